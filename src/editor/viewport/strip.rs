//! Strip of the selected layer's values in a corner of the picture: its angles, where no line shows
//! them, its colors and its warp. The strip would cover the object's feet, so that only a tab is
//! shown until the pointer comes near.

use chiaro_locale::{tr, trn};
use eframe::egui;
use eframe::egui::{
    Align2, Frame, Id, Margin, Rect, Response, RichText, TextWrapMode, Ui, UiBuilder, Vec2,
    WidgetText, pos2, vec2,
};

use crate::commands::Command;
use crate::document::Value;
use crate::fields::bands::{self, Bands, BandsOf};
use crate::fields::edge::{self, EdgeField};
use crate::fields::layer::{Curve, SelectedLayer, Setting};
use crate::state::session::Session;
use crate::widgets::color;
use crate::widgets::number::{NumberField, number_field};
use crate::widgets::theme;

/// Least height of a picture with a strip, in points.
const LEAST_HEIGHT: f32 = 200.0;

/// Distance within which the pointer keeps the strip open, in points.
const NEAR: f32 = 20.0;

/// True while the strip is open, and the ids of its widgets.
#[derive(Clone, Default)]
struct StripState {
    is_open: bool,
    widgets: Vec<Id>,
}

/// Shows the strip, or its tab while the pointer is elsewhere, which leaves `beside` points of the
/// picture's width free. Returns true while the strip is open.
pub(super) fn show(
    ui: &mut Ui,
    rect: Rect,
    session: &Session,
    (layer, beside): (&SelectedLayer, f32),
    out: &mut Vec<Command>,
) -> bool {
    if rect.height() < LEAST_HEIGHT {
        return false;
    }
    let room = rect.shrink(8.0);
    let id = ui.scope_id().with("strip").with(&layer.node);
    let state = ui.scope_id().with("strip is open");
    let seen: StripState = ui.data(|data| data.get_temp(state)).unwrap_or_default();
    let known: Option<Vec2> = ui.data(|data| data.get_temp(id));
    // An open strip stays open while the pointer is near, while one of its widgets has the focus,
    // or during a drag.
    let strip = Rect::from_min_size(
        pos2(room.left(), room.bottom() - known.map_or(64.0, |size| size.y)),
        known.unwrap_or(room.size()),
    );
    let is_near = ui
        .input(|input| input.pointer.hover_pos())
        .is_some_and(|at| strip.expand(NEAR).contains(at));
    let has_keyboard =
        ui.memory(egui::Memory::focused).is_some_and(|focus| seen.widgets.contains(&focus));
    let is_held = ui.input(|input| input.pointer.any_down()) || egui::Popup::is_any_open(ui.ctx());
    let mut now = StripState {
        is_open: seen.is_open && (is_near || has_keyboard || is_held),
        widgets: Vec::new(),
    };
    if now.is_open {
        open(ui, room, id, session, layer, &mut now.widgets, out);
    } else {
        let free = room.with_max_x(room.right() - beside);
        let tab = tab(ui, free, id, layer);
        now.is_open = tab.clicked() || tab.has_focus() || tab.hovered() && !is_held;
        if now.is_open {
            ui.ctx().request_repaint();
        }
        // The focus goes on from the tab to the first of the values.
        now.widgets.push(tab.id);
    }
    let is_open = now.is_open;
    ui.data_mut(|data| data.insert_temp(state, now));
    is_open
}

