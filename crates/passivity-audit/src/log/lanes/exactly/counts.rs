//! The same of rows between counts: their figures at the least and at the most, from the corners of what the counts leave
//! room for.
//!
//! With the force f = p/2P beyond that of the wall in the middle of the tick, the work u(f + ½(u − 1)) is a whole number
//! over 2P at whole ticks u, and where the wall balances the force it is −(P − p)²/8P². Where net energy is extreme between
//! the corners, which doubles tell, it is where a parabola [turns](turns).

mod row;
mod turns;

use num_bigint::BigInt;
use num_traits::ToPrimitive as _;
use passivity_core::{BigRational, Friction as OfLoop, Loop, Scalar as _};

use super::super::Length;
use super::constants::{Constants, Part, parts};
use super::{Sum, unit_of};
use crate::ball::Ball;
use crate::log::chunk::{Chunk, Samples};
use crate::log::numbers::{Readings, Unit};
use crate::log::task::Task;
use crate::number::{Factored, Primes};
use turns::Turns;

/// What friction at one of its ends makes of a row, over the length of the interval where it is viscous.
#[derive(Clone, Debug)]
struct Friction {
    viscous: u128,
    /// Of d² and of |d| times the length.
    taken: Sum<2>,
    /// Of these and of what is generated over 2P, and over the denominators where the force of the wall is the least and the
    /// largest.
    net: [Sum<3>; 3],
    /// Of |d| and the length, over |d|; and the numerator of the second, whose sign says where the margin is least.
    margin: (Sum<2>, i128),
    turns: Option<Turns>,
    near: OfLoop<Ball>,
}

/// What is the same in all rows between the counts of a log.
#[derive(Clone, Debug)]
pub(in super::super) struct Counts {
    of: (Option<Unit>, i64),
    primes: Primes,
    /// The numerator of the unit of a force, and its denominator P.
    force: (i64, i64, Factored),
    over: [Factored; 2],
    lasts: Factored,
    parts: [Option<Part>; 3],
    flat: [Flat; 2],
    frictions: (Friction, Option<Friction>),
}

/// Where the force of the wall is the least, or the largest.
#[derive(Clone, Debug)]
struct Flat {
    /// What a force in the log and that of the wall are times the denominator.
    unit: i64,
    limit: i64,
    over: Factored,
    denominator: i64,
}

impl Counts {
    /// As [`Exactly::find`](super::Exactly::find).
    pub(in super::super) fn find(
        task: &Task<'_>,
        chunk: &Chunk,
        lengths: &[Length],
        before: Option<Self>,
    ) -> Option<Self> {
        let Samples::Counts(_) = &chunk.samples else {
            return None;
        };
        let forces = task.applied.then_some(&chunk.forces.values);
        let of = (
            unit_of(forces)?,
            lengths.iter().map(|Length(_, d)| *d).max()?,
        );
        match before {
            Some(before) if before.of == of => Some(before),
            _ => Self::of(task, of, forces),
        }
    }

    fn of(task: &Task<'_>, of: (Option<Unit>, i64), forces: Option<&Readings>) -> Option<Self> {
        let given = Constants::of(task, (forces, of.0), of.1)?;
        let primes = Primes::of(&given.denominators())?;
        let force = given.force.clone().unwrap_or_else(BigRational::zero);
        let p = force.denom();
        let over = |d: &BigInt| BigRational::new((-1).into(), d.clone());
        let (twice, eightfold) = (p * 2, p * p * 8);
        let flat = given.limits.each_ref().map(|limit| {
            let limit = match (limit, &given.force) {
                (Some(limit), Some(_)) => limit.clone(),
                // The wall's own force does no more work than the wall takes up.
                _ => BigRational::zero(),
            };
            let d = num_integer::lcm(p.clone(), limit.denom().clone());
            let times = |x: &BigRational| (x.numer() * (&d / x.denom())).to_i64();
            let flat = Flat {
                unit: times(&force)?,
                limit: times(&limit)?,
                over: primes.factored(&d)?,
                denominator: d.to_i64()?,
            };
            Some((flat, d))
        });
        let [(lower, below), (upper, above)] = {
            let [a, b] = flat;
            [a?, b?]
        };
        let friction = |end: usize, near: &Loop<Ball>| {
            let ([beta, sigma], [viscous, coulomb]) =
                (given.frictions.get(end)?, given.criteria.get(end)?);
            let beta = beta * &given.lasts;
            let net = |d: &BigInt| Sum::of(&primes, [&beta, sigma, &over(d)]);
            let over_distance = coulomb / &given.lasts;
            let net = [net(&twice)?, net(&below)?, net(&above)?];
            Some(Friction {
                turns: Turns::of(&beta, &net),
                viscous: beta.numer().to_u128()?,
                taken: Sum::of(&primes, [&beta, sigma])?,
                net,
                margin: (
                    Sum::of(&primes, [viscous, &over_distance])?,
                    over_distance.numer().to_i128()?,
                ),
                near: OfLoop::new(near.viscous_friction(), near.coulomb_friction()),
            })
        };
        let near = task.ledger.near();
        Some(Self {
            of,
            force: (force.numer().to_i64()?, p.to_i64()?, primes.factored(p)?),
            over: [primes.factored(&twice)?, primes.factored(&eightfold)?],
            lasts: primes.factored(given.lasts.numer())?,
            parts: parts(&given.limits, &BigInt::from(1)),
            flat: [lower, upper],
            frictions: (
                friction(0, &near.least)?,
                match given.friction_is_exact {
                    true => None,
                    false => Some(friction(1, &near.most)?),
                },
            ),
            primes,
        })
    }
}
