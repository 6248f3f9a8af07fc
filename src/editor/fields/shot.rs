//! Marks of values that the open shot changes: a bar beside the value, with what it was before, who
//! changes it, and the way back.

use eframe::egui;
use eframe::egui::{Button, Popup, Rect, Role, Sense, Ui, Vec2, WidgetInfo, vec2};

use crate::commands::{Command, SceneCommand, ShotCommand};
use crate::frame::ValueChange;
use crate::state::keying::Owner;
use crate::state::session::Session;
use crate::state::session::shot::change_text;
use crate::state::shot::ShotAddress;
use crate::widgets::theme;

/// A value of a document, with the change that a shot makes of it.
#[derive(Clone, Copy)]
pub(crate) struct ChangedValue<'s> {
    session: &'s Session,
    pub(crate) change: &'s ValueChange,
}

impl<'s> ChangedValue<'s> {
    /// The change of a value of the open look or of the scene; `None` where no shot changes it.
    pub(crate) fn of(session: &'s Session, owner: Owner, target: &str) -> Option<Self> {
        Some(Self { session, change: session.change_by_shot(owner, target)? })
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

    /// Words for the reset of the value: the value that it brings back.
    pub(crate) fn reset_label(self) -> &'static str {
        match (self.is_over_another(), &self.change.look) {
            (true, _) => "Reset to the sequence's",
            (false, Some(_)) => "Reset to the look's",
            (false, None) => "Reset to the scene's",
        }
    }

    /// Sentence on the change.
    pub(crate) fn help(self) -> String {
        let (from, to) = change_text(self.change);
        let word = if self.change.is_keyed { "keyed" } else { "changed" };
        format!("{word} by {}: {from} before, {to} now", self.by())
    }

    /// Shows the entries of a menu: the way back, and a key.
    pub(crate) fn menu(self, ui: &mut Ui, out: &mut Vec<Command>) {
        let mut push = |command| out.push(Command::Scene(SceneCommand::Shot(command)));
        let at = ShotAddress::of(self.change);
        let reset = ui.add_enabled(self.is_own(), Button::new(self.reset_label()));
        let by = format!("{} changes it: open that to take it back", self.by());
        let reset = reset.on_hover_text(self.help()).on_disabled_hover_text(by);
        if reset.clicked() {
            push(ShotCommand::Reset(at.clone()));
            ui.close();
        }
        let help = "Keeps the present value at this frame; at others it may be another";
        if ui.button("Key at this frame of the shot").on_hover_text(help).clicked() {
            push(ShotCommand::Key(at));
            ui.close();
        }
    }
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
    let name = format!("Changed by the shot: {label}");
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    bar(ui, rect);
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

/// Room for the mark of values that the shot does not change, with a menu to key them.
fn unchanged(ui: &mut Ui, size: Vec2, targets: &[String], label: &str, out: &mut Vec<Command>) {
    let (_, response) = ui.allocate_exact_size(size, Sense::click());
    let name = format!("Keys of the shot: {label}");
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    Popup::menu(&response).show(|ui| {
        for target in targets {
            let text = match targets.len() {
                1 => "Key at this frame of the shot".to_owned(),
                _ => format!("Key {} at this frame", target.rsplit('.').next().unwrap_or(target)),
            };
            if ui.button(text).clicked() {
                let at = ShotAddress { look: None, target: target.clone() };
                out.push(Command::Scene(SceneCommand::Shot(ShotCommand::Key(at))));
                ui.close();
            }
        }
    });
    response.on_hover_text("As the scene has it; a press keys it in the shot");
}
