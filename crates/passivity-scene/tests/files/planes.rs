//! The borders of the plane of two parameters against the verdict on scenes with the numbers typed in.

use passivity_scene::check::{Verdict, check};
use passivity_scene::plane::{Extent, Plane, Region, Speeds, Window, window};
use passivity_scene::{Axis, Scene};

/// A scene as its file says it, with the places of the axes in it.
struct Device {
    name: &'static str,
    /// `{x}` and `{y}` stand where the numbers of the axes are typed.
    text: &'static str,
    /// The numbers of the scene itself.
    own: [&'static str; 2],
    axes: [&'static str; 2],
}

const DEVICES: [Device; 14] = [
    Device {
        name: "a motor in degrees, with tolerances",
        text: "[device]\nviscous = \"9e-6 N m s/rad ± 10%\"\ncoulomb = \"2 mN m ± 20%\"\n[sampling]\n\
               rate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\n\
               stiffness = \"{x} mN m/deg\"\ndamping = \"{y} N m s/rad\"\n[operator]\n\
               max_speed = \"20 rpm\"\n",
        own: ["3", "1e-6"],
        axes: ["stiffness", "damping"],
    },
    Device {
        name: "stiffness and rate of an arm",
        text: "[device]\ncoulomb = \"0.04 N\"\n[sampling]\nrate = \"{y} kHz\"\n[encoder]\n\
               resolution = \"0.03 mm\"\n[wall]\nstiffness = \"{x} N/mm\"\nmax_force = \"8.5 N\"\n\
               [operator]\nmax_speed = \"40 mm/s\"\n",
        own: ["1", "1"],
        axes: ["stiffness", "rate"],
    },
    Device {
        name: "friction, with a delay, a D/A step and a one-sided wall",
        text: "[device]\ncoulomb = \"{x} N\"\nviscous = \"{y} N s/m\"\n[sampling]\nrate = \"1 kHz\"\n\
               delay = 1\n[encoder]\nresolution = \"0.03 mm ± 10%\"\n[wall]\nstiffness = \"0.2 N/mm\"\n\
               unilateral = true\nforce_step = \"1 mN\"\n",
        own: ["0.04", "0.5"],
        axes: ["coulomb", "viscous"],
    },
    Device {
        name: "an encoder in counts",
        text: "[device]\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"{y} mN m\"\n[sampling]\n\
               period = \"0.1 ms\"\n[encoder]\ncounts_per_revolution = {x}\n[wall]\n\
               stiffness = \"0.15 N m/rad\"\n",
        own: ["512", "2"],
        axes: ["counts_per_revolution", "coulomb"],
    },
    Device {
        name: "damping behind an encoder, over periods",
        text: "[device]\nviscous = \"0.5 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"{y} ms\"\n\
               [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"0.2 N/mm\"\n\
               damping = \"{x} N s/m\"\nunilateral = true\n",
        own: ["0.1", "1"],
        axes: ["damping", "period"],
    },
    Device {
        name: "a delay and damping that partly cancel",
        text: "[device]\nviscous = \"0.9 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n\
               delay = 1\n[encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"{x} N/mm\"\n\
               damping = \"{y} N s/m\"\n",
        own: ["0.4", "0.2"],
        axes: ["stiffness", "damping"],
    },
    Device {
        name: "an amplifier",
        text: "[device]\nviscous = \"0.5 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n\
               [wall]\nstiffness = \"{x} N/mm\"\n[amplifier]\ntime_constant = \"{y} ms\"\n",
        own: ["0.4", "0.2"],
        axes: ["stiffness", "time_constant"],
    },
    Device {
        name: "a latency and a speed",
        text: "[device]\nviscous = \"0.1 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n\
               latency = \"{y} ms\"\n[encoder]\nresolution = \"0.03 mm\"\n[wall]\n\
               stiffness = \"0.4 N/mm\"\n[operator]\nmax_speed = \"{x} mm/s\"\n",
        own: ["100", "0.3"],
        axes: ["max_speed", "latency"],
    },
    Device {
        name: "β and σ with a controller",
        text: "[dimensionless]\nbeta = \"{x}\"\nsigma = \"{y}\"\n[sampling]\ndelay = 1\n[controller]\n\
               numerator = [\"1.5\", \"-0.5\"]\n[operator]\nmax_speed = \"2\"\n",
        own: ["5/4", "3/2"],
        axes: ["viscous", "coulomb"],
    },
    Device {
        name: "damping that is late, over viscous friction",
        text: "[device]\n\
               viscous = \"{y} N s/m\"\n\
               coulomb = \"0.04 N\"\n\
               [sampling]\n\
               period = \"1 ms\"\n\
               delay = 1\n\
               [encoder]\n\
               resolution = \"0.03 mm\"\n\
               [wall]\n\
               stiffness = \"0.4 N/mm\"\n\
               damping = \"{x} N s/m\"\n\
               ",
        own: ["0.2", "0.9"],
        axes: ["damping", "viscous"],
    },
    Device {
        name: "a filter, over Coulomb friction and periods",
        text: "[device]\n\
               viscous = \"0.3 N s/m\"\n\
               coulomb = \"{x} N\"\n\
               [sampling]\n\
               period = \"{y} ms\"\n\
               [encoder]\n\
               resolution = \"0.03 mm\"\n\
               [wall]\n\
               stiffness = \"0.4 N/mm\"\n\
               damping = \"0.3 N s/m\"\n\
               damping_time_constant = \"2 ms\"\n\
               [operator]\n\
               max_speed = \"50 mm/s\"\n\
               ",
        own: ["0.04", "1"],
        axes: ["coulomb", "period"],
    },
    Device {
        name: "a filter that is late, over its own time constant",
        text: "[device]\n\
               viscous = \"{y} N s/m\"\n\
               coulomb = \"0.04 N\"\n\
               [sampling]\n\
               period = \"1 ms\"\n\
               delay = 2\n\
               [encoder]\n\
               resolution = \"0.03 mm\"\n\
               [wall]\n\
               stiffness = \"0.4 N/mm\"\n\
               damping = \"0.3 N s/m\"\n\
               damping_time_constant = \"{x} ms\"\n\
               ",
        own: ["2", "1.5"],
        axes: ["damping_time_constant", "viscous"],
    },
    Device {
        name: "a latency, over viscous friction",
        text: "[device]\n\
               viscous = \"{y} N s/m\"\n\
               coulomb = \"0.04 N\"\n\
               [sampling]\n\
               period = \"1 ms\"\n\
               latency = \"{x} ms\"\n\
               [encoder]\n\
               resolution = \"0.03 mm\"\n\
               [wall]\n\
               stiffness = \"0.4 N/mm\"\n\
               ",
        own: ["1", "0.6"],
        axes: ["latency", "viscous"],
    },
    Device {
        name: "an amplifier and damping, over the resolution of the encoder",
        text: "[device]\n\
               viscous = \"0.5 N s/m\"\n\
               coulomb = \"0.04 N\"\n\
               [sampling]\n\
               period = \"1 ms\"\n\
               [encoder]\n\
               resolution = \"{y} mm\"\n\
               [wall]\n\
               stiffness = \"0.4 N/mm\"\n\
               damping = \"{x} N s/m\"\n\
               [amplifier]\n\
               time_constant = \"0.1 ms\"\n\
               ",
        own: ["0.1", "0.03"],
        axes: ["damping", "resolution"],
    },
];

impl Device {
    fn scene(&self, x: &str, y: &str) -> Scene {
        let text = self.text.replace("{x}", x).replace("{y}", y);
        Scene::from_toml("device", &text).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    fn plane(&self) -> (Scene, Plane) {
        let [x, y] = self.own;
        let scene = self.scene(x, y);
        let axes = self.axes.map(|name| Axis::parse(name, &scene).unwrap());
        let plane = Plane::new(&scene, axes).unwrap();
        (scene, plane)
    }

    /// Whether the scene with these numbers typed in is passive, at the speeds of a region.
    fn passes(&self, [x, y]: [f64; 2], speeds: Speeds) -> bool {
        let report = check(&self.scene(&x.to_string(), &y.to_string()));
        match speeds {
            Speeds::Every => report.at_every_speed,
            Speeds::UpToBound => report.verdict == Verdict::Passive,
        }
    }
}

#[test]
fn every_point_of_a_border_is_passive_typed_in_and_one_beyond_it_is_not() {
    for device in &DEVICES {
        let (scene, plane) = device.plane();
        let extents = window(&[(&scene, &plane)], &[], &Window::default()).unwrap();
        for speeds in plane.speeds() {
            let region = Region::of(&plane, &extents, speeds);
            let mut looked = 0;
            for line in &region.borders {
                // A few places of each line: the check of a scene takes its time.
                for pair in line.windows(2).step_by(line.len().div_ceil(8)) {
                    looked += usize::from(beyond(device, &extents, pair, speeds));
                }
            }
            let must = speeds == Speeds::UpToBound || plane.speeds().len() == 1;
            assert!(
                looked > 2 || !must,
                "{} {speeds:?}: {region:?}",
                device.name
            );
        }
    }
}

/// Checks a piece of a border, with the region on its left; whether there was something to check.
fn beyond(device: &Device, extents: &[Extent; 2], pair: &[[f64; 2]], speeds: Speeds) -> bool {
    let name = device.name;
    let [from, to] = [pair[0], pair[1]];
    assert!(
        device.passes(from, speeds) && device.passes(to, speeds),
        "{name}: {pair:?}"
    );
    let shares = |place: [f64; 2]| [extents[0].share(place[0]), extents[1].share(place[1])];
    let (a, b) = (shares(from), shares(to));
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    // A few pixels of the picture, and more than the border bends in between.
    let right = [(b[1] - a[1]) / length, (a[0] - b[0]) / length].map(|x| 4e-3 * x);
    let out = [0, 1].map(|i| extents[i].at(0.5 * (a[i] + b[i]) + right[i]));
    let mut shown = out.map(|x| format!("{x:.6e}").parse::<f64>().unwrap());
    if device.axes[0].starts_with("counts") {
        shown[0] = shown[0].round();
    }
    let inside = shares(shown)
        .iter()
        .all(|share| (0.005..=0.995).contains(share));
    if inside {
        assert!(!device.passes(shown, speeds), "{name}: {pair:?} {shown:?}");
    }
    inside
}

#[test]
fn a_border_solved_exactly_is_within_a_millionth() {
    // K ≤ 2b/T at every speed, and 2(bV + c)/(TV + Δ) up to V.
    let device = &DEVICES[1];
    let (_, plane) = device.plane();
    assert!(plane.has_formula());
    let linear = |from, to| Extent {
        from,
        to,
        log: false,
    };
    let region = Region::of(
        &plane,
        &[linear(0.1, 2.0), linear(0.2, 2.0)],
        Speeds::UpToBound,
    );
    // But for the places where the border leaves the window.
    let inside = |place: &&[f64; 2]| place[1] > 0.2 && place[1] < 2.0;
    for [stiffness, rate] in region.borders.iter().flatten().filter(inside) {
        let exact = 2.0 * 0.04 / (40.0 / (1000.0 * rate) + 0.03);
        assert!(
            *stiffness <= exact && *stiffness > exact * (1.0 - 1e-6),
            "{stiffness} {rate}"
        );
    }
    assert_eq!(
        Region::of(&plane, &[linear(0.1, 2.0), linear(0.2, 2.0)], Speeds::Every),
        Region::default()
    );
}

#[test]
fn axes_that_have_no_border_are_refused() {
    let plane = |text: &str, x: &str, y: &str| {
        let scene = Scene::from_toml("device", text).unwrap();
        let axes = [x, y].map(|name| Axis::parse(name, &scene).unwrap());
        Plane::new(&scene, axes).unwrap_err().to_string()
    };
    let plain = "[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N/mm\"\n";
    assert_eq!(
        plane(plain, "inertia", "stiffness"),
        "`inertia` has no part in the criterion, so no border depends on it"
    );
    assert_eq!(
        plane(plain, "period", "rate"),
        "`period` and `rate` are the same parameter"
    );
    assert_eq!(
        plane(plain, "stiffness", "damping_cutoff"),
        "`damping_cutoff`: the filter on the virtual damping has no damping to filter in `device`"
    );
    let controlled = format!("{plain}[controller]\nnumerator = [\"1.5\", \"-0.5\"]\n");
    assert_eq!(
        plane(&controlled, "stiffness", "damping"),
        "`damping`: [controller] and `wall.damping` cannot both be given in `device`"
    );
}

#[test]
fn a_window_shows_scene_and_limits_and_can_be_asked_for() {
    let (scene, plane) = DEVICES[0].plane();
    let of = |asked: &Window| window(&[(&scene, &plane)], &[], asked);
    let [x, _] = of(&Window::default()).unwrap();
    assert!(x.log && x.from < 0.3 && x.to > 3.0, "{x:?}");
    let asked = Window {
        log: [Some(false), Some(true)],
        range: [Some([0.0, 5.0]), None],
    };
    let [x, y] = of(&asked).unwrap();
    assert_eq!(
        x,
        Extent {
            from: 0.0,
            to: 5.0,
            log: false
        }
    );
    assert!(y.log);
    let wrong = |range, log| {
        let asked = Window {
            log: [log, None],
            range: [Some(range), None],
        };
        of(&asked).unwrap_err().to_string()
    };
    assert_eq!(
        wrong([3.0, 1.0], None),
        "`stiffness` from 3 to 1: expected two numbers, the lower first"
    );
    assert_eq!(
        wrong([0.0, 1.0], Some(true)),
        "`stiffness` from 0: a logarithmic axis begins above zero"
    );
}
