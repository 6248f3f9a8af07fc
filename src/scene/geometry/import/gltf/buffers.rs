//! Bytes of a glTF's buffers: from the chunks of a GLB, data URIs and files beside the glTF.

use std::borrow::Cow;

use base64::Engine as _;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use gltf::Document;
use gltf::buffer::Source;

use crate::diag::Diagnostic;
use crate::geometry::import::cursor::Cursor;
use crate::geometry::import::report::{ImportProblem, ImportReport};
use crate::geometry::import::{MAX_FILE_BYTES, Siblings};

/// Base64 as lenient as writers of glTF need: some forget the padding, some do not clear the last
/// bits.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

/// The JSON chunk and the binary chunk of a GLB.
///
/// # Errors
/// Where a chunk or the file is cut short, or the version is not 2.
pub(super) fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), ImportProblem> {
    let short = || Box::new(Diagnostic::error("mesh-truncated", "the GLB file is cut short"));
    let mut cursor = Cursor::little_endian(bytes);
    let _magic = cursor.take(4).ok_or_else(short)?;
    let version = cursor.u32().ok_or_else(short)?;
    if version != 2 {
        let message = format!("the GLB file has version {version}; only version 2 can be read");
        return Err(Diagnostic::error("mesh-unsupported", message).into());
    }
    let length = cursor.u32().ok_or_else(short)?;
    if u64::from(length) > bytes.len() as u64 {
        return Err(short());
    }
    let (mut json, mut binary) = (None, None);
    while cursor.left() >= 8 {
        let size = cursor.u32().ok_or_else(short)? as usize;
        let kind = cursor.take(4).ok_or_else(short)?;
        let chunk = cursor.take(size).ok_or_else(short)?;
        match kind {
            b"JSON" => json = json.or(Some(chunk)),
            b"BIN\0" => binary = binary.or(Some(chunk)),
            // The specification asks readers to pass over other chunks.
            _ => {}
        }
    }
    Ok((json.ok_or_else(short)?, binary))
}

/// The bytes of each buffer, those of a GLB as they lie in the file; an empty list of bytes for a
/// buffer that could not be read.
pub(super) fn load<'b>(
    document: &Document,
    binary: Option<&'b [u8]>,
    siblings: Siblings,
    report: &mut ImportReport,
) -> Vec<Cow<'b, [u8]>> {
    let mut total = 0;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let bytes = match buffer.source() {
            Source::Bin => {
                binary.map(Cow::Borrowed).ok_or_else(|| "the file has no binary chunk".to_owned())
            }
            Source::Uri(uri) => from_uri(uri, siblings).map(Cow::Owned),
        };
        let bytes = bytes.unwrap_or_else(|why| {
            let diagnostic = Diagnostic::error(
                "mesh-reference",
                format!("buffer {} is missing: {why}", buffer.index()),
            );
            report.add(diagnostic.hint("keep the .bin file beside the .gltf, or export as .glb"));
            Cow::default()
        });
        total += bytes.len() as u64;
        if total > MAX_FILE_BYTES {
            report.error(
                "mesh-too-large",
                format!("the buffers have more than the {MAX_FILE_BYTES} bytes allowed"),
            );
            return Vec::new();
        }
        buffers.push(bytes);
    }
    buffers
}

fn from_uri(uri: &str, siblings: Siblings) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (kind, data) = data.split_once(',').ok_or("its data URI has no comma")?;
        if !kind.ends_with(";base64") {
            return Err("its data URI is not in base64".to_owned());
        }
        return BASE64.decode(data.trim()).map_err(|_| "its base64 is damaged".to_owned());
    }
    let path = decode_percent(uri).ok_or("its name is not UTF-8")?;
    let has_scheme = path.split('/').next().is_some_and(|first| first.contains(':'));
    if has_scheme || path.starts_with(['/', '\\']) {
        return Err(format!("`{path}` is not a relative path"));
    }
    siblings(&path).map_err(|why| format!("`{path}`: {why}"))
}

fn decode_percent(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        let digit = |i: usize| tail.get(i).and_then(|&c| char::from(c).to_digit(16));
        rest = match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                &tail[2..]
            }
            _ => {
                bytes.push(*first);
                tail
            }
        };
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_signs() {
        assert_eq!(decode_percent("my%20mesh%2").as_deref(), Some("my mesh%2"));
        assert_eq!(decode_percent("%ff"), None);
    }

    #[test]
    fn base64_with_and_without_padding() {
        let decoded =
            |text: &str| from_uri(&format!("data:;base64,{text}"), &|_| Err(String::new())).ok();
        // The examples of RFC 4648.
        for (text, bytes) in [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYg==", "foob"),
            ("Zm9vYmFy", "foobar"),
        ] {
            assert_eq!(decoded(text).as_deref(), Some(bytes.as_bytes()), "{text}");
            assert_eq!(
                decoded(text.trim_end_matches('=')).as_deref(),
                Some(bytes.as_bytes()),
                "{text}"
            );
        }
        assert_eq!(decoded(" Zm9v\n").as_deref(), Some(&b"foo"[..]));
        assert_eq!(decoded("Zm9v!"), None);
        assert_eq!(decoded("Z"), None);
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(decoded(&BASE64.encode(&all)), Some(all));
    }

    #[test]
    fn only_relative_paths_are_followed() {
        let anything: Siblings = &|_| Ok(vec![1]);
        assert!(from_uri("a/b.bin", anything).is_ok());
        for uri in [
            "/etc/passwd",
            "file:///etc/passwd",
            "http://x/y",
            "\\\\host\\x",
            "data:,x",
            "data:;base64",
        ] {
            assert!(from_uri(uri, anything).is_err(), "{uri}");
        }
    }
}
