//! List of all problems, worst first: the problem, its place (a click leads there), hints, and a
//! button for the fix where one edit is enough. The status bar shows their number and the first of
//! them.

use chiaro_locale::{text, tr, tr_in, trn};
use eframe::egui;
use eframe::egui::{
    Label, Pos2, Response, RichText, Role, ScrollArea, Sense, Shape, Stroke, Ui, WidgetInfo, pos2,
    vec2,
};

use crate::commands::{Command, PanelId};
use crate::diag::{Diagnostic, Severity};
use crate::document::Target;
use crate::panels::table::{PanelPlace, PanelRow, Presence};
use crate::state::fixes;
use crate::state::problem_text::labelled;
use crate::state::session::Session;
use crate::widgets::text::hint;
use crate::widgets::theme::{self, Colors};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::PROBLEMS,
    text!("Problems"),
    text!("What is wrong, where, and what mends it"),
    PanelPlace::BELOW_PICTURE,
    |_, ui, context| show(ui, context.session),
)
.with_each_frame(|_, _, session, presence| {
    let is_read = presence == Presence::Seen && session.has_unread_notes();
    is_read.then_some(Command::ReadNotes).into_iter().collect()
});

/// Largest number of problems that are listed; fixing those shows the others.
const MAX_LISTED: usize = 100;
/// Severities, worst first.
const SEVERITIES: [Severity; 3] = [Severity::Error, Severity::Warning, Severity::Note];

/// Lists all problems.
pub(crate) fn show(ui: &mut Ui, session: &Session) -> Vec<Command> {
    let mut sorted: Vec<&Diagnostic> = session.all_problems().collect();
    if sorted.is_empty() {
        hint(
            ui,
            tr!("No problems. What is wrong with the look, its file or its mesh is listed here."),
        );
        return Vec::new();
    }
    sorted.sort_by_key(|problem| std::cmp::Reverse(problem.severity));
    let mut out = Vec::new();
    ui.horizontal(|ui| {
        counts(ui, &sorted);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui
                .button(tr!("Copy all"))
                .on_hover_text(tr!("Copies the list as text, to ask somebody"))
                .clicked()
            {
                let lines: Vec<String> = sorted.iter().map(ToString::to_string).collect();
                out.push(Command::Copy(lines.join("\n")));
            }
        });
    });
    ui.separator();
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        for (index, problem) in sorted.iter().take(MAX_LISTED).enumerate() {
            ui.push_id(index, |ui| row(ui, session, problem, &mut out));
        }
        if sorted.len() > MAX_LISTED {
            let more = sorted.len() - MAX_LISTED;
            hint(ui, &tr!("and {more} more, listed once these are mended"));
        }
    });
    out
}

fn row(ui: &mut Ui, session: &Session, problem: &Diagnostic, out: &mut Vec<Command>) {
    ui.horizontal_top(|ui| {
        mark(ui, problem.severity);
        let mended = fixes::of(session, problem).into_iter().next();
        let width = ui.available_width() - if mended.is_some() { 150.0 } else { 10.0 };
        ui.vertical(|ui| {
            ui.set_width(width.max(120.0));
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing.x = 5.0;
                place(ui, session, problem, out);
                let message = labelled(session.look_with_library(), problem, &problem.message);
                ui.label(message).on_hover_text(tr!("Code {code}", code = problem.code));
            });
            // A hint is left out where the button offers the same fix.
            let offered = problem.suggestion.filter(|_| mended.is_some());
            let hints = problem.hints.iter().enumerate();
            for (_, hint) in hints.filter(|(index, _)| Some(*index) != offered) {
                let hint = labelled(session.look_with_library(), problem, hint);
                ui.label(RichText::new(hint).small().color(theme::of(ui).dim));
            }
        });
        if let Some(fix) = mended {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Min), |ui| {
                ui.add_space(10.0);
                let button = egui::Button::new(&fix.label).truncate();
                let help = tr!("{help}. Undo takes it back.", help = fix.help);
                if ui.add(button).on_hover_text(help).clicked() {
                    out.push(Command::Edit(fix.edit));
                }
            });
        }
    });
    ui.add_space(4.0);
}

/// Titles of a problem's node along its path, with the label of the port.
fn node_and_port(session: &Session, problem: &Diagnostic) -> Option<String> {
    let (path, look) = (problem.place.node.as_ref()?, session.look_with_library());
    let text = look.title_of_path(path);
    let Some(port) = &problem.place.port else { return Some(text) };
    let target = Target::Input { node: path.clone(), port: port.clone() };
    let label = look.port_at(&target).map(|port| tr_in("node", &port.label).to_owned());
    Some(format!("{text}: {}", label.unwrap_or_else(|| port.to_string())))
}

/// File of a problem, with its line and column there.
fn file_and_line(problem: &Diagnostic) -> Option<String> {
    let line = problem.place.at.map(|at| {
        let (line, column) = (at.line, at.column);
        tr!("line {line}, column {column}")
    });
    let parts = problem.place.file.iter().cloned().chain(line);
    Some(parts.collect::<Vec<String>>().join(", ")).filter(|place| !place.is_empty())
}

