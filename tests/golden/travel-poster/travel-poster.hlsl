// Travel poster: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// travel-poster.json says what to put there and how to draw.

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
    Light sky;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float kappa;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
};

static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape evening_sun_tone_shape = {1.0, 0.0, 1.0955735, 1.6395584, 0.0, 1.1385497,
    0.5052584, 0u};
static const ProfileShape sky_tone_shape = {1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705,
    0.44442755, 0u};
static const ProfileShape glow_tone_shape = {0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1,
    0.4039123, 0.17722374, 0u};
static const Ramp seven_inks = {{float4(0.0863, 0.1333, 0.2471, 1.0),
    float4(0.1725, 0.3176, 0.3882, 1.0), float4(0.4863, 0.2275, 0.2706, 1.0),
    float4(0.7686, 0.3294, 0.2471, 1.0), float4(0.8784, 0.5412, 0.298, 1.0),
    float4(0.9412, 0.7608, 0.4824, 1.0), float4(0.9843, 0.9333, 0.7961, 1.0), (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.15, 0.3, 0.45), float4(0.6, 0.8, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx}, 7u, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float whole = round(x);
    float f = x - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable_2(float x)
{
    float clamped = max(x, -126.0);
    float whole = round(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
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

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y)
{
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
float2 sin_cos_tiny(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666667 + y * 0.008333334));
    float c = 1.0 - y * (0.5 + y * (-0.041666668 + y * 0.0013888889));
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
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, float2 t)
{
    float s = u.half_sin - 0.0;
    float2 upper = u.half_cos <= 0.0 ? float2(1.0, 0.0) : float2(s, u.half_cos);
    float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
}

/// base^exponent for every pair. A negative base is raised as in algebra by a whole exponent and
/// keeps its sign with any other, so that (-4)^0.5 is -2. 0 to a negative power is 0, as division
/// by 0 is; 0^0 is 1.
float powered(float base, float exponent)
{
    float magnitude = abs(base);
    const float raised = exp2_stable(exponent * log2_stable(max(magnitude, SMALLEST_NORMAL)));
    return magnitude < SMALLEST_NORMAL ? 0.0 : raised;
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
    float stair = min(floor(inside), 6.0);
    float beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 6.0;
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
        float edge = clamp(round(x), 1.0, 6.0);
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
    const float exp2_stable_value = exp2_stable(2.4 * log2_stable((size + 0.055) / 1.055));
    float value = size <= 0.04045 ? size / 12.92 : exp2_stable_value;
    return value;
}

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
float linear_of_srgb_2(float coded)
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
    const float powered_value = powered(size, 0.41666666);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * powered_value - 0.055;
    return light < 0.0 ? -value : value;
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
float3 oklab_of_linear(float3 rgb)
{
    const float l = powered(abs(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    const float m = powered(abs(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    const float s = powered(abs(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return float3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l - 2.4285922 * m
        + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
float3 oklab_of_linear_2(float3 rgb)
{
    float l = pow(abs(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995))), 0.33333334);
    float m = pow(abs(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696))), 0.33333334);
    float s = pow(abs(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787))), 0.33333334);
    return float3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l - 2.4285922 * m
        + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
float3 oklab_of_linear_3(float3 rgb)
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
    const float3 oklab_of_linear_3_value = oklab_of_linear_3(float3(pow((coded.x + 0.055) / 1.055,
        2.4), pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_3_value;
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
float3 srgb_of_oklab(float3 lab)
{
    const float3 light = linear_of_oklab(lab);
    return float3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// The color of a palette (the stops of a ramp) that is nearest to `rgb` in Oklab, alone or blended
/// there with the colors that are up to `softness` farther. Black for a palette without colors.
float3 palette_blend(Ramp palette, float3 rgb, float softness)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float3 found = (0.0).xxx;
    float nearest = 1e30;

    colors = palette.colors;
    const float3 wanted = oklab_of_linear_2(float3(linear_of_srgb_2(rgb.x), linear_of_srgb_2(rgb.y),
        linear_of_srgb_2(rgb.z)));
    for (uint i = 0u; i < 7u; i++) {
        const float3 lab = oklab_of_srgb(colors[min(uint(i), 15u)].xyz);
        float far = min(length(lab - wanted), 1e29);
        float4 colors_now = colors[min(uint(i), 15u)];
        found = far < nearest ? colors_now.xyz : found;
        nearest = min(nearest, far);
    }
    return found;
}

/// Posterize
///
/// Reduces a color to a few steps, as screen prints and old posters do. By lightness the hue stays
/// and only light and dark are cut, in steps that look even; by channel the hue shifts too, which
/// is the look of early computers.
float4 posterize_lightness(float4 color, int steps, float softness)
{
    const float3 lab = oklab_of_linear(float3(linear_of_srgb(color.x), linear_of_srgb(color.y),
        linear_of_srgb(color.z)));
    const float stairs_filtered_value = stairs_filtered(7.0 * clamp(lab.x, 0.0, 1.0), 7.0,
        length(float2(7.0 * footprint_of(lab.x), softness)));
    float stepped = clamp(stairs_filtered_value / 6.0, 0.0, 1.0);
    float kept = lab.x > 0.0001 ? stepped / max(lab.x, 0.0001) : 0.0;
    return float4(clamp(srgb_of_oklab(float3(stepped, lab.yz * min(kept, 1.0))), (0.0).xxx,
        (1.0).xxx), 1.0);
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return concave + convexity * (convex - concave);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + tone * color.xyz, 1.0), (0.0).xxxx, (1.0).xxxx);
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

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
float profile_power(float q, float exponent)
{
    float log_base = 0.0;

    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return min(exp2_stable(exponent * log_base), 1.0);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
float profile_point(Angle u, ProfileShape shape)
{
    float s = u.half_sin - u.half_cos * 0.0;
    if (s <= 0.0) {
        return 1.0;
    }
    float q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
float profile_point_2(Angle u, ProfileShape shape)
{
    float s = u.half_sin - 0.0;
    if (s <= 0.0) {
        return 1.0;
    }
    float q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
float profile_power_2(float q, float exponent)
{
    float log_base = 0.0;

    if (q >= 1.0) {
        return 0.0;
    }
    if (q < 0.5) {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return min(exp2_stable_2(exponent * log_base), 1.0);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
float profile_point_3(Angle u, ProfileShape shape)
{
    float s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if (s <= 0.0) {
        return 1.0;
    }
    float q = s * shape.scale;
    return profile_power_2(q, shape.exponent);
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
float profile_filtered(Angle u, float w, ProfileShape shape)
{
    const float point_ = profile_point(u, shape);
    bool is_wide = w < 0.1 * shape.edge_deviation;
    if (is_wide | (w <= 0.0)) {
        return point_;
    }
    const float2 reach = sin_cos_tiny(0.19364917 * w);
    const float before = profile_point(angle_turned(u, reach), shape);
    const float after = profile_point(angle_turned(u, float2(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
float profile_filtered_2(Angle u, float w, ProfileShape shape)
{
    const float point_ = profile_point_2(u, shape);
    bool is_wide = w < 0.1 * shape.edge_deviation;
    if (is_wide | (w <= 0.0)) {
        return point_;
    }
    const float2 reach = sin_cos_tiny(0.19364917 * w);
    const float before = profile_point_2(angle_turned(u, reach), shape);
    const float after = profile_point(angle_turned(u, float2(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
float profile_filtered_3(Angle u, float w, ProfileShape shape)
{
    const float point_ = profile_point_3(u, shape);
    bool is_wide = w < 0.1 * shape.edge_deviation;
    if (is_wide | (w <= 0.0)) {
        return point_;
    }
    const float2 reach = sin_cos_tiny(0.19364917 * w);
    const float before = profile_point_3(angle_turned(u, reach), shape);
    const float after = profile_point_3(angle_turned(u, float2(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
float profile(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, sin_cos_tiny(0.5 * shift));
    return profile_filtered(warped, angle_footprint(warped), shape);
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
float profile_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    return profile_filtered_2(warped, angle_footprint(warped), shape);
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
float profile_3(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    return profile_filtered_3(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Evening sun (Light layer)
    float evening_sun_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.12, -20.0, 20.0))));
    const float4 evening_sun_color = curvature_color(evening_sun_convexity,
        float4(0.93, 0.62, 0.36, 1.0), float4(0.66, 0.24, 0.24, 1.0));
    Angle evening_sun_angle = ConstructAngle(0.5 * length(surface.normal - look.key.direction),
        0.5 * length(surface.normal + look.key.direction));
    float evening_sun_warp = (2.0 * evening_sun_convexity - 1.0) * 0.1;
    const float evening_sun_tone = profile(evening_sun_angle, evening_sun_warp,
        evening_sun_tone_shape);
    const LitLayer evening_sun_lit = light_apply(look.key, evening_sun_color, evening_sun_tone);
    const float4 evening_sun_blend = blend_add(float4(0.07, 0.1, 0.22, 1.0), evening_sun_lit.color,
        evening_sun_lit.tone, 1.0, true);

    // Sky (Light layer)
    Angle sky_angle = ConstructAngle(0.5 * length(surface.normal - look.sky.direction), 0.5
        * length(surface.normal + look.sky.direction));
    const float sky_tone = profile_2(sky_angle, 0.0, sky_tone_shape);
    const LitLayer sky_lit = light_apply(look.sky, float4(0.02, 0.24, 0.3, 1.0), sky_tone);
    const float4 sky_blend = blend_add(evening_sun_blend, sky_lit.color, sky_lit.tone, 1.0, true);

    // Glow (Light layer)
    const Angle glow_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    const float glow_tone = profile_3(glow_angle, 0.0, glow_tone_shape);
    const LitLayer glow_lit = light_apply(look.key, float4(0.42, 0.38, 0.24, 1.0), glow_tone);
    const float4 glow_blend = blend_add(sky_blend, glow_lit.color, glow_lit.tone, 1.0, true);

    const float4 seven_lightnesses = posterize_lightness(glow_blend, int(7), 0.02);
    float4 seven_inks_2 = float4(palette_blend(seven_inks, seven_lightnesses.xyz, 0.0), 1.0);
    return seven_inks_2;
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

Surface ConstructSurface(float3 normal, float3 view, float kappa) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.kappa = kappa;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        texel.x);
    return shade(surface);
}
