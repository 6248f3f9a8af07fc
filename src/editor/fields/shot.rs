//! Marks of values that the open shot changes: a bar beside the value, and beside the row of what
//! has such values, with what each was before, who changes it, and the way back.

use std::path::Path;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Button, Color32, Popup, Rect, Role, Sense, Ui, Vec2, WidgetInfo, vec2};

use crate::commands::{Command, SceneCommand, ShotCommand};
use crate::document::Target;
use crate::fields::{edge, mark, scene_names};
use crate::frame::{ResolvedShot, ValueChange};
use crate::ids::{LightId, NodePath, ObjectId};
use crate::state::keying::Owner;
use crate::state::reading::{of_library, spoken};
use crate::state::session::Session;
use crate::state::session::shot::change_text;
use crate::state::shot::{OpenShot, ShotAddress, key_at};
use crate::widgets::theme;

/// A value of a document, with the change that a shot makes of it.
#[derive(Clone, Copy)]
pub(crate) struct ChangedValue<'s> {
    session: &'s Session,
    pub(crate) change: &'s ValueChange,
}

impl<'s> ChangedValue<'s> {
    /// A change by the open shot, or by one under it.
    pub(crate) fn new(session: &'s Session, change: &'s ValueChange) -> Self {
        Self { session, change }
    }

    /// The change of a value of the open look or of the scene; `None` where no shot changes it.
    pub(crate) fn of(session: &'s Session, owner: Owner, target: &str) -> Option<Self> {
        Some(Self { session, change: session.change_by_shot(owner, target)? })
    }

    /// The changes of values of the open look, or of the scene, that stand.
    pub(crate) fn all(session: &'s Session, owner: Owner) -> impl Iterator<Item = Self> {
        let look = session.shot().and_then(|shot| shot.open_look());
        let changes = session.shot().map(|shot| shot.resolved().changes.as_slice());
        let is_of_owner = move |change: &&ValueChange| {
            change.stands
                && match owner {
                    Owner::Look => look.is_some() && change.look == look,
                    Owner::Scene => change.look.is_none(),
                }
        };
        let changes = changes.unwrap_or_default().iter().filter(is_of_owner);
        changes.map(move |change| Self { session, change })
    }

    /// The first of several values of the scene that a shot changes.
    pub(crate) fn any(session: &'s Session, targets: &[String]) -> Option<Self> {
        session.shot()?;
        targets.iter().find_map(|target| Self::of(session, Owner::Scene, target))
    }

    /// True if the open shot itself changes the value, and not one under it.
    pub(crate) fn is_own(self) -> bool {
        self.session.shot().is_some_and(|shot| shot.path() == self.change.by)
    }

    /// Name of the file that changes the value.
    pub(crate) fn by(self) -> String {
        let name = self.change.by.file_name();
        name.map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    }

    /// True if a shot under the open one changes the value, too.
    fn is_over_another(self) -> bool {
        let shot = self.session.shot();
        let changes = shot.map(|shot| shot.resolved().changes.as_slice()).unwrap_or_default();
        changes.iter().any(|other| {
            !other.stands
                && (&other.look, &other.target) == (&self.change.look, &self.change.target)
        })
    }

    /// The value in words: what has it, and what it is.
    pub(crate) fn name(self) -> String {
        let Some(look) = &self.change.look else {
            return scene_names::of(&self.change.target).join(": ");
        };
        let is_open = self.session.shot().and_then(OpenShot::open_look).as_ref() == Some(look);
        let target = Target::parse(&self.change.target).filter(|_| is_open);
        let value = match target {
            Some(target) => {
                let [owner, value] = self.session.look_with_library().names_of(&target);
                format!("{owner}: {}", seen_as(self.session, &target, value))
            }
            None => self.change.target.clone(),
        };
        let look = Path::new(look).file_stem().unwrap_or_default().to_string_lossy();
        format!("{look}: {value}")
    }

