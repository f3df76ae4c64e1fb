//! TH-LTI, the converse: motions of one frequency that draw energy.

use num_traits::ToPrimitive as _;
use passivity_core::absolute_sum::viscous_bound;
use passivity_core::drift::Drift;
use passivity_core::frequency::ViscousCost;
use passivity_core::periodic::{Motion, commands, gain, held_forces};
use passivity_core::transfer::TransferFunction;
use passivity_core::wave::{Wave, harmonic};
use passivity_core::{BigRational, Friction, Loop, controller};
use proptest::prelude::*;

use crate::common::{half, magnitude, nonnegative, q, sampled, squared, zero};
use crate::transfer::{
    Controller, controller as any_controller, finite_controller, response, small, times,
};

/// The kernel's controller of a finite response, with an encoder.
pub(crate) fn kernels(of: &Controller) -> controller::Controller<BigRational> {
    controller::Controller {
        filter: of.filter().unwrap(),
        ..controller::Controller::of(&Loop::plain(Friction::new(zero(), zero())))
    }
}

/// What the operator gains each time round, from the coefficients of the response alone.
pub(crate) fn gain_by_hand(
    c: &[BigRational],
    positions: &[BigRational],
    friction: &Friction<BigRational>,
) -> BigRational {
    let period = positions.len();
    let mut gained = zero();
    for h in 0..period {
        let mut force = zero();
        for (j, c) in c.iter().enumerate() {
            let at = (h + j * (period - 1)) % period; // h − j
            force -= c * (positions[at].floor() + half());
        }
        let d = &positions[(h + 1) % period] - &positions[h];
        gained += force * &d - &friction.beta * squared(&d) - &friction.sigma * magnitude(&d);
    }
    gained
}

sampled! {
    fn th_lti_gain_of_a_period(
        controller in finite_controller(), positions in prop::collection::vec(small(), 1..9),
        beta in small(), sigma in small(),
    ) {
        let friction = Friction::new(beta, sigma);
        let c = response(&controller, 8);
        let forces = held_forces(&kernels(&controller), &positions);
        let by_hand = gain_by_hand(&c, &positions, &friction);
        prop_assert_eq!(gain(&forces, &positions, &friction), by_hand);
        let measured: Vec<_> = positions.iter().map(|xi| xi.floor() + half()).collect();
        prop_assert_eq!(commands(&controller, &measured), Some(forces));
    }

    /// The commands of any controller solve its equation round the period.
    fn th_lti_commands_of_a_period(
        controller in any_controller(), measured in prop::collection::vec(small(), 1..9)
    ) {
        let forces = commands(&controller, &measured).unwrap();
        let period = measured.len();
        for h in 0..period {
            let before = |of: &[BigRational], j: usize| of[(h + j * (period - 1)) % period].clone();
            let weigh = |coefficients: &[BigRational], of: &[BigRational]| coefficients
                .iter().enumerate().fold(zero(), |sum, (j, c)| sum + c * before(of, j));
            prop_assert_eq!(
                weigh(controller.denominator(), &forces),
                -weigh(controller.numerator(), &measured)
            );
        }
    }

    /// Below the border, by a hundredth of it, there is a witness; its gain is that of the forces.
    fn th_lti_witness_below_the_border(controller in finite_controller(), sigma in 0i64..5) {
        let cost = ViscousCost::of(&controller);
        let border = cost.enclosure(&q(1, 1_000_000)).lo().clone();
        let beta = &border - (&border + q(1, 1)) / q(100, 1);
        prop_assume!(beta >= zero());
        let friction = Friction::new(beta, q(sigma, 2));
        let kernel = kernels(&controller);
        let held = |positions: &[BigRational]| Some(held_forces(&kernel, positions));
        let found = harmonic(&cost, held, &friction, None).unwrap();
        let c = response(&controller, 8);
        prop_assert!(found.gain > zero());
        prop_assert_eq!(found.gain.clone(), gain_by_hand(&c, &found.positions, &friction));
        prop_assert!(found.positions.iter().all(|xi| *xi >= zero()));
        // Above it there is none.
        let enough = Friction::new(cost.enclosure(&q(1, 1000)).hi().clone(), zero());
        prop_assert!(harmonic(&cost, held, &enough, None).is_none());
    }

    /// The formula of going there and back is the sum over the period.
    fn th_lti_drift_formula(
        controller in finite_controller(), step in 1i64..4, more in 0i64..5,
        beta in small(), sigma in small(),
    ) {
        let friction = Friction::new(beta, sigma);
        let filter = controller.filter().unwrap();
        let samples = i64::try_from(filter.order()).unwrap().max(1) + more;
        let there = (0..samples).map(|h| q(h * step, 1));
        let back = (1..=samples).rev().map(|h| q(h * step, 1));
        let positions: Vec<_> = there.chain(back).collect();
        let by_hand = gain_by_hand(&response(&controller, 8), &positions, &friction);
        let formula = Drift::gain(&filter, &friction, &q(step, 1), &q(samples, 1));
        prop_assert_eq!(formula, by_hand);
    }

    /// There is a drift that gains exactly where β < λ(0).
    fn th_lti_drift_exists(controller in finite_controller(), below in nonnegative(), sigma in 0i64..9) {
        let filter = controller.filter().unwrap();
        let at_zero = ViscousCost::of(&controller).at(&q(1, 1));
        let friction = Friction::new(&at_zero - &below, q(sigma, 2));
        let found = Drift::of(&filter, &friction);
        prop_assert_eq!(found.is_some(), below > zero());
        if let Some(drift) = found {
            prop_assert!(drift.gain > zero());
            prop_assert!(drift.step.is_integer() && drift.samples.is_integer());
        }
    }
}

