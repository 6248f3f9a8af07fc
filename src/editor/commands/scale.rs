//! Commands about the scale of the window.

use eframe::egui::{self, gui_zoom};

/// Command about the scale of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ScaleCommand {
    Larger,
    Smaller,
    /// Scale in percent.
    To(u16),
}

impl ScaleCommand {
    /// Scales that menus offer, in percent.
    pub(crate) const PERCENTS: [u16; 4] = [100, 125, 150, 200];

    /// Scales the window.
    pub(crate) fn apply(self, ctx: &egui::Context) {
        match self {
            Self::Larger => gui_zoom::zoom_in(ctx),
            Self::Smaller => gui_zoom::zoom_out(ctx),
            Self::To(percent) => ctx.set_zoom_factor(f32::from(percent) / 100.0),
        }
    }
}
