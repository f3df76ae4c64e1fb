//! The account (TH-MONITOR): what the held forces have given the operator, at the least and at the
//! most that the counts allow.
//!
//! Positions x in ticks, x = n + ρ with 0 ≤ ρ ≤ 1 and n the count; energies in halves of the force
//! unit times a tick. Up to sample h the wall has given, beyond what its spring stored at the start,
//!
//! ```text
//! U_h = Σ given(d_i) − K x_0²,    given(d) = 2F d − 2V d² − 2C |d|,    d_i = x_{i+1} − x_i
//! ```
//!
//! with F the force that was held over the interval, and V = bΔ/T and C = c what friction takes.
//! Every ρ_i may be anything from 0 to 1. The cell of a count is half open, but `given` is continuous:
//! the bounds over the closed cell are the same.
//!
//! **Least.** −U is a sum of convex functions of the ρ_i, so U is least with every ρ_i at 0 or at 1.
//! The least U_h that ends at either is found from the two before it: four moves, of which two are of
//! the same length. That is exact: no more can be said for sure.
//!
//! **Most.** The wall's own spring is split off: at every sample
//!
//! ```text
//! U_h ≤ most + sρ − Kρ²                                                                      (1)
//! ```
//!
//! It holds at the start with s = −2Kn and most = −Kn². Under a force F over the next interval s becomes
//! s′ = K + 2F, at the cost of max(s − s′, 0), as ρ ≤ 1. A move by D ticks then takes (1) to the next
//! sample with s′ − 2KD and most + D(s′ − KD) − [`net`], where `net` is the least, over all positions
//! within both ticks, of twice what friction takes less what the wall of stiffness K generates (TH-LIN):
//!
//! ```text
//! 2V d² + 2C|d| − K d² − 2K(ρ₀ − ½)d,    d = D + ρ₁ − ρ₀
//! ```
//!
//! It is never below zero where b ≥ KT/2 and c ≥ KΔ/2 (TH-INTERVAL), so a passive wall stays surely
//! passive for ever.

use crate::config::Config;
use crate::width::Width;

/// What is known of U at a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Account<W> {
    /// `most` in (1).
    pub most: W,
    /// s in (1).
    pub slope: W,
    /// The least U with the position at the lower end of the tick.
    pub least: W,
    /// How much more it is at the upper end.
    pub apart: W,
}

impl<W: Width> Account<W> {
    /// At the first sample; `None` when the stored energy does not fit.
    #[must_use]
    pub fn start(config: &Config, count: W) -> Option<Self> {
        let stiffness = W::from_i64(config.stiffness);
        if let Some(stored) = config.stored {
            let given = W::ZERO.minus(W::from_i64(stored));
            return Some(Self {
                most: given,
                slope: stiffness,
                least: given,
                apart: W::ZERO,
            });
        }
        let force = |position: W| W::ZERO.minus(stiffness).checked_times(position);
        let after = count.checked_plus(W::from_i64(1))?;
        let [lower, upper] = [force(count)?, force(after)?];
        let most = lower.checked_times(count)?;
        upper.checked_times(after)?;
        Some(Self {
            most,
            slope: lower.checked_plus(lower)?,
            least: most,
            apart: lower.checked_plus(upper)?,
        })
    }

    /// Goes on to the next sample: this force was held, and the count changed by `ticks`; `None` when
    /// a sum does not fit, and the account is lost.
    ///
    /// Force and ticks are within [`FORCE_MAX`](Width::FORCE_MAX) and [`STEP_MAX`](Width::STEP_MAX), and
    /// the slope and how far the least is apart are what [`start`](Self::start) or a step leads to.
    #[inline]
    pub fn advance(&mut self, config: &Config, force: W, ticks: i64) -> Option<()> {
        let (twice, slope) = under(config, force);
        self.advance_least(config, twice, ticks)?;
        self.advance_most(config, slope, ticks)
    }

    /// The same of the least alone, of twice the force; `None` when a sum does not fit, and nothing has changed.
    #[inline]
    pub(crate) fn advance_least(&mut self, config: &Config, twice: W, ticks: i64) -> Option<()> {
        // `given` of the same distance, and what one tick more and one less add to it: the force gives
        // 2F more and less, and friction takes 2V(2d + 1) and 2V(1 − 2d) more, and 2C more and less
        // where d is not zero.
        let (viscous, coulomb) = (config.twice_viscous, config.twice_coulomb);
        let (stays, further, taken) = if ticks == 0 {
            (W::ZERO, twice, viscous.plus(coulomb))
        } else {
            let dragged = viscous.times(ticks);
            let rubbed = if ticks < 0 {
                config.minus_coulomb
            } else {
                coulomb
            };
            let pull = twice.minus(W::from_i64(dragged.plus(rubbed)));
            let stays = pull.times(W::from_i64(ticks));
            (stays, pull.minus(W::from_i64(dragged)), viscous)
        };
        let taken = W::of_size(taken);
        let rose = further.minus(taken);
        let fell = W::ZERO.minus(further).minus(taken);
        // From the lower end or from the upper one, whichever gives less, to either end.
        let lower = self.apart.plus(fell).min(W::ZERO);
        let apart = self.apart.min(rose).minus(lower);
        let least = self.least.checked_plus(stays.plus(lower))?;
        least.checked_plus(apart)?;
        (self.least, self.apart) = (least, apart);
        Some(())
    }

