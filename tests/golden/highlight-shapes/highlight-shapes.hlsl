// Highlight shapes: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// highlight-shapes.json says what to put there and how to draw.

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
    Light spark;
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
    float3 normal : LOC1;
};

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2 = 0.6931472;
static const float LOG2_E = 1.442695;
static const ProfileShape shadow_side_shape = {0.7484994, 0.66313547, 0.0, 1.0, 1.45, 0.0, 0.0, 1u};
static const ProfileShape window_shape = {0.99804753, 0.062459316, 0.0, 1.0, 0.125, 0.0, 0.0, 1u};
static const ProfileShape spark_shape = {0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u};

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

/// `accept` where the condition holds, else `reject`, component by component.
float2 choose(bool2 condition, float2 accept, float2 reject)
{
    return float2(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y);
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

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
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

/// ln(x) for normal x > 0.
float log_stable(float x)
{
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y)
{
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(float y)
{
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.1754944e-38));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
float2 sin_cos_quarter(float x)
{
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (2.7557319e-6 + h2 * -2.5052108e-8)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-2.4801588e-5 + h2 * (2.755732e-7 + h2 * -2.0876756e-9)))));
    float c = 1.0 - one_minus_c;
    return float2(2.0 * s * c, 1.0 - 2.0 * s * s);
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

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
Angle angle_of(float radians_)
{
    float half_angle = 0.5 * min(radians_, PI);
    const float2 sc = sin_cos_quarter(half_angle);
    return ConstructAngle(max(sc.x, 0.0), max(sc.y, 0.0));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, float2 t)
{
    float s = u.half_sin - 0.0;
    float2 upper = u.half_cos <= 0.0 ? float2(1.0, 0.0) : float2(s, u.half_cos);
    float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? float2(0.0, 1.0) : upper;
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
    return sqrt(dot(d, d));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
float3 any_orthogonal(float3 n)
{
    float sign_ = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign_ + n.z);
    return float3(1.0 + sign_ * n.x * n.x * a, sign_ * n.x * n.y * a, -sign_ * n.x);
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

/// Radius of a star at `turn`, in turns from its first ray: 1 at its rays, `inner` between them,
/// along straight lines; `round` from 0 to 1 goes from there to a circle.
float star_reach(float turn, float rays, float inner, float round_)
{
    float half_sector = PI / rays;
    float sector = abs(turn * rays - floor(turn * rays + 0.5));
    const float2 from_ray = sin_cos_quarter(min(2.0 * sector * half_sector, HALF_PI));
    const float2 between = sin_cos_quarter(max((1.0 - 2.0 * sector) * half_sector, 0.0));
    float corner = sin_cos_quarter(half_sector).x;
    float straight = inner * corner / max(inner * between.x + from_ray.x, 1e-6);
    return lerp(straight, 1.0, round_);
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

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
float3 half_vector(Light light, float3 view)
{
    float3 half_ = light.direction + view;
    const float3 any_orthogonal_value = any_orthogonal(view);
    return normalize_or(dot(half_, half_) > 1e-12 ? half_ : any_orthogonal_value, view);
}

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
float3 split_direction(float3 direction, float3 x_axis, float3 y_axis, float x, float y)
{
    const DirectionParts bent = direction_within(direction, x_axis, y_axis);
    const float2 side = choose(bent.place >= (0.0).xx, (1.0).xx, (-1.0).xx);
    return direction_moved(bent, -float2(x, y) * side);
}

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
float3 square_direction(float3 direction, float3 x_axis, float3 y_axis, float amount,
    float sharpness)
{
    const DirectionParts bent = direction_within(direction, x_axis, y_axis);
    float square = dot(bent.place, bent.place);
    float apart = abs(bent.place.x) - abs(bent.place.y);
    float aside = min(apart * apart / max(square, 1e-20), 1.0);
    const float exp2_stable_value = exp2_stable(sharpness * LOG2_E * log1p_negative(aside));
    float corner = ((square > 1e-20) & (aside < 1.0)) ? exp2_stable_value : 0.0;
    return direction_moved(bent, -amount * corner * bent.place);
}

/// Star
///
/// The angle between two directions, measured so that a Profile draws a star, a flower or a polygon
/// instead of a disk: in between its rays the angle counts for more.
Angle star_angle(float3 direction, float3 middle, float3 x_axis, float3 y_axis, int rays,
    float inner, float round_, float turn)
{
    const DirectionParts bent = direction_within(direction, x_axis, y_axis);
    Angle u = ConstructAngle(0.5 * length(bent.direction - middle), 0.5
        * length(bent.direction + middle));
    float around = (angle_of_point(bent.place.y, bent.place.x) - turn) / 6.2831855;
    const float reach = star_reach(around, 4.0, inner, round_);
    return angle_of(2.0 * atan2_positive(u.half_sin, u.half_cos) / reach);
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of(facing), 1.0));
    float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    float3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * rsqrt(max(dot(across, across), 1e-30)));
    return inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Parametrization
    Angle turned_from_the_key = ConstructAngle(0.5 * length(surface.normal - look.key.direction),
        0.5 * length(surface.normal + look.key.direction));
    const float shadow_side = profile_balanced(turned_from_the_key, 0.0, shadow_side_shape);
    float in_the_dark = 1.0 - shadow_side;
    // Blend
    float4 shadow = min(float4(float3(0.83, 0.19, 0.18)
        * lerp((1.0).xxx, float3(0.52, 0.25, 0.46), in_the_dark), 1.0), (1.0).xxxx);
    const float3 half_ = half_vector(look.key, surface.view);
    const AxesAround upright = axes(half_, float3(0.0, 1.0, 0.0));
    const float3 four_panes = split_direction(surface.normal, upright.x_axis, upright.y_axis, 0.15,
        0.15);
    const float3 square_it = square_direction(four_panes, upright.x_axis, upright.y_axis, 0.3, 4.0);
    // Angle between directions
    Angle window_angle = ConstructAngle(0.5 * length(square_it - half_), 0.5
        * length(square_it + half_));
    const float window = profile_balanced_2(window_angle, 0.0, window_shape);
    const float4 window_s_light = blend_alpha(shadow, float4(1.0, 0.97, 0.9, 1.0), window, 0.95,
        true);
    const float3 spark_half = half_vector(look.spark, surface.view);
    const AxesAround upright_2 = axes(spark_half, float3(0.0, 1.0, 0.0));
    const Angle four_rays = star_angle(surface.normal, spark_half, upright_2.x_axis,
        upright_2.y_axis, int(4), 0.28, 0.0, 0.3);
    const float spark = profile_balanced_2(four_rays, 0.0, spark_shape);
    // Blend
    float4 spark_s_light = clamp(float4(window_s_light.xyz + spark
        * (float3(1.0, 0.83, 0.42) - window_s_light.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float rim_2 = rim(look.back, surface.normal, surface.view, 0.38, 0.15, 1.0);
    // Blend
    float4 rim_s_light = clamp(float4(spark_s_light.xyz + 0.75
        * (spark_s_light.xyz + rim_2 * float3(0.55, 0.72, 1.0) - spark_s_light.xyz), 1.0),
        (0.0).xxxx, (1.0).xxxx);
    return rim_s_light;
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
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position));
    return shade(surface);
}
