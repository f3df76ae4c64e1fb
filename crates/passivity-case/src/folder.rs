//! The folder of a case, which is written completely or not at all.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::{fs, io};

use passivity_audit::legible;
use passivity_evidence::Sha256;
use passivity_scene::files::Output;

use crate::case::{Case, HistoryEntry};
use crate::draw::draw;
use crate::error::CaseError;
use crate::files::{MOST_BYTES, read_bytes};
use crate::manifest::{MANIFEST, Manifest};
use crate::print;
use crate::recorded::record_name;
use crate::{html, sections};

/// The document, as HTML.
pub const HTML: &str = "case.html";

/// The document, as PDF: only where it was asked for.
pub const PDF: &str = "case.pdf";

/// Who wrote the case, for which use: only where it was given.
pub const INFO: &str = "case.info.toml";

/// The files of a case, by name, the manifest last.
///
/// # Errors
///
/// A manifest that JSON cannot write.
pub fn files(case: &Case) -> Result<BTreeMap<String, Vec<u8>>, CaseError> {
    let document = sections::document(case);
    let mut files = BTreeMap::new();
    files.insert(HTML.to_owned(), html::write(&document).into_bytes());
    if let Some(info) = &case.info {
        files.insert(INFO.to_owned(), info.text.clone().into_bytes());
    }
    for (study, argument) in case.scenes() {
        let name = &study.slug;
        files.insert(format!("{name}.gsn.yaml"), argument.to_yaml().into_bytes());
        let drawing = draw(argument, argument.top(), &[], name);
        files.insert(format!("{name}.gsn.svg"), drawing.svg.into_bytes());
        files.insert(format!("{name}.toml"), study.text.clone().into_bytes());
        if let Some(recorded) = &study.recorded {
            let text = serde_json::to_string_pretty(&recorded.to_json(&study.scene))
                .map_err(|error| CaseError::new(format!("the recordings: {error}")))?;
            files.insert(record_name(name), format!("{text}\n").into_bytes());
        }
    }
    for (name, bytes) in case
        .studies
        .iter()
        .filter_map(|study| study.forces.as_ref())
    {
        let other = files.insert(name.clone(), bytes.clone());
        if other.is_some_and(|other| other != *bytes) || [MANIFEST, PDF].contains(&name.as_str()) {
            let name = legible(name);
            return Err(CaseError::new(format!(
                "`operator.force`: the case has another file `{name}`: give that of the forces a name of its own"
            )));
        }
    }
    let manifest = Manifest::of(case, &files);
    files.insert(MANIFEST.to_owned(), manifest.to_text()?.into_bytes());
    Ok(files)
}

/// The verdicts that an earlier case in the folder recorded; none when there is no case.
///
/// # Errors
///
/// A manifest that is there and cannot be read.
pub fn history(folder: &Path) -> Result<Vec<HistoryEntry>, CaseError> {
    if folder.join(MANIFEST).is_file() {
        Ok(Manifest::read(folder)?.history)
    } else {
        Ok(Vec::new())
    }
}

/// Writes the case into `folder`, which takes the place of a case that was there before.
///
/// Everything is written into a new folder beside it first, so that no half-written case is left
/// behind, whatever happens.
///
/// # Errors
///
/// A folder that cannot be written, that holds something that is no case, or whose case is another than the one whose
/// history this one goes on from.
pub fn write(case: &Case, folder: &Path) -> Result<(), CaseError> {
    let files = files(case)?;
    // Where there is a link, the folder that it leads to is replaced, and the link stays.
    let target = match folder.is_symlink() {
        true => folder.canonicalize().ok(),
        false => None,
    };
    let folder = target.as_deref().unwrap_or(folder);
    // What is there, if only as a link that leads nowhere.
    let mut there = folder
        .ancestors()
        .filter(|path| path.symlink_metadata().is_ok());
    if let Some(path) = there.next().filter(|path| !path.is_dir()) {
        let message = format!(
            "`{}` is no folder: the case cannot be written into it",
            path.display()
        );
        return Err(CaseError::new(message));
    }
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    fs::create_dir_all(&parent).map_err(|error| CaseError::io(&parent, &error))?;
    let _held = held(&parent);
    refuse_others(folder, &files)?;
    if !case.history.starts_with(&history(folder)?) {
        let what = "another process wrote the case meanwhile: run the command again, so that the history of verdicts \
                    has both";
        return Err(CaseError::within(folder, what));
    }
    let name = folder
        .file_name()
        .ok_or_else(|| {
            CaseError::new(format!(
                "`{}`: expected the name of a folder",
                folder.display()
            ))
        })?
        .to_string_lossy()
        .into_owned();
    let beside = |what: &str| parent.join(format!(".{name}.{what}-{}", std::process::id()));
    let (new, old) = (beside("new"), beside("old"));
    let result = fill(&new, &files, folder).and_then(|()| swap(&new, &old, folder));
    // What is left over when it failed is of no use to anybody.
    let _ = fs::remove_dir_all(&new);
    result
}

/// A lock of this folder, for which other processes that write cases in it wait; the system gives it back however this
/// one ends. Where it has none for folders, cases are written without.
fn held(folder: &Path) -> Option<fs::File> {
    let opened = fs::File::open(folder).ok()?;
    opened.lock().ok().map(|()| opened)
}

