//! Controls of the comparison, and its display over the picture.

use chiaro_locale::{tr, trn};
use eframe::egui;
use eframe::egui::{Color32, Key, Rect, RichText, Role, Ui, WidgetInfo};

use super::divider::{self, Corner};
use super::{ComparisonMode, ComparisonView, GAINS, Wipe};
use crate::accuracy::ErrorFigures;
use crate::commands::{Command, PanelId, ViewCommand, keyboard};
use crate::state::comparison::ComparedPicture;
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::state::shelf::SnapshotShelf;
use crate::state::worker::BackgroundJobs;
use crate::tools::PictureTools;
use crate::tools::flip::FlipBook;
use crate::tools::playback::Playback;
use crate::widgets::menu;
use crate::widgets::number::number_slider;
use crate::widgets::rows::{fitted, whole};
use crate::widgets::theme;

/// Height of the list of what to compare with, in points: all of it.
const LIST: f32 = 400.0;
/// Duration of each picture of the flicker, in seconds: it changes twice a second, there and back.
const HALF_FLICKER: f64 = 0.25;

/// Width of the choice, in points: narrow, since it stands in a bar with others.
const WIDTH: f32 = 97.0;

/// Shows the choice of what the picture is compared with: the same in another tier, a snapshot, a
/// file, or frames of another version.
pub(super) fn choice(tools: &mut PictureTools, ui: &mut Ui, out: &mut Vec<Command>) {
    let wipe = tools.of::<Wipe>();
    if wipe.worker.is_none() {
        return;
    }
    let version = tools.of::<FlipBook>().name().map(str::to_owned);
    let text = match (&version, &wipe.against) {
        (Some(version), _) => version.clone(),
        (None, Some(_)) => wipe.name.clone(),
        (None, None) => tr!("Compare").to_owned(),
    };
    let combo = egui::ComboBox::from_id_salt("against").width(WIDTH).truncate().height(LIST);
    let response = menu::choice(ui, combo, text, |ui| {
        let chosen = states(tools, ui, version.is_none(), out);
        let frames = frames(tools, ui, out);
        if let Some(chosen) = chosen.or(frames.then_some(None)) {
            tools.of_mut::<Wipe>().choose(chosen);
        }
    });
    response
        .on_hover_text(tr!(
            "Shows the picture beside a snapshot, a file, a reference picture, the same in another \
         tier, the truth in f64, or frames of another version"
        ))
        .on_disabled_hover_text(tr!("Nothing is compared while light is painted on the picture"));
}

/// Shows the pictures that the present one may be compared with, and returns the choice.
fn states(
    tools: &mut PictureTools,
    ui: &mut Ui,
    has_no_version: bool,
    out: &mut Vec<Command>,
) -> Option<Option<ComparedPicture>> {
    let wipe = tools.of::<Wipe>();
    let (against, snapshots) = (wipe.against.clone(), wipe.snapshots.clone());
    let has_file = wipe.has_file;
    let mut chosen = None;
    if ui.selectable_label(against.is_none() && has_no_version, tr!("Nothing")).clicked() {
        chosen = Some(None);
    }
    let shelf = SnapshotShelf::default();
    let own = ComparedPicture::OF_LOOK.map(|picture| (picture.label(&shelf), picture));
    for (label, picture) in own {
        if ui.selectable_label(against.as_ref() == Some(&picture), label).clicked() {
            chosen = Some(Some(picture));
        }
    }
    ui.separator();
    let saved = ComparedPicture::Saved;
    let is_it = against.as_ref() == Some(&saved);
    let saved_label = ui.add_enabled(has_file, egui::Button::selectable(is_it, tr!("As saved")));
    let saved_label = saved_label.on_hover_text(tr!("The look as its file has it"));
    if saved_label.on_disabled_hover_text(tr!("The look is in no file yet")).clicked() {
        chosen = Some(Some(saved));
    }
    for (picture, name) in snapshots {
        let is_it = against.as_ref() == Some(&picture);
        let help = tr!("A snapshot of the look");
        if ui.selectable_label(is_it, name).on_hover_text(help).clicked() {
            chosen = Some(Some(picture));
        }
    }
    let help = tr!(
        "Another look (JSON) in this view, or a reference picture (PNG, JPEG, EXR, HDR) fitted \
         into it"
    );
    if ui
        .selectable_label(false, tr!("A look or picture in a file..."))
        .on_hover_text(help)
        .clicked()
    {
        out.push(Command::View(ViewCommand::Compare(None)));
    }
    if chosen.is_some() {
        let (flip, playback) = tools.pair::<FlipBook, Playback>();
        flip.close(playback);
    }
    chosen
}

