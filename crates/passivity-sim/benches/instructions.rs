//! Instructions per interval for scenes with no effect, one, … all, and of the methods that have more
//! than doubles, counted by callgrind.
//!
//! `cargo bench -p passivity-sim --bench instructions` runs itself under valgrind, for 1000 and for
//! 3000 intervals of each scene; the difference over 2000 is what an interval costs. `-- WORDS` counts
//! the scenes whose name has these words. Of the scenes on a cycle a second table says how many intervals have a
//! stop, and what one with and one without it costs. Ends with an error where a scene costs more than its limit.

mod callgrind;

use passivity_core::{BigRational, Friction, Loop, Scalar};
use passivity_scene::Point;
use passivity_scene::point::Units;
use passivity_sim::{Method, Plan, run, simulate};

/// A heavy device that keeps moving through every scene: nothing rests, and nothing grows by a tick.
fn base(intervals: u64) -> Point {
    let one = BigRational::one();
    Point {
        at: Loop {
            inertia: Some(BigRational::integer(1_000_000)),
            start_velocity: Some(BigRational::integer(2)),
            ..Loop::new(one.clone(), one.clone())
        },
        forces: None,
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
            length_unit: None,
        },
    }
}

type Change = fn(&mut Point);

/// The effects in the order in which they are added.
fn effects() -> Vec<(&'static str, Change)> {
    fn tenth() -> BigRational {
        BigRational::one().over(BigRational::integer(10))
    }
    vec![
        ("encoder", |p| p.at.resolution = Some(BigRational::one())),
        ("viscous friction", |p| p.at.viscous = Some(tenth())),
        ("Coulomb friction", |p| p.at.coulomb = Some(tenth())),
        ("delay", |p| p.at.delay = 1),
        ("one-sided wall", |p| p.at.unilateral = true),
        ("virtual damping", |p| p.at.damping = Some(tenth())),
        ("D/A converter", |p| p.at.force_step = Some(tenth())),
        ("saturation", |p| {
            p.at.max_force = Some(BigRational::integer(10_000));
        }),
        ("operator's force", |p| p.forces = Some(vec![tenth()])),
        ("amplifier", |p| {
            p.at.time_constant = Some(tenth() * BigRational::integer(5));
        }),
        ("arm", |p| {
            p.at.arm_mass = Some(tenth());
            p.at.arm_damping = Some(tenth());
            p.at.arm_stiffness = Some(tenth());
        }),
    ]
}

/// What is counted.
struct Task {
    name: String,
    point: Point,
    /// The closed form without a ledger, or a method with one.
    method: Option<Method>,
    /// The most that an interval may cost, where that is promised.
    limit: Option<f64>,
}

impl Task {
    fn run(&self, intervals: u64) {
        let mut point = self.point.clone();
        point.intervals = intervals;
        let ran = match &self.method {
            // A frictionless loop grows from the start: let it, the interval costs the same.
            None => Plan::compile(&point).map(|plan| run::outcome(&plan.past_growth()).intervals),
            Some(method) => simulate(&point, method, None).map(|run| run.end.intervals),
        };
        assert_eq!(ran, Ok(intervals), "{}", self.name);
    }

    fn what(&self) -> String {
        match (&self.method, Plan::compile(&self.point)) {
            (Some(method), _) => format!("method `{method}`"),
            (None, Ok(plan)) => format!("loop `{}`", plan.loop_name()),
            (None, Err(error)) => error.to_string(),
        }
    }
}

/// The most that an interval on a cycle may cost with an amplifier, with an arm, and with both, on a processor with
/// AVX2.
const LIMITS: [f64; 3] = [400.0, 370.0, 950.0];

/// The paper's device on a cycle, where an interval in a few has a reversal.
fn cycles() -> Vec<Task> {
    let tenths = |n| BigRational::integer(n).over(BigRational::integer(10));
    let mut cycle = base(1);
    cycle.at = Loop {
        inertia: Some(BigRational::integer(50)),
        start_velocity: Some(BigRational::one()),
        ..Loop::plain(Friction::new(tenths(9), tenths(4)))
    };
    let mut lagging = cycle.clone();
    lagging.at.time_constant = Some(tenths(2));
    let mut held = cycle.clone();
    held.at.arm_mass = Some(BigRational::integer(10));
    held.at.arm_damping = Some(tenths(2));
    held.at.arm_stiffness = Some(BigRational::integer(2));
    let mut both = held.clone();
    both.at.time_constant = lagging.at.time_constant.clone();
    let scenes = [
        ("plain", cycle, 135.0),
        ("amplifier", lagging, LIMITS[0]),
        ("arm", held, LIMITS[1]),
        ("amplifier and arm", both, LIMITS[2]),
    ];
    scenes
        .map(|(name, point, limit)| Task {
            name: format!("on a cycle: {name}"),
            point,
            method: None,
            limit: Some(limit),
        })
        .into()
}

