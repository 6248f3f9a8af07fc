// Contours: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_tensor_map t0, smooth_normal_4_map t1.
// contours.json says what to put there and how to draw.

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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_camera;
    float3 curvature_tensor;
    float3 smooth_normal_4_;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp three_washes = {{float4(0.7255, 0.7686, 0.8118, 1.0),
    float4(0.8627, 0.8627, 0.8235, 1.0), float4(0.9725, 0.949, 0.8863, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.16, 0.42, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx}, 3u, 2u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);
Texture2D<float4> smooth_normal_4_map : register(t1);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_4 : LOC1;
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
float4 ramp_at(Ramp ramp, float x, float w)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    float4 color = (float4)0;

    colors = ramp.colors;
    places = ramp.places;
    color = colors[0];
    for (uint i = 1u; i < 3u; i++) {
        const float step_filtered_value = step_filtered(x,
            places[0][min(uint(naga_mod(i, 4u)), 3u)], w);
        color = color + (colors[min(uint(i), 15u)] - colors[min(uint(i - 1u), 15u)])
            * step_filtered_value;
    }
    return color;
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
float2 principal_curvatures(float3 tensor)
{
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = length(float2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    const float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? float2(far, near) : float2(near, far);
}

float reflectance_half_lambert(Light light, float3 normal)
{
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
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
    float pixels = 1.5 * height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    float strength = clamp(0.5 + (x - limit)
        / length(float2(min(footprint_of(x), 1000000000000000.0), 22.0)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
float faded_in(float x, float limit, float softness)
{
    float width = length(float2(min(footprint_of(x), 1000000000000000.0), 45.0));
    return clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
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
    const float3 broad_forms = normalize_moderate(surface.smooth_normal_4_, surface.normal);
    const float light_and_dark = reflectance_half_lambert(look.key, broad_forms);
    const float4 three_washes_2 = ramp_at(three_washes, light_and_dark,
        footprint_of_2(light_and_dark));
    const float faded_in_value = faded_in(-principal_curvatures(surface.curvature_tensor).y, 45.0,
        1.0);
    // Inner contour
    float hollows = faded_in_value * smoothstep(0.05, 0.3, dot(surface.normal, surface.view));
    float4 hollows_in_sepia = lerp(three_washes_2, float4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    const float inner_lines = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor,
        surface.normal, surface.view, look.camera_from_world, surface.position_camera,
        look.viewport);
    const float outline = outer_contour(5.0, surface.normal, surface.view, look.viewport);
    float all_lines = max(inner_lines, outline);
    float4 ink = lerp(hollows_in_sepia, float4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return ink;
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

Surface ConstructSurface(float3 normal, float3 view, float3 position_camera,
    float3 curvature_tensor, float3 smooth_normal_4_) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_camera = position_camera;
    ret.curvature_tensor = curvature_tensor;
    ret.smooth_normal_4_ = smooth_normal_4_;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_4 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_1 = smooth_normal_4_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        mul(float4(in_.position, 1.0), view.camera_from_world).xyz, texel.xyz,
        mul(view.camera_from_world, float4(texel_1.xyz, 0.0)).xyz);
    return shade(surface);
}
