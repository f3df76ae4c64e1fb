//! Rows that are written: all of their figures, several rows at a time.
//!
//! What an account sums up is told of each motion and of what a force does more than the wall's; a row that is
//! written is told as a whole, by the kernel's [`row_of`](passivity_core::ledger::row_of) on balls. A row of which
//! not all is decided here is left to that.

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::{Scalar as _, dissipation, generation, ledger, quantizer};

use super::compute::{is_nonnegative, whole};
use super::exactly::{Latest, Written as _};
use super::{Column, Intervals, Length, TILE, Tiles, crossed, truths};
use crate::ball::{Ball, Lane, unless};
use crate::entry::margin_of;
use crate::log::chunk::{Chunk, Samples};
use crate::log::error::TraceError;
use crate::log::numbers::Readings;
use crate::log::wall::Wall;
use crate::number::{Denominator, Fraction, Fractions, Line, Number, Reduced, SEVERAL};
use crate::rows::{Figures, Form, Shown, Whole};

/// Balls on the grid, as [`layers`](Ball::layers).
#[derive(Clone, Copy)]
struct OnGrid([[i64; TILE]; 4]);

impl OnGrid {
    const ZERO: Self = Self([[0; TILE]; 4]);

    /// Takes balls to the grid, and says which of them are `open`.
    #[inline(always)]
    fn take(&mut self, balls: &Column, open: &mut [f64; TILE]) {
        let [wholes, uppers, lowers, radii] = &mut self.0;
        for i in 0..TILE {
            let ball = balls.get(i);
            [wholes[i], uppers[i], lowers[i], radii[i]] = ball.layers();
            open[i] += ball.excess();
        }
    }

    /// The layers of some rows: of the part with this number.
    #[inline(always)]
    fn part(&self, part: usize) -> Option<[&[i64; SEVERAL]; 4]> {
        let [wholes, uppers, lowers, radii] = self
            .0
            .each_ref()
            .map(|column| column.as_chunks().0.get(part));
        Some([wholes?, uppers?, lowers?, radii?])
    }
}

/// The figures of some consecutive rows.
pub(super) struct Rows {
    /// The energies in the order of a row's columns and then the margin: at the least and at the most friction, which
    /// are the same column where friction is known.
    pub(super) balls: [[Column; 2]; 8],
    figures: [[OnGrid; 2]; 8],
    /// Where they end, and the force of each.
    end: OnGrid,
    force: OnGrid,
    /// Of one part of the rows, and which one: the position at the end, the figures and the force, at the least and at
    /// the most.
    fractions: [[Fractions; 2]; 10],
    part: Option<usize>,
    /// What they answer, as bits.
    pub(super) truths: [u64; TILE],
    /// Which ends of the margin there are, as bits: at the least and at the most.
    pub(super) margins: [u64; TILE],
    /// Above zero for the rows that are left open.
    pub(super) open: [f64; TILE],
    /// Where the column at the most friction is.
    most: usize,
}

/// Zero where the leading doubles of two ends are in order, else one.
#[inline(always)]
fn leading_in_order(least: Lane, most: Lane) -> f64 {
    let ((least, _), (most, _)) = (least.parts(), most.parts());
    unless(least <= most)
}

/// What a row says of the least friction or of the most.
#[derive(Clone, Copy)]
struct Ends {
    taken: Lane,
    /// What it is asked whether they are negative: the margin of the criterion times the speed, and net energies.
    asked: [Lane; 3],
    margin: Lane,
}

impl Ends {
    #[inline(always)]
    fn of(wall: &Wall<false>, end: usize, generated: [Lane; 2], [d, speed]: [&Lane; 2]) -> Self {
        let criterion = &wall.criteria[end];
        let taken = wall.frictions[end].dissipated_lower(d, speed);
        let [linear, quantized] = generated.map(|generated| taken - generated);
        Self {
            taken,
            asked: [criterion.margin(speed), linear, quantized],
            margin: margin_of(criterion, speed),
        }
    }
}

