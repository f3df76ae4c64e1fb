//! Runs a harness on input after input and keeps what it saw.

use std::any::Any;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, Location, catch_unwind, resume_unwind};

use crate::value::{Arbitrary, Random};

/// Inputs up to which a domain is small: all of them are run. Seconds at some 10 M a second.
const EXHAUST_UP_TO: u128 = 20_000_000;

/// Inputs run of a domain that is not small.
const SAMPLES: u64 = 400_000;

/// Values of a type up to which it is drawn by going through all of them.
const LISTED_UP_TO: i128 = 1 << 16;

/// Panics, each of which prints its own message, after which a harness is left.
const PANICS: u64 = 4;

/// Failures of an assertion that is to hold after which a harness is left: more would only be counted.
const FAILURES: u64 = 100;

/// Values tried before a sampled predicate counts as one that nothing meets.
const TRIES: usize = 4096;

/// How a domain was gone through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// On every input.
    Exhausted,
    /// On boundary-weighted samples.
    Sampled,
}

/// What was seen of a harness.
pub(crate) struct Seen {
    pub(crate) mode: Mode,
    /// Inputs run, those that an assumption excluded included.
    pub(crate) inputs: u64,
    /// Inputs that reached the end of the harness or a failure.
    pub(crate) cases: u64,
    /// Failures by their message: how many, and the first one's place and input.
    pub(crate) failures: BTreeMap<String, (u64, String)>,
    /// How often each cover was hit.
    pub(crate) hits: BTreeMap<&'static str, u64>,
    /// Inputs on which something other than an assertion failed.
    panics: u64,
    /// Inputs on which an assertion failed that is to hold.
    failed: u64,
    /// The message of the one that is to fail.
    must_fail: Option<String>,
}

/// One point on the way to an input: the values a draw may take, and which is taken.
struct Choice {
    values: Vec<i128>,
    index: usize,
}

enum Source {
    Every(Vec<Choice>),
    Samples(Random),
}

/// The input that is being drawn.
struct Input {
    source: Source,
    drawn: Vec<(i128, &'static Location<'static>)>,
    hits: BTreeMap<&'static str, u64>,
}

thread_local! {
    static INPUT: RefCell<Option<Input>> = const { RefCell::new(None) };
}

