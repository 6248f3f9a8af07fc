//! The lights of the look: which shine, alone or together with others, and what each is.

mod edit;

use std::collections::HashMap;

use eframe::egui;
use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{
    Button, Color32, DragValue, Id, Label, Popup, RichText, Role, ScrollArea, Sense, Ui, WidgetInfo, vec2,
};

use super::super::command::Command;
use super::super::dock::hint;
use super::super::session::Session;
use super::super::{theme, values};
use super::solo;
use super::widgets::{ICON, Icon, Renaming, icon, picture_frame};
use crate::document::{ColorSpace, Edit, Light, LightKind, Value};
use crate::ids::{LightId, make_slug};
use crate::library::Type;
pub(crate) use edit::edit;

/// The panel, and what it remembers.
#[derive(Default)]
pub(crate) struct Lights {
    renaming: Option<Renaming<LightId>>,
    /// How many nodes name each light.
    users: HashMap<LightId, usize>,
    of: Option<(u64, u64)>,
}

/// What a light is called.
pub(crate) fn name<'a>(id: &'a LightId, light: &'a Light) -> &'a str {
    if light.name.is_empty() { id.as_str() } else { &light.name }
}

impl Lights {
    /// Lists the lights.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        self.sync(session);
        let mut out = Vec::new();
        bar(ui, session, &mut out);
        if !session.solo().lights.is_empty() || !session.solo().muted.is_empty() {
            out.extend(solo::bar(ui, session));
        }
        let lights = &session.look().lights;
        if lights.is_empty() {
            hint(ui, "The look has no lights. Layers need one each.");
        }
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            // Room for the scroll bar.
            ui.set_max_width(ui.available_width() - 8.0);
            let is_short = lights.len() == 1;
            for (id, light) in lights {
                let state = Id::unique("light").with(id.as_str());
                let state = CollapsingState::load_with_default_open(ui.ctx(), state, is_short);
                let header = state.show_header(ui, |ui| self.head(ui, session, id, light, &mut out));
                header.body_unindented(|ui| {
                    ui.add_space(2.0);
                    edit(ui, session, id, light, &mut out);
                    ui.add_space(6.0);
                });
            }
        });
        out
    }

    fn sync(&mut self, session: &Session) {
        let of = (session.document_number(), session.revision());
        if self.of == Some(of) {
            return;
        }
        if self.of.is_none_or(|old| old.0 != of.0) {
            self.renaming = None;
        }
        self.of = Some(of);
        self.users.clear();
        let look = session.look();
        let groups = look.definitions.values().map(|definition| &definition.graph);
        for node in std::iter::once(&look.graph).chain(groups).flat_map(|graph| graph.nodes.values()) {
            let Some(kind) = session.catalog.of(node) else { continue };
            for port in kind.inputs.iter().filter(|port| port.ty == Type::LightName) {
                let named = match values::current(port, node.values.get(&port.name)) {
                    Some(Value::Text(id)) if !id.is_empty() => look.lights.get_key_value(id.as_str()),
                    _ => look.lights.first(),
                };
                if let Some((id, _)) = named {
                    *self.users.entry(id.clone()).or_default() += 1;
                }
            }
        }
    }

    fn head(&mut self, ui: &mut Ui, session: &Session, id: &LightId, light: &Light, out: &mut Vec<Command>) {
        let title = name(id, light);
        let solo = session.solo();
        ui.spacing_mut().item_spacing.x = 4.0;
        let is_muted = solo.muted.contains(id);
        let help = "Puts the light out, or lights it again.\nOnly in this window: nothing of it is saved.";
        if icon(ui, Icon::Bulb, !is_muted, &format!("Light {title} shines"), help).clicked() {
            out.push(Command::Solo(solo.toggle_mute(id)));
        }
        let (rect, _) = ui.allocate_exact_size(vec2(16.0, 16.0), Sense::hover());
        ui.painter().rect_filled(rect, 3.0, swatch(light, session.look().color_space));
        picture_frame(ui, rect);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let more = icon(ui, Icon::More, true, &format!("More of {title}"), "Rename, duplicate, remove");
            Popup::menu(&more).show(|ui| self.menu(ui, session, id, light, out));
            let is_alone = solo.lights.contains(id);
            let help =
                "Lets this light shine alone; Ctrl-click adds to others.\nOnly in this window: nothing of it is saved.";
            if icon(ui, Icon::Solo, is_alone, &format!("Solo {title}"), help).clicked() {
                let adds = ui.input(|input| input.modifiers.command || input.modifiers.shift);
                out.push(Command::Solo(solo.toggle_light(id, adds)));
            }
            self.users(ui, id);
            intensity(ui, session, id, light, out);
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.set_min_height(ICON);
                self.title(ui, id, light, solo.is_dark(id), out);
            });
        });
    }

    fn users(&self, ui: &mut Ui, id: &LightId) {
        let colors = theme::of(ui);
        let (text, color, help) = match self.users.get(id).copied().unwrap_or(0) {
            0 => ("unused".to_owned(), colors.warning, "No node names this light, so it lights nothing"),
            1 => ("1 node".to_owned(), colors.dim, "So many nodes name it"),
            count => (format!("{count} nodes"), colors.dim, "So many nodes name it"),
        };
        ui.label(RichText::new(text).small().color(color)).on_hover_text(help);
    }

    fn title(&mut self, ui: &mut Ui, id: &LightId, light: &Light, is_dark: bool, out: &mut Vec<Command>) {
        let title = name(id, light);
        if let Some(field) = self.renaming.as_mut().filter(|field| field.id == *id) {
            if let Some(new) = field.show(ui, id.as_str(), &format!("New name of {title}")) {
                self.renaming = None;
                if let Some(name) = new.filter(|name| *name != light.name) {
                    let light = Light { name, ..light.clone() };
                    out.push(Command::Edit(Edit::SetLight { id: id.clone(), light }));
                }
            }
            return;
        }
        let color = if is_dark { theme::of(ui).dim } else { theme::of(ui).text };
        let text = RichText::new(title).strong().color(color);
        let text = if is_dark { text.strikethrough() } else { text };
        let response = ui.add(Label::new(text).truncate().selectable(false).sense(Sense::click()));
        if response.double_clicked() {
            self.renaming = Some(Renaming::new(id.clone(), &light.name));
        }
        response.on_hover_text("Double click to rename");
    }

    fn menu(&mut self, ui: &mut Ui, session: &Session, id: &LightId, light: &Light, out: &mut Vec<Command>) {
        if ui.button("Rename light").on_hover_text("Or double click on the name").clicked() {
            self.renaming = Some(Renaming::new(id.clone(), &light.name));
        }
        if ui.button("Duplicate light").on_hover_text("Adds a copy, which no node names yet").clicked() {
            let index = session.look().lights.get_index_of(id).map(|index| index + 1);
            let mut light = light.clone();
            if !light.name.is_empty() {
                light.name += " copy";
            }
            let base = id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
            let base = if base.is_empty() { id.as_str() } else { base };
            out.push(Command::Edit(Edit::AddLight { id: free_id(session, base), light, index }));
        }
        ui.separator();
        let users = self.users.get(id).copied().unwrap_or(0);
        let help = match users {
            0 => "No node names it".to_owned(),
            users => format!("{users} of the look's nodes name it, and will have to name another one"),
        };
        if ui.add(Button::new("Remove light")).on_hover_text(help).clicked() {
            out.push(Command::Edit(Edit::RemoveLight { id: id.clone() }));
        }
    }
}

