//! Toolbar above the tile: the tools, the brush and the colors.

use chiaro_locale::tr;
use eframe::egui::{
    Color32, Rect, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo, color_picker, vec2,
};

use super::icons;
use super::tools::{LARGEST, PALETTE, Tools};
use crate::commands::PaintTool;
use crate::document::ColorSpace;
use crate::hcbtf::paint::{Pressure, Symmetry};
use crate::widgets::color;
use crate::widgets::number::{NumberField, number_field, number_slider};
use crate::widgets::theme;

/// Side of a color of the palette, in points.
const SWATCH: f32 = 16.0;
/// Widest soft edge that a fill goes under, in texels.
const MOST_EDGE: u32 = 64;
/// Change of the current color's value per point of the wheel.
const WHEEL: f32 = 0.0012;

/// Shows the tools and their settings.
pub(super) fn show(ui: &mut Ui, tools: &mut Tools) {
    ui.horizontal_wrapped(|ui| {
        for kind in PaintTool::ALL {
            let response = icons::button(ui, kind, tools.kind == kind);
            if response.clicked() {
                if kind == PaintTool::Stamp && ui.input(|input| input.modifiers.shift) {
                    tools.stamp = None;
                }
                tools.take(kind);
            }
        }
        ui.separator();
        colors(ui, tools);
        ui.separator();
        palette(ui, tools);
    });
    ui.horizontal_wrapped(|ui| match tools.kind {
        PaintTool::Fill => {
            let help =
                tr!("How far a color may be from the one under the pointer to be filled too");
            part(ui, tr!("Tolerance"), help, &mut tools.tolerance);
            let help = tr!(
                "How many texels the color goes on under soft edges, so that no rim of the old one \
                 is left; 0 stops where the tolerance does"
            );
            let drag = number_field(ui, &mut tools.edge)
                .range(0..=MOST_EDGE)
                .speed(0.1)
                .suffix(format!(" {}", tr!("texels")));
            named(ui, tr!("Under edges"), help, drag);
        }
        PaintTool::Pick => {
            ui.label(tr!("Click or drag on the tile to take a color"));
        }
        _ => brush(ui, tools),
    });
}

fn brush(ui: &mut Ui, tools: &mut Tools) {
    let size = number_field(ui, &mut tools.size)
        .range(1.0..=LARGEST)
        .speed(0.1)
        .max_decimals(1)
        .suffix(format!(" {}", tr!("texels")));
    named(ui, tr!("Size"), tr!("The brush's diameter ([ and ] make it smaller and larger)"), size);
    part(
        ui,
        tr!("Hardness"),
        tr!("How sharp the brush's edge is: at 0% it fades from its middle on"),
        &mut tools.hardness,
    );
    part(ui, tr!("Opacity"), tr!("How much a whole stroke covers at most"), &mut tools.opacity);
    part(
        ui,
        tr!("Flow"),
        tr!("How much of that each touch adds: low flow builds up as you go over it again"),
        &mut tools.flow,
    );
    ui.menu_button(symmetry_label(&tools.symmetry), |ui| symmetry(ui, &mut tools.symmetry))
        .response
        .on_hover_text(tr!("Repeats strokes mirrored or turned around the middle of the tile"));
    ui.menu_button(tr!("Pen"), |ui| {
        ui.label(tr!("What the pen's pressure drives"));
        let choices = [
            (Pressure::None, tr!("Nothing")),
            (Pressure::Size, tr!("Size")),
            (Pressure::Opacity, tr!("Opacity")),
            (Pressure::Both, tr!("Size and opacity")),
        ];
        for (pressure, label) in choices {
            ui.radio_value(&mut tools.pressure, pressure, label);
        }
    })
    .response
    .on_hover_text(tr!("What the pressure of a tablet's pen drives"));
}

fn symmetry_label(symmetry: &Symmetry) -> &'static str {
    if *symmetry == Symmetry::default() { tr!("Symmetry") } else { tr!("Symmetry: on") }
}

