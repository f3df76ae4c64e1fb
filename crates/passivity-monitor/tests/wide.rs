//! The monitor with sums of 128 bits against the account in 128 bits alone.

use passivity_monitor::account::Account;
use passivity_monitor::{
    Answer, Config, Given, Monitor, PARAMETER_MAX, Quantity, Saturation, Width,
};
use passivity_random::draws;
use proptest::prelude::*;

/// A monitor that has nothing but the account, and computes all of it in 128 bits at every sample.
struct Plain {
    config: Config,
    account: Option<Account<i128>>,
    count: i64,
    force: i64,
    samples: u64,
    answer: Answer,
    saturation: Option<Saturation>,
}

impl Plain {
    fn start(config: Config, count: i64, force: i64) -> Self {
        let mut plain = Self {
            config,
            account: Account::start(&config, count.into()),
            count,
            force,
            samples: 0,
            answer: Answer::SurelyPassive,
            saturation: None,
        };
        if plain.account.is_none() {
            plain.saturate(Quantity::Start);
        }
        plain
    }

    fn saturate(&mut self, quantity: Quantity) {
        let sample = self.samples;
        self.saturation = Some(Saturation { sample, quantity });
        self.account = None;
        if self.answer != Answer::SurelyActive {
            self.answer = Answer::Unknown;
        }
    }

    fn sample(&mut self, count: i64, force: i64) {
        let Some(mut account) = self.account else {
            return;
        };
        self.samples += 1;
        let ticks = i128::from(count) - i128::from(self.count);
        let Some(ticks) = i64::try_from(ticks)
            .ok()
            .filter(|n| n.abs() <= i128::STEP_MAX)
        else {
            return self.saturate(Quantity::Step);
        };
        let held = std::mem::replace(&mut self.force, force);
        self.count = count;
        if account.advance(&self.config, held.into(), ticks).is_none() {
            return self.saturate(Quantity::Energy);
        }
        self.account = Some(account);
        let passive = account.at_most(&self.config).is_some_and(|most| most <= 0);
        self.answer = match self.answer {
            Answer::SurelyPassive if passive => Answer::SurelyPassive,
            Answer::SurelyPassive | Answer::Open if account.at_least() > 0 => Answer::SurelyActive,
            Answer::SurelyPassive | Answer::Open => Answer::Open,
            settled => settled,
        };
    }

    fn given(&self) -> Option<Given<i128>> {
        let account = self.account?;
        Some(Given {
            least: account.at_least(),
            most: account.at_most(&self.config)?,
        })
    }
}

/// A number of at most so many bits: near a power of two, any, or small.
fn number(bits: u32) -> impl Strategy<Value = i64> {
    let edge = (0..=bits, -2..3_i64).prop_map(|(bits, off)| {
        let edge = if bits == 63 { i64::MAX } else { 1 << bits };
        edge.saturating_add(off)
    });
    let some = (0..=bits, any::<i64>()).prop_map(|(bits, n)| (n & i64::MAX) >> (63 - bits));
    let size = prop_oneof![edge, some, 0..4_i64];
    (size, any::<bool>()).prop_map(|(n, minus)| if minus { n.saturating_neg() } else { n })
}

/// A number of at most so many bits, with a favourite of fewer.
fn around(favourite: u32, bits: u32) -> impl Strategy<Value = i64> {
    let favoured = (-3..4_i64, any::<bool>()).prop_map(move |(off, minus)| {
        let n = (1 << favourite) + off;
        if minus { -n } else { n }
    });
    prop_oneof![favoured, number(favourite), number(bits)]
}

/// A count where a spring of this stiffness has stored about so many bits.
fn far_out(stiffness: i64, bits: u32, off: i64) -> i64 {
    let square = (1_u128 << bits) / u128::from(stiffness.unsigned_abs().max(1));
    i64::try_from(square.isqrt()).map_or(i64::MAX, |count| count.saturating_add(off))
}

fn parameter() -> impl Strategy<Value = i64> {
    prop_oneof![
        0..4_i64,
        0..2000_i64,
        0..=PARAMETER_MAX,
        Just(PARAMETER_MAX)
    ]
}

fn config() -> impl Strategy<Value = Config> {
    let parameters = prop::array::uniform3(parameter());
    let more = prop::option::of(prop::array::uniform2(parameter()));
    let stored = prop::option::of(0..=1_i64 << 62);
    (parameters, more, stored).prop_map(|([stiffness, viscous, coulomb], more, stored)| {
        let mut config = Config::new(stiffness, viscous, coulomb).expect("in range");
        if let Some([more_viscous, more_coulomb]) = more {
            let (viscous, coulomb) = (viscous.max(more_viscous), coulomb.max(more_coulomb));
            let more = config.with_friction_at_most(viscous, coulomb);
            config = more.expect("in range");
        }
        match stored {
            Some(stored) => config.with_stored_at_start(stored).expect("in range"),
            None => config,
        }
    })
}

/// Ticks, the force that is held over them, and whether what viscous friction takes is added to it.
type Sample = (i64, i64, bool);

/// Several times over.
fn samples() -> impl Strategy<Value = Vec<Sample>> {
    let sample = (around(15, 32), around(45, 63), prop::bool::weighted(0.2));
    prop::collection::vec((sample, 1..20_usize), 1..30).prop_map(|some| {
        let repeated = |(sample, times)| std::iter::repeat_n(sample, times);
        some.into_iter().flat_map(repeated).collect()
    })
}

/// Whether both say the same at every sample.
fn agree(config: Config, mut count: i64, samples: &[Sample]) -> Result<(), TestCaseError> {
    let held = |(ticks, force, more): &Sample| match more {
        true => force.saturating_add(ticks.saturating_mul(2 * config.viscous_at_most())),
        false => *force,
    };
    let first = samples.first().map_or(0, held);
    let mut plain = Plain::start(config, count, first);
    let mut monitor = Monitor::<i128>::start(config, count, first);
    for (i, (ticks, ..)) in samples.iter().enumerate() {
        prop_assert_eq!(plain.answer, monitor.answer());
        prop_assert_eq!(plain.given(), monitor.given());
        prop_assert_eq!(plain.saturation, monitor.saturation());
        count = count.saturating_add(*ticks);
        let force = samples.get(i + 1).map_or(0, held);
        plain.sample(count, force);
        prop_assert_eq!(plain.answer, monitor.sample(count, force));
    }
    prop_assert_eq!(plain.given(), monitor.given());
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(1000)))]

    /// TH-MONITOR: in two parts, an account is the same to the bit as in 128 bits alone.
    #[test]
    fn th_monitor_is_the_account_of_128_bits(
        config in config(),
        count in number(63),
        samples in samples(),
    ) {
        agree(config, count, &samples)?;
    }

    /// TH-MONITOR: so it is where sums are at the limits of the parts, and of 128 bits.
    #[test]
    fn th_monitor_is_the_account_of_128_bits_far_out(
        config in config(),
        bits in prop_oneof![60..66_u32, 120..128_u32],
        off in -3..4_i64,
        samples in samples(),
    ) {
        agree(config, far_out(config.stiffness(), bits, off), &samples)?;
    }

    /// TH-MONITOR: so it is from the least sum of 128 bits on.
    #[test]
    fn th_monitor_is_the_account_of_128_bits_at_its_end(
        viscous in 0..3_i64,
        coulomb in 0..3_i64,
        down in any::<bool>(),
        samples in samples(),
    ) {
        let config = Config::new(2, viscous, coulomb).expect("in range");
        let count = if down { i64::MIN } else { i64::MAX };
        agree(config, count, &samples)?;
    }
}
