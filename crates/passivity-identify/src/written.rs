//! The scene that is written: the sketch with what is known of the device.

use passivity_audit::{is_day, is_device, legible};
use passivity_core::{BigRational, Parameter};
use passivity_scene::check::{key_of, unit_of};
use passivity_scene::{Scene, SceneError};
use toml_edit::{Decor, DocumentMut, Item, Table, Value, value};

use crate::identified::{Bounds, Identified, IdentifyError};
use crate::report::{LogReport, nearest, range, with_unit};

/// How the lines begin of a comment that says where what was identified comes from, in their order; the last one may be
/// there several times.
const FORM: [&str; 5] = [
    "Identified by `passivity identify`",
    "Best estimate of ",
    "Device: ",
    "Recorded: ",
    "Log: ",
];

/// A wall for sketches that have none: no parameter of the device depends on it.
const WALLS: [&str; 2] = ["1 N m/rad", "1 N/m"];

/// What is said in the scene beside the numbers.
#[derive(Clone, Debug, Default)]
pub struct Provenance {
    /// The logs.
    pub logs: Vec<LogReport>,
    device: Option<String>,
    date: Option<String>,
}

impl Provenance {
    /// Which device was recorded and on which day, as far as somebody says so; of no logs yet.
    ///
    /// # Errors
    ///
    /// [`IdentifyError`] for a text that names no device, or is no day.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_identify::Provenance;
    ///
    /// let said = |device: &str, date: &str| Provenance::new(Some(device.to_owned()), Some(date.to_owned()));
    /// assert!(said("rig XXX-7", "2026-11-20").is_ok() && Provenance::new(None, None).is_ok());
    /// let error = said("rig XXX-7", "today").unwrap_err().to_string();
    /// assert_eq!(error, "date: expected a day such as 2026-11-20, found `today`");
    /// assert!(said("TODO", "2026-11-20").unwrap_err().to_string().starts_with("device: "));
    /// ```
    pub fn new(device: Option<String>, date: Option<String>) -> Result<Self, IdentifyError> {
        let wrong = |name: &str, expected: &str, found: &str| {
            let found = legible(found);
            let message = format!("{name}: expected {expected}, found `{found}`");
            Err(IdentifyError::new(message))
        };
        if let Some(text) = device.as_deref().filter(|text| !is_device(text)) {
            let expected = "which device was recorded, such as its name and serial number";
            return wrong("device", expected, text);
        }
        if let Some(text) = date.as_deref().filter(|text| !is_day(text)) {
            return wrong("date", "a day such as 2026-11-20", text);
        }
        let logs = Vec::new();
        Ok(Self { logs, device, date })
    }
}

/// Reads a sketch: a scene, perhaps without a wall.
///
/// # Errors
///
/// [`SceneError`] with what is wrong with it.
pub fn read_sketch(name: &str, text: &str) -> Result<Scene, SceneError> {
    let Ok(document) = text.parse::<DocumentMut>() else {
        // This says where it is no TOML.
        return Scene::from_toml(name, text);
    };
    if document.contains_key("wall") || document.contains_key("dimensionless") {
        return Scene::from_toml(name, text);
    }
    let with = |stiffness: &str| {
        let mut document = document.clone();
        let mut wall = Table::new();
        wall.insert("stiffness", value(stiffness));
        document.insert("wall", Item::Table(wall));
        Scene::from_toml(name, &document.to_string())
    };
    // Of the motion that the rest of the sketch is of.
    let [rotary, linear] = WALLS.map(with);
    let with_wall = match rotary.or_else(|error| linear.map_err(|_| error)) {
        Ok(scene) => return Ok(scene),
        Err(error) => error,
    };
    // What is wrong is said of the file, not of a wall that is not in it.
    let own = Scene::from_toml(name, text).err();
    Err(own.and_then(|own| own.without("wall")).unwrap_or(with_wall))
}