fn symmetry(ui: &mut Ui, symmetry: &mut Symmetry) {
    ui.checkbox(&mut symmetry.across_u, tr!("Mirror left and right"))
        .on_hover_text(tr!("Strokes appear on both sides"));
    ui.checkbox(&mut symmetry.across_v, tr!("Mirror top and bottom"))
        .on_hover_text(tr!("Strokes appear above and below"));
    let mut turns = symmetry.turns.max(1);
    let slider = number_slider(ui, &mut turns, 1..=12).text(tr!("copies around"));
    if ui
        .add(slider)
        .on_hover_text(tr!("Turned copies around the middle, as in a rosette"))
        .changed()
    {
        symmetry.turns = turns;
    }
}

/// Shows a field for a fraction, in percent.
fn part(ui: &mut Ui, label: &str, help: &str, value: &mut f64) {
    let mut percent = *value * 100.0;
    let drag =
        number_field(ui, &mut percent).range(0.0..=100.0).speed(0.5).max_decimals(0).suffix("%");
    if named(ui, label, help, drag) {
        *value = percent / 100.0;
    }
}

fn named(ui: &mut Ui, label: &str, help: &str, drag: NumberField<'_>) -> bool {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let id = ui.label(label).on_hover_text(help).id;
        ui.add(drag).labelled_by(id).on_hover_text(help).changed()
    })
    .inner
}

/// Shows the current color and the other one, and the button that swaps them.
fn colors(ui: &mut Ui, tools: &mut Tools) {
    for (index, name) in [(0, tr!("Color at hand")), (1, tr!("Other color"))] {
        let color = tools.colors[index].map(|channel| f64::from(channel) / 255.0);
        if let Some((_, color)) = color::named_swatch(ui, name, color, ColorSpace::Display, true) {
            tools.colors[index] = color.map(|channel| (channel * 255.0).round() as u8);
        }
    }
    let swap = ui.small_button(tr!("Swap"));
    swap.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Swap colors")));
    if swap.on_hover_text(tr!("Swaps the two colors (X)")).clicked() {
        tools.colors.swap(0, 1);
    }
}

/// Shows a palette of colors: a click takes one, the wheel makes the current color brighter or
/// darker.
fn palette(ui: &mut Ui, tools: &mut Tools) {
    let (rows, columns) = (2, PALETTE.len() / 2);
    let size = vec2(columns as f32 * SWATCH, rows as f32 * SWATCH);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    for (index, color) in PALETTE.iter().enumerate() {
        let (column, row) = ((index / rows) as f32, (index % rows) as f32);
        let at = Rect::from_min_size(rect.min + vec2(column, row) * SWATCH, vec2(SWATCH, SWATCH))
            .shrink(1.0);
        let [r, g, b] = *color;
        let response = ui.interact(at, ui.scope_id().with(("palette", index)), Sense::click());
        let name = tr!("Color #{r:02x}{g:02x}{b:02x}");
        let is_it = tools.colors[0][..3] == *color;
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_it, &name));
        color_picker::show_color_at(ui.painter(), Color32::from_rgb(r, g, b), at);
        let colors = theme::of(ui);
        let edge = if is_it || response.hovered() || response.has_focus() {
            colors.accent
        } else {
            colors.swatch_edge
        };
        ui.painter().rect_stroke(at, 1.0, Stroke::new(1.0, edge), StrokeKind::Inside);
        if response
            .on_hover_text(tr!("{name}. The wheel here makes the color at hand brighter or darker"))
            .clicked()
        {
            tools.colors[0] = [r, g, b, 255];
        }
    }
    if response.contains_pointer() {
        let scroll = ui.input_mut(|input| std::mem::take(&mut input.smooth_scroll_delta.y));
        if scroll != 0.0 {
            tools.change_value(scroll * WHEEL);
        }
    }
}
