//! Sums of doubles without rounding: the same however the terms are grouped.

use multiversion::multiversion;
use num_bigint::BigInt;
use passivity_core::BigRational;

use crate::log::running::near;

/// The exponent of the smallest double above zero: every double is a whole number of 2^−1074.
const LEAST: u32 = 1074;

/// How many bits apart the digits of the sum are.
const STRIDE: usize = 32;

/// Enough digits for the largest double.
const DIGITS: usize = 67;

/// A sum of doubles, exactly. A term that is no finite number makes all of it none.
#[derive(Clone, Debug)]
pub(crate) struct ExactSum {
    /// The digit `k` counts 2^(32k − 1074). A term, or a layer of some, adds less than 2^87 to one of them: there is room for
    /// 2^40 of them, those of sums that were added among them. Of no terms there are no digits.
    digits: Vec<i128>,
    /// What came from sums that were kept elsewhere.
    other: BigInt,
    finite: bool,
}

impl Default for ExactSum {
    fn default() -> Self {
        Self {
            digits: Vec::new(),
            other: BigInt::ZERO,
            finite: true,
        }
    }
}

impl ExactSum {
    /// Adds a term.
    pub(crate) fn add(&mut self, x: f64) {
        if !x.is_finite() {
            self.finite = false;
            return;
        }
        let bits = x.to_bits();
        let exponent = (bits >> 52) & 0x7ff;
        let fraction = bits & ((1 << 52) - 1);
        // Below the normal numbers the exponent is that of the least of them, without the leading one.
        let (mantissa, place) = match exponent {
            0 => (fraction, 0),
            e => (fraction | 1 << 52, e - 1),
        };
        let size = mantissa.cast_signed();
        let digits = if x.is_sign_negative() { -size } else { size };
        self.add_units(digits, place as usize);
    }

    /// Adds n·2^(place − 1074), with n below 2^55 in size and a place that a double has.
    fn add_units(&mut self, n: i64, place: usize) {
        self.digits.resize(DIGITS, 0);
        if let Some(digit) = self.digits.get_mut(place / STRIDE) {
            *digit += i128::from(n) << (place % STRIDE);
        }
    }

    /// Adds the products of two columns as far as both go, each rounded to the nearest double.
    pub(crate) fn add_products(&mut self, a: &[f64], b: &[f64]) {
        let len = a.len().min(b.len());
        let [a, b] = [a, b].map(|column| column.get(..len).unwrap_or_default());
        for (a, b) in a.chunks(SHORT).zip(b.chunks(SHORT)) {
            match layers(a, b) {
                Some(layers) => {
                    let layers = layers.as_flattened().iter();
                    for (lanes, grid) in layers.zip(GRIDS.as_flattened()) {
                        self.add_units(units(lanes, *grid), (LEAST as i32 + grid) as usize);
                    }
                }
                None => a.iter().zip(b).for_each(|(a, b)| self.add(a * b)),
            }
        }
    }

    /// Adds another sum.
    pub(crate) fn add_sum(&mut self, other: &Self) {
        self.digits
            .resize(self.digits.len().max(other.digits.len()), 0);
        for (digit, other) in self.digits.iter_mut().zip(&other.digits) {
            *digit += other;
        }
        self.other += &other.other;
        self.finite &= other.finite;
    }

    /// The sum, in 2^−1074.
    fn whole(&self) -> BigInt {
        let digits = self.digits.iter().rev();
        let own = digits.fold(BigInt::ZERO, |sum, digit| (sum << STRIDE) + digit);
        own + &self.other
    }

    /// The double nearest to the sum; NaN where a term was no finite number.
    pub(crate) fn value(&self) -> f64 {
        match self.finite {
            true => near(&BigRational::new(self.whole(), BigInt::from(1) << LEAST)),
            false => f64::NAN,
        }
    }

    /// The sum in 2^−1074 as digits; `None` where a term was no finite number.
    pub(crate) fn to_text(&self) -> Option<String> {
        self.finite.then(|| self.whole().to_string())
    }

