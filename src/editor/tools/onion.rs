//! Onion skin: ghosts of the picture at the neighboring keys, or some frames away, over the picture
//! of now.
//!
//! A pixel of a ghost is as opaque as it differs from the picture of now, so that only what moves
//! is seen twice. Ghosts are made of the frames that playback keeps, once for each place of the
//! playhead.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{
    Color32, ColorImage, Rect, RichText, Role, TextureHandle, TextureOptions, Ui, WidgetInfo,
};

use super::playback::cache::PictureKey;
use super::playback::paint::fit;
use super::playback::{Playback, frame_at};
use super::{PictureContext, SwitchPlace, ToolRow};
use crate::state::session::Session;
use crate::widgets::menu;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::rows::whole;
use crate::widgets::theme;

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Elsewhere,
    |_| Box::new(OnionSkin::default()),
    |tools| tools.of::<OnionSkin>().is_on,
    // The timeline has the form.
    |_, _, _| {},
)
.with_overlay(|tools, ui, PictureContext { session, rect, .. }, _| {
    let (onion, playback) = tools.pair::<OnionSkin, Playback>();
    onion.over(ui, session, playback, *rect);
});

/// Greatest number of ghosts on each side.
const MOST: u32 = 4;
/// Difference of a channel, in steps of 1/255, from which on a ghost is as opaque as any.
const PLAIN: u32 = 48;
/// Tints of ghosts before and after the playhead.
const TINTS: [Color32; 2] = [Color32::from_rgb(235, 80, 60), Color32::from_rgb(60, 150, 245)];

/// Frames that have ghosts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OnionStep {
    Keys,
    Frames,
}

/// Ghosts on the screen, with the pictures that they were made of and their opacity.
struct OnionPicture {
    of: Vec<(PictureKey, i32)>,
    opacity: f32,
    texture: TextureHandle,
}

/// Onion skin, with its form.
pub(crate) struct OnionSkin {
    is_on: bool,
    by: OnionStep,
    /// Number of ghosts before the playhead, and after it.
    count: u32,
    /// Frames between two ghosts.
    spacing: u32,
    opacity: f32,
    /// Frames that have a key, in order.
    keys: Vec<i32>,
    shown: Option<OnionPicture>,
}

impl Default for OnionSkin {
    fn default() -> Self {
        Self {
            is_on: false,
            by: OnionStep::Keys,
            count: 1,
            spacing: 4,
            opacity: 0.5,
            keys: Vec::new(),
            shown: None,
        }
    }
}

impl OnionSkin {
    /// Shows the form. `keys` gives the times of all keys, in seconds.
    pub(crate) fn form(&mut self, ui: &mut Ui, fps: f64, keys: impl Iterator<Item = f64>) {
        if self.is_on {
            self.keys = keys.map(|time| (time * fps).round() as i32).collect();
            self.keys.sort_unstable();
            self.keys.dedup();
        }
        let text = RichText::new(tr!("Onion skin"));
        let text = if self.is_on { text.color(theme::of(ui).accent) } else { text };
        let menu = menu::staying(ui, text, |ui| {
            let help = tr!("Ghosts of the picture at other times, where it differs from now");
            ui.checkbox(&mut self.is_on, tr!("Show ghosts")).on_hover_text(help);
            ui.radio_value(&mut self.by, OnionStep::Keys, tr!("At keys before and after"));
            ui.radio_value(&mut self.by, OnionStep::Frames, tr!("At frames before and after"));
            ui.horizontal(|ui| {
                let count = ui.add(number_field(ui, &mut self.count).range(1..=MOST));
                count.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Ghosts")));
                ui.label(tr!("on each side"));
            });
            if self.by == OnionStep::Frames {
                ui.horizontal(|ui| {
                    let spacing = ui.add(number_field(ui, &mut self.spacing).range(1..=1000));
                    let name = tr!("Frames between ghosts");
                    spacing.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
                    ui.label(tr!("frames apart"));
                });
            }
            let opacity =
                ui.add(number_slider(ui, &mut self.opacity, 0.05..=1.0).text(tr!("Opacity")));
            let value = f64::from(self.opacity);
            opacity.widget_info(|| WidgetInfo::slider(true, value, tr!("Opacity of ghosts")));
            ui.horizontal(|ui| {
                ui.label(RichText::new(tr!("before")).color(TINTS[0]));
                ui.label(RichText::new(tr!("after")).color(TINTS[1]));
            });
        });
        menu.on_hover_text(tr!("Ghosts of the picture before and after the playhead"));
    }

    /// Frames that have ghosts, before and after a frame; the nearest first.
    fn neighbors(&self, frame: i32) -> [Vec<i32>; 2] {
        let count = self.count.min(MOST) as usize;
        match self.by {
            OnionStep::Keys => {
                let before = self.keys.iter().rev().copied().filter(|key| *key < frame);
                let after = self.keys.iter().copied().filter(|key| *key > frame);
                [before.take(count).collect(), after.take(count).collect()]
            }
            OnionStep::Frames => [-1, 1].map(|way| {
                let step = self.spacing.min(1000) as i32 * way;
                (1..=count as i32).map(|at| frame.saturating_add(step * at)).collect()
            }),
        }
    }

