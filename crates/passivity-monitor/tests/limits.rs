//! What the monitor does not say, and what it needs to be told: each limit that the documentation names, by example.

use passivity_monitor::account::given;
use passivity_monitor::{Answer, Config, Monitor};

fn config(stiffness: i64, viscous: i64, coulomb: i64) -> Config {
    Config::new(stiffness, viscous, coulomb).expect("in range")
}

/// The monitor after these samples of a count and the force that is held from then on.
fn watched(config: Config, samples: &[(i32, i32)]) -> Monitor<i64> {
    let (count, force) = samples[0];
    let mut monitor = Monitor::start(config, count, force);
    for (count, force) in &samples[1..] {
        monitor.sample(*count, *force);
    }
    monitor
}

/// The samples of a wall of K = 1000 in whose force the device moves a tick outward a sample, from count 10 on.
fn let_out() -> [(i32, i32); 11] {
    std::array::from_fn(|i| 10 - i as i32).map(|count| (count, -(1000 * count + 500)))
}

/// More had been drawn at the second sample or at the last, wherever the positions were, and by at least 80; but
/// at neither of them for all positions: the answer stays open.
#[test]
fn it_stays_open_where_the_positions_decide_at_which_sample_more_was_drawn() {
    const PARTS: i64 = 20;
    let config = config(0, 0, 0).with_stored_at_start(10).expect("in range");
    let samples = [(0, 100), (1, 200), (1, 90), (2, 0)];
    // Energies in parts of a twentieth, as are positions; without friction energy is proportional to distance.
    let move_of = |i: usize, from: i64, to: i64| {
        let ticks = i64::from(samples[i + 1].0 - samples[i].0);
        given(&config, i64::from(samples[i].1), PARTS * ticks + to - from)
    };
    let mut least = i64::MAX;
    for within in 0..(PARTS + 1).pow(4) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| within / (PARTS + 1).pow(i) % (PARTS + 1));
        let second = -10 * PARTS + move_of(0, a, b);
        let last = second + move_of(1, b, c) + move_of(2, c, d);
        least = least.min(second.max(last));
    }
    assert_eq!(least, 80 * PARTS);
    let leasts = [1, 2, 3, 4].map(|n| watched(config, &samples[..n]).given().map(|it| it.least));
    assert_eq!(leasts, [-10, -10, -210, -30].map(Some));
    assert_eq!(watched(config, &samples).answer(), Answer::Open);
}

/// With a smaller K than the wall's less counts as stored: a passive wall that lets the device out is called active.
#[test]
fn a_smaller_stiffness_than_the_wall_has_gives_false_alarms() {
    let own = watched(config(1000, 500, 500), &let_out());
    assert_eq!(own.answer(), Answer::SurelyPassive);
    let smaller = config(250, 500, 500);
    assert_eq!(watched(smaller, &let_out()[..3]).answer(), Answer::Open);
    assert_eq!(
        watched(smaller, &let_out()[..4]).answer(),
        Answer::SurelyActive
    );
}

/// At rest the most stays where it is where KΔ ≤ 2c, but only under a force that stays the same.
#[test]
fn the_most_grows_at_rest_where_the_force_changes_or_friction_is_small() {
    let most = |config, forces: [i32; 2], samples: usize| {
        let forces = forces.iter().cycle().take(samples);
        let samples: Vec<(i32, i32)> = forces.map(|force| (0, *force)).collect();
        watched(config, &samples).given().expect("it fits").most
    };
    let grows = |config, forces| most(config, forces, 42) - most(config, forces, 22);
    assert_eq!(grows(config(1000, 500, 5000), [10, 10]), 0);
    assert_eq!(grows(config(1000, 500, 5000), [10, -10]), 20 * 20);
    assert!(grows(config(1000, 500, 100), [10, 10]) > 0);
}

/// A counter of 12 bits that wraps is taken for a motion of 4095 ticks, and what follows is called passive.
#[test]
fn a_counter_that_wraps_hides_what_follows() {
    let driven = |first: i32| -> Vec<(i32, i32)> {
        let counts = (0..5).map(|i| first + 20 * i);
        counts.map(|count| (count, 100_000)).collect()
    };
    let stored_nothing = config(1000, 500, 500)
        .with_stored_at_start(0)
        .expect("in range");
    assert_eq!(
        watched(stored_nothing, &driven(0)).answer(),
        Answer::SurelyActive
    );
    let mut wrapped = vec![(4095, 0)];
    wrapped.extend(driven(0));
    let monitor = watched(stored_nothing, &wrapped);
    assert_eq!(monitor.answer(), Answer::SurelyPassive, "it is not");
    assert!(
        monitor
            .given()
            .is_some_and(|given| given.most < -1_000_000_000)
    );
    let mut longer = vec![(65535, 0)];
    longer.extend(driven(0));
    assert_eq!(watched(stored_nothing, &longer).answer(), Answer::Unknown);
}
