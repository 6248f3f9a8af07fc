//! Places of a highlight's handles on the screen, and the values that dragged handles have there.
//!
//! Handles stand at the edge of the highlight, as large as it is drawn around its middle, and a
//! little outside: at an end, at a corner, in a notch between two rays. A split highlight has them
//! at one of its parts. Where the value of a handle is 0 the handle stands apart from the middle,
//! so that all of them are at hand on the smallest highlight.

use std::f64::consts::{PI, TAU};

use eframe::egui::{Pos2, Vec2};

use super::handle::{HighlightHandle, Side};
use crate::fields::layer::HighlightShape;

/// Distance of the handles from the edge, and of those of a split from the middle, in points.
const NEAR: f32 = 16.0;
/// Least radius of the highlight that handles stand around, in points, and that of the star's: its
/// notches need room.
const LEAST_RADIUS: f32 = 10.0;
const LEAST_STAR: f32 = 36.0;
/// Distance of the ring from the handles within, in points.
const ASIDE: f32 = 22.0;
/// Least and largest radius of the ring, in points and in heights of the picture.
const LEAST_RING: f32 = 58.0;
const LARGEST_RING: f32 = 0.3;
/// Points that a stretch, or corners, by the factor e take.
const STRETCH: f32 = 40.0;
/// Ranges of the values that are dragged.
const STRETCHED: [f64; 2] = [-0.5, 0.95];
const SQUARED: [f64; 2] = [0.0, 0.95];
const RAYS: [f64; 2] = [2.0, 64.0];
/// Part of the radius by which a star of 1 is notched: the inner radius that the node *Star* has
/// when it is added leaves the rest.
const NOTCH: f32 = 0.65;

/// Middle, axes and shape of a highlight on the screen, around which its handles stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct HandleFrame {
    /// Place of the middle.
    pub(super) at: Pos2,
    /// The layer's own axes before they are turned, foreshortened.
    pub(super) upright: [Vec2; 2],
    /// Points that a turn of the normals by a radian takes.
    pub(super) scale: f32,
    /// Height of the picture, in points.
    pub(super) height: f32,
    pub(super) shape: HighlightShape,
}

/// Line on the screen along which a handle is dragged.
struct DragLine {
    from: Pos2,
    /// Unit.
    along: Vec2,
    /// Distance from the beginning at which the handle stands where its value is 0.
    rest: f32,
}

impl HandleFrame {
    /// The layer's axes, foreshortened.
    fn turned(&self) -> [Vec2; 2] {
        let (sin, cos) = (self.shape.turn as f32).sin_cos();
        let [x, y] = self.upright;
        [cos * x + sin * y, cos * y - sin * x]
    }

    /// Directions of the layer's axes on the screen, unit.
    pub(super) fn axes(&self) -> [Vec2; 2] {
        self.turned().map(Vec2::normalized)
    }

    /// Points that a radian takes along each axis: fewer along one that is seen from its end.
    fn reach(&self) -> [f32; 2] {
        let [x, y] = self.turned();
        let mean = (x.x * y.y - x.y * y.x).abs().sqrt().max(1e-3);
        [x, y].map(|axis| self.scale * (axis.length() / mean).clamp(0.5, 2.0))
    }

    /// Radii of the highlight on the screen along both axes, and between them.
    fn radii(&self) -> [f32; 3] {
        let [x, y] = self.reach();
        let radius = self.shape.radius.clamp(0.0, 1.0) as f32;
        [x, y, 0.5 * (x + y)].map(|reach| (reach * radius).max(LEAST_RADIUS))
    }

    /// Middle of the part of a split highlight that lies on these sides.
    fn part(&self, sides: [Side; 2]) -> Pos2 {
        let (axes, reach) = (self.axes(), self.reach());
        let split = self.shape.split.map(|apart| apart.clamp(0.0, 1.0) as f32);
        let aside = |axis: usize| sides[axis].sign() * reach[axis] * split[axis] * axes[axis];
        self.at + aside(0) + aside(1)
    }

    /// Radius of the star on the screen.
    fn star(&self) -> f32 {
        self.radii()[2].max(LEAST_STAR)
    }

    /// Radius of the ring, around the handles of the upright axis.
    pub(super) fn ring(&self) -> f32 {
        let apart = self.reach()[1] * self.shape.split[1].clamp(0.0, 1.0) as f32;
        let inner = NEAR + apart + self.radii()[1].max(LEAST_STAR);
        (inner + ASIDE).clamp(LEAST_RING, (LARGEST_RING * self.height).max(LEAST_RING))
    }

    /// Direction on the screen at an angle of the layer's own, from its first axis on.
    fn toward(&self, angle: f64) -> Vec2 {
        let ((sin, cos), [x, y]) = ((angle as f32).sin_cos(), self.axes());
        (cos * x + sin * y).normalized()
    }

