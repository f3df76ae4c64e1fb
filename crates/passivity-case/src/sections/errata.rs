//! The errors of the paper, computed by the kernel, and why its conclusion holds.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::quantizer::held_force;
use passivity_core::{BigRational, Criterion, Friction, Law, Loop, Scalar as _, Step};

use super::PAPER;
use crate::case::Case;
use crate::document::{Document, Line, Row};
use crate::gsn::Anchor;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(
        2,
        "errata",
        "What the paper got wrong, and why the conclusion stands",
    );
    document.say(format!(
        "The criterion is that of {PAPER}. Its bound (22) on the energy generated in a sampling interval \
         is false as printed: (21) ends in an equality that holds only when the device stands \
         equally far into its tick at both ends of the interval. The numbers below are computed by \
         the kernel, exactly, when this document is written.",
    ));
    step(document);
    document.say(
        "The conclusion stands because the storage is a matter of choice. Measured against the \
         linear spring, (22) is true and tight, so no interval in which the criterion holds gains \
         energy (TH-INTERVAL), and neither does any number of them (TH-RUN). The two accounts differ \
         by at most 1/8 KΔ² over any number of intervals (TH-TELESCOPE). So the hand can never draw \
         more than was stored; only the paper's way of seeing it was wrong.",
    );
    switching(document);
    let claims = case.records.claims.claims.iter();
    let refuted = claims.filter(|claim| claim.refutes);
    let items = refuted.map(|claim| {
        Line::link(Anchor::Claim(claim.id.clone()).id(), claim.id.as_str())
            .and(format!(": {}", claim.sentence).into())
    });
    document.list(items.collect());
}

/// A step for which (22) is false, in numbers.
fn step(document: &mut Document) {
    let ratio = |n: i32, d: i32| BigRational::integer(n) / BigRational::integer(d);
    let step = Step::new(ratio(1, 1), ratio(1, 2));
    let friction = Friction::new(ratio(3, 5), ratio(3, 5));
    let interval = HeldInterval::plain(step, BigRational::integer(1));
    let row = ledger::row(&Loop::plain(friction), &interval);
    // The row has (8) times the speed, which is half a tick per sample.
    let margin = row.margin / ratio(1, 2);
    let rows = vec![
        line(
            "E_g, (18) to (20)",
            &row.generated_quantized,
            "generated, against the quantized spring of the paper",
        ),
        line(
            "Right-hand side of (22)",
            &row.bound_22,
            "smaller than E_g: the bound is false",
        ),
        line(
            "TH-QUANT",
            &row.bound_quantized,
            "the tight bound in its place",
        ),
        line(
            "E_g against the linear spring",
            &row.generated_linear,
            "never above the right-hand side of (22): TH-LIN",
        ),
        line("E_d, (26)", &row.dissipated_lower, "dissipated at least"),
        line(
            "Margin of (8), in KT",
            &margin,
            "its left side at half a tick per sample: it holds, and yet E_g > E_d: ERR-27",
        ),
    ];
    document.table(
        "One step from ξ = 1 to ξ = 1/2 in one sampling interval, β = σ = 3/5, energies in KΔ²",
        &[("Figure", 30), ("Value", 12), ("What it says", 58)],
        rows,
    );
}

fn line(name: &str, value: &BigRational, says: &str) -> Row {
    [name.into(), Line::code(value.to_string()), says.into()].into()
}

/// A wall that is switched on at a depth, and pushes the operator out (ERR-IV-C).
struct SwitchedOn {
    /// What friction has to spare at every speed.
    margin: BigRational,
    /// What switching it on added to what is stored.
    added: BigRational,
    /// What switching it off there would add.
    taken: BigRational,
    /// The work of the held forces on the way out.
    work: BigRational,
    /// What friction took of it.
    dissipated: BigRational,
}

