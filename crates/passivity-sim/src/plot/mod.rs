//! Pictures of motions, sweeps and accuracy, as SVG text; `passivity_plot::save` writes them.

pub mod accuracy;
pub mod motion;
pub mod sweep;

use passivity_plot::PlotError;
use plotters::prelude::*;

/// Okabe and Ito's palette: told apart by colour-blind readers too.
pub(crate) const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(140, 100, 0),
    RGBColor(90, 90, 90),
    RGBColor(230, 159, 0),
];

pub(crate) type Drawn = Result<(), Box<dyn std::error::Error>>;
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// Draws into SVG text.
pub(crate) fn svg(
    size: (u32, u32),
    what: &str,
    draw: impl FnOnce(&Area<'_>) -> Drawn,
) -> Result<String, PlotError> {
    let fail = |error: &dyn std::fmt::Display| PlotError::new(format!("{what}: {error}"));
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        root.fill(&WHITE).map_err(|error| fail(&error))?;
        draw(&root).map_err(|error| fail(&error))?;
        root.present().map_err(|error| fail(&error))?;
    }
    Ok(text)
}

/// A range with some air around it, never empty.
pub(crate) fn padded(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for x in values.filter(|x| x.is_finite()) {
        low = low.min(x);
        high = high.max(x);
    }
    if low > high {
        return -1.0..1.0;
    }
    let air = (0.06 * (high - low))
        .max(1e-6 * high.abs().max(low.abs()))
        .max(1e-9);
    low - air..high + air
}
