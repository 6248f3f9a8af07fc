//! Links of an object: the set of lights that reach it, and of those that do not all the same;
//! whose shadows it casts, and onto what.

use eframe::egui::{CollapsingHeader, Id, Ui};

use crate::commands::SceneCommand;
use crate::document::{MemberSet, Object, SetMember};
use crate::fields::row::labelled;
use crate::ids::ObjectId;
use crate::state::scene::OpenScene;
use crate::widgets::text;

/// Words on how a set is written, for tooltips.
const SETS: &str = "* is every light. key | group:rim - group:set says more: ids, \"names\" and \
                    groups, with | for either, - for without, & for both, and ( )";

/// Words on how a set of objects is written, for tooltips.
const OBJECTS: &str = "* is every object. floor | wall-* says more: ids, with | for either, - for \
                       without, & for both, and ( )";

/// Row for a set of an object.
struct SetRow<M: SetMember> {
    label: &'static str,
    help: &'static str,
    set: fn(&mut Object) -> &mut MemberSet<M>,
}

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
    let of = (open_scene, id, object);
    ui.push_id((id, "lights"), |ui| {
        SetRow { label: "Lit by", help: "Lights that reach it.", set: |object| &mut object.linked }
            .show(ui, of, SETS, out);
        SetRow {
            label: "Not lit by",
            help: "Lights that do not reach it all the same; {source} is Lit by.",
            set: |object| &mut object.unlinked,
        }
        .show(ui, of, SETS, out);
        let header = CollapsingHeader::new("Shadows")
            .id_salt("shadows")
            .default_open(!object.shadow_link().is_all());
        header.show(ui, |ui| shadows(ui, of, out));
    });
}

/// Shows whose shadows an object casts, and onto what.
fn shadows(ui: &mut Ui, of: (&OpenScene, &ObjectId, &Object), out: &mut Vec<SceneCommand>) {
    SetRow {
        label: "Of lights",
        help: "Lights whose shadows it casts, where looks ask for shadows.",
        set: |object| &mut object.shadowed,
    }
    .show(ui, of, SETS, out);
    SetRow {
        label: "Not of lights",
        help: "Lights whose shadows it does not cast all the same; {source} is Of lights.",
        set: |object| &mut object.unshadowed,
    }
    .show(ui, of, SETS, out);
    SetRow {
        label: "Onto",
        help: "Objects that its shadows fall on, itself among them.",
        set: |object| &mut object.shadows_on,
    }
    .show(ui, of, OBJECTS, out);
    SetRow {
        label: "Not onto",
        help: "Objects that they do not fall on all the same; {source} is Onto.",
        set: |object| &mut object.no_shadows_on,
    }
    .show(ui, of, OBJECTS, out);
}

impl<M: SetMember + 'static> SetRow<M> {
    fn show(
        self,
        ui: &mut Ui,
        (open_scene, id, object): (&OpenScene, &ObjectId, &Object),
        words: &str,
        out: &mut Vec<SceneCommand>,
    ) {
        let now = (self.set)(&mut object.clone()).clone();
        labelled(ui, self.label, &format!("{} {words}", self.help), |ui, label| {
            let edit = field(ui, label, &now).and_then(|(widget, set)| {
                let edit = open_scene.change(id, |object| *(self.set)(object) = set)?;
                Some(SceneCommand::EditHeld(widget, edit))
            });
            out.extend(edit);
        });
    }
}

fn field<M: SetMember>(ui: &mut Ui, label: Id, set: &MemberSet<M>) -> Option<(Id, MemberSet<M>)> {
    let read = |text: &str| MemberSet::parse(text).map_err(|why| why.to_string());
    text::formed(ui, label, set, |set| set.text().to_owned(), read)
}
