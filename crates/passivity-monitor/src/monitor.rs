//! The monitor: one call a sample.

use crate::account::Account;
use crate::config::Config;
use crate::width::Width;

/// What a monitor says of the motion so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Answer {
    /// At no sample so far can the wall have given more than its spring stored at the start.
    SurelyPassive = 0,
    /// The counts leave it open.
    Open = 1,
    /// At some sample the wall had given more, wherever within the ticks the positions were. This
    /// is never taken back.
    SurelyActive = 2,
    /// A number did not fit: see [`Monitor::saturation`]. Stays until the monitor starts anew.
    Unknown = 3,
}

/// Energy that the wall has given the operator beyond what its spring stored at the start, in halves
/// of the force unit times a tick, at the least and at the most that the counts allow.
///
/// What the device has of kinetic energy counts as given: the operator can take it at any time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Given<W> {
    /// Surely no less: some motion with these counts gave this much.
    pub least: W,
    /// Surely no more.
    pub most: W,
}

/// Which number did not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Quantity {
    /// The energy stored at the start does not fit in the width.
    Start = 1,
    /// The count changed by more than [`Width::STEP_MAX`] in one sample.
    Step = 2,
    /// A sum of energies does not fit in the width.
    Energy = 3,
}

/// Where a number did not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Saturation {
    /// At which sample, from 0.
    pub sample: u64,
    /// Which number it was.
    pub quantity: Quantity,
}

/// Watches the passivity of a loop, sample by sample.
///
/// # Example
///
/// A wall with K = 2b/T = 2c/Δ is passive, but barely.
///
/// ```
/// use passivity_monitor::{Answer, Config, Monitor};
///
/// let config = Config::new(1000, 500, 500)?;
/// let force = |count: i32| -(1000 * count + 500);
/// let mut monitor = Monitor::<i64>::start(config, 0, force(0));
/// for count in [2, 5, 9, 11, 8, 4, 0, -3] {
///     assert_eq!(monitor.sample(count, force(count)), Answer::SurelyPassive);
/// }
///
/// // The same wall, but its force comes two samples late.
/// let counts = [0, 0, 0, 2, 5, 9, 11, 8, 4, 0, -3, -3, -3];
/// let mut monitor = Monitor::<i64>::start(config, counts[2], force(counts[0]));
/// for (count, before) in counts[3..].iter().zip(&counts[1..]) {
///     monitor.sample(*count, force(*before));
/// }
/// assert_eq!(monitor.answer(), Answer::SurelyActive);
/// # Ok::<(), passivity_monitor::ConfigError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Monitor<W: Width> {
    config: Config,
    account: Account<W>,
    /// The count and the force of the last sample.
    count: W::Input,
    force: W::Input,
    /// How many samples were taken after the first.
    samples: u64,
    answer: Answer,
    /// How many different steps the next count may be away: those up to [`Width::STEP_MAX`] either way; none, so
    /// that no sample is looked at, once a number did not fit.
    steps: i64,
    /// Which number that was.
    saturated: Option<Quantity>,
}

impl<W: Width> Monitor<W> {
    /// A monitor at its first sample: the encoder's count, from where the wall begins, and the force
    /// that is held from now until the next sample, in the unit of the configuration.
    #[must_use]
    pub fn start(config: Config, count: W::Input, force: W::Input) -> Self {
        let account = Account::start(&config, count.into());
        let nothing = Account {
            most: W::ZERO,
            slope: W::ZERO,
            least: [W::ZERO; 2],
        };
        let mut monitor = Self {
            config,
            account: account.unwrap_or(nothing),
            count,
            force,
            samples: 0,
            answer: Answer::SurelyPassive,
            steps: 2 * W::STEP_MAX + 1,
            saturated: None,
        };
        if account.is_none() {
            monitor.saturate(Quantity::Start);
        }
        monitor
    }

    /// Takes the next sample: the encoder's count, and the force that is held from now until the one
    /// after.
    ///
    /// The answer is about the motion up to this sample. After a number that did not fit, samples
    /// are no longer looked at.
    #[inline]
    pub fn sample(&mut self, count: W::Input, force: W::Input) -> Answer {
        // Whether a step is neither too long up nor too long down is one comparison.
        let ticks = match W::ticks(self.count, count) {
            Some(ticks) if ticks.wrapping_add(W::STEP_MAX).is_below(self.steps) => ticks,
            _ => return self.saturate(Quantity::Step),
        };
        let held = core::mem::replace(&mut self.force, force);
        self.count = count;
        self.samples = self.samples.wrapping_add(1);
        let advanced = self.account.advance(&self.config, held.into(), ticks);
        if advanced.is_none() {
            return self.saturate(Quantity::Energy);
        }
        self.answer = match self.answer {
            Answer::SurelyPassive if !self.account.may_be_positive(&self.config) => {
                return Answer::SurelyPassive;
            }
            Answer::SurelyPassive | Answer::Open => match self.account.at_least() > W::ZERO {
                true => Answer::SurelyActive,
                false => Answer::Open,
            },
            settled => return settled,
        };
        self.answer
    }

    #[cold]
    fn saturate(&mut self, quantity: Quantity) -> Answer {
        if self.saturated.is_none() {
            self.saturated = Some(quantity);
            self.steps = 0;
            if self.answer != Answer::SurelyActive {
                self.answer = Answer::Unknown;
            }
        }
        self.answer
    }

    /// The answer about the motion so far.
    #[must_use]
    pub const fn answer(&self) -> Answer {
        self.answer
    }

    /// What has been given up to the last sample; `None` after a number that did not fit.
    #[must_use]
    pub fn given(&self) -> Option<Given<W>> {
        if self.saturated.is_some() {
            return None;
        }
        Some(Given {
            least: self.account.at_least(),
            most: self.account.at_most(&self.config)?,
        })
    }

    /// Where a number did not fit, if one did not.
    #[must_use]
    pub fn saturation(&self) -> Option<Saturation> {
        let quantity = self.saturated?;
        let sample = match quantity {
            Quantity::Start => 0,
            Quantity::Step => self.samples.wrapping_add(1),
            Quantity::Energy => self.samples,
        };
        Some(Saturation { sample, quantity })
    }

    /// The configuration.
    #[must_use]
    pub const fn config(&self) -> &Config {
        &self.config
    }
}
