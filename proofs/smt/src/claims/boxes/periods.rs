//! Boxes whose sampling period pulls both ways, behind an encoder with virtual damping.

use passivity_core::verdict::Speeds;
use passivity_core::{Criterion, Interval, Loop, Parameter, Scalar as _, Truth, stiffness};
use passivity_terms::{Term, paths};

use super::{DAMPED, allowed, interval, loop_of, within};
use crate::Query;
use crate::claims::words::{n, v};
use crate::formula::{
    Formula, all, any, eq, ge, le, lt, nonnegative, not, on_every_path, positive,
};

/// A box in which every parameter has a tolerance, and a loop in it.
fn box_and_member(with: &[Parameter]) -> (Loop<Interval<Term>>, Loop<Term>, Vec<Formula>) {
    let of = loop_of(with, |_, letter| interval(letter));
    let member = loop_of(with, |_, letter| v(letter));
    let mut premises = allowed(&of.map(|_, interval| interval.lo().clone()));
    for (parameter, x) in member.given() {
        premises.extend(
            of.get(parameter)
                .into_iter()
                .flat_map(|range| within(x, range)),
        );
    }
    (of, member, premises)
}

/// Where the period pulls both ways: damping behind an encoder.
pub(super) fn corners() -> Vec<Query> {
    let (of, member, premises) = box_and_member(&DAMPED);
    let [worst, best] = of.criteria();
    let criterion = member.criterion();
    let between = |[least, x, most]: [&Term; 3]| all([ge(x, least), ge(most, x)]);
    let viscous = [&worst.viscous, &criterion.viscous, &best.viscous];
    // The corners by the letters: least friction, most of all else, and the period as it hurts.
    let corner = |friction: u8, load: u8, period: u8| {
        loop_of(&DAMPED, |parameter, letter| {
            let end = match parameter {
                Parameter::Viscous | Parameter::Coulomb => friction,
                Parameter::Period => period,
                _ => load,
            };
            v(&format!("{letter}{end}"))
        })
        .criterion()
    };
    let corners = |hardest: [&Criterion<Term>; 2], easiest: [&Criterion<Term>; 2]| {
        all([
            eq(&worst.viscous, &hardest[0].viscous),
            eq(&worst.coulomb, &hardest[1].coulomb),
            eq(&best.viscous, &easiest[0].viscous),
            eq(&best.coulomb, &easiest[1].coulomb),
        ])
    };
    let hardest = [&corner(0, 1, 1), &corner(0, 1, 0)];
    let easiest = [&corner(1, 0, 0), &corner(1, 0, 1)];
    let swapped = |[least, x, most]: [&Term; 3]| between([most, x, least]);
    // One loop, its period anywhere between two ends, in units in which K, Δ and the speed are one.
    let in_units = loop_of(&DAMPED, |parameter, letter| match parameter {
        Parameter::Stiffness | Parameter::Resolution => n(1),
        _ => v(letter),
    });
    let speed = n(1);
    let in_units = Loop {
        force_step: None,
        ..in_units
    };
    let range = interval("T");
    let of_periods = in_units
        .map(|_, x| Interval::point(x.clone()))
        .with(Parameter::Period, range.clone());
    let at = |period: &Term| in_units.clone().with(Parameter::Period, period.clone());
    let margin = |the_loop: &Loop<Term>| the_loop.criterion().margin(&speed);
    let at_member = at(&v("T"));
    let [longest, shortest] = of_periods.hardest();
    let least = |f: &dyn Fn(&Loop<Term>) -> Term| f(&longest).min(f(&shortest));
    let near_rest = |the_loop: &Loop<Term>| the_loop.criterion().coulomb;
    let in_range = [positive(range.lo())]
        .into_iter()
        .chain(within(&v("T"), &range));
    let period_premises: Vec<Formula> = allowed(&at_member).into_iter().chain(in_range).collect();
    let everywhere = all([
        le(&least(&margin), &margin(&at_member)),
        le(&least(&near_rest), &near_rest(&at_member)),
    ]);
    let up_to = |the_loop: &Loop<Term>| {
        all([
            nonnegative(&near_rest(the_loop)),
            nonnegative(&margin(the_loop)),
        ])
    };
    let always = |the_loop: &Loop<Term>| {
        let Criterion { viscous, coulomb } = the_loop.criterion();
        all([nonnegative(&viscous), nonnegative(&coulomb)])
    };
    let near = stiffness::shortest_period(&at_member).unwrap_or_else(|| n(0));
    let peak = stiffness::best_period_at_speed(&at_member, &speed);
    let closer = v("T1");
    let told = |period: &Term, holds: &dyn Fn(&Loop<Term>) -> Formula| {
        let [above, below] = within(period, &range);
        all([above, below, holds(&at(period))])
    };
    let ends =
        |holds: &dyn Fn(&Loop<Term>) -> Formula| any(of_periods.easiest().each_ref().map(holds));
    vec![
        Query::new(
            "TH-REGION",
            "box criteria viscous",
            "every loop of a box has a viscous coefficient between those of its two criteria",
        )
        .given(premises.clone())
        .then(between(viscous))
        .but_not("not with the two taken for each other", swapped(viscous)),
        Query::new(
            "TH-REGION",
            "box corners",
            "each coefficient of the two criteria is that of a loop of the box, with the period where it hurts or helps it",
        )
        .given(premises)
        .then(corners(hardest, easiest))
        .but_not("not with one period for both", corners([hardest[0], hardest[0]], easiest)),
        Query::new(
            "TH-REGION",
            "hardest periods",
            "at a speed and near rest, no period between two is harder than both of them",
        )
        .given(period_premises.clone())
        .then(everywhere)
        .but_not("the longest alone is not the hardest", le(&margin(&longest), &margin(&at_member))),
        Query::new(
            "TH-REGION",
            "telling periods",
            "if a period between two meets the criterion at every speed, one of them does, or the shortest that is enough near rest",
        )
        .given(period_premises.clone())
        .given([always(&at_member)])
        .then(any([ends(&always), told(&near, &always)]))
        .but_not("not always one of the two", ends(&always)),
        Query::new(
            "TH-REGION",
            "towards the best period from below",
            "where a period meets the criterion up to a speed, each longer one does up to the best at the speed",
        )
        .given(allowed(&at_member))
        .given([ge(&closer, &v("T")), le(&closer, &peak), up_to(&at_member)])
        .then(up_to(&at(&closer)))
        .but_not("nor does one need to have met it", not(up_to(&at_member))),
        Query::new(
            "TH-REGION",
            "towards the best period from above",
            "where a period meets the criterion up to a speed, each shorter one does down to the best at the speed, as long as it is enough near rest",
        )
        .given(allowed(&at_member))
        .given([positive(&closer), le(&closer, &v("T")), ge(&closer, &peak), up_to(&at_member)])
        .given([nonnegative(&near_rest(&at(&closer)))])
        .then(up_to(&at(&closer)))
        .not_without("not if it is not enough near rest", 1),
    ]
}

