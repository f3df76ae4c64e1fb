//! A report for people.

use passivity_core::{BigRational, Effect, Interval, Parameter, Region, Truth};

use super::decide::Verdict;
use super::figures::NOT_COMPARED;
use super::limits::{Limit, Side};
use super::lines::{Lines, headline, limits_heading};
use super::report::Report;
use crate::display::{Rounding, approx, range, rounded, wrapped};
use crate::scene::Motion;
use crate::written::Form;

impl Report {
    /// The report as text, a screen for a scene.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut lines = Lines::default();
        let mut line = |label: &str, value: &str| lines.add(label, value);
        line("region", self.region_text());
        line("β = b/(KT)", &range(&self.beta));
        match &self.sigma {
            Some(sigma) => line("σ = c/(KΔ)", &range(sigma)),
            None => line("σ", "none: the position is not quantized"),
        }
        if let Some(mu) = &self.mu {
            line("μ = m/(KT²)", &range(mu));
        }
        let cost = &self.cost;
        line(
            "cost of the effects",
            &format!("β: {}, σ: {}", range(&cost.viscous), range(&cost.coulomb)),
        );
        let spare = &self.spare;
        line(
            "to spare at every speed",
            &format!("β: {}, σ: {}", range(&spare.viscous), range(&spare.coulomb)),
        );
        if let Some(margin) = &self.margin_at_speed_bound {
            line(
                &format!("margin (8) at {}", self.speed_bound_text()),
                &range(margin),
            );
        }
        if let Some(text) = self.critical_speed_text() {
            line("critical speed", &text);
        }
        line("what binds", &self.binds_text());
        self.add_stiffest(&mut lines);
        for (name, truth) in [
            ("Colgate, b ≥ KT/2", self.colgate),
            ("Abbott and Okamura", self.abbott_okamura),
        ] {
            lines.add(name, &comparison(truth, &self.effects));
        }
        lines.add_grounds(&self.effects, &self.because, &self.remarks);
        if let Some(text) = self.unforced_text() {
            lines.add("with the hand off", &text);
        }
        let mut text = format!("{}: {}\n{}", self.scene, self.headline(), lines.0);
        if let Some(witness) = self.witness_text() {
            text += &format!("  {}\n", wrapped(&format!("Witness: {witness}"), 2));
        }
        text.push_str(&self.limits_text());
        text.push_str(&self.advice_text());
        text
    }

    /// The verdict in one line.
    #[must_use]
    pub fn headline(&self) -> String {
        let speeds = self.speeds_text();
        headline(self.verdict, &speeds, &self.decided_by, &self.not_covered)
    }

    /// The speeds that the headline and the limits speak of.
    #[must_use]
    pub fn speeds_text(&self) -> String {
        if self.at_every_speed || self.speed_bound.is_none() {
            "at every speed".to_owned()
        } else {
            format!("at every speed up to {}", self.speed_bound_text())
        }
    }

    const fn region_text(&self) -> &'static str {
        match self.region {
            None => "depends on the tolerances",
            Some(Region::GloballyStable) => "globally stable: the criterion holds at every speed",
            Some(Region::LocallyStable) => {
                "locally stable: the criterion holds up to the critical speed"
            }
            Some(Region::LimitCycles) => {
                "limit cycles: the criterion fails below the critical speed"
            }
            Some(Region::Unstable) => "unstable: the criterion holds at no speed",
        }
    }

    /// The bound on the speed, in the unit of the scene.
    #[must_use]
    pub fn speed_bound_text(&self) -> String {
        match (&self.speed_bound_si, &self.speed_bound) {
            (Some(v), _) => self.speed_written.text(v, speed_unit(self.motion)),
            (None, Some(v)) => format!("{} ticks/sample", range(v)),
            (None, None) => "every speed".to_owned(),
        }
    }

    /// The critical speed, on the side of it on which the criterion holds over all tolerances.
    #[must_use]
    pub fn critical_speed_text(&self) -> Option<String> {
        let ticks = self.critical_ticks_text()?;
        Some(match &self.critical_speed_si {
            Some(v) => {
                let ((v, side), unit) = (self.safe_end(v), speed_unit(self.motion));
                let speed = self.speed_written.rounded_text(v, side, unit);
                format!("{speed} ({ticks})")
            }
            None => ticks,
        })
    }

    /// The critical speed in ticks per sample, or in the unit of length without an encoder.
    #[must_use]
    pub fn critical_ticks_text(&self) -> Option<String> {
        let (ticks, side) = self.safe_end(self.critical_speed.as_ref()?);
        let unit = self.length_unit();
        Some(format!("{} {unit}/sample", rounded(ticks, 5, side)))
    }

    /// The unit of positions in figures without units: the tick, and without an encoder that of SI.
    pub(crate) const fn length_unit(&self) -> &'static str {
        match (&self.sigma, self.motion) {
            (Some(_), _) => "ticks",
            (None, Motion::Linear) => "m",
            (None, _) => "rad",
        }
    }

    /// The end of a critical speed from which the criterion holds over all tolerances, and the side
    /// of it on which it does.
    const fn safe_end<'a>(&self, v: &'a Interval<BigRational>) -> (&'a BigRational, Rounding) {
        match self.region {
            Some(Region::LimitCycles) => (v.hi(), Rounding::Up),
            _ => (v.lo(), Rounding::Down),
        }
    }

    fn add_stiffest(&self, lines: &mut Lines) {
        let up_to = format!("up to {}", self.speed_bound_text());
        let walls = [
            (&self.max_stiffness_all_speeds, "at every speed"),
            (&self.max_stiffness_at_speed_bound, up_to.as_str()),
        ];
        let unit = unit_of(Parameter::Stiffness, self.motion);
        lines.add_stiffest(walls, &self.stiffness_written, unit);
    }

    fn unforced_text(&self) -> Option<String> {
        let unforced = self.unforced.as_ref()?;
        let v = |x: &Interval<BigRational>| rounded(x.hi(), 5, Rounding::Up);
        let speed = match &unforced.speed_si {
            Some(si) => {
                let unit = speed_unit(self.motion);
                self.speed_written.rounded_text(si.hi(), Rounding::Up, unit)
            }
            None => format!("{} ticks/sample", v(&unforced.speed)),
        };
        Some(match unforced.holds {
            Truth::Holds => {
                let assumed = unforced.assumes.map(|assumes| format!(", if {assumes}"));
                let assumed = assumed.unwrap_or_default();
                format!("from the start on never faster than {speed} (TH-START){assumed}")
            }
            Truth::Fails => {
                format!("not shown: the criterion fails at the speed of the start, {speed}")
            }
            Truth::Depends => "not shown".to_owned(),
        })
    }

    /// How to move so that the display gives energy, and how much it gives at least each time round; `None` where
    /// the report has no witness.
    #[must_use]
    pub fn witness_text(&self) -> Option<String> {
        let witness = self.witness.as_ref()?;
        let unit = self.length_unit();
        let least = |x: &BigRational| rounded(x, 5, Rounding::Down);
        let energy = match (&witness.gain_per_cycle_joules, &self.sigma) {
            (Some(joules), Some(_)) => {
                let gain = least(&witness.gain_per_cycle);
                format!("{} J ({gain} KΔ²)", least(joules))
            }
            (Some(joules), None) => format!("{} J", least(joules)),
            (None, _) => format!("{} KΔ²", least(&witness.gain_per_cycle)),
        };
        let way = match (&witness.wave, witness.positions.as_slice()) {
            (Some(wave), _) => format!(
                "repeat {} samples, steps of {}·cos(2π·{}·h/{}) ticks at sample h, positions \
                 rounded to whole ticks",
                wave.period, wave.amplitude, wave.turns, wave.period
            ),
            (None, [from, to]) => format!(
                "move from {} to {} {unit} and back, each way at constant speed within one \
                 sampling interval",
                short(from),
                short(to)
            ),
            (None, positions) => format!(
                "move through {} {unit}, one a sampling interval at constant speed, and round again",
                listed(positions)
            ),
        };
        Some(format!(
            "{way}. Each time round draws at least {energy}, if friction is no more than the scene allows."
        ))
    }

    fn limits_text(&self) -> String {
        // What is not covered is not mended by a parameter.
        if self.limits.is_empty() || self.verdict == Verdict::NotCovered {
            return String::new();
        }
        let mut out = limits_heading(self.verdict, &self.speeds_text());
        let lines = self.limits.iter().map(|limit| limit.line("", self.motion));
        out.extend(lines);
        out
    }
}

