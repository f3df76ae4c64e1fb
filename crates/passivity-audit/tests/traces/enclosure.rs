//! The enclosure of a counted interval holds every row of the kernel that the counts allow, and no
//! more; exact rows are the kernel's.

use passivity_audit::number::Written;
use passivity_audit::{Ends, Entry, Figure, Recorded, entry};
use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{BigRational, Fixed, Friction, Interval, Loop, Scalar, Step, Truth, Wide};
use passivity_random::draws;
use proptest::prelude::*;

/// Residues are multiples of 1/GRID, the upper end of a tick left out.
const GRID: i128 = 16;

fn friction() -> impl Strategy<Value = Friction<Fixed>> {
    (0..40_i128, 0..40_i128).prop_map(|(b, s)| Friction::new(Fixed::new(b, 20), Fixed::new(s, 20)))
}

/// A loop with any of the effects that shape its force, and friction between two ends.
fn ends() -> impl Strategy<Value = Ends<Fixed>> {
    let law = (any::<bool>(), prop::option::of(1..9_i128));
    let effects = (
        0..3_u16,
        prop::option::of(0..5_i128),
        prop::option::of(1..4_i128),
    );
    (friction(), friction(), law, effects).prop_map(|(a, b, law, (delay, damping, step))| {
        let point = |x: Fixed| Interval::point(x);
        let bounds = Loop {
            viscous: Some(Interval::hull(a.beta, b.beta)),
            coulomb: Some(Interval::hull(a.sigma, b.sigma)),
            resolution: Some(point(Fixed::integer(1))),
            damping: damping.map(|b| point(Fixed::new(b, 4))),
            force_step: step.map(|s| point(Fixed::new(s, 3))),
            max_force: law.1.map(|c| point(Fixed::new(c, 3))),
            delay,
            unilateral: law.0,
            ..Loop::new(point(Fixed::integer(1)), point(Fixed::integer(1)))
        };
        Ends::of(&bounds).unwrap()
    })
}

fn plain(friction: Friction<Fixed>) -> Ends<Fixed> {
    Ends::exact(Loop::plain(friction))
}

fn at(tick: i32, residue: i128) -> Figure<Fixed> {
    Figure::Exact(Fixed::integer(tick) + Fixed::new(residue, GRID))
}

fn count(tick: i32) -> Figure<Fixed> {
    Figure::between(Fixed::integer(tick), Fixed::integer(tick + 1)).unwrap()
}

/// A force that no controller of ours commands, exactly or between two ends.
fn force() -> impl Strategy<Value = Option<Figure<Fixed>>> {
    prop::option::of((-40..40_i128, 0..3_i128).prop_map(|(f, width)| {
        let (lo, hi) = (Fixed::new(f, 4), Fixed::new(f + width, 4));
        match width {
            0 => Figure::Exact(lo),
            _ => Figure::between(lo, hi).unwrap(),
        }
    }))
}

/// Over checked machine integers, or over big ones where those overflow.
fn row(
    ends: &Ends<Fixed>,
    samples: &[Figure<Fixed>],
    dtau: &Fixed,
    force: Option<&Figure<Fixed>>,
) -> Entry<BigRational> {
    let big = |x: &Fixed| x.to_rational();
    let samples: Vec<_> = samples.iter().map(|x| x.try_map(big).unwrap()).collect();
    let force = force.map(|force| force.try_map(big).unwrap());
    let recorded = Recorded {
        samples: &samples[1..],
        end: &samples[0],
        dtau: &big(dtau).unwrap(),
        force: force.as_ref(),
    };
    entry(&ends.try_map(big).unwrap(), &recorded).unwrap()
}

fn holds(outer: &Figure<BigRational>, inner: &Figure<BigRational>) -> bool {
    outer.lo() <= inner.lo() && inner.hi() <= outer.hi()
}

fn agrees(outer: Truth, inner: Truth) -> bool {
    outer == Truth::Depends || outer == inner
}

