//! Chiaro's texts in the language of its user.
//!
//! A text stands in English where it is used, as `tr!("Add layer")`, and in a table's row as
//! `text!("Lights")`. `chiaro.pot` lists all of them, with those of the nodes and the examples;
//! `de.po` and its like are the catalogs, in gettext's format, which every translator's tool reads.
//! A new language is a file and a row of [`LANGUAGES`]. Only the window speaks another language
//! than English: what scripts read stays as it is.

// The macros name this crate.
extern crate self as chiaro_locale;

mod catalog;
mod fill;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

pub use chiaro_locale_macros::{text, tr, trn};
pub use fill::fill;

use crate::catalog::Catalog;

/// Language that the window speaks.
#[derive(Debug)]
pub struct Language {
    /// Tag of BCP 47: `de`.
    pub tag: &'static str,
    /// Name of the language in itself.
    pub name: &'static str,
    /// Catalog in gettext's PO format; empty for English, which stands in the source.
    pub source: &'static str,
    /// Index of the form of a text that counts to a number, in the order of the catalog.
    pub form: fn(u64) -> usize,
    catalog: OnceLock<Catalog>,
}

impl Language {
    const fn new(
        tag: &'static str,
        name: &'static str,
        source: &'static str,
        form: fn(u64) -> usize,
    ) -> Self {
        Self { tag, name, source, form, catalog: OnceLock::new() }
    }

    fn catalog(&self) -> &Catalog {
        self.catalog.get_or_init(|| {
            if self.tag == MARKED { Catalog::marked() } else { Catalog::read(self.source) }
        })
    }
}

/// Tag of the language for tests: English with every text that was looked up within « and ».
pub const MARKED: &str = "qps";

fn one_or_many(count: u64) -> usize {
    usize::from(count != 1)
}

/// The languages of the window, English first.
pub static LANGUAGES: [Language; 2] = [
    Language::new("en", "English", "", one_or_many),
    Language::new("de", "Deutsch", include_str!("de.po"), one_or_many),
];

static MARKED_LANGUAGE: Language = Language::new(MARKED, "«English»", "", one_or_many);

/// Index of the language that is spoken; that of the marked one is beyond the list.
static SPOKEN: AtomicUsize = AtomicUsize::new(0);

/// Speaks a language from now on, in the whole process; one that is not known is English.
pub fn speak(tag: &str) {
    let index = match tag {
        MARKED => LANGUAGES.len(),
        _ => LANGUAGES.iter().position(|language| language.tag == tag).unwrap_or(0),
    };
    SPOKEN.store(index, Ordering::Relaxed);
}

/// Language that is spoken.
pub fn spoken() -> &'static Language {
    LANGUAGES.get(SPOKEN.load(Ordering::Relaxed)).unwrap_or(&MARKED_LANGUAGE)
}

/// Language of the system that is among [`LANGUAGES`], by the first that the user prefers.
pub fn of_system() -> &'static Language {
    let known = sys_locale::get_locales().find_map(|tag| {
        let primary = tag.split(['-', '_']).next().unwrap_or_default().to_lowercase();
        LANGUAGES.iter().find(|language| language.tag == primary)
    });
    known.unwrap_or(&LANGUAGES[0])
}

/// Text in the language that is spoken; a text that the catalog lacks stays in English.
pub fn tr(text: &str) -> &str {
    if SPOKEN.load(Ordering::Relaxed) == 0 {
        return text;
    }
    spoken().catalog().find("", text).unwrap_or(text)
}

/// Text of a context; without one of its own, that of the same words in no context.
pub fn tr_in<'a>(context: &str, text: &'a str) -> &'a str {
    if SPOKEN.load(Ordering::Relaxed) == 0 {
        return text;
    }
    let catalog = spoken().catalog();
    catalog.find(context, text).or_else(|| catalog.find("", text)).unwrap_or(text)
}

/// Form of a text that counts, in the language that is spoken. See the macro of the same name.
pub fn trn(one: &'static str, many: &'static str, count: u64) -> &'static str {
    let language = spoken();
    let english = if count == 1 { one } else { many };
    if SPOKEN.load(Ordering::Relaxed) == 0 {
        return english;
    }
    language.catalog().form(one, english, (language.form)(count))
}

/// Text of a table's row: English in the source, and looked up when it is shown.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Text {
    context: &'static str,
    english: &'static str,
}

impl Text {
    /// Text of the table; written as `text!("...")`, so that it is listed for translators.
    pub const fn new(english: &'static str) -> Self {
        Self::of("", english)
    }

    /// Text of a context; written as `text!("tool" => "Fill")`.
    pub const fn of(context: &'static str, english: &'static str) -> Self {
        Self { context, english }
    }

    /// Text in the language that is spoken.
    pub fn tr(self) -> &'static str {
        tr_in(self.context, self.english)
    }

    /// Text as it stands in the source, for names that are kept and for search.
    pub const fn english(self) -> &'static str {
        self.english
    }
}

impl std::fmt::Display for Text {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.tr())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // The language is the process's, so that one test alone may change it.
    #[test]
    fn a_text_is_spoken_in_the_chosen_language() {
        let name = "Ada";
        assert_eq!(tr!("Cancel"), "Cancel");
        assert_eq!(tr!("{name} has {n:.1}", n = 2.25), "Ada has 2.2");
        assert_eq!(trn!(n = 1, "{n} layer", "{n} layers"), "1 layer");
        speak(MARKED);
        assert_eq!(tr!("Cancel"), "«Cancel»");
        assert_eq!(tr!("{name} has {n:.1}", n = 2.25), "«Ada has 2.2»");
        assert_eq!(trn!(n = 3, "{n} layer", "{n} layers"), "«3 layers»");
        speak("de");
        assert_eq!(spoken().name, "Deutsch");
        assert_eq!(tr("no catalog has this"), "no catalog has this");
        assert_eq!(text!("Cancel").tr(), "Abbrechen");
        speak("tlh");
        assert_eq!(text!("Cancel").tr(), "Cancel");
    }

    #[test]
    fn catalogs_read() {
        for language in &LANGUAGES[1..] {
            assert!(language.catalog().find("", "Cancel").is_some(), "{}", language.tag);
        }
    }
}
