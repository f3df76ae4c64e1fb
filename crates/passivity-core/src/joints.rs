//! A device of several joints against one wall: its description and its account (TH-NDOF).
//!
//! Joint i has an encoder of resolution Δᵢ, friction bᵢ and cᵢ. The wall's torques are −𝐊·(measured q),
//! held, with 𝐊 symmetric and positive semidefinite. Inertia, Coriolis and gravity terms neither draw nor
//! dissipate energy and are no part of it. Everything is in the units of the caller, joint by joint;
//! positions are in ticks of the joint's encoder, or in its unit of length where it has none.

use alloc::vec::Vec;

use crate::definite;
use crate::parameter::Parameter;
use crate::quantizer::Quantized;
use crate::scalar::Scalar;

/// What is known of one joint: rows of the table of parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint<V> {
    /// b ≥ 0, viscous friction; absent it is zero.
    pub viscous: Option<V>,
    /// c ≥ 0, Coulomb friction; absent it is zero.
    pub coulomb: Option<V>,
    /// Δ > 0, resolution of the encoder; absent the position is known exactly.
    pub resolution: Option<V>,
    /// V > 0, a bound on the joint's speed.
    pub max_speed: Option<V>,
}

/// How the wall acts on the joints; 𝐊 is the stiffness times this.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<S> {
    /// a = Jᵀn: way of the wall for a unit of each joint. 𝐊 = K·aaᵀ.
    Direction(Vec<S>),
    /// A symmetric, positive semidefinite matrix by rows, in units of the stiffness.
    Matrix(Vec<Vec<S>>),
}

/// A parameter of a device of several joints: of the loop, or of one joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The row of the table of parameters.
    pub parameter: Parameter,
    /// Which joint, counted from 0; `None` for the wall and the sampling.
    pub joint: Option<usize>,
}

/// A device of several joints, its control loop and a wall.
///
/// `V` is what is known of each parameter, as for [`Loop`](crate::Loop): a number, an interval, or a
/// text. `S` is the kind of number that the shape of the wall is given in.
///
/// # Example
///
/// Two joints, a wall of 2 N/m in a direction in which a radian of either moves it by ½ m.
///
/// ```
/// use passivity_core::{Fixed, Scalar, joints::{Joint, Joints, Shape}};
///
/// let joint = Joint {
///     viscous: Some(Fixed::new(1, 1000)),
///     coulomb: Some(Fixed::new(1, 100)),
///     resolution: Some(Fixed::new(1, 100)),
///     max_speed: None,
/// };
/// let half = Fixed::new(1, 2);
/// let device = Joints {
///     stiffness: Fixed::integer(2),
///     period: Fixed::new(1, 1000),
///     joints: vec![joint.clone(), joint],
///     shape: Shape::Direction(vec![half, half]),
///     unilateral: false,
/// };
/// // ½(|K₁₁|Δ₁ + |K₁₂|Δ₂), with every entry of 𝐊 2·½·½
/// assert_eq!(device.coulomb_needed().first(), Some(&Fixed::new(1, 200)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Joints<V, S> {
    /// K > 0, the wall's stiffness; 1 for a wall that is given as a matrix.
    pub stiffness: V,
    /// T > 0, the sampling period.
    pub period: V,
    /// The joints, in order.
    pub joints: Vec<Joint<V>>,
    /// How the wall acts on them: as many entries as there are joints.
    pub shape: Shape<S>,
    /// Whether the wall is on one side only, a·q ≥ 0 (TH-UNI); for a direction.
    pub unilateral: bool,
}

/// The parameters that a joint has.
const OF_JOINT: [Parameter; 4] = [
    Parameter::Viscous,
    Parameter::Coulomb,
    Parameter::Resolution,
    Parameter::MaxSpeed,
];

impl<V> Joint<V> {
    const fn get(&self, parameter: Parameter) -> Option<&V> {
        match parameter {
            Parameter::Viscous => self.viscous.as_ref(),
            Parameter::Coulomb => self.coulomb.as_ref(),
            Parameter::Resolution => self.resolution.as_ref(),
            Parameter::MaxSpeed => self.max_speed.as_ref(),
            _ => None,
        }
    }
}

