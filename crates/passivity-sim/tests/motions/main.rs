//! Simulated motions, by every method, and sweeps of many.

mod common;
mod edges;
mod filters;
#[cfg(feature = "multiprecision")]
mod grid;
#[cfg(feature = "multiprecision")]
mod hard_cases;
mod latency;
#[cfg(all(feature = "adaptive", feature = "multiprecision"))]
mod methods;
#[cfg(feature = "parquet")]
mod sweep;
