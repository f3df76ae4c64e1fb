//! The picture of an identification: measured beside simulated, what is left between them, and the
//! parameters that fit.

use passivity_core::Parameter;
use passivity_plot::PlotError;
use passivity_plot::frame::Frame;
use passivity_plot::svg::{Anchor, BLACK, COLOURS, DARK, LIGHT, Pixel, Stroke, Svg, rectangle};
use passivity_scene::Motion;
use passivity_scene::check::unit_of;
use passivity_scene::plane::Extent;

use crate::estimate::residuals;
use crate::identified::Identified;
use crate::kept::Propagators;
use crate::log::Log;
use crate::motion::simulated;
use crate::region::{COULOMB, Ends, Part, VISCOUS};
use crate::report::nearest;

const SIZE: [f64; 2] = [1240.0, 700.0];
/// About how many points of a log are drawn.
const POINTS: usize = 600;

impl Identified {
    /// Draws the motion, the residuals and the set of frictions that fit, as SVG text.
    ///
    /// # Errors
    ///
    /// [`PlotError`] where there is nothing that can be drawn.
    pub fn picture(&self, title: &str) -> Result<String, PlotError> {
        let mut svg = Svg::new(SIZE);
        svg.title(26.0, 18.0, title);
        self.draw_motion(&mut svg)?;
        self.draw_residuals(&mut svg)?;
        self.draw_set(&mut svg)?;
        Ok(svg.finish())
    }

    fn times(&self, log: &Log) -> Vec<f64> {
        log.times()
            .into_iter()
            .map(|time| time * self.period)
            .collect()
    }

    fn time_axis(&self) -> Extent {
        let ends = self
            .logs
            .iter()
            .filter_map(|log| self.times(log).last().copied());
        Extent {
            from: 0.0,
            to: ends.fold(f64::MIN_POSITIVE, f64::max),
            log: false,
        }
    }

