use passivity_core::{BigRational, Loop, Scalar};
use passivity_random::draws;
use proptest::prelude::*;

use super::*;
use crate::ball::Ball;
use crate::number::Number;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn count<S: Ordered>(tick: i32) -> Figure<S> {
    Figure::between(S::integer(tick), S::integer(tick + 1)).unwrap()
}

/// Where exact fractions say that both accounts are, and where balls do.
fn is_around(near: Option<[Figure<Ball>; 2]>, exact: &[Figure<BigRational>; 2]) -> bool {
    let holds = |ball: &Ball, x: &BigRational| match ball.near() {
        None => true,
        Some(middle) => {
            let [middle, radius] =
                [middle, ball.parts().1].map(|x| num_rational::BigRational::from_float(x).unwrap());
            Scalar::abs(&(x - middle)) <= radius
        }
    };
    near.is_none_or(|near| {
        let mut both = near.iter().zip(exact);
        both.all(|(near, exact)| holds(near.lo(), exact.lo()) && holds(near.hi(), exact.hi()))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(200)))]

    /// At walls that end within a tick, at a tick, or nowhere: no positions give more or less than the row says, and
    /// some give that but for how far they are from where it is.
    #[test]
    fn net_energy_is_tight_where_the_law_is_bent(
        (from, ticks) in (-6..6_i32, -3..4_i32),
        (unilateral, limit) in (any::<bool>(), prop::option::of(1..20_i64)),
        (force, n, d) in (-40..40_i64, 1..9_i64, 1..9_i64),
        [b, c] in [0..30_i64, 0..30_i64],
    ) {
        const PARTS: i64 = 8;
        let friction = Friction::new(ratio(b, 12), ratio(c, 12));
        let ends = Ends::exact(Loop { unilateral, max_force: limit.map(|n| ratio(n, 4)), ..Loop::plain(friction.clone()) });
        let (start, end, force, dtau) = (count(from), count(from + ticks), ratio(force, 4), ratio(n, d));
        let rectangle = Rectangle { ends: &ends, start: &start, end: &end, force: &Figure::Exact(force.clone()), dtau: &dtau };
        let [law, steps] = rectangle.net_on_edges().unwrap();
        let crossings = rectangle.crossings();
        prop_assert_eq!(&[law.clone(), steps.clone()], &rectangle.net(crossings.as_ref()).unwrap());
        prop_assert_eq!(rectangle.generated(crossings.as_ref()).unwrap(), rectangle.generated_between().unwrap());
        let net = |at: [&BigRational; 2]| {
            let d = Scalar::abs(&(at[1].clone() - at[0].clone()));
            let taken = friction.beta.clone() * d.square() / dtau.clone() + friction.sigma.clone() * d;
            rectangle.generated_at(at, &force).map(|generated| taken.clone() - generated)
        };
        let mut found: [Option<Interval<BigRational>>; 2] = [None, None];
        for x in 0..=PARTS {
            for y in 0..=PARTS {
                let at = [ratio(from.into(), 1) + ratio(x, PARTS), ratio((from + ticks).into(), 1) + ratio(y, PARTS)];
                for (known, value) in found.iter_mut().zip(net(at.each_ref())) {
                    join(known, Interval::point(value));
                }
            }
        }
        // Within half a part, net energy changes by no more than its slope allows: distances are at most |ticks| + 1
        // and forces of the wall at most as large as positions.
        let reach = ratio((ticks.abs() + 1).into(), 1);
        let place = ratio((from.abs() + ticks.abs() + 1).into(), 1);
        let slope = friction.beta.double() * reach / dtau.clone() + friction.sigma.clone() + Scalar::abs(&force) + place;
        let most = slope * ratio(1, 2 * PARTS);
        for (figure, found) in [law, steps].iter().zip(found) {
            let found = found.unwrap();
            prop_assert!(figure.lo() <= found.lo() && found.hi() <= figure.hi());
            prop_assert!(found.lo() - figure.lo() <= most && figure.hi() - found.hi() <= most);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(500)))]

    /// On exact fractions the closed form is what the edges of the rectangle give; on balls it is around that.
    #[test]
    fn the_closed_form_is_what_the_edges_give(
        (from, ticks) in (-40..40_i32, prop_oneof![-3..4_i32, -50..50_i32]),
        (force, parts, width) in (-900..900_i64, 1..40_i64, 0..3_i64),
        (n, d) in (1..60_i64, 1..30_i64),
        friction in prop::array::uniform4(0..30_i64),
        is_exact: bool,
    ) {
        let [b, c, more_b, more_c] = friction;
        let more = |more: i64| if is_exact { 0 } else { more };
        let range = |lo: i64, more: i64| Interval::new(ratio(lo, 12), ratio(lo + more, 12)).unwrap();
        let point = |n: i64| Interval::point(ratio(n, 1));
        let ends = Ends::of(&Loop {
            viscous: Some(range(b, more(more_b))),
            coulomb: Some(range(c, more(more_c))),
            resolution: Some(point(1)),
            ..Loop::new(point(1), point(1))
        }).unwrap();
        let force = match width {
            0 => Figure::Exact(ratio(force, parts)),
            _ => Figure::between(ratio(force, parts), ratio(force + width, parts)).unwrap(),
        };
        let (start, end) = (count(from), count(from + ticks));
        let exact = Rectangle { ends: &ends, start: &start, end: &end, force: &force, dtau: &ratio(n, d) };
        let crossings = exact.crossings();
        prop_assert!(crossings.is_some());
        let (generated, net) = (exact.generated(crossings.as_ref()).unwrap(), exact.net(crossings.as_ref()).unwrap());
        prop_assert_eq!(&generated, &exact.generated_between().unwrap());
        prop_assert_eq!(&net, &exact.net_on_edges().unwrap());
        if let Figure::Exact(force) = &force {
            let (ends, start, end) = (ends.try_map(|x| Some(Ball::of_rational(x))).unwrap(), count(from), count(from + ticks));
            let force = Figure::Exact(Ball::of_rational(force));
            let near = Rectangle { ends: &ends, start: &start, end: &end, force: &force, dtau: &Ball::of(&Number::Small(n, d)) };
            let crossings = near.crossings();
            prop_assert!(is_around(near.generated(crossings.as_ref()), &generated));
            prop_assert!(is_around(near.net(crossings.as_ref()), &net));
        }
    }
}
