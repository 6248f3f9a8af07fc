//! Menus that add lights: to the look, and to the scene around it, in place of lights that its
//! looks have.

use eframe::egui::Ui;
use indexmap::IndexMap;

use crate::commands::{Command, PanelId};
use crate::document::{Light, LightKind};
use crate::fields::lighting::{Change, OwnedLight, Owner, SharedLight};
use crate::ids::LightId;
use crate::state::reading::{light_name, spoken};
use crate::state::session::Session;
use crate::widgets::text::hint;

/// Shows the menus above the list.
pub(super) fn bar(
    ui: &mut Ui,
    session: &Session,
    shared: &IndexMap<LightId, SharedLight>,
    out: &mut Vec<Command>,
) {
    ui.horizontal(|ui| menus(ui, session, shared, out));
    ui.add_space(2.0);
}

/// Shows the two menus.
pub(in crate::panels) fn menus(
    ui: &mut Ui,
    session: &Session,
    shared: &IndexMap<LightId, SharedLight>,
    out: &mut Vec<Command>,
) {
    let menu = ui.menu_button("Add light", |ui| {
        for &kind in LightKind::ALL {
            let button = ui.button(spoken(kind.word()));
            if button.on_hover_text(spoken(kind.help())).clicked() {
                let near = Light {
                    position: [1.5, 1.5, 2.0],
                    aim: [-0.5, -0.5, -0.7],
                    ..Light::default()
                };
                let light = Light { kind, direction: [0.5, 0.5, 0.7], ..near };
                let id = Owner::Look.free_id(session, "light");
                out.push(Owner::Look.add(id, light, None).once());
                ui.close();
            }
        }
    });
    menu.response.on_hover_text("Adds a light that layers can name");
    if session.open_scene().is_none() {
        return;
    }
    let menu = ui.menu_button("Add scene light", |ui| {
        let mut has_any = false;
        for (id, shared) in free(session, shared) {
            has_any = true;
            let name = light_name(id, &shared.light);
            let button =
                ui.button(format!("In place of {name}")).on_hover_text(help_for(id, shared));
            if button.clicked() {
                out.push(Owner::Scene.add(id.clone(), shared.light.clone(), None).once());
                ui.close();
            }
        }
        if !has_any {
            hint(ui, "Every light of the scene's looks has one in its place already.");
        }
    });
    menu.response
        .on_hover_text("Adds a light of the scene, which stands in place of one that looks have");
}

/// Shows the buttons that lead to the other panels about lights.
pub(in crate::panels) fn panels(ui: &mut Ui, out: &mut Vec<Command>) {
    let all = [
        (PanelId::LIGHT_TABLE, "Light table", "All lights and groups, field by field"),
        (PanelId::MIXER, "Mixer", "The groups' masters, as faders"),
        (PanelId::LINKS, "Links", "Which lights light which objects, and why"),
    ];
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (panel, label, help) in all {
            if ui.small_button(label).on_hover_text(help).clicked() {
                out.push(Command::ShowPanel(panel));
            }
        }
    });
    ui.add_space(2.0);
}

/// Shows the entries of a light's menu that apply in a scene.
pub(super) fn scene_menu(
    ui: &mut Ui,
    session: &Session,
    owned_light: &OwnedLight<'_>,
    shared: &IndexMap<LightId, SharedLight>,
    out: &mut Vec<Command>,
) {
    if session.open_scene().is_none() {
        return;
    }
    if owned_light.owner == Owner::Look {
        let help =
            "Adds the same to the scene, where it stands in place of every look's light of this id";
        if session.keys().light_of_scene(owned_light.id).is_none()
            && ui.button("Light the scene with it").on_hover_text(help).clicked()
        {
            out.push(
                Owner::Scene.add(owned_light.id.clone(), owned_light.as_set(session), None).once(),
            );
        }
        return;
    }
    for (id, shared) in free(session, shared) {
        let text = format!("Stand in for {}", light_name(id, &shared.light));
        if ui.button(text).on_hover_text(help_for(id, shared)).clicked() {
            out.extend(owned_light.stand_in_for(session, id).map(Change::once));
        }
    }
}

/// Lights of looks that no light of the scene stands in for.
fn free<'s>(
    session: &'s Session,
    shared: &'s IndexMap<LightId, SharedLight>,
) -> impl Iterator<Item = (&'s LightId, &'s SharedLight)> {
    shared.iter().filter(|(id, _)| session.keys().light_of_scene(id).is_none())
}

fn help_for(id: &LightId, shared: &SharedLight) -> String {
    match shared.looks {
        1 => format!("One look has the light {id}"),
        looks => format!("{looks} looks have the light {id}: all are lit by this one then"),
    }
}
