//! Cubics between keys in time.

/// Greatest number of steps toward a place on a cubic.
const STEPS: usize = 64;

/// Cubic Bézier curve between two keys, in one number of their values. Values are a function of
/// time: the inner points lie between the keys, in order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BezierSpan {
    /// Times of the inner points, as shares of the time between the keys: from 0 to 1, in order.
    pub times: [f64; 2],
    /// Values of the four points.
    pub values: [f64; 4],
}

impl BezierSpan {
    /// A cubic between two values over `length` seconds, by their handles: offsets in seconds and
    /// value. Handles that reach over one another are made shorter, both by the same share.
    pub fn new(length: f64, values: [f64; 2], outgoing: [f64; 2], incoming: [f64; 2]) -> Self {
        let out = outgoing[0].max(0.0);
        let back = (-incoming[0]).max(0.0);
        let both = out + back;
        let fit = if both > length { length / both } else { 1.0 };
        let share = |time: f64| {
            let share = time * fit / length;
            if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
        };
        let first = share(out);
        let second = (1.0 - share(back)).max(first);
        let [from, to] = values;
        Self {
            times: [first, second],
            values: [from, from + fit * outgoing[1], to + fit * incoming[1], to],
        }
    }

    /// The value at a share of the time between the keys. Never beyond the four points.
    pub fn at(&self, share: f64) -> f64 {
        let s = parameter(share, self.times);
        let between = |a: f64, b: f64| a + s * (b - a);
        let [a, b, c, d] = self.values;
        let (ab, bc, cd) = (between(a, b), between(b, c), between(c, d));
        let value = between(between(ab, bc), between(bc, cd));
        value.clamp(a.min(b).min(c).min(d), a.max(b).max(c).max(d))
    }

    /// Slopes at the two keys, over shares of the time between them; 0 where the curve stands
    /// upright.
    pub fn slopes(&self) -> [f64; 2] {
        let [a, b, c, d] = self.values;
        let [p, q] = self.times;
        // The first point that lies elsewhere in time tells the way.
        let slope = |candidates: [(f64, f64); 3]| {
            let found = candidates.into_iter().find(|(time, _)| *time > 1e-6);
            found.map_or(0.0, |(time, value)| value / time)
        };
        [
            slope([(p, b - a), (q, c - a), (1.0, d - a)]),
            slope([(1.0 - q, d - c), (1.0 - p, d - b), (1.0, d - a)]),
        ]
    }
}

/// The parameter at which the times of a cubic from 0 to 1, with inner points at these times, are
/// `share`: Newton's steps, within bounds that always close.
fn parameter(share: f64, [first, second]: [f64; 2]) -> f64 {
    if share.is_nan() || share <= 0.0 {
        return 0.0;
    }
    if share >= 1.0 {
        return 1.0;
    }
    let (a, b, c) = (1.0 + 3.0 * (first - second), 3.0 * second - 6.0 * first, 3.0 * first);
    let (mut low, mut high, mut s) = (0.0, 1.0, share);
    for _ in 0..STEPS {
        let off = ((a * s + b) * s + c) * s - share;
        if off == 0.0 {
            return s;
        }
        if off < 0.0 {
            low = s;
        } else {
            high = s;
        }
        let newton = s - off / ((3.0 * a * s + 2.0 * b) * s + c);
        // A step that is no number fails this comparison, too.
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - s).abs() <= 1e-16 {
            return next;
        }
        s = next;
    }
    s
}

