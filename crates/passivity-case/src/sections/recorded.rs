//! What was recorded of the device: the audits of its logs, and the friction that was identified.

use passivity_audit::Figure;
use passivity_core::{BigRational, Interval};
use passivity_scene::display::{Rounding, range, rounded, significant};

use crate::document::{Block, Document, Line, Row, capital};
use crate::recorded::{Identification, Log, Outcome, Recorded, Source};
use crate::study::Study;

pub(super) fn write(document: &mut Document, study: &Study) {
    let Some(recorded) = &study.recorded else {
        return;
    };
    document.heading(3, study.anchor("recorded"), "Recordings of the device");
    document.say(
        Line::text("Which device it was and when it was recorded is as the author of this case gave it, and \
             was not verified: device ")
            .and(Line::strong(format!("«{}»", recorded.device())))
            .and(Line::text(
                ". The files are bound to this case by their SHA-256. When the case was written they were \
                 audited, and friction was identified, by the same code as passivity audit and passivity \
                 identify; no report that was made before was taken.",
            )),
    );
    for log in &recorded.logs {
        audited(document, study, log);
    }
    if let Some(found) = &recorded.identification {
        identified(document, study, recorded, found);
    }
}

/// How a file is cited.
fn cited(source: &Source) -> [Row; 2] {
    [
        [
            "File".into(),
            Line::code(passivity_audit::legible(&source.path)),
        ]
        .into(),
        ["SHA-256".into(), Line::hash(&source.sha256)].into(),
    ]
}

/// What evidence comes to, as a statement that is not missed.
fn verdict(document: &mut Document, what: &str, says: &str, outcome: &Outcome) {
    let mut line = Line::strong(format!("{what}: {says}."));
    if let Some(why) = outcome.because() {
        // The statement itself may be the reason.
        let why = match why == says {
            true => String::new(),
            false => format!(" {}.", capital(why)),
        };
        line = line.and(format!("{why} The argument is not supported.").into());
    }
    let is_good = *outcome == Outcome::Supports;
    document.blocks.push(Block::Verdict(is_good, line));
}

fn audited(document: &mut Document, study: &Study, log: &Log) {
    let (report, source) = (&log.report, &log.source);
    let outcome = log.outcome(&study.scene);
    let id = study.anchor(&format!("log-{}", log.number));
    document.heading(4, id, format!("Log {}: «{}»", log.number, source.name));
    verdict(document, "Audit", &log.headline(), &outcome);
    let mut rows: Vec<Row> = cited(source).to_vec();
    let mut row = |name: &str, value: String| rows.push([Line::text(name), value.into()].into());
    row("Recorded, as given", source.date.clone());
    if let Some(form) = log.form_text() {
        row("Form", form.to_owned());
    }
    row(
        "Length",
        format!(
            "{} samples, {}",
            report.samples,
            log.duration_text(&study.scene)
        ),
    );
    if let Some(columns) = &report.columns {
        row("Columns, as given", columns.clone());
    }
    row("Force", log.force_text());
    let (totals, unit) = (&report.totals, report.energy_unit());
    let unknown = || "not accounted for".to_owned();
    let left = match report.is_less_stored() {
        true => "Dissipated less generated, and less what delay and damping stored",
        false => "Dissipated less generated",
    };
    for (name, figure) in [
        ("Generated, linear spring", totals.generated_linear.as_ref()),
        ("Dissipated at least", Some(&totals.dissipated_lower)),
        (left, totals.net_linear.as_ref()),
    ] {
        let text = figure.map(|figure| format!("{} {unit}", outward(figure)));
        row(name, text.unwrap_or_else(unknown));
    }
    let deficit = totals.violates_linear.zip(totals.depends_linear);
    let deficit = deficit.map(|(surely, open)| counted(surely, open));
    row("Deficit in", deficit.unwrap_or_else(unknown));
    row(
        "Criterion fails in",
        counted(totals.criterion_fails, totals.criterion_depends),
    );
    if let Some(supply) = &report.running.supply {
        let least = rounded(&supply.least, 5, Rounding::Down);
        let text = format!("{least} {unit} after row {}", supply.after + 1);
        row("Least energy balance", text);
    }
    if let Some(timing) = &report.timing {
        let ends = Interval::hull(timing.shortest.clone(), timing.longest.clone());
        let ends = match range(&ends).as_str() {
            "1" => "every interval lasts one period".to_owned(),
            ends => format!("intervals of {ends} periods"),
        };
        row(
            "Sampling",
            format!(
                "{ends}; {} longer than a period; {} missed",
                intervals(timing.late),
                number_of(timing.missed_samples, "sample")
            ),
        );
    }
    for finding in &report.findings {
        row(
            "Finding",
            format!("{}. To put it right: {}", finding.says, finding.fix),
        );
    }
    if !report.nominal.is_empty() {
        row("Taken at nominal value", report.nominal.join(", "));
    }
    let caption = format!("Audit of «{}» in «{}»", source.name, study.name());
    document.table(&caption, &[("Figure", 30), ("Value", 70)], rows);
}

