//! The picture of a motion: four charts over one axis of time.

use std::ops::Range;

use passivity_plot::frame::Frame;
use passivity_plot::svg::{Anchor, BLACK, COLOURS, DARK, LIGHT, Pixel, Stroke, Svg, rectangle};
use passivity_scene::plane::Extent;

use super::within::Acting;
use super::{Bar, Motion, Sample};
use crate::plot::padded;
use crate::scales::{Scale, Scales};

const WIDTH: f64 = 1080.0;
const LEFT: f64 = 104.0;
const RIGHT: f64 = 980.0;
const TOP: f64 = 48.0;
const HIGH: f64 = 178.0;
const GAP: f64 = 22.0;

/// Motions of more intervals than this are drawn from sample to sample: within an interval nothing can
/// be seen.
const CLOSE: usize = 1200;

/// Places on the curve of a motion that is drawn within its intervals.
const PLACES: u32 = 2400;

/// What generated energy is drawn in, dark, and what dissipated energy is, light with an edge.
const GENERATED: &str = "#b34700";
const DISSIPATED: &str = "#86bfe3";

/// Draws a motion as SVG text, in the units of `scales`.
///
/// Where there are few enough intervals the curve within them is the closed form; the force is held
/// from sample to sample.
#[must_use]
pub fn draw(title: &str, mut motion: Motion, scales: &Scales) -> String {
    motion.settle();
    let height = TOP + 4.0 * HIGH + 3.0 * GAP + 64.0;
    let mut svg = Svg::new([WIDTH, height]);
    svg.title(28.0, 18.0, title);
    let curve = curve(&motion);
    let first = curve.first().map_or(0.0, |sample| sample.time);
    let last = motion.end.time.max(first + 1.0);
    let time = Extent {
        from: first * scales.time.one,
        to: last * scales.time.one,
        log: false,
    };
    let drawing = Drawing {
        motion: &motion,
        scales,
        time,
    };
    let mut chart = Chart {
        svg: &mut svg,
        drawing,
        row: 0.0,
    };
    chart.position(&curve);
    chart.velocity(&curve);
    chart.force();
    chart.energy();
    svg.finish()
}

/// The samples, with the closed form between them where they are few.
fn curve(motion: &Motion) -> Vec<Sample> {
    let samples = &motion.samples;
    let mut curve = Vec::new();
    let count = u32::try_from(samples.len()).unwrap_or(u32::MAX).max(1);
    let parts = PLACES.div_ceil(count).clamp(4, 64);
    let within = motion.is_whole() && samples.len() <= CLOSE;
    for sample in samples {
        curve.push(*sample);
        if within {
            let states =
                motion
                    .follower
                    .within([sample.xi, sample.velocity], &sample.acting, parts);
            for (i, [xi, velocity]) in (1_u32..parts).zip(states) {
                let time = sample.time + f64::from(i) / f64::from(parts);
                curve.push(Sample {
                    time,
                    xi,
                    velocity,
                    ..*sample
                });
            }
        }
    }
    curve.push(motion.end);
    curve
}

#[derive(Clone, Copy)]
struct Drawing<'a> {
    motion: &'a Motion,
    scales: &'a Scales,
    time: Extent,
}

struct Chart<'a> {
    svg: &'a mut Svg,
    drawing: Drawing<'a>,
    row: f64,
}

fn extent(range: &Range<f64>) -> Extent {
    Extent {
        from: range.start,
        to: range.end,
        log: false,
    }
}

