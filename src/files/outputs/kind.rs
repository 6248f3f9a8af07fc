//! Kinds of files that commands write, and the tests by which earlier outputs are recognized.

use chiaro_locale::text;
use flate2::Crc;

use crate::png::{self, AFTER_HEADER, SIGNATURE};

/// Kind of a file that a command writes.
#[derive(Clone, Copy)]
pub struct OutputKind<'a> {
    /// Name of the kind for people, such as "a picture"; empty where no earlier output can be
    /// recognized.
    pub name: &'a str,
    /// Test whether bytes are an earlier output of this kind, as Chiaro wrote it. Such a file is
    /// replaced unasked.
    pub is_own: &'a dyn Fn(&[u8]) -> bool,
    /// True if files of this kind are PNGs that are written with a seal.
    pub has_seal: bool,
}

impl OutputKind<'_> {
    /// Work of people: a look, a scene, an HCBTF, or an export to be painted on. Such a file is
    /// never replaced unasked.
    pub const DOCUMENT: OutputKind<'static> =
        OutputKind { name: "", is_own: &|_| false, has_seal: false };
    /// Rendered picture.
    pub const PICTURE: OutputKind<'static> =
        OutputKind { name: text!("a picture").english(), is_own: &is_sealed, has_seal: true };
    /// Drawing of a graph or a plot, as SVG.
    pub const DRAWING: OutputKind<'static> =
        OutputKind { name: text!("a drawing").english(), is_own: &is_drawing, has_seal: false };

    /// Script for another program, with the seal of [`sealed_script`] as its last line.
    pub const SCRIPT: OutputKind<'static> = OutputKind {
        name: text!("a script").english(),
        is_own: &is_sealed_script,
        has_seal: false,
    };

    pub(super) fn is_document(&self) -> bool {
        self.name.is_empty()
    }
}

/// Beginning of a seal, before its number.
const SEAL: &[u8] = b"tEXtSoftware\0Chiaro ";
/// Length of a seal, in bytes: the chunk's length and checksum, the words, and the number in
/// hexadecimal.
const SEAL_BYTES: usize = 4 + SEAL.len() + 8 + 4;

/// Adds a seal to a PNG: the name of the program that made it, which a PNG may hold, and a checksum
/// of all the rest. A picture that was painted on since does not match the checksum, even if the
/// painting program keeps the text. Bytes that are no PNG are returned as they are.
pub(super) fn sealed(png: &[u8]) -> Vec<u8> {
    if !png.starts_with(SIGNATURE) || png.len() < AFTER_HEADER || is_sealed(png) {
        return png.to_vec();
    }
    let (head, rest) = png.split_at(AFTER_HEADER);
    png::with_note(png, "Software", &format!("Chiaro {:08x}", checksum(&[head, rest])))
}

/// Beginning of the last line of a script, before its number: a comment, as many languages have it.
const SCRIPT_SEAL: &str = "# Chiaro ";

/// Adds a seal to a script: a comment at its end with a checksum of all the rest. A script that
/// somebody changed since does not match, and one that another program saved has lost the comment.
pub fn sealed_script(script: &str) -> String {
    let script = script.trim_end();
    let sum = checksum(&[script.as_bytes()]);
    format!("{script}\n{SCRIPT_SEAL}{sum:08x}\n")
}

/// True if a script is as Chiaro wrote it.
fn is_sealed_script(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    let script = text.trim_end().rsplit_once('\n').map(|(script, _)| script);
    script.is_some_and(|script| sealed_script(script) == text)
}

/// True if a PNG is as Chiaro wrote it.
fn is_sealed(png: &[u8]) -> bool {
    let Some((head, rest)) = png.split_at_checked(AFTER_HEADER) else { return false };
    let Some((seal, rest)) = rest.split_at_checked(SEAL_BYTES) else { return false };
    let number =
        seal[4..].strip_prefix(SEAL).and_then(|rest| std::str::from_utf8(rest.get(..8)?).ok());
    let number = number.and_then(|digits| u32::from_str_radix(digits, 16).ok());
    head.starts_with(SIGNATURE) && number == Some(checksum(&[head, rest]))
}

/// Checksum as PNGs have it, of the concatenated parts.
fn checksum(parts: &[&[u8]]) -> u32 {
    let mut crc = Crc::new();
    parts.iter().for_each(|part| crc.update(part));
    crc.sum()
}

/// True if a text is an SVG as Chiaro writes its graphs and plots. SVGs of other programs begin in
/// other ways, also those that such a program has edited.
fn is_drawing(bytes: &[u8]) -> bool {
    const BEGINS: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    const FACES: [&str; 2] = [
        "font-family=\"system-ui, sans-serif\" font-size=\"",
        "font-family=\"sans-serif\" font-size=\"",
    ];
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(400)]);
    let line = head.lines().next().unwrap_or_default();
    line.starts_with(BEGINS) && line.ends_with('>') && FACES.iter().any(|face| line.contains(face))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn png() -> Vec<u8> {
        use image::ImageEncoder as _;
        let mut bytes = Vec::new();
        let encoder = image::codecs::png::PngEncoder::new(&mut bytes);
        encoder.write_image(&[7; 4 * 6], 3, 2, image::ExtendedColorType::Rgba8).unwrap();
        bytes
    }

    #[test]
    fn a_sealed_picture_is_the_same_picture_and_known_until_it_is_changed() {
        let plain = png();
        assert!(!is_sealed(&plain));
        let mut with_seal = sealed(&plain);
        assert!(is_sealed(&with_seal) && sealed(&with_seal) == with_seal);
        let read = |bytes: &[u8]| image::load_from_memory(bytes).unwrap().to_rgba8();
        assert_eq!(read(&with_seal), read(&plain));
        for cut in 0..with_seal.len() {
            assert!(!is_sealed(&with_seal[..cut]), "{cut}");
        }
        // The seal's text stays, as with programs that keep unknown chunks, and the picture
        // differs.
        let last = with_seal.len() - 20;
        with_seal[last] ^= 1;
        assert!(!is_sealed(&with_seal));
        for other in [&b""[..], b"no PNG at all", SIGNATURE] {
            assert_eq!(sealed(other), other);
        }
    }

    #[test]
    fn a_script_is_known_until_a_letter_of_it_is_changed() {
        let script = sealed_script("Root {\n inputs 0\n}\n");
        assert!(is_sealed_script(script.as_bytes()), "{script}");
        assert_eq!(sealed_script("Root {\n inputs 0\n}"), script);
        for other in ["", "\n", "Root {\n}\n", &script.replace('0', "1"), &(script.clone() + "b\n")]
        {
            assert!(!is_sealed_script(other.as_bytes()), "{other}");
        }
    }

    #[test]
    fn drawings_of_other_programs_are_not_ours() {
        for other in [
            "",
            "{\"chiaro\": \"look\"}",
            "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 \
             1\" font-family=\"sans-serif\"/>",
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"></svg>",
        ] {
            assert!(!is_drawing(other.as_bytes()), "{other}");
        }
    }
}
