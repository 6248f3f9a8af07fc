//! f32 mode against f32 arithmetic.

use super::*;

fn single(expression: &str, arguments: &[f32]) -> f32 {
    let types = vec!["f32"; arguments.len()].join(";");
    let arguments: Vec<Value> = arguments.iter().map(|&x| f64::from(x).into()).collect();
    let value = run_in(Precision::F32, &source(&format!("{types} -> f32"), expression), &arguments);
    value.as_f64().unwrap() as f32
}

#[test]
fn every_step_is_rounded() {
    let (a, b, c) = (0.1_f32, 1.0e-8_f32, 3.3333_f32);
    assert_eq!(single("a + b - a", &[a, b]), a + b - a);
    assert_eq!(single("a * b + c", &[a, b, c]), a * b + c);
    assert_eq!(single("a * c * c / b", &[a, b, c]), a * c * c / b);
    assert_eq!(single("sqrt(a) * sqrt(a)", &[a]), a.sqrt() * a.sqrt());
    assert_eq!(single("fract(a)", &[-1e-9]), 1.0);
    assert_eq!(single("fma(a, b, c)", &[a, b, c]), a.mul_add(b, c));
    assert_eq!(single("mix(a, b, c)", &[a, b, c]), a * (1.0 - c) + b * c);
    assert_eq!(single("dot(vec3(a, b, c), vec3(c, a, a))", &[a, b, c]), a * c + b * a + c * a);
    assert_eq!(single("a % b", &[c, a]), c % a);
    assert_eq!(single("a * b", &[1e30, 1e30]), f32::INFINITY);
}

#[test]
fn elementary_functions_are_the_nearest_f32() {
    for x in [0.1_f32, 0.7, 1.3, 2.9] {
        assert_eq!(single("sin(a)", &[x]), f64::from(x).sin() as f32);
        assert_eq!(single("exp2(a)", &[x]), f64::from(x).exp2() as f32);
        assert_eq!(single("pow(a, b)", &[x, 2.7]), f64::from(x).powf(f64::from(2.7_f32)) as f32);
    }
}

#[test]
fn arguments_are_rounded() {
    let value = run_in(Precision::F32, &source("f32 -> f32", "a"), &[0.1.into()]);
    assert_eq!(value, f64::from(0.1_f32).into());
    let program = compile("fn f(m: mat2x2<f32>) -> vec2<f32> { return m[0]; }").unwrap();
    let m = Value::matrix(&[[0.1, 0.2], [0.3, 0.4]]);
    assert_eq!(
        program.call(&[m], Precision::F32).unwrap(),
        [0.1_f32, 0.2_f32].map(f64::from).into()
    );
}

#[test]
fn wide_constants_are_rounded() {
    let source =
        "const WIDE = array(0.1lf, 0.3lf); fn f(i: i32) -> f64 { return 0.1lf + WIDE[i]; }";
    assert_eq!(run(source, &[0.into()]), 0.2.into());
    assert_eq!(run_in(Precision::F32, source, &[0.into()]), f64::from(0.1_f32 + 0.1_f32).into());
    assert_eq!(run_in(Precision::F32, source, &[1.into()]), f64::from(0.1_f32 + 0.3_f32).into());
}

#[test]
fn sums_lose_what_f32_loses() {
    let source = "fn f(n: i32) -> f32 \
                  { var s = 0.0; for (var i = 1; i <= n; i++) { s += 1.0 / f32(i); } return s; }";
    let n = 100_000;
    let expected: f32 = (1..=n).fold(0.0, |s, i| s + 1.0 / i as f32);
    let expected_wide: f64 = (1..=n).fold(0.0, |s, i| s + 1.0 / f64::from(i));
    assert_eq!(run_in(Precision::F32, source, &[n.into()]), f64::from(expected).into());
    assert_eq!(run(source, &[n.into()]), expected_wide.into());
}

#[test]
fn halves_are_rounded_in_f32_and_floats_in_f64() {
    let source = "enable f16; fn f(a: f32, b: f32) -> f32 \
                  { let x = f16(a) * f16(b); return f32(x + 0.1h); }";
    let half = |x: f64| half::f16::from_f64(x).to_f64();
    let (a, b) = (1.2345, 0.777);
    let (a32, b32) = (f64::from(a as f32), f64::from(b as f32));
    let expected = half(half(half(a32) * half(b32)) + half(0.1));
    assert_eq!(run_in(Precision::F32, source, &[a.into(), b.into()]), expected.into());
    assert_eq!(run(source, &[a.into(), b.into()]), (a * b + half(0.1)).into());
}

#[test]
fn literals_are_read_again_at_f64_and_stay_nagas_in_f32() {
    let source =
        "const PLACE: f32 = 4.10000001; fn f(x: f32) -> f32 { return x * 0.1 + PLACE / 3.0; }";
    let literals = Literals::of(source);
    let options = FunctionOptions { literals: Some(&literals), ..FunctionOptions::default() };
    let program = Program::compile(&module(source), "f", options).unwrap();
    assert_eq!(
        program.call(&[0.7.into()], Precision::F64).unwrap(),
        (0.7 * 0.1 + 4.10000001 / 3.0).into()
    );
    let expected = 0.7_f32 * 0.1 + 4.1_f32 / 3.0;
    assert_eq!(program.call(&[0.7.into()], Precision::F32).unwrap(), f64::from(expected).into());
    assert_eq!(
        compile(source).unwrap().call(&[0.0.into()], Precision::F64).unwrap(),
        f64::from(4.1_f32 / 3.0).into()
    );
}
