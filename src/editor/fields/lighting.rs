//! Lights of the look and of the scene around it: listed alike, changed alike, and moved by keys
//! alike. They differ only in the document that an edit goes to.

use chiaro_locale::tr;
use eframe::egui;
use indexmap::IndexMap;

use crate::commands::{Command, SceneCommand};
use crate::document::{Edit, Light, LightField, Look, SceneEdit, Target, Value};
use crate::frame::set_light_field;
use crate::ids::{LightId, make_slug};
pub(crate) use crate::state::keying::Owner;
use crate::state::keying::{KeyedBy, KeyedLook, scene_edit};
use crate::state::reading::light_name;
use crate::state::session::Session;

/// A light with the document that it belongs to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnedLight<'s> {
    pub(crate) owner: Owner,
    pub(crate) id: &'s LightId,
    pub(crate) light: &'s Light,
}

/// A light's id in the looks of a scene: how many have it, and with which light.
pub(crate) struct SharedLight {
    /// Number of looks that have such a light.
    pub(crate) looks: usize,
    /// Light of the first such look.
    pub(crate) light: Light,
}

/// Edit of the document that has the light.
#[expect(clippy::large_enum_variant, reason = "one at a time, on the stack")]
pub(crate) enum Change {
    Look(Edit),
    Scene(SceneEdit),
}

impl Change {
    /// The edit as an undo step of its own.
    pub(crate) fn once(self) -> Command {
        match self {
            Self::Look(edit) => Command::Edit(edit),
            Self::Scene(edit) => Command::Scene(SceneCommand::Edit(edit)),
        }
    }

    /// The edit as part of the step that goes on for as long as the same widget is held.
    pub(crate) fn held(self, widget: egui::Id) -> Command {
        match self {
            Self::Look(edit) => Command::EditHeld(widget, edit),
            Self::Scene(edit) => Command::Scene(SceneCommand::EditHeld(widget, edit)),
        }
    }
}

/// Keys of a document in view, with the commands that change them.
#[derive(Clone, Copy)]
pub(crate) struct OwnedKeys<'s> {
    pub(crate) session: &'s Session,
    pub(crate) owner: Owner,
    pub(crate) keys: KeyedLook<'s>,
}

impl<'s> OwnedKeys<'s> {
    /// The keys of a document; `None` for those of a scene where there is none.
    pub(crate) fn of(session: &'s Session, owner: Owner) -> Option<Self> {
        Some(Self { session, owner, keys: owner.keys(session)? })
    }

    /// The keys of the open look.
    pub(crate) fn of_look(session: &'s Session) -> Self {
        Self { session, owner: Owner::Look, keys: session.keys() }
    }

    /// The keys of the open look, then those of the scene around it.
    pub(crate) fn all(session: &'s Session) -> impl Iterator<Item = Self> {
        [Owner::Look, Owner::Scene].into_iter().filter_map(|owner| Self::of(session, owner))
    }

    /// The look that has the keys: the open one, or one of nothing but the scene's lights.
    pub(crate) fn look(self) -> &'s Look {
        self.keys.base.look
    }

    /// True if the scene has a light of this id, which stands in place of the look's: values of
    /// that change nothing.
    pub(crate) fn is_replaced(self, light: &LightId) -> bool {
        let of_scene = Owner::Scene.lights(self.session);
        self.owner == Owner::Look && of_scene.is_some_and(|lights| lights.contains_key(light))
    }

    /// An edit of that look as an undo step of its own.
    pub(crate) fn once(self, edit: Edit) -> Option<Command> {
        self.owner.change(self.session, edit).map(Change::once)
    }

    /// An edit of that look as part of the step that goes on for as long as a widget is held.
    pub(crate) fn held(self, widget: egui::Id, edit: Edit) -> Option<Command> {
        self.owner.change(self.session, edit).map(|change| change.held(widget))
    }
}

impl Owner {
    /// Lights of the look, or those of the scene, if there is one.
    pub(crate) fn lights(self, session: &Session) -> Option<&IndexMap<LightId, Light>> {
        match self {
            Self::Look => Some(&session.look().lights),
            Self::Scene => session.open_scene().map(|open_scene| &open_scene.scene().lights),
        }
    }

