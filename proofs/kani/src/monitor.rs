//! The account in the loop: one sample after any other, so that it holds after any number of them.
//!
//! What is assumed of the account before a sample is what is shown of it after. All is in whole
//! numbers; positions within a tick are quarters of it, so energies are compared in sixteenths.

use passivity_monitor::account::{Account, given, net};
use passivity_monitor::{Answer, Config, ConfigError, Monitor, PARAMETER_MAX, Parameter, Width};

/// Parameters below this: what friction takes is less than, equal to and more than half of the
/// stiffness, in each combination.
const SMALL: u8 = 6;

/// Forces up to this in magnitude: several times that of the spring at a tick.
const FORCE: i8 = 8;

/// Ticks crossed: none, one, several, in both directions.
const TICKS: i8 = 4;

/// Ticks crossed where only net energy is looked at: some past those that are tabulated.
const MANY_TICKS: u8 = 24;

/// Differences of energy from which a sample starts.
const ENERGY: i8 = 16;

fn parameter(limit: u8) -> i64 {
    i64::from(kani::any_where(|n: &u8| *n < limit))
}

fn up_to(limit: i8) -> i64 {
    i64::from(kani::any_where(|n: &i8| *n >= -limit && *n <= limit))
}

/// Quarters of a tick, both ends included.
fn quarters() -> i64 {
    i64::from(kani::any_where(|n: &u8| *n <= 4))
}

/// A configuration that is in range.
fn configured(stiffness: i64, viscous: i64, coulomb: i64) -> Config {
    let config = Config::new(stiffness, viscous, coulomb);
    kani::assume(config.is_ok());
    match config {
        Ok(config) => config,
        Err(_) => unreachable!(),
    }
}

fn advanced(mut account: Account<i64>, config: &Config, force: i64, ticks: i64) -> Account<i64> {
    let fits = account.advance(config, force, ticks);
    kani::assert(
        fits.is_some(),
        "TH-MONITOR: an account of small numbers fits",
    );
    account
}

/// Sixteen times what is given over q quarters of a tick, by the definition.
fn given_in_sixteenths(config: &Config, force: i64, q: i64) -> i64 {
    8 * force * q - 2 * config.viscous() * q * q - 8 * config.coulomb() * q.abs()
}

/// TH-MONITOR: wherever within the ticks a sample and the next one were, what was given is at most
/// what the account says, if it was before.
#[kani::proof]
fn th_monitor_most_bounds_every_motion() {
    let config = configured(parameter(SMALL), parameter(4), parameter(4));
    let (force, ticks, slope) = (up_to(FORCE), up_to(TICKS), up_to(ENERGY));
    let (from, to) = (quarters(), quarters());
    let before = Account {
        most: 0,
        slope,
        least: 0,
        apart: 0,
    };
    let after = advanced(before, &config, force, ticks);
    let bound = |account: &Account<i64>, r: i64| {
        16 * account.most + 4 * account.slope * r - config.stiffness() * r * r
    };
    let q = 4 * ticks + to - from;
    let now = bound(&before, from) + given_in_sixteenths(&config, force, q);
    kani::cover!(now == bound(&after, to), "the bound is reached");
    kani::assert(
        now <= bound(&after, to),
        "TH-MONITOR: no motion with these counts gives more than the most",
    );
}

/// TH-MONITOR: the same from below: what was given is at least what the account says, in between
/// the ends of the tick what lies on the straight line.
#[kani::proof]
fn th_monitor_least_bounds_every_motion() {
    let config = configured(0, parameter(4), parameter(4));
    let (force, ticks, rise) = (up_to(FORCE), up_to(TICKS), up_to(ENERGY));
    let (from, to) = (quarters(), quarters());
    let before = Account {
        most: 0,
        slope: 0,
        least: 0,
        apart: rise,
    };
    let after = advanced(before, &config, force, ticks);
    let bound = |account: &Account<i64>, r: i64| 4 * (4 * account.least + account.apart * r);
    let q = 4 * ticks + to - from;
    let now = bound(&before, from) + given_in_sixteenths(&config, force, q);
    kani::cover!(now == bound(&after, to), "the bound is reached");
    kani::assert(
        now >= bound(&after, to),
        "TH-MONITOR: no motion with these counts gives less than the least",
    );
}

