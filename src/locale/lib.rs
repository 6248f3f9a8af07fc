//! Chiaro's texts in the language of its user.
//!
//! A text stands in English where it is used, as `tr!("Add layer")`, and in a table's row as
//! `text!("Lights")`. `chiaro.pot` lists all of them, with those of the nodes and the examples;
//! `de.po` and its like are the catalogs, in gettext's format, which every translator's tool reads.
//! The window has the list of its languages; it alone speaks another language than English: what
//! scripts read stays as it is.

// The macros name this crate.
extern crate self as chiaro_locale;

mod catalog;
mod fill;

use std::cell::Cell;
use std::sync::{OnceLock, PoisonError, RwLock};

pub use chiaro_locale_macros::{text, tr, trn};
pub use fill::fill;

use crate::catalog::Catalog;

/// Language that can be spoken.
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
    /// Language with a catalog, which is read when it is first spoken.
    pub const fn new(
        tag: &'static str,
        name: &'static str,
        source: &'static str,
        form: fn(u64) -> usize,
    ) -> Self {
        Self { tag, name, source, form, catalog: OnceLock::new() }
    }

    /// Language for tests: English with every text within « and » that was looked up and that a
    /// list has, in gettext's PO format. An empty list has all texts.
    pub const fn marked(list: &'static str) -> Self {
        Self::new(MARKED_TAG, "«English»", list, one_or_many)
    }

    fn catalog(&self) -> &Catalog {
        self.catalog.get_or_init(|| match self.tag {
            MARKED_TAG => Catalog::marked(self.source),
            _ => Catalog::read(self.source),
        })
    }
}

const MARKED_TAG: &str = "qps";
/// Tag of English, which has no catalog.
const ENGLISH_TAG: &str = "en";

/// Form of a text that counts where one alone is another form than all others.
pub fn one_or_many(count: u64) -> usize {
    usize::from(count != 1)
}

/// Language that is spoken; none is English.
static SPOKEN: RwLock<Option<&'static Language>> = RwLock::new(None);

/// Speaks a language from now on, in the whole process; none is English.
pub fn speak(language: Option<&'static Language>) {
    *SPOKEN.write().unwrap_or_else(PoisonError::into_inner) = language;
}

/// Language that is spoken; none is English.
pub fn spoken() -> Option<&'static Language> {
    if IS_ENGLISH.get() {
        return None;
    }
    *SPOKEN.read().unwrap_or_else(PoisonError::into_inner)
}

/// Tag of the language that is spoken: a message that was told under another tag is in other words
/// now.
pub fn spoken_tag() -> &'static str {
    spoken().map_or(ENGLISH_TAG, |language| language.tag)
}

thread_local! {
    /// True while texts of this thread go into a file.
    static IS_ENGLISH: Cell<bool> = const { Cell::new(false) };
}

/// Scope of English texts. Its end restores what was before, even where the work panics.
struct EnglishScope {
    was_english: bool,
}

impl Drop for EnglishScope {
    fn drop(&mut self) {
        IS_ENGLISH.set(self.was_english);
    }
}

/// Result of work on this thread whose texts are English in every language: those that go into
/// files, which are the same for all who open them.
pub fn in_english<T>(work: impl FnOnce() -> T) -> T {
    let _scope = EnglishScope { was_english: IS_ENGLISH.replace(true) };
    work()
}

/// Language of the system that is among these, by the first that the user prefers.
pub fn of_system(languages: &'static [Language]) -> Option<&'static Language> {
    sys_locale::get_locales().find_map(|tag| {
        let primary = tag.split(['-', '_']).next().unwrap_or_default().to_lowercase();
        languages.iter().find(|language| language.tag == primary)
    })
}

/// Text in the language that is spoken; a text that the catalog lacks stays in English.
pub fn tr(text: &str) -> &str {
    let spoken = spoken().and_then(|language| language.catalog().find("", text));
    spoken.unwrap_or(text)
}

/// Text of a context; without one of its own, that of the same words in no context.
pub fn tr_in<'a>(context: &str, text: &'a str) -> &'a str {
    let Some(language) = spoken() else { return text };
    let catalog = language.catalog();
    catalog.find(context, text).or_else(|| catalog.find("", text)).unwrap_or(text)
}

/// Form of a text that counts, in the language that is spoken. See the macro of the same name.
pub fn trn(one: &'static str, many: &'static str, count: u64) -> &'static str {
    let english = if count == 1 { one } else { many };
    let Some(language) = spoken() else { return english };
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

    static GERMAN: Language = Language::new(
        "de",
        "Deutsch",
        r#"msgid ""
msgstr ""
"Plural-Forms: nplurals=2; plural=(n != 1);\n"

msgid "Cancel"
msgstr "Abbrechen"

msgctxt "tool"
msgid "Fill"
msgstr "Füllen"

msgid "{n} layer"
msgid_plural "{n} layers"
msgstr[0] "{n} Ebene"
msgstr[1] "{n} Ebenen"
"#,
        one_or_many,
    );

    static MARKED: Language = Language::marked("");
    static LISTED: Language = Language::marked(
        r#"msgid ""
msgstr ""
"Plural-Forms: nplurals=2; plural=(n != 1);\n"

msgid "Cancel"
msgstr ""

msgctxt "tool"
msgid "Fill"
msgstr ""
"#,
    );

    // The language is the process's, so that one test alone may change it.
    #[test]
    fn a_text_is_spoken_in_the_chosen_language() {
        let name = "Ada";
        let layers = |n: usize| trn!(n, "{n} layer", "{n} layers");
        assert_eq!(tr!("Cancel"), "Cancel");
        assert_eq!(tr!("{name} has {n:.1}", n = 2.25), "Ada has 2.2");
        assert_eq!([1, 0].map(layers), ["1 layer", "0 layers"]);
        speak(Some(&MARKED));
        assert_eq!(tr!("Cancel"), "«Cancel»");
        assert_eq!(tr!("{name} has {n:.1}", n = 2.25), "«Ada has 2.2»");
        assert_eq!(layers(3), "«3 layers»");
        assert_eq!([spoken_tag(), in_english(spoken_tag)], ["qps", "en"]);
        speak(Some(&LISTED));
        assert_eq!([tr_in("tool", "Cancel"), tr_in("tool", "Fill")], ["«Cancel»", "«Fill»"]);
        assert_eq!([tr("Fill"), tr("no list has this")], ["Fill", "no list has this"]);
        speak(Some(&GERMAN));
        assert_eq!(tr("no catalog has this"), "no catalog has this");
        assert_eq!(text!("Cancel").tr(), "Abbrechen");
        assert_eq!(tr_in("button", "Cancel"), "Abbrechen", "it is the same in every context");
        assert_eq!([tr!("tool" => "Fill"), tr!("Fill")], ["Füllen", "Fill"]);
        assert_eq!([1, 2].map(layers), ["1 Ebene", "2 Ebenen"]);
        assert_eq!(
            in_english(|| [text!("Cancel").tr().to_owned(), layers(2)]),
            ["Cancel", "2 layers"]
        );
        assert_eq!(tr!("Cancel"), "Abbrechen", "for that work alone");
        speak(None);
        assert_eq!(text!("Cancel").tr(), "Cancel");
    }
}
