//! `passivity vectors`: test vectors for other implementations.

use std::fs;
use std::path::PathBuf;

use passivity_vectors::{SCHEMA, against, all};
use serde_json::json;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json};

/// Write the test vectors with their JSON Schema, or drive another implementation through them.
///
/// Each vector is a request of `passivity oracle` with the answer it must get.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity vectors --out vectors
  passivity vectors --against 'python3 my_implementation.py'

Exit codes: 0 written, or no difference; 1 the other implementation differs; 2 bad usage.")]
pub(crate) struct Args {
    /// Write one file per group of claims, and `schema.json`, to a directory.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Run a command that speaks the line protocol, and list where its answers differ.
    #[arg(long, value_name = "COMMAND")]
    against: Option<String>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// How many differences are listed for people.
const LISTED: usize = 50;

/// Writes, drives, or lists what there is.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let groups = all();
    if let Some(folder) = &args.out {
        let write = |name: String, text: &str| {
            let path = folder.join(name);
            fs::write(&path, text).map_err(|error| Failure::io(path.display(), &error))
        };
        fs::create_dir_all(folder).map_err(|error| Failure::io(folder.display(), &error))?;
        write("schema.json".to_owned(), SCHEMA)?;
        for group in &groups {
            write(format!("{}.json", group.name), &group.to_json())?;
        }
    }
    if let Some(command) = &args.against {
        let outcome = against(command, &groups)
            .map_err(|error| Failure::io(format!("`{command}`"), &error))?;
        let differences = &outcome.differences;
        if args.format == Format::Json {
            let listed: Vec<_> = differences
                .iter()
                .map(|d| json!({"group": d.group, "id": d.id, "field": d.field, "message": d.message}))
                .collect();
            emit_json(&json!({"tests": outcome.tests, "differences": listed}))?;
        } else {
            for d in differences.iter().take(LISTED) {
                let field = match d.field.as_str() {
                    "" => String::new(),
                    field => format!("{field}: "),
                };
                emit(&format!("{} {}: {field}{}", d.group, d.id, d.message))?;
            }
            if differences.len() > LISTED {
                emit(&format!("and {} more", differences.len() - LISTED))?;
            }
            emit(&format!(
                "{} tests, {} differences",
                outcome.tests,
                differences.len()
            ))?;
        }
        return Ok(if differences.is_empty() {
            Exit::Holds
        } else {
            Exit::Fails
        });
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
                "{:>6} {:<12}{}",
                group.tests.len(),
                group.name,
                group.header
            ))?;
        }
    }
    Ok(Exit::Holds)
}
