//! The pointer on the picture: strokes, each one step of undo.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Event, Modifiers, PointerButton, Pos2, Rect, Response, Ui};
use glam::DVec2;

use super::FitTool;
use super::cover::Cover;
use super::ground::Ground;
use super::target::FINENESS;
use super::tools::Tools;
use crate::commands::{Command, LightBrush, SketchCommand};
use crate::document::Tile;
use crate::state::session::Session;
use crate::state::sketch::Standpoint;

/// Stroke under way; the painted goal of a pixel follows from its coverage.
pub(super) struct LightStroke {
    cover: Cover,
    before: Arc<Tile>,
    pub(super) now: Arc<Tile>,
    tools: Tools,
    /// True once the stroke has met the object.
    meets: bool,
}

/// Stroke over a picture that is still being read.
pub(super) struct WaitingStroke {
    /// Path of the stroke, in heights of the picture from its center.
    pub(super) path: Vec<DVec2>,
    /// Brush at the beginning of the stroke.
    tools: Tools,
    /// True once the button is up again.
    is_over: bool,
}

impl LightStroke {
    fn begin(before: Arc<Tile>, tools: &Tools) -> Self {
        let size = before.size();
        let cover = Cover::new(size, tools.radius(size[1]), tools.hardness);
        Self { cover, now: before.clone(), before, tools: tools.clone(), meets: false }
    }

    /// Extends the stroke to a place in pixels of the sketch.
    fn to(&mut self, at: DVec2, ground: &Ground) {
        let [width, _] = self.before.size();
        for ([x, y], cover) in self.cover.to(at) {
            let place = |x: u32| (f64::from(x) + 0.5) / f64::from(FINENESS);
            let (shown, share) = ground.at(place(x), place(y));
            if share < 0.5 && self.tools.kind != LightBrush::Erase {
                continue;
            }
            self.meets = true;
            let at = 4 * (y as usize * width as usize + x as usize);
            let texel = laid(&self.before.bytes()[at..at + 4], cover, shown, &self.tools);
            Arc::make_mut(&mut self.now).bytes_mut()[at..at + 4].copy_from_slice(&texel);
        }
    }
}

/// Converts a place in heights of the picture from its center to pixels of a sketch.
fn on_sketch(at: DVec2, size: [u32; 2]) -> DVec2 {
    let [width, height] = size.map(f64::from);
    at * height + 0.5 * DVec2::new(width, height)
}

/// Pixel of a sketch after a stroke that covers it by `cover`.
fn laid(before: &[u8], cover: f64, shown: [f64; 3], tools: &Tools) -> [u8; 4] {
    let [r, g, b, alpha] = [0, 1, 2, 3].map(|channel| f64::from(before[channel]) / 255.0);
    let was = [r, g, b];
    let seen = std::array::from_fn(|c| shown[c] + alpha * (was[c] - shown[c]));
    let byte = |x: f64| x.clamp(0.0, 1.0).mul_add(255.0, 0.5) as u8;
    let Some(goal) = tools.goal(shown, seen) else {
        return [before[0], before[1], before[2], byte(alpha * (1.0 - cover))];
    };
    let rest = alpha * (1.0 - cover);
    let [r, g, b] =
        std::array::from_fn(|c| byte((goal[c] * cover + was[c] * rest) / (cover + rest)));
    [r, g, b, byte(cover + rest)]
}

impl FitTool {
    /// Handles the pointer over the picture in `rect`.
    pub(super) fn paint(
        &mut self,
        ui: &Ui,
        response: &Response,
        rect: Rect,
        session: &Session,
    ) -> Option<Command> {
        let (is_down, is_pressed, modifiers) = ui.input(|input| {
            let pointer = &input.pointer;
            (
                pointer.primary_down(),
                pointer.button_pressed(PointerButton::Primary),
                input.modifiers,
            )
        });
        let canvas = Self::canvas(rect, self.size(session));
        // However wide the picture becomes, its center and its height stay the same.
        let place = |at: Pos2| {
            let [x, y] = (at - canvas.center()).into();
            DVec2::new(f64::from(x), f64::from(y)) / f64::from(canvas.height().max(1.0))
        };
        let mut out = None;
        let is_free = self.going.is_none() && self.waiting.is_none();
        if is_free && is_pressed && response.is_pointer_button_down_on() && !modifiers.alt {
            let at = ui.input(|input| input.pointer.press_origin()).map(place);
            out = at.and_then(|at| self.press(at, modifiers, session));
        }
        let path = ui.input(|input| {
            let moves = input.events.iter().filter_map(|event| match event {
                Event::PointerMoved(at) => Some(place(*at)),
                _ => None,
            });
            moves.collect::<Vec<DVec2>>()
        });
        if let Some(going) = &mut self.going {
            let ground = self.grounds.latest();
            for at in path {
                ground
                    .into_iter()
                    .for_each(|ground| going.to(on_sketch(at, going.before.size()), ground));
            }
        } else if let Some(waiting) = self.waiting.as_mut().filter(|waiting| !waiting.is_over) {
            waiting.path.extend(path);
            waiting.is_over = !is_down;
        }
        if self.waiting.is_some() && (self.ground().is_some() || self.obstacle(session).is_some()) {
            let is_over = self.waiting.as_ref().is_some_and(|waiting| waiting.is_over);
            out = out.or(self.catch_up(session));
            if is_over && let Some(going) = self.going.take() {
                out = out.or(self.end(going, session));
            }
            return out;
        }
        if !is_down && let Some(going) = self.going.take() {
            out = out.or(self.end(going, session));
        }
        out
    }