/// Writes the files into `new`, which is to become `folder`: errors name that, which a person gave.
fn fill(new: &Path, files: &BTreeMap<String, Vec<u8>>, folder: &Path) -> Result<(), CaseError> {
    fs::create_dir(new).map_err(|error| {
        CaseError::within(folder, format!("the case cannot be written there: {error}"))
    })?;
    for (name, bytes) in files {
        let written = fs::write(new.join(name), bytes);
        written.map_err(|error| CaseError::io(&folder.join(name), &error))?;
    }
    Ok(())
}

/// Puts `new` in the place of `folder`; should that fail, what was there stays there.
fn swap(new: &Path, old: &Path, folder: &Path) -> Result<(), CaseError> {
    let there = folder.exists();
    if there {
        fs::rename(folder, old).map_err(|error| CaseError::io(folder, &error))?;
    }
    if let Err(error) = fs::rename(new, folder) {
        let restored = if there {
            fs::rename(old, folder)
        } else {
            Ok(())
        };
        return Err(match restored {
            Ok(()) => CaseError::io(folder, &error),
            Err(_) => {
                let old = old.display();
                CaseError::within(folder, format!("{error}; the earlier case is in `{old}`"))
            }
        });
    }
    // The new case stands; an old one that cannot be removed does no harm.
    let _ = fs::remove_dir_all(old);
    Ok(())
}

/// Prints the document of a written case as PDF, with a browser, and adds it to the manifest.
///
/// # Errors
///
/// A browser that does not print the page; the rest of the case is left as it is.
pub fn add_pdf(folder: &Path, browser: &Path) -> Result<(), CaseError> {
    let pdf = print::to_pdf(browser, &folder.join(HTML), print::TIME_LIMIT)?;
    let mut manifest = Manifest::read(folder)?;
    manifest.files.insert(PDF.to_owned(), Sha256::of(&pdf));
    // The manifest first: where this is broken off, the PDF is one that is missing, and none of somebody's own.
    for (name, bytes) in [(MANIFEST, manifest.to_text()?.into_bytes()), (PDF, pdf)] {
        let path = folder.join(name);
        let written = Output::create(&path).and_then(|mut file| {
            file.write_all(&bytes)?;
            file.keep()
        });
        written.map_err(|error| CaseError::io(&path, &error))?;
    }
    Ok(())
}

/// Refuses a folder that holds something else than a case as it was written, or what is written now: writing would lose
/// what somebody put there, or what the case says of the past.
fn refuse_others(folder: &Path, new: &BTreeMap<String, Vec<u8>>) -> Result<(), CaseError> {
    let names = names(folder)?;
    if names.is_empty() {
        return Ok(());
    }
    if !names.contains(MANIFEST) {
        let what = match names.contains(HTML) {
            true => parted(&format!("`{MANIFEST}` is missing")),
            false => "expected an empty folder, a new one or one with a case in it".to_owned(),
        };
        return Err(CaseError::within(folder, what));
    }
    let manifest = Manifest::read(folder)?;
    let mut kept = Vec::new();
    for name in names {
        if name == MANIFEST || name == HTML {
            continue;
        }
        let path = folder.join(&name);
        let Some(written) = manifest.files.get(&name) else {
            kept.push(format!("`{}`: no part of the case", path.display()));
            continue;
        };
        let bytes = read_bytes(&path, MOST_BYTES)?;
        if Sha256::of(&bytes) != *written && new.get(&name) != Some(&bytes) {
            kept.push(format!(
                "`{}`: changed since the case was written",
                path.display()
            ));
        }
    }
    if !kept.is_empty() {
        let what = "and writing the case again would lose it: move it elsewhere";
        return Err(CaseError::new(format!("{}, {what}", kept.join("; "))));
    }
    let how = match read_bytes(&folder.join(HTML), MOST_BYTES) {
        Ok(page) => {
            let is_as_written = manifest.files.get(HTML) == Some(&Sha256::of(&page));
            match manifest.is_told_by(&String::from_utf8_lossy(&page)) {
                Some(false) => format!("`{HTML}` and `{MANIFEST}` are not of one case"),
                _ if is_as_written => return Ok(()),
                _ => format!("`{HTML}` was changed after it was written"),
            }
        }
        Err(_) => format!("`{HTML}` is missing or cannot be read"),
    };
    Err(CaseError::within(folder, parted(&how)))
}

/// What to do with a case whose history of verdicts cannot be told from one that somebody changed.
fn parted(how: &str) -> String {
    format!(
        "{how}, so that the history of verdicts may be another than it was: restore the folder, or \
         write the case into another one"
    )
}

/// The names of what is in a folder; none where there is no folder.
fn names(folder: &Path) -> Result<BTreeSet<String>, CaseError> {
    if !folder.exists() {
        return Ok(BTreeSet::new());
    }
    let of_folder = |error| CaseError::io(folder, &error);
    let entries = fs::read_dir(folder).map_err(of_folder)?;
    let name =
        |entry: io::Result<fs::DirEntry>| Ok(entry?.file_name().to_string_lossy().into_owned());
    entries
        .map(name)
        .collect::<io::Result<_>>()
        .map_err(of_folder)
}
