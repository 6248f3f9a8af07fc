// Grisaille and glaze: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// glaze.json says what to put there and how to draw.

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
    Light back;
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

static const ProfileShape gray_modeling_tone_shape = {1.0, 0.0, 1.0537579, 1.3909147, 0.0,
    1.2772532, 0.561292, 0u};
static const ProfileShape gray_lights_tone_shape = {0.99875027, 0.04997917, 2.0858297, 3.3126261,
    0.1, 0.42646712, 0.19445144, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
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

/// [`bounded`], component by component.
float3 bounded_vec3(float3 v)
{
    uint3 bits = asuint(v);
    uint3 magnitude = bits & (2147483647u).xxx;
    float3 largest = asfloat((bits & (2147483648u).xxx) | (2139095039u).xxx);
    const float3 numbers = choose(magnitude == (2139095040u).xxx, largest, (0.0).xxx);
    return choose(magnitude < (2139095040u).xxx, v, numbers);
}

/// [`mixed`], component by component.
float3 mixed_vec3(float3 a, float3 b, float t)
{
    const float3 d = bounded_vec3(b - a);
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
float soft_light(float a, float b)
{
    float curved = a <= 0.25 ? ((16.0 * a - 12.0) * a + 4.0) * a : sqrt(max(a, 0.0));
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
float4 color_mixed(float4 a, float3 blended, float factor)
{
    const float3 b = bounded_vec3(blended);
    return float4(bounded_vec3(b - (1.0 - factor) * bounded_vec3(b - a.xyz)), 1.0);
}

/// Lightness of a color in the non-separable modes (W3C Compositing and Blending 1, Lum).
float lightness_of(float3 rgb)
{
    return dot(rgb, float3(0.3, 0.59, 0.11));
}

/// `rgb` as light as `other`, drawn toward its gray where a component would leave [0, 1] (SetLum,
/// ClipColor).
float3 lit_as(float3 rgb, float3 other)
{
    const float light = lightness_of(other);
    float3 moved = rgb + (light - lightness_of(rgb)).xxx;
    float least = min(min(moved.x, moved.y), moved.z);
    float largest = max(max(moved.x, moved.y), moved.z);
    float raised = least < 0.0 ? light / max(light - least, 1e-6) : 1.0;
    float3 clipped = (light).xxx + (moved - (light).xxx) * raised;
    // If both ends lie outside, the upper one is measured after the lower one was drawn in.
    float top = light + (largest - light) * raised;
    float lowered = top > 1.0 ? (1.0 - light) / max(top - light, 1e-6) : 1.0;
    return (light).xxx + (clipped - (light).xxx) * lowered;
}

/// Hue of b with the saturation and lightness of a; both counted from 0 to 1.
float3 hued(float3 a, float3 b)
{
    float3 below = clamp(bounded_vec3(a), (0.0).xxx, (1.0).xxx);
    const float3 lit_as_value = lit_as((b - (b.y).xxx)
        * ((max(max(below.x, below.y), below.z) - min(min(below.x, below.y), below.z))
        / (b.x - b.y)), below);
    return lit_as_value;
}

float4 mix_colors_screen(float4 a, float4 b, float factor)
{
    return float4(mixed_vec3(bounded_vec3(a.xyz), bounded_vec3(a.xyz + b.xyz - a.xyz * b.xyz),
        factor), 1.0);
}

float4 mix_colors_soft_light(float4 a, float4 b, float factor)
{
    const float soft_light_value = soft_light(a.x, b.x);
    const float soft_light_value_1 = soft_light(a.y, b.y);
    return color_mixed(a, float3(soft_light_value, soft_light_value_1, a.z - (1.0 - 2.0 * b.z)
        * a.z * (1.0 - a.z)), factor);
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

Angle parametrization_specular_balanced(Light light, float3 normal, float3 view)
{
    float3 d = 2.0 * dot(normal, view) * normal - view;
    return ConstructAngle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
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
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
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
    // Gray modeling (Light layer)
    Angle gray_modeling_angle = ConstructAngle(0.5 * length(surface.normal - look.key.direction),
        0.5 * length(surface.normal + look.key.direction));
    const float gray_modeling_tone = profile_balanced(gray_modeling_angle, 0.0,
        gray_modeling_tone_shape);
    const LitLayer gray_modeling_lit = light_apply(look.key, float4(0.7059, 0.7059, 0.7059, 1.0),
        gray_modeling_tone);
    const float4 gray_modeling_blend = blend_alpha(float4(0.1216, 0.1216, 0.1216, 1.0),
        gray_modeling_lit.color, gray_modeling_lit.tone, 1.0, true);

    // Gray lights (Light layer)
    const Angle gray_lights_angle = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    const float gray_lights_tone = profile_balanced_2(gray_lights_angle, 0.0,
        gray_lights_tone_shape);
    const LitLayer gray_lights_lit = light_apply(look.key, float4(0.2902, 0.2902, 0.2902, 1.0),
        gray_lights_tone);
    float4 gray_lights_blend = clamp(float4(gray_modeling_blend.xyz + gray_lights_lit.tone
        * gray_lights_lit.color.xyz, 1.0), (0.0).xxxx, (1.0).xxxx);

    // Set alpha
    float4 grisaille = float4(gray_lights_blend.xyz, 1.0);
    float4 glaze_of_green_earth = float4(lerp(grisaille.xyz,
        lit_as(float3(0.4275, 0.5412, 0.4471), grisaille.xyz), 0.75), 1.0);
    float4 glaze_of_sienna = float4(lerp(grisaille.xyz,
        lit_as(float3(0.7098, 0.4667, 0.3098), grisaille.xyz), 0.7), 1.0);
    float3 place = surface.position_object;
    VectorParts height = ConstructVectorParts(place.x, place.y, place.z);
    float toward_the_head = smoothstep(-0.5, 0.5, height.y);
    float4 from_green_to_sienna = lerp(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    const float4 warm_light = mix_colors_soft_light(from_green_to_sienna,
        float4(0.9098, 0.702, 0.4157, 1.0), 0.6);
    float curvature = surface.kappa;
    // Curvature transition
    float bulge = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.88539 * clamp(curvature * 0.06, -20.0, 20.0))));
    float hollows = lerp(0.6, 0.0, min((bulge - 0.0) / 0.55, 1.0));
    const float3 mixed_vec3_value = mixed_vec3(bounded_vec3(warm_light.xyz),
        hued(warm_light.xyz, float3(0.4902, 0.2471, 0.3608)), max(hollows, 0.0));
    // Mix colors
    float4 wine_in_the_hollows = float4(mixed_vec3_value, 1.0);
    const float rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.6, 1.0);
    const float4 cool_edge = mix_colors_screen(wine_in_the_hollows,
        float4(0.4353, 0.5294, 0.6588, 1.0), rim_2);
    return finite_vec4(cool_edge);
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
    Varyings in_ = { input.clip_1, input.position_1, input.position_object_1, input.normal_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, texel.x);
    return finite_vec4(shade(surface));
}
