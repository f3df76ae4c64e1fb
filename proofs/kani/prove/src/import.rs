//! A report of Kani that was made elsewhere, turned into evidence about the sources of a commit.

use std::path::{Path, PathBuf};

use passivity_collect::imported::{self, Imported, LIST};
use passivity_evidence::{Sha256, Tool};
use passivity_standin::list::{self, List};

use crate::judge;
use crate::report::{self, Run};
use crate::sources::Sources;
use crate::{Stop, USAGE};

/// What was asked for.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Arguments {
    pub(crate) report: PathBuf,
    pub(crate) commit: String,
    /// Said by hand where the report does not say it.
    pub(crate) cbmc: Option<String>,
    pub(crate) solver: Option<String>,
}

impl Arguments {
    /// The arguments of the command line.
    pub(crate) fn read(words: &[String]) -> Result<Self, Stop> {
        let mut arguments = Self::default();
        for pair in words.chunks(2) {
            let [name, value] = pair else {
                return Err(usage(&format!("`{}` lacks its value", pair[0])));
            };
            if value.is_empty() {
                return Err(usage(&format!("`{name}` lacks its value")));
            }
            match name.as_str() {
                "--report" => arguments.report = value.into(),
                "--commit" => arguments.commit.clone_from(value),
                "--cbmc" => arguments.cbmc = Some(value.clone()),
                "--solver" => arguments.solver = Some(value.clone()),
                _ => return Err(usage(&format!("`{name}` is not known"))),
            }
        }
        if arguments.report.as_os_str().is_empty() || arguments.commit.is_empty() {
            return Err(usage("a report needs the commit that it speaks of"));
        }
        Ok(arguments)
    }
}

fn usage(what: &str) -> Stop {
    format!("{what}\n{USAGE}").into()
}

/// Judges a report by the list of harnesses of its commit, and records it when all is proved.
pub(crate) fn take(root: &Path, arguments: &Arguments) -> Result<(), Stop> {
    let path = arguments.report.display();
    let text = std::fs::read(&arguments.report).map_err(|e| format!("{path}: {e}"))?;
    let text = String::from_utf8(text).map_err(|_| format!("{path}: it is not text"))?;
    let run = report::read(&text).map_err(|why| format!("{path}: {why}"))?;
    let sources = Sources::of(root, &arguments.commit)?;
    if let Some(said) = run.commit.as_ref().filter(|said| **said != sources.commit) {
        let why = format!(
            "{path}: it speaks of commit {said}, not of {}",
            sources.commit
        );
        return Err(why.into());
    }
    let list = list::parse(&sources.read(LIST)?)
        .map_err(|why| format!("`{LIST}` of that commit: {why}"))?;
    let wrong = judge::wrong(&list, &run);
    if !wrong.is_empty() {
        return Err(format!("{path} shows nothing:\n{}", wrong.join("\n")).into());
    }
    let imported = bound(
        root,
        &run,
        arguments,
        &list,
        &sources,
        Sha256::of(text.as_bytes()),
    )?;
    imported.write(root)?;
    println!(
        "{} harnesses proved by {} ({}), in {:.0} s; the slowest, {}, took {:.0} s",
        imported.harnesses.len(),
        imported.words(),
        imported.below.join(", "),
        imported.harnesses.iter().map(|h| h.seconds).sum::<f64>(),
        imported.slowest().map_or("none", |h| &h.name),
        imported.slowest().map_or(0.0, |h| h.seconds),
    );
    println!("recorded in {}", imported::FILE);
    Ok(())
}

