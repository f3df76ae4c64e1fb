//! A report on several joints, for people.

use std::fmt::Write as _;

use num_traits::{Signed as _, Zero as _};
use passivity_core::{BigRational, Interval, Parameter};

use super::limits::JointLimit;
use super::report::{JointReport, OfJoint};
use crate::check::{Verdict, short, unit_of, words};
use crate::display::{Rounding, rounded, wrapped};
use crate::scene::Motion;

impl JointReport {
    /// The report as text, a screen for a scene.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        let mut line = |label: &str, value: &str| {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "  {label:<24}  {}", wrapped(value, 28));
        };
        line("wall", &self.wall_text());
        line("diag(b) − (T/2)K", self.viscous_text());
        self.stiffness_lines(&mut line);
        for (joint, name) in self.joints.iter().zip(&self.joint_names) {
            line(name, &joint.text());
        }
        line("effects", &words(&self.effects));
        line("because", &self.because.join(", "));
        for (at, remark) in self.remarks.iter().enumerate() {
            line(if at == 0 { "taken" } else { "" }, remark);
        }
        let mut text = format!("{}: {}\n{out}", self.scene, self.headline());
        text.push_str(&self.witness_text());
        text.push_str(&self.limits_text());
        text
    }

    /// The verdict in one line.
    #[must_use]
    pub fn headline(&self) -> String {
        match self.verdict {
            Verdict::Passive => format!("PASSIVE {}", self.speeds_text()),
            Verdict::NotPassive => "NOT PASSIVE: a cycle draws energy from it".to_owned(),
            Verdict::Depends if self.decided_by.is_empty() => {
                "DEPENDS on digits of π beyond those that were looked at".to_owned()
            }
            Verdict::Depends => {
                format!("DEPENDS on the tolerance of {}", self.decided_by.join(", "))
            }
            Verdict::NotGuaranteed | Verdict::NotCovered => {
                let speeds = self.speeds_text();
                format!("NOT GUARANTEED passive {speeds}: the criterion fails")
            }
        }
    }

    /// The speeds that the headline and the limits speak of.
    #[must_use]
    pub const fn speeds_text(&self) -> &'static str {
        if self.at_every_speed || !self.is_bounded {
            "at every speed"
        } else {
            "at every speed up to the bounds of the joints"
        }
    }

    fn wall_text(&self) -> String {
        match self.direction_texts.as_slice() {
            [] => format!("a stiffness matrix for {} joints", self.joints.len()),
            ways => format!("moves by {}, one entry a joint", ways.join(", ")),
        }
    }

    pub(super) const fn viscous_text(&self) -> &'static str {
        match self.viscous_definite {
            Some(true) => {
                "positive semidefinite: viscous friction outweighs sampling at every speed"
            }
            Some(false) => {
                "not positive semidefinite: fast enough, sampling outweighs viscous friction"
            }
            None => "depends on the tolerances whether it is positive semidefinite",
        }
    }

    fn stiffness_lines(&self, line: &mut impl FnMut(&str, &str)) {
        if let Some(factor) = &self.max_matrix_factor {
            let factor = rounded(factor.lo(), 5, Rounding::Down);
            let speeds = self.speeds_text();
            line(
                "stiffest wall",
                &format!("{factor} times this matrix {speeds}"),
            );
        }
        let rows = [
            (&self.max_stiffness_all_speeds, "at every speed"),
            (
                &self.max_stiffness_at_speed_bound,
                "up to the bounds of the joints",
            ),
        ];
        let unit = unit_of(Parameter::Stiffness, self.wall);
        let mut label = "stiffest wall";
        for (k, speeds) in rows {
            if let Some(k) = k {
                let k = self
                    .stiffness_written
                    .rounded_text(k.lo(), Rounding::Down, unit);
                line(label, &format!("{k} {speeds}"));
                label = "";
            }
        }
    }

    fn witness_text(&self) -> String {
        let Some(witness) = &self.witness else {
            return String::new();
        };
        let Some(step) = witness.moves.first() else {
            return String::new();
        };
        let names = self.joint_names.iter();
        let moved = names
            .zip(&witness.from)
            .zip(step.iter().zip(&witness.units));
        let moved = moved.filter(|(_, (d, _))| !d.is_zero());
        let ways = moved.map(|((name, from), (d, unit))| {
            let to: BigRational = from + d;
            format!("{name} from {} to {} {unit}", short(from), short(&to))
        });
        let ways: Vec<String> = ways.collect();
        let gain = rounded(&witness.gain_per_cycle, 5, Rounding::Down);
        let text = format!(
            "Witness: move {} and back, all at once and each way at constant speed within one \
             sampling interval. Each time round draws at least {gain} J, if friction is no more than \
             the scene allows.",
            ways.join(", ")
        );
        format!("  {}\n", wrapped(&text, 2))
    }

    fn limits_text(&self) -> String {
        if self.limits.is_empty() {
            return String::new();
        }
        let speeds = self.speeds_text();
        let mut out = if self.verdict == Verdict::Passive {
            format!("  Limits, one parameter at a time, to stay passive {speeds}:\n")
        } else {
            format!("  What each parameter would have to be for the criterion to hold {speeds}:\n")
        };
        for limit in &self.limits {
            let _ = writeln!(out, "    {}", self.limit_text(limit));
        }
        out
    }

    fn limit_text(&self, of: &JointLimit) -> String {
        let limit = &of.limit;
        let joint = of.place.joint;
        let motion = match (joint.and_then(|joint| self.joints.get(joint)), joint) {
            (Some(joint), _) => joint.moves(),
            (None, _) => self.wall,
        };
        let name = joint.and_then(|joint| self.joint_names.get(joint));
        let of_joint = name.map_or_else(String::new, |name| format!(", {name}"));
        let enough = if limit.printed.is_some() {
            ""
        } else {
            "; this alone does not suffice"
        };
        format!(
            "{}{of_joint}: {} (now {}){enough}",
            limit.name(motion),
            limit.promise(motion),
            limit.now(motion)
        )
    }
}

impl OfJoint {
    /// How the joint moves.
    #[must_use]
    pub fn moves(&self) -> Motion {
        match self.motion {
            "linear" => Motion::Linear,
            _ => Motion::Rotary,
        }
    }

    fn text(&self) -> String {
        let unit = unit_of(Parameter::Coulomb, self.moves());
        let written = &self.coulomb_written;
        let needed = written.rounded_text(self.coulomb_needed.hi(), Rounding::Up, unit);
        let spare = if self.spare_coulomb.hi().is_negative() {
            let short = Interval::hull(-self.spare_coulomb.hi(), -self.spare_coulomb.lo());
            format!("{} too little", written.text(&short, unit))
        } else {
            format!("{} to spare", written.text(&self.spare_coulomb, unit))
        };
        format!(
            "Coulomb friction {}, of which encoders ask {needed}: {spare}",
            written.text(&self.coulomb, unit)
        )
    }
}
