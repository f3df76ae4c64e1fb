//! The figures of one row, from the whole numbers that it is made of.

use std::ops::Range;

use passivity_core::Truth;

use super::super::Length;
use super::{Exactly, Friction, Part, Row, Sum, Written, force_at, lasts_over, write_ends};
use crate::figure::not;
use crate::ledger::Truths;
use crate::log::numbers::{Read, Readings};
use crate::number::{Beside, Exact as _, Factored, Line, Primes, Quotient, Split, Term, Total};
use crate::rows::{Figures, Form};

impl<const N: usize> Sum<N> {
    /// The numerator.
    #[inline(always)]
    pub(super) fn at<T: Term>(&self, terms: [T; N]) -> Option<T::Sum> {
        let mut sum = T::Sum::zero();
        for (factor, term) in self.factors.iter().zip(terms) {
            sum = sum.plus(term.by(*factor)?)?;
        }
        Some(sum)
    }
}

impl Written for Exactly {
    type Samples = Readings;

    const MAY_BE_LONG: bool = false;

    #[inline(always)]
    fn write_as<T: Read>(
        &self,
        (samples, forces, i): Row<'_, Readings>,
        length: Length,
        form: Form,
        line: &mut Line<'_>,
    ) -> Option<Range<usize>> {
        let (unit_of_position, unit_of_force, over) = self.of;
        let at = |i: usize| T::read(&samples.written, i, unit_of_position);
        let force = force_at(forces, unit_of_force, i)?;
        let row = Interval {
            ends: [at(i)?, at(i + 1)?],
            force,
            lasts: lasts_over(length, over)?,
        };
        let (ratio, _, q) = &self.position;
        let end = write_ends(row.ends, line, |x, line| {
            let xi = x.by((*ratio).into())?.quotient(&self.primes, q, 1)?;
            form.position([xi; 2], line)
        })?;
        let lasts = self.primes.quotient(row.lasts.into(), &self.lasts, 1)?;
        lasts.write(line)?;
        form.account(&self.figures(&row)?, line)?;
        Some(end)
    }
}

impl Exactly {
    #[inline(always)]
    fn figures<T: Term>(&self, row: &Interval<T>) -> Option<Figures<QuotientOf<T>>> {
        let [from, to] = row.ends;
        let (ratio, q, _) = self.position;
        let mut ticks = [([0; 2], 0); 2];
        let mut potentials = [T::zero(); 2];
        for ((tick, potential), x) in ticks.iter_mut().zip(&mut potentials).zip(row.ends) {
            let xi = T::from(ratio).times(x)?;
            let next_to = xi.next_to()?;
            let (n, of) = twice_quantized(xi, next_to, q)?;
            (*tick, *potential) = ((next_to, n), of);
        }
        let d = to.minus(from)?;
        let factor = match row.force {
            Some(force) => force,
            None => T::from(ticks[0].1.checked_mul(2)?.checked_add(1)?),
        };
        let work = d.times(factor)?;
        let holds = |part: &Option<Part>| part.is_some_and(|part| part.has(ticks));
        let part = self.parts.iter().position(holds)?;
        // What the wall takes up, against it and against its quantized form.
        let taken_up = match part {
            0 => [
                d.times(from.plus(to)?)?,
                potentials[1].minus(potentials[0])?,
            ],
            _ => [d; 2],
        };
        let (square, distance) = (d.times(d)?, d.size()?);
        let generated = &self.generated[part];
        let plain =
            |sum: &Sum<2>, terms: [T; 2]| sum.at(terms)?.quotient(&self.primes, &sum.over, 1);
        let bound = {
            let d = T::from(ratio).times(d)?.size()?;
            twice_quantized(d, d.next_to()?, q)?.1.plus(d)?
        };
        let split = self.primes.split(row.lasts.cast_unsigned());
        let (size, twos) = distance.size_over_twos()?;
        let moves = size > 0;
        let distances = self.primes.split(size);
        let terms = Terms {
            square,
            distance,
            size: (size, twos),
            work,
            taken_up,
            lasts: row.lasts,
        };
        let end =
            |friction: &Friction| friction.of(&self.primes, part, &terms, [&split, &distances]);
        let least = end(&self.frictions.0)?;
        let most = match &self.frictions.1 {
            Some(most) => end(most)?,
            None => least,
        };
        let both = |pick: fn(&Ends<T>) -> QuotientOf<T>| [pick(&least), pick(&most)];
        let energies = [
            [plain(&generated[0], [work, taken_up[0]])?; 2],
            [plain(&generated[1], [work, taken_up[1]])?; 2],
            [plain(&self.bound_22, [square, distance])?; 2],
            [bound
                .by(1)?
                .quotient(&self.primes, &self.bound_quantized, 1)?; 2],
            both(|end| end.taken),
            both(|end| end.net[0]),
            both(|end| end.net[1]),
        ];
        let margin @ [margin_lo, margin_hi] = both(|end| end.margin);
        let covers =
            |[lo, hi]: [QuotientOf<T>; 2]| Truth::over(!lo.is_negative(), !hi.is_negative());
        let (force, over) = &self.force;
        let force = match row.force {
            Some(f) => Some(f.by((*force).into())?.quotient(&self.primes, over, 1)?),
            None => None,
        };
        Some(Figures {
            truths: Truths {
                criterion_holds: if moves { covers(margin) } else { Truth::Holds },
                violates_linear: not(covers(energies[5])),
                violates_quantized: not(covers(energies[6])),
            },
            energies,
            margin: [moves.then_some(margin_lo), moves.then_some(margin_hi)],
            force: [force; 2],
        })
    }
}