    fn time_words(&self) -> &'static str {
        match self.motion {
            Motion::Dimensionless => "time in sampling periods",
            _ => "time in s",
        }
    }

    /// Positions from where each log starts.
    fn draw_motion(&self, svg: &mut Svg) -> Result<(), PlotError> {
        let measured: Vec<Vec<f64>> = self.logs.iter().map(from_start).collect();
        let frame = Frame {
            x: self.time_axis(),
            y: extent(measured.iter().flatten().copied())?,
            from: [90.0, 50.0],
            to: [720.0, 390.0],
        };
        let corners = self.found.hull.map(|[b, c, m]| {
            let middle = |[lo, hi]: Ends| 0.5 * lo + 0.5 * hi;
            [[b[0], c[0], middle(m)], [b[1], c[1], middle(m)]]
        });
        for ((log, measured), colour) in self.logs.iter().zip(&measured).zip(COLOURS.iter().cycle())
        {
            let times = self.times(log);
            let every = log.len().div_ceil(POINTS);
            for (time, x) in times.iter().zip(measured).step_by(every) {
                svg.disc(
                    frame.clamped([*time, *x]),
                    1.8,
                    LIGHT,
                    Stroke::solid(LIGHT, 0.5),
                );
            }
            let way = |at: [f64; 3]| simulated(log, at, &mut Propagators::default());
            let mut curve = |ways: &[f64], offset: f64, stroke: Stroke<'_>| {
                let places = times.iter().zip(ways).step_by(every);
                let places = places.map(|(time, way)| [*time, way + offset]);
                let seen = places.take_while(|place| frame.contains(*place));
                let seen: Vec<Pixel> = seen.map(|place| frame.pixel(place)).collect();
                svg.line(&seen, stroke);
            };
            // The device of either corner starts where the measured one did; the best estimate where it fits best.
            for at in corners.iter().flatten() {
                curve(&way(*at), 0.0, Stroke::dashed(DARK, 1.0));
            }
            if let Some(best) = self.best {
                let ways = way(best);
                let offset = mean(measured.iter().zip(&ways).map(|(x, y)| x - y));
                curve(&ways, offset, Stroke::solid(colour, 1.6));
            }
        }
        if let Some(refuted) = &self.refuted_by {
            let [from, to] = [frame.y.from, frame.y.to].map(|y| frame.clamped([refuted.time, y]));
            svg.line(&[from, to], Stroke::dashed(BLACK, 1.5));
            let words = "up to here nothing fits";
            let place = [from[0] + 6.0, from[1] - 8.0];
            svg.text_over(place, 13.0, Anchor::Start, words, BLACK);
        }
        frame.draw(
            svg,
            [self.time_words(), "position from the first sample in ticks"],
        );
        let words = match self.best {
            Some(_) => {
                "grey: measured; line: best estimate, moved to fit; dashed: least and most friction of the box"
            }
            None => "grey: measured",
        };
        svg.text([100.0, 44.0], 12.0, Anchor::Start, words);
        Ok(())
    }

    /// What was measured less the best estimate.
    fn draw_residuals(&self, svg: &mut Svg) -> Result<(), PlotError> {
        let Some(best) = self.best else {
            return Ok(());
        };
        let width = self.logs.iter().filter_map(|log| log.positions.first());
        let half = width.map(|[lo, hi]| 0.5 * (hi - lo)).fold(0.5, f64::max);
        let band = [-half, half];
        let of = |log: &Log| within(residuals(log, best), half);
        let all: Vec<Vec<f64>> = self.logs.iter().map(of).collect();
        let frame = Frame {
            x: self.time_axis(),
            y: extent(all.iter().flatten().copied().chain(band))?,
            from: [90.0, 460.0],
            to: [720.0, 640.0],
        };
        for y in band {
            let line = [frame.x.from, frame.x.to].map(|x| frame.clamped([x, y]));
            svg.line(&line, Stroke::dashed(DARK, 1.0));
        }
        for ((log, residuals), colour) in self.logs.iter().zip(&all).zip(COLOURS.iter().cycle()) {
            let times = self.times(log);
            let points = times
                .iter()
                .zip(residuals)
                .step_by(log.len().div_ceil(POINTS));
            for (time, residual) in points {
                svg.disc(
                    frame.clamped([*time, *residual]),
                    1.5,
                    colour,
                    Stroke::solid(colour, 0.5),
                );
            }
        }
        frame.draw(svg, [self.time_words(), "residual in ticks"]);
        let words = "measured less best estimate; dashed: the tick and the error of a count";
        svg.text([100.0, 454.0], 12.0, Anchor::Start, words);
        Ok(())
    }

    /// The parts that are left, the box and the best estimate.
    fn draw_set(&self, svg: &mut Svg) -> Result<(), PlotError> {
        let [left, right, top, bottom] = [860.0, 1200.0, 80.0, 480.0];
        let (Some(hull), Some(best)) = (self.found.hull, self.best) else {
            let words = match self.refuted_by {
                Some(_) => "no viscous and Coulomb friction fit",
                None => "the device does not surely move",
            };
            let middle = [0.5 * (left + right), 0.5 * (top + bottom)];
            svg.text(middle, 15.0, Anchor::Middle, words);
            return Ok(());
        };
        let scale = |dimension: usize| {
            let [lo, hi] = self.units.get(dimension).copied().unwrap_or([1.0; 2]);
            0.5 * lo + 0.5 * hi
        };
        let [kt, kd] = [scale(VISCOUS), scale(COULOMB)];
        let [b, c, _] = hull;
        let [viscous, coulomb, _] = best;
        let mut said = self.parameters.iter().map(|(_, bounds)| bounds.best);
        let axes = [
            (Parameter::Viscous, b, kt, viscous),
            (Parameter::Coulomb, c, kd, coulomb),
        ];
        let axes = axes.map(|(parameter, ends, si, best)| {
            let said = said.next().flatten().unwrap_or(best * si);
            Axis::of(parameter, ends, si, [best, said], self.motion)
        });
        let [x, y] = &axes;
        let frame = Frame {
            x: extent(b.into_iter().map(|b| x.shown(b)))?,
            y: extent(c.into_iter().map(|c| y.shown(c)))?,
            from: [left, top],
            to: [right, bottom],
        };
        let place = |[b, c]: [f64; 2]| frame.clamped([x.shown(b), y.shown(c)]);
        for part in &self.found.parts {
            let outline: Vec<Pixel> = self.outline(part).into_iter().map(place).collect();
            svg.area(&outline, "#9ecae1");
        }
        let mut edge = rectangle(place([b[0], c[1]]), place([b[1], c[0]])).to_vec();
        edge.extend(edge.first().copied());
        svg.line(&edge, Stroke::solid(BLACK, 1.5));
        svg.disc(
            place([viscous, coulomb]),
            5.0,
            COLOURS[1],
            Stroke::solid(BLACK, 1.0),
        );
        frame.draw(svg, [&x.words, &y.words]);
        svg.text(
            [left, top - 26.0],
            12.0,
            Anchor::Start,
            "blue: what is not refuted; frame: the box that holds it;",
        );
        svg.text(
            [left, top - 10.0],
            12.0,
            Anchor::Start,
            match self.best_refuted {
                true => "disc: best estimate, which the logs refute",
                false => "disc: best estimate",
            },
        );
        Ok(())
    }

    /// The outline of a part in b and c.
    fn outline(&self, part: &Part) -> Vec<[f64; 2]> {
        let near = |[lo, hi]: Ends| 0.5 * lo + 0.5 * hi;
        let corners = self.shear.corners(part).into_iter().map(|corner| {
            let r = near(corner.mobility);
            [near(corner.viscous) / r, near(corner.coulomb) / r].map(|x| x.max(0.0))
        });
        hull(corners.collect())
    }
}

