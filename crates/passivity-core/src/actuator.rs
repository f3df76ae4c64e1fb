//! What latency and the lag of an amplifier cost of viscous friction (TH-LATENCY, TH-LAG).
//!
//! The force of an actuator with a non-negative impulse response follows its command late, by m
//! sampling periods on average. How late varies with the phase t of the sample by G(t), whose mean
//! is m and whose variance is Var. The largest share of the squared velocity that such a force draws
//! is κ = ½[(½ + m) + √((½ + m)² + Var)], so the criterion becomes (β − κ)|v| + (σ − ½) ≥ 0.
//!
//! A latency of s = k + f samples, 0 ≤ f < 1, has m = s and Var = f(1 − f). A first-order lag of
//! time constant θ (in periods) has m = θ and Var = (θ/2)·coth(1/(2θ)) − θ². One after the other
//! have m = s + θ, and G(t) is the lag's at the phase t − f, one more where t < f, so that
//!
//! Var = f(1 − f) + Var(θ) + 2θ·[(e^(−(1 − f)/θ) − e)/(1 − e) − f], e = e^(−1/θ);
//!
//! the last term is not above zero.

use num_rational::BigRational;

use crate::exponential::{decay, root};
use crate::fraction::Wide;
use crate::interval::Interval;
use crate::rational::{from_wide, to_wide};
use crate::scalar::{Ordered as _, Scalar};

/// A computing time before the output changes, and a first-order lag after it, in sampling periods.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar, actuator::Actuator};
///
/// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
/// let late = Actuator { latency: ratio(3, 10), time_constant: ratio(0, 1) };
/// // κ = ½(0.8 + √0.85) = 0.86097…
/// assert_eq!(late.decide(&ratio(86_098, 100_000)), Some(true));
/// assert_eq!(late.decide(&ratio(86_097, 100_000)), Some(false));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Actuator<S> {
    /// s ≥ 0, whole samples of delay included.
    pub latency: S,
    /// θ ≥ 0; 0 without a lag.
    pub time_constant: S,
}

/// The enclosures that a decision is looked for with, in bits after the point.
const WIDTHS: [u32; 9] = [64, 128, 256, 512, 1024, 2048, 4096, 8192, 16_384];

impl<S: Scalar> Actuator<S> {
    /// m, the mean delay, in sampling periods.
    #[must_use]
    pub fn mean_delay(&self) -> S {
        self.latency.clone() + self.time_constant.clone()
    }

    /// f(1 − f) with f the fractional part of the latency: the variance without a lag (TH-LATENCY).
    #[must_use]
    pub fn variance_of_latency(&self) -> S {
        let fraction = self.fraction();
        fraction.clone() * (S::one() - fraction)
    }

    /// A bound of the variance that needs no exponential: f(1 − f) + min(θ/2, 1/12) (TH-LAG).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Scalar, actuator::Actuator};
    ///
    /// let slow = Actuator { latency: Fixed::integer(0), time_constant: Fixed::integer(1) };
    /// assert_eq!(slow.variance_bound(), Fixed::new(1, 12));
    /// ```
    #[must_use]
    pub fn variance_bound(&self) -> S {
        let twelfth = S::one().over(S::integer(12));
        self.variance_of_latency() + self.time_constant.clone().half().min(twelfth)
    }

    /// f, the fractional part of the latency.
    fn fraction(&self) -> S {
        self.latency.clone() - self.latency.floor()
    }
}

/// Two numbers that are both not negative exactly when β ≥ κ, for a mean delay m ≥ 0 and a variance:
/// β − ½ − m and 4β(β − ½ − m) − Var (TH-LATENCY, TH-LAG).
///
/// κ is the larger root of the second as a polynomial in β, at least ½ + m, and the other root is
/// not above zero. It is (2β − ½ − m)² − (½ + m)² − Var, so no root is taken.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, actuator::spare};
///
/// // A delay of one sample: κ = 3/2.
/// let [one, zero] = [1, 0].map(Fixed::integer);
/// assert_eq!(spare(&Fixed::new(3, 2), &one, &zero), [zero, zero]);
/// ```
#[must_use]
pub fn spare<S: Scalar>(beta: &S, mean_delay: &S, variance: &S) -> [S; 2] {
    let over = beta.clone() - S::one().half() - mean_delay.clone();
    let square = (beta.clone() * over.clone()).double().double() - variance.clone();
    [over, square]
}

/// (θ/2)·coth(1/(2θ)) − θ², the variance of a lag of θ > 0, from e = e^(−1/θ) (TH-LAG).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, actuator::lag_variance};
///
/// // Were e a third, coth(1/(2θ)) = (1 + e)/(1 − e) would be 2.
/// assert_eq!(lag_variance(&Fixed::new(1, 2), &Fixed::new(1, 3)), Fixed::new(1, 4));
/// ```
#[must_use]
pub fn lag_variance<S: Scalar>(theta: &S, e: &S) -> S {
    let coth = (S::one() + e.clone()).over(S::one() - e.clone());
    theta.clone().half() * coth - theta.square()
}

