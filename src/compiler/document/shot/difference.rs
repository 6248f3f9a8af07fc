//! Differences between two states of a look or a scene, in the addresses of their values.
//!
//! A shot holds nothing but values, so an edit that is made under one has to be told in values: the
//! state before it and the one after it are compared, part by part, by the shapes that files have,
//! as `place` walks them. What no address says, such as a node more or a wire less, is an error.

use std::hash::Hash;

use chiaro_locale::tr;
use indexmap::IndexMap;
use serde_json::Value as Json;

use super::place::{default_of, is_identity, item_name, json_of};
use crate::diag::Diagnostic;
use crate::document::shape::{FieldKind, ObjectShape};
use crate::document::{Graph, Look, Node, Scene, Target, TimeKeys, Value};
use crate::ids::{DefinitionId, LightGroup, NodeId, NodePath};

/// Most uses of a group that are looked for, and that a message names.
const MOST_USES: usize = 1000;
const NAMED_USES: usize = 4;

/// A value that differs between two states of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueDifference {
    /// Address of the value.
    pub target: String,
    /// Present state.
    pub to: ChangedTo,
}

/// State of a value that differs.
#[derive(Clone, Debug, PartialEq)]
pub enum ChangedTo {
    /// Another value.
    Value(Value),
    /// Nothing that is set: the default of the node.
    Default,
    /// Keys in time.
    Keys(TimeKeys),
    /// No keys in time any more.
    Unkeyed,
}

/// Differences so far.
type Differences = Vec<ValueDifference>;

impl Scene {
    /// Values that `after` has otherwise.
    ///
    /// # Errors
    /// A difference that no address says.
    pub fn differences(&self, after: &Self) -> Result<Vec<ValueDifference>, Diagnostic> {
        let mut found = Differences::new();
        let part = |objects: &_, lights: &_, light_groups: &_| Self {
            objects: IndexMap::clone(objects),
            lights: IndexMap::clone(lights),
            light_groups: IndexMap::clone(light_groups),
            ..Self::default()
        };
        let (none, no_lights, no_groups) = (IndexMap::new(), IndexMap::new(), IndexMap::new());
        same_ids(tr!("part" => "object"), &self.objects, &after.objects)?;
        same_ids(tr!("part" => "light"), &self.lights, &after.lights)?;
        let objects = changed(&self.objects, &after.objects);
        for [before, after] in objects {
            walk_documents(
                [before, after].map(|of| part(&of, &no_lights, &no_groups)),
                &mut found,
            )?;
        }
        for [before, after] in changed(&self.lights, &after.lights) {
            walk_documents([before, after].map(|of| part(&none, &of, &no_groups)), &mut found)?;
        }
        let is_gone = |group: &&LightGroup| !after.light_groups.contains_key(*group);
        let gone = self.light_groups.keys().filter(is_gone);
        for group in after.light_groups.keys().chain(gone) {
            let of = |scene: &Self| {
                let master = scene.light_groups.get(group).cloned().unwrap_or_default();
                part(&none, &no_lights, &IndexMap::from([(group.clone(), master)]))
            };
            let pair = [of(self), of(after)];
            if pair[0].light_groups != pair[1].light_groups {
                walk_documents(pair, &mut found)?;
            }
        }
        if self.direction_keys != after.direction_keys {
            return Err(beyond(tr!("keys by direction")));
        }
        differing_keys(&self.time_keys, &after.time_keys, &mut found);
        let rest = |scene: &Self| Self {
            objects: IndexMap::new(),
            lights: IndexMap::new(),
            light_groups: IndexMap::new(),
            direction_keys: Vec::new(),
            time_keys: Vec::new(),
            ..scene.clone()
        };
        walk_documents([rest(self), rest(after)], &mut found)?;
        Ok(found)
    }
}

impl Look {
    /// Values that `after` has otherwise.
    ///
    /// # Errors
    /// A difference that no address says.
    pub fn differences(&self, after: &Self) -> Result<Vec<ValueDifference>, Diagnostic> {
        self.differences_in(after, &[])
    }

