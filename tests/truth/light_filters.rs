//! Filters of lights by computations of their own in f64: what stands in a light's way is found by
//! search along the way.
#![cfg(feature = "gpu")]

use crate::support::eval::{eval, look, truth};
use crate::support::random::Random;
use chiaro::frame::{EvalSample, SetupLook};
use glam::{DMat3, DVec3};
use serde_json::{Value as Json, json};

/// Samples of a test.
const SAMPLES: usize = 4_000;
/// Surface points that are nearer to an edge than this are left out: f32 decides there.
const EDGE: f64 = 1e-3;

/// Light of a test, by its kind.
#[derive(Clone, Copy, Debug)]
enum TestLamp {
    Sun(DVec3),
    Point(DVec3),
    Spot(DVec3, DVec3),
}

impl TestLamp {
    fn json(self) -> Json {
        match self {
            Self::Sun(toward) => json!({"direction": toward.to_array(), "space": "world"}),
            Self::Point(place) => {
                json!({"type": "point", "position": place.to_array(), "space": "world"})
            }
            Self::Spot(place, aim) => json!({"type": "spot", "position": place.to_array(),
                "aim": aim.to_array(), "space": "world"}),
        }
    }

    /// The way of its light from a place, from 0 to 1.
    fn way(self, place: DVec3) -> impl Fn(f64) -> DVec3 {
        move |t| match self {
            Self::Sun(toward) => place + 1e3 * t * toward.normalize(),
            Self::Point(lamp) | Self::Spot(lamp, _) => place + t * (lamp - place),
        }
    }
}

