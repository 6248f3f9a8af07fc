//! The picture itself, or a stand-in.

use chiaro_locale::tr;
use eframe::egui::{self, Rect, TextureHandle, Ui, vec2};

use super::picture::ViewportPicture;
use crate::state::session::Session;
use crate::tools::playback::paint::{fit, paint_exposed};
use crate::tools::probe::picture_size;
use crate::widgets::theme;

pub(super) fn show_picture(
    ui: &Ui,
    rect: Rect,
    session: &Session,
    picture: &mut ViewportPicture,
    turns: bool,
    stops: f32,
) {
    let size = picture_size(rect, ui.pixels_per_point());
    let (is_held, dt) = ui.input(|input| (input.pointer.any_down(), input.unstable_dt));
    match picture.update(session, size, is_held || turns, dt) {
        Some(texture) => {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
            paint_exposed(&ui.painter_at(rect), texture, picture.place(rect), stops);
        }
        None => {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
            let font = egui::FontId::proportional(theme::TEXT_SIZE);
            let is_broken = !picture.problems.is_empty()
                || crate::diag::has_errors(session.compilation().problems());
            let text = match session.journals.held() {
                Some(_) => tr!("Not drawn until you press Try again above"),
                None if is_broken => tr!("No picture: Problems says what is to be mended"),
                None => tr!("Making the first picture"),
            };
            ui.painter().text(
                rect.center(),
                egui::Align2::CENTER_CENTER,
                text,
                font,
                theme::of(ui).dim,
            );
        }
    }
}

/// Shows a frame in place of the picture; one of another shape is fit in.
pub(super) fn show_frame(ui: &Ui, rect: Rect, frame: &TextureHandle, stops: f32) {
    ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
    let place = fit(rect, frame.size_vec2());
    paint_exposed(&ui.painter_at(rect), frame.id(), place, stops);
}

/// Draws a ball where there is no GPU, so that the camera and the lights can still be turned.
pub(super) fn stand_in(ui: &Ui, rect: Rect, session: &Session) {
    let radius = session.view.orbit.radius_in_picture() as f32 * rect.height();
    ui.painter().circle(
        rect.center(),
        radius,
        theme::of(ui).node,
        egui::Stroke::new(1.0, theme::of(ui).grid),
    );
    let font = egui::FontId::proportional(theme::TEXT_SIZE);
    let text = tr!("This window has no GPU to draw with").to_owned();
    let dim = theme::of(ui).dim;
    let mut text = egui::text::LayoutJob::simple(text, font, dim, rect.width() - 12.0);
    text.halign = egui::Align::Center;
    let text = ui.painter().layout_job(text);
    let at = rect.center_bottom() - vec2(0.0, 12.0 + text.size().y);
    // A picture that is lower than the text is one of a few pixels: the bars around it go first.
    if at.y >= rect.top() {
        ui.painter().galley(at, text, dim);
    }
}