/// What the report shows, bound to the sources of its commit.
fn bound(
    root: &Path,
    run: &Run,
    arguments: &Arguments,
    list: &List,
    sources: &Sources,
    report_sha256: Sha256,
) -> Result<Imported, Stop> {
    let version = run
        .kani
        .as_ref()
        .ok_or_else(|| "the report does not say which Kani made it".to_owned())?;
    let cbmc = said(run.cbmc.iter(), arguments.cbmc.as_ref(), "CBMC")?;
    let solver = said(run.solvers.iter(), arguments.solver.as_ref(), "SOLVER")?;
    let harness = |entry: &list::Entry| {
        let seconds = run
            .harnesses
            .get(&entry.name)
            .and_then(|report| report.seconds);
        Ok(imported::Harness {
            name: entry.name.clone(),
            claims: entry.claims.clone(),
            domain: entry.domain.clone(),
            seconds: seconds.ok_or_else(|| format!("{}: there is no time of it", entry.name))?,
        })
    };
    let harnesses: Vec<_> = list
        .harness
        .iter()
        .map(harness)
        .collect::<Result<_, String>>()?;
    let (claims, files) = imported::bind(root, &sources.commit, &harnesses)?;
    Ok(Imported {
        tool: Tool {
            name: "Kani".into(),
            version: Some(version.clone()),
        },
        below: vec![format!("CBMC {cbmc}"), solver],
        commit: sources.commit.clone(),
        report_sha256,
        claims,
        harnesses,
        files,
    })
}

