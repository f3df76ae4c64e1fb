//! What an audit found, for programs and for people.

use std::fmt::Write as _;

use passivity_core::BigRational;
use passivity_scene::display::{approx, significant};
use passivity_scene::{Effect, Scene, json};
use serde_json::{Map, Value, json};

use crate::audit::account::{Account, KINDS, Lowest, Point, Spot};
use crate::audit::course::near;
use crate::audit::error::TraceError;
use crate::audit::force::ForceCheck;
use crate::audit::merge::ROWS_IN_REPORT;
use crate::audit::worker::Task;
use crate::ledger::{Ledger, Sample};
use crate::number::Number;
use crate::run::{Run, Totals, tightened};
use crate::span::Span;
use crate::sum::SpanSum;

/// What an audit says of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// In no interval more was generated than friction surely dissipates, by the linear account.
    Holds,
    /// In some interval it was.
    Fails,
    /// The counts, or the tolerances, leave it open in some interval.
    Depends,
    /// The scene has an effect that no theorem covers.
    NotCovered,
    /// The trace is broken: the account ends there.
    Broken,
}

impl Standing {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Fails => "fails",
            Self::Depends => "depends",
            Self::NotCovered => "not_covered",
            Self::Broken => "broken",
        }
    }
}

/// The exact account of a trace.
#[derive(Clone, Debug)]
pub struct Audit {
    ledger: Ledger,
    scene: String,
    form: &'static str,
    effects: Vec<Effect>,
    not_covered: Vec<Effect>,
    nominal: Vec<&'static str>,
    samples: u64,
    totals: Totals,
    account: Account,
    start: Option<[BigRational; 2]>,
    force: Option<ForceCheck>,
    head: Vec<(Sample, Number)>,
    error: Option<TraceError>,
    unended: bool,
}

impl Audit {
    #[allow(clippy::too_many_arguments)]
    pub(crate) fn new(
        task: &Task<'_>,
        scene: &Scene,
        account: Account,
        samples: u64,
        start: Option<[BigRational; 2]>,
        force: Option<ForceCheck>,
        head: Vec<(Sample, Number)>,
        error: Option<TraceError>,
        unended: bool,
    ) -> Self {
        let mut figures = account.sums.each_ref().map(SpanSum::value);
        let counted = task.ledger.model().is_plain() && task.layout.form == super::Form::Count;
        if let (true, Some(last)) = (counted, &account.last) {
            figures = tightened(figures, last);
        }
        Self {
            ledger: task.ledger.clone(),
            scene: scene.name.clone(),
            form: task.layout.form.name(),
            effects: scene.effects(),
            not_covered: scene.not_covered(),
            nominal: taken_as_nominal(scene),
            samples,
            totals: Totals {
                intervals: account.intervals,
                figures,
                criterion: account.criterion,
                linear: account.linear,
                quantized: account.quantized,
            },
            account,
            start,
            force,
            head,
            error,
            unended,
        }
    }

    /// What the audit says.
    #[must_use]
    pub fn standing(&self) -> Standing {
        if self.error.is_some() {
            Standing::Broken
        } else if !self.not_covered.is_empty() {
            Standing::NotCovered
        } else if self.totals.linear.holds > 0 {
            Standing::Fails
        } else if self.totals.linear.depends > 0 {
            Standing::Depends
        } else {
            Standing::Holds
        }
    }

    /// The sums over all intervals, and how many of them broke what.
    #[must_use]
    pub const fn totals(&self) -> &Totals {
        &self.totals
    }

    /// What is wrong with the trace; the account is that of what came before.
    #[must_use]
    pub const fn error(&self) -> Option<&TraceError> {
        self.error.as_ref()
    }

