//! A run as a table: the ledger row of every interval, with velocities and dissipated energy.

use std::cmp::Ordering;
use std::fmt::Write as _;

use passivity_core::{BigRational, Friction, Scalar as _, Step, ledger};
use passivity_scene::Point;

use crate::enclosed::Enclosed;
use crate::ledger::Entry;
use crate::methods::{Line, Method};
use crate::model::Row;
use crate::plan::Plan;
use crate::real::{Real, Undecided};

/// The columns of figures, in the order of the interface; `h`, `dtau` and truths stand between.
const FIGURES: [&str; 13] = [
    "xi0",
    "xi1",
    "generated_linear",
    "generated_quantized",
    "bound_22",
    "bound_quantized",
    "dissipated_lower",
    "net_linear",
    "net_quantized",
    "margin",
    "v0",
    "v1",
    "dissipated",
];

/// What the rows of a run need beside the run.
#[derive(Clone, Debug)]
pub struct Table {
    friction: Friction<BigRational>,
    criterion: [BigRational; 2],
    doubles: [f64; 4],
    enclosures: bool,
}

/// The figures of a row in some kind of number.
struct Figures<T> {
    figures: [T; 9],
    margin: Option<T>,
    truths: [Option<bool>; 3],
    motion: [T; 3],
}

impl Table {
    /// The table of a scene's point by a method.
    #[must_use]
    pub fn new(point: &Point, plan: &Plan, method: &Method) -> Self {
        let effects = passivity_core::effects::Effects {
            encoder: point.encoder,
            delay: point.delay,
            damping: point.damping.clone(),
            force_step: point.force_step.clone(),
        };
        let rig = passivity_core::Rig::dimensionless(point.friction(), effects);
        let criterion = rig.dimensionless_criterion();
        let [at_speed, constant] = plan.criterion;
        Self {
            friction: point.friction(),
            criterion: [criterion.viscous, criterion.coulomb],
            doubles: [
                plan.constants.beta,
                plan.constants.sigma,
                at_speed,
                constant,
            ],
            enclosures: *method == Method::Enclosure,
        }
    }

    /// The header, without a line break.
    ///
    /// The last column, `xi`, is the position at the sample once more, as `passivity audit` reads it.
    #[must_use]
    pub fn header(&self) -> String {
        let names = |from: usize, to: usize| {
            let columns = FIGURES[from..to].iter().map(|name| {
                if self.enclosures {
                    format!("{name}_lo,{name}_hi")
                } else {
                    (*name).to_owned()
                }
            });
            columns.collect::<Vec<_>>().join(",")
        };
        let truths = "criterion_holds,violates_linear,violates_quantized";
        let sample = if self.enclosures { "" } else { ",xi" };
        format!(
            "h,{},dtau,{},{truths},{}{sample}",
            names(0, 2),
            names(2, 10),
            names(10, 13)
        )
    }

    /// Appends a row with its line break.
    pub fn write(&self, line: &Line<'_>, out: &mut String) {
        match line {
            Line::Double(entry) => {
                let row = self.of_doubles(entry);
                self.put(entry.h, &row, out, |x, out| {
                    // Shortest decimals that read back as the same double.
                    let _ = write!(out, "{x:?}");
                });
                let _ = writeln!(out, ",{:?}", entry.xi0);
            }
            Line::Exact(row) => {
                let figures = self.of_rationals(row);
                self.put(row.h, &figures, out, |x, out| {
                    let _ = write!(out, "{x}");
                });
                let _ = writeln!(out, ",{}", row.xi[0]);
            }
            Line::Enclosed(row) => {
                let figures = self.of_enclosures(row);
                self.put(row.h, &figures, out, |x, out| {
                    let _ = write!(out, "{:?},{:?}", x.lo, x.hi);
                });
                out.push('\n');
            }
        }
    }

    fn put<T>(&self, h: u64, row: &Figures<T>, out: &mut String, figure: impl Fn(&T, &mut String)) {
        let _ = write!(out, "{h}");
        for (index, x) in row.figures.iter().enumerate() {
            out.push(',');
            figure(x, out);
            if index == 1 {
                out.push_str(",1");
            }
        }
        out.push(',');
        match &row.margin {
            Some(margin) => figure(margin, out),
            None if self.enclosures => out.push(','),
            None => {}
        }
        for truth in row.truths {
            out.push_str(match truth {
                Some(true) => ",true",
                Some(false) => ",false",
                None => ",",
            });
        }
        for x in &row.motion {
            out.push(',');
            figure(x, out);
        }
    }

