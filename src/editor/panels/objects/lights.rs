//! Links of an object: the set of lights that reach it, and of those that do not all the same;
//! whose shadows it casts, and onto what.

use chiaro_locale::{Text, text, tr};
use eframe::egui::{CollapsingHeader, Id, Ui};

use crate::commands::SceneCommand;
use crate::document::{Light, MemberSet, Object, SetMember};
use crate::fields::row::labelled;
use crate::ids::ObjectId;
use crate::state::scene::OpenScene;
use crate::widgets::text;

/// Words on how a set is written, for tooltips.
const SETS: Text = text!(
    "* is every light. key | group:rim - group:set says more: ids, \"names\" and groups, with | \
     for either, - for without, & for both, and ( )"
);

/// Words on how a set of objects is written, for tooltips.
const OBJECTS: Text = text!(
    "* is every object. floor | wall-* says more: ids, with | for either, - for without, & for \
     both, and ( )"
);

/// Row for a set of an object.
struct SetRow<M: SetMember> {
    label: Text,
    help: Text,
    set: fn(&mut Object) -> &mut MemberSet<M>,
}

/// Lights that reach an object.
const REACH: [SetRow<Light>; 2] = [
    SetRow {
        label: text!("Lit by"),
        help: text!("Lights that reach it."),
        set: |object| &mut object.linked,
    },
    SetRow {
        label: text!("Not lit by"),
        help: text!("Lights that do not reach it all the same; {source} is Lit by."),
        set: |object| &mut object.unlinked,
    },
];

/// Lights whose shadows an object casts.
const SHADOWS_OF: [SetRow<Light>; 2] = [
    SetRow {
        label: text!("Of lights"),
        help: text!("Lights whose shadows it casts, where looks ask for shadows."),
        set: |object| &mut object.shadowed,
    },
    SetRow {
        label: text!("Not of lights"),
        help: text!("Lights whose shadows it does not cast all the same; {source} is Of lights."),
        set: |object| &mut object.unshadowed,
    },
];

/// Objects that the shadows of an object fall on.
const SHADOWS_ON: [SetRow<Object>; 2] = [
    SetRow {
        label: text!("Onto"),
        help: text!("Objects that its shadows fall on, itself among them."),
        set: |object| &mut object.shadows_on,
    },
    SetRow {
        label: text!("Not onto"),
        help: text!("Objects that they do not fall on all the same; {source} is Onto."),
        set: |object| &mut object.no_shadows_on,
    },
];

/// Shows the links of an object, where the scene has lights to share out.
pub(super) fn show(
    ui: &mut Ui,
    open_scene: &OpenScene,
    id: &ObjectId,
    object: &Object,
    out: &mut Vec<SceneCommand>,
) {
    let is_plain = object.light_link().is_all() && object.shadow_link().is_all();
    if open_scene.scene().lights.is_empty() && is_plain {
        return;
    }
    // Rows reach into an object that may be changed; this one is not.
    let mut now = object.clone();
    let mut rows = ObjectRows { open_scene, id, now: &mut now, out };
    ui.push_id((id, "lights"), |ui| {
        rows.show(ui, REACH, SETS);
        let header = CollapsingHeader::new(tr!("Shadows"))
            .id_salt("shadows")
            .default_open(!object.shadow_link().is_all());
        header.show(ui, |ui| {
            rows.show(ui, SHADOWS_OF, SETS);
            rows.show(ui, SHADOWS_ON, OBJECTS);
        });
    });
}

/// Object whose sets are shown, and the commands that change them.
struct ObjectRows<'a> {
    open_scene: &'a OpenScene,
    id: &'a ObjectId,
    now: &'a mut Object,
    out: &'a mut Vec<SceneCommand>,
}

impl ObjectRows<'_> {
    /// Shows a row for each set; `words` say how such a set is written.
    fn show<M: SetMember>(&mut self, ui: &mut Ui, rows: [SetRow<M>; 2], words: Text) {
        for SetRow { label, help, set } in rows {
            let now = &*set(self.now);
            labelled(ui, label.tr(), &format!("{help} {words}"), |ui, label| {
                let edit = field(ui, label, now).and_then(|(widget, changed)| {
                    let edit = self.open_scene.change(self.id, |object| *set(object) = changed)?;
                    Some(SceneCommand::EditHeld(widget, edit))
                });
                self.out.extend(edit);
            });
        }
    }
}

fn field<M: SetMember>(ui: &mut Ui, label: Id, set: &MemberSet<M>) -> Option<(Id, MemberSet<M>)> {
    let read = |text: &str| MemberSet::parse(text).map_err(|why| why.to_string());
    text::formed(ui, label, set, |set| set.text().to_owned(), read)
}
