// Comics: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// figure6-comics.json says what to put there and how to draw.

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
    Light rim;
    Light fill;
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

static const ProfileShape key_tone_shape = {0.8472551, 0.5311862, 0.0, 1.0, 1.12, 0.0, 0.0, 1u};
static const ProfileShape bounce_tone_shape = {0.9358968, 0.35227424, 0.0, 1.0, 0.72, 0.0, 0.0, 1u};
static const ProfileShape light_tone_shape = {0.96638995, 0.25708055, 0.0, 1.0, 0.52, 0.0, 0.0, 1u};
static const ProfileShape rim_tone_shape = {0.9130889, 0.40776044, 0.0, 1.0, 0.84, 0.0, 0.0, 1u};
static const ProfileShape highlight_tone_shape = {0.99280864, 0.119712204, 0.0, 1.0, 0.24, 0.0, 0.0,
    1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

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
    return clamp(float4(below.xyz + tone * (color.xyz - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
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

Angle parametrization_diffuse_balanced(Light light, float3 normal)
{
    return ConstructAngle(0.5 * length(normal - light.direction), 0.5
        * length(normal + light.direction));
}

Angle parametrization_specular_balanced(Light light, float3 normal, float3 view)
{
    float3 d = 2.0 * dot(normal, view) * normal - view;
    return ConstructAngle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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
    const Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Shadow (Light layer)
    const float key_convexity = transition_balanced(surface.kappa, 0.35);
    const float4 shadow_color = curvature_color(key_convexity, float4(0.7059, 0.3412, 0.2902, 1.0),
        float4(0.2941, 0.1098, 0.2, 1.0));
    const LitLayer shadow_lit = light_apply(look.key, shadow_color, 1.0);
    const float4 shadow_blend = blend_alpha(float4(0.8863, 0.6275, 0.4353, 1.0), shadow_lit.color,
        shadow_lit.tone, 1.0, true);

    // Key (Light layer)
    const float4 key_color = curvature_color(key_convexity, float4(0.9529, 0.6902, 0.4392, 1.0),
        float4(0.7686, 0.3451, 0.2902, 1.0));
    const Angle light_angle = parametrization_diffuse_balanced(look.key, surface.normal);
    float key_warp = (2.0 * key_convexity - 1.0) * 0.45;
    const float key_tone = profile_balanced(light_angle, key_warp, key_tone_shape);
    const LitLayer key_lit = light_apply(look.key, key_color, key_tone);
    const float4 key_blend = blend_alpha(shadow_blend, key_lit.color, key_lit.tone, 1.0, true);

    // Bounce (Light layer)
    const float light_convexity = transition_balanced(surface.kappa, 0.3);
    const float4 bounce_color = curvature_color(light_convexity,
        float4(0.8157, 0.4863, 0.3686, 1.0), float4(0.549, 0.2275, 0.298, 1.0));
    const Angle bounce_angle = parametrization_diffuse_balanced(look.fill, surface.normal);
    float bounce_warp = (2.0 * light_convexity - 1.0) * 0.35;
    const float bounce_tone = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    const LitLayer bounce_lit = light_apply(look.fill, bounce_color, bounce_tone);
    const float4 bounce_blend = blend_alpha(key_blend, bounce_lit.color, bounce_lit.tone, 1.0,
        true);

    // Light (Light layer)
    const float4 light_color = curvature_color(light_convexity, float4(1.0, 0.851, 0.6275, 1.0),
        float4(0.9412, 0.6431, 0.4078, 1.0));
    float light_warp = (2.0 * light_convexity - 1.0) * 0.3;
    const float light_tone = profile_balanced(light_angle, light_warp, light_tone_shape);
    const LitLayer light_lit = light_apply(look.key, light_color, light_tone);
    const float4 light_blend = blend_alpha(bounce_blend, light_lit.color, light_lit.tone, 1.0,
        true);

    // Rim (Light layer)
    const float highlight_convexity = transition_balanced(surface.kappa, 0.25);
    const float4 rim_color = curvature_color(highlight_convexity, float4(1.0, 0.9569, 0.8627, 1.0),
        float4(0.949, 0.6588, 0.4196, 1.0));
    const Angle rim_angle = parametrization_diffuse_balanced(look.rim, surface.normal);
    float rim_warp = (2.0 * highlight_convexity - 1.0) * 0.2;
    const float rim_tone = profile_balanced(rim_angle, rim_warp, rim_tone_shape);
    const LitLayer rim_lit = light_apply(look.rim, rim_color, rim_tone);
    const float4 rim_blend = blend_alpha(light_blend, rim_lit.color, rim_lit.tone, 1.0, true);

    // Highlight (Light layer)
    const float4 highlight_color = curvature_color(highlight_convexity,
        float4(1.0, 0.9804, 0.9412, 1.0), float4(1.0, 0.8863, 0.7216, 1.0));
    const Angle highlight_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    float highlight_warp = (2.0 * highlight_convexity - 1.0) * 0.1;
    const float highlight_tone = profile_balanced(highlight_angle, highlight_warp,
        highlight_tone_shape);
    const LitLayer highlight_lit = light_apply(look.key, highlight_color, highlight_tone);
    const float4 highlight_blend = blend_alpha(rim_blend, highlight_lit.color, highlight_lit.tone,
        1.0, true);

    return highlight_blend;
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
    Varyings in_ = { input.clip_1, input.position_1, input.normal_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        texel.x);
    return shade(surface);
}
