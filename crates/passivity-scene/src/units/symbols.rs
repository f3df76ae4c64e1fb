//! The symbols of units and their SI prefixes.

use num_bigint::BigInt;
use num_traits::Pow;
use passivity_core::BigRational;

use super::{Dimension, Unit};

/// A symbol: n/d·π^pi in SI units.
struct Symbol {
    name: &'static str,
    n: i64,
    d: i64,
    pi: i8,
    dimension: Dimension,
    /// Whether SI prefixes go with it.
    prefixed: bool,
}

const MASS: Dimension = Dimension::new(1, 0, 0, 0);
const LENGTH: Dimension = Dimension::new(0, 1, 0, 0);
const TIME: Dimension = Dimension::new(0, 0, 1, 0);
const FREQUENCY: Dimension = Dimension::new(0, 0, -1, 0);
const ANGLE: Dimension = Dimension::new(0, 0, 0, 1);
const ANGULAR_SPEED: Dimension = Dimension::new(0, 0, -1, 1);
const FORCE: Dimension = Dimension::new(1, 1, -2, 0);
const TORQUE: Dimension = Dimension::new(1, 2, -2, 0);

const SYMBOLS: [Symbol; 35] = [
    si("g", 1, 1000, MASS),
    si("m", 1, 1, LENGTH),
    si("s", 1, 1, TIME),
    si("sec", 1, 1, TIME),
    si("N", 1, 1, FORCE),
    si("Hz", 1, 1, FREQUENCY),
    si("rad", 1, 1, ANGLE),
    // As data sheets write them: newton-metre, newton-centimetre, newton-millimetre.
    si("Nm", 1, 1, TORQUE),
    plain("Ncm", 1, 100, 0, TORQUE),
    plain("Nmm", 1, 1000, 0, TORQUE),
    plain("min", 60, 1, 0, TIME),
    si("deg", 1, 180, ANGLE).times_pi(),
    plain("°", 1, 180, 1, ANGLE),
    plain("gon", 1, 200, 1, ANGLE),
    plain("arcmin", 1, 10_800, 1, ANGLE),
    plain("arcsec", 1, 648_000, 1, ANGLE),
    plain("rev", 2, 1, 1, ANGLE),
    plain("turn", 2, 1, 1, ANGLE),
    plain("rpm", 1, 30, 1, ANGULAR_SPEED),
    plain("krpm", 1000, 30, 1, ANGULAR_SPEED),
    plain("rps", 2, 1, 1, ANGULAR_SPEED),
    // Exact by definition: international inch, foot and pound (1959), standard gravity (1901).
    plain("in", 254, 10_000, 0, LENGTH),
    plain("inch", 254, 10_000, 0, LENGTH),
    plain("ft", 3048, 10_000, 0, LENGTH),
    plain("lb", 45_359_237, 100_000_000, 0, MASS),
    plain("oz", 45_359_237, 1_600_000_000, 0, MASS),
    plain("lbf", 44_482_216_152_605, 10_000_000_000_000, 0, FORCE),
    plain("ozf", 44_482_216_152_605, 160_000_000_000_000, 0, FORCE),
    si("gf", 980_665, 100_000_000, FORCE),
    // Spelt out.
    plain("metre", 1, 1, 0, LENGTH),
    plain("meter", 1, 1, 0, LENGTH),
    plain("second", 1, 1, 0, TIME),
    plain("newton", 1, 1, 0, FORCE),
    plain("radian", 1, 1, 0, ANGLE),
    plain("degree", 1, 180, 1, ANGLE),
];

const fn si(name: &'static str, n: i64, d: i64, dimension: Dimension) -> Symbol {
    Symbol {
        prefixed: true,
        ..plain(name, n, d, 0, dimension)
    }
}

const fn plain(name: &'static str, n: i64, d: i64, pi: i8, dimension: Dimension) -> Symbol {
    Symbol {
        name,
        n,
        d,
        pi,
        dimension,
        prefixed: false,
    }
}

impl Symbol {
    const fn times_pi(self) -> Self {
        Self { pi: 1, ..self }
    }

