//! Reading scenes from files, from TOML and from JSON.

mod amount;
mod axis;
mod build;
mod controller;
mod costs;
mod file;
mod keys;
mod measure;
mod node;
mod operator;
mod reader;
mod samples;

pub use amount::{MAX_NUMBER_CHARS, MAX_NUMBER_EXPONENT};
pub use axis::{Axis, AxisError};
pub use build::{MAX_COUNTS, MAX_INTERVALS};
pub use samples::{MAX_BYTES as MAX_SAMPLE_BYTES, MAX_SAMPLES};

use std::path::Path;

use serde_json::Value;

use crate::diagnostic::{Diagnostic, SceneError};
use crate::parse::node::Entry;
use crate::parse::reader::Reader;
use crate::scene::Scene;

/// The largest scene file, in bytes: a thousand times what a scene needs.
pub const MAX_BYTES: u64 = 256 << 10;

/// The contents of a file, unless it is longer than `most` bytes.
pub(crate) fn bytes_of(path: &Path, most: u64) -> Result<Vec<u8>, String> {
    file::read(path, most).map_err(|diagnostic| match diagnostic.expected {
        Some(expected) => format!("{}, expected {expected}", diagnostic.message),
        None => diagnostic.message,
    })
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
        let path = path.as_ref();
        let shown = path.display().to_string();
        let refuse = |diagnostic: Box<Diagnostic>| SceneError::new(&shown, "", vec![*diagnostic]);
        let bytes = file::read(path, MAX_BYTES).map_err(refuse)?;
        let text = file::text(bytes)
            .map_err(|(text, diagnostic)| SceneError::new(&shown, &text, vec![*diagnostic]))?;
        let name = path.file_stem().map(|stem| stem.to_string_lossy());
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        parse(
            &shown,
            name.as_deref().unwrap_or("scene"),
            &text,
            Some(folder),
        )
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
        if u64::try_from(text.len()).unwrap_or(u64::MAX) > MAX_BYTES {
            return Err(SceneError::new(name, "", vec![file::too_large(MAX_BYTES)]));
        }
        parse(name, name, text, None)
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
}

fn parse(shown: &str, name: &str, text: &str, folder: Option<&Path>) -> Result<Scene, SceneError> {
    node::from_toml(text)
        .map_err(|diagnostic| vec![*diagnostic])
        .and_then(|entries| build(name, entries, folder))
        .map_err(|diagnostics| SceneError::new(shown, text, diagnostics))
}

fn build(name: &str, entries: Vec<Entry>, folder: Option<&Path>) -> Result<Scene, Vec<Diagnostic>> {
    let mut reader = Reader {
        problems: Vec::new(),
        unit_notes: Vec::new(),
        dimensionless: false,
        folder,
    };
    build::scene(name, entries, &mut reader).ok_or(reader.problems)
}
