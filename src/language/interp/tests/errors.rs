//! Tests of refused programs and their errors.

use super::super::Derivatives;
use super::*;

fn refused(source: &str) -> Diagnostic {
    compile(source).map(|program| program.name().to_owned()).expect_err("refused")
}

#[test]
fn endless_loops_are_given_up() {
    let program =
        compile("fn f(x: i32) -> i32 { var i = x; while (i >= 0) { i ^= 1; } return i; }").unwrap();
    let mut machine = program.machine(Precision::F64);
    assert_eq!(machine.call(&[4.into()]).unwrap_err().code, "interp-endless");
    assert_eq!(machine.call(&[(-4).into()]).unwrap(), (-4).into(), "the machine can go on");
}

#[test]
fn calls_without_loops_are_counted_too() {
    let mut source = String::from("fn level0(x: f32) -> f32 { return x + 1.0; }\n");
    for i in 1..40 {
        source +=
            &format!("fn level{i}(x: f32) -> f32 {{ return level{0}(level{0}(x)); }}\n", i - 1);
    }
    let program =
        Program::compile(&module(&source), "level39", FunctionOptions::default()).unwrap();
    assert_eq!(program.call(&[0.0.into()], Precision::F64).unwrap_err().code, "interp-endless");
    let program =
        Program::compile(&module(&source), "level10", FunctionOptions::default()).unwrap();
    assert_eq!(program.call(&[0.0.into()], Precision::F64).unwrap(), 1024.0.into());
}

#[test]
fn copies_count_as_many_steps() {
    let source = "
        fn f(n: i32) -> f32 {
            var a: array<f32, 100000>;
            for (var i = 0; i < n; i++) { var b = a; a = b; }
            return a[0];
        }";
    let program = compile(source).unwrap();
    assert_eq!(program.call(&[2.into()], Precision::F64).unwrap(), 0.0.into());
    assert_eq!(program.call(&[1000.into()], Precision::F64).unwrap_err().code, "interp-endless");
}

#[test]
fn unknown_functions_are_suggested() {
    let error = Program::compile(
        &module("fn profile_angle() -> f32 { return 1.0; }"),
        "profile_angel",
        FunctionOptions::default(),
    )
    .expect_err("no such function");
    assert_eq!(error.code, "interp-unknown-function");
    assert_eq!(error.hints, ["did you mean `profile_angle`?"]);
}

#[test]
fn arguments_are_checked() {
    let program =
        compile("struct S { x: f32 } fn f(a: vec2<f32>, s: S) -> f32 { return a.x + s.x; }")
            .unwrap();
    let s = || Value::Struct(vec![1.0.into()]);
    let error = |arguments: &[Value]| {
        let error = program.call(arguments, Precision::F64).expect_err("wrong arguments");
        assert_eq!(error.code, "interp-argument");
        error.message
    };
    assert_eq!(error(&[]), "`f` takes 2 arguments, but 0 were given");
    assert_eq!(
        error(&[[1.0, 2.0, 3.0].into(), s()]),
        "argument `a` of `f` is vec2<f32>, but (1, 2, 3) (vec3<f32>) was given"
    );
    assert_eq!(
        error(&[Value::ivec(&[1, 2]), s()]),
        "argument `a` of `f` is vec2<f32>, but (1, 2) (vec2<i32>) was given"
    );
    error(&[[1.0, 2.0].into(), 1.0.into()]);
    error(&[[1.0, 2.0].into(), Value::Struct(vec![1.into()])]);
    error(&[[1.0, 2.0].into(), Value::Struct(vec![])]);
    error(&[Value::Vector(vec![]), s()]);
    error(&[Value::Matrix { columns: 0, components: vec![] }, s()]);
    assert_eq!(program.call(&[[1.0, 2.0].into(), s()], Precision::F64).unwrap(), 2.0.into());
}

