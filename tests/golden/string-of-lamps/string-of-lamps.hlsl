// A string of lamps: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// string-of-lamps.json says what to put there and how to draw.

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

/// What differs from light to light.
struct EachLight {
    row_major float3x3 own_from_world;
    int _pad1_0;
    float3 color;
    float intensity;
    float3 position;
    int _pad4_0;
    float2 fading;
    int _end_pad_0;
    int _end_pad_1;
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
    Light moon;
    EachLight lights[36];
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

struct LightParts {
    /// Unit, toward the light, world space.
    float3 direction;
    /// The light's color, opaque.
    float4 color;
    /// With the light's distance and cone attenuation; 0 or more.
    float intensity;
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
    float3 normal : LOC1;
};

static const ProfileShape lamps_tone_shape = {0.90044713, 0.43496552, 10.016686, 2.4912605, 0.9,
    0.09820393, 0.042312488, 0u};
static const ProfileShape moon_tone_shape = {0.90044713, 0.43496552, 2.9163208, 3.0838382, 0.9,
    0.3121117, 0.13987324, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

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
    float t = clamp(bounded((bounded(x) - low) / (high - low)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
float srgb_of_linear(float light)
{
    float size = abs(light);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * pow(size, 0.41666666) - 0.055;
    return light < 0.0 ? -value : value;
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
float3 oklab_of_linear(float3 rgb)
{
    float l = pow(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = pow(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return float3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l - 2.4285922 * m
        + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
float3 linear_of_oklab(float3 lab)
{
    float l = lab.x + 0.39633778 * lab.y + 0.21580376 * lab.z;
    float m = lab.x - 0.105561346 * lab.y - 0.06385417 * lab.z;
    float s = lab.x - 0.08948418 * lab.y - 1.2914855 * lab.z;
    float3 cubes = float3(l * l * l, m * m * m, s * s * s);
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)),
        dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)),
        dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
float3 oklab_of_srgb(float3 coded)
{
    const float3 oklab_of_linear_value = oklab_of_linear(float3(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
float3 srgb_of_oklab(float3 lab)
{
    const float3 light = linear_of_oklab(lab);
    return float3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
float4 limit_color(float4 color, float limit, float softness)
{
    float knee = 1.0 - softness;
    float brightest = max(max(color.x, color.y), color.z);
    if (brightest <= knee) {
        return float4(color.xyz, 1.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return float4(color.xyz * min(pressed / brightest, 1.0), 1.0);
}

/// Mix evenly
///
/// Goes from one color to another in steps that look even, without the gray or the dark that a
/// plain mix passes through.
float4 mix_evenly_oklab(float4 a, float4 b, float factor)
{
    const float3 srgb_of_oklab_value = srgb_of_oklab(lerp(oklab_of_srgb(a.xyz),
        oklab_of_srgb(b.xyz), factor));
    return factor <= 0.0 ? a : (factor >= 1.0 ? b : float4(srgb_of_oklab_value, 1.0));
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

LightParts ConstructLightParts(float3 direction, float4 color, float intensity) {
    LightParts ret = (LightParts)0;
    ret.direction = direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    float4 lamps_brightest = float4(0.0, 0.0, 0.0, 1.0);

    // For each light: lamp_1, lamp_2, lamp_3, lamp_4, lamp_5, lamp_6 and 30 more.
    for (uint each = 0u; each < 36u; each++) {
        // Lamps (Each lamp)
        const Light light = light_at(look.lights[each].position, look.lights[each].own_from_world,
            look.lights[each].color, look.lights[each].intensity, look.lights[each].fading,
            surface.position);
        LightParts light_2 = ConstructLightParts(light.direction, float4(light.color, 1.0),
            light.intensity);
        Angle lamps_angle = ConstructAngle(0.5 * length(surface.normal - light.direction), 0.5
            * length(surface.normal + light.direction));
        const float lamps_tone = profile_balanced(lamps_angle, 0.0, lamps_tone_shape);
        float lamps_bands = lerp(0.55, 1.0, eased(light_2.intensity, 0.5, 0.55));
        float lamps_reach = lamps_tone * (lamps_bands * eased(light_2.intensity, 0.2, 0.24));
        float4 lamps_lit = light_2.color * float4((lamps_reach).xxx, 1.0);
        lamps_brightest = light_2.intensity
            > 0.0 ? float4(max(lamps_brightest.xyz, lamps_lit.xyz), 1.0) : lamps_brightest;
    }

    // Parametrization
    Angle moon_angle = ConstructAngle(0.5 * length(surface.normal - look.moon.direction), 0.5
        * length(surface.normal + look.moon.direction));
    const float moon_tone = profile_balanced(moon_angle, 0.0, moon_tone_shape);
    const float4 dusk = mix_evenly_oklab(float4(0.07, 0.08, 0.16, 1.0), float4(0.2, 0.24, 0.4, 1.0),
        moon_tone);
    return limit_color(float4(lamps_brightest.xyz + dusk.xyz, 1.0), 1.0, 0.3);
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
    Varyings in_ = { input.clip_1, input.position_2, input.normal_1 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, in_.position);
    return shade(surface);
}
