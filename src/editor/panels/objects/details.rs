//! Fields of an object: mesh, looks by material, position, rotation and scale.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Checkbox, ComboBox, Id, RichText, Ui};

use crate::commands::{Command, FilePurpose, SceneCommand, ViewCommand, table};
use crate::document::{Object, Transform};
use crate::fields::row::{self, labelled};
use crate::fields::shot;
use crate::frame::{ANY_MATERIAL, SHAPE_PREFIX};
use crate::geometry::SHAPES;
use crate::ids::ObjectId;
use crate::state::scene::{
    OpenScene, file_label, from_degrees, mesh_label, stood_up, to_degrees, turned_around,
};
use crate::state::session::Session;
use crate::state::variations::VariedSubject;
use crate::state::view::TransformPart;
use crate::widgets::number::number_field;
use crate::widgets::theme;

/// Smallest scale: at 0 an object vanishes.
const LEAST_SCALE: f64 = 1e-3;

/// State of the fields between frames.
#[derive(Default)]
pub(super) struct Details {
    /// Rotation of an object in degrees, as typed, with the object and the quaternion that it
    /// became: many triples of degrees give the same rotation.
    turned: Option<(ObjectId, [f64; 4], [f64; 3])>,
    /// True if the three scales are set one by one.
    is_uneven: bool,
}

/// Name of a look in the list of objects.
pub(super) fn look_label(open_scene: &OpenScene, name: &str) -> String {
    if open_scene.is_open(name) { open_scene.open_label() } else { file_label(name) }
}

/// An object whose fields are shown, and the commands that they ask for.
pub(super) struct Fields<'a> {
    pub(super) session: &'a Session,
    pub(super) open_scene: &'a OpenScene,
    pub(super) id: &'a ObjectId,
    pub(super) object: &'a Object,
    pub(super) out: &'a mut Vec<SceneCommand>,
    pub(super) commands: &'a mut Vec<Command>,
}

impl Fields<'_> {
    /// Shows a row of some fields of the object, with the mark of what a shot changes of them.
    pub(super) fn row(
        &mut self,
        ui: &mut Ui,
        (label, help): (&str, &str),
        fields: &[&str],
        add: impl FnOnce(&mut Ui, Id),
    ) {
        let id = self.id;
        let targets: Vec<String> =
            fields.iter().map(|field| format!("objects.{id}.{field}")).collect();
        let text = RichText::new(label).color(theme::of(ui).text);
        let slot = |ui: &mut Ui, size| {
            shot::mark(ui, size, self.session, &targets, label, self.commands);
        };
        row::with_slot(ui, text, help, slot, add);
    }
}

impl Details {
    /// Shows all fields of an object but its name.
    pub(super) fn show(&mut self, ui: &mut Ui, fields: &mut Fields<'_>) {
        let Fields { open_scene, id, object, .. } = *fields;
        ui.push_id(id, |ui| {
            let (mut out, mut is_varied) = (Vec::new(), false);
            fields.row(ui, (tr!("Mesh"), tr!("What it is made of")), &["mesh"], |ui, label| {
                is_varied = mesh(ui, label, open_scene, id, object, &mut out);
            });
            fields.out.append(&mut out);
            if is_varied {
                let subject = VariedSubject::ObjectMesh(id.clone());
                fields.commands.push(Command::View(ViewCommand::Vary(subject)));
            }
            looks(ui, fields);
            super::motion::animation(ui, fields);
            let mut new = object.transform;
            let mut widget = None;
            let help = tr!("Where it stands, in scene units: to the right, up, toward the viewer");
            fields.row(ui, (tr!("Place"), help), &["transform.translate"], |ui, _| {
                widget = widget.or(xyz(ui, tr!("Place"), &mut new.translate, 0.01, ""));
            });
            let help =
                tr!("How it is turned: around the axis to the right, around the vertical one, \
                     around the one toward the viewer");
            fields.row(ui, (tr!("object" => "Turn"), help), &["transform.rotate"], |ui, _| {
                widget = widget.or(self.turn(ui, id, &mut new));
            });
            fields.row(
                ui,
                (tr!("object" => "Scale"), tr!("How large it is")),
                &["transform.scale"],
                |ui, _| {
                    widget = widget.or(self.scale(ui, &mut new));
                },
            );
            handles(ui, fields);
            let help =
                tr!("Brings the mesh to the middle, and its sphere to radius 1, before all else");
            fields.row(ui, (tr!("object" => "Fit"), help), &["transform.fit"], |ui, _| {
                let fit = ui.add(Checkbox::without_text(&mut new.fit));
                ui.ctx().accesskit_node_builder(fit.id, |node| node.set_label(tr!("Fit the mesh")));
                if fit.changed() {
                    widget = Some(fit.id);
                }
                if let Some(turned) = turns(ui, &mut new) {
                    widget = Some(turned);
                }
            });
            if let Some(widget) = widget.filter(|_| new != object.transform) {
                let edit = open_scene.change(id, |object| object.transform = new);
                fields.out.extend(edit.map(|edit| SceneCommand::EditHeld(widget, edit)));
            }
        });
    }

