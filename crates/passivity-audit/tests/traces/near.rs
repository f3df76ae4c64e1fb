//! Long logs are accounted for in doubles: the answers are those of exact numbers, and the sums enclose
//! theirs.

use std::fmt::Write as _;

use num_traits::{Signed as _, Zero as _};
use passivity_audit::{Ledger, Logged, Number, Options, Reading, Verdict, audit_csv, rows::Form};
use passivity_core::{BigRational, Truth};
use passivity_random::draws;
use passivity_scene::Scene;
use proptest::prelude::*;

/// A motor with an encoder whose tick is a rational part of a millimetre.
const LINEAR: &str = "[device]\nviscous = \"0.4 N s/m\"\ncoulomb = \"0.02 N ± 5%\"\n[sampling]\nrate = \"1 kHz\"\n\
                      [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1 N/mm\"\n";

/// One whose tick has π in it.
const ROTARY: &str = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\nperiod = \"1 ms\"\n\
                      [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"1 N m/rad\"\n";

/// A log that moves, rests now and then, and has an uneven clock and a force near the wall's, late at times.
fn log(seed: u64, rows: usize, header: &str, size: f64, stiffness: f64) -> String {
    let mut state = seed | 1;
    let mut random = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(u32::MAX)
    };
    let (mut text, mut t, mut x) = (format!("{header}\n"), 0_u64, 0.0_f64);
    for i in 0..rows {
        t += 970 + (60.0 * random()) as u64;
        if i % 97 < 80 {
            x += size * (random() - 0.5) - 0.01 * x;
        }
        let force = -stiffness * x * (0.8 + 0.5 * random());
        if header.contains("count") {
            // A tick is 30 µm.
            writeln!(text, "{t},{:.0},{force:.6}", (x / 3e-5).floor()).unwrap();
        } else {
            writeln!(text, "{t},{x:.9},{force:.6}").unwrap();
        }
    }
    text
}

fn audited(text: &str, scene: &Scene, block: usize) -> passivity_audit::Audit {
    let options = Options {
        block,
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(text.as_bytes().to_vec()));
    audit_csv(input, scene, options).unwrap()
}

/// The sums, how often each account was short, and the largest position or force and a tick, of exact rows alone.
fn exactly(text: &str, scene: &Scene) -> ([BigRational; 2], [u64; 2], BigRational) {
    let ledger = Ledger::of_scene(scene);
    let number = |text: &str| Number::parse(text).unwrap();
    let (per_tick, per_force) = (
        BigRational::new(100_000.into(), 3.into()),
        BigRational::new(100.into(), 3.into()),
    );
    let scaled =
        |x: &str, by: &BigRational| Reading::Exact(Number::from(number(x).to_rational() * by));
    let counts = text.starts_with("t [us],count");
    let sample = |x: &str| match counts {
        true => Reading::Count(x.parse().unwrap()),
        false => scaled(x, &per_tick),
    };
    let rows: Vec<Vec<&str>> = text
        .lines()
        .skip(1)
        .map(|l| l.split(',').collect())
        .collect();
    let (mut sums, mut short) = ([BigRational::zero(), BigRational::zero()], [0, 0]);
    let mut largest = BigRational::zero();
    for pair in rows.windows(2) {
        let [from, to] = pair else { unreachable!() };
        let dt = number(to[0]).to_rational() - number(from[0]).to_rational();
        let row = ledger
            .row(&Logged {
                samples: vec![sample(from[1])],
                end: sample(to[1]),
                dtau: Number::from(dt / BigRational::from_integer(1000.into())),
                force: Some(scaled(from[2], &per_force)),
            })
            .unwrap();
        for read in [sample(to[1]), scaled(from[2], &per_force)] {
            let range = read.to_rational();
            let tick = BigRational::from_integer(1.into());
            largest = largest
                .max(range.hi().abs() + tick.clone())
                .max(range.lo().abs() + tick);
        }
        let net = row.net_linear().unwrap();
        sums[0] += net.lo();
        sums[1] += net.hi();
        short[0] += u64::from(row.truths().violates_linear == Truth::Holds);
        short[1] += u64::from(row.truths().violates_linear == Truth::Depends);
    }
    (sums, short, largest)
}

