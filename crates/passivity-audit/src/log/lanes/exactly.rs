//! Rows of known positions that are written, as fractions in lowest terms.
//!
//! Positions and forces of rational scales are whole numbers of the log times a factor, so that each figure of a row on one
//! part of a wall is a sum of few products of such numbers, each times a factor that is the same for the whole log. Over
//! one denominator these are sums of whole numbers, and the primes of the denominator are known. Only the length of an
//! interval, and the distance in the margin, are denominators that change from row to row. A row whose sums 128 bits do not
//! hold, as where numbers are doubles, is computed with whole numbers over powers of two: of 128 bits with sums of 256, or
//! of 256 bits throughout. What these do not hold is left open, and so is a motion that does not stay on one part of the
//! wall.

mod constants;
mod counts;
mod row;

use constants::{Constants, Part, parts};
pub(super) use counts::Counts;

use std::ops::Range;

use ethnum::I256;
use num_bigint::BigInt;
use num_traits::{Signed as _, ToPrimitive as _};
use passivity_core::{BigRational, Scalar as _};

use super::Length;
use crate::log::chunk::{Chunk, Samples};
use crate::log::numbers::{Read, Readings, Unit};
use crate::log::task::Task;
use crate::number::{Dyadic, Factored, Line, Primes};
use crate::rows::Form;

/// How the forces are written that the account is of.
fn unit_of(forces: Option<&Readings>) -> Option<Option<Unit>> {
    match forces {
        Some(forces) => Some(Some(forces.written.unit()?)),
        None => Some(None),
    }
}

/// The force of the interval that starts at sample `i`, in its unit.
#[inline(always)]
fn force_at<T: Read>(forces: Option<&Readings>, unit: Option<Unit>, i: usize) -> Option<Option<T>> {
    match forces.zip(unit) {
        Some((forces, unit)) => Some(Some(T::read(&forces.written, i, unit)?)),
        None => Some(None),
    }
}

/// The samples and the forces of a log, and at which sample an interval starts.
pub(super) type Row<'a, S> = (&'a S, Option<&'a Readings>, usize);

/// The row that was written last, whose end is where the next one starts.
pub(super) struct Latest {
    pub(super) text: [u8; Line::ROOM],
    /// Where in the text the position at its end is, with its comma: nowhere if no row was written just before.
    pub(super) end: Range<usize>,
}

impl Latest {
    pub(super) const fn new() -> Self {
        Self {
            text: [0; Line::ROOM],
            end: 0..0,
        }
    }

    /// Begins the next row with the position at the end of the last one, if there is one: how long that is.
    #[inline(always)]
    pub(super) fn begin(&mut self) -> usize {
        let end = std::mem::take(&mut self.end);
        let known = end.len();
        self.text.copy_within(end, 0);
        known
    }
}

