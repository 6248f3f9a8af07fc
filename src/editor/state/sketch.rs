//! Sketch that was painted on the picture, and its past.
//!
//! A sketch is a small picture over the viewport's, straight RGBA as the command `chiaro fit` takes
//! it: the color is the goal of a pixel, alpha the weight of that goal. A sketch applies to the
//! view that it was painted in, and to no other. Its steps lie in the window's one order of undo
//! while they are seen.

use std::sync::Arc;

use crate::document::{Camera, Tile};
use crate::state::document::times::Times;
use crate::state::orbit::Orbit;
use crate::state::revision::StepTime;

/// Largest number of steps that can be taken back: each holds a picture of about a megabyte.
const MOST_STEPS: usize = 32;

/// View and moment that a sketch was painted at.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Standpoint {
    pub(crate) orbit: Orbit,
    /// Moment, in seconds.
    time: f64,
}

impl Standpoint {
    pub(crate) fn new(orbit: &Orbit, time: f64) -> Self {
        Self { orbit: orbit.clone(), time }
    }

    /// True if pixels show the same places in another view. The turn of the lights does not count.
    pub(crate) fn sees_as(&self, orbit: &Orbit, time: f64) -> bool {
        let of = |orbit: &Orbit| -> (Camera, String, bool) {
            (orbit.camera(), orbit.mesh.clone(), orbit.z_is_up)
        };
        self.time == time && of(&self.orbit) == of(orbit)
    }

    /// The standpoint's view, lit as `orbit` is and before its backdrop; and the moment in seconds.
    pub(crate) fn back(&self, orbit: &Orbit) -> (Orbit, f64) {
        let back = Orbit {
            illumination: orbit.illumination,
            backdrop: orbit.backdrop,
            ..self.orbit.clone()
        };
        (back, self.time)
    }
}

/// A sketch at one moment.
#[derive(Clone, Debug, Default)]
struct State {
    standpoint: Option<Standpoint>,
    tile: Option<Arc<Tile>>,
}

/// Sketch on the picture, with its steps.
#[derive(Debug, Default)]
pub struct Sketch {
    state: State,
    /// Label of each done step, and the state before it.
    done: Vec<(&'static str, State)>,
    /// Label of each undone step, and the state after it, the next to redo last.
    undone: Vec<(&'static str, State)>,
    pub(crate) times: Times,
    /// True while the sketch is seen, so that undo takes its steps back.
    pub(crate) is_open: bool,
}

impl Sketch {
    /// The painted picture, straight RGBA; `None` where nothing was ever painted.
    pub fn tile(&self) -> Option<&Arc<Tile>> {
        self.state.tile.as_ref()
    }

    /// The sketch with nothing to take back.
    pub(crate) fn without_past(self) -> Self {
        Self { state: self.state, ..Self::default() }
    }

    /// True if no pixel has a goal.
    pub fn is_empty(&self) -> bool {
        self.state
            .tile
            .as_ref()
            .is_none_or(|tile| tile.bytes().chunks_exact(4).all(|texel| texel[3] == 0))
    }

    /// View and moment that the sketch was painted at.
    pub(crate) fn standpoint(&self) -> Option<&Standpoint> {
        self.state.standpoint.as_ref()
    }

    /// Replaces the painted picture: a step that can be taken back.
    pub(crate) fn did(
        &mut self,
        what: &'static str,
        standpoint: Standpoint,
        tile: Option<Tile>,
        now: StepTime,
    ) {
        if self.done.len() >= MOST_STEPS {
            self.done.remove(0);
            self.times.fit((self.done.len(), self.undone.len()));
        }
        let state =
            State { standpoint: tile.is_some().then_some(standpoint), tile: tile.map(Arc::new) };
        self.done.push((what, std::mem::replace(&mut self.state, state)));
        self.undone.clear();
        self.times.did((self.done.len(), 0), now);
    }

    pub(crate) fn undo(&mut self) -> bool {
        let Some((what, before)) = self.done.pop() else { return false };
        self.undone.push((what, std::mem::replace(&mut self.state, before)));
        self.times.undid();
        true
    }

    pub(crate) fn redo(&mut self, now: StepTime) -> bool {
        let Some((what, after)) = self.undone.pop() else { return false };
        self.done.push((what, std::mem::replace(&mut self.state, after)));
        self.times.redid(now);
        true
    }

    pub(crate) fn undo_label(&self) -> Option<&'static str> {
        self.done.last().map(|(what, _)| *what)
    }

    pub(crate) fn redo_label(&self) -> Option<&'static str> {
        self.undone.last().map(|(what, _)| *what)
    }

    /// Number of done steps.
    pub(crate) fn place(&self) -> usize {
        self.done.len()
    }

    /// Labels of all steps: the done ones, then the undone ones, the next to redo first.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &'static str> {
        self.done.iter().chain(self.undone.iter().rev()).map(|(what, _)| *what)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(value: u8) -> Option<Tile> {
        Some(Tile::filled([2, 2], [value, value, value, 255]))
    }

    #[test]
    fn strokes_are_taken_back_and_only_so_many_are_kept() {
        let here = || Standpoint::new(&Orbit::default(), 0.0);
        let mut sketch = Sketch::default();
        assert!(sketch.is_empty() && !sketch.undo());
        for step in 0..60_u8 {
            sketch.did("light", here(), dot(step), StepTime(u64::from(step)));
        }
        assert_eq!((sketch.place(), sketch.times.all().count()), (MOST_STEPS, MOST_STEPS));
        assert_eq!(sketch.times.last(), Some(StepTime(59)));
        assert!(sketch.undo());
        assert_eq!(sketch.tile().unwrap().bytes()[0], 58);
        assert!(sketch.redo(StepTime(61)) && !sketch.redo(StepTime(62)));
        assert_eq!(
            (sketch.tile().unwrap().bytes()[0], sketch.times.last()),
            (59, Some(StepTime(61)))
        );
        sketch.did("clear", here(), None, StepTime(63));
        assert!(sketch.is_empty() && sketch.standpoint().is_none());
        assert!(sketch.undo() && !sketch.is_empty() && sketch.standpoint().is_some());
    }

    #[test]
    fn another_camera_or_moment_is_another_view_and_other_lights_are_not() {
        let here = Standpoint::new(&Orbit::default(), 1.0);
        let mut orbit = Orbit::default();
        orbit.turn_lights(0.2, 0.1);
        assert!(here.sees_as(&orbit, 1.0) && !here.sees_as(&orbit, 2.0));
        orbit.orbit(0.1, 0.0);
        assert!(!here.sees_as(&orbit, 1.0));
        let (back, time) = here.back(&orbit);
        assert!(here.sees_as(&back, time) && back.illumination == orbit.illumination);
    }
}
