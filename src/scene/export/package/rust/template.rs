//! Templates of source files, with sections that only some looks need.
//!
//! - `{{name}}` is a place that a text fills.
//! - A line `//@lines name` is a place of whole lines; they are as far in as that line.
//! - Lines from `//@if name` to `//@end` stay where the look has what `name` says; `!name` where it
//!   has not, `a&b` where it has both. Sections may lie in others.

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::ExportFile;

/// Contents of the templates of a package.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Template {
    sections: BTreeSet<&'static str>,
    places: BTreeMap<&'static str, String>,
    lines: BTreeMap<&'static str, Vec<String>>,
}

impl Template {
    /// Keeps the sections of a name, where `is_there`.
    pub(in super::super) fn section(&mut self, name: &'static str, is_there: bool) {
        if is_there {
            self.sections.insert(name);
        }
    }

    /// Fills a place.
    pub(in super::super) fn place(&mut self, name: &'static str, text: impl Into<String>) {
        self.places.insert(name, text.into());
    }

    /// Fills a place of whole lines.
    pub(in super::super) fn lines(&mut self, name: &'static str, lines: Vec<String>) {
        self.lines.insert(name, lines);
    }

    /// True if sections of the name stay.
    pub(in super::super) fn has(&self, name: &str) -> bool {
        self.sections.contains(name)
    }

    fn holds(&self, condition: &str) -> bool {
        condition.split('&').all(|name| match name.strip_prefix('!') {
            Some(name) => !self.has(name),
            None => self.has(name),
        })
    }

    /// The text of a template.
    pub(in super::super) fn text(&self, template: &str) -> String {
        let mut text = String::new();
        let mut open: Vec<bool> = Vec::new();
        for line in template.lines() {
            let found = line.trim_start();
            if let Some(condition) = found.strip_prefix("//@if ") {
                open.push(self.holds(condition));
            } else if found == "//@end" {
                open.pop();
            } else if open.iter().all(|is_kept| *is_kept) {
                // What is left out has lines without text on both sides.
                let is_second = line.is_empty() && (text.is_empty() || text.ends_with("\n\n"));
                if !is_second {
                    self.line(line, &mut text);
                }
            }
        }
        text
    }

    fn line(&self, line: &str, text: &mut String) {
        if let Some((indent, name)) = line.split_once("//@lines ") {
            for inner in self.lines.get(name).into_iter().flatten() {
                *text += format!("{indent}{inner}").trim_end();
                text.push('\n');
            }
            return;
        }
        let mut line = line.to_owned();
        for (name, value) in &self.places {
            line = line.replace(&format!("{{{{{name}}}}}"), value);
        }
        *text += line.trim_end();
        text.push('\n');
    }

    /// A file of a template.
    pub(in super::super) fn file(&self, name: &str, template: &str) -> ExportFile {
        ExportFile::text(name.to_owned(), self.text(template))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_and_places_are_filled() {
        let mut template = Template::default();
        template.section("a", true);
        template.place("word", "filled");
        template.lines("more", vec!["x".into(), "y".into()]);
        let text = "1 {{word}}\n//@if a\n2\n  //@if a&!b\n3\n  //@end\n//@if b\n4\n//@end\n//@end\n\
                    //@if !a\n5\n//@end\n  //@lines more\n  //@lines nothing\n6";
        assert_eq!(template.text(text), "1 filled\n2\n3\n  x\n  y\n6\n");
    }
}
