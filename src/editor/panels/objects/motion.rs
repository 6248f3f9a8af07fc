//! Motion that meshes' files bring: the animation that an object plays, and the camera of the
//! picture.

use chiaro_locale::tr;
use eframe::egui::{ComboBox, RichText, Role, Ui, WidgetInfo};

use super::details::Fields;
use crate::commands::{Command, SceneCommand};
use crate::document::{FileCamera, MeshAnimation, SceneEdit};
use crate::fields::{row, shot};
use crate::state::scene::OpenScene;
use crate::state::session::Session;
use crate::widgets::number::number_field;
use crate::widgets::theme;

/// Fields of an animation, by which a shot changes it.
const ANIMATION: [&str; 4] =
    ["animation.name", "animation.speed", "animation.offset", "animation.loops"];

/// Shows the animation that an object plays, where its mesh has any or the scene names one.
pub(super) fn animation(ui: &mut Ui, fields: &mut Fields<'_>) {
    let (open_scene, id, played) = (fields.open_scene, fields.id, &fields.object.animation);
    let names = open_scene.place(id).map_or(&[][..], |place| &place.animations);
    if names.is_empty() && played.is_none() {
        return;
    }
    let mut new = played.clone();
    let mut widget = None;
    let help = tr!("The animation of the mesh's file that it plays");
    fields.row(ui, (tr!("Animation"), help), &ANIMATION[..1], |ui, label| {
        let first = names.first().map_or(tr!("the first"), String::as_str);
        let shown = |animation: &MeshAnimation| match animation.name.as_str() {
            "" => first.to_owned(),
            name => name.to_owned(),
        };
        let text = new.as_ref().map_or_else(|| tr!("animation" => "None").to_owned(), shown);
        let combo = ComboBox::from_id_salt("animation").selected_text(text);
        let combo = combo.width(ui.available_width() - 12.0).show_ui(ui, |ui| {
            if ui.selectable_label(new.is_none(), tr!("animation" => "None")).clicked() {
                new = None;
            }
            for name in names {
                let is_it = new.as_ref().is_some_and(|animation| shown(animation) == *name);
                if ui.selectable_label(is_it, name).clicked() && !is_it {
                    let before = new.take().unwrap_or_default();
                    new = Some(MeshAnimation { name: name.clone(), ..before });
                }
            }
        });
        widget = Some(combo.response.labelled_by(label).id);
    });
    if let Some(animation) = &mut new {
        let help = tr!("Seconds of the animation in a second of the scene; below 0 backwards");
        fields.row(ui, (tr!("Speed"), help), &ANIMATION[1..2], |ui, _| {
            let drag = number_field(ui, &mut animation.speed).speed(0.01).range(-1000.0..=1000.0);
            let response = ui.add(drag.max_decimals(3).suffix(" ×"));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Speed")));
            widget = Some(response.id).filter(|_| response.changed()).or(widget);
        });
        let help = tr!("The time in the animation at the scene's time 0, in seconds");
        fields.row(ui, (tr!("Offset"), help), &ANIMATION[2..], |ui, _| {
            let drag = number_field(ui, &mut animation.offset).speed(0.02);
            let response = ui.add(drag.max_decimals(3).suffix(" s"));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Offset")));
            widget = Some(response.id).filter(|_| response.changed()).or(widget);
            let loops = ui.checkbox(&mut animation.loops, tr!("Loops"));
            let help = tr!("Begins anew after its last key; else what it ends with holds");
            widget = Some(loops.on_hover_text(help).id).or(widget);
        });
    }
    let Some(widget) = widget.filter(|_| new != *played) else { return };
    let edit = open_scene.change(id, |object| object.animation = new);
    fields.out.extend(edit.map(|edit| SceneCommand::EditHeld(widget, edit)));
}

/// Shows the camera of the picture, where a mesh's file brings one or the scene names one.
pub(super) fn camera(
    ui: &mut Ui,
    session: &Session,
    open_scene: &OpenScene,
    out: &mut Vec<SceneCommand>,
    commands: &mut Vec<Command>,
) {
    let own = &open_scene.scene().file_camera;
    let of_files = open_scene.placed.iter().flat_map(|place| {
        let object = place.id.to_string();
        place
            .cameras
            .iter()
            .map(move |name| FileCamera { object: object.clone(), name: name.clone() })
    });
    let of_files: Vec<FileCamera> = of_files.collect();
    if of_files.is_empty() && own.is_none() {
        return;
    }
    let targets = ["file_camera.object", "file_camera.name"].map(str::to_owned);
    let help = tr!(
        "Whose camera pictures of the scene are drawn from: its own, or one that a mesh's file \
         brings"
    );
    let text = RichText::new(tr!("Camera")).color(theme::of(ui).text);
    let slot = |ui: &mut Ui, size| shot::mark(ui, size, session, &targets, tr!("Camera"), commands);
    row::with_slot(ui, text, help, slot, |ui, label| {
        let shown = |camera: &FileCamera| match camera.name.as_str() {
            "" => tr!("the first of {object}", object = camera.object),
            name => tr!("{name} of {object}", object = camera.object),
        };
        let now = own.as_ref().map_or_else(|| tr!("The scene's own").to_owned(), shown);
        let combo = ComboBox::from_id_salt("file camera").selected_text(now);
        let combo = combo.width(ui.available_width() - 12.0).show_ui(ui, |ui| {
            let mut choose = |ui: &mut Ui, text: String, camera: Option<FileCamera>| {
                let is_it = *own == camera;
                if ui.selectable_label(is_it, text).clicked() && !is_it {
                    out.push(SceneCommand::Edit(SceneEdit::SetFileCamera { camera }));
                }
            };
            choose(ui, tr!("The scene's own").to_owned(), None);
            for camera in of_files {
                choose(ui, shown(&camera), Some(camera));
            }
        });
        combo.response.labelled_by(label);
    });
}
