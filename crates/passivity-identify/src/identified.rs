//! From samples to what is known of the device's parameters.

use std::fmt;
use std::path::Path;

use passivity_audit::{Dialect, Sampled, TraceError, samples};
use passivity_core::Parameter;
use passivity_scene::display::figures;
use passivity_scene::{Motion, Scene};

use crate::directed::{add, add_down, div, mul, mul_down};
use crate::estimate;
use crate::fitting::fitting;
use crate::lacks::{self, Lack};
use crate::log::{Errors, Log};
use crate::options::{Inertia, Options};
use crate::region::{COULOMB, Ends, INERTIA, Shear, parts};
use crate::report::{DIGITS, best_refuted};
use crate::search::{self, Found, Judge, Task};
use crate::sketch::{covered, ends, inertia, middle, units};
use crate::suspects::suspicion;

/// What is known of a parameter, in SI units (in K, T and Δ where the sketch is dimensionless).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The parameter is surely not below this.
    pub lo: f64,
    /// The parameter is surely not above this; `None` where nothing bounds it.
    pub hi: Option<f64>,
    /// The best estimate; `None` where the device did not surely move.
    pub best: Option<f64>,
}

/// Where the logs show that no parameters fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Refutation {
    /// Which log, from 0.
    pub log: usize,
    /// The row of the log, from 1: no parameters fit the rows up to it, and those of the logs before.
    pub row: usize,
    /// When that row was recorded, in seconds (sampling periods where the sketch is dimensionless) from the
    /// log's first one.
    pub time: f64,
    /// What it may be.
    pub suspicion: String,
}

/// What the logs say of the device.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Viscous and Coulomb friction, and the inertia where it was looked for; nothing where nothing fits.
    pub parameters: Vec<(Parameter, Bounds)>,
    /// How many samples the logs have.
    pub samples: usize,
    /// Where the logs show that no parameters fit.
    pub refuted_by: Option<Refutation>,
    /// Whether the work came to its bound before the box was as narrow as it could be.
    pub stopped_early: bool,
    /// Whether the logs refute the best estimate: no parameters were found that they do not.
    pub best_refuted: bool,
    /// What the logs lack: where the box is wide, and where all motion is one way.
    pub lacks: Vec<Lack>,
    pub(crate) logs: Vec<Log>,
    pub(crate) found: Found,
    #[cfg_attr(not(feature = "plot"), expect(dead_code, reason = "for pictures"))]
    pub(crate) shear: Shear,
    pub(crate) best: Option<[f64; 3]>,
    /// Where the inertia was looked for.
    pub(crate) inertia: Ends,
    /// By how much the logged force may be off, in KΔ.
    pub(crate) force_error: f64,
    /// How many times the logged one it may be.
    pub(crate) scale: Ends,
    /// Whether somebody says that.
    pub(crate) is_scale_said: bool,
    pub(crate) units: [[f64; 2]; 3],
    /// T in seconds.
    pub(crate) period: f64,
    pub(crate) motion: Motion,
}

/// Why parameters cannot be looked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IdentifyError {
    pub(crate) message: String,
    pub(crate) is_not_covered: bool,
    pub(crate) log: Option<usize>,
}

impl IdentifyError {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            is_not_covered: false,
            log: None,
        }
    }

    /// Which of the logs it is about, from 0; `None` where it is about none of them alone.
    #[must_use]
    pub const fn log(&self) -> Option<usize> {
        self.log
    }

    /// Whether the sketch has an effect that TH-IDENT does not cover.
    #[must_use]
    pub const fn is_not_covered(&self) -> bool {
        self.is_not_covered
    }
}

impl fmt::Display for IdentifyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for IdentifyError {}

/// Reads the samples of a log.
///
/// # Errors
///
/// [`TraceError`] as [`samples`].
pub fn read(path: &Path, scene: &Scene, dialect: &Dialect) -> Result<Sampled, TraceError> {
    samples(path, scene, dialect)
}

/// The parameters that are looked for, in the order of a box.
pub(crate) const PARAMETERS: [Parameter; 3] =
    [Parameter::Viscous, Parameter::Coulomb, Parameter::Inertia];

