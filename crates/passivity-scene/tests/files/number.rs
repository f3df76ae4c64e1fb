//! Exact literals, their JSON form and the nearest double.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use passivity_core::{BigRational, Interval};
use passivity_scene::json;
use passivity_scene::number::{MAX_CHARS, MAX_EXPONENT, nearest_f64, parse};
use proptest::prelude::*;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

#[test]
fn every_spelling_of_a_number_is_read() {
    let cases = [
        ("3/8", 3, 8),
        ("6/16", 3, 8),
        ("0.375", 3, 8),
        ("3.75e-1", 3, 8),
        ("3.75E-1", 3, 8),
        ("0.00375e+2", 3, 8),
        ("-2", -2, 1),
        ("+1", 1, 1),
        ("-3/8", -3, 8),
        ("0", 0, 1),
        ("-0", 0, 1),
        ("0/5", 0, 1),
        ("0.000", 0, 1),
        (".5", 1, 2),
        ("5.", 5, 1),
        ("1500e-2", 15, 1),
        ("1e3", 1000, 1),
        ("0.008", 1, 125),
        ("1.28e-2", 8, 625),
        ("250e-3", 1, 4),
        ("1e0000000000000000003", 1000, 1),
    ];
    for (text, n, d) in cases {
        assert_eq!(parse(text), Ok(ratio(n, d)), "{text}");
    }
}

#[test]
fn what_is_no_number_is_refused_with_its_place() {
    let cases = [
        ("", "empty_number", 0),
        ("NaN", "not_finite", 0),
        ("-inf", "not_finite", 1),
        ("Infinity", "not_finite", 0),
        ("1/0", "zero_denominator", 2),
        ("-12/000", "zero_denominator", 4),
        ("1/", "malformed_number", 1),
        ("1/-2", "malformed_number", 1),
        ("1.5/2", "malformed_number", 3),
        ("1/2/3", "malformed_number", 3),
        ("1e", "malformed_number", 1),
        ("1e+", "malformed_number", 1),
        ("1 000", "malformed_number", 1),
        (" 1", "malformed_number", 0),
        ("1_000", "malformed_number", 1),
        ("--1", "malformed_number", 1),
        (".", "malformed_number", 0),
        ("0x10", "malformed_number", 1),
        ("١", "malformed_number", 0),
        ("1\0", "malformed_number", 1),
        ("1e4097", "exponent_too_large", 2),
        ("1e-999999999", "exponent_too_large", 2),
        ("1e99999999999999999999", "exponent_too_large", 2),
    ];
    for (text, kind, at) in cases {
        let error = parse(text).expect_err(text);
        assert_eq!((error.kind().name(), error.at()), (kind, at), "{text:?}");
        assert!(!error.to_string().is_empty());
    }
}

#[test]
fn bounds_hold_to_the_last_character() {
    let longest = "9".repeat(MAX_CHARS);
    assert!(parse(&longest).is_ok());
    let error = parse(&format!("{longest}9")).unwrap_err();
    assert_eq!(
        (error.kind().name(), error.at()),
        ("number_too_long", MAX_CHARS)
    );
    let tenth = BigRational::new(1.into(), BigInt::from(10).pow(MAX_EXPONENT));
    assert_eq!(parse(&format!("1e-{MAX_EXPONENT}")), Ok(tenth));
    // A megabyte of digits is refused before it is read as a number.
    let error = parse(&"1".repeat(1 << 20)).unwrap_err();
    assert_eq!(error.kind().name(), "number_too_long");
}

#[test]
fn json_takes_numbers_as_the_decimals_they_spell() {
    let read = |text: &str| json::read_rational(&serde_json::from_str(text).unwrap());
    assert_eq!(read("0.1"), Ok(ratio(1, 10)));
    assert_eq!(read("1E-2"), Ok(ratio(1, 100)));
    assert_eq!(read("\"-3/8\""), Ok(ratio(-3, 8)));
    assert_eq!(
        read("0.1000000000000000000000000000001").unwrap() - ratio(1, 10),
        parse("1e-31").unwrap()
    );
    for refused in ["null", "true", "[1]", "{}", "\"NaN\"", "1e999999999"] {
        assert!(read(refused).is_err(), "{refused}");
    }
}

#[test]
fn intervals_past_the_doubles_have_no_approximation() {
    let huge = Interval::point(parse("1e400").unwrap());
    assert!(json::interval(&huge)["approx"].is_null());
    let tiny = Interval::point(parse("-1e-400").unwrap());
    assert_eq!(json::interval(&tiny)["approx"].as_f64(), Some(0.0));
    let third = Interval::hull(ratio(1, 4), ratio(5, 12));
    let expected = serde_json::json!({"lo": "1/4", "hi": "5/12", "approx": 1.0 / 3.0});
    assert_eq!(json::interval(&third), expected);
    assert_eq!(json::read_interval(&json::interval(&third)), Ok(third));
    let backwards = serde_json::json!({"lo": "2", "hi": "1"});
    assert!(json::read_interval(&backwards).is_err());
}

