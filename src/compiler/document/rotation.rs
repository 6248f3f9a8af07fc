//! Rotations as quaternions `[x, y, z, w]`, and their other notations.

use chiaro_locale::tr;

/// Rotation by `angle` around an axis of any length but 0, by the right-hand rule; in radians.
pub(super) fn from_axis_angle(axis: [f64; 3], angle: f64) -> [f64; 4] {
    let length = norm(&axis);
    let (sin, cos) = (angle / 2.0).sin_cos();
    let [x, y, z] = axis.map(|component| component / length * sin);
    [x, y, z, cos]
}

/// Normalized quaternion. A quaternion that is unit within the precision of f64 stays unchanged, so
/// that what was written is read back.
pub(super) fn from_quaternion(quaternion: [f64; 4]) -> Result<[f64; 4], &'static str> {
    let length = norm(&quaternion);
    if length < 1e-9 {
        return Err(tr!("a quaternion of length 0 is no rotation"));
    }
    Ok(if (length - 1.0).abs() < 1e-12 {
        quaternion
    } else {
        quaternion.map(|component| component / length)
    })
}

/// Rotation of a 3x3 matrix, given by rows, that turns column vectors.
pub(super) fn from_matrix(m: [[f64; 3]; 3]) -> Result<[f64; 4], &'static str> {
    const TOLERANCE: f64 = 1e-3;
    for i in 0..3 {
        for j in 0..3 {
            let dot: f64 = (0..3).map(|k| m[i][k] * m[j][k]).sum();
            let expected = if i == j { 1.0 } else { 0.0 };
            // This comparison fails for NaN, too.
            let holds = (dot - expected).abs() <= TOLERANCE;
            if !holds {
                return Err(tr!(
                    "the rows of the matrix are not of length 1 and at right angles, so it is no \
                     rotation"
                ));
            }
        }
    }
    let determinant: f64 = (0..3)
        .map(|i| {
            m[0][i]
                * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
        })
        .sum();
    if determinant < 0.0 {
        return Err(tr!("the matrix mirrors, so it is no rotation"));
    }
    // The largest of the four squared components is at least 1/4, so dividing by it is safe
    // (Shepperd 1978).
    let trace = m[0][0] + m[1][1] + m[2][2];
    let squares = [m[0][0], m[1][1], m[2][2], trace];
    let largest = (0..4).max_by(|&a, &b| squares[a].total_cmp(&squares[b])).unwrap_or(3);
    let quaternion = if largest == 3 {
        [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], 1.0 + trace]
    } else {
        let (i, j, k) = (largest, (largest + 1) % 3, (largest + 2) % 3);
        let mut q = [0.0; 4];
        q[i] = 1.0 + m[i][i] - m[j][j] - m[k][k];
        q[j] = m[j][i] + m[i][j];
        q[k] = m[k][i] + m[i][k];
        q[3] = m[k][j] - m[j][k];
        q
    };
    let length = norm(&quaternion);
    Ok(quaternion.map(|component| component / length))
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Vector turned by a quaternion: `v + 2 w (a x v) + 2 a x (a x v)` for `q = (a, w)`.
    fn turn([x, y, z, w]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let once = cross([x, y, z], v);
        let twice = cross([x, y, z], once);
        [0, 1, 2].map(|i| v[i] + 2.0 * (w * once[i] + twice[i]))
    }

    proptest! {
        #[test]
        fn a_matrix_and_its_quaternion_turn_alike(
            axis in prop::array::uniform3(-1.0..1.0f64).prop_filter("an axis", |a| norm(a) > 0.1),
            angle in -7.0..7.0f64,
        ) {
            let q = from_axis_angle(axis, angle);
            // Columns are what the axes become.
            let columns = [
                turn(q, [1.0, 0.0, 0.0]), turn(q, [0.0, 1.0, 0.0]), turn(q, [0.0, 0.0, 1.0])
            ];
            let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[j][i]));
            let back = from_matrix(rows).unwrap();
            let same: f64 = (0..4).map(|i| q[i] * back[i]).sum();
            prop_assert!((same.abs() - 1.0).abs() < 1e-12, "{q:?} {back:?}");
        }
    }

    #[test]
    fn a_quarter_turn_around_y_takes_z_to_x() {
        let q = from_axis_angle([0.0, 5.0, 0.0], std::f64::consts::FRAC_PI_2);
        let turned = turn(q, [0.0, 0.0, 1.0]);
        assert!((turned[0] - 1.0).abs() < 1e-15 && turned[2].abs() < 1e-15, "{turned:?}");
    }

    #[test]
    fn what_is_no_rotation_is_refused() {
        assert!(
            from_matrix([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]])
                .unwrap_err()
                .contains("mirrors")
        );
        assert!(from_matrix([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
        assert!(from_matrix([[f64::NAN; 3]; 3]).is_err());
        assert!(from_quaternion([0.0; 4]).is_err());
        assert_eq!(from_quaternion([0.0, 0.0, 0.0, 2.0]), Ok([0.0, 0.0, 0.0, 1.0]));
    }
}
