//! What the library carries of other folders, made small: the claims and the recorded evidence compressed, since
//! most of that is paths said again and again, and of the kernel's sources their SHA-256 sums.

use std::fmt::Write as _;
use std::io::{Error, Write as _};
use std::path::{Path, PathBuf};
use std::{env, fs};

use flate2::{Compression, write::DeflateEncoder};
use sha2::{Digest as _, Sha256};

const TEXTS: [(&str, &str); 2] = [
    ("data/claims.toml", "claims"),
    ("data/evidence.json", "evidence"),
];
const KERNEL: &str = "data/kernel";

/// Where a link of the repository leads: of a checkout without symbolic links they are files with that text.
fn followed(link: &str) -> PathBuf {
    let link = Path::new(link);
    match fs::read_to_string(link) {
        Ok(text) if text.starts_with("../") => link.with_file_name(text.trim_end()),
        _ => link.to_owned(),
    }
}

fn main() -> Result<(), Error> {
    let out = env::var_os("OUT_DIR").ok_or_else(|| Error::other("run by cargo"))?;
    println!("cargo::rerun-if-changed={}", followed(KERNEL).display());
    for (read, name) in TEXTS {
        println!("cargo::rerun-if-changed={}", followed(read).display());
        let mut text = DeflateEncoder::new(Vec::new(), Compression::best());
        text.write_all(&fs::read(followed(read))?)?;
        fs::write(Path::new(&out).join(name), text.finish()?)?;
    }

    let files = fs::read_dir(followed(KERNEL))?.collect::<Result<Vec<_>, _>>()?;
    let mut sums = files
        .iter()
        .map(|file| Ok((file.file_name(), Sha256::digest(fs::read(file.path())?))))
        .collect::<Result<Vec<_>, Error>>()?;
    sums.sort();
    let mut list = String::from("&[");
    for (name, sum) in sums {
        let path = Path::new("crates/passivity-core/src").join(name);
        let _ = write!(list, "({path:?}, Sha256({:?})),", sum.as_slice());
    }
    fs::write(Path::new(&out).join("kernel.rs"), list + "]")
}
