// Screen-aligned parametrization: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// figure2-screen-aligned.json says what to put there and how to draw.

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
    Light key;
    row_major float3x3 camera_from_world;
    int _end_pad_0;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
};

static const float HALF_PI = 1.5707964;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp color_code = {{float4(1.0, 0.9686, 0.8392, 1.0), float4(1.0, 0.8196, 0.4, 1.0),
    float4(0.9529, 0.4471, 0.1725, 1.0), float4(0.7843, 0.1961, 0.3529, 1.0),
    float4(0.4157, 0.1725, 0.549, 1.0), float4(0.1529, 0.2039, 0.4353, 1.0),
    float4(0.0431, 0.0627, 0.149, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.1, 0.22, 0.36), float4(0.52, 0.72, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx}, 7u, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 normal_1 : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 normal_2 : LOC0;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
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

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
float atan2_positive(float y, float x)
{
    float small = min(y, x);
    float large = max(y, x);
    if (large <= 0.0) {
        return 0.0;
    }
    float t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    bool is_wide = t > 0.41421357;
    float r = is_wide ? (small - large) / (small + large) : t;
    float r2 = r * r;
    float series = r * (1.0 + r2 * (-0.33333334 + r2
        * (0.2 + r2 * (-0.14285715 + r2
        * (0.11111111 + r2 * (-0.09090909 + r2
        * (0.07692308 + r2 * (-0.06666667 + r2 * 0.05882353))))))));
    float a = is_wide ? series + 0.7853982 : series;
    return y > x ? HALF_PI - a : a;
}

/// The angle u in radians.
float angle_radians(Angle u)
{
    return 2.0 * atan2_positive(u.half_sin, u.half_cos);
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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
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
    uint at = 0u;
    float4 from_a = (0.0).xxxx;
    float4 to_b = (0.0).xxxx;

    colors = ramp.colors;
    places = ramp.places;
    for (uint i_2 = 1u; i_2 < 7u; i_2++) {
        float places_now = places[min(uint(naga_div(i_2, 4u)), 3u)][min(uint(naga_mod(i_2, 4u)),
            3u)];
        at = places_now <= x ? i_2 : at;
    }
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    if ((at + 1u >= 7u) | (x <= place)) {
        return colors[min(uint(at), 15u)];
    }
    uint after = at + 1u;
    float span = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)]
        - place;
    float t = clamp(divided(x - place, span), 0.0, 1.0);
    if (at > 0u) {
        float before = places[min(uint(naga_div(at - 1u, 4u)), 3u)][min(uint(naga_mod(at - 1u, 4u)),
            3u)];
        float4 colors_now = colors[min(uint(at - 1u), 15u)];
        float4 colors_now_1 = colors[min(uint(after), 15u)];
        float4 colors_now_2 = colors[min(uint(at), 15u)];
        from_a = ramp_slope(colors[min(uint(at), 15u)] - colors_now, place - before, colors_now_1
            - colors_now_2, span);
    }
    if (after + 1u < 7u) {
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
float4 output(float4 color)
{
    return finite_vec4(straight(color));
}

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

Angle parametrization_screen_aligned_balanced(Light light, float3 normal,
    float3x3 camera_from_world)
{
    float3 d = mul(normal, camera_from_world);
    return ConstructAngle(0.5 * length(d - light.own_direction), 0.5
        * length(d + light.own_direction));
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const Angle angle = parametrization_screen_aligned_balanced(look.key, surface.normal,
        look.camera_from_world);
    float angle_over_pi = angle_radians(angle) / 3.1415927;
    const float4 color_code_2 = ramp_at(color_code, angle_over_pi, footprint_of(angle_over_pi));
    float4 output_alpha = float4(color_code_2.xyz, clamp(color_code_2.w, 0.0, 1.0));
    return output(premultiplied(output_alpha));
}

Varyings ConstructVaryings(float4 clip_, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world),
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal);
    return finite_vec4(shade(surface));
}
