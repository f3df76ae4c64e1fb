//! TH-REGION: a region is the set of speeds at which the criterion holds.

use passivity_core::{
    Criterion, Interval, Loop, Region, Scalar, Truth,
    region::critical_speed,
    verdict::{Speeds, decide},
};

use crate::domain::{COARSE_EXPONENT, SPEED_LIMIT, below, up_to};
use crate::{Dyadic, Ratio};

/// Eighths: what friction has to spare, in [−2, 2), 5 bits.
const SPARE_LIMIT: i8 = 16;

/// Slower than any border: 1/16. A spare of at least 1/8 outweighs one of up to 2 at this speed.
const SLOW: Dyadic = Dyadic::new(1, 4);

/// Faster than any border: 32. A spare of at least 1/8 outweighs one of up to 2 at this speed.
const FAST: Dyadic = Dyadic::new(32, 0);

pub(crate) fn criterion() -> Criterion<Dyadic> {
    let viscous = kani::any_where(|n: &i8| *n >= -SPARE_LIMIT && *n < SPARE_LIMIT);
    let coulomb = kani::any_where(|n: &i8| *n >= -SPARE_LIMIT && *n < SPARE_LIMIT);
    Criterion {
        viscous: Dyadic::new(i32::from(viscous), 3),
        coulomb: Dyadic::new(i32::from(coulomb), 3),
    }
}

/// A speed above zero: at least 1/4, below 8.
pub(crate) fn moving() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n >= 1 && *n < SPEED_LIMIT);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

fn holds(criterion: &Criterion<Dyadic>, speed: Dyadic) -> bool {
    criterion.margin(&speed).is_at_least_zero()
}

/// TH-REGION: all speeds, none, those up to a critical one, those from a critical one on.
#[kani::proof]
fn th_region_is_the_set_of_speeds() {
    let criterion = criterion();
    let slower = moving();
    let faster = moving();
    let region = Region::of(&criterion);
    kani::cover!(region == Some(Region::LocallyStable), "locally stable");
    kani::cover!(region == Some(Region::LimitCycles), "limit cycles");
    kani::cover!(
        region == Some(Region::GloballyStable) && criterion.coulomb == Dyadic::zero(),
        "on a line of the plane"
    );
    if slower <= faster {
        let as_named = match region {
            Some(Region::GloballyStable) => holds(&criterion, slower),
            Some(Region::Unstable) => !holds(&criterion, slower),
            Some(Region::LocallyStable) => {
                holds(&criterion, SLOW)
                    && !holds(&criterion, FAST)
                    && (holds(&criterion, slower) || !holds(&criterion, faster))
            }
            Some(Region::LimitCycles) => {
                !holds(&criterion, SLOW)
                    && holds(&criterion, FAST)
                    && (!holds(&criterion, slower) || holds(&criterion, faster))
            }
            None => false,
        };
        kani::assert(
            as_named,
            "TH-REGION: a region is the set of speeds where (8) holds",
        );
    }
}

/// TH-REGION: the margin at every speed is the least of all, up to a factor: its sign decides.
#[kani::proof]
fn th_region_margin_at_all_speeds() {
    let criterion = criterion();
    let speed = moving();
    let at_all = criterion.margin_at_all_speeds();
    kani::cover!(at_all == Dyadic::zero(), "on the corner or its lines");
    if at_all.is_at_least_zero() {
        kani::assert(
            holds(&criterion, speed) && holds(&criterion, Dyadic::zero()),
            "TH-REGION: with a margin at all speeds (8) holds at each",
        );
    } else {
        kani::assert(
            !holds(&criterion, Dyadic::zero()) || !holds(&criterion, FAST),
            "TH-REGION: without a margin at all speeds (8) fails at rest or at high speed",
        );
    }
}

/// TH-REGION: the margin up to a speed is the least one on the way there.
#[kani::proof]
fn th_region_margin_up_to_a_speed() {
    let criterion = criterion();
    let bound = moving();
    let speed = moving();
    if speed <= bound {
        let up_to = criterion.margin_up_to(&bound);
        let (at_rest, at_bound) = (criterion.margin(&Dyadic::zero()), criterion.margin(&bound));
        kani::cover!(
            at_bound < at_rest && speed < bound,
            "the margin falls with the speed"
        );
        kani::assert(
            criterion.margin(&speed) >= up_to,
            "TH-REGION: no speed up to the bound has less margin",
        );
        kani::assert(
            up_to == at_rest || up_to == at_bound,
            "TH-REGION: the margin up to a speed is that at one end",
        );
    }
}

/// TH-REGION: the critical speed is the border of the set, and the margin there is zero.
#[kani::proof]
fn th_region_ends_at_the_critical_speed() {
    let criterion = Criterion {
        viscous: below(16) - Ratio::integer(8),
        coulomb: below(16) - Ratio::integer(8),
    };
    let speed = up_to(16).half().half();
    let critical = critical_speed(&criterion);
    let holds = criterion.margin(&speed) >= Ratio::zero();
    match Region::of(&criterion) {
        Some(Region::LocallyStable) => {
            kani::cover!(
                speed == critical,
                "at the critical speed of a locally stable point"
            );
            kani::assert(
                holds == (speed <= critical) && criterion.margin(&critical) == Ratio::zero(),
                "TH-REGION: locally stable up to the critical speed",
            );
        }
        Some(Region::LimitCycles) => {
            kani::cover!(
                speed == critical,
                "at the critical speed of a point with limit cycles"
            );
            kani::assert(
                holds == (speed >= critical) && criterion.margin(&critical) == Ratio::zero(),
                "TH-REGION: limit cycles below the critical speed",
            );
        }
        region => kani::assert(
            region.is_some() && holds == (region == Some(Region::GloballyStable)),
            "TH-REGION: elsewhere the answer does not depend on the speed",
        ),
    }
}

