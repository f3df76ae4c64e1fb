//! The loop from standard input to standard output.

use std::io::{self, BufRead, Write};

use serde_json::Value;

use super::{At, Refusal, answer, refuse};

/// The longest request, in bytes. A longer line is refused and skipped without being kept.
pub const MAX_LINE: usize = 16 << 20;

/// Answers every line of `input` on `output`, in order, until the input ends.
///
/// Answers are held back only while further requests are at hand, so that a caller who waits for
/// an answer gets it.
///
/// # Errors
///
/// Only those of reading and writing.
///
/// # Example
///
/// ```
/// let (input, mut output) = (&b"nonsense\n{\"id\": 2, \"op\": \"version\"}\n"[..], Vec::new());
/// passivity_oracle::protocol::serve(input, &mut output).unwrap();
/// assert_eq!(String::from_utf8(output).unwrap().lines().count(), 2);
/// ```
pub fn serve(mut input: impl BufRead, mut output: impl Write) -> io::Result<()> {
    let (mut line, mut answers) = (Vec::new(), Vec::new());
    let mut skipping = false;
    loop {
        let available = match input.fill_buf() {
            Ok(available) => available,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        if available.is_empty() {
            if !line.is_empty() && !skipping {
                respond(&line, &mut answers);
            }
            output.write_all(&answers)?;
            return output.flush();
        }
        let mut used = 0;
        while let Some(rest) = available.get(used..).filter(|rest| !rest.is_empty()) {
            let end = rest.iter().position(|byte| *byte == b'\n');
            let (part, taken) = match end {
                Some(end) => (rest.get(..end).unwrap_or(rest), end + 1),
                None => (rest, rest.len()),
            };
            used += taken;
            if !skipping && line.len() + part.len() > MAX_LINE {
                too_long(&mut answers);
                line = Vec::new();
                skipping = true;
            }
            match (end.is_some(), skipping) {
                (true, true) => skipping = false,
                (true, false) if line.is_empty() => respond(part, &mut answers),
                (true, false) => {
                    line.extend_from_slice(part);
                    respond(&line, &mut answers);
                    line.clear();
                }
                (false, true) => {}
                (false, false) => line.extend_from_slice(part),
            }
            if answers.len() > 1 << 16 {
                output.write_all(&answers)?;
                answers.clear();
            }
        }
        input.consume(used);
        // Nothing more is at hand: the caller may be waiting.
        output.write_all(&answers)?;
        output.flush()?;
        answers.clear();
    }
}

fn respond(line: &[u8], answers: &mut Vec<u8>) {
    let line = line.strip_suffix(b"\r").unwrap_or(line);
    answer(line, answers);
    answers.push(b'\n');
}

fn too_long(answers: &mut Vec<u8>) {
    let message = format!("a request may have at most {MAX_LINE} bytes");
    let refusal = Refusal::new("line_too_long", At::Byte(MAX_LINE), message);
    refuse(&Value::Null, &refusal, answers);
    answers.push(b'\n');
}
