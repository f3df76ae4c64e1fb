//! Forces on another topic than the position: those that no row has, and those that are old.

use mcap::WriteOptions;
use passivity_audit::{Audit, Options, Verdict, audit_files};

use super::write::{Form, Sent, file};
use super::{COLUMNS, dialect, motion, read, save, scene, sent};

/// The account of these messages.
fn audited(sent: &[Sent]) -> Audit {
    let path = save(&file(WriteOptions::new(), Form::Cdr, sent));
    let found = read(&path, COLUMNS, &scene()).unwrap();
    assert_eq!(found.error(), None);
    found
}

/// What is found of a kind.
fn says<'a>(audit: &'a Audit, kind: &str) -> Option<&'a str> {
    let findings = &audit.report().findings;
    let mut of_kind = findings.iter().filter(|finding| finding.kind == kind);
    let says = of_kind.next().map(|finding| finding.says.as_str());
    assert!(of_kind.next().is_none());
    says
}

/// A force that is said just after the position of a row, counted from 0.
fn after(row: usize, force: f64) -> Sent {
    let stamp = motion().nth(row).unwrap().0;
    Sent {
        topic: "/wrench",
        log_time: stamp + 200,
        bytes: Form::Cdr.wrench(stamp, force),
    }
}

/// The messages with others just after the positions of rows.
fn with(others: &[(usize, f64)]) -> Vec<Sent> {
    let mut all = sent(Form::Cdr);
    for (row, force) in others.iter().rev() {
        all.insert(2 * row + 2, after(*row, *force));
    }
    all
}

fn force(row: usize) -> f64 {
    motion().nth(row).unwrap().2
}

#[test]
fn forces_that_no_row_has_leave_the_account_open() {
    let plain = audited(&sent(Form::Cdr));
    assert_eq!(
        (plain.verdict(), says(&plain, "missed_force")),
        (Verdict::Holds, None)
    );
    // Two between rows 5 and 6, and one between 100 and 101.
    let found = audited(&with(&[(4, 9.0), (4, 8.0), (99, 9.0)]));
    assert_eq!(found.verdict(), Verdict::Depends);
    let said = says(&found, "missed_force").unwrap();
    assert!(
        said.starts_with("3 values were") && said.contains("before row 6:"),
        "{said}"
    );
    assert!(said.contains("/wrench.wrench.force.x"), "{said}");
    assert!(found.to_text().contains("DEPENDS: a finding leaves open"));
    assert_eq!(found.totals(), plain.totals());
    // What says again what was held, or what the next one says, and what comes after the last row.
    let again = audited(&with(&[
        (4, force(4)),
        (7, force(8)),
        (199, 9.0),
        (199, 8.0),
    ]));
    assert_eq!(
        (again.verdict(), says(&again, "missed_force")),
        (Verdict::Holds, None)
    );
    // Before the first row nothing is held.
    let mut early = sent(Form::Cdr);
    for (value, before) in [(9.0, 2000), (8.0, 1000)] {
        early.insert(0, after(0, value));
        early[0].log_time -= before;
    }
    early[..2].sort_by_key(|sent| sent.log_time);
    assert_eq!(says(&audited(&early), "missed_force"), None);
}

#[test]
fn a_force_that_is_said_no_more_leaves_the_account_open() {
    let until = |keep: &dyn Fn(usize) -> bool| {
        let (rows, sent) = (0.., sent(Form::Cdr));
        let kept = rows.zip(sent).filter(|(i, _)| i % 2 == 1 || keep(i / 2));
        kept.map(|(_, sent)| sent).collect::<Vec<_>>()
    };
    let stale = until(&|row| row < 64);
    let found = audited(&stale);
    assert_eq!(found.verdict(), Verdict::Depends);
    // Row 64, where the force is near zero, is the last with its own, and up to row 71 it is not yet old.
    let said = says(&found, "old_force").unwrap();
    assert!(
        said.starts_with("129 rows rest") && said.contains("them row 72"),
        "{said}"
    );
    // A controller may be slower than the log, up to a point.
    let slower = audited(&until(&|row| row % 8 == 0));
    assert_eq!(
        (slower.verdict(), says(&slower, "old_force")),
        (Verdict::Holds, None)
    );
    let slow = audited(&until(&|row| row % 20 == 0));
    assert!(says(&slow, "old_force").unwrap().contains("them row 9"));
    // In several files as in one.
    let options = Options {
        dialect: dialect(COLUMNS),
        ..Options::default()
    };
    let files = [&stale[..200], &stale[200..]];
    let files = files.map(|sent| save(&file(WriteOptions::new(), Form::Cdr, sent)));
    let paths = files.each_ref().map(|file| file.to_path_buf());
    let both = audit_files(&paths, &scene(), options).unwrap();
    assert_eq!(both.report().findings, found.report().findings);
}
