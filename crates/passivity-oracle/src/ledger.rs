//! Rows on machine integers where they fit, on big integers where they do not: the same answers.

use num_integer::Integer as _;
use passivity_core::{BigRational, Fixed, Scalar, Truth, Wide};
use passivity_scene::Scene;

use crate::cell::Cell;
use crate::entry::{Entry, entry};
use crate::model::Model;
use crate::number::{Number, Written};
use crate::span::Span;
use crate::sum::SpanSum;

/// A sample of a trace.
#[derive(Clone, Debug, PartialEq)]
pub enum Sample {
    /// ξ, exactly.
    Exact(Number),
    /// An encoder's count n: ξ in [n, n + 1).
    Count(i64),
    /// ξ within an enclosure that no whole tick divides, as when Δ has π in it.
    Within(Box<(BigRational, BigRational)>),
}

impl Sample {
    /// The sample as a cell over machine integers, when it fits.
    #[must_use]
    pub fn to_fixed(&self) -> Option<Cell<Fixed>> {
        match self {
            Self::Exact(xi) => Some(Cell::of(&xi.to_fixed()?)),
            Self::Count(n) => Some(Cell::count(Fixed::new((*n).into(), 1))),
            Self::Within(ends) => within(&ends.0, &ends.1, passivity_core::rational::to_fixed),
        }
    }

    /// The sample as a cell over big integers.
    #[must_use]
    pub fn to_wide(&self) -> Cell<Wide> {
        match self {
            Self::Exact(xi) => Cell::of(&xi.to_wide()),
            Self::Count(n) => Cell::count(Wide::new((*n).into(), 1.into())),
            Self::Within(ends) => {
                let wide = |x: &BigRational| Some(passivity_core::rational::to_wide(x));
                within(&ends.0, &ends.1, wide)
                    .unwrap_or_else(|| Cell::of(&passivity_core::rational::to_wide(&ends.0)))
            }
        }
    }

    /// ⌊ξ⌋, when it fits.
    #[must_use]
    pub fn tick(&self) -> Option<i64> {
        use num_traits::ToPrimitive as _;
        match self {
            Self::Exact(Number::Small(n, d)) => Some(n.div_floor(d)),
            Self::Exact(Number::Big(x)) => x.floor().to_i64(),
            Self::Count(n) => Some(*n),
            Self::Within(ends) => ends.0.floor().to_i64(),
        }
    }
}

fn within<S: Scalar>(
    lo: &BigRational,
    hi: &BigRational,
    to: impl Fn(&BigRational) -> Option<S>,
) -> Option<Cell<S>> {
    let tick = lo.floor();
    Some(Cell {
        residue: Span::Between(to(&(lo - &tick))?, to(&(hi - &tick))?),
        tick: to(&tick)?,
    })
}

/// A loop ready to account for intervals.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Friction, Scalar};
/// use passivity_oracle::{Ledger, Model, Number, Sample};
///
/// let three_fifths = Number::Small(3, 5).to_rational();
/// let model = Model::plain(Friction::new(three_fifths.clone(), three_fifths));
/// let ledger = Ledger::new(model);
/// let at = |text| Sample::Exact(Number::parse(text).unwrap());
/// let row = ledger.row(&[at("1")], &at("1/2"), &Number::whole(1)).unwrap();
/// let mut json = Vec::new();
/// row.write_json(0, &mut json);
/// assert!(String::from_utf8(json).unwrap().contains(r#""violates_quantized": true"#));
/// ```
#[derive(Clone, Debug)]
pub struct Ledger {
    exact: Model<BigRational>,
    fixed: Option<Model<Fixed>>,
    wide: Model<Wide>,
}

/// A row on whichever integers it needed.
#[derive(Clone, Debug)]
pub enum Row {
    /// On 128-bit integers.
    Fixed(Box<Entry<Fixed>>),
    /// On big integers.
    Wide(Box<Entry<Wide>>),
}

impl Ledger {
    /// The ledger of a loop.
    #[must_use]
    pub fn new(model: Model<BigRational>) -> Self {
        let wide = |x: &BigRational| Some(passivity_core::rational::to_wide(x));
        Self {
            fixed: model.to_fixed(),
            // Every number has a wide form; the loop without friction stands in for the type.
            wide: model.try_map(wide).unwrap_or_else(|| {
                Model::plain(passivity_core::Friction::new(Wide::zero(), Wide::zero()))
            }),
            exact: model,
        }
    }

    /// The loop.
    #[must_use]
    pub const fn model(&self) -> &Model<BigRational> {
        &self.exact
    }

    /// The loop over machine integers, when its numbers fit.
    #[must_use]
    pub const fn fixed(&self) -> Option<&Model<Fixed>> {
        self.fixed.as_ref()
    }

    /// The loop over big integers.
    #[must_use]
    pub const fn wide(&self) -> &Model<Wide> {
        &self.wide
    }

