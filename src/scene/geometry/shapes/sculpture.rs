//! Soft modeling clay: a signed distance field made of rounded pieces, each added to or cut from
//! what came before with a smooth seam.
//!
//! The seam is the cubic smooth minimum, whose second derivatives are continuous, so that curvature
//! shows no line along it. It reaches exactly as far as its width `k`: a piece farther away than
//! that changes nothing, and is not evaluated. [`Sculpture::near`] finds the few pieces that matter
//! in a small ball.

use glam::{DMat3, DQuat, DVec3};

use super::curve::Tube;

/// A sculpture: its pieces, in the order in which they are applied.
#[derive(Clone, Debug, Default)]
pub(super) struct Sculpture {
    pieces: Vec<SolidPiece>,
}

#[derive(Clone, Debug)]
struct SolidPiece {
    solid: Solid,
    cut: bool,
    /// Width of the seam.
    k: f64,
    /// Center of a ball that holds the piece, whose radius is `reach`.
    center: DVec3,
    reach: f64,
}

/// A rounded body.
#[derive(Clone, Debug)]
pub(super) enum Solid {
    /// An ellipsoid; `local` turns space to its axes.
    Ellipsoid { center: DVec3, radii: DVec3, local: DMat3 },
    /// A tube.
    Stroke(Tube),
}

/// A solid ball.
pub(super) fn ball(center: [f64; 3], radius: f64) -> Solid {
    ellipsoid(center, [radius; 3], DQuat::IDENTITY)
}

/// An ellipsoid whose axes are turned by `turn`.
pub(super) fn ellipsoid(center: [f64; 3], radii: [f64; 3], turn: DQuat) -> Solid {
    Solid::Ellipsoid {
        center: center.into(),
        radii: radii.into(),
        local: DMat3::from_quat(turn.inverse()),
    }
}

/// A round tube through points `[x, y, z, radius]`, bent smoothly.
pub(super) fn stroke(points: &[[f64; 4]]) -> Solid {
    Solid::Stroke(Tube::through(points))
}

impl Solid {
    /// The signed distance from the solid, negative inside; exact near the surface, elsewhere a
    /// bound.
    fn distance(&self, p: DVec3) -> f64 {
        match self {
            Self::Ellipsoid { center, radii, local } => {
                let q = *local * (p - *center);
                let (scaled, twice) = ((q / *radii).length(), (q / (*radii * *radii)).length());
                // At the very center both are 0.
                if twice < 1e-9 { -radii.min_element() } else { scaled * (scaled - 1.0) / twice }
            }
            Self::Stroke(curve) => curve.distance(p),
        }
    }

    /// A ball that holds the solid (center and radius), with room for the ellipsoid's distance
    /// being a bound only.
    fn hull(&self) -> (DVec3, f64) {
        match self {
            Self::Ellipsoid { center, radii, .. } => (*center, 1.15 * radii.max_element()),
            Self::Stroke(curve) => curve.hull(),
        }
    }
}

/// The lesser of two distances, with a seam of width `k`: exactly the lesser where they differ by
/// `k` or more.
fn smooth_min(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0) / k;
    a.min(b) - h * h * h * k / 6.0
}

/// Greatest rate at which the field may change, relative to a true distance; see
/// [`Solid::distance`].
const SLACK: f64 = 1.4;

impl Sculpture {
    /// Adds a solid with a seam of width `k`.
    pub(super) fn add(&mut self, k: f64, solid: Solid) {
        self.piece(k, solid, false);
    }

    /// Cuts a solid out with a seam of width `k`.
    pub(super) fn cut(&mut self, k: f64, solid: Solid) {
        self.piece(k, solid, true);
    }

    fn piece(&mut self, k: f64, solid: Solid, cut: bool) {
        let (center, reach) = solid.hull();
        self.pieces.push(SolidPiece { solid, cut, k, center, reach });
    }

    /// The least and greatest coordinates of anything added.
    pub(super) fn bounds(&self) -> (DVec3, DVec3) {
        let added = self.pieces.iter().filter(|piece| !piece.cut);
        added.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), piece| {
            (min.min(piece.center - piece.reach), max.max(piece.center + piece.reach))
        })
    }

    /// The z at which a ray from `z` along -z at `x` and `y` meets the surface; `None` if it
    /// misses.
    pub(super) fn front(&self, x: f64, y: f64, z: f64) -> Option<f64> {
        let (all, mut at) = (self.all(), DVec3::new(x, y, z));
        for _ in 0..256 {
            let d = self.distance(at, &all);
            if d.abs() < 1e-6 {
                return Some(at.z);
            }
            at.z -= d / SLACK;
        }
        None
    }

    /// The indices of all pieces.
    pub(super) fn all(&self) -> Vec<u16> {
        (0..self.pieces.len() as u16).collect()
    }

    /// The indices of those pieces of `among` that matter within `radius` of `center`, in order,
    /// and the field at `center`.
    pub(super) fn near(&self, center: DVec3, radius: f64, among: &[u16]) -> (Vec<u16>, f64) {
        let mut found = Vec::new();
        let mut d = f64::INFINITY;
        for &i in among {
            let piece = &self.pieces[i as usize];
            if d == f64::INFINITY || piece.gap(d, center) < piece.k + (1.0 + SLACK) * radius {
                found.push(i);
                d = piece.apply(d, center);
            }
        }
        (found, d)
    }

    /// The field at `p`, from pieces that [`Sculpture::near`] found: negative inside.
    pub(super) fn distance(&self, p: DVec3, pieces: &[u16]) -> f64 {
        pieces.iter().fold(f64::INFINITY, |d, &i| self.pieces[i as usize].apply(d, p))
    }

    /// The field and its gradient at `p`, from the four corners of a tetrahedron.
    pub(super) fn gradient(&self, p: DVec3, pieces: &[u16]) -> (f64, DVec3) {
        const STEP: f64 = 1e-4;
        let corners = [
            DVec3::ONE,
            DVec3::new(1., -1., -1.),
            DVec3::new(-1., 1., -1.),
            DVec3::new(-1., -1., 1.),
        ];
        let (sum, gradient) =
            corners.into_iter().fold((0.0, DVec3::ZERO), |(sum, gradient), corner| {
                let d = self.distance(p + corner * STEP, pieces);
                (sum + d, gradient + corner * d)
            });
        (sum / 4.0, gradient / (4.0 * STEP))
    }

    /// Greatest rate at which the field may change, relative to a true distance: see [`SLACK`].
    pub(super) const fn slack() -> f64 {
        SLACK
    }
}

impl SolidPiece {
    /// The least margin by which the field `d` outweighs the piece at `p`; with a margin of `k` or
    /// more the piece changes nothing.
    fn gap(&self, d: f64, p: DVec3) -> f64 {
        let apart = p.distance(self.center) - self.reach;
        if self.cut { apart + d } else { apart - d }
    }

    fn apply(&self, d: f64, p: DVec3) -> f64 {
        if d == f64::INFINITY {
            return if self.cut { d } else { self.solid.distance(p) };
        }
        if self.gap(d, p) >= self.k {
            return d;
        }
        let own = self.solid.distance(p);
        if self.cut { -smooth_min(-d, own, self.k) } else { smooth_min(d, own, self.k) }
    }
}
