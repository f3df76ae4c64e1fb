//! The criterion with the numbers of a scene, at both ends of its tolerances.

use passivity_core::{BigRational, Exact, Interval};
use passivity_scene::check::enclosure;
use passivity_scene::display::range;
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
        let [hardest, easiest] = scene.bounds().criteria();
        let range = |a: Exact, b: Exact| match enclosure(&Interval::hull(a, b)) {
            Some(range) => range,
            None => unreachable!("the numbers of a scene are defined"),
        };
        Self {
            viscous: range(hardest.viscous, easiest.viscous),
            coulomb: range(hardest.coulomb, easiest.coulomb),
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

    /// The criterion in numbers, over the tolerances with the least and with the most that each coefficient may be.
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
        let (least, most) = (at(Interval::lo), at(Interval::hi));
        if least == most {
            return format!("In numbers: {least}.");
        }
        format!(
            "Over the tolerances, each coefficient for itself: at the least {least}; at the most {most}."
        )
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
            "Over the tolerances, each coefficient for itself: at the least (0.05)·v + (0.1) ≥ 0; \
             at the most (0.15)·v + (0.1) ≥ 0."
        );
    }
}
