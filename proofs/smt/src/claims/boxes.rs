//! Boxes of loops: which end of each tolerance is the hard one, and what the verdict on a box says of
//! the loops in it.

use passivity_core::verdict::{End, Speeds};
use passivity_core::{
    Criterion, Friction, Interval, Loop, Parameter, Region, Scalar as _, Truth, stiffness,
};
use passivity_terms::{Term, paths};

use super::words::{n, v};
use crate::Query;
use crate::formula::{
    Formula, all, any, eq, ge, iff, le, lt, nonnegative, not, on_every_path, positive,
};

pub(super) fn queries() -> Vec<Query> {
    [
        directions(),
        periods(),
        verdicts(),
        both_ways_decided(),
        regions(),
    ]
    .concat()
}

/// Everything that the criterion is made of, by the letters of the equations.
const LETTERS: [(Parameter, &str); 7] = [
    (Parameter::Stiffness, "K"),
    (Parameter::Period, "T"),
    (Parameter::Viscous, "b"),
    (Parameter::Coulomb, "c"),
    (Parameter::Resolution, "Delta"),
    (Parameter::Damping, "B"),
    (Parameter::ForceStep, "F"),
];

/// A loop with one sample of delay and the parameters asked for, each what `of` says.
fn loop_of<V>(with: &[Parameter], of: impl Fn(Parameter, &str) -> V) -> Loop<V> {
    let letter = |parameter: Parameter| {
        let found = LETTERS.iter().find(|(other, _)| *other == parameter);
        of(parameter, found.map_or("unknown", |(_, letter)| letter))
    };
    let start = Loop {
        delay: 1,
        ..Loop::new(letter(Parameter::Stiffness), letter(Parameter::Period))
    };
    let given = with.iter().copied();
    given.fold(start, |the_loop, parameter| {
        the_loop.with(parameter, letter(parameter))
    })
}

/// The interval between the variables `name0` and `name1`.
fn interval(name: &str) -> Interval<Term> {
    Term::interval(&format!("{name}0"), &format!("{name}1"))
}

/// That `x` is in the interval.
fn within(x: &Term, interval: &Interval<Term>) -> [Formula; 2] {
    [le(interval.lo(), x), le(x, interval.hi())]
}

/// That the loop has numbers which the table of parameters allows.
fn allowed(the_loop: &Loop<Term>) -> Vec<Formula> {
    let sign = |(parameter, x): (Parameter, &Term)| {
        use passivity_core::parameter::Values::{Any, NonNegative, Positive};
        match parameter.row().values {
            Positive => Some(positive(x)),
            NonNegative => Some(nonnegative(x)),
            Any => None,
        }
    };
    the_loop.given().filter_map(sign).collect()
}

/// Everything but virtual damping: no period pulls both ways.
const UNDAMPED: [Parameter; 4] = [
    Parameter::Viscous,
    Parameter::Coulomb,
    Parameter::Resolution,
    Parameter::ForceStep,
];

/// Friction and an encoder alone.
const PLAIN: [Parameter; 3] = [
    Parameter::Viscous,
    Parameter::Coulomb,
    Parameter::Resolution,
];

/// Everything.
const DAMPED: [Parameter; 5] = [
    Parameter::Viscous,
    Parameter::Coulomb,
    Parameter::Resolution,
    Parameter::ForceStep,
    Parameter::Damping,
];

fn no_harder(a: &Criterion<Term>, b: &Criterion<Term>) -> Formula {
    all([ge(&a.viscous, &b.viscous), ge(&a.coulomb, &b.coulomb)])
}

