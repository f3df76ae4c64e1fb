//! The command `passivity`, run as its users run it.
//!
//! A member of no crate of its own: `crates/passivity-cli` lists it as a test target, so that the
//! binary under test is the one just built.

mod accuracy;
mod audit;
mod careful;
mod case;
mod certificates;
mod check;
mod design;
mod explain;
mod frequencies;
mod growing;
mod guides;
mod harness;
mod identify;
mod joints;
mod ledgers;
mod logs;
mod monitor;
mod oracle;
mod outputs;
mod pieces;
mod plane;
mod recordings;
mod schema;
mod several;
mod sides;
mod simulate;
mod simulated;
mod sweep;
mod sweep_files;
mod usage;
mod vectors;
