//! Identifies simulated devices and prints how wide the boxes are: `table [HOW MANY] [INERTIA ± %] [free]`.
#![allow(clippy::print_stdout, missing_docs)]

#[path = "../tests/trial/mod.rs"]
mod trial;

use std::time::Instant;

use passivity_identify::{Inertia, Options, identify};

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let many = words.first().map_or(200, |n| n.parse().expect("a number"));
    let free = words.iter().any(|word| word == "free");
    let percent = words
        .get(1)
        .map_or(0.0, |n| n.parse().expect("a percentage"));
    let begin = Instant::now();
    for kind in trial::KINDS {
        let mut widths: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
        let (mut inside, mut all, mut informative, mut off): (_, _, _, f64) = (0, 0, 0, 0.0);
        let mut early = 0;
        let mut slowest: f64 = 0.0;
        for number in 0..many {
            let trial = trial::trial(number);
            if trial.kind != kind {
                continue;
            }
            let options = Options {
                inertia: if free { Inertia::Free } else { Inertia::Sketch },
                ..Options::default()
            };
            let sketch = trial::sketch(trial.device.inertia, percent);
            let one = Instant::now();
            let found = identify(&[trial.log], &sketch, &options, |_| true).expect("an answer");
            slowest = slowest.max(one.elapsed().as_secs_f64());
            all += 1;
            early += usize::from(found.stopped_early);
            let truth = [
                trial.device.viscous,
                trial.device.coulomb,
                trial.device.inertia,
            ];
            let mut holds = found.fits();
            for ((_, bounds), truth) in found.parameters.iter().zip(truth) {
                holds &= bounds.lo <= truth && truth <= bounds.hi.unwrap_or(f64::INFINITY);
            }
            if !holds {
                println!(
                    "outside: {number} {:?} {:?} {:?}",
                    trial.device, found.parameters, found.refuted_by
                );
            }
            inside += usize::from(holds);
            for ((widths, (_, bounds)), truth) in
                widths.iter_mut().zip(&found.parameters).zip(truth)
            {
                widths.push((bounds.hi.unwrap_or(f64::INFINITY) - bounds.lo) / truth);
            }
            if found.is_informative() {
                informative += 1;
                for ((_, bounds), truth) in found.parameters.iter().zip(truth) {
                    off = off.max((bounds.best.expect("an estimate") / truth - 1.0).abs());
                }
            } else if words.len() > 1 {
                println!("{number}: {:?}", found.lacks);
            }
        }
        let middle = |widths: &mut Vec<f64>| {
            widths.sort_by(f64::total_cmp);
            widths.get(widths.len() / 2).copied().unwrap_or(f64::NAN)
        };
        let [viscous, coulomb] = &mut widths;
        println!(
            "| {kind:?} | {inside} of {all} | {:.1} % | {:.1} % | {informative} | {:.1} % | {early} early, slowest {slowest:.2} s",
            100.0 * middle(viscous),
            100.0 * middle(coulomb),
            100.0 * off
        );
    }
    println!("{:.1} s", begin.elapsed().as_secs_f64());
}
