//! The document of `passivity case`, read by a stranger.

use super::{GOOD, one_error, read};
use crate::harness::{Dir, root};

/// The document of a shipped scene, without its line breaks.
fn page(name: &str) -> String {
    let dir = Dir::new();
    let scene = root().join("scenes").join(name);
    let run = dir.run(&["case", scene.to_str().expect("UTF-8"), "--out", "case"]);
    assert!(run.code < 2, "{}", run.stderr);
    let page = read(&dir, "case/case.html");
    page.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What a reader meets before the annex is said before it: the paper, the letters, who made the evidence.
#[test]
fn the_paper_the_letters_and_the_engines_are_said() {
    let page = page("re35.toml");
    let (head, _) = page.split_once("Summary and verdict").expect("the summary");
    assert!(
        head.contains("A Criterion for the Passivity of Haptic Devices"),
        "{head}"
    );
    let (_, glossary) = page.split_once(">Glossary</h2>").expect("the glossary");
    let (glossary, _) = glossary.split_once("Annex: ").expect("the annex");
    let words = [
        "E_g",
        "E_d",
        "φ_V",
        "φ_H",
        "Δτ",
        "ξ_h",
        "ρ",
        "Numbers in round brackets",
        "Harnesses as tests",
        "Big rationals",
        "Kernel",
        "z3 and cvc5",
    ];
    for word in words {
        assert!(glossary.contains(word), "{word}: {glossary}");
    }
    assert!(
        page.contains("the kernel was changed on purpose in"),
        "{page}"
    );
}

/// The sentence of an open goal is what the goal would say: it is quoted as what is not shown.
#[test]
fn an_open_goal_is_told_as_what_is_not_shown() {
    let page = page("tolerance-straddling.toml");
    let (_, rest) = page.split_once("What is not shown").expect("a list");
    let (list, _) = rest.split_once("Contents").expect("the contents");
    let says = "G-criterion is open: it is not shown that «The criterion holds at every speed";
    assert!(list.contains(says), "{list}");
}

#[test]
fn the_people_and_the_date_are_those_that_were_given() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    let info = dir.write(
        "device.toml",
        "title = \"The wall of the trainer\"\nauthor = \"A. Person\"\ndate = 2026-03-31\n",
    );
    let run = dir.run(&["case", &scene, "--out", "case", "--info", &info]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let html = read(&dir, "case/case.html");
    for says in [
        "<h1>The wall of the trainer</h1>",
        "A. Person",
        "2026-03-31",
        "not given",
    ] {
        assert!(html.contains(says), "{says}");
    }
    assert!(read(&dir, "case/case.info.toml").contains("A. Person"));
    // What makes the case again makes this one.
    let again = format!(
        "passivity case {scene} --out case \\\n    --info {info}\npassivity case --check case"
    );
    assert!(html.contains(&again), "{again}");
    for (text, about) in [
        ("author = \"TODO\"\n", "`author` still has to be filled in"),
        ("approval = \" \"\n", "`approval` still has to be filled in"),
        ("date = \"today\"\n", "`date` must be a day"),
        ("athor = \"A. Person\"\n", "athor"),
    ] {
        let info = dir.write("device.toml", text);
        let run = dir.run(&["case", &scene, "--out", "other", "--info", &info]);
        one_error(&run, about);
        assert!(run.stderr.contains("device.toml"), "{}", run.stderr);
        assert!(!dir.path("other").exists());
    }
}