/// Slope of an automatic handle between the slopes to the neighbors, each over its time: flat at a
/// turning point, else so that the curve stays between its keys (Fritsch and Butland 1984).
pub(super) fn automatic_slope([before, after]: [f64; 2], [since, until]: [f64; 2]) -> f64 {
    let turns = !(before > 0.0 && after > 0.0 || before < 0.0 && after < 0.0);
    if turns {
        return 0.0;
    }
    let (w, v) = (2.0 * until + since, until + 2.0 * since);
    let slope = (w + v) / (w / before + v / after);
    if slope.is_finite() { slope } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn handles_of_a_third_are_a_straight_line() {
        let span = BezierSpan::new(3.0, [10.0, 16.0], [1.0, 2.0], [-1.0, -2.0]);
        for i in 0..=64 {
            let share = f64::from(i) / 64.0;
            assert!((span.at(share) - (10.0 + 6.0 * share)).abs() < 1e-14, "{share}");
        }
        assert_eq!(span.at(0.0), 10.0);
        assert!(span.slopes().iter().all(|slope| (slope - 6.0).abs() < 1e-14), "{span:?}");
    }

    #[test]
    fn values_are_those_of_known_cubics() {
        // Thirds in time, flat in value: the cubic that eases, 3 t^2 - 2 t^3.
        let eased = BezierSpan::new(1.0, [0.0, 1.0], [1.0 / 3.0, 0.0], [-1.0 / 3.0, 0.0]);
        for t in [0.1, 0.25, 0.5, 0.9] {
            assert!((eased.at(t) - t * t * (3.0 - 2.0 * t)).abs() < 1e-15, "{t}");
        }
        // At the parameter s = 1/4 times are 3 p s r^2 + 3 q s^2 r + s^3.
        let (p, q, s, r) = (0.6, 0.9, 0.25, 0.75);
        let cubic = |b: f64, c: f64| 3.0 * b * s * r * r + 3.0 * c * s * s * r + s * s * s;
        let span = BezierSpan { times: [p, q], values: [0.0, 2.0, -1.0, 1.0] };
        assert!((span.at(cubic(p, q)) - cubic(2.0, -1.0)).abs() < 1e-14);
        // Upright at both ends: x = s^2 (3 - 2 s), half way at once.
        let upright = BezierSpan::new(2.0, [0.0, 1.0], [0.0, 1.0], [0.0, -1.0]);
        assert_eq!((upright.times, upright.slopes()), ([0.0, 1.0], [0.0, 0.0]));
        assert!((upright.at(0.5) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn handles_that_reach_over_one_another_are_made_shorter() {
        let span = BezierSpan::new(1.0, [0.0, 1.0], [3.0, 3.0], [-1.0, 0.0]);
        assert_eq!((span.times, span.values), ([0.75, 0.75], [0.0, 0.75, 1.0, 1.0]));
        // Handles that lead backwards stand upright.
        assert_eq!(BezierSpan::new(1.0, [0.0, 1.0], [-2.0, 1.0], [2.0, 1.0]).times, [0.0, 1.0]);
    }

    proptest! {
        #[test]
        fn every_span_is_a_function_of_time(
            handles in prop::array::uniform4(prop_oneof![-4.0..4.0f64, Just(0.0), -1e38..1e38f64]),
            length in prop_oneof![1e-9..1e6f64, Just(5e-324)],
            values in prop::array::uniform2(-1e38..1e38f64),
        ) {
            let [a, b, c, d] = handles;
            let span = BezierSpan::new(length, values, [a, b], [c, d]);
            let [p, q] = span.times;
            prop_assert!(0.0 <= p && p <= q && q <= 1.0);
            let mut last = 0.0;
            for i in 0..=40 {
                let share = f64::from(i) / 40.0;
                let s = parameter(share, span.times);
                prop_assert!(s >= last - 1e-9 && s <= 1.0, "{s} after {last}");
                last = s;
                let r = 1.0 - s;
                let time = 3.0 * p * s * r * r + 3.0 * q * s * s * r + s * s * s;
                prop_assert!((time - share).abs() < 1e-14, "{time} for {share}");
                prop_assert!(span.at(share).is_finite());
            }
            prop_assert_eq!(span.at(0.0), values[0]);
        }

        #[test]
        fn automatic_handles_stay_between_keys(
            slopes in prop::array::uniform2(-1e9..1e9f64),
            spans in prop::array::uniform2(1e-6..1e3f64),
        ) {
            let slope = automatic_slope(slopes, spans);
            let least = slopes[0].abs().min(slopes[1].abs());
            prop_assert!(slope.abs() <= 3.0 * least * (1.0 + 1e-12));
            prop_assert!(slope * slopes[0] >= 0.0 && slope * slopes[1] >= 0.0);
        }
    }
}
