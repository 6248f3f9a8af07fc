//! Values of looks and scenes by their addresses: `lights.key.color`, `objects.hero.visible`.
//!
//! An address goes down the fields of the canonical file, with ids in place of indices, so that
//! every field that files have can be addressed, and a new one needs nothing here. A value is set
//! by writing the part around it, putting the value in its place, and reading the part again: the
//! field's own reader judges it. Parts are single lights and objects, so that a value of a scene of
//! thousands is as quick to set as in a scene of one.

use chiaro_locale::{Text, text, tr, tr_in};
use indexmap::IndexMap;
use serde_json::Value as Json;

use crate::diag::{Diagnostic, has_errors};
use crate::document::described::{DescribedObject, FieldType as _};
use crate::document::json::JsonWriter;
use crate::document::read::read_unchecked;
use crate::document::shape::{FieldDefault, FieldKind, ObjectShape, ShapeField};
use crate::document::{LightField, Look, Scene, Target, TimeKey, TimeKeys, Value, check};
use crate::ids::{LightGroup, LightId, NodeId, ObjectId};

/// Fields that say what a document or a part is, and are no values.
const IDENTITY: [&str; 4] = ["chiaro", "version", "$schema", "id"];

/// Addresses of values of a look, in words.
const LOOK_ADDRESSES: Text = text!(
    "write `node.input`, `group/node.input`, `lights.light.field`, `nodes.node.field` or `tier`"
);

/// Way in which a value goes from key to key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlendKind {
    /// Number by number; words and switches hold until the next key.
    Numbers,
    /// Direction: it turns.
    Direction,
    /// Rotation: a quaternion, by the shorter way.
    Rotation,
}

/// Value of a document, found by its address.
#[derive(Clone, Debug, PartialEq)]
pub struct ValuePlace {
    /// The value, or its default, as files have it; null where nothing is set and a node has its
    /// own default.
    pub value: Json,
    /// Way in which it goes from key to key.
    pub blend: BlendKind,
}

impl Scene {
    /// The value at an address.
    ///
    /// # Errors
    /// What the address does not name, with the nearest name that there is.
    pub fn value_at(&self, address: &str) -> Result<ValuePlace, Diagnostic> {
        let mut json = json_of(&self.part(address)?);
        place(&mut json, Self::shape(), address).map(Slot::found)
    }

    /// Sets the value at an address.
    ///
    /// # Errors
    /// What the address does not name, or why the value cannot stand there.
    pub fn set_value(&mut self, address: &str, value: &Value) -> Result<(), Diagnostic> {
        let set: Self = with_value(&self.part(address)?, address, value)?;
        self.take_part(address, set);
        Ok(())
    }

    /// Checks that a value can stand at an address.
    ///
    /// # Errors
    /// The reason why it cannot.
    pub fn check_value(&self, address: &str, value: &Value) -> Result<(), Diagnostic> {
        with_value(&self.part(address)?, address, value).map(drop)
    }

    /// Keys of a field of a light in place of those that the scene has.
    pub fn key_light(&mut self, keys: TimeKeys) {
        key(&mut self.time_keys, keys);
    }

    /// A scene of nothing but the part that an address leads into.
    fn part(&self, address: &str) -> Result<Self, Diagnostic> {
        let (first, id) = first_steps(address);
        let part = match first {
            "objects" => {
                let objects = only::<ObjectId, _>(&self.objects, id, tr!("part" => "object"))?;
                Self { objects, ..Self::default() }
            }
            "lights" => {
                let lights = only::<LightId, _>(&self.lights, id, tr!("part" => "light"))?;
                Self { lights, ..Self::default() }
            }
            "light_groups" => {
                let mut light_groups = IndexMap::new();
                if crate::ids::is_slug(id) {
                    let group = LightGroup::from(id);
                    let master = self.light_groups.get(&group).cloned().unwrap_or_default();
                    light_groups.insert(group, master);
                }
                Self { light_groups, ..Self::default() }
            }
            _ => Self {
                name: self.name.clone(),
                about: self.about.clone(),
                muted: self.muted.clone(),
                soloed: self.soloed.clone(),
                illumination: self.illumination,
                camera: self.camera,
                file_camera: self.file_camera.clone(),
                backdrop: self.backdrop,
                outlines: self.outlines,
                time: self.time,
                ..Self::default()
            },
        };
        Ok(part)
    }

