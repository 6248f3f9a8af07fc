//! Tables of what becomes of a layer's values, as compositors read them: one column for each
//! channel in a `.cube`.

use std::fmt::Write as _;
use std::hash::Hasher as _;

use chiaro_locale::text;
use siphasher::sip::SipHasher13;

use crate::compile::TransferTable;
use crate::files::OutputKind;

/// Table of what becomes of a layer's values.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerTable {
    /// Name of the layer.
    pub layer: String,
    /// The table.
    pub table: TransferTable,
}

/// Table, as a file.
pub const CUBE: OutputKind<'static> =
    OutputKind { name: text!("a table").english(), is_own: &is_own, has_seal: false };

/// Beginning of a table's first line, before the checksum of all others.
const SEAL: &str = "# Chiaro ";

impl LayerTable {
    /// The file, as Adobe's Cube LUT 1.0 has it: values of the layer from `DOMAIN_MIN` to
    /// `DOMAIN_MAX`, beyond which the ends hold.
    pub fn cube(&self) -> Vec<u8> {
        let TransferTable { last, rows } = &self.table;
        let mut text = format!(
            "TITLE \"{}\"\nLUT_1D_SIZE {}\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX {last} {last} {last}\n",
            self.layer,
            rows.len(),
        );
        for [r, g, b] in rows {
            let [r, g, b] = [r, g, b].map(|x| *x as f32);
            let _ = writeln!(text, "{r} {g} {b}");
        }
        format!("{SEAL}{:016x}\n{text}", seal_of(&text)).into_bytes()
    }
}

fn seal_of(text: &str) -> u64 {
    let mut hasher = SipHasher13::new();
    hasher.write(text.as_bytes());
    hasher.finish()
}

/// True if a table is as Chiaro wrote it.
fn is_own(bytes: &[u8]) -> bool {
    let text = std::str::from_utf8(bytes).ok();
    let parts = text.and_then(|text| text.strip_prefix(SEAL)?.split_once('\n'));
    parts.is_some_and(|(seal, text)| u64::from_str_radix(seal, 16) == Ok(seal_of(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_known_until_it_is_changed() {
        let rows = vec![[0.0; 3], [0.25, 0.5, 1.0]];
        let table = LayerTable { layer: "a".to_owned(), table: TransferTable { last: 2.0, rows } };
        let bytes = table.cube();
        let text = String::from_utf8(bytes.clone()).unwrap();
        let lines: Vec<&str> = text.lines().skip(1).collect();
        let head = ["TITLE \"a\"", "LUT_1D_SIZE 2", "DOMAIN_MIN 0 0 0", "DOMAIN_MAX 2 2 2"];
        assert_eq!(lines[..4], head);
        assert_eq!(lines[4..], ["0 0 0", "0.25 0.5 1"]);
        assert!(is_own(&bytes));
        assert!(!is_own(text.replace("0.25", "0.26").as_bytes()) && !is_own(b"TITLE"));
    }
}
