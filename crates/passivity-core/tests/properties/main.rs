//! The kernel's claims on big rationals of full size, one test a statement.
//!
//! A test's name begins with the id of the claim that it speaks of (`th_lin_…` for TH-LIN);
//! NUM-EXACT is about the numbers and tables themselves. Every expected value is computed here from the
//! paper's or the theory's formula, not by the kernel's own functions.

mod absolute_sum;
mod actuator;
mod agreement;
mod boxes;
mod boxes_of_costs;
mod circle;
mod common;
mod control_loop;
mod controller;
mod counted;
mod course;
mod criterion;
mod decision;
mod definite;
mod dissipation;
mod drawn;
mod drift;
mod edge_cycle;
mod errata;
mod exact;
mod exponential;
mod extra_storage;
mod extremes;
mod filtered_boxes;
mod fraction;
mod frequency;
mod generation;
mod interval;
mod joint_criterion;
mod joint_cycle;
mod joints;
mod law;
mod ledger;
mod linear_part;
mod parameter;
mod periodic;
mod pi;
mod polynomial;
mod quantizer;
mod rational;
mod recursion;
mod region;
mod smooth;
mod smoothed;
mod spring;
mod start;
mod stiffness;
mod sturm;
mod transfer;
mod verdict;
mod walk;
mod whole;
mod witness;
