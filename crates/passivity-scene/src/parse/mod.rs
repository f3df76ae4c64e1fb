//! Reading scenes from files, from TOML and from JSON.

mod amount;
mod axis;
mod build;
mod controller;
mod costs;
mod encoder;
mod file;
mod given;
mod joint_wall;
mod joints;
mod keys;
mod measure;
mod motion;
mod node;
mod operator;
mod reader;
mod samples;
mod schema;
mod sketch;
mod transmission;

pub use amount::{MAX_NUMBER_CHARS, MAX_NUMBER_EXPONENT};
pub use axis::{Axis, AxisError};
pub use build::MAX_INTERVALS;
pub use encoder::MAX_COUNTS;
pub use joints::MAX_JOINTS;
pub use samples::{MAX_BYTES as MAX_SAMPLE_BYTES, MAX_SAMPLES};
pub use schema::schema;
pub use sketch::Sketch;

use std::path::Path;

use serde_json::Value;

use passivity_core::{BigRational, Parameter};

use crate::any::AnyScene;
use crate::diagnostic::{Diagnostic, Kind, SceneError};
use crate::number;
use crate::parse::node::Entry;
use crate::parse::reader::Reader;
use crate::scene::{Given, Motion, Scene};

/// The largest scene file, in bytes: a thousand times what a scene needs.
pub const MAX_BYTES: u64 = 256 << 10;

/// The contents of a regular file, or of what a shell hands over, unless it is longer than `most` bytes: at most so many
/// are taken from what has no end.
///
/// # Errors
///
/// In words, why it cannot be read, and what was expected.
pub fn bytes_of(path: &Path, most: u64) -> Result<Vec<u8>, String> {
    file::read(path, most).map_err(|diagnostic| match diagnostic.expected {
        Some(expected) => format!("{}, expected {expected}", diagnostic.message),
        None => diagnostic.message,
    })
}

/// The name of a scene by its file, and the text of the file, for readers that need it beside the scene.
///
/// # Errors
///
/// [`SceneError`] where the file cannot be read, is larger than [`MAX_BYTES`], or is no text in UTF-8.
pub fn named_text(path: &Path) -> Result<(String, String), SceneError> {
    let shown = path.display().to_string();
    let refuse =
        |text: &str, diagnostic: Diagnostic| SceneError::new(&shown, text, vec![diagnostic]);
    let bytes = file::read(path, MAX_BYTES).map_err(|diagnostic| refuse("", *diagnostic))?;
    let text = file::text(bytes).map_err(|(text, diagnostic)| refuse(&text, *diagnostic))?;
    let name = path.file_stem().map(|stem| stem.to_string_lossy());
    Ok((name.as_deref().unwrap_or("scene").to_owned(), text))
}

impl Scene {
    /// Reads a scene file.
    ///
    /// The scene's name is that of the file without folder and extension, unless `name` at the top
    /// of the file says otherwise. Files that the scene names are looked for in its own folder.
    ///
    /// # Errors
    ///
    /// [`SceneError`] with everything that is wrong with the file and can be told at once.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SceneError> {
        Self::read_with_text(path.as_ref()).map(|(scene, _)| scene)
    }

    /// Reads a scene file, as [`read`](Self::read) does, and gives its text beside the scene.
    ///
    /// # Errors
    ///
    /// As for [`read`](Self::read).
    pub fn read_with_text(path: &Path) -> Result<(Self, String), SceneError> {
        read(path, build)
    }

    /// Reads a scene from a stream, such as a pipe; `name` is what errors call it. It may name files
    /// relative to where the program runs.
    ///
    /// # Errors
    ///
    /// [`SceneError`] as for [`read`](Self::read).
    pub fn from_reader(name: &str, stream: impl std::io::Read) -> Result<Self, SceneError> {
        from_reader(name, stream, build)
    }

    /// Reads a scene from the text of a scene file. It may name no other files.
    ///
    /// # Errors
    ///
    /// [`SceneError`] with everything that is wrong with the text and can be told at once.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::{Motion, Scene};
    ///
    /// let text = r#"
    ///     [sampling]
    ///     rate = "1 kHz"
    ///     [wall]
    ///     stiffness = "2 N/mm ± 5%"
    /// "#;
    /// let scene = Scene::from_toml("spring", text).unwrap();
    /// assert_eq!(scene.motion, Motion::Linear);
    /// assert_eq!(scene.given.stiffness.value.lo().to_rational().unwrap().to_string(), "1900");
    /// ```
    pub fn from_toml(name: &str, text: &str) -> Result<Self, SceneError> {
        from_toml(name, text, build)
    }

    /// Reads a scene from a JSON object with the sections and keys of a scene file. It may name no
    /// files.
    ///
    /// # Errors
    ///
    /// [`SceneError`] with everything that is wrong with the object, by key.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::Scene;
    ///
    /// let value = serde_json::json!({"dimensionless": {"beta": "3/5", "sigma": 0.6}});
    /// let scene = Scene::from_json(&value).unwrap();
    /// assert_eq!(scene.point().at.friction().sigma.to_string(), "3/5");
    /// ```
    pub fn from_json(value: &Value) -> Result<Self, SceneError> {
        from_json(value, build)
    }
}

