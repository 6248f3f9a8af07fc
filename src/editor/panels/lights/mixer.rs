//! Mixer of a scene: a row for each group of lights, with its master, and what is muted or soloed.

use std::collections::BTreeSet;

use eframe::egui::{DragValue, Label, RichText, Role, Ui, WidgetInfo};
use indexmap::IndexMap;

use crate::commands::{Command, SceneCommand};
use crate::document::{
    ColorSpace, GroupMaster, Light, LightOut, LightSet, MAX_EXPOSURE, Scene, SceneEdit, SetTerm,
};
use crate::ids::{LightGroup, LightId};
use crate::state::session::Session;
use crate::widgets::color;
use crate::widgets::rows::{Icon, icon};
use crate::widgets::theme;

/// Lights of an open scene, as its mixer knows them; made anew where the scene or its looks change.
#[derive(Debug, Default)]
pub(super) struct MixedLights {
    /// The scene's lights, then those that its looks have besides.
    lights: IndexMap<LightId, Light>,
    /// Lights that are out by the scene's mutes, solos and masters.
    out: IndexMap<LightId, LightOut>,
}

impl MixedLights {
    /// Lights of a scene and those of its looks.
    pub(super) fn of<'l>(
        scene: &Scene,
        of_looks: impl Iterator<Item = (&'l LightId, &'l Light)>,
    ) -> Self {
        let mut lights = scene.lights.clone();
        for (id, light) in of_looks {
            lights.entry(id.clone()).or_insert_with(|| light.clone());
        }
        let out = scene.lights_out(&lights);
        Self { lights, out }
    }

    /// Reason why a light is out, in words; `None` where it shines.
    pub(super) fn told(&self, id: &LightId) -> Option<String> {
        Some(match self.out.get(id)? {
            LightOut::NotSoloed => "Out in the scene: other lights are soloed".to_owned(),
            LightOut::Muted => "Out in the scene: it is muted".to_owned(),
            LightOut::ByMaster(group) => {
                format!("Out in the scene: the master of its group {group} is 0")
            }
        })
    }
}

/// The mixer of an open scene.
pub(super) struct Mixer<'s> {
    scene: &'s Scene,
    mixed: &'s MixedLights,
    space: ColorSpace,
}

impl<'s> Mixer<'s> {
    /// The mixer of the open scene, if one is open.
    pub(super) fn of(session: &'s Session, mixed: &'s MixedLights) -> Option<Self> {
        let scene = session.open_scene()?.scene();
        Some(Self { scene, mixed, space: session.look().color_space })
    }

    /// Groups that lights are of, or that have a master.
    fn groups(&self) -> Vec<&LightGroup> {
        let of_lights = self.mixed.lights.values().flat_map(|light| &light.groups);
        let all: BTreeSet<&LightGroup> = of_lights.chain(self.scene.light_groups.keys()).collect();
        all.into_iter().collect()
    }

    /// Shows a row for each group; nothing where there is none.
    pub(super) fn show(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let groups = self.groups();
        if groups.is_empty() {
            return;
        }
        ui.add_space(6.0);
        super::section(
            ui,
            "Groups",
            "Masters: every light of a group is multiplied by them. A light tells its groups below \
             its other fields",
        );
        for group in groups {
            ui.push_id(group, |ui| ui.horizontal(|ui| self.row(ui, group, out)));
        }
    }

    fn row(&self, ui: &mut Ui, group: &LightGroup, out: &mut Vec<Command>) {
        let master = self.scene.light_groups.get(group).cloned().unwrap_or_default();
        let name = if master.name.is_empty() { group.as_str() } else { &master.name };
        let term = SetTerm::Group(group.to_string());
        ui.spacing_mut().item_spacing.x = 4.0;
        self.mute(ui, &format!("Group {name} shines"), &term, out);
        self.solo(ui, &format!("Solo group {name}"), &term, out);
        let mut new = master.clone();
        let mut widget = None;
        let intensity = DragValue::new(&mut new.intensity).prefix("×").speed(0.01);
        let response = ui.add(intensity.range(0.0..=1e6).max_decimals(2));
        let response = response.on_hover_text("Intensity: a factor on each light of the group");
        response.widget_info(|| number(format!("Intensity of group {name}"), new.intensity));
        widget = widget.or(response.changed().then_some(response.id));
        let exposure = DragValue::new(&mut new.exposure).suffix(" EV").speed(0.02);
        let response = ui.add(exposure.range(-MAX_EXPOSURE..=MAX_EXPOSURE).max_decimals(2));
        let response = response.on_hover_text("Exposure in stops: each doubles the intensity");
        response.widget_info(|| number(format!("Exposure of group {name}"), new.exposure));
        widget = widget.or(response.changed().then_some(response.id));
        let [r, g, b] = new.tint;
        let tint = format!("Tint of group {name}");
        if let Some((id, [r, g, b, _])) =
            color::named_swatch(ui, &tint, [r, g, b, 1.0], self.space, false)
        {
            new.tint = [r, g, b];
            widget = widget.or(Some(id));
        }
        let is_out = !self.shines(&term);
        let ink = if is_out { theme::of(ui).dim } else { theme::of(ui).text };
        let text = RichText::new(name).strong().color(ink);
        let text = if is_out { text.strikethrough() } else { text };
        let lights = self.lights_of(&term);
        ui.add(Label::new(text).truncate()).on_hover_text(self.told(&lights));
        if let Some(widget) = widget.filter(|_| new != master) {
            let edit = SceneEdit::SetMaster {
                group: group.clone(),
                master: (new != GroupMaster::default()).then_some(new),
                index: None,
            };
            out.push(Command::Scene(SceneCommand::EditHeld(widget, edit)));
        }
    }

