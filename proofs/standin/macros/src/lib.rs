//! The attributes of the stand-in for the `kani` API: `proof`, `solver`, `unwind`, `should_panic`.
//!
//! `#[kani::proof]` keeps the function and adds a test beside it, which hands the function to
//! `passivity_standin::check` together with what its text promises: its covers, its assertions
//! and whether it must fail. Works on token trees alone, so it needs no parser of Rust.

use proc_macro::{Delimiter, Group, TokenStream, TokenTree};

/// Attributes of a harness that are read here and mean nothing to `rustc`.
const OPTIONS: [&str; 3] = ["solver", "unwind", "should_panic"];

/// A harness: the function stays, and a test that explores it is added.
#[proc_macro_attribute]
pub fn proof(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut kept = Vec::new();
    let mut name = None;
    let mut must_fail = false;
    let mut texts = Texts::default();
    let mut tokens = item.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match (&token, tokens.peek()) {
            (TokenTree::Punct(hash), Some(TokenTree::Group(group)))
                if hash.as_char() == '#' && option(group).is_some() =>
            {
                must_fail |= option(group).as_deref() == Some("should_panic");
                tokens.next();
                continue;
            }
            (TokenTree::Ident(word), Some(TokenTree::Ident(ident)))
                if name.is_none() && word.to_string() == "fn" =>
            {
                name = Some(ident.to_string());
            }
            (TokenTree::Group(body), _) if body.delimiter() == Delimiter::Brace => {
                texts.read(body.stream());
            }
            _ => {}
        }
        kept.push(token);
    }
    let Some(name) = name else {
        return error("`#[kani::proof]` belongs on a function");
    };
    let test = format!(
        "#[cfg(test)] mod {name} {{ \
             #[test] fn stand_in() {{ \
                 ::passivity_standin::check(&::passivity_standin::Harness {{ \
                     manifest_dir: env!(\"CARGO_MANIFEST_DIR\"), \
                     path: module_path!(), \
                     must_fail: {must_fail}, \
                     covers: &[{}], \
                     assertions: &[{}], \
                 }}, super::{name}); \
             }} \
         }}",
        texts.covers.join(", "),
        texts.assertions.join(", "),
    );
    let mut out = parse("#[cfg_attr(not(test), allow(dead_code))]");
    out.extend(kept);
    out.extend(parse(&test));
    out
}

/// The solver that a model checker is advised to use; read by [`macro@proof`].
#[proc_macro_attribute]
pub fn solver(_arguments: TokenStream, _item: TokenStream) -> TokenStream {
    misplaced()
}

/// The bound on loops that a model checker unwinds; read by [`macro@proof`].
#[proc_macro_attribute]
pub fn unwind(_arguments: TokenStream, _item: TokenStream) -> TokenStream {
    misplaced()
}

/// The harness must fail; read by [`macro@proof`].
#[proc_macro_attribute]
pub fn should_panic(_arguments: TokenStream, _item: TokenStream) -> TokenStream {
    misplaced()
}

fn misplaced() -> TokenStream {
    error("write `#[kani::proof]` first, and the other attributes below it")
}

fn error(message: &str) -> TokenStream {
    parse(&format!("compile_error!({message:?});"))
}

fn parse(text: &str) -> TokenStream {
    // The text is this file's own and the names of items that `rustc` has read already.
    text.parse().unwrap_or_default()
}

/// The last name of `[kani::name]` or `[kani::name(…)]` when it is one of ours.
fn option(attribute: &Group) -> Option<String> {
    let mut path = Vec::new();
    for token in attribute.stream() {
        match token {
            TokenTree::Ident(ident) => path.push(ident.to_string()),
            TokenTree::Punct(colon) if colon.as_char() == ':' => {}
            _ => break,
        }
    }
    match path.as_slice() {
        [kani, name] if kani == "kani" && OPTIONS.contains(&name.as_str()) => Some(name.clone()),
        _ => None,
    }
}

/// The messages of a harness's `kani::cover!` and `kani::assert`, as literals.
#[derive(Default)]
struct Texts {
    covers: Vec<String>,
    assertions: Vec<String>,
}

impl Texts {
    fn read(&mut self, body: TokenStream) {
        let mut word = String::new();
        for token in body {
            match &token {
                TokenTree::Ident(ident) => word = ident.to_string(),
                TokenTree::Group(group) => {
                    let message = group.stream().into_iter().filter_map(literal).last();
                    match (word.as_str(), message) {
                        ("cover", Some(message)) => self.covers.push(message),
                        ("assert", Some(message)) => self.assertions.push(message),
                        _ => self.read(group.stream()),
                    }
                    word.clear();
                }
                _ => {}
            }
        }
    }
}

fn literal(token: TokenTree) -> Option<String> {
    match token {
        TokenTree::Literal(literal) => Some(literal.to_string()).filter(|l| l.starts_with('"')),
        _ => None,
    }
}
