//! Passes over the normals for nodes of the category "shape", against closed forms: the curvature
//! tensor, ever smoother normals, contours. These passes run only where a node reads them.
#![cfg(feature = "gpu")]

use std::f64::consts::{PI, TAU};

use crate::support::eval::{look, renderer, scene_of, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::{Camera, Projection, Scene, Tier};
use chiaro::frame::{FramePlan, PassId, PlanOptions, Planner, SetupLook};
use chiaro::geometry::{Mesh, MeshPart};
use chiaro::interp::{Precision, Value};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules};
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

const SIZE: [u32; 2] = [150, 100];
/// Height of the pictures. In scene units.
const HEIGHT: f64 = 2.0;

/// A look that shows one value.
fn showing(nodes: &Json, wires: &Json) -> SetupLook {
    let mut nodes = nodes.as_array().expect("nodes").clone();
    nodes.push(json!({"id": "output", "kind": "output"}));
    look(&json!({"lights": {"key": {"direction": [0, 0, 1]}}, "nodes": nodes, "wires": wires}))
}

/// A look that shows one component of a normal, in world space.
fn normal_along(axis: [f64; 3], scale: &str) -> SetupLook {
    showing(
        &json!([
            {"id": "smooth", "kind": "smooth_normal", "values": {"scale": scale}},
            {"id": "part", "kind": "dot_product", "values": {"b": axis}}
        ]),
        &json!([{"from": "smooth", "to": "part.a"}, {"from": "part", "to": "output.color"}]),
    )
}

