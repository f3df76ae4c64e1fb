//! The account and the criterion of several joints, worked out by their own means.

use passivity_core::BigRational;
use passivity_core::definite;
use passivity_core::joints::{Joint, Shape};

use super::Device;
use crate::common::{half, magnitude, q, squared, zero};

pub(super) fn matrix_of(device: &Device) -> Vec<Vec<BigRational>> {
    let n = device.joints.len();
    let at = |i: usize, j: usize| match &device.shape {
        Shape::Direction(a) => &device.stiffness * &a[i] * &a[j],
        Shape::Matrix(rows) => &device.stiffness * &rows[i][j],
    };
    (0..n).map(|i| (0..n).map(|j| at(i, j)).collect()).collect()
}

pub(super) fn needed_of(device: &Device) -> Vec<BigRational> {
    let unseen = |j: usize| device.joints[j].resolution.clone().unwrap_or_else(zero);
    let rows = matrix_of(device);
    let of = |row: &Vec<BigRational>| -> BigRational {
        let terms = row
            .iter()
            .enumerate()
            .map(|(j, k)| magnitude(k) * unseen(j));
        terms.sum::<BigRational>() * half()
    };
    rows.iter().map(of).collect()
}

pub(super) fn lengths(device: &Device) -> Vec<BigRational> {
    let joints = device.joints.iter();
    joints
        .map(|joint| joint.resolution.clone().unwrap_or_else(|| q(1, 1)))
        .collect()
}

/// Torques from what encoders show, by their own means.
pub(super) fn torques_by_hand(device: &Device, at: &[BigRational]) -> Vec<BigRational> {
    let measured = |joint: &Joint<BigRational>, x: &BigRational| match &joint.resolution {
        Some(delta) => (x.floor() + half()) * delta,
        None => x.clone(),
    };
    let m: Vec<BigRational> = device
        .joints
        .iter()
        .zip(at)
        .map(|(j, x)| measured(j, x))
        .collect();
    if let (Shape::Direction(a), true) = (&device.shape, device.unilateral) {
        let way: BigRational = a.iter().zip(&m).map(|(a, m)| a * m).sum();
        let force = if way > zero() {
            -way * &device.stiffness
        } else {
            zero()
        };
        return a.iter().map(|a| a * &force).collect();
    }
    let row = |row: &Vec<BigRational>| -row.iter().zip(&m).map(|(k, m)| k * m).sum::<BigRational>();
    matrix_of(device).iter().map(row).collect()
}

/// Work of the torques held from `from` to `to` less what friction takes at least in `share` of a period.
pub(super) fn net_by_hand(
    device: &Device,
    from: &[BigRational],
    to: &[BigRational],
    share: &BigRational,
) -> BigRational {
    let torques = torques_by_hand(device, from);
    let lengths = lengths(device);
    let mut net = zero();
    for (i, joint) in device.joints.iter().enumerate() {
        let way = (&to[i] - &from[i]) * &lengths[i];
        let viscous = joint.viscous.clone().unwrap_or_else(zero) * squared(&way);
        let coulomb = joint.coulomb.clone().unwrap_or_else(zero) * magnitude(&way);
        net += &torques[i] * &way - viscous / (&device.period * share) - coulomb;
    }
    net
}

pub(super) fn stored(device: &Device, at: &[BigRational]) -> BigRational {
    let x: Vec<BigRational> = at.iter().zip(lengths(device)).map(|(x, l)| x * l).collect();
    if let (Shape::Direction(a), true) = (&device.shape, device.unilateral) {
        let way: BigRational = a.iter().zip(&x).map(|(a, x)| a * x).sum();
        let way = if way > zero() { way } else { zero() };
        return squared(&way) * &device.stiffness * half();
    }
    definite::quadratic(&matrix_of(device), &x) * half()
}

/// Whether every entry of a principal minor test is at least zero: all 2ⁿ − 1 of them.
pub(super) fn semidefinite_by_minors(rows: &[Vec<BigRational>]) -> bool {
    fn determinant(rows: &[Vec<BigRational>]) -> BigRational {
        let Some((first, rest)) = rows.split_first() else {
            return q(1, 1);
        };
        let minor = |skip: usize| -> Vec<Vec<BigRational>> {
            let keep = |row: &Vec<BigRational>| {
                let kept = row.iter().enumerate().filter(|(j, _)| *j != skip);
                kept.map(|(_, x)| x.clone()).collect()
            };
            rest.iter().map(keep).collect()
        };
        let sign = |j: usize| if j % 2 == 0 { q(1, 1) } else { q(-1, 1) };
        (0..first.len())
            .map(|j| sign(j) * &first[j] * determinant(&minor(j)))
            .sum()
    }
    let n = rows.len();
    (1..1usize << n).all(|set| {
        let inside = |i: &usize| set >> i & 1 == 1;
        let row = |i: usize| (0..n).filter(inside).map(|j| rows[i][j].clone()).collect();
        let minor: Vec<Vec<BigRational>> = (0..n).filter(inside).map(row).collect();
        determinant(&minor) >= zero()
    })
}