    /// Frames that the onion skin needs: none while it is off, or while something moves.
    pub(crate) fn demands(&self, session: &Session, playback: &Playback) -> Vec<i32> {
        let Some(transport) = playback.transport().filter(|_| self.is_on) else {
            return Vec::new();
        };
        let frame = frame_at(session.view.time, transport.fps);
        let Some(frame) = frame.filter(|_| !playback.is_moving()) else { return Vec::new() };
        let [before, after] = self.neighbors(frame);
        std::iter::once(frame).chain(before).chain(after).collect()
    }

    fn over(&mut self, ui: &Ui, session: &Session, playback: &Playback, rect: Rect) {
        let transport = playback.transport().filter(|_| self.is_on && !playback.is_moving());
        let frame = transport.and_then(|of| frame_at(session.view.time, of.fps));
        let Some((frame, now)) = frame.and_then(|at| Some((at, playback.cache().get(at)?))) else {
            self.shown = None;
            return;
        };
        let cache = playback.cache();
        let mut ghosts: Vec<(PictureKey, i32, &Arc<ColorImage>)> = Vec::new();
        for (side, frames) in self.neighbors(frame).into_iter().enumerate() {
            for (away, at) in (1_i32..).zip(frames) {
                let picture = cache.key(at).zip(cache.get(at));
                let away = if side == 0 { -away } else { away };
                ghosts.extend(picture.map(|(key, image)| (key, away, image)));
            }
        }
        // The nearest ghosts lie above those farther away.
        ghosts.sort_by_key(|(_, away, _)| std::cmp::Reverse(away.abs()));
        let mut of: Vec<(PictureKey, i32)> =
            ghosts.iter().map(|(key, away, _)| (*key, *away)).collect();
        of.extend(cache.key(frame).map(|key| (key, 0)));
        let is_shown = |shown: &OnionPicture| shown.of == of && shown.opacity == self.opacity;
        if !self.shown.as_ref().is_some_and(is_shown) {
            let ghosts: Vec<(i32, &ColorImage)> =
                ghosts.iter().map(|(_, away, image)| (*away, image.as_ref())).collect();
            let image = composed(now, &ghosts, self.opacity);
            let texture = match self.shown.take() {
                Some(OnionPicture { mut texture, .. }) => {
                    texture.set(image, TextureOptions::LINEAR);
                    texture
                }
                None => ui.ctx().load_texture("onion skin", image, TextureOptions::LINEAR),
            };
            self.shown = Some(OnionPicture { of, opacity: self.opacity, texture });
        }
        if let Some(OnionPicture { texture, .. }) = &self.shown {
            let place = fit(rect, texture.size_vec2());
            ui.painter_at(rect).image(texture.id(), place, whole(), Color32::WHITE);
        }
    }
}

/// Ghosts over each other, in their order, transparent where they are as the picture of now. Each
/// comes with its distance from now, negative before; those farther away are fainter.
fn composed(now: &ColorImage, ghosts: &[(i32, &ColorImage)], opacity: f32) -> ColorImage {
    let mut pixels = vec![Color32::TRANSPARENT; now.pixels.len()];
    for (away, ghost) in ghosts.iter().filter(|(_, ghost)| ghost.size == now.size) {
        let tint = TINTS[usize::from(*away > 0)];
        let most = opacity / away.unsigned_abs().max(1) as f32;
        for ((pixel, here), then) in pixels.iter_mut().zip(&now.pixels).zip(&ghost.pixels) {
            if here == then {
                continue;
            }
            let (here, then) = (here.to_array(), then.to_array());
            let apart = (0..4).map(|at| here[at].abs_diff(then[at])).max().unwrap_or(0);
            let part = most * (u32::from(apart).min(PLAIN) as f32 / PLAIN as f32);
            let mixed = |at: usize| then[at] / 2 + tint.to_array()[at] / 2;
            let over = Color32::from_rgb(mixed(0), mixed(1), mixed(2)).gamma_multiply(part);
            *pixel = pixel.blend(over);
        }
    }
    ColorImage::new(now.size, pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ghosts_stand_at_the_nearest_keys_or_frames() {
        let keys = vec![0, 12, 24, 48];
        let mut onion = OnionSkin { keys, count: 2, ..OnionSkin::default() };
        assert_eq!(onion.neighbors(24), [vec![12, 0], vec![48]]);
        assert_eq!(onion.neighbors(13), [vec![12, 0], vec![24, 48]]);
        onion.by = OnionStep::Frames;
        assert_eq!(onion.neighbors(10), [vec![6, 2], vec![14, 18]]);
    }

    #[test]
    fn only_what_differs_is_seen() {
        let now = ColorImage::filled([2, 1], Color32::from_rgb(100, 100, 100));
        let mut before = now.clone();
        before.pixels[1] = Color32::WHITE;
        let wide = ColorImage::filled([3, 1], Color32::WHITE);
        let shown = composed(&now, &[(1, &wide), (-1, &before)], 0.5);
        assert_eq!(shown.pixels[0], Color32::TRANSPARENT);
        let [red, _, blue, alpha] = shown.pixels[1].to_array();
        assert!(alpha.abs_diff(128) <= 1 && red > blue, "{:?}", shown.pixels[1]);
        let far = composed(&now, &[(-2, &before)], 0.5);
        assert!(far.pixels[1].a() < alpha, "a ghost farther away is fainter");
    }
}
