//! How far forces are from those of the law, from a multiple of it, and from that of a wall that is moved.

use super::Comparison;
use crate::log::exact::ExactSum;
use crate::log::findings::ROUGH;
use crate::log::report::Fitted;

/// Forces whose variance is less than this share of their mean square are the same for a fit by doubles.
const SAME: f64 = 1e-9;

/// So many rows tell a delay, or how far a wall is moved.
const FEW: u64 = 8;

/// Forces of a wall that is moved are nearer to its law than this share of their size.
const MOVED: f64 = 0.05;

/// A wall is moved by less than so many times the mean depth in it, as a root of the mean square.
const FAR: f64 = 4.0;

impl Comparison {
    /// The multiple of the law, at some lag, that the forces come nearest to; `None` when forces or
    /// law are zero throughout.
    ///
    /// At the scene's delay it may be that of a wall that is moved, where the forces come much nearer to that: a controller
    /// that takes a count for the position, and not the middle of its tick, moves the wall by half a tick.
    pub(crate) fn fit(&self) -> Option<Fitted> {
        let fits = (0..self.lags.len()).filter_map(|lag| self.fit_at(lag));
        let told = fits.filter(|fit| fit.delay == self.delay || self.is_told_at(fit.delay));
        let nearest = told.min_by(|a, b| a.residual.total_cmp(&b.residual))?;
        // Which of two that are as near is nearer is told by noise, or by the last digits.
        let is_as_near = |own: &Fitted| {
            nearest.residual > 0.99 * own.residual || own.residual <= self.rounding()
        };
        let is_own = self
            .own_beside(nearest.delay)
            .is_some_and(|own| is_as_near(&own));
        let own = self.fit_at(self.delay).filter(|_| is_own);
        let nearest = own.unwrap_or(nearest);
        let is_nearer = |moved: &Fitted| {
            nearest.residual > self.rounding()
                && moved.residual < MOVED
                && moved.residual < 0.5 * nearest.residual
        };
        Some(self.fit_moved().filter(is_nearer).unwrap_or(nearest))
    }

    /// Whether enough rows are compared at a lag that is not the scene's: of a few anything is a multiple.
    fn is_told_at(&self, lag: usize) -> bool {
        let left_out = self.left_out(lag);
        let compared = self.compared.saturating_sub(left_out);
        compared >= FEW && compared >= left_out
    }

    /// The multiple of the law at the scene's delay, and the force added to it in all rows that are unlike it, that the
    /// forces come nearest to.
    fn fit_moved(&self) -> Option<Fitted> {
        let agreement = self.lags.get(self.delay)?;
        let [(unlike, _), _] = agreement.mismatches;
        // A wall that is moved has another force wherever it has one.
        if unlike < FEW || 10 * unlike < 9 * self.unlike.acting {
            return None;
        }
        let [mixed, law] = agreement.products.each_ref().map(ExactSum::value);
        let [forces, laws] = self.unlike.values()?;
        #[expect(clippy::cast_precision_loss, reason = "a log has fewer rows than 2⁵³")]
        let rows = unlike as f64;
        // Least squares of two numbers: where all of the law's forces are the same, one of them is as good as the other.
        let determinant = law * rows - laws * laws;
        if determinant <= SAME * law * rows {
            return None;
        }
        let scale = (mixed * rows - forces * laws) / determinant;
        let added = (law * forces - laws * mixed) / determinant;
        let squares = self.squares_at(self.delay);
        let left = (squares - scale * mixed - added * forces).max(0.0);
        let fit = Fitted {
            delay: self.delay,
            scale,
            moved: added / scale,
            residual: (left / squares).sqrt(),
        };
        // What is nearly the same everywhere is the force of no wall, nor is a wall told from so far beside it.
        let apart = squares - forces * forces / rows;
        let is_of_a_wall = left < 0.25 * apart && fit.moved.abs() < FAR * (law / rows).sqrt();
        let is_finite = fit.scale.is_finite() && fit.residual.is_finite();
        (is_finite && is_of_a_wall && fit.scale > 0.0).then_some(fit)
    }

    /// By how much all forces are off the law at the scene's delay where that is half of their last digit, to the same side.
    pub(crate) fn edge(&self) -> Option<f64> {
        let [above, below] = self.unlike.edges;
        let (count, sign) = if above > below {
            (above, 1.0)
        } else {
            (below, -1.0)
        };
        if count < FEW || count < self.unlike.acting || above.min(below) > 0 {
            return None;
        }
        #[expect(clippy::cast_precision_loss, reason = "a log has fewer rows than 2⁵³")]
        let mean = (self.roundings.value() / self.compared as f64).sqrt();
        Some(sign * mean)
    }

    /// Σ f² of the rows that are compared at a lag.
    fn squares_at(&self, lag: usize) -> f64 {
        let left_out = self.lags.get(lag).map_or(0.0, |lag| {
            let [squares, ..] = &lag.left_out.1;
            squares.value()
        });
        self.squares.value() - left_out
    }

    /// The multiple of the law at the scene's delay that the forces come nearest to in the rows that are compared at a lag.
    fn own_beside(&self, lag: usize) -> Option<Fitted> {
        let [squares, mixed, law] = self
            .lags
            .get(lag)?
            .left_out
            .1
            .each_ref()
            .map(ExactSum::value);
        let own = self.lags.get(self.delay)?.products.each_ref();
        let [of_mixed, of_law] = own.map(ExactSum::value);
        // Those that are left out at the scene's delay have no part in the latter.
        let least = self
            .squares_at(self.delay)
            .min(self.squares.value() - squares);
        Fitted::nearest(self.delay, [least, of_mixed - mixed, of_law - law])
    }

    /// The multiple of the law at a lag that the forces come nearest to.
    fn fit_at(&self, lag: usize) -> Option<Fitted> {
        let products = self.lags.get(lag)?.products.each_ref();
        let [mixed, law] = products.map(ExactSum::value);
        Fitted::nearest(lag, [self.squares_at(lag), mixed, law])
    }

    /// Whether the law has no force at the scene's delay.
    fn rests(&self) -> bool {
        let law = self.lags.get(self.delay).map(|lag| &lag.products[1]);
        law.is_none_or(|law| law.value() == 0.0)
    }

    /// Whether all forces are zero, and those of the law are not.
    pub(crate) fn is_zero(&self) -> bool {
        self.squares.value() == 0.0 && !self.rests()
    }

    /// How far off the digits of the forces may be, of their own size as a root of the mean square: what is left of
    /// forces that are a multiple of the law is no more.
    pub(crate) fn rounding(&self) -> f64 {
        (self.roundings.value() / self.squares.value()).sqrt()
    }

    /// How far the forces are from the law at the scene's delay, of their own size as a root of the mean square.
    pub(crate) fn difference(&self) -> Option<f64> {
        let squares = self.squares_at(self.delay);
        let products = self.lags.get(self.delay)?.products.each_ref();
        let [mixed, law] = products.map(ExactSum::value);
        let difference = ((squares - 2.0 * mixed + law).max(0.0) / squares).sqrt();
        difference.is_finite().then_some(difference)
    }

    /// Whether the law has a force that is far from those of the log at the scene's delay: where they agree to
    /// within their digits all the same, these are too few to tell anything.
    pub(crate) fn is_far(&self) -> bool {
        let near = |fit: Fitted| (fit.scale - 1.0).abs() < ROUGH && fit.residual < ROUGH;
        !self.rests() && !self.fit_at(self.delay).is_some_and(near)
    }
}
