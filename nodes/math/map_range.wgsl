import chiaro::types;
import chiaro::total;

/// Map range
///
/// Moves numbers from one range to another: depth to fog, curvature to a mask. Where the first
/// range is empty, all that is below it becomes the new low and the rest the new high. A color
/// keeps its alpha, within 0 and 1 while clamped.
///
/// @param value "Value" default=0 : What is moved.
/// @param from_low "From low" default=0 : This becomes the new low.
/// @param from_high "From high" default=1 : This becomes the new high; it may be below the old low.
/// @param to_low "To low" default=0 : The new low.
/// @param to_high "To high" default=1 : The new high.
/// @param clamped "Clamp" default=true : Keeps the result between the new low and high.
/// @return value "Value" : In the new range.
/// @unit when clamped = 1 and to_low = 0 and to_high = 1
fn map_range(value: f32, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> f32 {
    return remapped(value, from_low, from_high, to_low, to_high, clamped);
}

fn map_range_vec2(value: vec2f, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> vec2f {
    return vec2f(
        remapped(value.x, from_low, from_high, to_low, to_high, clamped),
        remapped(value.y, from_low, from_high, to_low, to_high, clamped),
    );
}

fn map_range_vec3(value: vec3f, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> vec3f {
    return vec3f(
        remapped(value.x, from_low, from_high, to_low, to_high, clamped),
        remapped(value.y, from_low, from_high, to_low, to_high, clamped),
        remapped(value.z, from_low, from_high, to_low, to_high, clamped),
    );
}

fn map_range_vec4(value: vec4f, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> vec4f {
    return vec4f(
        remapped(value.x, from_low, from_high, to_low, to_high, clamped),
        remapped(value.y, from_low, from_high, to_low, to_high, clamped),
        remapped(value.z, from_low, from_high, to_low, to_high, clamped),
        remapped(value.w, from_low, from_high, to_low, to_high, clamped),
    );
}

fn map_range_color(value: Color, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> Color {
    return vec4f(
        remapped(value.x, from_low, from_high, to_low, to_high, clamped),
        remapped(value.y, from_low, from_high, to_low, to_high, clamped),
        remapped(value.z, from_low, from_high, to_low, to_high, clamped),
        factor_of(value.w, clamped),
    );
}
