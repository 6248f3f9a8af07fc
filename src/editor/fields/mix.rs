//! Mix of an open scene's lights, as panels show and change it: groups with their masters, mutes
//! and solos. The rules themselves are the document's (`Scene::lights_out`).

use std::collections::BTreeSet;

use chiaro_locale::{tr, trn};
use eframe::egui::{Label, RichText, Ui};
use indexmap::IndexMap;

use super::lighting::{SharedLight, lights_of_looks};
use crate::commands::{Command, SceneCommand};
use crate::document::{GroupMaster, Light, LightOut, LightSet, Scene, SceneEdit, SetTerm};
use crate::ids::{LightGroup, LightId};
use crate::state::revision::{DocumentNumber, LookRevision, PictureRevision};
use crate::state::session::Session;
use crate::widgets::rows::{Icon, icon};
use crate::widgets::theme;

/// Lights of the window, and which of them are out in the scene; made anew where the look, the
/// scene or its other looks change.
#[derive(Default)]
pub(crate) struct MixedLights {
    /// The scene's lights, then those that its looks have besides.
    lights: IndexMap<LightId, Light>,
    /// Lights that are out by the scene's mutes, solos and masters.
    out: IndexMap<LightId, LightOut>,
    /// Lights of looks that lights of the scene can stand in for; empty without a scene.
    shared: IndexMap<LightId, SharedLight>,
    of: Option<(DocumentNumber, LookRevision, Option<PictureRevision>)>,
}

impl MixedLights {
    /// Finds out the lights of the session, where they changed. Returns true if they did.
    pub(crate) fn sync(&mut self, session: &Session) -> bool {
        let of = (session.revisions().document, session.revision(), session.scene_revision());
        if self.of == Some(of) {
            return false;
        }
        self.of = Some(of);
        match session.open_scene() {
            None => {
                self.shared.clear();
                self.lights.clone_from(&session.look().lights);
                self.out.clear();
            }
            Some(open_scene) => {
                self.shared = lights_of_looks(session);
                self.lights = open_scene.scene().lights.clone();
                for (id, shared) in &self.shared {
                    self.lights.entry(id.clone()).or_insert_with(|| shared.light.clone());
                }
                self.out = open_scene.scene().lights_out(&self.lights);
            }
        }
        true
    }

    /// The scene's lights, then those that its looks have besides; those of the look without a
    /// scene.
    pub(crate) fn lights(&self) -> &IndexMap<LightId, Light> {
        &self.lights
    }

    /// Lights of looks that lights of the scene can stand in for; empty without a scene.
    pub(crate) fn shared(&self) -> &IndexMap<LightId, SharedLight> {
        &self.shared
    }

    /// True if a light is out in the scene.
    pub(crate) fn is_out(&self, id: &LightId) -> bool {
        self.out.contains_key(id)
    }

    /// Reason why a light is out, in words; `None` where it shines.
    pub(crate) fn told(&self, id: &LightId) -> Option<String> {
        Some(match self.out.get(id)? {
            LightOut::NotSoloed => tr!("Out in the scene: other lights are soloed").to_owned(),
            LightOut::Muted => tr!("Out in the scene: it is muted").to_owned(),
            LightOut::ByMaster(group) => {
                tr!("Out in the scene: the master of its group {group} is 0")
            }
        })
    }

    /// Lights of a term.
    pub(crate) fn of_term(&self, term: &SetTerm) -> BTreeSet<LightId> {
        self.members(&LightSet::none().with(term))
    }

    /// Lights of a set.
    pub(crate) fn members(&self, set: &LightSet) -> BTreeSet<LightId> {
        set.of(&self.lights, &BTreeSet::new())
    }

    /// True if all lights of a term are of a set.
    pub(crate) fn has(&self, set: &LightSet, term: &SetTerm) -> bool {
        let lights = self.of_term(term);
        !lights.is_empty() && lights.is_subset(&self.members(set))
    }

    /// The set with the lights of a term, or without them.
    pub(crate) fn switched(&self, set: &LightSet, term: &SetTerm, is_in: bool) -> LightSet {
        match (is_in, self.has(set, term)) {
            (true, false) => set.with(term),
            (false, _) => set.without(term, &self.lights),
            (true, true) => set.clone(),
        }
    }

    /// Groups that lights are of, or that have a master, in the order of their words.
    pub(crate) fn groups(&self, scene: Option<&Scene>) -> Vec<LightGroup> {
        let of_lights = self.lights.values().flat_map(|light| &light.groups);
        let masters = scene.into_iter().flat_map(|scene| scene.light_groups.keys());
        let all: BTreeSet<&LightGroup> = of_lights.chain(masters).collect();
        all.into_iter().cloned().collect()
    }

