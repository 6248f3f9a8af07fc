//! Menu of a value beyond setting it: key, expose, reset. Opened from the diamond beside the value,
//! or by a right click on its name.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{RichText, ScrollArea, TextEdit, Ui};

use super::row;
use crate::commands::{Command, FilmCommand, PanelId, ViewCommand};
use crate::document::{Edit, ExposedValue, KeyDirection, Target};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::fields::shot::{self, ChangedValue};
use crate::fields::wedge::variation_of;
use crate::fields::{constant_wires, mark};
use crate::ids::{PortName, is_slug, make_slug};
use crate::library::Type;
use crate::state::keying::retime::SAME_TIME;
use crate::state::keying::{KeyPlace, KeyedBy, changes_in_time, has_between};
use crate::state::session::Session;
use crate::state::variations::{VariationKind, VariedSubject};
use crate::widgets::menu::scrolling;
use crate::widgets::text::is_typed;
use crate::widgets::theme;

/// Value with a mark: its target and type, and the edit that resets it to its default.
pub(crate) struct FieldTarget<'a> {
    pub(crate) owned: OwnedKeys<'a>,
    pub(crate) target: Target,
    pub(crate) ty: &'a Type,
    pub(crate) label: &'a str,
    pub(crate) reset: Option<Edit>,
}

impl FieldTarget<'_> {
    fn can_be_keyed(&self) -> bool {
        changes_in_time(self.ty) && self.owned.keys.base.own_value(&self.target).is_some()
    }

    /// Index of the value's exposed parameter.
    pub(crate) fn exposed(&self) -> Option<usize> {
        self.owned.look().exposed.iter().position(|exposed| exposed.target == self.target)
    }

    /// Lines that are added to the value's help.
    pub(crate) fn help(&self) -> String {
        let mut lines = Vec::new();
        if self.owned.keys.keyed_by(&self.target) != KeyedBy::Nothing {
            lines.push(mark::help(self.owned.keys, &self.target));
        }
        if let Some(exposed) = self.exposed().and_then(|index| self.owned.look().exposed.get(index))
        {
            lines.push(tr!("Exposed as \"{name}\".", name = exposed.name));
        }
        if let Some(changed) = self.by_shot() {
            lines.push(changed.help());
        }
        lines.join("\n")
    }

    /// The change that the open shot makes of the value.
    pub(crate) fn by_shot(&self) -> Option<ChangedValue<'_>> {
        ChangedValue::of(self.owned.session, self.owned.owner, &self.target.to_string())
    }
}

/// Room for a mark, in points.
pub(crate) fn size(ui: &Ui) -> egui::Vec2 {
    egui::vec2(16.0, ui.spacing().interact_size.y)
}

/// Shows the mark of a value, with its menu; leaves room for it where there is none.
pub(crate) fn diamond(ui: &mut Ui, marked: Option<&FieldTarget<'_>>, out: &mut Vec<Command>) {
    let is_changed = marked.is_some_and(|marked| marked.by_shot().is_some());
    let Some(marked) = marked.filter(|marked| marked.can_be_keyed()) else {
        let (rect, _) = ui.allocate_exact_size(size(ui), egui::Sense::hover());
        if is_changed {
            shot::bar(ui, rect);
        }
        return;
    };
    let name = tr!("Keys of {value}", value = marked.label);
    let response = mark::of(ui, marked.owned.keys, &marked.target, &name);
    if marked.by_shot().is_some() {
        shot::bar(ui, response.rect);
    }
    egui::Popup::menu(&response).show(|ui| scrolling(ui, |ui| menu(ui, marked, out)));
    response.on_hover_text(mark::help(marked.owned.keys, &marked.target));
}

/// Shows all entries of the menu: the key at the playhead is always the first, and what takes
/// something back the last.
pub(crate) fn menu(ui: &mut Ui, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    ui.set_min_width(190.0);
    if marked.can_be_keyed() {
        key_here(ui, marked, out);
        let is_keyed = marked.owned.keys.keyed_by(&marked.target) != KeyedBy::Nothing;
        let help = tr!("No keys move it any more; it keeps the value that it has now");
        if is_keyed && ui.button(tr!("Remove its keys")).on_hover_text(help).clicked() {
            out.extend(marked.owned.once(marked.owned.keys.unkey(&marked.target)));
        }
        ui.separator();
        if has_between(marked.ty) {
            keys_by_direction(ui, marked, out);
            ui.separator();
        }
    }
    trials(ui, marked, out);
    // Lights of a scene are no parameters, and have no defaults to go back to.
    let is_light_of_scene = marked.owned.owner == Owner::Scene && marked.can_be_keyed();
    if !is_light_of_scene {
        exposure(ui, marked, out);
    }
    let changed = marked.by_shot();
    if is_light_of_scene && changed.is_none() {
        return;
    }
    ui.separator();
    if let Some(changed) = changed {
        changed.reset(ui, out);
    }
    if is_light_of_scene {
        return;
    }
    let reset = ui.add_enabled(marked.reset.is_some(), egui::Button::new(tr!("Reset to default")));
    if let (true, Some(edit)) = (reset.clicked(), &marked.reset) {
        out.push(Command::Edit(edit.clone()));
    }
}

