//! The figures of one row, from the whole numbers that it is made of.

use passivity_core::Truth;

use super::super::Length;
use super::{Exactly, Friction, Part, Sum, force_at, lasts_over};
use crate::figure::not;
use crate::ledger::Truths;
use crate::log::numbers::Readings;
use crate::number::{Beside, Factored, Line, Primes, Quotient, Split};
use crate::rows::{Figures, Form};

impl<const N: usize> Sum<N> {
    /// The numerator.
    #[inline(always)]
    pub(super) fn at(&self, terms: [i64; N]) -> Option<i128> {
        let mut products = self.factors.iter().zip(terms);
        products.try_fold(0_i128, |sum, (factor, term)| {
            sum.checked_add(times(*factor, term)?)
        })
    }
}

/// A product of less than 126 bits.
#[inline(always)]
pub(super) fn times(a: i128, b: i64) -> Option<i128> {
    let zeros = a.unsigned_abs().leading_zeros() + b.unsigned_abs().leading_zeros();
    (zeros > u64::BITS + 2).then(|| a.wrapping_mul(b.into()))
}

impl Exactly {
    /// Writes the row of the interval that starts at sample `i` and lasts so long; nothing, and `None`, where it is left
    /// open.
    pub(in super::super) fn write(
        &self,
        (samples, forces, i): (&Readings, Option<&Readings>, usize),
        length: Length,
        form: Form,
        (room, out): (&mut [u8; Line::ROOM], &mut Vec<u8>),
    ) -> Option<()> {
        let (unit_of_position, unit_of_force, over) = self.of;
        let at = |i: usize| samples.written.whole_at(i, unit_of_position);
        let force = force_at(forces, unit_of_force, i)?;
        let row = Interval {
            ends: [at(i)?, at(i + 1)?],
            force,
            lasts: lasts_over(length, over)?,
        };
        let mut line = Line::new(room, 0);
        let (ratio, _, q) = &self.position;
        for x in row.ends {
            let xi = self.primes.quotient(times((*ratio).into(), x)?, q, 1)?;
            form.position([xi; 2], &mut line)?;
        }
        let lasts = self.primes.quotient(row.lasts.into(), &self.lasts, 1)?;
        lasts.write(&mut line)?;
        form.account(&self.figures(&row)?, &mut line)?;
        out.extend_from_slice(line.text());
        Some(())
    }

