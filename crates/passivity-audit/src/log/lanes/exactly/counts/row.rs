//! The figures of one row between counts, from the whole numbers that it is made of.

use std::ops::Range;

use passivity_core::Truth;
use passivity_core::counted::{Crossing, Resistance};

use super::super::super::Length;
use super::super::constants::Part;
use super::super::row::QuotientOf;
use super::super::{Row, Sum, Written, force_at, lasts_over, write_ends};
use super::turns::{self, Parabolas, Place, Ways};
use super::{Counts, Flat, Friction};
use crate::ball::Ball;
use crate::figure::not;
use crate::ledger::Truths;
use crate::log::numbers::Read;
use crate::number::{Exact as _, Factored, Line, Primes, Quotient, Term, Total as _};
use crate::rows::{Figures, Form, Whole};

/// A row as it is known.
struct Interval<T> {
    counts: [i64; 2],
    force: Option<T>,
    lasts: i64,
}

impl Written for Counts {
    type Samples = [i64];

    const MAY_BE_LONG: bool = true;

    #[inline(always)]
    fn write_as<T: Read>(
        &self,
        (counts, forces, i): Row<'_, [i64]>,
        length: Length,
        form: Form,
        line: &mut Line<'_>,
    ) -> Option<Range<usize>> {
        let (unit, over) = self.of;
        let force = force_at::<T>(forces, unit, i)?;
        let row = Interval {
            counts: *counts.get(i..)?.first_chunk()?,
            force,
            lasts: lasts_over(length, over)?,
        };
        let end = write_ends(row.counts, line, |n, line| {
            form.position([Whole(n), Whole(n.checked_add(1)?)], line)
        })?;
        let lasts = self.primes.quotient(row.lasts.into(), &self.lasts, 1)?;
        lasts.write(line)?;
        form.account(&self.figures(&row)?, line)?;
        Some(end)
    }
}

impl Counts {
    #[inline(always)]
    fn figures<T: Term>(&self, row: &Interval<T>) -> Option<Figures<QuotientOf<T>>> {
        let [from, to] = row.counts;
        let k = to.checked_sub(from)?;
        let ends = [from, from.checked_add(1)?, to, to.checked_add(1)?];
        let holds = |part: &Option<Part>| {
            let ticks = [from, from, to, to];
            let mut ends = ends.into_iter().zip(ticks);
            part.is_some_and(|part| ends.all(|(end, tick)| part.has([([end; 2], tick); 2])))
        };
        let part = self.parts.iter().position(holds)?;
        let distance = k.checked_abs()?;
        let (near, far) = ((distance - 1).max(0), distance.checked_add(1)?);
        let (least, most) = (
            &self.frictions.0,
            self.frictions.1.as_ref().unwrap_or(&self.frictions.0),
        );
        let frictions = [least, most];
        let ([generated, quantized], [net, net_quantized]) = match part {
            0 => self.linear(row, k, frictions)?,
            flat => self.flat(row, k, flat, frictions)?,
        };
        let bounds = [near, far].map(|d| {
            // Of d² and d one half is whole.
            let twice = Term::square(d)?.checked_add(d.into())?;
            self.primes.quotient(twice / 2, &Factored::ONE, 1)
        });
        let [a, b] = bounds;
        let bounds = [a?.widened(), b?.widened()];
        let taken = [
            least.taken(&self.primes, near, row.lasts)?.widened(),
            most.taken(&self.primes, far, row.lasts)?.widened(),
        ];
        let force = match row.force {
            Some(f) => {
                let (unit, _, over) = &self.force;
                Some(f.by((*unit).into())?.quotient(&self.primes, over, 1)?)
            }
            None => None,
        };
        let covers =
            |[lo, hi]: [QuotientOf<T>; 2]| Truth::over(!lo.is_negative(), !hi.is_negative());
        let signs = |friction: &Friction| {
            let sum = &friction.margin.0;
            let at = |d: i64| Some(sum.at([d, row.lasts])? >= 0);
            Some([at(near)?, at(far)?])
        };
        let ([a, b], [c, d]) = (signs(least)?, signs(most)?);
        let margin = |friction: &Friction, d: i64| {
            let margin = friction.margin(&self.primes, d, row.lasts)?;
            Some(margin.map(Quotient::widened))
        };
        Some(Figures {
            truths: Truths {
                criterion_holds: match Truth::over(a && b, c || d) {
                    // Had nothing moved, it would hold.
                    Truth::Fails if near == 0 => Truth::Depends,
                    truth => truth,
                },
                violates_linear: not(covers(net)),
                violates_quantized: not(covers(net_quantized)),
            },
            energies: [
                generated,
                quantized,
                bounds,
                bounds,
                taken,
                net,
                net_quantized,
            ],
            margin: [
                margin(least, if least.margin.1 < 0 { near } else { far })?,
                margin(most, if most.margin.1 > 0 { near } else { far })?,
            ],
            force: [force; 2],
        })
    }

