//! Help, completions, man page, and mistakes in typing.

use crate::harness::Dir;

#[test]
fn help_shows_examples_and_exit_codes() {
    let dir = Dir::new();
    let help = dir.run(&["--help"]);
    assert_eq!(help.code, 0);
    assert!(help.stdout.contains("Examples:") && help.stdout.contains("Exit codes:"));
    let check = dir.run(&["check", "--help"]);
    assert!(check.stdout.contains("passivity check scenes/re35.toml"));
}

#[test]
fn completions_and_man_page_come_from_the_same_table() {
    let dir = Dir::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let run = dir.run(&["completions", shell]);
        assert_eq!(run.code, 0);
        assert!(
            run.stdout.contains("check") && run.stdout.contains("plane"),
            "{shell}"
        );
    }
    let man = dir.run(&["man"]);
    assert!(man.stdout.contains(".TH passivity") && man.stdout.contains("check"));
    let verb = dir.run(&["man", "check"]);
    assert!(verb.stdout.contains("SCENE"), "{}", verb.stdout);
}

#[test]
fn mistakes_in_typing_exit_with_2() {
    let dir = Dir::new();
    for args in [
        &["chek"][..],
        &["check"],
        &["check", "--format", "xml", "a.toml"],
        &["man", "chek"],
        &[],
    ] {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}");
        assert!(!run.stderr.is_empty() && run.stdout.is_empty(), "{args:?}");
    }
}
