//! The kinds of mistakes, each with a name that does not change between versions.

use crate::number::NumberErrorKind;

/// A kind of mistake in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The file is not there or may not be read.
    Unreadable,
    /// A folder, a pipe or a device in place of a file.
    NotAFile,
    /// More bytes than a scene file may have.
    FileTooLarge,
    /// A byte that is not UTF-8.
    NotUtf8,
    /// Not TOML.
    Syntax,
    /// The same key or section twice.
    Duplicate,
    /// A section that no scene has.
    UnknownSection,
    /// A key that no section has.
    UnknownKey,
    /// A key in a section that is not its own.
    WrongSection,
    /// A key that a scene must have.
    MissingKey,
    /// Two keys of which a scene may have one.
    ConflictingKeys,
    /// A number where text was expected, and the like.
    WrongType,
    /// A literal that is no exact number.
    Number(NumberErrorKind),
    /// A number without its unit.
    MissingUnit,
    /// A symbol that is no unit.
    UnknownUnit,
    /// A text that has not the form of a unit.
    MalformedUnit,
    /// A unit that measures something else.
    WrongUnit,
    /// A tolerance that cannot be read.
    MalformedTolerance,
    /// A value that the quantity cannot have.
    OutOfBounds,
    /// A tolerance that reaches values that the quantity cannot have.
    ToleranceOutOfBounds,
    /// Linear and rotary units in one scene.
    MixedMotion,
    /// Something that is not covered for a device of several joints.
    NotWithJoints,
    /// A device of several joints where one of a single joint is asked for.
    SeveralJoints,
    /// A list with more or fewer entries than there are joints.
    WrongCount,
    /// A stiffness matrix that is not symmetric.
    NotSymmetric,
    /// A stiffness matrix that is not positive semidefinite.
    NotSemidefinite,
    /// A file of samples that cannot be read, or something in it.
    Samples,
}

impl Kind {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unreadable => "unreadable",
            Self::NotAFile => "not_a_file",
            Self::FileTooLarge => "file_too_large",
            Self::NotUtf8 => "not_utf8",
            Self::Syntax => "syntax",
            Self::Duplicate => "duplicate",
            Self::UnknownSection => "unknown_section",
            Self::UnknownKey => "unknown_key",
            Self::WrongSection => "wrong_section",
            Self::MissingKey => "missing_key",
            Self::ConflictingKeys => "conflicting_keys",
            Self::WrongType => "wrong_type",
            Self::Number(kind) => kind.name(),
            Self::MissingUnit => "missing_unit",
            Self::UnknownUnit => "unknown_unit",
            Self::MalformedUnit => "malformed_unit",
            Self::WrongUnit => "wrong_unit",
            Self::MalformedTolerance => "malformed_tolerance",
            Self::OutOfBounds => "out_of_bounds",
            Self::ToleranceOutOfBounds => "tolerance_out_of_bounds",
            Self::MixedMotion => "mixed_motion",
            Self::NotWithJoints => "not_with_joints",
            Self::SeveralJoints => "several_joints",
            Self::WrongCount => "wrong_count",
            Self::NotSymmetric => "not_symmetric",
            Self::NotSemidefinite => "not_semidefinite",
            Self::Samples => "samples",
        }
    }
}