impl Identified {
    /// The key under which a scene is given what was identified of a parameter: it is of the device, also where the
    /// sketch gives the parameter at the motor.
    #[must_use]
    pub fn key(&self, parameter: Parameter) -> &'static str {
        key_of(parameter, self.motion)
    }

    /// Bounds of a parameter, rounded outwards, as a scene is given them; in words where nothing bounds it above.
    #[must_use]
    pub fn range(&self, parameter: Parameter, bounds: &Bounds) -> String {
        range(bounds.lo, bounds.hi, unit_of(parameter, self.motion))
    }

    /// The sketch's text with what is known of the device, as ranges that surely hold it.
    ///
    /// # Errors
    ///
    /// [`IdentifyError`] where the sketch cannot be changed, or where none can be written
    /// ([`unwritten`](Self::unwritten)).
    pub fn scene(&self, sketch: &str, said: &Provenance) -> Result<String, IdentifyError> {
        if let Some(why) = self.unwritten() {
            return Err(IdentifyError::new(format!("no scene is written: {why}")));
        }
        let refuse = |error: &dyn std::fmt::Display| IdentifyError::new(error.to_string());
        let mut document: DocumentMut = sketch.parse().map_err(|error| refuse(&error))?;
        for (parameter, bounds) in &self.parameters {
            let text = self.range(*parameter, bounds);
            self.put(&mut document, *parameter, &text)?;
        }
        self.note(&mut document, said);
        let mut text = document.to_string();
        // With the line breaks of the sketch.
        let first = sketch.split_once('\n');
        if first.is_some_and(|(line, _)| line.ends_with('\r')) {
            text = text.replace("\r\n", "\n").replace('\n', "\r\n");
        }
        self.holds(&text)?;
        Ok(text)
    }

    /// Puts a parameter where it belongs, in place of what the sketch says of it.
    fn put(
        &self,
        document: &mut DocumentMut,
        parameter: Parameter,
        text: &str,
    ) -> Result<(), IdentifyError> {
        let row = parameter.row();
        let keys = [row.key].into_iter().chain(row.other_keys.iter().copied());
        let key = self.key(parameter);
        let (section, name) = place(key);
        // Comments that stand with another key of it stay, above and behind.
        let mut comments = None;
        for other in keys
            .chain(row.dimensionless_key)
            .filter(|other| *other != key)
        {
            let (section, name) = place(other);
            let table = document.get_mut(section).and_then(Item::as_table_like_mut);
            if let Some(table) = table {
                let above = table.key(name).map(|key| key.leaf_decor().clone());
                let removed = table.remove(name).and_then(|item| item.into_value().ok());
                comments = above
                    .zip(removed.map(|value| value.decor().clone()))
                    .or(comments);
            }
        }
        in_lines(document, section);
        let place = document.entry(section).or_insert(Item::Table(Table::new()));
        let Some(table) = place.as_table_like_mut() else {
            return Err(IdentifyError::new(format!(
                "`{section}` is not a section of the sketch"
            )));
        };
        let mut new = Value::from(text);
        if let Some(old) = table.get(name).and_then(Item::as_value) {
            comments = Some((Decor::default(), old.decor().clone()));
        }
        if let Some((_, behind)) = &comments {
            *new.decor_mut() = behind.clone();
            if let Some(comment) = behind.suffix().and_then(|suffix| suffix.as_str()) {
                new.decor_mut().set_suffix(sourced(comment));
            }
        }
        match table.get_mut(name) {
            // What stands above it stays.
            Some(item) => *item = Item::Value(new),
            None => {
                table.insert(name, Item::Value(new));
                if let (Some((above, _)), Some(mut key)) = (comments, table.key_mut(name)) {
                    *key.leaf_decor_mut() = above;
                }
            }
        }
        Ok(())
    }

    /// Says above each number that was identified where it comes from, of each by itself: a later identification may
    /// replace some of them only.
    fn note(&self, document: &mut DocumentMut, said: &Provenance) {
        // A line break tells words apart.
        let plain = |text: &str| {
            let pieces = text
                .split(char::is_control)
                .filter(|piece| !piece.is_empty());
            pieces.collect::<Vec<_>>().join(" ")
        };
        let [mark, best_estimate, device, recorded, log] = FORM;
        for (parameter, bounds) in &self.parameters {
            let name = parameter.row().name;
            let mut lines = vec![format!(
                "{mark}: {name} is surely in this range, if the device is one of the model (TH-IDENT)."
            )];
            if let Some(best) = bounds.best {
                let refuted = if self.best_refuted {
                    ", refuted by the logs"
                } else {
                    ""
                };
                let best = with_unit(&nearest(best), unit_of(*parameter, self.motion));
                lines.push(format!("{best_estimate}{name}: {best}{refuted}"));
            }
            let given = said.device.iter().map(|text| (device, text));
            let given = given.chain(said.date.iter().map(|text| (recorded, text)));
            lines.extend(given.map(|(what, text)| format!("{what}{}", plain(text))));
            let logs = said.logs.iter();
            lines.extend(
                logs.map(|one| format!("{log}{}, sha256 {}", plain(&one.file), one.sha256)),
            );
            comment_above(document, place(self.key(*parameter)), &lines);
        }
    }

    /// Reads the scene back: it must hold every bound.
    fn holds(&self, text: &str) -> Result<(), IdentifyError> {
        let scene = read_sketch("scene", text);
        let scene = scene.map_err(|error| IdentifyError::new(error.to_string()))?;
        let bounds = scene.bounds();
        for (parameter, found) in &self.parameters {
            let read = match parameter {
                Parameter::Viscous => bounds.viscous.as_ref(),
                Parameter::Coulomb => bounds.coulomb.as_ref(),
                _ => bounds.inertia.as_ref(),
            };
            let ends =
                read.and_then(|read| Some([read.lo().to_rational()?, read.hi().to_rational()?]));
            let own = [Some(found.lo), found.hi].map(|x| x.and_then(BigRational::from_float));
            let is_held = match (ends, own) {
                (Some([lo, hi]), [Some(least), Some(most)]) => lo <= least && most <= hi,
                _ => false,
            };
            if !is_held {
                let message = format!(
                    "the scene does not hold the bounds of `{}`: it is not written",
                    parameter.row().key
                );
                return Err(IdentifyError::new(message));
            }
        }
        Ok(())
    }
}

