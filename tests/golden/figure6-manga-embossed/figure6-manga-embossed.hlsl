// Manga, embossed: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// figure6-manga-embossed.json says what to put there and how to draw.

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
    Light above;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light below;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
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
    float3 normal : LOC0;
};

static const ProfileShape dark_side_tone_shape = {0.9624252, 0.27154693, 5.0334897, 2.4651666, 0.55,
    0.19658314, 0.08474467, 0u};
static const ProfileShape light_side_tone_shape = {0.9689124, 0.24740396, 5.743557, 2.3650649, 0.5,
    0.17491564, 0.07484149, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

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
    const Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Dark side (Light layer)
    float light_side_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.3, -20.0, 20.0))));
    const float4 dark_side_color = curvature_color(light_side_convexity,
        float4(0.4275, 0.4078, 0.4745, 1.0), float4(0.2275, 0.2078, 0.2784, 1.0));
    const Angle dark_side_angle = parametrization_screen_aligned_balanced(look.below,
        surface.normal, look.camera_from_world);
    float light_side_warp = (2.0 * light_side_convexity - 1.0) * 0.35;
    const float dark_side_tone = profile_balanced(dark_side_angle, light_side_warp,
        dark_side_tone_shape);
    const LitLayer dark_side_lit = light_apply(look.below, dark_side_color, dark_side_tone);
    float4 dark_side_blend = clamp(float4(float3(0.851, 0.8314, 0.7804)
        * lerp((1.0).xxx, dark_side_lit.color.xyz, dark_side_lit.tone), 1.0), (0.0).xxxx,
        (1.0).xxxx);

    // Light side (Light layer)
    const float4 light_side_color = curvature_color(light_side_convexity, (1.0).xxxx,
        float4(0.9529, 0.9176, 0.8471, 1.0));
    const Angle light_side_angle = parametrization_screen_aligned_balanced(look.above,
        surface.normal, look.camera_from_world);
    const float light_side_tone = profile_balanced(light_side_angle, light_side_warp,
        light_side_tone_shape);
    const LitLayer light_side_lit = light_apply(look.above, light_side_color, light_side_tone);
    float4 light_side_blend = clamp(float4(dark_side_blend.xyz + light_side_lit.tone
        * (light_side_lit.color.xyz - dark_side_blend.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);

    // Hollows (Light layer)
    float hollows_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.4, -20.0, 20.0))));
    const float4 hollows_color = curvature_color(hollows_convexity, (1.0).xxxx,
        float4(0.4667, 0.4392, 0.5412, 1.0));
    const LitLayer hollows_lit = light_apply(look.above, hollows_color, 1.0);
    float4 hollows_blend = clamp(float4(light_side_blend.xyz + 0.8
        * (light_side_blend.xyz * (hollows_lit.tone * hollows_lit.color.xyz)
        - light_side_blend.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);

    return hollows_blend;
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

Surface ConstructSurface(float3 normal, float kappa) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.kappa = kappa;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal,
        curvature_map.Load(int3(to_int(in_.clip_.xy), int(0))).x);
    return shade(surface);
}
