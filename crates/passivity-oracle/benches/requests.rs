//! The figure that the project promises for the line protocol: `cargo bench -p passivity-oracle --bench
//! requests`. By processor time where the system tells it; a figure that is missed ends the run with an
//! error.

use std::time::Instant;

use passivity_oracle::protocol;

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

/// Reports a figure; true when it reaches its target.
fn report(what: &str, found: f64, target: f64, unit: &str) -> bool {
    let reached = found >= target;
    let word = if reached { "reached" } else { "MISSED" };
    eprintln!("{what:<44}{found:>14.3e} {unit:<14} target {target:.1e}: {word}");
    reached
}

fn main() {
    let begin = Instant::now();
    let mut requests = String::new();
    for i in 0..200_000_i64 {
        let (a, b, c) = (i % 199 - 99, i % 17 + 1, i % 97 - 48);
        requests.push_str(&format!(
            "{{\"id\": {i}, \"op\": \"interval\", \"xi0\": \"{a}/{b}\", \"xi1\": \"{c}/{b}\", \
             \"beta\": \"3/5\", \"sigma\": \"3/5\", \"dtau\": \"1\"}}\n"
        ));
    }
    let before = processor(begin);
    let answered = {
        let input = std::io::BufReader::new(requests.as_bytes());
        let mut answers = Vec::new();
        protocol::serve(input, &mut answers).unwrap_or_else(|error| panic!("{error}"));
        answers.iter().filter(|byte| **byte == b'\n').count()
    };
    let seconds = (processor(begin) - before).max(0.01);
    #[allow(clippy::cast_precision_loss)]
    let rate = answered as f64 / seconds;
    let reached = report("interval requests, one core", rate, 1e5, "requests/s");
    if !reached {
        std::process::exit(1);
    }
}
