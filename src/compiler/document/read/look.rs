//! Reading a look.

use std::collections::HashSet;

use super::reader::{Fields, Reader};
use crate::diag::Diagnostic;
use crate::document::json::{At, Kind};
use crate::document::shape::{
    self, BOOKMARK, DEFINITION, DIRECTION_KEY, DIRECTION_KEYS, EXPOSED, FRAME, INTERFACE_PORT,
    LIGHT, LOOK, NODE, NOTE, TIME_KEY, TIME_KEYS, WIRE,
};
use crate::document::{
    Bookmark, Definition, DirectionKey, DirectionKeys, Driver, Exposed, Frame, Graph,
    InterfacePort, KeyDirection, Light, Look, Node, Note, OutputPort, Target, TimeKey, TimeKeys,
    Unknown, Value, Wire,
};
use crate::ids::{NodeId, ObjectId, is_slug, make_slug};

/// The look at the top of a document.
pub(super) fn look(r: &mut Reader<'_>, at: At) -> Option<Look> {
    let mut fields = r.object(at, &LOOK)?;
    top(r, &mut fields);
    r.color_space = r.word(&fields, "color_space").unwrap_or_default();
    Some(Look {
        name: r.text(&fields, "name").unwrap_or_default(),
        about: r.text(&fields, "about").unwrap_or_default(),
        color_space: r.color_space,
        tier: r.word(&fields, "tier").unwrap_or_default(),
        tuned: r.text(&fields, "tuned").unwrap_or_default(),
        lights: r.map(&mut fields, "lights", light),
        graph: graph(r, &mut fields),
        definitions: r.map(&mut fields, "definitions", |r, at, _| definition(r, at)),
        exposed: exposed(r, &mut fields),
        direction_keys: direction_keys(r, &fields),
        time_keys: time_keys(r, &fields),
        unknown: fields.unknown,
    })
}

/// What looks and scenes begin with.
pub(super) fn top(r: &mut Reader<'_>, fields: &mut Fields) {
    r.field(fields, "chiaro", |r, at, kind| match kind {
        crate::document::shape::Kind::Word(words) => r.word_at(at, words),
        _ => None,
    });
    r.number(fields, "version");
    if let Some(schema) = r.text(fields, "$schema") {
        fields.unknown.insert("$schema".to_owned(), schema.into());
    }
}

/// A light of a look or a scene.
pub(super) fn light(r: &mut Reader<'_>, at: At, extras: &mut Unknown) -> Option<Light> {
    let fields = r.object(at, &LIGHT)?;
    let normal = Light::default();
    let light = Light {
        name: r.text(&fields, "name").unwrap_or_default(),
        kind: r.word(&fields, "type").unwrap_or_default(),
        space: r.word(&fields, "space").unwrap_or_default(),
        direction: r.array(&fields, "direction").unwrap_or(normal.direction),
        position: r.array(&fields, "position").unwrap_or(normal.position),
        aim: r.array(&fields, "aim").unwrap_or(normal.aim),
        inner: r.number(&fields, "inner").unwrap_or(normal.inner),
        outer: r.number(&fields, "outer").unwrap_or(normal.outer),
        color: r
            .field(&fields, "color", |r, at, _| r.color_at(at, false))
            .and_then(|color| color.try_into().ok())
            .unwrap_or(normal.color),
        intensity: r.number(&fields, "intensity").unwrap_or(normal.intensity),
        half_distance: r.number(&fields, "half_distance").unwrap_or(normal.half_distance),
        range: r.number(&fields, "range").unwrap_or(normal.range),
    };
    *extras = fields.unknown;
    Some(light)
}

/// The nodes, wires and frames of a look or a definition.
fn graph(r: &mut Reader<'_>, fields: &mut Fields) -> Graph {
    let mut graph = Graph { nodes: nodes(r, fields), ..Graph::default() };
    let mut shadows = Vec::new();
    graph.wires = r.items(fields, "wires", |r, at| {
        let (wire, unknown) = wire(r, at)?;
        if !unknown.is_empty() {
            shadows.push((wire.to.to_string(), unknown));
        }
        Some(wire)
    });
    for (to, unknown) in shadows {
        fields.shadow("wires", Some(&to), unknown);
    }
    graph.frames = r.map(fields, "frames", frame);
    graph.notes = r.map(fields, "notes", note);
    graph.bookmarks =
        parts(r, fields, "bookmarks", |bookmark: &Bookmark| bookmark.key.to_string(), bookmark);
    graph
}

fn wire(r: &mut Reader<'_>, at: At) -> Option<(Wire, Unknown)> {
    let fields = r.object(at, &WIRE)?;
    let (from, to) = (r.endpoint(&fields, "from"), r.endpoint(&fields, "to"));
    Some((Wire { from: from?, to: to? }, fields.unknown))
}

