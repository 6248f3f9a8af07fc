//! One input: its label, and what edits its value.

use eframe::egui;
use eframe::egui::{Checkbox, ComboBox, DragValue, Id, RichText, Slider, TextEdit, Ui, vec2};

use super::super::catalog::Port;
use super::super::command::Command;
use super::super::{theme, values};
use super::{Subject, color, curve, ramp};
use crate::document::{Edit, Endpoint, Value, Wire};
use crate::ids::PortName;
use crate::library::{Fallback, Type};

/// How wide labels are.
const LABEL: f32 = 104.0;

/// A label with help, and a widget that is named by it.
pub(crate) fn labelled(ui: &mut Ui, label: &str, help: &str, add: impl FnOnce(&mut Ui, Id)) {
    labelled_in(ui, label, help, theme::of(ui).text, add);
}

fn labelled_in(ui: &mut Ui, label: &str, help: &str, color: egui::Color32, add: impl FnOnce(&mut Ui, Id)) {
    ui.horizontal(|ui| {
        let size = vec2(LABEL, ui.spacing().interact_size.y);
        let layout = egui::Layout::left_to_right(egui::Align::Center);
        let response = ui.allocate_ui_with_layout(size, layout, |ui| {
            ui.set_min_width(LABEL);
            ui.add(egui::Label::new(RichText::new(label).color(color)).truncate())
        });
        let id = response.inner.id;
        if !help.is_empty() {
            response.inner.on_hover_text(help);
        }
        add(ui, id);
    });
}

/// Shows an input.
pub(super) fn show(ui: &mut Ui, subject: &Subject<'_>, port: &Port, out: &mut Vec<Command>) {
    ui.push_id(&port.name, |ui| {
        if let Some(wire) = subject.session.graph().wire_into(subject.id, &port.name) {
            return wired(ui, subject, port, wire, out);
        }
        let own = subject.node.values.get(&port.name);
        let help = help_of(port);
        match port.ty {
            Type::Text => code(ui, subject, port, own, out),
            Type::Curve => wide(ui, subject, port, own, out, curve::show),
            Type::Ramp => wide(ui, subject, port, own, out, ramp::show),
            _ => {
                let tone = if own.is_some() { theme::of(ui).text } else { theme::of(ui).dim };
                labelled_in(ui, &port.label, &help, tone, |ui, label| {
                    reset(ui, subject, port, out);
                    if let Some((id, value)) = widget(ui, label, subject, port, own) {
                        out.push(held(subject, port, id, value));
                    }
                });
            }
        }
    });
}

fn help_of(port: &Port) -> String {
    let mut help = port.help.clone();
    if !help.is_empty() {
        help += "\n";
    }
    help += &format!("{} ({})", port.name, port.ty);
    help
}

fn held(subject: &Subject<'_>, port: &Port, widget: Id, value: Value) -> Command {
    Command::EditHeld(widget, set(subject, &port.name, value))
}

fn set(subject: &Subject<'_>, port: &PortName, value: Value) -> Edit {
    Edit::SetValue {
        graph: subject.session.graph_id().clone(),
        id: subject.id.clone(),
        port: port.clone(),
        value,
        index: None,
    }
}

/// What feeds a wired input.
fn wired(ui: &mut Ui, subject: &Subject<'_>, port: &Port, wire: &Wire, out: &mut Vec<Command>) {
    labelled(ui, &port.label, &help_of(port), |ui, _| {
        let Endpoint { node, .. } = &wire.from;
        let from = subject.session.graph().nodes.get(node);
        let kind = from.and_then(|from| subject.session.catalog.of(from));
        let name = match (from, kind) {
            (Some(from), _) if !from.name.is_empty() => from.name.clone(),
            (_, Some(kind)) => kind.label.to_string(),
            _ => node.to_string(),
        };
        if ui.link(format!("from {name}")).on_hover_text("Shows the node that feeds this").clicked() {
            out.push(Command::Reveal(node.clone()));
        }
        if ui.small_button("Unwire").on_hover_text("Removes the wire").clicked() {
            out.push(Command::Edit(Edit::RemoveWire { graph: subject.session.graph_id().clone(), wire: wire.clone() }));
        }
    });
}

/// Takes an own value away.
fn reset(ui: &mut Ui, subject: &Subject<'_>, port: &Port, out: &mut Vec<Command>) {
    // What a context would give has no widget of its own, so this is the only way back.
    let is_own = subject.node.values.contains_key(&port.name);
    let is_read = matches!(port.fallback, Fallback::Context(_) | Fallback::Same(_));
    if is_own && is_read && ui.small_button("Default").clicked() {
        let edit = Edit::ClearValue {
            graph: subject.session.graph_id().clone(),
            id: subject.id.clone(),
            port: port.name.clone(),
        };
        out.push(Command::Edit(edit));
    }
}

