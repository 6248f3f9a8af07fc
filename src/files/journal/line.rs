//! Lines of a journal, one record each: the record's number, the length and checksum of its JSON,
//! and the JSON. A line that was cut off, changed, lost or put in twice is told from a whole one.

use std::fmt::Write as _;
use std::io::{self, BufRead, Read as _};

/// Length of the longest line that is read, in bytes: enough for a snapshot's document at its
/// bound, every character escaped.
pub(super) const MAX_LINE: u64 = 256 << 20;

/// CRC-32 checksum as in Ethernet, gzip and PNG (polynomial 0x04C11DB7, reflected), computed by the
/// byte.
fn checksum(bytes: &[u8]) -> u32 {
    const TABLE: [u32; 256] = {
        let mut table = [0; 256];
        let mut index = 0;
        while index < 256 {
            let mut value = index as u32;
            let mut bit = 0;
            while bit < 8 {
                value = if value & 1 == 1 { 0xEDB8_8320 ^ (value >> 1) } else { value >> 1 };
                bit += 1;
            }
            table[index] = value;
            index += 1;
        }
        table
    };
    !bytes
        .iter()
        .fold(!0, |crc, &byte| TABLE[((crc ^ u32::from(byte)) & 0xFF) as usize] ^ (crc >> 8))
}

/// Appends record `number` to `text`; `json` is one line.
pub(super) fn push(text: &mut String, number: u64, json: &str) {
    debug_assert!(!json.contains('\n'), "JSON as serde writes it has no line ends");
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{number} {} {:08x} {json}", json.len(), checksum(json.as_bytes()));
}

/// Number and JSON of a line without its end; `None` where the line is not as it was written.
fn parse(line: &str) -> Option<(u64, &str)> {
    let (number, rest) = line.split_once(' ')?;
    let (length, rest) = rest.split_once(' ')?;
    let (crc, json) = rest.split_once(' ')?;
    let is_whole = length.parse() == Ok(json.len())
        && u32::from_str_radix(crc, 16) == Ok(checksum(json.as_bytes()));
    let is_whole = is_whole && crc.len() == 8;
    number.parse().ok().filter(|_| is_whole).map(|number| (number, json))
}

/// Result of reading the next line.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum JournalLine {
    /// The record's JSON.
    Whole(String),
    /// Line that differs from what was written.
    Damaged,
    /// End of the file.
    End,
}

/// Reader of lines in order.
pub(super) struct LineReader<R> {
    from: R,
    next: u64,
}

impl<R: BufRead> LineReader<R> {
    pub(super) fn new(from: R) -> Self {
        Self { from, next: 0 }
    }

    /// Reads the next record. After a damaged line the following one is looked at all the same: a
    /// whole record there tells damage from an end that was cut off.
    ///
    /// # Errors
    /// The file cannot be read.
    pub(super) fn next(&mut self) -> io::Result<JournalLine> {
        let mut bytes = Vec::new();
        self.from.by_ref().take(MAX_LINE).read_until(b'\n', &mut bytes)?;
        if bytes.is_empty() {
            return Ok(JournalLine::End);
        }
        let line = bytes.strip_suffix(b"\n").and_then(|bytes| std::str::from_utf8(bytes).ok());
        let found = line.and_then(parse).filter(|(number, _)| *number >= self.next);
        let Some((number, json)) = found else { return Ok(JournalLine::Damaged) };
        // A gap in the numbers is damage, whatever follows.
        let is_next = number == self.next;
        self.next = number + 1;
        Ok(if is_next { JournalLine::Whole(json.to_owned()) } else { JournalLine::Damaged })
    }

    /// True if any whole record follows.
    pub(super) fn has_more(&mut self) -> bool {
        loop {
            let before = self.next;
            match self.next() {
                Ok(JournalLine::End) | Err(_) => return false,
                Ok(JournalLine::Damaged) if self.next == before => {}
                Ok(_) => return true,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_the_known_one() {
        // Check value that every description of CRC-32 gives.
        assert_eq!(checksum(b"123456789"), 0xCBF4_3926);
        assert_eq!(checksum(b""), 0);
    }

    fn written() -> String {
        let mut text = String::new();
        for (number, json) in ["{}", r#"{"a":"ü"}"#, "[1,2]"].into_iter().enumerate() {
            push(&mut text, number as u64, json);
        }
        text
    }

    fn read(bytes: &[u8]) -> (Vec<String>, JournalLine) {
        let mut lines = LineReader::new(bytes);
        let mut whole = Vec::new();
        loop {
            match lines.next().unwrap() {
                JournalLine::Whole(json) => whole.push(json),
                other => return (whole, other),
            }
        }
    }

    #[test]
    fn lines_are_read_back() {
        let (whole, end) = read(written().as_bytes());
        assert_eq!(whole, ["{}", r#"{"a":"ü"}"#, "[1,2]"]);
        assert_eq!(end, JournalLine::End);
    }

    #[test]
    fn a_line_cut_anywhere_is_no_line() {
        let text = written();
        let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at + 1).collect();
        for cut in 0..=text.len() {
            let (whole, end) = read(&text.as_bytes()[..cut]);
            assert_eq!(whole.len(), ends.iter().filter(|&&end| end <= cut).count(), "cut at {cut}");
            assert_eq!(end == JournalLine::End, cut == 0 || ends.contains(&cut));
        }
    }

    #[test]
    fn any_changed_byte_is_seen() {
        let text = written();
        let first = text.find('\n').unwrap() + 1;
        let second = first + text[first..].find('\n').unwrap() + 1;
        for at in first..second {
            for change in [1, 0x20, 0x80] {
                let mut bytes = text.clone().into_bytes();
                bytes[at] ^= change;
                let (whole, end) = read(&bytes);
                // The case of the checksum's digits does not matter.
                assert!(
                    whole.len() == 1 && end == JournalLine::Damaged || whole[1] == r#"{"a":"ü"}"#,
                    "byte {at}"
                );
            }
        }
    }

    #[test]
    fn lost_and_repeated_lines_are_seen() {
        let text = written();
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        let joined = |lines: &[&str]| read(lines.concat().as_bytes());
        assert_eq!(joined(&[lines[0], lines[2]]).1, JournalLine::Damaged);
        assert_eq!(joined(&[lines[0], lines[0], lines[1]]).1, JournalLine::Damaged);
        let damaged = [lines[0], "garbage\n", lines[1]].concat();
        let mut reader = LineReader::new(damaged.as_bytes());
        assert!(matches!(reader.next(), Ok(JournalLine::Whole(_))));
        assert_eq!(reader.next().unwrap(), JournalLine::Damaged);
        assert!(reader.has_more());
        let cut = [lines[0], "garbage\nmore\n"].concat();
        let mut reader = LineReader::new(cut.as_bytes());
        assert!(matches!(reader.next(), Ok(JournalLine::Whole(_))));
        assert!(!reader.has_more());
    }
}
