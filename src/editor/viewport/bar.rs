//! Bar above the picture: the mesh that the look is seen on, and the options of the display.

use chiaro_locale::{Text, tr, trn};
use eframe::egui;
use eframe::egui::{Rect, Role, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2};
use std::path::Path;

use super::Viewport;
use super::colors;
use super::lying::StandUpOffer;
use super::show::{self, ReferencePlacement};
use super::solo_bar;
use crate::commands::{Command, PanelId, PictureExport, SceneCommand, ViewCommand, table};
use crate::document::{Projection, Scene, SceneEdit};
use crate::fields::names;
use crate::frame::SHAPE_PREFIX;
use crate::geometry::SHAPES;
use crate::state::orbit::Orbit;
use crate::state::scene::OpenScene;
use crate::state::session::Session;
use crate::state::wire::Style;
use crate::tools::notice::stand_below;
use crate::tools::{PictureTools, ToolRow};
use crate::widgets::color;
use crate::widgets::menu;
use crate::widgets::number::number_slider;
use crate::widgets::overflow::overflowing;
use crate::widgets::theme;

/// Least width of a bar that tells the number of a scene's objects at its start, in points.
const WIDE: f32 = 370.0;
/// Width of a bar, in points, below which the list of meshes has no room beside Options.
const NARROW: f32 = 220.0;
/// Room that the word about compiling takes, in points.
const COMPILING: f32 = 70.0;

