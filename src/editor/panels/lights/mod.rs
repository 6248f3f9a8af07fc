//! Lights of the look, and those of the scene around it: which of them shine, soloed or muted, and
//! the fields of each.

pub(super) mod add;
mod edit;
mod mixer;

use std::collections::{BTreeSet, HashMap};

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{
    Align, Button, Id, Label, Layout, Popup, Rect, RichText, Role, ScrollArea, Sense, Ui,
    WidgetInfo, vec2,
};

use crate::commands::{Command, LibraryCommand, PanelId};
use crate::document::{Light, Value};
use crate::fields::keyed;
use crate::fields::layer;
use crate::fields::lighting::{OwnedKeys, OwnedLight, Owner};
use crate::fields::mark;
use crate::fields::mix::{MixedLights, SceneMix};
use crate::fields::shot::ChangedRow;
use crate::ids::LightId;
use crate::library::Type;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::parts::saving::PartChoice;
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;
use crate::values;
use crate::viewport::solo_bar;
use crate::widgets::color;
use crate::widgets::number::number_field;
use crate::widgets::rows::{ICON, Icon, NameEdit, icon};
use crate::widgets::text::hint;
use crate::widgets::theme;
pub(crate) use edit::{edit, groups_text, keep_within, kind_name, read_groups, space_name, swatch};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::LIGHTS,
    text!("Lights"),
    text!("The lights that layers name: which shine, from where, how bright"),
    PanelPlace::WITH_DOCUMENT,
    |bench, ui, context| bench.memory.of::<Lights>().show(ui, context.session),
);

/// Width of the text on the users of a light, in points.
const USERS: f32 = 50.0;

/// Least room of a row's name and numbers that tells the users of a light, in points.
const ROOMY: f32 = 150.0;
/// Least room of a row's name and numbers that tells the intensity of a light, in points.
const TELLING: f32 = 100.0;

/// Side of a light's swatch, in points.
const SWATCH: f32 = 16.0;

/// The panel and its state.
#[derive(Default)]
pub(crate) struct Lights {
    renaming: Option<NameEdit<(Owner, LightId)>>,
    /// Number of the look's nodes that name each light.
    users: HashMap<LightId, usize>,
    /// Number of the scene's looks that have groups which run for each light, by light.
    drawn: HashMap<LightId, usize>,
    mixed: MixedLights,
    /// Document that a name is being changed in.
    document: Option<DocumentNumber>,
}