impl Rows {
    pub(super) const fn new() -> Self {
        Self {
            balls: [const { [Column::ZERO; 2] }; 8],
            figures: [[OnGrid::ZERO; 2]; 8],
            end: OnGrid::ZERO,
            force: OnGrid::ZERO,
            fractions: [const { [Fractions::ZERO; 2] }; 10],
            part: None,
            most: 0,
            truths: [0; TILE],
            margins: [0; TILE],
            open: [0.0; TILE],
        }
    }

    #[inline(always)]
    fn compute<const EXACT: bool, const APPLIED: bool>(
        &mut self,
        wall: &Wall<false>,
        of: &Intervals,
    ) {
        for i in 0..TILE {
            let ([start, _, lasts], step) = of.lanes(i);
            let d = step.displacement();
            let speed = dissipation::mean_speed(&d, &lasts);
            let force = match APPLIED {
                true => of.force.get(i).lane(),
                false => quantizer::held_force(&step.start),
            };
            let generated = ledger::generated_by_spring(&step, &force, true);
            let bounds = [generation::bound_22(&d), generation::bound_quantized(&d)];
            let [rests, moves] = is_nonnegative(-speed);
            let (length, off) = lasts.parts();
            let mut open = rests * moves + unless(length > off);
            // Friction that is known has one end.
            let least = Ends::of(wall, 0, generated, [&d, &speed]);
            let most = match EXACT {
                true => least,
                false => Ends::of(wall, 1, generated, [&d, &speed]),
            };
            let ends = [least, most];
            let mut truths = 0.0;
            for (Ends { asked, .. }, bit) in ends.iter().zip([1.0, 2.0]) {
                // The criterion is asked of what moves.
                let [
                    [criterion, not],
                    [linear, not_linear],
                    [quantized, not_quantized],
                ] = asked.map(is_nonnegative);
                open += (1.0 - moves) * (criterion * not);
                open += linear * not_linear + quantized * not_quantized;
                let failed = rests * criterion + 4.0 * linear + 16.0 * quantized;
                truths += bit * (21.0 - failed);
            }
            let [least, most] = &ends;
            open += leading_in_order(least.taken, most.taken);
            for (least, most) in least.asked.iter().zip(&most.asked) {
                open += leading_in_order(*least, *most);
            }
            let [[linear, quantized], [bound_22, bound_quantized]] = [generated, bounds];
            for (
                at,
                Ends {
                    taken,
                    asked,
                    margin,
                },
            ) in ends.into_iter().enumerate()
            {
                let [_, net_linear, net_quantized] = asked;
                // What rests has no margin.
                let margin = if rests == 0.0 { Lane::zero() } else { margin };
                let figures = [
                    linear,
                    quantized,
                    bound_22,
                    bound_quantized,
                    taken,
                    net_linear,
                    net_quantized,
                    margin,
                ];
                for (columns, figure) in self.balls.iter_mut().zip(figures) {
                    columns[at].set(i, figure);
                }
            }
            open += start.excess() + force.excess();
            self.truths[i] = whole(truths);
            self.margins[i] = whole(3.0 * rests);
            self.open[i] = open;
        }
        self.take(of, usize::from(!EXACT), APPLIED);
    }

    /// Takes what was computed to the grid, where the column at the most friction is this one.
    #[inline(always)]
    pub(super) fn take(&mut self, of: &Intervals, most: usize, applied: bool) {
        self.most = most;
        self.part = None;
        let open = &mut self.open;
        for (figures, balls) in self.figures.iter_mut().zip(&self.balls) {
            for (figure, balls) in figures.iter_mut().zip(balls).take(1 + most) {
                figure.take(balls, open);
            }
        }
        self.end.take(&of.end, open);
        if applied {
            self.force.take(&of.force, open);
        }
    }

