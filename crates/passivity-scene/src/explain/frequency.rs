//! What a linear loop costs of β, frequency by frequency (TH-LTI).

use std::f64::consts::TAU;

use num_bigint::BigInt;
use num_traits::ToPrimitive as _;
use passivity_core::frequency::ViscousCost;
use passivity_core::{BigRational, Interval};

use crate::number::nearest_f64;
use crate::scene::{Motion, Scene};

/// λ(θ) of a scene at its nominal values, with the frequencies in the scene's own unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Frequency {
    cost: ViscousCost,
    /// T in seconds; 1 for a dimensionless scene.
    period: f64,
    /// Whether frequencies are in cycles per sample.
    dimensionless: bool,
}

impl Frequency {
    /// The cost of a scene's linear loop; `None` behind a one-sided or saturated wall, a latency or an
    /// amplifier, of which other theorems speak, or of too high a degree.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::{Scene, explain::Frequency};
    ///
    /// let late = "[dimensionless]\nbeta = \"2\"\nsigma = \"1\"\n[sampling]\ndelay = 1\n";
    /// let frequency = Frequency::of(&Scene::from_toml("late", late).unwrap()).unwrap();
    /// // ½ + cos θ, largest at rest: 3/2.
    /// assert!((frequency.at(0.0) - 1.5).abs() < 1e-15);
    /// assert_eq!(frequency.worst_text(), "0 cycles/sample");
    /// ```
    #[must_use]
    pub fn of(scene: &Scene) -> Option<Self> {
        let nominal = scene
            .given
            .map(|_, given| Interval::point(given.nominal.clone()));
        let cost = nominal.linear_part(200)?.frequency_response()?;
        let dimensionless = scene.motion == Motion::Dimensionless;
        Some(Self {
            cost,
            period: nearest_f64(&scene.point().units.period),
            dimensionless,
        })
    }

    /// λ at a frequency, up to half the sampling rate.
    #[must_use]
    pub fn at(&self, frequency: f64) -> f64 {
        let cosine = (TAU * frequency * self.period).cos();
        let exact = BigRational::from_float(cosine);
        exact.map_or(f64::NAN, |x| self.cost.at(&x).to_f64().unwrap_or(f64::NAN))
    }

    /// Half the sampling rate.
    #[must_use]
    pub fn highest(&self) -> f64 {
        0.5 / self.period
    }

    /// The frequencies at which λ(θ) is largest, to about nine digits.
    #[must_use]
    pub fn worst(&self) -> Vec<f64> {
        let width = BigRational::new(BigInt::from(1), BigInt::from(1) << 60);
        let bands = self.cost.worst(&width).into_iter();
        let angle = |band: Interval<BigRational>| nearest_f64(band.hi()).clamp(-1.0, 1.0).acos();
        let mut found: Vec<f64> = bands
            .map(|band| angle(band) / (TAU * self.period))
            .collect();
        found.reverse();
        found
    }

    /// The same for people.
    #[must_use]
    pub fn worst_text(&self) -> String {
        let figures: Vec<String> = self.worst().into_iter().map(figure).collect();
        format!("{} {}", figures.join(" and "), self.unit())
    }

    /// The unit of the frequencies.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        if self.dimensionless {
            "cycles/sample"
        } else {
            "Hz"
        }
    }
}

/// About five significant digits.
fn figure(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    // λ is found to 2⁻⁶⁰, its place to about the root of that.
    let digits = (4.0 - x.abs().log10().floor())
        .clamp(0.0, 12.0)
        .to_usize()
        .unwrap_or(0);
    let text = format!("{x:.digits$}");
    if text.contains('.') {
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    text
}