impl Lights {
    /// Lists the lights.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        self.sync(session);
        let mut out = Vec::new();
        add::bar(ui, session, self.mixed.shared(), &mut out);
        add::panels(ui, &mut out);
        // Notes stand below: what is clicked must not move when one comes or goes.
        ui.with_layout(Layout::bottom_up(Align::LEFT), |ui| {
            if !session.view.solo.lights.is_empty() || !session.view.solo.muted.is_empty() {
                out.extend(solo_bar::show(ui, session));
            }
            if let Some(mix) = self.mix(session) {
                mix.solo_note(ui, &mut out);
            }
            let layout = Layout::top_down(Align::LEFT);
            ui.with_layout(layout, |ui| self.all(ui, session, &mut out));
        });
        out
    }

    /// Lists the lights of the scene and of the look, and the groups.
    fn all(&mut self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        let of_scene = Owner::Scene.lights(session).filter(|lights| !lights.is_empty());
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            // The margin is room for the scroll bar.
            ui.set_max_width(ui.available_width() - 8.0);
            if of_scene.is_some() {
                let help =
                    tr!("Each stands in place of the light of its id in every look of the scene");
                section(ui, tr!("Of the scene"), help);
                self.list(ui, session, Owner::Scene, out);
                ui.add_space(6.0);
                section(ui, tr!("Of the look"), tr!("What it has for itself, wherever it is worn"));
            }
            if session.look().lights.is_empty() {
                hint(ui, tr!("The look has no lights. Layers need one each."));
            }
            self.list(ui, session, Owner::Look, out);
            if let Some(mix) = self.mix(session) {
                mixer::show(ui, mix, session.look().color_space, out);
            }
        });
    }

    /// The mix of the open scene.
    fn mix<'s>(&'s self, session: &'s Session) -> Option<SceneMix<'s>> {
        SceneMix::of(session, &self.mixed)
    }

    fn list(&mut self, ui: &mut Ui, session: &Session, owner: Owner, out: &mut Vec<Command>) {
        let lights = owner.lights(session);
        let is_short = lights.is_some_and(|lights| lights.len() == 1)
            && Owner::Scene.lights(session).is_none();
        for (id, light) in lights.into_iter().flatten() {
            let owned_light = OwnedLight { owner, id, light };
            let state = Id::unique("light").with((owner, id.as_str()));
            let state = CollapsingState::load_with_default_open(ui.ctx(), state, is_short);
            let is_open = state.is_open();
            let header = state.show_header(ui, |ui| self.head(ui, session, &owned_light, out));
            header.body_unindented(|ui| {
                ui.add_space(2.0);
                edit(ui, session, &owned_light, out);
                ui.add_space(6.0);
            });
            // The row's own number tells what the fields would tell below theirs.
            if !is_open {
                held_intensity(ui, session, &owned_light);
            }
        }
    }

    fn sync(&mut self, session: &Session) {
        let document = Some(session.revisions().document);
        if self.document != document {
            self.renaming = None;
        }
        self.document = document;
        if !self.mixed.sync(session) {
            return;
        }
        self.users.clear();
        self.drawn.clear();
        self.count_looks_of_sets(session);
        let look = session.look();
        let groups = look.definitions.values().map(|definition| &definition.graph);
        for node in
            std::iter::once(&look.graph).chain(groups).flat_map(|graph| graph.nodes.values())
        {
            let Some(kind) = session.project.catalog.of(node) else { continue };
            for port in kind.inputs.iter().filter(|port| port.ty == Type::LightName) {
                let named = match values::current(port, node.values.get(&port.name)) {
                    Some(Value::Text(id)) if !id.is_empty() => {
                        look.lights.get_key_value(id.as_str())
                    }
                    _ => look.lights.first(),
                };
                if let Some((id, _)) = named {
                    *self.users.entry(id.clone()).or_default() += 1;
                }
            }
        }
    }

    /// Counts the looks of the scene that run for each light of sets.
    fn count_looks_of_sets(&mut self, session: &Session) {
        let Some(open_scene) = session.open_scene() else { return };
        let others = open_scene.snapshot().other_looks().map(|other| &other.look);
        for look in std::iter::once(session.look()).chain(others) {
            let groups = look.definitions.values().map(|definition| &definition.graph);
            let graphs = std::iter::once(&look.graph).chain(groups);
            let sets =
                graphs.flat_map(|graph| graph.nodes.values()).filter_map(|n| n.for_each.as_ref());
            let lights: BTreeSet<LightId> = sets.flat_map(|set| self.mixed.members(set)).collect();
            for id in lights {
                *self.drawn.entry(id).or_default() += 1;
            }
        }
    }

    fn head(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        owned_light: &OwnedLight<'_>,
        out: &mut Vec<Command>,
    ) {
        let title = owned_light.full_name();
        let solo = &session.view.solo;
        ui.spacing_mut().item_spacing.x = 4.0;
        let is_muted = solo.muted.contains(owned_light.id);
        let help = tr!(
            "Puts the light out, or lights it again.\nOnly in this window: nothing of it is saved."
        );
        if icon(ui, Icon::Bulb, !is_muted, &tr!("Light {title} shines"), help).clicked() {
            out.push(Command::Solo(solo.toggle_mute(owned_light.id)));
        }
        let rect = tint(ui, session, owned_light, out);
        let changed = ChangedRow::of_light(session, owned_light.owner, owned_light.id);
        changed.bar(ui, rect.translate(vec2(-4.0, 0.0)));
        let keys = owned_light.owner.keys(session);
        let keyed = keys.and_then(|keys| mark::keyed_fields(keys, owned_light.id));
        if let Some(fields) = &keyed {
            let at = rect.right_bottom() - vec2(1.0, 1.0);
            mark::diamond(ui, at, 4.5, theme::of(ui).accent, theme::of(ui).panel);
            let diamond = Rect::from_center_size(at, vec2(9.0, 9.0)).intersect(rect);
            let mark = ui.interact(diamond, ui.scope_id().with(("keyed", &title)), Sense::hover());
            mark.widget_info(|| WidgetInfo::labeled(Role::Label, true, tr!("{title} is keyed")));
            mark.on_hover_text(tr!("Keyed: {fields}"));
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let more = icon(
                ui,
                Icon::More,
                true,
                &tr!("More of {title}"),
                tr!("Rename, duplicate, remove"),
            );
            Popup::menu(&more).show(|ui| self.menu(ui, session, owned_light, out));
            let is_alone = solo.lights.contains(owned_light.id);
            let help = tr!(
                "Lets this light shine alone; Ctrl-click adds to others.\nOnly in this window: \
                 nothing of it is saved."
            );
            if icon(ui, Icon::Solo, is_alone, &tr!("Solo {title}"), help).clicked() {
                let adds = ui.input(|input| input.modifiers.command || input.modifiers.shift);
                out.push(Command::Solo(solo.toggle_light(owned_light.id, adds)));
            }
            let is_replaced = owned_light.owner == Owner::Look
                && session.keys().light_of_scene(owned_light.id).is_some();
            // In a narrow panel the name comes first; the intensity is among the light's fields,
            // too.
            if ui.available_width() > ROOMY {
                self.users(ui, owned_light, is_replaced);
            }
            if ui.available_width() > TELLING {
                intensity(ui, session, owned_light, out);
            }
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.set_min_height(ICON);
                let here =
                    solo.is_dark(owned_light.id).then(|| tr!("Out in this window").to_owned());
                let why_dark = here.or_else(|| self.mixed.told(owned_light.id));
                let is_at_hand = layer::light_at_hand(session).as_ref() == Some(owned_light.id);
                self.title(ui, owned_light, (why_dark, is_replaced, is_at_hand), &changed, out);
            });
        });
    }

    /// Shows the number of users of a light: nodes for a look's light, looks for a scene's.
    fn users(&self, ui: &mut Ui, owned_light: &OwnedLight<'_>, is_replaced: bool) {
        let colors = theme::of(ui);
        let (count, counted, none, help) = match owned_light.owner {
            Owner::Look => {
                let count = self.users.get(owned_light.id).copied().unwrap_or(0);
                let nodes = trn!(count, "{count} node", "{count} nodes");
                (
                    count,
                    nodes,
                    tr!("No node names this light, so it lights nothing"),
                    tr!("So many nodes name it"),
                )
            }
            Owner::Scene => {
                let count =
                    self.mixed.shared().get(owned_light.id).map_or(0, |shared| shared.looks);
                let none =
                    tr!("No look of the scene has a light of this id, or runs for each light, so \
                         it lights nothing: let it stand in for one");
                let drawn = self.drawn.get(owned_light.id).copied().unwrap_or(0);
                let help = match count {
                    0 => tr!("So many looks run for each light, and for this one among them"),
                    _ => tr!("So many looks have a light of this id, in whose place it stands"),
                };
                let count = if count == 0 { drawn } else { count };
                (count, trn!(count, "{count} look", "{count} looks"), none, help)
            }
        };
        let (text, color, help) = match count {
            _ if is_replaced => (
                tr!("scene's").to_owned(),
                colors.dim,
                tr!("In this scene the scene's light of this id stands in its place"),
            ),
            0 => (tr!("light" => "unused").to_owned(), colors.warning, none),
            _ => (counted, colors.dim, help),
        };
        let size = vec2(USERS, ui.available_height());
        // The width does not depend on the number, so that the widgets beside it form a column.
        ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
            ui.set_min_width(USERS);
            ui.label(RichText::new(text).small().color(color)).on_hover_text(help);
        });
    }

    fn title(
        &mut self,
        ui: &mut Ui,
        owned_light: &OwnedLight<'_>,
        (why_dark, is_replaced, is_at_hand): (Option<String>, bool, bool),
        changed: &ChangedRow<'_>,
        out: &mut Vec<Command>,
    ) {
        if let Some(field) = self
            .renaming
            .as_mut()
            .filter(|field| (field.id.0, &field.id.1) == (owned_light.owner, owned_light.id))
        {
            if let Some(new) = field.show(
                ui,
                owned_light.id.as_str(),
                &tr!("New name of {light}", light = owned_light.full_name()),
            ) {
                self.renaming = None;
                if let Some(name) = new.filter(|name| *name != owned_light.light.name) {
                    out.push(owned_light.set(Light { name, ..owned_light.light.clone() }).once());
                }
            }
            return;
        }
        let is_dark = why_dark.is_some();
        let colors = theme::of(ui);
        let color = match (is_dark || is_replaced, is_at_hand) {
            (true, _) => colors.dim,
            (false, true) => colors.accent,
            (false, false) => colors.text,
        };
        let text = RichText::new(owned_light.name()).strong().color(color);
        let text = if is_dark { text.strikethrough() } else { text };
        let response = ui.add(Label::new(text).truncate().selectable(false).sense(Sense::click()));
        if response.double_clicked() {
            self.rename(owned_light);
        } else if response.clicked() {
            out.push(Command::ChooseLight(owned_light.id.clone()));
        }
        let mut why = why_dark.map_or_else(String::new, |why| format!("{why}.\n"));
        if !changed.is_empty() {
            why += &format!("{}\n", changed.help());
        }
        why += tr!(
            "A click chooses it: its handles, placing and looking through are of it then. Double \
             click to rename"
        );
        response.on_hover_text(why);
    }

    fn rename(&mut self, owned_light: &OwnedLight<'_>) {
        self.renaming = Some(NameEdit::new(
            (owned_light.owner, owned_light.id.clone()),
            &owned_light.light.name,
        ));
    }

    fn menu(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        owned_light: &OwnedLight<'_>,
        out: &mut Vec<Command>,
    ) {
        ChangedRow::of_light(session, owned_light.owner, owned_light.id).menu(ui, out);
        if ui
            .button(tr!("Rename light"))
            .on_hover_text(tr!("Or double click on the name"))
            .clicked()
        {
            self.rename(owned_light);
        }
        let users = self.users.get(owned_light.id).copied().unwrap_or(0);
        let (copy, removal) = match (owned_light.owner, users) {
            (Owner::Scene, _) => (
                tr!("Adds a copy, which stands in for nothing yet"),
                tr!("Each look has its own light again").to_owned(),
            ),
            (Owner::Look, 0) => {
                (tr!("Adds a copy, which no node names yet"), tr!("No node names it").to_owned())
            }
            (Owner::Look, users) => (
                tr!("Adds a copy, which no node names yet"),
                trn!(
                    users,
                    "{users} of the look's nodes names it, and will have to name another one",
                    "{users} of the look's nodes name it, and will have to name another one"
                ),
            ),
        };
        if ui.button(tr!("Duplicate light")).on_hover_text(copy).clicked() {
            out.push(owned_light.duplicate(session).once());
        }
        if owned_light.owner == Owner::Look {
            let help = tr!("All lights of the look as one rig, for other looks");
            if ui.button(tr!("Save all to the library…")).on_hover_text(help).clicked() {
                out.push(Command::Library(LibraryCommand::Offer(PartChoice::Lights)));
            }
        }
        add::scene_menu(ui, session, owned_light, self.mixed.shared(), out);
        if let Some(mix) = self.mix(session) {
            mixer::menu(ui, mix, owned_light.id, out);
        }
        ui.separator();
        if ui.add(Button::new(tr!("Remove light"))).on_hover_text(removal).clicked() {
            out.push(owned_light.remove().once());
        }
    }
}

