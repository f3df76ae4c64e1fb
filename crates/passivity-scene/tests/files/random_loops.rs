//! Random linear loops: what their controllers cost against a grid of frequencies, and what is said of a box
//! against its devices (TH-LTI, TH-LATENCY, TH-LAG).

use num_traits::{Signed as _, Zero as _};
use passivity_core::BigRational;
use passivity_random::draws;
use passivity_scene::Scene;
use passivity_scene::check::{Report, Verdict, check};
use proptest::prelude::*;

use crate::dimensionless::{approx, q, report};

/// A controller whose poles are products of ones inside the unit circle, as texts and in doubles.
fn controllers() -> impl Strategy<Value = (Vec<BigRational>, Vec<BigRational>, u16)> {
    let hundredths = |range: std::ops::RangeInclusive<i64>| {
        range.prop_map(|n| BigRational::new(n.into(), 100.into()))
    };
    let numerator = prop::collection::vec(hundredths(-200..=200), 1..=7);
    let poles = prop::collection::vec(hundredths(-80..=80), 0..=4);
    // 1 − 2r·cos φ·z⁻¹ + r²z⁻² with r² ≤ 0.64.
    let pair = (hundredths(0..=64), hundredths(-99..=99));
    (numerator, poles, prop::option::of(pair), 0..3_u16).prop_map(
        |(numerator, poles, pair, delay)| {
            let mut denominator = vec![q("1")];
            let mut times = |factor: &[BigRational]| {
                let mut product = vec![q("0"); denominator.len() + factor.len() - 1];
                for (i, a) in denominator.iter().enumerate() {
                    for (j, b) in factor.iter().enumerate() {
                        product[i + j] += a * b;
                    }
                }
                denominator = product;
            };
            for pole in poles {
                times(&[q("1"), -pole]);
            }
            if let Some((squared, cosine)) = pair {
                // |2r·cos φ| < 2r ≤ 1 + r²: with half of 1 + r² it is inside.
                times(&[q("1"), cosine * (q("1") + &squared) * q("0.9"), squared]);
            }
            (numerator, denominator, delay)
        },
    )
}

/// λ(θ) = Re[(1 − e^(−iθ))·e^(−ikθ)·H(e^(iθ))]/(2(1 − cos θ)) = ½(Re h − cot(θ/2)·Im h), h = e^(−ikθ)·H, in doubles, and
/// how far off it is at most.
///
/// Angles are below 9π and so within 16ε, the terms of a sum within 20ε of their sizes, and the two parts of a sum within
/// 32ε of the sizes of all together. So h is off by 32ε(Σ|n| + |h|·Σ|d|)/|D| and by its own few roundings, 32ε|h|.
fn lambda_at(theta: f64, n: &[f64], d: &[f64], delay: u16) -> (f64, f64) {
    let sum = |c: &[f64]| {
        c.iter().enumerate().fold((0.0, 0.0), |(re, im), (j, c)| {
            let (sin, cos) = (-theta * j as f64).sin_cos();
            (re + c * cos, im + c * sin)
        })
    };
    let times = |(a, b): (f64, f64), (c, d): (f64, f64)| (a * c - b * d, a * d + b * c);
    let (dr, di) = sum(d);
    let size = dr * dr + di * di;
    let h = times(sum(n), (dr / size, -di / size));
    let (sin, cos) = (-theta * f64::from(delay)).sin_cos();
    let h = times(h, (cos, sin));
    let (sin, cos) = (theta / 2.0).sin_cos();
    let sizes = |c: &[f64]| c.iter().map(|c| c.abs()).sum::<f64>();
    let of_h = h.0.hypot(h.1);
    let off = 32.0 * f64::EPSILON * ((sizes(n) + of_h * sizes(d)) / size.sqrt() + of_h);
    // ½(1 + cot(θ/2)) ≤ 1/sin(θ/2).
    (0.5 * (h.0 - cos / sin * h.1), off / sin)
}

/// The most that |λ″| can be: λ(θ) = ½H(1) + Σ gⱼcos jθ with tail sums gⱼ, so that it is Σ j²|gⱼ|.
fn bend(n: &[f64], d: &[f64], delay: u16) -> f64 {
    // The poles are below 0.9: after 800 samples what is left is below 10⁻³⁰.
    let late = usize::from(delay);
    let mut response: Vec<f64> = Vec::new();
    for j in 0..800_usize {
        let driven = j.checked_sub(late).and_then(|i| n.get(i));
        let past = d.iter().skip(1).zip(response.iter().rev());
        let past: f64 = past.map(|(d, c)| d * c).sum();
        response.push((driven.unwrap_or(&0.0) - past) / d[0]);
    }
    let mut tail = 0.0;
    let from_the_end = response.iter().enumerate().skip(1).rev();
    from_the_end.fold(0.0, |sum, (j, c)| {
        tail += c;
        sum + (j * j) as f64 * f64::abs(tail)
    })
}

