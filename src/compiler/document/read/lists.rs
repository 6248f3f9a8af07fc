//! Reading of items of lists and members of objects.

use std::hash::Hash;

use chiaro_locale::{tr, trn};
use indexmap::IndexMap;

use super::reader::{PathStep, Reader};
use crate::diag::Diagnostic;
use crate::document::json::{JsonKind, ValueIndex};
use crate::document::shape;

impl Reader<'_> {
    /// Items of a list that could be read, each with its index in the text.
    pub(in crate::document) fn list_at<T>(
        &mut self,
        at: ValueIndex,
        kind: &'static shape::FieldKind,
        mut read: impl FnMut(&mut Self, ValueIndex) -> Option<T>,
    ) -> Option<Vec<(u32, T)>> {
        if self.tree.kind(at) != JsonKind::List {
            self.wrong_type(at, tr!("a list"));
            return None;
        }
        let tree = self.tree;
        let most = self.bounded(at, kind);
        let read_item = |(index, item)| {
            self.at_index(index, |r| read(r, item)).map(|value| (index as u32, value))
        };
        Some(tree.children(at).take(most).enumerate().filter_map(read_item).collect())
    }

    /// Remembers the indices in the text of the items that the value has of the reader's current
    /// list, unless they are the first ones without a gap.
    pub(in crate::document) fn keep(&mut self, indices: Vec<u32>) {
        if indices.iter().enumerate().any(|(own, &index)| own as u32 != index) {
            self.kept.insert(self.json_path(), indices);
        }
    }

    /// Members of an object with any names.
    pub(in crate::document) fn members<K: Hash + Eq, T>(
        &mut self,
        at: ValueIndex,
        kind: &'static shape::FieldKind,
        mut read: impl FnMut(&mut Self, ValueIndex, &str) -> Option<(K, T)>,
    ) -> Option<IndexMap<K, T>> {
        if self.tree.kind(at) != JsonKind::Object {
            self.wrong_type(at, tr!("an object"));
            return None;
        }
        let tree = self.tree;
        let most = self.bounded(at, kind);
        let mut map = IndexMap::new();
        for member in tree.children(at).take(most) {
            let key = tree.key(member);
            self.path.push(PathStep::Key(member));
            let entry = read(self, member, &key);
            self.path.pop();
            match entry {
                Some((id, _)) if map.contains_key(&id) => self.duplicate_key(member, &key),
                Some((id, value)) => drop(map.insert(id, value)),
                None => {}
            }
        }
        Some(map)
    }

    /// Number of items that are read; more are reported.
    fn bounded(&mut self, at: ValueIndex, kind: &shape::FieldKind) -> usize {
        let most = match kind {
            shape::FieldKind::List(_, most) | shape::FieldKind::Map(_, most) => *most,
            shape::FieldKind::Pair(_) => 2,
            _ => 10_000,
        };
        let count = self.tree.children(at).count();
        if count > most {
            let message = trn!(
                count,
                "there are {count} here; at most {most} are read",
                "there are {count} here; at most {most} are read"
            );
            self.report(at, Diagnostic::error("too-many", message));
        }
        most
    }
}
