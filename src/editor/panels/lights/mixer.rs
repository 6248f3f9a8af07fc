//! Mixer of a scene in the list of lights: a row for each group, with its master, and what is muted
//! or soloed.

use chiaro_locale::tr;
use eframe::egui::{Align, Id, Label, Layout, RichText, Role, Ui, WidgetInfo};

use crate::commands::{Command, SceneCommand};
use crate::document::{ColorSpace, GroupMaster, MAX_EXPOSURE, SetTerm};
use crate::fields::mix::SceneMix;
use crate::ids::{LightGroup, LightId};
use crate::widgets::color;
use crate::widgets::number::number_field;
use crate::widgets::rows::ICON;
use crate::widgets::theme;

/// Least room of a group's name and numbers that tells its exposure, in points.
const EXPOSED: f32 = 160.0;

/// Shows a row for each group; nothing where there is none.
pub(super) fn show(ui: &mut Ui, mix: SceneMix<'_>, space: ColorSpace, out: &mut Vec<Command>) {
    let groups = mix.lights.groups(Some(mix.scene));
    if groups.is_empty() {
        return;
    }
    ui.add_space(6.0);
    super::section(
        ui,
        tr!("Groups"),
        tr!(
            "Masters: every light of a group is multiplied by them. A light tells its groups below \
             its other fields"
        ),
    );
    for group in &groups {
        ui.push_id(group, |ui| ui.horizontal(|ui| row(ui, mix, group, space, out)));
    }
}

fn row(
    ui: &mut Ui,
    mix: SceneMix<'_>,
    group: &LightGroup,
    space: ColorSpace,
    out: &mut Vec<Command>,
) {
    let master = mix.master(group);
    let name = if master.name.is_empty() { group.as_str() } else { &master.name };
    let term = SetTerm::Group(group.to_string());
    ui.spacing_mut().item_spacing.x = 4.0;
    mix.mute(ui, &tr!("Group {name} shines"), &term, out);
    // The name is at the left and the rest at the right end, as in the rows of lights.
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.add_space(ICON + 4.0);
        mix.solo(ui, &tr!("Solo group {name}"), &term, out);
        let mut new = master.clone();
        let widget = values(ui, name, &mut new, space);
        let is_out = !mix.shines(&term);
        let ink = if is_out { theme::of(ui).dim } else { theme::of(ui).text };
        let text = RichText::new(name).strong().color(ink);
        let text = if is_out { text.strikethrough() } else { text };
        let lights = mix.lights.of_term(&term);
        let names = match lights.is_empty() {
            true => tr!("No light is of this group").to_owned(),
            false => mix.lights.names(&lights),
        };
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.add(Label::new(text).truncate()).on_hover_text(names);
        });
        if let Some(widget) = widget.filter(|_| new != master) {
            let edit = SceneCommand::EditHeld(widget, SceneMix::mastering(group, new));
            out.push(Command::Scene(edit));
        }
    });
}

/// Shows the values of a group's master, from the right to the left. Returns the widget of one that
/// is changed.
fn values(ui: &mut Ui, name: &str, new: &mut GroupMaster, space: ColorSpace) -> Option<Id> {
    ui.spacing_mut().interact_size.x = ICON;
    let mut widget = None;
    let [r, g, b] = new.tint;
    let tint = tr!("Tint of group {name}");
    if let Some((id, [r, g, b, _])) = color::named_swatch(ui, &tint, [r, g, b, 1.0], space, false) {
        new.tint = [r, g, b];
        widget = Some(id);
    }
    // The name comes before the exposure, which the mixer has, too.
    if ui.available_width() > EXPOSED {
        let exposure = number_field(ui, &mut new.exposure).suffix(" EV").speed(0.02);
        let response = ui.add(exposure.range(-MAX_EXPOSURE..=MAX_EXPOSURE).max_decimals(2));
        let response = response.on_hover_text(tr!("Exposure in stops: each doubles the intensity"));
        response.widget_info(|| number(tr!("Exposure of group {name}"), new.exposure));
        widget = widget.or(response.changed().then_some(response.id));
    }
    let intensity = number_field(ui, &mut new.intensity).prefix("×").speed(0.01);
    let response = ui.add(intensity.range(0.0..=1e6).max_decimals(2));
    let response = response.on_hover_text(tr!("Intensity: a factor on each light of the group"));
    response.widget_info(|| number(tr!("Intensity of group {name}"), new.intensity));
    widget.or(response.changed().then_some(response.id))
}

/// Shows the entries of a light's menu that mute and solo it in the scene.
pub(super) fn menu(ui: &mut Ui, mix: SceneMix<'_>, id: &LightId, out: &mut Vec<Command>) {
    let term = SetTerm::Id(id.to_string());
    let entries = [
        (tr!("Mute in the scene"), tr!("Light in the scene"), &mix.scene.muted, mix.muting(&term)),
        (tr!("Solo in the scene"), tr!("End its solo"), &mix.scene.soloed, mix.soloing(&term)),
    ];
    for (begin, end, set, command) in entries {
        let text = if mix.lights.has(set, &term) { end } else { begin };
        if ui.button(text).on_hover_text(tr!("Saved with the scene")).clicked() {
            out.push(command);
        }
    }
}

fn number(label: String, value: f64) -> WidgetInfo {
    let mut info = WidgetInfo::labeled(Role::SpinButton, true, label);
    info.value = Some(value);
    info
}
