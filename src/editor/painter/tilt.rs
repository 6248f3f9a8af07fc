//! Placement of the tile on the screen: turned and tilted as the eye sees it, without perspective,
//! so that one affine map leads from texels to points, and back under the pointer.
//!
//! The eye's own direction along the surface points down the screen, as the near edge of a sheet on
//! a table does. Seen along the normal, or flat, v points up.

use eframe::egui::{Pos2, Rect, Vec2, pos2, vec2};
use glam::{DVec2, DVec3};

use crate::document::{Direction, Grid};

/// Least height at which the tile is seen, as a part of its full height: the tile can still be
/// painted on however low the eye stands.
const LEAST_HEIGHT: f64 = 0.22;

/// Map from texels to points of the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tilt {
    /// Middle of the tile on the screen.
    pub(super) middle: Pos2,
    /// Half the tile's size, in texels.
    half: DVec2,
    /// Vectors of one texel to the right and one downward, in points.
    right: DVec2,
    down: DVec2,
    /// Direction along the surface toward the eye (u, v), and the angle between the eye and the
    /// normal, as shown.
    toward: DVec2,
    theta: f64,
    /// Points per texel.
    scale: f64,
}

impl Tilt {
    /// Tile of a grid as a view sees it: its middle at a point of the screen, a texel `scale`
    /// points wide.
    pub(super) fn new(
        grid: &Grid,
        view: Direction,
        is_flat: bool,
        middle: Pos2,
        scale: f64,
    ) -> Self {
        let [theta, phi] = grid.view.angles(view.canonical());
        let is_flat = is_flat || view.theta == 0;
        let (theta, toward) = match is_flat {
            true => (0.0, DVec2::NEG_Y),
            false => (theta, DVec2::new(phi.sin(), phi.cos())),
        };
        let height = theta.cos().max(LEAST_HEIGHT);
        // A place (u, v) goes across by its part at a right angle to the eye's direction, and down
        // by its part along that direction, toward the eye.
        let across = DVec2::new(-toward.y, toward.x);
        let of = |place: DVec2| DVec2::new(place.dot(across), place.dot(toward) * height) * scale;
        Self {
            middle,
            half: DVec2::new(f64::from(grid.size[0]), f64::from(grid.size[1])) / 2.0,
            right: of(DVec2::X),
            down: of(DVec2::NEG_Y),
            toward,
            theta,
            scale,
        }
    }

    /// Point of the screen at a place in texels, from the upper left corner of the tile.
    pub(super) fn screen(&self, texel: DVec2) -> Pos2 {
        let from_middle = texel - self.half;
        let by = self.right * from_middle.x + self.down * from_middle.y;
        self.middle + vec2(by.x as f32, by.y as f32)
    }

    /// Place in texels at a point of the screen; it may lie on a copy beside the tile.
    pub(super) fn texel(&self, at: Pos2) -> DVec2 {
        let by = at - self.middle;
        let by = DVec2::new(f64::from(by.x), f64::from(by.y));
        let area = self.right.perp_dot(self.down);
        DVec2::new(by.perp_dot(self.down), self.right.perp_dot(by)) / area + self.half
    }

    /// Corners of the copy of the tile that lies `copy` tiles to the right and down.
    pub(super) fn corners(&self, copy: [i32; 2]) -> [Pos2; 4] {
        let from = DVec2::new(f64::from(copy[0]), f64::from(copy[1])) * self.half * 2.0;
        let to = from + self.half * 2.0;
        [from, DVec2::new(to.x, from.y), to, DVec2::new(from.x, to.y)]
            .map(|corner| self.screen(corner))
    }

    /// Tip of a vector from the middle of the tile as seen on the screen, in points; the vector is
    /// along u, along v and along the normal.
    pub(super) fn tip(&self, vector: DVec3) -> Vec2 {
        let across = DVec2::new(-self.toward.y, self.toward.x);
        let along = vector.truncate();
        let down = along.dot(self.toward) * self.theta.cos() - vector.z * self.theta.sin();
        vec2(along.dot(across) as f32, down as f32)
    }

    /// Outline of a brush at a place as seen on the screen; the diameter is in texels.
    pub(super) fn outline(&self, at: DVec2, diameter: f64) -> Vec<Pos2> {
        const POINTS: u32 = 48;
        let point = |index: u32| {
            let turn = f64::from(index) / f64::from(POINTS) * std::f64::consts::TAU;
            self.screen(at + DVec2::from_angle(turn) * diameter / 2.0)
        };
        (0..POINTS).map(point).collect()
    }

