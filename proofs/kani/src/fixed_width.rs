//! The fixed-width instance: no overflow within its stated bound, no panic anywhere.
//!
//! `ledger::row` states how many bits its result takes; the harnesses here hold it to that at
//! 32 bits, where all inputs within the bound can be looked at. The count of bits is the same for
//! every width.

use passivity_core::{
    Fraction, Friction, Loop, Ordered, Step,
    ledger::{self, HeldInterval, Row},
    verdict,
};

use passivity_core::{Criterion, Scalar};

/// Magnitudes within the bound of 32 bits: 2 bits, see `ledger::row`.
const WITHIN: i8 = 3;

/// Denominators: the two largest of 2 bits, no two neighbours equal, so that nothing is shared.
const DENOMINATORS: [i32; 2] = [3, 2];

fn within(low: i8, high: i8, denominator: i32) -> Fraction<i32> {
    let n = kani::any_where(|n: &i8| *n >= low && *n <= high);
    Fraction::new(i32::from(n), denominator)
}

/// The row of a step with the most friction and the largest fraction of time: with less, no numerator
/// and no denominator of a field grows.
fn row(start: Fraction<i32>, end: Fraction<i32>) -> Row<Fraction<i32>> {
    let [p, q] = DENOMINATORS;
    let most = i32::from(WITHIN);
    let friction = Friction::new(Fraction::new(most, p), Fraction::new(most, q));
    let interval = HeldInterval::plain(Step::new(start, end), Fraction::new(most, p));
    ledger::row(&Loop::plain(friction), &interval)
}

fn is_defined(row: &Row<Fraction<i32>>) -> bool {
    row.net_linear.is_defined()
        && row.net_quantized.is_defined()
        && row.bound_22.is_defined()
        && row.bound_quantized.is_defined()
        && row.margin.is_defined()
}

/// TH-INTERVAL: within its stated bound a row of 32-bit fractions is defined in every field; here
/// of a step that starts inside the wall or at its border.
#[kani::proof]
fn th_interval_row_is_defined_within_its_bound() {
    let [p, q] = DENOMINATORS;
    let row = row(within(0, WITHIN, p), within(-WITHIN, WITHIN, q));
    kani::cover!(
        row.margin.is_nonnegative() == Some(true),
        "the criterion holds"
    );
    kani::assert(
        is_defined(&row),
        "TH-INTERVAL: within its bound a row does not overflow",
    );
}

/// TH-INTERVAL: the same of a step that starts outside the wall.
#[kani::proof]
fn th_interval_row_from_outside_is_defined_within_its_bound() {
    let [p, q] = DENOMINATORS;
    let row = row(within(-WITHIN, -1, p), within(-WITHIN, WITHIN, q));
    kani::cover!(
        row.margin.is_nonnegative() == Some(true),
        "the criterion holds"
    );
    kani::assert(
        is_defined(&row),
        "TH-INTERVAL: within its bound a row does not overflow",
    );
}

fn anything() -> Fraction<i32> {
    Fraction::new(kani::any(), kani::any())
}

/// Whether a fraction is undefined or has a denominator above zero.
fn is_sound(x: &Fraction<i32>) -> bool {
    x.parts().is_none_or(|(_, d)| *d > 0)
}

/// NUM-EXACT: a sum, a difference or the larger or smaller one of any two 32-bit fractions is a fraction or undefined; none
/// panics.
#[kani::proof]
fn num_exact_sums_never_panic() {
    let (x, y) = (anything(), anything());
    let sum = x + y;
    kani::cover!(
        !sum.is_defined() && x.is_defined() && y.is_defined(),
        "a sum overflows"
    );
    kani::assert(
        [sum, x - y, x.max(y), x.min(y)].iter().all(is_sound),
        "NUM-EXACT: a defined sum has a denominator above zero",
    );
}

/// NUM-EXACT: a product or a quotient of any two 32-bit fractions is a fraction or undefined, and so is half, the size or the
/// negative of one; none panics.
#[kani::proof]
fn num_exact_products_never_panic() {
    let (x, y) = (anything(), anything());
    let quotient = x.over(y);
    kani::cover!(quotient.is_defined(), "a quotient is defined");
    kani::assert(
        [x * y, quotient, -x, x.half(), x.abs()]
            .iter()
            .all(is_sound),
        "NUM-EXACT: a defined product has a denominator above zero",
    );
}

/// NUM-EXACT: products and quotients of fractions are those of their numerators and denominators, and nothing is divided by
/// zero.
#[kani::proof]
fn num_exact_products_are_right() {
    let [b, d] = DENOMINATORS;
    let (a, c) = (i32::from(kani::any::<i8>()), i32::from(kani::any::<i8>()));
    let (x, y) = (Fraction::new(a, b), Fraction::new(c, d));
    let (product, quotient) = (x * y, x.over(y));
    kani::cover!(a < 0 && c < 0, "both are below zero");
    kani::assert(
        product.parts() == Some((&(a * c), &(b * d))),
        "NUM-EXACT: a product is right",
    );
    let [n, over] = if c < 0 {
        [-a * d, -b * c]
    } else {
        [a * d, b * c]
    };
    kani::assert(
        quotient.parts() == (c != 0).then_some((&n, &over)),
        "NUM-EXACT: a quotient is right, and undefined over zero",
    );
}

/// NUM-EXACT: ⌊x⌋ is an integer n with n ≤ x < n + 1.
///
/// 8 bits over 4: the quotient is multiplied with the denominator again.
#[kani::proof]
fn num_exact_floor_is_just_below() {
    let n = kani::any_where(|n: &i16| *n > -128 && *n < 128);
    let d = kani::any_where(|d: &u8| *d > 0 && *d < 16);
    let (n, d) = (i32::from(n), i32::from(d));
    let floor = Fraction::new(n, d).floor();
    kani::cover!(n < 0 && d > 1, "below zero");
    if let Some((q, one)) = floor.parts() {
        kani::assert(
            *one == 1 && q * d <= n && n < q * d + d,
            "NUM-EXACT: the floor is the integer just below",
        );
    } else {
        kani::assert(false, "NUM-EXACT: a floor is always defined");
    }
}

/// TH-REGION: a verdict on any two 32-bit fractions is given or refused; it never panics.
#[kani::proof]
fn th_region_verdict_never_panics() {
    let criterion = Criterion {
        viscous: anything(),
        coulomb: anything(),
    };
    let speed = anything();
    let defined = criterion.viscous.is_defined() && criterion.coulomb.is_defined();
    let decision = verdict::decide(&criterion, &verdict::Speeds::UpTo(speed));
    kani::cover!(defined && decision.is_none(), "a verdict is refused");
    kani::assert(
        kani::implies!(decision.is_some() => defined),
        "TH-REGION: no verdict comes from an undefined number",
    );
}
