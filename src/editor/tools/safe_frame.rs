//! Frame of the shot's picture: what `chiaro render` draws of the shot, in a panel of another form.
//!
//! Cameras have their height of view. So a panel that is wider than the shot shows more at both
//! sides, which is dimmed; in a narrower one the picture gets less height, and is the frame itself.

use chiaro_locale::tr;
use eframe::egui::{Color32, Rect, Stroke, StrokeKind, Ui, Vec2, vec2};

use super::PictureTools;
use super::table::{PictureContext, SwitchPlace, ToolRow};
use crate::state::session::Session;

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Options,
    |_| Box::new(SafeFrame { is_on: true }),
    |tools| tools.of::<SafeFrame>().is_on,
    |tools, ui, _| {
        let help = tr!(
            "Frames what the shot shows in its own size, and dims what lies outside; for shots \
             that say a size"
        );
        let is_on = &mut tools.of_mut::<SafeFrame>().is_on;
        ui.checkbox(is_on, tr!("Frame of the shot")).on_hover_text(help);
    },
)
.with_overlay(|tools, ui, context, _| show(tools, ui, context));

/// Opacity of what lies outside, of 255, and of the line around the frame.
const DIM: u8 = 130;
const LINE: u8 = 110;
/// Difference of sides, in points, up to which the frame is the whole picture.
const SAME: f32 = 1.5;

/// State of the switch.
pub(crate) struct SafeFrame {
    pub(crate) is_on: bool,
}

impl SafeFrame {
    /// Place of the picture in the room of its panel: less high where the shot is wider than that.
    pub(crate) fn place(&self, room: Rect, session: &Session) -> Rect {
        let aspect = aspect_of(session).filter(|_| self.is_on);
        match aspect.map(|aspect| room.width() / aspect).filter(|height| *height < room.height()) {
            Some(height) => {
                // Whole points, so that the picture is drawn in as many pixels as it is shown in.
                let height = height.round().max(1.0);
                let top = (room.center().y - 0.5 * height).round();
                Rect::from_min_size(
                    eframe::egui::pos2(room.left(), top),
                    vec2(room.width(), height),
                )
            }
            None => room,
        }
    }

    /// The frame within the picture; `None` where no shot says a size.
    fn of(&self, picture: Rect, session: &Session) -> Option<Rect> {
        let aspect = aspect_of(session).filter(|_| self.is_on)?;
        let width = (picture.height() * aspect).min(picture.width());
        Some(Rect::from_center_size(picture.center(), Vec2::new(width, picture.height())))
    }
}

/// Width of the shot's picture, in heights.
fn aspect_of(session: &Session) -> Option<f32> {
    let [width, height] = session.shot()?.stack().size()?;
    Some(width.max(1) as f32 / height.max(1) as f32)
}

fn show(tools: &PictureTools, ui: &Ui, context: &PictureContext<'_>) {
    let (picture, session) = (context.rect, context.session);
    let Some(frame) = tools.of::<SafeFrame>().of(picture, session) else { return };
    let painter = ui.painter_at(picture);
    if picture.width() - frame.width() > SAME {
        let dim = Color32::from_black_alpha(DIM);
        for side in [picture.left()..=frame.left(), frame.right()..=picture.right()] {
            painter.rect_filled(Rect::from_x_y_ranges(side, picture.y_range()), 0.0, dim);
        }
    }
    let stroke = Stroke::new(1.0, Color32::from_white_alpha(LINE));
    painter.rect_stroke(frame, 0.0, stroke, StrokeKind::Inside);
}
