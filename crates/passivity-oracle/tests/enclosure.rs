//! The enclosure of a counted interval holds every row that the counts allow, and no more.

use passivity_core::effects::Effects;
use passivity_core::{BigRational, Fixed, Friction, Scalar, Truth, Wide};
use passivity_oracle::number::Written;
use passivity_oracle::{Cell, Entry, Model, Span, entry};
use proptest::prelude::*;

/// Residues are multiples of 1/GRID, the upper end of a tick left out.
const GRID: i128 = 16;

fn friction() -> impl Strategy<Value = Friction<Fixed>> {
    (0..40_i128, 0..40_i128).prop_map(|(b, s)| Friction::new(Fixed::new(b, 20), Fixed::new(s, 20)))
}

fn model() -> impl Strategy<Value = Model<Fixed>> {
    let law = (any::<bool>(), prop::option::of(1..9_i128));
    let effects = (
        0..3_u16,
        prop::option::of(0..5_i128),
        prop::option::of(1..4_i128),
    )
        .prop_map(|(delay, damping, step)| Effects {
            encoder: true,
            delay,
            damping: damping.map(|b| Fixed::new(b, 4)),
            force_step: step.map(|s| Fixed::new(s, 3)),
        });
    (friction(), friction(), law, effects).prop_map(|(a, b, law, effects)| Model {
        exact: a == b,
        least: Friction::new(a.beta.min(b.beta), a.sigma.min(b.sigma)),
        most: Friction::new(a.beta.max(b.beta), a.sigma.max(b.sigma)),
        unilateral: law.0,
        max_force: law.1.map(|c| Fixed::new(c, 3)),
        effects,
    })
}

fn within(outer: Option<&Span<BigRational>>, inner: Option<&Span<BigRational>>) -> bool {
    match (outer, inner) {
        (Some(outer), Some(inner)) => outer.lo() <= inner.lo() && inner.hi() <= outer.hi(),
        (outer, inner) => outer.is_none() && inner.is_none(),
    }
}

fn agrees(outer: Truth, inner: Truth) -> bool {
    outer == Truth::Depends || outer == inner
}

fn encloses(outer: &Entry<BigRational>, inner: &Entry<BigRational>) -> Result<(), TestCaseError> {
    for ((name, outer), (_, inner)) in outer.figures().into_iter().zip(inner.figures()) {
        prop_assert!(
            within(outer, inner),
            "{name}: {outer:?} does not hold {inner:?}"
        );
    }
    // Nothing may have moved: then there is no margin.
    if let (Some(outer), Some(inner)) = (&outer.margin, &inner.margin) {
        let above = outer.lo().is_none() || outer.lo() <= inner.lo();
        let below = outer.hi().is_none() || (inner.hi().is_some() && inner.hi() <= outer.hi());
        prop_assert!(above && below, "{outer:?} does not hold {inner:?}");
    }
    prop_assert!(agrees(outer.criterion_holds, inner.criterion_holds));
    prop_assert!(agrees(outer.violates_linear, inner.violates_linear));
    prop_assert!(agrees(outer.violates_quantized, inner.violates_quantized));
    Ok(())
}

