//! What is proposed for an unknown unit: only what the value can then be.

use passivity_scene::Scene;

/// A section, a key of it and a value.
type Line = (&'static str, &'static str, &'static str);

const LINEAR: &[Line] = &[
    ("device", "viscous", "0.5 N s/m"),
    ("device", "coulomb", "0.04 N"),
    ("device", "mass", "75 g"),
    ("sampling", "rate", "1 kHz"),
    ("sampling", "latency", "10 us"),
    ("encoder", "resolution", "0.03 mm"),
    ("wall", "stiffness", "1 N/mm"),
    ("wall", "damping", "0.01 N s/m"),
    ("wall", "damping_cutoff", "50 Hz"),
    ("wall", "max_force", "8 N"),
    ("operator", "max_speed", "40 mm/s"),
];

const ROTARY: &[Line] = &[
    ("device", "viscous", "0.01 N m s/rad"),
    ("device", "coulomb", "2 mN m"),
    ("device", "inertia", "6e-6 kg m^2"),
    ("sampling", "rate", "1 kHz"),
    ("sampling", "latency", "10 us"),
    ("encoder", "resolution", "0.05 deg"),
    ("wall", "stiffness", "1 N m/rad"),
    ("wall", "damping", "1e-4 N m s/rad"),
    ("wall", "damping_cutoff", "50 Hz"),
    ("wall", "max_force", "0.1 N m"),
    ("operator", "max_speed", "3 rad/s"),
];

/// Units as people spell them, for keys of the linear scene.
const SPELT_LINEAR: &[(&str, &str)] = &[
    (
        "viscous",
        "Ns/m|N*sec/m|N.s/m|Nsec/m|N/(m/s)|N/m/s|kg/s|lbf s/in|lbs s/in|lb-s/in|mN/(mm/s)|\
         mNs/mm|N·s/M|Newton s/m|n s/m|N sec/m|Ns/mm|gf s/cm",
    ),
    (
        "coulomb",
        "Newton|newtons|n|lbs|lbf|ozs|oz|gram|grams|gr|g|kgf|kg|cN|dyn|dyne|kp|pond|p|mn|gF|\
         LB|Lbf|OZ|lbs.|ounces|pounds|mNs",
    ),
    ("mass", "grams|Kg|KG|kgs|gr|lbs|lb|slug|oz|tonne|t|gram|G"),
    (
        "rate",
        "KHz|Khz|khz|HZ|hz|Hertz|Hz.|sps|S/s|/s|1/s|s^-1|per second|kSps|Samples/s|rps|rpm|\
         cps|MHZ",
    ),
    (
        "latency",
        "µs|μs|usec|msec|microseconds|sec|seconds|Us|uS|mS|MS|S|ticks|samples|min|h|nS",
    ),
    (
        "resolution",
        "MM|Mm|micrometer|um|µ|mil|mils|inch|inches|\"|thou|counts|counts/mm|1/mm|mm/count|\
         mm/tick|nm|cm|in.",
    ),
    (
        "stiffness",
        "N/MM|N/Mm|n/mm|N/um|kN/M|lbs/in|lbf/in|lb/inch|kgf/cm|g/mm|KN/m|kn/m|N/cm|N mm|Nm|\
         N/m2|N/m^2|oz/in|kg/cm|N per mm|N/ mm|N /mm",
    ),
    (
        "max_speed",
        "mm/sec|m/S|M/s|cm/sec|in/s|ips|inches/s|ft/min|fps|mps|kmh|km/h|mm/min|rpm",
    ),
    ("damping_cutoff", "rad/s|krad/s|hz|HZ|Hertz|rad/sec"),
];

const SPELT_ROTARY: &[(&str, &str)] = &[
    (
        "viscous",
        "Nms/rad|Nm s|mNm/krpm|mN m/rpm|oz-in/krpm|oz-in s|ozin/krpm|Nm-s/rad|N.m.s|Nmsec/rad|\
         Nm/(rad/s)|Nm/rad/s|lb in s|gcm/rpm|Nms|mNms|uNms/rad|Nm/rps|N m s/deg|N-m-sec",
    ),
    (
        "coulomb",
        "NM|nm|Nm|mNm|ozin|oz.in|oz-in|oz in.|ozf in|in-oz|in-lb|in lbs|lb-ft|ft lbs|lbft|\
         kgcm|kg-cm|gfcm|gcm|g-cm|Ncm|N-cm|cNm|uNm|N/m|mNM|Nmm|dyn cm|inlb|ft-lb|ft.lbs|\
         kgf.cm|Newton-meters|N·m",
    ),
    (
        "inertia",
        "gcm^2|g-cm2|g cm²|gcm2|kgm2|kg m2|kg-m^2|kgcm^2|oz-in-s^2|oz in s²|lb in^2|slug ft^2|\
         g*cm*cm|kgm^2|oz-in^2|gcm²|kg.m²",
    ),
    (
        "resolution",
        "degrees|degree|Deg|°|º|'|arc min|arcmin.|arcminutes|radians|mrad|urad|rad|revs|turns|\
         LSB|counts|grad|\"|arcseconds|″|mdeg",
    ),
    (
        "stiffness",
        "Nm/°|Nm/deg|N m/degree|Nm/degrees|Nm/rev|Nm|oz-in/deg|ozin/deg|mNm/°|N m/radian|\
         N.m/rad|NM/rad|Nm/Rad|N/mm|Nmm/rad|lb-in/rad|in-lbs/rad|Nm/turn|kgcm/deg",
    ),
    (
        "max_speed",
        "RPM|Rpm|rev/min|revs/min|rev/s|r/min|1/min|min^-1|deg/sec|°/s|dps|rad/sec|radians/s|\
         rads/s|Hz|krpm|RPS|turns/s|rot/s|tr/min|U/min",
    ),
];

/// Reads a scene with another unit of one key; the error is what is proposed, or empty.
fn read(lines: &[Line], key: &str, unit: &str) -> Result<(), String> {
    let mut text = String::new();
    let mut last = "";
    for (section, name, value) in lines {
        if *section != last {
            text += &format!("[{section}]\n");
            last = section;
        }
        let other = format!("1 {}", unit.replace('"', "\\\""));
        let value = if *name == key { &other } else { *value };
        text += &format!("{name} = \"{value}\"\n");
    }
    let Err(error) = Scene::from_toml("spelt", &text) else {
        return Ok(());
    };
    let first = &error.to_json()["errors"][0];
    Err(first["help"].as_str().unwrap_or_default().to_owned())
}

#[test]
fn every_unit_that_is_proposed_is_one_of_its_key() {
    let mut proposals = 0;
    for (lines, spelt) in [(LINEAR, SPELT_LINEAR), (ROTARY, SPELT_ROTARY)] {
        for (key, units) in spelt {
            for unit in units.split('|') {
                let Err(help) = read(lines, key, unit) else {
                    continue;
                };
                let quoted = help.split('`').skip(1).step_by(2);
                for proposed in quoted {
                    proposals += 1;
                    let again = read(lines, key, proposed);
                    assert_eq!(again, Ok(()), "{key} = `{unit}`: {help}");
                }
            }
        }
    }
    assert!(proposals > 100, "{proposals}");
}

#[test]
fn an_unknown_unit_comes_with_what_may_have_been_meant() {
    for (lines, key, unit, meant) in [
        (LINEAR, "rate", "khz", "`kHz`"),
        (LINEAR, "rate", "MHZ", "`MHz`"),
        (LINEAR, "rate", "Mhz", "`MHz`"),
        (LINEAR, "rate", "mhz", "`mHz` or `MHz`"),
        (LINEAR, "rate", "sps", ""),
        (ROTARY, "max_speed", "RPM", "`rpm`"),
        (ROTARY, "max_speed", "revs/min", "`rev/min`"),
        (ROTARY, "max_speed", "turns/s", "`turn/s`"),
        (ROTARY, "max_speed", "rads/s", "`rad/s`"),
        (LINEAR, "max_speed", "mps", ""),
        (LINEAR, "max_speed", "furlong/s", ""),
        (ROTARY, "viscous", "Nms", "`Nm s`"),
        (ROTARY, "viscous", "Nms/rad", "`Nm s/rad`"),
        (ROTARY, "viscous", "Nmsec/rad", "`Nm sec/rad`"),
        (LINEAR, "viscous", "Nsec/m", "`N sec/m`"),
        (LINEAR, "viscous", "Ns/m", "`N s/m`"),
        (LINEAR, "viscous", "lbs s/in", "`lb s/in`"),
        (LINEAR, "stiffness", "lbs/in", "`lb/in`"),
        (LINEAR, "stiffness", "Ns/m", ""),
        (ROTARY, "stiffness", "in-lbs/rad", "`in-lb/rad`"),
        (ROTARY, "stiffness", "Mn m/rad", "`MN m/rad`"),
        (ROTARY, "stiffness", "mn m/rad", "`mN m/rad` or `MN m/rad`"),
        (ROTARY, "coulomb", "ft lbs", "`ft lb`"),
        (ROTARY, "coulomb", "ft.lbs", "`ft.lb`"),
        (ROTARY, "coulomb", "Newton-meters", "`newton-meter`"),
        (ROTARY, "coulomb", "mNM", "`mNm`"),
        (LINEAR, "coulomb", "newtons", "`newton`"),
        (LINEAR, "coulomb", "LB", "`lbf`"),
        (LINEAR, "coulomb", "OZ", "`ozf`"),
        (LINEAR, "coulomb", "lbs", "`lbf`"),
        (LINEAR, "coulomb", "ozs", "`ozf`"),
        (LINEAR, "coulomb", "kgs", "`kgf`"),
        (LINEAR, "mass", "kgs", "`kg`"),
        (LINEAR, "mass", "lbs", "`lb`"),
        (LINEAR, "mass", "mgs", "`mg`"),
        (ROTARY, "inertia", "kgm^2", "`kg m^2`"),
        (ROTARY, "resolution", "revs", "`rev`"),
        (ROTARY, "resolution", "Grad", ""),
        (LINEAR, "latency", "Ms", "`ms`"),
        (LINEAR, "latency", "Msec", "`msec`"),
        (LINEAR, "latency", "Min", "`min`"),
        (LINEAR, "latency", "Ts", ""),
        (LINEAR, "latency", "Gs", ""),
        (LINEAR, "resolution", "Mm", "`mm`"),
        (ROTARY, "resolution", "Mrad", "`mrad`"),
        (ROTARY, "resolution", "MRad", "`mrad`"),
        (ROTARY, "resolution", "Trad", ""),
        (LINEAR, "resolution", "Pin", ""),
        (LINEAR, "latency", "Tick", ""),
    ] {
        let help = match meant {
            "" => String::new(),
            meant => format!("did you mean {meant}?"),
        };
        assert_eq!(read(lines, key, unit), Err(help), "{key} = `{unit}`");
    }
}
