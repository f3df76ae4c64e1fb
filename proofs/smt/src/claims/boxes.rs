//! Boxes of loops: which end of each tolerance is the hard one, and what the verdict on a box says of
//! the loops in it.

mod periods;

use passivity_core::verdict::{End, Speeds};
use passivity_core::{Criterion, Friction, Interval, Loop, Parameter, Region, Truth};
use passivity_terms::{Term, paths};

use super::words::{n, v};
use crate::Query;
use crate::formula::{
    Formula, all, any, eq, ge, iff, le, lt, nonnegative, not, on_every_path, positive,
};

pub(super) fn queries() -> Vec<Query> {
    [
        directions(),
        periods::corners(),
        verdicts(),
        periods::decided(),
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
