//! Controls of the comparison, and its display over the picture.

use eframe::egui;
use eframe::egui::{
    Align2, Color32, CursorIcon, FontId, Pos2, Rect, RichText, Role, Sense, Stroke, Ui, WidgetInfo,
    pos2, vec2,
};

use super::{ComparisonTarget, ComparisonView, GAINS, Wipe};
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use crate::widgets::theme;

/// Half of the width within which the divider can be grabbed, in points.
const REACH: f32 = 6.0;

impl Wipe {
    /// Shows the choice of the picture to compare with.
    pub(crate) fn choice(&mut self, ui: &mut Ui) {
        if self.worker.is_none() {
            return;
        }
        let text = self.against.map_or("Compare with", ComparisonTarget::label);
        let combo = egui::ComboBox::from_id_salt("against").selected_text(text).show_ui(ui, |ui| {
            if ui.selectable_label(self.against.is_none(), "Nothing").clicked() {
                self.choose(None);
            }
            for against in ComparisonTarget::ALL {
                if ui.selectable_label(self.against == Some(against), against.label()).clicked() {
                    self.choose(Some(against));
                }
            }
        });
        combo.response.on_hover_text(
            "Shows the picture beside the same in another tier, or beside the truth in f64",
        );
    }

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
        tag(ui, rect.left_top() + vec2(8.0, 8.0), Align2::LEFT_TOP, &text);
    }

    fn divider(&mut self, ui: &mut Ui, rect: Rect) {
        let x = rect.left() + self.split * rect.width();
        let grip = Rect::from_x_y_ranges(x - REACH..=x + REACH, rect.y_range());
        let response = ui.interact(grip, ui.scope_id().with("divider"), Sense::drag());
        let response = response.on_hover_cursor(CursorIcon::ResizeHorizontal);
        response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, "Divider"));
        if response.dragged()
            && let Some(at) = response.interact_pointer_pos()
        {
            self.split = ((at.x - rect.left()) / rect.width().max(1.0)).clamp(0.0, 1.0);
        }
        let Some(shown) = &self.shown else { return };
        let x = rect.left() + self.split * rect.width();
        let painter = ui.painter_at(rect);
        let half = |from: f32, to: f32| {
            let place = Rect::from_min_max(
                pos2(rect.left() + from * rect.width(), rect.top()),
                pos2(rect.left() + to * rect.width(), rect.bottom()),
            );
            (place, Rect::from_min_max(pos2(from, 0.0), pos2(to, 1.0)))
        };
        for (texture, (place, uv)) in
            shown.textures.iter().zip([half(0.0, self.split), half(self.split, 1.0)])
        {
            painter.rect_filled(place, 0.0, theme::of(ui).canvas);
            painter.image(texture.id(), place, uv, Color32::WHITE);
        }
        let color = if response.hovered() || response.dragged() {
            theme::of(ui).accent
        } else {
            Color32::WHITE
        };
        painter.vline(x, rect.y_range(), Stroke::new(3.0, Color32::from_black_alpha(110)));
        painter.vline(x, rect.y_range(), Stroke::new(1.0, color));
        painter.circle(pos2(x, rect.center().y), 5.0, theme::of(ui).panel, Stroke::new(1.5, color));
        tag(ui, rect.left_top() + vec2(8.0, 8.0), Align2::LEFT_TOP, "As set");
        tag(
            ui,
            rect.right_top() + vec2(-8.0, 8.0),
            Align2::RIGHT_TOP,
            shown.moment.against.label(),
        );
    }
}

fn whole() -> Rect {
    Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0))
}

fn tag(ui: &Ui, at: Pos2, align: Align2, text: &str) {
    let galley = ui.painter().layout_no_wrap(
        text.to_owned(),
        FontId::proportional(theme::SMALL_TEXT),
        theme::of(ui).text,
    );
    let place = align.anchor_size(at, galley.size());
    ui.painter().rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, Color32::from_black_alpha(150));
    ui.painter().galley(place.min, galley, theme::of(ui).text);
}

fn magnified(shown: &ComparisonView, gain: u32) -> egui::ColorImage {
    let byte = |x: f32| (x * gain as f32).clamp(0.0, 1.0).mul_add(255.0, 0.5) as u8;
    let pixels = shown.compared.difference.iter().map(|pixel| {
        let [r, g, b] = pixel.map(byte);
        Color32::from_rgb(r, g, b)
    });
    egui::ColorImage::new(shown.moment.size.map(|side| side as usize), pixels.collect())
}