impl Viewport {
    /// Shows the choice of the mesh, and its orientation.
    pub(super) fn bar(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        view: &mut Orbit,
        tools: &mut PictureTools,
        out: &mut Vec<Command>,
    ) {
        ui.horizontal(|ui| {
            let is_wide = ui.available_width() > WIDE;
            let has_mesh = session.open_scene().is_none();
            // Where the list of meshes would push Options out, it goes to the others without room.
            let is_mesh_listed = has_mesh && ui.available_width() < NARROW;
            match session.open_scene() {
                None if is_mesh_listed => {}
                None => mesh_choice(ui, session, out),
                Some(open_scene) if is_wide => objects_link(ui, open_scene, out),
                Some(_) => {}
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let menu = menu::staying(ui, tr!("Options"), |ui| {
                    self.options(ui, session, (&mut *view, &mut *tools), out);
                });
                menu.on_hover_text(tr!(
                    "Turntable, projection, backdrop, exposure, view transform, reference image, \
                     saving"
                ));
                let switches: Vec<&ToolRow> = PictureTools::of_bar().collect();
                let linked = session.open_scene().filter(|_| !is_wide);
                let is_last = linked.is_some() || is_mesh_listed;
                let parts: Vec<usize> = (0..switches.len() + usize::from(is_last)).collect();
                overflowing(ui, "switches", 1, &parts, |ui, part| match switches.get(part) {
                    Some(tool) => (tool.switch)(tools, ui, out),
                    None if is_mesh_listed => mesh_choice(ui, session, out),
                    None => linked.into_iter().for_each(|scene| objects_link(ui, scene, out)),
                });
                if session.is_compiling() && ui.available_width() > COMPILING {
                    ui.label(egui::RichText::new(tr!("compiling")).color(theme::of(ui).dim));
                }
            });
        });
    }

    fn options(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (view, tools): (&mut Orbit, &mut PictureTools),
        out: &mut Vec<Command>,
    ) {
        let help_of = |command| table::help_of(&Command::View(command));
        tools.options(ui, out);
        let help = tr!(
            "Where eye and lights stand at a place, as a painted surface (HCBTF) looks them up: \
             blue lies toward the eye, the others toward lights, each with its trace on the \
             surface; larger under the pointer"
        );
        ui.checkbox(&mut self.has_arrows, tr!("Arrows toward eye and lights")).on_hover_text(help);
        ui.checkbox(&mut self.turns, tr!("Turntable"))
            .on_hover_text(help_of(ViewCommand::ToggleTurntable));
        let help =
            tr!("The light comes from the same side of the picture wherever you look from: the \
             illumination frame turns with the camera");
        ui.checkbox(&mut self.takes_lights, tr!("Lights go with the camera")).on_hover_text(help);
        if session.open_scene().is_none() && !session.view.orbit.mesh.starts_with(SHAPE_PREFIX) {
            let help = tr!(
                "Stands up a mesh that lies on its back: one whose z axis points up, as in many \
                 scans"
            );
            let mut z_is_up = session.view.orbit.z_is_up;
            if ui.checkbox(&mut z_is_up, tr!("Z is up")).on_hover_text(help).changed() {
                out.push(Command::StandUp(z_is_up));
            }
        }
        ui.separator();
        for (projection, label, help) in [
            (Projection::Perspective, tr!("Perspective"), tr!("What is near is large (P)")),
            (
                Projection::Orthographic,
                tr!("Parallel"),
                tr!("All is as large at any distance, as in a technical drawing (P)"),
            ),
        ] {
            ui.radio_value(&mut view.projection, projection, label).on_hover_text(help);
        }
        let mut button = |ui: &mut Ui, label: &str, command: ViewCommand| {
            let command = Command::View(command);
            if ui.button(label).on_hover_text(table::help_of(&command)).clicked() {
                out.push(command);
            }
        };
        button(ui, tr!("Turn the object around"), ViewCommand::TurnAround);
        button(ui, tr!("Frame the object"), ViewCommand::FrameObject);
        if session.open_scene().is_some() {
            button(ui, tr!("Frame all"), ViewCommand::FrameAll);
        }
        button(ui, tr!("Reset camera and lights"), ViewCommand::Reset);
        button(ui, tr!("Look through the light"), ViewCommand::LookThrough);
        ui.separator();
        self.display(ui, view);
        colors::menu(ui, session, &mut self.colors, out);
        self.reference_image(ui, out);
        ui.separator();
        self.exports(ui, out);
    }

    /// Shows the options of the picture's display, which apply to this window only.
    fn display(&mut self, ui: &mut Ui, view: &mut Orbit) {
        let backdrop = Scene::default().backdrop.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        ui.horizontal(|ui| {
            let mut is_own = view.backdrop.is_some();
            let help = tr!("What is behind the object; for this window only");
            let label = ui.checkbox(&mut is_own, tr!("Backdrop")).on_hover_text(help);
            if label.changed() {
                view.backdrop = is_own.then_some(backdrop);
            }
        });
        // The color is picked here and not behind a swatch: a popup over the menu would close the
        // menu.
        if let Some(color) = &mut view.backdrop
            && let Some([r, g, b, _]) = color::pick(ui, *color)
        {
            *color = [r, g, b, 1.0];
        }
        ui.horizontal(|ui| {
            let label = ui.label(tr!("Exposure"));
            let range = -show::MOST_STOPS..=show::MOST_STOPS;
            let help = tr!(
                "Shows the picture brighter or darker, in stops; for this window only, the look \
                 stays as it is"
            );
            let slider = number_slider(ui, &mut self.exposure, range).max_decimals(2).step_by(0.05);
            ui.add(slider).labelled_by(label.id).on_hover_text(help);
            if self.exposure != 0.0 && ui.small_button("0").on_hover_text(tr!("As it is")).clicked()
            {
                self.exposure = 0.0;
            }
        });
    }

    fn reference_image(&mut self, ui: &mut Ui, out: &mut Vec<Command>) {
        let Some(reference) = &mut self.reference else {
            let help = tr!("Shows an image to work from, beside the picture or over it");
            if ui.button(tr!("Reference image...")).on_hover_text(help).clicked() {
                out.push(Command::ShowReference(None));
            }
            return;
        };
        let mut is_over = false;
        ui.horizontal(|ui| {
            ui.label(&reference.name);
            ui.selectable_value(&mut reference.place, ReferencePlacement::Beside, tr!("Beside"));
            ui.selectable_value(&mut reference.place, ReferencePlacement::Over, tr!("Over"));
            is_over = ui.button(tr!("Take away")).clicked();
        });
        if reference.place == ReferencePlacement::Over {
            ui.horizontal(|ui| {
                let label = ui.label(tr!("Opacity of the image"));
                ui.add(number_slider(ui, &mut reference.opacity, 0.0..=1.0)).labelled_by(label.id);
            });
        }
        if is_over {
            self.reference = None;
        }
    }

    fn exports(&mut self, ui: &mut Ui, out: &mut Vec<Command>) {
        if ui
            .button(tr!("Copy picture"))
            .on_hover_text(tr!("To the clipboard, as large as it is here"))
            .clicked()
        {
            out.push(Command::CopyPicture);
            ui.close();
        }
        ui.horizontal(|ui| {
            let own = self.size_in_pixels(ui.pixels_per_point());
            ui.label(tr!("Save picture"));
            for (label, factor) in [("1×", 1), ("2×", 2), ("4×", 4)] {
                let size = own.map(|side| (side * factor).clamp(1, MOST_SIDE));
                let help =
                    tr!("As PNG, {width} by {height} pixels", width = size[0], height = size[1]);
                let button = ui.button(label).on_hover_text(help);
                button.widget_info(|| {
                    WidgetInfo::labeled(Role::Button, true, tr!("Save picture {label}"))
                });
                if button.clicked() {
                    out.push(Command::Export(PictureExport::Picture(size), None));
                    ui.close();
                }
            }
        });
        ui.horizontal(|ui| {
            let help =
                tr!("Draws the look on a ball, from here and lit as here, as an image for the \
                 LitSphere node and for other programs (a matcap). Curvature is then the ball's.");
            if ui.button(tr!("Bake to LitSphere...")).on_hover_text(help).clicked() {
                out.push(Command::Export(PictureExport::LitSphere(self.bake_side), None));
                ui.close();
            }
            for side in [256, 512, 1024, 2048] {
                let response = ui.selectable_value(&mut self.bake_side, side, side.to_string());
                let is_it = self.bake_side == side;
                let name = || {
                    WidgetInfo::selected(
                        Role::Button,
                        true,
                        is_it,
                        tr!("{side} pixels along a side"),
                    )
                };
                response.on_hover_text(tr!("Pixels along a side")).widget_info(name);
            }
        });
    }
}

