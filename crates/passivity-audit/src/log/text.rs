//! The report of an audit as text, for people.

use std::fmt::Write as _;

use passivity_core::{BigRational, Effect};
use passivity_scene::Motion;
use passivity_scene::display::{Rounding, approx, rounded};

use crate::figure::Figure;
use crate::log::error::legible;
use crate::log::findings::{ROUGH, leave_open, off_one, samples};
use crate::log::layout::Form;
use crate::log::report::{Agreement, ByLaw, Fitted, Force, Judged, Report, UnendedRow, Verdict};

/// A report that grows line by line.
struct Lines(String);

impl Lines {
    fn put(&mut self, label: &str, value: &str) {
        self.0.push_str(&format!("  {label:<29}{value}\n"));
    }
}

impl Report {
    /// The report as text, for people.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut out = Lines(format!("{}: {}\n", self.scene, self.headline()));
        // Of nothing there is no account.
        if self.intervals > 0 {
            self.energies(&mut out);
            self.intervals(&mut out);
            self.running(&mut out);
            self.sampling(&mut out);
        }
        // Of no row there is nothing to say.
        if let (Some(agreement), true) = (&self.force, self.samples > 0) {
            out.put("force", &agreement.to_text());
            if let (Some(law), false) = (&self.law, agreement.agrees) {
                out.put("under the wall's law", law.words());
            }
        }
        let is_moved = |kind: &str| kind.contains("velocity");
        if let (Some(moved), true) = (&self.velocity, self.samples > 0)
            && !self.findings.iter().any(|finding| is_moved(finding.kind))
        {
            out.put("velocity", &moved.to_text());
        }
        for finding in &self.findings {
            out.put("finding", &finding.says);
            out.put("", &finding.fix);
        }
        if let Some(columns) = &self.columns {
            out.put("columns", columns);
        }
        if !self.not_read.is_empty() {
            out.put("not read", &listed(&self.not_read));
        }
        if !self.nominal.is_empty() {
            out.put("at nominal value", &self.nominal.join(", "));
        }
        if !self.unended_rows.is_empty() {
            let named = |it: &UnendedRow| match &it.file {
                Some(file) => format!("row {} of {}", it.row, legible(file)),
                None => format!("row {}", it.row),
            };
            let rows: Vec<String> = self.unended_rows.iter().map(named).collect();
            let has = if rows.len() == 1 { "has" } else { "have" };
            let text = format!(
                "{} {has} no line break and may be incomplete",
                listed(&rows)
            );
            out.put("last row", &text);
        }
        if let Some(error) = &self.error {
            out.0.push_str(&format!("  Error in the trace: {error}.\n"));
        }
        out.0
    }

    /// The unit of energies in text: without an encoder the Δ of KΔ² is one unit of length.
    #[must_use]
    pub fn energy_unit(&self) -> &'static str {
        energy_unit(self.motion, &self.effects)
    }

    /// What the audit says, in a line.
    #[must_use]
    pub fn headline(&self) -> String {
        let own = self.answer();
        let judges = matches!(
            self.verdict,
            Verdict::Holds | Verdict::Fails | Verdict::Depends
        );
        let differs = self
            .force
            .as_ref()
            .is_some_and(|force| !force.agrees && !force.rough);
        match own.split_once(':') {
            Some((verdict, says)) if self.account == Force::Law && judges && differs => {
                format!(
                    "{verdict} for the wall's own law, which the forces in the trace are not:{says}"
                )
            }
            _ => own,
        }
    }

    /// What the account says, in a line.
    fn answer(&self) -> String {
        let drawn = || {
            let supply = self.running.supply.as_ref();
            let drawn = supply.and_then(|supply| supply.drawn.as_ref());
            let lowest = drawn.and_then(|d| d.surely_drawn.as_ref().zip(d.surely_drawn_after));
            lowest.map_or_else(String::new, |(drawn, after)| {
                let drawn = least(drawn);
                let unit = self.energy_unit();
                format!(", by {drawn} {unit} after row {}", after + 1)
            })
        };
        // What such a controller remembered when the log began is not in the log.
        let has = |effect| self.effects.contains(&effect);
        let remembers = "; what the controller remembered then is not counted";
        let (stored, aside) = match [Effect::Controller, Effect::DampingFilter].map(has) {
            [true, _] => (
                "the spring of H(1) times the stiffness stored at the start",
                remembers,
            ),
            [_, true] => ("the wall's spring stored at the start", remembers),
            _ => ("was stored at the start", ""),
        };
        let applied = self.account == Force::Applied;
        let opened = leave_open(&self.findings, self.force.as_ref(), applied);
        match (self.verdict, self.judged) {
            (Verdict::Holds, Judged::Interval) => {
                "HOLDS: no interval generated more than friction dissipates".to_owned()
            }
            (Verdict::Holds, Judged::Running) => {
                format!("HOLDS: the operator never drew more than {stored}{aside}")
            }
            (Verdict::Fails, Judged::Interval) => format!(
                "FAILS: {} generated more than friction surely dissipates{}",
                intervals(self.totals.violates_linear.unwrap_or(0)),
                first_row(self.totals.first_linear)
            ),
            (Verdict::Fails, Judged::Running) => {
                let drawn = drawn();
                format!("FAILS: the operator surely drew more than {stored}{drawn}{aside}")
            }
            (Verdict::Depends, Judged::Interval) if opened => {
                "DEPENDS: a finding leaves open whether an interval generated more than friction dissipates"
                    .to_owned()
            }
            (Verdict::Depends, Judged::Running) if opened => format!(
                "DEPENDS: a finding leaves open whether the operator drew more than {stored}{aside}"
            ),
            (Verdict::Depends, Judged::Interval) => format!(
                "DEPENDS: {} may have generated more than friction dissipates{}",
                intervals(self.totals.depends_linear.unwrap_or(0)),
                first_row(self.first.possible_linear.as_ref().map(|shown| shown.h))
            ),
            (Verdict::Depends, Judged::Running) => {
                format!("DEPENDS: the operator may have drawn more than {stored}{aside}")
            }
            (Verdict::NotCovered, _) => {
                format!("NOT ACCOUNTED FOR in a log: {}", self.left_out())
            }
            (Verdict::Broken, _) => {
                if self.intervals > 0 {
                    "INVALID TRACE: the account covers the rows before the error".to_owned()
                } else {
                    "INVALID TRACE: there is no interval before the error".to_owned()
                }
            }
        }
    }

    /// The effects for which the log is not accounted for, in words.
    fn left_out(&self) -> String {
        let words: Vec<&str> = self.not_covered.iter().map(|e| e.words()).collect();
        words.join("; ")
    }

    fn energies(&self, out: &mut Lines) {
        let counted = match self.positions {
            Form::Count => " (encoder counts: figures are exact enclosures)",
            _ => "",
        };
        out.put("intervals", &format!("{}{counted}", self.intervals));
        match self.account {
            _ if !self.not_covered.is_empty() => {
                let text = format!(
                    "of the positions alone, whatever force acted ({})",
                    self.left_out()
                );
                out.put("account", &text);
            }
            Force::Applied => out.put("account", "of the force in the trace"),
            Force::Law if self.force.is_none() => {
                out.put("account", "of the wall's own law, as no force is read");
            }
            Force::Law => {}
        }
        let totals = &self.totals;
        let figures = [
            ("generated, linear spring", totals.generated_linear.as_ref()),
            (
                "generated, quantized spring",
                totals.generated_quantized.as_ref(),
            ),
            ("dissipated at least", Some(&totals.dissipated_lower)),
            ("dissipated less generated", totals.net_linear.as_ref()),
        ];
        for (label, figure) in figures {
            let Some(figure) = figure else { continue };
            out.put(label, &format!("{} {}", shown(figure), self.energy_unit()));
        }
        if self.is_less_stored() {
            let text = "and less what delay and damping stored meanwhile, as in each deficit below";
            out.put("", text);
        }
    }

    /// Whether what the storages of delay and damping gain is taken off net energies: of the wall's own law they are part.
    #[must_use]
    pub fn is_less_stored(&self) -> bool {
        let has = |effect| self.effects.contains(&effect);
        let is_stored = has(Effect::Delay) || has(Effect::Damping);
        let is_of_spring = has(Effect::DampingFilter) || has(Effect::Controller);
        self.account == Force::Law && is_stored && !is_of_spring && self.not_covered.is_empty()
    }

    fn intervals(&self, out: &mut Lines) {
        let short = |surely: u64, open: u64| match (surely, open) {
            (0, 0) => "none".to_owned(),
            (n, 0) => intervals(n),
            (n, open) => format!("{}, {open} undecided", intervals(n)),
        };
        let totals = &self.totals;
        let linear = totals.violates_linear.zip(totals.depends_linear);
        let quantized = totals.violates_quantized.zip(totals.depends_quantized);
        for (label, counts) in [
            ("deficit, linear spring", linear),
            ("deficit, quantized spring", quantized),
        ] {
            if let Some((surely, open)) = counts {
                out.put(label, &short(surely, open));
            }
        }
        let (fails, depends) = (totals.criterion_fails, totals.criterion_depends);
        let is_of_law =
            |effect: &Effect| matches!(effect, Effect::DampingFilter | Effect::Controller);
        let whose = match self.effects.iter().any(is_of_law) {
            true => "; of the wall's spring alone, without the cost of its filter or controller",
            false => "",
        };
        let criterion = format!("{}, {depends} undecided{whose}", intervals(fails));
        out.put("criterion fails in", &criterion);
        if let Some(worst) = &self.worst
            && let Some(net) = worst.ledger.row.net_linear()
        {
            let (net, unit) = (least(net.lo()), self.energy_unit());
            out.put(
                "worst interval",
                &format!("row {}, where {net} {unit} was left", worst.row),
            );
        }
    }

    fn running(&self, out: &mut Lines) {
        let unit = self.energy_unit();
        if let Some(supply) = &self.running.supply {
            let text = format!(
                "{} {unit} after row {}",
                least(&supply.least),
                supply.after + 1
            );
            out.put("least energy balance", &text);
            if self.judged == Judged::Running {
                let stored = rounded(&-&supply.floor, 5, Rounding::Up);
                let spring = match self.effects.contains(&Effect::Controller) {
                    true => "a spring of H(1) times the stiffness of the scene's wall",
                    false => "the spring of the scene's wall",
                };
                let text = format!("at most {stored} {unit} in {spring}");
                out.put("stored at the start", &text);
            }
        }
        if let Some(observer) = &self.observer {
            let (energy, least) = (approx(&observer.energy), approx(&observer.least));
            let text = format!("{energy} {unit}, lowest {least}");
            out.put("passivity observer −Σ f·Δx", &text);
        }
    }

    fn sampling(&self, out: &mut Lines) {
        let Some(timing) = &self.timing else { return };
        let (late, missed) = (timing.late, timing.missed_samples);
        let lengths = between(&timing.shortest, &timing.longest);
        out.put(
            "sampling",
            &format!(
                "{lengths} periods, {} late, {} missed",
                intervals(late),
                number_of(missed, "sample")
            ),
        );
    }
}

