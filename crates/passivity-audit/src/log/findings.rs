//! What stands out in a log beside its account, each with the change to the scene or to the columns that
//! puts it right.

use passivity_core::{BigRational, Parameter};
use passivity_scene::check::unit_of;
use passivity_scene::display::{Rounding, figures, rounded};
use passivity_scene::number::nearest_f64;
use passivity_scene::{Motion, Scene};
use serde::Serialize;

use crate::log::comparison::LAGS;
use crate::log::layout::{Form, Layout};
use crate::log::report::{Agreement, Fitted, Supplied};
use crate::log::text::energy_unit;
use crate::log::timing::{GAP, SHORT, Timing};
use crate::log::velocity::is_off;
use crate::shell::shell_word;

/// Of forces that are no multiple of the law's, a scale that is nearer to one than this is no finding.
const SCALED: f64 = 0.01;

/// Forces that are within this share of their own size of a multiple of the law's are near it: its delay, sign and scale
/// are told. Forces that are further from the law's as a whole agree with it only for want of digits.
pub(crate) const ROUGH: f64 = 0.2;

/// Something that stands out in a log.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// What kind of thing it is, for programs.
    pub kind: &'static str,
    /// What was found.
    pub says: String,
    /// What puts it right, if it is a mistake of the scene or of the columns.
    pub fix: String,
}

/// What a file says beside its columns.
#[derive(Clone, Debug, Default)]
pub(crate) struct Beside {
    /// What stands out in how the log was put together.
    pub(crate) finding: Option<Finding>,
    /// What it holds apart from the columns, in words.
    pub(crate) topics: Vec<String>,
}

/// Whether an account leaves open what is true of the device where this is found: one of the forces in the log, or
/// of the law.
pub(crate) fn leave_open(found: &[Finding], force: Option<&Agreement>, applied: bool) -> bool {
    let is_off = force.is_some_and(Agreement::is_off);
    applied && is_off || found.iter().any(|finding| finding.leaves_open(applied))
}

impl Agreement {
    /// Whether the forces are near another multiple of the law, by a unit or a sign perhaps.
    fn is_off(&self) -> bool {
        let near = self.fit.filter(|fit| fit.residual < ROUGH);
        !self.agrees && !self.rough && near.is_some_and(|fit| is_off(&fit))
    }
}

impl Finding {
    fn leaves_open(&self, applied: bool) -> bool {
        match self.kind {
            "wrap" | "fast_clock" | "undersampled" | "velocity_scale" | "counted_positions" => true,
            "missed_force" | "old_force" | "stored_energy" => applied,
            "oversampled" => !applied,
            _ => false,
        }
    }
}

/// What stands out in the forces of a log.
pub(crate) fn of_force(agreement: &Agreement, layout: &Layout, scene: &Scene) -> Vec<Finding> {
    if agreement.agrees || agreement.compared == 0 {
        let edge = agreement.edge.filter(|_| agreement.agrees);
        return edge.map(of_edge).into_iter().collect();
    }
    if agreement.zero {
        return vec![Finding {
            kind: "zero_force",
            says: "the force is zero in every row, and that of the wall's law is not: is it the right column?"
                .to_owned(),
            fix: "check that the column is the force that was commanded; `--columns` names another".to_owned(),
        }];
    }
    if agreement.rough {
        return vec![Finding {
            kind: "rough_force",
            says:
                "the force is the wall's law to within its last digit, and so would other forces be"
                    .to_owned(),
            fix: "log the force with more digits, as it was commanded; or check its unit"
                .to_owned(),
        }];
    }
    let exact = agreement.found.mismatches == 0;
    let near = agreement.fit.filter(|fit| fit.residual < ROUGH);
    let Fitted {
        delay,
        scale,
        moved,
        residual: left,
    } = match (exact, near) {
        (true, _) => Fitted {
            delay: agreement.found.delay,
            scale: if agreement.found.reversed { -1.0 } else { 1.0 },
            moved: 0.0,
            residual: 0.0,
        },
        (false, Some(fit)) => fit,
        (false, None) => {
            return vec![Finding {
                kind: "other_force",
                says: "the force is not that of the wall's law at any delay, sign or scale".to_owned(),
                fix: "check the wall in the scene, and that the column is the force that was commanded"
                    .to_owned(),
            }];
        }
    };
    let rounding = agreement.rounding.unwrap_or(0.0);
    let is_multiple = left <= rounding;
    let off = (scale.abs() - 1.0).abs();
    let threshold = if is_multiple {
        rounding
    } else {
        left.max(SCALED)
    };
    // What is left where the force comes late may be what a moved wall does, which at another delay than the scene's is not
    // told from a scale.
    let is_told = is_multiple || delay == agreement.delay;
    let times = match !is_told && off > threshold {
        true => format!("{} times ", off_one(scale, scale.abs())),
        false => String::new(),
    };
    let mut findings = Vec::new();
    // Of delays that are tried the last one may be the nearest for want of those beyond it, unless it leaves nothing.
    let is_last = !is_multiple && delay == agreement.delay + LAGS;
    if is_last {
        findings.push(Finding {
            kind: "delay",
            says: format!(
                "the force is late by {delay} samples or more, and the scene has {}; longer delays are not tried",
                samples(agreement.delay)
            ),
            fix: "check how late the force is; in the scene that is `delay`, under [sampling]".to_owned(),
        });
    } else if delay != agreement.delay {
        findings.push(Finding {
            kind: "delay",
            says: format!(
                "the force follows {times}the wall's law with {}, and the scene has {}",
                samples(delay),
                samples(agreement.delay)
            ),
            fix: match delay < agreement.delay {
                // A force that was written down as soon as it was commanded looks as if there were no delay.
                true => format!(
                    "in the scene, under [sampling]: delay = {delay}, if the force was held from its row on; if it \
                     was held later, write it into the row from which on it was"
                ),
                false => format!("in the scene, under [sampling]: delay = {delay}"),
            },
        });
    }
    if scale < 0.0 {
        let columns = layout.typed(true);
        findings.push(Finding {
            kind: "sign",
            says: "the force has the opposite sign to the wall's law".to_owned(),
            fix: match columns {
                Some(columns) => {
                    let columns = shell_word(&columns);
                    format!("if the column has the sign of the other side: --columns {columns}")
                }
                None => "turn the sign of the force in the log".to_owned(),
            },
        });
    }
    if moved != 0.0 {
        findings.push(of_moved(moved));
    }
    if is_told && off > threshold {
        findings.push(Finding {
            kind: "scale",
            says: format!(
                "the force is {} times that of the wall's law",
                off_one(scale, scale.abs())
            ),
            fix: scaled(scale.abs(), scene),
        });
    }
    if findings.is_empty() || !(is_multiple || is_last) {
        findings.push(beyond_rounding(
            agreement,
            (scale, moved, left),
            findings.is_empty(),
            layout.form,
        ));
    }
    findings
}

