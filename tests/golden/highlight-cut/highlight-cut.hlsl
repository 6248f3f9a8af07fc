// Highlights, cut and joined: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// highlight-cut.json says what to put there and how to draw.

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

static const ProfileShape lit_side_shape = {0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25,
    0.17004733, 0.08138281, 0u};
static const ProfileShape disc_shape = {0.9855848, 0.16918235, 0.0, 1.0, 0.34, 0.0, 0.0, 1u};
static const ProfileShape bite_shape = {0.9887711, 0.14943813, 0.0, 1.0, 0.3, 0.0, 0.0, 1u};
static const ProfileShape dot_shape = {0.99875027, 0.04997917, 0.0, 1.0, 0.1, 0.0, 0.0, 1u};

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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, float2 t)
{
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + u.half_sin * 0.0;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
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

/// Angle between directions
///
/// The angle that a Profile turns into a tone, between any two directions: a bent half-vector and
/// the normal, a hair's tangent and a light.
Angle angle_between_directions(float3 a, float3 b)
{
    return ConstructAngle(0.5 * length(a - b), 0.5 * length(a + b));
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

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
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
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
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
    const float lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = 1.0 - lit_side;
    // Blend
    float4 shadow = float4(float3(0.62, 0.16, 0.26)
        * lerp((1.0).xxx, float3(0.5, 0.33, 0.56), in_the_dark), 1.0);
    float3 normal = surface.normal;
    const float3 half_ = half_vector(look.key, surface.view);
    const Angle from_the_highlight = angle_between_directions(normal, half_);
    const float disc = profile_balanced_2(from_the_highlight, 0.0, disc_shape);
    const AxesAround upright = axes(half_, float3(0.0, 1.0, 0.0));
    // Shift direction
    const float3 aside = direction_moved(direction_within(normal, upright.x_axis, upright.y_axis),
        float2(-0.13, 0.13));
    const Angle from_beside_it = angle_between_directions(aside, half_);
    const float bite = profile_balanced_2(from_beside_it, 0.0, bite_shape);
    // Combine tones
    float crescent = min(disc, 1.0 - bite);
    // Shift direction
    const float3 dot_s_place = direction_moved(direction_within(normal, upright.x_axis,
        upright.y_axis), float2(-0.06, 0.06));
    const Angle from_the_dot = angle_between_directions(dot_s_place, half_);
    const float dot_2 = profile_balanced_2(from_the_dot, 0.0, dot_shape);
    // Combine tones
    float crescent_and_dot = max(crescent, dot_2);
    const float4 highlight_on_top = blend_alpha(shadow, float4(1.0, 0.97, 0.9, 1.0),
        crescent_and_dot, 0.96, true);
    const float rim_2 = rim(look.back, surface.normal, surface.view, 0.42, 0.08, 1.0);
    // Combine tones
    float rim_in_the_dark_only = min(rim_2, in_the_dark);
    // Blend
    float4 rim_s_light = clamp(float4(highlight_on_top.xyz + 0.6
        * (highlight_on_top.xyz + rim_in_the_dark_only * float3(1.0, 0.62, 0.5)
        - highlight_on_top.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
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
