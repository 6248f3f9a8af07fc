//! Interpolation of values with weights (BADF eq. 9).

use glam::DVec3;

use super::keys::unit;

/// Length below which a weighted sum of unit directions is taken for 0: the rest is rounding.
const NO_DIRECTION: f64 = 1e-9;

/// The weighted sum of one finite number per key; 0 without keys.
///
/// The sum never leaves the range of the values that have weight, not even by rounding, and the sum
/// keeps order: where every `a[k] <= b[k]`, so are the results. Hence a fall-off stays between its
/// offset and cut-off. Values of weight 0 are not read.
pub fn blend_number(weights: &[f64], values: &[f64]) -> f64 {
    blend(weights, values.iter().copied())
}

/// The weighted sum of one vector or straight color per key, component by component as
/// [`blend_number`] does.
pub fn blend_vector<const N: usize>(weights: &[f64], values: &[[f64; N]]) -> [f64; N] {
    std::array::from_fn(|component| blend(weights, values.iter().map(|value| value[component])))
}

fn blend(weights: &[f64], values: impl Iterator<Item = f64>) -> f64 {
    let (mut low, mut high, mut sum) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
    for (&weight, value) in weights.iter().zip(values).filter(|(weight, _)| **weight != 0.0) {
        sum += weight * value;
        low = low.min(value);
        high = high.max(value);
    }
    if low <= high { sum.clamp(low, high) } else { 0.0 }
}

/// The unit direction between one direction per key: the weighted sum of their unit vectors,
/// normalized.
///
/// Where the sum vanishes (half way between opposite directions) the result is the direction of the
/// highest weight, the first of equals. Directions that are zero or not finite are left out; `None`
/// if no key of positive weight has a direction.
pub fn blend_direction(weights: &[f64], directions: &[DVec3]) -> Option<DVec3> {
    let mut sum = DVec3::ZERO;
    let mut heaviest: Option<(f64, DVec3)> = None;
    for (&weight, &direction) in weights.iter().zip(directions) {
        let Some(direction) = unit(direction).filter(|_| weight > 0.0) else { continue };
        sum += weight * direction;
        if heaviest.is_none_or(|(most, _)| weight > most) {
            heaviest = Some((weight, direction));
        }
    }
    let (most, direction) = heaviest?;
    if sum.length() > NO_DIRECTION * most { unit(sum) } else { Some(direction) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stay_in_range_and_in_order() {
        let weights = [0.1, 0.2, 0.3, 0.4];
        assert_eq!(blend_number(&weights, &[0.7; 4]), 0.7);
        assert_eq!(blend_number(&[0.0, 1.0], &[f64::INFINITY, 2.0]), 2.0);
        assert_eq!(blend_number(&[], &[]), 0.0);
        let offset = blend_number(&weights, &[0.1, 0.3, 0.2, 0.9]);
        let falloff = blend_number(&weights, &[0.1, 0.4, 0.2, 0.9]);
        assert!((offset - 0.49).abs() < 1e-15 && offset <= falloff);
        assert_eq!(blend_vector(&[0.25, 0.75], &[[0.0, 1.0], [1.0, 1.0]]), [0.75, 1.0]);
    }

    #[test]
    fn directions_never_average_to_zero() {
        let keys = [DVec3::X * 3.0, DVec3::NEG_X];
        assert_eq!(blend_direction(&[0.5, 0.5], &keys), Some(DVec3::X));
        assert_eq!(blend_direction(&[0.4, 0.6], &keys), Some(DVec3::NEG_X));
        let barely = 0.5 + 1e-15;
        assert_eq!(blend_direction(&[1.0 - barely, barely], &keys), Some(DVec3::NEG_X));
        let middle = blend_direction(&[0.5, 0.5], &[DVec3::X, DVec3::Y * 1e300]).unwrap();
        assert!((middle - DVec3::new(1.0, 1.0, 0.0).normalize()).length() < 1e-15);
        assert_eq!(blend_direction(&[0.9, 0.1], &[DVec3::ZERO, DVec3::Z]), Some(DVec3::Z));
        assert_eq!(blend_direction(&[1.0], &[DVec3::NAN]), None);
        assert_eq!(blend_direction(&[], &[]), None);
    }
}