    /// Values that `after` has otherwise; one within a group that is used several times is of the
    /// use that `open` leads to or into, the nodes of groups that were opened.
    ///
    /// # Errors
    /// A difference that no address says, or one of several uses of which none is open.
    pub fn differences_in(
        &self,
        after: &Self,
        open: &[NodeId],
    ) -> Result<Vec<ValueDifference>, Diagnostic> {
        let mut found = Differences::new();
        differing_nodes("", &self.graph, &after.graph, &mut found)?;
        self.differing_definitions(after, open, &mut found)?;
        same_ids(tr!("part" => "light"), &self.lights, &after.lights)?;
        for pair in changed(&self.lights, &after.lights) {
            let part = |lights| Self { lights, ..Self::default() };
            walk_documents(pair.map(part), &mut found)?;
        }
        if self.exposed != after.exposed {
            return Err(beyond(tr!("what is exposed")));
        }
        if self.aovs != after.aovs {
            return Err(beyond(tr!("the names of outputs")));
        }
        if self.markers != after.markers {
            return Err(beyond(tr!("a marker of the look")));
        }
        if self.direction_keys != after.direction_keys {
            return Err(beyond(tr!("keys by direction")));
        }
        differing_keys(&self.time_keys, &after.time_keys, &mut found);
        let rest = |look: &Self| Self {
            name: look.name.clone(),
            about: look.about.clone(),
            tags: look.tags.clone(),
            tuned: look.tuned.clone(),
            color_space: look.color_space,
            tier: look.tier,
            max_error: look.max_error,
            ..Self::default()
        };
        walk_documents([rest(self), rest(after)], &mut found)?;
        Ok(found)
    }

    /// Values within groups: a shot changes those of one use.
    fn differing_definitions(
        &self,
        after: &Self,
        open: &[NodeId],
        found: &mut Differences,
    ) -> Result<(), Diagnostic> {
        same_ids(tr!("part" => "group"), &self.definitions, &after.definitions)?;
        for (id, before) in &self.definitions {
            let Some(now) = after.definitions.get(id).filter(|now| *now != before) else {
                continue;
            };
            let interface = |of: &crate::document::Definition| {
                (of.label.clone(), of.help.clone(), of.inputs.clone(), of.outputs.clone())
            };
            if interface(before) != interface(now) {
                return Err(beyond(tr!("inputs and outputs of groups")));
            }
            let uses = self.uses_of(id);
            let path = match uses.as_slice() {
                [path] => path,
                _ => uses.iter().find(|path| open.starts_with(path.ids())).ok_or_else(|| {
                    let named = uses.iter().take(NAMED_USES).map(|path| format!("`{path}`"));
                    let named: Vec<String> = named.collect();
                    let count = uses.len();
                    let more = if count > NAMED_USES { ", ..." } else { "" };
                    let message = tr!(
                        "the group is used {count} times ({named}{more}), and a shot changes one \
                         of them: open the node that is meant, and change the value there",
                        named = named.join(", ")
                    );
                    Diagnostic::error("used-more-than-once", message)
                })?,
            };
            let mut inner = Differences::new();
            differing_nodes(&format!("{path}/"), &before.graph, &now.graph, &mut inner)?;
            if inner.iter().any(|difference| difference.target.starts_with("nodes.")) {
                return Err(beyond(tr!("nodes within groups")));
            }
            found.append(&mut inner);
        }
        Ok(())
    }

    /// Nodes that are of a group of the look's own, by their paths, as far as they can be listed.
    pub fn uses_of(&self, group: &DefinitionId) -> Vec<NodePath> {
        let mut uses = Vec::new();
        let mut open: Vec<(Option<NodePath>, &Graph)> = vec![(None, &self.graph)];
        let mut seen = 0;
        while let Some((around, graph)) = open.pop() {
            for (id, node) in &graph.nodes {
                let Some(definition) = self.definitions.get(node.kind.as_str()) else { continue };
                let path = around
                    .as_ref()
                    .map_or_else(|| NodePath::root(id.clone()), |path| path.join(id.clone()));
                seen += 1;
                if seen > MOST_USES {
                    return uses;
                }
                if node.kind == group.as_str() {
                    uses.push(path);
                } else {
                    open.push((Some(path), &definition.graph));
                }
            }
        }
        uses
    }
}

/// An error of a difference that no address says.
fn beyond(what: &str) -> Diagnostic {
    Diagnostic::error("not-of-a-shot", tr!("{what} are no values that a shot can change"))
}