    #[inline(always)]
    fn figures(&self, row: &Interval) -> Option<Figures<Quotient>> {
        let [from, to] = row.ends;
        let (ratio, q, _) = self.position;
        let mut ticks = [(0, 0); 2];
        let mut potentials = [0; 2];
        for ((tick, potential), x) in ticks.iter_mut().zip(&mut potentials).zip(row.ends) {
            let xi = ratio.checked_mul(x)?;
            let n = xi.div_euclid(q);
            *tick = (xi, n);
            *potential = twice_quantized(n, xi.rem_euclid(q), q)?;
        }
        let d = to.checked_sub(from)?;
        let factor = match row.force {
            Some(force) => force,
            None => ticks[0].1.checked_mul(2)?.checked_add(1)?,
        };
        let work = d.checked_mul(factor)?;
        let holds = |part: &Option<Part>| part.is_some_and(|part| part.has(ticks));
        let part = self.parts.iter().position(holds)?;
        // What the wall takes up, against it and against its quantized form.
        let taken_up = match part {
            0 => [
                d.checked_mul(from.checked_add(to)?)?,
                potentials[1].checked_sub(potentials[0])?,
            ],
            _ => [d; 2],
        };
        let (square, distance) = (d.checked_mul(d)?, d.checked_abs()?);
        let generated = &self.generated[part];
        let plain = |sum: &Sum<2>, terms| self.primes.quotient(sum.at(terms)?, &sum.over, 1);
        let bound = {
            let d = ratio.checked_mul(d)?.checked_abs()?;
            twice_quantized(d.div_euclid(q), d.rem_euclid(q), q)?.checked_add(d)?
        };
        let split = self.primes.split(row.lasts.cast_unsigned());
        let distances = self.primes.split(distance.max(1).cast_unsigned());
        let terms = Terms {
            square,
            distance,
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
        let both = |pick: fn(&Ends) -> Quotient| [pick(&least), pick(&most)];
        let energies = [
            [plain(&generated[0], [work, taken_up[0]])?; 2],
            [plain(&generated[1], [work, taken_up[1]])?; 2],
            [plain(&self.bound_22, [square, distance])?; 2],
            [self.primes
                .quotient(bound.into(), &self.bound_quantized, 1)?; 2],
            both(|end| end.taken),
            both(|end| end.net[0]),
            both(|end| end.net[1]),
        ];
        let margin = both(|end| end.margin);
        let covers = |[lo, hi]: [Quotient; 2]| Truth::over(!lo.is_negative, !hi.is_negative);
        let (force, over) = &self.force;
        let force = match row.force {
            Some(f) => Some(self.primes.quotient(times((*force).into(), f)?, over, 1)?),
            None => None,
        };
        let moves = distance > 0;
        Some(Figures {
            truths: Truths {
                criterion_holds: if moves { covers(margin) } else { Truth::Holds },
                violates_linear: not(covers(energies[5])),
                violates_quantized: not(covers(energies[6])),
            },
            energies,
            margin: margin.map(|margin| moves.then_some(margin)),
            force: [force; 2],
        })
    }
}

/// An interval in whole numbers.
struct Interval {
    ends: [i64; 2],
    force: Option<i64>,
    lasts: i64,
}

/// The whole numbers that the figures of a row are sums of.
struct Terms {
    square: i64,
    distance: i64,
    work: i64,
    taken_up: [i64; 2],
    lasts: i64,
}

/// What a row says at one end of friction.
#[derive(Clone, Copy)]
struct Ends {
    taken: Quotient,
    net: [Quotient; 2],
    margin: Quotient,
}

impl Friction {
    #[inline(always)]
    fn of(
        &self,
        primes: &Primes,
        part: usize,
        terms: &Terms,
        [lasts, distances]: [&Split; 2],
    ) -> Option<Ends> {
        let Terms {
            square,
            distance,
            work,
            taken_up,
            lasts: n,
        } = *terms;
        let is_viscous = self.viscous != 0;
        let d = u128::from(distance.unsigned_abs());
        // Of all that is over the length, the length has in common what it has with viscous friction.
        let beside = match is_viscous {
            true => lasts.beside([self.viscous, d, d]),
            false => Beside::ONE,
        };
        let n_or_one = if is_viscous { n } else { 1 };
        let over = |n: i128, over: &Factored, beside: &Beside| {
            primes.quotient(beside.divided(n), &over.times(&beside.known)?, beside.rest)
        };
        let over_length = |sum: i128, more: i128, of: &Factored| {
            over(sum.checked_add(times(more, n_or_one)?)?, of, &beside)
        };
        let net = |of: &Sum<4>, taken_up: i64| {
            let [a, b, c, d] = of.factors;
            let more = times(b, distance)?
                .checked_add(times(c, work)?)?
                .checked_add(times(d, taken_up)?)?;
            over_length(times(a, square)?, more, &of.over)
        };
        let [a, b] = self.taken.factors;
        let [linear, quantized] = &self.net[part];
        let (margin, numerator) = &self.margin;
        let over_distance = distances.beside([*numerator, n.unsigned_abs().into(), 1]);
        let margin = over(margin.at([distance, n])?, &margin.over, &over_distance)?;
        Some(Ends {
            taken: over_length(times(a, square)?, times(b, distance)?, &self.taken.over)?,
            net: [net(linear, taken_up[0])?, net(quantized, taken_up[1])?],
            margin,
        })
    }
}

/// 2q times the potential of the quantized spring (16) at n + r/q ticks.
#[inline(always)]
fn twice_quantized(n: i64, r: i64, q: i64) -> Option<i64> {
    let up_to_tick = n.checked_mul(n)?.checked_mul(q)?;
    let within = n.checked_mul(2)?.checked_add(1)?.checked_mul(r)?;
    up_to_tick.checked_add(within)
}
