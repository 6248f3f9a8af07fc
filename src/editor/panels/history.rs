//! History of the document: every step by its name in undo; a click goes to the state after that
//! step.

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use eframe::egui::{
    EventFilter, FontId, Key, Modifiers, Role, ScrollArea, Sense, Ui, WidgetInfo, pos2, vec2,
};

use crate::commands::{Command, PanelId};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::problem_text::step_labelled;
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;
use crate::widgets::rows::{leave_with_pointer, row_ground, undo_keys};
use crate::widgets::text::cell;
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::HISTORY,
    text!("History"),
    text!("Everything that was done; a click goes there and back"),
    PanelPlace::WITH_DOCUMENT,
    |bench, ui, context| bench.memory.of::<History>().show(ui, context.session),
);

const ROW: f32 = 22.0;

/// The panel, and the place that it showed last.
#[derive(Default)]
pub(crate) struct History {
    shown: Option<(DocumentNumber, usize)>,
}

impl History {
    /// Lists the steps, the first at the top; steps that were undone are dim.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let labels: Vec<&str> = session.steps().labels().collect();
        let place = session.steps().done();
        let mut out = Vec::new();
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut area = ScrollArea::vertical().auto_shrink([false, false]);
        let is_new = self.shown != Some((session.revisions().document, place));
        let height = ui.available_height();
        self.shown = Some((session.revisions().document, place));
        if is_new {
            area = area.vertical_scroll_offset(((place as f32 + 1.5) * ROW - height).max(0.0));
        }
        area.show_rows(ui, ROW, labels.len() + 1, |ui, rows| {
            for index in rows {
                let label = match index.checked_sub(1) {
                    Some(step) => step_labelled(session.look_with_library(), labels[step]),
                    None if session.path().is_some() => tr!("Opened").to_owned(),
                    None => tr!("New look").to_owned(),
                };
                row(ui, index, place, &label, labels.len(), &mut out);
            }
        });
        out
    }
}

fn row(ui: &mut Ui, index: usize, place: usize, label: &str, last: usize, out: &mut Vec<Command>) {
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width() - 8.0, ROW), Sense::click());
    let (is_here, is_undone) = (index == place, index > place);
    let name = tr!("Step {index}: {label}");
    response.widget_info(|| WidgetInfo::selected(Role::ListItem, true, is_here, &name));
    row_ground(ui, rect, &response, is_here);
    let colors = theme::of(ui);
    let dot = pos2(rect.left() + 9.0, rect.center().y);
    ui.painter().vline(dot.x, rect.y_range(), egui::Stroke::new(1.0, colors.grid));
    match (is_here, is_undone) {
        (true, _) => drop(ui.painter().circle_filled(dot, 4.0, colors.accent)),
        (false, false) => drop(ui.painter().circle_filled(dot, 2.5, colors.dim)),
        (false, true) => {
            ui.painter().circle(dot, 2.5, colors.panel, egui::Stroke::new(1.0, colors.dim));
        }
    }
    let text =
        egui::Rect::from_min_max(pos2(rect.left() + 20.0, rect.top()), rect.max - vec2(4.0, 0.0));
    let mut letters = label.chars();
    let first = letters.next().map(char::to_uppercase).into_iter().flatten();
    let shown: String = first.chain(letters).collect();
    let ink = if is_undone { colors.dim } else { colors.text };
    cell(ui, text, &shown, FontId::proportional(theme::TEXT_SIZE), ink);
    leave_with_pointer(ui, &response);
    if response.has_focus() {
        let filter = EventFilter { vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        if pressed(Key::ArrowUp) && place > 0 {
            out.push(Command::GoTo(place - 1));
        } else if pressed(Key::ArrowDown) && place < last {
            out.push(Command::GoTo(place + 1));
        }
        undo_keys(ui, out);
    }
    if response.clicked() {
        response.request_focus();
        out.push(Command::GoTo(index));
    }
    let help = match (is_here, is_undone) {
        (true, _) => tr!("The look is as it was after this step").to_owned(),
        (false, true) => trn!(
            steps = index - place,
            "Repeats {steps} step, this one. It is lost when something else is done.",
            "Repeats {steps} steps, up to this one. They are lost when something else is done."
        ),
        (false, false) => trn!(
            steps = place - index,
            "Takes back {steps} step, to what was after this one",
            "Takes back {steps} steps, to what was after this one"
        ),
    };
    response.on_hover_text(help);
}
