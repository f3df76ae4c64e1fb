//! The motion over a whole short piece, as a table of what its end has of its start.
//!
//! Counted from the start of the piece, in the fraction s of its length h, let x be the way, V = dx/ds,
//! E = P(y − u) with P = h²/M, and w = P(u + F − σs − kξ₀) the constant pull. Then
//!
//! > E′ = −KE, x′ = V, V′ = E + w − DV − Sx with K = κh, D = β′h/M and S = kh²/M.
//!
//! Each of V, E and w at the start adds to the end by itself, and every pair of them to the integrals. So
//! an interval about one of them never widens but by what the motion makes of it.

use std::sync::OnceLock;

use super::Flow;
use super::power::{self, Series};
use super::products::Integrals;
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
    per_mass: R,
    /// E at the end from E = 1.
    decay: R,
    /// The coefficients of x in s, from V = 1, E = 1 and w = 1.
    ways: [Vec<R>; 3],
    /// x at the end.
    way: [R; 3],
    /// V likewise.
    speed: [R; 3],
    rates: Rates<R>,
    /// Once they were asked for.
    integrals: OnceLock<Integrals<R>>,
}

impl<R: Real> Flow<R> {
    /// The table of a piece of length `h`, at most that of the flow.
    pub(super) fn table(&self, h: &R) -> Table<R> {
        let (has_lag, has_arm) = (self.rate.is_some(), self.arm.is_some());
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
        let mut output = if has_lag { one.clone() } else { R::zero() };
        let mut ways = [one.clone(), R::zero(), R::zero()].map(|c| vec![R::zero(), c]);
        let count = power::terms(h.bits(), 1);
        for n in 2..count {
            let share = h.ratio(1, n * (n - 1));
            let constant = if n == 2 { one.clone() } else { R::zero() };
            let pulls = [R::zero(), output.clone(), constant];
            for (way, mut pull) in ways.iter_mut().zip(pulls) {
                let [.., before, latest] = way.as_slice() else {
                    continue; // There are two from the start.
                };
                pull = pull - rates.damping.clone() * latest.clone() * R::integer(n - 1);
                if has_arm {
                    pull = pull - rates.stiffness.clone() * before.clone();
                }
                way.push(pull * share.clone());
            }
            if has_lag {
                output = -(output * rates.output.clone()) * h.ratio(1, n - 1);
                decay = decay + output.clone();
            }
        }
        // With |c_{n+1}| ≤ (|e_{n−1}|/n + ½|c_n| + ¼|c_{n−1}|/n)/(n + 1) and |e_n| ≤ ½|e_{n−1}|/n what is
        // left out of x and of its first two derivatives is less than the last term with m in its
        // place, m = |c_n| + (|e_{n−1}| + ¼|c_{n−1}|)/n, and of E less than |e_{n−1}|.
        let last = h.ratio(1, count - 1);
        for way in &mut ways {
            if let [.., before, latest] = way.as_mut_slice() {
                let more = (output.abs() + before.abs().half().half()) * last.clone();
                *latest = latest.clone().widened(&(latest.abs() + more));
            }
        }
        let decay = match has_lag {
            true => decay.widened(&output),
            false => R::zero(),
        };
        Table {
            length: h.clone(),
            mass: self.mass.clone(),
            per_mass,
            integrals: OnceLock::new(),
            rates,
            decay,
            way: ways.each_ref().map(|way| power::derivative(way, &one, 0)),
            speed: ways.each_ref().map(|way| power::derivative(way, &one, 1)),
            ways,
        }
    }
}

impl<R: Real> Table<R> {
    /// ξ̇, (y − u)h/M and (u + F − σs − kξ₀)h/M at the start: V, E and w over h.
    fn inputs(&self, start: &Start<R>) -> [R; 3] {
        let [excess, pull] =
            [&start.excess, &start.pull].map(|x| x.clone() * self.per_mass.clone());
        [start.velocity.clone(), excess, pull]
    }

    /// The end of the piece.
    pub(super) fn end(&self, start: &Start<R>) -> End<R> {
        let inputs = self.inputs(start);
        End {
            way: combined(&self.way, &inputs) * self.length.clone(),
            velocity: combined(&self.speed, &inputs),
            excess: start.excess.clone() * self.decay.clone(),
        }
    }

    /// The amplifier's output at the end of the piece.
    pub(super) fn output(&self, output: &R, command: &R) -> R {
        command.clone() + (output.clone() - command.clone()) * self.decay.clone()
    }

    /// The series of x/h.
    pub(super) fn series(&self, start: &Start<R>) -> Series<R> {
        let inputs = self.inputs(start);
        let [of_v, of_e, of_w] = &self.ways;
        let terms = of_v.iter().zip(of_e).zip(of_w);
        let combined =
            |((v, e), w): ((&R, &R), &R)| combined(&[v.clone(), e.clone(), w.clone()], &inputs);
        Series(terms.map(combined).collect())
    }

    /// ∫ξ̇²dτ and ∫(y − u)ξ̇dτ over the piece.
    pub(super) fn integrals(&self, flow: &Flow<R>, start: &Start<R>) -> [R; 2] {
        let Integrals {
            vv,
            vw,
            ww,
            ee,
            ew,
            ev,
        } = self.integrals.get_or_init(|| flow.products(&self.rates));
        let [v, e, w] = self.inputs(start);
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

/// The sum of the inputs, each times what comes of it.
fn combined<R: Real>(of: &[R; 3], inputs: &[R; 3]) -> R {
    let products = of.iter().zip(inputs).map(|(of, x)| of.clone() * x.clone());
    products.fold(R::zero(), |sum, x| sum + x)
}