    /// Angle of the notch that lies nearest to the half of a right angle.
    fn notch(&self) -> f64 {
        let sector = TAU / self.rays();
        ((PI / 4.0 - 0.5 * sector) / sector).round() * sector + 0.5 * sector
    }

    fn rays(&self) -> f64 {
        self.shape.rays.round().clamp(RAYS[0], RAYS[1])
    }

    fn line(&self, handle: HighlightHandle) -> Option<DragLine> {
        let ([x, y], [along_x, _, between]) = (self.axes(), self.radii());
        let (ahead, behind) = (Side::Ahead, Side::Behind);
        Some(match handle {
            HighlightHandle::Middle | HighlightHandle::Ring | HighlightHandle::Rays => return None,
            HighlightHandle::Split(side) => {
                DragLine { from: self.at, along: side.sign() * x, rest: NEAR }
            }
            HighlightHandle::SplitUp(side) => {
                DragLine { from: self.at, along: side.sign() * y, rest: NEAR }
            }
            HighlightHandle::Stretch => {
                let from = self.part([ahead, ahead]);
                DragLine { from, along: x, rest: NEAR + along_x }
            }
            HighlightHandle::Size => {
                let from = self.part([ahead, behind]);
                DragLine { from, along: (x - y).normalized(), rest: NEAR }
            }
            HighlightHandle::Square => {
                let from = self.part([behind, ahead]);
                DragLine { from, along: (y - x).normalized(), rest: NEAR + between }
            }
            HighlightHandle::Star => {
                let from = self.part([ahead, ahead]);
                DragLine { from, along: self.toward(self.notch()), rest: NEAR + self.star() }
            }
        })
    }

    /// Place of a handle.
    pub(super) fn place(&self, handle: HighlightHandle) -> Pos2 {
        let [reach_x, reach_y] = self.reach();
        let shape = &self.shape;
        let way = match handle {
            HighlightHandle::Middle => return self.at,
            HighlightHandle::Ring => return self.at + self.ring() * self.axes()[1],
            HighlightHandle::Rays => {
                let tip = self.toward(TAU / self.rays());
                return self.part([Side::Ahead; 2]) + (NEAR + self.star()) * tip;
            }
            HighlightHandle::Split(_) => reach_x * shape.split[0].clamp(0.0, 1.0) as f32,
            HighlightHandle::SplitUp(_) => reach_y * shape.split[1].clamp(0.0, 1.0) as f32,
            HighlightHandle::Stretch => drawn_out(shape.stretch, STRETCHED),
            HighlightHandle::Square => drawn_out(shape.square, SQUARED),
            HighlightHandle::Size => self.between() * shape.radius.clamp(0.0, 1.0) as f32,
            HighlightHandle::Star => -NOTCH * self.star() * shape.star.clamp(0.0, 1.0) as f32,
        };
        self.line(handle).map_or(self.at, |line| line.from + (line.rest + way) * line.along)
    }

    /// Value of a handle that is dragged to a place; `None` for those that are no number, or where
    /// the axes are seen from their ends.
    pub(super) fn value_at(&self, handle: HighlightHandle, to: Pos2) -> Option<f64> {
        let [reach_x, reach_y] = self.reach();
        if handle == HighlightHandle::Rays {
            let angle = angle_of(to - self.part([Side::Ahead; 2]), self.axes())?.abs();
            return Some((TAU / angle.max(TAU / RAYS[1])).round().clamp(RAYS[0], RAYS[1]));
        }
        let line = self.line(handle)?;
        let way = (to - line.from).dot(line.along) - line.rest;
        let part = |way: f32, reach: f32| f64::from(way / reach.max(1.0)).clamp(0.0, 1.0);
        Some(match handle {
            HighlightHandle::Middle | HighlightHandle::Ring | HighlightHandle::Rays => return None,
            HighlightHandle::Split(_) => part(way, reach_x),
            HighlightHandle::SplitUp(_) => part(way, reach_y),
            HighlightHandle::Stretch => part_drawn_out(way, STRETCHED),
            HighlightHandle::Square => part_drawn_out(way, SQUARED),
            HighlightHandle::Size => part(way, self.between()),
            HighlightHandle::Star => part(-way, NOTCH * self.star()),
        })
    }

    /// Points that a radian takes between the axes.
    fn between(&self) -> f32 {
        let [x, y] = self.reach();
        0.5 * (x + y)
    }

    /// Turn of the first axis toward a place less a quarter turn, in radians: the handle of the
    /// ring stands on the second axis.
    pub(super) fn turn_at(&self, to: Pos2) -> Option<f64> {
        Some(angle_of(to - self.at, self.upright)? - 0.5 * PI)
    }
}

/// Angle of a way on the screen from the first of two axes toward the second, which may be
/// foreshortened: the way is made of both.
fn angle_of(way: Vec2, [x, y]: [Vec2; 2]) -> Option<f64> {
    let det = x.x * y.y - x.y * y.x;
    if det.abs() < 1e-4 {
        return None;
    }
    let (along, up) = ((way.x * y.y - way.y * y.x) / det, (x.x * way.y - x.y * way.x) / det);
    Some(f64::from(up.atan2(along)))
}

