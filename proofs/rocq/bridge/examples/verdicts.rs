//! Prints boxes of loops and what the kernel's `Loop::decide` says of each, for comparison with the
//! checker that is extracted from Rocq: name, box and verdict, divided by tabs.
//!
//! The boxes are those of the shipped scenes whose costs have a closed form, and random ones, always
//! the same.

use std::error::Error;
use std::io::Write;
use std::path::Path;

use passivity_core::verdict::Speeds;
use passivity_core::{BigRational, Exact, Interval, Loop, Scalar as _, Truth};
use passivity_scene::Scene;

/// Random boxes.
const BOXES: usize = 10_000;

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
        if scene.given.has_computed_costs() {
            // A controller, a filter or a lag: the checker knows of sums only.
            continue;
        }
        let of = scene.bounds().try_map(|_, ends| rational(ends));
        print(
            &mut out,
            &name,
            &of.ok_or(format!("{name}: an end is undefined"))?,
        )?;
    }
    let mut random = Random(20);
    for i in 0..BOXES {
        print(&mut out, &format!("random {i}"), &random.any_box())?;
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

fn print(out: &mut impl Write, name: &str, of: &Bounds) -> Result<(), Box<dyn Error>> {
    let speeds = match &of.max_speed {
        Some(v) => Speeds::UpTo(v.clone()),
        None => Speeds::All,
    };
    let verdict = match of.decide(&speeds) {
        Some(Truth::Holds) => "holds",
        Some(Truth::Fails) => "fails",
        Some(Truth::Depends) => "depends",
        None => return Err(format!("{name}: the kernel gives no verdict").into()),
    };
    let ends = |range: &Interval<BigRational>| format!("{}:{}", range.lo(), range.hi());
    let optional = |range: &Option<_>| range.as_ref().map_or("-".to_owned(), ends);
    let words = [
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
    writeln!(out, "{name}\t{}\t{verdict}", words.join(" "))?;
    Ok(())
}

/// Random numbers (SplitMix64), always the same.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    fn below(&mut self, n: u16) -> u16 {
        let [a, b, ..] = self.next().to_le_bytes();
        u16::from_le_bytes([a, b]) % n
    }

    /// Eighths below 4: borders are met often.
    fn eighths(&mut self, least: i32) -> BigRational {
        BigRational::integer(least + i32::from(self.below(32))) / BigRational::integer(8)
    }

    /// A point or a tolerance, of numbers of so many eighths at least.
    fn range(&mut self, least: i32) -> Interval<BigRational> {
        let lo = self.eighths(least);
        match self.below(3) {
            0 => Interval::point(lo),
            _ => {
                let width = self.eighths(0) / BigRational::integer(1 + i32::from(self.below(4)));
                Interval::hull(lo.clone(), lo + width)
            }
        }
    }

    fn sometimes(&mut self, least: i32) -> Option<Interval<BigRational>> {
        (self.below(4) > 0).then(|| self.range(least))
    }

    /// Friction is drawn about what the middle of the box asks for, so that all verdicts occur.
    fn any_box(&mut self) -> Bounds {
        let without_friction = Loop {
            resolution: self.sometimes(1),
            damping: self.sometimes(0),
            force_step: self.sometimes(1),
            delay: self.below(4),
            max_speed: self.sometimes(1),
            ..Loop::new(self.range(1), self.range(1))
        };
        let cost = without_friction.map(|_, x| x.lo().clone()).cost();
        let near = |random: &mut Self, need: BigRational| {
            let lo = need * random.eighths(4) / BigRational::integer(2);
            let width = random.range(0);
            Some(Interval::hull(lo.clone() + width.lo(), lo + width.hi()))
        };
        let viscous = near(self, cost.viscous);
        let coulomb = near(self, cost.coulomb);
        Loop {
            viscous: viscous.filter(|_| self.below(16) > 0),
            coulomb: coulomb.filter(|_| self.below(16) > 0),
            ..without_friction
        }
    }
}