impl Limit {
    /// The parameter in words and with its letter.
    #[must_use]
    pub fn name(&self, motion: Motion) -> String {
        let row = self.parameter.row();
        match self.written.form() {
            Form::Value => {}
            Form::Reciprocal => return format!("sampling rate 1/{}", row.symbol),
            Form::Cutoff => return "cutoff of the filter on the damping, 1/(2πτ)".to_owned(),
            Form::Count => return "counts per revolution of the encoder, 2π/Δ".to_owned(),
        }
        if motion != Motion::Dimensionless {
            return format!("{} {}", row.name, row.symbol);
        }
        match row.dimensionless_symbol {
            Some(symbol) => format!("effective {} {symbol}", row.name),
            None => format!("{}, as a factor of what it is", row.name),
        }
    }

    /// What the parameter is now, with its unit: with more digits than usual where it would read like what it
    /// has to be and is not that.
    #[must_use]
    pub fn now(&self, motion: Motion) -> String {
        /// The figures of a report are enclosed to 200 bits: about 60 digits.
        const MOST_DIGITS: u32 = 50;
        let si_unit = unit_of(self.parameter, motion);
        let promise = self.promise(motion);
        let reads_like_it = |now: &String| {
            let number = promise.strip_prefix("at least ");
            number.or(promise.strip_prefix("at most ")) == Some(now.as_str())
        };
        let with = |digits| self.written.text_with(&self.now, si_unit, digits);
        let usual = self.written.text(&self.now, si_unit);
        let usual = usual.trim_end().to_owned();
        if !reads_like_it(&usual) {
            return usual;
        }
        let mut more = (6..=MOST_DIGITS).map(|digits| with(digits).trim_end().to_owned());
        more.find(|now| !reads_like_it(now)).unwrap_or(usual)
    }

