// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_tensor_map t0, line_nearness_map t1, facet_map t2.
// ink-outlines.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
};

struct Object {
    row_major float4x4 world_from_object;
    /// The inverse transpose, for normals.
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    float3 direction;
    int _pad1_0;
    /// Unit, toward the light, in the light's own frame.
    float3 own_direction;
    int _pad2_0;
    /// Straight RGB.
    float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
    float object_id;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_object;
    float3 position_camera;
    float depth;
    float3 curvature_tensor;
    float4 line_nearness;
    float2 middle_surface;
    float magnification;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    float4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    float4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
};

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    float4 kinds;
    /// Of borders of ids.
    float ids;
};

struct Outline {
    /// From 0 beside lines to 1 on them.
    float line_;
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    float kind;
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    float distance_;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const uint NOISE_PERLIN = 1u;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
static const float MOST_ON_SCREEN = 1000000000000000.0;
/// What is no nearer than this many pixels is not near at all: less is rounding.
static const float LEAST_NEARNESS = 1e-6;
static const Ramp three_washes = {{float4(0.4353, 0.5255, 0.6588, 1.0),
    float4(0.7882, 0.6471, 0.549, 1.0), float4(0.949, 0.851, 0.6941, 1.0),
    float4(1.0, 0.9647, 0.8784, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.36, 0.54, 0.93), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 4u, 2u};
static const Ramp ink = {{float4(0.0784, 0.102, 0.2, 1.0), float4(0.3529, 0.1647, 0.1098, 1.0),
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.1, 0.85, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 2u, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);
Texture2D<float4> line_nearness_map : register(t1);
Texture2D<float4> facet_map : register(t2);

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

/// v with 0 for each component that is NaN or infinite.
float4 finite_vec4(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return choose((asuint(v) & exponent) != exponent, v, (0.0).xxxx);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
float4 bounded_vec4(float4 v)
{
    uint4 bits = asuint(v);
    uint4 magnitude = bits & (2147483647u).xxxx;
    float4 largest = asfloat((bits & (2147483648u).xxxx) | (2139095039u).xxxx);
    const float4 numbers = choose(magnitude == (2139095040u).xxxx, largest, (0.0).xxxx);
    return choose(magnitude < (2139095040u).xxxx, v, numbers);
}

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// [`mixed`], component by component.
float4 mixed_vec4(float4 a, float4 b, float t)
{
    const float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(float3 v)
{
    float3 dx = ddx(v);
    float3 dy = ddy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    const float d = bounded(x - edge);
    if (w < 1e-30) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered_2(float x, float edge, float w)
{
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
float4 hermite(float4 a, float4 b, float4 from_a, float4 to_b, float t)
{
    float4 d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// [`ramp_slope`] of one component.
float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (before * after <= 0.0) {
        return 0.0;
    }
    float weight_before = 2.0 * span_after + span_before;
    float weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
float4 ramp_slope(float4 rise_before, float span_before, float4 rise_after, float span_after)
{
    const float divided_value = divided(rise_after.x, span_after);
    const float divided_value_1 = divided(rise_after.y, span_after);
    const float harmonic_slope_value = harmonic_slope(divided(rise_before.y, span_before),
        span_before, divided_value_1, span_after);
    const float divided_value_2 = divided(rise_after.z, span_after);
    const float harmonic_slope_value_1 = harmonic_slope(divided(rise_before.z, span_before),
        span_before, divided_value_2, span_after);
    const float divided_value_3 = divided(rise_after.w, span_after);
    const float harmonic_slope_value_2 = harmonic_slope(divided(rise_before.w, span_before),
        span_before, divided_value_3, span_after);
    return float4(harmonic_slope(divided(rise_before.x, span_before), span_before, divided_value,
        span_after), harmonic_slope_value, harmonic_slope_value_1, harmonic_slope_value_2);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / max(rhs, 1u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
float4 ramp_at(Ramp ramp, float x, float w)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    float4 from_a = (0.0).xxxx;
    float4 to_b = (0.0).xxxx;

    uint count = min(ramp.count, 16u);
    if (count == 0u) {
        return (0.0).xxxx;
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        color = colors[0];
        for (; i < count; i++) {
            const float step_filtered_value = step_filtered(x,
                places[min(uint(naga_div(i, 4u)), 3u)][min(uint(naga_mod(i, 4u)), 3u)], w);
            color = color + (colors[min(uint(i), 15u)] - colors[min(uint(i - 1u), 15u)])
                * step_filtered_value;
        }
        return bounded_vec4(color);
    }
    for (uint i_1 = 1u; i_1 < count; i_1++) {
        float places_now = places[min(uint(naga_div(i_1, 4u)), 3u)][min(uint(naga_mod(i_1, 4u)),
            3u)];
        at = places_now <= x ? i_1 : at;
    }
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    if ((at + 1u >= count) | (x <= place)) {
        return bounded_vec4(colors[min(uint(at), 15u)]);
    }
    uint after = at + 1u;
    float span = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)]
        - place;
    float t = clamp(divided(x - place, span), 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        return mixed_vec4(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)], t);
    }
    if (at > 0u) {
        float before = places[min(uint(naga_div(at - 1u, 4u)), 3u)][min(uint(naga_mod(at - 1u, 4u)),
            3u)];
        float4 colors_now = colors[min(uint(at - 1u), 15u)];
        float4 colors_now_1 = colors[min(uint(after), 15u)];
        float4 colors_now_2 = colors[min(uint(at), 15u)];
        from_a = ramp_slope(colors[min(uint(at), 15u)] - colors_now, place - before, colors_now_1
            - colors_now_2, span);
    }
    if (after + 1u < count) {
        float places_now_1 = places[min(uint(naga_div(after + 1u, 4u)),
            3u)][min(uint(naga_mod(after + 1u, 4u)), 3u)];
        float next = places_now_1 - (place + span);
        float4 colors_now_3 = colors[min(uint(after + 1u), 15u)];
        float4 colors_now_4 = colors[min(uint(after), 15u)];
        to_b = ramp_slope(colors[min(uint(after), 15u)] - colors[min(uint(at), 15u)], span,
            colors_now_3 - colors_now_4, next);
    }
    const float4 hermite_value = hermite(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)],
        span * from_a, span * to_b, t);
    return bounded_vec4(hermite_value);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
float4 ramp_at_2(Ramp ramp, float x, float w)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    float4 color = (float4)0;

    colors = ramp.colors;
    places = ramp.places;
    color = colors[0];
    for (uint i = 1u; i < 4u; i++) {
        const float step_filtered_2_value = step_filtered_2(x,
            places[0][min(uint(naga_mod(i, 4u)), 3u)], w);
        color = color + (colors[min(uint(i), 15u)] - colors[min(uint(i - 1u), 15u)])
            * step_filtered_2_value;
    }
    return color;
}

/// Premultiplied RGBA of a straight color.
float4 premultiplied(float4 color)
{
    return float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
float4 straight(float4 composite)
{
    if (composite.w <= 0.0) {
        return composite;
    }
    return float4(composite.xyz / (composite.w).xxx, composite.w);
}

/// The number of an object in texels, from 1 on.
float object_number(float object)
{
    return object - 4096.0 * floor(object / 4096.0) + 1.0;
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
float4 output(float4 color)
{
    return finite_vec4(straight(color));
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
uint3 hash_pcg3d(uint3 seed)
{
    uint3 v = (uint3)0;

    v = seed * 1664525u + (1013904223u).xxx;
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> (16u).xxx);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// The hash of a lattice point.
uint3 lattice_hash(int3 cell, uint seed)
{
    return hash_pcg3d(asuint(cell) + seed * uint3(2654435769u, 2246822507u, 3266489909u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
float3 fade_quintic(float3 t)
{
    return t * t * t * (t * (t * 6.0 - (15.0).xxx) + (10.0).xxx);
}

int3 to_int(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(float3 p, uint seed)
{
    float sum = 0.0;

    float3 corner = floor(p);
    float3 d = p - corner;
    const float3 f = fade_quintic(d);
    int3 cell = to_int(corner);
    for (int i = 0; i < 8; i++) {
        int3 at = int3(i & int(1), (i >> 1u) & int(1), i >> 2u);
        const float3 weight = choose(at == (int(1)).xxx, f, (1.0).xxx - f);
        const float gradient_dot_value = gradient_dot(lattice_hash(asint(asuint(cell) + asuint(at)),
            seed), d - float3(at));
        sum = sum + weight.x * weight.y * weight.z * gradient_dot_value;
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise(uint kind, float3 p, int octaves, float roughness, int seed, float w)
{
    float octave = (float)0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum = 0.0;

    for (int i = 0; i < 2; i++) {
        float visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if (visible > 0.0) {
            float3 place = clamp(p * frequency + float(i) * float3(17.31, 5.17, 11.73),
                (-4194304.0).xxx, (4194304.0).xxx);
            octave = lerp(0.5, perlin_noise(place, 0u + uint(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return min(sum / 1.5, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale)
{
    // Clip space is 2 high.
    return min(0.5 * scale / lerp(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

float reflectance_half_lambert(Light light, float3 normal)
{
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
float4 own_nearness(float4 nearness, float2 middle, float depth, float object, float pixels,
    float reach)
{
    bool local = (bool)0;
    bool local_1 = (bool)0;

    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_1 = abs(behind) <= 8.0625;
        } else {
            local_1 = false;
        }
        local = local_1;
    } else {
        local = true;
    }
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    bool is_own = local;
    bool is_in_front = behind < (is_same_object ? -8.0625 : -2.0625);
    float4 other = float4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

LineWidths ConstructLineWidths(float4 kinds, float ids) {
    LineWidths ret = (LineWidths)0;
    ret.kinds = kinds;
    ret.ids = ids;
    return ret;
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(float width, float4 shares, float ids)
{
    float4 widths = min(width, 10000.0) * shares;
    return ConstructLineWidths(choose(widths > (1e-6).xxxx, widths, (0.0).xxxx), 0.0);
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(float distance_, float width)
{
    return clamp(width + 0.5 - distance_, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
float4 middle_line_covers(float4 distance_, float4 width)
{
    float4 half_ = 0.5 * width;
    return clamp(min(distance_ + (0.5).xxxx, half_) - max(distance_ - (0.5).xxxx, -half_),
        (0.0).xxxx, (1.0).xxxx);
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
float4 lines_cover(float4 nearness, float4 widths, float reach)
{
    float4 distance_ = (reach).xxxx - nearness;
    float4 covers = float4(inner_line_covers(distance_.x, widths.x),
        middle_line_covers(distance_, widths).yzw);
    return choose(nearness > (1e-6).xxxx, covers, (0.0).xxxx);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(float width, float limit, float softness, float3 tensor,
    float3 normal, float3 view, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal, camera_from_world);
    float square = dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    float2 change = float2(ddx(radial), ddy(radial));
    float3 v = mul(view, camera_from_world);
    float3 row = ddy(place);
    float up = (row - dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y) * rsqrt(max(square, 1e-6));
    float pixels = 0.5 * width * height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    float strength = clamp(0.5 + (x - limit)
        / length(float2(min(footprint_of(x), 1000000000000000.0), 24.0)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

Outline ConstructOutline(float line_, float kind, float distance_) {
    Outline ret = (Outline)0;
    ret.line_ = line_;
    ret.kind = kind;
    ret.distance_ = distance_;
    return ret;
}

Outline drawn_outline(LineWidths line_widths, float4 of_edges, float reach)
{
    float kind = (float)0;

    float4 signed_ = clamp(of_edges, (-reach).xxxx, (reach).xxxx);
    float4 nearness = abs(signed_);
    float4 widths = float4(line_widths.kinds.xyz, signed_.w < 0.0 ? 0.0 : line_widths.kinds.w);
    const float4 covers = lines_cover(nearness, widths, reach);
    float line_ = max(max(covers.x, covers.y), max(covers.z, covers.w));
    float least = line_ - 0.0009765625;
    kind = signed_.w < 0.0 ? 5.0 : 4.0;
    kind = covers.z >= least ? 3.0 : kind;
    kind = covers.y >= least ? 2.0 : kind;
    kind = covers.x >= least ? 1.0 : kind;
    const float4 near = choose(widths > (0.0).xxxx, nearness, (0.0).xxxx);
    float nearest = max(max(near.x, near.y), max(near.z, near.w));
    return ConstructOutline(line_, line_ > 0.0009765625 ? kind : 0.0, reach - nearest);
}

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
Outline outline_height(float width, float silhouettes, float creases, float borders,
    float material_borders, float id_borders, float4 nearness, float2 middle, float depth,
    float object, float2 viewport, float magnification)
{
    float pixels = magnification * viewport.y;
    float reach = min(16.0 * max(round(viewport.y / 800.0), 1.0), 31.0);
    const float4 own = own_nearness(nearness, middle, depth, object, pixels, reach);
    float4 shares = float4(silhouettes, creases, borders, material_borders);
    const LineWidths widths = line_widths(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

float noise_perlin(float3 position, float scale, int octaves, float roughness, int seed)
{
    float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const float light_and_dark = reflectance_half_lambert(look.key, surface.normal);
    const float4 three_washes_2 = ramp_at_2(three_washes, light_and_dark,
        footprint_of_2(light_and_dark));
    const float4 ink_2 = ramp_at(ink, light_and_dark, footprint_of_2(light_and_dark));
    float heavy_in_the_shade = lerp(1.6, 8.0, clamp((light_and_dark - 0.75) / -0.6, 0.0, 1.0));
    const float hand = noise_perlin(surface.position_object, 3.5, int(2), 0.5, int(0));
    float pressure = lerp(0.7, 1.3, hand - 0.0);
    float width = heavy_in_the_shade * pressure;
    const Outline pen = outline_height(width, 1.0, 0.6, 1.0, 0.6, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, look.object_id, look.viewport,
        surface.magnification);
    const float folds = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor,
        surface.normal, surface.view, look.camera_from_world, surface.position_camera,
        look.viewport);
    float all_strokes = max(pen.line_, folds);
    // Mix colors
    const float4 ink_on_the_washes = mixed_vec4(three_washes_2, bounded_vec4(ink_2), all_strokes);
    float4 output_alpha = float4(ink_on_the_washes.xyz, clamp(ink_on_the_washes.w, 0.0, 1.0));
    const float4 output_2 = output(premultiplied(output_alpha));
    return output_2;
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 position_object, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.position_object = position_object;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        vertex.position, mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.position_object, varyings.normal,
        varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float3 position_object, float3 position_camera,
    float depth, float3 curvature_tensor, float4 line_nearness, float2 middle_surface,
    float magnification) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    ret.position_camera = position_camera;
    ret.depth = depth;
    ret.curvature_tensor = curvature_tensor;
    ret.line_nearness = line_nearness;
    ret.middle_surface = middle_surface;
    ret.magnification = magnification;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_2, input.position_object_1, input.normal_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_1 = line_nearness_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_2 = facet_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_3 = facet_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    const float size_on_screen_value = size_on_screen(-mul(float4(in_.position, 1.0),
        view.camera_from_world).z, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, mul(float4(in_.position, 1.0), view.camera_from_world).xyz,
        -mul(float4(in_.position, 1.0), view.camera_from_world).z, texel.xyz, texel_1,
        float2(texel_2.z, floor(abs(texel_3.w))), size_on_screen_value);
    return finite_vec4(shade(surface));
}