/// Shows the tab of the closed strip, with the layer's name.
fn tab(ui: &mut Ui, room: Rect, id: Id, layer: &SelectedLayer) -> Response {
    let colors = theme::of(ui);
    let around = vec2(3.0 * DOT + 20.0, 6.0);
    let name = WidgetText::from(RichText::new(&layer.name).color(colors.dim));
    let width = (room.width() - around.x).max(0.0);
    let galley = name.into_galley(ui, Some(TextWrapMode::Truncate), width, egui::TextStyle::Body);
    let size = galley.size() + around;
    let rect = Align2::LEFT_BOTTOM.align_size_within_rect(size, room);
    let response = ui.interact(rect, id.with("tab"), egui::Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(
            egui::Role::Button,
            true,
            tr!("Values of {layer} over the picture", layer = layer.name),
        )
    });
    let painter = ui.painter().with_clip_rect(rect);
    painter.rect_filled(rect, 6.0, colors.panel.gamma_multiply(0.8));
    for index in 0..3_u8 {
        let at = pos2(rect.left() + 8.0 + (f32::from(index) + 0.5) * DOT, rect.center().y);
        painter.circle_filled(at, 4.0, theme::HALO);
        painter.circle_filled(at, 3.0, theme::curve(index.into()));
    }
    let at = rect.left_top() + vec2(around.x - 8.0, around.y / 2.0);
    painter.galley(at, galley, colors.dim);
    response.on_hover_text(tr!("The layer's angles, colors and shape, while the pointer is here"))
}

/// Distance between neighboring dots of the tab, in points.
const DOT: f32 = 10.0;

/// Shows the whole strip; `widgets` collects the ids of widgets that take the focus.
fn open(
    ui: &mut Ui,
    room: Rect,
    id: Id,
    session: &Session,
    layer: &SelectedLayer,
    widgets: &mut Vec<Id>,
    out: &mut Vec<Command>,
) {
    // The height is that of the frame before.
    let size: Vec2 = ui.data(|data| data.get_temp(id)).unwrap_or(vec2(room.width(), 64.0));
    let at = Align2::LEFT_BOTTOM.align_size_within_rect(vec2(room.width(), size.y), room);
    // Presses beside the widgets must not reach the picture below.
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
            ui.horizontal_wrapped(|ui| angles(ui, session, layer, widgets, out));
            if !layer.colors.is_empty() || layer.amount.is_some() {
                ui.horizontal_wrapped(|ui| surface(ui, session, layer, widgets, out));
            }
        })
    });
    let shown = shown.inner.response.rect;
    if (shown.size() - size).length() > 0.5 {
        ui.data_mut(|data| data.insert_temp(id, shown.size()));
        ui.ctx().request_discard("the strip has another height");
    }
}

fn angles(
    ui: &mut Ui,
    session: &Session,
    layer: &SelectedLayer,
    widgets: &mut Vec<Id>,
    out: &mut Vec<Command>,
) {
    ui.label(RichText::new(&layer.name).strong());
    if let Some(setting) = layer.bands() {
        return bands_bar(ui, session, layer, setting, out);
    }
    let Some(shape) = layer.profile() else { return };
    if let Some(field) = EdgeField::of_layer(session, layer) {
        let names = [tr!("Edge on the object"), tr!("Softness on the object")];
        widgets.extend(field.in_line(ui, names, out));
        let toggle = edge::angles_toggle(ui, &layer.path, field.edge().is_some());
        widgets.extend(toggle.widget);
        if !toggle.is_open {
            return;
        }
    }
    for curve in Curve::ALL {
        let setting = &shape[curve.index()];
        let shown = layer.angles_at_key();
        let index = curve.index();
        let least = if index > 0 { shown[index - 1] } else { 0.0 };
        let most = shown.get(index + 1).copied().unwrap_or(std::f64::consts::PI);
        let (dot, _) = ui.allocate_exact_size(vec2(9.0, 9.0), egui::Sense::hover());
        ui.painter().circle_filled(dot.center(), 5.0, theme::HALO);
        ui.painter().circle_filled(dot.center(), 4.0, theme::curve(index));
        let mut degrees = shown[index].to_degrees();
        let widget =
            number_field(ui, &mut degrees).range(least.to_degrees()..=most.to_degrees()).speed(0.5);
        let widget = widget.max_decimals(1).prefix(format!("{} ", curve.label())).suffix("°");
        let help = match curve {
            Curve::Offset => tr!("Up to this angle from the light the tone is full"),
            Curve::Falloff => tr!("Where the tone falls fastest"),
            Curve::Cutoff | Curve::Edge(_) => tr!("Where the tone ends"),
        };
        let response =
            number(ui, widget, setting, &tr!("{curve} on the object", curve = curve.label()), help);
        widgets.push(response.id);
        if response.changed() {
            let angle = (degrees.to_radians() * 1e4).round() / 1e4;
            out.push(Command::EditHeld(
                response.id,
                session.keys().set_at(&setting.target, Value::Number(angle.clamp(least, most))),
            ));
        }
    }
}

