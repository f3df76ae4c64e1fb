//! Fig. 5: where in the (β, σ) plane the motion grows (a) and where it never comes to rest (b).

use passivity_plot::critical::Borders;
use passivity_plot::frame::Frame;
use passivity_plot::svg::{Anchor, BLACK, COLOURS, DARK, HATCHED, Pixel, Stroke, Svg};

use super::cells::{Cell, cells, span};
use super::{cross, fill, frame, row, swatch, undecided};
use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::plot::label;
use crate::sweep::{Grid, Row};

/// The dashes of the critical lines, told apart in grey too.
const DASHES: [&str; 5] = ["7 4", "2 3", "12 3 2 3", "16 5", "5 2 1 2"];

const WIDE: f64 = 1240.0;
const TOP: f64 = 76.0;
const HIGH: f64 = 470.0;
/// The colour of the paper's detector.
const OSCILLATES: &str = "#e69f00";

/// Draws a sweep as SVG text: (a) growing, (b) never at rest, a shade for each speed from black for
/// the slowest to light grey; in (b) dots where the paper's detector sees the oscillation of some
/// speed too. Hatched cells with crosses are those of which some speed is undecided.
///
/// The critical lines (9) of the speeds are those of the scene with all its effects.
#[must_use]
pub fn draw(grid: &Grid, rows: &[Option<Row>], borders: Borders) -> String {
    let speeds = by_speed(grid);
    let high = TOP + HIGH + 76.0 + 24.0 * lines_of_key(&speeds) + 40.0;
    let mut svg = Svg::new([WIDE, high]);
    let title = "Outcome in the (β, σ) plane; dashed: critical lines, with the speed at the start";
    svg.title(28.0, 18.0, title);
    let drawing = Drawing {
        grid,
        rows,
        borders,
        speeds: &speeds,
    };
    for (left, title, shown) in [
        (80.0, "(a) growing", ExactOutcome::Growing),
        (
            700.0,
            "(b) never at rest; dots: |ξ̇| ≥ 0.01 at the end",
            ExactOutcome::NeverAtRest,
        ),
    ] {
        svg.text([left + 250.0, 60.0], 16.0, Anchor::Middle, title);
        drawing.panel(&mut svg, left, shown);
    }
    drawing.key(&mut svg, TOP + HIGH + 76.0);
    svg.finish()
}

/// What both panels show.
struct Drawing<'a> {
    grid: &'a Grid,
    rows: &'a [Option<Row>],
    borders: Borders,
    /// The indices of the speeds, the slowest first.
    speeds: &'a [(usize, f64)],
}

fn by_speed(grid: &Grid) -> Vec<(usize, f64)> {
    let [_, _, speeds] = &grid.values;
    let speeds = speeds.doubles().map(f64::abs);
    let mut order: Vec<(usize, f64)> = speeds.enumerate().collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1));
    order
}

/// How many speeds stand in a line of the key.
const A_LINE: usize = 4;

fn lines_of_key(speeds: &[(usize, f64)]) -> f64 {
    let lines = speeds.len().div_ceil(A_LINE) + 1;
    f64::from(u32::try_from(lines).unwrap_or(u32::MAX))
}

