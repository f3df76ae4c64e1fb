//! How much work a request may ask for: a fixed amount, and more for each of its bytes.
//!
//! The amount is counted before and while it is done, from the request alone, so that the same request is
//! refused everywhere. A step is about what two machine words take to be multiplied and reduced.

use num_traits::{One as _, ToPrimitive as _, Zero as _};
use passivity_audit::number::{Number, Written};
use passivity_audit::{Ledger, Reading};
use passivity_core::linear_part::MOST_DEGREE;
use passivity_core::{BigRational, Interval, Loop, Parameter};
use passivity_scene::json::read_rational;
use passivity_scene::number::nearest_f64;
use passivity_scene::{AnyScene, Given};
use serde_json::Value;

use super::{At, Refusal};

/// The steps that every request may take.
pub(super) const FREE: u64 = 4_000_000;

/// The steps that it may take beyond these for each of its bytes.
pub(super) const PER_BYTE: u64 = 100;

/// What a row takes that is written, however short its numbers are.
const ROW: u64 = 100;

/// How often the numbers of a row are multiplied and reduced.
const PRODUCTS: u64 = 8;

/// And how often for each sample that the loop remembers.
const PER_SAMPLE: u64 = 4;

/// What is left of the work that a request may ask for.
pub(super) struct Work {
    left: u64,
}

impl Work {
    /// Of a request of this many bytes.
    pub(super) fn of_request(bytes: usize) -> Self {
        let bytes = u64::try_from(bytes).unwrap_or(u64::MAX);
        Self {
            left: FREE.saturating_add(PER_BYTE.saturating_mul(bytes)),
        }
    }

    /// Takes these steps, or refuses what is at this place.
    pub(super) fn take(&mut self, steps: u64, at: impl Fn() -> At) -> Result<(), Refusal> {
        match self.left.checked_sub(steps) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => {
                let message = format!(
                    "more work than a request of this length may ask for ({FREE} steps and {PER_BYTE} for \
                     each byte): use shorter numbers, a shorter delay, fewer tolerances or fewer positions at a time"
                );
                Err(Refusal::new("too_much_work", at(), message))
            }
        }
    }
}

/// The steps of each row of a run under this ledger.
pub(super) fn of_row(
    ledger: &Ledger,
    samples: &[Reading],
    durations: &[Number],
    forces: &[Reading],
) -> u64 {
    let remembered = ledger.window().min(samples.len());
    let mut positions = Width::default();
    for sample in samples {
        positions.add_reading(sample);
    }
    let mut others = Width::default();
    for duration in durations {
        others.add(&duration.to_rational());
    }
    for force in forces {
        others.add_reading(force);
    }
    let remembered = u64::try_from(remembered).unwrap_or(u64::MAX);
    // Displacements are squared, and their sum has all denominators.
    let bits = 2 * (positions.bits(remembered + 1) + others.bits(1)) + bits_of_loop(ledger);
    let words = 1 + bits / 64;
    let times = PRODUCTS + PER_SAMPLE.saturating_mul(remembered - 1);
    ROW.saturating_add(times.saturating_mul(words.saturating_mul(words)))
}

/// The steps of computing what a delay with damping costs (TH-LTI): those of Sturm's sequences of polynomials
/// whose degree it makes, and of enclosing a large cost. Above the highest degree a closed form is used.
pub(super) fn of_costs(dimensionless: &Loop<Interval<BigRational>>) -> u64 {
    let degree = usize::from(dimensionless.delay) + 2;
    match &dimensionless.damping {
        Some(damping) if dimensionless.has_computed_costs() && degree <= MOST_DEGREE => {
            let words = 1 + (damping.lo().numer().bits() + damping.lo().denom().bits()) / 64;
            let degree = u64::try_from(degree).unwrap_or(u64::MAX);
            let of_size = of_size(degree, scale(damping.hi()));
            (degree.saturating_pow(4).saturating_mul(words * words)).saturating_add(of_size)
        }
        _ => 0,
    }
}

/// The steps of enclosing a cost that is 2 to the power of `scale`, as measured: the distance to it is doubled that often,
/// and each time the two roots beside a peak are told apart, which lie the closer together the sharper it is.
fn of_size(degree: u64, scale: i64) -> u64 {
    let scale = u64::try_from(scale).unwrap_or(0);
    degree.saturating_pow(3).saturating_mul(scale * scale) / 3
}

