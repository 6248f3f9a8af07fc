//! Keys by drivers: the numbers that decide, their present values, and the place of each key along
//! them.

use chiaro_locale::tr;
use eframe::egui::{
    Button, Color32, ComboBox, Grid, Rect, RichText, Role, ScrollArea, Sense, Stroke, TextWrapMode,
    Ui, WidgetInfo, pos2, vec2,
};
use glam::DVec3;

use super::sphere::{Ground, mixed};
use super::{KeySetView, name};
use crate::commands::Command;
use crate::document::{Driver, KeyDirection};
use crate::state::keying::{said, targets_of};
use crate::widgets::number::number_field;
use crate::widgets::theme;

/// Height up to which a menu of drivers grows before it scrolls, in points.
pub(super) const MENU: f32 = 360.0;

/// Number of pieces in a strip of colors.
const PIECES: usize = 96;

/// Shows the drivers of a set and the places of its keys; with a single driver also a strip of the
/// keys' weights along it.
pub(super) fn show(
    ui: &mut Ui,
    shown: &KeySetView<'_>,
    axes: &[Driver],
    ground: &mut Ground,
    out: &mut Vec<Command>,
) {
    if axes.len() == 1 {
        strip(ui, shown, ground, out);
    }
    let colors = theme::of(ui);
    Grid::new(("drivers", shown.owned.owner, shown.set))
        .num_columns(shown.keys.keys.len() + 3)
        .spacing([10.0, 4.0])
        .show(ui, |ui| {
            ui.label(RichText::new(tr!("Driver")).small().color(colors.dim));
            ui.label(RichText::new(tr!("Now")).small().color(colors.dim));
            for key in 0..shown.keys.keys.len() {
                ui.label(RichText::new(tr!("Key {key}", key = key + 1)).color(colors.hue(key)));
            }
            ui.end_row();
            for axis in 0..axes.len() {
                ui.push_id(axis, |ui| chosen(ui, shown, axes, axis, out));
                let now = ui.label(said(&axes[axis], shown.now[axis]));
                let text = tr!(
                    "{driver} now: {value}",
                    driver = shown.owned.keys.driver_name(&axes[axis]),
                    value = said(&axes[axis], shown.now[axis])
                );
                now.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.clone()));
                for key in 0..shown.keys.keys.len() {
                    ui.push_id((axis, key), |ui| place(ui, shown, &axes[axis], (axis, key), out));
                }
                if axes.len() > 1 {
                    let remove = ui
                        .add(Button::new("×").small().frame(false))
                        .on_hover_text(tr!("Decides no more"));
                    let driver = shown.owned.keys.driver_name(&axes[axis]);
                    let called = tr!("Remove the driver {driver}");
                    remove.widget_info(|| WidgetInfo::labeled(Role::Button, true, called.clone()));
                    if remove.clicked() {
                        out.extend(shown.change(|keys| remove_axis(keys, axis)));
                    }
                }
                ui.end_row();
            }
        });
    if axes.len() < Driver::MOST {
        add(ui, shown, axes, out);
    }
}

/// Possible drivers of a set's keys: numbers of the scene, then wires of the look that may change.
fn all(shown: &KeySetView<'_>) -> impl Iterator<Item = Driver> {
    let [wires, _] = shown.owned.keys.wires(&targets_of(shown.keys));
    shown.owned.keys.drivers().into_iter().chain(wires)
}

/// Shows the choice of an axis's driver.
fn chosen(
    ui: &mut Ui,
    shown: &KeySetView<'_>,
    axes: &[Driver],
    axis: usize,
    out: &mut Vec<Command>,
) {
    let keyed = shown.owned.keys;
    let combo = ComboBox::from_id_salt("driver").width(150.0).wrap_mode(TextWrapMode::Extend);
    let combo = combo.selected_text(keyed.driver_name(&axes[axis]));
    let combo = combo.show_ui(ui, |ui| {
        for driver in all(shown) {
            let is_free = !axes.contains(&driver);
            if ui.selectable_label(axes[axis] == driver, keyed.driver_name(&driver)).clicked()
                && is_free
            {
                out.extend(shown.change(|keys| {
                    if let KeyDirection::Drivers(axes) = &mut keys.by {
                        axes[axis] = driver;
                    }
                }));
            }
        }
    });
    name(&combo.response, Role::ComboBox, &tr!("Driver {number}", number = axis + 1));
    combo.response.on_hover_text(tr!(
        "Which number of the scene, or which wire of the look, decides; keys stay where they are"
    ));
}