/// The unit of energies in a scene that moves so and has these effects.
pub(crate) fn energy_unit(motion: Motion, effects: &[Effect]) -> &'static str {
    match motion {
        Motion::Dimensionless => "KΔ²",
        _ if effects.contains(&Effect::Encoder) => "KΔ²",
        Motion::Linear => "K·(1 m)²",
        Motion::Rotary => "K·(1 rad)²",
    }
}

/// The first of these names, as many as a line has room for, and how many more there are.
fn listed(names: &[String]) -> String {
    const ROOM: usize = 90;
    let mut text = String::new();
    for (i, name) in names.iter().enumerate() {
        if i > 0 && text.chars().count() + name.chars().count() > ROOM {
            let _ = write!(text, " and {} more", names.len() - i);
            break;
        }
        text.push_str(if i > 0 { ", " } else { "" });
        text.push_str(name);
    }
    text
}

/// `1 interval`, or `3 intervals`.
fn intervals(count: u64) -> String {
    number_of(count, "interval")
}

fn number_of(count: u64, what: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} {what}{ending}")
}

/// `, the first at row 3`, where there is one.
fn first_row(h: Option<u64>) -> String {
    h.map_or_else(String::new, |h| format!(", the first at row {}", h + 1))
}

/// At the least, as people read it.
fn least(x: &BigRational) -> String {
    rounded(x, 5, Rounding::Down)
}