impl SwitchedOn {
    /// From `depth` ticks out to the surface, a tick a sample, with β = σ = ½.
    fn at(depth: i32) -> Self {
        let half = BigRational::one().half();
        let friction = Friction::new(half.clone(), half);
        let (back, one) = (BigRational::integer(-1), BigRational::one());
        let a_tick = friction.dissipated_at_constant_velocity(&back, &one);
        let (mut work, mut dissipated) = (BigRational::zero(), BigRational::zero());
        for tick in 1..=depth {
            let from = BigRational::integer(tick);
            let step = Step::new(from.clone(), from - BigRational::one());
            work += held_force(&step.start) * step.displacement();
            dissipated += a_tick.clone();
        }
        let wall = Law::bilateral();
        let inside = BigRational::integer(depth);
        Self {
            margin: Criterion::of_friction(&friction).margin_at_all_speeds(),
            added: wall.switching_energy(false, true, &inside),
            taken: wall.switching_energy(true, false, &inside),
            work,
            dissipated,
        }
    }

    /// What the operator has drawn, at an unchanged speed.
    fn drawn(&self) -> BigRational {
        &self.work - &self.dissipated
    }
}

/// The error at the end of Sec. IV-C, in numbers.
fn switching(document: &mut Document) {
    const DEPTH: i32 = 4;
    document.say(
        "The last sentence of Sec. IV-C says that the virtual force can be set to zero at any time \
         without affecting the energy balance. Set to zero it costs nothing; set back at a depth it does: \
         a wall that is switched on there has energy to give that nobody put in (ERR-IV-C). Nothing is \
         stored before, and the criterion holds at every speed.",
    );
    let found = SwitchedOn::at(DEPTH);
    let rows = vec![
        line(
            "Margin of (8), in KT",
            &found.margin,
            "the least at any speed: the criterion holds",
        ),
        line(
            "Added by switching on",
            &found.added,
            "½ξ², which nobody put in",
        ),
        line(
            "Work of the held forces",
            &found.work,
            "given on the way out of the wall",
        ),
        line("Dissipated", &found.dissipated, "what friction takes of it"),
        line(
            "Drawn by the operator",
            &found.drawn(),
            "what is left, at an unchanged speed: what switching on added",
        ),
        line(
            "Added by switching off",
            &found.taken,
            "there instead: never above zero, so this costs nothing",
        ),
    ];
    let caption = format!(
        "A wall that is switched on at ξ = {DEPTH} and left a tick a sample, β = σ = ½, energies in KΔ²"
    );
    let columns = [("Figure", 30), ("Value", 12), ("What it says", 58)];
    document.table(&caption, &columns, rows);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Block;

    /// By the formula of the claim: on at depth n, out at a tick a sample, the operator draws ½n².
    #[test]
    fn err_iv_c_what_is_drawn_is_what_switching_on_added() {
        for depth in 1..9 {
            let found = SwitchedOn::at(depth);
            let stored = BigRational::integer(depth * depth).half();
            assert_eq!(found.drawn(), stored);
            assert_eq!(found.added, stored);
            assert_eq!(found.taken, -stored);
            assert_eq!(found.margin, BigRational::zero());
        }
    }

    /// Checks the numbers of the only table that is written.
    fn check(write: impl Fn(&mut Document), expected: [&str; 6]) {
        let mut document = Document::new("", "");
        write(&mut document);
        let tables = document.blocks.iter().filter_map(|block| match block {
            Block::Table(table) => Some(table),
            _ => None,
        });
        let value = |row: &Row| row.cells.get(1).cloned();
        let values: Vec<Vec<Line>> = tables
            .map(|table| table.rows.iter().filter_map(value).collect())
            .collect();
        assert_eq!(values, [expected.map(|x| Line::code(x.to_owned()))]);
    }

    #[test]
    fn err_27_is_printed_with_the_margin_of_the_ledger() {
        check(step, ["1/2", "3/8", "1/2", "3/8", "9/20", "3/10"]);
    }

    #[test]
    fn err_iv_c_is_printed_with_its_numbers() {
        check(switching, ["0", "8", "12", "4", "8", "-8"]);
    }
}
