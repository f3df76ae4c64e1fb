//! TH-LTI: polynomials with rational coefficients, against sums and products written out.

use passivity_core::polynomial::Polynomial;
use passivity_core::{BigRational, Interval, sturm};

use crate::common::q;
use crate::transfer::times;

fn of(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|c| q(*c, 1)))
}

#[test]
fn num_exact_polynomials_know_their_degree() {
    assert_eq!((of(&[]).degree(), of(&[]).is_zero()), (None, true));
    assert_eq!((of(&[0, 0]).degree(), of(&[0, 0]).is_zero()), (None, true));
    assert_eq!((of(&[3]).degree(), of(&[3]).is_zero()), (Some(0), false));
    assert_eq!(of(&[0, 0, -2, 0]).degree(), Some(2));
    // 3 − x + 2x² at −5/3, and its sign where it is close to zero.
    let parabola = of(&[3, -1, 2]);
    assert_eq!(parabola.at(&q(-5, 3)), q(3 * 9 + 5 * 3 + 2 * 25, 9));
    let thirds = Polynomial::new([q(-1, 3), q(1, 1)]);
    for (x, sign) in [
        (q(1, 3), 0),
        (q(1_000_001, 3_000_000), 1),
        (q(999_999, 3_000_000), -1),
    ] {
        assert_eq!(thirds.sign_at(&x) as i32, sign);
    }
}

/// As Sturm's sequence says: it is not seen only of those that touch zero and go no further.
#[test]
fn th_lti_polynomials_that_are_plainly_positive() {
    let ends = Interval::hull(q(-1, 1), q(1, 1));
    let mut found = [0, 0, 0];
    let range = -2..=3_i64;
    for a in range.clone() {
        for b in range.clone() {
            for c in range.clone() {
                for more in [vec![a], vec![a, b, c], vec![a, b, 0, c], vec![b, a, c, 1]] {
                    let polynomial = of(&more);
                    let is_touched = sturm::has_root(&polynomial, &ends);
                    let expected = match sturm::sign_over(&polynomial, &ends).is_nonnegative() {
                        true if is_touched => None,
                        sign => Some(sign),
                    };
                    assert_eq!(polynomial.is_plainly_positive(), expected, "{more:?}");
                    found[expected.map_or(2, usize::from)] += 1;
                }
            }
        }
    }
    assert!(found.iter().all(|n| *n > 10), "{found:?}");
    // By how little: (3x − 1)² ± 10⁻²⁰.
    let third = of(&[1, -6, 9]);
    for (raised, expected) in [(1, Some(true)), (-1, Some(false)), (0, None)] {
        let little = Polynomial::constant(q(raised, 10_000_000_000)).scaled(&q(1, 10_000_000_000));
        assert_eq!((&third + &little).is_plainly_positive(), expected);
    }
}

#[test]
fn num_exact_polynomials_divide_without_a_rest_what_they_multiplied() {
    let factors = [
        of(&[1, 2]),
        of(&[-3, 0, 1]),
        Polynomial::new([q(1, 2), q(-2, 3)]),
        of(&[5]),
    ];
    for a in &factors {
        for b in &factors {
            let product = a * b;
            let expected = times(&a.coefficients(), &b.coefficients());
            assert_eq!(product.coefficients(), expected);
            let (quotient, rest) = product.divided_by(b).unwrap();
            assert_eq!((&quotient, rest.is_zero()), (a, true));
            // x² + 1 is prime to all of them.
            let more = &product + &of(&[1]);
            let (_, rest) = more.divided_by(b).unwrap();
            assert_eq!(rest.is_zero(), b.degree() == Some(0));
        }
        let derivative = a.derivative();
        for (k, c) in a.coefficients().iter().enumerate().skip(1) {
            let times = BigRational::from_integer(k.into());
            assert_eq!(derivative.coefficients()[k - 1], c * times);
        }
    }
}

/// x³ + 2 less x(x² + 1) is 2 − x, and 4x³ − 3 at ½ is −5/2: of both the positive multiple with coprime coefficients.
#[test]
fn num_exact_polynomials_remainders_by_hand() {
    assert_eq!(of(&[2, 0, 0, 1]).remainder(&of(&[1, 0, 1])), of(&[2, -1]));
    assert_eq!(of(&[-3, 0, 0, 4]).remainder(&of(&[1, -2])), of(&[-1]));
    assert_eq!(of(&[1, 2]).remainder(&of(&[])), of(&[]));
    assert_eq!(of(&[4, 2]).remainder(&of(&[0, 0, 1])), of(&[2, 1]));
}
