//! Functions of floats.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6, LN_2, PI, SQRT_2};

use super::*;

#[test]
fn known_values() {
    let third = 1.0 / 3.0;
    let cases: &[(&str, f64, f64)] = &[
        ("abs(a)", -2.5, 2.5),
        ("sign(a)", -2.5, -1.0),
        ("sign(a)", 0.0, 0.0),
        ("saturate(a)", 1.5, 1.0),
        ("saturate(a)", -1.5, 0.0),
        ("saturate(a)", 0.25, 0.25),
        ("cos(a)", PI / 3.0, 0.5),
        ("sin(a)", FRAC_PI_6, 0.5),
        ("tan(a)", FRAC_PI_4, 1.0),
        ("acos(a)", -1.0, PI),
        ("asin(a)", 0.5, FRAC_PI_6),
        ("atan(a)", 1.0, FRAC_PI_4),
        ("cosh(a)", LN_2, 1.25),
        ("sinh(a)", LN_2, 0.75),
        ("tanh(a)", LN_2, 0.6),
        ("acosh(a)", 1.25, LN_2),
        ("asinh(a)", 0.75, LN_2),
        ("atanh(a)", 0.6, LN_2),
        ("radians(a)", 180.0, PI),
        ("degrees(a)", PI, 180.0),
        ("ceil(a)", -1.5, -1.0),
        ("floor(a)", -1.5, -2.0),
        ("trunc(a)", -1.5, -1.0),
        ("fract(a)", -1.25, 0.75),
        ("round(a)", 0.5, 0.0),
        ("round(a)", 1.5, 2.0),
        ("round(a)", 2.5, 2.0),
        ("round(a)", -2.5, -2.0),
        ("exp(a)", LN_2, 2.0),
        ("exp2(a)", 0.5, SQRT_2),
        ("log(a)", 2.0, LN_2),
        ("log2(a)", 0.125, -3.0),
        ("sqrt(a)", 2.0, SQRT_2),
        ("inverseSqrt(a)", 4.0, 0.5),
        ("length(a)", -3.0, 3.0),
        ("-a", 3.0, -3.0),
        ("1.0 / a", 3.0, third),
    ];
    for &(expression, x, expected) in cases {
        let actual = float(expression, &[x]);
        assert!(
            (actual - expected).abs() <= 4e-16 * expected.abs().max(1.0),
            "{expression} at {x} is {actual}"
        );
    }
}

#[test]
fn of_two_and_three() {
    let cases: &[(&str, &[f64], f64)] = &[
        ("a + b", &[0.1, 0.2], 0.1 + 0.2),
        ("a - b", &[0.1, 0.2], -0.1),
        ("a * b", &[0.1, 0.2], 0.1 * 0.2),
        ("a / b", &[0.1, 0.2], 0.5),
        ("a % b", &[-5.5, 2.0], -1.5),
        ("a % b", &[5.5, -2.0], 1.5),
        ("min(a, b)", &[1.0, 2.0], 1.0),
        ("max(a, b)", &[1.0, 2.0], 2.0),
        ("step(a, b)", &[1.0, 0.999], 0.0),
        ("step(a, b)", &[1.0, 1.0], 1.0),
        ("atan2(a, b)", &[1.0, -1.0], 0.75 * PI),
        ("atan2(a, b)", &[-1.0, 0.0], -FRAC_PI_2),
        ("pow(a, b)", &[2.0, 0.5], SQRT_2),
        ("distance(a, b)", &[1.0, 4.0], 3.0),
        ("clamp(a, b, c)", &[5.0, 1.0, 2.0], 2.0),
        ("clamp(a, b, c)", &[0.0, 1.0, 2.0], 1.0),
        ("clamp(a, b, c)", &[1.25, 1.0, 2.0], 1.25),
        ("mix(a, b, c)", &[10.0, 20.0, 0.25], 12.5),
        ("fma(a, b, c)", &[2.0, 3.0, 4.0], 10.0),
        ("smoothstep(a, b, c)", &[1.0, 3.0, 1.5], 0.15625),
        ("smoothstep(a, b, c)", &[1.0, 3.0, 9.0], 1.0),
        ("smoothstep(a, b, c)", &[1.0, 3.0, 0.0], 0.0),
        ("smoothstep(a, b, c)", &[3.0, 1.0, 2.5], 0.15625),
    ];
    for &(expression, arguments, expected) in cases {
        let actual = float(expression, arguments);
        assert!(
            (actual - expected).abs() <= 4e-16 * expected.abs(),
            "{expression} at {arguments:?} is {actual}"
        );
    }
}