/// The power of two that is about as large as a number.
fn scale(x: &BigRational) -> i64 {
    let bits = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
    bits(x.numer().bits()) - bits(x.denom().bits())
}

/// The delay that a scene asks for as it was sent, in samples.
fn delay(scene: &Value) -> u16 {
    let delay = scene.pointer("/sampling/delay");
    let delay = delay.and_then(|delay| read_rational(delay).ok());
    let delay = delay.and_then(|delay| delay.to_integer().to_u16());
    delay.unwrap_or(0)
}

/// The steps of a check of damping in a linear loop: many decisions by polynomials of the same degree, at both ends of each
/// tolerance, and with a filter in many pieces.
///
/// Reading a scene computes what its damping costs. Without its delay a closed form says that, so it is read without one.
pub(super) fn of_damping(scene: &Value) -> u64 {
    let others = ["/sampling/latency", "/amplifier", "/controller", "/joint"];
    let is_there = |place: &str| scene.pointer(place).is_some();
    if !is_there("/wall/damping") || others.into_iter().any(is_there) {
        return 0;
    }
    let mut undelayed = scene.clone();
    if let Some(Value::Object(sampling)) = undelayed.get_mut("sampling") {
        sampling.remove("delay");
    }
    // What cannot be read takes no work: it is refused.
    let Ok(AnyScene::One(mut read)) = AnyScene::from_json(&undelayed) else {
        return 0;
    };
    read.given.delay = delay(scene);
    of_linear(&read.given)
}

fn of_linear(given: &Loop<Given>) -> u64 {
    let degree = usize::from(given.delay) + 2;
    let is_computed = given.damping.is_some() && given.has_computed_costs();
    if !is_computed || !given.is_linear() || degree > MOST_DEGREE {
        return 0;
    }
    let shaping = [
        Parameter::Stiffness,
        Parameter::Period,
        Parameter::Damping,
        Parameter::DampingTimeConstant,
    ];
    let (mut bits, mut widest, mut ends) = (0, 0, 1);
    // At the most, of the damping as multiples of KT, and of the filter's time constant as multiples of T.
    let (mut scale_of_cost, mut scale_of_filter) = (0, 0);
    for (of, given) in shaping
        .into_iter()
        .filter_map(|of| Some((of, given.get(of)?)))
    {
        // Of a number with π, as many as it is computed with.
        let ends_of = [given.value.lo(), given.value.hi()].map(|end| end.enclosure(64));
        let [Some(lo), Some(hi)] = &ends_of else {
            continue;
        };
        let widths = [lo, hi].map(|end| [end.lo().numer().bits(), end.lo().denom().bits()]);
        bits += widths.map(|[n, d]| n + d).into_iter().max().unwrap_or(0);
        widest += widths.into_iter().flatten().max().unwrap_or(0);
        ends *= if given.has_tolerance() { 2 } else { 1 };
        let below = 1 - scale(lo.lo());
        match of {
            Parameter::Damping => scale_of_cost += scale(hi.hi()),
            Parameter::DampingTimeConstant => scale_of_filter += scale(hi.hi()),
            Parameter::Period => {
                scale_of_cost += below;
                scale_of_filter += below;
            }
            _ => scale_of_cost += below,
        }
    }
    // What a filter does is no polynomial but a fraction, whose powers are as long as both of its parts.
    let (pieces, words) = match given.damping_time_constant {
        Some(_) if ends > 1 => (5000, 1 + widest * widest / 12_288),
        Some(_) => (250, 1 + widest * widest / 12_288),
        None => (250, 1 + bits / 256),
    };
    let degree = u64::try_from(degree).unwrap_or(u64::MAX);
    let decisions = degree.saturating_pow(2).saturating_mul(pieces * words);
    let steps = decisions.saturating_add(of_size(degree, scale_of_cost));
    // Limits behind a slow filter are sought in stretches, the more of them the more damping it bends.
    let [cost, filter] = [scale_of_cost, scale_of_filter].map(|of| u64::try_from(of).unwrap_or(0));
    let stretches = match given.damping_time_constant {
        Some(_) => 100 * cost * cost * filter,
        None => 0,
    };
    steps.saturating_add(stretches).saturating_mul(ends)
}

