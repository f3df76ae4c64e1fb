//! The controller: from the positions at the samples to the force that is held (5).
//!
//! One text for every loop. The position is measured, through an encoder if there is one; a linear
//! digital filter makes a force of the samples known so far; outside a one-sided wall the force is
//! zero; the D/A converter rounds it and the actuator limits it; and it leaves k samples late.
//! Whatever computes a held force calls this text, or is tested against it.
//!
//! To delay the force by whole samples is to delay the samples, because nothing in between knows
//! the time. So the samples are what is remembered.

use alloc::collections::VecDeque;
use alloc::vec;
use alloc::vec::Vec;

use crate::parameter::Loop;
use crate::quantizer::Quantized;
use crate::rational;
use crate::scalar::Scalar;

/// A linear digital filter H(z) = c₀ + c₁z⁻¹ + c₂z⁻² + …, in units of the stiffness.
///
/// Kept as the sum H(1) = c₀ + c₁ + … and the tail sums gⱼ = cⱼ + cⱼ₊₁ + …, because
/// Σ cⱼqⱼ = H(1)·q₀ + Σ gⱼ(qⱼ − qⱼ₋₁), where q₀ is the present sample and qⱼ the one j before it: a
/// wall is a multiple of the position, and all else is made of displacements, which is how energy
/// is accounted for (TH-DAMP).
///
/// A response that does not end has a denominator 1 + r₁z⁻¹ + r₂z⁻² + …, and its tail sums are the
/// response of t₁z⁻¹ + t₂z⁻² + … over it (TH-LTI). The output is then H(1)·q + y, where y follows
/// from its own past: yₕ = Σ tⱼ(qₕ₋ⱼ − qₕ₋ⱼ₊₁) − Σ rᵢyₕ₋ᵢ. Without a denominator tⱼ is gⱼ.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, controller::Filter};
///
/// // A wall with virtual damping B = 2: 1 + 2(1 − z⁻¹).
/// let filter = Filter::damped(&Fixed::integer(2));
/// let [now, before] = [Fixed::integer(5), Fixed::integer(4)];
/// assert_eq!(filter.output(&[now, before]), Fixed::integer(7));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Filter<S> {
    /// H(1).
    pub sum: S,
    /// tⱼ for j = 1, 2, …, the tail sums gⱼ where there are no `poles`.
    pub tails: Vec<S>,
    /// r₁, r₂, …, the coefficients of z⁻¹, z⁻², … in the denominator over its first one; empty for
    /// a response that ends.
    pub poles: Vec<S>,
}

impl<S: Scalar> Filter<S> {
    /// The wall alone, H(z) = 1.
    #[must_use]
    pub fn wall() -> Self {
        Self {
            sum: S::one(),
            tails: Vec::new(),
            poles: Vec::new(),
        }
    }

    /// The wall with virtual damping by backward difference, H(z) = 1 + B(1 − z⁻¹); B in KT.
    #[must_use]
    pub fn damped(damping: &S) -> Self {
        Self {
            sum: S::one(),
            tails: vec![-damping.clone()],
            poles: Vec::new(),
        }
    }

    /// The wall with virtual damping behind a one-pole filter,
    /// H(z) = 1 + B(1 − z⁻¹)(1 − a)/(1 − az⁻¹); B in KT, `pole` is a.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Scalar, controller::Filter};
    ///
    /// let filter = Filter::filtered_damping(&Fixed::integer(2), &Fixed::new(1, 2));
    /// // After a step from 0 to 1 the damper gives 2·½, and then half as much each sample.
    /// let [zero, one] = [0, 1].map(Fixed::integer);
    /// assert_eq!(filter.output(&[one, zero]), Fixed::integer(2));
    /// assert_eq!(filter.output(&[one, one, zero]), Fixed::new(3, 2));
    /// ```
    #[must_use]
    pub fn filtered_damping(damping: &S, pole: &S) -> Self {
        Self {
            sum: S::one(),
            tails: vec![-(damping.clone() * (S::one() - pole.clone()))],
            poles: vec![-pole.clone()],
        }
    }

    /// The filter of a dimensionless loop: its controller, or the wall with its virtual damping.
    #[must_use]
    pub fn of(dimensionless: &Loop<S>) -> Self {
        let time_constant = &dimensionless.damping_time_constant;
        match (&dimensionless.controller, &dimensionless.damping) {
            (Some(controller), _) => controller.recursion().map(rational::to_scalar),
            (None, Some(damping)) => match time_constant {
                Some(tau) => {
                    let pole = tau.clone().over(S::one() + tau.clone());
                    Self::filtered_damping(damping, &pole)
                }
                None => Self::damped(damping),
            },
            (None, None) => Self::wall(),
        }
    }