/// A mesh of z = height(x, y) with given normals, over a range of x and of y.
fn raised(
    x: [f64; 2],
    y: [f64; 2],
    steps: [usize; 2],
    height: impl Fn(f64, f64) -> f64,
    normal: impl Fn(f64, f64) -> [f64; 3],
) -> Mesh {
    let (mut positions, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    let at = |range: [f64; 2], step: usize, count: usize| {
        range[0] + (range[1] - range[0]) * step as f64 / count as f64
    };
    for j in 0..=steps[1] {
        for i in 0..=steps[0] {
            let (x, y) = (at(x, i, steps[0]), at(y, j, steps[1]));
            positions.push([x, y, height(x, y)].map(|x| x as f32));
            normals.push(normal(x, y).map(|x| x as f32));
            if i > 0 && j > 0 {
                let here = (j * (steps[0] + 1) + i) as u32;
                let below = here - steps[0] as u32 - 1;
                indices.extend([below - 1, below, here, below - 1, here, here - 1]);
            }
        }
    }
    let count = positions.len();
    let part = MeshPart { indices: 0..indices.len() as u32, ..MeshPart::default() };
    Mesh {
        positions,
        normals,
        tangents: vec![[1.0, 0.0, 0.0, 1.0]; count],
        uvs: vec![[0.0; 2]; count],
        colors: vec![[1.0; 4]; count],
        indices,
        parts: vec![part],
        ..Mesh::default()
    }
}

/// A plane that fills the picture, with given normals.
fn plane(normal: impl Fn(f64, f64) -> [f64; 3]) -> Mesh {
    raised([-1.5, 1.5], [-1.0, 1.0], [150, 100], |_, _| 0.0, normal)
}

fn plan_of(parts: Vec<(SetupLook, Mesh)>, size: [u32; 2]) -> FramePlan {
    let camera = Camera {
        eye: [0.0, 0.0, 9.0],
        target: [0.0; 3],
        projection: Projection::Orthographic,
        height: HEIGHT,
        ..Camera::default()
    };
    let parts = parts.into_iter().map(|(look, mesh)| (look, mesh, DMat4::IDENTITY)).collect();
    let setup = scene_of(parts, Scene { camera, backdrop: None, ..Scene::default() });
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    let planned = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
}

/// The first channel of each pixel, rows from the top; `None` where no object is.
fn drawn(parts: Vec<(SetupLook, Mesh)>) -> Vec<Option<f64>> {
    let plan = plan_of(parts, SIZE);
    let picture = block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"));
    picture.rgba.iter().map(|pixel| (pixel[3] > 0.5).then_some(f64::from(pixel[0]))).collect()
}

/// The point under a pixel's middle. In scene units.
fn place(index: usize) -> (f64, f64) {
    let (x, y) = (index % SIZE[0] as usize, index / SIZE[0] as usize);
    let pixel = HEIGHT / f64::from(SIZE[1]);
    (
        (x as f64 + 0.5 - 0.5 * f64::from(SIZE[0])) * pixel,
        (0.5 * f64::from(SIZE[1]) - y as f64 - 0.5) * pixel,
    )
}

#[test]
fn the_tensor_is_how_slopes_change() {
    // nx / nz = 0.6 x + 0.5 y, ny / nz = 0.3 x - 0.4 y. Their derivatives are xx, xy and yy, of
    // which xy is the mean of both. In 1/scene-unit.
    let (xx, xy, yy) = (0.6_f64, 0.4, -0.4);
    let bent = |x: f64, y: f64| [0.6 * x + 0.5 * y, 0.3 * x - 0.4 * y, 1.0];
    let root = (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt();
    let eigenvalues = [0.5 * (xx + yy) + root, 0.5 * (xx + yy) - root].map(|k: f64| k * HEIGHT);
    for (port, wanted) in ["greatest", "least"].into_iter().zip(eigenvalues) {
        for tier in [Tier::Exact, Tier::Fast] {
            let mut look = showing(
                &json!([{"id": "relief", "kind": "relief"}]),
                &json!([{"from": format!("relief.{port}"), "to": "output.color"}]),
            );
            look.look.set_every_tier(tier);
            let got = drawn(vec![(look, plane(bent))]);
            let worst = got
                .iter()
                .map(|x| (x.expect("it fills the picture") - wanted).abs())
                .fold(0.0, f64::max);
            // Half floats have three digits.
            assert!(worst < 4e-3, "{port} {tier:?}: {worst} from {wanted}");
        }
    }
}

/// Smooth normals are waves with the amplitude that each level's 1 2 1 filter leaves.
#[test]
fn smooth_normals_are_the_waves_that_are_left() {
    let pixel = HEIGHT / f64::from(SIZE[1]);
    let omega = TAU / (24.0 * pixel);
    let height = 0.05;
    let waves = |x: f64, _: f64| [height * (omega * x).cos(), 0.0, 1.0];
    let mut left = 1.0;
    for (level, scale) in ["fine", "small", "medium", "large"].into_iter().enumerate() {
        // In a picture this low the filter's steps are whole pixels.
        left *= 0.5 + 0.5 * (omega * pixel * f64::from(2 << level)).cos();
        let got = drawn(vec![(normal_along([1.0, 0.0, 0.0], scale), plane(waves))]);
        let mut worst = 0.0_f64;
        for (index, got) in got.iter().enumerate() {
            let (x, y) = place(index);
            // Pixels at the picture's sides lack neighbors on one side.
            if x.abs() < 1.5 - 31.0 * pixel && y.abs() < 1.0 - 31.0 * pixel {
                worst = worst.max(
                    (got.expect("it fills the picture") - left * height * (omega * x).cos()).abs(),
                );
            }
        }
        assert!(worst < 6e-4, "{scale}: {worst} of {}", left * height);
    }
}

/// Smooth normals mix in no other object and no part of the same object behind, and keep normals
/// that turn evenly: neighbors that are missing at a border on one side do not bend the normal
/// toward the other.
#[test]
fn smooth_normals_keep_to_their_surface() {
    let tilted = |x: f64, y: f64| move |_: f64, _: f64| [x, y, 1.0];
    let show = || normal_along([1.0, 0.0, 0.0], "large");
    let left = || raised([-1.5, 0.0], [-1.0, 1.0], [2, 2], |_, _| 0.0, tilted(0.4, 0.0));
    let right = |z: f64| raised([0.0, 1.5], [-1.0, 1.0], [2, 2], move |_, _| z, tilted(-0.4, 0.2));
    let own = |index: usize| {
        let normal = if place(index).0 < 0.0 {
            DVec3::new(0.4, 0.0, 1.0)
        } else {
            DVec3::new(-0.4, 0.2, 1.0)
        };
        normal.normalize().x
    };
    let mut one = left();
    let behind = right(-4.0);
    let first = one.positions.len() as u32;
    one.positions.extend(behind.positions.iter());
    one.normals.extend(behind.normals.iter());
    one.tangents.extend(behind.tangents.iter());
    one.uvs.extend(behind.uvs.iter());
    one.colors.extend(behind.colors.iter());
    one.indices.extend(behind.indices.iter().map(|index| first + index));
    one.parts[0].indices = 0..one.indices.len() as u32;
    for (what, parts) in [
        ("two objects", vec![(show(), left()), (show(), right(0.0))]),
        ("one behind the other", vec![(show(), one)]),
    ] {
        let got = drawn(parts);
        let off = |(index, x): (usize, &Option<f64>)| {
            (x.expect("it fills the picture") - own(index)).abs()
        };
        let worst = got.iter().enumerate().map(off).fold(0.0, f64::max);
        assert!(worst < 1e-3, "{what}: {worst}");
    }
    // A bowl of even slopes, whose border lies within the picture.
    let bowl =
        raised([-0.8, 0.8], [-0.6, 0.6], [80, 60], |_, _| 0.0, |x, y| [0.3 * x, 0.3 * y, 1.0]);
    let got = drawn(vec![(show(), bowl)]);
    for (index, got) in got.iter().enumerate() {
        let (x, y) = place(index);
        let wanted = DVec3::new(0.3 * x, 0.3 * y, 1.0).normalize().x;
        if let Some(got) = got {
            assert!((got - wanted).abs() < 3e-3, "{got} in place of {wanted} at {x}, {y}");
        }
    }
}

#[test]
fn contours_are_as_wide_as_asked() {
    // A ball of half the picture's height: 300 thousandths of the height are 30 pixels of
    // circumference.
    let rings = 160;
    let mut mesh =
        raised([0.0, 1.0], [0.0, 1.0], [rings, rings], |_, _| 0.0, |_, _| [0.0, 0.0, 1.0]);
    for (position, normal) in mesh.positions.iter_mut().zip(&mut mesh.normals) {
        let (theta, phi) = (f64::from(position[0]) * 0.5 * PI, f64::from(position[1]) * TAU);
        let at = DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos());
        *normal = at.to_array().map(|x| x as f32);
        *position = (0.8 * at).to_array().map(|x| x as f32);
    }
    for width in [20.0, 40.0] {
        let line = showing(
            &json!([{"id": "line", "kind": "outer_contour", "values": {"width": width}}]),
            &json!([{"from": "line", "to": "output.color"}]),
        );
        let got = drawn(vec![(line, mesh.clone())]);
        let area: f64 = got.iter().flatten().sum();
        let (radius, pixels) =
            (0.8 * f64::from(SIZE[1]) / HEIGHT, width / 1000.0 * f64::from(SIZE[1]));
        let wanted = PI * (radius * radius - (radius - pixels) * (radius - pixels));
        assert!((area / wanted - 1.0).abs() < 0.12, "{area} pixels in place of {wanted}");
        let inside = |(index, _): &(usize, &Option<f64>)| {
            let (x, y) = place(*index);
            x.hypot(y) < 0.8 - 2.0 * width / 1000.0 * HEIGHT
        };
        assert!(
            got.iter().enumerate().filter(inside).all(|(_, x)| *x == Some(0.0)),
            "nothing within"
        );
    }
}

/// Suggestive contours lie where a slope that leads up to the viewer changes from hollow to
/// bulging, and not where it changes from bulging to hollow.
#[test]
fn suggestive_contours_lie_on_inflections_that_turn_to_the_eye() {
    let line = || {
        showing(
            &json!([{
                "id": "line", "kind": "inner_contour", "values": {"width": 40.0, "limit": 0.2}
            }]),
            &json!([{"from": "line", "to": "output.color"}]),
        )
    };
    let slope = |sign: f64| {
        let height = move |x: f64, _: f64| x + sign * x * x * x;
        let normal = move |x: f64, _: f64| [-(1.0 + 3.0 * sign * x * x), 0.0, 1.0];
        raised([-0.5, 0.5], [-1.0, 1.0], [200, 4], height, normal)
    };
    let ink =
        |sign: f64| -> (f64, f64) {
            let got = drawn(vec![(line(), slope(sign))]);
            let found = got.iter().enumerate().filter_map(|(index, x)| Some((place(index), (*x)?)));
            found.fold((0.0, 0.0), |(near, far), ((x, _), ink)| {
                if x.abs() < 0.06 { (near + ink, far) } else { (near, far + ink) }
            })
        };
    let (near, far) = ink(-1.0);
    assert!(near > 150.0 && far < 1.0, "a line along x = 0: {near} and {far} elsewhere");
    let (near, far) = ink(1.0);
    assert!(near + far < 1.0, "no line: {near} and {far}");
}

/// Suggestive contours are as wide as asked, and fade where the curvature they change to is no
/// stronger than the limit.
#[test]
fn suggestive_contours_are_as_wide_and_as_strong_as_asked() {
    // The slope is 1 where x is 0, and changes by -6 x: the radial curvature goes evenly through 0
    // at x = 0.
    let height = |x: f64, _: f64| x - x * x * x;
    let mesh =
        raised([-0.5, 0.5], [-1.0, 1.0], [200, 4], height, |x, _| [-(1.0 - 3.0 * x * x), 0.0, 1.0]);
    let ink = |width: f64, limit: f64| -> f64 {
        let values = json!({"width": width, "limit": limit, "softness": 0.5});
        let line = showing(
            &json!([{"id": "line", "kind": "inner_contour", "values": values}]),
            &json!([{"from": "line", "to": "output.color"}]),
        );
        drawn(vec![(line, mesh.clone())]).iter().flatten().sum()
    };
    let rows = f64::from(SIZE[1]);
    for width in [20.0, 40.0] {
        let (got, wanted) = (ink(width, 0.2), width / 1000.0 * rows * rows);
        assert!((got / wanted - 1.0).abs() < 0.25, "{width}: {got} pixels in place of {wanted}");
    }
    // Over a twentieth of the height the curvature changes by 6 x, per scene unit, times the
    // picture's height.
    let strength = 6.0 * 0.05 * HEIGHT * HEIGHT;
    let whole = ink(40.0, 0.2);
    for (limit, wanted) in [(0.75, 1.0), (1.0, 0.5), (1.125, 0.25), (1.3, 0.0)]
        .map(|(of, share)| (of * strength, share))
    {
        let part = ink(40.0, limit) / whole;
        assert!((part - wanted).abs() < 0.06, "{limit}: {part} in place of {wanted}");
    }
}

/// Bumps lean the normal away from where the height grows, in scene units, on any surface, by up to
/// 84 degrees.
#[test]
fn bumps_lean_the_normal_by_their_slope() {
    // A level plane, and a plane that leans by one in two.
    for lean in [0.0, 0.5] {
        let mesh =
            raised([-1.5, 1.5], [-1.0, 1.0], [10, 10], |x, _| lean * x, |_, _| [-lean, 0.0, 1.0]);
        let normal = DVec3::new(-lean, 0.0, 1.0).normalize();
        for (slope, scale) in
            [([0.3, 0.2, 0.0], 0.5), ([-1.5, 0.8, 0.0], 1.0), ([40.0, 0.0, 0.0], 2.0)]
        {
            // The height's gradient along the surface.
            let gradient = DVec3::from(slope) * scale;
            let along = gradient - gradient.dot(normal) * normal;
            let limited = along * (along.length().min(10.0) / along.length());
            let wanted = (normal - limited).normalize();
            for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                let bumped = showing(
                    &json!([
                        {"id": "place", "kind": "position"},
                        {"id": "height", "kind": "dot_product", "values": {"b": slope}},
                        {"id": "bump", "kind": "bump_map", "values": {"scale": scale}},
                        {"id": "part", "kind": "dot_product", "values": {"b": axis.to_array()}}
                    ]),
                    &json!([
                        {"from": "place", "to": "height.a"},
                        {"from": "height", "to": "bump.height"},
                        {"from": "bump", "to": "part.a"}, {"from": "part", "to": "output.color"}
                    ]),
                );
                let got = drawn(vec![(bumped, mesh.clone())]);
                let seen: Vec<f64> = got.into_iter().flatten().collect();
                let worst = seen.iter().map(|x| (x - wanted.dot(axis)).abs()).fold(0.0, f64::max);
                assert!(
                    seen.len() > 10_000 && worst < 2e-3,
                    "{lean} {slope:?} {axis}: off by {worst}"
                );
            }
        }
    }
}