/// `3 intervals, 2 undecided`.
fn counted(surely: u64, open: u64) -> String {
    match (surely, open) {
        (0, 0) => "no interval".to_owned(),
        (n, 0) => intervals(n),
        (n, open) => format!("{}, {open} undecided", intervals(n)),
    }
}

fn intervals(count: u64) -> String {
    number_of(count, "interval")
}

fn number_of(count: u64, what: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} {what}{ending}")
}

/// A figure between the decimals on both sides of it.
fn outward(figure: &Figure<BigRational>) -> String {
    let lo = rounded(figure.lo(), 5, Rounding::Down);
    let hi = rounded(figure.hi(), 5, Rounding::Up);
    if lo == hi {
        lo
    } else {
        format!("{lo} … {hi}")
    }
}

fn identified(document: &mut Document, study: &Study, recorded: &Recorded, found: &Identification) {
    document.heading(4, study.anchor("identified"), "Identified friction");
    let outcome = found.outcome();
    let says = outcome.because();
    let says = says.unwrap_or("the friction of the device is that of the scene");
    verdict(document, "Identification", says, &outcome);
    document.say(
        "The device moves freely in these logs: it starts at rest and nobody touches it. The ranges \
         surely hold its friction, if friction is of the model m·dv/dt = u − b·v − c·sgn(v) \
         (TH-IDENT); period and encoder are taken at their nominal values.",
    );
    if let Some(over) = &found.over {
        let headline = &over.headline;
        document.say(format!(
            "With the identified ranges in place of the scene's own friction, the wall is {headline}."
        ));
    }
    let rows = found.compared.iter().map(|one| -> Row {
        let agrees = if one.agrees() { "yes" } else { "NO" };
        [
            one.parameter.row().name.into(),
            Line::code(&one.in_scene),
            one.range.as_str().into(),
            one.best
                .map_or_else(|| "none".to_owned(), passivity_identify::nearest)
                .into(),
            agrees.into(),
        ]
        .into()
    });
    let columns = [
        ("Parameter", 20),
        ("In the scene", 24),
        ("Identified, surely within", 28),
        ("Best estimate", 16),
        ("Agree", 12),
    ];
    let caption = format!(
        "Friction of «{}» at the device, identified and in the scene",
        recorded.device()
    );
    document.table(&caption, &columns, rows.collect());
    if found.outside().next().is_some() {
        let bounded = found.compared.iter().filter(|one| one.hi.is_some());
        let ranges = bounded.map(|one| {
            let line = Line::code(one.line());
            match one.in_place_of {
                Some(key) => line.and(" in place of ".into()).and(Line::code(key)),
                None => line,
            }
        });
        document.say(
            Line::text("What the logs say, as a scene takes it: ")
                .and(Line::joined(ranges, ", "))
                .and(Line::text(".")),
        );
    }
    let mut rows: Vec<Row> = Vec::new();
    for source in &found.sources {
        rows.extend(cited(source));
        rows.push(["Recorded, as given".into(), source.date.as_str().into()].into());
    }
    let given = &recorded.given;
    let share = given.scale_error.map_or_else(String::new, |share| {
        let percent = significant(100.0 * share);
        format!(", and {percent} % of itself, all forces alike")
    });
    let errors = format!(
        "a count: {} to either side, in ticks; a force: {} to either side{share}",
        significant(given.count_error),
        significant(given.force_error)
    );
    rows.push(["Samples".into(), found.report.samples.to_string().into()].into());
    rows.push(["Errors, as given".into(), errors.into()].into());
    for lack in &found.report.lacks {
        rows.push(["To know more".into(), lack.as_str().into()].into());
    }
    if found.report.stopped_early {
        let text = "the search came to its bound: with more --effort the ranges may be narrower";
        rows.push(["Search".into(), text.into()].into());
    }
    let caption = format!(
        "Logs from which the friction of «{}» was identified",
        recorded.device()
    );
    document.table(&caption, &[("Figure", 30), ("Value", 70)], rows);
}