/// Between two numbers, which those that are shown enclose.
fn between(lo: &BigRational, hi: &BigRational) -> String {
    format!("{} … {}", least(lo), rounded(hi, 5, Rounding::Up))
}

fn shown(figure: &Figure<BigRational>) -> String {
    match figure {
        Figure::Exact(x) => approx(x),
        Figure::Enclosed(range) => between(range.lo(), range.hi()),
    }
}

impl ByLaw {
    /// What the account of the wall's own law says, of a trace whose force is another.
    const fn words(&self) -> &'static str {
        match (self.verdict, self.judged) {
            (Verdict::Holds, Judged::Interval) => {
                "no interval would have generated more than friction dissipates"
            }
            (Verdict::Holds, Judged::Running) => {
                "the operator would never have drawn more than was stored at the start"
            }
            (Verdict::Fails, Judged::Interval) => {
                "some intervals would have generated more than friction dissipates"
            }
            (Verdict::Fails, Judged::Running) => {
                "the operator would have drawn more than was stored at the start"
            }
            (Verdict::Depends, _) => "the trace leaves open what would have been",
            (Verdict::NotCovered, _) => "the scene has an effect that is not accounted for",
            (Verdict::Broken, _) => "accounted for as far as the trace can be read",
        }
    }
}

impl Agreement {
    /// The multiple of the law that they are to within their digits.
    fn multiple(&self) -> Option<Fitted> {
        let rounding = self.rounding.filter(|rounding| *rounding < ROUGH)?;
        let is_multiple = |fit: &Fitted| fit.moved == 0.0 && fit.residual <= rounding;
        let fit = self.fit.filter(is_multiple)?;
        ((fit.scale.abs() - 1.0).abs() > rounding).then_some(fit)
    }