    /// From what [`to_text`](Self::to_text) gives; `None` when it is no whole number.
    pub(crate) fn from_text(text: Option<&str>) -> Option<Self> {
        let other = match text {
            Some(text) => text.parse().ok()?,
            None => BigInt::ZERO,
        };
        Some(Self {
            other,
            finite: text.is_some(),
            ..Self::default()
        })
    }
}

/// As many terms as layers have room for.
const SHORT: usize = 4096;

/// Sums that are kept apart, so that processors add several numbers at once.
const LANES: usize = 8;

/// What the digits of each layer are multiples of, as powers of two: each has 38 bits more than the next. Most
/// numbers have no digits behind the first two.
const GRIDS: [[i32; 2]; 2] = [[-12, -50], [-88, -126]];

/// As many numbers as are looked at together.
const BLOCK: usize = 8 * LANES;

/// Below this, terms have room in the layers: 2^28.
const LARGEST: f64 = (1 << 28) as f64;

/// 2^k.
pub(super) const fn power(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// The sums of the digits of some numbers, by layer.
type Layers = [[[f64; LANES]; 2]; 2];

/// The sums of the digits of some products, by layer: exact, as a layer has at most 2^12 numbers below 2^40 of
/// its own grid, which makes 52 bits. `None` where a product is too large, or has digits behind the last layer.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn layers(a: &[f64], b: &[f64]) -> Option<Layers> {
    let mut sums = [[[0.0; LANES]; 2]; 2];
    // How large the products are, and the bits of what is behind the last layer.
    let (mut sizes, mut behind) = ([0.0; LANES], [0; LANES]);
    let ((whole_a, rest_a), (whole_b, rest_b)) = (a.as_chunks(), b.as_chunks());
    for (a, b) in whole_a.iter().zip(whole_b) {
        add_block([a, b], &mut sums, (&mut sizes, &mut behind));
    }
    if !rest_a.is_empty() {
        // What is not there adds nothing.
        let mut last = [[0.0; BLOCK]; 2];
        for (last, rest) in last.iter_mut().zip([rest_a, rest_b]) {
            for (x, y) in last.iter_mut().zip(rest) {
                *x = *y;
            }
        }
        add_block(last.each_ref(), &mut sums, (&mut sizes, &mut behind));
    }
    // What is no number is none in the sums.
    let numbers = sums.as_flattened().as_flattened();
    let open = sizes.iter().any(|size| *size >= LARGEST)
        | numbers.iter().any(|sum| sum.is_nan())
        | behind.iter().any(|bits| is_left(*bits));
    (!open).then_some(sums)
}

/// The sum of the lanes of a layer in units of its grid: less than 2^52 each.
#[allow(clippy::cast_possible_truncation)] // of whole numbers nothing is cut off
fn units(lanes: &[f64; LANES], grid: i32) -> i64 {
    lanes.iter().map(|sum| (sum * power(-grid)) as i64).sum()
}

/// Whether one of the numbers that these are all bits of is not zero.
#[inline(always)]
const fn is_left(bits: u64) -> bool {
    bits << 1 != 0
}

/// Adds the digits of a block of products.
#[inline(always)]
fn add_block(
    [a, b]: [&[f64; BLOCK]; 2],
    [first, second]: &mut Layers,
    (sizes, behind): (&mut [f64; LANES], &mut [u64; LANES]),
) {
    let mut rests = [[0.0; LANES]; BLOCK / LANES];
    let mut left = [0; LANES];
    let factors = a
        .as_chunks::<LANES>()
        .0
        .iter()
        .zip(b.as_chunks::<LANES>().0);
    for (rest, (a, b)) in rests.iter_mut().zip(factors) {
        for (((rest, size), a), b) in rest.iter_mut().zip(&mut *sizes).zip(a).zip(b) {
            *rest = a * b;
            *size = if rest.abs() > *size {
                rest.abs()
            } else {
                *size
            };
        }
        add_digits(first, GRIDS[0], rest, &mut left);
    }
    if left.iter().any(|bits| is_left(*bits)) {
        for rest in &mut rests {
            add_digits(second, GRIDS[1], rest, behind);
        }
    }
}

