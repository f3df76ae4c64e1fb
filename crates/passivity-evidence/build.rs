//! What the library carries of other folders, made small: the recorded evidence compressed, since
//! most of it is paths said again and again, and of the kernel's sources their SHA-256 sums.

use std::fmt::Write as _;
use std::io::{Error, Write as _};
use std::path::Path;
use std::{env, fs};

use flate2::{Compression, write::DeflateEncoder};
use sha2::{Digest as _, Sha256};

const EVIDENCE: &str = "data/evidence.json";
const KERNEL: &str = "data/kernel";

fn main() -> Result<(), Error> {
    let out = env::var_os("OUT_DIR").ok_or_else(|| Error::other("run by cargo"))?;
    for read in [EVIDENCE, KERNEL] {
        println!("cargo::rerun-if-changed={read}");
    }
    let mut evidence = DeflateEncoder::new(Vec::new(), Compression::best());
    evidence.write_all(&fs::read(EVIDENCE)?)?;
    fs::write(Path::new(&out).join("evidence"), evidence.finish()?)?;

    let files = fs::read_dir(KERNEL)?.collect::<Result<Vec<_>, _>>()?;
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