/// TH-MONITOR: the least is what some motion between ends of ticks gives: it is told when more was given
/// at one and the same sample, wherever the positions were.
#[kani::proof]
fn th_monitor_least_is_reached() {
    let config = configured(0, parameter(4), parameter(4));
    let (force, ticks, rise) = (up_to(FORCE), up_to(TICKS), up_to(ENERGY));
    let to = i64::from(kani::any_where(|n: &u8| *n <= 1));
    let before = Account {
        most: 0,
        slope: 0,
        least: 0,
        apart: rise,
    };
    let after = advanced(before, &config, force, ticks);
    let least = after.least + after.apart * to;
    let from_lower = given(&config, force, ticks + to);
    let from_upper = rise + given(&config, force, ticks + to - 1);
    kani::cover!(from_upper < from_lower, "it came from the upper end");
    kani::assert(
        least == from_lower.min(from_upper),
        "TH-MONITOR: the least is that of a motion",
    );
}

/// TH-MONITOR: net energy against the wall's spring is nowhere within the ticks less than the least,
/// in intervals short and long.
#[kani::proof]
fn th_monitor_net_is_least() {
    let config = configured(parameter(8), parameter(SMALL), parameter(SMALL));
    let ticks = i64::from(kani::any_where(|n: &u8| *n < MANY_TICKS));
    let (from, to) = (quarters(), quarters());
    let (stiffness, q) = (config.stiffness(), 4 * ticks + to - from);
    let taken = 2 * config.viscous() * q * q + 8 * config.coulomb() * q.abs();
    // Twice ½d² + (ρ₀ − ½)d of stiffness, in sixteenths.
    let generated = stiffness * (q * q + 2 * (from - 2) * q);
    let least: i64 = net(&config, ticks);
    kani::cover!(
        taken - generated == 16 * least && ticks > 16,
        "it is reached by a long interval"
    );
    kani::assert(
        taken - generated >= 16 * least,
        "TH-MONITOR: no positions within the ticks have less net energy",
    );
}

/// TH-MONITOR: under the wall's own force, with b ≥ KT/2 and c ≥ KΔ/2, nothing is ever given beyond what
/// the spring gives up.
#[kani::proof]
fn th_monitor_passive_wall_stays_passive() {
    let half = i64::from(kani::any_where(|n: &u8| *n >= 1 && *n < SMALL));
    let config = configured(2 * half, half + parameter(3), half + parameter(3));
    let count = up_to(8);
    let ticks = up_to(20);
    let stored = |n: i64| 2 * half * n * n;
    let before = Account {
        most: -stored(count),
        slope: -4 * half * count,
        least: 0,
        apart: 0,
    };
    let own = -half * (2 * count + 1);
    let after = advanced(before, &config, own, ticks);
    kani::cover!(
        after.most == -stored(count + ticks) && ticks != 0,
        "all of it is given up"
    );
    kani::assert(
        after.most <= -stored(count + ticks)
            && after.slope == -4 * half * (count + ticks)
            && !after.may_be_positive(&config),
        "TH-MONITOR: a passive wall is surely passive",
    );
}

/// TH-MONITOR: *surely passive* is answered exactly where the most is not above zero.
#[kani::proof]
fn th_monitor_is_passive_where_the_most_is_not_positive() {
    let config = configured(parameter(16), 0, 0);
    let account = Account {
        most: up_to(64),
        slope: up_to(64),
        least: 0,
        apart: 0,
    };
    let most = account.at_most(&config);
    kani::cover!(
        most == Some(0) && account.slope > 0 && account.slope < 2 * config.stiffness(),
        "just passive within the tick"
    );
    kani::assert(
        most.is_some_and(|most| (most > 0) == account.may_be_positive(&config)),
        "TH-MONITOR: the answer is that of the bound",
    );
}

/// TH-MONITOR: the counts alone, as the passivity observer takes them, are no bound: between the ticks
/// more may be given.
#[kani::proof]
#[kani::should_panic]
fn th_monitor_counts_alone_are_no_bound() {
    let config = configured(0, parameter(4), parameter(4));
    let (force, ticks) = (up_to(FORCE), up_to(TICKS));
    let (from, to) = (quarters(), quarters());
    let q = 4 * ticks + to - from;
    kani::cover!(q > 4 * ticks, "it went further than the counts");
    kani::assert(
        given_in_sixteenths(&config, force, q) <= 16 * given(&config, force, ticks),
        "TH-MONITOR: no more is given than the counts alone say",
    );
}