/// Objects are numbered in the order of the scene, and the picture's size is told in pixels.
#[test]
fn objects_have_numbers_and_pictures_a_size() {
    let half = |x: [f64; 2]| raised(x, [-1.0, 1.0], [2, 2], |_, _| 0.0, |_, _| [0.0, 0.0, 1.0]);
    let numbered = || {
        showing(
            &json!([{"id": "number", "kind": "object_id"}]),
            &json!([{"from": "number", "to": "output.color"}]),
        )
    };
    let bounds = [[-1.5, -0.5], [-0.5, 0.5], [0.5, 1.5]];
    let got = drawn(bounds.into_iter().map(|x| (numbered(), half(x))).collect());
    for (index, got) in got.iter().enumerate() {
        let wanted = bounds.iter().position(|[low, high]| (*low..*high).contains(&place(index).0));
        assert_eq!(*got, wanted.map(|number| number as f64), "{:?}", place(index));
    }
    for (port, wanted) in [("width", 150.0), ("height", 100.0), ("aspect", 1.5)] {
        let size = showing(
            &json!([{"id": "size", "kind": "viewport"}]),
            &json!([{"from": format!("size.{port}"), "to": "output.color"}]),
        );
        let got = drawn(vec![(size, plane(|_, _| [0.0, 0.0, 1.0]))]);
        assert!(
            got.iter().all(|x| *x == Some(wanted)),
            "{port}: {:?} in place of {wanted}",
            got[0]
        );
    }
}

