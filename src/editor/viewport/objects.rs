//! Objects of a scene in the picture: the object under the pointer, selection by clicks, and
//! unobtrusive marks.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Align2, FontId, Pos2, Rect, Stroke, Ui, pos2, vec2};

use super::place_in;
use super::surface::{ObjectPart, Surface};
use crate::commands::{Command, SceneCommand};
use crate::frame::look_of;
use crate::ids::ObjectId;
use crate::state::scene::file_label;
use crate::state::session::Session;
use crate::widgets::theme;

/// Length of a corner's lines, in points.
const CORNER: f32 = 10.0;

/// Object under the pointer.
pub(super) struct HoveredObject {
    piece: ObjectPart,
    /// Name of the object's look.
    look: String,
}

impl HoveredObject {
    pub(super) fn object(&self) -> &ObjectId {
        &self.piece.object
    }

    /// Hint on the object.
    pub(super) fn hint(&self) -> String {
        let Self { piece: ObjectPart { object, is_open, .. }, look } = self;
        let text = match is_open {
            true => tr!("{object} wears the open look"),
            false => tr!("{object} wears {look}: a click opens it"),
        };
        text + " · "
    }
}

/// Width of a picture, in heights.
pub(super) fn aspect(rect: Option<Rect>) -> f64 {
    rect.filter(|rect| rect.is_positive())
        .map_or(1.0, |rect| f64::from(rect.width() / rect.height()))
}

/// Object of a scene under the pointer.
pub(super) fn seen(
    session: &Session,
    surface: Option<&Surface>,
    rect: Rect,
    pointer: Option<Pos2>,
) -> Option<HoveredObject> {
    let open_scene = session.open_scene()?;
    let piece = surface?.piece_at(place_in(rect, pointer?))?.clone();
    let look =
        look_of(open_scene.scene().objects.get(&piece.object)?, &piece.material).map(file_label)?;
    Some(HoveredObject { piece, look })
}

/// Command of a click: selects the object under the pointer, with its look, or nothing.
pub(super) fn pick(
    session: &Session,
    surface: Option<&Surface>,
    seen: Option<&HoveredObject>,
) -> Option<Command> {
    session.open_scene().filter(|_| surface.is_some())?;
    Some(Command::Scene(match seen {
        Some(HoveredObject { piece, .. }) => {
            SceneCommand::Pick(piece.object.clone(), Some(piece.material.clone()))
        }
        None => SceneCommand::Unselect,
    }))
}

/// Marks the selected object by corners around it, and names the one under the pointer.
pub(super) fn paint(
    ui: &Ui,
    rect: Rect,
    session: &Session,
    surface: Option<&Surface>,
    seen: Option<&HoveredObject>,
) {
    let (Some(open_scene), Some(surface)) = (session.open_scene(), surface) else { return };
    let around = |id: &ObjectId| {
        let corners = surface.box_of(id)?;
        let on_screen =
            |[x, y]: [f32; 2]| pos2(rect.left() + x * rect.width(), rect.top() + y * rect.height());
        Some(
            Rect::from_two_pos(on_screen(corners[0]), on_screen(corners[1]))
                .expand(4.0)
                .intersect(rect.shrink(1.0)),
        )
    };
    let painter = ui.painter_at(rect);
    if let Some(at) = open_scene.selected().and_then(|(id, _)| around(id)) {
        for (width, color) in [(3.5, theme::HALO), (1.5, egui::Color32::WHITE)] {
            let stroke = Stroke::new(width, color);
            for (corner, x, y) in [
                (at.left_top(), 1.0, 1.0),
                (at.right_top(), -1.0, 1.0),
                (at.left_bottom(), 1.0, -1.0),
                (at.right_bottom(), -1.0, -1.0),
            ] {
                painter.line_segment([corner, corner + vec2(x * CORNER, 0.0)], stroke);
                painter.line_segment([corner, corner + vec2(0.0, y * CORNER)], stroke);
            }
        }
    }
    let Some((seen, at)) = seen.and_then(|seen| Some((seen, around(&seen.piece.object)?))) else {
        return;
    };
    let font = FontId::proportional(theme::SMALL_TEXT);
    let galley = painter.layout_no_wrap(seen.piece.object.to_string(), font, egui::Color32::WHITE);
    let place = Align2::LEFT_BOTTOM.anchor_size(at.left_top(), galley.size() + vec2(8.0, 3.0));
    let place = place.translate(vec2(0.0, (rect.top() - place.top()).max(0.0)));
    painter.rect_filled(place, 3.0, theme::PLATE);
    painter.galley(place.min + vec2(4.0, 1.5), galley, egui::Color32::WHITE);
}
