//! What a column may be about, and what that is called.

use passivity_scene::Motion;
use passivity_scene::units::Dimension;

use super::words::{OF_DEVICE, OF_FORCE};
use crate::log::columns::Role;

/// What a column may be about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Time,
    Position,
    Force,
    Velocity,
}

impl Kind {
    pub(super) const ALL: [Self; 4] = [Self::Time, Self::Position, Self::Force, Self::Velocity];

    pub(super) const fn of(role: Role) -> Self {
        match role {
            Role::T | Role::Fine | Role::Tau => Self::Time,
            Role::Xi | Role::X | Role::Count => Self::Position,
            Role::V => Self::Velocity,
            Role::F => Self::Force,
        }
    }

    /// The words that name it.
    pub(super) const fn words(self) -> &'static [&'static str] {
        match self {
            Self::Time => &[
                "t",
                "time",
                "timestamp",
                "timestep",
                "stamp",
                "clock",
                "ts",
                "elapsed",
                "epoch",
                "tau",
                "second",
                "sec",
                "milli",
                "micro",
                "nano",
                "since",
                "uptime",
                "datetime",
                "unix",
                "perf",
                "monotonic",
                "zeit",
                "utc",
                "tsec",
                "tms",
                "tus",
                "tns",
                "datum",
                "temps",
                "tempo",
                "tiempo",
                "hora",
                "heure",
                "tid",
                "czas",
                "čas",
                "час",
            ],
            Self::Position => &[
                "x",
                "xi",
                "pos",
                "position",
                "angle",
                "theta",
                "θ",
                "ϑ",
                "q",
                "phi",
                "φ",
                "ϕ",
                "displacement",
                "encoder",
                "enc",
                "count",
                "tick",
                "rotation",
                "winkel",
                "weg",
                "inkrement",
                "inkremente",
                "pulse",
                "step",
                "schritt",
                "schritte",
            ],
            Self::Force => &[
                "f",
                "force",
                "torque",
                "tau",
                "τ",
                "effort",
                "moment",
                "trq",
                "tq",
                "mz",
                "fh",
                "loadcell",
                "fx",
                "fy",
                "fz",
                "kraft",
                "drehmoment",
                "forza",
                "fuerza",
                "força",
                "kracht",
                "couple",
                "coppia",
                "koppel",
                "voima",
                "siła",
                "сила",
                "усилие",
                "тяга",
                "力",
                "힘",
            ],
            Self::Velocity => &[
                "v",
                "vel",
                "velocity",
                "speed",
                "omega",
                "ω",
                "dq",
                "qd",
                "xdot",
                "thetadot",
                "dtheta",
                "dx",
                "qdot",
                "dot",
                "geschwindigkeit",
                "drehzahl",
            ],
        }
    }

    /// Whether a word names it, alone or as part of a longer one: `walltime`, `Motorwinkel`, `Motorkraft`, `Fcmd`.
    pub(super) fn is_named(self, word: &str) -> bool {
        let has = |parts: &[&str]| {
            let is_part = |part: &&str| word.starts_with(part) || word.ends_with(part);
            parts.iter().any(is_part)
        };
        self.words().contains(&word)
            || match self {
                Self::Time => has(&[
                    "time",
                    "stamp",
                    "zeit",
                    "uhr",
                    "tijd",
                    "время",
                    "时间",
                    "時間",
                    "时刻",
                    "時刻",
                    "시간",
                ]),
                Self::Force => {
                    // A temperature, as `Tout` is, a fact and a momentum.
                    let is_other =
                        ["tmot", "tout", "fact"].contains(&word) || word.starts_with("momentu");
                    let behind = word.strip_prefix(['f', 't', 'm']);
                    !is_other
                        && (has(&[
                            "force",
                            "torque",
                            "effort",
                            "kraft",
                            "moment",
                            "thrust",
                            "момент",
                            "トルク",
                            "力矩",
                            "扭矩",
                            "转矩",
                            "轉矩",
                            "推力",
                            "토크",
                        ]) || behind.is_some_and(|rest| OF_FORCE.contains(&rest)))
                }
                Self::Position => ["position", "winkel", "angle"].iter().any(|end| {
                    word.strip_suffix(end)
                        .is_some_and(|before| OF_DEVICE.contains(&before))
                }),
                Self::Velocity => false,
            }
    }

    /// What it is called in sentences.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Time => "a time",
            Self::Position => "a position",
            Self::Force => "a force",
            Self::Velocity => "a velocity",
        }
    }

    /// The dimension of its unit, angles aside.
    pub(super) fn dimension(self, motion: Motion) -> Dimension {
        let linear = motion == Motion::Linear;
        match self {
            Self::Time => Dimension::new(0, 0, 1, 0),
            Self::Position if linear => Dimension::new(0, 1, 0, 0),
            Self::Position => Dimension::NONE,
            Self::Velocity if linear => Dimension::new(0, 1, -1, 0),
            Self::Velocity => Dimension::new(0, 0, -1, 0),
            Self::Force if linear => Dimension::new(1, 1, -2, 0),
            Self::Force => Dimension::new(1, 2, -2, 0),
        }
    }

    /// The unit that is assumed where the header gives none.
    pub(super) const fn unit(self, motion: Motion) -> &'static str {
        match (self, motion) {
            (Self::Time, _) => "s",
            (Self::Position, Motion::Linear) => "m",
            (Self::Position, _) => "rad",
            (Self::Velocity, Motion::Linear) => "m/s",
            (Self::Velocity, _) => "rad/s",
            (Self::Force, Motion::Linear) => "N",
            (Self::Force, _) => "N m",
        }
    }
}
