//! TH-NDOF: the kernel's account of two joints.

use passivity_core::Scalar as _;
use passivity_core::definite::quadratic;
use passivity_core::joints::{Joint, Joints, Shape};
use passivity_terms::Term;

use super::words::{n, v, values};
use crate::Query;
use crate::formula::{eq, positive};

/// Two joints with encoders, and any symmetric matrix.
fn device() -> Joints<Term, Term> {
    let joint = |b: &str, c: &str, delta: &str| Joint {
        viscous: Some(v(b)),
        coulomb: Some(v(c)),
        resolution: Some(v(delta)),
        max_speed: None,
    };
    Joints {
        stiffness: n(1),
        period: v("T"),
        joints: vec![joint("b1", "c1", "D1"), joint("b2", "c2", "D2")],
        shape: Shape::Matrix(vec![vec![v("K11"), v("K12")], vec![v("K12"), v("K22")]]),
        unilateral: false,
    }
}

fn pair(first: &str, second: &str) -> Vec<Term> {
    vec![v(first), v(second)]
}

/// Σ|dᵢ|xᵢ.
fn weighted(way: &[Term], by: &[Term]) -> Term {
    let pairs = way.iter().zip(by);
    pairs.fold(n(0), |sum, (d, x)| sum + d.abs() * x.clone())
}

pub(super) fn queries() -> Vec<Query> {
    let device = device();
    let (from, to) = (pair("x1", "x2"), pair("y1", "y2"));
    let way = pair("d1", "d2");
    let generated = device.generated(&from, &to);
    let by_residues = device.generated_by_residues(&from, &to);
    let needed = device.coulomb_needed();
    let coulomb = pair("c1", "c2");
    let spare: Vec<Term> = coulomb
        .iter()
        .zip(&needed)
        .map(|(c, x)| c.clone() - x.clone())
        .collect();
    let form = quadratic(&device.viscous_form(), &way);
    let left = device.dissipated_lower(&way) - device.bound(&way);
    let split = form.clone().over(v("T")) + weighted(&way, &spare);
    // A way of whole ticks, with its units.
    let ticks = pair("m1", "m2");
    let ends: Vec<Term> = from
        .iter()
        .zip(&ticks)
        .map(|(x, m)| x.clone() + m.clone())
        .collect();
    let with_units = device.with_units(&ticks);
    let over_ticks = quadratic(&device.viscous_form(), &with_units);
    let twice = n(2);
    let gain = device.gain(&from, &ticks);
    let formula = -(over_ticks.over(v("T")) + weighted(&with_units, &coulomb)) * twice;
    let floors = ends.iter().zip(from.iter().zip(&ticks));
    let floors = floors.map(|(end, (x, m))| eq(&end.floor(), &(x.floor() + m.clone())));
    vec![
        Query::new(
            "TH-NDOF",
            "generated",
            "what two joints generate is ½dᵀKd + Σ dᵢKᵢⱼΔⱼ(ρⱼ − ½)",
        )
        .then(eq(&generated, &by_residues))
        .but_not("it is not one more", eq(&generated, &(by_residues + n(1)))),
        Query::new(
            "TH-NDOF",
            "criterion",
            "friction less the bound is dᵀ(diag(b) − (T/2)K)d/T and what each joint has to spare",
        )
        .given([positive(&v("T"))])
        .then(eq(&left, &split))
        .but_not(
            "not without the Coulomb friction",
            eq(&left, &form.over(v("T"))),
        ),
        Query::new(
            "TH-NDOF",
            "ticks",
            "on ways of whole ticks a cycle gains −2dᵀ(diag(b) − (T/2)K)d/T − 2Σcᵢ|dᵢ|",
        )
        .given([positive(&v("T")), positive(&v("D1")), positive(&v("D2"))])
        .given(floors)
        .then(eq(&gain, &formula))
        .not_without("not with another floor", 2)
        .at(values([
            ("T", 1, 1),
            ("D1", 1, 1),
            ("D2", 1, 1),
            ("K11", 1, 1),
            ("K12", 0, 1),
            ("K22", 0, 1),
        ]))
        .at(values([
            ("m1", 1, 2),
            ("m2", 0, 1),
            ("x1", 0, 1),
            ("x2", 0, 1),
        ]))
        .at(values([
            ("b1", 0, 1),
            ("b2", 0, 1),
            ("c1", 0, 1),
            ("c2", 0, 1),
        ])),
    ]
}
