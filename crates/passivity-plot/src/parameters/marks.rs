//! The marks of scenes in a plane.

use passivity_scene::check::Verdict;

use super::colour;
use crate::labels::Labels;
use crate::svg::{Pixel, Stroke, Svg};

/// The radius of a scene's mark.
const RADIUS: f64 = 5.0;

/// Draws the marks of scenes, and gives where they are with their numbers. Of several at one place none hides
/// one of another verdict: those that are not passive are rings around those that are.
pub(crate) fn scenes(
    svg: &mut Svg,
    labels: &mut Labels,
    marks: impl Iterator<Item = (Option<Pixel>, Verdict)>,
) -> Vec<(Pixel, Vec<usize>)> {
    let mut places: Vec<(Pixel, Vec<(usize, Verdict)>)> = Vec::new();
    for (number, (place, verdict)) in marks.enumerate() {
        let Some(place) = place else { continue };
        let near = |(other, _): &&mut (Pixel, Vec<(usize, Verdict)>)| {
            (other[0] - place[0]).hypot(other[1] - place[1]) < 3.0
        };
        match places.iter_mut().find(near) {
            Some((_, all)) => all.push((number, verdict)),
            None => places.push((place, vec![(number, verdict)])),
        }
    }
    let rank = |verdict: Verdict| match verdict {
        Verdict::NotPassive => 0,
        Verdict::Passive => 2,
        _ => 1,
    };
    let mut numbered = Vec::new();
    for (place, all) in places {
        // The innermost first.
        let kinds = [2, 1, 0].map(|kind| all.iter().find(|(_, verdict)| rank(*verdict) == kind));
        let rings = kinds.into_iter().flatten();
        let radii = std::iter::successors(Some(RADIUS), |radius| Some(radius + 4.0));
        let mut rings: Vec<_> = rings.zip(radii).collect();
        rings.reverse();
        for ((number, verdict), radius) in rings {
            labels.take(place, radius + 2.0);
            sized_scene(svg, place, radius, *verdict, colour(*number));
        }
        let numbers = all.into_iter().map(|(number, _)| number).collect();
        numbered.push((place, numbers));
    }
    numbered
}

/// The mark of a scene: full where it is passive, empty where it is not, half where neither is sure.
pub(crate) fn scene(svg: &mut Svg, place: Pixel, verdict: Verdict, colour: &str) {
    sized_scene(svg, place, RADIUS, verdict, colour);
}

/// The same with another radius.
fn sized_scene(svg: &mut Svg, place: Pixel, radius: f64, verdict: Verdict, colour: &str) {
    let edge = Stroke::solid(colour, 2.0);
    match verdict {
        Verdict::Passive => svg.disc(place, radius, colour, edge),
        Verdict::NotPassive => svg.disc(place, radius, "#ffffff", edge),
        _ => {
            svg.disc(place, radius, "#ffffff", edge);
            svg.disc(place, 0.4 * RADIUS, colour, edge);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::Frame;

    #[test]
    fn no_mark_hides_one_of_another_verdict() {
        let frame = Frame::of_unit([800.0, 600.0]);
        let at = Some([300.0, 300.0]);
        for order in [[0, 1, 2], [2, 1, 0], [1, 0, 2]] {
            let kinds = [Verdict::Passive, Verdict::NotPassive, Verdict::NotPassive];
            let marks = order.map(|i| (at, kinds[i]));
            let mut svg = Svg::new([800.0, 600.0]);
            let places = scenes(&mut svg, &mut Labels::new(&frame), marks.into_iter());
            assert_eq!(places, [([300.0, 300.0], vec![0, 1, 2])]);
            let text = svg.finish();
            // A ring first, and the full disc on it, smaller.
            let radii: Vec<&str> = text.split(" r=\"").skip(1).collect();
            assert!(
                radii[0].starts_with('9') && radii[0].contains("#ffffff"),
                "{text}"
            );
            assert!(radii[1].starts_with('5') && radii.len() == 2, "{text}");
        }
    }
}