fn encloses(outer: &Entry<BigRational>, inner: &Entry<BigRational>) -> Result<(), TestCaseError> {
    for ((name, outer), (_, inner)) in outer.figures().into_iter().zip(inner.figures()) {
        let within = match (outer, inner) {
            (Some(outer), Some(inner)) => holds(outer, inner),
            (outer, inner) => outer.is_none() && inner.is_none(),
        };
        prop_assert!(within, "{name}: {outer:?} does not hold {inner:?}");
    }
    prop_assert!(holds(&outer.account.margin, &inner.account.margin));
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

/// The kernel's row of exact positions, with the friction and the force given.
fn of_kernel(
    of: &Loop<BigRational>,
    row: &Entry<BigRational>,
    force: &BigRational,
) -> ledger::Row<BigRational> {
    let held = HeldInterval {
        step: Step::new(row.xi0.lo().clone(), row.xi1.lo().clone()),
        force: force.clone(),
        dtau: row.dtau.clone(),
        extra_storage: row.extra_storage.as_ref().map(|gain| gain.lo().clone()),
    };
    ledger::row(of, &held)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(500)))]

    #[test]
    fn holds_every_row_of_the_kernel_that_the_counts_allow(
        ends in ends(),
        ticks in prop::collection::vec((-6..7_i32, 0..GRID), 2..6),
        known in prop::collection::vec(prop::bool::weighted(0.2), 6),
        force in force(),
        quarter_periods in 1..12_i128,
        (friction, strength) in (0..5_i128, 0..5_i128),
    ) {
        let dtau = Fixed::new(quarter_periods, 4);
        let exact: Vec<_> = ticks.iter().map(|t| at(t.0, t.1)).collect();
        // Some of the positions may be known exactly.
        let counted: Vec<_> = ticks
            .iter()
            .zip(&known)
            .map(|(t, known)| if *known { at(t.0, t.1) } else { count(t.0) })
            .collect();
        let outer = row(&ends, &counted, &dtau, force.as_ref());
        let inner = row(&ends, &exact, &dtau, force.as_ref());
        encloses(&outer, &inner)?;
        // With any friction and force in between, the kernel's own row of these positions.
        let between = |lo: &BigRational, hi: &BigRational, n: i128| {
            lo + (hi - lo) * BigRational::new(n.into(), 4.into())
        };
        let [least, most] = [&ends.least, &ends.most]
            .map(|of| of.try_map(|_, x| x.to_rational()).unwrap());
        let mut of = least.clone();
        of.viscous = Some(between(&least.viscous_friction(), &most.viscous_friction(), friction));
        of.coulomb = Some(between(&least.coulomb_friction(), &most.coulomb_friction(), friction));
        let force = between(inner.held.lo(), inner.held.hi(), strength);
        let found = of_kernel(&of, &inner, &force);
        for (name, outer, found) in [
            ("generated_linear", &outer.account.generated_linear, &found.generated_linear),
            ("generated_quantized", &outer.account.generated_quantized, &found.generated_quantized),
            ("bound_22", &outer.account.bound_22, &found.bound_22),
            ("bound_quantized", &outer.account.bound_quantized, &found.bound_quantized),
            ("dissipated_lower", &outer.account.dissipated_lower, &found.dissipated_lower),
            ("net_linear", &outer.account.net_linear, &found.net_linear),
            ("net_quantized", &outer.account.net_quantized, &found.net_quantized),
            ("margin", &outer.account.margin, &found.margin),
        ] {
            let within = holds(outer, &Figure::Exact(found.clone()));
            prop_assert!(within, "{name}: {outer:?} does not hold {found}");
        }
    }

    /// A theorem, whatever the trace: where the criterion holds, the linear account is not short.
    #[test]
    fn criterion_implies_no_linear_violation(
        ends in ends(),
        ticks in prop::collection::vec((-6..7_i32, 0..GRID), 2..6),
        quarter_periods in 1..5_i128,
    ) {
        // Per interval it is not proved of saturation together with virtual damping.
        prop_assume!(ends.least.max_force.is_none() || ends.least.damping.is_none());
        let dtau = Fixed::new(quarter_periods, 4);
        let exact: Vec<_> = ticks.iter().map(|t| at(t.0, t.1)).collect();
        let row = row(&ends, &exact, &dtau, None);
        prop_assert!(row.criterion_holds != Truth::Holds || row.violates_linear == Truth::Fails,
            "{row:?}");
    }

    /// Under any force: the extremes are those of the kernel's row over the closed square.
    #[test]
    fn plain_enclosure_is_reached(
        friction in friction(),
        start in -6..7_i32,
        end in -6..7_i32,
        quarter_periods in 1..12_i128,
        force in prop::option::of(-28..28_i128),
    ) {
        let ends = plain(friction);
        let dtau = Fixed::new(quarter_periods, 4);
        let force = force.map(|f| Fixed::new(f, 2));
        let given = force.map(Figure::Exact);
        let outer = row(&ends, &[count(end), count(start)], &dtau, given.as_ref());
        let held = force.unwrap_or(-(Fixed::integer(start) + Fixed::new(1, 2)));
        // The closed square on a grid. The corners are on it; a vertex on an edge is at most half a
        // grid step away, so the parabola, of curvature at most 2(β/Δτ + ½) ≤ 17, is off by at most
        // ½·17·(1/32)² < 1/100 there.
        let slack = BigRational::new(1.into(), 100.into());
        let mut extremes = [(Fixed::integer(1_000_000), Fixed::integer(-1_000_000)); 5];
        for (w, u) in (0..=GRID).flat_map(|w| (0..=GRID).map(move |u| (w, u))) {
            let (from, to) = (at(start, w), at(end, u));
            let interval = HeldInterval {
                step: Step::new(*from.lo(), *to.lo()),
                force: held,
                dtau,
                extra_storage: None,
            };
            let found = ledger::row(&ends.least, &interval);
            let values = [
                found.generated_linear,
                found.generated_quantized,
                found.dissipated_lower,
                found.net_linear,
                found.net_quantized,
            ];
            for ((least, most), value) in extremes.iter_mut().zip(values) {
                *least = (*least).min(value);
                *most = (*most).max(value);
            }
        }
        let account = &outer.account;
        let figures = [
            &account.generated_linear,
            &account.generated_quantized,
            &account.dissipated_lower,
            &account.net_linear,
            &account.net_quantized,
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
        ends in ends(),
        ticks in prop::collection::vec((-6..7_i32, 0..GRID), 2..6),
        force in force(),
        counted: bool,
    ) {
        let figure = |t: &(i32, i128)| if counted { count(t.0) } else { at(t.0, t.1) };
        let narrow: Vec<_> = ticks.iter().map(figure).collect();
        let broad: Vec<_> = narrow.iter().map(|x| x.try_map(widen).unwrap()).collect();
        let wide_force = force.as_ref().map(|force| force.try_map(widen).unwrap());
        let one = Fixed::integer(1);
        let on_machine_integers = entry(&ends, &Recorded {
            samples: &narrow[1..],
            end: &narrow[0],
            dtau: &one,
            force: force.as_ref(),
        });
        prop_assume!(on_machine_integers.is_some());
        let on_big_integers = entry(&ends.try_map(widen).unwrap(), &Recorded {
            samples: &broad[1..],
            end: &broad[0],
            dtau: &Wide::integer(1),
            force: wide_force.as_ref(),
        });
        let (narrow, broad) = (on_machine_integers.unwrap(), on_big_integers.unwrap());
        let rational = |figure: Option<&Figure<Fixed>>| figure.map(|x| x.try_map(Written::to_rational));
        let wide = |figure: Option<&Figure<Wide>>| figure.map(|x| x.try_map(Written::to_rational));
        for ((name, a), (_, b)) in narrow.figures().into_iter().zip(broad.figures()) {
            prop_assert_eq!(rational(a), wide(b), "{}", name);
        }
        prop_assert_eq!(narrow.violates_linear, broad.violates_linear);
        prop_assert_eq!(narrow.criterion_holds, broad.criterion_holds);
    }
}

fn widen(x: &Fixed) -> Option<Wide> {
    let (n, d) = x.parts()?;
    Some(Wide::new((*n).into(), (*d).into()))
}

#[test]
fn a_count_that_stays_may_not_have_moved() {
    // σ is short, so that the criterion fails at every small speed; but nothing may have moved.
    let ends = plain(Friction::new(Fixed::new(1, 4), Fixed::new(1, 4)));
    let one = Fixed::integer(1);
    let counted = row(&ends, &[count(3), count(3)], &one, None);
    assert_eq!(counted.criterion_holds, Truth::Depends);
    let exact = row(&ends, &[at(3, 1), at(3, 1)], &one, None);
    assert_eq!((exact.margin, exact.criterion_holds), (None, Truth::Holds));
    assert_eq!(exact.violates_linear, Truth::Fails);
}

#[test]
fn big_numbers_overflow_the_fixed_width_and_say_so() {
    let ends = plain(Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
    let recorded = Recorded {
        samples: &[Figure::Exact(Fixed::integer(0))],
        end: &Figure::Exact(Fixed::new(i128::MAX / 3, 7)),
        dtau: &Fixed::integer(1),
        force: None,
    };
    assert!(entry(&ends, &recorded).is_none());
}
