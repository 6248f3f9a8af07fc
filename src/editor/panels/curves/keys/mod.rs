//! Direction keys (BADF 3.4): the sphere of a light's or the view's directions with the keys on it,
//! and the values that each key sets. Keys by drivers lie along one to three numbers instead, which
//! are typed.

mod drivers;
mod jump;
mod marks;
mod sphere;
mod table;

use chiaro_locale::{text, tr};
use eframe::egui;
use eframe::egui::{
    Align2, Color32, ComboBox, CursorIcon, FontId, Rect, RichText, Role, ScrollArea, Sense, Stroke,
    TextEdit, TextWrapMode, Ui, WidgetInfo, pos2, vec2,
};
use glam::DVec3;

use crate::commands::{Command, PanelId, ViewCommand};
use crate::document::{DirectionKey, DirectionKeys, Edit, KeyDirection, KeyScheme};
use crate::fields::constant_wires;
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::keying::{KeyPlace, rounded};
use crate::state::orbit::Orbit;
use crate::state::session::Session;
use crate::widgets::text::hint;
use crate::widgets::text::is_typed;
use crate::widgets::theme;
use sphere::{Globe, Ground};

pub(crate) const PANEL: PanelRow = PanelRow::new(
    PanelId::KEYS,
    text!("Keys"),
    text!("Values that change with the direction of a light or of the view"),
    PanelPlace::BELOW_PICTURE_WITH_CURVES,
    |bench, ui, context| bench.memory.of::<Keys>().show(ui, context.session),
);

/// Step of an arrow key, in radians.
const STEP: f64 = 2.0 * std::f64::consts::PI / 180.0;
/// Angle between a copied key and its original, in radians.
const BESIDE: f64 = 0.4;

/// The panel of direction keys, and its state.
#[derive(Default)]
pub(crate) struct Keys {
    /// The set that is shown, where it is there: its document, and its index there.
    set: Option<(Owner, usize)>,
    /// Turn of the sphere: yaw and pitch in radians, for light directions and for view directions.
    turned: [Option<[f64; 2]>; 2],
    ground: Ground,
    /// Colors of the small sphere that shows the other side.
    other_side: Ground,
    /// View or illumination before it was turned to a key, to return to.
    back: Option<Orbit>,
}

/// Set of keys that is shown.
struct KeySetView<'a> {
    owned: OwnedKeys<'a>,
    set: usize,
    keys: &'a DirectionKeys,
    /// Key at which values are set, by index.
    key: usize,
    weights: Vec<f64>,
    now: DVec3,
}

impl<'a> KeySetView<'a> {
    /// The set of an index, as of now.
    fn of(owned: OwnedKeys<'a>, set: usize) -> Option<Self> {
        let keys = owned.look().direction_keys.get(set)?;
        let weights = owned.keys.key_weights(set);
        let now = owned.keys.direction_of(&keys.by);
        Some(Self { owned, set, keys, key: owned.keys.key_at(set), weights, now })
    }

    /// The same set with another key in hand.
    fn with_key(&self, key: usize) -> Self {
        Self { key, weights: Vec::new(), ..*self }
    }

    /// Place of a key of the set.
    fn place(&self, key: usize) -> KeyPlace {
        KeyPlace { owner: self.owned.owner, set: self.set, key }
    }

    /// Command that changes the set, as a step of its own.
    fn change(&self, change: impl FnOnce(&mut DirectionKeys)) -> Option<Command> {
        self.owned.once(self.owned.keys.change_set(self.set, change))
    }

    /// Command that changes the set for as long as a widget is held.
    fn change_held(
        &self,
        widget: egui::Id,
        change: impl FnOnce(&mut DirectionKeys),
    ) -> Option<Command> {
        self.owned.held(widget, self.owned.keys.change_set(self.set, change))
    }
}

