//! Texture reads against filters written by hand.

use super::super::{
    AddressMode, Bindings, Filter, Sampler, SamplerCompare, Texture, TextureDimension, TextureLevel,
};
use super::lanes::{bind, stage};
use super::*;

/// Content of a texel of a 2D texture in these tests: its place and its level.
fn texel(x: u32, y: u32, level: u32) -> [f32; 4] {
    [(x * x + 3 * y) as f32, (x * y) as f32, level as f32, 1.0]
}

fn flat(width: u32, height: u32, levels: u32) -> Texture {
    let level = |index: u32| {
        let (w, h) = ((width >> index).max(1), (height >> index).max(1));
        let texels = (0..w * h).map(|i| texel(i % w, i / w, index)).collect();
        TextureLevel::f32([w, h, 1], texels)
    };
    Texture::new(TextureDimension::D2, (0..levels).map(level).collect()).unwrap()
}

/// Runs `f` of the source with texture and sampler at bindings 0 and 1, for one quad.
fn quad(
    declaration: &str,
    body: &str,
    texture: &Texture,
    sampler: Sampler,
    places: [Value; 4],
) -> Vec<Value> {
    let kind = if sampler.compare.is_some() { "sampler_comparison" } else { "sampler" };
    let source = format!(
        "@group(0) @binding(0) var t: {declaration}; @group(0) @binding(1) var s: {kind};
         @group(0) @binding(2) var<uniform> none: vec4f;
         @fragment fn f({body} + none; }}"
    );
    let program = stage(&source, "f");
    let mut bindings = Bindings::new();
    bindings.texture(0, 0, texture.clone()).sampler(0, 1, sampler).buffer(0, 2, [0.0; 4].into());
    let bound = bind(&program, &bindings, Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    places.into_iter().enumerate().for_each(|(lane, place)| lanes.set(lane, &[place]).unwrap());
    lanes.run(4).unwrap();
    (0..4).map(|lane| lanes.get(lane)).collect()
}

/// Result of one read at level 0.
fn at<const N: usize>(
    declaration: &str,
    read: &str,
    texture: &Texture,
    sampler: Sampler,
    place: [f64; N],
) -> [f64; 4] {
    let body = format!("@location(0) p: vec{N}f) -> @location(0) vec4f {{ return {read}");
    let values = quad(declaration, &body, texture, sampler, std::array::from_fn(|_| place.into()));
    values[0].as_vec().unwrap()
}

const LEVEL_0: &str = "textureSampleLevel(t, s, p, 0.0)";

/// Index that an address mode leads to, found by walking there.
fn walk(address: AddressMode, index: i64, size: i64) -> u32 {
    let mut at = 0;
    let mut step = 1;
    for _ in 0..index.abs() {
        if index < 0 && address == AddressMode::ClampToEdge {
            break;
        }
        let direction = if index < 0 { -step } else { step };
        let next = at + direction;
        if (0..size).contains(&next) {
            at = next;
        } else {
            match address {
                AddressMode::ClampToEdge => {}
                AddressMode::Repeat => at = if next < 0 { size - 1 } else { 0 },
                // The walk meets the edge twice: once on the way there and once on the way back.
                AddressMode::MirrorRepeat => step = -step,
            }
        }
    }
    at as u32
}

#[test]
fn linear_filters_weigh_four_texels() {
    let texture = flat(5, 3, 1);
    for address in [AddressMode::ClampToEdge, AddressMode::Repeat, AddressMode::MirrorRepeat] {
        for (u, v) in [(0.37, 0.61), (0.02, 0.98), (-0.7, 1.4), (2.3, -1.9), (0.1, 0.5), (1.0, 0.0)]
        {
            let sampler = Sampler::new(address, Filter::Linear);
            let actual = at("texture_2d<f32>", LEVEL_0, &texture, sampler, [u, v]);
            let (x, y) = (u * 5.0 - 0.5, v * 3.0 - 0.5);
            let (x0, y0) = (x.floor(), y.floor());
            let (fx, fy) = (x - x0, y - y0);
            let read = |dx: i64, dy: i64| {
                let (x, y) = (walk(address, x0 as i64 + dx, 5), walk(address, y0 as i64 + dy, 3));
                f64::from(texel(x, y, 0)[0])
            };
            let top = read(0, 0) + fx * (read(1, 0) - read(0, 0));
            let bottom = read(0, 1) + fx * (read(1, 1) - read(0, 1));
            let expected = top + fy * (bottom - top);
            assert!(
                (actual[0] - expected).abs() < 1e-12,
                "{address:?} ({u}, {v}): {} is not {expected}",
                actual[0]
            );
        }
    }
}