/// A comment without the reminder that the number needs a source: it has one now.
fn sourced(comment: &str) -> String {
    const REMINDER: &str = "TODO: source";
    let mut said = comment.replace(&format!("; {REMINDER}"), "");
    if said.trim().trim_start_matches('#').trim() == REMINDER {
        said.clear();
    }
    said
}

/// The section of a key, and its name there.
fn place(key: &'static str) -> (&'static str, &'static str) {
    key.split_once('.').unwrap_or(("device", key))
}

/// Writes a section that is in one line as a line for each key, with the comments of the one: a comment above that
/// would be said of all that is in it.
fn in_lines(document: &mut DocumentMut, section: &str) {
    let key = document.key(section);
    let above = key.and_then(|key| key.leaf_decor().prefix()?.as_str());
    let above = above.unwrap_or_default().to_owned();
    let line = document.get_mut(section);
    let Some(line) = line.filter(|line| line.is_inline_table()) else {
        return;
    };
    let beside = line
        .as_value()
        .and_then(|line| line.decor().suffix()?.as_str());
    let beside = beside.unwrap_or_default().to_owned();
    let Ok(mut table) = std::mem::take(line).into_table() else {
        return;
    };
    table.set_dotted(true);
    for (index, (mut key, item)) in table.iter_mut().enumerate() {
        if index == 0 {
            key.leaf_decor_mut().set_prefix(above.as_str());
        }
        if let Some(value) = item.as_value_mut() {
            value.decor_mut().set_suffix(beside.as_str());
        }
    }
    *line = Item::Table(table);
}

/// The lines of comments that are not those that `identify` writes above a number, with or without their `#`.
pub fn remarks<'a>(lines: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let mut last = None;
    let mut is_own = |line: &str| {
        let words = line.trim_start_matches([' ', '\t', '#']);
        let Some(index) = FORM.iter().position(|begins| words.starts_with(begins)) else {
            return false;
        };
        let follows = match last {
            None => index == 0,
            Some(last) => index > last || [0, FORM.len() - 1].contains(&index),
        };
        if follows {
            last = Some(index);
        }
        follows
    };
    let lines = lines.into_iter();
    lines.filter(|line| !is_own(line)).collect()
}

/// Puts a comment above a key, apart from what stands there, in place of one of an earlier identification.
fn comment_above(document: &mut DocumentMut, (section, name): (&str, &str), comment: &[String]) {
    let table = document.get_mut(section).and_then(Item::as_table_mut);
    let Some(mut key) = table.and_then(|table| table.key_mut(name)) else {
        return;
    };
    let before = key.leaf_decor().prefix().and_then(|prefix| prefix.as_str());
    let before = before.unwrap_or_default();
    let lines: Vec<&str> = before.lines().collect();
    let earlier = lines.iter().position(|line| remarks([*line]).is_empty());
    let (above, below) = lines.split_at(earlier.unwrap_or(lines.len()));
    let below = remarks(below.iter().copied()).into_iter();
    let apart = if earlier.is_none() { "\n" } else { "" };
    let mut text: String = above.iter().map(|line| format!("{line}\n")).collect();
    text.push_str(apart);
    text.extend(comment.iter().map(|line| format!("# {line}\n")));
    // An empty line would part the comment from its key.
    let below = below.filter(|line| !line.trim().is_empty());
    text.extend(below.map(|line| format!("{line}\n")));
    key.leaf_decor_mut().set_prefix(text);
}
