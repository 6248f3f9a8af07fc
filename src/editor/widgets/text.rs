//! Lines of text: a hint in place of missing content, a cell that is cut where it is too long, and
//! a field for texts with a form of their own.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Id, Label, Response, RichText, TextEdit, Ui, WidgetText};

use super::theme;

/// Shows a line in place of content that does not exist yet.
pub(crate) fn hint(ui: &mut Ui, text: &str) {
    ui.label(egui::RichText::new(text).color(theme::of(ui).dim));
}

/// Shows a text that is cut after so many lines; the whole of it is up to the help.
pub(crate) fn in_lines(ui: &mut Ui, text: RichText, lines: usize) -> Response {
    let style = egui::FontSelection::Default;
    let job = WidgetText::from(text).into_layout_job(ui.style(), style, egui::Align::Center);
    let mut job = Arc::unwrap_or_clone(job);
    job.wrap.max_rows = lines;
    ui.add(Label::new(job).show_tooltip_when_elided(false))
}

/// Shows a field for a value that has a form as text. A text of that form takes effect while it is
/// typed; any other waits in the field with the reason below it, and is given up when the keyboard
/// leaves. Returns the new value with the id of the widget.
pub(crate) fn formed<T: PartialEq>(
    ui: &mut Ui,
    label: Id,
    current: &T,
    text_of: impl Fn(&T) -> String,
    read: impl Fn(&str) -> Result<T, String>,
) -> Option<(Id, T)> {
    let id = label.with("text");
    let has_focus = ui.memory(|memory| memory.has_focus(id));
    let typed = ui.data(|data| data.get_temp::<String>(id)).filter(|_| has_focus);
    // Undo may have taken the value back while the keyboard is here.
    let is_now = |typed: &String| read(typed).map_or(true, |value| value == *current);
    let mut text = typed.filter(is_now).unwrap_or_else(|| text_of(current));
    let is_formed = read(&text).is_ok();
    let colors = theme::of(ui);
    let ink = if is_formed { colors.text } else { colors.error };
    ui.vertical(|ui| {
        let edit = TextEdit::singleline(&mut text).id(id).hint_text(tr!("none")).text_color(ink);
        let response = ui.add(edit.desired_width(f32::INFINITY)).labelled_by(label);
        if response.lost_focus() {
            ui.data_mut(|data| data.remove::<String>(id));
        } else if response.changed() {
            ui.data_mut(|data| data.insert_temp(id, text.clone()));
        }
        match read(&text) {
            Ok(value) => response.changed().then_some((id, value)),
            Err(why) => {
                ui.label(RichText::new(why).small().color(theme::of(ui).error));
                None
            }
        }
    })
    .inner
}

/// Paints text in a column of a row, cut where it is too long.
pub(crate) fn cell(
    ui: &Ui,
    rect: egui::Rect,
    text: &str,
    font: egui::FontId,
    color: egui::Color32,
) {
    let mut job = egui::text::LayoutJob::single_section(
        text.to_owned(),
        egui::text::TextFormat { font_id: font, color, ..egui::text::TextFormat::default() },
    );
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width().max(0.0));
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let at = egui::pos2(rect.left(), rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, color);
}
