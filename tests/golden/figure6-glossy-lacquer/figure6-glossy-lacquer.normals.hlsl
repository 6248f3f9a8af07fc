// Glossy, lacquer: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws normals and depth, for the curvature pass.
// Registers of space 0: view b0, object b1.
// figure6-glossy-lacquer.json says what to put there and how to draw.

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

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
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

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }

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

/// The slope n.xy / n.z of a normal in camera axes.
float2 slope_of(float3 normal)
{
    return normal.xy / (max(normal.z, 0.2)).xx;
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
float4 surface_texel(float3 normal, float depth, float number)
{
    const float2 slope_of_value = slope_of(normal);
    return float4(slope_of_value, depth, normal.z < 0.0 ? -number : number);
}

/// The normal that the curvature pass sees.
float3 shade(Surface surface)
{
    return surface.normal;
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

Surface ConstructSurface(float3 normal) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_3 };
    bool is_front = input.is_front_1;
    bool local = (bool)0;

    const float3 facing = normalize_seen(in_.normal);
    float3 toward = normalize(view.eye.xyz - view.eye.w * in_.position);
    if (!is_front) {
        local = dot(facing, toward) < -0.1;
    } else {
        local = false;
    }
    bool is_behind = local;
    float3 normal = is_behind ? -facing : facing;
    Surface surface = ConstructSurface(normal);
    float3 seen = mul(float4(shade(surface), 0.0), view.camera_from_world).xyz;
    float depth = -mul(float4(in_.position, 1.0), view.camera_from_world).z;
    return surface_texel(seen, depth, object.id + 1.0);
}
