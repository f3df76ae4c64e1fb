//! The outcome of a run: by the paper's threshold, and by what is certain.
//!
//! The paper calls a run converged when |ξ̇| < 0.01 at its end. With μ = 50 that is the largest
//! chatter at a tick's edge, (½ − σ)/μ for σ → 0, so it calls most limit cycles converged. The
//! exact words are only said when they are certain.

use schemars::JsonSchema;
use serde::Serialize;

/// The paper's threshold, in ticks per sample.
pub(crate) const PAPER_THRESHOLD: f64 = 0.01;

/// The outcome by the paper's detector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, JsonSchema)]
#[schemars(rename_all = "snake_case")]
pub enum PaperOutcome {
    /// |ξ̇| < 0.01 at the end.
    Converged,
    /// Neither converged nor unstable.
    LimitCycle,
    /// Growing, or with more energy at the end than at the start while the loop's linear part grows.
    Unstable,
}

/// The outcome as far as it is certain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, JsonSchema)]
#[schemars(rename_all = "snake_case")]
pub enum ExactOutcome {
    /// ξ̇ = 0 and |u| ≤ σ, for ever.
    AtRest,
    /// Unforced, and no tick's force is small enough to hold the device.
    NeverAtRest,
    /// Past a radius from which divergence is certain.
    Growing,
    /// None of these was found within the intervals.
    Undecided,
}

/// What became of a run, and why.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Outcome {
    /// By the paper's detector.
    pub paper: PaperOutcome,
    /// As far as it is certain.
    pub exact: ExactOutcome,
    /// The interval at which rest began or divergence became certain.
    pub at_interval: Option<u64>,
    /// The reason for `exact`, a sentence for people.
    pub because: String,
}

/// The end of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// How many intervals were run.
    pub intervals: u64,
    /// ξ at the end, in ticks.
    pub xi: f64,
    /// ξ̇ at the end, in ticks per sample.
    pub velocity: f64,
    /// The outcome.
    pub outcome: Outcome,
    /// The first sample that rounding may have put on the wrong side of an edge: of an encoder's, or without one of
    /// where the force jumps, at the surface of a wall with damping or between two steps of a D/A converter. The motion
    /// from there on, and with it the outcome, may be another one. Null where no sample was so near to an edge, and for
    /// the methods that decide every sample.
    pub within_rounding_of_edge: Option<u64>,
}

impl PaperOutcome {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::LimitCycle => "limit_cycle",
            Self::Unstable => "unstable",
        }
    }

    /// The outcome with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        [Self::Converged, Self::LimitCycle, Self::Unstable]
            .into_iter()
            .find(|outcome| outcome.name() == name)
    }
}

impl ExactOutcome {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::AtRest => "at_rest",
            Self::NeverAtRest => "never_at_rest",
            Self::Growing => "growing",
            Self::Undecided => "undecided",
        }
    }

    /// The outcome with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        [
            Self::AtRest,
            Self::NeverAtRest,
            Self::Growing,
            Self::Undecided,
        ]
        .into_iter()
        .find(|outcome| outcome.name() == name)
    }
}

/// What the words for an outcome depend on beside the state at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Facts {
    /// μ, with the arm's mass.
    pub mu: f64,
    /// σ.
    pub sigma: f64,
    /// The largest force that friction takes, see [`Plan`](crate::Plan).
    pub holding: f64,
    /// The least force held at rest; `None` when the scene is forced.
    pub least_holding_force: Option<f64>,
    /// Whether the linear part of the loop has a growing mode (or is not known not to).
    pub may_grow: bool,
    /// ξ(0) and ξ̇(0).
    pub start: [f64; 2],
}

/// How a run stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stop {
    /// At rest from this interval on.
    Rest(u64),
    /// Growing, noticed at this interval.
    Growing(u64),
    /// All intervals were run.
    Ran(u64),
}

impl Facts {
    /// The words for a run that stopped with this state; `growing` says past what, if it did.
    pub(crate) fn judge(&self, stop: Stop, xi: f64, velocity: f64, growing: &str) -> Outcome {
        let (exact, at_interval, because) = match stop {
            Stop::Rest(h) => (
                ExactOutcome::AtRest,
                Some(h),
                format!(
                    "ξ̇ = 0 and |u| ≤ σ = {}, so the device stays at rest",
                    self.sigma
                ),
            ),
            Stop::Growing(h) => (ExactOutcome::Growing, Some(h), format!("past {growing}")),
            Stop::Ran(_) => match self.least_holding_force {
                Some(least) if least > self.holding => (
                    ExactOutcome::NeverAtRest,
                    None,
                    format!(
                        "unforced, and the least force held at rest, {least}, is above σ = {}{}",
                        self.sigma,
                        if least > self.sigma {
                            ""
                        } else {
                            ", by less than a double tells"
                        }
                    ),
                ),
                _ => (
                    ExactOutcome::Undecided,
                    None,
                    "the motion neither came to rest nor was certain to grow within the intervals"
                        .to_owned(),
                ),
            },
        };
        Outcome {
            paper: self.paper(exact, xi, velocity),
            exact,
            at_interval,
            because,
        }
    }

    fn paper(&self, exact: ExactOutcome, xi: f64, velocity: f64) -> PaperOutcome {
        let energy = |xi: f64, v: f64| self.mu * v * v + xi * xi;
        let [xi_0, velocity_0] = self.start;
        // A start at rest at the origin has no energy to compare with: one tick has some.
        let at_start = energy(xi_0, velocity_0).max(1.0);
        let grown = self.may_grow && energy(xi, velocity) > at_start;
        if exact == ExactOutcome::Growing {
            PaperOutcome::Unstable
        } else if velocity.abs() < PAPER_THRESHOLD {
            PaperOutcome::Converged
        } else if grown {
            PaperOutcome::Unstable
        } else {
            PaperOutcome::LimitCycle
        }
    }
}