#[test]
fn a_long_log_has_the_answers_of_exact_rows_and_sums_around_theirs() {
    let scene = Scene::from_toml("linear", LINEAR).unwrap();
    for (seed, header) in [
        (1, "t [us],x [m],f [N]"),
        (2, "t [us],x [m],f [N]"),
        (3, "t [us],count,f [N]"),
        (4, "t [us],count,f [N]"),
    ] {
        let text = log(seed, 2500, header, 2e-4, 1000.0);
        let audit = audited(&text, &scene, 0);
        let ([least, most], [short, open], largest) = exactly(&text, &scene);
        let totals = audit.totals();
        assert_eq!(totals.violates_linear, Some(short));
        assert_eq!(totals.depends_linear, Some(open));
        let net = totals.net_linear.as_ref().unwrap();
        let (lo, hi) = (net.lo(), net.hi());
        assert!(*lo <= least && most <= *hi);
        // A row has some thirty operations on energies, each off by 2⁻⁵² of its result: of two factors that are
        // twice the largest position or force, a tick included, at the most.
        let energy = &largest * &largest * BigRational::from_integer(4.into());
        let off = energy * BigRational::new((2500_i64 * 32).into(), (1_i64 << 52).into());
        assert!(&least - lo <= off && hi - &most <= off);
        assert!(!totals.generated_linear.as_ref().unwrap().is_exact());
    }
    let short = audited(&log(1, 900, "t [us],x [m],f [N]", 2e-4, 1000.0), &scene, 0);
    assert!(short.totals().generated_linear.as_ref().unwrap().is_exact());
}

/// π, cut off after thirty decimals.
fn pi() -> BigRational {
    let digits = "3141592653589793238462643383279/1000000000000000000000000000000";
    Number::parse(digits).unwrap().to_rational()
}

/// The row as it is written between two positions that are known, under a force that is.
fn written(
    ledger: &Ledger,
    positions: [&BigRational; 2],
    dtau: BigRational,
    force: &BigRational,
) -> String {
    let exact = |x: &BigRational| Reading::Exact(Number::from(x.clone()));
    let [start, end] = positions.map(exact);
    let row = ledger.row(&Logged {
        samples: vec![start],
        end,
        dtau: Number::from(dtau),
        force: Some(exact(force)),
    });
    let form = Form {
        enclosures: true,
        force: true,
        accounted: true,
    };
    let mut text = Vec::new();
    form.write_positions(row.as_ref().unwrap(), &mut text)
        .unwrap();
    form.write_account(row.as_ref().unwrap(), &mut text)
        .unwrap();
    String::from_utf8(text).unwrap()
}

