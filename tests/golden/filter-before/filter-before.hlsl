// A filter before the profile: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// filter-before.json says what to put there and how to draw.

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

/// What is known before the fragment.
struct Look {
    float3 lamp_position;
    int _pad1_0;
    float3 lamp_aim;
    int _pad2_0;
    row_major float3x3 lamp_own_from_world;
    int _pad3_0;
    float3 lamp_color;
    float lamp_intensity;
    float2 lamp_cone;
    float2 lamp_fading;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 position;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    float3 direction;
    /// Unit, toward the light, in the light's own frame.
    float3 own_direction;
    /// Straight RGB.
    float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

struct LitLayer {
    /// The color under this light.
    float4 color;
    /// The tone under this light.
    float tone;
};

struct FilteredLight {
    /// The light behind the filter.
    Light light;
    /// The angle for the profile.
    Angle angle;
};

struct PlaceInLight {
    /// From 0,0 at the picture's lower left corner to 1,1 at its upper right one, as the light sees
    /// it.
    float2 uv;
    /// 1 within the picture, 0 outside of it.
    float inside;
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
    float3 normal : LOC1;
};

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float SMALLEST_NORMAL = 1.1754944e-38;
/// The farthest that anything counts as from a shape, in sizes of the shape.
static const float FAR_FROM_SHAPE = 1000.0;
/// Least distance of the point of a cell that is no neighbor, in cells: points keep a quarter of a
/// cell from their cell's sides.
static const float CELL_REACH = 1.25;
static const ProfileShape tone_shape = {0.87758255, 0.47942555, 20.008335, 2.4978132, 1.0,
    0.04909103, 0.021148764, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position_4 : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_5 : LOC0;
    float3 normal_1 : LOC1;
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

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
float2 sin_cos_eighth(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y
        * (0.008333334 + y * (-0.0001984127 + y * 2.7557319e-6))));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y
        * (0.0013888889 + y * (-2.4801588e-5 + y * 2.755732e-7))));
    return float2(s, c);
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
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + 0.0;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
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