#[test]
fn a_fused_product_is_rounded_once() {
    let e = f64::EPSILON;
    // (1 + e)(1 - e) - 1 = -e^2, which the product alone loses.
    assert_eq!(float("fma(a, b, c)", &[1.0 + e, 1.0 - e, -1.0]), -e * e);
}

#[test]
fn infinities_and_nan_go_through() {
    let inf = f64::INFINITY;
    assert_eq!(float("a / b", &[1.0, 0.0]), inf);
    assert_eq!(float("a / b", &[-1.0, 0.0]), -inf);
    assert_eq!(float("log2(a)", &[0.0]), -inf);
    assert_eq!(float("exp2(a)", &[2000.0]), inf);
    assert_eq!(float("exp2(a)", &[-inf]), 0.0);
    assert_eq!(float("max(a, b)", &[f64::NAN, 1.0]), 1.0);
    assert_eq!(float("min(a, b)", &[1.0, f64::NAN]), 1.0);
    for (expression, arguments) in [
        ("a / b", [0.0, 0.0]),
        ("a - b", [inf, inf]),
        ("a * b", [inf, 0.0]),
        ("a + b", [f64::NAN, 0.0]),
        ("max(a, b)", [f64::NAN, f64::NAN]),
    ] {
        assert!(float(expression, &arguments).is_nan(), "{expression}");
    }
    for expression in ["sqrt(a)", "log(a)", "acos(a)", "inverseSqrt(a)", "acosh(a)"] {
        assert!(float(expression, &[-2.0]).is_nan(), "{expression}");
    }
}

#[test]
fn subnormals_stay() {
    assert_eq!(float("a * 0.5", &[f64::MIN_POSITIVE]), f64::MIN_POSITIVE / 2.0);
    let smallest = f64::from(f32::from_bits(1));
    assert_eq!(
        run_in(Precision::F32, &source("f32 -> f32", "a + a"), &[smallest.into()]),
        (2.0 * smallest).into()
    );
}

#[test]
fn pow_has_the_domain_of_its_definition() {
    let pow = |x, y| float("pow(a, b)", &[x, y]);
    assert_eq!(pow(0.0, 2.0), 0.0);
    assert_eq!(pow(0.0, -2.0), f64::INFINITY);
    assert_eq!(pow(9.0, 0.0), 1.0);
    assert!(pow(-2.0, 2.0).is_nan());
    assert!(pow(0.0, 0.0).is_nan());
    assert_eq!(pow(3.0, 5.0), 243.0);
}

#[test]
fn comparisons_with_nan_are_false() {
    for operator in ["<", "<=", ">", ">=", "=="] {
        let expression = format!("a {operator} b");
        assert_eq!(
            eval("f32; f32 -> bool", &expression, &[f64::NAN.into(), 1.0.into()]),
            false.into()
        );
        let equal = operator.contains('=');
        assert_eq!(
            eval("f32; f32 -> bool", &expression, &[1.0.into(), 1.0.into()]),
            equal.into(),
            "{operator}"
        );
        let greater = operator.starts_with('>');
        assert_eq!(
            eval("f32; f32 -> bool", &expression, &[2.0.into(), 1.0.into()]),
            greater.into(),
            "{operator}"
        );
    }
    assert_eq!(eval("f32; f32 -> bool", "a != b", &[f64::NAN.into(), 1.0.into()]), true.into());
}

