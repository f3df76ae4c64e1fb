//! Models of the errata, read as exact rationals and run on the kernel.

use num_bigint::BigInt;
use passivity_core::{BigRational, Scalar as _};

use crate::Query;

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

/// Runs the kernel on a model: the premises must hold and the goal must not.
///
/// # Errors
///
/// A sentence that says what of it is not so.
pub fn refutes(query: &Query, model: &[(String, BigRational)]) -> Result<(), String> {
    let value = |name: &str| {
        let found = model.iter().find(|(n, _)| n == name);
        // A variable that the solver left out may be anything.
        found.map_or_else(BigRational::zero, |(_, value)| value.clone())
    };
    for premise in &query.premises {
        if premise.holds(&value) != Some(true) {
            return Err(format!(
                "{}: a premise does not hold of the model",
                query.name()
            ));
        }
    }
    match query.goal.holds(&value) {
        Some(false) => Ok(()),
        _ => Err(format!("{}: the goal holds of the model", query.name())),
    }
}