    /// Makes the fractions of a part of the rows.
    #[inline(always)]
    fn make(&mut self, part: usize) -> Option<()> {
        let [end, figures @ .., force] = &mut self.fractions;
        let of_one = [(end, &self.end), (force, &self.force)];
        let of_one = of_one.map(|(fractions, layers)| (fractions, [layers; 2]));
        let of_two = figures.iter_mut().zip(&self.figures);
        let of_two =
            of_two.map(|(fractions, columns)| (fractions, [&columns[0], &columns[self.most]]));
        for ([lo, hi], [least, most]) in of_one.into_iter().chain(of_two) {
            lo.take(least.part(part)?, -1);
            hi.take(most.part(part)?, 1);
        }
        self.part = Some(part);
        Some(())
    }
}

/// [`Rows::make`], in the widest instructions that there are.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn make(rows: &mut Rows, part: usize) -> Option<()> {
    rows.make(part)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
pub(super) fn compute(rows: &mut Rows, wall: &Wall<false>, of: &Intervals, applied: bool) {
    match (wall.friction_is_exact, applied) {
        (true, true) => rows.compute::<true, true>(wall, of),
        (true, false) => rows.compute::<true, false>(wall, of),
        (false, true) => rows.compute::<false, true>(wall, of),
        (false, false) => rows.compute::<false, false>(wall, of),
    }
}

/// The last row that was written, and what is written again in most rows.
pub(super) struct Before {
    latest: Latest,
    /// What the denominator of its length is made of.
    denominator: Denominator,
}

/// Writes some rows of a chunk that doubles decide; those that are not decided here are `left` to be written one by
/// one.
pub(crate) fn write(
    (tiles, chunk): (&Tiles, &Chunk),
    rows: Range<usize>,
    form: Form,
    out: &mut Vec<u8>,
    mut left: impl FnMut(usize, &mut Vec<u8>) -> Result<(), TraceError>,
) -> Result<(), TraceError> {
    /// Fewer rows are written faster one by one.
    const FEW: usize = 8;
    let forces = form.force.then_some(&chunk.forces.values);
    let encloses = forces.is_some_and(Readings::encloses)
        || matches!(&chunk.samples, Samples::Any(samples) if samples.encloses());
    let linear = tiles.wall.as_ref().filter(|wall| wall.reach.is_none());
    let (Some(wall), FEW.., true) = (linear, rows.len(), encloses) else {
        let mut latest = Latest::new();
        return rows.into_iter().try_for_each(|i| {
            let length = tiles.lengths.get(i).copied().unwrap_or_default();
            let to = (&mut latest, &mut *out);
            let written = match &chunk.samples {
                Samples::Any(samples) => {
                    let exactly = tiles.exactly.as_ref();
                    exactly.and_then(|all| all.write((samples, forces, i), length, form, to))
                }
                Samples::Counts(counts) => {
                    let exactly = tiles.exactly_counts.as_ref();
                    exactly.and_then(|all| all.write((counts, forces, i), length, form, to))
                }
            };
            written.map_or_else(|| left(i, out), Ok)
        });
    };
    let (mut of, mut found) = (Intervals::new(), Rows::new());
    let mut before = Before::new();
    for at in rows.clone().step_by(TILE) {
        let lengths = tiles.lengths.get(at..rows.end).unwrap_or_default();
        match &chunk.samples {
            Samples::Any(samples) => {
                of.read(samples, forces, at, lengths);
                compute(&mut found, wall, &of, form.force);
            }
            Samples::Counts(counts) => {
                of.read_counts(counts, forces, at, lengths);
                crossed::compute(&mut found, wall, &of);
            }
        }
        for (i, row) in (at..rows.end).take(TILE).enumerate() {
            let is_enclosed = forces.is_some_and(|forces| forces.is_enclosed(row))
                || match &chunk.samples {
                    Samples::Any(samples) => samples.is_enclosed(row + 1),
                    Samples::Counts(_) => false,
                };
            let from = out.len();
            let mut written = None;
            if is_enclosed && i < of.len {
                written = match &chunk.samples {
                    Samples::Any(_) => {
                        let start = of.start.get(i);
                        found.write(i, (start, lengths[i]), &mut before, form, out)
                    }
                    Samples::Counts(counts) => {
                        let ends = [counts[row], counts[row + 1]];
                        found.write_counts(i, (ends, lengths[i]), &mut before, form, out)
                    }
                };
            }
            if written.is_none() {
                out.truncate(from);
                before.forget();
                left(row, out)?;
            }
        }
    }
    Ok(())
}

