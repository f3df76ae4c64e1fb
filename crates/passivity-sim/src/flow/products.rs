//! ∫V²ds and ∫EVds over a piece: the products of two of E, x, V and w follow a linear law as they do
//! themselves (see [`super::table`]), and its series sums up their integrals.

use super::Flow;
use super::power::terms;
use super::table::Rates;
use crate::number::Real;

/// The derivatives, of one order, of the products of two of E, x, V and w.
struct Products<R> {
    ee: R,
    ew: R,
    ev: R,
    vw: R,
    vv: R,
    // Only an arm asks for these.
    ex: R,
    xw: R,
    xv: R,
    xx: R,
}

impl<R: Real> Products<R> {
    /// The derivatives of the next order; of w² comes what is constant.
    fn next<const ARM: bool>(&self, rates: &Rates<R>, constant: R) -> Self {
        let [k, d, s] = [&rates.output, &rates.damping, &rates.stiffness].map(|rate| {
            let rate = rate.clone();
            move |x: &R| rate.clone() * x.clone()
        });
        let mut next = Self {
            ee: -k(&self.ee).double(),
            ew: -k(&self.ew),
            ev: self.ee.clone() + self.ew.clone() - k(&self.ev) - d(&self.ev),
            vw: self.ew.clone() + constant - d(&self.vw),
            vv: (self.ev.clone() + self.vw.clone() - d(&self.vv)).double(),
            ex: R::zero(),
            xw: R::zero(),
            xv: R::zero(),
            xx: R::zero(),
        };
        if ARM {
            next.ev = next.ev - s(&self.ex);
            next.vw = next.vw - s(&self.xw);
            next.vv = next.vv - s(&self.xv).double();
            next.ex = self.ev.clone() - k(&self.ex);
            next.xw = self.vw.clone();
            next.xv =
                self.vv.clone() + self.ex.clone() + self.xw.clone() - d(&self.xv) - s(&self.xx);
            next.xx = self.xv.double();
        }
        next
    }

    /// The sum of the magnitudes.
    fn size(self) -> R {
        let Self {
            ee,
            ew,
            ev,
            vw,
            vv,
            ex,
            xw,
            xv,
            xx,
        } = self;
        let all = [ee, ew, ev, vw, vv, ex, xw, xv, xx];
        all.into_iter().fold(R::zero(), |sum, x| sum + x.abs())
    }
}

/// What ∫V²ds and ∫EVds over the piece have of one product at its start, each of them alone at 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Integrals<R> {
    pub(super) vv: [R; 2],
    pub(super) vw: [R; 2],
    pub(super) ww: [R; 2],
    pub(super) ee: [R; 2],
    pub(super) ew: [R; 2],
    pub(super) ev: [R; 2],
}

impl<R: Real> Flow<R> {
    /// The integrals over a piece.
    pub(super) fn products(&self, rates: &Rates<R>) -> Integrals<R> {
        match (&self.rate, &self.arm) {
            (Some(_), Some(_)) => Integrals::of::<true, true>(rates),
            (Some(_), None) => Integrals::of::<true, false>(rates),
            (None, Some(_)) => Integrals::of::<false, true>(rates),
            (None, None) => Integrals::of::<false, false>(rates),
        }
    }
}

impl<R: Real> Integrals<R> {
    fn of<const LAG: bool, const ARM: bool>(rates: &Rates<R>) -> Self {
        let zero = R::zero;
        let of = || Products {
            ee: zero(),
            ew: zero(),
            ev: zero(),
            vw: zero(),
            vv: zero(),
            ex: zero(),
            xw: zero(),
            xv: zero(),
            xx: zero(),
        };
        let one = || rates.damping.whole(1);
        let sum = |start: Products<R>, constant: R| start.summed::<ARM>(rates, constant);
        let lagging = |start: Products<R>| match LAG {
            true => sum(start, zero()),
            false => [zero(), zero()],
        };
        Self {
            vv: sum(Products { vv: one(), ..of() }, zero()),
            vw: sum(Products { vw: one(), ..of() }, zero()),
            ww: sum(of(), one()),
            ee: lagging(Products { ee: one(), ..of() }),
            ew: lagging(Products { ew: one(), ..of() }),
            ev: lagging(Products { ev: one(), ..of() }),
        }
    }
}

impl<R: Real> Products<R> {
    /// ∫V²ds and ∫EVds from these products and w² on.
    fn summed<const ARM: bool>(mut self, rates: &Rates<R>, mut constant: R) -> [R; 2] {
        let one = rates.damping.whole(1);
        // 1/(n + 1)!.
        let mut share = one.clone();
        let (mut square, mut work) = (self.vv.clone(), self.ev.clone());
        for n in 2..terms(one.bits(), 0) {
            self = self.next::<ARM>(rates, constant);
            constant = R::zero();
            share = share * one.ratio(1, n);
            square = square + self.vv.clone() * share.clone();
            work = work + self.ev.clone() * share.clone();
        }
        // No derivative is larger than 5½ times the largest of the order before, and 1/(n + 1)! is at
        // most a twelfth of the one before from the eleventh on: what is left out is at most
        // (5½/12)/(1 − 5½/12) < 1 of the last term with the largest of its order.
        let rest = self.size() * share;
        [square.widened(&rest), work.widened(&rest)]
    }
}