/// Texels of a surface hold the whole unit normal, at every angle to the line of sight.
#[test]
fn a_texel_holds_the_normal() {
    let module = &Library::built_in().nodes["kappa"].module;
    let program = |name| module.program(name).unwrap_or_else(|problem| panic!("{problem}"));
    let (pack, unpack) = (program("surface_texel"), program("normal_of"));
    // The second bound is for normals nearly across the line of sight: what a rounded x and y leave
    // of the length 1.
    for (precision, bounds) in [(Precision::F64, [1e-12, 1e-7]), (Precision::F32, [3e-6, 1e-3])] {
        let mut worst = [0.0_f64; 2];
        for step in 0..=4000 {
            let (z, turn) = (1.0 - f64::from(step) / 2000.0, 2.4 * f64::from(step));
            let aside = (1.0 - z * z).sqrt();
            let normal = [aside * turn.cos(), aside * turn.sin(), z];
            let texel = pack.call(&[Value::vec(&normal), 2.5.into(), 3.0.into()], precision);
            let texel = texel.unwrap_or_else(|problem| panic!("{problem}"));
            let [x, y, depth, number] = texel.as_vec().expect("a texel");
            assert_eq!([depth, number], [2.5, if z < 0.0 { -3.0 } else { 3.0 }]);
            let divisor = z.max(0.2);
            let slope = [normal[0] / divisor, normal[1] / divisor];
            let off = (x - slope[0]).abs().max((y - slope[1]).abs());
            assert!(off < 10.0 * bounds[0], "{precision:?}, {z}: {off:e}");
            let got = unpack.call(&[texel], precision);
            let got: [f64; 3] =
                got.ok().and_then(|normal| normal.as_vec()).expect("a normal of a texel");
            let off = got.iter().zip(normal).map(|(got, wanted)| (got - wanted).abs());
            let place = usize::from(z.abs() < 0.1);
            worst[place] = off.fold(worst[place], f64::max);
        }
        assert!(worst[0] < bounds[0] && worst[1] < bounds[1], "{precision:?}: {worst:?}");
    }
}

