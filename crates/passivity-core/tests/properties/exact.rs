//! Numbers with π in them, against rationals that agree with π to hundreds of digits.

use std::cmp::Ordering::{Equal, Greater, Less};
use std::sync::LazyLock;

use num_bigint::BigInt;
use passivity_core::fraction::Integer as _;
use passivity_core::pi::{Polynomial, pi};
use passivity_core::verdict::Speeds;
use passivity_core::{BigRational, Exact, Interval, Loop, Ordered, Scalar, Truth};
use proptest::prelude::*;

use crate::common::{number, q, sampled, zero};

/// 2^−1500 is beyond what numbers of these tests can come near to zero without being zero.
pub(crate) const BITS: u32 = 1500;

/// π to [`BITS`] bits, by Gauss's formula 48·arctan(1/18) + 32·arctan(1/57) − 20·arctan(1/239):
/// another one than the kernel's.
pub(crate) static PI: LazyLock<BigRational> = LazyLock::new(|| {
    let one = BigInt::from(1) << (BITS + 64);
    let arctan = |n: u32| {
        let (mut sum, mut power, mut k) = (BigInt::ZERO, &one / n, 1);
        while power != BigInt::ZERO {
            sum += &power / k;
            power /= -BigInt::from(n * n);
            k += 2;
        }
        sum
    };
    BigRational::new(arctan(18) * 48 + arctan(57) * 32 - arctan(239) * 20, one)
});

/// What computes: a sum, product, quotient, … of numbers and π.
#[derive(Clone, Debug)]
enum Expression {
    Pi,
    Number(BigRational),
    Add(std::boxed::Box<[Expression; 2]>),
    Sub(std::boxed::Box<[Expression; 2]>),
    Mul(std::boxed::Box<[Expression; 2]>),
    Over(std::boxed::Box<[Expression; 2]>),
    Half(std::boxed::Box<Expression>),
}

impl Expression {
    fn evaluate<S: Scalar>(&self, pi: &S, of: &dyn Fn(&BigRational) -> S) -> S {
        let at = |x: &Self| x.evaluate(pi, of);
        match self {
            Self::Pi => pi.clone(),
            Self::Number(x) => of(x),
            Self::Add(xy) => at(&xy[0]) + at(&xy[1]),
            Self::Sub(xy) => at(&xy[0]) - at(&xy[1]),
            Self::Mul(xy) => at(&xy[0]) * at(&xy[1]),
            Self::Over(xy) => at(&xy[0]).over(at(&xy[1])),
            Self::Half(x) => at(x).half(),
        }
    }

    fn exact(&self) -> Exact {
        self.evaluate(&pi(), &Exact::of)
    }

    /// The value at the rational next to π; `None` where it divides by zero.
    fn near(&self) -> Option<BigRational> {
        let wide = |x: &BigRational| passivity_core::rational::to_wide(x);
        passivity_core::rational::from_wide(&self.evaluate(&wide(&PI), &wide))
    }
}

fn expression() -> impl Strategy<Value = Expression> {
    let small = (-40i64..40, 1i64..12).prop_map(|(n, d)| Expression::Number(q(n, d)));
    let leaf = prop_oneof![Just(Expression::Pi), small];
    leaf.prop_recursive(4, 24, 2, |inner| {
        let pair = (inner.clone(), inner.clone()).prop_map(|(x, y)| std::boxed::Box::new([x, y]));
        prop_oneof![
            pair.clone().prop_map(Expression::Add),
            pair.clone().prop_map(Expression::Sub),
            pair.clone().prop_map(Expression::Mul),
            pair.prop_map(Expression::Over),
            inner.prop_map(|x| Expression::Half(std::boxed::Box::new(x))),
        ]
    })
}

/// Whether a difference is so small that the two are one number.
fn is_nothing(x: &BigRational) -> bool {
    let bound = BigRational::new(1.into(), BigInt::from(1) << (BITS / 2));
    *x < bound && *x > -bound
}