    /// Takes a part back that [`part`](Self::part) gave.
    fn take_part(&mut self, address: &str, part: Self) {
        match first_steps(address).0 {
            "objects" => self.objects.extend(part.objects),
            "lights" => self.lights.extend(part.lights),
            "light_groups" => self.light_groups.extend(part.light_groups),
            _ => {
                let own = std::mem::take(self);
                *self = Self {
                    objects: own.objects,
                    lights: own.lights,
                    light_groups: own.light_groups,
                    direction_keys: own.direction_keys,
                    time_keys: own.time_keys,
                    markers: own.markers,
                    unknown: own.unknown,
                    ..part
                };
            }
        }
    }
}

impl Look {
    /// The value at an address: a target, or a field of the look.
    ///
    /// # Errors
    /// What the address does not name, with the nearest name that there is.
    pub fn value_at(&self, address: &str) -> Result<ValuePlace, Diagnostic> {
        if let Some((target, _)) = self.input_at(address)? {
            let keyed = self.time_keys.iter().find(|track| track.target == target);
            let value = match (&keyed, &target) {
                (Some(track), _) => track.keys.first().map(|key| &key.value),
                (None, Target::Input { node, port }) => {
                    self.find(node).and_then(|found| found.node.values.get(port))
                }
                (None, Target::Light { .. }) => None,
            };
            return Ok(ValuePlace {
                value: value.map_or(Json::Null, json_of_value),
                blend: BlendKind::Numbers,
            });
        }
        let mut json = json_of(&self.part(address)?);
        place(&mut json, Self::shape(), address).map(Slot::found)
    }

    /// Sets the value at an address: a target, or a field of the look. Keys that the look has for
    /// the value go.
    ///
    /// # Errors
    /// What the address does not name, or why the value cannot stand there.
    pub fn set_value(&mut self, address: &str, value: &Value) -> Result<(), Diagnostic> {
        if let Some((target, own)) = self.input_at(address)? {
            match (own, &target) {
                (Some(id), Target::Input { port, .. }) => {
                    if let Some(node) = self.graph.nodes.get_mut(&id) {
                        node.values.insert(port.clone(), value.clone());
                    }
                    self.time_keys.retain(|track| track.target != target);
                }
                // Within a group a value belongs to every use of the group; a key is for this one.
                _ => {
                    let keys = vec![TimeKey::new(0.0, value.clone(), Default::default())];
                    self.key_value(TimeKeys { keys, ..TimeKeys::new(target) });
                }
            }
            return Ok(());
        }
        let set: Self = with_value(&self.part(address)?, address, value)?;
        match first_steps(address).0 {
            "lights" => {
                self.lights.extend(set.lights);
                let is_it = |target: &Target| target.to_string() == address;
                self.time_keys.retain(|track| !is_it(&track.target));
            }
            "nodes" => self.graph.nodes.extend(set.graph.nodes),
            _ => {
                (self.name, self.about, self.tuned) = (set.name, set.about, set.tuned);
                (self.tier, self.max_error, self.color_space) =
                    (set.tier, set.max_error, set.color_space);
            }
        }
        Ok(())
    }

    /// Checks that a value can stand at an address, as far as that is known without the library.
    ///
    /// # Errors
    /// The reason why it cannot.
    pub fn check_value(&self, address: &str, value: &Value) -> Result<(), Diagnostic> {
        match self.input_at(address)? {
            Some(_) => Ok(()),
            None => with_value(&self.part(address)?, address, value).map(drop),
        }
    }

    /// Keys of an input or of a field of a light in place of those that the look has.
    pub fn key_value(&mut self, keys: TimeKeys) {
        key(&mut self.time_keys, keys);
    }

