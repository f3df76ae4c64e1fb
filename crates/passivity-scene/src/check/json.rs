//! A report for programs: the fields of the interface, and some more.

use passivity_core::{BigRational, Interval};
use serde_json::{Map, Value, json};

use super::changes::{Change, Direction};
use super::report::{BoundSource, Report};
use crate::effect::Effect;
use crate::json;

impl Report {
    /// The report as a JSON object, one of the `scenes` of `check --format json`.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let mut fields = Map::new();
        let mut put = |name: &str, value: Value| {
            fields.insert(name.to_owned(), value);
        };
        put("scene", json!(self.scene));
        put(
            "region",
            json!(self.region.map_or("depends", |region| region.name())),
        );
        put("verdict", json!(self.verdict.name()));
        put("because", json!(self.because));
        put("effects", names(&self.effects));
        put("not_covered", names(&self.not_covered));
        put("mu", optional(self.mu.as_ref()));
        put("beta", json::interval(&self.beta));
        put("sigma", optional(self.sigma.as_ref()));
        put("critical_speed", optional(self.critical_speed.as_ref()));
        put(
            "critical_speed_si",
            optional(self.critical_speed_si.as_ref()),
        );
        put(
            "margin_at_all_speeds",
            json::interval(&self.margin_at_all_speeds),
        );
        put("speed_bound", optional(self.speed_bound.as_ref()));
        put("speed_bound_si", optional(self.speed_bound_si.as_ref()));
        put(
            "speed_bound_source",
            json!(self.bound_source.map(BoundSource::name)),
        );
        put(
            "margin_at_speed_bound",
            optional(self.margin_at_speed_bound.as_ref()),
        );
        put(
            "max_stiffness_all_speeds",
            optional(self.max_stiffness_all_speeds.as_ref()),
        );
        put(
            "max_stiffness_at_speed_bound",
            optional(self.max_stiffness_at_speed_bound.as_ref()),
        );
        put("colgate", json!(self.colgate.name()));
        put("abbott_okamura", json!(self.abbott_okamura.name()));
        let witness = self.witness.as_ref().map(|witness| {
            json!({
                "from": json::rational(&witness.from),
                "to": json::rational(&witness.to),
                "gain_per_cycle": json::rational(&witness.gain_per_cycle),
            })
        });
        put("witness", json!(witness));
        put("decided_by", json!(self.decided_by));
        put("changes", self.changes.iter().map(change).collect());
        Value::Object(fields)
    }
}

impl BoundSource {
    /// The key of the scene, or the theorem, that the bound comes from.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::MaxSpeed => "operator.max_speed",
            Self::Start => "TH-START",
        }
    }
}

fn names(effects: &[Effect]) -> Value {
    effects.iter().map(|effect| effect.name()).collect()
}

fn optional(range: Option<&Interval<BigRational>>) -> Value {
    range.map_or(Value::Null, json::interval)
}

fn change(change: &Change) -> Value {
    json!({
        "parameter": change.key,
        "unit": change.unit,
        "now": json::interval(&change.now),
        "border": json::interval(&change.border),
        "holds": match change.direction {
            Direction::AtLeast => "at_least",
            Direction::AtMost => "at_most",
        },
        "suffices": change.suffices,
    })
}