sampled! {
    fn num_exact_pi_signs_are_those_of_the_numbers(of in expression(), other in expression()) {
        let (exact, other_exact) = (of.exact(), other.exact());
        let (Some(near), Some(other_near)) = (of.near(), other.near()) else {
            // Divided by zero, whatever π is.
            prop_assert!(!exact.is_defined() || !other_exact.is_defined());
            return Ok(());
        };
        // At a number next to π one may divide by next to nothing where π divides by zero.
        prop_assume!(exact.is_defined() && other_exact.is_defined());
        let sign = if is_nothing(&near) { Equal } else { near.cmp(&zero()) };
        prop_assert_eq!(exact.sign(), Some(sign));
        let difference = near - &other_near;
        let order = if is_nothing(&difference) { Equal } else { difference.cmp(&zero()) };
        prop_assert_eq!(exact.compare(&other_exact), Some(order));
        prop_assert_eq!(exact == other_exact, order == Equal);
        let larger = if order == Less { &other_exact } else { &exact };
        prop_assert_eq!(&exact.clone().max(other_exact.clone()), larger);
    }

    fn num_exact_pi_floors(of in expression()) {
        let exact = of.exact();
        prop_assume!(exact.is_defined());
        let near = of.near().unwrap();
        // A whole number is its own floor, even where the rational is just below it.
        let nearest = (&near + q(1, 2)).floor();
        let floor = if is_nothing(&(&near - &nearest)) { nearest } else { near.floor() };
        prop_assert_eq!(exact.floor().to_rational(), Some(floor));
    }

    fn num_exact_pi_enclosures(of in expression(), digits in 1u32..200) {
        let exact = of.exact();
        prop_assume!(exact.is_defined());
        let found = exact.enclosure(digits).unwrap();
        prop_assert!(Exact::of(found.lo()) <= exact && exact <= Exact::of(found.hi()));
        // A point when there is no π in it, and about as wide as asked for otherwise.
        prop_assert_eq!(found.is_point(), exact.to_rational().is_some());
        let width = (found.hi() - found.lo()) * BigRational::from_integer(BigInt::from(1) << digits);
        let size = std::cmp::max(found.hi().clone(), -found.lo());
        prop_assert!(width <= size * q(4, 1));
    }

    fn num_exact_pi_that_cancels_is_gone(of in expression(), x in number()) {
        let exact = of.exact();
        prop_assume!(exact.is_defined() && exact.sign() != Some(Equal));
        let scaled = exact.clone() * Exact::of(&x);
        prop_assert_eq!(scaled.clone().over(exact.clone()).to_rational(), Some(x.clone()));
        prop_assert_eq!((scaled.clone() - scaled.clone()).to_rational(), Some(zero()));
        // However little is left beside it.
        let tiny = BigRational::new(1.into(), BigInt::from(1) << 900);
        let beside = scaled.clone() + Exact::of(&tiny);
        prop_assert_eq!(beside.compare(&scaled), Some(Greater));
        prop_assert_eq!((beside - scaled).to_rational(), Some(tiny));
    }

    fn num_exact_pi_of_rationals_is_the_rational(x in number(), y in number()) {
        let (exact_x, exact_y) = (Exact::of(&x), Exact::of(&y));
        prop_assert_eq!(exact_x.to_rational(), Some(x.clone()));
        prop_assert_eq!((exact_x.clone() + exact_y.clone()).to_rational(), Some(&x + &y));
        prop_assert_eq!((exact_x.clone() * exact_y.clone()).to_rational(), Some(&x * &y));
        prop_assert_eq!(exact_x.compare(&exact_y), Some(x.cmp(&y)));
        prop_assert_eq!(exact_x.floor().to_rational(), Some(x.floor()));
        let wide = exact_x.to_wide().and_then(|wide| passivity_core::rational::from_wide(&wide));
        prop_assert_eq!(wide, Some(x));
        prop_assert!(pi().to_wide().is_none());
    }
}

