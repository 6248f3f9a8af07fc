//! Values of a wedge's cell, taken into the open documents.

use chiaro_locale::tr;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, Edit, LightField, SceneEdit, ShotEdit, Target, Value};
use crate::ids::{LightId, NodePath, ObjectId, PortName};
use crate::state::keying::{KeyedBy, changes_in_time, scene_edit};
use crate::state::revision::GestureId;
use crate::state::shot::{ShotAddress, ShotWriter};
use crate::state::wedge::{CellScope, WedgeCell};

/// Gesture of all edits of a cell: they are one step of each document.
const TAKING: GestureId = GestureId(0x77_65_64_67_65);

/// Parts of a scene whose fields vary by their addresses, as `chiaro wedge` has them.
const SCENE_PARTS: [&str; 5] = ["light_groups", "camera", "outlines", "backdrop", "illumination"];

/// Places of a cell's values: fields of the scene, targets of the scene's lights, values of
/// objects, targets of the look, and those of one use of a group.
#[derive(Default)]
struct CellPlaces {
    fields: Vec<(String, Value)>,
    lights: Vec<(Target, Value)>,
    objects: Vec<(ObjectId, PortName, Value)>,
    look: Vec<(Target, Value)>,
    /// Targets within groups that have other uses, which keep theirs.
    uses: Vec<(Target, Value)>,
}

impl CellPlaces {
    /// Addresses of the values as a shot over `look` has them.
    fn addresses(&self, look: Option<&str>) -> Vec<ShotAddress> {
        let of_scene = |target: String| ShotAddress { look: None, target };
        let fields = self.fields.iter().map(|(address, _)| of_scene(address.clone()));
        let lights = self.lights.iter().map(|(target, _)| of_scene(target.to_string()));
        let objects = self.objects.iter();
        let objects = objects.map(|(id, name, _)| of_scene(format!("objects.{id}.values.{name}")));
        let of_look = self.look.iter().chain(&self.uses).map(|(target, _)| ShotAddress {
            look: look.map(str::to_owned),
            target: target.to_string(),
        });
        fields.chain(lights).chain(objects).chain(of_look).collect()
    }
}

impl Session {
    /// Takes the values of a cell as one step: as overrides where a shot is open, else in the scene
    /// and the look. Returns a message on what became of them.
    ///
    /// # Errors
    /// A name that the open documents do not have; nothing is changed then.
    pub(crate) fn take_cell(
        &mut self,
        cell: &WedgeCell,
        scope: CellScope,
    ) -> Result<String, Box<Diagnostic>> {
        let moved = self.moved_by_shot(cell)?;
        self.take_values(cell)?;
        if scope == CellScope::WholeShot {
            self.hold_in_shot(moved.iter().flat_map(|(_, addresses)| addresses))?;
        }
        self.end_gestures();
        let values = cell.value_text();
        let Some(shot) = self.shot() else { return Ok(tr!("Set: {values}")) };
        let frame = shot.frame_at(self.view.time);
        let is_keyed = |name: &&str| moved.iter().any(|(moved, _)| moved == name);
        let (keyed, held): (Vec<&str>, Vec<&str>) =
            cell.values.iter().map(|(name, _)| name.as_str()).partition(is_keyed);
        Ok(match (keyed.is_empty() || scope == CellScope::WholeShot, held.is_empty()) {
            (true, _) => tr!("For the whole shot: {values}"),
            (false, true) => tr!("A key at frame {frame}: {values}"),
            (false, false) => tr!(
                "A key at frame {frame} of {keyed}; for the whole shot {held}",
                keyed = keyed.join(", "),
                held = held.join(", ")
            ),
        })
    }

    /// Names of a cell's values that the open shot has keys of, each with its addresses there.
    fn moved_by_shot(
        &self,
        cell: &WedgeCell,
    ) -> Result<Vec<(String, Vec<ShotAddress>)>, Box<Diagnostic>> {
        let mut moved = Vec::new();
        let Some(shot) = self.shot() else { return Ok(moved) };
        let is_moved = |at: &ShotAddress| {
            let change = shot.resolved().change_of(at.look.as_deref(), &at.target);
            change.is_some_and(|change| change.is_keyed)
        };
        for (name, value) in &cell.values {
            let mut places = CellPlaces::default();
            self.place_value(name, value, &mut places)?;
            let mut addresses = places.addresses(shot.open_look().as_deref());
            addresses.retain(is_moved);
            if !addresses.is_empty() {
                moved.push((name.clone(), addresses));
            }
        }
        Ok(moved)
    }

