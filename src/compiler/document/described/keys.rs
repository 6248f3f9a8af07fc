//! Direction or drivers that decide between direction keys, and the place of each key.

use chiaro_locale::{text, tr};
use indexmap::IndexMap;

use super::{Codec, FieldType as _, PlainCodec, part};
use crate::diag::Diagnostic;
use crate::document::json::{JsonKind, JsonLayout, JsonWriter, ValueIndex};
use crate::document::read::reader::{Fields, Reader};
use crate::document::shape;
use crate::document::{Driver, KeyDirection, OutputPort, Target, UnknownFields, Value};
use crate::ids::{ObjectId, is_slug};

/// Codec of the direction or the drivers that decide between the keys of a set, and so how the
/// places of the keys after it are read.
pub(in crate::document) struct DecidedBy;

impl Codec<KeyDirection> for DecidedBy {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<KeyDirection> {
        let by = r.field(fields, name, |r, at, _| key_direction(r, at));
        r.key_axes = by.as_ref().and_then(KeyDirection::axes);
        by
    }

    fn write(w: &mut JsonWriter, by: &KeyDirection, _unknown: Option<&UnknownFields>) {
        match by {
            KeyDirection::View => w.string("view"),
            KeyDirection::Light(id) => {
                w.object(JsonLayout::Inline, |w| w.member("light", |w| w.string(id.as_str())));
            }
            KeyDirection::Drivers(drivers) => {
                w.object(JsonLayout::Inline, |w| {
                    w.member("drivers", |w| w.list(JsonLayout::Inline, drivers, write_driver));
                });
            }
        }
    }

    fn member(
        w: &mut JsonWriter,
        name: &str,
        by: &KeyDirection,
        _default: Option<&KeyDirection>,
        _unknown: Option<&UnknownFields>,
    ) {
        w.key_axes = by.axes();
        w.member(name, |w| Self::write(w, by, None));
    }

    fn is_left_out(
        value: &KeyDirection,
        default: &KeyDirection,
        _: Option<&UnknownFields>,
    ) -> bool {
        value == default
    }
}

/// Codec of a key's place: a direction, or one number for each deciding driver.
pub(in crate::document) struct KeyPlace;

impl Codec<[f64; 3]> for KeyPlace {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<[f64; 3]> {
        match r.key_axes {
            Some(axes) => place_of_key(r, fields, axes),
            None => direction_of_key(r, fields, name),
        }
    }

    fn write(w: &mut JsonWriter, place: &[f64; 3], _unknown: Option<&UnknownFields>) {
        match w.key_axes {
            Some(axes) => w.numbers(&place[..axes.min(Driver::MOST)]),
            None => w.numbers(place),
        }
    }

    fn is_left_out(value: &[f64; 3], default: &[f64; 3], unknown: Option<&UnknownFields>) -> bool {
        PlainCodec::is_left_out(value, default, unknown)
    }

    fn member(
        w: &mut JsonWriter,
        name: &str,
        place: &[f64; 3],
        _default: Option<&[f64; 3]>,
        _unknown: Option<&UnknownFields>,
    ) {
        let name = if w.key_axes.is_some() { "at" } else { name };
        w.member(name, |w| Self::write(w, place, None));
    }
}

fn direction_of_key(r: &mut Reader<'_>, fields: &Fields, name: &'static str) -> Option<[f64; 3]> {
    if fields.get(name).is_none() {
        let problem = Diagnostic::error("missing-field", tr!("`direction` is missing"));
        r.report(
            fields.at(),
            problem.hint(tr!("write where the key lies: \"direction\": [0, 0, 1]")),
        );
        return None;
    }
    r.field(fields, name, |r, at, kind| <[f64; 3]>::read(r, at, kind, &mut UnknownFields::new()))
}

