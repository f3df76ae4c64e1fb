//! A run as a table: the ledger row of every interval, with velocities and dissipated energy.

use std::collections::VecDeque;
use std::fmt::Write as _;

use passivity_core::{BigRational, Criterion, Loop, Step, extra_storage, ledger};
use passivity_scene::display::{Rounding, outward};
use passivity_scene::number::{nearest_f64, parse};
use passivity_scene::point::Units;
use passivity_scene::{Point, Scene};

use crate::error::SimError;
use crate::method::Method;
use crate::model::IntervalRow;
use crate::number::{Double, Enclosed, Real};
use crate::simulated::Line;

/// The columns of the kernel's row, in the order of the interface; `dtau` stands after the positions.
const ROW: [&str; 10] = [
    "xi0",
    "xi1",
    "generated_linear",
    "generated_quantized",
    "bound_22",
    "bound_quantized",
    "dissipated_lower",
    "net_linear",
    "net_quantized",
    "margin",
];

/// The columns of what the kernel's row says of each interval.
const TRUTHS: [&str; 3] = ["criterion_holds", "violates_linear", "violates_quantized"];

/// The columns of the motion.
const MOTION: [&str; 3] = ["v0", "v1", "dissipated"];

/// What the rows of a run need beside the run.
#[derive(Clone, Debug)]
pub struct Table {
    doubles: Account<Double>,
    rationals: Account<BigRational>,
    enclosures: Account<Enclosed<Double>>,
    encloses: bool,
    si: Option<Si>,
}

/// What a tick, a tick per sample, KΔ² and a sample are in SI units, and how the device moves.
#[derive(Clone, Debug)]
struct Si {
    length: BigRational,
    speed: BigRational,
    energy: BigRational,
    period: BigRational,
    unit: &'static str,
    /// The sample after the last row: its number, the position and the velocity, in SI units.
    end: Option<(u64, [f64; 2])>,
}

/// What the kernel's account of an interval depends on, in some kind of number.
#[derive(Clone, Debug)]
struct Account<R> {
    dimensionless: Loop<R>,
    /// Computed exactly and rounded once.
    criterion: Criterion<R>,
    /// The latest displacements, the last one first: as many as delay and damping have in store; `None` where
    /// it is not known of each interval what the loop's memory has in store.
    stored: Option<VecDeque<R>>,
}

/// A row of the table.
struct Figures<R> {
    row: [R; 7],
    /// What is left of what friction dissipates at least, against either spring; `None` where that is not known.
    net: [Option<R>; 2],
    /// At the mean speed; `None` where there is none.
    margin: Option<R>,
    truths: [Option<bool>; 3],
    motion: [R; 3],
}

impl<R> Figures<R> {
    /// Appends what the kernel's row says, nothing where that is not known.
    fn put_truths(&self, out: &mut String) {
        for truth in self.truths {
            // Writing to a string does not fail.
            let _ = match truth {
                Some(truth) => write!(out, ",{truth}"),
                None => write!(out, ","),
            };
        }
    }
}

impl Table {
    /// The table of a scene's point by a method.
    ///
    /// The net energies and what they violate are left empty where `audit` does not account for logs of the
    /// scene, [`Scene::unaccounted`]: what the loop's memory has in store is not known of each interval.
    #[must_use]
    pub fn new(scene: &Scene, point: &Point, method: &Method) -> Self {
        let known = scene.unaccounted(false).is_empty();
        Self {
            doubles: Account::new(point, known, |x| Double::from(x)),
            rationals: Account::new(point, known, BigRational::clone),
            enclosures: Account::new(point, known, |x| Enclosed::from(x)),
            encloses: *method == Method::Enclosure,
            si: None,
        }
    }

    /// The table in SI units, as doubles: the time, the motion, the energies in joules, and what the
    /// kernel's row says. `None` for a scene without units and for enclosures.
    #[must_use]
    pub fn in_si(self, point: &Point) -> Option<Self> {
        let Units {
            period,
            length,
            stiffness,
            length_unit,
        } = &point.units;
        let si = Si {
            length: length.clone(),
            speed: length / period,
            energy: stiffness * length * length,
            period: period.clone(),
            end: None,
            unit: length_unit.as_ref().filter(|_| !self.encloses)?,
        };
        Some(Self {
            si: Some(si),
            ..self
        })
    }

