//! What an interval between two counts comes to, in doubles, where a wall is all there is, and the interval in one part of it,
//! or where it is bent.

mod bent;

use passivity_core::counted::{Crossing, Resistance};
use passivity_core::{Criterion, Friction, Ordered, Scalar as _, Truth, dissipation, quantizer};

use crate::ball::Ball;
use crate::figure::not;
use crate::ledger::{Ledger, Logged, Truths};
use crate::log::known::known_force;
use crate::log::lanes::Length;
use crate::log::motion::{Addend, between};
use crate::log::quick::Quick;
use crate::log::supply::Contribution;
use crate::log::wall::Wall;
use crate::number::{Number, Reduced};
use crate::reading::Reading;

/// What is known of an interval between two counts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval<T> {
    pub(crate) start: T,
    pub(crate) end: T,
    /// How many periods it lasts.
    pub(crate) lasts: T,
    /// The force in the log; any number where the account is of the wall's own.
    pub(crate) force: T,
}

/// What it comes to. Pairs are at the least and at the most.
#[derive(Clone, Debug)]
pub(crate) struct Row<T> {
    /// The least that friction takes (26).
    pub(crate) taken: [T; 2],
    /// The margin of the criterion, times the mean speed.
    pub(crate) margin: [T; 2],
    /// Generated and net energy, against the wall and against its quantized form.
    pub(crate) generated: [[T; 2]; 2],
    pub(crate) net: [[T; 2]; 2],
    /// The work of the force from one count to the other.
    pub(crate) work: T,
    /// Net energy against the wall under its own force,
    pub(crate) own: [T; 2],
    /// what is held beyond that,
    pub(crate) excess: T,
    /// and the potential where the interval ends, less what of the work of that is due to the place within the tick.
    pub(crate) stored: [T; 2],
}

/// The friction of a wall, and the criteria: at the least and at the most.
pub(crate) type Walls<'a, S> = (&'a [Friction<S>; 2], &'a [Criterion<S>; 2]);

impl<S: Ordered> Row<S> {
    /// Of an interval under the force in the log where that is `applied`, else under that of the wall, given the least
    /// friction and the most, and the criteria of both; `is_exact` says whether friction has one value.
    #[inline(always)]
    pub(crate) fn of(
        (frictions, criteria): Walls<'_, S>,
        of: &Interval<S>,
        is_exact: bool,
        applied: bool,
    ) -> Self {
        let ticks = of.end.clone() - of.start.clone();
        let own = Crossing::own(ticks.clone());
        let held = quantizer::held_force(&of.start);
        let force = if applied {
            of.force.clone()
        } else {
            held.clone()
        };
        let crossing = Crossing {
            ticks: ticks.clone(),
            excess: match applied {
                true => force.clone() - held,
                false => S::zero(),
            },
        };
        let [least, most] = resistances(frictions, &of.lasts, is_exact);
        let [near, far] = crossing.distances();
        let ([a, b], [c, d]) = (crossing.net_at_least(&least), crossing.net_at_most(&most));
        // Under the wall's own force that is the same.
        let [lo, hi] = match applied {
            true => {
                let ([lo, _], [hi, _]) = (own.net_at_least(&least), own.net_at_most(&most));
                [lo, hi]
            }
            false => [a.clone(), c.clone()],
        };
        Self {
            taken: [least.taken(&near), most.taken(&far)],
            margin: margin(criteria, [&near, &far], &of.lasts),
            generated: crossing.generated(),
            net: [[a, c], [b, d]],
            work: force * ticks,
            own: [lo, hi],
            stored: crossing.stored(&of.end),
            excess: crossing.excess,
        }
    }
}

/// Of the least friction and of the most, over an interval that lasts so long; `is_exact` where these are the same.
#[inline(always)]
pub(super) fn resistances<S: Ordered>(
    [least, most]: &[Friction<S>; 2],
    lasts: &S,
    is_exact: bool,
) -> [Resistance<S>; 2] {
    let least = Resistance::new(least, lasts);
    let most = match is_exact {
        true => least.clone(),
        false => Resistance::new(most, lasts),
    };
    [least, most]
}

/// The margin of both criteria, times the mean speed, over distances between two.
#[inline(always)]
pub(super) fn margin<S: Ordered>(
    criteria: &[Criterion<S>; 2],
    [near, far]: [&S; 2],
    lasts: &S,
) -> [S; 2] {
    let [slow, fast] = [
        dissipation::mean_speed(near, lasts),
        dissipation::mean_speed(far, lasts),
    ];
    let [low, high] = criteria;
    [
        low.margin(&slow).min(low.margin(&fast)),
        high.margin(&slow).max(high.margin(&fast)),
    ]
}

