//! Labels of steps that change a light or an object: they name the one part that is changed.

use chiaro_locale::{tr, trn};

use super::Edit;
use crate::document::{Light, LightField, Object};
use crate::ids::{LightId, ObjectId};

/// Label of a step that changes a light: *Intensity of key* where no more is changed, and the light
/// as a whole where several fields are, or where the light was not there.
pub(super) fn of_light(id: &LightId, old: Option<&Light>, new: &Light) -> String {
    let whole = || tr!("change the light {id}");
    let Some(old) = old else { return whole() };
    if old.name != new.name {
        return tr!("rename the light {id}");
    }
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
        [value] => tr!("{value} of {light}", light = new.display_name(id)),
        _ => whole(),
    }
}

/// Label of a step that changes one part of an object.
type ObjectStep = fn(&ObjectId) -> String;

/// Label of a step that changes an object: the one part of it that is changed, or the object as a
/// whole.
pub(super) fn of_object(id: &ObjectId, old: Option<&Object>, new: &Object) -> String {
    let whole = || tr!("change {id}");
    let Some(old) = old else { return whole() };
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
    let names = old.values.keys().chain(new.values.keys());
    let mut set = names.filter(|name| old.values.get(*name) != new.values.get(*name));
    match (changed.next(), changed.next(), set.next()) {
        (Some(label), None, None) => label(id),
        // A value that is changed is in both maps, so that its name comes twice.
        (None, None, Some(value)) if set.all(|other| other == value) => {
            tr!("change {value} of {id}", value = value.as_str().replace('_', " "))
        }
        _ => whole(),
    }
}

/// Label of edits that do the same to several nodes or lights; `None` for all others.
pub(super) fn of_several(edits: &[Edit]) -> Option<String> {
    let count = edits.len();
    let all = |is: fn(&Edit) -> bool| count > 1 && edits.iter().all(is);
    if all(|edit| matches!(edit, Edit::SetCollapsed { collapsed: true, .. })) {
        Some(trn!(count, "collapse {count} nodes", "collapse {count} nodes"))
    } else if all(|edit| matches!(edit, Edit::SetCollapsed { collapsed: false, .. })) {
        Some(trn!(count, "expand {count} nodes", "expand {count} nodes"))
    } else if all(|edit| matches!(edit, Edit::SetMuted { muted: true, .. })) {
        Some(trn!(count, "mute {count} nodes", "mute {count} nodes"))
    } else if all(|edit| matches!(edit, Edit::SetMuted { muted: false, .. })) {
        Some(trn!(count, "unmute {count} nodes", "unmute {count} nodes"))
    } else if all(|edit| matches!(edit, Edit::SetLight { .. })) {
        Some(trn!(count, "change {count} lights", "change {count} lights"))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Editable, GraphId, Look, Scene, SceneEdit};
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
        let two = Edit::Group { edits: vec![set(2.0), set(3.0)] };
        assert_eq!(look.label(&two), "change 2 lights");
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
    }
}
