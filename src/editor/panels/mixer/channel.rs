//! Channel of a group: its name, its switches, its fader, its exposure and its tint.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    Align2, FontId, Frame, Label, Margin, Rect, RichText, Role, Sense, Stroke, Ui, UiBuilder, Vec2,
    WidgetInfo, pos2, vec2,
};

use crate::commands::{Command, SceneCommand};
use crate::document::{ColorSpace, GroupMaster, MAX_EXPOSURE, SetTerm};
use crate::fields::mix::SceneMix;
use crate::fields::shot;
use crate::ids::LightGroup;
use crate::state::session::Session;
use crate::widgets::color;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::theme;

/// Size of the mark of what a shot changes, in points.
const MARK: Vec2 = vec2(9.0, 18.0);
/// Width of a channel, in points.
const WIDTH: f32 = 92.0;
/// Least height of a fader, in points.
const LEAST: f32 = 44.0;
/// Greatest height of a fader, in points.
const MOST: f32 = 190.0;
/// Height of everything in a channel but the fader, with the bar that scrolls the channels, in
/// points.
const REST: f32 = 118.0;
/// Width of a fader, in points.
const FADER: f32 = 22.0;
/// Intensity at the upper end of a fader; more can be typed.
const TOP: f64 = 4.0;
/// Intensities that have a mark beside the fader.
const MARKS: [f64; 5] = [0.0, 0.25, 1.0, 2.0, 4.0];

/// Place of an intensity on the fader, from 0 to 1: 1 stands in the middle, and dim ones have as
/// much room as bright ones.
fn place_of(intensity: f64) -> f64 {
    (intensity.clamp(0.0, TOP) / TOP).sqrt()
}

/// Intensity at a place of the fader. It snaps to 1, which leaves lights as they are.
fn intensity_at(place: f64) -> f64 {
    let intensity = TOP * place * place;
    if (intensity - 1.0).abs() < 0.03 { 1.0 } else { (intensity * 1e3).round() / 1e3 }
}

/// Height of the faders in a panel with so much room, in points.
pub(super) fn fader_height(room: f32) -> f32 {
    (room - REST).clamp(LEAST, MOST)
}

/// Shows the channel of a group, with a fader of this height.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    mix: SceneMix<'_>,
    (group, fader): (&LightGroup, f32),
    out: &mut Vec<Command>,
) {
    let space = session.look().color_space;
    let master = mix.master(group);
    let name = if master.name.is_empty() { group.as_str() } else { &master.name };
    let term = SetTerm::Group(group.to_string());
    let frame = Frame::new()
        .fill(theme::of(ui).node)
        .corner_radius(5)
        .inner_margin(Margin::symmetric(6, 5));
    frame.show(ui, |ui| {
        ui.set_width(WIDTH - 12.0);
        ui.vertical_centered(|ui| {
            ui.spacing_mut().item_spacing.y = 4.0;
            match session.shot() {
                None => title(ui, mix, name, &term),
                Some(_) => drop(ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = 0.0;
                    let fields = ["intensity", "exposure", "tint"];
                    let targets = fields.map(|field| format!("light_groups.{group}.{field}"));
                    shot::mark(ui, MARK, session, &targets, name, out);
                    title(ui, mix, name, &term);
                })),
            }
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 3.0;
                mix.mute(ui, &tr!("Group {name} shines"), &term, out);
                mix.solo(ui, &tr!("Solo group {name}"), &term, out);
                let mut new = master.clone();
                if let Some(widget) = tint(ui, name, &mut new, space) {
                    set(group, &master, new, widget, out);
                }
            });
            let mut new = master.clone();
            let moved = slide(ui, name, &mut new, fader);
            let typed = numbers(ui, name, &mut new);
            if let Some(widget) = moved.or(typed) {
                set(group, &master, new, widget, out);
            }
        });
    });
}

fn set(
    group: &LightGroup,
    old: &GroupMaster,
    new: GroupMaster,
    widget: egui::Id,
    out: &mut Vec<Command>,
) {
    if new != *old {
        out.push(Command::Scene(SceneCommand::EditHeld(widget, SceneMix::mastering(group, new))));
    }
}

fn title(ui: &mut Ui, mix: SceneMix<'_>, name: &str, term: &SetTerm) {
    let is_out = !mix.shines(term);
    let colors = theme::of(ui);
    let text = RichText::new(name).strong().color(if is_out { colors.dim } else { colors.text });
    let text = if is_out { text.strikethrough() } else { text };
    let lights = mix.lights.of_term(term);
    let names = match lights.is_empty() {
        true => tr!("No light is of this group").to_owned(),
        false => mix.lights.names(&lights),
    };
    ui.add(Label::new(text).truncate()).on_hover_text(names);
}