/// An axis of the set of frictions.
struct Axis {
    words: String,
    /// What is taken away from a value, and what one of the rest is shown as.
    origin: f64,
    factor: f64,
}

impl Axis {
    /// Of a parameter between `ends`: in per cent from the best estimate, where it is known so well that its
    /// digits would not tell; the estimate is given in SI units too.
    fn of(
        parameter: Parameter,
        ends: Ends,
        si: f64,
        [best, said]: [f64; 2],
        motion: Motion,
    ) -> Self {
        let name = parameter.row().name;
        let unit = match (unit_of(parameter, motion), parameter) {
            ("", Parameter::Viscous) => "KT",
            ("", _) => "KΔ",
            (unit, _) => unit,
        };
        if ends[1] - ends[0] > 0.01 * best {
            return Self {
                words: format!("{name} in {unit}"),
                origin: 0.0,
                factor: si,
            };
        }
        Self {
            words: format!("{name}, % from {} {unit}", nearest(said)),
            origin: best,
            factor: 100.0 / best,
        }
    }

    fn shown(&self, x: f64) -> f64 {
        (x - self.origin) * self.factor
    }
}

/// The convex hull of places, going around.
fn hull(mut places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let half = |places: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut found: Vec<[f64; 2]> = Vec::new();
        for place in places {
            while let [.., a, b] = found.as_slice() {
                let turn = (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]);
                if turn > 0.0 {
                    break;
                }
                found.pop();
            }
            found.push(place);
        }
        found.pop();
        found
    };
    let mut around = half(&mut places.iter().copied());
    around.extend(half(&mut places.iter().rev().copied()));
    around
}

/// Residuals from where the device can have started: moved as little as lets them all be within a band, where they can be.
fn within(mut residuals: Vec<f64>, half: f64) -> Vec<f64> {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    let fold = |[lo, hi]: [f64; 2], x: &f64| [lo.min(*x), hi.max(*x)];
    let [lo, hi] = residuals.iter().fold(ends, fold);
    let (least, most) = (-half - lo, half - hi);
    let by = match least <= most {
        true => 0.0_f64.max(least).min(most),
        false => 0.5 * (least + most),
    };
    residuals.iter_mut().for_each(|residual| *residual += by);
    residuals
}

/// Positions from the first sample on.
fn from_start(log: &Log) -> Vec<f64> {
    let middles: Vec<f64> = log.middles().collect();
    let first = middles.first().copied().unwrap_or_default();
    middles.into_iter().map(|x| x - first).collect()
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    sum / count
}

/// An axis over values, with some room.
fn extent(values: impl Iterator<Item = f64>) -> Result<Extent, PlotError> {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    let [lo, hi] = values.fold(ends, |[lo, hi], x| [lo.min(x), hi.max(x)]);
    if !(lo.is_finite() && hi.is_finite()) {
        return Err(PlotError::new("there is nothing finite to draw"));
    }
    let room = (0.06 * (hi - lo))
        .max(1e-6 * hi.abs().max(lo.abs()))
        .max(f64::MIN_POSITIVE);
    Ok(Extent {
        from: lo - room,
        to: hi + room,
        log: false,
    })
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn residuals_that_fit_a_band_are_drawn_within_it() {
        assert_eq!(within(vec![-1.25, 1.75, 0.0], 1.5), [-1.5, 1.5, -0.25]);
        assert_eq!(within(vec![-1.0, 1.25], 1.5), [-1.0, 1.25]);
        assert_eq!(within(vec![-1.75, 1.0, 0.0], 1.5), [-1.5, 1.25, 0.25]);
        // Where they do not fit, as far out on both sides.
        assert_eq!(within(vec![-1.0, 3.0], 1.5), [-2.0, 2.0]);
    }
}