/// Each parameter of the table by name: the criterion is hardest at the end that the table says.
fn directions() -> Vec<Query> {
    let says = "wherever it is in its tolerance, the criterion is no easier than at the easiest end and no harder than at the hardest";
    let direction = |parameter: Parameter, part: &'static str, with: &[Parameter]| {
        let letter = |_: Parameter, letter: &str| v(letter);
        let member = loop_of(with, letter);
        let x = member.get(parameter).cloned().unwrap_or_else(|| n(0));
        let range = interval("x");
        let at = |end: End| {
            let x = end.of(parameter, &range).clone();
            member.clone().with(parameter, x).criterion()
        };
        let (hardest, easiest) = (at(End::Hardest), at(End::Easiest));
        let criterion = member.criterion();
        Query::new("TH-REGION", part, says)
            .given(allowed(&member))
            .given([positive(range.lo())])
            .given(within(&x, &range))
            .then(all([
                no_harder(&criterion, &hardest),
                no_harder(&easiest, &criterion),
            ]))
            .but_not(
                "not with the ends taken for each other",
                all([
                    no_harder(&criterion, &easiest),
                    no_harder(&hardest, &criterion),
                ]),
            )
    };
    let criterion = Criterion {
        viscous: v("viscous"),
        coulomb: v("coulomb"),
    };
    let range = interval("V");
    let at = |end: End| match Speeds::UpTo(range.clone()).at(end) {
        Speeds::UpTo(bound) => criterion.margin_up_to(&bound),
        Speeds::All | Speeds::UpToSquared(_) => n(0),
    };
    let (hardest, easiest) = (at(End::Hardest), at(End::Easiest));
    let between = criterion.margin_up_to(&v("V"));
    let ends = [&hardest, &easiest];
    let order = |[least, most]: [&Term; 2]| all([le(least, &between), le(&between, most)]);
    vec![
        direction(Parameter::Stiffness, "direction of stiffness", &DAMPED),
        direction(Parameter::Period, "direction of period", &UNDAMPED),
        both_ways(),
        direction(Parameter::Viscous, "direction of viscous friction", &DAMPED),
        direction(Parameter::Coulomb, "direction of coulomb friction", &DAMPED),
        direction(Parameter::Resolution, "direction of resolution", &DAMPED),
        direction(Parameter::Damping, "direction of damping", &DAMPED),
        direction(Parameter::ForceStep, "direction of force step", &DAMPED),
        Query::new("TH-REGION", "direction of speed bound", says)
            .given([positive(range.lo())])
            .given(within(&v("V"), &range))
            .then(order(ends))
            .but_not(
                "not with the ends taken for each other",
                order([ends[1], ends[0]]),
            ),
    ]
}