/// A scene on a cycle with a device so heavy that it does not turn, but for once in 1500 intervals.
fn heavy(task: &Task) -> Task {
    let mut point = task.point.clone();
    point.at.inertia = Some(BigRational::integer(1_000_000));
    Task {
        name: format!("{}, heavy", task.name),
        point,
        method: None,
        limit: None,
    }
}

/// The part of the intervals from 1000 to 3000 in which the device stops.
fn share_of_stops(task: &Task) -> f64 {
    let mut point = task.point.clone();
    point.intervals = 3000;
    let plan = Plan::compile(&point).unwrap_or_else(|error| panic!("{error}"));
    let mut stops = 0_u32;
    run::ledger(&plan.past_growth(), |entry| {
        stops += u32::from(entry.h >= 1000 && entry.v0 * entry.v1 <= 0.0);
        true
    });
    f64::from(stops) / 2000.0
}

/// The scenes: each effect by itself, then one more at a time, then other methods.
fn tasks() -> Vec<Task> {
    let task = |name: String, point: &Point, method| Task {
        name,
        point: point.clone(),
        method,
        limit: None,
    };
    let mut tasks = vec![task("hold only".to_owned(), &base(1), None)];
    for (name, change) in effects() {
        let mut point = base(1);
        change(&mut point);
        tasks.push(task(format!("{name} alone"), &point, None));
    }
    let mut point = base(1);
    for (count, (name, change)) in effects().into_iter().enumerate() {
        change(&mut point);
        let name = format!("{} effects: … + {name}", count + 1);
        tasks.push(task(name, &point, None));
    }
    let cycles = cycles();
    tasks.extend(cycles.iter().map(heavy));
    tasks.extend(cycles);
    for (encoder_only, method) in [
        (false, Method::ClosedForm),
        (true, Method::Exact),
        (false, Method::Enclosure),
        (false, Method::Reference { digits: 20 }),
    ] {
        let mut plain = base(1);
        let mut controlled = base(1);
        for (index, (_, change)) in effects().into_iter().enumerate() {
            if encoder_only && index == 1 {
                continue; // viscous friction
            }
            if index < 3 {
                change(&mut plain);
            }
            if index < 9 {
                change(&mut controlled);
            }
        }
        tasks.push(task(
            "encoder and friction".to_owned(),
            &plain,
            Some(method),
        ));
        tasks.push(task("9 effects".to_owned(), &controlled, Some(method)));
    }
    tasks
}

/// Instructions for an interval of a task; `None` where valgrind is not installed.
fn each(index: usize) -> Option<f64> {
    let count = |intervals: u64| {
        let arguments = ["run", &index.to_string(), &intervals.to_string()];
        callgrind::counted(&[], &arguments).map(|(instructions, _)| instructions)
    };
    let (few, many) = count(1000).zip(count(3000))?;
    Some((many - few) / 2000.0)
}

/// Says of the scenes on a cycle what an interval with a stop costs.
#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn print_stops(tasks: &[Task], counts: &[Option<f64>]) {
    println!("\n| scene | an interval without a stop | intervals with one | such an interval |");
    println!("| --- | --- | --- | --- |");
    for (task, count) in tasks.iter().zip(counts) {
        let heavy = format!("{}, heavy", task.name);
        let at = tasks.iter().position(|other| other.name == heavy);
        if let Some((all, without)) = at.and_then(|at| (*count).zip(counts[at])) {
            let share = share_of_stops(task);
            let with = (all - (1.0 - share) * without) / share;
            println!(
                "| {} | {without:.0} | {:.0} % | {with:.0} |",
                task.name,
                100.0 * share
            );
        }
    }
}

#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn main() {
    let tasks = tasks();
    let args: Vec<String> = std::env::args().collect();
    if let [_, word, index, intervals] = args.as_slice()
        && word == "run"
    {
        let [index, intervals] = [index, intervals].map(|text| {
            text.parse::<usize>()
                .unwrap_or_else(|error| panic!("`{text}`: {error}"))
        });
        tasks[index].run(intervals as u64);
        return;
    }
    // Cargo adds a flag of its own.
    let words = args.iter().skip(1).find(|word| !word.starts_with("--"));
    println!("| scene | what | instructions an interval | at most |\n| --- | --- | --- | --- |");
    let mut counts = vec![None; tasks.len()];
    let mut missed = Vec::new();
    for (index, task) in tasks.iter().enumerate() {
        if words.is_some_and(|words| !task.name.contains(words)) {
            continue;
        }
        let Some(each) = each(index) else {
            println!("not run here: valgrind is not installed");
            return;
        };
        counts[index] = Some(each);
        let limit = task.limit.map(|limit| format!("{limit:.0}"));
        let limit = limit.as_deref().unwrap_or_default();
        println!("| {} | {} | {each:.0} | {limit} |", task.name, task.what());
        if task.limit.is_some_and(|limit| each > limit) {
            missed.push(&task.name);
        }
    }
    if tasks
        .iter()
        .zip(&counts)
        .any(|(task, count)| task.limit.and(*count).is_some())
    {
        print_stops(&tasks, &counts);
    }
    assert!(missed.is_empty(), "past their limits: {missed:?}");
}
