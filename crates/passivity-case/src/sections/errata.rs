//! The errors of the paper, computed by the kernel, and why its conclusion holds.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{BigRational, Friction, Loop, Scalar as _, Step};

use crate::case::Case;
use crate::document::{Document, Line, Row};
use crate::gsn::Anchor;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(
        2,
        "errata",
        "What the paper got wrong, and why the conclusion stands",
    );
    document.say(
        "The criterion is that of Diolaiti, Niemeyer, Barbagli and Salisbury, A Criterion for the \
         Passivity of Haptic Devices. Its bound (22) on the energy generated in a sampling interval \
         is false as printed: (21) ends in an equality that holds only when the device stands \
         equally far into its tick at both ends of the interval. The numbers below are computed by \
         the kernel, exactly, when this document is written.",
    );
    let ratio = |n: i32, d: i32| BigRational::integer(n) / BigRational::integer(d);
    let step = Step::new(ratio(1, 1), ratio(1, 2));
    let friction = Friction::new(ratio(3, 5), ratio(3, 5));
    let interval = HeldInterval::plain(step, BigRational::integer(1));
    let row = ledger::row(&Loop::plain(friction), &interval);
    let line = |name: &str, value: &BigRational, says: &str| -> Row {
        [name.into(), Line::code(value.to_string()), says.into()].into()
    };
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
            "Margin of (8)",
            &row.margin,
            "the criterion holds, and yet E_g > E_d: ERR-27",
        ),
    ];
    document.table(
        "One step from ξ = 1 to ξ = 1/2 in one sampling interval, β = σ = 3/5, in KΔ²",
        &[("Figure", 30), ("Value", 12), ("What it says", 58)],
        rows,
    );
    document.say(
        "The conclusion stands because the storage is a matter of choice. Measured against the \
         linear spring, (22) is true and tight, so no interval in which the criterion holds gains \
         energy (TH-INTERVAL), and neither does any number of them (TH-RUN). The two accounts differ \
         by at most 1/8 KΔ² over any number of intervals (TH-TELESCOPE). So the hand can never draw \
         more than was stored; only the paper's way of seeing it was wrong.",
    );
    let claims = case.records.claims.claims.iter();
    let refuted = claims.filter(|claim| claim.refutes);
    let items = refuted.map(|claim| {
        Line::link(Anchor::Claim(claim.id.clone()).id(), claim.id.as_str())
            .and(format!(": {}", claim.sentence).into())
    });
    document.list(items.collect());
}
