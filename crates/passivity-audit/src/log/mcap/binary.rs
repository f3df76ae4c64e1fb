//! Messages in the binary forms of ROS: CDR of ROS 2, and that of ROS 1, which has no gaps.
//!
//! A message can say anything, so every length is compared with what is left of it, and what it makes the
//! reader do is bounded by its own length.

use std::borrow::Cow;

use crate::log::mcap::schema::{Count, Field, Kind, Schema};
use crate::log::mcap::value::{MOST_ELEMENTS, Scalar, Value, nanoseconds};

/// How deep messages may be within each other.
const MOST_DEPTH: usize = 32;

/// The bytes of a message, and how they are read.
struct Bytes<'a> {
    bytes: &'a [u8],
    at: usize,
    big_endian: bool,
    /// The widest number that starts at a multiple of its own width; 1 where none does.
    align: usize,
    /// Whether a message without fields takes a byte.
    pads_empty: bool,
    /// How many more values may be read.
    fuel: usize,
}

const SHORT: &str = "it ends before its last field";

/// Decodes a message in CDR.
pub(crate) fn cdr<'a>(schema: &'a Schema, message: &'a [u8]) -> Result<Value<'a>, &'static str> {
    let Some(([_, form, _, _], bytes)) = message.split_first_chunk() else {
        return Err(SHORT);
    };
    // Plain CDR of the first and of the second version, each in both orders of bytes.
    let (big_endian, align) = match (message.first(), form) {
        (Some(0), 0) => (true, 8),
        (Some(0), 1) => (false, 8),
        (Some(0), 6) => (true, 4),
        (Some(0), 7) => (false, 4),
        _ => return Err("it is CDR of a kind that is not read"),
    };
    decode(schema, bytes, (big_endian, align, true))
}

/// Decodes a message of ROS 1.
pub(crate) fn ros1<'a>(schema: &'a Schema, message: &'a [u8]) -> Result<Value<'a>, &'static str> {
    decode(schema, message, (false, 1, false))
}

fn decode<'a>(
    schema: &'a Schema,
    bytes: &'a [u8],
    (big_endian, align, pads_empty): (bool, usize, bool),
) -> Result<Value<'a>, &'static str> {
    let mut bytes = Bytes {
        bytes,
        at: 0,
        big_endian,
        align,
        pads_empty,
        fuel: bytes.len().saturating_mul(4).saturating_add(1024),
    };
    bytes.message(schema, 0, 0)
}

impl<'a> Bytes<'a> {
    fn take(&mut self, size: usize) -> Result<&'a [u8], &'static str> {
        let end = self.at.checked_add(size).ok_or(SHORT)?;
        let taken = self.bytes.get(self.at..end).ok_or(SHORT)?;
        self.at = end;
        Ok(taken)
    }

    /// Goes to where something of this width may start.
    fn align(&mut self, size: usize) {
        self.at = self.at.next_multiple_of(size.clamp(1, self.align));
    }