/// Shows the frames of other versions; true if some are chosen.
fn frames(tools: &mut PictureTools, ui: &mut Ui, out: &mut Vec<Command>) -> bool {
    ui.separator();
    let (flip, playback) = tools.pair::<FlipBook, Playback>();
    let has_frames = playback.cache().frames().next().is_some();
    let keep = ui.add_enabled(has_frames, egui::Button::selectable(false, tr!("Frames kept now")));
    let help =
        tr!("A flip book against the frames that the timeline has now, such as those before an \
             edit");
    let keep = keep.on_hover_text(help).on_disabled_hover_text(tr!(
        "The timeline has no frames yet: play it, or press Cache range there"
    ));
    if keep.clicked() {
        flip.compare_kept(playback);
        return true;
    }
    let help =
        tr!("A flip book against frames that were rendered, as by chiaro render: choose one of \
             them");
    let files = ui.selectable_label(false, tr!("Rendered frames...")).on_hover_text(help);
    let help = tr!(
        "A flip book against another look, scene or shot, which is drawn frame by frame in the \
         same size"
    );
    let document = ui.selectable_label(false, tr!("Another document...")).on_hover_text(help);
    if files.clicked() || document.clicked() {
        out.push(Command::CompareFrames(None));
        out.push(Command::ShowPanel(PanelId::TIMELINE));
        return true;
    }
    false
}

/// A share or a difference in percent, with a decimal where that tells it from nothing.
fn percent(part: f64) -> String {
    let decimals = usize::from(part < 0.0095);
    format!("{:.decimals$}", part * 100.0)
}

/// Words for how much of the picture differs, and how much at most.
fn told(figures: &ErrorFigures) -> String {
    let count = figures.visible;
    let share = percent(count as f64 / figures.pixels.max(1) as f64);
    let most = percent(figures.max);
    match count {
        0 if figures.max == 0.0 => tr!("no difference").to_owned(),
        0 => tr!("no visible difference").to_owned(),
        _ if share == "0.0" => trn!(
            count,
            "{count} pixel differs, by up to {most} %",
            "{count} pixels differ, by up to {most} %"
        ),
        _ => tr!("{share} % of the pixels differ, by up to {most} %"),
    }
}

