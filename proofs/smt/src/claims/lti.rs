//! TH-LTI, TH-LATENCY and TH-LAG: what is finite of them. One sample of filtered damping, the decision of
//! β ≥ κ without a root, and the recursion that decides stability.

use std::collections::VecDeque;

use passivity_core::actuator::{Actuator, spare};
use passivity_core::controller::Filter;
use passivity_core::linear_part::filtered_cost;
use passivity_core::transfer::is_stable;
use passivity_core::{Friction, Scalar as _};
use passivity_terms::{Term, paths};

use super::words::{half, n, v};
use crate::Query;
use crate::formula::{Formula, all, any, eq, ge, iff, implies, le, lt, nonnegative, taken};

pub(super) fn queries() -> Vec<Query> {
    [filters(), squares(), stability()].concat()
}

/// Filtered damping: y of the code's recursion is B·w, w the filter's state with w′ = aw + (1 − a)D.
fn filters() -> Vec<Query> {
    let (damping, pole) = (v("B"), v("a"));
    let filter = Filter::filtered_damping(&damping, &pole);
    let next = |before: &Term| {
        let mut past = VecDeque::from([before.clone()]);
        let output = filter.next(&[v("x1"), v("x0")], &mut past);
        (output, past.pop_front().unwrap_or_else(|| n(0)))
    };
    let d = v("x1") - v("x0");
    let state = |w: Term| pole.clone() * w + (n(1) - pole.clone()) * d.clone();
    let (output, y) = next(&(damping.clone() * v("w")));
    let after = state(v("w"));
    let premises = [nonnegative(&damping), nonnegative(&pole), lt(&pole, &n(1))];
    let (w, stored, share) = (v("w"), v("stored"), v("share"));
    let passed = n(1) - pole.clone();
    // What S = w²/(2(1 − a)) gains over the sample.
    let gains = eq(
        &(stored.clone() * passed.double()),
        &(after.square() - w.square()),
    );
    let polynomial = (passed.clone() * d.square() - (n(1) + pole.clone()) * w.square()).half()
        + pole.clone() * w.clone() * d.clone();
    let is_polynomial = eq(&stored, &polynomial);
    let share_is = eq(&(share.clone() * (n(1) + pole.clone())), &passed);
    let slack = w.clone() * d.clone() + share.clone() * d.square() - stored.clone();
    let square = (n(1) + pole.clone()) * (w.clone() + share.clone() * d.clone()).square();
    let cost = filtered_cost(&damping, &pole);
    let held = -(v("x0") + damping.clone() * w.clone());
    let drawn = held * d.clone() + (v("x1").square() - v("x0").square()).half();
    let friction = Friction::new(v("beta"), v("sigma"));
    let left = friction.dissipated_lower(&d, &d.abs()) - drawn;
    let query = |part, says| Query::new("TH-LTI", part, says).given(premises.clone());
    vec![
        query("filtered damping in code", "the code's command is the position and B times the filter's state")
            .then(all([
                eq(&y, &(damping.clone() * after.clone())),
                eq(&output, &(v("x1") + y)),
            ]))
            .but_not("not with another state", eq(&output, &(v("x1") + damping.clone() * w.clone()))),
        query("filtered damping cost", "the code charges ½ and B(1 − a)/(1 + a) of viscous friction")
            .given([share_is.clone()])
            .then(eq(&cost.viscous, &(half() + damping.clone() * share.clone())))
            .but_not("not ½ and B", eq(&cost.viscous, &(half() + damping.clone()))),
        query("one pole storage", "what the storage w²/(2(1 − a)) of the filter gains over a sample is a polynomial")
            .given([gains])
            .then(is_polynomial.clone())
            .not_without("not with another storage", 1),
        query("one pole square", "twice what Dw + D²(1 − a)/(1 + a) has to spare beyond that is (1 + a) times a square")
            .given([share_is, is_polynomial])
            .then(eq(&slack.double(), &square))
            .but_not("not without the weight", eq(&slack.double(), &(w.clone() + share.clone() * d.clone()).square())),
        query("one pole step", "so Dw + D²(1 − a)/(1 + a) covers what the filter's storage gains over a sample")
            .given([eq(&slack.double(), &square)])
            .then(nonnegative(&slack))
            .not_without("not by itself", 1),
        query("filtered damping step", "friction less what the command draws and the filter stores is B times what the step before has to spare, and what friction has beyond the cost: not below zero where β is the cost or more")
            .then(eq(
                &(left.clone() - damping.clone() * stored.clone()),
                &(damping.clone() * slack.clone()
                    + (v("beta") - half() - damping.clone() * share.clone()) * d.square()
                    + v("sigma") * d.abs()),
            ))
            .but_not(
                "not with the whole damping as the cost",
                eq(
                    &(left - damping.clone() * stored),
                    &(damping.clone() * slack
                        + (v("beta") - half() - damping) * d.square()
                        + v("sigma") * d.abs()),
                ),
            ),
    ]
}

