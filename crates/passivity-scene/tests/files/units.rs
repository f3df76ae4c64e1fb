//! Units as data sheets write them.

use passivity_core::BigRational;
use passivity_scene::number;
use passivity_scene::units::{Dimension, Unit};
use proptest::prelude::*;

fn number(text: &str) -> BigRational {
    number::parse(text).unwrap()
}

#[test]
fn every_spelling_has_its_exact_factor_and_dimension() {
    let viscous = Dimension::new(1, 2, -1, -1);
    let torque = Dimension::new(1, 2, -2, 0);
    let stiffness = Dimension::new(1, 2, -2, -1);
    let cases = [
        ("N m s/rad", "1", 0, viscous),
        ("N*m*s/rad", "1", 0, viscous),
        ("N·m·s·rad⁻¹", "1", 0, viscous),
        ("N m s rad^-1", "1", 0, viscous),
        ("N m/(rad/s)", "1", 0, viscous),
        ("kg m^2/s/rad", "1", 0, viscous),
        ("mN m s/rad", "1e-3", 0, viscous),
        ("mNm sec/rad", "1e-3", 0, viscous),
        ("N m/rpm", "30", -1, viscous),
        ("N m", "1", 0, torque),
        ("Nm", "1", 0, torque),
        ("Ncm", "0.01", 0, torque),
        ("N mm", "1e-3", 0, torque),
        ("ozf in", "0.00706155181422604375", 0, torque),
        ("lbf in", "0.1129848290276167", 0, torque),
        ("kgf cm", "0.0980665", 0, torque),
        ("N m/rad", "1", 0, stiffness),
        ("N m/deg", "180", -1, stiffness),
        ("mN m / deg", "0.18", -1, stiffness),
        ("kg m^2", "1", 0, Dimension::new(1, 2, 0, 0)),
        ("kg m²", "1", 0, Dimension::new(1, 2, 0, 0)),
        ("kg m2", "1", 0, Dimension::new(1, 2, 0, 0)),
        ("g cm^2", "1e-7", 0, Dimension::new(1, 2, 0, 0)),
        ("N/mm", "1000", 0, Dimension::new(1, 0, -2, 0)),
        ("N/m", "1", 0, Dimension::new(1, 0, -2, 0)),
        ("kN s/m", "1000", 0, Dimension::new(1, 0, -1, 0)),
        ("N/(m/s)", "1", 0, Dimension::new(1, 0, -1, 0)),
        ("mm", "1e-3", 0, Dimension::new(0, 1, 0, 0)),
        ("µm", "1e-6", 0, Dimension::new(0, 1, 0, 0)),
        ("μm", "1e-6", 0, Dimension::new(0, 1, 0, 0)),
        ("um", "1e-6", 0, Dimension::new(0, 1, 0, 0)),
        ("in", "0.0254", 0, Dimension::new(0, 1, 0, 0)),
        ("ms", "1e-3", 0, Dimension::new(0, 0, 1, 0)),
        ("min", "60", 0, Dimension::new(0, 0, 1, 0)),
        ("kHz", "1000", 0, Dimension::new(0, 0, -1, 0)),
        ("1/s", "1", 0, Dimension::new(0, 0, -1, 0)),
        ("/s", "1", 0, Dimension::new(0, 0, -1, 0)),
        ("rad", "1", 0, Dimension::new(0, 0, 0, 1)),
        ("mrad", "1e-3", 0, Dimension::new(0, 0, 0, 1)),
        ("deg", "1/180", 1, Dimension::new(0, 0, 0, 1)),
        ("°", "1/180", 1, Dimension::new(0, 0, 0, 1)),
        ("rev", "2", 1, Dimension::new(0, 0, 0, 1)),
        ("turn", "2", 1, Dimension::new(0, 0, 0, 1)),
        ("gon", "1/200", 1, Dimension::new(0, 0, 0, 1)),
        ("MN/km", "1000", 0, Dimension::new(1, 0, -2, 0)),
        ("arcsec", "1/648000", 1, Dimension::new(0, 0, 0, 1)),
        ("rpm", "1/30", 1, Dimension::new(0, 0, -1, 1)),
        ("rev/min", "1/30", 1, Dimension::new(0, 0, -1, 1)),
        ("rad/s", "1", 0, Dimension::new(0, 0, -1, 1)),
        ("m / s", "1", 0, Dimension::new(0, 1, -1, 0)),
    ];
    for (text, scale, pi, dimension) in cases {
        let unit = Unit::parse(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(*unit.scale(), number(scale), "{text}");
        assert_eq!(unit.pi_power(), pi, "{text}");
        assert_eq!(unit.dimension(), dimension, "{text}");
    }
}

#[test]
fn what_is_no_unit_is_refused_with_its_place() {
    let cases = [
        ("", 0..0, "expected a unit here, found nothing"),
        ("N foo", 2..5, "unknown unit `foo`"),
        (
            "N m/Grad",
            4..8,
            "`Grad` may be degrees or gradians: write `deg` or `gon`",
        ),
        (
            "grad/s",
            0..4,
            "`grad` may be degrees or gradians: write `deg` or `gon`",
        ),
        ("N m//s", 4..5, "expected a unit here, found `/`"),
        ("N m/", 4..4, "expected a unit here, found nothing"),
        ("N^", 1..2, "expected a whole number as the power"),
        ("m^10", 1..4, "a power may be at most 9"),
        ("(N m", 0..1, "this parenthesis is not closed"),
        ("N m)", 3..4, "`)` cannot stand here in a unit"),
        ("N, m", 1..2, "expected a unit here, found `,`"),
        (
            "Nm^2",
            0..4,
            "it is not clear which unit the power belongs to",
        ),
        (
            "N m/rad s",
            8..9,
            "it is not clear whether what follows `/…` is multiplied or divided by",
        ),
        ("deg^3", 0..5, "the powers in this unit are too large"),
        ("m^2.5", 3..4, "expected a unit here, found `.`"),
        // Uncertain digits are no factor of the unit: left out they would make an uncertain value exact.
        (
            "(12) mN m",
            0..4,
            "expected a unit in these parentheses, found `12`",
        ),
        (
            "(1) mN m",
            0..3,
            "expected a unit in these parentheses, found `1`",
        ),
        (
            "mN (1) m",
            3..6,
            "expected a unit in these parentheses, found `1`",
        ),
        (
            "m(1",
            1..3,
            "expected a unit in these parentheses, found `1`",
        ),
        ("N 1 m", 2..3, "expected a unit here, found `1`"),
        ("N\0m", 1..2, "expected a unit here, found `\\0`"),
        ("N ±", 2..4, "expected a unit here, found `±`"),
    ];
    for (text, span, message) in cases {
        let error = Unit::parse(text).expect_err(text);
        assert_eq!(
            (error.span(), error.to_string().as_str()),
            (span, message),
            "{text}"
        );
    }
    assert!(Unit::parse(&"m ".repeat(200)).is_err());
    assert!(Unit::parse(&"(".repeat(150)).is_err());
    assert!(Unit::parse(&"m^9 ".repeat(40)).is_err());
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,12}|[Nmkgsrad/^()*· 1-3²⁻-]{0,16}") {
        if let Err(error) = Unit::parse(&text) {
            let span = error.span();
            prop_assert!(span.end <= text.len() && text.get(span).is_some());
        }
    }
}