/// Σ gain of a motion round its period, by running the difference equation until it repeats.
fn drawn(
    positions: &[BigRational],
    [n, d]: [&[BigRational]; 2],
    delay: u16,
    [beta, sigma]: [f64; 2],
) -> f64 {
    let q: Vec<f64> = positions
        .iter()
        .map(|x| approx(&(x.floor() + BigRational::new(1.into(), 2.into()))))
        .collect();
    let x: Vec<f64> = positions.iter().map(approx).collect();
    let [n, d] = [n, d].map(|c| c.iter().map(approx).collect::<Vec<f64>>());
    let p = q.len();
    // |poles| ≤ 0.9 or so: after 800 samples what was before is below 10⁻³⁰ of it.
    let rounds = 800 / p + 2;
    let mut outputs: Vec<f64> = vec![0.0; rounds * p];
    for h in 0..rounds * p {
        let driven: f64 = n
            .iter()
            .enumerate()
            .map(|(j, c)| c * q[(h + rounds * p - j) % p])
            .sum();
        let past: f64 = (1..d.len())
            .filter(|j| *j <= h)
            .map(|j| d[j] * outputs[h - j])
            .sum();
        outputs[h] = (driven - past) / d[0];
    }
    let last = (rounds - 1) * p;
    (0..p)
        .map(|h| {
            let step = x[(h + 1) % p] - x[h];
            let force = -outputs[last + h - usize::from(delay)];
            force * step - beta * step * step - sigma * step.abs()
        })
        .sum()
}

#[test]
fn random_controllers_cost_the_largest_value_over_all_frequencies() {
    let config = ProptestConfig::with_cases(draws(20));
    let mut runner = proptest::test_runner::TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    let result = runner.run(&controllers(), |(numerator, denominator, delay)| {
        let sum = |c: &[BigRational]| c.iter().fold(BigRational::zero(), |sum, x| sum + x);
        prop_assume!(!sum(&numerator).is_negative());
        let list = |c: &[BigRational]| {
            let texts: Vec<String> = c.iter().map(|x| format!("\"{x}\"")).collect();
            texts.join(", ")
        };
        let sections = format!(
            "[sampling]\ndelay = {delay}\n[controller]\nnumerator = [{}]\ndenominator = [{}]\n",
            list(&numerator),
            list(&denominator)
        );
        let whole = report(&q("1"), "1", &sections);
        let (lo, hi) = (whole.cost.viscous.lo(), whole.cost.viscous.hi());
        let [n, d] = [&numerator, &denominator].map(|c| c.iter().map(approx).collect::<Vec<f64>>());
        let angles = (1..=4000).map(|i| std::f64::consts::PI * f64::from(i) / 4000.0);
        let grid: Vec<_> = angles
            .map(|theta| lambda_at(theta, &n, &d, delay))
            .collect();
        let most = |side: f64| {
            let values = grid.iter().map(|(value, off)| value + side * off);
            values.fold(f64::NEG_INFINITY, f64::max)
        };
        let size: f64 =
            n.iter().map(|c| c.abs()).sum::<f64>() / d.iter().sum::<f64>().abs().min(1.0);
        let [least, most] = [most(-1.0), most(1.0)];
        prop_assert!(approx(hi) >= least, "{} {least}", approx(hi));
        // The largest value is at most a step from an angle of the grid, as it is at θ = 0, and λ′ is 0
        // there: the grid misses it by at most |λ″|(π/4000)²/2.
        let missed = bend(&n, &d, delay) * (std::f64::consts::PI / 4000.0).powi(2) / 2.0;
        prop_assert!(
            approx(lo) <= most + missed,
            "{} {most} {missed}",
            approx(lo)
        );
        // 10⁻⁴ on both sides, with as much Coulomb friction as is asked for.
        let sigma = whole.cost.coulomb.hi().clone() + q("1");
        let verdict = |beta: BigRational| report(&beta, &sigma.to_string(), &sections);
        let above = hi.clone() + q("1e-4");
        prop_assume!(above.is_positive());
        prop_assert_eq!(verdict(above).verdict, Verdict::Passive);
        let beta = lo - q("1e-4");
        if beta.is_positive() {
            let below = verdict(beta.clone());
            prop_assert_eq!(below.verdict, Verdict::NotPassive);
            let witness = below.witness.unwrap();
            if witness.wave.is_none() {
                let friction = [approx(&beta), approx(&sigma)];
                let lists = [numerator.as_slice(), denominator.as_slice()];
                let again = drawn(&witness.positions, lists, delay, friction);
                let said = approx(&witness.gain_per_cycle);
                // Doubles: each term is rounded to 2⁻⁵³ of the squares that the sum is made of.
                let x: Vec<f64> = witness.positions.iter().map(approx).collect();
                let squares: f64 = x.iter().map(|x| x * x).sum();
                prop_assert!(
                    (again - said).abs() < 1e-9 * (1.0 + squares) * (1.0 + size),
                    "{again} {said}"
                );
            }
        }
        Ok(())
    });
    result.unwrap();
}

