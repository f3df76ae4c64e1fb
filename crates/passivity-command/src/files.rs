//! The files that a command reads and writes.

use std::path::{Path, PathBuf};

use passivity_scene::Scene;
use passivity_scene::files::{self, Output, are_same};

use crate::exit::Failure;

/// The name of a file of CSV rows.
#[cfg(any(feature = "audit", feature = "plot", feature = "simulate"))]
pub(crate) fn csv() -> impl clap::builder::TypedValueParser<Value = PathBuf> {
    use clap::builder::{PathBufValueParser, TypedValueParser as _};
    use passivity_scene::files::csv_name;

    PathBufValueParser::new().try_map(|path| csv_name(&path).map(|()| path))
}

/// Refuses, before any work is done, to write over what is read, over what is no plain file, and two results into one
/// file. Each of the files that are to be written comes with the option that names it.
pub(crate) fn may_be_written(
    outputs: &[(&str, Option<&PathBuf>)],
    inputs: &[PathBuf],
    verb: &str,
) -> Result<(), Failure> {
    let mut before: Vec<(&str, &Path)> = Vec::new();
    for (option, output) in outputs {
        let Some(output) = output else { continue };
        let refuse = |why: String| Err(Failure::input(format!("{}: {why}", output.display())));
        // What does not exist yet is no input.
        let is_read = |input: &PathBuf| match input.as_os_str() == "-" {
            true => is_standard_input(output),
            false => are_same(output, input),
        };
        if output.exists() && inputs.iter().any(is_read) {
            return refuse(format!(
                "is read by this {verb}, and cannot be written by it"
            ));
        }
        // Work that takes minutes is not begun for a folder that is not there, or that takes no file.
        let folder = output
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty());
        if let Some(folder) = folder.filter(|folder| !folder.exists()) {
            return refuse(format!(
                "there is no folder `{}` for {option}",
                folder.display()
            ));
        }
        let made = Output::create(output).map(drop);
        made.map_err(|error| Failure::io(output.display(), &error))?;
        if let Some((other, _)) = before.iter().find(|(_, path)| are_same(path, output)) {
            return refuse(format!(
                "is the file of {other} and of {option}: give each a file of its own"
            ));
        }
        before.push((option, output));
    }
    Ok(())
}

/// Whether a file is the one that standard input comes from.
#[cfg(unix)]
fn is_standard_input(path: &Path) -> bool {
    use std::os::fd::AsFd as _;
    use std::os::unix::fs::MetadataExt as _;
    let input = std::io::stdin().as_fd().try_clone_to_owned();
    let input = input.and_then(|input| std::fs::File::from(input).metadata());
    let same = |(there, input): (std::fs::Metadata, std::fs::Metadata)| {
        (there.dev(), there.ino()) == (input.dev(), input.ino())
    };
    path.metadata().ok().zip(input.ok()).is_some_and(same)
}

/// Elsewhere nothing says where it comes from.
#[cfg(not(unix))]
fn is_standard_input(_: &Path) -> bool {
    false
}

/// What a scene is read from: its own file, and that of the operator's forces.
pub(crate) fn sources(scene: &Scene, path: &Path) -> Vec<PathBuf> {
    let forces = scene.forces.iter().zip(path.parent());
    let forces = forces.map(|(forces, folder)| folder.join(&forces.path));
    std::iter::once(path.to_owned()).chain(forces).collect()
}

/// Writes a file whole, in place of what had its name.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    files::write(path, text).map_err(|error| Failure::io(path.display(), &error))
}

/// Writes a file whole that must not be there yet.
pub(crate) fn write_new(path: &Path, text: &str) -> Result<(), Failure> {
    match path.symlink_metadata() {
        Ok(_) => Err(Failure::input(format!(
            "{} is there already: it is not overwritten",
            path.display()
        ))),
        Err(_) => write(path, text),
    }
}