#[test]
fn nearest_filters_take_the_texel_under_the_place() {
    let texture = flat(4, 4, 1);
    for address in [AddressMode::ClampToEdge, AddressMode::Repeat, AddressMode::MirrorRepeat] {
        for i in -9..13 {
            let place = [(f64::from(i) + 0.75) / 4.0, 0.3];
            let actual = at(
                "texture_2d<f32>",
                LEVEL_0,
                &texture,
                Sampler::new(address, Filter::Nearest),
                place,
            );
            assert_eq!(
                actual,
                texel(walk(address, i.into(), 4), 1, 0).map(f64::from),
                "{address:?} {i}"
            );
        }
    }
}

#[test]
fn the_footprint_chooses_the_level() {
    let texture = flat(64, 64, 7);
    // Neighbors k texels apart see level log2(k).
    let level = |k: f64, bias: &str, mip: Filter| {
        let sampler = Sampler { mip, lod_max: 5.5, ..Sampler::default() };
        let places = [[0, 0], [1, 0], [0, 1], [1, 1]]
            .map(|[x, y]| [f64::from(x) * k / 64.0, f64::from(y) / 640.0].into());
        let body =
            format!("@location(0) p: vec2f) -> @location(0) vec4f {{ return textureSample{bias}");
        quad("texture_2d<f32>", &body, &texture, sampler, places)[0].as_vec::<4>().unwrap()[2]
    };
    for (k, expected) in [
        (0.25, 0.0),
        (1.0, 0.0),
        (2.0, 1.0),
        (3.0, 3.0_f64.log2()),
        (12.0, 12.0_f64.log2()),
        (1e6, 5.5),
    ] {
        let actual = level(k, "(t, s, p)", Filter::Linear);
        assert!((actual - expected).abs() < 1e-12, "{k}: {actual} is not {expected}");
        let nearest = (expected + 0.5).ceil() - 1.0;
        assert_eq!(level(k, "(t, s, p)", Filter::Nearest), nearest.max(0.0));
    }
    assert!((level(4.0, "Bias(t, s, p, 0.75)", Filter::Linear) - 2.75).abs() < 1e-12);
    assert_eq!(level(4.0, "Level(t, s, p, 3.25)", Filter::Linear), 3.25);
    assert_eq!(level(4.0, "Level(t, s, p, 99.0)", Filter::Linear), 5.5);
    // The gradients are 8 texels along one axis, 3 and 4 along the other.
    let grad =
        level(4.0, "Grad(t, s, p, vec2f(0.125, 0.0), vec2f(0.046875, 0.0625))", Filter::Linear);
    assert!((grad - 3.0).abs() < 1e-12, "{grad}");
}

#[test]
fn magnified_and_minified_texels_have_filters_of_their_own() {
    let texture = flat(4, 4, 2);
    let sampler = Sampler { mag: Filter::Linear, ..Sampler::default() };
    let place = [0.5, 0.125];
    let read = |level: &str| {
        at(
            "texture_2d<f32>",
            &format!("textureSampleLevel(t, s, p, {level})"),
            &texture,
            sampler,
            place,
        )
    };
    assert_eq!(read("0.0")[0], (1.0 + 4.0) / 2.0);
    assert_eq!(read("0.25")[0], 4.0);
}

#[test]
fn offsets_layers_and_clamping() {
    let mut texels = Vec::new();
    for layer in 0..3 {
        texels.extend((0..16).map(|i| [f64::from(i % 4), f64::from(i / 4), f64::from(layer), 0.1]));
    }
    let texture =
        Texture::new(TextureDimension::D2, vec![TextureLevel::f64([4, 4, 3], texels)]).unwrap();
    let sampler = Sampler::new(AddressMode::Repeat, Filter::Nearest);
    let read = |read: &str| at("texture_2d_array<f32>", read, &texture, sampler, [0.9, 0.1]);
    assert_eq!(read("textureSampleLevel(t, s, p, 1, 0.0)"), [3.0, 0.0, 1.0, 0.1]);
    assert_eq!(read("textureSampleLevel(t, s, p, 7, 0.0, vec2i(2, -1))"), [1.0, 3.0, 2.0, 0.1]);
    assert_eq!(read("textureSampleLevel(t, s, p, -7, 0.0)")[2], 0.0);
    assert_eq!(
        read(
            "vec4f(vec2f(textureDimensions(t)), f32(textureNumLayers(t)), f32(textureNumLevels(t)))"
        ),
        [4.0, 4.0, 3.0, 1.0]
    );
    let flat = flat(4, 4, 1);
    let linear = Sampler::new(AddressMode::Repeat, Filter::Linear);
    let clamped =
        at("texture_2d<f32>", "textureSampleBaseClampToEdge(t, s, p)", &flat, linear, [1.7, 0.375]);
    assert_eq!(clamped[0], f64::from(texel(3, 1, 0)[0]));
}