    /// Words for the reset of the value: the value that it brings back.
    pub(crate) fn reset_label(self) -> &'static str {
        match (self.is_over_another(), &self.change.look) {
            (true, _) => tr!("Reset to the sequence's"),
            (false, Some(_)) => tr!("Reset to the look's"),
            (false, None) => tr!("Reset to the scene's"),
        }
    }

    /// Sentence on the change.
    pub(crate) fn help(self) -> String {
        let (from, to) = change_text(self.session, self.change);
        let by = self.by();
        match self.change.is_keyed {
            true => tr!("keyed by {by}: {from} before, {to} now"),
            false => tr!("changed by {by}: {from} before, {to} now"),
        }
    }

    /// Shows the entries of a menu: a key, and apart from that the way back.
    pub(crate) fn menu(self, ui: &mut Ui, out: &mut Vec<Command>) {
        let at = ShotAddress::of(self.change);
        if at.can_move() {
            let help = tr!("Keeps the present value at this frame; at others it may be another");
            if ui.button(tr!("Key here")).on_hover_text(help).clicked() {
                out.push(Command::Scene(SceneCommand::Shot(ShotCommand::Key(at))));
                ui.close();
            }
            ui.separator();
        }
        self.reset(ui, out);
    }

    /// Shows the entry that takes the change back.
    pub(crate) fn reset(self, ui: &mut Ui, out: &mut Vec<Command>) {
        let reset = ui.add_enabled(self.is_own(), Button::new(self.reset_label()));
        let by = tr!("{shot} changes it: open that to take it back", shot = self.by());
        let reset = reset.on_hover_text(self.help()).on_disabled_hover_text(by);
        if reset.clicked() {
            let at = ShotAddress::of(self.change);
            out.push(Command::Scene(SceneCommand::Shot(ShotCommand::Reset(at))));
            ui.close();
        }
    }
}

/// Label of a value of the open look as fields show it: angles of one edge with the edge's name.
fn seen_as(session: &Session, target: &Target, label: String) -> String {
    match edge::is_of_edge(session, target) {
        true => tr!("{angle} (edge and softness)", angle = label),
        false => label,
    }
}

/// Values of one row, such as a node, a light or an object, that the open shot changes, each with
/// its label.
pub(crate) struct ChangedRow<'s>(Vec<(String, ChangedValue<'s>)>);

impl<'s> ChangedRow<'s> {
    /// Values of a node of the open look, and of the nodes within it.
    pub(crate) fn of_node(session: &'s Session, path: &NodePath) -> Self {
        let named = |changed: ChangedValue<'s>| {
            // A node's own fields, such as its switch, are told beside its inputs.
            if let Some(field) = changed.change.target.strip_prefix("nodes.") {
                let (node, field) = field.rsplit_once('.')?;
                return (NodePath::parse(node) == *path).then(|| (spoken(field), changed));
            }
            let target = Target::parse(&changed.change.target)?;
            let Target::Input { node, .. } = &target else { return None };
            let inner = node.ids().strip_prefix(path.ids())?;
            let [owner, value] = session.look_with_library().names_of(&target);
            let value = seen_as(session, &target, value);
            Some((if inner.is_empty() { value } else { format!("{owner}: {value}") }, changed))
        };
        Self(ChangedValue::all(session, Owner::Look).filter_map(named).collect())
    }

    /// Values of a light of the open look or of the scene.
    pub(crate) fn of_light(session: &'s Session, owner: Owner, id: &LightId) -> Self {
        let prefix = format!("lights.{id}.");
        let named = |changed: ChangedValue<'s>| {
            let field = changed.change.target.strip_prefix(&prefix)?;
            let port = Target::parse(&changed.change.target)
                .and_then(|target| session.look_with_library().port_at(&target));
            Some((
                port.map_or_else(|| spoken(field), |port| of_library(&port.label).to_owned()),
                changed,
            ))
        };
        Self(ChangedValue::all(session, owner).filter_map(named).collect())
    }

    /// Values of an object of the scene, and of the looks that it wears.
    pub(crate) fn of_object(session: &'s Session, id: &ObjectId) -> Self {
        let prefix = format!("objects.{id}.");
        let named = |changed: ChangedValue<'s>| {
            let target = &changed.change.target;
            let [_, label] = scene_names::of(target);
            target.starts_with(&prefix).then_some((label, changed))
        };
        let own = ChangedValue::all(session, Owner::Scene).filter_map(named);
        Self(own.chain(of_looks(session, id)).collect())
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Addition to the row's name for screen readers.
    pub(crate) fn word(&self) -> &'static str {
        if self.is_empty() { "" } else { tr!(", changed by the shot") }
    }

    /// Lines on all changes.
    pub(crate) fn help(&self) -> String {
        let line =
            |(label, changed): &(String, ChangedValue<'_>)| format!("{label} {}", changed.help());
        self.0.iter().map(line).collect::<Vec<_>>().join("\n")
    }

    /// Paints the bar at the left edge of the row, if anything of it is changed.
    pub(crate) fn bar(&self, ui: &Ui, row: Rect) {
        if !self.is_empty() {
            bar(ui, row);
        }
    }

    /// Shows an entry for each value in the row's menu, with the way back.
    pub(crate) fn menu(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        for (index, (label, changed)) in self.0.iter().enumerate() {
            ui.push_id(("changed by the shot", index), |ui| {
                let text = tr!("{label}, changed by the shot");
                let entry = ui.menu_button(text, |ui| changed.menu(ui, out));
                entry.response.on_hover_text(changed.help());
            });
        }
        if !self.is_empty() {
            ui.separator();
        }
    }
}

