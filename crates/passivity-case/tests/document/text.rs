//! The sentences of a case, scene by scene.

use passivity_case::gsn::{Argument, Kind};
use passivity_case::records::Strength;
use passivity_case::{Case, Study};
use passivity_core::BigRational;
use passivity_evidence::Freshness;
use passivity_scene::check::Verdict;

use crate::{case, dimensionless, page, shipped, study};

const SHIPPED: [&str; 16] = [
    "amplifier-lag.toml",
    "devices/smartknob.toml",
    "digital-controller.toml",
    "dimensionless-corner.toml",
    "dimensionless.toml",
    "every-covered-effect.toml",
    "filtered-damping.toml",
    "phantom-premium.toml",
    "re35-globally-stable.toml",
    "re35-limit-cycles.toml",
    "re35-locally-stable-too-fast.toml",
    "re35-locally-stable.toml",
    "re35-unstable.toml",
    "re35.toml",
    "tolerance-straddling.toml",
    "tolerances.toml",
];

const SMOOTH: &str = "[device]\nmass = \"50 kg\"\nviscous = \"1 N s/m\"\n[sampling]\nperiod = \"1 s\"\n\
                      [wall]\nstiffness = \"1 N/m\"\n[start]\nposition = \"1 m\"\n";

fn cases() -> impl Iterator<Item = Case> {
    SHIPPED.into_iter().map(|name| case(shipped(name)))
}

fn only(case: &Case) -> (&Study, &Argument) {
    case.scenes().next().expect("a scene")
}

/// The counter goal says that the criterion fails at some of the speeds asked for, and it does, at the end
/// of the tolerances at which it is met most easily; at others it may hold.
#[test]
fn where_the_criterion_is_challenged_it_fails_at_some_speed() {
    let mut holds_at_another = 0;
    for case in cases() {
        let (study, argument) = only(&case);
        let report = study.report();
        let fails = matches!(report.verdict, Verdict::NotPassive | Verdict::NotGuaranteed);
        let Some(counter) = argument.node("CG-criterion") else {
            assert!(!fails, "{}", study.name());
            continue;
        };
        assert!(fails, "{}", study.name());
        let says = format!(
            "The criterion does not hold {}: at some of them it fails, whatever the values within the \
             tolerances.",
            study.speeds()
        );
        assert_eq!(counter.text, says);
        let criterion = study.criterion();
        let (viscous, coulomb) = (criterion.viscous.hi(), criterion.coulomb.hi());
        let zero = BigRational::default();
        let fastest = report
            .speed_bound_si
            .as_ref()
            .or(report.speed_bound.as_ref());
        let fails_fast = match fastest {
            Some(v) => viscous * v.hi() + coulomb < zero,
            None => *viscous < zero,
        };
        assert!(*coulomb < zero || fails_fast, "{}", study.name());
        holds_at_another += usize::from(*viscous > zero || *coulomb > zero);
    }
    assert!(
        holds_at_another > 0,
        "that it fails at every speed would be false"
    );
}

/// What leads from the file to the criterion, and from the criterion to the verdict, is cited.
#[test]
fn the_criterion_rests_on_what_links_it_to_the_verdict() {
    for (study, units, bound) in [
        (dimensionless("3/5", "3/5", ""), false, false),
        (dimensionless("2/5", "2/5", ""), false, false),
        (shipped("re35.toml"), true, true),
        (shipped("re35-limit-cycles.toml"), true, false),
        // It holds at every speed: the bound is not what it rests on.
        (
            dimensionless("3/5", "3/5", "[operator]\nmax_speed = \"3\"\n"),
            false,
            false,
        ),
    ] {
        let case = case(study);
        let (study, argument) = only(&case);
        let goal = argument.node("G-criterion").expect("the goal");
        for (id, is_cited) in [
            ("EQ-1..7", units),
            ("EQ-28", bound),
            ("TH-REGION", true),
            ("TH-CHECK", true),
            ("CHECK-VERDICT", true),
        ] {
            let cited = goal.supported_by.contains(&format!("G-{id}"));
            assert_eq!(cited, is_cited, "{}: {id}", study.name());
        }
    }
}