#[test]
fn loads_take_one_texel_and_nothing_outside() {
    let texture = flat(8, 4, 2);
    let read = |place: [f64; 2], level: i32| {
        let load = format!("textureLoad(t, vec2i(p), {level})");
        at("texture_2d<f32>", &load, &texture, Sampler::default(), place)
    };
    assert_eq!(read([5.0, 2.0], 0), texel(5, 2, 0).map(f64::from));
    assert_eq!(read([3.0, 1.0], 1), texel(3, 1, 1).map(f64::from));
    for (place, level) in [
        ([8.0, 0.0], 0),
        ([-1.0, 0.0], 0),
        ([0.0, 4.0], 0),
        ([4.0, 0.0], 1),
        ([0.0, 0.0], 2),
        ([0.0, 0.0], -1),
    ] {
        assert_eq!(read(place, level), [0.0; 4]);
    }
    let sizes = "vec4f(vec2f(textureDimensions(t, 1)), vec2f(textureDimensions(t)))";
    assert_eq!(
        at("texture_2d<f32>", sizes, &texture, Sampler::default(), [0.0, 0.0]),
        [4.0, 2.0, 8.0, 4.0]
    );
    let integers = Texture::new(
        TextureDimension::D2,
        vec![TextureLevel::f64([1, 1, 1], vec![[4_294_967_295.0, 2.0, 0.0, 1.0]])],
    );
    let load = "vec4f(textureLoad(t, vec2i(p), 0) >> vec4u(1u))";
    let halved = at("texture_2d<u32>", load, &integers.unwrap(), Sampler::default(), [0.0, 0.0]);
    assert_eq!(halved, [2_147_483_647.0, 1.0, 0.0, 0.0]);
}

#[test]
fn gathers_give_the_four_texels_of_a_linear_filter() {
    let texture = flat(4, 4, 1);
    let actual = at(
        "texture_2d<f32>",
        "textureGather(0, t, s, p)",
        &texture,
        Sampler::default(),
        [0.5, 0.5],
    );
    let expected = [(1, 2), (2, 2), (2, 1), (1, 1)].map(|(x, y)| f64::from(texel(x, y, 0)[0]));
    assert_eq!(actual, expected);
}

#[test]
fn depths_are_compared_before_they_are_filtered() {
    let texels = vec![[0.2, 0.0, 0.0, 1.0], [0.6, 0.0, 0.0, 1.0]];
    let texture = Texture::flat([2, 1], texels).unwrap();
    let read = |compare, read: &str, u| {
        let sampler = Sampler {
            compare: Some(compare),
            ..Sampler::new(AddressMode::ClampToEdge, Filter::Linear)
        };
        at("texture_depth_2d", &format!("vec4f({read})"), &texture, sampler, [u, 0.5])[0]
    };
    let less = "textureSampleCompareLevel(t, s, p, 0.5)";
    for (u, lit) in [(0.0, 0.0), (0.25, 0.0), (0.4, 0.3), (0.5, 0.5), (0.75, 1.0)] {
        let (actual, dark) =
            (read(SamplerCompare::Less, less, u), read(SamplerCompare::GreaterEqual, less, u));
        assert!(
            (actual - lit).abs() < 1e-12 && (dark - (1.0 - lit)).abs() < 1e-12,
            "{u}: {actual}, {dark}"
        );
    }
    assert_eq!(read(SamplerCompare::Less, "textureGatherCompare(t, s, p, 0.5)", 0.5), 0.0);
    let depth = f64::from(0.6_f32);
    let plain = at(
        "texture_depth_2d",
        "vec4f(textureSampleLevel(t, s, p, 0))",
        &texture,
        Sampler::default(),
        [0.9, 0.5],
    );
    assert_eq!(plain, [depth; 4]);
}

