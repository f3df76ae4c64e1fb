//! Prints loops and what the kernel says of each, for comparison with the checker that is extracted
//! from Rocq: name, the loop in the words of the checker (`driver.ml`) and the verdict, divided by tabs.
//!
//! The loops are those of the shipped scenes that the checker decides, and random ones, always the
//! same: boxes whose costs have a closed form (`Loop::decide`), and loops with tolerances of friction
//! whose costs have none (`Loop::truth`).

mod computed;
mod random;

use std::error::Error;
use std::io::Write;
use std::path::Path;

use passivity_core::{BigRational, Exact, Interval, Loop, Truth};
use passivity_scene::Scene;

use random::Random;

/// Random boxes.
const BOXES: usize = 10_000;

/// Random loops with computed costs.
const COMPUTED: usize = 8_000;

/// Bits to which an end with π in it is enclosed.
const BITS: u32 = 100;

type Bounds = Loop<Interval<BigRational>>;

fn main() -> Result<(), Box<dyn Error>> {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../scenes");
    let mut files = std::fs::read_dir(scenes)?
        .map(|entry| Ok(entry?.path()))
        .collect::<std::io::Result<Vec<_>>>()?;
    files.retain(|file| file.extension().is_some_and(|e| e == "toml"));
    files.sort();
    let mut out = std::io::stdout().lock();
    for file in files {
        let stem = file.file_stem().ok_or("a scene without a name")?;
        let name = stem.to_string_lossy();
        let scene = Scene::read(&file)?;
        let of = scene.bounds().try_map(|_, ends| rational(ends));
        let of = of.ok_or(format!("{name}: an end is undefined"))?;
        if scene.given.has_computed_costs() {
            print_computed(&mut out, &name, &computed::point(&of))?;
        } else {
            print_box(&mut out, &name, &of)?;
        }
    }
    for [met, short] in computed::borders() {
        print_computed(&mut out, "border", &met)?;
        print_computed(&mut out, "below the border", &short)?;
    }
    let mut random = Random::new(20);
    for i in 0..BOXES {
        print_box(&mut out, &format!("random {i}"), &random.any_box())?;
    }
    for i in 0..COMPUTED {
        let of = random.any_computed();
        let of = of.ok_or(format!("computed {i}: the kernel gives no costs"))?;
        print_computed(&mut out, &format!("computed {i}"), &of)?;
    }
    Ok(())
}

/// The rational box: with π in it, the one around.
fn rational(ends: &Interval<Exact>) -> Option<Interval<BigRational>> {
    let enclosed = |x: &Exact| {
        let point = x.to_rational().map(Interval::point);
        point.or_else(|| x.enclosure(BITS))
    };
    let (lo, hi) = (enclosed(ends.lo())?, enclosed(ends.hi())?);
    Interval::new(lo.lo().clone(), hi.hi().clone())
}

fn print(
    out: &mut impl Write,
    name: &str,
    words: &str,
    verdict: Option<Truth>,
) -> Result<(), Box<dyn Error>> {
    let verdict = match verdict {
        Some(Truth::Holds) => "holds",
        Some(Truth::Fails) => "fails",
        Some(Truth::Depends) => "depends",
        None => return Err(format!("{name}: the kernel gives no verdict").into()),
    };
    writeln!(out, "{name}\t{words}\t{verdict}")?;
    Ok(())
}

/// A loop that the checker does not decide is left out.
fn print_computed(out: &mut impl Write, name: &str, of: &Bounds) -> Result<(), Box<dyn Error>> {
    match computed::words(of) {
        Some(words) => print(out, name, &words, computed::verdict(of)),
        None => Ok(()),
    }
}

fn print_box(out: &mut impl Write, name: &str, of: &Bounds) -> Result<(), Box<dyn Error>> {
    let ends = |range: &Interval<BigRational>| format!("{}:{}", range.lo(), range.hi());
    let optional = |range: &Option<_>| range.as_ref().map_or("-".to_owned(), ends);
    let words = [
        "box".to_owned(),
        optional(&of.viscous),
        optional(&of.coulomb),
        ends(&of.stiffness),
        ends(&of.period),
        optional(&of.resolution),
        optional(&of.damping),
        optional(&of.force_step),
        of.delay.to_string(),
        optional(&of.max_speed),
    ];
    print(out, name, &words.join(" "), of.decide(&of.speeds()))
}
