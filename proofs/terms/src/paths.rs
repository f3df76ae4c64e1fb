//! Code that branches on signs, run once for each way the signs can fall.

use std::cell::RefCell;
use std::cmp::Ordering;

use passivity_core::{Ordered, Scalar as _, Wide};

use crate::{Node, Term};

/// What was assumed at a branch: how a term compares with zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sign {
    /// The term.
    pub term: Term,
    /// How it compares with zero on this path.
    pub sign: Ordering,
}

/// One way through a function.
#[derive(Clone, Debug)]
pub struct Path<T> {
    /// What was assumed on the way.
    pub signs: Vec<Sign>,
    /// What the function gave.
    pub result: T,
}

const ALL: [Ordering; 3] = [Ordering::Less, Ordering::Equal, Ordering::Greater];

/// The choices of the run under way: those fixed beforehand, then the first of each.
struct Run {
    script: Vec<usize>,
    taken: Vec<(Sign, usize)>,
}

thread_local! {
    static RUN: RefCell<Option<Run>> = const { RefCell::new(None) };
}

/// Every path through `function`, which branches on nothing but signs of terms.
///
/// A sign that was asked for before on the same path is not asked twice, and that of a number
/// without variables not at all. Paths that no numbers can take are listed too: their conditions
/// contradict each other.
///
/// # Example
///
/// ```
/// use passivity_core::{Criterion, Region};
/// use passivity_terms::{Term, paths};
///
/// let criterion = Criterion { viscous: Term::variable("v"), coulomb: Term::variable("c") };
/// let all = paths::of(|| Region::of(&criterion));
/// assert_eq!(all.len(), 9);
/// ```
pub fn of<T>(function: impl Fn() -> T) -> Vec<Path<T>> {
    let mut script = Vec::new();
    let mut paths = Vec::new();
    loop {
        RUN.set(Some(Run {
            script: script.clone(),
            taken: Vec::new(),
        }));
        let result = function();
        let taken = RUN.take().map_or(Vec::new(), |run| run.taken);
        script = taken.iter().map(|(_, choice)| *choice).collect();
        let signs = taken.into_iter().map(|(sign, _)| sign).collect();
        paths.push(Path { signs, result });
        // The next path: the last choice that is not exhausted takes its next value.
        while let Some(last) = script.pop() {
            if last + 1 < ALL.len() {
                script.push(last + 1);
                break;
            }
        }
        if script.is_empty() {
            return paths;
        }
    }
}

impl Ordered for Term {
    /// # Panics
    ///
    /// Outside of [`of`]: a term has no sign of its own.
    fn sign(&self) -> Option<Ordering> {
        if is_number(self) {
            return self.evaluate(&|_| Wide::zero()).sign();
        }
        RUN.with_borrow_mut(|run| {
            let run = run.as_mut().unwrap_or_else(|| {
                panic!("the sign of a term was asked for outside of `paths::of`: {self:?}")
            });
            if let Some((known, _)) = run.taken.iter().find(|(sign, _)| sign.term == *self) {
                return Some(known.sign);
            }
            let choice = run.script.get(run.taken.len()).copied().unwrap_or(0);
            let sign = ALL[choice];
            let term = self.clone();
            run.taken.push((Sign { term, sign }, choice));
            Some(sign)
        })
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        (self.clone() - other.clone()).sign()
    }
}

/// Whether a term has no variables.
fn is_number(term: &Term) -> bool {
    !matches!(term.node(), Node::Variable(_)) && term.children().into_iter().all(is_number)
}

impl Term {
    /// How the term compares with zero, as a condition.
    #[must_use]
    pub fn with_sign(self, sign: Ordering) -> Sign {
        Sign { term: self, sign }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_sign_is_asked_once_and_every_way_is_taken() {
        let x = Term::variable("x");
        let paths = of(|| match x.sign() {
            Some(Ordering::Greater) => (x.is_positive(), Term::variable("y").sign()),
            _ => (x.is_positive(), None),
        });
        // Less, Equal, and Greater with three signs of y.
        assert_eq!(paths.len(), 5);
        assert!(paths[0].result == (Some(false), None) && paths[0].signs.len() == 1);
        assert!(paths[4].result == (Some(true), Some(Ordering::Greater)));
        assert_eq!(
            paths[4].signs[1],
            Term::variable("y").with_sign(Ordering::Greater)
        );
    }

    #[test]
    fn numbers_have_the_sign_that_they_have() {
        let paths = of(|| {
            (
                Term::fraction(-1, 3).sign(),
                Term::zero().over(Term::one()).sign(),
            )
        });
        assert_eq!(paths.len(), 1);
        assert_eq!(
            paths[0].result,
            (Some(Ordering::Less), Some(Ordering::Equal))
        );
        assert_eq!(of(|| Term::fraction(1, 0).sign())[0].result, None);
    }

    #[test]
    fn a_function_without_branches_has_one_path() {
        let paths = of(|| Term::integer(1).half());
        assert_eq!(paths.len(), 1);
        assert!(paths[0].signs.is_empty());
    }
}