impl AnyScene {
    /// Reads a scene file of either kind, as [`Scene::read`] does one of a single joint.
    ///
    /// # Errors
    ///
    /// [`SceneError`] with everything that is wrong with the file and can be told at once.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SceneError> {
        read(path.as_ref(), build_any).map(|(scene, _)| scene)
    }

    /// Reads a scene of either kind from a stream, as [`Scene::from_reader`] does.
    ///
    /// # Errors
    ///
    /// [`SceneError`] as for [`read`](Self::read).
    pub fn from_reader(name: &str, stream: impl std::io::Read) -> Result<Self, SceneError> {
        from_reader(name, stream, build_any)
    }

    /// Reads a scene of either kind from the text of a scene file, as [`Scene::from_toml`] does.
    ///
    /// # Errors
    ///
    /// [`SceneError`] with everything that is wrong with the text and can be told at once.
    pub fn from_toml(name: &str, text: &str) -> Result<Self, SceneError> {
        from_toml(name, text, build_any)
    }

    /// Reads a scene of either kind from a JSON object, as [`Scene::from_json`] does.
    ///
    /// # Errors
    ///
    /// [`SceneError`] with everything that is wrong with the object, by key.
    pub fn from_json(value: &Value) -> Result<Self, SceneError> {
        from_json(value, build_any)
    }
}

impl Scene {
    /// Another value of a parameter that is in the scene, from the text that its file could have: of the
    /// same key, or of another key of the parameter where the unit is one of that.
    pub(crate) fn reread(&self, now: &Given, text: &str) -> Result<Given, SceneError> {
        let row = |parameter: &&Parameter| {
            let row = parameter.row();
            row.key == now.key || row.other_keys.contains(&now.key)
        };
        let Some(parameter) = Parameter::ALL.iter().find(row) else {
            unreachable!("a parameter of a scene has a row in the table");
        };
        let at_motor = now.written.is_at_motor();
        let attempt = |key: &'static str| self.value(*parameter, key, at_motor, text);
        let row = parameter.row();
        let others = [row.key].into_iter().chain(row.other_keys.iter().copied());
        let others = others.filter(|key| *key != now.key && !key.starts_with("motor."));
        // Where the unit is one of a key's, what is wrong with the value is the cause.
        let is_of_key = |problems: &Vec<Diagnostic>| {
            let causes = [
                Kind::OutOfBounds,
                Kind::ToleranceOutOfBounds,
                Kind::MixedMotion,
            ];
            problems
                .iter()
                .any(|problem| causes.contains(&problem.kind))
        };
        let mut cause: Option<Vec<Diagnostic>> = None;
        for attempt in [now.key].into_iter().chain(others).map(attempt) {
            match attempt {
                Ok(given) => return Ok(given),
                Err(problems) => {
                    let is_closer =
                        |found: &Vec<Diagnostic>| is_of_key(&problems) && !is_of_key(found);
                    if cause.as_ref().is_none_or(is_closer) {
                        cause = Some(problems);
                    }
                }
            }
        }
        Err(of_text(text, cause.unwrap_or_default()))
    }

    /// A speed as it was typed, in ticks per sample: a plain number is one already, and one with a unit
    /// is of the scene's motion.
    ///
    /// # Errors
    ///
    /// [`SceneError`] where the text is no speed.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::Scene;
    ///
    /// let text = r#"
    ///     [sampling]
    ///     rate = "1 kHz"
    ///     [encoder]
    ///     resolution = "0.01 mm"
    ///     [wall]
    ///     stiffness = "1 N/mm"
    /// "#;
    /// let scene = Scene::from_toml("slide", text).unwrap();
    /// assert_eq!(scene.ticks_per_sample("20 mm/s").unwrap().to_string(), "2");
    /// assert_eq!(scene.ticks_per_sample("2").unwrap().to_string(), "2");
    /// ```
    pub fn ticks_per_sample(&self, text: &str) -> Result<BigRational, SceneError> {
        if let Ok(ticks) = number::parse(text.trim()) {
            return Ok(ticks);
        }
        let key = Parameter::StartVelocity.row().key;
        let given = self
            .value(Parameter::StartVelocity, key, false, text)
            .map_err(|problems| of_text(text, problems))?;
        let mut with_speed = self.clone();
        with_speed.given.start_velocity = Some(given);
        let [_, speed] = with_speed.point().start();
        Ok(speed)
    }

