//! Table of the values that the keys of a set change: a row for each value, a column for each key,
//! edited in place.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Button, Grid, RichText, Ui, WidgetInfo};

use super::KeySetView;
use crate::commands::Command;
use crate::document::{LightField, Target};
use crate::fields::lighting::Owner;
use crate::library::Type;
use crate::state::keying::{has_between, targets_of};
use crate::widgets::text::hint;
use crate::widgets::theme;
use crate::widgets::value;

/// Part of the panel that names of values take, and their least width in points.
const NAME_PART: f32 = 0.45;
const LEAST_NAME: f32 = 80.0;

/// Shows the table.
pub(super) fn show(ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
    let targets = targets_of(shown.keys);
    Grid::new(("keyed values", shown.owned.owner, shown.set))
        .num_columns(shown.keys.keys.len() + 1)
        .spacing([10.0, 4.0])
        .show(ui, |ui| {
            head(ui, shown, out);
            for target in &targets {
                row(ui, shown, target, out);
            }
        });
    if targets.is_empty() {
        hint(
            ui,
            tr!("These keys change nothing yet: add a value, or press the diamond beside one in \
                 the inspector or in Lights."),
        );
    }
    add_value(ui, shown, &targets, out);
}

fn head(ui: &mut Ui, shown: &KeySetView<'_>, out: &mut Vec<Command>) {
    let colors = theme::of(ui);
    ui.label(RichText::new(tr!("Value")).small().color(colors.dim));
    // A key that is newly selected on the sphere is scrolled into view.
    let seen = egui::Id::unique("key in view");
    let place = shown.place(shown.key);
    let is_new = ui.data(|data| data.get_temp(seen)) != Some(place);
    ui.data_mut(|data| data.insert_temp(seen, place));
    for index in 0..shown.keys.keys.len() {
        let is_it = shown.key == index;
        let text =
            RichText::new(tr!("Key {key}", key = index + 1)).color(colors.hue(index)).strong();
        let response = ui.add(Button::selectable(is_it, text).small());
        response.widget_info(|| {
            WidgetInfo::selected(
                egui::Role::Button,
                true,
                is_it,
                tr!("Select key {key}", key = index + 1),
            )
        });
        if is_it && is_new {
            response.scroll_to_me(Some(egui::Align::Center));
        }
        let help = tr!(
            "Values set elsewhere in the window are set at this key; press again to follow the \
             heaviest key"
        );
        if response.on_hover_text(help).clicked() {
            let place = shown.place(index);
            let is_held = shown.owned.session.selection.key == Some(place);
            out.push(Command::SelectKey((!is_held).then_some(place)));
        }
    }
    ui.end_row();
}

fn row(ui: &mut Ui, shown: &KeySetView<'_>, target: &Target, out: &mut Vec<Command>) {
    let KeySetView { owned, set, keys, .. } = shown;
    let base = owned.keys.base;
    let [owner, what] = base.names_of(target);
    let called = format!("{owner}: {what}");
    let port = base.port_at(target);
    ui.vertical(|ui| {
        ui.set_max_width((ui.available_width() * NAME_PART).max(LEAST_NAME));
        let link = ui
            .add(egui::Link::new(RichText::new(&called).color(theme::of(ui).text)))
            .on_hover_text(tr!("Shows what has this value"));
        if link.clicked()
            && let Target::Input { node, .. } = target
        {
            out.push(Command::Show(node.clone()));
        }
        if port.is_some() {
            unkey(ui, shown, (target, &called), out);
        }
    });
    let Some(port) = port else {
        ui.end_row();
        return;
    };
    for (index, key) in keys.keys.iter().enumerate() {
        ui.push_id(index, |ui| {
            ui.horizontal(|ui| {
                let name = tr!("{called} at key {key}", key = index + 1);
                let own = key.values.get(target);
                let Some(now) = own.cloned().or_else(|| base.own_value(target)) else { return };
                if own.is_none() {
                    let help =
                        tr!("This key leaves the document's own value; press to give it one");
                    let whose = match owned.owner {
                        Owner::Look => tr!("the look's"),
                        Owner::Scene => tr!("the light's"),
                    };
                    let text = RichText::new(whose).color(theme::of(ui).dim);
                    let response = ui.add(Button::new(text).small()).on_hover_text(help);
                    let name = tr!("Set {called} at key {key}", key = index + 1);
                    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &name));
                    if response.clicked() {
                        out.extend(owned.once(owned.keys.set_in_key(*set, index, target, now)));
                    }
                    return;
                }
                let space = owned.session.look().color_space;
                if let Some((id, value)) = value::cell(ui, &name, &port, &now, space) {
                    let edit = owned.keys.set_in_key(*set, index, target, value);
                    out.extend(owned.held(id, edit));
                }
                let is_only =
                    keys.keys.iter().filter(|key| key.values.contains_key(target)).count() < 2;
                let clear = ui.add_enabled(!is_only, Button::new("×").small().frame(false));
                let name = tr!("Clear {called} at key {key}", key = index + 1);
                clear.widget_info(|| WidgetInfo::labeled(egui::Role::Button, !is_only, &name));
                if clear.on_hover_text(tr!("Leaves the own value at this key")).clicked() {
                    out.extend(shown.change(|keys| {
                        keys.keys[index].values.shift_remove(target);
                    }));
                }
            });
        });
    }
    ui.end_row();
}

