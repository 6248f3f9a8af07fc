//! Contents of menus that may be higher than the window.

use eframe::egui::{ScrollArea, Ui};

/// Room of a window that a menu leaves above and below itself, in points.
const MARGIN: f32 = 44.0;

/// Shows the contents of a menu, with a scroll bar where the window is too low for all of them.
pub(crate) fn scrolling<R>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
    let height = (ui.ctx().content_rect().height() - MARGIN).max(MARGIN);
    // A popup tells no height that it may take; without a least one it takes a few rows.
    let area = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
    area.show(ui, add).inner
}
