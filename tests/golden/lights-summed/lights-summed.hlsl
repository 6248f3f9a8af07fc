// Ten lights, one edge after the sum: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// lights-summed.json says what to put there and how to draw.

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
    Light moon;
    float moon_intensity;
    int _pad2_0;
    int _pad2_1;
    int _pad2_2;
    Light violet;
    float violet_intensity;
    int _pad4_0;
    int _pad4_1;
    int _pad4_2;
    Light rose;
    float rose_intensity;
    int _pad6_0;
    int _pad6_1;
    int _pad6_2;
    Light amber;
    float amber_intensity;
    int _pad8_0;
    int _pad8_1;
    int _pad8_2;
    Light gold;
    float gold_intensity;
    int _pad10_0;
    int _pad10_1;
    int _pad10_2;
    Light coral;
    float coral_intensity;
    int _pad12_0;
    int _pad12_1;
    int _pad12_2;
    Light magenta;
    float magenta_intensity;
    int _pad14_0;
    int _pad14_1;
    int _pad14_2;
    Light cobalt;
    float cobalt_intensity;
    int _pad16_0;
    int _pad16_1;
    int _pad16_2;
    Light turquoise;
    float turquoise_intensity;
    int _pad18_0;
    int _pad18_1;
    int _pad18_2;
    Light azure;
    float azure_intensity;
    int _pad20_0;
    int _pad20_1;
    int _pad20_2;
    float4 lamps_moon_strength;
    float4 lamps_violet_strength;
    float4 lamps_rose_strength;
    float4 lamps_amber_strength;
    float4 lamps_gold_strength;
    float4 lamps_coral_strength;
    float4 lamps_magenta_strength;
    float4 lamps_cobalt_strength;
    float4 lamps_turquoise_strength;
    float4 lamps_azure_strength;
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
    float3 normal : LOC0;
};

