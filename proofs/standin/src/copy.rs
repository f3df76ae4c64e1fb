//! Copies of crates, in which changes can be tried.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The version of every crate of the tree.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Writes a file, unless it says that already: what stays the same is not built again.
///
/// # Panics
///
/// When it cannot be written.
pub fn write(path: &Path, text: &[u8]) {
    if fs::read(path).is_ok_and(|there| there == text) {
        return;
    }
    fs::create_dir_all(path.parent().expect("a folder")).expect("folders can be made");
    fs::write(path, text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
}

/// Copies the manifests, the sources and the pages of a folder; `change` may change one. Removes from the copy what is
/// gone from the folder, but for the files that were `added` to the copy.
///
/// # Panics
///
/// When the folder cannot be read, or the copy not be written.
pub fn copy(
    from: &Path,
    to: &Path,
    added: &[&str],
    change: &mut dyn FnMut(&Path, String) -> String,
) {
    fs::create_dir_all(to).expect("folders can be made");
    for entry in fs::read_dir(from).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_name().expect("a name");
        if path.is_dir() {
            copy(&path, &to.join(name), added, change);
        } else if ["rs", "toml", "md"]
            .map(OsStr::new)
            .contains(&path.extension().unwrap_or_default())
        {
            let text = fs::read_to_string(&path).expect("sources are text");
            write(&to.join(name), change(&path, text).as_bytes());
        }
    }
    for entry in fs::read_dir(to).expect("the copy can be read") {
        let path = entry.expect("the copy can be read").path();
        let name = path.file_name().expect("a name");
        if from.join(name).exists() || added.iter().any(|added| name == *added) {
            continue;
        }
        let removed = match path.is_dir() {
            true => fs::remove_dir_all(&path),
            false => fs::remove_file(&path),
        };
        removed.expect("what is gone can be removed");
    }
}

/// Makes a workspace of the copied `members`, with the versions of the one at `root`. The members have a version of
/// their own, by which cargo tells them from those of the tree in a target folder that both share.
///
/// # Panics
///
/// When the workspace's manifest is not as it was.
pub fn workspace(root: &Path, copy_of: &Path, members: &[&str]) {
    let workspace = fs::read_to_string(root.join("Cargo.toml")).expect("the workspace's manifest");
    let (head, rest) = workspace.split_once("members = [").expect("members");
    let (_, tail) = rest
        .split_once("[workspace.package]")
        .expect("what members share");
    let members: Vec<String> = members.iter().map(|member| format!("{member:?}")).collect();
    let members = members.join(", ");
    let workspace = format!("{head}members = [{members}]\n[workspace.package]{tail}");
    let workspace = workspace.replace(VERSION, &format!("{VERSION}-changed"));
    write(&copy_of.join("Cargo.toml"), workspace.as_bytes());
    // Cargo takes out of the lock file what the copy does not have, so what was copied is kept aside.
    let lock = fs::read(root.join("Cargo.lock")).expect("the lock file");
    let kept = copy_of.join("Cargo.lock.copied");
    if fs::read(&kept).ok().as_ref() != Some(&lock) {
        write(&copy_of.join("Cargo.lock"), &lock);
        write(&kept, &lock);
    }
}

/// Writes a package into a folder of a copy that asks of each library which a `member` of the tree at `root` needs for
/// what the whole tree has of it: built with both, the copy needs no library again that is in the target folder of the
/// tree.
///
/// # Panics
///
/// When cargo does not say what the tree needs, or the package not be written.
pub fn share_libraries(root: &Path, folder: &Path, member: &str) {
    let all = libraries(root, &["--workspace"]);
    let needed = libraries(root, &["--package", member, "--edges", "normal,build"]);
    let mut asked = String::new();
    for (i, (library, version)) in needed.keys().enumerate() {
        let features = all.get(&(library.clone(), version.clone()));
        let features: Vec<&String> = features.into_iter().flatten().collect();
        asked += &format!(
            "l{i} = {{ package = {library:?}, version = \"={version}\", default-features = false, features = {features:?} }}\n"
        );
    }
    let name = folder.file_name().expect("a name");
    let manifest = format!(
        "[package]\nname = {name:?}\nedition = \"2021\"\n[dependencies]\n{asked}[build-dependencies]\n{asked}"
    );
    write(&folder.join("Cargo.toml"), manifest.as_bytes());
    write(&folder.join("src/lib.rs"), b"");
    // Macros are built for the compiler: what they need is asked for where a build script would.
    write(&folder.join("build.rs"), b"fn main() {}\n");
}

/// The libraries of a workspace that are from elsewhere, by name and version, and their features.
fn libraries(workspace: &Path, of: &[&str]) -> BTreeMap<(String, String), BTreeSet<String>> {
    let output = Command::new(env!("CARGO"))
        .args([
            "tree",
            "--offline",
            "--prefix",
            "none",
            "--format",
            "{p}|{f}",
        ])
        .args(of)
        .current_dir(workspace)
        .output()
        .expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "cargo tree: {said}");
    let mut libraries: BTreeMap<_, BTreeSet<String>> = BTreeMap::new();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Some((package, features)) = line.trim_end_matches(" (*)").split_once('|') else {
            continue;
        };
        // A member's folder comes after its version.
        let package = package.trim_end_matches(" (proc-macro)");
        let Some((name, version)) = package.split_once(" v").filter(|(_, v)| !v.contains(' '))
        else {
            continue;
        };
        let features = features.split(',').filter(|feature| !feature.is_empty());
        let known = libraries.entry((name.to_owned(), version.to_owned()));
        known.or_default().extend(features.map(str::to_owned));
    }
    libraries
}
