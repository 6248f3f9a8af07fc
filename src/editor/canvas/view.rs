//! Mapping of the graph's plane to the screen.

use eframe::egui::{Pos2, Rect, Vec2, vec2};

/// Range of the zoom, in points of the screen per point of the graph.
const ZOOM: std::ops::RangeInclusive<f32> = 0.03..=3.0;

/// Zoom from which titles and labels can be read.
const LEGIBLE: f32 = 0.5;
/// Margin around the content that is fitted into the view, in points of the screen.
const MARGIN: f32 = 30.0;

/// Zoom clamped to the canvas's range.
pub(crate) fn bounded(zoom: f32) -> f32 {
    zoom.clamp(*ZOOM.start(), *ZOOM.end())
}

/// View of a graph: a center and a zoom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CanvasView {
    /// Point of the graph at the canvas's center.
    pub(crate) center: Pos2,
    /// Points of the screen per point of the graph.
    pub(crate) zoom: f32,
    /// Rectangle of the canvas on the screen.
    pub(crate) screen: Rect,
}

impl Default for CanvasView {
    fn default() -> Self {
        Self { center: Pos2::ZERO, zoom: 1.0, screen: Rect::ZERO }
    }
}

impl CanvasView {
    pub(crate) fn to_screen(self, p: Pos2) -> Pos2 {
        self.screen.center() + (p - self.center) * self.zoom
    }

    pub(crate) fn rect_to_screen(self, r: Rect) -> Rect {
        Rect::from_min_max(self.to_screen(r.min), self.to_screen(r.max))
    }

    pub(crate) fn to_graph(self, p: Pos2) -> Pos2 {
        self.center + (p - self.screen.center()) / self.zoom
    }

    /// Part of the graph that is in view.
    pub(crate) fn visible(self) -> Rect {
        Rect::from_min_max(self.to_graph(self.screen.min), self.to_graph(self.screen.max))
    }

    /// Moves the graph with the pointer.
    pub(crate) fn pan(&mut self, delta: Vec2) {
        self.center -= delta / self.zoom;
    }

    /// Zooms; the point of the graph under `at` stays there.
    pub(crate) fn zoom_about(&mut self, at: Pos2, factor: f32) {
        let fixed = self.to_graph(at);
        self.zoom = (self.zoom * factor).clamp(*ZOOM.start(), *ZOOM.end());
        self.center += fixed - self.to_graph(at);
    }

    /// Shows all of `bounds`, at a zoom of at most 1.
    pub(crate) fn fit(&mut self, bounds: Rect) {
        if !bounds.is_finite() || !bounds.is_positive() {
            (self.center, self.zoom) = (Pos2::ZERO, 1.0);
            return;
        }
        let room = (self.screen.size() - Vec2::splat(2.0 * MARGIN)).max(vec2(40.0, 40.0));
        let zoom = (room.x / bounds.width()).min(room.y / bounds.height());
        self.zoom = zoom.clamp(*ZOOM.start(), 1.0);
        self.center = bounds.center();
    }

    /// Shows a graph that was just opened: all of `bounds` where text can be read at that zoom;
    /// otherwise the right end, where the picture comes out at `last`, at the least zoom that can
    /// be read.
    pub(crate) fn begin(&mut self, bounds: Rect, last: Rect) {
        self.fit(bounds);
        if self.zoom >= LEGIBLE {
            return;
        }
        self.zoom = LEGIBLE;
        let half = (0.5 * self.screen.size() - Vec2::splat(MARGIN)) / self.zoom;
        if bounds.width() > 2.0 * half.x {
            self.center.x = bounds.max.x - half.x;
        }
        if bounds.height() > 2.0 * half.y {
            self.center.y = last.center().y.clamp(bounds.min.y + half.y, bounds.max.y - half.y);
        }
    }

