// Light that wavers: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// bent-light.json says what to put there and how to draw.

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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light eye;
    Light key;
    float3 parts_direction;
    int _pad4_0;
    float3 axes_of_the_light_x_axis;
    int _pad5_0;
    float3 axes_of_the_light_y_axis;
    int _end_pad_0;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
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

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    float3 direction;
    float3 x_axis;
    float3 y_axis;
    /// The direction's cosines with the two axes.
    float2 place;
};

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    float3 x_axis;
    /// Unit, upright.
    float3 y_axis;
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

static const uint NOISE_PERLIN = 1u;
static const ProfileShape lit_shape = {0.8253356, 0.5646425, 25.006668, 1.7790966, 1.2, 0.04446849,
    0.018017149, 0u};
static const ProfileShape brightest_shape = {0.9358968, 0.35227424, 40.004166, 3.6241908, 0.72,
    0.021168118, 0.009611014, 0u};
static const ProfileShape window_shape = {0.9963897, 0.08489768, 0.0, 1.0, 0.17, 0.0, 0.0, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position_2 : LOC0;
    float3 position_object : LOC1;
    float3 normal_1 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_3 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
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

DirectionParts ConstructDirectionParts(float3 direction, float3 x_axis, float3 y_axis,
    float2 place) {
    DirectionParts ret = (DirectionParts)0;
    ret.direction = direction;
    ret.x_axis = x_axis;
    ret.y_axis = y_axis;
    ret.place = place;
    return ret;
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
DirectionParts direction_within(float3 direction, float3 x_axis, float3 y_axis)
{
    float3 y = y_axis * rsqrt(max(dot(y_axis, y_axis), 1e-30));
    return ConstructDirectionParts(direction, x_axis, y,
        float2(dot(direction, x_axis), dot(direction, y)));
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
float3 direction_moved(DirectionParts parts, float2 by)
{
    float3 moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    const float3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return dot(moved, moved) > 1e-6 ? normalize_moderate_value : parts.direction;
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

AxesAround ConstructAxesAround(float3 x_axis, float3 y_axis) {
    AxesAround ret = (AxesAround)0;
    ret.x_axis = x_axis;
    ret.y_axis = y_axis;
    return ret;
}

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
AxesAround axes(float3 direction, float3 up)
{
    const float3x3 axes_2 = axes_around(direction, up);
    return ConstructAxesAround(axes_2[0], axes_2[1]);
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
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

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick_2(float s, float w, ProfileShape shape)
{
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
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

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
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
            octave = lerp(0.5, perlin_noise(place, 1u + uint(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return min(sum / 1.5, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise_2(uint kind, float3 p, int octaves, float roughness, int seed, float w)
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
            octave = lerp(0.5, perlin_noise(place, 5u + uint(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return min(sum / 1.5, 1.0);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(float width, float3 normal, float3 view, float2 viewport)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = width * clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance_ = facing / max(2.0 * footprint_of(facing), 1e-6);
    float near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * near;
}

float noise_perlin(float3 position, float scale, int octaves, float roughness, int seed)
{
    float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

float noise_perlin_2(float3 position, float scale, int octaves, float roughness, int seed)
{
    float3 p = position * scale;
    return fractal_noise_2(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

Light ConstructLight(float3 direction, float3 own_direction, float3 color, float intensity) {
    Light ret = (Light)0;
    ret.direction = direction;
    ret.own_direction = own_direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    float3 place = surface.position_object;
    const float waver_across = noise_perlin(place, 3.5, int(2), 0.5, int(1));
    float across = lerp(-0.22, 0.22, waver_across - 0.0);
    const float waver_upright = noise_perlin_2(place, 3.5, int(2), 0.5, int(5));
    float upright = lerp(-0.22, 0.22, waver_upright - 0.0);
    const DirectionParts direction_within_value = direction_within(look.parts_direction,
        look.axes_of_the_light_x_axis, look.axes_of_the_light_y_axis);
    // Shift direction
    const float3 bend = direction_moved(direction_within_value, float2(across, upright));
    // Light toward
    Light bent_light = ConstructLight(bend, look.key.own_direction, look.key.color,
        look.key.intensity);
    // Parametrization
    Angle turned_from_it = ConstructAngle(0.5 * length(surface.normal - bent_light.direction), 0.5
        * length(surface.normal + bent_light.direction));
    const float lit_ = profile_balanced(turned_from_it, 0.0, lit_shape);
    const float4 light = blend_alpha(float4(0.1529, 0.251, 0.3765, 1.0),
        float4(0.3098, 0.5608, 0.6118, 1.0), lit_, 1.0, true);
    const float brightest = profile_balanced(turned_from_it, 0.0, brightest_shape);
    // Blend
    float4 brightest_light = min(float4(light.xyz + brightest
        * (float3(0.6627, 0.8392, 0.7569) - light.xyz), 1.0), (1.0).xxxx);
    float3 view_2 = surface.view;
    const AxesAround axes_of_the_view = axes(view_2, float3(0.0, 1.0, 0.0));
    // Shift direction
    const float3 up_and_left_of_the_eye = direction_moved(direction_within(view_2,
        axes_of_the_view.x_axis, axes_of_the_view.y_axis), float2(-0.32, 0.36));
    // Light toward
    Light locked_to_the_eye = ConstructLight(up_and_left_of_the_eye, look.eye.own_direction,
        look.eye.color, look.eye.intensity);
    // Parametrization
    Angle turned_from_the_eye = ConstructAngle(0.5
        * length(surface.normal - locked_to_the_eye.direction), 0.5
        * length(surface.normal + locked_to_the_eye.direction));
    const float window = profile_balanced_2(turned_from_the_eye, 0.0, window_shape);
    // Blend
    float4 window_on_top = clamp(float4(brightest_light.xyz + window
        * (float3(0.9922, 0.9647, 0.8902) - brightest_light.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float line_ = outer_contour(3.0, surface.normal, surface.view, look.viewport);
    // Blend
    float4 outline = clamp(float4(window_on_top.xyz + line_
        * (float3(0.0784, 0.1294, 0.2275) - window_on_top.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
    return outline;
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

Surface ConstructSurface(float3 normal, float3 view, float3 position_object) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_3, input.position_object_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object);
    return shade(surface);
}