/// Writes where an interval starts, unless the line has that already, and where it ends: where on the line that is.
#[inline(always)]
fn write_ends<P>(
    [start, end]: [P; 2],
    line: &mut Line<'_>,
    write: impl Fn(P, &mut Line<'_>) -> Option<()>,
) -> Option<Range<usize>> {
    if line.len() == 0 {
        write(start, line)?;
    }
    let from = line.len();
    write(end, line)?;
    Some(from..line.len())
}

/// What writes rows as they are exactly.
pub(super) trait Written {
    /// Where the samples of the log are.
    type Samples: ?Sized;

    /// Whether numbers of a row are added up before they are multiplied, for which 128 bits may be too short where they
    /// differ much in size.
    const MAY_BE_LONG: bool;

    /// Writes a row in numbers of this kind, on a line that may have the position at its start already: where on that the
    /// position at its end is; `None` where these numbers are too short, or it is left open.
    fn write_as<T: Read>(
        &self,
        row: Row<'_, Self::Samples>,
        length: Length,
        form: Form,
        line: &mut Line<'_>,
    ) -> Option<Range<usize>>;

    /// The same, on its own, where so much of the line was written before: of numbers that are longer than the machine's.
    #[inline(never)]
    fn write_widely<T: Read>(
        &self,
        row: Row<'_, Self::Samples>,
        length: Length,
        form: Form,
        (line, known): (&mut Line<'_>, usize),
    ) -> Option<Range<usize>> {
        line.truncate(known);
        self.write_as::<T>(row, length, form, line)
    }

    /// Writes the row of an interval that lasts so long, and that starts where the one of the last call ended; nothing, and
    /// `None`, where it is left open.
    fn write(
        &self,
        row: Row<'_, Self::Samples>,
        length: Length,
        form: Form,
        (latest, out): (&mut Latest, &mut Vec<u8>),
    ) -> Option<()> {
        let known = latest.begin();
        let line = &mut Line::new(&mut latest.text, known);
        let mut end = self.write_as::<i64>(row, length, form, line);
        if end.is_none() {
            end = self.write_widely::<Dyadic<i128>>(row, length, form, (line, known));
        }
        if end.is_none() && Self::MAY_BE_LONG {
            end = self.write_widely::<Dyadic<I256>>(row, length, form, (line, known));
        }
        let end = end?;
        out.extend_from_slice(line.text());
        latest.end = end;
        Some(())
    }
}

/// A length over this one number; `None` where it is not.
#[inline(always)]
fn lasts_over(Length(n, d): Length, over: i64) -> Option<i64> {
    if n <= 0 || d <= 0 || over % d != 0 {
        return None;
    }
    n.checked_mul(over / d)
}

/// Products that are summed up, over their common denominator.
#[derive(Clone, Debug)]
struct Sum<const N: usize> {
    factors: [i128; N],
    over: Factored,
}

impl<const N: usize> Sum<N> {
    fn of(primes: &Primes, factors: [&BigRational; N]) -> Option<Self> {
        let denominators = factors.iter().map(|x| x.denom());
        let over = denominators.fold(BigInt::from(1), |all, d| num_integer::lcm(all, d.clone()));
        let over_common = |x: &BigRational| (x.numer() * (&over / x.denom())).to_i128();
        let mut whole = [0; N];
        for (whole, x) in whole.iter_mut().zip(factors) {
            *whole = over_common(x)?;
        }
        Some(Self {
            factors: whole,
            over: primes.factored(&over)?,
        })
    }
}

/// What friction at one of its ends makes of a row. Energies are over the length of the interval, where friction is viscous.
#[derive(Clone, Debug)]
struct Friction {
    /// The numerator of viscous friction, with which the length of an interval may have something in common; zero for
    /// none.
    viscous: u128,
    /// Of d² and of |d| times the length.
    taken: Sum<2>,
    /// On each [part](Part) of the wall: of the same, and of what is generated, against the wall and against its
    /// quantized form.
    net: [[Sum<4>; 2]; 3],
    /// Of |d| and the length, over |d|; and the numerator of the second.
    margin: (Sum<2>, u128),
}

/// What is the same in all rows of a log, as far as its numbers are written alike.
#[derive(Clone, Debug)]
pub(super) struct Exactly {
    /// How positions and forces are written, and over what lengths are.
    of: (Unit, Option<Unit>, i64),
    primes: Primes,
    /// Ticks per unit of a position, and KΔ per unit of a force.
    position: (i64, i64, Factored),
    force: (i64, Factored),
    lasts: Factored,
    /// Linear, and where the force is the least and the largest.
    parts: [Option<Part>; 3],
    /// What is generated, on each part, against the wall and against its quantized form.
    generated: [[Sum<2>; 2]; 3],
    /// Of d² and |d|.
    bound_22: Sum<2>,
    /// Of one whole number.
    bound_quantized: Factored,
    /// Of the least friction and of the most, where that is another.
    frictions: (Friction, Option<Friction>),
}

impl Exactly {
    /// Of a chunk of a log at a plain wall, given what was found of another one; `None` where positions or forces have
    /// π in them.
    pub(super) fn find(
        task: &Task<'_>,
        chunk: &Chunk,
        lengths: &[Length],
        before: Option<Self>,
    ) -> Option<Self> {
        let Samples::Any(samples) = &chunk.samples else {
            return None;
        };
        let forces = task.applied.then_some(&chunk.forces.values);
        let of = (
            samples.written.unit()?,
            unit_of(forces)?,
            lengths.iter().map(|Length(_, d)| *d).max()?,
        );
        match before {
            Some(before) if before.of == of => Some(before),
            _ => Self::of(task, of, (samples, forces)),
        }
    }

    fn of(
        task: &Task<'_>,
        of: (Unit, Option<Unit>, i64),
        (samples, forces): (&Readings, Option<&Readings>),
    ) -> Option<Self> {
        let (unit_of_position, _, _) = of;
        let given = Constants::of(task, (forces, of.1), of.2)?;
        let unit = BigRational::from_integer(unit_of_position.denominator()?.into());
        let ticks = samples.factor()? / unit;
        let mut denominators = given.denominators();
        denominators.extend([ticks.denom().clone(), ticks.numer().abs()]);
        let Constants {
            force,
            lasts,
            limits,
            ..
        } = &given;
        let primes = Primes::of(&denominators)?;
        let (half, zero) = (BigRational::one().half(), BigRational::zero());
        // What the work of the force is over d: of the force in the log, or of that of the sample's tick.
        let work = match force {
            Some(force) => &ticks * force,
            None => -(&ticks * &half),
        };
        let square = &ticks * &ticks * &half;
        let potential = &half / BigRational::from_integer(ticks.denom().clone());
        let magnitude = num_traits::abs(ticks.clone());
        let flat = |limit: &Option<BigRational>| match (limit, force) {
            (Some(limit), Some(_)) => [work.clone(), limit * &ticks],
            // The wall's own force does no more work than the wall takes up.
            _ => [zero.clone(), zero.clone()],
        };
        let [lower, upper] = limits.each_ref().map(flat);
        let generated = [
            [
                [work.clone(), square.clone()],
                [work.clone(), potential.clone()],
            ],
            [lower.clone(), lower],
            [upper.clone(), upper],
        ];
        let friction = |end: usize| {
            let ([beta, sigma], [viscous, coulomb]) =
                (given.frictions.get(end)?, given.criteria.get(end)?);
            let (beta, sigma) = (beta * &ticks * &ticks * lasts, sigma * &magnitude);
            let net = |[a, b]: &[BigRational; 2]| {
                Sum::of(&primes, [&beta, &sigma, &-a.clone(), &-b.clone()])
            };
            let part =
                |[linear, quantized]: &[[BigRational; 2]; 2]| Some([net(linear)?, net(quantized)?]);
            let [a, b, c] = &generated;
            let over_distance = coulomb / (&magnitude * lasts);
            Some(Friction {
                viscous: beta.numer().to_u128()?,
                taken: Sum::of(&primes, [&beta, &sigma])?,
                net: [part(a)?, part(b)?, part(c)?],
                margin: (
                    Sum::of(&primes, [viscous, &over_distance])?,
                    over_distance.numer().abs().to_u128()?,
                ),
            })
        };
        let sum = |[a, b]: &[BigRational; 2]| Sum::of(&primes, [a, b]);
        let both =
            |[linear, quantized]: &[[BigRational; 2]; 2]| Some([sum(linear)?, sum(quantized)?]);
        let [a, b, c] = &generated;
        let q = ticks.denom();
        let force = force.clone().unwrap_or_else(BigRational::one);
        Some(Self {
            of,
            position: (ticks.numer().to_i64()?, q.to_i64()?, primes.factored(q)?),
            force: (force.numer().to_i64()?, primes.factored(force.denom())?),
            lasts: primes.factored(lasts.numer())?,
            parts: parts(limits, q),
            generated: [both(a)?, both(b)?, both(c)?],
            bound_22: Sum::of(&primes, [&square, &(&magnitude * &half)])?,
            bound_quantized: primes.factored(&(q * 2))?,
            frictions: (
                friction(0)?,
                match given.friction_is_exact {
                    true => None,
                    false => Some(friction(1)?),
                },
            ),
            primes,
        })
    }
}