    /// The same of the most and its slope alone, of s′; `None` when the most does not fit, and nothing has changed.
    #[inline]
    pub(crate) fn advance_most(&mut self, config: &Config, slope: W, ticks: i64) -> Option<()> {
        // Products of ticks and parameters fit in 64 bits for either width.
        let ahead: W = net(config, ticks.signed_by(ticks.sign_mask()));
        let turned = W::from_i64(config.stiffness.times(ticks));
        let held = self.slope.max(slope).minus(slope);
        let slanted = slope.minus(turned);
        let moved = slanted.times(W::from_i64(ticks));
        self.most = self.most.checked_plus(held.minus(ahead).plus(moved))?;
        self.slope = slanted.minus(turned);
        Some(())
    }

    /// The most that U can be: (1) at its largest; `None` when it does not fit.
    ///
    /// Between 0 and 1, sρ − Kρ² is largest at ρ = s/2K, or at the end that is nearer.
    #[inline]
    #[must_use]
    pub fn at_most(&self, config: &Config) -> Option<W> {
        if self.slope <= W::ZERO {
            return Some(self.most);
        }
        let stiffness = W::from_i64(config.stiffness);
        let twice = stiffness.plus(stiffness);
        let rise = if self.slope < twice {
            self.slope
                .times(self.slope)
                .over_rounded_up(twice.plus(twice))?
        } else {
            self.slope.minus(stiffness)
        };
        self.most.checked_plus(rise)
    }

    /// Whether [`at_most`](Self::at_most) is above zero, or does not fit.
    ///
    /// Without the division: for s < 2K the rise s²/4K is less than K.
    #[inline]
    #[must_use]
    pub fn may_be_positive(&self, config: &Config) -> bool {
        let stiffness = W::of_size(config.stiffness);
        let twice = stiffness.plus(stiffness);
        if !self.slope.is_below(twice) {
            // From 2K on the rise is s − K. Of a slope below zero there is none, and `most` is not above −s either.
            return self.most > W::ZERO || self.most > stiffness.minus(self.slope);
        }
        if !self.most.is_within(stiffness, twice) {
            return self.most > W::ZERO;
        }
        // From −K to K: s² + 4K·most fits in 64 bits for either width.
        let (most, slope) = (self.most.low(), self.slope.low());
        let four = config.stiffness.times(4);
        four.times(most).plus(slope.times(slope)) > 0
    }

    /// The least that U can be.
    #[inline]
    #[must_use]
    pub fn at_least(&self) -> W {
        self.least.plus(self.apart.min(W::ZERO))
    }

    /// Whether [`at_least`](Self::at_least) is above zero.
    #[inline]
    pub(crate) fn is_positive(&self) -> bool {
        self.least > W::ZERO && self.least.plus(self.apart) > W::ZERO
    }
}

/// 2F, and s′ under this force.
#[inline]
pub(crate) fn under<W: Width>(config: &Config, force: W) -> (W, W) {
    let twice = force.plus(force);
    let slope = twice.plus(W::of_size(config.stiffness));
    (twice, slope)
}

/// What a force gives over a move of `distance` ticks from sample to sample, less what friction
/// takes at its most (26).
#[must_use]
pub fn given<W: Width>(config: &Config, force: W, distance: W) -> W {
    let viscous = W::from_i64(config.twice_viscous);
    let coulomb = W::from_i64(config.twice_coulomb);
    let length = distance.signed_by(distance.sign_mask());
    let work = force.plus(force).minus(viscous.times(distance));
    distance.times(work).minus(coulomb.times(length))
}

/// The least net energy of an interval in which the count changes by `ticks` ≥ 0 up or down, rounded
/// down; friction at its least.
///
/// At a distance d ≥ 0 it is least with ρ₀ as large as can be. Up to d = D that is 1, and net energy
/// (2V − K)d² + (2C − K)d: least at d = D − 1, at d = D, or at the vertex between. Beyond, ρ₁ is 1 and
/// ρ₀ = D + 1 − d, and net energy rises from what it is at D, unless it first falls: by the square of
/// its slope 4VD + 2C − K there over 4(2V + K).
///
/// Short intervals are tabulated. Of long ones the vertex is taken to be everywhere, and the fall to be
/// that of the last in the table: a little too low, where friction is so small that either is there at all.
#[inline]
#[must_use]
pub fn net<W: Width>(config: &Config, ticks: i64) -> W {
    let net = &config.net;
    if let Some(short) = ticks.index().and_then(|ticks| net.short.get(ticks)) {
        return W::from_i64(*short);
    }
    let x = ticks.minus(ticks.is_below(net.peak).into());
    W::product(net.square.times(x).plus(net.linear), x).plus(W::from_i64(net.constant))
}
