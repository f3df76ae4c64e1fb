//! What constants hold only with: every effect of a scene is named beside them.

use std::path::{Path, PathBuf};

use passivity_scene::check::{Target, Verdict, check, constants};
use passivity_scene::{Effect, Scene};

use crate::wall;

const TARGETS: [Target; 3] = [Target::C, Target::Chai3d, Target::OpenHaptics];

/// Each scene of a folder and those below it that describes a device of one joint in units.
fn scenes(folder: &Path, found: &mut Vec<Scene>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path: PathBuf = entry.unwrap().path();
        if path.is_dir() {
            scenes(&path, found);
        } else if path.extension().is_some_and(|end| end == "toml") {
            found.extend(Scene::read(&path));
        }
    }
}

/// The constant that stands for an effect, beside its words in the comment.
fn constant(effect: Effect) -> Option<&'static str> {
    Some(match effect {
        Effect::Encoder => "encoder_resolution",
        Effect::Delay => "delay",
        Effect::Latency => "latency",
        Effect::Unilateral => "one_sided",
        Effect::DampingFilter => "damping_time_constant",
        Effect::Controller => "controller_numerator",
        Effect::ForceStep => "force_step",
        Effect::Amplifier => "amplifier_time_constant",
        Effect::Saturation => "max_force",
        _ => return None,
    })
}

#[test]
fn every_effect_of_a_scene_is_named_beside_its_constants() {
    let mut all = Vec::new();
    scenes(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes"),
        &mut all,
    );
    assert!(all.len() > 25, "{}", all.len());
    all.push(wall::scene(
        "viscous 9, coulomb 9, delay 1, latency 1/3, time_constant 1/5, force_step 1/7, max_force 9, \
         unilateral true, damping 1/9, damping_time_constant 2",
    ));
    all.push(wall::scene(
        "viscous 9, coulomb 9, latency 1/3, numerator [\"1.5\",\"-0.5\"]",
    ));
    for scene in all {
        for target in TARGETS {
            let Some(constants) = constants(&scene, target) else {
                continue;
            };
            let json = serde_json::to_value(&constants).unwrap();
            let source = constants.to_source();
            let (comment, code) = source.split_once(" */\n").unwrap();
            let comment = comment.replace("\n * ", " ");
            let code = code.to_ascii_lowercase().replace('_', "");
            for effect in scene.effects() {
                let place = format!("{} for {target:?}: {effect:?}\n{source}", scene.name);
                assert!(comment.contains(effect.words()), "{place}");
                let Some(name) = constant(effect) else {
                    continue;
                };
                let in_code = match (effect, target) {
                    (Effect::Saturation, Target::Chai3d) => "info.mmax",
                    _ => &name.replace('_', ""),
                };
                assert!(code.contains(in_code), "{place}");
                let conditions = json["conditions"].as_array().unwrap();
                let is_there = conditions.iter().any(|condition| condition["name"] == name);
                assert!(is_there || !json[name].is_null(), "{place}");
            }
            // What the numbers rest on stands there as the scene writes it.
            for text in ["device.viscous", "device.coulomb"] {
                let given = scene
                    .parameters()
                    .into_iter()
                    .find(|(_, given)| given.key == text);
                if let Some((_, given)) = given {
                    assert!(
                        comment.contains(&format!("{text} {}", given.text)),
                        "{comment}"
                    );
                }
            }
        }
    }
}

