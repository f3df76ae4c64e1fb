//! Terms as text for Rocq, over the reals.

use crate::{Node, Term};

/// The term in Rocq's `R_scope`, every operation in brackets.
///
/// `Rabs`, `Rmax` and `Rmin` are the standard library's; `floor : R -> R` is for the file that
/// imports the text to define.
///
/// # Example
///
/// ```
/// use passivity_core::{Scalar, quantizer::held_force};
/// use passivity_terms::{Term, rocq};
///
/// let force = held_force(&Term::variable("x"));
/// assert_eq!(rocq::print(&force), "(- ((floor x) + (1 / 2)))");
/// ```
#[must_use]
pub fn print(term: &Term) -> String {
    let infix = |x, sign, y| format!("({} {sign} {})", print(x), print(y));
    let prefix = |name, x| format!("({name} {})", print(x));
    match term.node() {
        Node::Variable(name) => name.clone(),
        Node::Integer(n) if *n < 0 => format!("({n})"),
        Node::Integer(n) => n.to_string(),
        Node::Add(x, y) => infix(x, "+", y),
        Node::Sub(x, y) => infix(x, "-", y),
        Node::Mul(x, y) => infix(x, "*", y),
        Node::Over(x, y) => infix(x, "/", y),
        Node::Neg(x) => prefix("-", x),
        Node::Half(x) => format!("({} / 2)", print(x)),
        Node::Floor(x) => prefix("floor", x),
        Node::Abs(x) => prefix("Rabs", x),
        Node::Max(x, y) => format!("(Rmax {} {})", print(x), print(y)),
        Node::Min(x, y) => format!("(Rmin {} {})", print(x), print(y)),
    }
}