    /// The input that an address names, and the id of its node where that is one of the look's own
    /// graph; `None` for a field of the look.
    fn input_at(&self, address: &str) -> Result<Option<(Target, Option<NodeId>)>, Diagnostic> {
        let (first, _) = first_steps(address);
        let is_node = self.graph.nodes.contains_key(first);
        if !is_node && Self::shape().field(first).is_some() {
            return Ok(None);
        }
        let target = Target::parse(address).filter(|target| matches!(target, Target::Input { .. }));
        let Some(target) = target else {
            let problem = Diagnostic::error("bad-target", tr!("`{address}` names no value"));
            let problem = problem.suggest(address, self.graph.nodes.keys().map(NodeId::as_str));
            return Err(problem.hint(LOOK_ADDRESSES.tr()));
        };
        if let Some(mut problem) = check::check_target(self, &target).into_iter().next() {
            problem.place = crate::diag::Place::default();
            return Err(problem);
        }
        let Target::Input { node, port } = &target else { return Ok(None) };
        let own = if let [id] = node.ids() { Some(id.clone()) } else { None };
        if let Some(wire) = own.as_ref().and_then(|id| self.graph.wire_into(id, port)) {
            let message = tr!("a wire from `{from}` leads into `{address}`", from = wire.from);
            return Err(Diagnostic::error("wired-input", message)
                .hint(tr!("change values of `{node}`, which decides", node = wire.from.node)));
        }
        Ok(Some((target, own)))
    }

    /// A look of nothing but the part that an address leads into.
    fn part(&self, address: &str) -> Result<Self, Diagnostic> {
        let (first, id) = first_steps(address);
        let mut part = Self { color_space: self.color_space, ..Self::default() };
        match first {
            "lights" => part.lights = only::<LightId, _>(&self.lights, id, tr!("part" => "light"))?,
            "nodes" => {
                part.graph.nodes = only::<NodeId, _>(&self.graph.nodes, id, tr!("part" => "node"))?;
            }
            "name" | "about" | "tuned" | "tier" | "max_error" | "color_space" => {
                part = Self {
                    name: self.name.clone(),
                    about: self.about.clone(),
                    tuned: self.tuned.clone(),
                    tier: self.tier,
                    max_error: self.max_error,
                    ..part
                };
            }
            _ => {
                let message = tr!("`{first}` of a look is not changed from outside");
                return Err(Diagnostic::error("bad-target", message).hint(LOOK_ADDRESSES.tr()));
            }
        }
        Ok(part)
    }
}

/// Target of an address that time keys can move: an input, or a field of the table of lights.
pub fn keyed_target(address: &str) -> Option<Target> {
    let target = Target::parse(address)?;
    let is_keyed = match &target {
        Target::Light { field, .. } => LightField::named(field).is_some(),
        Target::Input { .. } => true,
    };
    is_keyed.then_some(target)
}

fn key(tracks: &mut Vec<TimeKeys>, keys: TimeKeys) {
    match tracks.iter_mut().find(|track| track.target == keys.target) {
        Some(track) => *track = TimeKeys { unknown: std::mem::take(&mut track.unknown), ..keys },
        None => tracks.push(keys),
    }
}

/// The first two steps of an address; empty where there is none.
fn first_steps(address: &str) -> (&str, &str) {
    let mut steps = address.split('.');
    (steps.next().unwrap_or_default(), steps.next().unwrap_or_default())
}

/// The one of that id.
fn only<K, T: Clone>(
    all: &IndexMap<K, T>,
    id: &str,
    what: &str,
) -> Result<IndexMap<K, T>, Diagnostic>
where
    K: std::hash::Hash + Eq + AsRef<str> + Clone + std::borrow::Borrow<str>,
{
    if id.is_empty() {
        let known: Vec<&str> = all.keys().take(6).map(AsRef::as_ref).collect();
        let problem = Diagnostic::error("bad-target", tr!("the {what} is missing"));
        return Err(problem.hint(tr!("name one, such as {known}", known = known.join(", "))));
    }
    match all.get_key_value(id) {
        Some((key, part)) => Ok(IndexMap::from([(key.clone(), part.clone())])),
        None => {
            let problem = Diagnostic::error("unknown-target", tr!("there is no {what} `{id}`"));
            Err(problem.suggest(id, all.keys().map(AsRef::as_ref)))
        }
    }
}

