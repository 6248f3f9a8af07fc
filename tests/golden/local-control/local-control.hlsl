// Light where it is wanted: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_tensor_map t0.
// local-control.json says what to put there and how to draw.

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
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light back;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_object;
    float3 position_camera;
    float3 curvature_tensor;
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
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape soft_tone_shape = {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417,
    0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

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

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(bounded((bounded(x) - low) / (high - low)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
float length_of(float3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * length(v / (largest).xxx));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

float4 blend_alpha_2(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
}

Light ConstructLight(float3 direction, float3 own_direction, float3 color, float intensity) {
    Light ret = (Light)0;
    ret.direction = direction;
    ret.own_direction = own_direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}

/// Local light
///
/// Bends a light and changes its strength around a place on the surface, and leaves it as it is
/// elsewhere: light as an artist wants it to fall, where the real one would not.
Light local_light(Light light, float3 bend, float strength, float3 center_, float radius,
    float hardness, float3 position)
{
    float weight = 1.0 - eased(length_of(position - center_), radius * hardness, radius);
    float3 bent = light.direction + weight * bend;
    const float3 normalize_moderate_value = normalize_moderate(bent, light.direction);
    float3 direction = ((dot(bent, bent) > 1e-6)
        & (weight > 0.0)) ? normalize_moderate_value : light.direction;
    return ConstructLight(direction, light.own_direction, light.color, min(light.intensity, 1e30));
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

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of_2(facing), 1.0));
    float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    float3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * rsqrt(max(dot(across, across), 1e-30)));
    return inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(float width, float limit, float softness, float3 tensor,
    float3 normal, float3 view, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal, camera_from_world);
    float square = dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    float2 change = float2(ddx(radial), ddy(radial));
    float3 v = mul(view, camera_from_world);
    float3 row = ddy(place);
    float up = (row - dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y) * rsqrt(max(square, 1e-6));
    float pixels = height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    const float footprint_of_value = footprint_of(x);
    float strength = clamp(0.5 + (x - limit)
        / length(float2(min(footprint_of_value, 1000000000000000.0), limit * softness)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(float width, float3 normal, float3 view, float2 viewport)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = width * clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance_ = facing / max(2.0 * footprint_of_2(facing), 1e-6);
    float near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * near;
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const Light turned_to_the_face = local_light(look.key, float3(0.9, 0.25, 0.5), 1.0,
        float3(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    const Light around_the_belly = local_light(turned_to_the_face, float3(0.4, 0.1, 0.35), 1.0,
        float3(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    // Parametrization
    Angle turned_from_the_light = ConstructAngle(0.5
        * length(surface.normal - around_the_belly.direction), 0.5
        * length(surface.normal + around_the_belly.direction));
    const float soft_tone = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    const float eased_value = eased(length_of(surface.position_object - float3(0.0, 0.02, 0.45)),
        0.03, 0.3);
    // Local tone
    float shadow_under_the_chin = clamp(soft_tone + (1.0 - eased_value) * -0.45, 0.0, 1.0);
    const float eased_value_1 = eased(length_of(surface.position_object - float3(-0.2, 0.72, 0.4)),
        0.085, 0.17);
    // Local tone
    float glint_on_the_brow = clamp(shadow_under_the_chin + (1.0 - eased_value_1) * 0.5, 0.0, 1.0);
    // Threshold
    const float lit_ = step_filtered(glint_on_the_brow, 0.55,
        length(float2(footprint_of_2(glint_on_the_brow), 0.0)));
    const float4 light = blend_alpha(float4(0.36, 0.36, 0.6, 1.0), float4(0.96, 0.72, 0.47, 1.0),
        lit_, 1.0, true);
    // Threshold
    const float brightest = step_filtered(glint_on_the_brow, 0.97,
        length(float2(footprint_of_2(glint_on_the_brow), 0.0)));
    // Blend
    float4 brightest_light = min(float4(light.xyz + brightest
        * (float3(1.0, 0.93, 0.76) - light.xyz), 1.0), (1.0).xxxx);
    const float rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.1, 1.0);
    const float4 rim_s_light = blend_alpha_2(brightest_light, float4(0.72, 0.86, 1.0, 1.0), rim_2,
        0.7, true);
    const float folds = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor,
        surface.normal, surface.view, look.camera_from_world, surface.position_camera,
        look.viewport);
    // Combine tones
    float all_lines = max(outer_contour(3.0, surface.normal, surface.view, look.viewport), folds);
    const float4 lines = blend_alpha_2(rim_s_light, float4(0.17, 0.13, 0.28, 1.0), all_lines, 0.85,
        true);
    return lines;
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

Surface ConstructSurface(float3 normal, float3 view, float3 position_object, float3 position_camera,
    float3 curvature_tensor) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    ret.position_camera = position_camera;
    ret.curvature_tensor = curvature_tensor;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_2, input.position_object_1, input.normal_4 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, mul(float4(in_.position, 1.0), view.camera_from_world).xyz, texel.xyz);
    return shade(surface);
}
