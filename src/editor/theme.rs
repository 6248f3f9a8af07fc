//! Colours, sizes and fonts of the window, all in one place.
//!
//! A calm dark ground with one warm accent, so that the picture and the wires are what is seen. A socket says its type
//! by colour and by shape.

use eframe::egui;
use eframe::egui::{Color32, CornerRadius, FontFamily, FontId, Margin, Stroke, TextStyle, Visuals};

use crate::library::Type;

/// Panels.
pub(crate) const PANEL: Color32 = Color32::from_rgb(34, 35, 39);
/// The canvas.
pub(crate) const CANVAS: Color32 = Color32::from_rgb(24, 25, 28);
/// The dots of the canvas's grid.
pub(crate) const GRID: Color32 = Color32::from_rgb(45, 47, 52);
/// A node's body.
pub(crate) const NODE: Color32 = Color32::from_rgb(44, 46, 51);
/// The edge of a node.
pub(crate) const NODE_EDGE: Color32 = Color32::from_rgb(16, 17, 19);
/// Around a colour, so that dark ones are seen.
pub(crate) const SWATCH_EDGE: Color32 = Color32::from_rgb(92, 94, 100);
/// Plain text.
pub(crate) const TEXT: Color32 = Color32::from_rgb(222, 221, 217);
/// Text of less weight: units, hints, line numbers.
pub(crate) const DIM: Color32 = Color32::from_rgb(145, 146, 150);
/// What is selected or does something when pressed.
pub(crate) const ACCENT: Color32 = Color32::from_rgb(236, 164, 84);
/// The accent behind text.
pub(crate) const ACCENT_DIM: Color32 = Color32::from_rgb(92, 68, 42);
/// Errors.
pub(crate) const ERROR: Color32 = Color32::from_rgb(240, 98, 88);
/// Warnings.
pub(crate) const WARNING: Color32 = Color32::from_rgb(233, 196, 92);
/// Fields that are typed or dragged.
pub(crate) const FIELD: Color32 = Color32::from_rgb(50, 52, 57);

/// The size of plain text, in points.
pub(crate) const TEXT_SIZE: f32 = 13.0;
/// The width of a node, in points at zoom 1.
pub(crate) const NODE_WIDTH: f32 = 184.0;
/// The height of a node's title.
pub(crate) const TITLE_HEIGHT: f32 = 26.0;
/// The height of a port's row.
pub(crate) const ROW_HEIGHT: f32 = 20.0;
/// What a node has below its last row.
pub(crate) const NODE_FOOT: f32 = 6.0;
/// A socket's radius.
pub(crate) const SOCKET: f32 = 5.0;

/// How a socket is drawn, so that types are told apart without colour too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SocketShape {
    /// Numbers.
    Circle,
    /// Vectors.
    Diamond,
    /// Colours and stacks.
    Square,
    /// Angles.
    Triangle,
    /// Lights.
    Hexagon,
}

/// The colour of a type's sockets and wires.
pub(crate) fn type_color(ty: &Type) -> Color32 {
    match ty {
        Type::Float => Color32::from_rgb(176, 180, 188),
        Type::Int => Color32::from_rgb(126, 178, 150),
        Type::Bool => Color32::from_rgb(214, 140, 172),
        Type::Vec2 | Type::Vec3 | Type::Vec4 | Type::Mat3 => Color32::from_rgb(124, 146, 232),
        Type::Color => Color32::from_rgb(232, 200, 84),
        Type::Composite => Color32::from_rgb(238, 146, 66),
        Type::Angle => Color32::from_rgb(92, 194, 182),
        Type::Light => Color32::from_rgb(250, 238, 196),
        Type::Curve | Type::Ramp => Color32::from_rgb(190, 140, 224),
        _ => Color32::from_rgb(150, 138, 126),
    }
}

