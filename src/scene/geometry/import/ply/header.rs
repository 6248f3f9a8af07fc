//! The header of a PLY file: its elements, and the properties of each.

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::geometry::import::cursor::NumberType;
use crate::geometry::import::report::{ImportProblem, ImportReport};
use crate::geometry::import::source::Source;

/// Greatest number of elements and of properties; files with more are refused. Real files have a
/// dozen.
const MAX_WORDS: usize = 256;

/// Encodings of the numbers behind the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// A property of an element: a number, or a list of numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Property {
    pub name: String,
    /// Type of the count before a list; `None` for a single number.
    pub list: Option<NumberType>,
    pub number: NumberType,
}

/// A kind of element, `vertex` or `face` or any other that the writer chose: `count` elements with
/// the same properties.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
}

impl Element {
    /// The least number of bytes that one element takes.
    pub(super) fn least_bytes(&self, encoding: Encoding) -> u64 {
        let sizes = self.properties.iter().map(|p| match encoding {
            // A digit and the divider from the next number; the very last number may lack the
            // divider.
            Encoding::Ascii => 2,
            _ => p.list.unwrap_or(p.number).size() as u64,
        });
        sizes.sum()
    }

    /// The index of the property with one of these names.
    pub(super) fn find(&self, names: &[&str]) -> Option<usize> {
        self.properties.iter().position(|p| names.contains(&p.name.as_str()))
    }
}

/// The header of a file, up to and with `end_header`.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Length of the header, which is also the offset of the numbers, in bytes.
    pub length: usize,
    /// Number of lines in the header.
    pub lines: usize,
}

/// Number of bytes in which the end of the header is looked for first.
const USUAL_LENGTH: u64 = 1 << 12;

/// Reads the header; `None` after an error that was reported.
///
/// # Errors
/// Where the file cannot be read, or its header does not end.
pub(super) fn read(
    file: &Source,
    report: &mut ImportReport,
) -> Result<Option<Header>, ImportProblem> {
    let mut looked = USUAL_LENGTH;
    loop {
        let head = file.head(looked)?;
        if let Some(extent) = extent(&head) {
            return Ok(parse(&head, extent, report));
        }
        if looked >= file.length() {
            let message = tr!("the header does not end: there is no line `end_header`");
            return Err(Diagnostic::error("mesh-truncated", message).into());
        }
        looked *= 8;
    }
}

/// Reads the header of a file's first bytes, whose length in bytes and in lines is `extent`.
fn parse(bytes: &[u8], extent: (usize, usize), report: &mut ImportReport) -> Option<Header> {
    let (length, lines) = extent;
    // Comments may be in any encoding; nothing else needs more than ASCII.
    let text = String::from_utf8_lossy(&bytes[..length]);
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let words: Vec<&str> = line.split_ascii_whitespace().take(6).collect();
        let understood = match words[..] {
            ["ply"] => number == 0,
            ["format", name, _version] => {
                encoding = match name {
                    "ascii" => Some(Encoding::Ascii),
                    "binary_little_endian" => Some(Encoding::LittleEndian),
                    "binary_big_endian" => Some(Encoding::BigEndian),
                    _ => None,
                };
                encoding.is_some()
            }
            ["element", name, count] => count.parse().is_ok_and(|count| {
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
                elements.len() <= MAX_WORDS
            }),
            ["property", ..] => match (property(&words), elements.last_mut()) {
                (Some(property), Some(element)) if element.properties.len() < MAX_WORDS => {
                    element.properties.push(property);
                    true
                }
                _ => false,
            },
            ["comment" | "obj_info", ..] | ["end_header"] | [] => true,
            _ => false,
        };
        if !understood {
            let shown: String = line.trim().chars().take(80).collect();
            report.error_at(
                &text,
                line,
                "mesh-syntax",
                tr!("`{shown}` is no line of a PLY header"),
            );
        }
    }
    if encoding.is_none() && !report.has_errors() {
        report.error("mesh-syntax", tr!("the header has no line `format`"));
    }
    Some(Header { encoding: encoding?, elements, length, lines }).filter(|_| !report.has_errors())
}

/// The length of the header in bytes and in lines, up to and with `end_header` and the end of its
/// line.
fn extent(bytes: &[u8]) -> Option<(usize, usize)> {
    let mut length = 0;
    for (number, line) in bytes.split_inclusive(|&b| b == b'\n').enumerate() {
        length += line.len();
        if line.trim_ascii() == b"end_header" && line.ends_with(b"\n") {
            return Some((length, number + 1));
        }
    }
    None
}

fn property(words: &[&str]) -> Option<Property> {
    match *words {
        ["property", "list", count, kind, name] => {
            // A count must be whole.
            let list = number(count).filter(|n| n.max().is_some())?;
            Some(Property { name: name.to_owned(), list: Some(list), number: number(kind)? })
        }
        ["property", kind, name] => {
            Some(Property { name: name.to_owned(), list: None, number: number(kind)? })
        }
        _ => None,
    }
}

fn number(name: &str) -> Option<NumberType> {
    Some(match name {
        "char" | "int8" => NumberType::I8,
        "uchar" | "uint8" => NumberType::U8,
        "short" | "int16" => NumberType::I16,
        "ushort" | "uint16" => NumberType::U16,
        "int" | "int32" => NumberType::I32,
        "uint" | "uint32" => NumberType::U32,
        "float" | "float32" => NumberType::F32,
        "double" | "float64" => NumberType::F64,
        _ => return None,
    })
}
