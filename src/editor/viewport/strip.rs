//! The selected layer's values at hand in a corner of the picture: its angles, where no line of them is seen, its
//! colours and its warp.

use eframe::egui;
use eframe::egui::{Align2, DragValue, Frame, Id, Margin, Rect, Response, RichText, Ui, UiBuilder, Vec2, vec2};

use super::super::command::Command;
use super::super::inspector::color;
use super::super::session::Session;
use super::super::theme;
use super::layer::{Curve, Layer, Setting};
use crate::document::Value;

/// Pictures lower than this, in points, have no room for it.
const LEAST_HEIGHT: f32 = 200.0;

/// Shows the strip; says where it is.
pub(super) fn show(ui: &mut Ui, rect: Rect, session: &Session, layer: &Layer, out: &mut Vec<Command>) -> Option<Rect> {
    if rect.height() < LEAST_HEIGHT {
        return None;
    }
    let room = rect.shrink(8.0);
    let id = ui.scope_id().with("strip").with(&layer.node);
    // Its height is known from the frame before.
    let size: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or(vec2(room.width(), 64.0));
    let at = Align2::LEFT_BOTTOM.align_size_within_rect(vec2(room.width(), size.y), room);
    // What is pressed beside its widgets does nothing to the picture below.
    let known = Rect::from_min_size(at.min, size);
    ui.interact(known, id.with("ground"), egui::Sense::click_and_drag());
    let builder = UiBuilder::new().id_salt("strip").max_rect(at);
    let frame = Frame::new()
        .fill(theme::of(ui).panel.gamma_multiply(0.86))
        .corner_radius(6.0)
        .inner_margin(Margin::symmetric(8, 5));
    let shown = ui.scope_builder(builder, |ui| {
        frame.show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 3.0;
            ui.horizontal_wrapped(|ui| angles(ui, session, layer, out));
            if !layer.colors.is_empty() || layer.amount.is_some() {
                ui.horizontal_wrapped(|ui| surface(ui, session, layer, out));
            }
        })
    });
    let shown = shown.inner.response.rect;
    if (shown.size() - size).length() > 0.5 {
        ui.data_mut(|data| data.insert_temp(id, shown.size()));
        ui.ctx().request_discard("the strip has another height");
    }
    Some(shown)
}

fn angles(ui: &mut Ui, session: &Session, layer: &Layer, out: &mut Vec<Command>) {
    ui.label(RichText::new(&layer.name).strong());
    for curve in Curve::ALL {
        let setting = &layer.shape[curve as usize];
        let shown = layer.angles_at_key();
        let index = curve as usize;
        let least = if index > 0 { shown[index - 1] } else { 0.0 };
        let most = shown.get(index + 1).copied().unwrap_or(std::f64::consts::PI);
        let (dot, _) = ui.allocate_exact_size(vec2(9.0, 9.0), egui::Sense::hover());
        ui.painter().circle_filled(dot.center(), 5.0, theme::HALO);
        ui.painter().circle_filled(dot.center(), 4.0, theme::curve(index));
        let mut degrees = shown[index].to_degrees();
        let widget = DragValue::new(&mut degrees).range(least.to_degrees()..=most.to_degrees()).speed(0.5);
        let widget =
            widget.max_decimals(1).prefix(format!("{} ", curve.label())).suffix("°").update_while_editing(false);
        let help = match curve {
            Curve::Offset => "Up to this angle from the light the tone is full",
            Curve::Falloff => "Where the tone falls fastest",
            Curve::Cutoff => "Where the tone ends",
        };
        let response = number(ui, widget, setting, &format!("{} on the object", curve.label()), help);
        if response.changed() {
            let angle = (degrees.to_radians() * 1e4).round() / 1e4;
            out.push(Command::EditHeld(
                response.id,
                session.set_at(&setting.target, Value::Number(angle.clamp(least, most))),
            ));
        }
    }
}

fn surface(ui: &mut Ui, session: &Session, layer: &Layer, out: &mut Vec<Command>) {
    for (label, setting) in &layer.colors {
        let short = label.trim_end_matches(" color");
        let label = ui.label(RichText::new(short).color(theme::of(ui).dim));
        let changed = ui
            .add_enabled_ui(!setting.is_wired, |ui| {
                color::swatch(ui, label.id, setting.at_key, session.look().color_space, true)
            })
            .inner;
        if let Some((hand, color)) = changed {
            out.push(Command::EditHeld(hand, session.set_at(&setting.target, Value::Vector(color.to_vec()))));
        }
    }
    if let Some(setting) = &layer.slope {
        let mut slope = setting.at_key;
        let widget = DragValue::new(&mut slope).speed(0.005).max_decimals(3).prefix("Shape slope ");
        let help = "How sharply concave turns into convex; 0 is flat everywhere";
        let response = number(ui, widget, setting, "Shape slope on the object", help);
        if response.changed() {
            out.push(Command::EditHeld(response.id, session.set_at(&setting.target, Value::Number(slope))));
        }
    }
    if let Some(setting) = &layer.amount {
        let mut degrees = setting.at_key.to_degrees();
        let widget = DragValue::new(&mut degrees).speed(0.5).range(-180.0..=180.0).max_decimals(1);
        let widget = widget.prefix("Shape offset ").suffix("°");
        let help = "How far convex parts are lit beyond, and concave parts short of, what the profile says";
        let response = number(ui, widget, setting, "Shape offset on the object", help);
        if response.changed() {
            out.push(Command::EditHeld(
                response.id,
                session.set_at(&setting.target, Value::Number(degrees.to_radians())),
            ));
        }
    }
}

fn number<T>(ui: &mut Ui, widget: DragValue<'_>, setting: &Setting<T>, name: &str, help: &str) -> Response {
    let response = ui.add_enabled(!setting.is_wired, widget);
    set_name(ui, response.id, name);
    response.on_hover_text(help).on_disabled_hover_text("It cannot be set here: it comes from a wire")
}

/// Names a widget for screen readers.
fn set_name(ui: &Ui, id: Id, name: &str) {
    ui.ctx().accesskit_node_builder(id, |node| node.set_label(name));
}
