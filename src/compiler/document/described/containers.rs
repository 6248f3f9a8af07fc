//! Optional values, lists, and maps by id, as parts of documents.

use std::hash::Hash;

use indexmap::IndexMap;

use super::{FieldType, part};
use crate::document::UnknownFields;
use crate::document::json::{JsonWriter, ValueIndex};
use crate::document::read::reader::Reader;
use crate::document::shape::FieldKind;
use crate::ids::is_slug;

/// Optional field: `None` where it is left out.
impl<T: FieldType> FieldType for Option<T> {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        T::read(r, at, kind, extras).map(Some)
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        match self {
            Some(value) => value.write(w, unknown),
            None => w.null(),
        }
    }

    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Some(a), Some(b)) => a.is_same(b),
            (None, None) => true,
            _ => false,
        }
    }
}

/// List of the items that could be read. Unknown fields of an item are kept under its identity.
impl<T: FieldType> FieldType for Vec<T> {
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let FieldKind::List(item_kind, _) = kind else { return None };
        let mut items = Self::new();
        let mut kept = Vec::new();
        let read = r.list_at(at, kind, |r, at| {
            let mut of_item = UnknownFields::new();
            T::read(r, at, item_kind, &mut of_item).map(|item| (item, of_item))
        })?;
        for (index, (item, of_item)) in read {
            if !of_item.is_empty() {
                extras.insert(item.identity(items.len()), of_item.into());
            }
            kept.push(index);
            items.push(item);
        }
        r.keep(kept);
        Some(items)
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        w.list(T::LISTED, self.iter().enumerate(), |w, (index, item)| {
            let of_item = unknown.and_then(|_| part(unknown, &item.identity(index)));
            item.write(w, of_item);
        });
    }

    fn is_same(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().zip(other).all(|(a, b)| a.is_same(b))
    }
}

/// Members of an object whose names are ids.
impl<K, T: FieldType> FieldType for IndexMap<K, T>
where
    K: From<String> + AsRef<str> + Hash + Eq,
{
    fn read(
        r: &mut Reader<'_>,
        at: ValueIndex,
        kind: &'static FieldKind,
        extras: &mut UnknownFields,
    ) -> Option<Self> {
        let FieldKind::Map(item_kind, _) = kind else { return None };
        r.members(at, kind, |r, member, key| {
            if !is_slug(key) {
                r.report_name(member, Reader::no_slug(key));
                return None;
            }
            let mut of_item = UnknownFields::new();
            let value = T::read(r, member, item_kind, &mut of_item)?;
            if !of_item.is_empty() {
                extras.insert(key.to_owned(), of_item.into());
            }
            Some((K::from(key.to_owned()), value))
        })
    }

    fn write(&self, w: &mut JsonWriter, unknown: Option<&UnknownFields>) {
        w.object(T::LISTED, |w| {
            for (key, value) in self {
                let key = key.as_ref();
                w.member(key, |w| value.write(w, part(unknown, key)));
            }
        });
    }

    fn is_same(&self, other: &Self) -> bool {
        let pairs = || self.iter().zip(other);
        self.len() == other.len() && pairs().all(|((a, x), (b, y))| a == b && x.is_same(y))
    }
}