/// Shows the bands of a layer as a bar whose edges are dragged.
fn bands_bar(
    ui: &mut Ui,
    session: &Session,
    layer: &SelectedLayer,
    setting: &Setting<Bands>,
    out: &mut Vec<Command>,
) {
    let size = vec2(BAND_BAR.min(ui.available_width()), ui.spacing().interact_size.y);
    let (rect, _) = ui.allocate_exact_size(size, egui::Sense::hover());
    let (mut bands, mut changed) = (setting.at_key.clone(), None);
    let space = session.look().color_space;
    bands::bar(ui, rect, &mut bands, space, BandsOf::Strip, &mut changed);
    if let Some(widget) = changed.filter(|_| !setting.is_wired) {
        let edit = session.keys().set_at(&setting.target, Value::Ramp(bands.ramp()));
        out.push(Command::EditHeld(widget, edit));
    }
    let count = layer.bands().map_or(0, |it| it.at_key.colors.len());
    let words = trn!(count, "{count} band", "{count} bands");
    ui.label(RichText::new(words).color(theme::of(ui).dim));
}

/// Width of the bar of bands, in points.
const BAND_BAR: f32 = 220.0;

fn surface(
    ui: &mut Ui,
    session: &Session,
    layer: &SelectedLayer,
    widgets: &mut Vec<Id>,
    out: &mut Vec<Command>,
) {
    for (label, setting) in &layer.colors {
        let label = ui.label(RichText::new(*label).color(theme::of(ui).dim));
        let changed = ui
            .add_enabled_ui(!setting.is_wired, |ui| {
                color::swatch(ui, label.id, setting.at_key, session.look().color_space, true)
            })
            .inner;
        if let Some((widget, color)) = changed {
            out.push(Command::EditHeld(
                widget,
                session.keys().set_at(&setting.target, Value::Vector(color.to_vec())),
            ));
        }
    }
    if let Some(setting) = &layer.slope {
        let mut slope = setting.at_key;
        let widget = number_field(ui, &mut slope)
            .speed(0.005)
            .max_decimals(3)
            .prefix(format!("{} ", tr!("Shape slope")));
        let help = tr!("How sharply concave turns into convex; 0 is flat everywhere");
        let response = number(ui, widget, setting, tr!("Shape slope on the object"), help);
        widgets.push(response.id);
        if response.changed() {
            out.push(Command::EditHeld(
                response.id,
                session.keys().set_at(&setting.target, Value::Number(slope)),
            ));
        }
    }
    if let Some(setting) = &layer.amount {
        let mut degrees = setting.at_key.to_degrees();
        let widget =
            number_field(ui, &mut degrees).speed(0.5).range(-180.0..=180.0).max_decimals(1);
        let widget = widget.prefix(format!("{} ", tr!("Shape offset"))).suffix("°");
        let help = tr!(
            "How far convex parts are lit beyond, and concave parts short of, what the profile \
             says"
        );
        let response = number(ui, widget, setting, tr!("Shape offset on the object"), help);
        widgets.push(response.id);
        if response.changed() {
            out.push(Command::EditHeld(
                response.id,
                session.keys().set_at(&setting.target, Value::Number(degrees.to_radians())),
            ));
        }
    }
}

fn number<T>(
    ui: &mut Ui,
    widget: NumberField<'_>,
    setting: &Setting<T>,
    name: &str,
    help: &str,
) -> Response {
    let response = ui.add_enabled(!setting.is_wired, widget);
    set_name(ui, response.id, name);
    response
        .on_hover_text(help)
        .on_disabled_hover_text(tr!("It cannot be set here: it comes from a wire"))
}

/// Names a widget for screen readers.
fn set_name(ui: &Ui, id: Id, name: &str) {
    ui.ctx().accesskit_node_builder(id, |node| node.set_label(name));
}
