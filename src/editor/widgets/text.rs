//! Lines of text: a hint in place of missing content, and a cell that is cut where it is too long.

use eframe::egui;
use eframe::egui::Ui;

use super::theme;

/// Shows a line in place of content that does not exist yet.
pub(crate) fn hint(ui: &mut Ui, text: &str) {
    ui.label(egui::RichText::new(text).color(theme::of(ui).dim));
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