/// What a latency with the fractional part f adds to the variances of its own and of the lag behind it, from
/// e = e^(−1/θ) and the power e^(−(1 − f)/θ); not above zero (TH-LAG).
#[must_use]
pub fn shared_variance<S: Scalar>(theta: &S, fraction: &S, power: &S, e: &S) -> S {
    let left = (power.clone() - e.clone()).over(S::one() - e.clone());
    (theta.clone() * (left - fraction.clone())).double()
}

impl Actuator<BigRational> {
    /// The variance, enclosed the tighter the more bits (TH-LAG); a point without a lag.
    ///
    /// Never above [`variance_bound`](Self::variance_bound), and never below zero.
    #[must_use]
    pub fn variance(&self, bits: u32) -> Interval<BigRational> {
        let theta = &self.time_constant;
        let of_latency = self.variance_of_latency();
        if theta.is_positive() != Some(true) {
            return Interval::point(of_latency);
        }
        let one = BigRational::one();
        let e = decay(&theta.recip(), bits);
        let most = self.variance_bound();
        // The variance of the lag grows with e; what the two have in common, for f > 0, grows with the
        // power and falls with e.
        let fraction = self.fraction();
        let power = decay(&(one - &fraction).over(theta.clone()), bits);
        let [of_latency, theta, fraction] = [&of_latency, theta, &fraction].map(to_wide);
        let [e, power] = [e, power].map(|enclosed| enclosed.map(to_wide));
        let of_lag = |e: &Wide| lag_variance(&theta, e);
        let common = |power: &Wide, e: &Wide| {
            if fraction == Wide::zero() {
                return Wide::zero();
            }
            shared_variance(&theta, &fraction, power, e)
        };
        let lo = of_latency.clone() + of_lag(e.lo()) + common(power.lo(), e.hi());
        let hi = of_latency + of_lag(e.hi()) + common(power.hi(), e.lo());
        let lo = from_wide(&lo.max(Wide::zero()));
        let hi = from_wide(&hi.min(to_wide(&most)));
        // Undefined where e may be 1: so slow a lag that more bits are needed.
        let (lo, hi) = lo.zip(hi).unwrap_or((BigRational::zero(), most));
        Interval::hull(lo, hi)
    }

    /// Whether β ≥ κ, exactly; `None` where no enclosure within bounds tells.
    ///
    /// With a lag Var is transcendental, so that β = κ cannot be, and some enclosure tells.
    #[must_use]
    pub fn decide(&self, beta: &BigRational) -> Option<bool> {
        let [beta, mean_delay] = [beta, &self.mean_delay()].map(to_wide);
        let holds = |variance: &BigRational| {
            let spares = spare(&beta, &mean_delay, &to_wide(variance));
            spares
                .iter()
                .all(|spare| spare.is_nonnegative() == Some(true))
        };
        WIDTHS.into_iter().find_map(|bits| {
            let variance = self.variance(bits);
            match (holds(variance.lo()), holds(variance.hi())) {
                (_, true) => Some(true),
                (false, _) => Some(false),
                (true, false) => None,
            }
        })
    }

    /// An enclosure of κ, at most `width` > 0 wide, for print; a point where κ is met exactly.
    ///
    /// `None` where no enclosure within bounds is so tight.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Scalar, actuator::Actuator};
    ///
    /// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
    /// let slow = Actuator { latency: ratio(0, 1), time_constant: ratio(1, 1) };
    /// let kappa = slow.cost(&ratio(1, 1_000_000)).unwrap(); // 1.51354…
    /// assert!(*kappa.lo() > ratio(151_353, 100_000) && *kappa.hi() < ratio(151_355, 100_000));
    /// ```
    #[must_use]
    pub fn cost(&self, width: &BigRational) -> Option<Interval<BigRational>> {
        self.cost_with(&self.mean_delay(), &BigRational::zero(), width)
    }

    /// The same with another mean delay, and the variance off by `error`, down to zero.
    pub(crate) fn cost_with(
        &self,
        mean_delay: &BigRational,
        error: &BigRational,
        width: &BigRational,
    ) -> Option<Interval<BigRational>> {
        let half = BigRational::one().half() + mean_delay;
        let of = |root: &BigRational| (&half + root).half();
        WIDTHS.into_iter().find_map(|bits| {
            let variance = self.variance(bits);
            let [below, above] = [variance.lo(), variance.hi()].map(|v| {
                let off = (to_wide(v) + to_wide(error)).max(Wide::zero());
                let square = from_wide(&(to_wide(&half).square() + off))?;
                Some(root(&square, bits))
            });
            let cost = Interval::hull(of(below?.lo()), of(above?.hi()));
            (cost.hi() - cost.lo() <= *width).then_some(cost)
        })
    }
}
