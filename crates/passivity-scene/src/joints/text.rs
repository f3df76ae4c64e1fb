//! A report on several joints, for people.

use num_traits::{Signed as _, Zero as _};
use passivity_core::{BigRational, Interval, Parameter};

use super::limits::JointLimit;
use super::report::{JointReport, OfJoint};
use crate::check::{Lines, headline, limits_heading, short, unit_of};
use crate::display::{Rounding, rounded, wrapped};
use crate::scene::Motion;

impl JointReport {
    /// The report as text, a screen for a scene.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut lines = Lines::default();
        lines.add("wall", &self.wall_text());
        lines.add("diag(b) − (T/2)K", self.viscous_text());
        self.add_stiffest(&mut lines);
        for (joint, name) in self.joints.iter().zip(&self.joint_names) {
            lines.add(name, &joint.text());
        }
        lines.add_grounds(&self.effects, &self.because, &self.remarks);
        let mut text = format!("{}: {}\n{}", self.scene, self.headline(), lines.0);
        text.push_str(&self.witness_text());
        text.push_str(&self.limits_text());
        text
    }

    /// The verdict in one line.
    #[must_use]
    pub fn headline(&self) -> String {
        let speeds = self.speeds_text();
        headline(self.verdict, speeds, &self.decided_by, &self.not_covered)
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
            [] => match self.joints.len() {
                1 => "a stiffness matrix for 1 joint".to_owned(),
                n => format!("a stiffness matrix for {n} joints"),
            },
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

    fn add_stiffest(&self, lines: &mut Lines) {
        if let Some(factor) = &self.max_matrix_factor {
            let factor = rounded(factor.lo(), 5, Rounding::Down);
            let speeds = self.speeds_text();
            lines.add(
                "stiffest wall",
                &format!("{factor} times this matrix {speeds}"),
            );
        }
        let walls = [
            (&self.max_stiffness_all_speeds, "at every speed"),
            (
                &self.max_stiffness_at_speed_bound,
                "up to the bounds of the joints",
            ),
        ];
        let unit = unit_of(Parameter::Stiffness, self.wall);
        lines.add_stiffest(walls, &self.stiffness_written, unit);
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
        let mut out = limits_heading(self.verdict, self.speeds_text());
        out.extend(self.limits.iter().map(|limit| self.limit_line(limit)));
        out
    }

    fn limit_line(&self, limit: &JointLimit) -> String {
        let joint = limit.place.joint;
        let motion = match (joint.and_then(|joint| self.joints.get(joint)), joint) {
            (Some(joint), _) => joint.moves(),
            // Of a matrix it is a factor; the period is one in any case.
            (None, _) if limit.limit.parameter == Parameter::Stiffness => self.wall,
            (None, _) => Motion::Rotary,
        };
        let name = joint.and_then(|joint| self.joint_names.get(joint));
        let of_joint = name.map_or_else(String::new, |name| format!(", {name}"));
        limit.limit.line(&of_joint, motion)
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