#[test]
fn num_exact_pi_division_by_zero_is_undefined() {
    let nothing = pi() - pi();
    assert_eq!(nothing.to_rational(), Some(zero()));
    for undefined in [
        pi().over(nothing.clone()),
        Exact::one().over(nothing.clone()),
        Exact::one().over(pi() * pi() - pi().square()),
        nothing.clone().over(nothing),
    ] {
        assert!(!undefined.is_defined());
        assert_eq!((undefined.sign(), undefined.to_rational()), (None, None));
        assert!(undefined.enclosure(64).is_none() && undefined.to_wide().is_none());
        assert!(!(undefined + pi()).is_defined());
    }
}

#[test]
fn num_exact_pi_has_the_tabulated_digits() {
    // The first 60 decimals of π as tabulated, as two neighbours.
    let digits = "3141592653589793238462643383279502884197169399375105820974944";
    let digits: BigInt = digits.parse().unwrap();
    let scale = BigInt::from(10).pow(60);
    let below = BigRational::new(digits.clone(), scale.clone());
    let above = BigRational::new(digits + 1, scale);
    assert!(below < *PI && *PI < above);
    assert!(Exact::of(&below) < pi() && pi() < Exact::of(&above));
    // An enclosure is about as tight as was asked for.
    for digits in [1, 64, 256, 1024] {
        let found = pi().enclosure(digits).unwrap();
        assert!(*found.lo() < *PI && *PI < *found.hi());
        let width =
            (found.hi() - found.lo()) * BigRational::from_integer(BigInt::from(1) << digits);
        assert!(width <= q(4, 1));
    }
}

#[test]
fn num_exact_pi_operations_of_polynomials() {
    let [zero, two, seven] = [0, 2, 7].map(Polynomial::from_i32);
    let (x, square) = (Polynomial::power(1), Polynomial::power(2));
    assert_eq!(x.mul(&x), Some(square.clone()));
    assert_eq!(x.sub(&x), Some(zero.clone()));
    assert_eq!(x.mul(&zero), Some(zero.clone()));
    assert_eq!(x.add(&x), x.mul(&two));
    assert_eq!(x.add(&x).and_then(|sum| sum.halved()), Some(x.clone()));
    assert_eq!(x.halved(), None);
    assert_eq!((x.signum(), zero.signum()), (Some(Greater), Some(Equal)));
    assert_eq!(
        (x.compare(&square), seven.compare(&square)),
        (Some(Less), Some(Less))
    );
    // ⌊π²⌋ = 9, ⌊7/π⌋ = 2, ⌊−7/π⌋ = −3, ⌊2π/π⌋ = 2; the divisor must be above zero.
    let whole = |n: i32| Some(Polynomial::from_i32(n));
    assert_eq!(square.div_floor(&Polynomial::from_i32(1)), whole(9));
    assert_eq!(seven.div_floor(&x), whole(2));
    assert_eq!(zero.sub(&seven).unwrap().div_floor(&x), whole(-3));
    assert_eq!(x.mul(&two).unwrap().div_floor(&x), whole(2));
    assert_eq!(seven.div_floor(&zero), None);
    assert_eq!(seven.div_floor(&zero.sub(&x).unwrap()), None);
    assert_eq!(two.as_whole(), Some(BigInt::from(2)));
    assert_eq!((zero.as_whole(), x.as_whole()), (Some(BigInt::ZERO), None));
}