/// The nodes by id; who gives no id gets that of its kind.
fn nodes(r: &mut Reader<'_>, fields: &mut Fields) -> indexmap::IndexMap<NodeId, Node> {
    let found = r.list(fields, "nodes", |r, at| node(r, at).map(|(id, node)| (at, id, node)));
    let given: HashSet<NodeId> = found.iter().filter_map(|(_, (_, id, _))| id.clone()).collect();
    let mut nodes = indexmap::IndexMap::with_capacity(found.len());
    let mut kept = Vec::with_capacity(found.len());
    for (index, (at, id, node)) in found {
        let is_given = id.is_some();
        let id = id.unwrap_or_else(|| node.kind.as_str().into());
        let problem = if !is_slug(id.as_str()) {
            Diagnostic::error("missing-field", "the node needs an `id`, as its kind cannot be one")
                .hint(format!(
                    "write \"id\": \"{}\"",
                    make_slug(id.as_str(), |slug| given.contains(slug))
                ))
        } else if nodes.contains_key(&id) || (!is_given && given.contains(&id)) {
            let free =
                make_slug(id.as_str(), |slug| given.contains(slug) || nodes.contains_key(slug));
            let which = if is_given { "" } else { " (the node's kind, as no `id` is given)" };
            Diagnostic::error(
                "duplicate-id",
                format!("another node has the id `{id}`{which}; this one is left out"),
            )
            .hint(format!("write \"id\": \"{free}\""))
        } else {
            kept.push(index);
            nodes.insert(id, node);
            continue;
        };
        r.report_item("nodes", index, at, problem);
    }
    r.keep("nodes", kept);
    nodes
}

fn node(r: &mut Reader<'_>, at: At) -> Option<(Option<NodeId>, Node)> {
    let mut fields = r.object(at, &NODE)?;
    let id = r.slug::<NodeId>(&fields, "id");
    let kind = r.text(&fields, "kind");
    // A node whose id is broken has none; one without a kind can be told by its id until it gets
    // one.
    let has_broken_id = id.is_none() && fields.get("id").is_some();
    let is_some = !has_broken_id && (id.is_some() || kind.is_some());
    let node = Node {
        kind: kind.unwrap_or_default(),
        name: r.text(&fields, "name").unwrap_or_default(),
        position: r.array(&fields, "at").unwrap_or_default(),
        values: r.values(&mut fields),
        tier: r.word(&fields, "tier"),
        muted: r.bool(&fields, "muted").unwrap_or_default(),
        collapsed: r.bool(&fields, "collapsed").unwrap_or_default(),
        unknown: fields.unknown,
    };
    is_some.then_some((id, node))
}

fn frame(r: &mut Reader<'_>, at: At, extras: &mut Unknown) -> Option<Frame> {
    let fields = r.object(at, &FRAME)?;
    // Frames are part of the editor, not of the picture: their colors are always as shown.
    let space = std::mem::take(&mut r.color_space);
    let frame = Frame {
        title: r.text(&fields, "title").unwrap_or_default(),
        color: r.field(&fields, "color", |r, at, _| r.color_at(at, false)).unwrap_or_default(),
        nodes: r.items(&fields, "nodes", |r, at| r.slug_at(at).map(NodeId::from)),
    };
    r.color_space = space;
    *extras = fields.unknown;
    Some(frame)
}

fn note(r: &mut Reader<'_>, at: At, extras: &mut Unknown) -> Option<Note> {
    let fields = r.object(at, &NOTE)?;
    let space = std::mem::take(&mut r.color_space);
    let note = Note {
        text: r.text(&fields, "text").unwrap_or_default(),
        position: r.array(&fields, "at").unwrap_or_default(),
        width: r.number(&fields, "width").unwrap_or(Note::WIDTH),
        color: r.field(&fields, "color", |r, at, _| r.color_at(at, false)).unwrap_or_default(),
    };
    r.color_space = space;
    *extras = fields.unknown;
    Some(note)
}

fn bookmark(r: &mut Reader<'_>, at: At) -> Option<(Bookmark, Unknown)> {
    let fields = r.object(at, &BOOKMARK)?;
    let key = r.number(&fields, "key");
    let position = r.array(&fields, "at").unwrap_or_default();
    let zoom = r.number(&fields, "zoom").unwrap_or(1.0);
    Some((Bookmark { key: key? as u8, position, zoom }, fields.unknown))
}

