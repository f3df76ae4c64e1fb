//! (7), (11) and the terms that effects add: with units and without.

use passivity_core::effects::Effects;
use passivity_core::{BigRational, Criterion, Friction, Rig};
use proptest::prelude::*;

use crate::common::{effects, friction, half, nonnegative, positive, q, rig, sampled, zero};

/// The criterion (11) written out: b − KT(½ + k) − B and c − KΔ/2 − BΔ/T − F/2.
pub(crate) fn criterion_written_out(rig: &Rig<BigRational>) -> Criterion<BigRational> {
    let Rig {
        viscous: b,
        coulomb: c,
        stiffness: k,
        period: t,
        length: delta,
        effects,
    } = rig;
    let damping = effects.damping.clone().unwrap_or_else(zero);
    let force_step = effects.force_step.clone().unwrap_or_else(zero);
    let delay = q(i64::from(effects.delay), 1);
    let quantization = if effects.encoder {
        k * delta * half() + &damping * delta / t
    } else {
        zero()
    };
    Criterion {
        viscous: b - k * t * half() - delay * k * t - damping,
        coulomb: c - quantization - force_step * half(),
    }
}

/// The rig with one of its numbers replaced.
fn changed(rig: &Rig<BigRational>, change: impl FnOnce(&mut Rig<BigRational>)) -> Rig<BigRational> {
    let mut rig = rig.clone();
    change(&mut rig);
    rig
}

sampled! {
    fn eq_27_effective_friction(rig in rig(), inertia in positive()) {
        let Rig { viscous: b, coulomb: c, stiffness: k, period: t, length: delta, .. } = &rig;
        prop_assert_eq!(rig.viscous_unit(), k * t);
        prop_assert_eq!(rig.force_unit(), k * delta);
        prop_assert_eq!(rig.friction(), Friction::new(b / (k * t), c / (k * delta)));
        prop_assert_eq!(rig.mu(&inertia), &inertia / (k * t * t));
        prop_assert_eq!(rig.dimensionless_speed(&inertia), &inertia * t / delta);
    }

    fn eq_27_with_units_is_11(rig in rig()) {
        prop_assert_eq!(rig.criterion(), criterion_written_out(&rig));
    }

    fn eq_27_in_units_of_the_rig(rig in rig(), v in nonnegative()) {
        let dimensionless = rig.dimensionless_criterion();
        let written = criterion_written_out(&rig);
        prop_assert_eq!(&dimensionless.viscous, &(written.viscous / rig.viscous_unit()));
        prop_assert_eq!(&dimensionless.coulomb, &(written.coulomb / rig.force_unit()));
        // The margin (11) in units of force is KΔ times the margin (8) at the speed in ticks.
        let margin = rig.criterion().margin(&v) / rig.force_unit();
        prop_assert_eq!(dimensionless.margin(&rig.dimensionless_speed(&v)), margin);
    }

    fn eq_27_a_rig_whose_units_are_one(friction in friction(), effects in effects()) {
        let rig = Rig::dimensionless(friction.clone(), effects.clone());
        prop_assert_eq!(rig.friction(), friction.clone());
        prop_assert_eq!(rig.dimensionless_criterion(), rig.criterion());
        prop_assert_eq!(&rig.effects, &effects);
        let plain = Rig { effects: Effects::encoder(), ..rig };
        prop_assert_eq!(plain.criterion(), Criterion::of_friction(&friction));
    }

    /// More friction never hurts; a stiffer wall, a longer period, a coarser encoder, a later or
    /// coarser force never helps.
    fn eq_27_monotone_in_every_parameter(rig in rig(), more in nonnegative(), v in nonnegative()) {
        let margin = |rig: &Rig<BigRational>| rig.criterion().margin(&v);
        let before = margin(&rig);
        prop_assert!(margin(&changed(&rig, |r| r.viscous += &more)) >= before);
        prop_assert!(margin(&changed(&rig, |r| r.coulomb += &more)) >= before);
        prop_assert!(margin(&changed(&rig, |r| r.stiffness += &more)) <= before);
        prop_assert!(margin(&changed(&rig, |r| r.length += &more)) <= before);
        prop_assert!(margin(&changed(&rig, |r| r.effects.delay += 1)) <= before);
        prop_assert!(margin(&changed(&rig, |r| r.effects.encoder = true)) <= before);
        let force_step = Some(rig.effects.force_step.clone().unwrap_or_else(zero) + &more);
        prop_assert!(margin(&changed(&rig, |r| r.effects.force_step = force_step)) <= before);
        let damping = Some(rig.effects.damping.clone().unwrap_or_else(zero) + &more);
        prop_assert!(margin(&changed(&rig, |r| r.effects.damping = damping)) <= before);
        // A longer period pulls both ways when a tick is damped as a speed: BΔ/T.
        if rig.effects.damping.is_none() || !rig.effects.encoder {
            prop_assert!(margin(&changed(&rig, |r| r.period += &more)) <= before);
        }
        let slower = changed(&rig, |r| r.period += &more).criterion();
        prop_assert!(slower.viscous <= rig.criterion().viscous);
        prop_assert!(slower.coulomb >= rig.criterion().coulomb);
    }

    fn eq_27_try_map_takes_every_number(rig in rig()) {
        let doubled = rig.try_map(|x| Some(x * q(2, 1))).unwrap();
        prop_assert_eq!(doubled.viscous, &rig.viscous * q(2, 1));
        prop_assert_eq!(doubled.coulomb, &rig.coulomb * q(2, 1));
        prop_assert_eq!(doubled.stiffness, &rig.stiffness * q(2, 1));
        prop_assert_eq!(doubled.period, &rig.period * q(2, 1));
        prop_assert_eq!(doubled.length, &rig.length * q(2, 1));
        prop_assert_eq!(doubled.effects.encoder, rig.effects.encoder);
        prop_assert_eq!(doubled.effects.delay, rig.effects.delay);
        prop_assert_eq!(&doubled.effects.damping, &rig.effects.damping.as_ref().map(|x| x * q(2, 1)));
        prop_assert_eq!(&doubled.effects.force_step, &rig.effects.force_step.as_ref().map(|x| x * q(2, 1)));
        // One number that does not fit is enough to give up.
        let numbers = [Some(&rig.viscous), Some(&rig.coulomb), Some(&rig.stiffness), Some(&rig.period),
            Some(&rig.length), rig.effects.damping.as_ref(), rig.effects.force_step.as_ref()];
        for number in numbers.into_iter().flatten() {
            prop_assert!(rig.try_map(|x| (x != number).then(|| x.clone())).is_none());
        }
    }
}

#[test]
fn eq_27_the_maxon_motor_of_the_paper() {
    let rig = Rig {
        viscous: q(9, 1_000_000),
        coulomb: q(2, 1000),
        stiffness: q(1, 1),
        period: q(1, 1000),
        length: q(1, 1000),
        effects: Effects::encoder(),
    };
    assert_eq!(rig.friction(), Friction::new(q(9, 1000), q(2, 1)));
    assert_eq!(rig.criterion().viscous, q(-491, 1_000_000));
    assert_eq!(rig.criterion().coulomb, q(3, 2000));
}