/// A linear device of which some parameters have tolerances: key, value in thousandths of its unit, and
/// percent.
type Toleranced = Vec<(&'static str, i64, i64)>;

fn toleranced() -> impl Strategy<Value = (Toleranced, Vec<i64>)> {
    let percent = || prop::sample::select(vec![0_i64, 0, 2, 10]);
    let of =
        |key: &'static str, range: std::ops::RangeInclusive<i64>| (Just(key), range, percent());
    let some = |key, range| prop::option::of(of(key, range));
    let required = (
        of("viscous", 500..=4000),
        of("coulomb", 300..=3000),
        of("period", 900..=1100),
        of("stiffness", 900..=1100),
    );
    let optional = (
        some("damping", 100..=1500),
        some("damping_time_constant", 100..=2000),
        some("latency", 50..=1500),
        some("time_constant", 50..=1500),
    );
    let places = prop::collection::vec(-4..=4_i64, 8);
    (required, optional, places).prop_map(|((b, c, t, k), (damping, filter, late, lag), places)| {
        let mut all = vec![b, c, t, k];
        let filter = filter.filter(|_| damping.is_some());
        all.extend([damping, filter, late, lag].into_iter().flatten());
        (all, places)
    })
}

/// The scene where each value is at `place`/4 of its tolerance, or with its tolerances.
fn device(parameters: &Toleranced, places: Option<&[i64]>, delay: u16) -> Report {
    let value = |key: &str| {
        let index = parameters.iter().position(|(k, ..)| *k == key)?;
        let (_, thousandths, percent) = parameters[index];
        let unit = match key {
            "viscous" | "damping" => "N s/m",
            "coulomb" => "N",
            "stiffness" => "N/m",
            _ => "s",
        };
        let text = match places {
            None => format!("{thousandths}/1000 {unit} ± {percent}%"),
            Some(places) => {
                let share = places[index % places.len()] * percent;
                let exact = BigRational::new((thousandths * (400 + share)).into(), 400_000.into());
                format!("{exact} {unit}")
            }
        };
        Some(format!("{key} = \"{text}\"\n"))
    };
    let section = |name: &str, keys: &[&str]| {
        let lines: String = keys.iter().filter_map(|key| value(key)).collect();
        if lines.is_empty() {
            String::new()
        } else {
            format!("[{name}]\n{lines}")
        }
    };
    let text = section("device", &["viscous", "coulomb"])
        + &section("sampling", &["period", "latency"])
        + &format!("delay = {delay}\n[encoder]\nresolution = \"1 m\"\n")
        + &section("wall", &["stiffness", "damping", "damping_time_constant"])
        + &section("amplifier", &["time_constant"]);
    check(&Scene::from_toml("device", &text).unwrap_or_else(|error| panic!("{error}\n{text}")))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(6)))]

    /// What is said of all devices within the tolerances is so of each: at corners and inside.
    #[test]
    fn what_is_said_of_a_box_is_so_of_its_devices(
        (parameters, places) in toleranced(),
        delay in 0..3_u16,
    ) {
        let whole = device(&parameters, None, delay).verdict;
        for turn in 0..6 {
            let mut at = places.clone();
            at.rotate_left(turn);
            // Corners in the even turns.
            if turn % 2 == 0 {
                at = at.iter().map(|place| if *place < 0 { -4 } else { 4 }).collect();
            }
            let one = device(&parameters, Some(&at), delay).verdict;
            match whole {
                Verdict::Passive => prop_assert_eq!(one, Verdict::Passive),
                Verdict::NotPassive => prop_assert_eq!(one, Verdict::NotPassive),
                Verdict::NotGuaranteed => prop_assert_ne!(one, Verdict::Passive),
                Verdict::Depends => {}
                Verdict::NotCovered => prop_assert!(false, "all of it is covered"),
            }
        }
    }
}