#[test]
fn volumes_weigh_eight_texels() {
    // A linear filter reproduces a function that is linear along each axis.
    let value = |x: f64, y: f64, z: f64| 1.0 + 2.0 * x - y + 4.0 * z + x * y * z;
    let texels = (0..60)
        .map(|i| [value(f64::from(i % 3), f64::from(i / 3 % 4), f64::from(i / 12)), 0.0, 0.0, 0.0]);
    let texture =
        Texture::new(TextureDimension::D3, vec![TextureLevel::f64([3, 4, 5], texels.collect())])
            .unwrap();
    let sampler = Sampler::new(AddressMode::ClampToEdge, Filter::Linear);
    let actual = at("texture_3d<f32>", LEVEL_0, &texture, sampler, [0.4, 0.6, 0.45])[0];
    let expected = value(0.4 * 3.0 - 0.5, 0.6 * 4.0 - 0.5, 0.45 * 5.0 - 0.5);
    assert!((actual - expected).abs() < 1e-12, "{actual} is not {expected}");
    let load =
        at("texture_3d<f32>", "textureLoad(t, vec3i(p), 0)", &texture, sampler, [2.0, 3.0, 4.0]);
    assert_eq!(load[0], value(2.0, 3.0, 4.0));
}

#[test]
fn faces_of_cubes_join_without_a_seam() {
    // Every texel holds the direction to it, so that a filter gives nearly the direction that is
    // asked for.
    const SIZE: u32 = 16;
    let direction = |face: u32, x: u32, y: u32| {
        let [s, t] = [x, y].map(|i| f64::from(2 * i + 1) / f64::from(SIZE) - 1.0);
        let [x, y, z] = match face {
            0 => [1.0, -t, -s],
            1 => [-1.0, -t, s],
            2 => [s, 1.0, t],
            3 => [s, -1.0, -t],
            4 => [s, -t, 1.0],
            _ => [-s, -t, -1.0],
        };
        [x, y, z, f64::from(face)]
    };
    let texels = (0..6 * SIZE * SIZE)
        .map(|i| direction(i / (SIZE * SIZE), i % SIZE, i / SIZE % SIZE))
        .collect();
    let texture =
        Texture::new(TextureDimension::Cube, vec![TextureLevel::f64([SIZE, SIZE, 6], texels)])
            .unwrap();
    let read = |filter, place| {
        at(
            "texture_cube<f32>",
            LEVEL_0,
            &texture,
            Sampler::new(AddressMode::ClampToEdge, filter),
            place,
        )
    };
    let faces = [
        [2.0, 0.1, 0.1],
        [-2.0, 0.1, 0.1],
        [0.1, 2.0, 0.1],
        [0.1, -2.0, 0.1],
        [0.1, 0.1, 2.0],
        [0.1, 0.1, -2.0],
    ];
    for (face, place) in faces.into_iter().enumerate() {
        assert_eq!(read(Filter::Nearest, place)[3], face as f64);
    }
    let mut state = 1_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let edges = [
        [1.0, 0.999, 0.3],
        [0.2, -1.0, 0.998],
        [-1.0, 0.5, -0.999],
        [1.0, 0.999, 0.999],
        [-1.0, -0.999, 0.998],
    ];
    for place in edges.into_iter().chain((0..40).map(|_| [next(), next(), next()])) {
        let largest = place.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let [x, y, z, _] = read(Filter::Linear, place);
        for (actual, expected) in [x, y, z].into_iter().zip(place) {
            assert!(
                (actual - expected / largest).abs() < 1.0 / f64::from(SIZE),
                "{place:?} gives {:?}",
                [x, y, z]
            );
        }
    }
    // A direction exactly on the edge between +x and +z gets half of each.
    let [x, _, z, face] = read(Filter::Linear, [1.0, 1.0 / 16.0, 1.0]);
    assert!((x - z).abs() < 1e-12 && (face - 2.0).abs() < 1e-12, "{x} {z} {face}");
}

