//! Integer arithmetic and bit operations.

use super::*;

const MIN: i32 = i32::MIN;
const MAX: i32 = i32::MAX;

#[test]
fn arithmetic_wraps() {
    assert_eq!(int("a + b", &[MAX, 1]), MIN);
    assert_eq!(int("a - b", &[MIN, 1]), MAX);
    assert_eq!(int("a * b", &[65536, 65537]), 65536);
    assert_eq!(int("-a", &[MIN]), MIN);
    assert_eq!(int("abs(a)", &[MIN]), MIN);
    assert_eq!(int("abs(a)", &[-5]), 5);
    assert_eq!(uint("abs(a)", &[u32::MAX]), u32::MAX);
    assert_eq!(uint("a + b", &[u32::MAX, 2]), 1);
    assert_eq!(uint("a - b", &[1, 2]), u32::MAX);
    assert_eq!(uint("a * b", &[0x8000_0001, 2]), 2);
    assert_eq!(int("sign(a)", &[-9]), -1);
    assert_eq!(int("sign(a)", &[0]), 0);
}

#[test]
fn division_is_total() {
    assert_eq!(int("a / b", &[7, -2]), -3);
    assert_eq!(int("a % b", &[7, -2]), 1);
    assert_eq!(int("a % b", &[-7, 2]), -1);
    assert_eq!(int("a / b", &[7, 0]), 7);
    assert_eq!(int("a % b", &[7, 0]), 0);
    assert_eq!(int("a / b", &[MIN, -1]), MIN);
    assert_eq!(int("a % b", &[MIN, -1]), 0);
    assert_eq!(uint("a / b", &[u32::MAX, 2]), 0x7FFF_FFFF);
    assert_eq!(uint("a / b", &[7, 0]), 7);
    assert_eq!(uint("a % b", &[7, 0]), 0);
    assert_eq!(uint("a % b", &[7, 4]), 3);
}

#[test]
fn shifts_take_the_amount_modulo_32() {
    let shift = |expression: &str, x: i32, by: u32| {
        eval("i32; u32 -> i32", expression, &[x.into(), by.into()])
    };
    assert_eq!(shift("a << b", 1, 31), MIN.into());
    assert_eq!(shift("a << b", 1, 33), 2.into());
    assert_eq!(shift("a >> b", -8, 1), (-4).into());
    assert_eq!(shift("a >> b", MIN, 31), (-1).into());
    assert_eq!(shift("a >> b", -8, 32), (-8).into());
    assert_eq!(uint("a >> b", &[0x8000_0000, 31]), 1);
    assert_eq!(uint("a << b", &[3, 31]), 0x8000_0000);
}

#[test]
fn bitwise_operators() {
    assert_eq!(uint("a & b", &[0b1100, 0b1010]), 0b1000);
    assert_eq!(uint("a | b", &[0b1100, 0b1010]), 0b1110);
    assert_eq!(uint("a ^ b", &[0b1100, 0b1010]), 0b0110);
    assert_eq!(uint("~a", &[0]), u32::MAX);
    assert_eq!(int("~a", &[5]), -6);
}

#[test]
fn logic() {
    for (a, b) in [(false, false), (false, true), (true, false), (true, true)] {
        let both = [Value::from(a), Value::from(b)];
        let eval = |expression| eval("bool; bool -> bool", expression, &both);
        assert_eq!(eval("a && b"), (a && b).into());
        assert_eq!(eval("a || b"), (a || b).into());
        assert_eq!(eval("a & b"), (a & b).into());
        assert_eq!(eval("a | b"), (a | b).into());
        assert_eq!(eval("a == b"), (a == b).into());
        assert_eq!(eval("a != b"), (a != b).into());
        assert_eq!(eval("!a"), (!a).into());
    }
}