#[test]
fn derivatives_are_refused_or_zero() {
    let source = "fn g(x: f32) -> f32 { return fwidth(x) + dpdx(x); } fn f(x: vec2<f32>) -> \
                  vec2<f32> { return dpdyFine(x) + g(x.x); }";
    let error = refused(source);
    assert_eq!(error.code, "interp-unsupported");
    assert_eq!(
        error.message,
        "`g` uses a derivative (Derivative), which the interpreter cannot run"
    );
    assert_eq!(&source[error.place.wgsl.clone().unwrap()], "fwidth");
    assert_eq!(error.hints.len(), 1);
    let options = FunctionOptions { derivatives: Derivatives::Zero, ..FunctionOptions::default() };
    let program = Program::compile(&module(source), "f", options).unwrap();
    assert_eq!(program.call(&[[1.0, 2.0].into()], Precision::F64).unwrap(), [0.0, 0.0].into());
}

#[test]
fn what_only_a_gpu_has_is_refused() {
    let cases = [
        ("var<private> v: f32; fn f() -> f32 { return v; }", "GlobalVariable"),
        ("var<private> v: f32; fn f() -> f32 { v = 1.0; return 1.0; }", "GlobalVariable"),
        (
            "@group(0) @binding(0) var<uniform> u: vec4<f32>; fn f() -> f32 { return u.y; }",
            "the global variable `u` (GlobalVariable)",
        ),
        ("override o: f32 = 1.0; fn f() -> f32 { return o * 2.0; }", "the override `o` (Override)"),
        ("fn f(x: f32) -> f32 { if (x < 0.0) { discard; } return x; }", "Kill"),
        (
            "@group(0) @binding(0) var t: texture_2d<f32>; @group(0) @binding(1) var s: sampler;
             fn f(uv: vec2<f32>) -> vec4<f32> { return textureSampleLevel(t, s, uv, 0.0); }",
            "GlobalVariable",
        ),
    ];
    for (source, construct) in cases {
        let error = refused(source);
        assert_eq!(error.code, "interp-unsupported");
        assert!(error.message.contains(construct) && error.message.contains("`f`"), "{error}");
        assert!(error.place.wgsl.is_some(), "{error}");
    }
    let barrier = "@compute @workgroup_size(1) fn f() { workgroupBarrier(); }";
    assert_eq!(refused(barrier).message, "`f` returns nothing, so there is nothing to run it for");
    let called = "fn g() { workgroupBarrier(); } fn f() -> f32 { g(); return 1.0; }";
    assert_eq!(
        refused(called).message,
        "`g` uses a barrier (ControlBarrier), which the interpreter cannot run"
    );
}

#[test]
fn types_without_values_are_refused() {
    let error = refused("fn f(x: i64) -> i64 { return x; }");
    assert_eq!(error.code, "interp-unsupported");
    assert_eq!(
        error.message,
        "argument `x` of `f` is an integer not of 32 bits, which the interpreter cannot hold"
    );
    let error = refused("fn f(p: ptr<function, f32>) -> f32 { return *p; }");
    assert_eq!(error.code, "interp-unsupported");
}

#[test]
fn memory_is_bounded() {
    for source in [
        "fn f(i: i32) -> f32 { var a: array<f32, 100000000>; return a[i]; }",
        "fn f(i: i32) -> f32 { let a = array<array<f32, 1000>, 100000>(); return a[i][i]; }",
        "alias A = array<f32, 1000000>; fn f(i: i32) -> f32 \
         { var a: A; var b: A; var c: A; var d: A; var e: A; return e[i]; }",
    ] {
        assert_eq!(refused(source).code, "interp-too-big", "{source}");
    }
    let mut source = String::from("struct S0 { x: f32 }\n");
    for i in 1..100 {
        source += &format!("struct S{i} {{ x: S{} }}\n", i - 1);
    }
    assert_eq!(refused(&(source + "fn f(s: S99) -> i32 { return 1; }")).code, "interp-too-big");
}

#[test]
fn unused_functions_do_not_matter() {
    let source = "fn g(x: f32) -> f32 { return dpdx(x); } fn f(x: f32) -> f32 { return x; }";
    assert_eq!(run(source, &[1.0.into()]), 1.0.into());
}
