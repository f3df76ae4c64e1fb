//! The scene that is written: the sketch with what is known of the device.

use passivity_core::{BigRational, Parameter};
use passivity_scene::{Motion, Scene, SceneError};
use toml_edit::{DocumentMut, Item, Table, value};

use crate::identified::{Bounds, Identified, IdentifyError};
use crate::report::{LogReport, above, below, nearest, unit};

/// A wall for sketches that have none: no parameter of the device depends on it.
const WALLS: [&str; 2] = ["1 N m/rad", "1 N/m"];

/// What is said in the scene beside the numbers.
#[derive(Clone, Debug, Default)]
pub struct Provenance {
    /// The logs.
    pub logs: Vec<LogReport>,
    /// Which device it was.
    pub device: Option<String>,
    /// When it was recorded.
    pub date: Option<String>,
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
        let row = parameter.row();
        match (self.motion, row.dimensionless_key) {
            (Motion::Dimensionless, Some(key)) => key,
            (Motion::Linear, _) if parameter == Parameter::Inertia => "device.mass",
            _ => row.key,
        }
    }

    /// Bounds of a parameter, rounded outwards, as a scene is given them; in words where nothing bounds it above.
    #[must_use]
    pub fn range(&self, parameter: Parameter, bounds: &Bounds) -> String {
        let (lo, unit) = (below(bounds.lo), unit(parameter, self.motion));
        match bounds.hi {
            Some(hi) => format!("{lo} … {}{unit}", above(hi)),
            None => format!("at least {lo}{unit}; nothing bounds it above"),
        }
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
        let text = document.to_string();
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
        let (section, name) = key.split_once('.').unwrap_or(("device", key));
        for other in keys
            .chain(row.dimensionless_key)
            .filter(|other| *other != key)
        {
            let (section, name) = other.split_once('.').unwrap_or(("device", other));
            let table = document.get_mut(section).and_then(Item::as_table_like_mut);
            if let Some(table) = table {
                table.remove(name);
            }
        }
        let place = document.entry(section).or_insert(Item::Table(Table::new()));
        let Some(table) = place.as_table_like_mut() else {
            return Err(IdentifyError::new(format!(
                "`{section}` is not a section of the sketch"
            )));
        };
        table.insert(name, value(text));
        Ok(())
    }

    /// Says above the sketch where the numbers come from.
    fn note(&self, document: &mut DocumentMut, said: &Provenance) {
        let plain = |text: &str| text.chars().filter(|c| !c.is_control()).collect::<String>();
        let mut lines = vec![
            "Friction identified by `passivity identify`: it is surely in these ranges, if \
                              the device is one of the model (TH-IDENT)."
                .to_owned(),
        ];
        for (parameter, bounds) in &self.parameters {
            if let Some(best) = bounds.best {
                let unit = unit(*parameter, self.motion);
                let name = parameter.row().name;
                let refuted = if self.best_refuted {
                    ", refuted by the logs"
                } else {
                    ""
                };
                let best = nearest(best);
                lines.push(format!("Best estimate of {name}: {best}{unit}{refuted}"));
            }
        }
        let device = said
            .device
            .iter()
            .map(|device| format!("Device: {}", plain(device)));
        lines.extend(device);
        lines.extend(
            said.date
                .iter()
                .map(|date| format!("Recorded: {}", plain(date))),
        );
        let logs = said
            .logs
            .iter()
            .map(|log| format!("Log: {}, sha256 {}", plain(&log.file), log.sha256));
        lines.extend(logs);
        let comment: String = lines.iter().map(|line| format!("# {line}\n")).collect();
        let first = document.iter().next().map(|(key, _)| key.to_owned());
        // The comment goes above the first section, or, where there are keys before it, above these.
        let Some(first) = first else { return };
        if let Some(table) = document.get_mut(&first).and_then(Item::as_table_mut) {
            let before = table
                .decor()
                .prefix()
                .and_then(|prefix| prefix.as_str())
                .unwrap_or_default();
            let prefix = above_own(&comment, before);
            table.decor_mut().set_prefix(prefix);
        } else if let Some(mut key) = document.key_mut(&first) {
            let before = key
                .leaf_decor()
                .prefix()
                .and_then(|prefix| prefix.as_str())
                .unwrap_or_default();
            let prefix = above_own(&comment, before);
            key.leaf_decor_mut().set_prefix(prefix);
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

/// A comment above what stood before; a line for editors stays the first.
fn above_own(comment: &str, before: &str) -> String {
    match before.split_once('\n') {
        Some((first, rest)) if first.starts_with("#:schema") => format!("{first}\n{comment}{rest}"),
        _ => format!("{comment}{before}"),
    }
}
