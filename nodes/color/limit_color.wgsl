import chiaro::types;
import chiaro::total;

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
///
/// @param color "Color" default=1,1,1,1 : Straight; its alpha stays.
/// @param limit "Limit" default=1 min=0 max=10 : No channel exceeds this.
/// @param softness "Softness" default=0 min=0 max=1 : How much of the way to the limit is pressed
///   together, so that bright parts keep their differences.
/// @return color "Color" : Its brightest channel is at most the limit.
fn limit_color(color: Color, limit: f32, softness: f32) -> Color {
    // Within what an f32 divides without loss, so that the darkest factor is above 0.
    let c = clamp(bounded_vec3(color.xyz), vec3f(-1e18), vec3f(1e18));
    let most = clamp(bounded(limit), 0.0, 1e6);
    let knee = most * (1.0 - clamp(softness, 0.0, 1.0));
    let brightest = max(max(c.x, c.y), c.z);
    if brightest <= knee {
        return vec4f(c, bounded(color.w));
    }
    let room = most - knee;
    let above = brightest - knee;
    // A hyperbola from the knee, where its slope is 1, toward the limit: ab / (a + b).
    let pressed = knee + min(above, room) * (max(above, room) / (above + room));
    // Rounding must not brighten: channels may be as large as numbers come.
    return vec4f(c * min(pressed / brightest, 1.0), bounded(color.w));
}