impl Rows {
    /// Writes row `i`, of an interval that starts there and lasts so long.
    pub(super) fn write(
        &mut self,
        i: usize,
        (start, length): (Ball, Length),
        before: &mut Before,
        form: Form,
        out: &mut Vec<u8>,
    ) -> Option<()> {
        let (end, figures) = self.row(i, form)?;
        before.write(([&start; 2], end, length), &figures, form, out)
    }

    /// The same of an interval between two counts.
    pub(super) fn write_counts(
        &mut self,
        i: usize,
        (counts, length): ([i64; 2], Length),
        before: &mut Before,
        form: Form,
        out: &mut Vec<u8>,
    ) -> Option<()> {
        let (_, figures) = self.row(i, form)?;
        // The ends of a tick; what is past the last one of 64 bits is left open.
        let [start, end] = counts.map(|n| [Whole(n), Whole(n.wrapping_add(1))]);
        before.write((start, end, length), &figures, form, out)
    }

    /// The position at the end of row `i`, and its figures; `None` where something is left open.
    fn row(&mut self, i: usize, form: Form) -> Option<([Fraction<'_>; 2], Figures<Fraction<'_>>)> {
        if self.open[i] > 0.0 {
            return None;
        }
        if self.part != Some(i / SEVERAL) {
            make(self, i / SEVERAL)?;
        }
        let all = &self.fractions;
        let all = all
            .each_ref()
            .map(|ends| ends.each_ref().map(|of| Fraction(of, i % SEVERAL)));
        let [end, energies @ .., [margin_lo, margin_hi], force] = all;
        let has = |end: u64| self.margins[i] & end != 0;
        let figures = Figures {
            energies,
            margin: [has(1).then_some(margin_lo), has(2).then_some(margin_hi)],
            truths: truths(self.truths[i]),
            force: force.map(|end| form.force.then_some(end)),
        };
        Some((end, figures))
    }
}

impl Before {
    pub(super) fn new() -> Self {
        Self {
            latest: Latest::new(),
            denominator: Denominator::default(),
        }
    }

    /// Has no row before the next one.
    pub(super) fn forget(&mut self) {
        self.latest.end = 0..0;
    }

    /// Writes a row that starts and ends there and lasts so long.
    #[inline(always)]
    fn write(
        &mut self,
        (start, end, length): (
            [impl Shown<Vec<u8>>; 2],
            [impl for<'a> Shown<Line<'a>>; 2],
            Length,
        ),
        figures: &Figures<Fraction<'_>>,
        form: Form,
        out: &mut Vec<u8>,
    ) -> Option<()> {
        let known = self.latest.begin();
        if known == 0 {
            form.position(start, out)?;
        }
        let mut line = Line::new(&mut self.latest.text, known);
        form.position(end, &mut line)?;
        let end = known..line.len();
        let Length(n, d) = length;
        if self.denominator.of != d {
            self.denominator = Denominator::new(d);
        }
        match self.denominator.reduced(n) {
            Some([n, d]) => {
                line.append(b",")?;
                line.append_whole(n)?;
                if d != 1 {
                    line.append(b"/")?;
                    line.append_whole(d)?;
                }
            }
            None => {
                let mut duration = Vec::new();
                form.duration(&Reduced::from(&Number::Small(n, d)), &mut duration);
                line.append(&duration)?;
            }
        }
        form.account(figures, &mut line)?;
        out.extend_from_slice(line.text());
        self.latest.end = end;
        Some(())
    }
}
