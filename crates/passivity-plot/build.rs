//! The font of pictures as PNG, compressed, which it is worth: a program carries both of its weights.

#[cfg(not(feature = "png"))]
fn main() {}

#[cfg(feature = "png")]
fn main() -> std::io::Result<()> {
    use std::io::Write as _;

    println!("cargo::rerun-if-changed=build.rs");
    let out = std::env::var_os("OUT_DIR").ok_or_else(|| std::io::Error::other("run by cargo"))?;
    let fonts = [
        ("regular", dejavu::sans::regular()),
        ("bold", dejavu::sans::bold()),
    ];
    for (name, font) in fonts {
        let file = std::fs::File::create(std::path::Path::new(&out).join(name))?;
        let mut compressed = flate2::write::DeflateEncoder::new(file, flate2::Compression::best());
        compressed.write_all(font)?;
        compressed.finish()?;
    }
    Ok(())
}