pub(super) fn json_of<T: Document>(document: &T) -> Json {
    serde_json::from_str(&document.text()).unwrap_or(Json::Null)
}

/// A value as files have it.
pub fn json_of_value(value: &Value) -> Json {
    let mut writer = JsonWriter::trial();
    value.write(&mut writer, None);
    serde_json::from_str(&writer.finish()).unwrap_or(Json::Null)
}

/// A document with a value at an address.
fn with_value<T: Document>(part: &T, address: &str, value: &Value) -> Result<T, Diagnostic> {
    let mut json = json_of(part);
    *place(&mut json, T::shape(), address)?.json = json_of_value(value);
    let loaded = read_unchecked::<T>(&json.to_string());
    let is_read = !has_errors(&loaded.diagnostics);
    if let Some(read) = loaded.value.filter(|_| is_read) {
        return Ok(read);
    }
    let first = loaded.diagnostics.into_iter().find(Diagnostic::is_error);
    let mut problem =
        first.unwrap_or_else(|| Diagnostic::error("wrong-type", tr!("this cannot be read")));
    problem.message = format!("`{address}`: {}", problem.message);
    problem.place = crate::diag::Place::default();
    Err(problem)
}

/// Document whose values have addresses.
pub(super) trait Document: DescribedObject {
    fn text(&self) -> String;
}

impl Document for Scene {
    fn text(&self) -> String {
        self.to_text()
    }
}

impl Document for Look {
    fn text(&self) -> String {
        self.to_text()
    }
}

/// Place of a value in the JSON of a document.
struct Slot<'j> {
    json: &'j mut Json,
    kind: &'static FieldKind,
}

impl Slot<'_> {
    fn found(self) -> ValuePlace {
        let blend = match self.kind {
            FieldKind::Direction => BlendKind::Direction,
            FieldKind::Rotation => BlendKind::Rotation,
            _ => BlendKind::Numbers,
        };
        ValuePlace { value: self.json.take(), blend }
    }
}

/// Finds the value at an address; what is left out in the JSON is put there with its default.
fn place<'j>(
    json: &'j mut Json,
    shape: &'static ObjectShape,
    address: &str,
) -> Result<Slot<'j>, Diagnostic> {
    let mut at = AddressStep::Object(shape);
    let mut json = json;
    let mut so_far = "";
    for step in address.split('.') {
        let (next, kind) = match at {
            AddressStep::Object(shape) => member(json, shape, step)?,
            AddressStep::Kind(FieldKind::Map(item, _)) => (entry(json, item, step)?, *item),
            AddressStep::Kind(FieldKind::List(item @ FieldKind::Object(shape), _)) => {
                (item_of(json, shape(), step)?, *item)
            }
            AddressStep::Kind(_) => {
                let message = tr!("`{so_far}` is one value, which has no `{step}`");
                return Err(Diagnostic::error("bad-target", message).hint(tr!("write `{so_far}`")));
            }
        };
        so_far = &address[..(so_far.len() + usize::from(!so_far.is_empty()) + step.len())];
        json = next;
        at = match kind {
            FieldKind::Object(shape) => AddressStep::Object(shape()),
            kind => AddressStep::Kind(kind),
        };
    }
    match at {
        AddressStep::Kind(kind) if !matches!(kind, FieldKind::Map(..) | FieldKind::List(..)) => {
            Ok(Slot { json, kind })
        }
        AddressStep::Object(shape) => {
            let names = shape.fields().map(|field| field.name);
            let names: Vec<&str> = names.filter(|name| !IDENTITY.contains(name)).collect();
            let message = tr!("`{address}` is many values");
            Err(Diagnostic::error("bad-target", message)
                .hint(tr!("name one of them: `{address}.` and {names}", names = names.join(", "))))
        }
        AddressStep::Kind(_) => {
            let message = tr!("`{address}` is a list, of which one value is named");
            Err(Diagnostic::error("bad-target", message)
                .hint(tr!("write `{address}.` and its id or name")))
        }
    }
}