impl Chart<'_> {
    /// What an axis shows of dimensionless values. Around a single one it is a tick, or the KΔ of one: without an encoder
    /// these are 1 m or 1 rad wide, and it is as far as to zero, or one unit of the scene about zero.
    fn values(&self, values: impl Iterator<Item = f64>, scale: &Scale) -> Range<f64> {
        padded(values, |single| match self.drawing.scales.ticks {
            true => 1.0,
            false if single == 0.0 => 1.0 / scale.one,
            false => single.abs(),
        })
    }

    /// The frame of the next chart, of dimensionless values.
    fn frame(&mut self, values: &Range<f64>, scale: &Scale) -> Frame {
        let top = TOP + self.row * (HIGH + GAP);
        self.row += 1.0;
        let Range { start, end } = values;
        Frame {
            x: self.drawing.time,
            y: extent(&(start * scale.one..end * scale.one)),
            from: [LEFT, top],
            to: [RIGHT, top + HIGH],
        }
    }

    /// The axes of a chart, with figures in ticks on the right where there are ticks beside the units.
    fn axes(&mut self, frame: &Frame, values: &Range<f64>, words: [&str; 2], scale: &Scale) {
        let [name, plain] = words;
        frame.draw_y(self.svg, &format!("{name} ({})", scale.unit));
        if self.drawing.scales.si && self.drawing.scales.ticks {
            frame.draw_right(self.svg, &extent(values), plain);
        }
        frame.draw_edge(self.svg);
        if self.row == 4.0 {
            let unit = &self.drawing.scales.time.unit;
            frame.draw_x(self.svg, &format!("time ({unit})"));
        }
    }

    fn pixels(
        &self,
        frame: &Frame,
        curve: &[Sample],
        scale: &Scale,
        value: fn(&Sample) -> f64,
    ) -> Vec<Pixel> {
        let one = self.drawing.scales.time.one;
        let place = |sample: &Sample| frame.clamped([sample.time * one, value(sample) * scale.one]);
        curve.iter().map(place).collect()
    }

    fn position(&mut self, curve: &[Sample]) {
        let scale = self.drawing.scales.position.clone();
        let values = self.values(curve.iter().map(|s| s.xi), &scale);
        let frame = self.frame(&values, &scale);
        let edges = if self.drawing.scales.ticks {
            encoder_edges(&values)
        } else {
            Vec::new()
        };
        for edge in edges {
            let y = edge * scale.one;
            let ends = [frame.x.from, frame.x.to].map(|x| frame.clamped([x, y]));
            self.svg.line(&ends, Stroke::dashed(LIGHT, 1.0));
        }
        let line = self.pixels(&frame, curve, &scale, |s| s.xi);
        self.svg.line(&line, Stroke::solid(COLOURS[0], 2.0));
        self.axes(&frame, &values, ["position", "ticks"], &scale);
    }

    fn velocity(&mut self, curve: &[Sample]) {
        let scale = self.drawing.scales.velocity.clone();
        let values = self.values(curve.iter().map(|s| s.velocity), &scale);
        let frame = self.frame(&values, &scale);
        self.zero(&frame);
        let line = self.pixels(&frame, curve, &scale, |s| s.velocity);
        self.svg.line(&line, Stroke::solid(COLOURS[2], 2.0));
        self.axes(&frame, &values, ["velocity", "ticks/sample"], &scale);
    }

    /// The held force, a step at each sample or as late as the scene's latency says.
    fn force(&mut self) {
        let scale = self.drawing.scales.force.clone();
        let samples = &self.drawing.motion.samples;
        let values = samples.iter().map(|s| s.acting.held).chain([0.0]);
        let values = self.values(values, &scale);
        let frame = self.frame(&values, &scale);
        self.zero(&frame);
        let Motion { follower, end, .. } = self.drawing.motion;
        // Before the first sample's force acts, the one before does.
        let first = samples.iter().take(1).map(|sample| Sample {
            acting: Acting {
                held: sample.acting.earlier,
                ..sample.acting
            },
            ..*sample
        });
        let late = samples.iter().map(|sample| Sample {
            time: (sample.time + follower.late()).min(end.time),
            ..*sample
        });
        let mut steps: Vec<Sample> = Vec::new();
        for sample in first.chain(late).chain([*end]) {
            let before = steps.last().map(|before| Sample {
                time: sample.time,
                ..*before
            });
            steps.extend(before);
            steps.push(sample);
        }
        let line = self.pixels(&frame, &steps, &scale, |s| s.acting.held);
        self.svg.line(&line, Stroke::solid(BLACK, 1.5));
        self.axes(&frame, &values, ["held force", "KΔ"], &scale);
    }

    /// What each interval, or some in a row, generated and dissipated.
    fn energy(&mut self) {
        let Drawing { motion, scales, .. } = self.drawing;
        let bars = &motion.bars;
        let all = || {
            bars.iter()
                .flat_map(|bar| [bar.generated, bar.dissipated, 0.0])
        };
        let size = all().fold(0.0_f64, |most, x| most.max(x.abs()));
        let scale = if scales.si {
            scales.energy.prefixed(size)
        } else {
            scales.energy.clone()
        };
        let mut values = self.values(all(), &scale);
        // Room for what the bars are.
        values.end += 0.25 * (values.end - values.start);
        let frame = self.frame(&values, &scale);
        let start = motion.samples.first().map_or(0.0, |sample| sample.time);
        for (i, bar) in (0_u32..).zip(bars) {
            let from = start + f64::from(i) * motion.per_bar as f64;
            let to = (from + motion.per_bar as f64).min(motion.end.time);
            self.bar(&frame, [from, to], bar, &scale);
        }
        self.zero(&frame);
        let each = match motion.per_bar {
            1 => "each interval".to_owned(),
            n => format!("every {n} intervals"),
        };
        let [_, top] = frame.from;
        for (x, fill, words) in [
            (
                LEFT + 14.0,
                GENERATED,
                format!("generated in {each} (linear spring)"),
            ),
            (LEFT + 380.0, DISSIPATED, format!("dissipated in {each}")),
        ] {
            let corners = rectangle([x, top + 9.0], [x + 18.0, top + 20.0]);
            self.svg.area(&corners, fill);
            self.edge(&corners);
            let place = [x + 26.0, top + 19.0];
            self.svg
                .text_over(place, 13.0, Anchor::Start, &words, BLACK);
        }
        self.axes(&frame, &values, ["energy", "KΔ²"], &scale);
    }

    /// The two bars side by side.
    fn bar(&mut self, frame: &Frame, [from, to]: [f64; 2], bar: &Bar, scale: &Scale) {
        let one = self.drawing.scales.time.one;
        let at = |share: f64, value: f64| {
            frame.clamped([(from + share * (to - from)) * one, value * scale.one])
        };
        for (side, value, fill) in [
            (0.1, bar.generated, GENERATED),
            (0.5, bar.dissipated, DISSIPATED),
        ] {
            if value == 0.0 {
                continue;
            }
            let corners = rectangle(at(side, value), at(side + 0.4, 0.0));
            self.svg.area(&corners, fill);
            // A bar of a few pixels would be all edge.
            if fill == DISSIPATED && corners[1][0] - corners[0][0] > 4.0 {
                self.edge(&corners);
            }
        }
    }

    fn edge(&mut self, corners: &[Pixel; 4]) {
        let mut edge = corners.to_vec();
        edge.extend(edge.first().copied());
        self.svg.line(&edge, Stroke::solid(DARK, 0.6));
    }

    fn zero(&mut self, frame: &Frame) {
        let ends = [frame.x.from, frame.x.to].map(|x| frame.clamped([x, 0.0]));
        self.svg.line(&ends, Stroke::solid(LIGHT, 1.0));
    }
}

/// The encoder's edges in a range, or those at ±1 when there are more than can be told apart.
fn encoder_edges(range: &Range<f64>) -> Vec<f64> {
    const MOST_EDGES: f64 = 24.0;
    let (first, last) = (range.start.ceil(), range.end.floor());
    if !(last - first).is_finite() {
        return Vec::new();
    }
    if last - first > MOST_EDGES {
        // As in Fig. 6: one tick either side.
        return vec![-1.0, 1.0];
    }
    let count = (last - first) as i32;
    (0..=count).map(|i| first + f64::from(i)).collect()
}
