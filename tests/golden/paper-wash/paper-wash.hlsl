// Paper wash: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// paper-wash.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    float4 screen;
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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float2 pixel;
    float3 anchor;
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

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    float2 place;
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    float3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    float2 place;
    float3 stretch;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    float2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    float3 stretch;
};

struct PaperGrain {
    /// The tone as the paper shows it.
    float tone;
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    float height;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
static const float MOST_ON_SCREEN = 1000000000000000.0;
static const Ramp indigo_to_warm_paper = {{float4(0.13, 0.14, 0.33, 1.0),
    float4(0.24, 0.36, 0.56, 1.0), float4(0.53, 0.66, 0.72, 1.0), float4(0.9, 0.8, 0.68, 1.0),
    float4(0.975, 0.95, 0.9, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.35, 0.62, 0.82), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx}, 5u, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 normal : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 normal_1 : LOC0;
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

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x)
{
    uint bits = asuint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = asint(bits - 1060439283u) >> 23u;
    float mantissa = asfloat(bits - (asuint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
float3 normalize_seen(float3 v)
{
    return normalize_moderate(v, float3(0.0, 0.0, 1.0));
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
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral(float x, float count)
{
    float inside = min(x, count);
    float stair = min(floor(inside), 3.0);
    float beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 3.0;
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral_2(float x, float count)
{
    float inside = max(x, 0.0);
    float stair = floor(inside);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + 0.0;
}

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
float stairs_filtered(float x, float count, float w)
{
    if (w <= 1.0) {
        float edge = clamp(round(x), 1.0, 3.0);
        return edge - 1.0 + clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    float half_ = 0.5 * w;
    return (stairs_integral(x + half_, count) - stairs_integral_2(x - half_, count))
        / (2.0 * half_);
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
    for (uint i_2 = 1u; i_2 < 5u; i_2++) {
        float places_now = places[min(uint(naga_div(i_2, 4u)), 3u)][min(uint(naga_mod(i_2, 4u)),
            3u)];
        at = places_now <= x ? i_2 : at;
    }
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    if ((at + 1u >= 5u) | (x <= place)) {
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
    if (after + 1u < 5u) {
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

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
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
    float3 f = d * d * d * (d * (d * 6.0 - (15.0).xxx) + (10.0).xxx);
    int3 cell = to_int(corner);
    for (int i = 0; i < 8; i++) {
        int3 at = int3(i & int(1), (i >> 1u) & int(1), i >> 2u);
        const float3 weight = choose(at == (int(1)).xxx, f, (1.0).xxx - f);
        const uint3 hash_pcg3d_value = hash_pcg3d(asuint(asint(asuint(cell) + asuint(at))) + seed
            * uint3(2654435769u, 2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5 * gradient_dot(hash_pcg3d_value, d - float3(at));
    }
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale)
{
    // Clip space is 2 high.
    return min(0.5 * scale / lerp(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
float3 anchor_on_screen(float3 origin, float perspective, float scale)
{
    const float size = size_on_screen(-origin.z, perspective, scale);
    return clamp(float3(origin.x * size, -origin.y * size, size), (-1000000000000000.0).xxx,
        (1000000000000000.0).xxx);
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = pixel - 0.5 * viewport;
    return float2(from_middle.x, -from_middle.y) / (max(viewport.y, 1.0)).xx;
}

StretchedPlace ConstructStretchedPlace(float2 place, float3 stretch) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    float2 turn = float2(0.0, 1.0);
    float3 x = turn.y * along + turn.x * across;
    float3 y = turn.y * across - turn.x * along;
    float2 turned = float2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x
        * place.x);
    float3 stretch = float3(dot(x, x), dot(x, y), dot(y, y));
    return ConstructStretchedPlace(turned, stretch);
}

SpacedPlace ConstructSpacedPlace(float2 place, float3 stretch) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(float2 place, float3 stretch, float2 viewport, float count)
{
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / max(viewport.y, 1.0) : count;
    float2 p = clamp(place * scale, (-4194304.0).xx, (4194304.0).xx);
    return ConstructSpacedPlace(p, is_pixel ? float3(1.0, 0.0, 1.0) : stretch);
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
float area_square(float3 stretch)
{
    float sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

MarkPlace ConstructMarkPlace(float2 place, float3 stretch) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

MarkPlace mark_place_object(float angle, float3 anchor, float2 pixel, float2 viewport)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    float2 place = (place_in_picture(pixel, viewport) - float2(anchor.x, -anchor.y)) / (size).xx;
    const StretchedPlace m = mark_place_of(place, float3(1.0 / size, 0.0, 0.0),
        float3(0.0, 1.0 / size, 0.0), angle);
    return ConstructMarkPlace(m.place, m.stretch);
}

/// The height of paper in one octave; paper finer than a pixel is flat.
float paper_octave(float2 place, int zoom, float w, float fiber, uint seed)
{
    float scale = asfloat(uint(asint(asuint(zoom) + asuint(int(127)))) << 23u);
    float2 p = clamp(place * scale, (-4194304.0).xx, (4194304.0).xx);
    uint own = seed + 7u * asuint(zoom);
    float grain = perlin_noise(float3(p, 0.5), own) - 0.5;
    float2 q = clamp(2.7 * float2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), (-4194304.0).xx,
        (4194304.0).xx);
    float felt = perlin_noise(float3(q, 0.5), own + 1u) - 0.5;
    float coarse_seen = 1.0 - smoothstep(0.5, 1.0, w * scale);
    float felt_seen = 1.0 - smoothstep(0.5, 1.0, 2.7 * w * scale);
    return clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
float paper_height(SpacedPlace at, float fiber, uint seed)
{
    float height = (float)0;

    float2 x = ddx(at.place);
    float2 y = ddy(at.place);
    float w = sqrt(max(dot(x, x), dot(y, y)));
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    height = paper_octave(at.place, to_int(zoom), w, fiber, seed);
    if (f > 0.0) {
        const float paper_octave_value = paper_octave(at.place,
            asint(asuint(to_int(zoom)) + asuint(int(1))), w, fiber, seed);
        float both = lerp(height, paper_octave_value, f);
        height = clamp(0.5 + (both - 0.5) / sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0, 1.0);
    }
    return height;
}

PaperGrain ConstructPaperGrain(float tone, float height) {
    PaperGrain ret = (PaperGrain)0;
    ret.tone = tone;
    ret.height = height;
    return ret;
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain(float value, float2 place, float3 stretch, float count, float tooth,
    float fiber, int seed, float2 viewport)
{
    const float height = paper_height(spaced(place, stretch, viewport, count), fiber, 5u);
    return ConstructPaperGrain(1.0 - clamp(0.5 + 0.0 * (height - 0.5) * 0.5 * 0.5, 0.0, 1.0),
        height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_2(float value, float2 place, float3 stretch, float count, float tooth,
    float fiber, int seed, float2 viewport)
{
    const float height = paper_height(spaced(place, stretch, viewport, count), fiber, 0u);
    float ink = 1.0 - clamp(value, 0.0, 1.0);
    return ConstructPaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float light_and_shade = max((dot(surface.normal, look.key.direction) + 0.5) / 1.5, 0.0);
    const MarkPlace paper_that_goes_along = mark_place_object(0.0, surface.anchor, surface.pixel,
        look.viewport);
    const PaperGrain where_water_stood = paper_grain(0.5, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 11.0, 0.0, 0.7, int(5), look.viewport);
    float uneven_edge = lerp(-0.2, 0.2, bounded(where_water_stood.height) - 0.0);
    float wet = light_and_shade + uneven_edge;
    const float stairs_filtered_value = stairs_filtered(4.0 * clamp(wet, 0.0, 1.0), 4.0,
        length(float2(4.0 * footprint_of_2(wet), 0.22)));
    // Bands
    float washes = clamp(stairs_filtered_value / 3.0, 0.0, 1.0);
    float pigment_in_them = lerp(washes, wet, 0.35);
    const PaperGrain tooth_of_the_paper = paper_grain_2(pigment_in_them,
        paper_that_goes_along.place, paper_that_goes_along.stretch, 260.0, 0.2, 0.6, int(0),
        look.viewport);
    const float4 indigo_to_warm_paper_2 = ramp_at(indigo_to_warm_paper,
        bounded(tooth_of_the_paper.tone), footprint_of(tooth_of_the_paper.tone));
    float4 output_alpha = float4(indigo_to_warm_paper_2.xyz,
        clamp(indigo_to_warm_paper_2.w, 0.0, 1.0));
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

Surface ConstructSurface(float3 normal, float2 pixel, float3 anchor) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.pixel = pixel;
    ret.anchor = anchor;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.normal_1 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    const float3 anchor_on_screen_value = anchor_on_screen(mul(float4(object.world_from_object[3].xyz,
        1.0), view.camera_from_world).xyz, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, in_.clip_.xy * view.screen.xy + view.screen.zw,
        anchor_on_screen_value);
    return finite_vec4(shade(surface));
}
