// Contours: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2, curvature_tensor_map t0, smooth_normal_4_map t1.
// contours.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    float4 eye;
};

struct Object {
    row_major float4x4 world_from_object;
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    float cutoff;
    int _end_pad_0;
    int _end_pad_1;
};

struct Light {
    float3 direction;
    int _pad1_0;
    float3 own_direction;
    int _pad2_0;
    float3 color;
    float intensity;
};

struct Look {
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    row_major float3x3 camera_from_world;
    int _pad2_0;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_camera;
    int _pad3_0;
    float3 curvature_tensor;
    int _pad4_0;
    float3 smooth_normal_4_;
    int _end_pad_0;
};

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
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

typedef float4 ret_Constructarray16_float4_[16];
ret_Constructarray16_float4_ Constructarray16_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3, float4 arg4, float4 arg5, float4 arg6, float4 arg7, float4 arg8, float4 arg9, float4 arg10, float4 arg11, float4 arg12, float4 arg13, float4 arg14, float4 arg15) {
    float4 ret[16] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15 };
    return ret;
}

typedef float4 ret_Constructarray4_float4_[4];
ret_Constructarray4_float4_ Constructarray4_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3) {
    float4 ret[4] = { arg0, arg1, arg2, arg3 };
    return ret;
}

Ramp ConstructRamp(float4 arg0[16], float4 arg1[4], uint arg2, uint arg3) {
    Ramp ret = (Ramp)0;
    ret.colors = arg0;
    ret.places = arg1;
    ret.count = arg2;
    ret.interpolation = arg3;
    return ret;
}

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp three_washes = ConstructRamp(Constructarray16_float4_(float4(0.7255, 0.7686, 0.8118, 1.0), float4(0.8627, 0.8627, 0.8235, 1.0), float4(0.9725, 0.949, 0.8863, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.16, 0.42, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 3u, 2u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);
Texture2D<float4> smooth_normal_4_map : register(t1);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_4 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_1)
{
    float _e1 = ddx(x_1);
    float _e2 = ddy(x_1);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float footprint_of_2_(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d_1 = float2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float step_filtered(float x_3, float edge, float w)
{
    float d_2 = (x_3 - edge);
    return ((w < 1e-30) ? ((d_2 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_2 / w)), 0.0, 1.0));
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_4, float w_1)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;

    colors = ramp.colors;
    places = ramp.places;
    float4 _e8 = colors[0];
    color = _e8;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e35 = i;
            i = (_e35 + 1u);
        }
        loop_init = false;
        uint _e12 = i;
        if (!((_e12 < 3u))) {
            break;
        }
        float4 _e16 = color;
        uint _e17 = i;
        float4 _e19 = colors[min(uint(_e17), 15u)];
        uint _e20 = i;
        float4 _e24 = colors[min(uint((_e20 - 1u)), 15u)];
        uint _e27 = i;
        float _e31 = places[0][min(uint(naga_mod(_e27, 4u)), 3u)];
        const float _e32 = step_filtered(x_4, _e31, w_1);
        color = (_e16 + ((_e19 - _e24) * _e32));
    }
    float4 _e38 = color;
    return _e38;
}

float2 principal_curvatures(float3 tensor)
{
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(float2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    const float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? float2(far, _e26) : float2(_e26, far));
}

float reflectance_half_lambert(Light light, float3 normal)
{
    float half_ = (0.5 + (0.5 * dot(normal, light.direction)));
    return min((half_ * half_), 1.0);
}

float inner_contour_suggestive(float width, float limit, float softness, float3 tensor_1, float3 normal_1, float3 view, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal_1, camera_from_world);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((tensor_1.x * n.x) * n.x) + (((2.0 * tensor_1.y) * n.x) * n.y)) + ((tensor_1.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e35 = ddx(radial);
    float _e36 = ddy(radial);
    float2 change = float2(_e35, _e36);
    float3 v_2 = mul(view, camera_from_world);
    float3 row = ddy(place);
    float up = (((row - (dot(row, v_2) * v_2)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * rsqrt(max(square_1, 1e-6)));
    float pixels = ((1.5 * height) / 1000.0);
    float distance_ = (abs(radial) / max(length(change), 1e-6));
    float x_6 = ((toward_eye * height) * 0.05);
    const float _e79 = footprint_of(x_6);
    float strength = clamp((0.5 + ((x_6 - limit) / length(float2(min(_e79, 1000000000000000.0), 22.0)))), 0.0, 1.0);
    return ((clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * strength) * smoothstep(0.05, 0.3, dot(normal_1, view)));
}

float faded_in(float x_5, float limit_1, float softness_1)
{
    const float _e3 = footprint_of(x_5);
    float width_2 = length(float2(min(_e3, 1000000000000000.0), 45.0));
    const float _e9 = bounded(x_5);
    const float _e11 = bounded((_e9 - limit_1));
    return clamp((0.5 + (_e11 / width_2)), 0.0, 1.0);
}

float outer_contour(float width_1, float3 normal_2, float3 view_1, float2 viewport_1)
{
    float facing = clamp(dot(normal_2, view_1), 0.0, 1.0);
    float pixels_1 = ((width_1 * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    const float _e15 = footprint_of_2_(facing);
    float distance_1 = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels_1 + 0.5) - distance_1), 0.0, min(pixels_1, 1.0)) * near);
}

float4 shade(Surface surface)
{
    const float3 _e3 = normalize_moderate(surface.smooth_normal_4_, surface.normal);
    Light _e6 = look.key;
    const float _e7 = reflectance_half_lambert(_e6, _e3);
    const float _e9 = footprint_of_2_(_e7);
    const float4 _e10 = ramp_at(three_washes, _e7, _e9);
    const float2 _e12 = principal_curvatures(surface.curvature_tensor);
    const float _e17 = faded_in(-(_e12.y), 45.0, 1.0);
    float hollows = (_e17 * smoothstep(0.05, 0.3, dot(surface.normal, surface.view)));
    float4 hollows_in_sepia = lerp(_e10, float4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    float3x3 _e39 = look.camera_from_world;
    float2 _e43 = look.viewport;
    const float _e44 = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor, surface.normal, surface.view, _e39, surface.position_camera, _e43);
    float2 _e50 = look.viewport;
    const float _e51 = outer_contour(5.0, surface.normal, surface.view, _e50);
    float all_lines = max(_e44, _e51);
    float4 ink = lerp(hollows_in_sepia, float4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return ink;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.normal = arg2;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_2.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float3 arg4) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_camera = arg2;
    ret.curvature_tensor = arg3;
    ret.smooth_normal_4_ = arg4;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_5 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    float4x4 _e20 = view_2.camera_from_world;
    float4 _e31 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e38 = smooth_normal_4_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e44 = view_2.camera_from_world;
    Surface surface_1 = ConstructSurface(normal_5, normalize((_e8.xyz - (_e13 * in_.position))), mul(float4(in_.position, 1.0), _e20).xyz, _e31.xyz, mul(_e44, float4(_e38.xyz, 0.0)).xyz);
    const float4 _e48 = shade(surface_1);
    return _e48;
}