impl Keys {
    /// Shows a set of direction keys of the look or of the scene.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut commands = Vec::new();
        if let Some(place) = session.selection.key {
            self.set = Some((place.owner, place.set));
        }
        let Some(shown) = self.shown(session) else {
            nothing(ui, session, &mut commands);
            return commands;
        };
        let keys = shown.keys;
        self.sets(ui, &shown, &mut commands);
        let room = ui.available_size();
        if let KeyDirection::Drivers(axes) = &keys.by {
            drivers::show(ui, &shown, axes, &mut self.ground, &mut commands);
            self.beside(ui, &shown, &mut commands);
            return commands;
        }
        if room.x > 400.0 {
            ui.horizontal_top(|ui| {
                let side = room.y.min(room.x * 0.42).max(120.0);
                ui.vertical(|ui| {
                    ui.set_width(side);
                    self.globe(ui, &shown, side, &mut commands);
                });
                ui.vertical(|ui| self.beside(ui, &shown, &mut commands));
            });
        } else {
            let side = room.x.min((room.y * 0.5).max(140.0));
            self.globe(ui, &shown, side, &mut commands);
            self.beside(ui, &shown, &mut commands);
        }
        commands
    }

    /// The set that is in hand, or the first of the look's and the scene's.
    fn shown<'s>(&mut self, session: &'s Session) -> Option<KeySetView<'s>> {
        let in_hand = self.set.and_then(|(owner, set)| {
            let owned = OwnedKeys::of(session, owner)?;
            // After the last set was removed the one before it is shown.
            KeySetView::of(owned, set.min(owned.look().direction_keys.len().saturating_sub(1)))
        });
        let first = || OwnedKeys::all(session).find_map(|owned| KeySetView::of(owned, 0));
        let shown = in_hand.or_else(first);
        self.set = shown.as_ref().map(|shown| (shown.owned.owner, shown.set));
        shown
    }

    fn beside(&mut self, ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
        shares(ui, shown);
        self.buttons(ui, shown, out);
        ScrollArea::both()
            .id_salt("values")
            .auto_shrink([false, false])
            .show(ui, |ui| table::show(ui, shown, out));
    }

    /// Shows the choice of the set, of its driver, and of the scheme of weights.
    fn sets(&mut self, ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
        let KeySetView { owned, set, keys, .. } = shown;
        ui.horizontal_wrapped(|ui| {
            self.choice(ui, shown, out);
            if owned.owner == Owner::Scene {
                let text = RichText::new(tr!("Of the scene")).small().color(theme::of(ui).dim);
                ui.label(text)
                    .on_hover_text(tr!("These keys move lights of the scene, in every look"));
            }
            let mut called = keys.name.clone();
            let edit = ui.add(
                TextEdit::singleline(&mut called)
                    .desired_width(104.0)
                    .hint_text(tr!("Name"))
                    .char_limit(80),
            );
            name(&edit, Role::TextInput, tr!("Name of the keys"));
            if is_typed(ui, &edit, &mut called) {
                out.extend(shown.change_held(edit.id, |keys| keys.name = called));
            }
            if keys.by.axes().is_none() {
                by(ui, shown, out);
                scheme(ui, shown, out);
            }
            add_menu(ui, owned.session, tr!("Add set"), out);
            let help = tr!("Removes these keys: every value is its own again");
            if ui.button(tr!("Remove set")).on_hover_text(help).clicked() {
                out.push(Command::SelectKey(None));
                out.extend(owned.once(Edit::RemoveDirectionKeys { index: *set }));
            }
        });
    }

    /// Shows the list of all sets, the look's and then the scene's, where there are several.
    fn choice(&mut self, ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
        let all: Vec<KeySetView<'_>> = OwnedKeys::all(shown.owned.session)
            .flat_map(|owned| {
                let sets = 0..owned.look().direction_keys.len();
                sets.filter_map(move |set| KeySetView::of(owned, set))
            })
            .collect();
        if all.len() < 2 {
            return;
        }
        let place = |set: &KeySetView<'_>| (set.owned.owner, set.set);
        let index = all.iter().position(|set| place(set) == place(shown)).unwrap_or_default();
        let combo = ComboBox::from_id_salt("set").width(56.0);
        let combo =
            combo.selected_text(tr!("{number} of {count}", number = index + 1, count = all.len()));
        let combo = combo.show_ui(ui, |ui| {
            for (at, set) in all.iter().enumerate() {
                let name = match set.owned.owner {
                    Owner::Look => set.keys.name.clone(),
                    Owner::Scene => tr!("{name} · of the scene", name = set.keys.name),
                };
                if ui.selectable_label(at == index, name).clicked() {
                    self.set = Some(place(set));
                    self.back = None;
                    out.push(Command::SelectKey(None));
                }
            }
        });
        name(&combo.response, Role::ComboBox, tr!("Set of keys"));
    }

    /// Shows the buttons for the selected key.
    fn buttons(&mut self, ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
        let KeySetView { owned, keys, key, .. } = shown;
        let can_edit = !keys.keys.is_empty();
        ui.horizontal_wrapped(|ui| {
            let help = tr!(
                "Adds a key where the light or the view is now, with the values that are seen now"
            );
            if ui.button(tr!("Add key here")).on_hover_text(help).clicked() {
                out.extend(owned.once(owned.keys.key_here(shown.set)));
                out.push(Command::SelectKey(Some(shown.place(keys.keys.len()))));
            }
            if ui
                .add_enabled(can_edit, egui::Button::new(tr!("Copy key")))
                .on_hover_text(tr!("Beside it (D)"))
                .clicked()
            {
                copy(shown, out);
            }
            let delete = ui.add_enabled(can_edit, egui::Button::new(tr!("Delete key")));
            if delete.on_hover_text(tr!("Takes this key and its values away (Delete)")).clicked() {
                remove(shown, out);
            }
            let to = keys
                .keys
                .get(*key)
                .and_then(|key| jump::to(*owned, &keys.by, key.direction.into()));
            let help = tr!(
                "Brings the light or the view to this key, to compare; Back returns. The document \
                 is not changed"
            );
            let go = ui
                .add_enabled(to.is_some(), egui::Button::new(tr!("Go to key")))
                .on_hover_text(help);
            let help = tr!("This light does not turn with the illumination frame: move it itself");
            if go.on_disabled_hover_text(help).clicked()
                && let Some(view) = to
            {
                self.back.get_or_insert_with(|| owned.session.view.orbit.clone());
                out.push(Command::View(ViewCommand::TurnTo(Box::new(view))));
            }
            let back = ui.add_enabled(self.back.is_some(), egui::Button::new(tr!("Back")));
            if back.on_hover_text(tr!("To where it was")).clicked()
                && let Some(view) = self.back.take()
            {
                out.push(Command::View(ViewCommand::TurnTo(Box::new(view))));
            }
        });
    }

    fn globe(&mut self, ui: &mut Ui, shown: &KeySetView<'_>, side: f32, out: &mut Vec<Command>) {
        let colors = theme::of(ui);
        let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::click_and_drag());
        response
            .widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Sphere of directions")));
        let is_view = shown.keys.by == KeyDirection::View;
        let turned = self.turned[usize::from(is_view)].get_or_insert(if is_view {
            [0.5, 0.35]
        } else {
            [0.0, 0.0]
        });
        if response.dragged() {
            let delta = response.drag_delta() / side * 3.0;
            let [yaw, pitch] = *turned;
            *turned = [yaw - f64::from(delta.x), (pitch + f64::from(delta.y)).clamp(-1.5, 1.5)];
        }
        if response.double_clicked() {
            *turned = [0.0, 0.0];
        }
        let turned = *turned;
        let globe = Globe::new(rect.center(), side / 2.0 - 25.0, turned);
        let inks: Vec<Color32> = (0..shown.keys.keys.len()).map(|key| colors.hue(key)).collect();
        ui.painter().rect_filled(rect, 4.0, colors.canvas);
        marks::graticule(ui, globe, false);
        ui.painter().add(self.ground.mesh(shown.keys, globe, turned, &inks, colors.canvas));
        marks::graticule(ui, globe, true);
        ui.painter().circle_stroke(
            globe.center,
            globe.radius,
            Stroke::new(1.0, colors.swatch_edge),
        );
        marks::names_of_places(ui, rect, globe, is_view);
        response.on_hover_cursor(CursorIcon::Move).on_hover_text(tr!(
            "Every direction of the light or the view, colored by the key that weighs there. Drag \
             a key; drag beside the keys to turn the sphere, double-click to turn it back. Keys \
             behind are rings."
        ));
        for is_front in [false, true] {
            for (index, key) in shown.keys.keys.iter().enumerate() {
                let Some(direction) = DVec3::from(key.direction).try_normalize() else { continue };
                if globe.is_front(direction) == is_front {
                    marks::key_handle(ui, shown, globe, index, direction, out);
                }
            }
        }
        marks::now_mark(ui, shown, globe);
        self.other_side(ui, shown, rect, turned);
    }

    /// Shows a small sphere in the corner as seen from the other side; a press turns the large one
    /// there.
    fn other_side(&mut self, ui: &Ui, shown: &KeySetView<'_>, rect: Rect, [yaw, pitch]: [f64; 2]) {
        let colors = theme::of(ui);
        let radius = (rect.width() * 0.11).clamp(14.0, 34.0);
        let turned = [yaw + std::f64::consts::PI, -pitch];
        let globe =
            Globe::new(rect.right_bottom() - vec2(radius + 5.0, radius + 5.0), radius, turned);
        let place = Rect::from_center_size(globe.center, egui::Vec2::splat(2.0 * radius));
        let response = ui.interact(place, ui.scope_id().with("other side"), Sense::click());
        name(&response, Role::Button, tr!("Turn to the other side"));
        let inks: Vec<Color32> = (0..shown.keys.keys.len()).map(|key| colors.hue(key)).collect();
        ui.painter().circle_filled(globe.center, radius + 2.0, colors.canvas);
        ui.painter().add(self.other_side.mesh(shown.keys, globe, turned, &inks, colors.canvas));
        let edge = if response.hovered() || response.has_focus() {
            colors.accent
        } else {
            colors.swatch_edge
        };
        ui.painter().circle_stroke(globe.center, radius, Stroke::new(1.0, edge));
        for (index, key) in shown.keys.keys.iter().enumerate() {
            let direction = DVec3::from(key.direction).normalize_or_zero();
            if globe.is_front(direction) {
                let stroke = Stroke::new(1.0, colors.canvas);
                ui.painter().circle(globe.project(direction), 3.5, colors.hue(index), stroke);
            }
        }
        if response.clicked() {
            self.turned[usize::from(shown.keys.by == KeyDirection::View)] = Some(turned);
        }
        response.on_hover_text(tr!("The other side of the sphere; press to turn it to the front"));
    }
}