    /// Shows the button that mutes the lights of a term in the scene.
    fn mute(&self, ui: &mut Ui, label: &str, term: &SetTerm, out: &mut Vec<Command>) {
        let is_muted = self.has(&self.scene.muted, term);
        let help = "Puts its lights out in the scene, or lights them again";
        if icon(ui, Icon::Bulb, !is_muted, label, help).clicked() {
            out.push(self.muting(term));
        }
    }

    fn solo(&self, ui: &mut Ui, label: &str, term: &SetTerm, out: &mut Vec<Command>) {
        let is_alone = self.has(&self.scene.soloed, term);
        let help = "Lets its lights shine alone in the scene, muted or not.\nThis is saved: \
                    rendering tells of it.";
        if icon(ui, Icon::Solo, is_alone, label, help).clicked() {
            out.push(self.soloing(term));
        }
    }

    /// The edit that mutes the lights of a term, or that lights them again.
    fn muting(&self, term: &SetTerm) -> Command {
        let muted = self.toggled(&self.scene.muted, term);
        Command::Scene(SceneCommand::Edit(SceneEdit::SetMutedLights { muted }))
    }

    /// The edit that solos the lights of a term, or takes them back.
    fn soloing(&self, term: &SetTerm) -> Command {
        let soloed = self.toggled(&self.scene.soloed, term);
        Command::Scene(SceneCommand::Edit(SceneEdit::SetSoloedLights { soloed }))
    }

    /// Shows the entries of a light's menu that mute and solo it in the scene.
    pub(super) fn menu(&self, ui: &mut Ui, id: &LightId, out: &mut Vec<Command>) {
        let term = SetTerm::Id(id.to_string());
        let entries = [
            ("Mute in the scene", "Light in the scene", &self.scene.muted, self.muting(&term)),
            ("Solo in the scene", "End its solo", &self.scene.soloed, self.soloing(&term)),
        ];
        for (begin, end, set, command) in entries {
            let text = if self.has(set, &term) { end } else { begin };
            if ui.button(text).on_hover_text("Saved with the scene").clicked() {
                out.push(command);
            }
        }
    }

    fn lights_of(&self, term: &SetTerm) -> BTreeSet<LightId> {
        LightSet::none().with(term).of(&self.mixed.lights, &BTreeSet::new())
    }

    /// True if all lights of a term are of a set.
    fn has(&self, set: &LightSet, term: &SetTerm) -> bool {
        let lights = self.lights_of(term);
        !lights.is_empty() && lights.is_subset(&set.of(&self.mixed.lights, &BTreeSet::new()))
    }

    fn toggled(&self, set: &LightSet, term: &SetTerm) -> LightSet {
        if self.has(set, term) { set.without(term, &self.mixed.lights) } else { set.with(term) }
    }

    /// True if any light of a term shines.
    fn shines(&self, term: &SetTerm) -> bool {
        self.lights_of(term).iter().any(|id| !self.mixed.out.contains_key(id))
    }

    fn told(&self, lights: &BTreeSet<LightId>) -> String {
        let names = lights.iter().map(|id| self.mixed.lights[id].display_name(id));
        let names: Vec<&str> = names.collect();
        if names.is_empty() { "No light is of this group".to_owned() } else { names.join(", ") }
    }
}

fn number(label: String, value: f64) -> WidgetInfo {
    let mut info = WidgetInfo::labeled(Role::SpinButton, true, label);
    info.value = Some(value);
    info
}
