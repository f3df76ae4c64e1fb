//! The records of an MCAP file, one after the other, each chunk checked before any of it is used.

use std::fs::File;
use std::io::{Read as _, Seek as _, SeekFrom};
use std::path::Path;

use mcap::records::{Record, op};
use mcap::sans_io::linear_reader::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{McapError, parse_record};

use crate::log::error::{TraceError, shown};

/// The longest record and the largest chunk, in bytes: as much may be held in memory at once.
const MOST_BYTES: usize = 1 << 28;

/// How much is read at once: not less, nor more, whatever a record says of its length.
const LEAST_READ: usize = 1 << 16;
const MOST_READ: usize = 1 << 20;

/// The records of a file, from some place on.
pub(crate) struct Records {
    file: File,
    reader: LinearReader,
    /// How many bytes of the file have been read.
    at: u64,
}

fn wrong(message: impl Into<String>) -> TraceError {
    TraceError::new("mcap", message)
}

impl Records {
    pub(crate) fn open(path: &Path) -> Result<Self, TraceError> {
        let file = File::open(path).map_err(|error| TraceError::io(&error))?;
        let options = LinearReaderOptions::default()
            .with_prevalidate_chunk_crcs(true)
            .with_validate_data_section_crc(true)
            .with_validate_summary_section_crc(true)
            .with_record_length_limit(MOST_BYTES);
        Ok(Self {
            file,
            reader: LinearReader::new_with_options(options),
            at: 0,
        })
    }

    /// The records of the summary at the end of a file; `None` where it has none that can be found.
    pub(crate) fn summary(path: &Path) -> Option<Self> {
        // The footer and the magic bytes after it, of which the first eight after the record's own nine say
        // where the summary starts.
        const END: i64 = 9 + 20 + 8;
        let mut file = File::open(path).ok()?;
        file.seek(SeekFrom::End(-END)).ok()?;
        let mut end = [0; 17];
        file.read_exact(&mut end).ok()?;
        let (&opcode, rest) = end.split_first()?;
        let start = u64::from_le_bytes(rest.get(8..)?.try_into().ok()?);
        if opcode != op::FOOTER || start == 0 {
            return None;
        }
        file.seek(SeekFrom::Start(start)).ok()?;
        let options = LinearReaderOptions::default()
            .with_skip_start_magic(true)
            .with_record_length_limit(MOST_BYTES);
        Some(Self {
            file,
            reader: LinearReader::new_with_options(options),
            at: start,
        })
    }

    /// Gives the next record that says something about messages; `None` at the end of the file.
    pub(crate) fn next<T>(
        &mut self,
        mut with: impl FnMut(Record<'_>) -> Result<T, TraceError>,
    ) -> Result<Option<T>, TraceError> {
        loop {
            let at = self.at;
            let need = match self.reader.next_event() {
                None => return Ok(None),
                Some(Err(error)) => return Err(broken(&error, at)),
                Some(Ok(LinearReadEvent::ReadRequest(need))) => need,
                Some(Ok(LinearReadEvent::Record { data, opcode })) => {
                    // The others say nothing that is needed, and some can be long.
                    if [op::SCHEMA, op::CHANNEL, op::MESSAGE, op::STATISTICS].contains(&opcode) {
                        let record = parse_record(opcode, data).map_err(|e| broken(&e, at))?;
                        return with(record).map(Some);
                    }
                    continue;
                }
            };
            let room = self.reader.insert(need.clamp(LEAST_READ, MOST_READ));
            let read = loop {
                match self.file.read(room) {
                    Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                    read => break read.map_err(|error| TraceError::io(&error))?,
                }
            };
            self.reader.notify_read(read);
            self.at += read as u64;
        }
    }
}

/// What the library says of a file that it cannot read, with the place.
fn broken(error: &McapError, at: u64) -> TraceError {
    match error {
        McapError::UnexpectedEof => wrong(format!(
            "the file ends at byte {at} in the middle of a record: it was cut short, or not closed"
        )),
        McapError::BadChunkCrc { .. } => wrong(format!(
            "a chunk that ends before byte {at} was changed after it was written: its checksum is another"
        )),
        McapError::BadDataCrc { .. } => wrong(
            "the file was changed after it was written: the checksum of all its records is another",
        ),
        McapError::RecordTooLarge { len, .. } | McapError::ChunkTooLarge(len) => wrong(format!(
            "a record or chunk before byte {at} has {len} bytes, and at most {MOST_BYTES} are read"
        )),
        McapError::UnsupportedCompression(name) => wrong(format!(
            "a chunk before byte {at} is compressed by `{}`: zstd and lz4 are read",
            shown(name.as_bytes())
        )),
        other => wrong(format!("cannot be read as MCAP before byte {at}: {other}")),
    }
}