/// Shows the number of a scene's objects, which leads to their list: the scene's name stands in the
/// title already.
fn objects_link(ui: &mut Ui, open_scene: &OpenScene, out: &mut Vec<Command>) {
    let count = open_scene.scene().objects.len();
    let text = trn!(count, "{count} object", "{count} objects");
    let help = tr!("Shows the objects of {scene}", scene = open_scene.name());
    if ui.link(text).on_hover_text(help).clicked() {
        out.push(Command::ShowPanel(PanelId::OBJECTS));
    }
}

/// Width of the choice of the mesh, in points: others stand beside it.
const MESH: f32 = 84.0;
/// Height of the list of meshes, in points: room for all of them, and for the entry that opens a
/// file.
const MESHES: f32 = 420.0;
/// Largest side of a picture that is saved, in pixels.
const MOST_SIDE: u32 = 8192;

fn mesh_choice(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let mesh = session.view.orbit.mesh.clone();
    let shape = SHAPES.iter().find(|shape| mesh.strip_prefix("shape:") == Some(shape.name));
    let file = Path::new(&mesh)
        .file_name()
        .map_or(mesh.clone(), |name| name.to_string_lossy().into_owned());
    let shown = shape.map_or(file.as_str(), |shape| shape.label.tr());
    let combo = egui::ComboBox::from_id_salt("mesh").width(MESH).truncate().height(MESHES);
    let response = menu::choice(ui, combo, shown, |ui| {
        for shape in SHAPES {
            let is_it = mesh.strip_prefix("shape:") == Some(shape.name);
            let [label, help] = [shape.label, shape.help].map(Text::tr);
            if ui.selectable_label(is_it, label).on_hover_text(help).clicked() {
                out.push(Command::ShowOn(Some(format!("{SHAPE_PREFIX}{}", shape.name).into())));
            }
        }
        ui.separator();
        let help = tr!(
            "Shows the look on a mesh of yours (OBJ, PLY, STL, glTF); it can also be dropped on \
             the window. One that lies on its back is stood up by \"Z is up\" under Options"
        );
        if ui.selectable_label(shape.is_none(), tr!("From a file...")).on_hover_text(help).clicked()
        {
            out.push(Command::ShowOn(None));
        }
    });
    let response = response.on_hover_text(tr!("The mesh that the look is shown on"));
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr!("mesh" => "On")));
}

