//! Objects of the scene: a row for each, and all fields of the selected one.

mod details;
mod layers;
mod lights;
mod motion;
mod outlines;
mod parameters;
mod words;

use chiaro_locale::{text, tr};
use eframe::egui;
use eframe::egui::{
    Button, Id, Key, Label, Layout, Modifiers, Popup, Rect, RichText, Role, ScrollArea, Sense, Ui,
    UiBuilder, WidgetInfo, vec2,
};

use crate::commands::{Command, PanelId, SceneCommand};
use crate::document::{Object, SceneEdit};
use crate::fields::shot::ChangedRow;
use crate::geometry::SHAPES;
use crate::ids::ObjectId;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::scene::{OpenScene, mesh_label};
use crate::state::session::Session;
use crate::widgets::rows::{Icon, NameEdit, card_ground, icon, leave_with_pointer, undo_keys};
use crate::widgets::text::hint;
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::OBJECTS,
    text!("Objects"),
    text!("The objects of the scene: their meshes, their looks, where they stand"),
    PanelPlace::WITH_DOCUMENT,
    |bench, ui, context| bench.memory.of::<Objects>().show(ui, context.session),
);

const ROW: f32 = 40.0;

/// The panel and its state.
#[derive(Default)]
pub(crate) struct Objects {
    renaming: Option<NameEdit<ObjectId>>,
    /// Object whose row was scrolled into view.
    shown_for: Option<ObjectId>,
    details: details::Details,
}