    /// The header, without a line break.
    ///
    /// The last column, `xi`, is the position at the sample once more, as `passivity audit` reads it;
    /// enclosures have none.
    #[must_use]
    pub fn header(&self) -> String {
        if let Some(Si { unit, .. }) = &self.si {
            let energies = "generated_linear [J],generated_quantized [J],dissipated [J]";
            let truths = TRUTHS.join(",");
            return format!("h,t [s],x [{unit}],v [{unit}/s],{energies},{truths}");
        }
        let figures = |names: &'static [&'static str]| {
            names.iter().flat_map(|name| {
                if self.encloses {
                    vec![format!("{name}_lo"), format!("{name}_hi")]
                } else {
                    vec![(*name).to_owned()]
                }
            })
        };
        let plain = |names: &'static [&'static str]| names.iter().map(|name| (*name).to_owned());
        let (positions, energies) = ROW.split_at(2);
        let columns = plain(&["h"])
            .chain(figures(positions))
            .chain(plain(&["dtau"]))
            .chain(figures(energies))
            .chain(plain(&TRUTHS))
            .chain(figures(&MOTION))
            .chain(plain(if self.encloses { &[] } else { &["xi"] }));
        columns.collect::<Vec<_>>().join(",")
    }

    /// Appends a row with its line break.
    ///
    /// # Errors
    ///
    /// A figure that is undefined.
    pub fn write(&mut self, line: &Line<'_>, out: &mut String) -> Result<(), SimError> {
        match line {
            Line::Double(entry) => {
                let row = IntervalRow {
                    h: entry.h,
                    step: Step {
                        start: entry.xi0,
                        end: entry.xi1,
                    },
                    velocity: [entry.v0, entry.v1],
                    generated: [entry.generated_linear, entry.generated_quantized],
                    dissipated: entry.dissipated,
                    residual: entry.residual,
                };
                let figures = self.doubles.figures(&row.map(|x| Double(*x)));
                if let Some(si) = &mut self.si {
                    let in_unit = |x: &Double, unit: &BigRational| x.0 * nearest_f64(unit);
                    let by_edge = |x: &Double| {
                        // What a product of doubles may be off, twice, and what may become zero.
                        let off = (2.0 * f64::EPSILON * x.0.abs()).max(1e-200);
                        let is_near = (x.0 - x.0.round()).abs() <= off;
                        BigRational::from_float(x.0).filter(|_| is_near)
                    };
                    return si.put(entry.h, &figures, out, (in_unit, by_edge));
                }
                // Shortest decimals that read back as the same double. At a speed that is almost
                // nothing the margin is beyond all doubles.
                let shown = |x: &Double| format!("{:?}", x.0.clamp(f64::MIN, f64::MAX));
                self.put(entry.h, &figures, out, shown)?;
                let _ = writeln!(out, ",{:?}", entry.xi0);
            }
            Line::Exact(row) => {
                let figures = self.rationals.figures(row);
                if let Some(si) = &mut self.si {
                    let in_unit = |x: &BigRational, unit: &BigRational| nearest_f64(&(x * unit));
                    return si.put(row.h, &figures, out, (in_unit, |x| Some(x.clone())));
                }
                self.put(row.h, &figures, out, BigRational::to_string)?;
                let _ = writeln!(out, ",{}", row.step.start);
            }
            Line::Enclosed(row) => {
                let figures = self.enclosures.figures(row);
                self.put(row.h, &figures, out, |x| {
                    let [lo, hi] = x.bounds();
                    format!(
                        "{},{}",
                        outward(lo, Rounding::Down),
                        outward(hi, Rounding::Up)
                    )
                })?;
                out.push('\n');
            }
        }
        Ok(())
    }

    /// Appends the sample that ends the run, where rows tell of the sample at their start only: in SI units. Of an
    /// interval that is not in the table it says nothing.
    pub fn end(&self, out: &mut String) {
        if let Some((si, (h, motion))) = self.si.as_ref().and_then(|si| Some((si, si.end?))) {
            si.sample(h, motion, out);
            // Three energies and three truths.
            out.push_str(",,,,,,\n");
        }
    }

    fn put<R: Real>(
        &self,
        h: u64,
        figures: &Figures<R>,
        out: &mut String,
        shown: impl Fn(&R) -> String,
    ) -> Result<(), SimError> {
        let shown = |x: &R, figure| {
            if x.is_defined() {
                Ok(shown(x))
            } else {
                Err(SimError::NotFinite {
                    interval: h,
                    figure,
                })
            }
        };
        // Writing to a string does not fail.
        let _ = write!(out, "{h}");
        let known = figures.row.iter().map(Some);
        let rest = figures.net.iter().chain([&figures.margin]);
        for (name, x) in ROW.into_iter().zip(known.chain(rest.map(Option::as_ref))) {
            out.push(',');
            match x {
                Some(x) => out.push_str(&shown(x, name)?),
                None if self.encloses => out.push(','),
                None => {}
            }
            if name == "xi1" {
                out.push_str(",1"); // Δτ
            }
        }
        figures.put_truths(out);
        for (name, x) in MOTION.into_iter().zip(&figures.motion) {
            let _ = write!(out, ",{}", shown(x, name)?);
        }
        Ok(())
    }
}

