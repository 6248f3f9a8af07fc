//! Values of wires at the pixel that is probed, above the nodes that give them: beside an output
//! they would lie over the next node.

use std::sync::Arc;

use eframe::egui::{Align2, FontId, Rect, Ui, pos2, vec2};

use super::Canvas;
use super::draw::ALL_TEXT;
use crate::fields::wire_value::{WireReading, WireReadings};
use crate::ids::NodePath;
use crate::state::session::Session;
use crate::state::wire::source_within;
use crate::widgets::theme;

/// Size of the text, in points of the graph.
const TEXT: f32 = 11.0;
/// Side of the swatch of a color, in points of the graph.
const SWATCH: f32 = 10.0;

/// Readings of the probe, and whether they are of what is under the pointer now.
#[derive(Default)]
pub(super) struct Readings {
    known: Option<Arc<WireReadings>>,
    is_current: bool,
}

impl Canvas {
    /// Takes the readings of the probe while it is on; `is_current` is false while newer ones are
    /// awaited.
    pub(crate) fn take_readings(&mut self, known: Option<Arc<WireReadings>>, is_current: bool) {
        self.readings = Readings { known, is_current };
    }

    /// Shows the value of the first output of each node in view, above the right end of the node:
    /// costs are at the left.
    pub(super) fn draw_readings(&self, ui: &Ui, session: &Session) {
        let Some(known) = self.readings.known.as_ref().filter(|_| self.view.zoom > ALL_TEXT) else {
            return;
        };
        let visible = self.view.visible();
        for (index, row) in self.table.nodes.iter().enumerate() {
            if row.rect.intersects(visible)
                && let Some(reading) = self.reading_of(known, session, index)
            {
                let node = self.view.rect_to_screen(row.rect);
                self.draw_reading(ui, reading, node);
            }
        }
    }

    /// Reading of a node's first output, which of a group lies within.
    fn reading_of<'r>(
        &self,
        known: &'r WireReadings,
        session: &Session,
        index: usize,
    ) -> Option<&'r WireReading> {
        let row = &self.table.nodes[index];
        let port = &row.kind.outputs.first()?.name;
        let path: NodePath = session.selection.path_of(&row.id);
        known.get(&source_within(session.look(), &session.project.library, path, port))
    }

    /// Draws a reading above the right end of a node: as wide as the node at most, so that it lies
    /// over no other one beside it, and moved into view as far as the node leaves it.
    fn draw_reading(&self, ui: &Ui, reading: &WireReading, node: Rect) {
        let (zoom, colors) = (self.view.zoom, theme::of(ui));
        let painter = ui.painter_at(self.view.screen);
        let ink = if reading.is_finite { colors.text } else { colors.error };
        let ink = if self.readings.is_current { ink } else { ink.gamma_multiply(0.5) };
        let font = FontId::monospace(TEXT * zoom);
        let room = reading.color.map_or(0.0, |_| (SWATCH + 4.0) * zoom);
        let (margin, corner) = (vec2(3.0, 1.0) * zoom, vec2(-4.0, -4.0) * zoom);
        let width = node.width() - room + 2.0 * corner.x;
        let galley = painter.layout(reading.text.clone(), font, ink, width);
        let size = galley.size() + vec2(room, 0.0);
        let place = Align2::RIGHT_BOTTOM.anchor_size(node.right_top() + corner, size);
        let place = moved_into(place, self.view.screen.shrink2(margin));
        let plate = place.expand2(margin);
        painter.rect_filled(plate, 3.0 * zoom, colors.canvas.gamma_multiply(0.9));
        if let Some(color) = reading.color {
            let middle = pos2(place.left() + 0.5 * SWATCH * zoom, place.center().y);
            let swatch = Rect::from_center_size(middle, vec2(SWATCH, SWATCH) * zoom);
            painter.rect_filled(swatch.expand(1.0), 2.0 * zoom, colors.swatch_edge);
            painter.rect_filled(swatch, 2.0 * zoom, color);
        }
        painter.galley(place.min + vec2(room, 0.0), galley, ink);
    }

    /// The value that is shown above a node, for tests.
    pub fn reading_text(&self, session: &Session, id: &str) -> Option<&str> {
        let index = self.table.index_of(&id.into())?;
        let known = self.readings.known.as_ref()?;
        self.reading_of(known, session, index).map(|reading| reading.text.as_str())
    }
}

/// A place moved by as little as brings it into `room`; what is larger begins where `room` does.
fn moved_into(place: Rect, room: Rect) -> Rect {
    let corner = place.max.min(room.max) - place.size();
    Rect::from_min_size(corner.max(room.min), place.size())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_moved_into_the_room() {
        let room = Rect::from_min_max(pos2(10.0, 20.0), pos2(110.0, 70.0));
        let place = |x, y| Rect::from_min_size(pos2(x, y), vec2(30.0, 8.0));
        assert_eq!(moved_into(place(40.0, 30.0), room), place(40.0, 30.0));
        assert_eq!(moved_into(place(-5.0, 90.0), room), place(10.0, 62.0));
        assert_eq!(moved_into(place(100.0, 0.0), room), place(80.0, 20.0));
        let wide = Rect::from_min_size(pos2(50.0, 30.0), vec2(200.0, 8.0));
        assert_eq!(moved_into(wide, room).min, pos2(10.0, 30.0));
    }
}