    fn turn(&mut self, ui: &mut Ui, id: &ObjectId, new: &mut Transform) -> Option<Id> {
        let known =
            self.turned.as_ref().filter(|(of, rotation, _)| of == id && *rotation == new.rotate);
        let mut degrees = known.map_or_else(|| to_degrees(new.rotate), |(_, _, degrees)| *degrees);
        let widget = xyz(ui, tr!("object" => "Turn"), &mut degrees, 0.5, "°");
        if widget.is_some() {
            new.rotate = from_degrees(degrees);
            self.turned = Some((id.clone(), new.rotate, degrees));
        }
        widget
    }

    fn scale(&mut self, ui: &mut Ui, new: &mut Transform) -> Option<Id> {
        let [x, y, z] = new.scale;
        let is_even = x == y && y == z;
        let mut widget = None;
        if self.is_uneven || !is_even {
            widget = xyz(ui, tr!("object" => "Scale"), &mut new.scale, 0.01, "");
        } else {
            let response = number(ui, tr!("object" => "Scale"), &mut new.scale[0], 0.01, "", "×");
            if response.changed() {
                new.scale = [new.scale[0]; 3];
                widget = Some(response.id);
            }
        }
        for scale in &mut new.scale {
            if scale.abs() < LEAST_SCALE {
                *scale = LEAST_SCALE.copysign(*scale);
            }
        }
        ui.add_enabled_ui(is_even, |ui| {
            ui.checkbox(&mut self.is_uneven, tr!("Uneven"))
                .on_hover_text(tr!("Sets the scale along each axis"));
        });
        widget
    }
}

/// Shows buttons that turn an object whose file has another front or another axis up. Returns the
/// id of the one that did.
fn turns(ui: &mut Ui, new: &mut Transform) -> Option<Id> {
    let mut pressed = None;
    let mut button = |ui: &mut Ui, label: &str, help: &str, turned: fn([f64; 4]) -> [f64; 4]| {
        let button = ui.small_button(label).on_hover_text(help);
        if button.clicked() {
            new.rotate = turned(new.rotate);
            pressed = Some(button.id);
        }
    };
    // In a narrow panel one button stands below the other.
    ui.horizontal_wrapped(|ui| {
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        let help = tr!("Turns a mesh whose z axis points up, as in many scans, by a quarter");
        button(ui, tr!("Stand up"), help, stood_up);
        let help = tr!("Turns an object that faces away by half, around the vertical");
        button(ui, tr!("Turn around"), help, turned_around);
    });
    pressed
}

/// Shows the switches of the handles in the picture.
fn handles(ui: &mut Ui, fields: &mut Fields<'_>) {
    let help = tr!("Handles on the object in the picture, to drag it by");
    labelled(ui, tr!("Handles"), help, |ui, _| {
        for part in TransformPart::ALL {
            let command = Command::View(ViewCommand::ToggleTransform(part));
            let is_on = fields.session.view.handled == Some(part);
            let response = ui.selectable_label(is_on, part.label());
            if response.on_hover_text(table::help_of(&command)).clicked() {
                fields.commands.push(command);
            }
        }
    });
}

/// Shows the choice of an object's mesh; true if its variations are asked for.
fn mesh(
    ui: &mut Ui,
    label: Id,
    open_scene: &OpenScene,
    id: &ObjectId,
    object: &Object,
    out: &mut Vec<SceneCommand>,
) -> bool {
    let mut is_varied = false;
    let combo = ComboBox::from_id_salt("mesh")
        .selected_text(mesh_label(&object.mesh))
        .width(ui.available_width() - 12.0);
    let combo = combo.show_ui(ui, |ui| {
        for shape in SHAPES {
            let is_it = object.mesh.strip_prefix(SHAPE_PREFIX) == Some(shape.name);
            let shown = ui.selectable_label(is_it, shape.label.tr());
            if shown.on_hover_text(shape.help.tr()).clicked() && !is_it {
                let mesh = format!("{SHAPE_PREFIX}{}", shape.name);
                out.extend(
                    open_scene.change(id, |object| object.mesh = mesh).map(SceneCommand::Edit),
                );
            }
        }
        ui.separator();
        let is_file = !object.mesh.starts_with(SHAPE_PREFIX);
        if ui
            .selectable_label(is_file, tr!("From a file..."))
            .on_hover_text(tr!("OBJ, PLY, STL or glTF"))
            .clicked()
        {
            out.push(SceneCommand::Ask(FilePurpose::ObjectMesh, id.clone(), String::new()));
        }
        let help = tr!("Small pictures of the object on other meshes; a click takes one");
        is_varied = ui.selectable_label(false, tr!("Variations...")).on_hover_text(help).clicked();
    });
    combo.response.labelled_by(label).on_hover_text(&object.mesh);
    is_varied
}

