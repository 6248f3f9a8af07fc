//! Labels of steps: they name what is changed, where that is one value or the same of several
//! parts.

use std::fmt::Display;

use chiaro_locale::{tr, trn};
use indexmap::IndexSet;

use super::Edit;
use crate::document::{DirectionKey, DirectionKeys, Light, LightField, Object, Target};
use crate::ids::{LightId, ObjectId};

/// Names that a label has room for.
const MOST_NAMES: usize = 3;

/// Names of parts, each once: the first ones, and the number of the others.
pub(super) fn names<T: Display>(parts: impl IntoIterator<Item = T>) -> String {
    let all: IndexSet<String> = parts.into_iter().map(|part| part.to_string()).collect();
    let first: Vec<&str> = all.iter().take(MOST_NAMES).map(String::as_str).collect();
    let names = first.join(", ");
    match all.len() - first.len() {
        0 => names,
        more => tr!("{names} and {more} more"),
    }
}

/// The only text of a list; `None` where there are several.
fn only_of(mut texts: Vec<Option<String>>) -> Option<String> {
    texts.dedup();
    if texts.len() == 1 { texts.pop().flatten() } else { None }
}

/// Label of a step that changes a light: *Intensity of key* where no more is changed, and the light
/// as a whole where several fields are, or where the light was not there.
pub(super) fn of_light(id: &LightId, old: Option<&Light>, new: &Light) -> String {
    if old.is_some_and(|old| old.name != new.name) {
        return tr!("rename the light {id}");
    }
    let value = old.and_then(|old| value_of_light(new.display_name(id), old, new));
    value.unwrap_or_else(|| tr!("change the light {id}"))
}

/// Label of a step that changes several lights: *Color of key, rim* where the same value of each is
/// changed, and their number otherwise.
pub(super) fn of_lights<'l>(
    changes: impl Iterator<Item = (&'l LightId, Option<&'l Light>, &'l Light)>,
) -> String {
    let changes: Vec<_> = changes.filter(|(_, old, new)| *old != Some(*new)).collect();
    let count = changes.len();
    let lights = names(changes.iter().map(|(id, _, new)| new.display_name(id)));
    let value = |(_, old, new): &(_, Option<&Light>, &Light)| {
        old.and_then(|old| value_of_light(&lights, old, new))
    };
    only_of(changes.iter().map(value).collect())
        .unwrap_or_else(|| trn!(count, "change {count} lights", "change {count} lights"))
}

/// Label of the one value by which a light of a name, or each of several, differs from before.
fn value_of_light(light: &str, old: &Light, new: &Light) -> Option<String> {
    let fields = LightField::ALL.into_iter().filter(|field| field.get(old) != field.get(new));
    let others = [
        (old.kind != new.kind, tr!("Type")),
        (old.space != new.space, tr!("light" => "Frame")),
        (old.aimed_at != new.aimed_at, tr!("Aim at")),
        (old.groups != new.groups, tr!("Groups")),
    ];
    let others = others.into_iter().filter(|(differs, _)| *differs).map(|(_, label)| label);
    let changed: Vec<&str> = fields.map(LightField::label).chain(others).collect();
    match changed[..] {
        [value] => Some(tr!("{value} of {light}")),
        _ => None,
    }
}

/// Label of a step that changes one part of an object, or of several, by their names.
type ObjectStep = fn(&str) -> String;

/// Label of a step that changes an object: the one part of it that is changed, or the object as a
/// whole.
pub(super) fn of_object(id: &ObjectId, old: Option<&Object>, new: &Object) -> String {
    let part = old.and_then(|old| part_of_object(id.as_str(), old, new));
    part.unwrap_or_else(|| tr!("change {id}"))
}

