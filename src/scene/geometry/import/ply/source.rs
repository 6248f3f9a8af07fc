//! The numbers behind a PLY header, as text or binary.

use super::header::{Encoding, Property};
use crate::diag::{Diagnostic, LineColumn};
use crate::geometry::import::cursor::{Cursor, NumberType};
use crate::geometry::import::report::ImportProblem;

/// Source of the numbers, which are read one after the other.
pub(super) enum NumberSource<'a> {
    Text(Words<'a>),
    Binary(Cursor<'a>),
}

/// The words of a text, and the line of the next word.
pub(super) struct Words<'a> {
    rest: &'a [u8],
    line: u32,
}

impl<'a> NumberSource<'a> {
    pub(super) fn new(bytes: &'a [u8], encoding: Encoding, header_lines: usize) -> Self {
        match encoding {
            Encoding::Ascii => Self::Text(Words { rest: bytes, line: header_lines as u32 + 1 }),
            Encoding::LittleEndian => Self::Binary(Cursor::little_endian(bytes)),
            Encoding::BigEndian => Self::Binary(Cursor::big_endian(bytes)),
        }
    }

    /// Number of bytes left to read.
    pub(super) fn left(&self) -> usize {
        match self {
            Self::Text(words) => words.rest.len(),
            Self::Binary(cursor) => cursor.left(),
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
            let message =
                format!("{} has a list of {count} numbers, more than the file holds", what());
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
        let word = match self {
            Self::Binary(cursor) => return cursor.number(kind).ok_or_else(|| ended(what)),
            Self::Text(words) => words.next().ok_or_else(|| ended(what))?,
        };
        let number = std::str::from_utf8(word).ok().and_then(|text| text.parse::<f64>().ok());
        number.ok_or_else(|| {
            let shown: String = String::from_utf8_lossy(word).chars().take(40).collect();
            self.here(Diagnostic::error(
                "mesh-syntax",
                format!("`{shown}` in {} is not a number", what()),
            ))
            .into()
        })
    }

    /// Adds the current line to a diagnostic where the source is text.
    pub(super) fn here(&self, diagnostic: Diagnostic) -> Diagnostic {
        match self {
            Self::Text(words) => diagnostic.at(LineColumn { line: words.line, column: 1 }),
            Self::Binary(_) => diagnostic,
        }
    }
}

fn ended(what: &dyn Fn() -> String) -> ImportProblem {
    Diagnostic::error("mesh-truncated", format!("the file ends within {}", what())).into()
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|b| !b.is_ascii_whitespace())?;
        self.line += self.rest[..start].iter().filter(|&&b| b == b'\n').count() as u32;
        let rest = &self.rest[start..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.rest = &rest[length..];
        Some(&rest[..length])
    }
}