impl<V, S: Clone> Joints<V, S> {
    /// The places of all parameters, those of the loop first.
    pub fn places(&self) -> impl Iterator<Item = Place> + use<V, S> {
        let of_loop = [Parameter::Stiffness, Parameter::Period].into_iter();
        let of_loop = of_loop.map(|parameter| Place {
            parameter,
            joint: None,
        });
        let of_joints = (0..self.joints.len()).flat_map(|joint| {
            OF_JOINT.into_iter().map(move |parameter| Place {
                parameter,
                joint: Some(joint),
            })
        });
        of_loop.chain(of_joints)
    }

    /// What is known at a place; `None` when it is absent.
    #[must_use]
    pub fn get(&self, place: Place) -> Option<&V> {
        match (place.joint, place.parameter) {
            (None, Parameter::Stiffness) => Some(&self.stiffness),
            (None, Parameter::Period) => Some(&self.period),
            (None, _) => None,
            (Some(joint), parameter) => self.joints.get(joint)?.get(parameter),
        }
    }

    /// The same device with another value at a place that it has.
    #[must_use]
    pub fn with(mut self, place: Place, value: V) -> Self {
        let joint = place.joint.and_then(|joint| self.joints.get_mut(joint));
        match (joint, place.parameter) {
            (None, Parameter::Stiffness) => self.stiffness = value,
            (None, Parameter::Period) => self.period = value,
            (Some(joint), Parameter::Viscous) => joint.viscous = Some(value),
            (Some(joint), Parameter::Coulomb) => joint.coulomb = Some(value),
            (Some(joint), Parameter::Resolution) => joint.resolution = Some(value),
            (Some(joint), Parameter::MaxSpeed) => joint.max_speed = Some(value),
            (_, _) => {}
        }
        self
    }

    /// The same device with the shape of its wall in another kind of number.
    #[must_use]
    pub fn reshaped<U>(self, shape: Shape<U>) -> Joints<V, U> {
        Joints {
            stiffness: self.stiffness,
            period: self.period,
            joints: self.joints,
            shape,
            unilateral: self.unilateral,
        }
    }

    /// The same device with every value taken through `f`; `None` when `f` gives up on one.
    pub fn try_map<U>(&self, mut f: impl FnMut(Place, &V) -> Option<U>) -> Option<Joints<U, S>> {
        let mut of_loop = |parameter, value| {
            let joint = None;
            f(Place { parameter, joint }, value)
        };
        let stiffness = of_loop(Parameter::Stiffness, &self.stiffness)?;
        let period = of_loop(Parameter::Period, &self.period)?;
        let mut joints = Vec::with_capacity(self.joints.len());
        for (at, joint) in self.joints.iter().enumerate() {
            let mut of_joint = |parameter: Parameter| match joint.get(parameter) {
                Some(value) => {
                    let joint = Some(at);
                    f(Place { parameter, joint }, value).map(Some)
                }
                None => Some(None),
            };
            joints.push(Joint {
                viscous: of_joint(Parameter::Viscous)?,
                coulomb: of_joint(Parameter::Coulomb)?,
                resolution: of_joint(Parameter::Resolution)?,
                max_speed: of_joint(Parameter::MaxSpeed)?,
            });
        }
        Some(Joints {
            stiffness,
            period,
            joints,
            shape: self.shape.clone(),
            unilateral: self.unilateral,
        })
    }
}

impl<S: Clone> Shape<S> {
    /// The same shape in another kind of number; `None` when `f` gives up on an entry.
    pub fn try_map<U>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Shape<U>> {
        let row = |row: &Vec<S>| row.iter().map(&f).collect::<Option<Vec<U>>>();
        Some(match self {
            Self::Direction(a) => Shape::Direction(row(a)?),
            Self::Matrix(rows) => Shape::Matrix(rows.iter().map(row).collect::<Option<_>>()?),
        })
    }
}

