//! Cost of the picture that is shown, in a corner of it: milliseconds, and passes by number.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{
    Align2, Color32, CursorIcon, FontId, Galley, Rect, Role, Sense, Ui, WidgetInfo, vec2,
};

use super::picture::ViewportPicture;
use crate::commands::{Command, PanelId};
use crate::state::picture_cost::PictureCost;
use crate::widgets::theme;

/// Distance from the corner, in points.
const MARGIN: f32 = 6.0;
/// Smallest picture with a readout, in points.
const LEAST: [f32; 2] = [180.0, 90.0];

/// Text of the readout, and its place in the corner; `None` in a small picture.
fn laid_out(ui: &Ui, rect: Rect, picture: &ViewportPicture) -> Option<(Arc<Galley>, Rect)> {
    let has_room = rect.width() >= LEAST[0] && rect.height() >= LEAST[1];
    if picture.is_covered || picture.cost().passes.is_empty() || !has_room {
        return None;
    }
    let font = FontId::proportional(theme::SMALL_TEXT);
    let galley = ui.painter().layout_no_wrap(picture.cost().short(), font, theme::of(ui).dim);
    let at = rect.right_bottom() - vec2(MARGIN, MARGIN);
    let place = Align2::RIGHT_BOTTOM.anchor_size(at, galley.size()).expand2(vec2(4.0, 2.0));
    Some((galley, place))
}

/// Room that the readout takes of the picture's lower edge, in points.
pub(super) fn width(ui: &Ui, rect: Rect, picture: &ViewportPicture) -> f32 {
    laid_out(ui, rect, picture).map_or(0.0, |(_, place)| place.width() + MARGIN)
}

/// Shows the cost of the picture that was drawn last; a click opens the panel about it.
pub(super) fn show(ui: &Ui, rect: Rect, picture: &ViewportPicture, out: &mut Vec<Command>) {
    let Some((galley, place)) = laid_out(ui, rect, picture) else { return };
    let (cost, colors) = (picture.cost(), theme::of(ui));
    let text = cost.short();
    let response = ui.interact(place, ui.scope_id().with("cost of the picture"), Sense::click());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Button, true, tr!("Cost of the picture: {text}"))
    });
    let ground = if response.hovered() { 190 } else { 120 };
    ui.painter().rect_filled(place, 3.0, Color32::from_black_alpha(ground));
    ui.painter().galley(place.shrink2(vec2(4.0, 2.0)).min, galley, colors.dim);
    if response.on_hover_cursor(CursorIcon::PointingHand).on_hover_text(help(cost)).clicked() {
        out.push(Command::ShowPanel(PanelId::COST));
    }
}

fn help(cost: &PictureCost) -> String {
    let [width, height] = cost.size;
    let mut text = tr!(
        "The picture of now, {width} by {height} pixels. Its time is from when it was handed to \
         the GPU until the GPU was done, by the clock on the wall."
    );
    for pass in &cost.passes {
        text += &format!("\n{}: {}", pass.label(), pass.words());
    }
    text + "\n" + tr!("A click tells what each layer costs, and why passes are needed.")
}