/// Shows notices over the top of the picture, which does not move when they come and go: of a wire
/// that is viewed in place of the picture, of soloed or muted layers and lights, and of a mesh that
/// seems to lie.
pub(super) fn over_top(
    ui: &mut Ui,
    rect: Rect,
    session: &Session,
    through: Option<&str>,
    stands: &mut StandUpOffer,
    out: &mut Vec<Command>,
) {
    let open_scene = session.open_scene();
    let is_soloed = open_scene.is_some_and(|open_scene| !open_scene.scene().soloed.is_none());
    let is_turned = session.lights_of_shot().is_some();
    let is_told =
        is_soloed || is_turned || session.view.wire.is_some() || !session.view.solo.is_empty();
    if !is_told && through.is_none() && stands.offer(session).is_none() {
        stand_below(ui.ctx(), 0.0);
        return;
    }
    let id = ui.scope_id().with("told over the picture");
    let room = Rect::from_min_max(rect.min + vec2(8.0, 8.0), pos2(rect.max.x - 8.0, rect.max.y));
    // The height is that of the frame before. Presses beside the buttons must not reach the picture
    // below.
    let height: f32 = ui.data(|data| data.get_temp(id)).unwrap_or(30.0);
    ui.interact(
        Rect::from_min_size(room.min, vec2(room.width(), height)),
        id,
        Sense::click_and_drag(),
    );
    let shown =
        ui.scope_builder(UiBuilder::new().id_salt("over the picture").max_rect(room), |ui| {
            if let Some(name) = through {
                through_bar(ui, name, out);
            }
            wire_bar(ui, session, out);
            turned_bar(ui, session, out);
            out.extend(solo_bar::show(ui, session));
            out.extend(solo_bar::of_scene(ui, session));
            out.extend(stands.show(ui, session));
        });
    let height = shown.response.rect.height();
    ui.data_mut(|data| data.insert_temp(id, height));
    stand_below(ui.ctx(), height);
}

/// Says that a light is looked through, with a button that leads back.
fn through_bar(ui: &mut Ui, name: &str, out: &mut Vec<Command>) {
    let frame = egui::Frame::new()
        .fill(theme::of(ui).accent_dim)
        .corner_radius(4.0)
        .inner_margin(egui::Margin::symmetric(8, 3));
    frame.show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let help =
                    tr!("Gives the camera back its place (O, or Esc); the light stays where it is");
                if ui.button(tr!("Back to the camera")).on_hover_text(help).clicked() {
                    out.push(Command::View(ViewCommand::LookThrough));
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let text = tr!("Looking through {name}: the light goes with the view");
                    let text = egui::RichText::new(text).color(theme::of(ui).text);
                    ui.add(egui::Label::new(text).truncate());
                });
            });
        });
    });
}

/// Says that the lights were turned by hand, which is not what the open shot renders, with buttons
/// that turn them back and that keep the turn in the shot.
fn turned_bar(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) -> Option<()> {
    let illumination = session.lights_of_shot().filter(|_| session.keys().has_turning_lights())?;
    let text = tr!("Lights turned by hand: rendered frames have them as the shot does");
    let help =
        tr!("A drag on the object turns all lights around it, in this window only. R takes it \
         back, too");
    let back = (tr!("Back to the shot's"), tr!("The lights are as the shot has them again"));
    let keep = (
        tr!("Keep in the shot"),
        tr!("The shot turns all lights like this from now on: at this frame where that is keyed"),
    );
    out.push(match solo_bar::bar(ui, text, help, &[back, keep])? {
        0 => {
            let view = Orbit { illumination, ..session.view.orbit.clone() };
            Command::View(ViewCommand::TurnTo(Box::new(view)))
        }
        _ => {
            let rotation = session.view.orbit.illumination.to_array();
            Command::Scene(SceneCommand::Edit(SceneEdit::SetIllumination { rotation }))
        }
    });
    Some(())
}

/// Says that a wire is viewed in place of the picture, with a button that leads back.
fn wire_bar(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) -> Option<()> {
    let wire = session.view.wire.as_ref()?;
    let look = session.look_with_library();
    let kind = look.catalog.of(look.node_at(&wire.node)?);
    let name = look.title_of_path(&wire.node);
    let port = kind
        .and_then(|kind| {
            let port = &kind.outputs[kind.output(wire.port.as_str())?];
            Some(names::of(&kind.id, &port.label))
        })
        .unwrap_or_default();
    let frame = egui::Frame::new()
        .fill(theme::of(ui).panel.gamma_multiply(0.9))
        .corner_radius(4.0)
        .inner_margin(egui::Margin::symmetric(8, 3));
    frame.show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button(tr!("Show the look")).clicked() {
                    out.push(Command::ShowWire(None));
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let text = match wire.style {
                        Style::Color => tr!("Showing {port} of {name} as color"),
                        Style::Heat => tr!("Showing {port} of {name} as heat"),
                        Style::Isolines => tr!("Showing {port} of {name} as isolines"),
                    };
                    let label =
                        egui::Label::new(egui::RichText::new(text).color(theme::of(ui).accent))
                            .truncate();
                    ui.add(label).on_hover_text(wire.style.help());
                });
            });
        });
    });
    Some(())
}
