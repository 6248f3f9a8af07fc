//! Editor of a value in a cell of a table, in as little room as its type allows.

use chiaro_locale::tr_in;
use eframe::egui::{Checkbox, ComboBox, Id, RichText, TextWrapMode, Ui, vec2};

use super::color;
use crate::catalog::Port;
use crate::document::{ColorSpace, Value};
use crate::library::Type;
use crate::values;
use crate::widgets::number::number_field;
use crate::widgets::theme;

/// Edits a value in place; `name` is its name for screen readers. Returns the id of the widget and
/// the new value where it changed.
pub(crate) fn cell(
    ui: &mut Ui,
    name: &str,
    port: &Port,
    value: &Value,
    space: ColorSpace,
) -> Option<(Id, Value)> {
    match &port.ty {
        Type::Bool => {
            let mut on = values::number(Some(value)) > 0.5;
            let response = ui.add(Checkbox::without_text(&mut on));
            named(&response, eframe::egui::Role::CheckBox, name);
            response.changed().then_some((response.id, Value::Bool(on)))
        }
        Type::Choice => choice(ui, name, port, value),
        Type::Color | Type::Composite => {
            let now = value.color_in(space).unwrap_or([0.0, 0.0, 0.0, 1.0]);
            let (id, now) = color::named_swatch(ui, name, now, space, true)?;
            let is_opaque = now[3] == 1.0;
            Some((id, Value::Vector(if is_opaque { now[..3].to_vec() } else { now.to_vec() })))
        }
        Type::Vec2 => vector(ui, name, value, 2),
        Type::Vec3 => vector(ui, name, value, 3),
        Type::Vec4 => vector(ui, name, value, 4),
        Type::Float | Type::Int | Type::Angle => number(ui, name, port, value),
        _ => {
            ui.label(RichText::new(values::short(port, value)).color(theme::of(ui).dim));
            None
        }
    }
}

fn named(response: &eframe::egui::Response, role: eframe::egui::Role, name: &str) {
    response.widget_info(|| eframe::egui::WidgetInfo::labeled(role, true, name));
}

fn number(ui: &mut Ui, name: &str, port: &Port, value: &Value) -> Option<(Id, Value)> {
    let scale = if port.unit == "rad" { 180.0 / std::f64::consts::PI } else { 1.0 };
    let is_int = port.ty == Type::Int;
    let mut shown = values::number(Some(value)) * scale;
    let range = port.min.map_or(f64::NEG_INFINITY, |x| x * scale)
        ..=port.max.map_or(f64::INFINITY, |x| x * scale);
    let drag = number_field(ui, &mut shown)
        .range(range)
        .clamp_existing_to_range(false)
        .suffix(if scale == 1.0 { "" } else { "°" })
        .max_decimals(if is_int {
            0
        } else if scale == 1.0 {
            3
        } else {
            1
        })
        .speed(if scale == 1.0 { 0.01 } else { 0.5 });
    let response = ui.add_sized(vec2(66.0, ui.spacing().interact_size.y), drag);
    named(&response, eframe::egui::Role::SpinButton, name);
    let number = if is_int { shown.round() } else { shown / scale };
    (response.changed() && shown.is_finite()).then_some((response.id, Value::Number(number)))
}

fn vector(ui: &mut Ui, name: &str, value: &Value, width: usize) -> Option<(Id, Value)> {
    let mut numbers = values::vector(Some(value), width);
    let mut changed = None;
    for (number, axis) in numbers.iter_mut().zip(["x", "y", "z", "w"]) {
        let drag = number_field(ui, number).speed(0.01).max_decimals(3);
        let response = ui.add_sized(vec2(44.0, ui.spacing().interact_size.y), drag);
        named(&response, eframe::egui::Role::SpinButton, &format!("{name} {axis}"));
        if response.changed() {
            changed = Some(response.id);
        }
    }
    changed.filter(|_| numbers.iter().all(|x| x.is_finite())).map(|id| (id, Value::Vector(numbers)))
}

fn choice(ui: &mut Ui, name: &str, port: &Port, value: &Value) -> Option<(Id, Value)> {
    let Value::Text(word) = value else { return None };
    let shown = port
        .options
        .iter()
        .find(|(known, _)| known == word)
        .map_or(word.as_str(), |(_, label)| tr_in("choice", label));
    let mut chosen = None;
    let combo = ComboBox::from_id_salt(name)
        .width(80.0)
        .wrap_mode(TextWrapMode::Extend)
        .selected_text(shown)
        .show_ui(ui, |ui| {
            for (known, label) in &port.options {
                if ui.selectable_label(known == word, tr_in("choice", label)).clicked()
                    && known != word
                {
                    chosen = Some(known.clone());
                }
            }
        });
    named(&combo.response, eframe::egui::Role::ComboBox, name);
    chosen.map(|word| (combo.response.id.with(&word), Value::Text(word)))
}