/// Checks that two maps have the same ids in the same order.
fn same_ids<K: Eq + std::fmt::Display, T>(
    what: &str,
    before: &IndexMap<K, T>,
    after: &IndexMap<K, T>,
) -> Result<(), Diagnostic> {
    if before.keys().eq(after.keys()) {
        return Ok(());
    }
    let new = after.keys().find(|id| !before.keys().any(|old| old == *id));
    let gone = before.keys().find(|id| !after.keys().any(|now| now == *id));
    let message = match (new, gone) {
        (Some(id), _) => tr!("{what} `{id}` would be new: a shot changes values alone"),
        (None, Some(id)) => tr!("{what} `{id}` would be gone: a shot changes values alone"),
        (None, None) => tr!("the order of the {what}s is no value that a shot can change"),
    };
    Err(Diagnostic::error("not-of-a-shot", message))
}

/// Parts that differ, each alone in a map as it was and as it is.
fn changed<'m, K: Clone + Eq + Hash, T: Clone + PartialEq>(
    before: &'m IndexMap<K, T>,
    after: &'m IndexMap<K, T>,
) -> impl Iterator<Item = [IndexMap<K, T>; 2]> + 'm {
    let pairs = before.iter().zip(after.values()).filter(|((_, before), after)| before != after);
    pairs.map(|((id, before), after)| {
        [before, after].map(|part| IndexMap::from([(id.clone(), part.clone())]))
    })
}

/// Keys in time that differ, by their targets.
fn differing_keys(before: &[TimeKeys], after: &[TimeKeys], found: &mut Differences) {
    let of = |tracks: &[TimeKeys], target: &Target| {
        tracks.iter().find(|track| track.target == *target).cloned()
    };
    for track in after {
        if of(before, &track.target).as_ref() != Some(track) {
            let to = ChangedTo::Keys(track.clone());
            found.push(ValueDifference { target: track.target.to_string(), to });
        }
    }
    for track in before.iter().filter(|track| of(after, &track.target).is_none()) {
        // A value that was set as the keys went is told already.
        let target = track.target.to_string();
        if !found.iter().any(|difference| difference.target == target) {
            found.push(ValueDifference { target, to: ChangedTo::Unkeyed });
        }
    }
}

/// Values of nodes that differ; `around` is the path of the group, with a `/` behind it.
fn differing_nodes(
    around: &str,
    before: &Graph,
    after: &Graph,
    found: &mut Differences,
) -> Result<(), Diagnostic> {
    same_ids(tr!("part" => "node"), &before.nodes, &after.nodes)?;
    if before.wires != after.wires {
        return Err(beyond(tr!("wires")));
    }
    if (&before.frames, &before.notes, &before.bookmarks)
        != (&after.frames, &after.notes, &after.bookmarks)
    {
        return Err(beyond(tr!("frames, notes and bookmarks")));
    }
    for ((id, before), after) in before.nodes.iter().zip(after.nodes.values()) {
        if before != after {
            differing_node(around, (id, before), after, found)?;
        }
    }
    Ok(())
}

fn differing_node(
    around: &str,
    (id, before): (&NodeId, &Node),
    after: &Node,
    found: &mut Differences,
) -> Result<(), Diagnostic> {
    if before.kind != after.kind {
        return Err(beyond(tr!("kinds of nodes")));
    }
    let layout = |node: &Node| (node.position, node.collapsed, node.name.clone());
    if layout(before) != layout(after) {
        return Err(beyond(tr!("names and places of nodes")));
    }
    for (port, value) in &after.values {
        if before.values.get(port) != Some(value) {
            let to = ChangedTo::Value(value.clone());
            found.push(ValueDifference { target: format!("{around}{id}.{port}"), to });
        }
    }
    for port in before.values.keys().filter(|port| !after.values.contains_key(*port)) {
        let target = format!("{around}{id}.{port}");
        found.push(ValueDifference { target, to: ChangedTo::Default });
    }
    let part = |node: &Node| {
        let mut look = Look::default();
        look.graph.nodes.insert(id.clone(), Node { values: Default::default(), ..node.clone() });
        look
    };
    walk_documents([part(before), part(after)], found)
}

/// Differences of two documents of one shape.
fn walk_documents<T: super::place::Document>(
    [before, after]: [T; 2],
    found: &mut Differences,
) -> Result<(), Diagnostic> {
    let (before, after) = (json_of(&before), json_of(&after));
    walk_object(T::shape(), [&before, &after], "", found)
}

