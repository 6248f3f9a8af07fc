// Free curves and color ramps. Whoever fills a Curve or a Ramp sorts its points and keeps them
// finite; these functions are total all the same: count is at most 16, and points in the same place
// make a step.
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::antialias;
import chiaro::color;

const INTERPOLATION_LINEAR: u32 = 0u;
const INTERPOLATION_SMOOTH: u32 = 1u;
const INTERPOLATION_STEPPED: u32 = 2u;

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
fn curve_at(curve: Curve, x: f32, w: f32) -> f32 {
    let count = min(curve.count, 16u);
    if count == 0u {
        return 0.0;
    }
    var points = curve.points;
    if curve.interpolation == INTERPOLATION_STEPPED {
        var y = points[0].y;
        for (var i = 1u; i < count; i++) {
            y += (points[i].y - points[i - 1u].y) * step_filtered(x, points[i].x, w);
        }
        return bounded(y);
    }
    // The last point that is not beyond x begins the segment.
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, points[i].x <= x);
    }
    let a = points[at];
    if (at + 1u >= count) | (x <= a.x) {
        return bounded(a.y);
    }
    let b = points[at + 1u];
    let t = clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    if curve.interpolation == INTERPOLATION_SMOOTH {
        return bounded(hermite(vec4f(a.y), vec4f(b.y), (b.x - a.x) * vec4f(a.z),
            (b.x - a.x) * vec4f(b.z), t).x);
    }
    return mixed(a.y, b.y, t);
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    let count = min(ramp.count, 16u);
    if count == 0u {
        return vec4f(0.0);
    }
    var colors = ramp.colors;
    var places = ramp.places;
    if ramp.interpolation == INTERPOLATION_STEPPED {
        var color = colors[0];
        for (var i = 1u; i < count; i++) {
            color += (colors[i] - colors[i - 1u]) * step_filtered(x, places[i / 4u][i % 4u], w);
        }
        return bounded_vec4(color);
    }
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, places[i / 4u][i % 4u] <= x);
    }
    let place = places[at / 4u][at % 4u];
    if (at + 1u >= count) | (x <= place) {
        return bounded_vec4(colors[at]);
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    if ramp.interpolation != INTERPOLATION_SMOOTH {
        return mixed_vec4(colors[at], colors[after], t);
    }
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    var from_a = vec4f(0.0);
    var to_b = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    if after + 1u < count {
        let next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
fn ramp_slope(rise_before: vec4f, span_before: f32, rise_after: vec4f, span_after: f32) -> vec4f {
    return vec4f(
        harmonic_slope(divided(rise_before.x, span_before), span_before,
            divided(rise_after.x, span_after), span_after),
        harmonic_slope(divided(rise_before.y, span_before), span_before,
            divided(rise_after.y, span_after), span_after),
        harmonic_slope(divided(rise_before.z, span_before), span_before,
            divided(rise_after.z, span_after), span_after),
        harmonic_slope(divided(rise_before.w, span_before), span_before,
            divided(rise_after.w, span_after), span_after),
    );
}

/// [`ramp_slope`] of one component.
fn harmonic_slope(before: f32, span_before: f32, after: f32, span_after: f32) -> f32 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let weight_before = 2.0 * span_after + span_before;
    let weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    before: vec4f,
    after: vec4f,
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    t: f32,
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
fn ramp_place(ramp: Ramp, x: f32) -> RampPlace {
    let count = min(ramp.count, 16u);
    if count == 0u {
        return RampPlace(vec4f(0.0), vec4f(0.0), 0.0);
    }
    var colors = ramp.colors;
    var places = ramp.places;
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, places[i / 4u][i % 4u] <= x);
    }
    let after = min(at + 1u, count - 1u);
    let place = places[at / 4u][at % 4u];
    let t = clamp(divided(x - place, places[after / 4u][after % 4u] - place), 0.0, 1.0);
    return RampPlace(colors[at], colors[after],
        select(t, eased(t, 0.0, 1.0), ramp.interpolation == INTERPOLATION_SMOOTH));
}

/// The color of a palette (the stops of a ramp) that is nearest to `rgb` in Oklab, alone or blended
/// there with the colors that are up to `softness` farther. Black for a palette without colors.
fn palette_blend(palette: Ramp, rgb: vec3f, softness: f32) -> vec3f {
    let count = min(palette.count, 16u);
    var colors = palette.colors;
    let wanted = oklab_of_srgb(rgb);
    var nearest = 1e30;
    var found = vec3f(0.0);
    for (var i = 0u; i < count; i++) {
        let lab = oklab_of_srgb(colors[i].xyz);
        let far = min(length_of(lab - wanted), 1e29);
        found = select(found, bounded_vec3(colors[i].xyz), far < nearest);
        nearest = min(nearest, far);
    }
    if (softness <= 0.0) | (count == 0u) {
        return found;
    }
    var sum = vec3f(0.0);
    var total = 0.0;
    for (var i = 0u; i < count; i++) {
        let lab = oklab_of_srgb(colors[i].xyz);
        let near = clamp(1.0 - (length_of(lab - wanted) - nearest) / softness, 0.0, 1.0);
        // Weights are squared, so that colors come and go without a kink.
        sum += near * near * lab;
        total += near * near;
    }
    return bounded_vec3(srgb_of_oklab(sum / max(total, 1e-6)));
}
