//! A motion: position, velocity and energy against time, with encoder ticks dashed as in Fig. 6, and
//! the phase plane.

use std::collections::VecDeque;

use passivity_plot::PlotError;
use plotters::prelude::*;

use crate::ledger::Entry;
use crate::plot::{Area, COLOURS, DASHED, Drawn, label, padded, svg};

/// A sample of a motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Time in sampling periods.
    pub time: f64,
    /// ξ in ticks.
    pub xi: f64,
    /// ξ̇ in ticks per sample.
    pub velocity: f64,
    /// Σ E_gᴸ, Σ E_g and Σ E_d so far, in KΔ².
    pub energies: [f64; 3],
}

/// The samples of a motion that a picture needs: all of a short one, the extremes of stretches of a
/// long one, in bounded memory.
#[derive(Clone, Debug)]
pub struct Motion {
    samples: Vec<Sample>,
    first: Vec<Sample>,
    last: VecDeque<Sample>,
    stretch: u64,
    pending: Vec<Sample>,
    energies: [f64; 3],
}

/// What is drawn of a sample.
type Key = fn(&Sample) -> f64;

/// The most samples that are kept.
const MOST: usize = 16_384;

/// How many samples of the beginning are all kept, for the phase plane.
const BEGIN: usize = 4_000;

/// The colour of the encoder's edges.
const TICK: RGBColor = RGBColor(150, 150, 150);

/// How many samples the end of a motion has.
const END: usize = 160;

impl Default for Motion {
    /// A motion that starts where its first interval does.
    fn default() -> Self {
        Self {
            samples: Vec::new(),
            first: Vec::new(),
            last: VecDeque::new(),
            stretch: 1,
            pending: Vec::new(),
            energies: [0.0; 3],
        }
    }
}

impl Motion {
    /// A motion from a position in ticks and a velocity in ticks per sample, to be seen even if it has
    /// no interval.
    #[must_use]
    pub fn new([xi, velocity]: [f64; 2]) -> Self {
        let start = Sample {
            xi,
            velocity,
            ..Sample::default()
        };
        Self {
            samples: vec![start],
            ..Self::default()
        }
    }

    /// Takes an interval.
    pub fn add(&mut self, entry: &Entry) {
        if self.samples.is_empty() && self.pending.is_empty() {
            self.samples.push(Sample {
                time: entry.h as f64,
                xi: entry.xi0,
                velocity: entry.v0,
                energies: self.energies,
            });
        }
        let terms = [
            entry.generated_linear,
            entry.generated_quantized,
            entry.dissipated,
        ];
        for (sum, term) in self.energies.iter_mut().zip(terms) {
            *sum += term;
        }
        let sample = Sample {
            time: (entry.h + 1) as f64,
            xi: entry.xi1,
            velocity: entry.v1,
            energies: self.energies,
        };
        self.pending.push(sample);
        if self.first.len() < BEGIN {
            self.first.push(sample);
        }
        if self.last.len() == END {
            self.last.pop_front();
        }
        self.last.push_back(sample);
        if self.pending.len() as u64 >= self.stretch * 4 {
            self.settle();
        }
    }

    /// The samples, in order of time: those of the whole motion, those with all of its beginning, and
    /// all of its end.
    #[must_use]
    pub fn samples(mut self) -> [Vec<Sample>; 3] {
        self.settle();
        let begun = self.first.last().map_or(f64::NEG_INFINITY, |s| s.time);
        let mut path: Vec<Sample> = self.samples.first().copied().into_iter().collect();
        path.extend(self.first);
        path.extend(self.samples.iter().filter(|s| s.time > begun));
        [self.samples, path, self.last.into()]
    }

    /// Keeps the extremes of what is pending, and half of everything when there is too much.
    fn settle(&mut self) {
        thin(&self.pending, self.stretch, &mut self.samples);
        self.pending.clear();
        if self.samples.len() > MOST {
            let mut fewer = Vec::with_capacity(MOST);
            for group in self.samples.chunks(8) {
                thin(group, 2, &mut fewer);
            }
            self.samples = fewer;
            self.stretch *= 2;
        }
    }
}

/// Of a group, the samples with extreme position or velocity, unless `stretch` is 1.
fn thin(group: &[Sample], stretch: u64, kept: &mut Vec<Sample>) {
    if stretch == 1 {
        kept.extend_from_slice(group);
        return;
    }
    let by = |key: fn(&Sample) -> f64| {
        let order = move |a: &&Sample, b: &&Sample| key(a).total_cmp(&key(b));
        [group.iter().min_by(order), group.iter().max_by(order)]
    };
    let mut extremes: Vec<Sample> = by(|s| s.xi)
        .into_iter()
        .chain(by(|s| s.velocity))
        .flatten()
        .copied()
        .collect();
    extremes.sort_by(|a, b| a.time.total_cmp(&b.time));
    extremes.dedup_by(|a, b| a.time == b.time);
    kept.extend(extremes);
}

/// Draws a motion as SVG text.
///
/// # Errors
///
/// A motion that cannot be drawn.
pub fn draw(title: &str, motion: Motion) -> Result<String, PlotError> {
    let [samples, path, mut end] = motion.samples();
    if end.is_empty() {
        end.clone_from(&path); // Nothing moved: the start is the end.
    }
    svg((1200, 860), "motion", |root| {
        panels(root, title, [&samples, &path, &end])
    })
}