/// The widget of a type; the new value where it was changed, and who changed it.
fn widget(ui: &mut Ui, label: Id, subject: &Subject<'_>, port: &Port, own: Option<&Value>) -> Option<(Id, Value)> {
    let value = values::current(port, own);
    if value.is_none() {
        return unset(ui, subject, port);
    }
    match &port.ty {
        Type::Bool => {
            let mut on = values::number(value) > 0.5;
            let response = ui.add(Checkbox::without_text(&mut on)).labelled_by(label);
            response.changed().then_some((response.id, Value::Bool(on)))
        }
        Type::Choice => choice(ui, label, port, value),
        Type::LightName => light_name(ui, label, subject, value),
        Type::Color | Type::Composite => {
            let space = subject.session.look().color_space;
            let color = value.and_then(|value| value.color_in(space)).unwrap_or([0.0, 0.0, 0.0, 1.0]);
            let (id, color) = color::edit(ui, label, color, space, true)?;
            let is_opaque = color[3] == 1.0;
            Some((id, Value::Vector(if is_opaque { color[..3].to_vec() } else { color.to_vec() })))
        }
        Type::Vec2 => vector(ui, label, port, value, 2),
        Type::Vec3 => vector(ui, label, port, value, 3),
        Type::Vec4 => vector(ui, label, port, value, 4),
        Type::Image => path(ui, label, value),
        Type::Float | Type::Int | Type::Angle => number(ui, label, port, value),
        _ => {
            ui.label(RichText::new("by wire only").color(theme::of(ui).dim));
            None
        }
    }
}

/// An input that has neither a value nor a default.
fn unset(ui: &mut Ui, subject: &Subject<'_>, port: &Port) -> Option<(Id, Value)> {
    let width = port.ty.width();
    let of_all = |number: f64| match width {
        Some(1) => Some(Value::Number(number)),
        Some(width) => Some(Value::Vector(vec![number; width])),
        None => None,
    };
    let (text, first) = match &port.fallback {
        Fallback::Context(context) => (format!("the surface's {}", values::words(context.word())), of_all(0.0)),
        Fallback::Same(other) => {
            let kind = subject.session.catalog.of(subject.node);
            let of_other = kind.and_then(|kind| Some(&kind.inputs[kind.input(other.as_str())?]));
            let value = of_other.and_then(|other| values::current(other, subject.node.values.get(&other.name)));
            (format!("as {}", values::words(other.as_str())), value.cloned().or_else(|| of_all(1.0)))
        }
        _ => {
            ui.label(RichText::new("wire something here").color(theme::of(ui).warning));
            return None;
        }
    };
    ui.label(RichText::new(text).color(theme::of(ui).dim));
    let response = ui.small_button("Set").on_hover_text("Gives it a value of its own");
    if response.clicked() { Some((response.id, first?)) } else { None }
}

/// Radians are shown as degrees.
fn number(ui: &mut Ui, label: Id, port: &Port, value: Option<&Value>) -> Option<(Id, Value)> {
    let scale = if port.unit == "rad" { 180.0 / std::f64::consts::PI } else { 1.0 };
    let is_int = port.ty == Type::Int;
    let mut shown = values::number(value) * scale;
    let suffix = match port.unit.as_str() {
        "rad" => "°",
        "px" => " px",
        "s" => " s",
        _ => "",
    };
    let decimals = if is_int {
        0
    } else if scale == 1.0 {
        3
    } else {
        1
    };
    let response = match (port.min, port.max) {
        (Some(min), Some(max)) => {
            ui.spacing_mut().slider_width = (ui.available_width() - 66.0).max(40.0);
            let range = min * scale..=max * scale;
            let slider = Slider::new(&mut shown, range).suffix(suffix).max_decimals(decimals);
            let slider = slider.clamping(egui::SliderClamping::Edits);
            ui.add(if is_int { slider.integer() } else { slider })
        }
        (min, max) => {
            let range = min.map_or(f64::NEG_INFINITY, |x| x * scale)..=max.map_or(f64::INFINITY, |x| x * scale);
            let speed = if is_int { 0.1 } else { 0.01 * scale.max(1.0) };
            let drag = DragValue::new(&mut shown)
                .range(range)
                .clamp_existing_to_range(false)
                .suffix(suffix)
                .max_decimals(decimals)
                .speed(speed);
            ui.add_sized(vec2(ui.available_width(), ui.spacing().interact_size.y), drag)
        }
    };
    let response = response.labelled_by(label);
    if !response.changed() || !shown.is_finite() {
        return None;
    }
    Some((response.id, Value::Number(if is_int { shown.round() } else { shown / scale })))
}

