//! Values of wires at the pixel that is probed, above the nodes that give them: beside an output
//! they would lie over the next node.

use std::sync::Arc;

use eframe::egui::{Align2, FontId, Pos2, Rect, Ui, pos2, vec2};

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
                let corner = self.view.to_screen(row.rect.right_top());
                self.draw_reading(ui, reading, corner + vec2(-4.0, -4.0) * self.view.zoom);
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

    /// Draws a reading whose right lower corner is `at`.
    fn draw_reading(&self, ui: &Ui, reading: &WireReading, at: Pos2) {
        let (zoom, colors) = (self.view.zoom, theme::of(ui));
        let painter = ui.painter_at(self.view.screen);
        let ink = if reading.is_finite { colors.text } else { colors.error };
        let ink = if self.readings.is_current { ink } else { ink.gamma_multiply(0.5) };
        let font = FontId::monospace(TEXT * zoom);
        let galley = painter.layout_no_wrap(reading.text.clone(), font, ink);
        let room = reading.color.map_or(0.0, |_| (SWATCH + 4.0) * zoom);
        let size = galley.size() + vec2(room, 0.0);
        let place = Align2::RIGHT_BOTTOM.anchor_size(at, size);
        let plate = place.expand2(vec2(3.0, 1.0) * zoom);
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
