//! Weights of direction keys: partition of unity, interpolation, invariances, smoothness, and odd
//! sets of keys (hard cases 22 and 23).

use chiaro::diag::has_errors;
use chiaro::directions::{KeyWeights, MAX_KEYS, Tessellation, blend_direction};
use chiaro::document::KeyScheme::{self, AppendixB, Biharmonic, Tessellated};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

const CLOSED: [KeyScheme; 2] = [Biharmonic, AppendixB];
const ALL: [KeyScheme; 3] = [Biharmonic, AppendixB, Tessellated];

/// Weights of keys without errors; warnings are allowed.
fn keys(directions: &[DVec3], scheme: KeyScheme) -> KeyWeights {
    let (keys, problems) = KeyWeights::new(directions, scheme).into_parts();
    assert!(!has_errors(&problems), "{problems:?}");
    keys
}

/// `count` directions spread evenly over the sphere (a Fibonacci spiral).
fn spread(count: usize) -> impl Iterator<Item = DVec3> + Clone {
    let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (golden * i as f64).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        DVec3::new(radius * cos, radius * sin, z)
    })
}

fn some_keys() -> Vec<DVec3> {
    [[0.1, 0.9, 0.3], [-0.8, 0.2, 0.5], [0.3, -0.4, -0.9], [0.9, -0.3, 0.4]]
        .map(DVec3::from)
        .to_vec()
}

fn code(directions: &[DVec3], scheme: KeyScheme) -> Vec<&'static str> {
    KeyWeights::new(directions, scheme).warnings.iter().map(|d| d.code).collect()
}

/// Asserts that weights at keys are unit vectors, and everywhere in [0, 1] with sum 1.
fn check(keys: &KeyWeights, directions: &[DVec3], at_keys: f64) {
    for (key, &direction) in directions.iter().enumerate() {
        for (other, weight) in keys.weights(direction).into_iter().enumerate() {
            let wanted = f64::from(u8::from(other == key));
            assert!((weight - wanted).abs() < at_keys, "weight {other} at key {key} is {weight}");
        }
    }
    for direction in spread(500) {
        let weights = keys.weights(direction);
        assert!(weights.iter().all(|weight| (0.0..=1.0).contains(weight)), "{weights:?}");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-13, "{weights:?}");
    }
}

#[test]
fn no_keys_give_no_weights_and_one_has_all() {
    for scheme in ALL {
        let none = keys(&[], scheme);
        assert!(none.is_empty() && !none.has_weight() && none.weights(DVec3::X).is_empty());
        let one = keys(&[DVec3::new(0.0, 3.0, 4.0)], scheme);
        assert!(
            spread(100)
                .all(|direction| one.weights(direction) == [1.0] && one.raw(direction) == [1.0])
        );
    }
}

#[test]
fn a_duplicate_changes_nothing() {
    let mut directions = some_keys();
    for (scheme, again) in ALL.into_iter().flat_map(|scheme| [(scheme, 1.0), (scheme, 7.5)]) {
        let before = keys(&directions, scheme);
        directions.insert(2, directions[1] * again);
        assert_eq!(code(&directions, scheme), ["merged-keys"]);
        let after = keys(&directions, scheme);
        directions.remove(2);
        for direction in spread(50) {
            let [was, is] = [before.weights(direction), after.weights(direction)];
            assert_eq!(is[1], is[2]);
            let merged = [is[0], is[1] + is[2], is[3], is[4]];
            assert!(
                merged.iter().zip(&was).all(|(a, b)| (a - b).abs() < 1e-14),
                "{merged:?} was {was:?}"
            );
        }
    }
}

#[test]
fn keys_a_millionth_apart_are_one() {
    let [a, b] = [DVec3::X, DVec3::new(1.0, 1e-6, 0.0)];
    for scheme in ALL {
        assert_eq!(code(&[a, b, DVec3::Z], scheme), ["merged-keys"]);
        let both = keys(&[a, b, DVec3::Z], scheme);
        for at in [a, b] {
            let weights = both.weights(at);
            assert!(
                (weights[0] - 0.5).abs() < 1e-6 && weights[0] == weights[1] && weights[2] < 1e-6,
                "{weights:?}"
            );
        }
        check(&both, &[], 0.0);
    }
}

