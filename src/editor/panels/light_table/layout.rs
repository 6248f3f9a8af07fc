//! Places of the table's cells: what scrolls, what stays at the edges, and what lies at a point.

use eframe::egui::{Pos2, Rect, pos2, vec2};

use super::selection::{Place, ShownCells};

/// Height of a row, in points.
pub(super) const ROW: f32 = 22.0;
/// Height of the head, in points.
pub(super) const HEAD: f32 = 22.0;

/// Places of the cells on the screen.
pub(super) struct CellLayout<'s> {
    pub(super) shown: ShownCells<'s>,
    /// Left edges of the columns from the table's own, and the right edge of the last.
    pub(super) lefts: Vec<f32>,
    /// Number of columns that stay at the left edge.
    pub(super) pinned: usize,
    /// Upper left corner of the cells, which goes with scrolling.
    pub(super) origin: Pos2,
    /// Part of the screen that is seen.
    pub(super) seen: Rect,
}

impl CellLayout<'_> {
    pub(super) fn left_of(&self, column: usize) -> f32 {
        let from = if column < self.pinned { self.seen.left() } else { self.origin.x };
        from + self.lefts[column]
    }

    pub(super) fn rect(&self, row: usize, column: usize) -> Rect {
        let width = self.lefts[column + 1] - self.lefts[column];
        let top = self.origin.y + HEAD + row as f32 * ROW;
        Rect::from_min_size(pos2(self.left_of(column), top), vec2(width, ROW))
    }

    pub(super) fn head(&self, column: usize) -> Rect {
        let width = self.lefts[column + 1] - self.lefts[column];
        Rect::from_min_size(pos2(self.left_of(column), self.seen.top()), vec2(width, HEAD))
    }

    /// Width of the columns that stay.
    pub(super) fn pinned_width(&self) -> f32 {
        self.lefts[self.pinned]
    }

    /// Area of the columns that stay, or of the others, without the head.
    pub(super) fn area(&self, is_pinned: bool) -> Rect {
        let edge = (self.seen.left() + self.pinned_width()).min(self.seen.right());
        let top = (self.seen.top() + HEAD).min(self.seen.bottom());
        let body = Rect::from_min_max(pos2(self.seen.left(), top), self.seen.max);
        if is_pinned { body.with_max_x(edge) } else { body.with_min_x(edge) }
    }

    pub(super) fn columns(&self, is_pinned: bool) -> std::ops::Range<usize> {
        if is_pinned { 0..self.pinned } else { self.pinned..self.shown.columns.len() }
    }

    /// The cell nearest to a point.
    pub(super) fn nearest(&self, at: Pos2) -> Option<Place> {
        let rows = self.shown.rows.len().checked_sub(1)?;
        let row = ((at.y - self.origin.y - HEAD) / ROW).max(0.0) as usize;
        let is_pinned = at.x < self.seen.left() + self.pinned_width();
        let columns = self.columns(is_pinned);
        let is_right_of = |column: &usize| self.left_of(*column) <= at.x;
        let column = columns.clone().rev().find(is_right_of).unwrap_or(columns.start);
        let row = self.shown.rows.get(row.min(rows))?.clone();
        Some((row, *self.shown.columns.get(column)?))
    }
}
