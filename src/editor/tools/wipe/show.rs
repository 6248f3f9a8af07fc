//! Controls of the comparison, and its display over the picture.

use eframe::egui;
use eframe::egui::{Color32, Rect, RichText, Ui};

use super::divider::{self, Corner};
use super::{ComparisonTarget, ComparisonView, GAINS, Wipe};
use crate::commands::{Command, PanelId};
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use crate::tools::PictureTools;
use crate::tools::flip::FlipBook;
use crate::tools::playback::Playback;
use crate::widgets::rows::whole;
use crate::widgets::theme;

/// Height of the list of what to compare with, in points: all of it.
const LIST: f32 = 400.0;

/// Shows the choice of what the picture is compared with: the same in another tier, or frames of
/// another version.
pub(super) fn choice(tools: &mut PictureTools, ui: &mut Ui, out: &mut Vec<Command>) {
    let wipe = tools.of::<Wipe>();
    if wipe.worker.is_none() {
        return;
    }
    let against = wipe.against;
    let version = tools.of::<FlipBook>().name().map(str::to_owned);
    let is_none = against.is_none() && version.is_none();
    let text = match (&version, against) {
        (Some(version), _) => version.clone(),
        (None, against) => against.map_or("Compare with", ComparisonTarget::label).to_owned(),
    };
    let combo = egui::ComboBox::from_id_salt("against").selected_text(text);
    let combo = combo.height(LIST).show_ui(ui, |ui| {
        let (flip, playback) = tools.pair::<FlipBook, Playback>();
        let mut chosen = None;
        if ui.selectable_label(is_none, "Nothing").clicked() {
            chosen = Some(None);
            flip.close(playback);
        }
        for target in ComparisonTarget::ALL {
            if ui.selectable_label(against == Some(target), target.label()).clicked() {
                chosen = Some(Some(target));
                flip.close(playback);
            }
        }
        ui.separator();
        let has_frames = playback.cache().frames().next().is_some();
        let keep = ui.add_enabled(has_frames, egui::Button::selectable(false, "Frames kept now"));
        let help = "A flip book against the frames that the timeline has now, such as those before \
                    an edit";
        let keep = keep.on_hover_text(help).on_disabled_hover_text(
            "The timeline has no frames yet: play it, or press Cache range there",
        );
        if keep.clicked() {
            chosen = Some(None);
            flip.keep(playback);
        }
        let help = "A flip book against frames that were rendered, as by chiaro render: choose one \
                    of them";
        let files = ui.selectable_label(false, "Rendered frames...").on_hover_text(help);
        let help = "A flip book against another look, scene or shot, which is drawn frame by frame \
                    in the same size";
        let document = ui.selectable_label(false, "Another document...").on_hover_text(help);
        if files.clicked() || document.clicked() {
            chosen = Some(None);
            out.push(Command::CompareFrames(None));
            out.push(Command::ShowPanel(PanelId::TIMELINE));
        }
        if let Some(chosen) = chosen {
            tools.of_mut::<Wipe>().choose(chosen);
        }
    });
    combo.response.on_hover_text(
        "Shows the picture beside the same in another tier, beside the truth in f64, or beside \
         frames of another version",
    );
}

