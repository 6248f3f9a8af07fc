// Stained glass: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// stained-glass.json says what to put there and how to draw.

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
    Light room;
    Light sun;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position;
    float3 position_object;
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

struct LitLayer {
    /// The color under this light.
    float4 color;
    /// The tone under this light.
    float tone;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

struct Cell {
    /// The distance to the nearest border, in cells.
    float border;
    /// A random number of the cell, in [0, 1).
    float random;
    /// The distance to the cell's point.
    float distance_;
};

struct Cells {
    /// The distance to the nearest border, in cells: 0 at it, rarely above 0.3.
    float border;
    /// A number from 0 to 1 that is the same all over a cell.
    float random;
    /// The distance to the cell's middle, in cells.
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
static const uint NOISE_PERLIN = 1u;
/// Least distance of the point of a cell that is no neighbor, in cells: points keep a quarter of a
/// cell from their cell's sides.
static const float CELL_REACH = 1.25;
static const Ramp colors_1 = {{float4(0.0706, 0.1882, 0.4784, 1.0),
    float4(0.1216, 0.4784, 0.6902, 1.0), float4(0.1137, 0.5412, 0.3529, 1.0),
    float4(0.9098, 0.6902, 0.1255, 1.0), float4(0.8471, 0.3255, 0.1098, 1.0),
    float4(0.6902, 0.0706, 0.2196, 1.0), float4(0.3529, 0.102, 0.4784, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.22, 0.4, 0.58), float4(0.75, 0.9, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx}, 7u, 2u};
static const ProfileShape through_the_glass_shape = {0.9950042, 0.099833414, 1.1883951, 1.4967098,
    0.2, 1.0679889, 0.45520553, 0u};
static const ProfileShape on_the_glass_shape = {0.99875027, 0.04997917, 1.2766062, 1.3888036, 0.1,
    1.0089166, 0.41697913, 0u};
static const ProfileShape gleam_tone_shape = {0.99820054, 0.059964005, 11.126125, 3.022525, 0.12,
    0.08196669, 0.036355104, 0u};
static const ProfileShape edge_of_the_lead_tone_shape = {0.9887711, 0.14943813, 3.3838634,
    2.4220939, 0.3, 0.29531473, 0.1274162, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position_3 : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_4 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x)
{
    return (asuint(x) & 2139095040u) != 2139095040u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!((largest > 1e-30) & (largest < 1e30))) {
        return otherwise;
    }
    float3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
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

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, float2 t)
{
    float s = u.half_sin - 0.0;
    float2 upper = u.half_cos <= 0.0 ? float2(1.0, 0.0) : float2(s, u.half_cos);
    float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
float length_of(float3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * length(v / (largest).xxx));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3_2(float3 v)
{
    float3 dx = ddx(v);
    float3 dy = ddy(v);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
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

    colors = ramp.colors;
    places = ramp.places;
    color = colors[0];
    for (uint i = 1u; i < 7u; i++) {
        const float step_filtered_value = step_filtered(x,
            places[min(uint(naga_div(i, 4u)), 3u)][min(uint(naga_mod(i, 4u)), 3u)], w);
        color = color + (colors[min(uint(i), 15u)] - colors[min(uint(i - 1u), 15u)])
            * step_filtered_value;
    }
    return color;
}

/// The normal of a surface that is raised by a height (Mikkelsen 2010): `along_x` and `along_y`
/// hold how position (xyz) and height (w) change from pixel to pixel. Where position does not
/// change, or the surface is seen edge-on, the normal stays as it is. Slopes end at 10, which is 84
/// degrees, so that silhouettes do not sparkle.
float3 bumped_normal(float4 along_x, float4 along_y, float3 normal)
{
    float largest = max(length_of(along_x.xyz), length_of(along_y.xyz));
    if ((largest < 1e-18) | (largest > 1e18)) {
        return normal;
    }
    float3 s = along_x.xyz / (largest).xxx;
    float3 t = along_y.xyz / (largest).xxx;
    float2 rise = clamp(float2(along_x.w, along_y.w) / (largest).xx, (-1000000.0).xx,
        (1000000.0).xx);
    float3 right = cross(t, normal);
    float3 up = cross(normal, s);
    float area = dot(s, right);
    if (abs(area) < 1e-6) {
        return normal;
    }
    float3 slope = (rise.x * right + rise.y * up) / (area).xxx;
    float steepness = length(slope);
    float3 limited = slope * (min(steepness, 10.0) / max(steepness, 1e-20));
    return normalize_or(normal - limited, normal);
}

/// Bump map
///
/// Bends the normal as if the surface were raised by a height: from a picture, a noise or anything
/// else. It needs no texture coordinates.
float3 bump_map(float height, float scale, float3 normal, float3 position)
{
    float raised = height * scale;
    float4 along_x = float4(ddx(position), ddx(raised));
    float4 along_y = float4(ddy(position), ddy(raised));
    return bumped_normal(along_x, along_y, normal);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return max(float4(below.xyz + opacity * (below.xyz + color.xyz - below.xyz), 1.0), (0.0).xxxx);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
float4 blend_add_2(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity * (below.xyz + tone * color.xyz - below.xyz), 1.0),
        (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
}

LitLayer ConstructLitLayer(float4 color, float tone) {
    LitLayer ret = (LitLayer)0;
    ret.color = color;
    ret.tone = tone;
    return ret;
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, float4 color, float tone)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return ConstructLitLayer(float4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_specular_balanced(Light light, float3 normal, float3 view)
{
    float3 d = 2.0 * dot(normal, view) * normal - view;
    return ConstructAngle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    const float point_ = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point_;
    }
    float r = 0.19364917 * w;
    float2 turn = float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    const float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    const float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = (w > 0.0) & (w >= 3.4641016 * shape.edge_deviation);
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
    const float point_ = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point_;
    }
    float r = 0.19364917 * w;
    float2 turn = float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    const float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    const float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
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

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
float3 unit_of_hash(uint3 hash)
{
    return float3(hash >> (8u).xxx) * 5.9604645e-8;
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

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - lhs / divisor * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

Cell ConstructCell(float border, float random, float distance_) {
    Cell ret = (Cell)0;
    ret.border = border;
    ret.random = random;
    ret.distance_ = distance_;
    return ret;
}

/// The cell around the nearest of one point per lattice cell, each in the middle half of its own.
///
/// The distance to the border, which lies midway between the two nearest points, ends at (1.25 -
/// distance) / 2: a point that was not looked at is at least 1.25 away, so no border of its is
/// nearer, and a farther border counts as that far.
Cell nearest_cell(float3 p, uint seed)
{
    float3 nearest = (4.0).xxx;
    uint3 hash = (0u).xxx;
    float border = (float)0;

    float3 corner = floor(p);
    float3 d = p - corner;
    int3 cell = to_int(corner);
    for (int i = 0; i < 27; i++) {
        int3 at = int3(asint(asuint(naga_mod(i, int(3))) - asuint(int(1))),
            asint(asuint(naga_mod(naga_div(i, int(3)), int(3))) - asuint(int(1))),
            asint(asuint(naga_div(i, int(9))) - asuint(int(1))));
        const uint3 own = lattice_hash(asint(asuint(cell) + asuint(at)), seed);
        float3 offset = float3(at) + (0.25).xxx + 0.5 * unit_of_hash(own) - d;
        if (dot(offset, offset) < dot(nearest, nearest)) {
            nearest = offset;
            hash = own;
        }
    }
    float distance_ = length(nearest);
    border = max(0.5 * (CELL_REACH - distance_), 0.0);
    for (int i_1 = 0; i_1 < 27; i_1++) {
        int3 at_1 = int3(asint(asuint(naga_mod(i_1, int(3))) - asuint(int(1))),
            asint(asuint(naga_mod(naga_div(i_1, int(3)), int(3))) - asuint(int(1))),
            asint(asuint(naga_div(i_1, int(9))) - asuint(int(1))));
        const float3 unit_of_hash_value = unit_of_hash(lattice_hash(asint(asuint(cell)
            + asuint(at_1)), seed));
        float3 apart = float3(at_1) + (0.25).xxx + 0.5 * unit_of_hash_value - d - nearest;
        float between = length(apart);
        // Points are half a cell apart at least; a nearer one is the cell's own.
        if (between > 0.25) {
            border = min(border, dot(nearest + 0.5 * apart, apart) / between);
        }
    }
    const Cell cell_1 = ConstructCell(max(border, 0.0), unit_of_hash(hash_pcg3d(hash)).x,
        distance_);
    // The number has a hash other than that of the point's place, or it would tell where in its
    // cell the point lies.
    return cell_1;
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

Cells ConstructCells(float border, float random, float distance_) {
    Cells ret = (Cells)0;
    ret.border = border;
    ret.random = random;
    ret.distance_ = distance_;
    return ret;
}

/// Cells
///
/// Space in pieces with straight borders, each with a number of its own: panes of glass, scales,
/// tiles, cracks. A Threshold of the border draws the seams, a Ramp of the number gives every piece
/// its color.
Cells cells(float3 position, float scale, int seed)
{
    float3 p = clamp(position * scale, (-4194304.0).xxx, (4194304.0).xxx);
    const Cell cell = nearest_cell(p, 4u);
    float visible = 1.0 - smoothstep(0.5, 1.0, footprint_of_vec3_2(p));
    float3 average = float3(0.1301, 0.5, 0.491);
    float3 seen = lerp(average, float3(cell.border, cell.random, cell.distance_), visible);
    return ConstructCells(seen.x, seen.y, seen.z);
}

float noise_perlin(float3 position, float scale, int octaves, float roughness, int seed)
{
    float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const Cells panes = cells(surface.position_object, 3.4, int(4));
    const float4 colors_2 = ramp_at(colors_1, panes.random, footprint_of(panes.random));
    const float4 glass_in_shade = blend_add(float4(0.0275, 0.0235, 0.0471, 1.0), colors_2, 1.0, 0.3,
        true);
    const float wavering_glass = noise_perlin(surface.position_object, 5.0, int(2), 0.5, int(0));
    const float3 glass = bump_map(wavering_glass, 0.03, surface.normal, surface.position);
    // Parametrization
    Angle sun_turn = ConstructAngle(0.5 * length(glass - look.sun.direction), 0.5
        * length(glass + look.sun.direction));
    const float through_the_glass = profile_balanced(sun_turn, 0.0, through_the_glass_shape);
    const float4 light_through_it = blend_add_2(glass_in_shade, colors_2, through_the_glass, 0.95,
        true);
    // Parametrization
    Angle room_turn = ConstructAngle(0.5 * length(glass - look.room.direction), 0.5
        * length(glass + look.room.direction));
    const float on_the_glass = profile_balanced(room_turn, 0.0, on_the_glass_shape);
    const float4 light_on_it = blend_add_2(light_through_it, colors_2, on_the_glass, 0.45, true);
    // Threshold
    const float seam = step_filtered(panes.border, 0.035,
        length(float2(footprint_of(panes.border), 0.0)));
    float leading = 1.0 - seam;
    // Blend
    float4 leading_2 = clamp(float4(light_on_it.xyz + leading
        * (float3(0.0824, 0.0863, 0.102) - light_on_it.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);

    // Gleam (Light layer)
    const Angle gleam_angle = parametrization_specular_balanced(look.room, glass, surface.view);
    const float gleam_tone = profile_balanced_2(gleam_angle, 0.0, gleam_tone_shape);
    const LitLayer gleam_lit = light_apply(look.room, float4(1.0, 0.9647, 0.8941, 1.0), gleam_tone);
    const float4 gleam_blend = blend_alpha(leading_2, gleam_lit.color, gleam_lit.tone, 0.7, true);

    // Edge of the lead (Light layer)
    const Angle edge_of_the_lead_angle = parametrization_specular_balanced(look.room,
        surface.normal, surface.view);
    const float edge_of_the_lead_tone = profile_balanced_2(edge_of_the_lead_angle, 0.0,
        edge_of_the_lead_tone_shape);
    const LitLayer edge_of_the_lead_lit = light_apply(look.room,
        float4(0.1725, 0.1843, 0.2196, 1.0), edge_of_the_lead_tone);
    const float4 edge_of_the_lead_blend = blend_add_2(gleam_blend, edge_of_the_lead_lit.color,
        edge_of_the_lead_lit.tone, 0.35, true);

    return edge_of_the_lead_blend;
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

Surface ConstructSurface(float3 normal, float3 view, float3 position, float3 position_object) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position = position;
    ret.position_object = position_object;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_4, input.position_object_1, input.normal_4 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position, in_.position_object);
    return shade(surface);
}