impl<S: Scalar> Shape<S> {
    /// The matrix by rows: aaᵀ of a direction.
    #[must_use]
    pub fn rows(&self) -> Vec<Vec<S>> {
        match self {
            Self::Matrix(rows) => rows.clone(),
            Self::Direction(a) => {
                let row = |x: &S| a.iter().map(|y| x.clone() * y.clone()).collect();
                a.iter().map(row).collect()
            }
        }
    }
}

/// Σ xᵢyᵢ.
pub(crate) fn dot<'a, S: Scalar + 'a>(
    x: impl IntoIterator<Item = &'a S>,
    y: impl IntoIterator<Item = &'a S>,
) -> S {
    let pairs = x.into_iter().zip(y);
    pairs.fold(S::zero(), |sum, (x, y)| {
        (sum + x.clone() * y.clone()).shortened()
    })
}

impl<S: Scalar> Joint<S> {
    /// b, zero when absent.
    #[must_use]
    pub fn viscous_friction(&self) -> S {
        self.viscous.clone().unwrap_or_else(S::zero)
    }

    /// c, zero when absent.
    #[must_use]
    pub fn coulomb_friction(&self) -> S {
        self.coulomb.clone().unwrap_or_else(S::zero)
    }

    /// The unit of the joint's positions: Δ, or 1 without an encoder.
    #[must_use]
    pub fn length(&self) -> S {
        self.resolution.clone().unwrap_or_else(S::one)
    }

    /// Δ, the size of what the joint's encoder does not see; zero without an encoder.
    #[must_use]
    pub fn unseen(&self) -> S {
        self.resolution.clone().unwrap_or_else(S::zero)
    }

    /// What the control loop knows of a position, in the same unit: the middle of the tick.
    #[must_use]
    pub fn measured(&self, position: &S) -> S {
        match self.resolution {
            Some(_) => Quantized::of(position).measured(),
            None => position.clone(),
        }
    }
}

impl<S: Scalar> Joints<S, S> {
    /// 𝐊 by rows.
    #[must_use]
    pub fn stiffness_matrix(&self) -> Vec<Vec<S>> {
        let mut rows = self.shape.rows();
        for entry in rows.iter_mut().flatten() {
            *entry = (self.stiffness.clone() * entry.clone()).shortened();
        }
        rows
    }

    /// Positions or displacements with units: those of the joints times their unit of length.
    #[must_use]
    pub fn with_units(&self, positions: &[S]) -> Vec<S> {
        let pairs = self.joints.iter().zip(positions);
        pairs.map(|(joint, x)| joint.length() * x.clone()).collect()
    }

    /// The torques that are held from a sample at `positions`: −𝐊 times what is measured; of a
    /// one-sided wall none where the measured way into it is below zero.
    #[must_use]
    pub fn held_torques(&self, positions: &[S]) -> Vec<S> {
        let pairs = self.joints.iter().zip(positions);
        let measured: Vec<S> = pairs.map(|(joint, x)| joint.measured(x)).collect();
        let measured = self.with_units(&measured);
        if let (Shape::Direction(a), true) = (&self.shape, self.unilateral) {
            let into = dot(a, &measured).max(S::zero());
            let force = -(self.stiffness.clone() * into);
            return a.iter().map(|a| a.clone() * force.clone()).collect();
        }
        let rows = self.stiffness_matrix();
        rows.iter().map(|row| -dot(row, &measured)).collect()
    }

    /// Work of the torques that are held from `from`, on the way to `to`.
    #[must_use]
    pub fn work(&self, from: &[S], to: &[S]) -> S {
        let (start, end) = (self.with_units(from), self.with_units(to));
        let way: Vec<S> = end.into_iter().zip(start).map(|(x, y)| x - y).collect();
        dot(&self.held_torques(from), &way)
    }

    /// Energy generated on the way from a sample at `from` to `to` within its interval: the work of the
    /// held torques and what the spring −𝐊q of a wall on both sides would have stored,
    /// ½q₁ᵀ𝐊q₁ − ½q₀ᵀ𝐊q₀ (TH-NDOF).
    #[must_use]
    pub fn generated(&self, from: &[S], to: &[S]) -> S {
        let rows = self.stiffness_matrix();
        let stored = |x: &[S]| definite::quadratic(&rows, &self.with_units(x)).half();
        self.work(from, to) + stored(to) - stored(from)
    }

