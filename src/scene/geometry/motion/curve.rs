//! Curves of animations: a value of several numbers at each of some times.

use chiaro_locale::tr;
use glam::DQuat;

/// Way from one key of a curve to the next, as glTF names it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::geometry) enum KeyInterpolation {
    /// The value goes straight; a rotation along the shortest arc, at one speed.
    #[default]
    Linear,
    /// The value of the key before holds.
    Step,
    /// The value follows Hermite's cubic with the keys' own tangents.
    CubicSpline,
}

/// Keys of a curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::geometry) struct Curve {
    interpolation: KeyInterpolation,
    /// Times of the keys, in seconds, each after the one before.
    times: Vec<f32>,
    /// Values of the keys, `width` numbers each; for cubic splines the tangent toward the key, the
    /// value, and the tangent from it, each of as many numbers.
    values: Vec<f32>,
    width: usize,
}

impl Curve {
    /// The curve of these keys.
    ///
    /// # Errors
    /// The reason why these are no curve, as a part of a sentence.
    pub(in crate::geometry) fn new(
        interpolation: KeyInterpolation,
        times: Vec<f32>,
        values: Vec<f32>,
        width: usize,
    ) -> Result<Self, &'static str> {
        let of_key = if interpolation == KeyInterpolation::CubicSpline { 3 } else { 1 };
        if times.is_empty() || width == 0 {
            return Err(tr!("it has no keys"));
        }
        if !times.iter().all(|time| time.is_finite()) {
            return Err(tr!("a time of it is not finite"));
        }
        if !times.is_sorted_by(|before, after| before < after) {
            return Err(tr!("its times do not grow"));
        }
        if times.len().checked_mul(of_key * width) != Some(values.len()) {
            return Err(tr!("it has not one value for each time"));
        }
        if !values.iter().all(|value| value.is_finite()) {
            return Err(tr!("a value of it is not finite"));
        }
        Ok(Self { interpolation, times, values, width })
    }

    /// The time of the last key, in seconds.
    pub(in crate::geometry) fn end(&self) -> f64 {
        self.times.last().copied().map_or(0.0, f64::from)
    }

    /// Times of the keys, in seconds, each after the one before.
    pub(in crate::geometry) fn times(&self) -> impl Iterator<Item = f64> + '_ {
        self.times.iter().map(|time| f64::from(*time))
    }

    /// The value at a time in seconds, into `value`. Before the first key and after the last, that
    /// key's value holds.
    pub(in crate::geometry) fn value(&self, time: f64, value: &mut Vec<f64>) {
        value.clear();
        let (before, after, share) = self.around(time);
        match self.interpolation {
            _ if share == 0.0 => value.extend(self.key(before)),
            KeyInterpolation::Step => value.extend(self.key(before)),
            KeyInterpolation::Linear => value.extend(
                self.key(before).zip(self.key(after)).map(|(a, b)| a * (1.0 - share) + b * share),
            ),
            KeyInterpolation::CubicSpline => {
                let span = f64::from(self.times[after]) - f64::from(self.times[before]);
                let (t, t2, t3) = (share, share * share, share * share * share);
                let from = self.part(before, 2).zip(self.part(after, 0));
                let keys = self.key(before).zip(self.key(after)).zip(from);
                value.extend(keys.map(|((a, b), (leaving, arriving))| {
                    (2.0 * t3 - 3.0 * t2 + 1.0) * a
                        + span * (t3 - 2.0 * t2 + t) * leaving
                        + (3.0 * t2 - 2.0 * t3) * b
                        + span * (t3 - t2) * arriving
                }));
            }
        }
    }

    /// The rotation at a time in seconds, of length 1; `None` where the curve leaves no direction,
    /// or is not of four numbers.
    pub(in crate::geometry) fn rotation(&self, time: f64) -> Option<DQuat> {
        let read = |numbers: &[f64]| -> Option<DQuat> {
            let [x, y, z, w] = <[f64; 4]>::try_from(numbers).ok()?;
            let length = DQuat::from_xyzw(x, y, z, w).length();
            (length > 1e-12).then(|| DQuat::from_xyzw(x, y, z, w) / length)
        };
        let (before, after, share) = self.around(time);
        if self.interpolation == KeyInterpolation::Linear && share > 0.0 {
            let [a, b] = [before, after].map(|key| read(&self.key(key).collect::<Vec<_>>()));
            return Some(a?.slerp(b?, share));
        }
        let mut value = Vec::with_capacity(4);
        self.value(time, &mut value);
        read(&value)
    }

    /// The keys around a time, and the share of the way from the first to the second.
    fn around(&self, time: f64) -> (usize, usize, f64) {
        let next = self.times.partition_point(|key| f64::from(*key) <= time);
        let Some(before) = next.checked_sub(1) else { return (0, 0, 0.0) };
        let Some(after) = self.times.get(next) else { return (before, before, 0.0) };
        let start = f64::from(self.times[before]);
        (before, next, (time - start) / (f64::from(*after) - start))
    }

    /// The value of a key.
    fn key(&self, key: usize) -> impl Iterator<Item = f64> + '_ {
        self.part(key, usize::from(self.interpolation == KeyInterpolation::CubicSpline))
    }

    /// The numbers of a key from `part` values on.
    fn part(&self, key: usize, part: usize) -> impl Iterator<Item = f64> + '_ {
        let of_key = self.values.len() / self.times.len();
        let start = key * of_key + part * self.width;
        self.values[start..start + self.width].iter().map(|number| f64::from(*number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(curve: &Curve, time: f64) -> Vec<f64> {
        let mut value = vec![9.0];
        curve.value(time, &mut value);
        value
    }

    #[test]
    fn curves_go_as_gltf_says() {
        let curve = |interpolation, values: &[f32], width| {
            Curve::new(interpolation, vec![1.0, 3.0], values.to_vec(), width).unwrap()
        };
        let linear = curve(KeyInterpolation::Linear, &[0.0, 10.0, 4.0, 30.0], 2);
        assert_eq!(at(&linear, 0.0), [0.0, 10.0]);
        assert_eq!(at(&linear, 1.5), [1.0, 15.0]);
        assert_eq!(at(&linear, 3.0), [4.0, 30.0]);
        assert_eq!(at(&linear, 99.0), [4.0, 30.0]);
        let step = curve(KeyInterpolation::Step, &[0.0, 4.0], 1);
        assert_eq!([1.0, 2.999, 3.0].map(|time| at(&step, time)[0]), [0.0, 0.0, 4.0]);
        // By hand, halfway over 2 seconds: a/2 + b/2 + 2 (m0 - m1) / 8.
        let cubic = curve(KeyInterpolation::CubicSpline, &[7.0, 1.0, 3.0, -1.0, 5.0, 8.0], 1);
        assert_eq!(at(&cubic, 2.0), [0.5 + 2.5 + 0.25 * (3.0 + 1.0)]);
        assert_eq!((at(&cubic, 1.0), at(&cubic, 3.0)), (vec![1.0], vec![5.0]));
    }

    #[test]
    fn rotations_take_the_shortest_arc_at_one_speed() {
        let half = std::f32::consts::FRAC_1_SQRT_2;
        // From none to a quarter turn about z, written with the other sign and twice as long.
        let values = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -2.0 * half, -2.0 * half];
        let curve = Curve::new(KeyInterpolation::Linear, vec![0.0, 1.0], values, 4).unwrap();
        for share in [0.0, 0.25, 0.5, 1.0] {
            let expected = DQuat::from_rotation_z(share * std::f64::consts::FRAC_PI_2);
            let off = curve.rotation(share).unwrap().dot(expected).abs();
            assert!((off - 1.0).abs() < 1e-9, "{share}: {off}");
        }
        let none = Curve::new(KeyInterpolation::Step, vec![0.0], vec![0.0; 4], 4).unwrap();
        assert_eq!(none.rotation(0.0), None);
    }

    #[test]
    fn what_is_no_curve_is_told() {
        let new = |times: &[f32], values: &[f32]| {
            Curve::new(KeyInterpolation::Linear, times.to_vec(), values.to_vec(), 1).err()
        };
        assert_eq!(new(&[0.0, 1.0], &[0.0, 1.0]), None);
        assert_eq!(new(&[], &[]), Some("it has no keys"));
        assert_eq!(new(&[f32::NAN], &[0.0]), Some("a time of it is not finite"));
        assert_eq!(new(&[1.0, 1.0], &[0.0, 1.0]), Some("its times do not grow"));
        assert_eq!(new(&[1.0, 0.5], &[0.0, 1.0]), Some("its times do not grow"));
        assert_eq!(new(&[0.0, 1.0], &[0.0]), Some("it has not one value for each time"));
        assert_eq!(new(&[0.0], &[f32::INFINITY]), Some("a value of it is not finite"));
    }
}