    fn unit(&self, power_of_ten: i32) -> Unit {
        let ten = BigRational::from_integer(BigInt::from(10));
        let own = BigRational::new(self.n.into(), self.d.into());
        Unit {
            scale: own * Pow::pow(&ten, power_of_ten),
            pi: self.pi,
            dimension: self.dimension,
        }
    }
}

/// SI prefixes; µ is the micro sign, the Greek letter or a u.
const PREFIXES: [(&str, i32); 18] = [
    ("da", 1),
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("\u{b5}", -6),
    ("\u{3bc}", -6),
    ("u", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
    ("P", 15),
    ("a", -18),
    ("E", 18),
];

/// The unit that a symbol stands for, prefix included: an exact name goes before a prefix, so that
/// `min` is a minute. No device has times, ways and angles of millions of their units: what looks like one is another
/// word, as the German `Grad` for degrees, or a unit in letters of another case, as `Ms` and `Mm`.
pub(super) fn find(text: &str) -> Option<Unit> {
    if let Some(symbol) = SYMBOLS.iter().find(|symbol| symbol.name == text) {
        return Some(symbol.unit(0));
    }
    PREFIXES.iter().find_map(|(prefix, power)| {
        let rest = text.strip_prefix(prefix)?;
        let symbol = SYMBOLS.iter().find(|s| s.prefixed && s.name == rest)?;
        let is_word = *power > 3 && [TIME, LENGTH, ANGLE].contains(&symbol.dimension);
        if is_word {
            return None;
        }
        Some(symbol.unit(*power))
    })
}

/// Whether a power after the symbol could be read in two ways, as in `Nm^2`.
pub(super) fn is_compound(text: &str) -> bool {
    find(text).is_some_and(|unit| unit.dimension == TORQUE)
}

/// Whether a word is one of several units: degrees in German, gradians in other languages.
pub(super) fn is_ambiguous(text: &str) -> bool {
    text.eq_ignore_ascii_case("grad")
}

/// The symbols that an unknown one may have been: in letters of another case, one of several, as the weight of a
/// mass, or a product without its spaces.
pub(super) fn meant(text: &str) -> Vec<String> {
    if is_ambiguous(text) {
        return Vec::new();
    }
    let mut meant = in_any_case(text);
    let singular = text.strip_suffix(['s', 'S']).unwrap_or_default();
    let singular = in_any_case(singular).into_iter();
    // `newtons` is a plural, `Ns` and `Nms` are products with seconds.
    meant.extend(singular.filter(|symbol| !symbol.contains('N')));
    let weights = meant.iter().map(|symbol| format!("{symbol}f"));
    let weights: Vec<String> = weights.filter(|symbol| find(symbol).is_some()).collect();
    meant.extend(weights);
    let splits = text.char_indices().skip(1).map(|(at, _)| text.split_at(at));
    let products = splits.filter(|(a, b)| find(a).is_some() && find(b).is_some());
    meant.extend(products.map(|(a, b)| format!("{a} {b}")));
    meant
}

/// The symbols that have these letters in any case.
fn in_any_case(text: &str) -> Vec<String> {
    if find(text).is_some() {
        return vec![text.to_owned()];
    }
    let prefixed = SYMBOLS.iter().filter(|symbol| symbol.prefixed);
    let prefixed = prefixed.flat_map(|symbol| {
        let prefixes = PREFIXES.iter();
        prefixes.map(|(prefix, _)| format!("{prefix}{}", symbol.name))
    });
    let mut found: Vec<String> = SYMBOLS
        .iter()
        .map(|symbol| symbol.name.to_owned())
        .chain(prefixed)
        .filter(|symbol| symbol.eq_ignore_ascii_case(text) && find(symbol).is_some())
        .collect();
    // A capital M is mega where that is a unit, as in `MHZ`; of `mhz` nothing says whether it is milli or mega.
    let keeps = |symbol: &String| symbol.chars().next() == text.chars().next();
    if text.contains(char::is_uppercase) && found.iter().any(keeps) {
        found.retain(keeps);
    }
    found
}
