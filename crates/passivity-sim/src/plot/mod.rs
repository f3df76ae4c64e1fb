//! Pictures of motions, sweeps and accuracy, as SVG text; `passivity_plot::save` writes them.

pub mod accuracy;
pub mod motion;
pub mod sweep;

use passivity_plot::PlotError;
use plotters::prelude::*;

/// Okabe and Ito's palette: told apart by colour-blind readers too.
pub(crate) const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(140, 100, 0),
    RGBColor(90, 90, 90),
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

/// A label of an axis over `range`: no more digits than needed.
pub(crate) fn label(x: f64, range: &std::ops::Range<f64>) -> String {
    if x == 0.0 || x.abs() < 1e-9 * (range.end - range.start) {
        return "0".to_owned(); // What rounding left of it.
    }
    let (text, exponent) = if (1e-4..1e6).contains(&x.abs()) {
        (format!("{x:.7}"), None)
    } else {
        let text = format!("{x:.3e}");
        match text.split_once('e') {
            Some((digits, exponent)) => (digits.to_owned(), Some(exponent.to_owned())),
            None => (text, None),
        }
    };
    let digits = text.trim_end_matches('0').trim_end_matches('.');
    exponent.map_or_else(|| digits.to_owned(), |e| format!("{digits}e{e}"))
}

/// A range with some air around it, never empty: around a single value so much as `about` says.
pub(crate) fn padded(
    values: impl Iterator<Item = f64>,
    about: impl Fn(f64) -> f64,
) -> std::ops::Range<f64> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for x in values.filter(|x| x.is_finite()) {
        low = low.min(x);
        high = high.max(x);
    }
    if low > high {
        return -1.0..1.0;
    }
    if low == high {
        let air = about(low);
        return low - air..high + air;
    }
    let air = (0.06 * (high - low))
        .max(1e-6 * high.abs().max(low.abs()))
        .max(1e-9);
    low - air..high + air
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn labels_have_no_idle_digits() {
        let wide = 0.0..50_000.0;
        for (x, text) in [
            (10_000.0, "10000"),
            (0.5, "0.5"),
            (0.1 + 0.2, "0.3"),
            (-2.0, "-2"),
        ] {
            assert_eq!(label(x, &wide), text);
        }
        assert_eq!(label(1.4e-17, &(-1.0..1.0)), "0");
        assert_eq!(label(0.0, &(0.0..0.0)), "0");
        assert_eq!(label(1.5e-7, &(0.0..1e-6)), "1.5e-7");
        assert_eq!(label(2e9, &(0.0..1e10)), "2e9");
    }
}