/// Points that a length which is drawn out by a part takes more than one that is not.
fn drawn_out(part: f64, [low, high]: [f64; 2]) -> f32 {
    -STRETCH * (1.0 - part.clamp(low, high)).ln() as f32
}

/// Part by which a length that takes so many points more is drawn out.
fn part_drawn_out(way: f32, [low, high]: [f64; 2]) -> f64 {
    (1.0 - f64::from(-way / STRETCH).exp()).clamp(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::{pos2, vec2};

    const SHAPE: HighlightShape = HighlightShape {
        radius: 0.14,
        cutoff: 0.14,
        turn: -0.3,
        stretch: 0.0,
        split: [0.16, 0.0],
        square: 0.3,
        star: 0.25,
        rays: 5.0,
    };

    fn frame(shape: HighlightShape) -> HandleFrame {
        let upright = [vec2(0.9, 0.1), vec2(0.05, -0.8)];
        HandleFrame { at: pos2(300.0, 200.0), upright, scale: 220.0, height: 500.0, shape }
    }

    #[test]
    fn knobs_stand_where_a_drag_puts_them() {
        let stands = |handle: HighlightHandle, value: f64, shape: HighlightShape| {
            let frame = frame(shape);
            let again = frame.value_at(handle, frame.place(handle)).expect("a number");
            assert!((again - value).abs() < 1e-4, "{handle:?}: {again} for {value}");
        };
        for stretch in [-0.5, 0.0, 0.4, 0.95] {
            stands(HighlightHandle::Stretch, stretch, HighlightShape { stretch, ..SHAPE });
        }
        for value in [0.0, 0.3, 1.0] {
            for side in [Side::Ahead, Side::Behind] {
                let split = HighlightShape { split: [value, 0.2], ..SHAPE };
                stands(HighlightHandle::Split(side), value, split);
                let split = HighlightShape { split: [0.2, value], ..SHAPE };
                stands(HighlightHandle::SplitUp(side), value, split);
            }
            stands(HighlightHandle::Size, value, HighlightShape { radius: value, ..SHAPE });
            stands(HighlightHandle::Star, value, HighlightShape { star: value, ..SHAPE });
            let square = 0.9 * value;
            stands(HighlightHandle::Square, square, HighlightShape { square, ..SHAPE });
        }
        for rays in [2.0, 3.0, 4.0, 5.0, 12.0, 63.0, 64.0] {
            stands(HighlightHandle::Rays, rays, HighlightShape { rays, ..SHAPE });
        }
        for stretch in [f64::NEG_INFINITY, 1.0] {
            let frame = frame(HighlightShape { stretch, ..SHAPE });
            assert!(frame.place(HighlightHandle::Stretch).is_finite());
        }
    }

    #[test]
    fn handles_of_a_split_highlight_stand_at_its_parts() {
        let wide = frame(HighlightShape { split: [0.4, 0.3], ..SHAPE });
        let [x, y] = wide.axes();
        let aside = |handle| {
            let way = wide.place(handle) - wide.at;
            [way.dot(x), way.dot(y)]
        };
        let [right, low] = aside(HighlightHandle::Size);
        assert!(right > 80.0 && low < -40.0, "{right} {low}");
        let [left, high] = aside(HighlightHandle::Square);
        assert!(left < -80.0 && high > 40.0, "{left} {high}");
        let both = [Side::Ahead, Side::Behind].map(|side| aside(HighlightHandle::Split(side)));
        assert!(both[0][0] > 80.0 && (both[0][0] + both[1][0]).abs() < 1e-3, "opposed: {both:?}");
    }

    /// A handle within reach of another one could not be taken.
    #[test]
    fn handles_are_apart_on_the_smallest_highlight_and_on_a_large_one() {
        for rays in [3.0, 4.0, 5.0, 8.0] {
            for radius in [0.0, 0.14, 0.3] {
                let shape = HighlightShape { radius, rays, star: 0.5, split: [0.16, 0.1], ..SHAPE };
                let frame = frame(shape);
                let places = HighlightHandle::ALL.map(|handle| (handle, frame.place(handle)));
                for (index, (one, at)) in places.iter().enumerate() {
                    for (other, there) in &places[..index] {
                        let apart = at.distance(*there);
                        assert!(apart > 16.0, "{one:?} {other:?}: {apart} at {radius}, {rays}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_turn_is_read_from_foreshortened_axes() {
        let frame = frame(SHAPE);
        let at = frame.turn_at(frame.place(HighlightHandle::Ring)).expect("it is seen");
        assert!((at - SHAPE.turn).abs() < 1e-4, "{at}");
        let flat = HandleFrame { upright: [vec2(1.0, 0.0), vec2(2.0, 0.0)], ..frame };
        assert_eq!(flat.turn_at(pos2(310.0, 210.0)), None, "seen from the end of an axis");
    }
}
