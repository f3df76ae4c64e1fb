//! The motion over one interval under a held force, in closed form, for any [`Real`].
//!
//! [`crate::motion`] explains the formulas; here they are written plainly.

use std::cmp::Ordering;

use passivity_core::Loop;

use crate::number::{Real, Undecided};
use crate::series::{self, Functions};

/// The device and its friction.
#[derive(Clone, Debug)]
pub(super) struct Motion<R> {
    mu: R,
    /// β, when there is viscous friction and it is not zero.
    beta: Option<R>,
    sigma: Option<R>,
    lambda: R,
    whole: Functions<R>,
}

/// Where an interval led.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Moved<R> {
    /// ξ at the end.
    pub(super) xi: R,
    /// ξ̇ at the end.
    pub(super) velocity: R,
    /// E_d.
    pub(super) dissipated: R,
}

/// What the way after a stop and the way to it depend on.
struct Ways<R> {
    /// f, the speed at the end over the acceleration from rest.
    f: R,
    /// f²H(λf).
    second: R,
    /// f³K(λf).
    cubed: R,
    /// rH(−λr).
    first: R,
    /// rK(−λr).
    stopping: R,
}

impl<R: Real> Motion<R> {
    /// The motion of a device of mass `mu` with the frictions of a dimensionless loop.
    pub(super) fn new(mu: R, dimensionless: &Loop<R>) -> Self {
        let beta = dimensionless.viscous.clone();
        let beta = beta.filter(|beta| beta.sign() != Some(Ordering::Equal));
        let lambda = match &beta {
            Some(beta) => beta.clone().over(mu.clone()),
            None => R::zero(),
        };
        let whole = if beta.is_some() {
            series::functions(&lambda)
        } else {
            Functions {
                decay: R::one(),
                phi1: R::one(),
                phi2: R::one().half(),
                double: R::one(),
                chi: mu.ratio(1, 3),
            }
        };
        Self {
            mu,
            beta,
            sigma: dimensionless.coulomb.clone(),
            lambda,
            whole,
        }
    }

    /// μ.
    pub(super) const fn mass(&self) -> &R {
        &self.mu
    }

    /// The motion over an interval under the force `u`.
    ///
    /// ξ and ξ̇ at the end grow with ξ̇ at the start, because motions under the same force do not
    /// cross: the ends of an enclosed ξ̇ lead to the ends of what comes out. So each is followed by
    /// itself, where every sign is known, and nothing widens but by rounding and by the motion.
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the number cannot tell whether the device moves.
    pub(super) fn over(&self, xi: &R, v: &R, u: &R) -> Result<Moved<R>, Undecided> {
        let Some([low, high]) = v.ends() else {
            return self.advance(xi, v, u);
        };
        let (low, high) = (
            self.advance(&R::zero(), &low, u)?,
            self.advance(&R::zero(), &high, u)?,
        );
        let d = low.xi.join(high.xi);
        let velocity = low.velocity.join(high.velocity);
        // What friction took is not monotone, but it is what the balance leaves over.
        let kinetic = (self.mu.clone() * (velocity.square() - v.square())).half();
        let has_friction = self.sigma.is_some() || self.beta.is_some();
        let left = has_friction.then(|| u.clone() * d.clone() - kinetic);
        Ok(Moved {
            dissipated: left.map_or_else(R::zero, |left| left.max(R::zero())),
            xi: xi.clone() + d,
            velocity,
        })
    }

    /// The motion over an interval, where the sign of `v` can be told.
    fn advance(&self, xi: &R, v: &R, u: &R) -> Result<Moved<R>, Undecided> {
        let Some(sigma) = &self.sigma else {
            let a = u.clone().over(self.mu.clone());
            return Ok(self.straight(xi, v, &a));
        };
        let direction = v.sign().ok_or(Undecided)?;
        let friction = if direction == Ordering::Less {
            -sigma.clone()
        } else {
            sigma.clone()
        };
        let a = (u.clone() - friction).over(self.mu.clone());
        if direction == Ordering::Equal {
            return self.turned(xi, v, u, &a, sigma);
        }
        let straight = self.straight(xi, v, &a);
        match straight.velocity.sign() {
            Some(sign) if sign != direction.reverse() => Ok(straight),
            Some(_) => self.turned(xi, v, u, &a, sigma),
            // It comes to rest at the sample, or not quite: both texts hold there.
            None => {
                let turned = self.turned(xi, v, u, &a, sigma)?;
                Ok(Moved {
                    xi: straight.xi.join(turned.xi),
                    velocity: straight.velocity.join(turned.velocity),
                    dissipated: straight.dissipated.join(turned.dissipated),
                })
            }
        }
    }

