//! Sign that the picture of a document just opened is being made; the old picture fades behind it.
//! Quick pictures get no sign, so that nothing flickers, and the sign fades in slowly.

use std::time::Duration;

use chiaro_locale::tr;
use eframe::egui::{self, Align2, FontId, Rect, Role, Sense, Spinner, Ui, Vec2, WidgetInfo, vec2};

use crate::diag::has_errors;
use crate::state::session::Session;
use crate::viewport::picture::{MissingPicture, ViewportPicture};
use crate::widgets::theme;

/// Time for which no sign is shown, in seconds.
const CALM: f64 = 0.35;
/// Time in which the sign fades in, in seconds.
const FADE: f64 = 0.3;
/// Opacity of the veil over the old picture, 0 to 1.
const VEIL: f32 = 0.6;
/// Size of the sign, and of its wheel, in points.
const SIGN: Vec2 = vec2(340.0, 84.0);
const WHEEL: f32 = 22.0;

/// Time since which a picture is awaited, in seconds of the window's clock.
#[derive(Debug, Default)]
pub(super) struct PictureDelay {
    since: Option<f64>,
}

impl PictureDelay {
    /// Opacity of the sign, 0 to 1, and the time until it begins to show, in seconds.
    fn tell(&mut self, is_awaited: bool, now: f64) -> (f32, f64) {
        if !is_awaited {
            self.since = None;
            return (0.0, f64::INFINITY);
        }
        let age = now - *self.since.get_or_insert(now);
        (((age - CALM) / FADE).clamp(0.0, 1.0) as f32, (CALM - age).max(0.0))
    }

    /// Shows the sign over the picture, once a picture has been awaited for a while.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        session: &Session,
        picture: &ViewportPicture,
    ) {
        let awaited = picture.awaited(session);
        let is_made = matches!(awaited, Some(MissingPicture::Shader | MissingPicture::Picture));
        let (strength, calm) = self.tell(is_made, ui.input(|input| input.time));
        let name = session.name();
        if is_made && strength == 0.0 {
            return ui.ctx().request_repaint_after(Duration::from_secs_f64(calm.max(0.01)));
        }
        let text = tr!("Preparing {name}");
        match awaited {
            Some(MissingPicture::Shader) => {
                sign(ui, rect, strength, true, &text, tr!("building its shader"));
            }
            Some(MissingPicture::Picture) => {
                sign(ui, rect, strength, true, &text, tr!("reading meshes and paintings, drawing"));
            }
            Some(MissingPicture::Mended) if session.journals.held().is_some() => {
                sign(
                    ui,
                    rect,
                    1.0,
                    false,
                    tr!("Not drawn"),
                    tr!("until you press Try again above"),
                );
            }
            Some(MissingPicture::Mended) => {
                sign(
                    ui,
                    rect,
                    1.0,
                    false,
                    tr!("No picture yet"),
                    tr!("until what is listed below is mended"),
                );
            }
            None if has_errors(session.compilation().problems()) => stale(ui, rect),
            None => {}
        }
    }
}

/// Says over the picture that it is of the graph before its error.
fn stale(ui: &Ui, rect: Rect) {
    let text = tr!("Of the graph before the error");
    let colors = theme::of(ui);
    let painter = ui.painter().with_clip_rect(rect);
    let font = FontId::proportional(theme::TEXT_SIZE);
    let galley = painter.layout_no_wrap(text.to_owned(), font, colors.error);
    let size = galley.size() + vec2(20.0, 10.0);
    // Other tools lie along the edges of the picture.
    let middle = egui::pos2(rect.center().x, rect.top() + rect.height() * 0.2);
    let room = Rect::from_center_size(middle, size);
    painter.rect_filled(room, 4.0, colors.panel.gamma_multiply(0.92));
    let edge = egui::Stroke::new(1.0, colors.error);
    painter.rect_stroke(room, 4.0, edge, egui::StrokeKind::Inside);
    painter.galley(room.min + vec2(10.0, 5.0), galley, colors.error);
    let response = ui.interact(room, ui.scope_id().with("of before"), Sense::empty());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
}

fn sign(ui: &mut Ui, rect: Rect, strength: f32, turns: bool, text: &str, more: &str) {
    let colors = theme::of(ui);
    let painter = ui.painter().with_clip_rect(rect);
    painter.rect_filled(rect, 0.0, colors.canvas.gamma_multiply(VEIL * strength));
    let room = Rect::from_center_size(rect.center(), SIGN.min(rect.size()));
    painter.rect_filled(room, 6.0, colors.panel.gamma_multiply(0.9 * strength));
    let response = ui.interact(room, ui.scope_id().with("preparing"), Sense::empty());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    let left = room.left() + if turns { 24.0 + WHEEL + 16.0 } else { 24.0 };
    if turns {
        let wheel = egui::pos2(room.left() + 24.0 + WHEEL / 2.0, room.center().y);
        let wheel = Rect::from_center_size(wheel, Vec2::splat(WHEEL));
        Spinner::new().color(colors.accent.gamma_multiply(strength)).paint_at(ui, wheel);
    }
    let width = (room.right() - 16.0 - left).max(0.0);
    let line = |text: &str, font: FontId, color: egui::Color32| {
        let mut job = egui::text::LayoutJob::simple_singleline(
            text.to_owned(),
            font,
            color.gamma_multiply(strength),
        );
        job.wrap = egui::text::TextWrapping::truncate_at_width(width);
        painter.layout_job(job)
    };
    let first = line(text, FontId::proportional(theme::TEXT_SIZE + 2.0), colors.text);
    let second = line(more, FontId::proportional(theme::TEXT_SIZE), colors.dim);
    let gap = 2.0;
    let height = first.size().y + gap + second.size().y;
    let top =
        Align2::LEFT_CENTER.anchor_size(egui::pos2(left, room.center().y), vec2(width, height)).min;
    let below = top + vec2(0.0, first.size().y + gap);
    painter.galley(top, first, colors.text);
    painter.galley(below, second, colors.dim);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_quick_has_no_sign_and_what_is_slow_one_that_fades_in() {
        let mut preparing = PictureDelay::default();
        let mut at = |is_awaited, now| preparing.tell(is_awaited, now).0;
        assert_eq!([at(true, 10.0), at(true, 10.2), at(true, 10.0 + CALM)], [0.0; 3]);
        let half = at(true, 10.0 + CALM + FADE / 2.0);
        assert!((half - 0.5).abs() < 1e-6, "{half}");
        assert_eq!([at(true, 12.0), at(true, 60.0)], [1.0; 2], "as long as it takes");
        assert_eq!(at(false, 60.1), 0.0, "it goes at once");
        assert_eq!(at(true, 61.0), 0.0, "and the next one is as calm");
        assert_eq!(
            preparing.tell(true, 61.1).1,
            CALM - (61.1 - 61.0),
            "to be shown without anything that moves"
        );
    }
}
