//! What the shades, lines and signs of the picture mean.

use passivity_scene::plane::{Prediction, Speeds};

use super::{
    BOUNDED, EVERY, Group, Mark, Picture, colour, frame, is_outside, measured, scene, stroke,
    tolerance_lines,
};
use crate::svg::{Anchor, BLACK, DARK, Pixel, Stroke, Svg, rectangle};

const LINE: f64 = 20.0;
const SMALL: f64 = 16.0;

/// The longest words of a line of the key.
const LETTERS: usize = 44;

/// How high the key is.
pub(super) fn height(picture: &Picture<'_>) -> f64 {
    let mut nothing = Svg::new([1.0, 1.0]);
    draw(&mut nothing, picture, [0.0, 0.0]) + 60.0
}

/// Draws the key from its upper left corner; gives where it ends.
pub(super) fn draw(svg: &mut Svg, picture: &Picture<'_>, [x, top]: Pixel) -> f64 {
    let mut key = Key { svg, x, y: top };
    match picture.groups {
        [one] => key.shades(one),
        many => key.lines(many),
    }
    key.y += 0.6 * LINE;
    key.signs(picture);
    for (number, mark) in picture.marks.iter().enumerate() {
        key.scene(number, mark, picture);
    }
    if !picture.points.is_empty() {
        key.y += 0.6 * LINE;
        key.points(picture);
    }
    key.y
}

struct Key<'a> {
    svg: &'a mut Svg,
    x: f64,
    y: f64,
}

impl Key<'_> {
    fn words(&mut self, size: f64, words: &str) {
        let at = [self.x + 30.0, self.y + 12.0];
        self.svg.text(at, size, Anchor::Start, &clipped(words));
        self.y += if size < 13.0 { SMALL } else { LINE };
    }

    fn shades(&mut self, group: &Group) {
        for (speeds, region) in &group.regions {
            let (fill, mut words) = match speeds {
                Speeds::Every => (EVERY, "passive at every speed".to_owned()),
                Speeds::UpToBound => (BOUNDED, up_to(group)),
            };
            let corners = rectangle([self.x, self.y], [self.x + 22.0, self.y + 14.0]);
            self.svg.area(&corners, fill);
            let edge = stroke(*speeds, BLACK);
            self.svg.line(&[corners[3], corners[0], corners[1]], edge);
            if region.outlines.is_empty() {
                words.push_str(": nowhere here");
            }
            self.words(14.0, &words);
        }
        let corners = rectangle([self.x, self.y], [self.x + 22.0, self.y + 14.0]);
        self.svg.area(&corners, "#ffffff");
        self.svg.line(
            &[corners[0], corners[1], corners[2], corners[3], corners[0]],
            Stroke::solid(DARK, 0.7),
        );
        self.words(14.0, "the criterion fails");
    }

    fn lines(&mut self, groups: &[Group]) {
        let has = |speeds| {
            let mut last = groups.iter().filter_map(|group| group.regions.last());
            last.any(|(of, _)| *of == speeds)
        };
        for (speeds, words) in [
            (Speeds::Every, "border: passive at every speed"),
            (Speeds::UpToBound, "border: passive up to the scene's speed"),
        ] {
            if has(speeds) {
                let y = self.y + 7.0;
                self.svg
                    .line(&[[self.x, y], [self.x + 24.0, y]], stroke(speeds, BLACK));
                self.words(14.0, words);
            }
        }
        let y = self.y + 9.0;
        self.svg.line(
            &[[self.x, y], [self.x + 24.0, y]],
            Stroke::solid(BLACK, 2.0),
        );
        for i in 0..3 {
            let x = self.x + 4.0 + 8.0 * f64::from(i);
            self.svg
                .line(&[[x, y], [x, y - 6.0]], Stroke::solid(BLACK, 1.0));
        }
        self.words(14.0, "short strokes: the side that is passive");
    }

    /// What the marks of the scenes mean.
    fn signs(&mut self, picture: &Picture<'_>) {
        use passivity_scene::check::Verdict;
        let is_known = |verdict: Verdict| matches!(verdict, Verdict::Passive | Verdict::NotPassive);
        let mut kinds = vec![
            (Verdict::Passive, "a scene that is passive"),
            (Verdict::NotPassive, "one that is not passive"),
        ];
        if picture.marks.iter().any(|mark| !is_known(mark.verdict)) {
            kinds.push((Verdict::Depends, "one of which neither is shown"));
        }
        for (verdict, words) in kinds {
            if picture.marks.iter().any(|mark| {
                mark.verdict == verdict || (verdict == Verdict::Depends && !is_known(mark.verdict))
            }) {
                scene(self.svg, [self.x + 11.0, self.y + 7.0], verdict, DARK);
                self.words(13.0, words);
            }
        }
        let frame = frame(picture);
        let boxed = |mark: &Mark| !tolerance_lines(&frame, mark).is_empty();
        if picture.marks.iter().any(boxed) {
            let mut edge =
                rectangle([self.x + 1.0, self.y + 1.0], [self.x + 21.0, self.y + 13.0]).to_vec();
            edge.extend(edge.first().copied());
            self.svg.line(&edge, Stroke::solid(DARK, 1.5));
            self.words(13.0, "its tolerances");
        }
        self.y += 0.6 * LINE;
    }

    fn scene(&mut self, number: usize, mark: &Mark, picture: &Picture<'_>) {
        scene(
            self.svg,
            [self.x + 11.0, self.y + 7.0],
            mark.verdict,
            colour(number),
        );
        self.words(14.0, &format!("{}: {}", number + 1, mark.name));
        self.y -= 2.0;
        let verdict = mark.verdict.name().replace('_', " ");
        let outside = match mark.ranges {
            None => "; not in the picture",
            Some(_) if is_outside(&picture.window, mark) => "; at the edge: it is outside",
            Some(_) => "",
        };
        let [x, y] = &mark.place;
        let both = format!("{x}, {y}");
        if both.chars().count() <= LETTERS {
            self.words(12.0, &both);
        } else {
            self.words(12.0, x);
            self.words(12.0, y);
        }
        self.words(12.0, &format!("{verdict}{outside}"));
        self.y += 4.0;
    }

    fn points(&mut self, picture: &Picture<'_>) {
        use super::Point;
        let kinds = [
            (true, Prediction::Agree, "measured: stable"),
            (false, Prediction::Agree, "measured: unstable"),
            (
                false,
                Prediction::Looser,
                "unstable where the criterion holds",
            ),
        ];
        for (stable, prediction, words) in kinds {
            let point = Point {
                at: [0.0; 2],
                stable,
                prediction,
            };
            measured(self.svg, [self.x + 11.0, self.y + 8.0], &point);
            self.words(13.0, words);
        }
        let count = |prediction| {
            let all = picture.points.iter();
            all.filter(|point| point.prediction == prediction).count()
        };
        let [agree, stricter, looser] =
            [Prediction::Agree, Prediction::Stricter, Prediction::Looser].map(count);
        self.words(
            12.0,
            &format!("{agree} agree; the criterion is stricter at {stricter},"),
        );
        self.words(12.0, &format!("looser at {looser}"));
    }
}

fn up_to(group: &Group) -> String {
    match &group.bound {
        Some(bound) => format!("passive up to {bound}"),
        None => "passive up to the speed bound".to_owned(),
    }
}

/// Words that fit their place.
fn clipped(words: &str) -> String {
    if words.chars().count() <= LETTERS {
        return words.to_owned();
    }
    words.chars().take(LETTERS - 1).chain(['…']).collect()
}
