//! Packing vectors into integers, and back.

use super::*;

fn pack(function: &str, components: &[f64]) -> u32 {
    let signature = format!("vec{}<f32> -> u32", components.len());
    let Value::U32(x) = eval(&signature, &format!("{function}(a)"), &[Value::vec(components)])
    else {
        panic!()
    };
    x
}

fn unpack(function: &str, size: usize, packed: u32) -> Value {
    eval(&format!("u32 -> vec{size}<f32>"), &format!("{function}(a)"), &[packed.into()])
}

#[test]
fn normalized() {
    assert_eq!(pack("pack4x8unorm", &[0.0, 1.0, 0.5, 2.0]), 0xFF80_FF00);
    assert_eq!(pack("pack4x8snorm", &[0.0, 1.0, -1.0, -9.0]), 0x8181_7F00);
    assert_eq!(pack("pack2x16unorm", &[1.0, -1.0]), 0x0000_FFFF);
    assert_eq!(pack("pack2x16snorm", &[1.0, -1.0]), 0x8001_7FFF);
    assert_close(&unpack("unpack4x8unorm", 4, 0xFF80_3300), &[0.0, 0.2, 128.0 / 255.0, 1.0], 1e-15);
    assert_close(&unpack("unpack4x8snorm", 4, 0x8081_7F00), &[0.0, 1.0, -1.0, -1.0], 1e-15);
    assert_close(&unpack("unpack2x16unorm", 2, 0xFFFF_3333), &[0.2, 1.0], 1e-15);
    assert_close(&unpack("unpack2x16snorm", 2, 0x8000_4000), &[16384.0 / 32767.0, -1.0], 1e-15);
}

#[test]
fn half_floats() {
    assert_eq!(pack("pack2x16float", &[1.0, -2.0]), 0xC000_3C00);
    assert_close(&unpack("unpack2x16float", 2, 0xC000_3555), &[0.333_251_953_125, -2.0], 0.0);
}

#[test]
fn bytes() {
    let signed = [Value::ivec(&[1, -1, 300, -300])];
    assert_eq!(eval("vec4<i32> -> u32", "pack4xI8(a)", &signed), 0xD42C_FF01_u32.into());
    assert_eq!(eval("vec4<i32> -> u32", "pack4xI8Clamp(a)", &signed), 0x807F_FF01_u32.into());
    let unsigned = [Value::uvec(&[1, 255, 300, 0])];
    assert_eq!(eval("vec4<u32> -> u32", "pack4xU8(a)", &unsigned), 0x002C_FF01_u32.into());
    assert_eq!(eval("vec4<u32> -> u32", "pack4xU8Clamp(a)", &unsigned), 0x00FF_FF01_u32.into());
    let packed = [0x80FF_7F01_u32.into()];
    assert_eq!(
        eval("u32 -> vec4<i32>", "unpack4xI8(a)", &packed),
        Value::ivec(&[1, 127, -1, -128])
    );
    assert_eq!(
        eval("u32 -> vec4<u32>", "unpack4xU8(a)", &packed),
        Value::uvec(&[1, 127, 255, 128])
    );
    let both = [0x01FF_0302_u32.into(), 0x02FF_0504_u32.into()];
    assert_eq!(
        eval("u32; u32 -> i32", "dot4I8Packed(a, b)", &both),
        (2 * 4 + 3 * 5 + 1 + 2).into()
    );
    assert_eq!(
        eval("u32; u32 -> u32", "dot4U8Packed(a, b)", &both),
        (2 * 4 + 3 * 5 + 255 * 255 + 2_u32).into()
    );
}