/// TH-MONITOR: a configuration of any numbers of which one is out of range is refused, and says which.
#[kani::proof]
fn th_monitor_refuses_what_is_out_of_range() {
    let numbers: [i64; 3] = [kani::any(), kani::any(), kani::any()];
    let out_of_range = numbers.map(|n| !(0..=PARAMETER_MAX).contains(&n));
    kani::assume(out_of_range.contains(&true));
    let [stiffness, viscous, coulomb] = numbers;
    let refused = Config::new(stiffness, viscous, coulomb);
    let first = match out_of_range {
        [true, ..] => Parameter::Stiffness,
        [false, true, _] => Parameter::Viscous,
        [false, false, _] => Parameter::Coulomb,
    };
    let monitor = Monitor::<i64>::start(ORDINARY, 0, 0);
    kani::cover!(coulomb > PARAMETER_MAX, "it is too large");
    kani::assert(
        refused == Err(ConfigError::OutOfRange(first)) && monitor.answer() == Answer::SurelyPassive,
        "TH-MONITOR: what is out of range is refused",
    );
}

/// TH-MONITOR: at the start nothing has been given that was not stored.
#[kani::proof]
fn th_monitor_starts_with_nothing_given() {
    let config = configured(parameter(16), parameter(4), parameter(4));
    let count = up_to(16);
    let account = Account::<i64>::start(&config, count);
    let stored = |n: i64| config.stiffness() * n * n;
    let [near, far] = match count >= 0 {
        true => [count, count + 1],
        false => [count + 1, count],
    };
    let bounds = account.map(|account| (account.at_least(), account.at_most(&config)));
    kani::cover!(count < -1, "it starts on the other side");
    kani::assert(
        bounds == Some((-stored(far), Some(-stored(near)))),
        "TH-MONITOR: a start is passive",
    );
}

/// Parameters that are as large as they may be, and small ones: what one sample adds is largest where
/// each is, or is not, there.
const LARGEST: Config = at(PARAMETER_MAX, PARAMETER_MAX, PARAMETER_MAX);
const NO_FRICTION: Config = at(PARAMETER_MAX, 0, 0);
const NO_SPRING: Config = at(0, PARAMETER_MAX, PARAMETER_MAX);
pub(crate) const ORDINARY: Config = at(1000, 650, 300);

const fn at(stiffness: i64, viscous: i64, coulomb: i64) -> Config {
    match Config::new(stiffness, viscous, coulomb) {
        Ok(config) => config,
        Err(_) => panic!("in range"),
    }
}

/// Advances an account of any numbers, the slope and the leasts as far as a start can lead, by any force and a step:
/// what it is then, if it fits, and how it slopes by the definition, in wider integers. The step is a
/// number that the compiler knows, so that nothing is left to multiply but by numbers.
fn advances(config: &Config, ticks: i64) -> (Option<Account<i64>>, i128) {
    let force = kani::any_where(|n: &i64| *n >= -i64::FORCE_MAX && *n <= i64::FORCE_MAX);
    let far = || kani::any_where(|far: &i64| *far >= -(1 << 62) && *far <= 1 << 62);
    let mut account = Account {
        most: kani::any(),
        slope: far(),
        least: kani::any(),
        apart: far(),
    };
    let fits = account.advance(config, force, ticks);
    let stiffness = i128::from(config.stiffness());
    let slope = stiffness + 2 * i128::from(force) - 2 * stiffness * i128::from(ticks);
    (fits.map(|()| account), slope)
}

/// Whether it slopes so, and its leasts at both ends of the tick fit.
fn slopes(account: &Account<i64>, slope: i128) -> bool {
    i128::from(account.slope) == slope && account.at_least() <= account.least
}

/// TH-MONITOR: with the largest parameters, the longest step forward after any samples makes no account panic or wrap.
#[kani::proof]
fn th_monitor_never_wraps_with_the_largest_parameters_forward() {
    let (account, slope) = advances(&LARGEST, i64::STEP_MAX);
    kani::cover!(account.is_some(), "it fits");
    kani::cover!(account.is_none(), "it does not fit");
    kani::assert(
        account.is_none_or(|account| slopes(&account, slope)),
        "TH-MONITOR: an account that fits slopes by the definition, and its leasts fit",
    );
}