/// A look that shows an output of a node of a kind for a lamp.
fn filter(kind: &str, output: &str, lamp: Option<TestLamp>, values: &Json) -> SetupLook {
    let mut values = values.clone();
    let mut lights = json!({});
    if let Some(lamp) = lamp {
        lights["lamp"] = lamp.json();
        values["light"] = json!("lamp");
    }
    look(&json!({"lights": lights,
        "nodes": [{"id": "filter", "kind": kind, "values": values},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": format!("filter.{output}"), "to": "output.color"}]}))
}

fn samples(random: &mut Random, reach: f64) -> Vec<EvalSample> {
    let f32s = |v: DVec3| v.as_vec3().as_dvec3();
    let sample = |_| EvalSample {
        position: f32s(DVec3::from_array(std::array::from_fn(|_| random.between(-reach, reach)))),
        ..EvalSample::default()
    };
    (0..SAMPLES).map(sample).collect()
}

/// Axes of a thing that points along `toward`, by a rotation.
fn axes(toward: DVec3, spin: f64) -> DMat3 {
    let z = toward.normalize();
    let x = DVec3::Y.cross(z).normalize();
    DMat3::from_axis_angle(z, spin) * DMat3::from_cols(x, z.cross(x), z)
}

/// The least of a function that falls and then rises between 0 and 1.
fn least(of: impl Fn(f64) -> f64) -> f64 {
    let (mut a, mut b) = (0.0, 1.0);
    for _ in 0..200 {
        let (left, right) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
        if of(left) < of(right) { b = right } else { a = left }
    }
    of(0.5 * (a + b))
}

/// The distance of a place from a shape's middle, 1 on its surface.
fn distance(shape: &str, at: DVec3, size: DVec3) -> f64 {
    match shape {
        "ball" => (at / size).length(),
        "box" => (at / size).abs().max_element(),
        _ => (at - DVec3::Z * at.z.clamp(-size.z, size.z)).length() / size.x,
    }
}

fn eased(x: f64, low: f64, high: f64) -> f64 {
    if low >= high {
        return if x >= low { 1.0 } else { 0.0 };
    }
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Holds a look's values against wanted ones, `None` where f32 decides.
fn hold(
    look: &SetupLook,
    samples: &[EvalSample],
    wanted: impl Fn(DVec3) -> Option<f64>,
    what: &str,
) {
    let output = if what == "inside" { "filter.inside" } else { "filter.share" };
    let (mut compared, mut seen) = (0, [f64::INFINITY, f64::NEG_INFINITY]);
    for (values, bound) in
        [(truth(look, output, samples), 1e-6), (eval(look, output, samples), 2e-3)]
    {
        for (value, sample) in values.iter().zip(samples) {
            let Some(wanted) = wanted(sample.position) else { continue };
            compared += 1;
            seen = [seen[0].min(wanted), seen[1].max(wanted)];
            assert!(
                (value[0] - wanted).abs() <= bound,
                "{what} at {:?}: {} for {wanted}",
                sample.position,
                value[0]
            );
        }
    }
    assert!(compared > SAMPLES, "{what}: {compared} compared");
    assert!(seen[0] < 0.1 && seen[1] > 0.9, "{what}: {seen:?}");
}

#[test]
fn a_blocker_darkens_what_lies_behind_it() {
    let mut random = Random::new(31);
    let center = DVec3::new(0.25, 1.0, -0.125);
    let toward = DVec3::new(0.5, 1.0, 0.25);
    let size = DVec3::new(0.5, 0.75, 1.0);
    let lamps = [
        TestLamp::Sun(DVec3::new(0.25, 1.0, 0.5)),
        TestLamp::Point(DVec3::new(0.5, 3.0, 0.5)),
        TestLamp::Spot(DVec3::new(-0.5, 3.0, 0.5), DVec3::new(0.0, -1.0, 0.0)),
    ];
    let axes = axes(toward, 0.7);
    for lamp in lamps {
        for (shape, softness) in [("ball", 0.0), ("ball", 0.5), ("box", 0.25), ("capsule", 0.25)] {
            let values = json!({"shape": shape, "center": center.to_array(),
                "toward": toward.to_array(), "spin": 0.7, "size": size.to_array(),
                "softness": softness});
            let wanted = |place: DVec3| {
                let way = lamp.way(place);
                let m = least(|t| distance(shape, axes.transpose() * (way(t) - center), size));
                let is_hard = softness == 0.0 && (m - 1.0).abs() < EDGE;
                (!is_hard).then(|| eased(m, 1.0, 1.0 + softness))
            };
            let look = filter("blocker", "share", Some(lamp), &values);
            hold(&look, &samples(&mut random, 2.0), wanted, &format!("{shape} {lamp:?}"));
        }
    }
}

#[test]
fn a_card_darkens_what_sees_the_light_through_it() {
    let mut random = Random::new(32);
    let (lamp, center) = (DVec3::new(0.5, 3.0, 0.5), DVec3::new(0.0, 1.5, 0.25));
    let toward = DVec3::new(0.5, 1.0, 0.25);
    let axes = axes(toward, 0.2);
    let values = json!({"shape": "card", "center": center.to_array(), "size": [0.5, 0.75, 1],
        "toward": toward.to_array(), "spin": 0.2, "inverted": true});
    let wanted = |place: DVec3| {
        let [from, to] = [place, lamp].map(|at| axes.transpose() * (at - center));
        let t = from.z / (from.z - to.z);
        let at = from + t * (to - from);
        let m = (at.x.abs() / 0.5).max(at.y.abs() / 0.75);
        let is_edge = (m - 1.0).abs() < EDGE || t.abs() < EDGE || (t - 1.0).abs() < EDGE;
        (!is_edge).then(|| f64::from(u8::from((0.0..=1.0).contains(&t) && m < 1.0)))
    };
    let look = filter("blocker", "share", Some(TestLamp::Point(lamp)), &values);
    hold(&look, &samples(&mut random, 1.4), wanted, "card");
}

#[test]
fn a_rod_dims_the_places_inside() {
    let mut random = Random::new(33);
    let (center, size) = (DVec3::new(0.25, 0.5, -0.25), DVec3::new(0.5, 0.75, 1.0));
    let axes = axes(DVec3::new(1.0, 0.5, 0.0), -0.4);
    for (roundness, inverted) in [(0.0, false), (1.0, true), (0.5, false)] {
        let values = json!({"center": center.to_array(), "toward": [1, 0.5, 0], "spin": -0.4,
            "size": size.to_array(), "roundness": roundness, "softness": 0.5,
            "inverted": inverted});
        let wanted = |place: DVec3| {
            let q = (axes.transpose() * (place - center)) / size;
            let m = (1.0 - roundness) * q.abs().max_element() + roundness * q.length();
            let beside = eased(m, 1.0, 1.5);
            Some(if inverted { 1.0 - beside } else { beside })
        };
        let look = filter("rod", "share", None, &values);
        hold(&look, &samples(&mut random, 1.5), wanted, &format!("rod {roundness}"));
    }
}

#[test]
fn barn_doors_cut_between_angles() {
    let mut random = Random::new(34);
    let (place, aim) = (DVec3::new(0.25, 2.0, 1.0), DVec3::new(0.25, -1.0, -0.5));
    let axes = axes(aim, 0.3);
    let flaps = json!({"left": 0.5, "right": 0.25, "top": 0.375, "bottom": 0.75, "spin": 0.3,
        "softness": 0.2, "toward": aim.to_array()});
    let wanted = |at: DVec3| {
        let seen = axes.transpose() * (at - place);
        let [aside, up] = [seen.x.atan2(seen.z), seen.y.atan2(seen.z)];
        let beside = |angle: f64, flap: f64| 1.0 - eased(angle, flap, flap + 0.2);
        Some(beside(aside, 0.5) * beside(-aside, 0.25) * beside(up, 0.375) * beside(-up, 0.75))
    };
    for lamp in [TestLamp::Point(place), TestLamp::Spot(place, aim)] {
        let look = filter("barn_doors", "share", Some(lamp), &flaps);
        hold(&look, &samples(&mut random, 2.0), wanted, &format!("{lamp:?}"));
    }
}

#[test]
fn a_light_throws_a_picture_upright() {
    let mut random = Random::new(35);
    let (place, aim) = (DVec3::new(0.25, 2.0, 1.0), DVec3::new(0.25, -1.0, -0.5));
    let axes = axes(aim, 0.0);
    let samples = samples(&mut random, 1.5);
    let values = json!({"angle": 0.5});
    let thrown = |at: DVec3| {
        let seen = axes.transpose() * (at - place);
        let [right, up] = [-seen.x, seen.y].map(|x| x / (seen.z * 0.5_f64.tan()));
        (seen.z > 0.01).then_some([0.5 + 0.5 * right, 0.5 + 0.5 * up])
    };
    let look_at = filter("light_place", "inside", Some(TestLamp::Spot(place, aim)), &values);
    let inside = |at: DVec3| {
        let m = thrown(at)?.map(|x| (2.0 * x - 1.0).abs()).into_iter().fold(0.0, f64::max);
        ((m - 1.0).abs() > EDGE).then(|| f64::from(u8::from(m < 1.0)))
    };
    hold(&look_at, &samples, inside, "inside");
    let found = truth(
        &filter("light_place", "uv", Some(TestLamp::Spot(place, aim)), &values),
        "filter.uv",
        &samples,
    );
    for (found, sample) in found.iter().zip(&samples) {
        let Some(wanted) = thrown(sample.position).filter(|uv| uv.iter().all(|x| x.abs() < 100.0))
        else {
            continue;
        };
        assert!((found[0] - wanted[0]).abs() < 1e-4, "{found:?} for {wanted:?}");
        assert!((found[1] - wanted[1]).abs() < 1e-4, "{found:?} for {wanted:?}");
    }
    // What is to the right of who looks along the light is to the right in its picture.
    let sun = TestLamp::Sun(DVec3::Z);
    let values = json!({"size": 2, "center": [0, 0, 0]});
    let at = [EvalSample { position: DVec3::new(1.0, 0.5, 0.0), ..EvalSample::default() }];
    let [u, v, ..] = truth(&filter("light_place", "uv", Some(sun), &values), "filter.uv", &at)[0];
    assert!((u - 0.75).abs() < 1e-9 && (v - 0.625).abs() < 1e-9, "{u} {v}");
}

#[test]
fn a_measured_lamp_shines_as_its_file_says() {
    let mut random = Random::new(38);
    let (place, aim) = (DVec3::new(0.25, 2.0, 1.0), DVec3::new(0.25, -1.0, -0.5));
    let axes = axes(aim, 0.3);
    let samples = samples(&mut random, 1.5);
    let file = include_str!("../../examples/images/two-wings.ies");
    // Strengths of each quarter turn, by steps of 15 degrees around and 5 down.
    let candela: Vec<Vec<f64>> = file
        .lines()
        .skip(9)
        .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
        .collect();
    let greatest = candela.iter().flatten().copied().fold(0.0, f64::max);
    let strength = |at: DVec3| {
        let seen = axes.transpose() * (at - place);
        let down = seen.truncate().length().atan2(seen.z).to_degrees();
        let around = seen.y.abs().atan2(seen.x.abs()).to_degrees();
        let (row, column) = (down / 5.0, around / 15.0);
        let of = |column: usize| {
            let [above, below] = [0, 1].map(|next| candela[column][row as usize + next]);
            above + row.fract() * (below - above)
        };
        let left = (column as usize).min(candela.len() - 2);
        let aside = column - left as f64;
        (of(left) + aside * (of(left + 1) - of(left))) / greatest
    };
    let values = json!({"spin": 0.3, "toward": aim.to_array(),
        "image": "example:images/two-wings.ies"});
    for lamp in [TestLamp::Point(place), TestLamp::Spot(place, aim)] {
        let look = filter("photometry", "share", Some(lamp), &values);
        for values in
            [truth(&look, "filter.share", &samples), eval(&look, "filter.share", &samples)]
        {
            let mut seen = [f64::INFINITY, f64::NEG_INFINITY];
            for (value, sample) in values.iter().zip(&samples) {
                let away = axes.transpose() * (sample.position - place);
                let is_in_front = away.z > 0.2 * away.length();
                let wanted = if is_in_front { strength(sample.position) } else { continue };
                seen = [seen[0].min(wanted), seen[1].max(wanted)];
                // Rows of 0.7 degrees, and eight bits of its root.
                assert!((value[0] - wanted).abs() < 0.02, "{} for {wanted}", value[0]);
            }
            assert!(seen[0] < 0.05 && seen[1] > 0.9, "{seen:?}");
        }
    }
    // Around the lamp, from its right upward, and from 1 in front to 0 at its back.
    let look = filter(
        "lamp_sphere",
        "uv",
        Some(TestLamp::Point(DVec3::ZERO)),
        &json!({"toward": [0, 0, 1]}),
    );
    for (at, wanted) in [
        (DVec3::NEG_X, [0.0, 0.5]),
        (DVec3::Y, [0.25, 0.5]),
        (DVec3::X, [0.5, 0.5]),
        (DVec3::NEG_Y, [0.75, 0.5]),
        (DVec3::Z, [0.0, 1.0 - 0.5 / 256.0]),
        (DVec3::new(1.0, 0.0, -1.0), [0.5, 0.25]),
    ] {
        let sample = [EvalSample { position: at, ..EvalSample::default() }];
        let found = truth(&look, "filter.uv", &sample)[0];
        assert!((found[0] - wanted[0]).abs() < 1e-6, "{found:?} for {wanted:?}");
        assert!((found[1] - wanted[1]).abs() < 1e-6, "{found:?} for {wanted:?}");
    }
}

#[test]
fn lamps_begin_end_and_decay_by_distance() {
    let mut random = Random::new(36);
    let place = DVec3::new(0.25, 0.5, 1.0);
    let lamp = Some(TestLamp::Point(place));
    let samples = samples(&mut random, 2.0);
    let ramp = json!({"near_from": 0.5, "near_to": 1, "far_from": 1.5, "far_to": 2.5});
    let wanted = |at: DVec3| {
        let d = at.distance(place);
        Some(eased(d, 0.5, 1.0) * (1.0 - eased(d, 1.5, 2.5)))
    };
    hold(&filter("distance_ramp", "share", lamp, &ramp), &samples, wanted, "ramp");
    let decay = json!({"start": 0.5, "power": 2.5});
    let wanted = |at: DVec3| Some((0.5 / at.distance(place)).powf(2.5).min(1.0));
    hold(&filter("decay", "share", lamp, &decay), &samples, wanted, "decay");
}

#[test]
fn the_sun_has_no_doors_and_does_not_decay() {
    let samples = samples(&mut Random::new(37), 2.0);
    for kind in ["barn_doors", "distance_ramp", "decay"] {
        let look = filter(kind, "share", Some(TestLamp::Sun(DVec3::Y)), &json!({}));
        assert!(
            truth(&look, "filter.share", &samples).iter().all(|value| value[0] == 1.0),
            "{kind}"
        );
    }
}

#[test]
fn filters_are_combined_in_five_ways() {
    let (a, b) = (0.75, 0.5);
    for (mode, wanted) in
        [("multiply", a * b), ("add", 1.0), ("subtract", a - b), ("minimum", b), ("maximum", a)]
    {
        let look = filter("combine_filters", "share", None, &json!({"mode": mode, "a": a, "b": b}));
        let found = truth(&look, "filter.share", &[EvalSample::default()]);
        assert_eq!(found[0][0], wanted, "{mode}");
    }
}

/// A filter after the profile dims; before it, it moves the terminator, by tan(u/2) over the share.
#[test]
fn the_stage_of_a_filter_dims_or_moves() {
    let share = 0.375;
    let stack = |stage: &str| {
        look(&json!({"lights": {"key": {"direction": [0, 0, 1], "space": "world"}},
            "nodes": [
                {"id": "lamp", "kind": "light"}, {"id": "angle", "kind": "parametrization"},
                {"id": "filter", "kind": "light_filter",
                    "values": {"stage": stage, "share": share}},
                {"id": "tone", "kind": "profile"}, {"id": "parts", "kind": "light_parts"},
                {"id": "lit", "kind": "multiply"}, {"id": "output", "kind": "output"}],
            "wires": [
                {"from": "lamp", "to": "angle.light"}, {"from": "lamp", "to": "filter.light"},
                {"from": "angle", "to": "filter.angle"},
                {"from": "filter.angle", "to": "tone.angle"},
                {"from": "filter.light", "to": "parts.light"},
                {"from": "parts.intensity", "to": "lit.a"}, {"from": "tone", "to": "lit.b"},
                {"from": "lit", "to": "output.color"}]}))
    };
    let mut random = Random::new(38);
    let samples: Vec<EvalSample> = (0..500)
        .map(|_| EvalSample { normal: random.direction(), ..EvalSample::default() })
        .collect();
    for (stage, dimmed, moved) in [("after", share, 1.0), ("before", 1.0, share)] {
        let found = truth(&stack(stage), "lit", &samples);
        for (found, sample) in found.iter().zip(&samples) {
            let u = sample.normal.normalize().angle_between(DVec3::Z);
            // The profile as it is by default is Lambert's.
            let wanted = dimmed * (2.0 * ((u / 2.0).tan() / moved).atan()).cos().max(0.0);
            assert!((found[0] - wanted).abs() < 1e-6, "{stage} {u}: {} for {wanted}", found[0]);
        }
    }
    // Where nothing passes, everything is dark, the place that faces the light too.
    let blocked = look(&json!({"lights": {"key": {"direction": [0, 0, 1], "space": "world"}},
        "nodes": [
            {"id": "lamp", "kind": "light"}, {"id": "angle", "kind": "parametrization"},
            {"id": "filter", "kind": "light_filter", "values": {"stage": "before", "share": 0}},
            {"id": "tone", "kind": "profile"}, {"id": "output", "kind": "output"}],
        "wires": [
            {"from": "lamp", "to": "angle.light"}, {"from": "lamp", "to": "filter.light"},
            {"from": "angle", "to": "filter.angle"}, {"from": "filter.angle", "to": "tone.angle"},
            {"from": "tone", "to": "output.color"}]}));
    let facing = EvalSample { normal: DVec3::Z, ..EvalSample::default() };
    let all = [&[facing], samples.as_slice()].concat();
    for values in [truth(&blocked, "tone", &all), eval(&blocked, "tone", &all)] {
        assert!(values.iter().all(|value| value[0] == 0.0));
    }
}