/// What the report says of a tool, or what was said by hand; where both speak they must agree.
fn said<'a>(
    in_report: impl Iterator<Item = &'a String>,
    by_hand: Option<&String>,
    name: &str,
) -> Result<String, String> {
    let in_report: Vec<&str> = in_report.map(String::as_str).collect();
    match (in_report.as_slice(), by_hand) {
        ([], None) => Err(format!(
            "the report does not say which {name} worked: add {name}=…"
        )),
        ([], Some(said)) => Ok(said.clone()),
        (found, Some(said)) if found.join(" and ") != *said => Err(format!(
            "{name}={said}, but the report says {}",
            found.join(" and ")
        )),
        (found, _) => Ok(found.join(" and ")),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::process::Command;

    use std::collections::BTreeMap;

    use passivity_collect::imported::HARNESSES;
    use passivity_collect::tools;
    use passivity_evidence::{
        Claims, Engine, Evidence, FORMAT, Freshness, Run as EngineRun, RunOutcome, assess, in_tree,
    };

    use super::*;

    const REPORT: &str = include_str!("../samples/terse-two-threads.txt");

    const CLAIM: &str = r#"
        assumption = []
        caveat = []
        [[claim]]
        id = "TH-LIN"
        sentence = "One."
        formula = ""
        equation = "(1)"
        code = ["generation::bound_22"]
        evidence = ["kani"]
        scope = { kani = "a part" }
        assumptions = []
        caveats = []
    "#;

    /// A repository of one commit, whose harnesses are those of [`REPORT`].
    struct Repository(PathBuf);

    impl Repository {
        fn new(name: &str) -> Self {
            let name = format!("passivity-import-{name}-{}", std::process::id());
            let here = Self(std::env::temp_dir().join(name));
            let entry = |name: &str, covers: &str, must_fail: &str| {
                format!(
                    "[[harness]]\nname = \"{name}\"\nclaims = [\"TH-LIN\"]\ndomain = \"few\"\n\
                     covers = {covers}\n{must_fail}\n"
                )
            };
            let must_fail = "must_fail = \"ERR-22: E_g is within the printed bound (22)\"";
            let list = [
                entry("generation::th_lin_bound", "[\"left\", \"entered\"]", ""),
                entry("errata::err_22", "[\"down\"]", must_fail),
                entry("generation::th_quant_bound", "[\"crossing\"]", ""),
            ];
            here.write(LIST, &list.concat());
            here.write(Claims::PATH, CLAIM);
            here.write(
                "crates/passivity-core/src/generation.rs",
                "fn bound_22() {}",
            );
            for file in ["generation", "errata", "domain", "lib"] {
                let text = format!("use crate::domain;\n// {file}");
                here.write(&format!("{HARNESSES}/{file}.rs"), &text);
            }
            for other in [
                "crates/passivity-identify",
                "crates/passivity-monitor",
                "crates/passivity-scene",
                "proofs/terms",
                "proofs/smt",
            ] {
                here.write(&format!("{other}/src/lib.rs"), "");
            }
            here.write("crates/passivity-core/tests/properties/main.rs", "");
            for crate_folder in ["crates/passivity-core", "proofs/kani"] {
                here.write(&format!("{crate_folder}/Cargo.toml"), "[package]");
            }
            here.write("Cargo.toml", "[workspace]");
            here.write("Cargo.lock", "version = 4");
            here.git(&["init", "-q"]);
            here.git(&["add", "-A"]);
            let (name, mail) = ("user.name=Somebody", "user.email=somebody@example.org");
            here.git(&["-c", name, "-c", mail, "commit", "-q", "-m", "All there is"]);
            here
        }

        fn git(&self, arguments: &[&str]) {
            let status = Command::new("git")
                .arg("-C")
                .arg(&self.0)
                .args(arguments)
                .status();
            assert!(status.expect("git runs").success(), "{arguments:?}");
        }

        fn write(&self, path: &str, text: &str) {
            let path = self.0.join(path);
            fs::create_dir_all(path.parent().expect("a folder")).expect("folders can be made");
            fs::write(path, text).expect("files can be written");
        }

        /// Takes a report of the commit, with the versions said by hand.
        fn take(&self, report: &str) -> Result<(), String> {
            self.write("target/report.txt", report);
            let arguments = Arguments {
                report: self.0.join("target/report.txt"),
                commit: "HEAD".into(),
                cbmc: Some("6.6.0".into()),
                solver: Some("MiniSat".into()),
            };
            take(&self.0, &arguments).map_err(|stop| stop.message)
        }

        fn imported(&self) -> Option<Imported> {
            Imported::read(&self.0).expect("what was written can be read")
        }

        /// The recorded evidence after the import, read again, and what has changed since.
        fn evidence(&self) -> (Evidence, Vec<String>) {
            let claims = Claims::read(&self.0).expect("claims");
            let mut evidence = Evidence {
                format: FORMAT,
                runs: vec![EngineRun {
                    engine: Engine::Kani,
                    tools: Vec::new(),
                    commit: None,
                    outcome: RunOutcome::NotRun("not here".into()),
                    files: BTreeMap::new(),
                }],
                records: Vec::new(),
                mutation: None,
            };
            let imported = self.imported().expect("a record");
            imported
                .put_into(&self.0, &claims, &mut evidence)
                .expect("sources");
            let text = evidence.to_text().expect("a text");
            let evidence = Evidence::parse("evidence", &text).expect("no contradiction");
            let now = |path: &str| in_tree(&self.0, path);
            let assessed = assess(&claims, &evidence, now).expect("sources");
            let [of_claim] = assessed.as_slice() else {
                panic!("{assessed:?}");
            };
            let changed = match &of_claim.freshness {
                Freshness::Fresh => Vec::new(),
                Freshness::Stale(changes) => changes.iter().map(ToString::to_string).collect(),
                other => panic!("{other}"),
            };
            (evidence, changed)
        }

        /// What has changed since the import.
        fn changed(&self) -> Vec<String> {
            self.evidence().1
        }
    }

    impl Drop for Repository {
        fn drop(&mut self) {
            fs::remove_dir_all(&self.0).expect("it can be removed");
        }
    }

    #[test]
    fn a_report_is_bound_to_the_sources_of_its_commit() {
        let here = Repository::new("bound");
        // What is in the tree does not matter, only what is at the commit.
        here.write("crates/passivity-core/src/generation.rs", "changed");
        here.write(LIST, "changed");
        here.take(REPORT).expect("all is proved");
        let (evidence, changed) = here.evidence();
        let commit = here.imported().expect("a record").commit;
        let run = evidence.run(Engine::Kani).expect("a run");
        let words = format!("Kani 0.68.0, at commit {}", &commit[..12]);
        assert_eq!(tools(run), words);
        let record = evidence.find("TH-LIN", Engine::Kani).expect("a record");
        assert_eq!(record.outcome.words(), "proved for all inputs in 3 domains");
        assert_eq!(record.scope.as_deref(), Some("a part"));
        assert_eq!(
            run.files["crates/passivity-core/src/generation.rs"],
            Sha256::of(b"fn bound_22() {}")
        );
        let claims = Claims::read(&here.0).expect("claims");
        let table = passivity_collect::table(&claims, &evidence, |path| in_tree(&here.0, path))
            .expect("sources");
        let cell = "**stale**, changed since: crates/passivity-core/src/generation.rs, proofs/kani/harnesses.toml; it was \
                    proved for all inputs in 3 domains for *a part* (3 harnesses";
        assert!(table.contains(&format!("{cell}; {words})")), "{table}");
        assert_eq!(changed, ["crates/passivity-core/src/generation.rs", LIST]);
    }

    #[test]
    fn a_record_is_stale_when_its_claim_its_code_or_its_harnesses_change() {
        let here = Repository::new("stale");
        here.take(REPORT).expect("all is proved");
        assert_eq!(here.changed(), Vec::<String>::new());
        here.write(&format!("{HARNESSES}/domain.rs"), "// a wider domain");
        assert_eq!(here.changed(), ["proofs/kani/src/domain.rs"]);
        here.write(
            &format!("{HARNESSES}/domain.rs"),
            "use crate::domain;\n// domain",
        );
        here.write("Cargo.lock", "version = 5");
        assert_eq!(here.changed(), ["Cargo.lock"]);
        here.write("Cargo.lock", "version = 4");
        here.write(Claims::PATH, &CLAIM.replace("One.", "Two."));
        assert_eq!(here.changed(), ["claim text"]);
    }

    #[test]
    fn a_report_that_does_not_show_everything_is_refused() {
        let here = Repository::new("refused");
        let refused = |report: &str, why: &str| {
            let message = here.take(report).expect_err("it is refused");
            assert!(message.contains(why), "{message}");
            assert_eq!(here.imported(), None);
        };
        refused(
            &REPORT.replace("th_quant_bound", "th_other_bound"),
            "generation::th_quant_bound: it is not in the report\n\
             generation::th_other_bound: it is not in harnesses.toml",
        );
        refused(
            &REPORT.replace(
                "VERIFICATION:- SUCCESSFUL\nVerification Time: 12.61s",
                "VERIFICATION:- FAILED",
            ),
            "generation::th_quant_bound: the verdict is `FAILED`",
        );
        refused(
            &REPORT.replace("Failed Checks: ERR-22", "Failed Checks: ERR-27"),
            "errata::err_22: the checks that failed are",
        );
        refused(
            &REPORT.replace("2 of 2 cover", "1 of 2 cover"),
            "generation::th_lin_bound: 1 of 2 covers are satisfied",
        );
        refused(
            &REPORT.replace("Verification Time: 12.61s", ""),
            "generation::th_quant_bound: there is no time of it",
        );
        let other = format!("Commit: 0123, with changes\n{REPORT}");
        refused(&other, "it speaks of commit 0123, with changes, not of ");
    }

    #[test]
    fn the_commit_and_the_versions_must_be_known() {
        let here = Repository::new("unknown");
        here.write("target/report.txt", REPORT);
        let mut arguments = Arguments {
            report: here.0.join("target/report.txt"),
            commit: "0123456".into(),
            ..Arguments::default()
        };
        let stop = take(&here.0, &arguments).expect_err("there is no such commit");
        assert_eq!(stop.message, "`0123456` is no commit of this repository");
        arguments.commit = "HEAD".into();
        let stop = take(&here.0, &arguments).expect_err("nobody says the version of CBMC");
        assert_eq!(
            stop.message,
            "the report does not say which CBMC worked: add CBMC=…"
        );
        let words = ["--report", "file"].map(String::from);
        let stop = Arguments::read(&words).expect_err("the commit is missing");
        assert!(stop.message.starts_with("a report needs the commit"));
    }

    #[test]
    fn what_is_said_by_hand_agrees_with_the_report() {
        let found = ["6.8.0".to_string()];
        let (same, other) = ("6.8.0".to_string(), "6.6.0".to_string());
        assert_eq!(said(found.iter(), None, "CBMC"), Ok(same.clone()));
        assert_eq!(said(found.iter(), Some(&same), "CBMC"), Ok(same));
        assert!(said(found.iter(), Some(&other), "CBMC").is_err());
    }
}