    /// What is generated, and net energy, where the wall is linear.
    #[inline]
    fn linear<T: Term>(
        &self,
        row: &Interval<T>,
        k: i64,
        frictions: [&Friction; 2],
    ) -> Option<Energies<T>> {
        let [from, _] = row.counts;
        let (unit, p, _) = self.force;
        let (whole, zero) = (T::from, T::zero());
        let beyond = match row.force {
            Some(f) => {
                let own = from.checked_mul(2)?.checked_add(1)?.checked_mul(p)?;
                let twice = whole(unit).times(f)?.times(whole(2))?;
                twice.plus(whole(own))?
            }
            None => zero,
        };
        let start = whole(k).times(beyond.plus(whole(p.checked_mul(k.checked_sub(1)?)?))?)?;
        let rise = beyond.plus(whole(p.checked_mul(2)?.checked_mul(k)?))?;
        let highest = start.plus(rise.at_least_zero())?;
        let quantized = [
            start
                .plus(rise.at_most_zero())?
                .minus(beyond.at_least_zero())?,
            highest.minus(beyond.at_most_zero())?,
        ];
        // Over 8P²; where the wall balances the force, in ticks over 2P.
        let wide = |x: T| x.by(i128::from(p) * 4);
        let balance = whole(p).minus(beyond)?;
        let at_balance = || T::Sum::zero().minus(balance.square()?);
        let ticks = |n: i64| Some(whole(p.checked_mul(2)?.checked_mul(n)?));
        let is_up_to = |n: i64| Some(!ticks(n)?.minus(balance)?.is_negative());
        let is_from = |n: i64| Some(!balance.minus(ticks(n)?)?.is_negative());
        let least = if is_up_to(k)? {
            wide(start)?
        } else if is_from(k.checked_add(1)?)? {
            wide(start.plus(rise)?)?
        } else {
            at_balance()?
        };
        let lowest = if is_up_to(0)? {
            T::Sum::zero()
        } else if is_from(1)? {
            wide(beyond)?
        } else {
            at_balance()?
        };
        let generated = [
            least.minus(wide(beyond.at_least_zero())?)?,
            wide(highest)?.minus(lowest)?,
        ];
        let (before, behind) = (k.checked_sub(1)?, k.checked_add(1)?);
        let distance = k.checked_abs()?;
        let wider = ticks(k)?;
        let corner = |d: i64| whole(d).times(beyond.plus(whole(p.checked_mul(k)?))?);
        let corners = [
            (distance, start.plus(wider.at_least_zero())?),
            (distance, start.plus(wider.at_most_zero())?),
            (before.checked_abs()?, corner(before)?),
            (behind.checked_abs()?, corner(behind)?),
        ];
        let nets = self.nets(frictions, (k, beyond), &corners, row.lasts)?;
        let [twice, eightfold] = &self.over;
        let [least, most] = quantized;
        Some((
            [
                self.both::<T>(generated, eightfold)?,
                self.both::<T>([least.by(1)?, most.by(1)?], twice)?,
            ],
            nets,
        ))
    }