/// The shape of a type's sockets.
pub(crate) fn type_shape(ty: &Type) -> SocketShape {
    match ty {
        Type::Vec2 | Type::Vec3 | Type::Vec4 | Type::Mat3 => SocketShape::Diamond,
        Type::Color | Type::Composite => SocketShape::Square,
        Type::Angle => SocketShape::Triangle,
        Type::Light => SocketShape::Hexagon,
        _ => SocketShape::Circle,
    }
}

/// The colour of a category's titles.
pub(crate) fn category_color(category: &str) -> Color32 {
    match category {
        "layer" => Color32::from_rgb(116, 76, 44),
        "light" => Color32::from_rgb(110, 96, 50),
        "curvature" => Color32::from_rgb(62, 92, 62),
        "geometry" => Color32::from_rgb(48, 88, 92),
        "color" => Color32::from_rgb(104, 66, 82),
        "vector" => Color32::from_rgb(66, 72, 116),
        "math" => Color32::from_rgb(68, 76, 90),
        "input" => Color32::from_rgb(92, 64, 64),
        _ => Color32::from_rgb(74, 74, 78),
    }
}

/// Sets colours, fonts and spacings for the whole window.
pub(crate) fn apply(ctx: &egui::Context) {
    ctx.set_theme(egui::Theme::Dark);
    let mut visuals = Visuals::dark();
    visuals.override_text_color = None;
    visuals.panel_fill = PANEL;
    visuals.window_fill = Color32::from_rgb(39, 40, 45);
    visuals.window_stroke = Stroke::new(1.0, Color32::from_rgb(62, 64, 70));
    visuals.extreme_bg_color = Color32::from_rgb(26, 27, 30);
    visuals.faint_bg_color = Color32::from_rgb(38, 39, 43);
    visuals.selection.bg_fill = ACCENT_DIM;
    visuals.selection.stroke = Stroke::new(1.0, ACCENT);
    visuals.hyperlink_color = ACCENT;
    visuals.slider_trailing_fill = true;
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.fg_stroke.color = TEXT;
    widgets.noninteractive.bg_stroke.color = Color32::from_rgb(48, 50, 55);
    widgets.inactive.fg_stroke.color = TEXT;
    widgets.inactive.bg_fill = FIELD;
    widgets.inactive.weak_bg_fill = FIELD;
    widgets.hovered.bg_fill = Color32::from_rgb(62, 64, 70);
    widgets.hovered.weak_bg_fill = Color32::from_rgb(62, 64, 70);
    widgets.hovered.bg_stroke = Stroke::new(1.0, Color32::from_rgb(92, 94, 100));
    widgets.active.bg_fill = ACCENT_DIM;
    widgets.active.weak_bg_fill = ACCENT_DIM;
    widgets.active.bg_stroke = Stroke::new(1.0, ACCENT);
    widgets.open.weak_bg_fill = Color32::from_rgb(58, 60, 66);
    let radius = CornerRadius::same(4);
    for state in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        state.corner_radius = radius;
        state.expansion = 0.0;
    }
    ctx.set_visuals_of(egui::Theme::Dark, visuals);
    ctx.style_mut_of(egui::Theme::Dark, |style| {
        style.spacing.item_spacing = egui::vec2(6.0, 5.0);
        style.spacing.button_padding = egui::vec2(8.0, 3.0);
        style.spacing.interact_size.y = 22.0;
        style.spacing.window_margin = Margin::same(8);
        style.interaction.tooltip_delay = 0.4;
        style.text_styles = [
            (TextStyle::Small, FontId::proportional(11.0)),
            (TextStyle::Body, FontId::proportional(TEXT_SIZE)),
            (TextStyle::Button, FontId::proportional(TEXT_SIZE)),
            (TextStyle::Heading, FontId::proportional(16.0)),
            (TextStyle::Monospace, FontId::new(12.0, FontFamily::Monospace)),
        ]
        .into();
    });
}

/// The frame of a panel.
pub(crate) fn panel() -> egui::Frame {
    egui::Frame::new().fill(PANEL).inner_margin(Margin::symmetric(10, 8))
}