fn at(tick: i32, residue: i128) -> Cell<Fixed> {
    Cell::of(&(Fixed::integer(tick) + Fixed::new(residue, GRID)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn holds_every_row_the_counts_allow(
        model in model(),
        ticks in prop::collection::vec((-6..7_i32, 0..GRID), 2..6),
        quarter_periods in 1..12_i128,
    ) {
        let dtau = Fixed::new(quarter_periods, 4);
        let counted: Vec<_> = ticks.iter().map(|t| Cell::count(Fixed::integer(t.0))).collect();
        let exact: Vec<_> = ticks.iter().map(|t| at(t.0, t.1)).collect();
        let outer = row(&model, &counted[1..], &counted[0], &dtau);
        let inner = row(&model, &exact[1..], &exact[0], &dtau);
        encloses(&outer, &inner)?;
    }

    /// A theorem, whatever the trace: where the criterion holds, the linear account is not short.
    #[test]
    fn criterion_implies_no_linear_violation(
        model in model(),
        ticks in prop::collection::vec((-6..7_i32, 0..GRID), 2..6),
        quarter_periods in 1..5_i128,
    ) {
        // Saturation together with virtual damping is not covered.
        prop_assume!(model.max_force.is_none() || model.effects.damping.is_none());
        let dtau = Fixed::new(quarter_periods, 4);
        let exact: Vec<_> = ticks.iter().map(|t| at(t.0, t.1)).collect();
        let row = row(&model, &exact[1..], &exact[0], &dtau);
        prop_assert!(row.criterion_holds != Truth::Holds || row.violates_linear == Truth::Fails,
            "{row:?}");
    }

    #[test]
    fn plain_enclosure_is_reached(
        friction in friction(),
        start in -6..7_i32,
        end in -6..7_i32,
        quarter_periods in 1..12_i128,
    ) {
        let model = Model::plain(friction);
        let dtau = Fixed::new(quarter_periods, 4);
        let [from, to] = [start, end].map(|n| Cell::count(Fixed::integer(n)));
        let outer = row(&model, std::slice::from_ref(&from), &to, &dtau);
        // The closed square on a grid, by the formulas of the claims. The corners are on it; a
        // vertex on an edge is at most half a grid step away, so the parabola, of curvature at
        // most 2(β/Δτ + ½) ≤ 17, is off by at most ½·17·(1/32)² < 1/100 there.
        let slack = BigRational::new(1.into(), 100.into());
        let half = Fixed::new(1, 2);
        let ticks = Fixed::integer(end - start);
        let mut extremes = [(Fixed::integer(1_000_000), Fixed::integer(-1_000_000)); 4];
        for (w, u) in (0..=GRID).flat_map(|w| (0..=GRID).map(move |u| (w, u))) {
            let (w, u) = (Fixed::new(w, GRID), Fixed::new(u, GRID));
            let d = ticks + u - w;
            let spent = friction.beta * d * d.over(dtau) + friction.sigma * d.abs();
            let linear = (d * d).half() + (w - half) * d;
            let quantized = (ticks * ticks).half() + ticks * (u - half);
            let values = [linear, quantized, spent - linear, spent - quantized];
            for ((least, most), value) in extremes.iter_mut().zip(values) {
                *least = (*least).min(value);
                *most = (*most).max(value);
            }
        }
        let figures = [
            &outer.generated_linear,
            &outer.generated_quantized,
            &outer.net_linear,
            &outer.net_quantized,
        ];
        for (figure, (least, most)) in figures.into_iter().zip(extremes) {
            let (lo, hi) = (figure.lo().clone(), figure.hi().clone());
            let (least, most) = (least.to_rational().unwrap(), most.to_rational().unwrap());
            prop_assert!(lo <= least && &least - &lo <= slack, "{lo} {least}");
            prop_assert!(hi >= most && &hi - &most <= slack, "{hi} {most}");
        }
    }

    #[test]
    fn fixed_width_and_big_integers_agree(
        model in model(),
        ticks in prop::collection::vec((-6..7_i32, 0..GRID), 2..6),
        counted: bool,
    ) {
        let fixed = |t: &(i32, i128)| if counted { Cell::count(Fixed::integer(t.0)) } else { at(t.0, t.1) };
        let wide = |cell: Cell<Fixed>| Cell {
            tick: widen(&cell.tick).unwrap(),
            residue: cell.residue.try_map(widen).unwrap(),
        };
        let cells: Vec<_> = ticks.iter().map(fixed).collect();
        let wides: Vec<_> = cells.iter().cloned().map(wide).collect();
        let narrow = entry(&model, &cells[1..], &cells[0], &Fixed::integer(1));
        prop_assume!(narrow.is_some());
        let narrow = narrow.unwrap();
        let broad = entry(&model.try_map(widen).unwrap(), &wides[1..], &wides[0], &Wide::integer(1)).unwrap();
        let (mut a, mut b) = (Vec::new(), Vec::new());
        narrow.write_json(0, &mut a);
        broad.write_json(0, &mut b);
        prop_assert_eq!(String::from_utf8(a), String::from_utf8(b));
    }
}

/// Over checked machine integers, or over big ones where those overflow.
fn row(
    model: &Model<Fixed>,
    samples: &[Cell<Fixed>],
    end: &Cell<Fixed>,
    dtau: &Fixed,
) -> Entry<BigRational> {
    let big = |x: &Fixed| x.to_rational();
    let cell = |cell: &Cell<Fixed>| Cell {
        tick: big(&cell.tick).unwrap(),
        residue: cell.residue.try_map(big).unwrap(),
    };
    let samples: Vec<_> = samples.iter().map(cell).collect();
    entry(
        &model.try_map(big).unwrap(),
        &samples,
        &cell(end),
        &big(dtau).unwrap(),
    )
    .unwrap()
}

fn widen(x: &Fixed) -> Option<Wide> {
    let (n, d) = x.parts()?;
    Some(Wide::new((*n).into(), (*d).into()))
}

#[test]
fn a_count_that_stays_may_not_have_moved() {
    // σ is short, so that the criterion fails at every small speed; but nothing may have moved.
    let model = Model::plain(Friction::new(Fixed::new(1, 4), Fixed::new(1, 4)));
    let cell = Cell::count(Fixed::integer(3));
    let row = entry(
        &model,
        std::slice::from_ref(&cell),
        &cell,
        &Fixed::integer(1),
    )
    .unwrap();
    assert_eq!(row.criterion_holds, Truth::Depends);
    let exact = at(3, 1);
    let row = entry(
        &model,
        std::slice::from_ref(&exact),
        &exact,
        &Fixed::integer(1),
    )
    .unwrap();
    assert_eq!((row.margin, row.criterion_holds), (None, Truth::Holds));
    assert_eq!(row.violates_linear, Truth::Fails);
}

#[test]
fn big_numbers_overflow_the_fixed_width_and_say_so() {
    let model = Model::plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
    let far = Cell::of(&Fixed::new(i128::MAX / 3, 7));
    let near = Cell::of(&Fixed::integer(0));
    assert!(entry(&model, &[near], &far, &Fixed::integer(1)).is_none());
}