    /// The same where the force of the wall is the same everywhere.
    #[inline]
    fn flat<T: Term>(
        &self,
        row: &Interval<T>,
        k: i64,
        part: usize,
        frictions: [&Friction; 2],
    ) -> Option<Energies<T>> {
        let Flat {
            unit,
            limit,
            over,
            denominator,
        } = self.flat.get(part.checked_sub(1)?)?;
        let force = match row.force {
            Some(f) => T::from(*unit).times(f)?.plus(T::from(*limit))?,
            None => T::zero(),
        };
        let corner = |d: i64| Some((d.checked_abs()?, T::from(d).times(force)?));
        let corners = [
            corner(k.checked_sub(1)?)?,
            corner(k)?,
            corner(k.checked_add(1)?)?,
        ];
        let [(_, first), _, (_, last)] = corners;
        let generated = match force.is_negative() {
            true => [last.by(1)?, first.by(1)?],
            false => [first.by(1)?, last.by(1)?],
        };
        let [mut least, most] = self.extremes(frictions, part, &corners, row.lasts)?;
        let [friction, _] = frictions;
        if friction.viscous != 0 && row.force.is_some() {
            let ways = Ways::of(k, force)?;
            let resistance = friction.resistance(row.lasts, self.of.1);
            let place = turns::flat(&ways, *denominator, &resistance)?;
            if let Some(side) = place {
                let parabolas = ways.flat()?;
                least = friction.at_turn(&self.primes, part, parabolas.get(side)?, row.lasts)?;
            }
        }
        let generated = self.both::<T>(generated, over)?;
        Some(([generated; 2], [[least, most]; 2]))
    }

    #[inline]
    fn both<T: Term>(&self, [lo, hi]: [T::Sum; 2], over: &Factored) -> Option<[QuotientOf<T>; 2]> {
        Some([
            lo.quotient(&self.primes, over, 1)?,
            hi.quotient(&self.primes, over, 1)?,
        ])
    }

    /// The least net energy with the least friction and the most with the most, of pairs of a distance and of what is
    /// generated.
    #[inline]
    fn extremes<T: Term>(
        &self,
        [least, most]: [&Friction; 2],
        over: usize,
        corners: &[(i64, T)],
        n: i64,
    ) -> Option<[QuotientOf<T>; 2]> {
        let at = |friction: &Friction, (d, work): (i64, T)| {
            Some((friction.numerator(friction.net.get(over)?, d, work, n)?, d))
        };
        let is_below = |a: T::Sum, b: T::Sum| Some(a.minus(b)?.is_negative());
        let mut found: Option<[(T::Sum, i64); 2]> = None;
        // Friction that is known has one end.
        let is_known = std::ptr::eq(least, most);
        for corner in corners {
            let a = at(least, *corner)?;
            let b = if is_known { a } else { at(most, *corner)? };
            found = Some(match found {
                None => [a, b],
                Some([lo, hi]) => [
                    if is_below(a.0, lo.0)? { a } else { lo },
                    if is_below(hi.0, b.0)? { b } else { hi },
                ],
            });
        }
        let [(lo, d), (hi, e)] = found?;
        Some([
            least.quotient::<T>(&self.primes, lo, &least.net.get(over)?.over, d, n)?,
            most.quotient::<T>(&self.primes, hi, &most.net.get(over)?.over, e, n)?,
        ])
    }

