//! TH-SMOOTH: without an encoder the ½ of quantization goes.

use passivity_core::{Friction, Loop, Region, witness};
use proptest::prelude::*;

use crate::common::{
    coefficient, friction, half, magnitude, number, position, positive, q, sampled, squared, zero,
};

sampled! {
    fn th_smooth_a_step_generates_half_the_square(a in position(), b in position()) {
        // The held force is −ξ₀: the work against ½ξ² is ½d² and nothing else.
        let d = &b - &a;
        let generated = -&a * &d + half() * (squared(&b) - squared(&a));
        prop_assert_eq!(generated.clone(), half() * squared(&d));
        let smooth = Loop::smooth(Friction::new(zero(), zero()));
        prop_assert_eq!(generated, smooth.cost().bound(&d));
    }

    fn th_smooth_criterion(friction in friction()) {
        let criterion = Loop::smooth(friction.clone()).criterion();
        prop_assert_eq!(criterion.viscous, &friction.beta - half());
        prop_assert_eq!(criterion.coulomb, friction.sigma);
    }

    fn th_smooth_without_coulomb_friction_is_colgate(
        b in positive(), k in positive(), t in positive()
    ) {
        let smooth = Loop { viscous: Some(b.clone()), ..Loop::new(k.clone(), t.clone()) };
        let globally = Region::of(&smooth.criterion()) == Some(Region::GloballyStable);
        prop_assert_eq!(globally, b >= k * t * half());
    }

    fn th_smooth_witness(
        beta in coefficient(), sigma in coefficient(), bound in prop::option::of(positive())
    ) {
        let friction = Friction::new(beta.clone(), sigma.clone());
        let found = witness::smooth(&friction, bound.as_ref());
        // There is one exactly when β < ½ and the bound leaves room above σ/(½ − β).
        let exists = beta < half()
            && bound.as_ref().is_none_or(|bound| *bound > &sigma / (half() - &beta));
        prop_assert_eq!(found.is_some(), exists);
        if let Some(cycle) = found {
            prop_assert_eq!(cycle.from, zero());
            let d = cycle.to;
            prop_assert!(bound.is_none_or(|bound| d <= bound));
            // There against the force held from 0, which is 0; back with that held from d.
            let spent = q(2, 1) * (&beta * squared(&d) + &sigma * &d);
            let gain = squared(&d) - spent;
            prop_assert!(gain > zero());
            prop_assert_eq!(cycle.gain, gain);
        }
    }

    fn th_smooth_virtual_damping_and_steps(
        beta in coefficient(), sigma in coefficient(), damping in coefficient(), step in positive(),
        v in number()
    ) {
        let the_loop = Loop {
            delay: 2, damping: Some(damping.clone()), force_step: Some(step.clone()),
            ..Loop::smooth(Friction::new(beta.clone(), sigma.clone()))
        };
        let criterion = the_loop.criterion();
        let v = magnitude(&v);
        let margin = (beta - half() - q(2, 1) - damping) * &v + sigma - half() * step;
        prop_assert_eq!(criterion.margin(&v), margin);
    }
}