impl Wipe {
    /// Shows a second row of controls while the picture is compared.
    pub(crate) fn bar(&mut self, ui: &mut Ui, session: &Session) {
        let Some(against) = self.against else { return };
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 3.0;
            if ui
                .selectable_label(self.gain.is_none(), "Wipe")
                .on_hover_text("Drag the divider")
                .clicked()
            {
                self.gain = None;
            }
            for gain in GAINS {
                let help = format!("Shows the difference, magnified {gain} times");
                if ui
                    .selectable_label(self.gain == Some(gain), format!("×{gain}"))
                    .on_hover_text(help)
                    .clicked()
                {
                    self.gain = Some(gain);
                }
            }
            ui.add_space(6.0);
            self.state(ui, session, against);
        });
        for problem in self.problems.iter().take(2) {
            ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
        }
    }

    fn state(&mut self, ui: &mut Ui, session: &Session, against: ComparisonTarget) {
        if let Some(shown) = self.current() {
            let figures = &shown.compared.figures;
            let text = match figures.max {
                0.0 => "no difference".to_owned(),
                max => format!("max {max:.1e} · {} px over 1/255", figures.visible),
            };
            let ink = if figures.visible > 0 { theme::of(ui).warning } else { theme::of(ui).dim };
            let [x, y] = figures.worst;
            let help = format!(
                "Largest difference of a channel {:.3e} at pixel {x}, {y}; rms {:.1e}; {} pixels \
                 compared, and {} on edges \
                 told apart, where coverage may differ",
                figures.max, figures.rms, figures.pixels, figures.edges
            );
            ui.add(egui::Label::new(RichText::new(text).color(ink)).truncate()).on_hover_text(help);
            return;
        }
        if self.is_busy() {
            if against == ComparisonTarget::Truth {
                let share = self.progress.share() as f32;
                let bar = egui::ProgressBar::new(share)
                    .desired_width(90.0)
                    .text(format!("{:.0} %", share * 100.0));
                ui.add(bar);
                if ui.button("Stop").clicked() {
                    self.stop();
                }
            } else {
                ui.label(RichText::new("drawing").color(theme::of(ui).dim));
            }
            return;
        }
        if against == ComparisonTarget::Truth {
            if ui
                .button("Compute again")
                .on_hover_text("Computes the truth of what is shown now")
                .clicked()
                && let Some(moment) = self.seen.clone()
            {
                self.ask(session, moment);
            }
            ui.label(RichText::new("out of date").color(theme::of(ui).warning));
        }
    }

    /// Shows the divider, or the difference, over the picture.
    pub(crate) fn over(&mut self, ui: &mut Ui, rect: Rect) {
        if self.current().is_none() {
            return;
        }
        match self.gain {
            Some(gain) => self.difference(ui, rect, gain),
            None => self.divider(ui, rect),
        }
    }

    fn difference(&mut self, ui: &Ui, rect: Rect, gain: u32) {
        let Some(shown) = &mut self.shown else { return };
        if shown.magnified.as_ref().is_none_or(|(of, _)| *of != gain) {
            let image = magnified(shown, gain);
            let options = egui::TextureOptions::NEAREST;
            shown.magnified = Some((gain, ui.ctx().load_texture("difference", image, options)));
        }
        if let Some((_, texture)) = &shown.magnified {
            ui.painter().image(texture.id(), rect, whole(), Color32::WHITE);
        }
        let text = format!("Difference ×{gain}, largest {:.1e}", shown.compared.figures.max);
        divider::tag(ui, rect, Corner::Left, &text);
    }

    fn divider(&mut self, ui: &mut Ui, rect: Rect) {
        let is_hot = divider::drag(ui, rect, &mut self.split);
        let Some(shown) = &self.shown else { return };
        for (texture, half) in shown.textures.iter().zip(divider::halves(rect, self.split)) {
            let painter = ui.painter_at(half);
            painter.rect_filled(half, 0.0, theme::of(ui).canvas);
            painter.image(texture.id(), rect, whole(), Color32::WHITE);
        }
        divider::paint(ui, rect, self.split, is_hot);
        divider::tag(ui, rect, Corner::Left, "As set");
        divider::tag(ui, rect, Corner::Right, shown.moment.against.label());
    }
}

fn magnified(shown: &ComparisonView, gain: u32) -> egui::ColorImage {
    let byte = |x: f32| (x * gain as f32).clamp(0.0, 1.0).mul_add(255.0, 0.5) as u8;
    let pixels = shown.compared.difference.iter().map(|pixel| {
        let [r, g, b] = pixel.map(byte);
        Color32::from_rgb(r, g, b)
    });
    egui::ColorImage::new(shown.moment.size.map(|side| side as usize), pixels.collect())
}