impl Si {
    /// Appends a row in SI units, with the motion at the sample. Of a position that may be by an encoder edge it is
    /// given what it is exactly, so that what is written is read in the same tick.
    fn put<R>(
        &mut self,
        h: u64,
        figures: &Figures<R>,
        out: &mut String,
        (in_unit, by_edge): (
            impl Fn(&R, &BigRational) -> f64,
            impl Fn(&R) -> Option<BigRational>,
        ),
    ) -> Result<(), SimError> {
        let [start, end, linear, quantized, ..] = &figures.row;
        let [v0, v1, dissipated] = &figures.motion;
        let finite = |x: &R, unit: &BigRational, figure| match in_unit(x, unit) {
            x if x.is_finite() => Ok(x),
            _ => Err(SimError::NotFinite {
                interval: h,
                figure,
            }),
        };
        let motion = |xi: &R, v: &R| {
            let x = finite(xi, &self.length, "x")?;
            let x = match by_edge(xi) {
                Some(xi) => self.in_tick(x, &xi.floor()),
                None => x,
            };
            Ok([x, finite(v, &self.speed, "v")?])
        };
        self.sample(h, motion(start, v0)?, out);
        for (name, x) in [
            ("generated_linear", linear),
            ("generated_quantized", quantized),
            ("dissipated", dissipated),
        ] {
            // Writing to a string does not fail.
            let _ = write!(out, ",{:?}", finite(x, &self.energy, name)?);
        }
        let after = motion(end, v1)?;
        figures.put_truths(out);
        out.push('\n');
        self.end = Some((h + 1, after));
        Ok(())
    }

    /// The double nearest to this one that is read in this tick.
    fn in_tick(&self, mut x: f64, tick: &BigRational) -> f64 {
        let read = |x: f64| parse(&format!("{x:?}")).map(|x| (x / &self.length).floor());
        while read(x).is_ok_and(|read| read < *tick) {
            x = x.next_up();
        }
        while read(x).is_ok_and(|read| read > *tick) {
            x = x.next_down();
        }
        x
    }

    /// Appends a sample's number and time, and the motion at it.
    fn sample(&self, h: u64, [x, v]: [f64; 2], out: &mut String) {
        let time = nearest_f64(&(BigRational::from_integer(h.into()) * &self.period));
        // Writing to a string does not fail.
        let _ = write!(out, "{h},{time:?},{x:?},{v:?}");
    }
}

impl<R: Real> Account<R> {
    fn new(point: &Point, known: bool, of: impl Fn(&BigRational) -> R) -> Self {
        let criterion = point.at.dimensionless_criterion();
        // Before the first sample nothing moved.
        let late = usize::from(point.at.delay);
        Self {
            stored: known.then(|| vec![R::zero(); late + 1].into()),
            dimensionless: point.at.map(|_, x| of(x)),
            criterion: Criterion {
                viscous: of(&criterion.viscous),
                coulomb: of(&criterion.coulomb),
            },
        }
    }

    /// What the extra storages of delay and damping gain over an interval (TH-DELAY, TH-DAMP).
    fn gained(&mut self, displacement: &R) -> Option<R> {
        let Loop { delay, damping, .. } = &self.dimensionless;
        let steps = self.stored.as_mut()?;
        let storage = |steps: &mut VecDeque<R>| {
            let steps = steps.make_contiguous();
            let late = steps.get(..usize::from(*delay)).unwrap_or_default();
            let delayed = extra_storage::delay_storage(late);
            match damping {
                Some(damping) => delayed + extra_storage::damping_storage(damping, steps),
                None => delayed,
            }
        };
        let before = storage(steps);
        steps.pop_back();
        steps.push_front(displacement.clone());
        Some(storage(steps) - before)
    }

    /// The kernel's row of an interval of a run, which knows what was generated.
    fn figures(&mut self, interval: &IntervalRow<R>) -> Figures<R> {
        let step = &interval.step;
        let row = ledger::row_of(
            &self.dimensionless,
            step,
            &R::one(),
            interval.generated.clone(),
        );
        let gained = self.gained(&step.displacement());
        let net = [row.net_linear, row.net_quantized];
        let net = net.map(|net| Some(net - gained.clone()?));
        let violates = |net: &Option<R>| net.as_ref()?.is_nonnegative().map(|ok| !ok);
        let [violates_linear, violates_quantized] = net.each_ref().map(violates);
        let speed = step.displacement().abs();
        // Where a step may be none, its mean speed has no margin, and where it is none the criterion holds.
        let moves = speed.is_positive();
        let moved = moves == Some(true);
        let at_speed = self.criterion.margin(&speed).is_nonnegative();
        let holds = match moves {
            Some(false) => Some(true),
            Some(true) => at_speed,
            None => at_speed.filter(|holds| *holds),
        };
        let over_speed = || self.criterion.coulomb.clone().over(speed);
        let bound_quantized = if row.bound_quantized.is_defined() {
            row.bound_quantized.clone()
        } else {
            // A way that may be a whole tick: between 0 and 1/8 more.
            let eighth = R::one().half().half().half();
            row.bound_22.clone() + R::zero().join(eighth)
        };
        let [v0, v1] = interval.velocity.clone();
        Figures {
            margin: moved.then(|| self.criterion.viscous.clone() + over_speed()),
            truths: [holds, violates_linear, violates_quantized],
            row: [
                step.start.clone(),
                step.end.clone(),
                row.generated_linear,
                row.generated_quantized,
                row.bound_22,
                bound_quantized,
                row.dissipated_lower,
            ],
            net,
            motion: [v0, v1, interval.dissipated.clone()],
        }
    }
}
