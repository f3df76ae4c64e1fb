//! An account of 128 bits in two parts (TH-MONITOR): one of 64 bits, which samples change, and what is beside it.
//!
//! Both parts make it up, what is beside never lets an answer come late, and both sums go on with something beside them as
//! they do alone: over one tick ahead. That they do over any way is left to tests: it takes a solver too long.

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

/// Any account whose least at the upper end of the tick 128 bits hold.
fn any_account() -> Account<i128> {
    let (least, apart) = (any_number(), any_number());
    kani::assume(least.checked_add(apart).is_some());
    Account {
        most: any_number(),
        slope: any_number(),
        least,
        apart,
    }
}

/// TH-MONITOR: the most of an account of any numbers is what its parts make up.
#[kani::proof]
fn th_monitor_parts_make_up_the_most() {
    let account = Account {
        most: any_number(),
        slope: 0,
        least: 0,
        apart: 0,
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

/// TH-MONITOR: the least of an account of any numbers, at either end of the tick, is what its parts make up.
#[kani::proof]
fn th_monitor_parts_make_up_the_least() {
    let account = Account {
        most: 0,
        slope: 0,
        ..any_account()
    };
    let kept = i128::kept(account);
    kani::cover!(kept.is_parted && kept.steps != 0, "both parts are used");
    kani::cover!(!kept.is_parted, "64 bits are enough");
    let whole = i128::whole(&kept);
    kani::assert(
        whole.least == account.least && whole.apart == account.apart,
        "TH-MONITOR: the parts of an account make it up",
    );
}

/// TH-MONITOR: where the most, or the least at either end of the tick, is not above zero, what is beside it in 128 bits is
/// not either.
#[kani::proof]
fn th_monitor_nothing_is_beside_what_can_turn_an_answer() {
    let account = any_account();
    let (lower, upper) = (account.least, account.least + account.apart);
    let kept = i128::kept(account);
    kani::assume(kept.steps != 0);
    let beside = kept.beside.least;
    kani::cover!(kept.beside.most < 0 && beside < 0, "something is beside it");
    kani::assert(
        account.most > 0 || kept.beside.most <= 0,
        "TH-MONITOR: beside a most that is not above zero is nothing above zero",
    );
    kani::assert(
        kept.beside.apart == 0 && (lower > 0 && upper > 0 || beside <= 0),
        "TH-MONITOR: beside a least that is not above zero is nothing above zero",
    );
}

/// Any account of 64 bits with such a slope whose least at the upper end of the tick fits too.
fn any_steep() -> Account<i64> {
    let (least, apart) = (kani::any::<i64>(), kani::any());
    kani::assume(least.checked_add(apart).is_some());
    Account {
        most: kani::any(),
        slope: kani::any_where(|n: &i16| *n >= -SLOPE && *n <= SLOPE).into(),
        least,
        apart,
    }
}

/// TH-MONITOR: where nothing above zero is beside an account of 64 bits, that answers no later than both do together.
#[kani::proof]
fn th_monitor_parts_answer_no_later_than_the_account() {
    let not_positive = || kani::any_where(|n: &i64| *n <= 0);
    let account = any_steep();
    let kept = Kept::<i128> {
        account,
        beside: Account {
            most: i128::from(not_positive()),
            slope: 0,
            least: i128::from(not_positive()),
            apart: 0,
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

/// An account of 64 bits, and the same with a number beside it, over one tick ahead under any small force: each as it is
/// then, if it fits.
fn go_on(account: Account<i64>, beside: Account<i128>) -> [Option<Account<i128>>; 2] {
    let mut kept = Kept::<i128> {
        account,
        beside,
        is_parted: true,
        steps: 3,
    };
    let mut whole = i128::whole(&kept);
    let force = i64::from(kani::any::<i8>());
    let goes_on = kept.account.advance(&ORDINARY, force, 1);
    let whole_goes_on = whole.advance(&ORDINARY, force.into(), 1);
    [
        goes_on.map(|()| i128::whole(&kept)),
        whole_goes_on.map(|()| whole),
    ]
}

/// A number up to 2¹²⁴ in magnitude.
fn any_beside() -> i128 {
    let beside = any_number();
    kani::assume(beside.unsigned_abs() <= 1 << 124);
    beside
}

const NOTHING: Account<i128> = Account {
    most: 0,
    slope: 0,
    least: 0,
    apart: 0,
};

/// TH-MONITOR: over one tick ahead, the most of 64 bits and the number beside it are what the most of both is after that.
#[kani::proof]
fn th_monitor_parts_go_on_as_the_most_does() {
    let account = Account {
        most: kani::any(),
        slope: kani::any_where(|n: &i16| *n >= -SLOPE && *n <= SLOPE).into(),
        least: 0,
        apart: 0,
    };
    let most = any_beside();
    let [parts, whole] = go_on(account, Account { most, ..NOTHING });
    kani::cover!(parts.is_some(), "it goes on in 64 bits");
    kani::assert(
        parts.is_none() || parts == whole,
        "TH-MONITOR: the most goes on beside a number as it does alone",
    );
}

/// TH-MONITOR: over one tick ahead, the least of 64 bits and the number beside it are what the least of both is after that.
#[kani::proof]
fn th_monitor_parts_go_on_as_the_least_does() {
    let account = Account {
        most: 0,
        slope: 0,
        least: kani::any(),
        apart: kani::any::<i16>().into(),
    };
    let least = any_beside();
    let [parts, whole] = go_on(account, Account { least, ..NOTHING });
    kani::cover!(parts.is_some(), "it goes on in 64 bits");
    kani::assert(
        parts.is_none() || parts == whole,
        "TH-MONITOR: the least goes on beside a number as it does alone",
    );
}
