//! What a case, `explain` and `check` say of a motion that draws energy is one text, and it is true: from
//! the positions as printed the gain is computed again, by a held force that is written out here.

use num_traits::{Signed as _, Zero as _};
use passivity_core::BigRational;
use passivity_scene::display::{Rounding, rounded};
use passivity_scene::explain::Step;
use passivity_scene::number::parse;

use crate::{case, dimensionless, in_one_line, page, shipped, study};

fn q(text: &str) -> BigRational {
    parse(text).unwrap_or_else(|error| panic!("`{text}`: {error:?}"))
}

/// A held force: y = Σ nⱼ·q + a·y′ of measured positions, late, and on one side only or on both.
struct Law {
    encoder: bool,
    numerator: Vec<BigRational>,
    pole: BigRational,
    delay: usize,
    /// The part of a sample after which the output changes.
    latency: BigRational,
    unilateral: bool,
}

impl Law {
    fn of(numerator: &[&str]) -> Self {
        Self {
            encoder: true,
            numerator: numerator.iter().map(|n| q(n)).collect(),
            pole: q("0"),
            delay: 0,
            latency: q("0"),
            unilateral: false,
        }
    }

    /// The mean force of each interval of a motion that has repeated for ever.
    fn forces(&self, positions: &[BigRational]) -> Vec<BigRational> {
        let period = positions.len();
        let measured = |h: usize, back: usize| {
            let xi = &positions[(h + (back / period + 1) * period - back) % period];
            if self.encoder {
                xi.floor() + q("1/2")
            } else {
                xi.clone()
            }
        };
        let round = |start: BigRational| {
            let mut state = start;
            let outputs = (0..period).map(|h| {
                let taps = self.numerator.iter().enumerate();
                let input = taps.map(|(j, n)| n * measured(h, self.delay + j));
                state = input.fold(&self.pole * &state, |sum, term| sum + term);
                let inside = !self.unilateral || !measured(h, self.delay).is_negative();
                if inside { -state.clone() } else { q("0") }
            });
            let outputs: Vec<BigRational> = outputs.collect();
            (outputs, state)
        };
        // The state that a period leads back to: y = f + aᵖ·y.
        let (_, forced) = round(q("0"));
        let left = (0..period).fold(q("1"), |product, _| product * &self.pole);
        let (commands, _) = round(forced / (q("1") - left));
        let mean = |h: usize| {
            let before = &commands[(h + period - 1) % period];
            before * &self.latency + &commands[h] * (q("1") - &self.latency)
        };
        (0..period).map(mean).collect()
    }

    /// What the hand gains each time round.
    fn gain(
        &self,
        positions: &[BigRational],
        beta: &BigRational,
        sigma: &BigRational,
    ) -> BigRational {
        let next = positions.iter().cycle().skip(1);
        let steps = positions.iter().zip(next).map(|(from, to)| to - from);
        let gains = self.forces(positions).into_iter().zip(steps);
        gains.fold(BigRational::zero(), |sum, (force, d)| {
            sum + force * &d - beta * &d * &d - sigma * d.abs()
        })
    }
}

/// What is said of the motion in a text.
fn said(text: &str) -> String {
    let text = in_one_line(text);
    let end = "the scene allows.";
    let (before, _) = text
        .split_once(end)
        .unwrap_or_else(|| panic!("no witness: {text}"));
    let starts = ["move from", "move through", "repeat"];
    let start = starts.iter().filter_map(|start| before.rfind(start)).max();
    format!("{}{end}", &before[start.expect("a motion")..])
}

fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let rest = text.split_once(before).map(|(_, rest)| rest);
    let found = rest.and_then(|rest| rest.split_once(after));
    found
        .unwrap_or_else(|| panic!("{before} … {after}: {text}"))
        .0
}

/// The positions of a motion as it is printed. A wave is computed in doubles, whose error of some 10⁻⁷ ticks
/// may round a place in the middle of two ticks to either: both are within the half tick that the text allows.
///
/// Of a long list the beginning is printed and how many there are; the rest is that of the report.
fn positions(text: &str, unit: &str, all: &[BigRational]) -> Vec<BigRational> {
    if text.starts_with("move from ") {
        return vec![
            q(between(text, "move from ", " to ")),
            q(between(text, " to ", &format!(" {unit} and back"))),
        ];
    }
    if text.starts_with("move through ") {
        let list = between(text, "move through ", &format!(" {unit}, one a sampling"));
        let (first, count) = match list.split_once(", … (") {
            Some((first, count)) => (first, count.strip_suffix(" positions)").expect("a count")),
            None => (list, ""),
        };
        let mut printed: Vec<BigRational> = first.split(", ").map(q).collect();
        if !count.is_empty() {
            assert_eq!(count, all.len().to_string());
            printed.extend(all.iter().skip(printed.len()).cloned());
        }
        return printed;
    }
    let number = |before, after| {
        between(text, before, after)
            .parse::<f64>()
            .expect("a number")
    };
    let (period, amplitude) = (number("repeat ", " samples"), number("steps of ", "·cos"));
    let turns = number("cos(2π·", "·h/");
    assert!(
        text.contains(&format!("·h/{period}) ticks at sample h")),
        "{text}"
    );
    let angle = std::f64::consts::TAU * turns / period;
    let half = (angle / 2.0).sin();
    // The sum of A·cos θj over j < h.
    let place = |h: u32| amplitude * ((angle * (f64::from(h) - 0.5)).sin() + half) / (2.0 * half);
    let whole = |h| BigRational::from_float(place(h).round()).expect("a number");
    (0..period as u32).map(whole).collect()
}

