//! The form of the vector files, as a JSON Schema.

/// JSON Schema (draft 2020-12) of a vector file.
pub const SCHEMA: &str = include_str!("schema.json");