fn tint(ui: &mut Ui, name: &str, master: &mut GroupMaster, space: ColorSpace) -> Option<egui::Id> {
    ui.spacing_mut().interact_size.x = 22.0;
    let [r, g, b] = master.tint;
    let label = tr!("Tint of group {name}");
    let (id, [r, g, b, _]) = color::named_swatch(ui, &label, [r, g, b, 1.0], space, false)?;
    master.tint = [r, g, b];
    Some(id)
}

/// Shows the fader, with marks beside it. Returns its id where it was moved.
fn slide(ui: &mut Ui, name: &str, master: &mut GroupMaster, height: f32) -> Option<egui::Id> {
    let (room, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let rail = Rect::from_center_size(room.center() + vec2(8.0, 0.0), vec2(FADER, height));
    ui.scope_builder(UiBuilder::new().max_rect(rail), |ui| {
        ui.spacing_mut().slider_width = height;
        let mut place = place_of(master.intensity);
        let slider = number_slider(ui, &mut place, 0.0..=1.0).vertical().show_value(false);
        let response = ui.add(slider);
        let label = tr!("Fader of group {name}");
        response.widget_info(|| WidgetInfo::slider(true, master.intensity, &label));
        marks(ui, response.rect);
        let twice = response.interact(Sense::click()).double_clicked();
        let help = tr!(
            "Intensity of the group: drag, or use the arrow keys. A double click puts it back to 1."
        );
        let id = response.id;
        let is_moved = response.changed();
        response.on_hover_text(help);
        if twice {
            master.intensity = 1.0;
        } else if is_moved {
            master.intensity = intensity_at(place);
        }
        (twice || is_moved).then_some(id)
    })
    .inner
}

/// Paints marks left of the fader.
fn marks(ui: &Ui, rect: Rect) {
    let colors = theme::of(ui);
    // The handle's middle stays within the rail by its own radius.
    let rail = rect.shrink2(vec2(0.0, rect.width() / 2.5));
    // A low fader has room for the ends and the middle.
    let is_low = rect.height() < 60.0;
    for mark in MARKS.into_iter().filter(|mark| !is_low || [0.0, 1.0, TOP].contains(mark)) {
        let y = egui::lerp(rail.bottom()..=rail.top(), place_of(mark) as f32);
        let is_normal = mark == 1.0;
        let ink = if is_normal { colors.text } else { colors.dim.gamma_multiply(0.8) };
        let right = rect.left() - 3.0;
        let line = [pos2(right - 5.0, y), pos2(right, y)];
        ui.painter().line_segment(line, Stroke::new(1.0, ink));
        let font = FontId::proportional(9.0);
        let text = crate::values::number_text(mark, 2);
        ui.painter().text(pos2(right - 8.0, y), Align2::RIGHT_CENTER, text, font, ink);
    }
}

/// Shows the intensity and the exposure as numbers. Returns the id of the widget that changed one.
fn numbers(ui: &mut Ui, name: &str, master: &mut GroupMaster) -> Option<egui::Id> {
    let size = vec2(ui.available_width(), 18.0);
    let intensity = number_field(ui, &mut master.intensity).prefix("×").speed(0.01);
    let response = ui.add_sized(size, intensity.range(0.0..=1e6).max_decimals(3));
    let response = response.on_hover_text(tr!("Intensity: a factor on each light of the group"));
    response.widget_info(|| number(tr!("Intensity of group {name}"), master.intensity));
    let by_intensity = response.changed().then_some(response.id);
    let exposure = number_field(ui, &mut master.exposure).suffix(" EV").speed(0.02);
    let response = ui.add_sized(size, exposure.range(-MAX_EXPOSURE..=MAX_EXPOSURE).max_decimals(2));
    let response = response.on_hover_text(tr!("Exposure in stops: each doubles the intensity"));
    response.widget_info(|| number(tr!("Exposure of group {name}"), master.exposure));
    by_intensity.or(response.changed().then_some(response.id))
}

fn number(label: String, value: f64) -> WidgetInfo {
    let mut info = WidgetInfo::labeled(Role::SpinButton, true, label);
    info.value = Some(value);
    info
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fader_has_one_in_its_middle_and_comes_back_to_where_it_stood() {
        assert_eq!(place_of(1.0), 0.5);
        for intensity in [0.0, 0.01, 0.3, 1.0, 2.5, 4.0] {
            assert!((intensity_at(place_of(intensity)) - intensity).abs() < 1e-3, "{intensity}");
        }
        assert_eq!(place_of(9.0), 1.0);
        assert_eq!(intensity_at(0.503), 1.0, "snaps");
    }
}
