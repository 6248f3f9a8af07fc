// Film print: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// film-print.json says what to put there and how to draw.

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
    Light back;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    float4 points[16];
    /// Number of points that count.
    uint count;
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
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
static const ProfileShape tone_shape = {1.0, 0.0, 1.0248806, 0.99999666, 0.0, 1.5064107, 0.63535863,
    0u};
static const Curve response_of_the_film = {{float4(0.0, 0.0, 0.2, 0.0),
    float4(0.3, 0.06, 0.36, 0.0), float4(0.5, 0.42, 0.972973, 0.0),
    float4(0.62, 0.5, 1.0256411, 0.0), float4(0.8, 0.9, 0.81632656, 0.0),
    float4(1.0, 1.0, 0.5, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 6u, 1u};
static const ProfileShape sheen_tone_shape = {0.9996875, 0.024997396, 3.1317647, 2.7420828, 0.05,
    0.3043368, 0.13399889, 0u};
static const ProfileShape back_light_tone_shape = {0.9689124, 0.24740396, 4.0419726, 1.8505588, 0.5,
    0.27256957, 0.11186968, 0u};
static const Curve film_print = {{float4(0.0, 0.04, 0.64, 0.0), float4(0.25, 0.2, 0.8608187, 0.0),
    float4(0.6, 0.66, 0.97504276, 0.0), float4(1.0, 0.97, 0.775, 0.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx}, 4u, 1u};
static const Curve film_print_2 = {{float4(0.0, 0.0, 0.73333335, 0.0),
    float4(0.3, 0.22, 0.99215686, 0.0), float4(0.6, 0.68, 1.0514286, 0.0),
    float4(1.0, 1.0, 0.8, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 4u, 1u};
static const Curve film_print_3 = {{float4(0.0, 0.06, 0.8333333, 0.0),
    float4(0.3, 0.31, 0.8805031, 0.0), float4(0.6, 0.59, 0.91636366, 0.0),
    float4(1.0, 0.95, 0.9, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 4u, 1u};
static const Curve film_print_4 = {{float4(0.0, 0.13, 0.8, 0.0), float4(0.3, 0.37, 0.53333336, 0.0),
    float4(0.6, 0.49, 0.51555556, 0.0), float4(1.0, 0.78, 0.725, 0.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx}, 4u, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

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
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + u.half_sin * 0.0;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_3(Angle u, float2 t)
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

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
float curve_at(Curve curve, float x, float w)
{
    float4 points[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    uint at = 0u;

    points = curve.points;
    for (uint i_2 = 1u; i_2 < 6u; i_2++) {
        float points_now = points[min(uint(i_2), 15u)].x;
        at = points_now <= x ? i_2 : at;
    }
    float4 a = points[min(uint(at), 15u)];
    if ((at + 1u >= 6u) | (x <= a.x)) {
        return a.y;
    }
    float4 b = points[min(uint(at + 1u), 15u)];
    float t = clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    return hermite((a.y).xxxx, (b.y).xxxx, (b.x - a.x) * (a.z).xxxx, (b.x - a.x) * (b.z).xxxx, t).x;
}

/// The curve's y at x; the steps of a stepped curve are averaged over a footprint of `w`. 0 for a
/// curve without points.
float curve_at_2(Curve curve, float x, float w)
{
    float4 points[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    uint at = 0u;

    points = curve.points;
    for (uint i_2 = 1u; i_2 < 4u; i_2++) {
        float points_now = points[min(uint(i_2), 15u)].x;
        at = points_now <= x ? i_2 : at;
    }
    float4 a = points[min(uint(at), 15u)];
    if ((at + 1u >= 4u) | (x <= a.x)) {
        return a.y;
    }
    float4 b = points[min(uint(at + 1u), 15u)];
    float t = clamp(divided(x - a.x, b.x - a.x), 0.0, 1.0);
    return hermite((a.y).xxxx, (b.y).xxxx, (b.x - a.x) * (a.z).xxxx, (b.x - a.x) * (b.z).xxxx, t).x;
}

/// Color curves
///
/// Redraws a color's channels along curves, one for all of them and then one for each: contrast,
/// film looks, split toning.
float4 color_curves(float4 color, Curve all_, Curve red, Curve green, Curve blue)
{
    float3 w = float3(footprint_of(color.x), footprint_of(color.y), footprint_of(color.z));
    const float r = curve_at_2(all_, color.x, w.x);
    const float g = curve_at_2(all_, color.y, w.y);
    const float b = curve_at_2(all_, color.z, w.z);
    return float4(curve_at_2(red, r, w.x), curve_at_2(green, g, w.y), curve_at_2(blue, b, w.z),
        1.0);
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
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

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
float profile(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    return profile_filtered(warped, angle_footprint(warped), shape);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_3(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Parametrization
    Angle turned_from_the_key = ConstructAngle(0.5 * length(surface.normal - look.key.direction),
        0.5 * length(surface.normal + look.key.direction));
    const float tone = profile(turned_from_the_key, 0.0, tone_shape);
    const float response_of_the_film_2 = curve_at(response_of_the_film, tone, footprint_of(tone));
    // Blend
    float body_tone = clamp(response_of_the_film_2, 0.0, 1.0);
    const float4 body = blend_alpha(float4(0.1216, 0.1137, 0.1333, 1.0),
        float4(0.7765, 0.7137, 0.6392, 1.0), body_tone, 1.0, true);

    // Sheen (Light layer)
    const Angle sheen_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    const float sheen_tone = profile_balanced(sheen_angle, 0.0, sheen_tone_shape);
    const LitLayer sheen_lit = light_apply(look.key, float4(0.3725, 0.3451, 0.298, 1.0),
        sheen_tone);
    float4 sheen_blend = clamp(float4(body.xyz + sheen_lit.tone * sheen_lit.color.xyz, 1.0),
        (0.0).xxxx, (1.0).xxxx);

    // Back-light (Light layer)
    Angle back_light_angle = ConstructAngle(0.5 * length(surface.normal - look.back.direction),
        0.5 * length(surface.normal + look.back.direction));
    const float back_light_tone = profile_balanced(back_light_angle, 0.0, back_light_tone_shape);
    const LitLayer back_light_lit = light_apply(look.back, float4(0.498, 0.5255, 0.549, 1.0),
        back_light_tone);
    float4 back_light_blend = clamp(float4(sheen_blend.xyz + back_light_lit.tone
        * back_light_lit.color.xyz, 1.0), (0.0).xxxx, (1.0).xxxx);

    const float4 film_print_5 = color_curves(back_light_blend, film_print, film_print_2,
        film_print_3, film_print_4);
    return film_print_5;
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

Surface ConstructSurface(float3 normal, float3 view) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position));
    return shade(surface);
}
