//! TH-LTI, the converse: cycles across one edge, and the Coulomb friction below which they gain.

use passivity_core::edge_cycle::EdgeCycle;
use passivity_core::periodic::held_forces;
use passivity_core::{BigRational, Friction};
use proptest::prelude::*;

use crate::common::{half, magnitude, q, sampled, zero};
use crate::periodic::{gain_by_hand, kernels};
use crate::transfer::{Controller, finite_controller, response, small};

fn best(c: &[BigRational]) -> EdgeCycle {
    EdgeCycle::of(c).unwrap()
}

fn half_sum(c: &[BigRational]) -> BigRational {
    c.iter().fold(zero(), |sum, c| sum + magnitude(c)) * half()
}

/// What a pattern of sides draws a move, by the plain sum; `None` without a move.
fn ratio(c: &[BigRational], above: &[bool]) -> Option<BigRational> {
    let period = above.len();
    let side = |h: usize| if above[h % period] { half() } else { -half() };
    let (mut drawn, mut moves) = (zero(), zero());
    for h in 0..period {
        let force = c
            .iter()
            .enumerate()
            .fold(zero(), |sum, (j, c)| sum - c * side(h + j * (period - 1)));
        let step = side(h + 1) - side(h);
        moves += magnitude(&step);
        drawn += force * step;
    }
    (moves > zero()).then(|| drawn / moves)
}

sampled! {
    /// No pattern of up to seven sides draws more a move, the best one draws just that, and ½‖c‖₁ is
    /// never exceeded.
    fn th_lti_edge_best_of_all_patterns(c in prop::collection::vec(small(), 1..5)) {
        let found = best(&c);
        prop_assert!(found.coulomb <= half_sum(&c));
        for period in 2..=7 {
            for pattern in 0u32..1 << period {
                let above: Vec<bool> = (0..period).map(|h| pattern >> h & 1 == 1).collect();
                if let Some(ratio) = ratio(&c, &above) {
                    prop_assert!(ratio <= found.coulomb);
                }
            }
        }
        if !found.above.is_empty() {
            prop_assert_eq!(ratio(&c, &found.above), Some(found.coulomb));
        }
    }

    /// Below s* the motion gains, with the gain of the forces; at s* it does not.
    fn th_lti_edge_witness(controller in finite_controller(), beta in 0i64..9, part in 0i64..10) {
        let c = response(&controller, 8);
        let found = best(&c);
        let kernel = kernels(&controller);
        let held = |positions: &[BigRational]| Some(held_forces(&kernel, positions));
        let friction = Friction::new(q(beta, 2), &found.coulomb * q(part, 10));
        let motion = found.motion(held, &friction, None);
        prop_assert_eq!(motion.is_some(), found.coulomb > zero());
        if let Some(motion) = motion {
            prop_assert!(motion.gain > zero());
            prop_assert_eq!(motion.gain.clone(), gain_by_hand(&c, &motion.positions, &friction));
            let slow = found.motion(held, &friction, Some(&q(1, 1000))).unwrap();
            let fastest = slow.positions.iter().max().unwrap() - slow.positions.iter().min().unwrap();
            prop_assert!(fastest < q(1, 1000) && slow.gain > zero());
        }
        let enough = Friction::new(zero(), found.coulomb.clone());
        prop_assert!(found.motion(held, &enough, None).is_none());
    }
}

#[test]
fn th_lti_edge_figures() {
    // ½‖c‖₁ for the plain wall, delay, damping, and the two together.
    for delay in 0..5 {
        for damping in [zero(), half(), q(2, 1), q(7, 3)] {
            let controller = Controller::damped(&damping).unwrap().delayed(delay);
            let c = response(&controller, usize::from(delay) + 2);
            assert_eq!(
                best(&c).coulomb,
                half_sum(&c),
                "delay {delay}, damping {damping}"
            );
        }
    }
    let mixed = [q(1, 2), q(-1, 1), q(6, 5), q(2, 5)];
    assert_eq!(
        (best(&mixed).coulomb, half_sum(&mixed)),
        (q(23, 20), q(31, 20))
    );
    // Damping behind a pole of ¾, cut to eight terms: B(1 − a) = ½, that is B = 2.
    let cut = |damping| {
        response(
            &Controller::filtered_damping(&damping, &q(3, 4)).unwrap(),
            8,
        )
    };
    let close = |x: &BigRational, ten_thousandths| {
        assert!(
            magnitude(&(x - q(ten_thousandths, 10_000))) < q(1, 10_000),
            "{x}"
        );
    };
    close(&best(&cut(q(2, 1))).coulomb, 7905);
    close(&half_sum(&cut(q(2, 1))), 9666);
    // With B = ½ itself it is less.
    close(&best(&cut(half())).coulomb, 5726);
    close(&half_sum(&cut(half())), 6167);
    // Too long a response is not searched.
    assert_eq!(EdgeCycle::of(&vec![q(1, 1); 11]), None);
    assert_eq!(best(&[]).above, Vec::<bool>::new());
}

/// Up and down for the plain wall, with a wait behind a delay; nothing where the bound or the friction leaves
/// no room, or the force is that of another loop.
#[test]
fn th_lti_edge_motions_have_room() {
    let taps = |c: &[i64]| c.iter().map(|c| q(*c, 1)).collect::<Vec<_>>();
    for (c, coulomb, above) in [
        (taps(&[1]), half(), vec![false, true]),
        (taps(&[0, 1]), half(), vec![true, true, false, false]),
        (taps(&[2, -1]), q(3, 2), vec![false, true]),
    ] {
        let found = best(&c);
        assert_eq!(found.coulomb, coulomb);
        let mut turned = found.above.clone();
        let turns = (0..turned.len()).any(|_| {
            turned.rotate_left(1);
            turned == above
        });
        assert!(turns, "{:?}", found.above);
    }
    let wall = best(&taps(&[1]));
    let kernel = kernels(&Controller::wall());
    let held = |positions: &[BigRational]| Some(held_forces(&kernel, positions));
    let motion = |sigma: BigRational, bound: Option<BigRational>| {
        wall.motion(held, &Friction::new(q(1, 1), sigma), bound.as_ref())
    };
    assert_eq!(motion(half(), None), None);
    // a = ¼/1/2, or half of the bound.
    let gain = |a: BigRational| &a * half() - &a * &a * q(2, 1);
    assert_eq!(motion(q(1, 4), None).unwrap().gain, gain(q(1, 8)));
    assert_eq!(
        motion(q(1, 4), Some(q(1, 50))).unwrap().gain,
        gain(q(1, 100))
    );
    assert_eq!(motion(q(1, 4), Some(zero())), None);
    // A loop without force gains nothing, whatever the pattern.
    let none = |positions: &[BigRational]| Some(vec![zero(); positions.len()]);
    let slow = Friction::new(zero(), zero());
    assert_eq!(wall.motion(none, &slow, None), None);
}