/// [`bounded`], component by component.
float3 bounded_vec3(float3 v)
{
    uint3 bits = asuint(v);
    uint3 magnitude = bits & (2147483647u).xxx;
    float3 largest = asfloat((bits & (2147483648u).xxx) | (2139095039u).xxx);
    const float3 numbers = choose(magnitude == (2139095040u).xxx, largest, (0.0).xxx);
    return choose(magnitude < (2139095040u).xxx, v, numbers);
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(float x, float low, float high)
{
    float span = high - low;
    if (span < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(place_between(bounded(x), low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
float angle_of_point(float y, float x)
{
    float2 p = abs(float2(x, y));
    float2 scaled = max(p.x, p.y) > 1.0 ? 0.5 * p : p;
    const float a = atan2_positive(scaled.y, scaled.x);
    float turned = x < 0.0 ? PI - a : a;
    return y < 0.0 ? -turned : turned;
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
float2 footprint_of_vec2(float2 v)
{
    float2 dx = ddx(v);
    float2 dy = ddy(v);
    return sqrt(dx * dx + dy * dy);
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(float3 v)
{
    float3 dx = ddx(v);
    float3 dy = ddy(v);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
float luminance(float4 color)
{
    return dot(color.xyz, float3(0.2126, 0.7152, 0.0722));
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
float3x3 axes_around(float3 toward, float3 up)
{
    float3 leaning = cross(up, toward);
    float square = dot(leaning, leaning);
    float3 aside = abs(toward.x) > 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0);
    float3 across = square > 1e-8 ? leaning : cross(aside, toward);
    const float3 x = normalize_moderate(across - dot(across, toward) * toward,
        float3(1.0, 0.0, 0.0));
    return float3x3(x, cross(toward, x), toward);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + (below.xyz + tone * color.xyz - below.xyz), 1.0), (0.0).xxxx,
        (1.0).xxxx);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
float3x3 axes_turned(float3 toward, float spin)
{
    const float3x3 axes = axes_around(toward, float3(0.0, 1.0, 0.0));
    float2 turn = float2(0.0, 1.0);
    return float3x3(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
float3x3 axes_turned_2(float3 toward, float spin)
{
    const float3x3 axes = axes_around(toward, float3(0.0, 1.0, 0.0));
    float2 turn = clamp(sin_cos_eighth(spin - 0.0 - 0.0 - 0.0), (-1.0).xx, (1.0).xx);
    return float3x3(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// A place as seen from a center along axes, within a million of it.
float3 place_along(float3 place, float3 center_, float3x3 axes)
{
    float3 away = clamp(place - center_, (-1000000.0).xxx, (1000000.0).xxx);
    return float3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

/// The share of a light that passes a shape at distance m, 1 on its surface, in sizes of the shape:
/// its edge is `softness` wide outward, and never narrower than a pixel. Call it in uniform control
/// flow.
float share_beside(float m, float softness, float density, bool inverted)
{
    float near = min(m, FAR_FROM_SHAPE);
    float half_ = 0.5 * min(footprint_of(near), 0.25);
    const float beside = eased(near, 1.0 - half_, 1.0 + half_);
    return 1.0 - beside;
}

/// The share of a lamp's light that passes between four flaps, for a place as the lamp sees it and
/// the angles to the left, right, top and bottom flap.
float share_of_doors(float3 seen, float4 flaps, float softness)
{
    float2 angles = float2(angle_of_point(seen.x, seen.z), angle_of_point(seen.y, seen.z));
    float2 half_ = 0.5 * min(footprint_of_vec2(angles), (0.1).xx);
    float aside = (1.0 - smoothstep(flaps.x - half_.x, flaps.x + max(softness, half_.x),
        angles.x)) * (1.0 - smoothstep(flaps.y - half_.x, flaps.y + max(softness, half_.x),
        -angles.x));
    return aside * (1.0 - smoothstep(flaps.z - half_.y, flaps.z + max(softness, half_.y),
        angles.y)) * (1.0 - smoothstep(flaps.w - half_.y, flaps.w + max(softness, half_.y),
        -angles.y));
}

/// An angle as a filter before the profile leaves it: tan(u/2) over the share that passes, so that
/// the dark side grows from its edge as less passes, and everything is dark where nothing does.
Angle angle_filtered(Angle u, float share)
{
    float cosine = u.half_cos * share;
    float square = u.half_sin * u.half_sin + cosine * cosine;
    float scale = rsqrt(max(square, 1e-30));
    bool is_dark = square < 1e-30;
    return ConstructAngle(is_dark ? 1.0 : u.half_sin * scale, is_dark ? 0.0 : cosine * scale);
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
float light_fading(float distance_, float2 fading)
{
    float left = 1.0;

    if (fading.x > 0.0) {
        float d = min(distance_ / fading.x, 1000000000000000.0);
        left = 1.0 / (1.0 + d * d);
    }
    if (fading.y > 0.0) {
        float d_1 = min(distance_ / fading.y, 1.0);
        float window = max(1.0 - d_1 * d_1 * d_1 * d_1, 0.0);
        left = left * (window * window);
    }
    return left;
}

Light ConstructLight(float3 direction, float3 own_direction, float3 color, float intensity) {
    Light ret = (Light)0;
    ret.direction = direction;
    ret.own_direction = own_direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
Light light_at(float3 light_position, float3x3 own_from_world, float3 color, float intensity,
    float2 fading, float3 position)
{
    float3 offset = light_position - position;
    const float3 direction = normalize_or(offset, float3(0.0, 0.0, 1.0));
    float faded = intensity * light_fading(length(offset), fading);
    return ConstructLight(direction, mul(direction, own_from_world), color, faded);
}

/// Attenuation at an angle from a spot light's aim: smoothstep between the cosines `cone.y` (outer)
/// and `cone.x` (inner); a hard, inclusive edge where they are equal.
float light_cone(float cos_angle, float2 cone)
{
    if (cone.x <= cone.y) {
        return cos_angle >= cone.y ? 1.0 : 0.0;
    }
    float t = clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Light light_spot(float3 light_position, float3 aim, float3x3 own_from_world, float3 color,
    float intensity, float2 cone, float2 fading, float3 position)
{
    Light light = (Light)0;

    light = light_at(light_position, own_from_world, color, intensity, fading, position);
    light.intensity = light.intensity * light_cone(dot(-light.direction, aim), cone);
    return light;
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

PlaceInLight ConstructPlaceInLight(float2 uv, float inside) {
    PlaceInLight ret = (PlaceInLight)0;
    ret.uv = uv;
    ret.inside = inside;
    return ret;
}

PlaceInLight place_in_light(float2 at)
{
    float2 near = clamp(at, (-1000.0).xx, (1000.0).xx);
    const float inside = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    return ConstructPlaceInLight((0.5).xx + 0.5 * float2(-near.x, near.y), inside);
}

PlaceInLight light_place_point(float3 light_position, float angle, float spin, float3 toward,
    float3 position)
{
    const float3 seen = place_along(position, light_position, axes_turned_2(toward, spin));
    float2 turn = clamp(sin_cos_eighth(angle - 0.0 - 0.0 - 0.0), (-1.0).xx, (1.0).xx);
    float2 at = seen.xy * (turn.y / turn.x) / (max(seen.z, 0.001)).xx;
    return place_in_light(seen.z > 0.001 ? at : (1000.0).xx);
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

int3 to_int(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
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
    const float3 p = bounded_vec3(position * scale);
    const Cell cell = nearest_cell(p, 0u);
    float visible = 1.0 - smoothstep(0.5, 1.0, footprint_of_vec3(p));
    float3 average = float3(0.1301, 0.5, 0.491);
    float3 seen = lerp(average, float3(cell.border, cell.random, cell.distance_), visible);
    return ConstructCells(seen.x, seen.y, seen.z);
}

FilteredLight ConstructFilteredLight(Light light, Angle angle) {
    FilteredLight ret = (FilteredLight)0;
    ret.light = light;
    ret.angle = angle;
    return ret;
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const Light lamp = light_spot(look.lamp_position, look.lamp_aim, look.lamp_own_from_world,
        look.lamp_color, look.lamp_intensity, look.lamp_cone, look.lamp_fading, surface.position);
    // Parametrization
    Angle angle = ConstructAngle(0.5 * length(surface.normal - lamp.direction), 0.5
        * length(surface.normal + lamp.direction));
    const float3 place_along_value = place_along(surface.position, look.lamp_position,
        axes_turned(look.lamp_aim, 0.0));
    // Barn doors
    const float doors = share_of_doors(place_along_value, float4(0.3, 0.36, 0.3, 0.2), 0.02);
    const PlaceInLight place = light_place_point(look.lamp_position, 0.4, 0.6, look.lamp_aim,
        surface.position);
    const Cells leaves = cells(float3(place.uv, 0.0), 13.0, int(0));
    // Combine filters
    float both = doors * smoothstep(0.12, 0.62, leaves.distance_);
    // Light filter
    FilteredLight filter_2 = ConstructFilteredLight(lamp,
        angle_filtered(angle, both * min(luminance((1.0).xxxx), 1.0)));
    const float tone = profile_balanced(filter_2.angle, 0.0, tone_shape);
    const LitLayer lit_ = light_apply(filter_2.light, float4(0.93, 0.62, 0.36, 1.0), tone);
    return blend_add(float4(0.13, 0.14, 0.27, 1.0), lit_.color, lit_.tone, 1.0, true);
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 position) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.position = position;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_5, input.normal_1 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, in_.position);
    return shade(surface);
}
