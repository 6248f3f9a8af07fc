// Color code of angles: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1.
// figure2-code.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// The surface under the fragment, in world space.
struct Surface {
    uv: vec2f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    colors: array<vec4f, 16>,
    /// Places of the stops, in increasing order, four to a vector.
    places: array<vec4f, 4>,
    /// Number of stops that count.
    count: u32,
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    interpolation: u32,
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
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
    var colors = ramp.colors;
    var places = ramp.places;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 7u) {
            break;
        }
        at = select(at, i_2, places[i_2 / 4u][i_2 % 4u] <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let place = places[at / 4u][at % 4u];
    if (at + 1u >= 7u) | (x <= place) {
        return colors[at];
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    var from_a = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    var to_b = vec4f(0.0);
    if after + 1u < 7u {
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Separate vector
///
/// The three numbers of a vector.
fn separate_vector(vector: vec3f) -> VectorParts {
    return VectorParts(vector.x, vector.y, 0.0);
}

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}

const color_code = Ramp(array(vec4f(1.0, 0.9686, 0.8392, 1.0), vec4f(1.0, 0.8196, 0.4, 1.0),
    vec4f(0.9529, 0.4471, 0.1725, 1.0), vec4f(0.7843, 0.1961, 0.3529, 1.0),
    vec4f(0.4157, 0.1725, 0.549, 1.0), vec4f(0.1529, 0.2039, 0.4353, 1.0),
    vec4f(0.0431, 0.0627, 0.149, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.1, 0.22, 0.36), vec4f(0.52, 0.72, 1.0, 0.0), vec4f(0.0), vec4f(0.0)), 7u,
    1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let parts = separate_vector(vec3f(surface.uv, 0.0));
    let color_code_2 = ramp_at(color_code, parts.y, footprint_of(parts.y));
    let output_alpha = vec4f(color_code_2.xyz, clamp(color_code_2.w, 0.0, 1.0));
    return output(premultiplied(output_alpha));
}

struct Vertex {
    @location(0) position: vec3f,
    @location(3) uv: vec2f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) uv: vec2f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, vertex.uv);
}

@fragment
fn fs_main(in: Varyings) -> @location(0) vec4f {
    let surface = Surface(in.uv);
    return finite_vec4(shade(surface));
}
