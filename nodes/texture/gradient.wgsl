import chiaro::total;

/// Gradient
///
/// A number that grows from 0 to 1 from one point to another: straight, round or around. Ramp gives
/// it colors.
///
/// @choice shape "Shape" default=straight straight="Straight" round="Round" around="Around" :
///   Straight grows along the line between both points; Round grows with the distance from the
///   start; Around grows with the angle about the start, counter-clockwise from the end.
/// @param place "Place" from=uv : Where in the gradient.
/// @param start "Start" default=0,0 : 0 is here; the middle of Round and Around.
/// @param end "End" default=1,0 : 1 is here, or at its distance. Where it is the start, everything
///   is 0.
/// @return value "Value" : From 0 to 1.
/// @unit
fn gradient_straight(place: vec2f, start: vec2f, end: vec2f) -> f32 {
    let line = clamp(bounded_vec2(end - start), vec2f(-1e15), vec2f(1e15));
    let reach = clamp(bounded_vec2(place - start), vec2f(-1e15), vec2f(1e15));
    return clamp(divided(dot(reach, line), dot(line, line)), 0.0, 1.0);
}

fn gradient_round(place: vec2f, start: vec2f, end: vec2f) -> f32 {
    let reach = length_of(vec3f(bounded_vec2(place) - bounded_vec2(start), 0.0));
    return clamp(divided(reach, length_of(vec3f(bounded_vec2(end) - bounded_vec2(start), 0.0))),
        0.0, 1.0);
}

fn gradient_around(place: vec2f, start: vec2f, end: vec2f) -> f32 {
    let line = clamp(bounded_vec2(end - start), vec2f(-1e15), vec2f(1e15));
    let reach = clamp(bounded_vec2(place - start), vec2f(-1e15), vec2f(1e15));
    let across = line.x * reach.y - line.y * reach.x;
    let turn = angle_of_point(across, dot(line, reach)) * 0.159154943091895336;
    return clamp(select(turn, turn + 1.0, turn < 0.0), 0.0, 1.0);
}