/// TH-MONITOR: with the largest parameters, the longest step back after any samples makes no account panic or wrap.
#[kani::proof]
fn th_monitor_never_wraps_with_the_largest_parameters_back() {
    let (account, slope) = advances(&LARGEST, -i64::STEP_MAX);
    kani::cover!(account.is_some(), "it fits");
    kani::cover!(account.is_none(), "it does not fit");
    kani::assert(
        account.is_none_or(|account| slopes(&account, slope)),
        "TH-MONITOR: an account that fits slopes by the definition, and its leasts fit",
    );
}

/// TH-MONITOR: with the stiffest spring and no friction, the longest step forward after any samples makes no account panic or wrap.
#[kani::proof]
fn th_monitor_never_wraps_without_friction_forward() {
    let (account, slope) = advances(&NO_FRICTION, i64::STEP_MAX);
    kani::cover!(account.is_some(), "it fits");
    kani::cover!(account.is_none(), "it does not fit");
    kani::assert(
        account.is_none_or(|account| slopes(&account, slope)),
        "TH-MONITOR: an account that fits slopes by the definition, and its leasts fit",
    );
}

/// TH-MONITOR: with the stiffest spring and no friction, the longest step back after any samples makes no account panic or wrap.
#[kani::proof]
fn th_monitor_never_wraps_without_friction_back() {
    let (account, slope) = advances(&NO_FRICTION, -i64::STEP_MAX);
    kani::cover!(account.is_some(), "it fits");
    kani::cover!(account.is_none(), "it does not fit");
    kani::assert(
        account.is_none_or(|account| slopes(&account, slope)),
        "TH-MONITOR: an account that fits slopes by the definition, and its leasts fit",
    );
}

/// TH-MONITOR: with the most friction and no spring, the longest step forward after any samples makes no account panic or wrap.
#[kani::proof]
fn th_monitor_never_wraps_without_a_spring_forward() {
    let (account, slope) = advances(&NO_SPRING, i64::STEP_MAX);
    kani::cover!(account.is_some(), "it fits");
    kani::cover!(account.is_none(), "it does not fit");
    kani::assert(
        account.is_none_or(|account| slopes(&account, slope)),
        "TH-MONITOR: an account that fits slopes by the definition, and its leasts fit",
    );
}

/// TH-MONITOR: with the most friction and no spring, the longest step back after any samples makes no account panic or wrap.
#[kani::proof]
fn th_monitor_never_wraps_without_a_spring_back() {
    let (account, slope) = advances(&NO_SPRING, -i64::STEP_MAX);
    kani::cover!(account.is_some(), "it fits");
    kani::cover!(account.is_none(), "it does not fit");
    kani::assert(
        account.is_none_or(|account| slopes(&account, slope)),
        "TH-MONITOR: an account that fits slopes by the definition, and its leasts fit",
    );
}

/// A count one tick further, back, the same, or where none can be.
fn next(count: i32) -> i32 {
    match kani::any_where(|n: &u8| *n < 4) {
        0 => count - 1,
        1 => count,
        2 => count + 1,
        _ => count + (1 << 20),
    }
}

/// TH-MONITOR: samples of any forces have an answer, which is unknown exactly where a number did not
/// fit, unless the wall was surely active before.
#[kani::proof]
fn th_monitor_answers_any_forces() {
    let first = i32::from(kani::any::<i8>());
    let mut monitor = Monitor::<i64>::start(ORDINARY, first, kani::any());
    let second = next(first);
    monitor.sample(second, kani::any());
    let answer = monitor.sample(next(second), kani::any());
    let saturated = monitor.saturation().is_some();
    kani::cover!(answer == Answer::SurelyActive, "it is surely active");
    kani::cover!(answer == Answer::Unknown, "a number did not fit");
    kani::assert(
        (answer != Answer::Unknown || saturated)
            && (!saturated || matches!(answer, Answer::Unknown | Answer::SurelyActive)),
        "TH-MONITOR: an answer is unknown exactly where a number did not fit",
    );
}
