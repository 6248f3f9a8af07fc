//! Parameters that the looks of an object expose: the looks' values, and the object's own over
//! them.

use std::borrow::Cow;

use chiaro_locale::{tr, tr_in};
use eframe::egui::{Id, RichText, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, vec2};

use super::details::look_label;
use crate::catalog::Port;
use crate::commands::SceneCommand;
use crate::document::{Object, Value};
use crate::fields::row;
use crate::ids::{ObjectId, PortName};
use crate::library::Type;
use crate::state::reading::Parameter;
use crate::state::scene::OpenScene;
use crate::state::session::Session;
use crate::values;
use crate::widgets::theme;

/// Lists the parameters by the looks that expose them, then the values of the object that none of
/// its looks takes.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    open_scene: &OpenScene,
    id: &ObjectId,
    object: &Object,
    out: &mut Vec<SceneCommand>,
) {
    let mut known: Vec<PortName> = Vec::new();
    let mut setter = Setter { open_scene, id, object, out };
    for (name, parameters) in of_looks(session, open_scene, object) {
        // A name that several looks expose is set for all of them at once.
        let new: Vec<&Parameter> =
            parameters.iter().filter(|parameter| !known.contains(&parameter.name)).collect();
        if new.is_empty() {
            continue;
        }
        heading(ui, &tr!("Parameters of {look}", look = look_label(open_scene, name)));
        for parameter in new {
            known.push(parameter.name.clone());
            ui.push_id(&parameter.name, |ui| setter.row(ui, parameter));
        }
    }
    let unknown: Vec<_> = object.values.iter().filter(|(name, _)| !known.contains(name)).collect();
    if !unknown.is_empty() {
        heading(ui, tr!("Set, and exposed by none of its looks"));
        for (name, value) in unknown {
            ui.push_id(name, |ui| setter.unknown(ui, name, value));
        }
    }
}

/// Looks that an object wears, each once, with the parameters that they expose.
fn of_looks<'s>(
    session: &Session,
    open_scene: &'s OpenScene,
    object: &'s Object,
) -> Vec<(&'s str, Cow<'s, [Parameter]>)> {
    let mut found: Vec<(&str, Cow<'_, [Parameter]>)> = Vec::new();
    for name in object.looks.values() {
        let is_known = |(known, _): &(&str, _)| {
            *known == name.as_str() || open_scene.is_open(known) && open_scene.is_open(name)
        };
        if !found.iter().any(is_known) {
            let parameters = match open_scene.is_open(name) {
                true => Cow::Owned(session.look_with_library().parameters()),
                false => Cow::Borrowed(open_scene.parameters(name)),
            };
            found.push((name, parameters));
        }
    }
    found
}

fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(2.0);
    ui.label(RichText::new(text).small().color(theme::of(ui).dim));
}

/// Setter of one object's values.
struct Setter<'a> {
    open_scene: &'a OpenScene,
    id: &'a ObjectId,
    object: &'a Object,
    out: &'a mut Vec<SceneCommand>,
}

impl Setter<'_> {
    fn row(&mut self, ui: &mut Ui, parameter: &Parameter) {
        let Parameter { name, port, .. } = parameter;
        let label = tr_in("node", &parameter.label);
        let own = self.object.values.get(name);
        let of_look = parameter.value.as_ref().map(|value| values::short(port, value));
        let colors = theme::of(ui);
        let (color, more) = match (own, of_look) {
            (Some(_), Some(of_look)) => {
                (colors.accent, tr!("Set by this object; its look has {of_look}"))
            }
            (Some(_), None) => (colors.accent, tr!("Set by this object").to_owned()),
            (None, _) => (colors.text, tr!("As its look has it, until it is set here").to_owned()),
        };
        let text = RichText::new(label).color(color);
        let text = if own.is_some() { text.strong() } else { text };
        let help = format!("{}\n{more}", tr_in("node", &parameter.help));
        let mut is_taken_back = false;
        let slot = |ui: &mut Ui, size: Vec2| match own {
            Some(_) => {
                let help = tr!(
                    "Set by this object. A press takes that back, and it is as its look has it."
                );
                is_taken_back = mark(ui, size, &tr!("Back to the look's {label}"), help);
            }
            None => drop(ui.allocate_exact_size(size, Sense::hover())),
        };
        row::with_slot(ui, text, &help, slot, |ui, label_id| {
            let value = own.or(parameter.value.as_ref());
            match port.ty {
                _ if value.is_none() => {
                    ui.label(RichText::new(tr!("from the surface")).color(theme::of(ui).dim));
                }
                Type::Curve | Type::Ramp | Type::Text => {
                    let text = value.map(|value| values::short(port, value)).unwrap_or_default();
                    ui.label(RichText::new(text).color(theme::of(ui).dim))
                        .on_hover_text(tr!("Set in a scene's file, or in the look"));
                }
                _ => {
                    let changed = row::plain(ui, label_id, port, value, parameter.space);
                    if let Some((widget, value)) = changed {
                        self.set(widget, name, value);
                    }
                }
            }
        });
        if is_taken_back {
            self.clear(name);
        }
    }

    /// Shows a value that none of the looks takes: its name may be misspelled, or no longer
    /// exposed.
    fn unknown(&mut self, ui: &mut Ui, name: &PortName, value: &Value) {
        let port = Port::named(name.as_str());
        let text = RichText::new(name.as_str()).color(theme::of(ui).warning);
        let help = tr!("No look of this object exposes it under this name, so it changes nothing");
        let slot = |ui: &mut Ui, size: Vec2| drop(ui.allocate_exact_size(size, Sense::hover()));
        row::with_slot(ui, text, help, slot, |ui, _| {
            ui.label(RichText::new(values::short(&port, value)).color(theme::of(ui).dim));
            let take_out = ui.small_button(tr!("Take out"));
            take_out
                .widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Take out {name}")));
            if take_out.on_hover_text(tr!("Takes the value out of the scene")).clicked() {
                self.clear(name);
            }
        });
    }

    fn set(&mut self, widget: Id, name: &PortName, value: Value) {
        let set = self
            .open_scene
            .change(self.id, |object| drop(object.values.insert(name.clone(), value)));
        self.out.extend(set.map(|edit| SceneCommand::EditHeld(widget, edit)));
    }

    /// Removes the object's own value.
    fn clear(&mut self, name: &PortName) {
        let edit = self.open_scene.change(self.id, |object| drop(object.values.shift_remove(name)));
        self.out.extend(edit.map(SceneCommand::Edit));
    }
}

/// Shows a dot beside a value that the object sets itself; under the pointer the dot becomes an
/// arrow back. Returns true if it was pressed.
fn mark(ui: &mut Ui, size: Vec2, label: &str, help: &str) -> bool {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, label));
    let (colors, at) = (theme::of(ui), rect.center());
    if response.hovered() || response.has_focus() {
        let stroke = Stroke::new(1.5, colors.text);
        let arc =
            (0..=9_u8).map(|step| at + 4.0 * Vec2::angled(-2.2 + f32::from(step) / 9.0 * 4.6));
        ui.painter().add(Shape::line(arc.collect(), stroke));
        let end = at + 4.0 * Vec2::angled(-2.2);
        ui.painter()
            .add(Shape::line(vec![end + vec2(-0.4, -4.0), end, end + vec2(4.0, 0.4)], stroke));
    } else {
        ui.painter().circle_filled(at, 3.0, colors.accent);
    }
    response.on_hover_text(help).clicked()
}
