//! The figures of one row between counts, from the whole numbers that it is made of.

use passivity_core::counted::{Arc, Crossing, Resistance};
use passivity_core::{Ordered as _, Scalar as _, Truth};

use super::super::super::Length;
use super::super::constants::Part;
use super::super::row::times;
use super::super::{Sum, force_at, lasts_over};
use super::{Counts, Friction};
use crate::ball::Ball;
use crate::figure::not;
use crate::ledger::Truths;
use crate::log::numbers::Readings;
use crate::number::{Factored, Line, Primes, Quotient};
use crate::rows::{Figures, Form, Whole};

/// A row as it is known.
struct Interval {
    counts: [i64; 2],
    force: Option<i64>,
    lasts: i64,
}

/// Numerators at the least and at the most.
type Pair = [i128; 2];

impl Counts {
    /// As [`Exactly::write`](super::super::Exactly::write).
    pub(in super::super::super) fn write(
        &self,
        (counts, forces, i): (&[i64], Option<&Readings>, usize),
        length: Length,
        form: Form,
        (room, out): (&mut [u8; Line::ROOM], &mut Vec<u8>),
    ) -> Option<()> {
        let (unit, over) = self.of;
        let force = force_at(forces, unit, i)?;
        let row = Interval {
            counts: *counts.get(i..)?.first_chunk()?,
            force,
            lasts: lasts_over(length, over)?,
        };
        let mut line = Line::new(room, 0);
        for n in row.counts {
            form.position([Whole(n), Whole(n.checked_add(1)?)], &mut line)?;
        }
        let lasts = self.primes.quotient(row.lasts.into(), &self.lasts, 1)?;
        lasts.write(&mut line)?;
        form.account(&self.figures(&row)?, &mut line)?;
        out.extend_from_slice(line.text());
        Some(())
    }

