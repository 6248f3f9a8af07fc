//! Controls of the flip book, and its display over the picture.

use chiaro_locale::{tr, trn};
use eframe::egui::{
    Color32, Key, Rect, RichText, TextureHandle, TextureOptions, Ui, Vec2, WidgetInfo,
};

use super::{FlipBook, FlipPicture, FlipView, KeyedPicture, difference};
use crate::commands::keyboard;
use crate::state::session::Session;
use crate::tools::playback::paint::{fit, paint_exposed};
use crate::tools::playback::{Playback, frame_at};
use crate::tools::wipe::divider::{self, Corner};
use crate::widgets::number::number_slider;
use crate::widgets::rows::whole;
use crate::widgets::theme;

/// Greatest brightness of a difference, in stops: a step of 1/255 is white then.
const MOST_STOPS: i32 = 8;

impl FlipBook {
    /// Shows the row of controls while the flip book is open.
    pub(super) fn bar(&mut self, ui: &mut Ui, session: &Session, playback: &mut Playback) {
        if !self.is_open() {
            return;
        }
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 3.0;
            for (view, text, help) in [
                (
                    FlipView::Flicker,
                    tr!("Flicker"),
                    tr!("One version at a time: hold V for the other one"),
                ),
                (FlipView::Wipe, tr!("Wipe"), tr!("Both versions: drag the divider")),
                (FlipView::Difference, tr!("Difference"), tr!("What differs, on black")),
            ] {
                if ui.selectable_label(self.view == view, text).on_hover_text(help).clicked() {
                    self.view = view;
                }
            }
            match self.view {
                FlipView::Flicker => {
                    let help = tr!("Shows the frames of the other version (V, while it is held)");
                    ui.toggle_value(&mut self.shows_other, tr!("Other version"))
                        .on_hover_text(help);
                }
                FlipView::Difference => {
                    let slider =
                        number_slider(ui, &mut self.stops, 0..=MOST_STOPS).suffix(tr!(" stops"));
                    let response =
                        ui.add(slider).on_hover_text(tr!("Brightness of the difference"));
                    let stops = f64::from(self.stops);
                    let name = tr!("Brightness of the difference");
                    response.widget_info(|| WidgetInfo::slider(true, stops, name));
                }
                FlipView::Wipe => {}
            }
            let mut chosen = None;
            for (index, version) in self.beside().enumerate() {
                let help = tr!("It is there beside the version that is compared with now, and \
                                that one stays, too");
                let button = ui.button(tr!("Compare with {version}")).on_hover_text(help);
                if button.clicked() {
                    chosen = Some(index);
                }
            }
            if let Some(index) = chosen {
                self.compare_with(index, playback);
            }
            if let (Some(mut form), Some(_)) = (playback.form(), session.open_scene()) {
                let help = tr!(
                    "Draws the frames from the scene's own camera, as chiaro render does, and not \
                     from the window's"
                );
                let by_scene = ui.checkbox(&mut form.by_scene, tr!("Scene's camera"));
                if by_scene.on_hover_text(help).changed() {
                    playback.share(Some(form));
                }
            }
            if ui.button(tr!("Close flip book")).clicked() {
                self.close(playback);
            }
            self.state(ui, session, playback);
        });
    }

    fn state(&self, ui: &mut Ui, session: &Session, playback: &Playback) {
        let colors = theme::of(ui);
        if let Some(problem) = &self.problem {
            ui.label(RichText::new(problem).color(colors.error));
            return;
        }
        let (Some(version), Some(transport)) = (&self.version, playback.transport()) else {
            let text = if self.opens.is_some() {
                tr!("opening")
            } else {
                tr!("open the timeline to compare")
            };
            ui.label(RichText::new(text).color(colors.dim));
            return;
        };
        let frame = frame_at(session.view.time, transport.fps);
        let (text, color) = match frame {
            None => (tr!("between two frames").to_owned(), colors.dim),
            Some(frame) if !version.has(frame) => {
                (tr!("{version} has no frame {frame}", version = version.name), colors.warning)
            }
            Some(frame) => match (self.deltas.get(&frame), version.failed.get(&frame)) {
                (_, Some(problem)) => (problem.message.clone(), colors.error),
                (Some(delta), _) => {
                    let is_wrong = delta.kind.greatest() > self.threshold;
                    let color = if is_wrong { colors.warning } else { colors.dim };
                    (tr!("frame {frame} {difference}", difference = delta.kind.text()), color)
                }
                (None, None) => (tr!("frame {frame} is not compared yet"), colors.dim),
            },
        };
        ui.label(RichText::new(text).color(color));
        if let Some([width, height]) = version.size {
            let help =
                tr!("Frames are drawn in the size of the other version while both are compared");
            let text = RichText::new(format!("{width}×{height}")).color(colors.dim);
            ui.label(text).on_hover_text(help);
        }
    }

    /// Shows the other version, or the difference, over the picture.
    pub(super) fn over(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        playback: &Playback,
        rect: Rect,
        is_pointed_at: bool,
    ) {
        let (Some(version), Some(transport)) = (&self.version, playback.transport()) else {
            return;
        };
        let Some(frame) = frame_at(session.view.time, transport.fps) else { return };
        let name = version.name.clone();
        let other = version.frames.key(frame).zip(version.frames.get(frame).cloned());
        let cache = playback.cache();
        let ours = cache.key(frame).zip(cache.get(frame).cloned());
        let is_free = is_pointed_at || transport.is_playing;
        let is_held = is_free
            && !keyboard::is_keyboard_taken(ui.ctx())
            && ui.input(|input| input.key_down(Key::V));
        let Some(other) = other else {
            if self.view != FlipView::Flicker || self.shows_other || is_held {
                divider::tag(ui, rect, Corner::Right, &tr!("{name}: no frame {frame} yet"));
            }
            return;
        };
        match self.view {
            FlipView::Flicker => {
                let shows_other = self.shows_other != is_held;
                if shows_other {
                    self.show_other(ui, other, rect, rect);
                }
                let shown = if shows_other { name.as_str() } else { tr!("As it is now") };
                divider::tag(ui, rect, Corner::Left, shown);
            }
            FlipView::Wipe => {
                let split = &mut self.split;
                let is_hot = divider::drag(ui, rect, split);
                let [_, right] = divider::halves(rect, *split);
                self.show_other(ui, other, rect, right);
                divider::paint(ui, rect, self.split, is_hot);
                divider::tag(ui, rect, Corner::Left, tr!("As it is now"));
                divider::tag(ui, rect, Corner::Right, &name);
            }
            FlipView::Difference => match ours {
                Some(ours) => self.show_difference(ui, ours, other, rect),
                None => {
                    let text = tr!("The frame as it is now is not drawn yet");
                    divider::tag(ui, rect, Corner::Left, text);
                }
            },
        }
    }

    fn show_other(&mut self, ui: &Ui, other: KeyedPicture, rect: Rect, part: Rect) {
        let is_shown = self.other.as_ref().is_some_and(|shown| shown.of.0 == other.0);
        if !is_shown {
            let image = other.1.clone();
            let texture = match self.other.take() {
                Some(FlipPicture { mut texture, .. }) => {
                    texture.set(image, TextureOptions::LINEAR);
                    texture
                }
                None => ui.ctx().load_texture("other version", image, TextureOptions::LINEAR),
            };
            self.other = Some(FlipPicture { of: other, texture });
        }
        let Some(FlipPicture { texture, .. }) = &self.other else { return };
        let painter = ui.painter_at(part);
        painter.rect_filled(part, 0.0, theme::of(ui).canvas);
        let place = fit(rect, texture.size_vec2());
        paint_exposed(&painter, texture.id(), place, self.exposure);
    }

    fn show_difference(&mut self, ui: &Ui, ours: KeyedPicture, other: KeyedPicture, rect: Rect) {
        let stops = self.stops;
        let is_shown = |shown: &FlipPicture<(KeyedPicture, KeyedPicture, i32)>| {
            let (a, b, of) = &shown.of;
            (a.0, b.0, *of) == (ours.0, other.0, stops)
        };
        ui.painter().rect_filled(rect, 0.0, Color32::BLACK);
        if !self.difference.as_ref().is_some_and(is_shown) {
            let Some(image) = difference::image(&ours.1, &other.1, stops) else {
                let text = tr!("The frames differ in size");
                return divider::tag(ui, rect, Corner::Left, text);
            };
            let texture = match self.difference.take() {
                Some(FlipPicture { mut texture, .. }) => {
                    texture.set(image, TextureOptions::NEAREST);
                    texture
                }
                None => ui.ctx().load_texture("frame difference", image, TextureOptions::NEAREST),
            };
            self.difference = Some(FlipPicture { of: (ours, other, stops), texture });
        }
        if let Some(FlipPicture { texture, .. }) = &self.difference {
            image(ui, texture, rect, texture.size_vec2());
        }
        let text =
            trn!(stops, "Difference, {stops} stop brighter", "Difference, {stops} stops brighter");
        divider::tag(ui, rect, Corner::Left, &text);
    }
}

fn image(ui: &Ui, texture: &TextureHandle, rect: Rect, size: Vec2) {
    ui.painter_at(rect).image(texture.id(), fit(rect, size), whole(), Color32::WHITE);
}