impl Drawing<'_> {
    fn panel(&self, svg: &mut Svg, left: f64, shown: ExactOutcome) {
        let [betas, sigmas, _] = &self.grid.values;
        let (columns, lines) = (cells(betas), cells(sigmas));
        let frame = frame(&columns, &lines, [left, TOP], [left + 500.0, TOP + HIGH]);
        let row = |column: &Cell, line: &Cell, speed| {
            row(self.grid, self.rows, [column.index, line.index, speed])
        };
        for (column, line) in columns
            .iter()
            .flat_map(|c| lines.iter().map(move |l| (c, l)))
        {
            let all: Vec<Row> = self
                .speeds
                .iter()
                .filter_map(|(speed, _)| row(column, line, *speed))
                .collect();
            let is_undecided = all.iter().any(|row| row.is_undecided());
            if is_undecided {
                undecided(svg, &frame, column, line);
            }
            // The slowest speed that does it says the shade.
            let does = |(_, (speed, _)): &(usize, &(usize, f64))| {
                row(column, line, *speed).is_some_and(|row| row.exact == shown)
            };
            if let Some((rank, _)) = self.speeds.iter().enumerate().find(does) {
                fill(svg, &frame, column, line, &shade(rank, self.speeds.len()));
                if is_undecided {
                    cross(svg, frame.clamped([column.at, line.at]));
                }
            }
            let oscillates = |row: &Row| row.paper == PaperOutcome::LimitCycle;
            if shown == ExactOutcome::NeverAtRest && all.iter().any(oscillates) {
                let place = frame.clamped([column.at, line.at]);
                svg.disc(place, 1.8, OSCILLATES, Stroke::solid(OSCILLATES, 0.5));
            }
        }
        self.draw_borders(svg, &frame, &span(&columns), &span(&lines));
        frame.draw(svg, ["β = b/(KT)", "σ = c/(KΔ)"]);
    }

    /// The borders of β and σ, and the critical line (9) of each speed.
    fn draw_borders(
        &self,
        svg: &mut Svg,
        frame: &Frame,
        width: &std::ops::Range<f64>,
        height: &std::ops::Range<f64>,
    ) {
        let Borders { beta, sigma } = self.borders;
        for border in [
            [[beta, height.start], [beta, height.end]],
            [[width.start, sigma], [width.end, sigma]],
        ] {
            if frame.contains(border[0]) && frame.contains(border[1]) {
                svg.line(
                    &border.map(|place| frame.pixel(place)),
                    Stroke::solid(DARK, 0.8),
                );
            }
        }
        for (rank, (_, speed)) in self.speeds.iter().enumerate() {
            let Some(ends) = self.borders.critical_line(*speed, width, height) else {
                continue;
            };
            let line = ends.map(|(beta, sigma)| frame.clamped([beta, sigma]));
            svg.line(&line, Stroke::solid("#ffffff", 3.5));
            svg.line(&line, critical(rank));
        }
    }

    /// What shades, lines and signs mean.
    fn key(&self, svg: &mut Svg, top: f64) {
        let first = "the slowest speed at which it does so, and its critical line:";
        svg.text([80.0, top + 12.0], 14.0, Anchor::Start, first);
        let range = 0.0..self.speeds.last().map_or(1.0, |(_, speed)| *speed);
        let mut at: Pixel = [80.0, top + 24.0];
        for (rank, (_, speed)) in self.speeds.iter().enumerate() {
            let [x, y] = at;
            swatch(svg, at, &shade(rank, self.speeds.len()));
            svg.line(&[[x + 30.0, y + 7.0], [x + 76.0, y + 7.0]], critical(rank));
            let words = match label(*speed, &range).as_str() {
                "1" => "1 tick/sample".to_owned(),
                speed => format!("{speed} ticks/sample"),
            };
            svg.text([x + 84.0, y + 12.0], 13.0, Anchor::Start, &words);
            at = if (rank + 1) % A_LINE == 0 {
                [80.0, y + 24.0]
            } else {
                [x + 230.0, y]
            };
        }
        let right = 1010.0;
        if self.rows.iter().flatten().any(|row| row.is_undecided()) {
            swatch(svg, [right, top + 24.0], HATCHED);
            cross(svg, [right + 11.0, top + 31.0]);
            svg.text(
                [right + 32.0, top + 36.0],
                13.0,
                Anchor::Start,
                "crosses: undecided",
            );
        }
    }
}

fn critical(rank: usize) -> Stroke<'static> {
    Stroke {
        colour: COLOURS.get(rank % COLOURS.len()).copied().unwrap_or(BLACK),
        width: 2.0,
        dash: DASHES.get(rank % DASHES.len()).copied().unwrap_or_default(),
    }
}

/// From nearly black for the slowest speed to light grey.
fn shade(rank: usize, speeds: usize) -> String {
    let level = 30 + 180 * rank / (speeds.max(2) - 1);
    format!("#{level:02x}{level:02x}{level:02x}")
}