/// Looks for the parameters that can have produced the logs (TH-IDENT); `progress` is told how much of the
/// effort is spent, and ends the search where it says `false`: the bounds are then wider, and as sure.
///
/// # Errors
///
/// [`IdentifyError`] for a sketch with effects that are not covered, for one without an encoder, and for a
/// log that does not start at rest.
///
/// # Example
///
/// ```
/// use passivity_audit::{Number, Reading};
/// use passivity_identify::{Options, Sampled, identify};
/// use passivity_scene::Scene;
///
/// // Pushed with 10 KΔ for ten samples, a device with μ = 10, β = 0 and σ = 1 coasts to rest.
/// let sketch = Scene::from_toml("sketch", "[dimensionless]\nmu = 10").unwrap();
/// let way = |n: i64| match n {
///     0..=10 => 45 * n * n / 100,
///     n => 45 + (900 * (n - 10) - 5 * (n - 10) * (n - 10)) / 100,
/// };
/// let count = |n: i64| Reading::Count(way(n.min(100)));
/// let force = |n: i64| Reading::Exact(Number::whole(if n < 10 { 10 } else { 0 }));
/// let log = Sampled {
///     positions: (0..120).map(count).collect(),
///     forces: (0..120).map(force).collect(),
///     durations: vec![Number::whole(1); 119],
/// };
/// let found = identify(&[log], &sketch, &Options::default(), |_| true).unwrap();
/// let (_, coulomb) = found.parameters[1];
/// assert!(coulomb.lo <= 1.0 && 1.0 <= coulomb.hi.unwrap());
/// ```
pub fn identify(
    sampled: &[Sampled],
    sketch: &Scene,
    options: &Options,
    progress: impl FnMut(u64) -> bool,
) -> Result<Identified, IdentifyError> {
    covered(sketch)?;
    options.check()?;
    let nominal = sketch.given.map(|_, given| given.nominal.clone());
    let units = units(&nominal)?;
    let force_unit = *units.get(COULOMB).unwrap_or(&[1.0; 2]);
    let errors = Errors {
        count: options.count_error,
        force: div(options.force_error, force_unit[0]),
    };
    let logs: Vec<Log> = sampled.iter().map(|one| Log::of(one, errors)).collect();
    if logs.is_empty() {
        return Err(IdentifyError::new("a log is needed"));
    }
    for (number, log) in logs.iter().enumerate() {
        log.starts_at_rest().map_err(|error| IdentifyError {
            log: Some(number),
            ..error
        })?;
    }
    let known = match options.inertia {
        Inertia::Sketch => inertia(sketch, &nominal)?,
        Inertia::Free => None,
    };
    // m·dv/dt = κ·u − b·v − c·sgn(v), κ from 1 − s to 1 + s, is the motion of m/κ, b/κ and c/κ under u.
    let share = options.scale_error.unwrap_or(0.0);
    let scale = [add_down(1.0, -share), add(1.0, share)];
    let known = known.map(|[lo, hi]| match share == 0.0 {
        true => [lo, hi],
        false => [-div(-lo, scale[1]), div(hi, scale[0])],
    });
    let period = middle(ends(&nominal.period)?);
    let bounds = search::first_bounds(&logs);
    // Without an inertia in the sketch it is looked for over six decades.
    let mass = bounds[2].unwrap_or(0.0);
    let (inertia, slabs) = match known {
        Some(ends) => (ends, 1),
        None => ([mass * LEAST_INERTIA, mass], SLABS),
    };
    let least_inertia = 1.001 * LEAST_INERTIA * mass;
    let whole = |found: Found, shear, best: Option<([f64; 3], bool)>, suspicion: String| {
        let mut identified = Identified {
            parameters: Vec::new(),
            samples: logs.iter().map(Log::len).sum(),
            refuted_by: None,
            stopped_early: found.stopped_early,
            best_refuted: best.is_some_and(|(_, is_refuted)| is_refuted),
            lacks: Vec::new(),
            logs: logs.clone(),
            found,
            shear,
            best: best.map(|(best, _)| best),
            inertia,
            force_error: errors.force,
            scale,
            is_scale_said: options.scale_error.is_some(),
            units,
            period,
            motion: sketch.motion,
        };
        identified.describe(known.is_none(), least_inertia, suspicion);
        identified
    };
    let [Some(viscous), Some(coulomb), Some(_)] = bounds else {
        let nothing = Found {
            parts: Vec::new(),
            hull: None,
            refuted_by: None,
            fits: None,
            stopped_early: false,
        };
        return Ok(whole(nothing, Shear::default(), None, String::new()));
    };
    let most = [viscous, coulomb];
    let first = estimate::first(&logs, most, inertia);
    let (shear, weights) = estimate::coordinates(&logs, first);
    let task = Task {
        logs: &logs,
        shear,
        weights,
        most,
        near: first,
        effort: options.effort,
    };
    let found = task.search(parts(&shear, most, inertia, slabs), progress);
    let best = found.hull.map(|hull| {
        let left = (found.parts.as_slice(), &hull);
        let best = estimate::best(&logs, left, (&shear, weights), first);
        match fitting(&logs, &hull, best, found.fits) {
            Some(fitting) => (fitting, false),
            None => (best, true),
        }
    });
    let refuted = found.refuted_by;
    let suspicion = refuted.map_or_else(String::new, |place| {
        suspicion(&logs, place, (inertia, slabs))
    });
    Ok(whole(found, shear, best, suspicion))
}

/// The least inertia that is looked for, of the largest that the logs allow.
const LEAST_INERTIA: f64 = 1e-6;

/// Into how many parts it is cut before the search.
const SLABS: u32 = 20;

impl Identified {
    /// Whether some parameters fit the logs.
    #[must_use]
    pub const fn fits(&self) -> bool {
        self.refuted_by.is_none()
    }