/// Shows the entries that try other values.
fn trials(ui: &mut Ui, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    if let Some(variation) = variation_of(marked.owned, &marked.target) {
        let help = tr!("Tries several values of it, each as a picture on one sheet");
        if ui.button(tr!("Wedge this value")).on_hover_text(help).clicked() {
            out.push(Command::Film(FilmCommand::Vary(variation)));
        }
    }
    if let Some(port) = marked.owned.keys.base.port_at(&marked.target)
        && VariationKind::of(&marked.target, &port).is_some()
    {
        let help = tr!("Small pictures of the value as it could be; a click takes one");
        let subject = VariedSubject::Value(marked.owned.owner, marked.target.clone());
        if ui.button(tr!("Variations...")).on_hover_text(help).clicked() {
            out.push(Command::View(ViewCommand::Vary(subject)));
        }
    }
}

/// Shows the entry that makes the value a parameter, or ends that.
fn exposure(ui: &mut Ui, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    match marked.exposed() {
        None if marked.owned.keys.base.own_value(&marked.target).is_none() => {
            ui.label(
                RichText::new(tr!("Set a value to key or expose it.")).color(theme::of(ui).dim),
            );
        }
        None => {
            let help = tr!("Scenes, scripts and exported shaders can set it by a name then");
            if ui.button(tr!("Expose")).on_hover_text(help).clicked() {
                out.push(Command::Edit(expose(marked)));
            }
        }
        Some(index) => {
            if ui
                .button(tr!("Unexpose"))
                .on_hover_text(tr!("It is no parameter any more"))
                .clicked()
            {
                out.push(Command::Edit(Edit::RemoveExposed { index }));
            }
        }
    }
}

/// Shows the entry that keys the value at the playhead, or takes its key there away.
fn key_here(ui: &mut Ui, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    let (owned, keys) = (marked.owned, marked.owned.keys);
    let now = owned.session.view.time;
    let mut tracks = owned.look().time_keys.iter().enumerate();
    let track = tracks.find(|(_, track)| track.target == marked.target);
    let key = track.and_then(|(index, track)| {
        let here = track.keys.iter().position(|key| (key.time - now).abs() < SAME_TIME)?;
        keys.without_key(index, here)
    });
    if let Some(edit) = key {
        let help = tr!("Takes the key at the playhead away; the others stay");
        if ui.button(tr!("Remove the key here")).on_hover_text(help).clicked() {
            out.extend(owned.once(edit));
        }
        return;
    }
    let help = tr!(
        "A key at the playhead with the value of now; setting it at another time adds another key"
    );
    if ui.button(tr!("Key here")).on_hover_text(help).clicked() {
        let edit = keys.key_in_time(&marked.target);
        out.extend(edit.and_then(|edit| owned.once(edit)));
        out.push(Command::ShowPanel(PanelId::TIMELINE));
    }
}

fn keys_by_direction(ui: &mut Ui, marked: &FieldTarget<'_>, out: &mut Vec<Command>) {
    let owned = marked.owned;
    let (session, keys) = (owned.session, owned.keys);
    let sets = &owned.look().direction_keys;
    let is_of_look = owned.owner == Owner::Look;
    for (index, set) in sets.iter().enumerate() {
        let has_it = set.keys.iter().any(|key| key.values.contains_key(&marked.target));
        let help =
            tr!("Has its present value at every key of this set, until you change it at one");
        let here = tr!("Adds a key where that is now, with the present values");
        let adds_here = has_it && !is_of_look;
        let text = tr!("New key in \"{set}\"", set = set.name);
        if adds_here && ui.button(text).on_hover_text(here).clicked() {
            out.extend(owned.once(keys.key_here(index)));
        }
        let text = tr!("Key in \"{set}\"", set = set.name);
        if !has_it && ui.button(text).on_hover_text(help).clicked() {
            let edit = keys.key_in_set(index, &marked.target);
            out.extend(edit.and_then(|edit| owned.once(edit)));
            out.push(Command::ShowPanel(PanelId::KEYS));
        }
    }
    let lights = owned.look().lights.keys().map(|id| KeyDirection::Light(id.clone()));
    let mut begin = |ui: &mut Ui, text: String, by: KeyDirection| {
        if ui.button(text).on_hover_text(tr!("Begins keys with one where that is now")).clicked() {
            out.extend(owned.once(keys.new_set(by, Some(&marked.target))));
            let place = KeyPlace { owner: owned.owner, set: sets.len(), key: 0 };
            out.push(Command::SelectKey(Some(place)));
            out.push(Command::ShowPanel(PanelId::KEYS));
        }
    };
    for by in lights.chain([KeyDirection::View]) {
        let text = match &by {
            KeyDirection::Light(id) => {
                tr!("New keys by the light \"{light}\"", light = keys.base.light_name(id))
            }
            _ => tr!("New keys by the view").to_owned(),
        };
        begin(ui, text, by);
    }
    ui.menu_button(tr!("New keys by a distance or height…"), |ui| {
        ScrollArea::vertical().max_height(360.0).show(ui, |ui| {
            for driver in keys.drivers() {
                let text = tr!("New keys by: {names}", names = keys.driver_name(&driver));
                begin(ui, text, KeyDirection::Drivers(vec![driver]));
            }
        });
    });
    if !is_of_look {
        return;
    }
    let [wires, constant] = keys.wires(std::slice::from_ref(&marked.target));
    if wires.is_empty() && constant.is_empty() {
        return;
    }
    let help = tr!(
        "What is the same all over the object may decide: an exposed or keyed value, the time, a \
         light's direction, and what is computed from these"
    );
    let menu = ui.menu_button(tr!("New keys by a wire…"), |ui| {
        ScrollArea::vertical().max_height(360.0).show(ui, |ui| {
            for driver in wires {
                begin(ui, session.keys().driver_name(&driver), KeyDirection::Drivers(vec![driver]));
            }
        });
        constant_wires::note(ui, session, &constant);
    });
    menu.response.on_hover_text(help);
}