/// Differences of the fields of an object. Depth is that of the shapes of files.
fn walk_object(
    shape: &'static ObjectShape,
    [before, after]: [&Json; 2],
    address: &str,
    found: &mut Differences,
) -> Result<(), Diagnostic> {
    if before == after {
        return Ok(());
    }
    if !after.is_object() && before.is_object() {
        return Err(beyond(&tr!("`{address}`, taken away,")));
    }
    // What is there for the first time is told whole.
    let is_new = !before.is_object();
    for field in shape.fields() {
        let default = default_of(field);
        let [was, is] = [before, after].map(|of| of.get(field.name).unwrap_or(&default));
        if was == is && !is_new || is_new && is.is_null() {
            continue;
        }
        if is_identity(field.name)
            || address.is_empty() && ["name", "about", "tags"].contains(&field.name)
        {
            if was == is {
                continue;
            }
            return Err(beyond(tr!("names and texts of documents")));
        }
        let dot = if address.is_empty() { "" } else { "." };
        walk(&field.kind, [was, is], &format!("{address}{dot}{}", field.name), found)?;
    }
    Ok(())
}

fn walk(
    kind: &'static FieldKind,
    [before, after]: [&Json; 2],
    address: &str,
    found: &mut Differences,
) -> Result<(), Diagnostic> {
    match kind {
        FieldKind::Object(shape) => walk_object(shape(), [before, after], address, found),
        FieldKind::Map(item, _) => {
            let none = serde_json::Map::new();
            let [before, after] = [before, after].map(|of| of.as_object().unwrap_or(&none));
            for (name, now) in after {
                let was = before.get(name).unwrap_or(&Json::Null);
                if was != now {
                    walk(item, [was, now], &format!("{address}.{name}"), found)?;
                }
            }
            for name in before.keys().filter(|name| !after.contains_key(*name)) {
                let target = format!("{address}.{name}");
                found.push(ValueDifference { target, to: ChangedTo::Default });
            }
            Ok(())
        }
        FieldKind::List(FieldKind::Object(shape), _) => {
            let none = Vec::new();
            let [before, after] = [before, after].map(|of| of.as_array().unwrap_or(&none));
            let named = |items: &[Json], name: &str| {
                items.iter().find(|item| item_name(item).as_deref() == Some(name)).cloned()
            };
            for now in after {
                let Some(name) = item_name(now) else { return Err(beyond(tr!("lists"))) };
                let was = named(before, &name).unwrap_or_else(|| {
                    let named = if now.get("node").is_some() { "node" } else { "id" };
                    serde_json::json!({ named: name.as_str() })
                });
                walk_object(shape(), [&was, now], &format!("{address}.{name}"), found)?;
            }
            let gone = before.iter().filter_map(item_name);
            if gone.into_iter().any(|name| named(after, &name).is_none()) {
                return Err(beyond(tr!("rows of lists")));
            }
            Ok(())
        }
        FieldKind::List(..) => Err(beyond(&tr!("lists such as `{address}`"))),
        // A look of the whole mesh is written as a text, and read by its name.
        FieldKind::Looks => {
            let of = |json: &Json| match json {
                Json::String(path) => serde_json::json!({ "*": path }),
                json => json.clone(),
            };
            if of(before) == of(after) { Ok(()) } else { leaf(after, address, found) }
        }
        _ => leaf(after, address, found),
    }
}

