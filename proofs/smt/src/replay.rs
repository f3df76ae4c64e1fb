//! Models that solvers give, read as exact rationals and run on the kernel.

use num_bigint::BigInt;
use passivity_core::rational::to_wide;
use passivity_core::{BigRational, Scalar as _, Wide};

use crate::Script;

/// A number as solvers print it: `3`, `0.5`, `3.0`, `(/ 1 2)`, `(- (/ 1 2))`, `(/ (- 1) 2)`.
///
/// # Errors
///
/// The text, when it is none of these.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar};
///
/// let half = BigRational::integer(1).half();
/// assert_eq!(passivity_smt::replay::number("(- (/ 1.0 2.0))"), Ok(-half));
/// ```
pub fn number(text: &str) -> Result<BigRational, String> {
    let spaced = text.replace('(', " ( ").replace(')', " ) ");
    let tokens: Vec<&str> = spaced.split_whitespace().collect();
    let mut rest = tokens.as_slice();
    match (expression(&mut rest), rest) {
        (Some(value), []) => Ok(value),
        _ => Err(format!("`{text}` is not a rational number")),
    }
}

fn expression(tokens: &mut &[&str]) -> Option<BigRational> {
    let (&first, rest) = tokens.split_first()?;
    *tokens = rest;
    if first != "(" {
        return decimal(first);
    }
    let (&operator, rest) = tokens.split_first()?;
    *tokens = rest;
    let x = expression(tokens)?;
    let value = match operator {
        "-" => -x,
        "/" => {
            let y = expression(tokens)?;
            if y == BigRational::zero() {
                return None;
            }
            x / y
        }
        _ => return None,
    };
    let (&close, rest) = tokens.split_first()?;
    *tokens = rest;
    (close == ")").then_some(value)
}

fn decimal(text: &str) -> Option<BigRational> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
    let places = u32::try_from(fraction.len()).ok()?;
    Some(BigRational::new(digits, BigInt::from(10).pow(places)))
}

/// Runs the kernel on a model: everything that the script asserts must hold of it.
///
/// # Errors
///
/// A sentence that says what of it is not so.
pub fn confirms(script: &Script, model: &[(String, BigRational)]) -> Result<(), String> {
    let name = &script.name;
    for variable in &script.variables {
        if !model.iter().any(|(other, _)| other == variable) {
            return Err(format!("{name}: the model has no value of {variable}"));
        }
    }
    let value = |name: &str| {
        let found = model.iter().find(|(other, _)| other == name);
        found.map_or(Wide::new(1.into(), 0.into()), |(_, value)| to_wide(value))
    };
    for (assertion, place) in script.assertions.iter().zip(1..) {
        match assertion.holds(&value) {
            Some(true) => {}
            Some(false) => return Err(format!("{name}: assertion {place} is false of the model")),
            None => {
                return Err(format!(
                    "{name}: assertion {place} is undefined for the model"
                ));
            }
        }
    }
    Ok(())
}
