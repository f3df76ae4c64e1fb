//! The held force of the kernel's controller: every combination of its parts, up to three samples
//! late, and the law of the wall that is left without damping and steps.

use passivity_core::controller::Controller;
use passivity_core::{Friction, Loop, Scalar as _};
use passivity_terms::Term;

use crate::formula::Formula;
use crate::plain::var;

/// Positions at the samples, the present one first.
const POSITIONS: [&str; 5] = ["x0", "x1", "x2", "x3", "x4"];

/// The delays that are compared: each is its own formula.
const DELAYS: [u16; 4] = [0, 1, 2, 3];

/// A combination of the parts of a controller, as five bits.
#[derive(Clone, Copy)]
struct Parts(u8);

impl Parts {
    fn all() -> impl Iterator<Item = Self> {
        (0..32).map(Self)
    }

    const fn has(self, bit: u8) -> bool {
        self.0 >> bit & 1 == 1
    }

    const fn encoder(self) -> bool {
        self.has(0)
    }

    const fn one_sided(self) -> bool {
        self.has(1)
    }

    const fn damped(self) -> bool {
        self.has(2)
    }

    const fn stepped(self) -> bool {
        self.has(3)
    }

    const fn limited(self) -> bool {
        self.has(4)
    }

    /// The dimensionless loop with these parts, so many samples late.
    fn late(self, delay: u16) -> Loop<Term> {
        Loop {
            resolution: self.encoder().then(Term::one),
            unilateral: self.one_sided(),
            damping: self.damped().then(|| var("B")),
            force_step: self.stepped().then(|| var("delta")),
            max_force: self.limited().then(|| var("L")),
            delay,
            ..Loop::plain(Friction::new(var("beta"), var("sigma")))
        }
    }

    /// The name of the combination.
    fn name(self) -> String {
        let words = ["encoder", "one_sided", "damped", "stepped", "limited"];
        let there = (0u8..).zip(words).filter(|(bit, _)| self.has(*bit));
        let there: Vec<&str> = there.map(|(_, word)| word).collect();
        if there.is_empty() {
            "plain".to_owned()
        } else {
            there.join("_")
        }
    }

    /// The variables that the combination has beside positions.
    fn numbers(self) -> Vec<&'static str> {
        let all = [
            (self.damped(), "B"),
            (self.stepped(), "delta"),
            (self.limited(), "L"),
        ];
        all.iter()
            .filter(|(has, _)| *has)
            .map(|(_, name)| *name)
            .collect()
    }

    /// What the filter is given for a position.
    fn measured(self, position: &str) -> String {
        if self.encoder() {
            format!("(measured {position})")
        } else {
            position.to_owned()
        }
    }

    /// The controller of the theorems, from two positions.
    fn theorems(self, now: &str, before: &str) -> String {
        let option = |has, name: &str| {
            if has {
                format!("(Some {name})")
            } else {
                "None".to_owned()
            }
        };
        format!(
            "controller {} {} {} {} {} {}",
            self.one_sided(),
            if self.damped() { "B" } else { "0" },
            option(self.stepped(), "delta"),
            option(self.limited(), "L"),
            self.measured(now),
            self.measured(before),
        )
    }

    fn formula(
        self,
        source: &'static str,
        positions: &[&'static str],
        held: Term,
        equals: String,
    ) -> Formula {
        let variables = [positions, &self.numbers()].concat();
        let formula = Formula::new(source, &variables, held, equals).by("bridge_controller");
        if self.limited() {
            formula.given("0 <= L")
        } else {
            formula
        }
    }
}

pub(crate) fn formulas() -> Vec<Formula> {
    let mut all = held();
    all.extend(settled());
    all.extend(laws());
    all
}

/// The force held k samples late.
fn held() -> Vec<Formula> {
    let mut all = Vec::new();
    for parts in Parts::all() {
        for delay in DELAYS {
            let controller = Controller::of(&parts.late(delay));
            let late = usize::from(delay);
            let seen = if parts.damped() { late + 1 } else { late };
            let positions = &POSITIONS[..=seen];
            let samples: Vec<Term> = positions
                .iter()
                .map(|name| controller.measured(&var(name)))
                .collect();
            let equals = parts.theorems(POSITIONS[late], POSITIONS[seen]);
            let held = controller.held_force(&samples);
            all.push(
                parts
                    .formula("Controller::held_force", positions, held, equals)
                    .named(format!("held_{}_{delay}", parts.name())),
            );
        }
    }
    all
}

/// The force held when the device has rested: whatever the delay, that of one position.
fn settled() -> Vec<Formula> {
    let settled = |parts: Parts| {
        let controller = Controller::of(&parts.late(2));
        let held = controller.settled(&controller.measured(&var("x0")));
        parts
            .formula(
                "Controller::settled",
                &POSITIONS[..1],
                held,
                parts.theorems("x0", "x0"),
            )
            .named(format!("settled_{}", parts.name()))
    };
    Parts::all().map(settled).collect()
}

/// The law of the wall and its potential.
fn laws() -> Vec<Formula> {
    let mut all = Vec::new();
    for parts in
        Parts::all().filter(|parts| !parts.encoder() && !parts.damped() && !parts.stepped())
    {
        let law = parts.late(0).law();
        let limit = if parts.limited() { "(Some L)" } else { "None" };
        let x = var("x");
        for (name, term) in [("law", law.force(&x)), ("potential", law.potential(&x))] {
            let equals = format!("controller_{name} {} {limit} x", parts.one_sided());
            all.push(
                parts
                    .formula("Loop::law", &["x"], term, equals)
                    .by("bridge_law")
                    .named(format!("loop_{name}_{}", parts.name())),
            );
        }
    }
    all
}
