//! TH-LTI: polynomials with rational coefficients, against sums and products written out.

use passivity_core::BigRational;
use passivity_core::polynomial::Polynomial;

use crate::common::{q, zero};
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

/// Where Σ aᵢ(1 − s)ⁱ(1 + s)ⁿ⁻ⁱ has coefficients above zero only, and nowhere else.
#[test]
fn th_lti_polynomials_that_are_plainly_positive() {
    let by_hand = |a: &[i64]| {
        let n = a.len() - 1;
        let mut sum = vec![zero(); n + 1];
        for (i, a) in a.iter().enumerate() {
            let mut term = vec![q(*a, 1)];
            for k in 0..n {
                term = times(&term, &[q(1, 1), q(if k < i { -1 } else { 1 }, 1)]);
            }
            for (sum, c) in sum.iter_mut().zip(term) {
                *sum += c;
            }
        }
        sum.iter().all(|c| *c > zero())
    };
    let mut found = [0, 0];
    let range = -2..=3_i64;
    for a in range.clone() {
        for b in range.clone() {
            assert_eq!(of(&[a]).is_plainly_positive(), a > 0);
            for c in range.clone().filter(|c| *c != 0) {
                for more in [vec![a, b, c], vec![a, b, 0, c], vec![b, a, c, 1]] {
                    let expected = by_hand(&more);
                    assert_eq!(of(&more).is_plainly_positive(), expected, "{more:?}");
                    found[usize::from(expected)] += 1;
                }
            }
        }
    }
    assert!(found.iter().all(|n| *n > 50), "{found:?}");
    assert!(!of(&[]).is_plainly_positive());
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