/// A wall in N·m/deg and an encoder in degrees, with Coulomb friction at the border: π cancels.
#[test]
fn num_exact_pi_in_a_loop_is_decided_where_it_cancels() {
    let number = |n: i64, d: i64| Exact::of(&q(n, d));
    let degree = || pi().over(number(180, 1));
    // 3 N·m/deg, 1/5 deg and 3/10 N·m: KΔ/2 is 3/10 exactly.
    let of = |coulomb: Exact| Loop {
        viscous: Some(number(1, 1)),
        coulomb: Some(coulomb),
        resolution: Some(number(1, 5) * degree()),
        ..Loop::new(number(3, 1).over(degree()), number(1, 1000))
    };
    let decide = |of: &Loop<Exact>| {
        of.map(|_, x| Interval::point(x.clone()))
            .decide(&Speeds::All)
    };
    assert_eq!(
        of(number(3, 10)).cost().coulomb.to_rational(),
        Some(q(3, 10))
    );
    assert_eq!(decide(&of(number(3, 10))), Some(Truth::Holds));
    let tiny = Exact::of(&BigRational::new(1.into(), BigInt::from(1) << 500));
    assert_eq!(decide(&of(number(3, 10) - tiny)), Some(Truth::Fails));
    // Viscous friction at KT/2, which has π in it.
    let border = number(3, 2000).over(degree());
    let at = |viscous| Loop {
        viscous: Some(viscous),
        ..of(number(3, 10))
    };
    assert_eq!(decide(&at(border.clone())), Some(Truth::Holds));
    let [below, above] = border
        .enclosure(300)
        .map(|found| [found.lo(), found.hi()].map(Exact::of))
        .unwrap();
    assert_eq!(decide(&at(below)), Some(Truth::Fails));
    assert_eq!(decide(&at(above)), Some(Truth::Holds));
}

/// Numerators within 2⁻¹⁰⁰ of a whole multiple of their denominator, on either side of it: the first
/// enclosure of π, of 64 bits, has whole numbers inside, and each of its ends decides for some signs.
#[test]
fn num_exact_pi_floors_beside_whole_numbers() {
    let tiny = Exact::of(&BigRational::new(1.into(), BigInt::from(1) << 100));
    let two = Exact::integer(2);
    for whole in [-7, -1, 0, 1, 7] {
        let number = Exact::integer(whole);
        for denominator in [pi(), two.clone(), pi() * pi() + two.clone()] {
            let middle = number.clone() * denominator.clone();
            let beside = tiny.clone() * pi();
            let floor = |x: Exact| x.over(denominator.clone()).floor().to_rational();
            assert_eq!(
                floor(middle.clone() + beside.clone()),
                Some(q(i64::from(whole), 1))
            );
            assert_eq!(
                floor(middle.clone() - beside),
                Some(q(i64::from(whole) - 1, 1))
            );
            assert_eq!(floor(middle), Some(q(i64::from(whole), 1)));
        }
    }
}

/// π less its first bits is near zero: the enclosure is as narrow for its size as for other numbers,
/// has the sign, and holds the number.
#[test]
fn num_exact_pi_is_enclosed_relative_to_the_size() {
    for bits in [3_u32, 62, 63, 64, 65, 130, 255, 256, 300] {
        let cut = BigInt::from(1) << bits;
        let below = (&*PI * BigRational::from_integer(cut.clone())).floor()
            / BigRational::from_integer(cut);
        for (x, near) in [
            (pi() - Exact::of(&below), &*PI - &below),
            (Exact::of(&below) - pi(), &below - &*PI),
            (
                (Exact::of(&below) - pi()).over(pi()),
                (&below - &*PI) / &*PI,
            ),
            (pi().over(Exact::of(&below) - pi()), &*PI / (&below - &*PI)),
        ] {
            let found = x.enclosure(20).unwrap();
            assert!(*found.lo() <= near && near <= *found.hi(), "{bits}");
            let size = crate::common::magnitude(&near);
            assert!((found.hi() - found.lo()) * q(1 << 18, 1) <= size, "{bits}");
        }
    }
}

/// A common power of π is taken out of a numerator and a denominator that have different ones.
#[test]
fn num_exact_pi_cancels_by_the_smaller_power() {
    let cube = pi() * pi() * pi();
    for (n, d) in [(cube.clone(), pi()), (pi(), cube)] {
        let quotient = n.over(d);
        assert_eq!(quotient.clone().shortened(), quotient);
    }
}