impl Wipe {
    /// Shows a second row of controls while the picture is compared.
    pub(crate) fn bar(&mut self, ui: &mut Ui, session: &Session) {
        let Some(against) = self.against.clone() else { return };
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 3.0;
            self.left_choice(ui);
            self.modes(ui);
        });
        // A row of its own that is always as high: the picture's size must not depend on what is
        // told of it, or it would be compared for ever.
        ui.horizontal(|ui| {
            ui.set_height(ui.spacing().interact_size.y);
            self.state(ui, session, &against);
        });
        for problem in self.problems.iter().take(2) {
            let text = RichText::new(sentence(problem)).color(theme::of(ui).error);
            ui.add(egui::Label::new(text).wrap());
        }
    }

    /// Shows the choice of the left picture: the look as it is, or a snapshot.
    fn left_choice(&mut self, ui: &mut Ui) {
        if self.snapshots.is_empty() {
            return;
        }
        let as_set = tr!("As set").to_owned();
        let is_it = |(picture, _): &&(ComparedPicture, String)| *picture == self.left;
        let name = self.snapshots.iter().find(is_it).map_or(&as_set, |(_, name)| name);
        let mut chosen = None;
        let combo = egui::ComboBox::from_id_salt("left").width(60.0).selected_text(name);
        let combo = combo.show_ui(ui, |ui| {
            let present = (ComparedPicture::Present, as_set.clone());
            for (picture, name) in std::iter::once(&present).chain(&self.snapshots) {
                if ui.selectable_label(self.left == *picture, name).clicked() {
                    chosen = Some(picture.clone());
                }
            }
        });
        combo
            .response
            .widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr!("Left picture")));
        combo.response.on_hover_text(tr!("The left picture: the look as it is now, or a snapshot"));
        if let Some(left) = chosen {
            self.choose_left(left);
        }
    }

    /// Shows the ways to look at both pictures, with the controls of the present one.
    fn modes(&mut self, ui: &mut Ui) {
        use ComparisonMode as M;
        for (mode, text, help) in [
            (M::Wipe, tr!("Wipe"), tr!("Both pictures: drag the divider")),
            (M::Flicker, tr!("Flicker"), tr!("One at a time: twice a second, or while V is held")),
            (M::Beside, tr!("comparison" => "Beside"), tr!("Both pictures, side by side")),
            (M::Over, tr!("comparison" => "Over"), tr!("The other picture over this one")),
        ] {
            if ui.selectable_label(self.mode == mode, text).on_hover_text(help).clicked() {
                self.mode = mode;
            }
        }
        for gain in GAINS {
            let help = tr!("Shows the difference, magnified {gain} times");
            let mode = M::Difference(gain);
            let label = ui.selectable_label(self.mode == mode, format!("×{gain}"));
            if label.on_hover_text(help).clicked() {
                self.mode = mode;
            }
        }
        match self.mode {
            M::Flicker => {
                ui.checkbox(&mut self.flickers, tr!("By itself"))
                    .on_hover_text(tr!("Twice a second"));
                let help = tr!("Shows the other picture (V, while it is held)");
                ui.add_enabled_ui(!self.flickers, |ui| {
                    ui.toggle_value(&mut self.shows_right, tr!("comparison" => "Other"))
                        .on_hover_text(help);
                });
            }
            M::Over => {
                let slider = number_slider(ui, &mut self.opacity, 0.0..=1.0).show_value(false);
                let slider = ui.add(slider).on_hover_text(tr!("Opacity of the other picture"));
                let opacity = f64::from(self.opacity);
                let name = tr!("Opacity of the other picture");
                slider.widget_info(|| WidgetInfo::slider(true, opacity, name));
            }
            M::Wipe | M::Beside | M::Difference(_) => {}
        }
    }

    fn state(&mut self, ui: &mut Ui, session: &Session, against: &ComparedPicture) {
        if let Some(shown) = self.current() {
            let figures = &shown.compared.figures;
            // Between two states of a look a difference is what was asked for, and no warning.
            let is_error = matches!(against, ComparedPicture::Truth | ComparedPicture::Tier(_));
            let is_warning = is_error && figures.visible > 0;
            let ink = if is_warning { theme::of(ui).warning } else { theme::of(ui).dim };
            let text = told(figures);
            let [x, y] = figures.worst;
            let help = tr!(
                "Largest difference of a channel {max:.3e} at pixel {x}, {y}; rms {rms:.1e}; \
                 {visible} of {pixels} pixels differ by more than 1/255; {edges} on edges are told \
                 apart, where coverage may differ",
                max = figures.max,
                rms = figures.rms,
                visible = figures.visible,
                pixels = figures.pixels,
                edges = figures.edges
            );
            ui.add(egui::Label::new(RichText::new(text).color(ink)).truncate()).on_hover_text(help);
            return;
        }
        if self.is_busy() {
            if *against == ComparedPicture::Truth {
                let share = self.progress.share() as f32;
                let bar = egui::ProgressBar::new(share)
                    .desired_width(90.0)
                    .text(format!("{:.0} %", share * 100.0));
                ui.add(bar);
                if ui.button(tr!("Stop")).clicked() {
                    self.stop();
                }
            } else {
                ui.label(RichText::new(tr!("drawing")).color(theme::of(ui).dim));
            }
            return;
        }
        if *against == ComparedPicture::Truth {
            if ui
                .button(tr!("Compute again"))
                .on_hover_text(tr!("Computes the truth of what is shown now"))
                .clicked()
                && let Some(moment) = self.seen.clone()
            {
                self.ask(session, moment);
            }
            ui.label(RichText::new(tr!("out of date")).color(theme::of(ui).warning));
        }
    }

    /// Shows both pictures, one of them, or the difference over the picture.
    pub(crate) fn over(&mut self, ui: &mut Ui, rect: Rect, is_pointed_at: bool) {
        if self.current().is_none() {
            return;
        }
        match self.mode {
            ComparisonMode::Difference(gain) => self.difference(ui, rect, gain),
            ComparisonMode::Wipe => self.divider(ui, rect),
            ComparisonMode::Flicker => self.flicker(ui, rect, is_pointed_at),
            ComparisonMode::Beside => self.beside(ui, rect),
            ComparisonMode::Over => self.above(ui, rect),
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
        let most = percent(shown.compared.figures.max);
        let text = tr!("Difference ×{gain}, up to {most} %");
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
        divider::tag(ui, rect, Corner::Left, &shown.names[0]);
        divider::tag(ui, rect, Corner::Right, &shown.names[1]);
    }

    fn flicker(&mut self, ui: &Ui, rect: Rect, is_pointed_at: bool) {
        let is_held = is_pointed_at
            && !keyboard::is_keyboard_taken(ui.ctx())
            && ui.input(|input| input.key_down(Key::V));
        let is_right = if self.flickers && !is_held {
            let time = ui.input(|input| input.time);
            let left = HALF_FLICKER - time.rem_euclid(HALF_FLICKER);
            ui.ctx().request_repaint_after_secs(left.max(0.01) as f32);
            time.rem_euclid(2.0 * HALF_FLICKER) >= HALF_FLICKER
        } else {
            is_held || self.shows_right
        };
        let Some(shown) = &self.shown else { return };
        let side = usize::from(is_right);
        ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
        ui.painter().image(shown.textures[side].id(), rect, whole(), Color32::WHITE);
        let corner = if is_right { Corner::Right } else { Corner::Left };
        divider::tag(ui, rect, corner, &shown.names[side]);
    }

    fn beside(&self, ui: &Ui, rect: Rect) {
        let Some(shown) = &self.shown else { return };
        ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
        for (side, half) in divider::halves(rect, 0.5).into_iter().enumerate() {
            let place = fitted(half, shown.moment.size);
            ui.painter().image(shown.textures[side].id(), place, whole(), Color32::WHITE);
            let corner = if side == 0 { Corner::Left } else { Corner::Right };
            divider::tag(ui, half, corner, &shown.names[side]);
        }
    }

    fn above(&self, ui: &Ui, rect: Rect) {
        let Some(shown) = &self.shown else { return };
        ui.painter().rect_filled(rect, 0.0, theme::of(ui).canvas);
        let [left, right] = &shown.textures;
        ui.painter().image(left.id(), rect, whole(), Color32::WHITE);
        let tint = Color32::WHITE.gamma_multiply(self.opacity);
        ui.painter().image(right.id(), rect, whole(), tint);
        divider::tag(ui, rect, Corner::Left, &shown.names[0]);
        divider::tag(ui, rect, Corner::Right, &shown.names[1]);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_is_told_in_shares_of_the_picture() {
        let of = |max: f64, visible| {
            let pixels = 100_000;
            told(&ErrorFigures { max, visible, pixels, ..ErrorFigures::default() })
        };
        assert_eq!(of(0.0, 0), "no difference");
        assert_eq!(of(0.001, 0), "no visible difference");
        assert_eq!(of(0.77, 33_172), "33 % of the pixels differ, by up to 77 %");
        assert_eq!(of(0.008, 600), "0.6 % of the pixels differ, by up to 0.8 %");
        assert_eq!(of(0.02, 1), "1 pixel differs, by up to 2 %");
    }
}