/// Label of a step that changes several objects: *move cat, dog* where the same part of each is
/// changed.
pub(super) fn of_objects<'o>(
    changes: impl Iterator<Item = (&'o ObjectId, Option<&'o Object>, &'o Object)>,
) -> String {
    let changes: Vec<_> = changes.filter(|(_, old, new)| *old != Some(*new)).collect();
    let id = names(changes.iter().map(|(id, ..)| id));
    let part = |(_, old, new): &(_, Option<&Object>, &Object)| {
        old.and_then(|old| part_of_object(&id, old, new))
    };
    only_of(changes.iter().map(part).collect()).unwrap_or_else(|| tr!("change {id}"))
}

/// Label of the one part by which an object of a name, or each of several, differs from before.
fn part_of_object(id: &str, old: &Object, new: &Object) -> Option<String> {
    let (a, b) = (&old.transform, &new.transform);
    let is_linked = old.light_link() != new.light_link() || old.layers != new.layers;
    let parts: [(bool, ObjectStep); 10] = [
        (a.translate != b.translate, |id| tr!("move {id}")),
        (a.rotate != b.rotate, |id| tr!("turn {id}")),
        (a.scale != b.scale || a.fit != b.fit, |id| tr!("scale {id}")),
        (old.mesh != new.mesh, |id| tr!("change the mesh of {id}")),
        (old.animation != new.animation, |id| tr!("change the animation of {id}")),
        (old.looks != new.looks, |id| tr!("change the look of {id}")),
        (is_linked, |id| tr!("link lights and {id}")),
        (old.shadow_link() != new.shadow_link(), |id| tr!("change the shadows of {id}")),
        (old.visible && !new.visible, |id| tr!("hide {id}")),
        (!old.visible && new.visible, |id| tr!("show {id}")),
    ];
    let mut changed = parts.into_iter().filter(|(differs, _)| *differs).map(|(_, label)| label);
    let keys = old.values.keys().chain(new.values.keys());
    let mut set = keys.filter(|name| old.values.get(*name) != new.values.get(*name));
    match (changed.next(), changed.next(), set.next()) {
        (Some(label), None, None) => Some(label(id)),
        // A value that is changed is in both maps, so that its name comes twice.
        (None, None, Some(value)) if set.all(|other| other == value) => {
            Some(tr!("change {value} of {id}", value = value.as_str().replace('_', " ")))
        }
        _ => None,
    }
}

/// Label of a step that adds a set of direction keys.
pub(super) fn of_new_keys(keys: &DirectionKeys) -> String {
    match keys.name.as_str() {
        "" => tr!("add keys").to_owned(),
        name => tr!("add keys: {name}"),
    }
}

/// Label of a step that removes a set of direction keys.
pub(super) fn of_removed_keys(keys: Option<&DirectionKeys>) -> String {
    match keys.map_or("", |keys| keys.name.as_str()) {
        "" => tr!("remove keys").to_owned(),
        name => tr!("remove keys: {name}"),
    }
}

/// Label of a step that changes a set of direction keys: the key or the value that is changed, or
/// the set as a whole.
pub(super) fn of_keys(old: Option<&DirectionKeys>, new: &DirectionKeys) -> String {
    let name = new.name.as_str();
    let whole = || match name {
        "" => tr!("change keys").to_owned(),
        name => tr!("change keys: {name}"),
    };
    let Some(old) = old else { return whole() };
    if old.name != new.name {
        return if name.is_empty() { whole() } else { tr!("rename keys: {name}") };
    }
    if old.by != new.by || old.scheme != new.scheme {
        return whole();
    }
    let is_named = !name.is_empty();
    match (old.keys.len(), new.keys.len()) {
        (before, after) if before < after && is_named => return tr!("add a key: {name}"),
        (before, after) if before < after => return tr!("add a key").to_owned(),
        (before, after) if before > after && is_named => return tr!("remove a key: {name}"),
        (before, after) if before > after => return tr!("remove a key").to_owned(),
        _ => {}
    }
    let pairs: Vec<_> = old.keys.iter().zip(&new.keys).collect();
    let targets: IndexSet<&Target> =
        pairs.iter().flat_map(|(old, new)| changed_targets(old, new)).collect();
    let moved: Vec<usize> = (1..)
        .zip(&pairs)
        .filter(|(_, (old, new))| old.direction != new.direction)
        .map(|(number, _)| number)
        .collect();
    match (&moved[..], targets.len()) {
        ([number], 0) if is_named => tr!("move key {number}: {name}"),
        ([number], 0) => tr!("move key {number}"),
        ([], 1..) => of_values(&pairs, &targets),
        _ => whole(),
    }
}

