//! One formula of the kernel and the definition it must equal.

use passivity_terms::{Term, rocq};

/// A formula that the kernel computed on variables, and what Rocq is to prove of it.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The kernel's function, as a path in `passivity_core`.
    source: &'static str,
    name: String,
    variables: Vec<&'static str>,
    computed: Term,
    equals: String,
    given: Vec<&'static str>,
    proof: &'static str,
}

impl Formula {
    /// The kernel's `computed` equals the Rocq term `equals`, for all values of `variables`.
    ///
    /// The name in Rocq is the last part of `source`, unless [`named`](Self::named).
    #[must_use]
    pub fn new(
        source: &'static str,
        variables: &[&'static str],
        computed: Term,
        equals: impl Into<String>,
    ) -> Self {
        let name = source.rsplit("::").next().unwrap_or(source).to_owned();
        Self {
            source,
            name,
            variables: variables.to_vec(),
            computed,
            equals: equals.into(),
            given: Vec::new(),
            proof: "bridge",
        }
    }

    /// The same under another name, for a function that is run more than once.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    /// What must hold of the variables, as a Rocq proposition.
    #[must_use]
    pub fn given(mut self, premise: &'static str) -> Self {
        self.given.push(premise);
        self
    }

    /// The tactic that proves it, where the usual one does not.
    #[must_use]
    pub const fn by(mut self, proof: &'static str) -> Self {
        self.proof = proof;
        self
    }

    /// The name in Rocq, without its prefix.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The definition and its lemma.
    #[must_use]
    pub fn print(&self) -> String {
        let Self {
            source,
            name,
            equals,
            proof,
            ..
        } = self;
        let variables = self.variables.join(" ");
        let computed = rocq::print(&self.computed);
        let premises: String = self.given.iter().map(|p| format!("{p} -> ")).collect();
        format!(
            "(** [{source}] *)\n\
             Definition kernel_{name} ({variables} : R) : R :=\n  {computed}.\n\
             Lemma bridge_{name} : forall {variables},\n  {premises}\
             kernel_{name} {variables} = {equals}.\n\
             Proof. unfold kernel_{name}. {proof}. Qed.\n"
        )
    }
}
