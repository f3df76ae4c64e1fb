//! What a linear loop costs of β at each frequency, against the β that there is (TH-LTI).

use passivity_scene::Scene;
use passivity_scene::check::Report;
use passivity_scene::explain::Frequency;
use passivity_scene::number::nearest_f64;
use passivity_scene::plane::Extent;

use crate::PlotError;
use crate::frame::{Frame, key};
use crate::svg::{Anchor, COLOURS, Stroke, Svg, rectangle};

const SIZE: [f64; 2] = [900.0, 520.0];
const POINTS: u32 = 600;
/// How far below half the sampling rate the picture begins.
const DECADES: f64 = 3.0;

/// What the picture is about: the verdict counts Coulomb friction and bounds on the speed too.
const SCOPE: &str = "Where λ ≤ β viscous friction suffices at every speed; Coulomb friction and bounds on the \
                     speed are not in this picture";

/// Where β is short.
const SHORT: &str = "#f6d6d6";

/// Draws λ(f) of a scene up to half the sampling rate, as SVG text.
///
/// Where the curve is above the line of β, shaded, a wave of that frequency draws energy if it is
/// large enough; the least β of the tolerances counts.
///
/// # Errors
///
/// A scene of which no frequency speaks: behind a one-sided or saturated wall, a latency or an
/// amplifier.
pub fn draw(scene: &Scene, report: &Report) -> Result<String, PlotError> {
    let Some(frequency) = Frequency::of(scene) else {
        return Err(PlotError::new(
            "frequency: expected a linear loop: a wall on both sides without saturation, latency \
             and amplifier, and a controller and a delay of at most 24 samples together",
        ));
    };
    let beta = nearest_f64(report.beta.lo());
    let highest = frequency.highest();
    let at = |i: u32| {
        let share = f64::from(i) / f64::from(POINTS) - 1.0;
        let f = highest * 10.0_f64.powf(DECADES * share);
        [f, frequency.at(f)]
    };
    let curve: Vec<[f64; 2]> = (0..=POINTS).map(at).collect();
    let reach = |of: fn(f64, f64) -> f64| curve.iter().fold(beta, |most, [_, y]| of(most, *y));
    let (low, high) = (reach(f64::min).min(0.0), reach(f64::max));
    let room = 0.08 * (high - low).max(1e-6);
    if !(low.is_finite() && high.is_finite()) {
        return Err(PlotError::new("frequency: the curve has no finite values"));
    }
    let extent = |from, to, log| Extent { from, to, log };
    let frame = Frame {
        x: extent(highest * 10.0_f64.powf(-DECADES), highest, true),
        y: extent(low - room, high + room, false),
        from: [86.0, 96.0],
        to: [870.0, 456.0],
    };
    let mut svg = Svg::new(SIZE);
    let title = format!(
        "{}: what each frequency asks of viscous friction, β",
        report.scene
    );
    let middle = 0.5 * SIZE[0];
    svg.title(28.0, 18.0, &title);
    svg.text([middle, 50.0], 13.0, Anchor::Middle, SCOPE);
    let [loop_line, beta_line] = [COLOURS[0], COLOURS[1]].map(|colour| Stroke::solid(colour, 2.0));
    let given = format!("β = {}", passivity_scene::display::range(&report.beta));
    // Above the frame, where no curve is.
    let keys = [
        (loop_line, "λ, what the loop costs of β"),
        (beta_line, &given),
    ];
    key(&mut svg, [frame.from[0], 76.0], &keys);
    for pair in curve.windows(2) {
        if let [[f0, y0], [f1, y1]] = *pair
            && (y0 > beta || y1 > beta)
        {
            let corners = [[f0, frame.y.from], [f1, frame.y.to]].map(|place| frame.clamped(place));
            svg.cell(&rectangle(corners[0], corners[1]), SHORT);
        }
    }
    let line: Vec<_> = curve.iter().map(|place| frame.clamped(*place)).collect();
    svg.line(&line, loop_line);
    let ends = [frame.x.from, frame.x.to].map(|f| frame.clamped([f, beta]));
    svg.line(&ends, beta_line);
    let unit = frequency.unit();
    let words = format!("frequency ({unit}), to half the sampling rate");
    frame.draw(&mut svg, [&words, "λ, β (KT)"]);
    Ok(svg.finish())
}

#[cfg(test)]
mod tests {
    /// Of two scenes with enough viscous friction, and the verdicts one and the other way.
    #[test]
    fn the_picture_says_what_it_leaves_out() -> Result<(), Box<dyn std::error::Error>> {
        use passivity_scene::{Scene, check};
        for (sigma, verdict) in [
            ("1", check::Verdict::Passive),
            ("0.1", check::Verdict::NotPassive),
        ] {
            let text = format!("[dimensionless]\nbeta = \"1\"\nsigma = \"{sigma}\"\n");
            let scene = Scene::from_toml("plain", &text)?;
            let report = check::check(&scene);
            assert_eq!(report.verdict, verdict);
            let svg = super::draw(&scene, &report)?;
            for part in [
                "plain: what each frequency asks of viscous friction",
                super::SCOPE,
            ] {
                assert!(svg.contains(part), "{part}\n{svg}");
            }
            assert!(!svg.contains("passive"), "{svg}");
            // The key is above the frame, whose upper edge is at 96.
            let key = svg
                .lines()
                .find(|line| line.contains("what the loop costs"));
            let key = key.and_then(|line| line.split(" y=\"").nth(1)?.split('"').next());
            assert!(key.ok_or("no key")?.parse::<f64>()? < 90.0, "{svg}");
        }
        Ok(())
    }
}
