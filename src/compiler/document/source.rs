//! Places of a document's parts in the text that it was read from.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use super::json::{JsonKind, Tree, ValueIndex};
use super::problems::LineIndex;
use crate::diag::{Diagnostic, LineColumn};
use crate::ids::NodePath;

/// Result of reading a document.
#[derive(Clone, Debug)]
pub struct LoadedDocument<T> {
    /// Document, as far as it could be understood. `None` where the text is no document of this
    /// type, or one of a newer version: saving it would lose fields that this version does not
    /// know.
    pub value: Option<T>,
    /// Text, with the places of all its parts.
    pub source: SourceMap,
    /// Problems, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

impl<T> LoadedDocument<T> {
    /// True if a part of the text could not be understood. Saving the value over the file would
    /// lose that part.
    pub fn has_errors(&self) -> bool {
        crate::diag::has_errors(&self.diagnostics)
    }
}

/// Text with the places of all its parts.
#[derive(Clone, Debug)]
pub struct SourceMap {
    pub(super) file: String,
    pub(super) lines: LineIndex,
    pub(super) tree: Tree,
    /// Lists that lost items in reading: the index in the text of each item of the value, by the
    /// list's path.
    pub(super) kept: BTreeMap<String, Vec<u32>>,
}

impl SourceMap {
    /// Text as it was read.
    pub fn text(&self) -> &Arc<str> {
        self.tree.text()
    }

    /// File name, as the user gave it.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Fills in the file, line and column of a diagnostic that names a place in the document: a
    /// node (which is looked for by its id, through its groups) or a JSON path. Where the text has
    /// no such place, because a default was left out, the nearest part around it is taken. A place
    /// that is known already stays.
    pub fn locate(&self, diagnostic: &mut Diagnostic) {
        self.locate_all(std::slice::from_mut(diagnostic));
    }

    /// Fills in the places of all diagnostics, as [`locate`](Self::locate).
    pub fn locate_all(&self, diagnostics: &mut [Diagnostic]) {
        let mut finder = Finder::new(self);
        for diagnostic in diagnostics {
            finder.locate(diagnostic);
        }
    }

    /// Line and column of the value at a JSON path, or of the nearest part around it.
    pub fn place_of(&self, json_path: &str) -> Option<LineColumn> {
        let (at, _) = Finder::new(self).find_translated(json_path);
        at.map(|at| self.line_column(at))
    }

    /// The text without the item of a list, or the member of an object, at a JSON path; all else is
    /// as it was. `None` where the text has no such part.
    pub fn text_without(&self, json_path: &str) -> Option<String> {
        let mut finder = Finder::new(self);
        let (_, path) = finder.find_translated(json_path);
        let (at, is_whole) = finder.find(&path);
        at.filter(|_| is_whole && !path.is_empty()).map(|at| self.tree.without(at))
    }

    fn line_column(&self, at: ValueIndex) -> LineColumn {
        self.lines.at(self.text(), self.tree.start(at))
    }
}

/// Finder of places in a text. Each list and object that is looked into is gone through once,
/// however many places are looked for: a document may have 100,000 nodes, and a problem in each.
struct Finder<'s> {
    source: &'s SourceMap,
    items: HashMap<u32, Vec<ValueIndex>>,
    members: HashMap<u32, HashMap<Cow<'s, str>, ValueIndex>>,
    /// Indices of the nodes of a list, by their ids.
    nodes: HashMap<u32, HashMap<Cow<'s, str>, usize>>,
}

impl<'s> Finder<'s> {
    fn new(source: &'s SourceMap) -> Self {
        Self { source, items: HashMap::new(), members: HashMap::new(), nodes: HashMap::new() }
    }