fn name(response: &egui::Response, role: Role, text: &str) {
    response.widget_info(|| WidgetInfo::labeled(role, true, text));
}

/// Shows the purpose of direction keys and how to begin, where neither look nor scene has any.
fn nothing(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    hint(
        ui,
        tr!(
            "Direction keys change a look, or the lights of a scene, with where the light, or the \
             view, is: a rim light that turns violet as it comes around, a highlight that goes out \
             from behind. Begin with what decides, or with the diamond beside any value."
        ),
    );
    add_menu(ui, session, tr!("Add direction keys"), out);
}

fn add_menu(ui: &mut Ui, session: &Session, text: &str, out: &mut Vec<Command>) {
    let menu = ui.menu_button(text, |ui| {
        new_sets(ui, OwnedKeys::of_look(session), out);
        let of_scene = OwnedKeys::of(session, Owner::Scene);
        if let Some(owned) = of_scene.filter(|owned| !owned.look().lights.is_empty()) {
            ui.separator();
            let menu =
                ui.menu_button(tr!("For lights of the scene"), |ui| new_sets(ui, owned, out));
            menu.response.on_hover_text(tr!("Keys of the scene move its lights, in every look"));
        }
    });
    menu.response.on_hover_text(tr!(
        "Another set of keys, by the direction of a light or of the view, by a number of the \
         scene, or by a wire of the look that is one number for the whole object"
    ));
}

