//! TH-LTI: the sign of a polynomial on [−1, 1], against the roots that it was made of.

use passivity_core::polynomial::Polynomial;
use passivity_core::sturm::{self, SignOver};
use passivity_core::{BigRational, Interval};
use proptest::prelude::*;

use crate::common::{magnitude, q, sampled, zero};
use crate::transfer::small;

fn everywhere() -> Interval<BigRational> {
    Interval::hull(q(-1, 1), q(1, 1))
}

/// A polynomial with these roots, each as often as said.
fn with_roots(roots: &[(BigRational, u32)], factor: &BigRational) -> Polynomial {
    let mut product = Polynomial::constant(factor.clone());
    for (root, times) in roots {
        for _ in 0..*times {
            product = &product * &Polynomial::new([-root, q(1, 1)]);
        }
    }
    product
}

fn value(coefficients: &[BigRational], x: &BigRational) -> BigRational {
    let mut power = q(1, 1);
    let mut sum = zero();
    for a in coefficients {
        sum += a * &power;
        power *= x;
    }
    sum
}

fn roots() -> impl Strategy<Value = Vec<(BigRational, u32)>> {
    prop::collection::vec(((-20i64..21).prop_map(|n| q(n, 12)), 1u32..5), 0..5)
}

sampled! {
    /// Decided as by the signs between the roots that are known, ends and multiple roots included.
    fn th_lti_sturm_against_known_roots(roots in roots(), factor in small(), shift in any::<bool>()) {
        let mut polynomial = with_roots(&roots, &factor);
        if shift {
            // A part without real roots.
            polynomial = &polynomial * &Polynomial::new([q(1, 7), zero(), q(1, 1)]);
        }
        let mut stops: Vec<BigRational> = roots.iter().map(|(root, _)| root.clone()).collect();
        stops.extend([q(-1, 1), q(1, 1)]);
        stops.retain(|x| magnitude(x) <= q(1, 1));
        stops.sort();
        let between = stops.windows(2).map(|pair| (&pair[0] + &pair[1]) / q(2, 1));
        let negative = between.into_iter().any(|x| polynomial.at(&x) < zero());
        match sturm::sign_over(&polynomial, &everywhere()) {
            SignOver::Nonnegative(certificate) => {
                prop_assert!(!negative);
                prop_assert!(certificate.shows(&polynomial, &everywhere()));
                // No certificate of one polynomial shows another.
                let lower = &polynomial - &Polynomial::constant(q(1, 1_000_000));
                prop_assert!(!certificate.shows(&lower, &everywhere()));
            }
            SignOver::NegativeAt(x) => {
                prop_assert!(negative);
                prop_assert!(magnitude(&x) <= q(1, 1));
                prop_assert!(value(&polynomial.coefficients(), &x) < zero());
            }
        }
    }

    /// On a dense grid nothing is negative where so decided; lowered by its least value there and a
    /// little more, it is.
    fn th_lti_sturm_against_a_grid(coefficients in prop::collection::vec(small(), 1..8)) {
        let polynomial = Polynomial::new(coefficients.clone());
        let grid = (-200i64..=200).map(|n| value(&coefficients, &q(n, 200)));
        let least = grid.min().unwrap();
        let decided = sturm::sign_over(&polynomial, &everywhere()).is_nonnegative();
        prop_assert!(!decided || least >= zero());
        let raised = |by: BigRational| &polynomial - &Polynomial::constant(&least - by);
        prop_assert!(!sturm::sign_over(&raised(q(-1, 1_000_000)), &everywhere()).is_nonnegative());
        // The slope is at most Σ k·|aₖ|, and a grid point is within 1/400.
        let slope = coefficients.iter().zip(0i64..).fold(zero(), |s, (a, k)| s + magnitude(a) * q(k, 1));
        prop_assert!(sturm::sign_over(&raised(slope / q(400, 1)), &everywhere()).is_nonnegative());
    }

    /// A square is never negative; it touches zero exactly at its roots.
    fn th_lti_sturm_squares(a in small(), b in small(), c in small()) {
        let p = Polynomial::new([a, b, c]);
        let square = &p * &p;
        prop_assert!(sturm::sign_over(&square, &everywhere()).is_nonnegative());
        prop_assert_eq!(
            sturm::has_root(&square, &everywhere()),
            sturm::has_root(&p, &everywhere())
        );
        let above = &square + &Polynomial::constant(q(1, 1_000));
        prop_assert!(!sturm::has_root(&above, &everywhere()));
    }

    /// The bands where it is not positive hold every point of a grid that is not.
    fn th_lti_sturm_bands(roots in roots(), factor in small()) {
        let polynomial = with_roots(&roots, &factor);
        let bands = sturm::not_positive(&polynomial, &everywhere(), &q(1, 1000));
        for pair in bands.windows(2) {
            prop_assert!(pair[0].hi() < pair[1].lo());
        }
        for x in (-120i64..=120).map(|n| q(n, 120)) {
            let within = |slack: &BigRational| bands
                .iter().any(|band| x >= band.lo() - slack && x <= band.hi() + slack);
            if polynomial.at(&x) <= zero() {
                prop_assert!(within(&zero()));
            } else if within(&q(-1, 1000)) {
                prop_assert!(false, "{} is positive", x);
            }
        }
    }
}