    /// Fills in a diagnostic's place: see [`SourceMap::locate`].
    fn locate(&mut self, diagnostic: &mut Diagnostic) {
        let place = &mut diagnostic.place;
        if place.file.is_none() {
            place.file = Some(self.source.file.clone());
        }
        if place.at.is_some() {
            return;
        }
        if place.json_path.is_none()
            && let Some(node) = &place.node
        {
            // Nodes in a group of the library are not in the text; the group's node is.
            let mut around = std::iter::successors(Some(node.clone()), NodePath::parent);
            let path = around.find_map(|node| self.path_of_node(&node));
            let value =
                |path: &String| place.port.as_ref().map(|port| format!("{path}.values.{port}"));
            let value = path.as_ref().and_then(value).filter(|value| self.find(value).1);
            place.json_path = value.or(path);
        }
        if let Some(path) = &place.json_path {
            let (at, path_in_text) = self.find_translated(path);
            place.json_path = Some(path_in_text);
            place.at = at.map(|at| self.source.line_column(at));
        }
    }

    /// JSON path of a node, found by its id through the groups around it.
    fn path_of_node(&mut self, node: &NodePath) -> Option<String> {
        let (last, groups) = node.ids().split_last()?;
        let mut graph = String::new();
        for group in groups {
            let path = self.node_in(&graph, group.as_str())?;
            let kind =
                self.find(&format!("{path}.kind")).0.and_then(|at| self.source.tree.string(at))?;
            graph = member_path("definitions", &kind) + ".";
        }
        self.node_in(&graph, last.as_str())
    }

    fn node_in(&mut self, graph: &str, id: &str) -> Option<String> {
        let list = format!("{graph}nodes");
        let (Some(at), true) = self.find(&list) else { return None };
        let tree = &self.source.tree;
        let ids = self.nodes.entry(at.index()).or_insert_with(|| {
            let mut ids = HashMap::new();
            for (index, node) in tree.children(at).enumerate() {
                let name = tree.member(node, "id").or_else(|| tree.member(node, "kind"));
                if let Some(id) = name.and_then(|name| tree.string(name)) {
                    ids.entry(id).or_insert(index);
                }
            }
            ids
        });
        let index = ids.get(id)?;
        Some(format!("{list}[{index}]"))
    }

    /// Value at a path of the text, or the nearest part around it, and true if it is the value
    /// itself.
    fn find(&mut self, path: &str) -> (Option<ValueIndex>, bool) {
        let mut at = self.source.tree.root();
        for segment in segments(path) {
            let next = at.and_then(|at| self.step(at, &segment, None));
            if next.is_none() {
                return (at, false);
            }
            at = next;
        }
        (at, at.is_some())
    }

    /// Value at a path of the document, and its path in the text: the two paths differ where items
    /// were left out.
    fn find_translated(&mut self, path: &str) -> (Option<ValueIndex>, String) {
        let mut at = self.source.tree.root();
        let mut so_far = String::new();
        let mut whole = true;
        for segment in segments(path) {
            let kept = self.source.kept.get(&so_far);
            let index = match &segment {
                Segment::Index(index) => {
                    kept.map_or(Some(*index), |kept| kept.get(*index).map(|&kept| kept as usize))
                }
                Segment::Key(_) => None,
            };
            let next = at.and_then(|at| self.step(at, &segment, index)).filter(|_| whole);
            whole &= next.is_some();
            at = next.or(at);
            so_far = match segment {
                Segment::Key(key) => member_path(&so_far, &key),
                Segment::Index(original) => format!("{so_far}[{}]", index.unwrap_or(original)),
            };
        }
        (at, so_far)
    }

    fn step(
        &mut self,
        at: ValueIndex,
        segment: &Segment,
        index: Option<usize>,
    ) -> Option<ValueIndex> {
        let tree = &self.source.tree;
        match (segment, tree.kind(at)) {
            (Segment::Key(key), JsonKind::Object) => {
                let members = self.members.entry(at.index()).or_insert_with(|| {
                    let mut members = HashMap::new();
                    for member in tree.children(at) {
                        // Of two members with one name, the first counts.
                        members.entry(tree.key(member)).or_insert(member);
                    }
                    members
                });
                members.get(key.as_str()).copied()
            }
            (Segment::Index(own), JsonKind::List) => {
                let items =
                    self.items.entry(at.index()).or_insert_with(|| tree.children(at).collect());
                items.get(index.unwrap_or(*own)).copied()
            }
            _ => None,
        }
    }
}