/// Why a run of a harness was left early.
enum Leave {
    /// An assumption is not met.
    Cut,
    /// The domain is not small enough to run all of it.
    TooLarge,
    /// An assertion does not hold.
    Failed(&'static str, &'static Location<'static>),
}

fn leave(why: Leave) -> ! {
    // Not a panic: the hook that prints panics must stay silent.
    resume_unwind(Box::new(why))
}

pub(crate) fn cut() -> ! {
    leave(Leave::Cut)
}

pub(crate) fn fail(message: &'static str, at: &'static Location<'static>) -> ! {
    leave(Leave::Failed(message, at))
}

pub(crate) fn hit(message: &'static str) {
    INPUT.with_borrow_mut(|input| {
        if let Some(input) = input {
            *input.hits.entry(message).or_default() += 1;
        }
    });
}

#[inline]
pub(crate) fn draw<T: Arbitrary, F: Fn(&T) -> bool>(
    accept: F,
    at: &'static Location<'static>,
) -> T {
    let number = INPUT.with_borrow_mut(|input| {
        let input = input
            .as_mut()
            .expect("values are drawn within a harness only");
        let number = match &mut input.source {
            Source::Every(choices) => {
                let depth = input.drawn.len();
                if depth == choices.len() {
                    let values = listed::<T, F>(&accept).ok_or(Leave::TooLarge)?;
                    choices.push(Choice { values, index: 0 });
                }
                let choice = &choices[depth];
                *choice.values.get(choice.index).ok_or(Leave::Cut)?
            }
            Source::Samples(random) => sampled::<T, F>(&accept, random).ok_or(Leave::Cut)?,
        };
        input.drawn.push((number, at));
        Ok(number)
    });
    match number {
        Ok(number) => T::from_number(number),
        Err(why) => leave(why),
    }
}

/// Every value that is accepted, or `None` when the type has too many.
fn listed<T: Arbitrary, F: Fn(&T) -> bool>(accept: &F) -> Option<Vec<i128>> {
    let (lo, hi) = T::RANGE;
    let few = hi - lo < LISTED_UP_TO;
    few.then(|| (lo..=hi).filter(|&n| accept(&T::from_number(n))).collect())
}

/// A value that is accepted, if one is found.
fn sampled<T: Arbitrary, F: Fn(&T) -> bool>(accept: &F, random: &mut Random) -> Option<i128> {
    let (lo, hi) = T::RANGE;
    if hi - lo < 256 {
        let values = listed::<T, F>(accept)?;
        let last = values.len().checked_sub(1)?;
        let near = random.below(3).min(last);
        // One draw in four is at an end of what is accepted.
        return Some(
            values[match random.below(8) {
                0 => near,
                1 => last - near,
                _ => random.below(last + 1),
            }],
        );
    }
    (0..TRIES)
        .map(|_| random.number(T::RANGE))
        .find(|&n| accept(&T::from_number(n)))
}

/// Runs the harness on every input, or on samples where these are too many; one assertion may be to fail.
pub(crate) fn explore(name: &str, must_fail: Option<&str>, body: fn()) -> Seen {
    let seen = |mode| Seen::new(mode, must_fail);
    every(seen(Mode::Exhausted), body)
        .unwrap_or_else(|| samples(seen(Mode::Sampled), body, Random::named(name)))
}

fn every(mut seen: Seen, body: fn()) -> Option<Seen> {
    let mut choices = Vec::new();
    let mut hits = BTreeMap::new();
    loop {
        let (left, input) = run(body, Source::Every(choices), hits);
        let Source::Every(mut taken) = input.source else {
            unreachable!("the source is the one put in");
        };
        if matches!(&left, Err(why) if matches!(why.downcast_ref(), Some(Leave::TooLarge))) {
            return None;
        }
        taken.truncate(input.drawn.len().max(1));
        // The width of the way taken stands for that of the others; the count is the last word.
        let width = taken.iter().fold(1u128, |width, choice| {
            width.saturating_mul(choice.values.len() as u128)
        });
        if width > EXHAUST_UP_TO || u128::from(seen.inputs) > EXHAUST_UP_TO {
            return None;
        }
        seen.note(left, &input.drawn);
        hits = input.hits;
        if seen.is_left() {
            seen.hits = hits;
            return Some(seen);
        }
        // On to the next input: the last draw that has another value takes it.
        loop {
            let Some(last) = taken.last_mut() else {
                seen.hits = hits;
                return Some(seen);
            };
            last.index += 1;
            if last.index < last.values.len() {
                break;
            }
            taken.pop();
        }
        choices = taken;
    }
}

fn samples(mut seen: Seen, body: fn(), random: Random) -> Seen {
    let mut source = Source::Samples(random);
    let mut hits = BTreeMap::new();
    for _ in 0..SAMPLES {
        let (left, input) = run(body, source, hits);
        seen.note(left, &input.drawn);
        source = input.source;
        hits = input.hits;
        if seen.is_left() {
            break;
        }
    }
    seen.hits = hits;
    seen
}

type Left = Result<(), Box<dyn Any + Send>>;

fn run(body: fn(), source: Source, hits: BTreeMap<&'static str, u64>) -> (Left, Input) {
    let input = Input {
        source,
        drawn: Vec::with_capacity(8),
        hits,
    };
    INPUT.set(Some(input));
    let left = catch_unwind(AssertUnwindSafe(body));
    let input = INPUT.take().expect("put there a few lines above");
    (left, input)
}

impl Seen {
    fn new(mode: Mode, must_fail: Option<&str>) -> Self {
        Self {
            mode,
            inputs: 0,
            cases: 0,
            failures: BTreeMap::new(),
            hits: BTreeMap::new(),
            panics: 0,
            failed: 0,
            must_fail: must_fail.map(str::to_owned),
        }
    }

    /// Whether enough has failed that no more is run.
    pub(crate) const fn is_left(&self) -> bool {
        self.panics >= PANICS || self.failed >= FAILURES
    }

    fn note(&mut self, left: Left, drawn: &[(i128, &'static Location<'static>)]) {
        self.inputs += 1;
        let Err(why) = left else {
            self.cases += 1;
            return;
        };
        let (message, place) = match why.downcast_ref() {
            Some(Leave::Cut | Leave::TooLarge) => return,
            Some(Leave::Failed(message, at)) => {
                self.failed += u64::from(self.must_fail.as_deref() != Some(message));
                ((*message).to_string(), format!(" at {at}"))
            }
            None => {
                self.panics += 1;
                (panic_message(&*why), String::new())
            }
        };
        self.cases += 1;
        let entry = self.failures.entry(message).or_insert_with(|| {
            let values: Vec<String> = drawn
                .iter()
                .map(|(n, at)| format!("{n} (line {})", at.line()))
                .collect();
            (0, format!("{place}, drawn: {}", values.join(", ")))
        });
        entry.0 += 1;
    }
}

fn panic_message(payload: &(dyn Any + Send)) -> String {
    let text = payload
        .downcast_ref::<&str>()
        .map(|text| (*text).to_string())
        .or_else(|| payload.downcast_ref::<String>().cloned());
    format!("panic: {}", text.unwrap_or_else(|| "without a text".into()))
}
