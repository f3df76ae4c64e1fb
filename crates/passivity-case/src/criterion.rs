//! The criterion with the numbers of a scene, at both ends of its tolerances.

use passivity_core::{BigRational, Interval, criterion};
use passivity_scene::display::range;
use passivity_scene::pi::PRINT_LEVEL;
use passivity_scene::{Motion, Scene};

/// The criterion (11), (b − …)·v + (c − …) ≥ 0, in SI units: every rig within the tolerances lies
/// between the ends of the two coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct Criterion {
    /// What viscous friction has left, in N·s/m or N·m·s/rad.
    pub viscous: Interval<BigRational>,
    /// What Coulomb friction has left, in N or N·m.
    pub coulomb: Interval<BigRational>,
    motion: Motion,
}

impl Criterion {
    /// The criterion of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let (hardest, easiest): (criterion::Criterion<_>, _) =
            scene.rig_box(PRINT_LEVEL).criteria();
        Self {
            viscous: Interval::hull(hardest.viscous, easiest.viscous),
            coulomb: Interval::hull(hardest.coulomb, easiest.coulomb),
            motion: scene.motion,
        }
    }

    /// The units of the two coefficients, with a space in front; nothing for a dimensionless scene.
    #[must_use]
    pub const fn units(&self) -> (&'static str, &'static str) {
        match self.motion {
            Motion::Linear => (" N s/m", " N"),
            Motion::Rotary => (" N m s/rad", " N m"),
            Motion::Dimensionless => ("", ""),
        }
    }

    /// The criterion in numbers: at the hardest end of the tolerances, and at the easiest where
    /// they differ.
    #[must_use]
    pub fn sentence(&self) -> String {
        let (viscous_unit, coulomb_unit) = self.units();
        let at = |end: fn(&Interval<BigRational>) -> &BigRational| {
            let number = |x: &Interval<BigRational>| range(&Interval::point(end(x).clone()));
            format!(
                "({}{viscous_unit})·v + ({}{coulomb_unit}) ≥ 0",
                number(&self.viscous),
                number(&self.coulomb)
            )
        };
        if self.viscous.is_point() && self.coulomb.is_point() {
            return format!("In numbers: {}.", at(Interval::lo));
        }
        let (hardest, easiest) = (at(Interval::lo), at(Interval::hi));
        if hardest == easiest {
            return format!("In numbers: {hardest}.");
        }
        format!("At the hardest end of the tolerances: {hardest}; at the easiest: {easiest}.")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_tolerances_are_both_said() {
        let scene = |beta: &str| {
            let text =
                format!("[dimensionless]\nmu = \"50\"\nbeta = \"{beta}\"\nsigma = \"3/5\"\n");
            Criterion::of(&Scene::from_toml("s", &text).unwrap()).sentence()
        };
        assert_eq!(scene("3/5"), "In numbers: (0.1)·v + (0.1) ≥ 0.");
        assert_eq!(
            scene("0.6 ± 0.05"),
            "At the hardest end of the tolerances: (0.05)·v + (0.1) ≥ 0; at the easiest: (0.15)·v + (0.1) ≥ 0."
        );
    }
}