/// Step of a JSON path.
#[derive(Debug, PartialEq)]
enum Segment {
    Key(String),
    Index(usize),
}

/// Steps of a path like `nodes[3].values.offset` or `looks["skin 2"]`.
fn segments(path: &str) -> Vec<Segment> {
    let mut found = Vec::new();
    let mut rest = path;
    while !rest.is_empty() {
        if let Some(inner) = rest.strip_prefix("[\"") {
            let quoted = quoted_length(inner);
            let key = serde_json::from_str(&format!("\"{}\"", &inner[..quoted]));
            found.push(Segment::Key(key.unwrap_or_else(|_| inner[..quoted].to_owned())));
            rest = &inner[quoted..];
            rest = rest.strip_prefix("\"]").unwrap_or("");
        } else if let Some(inner) = rest.strip_prefix('[') {
            let (index, after) = inner.split_once(']').unwrap_or((inner, ""));
            found.push(Segment::Index(index.parse().unwrap_or(usize::MAX)));
            rest = after;
        } else {
            let end = rest.find(['.', '[']).unwrap_or(rest.len());
            found.push(Segment::Key(rest[..end].to_owned()));
            rest = &rest[end..];
        }
        rest = rest.strip_prefix('.').unwrap_or(rest);
    }
    found
}

/// Length of the inside of a quoted key, in bytes.
fn quoted_length(inner: &str) -> usize {
    let mut escaped = false;
    for (i, c) in inner.char_indices() {
        match c {
            '"' if !escaped => return i,
            _ => escaped = c == '\\' && !escaped,
        }
    }
    inner.len()
}

/// Path of a member of the object at `path`: `.key`, or `["key"]` where the key is not a plain
/// word.
pub(super) fn member_path(path: &str, key: &str) -> String {
    let plain = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-$".contains(c));
    match (plain, path.is_empty()) {
        (true, true) => key.to_owned(),
        (true, false) => format!("{path}.{key}"),
        (false, _) => format!("{path}[{}]", serde_json::Value::from(key)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_list_is_gone_through_once() {
        let nodes: Vec<String> =
            (0..500).map(|i| format!(r#"{{"id": "n{i}", "kind": "k"}}"#)).collect();
        let text = format!(r#"{{"nodes": [{}]}}"#, nodes.join(",\n"));
        let source = crate::document::Look::read(&text, "a.json").source;
        let mut finder = Finder::new(&source);
        for i in (0..500).rev() {
            let node = NodePath::root(format!("n{i}").into());
            let mut problem = Diagnostic::error("test", "").node(node);
            finder.locate(&mut problem);
            assert_eq!(problem.place.at.map(|at| at.line), Some(i + 1));
            assert_eq!(problem.place.json_path, Some(format!("nodes[{i}]")));
        }
        // Lookups of the document, of its list of nodes by place, and by id. Nodes themselves are
        // not looked into.
        assert_eq!((finder.members.len(), finder.items.len(), finder.nodes.len()), (1, 1, 1));
    }

    #[test]
    fn paths_are_taken_apart() {
        let key = |key: &str| Segment::Key(key.to_owned());
        assert_eq!(
            segments("nodes[3].values.offset"),
            [key("nodes"), Segment::Index(3), key("values"), key("offset")]
        );
        assert_eq!(
            segments("looks[\"a]\\\".b\"][0]"),
            [key("looks"), key("a]\".b"), Segment::Index(0)]
        );
        assert_eq!(segments(""), []);
        // Composed paths come apart again.
        for name in ["plain", "two words", "a.b", "", "\"", "\\", "光", "[0]"] {
            assert_eq!(segments(&member_path("lights", name)), [key("lights"), key(name)]);
        }
        // Malformed paths give some steps, and no panic.
        for text in ["[", "]", "[\"", "a..b", ".", "[\"a", "[x]", "[\"\\"] {
            segments(text);
        }
    }
}
