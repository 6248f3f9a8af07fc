//! Languages that the window speaks.

use chiaro_locale::{Language, one_or_many};

/// The languages of the window, English first. A new one is a catalog and a row.
pub(crate) static LANGUAGES: [Language; 2] = [
    Language::new("en", "English", "", one_or_many),
    Language::new("de", "Deutsch", include_str!("../../locale/de.po"), one_or_many),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_has_the_forms_of_its_catalog() {
        for Language { tag, source, form, .. } in &LANGUAGES[1..] {
            let forms = (0..200).map(form).max().unwrap_or_default() + 1;
            let header = format!("\"Plural-Forms: nplurals={forms}; ");
            assert!(source.contains(&header), "{tag}.po counts otherwise");
            assert!(source.contains(&format!("\"Language: {tag}\\n\"")), "{tag}");
        }
    }
}