/// Shows a row for the look of all materials, and one for each material where the mesh has several
/// or the object names some.
fn looks(ui: &mut Ui, fields: &mut Fields<'_>) {
    let Fields { open_scene, id, object, .. } = *fields;
    let mut out = Vec::new();
    let known = open_scene.materials(id);
    let mut materials: Vec<&str> =
        known.iter().map(String::as_str).filter(|_| known.len() > 1).collect();
    for material in
        object.looks.keys().map(String::as_str).filter(|material| *material != ANY_MATERIAL)
    {
        if !materials.contains(&material) {
            materials.push(material);
        }
    }
    let help = if materials.is_empty() {
        tr!("What it wears")
    } else {
        tr!("What all materials wear that have no look of their own")
    };
    let field = |material: &str| format!("looks.{material}");
    fields.row(ui, (tr!("Look"), help), &["looks", &field(ANY_MATERIAL)], |ui, label| {
        look(ui, label, open_scene, id, object, ANY_MATERIAL, &mut out);
    });
    for material in materials {
        let shown = if material.is_empty() { tr!("(no name)") } else { material };
        let help = tr!("What this material wears");
        fields.row(ui, (shown, help), &[&field(material)], |ui, label| {
            look(ui, label, open_scene, id, object, material, &mut out);
        });
    }
    fields.out.append(&mut out);
}

fn look(
    ui: &mut Ui,
    label: Id,
    open_scene: &OpenScene,
    id: &ObjectId,
    object: &Object,
    material: &str,
    out: &mut Vec<SceneCommand>,
) {
    let nothing = match material {
        ANY_MATERIAL => tr!("look" => "None"),
        _ => tr!("As the others"),
    };
    let worn = object.looks.get(material);
    let text = worn.map_or_else(|| nothing.to_owned(), |name| look_label(open_scene, name));
    let combo = ComboBox::from_id_salt(("look", material))
        .selected_text(text)
        .width(ui.available_width() - 12.0);
    let combo = combo.show_ui(ui, |ui| {
        let mut wear = |name: Option<String>| {
            let edit = open_scene.change(id, |object| match name {
                Some(name) => drop(object.looks.insert(material.to_owned(), name)),
                None => drop(object.looks.shift_remove(material)),
            });
            out.extend(edit.map(SceneCommand::Edit));
        };
        for name in open_scene.looks() {
            let is_it = worn.is_some_and(|worn| {
                *worn == name || open_scene.is_open(worn) && open_scene.is_open(&name)
            });
            if ui
                .selectable_label(is_it, look_label(open_scene, &name))
                .on_hover_text(&name)
                .clicked()
                && !is_it
            {
                wear(Some(name));
            }
        }
        if ui.selectable_label(worn.is_none(), nothing).clicked() && worn.is_some() {
            wear(None);
        }
        ui.separator();
        if ui
            .selectable_label(false, tr!("From a file..."))
            .on_hover_text(tr!("Another look"))
            .clicked()
        {
            out.push(SceneCommand::Ask(FilePurpose::ObjectLook, id.clone(), material.to_owned()));
        }
    });
    combo.response.labelled_by(label);
}

fn number(
    ui: &mut Ui,
    name: &str,
    number: &mut f64,
    speed: f64,
    suffix: &str,
    prefix: &str,
) -> egui::Response {
    let before = *number;
    let drag = number_field(ui, number).speed(speed).max_decimals(3).prefix(prefix).suffix(suffix);
    let response = ui.add(drag);
    if !number.is_finite() {
        *number = before;
    }
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
    response
}

/// Shows three numbers, named after their axes. Returns the id of the widget that changed one.
fn xyz(ui: &mut Ui, name: &str, numbers: &mut [f64; 3], speed: f64, suffix: &str) -> Option<Id> {
    let mut widget = None;
    ui.spacing_mut().item_spacing.x = 4.0;
    for (value, axis) in numbers.iter_mut().zip(["x", "y", "z"]) {
        let response =
            number(ui, &format!("{name} {axis}"), value, speed, suffix, &format!("{axis} "));
        if response.changed() {
            widget = Some(response.id);
        }
    }
    widget
}