fn vector(ui: &mut Ui, label: Id, port: &Port, value: Option<&Value>, width: usize) -> Option<(Id, Value)> {
    let mut numbers = values::vector(value, width);
    let each = (ui.available_width() - ui.spacing().item_spacing.x * (width as f32 - 1.0)) / width as f32;
    let mut changed = None;
    for number in &mut numbers {
        let mut drag = DragValue::new(number).speed(0.01).max_decimals(3).clamp_existing_to_range(false);
        if let (Some(min), Some(max)) = (port.min, port.max) {
            drag = drag.range(min..=max);
        }
        let response = ui.add_sized(vec2(each, ui.spacing().interact_size.y), drag).labelled_by(label);
        if response.changed() {
            changed = Some(response.id);
        }
    }
    let is_finite = numbers.iter().all(|number| number.is_finite());
    changed.filter(|_| is_finite).map(|id| (id, Value::Vector(numbers)))
}

fn choice(ui: &mut Ui, label: Id, port: &Port, value: Option<&Value>) -> Option<(Id, Value)> {
    let word = match value {
        Some(Value::Text(word)) => word.as_str(),
        _ => "",
    };
    let shown = port.options.iter().find(|(known, _)| known == word).map_or(word, |(_, label)| label);
    let width = ui.available_width();
    let mut chosen = None;
    let combo = ComboBox::from_id_salt("choice").width(width).selected_text(shown).show_ui(ui, |ui| {
        for (known, label) in &port.options {
            if ui.selectable_label(known == word, label).clicked() && known != word {
                chosen = Some(known.clone());
            }
        }
    });
    let response = combo.response.labelled_by(label);
    chosen.map(|word| (response.id.with(&word), Value::Text(word)))
}

fn light_name(ui: &mut Ui, label: Id, subject: &Subject<'_>, value: Option<&Value>) -> Option<(Id, Value)> {
    let id = match value {
        Some(Value::Text(id)) => id.as_str(),
        _ => "",
    };
    let lights = &subject.session.look().lights;
    let name = |id: &str| {
        let light = lights.get(id).filter(|light| !light.name.is_empty());
        light.map_or_else(|| id.to_owned(), |light| light.name.clone())
    };
    let mut chosen = None;
    let shown = if id.is_empty() { "choose a light".to_owned() } else { name(id) };
    let combo = ComboBox::from_id_salt("light").width(ui.available_width()).selected_text(shown).show_ui(ui, |ui| {
        for known in lights.keys() {
            if ui.selectable_label(known.as_str() == id, name(known.as_str())).clicked() {
                chosen = Some(known.to_string());
            }
        }
    });
    let response = combo.response.labelled_by(label);
    chosen.map(|id| (response.id.with(&id), Value::Text(id)))
}

fn path(ui: &mut Ui, label: Id, value: Option<&Value>) -> Option<(Id, Value)> {
    let mut text = match value {
        Some(Value::Text(text)) => text.clone(),
        _ => String::new(),
    };
    let edit = TextEdit::singleline(&mut text).hint_text("path beside the look").desired_width(f32::INFINITY);
    let response = ui.add(edit).labelled_by(label);
    response.changed().then_some((response.id, Value::Text(text)))
}

/// WGSL of a custom node.
fn code(ui: &mut Ui, subject: &Subject<'_>, port: &Port, own: Option<&Value>, out: &mut Vec<Command>) {
    let mut text = match values::current(port, own) {
        Some(Value::Text(text)) => text.clone(),
        _ => String::new(),
    };
    let label = ui.label(&*port.label).on_hover_text(help_of(port)).id;
    let edit = TextEdit::multiline(&mut text).code_editor().desired_rows(10).desired_width(f32::INFINITY);
    let response = ui.add(edit).labelled_by(label);
    if response.changed() {
        out.push(held(subject, port, response.id, Value::Text(text)));
    }
}

type Editor = fn(&mut Ui, Id, Option<&Value>) -> Option<(Id, Value)>;

/// An editor that takes the whole width, below its label.
fn wide(ui: &mut Ui, subject: &Subject<'_>, port: &Port, own: Option<&Value>, out: &mut Vec<Command>, show: Editor) {
    let label = ui.label(&*port.label).on_hover_text(help_of(port)).id;
    if let Some((id, value)) = show(ui, label, values::current(port, own)) {
        out.push(held(subject, port, id, value));
    }
}
