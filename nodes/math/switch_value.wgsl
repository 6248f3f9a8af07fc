import chiaro::types;

/// Switch
///
/// One of two values, by a switch or by a number that is on above 0.5.
///
/// @param off "Off" default=0 : While the switch is off.
/// @param on "On" default=1 : While the switch is on.
/// @param condition "Switch" default=false : Which of the two.
/// @return value "Value" : The chosen one.
/// @bypass off when condition = 0 : it is off
/// @bypass on when condition = 1 : it is on
/// @bypass off when off = on : both values are the same
fn switch_value(off: f32, on: f32, condition: bool) -> f32 {
    return select(off, on, condition);
}

fn switch_value_vec2(off: vec2f, on: vec2f, condition: bool) -> vec2f {
    return select(off, on, condition);
}

fn switch_value_vec3(off: vec3f, on: vec3f, condition: bool) -> vec3f {
    return select(off, on, condition);
}

fn switch_value_vec4(off: vec4f, on: vec4f, condition: bool) -> vec4f {
    return select(off, on, condition);
}

fn switch_value_color(off: Color, on: Color, condition: bool) -> Color {
    return select(off, on, condition);
}
