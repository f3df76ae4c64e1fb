//! A scene of either kind: of one joint, or of several.

use schemars::JsonSchema;
use serde::Serialize;

use crate::check::{Certificate, NotCertified, Report, Verdict};
use crate::joints::{JointReport, JointScene};
use crate::scene::Scene;

/// A scene file that was read: of a device of one joint, or of one of several.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyScene {
    /// A device of one joint.
    One(Box<Scene>),
    /// A device of several joints: a scene with `[[joint]]`.
    Joints(Box<JointScene>),
}

/// What `check` answers for either kind of scene.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum AnyReport {
    /// Of a device of one joint.
    One(Box<Report>),
    /// Of a device of several joints.
    Joints(Box<JointReport>),
}

impl AnyScene {
    /// Checks the scene.
    #[must_use]
    pub fn check(&self) -> AnyReport {
        match self {
            Self::One(scene) => AnyReport::One(Box::new(crate::check::check(scene))),
            Self::Joints(scene) => AnyReport::Joints(Box::new(crate::joints::check(scene))),
        }
    }

    /// What shows the decision about viscous friction in the report of the scene.
    ///
    /// # Errors
    ///
    /// [`NotCertified`] where no polynomial in cos θ decides it.
    pub fn certificate(&self, report: &AnyReport) -> Result<Certificate, NotCertified> {
        match (self, report) {
            (Self::One(scene), AnyReport::One(report)) => Certificate::new(scene, report),
            _ => Err(NotCertified::Joints),
        }
    }
}

impl AnyReport {
    /// The verdict, about any operator.
    #[must_use]
    pub const fn verdict(&self) -> Verdict {
        match self {
            Self::One(report) => report.verdict,
            Self::Joints(report) => report.verdict,
        }
    }

    /// The report as text, a screen for a scene.
    #[must_use]
    pub fn to_text(&self) -> String {
        match self {
            Self::One(report) => report.to_text(),
            Self::Joints(report) => report.to_text(),
        }
    }

    /// The report as a JSON object, one of the `scenes` of `check --format json`.
    #[must_use]
    pub fn to_json(&self) -> serde_json::Value {
        match self {
            Self::One(report) => report.to_json(),
            Self::Joints(report) => report.to_json(),
        }
    }
}
