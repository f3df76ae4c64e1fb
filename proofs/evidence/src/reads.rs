//! Which of the workspace's own source files a Rust file rests on, found in their text.
//!
//! A file rests on the modules that its paths name, and on the files in which the methods that it
//! calls are written: a type of one file has methods in others. What calls what is judged by names
//! alone, so that a file too many may be found, and none too few.

use std::collections::{BTreeMap, BTreeSet};

use passivity_evidence::EvidenceError;

use crate::rust_text::{Implementation, implementations, spelled, tokens, uses};
use crate::sources::Sources;

/// The crates whose files are found: the name in paths, and the folder of the sources.
const CRATES: [(&str, &str); 8] = [
    ("passivity_core", "crates/passivity-core/src"),
    ("passivity_identify", "crates/passivity-identify/src"),
    ("passivity_monitor", "crates/passivity-monitor/src"),
    ("passivity_scene", "crates/passivity-scene/src"),
    ("passivity_terms", "proofs/terms/src"),
    ("passivity_smt", "proofs/smt/src"),
    ("passivity_kani", "proofs/kani/src"),
    ("properties", "crates/passivity-core/tests/properties"),
];

/// The texts of the crates that others are built on.
pub(crate) struct Reads {
    files: BTreeMap<String, File>,
    /// The files of modules, and of the names that `lib.rs` re-exports, by their paths.
    modules: BTreeMap<Vec<String>, BTreeSet<String>>,
}

/// What the text of a file says of others.
struct File {
    /// The module that it holds; none outside of the crates.
    module: Vec<String>,
    /// Paths from the root of a crate.
    paths: Vec<Vec<String>>,
    /// Those that it gives a name to for others: `pub use`.
    exports: Vec<Vec<String>>,
    /// Names after a point, and those after a type's name.
    methods: BTreeSet<String>,
    associated: BTreeSet<(String, String)>,
    words: BTreeSet<String>,
    types: BTreeSet<String>,
    implementations: Vec<Implementation>,
}

impl Reads {
    /// Reads the crates.
    ///
    /// # Errors
    ///
    /// A file that cannot be read.
    pub(crate) fn new(sources: &Sources) -> Result<Self, EvidenceError> {
        let mut reads = Self {
            files: BTreeMap::new(),
            modules: BTreeMap::new(),
        };
        for (name, folder) in CRATES {
            for path in sources.under(folder)? {
                let Some(module) = module_of(name, folder, &path) else {
                    continue;
                };
                let file = File::of(&sources.text(&path)?, &module, is_folder(&path));
                reads
                    .modules
                    .entry(module)
                    .or_default()
                    .insert(path.clone());
                reads.files.insert(path, file);
            }
        }
        reads.follow_exports();
        Ok(reads)
    }

    /// Names that a module re-exports stand for the modules that they come from, which may do the same.
    fn follow_exports(&mut self) {
        loop {
            let mut more = Vec::new();
            for (path, file) in &self.files {
                for export in &file.exports {
                    let mut found = self.resolve(export);
                    found.insert(path.clone());
                    let name = file.module.iter().chain(export.last()).cloned().collect();
                    more.push((name, found));
                }
            }
            let known = |(name, found): &(Vec<String>, BTreeSet<String>)| {
                self.modules
                    .get(name)
                    .is_some_and(|files| files.is_superset(found))
            };
            if more.iter().all(known) {
                return;
            }
            for (name, found) in more {
                self.modules.entry(name).or_default().extend(found);
            }
        }
    }

    /// The files of the longest module path that a path begins with.
    fn resolve(&self, path: &[String]) -> BTreeSet<String> {
        (1..=path.len())
            .rev()
            .find_map(|length| self.modules.get(path.get(..length)?))
            .cloned()
            .unwrap_or_default()
    }

    /// The files that `roots` rest on, themselves included; of files of other crates, those in
    /// `roots` only.
    ///
    /// # Errors
    ///
    /// A file that cannot be read.
    pub(crate) fn of(
        &self,
        sources: &Sources,
        roots: impl IntoIterator<Item = String>,
    ) -> Result<BTreeSet<String>, EvidenceError> {
        let roots: BTreeSet<String> = roots.into_iter().collect();
        let mut foreign = BTreeMap::new();
        for path in roots.iter().filter(|path| path.ends_with(".rs")) {
            if !self.files.contains_key(path) {
                foreign.insert(path.clone(), File::of(&sources.text(path)?, &[], false));
            }
        }
        let mut found = roots;
        loop {
            let known: Vec<&File> = found
                .iter()
                .filter_map(|path| self.files.get(path).or_else(|| foreign.get(path)))
                .collect();
            let named = known.iter().flat_map(|file| &file.paths);
            let mut more: BTreeSet<String> = named.flat_map(|path| self.resolve(path)).collect();
            // Nothing of a crate is called where no path leads into it.
            let entered: BTreeSet<&str> = CRATES
                .into_iter()
                .filter(|(name, folder)| {
                    let names = |path: &Vec<String>| path.first().is_some_and(|f| f == name);
                    known.iter().any(|file| file.paths.iter().any(names))
                        || found.iter().any(|path| path.starts_with(folder))
                })
                .map(|(_, folder)| folder)
                .collect();
            let unread = self.files.iter().filter(|(path, _)| {
                !found.contains(*path) && entered.iter().any(|folder| path.starts_with(folder))
            });
            let called = unread.filter(|(_, file)| self.is_called(file, &known));
            more.extend(called.map(|(path, _)| path.clone()));
            let before = found.len();
            found.extend(more);
            if found.len() == before {
                return Ok(found);
            }
        }
    }