#[test]
fn the_motion_that_is_printed_draws_what_is_printed() {
    let one_pole = Law {
        pole: q("3/5"),
        ..Law::of(&["2/5"])
    };
    let late = |numerator: &[&str], unilateral| Law {
        delay: 1,
        unilateral,
        ..Law::of(numerator)
    };
    let smooth = "[device]\nviscous = \"1/4 N s/m\"\ncoulomb = \"1/10 N\"\n[sampling]\nperiod = \"1 s\"\n\
                  [wall]\nstiffness = \"1 N/m\"\n";
    let cases = [
        (dimensionless("2/5", "2/5", ""), Law::of(&["1"])),
        (shipped("re35-limit-cycles.toml"), Law::of(&["1"])),
        (shipped("re35-locally-stable.toml"), Law::of(&["1"])),
        (shipped("re35-unstable.toml"), Law::of(&["1"])),
        (
            dimensionless(
                "3",
                "9/10",
                "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/2\"\nunilateral = true\n",
            ),
            late(&["3/2", "-1/2"], true),
        ),
        (shipped("devices/smartknob.toml"), one_pole),
        (
            dimensionless(
                "1.249",
                "2",
                "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/2\"\n",
            ),
            late(&["3/2", "-1/2"], false),
        ),
        (
            dimensionless(
                "4",
                "1",
                "[controller]\nnumerator = [\"0.5\", \"-1\", \"1.2\", \"0.4\"]\n",
            ),
            Law::of(&["0.5", "-1", "1.2", "0.4"]),
        ),
        (
            dimensionless("9", "0.4", "[sampling]\nlatency = \"0.3\"\n"),
            Law {
                latency: q("0.3"),
                ..Law::of(&["1"])
            },
        ),
        (
            study(smooth),
            Law {
                encoder: false,
                ..Law::of(&["1"])
            },
        ),
        // Too long to write down: a formula.
        (
            dimensionless("1.49999", "2", "[sampling]\ndelay = 1\n"),
            late(&["1"], false),
        ),
    ];
    let mut lengths = Vec::new();
    for (study, law) in cases {
        let report = study.report().clone();
        let text = said(&report.to_text());
        let unit = if law.encoder { "ticks" } else { "m" };
        let witness = report.witness.as_ref().expect("a witness");
        let positions = positions(&text, unit, &witness.positions);
        lengths.push(positions.len());
        let zero = q("0");
        let sigma = report.sigma.as_ref().map(|sigma| sigma.hi());
        // K = 1 N/m without an encoder: σ is the force.
        let coulomb = q("1/10");
        let sigma = sigma.unwrap_or(if law.encoder { &zero } else { &coulomb });
        let gain = law.gain(&positions, report.beta.hi(), sigma);
        let energy = between(&text, "draws at least ", ", if friction");
        // In KΔ² where there is a Δ, which may stand in brackets behind the joules.
        let energy = energy.rsplit('(').next().expect("an energy");
        let printed = energy.split(' ').next().expect("a number");
        assert!(
            energy.contains(if law.encoder { "KΔ²" } else { "J" }),
            "{text}"
        );
        assert!(
            q(printed).is_positive() && q(printed) <= gain,
            "{text}: {gain}"
        );
        if !text.starts_with("repeat") {
            assert_eq!(printed, rounded(&gain, 5, Rounding::Down), "{text}");
        }
        // Nobody says anything else, nor rests it on another theorem.
        assert_eq!(said(&study.explanation.to_text()), text);
        let line = study.explanation.line(Step::Witness).expect("a line");
        assert_eq!(Some(&line.id), report.because.first());
        let case = case(study);
        let [argument] = &case.arguments[..] else {
            panic!("one scene")
        };
        let counter = argument.node("CG-cycle").expect("a counter goal");
        assert_eq!(said(&counter.text), text);
        let grounds = report.because.iter().map(|id| format!("CSn-{id}"));
        let expected: Vec<String> = std::iter::once("CSn-witness".to_owned())
            .chain(grounds)
            .collect();
        assert_eq!(counter.supported_by, expected);
        let page = page(&case);
        assert!(!page.contains("round trip"), "{page}");
        assert!(page.contains(&format!("Witness: {text}")));
    }
    assert!(
        [2, 4, 6, 2048]
            .iter()
            .all(|length| lengths.contains(length)),
        "{lengths:?}"
    );
}
