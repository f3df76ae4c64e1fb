//! The motion over one interval under a held force, in closed form.

use std::cmp::Ordering;

use super::{Model, Moved, Number};
use crate::real::Undecided;
use crate::series;

impl<R: Number> Model<R> {
    /// The motion over an interval under `u`, where the sign of `v` can be told.
    pub(crate) fn advance(&self, xi: &R, v: &R, u: &R) -> Result<Moved<R>, Undecided> {
        let Some(sigma) = &self.sigma else {
            let a = u.clone() / self.mu.clone();
            return Ok(self.straight(xi, v, &a));
        };
        let direction = v.sign()?;
        let friction = if direction == Ordering::Less {
            -sigma.clone()
        } else {
            sigma.clone()
        };
        let a = (u.clone() - friction) / self.mu.clone();
        if direction == Ordering::Equal {
            return self.turned(xi, v, u, &a, sigma);
        }
        let straight = self.straight(xi, v, &a);
        match straight.velocity.sign() {
            Ok(sign) if sign != direction.reverse() => Ok(straight),
            Ok(_) => self.turned(xi, v, u, &a, sigma),
            // It comes to rest at the sample, or not quite: both texts hold there.
            Err(Undecided) => {
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
            // The velocity keeps its sign, so the way is |d|; a sign that cannot be told is rounding.
            Some(sigma) => sigma.clone() * d.magnitude().unwrap_or_else(|_| d.clone()),
            None => xi.zero(),
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
        let one = xi.one();
        let at_rest = v.sign()? == Ordering::Equal;
        let r = if at_rest {
            xi.zero()
        } else {
            -(v.clone() / a.clone())
        };
        let onward = match u.magnitude()?.compare(sigma)? {
            Ordering::Greater if u.sign()? == Ordering::Less => u.clone() + sigma.clone(),
            Ordering::Greater => u.clone() - sigma.clone(),
            _ => xi.zero(),
        } / self.mu.clone();
        let half = xi.ratio(1, 2);
        let third = xi.ratio(1, 3);
        // f, f²H, f³K of the way on, and rH, rK of the way to the stop.
        let (f, second, cubed, first, stopping) = if self.beta.is_none() {
            let f = one - r.clone();
            let square = f.clone() * f.clone();
            let cubed = square.clone() * f.clone() * third.clone();
            (f, square * half.clone(), cubed, r.clone() * half, r * third)
        } else {
            self.ways(&r)
        };
        let d = v.clone() * first;
        let then = onward.clone() * second;
        let way = d.magnitude().unwrap_or_else(|_| d.clone())
            + then.magnitude().unwrap_or_else(|_| then.clone());
        let mut dissipated = sigma.clone() * way;
        if let Some(beta) = &self.beta {
            let square = v.clone() * v.clone() * stopping + onward.clone() * onward.clone() * cubed;
            dissipated = dissipated + beta.clone() * square;
        }
        Ok(Moved {
            xi: xi.clone() + d + then,
            velocity: onward * f,
            dissipated,
        })
    }

    /// f, f²H(λf), f³K(λf), rH(−λr) and rK(−λr) for a stop after the time of r.
    fn ways(&self, r: &R) -> (R, R, R, R, R) {
        let lambda = &self.lambda;
        let w = lambda.clone() * r.clone();
        let minus = -w.clone();
        let first = r.clone() * series::h(&minus);
        let stopping = r.clone() * series::k(&minus);
        let f = self.whole.phi1.clone() - self.whole.decay.clone() * r.clone();
        let x = lambda.clone() * f.clone();
        if x.approximate() <= 0.5 {
            let square = f.clone() * f.clone();
            let second = square.clone() * series::h(&x);
            let cubed = square * f.clone() * series::k(&x);
            return (f, second, cubed, first, stopping);
        }
        // λf near 1 leaves nothing of 1 − λf: go by the time that is left instead.
        let rest = r.one() - series::ln_1p(&w) / lambda.clone();
        let (phi1, phi2) = series::phi(&(lambda.clone() * rest.clone()));
        let f = rest.clone() * phi1;
        let second = rest.clone() * rest * phi2;
        let half_square = f.clone() * f.clone() * r.ratio(1, 2);
        let cubed = (second.clone() - half_square) / lambda.clone();
        (f, second, cubed, first, stopping)
    }
}