    /// Keys that move lights of the document.
    pub(crate) fn keys(self, session: &Session) -> Option<KeyedLook<'_>> {
        match self {
            Self::Look => Some(session.keys()),
            Self::Scene => session.keys().of_scene(),
        }
    }

    /// The edit of the document that does what an edit of the look of its [`keys`](Self::keys)
    /// does; `None` where nothing changes.
    pub(crate) fn change(self, session: &Session, edit: Edit) -> Option<Change> {
        match self {
            Self::Look => Some(Change::Look(edit)),
            Self::Scene => scene_edit(session.open_scene()?.scene(), edit).map(Change::Scene),
        }
    }

    /// The edit of the document that changes nothing.
    fn nothing(self) -> Change {
        match self {
            Self::Look => Change::Look(Edit::Group { edits: Vec::new() }),
            Self::Scene => Change::Scene(SceneEdit::Group { edits: Vec::new() }),
        }
    }

    /// Document whose keys move a field of a light: the scene's stand over the look's.
    pub(crate) fn of_keys(session: &Session, target: &Target) -> Option<Self> {
        let moves = |owner: &Self| {
            let keys = owner.keys(session);
            keys.is_some_and(|keys| keys.keyed_by(target) != KeyedBy::Nothing)
        };
        [Self::Scene, Self::Look].into_iter().find(moves)
    }

    /// An id that no other light of the same document has.
    pub(crate) fn free_id(self, session: &Session, base: &str) -> LightId {
        let lights = self.lights(session);
        LightId::new(make_slug(base, |slug| lights.is_some_and(|lights| lights.contains_key(slug))))
    }

    /// Adds a light under a free id.
    pub(crate) fn add(self, id: LightId, light: Light, index: Option<usize>) -> Change {
        match self {
            Self::Look => Change::Look(Edit::AddLight { id, light, index }),
            Self::Scene => Change::Scene(SceneEdit::AddLight { id, light, index }),
        }
    }
}

impl<'s> OwnedLight<'s> {
    /// The light that lights the look under an id: the scene's, where it has one.
    pub(crate) fn lighting(session: &'s Session, id: &'s LightId) -> Option<Self> {
        let of = |owner: Owner| Some(Self { owner, id, light: owner.lights(session)?.get(id)? });
        of(Owner::Scene).or_else(|| of(Owner::Look))
    }

    /// Display name of the light.
    pub(crate) fn name(&self) -> &'s str {
        light_name(self.id, self.light)
    }

    /// Display name that tells the light from the other document's light of the same name.
    pub(crate) fn full_name(&self) -> String {
        match self.owner {
            Owner::Look => self.name().to_owned(),
            Owner::Scene => tr!("{light} of the scene", light = self.name()),
        }
    }

    /// The light with its keyed fields as they are at the keys where they are set.
    pub(crate) fn as_set(&self, session: &Session) -> Light {
        let mut shown = self.light.clone();
        let Some(keys) = self.owner.keys(session) else { return shown };
        for field in LightField::ALL {
            let target = self.target(field.name());
            if keys.keyed_by(&target) != KeyedBy::Nothing
                && let Some(value) = keys.value_at(&target)
            {
                set_light_field(&mut shown, field.name(), &value);
            }
        }
        shown
    }

    /// Target of a field, as keys of the look name it.
    pub(crate) fn target(&self, field: &str) -> Target {
        Target::Light { light: self.id.clone(), field: field.to_owned() }
    }

    /// The edit from one state of the light to another: a keyed field is set at its key, all others
    /// in the light.
    pub(crate) fn changed(&self, session: &Session, old: &Light, new: &Light) -> Change {
        let differs = |field: &LightField| field.get(old) != field.get(new);
        let fields: Vec<LightField> = LightField::ALL.into_iter().filter(differs).collect();
        let is_about =
            |light: &Light| (light.kind, light.space, light.groups.clone(), light.aimed_at.clone());
        if is_about(new) == is_about(old) && !fields.is_empty() {
            let values = fields.iter().map(|field| (self.target(field.name()), field.get(new)));
            // Where the keys have these values already there is nothing to change: the light itself
            // would be another thing.
            return match self.owner.keys(session).map(|keys| keys.set_all_at(values)) {
                Some(edit) => self.owner.change(session, edit).unwrap_or(self.owner.nothing()),
                None => self.set(new.clone()),
            };
        }
        let (kind, space, groups, aimed_at) = is_about(new);
        self.set(Light { kind, space, groups, aimed_at, ..self.light.clone() })
    }

    /// Replaces the light.
    pub(crate) fn set(&self, light: Light) -> Change {
        let id = self.id.clone();
        match self.owner {
            Owner::Look => Change::Look(Edit::SetLight { id, light }),
            Owner::Scene => Change::Scene(SceneEdit::SetLight { id, light }),
        }
    }

    /// Removes the light.
    pub(crate) fn remove(&self) -> Change {
        let id = self.id.clone();
        match self.owner {
            Owner::Look => Change::Look(Edit::RemoveLight { id }),
            Owner::Scene => Change::Scene(SceneEdit::RemoveLight { id }),
        }
    }

    /// Adds a copy of the light, after it.
    pub(crate) fn duplicate(&self, session: &Session) -> Change {
        let mut light = self.light.clone();
        if !light.name.is_empty() {
            light.name += " copy";
        }
        let base =
            self.id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
        let base = if base.is_empty() { self.id.as_str() } else { base };
        let index = self.owner.lights(session).and_then(|lights| lights.get_index_of(self.id));
        self.owner.add(self.owner.free_id(session, base), light, index.map(|index| index + 1))
    }

    /// Lets a scene's light stand in place of another light of the looks. `None` for a light of a
    /// look.
    pub(crate) fn stand_in_for(&self, session: &Session, id: &LightId) -> Option<Change> {
        let index = Owner::Scene
            .lights(session)
            .filter(|_| self.owner == Owner::Scene)?
            .get_index_of(self.id);
        let edits = vec![
            SceneEdit::AddLight { id: id.clone(), light: self.light.clone(), index },
            SceneEdit::RemoveLight { id: self.id.clone() },
        ];
        Some(Change::Scene(SceneEdit::Group { edits }))
    }
}