/// TH-REGION: the verdict up to a speed holds exactly when (8) does at every speed v, 0 < v ≤ V.
#[kani::proof]
fn th_region_verdict_up_to_a_speed() {
    let criterion = criterion();
    let bound = moving();
    let speed = moving();
    if let Some(decision) = decide(&criterion, &Speeds::UpTo(bound)) {
        kani::cover!(
            decision.holds && criterion.viscous < Dyadic::zero(),
            "it holds thanks to the bound"
        );
        if decision.holds && speed <= bound {
            kani::assert(
                holds(&criterion, speed) && holds(&criterion, SLOW),
                "TH-REGION: a verdict up to a speed holds at every speed below",
            );
        }
        if !decision.holds {
            kani::assert(
                !holds(&criterion, bound) || !holds(&criterion, SLOW),
                "TH-REGION: a verdict that does not hold has a speed at which (8) fails",
            );
        }
    } else {
        kani::assert(false, "TH-REGION: there is a verdict for every criterion");
    }
}

/// TH-REGION: the verdict at every speed holds exactly in the globally stable region.
#[kani::proof]
fn th_region_verdict_at_every_speed() {
    let criterion = criterion();
    let expected = criterion.margin_at_all_speeds().is_at_least_zero();
    kani::cover!(expected, "the criterion holds at every speed");
    kani::cover!(!expected, "it does not");
    let decided = decide(&criterion, &Speeds::All).map(|decision| decision.holds);
    kani::assert(
        decided == Some(expected),
        "TH-REGION: the verdict at every speed is β ≥ ½ and σ ≥ ½",
    );
}

/// Units of a tolerance, halves for c: up to 4, 2 bits, three numbers an interval.
const TOLERANCE: u8 = 4;

/// An interval of [1, `most`] and a number within it.
fn tolerance(most: u8) -> (Interval<Ratio>, Ratio) {
    let lo = kani::any_where(|n: &u8| *n >= 1 && *n <= most);
    let x = kani::any_where(|n: &u8| *n >= lo && *n <= most);
    let hi = kani::any_where(|n: &u8| *n >= x && *n <= most);
    let number = |n: u8| Ratio::integer(i32::from(n));
    (Interval::hull(number(lo), number(hi)), number(x))
}

/// A box of loops with tolerances of c and T, and one loop within it.
///
/// T pulls both ways, since virtual damping costs BΔ/T. b is exact, and so are K = 2, B = Δ = 1.
fn loops_and_one_of_them() -> (Loop<Interval<Ratio>>, Loop<Ratio>) {
    let viscous = below(TOLERANCE);
    let (double_coulomb_box, double_coulomb) = tolerance(TOLERANCE);
    let (period_box, period) = tolerance(TOLERANCE - 1);
    let two = Ratio::integer(2);
    let loops = Loop {
        viscous: Some(Interval::point(viscous)),
        coulomb: Some(double_coulomb_box.map(|c| c.half())),
        resolution: Some(Interval::point(Ratio::one())),
        damping: Some(Interval::point(Ratio::one())),
        ..Loop::new(Interval::point(two), period_box)
    };
    let one = Loop {
        viscous: Some(viscous),
        coulomb: Some(double_coulomb.half()),
        resolution: Some(Ratio::one()),
        damping: Some(Ratio::one()),
        ..Loop::new(two, period)
    };
    (loops, one)
}

/// TH-REGION: a verdict over tolerances is that of every loop within them, or it depends.
#[kani::proof]
#[kani::unwind(5)]
fn th_region_verdict_over_tolerances() {
    let (loops, one) = loops_and_one_of_them();
    let truth = loops.decide(&Speeds::All);
    let one = decide(&one.criterion(), &Speeds::All).map(|decision| decision.holds);
    kani::cover!(truth == Some(Truth::Depends), "it depends");
    kani::cover!(
        truth == Some(Truth::Holds) && !loops.period.is_point(),
        "it holds for every period of an interval"
    );
    let agrees = match truth {
        Some(Truth::Holds) => one == Some(true),
        Some(Truth::Fails) => one == Some(false),
        Some(Truth::Depends) => one.is_some(),
        None => false,
    };
    kani::assert(
        agrees,
        "TH-REGION: a verdict over tolerances is that of each loop within",
    );
}

/// TH-REGION: a region over tolerances is that of every loop within them, or there is none.
#[kani::proof]
#[kani::unwind(5)]
fn th_region_region_over_tolerances() {
    let (loops, one) = loops_and_one_of_them();
    let region = loops.region();
    kani::cover!(
        region == Some(Region::GloballyStable) && !loops.period.is_point(),
        "globally stable for every period of an interval"
    );
    kani::assert(
        region.is_none() || region == Region::of(&one.criterion()),
        "TH-REGION: a region over tolerances is that of each loop within",
    );
}
