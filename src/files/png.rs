//! Notes in PNGs: `tEXt` chunks, which other programs pass over.

use flate2::Crc;

/// Signature at the beginning of a PNG.
pub(crate) const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// End of a PNG's header, in bytes: the signature, and one chunk of 13 bytes.
pub(crate) const AFTER_HEADER: usize = 8 + 12 + 13;

/// The PNG with a note behind its header; bytes that are no PNG stay as they are. Keyword and text
/// are ASCII.
pub fn with_note(png: &[u8], keyword: &str, text: &str) -> Vec<u8> {
    if !png.starts_with(SIGNATURE) || png.len() < AFTER_HEADER {
        return png.to_vec();
    }
    let words = [b"tEXt", keyword.as_bytes(), b"\0", text.as_bytes()].concat();
    let mut crc = Crc::new();
    crc.update(&words);
    let length = (words.len() as u32 - 4).to_be_bytes();
    let (head, rest) = png.split_at(AFTER_HEADER);
    [head, &length, &words, &crc.sum().to_be_bytes(), rest].concat()
}

/// The text of a note before the pixels; `None` where there is none of this keyword.
pub fn note(png: &[u8], keyword: &str) -> Option<String> {
    let mut rest = png.strip_prefix(SIGNATURE)?;
    loop {
        let (head, after) = rest.split_at_checked(8)?;
        let length = u32::from_be_bytes(head[..4].try_into().ok()?) as usize;
        let data = after.get(..length)?;
        match &head[4..] {
            b"tEXt" => {
                let found = data.strip_prefix(keyword.as_bytes());
                if let Some(text) = found.and_then(|text| text.strip_prefix(b"\0")) {
                    return String::from_utf8(text.to_vec()).ok();
                }
            }
            b"IDAT" | b"IEND" => return None,
            _ => {}
        }
        // The checksum follows the data.
        rest = after.get(length.checked_add(4)?..)?;
    }
}

#[cfg(test)]
mod tests {
    use image::ImageEncoder as _;

    use super::*;

    #[test]
    fn notes_are_read_and_change_no_pixel() {
        let mut plain = Vec::new();
        let encoder = image::codecs::png::PngEncoder::new(&mut plain);
        encoder.write_image(&[9; 4 * 6], 3, 2, image::ExtendedColorType::Rgba8).unwrap();
        assert_eq!(note(&plain, "plan"), None);
        let noted = with_note(&with_note(&plain, "plan", "abc"), "planner", "d");
        assert_eq!(note(&noted, "plan").as_deref(), Some("abc"));
        assert_eq!(note(&noted, "planner").as_deref(), Some("d"));
        let read = |bytes: &[u8]| image::load_from_memory(bytes).unwrap().to_rgba8();
        assert_eq!(read(&noted), read(&plain));
        for cut in 0..AFTER_HEADER + 12 {
            assert_eq!(note(&noted[..cut], "plan"), None, "{cut}");
        }
        assert_eq!(with_note(b"none", "plan", "abc"), b"none");
    }
}