/// Of forces that are those of a wall that is moved by so many ticks.
fn of_moved(ticks: f64) -> Finding {
    let is_half = (ticks.abs() - 0.5).abs() < SCALED;
    let way = if ticks < 0.0 { "backward" } else { "forward" };
    Finding {
        kind: "offset",
        says: match is_half {
            true => format!("the force is that of a wall that is moved half a tick {way}"),
            false => format!(
                "the force is that of a wall that is moved {} ticks {way}",
                figures(ticks.abs(), 3)
            ),
        },
        fix: match is_half {
            true => "the wall's law takes the middle of the encoder's tick for the position, −K·(n + ½)·Δ at the \
                     count n; a controller that commands −K·n·Δ, or −K·(n + 1)·Δ, takes its border: take the middle \
                     there too"
                .to_owned(),
            false => "check where positions are counted from, and that nothing is added to the force".to_owned(),
        },
    }
}

/// Of forces that are those of the law but for half of their last digit, always to the same side: those of a wall that is moved
/// by so many ticks may be, as they are where whole numbers are commanded.
fn of_edge(ticks: f64) -> Finding {
    let moved = of_moved(ticks);
    Finding {
        says: format!(
            "all forces are off the wall's law by half of their last digit, to the same side: they were rounded to that side, or {}",
            moved.says
        ),
        fix: format!("log the force with more digits; {}", moved.fix),
        ..moved
    }
}

/// What is left of forces is what they are off the nearest multiple, which is said unless it is the law.
fn of_multiple(scale: f64, moved: f64) -> String {
    let law = match moved == 0.0 {
        true => "the law",
        false => "that of the moved wall",
    };
    match figures(scale, 5) {
        one if one == "1" => String::new(),
        scale => format!(" from {scale} times {law}"),
    }
}

/// Of forces that are near the law's, or a multiple of it, by more than their digits are off.
fn beyond_rounding(
    agreement: &Agreement,
    (scale, moved, left): (f64, f64, f64),
    is_all: bool,
    form: Form,
) -> Finding {
    let share = |x: f64| format!("{} % of its size (RMS)", figures(100.0 * x, 3));
    let says = match is_all {
        true => format!(
            "the force differs from the wall's law in {} of {} rows by more than its digits are off, by {} over all",
            agreement.mismatches,
            agreement.compared,
            share(agreement.difference.unwrap_or(left))
        ),
        false => format!(
            "beside that the force differs by {}{}, and its digits are off by {} at the most",
            share(left),
            of_multiple(scale, moved),
            share(agreement.rounding.unwrap_or(0.0))
        ),
    };
    let check = "check the wall in the scene, and that the column is the force that was commanded and nothing added";
    match form {
        Form::Count => Finding {
            kind: "other_force",
            says,
            fix: check.to_owned(),
        },
        // A position next to the border of a tick may have been rounded over it.
        Form::Xi | Form::X | Form::Ledger => Finding {
            kind: "near_force",
            says,
            fix: format!("{check}; if the positions are rounded, log what the encoder counted"),
        },
    }
}

/// A delay in words.
pub(crate) fn samples(delay: usize) -> String {
    match delay {
        0 => "no delay".to_owned(),
        1 => "1 sample of delay".to_owned(),
        delay => format!("{delay} samples of delay"),
    }
}

