//! Terms as text for SMT-LIB, over the reals.

use std::collections::HashMap;
use std::fmt::Write as _;

use crate::{Node, Term};

/// Prints terms, and gathers what their text refers to.
///
/// A magnitude, maximum or minimum becomes an `ite`; ⌊x⌋ becomes a variable n with n ≤ x < n + 1,
/// which says all that the real numbers know of it. Whether n is also whole is for the query to
/// say ([`Printer::floors`]): most claims hold without. Whatever is used twice gets a name.
///
/// # Example
///
/// ```
/// use passivity_core::{Scalar, quantizer::held_force};
/// use passivity_terms::{Term, smt::Printer};
///
/// let mut printer = Printer::default();
/// let text = printer.print(&held_force(&Term::variable("x")));
/// assert_eq!(text, "(- (+ floor1 (/ 1 2)))");
/// assert_eq!(
///     printer.preamble(),
///     "(declare-const floor1 Real) ; floor of x\n(assert (and (<= floor1 x) (< x (+ floor1 1))))\n"
/// );
/// ```
#[derive(Clone, Debug, Default)]
pub struct Printer {
    preamble: String,
    names: HashMap<Term, String>,
    floors: Vec<(Term, String)>,
    whole: bool,
}

impl Printer {
    /// A printer whose floors are declared as whole numbers.
    #[must_use]
    pub fn with_whole_floors() -> Self {
        Self {
            whole: true,
            ..Self::default()
        }
    }

    /// Declarations and constraints that the printed text needs, in order.
    #[must_use]
    pub fn preamble(&self) -> &str {
        &self.preamble
    }

    /// The arguments of ⌊·⌋ so far and the variables that stand for their floors.
    #[must_use]
    pub fn floors(&self) -> &[(Term, String)] {
        &self.floors
    }

    /// The text of a term.
    pub fn print(&mut self, term: &Term) -> String {
        if let Some(name) = self.names.get(term) {
            return name.clone();
        }
        match term.node() {
            Node::Variable(name) => name.clone(),
            Node::Integer(n) if *n < 0 => format!("(- {}{})", i64::from(*n).abs(), self.point()),
            Node::Integer(n) => format!("{n}{}", self.point()),
            Node::Add(x, y) => self.apply("+", x, y),
            Node::Sub(x, y) => self.apply("-", x, y),
            Node::Mul(x, y) => self.apply("*", x, y),
            Node::Over(x, y) => self.apply("/", x, y),
            Node::Neg(x) => format!("(- {})", self.print(x)),
            Node::Half(x) => format!("(/ {} 2)", self.print(x)),
            Node::Floor(x) => self.floor(term, x),
            Node::Abs(x) => {
                let x = self.named(x);
                self.define(term, &format!("(ite (>= {x} 0) {x} (- {x}))"))
            }
            Node::Max(x, y) => self.choice(term, x, ">=", y),
            Node::Min(x, y) => self.choice(term, x, "<=", y),
        }
    }

    /// What makes a whole number a real one where there are integers too.
    const fn point(&self) -> &'static str {
        if self.whole { ".0" } else { "" }
    }

    fn apply(&mut self, operator: &str, x: &Term, y: &Term) -> String {
        let (x, y) = (self.print(x), self.print(y));
        format!("({operator} {x} {y})")
    }

    /// The first term where the comparison holds, else the second.
    fn choice(&mut self, term: &Term, x: &Term, compare: &str, y: &Term) -> String {
        let (x, y) = (self.named(x), self.named(y));
        self.define(term, &format!("(ite ({compare} {x} {y}) {x} {y})"))
    }

    /// A text that may be written several times.
    fn named(&mut self, term: &Term) -> String {
        let text = self.print(term);
        match term.node() {
            Node::Variable(_) | Node::Integer(_) => text,
            _ if self.names.contains_key(term) => text,
            _ => self.define(term, &text),
        }
    }

    fn define(&mut self, term: &Term, text: &str) -> String {
        let name = format!("def{}", self.names.len() + 1);
        let _ = writeln!(self.preamble, "(define-fun {name} () Real {text})");
        self.names.insert(term.clone(), name.clone());
        name
    }

    fn floor(&mut self, term: &Term, x: &Term) -> String {
        let x_text = self.named(x);
        let name = format!("floor{}", self.names.len() + 1);
        let (sort, value) = if self.whole {
            ("Int", format!("(to_real {name})"))
        } else {
            ("Real", name.clone())
        };
        let _ = writeln!(
            self.preamble,
            "(declare-const {name} {sort}) ; floor of {x_text}\n\
             (assert (and (<= {value} {x_text}) (< {x_text} (+ {value} 1))))"
        );
        self.names.insert(term.clone(), value.clone());
        self.floors.push((x.clone(), name));
        value
    }
}
