//! Lines below a keyed value: its present value, what decides between the keys and where that is,
//! and the key at which a hand sets the value.
//!
//! The widget above shows the value at that one key, so typed text stays as it was typed; the
//! picture's value lies between the keys.

use chiaro_locale::tr;
use eframe::egui::{Button, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use super::marks::{self, FieldTarget};
use crate::commands::Command;
use crate::document::{DirectionKeys, KeyDirection, Target, TimeKeys, Value};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::fields::shot::ChangedValue;
use crate::library::Type;
use crate::state::keying::retime::SAME_TIME;
use crate::state::keying::{KeyPlace, KeyedBy, KeyedLook, said};
use crate::values;
use crate::widgets::color;
use crate::widgets::theme;

/// Shows these lines below a value, if keys move it.
pub(crate) fn show(ui: &mut Ui, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    match marked.owned.keys.keyed_by(&marked.target) {
        KeyedBy::Nothing => {}
        KeyedBy::Direction(set) => by_direction(ui, marked, set, out),
        KeyedBy::Time(track) => in_time(ui, marked, track),
    }
}

/// Shows a line below the widget.
fn line(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let indent = marks::size(ui).x;
        ui.add_space(indent);
        add(ui);
    });
}

fn quiet(ui: &Ui, text: impl Into<String>) -> RichText {
    RichText::new(text).small().color(theme::of(ui).dim)
}

fn by_direction(ui: &mut Ui, marked: &FieldTarget<'_>, set: usize, out: &mut Vec<Command>) {
    let keyed = marked.owned.keys;
    let Some(keys) = marked.owned.look().direction_keys.get(set) else { return };
    let Some(port) = keyed.base.port_at(&marked.target) else { return };
    let said_of = |value: &Value| match shown_color(marked, value) {
        Some(color) => values::hex(color),
        None => values::short(&port, value),
    };
    line(ui, |ui| {
        if let Some(now) = keyed.value_now(&marked.target) {
            chip(ui, marked, &now);
            ui.label(
                RichText::new(tr!("Now {value}", value = said_of(&now)))
                    .small()
                    .color(theme::of(ui).text),
            );
        }
        let text = decided_by(keyed, set, keys);
        ui.label(quiet(ui, text))
            .on_hover_text(tr!("What decides between the keys, and where that is now"));
    });
    line(ui, |ui| {
        let help = tr!(
            "At which key a value is set that is typed here; what is seen now lies between the keys"
        );
        ui.label(quiet(ui, tr!("key" => "Sets"))).on_hover_text(help);
        for index in 0..keys.keys.len() {
            let value = keys.keys[index].values.get(&marked.target).map(said_of);
            one_key(ui, marked, (set, index), keys, value, out);
        }
    });
}

/// A color as shown; `None` for a value that is no color.
fn shown_color(marked: &FieldTarget<'_>, value: &Value) -> Option<[f64; 4]> {
    let space = marked.owned.session.look().color_space;
    let is_color = matches!(marked.ty, Type::Color | Type::Composite);
    Some(color::encoded(value.color_in(space).filter(|_| is_color)?, space))
}

/// Shows the present color of a value.
fn chip(ui: &mut Ui, marked: &FieldTarget<'_>, now: &Value) {
    let Some(color) = shown_color(marked, now) else { return };
    let [r, g, b, _] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    let (rect, _) = ui.allocate_exact_size(vec2(12.0, 12.0), Sense::hover());
    ui.painter().rect_filled(rect, 2.0, eframe::egui::Color32::from_rgb(r, g, b));
}

/// Text on what decides between the keys of a set, with its present value where that is a number.
fn decided_by(keyed: KeyedLook<'_>, set: usize, keys: &DirectionKeys) -> String {
    match &keys.by {
        KeyDirection::View => tr!("by the view").to_owned(),
        KeyDirection::Light(light) => {
            tr!("by the light \"{light}\"", light = keyed.base.light_name(light))
        }
        KeyDirection::Drivers(drivers) => {
            let now = keyed.decided(set).map(|(now, _)| now.to_array()).unwrap_or_default();
            let each = drivers.iter().zip(now).map(|(driver, now)| {
                let name = keyed.driver_name(driver);
                tr!("{name} is {value}", value = said(driver, now))
            });
            tr!("while {each}", each = each.collect::<Vec<_>>().join(", "))
        }
    }
}