    /// Sets values of the shot to what they are now, in place of their keys, as part of the step in
    /// which a cell is taken.
    fn hold_in_shot<'a>(
        &mut self,
        addresses: impl Iterator<Item = &'a ShotAddress>,
    ) -> Result<(), Box<Diagnostic>> {
        // The keys have just been set.
        self.refresh_keys();
        let Some(shot) = self.shot() else { return Ok(()) };
        let mut edits = Vec::new();
        for at in addresses {
            let mut writer = ShotWriter::new(shot, at.look.clone(), self.view.time);
            if let Some(value) = self.value_in_shot(at) {
                writer.set_for_all(&at.target, value);
            }
            edits.extend(writer.finish());
        }
        if !edits.is_empty() {
            self.apply_to_shot(ShotEdit::Group { edits }, Some(TAKING))?;
        }
        Ok(())
    }

    fn take_values(&mut self, cell: &WedgeCell) -> Result<(), Box<Diagnostic>> {
        // What keys move takes the value at the frame that the cell shows.
        if let Some((frame, shot)) = cell.frame.zip(self.shot()) {
            self.set_time(shot.rate().time(frame));
        }
        let mut places = CellPlaces::default();
        for (name, value) in &cell.values {
            self.place_value(name, value, &mut places)?;
        }
        self.end_gestures();
        let steps_of_scene = self.steps_of_scene();
        if !places.lights.is_empty()
            && let Some(open_scene) = self.open_scene()
            && let Some(keys) = self.keys().of_scene()
        {
            let edit = keys.set_all_at(places.lights);
            if let Some(edit) = scene_edit(open_scene.scene(), edit) {
                self.apply_to_scene(edit, Some(TAKING))?;
            }
        }
        let objects = self.open_scene().map(|open_scene| open_scene.scene().objects.clone());
        let mut objects = objects.unwrap_or_default();
        let mut changed = Vec::new();
        for (id, name, value) in places.objects {
            if let Some(object) = objects.get_mut(&id) {
                object.values.insert(name, value);
                changed.push(id);
            }
        }
        changed.dedup();
        let edit = |id: ObjectId| {
            let object = Box::new(objects.get(&id)?.clone());
            Some(SceneEdit::SetObject { id, object })
        };
        let edits: Vec<SceneEdit> = changed.into_iter().filter_map(edit).collect();
        if !edits.is_empty() {
            self.apply_to_scene(SceneEdit::Group { edits }, Some(TAKING))?;
        }
        if let Some(open_scene) = self.open_scene().filter(|_| !places.fields.is_empty()) {
            let mut scene = open_scene.scene().clone();
            for (address, value) in &places.fields {
                scene.set_value(address, value)?;
            }
            self.apply_to_scene(SceneEdit::Replace { scene: Box::new(scene) }, Some(TAKING))?;
        }
        let keys = self.keys();
        let mut edits: Vec<Edit> =
            places.uses.into_iter().map(|(target, value)| keys.hold(&target, value)).collect();
        if !places.look.is_empty() {
            match keys.set_all_at(places.look) {
                Edit::Group { edits: several } => edits.extend(several),
                edit => edits.push(edit),
            }
        }
        if !edits.is_empty() {
            let edit = Edit::Group { edits };
            // What is done in the look is part of what was done in the scene.
            let is_done = self.steps_of_scene() != steps_of_scene;
            let done = self.open_scene().filter(|_| is_done);
            let time = done.and_then(|open_scene| open_scene.document.times.last());
            let time = time.unwrap_or(self.revisions.step.next());
            if let Err(problem) = self.apply_at(edit, Some(TAKING), time) {
                if is_done {
                    self.undo();
                }
                return Err(problem);
            }
        }
        Ok(())
    }

    fn steps_of_scene(&self) -> usize {
        self.open_scene().map_or(0, |open_scene| open_scene.history().place())
    }

    fn end_gestures(&mut self) {
        self.look.end_gesture();
        if let Some(open_scene) = self.open_scene_mut() {
            open_scene.end_gesture();
        }
    }

    /// Finds what a name stands for, as `chiaro wedge` does: a light's field before a parameter
    /// before a node's input.
    fn place_value(
        &self,
        name: &str,
        value: &Value,
        places: &mut CellPlaces,
    ) -> Result<(), Box<Diagnostic>> {
        let is_field = SCENE_PARTS.contains(&name.split('.').next().unwrap_or_default());
        if let Some(open_scene) = self.open_scene().filter(|_| is_field) {
            open_scene.scene().clone().set_value(name, value)?;
            places.fields.push((name.to_owned(), value.clone()));
            return Ok(());
        }
        let (owner, part) = name.rsplit_once('.').unwrap_or(("", name));
        let light = LightId::from(owner.strip_prefix("lights.").unwrap_or(owner));
        let scene = self.open_scene().map(|open_scene| open_scene.scene());
        let of_scene = scene.is_some_and(|scene| scene.lights.contains_key(&light));
        if of_scene || self.look().lights.contains_key(&light) {
            let target = Target::Light { light, field: part.to_owned() };
            // Lights of scenes have colors as shown; those of a look have its own space.
            let space = if of_scene { ColorSpace::Display } else { self.look().color_space };
            let value = light_value(part, value, space);
            match of_scene {
                true => places.lights.push((target, value)),
                false => places.look.push((target, value)),
            }
            return Ok(());
        }
        let parameters = self.look_with_library().parameters();
        let exposed = parameters.iter().find(|parameter| parameter.name.as_str() == part);
        let wears = |id: &ObjectId, object: &crate::document::Object| {
            let is_asked = owner.is_empty() || id.as_str() == owner;
            is_asked
                && (object.values.contains_key(part)
                    || exposed.is_some()
                        && self.open_scene().is_some_and(|scene| scene.wears_open(object)))
        };
        let objects = scene.into_iter().flat_map(|scene| &scene.objects);
        let found: Vec<ObjectId> =
            objects.filter(|(id, object)| wears(id, object)).map(|(id, _)| id.clone()).collect();
        if !found.is_empty() {
            let port = PortName::from(part);
            places.objects.extend(found.into_iter().map(|id| (id, port.clone(), value.clone())));
            return Ok(());
        }
        let of_parameter = || {
            let is_it = |exposed: &&crate::document::ExposedValue| exposed.name.as_str() == part;
            Some(self.look().exposed.iter().find(is_it)?.target.clone())
        };
        let target = match owner {
            "" => of_parameter(),
            owner => {
                let node = NodePath::parse(owner);
                let is_there = self.look_with_library().node_at(&node).is_some();
                is_there.then(|| Target::Input { node, port: part.into() })
            }
        };
        let Some(target) = target else {
            let message = tr!("nothing open here has `{name}`: open what the wedge is of");
            return Err(Box::new(Diagnostic::error("unknown-target", message)));
        };
        let of_target = match self.is_of_one_use(&target) {
            true => {
                self.check_held(&target)?;
                &mut places.uses
            }
            false => &mut places.look,
        };
        of_target.push((target, value.clone()));
        Ok(())
    }

    /// True for an input without keys in a group that has other uses, or is the library's.
    fn is_of_one_use(&self, target: &Target) -> bool {
        let Target::Input { node, .. } = target else { return false };
        let moves = match self.keys().keyed_by(target) {
            KeyedBy::Nothing => false,
            KeyedBy::Time(track) => self.look().time_keys[track].keys.len() > 1,
            KeyedBy::Direction(_) => true,
        };
        let is_shared = || {
            let is_own = self.look().find(node).is_some();
            !is_own || self.look_with_library().uses_around(target).len() > 1
        };
        node.parent().is_some() && !moves && is_shared()
    }

    /// Checks that a value can be held by a key.
    fn check_held(&self, target: &Target) -> Result<(), Box<Diagnostic>> {
        let port = self.look_with_library().port_at(target);
        if port.is_some_and(|port| changes_in_time(&port.ty)) {
            return Ok(());
        }
        let message = tr!(
            "`{target}` is built into a group that is used elsewhere, too: make it an input of the \
             group"
        );
        Err(Box::new(Diagnostic::error("used-more-than-once", message)))
    }
}