    /// No reversal, acceleration `a` at rest.
    fn straight(&self, xi: &R, v: &R, a: &R) -> Moved<R> {
        let k = &self.whole;
        let d = k.phi1.clone() * v.clone() + k.phi2.clone() * a.clone();
        let velocity = k.decay.clone() * v.clone() + k.phi1.clone() * a.clone();
        let mut dissipated = match &self.sigma {
            // The velocity keeps its sign, so the way is |d|.
            Some(sigma) => sigma.clone() * d.abs(),
            None => R::zero(),
        };
        if let Some(beta) = &self.beta {
            let square = k.double.clone() * v.clone() * v.clone()
                + k.phi1.clone() * k.phi1.clone() * v.clone() * a.clone()
                + k.chi.clone() * a.clone() * a.clone();
            dissipated = dissipated + beta.clone() * square;
        }
        Moved {
            xi: xi.clone() + d,
            velocity,
            dissipated,
        }
    }

    /// A reversal, or a stop, or a start from rest; `a` is the acceleration before it.
    fn turned(&self, xi: &R, v: &R, u: &R, a: &R, sigma: &R) -> Result<Moved<R>, Undecided> {
        let r = if v.sign().ok_or(Undecided)? == Ordering::Equal {
            R::zero()
        } else {
            -(v.clone().over(a.clone()))
        };
        let ways = self.ways(&r);
        let onward = self.onward(u, sigma)?;
        let d = v.clone() * ways.first;
        let then = onward.clone() * ways.second;
        let mut dissipated = sigma.clone() * (d.abs() + then.abs());
        if let Some(beta) = &self.beta {
            let square = v.clone() * v.clone() * ways.stopping
                + onward.clone() * onward.clone() * ways.cubed;
            dissipated = dissipated + beta.clone() * square;
        }
        Ok(Moved {
            xi: xi.clone() + d + then,
            velocity: onward * ways.f,
            dissipated,
        })
    }

    /// The acceleration from rest: 0 while friction takes the force.
    fn onward(&self, u: &R, sigma: &R) -> Result<R, Undecided> {
        let excess = match u.abs().compare(sigma).ok_or(Undecided)? {
            Ordering::Greater if u.sign().ok_or(Undecided)? == Ordering::Less => {
                u.clone() + sigma.clone()
            }
            Ordering::Greater => u.clone() - sigma.clone(),
            _ => R::zero(),
        };
        Ok(excess.over(self.mu.clone()))
    }

    /// The ways for a stop after the time of r.
    fn ways(&self, r: &R) -> Ways<R> {
        if self.beta.is_none() {
            let third = self.mu.ratio(1, 3);
            let f = R::one() - r.clone();
            let square = f.square();
            return Ways {
                cubed: square.clone() * f.clone() * third.clone(),
                second: square.half(),
                first: r.clone().half(),
                stopping: r.clone() * third,
                f,
            };
        }
        let lambda = &self.lambda;
        let w = lambda.clone() * r.clone();
        let minus = -w.clone();
        let first = r.clone() * series::h(&minus);
        let stopping = r.clone() * series::k(&minus);
        let f = self.whole.phi1.clone() - self.whole.decay.clone() * r.clone();
        let x = lambda.clone() * f.clone();
        if x.approximate() <= 0.5 {
            let square = f.square();
            return Ways {
                second: square.clone() * series::h(&x),
                cubed: square * f.clone() * series::k(&x),
                f,
                first,
                stopping,
            };
        }
        // λf near 1 leaves nothing of 1 − λf: go by the time that is left instead.
        let rest = R::one() - series::ln_1p(&w).over(lambda.clone());
        let (phi1, phi2) = series::phi(&(lambda.clone() * rest.clone()));
        let f = rest.clone() * phi1;
        let second = rest.square() * phi2;
        let half_square = f.square().half();
        Ways {
            cubed: (second.clone() - half_square).over(lambda.clone()),
            second,
            f,
            first,
            stopping,
        }
    }
}
