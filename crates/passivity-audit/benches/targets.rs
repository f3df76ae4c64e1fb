//! The figures that the project promises for audits, measured in one run:
//! `cargo bench -p passivity-audit --bench targets`.
//!
//! Rates are per core: on one thread, by processor time where the system tells it. A figure that is
//! missed ends the run with an error.

use std::io::Read;
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::{DoubleType, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::Type;
use passivity_audit::{Options, Values, audit, audit_columns, audit_csv};
use passivity_scene::Scene;

/// A hand that presses into a wall, holds and lets go: 50 000 samples that end where they start.
fn counts() -> Vec<i64> {
    let mut counts = Vec::with_capacity(50_000);
    for i in 0..50_000_i64 {
        let phase = (i - 25_000).abs();
        counts.push((25_000 - phase).min(9_000) / 3 + (i * i % 7) / 3);
    }
    counts
}

/// A CSV trace of any length, without a file.
struct Endless {
    block: Vec<u8>,
    at: usize,
    left: u64,
}

impl Endless {
    fn new(blocks: u64) -> Self {
        let mut block = Vec::new();
        for count in counts() {
            block.extend_from_slice(format!("{count}\n").as_bytes());
        }
        let left = blocks * block.len() as u64;
        Self { block, at: 0, left }
    }
}

impl Read for Endless {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let most = usize::try_from(self.left).unwrap_or(usize::MAX);
        let n = buffer.len().min(self.block.len() - self.at).min(most);
        buffer[..n].copy_from_slice(&self.block[self.at..self.at + n]);
        self.at = (self.at + n) % self.block.len();
        self.left -= n as u64;
        Ok(n)
    }
}

fn scene() -> Scene {
    let text = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"";
    Scene::from_toml("bench", text).unwrap_or_else(|error| panic!("{error}"))
}

/// Seconds that this process, with its threads, has run for.
fn processor(begin: Instant) -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after_name = stat.rsplit(')').next().unwrap_or_default();
    let fields: Vec<f64> = after_name
        .split_whitespace()
        .filter_map(|f| f.parse().ok())
        .collect();
    // utime and stime, in ticks of 10 ms; the state before them is a letter.
    match (fields.get(10), fields.get(11)) {
        (Some(user), Some(system)) => (user + system) * 0.01,
        _ => begin.elapsed().as_secs_f64(),
    }
}

fn csv(blocks: u64, threads: usize) -> u64 {
    let input: Box<dyn Read> = Box::new((&b"count\n"[..]).chain(Endless::new(blocks)));
    let options = Options {
        threads,
        ..Options::default()
    };
    let audit = audit_csv(input, &scene(), options).unwrap_or_else(|error| panic!("{error}"));
    assert!(audit.error().is_none());
    assert_eq!(audit.totals().intervals, blocks * 50_000 - 1);
    audit.totals().intervals
}

const MOTOR: &str = "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"2e-3 N m\"\n[sampling]\n\
                     period = \"1 ms\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\n\
                     stiffness = \"1 N m/rad\"\n";

fn motor() -> Scene {
    Scene::from_toml("motor", MOTOR).unwrap_or_else(|error| panic!("{error}"))
}

/// The row `i` of a motor's log with an uneven clock and forces: when, where in radians, and under which force.
fn uneven(i: u32) -> [f64; 3] {
    // Periods off by up to 5 %, and two sines.
    let t = f64::from(i) * 1e-3 + f64::from(i % 101 * 41 % 101) * 5e-7;
    let x = 0.03 * (8.2 * t).sin() + 0.002 * (141.3 * t).sin();
    [t, x, -0.2 * x.max(0.0)]
}

/// That log, in radians or in counts.
fn uneven_csv(is_counted: bool, rows: u32) -> String {
    use std::fmt::Write as _;
    let column = if is_counted { "count" } else { "x [rad]" };
    let mut log = format!("t [s],{column},f [N m]\n");
    for [t, x, force] in (0..rows).map(uneven) {
        let written = if is_counted {
            format!("{:.0}", (x * 8192.0 / std::f64::consts::TAU).floor())
        } else {
            format!("{x:.9}")
        };
        writeln!(log, "{t:.6},{written},{force:.6}").expect("text grows");
    }
    log
}

