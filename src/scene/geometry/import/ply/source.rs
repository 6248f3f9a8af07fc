//! The numbers behind a PLY header, as text or binary.

use chiaro_locale::tr;

use super::header::{Encoding, Header, Property};
use crate::diag::{Diagnostic, LineColumn};
use crate::geometry::import::cursor::{Cursor, NumberType};
use crate::geometry::import::report::ImportProblem;
use crate::geometry::import::source::Source;

/// Number of bytes that are read from the file at a time.
const BLOCK: usize = 1 << 16;

/// Source of the numbers, which are read one after the other.
pub(super) struct NumberSource<'f> {
    file: Source<'f>,
    encoding: Encoding,
    /// Place in the file behind the bytes of `block`.
    place: u64,
    block: Vec<u8>,
    /// Number of bytes of `block` that were read.
    read: usize,
    /// Line of the next word, in a text.
    line: u32,
}

impl<'f> NumberSource<'f> {
    /// The numbers behind a header.
    pub(super) fn new(file: Source<'f>, header: &Header) -> Self {
        Self {
            file,
            encoding: header.encoding,
            place: header.length as u64,
            block: Vec::new(),
            read: 0,
            line: header.lines as u32 + 1,
        }
    }

    /// Number of bytes left to read.
    pub(super) fn left(&self) -> u64 {
        self.file.length() - self.place + self.unread().len() as u64
    }

    /// The bytes at hand.
    fn unread(&self) -> &[u8] {
        &self.block[self.read..]
    }

    /// Puts more bytes at hand; false at the end of the file.
    fn fill(&mut self) -> Result<bool, ImportProblem> {
        let count = (self.file.length() - self.place).min(BLOCK as u64) as usize;
        self.block.drain(..self.read);
        self.read = 0;
        let before = self.block.len();
        self.block.resize(before + count, 0);
        self.file.read(self.place, &mut self.block[before..])?;
        self.place += count as u64;
        Ok(count > 0)
    }

    /// The length of the next word of a text, behind the white space before it, which is passed
    /// over; 0 at the end of the file.
    fn word(&mut self) -> Result<usize, ImportProblem> {
        let mut length = 0;
        loop {
            if length == 0 {
                let unread = self.unread();
                let start = unread.iter().position(|byte| !byte.is_ascii_whitespace());
                let start = start.unwrap_or(unread.len());
                let lines = unread[..start].iter().filter(|&&byte| byte == b'\n').count();
                self.line += lines as u32;
                self.read += start;
            }
            let more = &self.unread()[length..];
            let end = more.iter().position(u8::is_ascii_whitespace);
            length += end.unwrap_or(more.len());
            if end.is_some() || !self.fill()? {
                return Ok(length);
            }
        }
    }

    /// Reads the numbers of one property into `values`: one number, or those of a list.
    ///
    /// # Errors
    /// At the end of the file, and at words that are no numbers; `what` names the element.
    pub(super) fn property(
        &mut self,
        property: &Property,
        values: &mut Vec<f64>,
        what: &dyn Fn() -> String,
    ) -> Result<(), ImportProblem> {
        values.clear();
        let Some(list) = property.list else {
            values.push(self.number(property.number, what)?);
            return Ok(());
        };
        let count = self.number(list, what)?;
        // The comparison also refuses NaN; every number takes a byte at least.
        if !(0.0..=self.left() as f64).contains(&count) || count.fract() != 0.0 {
            let message = tr!(
                "{what} has a list of {count} numbers, more than the file holds",
                what = what()
            );
            return Err(self.here(Diagnostic::error("mesh-truncated", message)).into());
        }
        for _ in 0..count as usize {
            values.push(self.number(property.number, what)?);
        }
        Ok(())
    }

    fn number(
        &mut self,
        kind: NumberType,
        what: &dyn Fn() -> String,
    ) -> Result<f64, ImportProblem> {
        if self.encoding != Encoding::Ascii {
            while self.unread().len() < kind.size() {
                if !self.fill()? {
                    return Err(ended(what));
                }
            }
            let mut cursor = match self.encoding {
                Encoding::BigEndian => Cursor::big_endian(self.unread()),
                _ => Cursor::little_endian(self.unread()),
            };
            let number = cursor.number(kind);
            self.read += kind.size();
            return number.ok_or_else(|| ended(what));
        }
        let length = self.word()?;
        if length == 0 {
            return Err(ended(what));
        }
        let start = self.read;
        self.read += length;
        let word = &self.block[start..self.read];
        let number = std::str::from_utf8(word).ok().and_then(|text| text.parse::<f64>().ok());
        number.ok_or_else(|| {
            let shown: String = String::from_utf8_lossy(word).chars().take(40).collect();
            self.here(Diagnostic::error(
                "mesh-syntax",
                tr!("`{shown}` in {what} is not a number", what = what()),
            ))
            .into()
        })
    }

    /// Adds the current line to a diagnostic where the source is text.
    pub(super) fn here(&self, diagnostic: Diagnostic) -> Diagnostic {
        match self.encoding {
            Encoding::Ascii => diagnostic.at(LineColumn { line: self.line, column: 1 }),
            _ => diagnostic,
        }
    }
}

fn ended(what: &dyn Fn() -> String) -> ImportProblem {
    Diagnostic::error("mesh-truncated", tr!("the file ends within {what}", what = what())).into()
}