    /// The bytes of a number, the lowest first.
    fn number<const N: usize>(&mut self) -> Result<[u8; N], &'static str> {
        self.align(N);
        let mut bytes: [u8; N] = self.take(N)?.try_into().map_err(|_| SHORT)?;
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn length(&mut self) -> Result<usize, &'static str> {
        usize::try_from(u32::from_le_bytes(self.number()?)).map_err(|_| SHORT)
    }

    fn message(
        &mut self,
        schema: &'a Schema,
        message: usize,
        depth: usize,
    ) -> Result<Value<'a>, &'static str> {
        if depth == MOST_DEPTH {
            return Err("its messages are too deep within each other");
        }
        let message = schema.messages.get(message).ok_or("it has no definition")?;
        let mut fields = Vec::with_capacity(message.fields.len());
        for field in &message.fields {
            let value = self.field(schema, field, depth)?;
            fields.push((Cow::Borrowed(field.name.as_str()), value));
        }
        if fields.is_empty() && self.pads_empty {
            self.take(1)?;
        }
        if message.is_time
            && let [
                (_, Value::Number(Scalar::Whole(seconds))),
                (_, Value::Number(Scalar::Whole(rest))),
            ] = fields.as_slice()
        {
            return time(*seconds, *rest);
        }
        Ok(Value::Struct(fields))
    }

    fn field(
        &mut self,
        schema: &'a Schema,
        field: &Field,
        depth: usize,
    ) -> Result<Value<'a>, &'static str> {
        let count = match field.count {
            Count::One => return self.value(schema, field.kind, depth),
            Count::Fixed(count) => count,
            Count::Any => self.length()?,
        };
        let mut list = Vec::new();
        if let Some(size) = field.kind.size() {
            if count > 0 {
                self.align(size);
            }
            let all = count.checked_mul(size).ok_or(SHORT)?;
            let end = self
                .at
                .checked_add(all)
                .filter(|end| *end <= self.bytes.len());
            let end = end.ok_or(SHORT)?;
            for _ in 0..count.min(MOST_ELEMENTS) {
                list.push(self.value(schema, field.kind, depth)?);
            }
            self.at = end;
            return Ok(Value::List(list));
        }
        for i in 0..count {
            let value = self.value(schema, field.kind, depth)?;
            if i < MOST_ELEMENTS {
                list.push(value);
            }
        }
        Ok(Value::List(list))
    }

    fn value(
        &mut self,
        schema: &'a Schema,
        kind: Kind,
        depth: usize,
    ) -> Result<Value<'a>, &'static str> {
        // Values without any bytes could be as many as a message likes.
        self.fuel = self
            .fuel
            .checked_sub(1)
            .ok_or("its lengths are too long for it")?;
        Ok(match kind {
            Kind::Bool => Value::Truth(self.number()? != [0]),
            Kind::Whole { bytes, signed } => {
                Value::Number(Scalar::Whole(self.whole(bytes, signed)?))
            }
            Kind::Single => Value::Number(Scalar::Single(f32::from_le_bytes(self.number()?))),
            Kind::Double => Value::Number(Scalar::Double(f64::from_le_bytes(self.number()?))),
            Kind::Time { signed } => {
                let (seconds, rest) = (self.whole(4, signed)?, self.whole(4, signed)?);
                return time(seconds, rest);
            }
            Kind::Text => {
                let length = self.length()?;
                let text = self.take(length)?;
                let text = text.strip_suffix(b"\0").unwrap_or(text);
                Value::Text(String::from_utf8_lossy(text))
            }
            Kind::Message(message) => return self.message(schema, message, depth + 1),
        })
    }

    fn whole(&mut self, bytes: usize, signed: bool) -> Result<i128, &'static str> {
        Ok(match (bytes, signed) {
            (1, true) => i8::from_le_bytes(self.number()?).into(),
            (1, false) => u8::from_le_bytes(self.number()?).into(),
            (2, true) => i16::from_le_bytes(self.number()?).into(),
            (2, false) => u16::from_le_bytes(self.number()?).into(),
            (4, true) => i32::from_le_bytes(self.number()?).into(),
            (4, false) => u32::from_le_bytes(self.number()?).into(),
            (_, true) => i64::from_le_bytes(self.number()?).into(),
            (_, false) => u64::from_le_bytes(self.number()?).into(),
        })
    }
}

fn time<'a>(seconds: i128, rest: i128) -> Result<Value<'a>, &'static str> {
    let time = nanoseconds(seconds, rest).ok_or("a time is too long")?;
    Ok(Value::Nanoseconds(time))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::mcap::schema::Ros;

    fn number(x: f64) -> Value<'static> {
        Value::Number(Scalar::Double(x))
    }

    #[test]
    fn numbers_start_at_multiples_of_their_width() {
        let schema = Schema::parse("p/M", b"uint8 a\nfloat64 b\nuint8 c\nfloat64[] d", Ros::Two);
        let schema = schema.unwrap();
        let mut bytes = vec![0, 1, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0];
        bytes.extend(1.5_f64.to_le_bytes());
        bytes.extend([9, 0, 0, 0, 1, 0, 0, 0]);
        bytes.extend(2.5_f64.to_le_bytes());
        let Value::Struct(fields) = cdr(&schema, &bytes).unwrap() else {
            panic!("no struct");
        };
        assert_eq!(fields[1].1, number(1.5));
        assert_eq!(fields[3].1, Value::List(vec![number(2.5)]));
        for short in 0..bytes.len() {
            assert!(cdr(&schema, &bytes[..short]).is_err(), "{short}");
        }
        // The same bytes of ROS 1 have no gaps.
        let schema = Schema::parse("p/M", b"uint8 a\nfloat64 b\ntime t", Ros::One).unwrap();
        let mut bytes = vec![7];
        bytes.extend(1.5_f64.to_le_bytes());
        bytes.extend([1, 0, 0, 0, 5, 0, 0, 0]);
        let Value::Struct(fields) = ros1(&schema, &bytes).unwrap() else {
            panic!("no struct");
        };
        assert_eq!(fields[1].1, number(1.5));
        assert_eq!(fields[2].1, Value::Nanoseconds(1_000_000_005));
    }

    #[test]
    fn lengths_that_a_message_has_no_room_for_are_refused() {
        let long = [0xff; 8];
        for text in [
            "float64[] x",
            "string s",
            "string[] s",
            "float64[1000000000000] x",
            "E[] e\n===\nMSG: p/E\n",
        ] {
            let schema = Schema::parse("p/M", text.as_bytes(), Ros::One).unwrap();
            assert!(ros1(&schema, &long).is_err(), "{text}");
        }
        // A message within itself.
        let schema = Schema::parse("p/M", b"p/M m", Ros::One).unwrap();
        assert!(ros1(&schema, &long).is_err());
    }
}