    /// Whether known files call what a file implements for types that are known, too.
    fn is_called(&self, file: &File, known: &[&File]) -> bool {
        let declares = |name: &str| known.iter().any(|file| file.types.contains(name));
        let is_ours = |name: &str| self.files.values().any(|file| file.types.contains(name));
        file.implementations.iter().any(|block| {
            let type_is_known = declares(&block.name)
                || !is_ours(&block.name) && known.iter().any(|f| f.words.contains(&block.name));
            let called = |function: &String| {
                let path = |name: &str| (name.to_owned(), function.clone());
                known.iter().any(|file| {
                    file.methods.contains(function)
                        || file.associated.contains(&path(&block.name))
                        || file.associated.contains(&path("Self"))
                })
            };
            type_is_known
                && match &block.of {
                    None => block.functions.iter().any(called),
                    Some(of) => declares(of) || !is_ours(of),
                }
        })
    }
}

/// The path of the module that a file holds.
fn module_of(name: &str, folder: &str, path: &str) -> Option<Vec<String>> {
    let within = path.strip_prefix(folder)?.strip_prefix('/')?;
    let within = within.strip_suffix(".rs")?;
    let mut module = vec![name.to_owned()];
    module.extend(within.split('/').map(str::to_owned));
    // A program beside a library is a module that nothing names.
    if is_folder(path) {
        module.pop();
    }
    Some(module)
}

/// Whether the modules in the folder of a file are below that file's own.
fn is_folder(path: &str) -> bool {
    ["/lib.rs", "/mod.rs", "/properties/main.rs"]
        .iter()
        .any(|end| path.ends_with(end))
}

impl File {
    fn of(text: &str, module: &[String], is_folder: bool) -> Self {
        let tokens = tokens(text);
        let at = |index: usize| tokens.get(index).map_or("", String::as_str);
        let is_name = |word: &str| word.starts_with(|c: char| c.is_alphabetic() || c == '_');
        let declaring = ["struct", "enum", "trait", "type"];
        let mut file = Self {
            module: module.to_vec(),
            paths: Vec::new(),
            exports: Vec::new(),
            methods: BTreeSet::new(),
            associated: BTreeSet::new(),
            words: tokens
                .iter()
                .filter(|word| is_name(word))
                .cloned()
                .collect(),
            types: BTreeSet::new(),
            implementations: implementations(&tokens),
        };
        for index in 0..tokens.len() {
            let (here, next, after) = (at(index), at(index + 1), at(index + 2));
            if here == "." && is_name(next) {
                file.methods.insert(next.to_owned());
            } else if is_name(here) && next == "::" && is_name(after) {
                file.associated.insert((here.to_owned(), after.to_owned()));
            } else if here == ">" && next == "::" && is_name(after) {
                // `Loop::<Interval<_>>::decide`: whatever type it is.
                file.methods.insert(after.to_owned());
            } else if declaring.contains(&here) && is_name(next) {
                file.types.insert(next.to_owned());
            }
        }
        let parent = module.get(..module.len().saturating_sub(1)).unwrap_or(&[]);
        let from_the_root = |path: Vec<String>| {
            let (first, rest) = path.split_first()?;
            let from: &[String] = match first.as_str() {
                "crate" => module.get(..1).unwrap_or(&[]),
                "self" => module,
                "super" => parent,
                name if CRATES.iter().any(|(known, _)| *known == name) => return Some(path),
                _ if is_folder => return Some([module, &path].concat()),
                _ => return None,
            };
            Some([from, rest].concat())
        };
        let (exported, used): (Vec<_>, Vec<_>) =
            uses(&tokens).into_iter().partition(|(_, public)| *public);
        let exported = exported.into_iter().map(|(path, _)| path);
        file.exports = exported.filter_map(from_the_root).collect();
        let used = used.into_iter().map(|(path, _)| path);
        file.paths = used
            .chain(spelled(&tokens))
            .filter_map(from_the_root)
            .collect();
        file
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(roots: &[&str]) -> BTreeSet<String> {
        let sources = Sources::new(&crate::root(), None);
        let reads = Reads::new(&sources).unwrap();
        let roots = roots.iter().map(|root| (*root).to_owned());
        reads.of(&sources, roots).unwrap()
    }

    fn has(found: &BTreeSet<String>, names: &[&str]) -> Vec<bool> {
        let file = |name: &&str| format!("crates/passivity-core/src/{name}.rs");
        names
            .iter()
            .map(|name| found.contains(&file(name)))
            .collect()
    }

    #[test]
    fn a_file_rests_on_what_it_names_and_calls_and_on_nothing_else() {
        let found = of(&["crates/passivity-core/src/generation.rs"]);
        let names = ["generation", "quantizer", "scalar", "spring"];
        assert_eq!(has(&found, &names), [true; 4], "{found:?}");
        let others = ["pi", "verdict", "stiffness", "parameter", "witness"];
        assert_eq!(has(&found, &others), [false; 5], "{found:?}");
    }

    #[test]
    fn methods_of_a_type_are_found_where_they_are_written() {
        let found = of(&["crates/passivity-core/src/verdict.rs"]);
        let names = ["control_loop", "interval", "start", "region", "rational"];
        assert_eq!(has(&found, &names), [true; 5], "{found:?}");
        assert_eq!(has(&found, &["pi", "witness"]), [false; 2], "{found:?}");
    }

    #[test]
    fn another_crate_is_followed_into_the_kernel() {
        let found = of(&["crates/passivity-scene/src/check/decide.rs"]);
        assert!(
            found.contains("crates/passivity-scene/src/scene.rs"),
            "{found:?}"
        );
        assert_eq!(has(&found, &["verdict", "witness", "pi"]), [true; 3]);
    }
}