    fn figures(&self, row: &Interval) -> Option<Figures<Quotient>> {
        let [from, to] = row.counts;
        let k = to.checked_sub(from)?;
        let ends = [from, from.checked_add(1)?, to, to.checked_add(1)?];
        let holds = |part: &Option<Part>| {
            let ticks = [from, from, to, to];
            let mut ends = ends.into_iter().zip(ticks);
            part.is_some_and(|part| ends.all(|end| part.has([end; 2])))
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
            let twice = times(d.into(), d)?.checked_add(d.into())?;
            self.primes.quotient(twice / 2, &Factored::ONE, 1)
        });
        let [a, b] = bounds;
        let bounds = [a?, b?];
        let taken = [
            least.taken(&self.primes, near, row.lasts)?,
            most.taken(&self.primes, far, row.lasts)?,
        ];
        let force = match row.force {
            Some(f) => Some(self.primes.quotient(
                times(self.force.0.into(), f)?,
                &self.force.2,
                1,
            )?),
            None => None,
        };
        let covers = |[lo, hi]: [Quotient; 2]| Truth::over(!lo.is_negative, !hi.is_negative);
        let signs = |friction: &Friction| {
            let sum = &friction.margin.0;
            let at = |d: i64| Some(sum.at([d, row.lasts])? >= 0);
            Some([at(near)?, at(far)?])
        };
        let ([a, b], [c, d]) = (signs(least)?, signs(most)?);
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
                least.margin(
                    &self.primes,
                    if least.margin.1 < 0 { near } else { far },
                    row.lasts,
                )?,
                most.margin(
                    &self.primes,
                    if most.margin.1 > 0 { near } else { far },
                    row.lasts,
                )?,
            ],
            force: [force; 2],
        })
    }

    /// What is generated, and net energy, where the wall is linear.
    #[inline(always)]
    fn linear(&self, row: &Interval, k: i64, frictions: [&Friction; 2]) -> Option<Energies> {
        let [from, _] = row.counts;
        let (unit, p, _) = self.force;
        let beyond = match row.force {
            Some(f) => {
                let own = from.checked_mul(2)?.checked_add(1)?.checked_mul(p)?;
                unit.checked_mul(f)?.checked_mul(2)?.checked_add(own)?
            }
            None => 0,
        };
        self.turns_nowhere(k, beyond, row.lasts, frictions)?;
        let work = |u: i64| u.checked_mul(beyond.checked_add(p.checked_mul(u.checked_sub(1)?)?)?);
        let start = work(k)?;
        let rise = beyond.checked_add(p.checked_mul(2)?.checked_mul(k)?)?;
        let highest = start.checked_add(rise.max(0))?;
        let quantized = [
            start.checked_add(rise.min(0))?.checked_sub(beyond.max(0))?,
            highest.checked_sub(beyond.min(0))?,
        ];
        // Over 8P²; where the wall balances the force, in ticks over 2P.
        let wide = |n: i64| times(i128::from(p) * 4, n);
        let balance = p.checked_sub(beyond)?;
        let at_balance = || times((-balance).into(), balance);
        let ticks = |n: i64| p.checked_mul(2)?.checked_mul(n);
        let least = match balance {
            x if x <= ticks(k)? => wide(start)?,
            x if x >= ticks(k.checked_add(1)?)? => wide(start.checked_add(rise)?)?,
            _ => at_balance()?,
        };
        let lowest = match balance {
            ..=0 => 0,
            x if x >= ticks(1)? => wide(beyond)?,
            _ => at_balance()?,
        };
        let generated = [
            least.checked_sub(wide(beyond.max(0))?)?,
            wide(highest)?.checked_sub(lowest)?,
        ];
        let (before, behind) = (k.checked_sub(1)?, k.checked_add(1)?);
        let distance = k.checked_abs()?;
        let wider = ticks(k)?;
        let corner = |d: i64| d.checked_mul(beyond.checked_add(p.checked_mul(k)?)?);
        let corners = [
            (distance, start.checked_add(wider.max(0))?),
            (distance, start.checked_add(wider.min(0))?),
            (before.checked_abs()?, corner(before)?),
            (behind.checked_abs()?, corner(behind)?),
        ];
        let net = self.extremes(frictions, 0, &corners, row.lasts)?;
        let [twice, eightfold] = &self.over;
        Some((
            [
                self.both(generated, eightfold)?,
                self.both(quantized.map(i128::from), twice)?,
            ],
            [net; 2],
        ))
    }

    /// The same where the force of the wall is the same everywhere.
    fn flat(
        &self,
        row: &Interval,
        k: i64,
        part: usize,
        frictions: [&Friction; 2],
    ) -> Option<Energies> {
        let (unit, limit, over) = self.flat.get(part.checked_sub(1)?)?;
        let force = match row.force {
            Some(f) => unit.checked_mul(f)?.checked_add(*limit)?,
            None => 0,
        };
        if force != 0 && frictions.iter().any(|friction| friction.viscous != 0) {
            return None;
        }
        let corner = |d: i64| Some((d.checked_abs()?, d.checked_mul(force)?));
        let corners = [
            corner(k.checked_sub(1)?)?,
            corner(k)?,
            corner(k.checked_add(1)?)?,
        ];
        let [(_, first), _, (_, last)] = corners;
        let generated = [first.min(last), first.max(last)].map(i128::from);
        let net = self.extremes(frictions, part, &corners, row.lasts)?;
        let generated = self.both(generated, over)?;
        Some(([generated; 2], [net; 2]))
    }

    fn both(&self, [lo, hi]: Pair, over: &Factored) -> Option<[Quotient; 2]> {
        Some([
            self.primes.quotient(lo, over, 1)?,
            self.primes.quotient(hi, over, 1)?,
        ])
    }

    /// The least net energy with the least friction and the most with the most, of pairs of a distance and of what is
    /// generated.
    fn extremes(
        &self,
        [least, most]: [&Friction; 2],
        over: usize,
        corners: &[(i64, i64)],
        n: i64,
    ) -> Option<[Quotient; 2]> {
        let at = |friction: &Friction, (d, work): (i64, i64)| {
            Some((
                friction.numerator(friction.net.get(over)?, d, work.into(), n)?,
                d,
            ))
        };
        let mut found: Option<[(i128, i64); 2]> = None;
        for corner in corners {
            let (a, b) = (at(least, *corner)?, at(most, *corner)?);
            found = Some(match found {
                None => [a, b],
                Some([lo, hi]) => [
                    if a.0 < lo.0 { a } else { lo },
                    if b.0 > hi.0 { b } else { hi },
                ],
            });
        }
        let [(lo, d), (hi, e)] = found?;
        Some([
            least.quotient(&self.primes, lo, &least.net.get(over)?.over, d, n)?,
            most.quotient(&self.primes, hi, &most.net.get(over)?.over, e, n)?,
        ])
    }

    /// Nothing where net energy may be extreme between the corners.
    fn turns_nowhere(
        &self,
        k: i64,
        beyond: i64,
        lasts: i64,
        [least, most]: [&Friction; 2],
    ) -> Option<()> {
        let (_, p, _) = self.force;
        let crossing = Crossing {
            ticks: Ball::whole(k),
            excess: Ball::ratio(beyond, p.checked_mul(2)?),
        };
        let lasts = Ball::ratio(lasts, self.of.1);
        let resistance = Resistance::new(&least.near, &lasts);
        // Whether it is least, or most, at an end of a part: where its slope has one sign, or the part is bent otherwise.
        let is_at_an_end = |arc: &Arc<Ball>, is_bent_away: fn(Ball) -> Option<bool>| {
            let [from, to] = arc.ends.map(|d| arc.slope + (arc.bend.square * d).double());
            let (a, b) = (from.is_nonnegative(), to.is_nonnegative());
            (a.is_some() && a == b) || is_bent_away(arc.bend.square) == Some(true)
        };
        let is_not_above = |x: Ball| (-x).is_nonnegative();
        let at_least =
            |arcs: &[Arc<Ball>; 2]| arcs.iter().all(|arc| is_at_an_end(arc, is_not_above));
        if least.viscous != 0 && !at_least(&crossing.least_quantized(&resistance)) {
            return None;
        }
        let resistance_at_most = Resistance::new(&most.near, &lasts);
        let at_most = crossing.most_linear(&resistance_at_most);
        let at_most = at_most
            .iter()
            .all(|arc| is_at_an_end(arc, |x| x.is_nonnegative()));
        (at_most && at_least(&crossing.least_linear(&resistance))).then_some(())
    }
}

