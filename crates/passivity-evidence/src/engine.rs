//! What can show a claim.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::record::Shown;

/// Something that can show a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Engine {
    /// The solvers z3 and cvc5 on the formulas that the kernel computes.
    Smt,
    /// The theorem in a proof assistant.
    Rocq,
    /// The proof harnesses, decided by a model checker.
    Kani,
    /// The proof harnesses, run as tests.
    StandIn,
    /// Property tests of the kernel on big rationals.
    Tests,
    /// Contracts on the kernel's functions.
    Prusti,
}

impl Engine {
    /// Every engine, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::Smt,
        Self::Rocq,
        Self::Kani,
        Self::StandIn,
        Self::Tests,
        Self::Prusti,
    ];

    /// The name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Smt => "smt",
            Self::Rocq => "rocq",
            Self::Kani => "kani",
            Self::StandIn => "stand-in",
            Self::Tests => "tests",
            Self::Prusti => "prusti",
        }
    }

    /// What it is, for a reader of the table.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Smt => "z3 and cvc5",
            Self::Rocq => "Rocq",
            Self::Kani => "Kani",
            Self::StandIn => "harnesses as tests",
            Self::Tests => "big rationals",
            Self::Prusti => "Prusti",
        }
    }

    /// What one part of its work is called, and several: `query`, `queries`.
    #[must_use]
    pub const fn part(self) -> (&'static str, &'static str) {
        match self {
            Self::Smt => ("query", "queries"),
            Self::Rocq => ("theorem", "theorems"),
            Self::Kani | Self::StandIn => ("harness", "harnesses"),
            Self::Tests => ("test", "tests"),
            Self::Prusti => ("contract", "contracts"),
        }
    }

    /// Whether this engine is entitled to say so: a solver proves for all reals, tests sample.
    #[must_use]
    pub const fn can_show(self, shown: &Shown) -> bool {
        match self {
            Self::Smt | Self::Rocq => matches!(shown, Shown::AllReals),
            Self::Kani => matches!(shown, Shown::AllInputs { .. }),
            Self::StandIn => matches!(shown, Shown::Exhausted { .. } | Shown::Sampled { .. }),
            Self::Tests => matches!(shown, Shown::Sampled { .. }),
            // Nothing here checks the contracts.
            Self::Prusti => false,
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