#[test]
fn cubes_have_levels_by_their_footprint() {
    let level = |index: u32| {
        let size = 32 >> index;
        TextureLevel::f32(
            [size, size, 6],
            vec![[index as f32, 0.0, 0.0, 0.0]; (6 * size * size) as usize],
        )
    };
    let texture = Texture::new(TextureDimension::Cube, (0..6).map(level).collect()).unwrap();
    let sampler = Sampler { mip: Filter::Linear, ..Sampler::default() };
    // Two texels on the face z = 1 are 2 * 2 / 32 apart; the length of the direction does not
    // matter.
    let step = 2.0 * 2.0 / 32.0;
    let places = [[0.0, 0.0], [step, 0.0], [0.0, step], [step, step]]
        .map(|[x, y]| [3.0 * x, 3.0 * y, 3.0].into());
    let body = "@location(0) p: vec3f) -> @location(0) vec4f { return textureSample(t, s, p)";
    let actual =
        quad("texture_cube<f32>", body, &texture, sampler, places)[0].as_vec::<4>().unwrap()[0];
    assert!((actual - 1.0).abs() < 1e-12, "{actual}");
}

#[test]
fn places_that_are_no_numbers_read_some_texel() {
    for filter in [Filter::Nearest, Filter::Linear] {
        for address in [AddressMode::ClampToEdge, AddressMode::Repeat, AddressMode::MirrorRepeat] {
            for place in [[f64::NAN, 0.5], [f64::INFINITY, f64::NEG_INFINITY], [1e300, -1e300]] {
                let read = at(
                    "texture_2d<f32>",
                    LEVEL_0,
                    &flat(3, 3, 1),
                    Sampler::new(address, filter),
                    place,
                );
                assert!(read.iter().all(|x| x.is_finite()), "{place:?} gives {read:?}");
            }
        }
        let cube = Texture::new(
            TextureDimension::Cube,
            vec![TextureLevel::f32([2, 2, 6], vec![[1.0; 4]; 24])],
        )
        .unwrap();
        for place in [[f64::NAN; 3], [0.0; 3], [f64::INFINITY; 3]] {
            let read = at(
                "texture_cube<f32>",
                LEVEL_0,
                &cube,
                Sampler::new(AddressMode::Repeat, filter),
                place,
            );
            assert_eq!(read, [1.0; 4]);
        }
    }
}

#[test]
fn textures_are_functions_arguments() {
    let source = "
        @group(0) @binding(0) var a: texture_2d<f32>;
        @group(0) @binding(1) var b: texture_2d<f32>;
        @group(0) @binding(2) var s: sampler;
        fn read(t: texture_2d<f32>, r: sampler, p: vec2f) -> f32 \
        { return textureSampleLevel(t, r, p, 0.0).x; }
        fn f(p: vec2f) -> f32 {
            if p.x < 0.5 { return read(a, s, p); }
            return read(b, s, p) + 100.0 * read(a, s, p);
        }";
    let one = |x: f32| Texture::flat([1, 1], vec![[x; 4]]).unwrap();
    let mut bindings = Bindings::new();
    bindings.texture(0, 0, one(3.0)).texture(0, 1, one(5.0)).sampler(0, 2, Sampler::default());
    let program = stage(source, "f");
    let bound = bind(&program, &bindings, Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    for lane in 0..8 {
        lanes.set(lane, &[[(lane % 2) as f64, 0.0].into()]).unwrap();
    }
    lanes.run(8).unwrap();
    for lane in 0..8 {
        assert_eq!(lanes.get(lane), [3.0, 305.0][lane % 2].into());
    }
}

#[test]
fn textures_of_a_wrong_size_are_refused() {
    let level = |size: [u32; 3], count: usize| TextureLevel::f32(size, vec![[0.0; 4]; count]);
    let refused = |dimension, levels| Texture::new(dimension, levels).map(|_| ()).unwrap_err().code;
    for (dimension, levels) in [
        (TextureDimension::D2, vec![]),
        (TextureDimension::D2, vec![level([2, 2, 1], 3)]),
        (TextureDimension::D2, vec![level([0, 2, 1], 0)]),
        (TextureDimension::D2, vec![level([4, 4, 1], 16), level([2, 1, 1], 2)]),
        (TextureDimension::D2, vec![level([u32::MAX, u32::MAX, u32::MAX], 1)]),
        (TextureDimension::Cube, vec![level([2, 2, 5], 20)]),
        (TextureDimension::D1, vec![level([2, 2, 1], 4)]),
    ] {
        assert_eq!(refused(dimension, levels), "interp-texture");
    }
}
