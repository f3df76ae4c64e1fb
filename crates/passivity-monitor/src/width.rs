//! The integers that energies are summed in.

use crate::kept::Keep;

/// The largest parameter of a [`Config`](crate::Config), for either width: 2³⁰.
pub const PARAMETER_MAX: i64 = 1 << 30;

/// An integer that a [`Monitor`](crate::Monitor) sums energies in: `i64` or `i128`.
///
/// Its inputs are such that what one sample adds never overflows; the sums over many are checked.
pub trait Width: Copy + Ord + core::fmt::Debug + Keep {
    /// Counts and forces: `i32` for sums of 64 bits, `i64` for sums of 128.
    type Input: Copy + Ord + core::fmt::Debug + Into<Self> + Into<i64>;
    /// Zero.
    const ZERO: Self;
    /// No count, and no force.
    const NO_INPUT: Self::Input;
    /// The most ticks that the count may change by from one sample to the next.
    const STEP_MAX: i64;
    /// The largest force, in magnitude, that an [`Account`](crate::account::Account) goes on by. With 64 bits that is
    /// more than an input can be: those of 128-bit sums go on in 64 bits too, where they are small.
    const FORCE_MAX: Self;

    /// The same number.
    #[must_use]
    fn from_i64(n: i64) -> Self;

    /// The same number, which is not below zero: nothing is spent on its sign.
    #[must_use]
    fn of_size(n: i64) -> Self;

    /// The same number, where the inputs are such that it fits in 64 bits.
    #[must_use]
    fn low(self) -> i64;

    /// The sum, where the inputs are such that it fits.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// The difference, where the inputs are such that it fits.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// The product, where the inputs are such that it fits.
    #[must_use]
    fn times(self, other: Self) -> Self;

    /// The product of two numbers of 64 bits, where the inputs are such that it fits.
    #[must_use]
    fn product(a: i64, b: i64) -> Self;

    /// The sum; `None` when it does not fit.
    #[must_use]
    fn checked_plus(self, other: Self) -> Option<Self>;

    /// The product; `None` when it does not fit.
    #[must_use]
    fn checked_times(self, other: Self) -> Option<Self>;

    /// The quotient of two numbers above zero, rounded up; `None` for a divisor of zero.
    #[must_use]
    fn over_rounded_up(self, divisor: Self) -> Option<Self>;

    /// Whether the number is from zero to below another, which is not below zero: by one comparison.
    #[must_use]
    fn is_below(self, other: Self) -> bool;

    /// Whether the number is at least −`least`, and below `numbers` − `least`: by one comparison. Neither is below
    /// zero.
    #[must_use]
    fn is_within(self, least: Self, numbers: Self) -> bool;

    /// How far apart two counts are, in ticks; `None` of more than 64 bits, which is past any step.
    #[must_use]
    fn ticks(from: Self::Input, to: Self::Input) -> Option<i64>;

    /// The number as an index; `None` of one below zero.
    #[must_use]
    fn index(self) -> Option<usize>;

    /// −1 for a number below zero, else 0.
    #[must_use]
    fn sign_mask(self) -> Self;

    /// The number with another sign where the mask is −1.
    #[must_use]
    fn signed_by(self, mask: Self) -> Self;
}

macro_rules! width {
    ($int:ty, $unsigned:ty, $input:ty, $step:expr, $force:expr) => {
        impl Width for $int {
            type Input = $input;
            const ZERO: Self = 0;
            const NO_INPUT: $input = 0;
            const STEP_MAX: i64 = $step;
            const FORCE_MAX: Self = $force;

            #[inline]
            fn from_i64(n: i64) -> Self {
                n.into()
            }

            #[inline]
            fn of_size(n: i64) -> Self {
                debug_assert!(n >= 0);
                n as u64 as $int
            }

            #[inline]
            fn low(self) -> i64 {
                debug_assert!(i64::try_from(self).is_ok());
                self as i64
            }

            // A build that checks, such as that of the proofs, looks whether the result fits, as it
            // always does; in any other nothing is left that could panic.
            #[inline]
            fn plus(self, other: Self) -> Self {
                debug_assert!(self.checked_add(other).is_some());
                self.wrapping_add(other)
            }

            #[inline]
            fn minus(self, other: Self) -> Self {
                debug_assert!(self.checked_sub(other).is_some());
                self.wrapping_sub(other)
            }

            #[inline]
            fn times(self, other: Self) -> Self {
                debug_assert!(self.checked_mul(other).is_some());
                self.wrapping_mul(other)
            }

            #[inline]
            fn product(a: i64, b: i64) -> Self {
                Self::from(a).times(b.into())
            }

            #[inline]
            fn checked_plus(self, other: Self) -> Option<Self> {
                self.checked_add(other)
            }

            #[inline]
            fn checked_times(self, other: Self) -> Option<Self> {
                self.checked_mul(other)
            }

            #[inline]
            fn over_rounded_up(self, divisor: Self) -> Option<Self> {
                // (a − 1)/b + 1 fits where a + b − 1 might not.
                Some(self.minus(1).checked_div(divisor)?.plus(1))
            }

            #[inline]
            fn is_below(self, other: Self) -> bool {
                debug_assert!(other >= 0);
                // Without a sign, numbers below zero come after all others.
                (self as $unsigned) < other as $unsigned
            }

            #[inline]
            fn is_within(self, least: Self, numbers: Self) -> bool {
                debug_assert!(least >= 0);
                // One that is too large wraps to below zero.
                self.wrapping_add(least).is_below(numbers)
            }

            #[inline]
            fn ticks(from: $input, to: $input) -> Option<i64> {
                to.checked_sub(from).map(i64::from)
            }

            #[inline]
            fn index(self) -> Option<usize> {
                Self::try_into(self).ok()
            }

            #[inline]
            fn sign_mask(self) -> Self {
                self >> (<$int>::BITS - 1)
            }

            #[inline]
            fn signed_by(self, mask: Self) -> Self {
                (self ^ mask).minus(mask)
            }
        }
    };
}

width!(i64, u64, i32, (1 << 15) - 1, 1 << 44);
width!(i128, u128, i64, (1 << 31) - 1, 1 << 63);

/// The largest that one sample adds, of inputs at their limits: the magnitudes of all terms of
/// [`Account::advance`](crate::account::Account::advance) together.
///
/// With P the largest parameter, F the largest force and D the largest step, one tick more for
/// what is within the ticks: friction takes up to 2P·D² + 2P·D, the wall's spring P·D² + 2P·D, and
/// the force gives 2F·D.
///
/// On top comes what a new force adds to the most, up to 2⁶² after a start far from zero. Both together
/// fit: a step adds no more than 2F·D + 4P·D, as the rest of its terms are below zero. From the least comes as much
/// where it is far apart at the ends of the tick. The harnesses of `proofs/kani` have each at its largest.
const fn largest_term(step: i64, force: u128) -> u128 {
    let (p, d) = (
        PARAMETER_MAX.unsigned_abs() as u128,
        step.unsigned_abs() as u128 + 1,
    );
    3 * p * d * d + 4 * p * d + 2 * force * d
}

// What the arithmetic without checks relies on.
const _: () = assert!(largest_term(i64::STEP_MAX, i64::FORCE_MAX.unsigned_abs() as u128) < 1 << 63);
const _: () = assert!(largest_term(i128::STEP_MAX, i128::FORCE_MAX.unsigned_abs()) < 1 << 127);