/// The damping that passes behind the filter draws energy without it.
#[test]
fn a_filter_and_a_delay_stand_beside_the_damping_that_needs_them() {
    let values = "viscous 2, coulomb 2, delay 1, damping 1/2, damping_time_constant 3";
    let of = |target| constants(&wall::scene(values), target).unwrap();
    let found = of(Target::C);
    let most = found.max_damping.unwrap();
    let at = |filter: &str| {
        let typed = format!("viscous 2, coulomb 2, delay 1, damping {most}{filter}");
        check(&wall::scene(&typed)).verdict
    };
    assert_eq!(at(", damping_time_constant 3"), Verdict::Passive);
    assert_eq!(at(""), Verdict::NotPassive);
    let source = found.to_source();
    let code = source.split_once(" */\n").unwrap().1;
    let expected = format!(
        "\
#ifndef TEST_WALL_H
#define TEST_WALL_H

#define TEST_STIFFNESS 1.0 /* N/m, under the conditions below */
#define TEST_MAX_STIFFNESS {:?} /* N/m, with TEST_DAMPING and under the conditions below */
#define TEST_DAMPING 0.5 /* N s/m, under the conditions below */
#define TEST_MAX_DAMPING {most:?} /* N s/m, with TEST_STIFFNESS and under the conditions below */
#define TEST_SAMPLING_RATE 1.0 /* Hz */
/* TEST_MAX_SPEED: not bounded, the verdict holds at every speed or at none */
/* TEST_MAX_FORCE: not in the scene */
/* Conditions: the numbers above hold only with all of these. */
#define TEST_DELAY 1 /* samples, after which the force of a sample is given out, and not at once */
#define TEST_DAMPING_TIME_CONSTANT 3.0 /* s, of the one-pole filter that the damping stands behind */
#define TEST_DAMPING_POLE 0.75 /* a of that filter */
#define TEST_ENCODER_RESOLUTION 1.0 /* m, of the device's position, a count */

#endif
",
        found.max_stiffness.unwrap()
    );
    assert_eq!(code, expected);
    let comment = source.replace("\n * ", " ");
    assert!(comment.contains("y = a y + (1 - a) d"), "{comment}");
    // A delay and damping cost less together in a linear loop than behind a law that is not.
    let also = "of a loop that also has latency before the output changes, or a wall on one side only, or saturation";
    assert!(comment.contains(also), "{comment}");
    let millimetres = of(Target::OpenHaptics).to_source();
    let lines = "\
static const int kDelay = 1; /* samples, after which the force of a sample is given out, and not at once */
static const HDdouble kDampingTimeConstant = 3.0; /* s, of the one-pole filter that the damping stands behind */
static const HDdouble kDampingPole = 0.75; /* a of that filter */
static const HDdouble kEncoderResolution = 1000.0; /* mm, of the device's position, a count */
";
    assert!(millimetres.ends_with(lines), "{millimetres}");
    let fields = of(Target::Chai3d).to_source();
    assert!(
        fields.contains("\nconst double dampingPole = 0.75; /*"),
        "{fields}"
    );
    assert!(
        fields.contains("Damping = 0.5; /* the scene's, under the conditions below */"),
        "{fields}"
    );
}

#[test]
fn what_a_scene_does_not_have_is_not_shown() {
    let absent = |values: &str| {
        let found = constants(&wall::scene(values), Target::C);
        found.unwrap().not_shown_with
    };
    let linear = [
        Effect::Unilateral.words(),
        Effect::Saturation.words(),
        Effect::Delay.words(),
    ];
    // A plain wall passes behind any law (TH-LAW), and with all its effects nothing is left to add.
    let plain = absent("viscous 3/4, coulomb 5/4");
    assert_eq!(
        linear.map(|words| plain.contains(&words)),
        [false, false, true]
    );
    // Late by a sample, a lead costs 5/4 in a linear loop and 2 behind another law.
    let led = absent("viscous 3, coulomb 3, delay 1, numerator [\"1.5\",\"-0.5\"]");
    assert_eq!(
        linear.map(|words| led.contains(&words)),
        [true, true, false]
    );
    // So does damping that is late: λ = 5/4 in a linear loop, ½ + 1 + ½ behind another law.
    for viscous in ["5/4", "19/10"] {
        let values = format!("viscous {viscous}, coulomb 9, delay 1, damping 1/2");
        let late = absent(&values);
        let named = linear.map(|words| late.contains(&words));
        assert_eq!(named, [true, true, false], "{values}");
        for law in ["unilateral true", "max_force 9"] {
            let verdict = wall::report(&format!("{values}, {law}")).verdict;
            assert_eq!(verdict, Verdict::NotGuaranteed, "{values}, {law}");
        }
    }
    let all = "viscous 9, coulomb 9, delay 1, latency 1/3, time_constant 1/5, force_step 1/7, max_force 9, \
               unilateral true, damping 1/9, damping_time_constant 2";
    assert_eq!(absent(all), [""; 0]);
}

/// Coefficients are written as doubles where those pass, and it is said where they do not.
#[test]
fn coefficients_of_a_controller_are_doubles_that_pass() {
    let coefficients = |values: &str| {
        let found = constants(&wall::scene(values), Target::C).unwrap();
        let is_numerator = |name| name == "controller_numerator";
        let mut found = found.conditions.into_iter();
        let found = found
            .find(|condition| is_numerator(condition.name))
            .unwrap();
        (serde_json::to_value(found.value).unwrap(), found.about)
    };
    let exactly = "of z^0, z^-1, ... in H";
    let (values, about) = coefficients("viscous 3, coulomb 3, numerator [\"1.5\",\"-0.5\"]");
    assert_eq!((values, about), (serde_json::json!([1.5, -0.5]), exactly));
    let (_, about) = coefficients("viscous 3, coulomb 3, numerator [\"4/3\",\"-1/3\"]");
    assert_eq!(about, exactly);
    // H(1) = 0, and below it in doubles: 0.1 + 0.7 and the double above 0.8.
    let (_, about) = coefficients("viscous 3, coulomb 3, numerator [\"0.7\",\"0.1\",\"-0.8\"]");
    assert!(
        about.contains("nothing is shown of these doubles"),
        "{about}"
    );
}
