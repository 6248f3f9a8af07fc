//! Values of a wedge's cell, taken into the open documents.

use chiaro_locale::tr;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, Edit, LightField, SceneEdit, Target, Value};
use crate::ids::{LightId, NodePath, ObjectId, PortName};
use crate::state::keying::scene_edit;
use crate::state::revision::GestureId;
use crate::state::wedge::WedgeCell;

/// Gesture of all edits of a cell: they are one step of each document.
const TAKING: GestureId = GestureId(0x77_65_64_67_65);

/// Parts of a scene whose fields vary by their addresses, as `chiaro wedge` has them.
const SCENE_PARTS: [&str; 5] = ["light_groups", "camera", "outlines", "backdrop", "illumination"];

/// Places of a cell's values: fields of the scene, targets of the scene's lights, values of
/// objects, targets of the look.
#[derive(Default)]
struct CellPlaces {
    fields: Vec<(String, Value)>,
    lights: Vec<(Target, Value)>,
    objects: Vec<(ObjectId, PortName, Value)>,
    look: Vec<(Target, Value)>,
}

impl Session {
    /// Takes the values of a cell as one step: as overrides where a shot is open, else in the scene
    /// and the look.
    ///
    /// # Errors
    /// A name that the open documents do not have; nothing is changed then.
    pub(crate) fn take_cell(&mut self, cell: &WedgeCell) -> Result<(), Box<Diagnostic>> {
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
        if !places.look.is_empty() {
            let edit = match self.keys().set_all_at(places.look) {
                edit @ Edit::Group { .. } => edit,
                edit => Edit::Group { edits: vec![edit] },
            };
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
        self.end_gestures();
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
                let is_there = self.look().find(&node).is_some();
                is_there.then(|| Target::Input { node, port: part.into() })
            }
        };
        let Some(target) = target else {
            let message = tr!("nothing open here has `{name}`: open what the wedge is of");
            return Err(Box::new(Diagnostic::error("unknown-target", message)));
        };
        places.look.push((target, value.clone()));
        Ok(())
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
