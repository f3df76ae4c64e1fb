//! What `passivity simulate` says of a motion to people.

use passivity_scene::display::{Rounding, outward, significant};
use passivity_scene::{Point, Scene};
use passivity_sim::report::{Simulation, taken};
use passivity_sim::scales::{Scale, Scales};
use passivity_sim::{Beyond, Detail, ExactOutcome, Method, Plan, Simulated};

use super::words;

/// Which method decides of a sample on which side of an edge it is, of those that the effects of these points allow.
pub(crate) fn deciding(points: &[Point]) -> &'static str {
    let takes = |method: Method| {
        points
            .iter()
            .map(move |point| method.unsupported(point).is_empty())
    };
    let takes_all = |method: Method| takes(method).all(|takes| takes);
    match [Method::Exact, Method::Enclosure].map(takes_all) {
        [true, _] => "`--method exact` decides",
        [false, true] if takes(Method::Exact).any(|takes| takes) => {
            "`--method exact` decides of points with β = 0, and of the others `--method enclosure`, but not of a sample \
             that is exactly on the edge"
        }
        [false, true] => {
            "`--method enclosure` decides, but of a sample that is exactly on the edge no method does"
        }
        [false, false] => {
            "of more digits (`--method reference:60`) more is to be believed, and no method decides"
        }
    }
}

/// The motion in words.
pub(super) fn text(
    report: &Simulation,
    plan: &Plan,
    run: &Simulated,
    beyond: Beyond,
    scene: &Scene,
) -> String {
    let (end, totals) = (&run.end, &report.totals);
    let scales = Scales::of(scene);
    let effects: Vec<&str> = plan.effects().iter().map(|effect| effect.words()).collect();
    let [xi, velocity] = plan.start();
    let at = end
        .outcome
        .at_interval
        .map_or_else(String::new, |h| format!(" (interval {h})"));
    let took = report
        .seconds
        .map_or_else(String::new, |s| format!(" in {s:.3} s"));
    let mut lines = vec![
        format!("{}: {}{at}", report.scene, words(end.outcome.exact)),
        format!("  {}", end.outcome.because),
    ];
    if let Some(h) = end.within_rounding_of_edge {
        lines.push(format!(
            "  sample {h} is within rounding of {}, and the motion from there on may be another one: {}",
            plan.edge_words(),
            deciding(&[scene.point()])
        ));
    }
    lines.extend([
        format!("  start       {}", state(xi, velocity, &scales)),
        format!(
            "  by the paper's detector (|ξ̇| < 0.01 at the end): {}",
            end.outcome.paper.name().replace('_', " ")
        ),
        format!(
            "  method      {}, {} interval{}{took}",
            report.method_parameter,
            end.intervals,
            if end.intervals == 1 { "" } else { "s" },
        ),
        format!("  effects     {}", effects.join(", ")),
    ]);
    let nominal =
        taken(scene, plan).map(|(_, given)| format!("{} {}", given.key, given.nominal_text()));
    let starts = std::iter::once("  nominal     ").chain(std::iter::repeat(INDENT));
    lines.extend(
        starts
            .zip(nominal)
            .map(|(start, line)| format!("{start}{line}")),
    );
    lines.extend([format!(
        "  end         {}",
        state(end.xi, end.velocity, &scales)
    )]);
    lines.extend(detail(&run.detail));
    let energies = |unit: f64, name: &str| {
        let [linear, quantized, dissipated] = [
            totals.generated_linear,
            totals.generated_quantized,
            totals.dissipated,
        ]
        .map(|energy| significant(energy * unit));
        format!(
            "generated {linear} (linear spring), {quantized} (quantized spring), dissipated {dissipated} {name}"
        )
    };
    let joule = &scales.energy;
    let both = [
        scales.ticks.then(|| energies(1.0, "KΔ²")),
        scales.si.then(|| energies(joule.one, &joule.unit)),
    ];
    for (line, start) in both.into_iter().flatten().zip(["  energy      ", INDENT]) {
        lines.push(format!("{start}{line}"));
    }
    if end.intervals == 0 && end.outcome.exact == ExactOutcome::AtRest {
        lines.push(
            "  the device starts at rest and does not move; --speed sets a speed at the start"
                .to_owned(),
        );
    }
    let more = match beyond {
        Beyond::Nothing => "the run ends where that is certain",
        Beyond::Tenfold => "the run ends where it has grown tenfold",
        Beyond::All => "",
    };
    if end.outcome.exact == ExactOutcome::Growing && !more.is_empty() {
        lines.push(format!("  {more}; --intervals goes on"));
    }
    let (unit, name) = match scales.ticks {
        true => (1.0, "KΔ²"),
        false => (joule.one, joule.unit.as_str()),
    };
    lines.push(format!(
        "  balance     (13) holds in every interval to {:.1e} {name}",
        totals.residual_max * unit
    ));
    lines.join("\n")
}

