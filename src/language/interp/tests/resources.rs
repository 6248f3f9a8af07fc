//! Buffers, and errors of their bindings.

use super::super::{Bindings, LANES, Sampler, SamplerCompare, Texture};
use super::lanes::{bind, stage};
use super::*;

#[test]
fn uniforms_are_read_whole_in_parts_and_by_index() {
    let source = "
        struct Light { direction: vec3f, power: f32 }
        struct Look { m: mat3x3f, lights: array<Light, 3>, count: u32 }
        @group(1) @binding(4) var<uniform> look: Look;
        fn power(light: Light) -> f32 { return light.power; }
        fn f(i: i32) -> f32 {
            let first = look.lights[0];
            return power(look.lights[i]) + first.direction.y + look.m[i][1] + \
            look.lights[i].direction[i] + f32(look.count);
        }";
    let light = |x: f64| Value::Struct(vec![[x, x + 0.1, x + 0.2].into(), (x * 100.0).into()]);
    let matrix = Value::matrix(&[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
    let lights = Value::Array(vec![light(10.0), light(20.0), light(30.0)]);
    let mut bindings = Bindings::new();
    bindings.buffer(1, 4, Value::Struct(vec![matrix, lights, 1000_u32.into()]));
    let program = stage(source, "f");
    assert_eq!(program.resources().len(), 1);
    assert_eq!(program.resources()[0].name, "look");
    let bound = bind(&program, &bindings, Precision::F64);
    let expected = |i: usize| {
        let x = 10.0 * (i + 1) as f64;
        x * 100.0 + (10.0 + 0.1) + [2.0, 5.0, 8.0][i] + [x, x + 0.1, x + 0.2][i] + 1000.0
    };
    let mut lanes = bound.lanes().unwrap();
    for lane in 0..LANES {
        lanes.set(lane, &[Value::I32(lane as i32 % 3)]).unwrap();
    }
    lanes.run(LANES).unwrap();
    for i in 0..3 {
        assert_eq!(lanes.get(i), expected(i).into());
        assert_eq!(bound.machine().call(&[Value::I32(i as i32)]).unwrap(), expected(i).into());
    }
    // An index beyond the end gives the last element, as everywhere.
    assert_eq!(bound.machine().call(&[Value::I32(99)]).unwrap(), expected(2).into());
    assert_eq!(program.call(&[Value::I32(0)], Precision::F64).unwrap_err().code, "interp-unbound");
}

#[test]
fn buffers_may_end_in_arrays_of_any_length() {
    let source = "
        struct Keys { scale: f32, weights: array<vec2f> }
        @group(0) @binding(0) var<storage> keys: Keys;
        @group(0) @binding(1) var<storage, read> plain: array<u32>;
        fn f(i: u32) -> vec4f {
            let n = arrayLength(&keys.weights);
            return vec4f(keys.weights[i] * keys.scale, f32(n), f32(plain[2] + plain[i]));
        }";
    let mut bindings = Bindings::new();
    let weights = Value::Array((0..5).map(|i| [f64::from(i), 0.5].into()).collect());
    bindings.buffer(0, 0, Value::Struct(vec![3.0.into(), weights]));
    bindings.buffer(0, 1, Value::Array(vec![7_u32.into(), 9_u32.into()]));
    let program = stage(source, "f");
    let bound = bind(&program, &bindings, Precision::F64);
    let mut machine = bound.machine();
    // The third of two elements is the last.
    assert_eq!(machine.call(&[0_u32.into()]).unwrap(), [0.0, 1.5, 5.0, 16.0].into());
    assert_eq!(machine.call(&[4_u32.into()]).unwrap(), [12.0, 1.5, 5.0, 18.0].into());
    assert_eq!(machine.call(&[u32::MAX.into()]).unwrap(), [12.0, 1.5, 5.0, 18.0].into());
    bindings.buffer(0, 1, Value::Array(Vec::new()));
    assert_eq!(program.bind(&bindings, Precision::F64).unwrap_err()[0].code, "interp-binding");
}

#[test]
fn uniforms_are_f64_or_rounded() {
    let source = "@group(0) @binding(0) var<uniform> u: vec2f; fn f(i: i32) -> vec2f \
                  { return vec2f(u.x, u[i]); }";
    let mut bindings = Bindings::new();
    bindings.buffer(0, 0, [0.1, 0.2].into());
    let program = stage(source, "f");
    let value =
        |precision| bind(&program, &bindings, precision).machine().call(&[1.into()]).unwrap();
    assert_eq!(value(Precision::F64), [0.1, 0.2].into());
    assert_eq!(value(Precision::F32), [0.1_f32, 0.2_f32].map(f64::from).into());
}

#[test]
fn everything_that_does_not_fit_is_told() {
    let source = "
        @group(0) @binding(0) var<uniform> u: vec4f;
        @group(0) @binding(1) var t: texture_2d<f32>;
        @group(0) @binding(2) var s: sampler;
        @group(0) @binding(3) var d: texture_depth_cube;
        @group(0) @binding(4) var c: sampler_comparison;
        @fragment fn f() -> @location(0) vec4f {
            return u + textureSampleLevel(t, s, u.xy, 0.0) + textureSampleCompareLevel(d, c, \
            u.xyz, 0.5);
        }";
    let program = stage(source, "f");
    let problems = program.bind(&Bindings::new(), Precision::F64).unwrap_err();
    assert_eq!(problems.len(), 5);
    assert!(problems.iter().all(|problem| problem.code == "interp-binding"));
    assert_eq!(
        problems[0].message,
        "`u` (@group(0) @binding(0)) is a buffer of vec4<f32>, and nothing is bound"
    );
    let flat = Texture::flat([1, 1], vec![[0.0; 4]]).unwrap();
    let comparison = Sampler { compare: Some(SamplerCompare::Less), ..Sampler::default() };
    let mut bindings = Bindings::new();
    bindings
        .buffer(0, 0, [1.0, 2.0, 3.0].into())
        .sampler(0, 1, comparison)
        .sampler(0, 2, comparison);
    bindings.texture(0, 3, flat).sampler(0, 4, Sampler::default());
    let problems = program.bind(&bindings, Precision::F64).unwrap_err();
    let told: Vec<&str> = problems.iter().map(|problem| problem.message.as_str()).collect();
    assert_eq!(
        told,
        [
            "`u` (@group(0) @binding(0)) is a buffer of vec4<f32>, but vec3<f32> was bound",
            "`t` (@group(0) @binding(1)) is a 2D texture, but a comparison sampler was bound",
            "`s` (@group(0) @binding(2)) is a sampler, but a comparison sampler was bound",
            "`d` (@group(0) @binding(3)) is a cube texture, but a 2D texture was bound",
            "`c` (@group(0) @binding(4)) is a comparison sampler, but a sampler was bound",
        ]
    );
}

#[test]
fn what_only_compute_has_is_refused_in_stages_too() {
    let cases = [
        (
            "@group(0) @binding(0) var<storage, read_write> b: array<f32>;
             @fragment fn f() -> @location(0) f32 { b[0] = 1.0; return b[1]; }",
            "the global variable `b` is a storage buffer that can be written",
        ),
        (
            "@group(0) @binding(0) var t: texture_storage_2d<rgba8unorm, write>;
             @fragment fn f() -> @location(0) f32 \
             { textureStore(t, vec2i(0), vec4f(1.0)); return 1.0; }",
            "the global variable `t` is a storage texture",
        ),
        (
            "@group(0) @binding(0) var t: texture_multisampled_2d<f32>;
             @fragment fn f() -> @location(0) vec4f { return textureLoad(t, vec2i(0), 1); }",
            "the global variable `t` is a multisampled texture",
        ),
        (
            "var<workgroup> w: array<f32, 4>; @compute @workgroup_size(1) fn f() { w[1] = 1.0; }",
            "the global variable `w` is workgroup memory",
        ),
        (
            "@compute @workgroup_size(1) fn f() { workgroupBarrier(); }",
            "`f` uses a barrier (ControlBarrier)",
        ),
    ];
    for (source, message) in cases {
        let literals = Literals::of(source);
        let error = Program::compile(&module(source), "f", FunctionOptions::stage(&literals))
            .expect_err("refused");
        assert_eq!(error.code, "interp-unsupported");
        assert!(error.message.starts_with(message), "{error}");
        assert!(error.place.wgsl.is_some(), "{error}");
    }
}