fn expose(marked: &FieldTarget<'_>) -> Edit {
    let session = marked.owned.session;
    let [owner, what] = session.look_with_library().english_names_of(&marked.target);
    let is_taken =
        |slug: &str| session.look().exposed.iter().any(|exposed| exposed.name.as_str() == slug);
    let name = PortName::new(make_slug(&format!("{owner} {what}"), is_taken));
    let exposed = ExposedValue { name, target: marked.target.clone(), label: String::new() };
    session.keys().grounded(Some(&marked.target), Edit::AddExposed { exposed, index: None })
}

/// Lists the exposed parameters whose targets `is_shown` accepts, with their names.
pub(crate) fn list(
    ui: &mut Ui,
    session: &Session,
    is_shown: impl Fn(&Target) -> bool,
    out: &mut Vec<Command>,
) {
    let shown =
        session.look().exposed.iter().enumerate().filter(|(_, exposed)| is_shown(&exposed.target));
    let shown: Vec<_> = shown.collect();
    if shown.is_empty() {
        return;
    }
    ui.separator();
    let help = tr!("What scenes, scripts and exported shaders may set, by these names");
    ui.label(RichText::new(tr!("Exposed parameters")).strong()).on_hover_text(help);
    for (index, exposed) in shown {
        ui.push_id(index, |ui| {
            let [owner, what] = session.look_with_library().names_of(&exposed.target);
            let called = format!("{owner}: {what}");
            row::labelled(
                ui,
                &called,
                tr!("The name of this parameter: small letters, digits and _"),
                |ui, label| {
                    let width = (ui.available_width() - 78.0).max(60.0);
                    rename(ui, session, index, exposed, (label, width), out);
                    if ui.small_button(tr!("Unexpose")).clicked() {
                        out.push(Command::Edit(Edit::RemoveExposed { index }));
                    }
                },
            );
        });
    }
}

/// Shows the field for a parameter's name. A text that is being typed may be no valid name yet, so
/// it is kept aside.
fn rename(
    ui: &mut Ui,
    session: &Session,
    index: usize,
    exposed: &ExposedValue,
    (label, width): (egui::Id, f32),
    out: &mut Vec<Command>,
) {
    let id = ui.scope_id().with("parameter");
    let mut text =
        ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| exposed.name.to_string());
    let is_free = session
        .look()
        .exposed
        .iter()
        .enumerate()
        .all(|(at, other)| at == index || other.name.as_str() != text);
    let is_good = is_slug(&text) && is_free;
    let ink = if is_good { theme::of(ui).text } else { theme::of(ui).error };
    let edit =
        TextEdit::singleline(&mut text).id(id).desired_width(width).text_color(ink).char_limit(64);
    let response = ui.add(edit).labelled_by(label);
    let is_typed = is_typed(ui, &response, &mut text);
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text.clone()));
    } else {
        ui.data_mut(|data| data.remove::<String>(id));
    }
    let is_free = session
        .look()
        .exposed
        .iter()
        .enumerate()
        .all(|(at, other)| at == index || other.name.as_str() != text);
    if is_typed && is_slug(&text) && is_free {
        let exposed = ExposedValue { name: PortName::new(text), ..exposed.clone() };
        out.push(Command::EditHeld(id, Edit::SetExposed { index, exposed }));
    }
    if !is_good {
        response.on_hover_text(tr!(
            "Small letters, digits and _, beginning with a letter, and used once"
        ));
    }
}
