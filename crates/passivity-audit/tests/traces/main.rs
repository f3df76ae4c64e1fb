//! Audits of traces: in exact numbers and in doubles, in pieces, and from files of every form.

mod applied;
mod audit;
mod enclosure;
mod headers;
#[cfg(feature = "mcap")]
mod mcap;
mod near;
#[cfg(feature = "parquet")]
mod parquet;
mod partial;
mod scratch;
mod stored;
mod ticks;
mod wraps;
