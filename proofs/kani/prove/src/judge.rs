//! The list of harnesses against the reports: what is proved, and what is wrong.

use std::collections::BTreeMap;

use passivity_standin::list::{Entry, List};

use crate::report::Report;

/// Kani's verdict on a harness that holds.
const HOLDS: &str = "SUCCESSFUL";

/// Kani's verdict on a harness that must fail and does.
const FAILS_AS_IT_SHOULD: &str = "SUCCESSFUL (encountered one or more panics as expected)";

/// The faults of each harness of the list, in its order; no fault means that it is proved.
pub(crate) fn judge<'a>(
    list: &'a List,
    reports: &BTreeMap<String, Report>,
) -> Vec<(&'a Entry, Vec<String>)> {
    list.harness
        .iter()
        .map(|entry| (entry, faults(entry, reports.get(&entry.name))))
        .collect()
}

/// Harnesses that were reported and are not in the list.
pub(crate) fn unknown<'a>(list: &List, reports: &'a BTreeMap<String, Report>) -> Vec<&'a str> {
    let names = reports.keys().map(String::as_str);
    names.filter(|name| list.find(name).is_none()).collect()
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
    let all = entry.covers.len();
    if report.covers != (all, all) {
        let (satisfied, found) = report.covers;
        faults.push(format!(
            "{satisfied} of {found} covers are satisfied; the list has {all}"
        ));
    }
    faults
}