/// Values of the looks that an object wears, each with its label.
fn of_looks<'s>(
    session: &'s Session,
    id: &ObjectId,
) -> impl Iterator<Item = (String, ChangedValue<'s>)> {
    let scene = session.open_scene();
    let object = scene.and_then(|open_scene| open_scene.scene().objects.get(id));
    let names = object.into_iter().flat_map(|object| object.looks.values());
    let paths = scene.into_iter().flat_map(|open_scene| {
        let path = |name: &String| ResolvedShot::name_of_look(&open_scene.path_of(name));
        names.clone().map(path).collect::<Vec<String>>()
    });
    let worn: Vec<String> = paths.collect();
    let changes = session.shot().map(|shot| shot.resolved().changes.as_slice());
    changes.unwrap_or_default().iter().filter_map(move |change| {
        let look = change.look.as_ref().filter(|look| change.stands && worn.contains(look))?;
        let look = Path::new(look).file_stem().unwrap_or_default().to_string_lossy();
        let label = tr!("{value} of the look {look}", value = change.target);
        Some((label, ChangedValue { session, change }))
    })
}

/// Paints the bar of a changed value at the left edge of an area.
pub(crate) fn bar(ui: &Ui, area: Rect) {
    let left = Rect::from_min_size(area.min, vec2(2.5, area.height())).shrink2(vec2(0.0, 2.0));
    ui.painter().rect_filled(left, 1.0, theme::of(ui).second);
}

/// Shows the mark of values of the scene in the room before a label, with its menu; room alone
/// where no shot changes them. `label` names the value.
pub(crate) fn mark(
    ui: &mut Ui,
    size: Vec2,
    session: &Session,
    targets: &[String],
    label: &str,
    out: &mut Vec<Command>,
) {
    let Some(first) = ChangedValue::any(session, targets) else {
        if session.shot().is_none() {
            ui.allocate_exact_size(size, Sense::hover());
            return;
        }
        return unchanged(ui, size, targets, label, out);
    };
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let name = tr!("Changed by the shot: {label}");
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    bar(ui, rect);
    if first.change.is_keyed {
        let ink = theme::of(ui).accent;
        let fill = if is_key_here(session, first.change) { ink } else { Color32::TRANSPARENT };
        mark::diamond(ui, rect.center(), 4.5, fill, ink);
    }
    let all: Vec<ChangedValue<'_>> = targets
        .iter()
        .filter_map(|target| ChangedValue::of(session, Owner::Scene, target))
        .collect();
    Popup::menu(&response).show(|ui| {
        for changed in &all {
            if all.len() > 1 {
                ui.label(egui::RichText::new(&changed.change.target).small());
            }
            changed.menu(ui, out);
        }
    });
    response.on_hover_text(first.help());
}