fn panels(root: &Area<'_>, title: &str, [samples, path, end]: [&[Sample]; 3]) -> Drawn {
    let root = root.titled(title, ("sans-serif", 20))?;
    let (left, right) = root.split_horizontally(720);
    let rows = left.split_evenly((3, 1));
    let [position, velocity, energy] = rows.as_slice() else {
        return Ok(());
    };
    let time = padded(samples.iter().map(|s| s.time));
    let points = |key: fn(&Sample) -> f64| samples.iter().map(move |s| (s.time, key(s)));
    let panel = |area: &Area<'_>, name: &str, range: std::ops::Range<f64>, ticks: bool| -> Drawn {
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .x_label_area_size(38)
            .y_label_area_size(70)
            .build_cartesian_2d(time.clone(), range.clone())?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("time τ (sampling periods)")
            .y_desc(name)
            .x_label_formatter(&|x| label(*x, &time))
            .y_label_formatter(&|y| label(*y, &range))
            .axis_desc_style(("sans-serif", 15))
            .label_style(("sans-serif", 12))
            .draw()?;
        if ticks {
            for y in encoder_ticks(&range) {
                let line = [(time.start, y), (time.end, y)];
                chart.draw_series(LineSeries::new(line, TICK.mix(DASHED)))?;
            }
            chart.draw_series(LineSeries::new(
                points(|s| s.xi),
                COLOURS[0].stroke_width(2),
            ))?;
            return Ok(());
        }
        if name.starts_with("velocity") {
            let zero = [(time.start, 0.0), (time.end, 0.0)];
            chart.draw_series(LineSeries::new(zero, BLACK.mix(0.4)))?;
            let line = points(|s| s.velocity);
            chart.draw_series(LineSeries::new(line, COLOURS[2].stroke_width(2)))?;
            return Ok(());
        }
        let series: [(&str, Key, RGBColor); 3] = [
            ("generated, linear spring", |s| s.energies[0], COLOURS[1]),
            ("generated, quantized spring", |s| s.energies[1], BLACK),
            ("dissipated", |s| s.energies[2], COLOURS[0]),
        ];
        for ((label, key, colour), width) in series.into_iter().zip([4, 1, 2]) {
            chart
                .draw_series(LineSeries::new(points(key), colour.stroke_width(width)))?
                .label(label)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(width))
                });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE.mix(0.8))
            .border_style(BLACK.mix(0.3))
            .label_font(("sans-serif", 13))
            .draw()?;
        Ok(())
    };
    panel(
        position,
        "position ξ (ticks)",
        padded(samples.iter().map(|s| s.xi)),
        true,
    )?;
    panel(
        velocity,
        "velocity ξ̇ (ticks/sample)",
        padded(samples.iter().map(|s| s.velocity)),
        false,
    )?;
    let energies = padded(samples.iter().flat_map(|s| s.energies));
    // Room above the curves for what they are.
    let high = energies.end + 0.55 * (energies.end - energies.start);
    panel(energy, "energy so far (KΔ²)", energies.start..high, false)?;
    let (upper, lower) = right.split_vertically(500);
    phase_plane(&upper, path)?;
    the_end(&lower, end)
}

fn phase_plane(area: &Area<'_>, samples: &[Sample]) -> Drawn {
    let range = padded(samples.iter().map(|s| s.xi));
    let speeds = padded(samples.iter().map(|s| s.velocity));
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption("phase plane; green: start, red: end", ("sans-serif", 16))
        .x_label_area_size(38)
        .y_label_area_size(60)
        .build_cartesian_2d(range.clone(), speeds.clone())?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc("ξ (ticks)")
        .y_desc("ξ̇ (ticks/sample)")
        .x_label_formatter(&|x| label(*x, &range))
        .y_label_formatter(&|y| label(*y, &speeds))
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 12))
        .draw()?;
    let path = samples.iter().map(|s| (s.xi, s.velocity));
    chart.draw_series(LineSeries::new(path, COLOURS[3].stroke_width(1)))?;
    let mark = |sample: Option<&Sample>, colour: RGBColor| {
        sample.map(|s| Circle::new((s.xi, s.velocity), 4, colour.filled()))
    };
    chart.draw_series(mark(samples.first(), COLOURS[2]))?;
    chart.draw_series(mark(samples.last(), COLOURS[1]))?;
    Ok(())
}

/// The position over the last samples, close enough to see the ticks.
fn the_end(area: &Area<'_>, samples: &[Sample]) -> Drawn {
    let time = padded(samples.iter().map(|s| s.time));
    let range = padded(samples.iter().map(|s| s.xi));
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption("position, the last samples", ("sans-serif", 16))
        .x_label_area_size(38)
        .y_label_area_size(84)
        .build_cartesian_2d(time.clone(), range.clone())?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(5)
        .x_desc("time τ (sampling periods)")
        .y_desc("ξ (ticks)")
        .x_label_formatter(&|x| label(*x, &time))
        .y_label_formatter(&|y| label(*y, &range))
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 12))
        .draw()?;
    for y in encoder_ticks(&range) {
        let line = [(time.start, y), (time.end, y)];
        chart.draw_series(LineSeries::new(line, TICK.mix(DASHED)))?;
    }
    let path = samples.iter().map(|s| (s.time, s.xi));
    chart.draw_series(LineSeries::new(path, COLOURS[0].stroke_width(2)))?;
    Ok(())
}

/// The encoder's edges in a range, or those at ±1 when there are more than can be told apart.
fn encoder_ticks(range: &std::ops::Range<f64>) -> Vec<f64> {
    const MOST_TICKS: f64 = 24.0;
    let (first, last) = (range.start.ceil(), range.end.floor());
    if !(last - first).is_finite() {
        return Vec::new();
    }
    if last - first > MOST_TICKS {
        // As in Fig. 6: one tick either side.
        return vec![-1.0, 1.0];
    }
    let count = (last - first) as i32;
    (0..=count).map(|i| first + f64::from(i)).collect()
}
