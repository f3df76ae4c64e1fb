//! How a monitor keeps its account: one of 64 bits, which samples change, and what is beside it.
//!
//! Sums of 128 bits change by little from sample to sample. So each is kept as a number of 64 bits and
//! another one beside it, which stays as it is until the first does not fit, or a sample is too much for
//! 64 bits. Then the account in 128 bits, which is their sum, goes on, and is parted again.

use core::fmt::Debug;

use crate::account::Account;
use crate::width::Width;

/// An account in its parts.
#[derive(Clone, Copy, Debug)]
pub struct Kept<W: Keep> {
    /// The one of 64 bits.
    pub account: Account<i64>,
    /// What is added to each of its numbers.
    pub beside: W::Beside,
    /// Whether that is anything.
    pub is_parted: bool,
    /// How many different steps the account of 64 bits goes on by: those up to its longest either way, or none.
    pub steps: i64,
}

const STEPS: i64 = 2 * i64::STEP_MAX + 1;

/// An integer of the whole account.
pub trait Keep: Copy + Debug {
    /// What can be beside the account of 64 bits.
    type Beside: Copy + Debug;
    /// Whether anything can.
    const IS_WIDE: bool;

    /// An account in its parts.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_monitor::account::Account;
    /// use passivity_monitor::kept::Keep;
    ///
    /// let account = Account { most: -1_i128 << 80, slope: 5, least: 7, apart: 2 };
    /// let kept = i128::kept(account);
    /// assert_eq!(kept.account.most, -1 << 62);
    /// assert_eq!(i128::whole(&kept), account);
    /// ```
    #[must_use]
    fn kept(whole: Account<Self>) -> Kept<Self>;

    /// The account of these parts.
    #[must_use]
    fn whole(kept: &Kept<Self>) -> Account<Self>;
}

impl Keep for i64 {
    type Beside = ();
    const IS_WIDE: bool = false;

    #[inline]
    fn kept(whole: Account<Self>) -> Kept<Self> {
        Kept {
            account: whole,
            beside: (),
            is_parted: false,
            steps: STEPS,
        }
    }

    #[inline]
    fn whole(kept: &Kept<Self>) -> Account<Self> {
        kept.account
    }
}

impl Keep for i128 {
    type Beside = Account<Self>;
    const IS_WIDE: bool = true;

    /// A small sum is all in the account of 64 bits. Of any other the account has −2⁶², halfway to its end, and the rest
    /// is beside it. Where a sum is not above zero, neither is that rest; nor is that of the least, where it is not above
    /// zero at the upper end of the tick only.
    #[inline]
    fn kept(whole: Account<Self>) -> Kept<Self> {
        let is_up_to = |n: Self, most: Self| n.is_within(most, most.plus(most));
        let goes_on = is_up_to(whole.most, SUM_MAX)
            && is_up_to(whole.least, SUM_MAX)
            && is_up_to(whole.slope, PART_MAX)
            && is_up_to(whole.apart, PART_MAX);
        if !goes_on {
            return Kept {
                account: NOTHING,
                beside: whole,
                is_parted: true,
                steps: 0,
            };
        }
        let rest = |sum: Self| match is_up_to(sum, PART_MAX) {
            true => 0,
            false => sum.plus(PART_MAX),
        };
        let (most, least) = (rest(whole.most), rest(whole.least));
        Kept {
            account: Account {
                most: whole.most.minus(most).low(),
                slope: whole.slope.low(),
                least: whole.least.minus(least).low(),
                apart: whole.apart.low(),
            },
            beside: Account {
                most,
                slope: 0,
                least,
                apart: 0,
            },
            is_parted: most != 0 || least != 0,
            steps: STEPS,
        }
    }

    #[inline]
    fn whole(kept: &Kept<Self>) -> Account<Self> {
        let sum = |low: i64, beside: Self| beside.plus(low.into());
        let (account, beside) = (&kept.account, &kept.beside);
        Account {
            most: sum(account.most, beside.most),
            slope: sum(account.slope, beside.slope),
            least: sum(account.least, beside.least),
            apart: sum(account.apart, beside.apart),
        }
    }
}

const NOTHING: Account<i64> = Account {
    most: 0,
    slope: 0,
    least: 0,
    apart: 0,
};

/// Sums up to this leave room for any change of the 64 bits.
const SUM_MAX: i128 = 1 << 125;

/// An account of 64 bits takes numbers up to this, which leaves room for what samples add.
const PART_MAX: i128 = 1 << 62;