    /// Whether the output depends on finitely many samples.
    #[must_use]
    pub fn ends(&self) -> bool {
        self.poles.is_empty()
    }

    /// How many samples before the present one the next output is made of, beside its own past.
    #[must_use]
    pub fn order(&self) -> usize {
        self.tails.len()
    }

    /// The output at a sample; `samples` are the present one and those before it, the latest first.
    ///
    /// Before the oldest of them the device is taken to have rested where it is; no samples at all
    /// give zero.
    #[must_use]
    pub fn output(&self, samples: &[S]) -> S {
        // What a response that does not end remembers of the past builds up from the oldest sample.
        let oldest = if self.ends() {
            0
        } else {
            samples.len().saturating_sub(1)
        };
        let mut past = VecDeque::new();
        let outputs = (0..=oldest)
            .rev()
            .map(|later| self.next(samples.get(later..).unwrap_or_default(), &mut past));
        outputs.last().unwrap_or_else(S::zero)
    }

    /// The output at the next sample; `samples` are as many as the [`order`](Self::order) and one
    /// more, the latest first, and `past` holds y of the samples before, the latest first, and is
    /// brought up to date.
    ///
    /// What `past` does not hold is zero: that of a device at rest.
    #[must_use]
    pub fn next(&self, samples: &[S], past: &mut VecDeque<S>) -> S {
        let Some(now) = samples.first() else {
            return S::zero();
        };
        let wall = self.sum.clone() * now.clone();
        if self.ends() {
            return self.plus_displacements(wall, samples);
        }
        let terms = self.poles.iter().zip(past.iter());
        let decayed = terms.fold(S::zero(), |y, (r, before)| y - r.clone() * before.clone());
        let y = self.plus_displacements(decayed, samples);
        past.push_front(y.clone());
        past.truncate(self.poles.len());
        wall + y
    }

    /// `start` + Σ tⱼ(qⱼ − qⱼ₋₁).
    fn plus_displacements(&self, start: S, samples: &[S]) -> S {
        let displacements = samples.windows(2).filter_map(|pair| match pair {
            [later, earlier] => Some(earlier.clone() - later.clone()),
            _ => None,
        });
        let remembered = self.tails.iter().zip(displacements);
        remembered.fold(start, |sum, (tail, d)| sum + tail.clone() * d)
    }
}

impl<S> Filter<S> {
    /// The same filter in other numbers.
    pub fn map<U>(&self, f: impl Fn(&S) -> U) -> Filter<U> {
        Filter {
            sum: f(&self.sum),
            tails: self.tails.iter().map(&f).collect(),
            poles: self.poles.iter().map(&f).collect(),
        }
    }
}

/// A controller, compiled from a dimensionless [`Loop`]; forces in KΔ, positions in ticks.
///
/// # Example
///
/// A one-sided wall with virtual damping B = 1, entered at one tick a sample.
///
/// ```
/// use passivity_core::{Fixed, Friction, Loop, Scalar, controller::Controller};
///
/// let friction = Friction::new(Fixed::integer(2), Fixed::integer(2));
/// let damped = Loop { damping: Some(Fixed::integer(1)), unilateral: true, ..Loop::plain(friction) };
/// let controller = Controller::of(&damped);
/// let mut memory = controller.at_rest(&Fixed::integer(-1));
/// let forces = [-1, 0, 1].map(|xi| controller.sample(&mut memory, &Fixed::integer(xi)));
/// assert_eq!(forces, [Fixed::integer(0), Fixed::new(-3, 2), Fixed::new(-5, 2)]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Controller<S> {
    /// Whether the position is measured through an encoder.
    pub encoder: bool,
    /// k, in samples (TH-DELAY).
    pub delay: usize,
    /// The linear digital filter.
    pub filter: Filter<S>,
    /// Whether the wall is ξ ≥ 0 only (TH-UNI).
    pub unilateral: bool,
    /// δ of the D/A converter as a quotient (TH-DAC). Two whole numbers let every kind of number
    /// see a force that lies half-way between two steps as such.
    pub force_step: Option<[S; 2]>,
    /// The largest force of the actuator (TH-LAW).
    pub max_force: Option<S>,
}

/// What a controller remembers from sample to sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Memory<S> {
    /// Measured positions, the latest first.
    pub samples: VecDeque<S>,
    /// y of a filter whose response does not end, at the latest sample that reached the filter and
    /// those before it, the latest first.
    pub past: VecDeque<S>,
}

