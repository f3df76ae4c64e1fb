//! What uses up the friction of a device, and what to change: advice, not proof. What it tells to type
//! has been checked like any limit.

use num_traits::Signed as _;
use passivity_core::verdict::{End, Speeds};
use passivity_core::{BigRational, Cost, Enclosed, Interval, Loop, pi};
use schemars::JsonSchema;
use serde::Serialize;

use super::decide::Verdict;
use super::figures::Figures;
use super::limits::{Limit, typed_back};
use super::report::Report;
use super::{BITS, figure};
use crate::display::{Rounding, significant, wrapped};
use crate::json::shape;
use crate::number::nearest_f64;
use crate::scene::Motion;
use crate::written::{Form, Written};

/// Which friction decides whether the criterion holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Binds {
    /// Viscous friction, against what fast motions generate.
    Viscous,
    /// Coulomb friction, against what slow motions generate.
    Coulomb,
    /// Both together at the bound on the speed.
    AtSpeedBound,
}

/// The part of the friction asked for that one effect asks for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Share {
    /// The effect, in a word or two.
    pub of: &'static str,
    /// Its part of the whole; below zero where it takes off what the effects before it ask for.
    pub share: f64,
}

/// A bound on the speed up to which the wall is passive.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpeedToSet {
    /// What to type as `operator.max_speed`, with the unit.
    pub typed: String,
    /// The same in m/s or rad/s, or ticks a sample in a dimensionless scene.
    #[serde(with = "shape::Rational")]
    pub value: BigRational,
}

/// A change of one parameter that is enough alone.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Change {
    /// Which of the limits it is.
    pub limit: usize,
    /// By how much the number in the scene file changes, relative to what it is.
    pub relative: f64,
}

/// What uses up the friction, and what to change.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Advice {
    /// The friction that decides.
    pub binds: Binds,
    /// How much of it is used: above 1 where there is too little, `None` where there is none of it.
    pub used: Option<f64>,
    /// What it is used for.
    pub shares: Vec<Share>,
    /// A bound on the speed that makes the wall passive, where it is not.
    pub max_speed: Option<SpeedToSet>,
    /// The smallest change of one parameter that makes the wall passive, where it is not.
    pub smallest_change: Option<Change>,
}

/// The advice on a box of loops, about the speeds that its limits speak of; `None` where a figure is
/// undefined.
pub(super) fn of<S: Enclosed>(
    figures: &Figures<'_, S>,
    speeds: &Speeds<Interval<S>>,
    verdict: Verdict,
    limits: &[Limit],
    speed_written: &Written,
) -> Option<Advice> {
    let to_mend = !matches!(verdict, Verdict::Passive | Verdict::NotCovered);
    let speed = match speeds.at(End::Hardest) {
        Speeds::UpTo(v) => Some(upper(&v)?),
        _ => None,
    };
    let (binds, used, shares) = uses(figures.bounds, speed.as_ref())?;
    Some(Advice {
        binds,
        used,
        shares,
        max_speed: if to_mend {
            speed_to_set(figures, speed_written)
        } else {
            None
        },
        smallest_change: if to_mend { smallest(limits) } else { None },
    })
}

fn upper<S: Enclosed>(x: &S) -> Option<BigRational> {
    Some(x.enclosed(BITS)?.hi().clone())
}

/// What the effects ask for one after the other, with their names: the first asks through sampling
/// and the encoder.
fn asked<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
) -> Option<Vec<(&'static str, Cost<BigRational>)>> {
    let hardest = bounds.at(End::Hardest);
    let mut so_far = hardest.clone().reshaped(|bare| {
        bare.damping = None;
        bare.damping_time_constant = None;
        bare.controller = None;
        bare.latency = None;
        bare.time_constant = None;
        bare.force_step = None;
        bare.delay = 0;
    });
    let mut steps = Vec::new();
    let mut add = |name, so_far: &Loop<S>| {
        let point = so_far.map(|_, x| Interval::point(x.clone()));
        let cost = point.with_costs(BITS)?.map(|_, x| x.hi().clone()).cost();
        steps.push((
            name,
            Cost {
                viscous: upper(&cost.viscous)?,
                coulomb: upper(&cost.coulomb)?,
            },
        ));
        Some(())
    };
    add("sampling", &so_far)?;
    if hardest.delay > 0 {
        so_far.delay = hardest.delay;
        add("delay", &so_far)?;
    }
    if hardest.controller.is_some() {
        so_far.controller.clone_from(&hardest.controller);
        add("controller", &so_far)?;
    } else if hardest.damping.is_some() {
        so_far.damping.clone_from(&hardest.damping);
        so_far
            .damping_time_constant
            .clone_from(&hardest.damping_time_constant);
        add("virtual damping", &so_far)?;
    }
    if hardest.latency.is_some() {
        so_far.latency.clone_from(&hardest.latency);
        add("latency", &so_far)?;
    }
    if hardest.time_constant.is_some() {
        so_far.time_constant.clone_from(&hardest.time_constant);
        add("amplifier", &so_far)?;
    }
    if hardest.force_step.is_some() {
        so_far.force_step.clone_from(&hardest.force_step);
        add("D/A steps", &so_far)?;
    }
    Some(steps)
}