/// What depends on a scale, with as many digits as tell it from one.
pub(crate) fn off_one(scale: f64, x: f64) -> String {
    figures(
        x,
        if (scale.abs() - 1.0).abs() < 1e-3 {
            9
        } else {
            5
        },
    )
}

/// What makes the wall of a scene so many times as stiff.
fn scaled(scale: f64, scene: &Scene) -> String {
    if scene.motion == Motion::Dimensionless {
        return "write the force in units of KΔ".to_owned();
    }
    let unit = unit_of(Parameter::Stiffness, scene.motion);
    let stiffness = scene.given.stiffness.nominal.enclosure(64);
    let Some(stiffness) = stiffness.map(|range| nearest_f64(&range.middle())) else {
        return "correct the stiffness of the wall, or the unit of the force".to_owned();
    };
    let stiffness = off_one(scale, stiffness * scale);
    let motor = match scene.transmission {
        Some(_) => ", which is that at the device, not at the motor",
        None => "",
    };
    // All that the force of the wall is made of has its unit.
    let given = &scene.given;
    let others = [&given.damping, &given.max_force, &given.force_step];
    let others: Vec<String> = others
        .into_iter()
        .flatten()
        .map(|given| format!("`{}`", given.key.trim_start_matches("wall.")))
        .collect();
    let others = match &others[..] {
        [] => String::new(),
        all => format!(", and {} as many times as large", all.join(" and ")),
    };
    // As of positions that were logged in one unit and read in another.
    let factors: &[(f64, &str)] = match scene.motion {
        Motion::Linear => &[(1e3, "m and mm"), (1e2, "m and cm")],
        _ => &[(180.0 / std::f64::consts::PI, "rad and deg")],
    };
    let is_near = |factor: f64| (scale.abs().ln().abs() - factor.ln()).abs() < ROUGH;
    let positions = factors.iter().find(|(factor, _)| is_near(*factor));
    let positions = positions.map_or_else(String::new, |(_, units)| {
        format!(" of the positions, as the factor is that between {units}, or")
    });
    format!(
        "in the scene, under [wall]: stiffness = \"{stiffness} {unit}\"{others}; or correct the unit{positions} of the \
         force{motor}"
    )
}

/// What the positions of a log are, in a word.
pub(crate) const fn position(form: Form) -> &'static str {
    match form {
        Form::Count => "count",
        Form::Xi | Form::X | Form::Ledger => "position",
    }
}

/// What stands out in an account that holds, of forces that are not those of the scene's wall: that it rests on energy which
/// the spring of that wall would have stored at the start. Of positions that are not zero where the wall that acted begins
/// that is as much as one likes.
pub(crate) fn of_stored(supply: &Supplied, form: Form, scene: &Scene) -> Finding {
    let unit = energy_unit(scene.motion, &scene.effects());
    let most = |x: &BigRational| rounded(&-x, 5, Rounding::Up);
    Finding {
        kind: "stored_energy",
        says: format!(
            "up to row {} the operator may have drawn {} {unit}: the spring of the scene's wall stores at most {} {unit} at the \
             start, but the force is not that wall's, so it is open whether so much was stored",
            supply.after + 1,
            most(&supply.least),
            most(&supply.floor)
        ),
        fix: format!(
            "check that the {} is 0 where the wall begins, and that the scene has the wall of the log; or begin the log outside \
             of the wall, where nothing is stored",
            position(form)
        ),
    }
}

/// What stands out in times: that intervals are mostly as short as [`SHORT`] says, or that samples are missing in half of
/// them, and on the whole.
pub(crate) fn of_clock(timing: &Timing, intervals: u64) -> Option<Finding> {
    // One interval alone may be a motion that ended within it.
    if intervals < 2 {
        return None;
    }
    let unit = "check the unit of the times, and the sampling period of the scene";
    let gaps = timing.gaps;
    if timing.is_sparse(intervals) {
        let (n, d) = GAP;
        return Some(Finding {
            kind: "undersampled",
            says: format!(
                "{gaps} of {intervals} intervals between rows are at least {n}/{d} of a sampling period: if samples between them were \
                 left out, their forces are not accounted for, nor how the device moved"
            ),
            fix: format!("log every sample; or {unit}"),
        });
    }
    // A recorder that pauses makes a few long ones.
    let is_usual = |count: u64| 10 * count >= 9 * intervals;
    let mut counted = timing.short.into_iter().zip(SHORT).enumerate();
    let (at, (count, (n, d))) = counted.find(|(_, (count, _))| is_usual(*count))?;
    let says = format!(
        "{count} of {intervals} intervals between rows are at most {n}/{d} of a sampling period"
    );
    Some(match at {
        0 => Finding {
            kind: "fast_clock",
            says: format!(
                "{says}: friction would take so much more than it does if the clock is not as fast"
            ),
            fix: format!(
                "{unit}; if the log does have so many rows of each sample, keep one of each period, that from which on \
                 its force is held"
            ),
        },
        _ => Finding {
            kind: "oversampled",
            says: format!("{says}, and the wall's law commands one force for each period"),
            fix: format!(
                "log one row for each sample, or the force beside the position; or {unit}"
            ),
        },
    })
}