    /// The value that the text of a key stands for in this scene.
    fn value(
        &self,
        parameter: Parameter,
        key: &'static str,
        at_motor: bool,
        text: &str,
    ) -> Result<Given, Vec<Diagnostic>> {
        let mut reader = Reader {
            problems: Vec::new(),
            unit_notes: Vec::new(),
            dimensionless: self.motion == Motion::Dimensionless,
            transmission: self.transmission.clone(),
            folder: None,
        };
        let entry = Entry::of_text(key, text.trim());
        let given = build::value(parameter, key, at_motor, entry, &mut reader);
        let of_other_motion = reader.motion().is_some_and(|motion| motion != self.motion);
        match given {
            Some(given) if !of_other_motion => Ok(given),
            Some(_) => {
                let message = format!("`{text}` is of another motion than the scene");
                let diagnostic = Diagnostic::new(Kind::MixedMotion, message).key(key);
                Err(vec![
                    diagnostic.expected("a unit of the scene's own motion"),
                ])
            }
            None => Err(reader.problems),
        }
    }
}

/// The error about a text that stands in no file.
fn of_text(text: &str, problems: Vec<Diagnostic>) -> SceneError {
    let unplaced = |mut diagnostic: Diagnostic| {
        diagnostic.span = None;
        diagnostic
    };
    let problems = problems.into_iter().map(unplaced).collect();
    SceneError::new(&format!("`{text}`"), "", problems)
}

/// What makes a scene of the tree of a file; files that it names are looked for in a folder, or it may
/// name none.
type Build<T> = fn(&str, Vec<Entry>, Option<&Path>) -> Result<T, Vec<Diagnostic>>;

fn read<T>(path: &Path, build: Build<T>) -> Result<(T, String), SceneError> {
    let (name, text) = named_text(path)?;
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let shown = path.display().to_string();
    let read = parse((&shown, &name), &text, Some(folder), build)?;
    Ok((read, text))
}

fn from_reader<T>(
    name: &str,
    stream: impl std::io::Read,
    build: Build<T>,
) -> Result<T, SceneError> {
    let refuse = |diagnostic: Box<Diagnostic>| SceneError::new(name, "", vec![*diagnostic]);
    let bytes = file::limited(stream, MAX_BYTES).map_err(refuse)?;
    let text = file::text(bytes)
        .map_err(|(text, diagnostic)| SceneError::new(name, &text, vec![*diagnostic]))?;
    parse((name, name), &text, Some(Path::new("")), build)
}

fn from_toml<T>(name: &str, text: &str, build: Build<T>) -> Result<T, SceneError> {
    if u64::try_from(text.len()).unwrap_or(u64::MAX) > MAX_BYTES {
        return Err(SceneError::new(name, "", vec![file::too_large(MAX_BYTES)]));
    }
    parse((name, name), text, None, build)
}

fn from_json<T>(value: &Value, build: Build<T>) -> Result<T, SceneError> {
    const NAME: &str = "scene";
    let built = node::from_json(value)
        .map_err(|diagnostic| vec![*diagnostic])
        .and_then(|entries| build(NAME, entries, None));
    built.map_err(|mut diagnostics| {
        // There is no text that a place could be in.
        for diagnostic in &mut diagnostics {
            diagnostic.span = None;
        }
        SceneError::new(NAME, "", diagnostics)
    })
}

/// Reads a text: of what errors call it and of the scene's name, the text and the folder of its files.
fn parse<T>(
    (shown, name): (&str, &str),
    text: &str,
    folder: Option<&Path>,
    build: Build<T>,
) -> Result<T, SceneError> {
    node::from_toml(text)
        .map_err(|diagnostic| vec![*diagnostic])
        .and_then(|entries| build(name, entries, folder))
        .map_err(|diagnostics| SceneError::new(shown, text, diagnostics))
}

fn reader(folder: Option<&Path>) -> Reader<'_> {
    Reader {
        problems: Vec::new(),
        unit_notes: Vec::new(),
        dimensionless: false,
        transmission: None,
        folder,
    }
}

fn of_joints(entries: &[Entry]) -> Option<&Entry> {
    entries.iter().find(|entry| entry.key == joints::KEY)
}

fn build(name: &str, entries: Vec<Entry>, folder: Option<&Path>) -> Result<Scene, Vec<Diagnostic>> {
    if let Some(entry) = of_joints(&entries) {
        return Err(vec![joints::not_here(entry)]);
    }
    let mut reader = reader(folder);
    build::scene(name, entries, &mut reader).ok_or(reader.problems)
}

fn build_any(
    name: &str,
    entries: Vec<Entry>,
    folder: Option<&Path>,
) -> Result<AnyScene, Vec<Diagnostic>> {
    if of_joints(&entries).is_none() {
        return build(name, entries, folder).map(|scene| AnyScene::One(Box::new(scene)));
    }
    let mut reader = reader(folder);
    let scene = joints::scene(name, entries, &mut reader);
    scene
        .map(|scene| AnyScene::Joints(Box::new(scene)))
        .ok_or(reader.problems)
}