type Uses = (Binds, Option<f64>, Vec<Share>);

/// The friction that decides, how much of it is used, and for what.
fn uses<S: Enclosed>(bounds: &Loop<Interval<S>>, speed: Option<&BigRational>) -> Option<Uses> {
    let steps = asked(bounds)?;
    let corner = bounds.at(End::Hardest);
    let viscous = corner.viscous_friction().enclosed(BITS)?.lo().clone();
    let coulomb = corner.coulomb_friction().enclosed(BITS)?.lo().clone();
    let with_encoder = corner.has_encoder();
    let weighed = |of_viscous: &BigRational, of_coulomb: &BigRational| {
        let have = &viscous * of_viscous + &coulomb * of_coulomb;
        let mut shares: Vec<(&'static str, BigRational)> = Vec::new();
        let zero = || BigRational::from_integer(0.into());
        let (mut v, mut c) = (zero(), zero());
        for (name, cost) in &steps {
            let more = (&cost.viscous - &v) * of_viscous;
            let rest = (&cost.coulomb - &c) * of_coulomb;
            (v, c) = (cost.viscous.clone(), cost.coulomb.clone());
            if *name == "sampling" {
                shares.push((name, more));
                shares.push(("encoder", rest));
            } else {
                shares.push((name, more + rest));
            }
        }
        let need = v * of_viscous + c * of_coulomb;
        (have, need, shares)
    };
    let one = BigRational::from_integer(1.into());
    let zero = BigRational::from_integer(0.into());
    let fast = match speed {
        Some(v) => (Binds::AtSpeedBound, weighed(v, &one)),
        None => (Binds::Viscous, weighed(&one, &zero)),
    };
    let slow = (Binds::Coulomb, weighed(&zero, &one));
    let used = |(have, need, _): &(BigRational, BigRational, _)| {
        (*have > zero).then(|| nearest_f64(&(need / have)))
    };
    let or_infinite = |used: Option<f64>, need: &BigRational| match used {
        Some(used) => used,
        None if *need > zero => f64::INFINITY,
        None => 0.0,
    };
    let [a, b] = [&fast, &slow].map(|(_, w)| or_infinite(used(w), &w.1));
    let decides = if with_encoder && b > a { slow } else { fast };
    let (binds, weights) = decides;
    let used = used(&weights);
    let (_, need, shares) = weights;
    let share = |(of, part): (&'static str, BigRational)| {
        (part != zero && need > zero).then(|| Share {
            of,
            share: nearest_f64(&(part / &need)),
        })
    };
    Some((binds, used, shares.into_iter().filter_map(share).collect()))
}

/// The largest bound on the speed that is enough, as the scene file would write it.
fn speed_to_set<S: Enclosed>(figures: &Figures<'_, S>, written: &Written) -> Option<SpeedToSet> {
    let bounds = figures.bounds;
    let border = Interval::point(figures.speed_to_set()?);
    let border = figure(&border)?.lo().clone();
    let suffices = |v: &S| bounds.surely_holds(&Speeds::UpTo(Interval::point(v.clone())));
    let typed = typed_back(written, &border, Rounding::Down, suffices)?;
    let value = written.typed(&crate::number::parse(&typed).ok()?);
    Some(SpeedToSet {
        typed: format!("{typed}{}", written.unit()),
        value: value.enclosure(BITS)?.lo().clone(),
    })
}

/// The limit that is the least away from what is, of those that are enough alone.
fn smallest(limits: &[Limit]) -> Option<Change> {
    let changes = limits.iter().enumerate().filter_map(|(limit, of)| {
        of.printed.as_ref()?;
        let now = of.written.of(&of.now)?;
        let border = of.written.of(&Interval::point(of.hardest().clone()))?;
        // The end of the tolerance that must move the farthest.
        let ends = [now.lo(), now.hi()].map(|x| (*x != BigRational::default()).then_some(x));
        let [a, b] = ends;
        let [a, b] = [a?, b?].map(|x| border.lo() / x);
        let one = BigRational::from_integer(1.into());
        let ratio = if (&a - &one).abs() > (&b - &one).abs() {
            a
        } else {
            b
        };
        if !ratio.is_positive() {
            return None;
        }
        let grows = ratio > one;
        let factor = if grows { ratio.clone() } else { ratio.recip() };
        let relative = nearest_f64(&ratio) - 1.0;
        Some((nearest_f64(&factor), grows, Change { limit, relative }))
    });
    // A factor of two up is as far as one of two down. On a tie the number that falls is taken: a softer
    // wall or a shorter period is for the program to set, and more friction is not.
    changes
        .min_by(|(a, a_grows, _), (b, b_grows, _)| a.total_cmp(b).then(a_grows.cmp(b_grows)))
        .map(|(.., change)| change)
}

impl Report {
    /// What uses up the friction that decides, in a line.
    pub(super) fn binds_text(&self) -> String {
        let advice = &self.advice;
        let friction = match advice.binds {
            Binds::Viscous => "viscous friction".to_owned(),
            Binds::Coulomb => "Coulomb friction".to_owned(),
            Binds::AtSpeedBound => format!("friction at {}", self.speed_bound_text()),
        };
        let used = match advice.used {
            Some(used) => format!("{} of what the device has is asked for", percent_up(used)),
            None => "the scene gives none that is sure, and it is asked for".to_owned(),
        };
        let share = |share: &Share| format!("{} {}", share.of, percent(share.share));
        let shares: Vec<String> = advice.shares.iter().map(share).collect();
        match shares.as_slice() {
            [] => format!("{friction}: nothing asks for it"),
            _ => format!("{friction}: {used}, by {}", shares.join(", ")),
        }
    }

    /// What to change where the wall is not passive, each in a line; empty where it is.
    pub(super) fn advice_text(&self) -> String {
        let mut out = String::new();
        if let Some(speed) = &self.advice.max_speed {
            let typed = &speed.typed;
            let is_rpm = typed.ends_with("rpm");
            let rpm = match self.motion {
                Motion::Rotary if !is_rpm => in_rpm(&speed.value),
                _ => None,
            };
            let rpm = rpm.map_or_else(String::new, |rpm| format!(" ({rpm} rpm)"));
            let text = format!(
                "Passive at every speed up to {typed}{rpm}: set operator.max_speed = \"{typed}\" if the \
                 hand is never faster."
            );
            out += &format!("  {}\n", wrapped(&text, 2));
        }
        let change = self.advice.smallest_change.as_ref();
        let limit = change.and_then(|change| Some((change, self.limits.get(change.limit)?)));
        if let Some((change, limit)) = limit {
            let text = format!(
                "Smallest single change: {} {} (now {}), {}{}.",
                limit.name(self.motion),
                limit.promise(self.motion),
                limit.now(self.motion),
                if change.relative < 0.0 { "−" } else { "+" },
                percent_up(change.relative.abs())
            );
            out += &format!("  {}\n", wrapped(&text, 2));
        }
        out
    }
}

/// A part as a percentage.
fn percent(part: f64) -> String {
    let sign = if part < 0.0 { "−" } else { "" };
    format!(
        "{sign}{} %",
        significant(round(part.abs() * 100.0, f64::round))
    )
}

/// A part as a percentage, rounded up.
fn percent_up(part: f64) -> String {
    format!("{} %", significant(round(part * 100.0, f64::ceil)))
}

/// To one decimal below 100 and none above, so that a figure above 100 % never reads as 100 %.
fn round(percent: f64, to_whole: impl Fn(f64) -> f64) -> f64 {
    if percent <= 100.0 {
        to_whole(percent * 10.0) / 10.0
    } else {
        to_whole(percent)
    }
}

/// A speed in revolutions a minute, rounded down.
fn in_rpm(speed: &BigRational) -> Option<String> {
    let one = pi::pi() * passivity_core::Exact::of(&BigRational::new(1.into(), 30.into()));
    Written::new(Form::Value, "rpm", one).rounded(speed, 5, Rounding::Down)
}
