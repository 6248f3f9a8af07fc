//! Conversions between kinds of scalars.

use super::*;

fn to_i32(x: f64) -> Value {
    eval("f32 -> i32", "i32(a)", &[x.into()])
}

fn to_u32(x: f64) -> Value {
    eval("f32 -> u32", "u32(a)", &[x.into()])
}

#[test]
fn floats_truncate_and_saturate() {
    assert_eq!(to_i32(-1.9), (-1).into());
    assert_eq!(to_i32(2_147_483_646.5), 2_147_483_646.into());
    assert_eq!(to_i32(1e30), i32::MAX.into());
    assert_eq!(to_i32(f64::NEG_INFINITY), i32::MIN.into());
    assert_eq!(to_i32(f64::NAN), 0.into());
    assert_eq!(to_u32(1.9), 1_u32.into());
    assert_eq!(to_u32(-1.9), 0_u32.into());
    assert_eq!(to_u32(f64::INFINITY), u32::MAX.into());
    assert_eq!(to_u32(f64::NAN), 0_u32.into());
}

#[test]
fn in_f32_they_saturate_at_what_f32_can_hold() {
    let convert = |signature: &str, expression: &str, x: f64| {
        run_in(Precision::F32, &source(signature, expression), &[x.into()])
    };
    assert_eq!(convert("f32 -> i32", "i32(a)", 1e30), 2_147_483_520.into());
    assert_eq!(convert("f32 -> i32", "i32(a)", -1e30), i32::MIN.into());
    assert_eq!(convert("f32 -> u32", "u32(a)", 1e30), 4_294_967_040_u32.into());
    assert_eq!(convert("f32 -> u32", "u32(a)", f64::NAN), 0_u32.into());
}

#[test]
fn integers_and_bools() {
    assert_eq!(eval("u32 -> i32", "i32(a)", &[u32::MAX.into()]), (-1).into());
    assert_eq!(eval("i32 -> u32", "u32(a)", &[(-1).into()]), u32::MAX.into());
    assert_eq!(eval("i32 -> f32", "f32(a)", &[i32::MIN.into()]), f64::from(i32::MIN).into());
    assert_eq!(eval("u32 -> f32", "f32(a)", &[u32::MAX.into()]), f64::from(u32::MAX).into());
    assert_eq!(eval("bool -> f32", "f32(a)", &[true.into()]), 1.0.into());
    assert_eq!(eval("bool -> i32", "i32(a)", &[true.into()]), 1.into());
    assert_eq!(eval("bool -> u32", "u32(a)", &[false.into()]), 0_u32.into());
    assert_eq!(eval("i32 -> bool", "bool(a)", &[(-7).into()]), true.into());
    assert_eq!(eval("u32 -> bool", "bool(a)", &[0_u32.into()]), false.into());
    assert_eq!(eval("f32 -> bool", "bool(a)", &[(-0.0).into()]), false.into());
    assert_eq!(eval("f32 -> bool", "bool(a)", &[0.1.into()]), true.into());
    assert_eq!(eval("f32 -> bool", "bool(a)", &[f64::NAN.into()]), true.into());
    assert_eq!(
        eval("vec3<f32> -> vec3<i32>", "vec3<i32>(a)", &[Value::vec(&[1.5, -1.5, 1e10])]),
        Value::ivec(&[1, -1, i32::MAX])
    );
}

#[test]
fn bitcasts_go_through_f32() {
    assert_eq!(eval("f32 -> u32", "bitcast<u32>(a)", &[1.0.into()]), 0x3F80_0000_u32.into());
    assert_eq!(eval("f32 -> i32", "bitcast<i32>(a)", &[(-0.0).into()]), i32::MIN.into());
    assert_eq!(eval("f32 -> u32", "bitcast<u32>(a)", &[0.1.into()]), 0.1_f32.to_bits().into());
    assert_eq!(
        eval("u32 -> f32", "bitcast<f32>(a)", &[0x7F80_0000_u32.into()]),
        f64::INFINITY.into()
    );
    assert_eq!(
        eval("i32 -> f32", "bitcast<f32>(a)", &[1.into()]),
        f64::from(f32::from_bits(1)).into()
    );
    assert_eq!(eval("i32 -> u32", "bitcast<u32>(a)", &[(-1).into()]), u32::MAX.into());
    assert_eq!(
        eval("vec2<f32> -> vec2<u32>", "bitcast<vec2<u32>>(a)", &[Value::vec(&[2.0, -2.0])]),
        Value::uvec(&[0x4000_0000, 0xC000_0000])
    );
    let fields = "extractBits(bitcast<u32>(a), 23u, 8u)";
    assert_eq!(eval("f32 -> u32", fields, &[8.5.into()]), 130_u32.into());
}

#[test]
fn integers_round_in_f32() {
    let value = run_in(Precision::F32, &source("u32 -> f32", "f32(a)"), &[16_777_217_u32.into()]);
    assert_eq!(value, 16_777_216.0.into());
    let value = run_in(Precision::F32, &source("i32 -> f32", "f32(a)"), &[(-16_777_219).into()]);
    assert_eq!(value, (-16_777_220.0).into());
}
