//! Comparisons of terms, and what is made of them.

use std::cmp::Ordering;

use passivity_core::{Ordered, Scalar};
use passivity_terms::smt::Printer;
use passivity_terms::{Node, Term, paths};

/// A statement about real numbers without quantifiers.
#[derive(Clone, Debug)]
pub enum Formula {
    /// The first term is above the second.
    Above(Term, Term),
    /// The terms are equal.
    Equal(Term, Term),
    /// Every part holds.
    All(Vec<Formula>),
    /// Some part holds.
    Any(Vec<Formula>),
    /// The part does not hold.
    Not(Box<Formula>),
}

/// a > b.
#[must_use]
pub fn gt(a: &Term, b: &Term) -> Formula {
    Formula::Above(a.clone(), b.clone())
}

/// a < b.
#[must_use]
pub fn lt(a: &Term, b: &Term) -> Formula {
    gt(b, a)
}

/// a ≤ b.
#[must_use]
pub fn le(a: &Term, b: &Term) -> Formula {
    not(gt(a, b))
}

/// a ≥ b.
#[must_use]
pub fn ge(a: &Term, b: &Term) -> Formula {
    le(b, a)
}

/// a = b.
#[must_use]
pub fn eq(a: &Term, b: &Term) -> Formula {
    Formula::Equal(a.clone(), b.clone())
}

/// a > 0.
#[must_use]
pub fn positive(a: &Term) -> Formula {
    gt(a, &Term::zero())
}

/// a ≥ 0.
#[must_use]
pub fn nonnegative(a: &Term) -> Formula {
    ge(a, &Term::zero())
}

/// Not f.
#[must_use]
pub fn not(f: Formula) -> Formula {
    Formula::Not(Box::new(f))
}

/// All of the formulas.
#[must_use]
pub fn all<const N: usize>(parts: [Formula; N]) -> Formula {
    Formula::All(parts.into())
}

/// Any of the formulas.
#[must_use]
pub fn any<const N: usize>(parts: [Formula; N]) -> Formula {
    Formula::Any(parts.into())
}

/// f implies g.
#[must_use]
pub fn implies(f: Formula, g: Formula) -> Formula {
    any([not(f), g])
}

/// f exactly when g.
#[must_use]
pub fn iff(f: Formula, g: Formula) -> Formula {
    all([implies(f.clone(), g.clone()), implies(g, f)])
}

/// The conditions under which a function takes a path.
#[must_use]
pub fn taken<T>(path: &paths::Path<T>) -> Formula {
    let condition = |sign: &paths::Sign| match sign.sign {
        Ordering::Less => lt(&sign.term, &Term::zero()),
        Ordering::Equal => eq(&sign.term, &Term::zero()),
        Ordering::Greater => gt(&sign.term, &Term::zero()),
    };
    Formula::All(path.signs.iter().map(condition).collect())
}

/// On every path through a function, what its result implies.
#[must_use]
pub fn on_every_path<T>(paths: &[paths::Path<T>], says: impl Fn(&T) -> Formula) -> Formula {
    let part = |path: &paths::Path<T>| implies(taken(path), says(&path.result));
    Formula::All(paths.iter().map(part).collect())
}

impl Formula {
    /// The formula in SMT-LIB.
    pub fn print(&self, printer: &mut Printer) -> String {
        let mut list = |name: &str, parts: &[Self], none: &str| match parts {
            [] => none.to_owned(),
            [one] => one.print(printer),
            _ => {
                let parts: Vec<_> = parts.iter().map(|f| f.print(printer)).collect();
                format!("({name} {})", parts.join(" "))
            }
        };
        match self {
            Self::All(parts) => list("and", parts, "true"),
            Self::Any(parts) => list("or", parts, "false"),
            Self::Above(a, b) => format!("(> {} {})", printer.print(a), printer.print(b)),
            Self::Equal(a, b) => format!("(= {} {})", printer.print(a), printer.print(b)),
            Self::Not(f) => match &**f {
                Self::Above(a, b) => format!("(<= {} {})", printer.print(a), printer.print(b)),
                f => format!("(not {})", f.print(printer)),
            },
        }
    }

    /// Whether the formula holds of numbers; `None` when that depends on one that is undefined.
    pub fn holds<S: Ordered>(&self, of: &dyn Fn(&str) -> S) -> Option<bool> {
        let compare = |a: &Term, b: &Term| a.evaluate(of).compare(&b.evaluate(of));
        match self {
            Self::Above(a, b) => Some(compare(a, b)? == Ordering::Greater),
            Self::Equal(a, b) => Some(compare(a, b)? == Ordering::Equal),
            Self::Not(f) => Some(!f.holds(of)?),
            Self::All(parts) => decided_by(false, parts, of),
            Self::Any(parts) => decided_by(true, parts, of),
        }
    }

    /// Whether no two variables are multiplied and nothing is divided by one.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        match self {
            Self::Above(a, b) | Self::Equal(a, b) => linear(a) && linear(b),
            Self::Not(f) => f.is_linear(),
            Self::All(parts) | Self::Any(parts) => parts.iter().all(Self::is_linear),
        }
    }

    /// The names of the variables, in the order of their first use.
    pub fn variables(&self, names: &mut Vec<String>) {
        match self {
            Self::Above(a, b) | Self::Equal(a, b) => {
                of_term(a, names);
                of_term(b, names);
            }
            Self::Not(f) => f.variables(names),
            Self::All(parts) | Self::Any(parts) => parts.iter().for_each(|f| f.variables(names)),
        }
    }
}

/// `truth` when a part has it, its opposite when all parts have that.
fn decided_by<S: Ordered>(truth: bool, parts: &[Formula], of: &dyn Fn(&str) -> S) -> Option<bool> {
    let truths: Vec<Option<bool>> = parts.iter().map(|f| f.holds(of)).collect();
    if truths.contains(&Some(truth)) {
        return Some(truth);
    }
    (!truths.contains(&None)).then_some(!truth)
}

fn linear(term: &Term) -> bool {
    let constant = |term: &Term| {
        let mut names = Vec::new();
        of_term(term, &mut names);
        names.is_empty()
    };
    let here = match term.node() {
        Node::Mul(a, b) => constant(a) || constant(b),
        Node::Over(_, b) => constant(b),
        _ => true,
    };
    here && term.children().into_iter().all(linear)
}

fn of_term(term: &Term, names: &mut Vec<String>) {
    if let Node::Variable(name) = term.node()
        && !names.contains(name)
    {
        names.push(name.clone());
    }
    for child in term.children() {
        of_term(child, names);
    }
}