    /// The same by residues, ½dᵀ𝐊d + Σᵢⱼ dᵢKᵢⱼΔⱼ(ρⱼ − ½), for a wall on both sides (TH-NDOF).
    #[must_use]
    pub fn generated_by_residues(&self, from: &[S], to: &[S]) -> S {
        let pairs = to.iter().zip(from);
        let way: Vec<S> = pairs.map(|(x, y)| x.clone() - y.clone()).collect();
        let way = self.with_units(&way);
        let pairs = self.joints.iter().zip(from);
        let errors: Vec<S> = pairs
            .map(|(joint, x)| joint.length() * (x.clone() - joint.measured(x)))
            .collect();
        let rows = self.stiffness_matrix();
        let by_row = rows.iter().map(|row| dot(row, &errors));
        let by_row: Vec<S> = by_row.collect();
        definite::quadratic(&rows, &way).half() + dot(&way, &by_row)
    }

    /// What a displacement d (with units) generates at most, from whatever residues:
    /// ½dᵀ𝐊d + ½Σᵢ|dᵢ|Σⱼ|Kᵢⱼ|Δⱼ (TH-NDOF).
    #[must_use]
    pub fn bound(&self, displacement: &[S]) -> S {
        let rows = self.stiffness_matrix();
        let magnitudes: Vec<S> = displacement.iter().map(Scalar::abs).collect();
        definite::quadratic(&rows, displacement).half() + dot(&magnitudes, &self.coulomb_needed())
    }

    /// What friction takes at least on a displacement d (with units) within a sampling period:
    /// Σᵢ bᵢdᵢ²/T + cᵢ|dᵢ|.
    #[must_use]
    pub fn dissipated_lower(&self, displacement: &[S]) -> S {
        let pairs = self.joints.iter().zip(displacement);
        pairs.fold(S::zero(), |sum, (joint, d)| {
            let viscous = (joint.viscous_friction() * d.square()).over(self.period.clone());
            (sum + viscous + joint.coulomb_friction() * d.abs()).shortened()
        })
    }

    /// ½Σⱼ|Kᵢⱼ|Δⱼ for each joint i: the Coulomb friction that the encoders ask of it (TH-NDOF).
    #[must_use]
    pub fn coulomb_needed(&self) -> Vec<S> {
        let unseen: Vec<S> = self.joints.iter().map(Joint::unseen).collect();
        let rows = self.stiffness_matrix();
        let needed = |row: &Vec<S>| {
            let magnitudes: Vec<S> = row.iter().map(Scalar::abs).collect();
            dot(&magnitudes, &unseen).half()
        };
        rows.iter().map(needed).collect()
    }

    /// diag(b) − (T/2)𝐊 by rows, which has to be positive semidefinite at every speed (TH-NDOF).
    #[must_use]
    pub fn viscous_form(&self) -> Vec<Vec<S>> {
        let half_period = self.period.clone().half();
        let mut rows = self.stiffness_matrix();
        for ((at, row), joint) in rows.iter_mut().enumerate().zip(&self.joints) {
            for (column, entry) in row.iter_mut().enumerate() {
                let taken = half_period.clone() * entry.clone();
                *entry = if column == at {
                    joint.viscous_friction() - taken
                } else {
                    -taken
                };
            }
        }
        rows
    }

    /// What an operator gains on a cycle `from` → `from` + `move` → `from` from the held torques and
    /// friction alone, each way at constant speed within one sampling period (TH-NDOF).
    #[must_use]
    pub fn gain(&self, from: &[S], step: &[S]) -> S {
        let to = from.iter().zip(step).map(|(x, d)| x.clone() + d.clone());
        let to: Vec<S> = to.collect();
        let spent = self.dissipated_lower(&self.with_units(step)).double();
        self.work(from, &to) + self.work(&to, from) - spent
    }
}