#[test]
fn th_lti_sturm_borders() {
    let decide = |p: &[i64]| {
        let p = Polynomial::new(p.iter().map(|a| q(*a, 1)));
        sturm::sign_over(&p, &everywhere()).is_nonnegative()
    };
    assert!(decide(&[])); // 0
    assert!(decide(&[1]));
    assert!(!decide(&[-1]));
    assert!(decide(&[1, 1])); // 0 at −1
    assert!(decide(&[1, -1])); // 0 at 1
    assert!(decide(&[1, 0, -1])); // 0 at both
    assert!(!decide(&[-1, 0, 1])); // and below between them
    assert!(!decide(&[0, 1])); // a sign change in the middle
    assert!(decide(&[0, 0, 1])); // a double root there
    assert!(!decide(&[0, 0, 0, 1])); // a triple one
    assert!(decide(&[0, 0, 1, -1])); // x²(1 − x)
    assert!(decide(&[1, -1, -1, 1])); // (1 − x)²(1 + x)
    assert!(!decide(&[-1, -1, 1, 1])); // (x − 1)(1 + x)²
    assert!(decide(&[4, -4, 1])); // (2 − x)²
}

/// Whether a cubic c₀ + c₁x + c₂x² + c₃x³ of whole coefficients is negative somewhere on [−1, 1]: at an
/// end, or where its slope is zero, by squares of whole numbers.
fn is_negative_by_hand([c0, c1, c2, c3]: [i64; 4]) -> bool {
    if c0 + c2 < (c1 + c3).abs() {
        return true; // at an end
    }
    // The slope is c₁ + 2c₂x + 3c₃x².
    let (a, b) = (3 * c3, 2 * c2);
    if a == 0 {
        // A parabola is least at −c₁/(2c₂) if it opens upwards: c₀ − c₁²/(4c₂).
        return c2 > 0 && c1.abs() < 2 * c2 && 4 * c2 * c0 < c1 * c1;
    }
    let discriminant = b * b - 4 * a * c1;
    if discriminant <= 0 {
        return false; // It only rises, or only falls.
    }
    // The sign of u + v√Δ.
    let sign = |u: i64, v: i64| {
        let squares = (u * u).cmp(&(v * v * discriminant));
        match (u.signum(), v.signum()) {
            (p, q) if p >= 0 && q >= 0 => p.max(q),
            (p, q) if p <= 0 && q <= 0 => p.min(q),
            (p, _) => match squares {
                std::cmp::Ordering::Greater => p,
                std::cmp::Ordering::Less => -p,
                std::cmp::Ordering::Equal => 0,
            },
        }
    };
    // x = (−b ± √Δ)/(2a), and there 9c₃·P = (9c₃c₀ − c₁c₂) + (6c₃c₁ − 2c₂²)x, by division by the slope.
    let side = a.signum();
    [1, -1].into_iter().any(|root| {
        let inside = sign(2 * a.abs() + side * b, -side * root) > 0
            && sign(2 * a.abs() - side * b, side * root) > 0;
        let (constant, linear) = (9 * c3 * c0 - c1 * c2, 6 * c3 * c1 - 2 * c2 * c2);
        // Times 2a: 18ac₃·P, and ac₃ is above zero.
        inside && sign(2 * a * constant - linear * b, linear * root) < 0
    })
}

/// All cubics with whole coefficients from −4 to 4, against their least value by hand.
#[test]
fn th_lti_sturm_exhausts_small_cubics() {
    let all = -4..=4_i64;
    let (mut negative, mut touching) = (0, 0);
    for c0 in all.clone() {
        for c1 in all.clone() {
            for c2 in all.clone() {
                for c3 in all.clone() {
                    let whole = [c0, c1, c2, c3];
                    let polynomial = Polynomial::new(whole.map(|c| q(c, 1)));
                    let by_hand = is_negative_by_hand(whole);
                    let decided = sturm::sign_over(&polynomial, &everywhere());
                    assert_eq!(decided.is_nonnegative(), !by_hand, "{whole:?}");
                    negative += usize::from(by_hand);
                    touching +=
                        usize::from(!by_hand && sturm::has_root(&polynomial, &everywhere()));
                }
            }
        }
    }
    assert!(negative > 1000 && touching > 100, "{negative} {touching}");
}

