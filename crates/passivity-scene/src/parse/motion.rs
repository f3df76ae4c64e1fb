//! Whether all units of a scene tell of one motion, linear or rotary.

use crate::diagnostic::{Diagnostic, Kind};
use crate::parse::measure::Measure;
use crate::parse::reader::Reader;
use crate::scene::Motion;

/// Reports the units that tell of another motion than most; the stiffness decides between equals.
pub(super) fn check_motion(reader: &mut Reader<'_>) {
    let count = |motion| {
        reader
            .unit_notes
            .iter()
            .filter(|note| note.motion == motion)
            .count()
    };
    let (linear, rotary) = (count(Motion::Linear), count(Motion::Rotary));
    if linear == 0 || rotary == 0 {
        return;
    }
    let kept = match linear.cmp(&rotary) {
        std::cmp::Ordering::Less => Motion::Rotary,
        std::cmp::Ordering::Greater => Motion::Linear,
        std::cmp::Ordering::Equal => reader.motion().unwrap_or(Motion::Linear),
    };
    let Some(anchor) = reader.unit_notes.iter().find(|note| note.motion == kept) else {
        return;
    };
    let word = |motion| match motion {
        Motion::Rotary => "rotary",
        _ => "linear",
    };
    let others = reader.unit_notes.iter().filter(|note| note.motion != kept);
    let mixed: Vec<Diagnostic> = others
        .map(|note| {
            let message = format!(
                "`{}` is {} (`{}`), but `{}` is {} (`{}`)",
                note.key,
                word(note.motion),
                note.unit,
                anchor.key,
                word(kept),
                anchor.unit
            );
            let expected = match (note.key, note.measure) {
                ("device.mass", _) => {
                    format!("`inertia`, {}", Measure::Inertia.expected(Some(kept)))
                }
                ("transmission.ratio", _) if kept == Motion::Rotary => {
                    "a plain number, such as `9.375`, of turns to turns".to_owned()
                }
                ("transmission.ratio", _) => {
                    "a way in a turn, such as `\"10 mm/rev\"`, or the radii of pulleys".to_owned()
                }
                (_, Some(measure)) => measure.expected(Some(kept)),
                (_, None) => "`resolution`, a length".to_owned(),
            };
            Diagnostic::new(Kind::MixedMotion, message)
                .at(note.span.clone())
                .key(note.key)
                .expected(expected)
                .found(format!("`{}`", note.unit))
        })
        .collect();
    reader.problems.extend(mixed);
}
