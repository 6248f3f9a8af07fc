//! Time axis: mapping of seconds to the screen, ruler, zoom and pan.

use eframe::egui::{Align2, Color32, FontId, Pos2, Rect, Response, Shape, Stroke, Ui, pos2, vec2};

use crate::values;
use crate::widgets::theme;

/// Shortest and longest visible range, in seconds.
const SPAN: std::ops::RangeInclusive<f64> = 0.05..=36_000.0;

/// Mapping of times to the screen.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    pub(super) lane: Rect,
    pub(super) seen: [f64; 2],
}

impl Axis {
    fn span(self) -> f64 {
        (self.seen[1] - self.seen[0]).max(*SPAN.start())
    }

    pub(super) fn x(self, time: f64) -> f32 {
        self.lane.left() + ((time - self.seen[0]) / self.span()) as f32 * self.lane.width()
    }

    pub(super) fn time(self, x: f32) -> f64 {
        self.seen[0] + f64::from((x - self.lane.left()) / self.lane.width().max(1.0)) * self.span()
    }

    /// Visible range zoomed in by a factor; the time under `x` stays there.
    pub(super) fn zoomed(self, x: f32, factor: f64) -> [f64; 2] {
        let time = self.time(x);
        let span = (self.span() / factor).clamp(*SPAN.start(), *SPAN.end());
        let before = (time - self.seen[0]) / self.span() * span;
        [time - before, time - before + span]
    }

    /// Visible range dragged by a distance, in points.
    pub(super) fn panned(self, points: f32) -> [f64; 2] {
        let shift = f64::from(points / self.lane.width().max(1.0)) * self.span();
        self.seen.map(|time| time - shift)
    }

    /// Seconds between two marks, far enough apart to be read: whole frames below a second.
    fn step(self, fps: f64) -> f64 {
        let least = 56.0 / f64::from(self.lane.width().max(1.0)) * self.span();
        let frames = [1.0, 2.0, 3.0, 4.0, 6.0, 12.0].map(|frames| frames / fps);
        let seconds = [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0];
        frames.into_iter().chain(seconds).find(|step| *step >= least).unwrap_or(7200.0)
    }

    /// Draws the ruler, and the played range as a band. `is_in_frames` counts frames, as shots do,
    /// and not seconds.
    pub(super) fn ruler(self, ui: &Ui, fps: f64, range: [f64; 2], is_in_frames: bool) {
        let colors = theme::of(ui);
        let painter = ui.painter_at(self.lane.expand2(vec2(0.0, 1.0)));
        painter.rect_filled(self.lane, 3.0, colors.canvas);
        let band = Rect::from_x_y_ranges(
            self.x(range[0])..=self.x(range[1]),
            self.lane.bottom() - 4.0..=self.lane.bottom(),
        );
        painter.rect_filled(band, 0.0, colors.accent_dim);
        let font = FontId::proportional(theme::SMALL_TEXT);
        for time in self.marks(fps) {
            let x = self.x(time);
            painter.vline(
                x,
                self.lane.bottom() - 7.0..=self.lane.bottom(),
                Stroke::new(1.0, colors.dim),
            );
            let is_whole = (time - time.round()).abs() < 1e-6;
            let text = match is_whole {
                _ if is_in_frames => values::number_text((time * fps).round(), 0),
                true => format!("{} s", values::number_text(time.round(), 0)),
                false => format!("f{}", values::number_text((time * fps).round(), 0)),
            };
            painter.text(
                pos2(x + 3.0, self.lane.top() + 3.0),
                Align2::LEFT_TOP,
                text,
                font.clone(),
                colors.dim,
            );
        }
    }

    /// Times that have a mark.
    pub(super) fn marks(self, fps: f64) -> impl Iterator<Item = f64> {
        let step = self.step(fps);
        let first = (self.seen[0] / step).ceil() as i64;
        let last = (self.seen[1] / step).floor() as i64;
        (first..=last.min(first + 400)).map(move |i| i as f64 * step)
    }
}

/// Draws an end of the range as a flag on the ruler.
pub(super) fn flag(ui: &Ui, at: Pos2, is_end: bool, response: &Response) {
    let colors = theme::of(ui);
    let way = if is_end { -1.0 } else { 1.0 };
    let points = [vec2(0.0, -6.0), vec2(7.0 * way, 0.0), vec2(0.0, 6.0)].map(|d| at + d).to_vec();
    let is_hot = response.hovered() || response.dragged() || response.has_focus();
    let fill: Color32 = if is_hot { colors.accent } else { colors.dim };
    ui.painter().add(Shape::convex_polygon(points, fill, Stroke::NONE));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zooming_keeps_what_is_under_the_pointer() {
        let lane = Rect::from_min_size(pos2(200.0, 10.0), vec2(500.0, 24.0));
        let axis = Axis { lane, seen: [-0.5, 4.5] };
        for factor in [0.25, 1.0, 3.0, 1e9] {
            let zoomed = Axis { lane, seen: axis.zoomed(350.0, factor) };
            assert!((zoomed.time(350.0) - axis.time(350.0)).abs() < 1e-9);
            let marks: Vec<f64> = zoomed.marks(24.0).collect();
            assert!(
                marks.len() < 12
                    && marks.windows(2).all(|pair| zoomed.x(pair[1]) - zoomed.x(pair[0]) > 40.0)
            );
        }
        let panned = Axis { lane, seen: axis.panned(100.0) };
        assert!((panned.x(1.0) - axis.x(1.0) - 100.0).abs() < 1e-3);
        assert!((axis.time(axis.x(2.0)) - 2.0).abs() < 1e-6);
    }
}
