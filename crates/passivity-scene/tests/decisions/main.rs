//! What `check` decides and prints: the tests that must notice a change of what decides.

mod conditions;
mod constants;
mod dimensionless;
mod joint_reports;
mod joints;
mod limit_ends;
mod limits;
mod linear;
mod ranges;
mod reports;
mod scenes;
mod unforced;
mod verdicts;
mod wall;
mod witness_tolerances;
mod witnesses;