impl Objects {
    /// Lists the objects.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        bar(ui, session, &mut out);
        let Some(open_scene) = session.open_scene() else {
            hint(
                ui,
                tr!("The look is on one object. The look's file keeps neither the mesh nor the \
                     camera nor how the lights were turned: a scene does."),
            );
            let help = tr!(
                "Makes a scene of the mesh, the camera and the lights of the picture, and saves \
                 it; the look stays a file of its own"
            );
            if ui.button(tr!("Save as a scene...")).on_hover_text(help).clicked() {
                out.push(SceneCommand::SaveAs);
            }
            hint(ui, tr!("Open shows the objects of a scene file, each in its own look."));
            return out.into_iter().map(Command::Scene).collect();
        };
        let selected = open_scene.selected().map(|(id, _)| id.clone());
        let goal = selected.clone().filter(|_| self.shown_for != selected);
        self.shown_for = selected;
        let mut commands = Vec::new();
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("objects").show(ui, |ui| {
            // The margin is room for the scroll bar.
            ui.set_max_width(ui.available_width() - 8.0);
            words::show(ui, session, open_scene.scene(), &mut out, &mut commands);
            motion::camera(ui, session, open_scene, &mut out, &mut commands);
            if open_scene.scene().objects.is_empty() {
                hint(ui, tr!("The scene has no objects yet."));
            }
            ui.spacing_mut().item_spacing.y = 2.0;
            for (id, object) in &open_scene.scene().objects {
                let row = self.row(ui, session, (id, object), &mut out, &mut commands);
                if goal.as_ref() == Some(id) {
                    // The row is scrolled into view with the beginning of the fields below it.
                    ui.scroll_to_rect(row.with_max_y(row.max.y + 3.0 * ROW), None);
                }
                if open_scene.selected().is_some_and(|(selected, _)| selected == id) {
                    ui.add_space(2.0);
                    let mut fields = details::Fields {
                        session,
                        open_scene,
                        id,
                        object,
                        out: &mut out,
                        commands: &mut commands,
                    };
                    self.details.show(ui, &mut fields);
                    parameters::show(ui, session, open_scene, id, object, &mut out);
                    lights::show(ui, open_scene, id, object, &mut out);
                    layers::show(ui, session, open_scene, (id, object), &mut out);
                    ui.add_space(8.0);
                }
            }
        });
        out.into_iter().map(Command::Scene).chain(commands).collect()
    }

    fn row(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (id, object): (&ObjectId, &Object),
        out: &mut Vec<SceneCommand>,
        commands: &mut Vec<Command>,
    ) -> Rect {
        let Some(open_scene) = session.open_scene() else { return Rect::NOTHING };
        let changed = ChangedRow::of_object(session, id);
        let is_selected = open_scene.selected().is_some_and(|(selected, _)| selected == id);
        let (rect, response) =
            ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
        response.widget_info(|| {
            let name = tr!("Object {id}{changed}", changed = changed.word());
            WidgetInfo::selected(Role::ListItem, true, is_selected, name)
        });
        card_ground(ui, rect, &response, is_selected);
        changed.bar(ui, rect);
        // The buttons at the right end lie in the same column here as in the lists of layers and
        // lights.
        let inner = egui::Rect::from_min_max(rect.min + vec2(6.0, 2.0), rect.max - vec2(0.0, 2.0));
        let builder = UiBuilder::new().id_salt(("object", id.as_str())).max_rect(inner);
        let mut inner = ui.new_child(builder.layout(Layout::left_to_right(egui::Align::Center)));
        self.head(&mut inner, session, (id, object), out, commands);
        if response.clicked() {
            response.request_focus();
            out.push(SceneCommand::Pick(id.clone(), None));
        }
        if response.double_clicked() {
            self.renaming = Some(NameEdit::new(id.clone(), id.as_str()));
        }
        leave_with_pointer(ui, &response);
        if response.has_focus() {
            let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
            if pressed(Key::Delete) {
                out.push(SceneCommand::Edit(SceneEdit::RemoveObject { id: id.clone() }));
            }
            undo_keys(ui, commands);
        }
        let mut help = changed.help();
        help += if help.is_empty() { "" } else { "\n" };
        help += tr!("A click selects it and opens its look; a double click renames it");
        Popup::context_menu(&response.on_hover_text(help)).show(|ui| {
            changed.menu(ui, commands);
            self.menu(ui, open_scene, id, out);
        });
        rect
    }

    fn head(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (id, object): (&ObjectId, &Object),
        out: &mut Vec<SceneCommand>,
        commands: &mut Vec<Command>,
    ) {
        let Some(open_scene) = session.open_scene() else { return };
        ui.spacing_mut().item_spacing.x = 6.0;
        let help = tr!("Shows the object, or hides it");
        if icon(ui, Icon::Eye, object.visible, &tr!("Object {id} is seen"), help).clicked() {
            out.extend(
                open_scene
                    .change(id, |object| object.visible = !object.visible)
                    .map(SceneCommand::Edit),
            );
        }
        ui.with_layout(Layout::right_to_left(egui::Align::Center), |ui| {
            let help = tr!("Frame, duplicate, rename, remove");
            let more = icon(ui, Icon::More, true, &tr!("More of {id}"), help);
            Popup::menu(&more).show(|ui| {
                ChangedRow::of_object(session, id).menu(ui, commands);
                self.menu(ui, open_scene, id, out);
            });
            ui.with_layout(Layout::top_down(egui::Align::LEFT), |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                self.title(ui, open_scene, id, object, out);
                self.about(ui, open_scene, object);
            });
        });
    }

    fn title(
        &mut self,
        ui: &mut Ui,
        open_scene: &OpenScene,
        id: &ObjectId,
        object: &Object,
        out: &mut Vec<SceneCommand>,
    ) {
        if let Some(field) = self.renaming.as_mut().filter(|field| field.id == *id) {
            if let Some(new) = field.show(ui, id.as_str(), &tr!("New name of {id}")) {
                self.renaming = None;
                let renamed = new
                    .filter(|name| !name.is_empty())
                    .and_then(|name| open_scene.rename(id, &name));
                out.extend(renamed.map(|(new, edit)| SceneCommand::Make(new, edit)));
            }
            return;
        }
        let colors = theme::of(ui);
        let text = RichText::new(id.as_str()).strong().color(if object.visible {
            colors.text
        } else {
            colors.dim
        });
        // The label takes no clicks: the row itself does.
        ui.add(Label::new(text).truncate().selectable(false).sense(Sense::empty()));
    }

    /// Shows the mesh and the looks of an object, in a line.
    fn about(&self, ui: &mut Ui, open_scene: &OpenScene, object: &Object) {
        let looks: Vec<String> =
            object.looks.values().map(|name| details::look_label(open_scene, name)).collect();
        let looks = if looks.is_empty() { tr!("no look").to_owned() } else { looks.join(", ") };
        let is_open = open_scene.wears_open(object);
        let colors = theme::of(ui);
        let color = if is_open { colors.accent } else { colors.dim };
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let mesh =
                RichText::new(format!("{} ·", mesh_label(&object.mesh))).small().color(colors.dim);
            ui.add(Label::new(mesh).selectable(false).sense(Sense::empty()));
            let looks = RichText::new(looks).small().color(color);
            ui.add(Label::new(looks).truncate().selectable(false).sense(Sense::empty()));
        });
    }

    fn menu(
        &mut self,
        ui: &mut Ui,
        open_scene: &OpenScene,
        id: &ObjectId,
        out: &mut Vec<SceneCommand>,
    ) {
        if ui
            .button(tr!("Frame object"))
            .on_hover_text(tr!("Brings it into view (F over the picture)"))
            .clicked()
        {
            out.push(SceneCommand::Frame(Some(id.clone())));
        }
        if ui
            .button(tr!("Duplicate object"))
            .on_hover_text(tr!("Adds the same once more, to the right of all"))
            .clicked()
        {
            out.extend(open_scene.duplicate(id).map(|(new, edit)| SceneCommand::Make(new, edit)));
        }
        if ui
            .button(tr!("Rename object"))
            .on_hover_text(tr!("Or double click on the row"))
            .clicked()
        {
            self.renaming = Some(NameEdit::new(id.clone(), id.as_str()));
        }
        ui.separator();
        if ui
            .add(Button::new(tr!("Remove object")))
            .on_hover_text(tr!("Its mesh and its look stay where they are"))
            .clicked()
        {
            out.push(SceneCommand::Edit(SceneEdit::RemoveObject { id: id.clone() }));
        }
    }
}