    /// Net energy where the wall is linear, against it and against its quantized form, k ticks under an excess.
    #[inline]
    fn nets<T: Term>(
        &self,
        [least, most]: [&Friction; 2],
        (k, excess): (i64, T),
        corners: &[(i64, T)],
        lasts: i64,
    ) -> Option<[[QuotientOf<T>; 2]; 2]> {
        let (_, p, _) = self.force;
        let one = p.checked_mul(2)?;
        let near = Crossing {
            ticks: Ball::whole(k),
            excess: excess.near(one),
        };
        let [lo, hi] = self.extremes([least, most], 0, corners, lasts)?;
        let resistance = [least, most].map(|friction| friction.resistance(lasts, self.of.1));
        let [linear, quantized, linear_at_most] = turns::linear(&near, resistance.each_ref())?;
        let at = |place: Place, friction: &Friction, parabolas: Parabolas<T>| match place {
            None => Some(None),
            Some(side) => {
                let sides = parabolas(&Ways::of(k, excess)?, one)?;
                let turn = friction.at_turn(&self.primes, 0, sides.get(side)?, lasts)?;
                Some(Some(turn))
            }
        };
        let linear = at(linear, least, Ways::least_linear)?;
        let quantized = at(quantized, least, Ways::least_quantized)?;
        let linear_at_most = at(linear_at_most, most, Ways::most_linear)?;
        Some([
            [linear.unwrap_or(lo), linear_at_most.unwrap_or(hi)],
            [quantized.unwrap_or(lo), hi],
        ])
    }
}

/// What is generated and net energy, against the wall and against its quantized form.
type Energies<T> = ([[QuotientOf<T>; 2]; 2], [[QuotientOf<T>; 2]; 2]);

impl Friction {
    /// The same, near by, over an interval that lasts so long.
    fn resistance(&self, lasts: i64, over: i64) -> Resistance<Ball> {
        Resistance::new(&self.near, &Ball::ratio(lasts, over))
    }

    /// The numerator of net energy.
    #[inline]
    fn numerator<T: Term>(&self, net: &Sum<3>, d: i64, generated: T, n: i64) -> Option<T::Sum> {
        let [a, b, c] = net.factors;
        let generated = generated.by(c)?;
        let generated = match self.viscous {
            0 => generated,
            _ => generated.by(n)?,
        };
        T::Sum::from(self.over_length([a, b], d, n)?).plus(generated)
    }

    /// What friction takes, over the length where it is viscous.
    #[inline]
    fn over_length(&self, [a, b]: [i128; 2], d: i64, n: i64) -> Option<i128> {
        let coulomb = d.by(b)?;
        match self.viscous {
            0 => Some(coulomb),
            _ => d.checked_mul(d)?.by(a)?.checked_add(coulomb.by(n)?),
        }
    }

    /// A numerator over the length, where friction is viscous, which has in common with it what it has with that.
    #[inline]
    fn quotient<T: Term>(
        &self,
        primes: &Primes,
        numerator: T::Sum,
        over: &Factored,
        d: i64,
        n: i64,
    ) -> Option<QuotientOf<T>> {
        if self.viscous == 0 {
            return numerator.quotient(primes, over, 1);
        }
        let d = u128::from(d.unsigned_abs());
        let beside = primes.split(n.unsigned_abs()).beside([self.viscous, d, d]);
        let over = over.times(&beside.known)?;
        beside
            .divided(numerator)
            .quotient(primes, &over, beside.rest)
    }

    #[inline]
    fn taken(&self, primes: &Primes, d: i64, n: i64) -> Option<Quotient> {
        let numerator = self.over_length(self.taken.factors, d, n)?;
        self.quotient::<i64>(primes, numerator, &self.taken.over, d, n)
    }

    /// The margin of the criterion over this distance; nothing in it at rest.
    #[inline]
    fn margin(&self, primes: &Primes, d: i64, n: i64) -> Option<Option<Quotient>> {
        if d == 0 {
            return Some(None);
        }
        let (sum, numerator) = &self.margin;
        let split = primes.split(d.unsigned_abs());
        let beside = split.beside([numerator.unsigned_abs(), n.unsigned_abs().into(), 1]);
        let over = sum.over.times(&beside.known)?;
        primes
            .quotient(beside.divided(sum.at([d, n])?), &over, beside.rest)
            .map(Some)
    }
}