/// Shows a button for a key of the set: pressed, values are set at this key; pressed again, at the
/// heaviest.
fn one_key(
    ui: &mut Ui,
    marked: &FieldTarget<'_>,
    (set, index): (usize, usize),
    keys: &DirectionKeys,
    value: Option<String>,
    out: &mut Vec<Command>,
) {
    let OwnedKeys { session, owner, keys: keyed } = marked.owned;
    let (is_it, number) = (keyed.key_at(set) == index, index + 1);
    let text = RichText::new(tr!("Key {number}")).small().color(theme::of(ui).hue(index));
    let button = ui.add(Button::selectable(is_it, text).small());
    let name = tr!("Set {value} at key {number}", value = marked.label);
    button.widget_info(|| WidgetInfo::selected(Role::Button, true, is_it, name.clone()));
    let place = KeyPlace { owner, set, key: index };
    let held = session.selection.key == Some(place);
    if button.clicked() {
        out.push(Command::SelectKey((!held).then_some(place)));
    }
    button.on_hover_ui(|ui| {
        let place = match &keys.by {
            KeyDirection::Drivers(drivers) => {
                let each = drivers.iter().zip(keys.keys[index].direction);
                let each = each.map(|(driver, at)| {
                    format!("{}: {}", keyed.driver_name(driver), said(driver, at))
                });
                format!(" ({})", each.collect::<Vec<_>>().join(", "))
            }
            KeyDirection::View | KeyDirection::Light(_) => String::new(),
        };
        let own = match owner {
            Owner::Look => tr!("the look's own value"),
            Owner::Scene => tr!("the light's own value"),
        };
        let value = value.unwrap_or_else(|| own.to_owned());
        let weight = keyed.key_weights(set).get(index).copied().unwrap_or(0.0);
        ui.label(tr!(
            "{value} at key {number}{place}, which counts {weight:.0}% now.",
            weight = weight * 100.0
        ));
        let help = match held {
            true => tr!("Press to follow the heaviest key again"),
            false => tr!("Press to set this key"),
        };
        ui.label(quiet(ui, help));
    });
}

fn in_time(ui: &mut Ui, marked: &FieldTarget<'_>, track: usize) {
    let Some(track) = marked.owned.look().time_keys.get(track) else { return };
    let (text, _) = time_text(marked.owned, track);
    line(ui, |ui| {
        ui.label(quiet(ui, text)).on_hover_text(tr!("The value above is the one at the playhead"));
    });
}

/// Text on what a hand sets of a value whose picture is that of a frame before, as the shot holds
/// it; `None` where the picture shows the frame of the playhead.
pub(crate) fn held_text(owned: OwnedKeys<'_>, target: &Target) -> Option<String> {
    let track = owned.look().time_keys.iter().find(|track| track.target == *target)?;
    let (text, is_held) = time_text(owned, track);
    is_held.then_some(text)
}

/// Text on the key that is set at the playhead, and true where the picture holds another frame.
fn time_text(owned: OwnedKeys<'_>, track: &TimeKeys) -> (String, bool) {
    let now = owned.session.view.time;
    let here = track.keys.iter().position(|key| (key.time - now).abs() < SAME_TIME);
    let count = track.keys.len();
    let Some(shot) = owned.session.shot() else {
        let now = values::number_text(now, 2);
        let text = match here.map(|key| key + 1) {
            Some(key) => tr!("At {now} s: sets key {key} of {count}"),
            None => tr!("At {now} s: setting it adds a key to {count}"),
        };
        return (text, false);
    };
    let frame = |time: f64| values::number_text(shot.rate().frame_within(time), 2);
    let changed = ChangedValue::of(owned.session, owned.owner, &track.target.to_string());
    let step = changed.map_or(1, |changed| changed.change.step);
    let held = shot.resolved().held_time(now, step);
    let (is_held, now, held) = (held != now, frame(now), frame(held));
    let ordinal = ordinal(count + 1);
    let text = match (here.map(|key| key + 1), is_held) {
        (Some(key), false) => tr!("Frame {now}: sets key {key} of {count}"),
        (Some(key), true) => {
            tr!("Frame {now}: sets key {key} of {count}; the picture holds frame {held}")
        }
        (None, false) => tr!("Frame {now}: adds a {ordinal} key"),
        (None, true) => tr!("Frame {now}: adds a {ordinal} key; the picture holds frame {held}"),
    };
    (text, is_held)
}

/// A place in words, as in "a 2nd key".
fn ordinal(number: usize) -> String {
    match (number % 10, number % 100) {
        (_, 11..=13) => tr!("{number}th"),
        (1, _) => tr!("{number}st"),
        (2, _) => tr!("{number}nd"),
        (3, _) => tr!("{number}rd"),
        _ => tr!("{number}th"),
    }
}

#[cfg(test)]
mod tests {
    use super::ordinal;

    #[test]
    fn places_are_said_as_they_are_spoken() {
        let said = [1, 2, 3, 4, 11, 12, 13, 21, 102, 111].map(ordinal);
        let spoken = ["1st", "2nd", "3rd", "4th", "11th", "12th", "13th", "21st", "102nd", "111th"];
        assert_eq!(said, spoken);
    }
}