    /// The course of the energy, for a plot; empty unless it was asked for.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.account.points
    }

    /// The lowest running energy from the start: what the operator put in, less the kinetic energy
    /// gained, E_d + V(ξ) − V(ξ₀) − E_gᴸ at the least. Where the criterion holds it never is more
    /// than the potential at the start below zero (TH-RUN).
    fn supply(&self) -> Option<Lowest> {
        let lowest = self.account.supply.as_ref()?;
        let [_, most] = self.start.as_ref()?;
        let value = &lowest.value - most;
        // At the start it is zero.
        let below = num_traits::Signed::is_negative(&value);
        Some(Lowest {
            h: if below { lowest.h } else { 0 },
            value: if below { value } else { value.clone() - value },
        })
    }

    fn shown(&self, spot: &Spot) -> Value {
        let mut text = Vec::new();
        if let Some(row) = spot.row(&self.ledger) {
            row.write_json(spot.h, &mut text);
        }
        let ledger: Value = serde_json::from_slice(&text).unwrap_or(Value::Null);
        json!({ "h": spot.h, "row": spot.h + 1, "ledger": ledger })
    }

    /// The rows of a short trace; null for a longer one, whose rows go to a file.
    fn rows(&self) -> Value {
        let most = u64::try_from(ROWS_IN_REPORT).unwrap_or(u64::MAX);
        if self.totals.intervals > most {
            return Value::Null;
        }
        let mut run = Run::new(&self.ledger);
        let mut rows = Vec::new();
        for (sample, dtau) in &self.head {
            let Some(row) = run.step(sample.clone(), dtau) else {
                break;
            };
            if let Some(row) = row {
                let mut text = Vec::new();
                row.write_json(run.intervals() - 1, &mut text);
                rows.push(serde_json::from_slice(&text).unwrap_or(Value::Null));
            }
        }
        Value::Array(rows)
    }

    /// The report as a JSON object.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let mut fields = Map::new();
        let mut put = |name: &str, value: Value| {
            fields.insert(name.to_owned(), value);
        };
        let names = |effects: &[Effect]| -> Value { effects.iter().map(|e| e.name()).collect() };
        put("scene", json!(self.scene));
        put("positions", json!(self.form));
        put("verdict", json!(self.standing().name()));
        put("effects", names(&self.effects));
        put("not_covered", names(&self.not_covered));
        put("nominal", json!(self.nominal));
        put("samples", json!(self.samples));
        put("intervals", json!(self.totals.intervals));
        let mut text = Vec::new();
        self.totals.write_json(&mut text);
        put(
            "totals",
            serde_json::from_slice(&text).unwrap_or(Value::Null),
        );
        let (net, net_at) = self.account.net.least();
        let supply = self.supply().map(|lowest| {
            let floor = self.start.as_ref().map(|[_, most]| (-most).to_string());
            json!({"least": lowest.value.to_string(), "after": lowest.h, "floor": floor})
        });
        put(
            "running",
            json!({
                "net_linear": {"least": net.to_string(), "after": net_at},
                "supply": supply,
            }),
        );
        let spot = |spot: Option<&Spot>| spot.map_or(Value::Null, |spot| self.shown(spot));
        put(
            "worst",
            spot(self.account.worst.as_ref().map(|(_, spot)| spot)),
        );
        put("first_violation", spot(self.account.firsts[0].as_ref()));
        let firsts = KINDS.iter().zip(&self.account.firsts);
        let firsts: Map<String, Value> = firsts
            .map(|(name, first)| ((*name).to_owned(), spot(first.as_ref())))
            .collect();
        put("first", Value::Object(firsts));
        let (least, at) = self.account.observer.least();
        let energy = self.account.observer.total();
        put(
            "observer",
            json!({
                "energy": energy.to_string(),
                "approx": json::approx(&energy),
                "least": least.to_string(),
                "after": at,
                "says": if least < BigRational::from_integer(0.into()) { "active" } else { "passive" },
            }),
        );
        put("timing", self.timing_json());
        put("force", self.force_json());
        put("rows", self.rows());
        put("last_row_unended", json!(self.unended));
        put("error", error_json(self.error.as_ref()));
        Value::Object(fields)
    }

    fn timing_json(&self) -> Value {
        let timing = &self.account.timing;
        let Some((shortest, longest)) = timing.shortest.as_ref().zip(timing.longest.as_ref())
        else {
            return Value::Null;
        };
        json!({
            "uneven": timing.uneven,
            "late": timing.late,
            "missed_samples": timing.missed,
            "first_missed_row": timing.first_missed.map(|h| h + 1),
            "shortest": shortest.to_string(),
            "longest": longest.to_string(),
        })
    }

    fn force_json(&self) -> Value {
        let check = self.force.as_ref();
        let Some((check, own, best)) =
            check.and_then(|check| Some((check, check.as_scene_says()?, check.best()?)))
        else {
            return Value::Null;
        };
        json!({
            "compared": check.compared,
            "agrees": own.mismatches == 0,
            "mismatches": own.mismatches,
            "first_mismatch_row": own.first.map(|row| row + 1),
            "delay": check.delay,
            "found": {
                "delay": best.lag,
                "reversed": best.reversed,
                "mismatches": best.mismatches,
            },
            "observer": check.observed,
        })
    }

    /// The report as text, for people.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        let _ = writeln!(out, "{}: {}", self.scene, self.headline());
        let mut line = |label: &str, value: &str| {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "  {label:<26}{value}");
        };
        let counted = match self.form {
            "count" => " (encoder counts: figures are exact enclosures)",
            _ => "",
        };
        line("intervals", &format!("{}{counted}", self.totals.intervals));
        let names = [
            "generated, linear",
            "generated, quantized",
            "dissipated at least",
        ];
        let shown = |figure: &Span<BigRational>| match figure {
            Span::At(x) => approx(x),
            Span::Between(lo, hi) => format!("{} … {}", approx(lo), approx(hi)),
        };
        for (name, figure) in names.iter().zip(&self.totals.figures) {
            line(name, &format!("{} KΔ²", shown(figure)));
        }
        line(
            "net, linear",
            &format!("{} KΔ²", shown(&self.totals.figures[3])),
        );
        let tally = |tally: &crate::run::Tally, what: &str| match (tally.holds, tally.depends) {
            (0, 0) => "none".to_owned(),
            (n, 0) => format!("{n} {what}"),
            (n, open) => format!("{n} {what}, {open} open"),
        };
        line(
            "short, linear account",
            &tally(&self.totals.linear, "intervals"),
        );
        line(
            "short, account of (22)",
            &tally(&self.totals.quantized, "intervals"),
        );
        let criterion = &self.totals.criterion;
        line(
            "criterion fails in",
            &format!("{} intervals, {} open", criterion.fails, criterion.depends),
        );
        if let Some((net, spot)) = &self.account.worst {
            line(
                "worst interval",
                &format!("row {}, net {} KΔ²", spot.h + 1, approx(net)),
            );
        }
        if let Some(supply) = self.supply() {
            line(
                "lowest running energy",
                &format!("{} KΔ² after row {}", approx(&supply.value), supply.h + 1),
            );
        }
        let (least, _) = self.account.observer.least();
        line(
            "passivity observer Σf·Δx",
            &format!(
                "{} KΔ², lowest {}",
                approx(&self.account.observer.total()),
                approx(&least)
            ),
        );
        self.timing_text(&mut line);
        self.force_text(&mut line);
        if !self.nominal.is_empty() {
            line("at nominal value", &self.nominal.join(", "));
        }
        if self.unended {
            line(
                "last row",
                &format!("row {} has no line break: it may be torn", self.samples),
            );
        }
        if let Some(error) = &self.error {
            let _ = writeln!(out, "  The trace is broken there: {error}.");
            let _ = writeln!(out, "  What came before it is accounted for above.");
        }
        out
    }

    fn headline(&self) -> String {
        let row = |kind: usize| {
            let first = self.account.firsts.get(kind).and_then(Option::as_ref);
            first.map_or(0, |spot| spot.h + 1)
        };
        match self.standing() {
            Standing::Holds => {
                "HOLDS: no interval generated more than friction dissipates".to_owned()
            }
            Standing::Fails => format!(
                "FAILS: {} intervals generated more than friction surely dissipates, the first at row {}",
                self.totals.linear.holds,
                row(0)
            ),
            Standing::Depends => format!(
                "DEPENDS: {} intervals may have generated more than friction dissipates, the first at row {}",
                self.totals.linear.depends,
                row(1)
            ),
            Standing::NotCovered => {
                let words: Vec<&str> = self.not_covered.iter().map(|e| e.words()).collect();
                format!("NOT COVERED by a theorem: {}", words.join("; "))
            }
            Standing::Broken => "BROKEN TRACE: the account is that of its first part".to_owned(),
        }
    }

    fn timing_text(&self, line: &mut impl FnMut(&str, &str)) {
        let timing = &self.account.timing;
        if let Some((shortest, longest)) = timing.shortest.as_ref().zip(timing.longest.as_ref()) {
            let near = |x: &Number| significant(near(&x.to_rational()));
            line(
                "sampling",
                &format!(
                    "{} … {} periods, {} intervals late, {} samples missed",
                    near(shortest),
                    near(longest),
                    timing.late,
                    timing.missed
                ),
            );
        }
    }

    fn force_text(&self, line: &mut impl FnMut(&str, &str)) {
        let Some(check) = &self.force else { return };
        let (Some(own), Some(best)) = (check.as_scene_says(), check.best()) else {
            return;
        };
        if own.mismatches == 0 {
            return line(
                "force",
                &format!("the wall's law in all {} rows", check.compared),
            );
        }
        let first = own.first.map_or(0, |row| row + 1);
        let mut text = format!(
            "not the wall's law in {} of {} rows, the first at row {first}",
            own.mismatches, check.compared
        );
        if best != own {
            let sign = if best.reversed {
                "the other sign and "
            } else {
                ""
            };
            let _ = write!(
                text,
                "; with {sign}{} samples of delay in {}",
                best.lag, best.mismatches
            );
        }
        line("force", &text);
    }
}

/// The parameters with a tolerance that the audit takes at their nominal value: those that scale
/// the trace or shape the law. Friction is taken over its whole tolerance.
fn taken_as_nominal(scene: &Scene) -> Vec<&'static str> {
    let given = [&scene.damping, &scene.max_force, &scene.force_step];
    given
        .into_iter()
        .flatten()
        .filter(|given| given.has_tolerance())
        .map(|given| given.key)
        .collect()
}

fn error_json(error: Option<&TraceError>) -> Value {
    error.map_or(Value::Null, |error| {
        json!({
            "kind": error.kind,
            "row": error.row,
            "column": error.column,
            "message": error.message,
        })
    })
}