/// Passes run where a live node reads their images, and the reference and the GPU draw the same
/// with them.
#[test]
fn passes_are_there_for_who_reads_them() {
    const NORMALS: PassId = PassId::named("normals");
    const TENSOR: PassId = PassId::named("curvature_tensor");
    const SMOOTH: [PassId; 2] =
        [PassId::named("smooth_normals_1"), PassId::named("smooth_normals_2")];
    const LOOK: PassId = PassId::LOOK;
    let normal = |x: f64, y: f64| [0.4 * (5.0 * x).sin(), 0.3 * (7.0 * y).sin(), 1.0];
    let waves = || raised([-1.5, 1.5], [-1.0, 1.0], [30, 20], |_, _| 0.0, normal);
    let kinds = |look: SetupLook| -> Vec<PassId> {
        plan_of(vec![(look, waves())], SIZE).passes.into_iter().map(|pass| pass.id).collect()
    };
    let small = normal_along([0.0, 1.0, 0.0], "small");
    assert_eq!(kinds(small), [NORMALS, SMOOTH[0], SMOOTH[1], LOOK]);
    let warped = |amount: f64, tier: Tier| {
        let mut look = showing(
            &json!([
                {"id": "light", "kind": "light", "values": {"light": "key"}},
                {"id": "warp", "kind": "light_warp", "values": {"amount": amount}},
                {"id": "tone", "kind": "reflectance", "values": {"model": "lambert"}}
            ]),
            &json!([
                {"from": "light", "to": "warp.light"},
                {"from": "warp", "to": "tone.light"},
                {"from": "tone", "to": "output.color"}
            ]),
        );
        look.look.set_every_tier(tier);
        look
    };
    assert_eq!(kinds(warped(1.0, Tier::Exact)), [NORMALS, TENSOR, LOOK]);
    assert_eq!(kinds(warped(1.0, Tier::Balanced)), [NORMALS, TENSOR, LOOK]);
    assert_eq!(kinds(warped(1.0, Tier::Fast)), [LOOK]);
    assert_eq!(kinds(warped(0.0, Tier::Exact)), [LOOK], "no warp, no pass");

    for look in [warped(2.0, Tier::Exact), normal_along([1.0, 0.0, 0.0], "large")] {
        let plan = plan_of(vec![(look, waves())], [60, 40]);
        let modules =
            Modules::new(&plan, Precision::F64).unwrap_or_else(|problem| panic!("{problem}"));
        let truth = reference::execute(
            &plan,
            &modules,
            &reference::ReferenceOptions::default(),
            &Progress::new(),
        )
        .unwrap_or_else(|problem| panic!("{problem}"));
        let picture = block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"));
        let pairs = picture.rgba.iter().zip(truth.color.values.chunks_exact(4));
        let worst =
            pairs.map(|(got, wanted)| (f64::from(got[0]) - wanted[0]).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-3, "{worst}");
    }
}

/// A pair of LitSpheres shows one where the surface bulges and the other where it is hollow.
#[test]
fn a_pair_of_litspheres_goes_by_curvature() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, color) in [("bulging.png", [200, 40, 20, 255]), ("hollow.png", [10, 60, 220, 255])] {
        let pixels = color.repeat(64);
        let image = image::RgbaImage::from_raw(8, 8, pixels).expect("an image");
        image.save(folder.path().join(name)).expect("it is written");
    }
    for (turn, wanted) in [(1.5, 200.0 / 255.0), (-1.5, 10.0 / 255.0)] {
        let mut pair = showing(
            &json!([{"id": "pair", "kind": "litsphere_pair",
                "values": {"convex": "bulging.png", "concave": "hollow.png", "slope": 4.0}}]),
            &json!([{"from": "pair", "to": "output.color"}]),
        );
        pair.folder = folder.path().to_owned();
        let got = drawn(vec![(pair, plane(move |x, y| [turn * x, turn * y, 1.0]))]);
        let middle =
            got[(SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) as usize].expect("it fills the picture");
        assert!((middle - wanted).abs() < 5e-3, "{middle} in place of {wanted}");
    }
}
