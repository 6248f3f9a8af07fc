// Technical cutaway: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// technical-cutaway.json says what to put there and how to draw.

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

struct Shaded {
    float4 value;
    float4 color;
    float cutoff;
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

static const ProfileShape metal_tone_shape = {0.99820054, 0.059964005, 7.166244, 3.1997643, 0.12,
    0.124456726, 0.0556771, 0u};
static const ProfileShape contour_tone_shape = {0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0, 1u};

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

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// v with 0 for each component that is NaN or infinite.
float4 finite_vec4(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return choose((asuint(v) & exponent) != exponent, v, (0.0).xxxx);
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

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    float d = x - edge;
    if (w < 1e-30) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Premultiplied RGBA of a straight color.
float4 premultiplied(float4 color)
{
    return float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
float4 straight(float4 composite)
{
    if (composite.w <= 0.0) {
        return composite;
    }
    return float4(composite.xyz / (composite.w).xxx, composite.w);
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
float4 output(float4 color)
{
    return finite_vec4(straight(color));
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
    const Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// Cool to warm
///
/// Technical illustration's shading: from a cool color on the far side to a warm one toward the
/// light, so that outlines and highlights, which are darker and lighter, stay readable everywhere.
float4 gooch(Light light, float3 normal, float4 color, float4 cool, float4 warm, float cool_amount,
    float warm_amount)
{
    float t = 0.5 + 0.5 * dot(normal, light.direction);
    float3 far = cool.xyz + cool_amount * color.xyz;
    float3 near = warm.xyz + warm_amount * color.xyz;
    return float4(lerp(far, near, clamp(t, 0.0, 1.0)), 1.0);
}

VectorParts ConstructVectorParts(float x, float y, float z) {
    VectorParts ret = (VectorParts)0;
    ret.x = x;
    ret.y = y;
    ret.z = z;
    return ret;
}

Shaded ConstructShaded(float4 value, float4 color, float cutoff) {
    Shaded ret = (Shaded)0;
    ret.value = value;
    ret.color = color;
    ret.cutoff = cutoff;
    return ret;
}

/// The look at one point of the surface.
Shaded shade(Surface surface)
{
    const float4 cool_to_warm = gooch(look.key, surface.normal, float4(0.8314, 0.8392, 0.8549, 1.0),
        float4(0.1725, 0.2902, 0.4863, 1.0), float4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    // Blend
    float4 cool_to_warm_2 = float4((1.0).xxx + (cool_to_warm.xyz - (1.0).xxx), 1.0);

    // Hollows (Light layer)
    const float hollows_convexity = transition_balanced(surface.kappa, 0.25);
    const float4 hollows_color = curvature_color(hollows_convexity, (1.0).xxxx,
        float4(0.5412, 0.5804, 0.6588, 1.0));
    const LitLayer hollows_lit = light_apply(look.key, hollows_color, 1.0);
    float4 hollows_blend = clamp(float4(cool_to_warm_2.xyz + 0.8
        * (cool_to_warm_2.xyz * (hollows_lit.tone * hollows_lit.color.xyz) - cool_to_warm_2.xyz),
        1.0), (0.0).xxxx, (1.0).xxxx);

    // Metal (Light layer)
    const Angle metal_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    float metal_warp = (2.0 * transition_balanced(surface.kappa, 0.2) - 1.0) * 0.05;
    const float metal_tone = profile_balanced(metal_angle, metal_warp, metal_tone_shape);
    const LitLayer metal_lit = light_apply_2(look.key, (1.0).xxxx, metal_tone);
    const float4 metal_blend = blend_alpha(hollows_blend, metal_lit.color, metal_lit.tone, 0.8,
        true);

    // Contour (Light layer)
    const Angle contour_angle = parametrization_screen_aligned_balanced(look.eye, surface.normal,
        look.camera_from_world);
    float contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.25;
    const float contour_tone = profile_balanced_2(contour_angle, contour_warp, contour_tone_shape);
    const LitLayer contour_lit = light_apply_2(look.eye, (1.0).xxxx, contour_tone);
    float4 contour_blend = clamp(float4(metal_blend.xyz
        * (contour_lit.tone * contour_lit.color.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);

    float3 place = surface.position_object;
    VectorParts parts = ConstructVectorParts(place.x, place.y, place.z);
    float into_the_corner = min(parts.x, parts.z);
    const float footprint_of_value = footprint_of(into_the_corner);
    // Threshold
    const float section = step_filtered(into_the_corner, -0.012,
        length(float2(min(footprint_of_value, 1000000000000000.0), 0.0)));
    float4 section_line = clamp(float4(contour_blend.xyz + section
        * (float3(0.8471, 0.1569, 0.1098) - contour_blend.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
    const float footprint_of_value_1 = footprint_of(into_the_corner);
    // Threshold
    const float taken_out = step_filtered(into_the_corner, 0.02,
        length(float2(min(footprint_of_value_1, 1000000000000000.0), 0.0)));
    float kept = 1.0 - taken_out;
    // Set alpha
    float4 cut = float4(section_line.xyz, kept);
    const float4 output_2 = output(premultiplied(cut));
    return ConstructShaded(output_2, output_2, 0.5);
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
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, texel.x);
    const Shaded shaded = shade(surface);
    if (shaded.color.w < shaded.cutoff) {
        discard;
    }
    return finite_vec4(shaded.value);
}
