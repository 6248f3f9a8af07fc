//! Comments and blank lines of the functions that evaluate a look's graph.
//!
//! What comes of one group stands together, with a blank line and the group's name before it: a
//! layer reads like a paragraph. A node outside of groups mostly says all by itself, as its value
//! has the artist's name and its function that of the kind; where it does not, it has a comment.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::parts::Body;
use super::{Emitter, ValueId};
use crate::compile::functions::LINE;
use crate::compile::titles::readable;
use crate::library::Treatment;

/// Categories of nodes whose expressions need no words.
const PLAIN: [&str; 4] = ["input", "math", "utility", "vector"];

/// A statement of a function, as far as headings care.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Statement {
    /// The value of a node.
    Value(ValueId),
    /// The result of another function.
    Part,
    /// A loop over lights.
    Loop,
}

/// Lines before a statement.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Heading {
    /// True if a blank line stands before the statement.
    has_gap: bool,
    /// Name of the group whose values begin with the statement.
    group: Option<String>,
    /// True if the statement's node may have a comment of its own.
    is_alone: bool,
}

/// A stretch of statements that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Stretch {
    /// Values of a group, by the address of its label.
    Group(usize),
    /// Values of nodes outside of groups.
    Alone,
    /// Results of other functions.
    Parts,
    /// A loop, by its statement's index.
    Loop(usize),
}

impl Emitter<'_> {
    /// The lines before each of a function's statements.
    pub(super) fn headings(&self, statements: &[Statement]) -> Vec<Heading> {
        if self.options.unspecialized {
            return vec![Heading::default(); statements.len()];
        }
        let stretches = self.stretches(statements);
        let mut told: HashSet<usize> = HashSet::new();
        let mut headings = Vec::with_capacity(statements.len());
        for (index, &stretch) in stretches.iter().enumerate() {
            let before = index.checked_sub(1).map(|before| stretches[before]);
            let begins = before != Some(stretch);
            let mut heading = Heading { has_gap: begins && before.is_some(), ..Heading::default() };
            match stretch {
                Stretch::Group(group) if begins => {
                    let is_first = told.insert(group);
                    let mut own = statements[index..].iter().filter_map(|&s| self.group_of(s));
                    let value = own.find(|(own, _)| *own == group).map(|(_, value)| value);
                    heading.group = value.map(|value| self.group_title(value, is_first));
                }
                Stretch::Alone => heading.is_alone = true,
                Stretch::Group(_) | Stretch::Parts | Stretch::Loop(_) => {}
            }
            headings.push(heading);
        }
        headings
    }

    /// The stretch of each statement. A single value of a group of which more comes later is one
    /// that others read too: it stands with those.
    fn stretches(&self, statements: &[Statement]) -> Vec<Stretch> {
        let stretch = |(index, statement): (usize, &Statement)| match statement {
            Statement::Value(_) => {
                self.group_of(*statement).map_or(Stretch::Alone, |(group, _)| Stretch::Group(group))
            }
            Statement::Part => Stretch::Parts,
            Statement::Loop => Stretch::Loop(index),
        };
        let mut stretches: Vec<Stretch> = statements.iter().enumerate().map(stretch).collect();
        let numbered = stretches.iter().enumerate();
        let last: HashMap<Stretch, usize> = numbered.map(|(index, own)| (*own, index)).collect();
        for index in (0..stretches.len().saturating_sub(1)).rev() {
            let (own, next) = (stretches[index], stretches[index + 1]);
            let is_single = index.checked_sub(1).is_none_or(|before| stretches[before] != own);
            let is_of_groups = matches!((own, next), (Stretch::Group(_), Stretch::Group(_)));
            if is_of_groups && own != next && is_single && last.get(&own) > Some(&index) {
                stretches[index] = next;
            }
        }
        stretches
    }

    /// The group around a value's node, by the address of its label, with the value.
    fn group_of(&self, statement: Statement) -> Option<(usize, ValueId)> {
        let Statement::Value(id) = statement else { return None };
        let group = self.graph.nodes[self.special.values[id].node].group.as_ref()?;
        Some((Arc::as_ptr(group).addr(), id))
    }

    /// The artist's name of the group around a value, with the group's label where it says more.
    fn group_title(&self, value: ValueId, has_label: bool) -> String {
        let node = &self.graph.nodes[self.special.values[value].node];
        let Some(group) = &node.group else { return String::new() };
        let is_shared = self.loop_around(value).is_some() || self.of_all_lights.contains(&value);
        let name = if is_shared { &group.shared_name } else { &group.name };
        if has_label { titled(name, &group.label) } else { readable(name) }
    }

    /// Writes the lines before a statement that makes a value.
    pub(super) fn write_heading(
        &self,
        heading: &Heading,
        (id, statement): (ValueId, &str),
        depth: usize,
        body: &mut Body,
    ) {
        heading.write_gap(body);
        let own = heading.is_alone.then(|| self.own_title(id, statement)).flatten();
        if let Some(comment) = heading.group.clone().or(own) {
            write_comment(&comment, depth, body);
        }
    }

    /// A comment on a node outside of groups; `None` where the statement says it all.
    fn own_title(&self, id: ValueId, statement: &str) -> Option<String> {
        let node = &self.graph.nodes[self.special.values[id].node];
        let line = squashed(statement);
        let is_plain = PLAIN.contains(&node.def.category.as_str());
        let is_named =
            [&node.def.label, &node.def.kind].iter().any(|n| line.contains(&squashed(n)));
        // `mix(` says enough of what mixes colors.
        let word = node.def.label.split(' ').next().unwrap_or_default().to_lowercase();
        let is_called = statement.contains(&format!("{word}("));
        if is_plain || is_named || is_called || node.def.special == Treatment::Output {
            return None;
        }
        let name = self.name_without_light(id);
        let is_said = line.contains(&squashed(&name)) && !squashed(&name).is_empty();
        Some(if is_said { node.def.label.clone() } else { titled(&node.name, &node.def.label) })
    }
}

impl Heading {
    /// Writes the blank line before a statement.
    pub(super) fn write_gap(&self, body: &mut Body) {
        if self.has_gap {
            body.text.push('\n');
        }
    }
}

/// Writes a comment as one line.
fn write_comment(comment: &str, depth: usize, body: &mut Body) {
    let room = LINE - 4 * depth - "// ".len();
    let line: String =
        comment.chars().map(|c| if c.is_control() { ' ' } else { c }).take(room).collect();
    body.text.push_str(&"    ".repeat(depth));
    body.text.push_str("// ");
    body.text.push_str(line.trim_end());
    body.text.push('\n');
}

/// A name with a label in brackets, where that says more.
fn titled(name: &str, label: &str) -> String {
    let (own, of_kind) = (squashed(name), squashed(label));
    if own.is_empty() && !label.is_empty() && name.trim().is_empty() {
        label.to_owned()
    } else if own == of_kind || label.is_empty() {
        readable(name)
    } else {
        format!("{} ({label})", readable(name))
    }
}

/// Letters and digits of a text, to compare names with.
fn squashed(text: &str) -> String {
    let letters = text.chars().filter(|c| c.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_say_nothing_twice() {
        assert_eq!(titled("back_light", "Light layer"), "Back light (Light layer)");
        assert_eq!(titled("Light layer", "Light layer"), "Light layer");
        assert_eq!(titled("curvature_transition", "Curvature transition"), "Curvature transition");
        assert_eq!(titled("", "Profile"), "Profile");
        assert_eq!(titled("影", "Profile"), "影 (Profile)");
    }
}
