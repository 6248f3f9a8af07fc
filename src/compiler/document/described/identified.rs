//! Nodes and objects: lists in files, in which an item without an id gets one.

use std::collections::HashSet;

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::{Codec, DescribedObject, FieldType as _, PlainCodec};
use crate::diag::Diagnostic;
use crate::document::json::{JsonLayout, JsonWriter, ValueIndex};
use crate::document::read::reader::{Fields, Reader};
use crate::document::shape::FieldKind;
use crate::document::{Node, Object, UnknownFields};
use crate::ids::{NodeId, ObjectId, is_slug, make_slug};

/// Codec of the nodes by id; a node without an id gets that of its kind.
pub(in crate::document) struct Nodes;

impl Codec<IndexMap<NodeId, Node>> for Nodes {
    fn read(
        r: &mut Reader<'_>,
        fields: &mut Fields,
        name: &'static str,
    ) -> Option<IndexMap<NodeId, Node>> {
        r.field(fields, name, nodes)
    }

    fn write(w: &mut JsonWriter, nodes: &IndexMap<NodeId, Node>, _unknown: Option<&UnknownFields>) {
        w.list(JsonLayout::Lines, nodes, |w, (id, node)| write_with_id(w, id.as_str(), node));
    }

    fn is_left_out(
        value: &IndexMap<NodeId, Node>,
        default: &IndexMap<NodeId, Node>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value.is_same(default)
    }
}

/// Codec of the objects by id; an object without an id gets one from its mesh.
pub(in crate::document) struct Objects;

impl Codec<IndexMap<ObjectId, Object>> for Objects {
    fn read(
        r: &mut Reader<'_>,
        fields: &mut Fields,
        name: &'static str,
    ) -> Option<IndexMap<ObjectId, Object>> {
        r.field(fields, name, objects)
    }

    fn write(
        w: &mut JsonWriter,
        objects: &IndexMap<ObjectId, Object>,
        _unknown: Option<&UnknownFields>,
    ) {
        w.list(JsonLayout::Lines, objects, |w, (id, object)| write_with_id(w, id.as_str(), object));
    }

    fn is_left_out(
        value: &IndexMap<ObjectId, Object>,
        default: &IndexMap<ObjectId, Object>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value.is_same(default)
    }
}

fn write_with_id<T: DescribedObject>(w: &mut JsonWriter, id: &str, item: &T) {
    let unknown = item.own_unknown();
    w.shaped(T::LAYOUT.0, T::shape(), unknown, |w| {
        w.member("id", |w| w.string(id));
        item.write_members(w, unknown);
    });
}

/// Reads nodes by id; a node without an id gets that of its kind.
fn nodes(
    r: &mut Reader<'_>,
    at: ValueIndex,
    kind: &'static FieldKind,
) -> Option<IndexMap<NodeId, Node>> {
    let found = r.list_at(at, kind, |r, at| node(r, at).map(|(id, node)| (at, id, node)))?;
    let given: HashSet<NodeId> = found.iter().filter_map(|(_, (_, id, _))| id.clone()).collect();
    let mut nodes = IndexMap::with_capacity(found.len());
    let mut kept = Vec::with_capacity(found.len());
    for (index, (at, id, node)) in found {
        let is_given = id.is_some();
        let id = id.unwrap_or_else(|| node.kind.as_str().into());
        let problem = if !is_slug(id.as_str()) {
            Diagnostic::error(
                "missing-field",
                tr!("the node needs an `id`, as its kind cannot be one"),
            )
            .hint(tr!(
                "write \"id\": \"{id}\"",
                id = make_slug(id.as_str(), |slug| given.contains(slug))
            ))
        } else if nodes.contains_key(&id) || (!is_given && given.contains(&id)) {
            let free =
                make_slug(id.as_str(), |slug| given.contains(slug) || nodes.contains_key(slug));
            let which = if is_given { "" } else { tr!(" (the node's kind, as no `id` is given)") };
            Diagnostic::error(
                "duplicate-id",
                tr!("another node has the id `{id}`{which}; this one is left out"),
            )
            .hint(tr!("write \"id\": \"{free}\""))
        } else {
            kept.push(index);
            nodes.insert(id, node);
            continue;
        };
        r.report_item(index, at, problem);
    }
    r.keep(kept);
    Some(nodes)
}

fn node(r: &mut Reader<'_>, at: ValueIndex) -> Option<(Option<NodeId>, Node)> {
    let mut fields = r.object(at, Node::shape())?;
    let id: Option<NodeId> = PlainCodec::read(r, &mut fields, "id");
    let node = Node::from_fields(r, &mut fields)?;
    // A node with a broken id is dropped; a node without a kind can be named by its id until it
    // gets a kind.
    let has_broken_id = id.is_none() && fields.get("id").is_some();
    let given_kind = fields.get("kind").and_then(|at| r.tree.string(at));
    let has_kind = given_kind.is_some_and(|given| given == node.kind);
    (!has_broken_id && (id.is_some() || has_kind)).then_some((id, node))
}

/// Reads objects by id; an object without an id gets one from its mesh.
fn objects(
    r: &mut Reader<'_>,
    at: ValueIndex,
    kind: &'static FieldKind,
) -> Option<IndexMap<ObjectId, Object>> {
    let found = r.list_at(at, kind, |r, at| object(r, at).map(|(id, object)| (at, id, object)))?;
    let mut taken: HashSet<ObjectId> =
        found.iter().filter_map(|(_, (_, id, _))| id.clone()).collect();
    let mut objects = IndexMap::with_capacity(found.len());
    let mut kept = Vec::with_capacity(found.len());
    for (index, (at, id, object)) in found {
        let id = id.unwrap_or_else(|| {
            let made =
                ObjectId::from(make_slug(mesh_name(&object.mesh), |slug| taken.contains(slug)));
            taken.insert(made.clone());
            made
        });
        if objects.contains_key(&id) {
            let free = make_slug(id.as_str(), |slug| taken.contains(slug));
            let message = tr!("another object has the id `{id}`; this one is left out");
            let problem =
                Diagnostic::error("duplicate-id", message).hint(tr!("write \"id\": \"{free}\""));
            r.report_item(index, at, problem);
        } else {
            kept.push(index);
            objects.insert(id, object);
        }
    }
    r.keep(kept);
    Some(objects)
}

/// Name of a mesh: `sphere` of `shape:sphere`, `bunny` of `meshes/bunny.obj`.
fn mesh_name(mesh: &str) -> &str {
    let file = mesh.rsplit(['/', '\\', ':']).next().unwrap_or(mesh);
    file.split_once('.').map_or(file, |(stem, _)| stem)
}

fn object(r: &mut Reader<'_>, at: ValueIndex) -> Option<(Option<ObjectId>, Object)> {
    let mut fields = r.object(at, Object::shape())?;
    let id = PlainCodec::read(r, &mut fields, "id");
    Some((id, Object::from_fields(r, &mut fields)?))
}
