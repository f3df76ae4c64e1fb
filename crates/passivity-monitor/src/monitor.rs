//! The monitor: one call a sample.

use crate::account::{Account, under};
use crate::config::Config;
use crate::kept::Kept;
use crate::width::Width;

/// What a monitor says of the motion so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Answer {
    /// At no sample so far can the wall have given more than its spring stored at the start.
    SurelyPassive = 0,
    /// The counts leave it open.
    Open = 1,
    /// At one and the same sample the wall had given more, wherever within the ticks the positions were.
    /// This is never taken back.
    SurelyActive = 2,
    /// A number did not fit: see [`Monitor::saturation`]. Stays until the monitor starts anew: until then nothing shows
    /// that the wall is passive.
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
    kept: Kept<W>,
    /// The count and the force of the last sample.
    count: W::Input,
    force: W::Input,
    /// How many samples were taken after the first.
    samples: u64,
    /// Whether the wall was surely passive so far; if not, the answer is the next.
    is_passive: bool,
    answer: Answer,
    /// Which number did not fit. No sample is looked at then.
    saturated: Option<Quantity>,
}

impl<W: Width> Monitor<W> {
    /// A monitor at its first sample: the encoder's count, unwrapped and from where the wall begins, and the
    /// force that is held from now until the next sample, in the unit of the configuration. So far from there that the
    /// energy stored does not fit, its answer is [`Answer::Unknown`] from the start on.
    #[must_use]
    pub fn start(config: Config, count: W::Input, force: W::Input) -> Self {
        let account = Account::start(&config, count.into());
        let nothing = Account {
            most: W::ZERO,
            slope: W::ZERO,
            least: W::ZERO,
            apart: W::ZERO,
        };
        let mut monitor = Self {
            config,
            kept: W::kept(account.unwrap_or(nothing)),
            count,
            force,
            samples: 0,
            is_passive: true,
            answer: Answer::Open,
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
        let ticks = match W::ticks(self.count, count) {
            Some(ticks) if ticks.is_within(i64::STEP_MAX, self.kept.steps) => ticks,
            _ => return self.step_far(count, force),
        };
        let held = self.take(count, force);
        let small: i64 = held.into();
        if !small.is_within(i64::FORCE_MAX, 2 * i64::FORCE_MAX) {
            return self.far(|monitor| monitor.advance_far(held, ticks));
        }
        let account = &mut self.kept.account;
        let (twice, slope) = under(&self.config, small);
        if account.advance_least(&self.config, twice, ticks).is_none() {
            return self.far(|monitor| monitor.advance_far(held, ticks));
        }
        if account.advance_most(&self.config, slope, ticks).is_none() {
            return self.far(|monitor| monitor.advance_most_far(slope, ticks));
        }
        if !self.is_passive {
            return self.look();
        }
        if !self.kept.account.may_be_positive(&self.config) {
            return Answer::SurelyPassive;
        }
        self.turn()
    }

    /// Notes a sample, and gives the force that was held until it.
    #[inline]
    fn take(&mut self, count: W::Input, force: W::Input) -> W::Input {
        self.count = count;
        self.samples = self.samples.wrapping_add(1);
        core::mem::replace(&mut self.force, force)
    }

    /// The answer where an account of 64 bits does not go on: a wider one may.
    #[inline]
    fn far(&mut self, goes_on: impl FnOnce(&mut Self) -> Answer) -> Answer {
        match W::IS_WIDE {
            true => goes_on(self),
            false => self.saturate(Quantity::Energy),
        }
    }

    // What follows is not in line: what it needs of the account is not kept in registers for it.

    /// The answer where the wall was not surely passive before.
    #[inline(never)]
    fn look(&mut self) -> Answer {
        if self.answer == Answer::Open && self.kept.account.is_positive() {
            return self.turn();
        }
        self.answer
    }

    /// The answer where the account of 64 bits says that it is another one now.
    ///
    /// What is beside the account is not above zero as long as the answer can change. So the account of 64 bits may
    /// say so early, but not late.
    #[inline(never)]
    fn turn(&mut self) -> Answer {
        if W::IS_WIDE && self.kept.is_parted {
            return self.settle(W::whole(&self.kept));
        }
        self.is_passive = false;
        if self.kept.account.is_positive() {
            self.answer = Answer::SurelyActive;
        }
        self.answer
    }

    /// Takes a sample whose step is too long for the account of 64 bits, or for any.
    #[cold]
    #[inline(never)]
    fn step_far(&mut self, count: W::Input, force: W::Input) -> Answer {
        match W::ticks(self.count, count) {
            _ if self.saturated.is_some() => self.answer,
            Some(ticks) if ticks.is_within(W::STEP_MAX, 2 * W::STEP_MAX + 1) => {
                let held = self.take(count, force);
                self.far(|monitor| monitor.advance_far(held, ticks))
            }
            _ => self.saturate(Quantity::Step),
        }
    }

    /// Goes on by the whole account, as the one of 64 bits has not.
    #[cold]
    #[inline(never)]
    fn advance_far(&mut self, held: W::Input, ticks: i64) -> Answer {
        let mut whole = W::whole(&self.kept);
        match whole.advance(&self.config, held.into(), ticks) {
            Some(()) => self.settle(whole),
            None => self.saturate(Quantity::Energy),
        }
    }

    /// The same where the least of it has, but the most has not.
    #[cold]
    #[inline(never)]
    fn advance_most_far(&mut self, slope: i64, ticks: i64) -> Answer {
        let mut whole = W::whole(&self.kept);
        match whole.advance_most(&self.config, W::from_i64(slope), ticks) {
            Some(()) => self.settle(whole),
            None => self.saturate(Quantity::Energy),
        }
    }

    /// Answers by the whole account, and parts it anew.
    #[inline]
    fn settle(&mut self, whole: Account<W>) -> Answer {
        self.is_passive = self.is_passive && !whole.may_be_positive(&self.config);
        if !self.is_passive && self.answer == Answer::Open && whole.is_positive() {
            self.answer = Answer::SurelyActive;
        }
        self.kept = W::kept(whole);
        self.answer()
    }

    #[cold]
    fn saturate(&mut self, quantity: Quantity) -> Answer {
        if self.saturated.is_none() {
            self.saturated = Some(quantity);
            self.kept.steps = 0;
            self.is_passive = false;
            if self.answer != Answer::SurelyActive {
                self.answer = Answer::Unknown;
            }
        }
        self.answer
    }

    /// The answer about the motion so far.
    #[must_use]
    pub const fn answer(&self) -> Answer {
        match self.is_passive {
            true => Answer::SurelyPassive,
            false => self.answer,
        }
    }

    /// What has been given up to the last sample; `None` after a number that did not fit.
    #[must_use]
    pub fn given(&self) -> Option<Given<W>> {
        if self.saturated.is_some() {
            return None;
        }
        let account = W::whole(&self.kept);
        Some(Given {
            least: account.at_least(),
            most: account.at_most(&self.config)?,
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