    fn of_doubles(&self, entry: &Entry) -> Figures<f64> {
        let [beta, sigma, at_speed, constant] = self.doubles;
        let d = entry.displacement();
        let lower = entry.dissipated_lower(beta, sigma);
        let speed = d.abs();
        let moved = d != 0.0;
        // At a speed that is almost nothing the quotient is beyond all doubles.
        let quotient = (constant / speed).clamp(-f64::MAX, f64::MAX);
        let [linear, quantized] = [entry.generated_linear, entry.generated_quantized];
        Figures {
            figures: [
                entry.xi0,
                entry.xi1,
                linear,
                quantized,
                entry.bound_22(),
                entry.bound_quantized(),
                lower,
                lower - linear,
                lower - quantized,
            ],
            truths: [
                moved.then_some(at_speed * speed + constant >= 0.0),
                Some(lower < linear),
                Some(lower < quantized),
            ],
            margin: moved.then_some(at_speed + quotient),
            motion: [entry.v0, entry.v1, entry.dissipated],
        }
    }

    fn of_rationals(&self, row: &Row<BigRational>) -> Figures<BigRational> {
        let step = Step::new(row.xi[0].clone(), row.xi[1].clone());
        let one = BigRational::integer(1);
        // Bounds by the kernel; what was generated is the simulation's, which knows every effect.
        let kernel = ledger::row(&step, &self.friction, &one);
        let speed = passivity_core::Scalar::abs(&step.displacement());
        let [at_speed, constant] = &self.criterion;
        let still = speed == BigRational::integer(0);
        let margin = (!still).then(|| at_speed + constant / &speed);
        let lower = kernel.dissipated_lower;
        let (linear, quantized) = (&row.generated_linear, &row.generated_quantized);
        let negative = |x: &BigRational| *x < BigRational::integer(0);
        let nets = [&lower - linear, &lower - quantized];
        Figures {
            truths: [
                margin.as_ref().map(|m| !negative(m)),
                Some(negative(&nets[0])),
                Some(negative(&nets[1])),
            ],
            margin,
            figures: {
                let [net_linear, net_quantized] = nets;
                [
                    step.start,
                    step.end,
                    linear.clone(),
                    quantized.clone(),
                    kernel.bound_22,
                    kernel.bound_quantized,
                    lower,
                    net_linear,
                    net_quantized,
                ]
            },
            motion: [
                row.velocity[0].clone(),
                row.velocity[1].clone(),
                row.dissipated.clone(),
            ],
        }
    }

    fn of_enclosures(&self, row: &Row<Enclosed<f64>>) -> Figures<Enclosed<f64>> {
        let d = row.xi[1].clone() - row.xi[0].clone();
        let size = magnitude(&d);
        let half = size.ratio(1, 2);
        let bound = half.clone() * size.clone() * (size.clone() + size.one());
        let bump = match size.floor() {
            Ok(whole) => {
                let rest = size.clone() - whole;
                half * rest.clone() * (rest.one() - rest)
            }
            // Both sides of a whole tick: between 0 and 1/8.
            Err(Undecided) => Enclosed { lo: 0.0, hi: 0.125 },
        };
        let number = |x: &BigRational| Enclosed::double(x);
        let (beta, sigma) = (number(&self.friction.beta), number(&self.friction.sigma));
        let lower = size.clone() * (beta * size.clone() + sigma);
        let [at_speed, constant] = [number(&self.criterion[0]), number(&self.criterion[1])];
        let surplus = at_speed.clone() * size.clone() + constant.clone();
        // A step that may be none has no margin to enclose.
        let margin = (size.lo > 0.0).then(|| at_speed + constant / size);
        let nets = [
            lower.clone() - row.generated_linear.clone(),
            lower.clone() - row.generated_quantized.clone(),
        ];
        let negative = |x: &Enclosed<f64>| match x.sign() {
            Ok(sign) => Some(sign == Ordering::Less),
            Err(Undecided) if x.lo >= 0.0 => Some(false),
            Err(Undecided) => None,
        };
        let still = d.sign() == Ok(Ordering::Equal);
        let truths = [
            if still {
                None
            } else {
                negative(&surplus).map(|n| !n)
            },
            negative(&nets[0]),
            negative(&nets[1]),
        ];
        let [net_linear, net_quantized] = nets;
        Figures {
            figures: [
                row.xi[0].clone(),
                row.xi[1].clone(),
                row.generated_linear.clone(),
                row.generated_quantized.clone(),
                bound.clone(),
                bound + bump,
                lower,
                net_linear,
                net_quantized,
            ],
            margin,
            truths,
            motion: [
                row.velocity[0].clone(),
                row.velocity[1].clone(),
                row.dissipated.clone(),
            ],
        }
    }
}

/// |x| of an interval that may hold 0.
fn magnitude(x: &Enclosed<f64>) -> Enclosed<f64> {
    if x.lo >= 0.0 {
        x.clone()
    } else if x.hi <= 0.0 {
        -x.clone()
    } else {
        Enclosed {
            lo: 0.0,
            hi: x.hi.max(-x.lo),
        }
    }
}