/// Targets whose values differ in a key from before.
fn changed_targets<'k>(
    old: &'k DirectionKey,
    new: &'k DirectionKey,
) -> impl Iterator<Item = &'k Target> {
    let all = old.values.keys().chain(new.values.keys());
    all.filter(move |target| old.values.get(*target) != new.values.get(*target))
}

/// Label of a step that changes values of direction keys: of one key, or of all of them.
fn of_values(pairs: &[(&DirectionKey, &DirectionKey)], targets: &IndexSet<&Target>) -> String {
    let target = names(targets);
    let has = |key: &DirectionKey| targets.iter().any(|target| key.values.contains_key(*target));
    if !pairs.iter().any(|(old, _)| has(old)) {
        return tr!("key {target}");
    }
    if !pairs.iter().any(|(_, new)| has(new)) {
        return tr!("remove keys of {target}");
    }
    let differs = |(old, new): &(&DirectionKey, &DirectionKey)| old.values != new.values;
    let mut changed = (1..).zip(pairs).filter(|(_, pair)| differs(pair));
    match (changed.next(), changed.next()) {
        (Some((number, _)), None) => tr!("change {target} at key {number}"),
        _ => tr!("change keys of {target}"),
    }
}

/// Label of edits that do the same to several nodes, values or tracks; `None` for all others.
pub(super) fn of_several(edits: &[Edit]) -> Option<String> {
    let count = edits.len();
    let all = |is: fn(&Edit) -> bool| count > 1 && edits.iter().all(is);
    let named = |name: fn(&Edit) -> Option<String>| {
        let found: Option<Vec<String>> = edits.iter().map(name).collect();
        found.filter(|found| found.len() > 1).map(names)
    };
    if all(|edit| matches!(edit, Edit::SetCollapsed { collapsed: true, .. })) {
        return Some(trn!(count, "collapse {count} nodes", "collapse {count} nodes"));
    } else if all(|edit| matches!(edit, Edit::SetCollapsed { collapsed: false, .. })) {
        return Some(trn!(count, "expand {count} nodes", "expand {count} nodes"));
    } else if all(|edit| matches!(edit, Edit::SetMuted { muted: true, .. })) {
        return Some(trn!(count, "mute {count} nodes", "mute {count} nodes"));
    } else if all(|edit| matches!(edit, Edit::SetMuted { muted: false, .. })) {
        return Some(trn!(count, "unmute {count} nodes", "unmute {count} nodes"));
    }
    let values = named(|edit| match edit {
        Edit::SetValue { id, port, .. } => Some(format!("{id}.{port}")),
        _ => None,
    });
    if let Some(values) = values {
        return Some(tr!("change {values}"));
    }
    let removed = named(|edit| match edit {
        Edit::RemoveNode { id, .. } => Some(id.to_string()),
        _ => None,
    });
    if let Some(id) = removed {
        return Some(tr!("remove {id}"));
    }
    let target = named(|edit| match edit {
        Edit::SetTimeKeys { keys, .. } => Some(keys.target.to_string()),
        _ => None,
    });
    target.map(|target| tr!("change keys of {target}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Editable, GraphId, Look, Scene, SceneEdit, Value};
    use crate::ids::NodeId;

    #[test]
    fn a_step_names_the_one_value_of_a_light_that_it_changes() {
        let (id, old) = (LightId::new("key"), Light::default());
        let step = |new: &Light| of_light(&id, Some(&old), new);
        assert_eq!(step(&Light { intensity: 2.0, ..old.clone() }), "Intensity of key");
        assert_eq!(step(&Light { color: [1.0, 0.0, 0.0], ..old.clone() }), "Color of key");
        let sun = Light { name: "Sun".to_owned(), ..old.clone() };
        assert_eq!(step(&sun), "rename the light key");
        let brighter = Light { intensity: 2.0, ..sun.clone() };
        assert_eq!(of_light(&id, Some(&sun), &brighter), "Intensity of Sun");
        let both = Light { intensity: 2.0, color: [1.0, 0.0, 0.0], ..old.clone() };
        assert_eq!(step(&both), "change the light key");
        assert_eq!(of_light(&id, None, &old), "change the light key");
        let look = r#"{"lights": {"key": {}}}"#;
        let look = Look::read(look, "test").value.unwrap();
        let set = |intensity: f64| {
            let light = Light { intensity, ..look.lights["key"].clone() };
            Edit::SetLight { id: id.clone(), light }
        };
        assert_eq!(look.label(&set(2.0)), "Intensity of key");
        let one = Edit::Group { edits: vec![set(2.0)] };
        assert_eq!(look.label(&one), "Intensity of key");
        let twice = Edit::Group { edits: vec![set(2.0), set(3.0)] };
        assert_eq!(look.label(&twice), "Intensity of key");
    }

    #[test]
    fn a_step_names_the_one_part_of_an_object_that_it_changes() {
        let scene = r#"{"objects": [{"id": "cat", "values": {"rim_width": 1}}]}"#;
        let scene = Scene::read(scene, "test").value.unwrap();
        let step = |change: fn(&mut Object)| {
            let mut object = scene.objects["cat"].clone();
            change(&mut object);
            scene.label(&SceneEdit::SetObject { id: "cat".into(), object: Box::new(object) })
        };
        assert_eq!(step(|cat| cat.transform.translate[1] = 2.0), "move cat");
        assert_eq!(step(|cat| cat.transform.rotate = [0.0, 1.0, 0.0, 0.0]), "turn cat");
        assert_eq!(step(|cat| cat.visible = false), "hide cat");
        assert_eq!(
            step(|cat| drop(cat.values.shift_remove("rim_width"))),
            "change rim width of cat"
        );
        let both: fn(&mut Object) = |cat| {
            cat.visible = false;
            cat.transform.scale = [2.0; 3];
        };
        assert_eq!(step(both), "change cat");
    }

    #[test]
    fn a_step_names_the_lights_and_objects_that_it_changes_alike() {
        let scene = r#"{"lights": {"key": {}, "rim": {"name": "Rim"}},
          "objects": [{"id": "cat"}, {"id": "dog"}, {"id": "hat"}, {"id": "mat"}, {"id": "pot"}]}"#;
        let scene = Scene::read(scene, "test").value.unwrap();
        let light = |id: &str, change: fn(&mut Light)| {
            let mut light = scene.lights[id].clone();
            change(&mut light);
            SceneEdit::SetLight { id: id.into(), light }
        };
        let object = |id: &str, change: fn(&mut Object)| {
            let mut object = scene.objects[id].clone();
            change(&mut object);
            SceneEdit::SetObject { id: id.into(), object: Box::new(object) }
        };
        let label = |edits: Vec<SceneEdit>| scene.label(&SceneEdit::Group { edits });
        let turn: fn(&mut Light) = |light| light.direction = [1.0, 0.0, 0.0];
        let color: fn(&mut Light) = |light| light.color = [1.0, 0.0, 0.0];
        let both = vec![light("key", turn), light("rim", turn)];
        assert_eq!(label(both), "Direction of key, Rim");
        let mixed = vec![light("key", turn), light("rim", color)];
        assert_eq!(label(mixed), "change 2 lights");
        let lift: fn(&mut Object) = |object| object.transform.translate[1] = 2.0;
        let hide: fn(&mut Object) = |object| object.visible = false;
        assert_eq!(label(vec![object("cat", lift), object("dog", lift)]), "move cat, dog");
        assert_eq!(label(vec![object("cat", lift), object("dog", hide)]), "change cat, dog");
        let all = scene.objects.keys().map(|id| object(id.as_str(), lift)).collect();
        assert_eq!(label(all), "move cat, dog, hat and 2 more");
        // What stays as it is is not named.
        assert_eq!(label(vec![object("cat", |_| {}), object("dog", lift)]), "move dog");
        let with_camera = vec![object("cat", lift), SceneEdit::SetBackdrop { color: None }];
        assert_eq!(label(with_camera), "move cat");
    }

    #[test]
    fn a_step_names_the_direction_key_or_the_value_that_it_changes() {
        let look = r#"{"nodes": [{"id": "rim", "kind": "light_layer"}], "direction_keys": [
          {"name": "By the view", "by": "view", "keys": [
            {"direction": [0, 0, 1], "values": {"rim.opacity": 0}},
            {"direction": [1, 0, 0], "values": {"rim.opacity": 1}}]}]}"#;
        let look = Look::read(look, "test").value.unwrap();
        let step = |change: fn(&mut DirectionKeys)| {
            let mut keys = look.direction_keys[0].clone();
            change(&mut keys);
            look.label(&Edit::SetDirectionKeys { index: 0, keys })
        };
        let put = |keys: &mut DirectionKeys, key: usize, target: &str| {
            let target = Target::parse(target).expect("a target");
            keys.keys[key].values.insert(target, Value::Number(0.5));
        };
        assert_eq!(
            step(|keys| keys.keys[1].direction = [0.0, 1.0, 0.0]),
            "move key 2: By the view"
        );
        assert_eq!(step(|keys| drop(keys.keys.pop())), "remove a key: By the view");
        assert_eq!(step(|keys| keys.keys.push(keys.keys[0].clone())), "add a key: By the view");
        assert_eq!(step(|keys| keys.name = "Turns".to_owned()), "rename keys: Turns");
        let one: fn(&mut DirectionKeys) = |keys| {
            keys.keys[0].values[0] = Value::Number(0.5);
        };
        assert_eq!(step(one), "change rim.opacity at key 1");
        let both: fn(&mut DirectionKeys) = |keys| {
            keys.keys.iter_mut().for_each(|key| key.values[0] = Value::Number(0.5));
        };
        assert_eq!(step(both), "change keys of rim.opacity");
        let mut keys = look.direction_keys[0].clone();
        (0..2).for_each(|key| put(&mut keys, key, "rim.slope"));
        let edit = Edit::SetDirectionKeys { index: 0, keys };
        assert_eq!(look.label(&edit), "key rim.slope");
        // The value that a new key needs is no step of its own.
        let (id, port) = (NodeId::new("rim"), "slope".into());
        let value = Value::Number(0.5);
        let set = Edit::SetValue { graph: GraphId::Look, id, port, value, index: None };
        assert_eq!(look.label(&Edit::Group { edits: vec![set, edit] }), "key rim.slope");
        let gone = Edit::RemoveDirectionKeys { index: 0 };
        assert_eq!(look.label(&gone), "remove keys: By the view");
    }

    #[test]
    fn the_same_done_to_several_nodes_is_told_by_their_number() {
        let collapse = |id: &str, collapsed: bool| Edit::SetCollapsed {
            graph: GraphId::Look,
            id: NodeId::new(id),
            collapsed,
        };
        let group = |edits: Vec<Edit>| Edit::Group { edits }.label();
        assert_eq!(group(vec![collapse("base", true), collapse("rim", true)]), "collapse 2 nodes");
        assert_eq!(group(vec![collapse("base", false), collapse("rim", false)]), "expand 2 nodes");
        assert_eq!(group(vec![collapse("base", true)]), "collapse base");
        let mixed = vec![collapse("base", true), collapse("rim", false)];
        assert_eq!(group(mixed), "collapse base");
        let set = |id: &str| Edit::SetValue {
            graph: GraphId::Look,
            id: NodeId::new(id),
            port: "opacity".into(),
            value: Value::Number(0.5),
            index: None,
        };
        assert_eq!(group(vec![set("rim"), set("key")]), "change rim.opacity, key.opacity");
    }
}
