//! Files that are compressed by gzip or zstd.

use std::io::Read;

use crate::log::error::TraceError;

/// Whether a file with these first bytes is compressed by gzip or zstd, which may start with a frame that is skipped.
pub(crate) fn is_compressed(start: &[u8]) -> bool {
    start.starts_with(&[0x1f, 0x8b])
        || matches!(
            start,
            [0x28, 0xb5, 0x2f, 0xfd, ..] | [0x50..=0x5f, 0x2a, 0x4d, 0x18, ..]
        )
}

/// The first bytes, by which formats are told, or as many as there are.
pub(crate) fn start(input: &mut dyn Read) -> Result<Vec<u8>, TraceError> {
    let mut start = Vec::new();
    let read = input.take(16).read_to_end(&mut start);
    read.map_err(|error| TraceError::io(&error))?;
    Ok(start)
}

#[cfg(feature = "compressed")]
pub(super) fn decompressed(
    input: Box<dyn Read>,
    start: &[u8],
) -> Result<Box<dyn Read>, TraceError> {
    if start.starts_with(&[0x1f, 0x8b]) {
        let buffered = std::io::BufReader::new(input);
        return Ok(Box::new(flate2::bufread::MultiGzDecoder::new(buffered)));
    }
    match zstd::stream::read::Decoder::new(input) {
        Ok(decoder) => Ok(Box::new(decoder)),
        Err(error) => Err(TraceError::io(&error)),
    }
}

#[cfg(not(feature = "compressed"))]
pub(super) fn decompressed(_: Box<dyn Read>, _: &[u8]) -> Result<Box<dyn Read>, TraceError> {
    let message = "compressed files are not in this build: build it with the feature `compressed`";
    Err(TraceError::new("compressed", message))
}