fn definition(r: &mut Reader<'_>, at: At) -> Option<Definition> {
    let mut fields = r.object(at, &DEFINITION)?;
    Some(Definition {
        label: r.text(&fields, "label").unwrap_or_default(),
        help: r.text(&fields, "help").unwrap_or_default(),
        inputs: interface(r, &mut fields, "inputs"),
        outputs: interface(r, &mut fields, "outputs"),
        graph: graph(r, &mut fields),
        unknown: fields.unknown,
    })
}

fn interface(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Vec<InterfacePort> {
    parts(
        r,
        fields,
        name,
        |port: &InterfacePort| port.name.to_string(),
        |r, at| {
            let mut fields = r.object(at, &INTERFACE_PORT)?;
            let port = InterfacePort {
                name: r.slug(&fields, "name").unwrap_or_default(),
                label: r.text(&fields, "label"),
                help: r.text(&fields, "help"),
                default: r.value(&mut fields, "default"),
                min: r.number(&fields, "min"),
                max: r.number(&fields, "max"),
            };
            (!port.name.as_str().is_empty()).then_some((port, fields.unknown))
        },
    )
}

fn exposed(r: &mut Reader<'_>, fields: &mut Fields) -> Vec<Exposed> {
    parts(
        r,
        fields,
        "exposed",
        |exposed: &Exposed| exposed.name.to_string(),
        |r, at| {
            let fields = r.object(at, &EXPOSED)?;
            let (name, target) = (r.slug(&fields, "name"), r.target(&fields, "target"));
            let label = r.text(&fields, "label").unwrap_or_default();
            Some((Exposed { name: name?, target: target?, label }, fields.unknown))
        },
    )
}

fn direction_keys(r: &mut Reader<'_>, fields: &Fields) -> Vec<DirectionKeys> {
    r.items(fields, "direction_keys", |r, at| {
        let fields = r.object(at, &DIRECTION_KEYS)?;
        let name = r.text(&fields, "name").unwrap_or_default();
        let by = r.field(&fields, "by", |r, at, _| key_direction(r, at));
        let scheme = r.word(&fields, "scheme").unwrap_or_default();
        let axes = by.as_ref().and_then(KeyDirection::axes);
        let keys = r.items(&fields, "keys", |r, at| direction_key(r, at, axes));
        Some(DirectionKeys { name, by: by?, scheme, keys, unknown: fields.unknown })
    })
}

/// A key of a set by so many drivers, or by a direction.
fn direction_key(r: &mut Reader<'_>, at: At, axes: Option<usize>) -> Option<DirectionKey> {
    let mut fields = r.object(at, &DIRECTION_KEY)?;
    let direction = match axes {
        Some(axes) => place_of_key(r, at, &fields, axes),
        None => direction_of_key(r, at, &fields),
    };
    let mut shadows = Vec::new();
    let values = r.field(&fields, "values", |r, at, kind| {
        r.members::<Target, Value>(at, kind, |r, member, key| {
            let target = r.target_from(member, key);
            let mut extras = Unknown::new();
            let value = r.value_at(member, &mut extras);
            shadows.push((key.to_owned(), extras));
            Some((target?, value?))
        })
    });
    for (key, extras) in shadows {
        fields.shadow("values", Some(&key), extras);
    }
    Some(DirectionKey {
        direction: direction?,
        values: values.unwrap_or_default(),
        unknown: fields.unknown,
    })
}

fn direction_of_key(r: &mut Reader<'_>, at: At, fields: &Fields) -> Option<[f64; 3]> {
    if fields.get("direction").is_none() {
        let problem = Diagnostic::error("missing-field", "`direction` is missing");
        r.report(at, problem.hint("write where the key lies: \"direction\": [0, 0, 1]"));
        return None;
    }
    r.array(fields, "direction")
}

fn place_of_key(r: &mut Reader<'_>, at: At, fields: &Fields, axes: usize) -> Option<[f64; 3]> {
    let numbers = ["0"; Driver::MOST][..axes.min(Driver::MOST)].join(", ");
    if fields.get("at").is_none() {
        let problem = Diagnostic::error("missing-field", "`at` is missing");
        r.report(
            at,
            problem.hint(format!(
                "write where the key lies, one number a driver: \"at\": [{numbers}]"
            )),
        );
        return None;
    }
    r.field(fields, "at", |r, at, _| {
        let found = r.numbers_at(at, axes, axes, shape::FAR)?;
        let mut place = [0.0; 3];
        place.iter_mut().zip(found).for_each(|(slot, number)| *slot = number);
        Some(place)
    })
}

fn drivers(r: &mut Reader<'_>, at: At) -> Option<KeyDirection> {
    let tree = r.tree;
    let items: Vec<At> =
        if tree.kind(at) == Kind::List { tree.children(at).collect() } else { Vec::new() };
    if items.is_empty() || items.len() > Driver::MOST {
        let problem = Diagnostic::error("wrong-count", "one to three drivers decide between keys");
        r.report(
            at,
            problem.hint(
                "write a list, such as [\"distance\"] or [\"facing\", {\"height\": \"key\"}]",
            ),
        );
        return None;
    }
    let read: Vec<Option<Driver>> = items.into_iter().map(|at| driver(r, at)).collect();
    read.into_iter().collect::<Option<Vec<_>>>().map(KeyDirection::Drivers)
}

fn driver(r: &mut Reader<'_>, at: At) -> Option<Driver> {
    match r.tree.string(at).as_deref() {
        Some("distance") => return Some(Driver::Distance),
        Some("facing") => return Some(Driver::Facing),
        _ if r.tree.kind(at) == Kind::Bad => return None,
        _ => {}
    }
    let is_alone = r.tree.children(at).count() == 1;
    let member = |name| r.tree.member(at, name).filter(|_| is_alone);
    let (height, near, wire) = (member("height"), member("near"), member("wire"));
    if let Some(light) = height {
        return r.slug_at(light).map(|id| Driver::Height(id.into()));
    }
    if let Some(object) = near {
        return r.slug_at(object).map(|id| Driver::Near(ObjectId::new(id)));
    }
    if let Some(wire) = wire {
        return output(r, wire).map(Driver::Wire);
    }
    let problem = Diagnostic::error("wrong-type", "this names no driver");
    let hint = "write \"distance\", \"facing\", {\"height\": \"a light's id\"}, \
                {\"near\": \"another object's id\"} or \
                {\"wire\": \"node.output\"}";
    r.report(at, problem.hint(hint));
    None
}

/// An output of a node, through groups.
fn output(r: &mut Reader<'_>, at: At) -> Option<OutputPort> {
    let text = r.tree.string(at).unwrap_or_default();
    let is_port = |port: &str| port.is_empty() || is_slug(port);
    let is_one = |output: &OutputPort| {
        output.node.ids().iter().all(|id| is_slug(id.as_str()))
            && is_port(output.port.as_str())
            && !text.ends_with('.')
    };
    let output = OutputPort::parse(&text).filter(is_one);
    if output.is_none() && r.tree.kind(at) != Kind::Bad {
        let shown: String = text.chars().take(80).collect();
        let problem =
            Diagnostic::error("bad-output", format!("`{shown}` names no output of a node"));
        r.report(at, problem.hint("write `node`, `node.output` or `group/node.output`"));
    }
    output
}

fn key_direction(r: &mut Reader<'_>, at: At) -> Option<KeyDirection> {
    let light = r.tree.member(at, "light").filter(|_| r.tree.children(at).count() == 1);
    if let Some(light) = light {
        return r.slug_at(light).map(|id| KeyDirection::Light(id.into()));
    }
    let list = r.tree.member(at, "drivers").filter(|_| r.tree.children(at).count() == 1);
    if let Some(list) = list {
        return drivers(r, list);
    }
    match r.tree.string(at).as_deref() {
        Some("view") => return Some(KeyDirection::View),
        _ if r.tree.kind(at) == Kind::Bad => return None,
        _ => {}
    }
    let problem = Diagnostic::error("wrong-type", "this names no direction");
    r.report(
        at,
        problem.hint(
            "write \"view\", {\"light\": \"the light's id\"}, or {\"drivers\": [\"distance\"]}",
        ),
    );
    None
}

fn time_keys(r: &mut Reader<'_>, fields: &Fields) -> Vec<TimeKeys> {
    r.items(fields, "time_keys", |r, at| {
        let fields = r.object(at, &TIME_KEYS)?;
        let target = r.target(&fields, "target");
        let keys = r.items(&fields, "keys", |r, at| {
            let mut fields = r.object(at, &TIME_KEY)?;
            let (time, value) = (r.number(&fields, "time"), r.value(&mut fields, "value"));
            let interpolation = r.word(&fields, "interpolation").unwrap_or_default();
            Some(TimeKey { time: time?, value: value?, interpolation, unknown: fields.unknown })
        });
        Some(TimeKeys { target: target?, keys, unknown: fields.unknown })
    })
}

/// The items of a list; their unknown fields are kept under what tells them apart.
fn parts<T>(
    r: &mut Reader<'_>,
    fields: &mut Fields,
    name: &'static str,
    identity: impl Fn(&T) -> String,
    read: impl Fn(&mut Reader<'_>, At) -> Option<(T, Unknown)>,
) -> Vec<T> {
    let read = r.items(fields, name, |r, at| read(r, at));
    let mut items = Vec::with_capacity(read.len());
    for (item, unknown) in read {
        fields.shadow(name, Some(&identity(&item)), unknown);
        items.push(item);
    }
    items
}
