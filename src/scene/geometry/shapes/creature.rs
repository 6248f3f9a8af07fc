//! A creature: a seated cub with bat's ears, horns, a smile and a curled tail, looking along +z,
//! about 2.4 units high.
//!
//! The creature is made to judge a shading look on, so it has what shading must cope with: convex
//! masses (skull, belly, thighs), tight ridges (brows, lids, lips, horns), real hollows (ears, eye
//! sockets, nostrils, mouth), and folds in rows (belly, fingers, toes).

use glam::{DQuat, DVec3};

use super::nets::Cells;
use super::sculpture::{Sculpture, Solid, ball, ellipsoid, stroke};

/// Sizes of the grid's cells, smaller in the face.
pub(super) const CELLS: Cells =
    Cells { edge: 0.032, detail: [[-0.48, 0.48], [0.10, 0.92], [0.34, 0.72]], fine: 0.5 };

/// The whole creature.
pub(super) fn sculpture() -> Sculpture {
    let mut clay = Sculpture::default();
    body(&mut clay);
    tail(&mut clay);
    for side in [-1.0, 1.0] {
        leg(&mut clay, Side(side));
    }
    head(&mut clay);
    for side in [-1.0, 1.0] {
        ear(&mut clay, Side(side));
        horn(&mut clay, Side(side));
        eye(&mut clay, Side(side));
    }
    mouth(&mut clay);
    for side in [-1.0, 1.0] {
        arm(&mut clay, Side(side));
    }
    clay
}

/// The left (-1) or right (1) side of parts that come in pairs; solids are given for the right
/// side.
#[derive(Clone, Copy)]
struct Side(f64);

impl Side {
    fn ball(self, [x, y, z]: [f64; 3], radius: f64) -> Solid {
        ball([self.0 * x, y, z], radius)
    }

    /// An ellipsoid turned by `angle` about `axis`, in radians; on the left side mirrored with its
    /// axis.
    fn ellipsoid(self, [x, y, z]: [f64; 3], radii: [f64; 3], axis: [f64; 3], angle: f64) -> Solid {
        // A mirrored turn goes the other way about the mirrored axis.
        let axis = DVec3::new(self.0 * axis[0], axis[1], axis[2]).normalize();
        ellipsoid([self.0 * x, y, z], radii, DQuat::from_axis_angle(axis, self.0 * angle))
    }

    fn stroke<const N: usize>(self, points: [[f64; 4]; N]) -> Solid {
        stroke(&points.map(|[x, y, z, r]| [self.0 * x, y, z, r]))
    }
}

fn body(clay: &mut Sculpture) {
    clay.add(0.1, ellipsoid([0.0, -0.52, -0.04], [0.50, 0.56, 0.45], DQuat::IDENTITY));
    clay.add(0.25, ellipsoid([0.0, -0.10, -0.04], [0.36, 0.30, 0.30], DQuat::IDENTITY));
    clay.add(0.16, ellipsoid([0.0, -0.56, 0.22], [0.36, 0.42, 0.27], DQuat::IDENTITY));
    // Folds across the belly, laid onto the belly's surface; their ends come out of the skin.
    for (y, half) in [(-0.26, 0.20), (-0.41, 0.27), (-0.57, 0.29), (-0.73, 0.25)] {
        let groove = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|t: f64| {
            let (x, y) = (t * half, y + 0.06 * t * t);
            let skin = clay.front(x, y, 1.0).unwrap_or(0.4);
            [x, y, skin + 0.005 + 0.045 * t.powi(4), 0.027]
        });
        clay.cut(0.06, stroke(&groove));
    }
    // A crest of spines down the back.
    for i in 0..5 {
        let t = f64::from(i) / 4.0;
        let (y, z) = (0.06 - 0.72 * t, -0.36 - 0.13 * (t * 3.1).sin());
        let size = 0.085 + 0.03 * (t * 3.1).sin();
        clay.add(0.07, ellipsoid([0.0, y, z], [0.045, size, 0.12], DQuat::from_rotation_x(-0.5)));
    }
}