    /// Display names of lights, in a line.
    pub(crate) fn names(&self, lights: &BTreeSet<LightId>) -> String {
        let names: Vec<&str> = lights.iter().map(|id| self.name(id)).collect();
        names.join(", ")
    }

    /// Display name of a light.
    pub(crate) fn name<'l>(&'l self, id: &'l LightId) -> &'l str {
        self.lights.get(id).map_or(id.as_str(), |light| light.display_name(id))
    }
}

/// Mix of the open scene, with the edits that change it.
#[derive(Clone, Copy)]
pub(crate) struct SceneMix<'s> {
    pub(crate) scene: &'s Scene,
    pub(crate) lights: &'s MixedLights,
}

impl<'s> SceneMix<'s> {
    /// The mix of the open scene, if one is open.
    pub(crate) fn of(session: &'s Session, lights: &'s MixedLights) -> Option<Self> {
        Some(Self { scene: session.open_scene()?.scene(), lights })
    }

    /// Master of a group; one that does nothing where the scene has none.
    pub(crate) fn master(self, group: &LightGroup) -> GroupMaster {
        self.scene.light_groups.get(group).cloned().unwrap_or_default()
    }

    /// True if any light of a term shines.
    pub(crate) fn shines(self, term: &SetTerm) -> bool {
        self.lights.of_term(term).iter().any(|id| !self.lights.is_out(id))
    }

    /// Shows the button that mutes the lights of a term in the scene.
    pub(crate) fn mute(self, ui: &mut Ui, label: &str, term: &SetTerm, out: &mut Vec<Command>) {
        let is_muted = self.lights.has(&self.scene.muted, term);
        let help =
            tr!("Puts its lights out in the scene, or lights them again.\nA solo beats a mute.");
        if icon(ui, Icon::Bulb, !is_muted, label, help).clicked() {
            out.push(self.muting(term));
        }
    }

    /// Shows the button that solos the lights of a term in the scene.
    pub(crate) fn solo(self, ui: &mut Ui, label: &str, term: &SetTerm, out: &mut Vec<Command>) {
        let is_alone = self.lights.has(&self.scene.soloed, term);
        let help = tr!(
            "Lets its lights shine alone in the scene, muted or not.\nThis is saved: rendering \
             tells of it."
        );
        if icon(ui, Icon::Solo, is_alone, label, help).clicked() {
            out.push(self.soloing(term));
        }
    }

    /// The edit that mutes the lights of a term, or that lights them again.
    pub(crate) fn muting(self, term: &SetTerm) -> Command {
        let set = &self.scene.muted;
        let muted = self.lights.switched(set, term, !self.lights.has(set, term));
        Command::Scene(SceneCommand::Edit(SceneEdit::SetMutedLights { muted }))
    }

    /// The edit that solos the lights of a term, or takes them back.
    pub(crate) fn soloing(self, term: &SetTerm) -> Command {
        let set = &self.scene.soloed;
        let soloed = self.lights.switched(set, term, !self.lights.has(set, term));
        Command::Scene(SceneCommand::Edit(SceneEdit::SetSoloedLights { soloed }))
    }

    /// The edit that sets the master of a group; one that does nothing is not kept.
    pub(crate) fn mastering(group: &LightGroup, master: GroupMaster) -> SceneEdit {
        let master = (master != GroupMaster::default()).then_some(master);
        SceneEdit::SetMaster { group: group.clone(), master, index: None }
    }

    /// Says that a solo was left on, with the button that ends it; nothing where none was.
    pub(crate) fn solo_note(self, ui: &mut Ui, out: &mut Vec<Command>) {
        let soloed = &self.scene.soloed;
        if soloed.is_none() {
            return;
        }
        let alone = self.lights.members(soloed);
        let text = match alone.len() {
            0 => tr!("Solo: {set} names no light, so that all shine", set = soloed.text()),
            count => trn!(
                count,
                "Solo: {lights} shines alone in the scene",
                "Solo: {lights} shine alone in the scene",
                lights = self.lights.names(&alone)
            ),
        };
        ui.horizontal(|ui| {
            let help = tr!("Lets all lights shine again that are not muted");
            if ui.button(tr!("End solo")).on_hover_text(help).clicked() {
                let soloed = LightSet::none();
                let edit = SceneEdit::SetSoloedLights { soloed };
                out.push(Command::Scene(SceneCommand::Edit(edit)));
            }
            let text = RichText::new(text).color(theme::of(ui).warning);
            ui.add(Label::new(text).truncate()).on_hover_text(tr!(
                "Saved with the scene: rendering warns of it, and with --strict refuses"
            ));
        });
        ui.add_space(2.0);
    }
}
