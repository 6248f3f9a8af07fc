// Anisotropic Ward: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// material-ward.json says what to put there and how to draw.

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
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 tangent;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_4 : LOC1;
    float4 tangent_2 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_5 : LOC1;
    float4 tangent_3 : LOC2;
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

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
float3 any_orthogonal(float3 n)
{
    float sign_ = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign_ + n.z);
    return float3(1.0 + sign_ * n.x * n.x * a, sign_ * n.x * n.y * a, -sign_ * n.x);
}

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a
/// normal (Gram and Schmidt), with the handedness of the mesh. Where the tangent is missing or lies
/// along the normal, another one takes its place.
float3x3 world_from_tangent(float3 tangent, float3 bitangent, float3 normal)
{
    float3 t = tangent * rsqrt(max(dot(tangent, tangent), 1e-30));
    float3 leaning = t - dot(t, normal) * normal;
    bool is_usable = dot(leaning, leaning) > 1e-8;
    const float3 any_orthogonal_value = any_orthogonal(normal);
    const float3 rough = normalize_or(is_usable ? leaning : any_orthogonal_value,
        float3(1.0, 0.0, 0.0));
    const float3 upright = normalize_moderate(rough - dot(rough, normal) * normal,
        float3(1.0, 0.0, 0.0));
    float3 b = cross(normal, upright);
    return float3x3(upright, b, normal);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
float3 half_of(float3 light, float3 normal, float3 view)
{
    float3 half_ = light + view;
    return normalize_moderate(dot(half_, half_) > 1e-12 ? half_ : normal, normal);
}

/// Ward's anisotropic highlight (1992, in the form of Walter 2005) with a width along each of two
/// axes.
float ward(float3 light, float3 normal, float3 view, float3 x_axis, float3 y_axis, float2 widths)
{
    float n_l = dot(normal, light);
    float n_v = dot(normal, view);
    if ((n_l <= 0.0) | (n_v <= 0.0)) {
        return 0.0;
    }
    const float3 half_ = half_of(light, normal, view);
    float n_h = max(dot(normal, half_), 1e-6);
    float2 slope = float2(dot(half_, x_axis), dot(half_, y_axis)) / (widths * n_h);
    const float lobe = exp2_stable(-1.442695 * min(dot(slope, slope), 200.0));
    return n_l * lobe / (widths.y * sqrt(max(n_l * n_v, 1e-6)));
}

float reflectance_ward(Light light, float3 normal, float3 view, float3 tangent, float roughness,
    float across)
{
    const float3x3 frame = world_from_tangent(tangent, (0.0).xxx, normal);
    float2 widths = float2(0.25, across * across);
    return ward(light.direction, frame[2], view, frame[0], frame[1], widths);
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float lambert = max(dot(surface.normal, look.key.direction), 0.0);
    // Blend
    float4 body = float4(float3(0.098, 0.1059, 0.1333) + lambert * float3(0.3529, 0.3961, 0.4392),
        1.0);
    const float ward_2 = reflectance_ward(look.key, surface.normal, surface.view, surface.tangent,
        0.5, 0.2);
    // Blend
    float4 highlight = clamp(float4(body.xyz + 0.55
        * (body.xyz + ward_2 * float3(0.9569, 0.9412, 0.902) - body.xyz), 1.0), (0.0).xxxx,
        (1.0).xxxx);
    return highlight;
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 normal, float4 tangent) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.normal = normal;
    ret.tangent = tangent;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        mul(vertex.normal, object.world_from_normal),
        float4(mul(float4(vertex.tangent.xyz, 0.0), object.world_from_object).xyz,
        determinant(object.world_from_normal) < 0.0 ? -vertex.tangent.w : vertex.tangent.w));
    const VertexOutput varyings_1 = { varyings.position, varyings.normal, varyings.tangent,
        varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float3 tangent) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.tangent = tangent;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_5, input.tangent_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    const float3 normalize_moderate_value = normalize_moderate(in_.tangent.xyz - normal
        * dot(normal, in_.tangent.xyz), (0.0).xxx);
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        normalize_moderate_value);
    return shade(surface);
}
