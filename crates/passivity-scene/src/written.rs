//! How a scene file writes a parameter: its unit, and whether it writes the value or its reciprocal.
//!
//! Figures for people come in the units of the scene file, so that they can be typed back into it.

use num_bigint::BigInt;
use num_traits::Signed;
use passivity_core::{BigRational, Exact, Interval, Scalar};

use crate::check::enclosure;
use crate::display::{Rounding, approx, range, range_with, rounded};
use crate::number::parse;

/// What a scene file writes for a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The value itself.
    Value,
    /// Its reciprocal: the sampling rate for the period.
    Reciprocal,
    /// A whole number, inversely: counts per revolution for the resolution.
    Count,
    /// Its reciprocal over 2π: the cutoff of a filter for its time constant.
    Cutoff,
}

/// The form and the unit in which a scene file writes a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    form: Form,
    unit: String,
    /// The SI value where the file writes 1: the size of the unit, or its reciprocal.
    one: Exact,
    /// Whether the file writes the value at the motor's side of a transmission.
    at_motor: bool,
}

impl Written {
    /// A value in an SI unit; an empty text is no unit.
    #[must_use]
    pub fn si(unit: &str) -> Self {
        Self::new(Form::Value, unit, Exact::one())
    }

    pub(crate) fn new(form: Form, unit: &str, one: Exact) -> Self {
        Self {
            form,
            unit: unit.to_owned(),
            one,
            at_motor: false,
        }
    }

    /// The same written at the motor's side of a transmission, where 1 is `factor` at the device.
    pub(crate) fn at_motor(self, factor: &Exact) -> Self {
        Self {
            one: self.one * factor.clone(),
            at_motor: true,
            ..self
        }
    }

    /// Whether the file writes the value at the motor's side of a transmission.
    pub(crate) const fn is_at_motor(&self) -> bool {
        self.at_motor
    }

    /// Whether the numbers of the file have a unit.
    pub(crate) const fn has_unit(&self) -> bool {
        !self.unit.is_empty()
    }

    /// The same unit per second: of a speed, where this is one of a position at the device.
    pub(crate) fn per_second(&self) -> Option<Self> {
        let is_plain = self.form == Form::Value && !self.at_motor && !self.unit.contains('/');
        is_plain.then(|| Self::new(Form::Value, &format!("{}/s", self.unit), self.one.clone()))
    }

    /// Whether the file writes the value or its reciprocal.
    #[must_use]
    pub const fn form(&self) -> Form {
        self.form
    }

    /// The unit as the file writes it, after a space; nothing where there is none. What the file
    /// writes at the motor's side of a transmission says so.
    #[must_use]
    pub fn unit(&self) -> String {
        let side = if self.at_motor { " at the motor" } else { "" };
        match self.unit.as_str() {
            "" => side.to_owned(),
            unit => format!(" {unit}{side}"),
        }
    }

    /// The SI value of a number that is typed into the file; the number must be above zero where
    /// the file writes a reciprocal.
    pub(crate) fn typed(&self, number: &BigRational) -> Exact {
        match self.form {
            Form::Value => self.one.clone() * Exact::of(number),
            Form::Reciprocal | Form::Cutoff | Form::Count => {
                self.one.clone().over(Exact::of(number))
            }
        }
    }

    /// The numbers that the file writes for SI values; `None` for the reciprocal of what is not
    /// above zero.
    #[must_use]
    pub fn of(&self, si: &Interval<BigRational>) -> Option<Interval<BigRational>> {
        let one = enclosure(&Interval::point(self.one.clone()))?;
        let over = |a: &BigRational, b: &BigRational| a.clone().over(b.clone());
        let ends = |x: &BigRational| match self.form {
            Form::Value => Some([over(x, one.lo()), over(x, one.hi())]),
            _ if !x.is_positive() => None,
            _ => Some([over(one.lo(), x), over(one.hi(), x)]),
        };
        let [a, b] = ends(si.lo())?;
        let [c, d] = ends(si.hi())?;
        Some(Interval::hull(a, b).joined(&Interval::hull(c, d)))
    }