    /// What the parameter has to be, rounded to the safe side, with its unit: `at most 1.07 N/m`, or
    /// `from 0.36 to 0.51 N s/m`.
    #[must_use]
    pub fn promise(&self, motion: Motion) -> String {
        let inverse = self.written.form() != Form::Value;
        let text =
            |side, border, typed, printed| self.end_text(side, border, typed, printed, motion);
        let near = text(self.side, &self.border, &self.typed, &self.printed);
        let is_least = (self.side == Side::AtLeast) != inverse;
        let Some(far) = &self.far else {
            let relation = if is_least { "at least" } else { "at most" };
            return format!("{relation} {near}");
        };
        let far = text(self.side.other(), &far.border, &far.typed, &far.printed);
        let (from, to) = if is_least { (near, far) } else { (far, near) };
        let unit = to.trim_start_matches(|c| c != ' ');
        format!("from {} to {to}", from.strip_suffix(unit).unwrap_or(&from))
    }

    /// An end of the values that pass, rounded to the safe side, with its unit.
    fn end_text(
        &self,
        side: Side,
        border: &Interval<BigRational>,
        typed: &Option<String>,
        printed: &Option<String>,
        motion: Motion,
    ) -> String {
        let si_unit = unit_of(self.parameter, motion);
        let text = match (typed, printed) {
            (Some(typed), _) => format!("{typed}{}", self.written.unit()),
            (None, Some(printed)) if self.written.form() == Form::Value => {
                format!("{printed} {si_unit}")
            }
            _ => {
                let hardest = side.hardest(border);
                self.written.rounded_text(hardest, side.rounding(), si_unit)
            }
        };
        text.trim_end().to_owned()
    }
}