sampled! {
    /// A wave exists for any controller however little below the border, and not on it; where its
    /// period can be written down, its gain computed from the forces is at least what is said.
    fn th_lti_wave_below_the_border(
        controller in any_controller(), digits in prop_oneof![0u32..3, 3u32..12], sigma in 0i64..5
    ) {
        let little = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(digits));
        let border = ViscousCost::of(&controller).enclosure(&(&little / q(2, 1)));
        let beta = border.lo() - little;
        prop_assume!(beta >= zero());
        let friction = Friction::new(beta, q(sigma, 2));
        let wave = Wave::of(&controller, &friction).unwrap();
        prop_assert!(wave.gain_at_least > zero());
        let enough = Friction::new(border.hi().clone(), zero());
        prop_assert_eq!(Wave::of(&controller, &enough), None);
        if let Some(positions) = written_down(&wave, 64) {
            let measured: Vec<_> = positions.iter().map(|xi| xi + half()).collect();
            let forces = commands(&controller, &measured).unwrap();
            prop_assert!(gain(&forces, &positions, &friction) >= wave.gain_at_least);
        }
    }
}

/// The positions of a wave that is not too long and not too large.
fn written_down(wave: &Wave, most: u32) -> Option<Vec<BigRational>> {
    let period = wave.period.to_u32().filter(|p| *p <= most)?;
    let amplitude = wave.amplitude.to_f64().filter(|a| *a < 1e9)?;
    let theta = std::f64::consts::TAU * wave.turns.to_f64()? / f64::from(period);
    let position = |h: u32| {
        let xi = (theta * (f64::from(h) - 0.5)).sin() / (2.0 * (theta / 2.0).sin());
        q((amplitude * xi).round() as i64, 1)
    };
    Some((0..period).map(position).collect())
}

#[test]
fn th_lti_waves_written_down() {
    // A delay of k samples, worst at the lowest frequencies: periods of 8 and of 64, and longer.
    for (k, tenths, most) in [
        (0, 4, 8),
        (1, 13, 64),
        (2, 24, 64),
        (1, 14, 512),
        (3, 34, 512),
    ] {
        let controller = Controller::wall().delayed(k);
        let friction = Friction::new(q(tenths, 10), q(3, 2));
        let wave = Wave::of(&controller, &friction).unwrap();
        let positions = written_down(&wave, most).unwrap();
        let c = response(&controller, 4);
        assert!(gain_by_hand(&c, &positions, &friction) >= wave.gain_at_least);
    }
    // 10⁻³⁰ below the border, too long to write down.
    let controller = Controller::damped(&half()).unwrap().delayed(1);
    let less = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
    let wave = Wave::of(&controller, &Friction::new(q(5, 4) - less, q(1, 1))).unwrap();
    assert!(wave.period.bits() > 40);
}

/// s of gain = p·[s·(½A² − 2A) − F − σ(A + 1)]: one over a whole number.
fn spare_of(wave: &Wave, controller: &Controller, friction: &Friction<BigRational>) -> BigRational {
    let [period, amplitude] =
        [&wave.period, &wave.amplitude].map(|n| BigRational::from_integer(n.clone()));
    let most = viscous_bound(controller, &q(1, 1)).unwrap().hi() + &friction.beta;
    let spent = most + &friction.sigma * (&amplitude + q(1, 1));
    let drawn = &wave.gain_at_least / period + spent;
    drawn / (&amplitude * &amplitude * half() - &amplitude * q(2, 1))
}

/// For the plain wall λ = ½ and F = ½ + β. With β = ¼, s = ⅛, and σ = 5/36 an amplitude of 8 draws
/// ⅛(32 − 16) − ¾ − 9σ = 0 a sample, which is not above zero.
#[test]
fn th_lti_wave_gain_by_hand() {
    let little = q(1, 1_000_000);
    for (sigma, amplitude) in [(q(5, 36), 16), (q(5, 36) - little, 8)] {
        let friction = Friction::new(q(1, 4), sigma);
        let wave = Wave::of(&Controller::wall(), &friction).unwrap();
        assert_eq!(wave.amplitude, amplitude.into());
        assert_eq!(
            spare_of(&wave, &Controller::wall(), &friction),
            q(1, 8),
            "{wave:?}"
        );
    }
    // Σ|gⱼ| is known only within bounds: the larger one counts.
    let poles = times(&[q(1, 1), q(-1, 2)], &[q(1, 1), q(-1, 3)]);
    let controller = Controller::new([q(2, 1), q(-1, 1)], poles).unwrap();
    assert!(!viscous_bound(&controller, &q(1, 1)).unwrap().is_point());
    let border = ViscousCost::of(&controller).enclosure(&q(1, 1000));
    let friction = Friction::new(border.lo() - q(1, 10), q(1, 2));
    let wave = Wave::of(&controller, &friction).unwrap();
    let spare = spare_of(&wave, &controller, &friction);
    assert!(spare.numer() == &1.into() && spare <= q(101, 1000));
}