    /// How many samples, up to the start of an interval, its row depends on: the storage of a
    /// delay looks one displacement further back than the force.
    #[must_use]
    pub fn window(&self) -> usize {
        match self.exact.memory() {
            0 => 1,
            memory => memory + 2,
        }
    }

    /// The row of the interval from `samples[0]` (the latest sample first) to `end`; `None` for
    /// no samples or a Δτ that is not above zero.
    #[must_use]
    pub fn row(&self, samples: &[Sample], end: &Sample, dtau: &Number) -> Option<Row> {
        let kept = samples.get(..self.window()).unwrap_or(samples);
        let on_machine_integers = || {
            let model = self.fixed.as_ref()?;
            let cells: Option<Vec<_>> = kept.iter().map(Sample::to_fixed).collect();
            entry(model, &cells?, &end.to_fixed()?, &dtau.to_fixed()?)
        };
        if let Some(entry) = on_machine_integers() {
            return Some(Row::Fixed(Box::new(entry)));
        }
        let cells: Vec<_> = kept.iter().map(Sample::to_wide).collect();
        let entry = entry(&self.wide, &cells, &end.to_wide(), &dtau.to_wide())?;
        Some(Row::Wide(Box::new(entry)))
    }
}

/// Runs an expression on the entry inside a row, whatever its integers.
macro_rules! on_entry {
    ($row:expr, $entry:ident => $body:expr) => {
        match $row {
            Row::Fixed($entry) => $body,
            Row::Wide($entry) => $body,
        }
    };
}

impl Row {
    /// Appends the row as a JSON object; see [`Entry::write_json`].
    pub fn write_json(&self, h: u64, out: &mut Vec<u8>) {
        on_entry!(self, entry => entry.write_json(h, out));
    }

    /// Appends the row as a line of CSV; see [`Entry::write_csv`].
    pub fn write_csv(&self, h: u64, enclosures: bool, out: &mut Vec<u8>) {
        on_entry!(self, entry => entry.write_csv(h, enclosures, out));
    }

    /// Whether the criterion holds, and whether each account is violated: linear, quantized.
    #[must_use]
    pub fn truths(&self) -> [Truth; 3] {
        on_entry!(self, entry => [
            entry.criterion_holds,
            entry.violates_linear,
            entry.violates_quantized,
        ])
    }

    /// Whether the row is an enclosure.
    #[must_use]
    pub fn is_enclosure(&self) -> bool {
        on_entry!(self, entry => entry.figures().iter().any(|(_, figure)| {
            figure.is_some_and(|span| span.exact().is_none())
        }))
    }

    /// `net_linear` in lowest terms.
    #[must_use]
    pub fn net_linear(&self) -> Option<Span<BigRational>> {
        on_entry!(self, entry => entry.net_linear.try_map(Written::to_rational))
    }

    /// E_gᴸ and E_g in lowest terms.
    pub(crate) fn generated(&self) -> Option<[Span<BigRational>; 2]> {
        on_entry!(self, entry => Some([
            entry.generated_linear.try_map(Written::to_rational)?,
            entry.generated_quantized.try_map(Written::to_rational)?,
        ]))
    }

    /// The lower end of `net_linear`: in lowest terms, on machine integers when it fits.
    pub(crate) fn net_floor(&self) -> Result<(i128, i128), BigRational> {
        on_entry!(self, entry => {
            let net = entry.net_linear.lo();
            net.to_reduced().ok_or_else(|| {
                // A row's figures are defined.
                net.to_rational().unwrap_or_else(BigRational::zero)
            })
        })
    }

    /// The five figures that totals are kept of.
    pub(crate) fn add_to(&self, sums: &mut [SpanSum; 5], times: u64) {
        on_entry!(self, entry => {
            let figures = [
                &entry.generated_linear,
                &entry.generated_quantized,
                &entry.dissipated_lower,
                &entry.net_linear,
                &entry.net_quantized,
            ];
            for (sum, figure) in sums.iter_mut().zip(figures) {
                sum.add_times(figure, times);
            }
        });
    }
}

impl Model<BigRational> {
    /// The loop of a scene, with its friction over the tolerances and π enclosed at a level; other
    /// parameters at their nominal values.
    #[must_use]
    pub fn of_scene(scene: &Scene, pi_level: usize) -> Self {
        let rigs = scene.rig_box(pi_level);
        let (worst, best) = (rigs.worst().friction(), rigs.best().friction());
        let point = scene.point();
        Self {
            exact: worst == best,
            least: worst,
            most: best,
            effects: passivity_core::effects::Effects {
                encoder: point.encoder,
                delay: point.delay,
                damping: point.damping,
                force_step: point.force_step,
            },
            unilateral: point.unilateral,
            max_force: point.max_force,
        }
    }
}