    fn press(&mut self, at: DVec2, modifiers: Modifiers, session: &Session) -> Option<Command> {
        if let Some(obstacle) = self.obstacle(session) {
            return Some(Command::Tell(obstacle.to_owned()));
        }
        if modifiers.command {
            let Some(ground) = self.ground() else {
                return Some(Command::Tell(
                    tr!("The picture is being read: take the color in a moment").to_owned(),
                ));
            };
            let place = on_sketch(at, ground.size);
            let (shown, share) = ground.at(place.x, place.y);
            if share > 0.0 {
                self.tools.color = shown;
                self.tools.kind = LightBrush::Color;
            }
            return None;
        }
        self.waiting =
            Some(WaitingStroke { path: vec![at], tools: self.tools.clone(), is_over: false });
        self.told = None;
        None
    }

    /// Begins the waiting stroke, and draws its path so far.
    fn catch_up(&mut self, session: &Session) -> Option<Command> {
        let waiting = self.waiting.take()?;
        if let Some(obstacle) = self.obstacle(session) {
            return Some(Command::Tell(obstacle.to_owned()));
        }
        let ground = self.ground()?;
        let empty = || Arc::new(Tile::filled(ground.size.map(|side| side * FINENESS), [0; 4]));
        let before = session.sketchbook.sketch().tile().cloned().unwrap_or_else(empty);
        let mut going = LightStroke::begin(before, &waiting.tools);
        for at in waiting.path {
            going.to(on_sketch(at, going.before.size()), ground);
        }
        self.going = Some(going);
        None
    }

    fn end(&self, going: LightStroke, session: &Session) -> Option<Command> {
        if !going.meets {
            let told =
                tr!("That stroke met no object that wears this look: only strokes on it count");
            return Some(Command::Tell(told.to_owned()));
        }
        if going.now != going.before {
            let from = match session.sketchbook.sketch().standpoint() {
                Some(standpoint) => standpoint.clone(),
                None => Standpoint::new(&session.view.orbit, session.view.time),
            };
            let is_empty = going.now.bytes().chunks_exact(4).all(|texel| texel[3] == 0);
            let tile = Arc::unwrap_or_clone(going.now);
            let (label, tile) = (going.tools.kind.step(), (!is_empty).then_some(tile));
            return Some(Command::Sketch(SketchCommand::Paint {
                label,
                from: Box::new(from),
                tile,
            }));
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_wishes_as_much_as_it_covers_and_a_second_one_goes_on_from_there() {
        let tools = Tools::default();
        let shown = [0.3, 0.25, 0.2];
        let half = laid(&[0; 4], 0.5, shown, &tools);
        let goal = tools.goal(shown, shown).unwrap();
        let near = |a: u8, b: f64| (f64::from(a) / 255.0 - b).abs() < 0.003;
        assert!((0..3).all(|c| near(half[c], goal[c])) && near(half[3], 0.5), "{half:?}");
        let whole = laid(&[0; 4], 1.0, shown, &tools);
        let twice = laid(&whole, 1.0, shown, &tools);
        assert!((0..3).all(|c| twice[c] > whole[c]) && twice[3] == 255);
        let keep = Tools { kind: LightBrush::Keep, ..tools.clone() };
        assert!(
            (0..3).all(|c| near(laid(&twice, 1.0, shown, &keep)[c], shown[c])),
            "it stays as the look shows it"
        );
        let erase = Tools { kind: LightBrush::Erase, ..tools };
        assert_eq!(laid(&twice, 1.0, shown, &erase)[3], 0);
        assert!(near(laid(&twice, 0.25, shown, &erase)[3], 0.75));
    }
}