/// A value for a field of a light of a color space: a color as text is one as shown.
fn light_value(field: &str, value: &Value, space: ColorSpace) -> Value {
    let is_color = LightField::named(field).is_some_and(|field| field == LightField::Color);
    match value {
        Value::Text(_) if is_color => {
            let color = value.color_in(space);
            color.map_or_else(|| value.clone(), |color| Value::Vector(color[..3].to_vec()))
        }
        value => value.clone(),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::library::Library;
    use crate::state::session::shot::tests::opened;

    /// A session of a look in which a group is used once or twice.
    fn session(is_twice: bool) -> Session {
        let second = r#", {"id": "second", "kind": "part"}"#;
        let text = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}}, "nodes": [
            {"id": "first", "kind": "part"}SECOND, {"id": "output", "kind": "output"}],
            "wires": [{"from": "first", "to": "output.color"}],
            "definitions": {"part": {"outputs": [{"name": "color"}], "nodes": [{"id": "lit",
                "kind": "light_layer", "values": {"light": "key", "opacity": 0.5}}],
                "wires": [{"from": "lit", "to": "outputs.color"}]}}}"#;
        let text = text.replace("SECOND", if is_twice { second } else { "" });
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.start_from(&text, "groups");
        session
    }

    fn cell(name: &str, value: Value) -> WedgeCell {
        WedgeCell { values: vec![(name.to_owned(), value)], frame: None, place: None }
    }

    fn own_value(session: &Session) -> Value {
        session.look().definitions["part"].graph.nodes["lit"].values["opacity"].clone()
    }

    #[test]
    fn a_value_within_a_group_is_set_in_the_use_that_was_varied() {
        let taken = cell("first/lit.opacity", Value::Number(0.25));
        let mut once = session(false);
        once.take_cell(&taken, CellScope::AsKeyed).unwrap();
        assert_eq!(own_value(&once), Value::Number(0.25));
        assert!(once.look().time_keys.is_empty());

        let mut twice = session(true);
        let before = twice.look().clone();
        twice.take_cell(&taken, CellScope::AsKeyed).unwrap();
        let [track] = twice.look().time_keys.as_slice() else { panic!("one track") };
        assert_eq!(track.target.to_string(), "first/lit.opacity");
        assert_eq!(track.keys[0].value, Value::Number(0.25));
        assert_eq!(own_value(&twice), Value::Number(0.5), "the other use keeps its value");
        // A value that is held is another one next time.
        let one = cell("first/lit.opacity", Value::Number(1.0));
        twice.take_cell(&one, CellScope::AsKeyed).unwrap();
        assert_eq!(twice.look().time_keys[0].keys[0].value, Value::Number(1.0));
        twice.undo();
        twice.undo();
        assert_eq!(*twice.look(), before);
        let fixed = cell("first/lit.light", Value::Text("key".to_owned()));
        assert_eq!(
            twice.take_cell(&fixed, CellScope::AsKeyed).unwrap_err().code,
            "used-more-than-once"
        );
        assert_eq!(*twice.look(), before);
    }

    #[test]
    fn a_cell_of_a_shot_tells_what_it_keys_and_can_hold_for_all_frames() {
        let folder = tempfile::tempdir().unwrap();
        let mut session = opened(folder.path());
        session.refresh_keys();
        let before = session.shot().unwrap().shot().clone();
        let mut taken = cell("sun.intensity", Value::Number(3.0));
        taken.frame = Some(7);
        let told = session.take_cell(&taken, CellScope::AsKeyed).unwrap();
        assert_eq!(told, "A key at frame 7: sun.intensity = 3");
        let [own] = session.shot().unwrap().shot().overrides.as_slice() else { panic!("one") };
        assert_eq!(own.keys.iter().map(|key| key.frame).collect::<Vec<f64>>(), [1.0, 7.0, 24.0]);
        // The same once more, for all frames: there the value is what it was at that frame.
        let told = session.take_cell(&taken, CellScope::WholeShot).unwrap();
        assert_eq!(told, "For the whole shot: sun.intensity = 3");
        let [own] = session.shot().unwrap().shot().overrides.as_slice() else { panic!("one") };
        assert_eq!((own.value.as_ref(), own.keys.len()), (Some(&Value::Number(3.0)), 0));
        session.undo();
        session.undo();
        assert_eq!(*session.shot().unwrap().shot(), before, "each was one step");
        // Both in one step.
        session.take_cell(&taken, CellScope::WholeShot).unwrap();
        session.undo();
        assert_eq!(*session.shot().unwrap().shot(), before);
        taken.values.push(("sun.color".to_owned(), Value::Text("#ff8000".to_owned())));
        let told = session.take_cell(&taken, CellScope::AsKeyed).unwrap();
        let wanted = "A key at frame 7 of sun.intensity; for the whole shot sun.color";
        assert_eq!(told, wanted);
    }

    #[test]
    fn a_word_is_held_in_one_use_of_a_group_of_the_look_or_of_the_library() {
        let mut of_library = session(false);
        let text = r#"{"chiaro": "look", "nodes": [{"id": "bands", "kind": "band_layer"},
            {"id": "output", "kind": "output"}],
            "wires": [{"from": "bands", "to": "output.color"}]}"#;
        of_library.start_from(text, "bands");
        let words = [
            (session(true), "first/lit.blend", "multiply"),
            (of_library, "bands/colors.space", "oklab"),
        ];
        for (mut session, name, word) in words {
            let before = session.look().clone();
            let word = Value::Text(word.to_owned());
            session.take_cell(&cell(name, word.clone()), CellScope::AsKeyed).unwrap();
            let [track] = session.look().time_keys.as_slice() else { panic!("one track") };
            assert_eq!((track.target.to_string(), &track.keys[0].value), (name.to_owned(), &word));
            assert_eq!(session.look().definitions, before.definitions);
            session.undo();
            assert_eq!(*session.look(), before);
        }
    }
}