/// β ≥ κ by two numbers, without the root that κ has.
fn squares() -> Vec<Query> {
    let (beta, mean, variance, root) = (v("beta"), v("m"), v("Var"), v("root"));
    let first = half() + mean.clone();
    let kappa = (first.clone() + root.clone()).half();
    let [over, square] = spare(&beta, &mean, &variance);
    let rest = beta.double() - first.clone();
    let decided = all([nonnegative(&over), nonnegative(&square)]);
    let premises = [nonnegative(&mean), nonnegative(&variance)];
    let kappa_is = [
        nonnegative(&root),
        eq(&root.square(), &(first.square() + variance.clone())),
    ];
    let late = Actuator {
        latency: v("s"),
        time_constant: v("theta"),
    };
    let f = v("s") - v("s").floor();
    vec![
        Query::new("TH-LATENCY", "decision", "the two numbers of the code are not negative exactly where β ≥ κ")
            .given(premises.clone())
            .given(kappa_is.clone())
            .then(iff(decided.clone(), ge(&beta, &kappa)))
            .but_not("the square alone is not enough", iff(nonnegative(&square), ge(&beta, &kappa))),
        Query::new("TH-LATENCY", "squares", "the two numbers are not negative exactly where 2β ≥ ½ + m and (2β − ½ − m)² ≥ (½ + m)² + Var")
            .given(premises.clone())
            .then(iff(
                decided.clone(),
                all([
                    nonnegative(&rest),
                    ge(&rest.square(), &(first.square() + variance.clone())),
                ]),
            ))
            .but_not(
                "not with the square alone",
                iff(decided.clone(), ge(&rest.square(), &(first.square() + variance.clone()))),
            ),
        Query::new("TH-LATENCY", "variance", "the variance of a latency is f(1 − f), from 0 to ¼")
            .then(all([
                eq(&late.variance_of_latency(), &(f.clone() * (n(1) - f))),
                nonnegative(&late.variance_of_latency()),
                le(&late.variance_of_latency(), &half().half()),
            ]))
            .but_not("it can be above 1/5", le(&late.variance_of_latency(), &Term::fraction(1, 5))),
        Query::new("TH-LAG", "decision", "more variance is never decided for less friction: an enclosure's upper end is safe")
            .given(premises)
            .given([le(&variance, &v("more"))])
            .then(implies(
                {
                    let [over, square] = spare(&beta, &mean, &v("more"));
                    all([nonnegative(&over), nonnegative(&square)])
                },
                decided.clone(),
            ))
            .but_not(
                "less variance is not safe",
                implies(decided, {
                    let [over, square] = spare(&beta, &mean, &v("more"));
                    all([nonnegative(&over), nonnegative(&square)])
                }),
            ),
        Query::new("TH-LAG", "bound", "the bound of the variance that needs no exponential is that of the latency and min(θ/2, 1/12)")
            .given([nonnegative(&v("theta"))])
            .then(any([
                all([
                    eq(&late.variance_bound(), &(late.variance_of_latency() + v("theta").half())),
                    le(&v("theta"), &Term::fraction(1, 6)),
                ]),
                all([
                    eq(&late.variance_bound(), &(late.variance_of_latency() + Term::fraction(1, 12))),
                    ge(&v("theta"), &Term::fraction(1, 6)),
                ]),
            ]))
            .but_not("it is not always θ/2", eq(&late.variance_bound(), &(late.variance_of_latency() + v("theta").half()))),
    ]
}

/// What the code says of a denominator, on each path.
fn where_stable(denominator: &[Term]) -> Formula {
    let found = paths::of(|| is_stable(denominator));
    let stable = found.iter().filter(|path| path.result == Some(true));
    Formula::Any(stable.map(taken).collect())
}

/// Roots of denominators of one and two poles.
fn stability() -> Vec<Query> {
    let [d0, d1, d2] = ["d0", "d1", "d2"].map(v);
    let (x, y) = (v("x"), v("y"));
    let leading = any([lt(&d0, &n(0)), lt(&n(0), &d0)]);
    let one = where_stable(&[d0.clone(), d1.clone()]);
    let two = where_stable(&[d0.clone(), d1.clone(), d2.clone()]);
    let radius = x.square() + y.square();
    // d₀z² + d₁z + d₂ at z = x + iy.
    let real = d0.clone() * (x.square() - y.square()) + d1.clone() * x.clone() + d2.clone();
    let imaginary = y.clone() * (d0.clone() * x.double() + d1.clone());
    let root = all([eq(&real, &n(0)), eq(&imaginary, &n(0))]);
    let triangle = all([
        lt(&d2.abs(), &d0.abs()),
        lt(&d1.abs(), &(d0.clone() + d2.clone()).abs()),
    ]);
    vec![
        Query::new("TH-LTI", "one pole stable", "one pole is stable in the code exactly where its root is inside the unit circle")
            .given([leading.clone(), eq(&(d0.clone() * x.clone() + d1), &n(0))])
            .then(iff(one.clone(), lt(&x.abs(), &n(1))))
            .but_not("not where it is on the circle", iff(one, le(&x.abs(), &n(1)))),
        Query::new("TH-LTI", "two poles", "two poles are stable in the code exactly where |d₂| < |d₀| and |d₁| < |d₀ + d₂|")
            .given([leading.clone()])
            .then(iff(two.clone(), triangle.clone()))
            .but_not("not with ≤", iff(two, le(&d2.abs(), &d0.abs()))),
        Query::new("TH-LTI", "two poles inside", "where |d₂| < |d₀| and |d₁| < |d₀ + d₂| every root, real or not, is inside the unit circle")
            .given([leading.clone(), root.clone(), triangle.clone()])
            .then(lt(&radius, &n(1)))
            .not_without("else it need not be", 1),
        Query::new("TH-LTI", "two poles outside", "where two real roots, or a root and its conjugate, are inside the unit circle, |d₂| < |d₀| and |d₁| < |d₀ + d₂|")
            .given([leading, any([
                all([
                    eq(&d2, &(d0.clone() * x.clone() * y.clone())),
                    eq(&v("d1"), &-(d0.clone() * (x.clone() + y.clone()))),
                    lt(&x.abs(), &n(1)),
                    lt(&y.abs(), &n(1)),
                ]),
                all([
                    eq(&d2, &(d0.clone() * radius.clone())),
                    eq(&v("d1"), &-(d0 * x.double())),
                    lt(&radius, &n(1)),
                ]),
            ])])
            .then(triangle)
            .not_without("else they need not be", 1),
    ]
}