fn place_of_key(r: &mut Reader<'_>, fields: &Fields, axes: usize) -> Option<[f64; 3]> {
    let numbers = ["0"; Driver::MOST][..axes.min(Driver::MOST)].join(", ");
    if fields.get("at").is_none() {
        let problem = Diagnostic::error("missing-field", tr!("`at` is missing"));
        r.report(
            fields.at(),
            problem.hint(tr!("write where the key lies, one number a driver: \"at\": [{numbers}]")),
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

fn key_direction(r: &mut Reader<'_>, at: ValueIndex) -> Option<KeyDirection> {
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
        _ if r.tree.kind(at) == JsonKind::Bad => return None,
        _ => {}
    }
    let problem = Diagnostic::error("wrong-type", tr!("this names no direction"));
    r.report(
        at,
        problem.hint(
            text!(
                "write \"view\", {\"light\": \"the light's id\"}, or {\"drivers\": [\"distance\"]}"
            )
            .tr(),
        ),
    );
    None
}

fn drivers(r: &mut Reader<'_>, at: ValueIndex) -> Option<KeyDirection> {
    let tree = r.tree;
    let items: Vec<ValueIndex> =
        if tree.kind(at) == JsonKind::List { tree.children(at).collect() } else { Vec::new() };
    if items.is_empty() || items.len() > Driver::MOST {
        let problem =
            Diagnostic::error("wrong-count", tr!("one to three drivers decide between keys"));
        r.report(
            at,
            problem.hint(
                text!(
                    "write a list, such as [\"distance\"] or [\"facing\", {\"height\": \"key\"}]"
                )
                .tr(),
            ),
        );
        return None;
    }
    let read: Vec<Option<Driver>> = items.into_iter().map(|at| driver(r, at)).collect();
    read.into_iter().collect::<Option<Vec<_>>>().map(KeyDirection::Drivers)
}

fn driver(r: &mut Reader<'_>, at: ValueIndex) -> Option<Driver> {
    match r.tree.string(at).as_deref() {
        Some("distance") => return Some(Driver::Distance),
        Some("facing") => return Some(Driver::Facing),
        _ if r.tree.kind(at) == JsonKind::Bad => return None,
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
    let problem = Diagnostic::error("wrong-type", tr!("this names no driver"));
    let hint = text!(
        "write \"distance\", \"facing\", {\"height\": \"a light's id\"}, \
                {\"near\": \"another object's id\"} or \
                {\"wire\": \"node.output\"}"
    )
    .tr();
    r.report(at, problem.hint(hint));
    None
}

/// Reads an output of a node, with the groups around it.
pub(super) fn output(r: &mut Reader<'_>, at: ValueIndex) -> Option<OutputPort> {
    let text = r.tree.string(at).unwrap_or_default();
    let is_port = |port: &str| port.is_empty() || is_slug(port);
    let is_one = |output: &OutputPort| {
        output.node.ids().iter().all(|id| is_slug(id.as_str()))
            && is_port(output.port.as_str())
            && !text.ends_with('.')
    };
    let output = OutputPort::parse(&text).filter(is_one);
    if output.is_none() && r.tree.kind(at) != JsonKind::Bad {
        let shown: String = text.chars().take(80).collect();
        let problem = Diagnostic::error("bad-output", tr!("`{shown}` names no output of a node"));
        r.report(at, problem.hint(tr!("write `node`, `node.output` or `group/node.output`")));
    }
    output
}

fn write_driver(w: &mut JsonWriter, driver: &Driver) {
    let named = |w: &mut JsonWriter, kind: &'static str, id: &str| {
        w.object(JsonLayout::Inline, |w| w.member(kind, |w| w.string(id)));
    };
    match driver {
        Driver::Distance => w.string("distance"),
        Driver::Facing => w.string("facing"),
        Driver::Height(light) => named(w, "height", light.as_str()),
        Driver::Near(object) => named(w, "near", object.as_str()),
        Driver::Wire(output) => named(w, "wire", &output.to_string()),
    }
}

/// Codec of a key's values, by target.
pub(in crate::document) struct TargetValues;

impl Codec<IndexMap<Target, Value>> for TargetValues {
    fn read(
        r: &mut Reader<'_>,
        fields: &mut Fields,
        name: &'static str,
    ) -> Option<IndexMap<Target, Value>> {
        let mut extras = UnknownFields::new();
        let values = r.field(fields, name, |r, at, kind| {
            r.members::<Target, Value>(at, kind, |r, member, key| {
                let target = r.target_from(member, key);
                let mut of_value = UnknownFields::new();
                let value = r.value_at(member, &mut of_value);
                let read = (target?, value?);
                if !of_value.is_empty() {
                    extras.insert(key.to_owned(), of_value.into());
                }
                Some(read)
            })
        });
        fields.shadow(name, extras);
        values
    }

    fn write(
        w: &mut JsonWriter,
        values: &IndexMap<Target, Value>,
        unknown: Option<&UnknownFields>,
    ) {
        w.object(JsonLayout::Inline, |w| {
            for (target, value) in values {
                let target = target.to_string();
                w.member(&target, |w| value.write(w, part(unknown, &target)));
            }
        });
    }

    fn is_left_out(
        value: &IndexMap<Target, Value>,
        default: &IndexMap<Target, Value>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value == default
    }
}
