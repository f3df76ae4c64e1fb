//! Scene files to begin with, commented.

/// For which kind of device a scene file is begun.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sketch {
    /// A rotary device: a knob, a wheel, a paddle.
    Rotary,
    /// A device that moves along a line.
    Linear,
    /// A device of several joints.
    Joints,
    /// Numbers without units: β, σ and μ.
    Dimensionless,
}

impl Sketch {
    /// A scene file with every section, those that are not needed as comments.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_scene::{Scene, parse::Sketch};
    ///
    /// assert!(Scene::from_toml("mine", Sketch::Rotary.text()).is_ok());
    /// ```
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Rotary => ROTARY,
            Self::Linear => LINEAR,
            Self::Joints => JOINTS,
            Self::Dimensionless => DIMENSIONLESS,
        }
    }
}

const ROTARY: &str = r#"#:schema scene.schema.json
# A rotary haptic device and a virtual wall. Fill in what your data sheet or your bench says, write where
# each number is from in place of "TODO: source", and ask `passivity check` about this file.
#
# A value is a number with a unit, and what is known of it: "9e-6 N m s/rad ± 10%", "4 … 6 mN m",
# "<0.05 N m". An effect whose key is not here is not in the scene.

[device]                             # what the hand holds
viscous = "9e-6 N m s/rad ± 10%"     # viscous friction; leave it out where there is none; TODO: source
coulomb = "2 mN m ± 5%"              # Coulomb friction; TODO: source
# inertia = "6.28e-6 kg m^2"         # needed to simulate and to identify; TODO: source

# [transmission]                     # where the motor turns faster than the device
# ratio = "15:1"                     # or motor_pulley = "5 mm" and output_pulley = "75 mm"; TODO: source
# [motor]                            # what is known at the motor's side, in place of [device]
# coulomb = "1.0 … 1.2 mN m"         # TODO: source

[sampling]
rate = "1 kHz"                       # or period = "1 ms"; TODO: source
# delay = 1                          # whole samples by which the force is late
# latency = "40 us"                  # time from a sample to the change of the output; TODO: source

[encoder]
counts_per_revolution = 8192         # behind the decoder; or resolution = "0.05 deg"; TODO: source
# side = "motor"                     # where it sits on the motor

[wall]
stiffness = "1 N m/rad"              # TODO: source
# unilateral = true                  # a wall on one side only
# damping = "1e-4 N m s/rad"         # virtual damping; TODO: source
# damping_cutoff = "50 Hz"           # of a filter on it; TODO: source
# max_force = "0.1 N m"              # the largest torque of the actuator; TODO: source
# force_step = "0.1 mN m"            # the step of the D/A converter; TODO: source

# [amplifier]
# time_constant = "0.2 ms"           # TODO: source

[operator]
max_speed = "3 rad/s"                # the hand is never faster; without it every speed is asked for; TODO: source
"#;

const LINEAR: &str = r#"#:schema scene.schema.json
# A haptic device that moves along a line, and a virtual wall. Fill in what your data sheet or your
# bench says, write where each number is from in place of "TODO: source", and ask `passivity check` about
# this file.
#
# A value is a number with a unit, and what is known of it: "0.5 N s/m ± 10%", "0.03 … 0.05 N",
# "<0.05 N". An effect whose key is not here is not in the scene.

[device]                             # what the hand holds
coulomb = "0.04 N ± 10%"             # Coulomb friction; TODO: source
# viscous = "0.5 N s/m"              # viscous friction; leave it out where there is none; TODO: source
# mass = "75 g"                      # needed to simulate and to identify; TODO: source

# [transmission]                     # a motor that drives the device by a cable
# motor_pulley = "5 mm"
# [motor]                            # what is known at the motor's side, in place of [device]
# coulomb = "1.0 … 1.2 mN m"         # TODO: source

[sampling]
rate = "1 kHz"                       # or period = "1 ms"; TODO: source
# delay = 1                          # whole samples by which the force is late
# latency = "40 us"                  # time from a sample to the change of the output; TODO: source

[encoder]
resolution = "0.03 mm"               # of the position; counts per revolution with side = "motor"; TODO: source

[wall]
stiffness = "1 N/mm"                 # TODO: source
# unilateral = true                  # a wall on one side only
# damping = "2 N s/m"                # virtual damping; TODO: source
# damping_cutoff = "50 Hz"           # of a filter on it; TODO: source
# max_force = "8.5 N"                # the largest force of the actuator; TODO: source
# force_step = "1 mN"                # the step of the D/A converter; TODO: source