/// Shows the field for a key's place along an axis.
fn place(
    ui: &mut Ui,
    shown: &KeySetView<'_>,
    driver: &Driver,
    (axis, key): (usize, usize),
    out: &mut Vec<Command>,
) {
    let own = shown.keys.keys[key].direction[axis];
    let per_unit = if driver.is_angle() { 1f64.to_radians() } else { 1.0 };
    let mut value = own / per_unit;
    let (speed, suffix) = if driver.is_angle() { (0.5, "°") } else { (0.01, "") };
    let drag = ui.add(number_field(ui, &mut value).speed(speed).suffix(suffix).max_decimals(3));
    let driver = shown.owned.keys.driver_name(driver);
    let called = tr!("{driver} of key {key}", key = key + 1);
    drag.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, called.clone()));
    if drag.changed() && value.is_finite() {
        let moved = (value * per_unit).clamp(-1e6, 1e6);
        out.extend(shown.change_held(drag.id, |keys| keys.keys[key].direction[axis] = moved));
    }
}

/// Shows the menu that adds a driver to a set; all keys get the driver's present value as their
/// place.
fn add(ui: &mut Ui, shown: &KeySetView<'_>, axes: &[Driver], out: &mut Vec<Command>) {
    let keyed = shown.owned.keys;
    ui.menu_button(tr!("Add driver"), |ui| {
        ScrollArea::vertical().max_height(MENU).show(ui, |ui| {
            for driver in all(shown).filter(|driver| !axes.contains(driver)) {
                if ui.button(keyed.driver_name(&driver)).clicked() {
                    let now = super::rounded(DVec3::splat(keyed.driver_now(&driver)))[0];
                    out.extend(shown.change(|keys| {
                        let KeyDirection::Drivers(axes) = &mut keys.by else { return };
                        let axis = axes.len();
                        axes.push(driver);
                        keys.keys.iter_mut().for_each(|key| key.direction[axis] = now);
                    }));
                }
            }
        });
    })
    .response
    .on_hover_text(tr!("Up to three numbers decide together: keys lie on a plane, or in space"));
}

fn remove_axis(keys: &mut crate::document::DirectionKeys, axis: usize) {
    let KeyDirection::Drivers(axes) = &mut keys.by else { return };
    axes.remove(axis);
    for key in &mut keys.keys {
        key.direction[axis..].rotate_left(1);
        key.direction[2] = 0.0;
    }
}

/// Place of a copied key, beside its original.
pub(super) fn beside(place: [f64; 3]) -> [f64; 3] {
    let [first, rest @ ..] = place;
    let moved = if first == 0.0 { 0.5 } else { first * 1.25 };
    [moved, rest[0], rest[1]]
}

/// Shows the keys' weights along the only driver as colors, with the keys and the driver's present
/// value. A press selects the nearest key.
fn strip(ui: &mut Ui, shown: &KeySetView<'_>, ground: &mut Ground, out: &mut Vec<Command>) {
    let colors = theme::of(ui);
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width().max(80.0), 34.0), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, tr!("Keys along the driver")));
    let places = || shown.keys.keys.iter().map(|key| key.direction[0]).chain([shown.now.x]);
    let (low, high) = (places().fold(f64::MAX, f64::min), places().fold(f64::MIN, f64::max));
    let margin = (0.08 * (high - low)).max(1e-3);
    let (low, span) = (low - margin, high - low + 2.0 * margin);
    let at = |value: f64| rect.left() + rect.width() * ((value - low) / span) as f32;
    let bar = Rect::from_min_max(rect.min, pos2(rect.right(), rect.top() + 18.0));
    let inks: Vec<Color32> = (0..shown.keys.keys.len()).map(|key| colors.hue(key)).collect();
    let weights = ground.weights(shown.keys);
    for piece in 0..PIECES {
        let share = |piece: usize| piece as f32 / PIECES as f32;
        let value = low + span * (piece as f64 + 0.5) / PIECES as f64;
        let color =
            mixed(&weights.weights(DVec3::new(value, 0.0, 0.0)), &inks, colors.canvas, 0.72);
        let [left, right] = [piece, piece + 1].map(|piece| bar.left() + bar.width() * share(piece));
        let part = Rect::from_min_max(pos2(left, bar.top()), pos2(right, bar.bottom()));
        ui.painter().rect_filled(part, 0.0, color);
    }
    for (key, ink) in inks.iter().enumerate() {
        let center = pos2(at(shown.keys.keys[key].direction[0]), rect.bottom() - 7.0);
        let edge = if shown.key == key { colors.text } else { colors.canvas };
        ui.painter().circle(center, 6.0, *ink, Stroke::new(1.5, edge));
    }
    let now = at(shown.now.x);
    ui.painter().vline(now, rect.y_range(), Stroke::new(1.5, colors.text));
    if response.clicked()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let far = |key: usize| (at(shown.keys.keys[key].direction[0]) - pointer.x).abs();
        let nearest = (0..shown.keys.keys.len()).min_by(|a, b| far(*a).total_cmp(&far(*b)));
        out.push(Command::SelectKey(nearest.map(|key| shown.place(key))));
    }
    response.on_hover_text(tr!(
        "Colored by the key that weighs there; the line is where the driver is now. Press a key to \
         select it"
    ));
}