/// `decide` over periods from `shortest` to `longest` where they pull both ways, on numbers for which
/// those that meet the criterion are known: the stretch between `from` and `to`.
fn pulled(
    part: &'static str,
    [viscous, coulomb, damping]: [Term; 3],
    speeds: &Speeds<Interval<Term>>,
    [from, to]: [Term; 2],
    [shortest, longest]: [Term; 2],
) -> Query {
    let ends = interval("T");
    let renamed = ends.map(|end| {
        if end == ends.lo() {
            shortest.clone()
        } else {
            longest.clone()
        }
    });
    let of = Loop {
        viscous: Some(viscous),
        coulomb: Some(coulomb),
        resolution: Some(n(1)),
        damping: Some(damping),
        ..Loop::new(n(1), n(1))
    };
    let of = of
        .map(|_, x| Interval::point(x.clone()))
        .with(Parameter::Period, renamed);
    let found = paths::of(|| of.decide(speeds));
    let all_meet = all([ge(&shortest, &from), le(&longest, &to)]);
    let none_meets = any([lt(&longest, &from), lt(&to, &shortest)]);
    let meaning = |truth: &Option<Truth>| match truth {
        Some(Truth::Holds) => all_meet.clone(),
        Some(Truth::Fails) => none_meets.clone(),
        Some(Truth::Depends) => all([not(all_meet.clone()), not(none_meets.clone())]),
        None => Formula::Any(vec![]),
    };
    let never_depends = |truth: &Option<Truth>| match truth {
        Some(Truth::Depends) => none_meets.clone(),
        other => meaning(other),
    };
    Query::new(
        "TH-REGION",
        part,
        "where the period pulls both ways, holds is said of all periods, fails of none, and it depends where some meet the criterion",
    )
    .given([positive(&shortest), le(&shortest, &longest)])
    .then(on_every_path(&found, meaning))
    .but_not("some meet it where neither end does", on_every_path(&found, never_depends))
}

/// The stretch of periods that meet the criterion, entered from below and left above.
pub(super) fn decided() -> Vec<Query> {
    let ratio = |n, d| Term::fraction(n, d);
    // b − B − T/2 ≥ 0 up to T = 6/5, and c − ½ − B/T ≥ 0 from T = 1 on.
    let always = || [ratio(7, 10), ratio(3, 5), ratio(1, 10)];
    let stretch = || [n(1), ratio(6, 5)];
    // T·margin = −½(T − ½)(T − 3/2) at V = 1; near rest T = 3/8 is enough.
    let bounded = || [ratio(3, 8), ratio(3, 2), ratio(3, 8)];
    let up_to_one = Speeds::UpTo(Interval::point(n(1)));
    let bounded_stretch = || [ratio(1, 2), ratio(3, 2)];
    let (short, long) = ([ratio(1, 4), v("T1")], [v("T0"), n(2)]);
    vec![
        pulled(
            "box of longest period with damping",
            always(),
            &Speeds::All,
            stretch(),
            short.clone(),
        ),
        pulled(
            "box of shortest period with damping",
            always(),
            &Speeds::All,
            stretch(),
            long.clone(),
        ),
        pulled(
            "box of longest period with damping up to a speed",
            bounded(),
            &up_to_one,
            bounded_stretch(),
            short,
        ),
        pulled(
            "box of shortest period with damping up to a speed",
            bounded(),
            &up_to_one,
            bounded_stretch(),
            long,
        ),
    ]
}