    fn to_text(&self) -> String {
        if self.agrees {
            return format!("agrees with the wall's law in all {} rows", self.compared);
        }
        if self.compared == 0 {
            return "is made of samples before the trace in every row, so none is compared with the wall's law"
                .to_owned();
        }
        if self.zero {
            return format!(
                "is zero in all {} rows, and the wall's law is not",
                self.compared
            );
        }
        if self.rough {
            return "is written with too few digits to be told from other forces than the wall's law"
                .to_owned();
        }
        let mut text = format!(
            "differs from the wall's law in {} of {} rows",
            self.mismatches, self.compared
        );
        text.push_str(&first_row(self.first_mismatch_row.map(|row| row - 1)));
        let found = &self.found;
        if found.mismatches == 0 {
            let sign = if found.reversed {
                "the opposite sign and "
            } else {
                ""
            };
            let _ = write!(text, "; with {sign}{} it agrees", samples(found.delay));
        } else if let Some(fit) = self.multiple() {
            let (scale, delay) = (off_one(fit.scale, fit.scale), samples(fit.delay));
            let _ = write!(text, "; it is {scale} times the law with {delay}");
        } else if found.mismatches < self.mismatches {
            let sign = if found.reversed {
                "the opposite sign and "
            } else {
                ""
            };
            let (delay, left) = (samples(found.delay), found.mismatches);
            let _ = write!(text, "; with {sign}{delay} it differs in {left}");
        }
        text
    }
}
