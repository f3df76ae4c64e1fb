//! The list of harnesses against the reports: what is proved, and what is wrong.

use passivity_standin::list::{Entry, List};

use crate::report::{Covers, Report, Run};

/// Kani's verdict on a harness that holds.
const HOLDS: &str = "SUCCESSFUL";

/// Kani's verdict on a harness that must fail and does.
const FAILS_AS_IT_SHOULD: &str = "SUCCESSFUL (encountered one or more panics as expected)";

/// The faults of each harness of the list, in its order; no fault means that it is proved.
pub(crate) fn judge<'a>(list: &'a List, run: &Run) -> Vec<(&'a Entry, Vec<String>)> {
    list.harness
        .iter()
        .map(|entry| (entry, faults(entry, run.harnesses.get(&entry.name))))
        .collect()
}

/// Everything that is wrong, a line each; nothing when each harness of the list is proved and there
/// is no other.
pub(crate) fn wrong(list: &List, run: &Run) -> Vec<String> {
    let of_list = judge(list, run).into_iter().flat_map(|(entry, faults)| {
        let line = move |fault| format!("{}: {fault}", entry.name);
        faults.into_iter().map(line)
    });
    let names = run.harnesses.keys();
    let unknown = names.filter(|name| list.find(name).is_none());
    let unlisted = unknown.map(|name| format!("{name}: it is not in harnesses.toml"));
    of_list.chain(unlisted).collect()
}

fn faults(entry: &Entry, report: Option<&Report>) -> Vec<String> {
    let Some(report) = report else {
        return vec!["it is not in the report".into()];
    };
    let mut faults = Vec::new();
    let expected = match entry.must_fail {
        None => HOLDS,
        Some(_) => FAILS_AS_IT_SHOULD,
    };
    match &report.verdict {
        None => faults.push("there is no verdict on it".into()),
        Some(verdict) if verdict != expected => {
            faults.push(format!("the verdict is `{verdict}` and not `{expected}`"));
        }
        Some(_) => {}
    }
    let failed_as_listed: Vec<&String> = entry.must_fail.iter().collect();
    if report.failed.iter().collect::<Vec<_>>() != failed_as_listed {
        faults.push(format!(
            "the checks that failed are {:?} and not {:?}",
            report.failed, failed_as_listed
        ));
    }
    if report.covers.satisfied.is_empty() {
        faults.extend(by_count(&entry.covers, &report.covers));
    } else {
        faults.extend(by_message(&entry.covers, &report.covers));
    }
    faults
}

/// Each listed cover must have a copy that is satisfied, and no other cover may be there.
fn by_message(listed: &[String], covers: &Covers) -> Vec<String> {
    let missing = listed
        .iter()
        .filter_map(|cover| match covers.satisfied.get(cover) {
            Some(true) => None,
            Some(false) => Some(format!("no copy of its cover \"{cover}\" is satisfied")),
            None => Some(format!("its cover \"{cover}\" is not in the report")),
        });
    let known = |cover: &String| listed.contains(cover);
    let others = covers.satisfied.keys().filter(|cover| !known(cover));
    let unlisted = others.map(|cover| format!("its cover \"{cover}\" is not in the list"));
    missing.chain(unlisted).collect()
}

/// The terse format says how many copies are satisfied and not of which cover. That is enough
/// where all are, one for each listed cover, and where all copies are of one cover.
fn by_count(listed: &[String], covers: &Covers) -> Option<String> {
    let (satisfied, copies) = covers.counted;
    let enough = match listed.len() {
        1 => satisfied >= 1,
        all => (satisfied, copies) == (all, all),
    };
    (!enough).then(|| {
        format!(
            "{satisfied} of {copies} covers are satisfied, the list has {}, and without \
             `--output-format=regular` nobody knows which",
            listed.len()
        )
    })
}
