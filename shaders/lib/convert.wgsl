// Conversions that the compiler calls between nodes: where a wire changes type, and where a number
// is a share.
import chiaro::types;
import chiaro::numeric;
import chiaro::angle;

/// A share (an opacity, a mask) clamped to [0, 1]: beyond, a mix would go past what it mixes.
fn unit_share(share: f32) -> f32 {
    return clamp(share, 0.0, 1.0);
}

/// `color` with its alpha clamped to [0, 1].
fn with_unit_alpha(color: Color) -> Color {
    return vec4f(color.xyz, unit_share(color.w));
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
fn luminance(color: Color) -> f32 {
    return dot(color.xyz, vec3f(0.2126, 0.7152, 0.0722));
}

/// The nearest whole number, within +-2^24; 0 where x is not finite.
fn int_of(x: f32) -> i32 {
    return i32(round(clamp(finite_or(x, 0.0), -16777216.0, 16777216.0)));
}

/// Linear light encoded for display by the sRGB curve (IEC 61966-2-1); negative light is black,
/// alpha stays.
fn display_from_linear(color: Color) -> Color {
    let c = max(color.xyz, vec3f(0.0));
    let low = 12.92 * c;
    let high = 1.055 * pow(c, vec3f(1.0 / 2.4)) - 0.055;
    return vec4f(select(high, low, c <= vec3f(0.0031308)), color.w);
}

/// Display colors decoded to linear light by the sRGB curve (IEC 61966-2-1); alpha stays.
fn linear_from_display(color: Color) -> Color {
    let c = max(color.xyz, vec3f(0.0));
    let low = c / 12.92;
    let high = pow((c + 0.055) / 1.055, vec3f(2.4));
    return vec4f(select(high, low, c <= vec3f(0.04045)), color.w);
}
