// First look: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds curvature from normals and depth.
// Registers of space 0: normals t0, depths t1, curvature b0.
// first.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
};

struct Texel {
    float3 normal;
    float object;
    float depth;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

Texture2D<float4> normals : register(t0);
Texture2D<float4> depths : register(t1);
cbuffer curvature : register(b0) { Curvature curvature; }

struct FragmentInput_fs_main {
    float4 position_1 : SV_Position;
};

Texel ConstructTexel(float3 arg0, float arg1, float arg2) {
    Texel ret = (Texel)0;
    ret.normal = arg0;
    ret.object = arg1;
    ret.depth = arg2;
    return ret;
}

uint2 NagaDimensions2D(Texture2D<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z);
    return ret.xy;
}

Texel texel(int2 at)
{
    bool local = (bool)0;

    int2 size = int2(NagaDimensions2D(normals));
    if (!(any((at < (int(0)).xx)))) {
        local = any((at >= size));
    } else {
        local = true;
    }
    bool _e14 = local;
    if (_e14) {
        const Texel texel_1 = ConstructTexel((0.0).xxx, 0.0, 0.0);
        return texel_1;
    }
    float4 normal_1 = normals.Load(int3(at, int(0)));
    float4 _e27 = depths.Load(int3(at, int(0)));
    const Texel texel_2 = ConstructTexel(normal_1.xyz, normal_1.w, _e27.x);
    return texel_2;
}

float2 slope(float3 normal)
{
    return (normal.xy / (max(normal.z, 0.2)).xx);
}

float3 neighbour(Texel center_, int2 at_1, float2 step_)
{
    const Texel _e3 = texel(at_1);
    if ((_e3.object != center_.object)) {
        return (0.0).xxx;
    }
    float _e11 = curvature.pixel;
    float _e15 = curvature.perspective;
    float pixel = (_e11 * lerp(1.0, center_.depth, _e15));
    float2 gradient = (-(center_.normal.xy) / (max(center_.normal.z, 0.02)).xx);
    float expected = (dot(gradient, step_) * pixel);
    float error = abs(((center_.depth - _e3.depth) - expected));
    bool is_near = (error <= ((2.0 * pixel) * (1.0 + length(gradient))));
    const float2 _e45 = slope(_e3.normal);
    return (is_near ? float3(_e45, 1.0) : (0.0).xxx);
}

float derivative(float here, float2 before, float2 after)
{
    float total = (before.y + after.y);
    if ((total == 0.0)) {
        return 0.0;
    }
    float forward = ((after.x - here) * after.y);
    float backward = ((here - before.x) * before.y);
    return ((forward + backward) / total);
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    return float4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    float4 position = fragmentinput_fs_main.position_1;
    int2 at_2 = naga_f2i32(position.xy);
    const Texel _e3 = texel(at_2);
    if ((_e3.object == 0.0)) {
        return 0.0;
    }
    const float2 _e9 = slope(_e3.normal);
    const float3 _e17 = neighbour(_e3, asint(asuint(at_2) + asuint(int2(int(-1), int(0)))), float2(-1.0, 0.0));
    const float3 _e25 = neighbour(_e3, asint(asuint(at_2) + asuint(int2(int(1), int(0)))), float2(1.0, 0.0));
    float _e28 = curvature.rows_up;
    int up = ((_e28 > 0.5) ? int(1) : int(-1));
    const float3 _e40 = neighbour(_e3, asint(asuint(at_2) + asuint(int2(int(0), up))), float2(0.0, 1.0));
    const float3 _e47 = neighbour(_e3, asint(asuint(at_2) - asuint(int2(int(0), up))), float2(0.0, -1.0));
    const float _e51 = derivative(_e9.x, _e17.xz, _e25.xz);
    const float _e55 = derivative(_e9.y, _e47.yz, _e40.yz);
    float _e61 = curvature.viewport_height;
    float kappa = ((0.5 * (_e51 + _e55)) * _e61);
    return clamp(kappa, -10000.0, 10000.0);
}