#[test]
fn modf_splits() {
    let modf = |x: f64| [float("modf(a).fract", &[x]), float("modf(a).whole", &[x])];
    assert_eq!(modf(-1.25), [-0.25, -1.0]);
    assert_eq!(modf(3.5), [0.5, 3.0]);
    let both = run(
        "fn f(a: vec2<f32>) -> vec4<f32> { let m = modf(a); return vec4(m.whole, m.fract); }",
        &[Value::vec(&[1.5, -2.75])],
    );
    assert_eq!(both, Value::vec(&[1.0, -2.0, 0.5, -0.75]));
}

#[test]
fn frexp_and_ldexp_are_inverse() {
    for x in [1.0, -0.75, 6.0, 1e-300, 1e300, f64::MIN_POSITIVE / 8.0, f64::from_bits(1), f64::MAX]
    {
        let fraction = float("frexp(a).fract", &[x]);
        let Value::I32(exponent) = eval("f32 -> i32", "frexp(a).exp", &[x.into()]) else {
            panic!()
        };
        assert!((0.5..1.0).contains(&fraction.abs()), "{x}");
        let back = eval("f32; i32 -> f32", "ldexp(a, b)", &[fraction.into(), exponent.into()]);
        assert_eq!(back, x.into());
    }
    assert_eq!(float("frexp(a).fract", &[0.0]), 0.0);
    let ldexp = |x: f64, e: i32| eval("f32; i32 -> f32", "ldexp(a, b)", &[x.into(), e.into()]);
    assert_eq!(ldexp(3.0, 4), 48.0.into());
    assert_eq!(ldexp(1.0, i32::MAX), f64::INFINITY.into());
    assert_eq!(ldexp(1.0, i32::MIN), 0.0.into());
    assert_eq!(
        ldexp(f64::from_bits(1), 2000),
        (f64::from_bits(1) * 1000_f64.exp2() * 1000_f64.exp2()).into()
    );
    // Half of the smallest number ties to even (0), anything above rounds up to it.
    assert_eq!(ldexp(1.0, -1075), 0.0.into());
    assert_eq!(ldexp(1.0 + f64::EPSILON, -1075), f64::from_bits(1).into());
}

#[test]
fn quantize_rounds_to_half_precision() {
    assert_eq!(float("quantizeToF16(a)", &[1.0 / 3.0]), 0.333_251_953_125);
    assert_eq!(float("quantizeToF16(a)", &[65504.0]), 65504.0);
    assert_eq!(float("quantizeToF16(a)", &[1e-9]), 0.0);
}

/// Profile of BADF as docs/math.md 2.3 evaluates it: a series where `log1p` needs it, `exp2`, and
/// branches.
const PROFILE: &str = "
fn log1m(y: f32) -> f32 {
    if (y < 0.25) {
        let z = y / (2.0 - y);
        let s = z * z;
        var sum = 0.0;
        for (var k = 30; k >= 0; k -= 1) {
            sum = sum * s + 1.0 / f32(2 * k + 1);
        }
        return -2.0 * z * sum;
    }
    return log(1.0 - y);
}
fn f(x: f32, c: f32, g: f32) -> f32 {
    if (x <= 0.0) { return 1.0; }
    let q = sin(0.5 * x) / sin(0.5 * c);
    if (q >= 1.0) { return 0.0; }
    return exp2(g * log1m(q * q) / log(a_number(2.0)));
}
fn a_number(x: f32) -> f32 { return x; }
";

#[test]
fn a_profile_agrees_with_its_closed_form() {
    let program = compile(PROFILE).unwrap();
    for (c, g) in [(FRAC_PI_2, 1.0), (1.0, 3.7), (0.01, 0.5), (3.0, 250.0)] {
        for step in 0..=20 {
            let x = 1.1 * c * f64::from(step) / 20.0;
            let ratio = ((0.5 * x).sin() / (0.5 * c).sin()).min(1.0);
            let expected = (g * (-ratio * ratio).ln_1p()).exp();
            let actual = program.call(&[x.into(), c.into(), g.into()], Precision::F64).unwrap();
            assert_close(&actual, &[expected], 1e-13);
        }
    }
}
