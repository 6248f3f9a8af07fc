//! Lists, and objects of things by name.

use std::hash::Hash;

use indexmap::IndexMap;

use super::reader::{Fields, Reader, Step};
use crate::diag::Diagnostic;
use crate::document::Unknown;
use crate::document::json::{At, Kind};
use crate::document::shape;
use crate::ids::is_slug;

impl Reader<'_> {
    /// The items of a list that could be read, each with its index in the text.
    pub(super) fn list<T>(
        &mut self,
        fields: &Fields,
        name: &'static str,
        mut read: impl FnMut(&mut Self, At) -> Option<T>,
    ) -> Vec<(u32, T)> {
        let items = self.field(fields, name, |r, at, kind| {
            if r.tree.kind(at) != Kind::List {
                r.wrong_type(at, "a list");
                return None;
            }
            let tree = r.tree;
            let most = r.bounded(at, kind);
            let read_item = |(index, item)| {
                r.at_index(index, |r| read(r, item)).map(|value| (index as u32, value))
            };
            Some(tree.children(at).take(most).enumerate().filter_map(read_item).collect())
        });
        items.unwrap_or_default()
    }

    /// The items of a list, and which ones they are in the text, for [`keep`](Self::keep).
    pub(super) fn items<T>(
        &mut self,
        fields: &Fields,
        name: &'static str,
        read: impl FnMut(&mut Self, At) -> Option<T>,
    ) -> Vec<T> {
        let (indices, items): (Vec<u32>, Vec<T>) =
            self.list(fields, name, read).into_iter().unzip();
        self.keep(name, indices);
        items
    }

    /// Remembers which items of a list the value has, if it does not have all before the last of
    /// them.
    pub(super) fn keep(&mut self, name: &'static str, indices: Vec<u32>) {
        if indices.iter().enumerate().any(|(own, &index)| own as u32 != index) {
            self.path.push(Step::Field(name));
            self.kept.insert(self.json_path(), indices);
            self.path.pop();
        }
    }

    /// The members of an object whose names are ids.
    pub(super) fn map<K: From<String> + Hash + Eq, T>(
        &mut self,
        fields: &mut Fields,
        name: &'static str,
        mut read: impl FnMut(&mut Self, At, &mut Unknown) -> Option<T>,
    ) -> IndexMap<K, T> {
        let mut shadows = Vec::new();
        let map = self.field(fields, name, |r, at, kind| {
            r.members(at, kind, |r, member, key| {
                if !is_slug(key) {
                    r.report_name(member, Self::no_slug(key));
                    return None;
                }
                let mut extras = Unknown::new();
                let value = read(r, member, &mut extras)?;
                if !extras.is_empty() {
                    shadows.push((key.to_owned(), extras));
                }
                Some((K::from(key.to_owned()), value))
            })
        });
        for (key, extras) in shadows {
            fields.shadow(name, Some(&key), extras);
        }
        map.unwrap_or_default()
    }

    /// The members of an object with any names.
    pub(super) fn members<K: Hash + Eq, T>(
        &mut self,
        at: At,
        kind: &'static shape::Kind,
        mut read: impl FnMut(&mut Self, At, &str) -> Option<(K, T)>,
    ) -> Option<IndexMap<K, T>> {
        if self.tree.kind(at) != Kind::Object {
            self.wrong_type(at, "an object");
            return None;
        }
        let tree = self.tree;
        let most = self.bounded(at, kind);
        let mut map = IndexMap::new();
        for member in tree.children(at).take(most) {
            let key = tree.key(member);
            self.path.push(Step::Key(member));
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

    /// How many items are read; more are told.
    fn bounded(&mut self, at: At, kind: &shape::Kind) -> usize {
        let most = match kind {
            shape::Kind::List(_, most) | shape::Kind::Map(_, most) => *most,
            _ => 10_000,
        };
        let count = self.tree.children(at).count();
        if count > most {
            let message = format!("there are {count} here; at most {most} are read");
            self.report(at, Diagnostic::error("too-many", message));
        }
        most
    }
}
