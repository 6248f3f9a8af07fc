//! Writer of JSON in the canonical form.

use super::scan::format_number;
use crate::document::UnknownFields;
use crate::document::shape::ObjectShape;

/// Layout of an object or a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::document) enum JsonLayout {
    /// Layout with every member or item on a line of its own.
    Lines,
    /// Layout on one line.
    Inline,
}

/// Writer of one document.
pub(in crate::document) struct JsonWriter {
    text: String,
    /// Open objects and lists: the layout of each, and whether it has content already.
    open: Vec<(JsonLayout, bool)>,
    /// Text of numbers that are not finite.
    not_finite: &'static str,
    /// Number of drivers that decide between the direction keys of the set that is written; `None`
    /// where a direction does.
    pub(in crate::document) key_axes: Option<usize>,
}

impl JsonWriter {
    pub(in crate::document) fn new() -> Self {
        Self { text: String::new(), open: Vec::new(), not_finite: "null", key_axes: None }
    }

    /// Writer whose text is only read back, to see whether it can be.
    pub(in crate::document) fn trial() -> Self {
        Self { not_finite: "NaN", ..Self::new() }
    }

    /// Written text, with a line end at its end.
    pub(in crate::document) fn finish(mut self) -> String {
        self.text.push('\n');
        self.text
    }

    pub(in crate::document) fn null(&mut self) {
        self.text.push_str("null");
    }

    pub(in crate::document) fn bool(&mut self, value: bool) {
        self.text.push_str(if value { "true" } else { "false" });
    }

    /// Writes a finite number; others, which no document holds, become null, or NaN in a trial.
    pub(in crate::document) fn number(&mut self, number: f64) {
        if number.is_finite() {
            self.text.push_str(&format_number(number));
        } else {
            self.text.push_str(self.not_finite);
        }
    }

    pub(in crate::document) fn numbers(&mut self, numbers: &[f64]) {
        self.list(JsonLayout::Inline, numbers, |w, &number| w.number(number));
    }

    pub(in crate::document) fn string(&mut self, text: &str) {
        self.text.push_str(&serde_json::Value::from(text).to_string());
    }

    /// Writes any JSON on one line.
    pub(in crate::document) fn json(&mut self, value: &serde_json::Value) {
        match value {
            serde_json::Value::Object(members) => self.object(JsonLayout::Inline, |w| {
                for (name, value) in members {
                    w.member(name, |w| w.json(value));
                }
            }),
            serde_json::Value::Array(items) => self.list(JsonLayout::Inline, items, Self::json),
            other => self.text.push_str(&other.to_string()),
        }
    }

    /// Writes an object; `write` writes its members.
    pub(in crate::document) fn object(
        &mut self,
        layout: JsonLayout,
        write: impl FnOnce(&mut Self),
    ) {
        self.text.push('{');
        self.open.push((layout, false));
        write(self);
        self.close('}', layout == JsonLayout::Inline);
    }

    /// Writes a member of the open object.
    pub(in crate::document) fn member(&mut self, name: &str, write: impl FnOnce(&mut Self)) {
        self.separate(true);
        self.string(name);
        self.text.push_str(": ");
        write(self);
    }

    /// Writes a list of these items.
    pub(in crate::document) fn list<I: IntoIterator>(
        &mut self,
        layout: JsonLayout,
        items: I,
        mut write: impl FnMut(&mut Self, I::Item),
    ) {
        self.text.push('[');
        self.open.push((layout, false));
        for item in items {
            self.separate(false);
            write(self, item);
        }
        self.close(']', false);
    }

    /// Writes the members that the shape does not know, at the end of its object.
    pub(in crate::document) fn unknown(
        &mut self,
        shape: &'static ObjectShape,
        unknown: Option<&UnknownFields>,
    ) {
        for (name, value) in
            unknown.into_iter().flatten().filter(|(name, _)| shape.field(name).is_none())
        {
            self.member(name, |w| w.json(value));
        }
    }

    fn separate(&mut self, pad: bool) {
        let Some((layout, has_items)) = self.open.last_mut() else { return };
        let (layout, is_first) = (*layout, !std::mem::replace(has_items, true));
        if !is_first {
            self.text.push(',');
        }
        match layout {
            JsonLayout::Lines => self.new_line(),
            JsonLayout::Inline if !is_first || pad => self.text.push(' '),
            JsonLayout::Inline => {}
        }
    }

    fn close(&mut self, end: char, pad: bool) {
        if let Some((layout, true)) = self.open.pop() {
            match layout {
                JsonLayout::Lines => self.new_line(),
                JsonLayout::Inline if pad => self.text.push(' '),
                JsonLayout::Inline => {}
            }
        }
        self.text.push(end);
    }

    fn new_line(&mut self) {
        self.text.push('\n');
        for _ in 0..self.open.len() {
            self.text.push_str("  ");
        }
    }
}
