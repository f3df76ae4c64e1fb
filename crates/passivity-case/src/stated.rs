//! What a scene file says of the loop, each with where that is from: its parameters, and what has no unit and no
//! tolerance, as a delay, the side of a wall, a controller and a transmission.

use std::ops::Range;

use passivity_core::Parameter;
use passivity_scene::check::{enclosure, key_of, unit_of};
use passivity_scene::display::range;
use passivity_scene::{Given, Motion};
use toml::de::{DeTable, DeValue};

use crate::study::{Source, Study};

/// What a scene file says under a key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stated {
    /// The key, with its section.
    pub key: String,
    /// The text in the file.
    pub text: String,
    /// The value in SI units, as the criterion has it, and of what it is where the key is of something else, as of a rate or
    /// of friction at the motor; `None` of what has no unit.
    pub si: Option<String>,
    /// Where it is from, as far as the file says.
    pub source: Source,
}

/// The sections with keys that are no parameters; the keys are all of them where none is named.
const OTHERS: [(&str, &[&str]); 6] = [
    // Beside that of the device, with which it is one parameter.
    ("motor", &["inertia"]),
    ("sampling", &["delay"]),
    ("encoder", &["side"]),
    ("wall", &["unilateral"]),
    ("controller", &[]),
    ("transmission", &[]),
];

/// The value of a parameter in SI units, and of what it is where the file has another form of it.
fn in_si(parameter: Parameter, given: &Given, motion: Motion) -> String {
    let Some(value) = enclosure(&given.value) else {
        return "undefined".to_owned();
    };
    let key = key_of(parameter, motion);
    let of = match given.key == key {
        true => String::new(),
        false => format!("{key}: "),
    };
    let value = format!("{of}{} {}", range(&value), unit_of(parameter, motion));
    value.trim_end().to_owned()
}

/// A key with its section, where it is in the file, and where its value is.
type Place = (String, usize, Range<usize>);

/// Where the keys are that are no parameters.
fn others(text: &str) -> Vec<Place> {
    let Ok(file) = DeTable::parse(text) else {
        return Vec::new();
    };
    let mut places = Vec::new();
    for (section, entries) in file.get_ref() {
        let section = section.get_ref();
        let known = OTHERS.iter().find(|(name, _)| section == name);
        let (Some((_, keys)), DeValue::Table(entries)) = (known, entries.get_ref()) else {
            continue;
        };
        for (key, value) in entries {
            let name = key.get_ref();
            if keys.is_empty() || keys.contains(&name.as_ref()) {
                places.push((format!("{section}.{name}"), key.span().start, value.span()));
            }
        }
    }
    places
}

impl Study {
    /// What the file says of the loop, in its order, with the source of each.
    #[must_use]
    pub fn stated(&self) -> Vec<Stated> {
        let of_parameter = |(parameter, given): (Parameter, &Given)| {
            let si = in_si(parameter, given, self.scene.motion);
            let stated = Stated {
                key: given.key.to_owned(),
                text: given.text.clone(),
                si: Some(si),
                source: self.source(parameter, given),
            };
            (given.span.start, stated)
        };
        let of_other = |(key, at, value): Place| {
            let text = self.text.get(value).unwrap_or_default();
            let words: Vec<&str> = text.split_whitespace().collect();
            let stated = Stated {
                key,
                text: words.join(" ").trim_matches(['"', '\'']).to_owned(),
                si: None,
                source: self.source_at(at),
            };
            (at, stated)
        };
        let parameters = self.scene.parameters();
        let mut places = others(&self.text);
        places.retain(|(key, ..)| parameters.iter().all(|(_, given)| given.key != key));
        let parameters = parameters.into_iter().map(of_parameter);
        let mut all: Vec<_> = parameters.chain(places.into_iter().map(of_other)).collect();
        all.sort_by_key(|(at, _)| *at);
        all.into_iter().map(|(_, stated)| stated).collect()
    }

    /// The keys of which the file says no source.
    #[must_use]
    pub fn unsourced(&self) -> Vec<String> {
        let open = |stated: &Stated| stated.source == Source::None;
        let stated = self.stated().into_iter().filter(open);
        stated.map(|stated| stated.key).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use passivity_scene::Scene;

    use super::*;

    #[test]
    fn what_is_no_parameter_has_a_source_or_none() {
        let text = "[device]\nviscous = \"1 N m s/rad\" # bench\ncoulomb = \"1 N m\" # bench\n\
            [transmission]\nratio = \"15:1\" # drawing 7\n[sampling]\nperiod = \"1 ms\" # code\ndelay = 3\n\
            [wall]\nstiffness = \"10 N m/rad\" # R7\n# It is a floor.\nunilateral = true\n\
            [controller]\nnumerator = [\"7\",\n  \"-2.5\"]\ndenominator = [\"1\", \"-0.4\"] # TODO\n";
        let scene = Scene::from_toml("scene", text).expect("a scene");
        let study = Study::new(scene, text.to_owned(), Path::new("scene.toml"));
        let open = [
            "sampling.delay",
            "controller.numerator",
            "controller.denominator",
        ];
        // There is no comment at the head.
        assert_eq!(study.unsourced(), open);
        let stated = study.stated();
        let find = |key: &str| stated.iter().find(|one| one.key == key).expect(key);
        let si = |key: &str| find(key).si.clone().expect(key);
        assert_eq!(si("device.viscous"), "1 N m s/rad");
        let ratio = find("transmission.ratio");
        assert_eq!(ratio.source, Source::Comment("drawing 7".to_owned()));
        assert_eq!((ratio.text.as_str(), &ratio.si), ("15:1", &None));
        let side = find("wall.unilateral");
        assert_eq!(side.source, Source::Comment("It is a floor.".to_owned()));
        assert_eq!(find("controller.numerator").text, "[\"7\", \"-2.5\"]");
        assert_eq!(find("sampling.delay").text, "3");
        // Inertia is given in two places, each with a source of its own; alone it is in one.
        let motor = "[motor]\ninertia = \"9.4 g cm^2\" # TODO: source\n[sampling]";
        let alone = text.replace("[sampling]", motor);
        let both = alone.replace("[device]", "[device]\ninertia = \"2e-5 kg m^2\" # CAD");
        for (text, before) in [(alone, 0), (both, 1)] {
            let scene = Scene::from_toml("scene", &text).expect("a scene");
            let study = Study::new(scene, text, Path::new("scene.toml"));
            let stated = study.stated();
            let keys = stated.iter().filter(|one| one.key.ends_with(".inertia"));
            assert_eq!(keys.count(), before + 1);
            // At the device, 225 times as much.
            let motor = stated.iter().find(|one| one.key == "motor.inertia");
            let of_device = motor.and_then(|one| one.si.as_deref());
            let says = ["device.inertia: 0.0002115 kg m^2", ""][before];
            assert_eq!(of_device.unwrap_or_default(), says);
            let open = study.unsourced();
            assert!(open.contains(&"motor.inertia".to_owned()), "{open:?}");
            assert_eq!(open.len(), 4, "{open:?}");
        }
        // And the head speaks of all.
        let text = format!("# Ours.\n{text}").replace("# TODO", "");
        let scene = Scene::from_toml("scene", &text).expect("a scene");
        let study = Study::new(scene, text, Path::new("scene.toml"));
        assert_eq!(study.unsourced(), Vec::<String>::new());
    }
}
