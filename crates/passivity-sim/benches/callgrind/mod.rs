//! Instructions of this very program, counted by callgrind: for benches that run themselves under valgrind.

use std::io::ErrorKind;
use std::process::Command;

/// Runs this program under callgrind with its own `arguments`, callgrind having `flags`: the instructions that it
/// took, and what it printed. `None` where valgrind is not installed.
///
/// # Panics
///
/// Where the program fails, or callgrind does not say what it counted.
pub(crate) fn counted(flags: &[&str], arguments: &[&str]) -> Option<(f64, String)> {
    let program = std::env::current_exe().expect("this program has a path");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .args(flags)
        .arg(program)
        .args(arguments)
        .output();
    let output = match output {
        Err(error) if error.kind() == ErrorKind::NotFound => return None,
        output => output.expect("valgrind runs"),
    };
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
    let mut lines = said.lines();
    let collected = lines.find_map(|line| line.split_once("Collected : "));
    let (_, count) = collected.expect("callgrind says what it collected");
    let printed = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    Some((count.trim().parse().expect("a number"), printed))
}
