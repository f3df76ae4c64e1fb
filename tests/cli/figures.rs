//! The pictures of the documentation, `docs/figures`, are what the commands of `make figures` draw.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use crate::harness::{Dir, root};

/// The commands by which the Makefile draws every picture, as one types them.
fn commands() -> Vec<String> {
    let makefile = std::fs::read_to_string(root().join("Makefile")).expect("the Makefile");
    let (_, recipe) = makefile.split_once("\nfigures:").expect("its target");
    let (recipe, _) = recipe.split_once("\n\n").expect("its end");
    let recipe = recipe
        .replace("\\\n", " ")
        .replace("$(SCENE)", "scenes/re35.toml");
    let commands = recipe
        .lines()
        .filter_map(|line| line.strip_prefix("\t@$(BIN) "));
    commands.map(str::to_owned).collect()
}

#[cfg(unix)]
#[test]
fn the_figures_of_the_documentation_are_what_the_program_draws() {
    let dir = Dir::new();
    let mut stale = Vec::new();
    let mut drawn = BTreeSet::new();
    for command in commands() {
        let (_, picture) = command.rsplit_once("target/figures/").expect("a picture");
        let folder = dir.path("").display().to_string();
        let script = command.replace("target/figures", &folder);
        let run = Command::new("sh")
            .args([
                "-c",
                &format!("\"$0\" {script}"),
                env!("CARGO_BIN_EXE_passivity"),
            ])
            .current_dir(root())
            .output()
            .expect("a shell");
        // 1 is that a claim does not hold.
        let errors = String::from_utf8_lossy(&run.stderr);
        assert!(
            run.status.code().is_some_and(|code| code < 2),
            "{command}: {errors}"
        );
        let read = |folder: &Path| std::fs::read(folder.join(picture)).expect(picture);
        let (there, new) = (read(&root().join("docs/figures")), read(&dir.path("")));
        // Times differ from run to run, and with them the whole of that picture.
        let is_same = match picture {
            "accuracy.svg" => new.starts_with(b"<svg"),
            _ => there == new,
        };
        if !is_same {
            stale.push(picture.to_owned());
        }
        drawn.insert(picture.to_owned());
    }
    let there = std::fs::read_dir(root().join("docs/figures")).expect("the figures");
    let there = there.map(|entry| entry.expect("an entry").file_name());
    let there: BTreeSet<String> = there.filter_map(|name| name.into_string().ok()).collect();
    assert_eq!(drawn, there, "`make figures` draws every figure");
    assert!(
        stale.is_empty(),
        "{stale:?}: the program draws another picture: run `make figures`, look at it in target/figures and copy it to docs/figures"
    );
}