fn leaf(after: &Json, address: &str, found: &mut Differences) -> Result<(), Diagnostic> {
    let value = serde_json::from_value::<Value>(after.clone());
    let value = value.map_err(|_| beyond(&tr!("`{address}` without a value")))?;
    found.push(ValueDifference { target: address.to_owned(), to: ChangedTo::Value(value) });
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(found: &[ValueDifference]) -> Vec<String> {
        let one = |difference: &ValueDifference| match &difference.to {
            ChangedTo::Value(value) => {
                format!("{} = {}", difference.target, crate::document::json_of_value(value))
            }
            other => format!("{}: {other:?}", difference.target),
        };
        found.iter().map(one).collect()
    }

    #[test]
    fn what_differs_is_told_in_addresses_that_set_it() {
        let text = r#"{"chiaro": "scene", "lights": {"key": {}}, "camera": {"fov": 0.5},
            "objects": [{"id": "hero", "mesh": "shape:sphere", "looks": "a.json"},
                        {"id": "floor", "mesh": "shape:plane", "looks": "a.json"}]}"#;
        let before = Scene::read(text, "").value.unwrap();
        let mut after = before.clone();
        after.lights["key"].intensity = 2.0;
        after.objects["hero"].transform.translate = [1.0, 0.0, 0.0];
        after.objects["hero"].visible = false;
        after.camera.fov = 0.75;
        after.muted = crate::document::LightSet::parse("key").unwrap();
        after.light_groups.insert("rim".into(), Default::default());
        after.light_groups["rim"].exposure = -1.0;
        let found = before.differences(&after).unwrap();
        let expected = [
            "objects.hero.transform.translate = [1,0,0]",
            "objects.hero.visible = false",
            "lights.key.intensity = 2",
            "light_groups.rim.exposure = -1",
            "muted = \"key\"",
            "camera.fov = 0.75",
        ];
        assert_eq!(told(&found), expected);
        let mut set = before.clone();
        for ValueDifference { target, to } in &found {
            let ChangedTo::Value(value) = to else { panic!("{target}: {to:?}") };
            set.set_value(target, value).unwrap();
        }
        assert_eq!(set.to_text(), after.to_text());
        assert!(before.differences(&before).unwrap().is_empty());

        after.objects.shift_remove("floor");
        let problem = before.differences(&after).unwrap_err();
        assert!(problem.message.contains("`floor` would be gone"), "{}", problem.message);
    }

    #[test]
    fn values_of_nodes_differ_and_wires_are_refused() {
        let text = r#"{"lights": {"key": {}}, "nodes": [
            {"id": "lit", "kind": "light_layer", "values": {"offset": 0.5}},
            {"id": "output", "kind": "output"}],
            "wires": [{"from": "lit", "to": "output.color"}]}"#;
        let before = Look::read(text, "").value.unwrap();
        let mut after = before.clone();
        after.graph.nodes["lit"].values.insert("offset".into(), Value::Number(1.0));
        after.graph.nodes["lit"].muted = true;
        after.lights["key"].intensity = 3.0;
        let found = before.differences(&after).unwrap();
        let expected = ["lit.offset = 1", "nodes.lit.muted = true", "lights.key.intensity = 3"];
        assert_eq!(told(&found), expected);

        let mut reset = before.clone();
        reset.graph.nodes["lit"].values.clear();
        let found = before.differences(&reset).unwrap();
        assert_eq!(found[0].to, ChangedTo::Default);

        let mut cut = before.clone();
        cut.graph.wires.clear();
        assert!(before.differences(&cut).unwrap_err().message.contains("wires"));
        let mut moved = before.clone();
        moved.graph.nodes["lit"].position = [9.0, 9.0];
        assert!(before.differences(&moved).is_err());
    }

    #[test]
    fn a_value_within_a_group_is_of_the_use_that_is_open() {
        let text = r#"{"nodes": [
            {"id": "one", "kind": "half"}, {"id": "two", "kind": "half"},
            {"id": "output", "kind": "output"}],
            "definitions": {"half": {"nodes": [{"id": "lit", "kind": "light_layer"}]}}}"#;
        let loaded = Look::read(text, "");
        let before = loaded.value.unwrap();
        let mut after = before.clone();
        let group = after.definitions.get_mut("half").unwrap();
        group.graph.nodes["lit"].values.insert("offset".into(), Value::Number(1.0));
        let open = |ids: &[&str]| -> Vec<NodeId> { ids.iter().map(|id| (*id).into()).collect() };
        let found = before.differences_in(&after, &open(&["two"])).unwrap();
        assert_eq!(told(&found), ["two/lit.offset = 1"]);
        let problem = before.differences(&after).unwrap_err();
        assert!(problem.message.contains("used 2 times") && problem.message.contains("`two`"));
        // The shot that says so changes that use alone.
        let mut set = before.clone();
        set.set_value("two/lit.offset", &Value::Number(1.0)).unwrap();
        assert_eq!(set.definitions, before.definitions);
        assert_eq!(set.time_keys[0].target.to_string(), "two/lit.offset");
    }
}
