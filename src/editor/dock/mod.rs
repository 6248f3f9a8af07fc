//! The panels below the picture, one at a time: a strip of tabs, and what the chosen one shows.

pub(crate) mod effects;

use eframe::egui;
use eframe::egui::{Sense, Ui, vec2};

use super::theme;

/// What can be seen there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tab {
    Code,
    Effects,
    Cost,
    Probe,
}

impl Tab {
    const ALL: [Self; 4] = [Self::Code, Self::Effects, Self::Cost, Self::Probe];

    fn label(self) -> &'static str {
        match self {
            Self::Code => "Code",
            Self::Effects => "Effects",
            Self::Cost => "Cost and accuracy",
            Self::Probe => "Probe",
        }
    }

    fn help(self) -> &'static str {
        match self {
            Self::Code => "The generated WGSL",
            Self::Effects => "Everything that the picture costs, what was left out, and the proof",
            Self::Cost => "What each tier costs in time, and how far it is from the truth",
            Self::Probe => "The value on every wire at a pixel, f32 beside f64 (I)",
        }
    }
}

/// Which panel is shown.
#[derive(Debug)]
pub(crate) struct Dock {
    pub(crate) is_open: bool,
    pub(crate) tab: Tab,
}

impl Default for Dock {
    fn default() -> Self {
        Self { is_open: true, tab: Tab::Code }
    }
}

impl Dock {
    /// Whether this panel is seen.
    pub(crate) fn shows(&self, tab: Tab) -> bool {
        self.is_open && self.tab == tab
    }

    /// Brings a panel to the front.
    pub(crate) fn open(&mut self, tab: Tab) {
        *self = Self { is_open: true, tab };
    }

    /// The tabs, the chosen one underlined.
    pub(crate) fn strip(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 14.0;
            for tab in Tab::ALL {
                let is_it = self.tab == tab;
                let color = if is_it { theme::of(ui).text } else { theme::of(ui).dim };
                let text = egui::RichText::new(tab.label()).color(color);
                let button = egui::Button::new(text).frame(false).sense(Sense::click());
                let response = ui.add(button).on_hover_text(tab.help());
                if is_it {
                    let line = response.rect.translate(vec2(0.0, 2.0));
                    let stroke = egui::Stroke::new(2.0, theme::of(ui).accent);
                    ui.painter().line_segment([line.left_bottom(), line.right_bottom()], stroke);
                }
                if response.clicked() {
                    self.tab = tab;
                }
            }
        });
        ui.add_space(4.0);
    }
}

/// A line in place of what is not there yet.
pub(crate) fn hint(ui: &mut Ui, text: &str) {
    ui.label(egui::RichText::new(text).color(theme::of(ui).dim));
}

/// Text in a column of a row, cut where it is too long.
pub(crate) fn cell(ui: &Ui, rect: egui::Rect, text: &str, font: egui::FontId, color: egui::Color32) {
    let mut job = egui::text::LayoutJob::single_section(
        text.to_owned(),
        egui::text::TextFormat { font_id: font, color, ..egui::text::TextFormat::default() },
    );
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width().max(0.0));
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let at = egui::pos2(rect.left(), rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, color);
}