/// The steps of a check of several joints, as measured, and none of one: each of the limits of every joint is sought by eliminations of the
/// matrix of their frictions, whose numbers grow, or along a direction by sums.
pub(super) fn of_joints(scene: &AnyScene) -> u64 {
    let AnyScene::Joints(scene) = scene else {
        return 0;
    };
    let n = u64::try_from(scene.motions.len()).unwrap_or(u64::MAX);
    let rows = scene.given.shape.rows();
    let entries = rows.iter().flatten().filter_map(|x| x.enclosure(64));
    let bits = entries.map(|x| x.lo().numer().bits() + x.lo().denom().bits());
    let bits = bits.max().unwrap_or_default();
    let has_tolerance = scene.given.places().any(|place| {
        let given = scene.given.get(place);
        given.is_some_and(Given::has_tolerance)
    });
    let power = if scene.has_matrix() { 4 } else { 3 };
    let times = if has_tolerance { 60 } else { 20 };
    let of_numbers = (16 + bits) * (1 + bits / 1024);
    n.saturating_pow(power).saturating_mul(times * of_numbers)
}

/// The steps of a check with a digital controller, as measured: those of polynomials whose degree it makes with the delay, or
/// of sums alone above the highest degree, and those of a response that is summed until it is forgotten ([`forgetting`]).
///
/// Reading a scene computes what its controller costs, so this is of the scene as it was sent. What is no controller of a
/// scene takes no work: its reader refuses it.
pub(super) fn of_controller(scene: &Value) -> u64 {
    /// A scene has no more coefficients in a list.
    const MOST: usize = 64;
    let read = |name: &str| -> Option<Vec<BigRational>> {
        let list = scene.get("controller")?.get(name)?.as_array()?;
        let few = (1..=MOST).contains(&list.len()).then_some(list)?;
        few.iter().map(|x| read_rational(x).ok()).collect()
    };
    let (Some(numerator), denominator) = (read("numerator"), read("denominator")) else {
        return 0;
    };
    let denominator = denominator.unwrap_or_else(|| vec![BigRational::one()]);
    let mut width = Width::default();
    for x in numerator.iter().chain(&denominator) {
        width.add(x);
    }
    let whole = |n: usize| u64::try_from(n).unwrap_or(u64::MAX);
    let words = 1 + width.bits(whole(numerator.len() + denominator.len())) / 64;
    let n = whole(numerator.len().max(denominator.len()) + usize::from(delay(scene)));
    let largest = numerator.iter().map(scale).max().unwrap_or(0);
    let largest = largest - denominator.first().map_or(0, scale);
    let steps = match n <= whole(MOST_DEGREE) {
        true => {
            let steps = 2 * n * n * words.saturating_mul(n * n + words);
            steps.saturating_add(of_size(n, largest))
        }
        false => 20 * n * words.saturating_mul(n + words),
    };
    steps.saturating_add(forgetting(&denominator, words))
}

/// The steps of what a response costs that never ends: some hundred times, as limits are sought, its terms are summed, and
/// before it the matrix that takes one to the next is squared until it is small. Closed forms say what a denominator of
/// degree 0 or 1 makes.
fn forgetting(denominator: &[BigRational], words: u64) -> u64 {
    /// The bits that the squares are computed to, one after the other, until they are enough.
    const WIDTHS: [u64; 4] = [128, 512, 2048, 8192];
    let order = denominator.iter().rposition(|d| !d.is_zero());
    let order = order.unwrap_or_default();
    let ratios: Vec<f64> = match denominator.split_first() {
        Some((leading, others)) if !leading.is_zero() && order > 1 => {
            let others = others.iter().take(order);
            others.map(|d| nearest_f64(&(d / leading))).collect()
        }
        _ => return 0,
    };
    let response = response(&ratios);
    let whole = |n: usize| u64::try_from(n).unwrap_or(u64::MAX);
    let terms = whole(response.len());
    let sums = 250 * whole(order) * terms * (3 + words) / 4;
    // The k-th power takes what was held by the ratios to the terms up to k, or on to the next place.
    let held: f64 = ratios.iter().map(|d| d.abs()).sum();
    let (mut bits, mut squares) = (1.0, 0);
    for power in (0..24).map(|i| 1_usize << i) {
        let last = response
            .iter()
            .take(power + 1)
            .skip((power + 1).saturating_sub(2 * order));
        let on = if power < order { 1.0 } else { 0.0 };
        let norm = held * last.map(|c| c.abs()).sum::<f64>() + on;
        if norm <= 0.5 {
            break;
        }
        bits += 1.0 + norm.log2().max(0.0);
        squares += 1;
    }
    #[expect(clippy::cast_precision_loss, reason = "these are powers of two")]
    let width = WIDTHS.into_iter().find(|width| *width as f64 >= bits);
    let width = width.unwrap_or(8192) / 128;
    let squaring = 20 * whole(order).pow(3) * squares * (1 + width * width / 16);
    sums.saturating_add(squaring)
}