/// The same in radians, as arrays.
fn uneven_arrays(rows: u32) -> Vec<(String, Values)> {
    let column = |name: &str, at: usize| {
        let values = (0..rows).map(|i| uneven(i)[at]).collect();
        (name.to_owned(), Values::Doubles(values))
    };
    vec![
        column("t [s]", 0),
        column("x [rad]", 1),
        column("f [N m]", 2),
    ]
}

/// Audits with one thread: how many intervals there are.
fn alone(
    audit: impl Fn(Options<'_>) -> Result<passivity_audit::Audit, passivity_audit::TraceError>,
) -> u64 {
    let options = Options {
        threads: 1,
        ..Options::default()
    };
    let audit = audit(options).unwrap_or_else(|error| panic!("{error}"));
    assert!(audit.error().is_none());
    audit.totals().intervals
}

fn write_parquet(path: &std::path::Path, blocks: usize) {
    let schema = parse_message_type("message trace { required int64 count; }");
    let schema = Arc::new(schema.unwrap_or_else(|error| panic!("{error}")));
    let file = std::fs::File::create(path).unwrap_or_else(|error| panic!("{error}"));
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(file, schema, properties).expect("a writer");
    let values = counts().repeat(20);
    for _ in 0..blocks / 20 {
        let mut group = writer.next_row_group().expect("a group");
        let mut column = group.next_column().expect("a column").expect("one");
        column
            .typed::<Int64Type>()
            .write_batch(&values, None, None)
            .expect("values");
        column.close().expect("a column");
        group.close().expect("a group");
    }
    writer.close().expect("a file");
}

/// Writes columns of numbers.
fn write_columns(path: &std::path::Path, columns: &[(String, Values)]) {
    let field = |(name, values): &(String, Values)| {
        let physical = match values {
            Values::Whole(_) => Physical::INT64,
            Values::Doubles(_) => Physical::DOUBLE,
        };
        let field = Type::primitive_type_builder(name, physical);
        let field = field.with_repetition(Repetition::REQUIRED).build();
        Arc::new(field.expect("a field"))
    };
    let fields = columns.iter().map(field).collect();
    let schema = Type::group_type_builder("trace").with_fields(fields);
    let schema = Arc::new(schema.build().expect("a schema"));
    let file = std::fs::File::create(path).unwrap_or_else(|error| panic!("{error}"));
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(file, schema, properties).expect("a writer");
    let mut group = writer.next_row_group().expect("a group");
    for (_, values) in columns {
        let mut column = group.next_column().expect("a column").expect("one");
        let written = match values {
            Values::Whole(values) => {
                let column = column.typed::<Int64Type>();
                column.write_batch(values, None, None)
            }
            Values::Doubles(values) => {
                let column = column.typed::<DoubleType>();
                column.write_batch(values, None, None)
            }
        };
        written.expect("values");
        column.close().expect("a column");
    }
    group.close().expect("a group");
    writer.close().expect("a file");
}

/// A motor's log in counts, one period apart by a clock of whole nanoseconds.
fn even_counts(rows: u32) -> Vec<(String, Values)> {
    #[allow(clippy::cast_possible_truncation)] // some forty counts on either side
    let count = |[_, x, _]: [f64; 3]| (x * 8192.0 / std::f64::consts::TAU).floor() as i64;
    let counts = (0..rows).map(uneven).map(count).collect();
    let times = (0..rows).map(|i| i64::from(i) * 1_000_000).collect();
    vec![
        ("t [ns]".to_owned(), Values::Whole(times)),
        ("count".to_owned(), Values::Whole(counts)),
    ]
}

/// Seconds per interval of a plain exact loop in Python that sums the same enclosures of counts: the
/// energy generated by (TH-LIN), what friction dissipates at the least and at the most, and how many
/// intervals may fall short.
fn python() -> Option<f64> {
    const LOOP: &str = "
import time
from fractions import Fraction as F
beta = sigma = F(3, 5)
half, eighth = F(1, 2), F(1, 8)
counts = [(i * 7919) % 13 for i in range(3001)]
begin = time.process_time()
generated, dissipated, net, short = [F(0), F(0)], [F(0), F(0)], F(0), 0
for n0, n1 in zip(counts, counts[1:]):
    d = F(n1 - n0)
    least, most = max(abs(d) - 1, F(0)), abs(d) + 1
    below, above = (d - half)**2 / 2, (d + half)**2 / 2
    low = (min(below, above) if d else F(0)) - eighth
    high = max(below, above)
    taken = beta * least * least + sigma * least
    generated[0] += low
    generated[1] += high
    dissipated[0] += taken
    dissipated[1] += beta * most * most + sigma * most
    net += taken - high
    short += taken < high
print((time.process_time() - begin) / (len(counts) - 1))
";
    let output = Command::new("python3").args(["-c", LOOP]).output().ok()?;
    String::from_utf8(output.stdout).ok()?.trim().parse().ok()
}

/// Reports a figure; true when it reaches its target.
fn report(what: &str, found: f64, target: f64, unit: &str) -> bool {
    let reached = found >= target;
    let word = if reached { "reached" } else { "MISSED" };
    eprintln!("{what:<44}{found:>14.3e} {unit:<14} target {target:.1e}: {word}");
    reached
}

fn main() {
    let begin = Instant::now();
    let timed = |work: &dyn Fn() -> u64| {
        let before = processor(begin);
        let n = work();
        let seconds = (processor(begin) - before).max(0.01);
        #[allow(clippy::cast_precision_loss)]
        let rate = n as f64 / seconds;
        rate
    };
    let mut reached = true;
    let from_csv = timed(&|| csv(800, 1));
    reached &= report(
        "audit of counts from CSV, one core",
        from_csv,
        5e6,
        "intervals/s",
    );
    let path = std::env::temp_dir().join(format!("passivity-bench-{}.parquet", std::process::id()));
    write_parquet(&path, 800);
    let from_parquet = timed(&|| {
        let options = Options {
            threads: 1,
            ..Options::default()
        };
        let audit = audit(&path, &scene(), options).unwrap_or_else(|error| panic!("{error}"));
        audit.totals().intervals
    });
    reached &= report(
        "audit of counts from Parquet, one core",
        from_parquet,
        2e7,
        "intervals/s",
    );
    // About half of what was measured is asked for.
    let log = uneven_csv(false, 2_000_000);
    let from_csv_of = |log: &str| {
        let input = Box::new(std::io::Cursor::new(log.to_owned()));
        alone(move |options| audit_csv(input.clone(), &motor(), options))
    };
    reached &= report(
        "radians, uneven clock and forces, from CSV",
        timed(&|| from_csv_of(&log)),
        2e6,
        "intervals/s",
    );
    drop(log);
    let arrays = uneven_arrays(2_000_000);
    reached &= report(
        "the same from arrays of doubles",
        timed(&|| alone(|options| audit_columns(arrays.clone(), &motor(), options))),
        1.5e6,
        "intervals/s",
    );
    let from_parquet_of = |columns: &[(String, Values)]| {
        write_columns(&path, columns);
        timed(&|| alone(|options| audit(&path, &motor(), options)))
    };
    reached &= report(
        "the same from Parquet",
        from_parquet_of(&arrays),
        5e6,
        "intervals/s",
    );
    let mut arrays = arrays;
    let force = arrays.pop();
    let mut even = even_counts(2_000_000);
    reached &= report(
        "counts, even clock, from Parquet",
        from_parquet_of(&even),
        1.5e7,
        "intervals/s",
    );
    even.extend(force);
    reached &= report(
        "counts, even clock and forces, from Parquet",
        from_parquet_of(&even),
        3e6,
        "intervals/s",
    );
    let _ = std::fs::remove_file(&path);
    drop((arrays, even));
    let log = uneven_csv(true, 2_000_000);
    reached &= report(
        "counts, uneven clock and forces, from CSV",
        timed(&|| from_csv_of(&log)),
        2e6,
        "intervals/s",
    );
    // 24 hours at 1 kHz: 86.4 million samples.
    let start = Instant::now();
    let samples = csv(1728, 2) + 1;
    let seconds = start.elapsed().as_secs_f64();
    assert_eq!(samples, 86_400_000);
    reached &= report(
        "24 hours at 1 kHz on two cores, 20 s over",
        20.0 / seconds,
        1.0,
        "times",
    );
    match python() {
        Some(seconds) => {
            let times = seconds * from_csv;
            reached &= report(
                "against a loop of Python's fractions",
                times,
                1000.0,
                "times",
            );
        }
        None => eprintln!("against a loop of Python's fractions: not run here (no python3)"),
    }
    if !reached {
        std::process::exit(1);
    }
}