/// What a figure made of these numbers is written as.
pub(super) type QuotientOf<T> = Quotient<<<T as Term>::Sum as Total>::Size>;

/// An interval in whole numbers, or in what doubles are.
struct Interval<T> {
    ends: [T; 2],
    force: Option<T>,
    lasts: i64,
}

/// The numbers that the figures of a row are sums of.
struct Terms<T> {
    square: T,
    distance: T,
    /// The distance, as a whole number over a power of two.
    size: (u64, u32),
    work: T,
    taken_up: [T; 2],
    lasts: i64,
}

/// What a row says at one end of friction.
#[derive(Clone, Copy)]
struct Ends<T: Term> {
    taken: QuotientOf<T>,
    net: [QuotientOf<T>; 2],
    margin: QuotientOf<T>,
}

impl Friction {
    #[inline(always)]
    fn of<T: Term>(
        &self,
        primes: &Primes,
        part: usize,
        terms: &Terms<T>,
        [lasts, distances]: [&Split; 2],
    ) -> Option<Ends<T>> {
        let Terms {
            square,
            distance,
            size: (size, twos),
            work,
            taken_up,
            lasts: n,
        } = *terms;
        let is_viscous = self.viscous != 0;
        let d = u128::from(size);
        // Of all that is over the length, the length has in common what it has with viscous friction.
        let beside = match is_viscous {
            true => lasts.beside([self.viscous, d, d]),
            false => Beside::ONE,
        };
        let n_or_one = if is_viscous { n } else { 1 };
        let over = |n: T::Sum, over: &Factored, beside: &Beside| {
            let over = over.times(&beside.known)?;
            beside.divided(n).quotient(primes, &over, beside.rest)
        };
        let over_length = |sum: T::Sum, more: T::Sum, of: &Factored| {
            over(sum.plus(more.by(n_or_one)?)?, of, &beside)
        };
        let net = |of: &Sum<4>, taken_up: T| {
            let [a, b, c, d] = of.factors;
            let more = distance.by(b)?.plus(work.by(c)?)?.plus(taken_up.by(d)?)?;
            over_length(square.by(a)?, more, &of.over)
        };
        let [a, b] = self.taken.factors;
        let [linear, quantized] = &self.net[part];
        let (margin, numerator) = &self.margin;
        let over_distance = distances.beside([*numerator, n.unsigned_abs().into(), 1]);
        let times_distance = margin.at([distance, T::from(n)])?.by_twos(twos)?;
        let margin = over(times_distance, &margin.over, &over_distance)?;
        Some(Ends {
            taken: over_length(square.by(a)?, distance.by(b)?, &self.taken.over)?,
            net: [net(linear, taken_up[0])?, net(quantized, taken_up[1])?],
            margin,
        })
    }
}

/// The tick of a position that is a q-th of ξ, and 2q times the potential of the quantized spring (16) there.
#[inline(always)]
fn twice_quantized<T: Term>(xi: T, [below, _]: [i64; 2], q: i64) -> Option<(i64, T)> {
    let n = below.div_euclid(q);
    let within = xi.minus(T::from(n.checked_mul(q)?))?;
    let up_to_tick = T::from(n.checked_mul(n)?.checked_mul(q)?);
    let twice_and_one = T::from(n.checked_mul(2)?.checked_add(1)?);
    Some((n, up_to_tick.plus(twice_and_one.times(within)?)?))
}