/// What an interval between two counts comes to, in units of the grid. Pairs are at the least and at the most.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Figures {
    /// As [`Addend::sums`].
    pub(crate) sums: [[i128; 2]; 5],
    /// What the observer adds.
    pub(crate) observed: i128,
    /// The rest as in [`Row`].
    pub(crate) own: [i128; 2],
    pub(crate) excess: [i128; 2],
    pub(crate) stored: [i128; 2],
    pub(crate) truths: Truths,
    /// How many ticks it crosses.
    pub(crate) crossed: i64,
}

impl Figures {
    /// Of an interval of its own; `None` of others than those between counts, of loops that have more than an encoder,
    /// and where doubles leave something open.
    pub(crate) fn of_interval(ledger: &Ledger, interval: &Logged) -> Option<Self> {
        let ([Reading::Count(from)], Reading::Count(to)) =
            (interval.samples.as_slice(), &interval.end)
        else {
            return None;
        };
        let force = known_force(interval)?;
        let wall = Wall::of(ledger)?;
        let lasts = match interval.dtau {
            Number::Small(n, d) => Length(n, d),
            Number::Tiny(..) | Number::Big(_) => Length::OPEN,
        };
        let quick = Quick::of(&wall).figures([*from, *to], lasts, force);
        quick.or_else(|| {
            let lasts = Ball::of(&interval.dtau);
            Self::bent(&wall, [*from, *to], lasts, force)
        })
    }

    /// Of one between these counts where the wall is [bent](Wall::bend) that lasts so long, under the force in the log
    /// where there is any, with doubles that tell how far off they are.
    pub(crate) fn bent(
        wall: &Wall,
        [from, to]: [i64; 2],
        lasts: Ball,
        force: Option<Ball>,
    ) -> Option<Self> {
        let of = Interval {
            start: Ball::whole(from),
            end: Ball::whole(to),
            lasts,
            force: force.unwrap_or(Ball::zero()),
        };
        let bend = wall.bend([of.start, of.end])?;
        let walls = (&wall.frictions, &wall.criteria);
        let how = (wall.friction_is_exact, force.is_some());
        Self::of(&Row::bent(walls, &of, &bend, how)?, to.checked_sub(from)?)
    }

    /// Of a row that crosses so many ticks; `None` where doubles leave something open.
    pub(crate) fn of(row: &Row<Ball>, crossed: i64) -> Option<Self> {
        let grid = |[lo, hi]: [Ball; 2]| between(lo, hi);
        let covers = |[lo, hi]: [Ball; 2]| Some([lo.is_nonnegative()?, hi.is_nonnegative()?]);
        let ([linear, quantized], [net, net_quantized]) = (row.generated, row.net);
        Some(Self {
            sums: [
                grid(linear)?,
                grid(quantized)?,
                grid(row.taken)?,
                grid(net)?,
                grid(net_quantized)?,
            ],
            observed: (-row.work).on_grid()?[0],
            own: grid(row.own)?,
            excess: row.excess.on_grid()?,
            stored: grid(row.stored)?,
            truths: truths(
                [covers(row.margin)?, covers(net)?, covers(net_quantized)?],
                crossed,
            ),
            crossed,
        })
    }

    /// What the interval adds to an account.
    pub(crate) const fn addend(&self) -> Addend {
        // Balls on the grid are below 2³⁶ KΔ², so all of it fits.
        Addend {
            sums: self.sums,
            observed: self.observed,
            potential: self.stored,
            truths: self.truths,
        }
    }

    /// What it adds to T.
    pub(crate) fn contribution(&self) -> Contribution {
        let advance = Reduced::Small(self.crossed.into(), 1);
        Contribution::counted(self.own, self.excess, advance, self.stored)
    }
}

/// What a row answers that crosses so many ticks: whether the margin of the criterion and net energy against the wall and
/// against its quantized form are not negative at the least and at the most.
pub(crate) fn truths([margin, net, quantized]: [[bool; 2]; 3], crossed: i64) -> Truths {
    let [holds, linear, quantized] = [margin, net, quantized].map(|[lo, hi]| Truth::over(lo, hi));
    Truths {
        // Had nothing moved, it would hold.
        criterion_holds: match holds {
            Truth::Fails if crossed.unsigned_abs() <= 1 => Truth::Depends,
            holds => holds,
        },
        violates_linear: not(linear),
        violates_quantized: not(quantized),
    }
}