/// A counterexample rests on friction taking no more than the scene allows, whichever theorem it is of.
#[test]
fn a_counterexample_names_what_it_assumes() {
    for name in ["re35-limit-cycles.toml", "devices/smartknob.toml"] {
        let case = case(shipped(name));
        let (_, argument) = only(&case);
        let counter = argument.node("CG-cycle").expect("a counterexample");
        let assumed = &counter.in_context_of;
        assert!(
            assumed.contains(&"A-FRICTION-AT-MOST".to_owned()),
            "{name}: {assumed:?}"
        );
        let node = argument.node("A-FRICTION-AT-MOST").expect("the assumption");
        assert_eq!(node.kind, Kind::Assumption);
        let page = page(&case);
        let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("{name}: {text}"));
        let row = at("id=\"assumption-A-FRICTION-AT-MOST\"");
        let first = at("Assumptions that this case stands on");
        assert!(first < row && row < at("Assumptions that only other claims are made under"));
    }
    let case = case(dimensionless("3/5", "3/5", ""));
    assert_eq!(only(&case).1.node("A-FRICTION-AT-MOST"), None);
}

#[test]
fn hazards_are_said_to_be_excluded_only_where_they_are() {
    let bounded = |v: &str| {
        let operator = format!("[operator]\nmax_speed = \"{v}\"\n");
        // v_c = 1.
        dimensionless("2/5", "3/5", &operator)
    };
    let excludes = "It is the bound on the speed that excludes it.";
    for (study, says) in [
        (shipped("re35.toml"), excludes),
        (bounded("1"), excludes),
        (
            bounded("2"),
            "The bound on the speed is too high to exclude it.",
        ),
        (
            bounded("1 ± 1/2"),
            "Whether the bound on the speed excludes it depends on the tolerances.",
        ),
        (
            shipped("re35-locally-stable.toml"),
            "Nothing bounds the speed, so it is not excluded.",
        ),
    ] {
        let name = study.report().headline();
        let page = page(&case(study));
        assert!(page.contains(says), "{name}");
        assert_eq!(page.contains(excludes), says == excludes, "{name}");
    }
    let smooth = page(&case(study(SMOOTH)));
    assert!(smooth.contains("Excluded: measured by the linear spring a motion yields nothing."));
    // There is no Δ, and so no energy in its units.
    let (_, caption) = smooth
        .split_once("is the energy ledger, ")
        .expect("a caption");
    let (caption, _) = caption.split_once("in every interval").expect("its end");
    assert_eq!(
        (caption.matches(" J ").count(), caption.matches('Δ').count()),
        (3, 0),
        "{caption}"
    );
}