    /// Whether every parameter is bounded on both sides.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.fits()
            && self
                .parameters
                .iter()
                .all(|(_, bounds)| bounds.hi.is_some())
    }

    /// Why no scene can be written, if none can.
    #[must_use]
    pub fn unwritten(&self) -> Option<String> {
        if !self.fits() {
            return Some("no parameters fit the logs".to_owned());
        }
        if !self.is_bounded() {
            return Some("a parameter has no bounds".to_owned());
        }
        let mut known = self.parameters.iter();
        let inertia = known.find(|(parameter, _)| *parameter == Parameter::Inertia);
        inertia.filter(|(_, bounds)| bounds.lo <= 0.0).map(|_| {
            "the logs leave open how small the inertia is, and that of a scene must be above zero: give the \
             inertia in the sketch, with a generous tolerance, or try more --effort"
                .to_owned()
        })
    }

    /// Whether the box is narrow: every best estimate within 5 % of the true value, wherever in the box that is.
    #[must_use]
    pub fn is_informative(&self) -> bool {
        self.fits() && self.parameters.iter().all(|(_, bounds)| bounds.is_narrow())
    }

    /// Why the bounds may be wrong, however narrow they are: what the logs leave open of whether the device is one of
    /// the model.
    #[must_use]
    pub fn doubts(&self) -> Vec<String> {
        let refuted = self.best_refuted.then(|| best_refuted(self.stopped_early));
        let lacks = self.lacks.iter().filter(|lack| lack.is_doubt());
        refuted
            .into_iter()
            .chain(lacks.map(ToString::to_string))
            .collect()
    }

    /// Fills in what follows from the search.
    fn describe(&mut self, inertia_is_free: bool, least_inertia: f64, suspicion: String) {
        if let Some(place) = self.found.refuted_by {
            let log = self.logs.get(place.log);
            let time = log.and_then(|log| log.times().get(place.sample).copied());
            self.refuted_by = Some(Refutation {
                log: place.log,
                row: place.sample + 1,
                time: time.map_or(f64::NAN, |time| time * self.period),
                suspicion,
            });
            return;
        }
        let wanted = if inertia_is_free { 3 } else { 2 };
        let [least, most] = self.scale;
        let less = |x: f64| if least == 1.0 { x } else { mul_down(x, least) };
        let more = |x: f64| if most == 1.0 { x } else { mul(x, most) };
        for (dimension, parameter) in PARAMETERS.into_iter().enumerate().take(wanted) {
            let unit = self.units.get(dimension).copied().unwrap_or([f64::NAN; 2]);
            let ends = self
                .found
                .hull
                .and_then(|region| region.get(dimension).copied());
            let best = self.best.and_then(|best| best.get(dimension).copied());
            // An inertia may be smaller than what was looked at.
            let is_open = dimension == INERTIA && ends.is_some_and(|[lo, _]| lo <= least_inertia);
            let lo = match ends.filter(|_| !is_open) {
                Some([lo, _]) => less(mul_down(lo, unit[0])),
                None => 0.0,
            };
            let hi = ends.map(|[_, hi]| more(mul(hi, unit[1])));
            let best = best.map(|best| best * middle(unit));
            self.parameters.push((
                parameter,
                Bounds {
                    // Not minus zero.
                    lo: lo + 0.0,
                    hi,
                    best: best.map(|best| best.clamp(lo, hi.unwrap_or(f64::INFINITY))),
                },
            ));
        }
        self.shorten();
        self.lacks = lacks::lacks(self);
    }

    /// Rounds the best estimate to as few digits as do not lead it to what the logs refute, or out of its bounds.
    fn shorten(&mut self) {
        let mut judge = Judge::new(&self.logs);
        let mut all = DIGITS;
        let rounded = all.find_map(|digits| {
            let mut best = self.best?;
            let mut known = self.parameters.clone();
            let units = self.units.into_iter().map(middle);
            for (((_, bounds), best), unit) in known.iter_mut().zip(&mut best).zip(units) {
                let short: f64 = figures(bounds.best?, digits).parse().ok()?;
                let hi = bounds.hi.unwrap_or(f64::INFINITY);
                if !(bounds.lo..=hi).contains(&short) {
                    return None;
                }
                bounds.best = Some(short);
                *best = short / unit;
            }
            (self.best_refuted || judge.lets(best)).then_some((known, best))
        });
        if let Some((known, best)) = rounded {
            (self.parameters, self.best) = (known, Some(best));
        }
    }
}

impl Bounds {
    /// How far the best estimate is at the most from each value within bounds that are narrow, in parts of that value.
    pub const NEAR: f64 = 0.05;

    /// Whether the best estimate is within 5 % of the true value, wherever within the bounds that is.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_identify::Bounds;
    ///
    /// let bounds = |lo, hi| Bounds { lo, hi: Some(hi), best: Some(2.0) };
    /// assert!(bounds(1.91, 2.1).is_narrow());
    /// // Where 1.9 is true, 2.0 is 5.3 % off.
    /// assert!(!bounds(1.9, 2.1).is_narrow());
    /// ```
    #[must_use]
    pub fn is_narrow(&self) -> bool {
        match (self.hi, self.best) {
            (Some(hi), Some(best)) => {
                best <= (1.0 + Self::NEAR) * self.lo && best >= (1.0 - Self::NEAR) * hi
            }
            _ => false,
        }
    }
}