#[test]
fn th_lti_motions_stay_below_the_bound_and_draw() {
    let kernel = kernels(&Controller::wall());
    let held = |positions: &[BigRational]| Some(held_forces(&kernel, positions));
    let friction = |sigma: BigRational| Friction::new(zero(), sigma);
    let up_and_down = |bound: Option<BigRational>, sigma: BigRational| {
        let positions = vec![zero(), q(1, 1), q(3, 1), q(1, 1)];
        Motion::below(bound.as_ref(), positions, held, &friction(sigma))
    };
    // Held: −½, −3/2, −7/2, −3/2; drawn: −½ − 3 + 7 + 3/2 = 5 over a way of 6.
    let free = up_and_down(None, q(1, 2)).unwrap();
    assert_eq!(free.gain, q(2, 1));
    assert_eq!(up_and_down(Some(q(2, 1)), q(1, 2)), None);
    let slower = up_and_down(Some(q(2_000_001, 1_000_000)), q(1, 2));
    assert_eq!(slower.unwrap().that_draws(), Some(free));
    assert_eq!(up_and_down(None, q(5, 6)).unwrap().that_draws(), None);
    // The last step, back to the start, is the longest.
    let down = |bound: BigRational| {
        let positions = vec![zero(), q(1, 1), q(2, 1)];
        Motion::below(Some(&bound), positions, held, &friction(zero()))
    };
    assert_eq!(down(q(2, 1)), None);
    assert!(down(q(3, 1) + q(1, 1000)).is_some());
    let nothing = |_: &[BigRational]| None;
    assert_eq!(
        Motion::below(None, vec![zero(), q(1, 1)], nothing, &friction(zero())),
        None
    );
}

#[test]
fn th_lti_witness_of_period_six() {
    let controller = Controller::damped(&half()).unwrap().delayed(1);
    let cost = ViscousCost::of(&controller);
    let kernel = kernels(&controller);
    let held = |positions: &[BigRational]| Some(held_forces(&kernel, positions));
    let less = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
    let friction = Friction::new(q(5, 4) - &less, q(100, 1));
    let found = harmonic(&cost, held, &friction, None).unwrap();
    assert_eq!(found.positions.len(), 6);
    assert!(found.gain > zero());
    let c = response(&controller, 3);
    assert_eq!(found.gain, gain_by_hand(&c, &found.positions, &friction));
    // D = 1, ½, −½, −1, −½, ½ times the amplitude.
    let steps: Vec<_> = (0..6)
        .map(|h| &found.positions[(h + 1) % 6] - &found.positions[h])
        .collect();
    let largest = steps.iter().max().unwrap().clone();
    assert!(
        steps
            .iter()
            .all(|d| *d == largest || -d == largest || magnitude(d) * q(2, 1) == largest)
    );
    let (squares, way) = steps.iter().fold((zero(), zero()), |(s, w), d| {
        (s + squared(d), w + magnitude(d))
    });
    assert_eq!(found.gain, &less * squares - q(100, 1) * way);
    // Nothing below a speed that it exceeds.
    let slow = harmonic(&cost, held, &friction, Some(&q(10, 1)));
    assert_eq!(slow, None);
    // On the border there is none.
    let border = Friction::new(q(5, 4), zero());
    assert_eq!(harmonic(&cost, held, &border, None), None);
}

#[test]
fn th_lti_witness_of_an_endless_response() {
    // One-pole damping, worst at half the sampling rate: up and down.
    let controller = TransferFunction::filtered_damping(&q(1, 1), &half()).unwrap();
    let cost = ViscousCost::of(&controller);
    let held = |positions: &[BigRational]| {
        let measured: Vec<_> = positions.iter().map(|xi| xi.floor() + half()).collect();
        commands(&controller, &measured)
    };
    let friction = Friction::new(q(5, 6) - q(1, 1_000_000), q(1, 1));
    let found = harmonic(&cost, held, &friction, None).unwrap();
    assert_eq!(found.positions.len(), 2);
    // Far enough from the start the coefficients that are left out no longer matter.
    let c = response(&controller, 200);
    let missing = gain_by_hand(&c, &found.positions, &friction) - &found.gain;
    assert!(magnitude(&missing) < q(1, 1_000_000) && found.gain > q(1, 1_000_000));
}