# [amplifier]
# time_constant = "0.2 ms"           # TODO: source

[operator]
max_speed = "40 mm/s"                # the hand is never faster; without it every speed is asked for; TODO: source
"#;

const JOINTS: &str = r#"#:schema scene.schema.json
# A haptic device of several joints and a virtual wall at one pose of it. Fill in what your data sheets
# or your bench say, write where each number is from in place of "TODO: source", and ask `passivity check`
# about this file.
#
# A value is a number with a unit, and what is known of it: "9e-6 N m s/rad ± 10%", "4 … 6 mN m",
# "<0.05 N". A joint may turn (N m, rad) or move along a line (N, m).

[[joint]]                            # one of these for each joint, in order
name = "shoulder"
viscous = "0.01 N m s/rad ± 10%"     # viscous friction, at the joint; TODO: source
coulomb = "20 mN m"                  # Coulomb friction, at the joint; TODO: source
encoder = { counts_per_revolution = 65536 } # of the joint; or { resolution = "0.005 deg" }; TODO: source
# max_speed = "2 rad/s"              # the joint is never faster; without it every speed is asked for; TODO: source

[[joint]]
name = "elbow"
viscous = "0.01 N m s/rad ± 10%"     # TODO: source
coulomb = "20 mN m"                  # TODO: source
encoder = { counts_per_revolution = 65536 } # TODO: source
# max_speed = "2 rad/s"              # TODO: source

[sampling]
rate = "1 kHz"                       # or period = "1 ms"; TODO: source

[wall]
stiffness = "0.3 N/mm"               # along its normal; TODO: source
direction = ["0.2 m/rad", "0.05 m/rad"] # how far a radian of each joint moves the hand along the normal: Jᵀn; TODO: source
# unilateral = true                  # a wall on one side only
"#;

const DIMENSIONLESS: &str = r#"#:schema scene.schema.json
# A wall without units: lengths in ticks of the encoder, times in sampling periods, forces in KΔ.
# Write where each number is from in place of "TODO: source".

[dimensionless]
beta = "3/5"                         # β = b/(KT), viscous friction; TODO: source
sigma = "3/5"                        # σ = c/(KΔ), Coulomb friction; TODO: source
# mu = 50                            # μ = m/(KT²), inertia: needed to simulate and to identify; TODO: source

# [sampling]
# delay = 1                          # whole samples by which the force is late

# [wall]
# unilateral = true
# damping = "1/10"                   # virtual damping in KT; TODO: source

# [operator]
# max_speed = "2 ticks/sample"       # the hand is never faster; TODO: source

# [start]
# velocity = "5 ticks/sample"        # where a simulation starts; TODO: source
"#;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::AnyScene;
    use crate::check::Verdict;

    /// The sketch with every commented key and section in force, but for those that `left` names.
    fn uncommented(sketch: Sketch, left: &[&str]) -> String {
        let in_force = |line: &str| {
            let Some(code) = line.strip_prefix("# ") else {
                return line.to_owned();
            };
            let is_key = code
                .split_once(" = ")
                .is_some_and(|(key, _)| key.chars().all(|c| c.is_ascii_lowercase() || c == '_'));
            if is_key || code.starts_with('[') {
                code.to_owned()
            } else {
                line.to_owned()
            }
        };
        let lines = sketch.text().lines().map(in_force);
        let kept = lines.filter(|line| !left.iter().any(|left| line.starts_with(left)));
        kept.collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn each_sketch_is_a_scene_also_with_all_its_comments_in_force() {
        for sketch in [
            Sketch::Rotary,
            Sketch::Linear,
            Sketch::Joints,
            Sketch::Dimensionless,
        ] {
            let scene = AnyScene::from_toml("mine", sketch.text()).unwrap();
            assert_eq!(scene.check().verdict(), Verdict::Passive);
            // No number has a source before somebody writes one.
            let is_number = |line: &&str| {
                let code = line.strip_prefix("# ").unwrap_or(line);
                let keys_without = ["name", "side", "unilateral", "delay", "motor_pulley"];
                let key = code.split_once(" = ").map(|(key, _)| key);
                key.is_some_and(|key| !key.contains(' ') && !keys_without.contains(&key))
            };
            for line in sketch.text().lines().filter(is_number) {
                assert!(
                    line.contains("# ") && line.ends_with("TODO: source"),
                    "{line}"
                );
            }
            // Friction at the device goes where that at the motor is given.
            let text = uncommented(sketch, &["coulomb = \"2 mN", "coulomb = \"0.04"]);
            AnyScene::from_toml("mine", &text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        }
    }
}