    /// Copies of the tile that are seen in a rectangle, the tile itself first; at most a few
    /// hundred.
    pub(super) fn copies(&self, room: Rect) -> Vec<[i32; 2]> {
        const MOST: i32 = 8;
        let seen = [room.left_top(), room.right_top(), room.right_bottom(), room.left_bottom()];
        let size = self.half * 2.0;
        let seen = seen.map(|corner| self.texel(corner) / size);
        let least = seen.into_iter().fold(DVec2::MAX, DVec2::min).floor();
        let most = seen.into_iter().fold(DVec2::MIN, DVec2::max).floor();
        let range = |least: f64, most: f64| (least as i32).max(-MOST)..=(most as i32).min(MOST);
        let all = range(least.y, most.y).flat_map(|y| range(least.x, most.x).map(move |x| [x, y]));
        std::iter::once([0, 0]).chain(all.filter(|copy| *copy != [0, 0])).collect()
    }

    /// Points per texel.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    /// Bounding rectangle of the tile on the screen.
    pub(super) fn bounds(&self) -> Rect {
        let corners = self.corners([0, 0]);
        corners.into_iter().fold(Rect::from_min_max(corners[0], corners[0]), |rect, corner| {
            Rect::from_min_max(
                pos2(rect.min.x.min(corner.x), rect.min.y.min(corner.y)),
                pos2(rect.max.x.max(corner.x), rect.max.y.max(corner.y)),
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Pos2, b: Pos2) -> bool {
        a.distance(b) < 1e-3
    }

    #[test]
    fn from_above_the_tile_is_as_it_is() {
        let tilt = Tilt::new(&Grid::THESIS, Direction::default(), false, pos2(100.0, 50.0), 2.0);
        assert!(near(tilt.screen(DVec2::ZERO), pos2(68.0, 18.0)));
        assert!(near(tilt.screen(DVec2::new(32.0, 0.0)), pos2(132.0, 18.0)));
        let low = Direction { theta: 4, phi: 3 };
        assert_eq!(
            Tilt::new(&Grid::THESIS, low, true, pos2(100.0, 50.0), 2.0),
            tilt,
            "flat is from above"
        );
    }

    #[test]
    fn the_eye_is_at_the_bottom_of_the_screen() {
        for phi in 0..10 {
            let view = Direction { theta: 3, phi };
            let tilt = Tilt::new(&Grid::THESIS, view, false, pos2(0.0, 0.0), 4.0);
            let eye = tilt.tip(Grid::THESIS.view.vector(view));
            assert!(eye.length() < 1e-6, "the eye looks along its own direction: {eye:?}");
            let normal = tilt.tip(DVec3::Z);
            assert!(
                normal.x.abs() < 1e-6 && normal.y < 0.0,
                "what stands on the tile points up: {normal:?}"
            );
            // The map does not mirror.
            assert!(tilt.right.perp_dot(tilt.down) > 0.0);
        }
        // An eye on the side of -v sees v up, and the tile unturned.
        let tilt =
            Tilt::new(&Grid::THESIS, Direction { theta: 1, phi: 5 }, false, pos2(0.0, 0.0), 1.0);
        assert!((tilt.right - DVec2::X).length() < 1e-9 && tilt.down.x.abs() < 1e-9);
    }

    #[test]
    fn every_point_leads_back_to_its_texel() {
        for theta in 0..6 {
            for phi in 0..10 {
                let tilt = Tilt::new(
                    &Grid::THESIS,
                    Direction { theta, phi },
                    false,
                    pos2(31.0, 77.0),
                    3.5,
                );
                for texel in [DVec2::new(0.5, 0.5), DVec2::new(31.0, 2.25), DVec2::new(-40.0, 90.0)]
                {
                    let back = tilt.texel(tilt.screen(texel));
                    assert!(
                        (back - texel).length() < 1e-3,
                        "{theta}.{phi}: {texel} came back as {back}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_tile_can_be_painted_on_at_the_horizon() {
        let tilt =
            Tilt::new(&Grid::THESIS, Direction { theta: 5, phi: 0 }, false, pos2(0.0, 0.0), 10.0);
        assert!(tilt.bounds().height() > 60.0);
        assert!(tilt.copies(Rect::from_center_size(pos2(0.0, 0.0), vec2(700.0, 300.0))).len() > 9);
    }
}