fn tail(clay: &mut Sculpture) {
    clay.add(
        0.2,
        stroke(&[
            [0.0, -0.86, -0.30, 0.20],
            [0.22, -0.97, -0.66, 0.15],
            [0.66, -1.00, -0.62, 0.115],
            [0.92, -1.00, -0.22, 0.09],
            [0.92, -0.98, 0.14, 0.07],
            [0.80, -0.84, 0.34, 0.05],
        ]),
    );
    // A leaf at the tail's end.
    let turn = DQuat::from_rotation_z(0.5) * DQuat::from_rotation_x(-0.35);
    clay.add(0.06, ellipsoid([0.755, -0.70, 0.40], [0.115, 0.175, 0.045], turn));
    clay.cut(0.04, ellipsoid([0.745, -0.70, 0.465], [0.05, 0.12, 0.04], turn));
}

fn leg(clay: &mut Sculpture, side: Side) {
    clay.add(
        0.14,
        side.ellipsoid([0.42, -0.80, 0.10], [0.235, 0.285, 0.345], [0.0, 1.0, 0.0], 0.35),
    );
    clay.add(0.09, side.ellipsoid([0.47, -1.00, 0.46], [0.155, 0.105, 0.25], [0.0, 1.0, 0.0], 0.3));
    for (x, z, r) in [(0.40, 0.68, 0.085), (0.535, 0.70, 0.09), (0.655, 0.625, 0.08)] {
        clay.add(0.03, side.ball([x, -1.015, z], r));
        clay.add(
            0.02,
            side.stroke([
                [x + 0.005, -1.02, z + 0.06, 0.035],
                [x + 0.015, -1.055, z + 0.125, 0.008],
            ]),
        );
    }
}

fn arm(clay: &mut Sculpture, side: Side) {
    clay.add(
        0.10,
        side.stroke([
            [0.30, -0.17, 0.02, 0.15],
            [0.50, -0.36, 0.10, 0.125],
            [0.54, -0.54, 0.28, 0.105],
            [0.42, -0.58, 0.46, 0.095],
        ]),
    );
    clay.add(0.06, side.ellipsoid([0.36, -0.585, 0.50], [0.12, 0.095, 0.07], [0.0, 1.0, 0.0], 0.5));
    for (y, x, z) in [(-0.535, 0.185, 0.555), (-0.60, 0.165, 0.56), (-0.66, 0.19, 0.545)] {
        let knuckle = [0.29, y + 0.005, 0.585, 0.042];
        clay.add(0.018, side.stroke([[0.36, y, 0.54, 0.045], knuckle, [x, y - 0.02, z, 0.036]]));
    }
    clay.add(
        0.025,
        side.stroke([
            [0.37, -0.52, 0.52, 0.045],
            [0.31, -0.455, 0.56, 0.042],
            [0.26, -0.44, 0.555, 0.036],
        ]),
    );
}

fn head(clay: &mut Sculpture) {
    clay.add(0.16, ellipsoid([0.0, 0.52, 0.0], [0.60, 0.50, 0.52], DQuat::IDENTITY));
    for side in [-1.0, 1.0] {
        clay.add(0.16, Side(side).ball([0.34, 0.33, 0.22], 0.24));
    }
    // The muzzle, and the bridge of the nose.
    clay.add(0.16, ellipsoid([0.0, 0.30, 0.42], [0.30, 0.19, 0.24], DQuat::IDENTITY));
    clay.add(
        0.10,
        stroke(&[[0.0, 0.62, 0.46, 0.06], [0.0, 0.48, 0.58, 0.075], [0.0, 0.42, 0.64, 0.085]]),
    );
    for side in [-1.0, 1.0].map(Side) {
        clay.add(0.06, side.ball([0.085, 0.40, 0.66], 0.060));
        clay.cut(
            0.04,
            side.ellipsoid([0.090, 0.392, 0.718], [0.030, 0.040, 0.06], [0.0, 0.0, 1.0], 0.5),
        );
    }
    // A tuft between the horns.
    for (x, y, lean) in [(-0.07, 1.10, -0.06), (0.0, 1.15, 0.0), (0.07, 1.10, 0.06)] {
        clay.add(
            0.04,
            stroke(&[
                [x, 0.98, 0.10, 0.06],
                [x + lean, y, 0.16, 0.03],
                [x + 1.6 * lean, y + 0.03, 0.21, 0.012],
            ]),
        );
    }
}

