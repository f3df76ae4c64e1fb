//! TH-NDOF: quadratic forms of small matrices, by their determinants.

use num_bigint::BigInt;
use passivity_core::definite::{self, Form, decide_enclosed, least_last};
use passivity_core::pi::pi;
use passivity_core::{BigRational, Exact, Ordered as _, Scalar as _};

use crate::common::{q, zero};

fn matrix(rows: &[&[i64]]) -> Vec<Vec<BigRational>> {
    let row = |row: &&[i64]| row.iter().map(|x| q(*x, 1)).collect();
    rows.iter().map(row).collect()
}

/// The least x with det ≥ 0, where the others allow one.
#[test]
fn th_ndof_the_least_last_entry() {
    for (rows, expected) in [
        // 4x ≥ 9.
        (matrix(&[&[4, 3], &[3, 100]]), Some(q(9, 4))),
        (matrix(&[&[4, -3], &[-3, -100]]), Some(q(9, 4))),
        // 2x ≥ 1 once the first is eliminated: 2 − ½·… of [[2, 1, 0], [1, 2, 1], [0, 1, x]].
        (matrix(&[&[2, 1, 0], &[1, 2, 1], &[0, 1, 7]]), Some(q(2, 3))),
        // A zero that is alone asks for nothing, and one that is not for the impossible.
        (matrix(&[&[0, 0], &[0, 5]]), Some(zero())),
        (matrix(&[&[0, 1], &[1, 5]]), None),
        (matrix(&[&[-1, 0], &[0, 5]]), None),
        (matrix(&[&[1, 2, 0], &[2, 4, 0], &[0, 0, 1]]), Some(zero())),
        (matrix(&[&[1, 2, 0], &[2, 4, 1], &[0, 1, 1]]), None),
        (matrix(&[&[1, 2, 0], &[2, 3, 0], &[0, 0, 1]]), None),
        (matrix(&[&[3]]), Some(zero())),
    ] {
        assert_eq!(least_last(rows.clone()), expected, "{rows:?}");
        let Some(least) = expected else { continue };
        // There it is semidefinite, and a little below it is not.
        for (off, holds) in [(zero(), true), (q(1, 1_000_000), false)] {
            let mut rows = rows.clone();
            *rows.last_mut().unwrap().last_mut().unwrap() = &least - off;
            let form = definite::decide(rows).unwrap();
            assert_eq!(form.is_semidefinite(), holds);
        }
    }
}

/// [[π, x], [x, 1]] is semidefinite where x² ≤ π: to far beyond what 64 bits tell, with a direction that
/// shows it where not.
#[test]
fn th_ndof_matrices_with_pi() {
    let scale: BigInt = BigInt::from(1) << 600;
    // ⌊√π·2⁶⁰⁰⌋ by squares of exact numbers.
    let root = {
        let (mut lo, mut hi) = (scale.clone(), &scale * 2);
        while &hi - &lo > BigInt::from(1) {
            let middle: BigInt = (&lo + &hi) / 2;
            let x = Exact::of(&BigRational::new(middle.clone(), scale.clone()));
            match (pi() - x.clone() * x).is_nonnegative() {
                Some(true) => lo = middle,
                _ => hi = middle,
            }
        }
        BigRational::new(lo, scale)
    };
    let rows = |x: &BigRational, sign: i64| {
        let x = Exact::of(&(x * q(sign, 1)));
        vec![vec![pi(), x.clone()], vec![x, Exact::one()]]
    };
    for bits in [10, 40, 70, 400, 590] {
        let off = BigRational::new(1.into(), BigInt::from(1) << bits);
        for sign in [1, -1] {
            let inside = rows(&(&root - &off), sign);
            assert_eq!(decide_enclosed(&inside), Some(Form::Semidefinite), "{bits}");
            let outside = rows(&(&root + &off), sign);
            let Some(Form::Negative(d)) = decide_enclosed(&outside) else {
                panic!("{bits}")
            };
            assert_eq!(
                definite::quadratic(&outside, &d).is_nonnegative(),
                Some(false)
            );
        }
    }
    // Multiples of one entry are as good as rational, and a negative diagonal tells at once.
    let multiples = |x: i64| {
        let of = |x: i64| Exact::integer(i32::try_from(x).unwrap()) * pi();
        vec![vec![of(1), of(2)], vec![of(2), of(x)]]
    };
    assert_eq!(decide_enclosed(&multiples(4)), Some(Form::Semidefinite));
    assert!(matches!(
        decide_enclosed(&multiples(3)),
        Some(Form::Negative(_))
    ));
    assert!(matches!(
        decide_enclosed(&multiples(-3)),
        Some(Form::Negative(_))
    ));
    // A row of zeros is exact: it leaves nothing open.
    let (zero, one) = (Exact::zero, Exact::one);
    let beside = |x: Exact| {
        vec![
            vec![pi(), zero(), x.clone()],
            vec![zero(), zero(), zero()],
            vec![x, zero(), one()],
        ]
    };
    assert_eq!(decide_enclosed(&beside(one())), Some(Form::Semidefinite));
    let negative = decide_enclosed(&beside(one().double()));
    assert!(matches!(negative, Some(Form::Negative(_))));
}
