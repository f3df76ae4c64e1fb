//! Exact energy accounting of a sampled, quantized virtual wall.
//!
//! A haptic device renders a virtual wall: a spring whose force is computed from a quantized
//! position once per sampling period and held until the next sample. Sampling and quantization
//! *generate* energy, viscous and Coulomb friction *dissipate* it. This crate computes both,
//! exactly, and the criterion of Diolaiti, Niemeyer, Barbagli and Salisbury (*A Criterion for the
//! Passivity of Haptic Devices*) that compares them. Numbers in round brackets are the paper's
//! equations; ids such as `TH-LIN` are the claims of `proofs/claims.toml`.
//!
//! Everything is one text, generic over a small [`Scalar`]: the same functions run on exact
//! fractions of machine integers ([`Fixed`]), on big rationals, inside a model checker and on
//! the terms of a solver. Functions return exact quantities, "the margin, passive when it is not
//! negative", and leave the verdict to [`verdict`].
//!
//! What it is **not**: it reads no files, knows no units, uses no floating point, and does not
//! simulate motion.
//!
//! # Dimensionless quantities
//!
//! Position ξ = x/Δ in encoder ticks, time τ = t/T in sampling periods, force in KΔ, energy in
//! KΔ², μ = m/(KT²), β = b/(KT), σ = c/(KΔ) (3), (4), (7).
//!
//! # Example
//!
//! The paper's bound (22) is false as printed; measured against the linear spring it is true.
//!
//! ```
//! use passivity_core::{Fixed, Friction, Loop, Scalar, Step, ledger};
//!
//! let step = Step::new(Fixed::integer(1), Fixed::new(1, 2));
//! let paper = Loop::plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
//! let row = ledger::row(&paper, &ledger::HeldInterval::plain(step, Fixed::integer(1)));
//! assert_eq!(row.generated_quantized, Fixed::new(1, 2)); // more than
//! assert_eq!(row.bound_22, Fixed::new(3, 8)); // what (22) allows,
//! assert_eq!(row.generated_linear, Fixed::new(3, 8)); // and yet within it here.
//! ```
#![no_std]
#![forbid(unsafe_code)]
#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::float_arithmetic,
    clippy::as_conversions
)]
// Formulas clone their operands: the last clone of each is the price of one readable text.
#![allow(clippy::redundant_clone)]

extern crate alloc;

pub mod absolute_sum;
pub mod actuator;
mod cells;
pub mod circle;
pub mod control_loop;
pub mod controller;
pub mod counted;
pub mod course;
pub mod criterion;
pub mod decision;
pub mod definite;
pub mod dissipation;
pub mod drawn;
pub mod drift;
pub mod edge_cycle;
pub mod effect;
pub mod exponential;
pub mod extra_storage;
pub mod extremes;
pub mod fraction;
pub mod frequency;
pub mod generation;
pub mod interval;
pub mod joint_criterion;
pub mod joint_cycle;
pub mod joints;
pub mod law;
pub mod ledger;
pub mod linear_part;
pub mod parameter;
pub mod periodic;
pub mod pi;
pub mod polynomial;
pub mod quantizer;
pub mod rational;
pub mod region;
pub mod scalar;
pub mod smoothed;
pub mod spring;
pub mod start;
pub mod stiffness;
pub mod sturm;
pub mod transfer;
pub mod verdict;
pub mod wave;
pub mod whole;
pub mod witness;

pub use control_loop::Cost;
pub use controller::Controller;
pub use criterion::Criterion;
pub use decision::Enclosed;
pub use dissipation::Friction;
pub use effect::Effect;
pub use fraction::{Fixed, Fraction, Wide};
pub use generation::Step;
pub use interval::{Interval, Truth};
pub use joints::Joints;
pub use law::Law;
pub use num_rational::BigRational;
pub use parameter::{Loop, Parameter};
pub use pi::Exact;
pub use quantizer::Quantized;
pub use region::Region;
pub use scalar::{Ordered, Scalar};
pub use witness::Cycle;