#[test]
fn a_row_that_is_written_encloses_that_of_positions_known_more_closely() {
    let scene = Scene::from_toml("rotary", ROTARY).unwrap();
    let ledger = Ledger::of_scene(&scene);
    let log = log(5, 1200, "t [us],x [rad],f [N m]", 2e-3, 1.0);
    let mut rows = Vec::new();
    let options = Options {
        rows: Some(&mut rows),
        ..Options::default()
    };
    let input = Box::new(std::io::Cursor::new(log.as_bytes().to_vec()));
    let audit = audit_csv(input, &scene, options).unwrap();
    assert!(audit.error().is_none());
    // A tick is π/4096, and its stiffness 1.
    let per_tick = BigRational::from_integer(4096.into()) / pi();
    let number = |text: &str| Number::parse(text).unwrap().to_rational();
    let samples: Vec<[BigRational; 3]> = log
        .lines()
        .skip(1)
        .map(|line| {
            let read: Vec<_> = line.split(',').map(number).collect();
            [
                &read[0] / BigRational::from_integer(1000.into()),
                &read[1] * &per_tick,
                &read[2] * &per_tick,
            ]
        })
        .collect();
    let text = String::from_utf8(rows).unwrap();
    assert_eq!(text.lines().count(), samples.len());
    // π is off by 10⁻³⁰; positions and forces are below 100, margins below 10⁵ of what they are made of.
    let off = number("1e-20");
    let width = BigRational::new(1.into(), (1_i64 << 30).into());
    for (line, pair) in text.lines().skip(1).zip(samples.windows(2)) {
        let [[from, start, force], [to, end, _]] = pair else {
            unreachable!()
        };
        assert!(start.abs() < BigRational::from_integer(100.into()));
        let expected = written(&ledger, [start, end], to - from, force);
        let (_, found) = line.split_once(',').unwrap();
        let fields = |text: &str| {
            text.trim_end()
                .trim_start_matches(',')
                .split(',')
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        let (found, expected) = (fields(found), fields(&expected));
        assert_eq!(found.len(), expected.len());
        let mut i = 0;
        while i < found.len() {
            // How long it lasts, and the answers, are one field each.
            if i == 4 || (21..24).contains(&i) || found[i].is_empty() {
                assert_eq!(found[i], expected[i], "field {i} of {line}");
                i += 1;
                continue;
            }
            let ([lo, hi], [least, most]) = (
                [number(&found[i]), number(&found[i + 1])],
                [number(&expected[i]), number(&expected[i + 1])],
            );
            assert!(
                lo <= &most + &off && &least - &off <= hi,
                "field {i} of {line}"
            );
            assert!(hi - lo <= most - least + &width, "field {i} of {line}");
            i += 2;
        }
    }
}

#[test]
fn the_report_does_not_depend_on_how_a_log_is_cut() {
    for (scene, header, size, stiffness) in [
        (LINEAR, "t [us],x [m],f [N]", 2e-4, 1000.0),
        (LINEAR, "t [us],count,f [N]", 2e-4, 1000.0),
        (ROTARY, "t [us],count,f [N m]", 2e-4, 1.0),
        (ROTARY, "t [us],x [rad],f [N m]", 2e-3, 1.0),
        (ROTARY, "t [us],x [deg],f [mN m]", 0.1, 20.0),
    ] {
        let scene = Scene::from_toml("scene", scene).unwrap();
        let text = log(7, 2200, header, size, stiffness);
        let whole = audited(&text, &scene, 0).to_json();
        assert!(whole["error"].is_null(), "{whole}");
        for block in [900, 5000, 20_000] {
            assert_eq!(
                audited(&text, &scene, block).to_json(),
                whole,
                "{header} in blocks of {block}"
            );
        }
    }
}

#[test]
fn a_device_that_rests_generates_nothing_however_little_is_known_of_where() {
    let scene = Scene::from_toml("rotary", ROTARY).unwrap();
    let mut text = "t [us],x [rad],f [N m]\n".to_owned();
    for i in 0..1500 {
        // It rests in the wall, whose force a hand holds, and the clock is uneven.
        writeln!(text, "{},0.0123,-0.0123", 1000 * i + i % 7).unwrap();
    }
    let audit = audited(&text, &scene, 0);
    assert_eq!(audit.verdict(), Verdict::Holds);
    let totals = audit.totals();
    let net = totals.net_linear.as_ref().unwrap();
    assert_eq!(
        (totals.violates_linear, totals.depends_linear),
        (Some(0), Some(0))
    );
    assert!(net.lo().is_zero() && net.hi().is_zero());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(8)))]

    /// Numbers that fit nothing of fixed width are accounted for all the same.
    #[test]
    fn numbers_of_any_size_give_the_same_answers(
        exponents in prop::collection::vec(0..40_i32, 12), seed in 1..1000_u64,
    ) {
        let scene = Scene::from_toml("linear", LINEAR).unwrap();
        let mut text = log(seed, 1010, "t [us],x [m],f [N]", 2e-4, 1000.0);
        let mut t = 2_000_000;
        for (i, exponent) in exponents.iter().enumerate() {
            t += 1000;
            let sign = if i % 2 == 0 { "" } else { "-" };
            writeln!(text, "{t},{sign}3e{},{sign}7e{}", exponent - 20, 20 - exponent).unwrap();
        }
        let audit = audited(&text, &scene, 0);
        let ([least, most], [short, open], _) = exactly(&text, &scene);
        let totals = audit.totals();
        prop_assert_eq!(totals.violates_linear, Some(short));
        prop_assert_eq!(totals.depends_linear, Some(open));
        let net = totals.net_linear.as_ref().unwrap();
        prop_assert!(*net.lo() <= least && most <= *net.hi());
    }
}

#[test]
fn a_long_log_of_positions_is_plotted_as_closely_as_one_of_counts() {
    let scene = Scene::from_toml("rotary", ROTARY).unwrap();
    for header in ["t [us],x [rad],f [N m]", "t [us],count,f [N m]"] {
        let text = log(5, 6000, header, 2e-3, 1.0);
        let options = Options {
            points: true,
            ..Options::default()
        };
        let input = Box::new(std::io::Cursor::new(text.into_bytes()));
        let audit = audit_csv(input, &scene, options).unwrap();
        // At least every 512th part of it; where a block ends it is counted anew, so that two are one.
        let steps = audit.points().windows(2).map(|pair| pair[1].h - pair[0].h);
        let longest = steps.max().unwrap();
        assert!(longest <= 2 * (6000 / 512), "{header}: {longest}");
    }
}