/// Shows the menus for the scene as a whole.
fn bar(ui: &mut Ui, session: &Session, out: &mut Vec<SceneCommand>) {
    ui.horizontal(|ui| {
        let menu = ui.menu_button(tr!("Add an object"), |ui| {
            for shape in SHAPES {
                let button = ui.button(shape.label.tr());
                if button.on_hover_text(shape.help.tr()).clicked() {
                    out.push(SceneCommand::Add(Some(format!(
                        "{}{}",
                        crate::frame::SHAPE_PREFIX,
                        shape.name
                    ))));
                    ui.close();
                }
            }
            ui.separator();
            let help = tr!(
                "OBJ, PLY, STL or glTF; it can also be dropped here, or on the picture with Shift"
            );
            if ui.button(tr!("Mesh from a file...")).on_hover_text(help).clicked() {
                out.push(SceneCommand::Add(None));
                ui.close();
            }
        });
        menu.response.on_hover_text(tr!(
            "Adds an object beside the others, in the look of the selected one"
        ));
        let Some(open_scene) = session.open_scene() else { return };
        ui.with_layout(Layout::right_to_left(egui::Align::Center), |ui| {
            let more =
                icon(ui, Icon::More, true, tr!("More of the scene"), tr!("Save, camera, close"));
            Popup::menu(&more).id(Id::unique("scene menu")).show(|ui| scene_menu(ui, out));
            let text = RichText::new(open_scene.name()).color(theme::of(ui).dim);
            let path = open_scene.path().map(|path| path.display().to_string());
            let help = path
                .unwrap_or_else(|| tr!("No file has it yet: save the scene to keep it").to_owned());
            if open_scene.is_dirty() {
                let help = tr!("Saves the scene to its file");
                if ui.button(tr!("Save scene")).on_hover_text(help).clicked() {
                    out.push(SceneCommand::Save);
                }
            }
            ui.add(Label::new(text).truncate()).on_hover_text(help);
        });
    });
    ui.add_space(2.0);
}

fn scene_menu(ui: &mut Ui, out: &mut Vec<SceneCommand>) {
    if ui
        .button(tr!("Save scene as..."))
        .on_hover_text(tr!("Saves the scene under another name"))
        .clicked()
    {
        out.push(SceneCommand::SaveAs);
    }
    let help = tr!("The scene's camera, lights and backdrop become what the picture shows now");
    if ui.button(tr!("Keep this view")).on_hover_text(help).clicked() {
        out.push(SceneCommand::KeepView);
    }
    if ui
        .button(tr!("Frame all objects"))
        .on_hover_text(tr!("Brings every object into view (A over the picture)"))
        .clicked()
    {
        out.push(SceneCommand::Frame(None));
    }
    ui.separator();
    if ui
        .button(tr!("Close the scene"))
        .on_hover_text(tr!("The open look stays, on one object"))
        .clicked()
    {
        out.push(SceneCommand::Close);
    }
}
