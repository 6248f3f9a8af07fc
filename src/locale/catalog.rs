//! Catalog of a language: its texts by those of the source.

use std::collections::{HashMap, HashSet};
use std::sync::Mutex;

/// Texts of a language.
#[derive(Debug)]
pub(crate) enum Catalog {
    /// Forms by context and English text; a text that does not count has one.
    Read(HashMap<String, HashMap<String, Vec<String>>>),
    /// English within marks, for tests.
    Marked(MarkedTexts),
}

/// Texts within marks, each kept for as long as the process runs.
#[derive(Debug)]
pub(crate) struct MarkedTexts {
    /// Contexts and texts that are marked; `None` for all.
    listed: Option<HashSet<(String, String)>>,
    known: Mutex<HashMap<String, &'static str>>,
}

impl Catalog {
    /// Reads a catalog in gettext's PO format. What is not translated, or in doubt, is left out; a
    /// catalog that cannot be read is empty. Tests hold that neither is so.
    pub(crate) fn read(source: &str) -> Self {
        let mut contexts: HashMap<String, HashMap<String, Vec<String>>> = HashMap::new();
        if let Ok(catalog) = polib::po_file::parse_from_reader(source.as_bytes()) {
            for message in catalog.messages() {
                if !message.is_translated() || message.is_fuzzy() {
                    continue;
                }
                let forms = match message.msgstr_plural() {
                    Ok(forms) if message.is_plural() => forms.clone(),
                    _ => message.msgstr().map(|text| vec![text.to_owned()]).unwrap_or_default(),
                };
                let context = message.msgctxt().unwrap_or_default().to_owned();
                contexts.entry(context).or_default().insert(message.msgid().to_owned(), forms);
            }
        }
        Self::Read(contexts)
    }

    /// Catalog that marks the texts of a list in gettext's PO format; where it is empty, all.
    pub(crate) fn marked(list: &str) -> Self {
        let list = (!list.is_empty()).then(|| polib::po_file::parse_from_reader(list.as_bytes()));
        let listed = list.and_then(Result::ok).map(|list| {
            let messages = list.messages().map(|message| {
                (message.msgctxt().unwrap_or_default().to_owned(), message.msgid().to_owned())
            });
            messages.collect()
        });
        Self::Marked(MarkedTexts { listed, known: Mutex::default() })
    }

    /// Text of a context.
    pub(crate) fn find(&'static self, context: &str, text: &str) -> Option<&'static str> {
        match self {
            Self::Read(contexts) => contexts.get(context)?.get(text)?.first().map(String::as_str),
            Self::Marked(texts) => texts.mark(context, text, text),
        }
    }

    /// Form of a text that counts, and `english` where there is none.
    pub(crate) fn form(
        &'static self,
        one: &str,
        english: &'static str,
        form: usize,
    ) -> &'static str {
        match self {
            Self::Read(contexts) => {
                let forms = contexts.get("").and_then(|texts| texts.get(one));
                forms.and_then(|forms| forms.get(form)).map_or(english, String::as_str)
            }
            Self::Marked(texts) => texts.mark("", one, english).unwrap_or(english),
        }
    }
}

impl MarkedTexts {
    /// Text within marks, if what it is listed by is listed. An empty one stays empty, and one that
    /// is marked is not marked again.
    fn mark(&self, context: &str, listed_by: &str, text: &str) -> Option<&'static str> {
        let key = || (context.to_owned(), listed_by.to_owned());
        if self.listed.as_ref().is_some_and(|listed| !listed.contains(&key())) {
            return None;
        }
        let mut known = self.known.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(marked) = known.get(text) {
            return Some(marked);
        }
        let marked = if text.trim().is_empty() || text.starts_with('«') {
            text.to_owned()
        } else {
            format!("«{text}»")
        };
        let marked: &'static str = Box::leak(marked.into_boxed_str());
        known.insert(text.to_owned(), marked);
        Some(marked)
    }
}