/// Shows an entry for each thing that may decide between keys of a document.
fn new_sets(ui: &mut Ui, owned: OwnedKeys<'_>, out: &mut Vec<Command>) {
    let keys = owned.keys;
    let mut add = |ui: &mut Ui, text: String, by: KeyDirection| {
        if ui.button(text).clicked() {
            let set = owned.look().direction_keys.len();
            out.extend(owned.once(keys.new_set(by, None)));
            let place = KeyPlace { owner: owned.owner, set, key: 0 };
            out.push(Command::SelectKey(Some(place)));
        }
    };
    for id in owned.look().lights.keys() {
        let text = tr!("By the light \"{light}\"", light = keys.base.light_name(id));
        add(ui, text, KeyDirection::Light(id.clone()));
    }
    add(ui, tr!("By the view").to_owned(), KeyDirection::View);
    ui.separator();
    for driver in keys.drivers() {
        add(ui, keys.driver_name(&driver), KeyDirection::Drivers(vec![driver]));
    }
    let [wires, constant] = keys.wires(&[]);
    if wires.is_empty() && constant.is_empty() {
        return;
    }
    ui.separator();
    ScrollArea::vertical().max_height(drivers::MENU).show(ui, |ui| {
        for driver in wires {
            add(ui, keys.driver_name(&driver), KeyDirection::Drivers(vec![driver]));
        }
    });
    constant_wires::note(ui, owned.session, &constant);
}