    /// Centers the view on `bounds` unless they are in view; zooms in first where the view is far.
    pub(crate) fn reveal(&mut self, bounds: Rect) {
        if self.zoom < 0.4 {
            self.zoom = 0.8;
        }
        let visible = self.visible().shrink(20.0 / self.zoom);
        if !visible.contains_rect(bounds) {
            self.center = bounds.center();
        }
    }

    /// Moves the view just far enough to have `bounds` in it, and shows more of the graph where
    /// they are too large for it.
    pub(crate) fn include(&mut self, bounds: Rect) {
        let is_there = bounds.is_finite() && self.screen.is_positive();
        if !is_there || self.visible().contains_rect(bounds) {
            return;
        }
        let room = (self.screen.size() - Vec2::splat(2.0 * MARGIN)).max(vec2(40.0, 40.0));
        self.zoom = bounded(self.zoom.min(room.x / bounds.width()).min(room.y / bounds.height()));
        let half = 0.5 * room / self.zoom;
        let within = |center: f32, half: f32, [from, to]: [f32; 2]| {
            let (least, most) = (to - half, from + half);
            if least <= most { center.clamp(least, most) } else { 0.5 * (from + to) }
        };
        self.center.x = within(self.center.x, half.x, [bounds.min.x, bounds.max.x]);
        self.center.y = within(self.center.y, half.y, [bounds.min.y, bounds.max.y]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let screen = Rect::from_min_size(pos2(100.0, 50.0), vec2(800.0, 600.0));
        let mut view = CanvasView { center: pos2(30.0, -20.0), zoom: 0.7, screen };
        let at = pos2(333.0, 444.0);
        let before = view.to_graph(at);
        view.zoom_about(at, 1.7);
        assert!((view.to_graph(at) - before).length() < 1e-3);
        assert!((view.to_screen(view.to_graph(at)) - at).length() < 1e-3);
    }

    #[test]
    fn everything_fits() {
        let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(800.0, 600.0));
        let mut view = CanvasView { screen, ..CanvasView::default() };
        let bounds = Rect::from_min_max(pos2(-500.0, 0.0), pos2(3000.0, 100.0));
        view.fit(bounds);
        assert!(view.visible().contains_rect(bounds));
    }

    #[test]
    fn what_is_added_comes_into_view_by_as_little_as_that_takes() {
        let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(800.0, 600.0));
        let start = CanvasView { screen, center: pos2(400.0, 300.0), zoom: 1.0 };
        let included = |bounds: Rect| {
            let mut view = start;
            view.include(bounds);
            assert!(view.visible().contains_rect(bounds), "{view:?}");
            view
        };
        let node = |x: f32, y: f32| Rect::from_min_size(pos2(x, y), vec2(184.0, 200.0));
        assert_eq!(included(node(10.0, 10.0)), start, "nothing moves for what is seen");
        let right = included(node(900.0, 100.0));
        assert_eq!((right.zoom, right.center.y), (1.0, 300.0));
        assert!((right.visible().max.x - 1084.0 - MARGIN).abs() < 1e-3);
        let all = Rect::from_min_max(pos2(500.0, 0.0), pos2(2500.0, 200.0));
        let far = included(all);
        assert!(far.zoom < 0.4 && (far.center.x - 1500.0).abs() < 1e-2);
    }

    #[test]
    fn what_is_opened_can_be_read() {
        let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(800.0, 600.0));
        let mut view = CanvasView { screen, ..CanvasView::default() };
        let small = Rect::from_min_max(pos2(0.0, 0.0), pos2(1200.0, 300.0));
        view.begin(small, small);
        assert!(view.visible().contains_rect(small), "a graph that can be read is shown whole");
        let large = Rect::from_min_max(pos2(-500.0, -2000.0), pos2(3000.0, 100.0));
        let last = Rect::from_min_max(pos2(2800.0, -100.0), pos2(3000.0, 100.0));
        view.begin(large, last);
        assert!(view.zoom >= LEGIBLE && view.visible().contains_rect(last));
        assert!(
            view.visible().max.x < large.max.x + 2.0 * MARGIN / LEGIBLE,
            "no room is lost beyond the end"
        );
    }
}