/// The exact value of a finite double.
fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

/// The next double above a finite one.
fn above(x: f64) -> f64 {
    match x.to_bits() {
        _ if x == 0.0 => f64::from_bits(1),
        bits if x > 0.0 => f64::from_bits(bits + 1),
        bits => f64::from_bits(bits - 1),
    }
}

fn below(x: f64) -> f64 {
    -above(-x)
}

/// Asserts that no double is nearer to `x`, and that a tie went to the even one.
fn assert_nearest(x: &BigRational) {
    let got = nearest_f64(x);
    let limit = exact(f64::MAX) + exact((f64::MAX - below(f64::MAX)) / 2.0);
    if x.abs() >= limit {
        assert!(got.is_infinite(), "{x}");
        assert_eq!(got > 0.0, x.is_positive());
        return;
    }
    assert!(got.is_finite(), "{x}");
    let error = (exact(got) - x).abs();
    for neighbour in [above(got), below(got)] {
        if neighbour.is_finite() {
            let other = (exact(neighbour) - x).abs();
            assert!(
                error < other || (error == other && got.to_bits() & 1 == 0),
                "{x}"
            );
        }
    }
}

#[test]
fn the_nearest_double_is_right_at_every_edge() {
    let edges = [
        f64::MIN_POSITIVE,
        below(f64::MIN_POSITIVE),
        5e-324,
        1e-323,
        f64::MAX,
        below(f64::MAX),
        1.0,
        below(1.0),
        9_007_199_254_740_992.0,
        0.1,
    ];
    for edge in edges {
        assert_eq!(nearest_f64(&exact(edge)), edge);
        assert_eq!(nearest_f64(&-exact(edge)), -edge);
        let gap = exact(edge) - exact(below(edge));
        for (n, d) in [
            (1, 2),
            (1, 3),
            (2, 3),
            (1, 1),
            (3, 2),
            (1, 1000),
            (999, 1000),
        ] {
            assert_nearest(&(exact(edge) + &gap * ratio(n, d)));
            assert_nearest(&(exact(edge) - &gap * ratio(n, d)));
        }
    }
    assert_eq!(nearest_f64(&BigRational::zero()).to_bits(), 0);
    assert!(nearest_f64(&parse("1e4096").unwrap()).is_infinite());
    assert_eq!(nearest_f64(&parse("1e-4096").unwrap()), 0.0);
}

proptest! {
    #[test]
    fn a_decimal_read_back_agrees_with_the_standard_library(
        digits in "[0-9]{1,25}", decimals in "[0-9]{0,25}", exponent in -330_i32..310, minus: bool,
    ) {
        let sign = if minus { "-" } else { "" };
        let text = format!("{sign}{digits}.{decimals}e{exponent}");
        let value = parse(&text).unwrap();
        // Both round correctly, so they must agree to the last bit; zero keeps no sign here.
        let expected: f64 = text.parse().unwrap();
        prop_assert_eq!(nearest_f64(&value), expected);
        prop_assert_eq!(parse(&value.to_string()), Ok(value));
    }

    #[test]
    fn a_decimal_is_in_lowest_terms(digits in "[0-9]{1,40}", exponent in -60_i32..60) {
        let value = parse(&format!("{digits}e{exponent}")).unwrap();
        let n: BigInt = digits.parse().unwrap();
        let ten = ratio(10, 1);
        let expected = BigRational::from_integer(n) * num_traits::Pow::pow(&ten, exponent);
        prop_assert_eq!(value.numer(), expected.numer());
        prop_assert_eq!(value.denom(), expected.denom());
    }

    #[test]
    fn no_double_is_nearer(n: i128, d in 1_i128.., shift in 0_u32..1300, down: bool) {
        let power = BigInt::from(1) << shift;
        let x = BigRational::new(n.into(), d.into());
        assert_nearest(&if down { x / power } else { x * power });
    }

    #[test]
    fn a_double_is_its_own_nearest(bits: u64) {
        let x = f64::from_bits(bits);
        if x.is_finite() {
            prop_assert_eq!(nearest_f64(&exact(x)), x);
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,12}|[0-9+\\-./eE]{0,12}") {
        if let Err(error) = parse(&text) {
            prop_assert!(error.at() <= text.len());
        }
    }
}