/// A root counts at the ends too, also where the sign does not change; outside it does not.
#[test]
fn th_lti_sturm_has_root() {
    let roots = |roots: &[(BigRational, u32)]| with_roots(roots, &q(3, 1));
    assert!(sturm::has_root(
        &Polynomial::constant(zero()),
        &everywhere()
    ));
    assert!(!sturm::has_root(
        &Polynomial::constant(q(1, 1)),
        &everywhere()
    ));
    for root in [q(-1, 1), q(-1, 3), zero(), q(1, 1)] {
        for times in 1..4 {
            assert!(sturm::has_root(
                &roots(&[(root.clone(), times)]),
                &everywhere()
            ));
        }
    }
    assert!(!sturm::has_root(
        &roots(&[(q(-5, 4), 1), (q(9, 8), 2)]),
        &everywhere()
    ));
}

/// A certificate in which one part is wrong shows nothing, whatever the others say.
#[test]
fn th_lti_sturm_certificate_with_a_wrong_part_shows_nothing() {
    // (x − ¼)²·(x² + 1)·(9/8 − x): nowhere negative, with a root of even multiplicity, Sturm's sequence
    // of the rest has three members and more.
    let [one, two] = [1, 2].map(|n| Polynomial::constant(q(n, 1)));
    let rest = &Polynomial::new([q(1, 1), zero(), q(1, 1)]) * &Polynomial::new([q(9, 8), q(-1, 1)]);
    let polynomial = &with_roots(&[(q(1, 4), 2)], &q(1, 1)) * &rest;
    let SignOver::Nonnegative(right) = sturm::sign_over(&polynomial, &everywhere()) else {
        panic!("it is nowhere negative")
    };
    assert!(right.shows(&polynomial, &everywhere()));
    assert!(right.sequence.len() > 3);
    let shows = |change: &dyn Fn(&mut sturm::Certificate)| {
        let mut wrong = right.clone();
        change(&mut wrong);
        wrong.shows(&polynomial, &everywhere())
    };
    // A positive factor is nothing; a wrong polynomial in any place of the sequence is.
    assert!(shows(&|of| of.sequence[2] = &of.sequence[2] * &two));
    for i in 0..right.sequence.len() {
        assert!(!shows(
            &|of| of.sequence[i] = &of.sequence[i] + &Polynomial::new([zero(), q(1, 1)])
        ));
        assert!(!shows(
            &|of| of.sequence[i] = &of.sequence[i] * &Polynomial::constant(q(-1, 1))
        ));
    }
    // It must go on to a number, and not beyond.
    assert!(!shows(&|of| drop(of.sequence.pop())));
    assert!(!shows(&|of| of.sequence.push(one.clone())));
    assert!(!shows(&|of| of.sequence.truncate(1)));
    assert!(!shows(&|of| of.sequence.clear()));
    assert!(!shows(&|of| of.sign_changes[0] += 1));
    assert!(!shows(&|of| of.sign_changes[1] += 1));
    assert!(!shows(
        &|of| of.sign_changes = of.sign_changes.map(|n| n + 1)
    ));
    assert!(!shows(&|of| of.simple = &of.simple * &two));
    assert!(!shows(&|of| of.repeated = &of.repeated * &two));
}

/// A root at an end of a piece is met exactly, however wide an enclosure may be.
#[test]
fn th_lti_sturm_roots_at_the_ends_are_points() {
    let width = q(4, 1);
    for root in [q(-1, 1), q(1, 1)] {
        // 1 + x and 1 − x.
        let line = with_roots(&[(root.clone(), 1)], &-&root);
        let found = sturm::not_positive(&line, &everywhere(), &width);
        assert_eq!(found, [Interval::point(root)]);
    }
    // x²·(x − 1)²·(x + 1): zero at the ends and between.
    let touching = with_roots(&[(zero(), 2), (q(1, 1), 2), (q(-1, 1), 1)], &q(1, 1));
    let found = sturm::not_positive(&touching, &everywhere(), &width);
    assert!(
        found.iter().all(Interval::is_point) && found.len() == 3,
        "{found:?}"
    );
}

#[test]
fn th_lti_one_parabola_each_way() {
    let everywhere = Interval::hull(q(-1, 1), q(1, 1));
    let above = Polynomial::new([q(1, 1), q(0, 1), q(1, 1)]);
    assert!(sturm::sign_over(&above, &everywhere).is_nonnegative());
    let across = Polynomial::new([q(-1, 4), q(0, 1), q(1, 1)]);
    assert!(sturm::has_root(&across, &everywhere));
}