#[test]
fn opposite_keys_give_symmetric_halves() {
    let axis = DVec3::new(0.48, -0.6, 0.64);
    for scheme in CLOSED {
        let pair = keys(&[axis, -axis], scheme);
        check(&pair, &[axis, -axis], 1e-12);
        for direction in spread(200) {
            let [here, there] = [pair.weights(direction), pair.weights(-direction)];
            assert!((here[0] - there[1]).abs() < 1e-14);
            assert_eq!(here[0] > 0.5, direction.dot(axis) > 0.0);
            let equator = pair.weights(direction - direction.dot(axis) * axis);
            assert!((equator[0] - 0.5).abs() < 1e-14, "{equator:?}");
            // A light direction blended half-way is one of the two directions, never zero.
            let light = blend_direction(&equator, &[axis, -axis]).unwrap();
            assert!((light.dot(axis).abs() - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn lengths_do_not_matter() {
    let scaled: Vec<DVec3> =
        some_keys().iter().zip([1e-200, 3.0, 1e200, 0.5]).map(|(d, s)| *d * s).collect();
    for scheme in ALL {
        let (unit, any) = (keys(&some_keys(), scheme), keys(&scaled, scheme));
        for direction in spread(50) {
            let pairs = unit.weights(direction).into_iter().zip(any.weights(direction * 1e-170));
            assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }
}

#[test]
fn keys_without_direction_have_no_weight() {
    let directions =
        [DVec3::ZERO, DVec3::X, DVec3::new(f64::NAN, 1.0, 0.0), DVec3::Y, DVec3::INFINITY];
    for scheme in ALL {
        assert_eq!(code(&directions, scheme), ["key-without-direction"; 3]);
        let odd = KeyWeights::new(&directions, scheme).value;
        let plain = keys(&[DVec3::X, DVec3::Y], scheme);
        for direction in spread(50) {
            let wanted = plain.weights(direction);
            assert_eq!(odd.weights(direction), [0.0, wanted[0], 0.0, wanted[1], 0.0]);
        }
        let nowhere = KeyWeights::new(&[DVec3::ZERO, DVec3::NAN], scheme).value;
        assert!(!nowhere.has_weight() && nowhere.weights(DVec3::X) == [0.0, 0.0]);
    }
}

#[test]
fn a_query_without_direction_favors_no_key() {
    for scheme in ALL {
        for nowhere in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
            assert_eq!(keys(&some_keys(), scheme).weights(nowhere), [0.25; 4]);
        }
    }
}

#[test]
fn keys_ten_degrees_apart_and_between_vertices_are_met() {
    // Hard case 23: no vertex of a regular mesh lies at any of these keys.
    let (sin, cos) = 10f64.to_radians().sin_cos();
    let directions = [DVec3::new(cos, sin, 0.0), DVec3::X, DVec3::new(0.123, 0.456, -0.789)];
    for scheme in ALL {
        let met = keys(&directions, scheme);
        check(&met, &directions, 1e-9);
    }
}

#[test]
fn close_keys_are_warned_of_and_still_met() {
    for angle in [2e-4f64, 1e-3, 0.01, 0.08] {
        let directions =
            [DVec3::X, DVec3::new(angle.cos(), 0.0, angle.sin()), DVec3::Y, DVec3::NEG_Z];
        for scheme in CLOSED {
            assert_eq!(code(&directions, scheme), ["close-keys"]);
            check(&keys(&directions, scheme), &directions, 1e-9);
        }
    }
    assert!(code(&[DVec3::X, DVec3::new(1.0, 0.09, 0.0)], Biharmonic).is_empty(), "5.1 degrees");
}

#[test]
fn a_mesh_that_is_too_coarse_gives_way_to_the_closed_form() {
    let directions = [DVec3::X, DVec3::new(1.0, 0.01, 0.0), DVec3::Y];
    assert_eq!(code(&directions, Tessellated), ["close-keys", "tessellation-too-coarse"]);
    let (meshed, closed) = (keys(&directions, Tessellated), keys(&directions, AppendixB));
    assert!(spread(50).all(|direction| meshed.weights(direction) == closed.weights(direction)));
}

#[test]
fn a_mesh_may_have_a_key_at_every_vertex() {
    let (short, long) = (1.0, 0.5 * (1.0 + 5f64.sqrt()));
    let corners = [(short, long), (-short, long), (short, -long), (-short, -long)];
    let directions: Vec<DVec3> = corners
        .iter()
        .flat_map(|&(s, l)| [[0.0, s, l], [s, l, 0.0], [l, 0.0, s]].map(DVec3::from))
        .collect();
    let (full, problems) =
        KeyWeights::tessellated(&directions, Tessellation { level: 0, area_weighted: false })
            .into_parts();
    assert!(problems.iter().all(|d| d.code == "keys-near-mesh-size"), "{problems:?}");
    check(&full, &directions, 1e-12);
}

#[test]
fn many_keys_are_fine_and_too_many_are_reported() {
    let directions: Vec<DVec3> = spread(MAX_KEYS).collect();
    for scheme in CLOSED {
        check(&keys(&directions, scheme), &directions, 1e-9);
    }
    let directions: Vec<DVec3> = spread(100).cycle().take(2000).collect();
    let (many, problems) = KeyWeights::new(&directions, Biharmonic).into_parts();
    assert_eq!(problems.last().map(|d| d.code), Some("too-many-keys"));
    let weights = many.weights(DVec3::X);
    assert!(weights[MAX_KEYS..].iter().all(|&weight| weight == 0.0));
    assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
}

#[test]
fn weights_are_flat_at_keys_from_every_side() {
    // C1: one-sided derivatives along great circles agree at a key, because all are 0 there. (Those
    // of raw weights are not 0.)
    let directions = some_keys();
    for scheme in CLOSED {
        let weights = keys(&directions, scheme);
        for (key, center) in directions.iter().map(|d| d.normalize()).enumerate() {
            for tangent in
                [center.any_orthonormal_vector(), center.cross(center.any_orthonormal_vector())]
            {
                let h = 1e-5;
                let slope = |h: f64| {
                    let moved = weights.weights(center * h.abs().cos() + tangent * h.sin());
                    let at = weights.weights(center);
                    (0..at.len()).map(|k| ((moved[k] - at[k]) / h).abs()).fold(0.0, f64::max)
                };
                assert!(
                    slope(h) < 1e-3 && slope(-h) < 1e-3,
                    "{scheme:?} at key {key}: {} {}",
                    slope(h),
                    slope(-h)
                );
            }
        }
    }
}

#[test]
fn weights_are_continuously_differentiable_everywhere() {
    // On a great circle through keys and through lines where weights are clamped, neighboring
    // difference quotients differ by O(h log h): no kink.
    let directions = some_keys();
    let from = directions[0].normalize();
    let toward = (directions[1] - directions[1].dot(from) * from).normalize();
    let largest_change = |weights: &KeyWeights, steps: u32| {
        let h = std::f64::consts::TAU / f64::from(steps);
        let at = |step: u32| {
            let (sin, cos) = (h * f64::from(step)).sin_cos();
            weights.weights(from * cos + toward * sin)
        };
        let (mut before, mut now, mut largest) = (at(0), at(1), 0.0f64);
        for step in 2..=steps + 1 {
            let next = at(step);
            for k in 0..now.len() {
                largest = largest.max(((next[k] - 2.0 * now[k] + before[k]) / h).abs());
            }
            (before, now) = (now, next);
        }
        largest
    };
    for scheme in CLOSED {
        let weights = keys(&directions, scheme);
        let (coarse, fine) = (largest_change(&weights, 2_000), largest_change(&weights, 16_000));
        assert!(fine < 0.2 * coarse, "{scheme:?}: {coarse} then {fine}");
    }
}

#[test]
fn the_second_derivative_of_raw_weights_grows_like_a_logarithm_at_keys() {
    // The paper claims C2; but the second derivative grows by the same amount with every factor of
    // 10 nearer to a key.
    let pair = keys(&[DVec3::Z, DVec3::X], Biharmonic);
    let second = |h: f64| {
        let at = |h: f64| pair.raw(DVec3::new(0.0, h.sin(), h.cos()))[0];
        (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h)
    };
    // w = 1/2 + (K(x, x_1) - K(x, x_2)) / (-2 K(x_1, x_2)), K(y) ~ y ln y, and K(1/2) = -(pi^2 + 6
    // ln(2)^2) / 12.
    let wanted = -6.0 * 10f64.ln() / (std::f64::consts::PI.powi(2) + 6.0 * 2f64.ln().powi(2));
    for h in [1e-1, 1e-2, 1e-3] {
        let step = second(h / 10.0) - second(h);
        assert!((step / wanted - 1.0).abs() < 2e-3, "{step} instead of {wanted} at {h}");
    }
}

/// Directions uniform in a cube, without short ones: any spread, clusters included.
fn any_direction() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0f64..1.0]
        .prop_map(DVec3::from)
        .prop_filter("too short", |d| d.length() > 0.1)
}

/// Vectors of any bits: infinities and NaN, subnormals and the largest numbers.
fn any_bits() -> impl Strategy<Value = DVec3> {
    use prop::num::f64::ANY;
    [ANY, ANY, ANY].prop_map(DVec3::from)
}

/// A configuration of `cases` random sets that writes no failures to disk.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config(256))]

    #[test]
    fn random_sets_are_partitions_of_unity(
        directions in prop::collection::vec(any_direction(), 1..24),
        queries in prop::collection::vec(any_direction(), 32),
    ) {
        for scheme in CLOSED {
            let (keys, problems) = KeyWeights::new(&directions, scheme).into_parts();
            let is_of_places = |code| ["close-keys", "merged-keys"].contains(&code);
            prop_assert!(problems.iter().all(|problem| is_of_places(problem.code)));
            for &query in queries.iter().chain(&directions) {
                let weights = keys.weights(query);
                prop_assert!(weights.iter().all(|weight| (0.0..=1.0).contains(weight)));
                prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                prop_assert!((keys.raw(query).iter().sum::<f64>() - 1.0).abs() < 1e-6);
            }
            if problems.iter().all(|d| d.code != "merged-keys") {
                for (key, &direction) in directions.iter().enumerate() {
                    prop_assert!((keys.weights(direction)[key] - 1.0).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn turning_everything_changes_nothing(
        directions in prop::collection::vec(any_direction(), 2..12),
        query in any_direction(),
        axis in any_direction(),
        angle in -3.0..3.0,
    ) {
        let turn = DQuat::from_axis_angle(axis.normalize(), angle);
        let turned: Vec<DVec3> = directions.iter().map(|d| turn * *d).collect();
        for scheme in CLOSED {
            let (still, problems) = KeyWeights::new(&directions, scheme).into_parts();
            prop_assume!(problems.is_empty());
            let moved = KeyWeights::new(&turned, scheme).value;
            for (a, b) in still.weights(query).into_iter().zip(moved.weights(turn * query)) {
                prop_assert!((a - b).abs() < 1e-10, "{a} {b}");
            }
        }
    }

    #[test]
    fn the_order_of_keys_does_not_matter(
        directions in prop::collection::vec(any_direction(), 2..12),
        query in any_direction(),
    ) {
        let reversed: Vec<DVec3> = directions.iter().copied().rev().collect();
        for scheme in CLOSED {
            let (keys, problems) = KeyWeights::new(&directions, scheme).into_parts();
            prop_assume!(problems.is_empty());
            let others = KeyWeights::new(&reversed, scheme).value;
            for (
                a, b
            ) in keys.weights(query).into_iter().zip(others.weights(query).into_iter().rev()) {
                prop_assert!((a - b).abs() < 1e-10, "{a} {b}");
            }
        }
    }

    #[test]
    fn any_bits_give_finite_weights(
        directions in prop::collection::vec(any_bits(), 0..8),
        query in any_bits(),
    ) {
        for scheme in CLOSED {
            let keys = KeyWeights::new(&directions, scheme).value;
            let weights = keys.weights(query);
            let wanted = if keys.has_weight() { 1.0 } else { 0.0 };
            prop_assert!((weights.iter().sum::<f64>() - wanted).abs() < 1e-12, "{weights:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn coarse_meshes_are_partitions_of_unity_too(
        directions in prop::collection::vec(any_direction(), 2..12),
        queries in prop::collection::vec(any_direction(), 64),
        area_weighted: bool,
    ) {
        let (keys, problems) = KeyWeights::tessellated(
            &directions, Tessellation { level: 2, area_weighted }
        ).into_parts();
        prop_assert!(!has_errors(&problems));
        for &query in queries.iter().chain(&directions) {
            let weights = keys.weights(query);
            prop_assert!(weights.iter().all(|weight| (0.0..=1.0).contains(weight)));
            prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{weights:?}");
        }
        if problems.iter().all(|d| d.code != "merged-keys") {
            for (key, &direction) in directions.iter().enumerate() {
                prop_assert!((keys.weights(direction)[key] - 1.0).abs() < 1e-9);
            }
        }
    }
}