/// With damping behind an encoder a longer period helps Coulomb friction.
fn both_ways() -> Query {
    let member = loop_of(&DAMPED, |_, letter| v(letter));
    let slower = member.clone().with(Parameter::Period, v("T1")).criterion();
    let criterion = member.criterion();
    let longer = |coulomb| all([le(&slower.viscous, &criterion.viscous), coulomb]);
    Query::new(
        "TH-REGION",
        "direction of period with damping",
        "a longer period makes it harder for viscous friction and easier for Coulomb friction",
    )
    .given(allowed(&member))
    .given([ge(&v("T1"), &v("T"))])
    .then(longer(ge(&slower.coulomb, &criterion.coulomb)))
    .but_not(
        "not harder for both",
        longer(le(&slower.coulomb, &criterion.coulomb)),
    )
}

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
fn periods() -> Vec<Query> {
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

/// The criterion of a loop up to a speed, or at every speed: as `decide` is asked, what a yes means at
/// a speed v, and what a no means.
struct Asked {
    speeds: Speeds<Interval<Term>>,
    bound: Option<Term>,
}

impl Asked {
    fn always() -> Self {
        Self {
            speeds: Speeds::All,
            bound: None,
        }
    }

    fn up_to(range: Interval<Term>, bound: Term) -> Self {
        Self {
            speeds: Speeds::UpTo(range),
            bound: Some(bound),
        }
    }

    /// That `v` is a speed that was asked for.
    fn at(&self) -> Vec<Formula> {
        let bound = self.bound.as_ref().map(|bound| le(&v("v"), bound));
        bound.into_iter().chain([positive(&v("v"))]).collect()
    }

    fn holds(criterion: &Criterion<Term>) -> Formula {
        nonnegative(&criterion.margin(&v("v")))
    }

    /// That the criterion fails at some of the speeds: at the highest, or near rest.
    fn fails(&self, criterion: &Criterion<Term>) -> Formula {
        let Criterion { viscous, coulomb } = criterion;
        match &self.bound {
            Some(bound) => any([
                lt(&criterion.margin(bound), &n(0)),
                lt(coulomb, &n(0)),
                all([eq(coulomb, &n(0)), lt(viscous, &n(0))]),
            ]),
            None => any([lt(viscous, &n(0)), lt(coulomb, &n(0))]),
        }
    }
}

/// `decide` over a box with one tolerance, by the name of its parameter.
fn verdicts() -> Vec<Query> {
    let says = "holds is said for every value in the tolerance, fails for none, and it depends only where the ends differ";
    let decided = |parameter: Parameter, part: &'static str, with: &[Parameter], asked: Asked| {
        // In units of K, but where K itself has the tolerance.
        let member = loop_of(with, |other, letter| match other {
            Parameter::Stiffness if parameter != Parameter::Stiffness => n(1),
            _ => v(letter),
        });
        let x = member.get(parameter).cloned().unwrap_or_else(|| n(0));
        let range = interval("x");
        let of = member
            .map(|_, x| Interval::point(x.clone()))
            .with(parameter, range.clone());
        let found = paths::of(|| of.decide(&asked.speeds));
        let criterion = member.criterion();
        let at = |end: &Term| member.clone().with(parameter, end.clone()).criterion();
        let (low, high) = (at(range.lo()), at(range.hi()));
        let meaning = |truth: &Option<Truth>| match truth {
            Some(Truth::Holds) => Asked::holds(&criterion),
            Some(Truth::Fails) => asked.fails(&criterion),
            Some(Truth::Depends) => any([
                all([asked.fails(&low), not(asked.fails(&high))]),
                all([asked.fails(&high), not(asked.fails(&low))]),
            ]),
            None => Formula::Any(vec![]),
        };
        Query::new("TH-REGION", part, says)
            .given(allowed(&member))
            .given([positive(range.lo())])
            .given(within(&x, &range))
            .given(asked.bound.iter().map(positive))
            .given(asked.at())
            .then(on_every_path(&found, meaning))
            .but_not(
                "holds is not said of what holds anywhere",
                on_every_path(&found, |truth| match truth {
                    Some(Truth::Holds) => Formula::All(vec![]),
                    _ => asked.fails(&criterion),
                }),
            )
    };
    let point = || Asked::up_to(Interval::point(v("V")), v("V"));
    let smooth = [Parameter::Viscous, Parameter::Coulomb, Parameter::Damping];
    use Parameter::{Coulomb, Damping, ForceStep, Period, Resolution, Stiffness, Viscous};
    let mut all = vec![
        decided(Stiffness, "box of stiffness", &PLAIN, Asked::always()),
        decided(Period, "box of period", &PLAIN, Asked::always()),
        decided(Viscous, "box of viscous friction", &PLAIN, Asked::always()),
        decided(Coulomb, "box of coulomb friction", &PLAIN, Asked::always()),
        decided(Resolution, "box of resolution", &PLAIN, Asked::always()),
        decided(Damping, "box of damping", &smooth, Asked::always()),
        decided(ForceStep, "box of force step", &UNDAMPED, Asked::always()),
        decided(Stiffness, "box of stiffness up to a speed", &PLAIN, point()),
        decided(Period, "box of period up to a speed", &PLAIN, point()),
        decided(
            Viscous,
            "box of viscous friction up to a speed",
            &PLAIN,
            point(),
        ),
        decided(
            Coulomb,
            "box of coulomb friction up to a speed",
            &PLAIN,
            point(),
        ),
        decided(
            Resolution,
            "box of resolution up to a speed",
            &PLAIN,
            point(),
        ),
        decided(Damping, "box of damping up to a speed", &smooth, point()),
        decided(
            ForceStep,
            "box of force step up to a speed",
            &UNDAMPED,
            point(),
        ),
    ];
    all.push(speed_bound());
    all
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
fn both_ways_decided() -> Vec<Query> {
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

/// `decide` where only the bound on the speed has a tolerance.
fn speed_bound() -> Query {
    let range = interval("V");
    let asked = Asked::up_to(range.clone(), v("V"));
    let plain = Loop::plain(Friction::new(v("beta"), v("sigma")));
    let criterion = plain.criterion();
    let of = plain.map(|_, x| Interval::point(x.clone()));
    let found = paths::of(|| of.decide(&asked.speeds));
    let fails_up_to = |bound: &Term| Asked::up_to(range.clone(), bound.clone()).fails(&criterion);
    let meaning = |truth: &Option<Truth>| match truth {
        Some(Truth::Holds) => Asked::holds(&criterion),
        Some(Truth::Fails) => asked.fails(&criterion),
        Some(Truth::Depends) => all([fails_up_to(range.hi()), not(fails_up_to(range.lo()))]),
        None => Formula::Any(vec![]),
    };
    let swapped = |truth: &Option<Truth>| match truth {
        Some(Truth::Depends) => all([fails_up_to(range.lo()), not(fails_up_to(range.hi()))]),
        other => meaning(other),
    };
    Query::new(
        "TH-REGION",
        "box of speed bound",
        "holds is said for every bound in the tolerance, fails for none, and it depends only where the ends differ",
    )
    .given([positive(range.lo())])
    .given(within(&v("V"), &range))
    .given(asked.at())
    .then(on_every_path(&found, meaning))
    .but_not("not with the ends taken for each other", on_every_path(&found, swapped))
}

/// The region of a box of β and σ is that of each of its loops.
fn regions() -> Vec<Query> {
    let (beta, sigma) = (interval("beta"), interval("sigma"));
    let plain = |beta, sigma| Loop {
        viscous: Some(beta),
        coulomb: Some(sigma),
        ..Loop::plain(Friction::new(n(0), n(0)))
    };
    let point = |x: i32| Interval::point(n(x));
    let of = Loop {
        viscous: Some(beta.clone()),
        coulomb: Some(sigma.clone()),
        resolution: Some(point(1)),
        ..Loop::new(point(1), point(1))
    };
    let found = paths::of(|| of.region());
    let criterion = plain(v("beta"), v("sigma")).criterion();
    let Criterion { viscous, coulomb } = &criterion;
    let holds = nonnegative(&criterion.margin(&v("v")));
    let critical = passivity_core::region::critical_speed(&criterion);
    let meaning = |region: &Option<Region>| match region {
        Some(Region::GloballyStable) => holds.clone(),
        Some(Region::Unstable) => not(holds.clone()),
        Some(Region::LocallyStable) => all([
            lt(viscous, &n(0)),
            iff(holds.clone(), le(&v("v"), &critical)),
        ]),
        Some(Region::LimitCycles) => all([
            positive(viscous),
            iff(holds.clone(), ge(&v("v"), &critical)),
        ]),
        None => Formula::All(vec![]),
    };
    let one_sided = |region: &Option<Region>| match region {
        Some(Region::GloballyStable) => positive(coulomb),
        other => meaning(other),
    };
    vec![
        Query::new(
            "TH-REGION",
            "box region",
            "the region of a box is that of every loop in it",
        )
        .given([positive(&v("v"))])
        .given(within(&v("beta"), &beta))
        .given(within(&v("sigma"), &sigma))
        .then(on_every_path(&found, meaning))
        .but_not("the border belongs to it", on_every_path(&found, one_sided)),
    ]
}
