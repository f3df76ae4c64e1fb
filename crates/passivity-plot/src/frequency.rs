//! What a linear loop costs of β at each frequency, against the β that there is (TH-LTI).

use passivity_scene::Scene;
use passivity_scene::check::Report;
use passivity_scene::explain::Frequency;
use passivity_scene::number::nearest_f64;
use plotters::prelude::*;

use crate::PlotError;

const SIZE: (u32, u32) = (900, 520);
const POINTS: u32 = 600;
/// How far below half the sampling rate the picture begins.
const DECADES: f64 = 3.0;

/// What the picture is about: the verdict counts Coulomb friction and bounds on the speed too.
const SCOPE: &str = "Where λ ≤ β viscous friction suffices at every speed; Coulomb friction and bounds on the \
                     speed are not in this picture";

const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const SHORT: RGBColor = RGBColor(246, 214, 214);

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
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        let drawn = draw_on(&root, report, &frequency);
        drawn.map_err(|error| PlotError::new(format!("frequency: {error}")))?;
        root.present()
            .map_err(|error| PlotError::new(format!("frequency: {error}")))?;
    }
    Ok(svg)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

fn draw_on(
    root: &Area<'_>,
    report: &Report,
    frequency: &Frequency,
) -> Result<(), Box<dyn std::error::Error>> {
    root.fill(&WHITE)?;
    let beta = nearest_f64(report.beta.lo());
    let highest = frequency.highest();
    let at = |i: u32| {
        let share = f64::from(i) / f64::from(POINTS) - 1.0;
        let f = highest * 10.0_f64.powf(DECADES * share);
        (f, frequency.at(f))
    };
    let curve: Vec<(f64, f64)> = (0..=POINTS).map(at).collect();
    let reach = |of: fn(f64, f64) -> f64| curve.iter().fold(beta, |most, (_, y)| of(most, *y));
    let (low, high) = (reach(f64::min).min(0.0), reach(f64::max));
    let room = 0.08 * (high - low).max(1e-6);
    let start = curve.first().map_or(highest, |(f, _)| *f);
    let (name, unit) = (&report.scene, frequency.unit());
    let title = format!("{name}: what each frequency asks of viscous friction, β");
    let below = root
        .margin(10, 0, 0, 0)
        .titled(&title, ("sans-serif", 18))?
        .titled(SCOPE, ("sans-serif", 14))?;
    let mut chart = ChartBuilder::on(&below)
        .margin(14)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((start..highest).log_scale(), low - room..high + room)?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .x_desc(format!("frequency [{unit}], to half the sampling rate"))
        .y_desc("λ, β [KT]")
        .draw()?;
    let floor = low - room;
    let shaded = curve.windows(2).filter_map(|pair| match pair {
        [(f0, y0), (f1, y1)] if *y0 > beta || *y1 > beta => Some(Rectangle::new(
            [(*f0, floor), (*f1, high + room)],
            SHORT.filled(),
        )),
        _ => None,
    });
    chart.draw_series(shaded)?;
    chart
        .draw_series(LineSeries::new(curve, BLUE.stroke_width(2)))?
        .label("λ, what the loop costs of β")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 22, y)], BLUE.stroke_width(2)));
    let line = [(start, beta), (highest, beta)];
    chart
        .draw_series(LineSeries::new(line, VERMILION.stroke_width(2)))?
        .label(format!(
            "β = {}",
            passivity_scene::display::range(&report.beta)
        ))
        .legend(|(x, y)| PathElement::new([(x, y), (x + 22, y)], VERMILION.stroke_width(2)));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    Ok(())
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
        }
        Ok(())
    }
}
