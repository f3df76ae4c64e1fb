//! What scene files may hold, what is said of their mistakes, and what is written of them: certificates, planes,
//! advice, and real devices.

mod advice;
mod certificates;
mod cycles;
mod data_sheets;
mod devices;
#[path = "../decisions/dimensionless.rs"]
mod dimensionless;
mod errors;
mod meant;
mod number;
mod planes;
mod quantities;
mod random_loops;
mod sides;
mod units;