/// What is generated and net energy, against the wall and against its quantized form.
type Energies = ([[Quotient; 2]; 2], [[Quotient; 2]; 2]);

impl Friction {
    /// The numerator of net energy.
    #[inline(always)]
    fn numerator(&self, net: &Sum<3>, d: i64, generated: i128, n: i64) -> Option<i128> {
        let [a, b, c] = net.factors;
        let more = times(b, d)?.checked_add(c.checked_mul(generated)?)?;
        self.over_length(times(a, d.checked_mul(d)?)?, more, n)
    }

    #[inline(always)]
    fn over_length(&self, viscous: i128, more: i128, n: i64) -> Option<i128> {
        match self.viscous {
            0 => Some(more),
            _ => viscous.checked_add(times(more, n)?),
        }
    }

    /// A numerator over the length, where friction is viscous, which has in common with it what it has with that.
    #[inline(always)]
    fn quotient(
        &self,
        primes: &Primes,
        numerator: i128,
        over: &Factored,
        d: i64,
        n: i64,
    ) -> Option<Quotient> {
        if self.viscous == 0 {
            return primes.quotient(numerator, over, 1);
        }
        let d = u128::from(d.unsigned_abs());
        let beside = primes.split(n.unsigned_abs()).beside([self.viscous, d, d]);
        primes.quotient(
            beside.divided(numerator),
            &over.times(&beside.known)?,
            beside.rest,
        )
    }

    fn taken(&self, primes: &Primes, d: i64, n: i64) -> Option<Quotient> {
        let [a, b] = self.taken.factors;
        let numerator = self.over_length(times(a, d.checked_mul(d)?)?, times(b, d)?, n)?;
        self.quotient(primes, numerator, &self.taken.over, d, n)
    }

    /// The margin of the criterion over this distance; nothing in it at rest.
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