/// What a condition that is only for comparison says, in words; where it does not apply, because of which of the scene's effects.
#[must_use]
pub fn comparison(truth: Option<Truth>, effects: &[Effect]) -> String {
    truth.map_or_else(
        || {
            let mut effects = effects.to_vec();
            effects.retain(|effect| NOT_COMPARED.contains(effect));
            format!("does not apply: {}", words(&effects))
        },
        |truth| truth.name().to_owned(),
    )
}

pub(crate) fn words(effects: &[Effect]) -> String {
    let words: Vec<&str> = effects.iter().map(|effect| effect.words()).collect();
    words.join("; ")
}

/// Positions as a list; of a long one the beginning, with how many there are.
fn listed(positions: &[BigRational]) -> String {
    const SHOWN: usize = 24;
    let first: Vec<String> = positions.iter().take(SHOWN).map(short).collect();
    let more = positions.len().saturating_sub(SHOWN);
    let rest = match more {
        0 => String::new(),
        _ => format!(", … ({} positions)", positions.len()),
    };
    format!("{}{rest}", first.join(", "))
}

/// A rational as it is when that is short enough to read, else rounded.
pub(crate) fn short(x: &BigRational) -> String {
    let exact = x.to_string();
    if exact.len() <= 40 {
        exact
    } else {
        format!("about {}", approx(x))
    }
}

/// A parameter's SI unit, as a scene file may write it; empty for a dimensionless scene.
///
/// # Example
///
/// ```
/// use passivity_core::Parameter;
/// use passivity_scene::{Motion, check::unit_of};
///
/// assert_eq!(unit_of(Parameter::Inertia, Motion::Rotary), "kg m^2");
/// ```
#[must_use]
pub fn unit_of(parameter: Parameter, motion: Motion) -> &'static str {
    use passivity_core::parameter::Unit;
    let [linear, rotary] = match parameter.row().unit {
        Unit::INERTIA => ["kg", "kg m^2"],
        Unit::VISCOUS => ["N s/m", "N m s/rad"],
        Unit::FORCE => ["N", "N m"],
        Unit::TIME => ["s", "s"],
        Unit::POSITION => ["m", "rad"],
        Unit::SPEED => ["m/s", "rad/s"],
        _ => ["N/m", "N m/rad"],
    };
    match motion {
        Motion::Linear => linear,
        Motion::Rotary => rotary,
        Motion::Dimensionless => "",
    }
}

/// The key under which a scene of that motion has a parameter itself, and not in another form or at the motor.
///
/// # Example
///
/// ```
/// use passivity_core::Parameter;
/// use passivity_scene::{Motion, check::key_of};
///
/// assert_eq!(key_of(Parameter::Inertia, Motion::Linear), "device.mass");
/// assert_eq!(key_of(Parameter::Viscous, Motion::Dimensionless), "dimensionless.beta");
/// ```
#[must_use]
pub fn key_of(parameter: Parameter, motion: Motion) -> &'static str {
    let row = parameter.row();
    match (motion, row.dimensionless_key) {
        (Motion::Dimensionless, Some(key)) => key,
        (Motion::Linear, _) if parameter == Parameter::Inertia => "device.mass",
        _ => row.key,
    }
}

/// The unit of speed of a motion.
#[must_use]
pub(crate) const fn speed_unit(motion: Motion) -> &'static str {
    match motion {
        Motion::Linear => "m/s",
        Motion::Rotary => "rad/s",
        Motion::Dimensionless => "ticks/sample",
    }
}
