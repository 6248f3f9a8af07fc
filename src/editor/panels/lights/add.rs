//! Menus that add lights: to the look, and to the scene around it, new ones or in place of lights
//! that its looks have.

use chiaro_locale::{tr, tr_in, trn};
use eframe::egui::Ui;
use glam::DVec3;
use indexmap::IndexMap;

use super::edit::kind_name;
use crate::commands::{Command, PanelId};
use crate::document::{Light, LightKind, LightSpace};
use crate::fields::lighting::{Change, OwnedLight, Owner, SharedLight, lights_of_looks};
use crate::ids::{LightId, make_slug};
use crate::state::reading::{light_name, spoken};
use crate::state::scene::sphere_of_lights;
use crate::state::session::Session;
use crate::widgets::spots::{self, Spot};
use crate::widgets::text::hint;

/// Shows the menus above the list.
pub(super) fn bar(
    ui: &mut Ui,
    session: &Session,
    shared: &IndexMap<LightId, SharedLight>,
    out: &mut Vec<Command>,
) {
    ui.horizontal_wrapped(|ui| menus(ui, session, shared, out));
    ui.add_space(2.0);
}

/// Shows the two menus.
pub(in crate::panels) fn menus(
    ui: &mut Ui,
    session: &Session,
    shared: &IndexMap<LightId, SharedLight>,
    out: &mut Vec<Command>,
) {
    let menu = ui.menu_button(tr!("Add light"), |ui| kinds(ui, session, Owner::Look, out));
    menu.response.on_hover_text(tr!("Adds a light that layers can name"));
    if session.open_scene().is_none() {
        return;
    }
    let menu = ui.menu_button(tr!("Add scene light"), |ui| {
        kinds(ui, session, Owner::Scene, out);
        ui.separator();
        let mut has_any = false;
        for (id, shared) in free(session, shared) {
            has_any = true;
            let name = light_name(id, &shared.light);
            let button = ui.button(tr!("In place of {name}")).on_hover_text(help_for(id, shared));
            if button.clicked() {
                out.push(Owner::Scene.add(id.clone(), shared.light.clone(), None).once());
                ui.close();
            }
        }
        if !has_any {
            hint(ui, tr!("Every light of the scene's looks has one in its place already."));
        }
    });
    spots::note(ui, Spot::AddSceneLight, menu.response.rect);
    menu.response.on_hover_text(tr!(
        "Adds a light of the scene: a new one for groups that run for each light, or one in place \
         of a light that looks have"
    ));
}

/// Shows an entry for each kind of light, which adds a new one to a document and chooses it.
fn kinds(ui: &mut Ui, session: &Session, owner: Owner, out: &mut Vec<Command>) {
    for &kind in LightKind::ALL {
        let help = spoken(tr_in("choice", kind.help()));
        let button = ui.button(kind_name(kind));
        let button = match owner {
            Owner::Look => button.on_hover_text(help),
            Owner::Scene => {
                let of_scene = tr!("A new light, which every group draws that runs for each light");
                button.on_hover_text(format!("{help}.\n{of_scene}"))
            }
        };
        if button.clicked() {
            let (id, light) = new_light(session, owner, kind);
            out.push(owner.add(id.clone(), light, None).once());
            out.push(Command::ChooseLight(id));
            ui.close();
        }
    }
}

/// A new light, in front of what it is to light, at its upper right.
fn new_light(session: &Session, owner: Owner, kind: LightKind) -> (LightId, Light) {
    const TOWARD: DVec3 = DVec3::new(0.5, 0.5, 0.7);
    let near = Light {
        kind,
        direction: TOWARD.to_array(),
        position: [1.5, 1.5, 2.0],
        aim: [-0.5, -0.5, -0.7],
        ..Light::default()
    };
    if owner == Owner::Look {
        return (owner.free_id(session, "light"), near);
    }
    // In the scene it stands where the camera sees it, whichever object is selected.
    let (center, radius) = sphere_of_lights(session.open_scene());
    let orbit = &session.view.orbit;
    let (right, up) = orbit.right_and_up();
    let toward = right * TOWARD.x + up * TOWARD.y + orbit.direction() * TOWARD.z;
    let short = |v: DVec3| v.to_array().map(|x| (x * 1e3).round() / 1e3 + 0.0);
    let light = Light {
        space: LightSpace::World,
        direction: short(toward),
        position: short(center + toward.normalize() * 1.6 * radius),
        aim: short(-toward),
        ..near
    };
    // An id that no look has: it would stand in place of that light otherwise.
    let is_taken = |slug: &str| {
        let id = LightId::new(slug);
        let has = |lights: &IndexMap<LightId, Light>| lights.contains_key(&id);
        owner.lights(session).is_some_and(has) || lights_of_looks(session).contains_key(&id)
    };
    (LightId::new(make_slug("light", is_taken)), light)
}

/// Shows the buttons that lead to the other panels about lights.
pub(in crate::panels) fn panels(ui: &mut Ui, out: &mut Vec<Command>) {
    let all = [
        (PanelId::LIGHT_TABLE, tr!("Light table"), tr!("All lights and groups, field by field")),
        (PanelId::MIXER, tr!("Mixer"), tr!("The groups' masters, as faders")),
        (PanelId::LINKS, tr!("Links"), tr!("Which lights light which objects, and why")),
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
        let help = tr!(
            "Adds the same to the scene, where it stands in place of every look's light of this id"
        );
        if session.keys().light_of_scene(owned_light.id).is_none()
            && ui.button(tr!("Light the scene with it")).on_hover_text(help).clicked()
        {
            out.push(
                Owner::Scene.add(owned_light.id.clone(), owned_light.as_set(session), None).once(),
            );
        }
        return;
    }
    for (id, shared) in free(session, shared) {
        let text = tr!("Stand in for {light}", light = light_name(id, &shared.light));
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
    trn!(
        looks = shared.looks,
        "One look has the light {id}",
        "{looks} looks have the light {id}: all are lit by this one then"
    )
}
