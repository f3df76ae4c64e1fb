//! `passivity schema`: the JSON Schemas of scene files and of what the commands answer.

use passivity_scene::check::{Constants, Design};
use serde_json::{Value, json};

use crate::exit::{Exit, Failure};
use crate::output::emit;
use crate::verbs;

/// Print the JSON Schema of scene files, for editors, or of what a command answers as JSON.
///
/// A scene file that begins with the line `#:schema scene.schema.json` gets completion, descriptions and
/// marks under mistakes in editors with Taplo or "Even Better TOML".
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity schema > scene.schema.json
  passivity schema check > check.schema.json")]
pub(crate) struct Args {
    /// What the schema is of.
    #[arg(value_enum, default_value_t)]
    of: Of,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Of {
    /// Scene files.
    #[default]
    Scene,
    /// `check --format json`.
    Check,
    /// `explain --format json`.
    Explain,
    /// `design --format json`.
    Design,
    /// `export --for json`.
    Export,
    /// `identify --format json`.
    #[cfg(feature = "identify")]
    Identify,
    /// `simulate --format json`.
    #[cfg(feature = "simulate")]
    Simulate,
    /// `sweep --format json`.
    #[cfg(feature = "simulate")]
    Sweep,
    /// `accuracy --format json`.
    #[cfg(feature = "simulate")]
    Accuracy,
}

/// Prints the schema.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let mut schema: Value = match args.of {
        Of::Scene => return print(&passivity_scene::parse::schema()),
        Of::Check => schemars::schema_for!(verbs::check::Document).into(),
        Of::Explain => schemars::schema_for!(verbs::explain::Document).into(),
        Of::Design => schemars::schema_for!(Design).into(),
        Of::Export => schemars::schema_for!(Constants).into(),
        #[cfg(feature = "identify")]
        Of::Identify => schemars::schema_for!(passivity_identify::Report).into(),
        #[cfg(feature = "simulate")]
        Of::Simulate => schemars::schema_for!(passivity_sim::report::Simulation).into(),
        #[cfg(feature = "simulate")]
        Of::Sweep => schemars::schema_for!(passivity_sim::report::Sweep).into(),
        #[cfg(feature = "simulate")]
        Of::Accuracy => schemars::schema_for!(passivity_sim::report::Accuracy).into(),
    };
    // What every answer has.
    schema["properties"]["version"] = json!({
        "description": "The version of the program.",
        "type": "string",
    });
    print(&schema)
}

/// Prints a schema, which is no answer and has no version.
fn print(schema: &Value) -> Result<Exit, Failure> {
    let text = serde_json::to_string_pretty(schema);
    emit(&text.map_err(|error| Failure::input(format!("this schema is not JSON: {error}")))?)?;
    Ok(Exit::Holds)
}