/// Kind of what an address has come to.
enum AddressStep {
    Object(&'static ObjectShape),
    Kind(&'static FieldKind),
}

/// A field of an object.
fn member<'j>(
    json: &'j mut Json,
    shape: &'static ObjectShape,
    step: &str,
) -> Result<(&'j mut Json, &'static FieldKind), Diagnostic> {
    let field = shape.field(step).filter(|_| !IDENTITY.contains(&step));
    let (Some((_, field)), Some(members)) = (field, json.as_object_mut()) else {
        let message = if step.is_empty() {
            tr!("a field of the {name} is missing", name = tr_in("part", shape.name))
        } else {
            tr!("the {name} has no `{step}` that can be changed", name = tr_in("part", shape.name))
        };
        let known = shape.fields().map(|field| field.name);
        return Err(Diagnostic::error("bad-target", message)
            .suggest(step, known.filter(|name| !IDENTITY.contains(name))));
    };
    let default = match (default_of(field), &field.kind) {
        (Json::Null, FieldKind::Object(_)) => Json::Object(Default::default()),
        (default, _) => default,
    };
    Ok((members.entry(field.name).or_insert(default), &field.kind))
}

/// Value of a field that files leave out, as they would have it; null for nothing.
pub(super) fn default_of(field: &ShapeField) -> Json {
    match field.default {
        FieldDefault::Json(json) => serde_json::from_str(&json()).unwrap_or(Json::Null),
        FieldDefault::Required | FieldDefault::Words(_) => Json::Null,
    }
}

/// True if a field says what a part is, and is no value.
pub(super) fn is_identity(field: &str) -> bool {
    IDENTITY.contains(&field)
}

/// Name of an item of a list: its id, or the node or the name that it is for.
pub(super) fn item_name(item: &Json) -> Option<String> {
    let names = ["id", "node", "name"].into_iter();
    names.filter_map(|field| item.get(field)?.as_str().map(str::to_owned)).next()
}

/// An entry of a map; values, such as those of inputs, may be new.
fn entry<'j>(
    json: &'j mut Json,
    item: &'static FieldKind,
    step: &str,
) -> Result<&'j mut Json, Diagnostic> {
    let unknown = |known: Vec<String>| {
        let problem = Diagnostic::error("unknown-target", tr!("there is no `{step}`"));
        problem.suggest(step, known.iter().map(String::as_str))
    };
    let Some(members) = json.as_object_mut() else { return Err(unknown(Vec::new())) };
    if !members.contains_key(step) {
        if !matches!(item, FieldKind::Value) || !crate::ids::is_slug(step) {
            return Err(unknown(members.keys().cloned().collect()));
        }
        members.insert(step.to_owned(), Json::Null);
    }
    members.get_mut(step).ok_or_else(|| unknown(Vec::new()))
}

/// An item of a list by its id, or by the node or the name that it is for. A row for a node is made
/// where there is none.
fn item_of<'j>(
    json: &'j mut Json,
    shape: &'static ObjectShape,
    step: &str,
) -> Result<&'j mut Json, Diagnostic> {
    let known: Vec<Option<String>> =
        json.as_array().map(|items| items.iter().map(item_name).collect()).unwrap_or_default();
    let index = known.iter().position(|known| known.as_deref() == Some(step));
    let may_be_new = shape.field("node").is_some() && crate::ids::is_slug(step);
    let missing = || {
        let message = tr!("there is no {name} `{step}`", name = tr_in("part", shape.name));
        Diagnostic::error("unknown-target", message)
            .suggest(step, known.iter().flatten().map(String::as_str))
    };
    let items = json.as_array_mut().ok_or_else(missing)?;
    let index = match index {
        Some(index) => index,
        None if may_be_new => {
            items.push(serde_json::json!({ "node": step }));
            items.len() - 1
        }
        None => return Err(missing()),
    };
    items.get_mut(index).ok_or_else(missing)
}