/// All that is known of a problem: where it is, what is wrong and what mends it.
fn whole(session: &Session, problem: &Diagnostic) -> String {
    let look = session.look_with_library();
    let place = node_and_port(session, problem);
    let message = labelled(look, problem, &problem.message);
    let hints = problem.hints.iter().map(|hint| labelled(look, problem, hint));
    let lines = place.into_iter().chain(file_and_line(problem)).chain([message]).chain(hints);
    lines.collect::<Vec<String>>().join("\n")
}

/// Shows the place of a problem: a node that a click leads to, or a line of a file.
fn place(ui: &mut Ui, session: &Session, problem: &Diagnostic, out: &mut Vec<Command>) {
    if let Some(path) = &problem.place.node
        && let Some(node) = path.outermost()
        && let Some(text) = node_and_port(session, problem)
    {
        let title = session.look_with_library().title(node);
        let link = ui.link(RichText::new(text).color(theme::of(ui).accent));
        if link.on_hover_text(tr!("Selects {title} and brings it into view")).clicked() {
            out.push(Command::Show(path.clone()));
        }
    }
    if let (Some(at), Some(place)) = (problem.place.at, file_and_line(problem)) {
        let line = at.line;
        ui.label(RichText::new(tr!("line {line}")).color(theme::of(ui).dim)).on_hover_text(place);
    }
}

fn counted(severity: Severity, count: usize) -> String {
    match severity {
        Severity::Error => trn!(count, "{count} error", "{count} errors"),
        Severity::Warning => trn!(count, "{count} warning", "{count} warnings"),
        Severity::Note => trn!(count, "{count} note", "{count} notes"),
    }
}

fn color(severity: Severity, colors: &Colors) -> egui::Color32 {
    match severity {
        Severity::Error => colors.error,
        Severity::Warning => colors.warning,
        Severity::Note => colors.dim,
    }
}

/// Shows the mark of a severity, told by shape as well as by color.
fn mark(ui: &mut Ui, severity: Severity) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(14.0, 18.0), Sense::hover());
    let (at, ink) = (rect.center(), color(severity, theme::of(ui)));
    let ground = theme::of(ui).panel;
    let bar = |ui: &Ui, from: Pos2, to: Pos2| {
        ui.painter().line_segment([from, to], Stroke::new(1.6, ground))
    };
    match severity {
        Severity::Error => {
            ui.painter().circle_filled(at, 6.0, ink);
            bar(ui, at - vec2(2.2, 2.2), at + vec2(2.2, 2.2));
            bar(ui, at + vec2(-2.2, 2.2), at + vec2(2.2, -2.2));
        }
        Severity::Warning => {
            let corners = vec![at + vec2(0.0, -6.0), at + vec2(6.5, 5.5), at + vec2(-6.5, 5.5)];
            ui.painter().add(Shape::convex_polygon(corners, ink, Stroke::NONE));
            bar(ui, at - vec2(0.0, 2.5), at + vec2(0.0, 1.8));
        }
        Severity::Note => drop(ui.painter().circle_stroke(at, 5.0, Stroke::new(1.6, ink))),
    }
    response
}

/// Shows the number of problems of each severity.
fn counts(ui: &mut Ui, problems: &[&Diagnostic]) {
    for severity in SEVERITIES {
        let count = problems.iter().filter(|problem| problem.severity == severity).count();
        if count > 0 {
            mark(ui, severity);
            let ink = color(severity, theme::of(ui));
            let text = RichText::new(counted(severity, count)).color(ink);
            ui.add(Label::new(text).selectable(false));
        }
    }
}

/// Shows the number of problems, and the worst in words, for the status bar, but for notes that
/// were read in the panel. A click opens the panel.
pub(crate) fn status(ui: &mut Ui, session: &Session) -> Option<Command> {
    let problems: Vec<&Diagnostic> = session.unread_problems().collect();
    // `max_by_key` takes the last of equals, so that the reversed order gives the first of the
    // worst.
    let first = problems.iter().rev().max_by_key(|problem| problem.severity)?;
    let start = ui.cursor().min;
    let room = ui.available_width() * 0.6;
    let shown = ui.scope(|ui| {
        ui.set_max_width(room);
        counts(ui, &problems);
        let look = session.look_with_library();
        let node = first.place.node.as_ref();
        let node = node.map(|path| format!("{}: ", look.title_of_path(path))).unwrap_or_default();
        let text = format!("{node}{}", labelled(look, first, &first.message));
        ui.add(Label::new(text).selectable(false).truncate());
    });
    let rect = shown
        .response
        .rect
        .union(egui::Rect::from_min_size(pos2(start.x, start.y), vec2(1.0, 1.0)));
    let response = ui.interact(rect, ui.scope_id().with("problems"), Sense::click());
    response
        .widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Open the list of problems")));
    if response.has_focus() || response.hovered() {
        ui.painter().hline(rect.x_range(), rect.bottom(), Stroke::new(1.0, theme::of(ui).accent));
    }
    ui.separator();
    let clicked = response.clicked();
    let help = tr!("Lists all problems, with what mends them");
    response
        .on_hover_cursor(egui::CursorIcon::PointingHand)
        .on_hover_text(format!("{}\n\n{help}", whole(session, first)));
    clicked.then_some(Command::ShowPanel(PanelId::PROBLEMS))
}