/// Adds the digits of some numbers to two layers, keeps what is left of the numbers and adds the bits of that.
#[inline(always)]
fn add_digits(
    sums: &mut [[f64; LANES]; 2],
    grids: [i32; 2],
    rest: &mut [f64; LANES],
    left: &mut [u64; LANES],
) {
    for (sums, grid) in sums.iter_mut().zip(grids) {
        // Adding it leaves no room for digits below the grid.
        let shift = 1.5 * power(52 + grid);
        for (rest, sum) in rest.iter_mut().zip(sums) {
            let digits = (*rest + shift) - shift;
            *rest -= digits;
            *sum += digits;
        }
    }
    for (left, rest) in left.iter_mut().zip(rest) {
        *left |= rest.to_bits();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_sum_is_exact_and_does_not_depend_on_its_order(
            terms in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL, 0..40),
            cut in 0..40_usize,
        ) {
            let terms: Vec<f64> = terms.into_iter().map(|x| x / 256.0).collect();
            let exact = |x: &f64| BigRational::from_float(*x).unwrap();
            let expected: BigRational = terms.iter().map(exact).sum();
            let mut whole = ExactSum::default();
            terms.iter().for_each(|x| whole.add(*x));
            let (mut first, mut second) = (ExactSum::default(), ExactSum::default());
            for (i, x) in terms.iter().enumerate().rev() {
                if i < cut { first.add(*x) } else { second.add(*x) }
            }
            let saved = second.to_text();
            first.add_sum(&ExactSum::from_text(saved.as_deref()).unwrap());
            prop_assert_eq!(whole.value().to_bits(), near(&expected).to_bits());
            prop_assert_eq!(first.to_text(), whole.to_text());
        }
    }

    proptest! {
        #[test]
        fn products_are_summed_up_as_their_terms_are(
            terms in prop::collection::vec((any::<i32>(), any::<i32>()), 0..40),
            scale in -60..20_i32,
            odd in prop::option::of((0..40_usize, prop::num::f64::ANY)),
        ) {
            let mut a: Vec<f64> = terms.iter().map(|(a, _)| f64::from(*a) / 3.0 * 2_f64.powi(scale)).collect();
            let b: Vec<f64> = terms.iter().map(|(_, b)| f64::from(*b) / 7e9).collect();
            if let Some((i, x)) = odd
                && let Some(slot) = a.get_mut(i)
            {
                *slot = x;
            }
            let (mut one, mut all) = (ExactSum::default(), ExactSum::default());
            a.iter().zip(&b).for_each(|(a, b)| one.add(a * b));
            all.add_products(&a, &b);
            prop_assert_eq!(one.to_text(), all.to_text());
        }
    }

    #[test]
    fn layers_have_room_for_the_largest_terms() {
        let largest = vec![LARGEST.next_down(); SHORT];
        let one = vec![1.0; SHORT];
        assert!(layers(&largest, &one).is_some());
        let (mut single, mut all) = (ExactSum::default(), ExactSum::default());
        largest.iter().for_each(|x| single.add(*x));
        all.add_products(&largest, &one);
        assert_eq!(single.to_text(), all.to_text());
        assert!(layers(&[LARGEST], &[1.0]).is_none());
        assert!(layers(&[1e-30], &[1e-30]).is_none());
    }

    #[test]
    fn what_is_no_number_spoils_the_sum() {
        let mut sum = ExactSum::default();
        sum.add(1.0);
        sum.add(f64::INFINITY);
        assert!(sum.value().is_nan());
        assert!(
            ExactSum::from_text(sum.to_text().as_deref())
                .unwrap()
                .value()
                .is_nan()
        );
    }
}