/// Of large counts the potential is too large for the units in which rows are summed up; a row that is looked up may be
/// that of a small count, and a block may end anywhere.
#[test]
fn rows_of_large_counts_are_defined_wherever_a_block_ends() {
    let scene = Scene::from_toml("s", ROTARY).unwrap();
    let mut text = "t [s],count,f [N m]\n".to_owned();
    let (mut t, mut x) = (0.0, 0.0);
    for i in 0..3000_u32 {
        if i % 50 > 15 {
            // Some 200 rad to each side.
            let at = f64::from(i);
            x = 260_000.0 * (0.0082 * at).sin() + 17_000.0 * (0.1413 * at).sin();
        }
        let force = -2e-4 * f64::max(x, 0.0);
        writeln!(text, "{t:.4},{x:.0},{force:.6}").unwrap();
        t += 1e-3 + 1e-4 * f64::from(i * 7 % 3);
    }
    let report = |block| {
        let options = Options {
            block,
            law: true,
            ..Options::default()
        };
        let input = Box::new(std::io::Cursor::new(text.as_bytes().to_vec()));
        let audit = audit_csv(input, &scene, options).unwrap();
        assert!(audit.error().is_none(), "{:?}", audit.error());
        serde_json::to_string(audit.report()).unwrap()
    };
    let whole = report(0);
    assert!(whole.contains("\"intervals\":2999"), "{whole}");
    for block in [300, 4096] {
        assert_eq!(report(block), whole, "block {block}");
    }
}

/// Whether a log of so many rows at rest and then others says the same, whether it is short enough to be computed exactly or not.
fn check_late(scene: &str, header: &str, rest: fn(usize) -> String, then: fn(usize) -> String) {
    let scene = Scene::from_toml("s", scene).unwrap();
    let [early, late] = [900, 1002].map(|rows| {
        let at_rest: Vec<String> = (0..rows).map(rest).collect();
        let text = format!("{header}\n{}\n{}\n", at_rest.join("\n"), then(rows - 1));
        audited(&text, &scene, 0)
    });
    for audit in [&early, &late] {
        assert!(audit.error().is_none(), "{header}: {:?}", audit.error());
    }
    let violated = |audit: &passivity_audit::Audit| {
        let totals = audit.totals();
        (totals.violates_linear, totals.depends_linear)
    };
    assert_eq!(early.verdict(), late.verdict(), "{header}");
    assert_eq!(violated(&early), violated(&late), "{header}");
    // More rows at rest leave more room.
    let [early, late] = [&early, &late].map(|audit| audit.totals().net_linear.as_ref().unwrap());
    assert!(
        late.lo() <= early.hi() && early.lo() <= late.hi(),
        "{header}"
    );
}

/// What has no room in the units in which rows are summed up is for exact numbers: late in a log as at its start.
#[test]
fn rows_of_large_energies_are_accounted_for_late_in_a_log_too() {
    let plain = |beta: &str| format!("[dimensionless]\nbeta = \"{beta}\"\nsigma = \"3/5\"\n");
    let far = |_| "200000,-200000.5".to_owned();
    check_late(&plain("1"), "count,f", |_| "0,-0.5".to_owned(), far);
    let far = |i| format!("{},200000,0", i + 20_000);
    check_late(&plain("1/3"), "tau,count,f", |i| format!("{i},0,-0.5"), far);
    let soon = |i| format!("{i}.000000001,0");
    check_late(&plain("100"), "tau,count", |i| format!("{i},0"), soon);
    // From one saturated part of a wall to the other.
    let saturated = "[device]\nviscous = \"2 N s/m\"\ncoulomb = \"0.5 N\"\n[sampling]\nperiod = \"1 ms\"\n\
        [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"10 N/mm\"\nmax_force = \"2 N\"\n";
    let across = |i| format!("{},-145,2\n{},-145,2", i + 120, i + 121);
    check_late(
        saturated,
        "t [ms],count,f [N]",
        |i| format!("{i},145,-2"),
        across,
    );
}

#[test]
fn what_rests_does_so_however_its_position_is_spelt() {
    let scene = Scene::from_toml("rotary", ROTARY).unwrap();
    let at_rest = ["0.0442", "0.04420", "4.42e-2", "4420e-5", "221/5000"];
    let csv = format!("x [rad]\n{}\n", at_rest.join("\n"));
    let input = Box::new(std::io::Cursor::new(csv.into_bytes()));
    let audit = audit_csv(input, &scene, Options::default()).unwrap();
    assert_eq!(
        audit.report().verdict,
        Verdict::Holds,
        "{}",
        audit.to_text()
    );
}
