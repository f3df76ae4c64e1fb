//! The motion over a whole short piece, as a table of what its end has of its start.
//!
//! Counted from the start of the piece, in the fraction s of its length h, let x be the way, V = dx/ds,
//! E = P(y − u) with P = h²/M, and w = P(u + F − σs − kξ₀) the constant pull. Then
//!
//! > E′ = −KE, x′ = V, V′ = E + w − DV − Sx with K = κh, D = β′h/M and S = kh²/M.
//!
//! Each of V, E and w at the start adds to the end by itself, and every pair of them to the integrals. So
//! an interval about one of them never widens but by what the motion makes of it.

use super::products::Integrals;
use super::{Flow, power};
use crate::number::Real;

/// K, D and S. On a piece K and D are at most ½ and S at most ¼.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rates<R> {
    pub(super) output: R,
    pub(super) damping: R,
    pub(super) stiffness: R,
}

/// What the motion starts with: ξ̇, the excess y − u of the output over what is commanded, and the
/// constant pull u + F − σs − kξ₀.
pub(super) struct Start<R> {
    pub(super) velocity: R,
    pub(super) excess: R,
    pub(super) pull: R,
}

/// What it ends with.
pub(super) struct End<R> {
    /// The way.
    pub(super) way: R,
    pub(super) velocity: R,
    pub(super) excess: R,
}

/// A piece of a length.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Table<R> {
    pub(super) length: R,
    /// M.
    mass: R,
    /// h/M.
    pub(super) per_mass: R,
    pub(super) rates: Rates<R>,
    /// E at the end from E = 1.
    decay: R,
    /// x at the end from V = 1, E = 1 and w = 1.
    way: [R; 3],
    /// V likewise.
    speed: [R; 3],
    integrals: Integrals<R>,
}

impl<R: Real> Flow<R> {
    /// The table of a piece of length `h`, at most that of the flow.
    pub(super) fn table(&self, h: &R) -> Table<R> {
        match (&self.rate, &self.arm) {
            (Some(_), Some(_)) => self.table_with::<true, true>(h),
            (Some(_), None) => self.table_with::<true, false>(h),
            (None, Some(_)) => self.table_with::<false, true>(h),
            (None, None) => self.table_with::<false, false>(h),
        }
    }

    fn table_with<const LAG: bool, const ARM: bool>(&self, h: &R) -> Table<R> {
        let per_mass = h.clone().over(self.mass.clone());
        let times = |x: Option<&R>, y: &R| x.map_or_else(R::zero, |x| x.clone() * y.clone());
        let (damping, stiffness) = match &self.arm {
            Some([damping, stiffness]) => (self.beta.clone() + damping.clone(), Some(stiffness)),
            None => (self.beta.clone(), None),
        };
        let rates = Rates {
            output: times(self.rate.as_ref(), h),
            damping: damping * per_mass.clone(),
            stiffness: times(stiffness, &(h.clone() * per_mass.clone())),
        };
        let one = h.whole(1);
        let mut decay = one.clone();
        // The coefficients of E, and of x from V, E and w alone.
        let mut output = if LAG { one.clone() } else { R::zero() };
        let mut before = [R::zero(), R::zero(), R::zero()];
        let mut latest = [one.clone(), R::zero(), R::zero()];
        let (mut way, mut speed) = (latest.clone(), latest.clone());
        let count = power::terms(h.bits());
        for n in 2..count {
            let share = h.ratio(1, n * (n - 1));
            let each = R::integer(n - 1);
            for (i, (before, latest)) in before.iter_mut().zip(&mut latest).enumerate() {
                let mut pull = -(rates.damping.clone() * latest.clone() * each.clone());
                if ARM {
                    pull = pull - rates.stiffness.clone() * before.clone();
                }
                if i == 1 {
                    pull = pull + output.clone();
                } else if i == 2 && n == 2 {
                    pull = pull + one.clone();
                }
                *before = std::mem::replace(latest, pull * share.clone());
            }
            for (sum, c) in way.iter_mut().zip(&latest) {
                *sum = sum.clone() + c.clone();
            }
            for (sum, c) in speed.iter_mut().zip(&latest) {
                *sum = sum.clone() + c.clone() * R::integer(n);
            }
            if LAG {
                output = -(output * rates.output.clone()) * h.ratio(1, n - 1);
                decay = decay + output.clone();
            }
        }
        // With |c_{n+1}| ≤ (|e_{n−1}|/n + ½|c_n| + ¼|c_{n−1}|/n)/(n + 1) and |e_n| ≤ ½|e_{n−1}|/n what is
        // left out of x is at most m, of V at most 2m, and of E at most |e_{n−1}|, where
        // m = |c_n| + (|e_{n−1}| + ¼|c_{n−1}|)/n.
        let last = h.ratio(1, count - 1);
        let sums = way.iter_mut().zip(&mut speed);
        for ((way, speed), (before, latest)) in sums.zip(before.iter().zip(&latest)) {
            let more = (output.abs() + before.abs().half().half()) * last.clone();
            let rest = latest.abs() + more;
            *way = way.clone().widened(&rest);
            *speed = speed.clone().widened(&rest.double());
        }
        Table {
            length: h.clone(),
            mass: self.mass.clone(),
            per_mass,
            integrals: Integrals::of::<LAG, ARM>(&rates),
            rates,
            decay: if LAG {
                decay.widened(&output)
            } else {
                R::zero()
            },
            way,
            speed,
        }
    }
}

impl<R: Real> Table<R> {
    /// The end of the piece.
    pub(super) fn end(&self, start: &Start<R>) -> End<R> {
        let [excess, pull] =
            [&start.excess, &start.pull].map(|x| x.clone() * self.per_mass.clone());
        let sum = |[of_v, of_e, of_w]: &[R; 3]| {
            of_v.clone() * start.velocity.clone()
                + of_e.clone() * excess.clone()
                + of_w.clone() * pull.clone()
        };
        End {
            way: sum(&self.way) * self.length.clone(),
            velocity: sum(&self.speed),
            excess: start.excess.clone() * self.decay.clone(),
        }
    }

    /// ∫ξ̇²dτ and ∫(y − u)ξ̇dτ over the piece.
    pub(super) fn integrals(&self, start: &Start<R>) -> [R; 2] {
        let Integrals {
            vv,
            vw,
            ww,
            ee,
            ew,
            ev,
        } = &self.integrals;
        let v = start.velocity.clone();
        let [e, w] = [&start.excess, &start.pull].map(|x| x.clone() * self.per_mass.clone());
        let products = [
            (vv, v.square()),
            (vw, v.clone() * w.clone()),
            (ww, w.square()),
            (ee, e.square()),
            (ew, e.clone() * w),
            (ev, e * v),
        ];
        let mut sums = [R::zero(), R::zero()];
        for ([square, work], product) in products {
            let [of_square, of_work] = sums;
            sums = [
                of_square + square.clone() * product.clone(),
                of_work + work.clone() * product,
            ];
        }
        // V = hξ̇ and E = h·(y − u)·h/M, ξ̇dτ = Vds.
        let [square, work] = sums;
        [square * self.length.clone(), work * self.mass.clone()]
    }
}