/// How bright it is, at hand also while the rest is folded away.
fn intensity(ui: &mut Ui, session: &Session, id: &LightId, light: &Light, out: &mut Vec<Command>) {
    let light = &edit::as_set(session, id, light);
    let mut value = light.intensity;
    let drag = DragValue::new(&mut value).prefix("×").speed(0.01).range(0.0..=f64::MAX).clamp_existing_to_range(false);
    let response =
        ui.add(drag.max_decimals(2)).on_hover_text("Intensity: a factor on the color. Drag, or click to type.");
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::SpinButton, true, format!("Intensity of {}", name(id, light)));
        info.value = Some(value);
        info
    });
    if response.changed() && value.is_finite() {
        let new = Light { intensity: value, ..light.clone() };
        out.push(Command::EditHeld(response.id, edit::changed(session, id, light, &new)));
    }
}

fn bar(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let menu = ui.menu_button("Add light", |ui| {
            let kinds = [
                (LightKind::Directional, "Directional", "As far away as the sun: the same direction everywhere"),
                (LightKind::Point, "Point", "At a place, shining everywhere"),
                (LightKind::Spot, "Spot", "At a place, shining into a cone"),
            ];
            for (kind, label, help) in kinds {
                if ui.button(label).on_hover_text(help).clicked() {
                    let near = Light { position: [1.5, 1.5, 2.0], aim: [-0.5, -0.5, -0.7], ..Light::default() };
                    let light = Light { kind, direction: [0.5, 0.5, 0.7], ..near };
                    out.push(Command::Edit(Edit::AddLight { id: free_id(session, "light"), light, index: None }));
                    ui.close();
                }
            }
        });
        menu.response.on_hover_text("Adds a light that layers can name");
    });
    ui.add_space(2.0);
}

fn free_id(session: &Session, base: &str) -> LightId {
    LightId::new(make_slug(base, |slug| session.look().lights.contains_key(slug)))
}

/// The colour of a light as it is shown.
fn swatch(light: &Light, space: ColorSpace) -> Color32 {
    let value = Value::Vector(light.color.to_vec());
    let [r, g, b, _] = match space {
        ColorSpace::Display => value.color().unwrap_or([0.0, 0.0, 0.0, 1.0]),
        ColorSpace::Linear => {
            let encode = |x: f64| f64::from(egui::ecolor::gamma_from_linear(x.clamp(0.0, 1.0) as f32));
            let [r, g, b] = light.color.map(encode);
            [r, g, b, 1.0]
        }
    };
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    Color32::from_rgb(byte(r), byte(g), byte(b))
}