/// The terms of the response of a stable denominator until they are below 2⁻⁶⁴, about; none of one that is not stable,
/// which its reader says.
fn response(ratios: &[f64]) -> Vec<f64> {
    const MOST: usize = 1 << 16;
    let small = |terms: &[f64], below: f64| {
        let mut state = terms.iter().rev().take(ratios.len());
        state.all(|c| c.abs() < below)
    };
    let mut terms = vec![1.0];
    while terms.len() < MOST {
        let past = ratios.iter().zip(terms.iter().rev());
        terms.push(past.fold(0.0, |sum, (d, c)| sum - d * c));
        if small(&terms, 0.5_f64.powi(64)) {
            return terms;
        }
    }
    match small(&terms, 0.1) {
        true => terms,
        false => Vec::new(),
    }
}

/// The steps of adding a row to sums whose denominators have this many bits.
pub(super) const fn of_sums(bits: u64) -> u64 {
    let words = bits / 64;
    2 * words * words
}

/// How long numbers are, and the denominator that all of them have in common, as long as it is short.
#[derive(Default)]
struct Width {
    numerator: u64,
    denominator: u64,
    common: Option<num_bigint::BigInt>,
    is_long: bool,
}

impl Width {
    fn add_reading(&mut self, reading: &Reading) {
        match reading {
            Reading::Count(n) => self.add(&BigRational::from_integer((*n).into())),
            Reading::Exact(Number::Small(n, 1)) => {
                self.numerator = self
                    .numerator
                    .max(64 - u64::from(n.unsigned_abs().leading_zeros()));
            }
            Reading::Exact(x) => self.add(&x.to_rational()),
            Reading::Within(x) => {
                let range = x.range();
                self.add(range.lo());
                self.add(range.hi());
            }
        }
    }

    fn add(&mut self, x: &BigRational) {
        /// A common denominator is sought up to this many bits.
        const SHORT: u64 = 512;
        self.numerator = self.numerator.max(x.numer().bits());
        self.denominator = self.denominator.max(x.denom().bits());
        if self.is_long {
            return;
        }
        let common = match self.common.take() {
            Some(common) if (&common % x.denom()).is_zero() => common,
            Some(common) => num_integer::Integer::lcm(&common, x.denom()),
            None => x.denom().clone(),
        };
        self.is_long = common.bits() > SHORT;
        self.common = Some(common);
    }

    /// The bits of a sum of `terms` of them.
    fn bits(&self, terms: u64) -> u64 {
        let most = self.denominator.saturating_mul(terms);
        let common = self.common.as_ref().filter(|_| !self.is_long);
        let denominator = common.map_or(most, |common| common.bits().min(most));
        self.numerator.saturating_add(denominator)
    }
}

/// The bits of all numbers of a loop.
fn bits_of_loop(ledger: &Ledger) -> u64 {
    let ends = ledger.wide();
    let mut bits = 0;
    for end in [&ends.least, &ends.most] {
        let counted = end.try_map(|_, x| {
            let x = Written::to_rational(x)?;
            bits += x.numer().bits() + x.denom().bits();
            Some(())
        });
        // What has no numbers takes no work.
        let _ = counted;
    }
    bits / 2
}
