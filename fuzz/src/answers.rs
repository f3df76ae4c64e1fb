//! Answers of another implementation, as `passivity vectors --against` reads them.

use std::sync::OnceLock;

use passivity_vectors::{Group, Judge, all};

/// A few tests of every group, numbered from 1.
fn groups() -> &'static [Group] {
    static FEW: OnceLock<Vec<Group>> = OnceLock::new();
    FEW.get_or_init(|| {
        let mut groups = all();
        let mut id = 0;
        for group in &mut groups {
            group.tests.truncate(2);
            for test in &mut group.tests {
                id += 1;
                test.id = id;
            }
        }
        groups
    })
}

/// Every test is judged: no answer, and an answer that is none, is a difference.
pub(crate) fn run(data: &[u8]) {
    let mut judge = Judge::new(groups());
    for line in data.split(|byte| *byte == b'\n') {
        judge.hear(line);
    }
    let outcome = judge.finish();
    let tests: Vec<u64> = groups()
        .iter()
        .flat_map(|group| &group.tests)
        .map(|test| test.id)
        .collect();
    assert_eq!(outcome.tests, tests.len());
    for id in tests {
        let heard = data.len() > 8
            && data
                .split(|byte| *byte == b'\n')
                .any(|line| mentions(line, id));
        let different = outcome
            .differences
            .iter()
            .any(|difference| difference.id == id);
        assert!(heard || different, "test {id} has no answer, and passed");
    }
}

/// Whether a line could be an answer to a test.
fn mentions(line: &[u8], id: u64) -> bool {
    serde_json::from_slice::<serde_json::Value>(line).is_ok_and(|answer| answer["id"] == id)
}