impl<S: Scalar> Controller<S> {
    /// The controller of a dimensionless loop.
    #[must_use]
    pub fn of(dimensionless: &Loop<S>) -> Self {
        let step = dimensionless.force_step.as_ref();
        Self {
            encoder: dimensionless.has_encoder(),
            delay: usize::from(dimensionless.delay),
            filter: Filter::of(dimensionless),
            unilateral: dimensionless.unilateral,
            force_step: step.map(|delta| [delta.clone(), S::one()]),
            max_force: dimensionless.max_force.clone(),
        }
    }

    /// How many samples before the present one the controller remembers.
    ///
    /// The held force depends on no others, unless the filter's response does not end.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.delay.saturating_add(self.filter.order())
    }

    /// The position that the filter is given for ξ: the middle of its tick (5), or ξ itself.
    #[must_use]
    pub fn measured(&self, xi: &S) -> S {
        if self.encoder {
            Quantized::of(xi).measured()
        } else {
            xi.clone()
        }
    }

    /// The force held from the present sample on; `samples` are measured positions, the present
    /// one first and those before it after it.
    ///
    /// Before the oldest of them the device is taken to have rested where it is.
    #[must_use]
    pub fn held_force(&self, samples: &[S]) -> S {
        let known = self.known(samples);
        self.applied(&self.filter.output(known), known)
    }

    /// The samples that have reached the filter.
    fn known<'a>(&self, samples: &'a [S]) -> &'a [S] {
        // With fewer samples than the delay the oldest one is what has rested there for ever.
        let oldest = samples.len().saturating_sub(1);
        samples.get(self.delay.min(oldest)..).unwrap_or_default()
    }

    /// The filter's output as it is applied: gated, negated, rounded and limited; `samples` are the
    /// measured positions that it was made of, the latest first.
    #[must_use]
    pub fn applied(&self, output: &S, samples: &[S]) -> S {
        let mut force = output.clone();
        if let (true, Some(q)) = (self.unilateral, samples.first()) {
            force = force * inside(q);
        }
        let mut held = -force;
        if let Some([numerator, denominator]) = &self.force_step {
            held = rounded(&held, numerator, denominator);
        }
        match &self.max_force {
            Some(limit) => held.min(limit.clone()).max(-limit.clone()),
            None => held,
        }
    }

    /// What the controller remembers when the device has rested at ξ for ever.
    #[must_use]
    pub fn at_rest(&self, xi: &S) -> Memory<S> {
        Memory {
            samples: core::iter::repeat_n(self.measured(xi), self.memory()).collect(),
            past: core::iter::repeat_n(S::zero(), self.filter.poles.len()).collect(),
        }
    }

    /// Takes a sample at ξ and gives the force that is held from now on.
    #[must_use]
    pub fn sample(&self, memory: &mut Memory<S>, xi: &S) -> S {
        let Memory { samples, past } = memory;
        samples.push_front(self.measured(xi));
        let known = self.known(samples.make_contiguous());
        let held = self.applied(&self.filter.next(known, past), known);
        samples.truncate(self.memory());
        held
    }

    /// The force held once the device has rested for ever where it is measured at `q`.
    #[must_use]
    pub fn settled(&self, q: &S) -> S {
        self.held_force(core::slice::from_ref(q))
    }

    /// The same controller in other numbers; the two of `force_step` are taken through `f` as well.
    pub fn map<U>(&self, f: impl Fn(&S) -> U) -> Controller<U> {
        Controller {
            encoder: self.encoder,
            delay: self.delay,
            filter: self.filter.map(&f),
            unilateral: self.unilateral,
            force_step: self.force_step.as_ref().map(|step| step.each_ref().map(&f)),
            max_force: self.max_force.as_ref().map(&f),
        }
    }
}

/// 1 where the measured position q is inside the wall q ≥ 0, and 0 outside, without a branch.
fn inside<S: Scalar>(q: &S) -> S {
    // Clamped first, so that the floor is that of a number between −1 and 0 only.
    q.clone().max(-S::one()).min(S::zero()).floor() + S::one()
}

/// The force rounded to whole steps δ = n/d of a D/A converter, δ·⌊u/δ + ½⌋ (TH-DAC).
///
/// Off by at most ½δ, so it adds at most ½δ|d| to what a step generates. δ > 0.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, controller::rounded};
///
/// let [one, two] = [1, 2].map(Fixed::integer);
/// assert_eq!(rounded(&Fixed::new(7, 4), &one, &two), two);
/// ```
#[must_use]
pub fn rounded<S: Scalar>(force: &S, numerator: &S, denominator: &S) -> S {
    let steps = (force.clone() * denominator.clone()).over(numerator.clone());
    ((steps + S::one().half()).floor() * numerator.clone()).over(denominator.clone())
}