fn ear(clay: &mut Sculpture, side: Side) {
    let (axis, lean) = ([0.0, 0.25, 1.0], -0.85);
    clay.add(0.10, side.ellipsoid([0.76, 0.76, -0.10], [0.235, 0.44, 0.12], axis, lean));
    clay.add(0.16, side.ellipsoid([1.03, 0.99, -0.11], [0.07, 0.20, 0.05], axis, lean));
    // The hollow of the ear, and a fold in it.
    clay.cut(0.07, side.ellipsoid([0.775, 0.775, 0.035], [0.16, 0.345, 0.125], axis, lean));
    clay.add(
        0.10,
        side.stroke([
            [0.56, 0.57, 0.03, 0.06],
            [0.67, 0.70, -0.062, 0.05],
            [0.82, 0.82, -0.115, 0.03],
        ]),
    );
}

fn horn(clay: &mut Sculpture, side: Side) {
    // Radii alternate between wider and narrower: the horn's rings.
    clay.add(
        0.05,
        side.stroke([
            [0.250, 0.90, 0.080, 0.100],
            [0.280, 0.97, 0.078, 0.102],
            [0.302, 1.02, 0.070, 0.076],
            [0.319, 1.07, 0.056, 0.086],
            [0.331, 1.12, 0.036, 0.060],
            [0.337, 1.17, 0.012, 0.068],
            [0.336, 1.22, -0.016, 0.043],
            [0.328, 1.27, -0.050, 0.044],
            [0.312, 1.33, -0.090, 0.018],
        ]),
    );
}

fn eye(clay: &mut Sculpture, side: Side) {
    // The eye's socket, and the lids that line it.
    clay.cut(
        0.06,
        side.ellipsoid([0.245, 0.575, 0.49], [0.145, 0.150, 0.16], [0.0, 1.0, 0.0], 0.3),
    );
    clay.add(
        0.055,
        side.stroke([
            [0.105, 0.555, 0.475, 0.026],
            [0.145, 0.655, 0.49, 0.036],
            [0.245, 0.71, 0.475, 0.044],
            [0.345, 0.66, 0.405, 0.038],
            [0.395, 0.555, 0.34, 0.026],
        ]),
    );
    clay.add(
        0.055,
        side.stroke([
            [0.105, 0.555, 0.475, 0.026],
            [0.155, 0.47, 0.475, 0.026],
            [0.245, 0.435, 0.45, 0.027],
            [0.345, 0.475, 0.385, 0.026],
            [0.395, 0.555, 0.34, 0.026],
        ]),
    );
    // The eyeball, and the pupil drilled as sculptors do.
    clay.add(0.03, side.ball([0.24, 0.575, 0.375], 0.155));
    clay.cut(0.035, side.ball([0.222, 0.58, 0.555], 0.070));
    // The brow, higher inside: a friendly, somewhat worried face.
    clay.add(
        0.09,
        side.stroke([
            [0.12, 0.83, 0.43, 0.042],
            [0.22, 0.868, 0.42, 0.058],
            [0.36, 0.825, 0.34, 0.050],
            [0.47, 0.69, 0.225, 0.026],
        ]),
    );
}

fn mouth(clay: &mut Sculpture) {
    // The chin, then the smile, deepest in the middle.
    clay.add(0.14, ellipsoid([0.0, 0.13, 0.36], [0.24, 0.12, 0.20], DQuat::IDENTITY));
    let smile = [-1.0, -0.7, -0.35, 0.0, 0.35, 0.7, 1.0].map(|t: f64| {
        let (x, y) = (0.40 * t, 0.19 + 0.165 * t * t);
        let skin = clay.front(x, y, 1.0).unwrap_or(0.5);
        [x, y, skin - 0.012 + 0.042 * t.powi(6), 0.034]
    });
    clay.cut(0.045, stroke(&smile));
    clay.cut(
        0.05,
        ellipsoid([0.0, 0.185, 0.56], [0.18, 0.055, 0.18], DQuat::from_rotation_x(0.15)),
    );
    // The tongue.
    clay.add(0.03, ellipsoid([0.0, 0.145, 0.47], [0.10, 0.035, 0.12], DQuat::from_rotation_x(0.1)));
    for side in [-1.0, 1.0].map(Side) {
        // A fang, and the dimple where the smile ends.
        clay.add(0.02, side.stroke([[0.125, 0.255, 0.585, 0.036], [0.128, 0.17, 0.60, 0.013]]));
        clay.add(0.05, side.ball([0.435, 0.375, 0.34], 0.05));
    }
}
