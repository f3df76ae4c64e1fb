//! The tree of what was asked.

use std::ops::{Add, Mul, Neg, Sub};
use std::sync::Arc;

use passivity_core::{Fixed, Interval, Scalar};

/// A number that remembers how it is computed.
///
/// Two terms are equal when they are the same tree, not when they are equal as numbers.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, quantizer::held_force};
/// use passivity_terms::Term;
///
/// let force = held_force(&Term::variable("x"));
/// assert_eq!(force.evaluate(&|_| Fixed::new(5, 4)), Fixed::new(-3, 2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Term(Arc<Node>);

/// The top of a [`Term`].
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A variable, by name.
    Variable(String),
    /// A whole number.
    Integer(i32),
    /// A sum.
    Add(Term, Term),
    /// A difference.
    Sub(Term, Term),
    /// A product.
    Mul(Term, Term),
    /// A negation.
    Neg(Term),
    /// One half of a term.
    Half(Term),
    /// The largest integer not above a term.
    Floor(Term),
    /// A magnitude.
    Abs(Term),
    /// The larger of two terms.
    Max(Term, Term),
    /// The smaller of two terms.
    Min(Term, Term),
    /// A quotient.
    Over(Term, Term),
}

impl Term {
    fn of(node: Node) -> Self {
        Self(Arc::new(node))
    }

    /// The variable of that name.
    #[must_use]
    pub fn variable(name: &str) -> Self {
        Self::of(Node::Variable(name.to_owned()))
    }

    /// The fraction `n / d` as a quotient of two whole numbers.
    #[must_use]
    pub fn fraction(n: i32, d: i32) -> Self {
        Self::integer(n).over(Self::integer(d))
    }

    /// The interval between two variables, of which nothing is known but their order.
    #[must_use]
    pub fn interval(lo: &str, hi: &str) -> Interval<Self> {
        // No order is asked of terms: it is that of 0 and 1.
        let ends = Interval::hull(Fixed::integer(0), Fixed::integer(1));
        let name = |end: &Fixed| if *end == Fixed::integer(0) { lo } else { hi };
        ends.map(|end| Self::variable(name(end)))
    }

    /// The top of the tree.
    #[must_use]
    pub fn node(&self) -> &Node {
        &self.0
    }

    /// The terms directly below the top.
    #[must_use]
    pub fn children(&self) -> Vec<&Self> {
        match self.node() {
            Node::Variable(_) | Node::Integer(_) => vec![],
            Node::Neg(x) | Node::Half(x) | Node::Floor(x) | Node::Abs(x) => vec![x],
            Node::Add(x, y)
            | Node::Sub(x, y)
            | Node::Mul(x, y)
            | Node::Max(x, y)
            | Node::Min(x, y)
            | Node::Over(x, y) => vec![x, y],
        }
    }

    /// The value when each variable has the value that `of` gives it.
    pub fn evaluate<S: Scalar>(&self, of: &dyn Fn(&str) -> S) -> S {
        let at = |x: &Self| x.evaluate(of);
        match self.node() {
            Node::Variable(name) => of(name),
            Node::Integer(n) => S::integer(*n),
            Node::Add(x, y) => at(x) + at(y),
            Node::Sub(x, y) => at(x) - at(y),
            Node::Mul(x, y) => at(x) * at(y),
            Node::Neg(x) => -at(x),
            Node::Half(x) => at(x).half(),
            Node::Floor(x) => at(x).floor(),
            Node::Abs(x) => at(x).abs(),
            Node::Max(x, y) => at(x).max(at(y)),
            Node::Min(x, y) => at(x).min(at(y)),
            Node::Over(x, y) => at(x).over(at(y)),
        }
    }
}

impl Add for Term {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::of(Node::Add(self, other))
    }
}

impl Sub for Term {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::of(Node::Sub(self, other))
    }
}

impl Mul for Term {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::of(Node::Mul(self, other))
    }
}

impl Neg for Term {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of(Node::Neg(self))
    }
}

impl Scalar for Term {
    fn integer(n: i32) -> Self {
        Self::of(Node::Integer(n))
    }

    fn half(self) -> Self {
        Self::of(Node::Half(self))
    }

    fn floor(&self) -> Self {
        Self::of(Node::Floor(self.clone()))
    }

    fn abs(&self) -> Self {
        Self::of(Node::Abs(self.clone()))
    }

    fn max(self, other: Self) -> Self {
        Self::of(Node::Max(self, other))
    }

    fn min(self, other: Self) -> Self {
        Self::of(Node::Min(self, other))
    }

    fn over(self, divisor: Self) -> Self {
        Self::of(Node::Over(self, divisor))
    }
}
