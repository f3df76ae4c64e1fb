//! The kernel's claims on big rationals of full size, one test a statement.
//!
//! A test's name begins with the id of the claim that it speaks of (`th_lin_…` for TH-LIN);
//! NUM-EXACT is about the numbers and tables themselves. Every expected value is computed here from the
//! paper's or the theory's formula, not by the kernel's own functions.

mod agreement;
mod bounds;
mod common;
mod criterion;
mod dissipation;
mod effects;
mod errata;
mod fraction;
mod generation;
mod interval;
mod law;
mod ledger;
mod quantizer;
mod region;
mod rig;
mod smooth;
mod spring;
mod start;
mod stiffness;
mod verdict;
mod walk;
mod witness;
