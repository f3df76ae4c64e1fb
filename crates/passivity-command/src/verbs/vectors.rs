//! `passivity vectors`: test vectors for other implementations.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use passivity_scene::files::may_be_replaced;
use passivity_vectors::{
    Difference, Group, PATIENCE, SCHEMA, against, all, end_children, named, names,
};
use serde_json::{Value, json};

use crate::exit::{Exit, Failure};
use crate::files::write;
use crate::output::{Format, emit, emit_json};

/// Write the test vectors with their JSON Schema, or drive another implementation through them.
///
/// Each vector is a request of `passivity oracle` with the answer it must get.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity vectors --out vectors
  passivity vectors --against 'python3 my_implementation.py'
  passivity vectors --against './mine' --group errata --group regions --timeout 5

Exit codes: 0 written, or no difference; 1 the other implementation differs; 2 bad usage.")]
pub(crate) struct Args {
    /// Write one file per group of claims, and `schema.json`, to a directory; of what is there, only vectors are replaced.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Run a command that speaks the line protocol, and list where its answers differ.
    #[arg(long, value_name = "COMMAND")]
    against: Option<String>,
    /// Ask, write or list only this group of tests; may be given several times.
    #[arg(long, value_name = "NAME")]
    group: Vec<String>,
    /// With `--against`: how many seconds to wait for each next answer before the rest counts as not
    /// answered and the command is ended.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true, default_value_t = PATIENCE.as_secs(), requires = "against",
          value_parser = crate::args::whole(1..=86_400_u64))]
    timeout: u64,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// How many tests with another answer are listed for people.
const LISTED: usize = 20;

/// Writes, drives, or lists what there is.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let groups = chosen(&args.group)?;
    if let Some(folder) = &args.out {
        fs::create_dir_all(folder).map_err(|error| Failure::io(folder.display(), &error))?;
        let of_group = |group: &Group| (format!("{}.json", group.name), group.to_json());
        let schema = ("schema.json".to_owned(), SCHEMA.to_owned());
        let files = std::iter::once(schema).chain(groups.iter().map(of_group));
        let files: Vec<(PathBuf, String)> = files
            .map(|(name, text)| (folder.join(name), text))
            .collect();
        // Each of them before the first one is written.
        for (path, text) in &files {
            may_be_renewed(path, text)?;
        }
        for (path, text) in &files {
            write(path, text)?;
        }
    }
    if let Some(command) = &args.against {
        return drive(command, &groups, args);
    }
    if args.format == Format::Json {
        let listed: Vec<_> = groups
            .iter()
            .map(|g| json!({"group": g.name, "header": g.header, "tests": g.tests.len()}))
            .collect();
        emit_json(&json!({ "groups": listed }))?;
    } else {
        for group in &groups {
            emit(&format!(
                "{:>6} {:<16}{}",
                group.tests.len(),
                group.name,
                group.header
            ))?;
        }
    }
    Ok(Exit::Holds)
}

/// Refuses to write over a file that an earlier run has not written: vectors say of what group they are, and their schema
/// has its title.
fn may_be_renewed(path: &Path, text: &str) -> Result<(), Failure> {
    may_be_replaced(path).map_err(|error| Failure::io(path.display(), &error))?;
    let Ok(there) = fs::read(path) else {
        return Ok(()); // What is not there yet, or else what writing it says.
    };
    let read = |bytes: &[u8]| serde_json::from_slice::<Value>(bytes).ok();
    let is_ours = read(&there)
        .zip(read(text.as_bytes()))
        .is_some_and(|(there, new)| {
            let is_same = |key: &&str| there.get(key) == new.get(key);
            ["schema", "group", "title"].iter().all(is_same)
        });
    match is_ours {
        true => Ok(()),
        false => Err(Failure::input(format!(
            "{} is there already and has no vectors of this program: it is not overwritten",
            path.display()
        ))),
    }
}

/// The groups that are named; all where none is.
fn chosen(chosen: &[String]) -> Result<Vec<Group>, Failure> {
    if chosen.is_empty() {
        return Ok(all());
    }
    named(chosen).map_err(|unknown| {
        let known: Vec<&str> = names().collect();
        Failure::input(format!(
            "there is no group `{unknown}`: the groups are {}",
            known.join(", ")
        ))
    })
}

/// Drives another implementation through the tests and says where it differs.
fn drive(command: &str, groups: &[Group], args: &Args) -> Result<Exit, Failure> {
    // Interrupted, this program takes with it what it started.
    ctrlc::set_handler(|| {
        end_children();
        std::process::exit(130);
    })
    .map_err(Failure::input)?;
    let outcome = against(command, groups, Duration::from_secs(args.timeout))
        .map_err(|error| Failure::io(format!("`{command}`"), &error))?;
    let differences = &outcome.differences;
    if args.format == Format::Json {
        let fields = |d: &Difference| -> Vec<Value> {
            let one =
                |(field, message): &(String, String)| json!({"field": field, "message": message});
            d.fields.iter().map(one).collect()
        };
        let listed: Vec<_> = differences
            .iter()
            .map(|d| {
                json!({
                    "group": d.group, "id": d.id, "fields": fields(d),
                    "request": d.request, "expected": d.expected, "answer": d.answer,
                })
            })
            .collect();
        emit_json(&json!({
            "tests": outcome.tests, "differences": listed,
        }))?;
    } else {
        for d in differences.iter().take(LISTED) {
            emit(&in_words(d))?;
        }
        if differences.len() > LISTED {
            emit(&format!("and {} more tests", differences.len() - LISTED))?;
        }
        emit(&format!(
            "{} tests, {} differences",
            outcome.tests,
            differences.len()
        ))?;
    }
    Ok(if differences.is_empty() {
        Exit::Holds
    } else {
        Exit::Fails
    })
}

/// A test with another answer: what differs first, the request and both answers.
fn in_words(d: &Difference) -> String {
    let mut text = format!("{} {}: ", d.group, d.id);
    if let Some((field, message)) = d.fields.first() {
        let field = match field.as_str() {
            "" => String::new(),
            field => format!("{field}: "),
        };
        text += &format!("{field}{message}");
    }
    match d.fields.len() {
        0 | 1 => {}
        n => text += &format!(" (and {} more fields)", n - 1),
    }
    let answer = |answer: &Option<Value>, none: &str| {
        answer
            .as_ref()
            .map_or_else(|| none.to_owned(), Value::to_string)
    };
    text += &format!("\n  request:  {}", d.request);
    text += &format!("\n  expected: {}", answer(&d.expected, "an error"));
    text += &format!("\n  answer:   {}", answer(&d.answer, "none"));
    text
}
