// Anime face: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// anime-face.json says what to put there and how to draw.

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
    Light eye;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light back;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_object;
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

struct VectorParts {
    /// The first number.
    float x;
    /// The second number.
    float y;
    /// The third number.
    float z;
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

static const ProfileShape edge_of_the_shadow_shape = {0.7960838, 0.6051864, 15.395454, 2.8429606,
    1.3, 0.060679536, 0.026670605, 0u};
static const ProfileShape lit_shape = {0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u};
static const ProfileShape shine_tone_shape = {0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0, 1u};
static const ProfileShape rim_light_tone_shape = {0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0, 0.0,
    1u};
static const ProfileShape contour_tone_shape = {0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 1e-30)) {
        return otherwise;
    }
    float3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    return (asuint(square) & 2139095040u) == 2139095040u ? otherwise : scaled
        * (1.0 / sqrt(square));
}

/// [`normalize_or`] for a third of its price: a vector shorter than 1e-15 or longer than 1e18
/// counts as having no direction.
float3 normalize_quick(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    bool is_usable = square > 1e-30;
    return is_usable ? v * rsqrt(is_usable ? square : 1.0) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
float2 sin_cos_quick(float x)
{
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 2.6347564e-6))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.477458e-5 - y * 2.6297516e-7))));
    return float2(s, c);
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

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
float4 curvature_color(float convexity, float4 convex, float4 concave)
{
    return concave + convexity * (convex - concave);
}

float transition_balanced(float kappa, float slope)
{
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(kappa * slope, -20.0, 20.0))));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_shade(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return min(float4(below.xyz + opacity
        * (below.xyz * lerp((1.0).xxx, color.xyz, tone) - below.xyz), 1.0), (1.0).xxxx);
}

float4 blend_shade_2(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz * lerp((1.0).xxx, color.xyz, tone) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
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
    return ConstructLitLayer(float4(color.xyz * light.color * split.y, 1.0), split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_2(Light light, float4 color, float tone)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return ConstructLitLayer(float4(light.color * split.y, 1.0), tone * split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_3(Light light, float4 color, float tone)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return ConstructLitLayer(float4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_diffuse_balanced(Light light, float3 normal)
{
    const float3 d = normalize_quick(normal, float3(0.0, 0.0, 1.0));
    return ConstructAngle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

Angle parametrization_specular_balanced(Light light, float3 normal, float3 view)
{
    float3 d = 2.0 * dot(normal, view) * normal - view;
    return ConstructAngle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

Angle parametrization_screen_aligned_balanced(Light light, float3 normal,
    float3x3 camera_from_world)
{
    float3 d = mul(normal, camera_from_world);
    return ConstructAngle(0.5 * length(d - light.own_direction), 0.5
        * length(d + light.own_direction));
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
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

VectorParts ConstructVectorParts(float x, float y, float z) {
    VectorParts ret = (VectorParts)0;
    ret.x = x;
    ret.y = y;
    ret.z = z;
    return ret;
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    float3 place = surface.position_object;
    float3 from_the_face_s_middle = place - float3(0.0, 0.52, -0.18);
    float3 flattened = from_the_face_s_middle * float3(1.0, 0.35, 1.0);
    const float3 face_direction = normalize_or(flattened, (0.0).xxx);
    VectorParts high = ConstructVectorParts(place.x, place.y, place.z);
    float is_face = smoothstep(0.02, 0.16, high.y);
    float3 face_or_body = lerp(surface.normal, face_direction, is_face);
    float3 shading_direction = face_or_body * rsqrt(max(dot(face_or_body, face_or_body), 1e-30));
    const Angle from_the_light = parametrization_diffuse_balanced(look.key, shading_direction);
    const float edge_of_the_shadow = profile_balanced(from_the_light, 0.0,
        edge_of_the_shadow_shape);
    float soft_dark = 1.0 - edge_of_the_shadow;
    const float4 warm_edge = blend_shade(float4(0.9843, 0.8902, 0.8118, 1.0),
        float4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    const float lit_ = profile_balanced_2(from_the_light, 0.0, lit_shape);
    float in_shadow = 1.0 - lit_;
    const float4 shadow = blend_shade_2(warm_edge, float4(0.698, 0.4784, 0.6588, 1.0), in_shadow,
        0.85, true);

    // Inked hollows (Light layer)
    const float inked_hollows_convexity = transition_balanced(surface.kappa, 0.55);
    const float4 inked_hollows_color = curvature_color(inked_hollows_convexity, (1.0).xxxx,
        float4(0.2902, 0.1412, 0.251, 1.0));
    const LitLayer inked_hollows_lit = light_apply(look.eye, inked_hollows_color, 1.0);
    float4 inked_hollows_blend = clamp(float4(shadow.xyz + 0.9
        * (shadow.xyz * (inked_hollows_lit.tone * inked_hollows_lit.color.xyz) - shadow.xyz), 1.0),
        (0.0).xxxx, (1.0).xxxx);

    // Shine (Light layer)
    const Angle shine_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    const float rim_light_convexity = transition_balanced(surface.kappa, 0.2);
    float shine_warp = (2.0 * rim_light_convexity - 1.0) * 0.05;
    const float shine_tone = profile_balanced_3(shine_angle, shine_warp, shine_tone_shape);
    const LitLayer shine_lit = light_apply_2(look.key, (1.0).xxxx, shine_tone);
    const float4 shine_blend = blend_alpha(inked_hollows_blend, shine_lit.color, shine_lit.tone,
        0.85, true);

    // Rim light (Light layer)
    Angle rim_light_angle = ConstructAngle(0.5 * length(surface.normal - look.back.direction), 0.5
        * length(surface.normal + look.back.direction));
    float rim_light_warp = (2.0 * rim_light_convexity - 1.0) * 0.15;
    const float rim_light_tone = profile_balanced_3(rim_light_angle, rim_light_warp,
        rim_light_tone_shape);
    const LitLayer rim_light_lit = light_apply_3(look.back, float4(1.0, 0.9647, 0.9176, 1.0),
        rim_light_tone);
    const float4 rim_light_blend = blend_alpha(shine_blend, rim_light_lit.color, rim_light_lit.tone,
        0.9, true);

    // Contour (Light layer)
    const Angle contour_angle = parametrization_screen_aligned_balanced(look.eye, surface.normal,
        look.camera_from_world);
    float contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.28;
    const float contour_tone = profile_balanced_3(contour_angle, contour_warp, contour_tone_shape);
    const LitLayer contour_lit = light_apply_2(look.eye, (1.0).xxxx, contour_tone);
    float4 contour_blend = clamp(float4(rim_light_blend.xyz
        * (contour_lit.tone * contour_lit.color.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);

    return contour_blend;
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

Surface ConstructSurface(float3 normal, float3 view, float3 position_object, float kappa) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    ret.kappa = kappa;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.position_object_1, input.normal_4 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, texel.x);
    return shade(surface);
}