static const ProfileShape lamps_moon_tone_shape = {1.0, 0.0, 1.6002629, 1.8073579, 0.0, 0.71386534,
    0.30130044, 0u};

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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral(float x, float count)
{
    float inside = min(x, count);
    float stair = min(floor(inside), 5.0);
    float beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 5.0;
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
        float edge = clamp(round(x), 1.0, 5.0);
        return edge - 1.0 + clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    float half_ = 0.5 * w;
    return (stairs_integral(x + half_, count) - stairs_integral_2(x - half_, count))
        / (2.0 * half_);
}

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
float linear_of_srgb(float coded)
{
    float size = abs(coded);
    float value = size <= 0.04045 ? size / 12.92 : pow((size + 0.055) / 1.055, 2.4);
    return value;
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
    float l = pow(abs(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = pow(abs(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s = pow(abs(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
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
        return float4(color.xyz, 2.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return float4(color.xyz * min(pressed / brightest, 1.0), 2.0);
}

/// Posterize
///
/// Reduces a color to a few steps, as screen prints and old posters do. By lightness the hue stays
/// and only light and dark are cut, in steps that look even; by channel the hue shifts too, which
/// is the look of early computers.
float4 posterize_lightness(float4 color, int steps, float softness)
{
    float3 coded = clamp(color.xyz, (0.0).xxx, (1.0).xxx);
    const float3 lab = oklab_of_linear(float3(linear_of_srgb(coded.x), linear_of_srgb(coded.y),
        linear_of_srgb(coded.z)));
    const float stairs_filtered_value = stairs_filtered(6.0 * clamp(lab.x, 0.0, 1.0), 6.0,
        length(float2(6.0 * footprint_of(lab.x), softness)));
    float stepped = clamp(stairs_filtered_value / 5.0, 0.0, 1.0);
    float kept = lab.x > 0.0001 ? stepped / max(lab.x, 0.0001) : 0.0;
    return float4(clamp(srgb_of_oklab(float3(stepped, lab.yz * min(kept, 1.0))), (0.0).xxx,
        (1.0).xxx), 2.0);
}

Angle parametrization_diffuse_balanced(Light light, float3 normal)
{
    return ConstructAngle(0.5 * length(normal - light.direction), 0.5
        * length(normal + light.direction));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin - 0.0, u.half_cos);
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

float4 sum_of_lights_color(float4 value, float4 before_sum, float reach)
{
    return reach > 0.0 ? float4(before_sum.xyz + value.xyz, 1.0) : before_sum;
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Lamps moon (Each lamp)
    const Angle lamps_moon_angle = parametrization_diffuse_balanced(look.moon, surface.normal);
    const float lamps_moon_tone = profile_balanced(lamps_moon_angle, 0.0, lamps_moon_tone_shape);
    float4 lamps_moon_lit = look.lamps_moon_strength * float4((lamps_moon_tone).xxx, 1.0);

    // Lamps violet (Each lamp)
    const Angle lamps_violet_angle = parametrization_diffuse_balanced(look.violet, surface.normal);
    const float lamps_violet_tone = profile_balanced(lamps_violet_angle, 0.0,
        lamps_moon_tone_shape);
    float4 lamps_violet_lit = look.lamps_violet_strength * float4((lamps_violet_tone).xxx, 1.0);

    // Lamps rose (Each lamp)
    const Angle lamps_rose_angle = parametrization_diffuse_balanced(look.rose, surface.normal);
    const float lamps_rose_tone = profile_balanced(lamps_rose_angle, 0.0, lamps_moon_tone_shape);
    float4 lamps_rose_lit = look.lamps_rose_strength * float4((lamps_rose_tone).xxx, 1.0);

    // Lamps amber (Each lamp)
    const Angle lamps_amber_angle = parametrization_diffuse_balanced(look.amber, surface.normal);
    const float lamps_amber_tone = profile_balanced(lamps_amber_angle, 0.0, lamps_moon_tone_shape);
    float4 lamps_amber_lit = look.lamps_amber_strength * float4((lamps_amber_tone).xxx, 1.0);

    // Lamps gold (Each lamp)
    const Angle lamps_gold_angle = parametrization_diffuse_balanced(look.gold, surface.normal);
    const float lamps_gold_tone = profile_balanced(lamps_gold_angle, 0.0, lamps_moon_tone_shape);
    float4 lamps_gold_lit = look.lamps_gold_strength * float4((lamps_gold_tone).xxx, 1.0);

    // Lamps coral (Each lamp)
    const Angle lamps_coral_angle = parametrization_diffuse_balanced(look.coral, surface.normal);
    const float lamps_coral_tone = profile_balanced(lamps_coral_angle, 0.0, lamps_moon_tone_shape);
    float4 lamps_coral_lit = look.lamps_coral_strength * float4((lamps_coral_tone).xxx, 1.0);

    // Lamps magenta (Each lamp)
    const Angle lamps_magenta_angle = parametrization_diffuse_balanced(look.magenta,
        surface.normal);
    const float lamps_magenta_tone = profile_balanced(lamps_magenta_angle, 0.0,
        lamps_moon_tone_shape);
    float4 lamps_magenta_lit = look.lamps_magenta_strength * float4((lamps_magenta_tone).xxx, 1.0);

    // Lamps cobalt (Each lamp)
    const Angle lamps_cobalt_angle = parametrization_diffuse_balanced(look.cobalt, surface.normal);
    const float lamps_cobalt_tone = profile_balanced(lamps_cobalt_angle, 0.0,
        lamps_moon_tone_shape);
    float4 lamps_cobalt_lit = look.lamps_cobalt_strength * float4((lamps_cobalt_tone).xxx, 1.0);

    // Lamps turquoise (Each lamp)
    const Angle lamps_turquoise_angle = parametrization_diffuse_balanced(look.turquoise,
        surface.normal);
    const float lamps_turquoise_tone = profile_balanced(lamps_turquoise_angle, 0.0,
        lamps_moon_tone_shape);
    float4 lamps_turquoise_lit = look.lamps_turquoise_strength
        * float4((lamps_turquoise_tone).xxx, 1.0);

    // Lamps azure (Each lamp)
    const Angle lamps_azure_angle = parametrization_diffuse_balanced(look.azure, surface.normal);
    const float lamps_azure_tone = profile_balanced(lamps_azure_angle, 0.0, lamps_moon_tone_shape);
    float4 lamps_azure_lit = look.lamps_azure_strength * float4((lamps_azure_tone).xxx, 1.0);
    float4 lamps_azure_sum = look.azure_intensity
        > 0.0 ? float4((0.0).xxx + lamps_azure_lit.xyz, 1.0) : float4(0.0, 0.0, 0.0, 1.0);

    // Lamps turquoise
    const float4 lamps_turquoise_sum = sum_of_lights_color(lamps_turquoise_lit, lamps_azure_sum,
        look.turquoise_intensity);

    // Lamps cobalt
    const float4 lamps_cobalt_sum = sum_of_lights_color(lamps_cobalt_lit, lamps_turquoise_sum,
        look.cobalt_intensity);

    // Lamps magenta
    const float4 lamps_magenta_sum = sum_of_lights_color(lamps_magenta_lit, lamps_cobalt_sum,
        look.magenta_intensity);

    // Lamps coral
    const float4 lamps_coral_sum = sum_of_lights_color(lamps_coral_lit, lamps_magenta_sum,
        look.coral_intensity);

    // Lamps gold
    const float4 lamps_gold_sum = sum_of_lights_color(lamps_gold_lit, lamps_coral_sum,
        look.gold_intensity);

    // Lamps amber
    const float4 lamps_amber_sum = sum_of_lights_color(lamps_amber_lit, lamps_gold_sum,
        look.amber_intensity);

    // Lamps rose
    const float4 lamps_rose_sum = sum_of_lights_color(lamps_rose_lit, lamps_amber_sum,
        look.rose_intensity);

    // Lamps violet
    const float4 lamps_violet_sum = sum_of_lights_color(lamps_violet_lit, lamps_rose_sum,
        look.violet_intensity);

    // Lamps moon
    const float4 lamps_moon_sum = sum_of_lights_color(lamps_moon_lit, lamps_violet_sum,
        look.moon_intensity);

    float4 dark = lamps_moon_sum * float4(0.44, 0.44, 0.44, 1.0) + float4(0.07, 0.05, 0.1, 1.0);
    const float4 limit = limit_color(posterize_lightness(dark, int(6), 0.04), 1.0, 0.4);
    return float4(limit.xyz, 1.0);
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
    return shade(surface);
}