/// What stands before a line that goes on.
const INDENT: &str = "              ";

/// A position and a velocity: in ticks where the scene has any, in its units where it has units.
fn state(xi: f64, velocity: f64, scales: &Scales) -> String {
    let in_ticks = scales.ticks.then(|| {
        let of = |x: f64| if x.abs() == 1.0 { "tick" } else { "ticks" };
        format!(
            "ξ = {xi} {}, ξ̇ = {velocity} {}/sample",
            of(xi),
            of(velocity)
        )
    });
    let in_units = scales.si.then(|| {
        let shown =
            |x: f64, scale: &Scale| format!("{} {}", significant(x * scale.one), scale.unit);
        let [x, v] = [
            shown(xi, &scales.position),
            shown(velocity, &scales.velocity),
        ];
        format!("x = {x}, v = {v}")
    });
    let both: Vec<String> = in_ticks.into_iter().chain(in_units).collect();
    both.join(&format!("\n{INDENT}"))
}

/// The state at the end in the method's own numbers.
fn detail(detail: &Detail) -> Vec<String> {
    match detail {
        Detail::None => Vec::new(),
        Detail::Exact([xi, v]) | Detail::Digits([xi, v]) => {
            vec![format!("{INDENT}ξ = {xi}"), format!("{INDENT}ξ̇ = {v}")]
        }
        Detail::Enclosed {
            ends: [[xi_lo, xi_hi], [v_lo, v_hi]],
            bits,
        } => vec![
            format!("{INDENT}ξ in {}", within([xi_lo, xi_hi])),
            format!(
                "{INDENT}ξ̇ in {}, by numbers of {bits} bits",
                within([v_lo, v_hi])
            ),
        ],
    }
}

/// An enclosure in words.
fn within([lo, hi]: [&f64; 2]) -> String {
    let [lo, hi] = [outward(*lo, Rounding::Down), outward(*hi, Rounding::Up)];
    format!("[{lo}, {hi}]")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_methods_that_take_the_scene_are_said_to_decide() {
        let of = |viscous: &str, arm: &str| {
            let text = format!(
                "[device]\ninertia = \"1 kg\"\nviscous = \"{viscous} N s/m\"\ncoulomb = \"1 N\"\n\
                 [sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N/m\"\n\
                 [encoder]\nresolution = \"1 mm\"\n{arm}"
            );
            Scene::from_toml("scene", &text).unwrap().point()
        };
        let arm =
            "[operator]\narm = { mass = \"1 kg\", damping = \"1 N s/m\", stiffness = \"1 N/m\" }\n";
        let enclosed = "`--method enclosure` decides, but of a sample that is exactly on the edge no method does";
        assert_eq!(deciding(&[of("1", "")]), enclosed);
        assert_eq!(deciding(&[of("0", "")]), "`--method exact` decides");
        // Of a sweep, a method that takes some of the points only decides none of the others.
        let of_both = deciding(&[of("0", ""), of("1", "")]);
        assert!(
            of_both.starts_with("`--method exact` decides of points with β = 0, and of the others")
        );
        assert!(deciding(&[of("0", arm)]).ends_with("no method decides"));
    }
}