/// Shows the button that takes a value out of the set.
fn unkey(
    ui: &mut Ui,
    shown: &KeySetView<'_>,
    (target, called): (&Target, &str),
    out: &mut Vec<Command>,
) {
    let text = RichText::new(tr!("Unkey")).color(theme::of(ui).dim);
    let button = ui.add(Button::new(text).small());
    button.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, tr!("Unkey {called}")));
    let help = tr!("Keys change this no more; it keeps the value that it has now");
    if button.on_hover_text(help).clicked() {
        out.extend(shown.owned.once(shown.owned.keys.unkey(target)));
    }
}

/// Shows the menu of values that can be keyed: inputs of the selected nodes, and fields of the
/// lights.
fn add_value(ui: &mut Ui, shown: &KeySetView<'_>, known: &[Target], out: &mut Vec<Command>) {
    let (session, owned) = (shown.owned.session, shown.owned);
    let has_nodes = owned.owner == Owner::Look;
    ui.menu_button(tr!("Add value"), |ui| {
        egui::ScrollArea::vertical().max_height(320.0).show(ui, |ui| {
            for id in session.selection.nodes.iter().filter(|_| has_nodes) {
                let kind =
                    session.graph().nodes.get(id).and_then(|node| session.project.catalog.of(node));
                let ports = kind.map(|kind| kind.inputs.as_slice()).unwrap_or_default();
                for port in ports.iter().filter(|port| has_between(&port.ty)) {
                    let is_free = session.graph().wire_into(id, &port.name).is_none();
                    let target = session.selection.target(id, &port.name);
                    entry(ui, shown, &target, is_free && !known.contains(&target), out);
                }
            }
            if has_nodes && session.selection.nodes.is_empty() {
                hint(ui, tr!("Select a node to key its values."));
            }
            for (id, light) in &owned.look().lights {
                // The position and the direction of a light are no values for a table; the diamonds
                // beside these fields key them.
                let is_cell = |field: &LightField| Type::of_light_field(*field) != Type::Vec3;
                for field in light.fields().filter(is_cell) {
                    let target =
                        Target::Light { light: id.clone(), field: field.name().to_owned() };
                    let is_new = !known.contains(&target);
                    entry(ui, shown, &target, is_new, out);
                }
            }
        });
    })
    .response
    .on_hover_text(tr!(
        "Keys another value: it has its present one at every key until you change it"
    ));
}

fn entry(
    ui: &mut Ui,
    shown: &KeySetView<'_>,
    target: &Target,
    is_new: bool,
    out: &mut Vec<Command>,
) {
    let owned = shown.owned;
    let [owner, what] = owned.keys.base.names_of(target);
    if is_new
        && owned.keys.value_now(target).is_some()
        && ui.button(format!("{owner}: {what}")).clicked()
    {
        let edit = owned.keys.key_in_set(shown.set, target);
        out.extend(edit.and_then(|edit| owned.once(edit)));
    }
}