/// What the tolerances leave open is said to be open, and nothing else.
#[test]
fn hazards_that_no_value_within_the_tolerances_has_are_excluded() {
    let every = "for every value within the tolerances";
    let any = "Not excluded for any value within the tolerances";
    let depends = "It depends on where in their tolerances the parameters are.";
    let bounded = "[operator]\nmax_speed = \"1\"\n";
    let by_bound = format!("Excluded up to the bound on the speed, {every}");
    let at_high = format!("Excluded at high speeds, {every}");
    let at_small = format!("Excluded at small speeds, {every}");
    for (study, divergence, oscillation) in [
        // The bound of 1 is below the least critical speed, 0.2/0.1.
        (
            dimensionless("2/5 … 3/5", "7/10", bounded),
            by_bound.as_str(),
            at_small.as_str(),
        ),
        (
            shipped("tolerance-straddling.toml"),
            depends,
            at_small.as_str(),
        ),
        (
            dimensionless("3/5", "2/5 … 3/5", ""),
            at_high.as_str(),
            depends,
        ),
        (dimensionless("2/5", "2/5 … 3/5", ""), any, depends),
        (dimensionless("2/5 … 3/5", "2/5", ""), depends, any),
        // For no value does the bound exclude it: the largest critical speed is 1/2.
        (dimensionless("3/10", "2/5 … 3/5", bounded), any, depends),
        // For some it does.
        (
            dimensionless("2/5", "2/5 … 7/10", bounded),
            depends,
            depends,
        ),
        (
            dimensionless("2/5 … 3/5", "2/5 … 3/5", ""),
            depends,
            depends,
        ),
    ] {
        let name = study.report().headline();
        assert_eq!(study.report().region, None, "{name}");
        let page = page(&case(study));
        let (_, table) = page.split_once("Divergence</th>").expect("a row");
        let (first, rest) = table
            .split_once("Sustained oscillation</th>")
            .expect("a row");
        let (second, _) = rest.split_once("</tr>").expect("its end");
        assert!(first.contains(divergence), "{name}: {first}");
        assert!(second.contains(oscillation), "{name}: {second}");
    }
}

#[test]
fn what_does_not_apply_is_said_in_the_words_of_check() {
    for (name, says) in [
        (
            "devices/smartknob.toml",
            "does not apply: a digital controller",
        ),
        (
            "amplifier-lag.toml",
            "does not apply: first-order lag of the amplifier",
        ),
    ] {
        let study = shipped(name);
        assert!(study.report().to_text().contains(says), "{name}");
        let page = page(&case(study));
        assert!(
            page.contains(says) && !page.contains("to a loop with a delay"),
            "{name}"
        );
    }
}

#[test]
fn the_limits_are_those_of_the_assumptions() {
    let page = page(&case(shipped("re35.toml")));
    // More static friction only helps: Sec. IV-B, A-FRICTION.
    assert!(!page.contains("friction that changes with speed"));
    assert!(page.contains("takes nothing from a verdict that the wall is passive (A-FRICTION)"));
    assert!(
        page.contains("anything about motions faster than 3 rad/s."),
        "{page}"
    );
}

/// A claim that tests have only sampled is not counted with those that a machine has proved.
#[test]
fn claims_are_counted_by_what_shows_them() {
    let mut case = case(dimensionless("3/5", "3/5", ""));
    let records = &mut case.records;
    for (id, strength) in [
        ("TH-LIN", Strength::AllReals),
        ("TH-START", Strength::InPart),
        ("NUM-EXACT", Strength::Exhausted),
        ("CHECK-VERDICT", Strength::Sampled),
        ("TH-IDENT", Strength::Sampled),
    ] {
        for assessed in &mut records.assessed {
            if assessed.claim == id && assessed.record.is_some() {
                assessed.freshness = Freshness::Fresh;
            }
        }
        records
            .assessed
            .retain(|a| a.claim != id || a.freshness == Freshness::Fresh);
        assert_eq!(records.strength(id), Some(strength), "{id}");
    }
    records
        .assessed
        .retain(|assessed| assessed.claim != "TH-RUN");
    assert_eq!(records.strength("TH-RUN"), None);
    let page = page(&case);
    let claims = &case.records.claims.claims;
    let (_, counted) = page
        .split_once(&format!("Of {} claims: ", claims.len()))
        .expect("the count");
    let (counted, _) = counted.split_once(", by ").expect("its end");
    let numbers = counted
        .split(", ")
        .filter_map(|part| part.split(' ').next()?.parse::<usize>().ok());
    assert_eq!(numbers.sum::<usize>(), claims.len(), "{counted}");
    for says in [
        Strength::AllReals.words(),
        Strength::Sampled.words(),
        "not shown",
    ] {
        assert!(counted.contains(says), "{counted}");
    }
    assert!(!page.contains("claims are shown"));
}