/// Tells that the picture holds another frame than the one whose intensity the row sets.
fn held_intensity(ui: &mut Ui, session: &Session, owned_light: &OwnedLight<'_>) {
    let target = owned_light.target("intensity");
    let owned = OwnedKeys::of(session, owned_light.owner);
    if let Some(text) = owned.and_then(|owned| keyed::held_text(owned, &target)) {
        let text = RichText::new(tr!("Intensity: {text}")).small().color(theme::of(ui).dim);
        ui.add(Label::new(text).truncate());
    }
}

fn section(ui: &mut Ui, title: &str, help: &str) {
    ui.label(RichText::new(title).small().color(theme::of(ui).dim)).on_hover_text(help);
}

/// Shows the color of a light as a swatch that opens the picker, also while the other fields are
/// folded away. Returns the place of the swatch.
fn tint(
    ui: &mut Ui,
    session: &Session,
    owned_light: &OwnedLight<'_>,
    out: &mut Vec<Command>,
) -> Rect {
    let light = &owned_light.as_set(session);
    let shown = ui.scope(|ui| {
        ui.spacing_mut().interact_size = vec2(SWATCH, SWATCH);
        let [r, g, b] = light.color;
        let name = tr!("Color of {light}", light = owned_light.full_name());
        color::named_swatch(ui, &name, [r, g, b, 1.0], session.look().color_space, false)
    });
    if let Some((widget, [r, g, b, _])) = shown.inner {
        let new = Light { color: [r, g, b], ..light.clone() };
        out.push(owned_light.changed(session, light, &new).held(widget));
    }
    shown.response.rect
}

/// Shows the intensity of a light, also while the other fields are folded away.
fn intensity(ui: &mut Ui, session: &Session, owned_light: &OwnedLight<'_>, out: &mut Vec<Command>) {
    let light = &owned_light.as_set(session);
    let mut value = light.intensity;
    let drag = number_field(ui, &mut value)
        .prefix("×")
        .speed(0.01)
        .range(0.0..=f64::MAX)
        .clamp_existing_to_range(false);
    let response = ui
        .add(drag.max_decimals(2))
        .on_hover_text(tr!("Intensity: a factor on the color. Drag, or click to type."));
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(
            Role::SpinButton,
            true,
            tr!("Intensity of {light}", light = owned_light.full_name()),
        );
        info.value = Some(value);
        info
    });
    if response.changed() && value.is_finite() {
        let new = Light { intensity: value, ..light.clone() };
        out.push(owned_light.changed(session, light, &new).held(response.id));
    }
}