    /// SI values as people read them, with the unit; in SI where the file cannot write them.
    #[must_use]
    pub fn text(&self, si: &Interval<BigRational>, si_unit: &str) -> String {
        self.text_by(si, si_unit, range)
    }

    /// The same with that many significant digits.
    pub(crate) fn text_with(
        &self,
        si: &Interval<BigRational>,
        si_unit: &str,
        digits: u32,
    ) -> String {
        self.text_by(si, si_unit, |x| range_with(x, digits))
    }

    fn text_by(
        &self,
        si: &Interval<BigRational>,
        si_unit: &str,
        figures: impl Fn(&Interval<BigRational>) -> String,
    ) -> String {
        match self.of(si) {
            Some(written) => format!("{}{}", figures(&written), self.unit()),
            None => format!("{} {si_unit}", figures(si)),
        }
    }

    /// A value x ≥ 0 as people read it, rounded to one side, with the unit; in SI where the file
    /// cannot write it.
    #[must_use]
    pub fn rounded_text(&self, si: &BigRational, to: Rounding, si_unit: &str) -> String {
        match self.rounded(si, 5, to) {
            Some(figure) => format!("{figure}{}", self.unit()),
            None => format!("{} {si_unit}", rounded(si, 5, to)),
        }
    }

    /// The number of at most five digits that the file writes for a value, up to the error of an
    /// enclosure; `None` where there is none.
    pub(crate) fn short(&self, si: &BigRational) -> Option<String> {
        let written = self.of(&Interval::point(si.clone()))?;
        let text = approx(written.lo());
        let number = parse(&text).ok()?;
        if self.form == Form::Count && !number.is_integer() {
            return None;
        }
        let error = Signed::abs(&(written.lo() - number));
        // The figures of a report are enclosed to 200 bits: about 60 digits.
        let small = BigRational::new(1.into(), BigInt::from(10).pow(50));
        (error <= Signed::abs(written.lo()) * small).then_some(text)
    }

    /// A value x ≥ 0 as the file writes it, rounded to one side of x, with that many digits and
    /// without the unit.
    #[must_use]
    pub fn rounded(&self, si: &BigRational, digits: u32, to: Rounding) -> Option<String> {
        let written = self.of(&Interval::point(si.clone()))?;
        let to = match (self.form, to) {
            (Form::Value, to) => to,
            (_, Rounding::Down) => Rounding::Up,
            (_, Rounding::Up) => Rounding::Down,
        };
        let end = match to {
            Rounding::Down => written.lo(),
            Rounding::Up => written.hi(),
        };
        if self.form == Form::Count {
            let whole: BigInt = match to {
                Rounding::Down => end.floor().to_integer(),
                Rounding::Up => end.ceil().to_integer(),
            };
            return Some(whole.to_string());
        }
        Some(rounded(end, digits, to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::pi;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    #[test]
    fn a_limit_is_rounded_to_the_side_that_the_file_writes() {
        let mm = Written::new(Form::Value, "mm", Exact::of(&ratio(1, 1000)));
        let third = ratio(1, 3);
        assert_eq!(mm.rounded(&third, 5, Rounding::Down).unwrap(), "333.33");
        let khz = Written::new(Form::Reciprocal, "kHz", Exact::of(&ratio(1, 1000)));
        let period = ratio(3, 10_000);
        assert_eq!(khz.rounded(&period, 5, Rounding::Down).unwrap(), "3.3334");
        let counts = Written::new(Form::Count, "", pi::pi() + pi::pi());
        let resolution = ratio(1, 100);
        assert_eq!(
            counts.rounded(&resolution, 5, Rounding::Down).unwrap(),
            "629"
        );
    }

    #[test]
    fn what_cannot_be_written_stays_in_si() {
        let khz = Written::new(Form::Reciprocal, "kHz", Exact::of(&ratio(1, 1000)));
        let zero = Interval::point(ratio(0, 1));
        assert_eq!(khz.of(&zero), None);
        assert_eq!(khz.text(&zero, "s"), "0 s");
    }
}
