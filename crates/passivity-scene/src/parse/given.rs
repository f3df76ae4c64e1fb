//! From an amount as it was written to the values of a parameter: bounds, the side of a transmission,
//! how a text was taken.

use passivity_core::parameter::Hurts;
use passivity_core::{BigRational, Exact, Interval, Ordered as _, Parameter};

use crate::diagnostic::{Diagnostic, Kind};
use crate::parse::amount::{Amount, Bound};
use crate::parse::keys::shorten;
use crate::parse::node::{Content, Node};
use crate::parse::reader::{Reader, Spec};
use crate::scene::Given;
use crate::written::Form;

impl Reader<'_> {
    /// The value in SI units, when its sign is allowed, tolerance included.
    pub(super) fn given(
        &mut self,
        node: &Node,
        spec: &Spec,
        amount: &Amount,
        form: Form,
    ) -> Option<Given> {
        // The unit's place was noted within the text: now it is known where the text stands.
        if let Some(note) = self
            .unit_notes
            .last_mut()
            .filter(|note| note.key == spec.key)
        {
            note.span = node.part(note.span.clone());
        }
        let text = match &node.content {
            Content::Text(text, _) | Content::Number(text) => text.clone(),
            _ => String::new(),
        };
        let about = |kind, message: String| {
            Diagnostic::new(kind, message)
                .at(node.span.clone())
                .key(spec.key)
                .expected(spec.values.expected())
                .found(format!("`{}`", shorten(&text)))
        };
        let allowed = |x: &BigRational| x.sign().is_some_and(|sign| spec.values.allow(sign));
        if !allowed(&amount.nominal) {
            let message = format!("`{}` cannot be `{}`", spec.key, shorten(&text));
            self.report(about(Kind::OutOfBounds, message));
            return None;
        }
        if !allowed(&amount.lo) {
            let unit = amount.unit_text.as_ref().map_or("", |(unit, _)| unit);
            let least = format!("{} {}", crate::display::approx(&amount.lo), shorten(unit));
            let least = least.trim_end();
            let message = format!("the tolerance lets `{}` be as low as {least}", spec.key);
            self.report(about(Kind::ToleranceOutOfBounds, message));
            return None;
        }
        let (amount, remark) = match self.closed(amount, spec) {
            Ok(closed) => closed,
            Err(expected) => {
                let message = format!("`{}` is given as a bound on one side", spec.key);
                self.report(about(Kind::OutOfBounds, message).expected(expected));
                return None;
            }
        };
        let mut written = amount.written(form);
        if spec.at_motor {
            written = written.at_motor(&self.factor(spec.parameter)?);
        }
        let value = Interval::hull(written.typed(&amount.lo), written.typed(&amount.hi));
        Some(Given {
            key: spec.key,
            value,
            nominal: written.typed(&amount.nominal),
            text,
            written,
            span: node.span.clone(),
            remark,
            parts: None,
        })
    }

    /// What a quantity at the motor is multiplied with to have it at the device; `None`, and a
    /// diagnostic before, where no transmission says it.
    pub(super) fn factor(&self, parameter: Parameter) -> Option<Exact> {
        Some(self.transmission.as_ref()?.factor(parameter))
    }

    /// The amount with the open side of a bound closed, and how its text was taken; on a bound that
    /// says nothing safe, what was expected.
    fn closed(
        &self,
        amount: &Amount,
        spec: &Spec,
    ) -> Result<(Amount, Option<String>), &'static str> {
        let unit = amount.unit_text.as_ref().map_or("", |(unit, _)| unit);
        let weight = amount.is_weight.then(|| {
            format!(
                "{}: the mass in `{}` is taken as its weight at standard gravity",
                spec.key,
                shorten(unit)
            )
        });
        let amount = amount.clone();
        let bound = match (amount.bound, spec.parameter, spec.parameter.row().hurts) {
            (None, ..) | (Some(Bound::AtMost), Parameter::MaxSpeed, _) => {
                return Ok((amount, weight));
            }
            (_, Parameter::MaxSpeed, _) => return Err("the largest speed, as a value"),
            (_, _, Hurts::Neither) => return Err("a value, with a tolerance where there is one"),
            (Some(bound), ..) => bound,
        };
        let closed = amount.closed(spec.values);
        let shown = |x: &BigRational| format!("{} {}", crate::display::approx(x), shorten(unit));
        let (side, other) = match bound {
            Bound::AtMost => ("most", &closed.lo),
            Bound::AtLeast => ("least", &closed.hi),
        };
        let remark = format!(
            "{}: given as at {side} {}, taken as anything from there to {}",
            spec.key,
            shown(&closed.nominal).trim_end(),
            shown(other).trim_end()
        );
        let remark = match weight {
            Some(weight) => format!("{remark}; {weight}"),
            None => remark,
        };
        Ok((closed, Some(remark)))
    }
}
