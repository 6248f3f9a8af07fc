//! Names of a function's values in a language.

use std::collections::HashSet;

/// Names that are taken, in a module or in a function of it.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    taken: HashSet<String>,
}

impl Names {
    /// Takes names that no value can have.
    pub(super) fn reserve(&mut self, names: impl IntoIterator<Item = String>) {
        self.taken.extend(names);
    }

    /// The name, or one like it that is free; it is taken from now on. A `_` at the end tells a
    /// name from a word of the language, a number from a value of the same name.
    pub(super) fn give(&mut self, wanted: &str) -> String {
        let wanted = if wanted.is_empty() { "value" } else { wanted };
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let candidates = [wanted.to_owned(), format!("{wanted}_")].into_iter().chain(numbered);
        for name in candidates {
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
        wanted.to_owned()
    }
}