#[test]
fn comparisons_know_the_sign() {
    let signed = |expression| eval("i32; i32 -> bool", expression, &[(-1).into(), 1.into()]);
    assert_eq!(signed("a < b"), true.into());
    assert_eq!(signed("a > b"), false.into());
    assert_eq!(signed("a <= b"), true.into());
    assert_eq!(signed("a >= b"), false.into());
    let unsigned =
        |expression| eval("u32; u32 -> bool", expression, &[u32::MAX.into(), 1_u32.into()]);
    assert_eq!(unsigned("a < b"), false.into());
    assert_eq!(unsigned("a > b"), true.into());
    assert_eq!(unsigned("a <= b"), false.into());
    assert_eq!(unsigned("a >= b"), true.into());
    assert_eq!(unsigned("a == b"), false.into());
    assert_eq!(int("min(a, b)", &[-1, 1]), -1);
    assert_eq!(int("max(a, b)", &[-1, 1]), 1);
    assert_eq!(uint("min(a, b)", &[u32::MAX, 1]), 1);
    assert_eq!(uint("max(a, b)", &[u32::MAX, 1]), u32::MAX);
    assert_eq!(int("clamp(a, b, c)", &[-9, -3, 4]), -3);
    assert_eq!(uint("clamp(a, b, c)", &[u32::MAX, 3, 4]), 4);
}

#[test]
fn counting_bits() {
    assert_eq!(uint("countOneBits(a)", &[0xF0F0]), 8);
    assert_eq!(uint("countLeadingZeros(a)", &[1]), 31);
    assert_eq!(uint("countLeadingZeros(a)", &[0]), 32);
    assert_eq!(uint("countTrailingZeros(a)", &[8]), 3);
    assert_eq!(uint("countTrailingZeros(a)", &[0]), 32);
    assert_eq!(uint("reverseBits(a)", &[1]), 0x8000_0000);
    assert_eq!(uint("firstLeadingBit(a)", &[0]), u32::MAX);
    assert_eq!(uint("firstLeadingBit(a)", &[0x8000_0001]), 31);
    assert_eq!(uint("firstTrailingBit(a)", &[0]), u32::MAX);
    assert_eq!(uint("firstTrailingBit(a)", &[12]), 2);
    assert_eq!(int("firstLeadingBit(a)", &[0]), -1);
    assert_eq!(int("firstLeadingBit(a)", &[-1]), -1);
    assert_eq!(int("firstLeadingBit(a)", &[-2]), 0);
    assert_eq!(int("firstLeadingBit(a)", &[MAX]), 30);
    assert_eq!(int("firstLeadingBit(a)", &[MIN]), 30);
}

#[test]
fn bit_fields() {
    let extract = |x: i32, offset: u32, count: u32| {
        eval(
            "i32; u32; u32 -> i32",
            "extractBits(a, b, c)",
            &[x.into(), offset.into(), count.into()],
        )
    };
    assert_eq!(extract(0b1011_0000, 4, 4), (-5).into());
    assert_eq!(extract(0b0011_0000, 4, 4), 3.into());
    assert_eq!(extract(-2, 0, 32), (-2).into());
    assert_eq!(extract(-2, 31, 9), (-1).into());
    assert_eq!(extract(-2, 32, 9), 0.into());
    assert_eq!(extract(-2, 3, 0), 0.into());
    assert_eq!(extract(-2, 0, 0), 0.into());
    assert_eq!(uint("extractBits(a, b, c)", &[0xABCD_1234, 8, 16]), 0xCD12);
    assert_eq!(uint("extractBits(a, b, c)", &[0xABCD_1234, 28, 400]), 0xA);
    assert_eq!(uint("insertBits(a, b, c, d)", &[0xFFFF_FFFF, 0x12, 8, 8]), 0xFFFF_12FF);
    assert_eq!(uint("insertBits(a, b, c, d)", &[0, 0xFF, 28, 8]), 0xF000_0000);
    assert_eq!(uint("insertBits(a, b, c, d)", &[7, 0xFF, 40, 8]), 7);
    assert_eq!(uint("insertBits(a, b, c, d)", &[7, 9, 0, 32]), 9);
}

#[test]
fn integer_vectors() {
    let dot = eval(
        "vec3<i32>; vec3<i32> -> i32",
        "dot(a, b)",
        &[Value::ivec(&[1, 2, 3]), Value::ivec(&[4, -5, 6])],
    );
    assert_eq!(dot, 12.into());
    let quotient = eval(
        "vec2<u32>; vec2<u32> -> vec2<u32>",
        "a / b",
        &[Value::uvec(&[9, 5]), Value::uvec(&[2, 0])],
    );
    assert_eq!(quotient, Value::uvec(&[4, 5]));
    let scaled = eval("vec2<i32>; i32 -> vec2<i32>", "b * a", &[Value::ivec(&[9, -5]), 3.into()]);
    assert_eq!(scaled, Value::ivec(&[27, -15]));
}
