import chiaro::types;
import chiaro::total;

/// Power
///
/// A number raised to a power. Above 1 it pulls values between 0 and 1 down, below 1 it lifts them.
/// A color keeps its alpha.
///
/// A negative base is raised as in algebra by a whole exponent ((-2)^2 = 4) and keeps its sign with
/// any other ((-4)^0.5 = -2). 0 to the power of 0 is 1; 0 to a negative power is 0.
///
/// @param base "Base" default=1 : What is raised.
/// @param exponent "Exponent" default=1 : How often it is multiplied with itself.
/// @return power "Power" : Base^exponent.
/// @bypass base when exponent = 1 : its exponent is 1
fn power(base: f32, exponent: f32) -> f32 {
    return powered(base, exponent);
}

fn power_vec2(base: vec2f, exponent: f32) -> vec2f {
    return vec2f(powered(base.x, exponent), powered(base.y, exponent));
}

fn power_vec3(base: vec3f, exponent: f32) -> vec3f {
    return vec3f(powered(base.x, exponent), powered(base.y, exponent), powered(base.z, exponent));
}

fn power_vec4(base: vec4f, exponent: f32) -> vec4f {
    return vec4f(
        powered(base.x, exponent),
        powered(base.y, exponent),
        powered(base.z, exponent),
        powered(base.w, exponent),
    );
}

fn power_color(base: Color, exponent: f32) -> Color {
    return vec4f(powered_vec3(base.xyz, exponent), bounded(base.w));
}
