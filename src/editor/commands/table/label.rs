//! Label of a command: a text of the user's language, and names that stand in it as they are.

use std::borrow::Cow;
use std::fmt;

use chiaro_locale::{Text, fill};

/// Label of a command.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowLabel {
    text: Text,
    /// Names that stand in the text, by the words in its braces; without a word there is none.
    names: [(&'static str, &'static str); 2],
}

impl From<Text> for RowLabel {
    fn from(text: Text) -> Self {
        Self { text, names: [("", ""); 2] }
    }
}

impl RowLabel {
    /// The label with a name in the place of `{word}`.
    pub(super) fn with(self, word: &'static str, name: &'static str) -> Self {
        let [first, _] = self.names;
        Self { names: [(word, name), first], ..self }
    }

    /// The label in the language that is spoken.
    pub(crate) fn tr(&self) -> Cow<'static, str> {
        self.filled(self.text.tr())
    }

    /// The label as it stands in the source.
    pub(crate) fn english(&self) -> Cow<'static, str> {
        self.filled(self.text.english())
    }

    /// True if the label has all of these words, in the language that is spoken or in English.
    pub(crate) fn has(&self, words: &[&str]) -> bool {
        let text = format!("{} {}", self.tr(), self.english()).to_lowercase();
        words.iter().all(|word| text.contains(word))
    }

    /// True if the label begins with a word, in the language that is spoken or in English.
    pub(crate) fn begins_with(&self, word: &str) -> bool {
        [self.tr(), self.english()].iter().any(|text| text.to_lowercase().starts_with(word))
    }

    fn filled(&self, text: &'static str) -> Cow<'static, str> {
        match self.names {
            [("", _), _] => text.into(),
            [(a, first), (b, second)] => {
                fill(text, &[(a, format_args!("{first}")), (b, format_args!("{second}"))]).into()
            }
        }
    }
}

impl fmt::Display for RowLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.tr())
    }
}