fn by(ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
    let KeySetView { owned, keys, .. } = shown;
    let text = |by: &KeyDirection| match by {
        KeyDirection::View => tr!("By the view").to_owned(),
        KeyDirection::Light(id) => tr!("By \"{light}\"", light = owned.keys.base.light_name(id)),
        KeyDirection::Drivers(_) => String::new(),
    };
    let combo = ComboBox::from_id_salt("by")
        .width(84.0)
        .wrap_mode(TextWrapMode::Extend)
        .selected_text(text(&keys.by))
        .show_ui(ui, |ui| {
            let lights = owned.look().lights.keys().map(|id| KeyDirection::Light(id.clone()));
            for by in lights.chain([KeyDirection::View]) {
                if ui.selectable_label(keys.by == by, text(&by)).clicked() && keys.by != by {
                    out.extend(shown.change(|keys| keys.by = by));
                }
            }
        });
    name(&combo.response, Role::ComboBox, tr!("What decides between the keys"));
    combo.response.on_hover_text(tr!(
        "Whose direction decides: a light's as the camera sees it (it changes too when you orbit), \
         or that to the eye"
    ));
}

fn scheme(ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
    let keys = shown.keys;
    let text = |scheme| match scheme {
        KeyScheme::Biharmonic => {
            (tr!("Biharmonic"), tr!("The smoothest weights on a sphere, in closed form"))
        }
        KeyScheme::AppendixB => {
            (tr!("Appendix B"), tr!("The energy of the BADF paper's Appendix B, in closed form"))
        }
        KeyScheme::Tessellated => {
            (tr!("Tessellated"), tr!("The paper's own mesh; slow, for comparison"))
        }
    };
    let combo = ComboBox::from_id_salt("scheme")
        .width(84.0)
        .wrap_mode(TextWrapMode::Extend)
        .selected_text(text(keys.scheme).0)
        .show_ui(ui, |ui| {
            for choice in [KeyScheme::Biharmonic, KeyScheme::AppendixB, KeyScheme::Tessellated] {
                let (label, help) = text(choice);
                let is_it = keys.scheme == choice;
                if ui.selectable_label(is_it, label).on_hover_text(help).clicked() && !is_it {
                    out.extend(shown.change(|keys| keys.scheme = choice));
                }
            }
        });
    name(&combo.response, Role::ComboBox, tr!("Scheme of the weights"));
    combo.response.on_hover_text(tr!("How the weights between keys are found"));
}

/// Shows the present weight of each key, as a bar.
fn shares(ui: &mut Ui, shown: &KeySetView<'_>) {
    let colors = theme::of(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), 12.0), Sense::hover());
    response.widget_info(|| {
        let each = shown
            .weights
            .iter()
            .enumerate()
            .map(|(key, weight)| format!("{} {:.0}%", key + 1, weight * 100.0));
        let weights = each.collect::<Vec<_>>().join(", ");
        let said = tr!("Weights of the keys now: {weights}");
        WidgetInfo::labeled(Role::Image, true, said)
    });
    let painter = ui.painter();
    painter.rect_filled(rect, 3.0, colors.canvas);
    let mut left = rect.left();
    for (key, weight) in shown.weights.iter().enumerate() {
        let width = rect.width() * *weight as f32;
        let part = Rect::from_min_size(pos2(left, rect.top()), vec2(width, rect.height()));
        painter.rect_filled(part, 2.0, colors.hue(key));
        if width > 34.0 {
            let font = FontId::proportional(theme::SMALL_TEXT);
            let text = format!("{}: {:.0}%", key + 1, weight * 100.0);
            painter.text(part.center(), Align2::CENTER_CENTER, text, font, colors.canvas);
        }
        left += width;
    }
    response.on_hover_text(tr!("How much each key counts where the light or the view is now"));
}

fn copy(shown: &KeySetView<'_>, out: &mut Vec<Command>) {
    let Some(original) = shown.keys.keys.get(shown.key) else { return };
    let direction = match shown.keys.by.axes() {
        Some(_) => drivers::beside(original.direction),
        None => {
            let direction = DVec3::from(original.direction).try_normalize().unwrap_or(DVec3::Z);
            let side = direction.any_orthonormal_vector();
            rounded(direction * BESIDE.cos() + side * BESIDE.sin())
        }
    };
    let copied = DirectionKey { direction, ..original.clone() };
    out.extend(shown.change(|keys| keys.keys.push(copied)));
    out.push(Command::SelectKey(Some(shown.place(shown.keys.keys.len()))));
}

fn remove(shown: &KeySetView<'_>, out: &mut Vec<Command>) {
    let key = shown.key;
    out.push(Command::SelectKey(None));
    out.extend(shown.change(|keys| {
        if key < keys.keys.len() {
            keys.keys.remove(key);
        }
    }));
}