/// The edit that sets a field of the look's light in view: at a key of the look, or else in the
/// document that the light belongs to.
pub(crate) fn set_light_at(session: &Session, id: &LightId, field: &str, value: Value) -> Change {
    let target = Target::Light { light: id.clone(), field: field.to_owned() };
    let of_scene = session.keys().light_of_scene(id);
    match (Owner::of_keys(session, &target), of_scene) {
        (Some(Owner::Scene), _) => {
            let keys = Owner::Scene.keys(session);
            let edit = keys.map(|keys| keys.set_at(&target, value));
            let change = edit.and_then(|edit| Owner::Scene.change(session, edit));
            change.unwrap_or(Owner::Scene.nothing())
        }
        (None, Some(light)) => {
            let mut light = light.clone();
            set_light_field(&mut light, field, &value);
            Change::Scene(SceneEdit::SetLight { id: id.clone(), light })
        }
        _ => Change::Look(session.keys().set_at(&target, value)),
    }
}

/// The edit that gives the light in view the fields in which another light differs from it, as
/// [`set_light_at`] does for one.
pub(crate) fn set_light_like(session: &Session, id: &LightId, new: &Light) -> Option<Change> {
    let old = light_in_view(session, id)?;
    let differs = |field: &LightField| field.get(old) != field.get(new);
    let fields: Vec<LightField> = LightField::ALL.into_iter().filter(differs).collect();
    let target =
        |field: LightField| Target::Light { light: id.clone(), field: field.name().to_owned() };
    let owner_of = |field: &LightField| Owner::of_keys(session, &target(*field));
    if fields.is_empty() {
        return None;
    }
    let is_of_scene = session.keys().light_of_scene(id).is_some();
    let is_keyed_by_look = fields.iter().any(|field| owner_of(field) == Some(Owner::Look));
    let owner = if is_of_scene && !is_keyed_by_look { Owner::Scene } else { Owner::Look };
    let values = fields.into_iter().map(|field| (target(field), field.get(new)));
    let edit = owner.keys(session)?.set_all_at(values);
    owner.change(session, edit)
}

/// The light of an id with its present values, of the look or of the scene around it.
pub(crate) fn light_in_view<'s>(session: &'s Session, id: &'s LightId) -> Option<&'s Light> {
    session.keys().light(id).or_else(|| Some(OwnedLight::lighting(session, id)?.light))
}

/// Lights that a light of the scene can stand in for: those of the open look and of all others
/// in the scene, by id.
pub(crate) fn lights_of_looks(session: &Session) -> IndexMap<LightId, SharedLight> {
    let mut found: IndexMap<LightId, SharedLight> = IndexMap::new();
    let mut count = |look: &Look| {
        for (id, light) in &look.lights {
            let fresh = || SharedLight { looks: 0, light: light.clone() };
            found.entry(id.clone()).or_insert_with(fresh).looks += 1;
        }
    };
    count(session.look());
    session
        .open_scene()
        .into_iter()
        .flat_map(|open_scene| open_scene.snapshot().other_looks())
        .for_each(|look| count(&look.look));
    found
}