/// True if the shot's own keys of a value have one at the playhead.
fn is_key_here(session: &Session, change: &ValueChange) -> bool {
    let shot = session.shot();
    let own = shot.and_then(|shot| Some((shot.own(&ShotAddress::of(change))?, shot.rate())));
    own.is_some_and(|(own, rate)| {
        let now = rate.frame_within(session.view.time);
        key_at(&own.keys, now).is_some()
    })
}

/// Mark of values that the shot does not change: a press keys the only one, or asks which.
fn unchanged(ui: &mut Ui, size: Vec2, targets: &[String], label: &str, out: &mut Vec<Command>) {
    let address = |target: &String| ShotAddress { look: None, target: target.clone() };
    let addresses: Vec<ShotAddress> = targets.iter().map(address).collect();
    if !addresses.iter().all(ShotAddress::can_move) {
        ui.allocate_exact_size(size, Sense::hover());
        return;
    }
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let name = tr!("Keys of the shot: {label}");
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    let colors = theme::of(ui);
    let is_at = response.hovered() || response.has_focus();
    let edge = if is_at { colors.text } else { colors.dim.gamma_multiply(0.7) };
    mark::diamond(ui, rect.center(), 4.5, Color32::TRANSPARENT, edge);
    let mut key = |at: &ShotAddress| {
        out.push(Command::Scene(SceneCommand::Shot(ShotCommand::Key(at.clone()))));
    };
    if let [only] = addresses.as_slice() {
        if response.clicked() {
            key(only);
        }
    } else {
        Popup::menu(&response).show(|ui| {
            for at in &addresses {
                let field = at.target.rsplit('.').next().unwrap_or(&at.target);
                if ui.button(tr!("Key {field} at this frame")).clicked() {
                    key(at);
                    ui.close();
                }
            }
        });
    }
    response.on_hover_text(tr!("As the scene has it; a press keys it in the shot"));
}

#[cfg(test)]
mod tests {
    use eframe::egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput, pos2};

    use super::*;

    /// Commands of a click on the mark of values that no shot changes.
    fn clicked(targets: &[&str]) -> Vec<Command> {
        let targets: Vec<String> = targets.iter().map(|&target| target.to_owned()).collect();
        let (ctx, mut out) = (Context::default(), Vec::new());
        let mut frame = |events| {
            let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(200.0, 100.0)));
            let input = RawInput { events, screen_rect, ..RawInput::default() };
            let mut place = Rect::ZERO;
            let output = ctx.run_ui(input, |ui| {
                place = Rect::from_min_size(ui.cursor().min, vec2(16.0, 16.0));
                unchanged(ui, place.size(), &targets, "Place", &mut out);
            });
            output.drop_without_applying_deltas();
            place
        };
        let pos = frame(Vec::new()).center();
        assert_ne!(pos, pos2(0.0, 0.0));
        frame(vec![Event::PointerMoved(pos)]);
        for pressed in [true, false] {
            let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
            frame(vec![Event::PointerButton { pos, button, pressed, modifiers }]);
        }
        frame(Vec::new());
        out
    }

    #[test]
    fn a_click_keys_the_only_value_of_a_mark_and_asks_among_several() {
        let target = "objects.cat.transform.translate";
        let at = ShotAddress { look: None, target: target.to_owned() };
        let key = Command::Scene(SceneCommand::Shot(ShotCommand::Key(at)));
        assert_eq!(clicked(&[target]), [key]);
        assert_eq!(clicked(&[target, "objects.cat.transform.rotate"]), []);
        assert_eq!(clicked(&["objects.cat.mesh"]), [], "a mesh does not move");
    }
}
