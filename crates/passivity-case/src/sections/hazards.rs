//! The hazards for the operator, and what the criterion says about each.

use passivity_core::{BigRational, Region};
use passivity_scene::check::{Report, Verdict};

use crate::case::Case;
use crate::document::{Document, Row};

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "hazards", "Hazards");
    document.say(
        "The hazard is energy that the display injects into the operator. A display is passive when \
         at every sampling instant the work that the hand has done so far is at least the energy \
         stored now less the energy stored at the start: then the hand can never draw more than was \
         stored. How much harm an injected energy does depends on the device and its use, and is \
         not judged here.",
    );
    for study in &case.studies {
        let report = study.report();
        let rows = vec![
            divergence(report),
            oscillation(report),
            single(report),
            outside(report),
        ];
        let caption = format!("Hazards of «{}»", study.name());
        let columns = [
            ("Hazard", 22),
            ("How it shows", 28),
            ("What the criterion says of it here", 50),
        ];
        document.table(&caption, &columns, rows);
    }
}

/// What is said where some values within the tolerances exclude a hazard, or may, and others do not.
const DEPENDS: &str = "It depends on where in their tolerances the parameters are.";

/// The critical speed, after `of`.
fn speed(report: &Report) -> String {
    let speed = report.critical_speed_text();
    speed.map_or_else(String::new, |speed| format!(" of {speed}"))
}

fn row(hazard: &str, shows: &str, here: String) -> Row {
    [hazard.into(), shows.into(), here.into()].into()
}

/// Energy of the zero-order hold, which grows with the square of the speed.
fn divergence(report: &Report) -> Row {
    let here = match report.region {
        _ if report.verdict == Verdict::NotCovered => not_covered(),
        None => divergence_over_tolerances(report).to_owned(),
        Some(Region::GloballyStable) => {
            "Excluded: viscous friction covers what the hold generates at every speed.".to_owned()
        }
        Some(Region::LimitCycles) => {
            "Excluded above the critical speed: viscous friction covers the hold; growth ends there."
                .to_owned()
        }
        Some(Region::LocallyStable) => format!(
            "Excluded up to the critical speed{}; above it the hold generates more than friction \
             dissipates. {}",
            speed(report),
            match (report.verdict, &report.speed_bound) {
                (_, None) => "Nothing bounds the speed, so it is not excluded.",
                (Verdict::Passive, Some(_)) => "It is the bound on the speed that excludes it.",
                (Verdict::Depends, Some(_)) =>
                    "Whether the bound on the speed excludes it depends on the tolerances.",
                (_, Some(_)) => "The bound on the speed is too high to exclude it.",
            }
        ),
        Some(Region::Unstable) => {
            "Not excluded: viscous friction does not cover what the hold generates.".to_owned()
        }
    };
    row(
        "Divergence",
        "The motion grows until the device hits its stops or the drive saturates.",
        here,
    )
}

/// What holds of divergence for every value within the tolerances, where they reach into several regions.
fn divergence_over_tolerances(report: &Report) -> &'static str {
    let viscous = &report.spare.viscous;
    let zero = BigRational::default();
    match (report.verdict, &report.speed_bound) {
        // The criterion holds up to the bound, whatever the values.
        (Verdict::Passive, _) => {
            "Excluded up to the bound on the speed, for every value within the tolerances; for some the hold \
             generates more above it than friction dissipates. It is the bound on the speed that excludes it."
        }
        _ if *viscous.lo() > zero => {
            "Excluded at high speeds, for every value within the tolerances: viscous friction covers the hold; \
             growth ends there."
        }
        (_, None) if *viscous.hi() < zero => {
            "Not excluded for any value within the tolerances: viscous friction does not cover what the hold \
             generates at high speeds, and nothing bounds the speed."
        }
        (Verdict::NotPassive | Verdict::NotGuaranteed, Some(_)) if *viscous.hi() < zero => {
            "Not excluded for any value within the tolerances: viscous friction does not cover what the hold \
             generates, and the bound on the speed does not exclude it."
        }
        _ => DEPENDS,
    }
}

/// Energy of the quantizer, which grows with the distance.
fn oscillation(report: &Report) -> Row {
    let here = match report.region {
        _ if report.verdict == Verdict::NotCovered => not_covered(),
        _ if report.sigma.is_none() => {
            "The scene has no encoder, and no quantization to sustain one.".to_owned()
        }
        None => oscillation_over_tolerances(report).to_owned(),
        Some(Region::GloballyStable | Region::LocallyStable) => {
            "Excluded at small speeds: Coulomb friction covers what the quantizer generates."
                .to_owned()
        }
        Some(Region::LimitCycles) => format!(
            "Not excluded: below the critical speed{} the quantizer generates more than friction \
             dissipates.",
            speed(report)
        ),
        Some(Region::Unstable) => {
            "Not excluded: Coulomb friction does not cover what the quantizer generates.".to_owned()
        }
    };
    row(
        "Sustained oscillation",
        "The device vibrates within a few ticks of the wall.",
        here,
    )
}

/// What holds of it for every value within the tolerances, where they reach into several regions.
fn oscillation_over_tolerances(report: &Report) -> &'static str {
    let coulomb = &report.spare.coulomb;
    let zero = BigRational::default();
    if report.verdict == Verdict::Passive || *coulomb.lo() > zero {
        "Excluded at small speeds, for every value within the tolerances: Coulomb friction covers what the \
         quantizer generates."
    } else if *coulomb.hi() < zero {
        "Not excluded for any value within the tolerances: at small speeds the quantizer generates more than \
         friction dissipates."
    } else {
        DEPENDS
    }
}

fn single(report: &Report) -> Row {
    let here = match report.verdict {
        Verdict::Passive if report.sigma.is_none() => {
            "Excluded: measured by the linear spring a motion yields nothing.".to_owned()
        }
        Verdict::Passive => {
            "Bounded: measured by the paper's quantized spring a motion may seem to yield up to 1/8 \
             KΔ² once, not each time; by the linear spring it yields nothing."
                .to_owned()
        }
        Verdict::NotPassive => {
            "Present: the witness gains energy each time round, as often as it is repeated.".to_owned()
        }
        Verdict::NotCovered => not_covered(),
        Verdict::NotGuaranteed | Verdict::Depends => "Not excluded.".to_owned(),
    };
    row(
        "Energy from a few contacts",
        "A push that is stronger out than in.",
        here,
    )
}

fn outside(report: &Report) -> Row {
    let here = if report.not_covered.is_empty() {
        "Not covered by the criterion. The limits of this case list what to look for.".to_owned()
    } else {
        let words: Vec<&str> = report
            .not_covered
            .iter()
            .map(|effect| effect.words())
            .collect();
        format!("Present and not covered: {}.", words.join("; "))
    };
    row(
        "Effects outside the model",
        "Any of the above although the criterion holds.",
        here,
    )
}

fn not_covered() -> String {
    "No statement: the scene has an effect that no theorem covers.".to_owned()
}
