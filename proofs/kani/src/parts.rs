//! An account of 128 bits in two parts (TH-MONITOR): one of 64 bits, which samples change, and what is beside it.
//!
//! Both parts make it up, and what is beside never lets an answer come late; the most goes on with something beside it as it
//! does alone. That the least does too, and over any way, is left to tests: it takes a solver too long.

use passivity_monitor::account::Account;
use passivity_monitor::kept::{Keep, Kept};

use crate::monitor::ORDINARY;

/// Slopes past both ends of where the answer asks for their square.
const SLOPE: i16 = 3000;

/// Any number of 128 bits.
fn any_number() -> i128 {
    let (upper, lower) = (kani::any::<i64>(), kani::any::<u64>());
    (i128::from(upper) << 64) | i128::from(lower)
}

/// Any account whose two leasts are not further apart than 128 bits hold.
fn any_account() -> Account<i128> {
    let (lower, apart) = (any_number(), any_number());
    let upper = lower.checked_add(apart);
    kani::assume(upper.is_some());
    Account {
        most: any_number(),
        slope: any_number(),
        least: [lower, upper.unwrap_or(lower)],
    }
}

/// TH-MONITOR: the most of an account of any numbers is what its parts make up.
#[kani::proof]
fn th_monitor_parts_make_up_the_most() {
    let account = Account {
        most: any_number(),
        slope: 0,
        least: [0; 2],
    };
    let kept = i128::kept(account);
    kani::cover!(kept.is_parted && kept.steps != 0, "both parts are used");
    kani::cover!(!kept.is_parted, "64 bits are enough");
    kani::cover!(kept.steps == 0, "it does not go on in 64 bits");
    kani::assert(
        i128::whole(&kept).most == account.most,
        "TH-MONITOR: the parts of an account make it up",
    );
}

/// TH-MONITOR: the least at the lower end of the tick is what its parts make up; and in 64 bits that at the upper end is as
/// far from it as it was, so that with the same number beside both it is what its parts make up too.
#[kani::proof]
fn th_monitor_parts_make_up_the_least() {
    let account = Account {
        most: 0,
        slope: 0,
        ..any_account()
    };
    let [lower, upper] = account.least;
    let kept = i128::kept(account);
    kani::cover!(kept.is_parted && kept.steps != 0, "both parts are used");
    kani::cover!(!kept.is_parted, "64 bits are enough");
    let ([now, other], beside) = (kept.account.least, kept.beside.least);
    kani::assert(
        i128::whole(&kept).least[0] == lower,
        "TH-MONITOR: the parts of an account make it up",
    );
    kani::assert(
        kept.steps == 0
            || i128::from(other) - i128::from(now) == upper - lower && beside[0] == beside[1],
        "TH-MONITOR: the least at both ends is as far apart in 64 bits",
    );
}

/// TH-MONITOR: where the most, or the least at either end of the tick, is not above zero, what is beside it in 128 bits is
/// not either.
#[kani::proof]
fn th_monitor_nothing_is_beside_what_can_turn_an_answer() {
    let account = any_account();
    let [lower, upper] = account.least;
    let kept = i128::kept(account);
    kani::assume(kept.steps != 0);
    let [beside, other] = kept.beside.least;
    kani::cover!(kept.beside.most < 0 && beside < 0, "something is beside it");
    kani::assert(
        account.most > 0 || kept.beside.most <= 0,
        "TH-MONITOR: beside a most that is not above zero is nothing above zero",
    );
    kani::assert(
        beside == other && (lower > 0 && upper > 0 || beside <= 0),
        "TH-MONITOR: beside a least that is not above zero is nothing above zero",
    );
}

/// TH-MONITOR: where nothing above zero is beside an account of 64 bits, that answers no later than both do together.
#[kani::proof]
fn th_monitor_parts_answer_no_later_than_the_account() {
    let not_positive = || kani::any_where(|n: &i64| *n <= 0);
    let account = Account::<i64> {
        most: kani::any(),
        slope: kani::any_where(|n: &i16| *n >= -SLOPE && *n <= SLOPE).into(),
        least: [kani::any(), kani::any()],
    };
    let beside = i128::from(not_positive());
    let kept = Kept::<i128> {
        account,
        beside: Account {
            most: i128::from(not_positive()),
            slope: 0,
            least: [beside; 2],
        },
        is_parted: true,
        steps: 1,
    };
    let whole = i128::whole(&kept);
    kani::cover!(whole.may_be_positive(&ORDINARY), "the answer is open");
    kani::cover!(whole.at_least() > 0, "it is surely active");
    kani::assert(
        account.may_be_positive(&ORDINARY) || !whole.may_be_positive(&ORDINARY),
        "TH-MONITOR: what 64 bits leave surely passive is that",
    );
    kani::assert(
        account.at_least() > 0 || whole.at_least() <= 0,
        "TH-MONITOR: what is surely active is so in 64 bits",
    );
}

/// TH-MONITOR: over one tick ahead, the most of 64 bits and the number beside it are what the most of both is after that.
#[kani::proof]
fn th_monitor_parts_go_on_as_the_most_does() {
    let beside = any_number();
    kani::assume(beside.unsigned_abs() <= 1 << 124);
    let mut kept = Kept::<i128> {
        account: Account {
            most: kani::any(),
            slope: kani::any_where(|n: &i16| *n >= -SLOPE && *n <= SLOPE).into(),
            least: [0; 2],
        },
        beside: Account {
            most: beside,
            slope: 0,
            least: [0; 2],
        },
        is_parted: true,
        steps: 3,
    };
    let mut whole = i128::whole(&kept);
    let force = i64::from(kani::any::<i8>());
    let goes_on = kept.account.advance(&ORDINARY, force, 1).is_some();
    let whole_goes_on = whole.advance(&ORDINARY, force.into(), 1).is_some();
    kani::cover!(goes_on, "it goes on in 64 bits");
    kani::assert(
        !goes_on
            || whole_goes_on
                && whole.most == beside + i128::from(kept.account.most)
                && whole.slope == kept.account.slope.into(),
        "TH-MONITOR: the most goes on beside a number as it does alone",
    );
}
