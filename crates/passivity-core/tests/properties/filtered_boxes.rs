//! TH-CHECK, TH-LTI: boxes with damping behind a filter and a delay, whose cost between the ends of a tolerance is
//! known by how much it bends.

use passivity_core::parameter::Parameter;
use passivity_core::rational::{from_wide, to_wide};
use passivity_core::{BigRational, Interval, Loop, Scalar as _, Truth, Wide};

use crate::boxes_of_costs::{asked, assert_said, number};
use crate::common::q;

/// Behind a delay of one sample damping of 1 costs at most 1.509854… at τ = 8, and at least 1.5035… at τ = 24.
#[test]
fn th_lti_boxes_of_filtered_damping_behind_a_delay() {
    assert_said(
        Truth::Holds,
        &[
            "b=1.55 k=1 B=1 τ=8..24",
            "b=1.51 k=1 B=1 τ=8..24",
            "b=1.50986 k=1 B=1 τ=8..24",
            "b=1.5055 k=1 B=1 τ=15.2..16.8",
            "b=1.51 c=2 k=1 B=1 τ=8..24 V=3",
            // Over all of B too: at most where there is most of it.
            "b=1.50986 k=1 B=0.2..1 τ=8..24",
            // 1.1 of it in K, and B is 1/1.1 of KT there at the most.
            "b=1.661 k=1 B=1 τ=8..24 K=1..1.1",
            "b=1.7 k=1 B=1 τ=8..24 T=0.9..1.1",
        ],
    );
    assert_said(
        Truth::Depends,
        &["b=1.5098 k=1 B=1 τ=8..24", "b=1.504 k=1 B=1 τ=8..24"],
    );
    assert_said(
        Truth::Fails,
        &[
            "b=1.5 k=1 B=1 τ=8..9",
            // What damping bends between the ends of a stretch tells below the border too.
            "b=1.5034 k=1 B=1 τ=8..24",
            "b=1.44 c=0.6 k=1 B=1 τ=8..24 V=1..3",
        ],
    );
}

/// Where it is said that a box holds, so does every loop of it, at the border of its hardest corner.
#[test]
fn th_lti_filtered_boxes_hold_in_between() {
    let mut held = 0;
    for (k, damping, from, to) in [
        (1, "0.3", "0.1", "0.4"),
        (1, "4", "0.5", "2"),
        (2, "2", "1", "1.5"),
        (2, "0.7", "0", "0.2"),
        (3, "3", "4", "30"),
        (4, "9", "0.05", "3"),
    ] {
        let (of, speeds) = asked(&format!("b=1 c=99 k={k} B={damping} τ={from}..{to}"));
        // What each of twenty loops of the box asks for.
        let [from, to] = [from, to].map(number);
        let taus = (0..=20).map(|i| &from + (&to - &from) * q(i, 20));
        let costs: Vec<Wide> = taus
            .map(|tau| {
                let tau = Interval::point(to_wide(&tau));
                let one = of.clone().with(Parameter::DampingTimeConstant, tau);
                let cost = one.with_costs(40).unwrap().viscous_cost.unwrap();
                cost.hi().clone()
            })
            .collect();
        let most = costs.iter().cloned().reduce(Wide::max).unwrap();
        for thousandths in [-1, 0, 1, 3, 10, 100] {
            let b = most.clone() + to_wide(&q(thousandths, 1000));
            let asked = Loop {
                viscous: Some(Interval::point(b.clone())),
                ..of.clone()
            };
            let holds = asked.truth(&speeds) == Some(Truth::Holds);
            assert_eq!(asked.surely_holds(&speeds), holds, "k={k} {thousandths}");
            assert!(!holds || most <= b, "k={k} {thousandths}");
            // A hundredth is more than cells leave open in any of these.
            assert!(holds || thousandths < 10, "k={k} {thousandths}");
            held += usize::from(holds);
        }
    }
    assert!(held > 12);
}

/// Whatever is said of a box is so of loops anywhere in it: random boxes, with b about what the middle asks for.
#[test]
fn th_lti_filtered_boxes_say_what_loops_in_them_do() {
    let mut state = 7_u64;
    let mut random = |most: u64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        i64::try_from((state >> 33) % most).unwrap()
    };
    let mut said = [0, 0, 0];
    for _ in 0..150 {
        let (k, bound) = (1 + random(4), random(2));
        let ranges: Vec<_> = ["B", "τ", "K", "T"]
            .into_iter()
            .map(|name| {
                let from = q(1 + random(40), 10);
                let share = q(random(3) * random(40), 1000);
                (name, from.clone(), &from + from.clone() * share)
            })
            .collect();
        let line = |b: &BigRational, values: Vec<(&str, String)>| {
            let values = values
                .into_iter()
                .map(|(name, value)| format!(" {name}={value}"));
            let values: String = values.collect();
            let speed = if bound == 1 { " V=1..2" } else { "" };
            asked(&format!("b={b} c=9 k={k}{values}{speed}"))
        };
        let at = |shares: [i64; 4]| -> Vec<(&str, String)> {
            let each = ranges.iter().zip(shares);
            let each = each.map(|((name, from, to), share)| {
                (*name, (from + (to - from) * q(share, 12)).to_string())
            });
            each.collect()
        };
        let (middle, _) = line(&q(1, 1), at([6; 4]));
        let asked = middle
            .with_costs(40)
            .unwrap()
            .map(|_, x| x.hi().clone())
            .cost()
            .viscous;
        let near = (from_wide(&asked).unwrap() * q(100_000, 1)).floor() / q(100_000, 1);
        let b = near * q(1000 + random(9) * random(9) - 30, 1000);
        let ends = ranges
            .iter()
            .map(|(name, from, to)| (*name, format!("{from}..{to}")))
            .collect();
        let (whole, speeds) = line(&b, ends);
        let truth = whole.truth(&speeds).unwrap();
        said[truth as usize] += 1;
        for _ in 0..12 {
            let (one, speeds) = line(&b, at([0; 4].map(|_: i64| random(13))));
            let one = one.truth(&speeds).unwrap();
            assert!(
                truth == Truth::Depends || one == truth || one == Truth::Depends,
                "{whole:?}: {one:?}"
            );
        }
    }
    assert!(said.iter().all(|n| *n > 3), "{said:?}");
}
