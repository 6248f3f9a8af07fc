//! Bytes of a glTF's buffers: from the chunks of a GLB, data URIs and files beside the glTF.

use std::io::Cursor;

use base64::Engine as _;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use chiaro_locale::tr;
use gltf::Document;
use gltf::buffer::Source as Place;

use crate::diag::Diagnostic;
use crate::files::OpenFile;
use crate::geometry::import::report::{ImportProblem, ImportReport};
use crate::geometry::import::source::Source;
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
pub(super) fn chunks<'f>(
    file: &Source<'f>,
) -> Result<(Source<'f>, Option<Source<'f>>), ImportProblem> {
    let short = || Box::new(Diagnostic::error("mesh-truncated", tr!("the GLB file is cut short")));
    let words = |offset: u64, count: u64| -> Result<Vec<u32>, ImportProblem> {
        let bytes = file.part(offset, 4 * count).ok_or_else(short)?.all()?;
        Ok(bytes.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect())
    };
    let [version, length] = words(4, 2)?[..] else { return Err(short()) };
    if version != 2 {
        let message = tr!("the GLB file has version {version}; only version 2 can be read");
        return Err(Diagnostic::error("mesh-unsupported", message).into());
    }
    if u64::from(length) > file.length() {
        return Err(short());
    }
    let (mut json, mut binary) = (None, None);
    let mut offset = 12;
    while file.length() - offset >= 8 {
        let [size, kind] = words(offset, 2)?[..] else { return Err(short()) };
        let chunk = file.part(offset + 8, size.into()).ok_or_else(short)?;
        offset += 8 + u64::from(size);
        match &kind.to_le_bytes() {
            b"JSON" => json = json.or(Some(chunk)),
            b"BIN\0" => binary = binary.or(Some(chunk)),
            // The specification asks readers to pass over other chunks.
            _ => {}
        }
    }
    Ok((json.ok_or_else(short)?, binary))
}

/// The buffers, those of a GLB and of files as they lie there. After an error there may be fewer.
pub(super) fn load<'f>(
    document: &Document,
    binary: Option<&Source<'f>>,
    siblings: Siblings,
    report: &mut ImportReport,
) -> Vec<Source<'f>> {
    let mut total = 0;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let bytes = match buffer.source() {
            Place::Bin => {
                binary.cloned().ok_or_else(|| tr!("the file has no binary chunk").to_owned())
            }
            Place::Uri(uri) => from_uri(uri, siblings)
                .and_then(|file| Source::whole(file).map_err(|why| why.to_string())),
        };
        let bytes = match bytes {
            Ok(bytes) => bytes,
            Err(why) => {
                let message = tr!("buffer {index} is missing: {why}", index = buffer.index());
                let problem = Diagnostic::error("mesh-reference", message);
                report.add(
                    problem.hint(tr!("keep the .bin file beside the .gltf, or export as .glb")),
                );
                continue;
            }
        };
        total += bytes.length();
        if total > MAX_FILE_BYTES {
            report.error(
                "mesh-too-large",
                tr!("the buffers have more than the {MAX_FILE_BYTES} bytes allowed"),
            );
            return Vec::new();
        }
        buffers.push(bytes);
    }
    buffers
}

/// Opens what a URI in a glTF names: data, or a file beside it.
///
/// # Errors
/// The reason why it cannot be read, in words that follow what is named.
pub(super) fn from_uri(uri: &str, siblings: Siblings) -> Result<Box<dyn OpenFile>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (kind, data) = data.split_once(',').ok_or_else(|| tr!("its data URI has no comma"))?;
        if !kind.ends_with(";base64") {
            return Err(tr!("its data URI is not in base64").to_owned());
        }
        let bytes = BASE64.decode(data.trim()).map_err(|_| tr!("its base64 is damaged"))?;
        return Ok(Box::new(Cursor::new(bytes)));
    }
    let path = decoded_path(uri)?;
    siblings(&path).map_err(|why| format!("`{path}`: {why}"))
}

/// The relative path that a URI means.
///
/// # Errors
/// The reason why it means none.
pub(super) fn decoded_path(uri: &str) -> Result<String, String> {
    let path = decode_percent(uri).ok_or_else(|| tr!("its name is not UTF-8"))?;
    let has_scheme = path.split('/').next().is_some_and(|first| first.contains(':'));
    if has_scheme || path.starts_with(['/', '\\']) {
        return Err(tr!("`{path}` is not a relative path"));
    }
    Ok(path)
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
        let decoded = |text: &str| {
            let file = from_uri(&format!("data:;base64,{text}"), &|_| Err(String::new())).ok()?;
            Source::whole(file).ok()?.all().ok()
        };
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
        let anything: Siblings = &|_| Ok(Box::new(Cursor::new([1])));
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
