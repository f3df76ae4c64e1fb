//! Clocks: in which unit they tick.

use passivity_scene::Scene;

/// The unit in which a clock goes on by about a sampling period from row to row.
pub(super) fn unit_of_time(step: Option<f64>, scene: &Scene) -> &'static str {
    const UNITS: [(&str, f64); 4] = [("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)];
    let period = scene.given.map(|_, given| given.nominal.clone()).period;
    let seconds = period
        .to_rational()
        .map(|x| passivity_scene::number::nearest_f64(&x));
    let (Some(step), Some(period)) = (step, seconds) else {
        return "s";
    };
    let off = |unit: f64| (step * unit / period).ln().abs();
    let best = UNITS
        .iter()
        .min_by(|(_, a), (_, b)| off(*a).total_cmp(&off(*b)));
    best.map_or("s", |(name, _)| name)
}
