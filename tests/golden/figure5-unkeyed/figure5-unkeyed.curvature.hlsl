// Without directional control: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds curvature from normals and depth.
// Registers of space 0: normals t0, depths t1, curvature b0.
// figure5-unkeyed.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};

struct Texel {
    float3 normal;
    float object;
    float depth;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct SideDifferences {
    float forward;
    float forward_weight;
    float backward;
    float backward_weight;
};

typedef int2 ret_Constructarray8_int2_[8];
ret_Constructarray8_int2_ Constructarray8_int2_(int2 arg0, int2 arg1, int2 arg2, int2 arg3, int2 arg4, int2 arg5, int2 arg6, int2 arg7) {
    int2 ret[8] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7 };
    return ret;
}

typedef float ret_Constructarray3_float_[3];
ret_Constructarray3_float_ Constructarray3_float_(float arg0, float arg1, float arg2) {
    float ret[3] = { arg0, arg1, arg2 };
    return ret;
}

static const int2 RING[8] = Constructarray8_int2_(int2(int(1), int(0)), int2(int(-1), int(0)), int2(int(0), int(1)), int2(int(0), int(-1)), int2(int(1), int(1)), int2(int(-1), int(1)), int2(int(1), int(-1)), int2(int(-1), int(-1)));
static const float WEIGHTS[3] = Constructarray3_float_(1.0, 0.85, 0.5);

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

float3 neighbor(Texel center_, int2 at_1, float2 offset)
{
    const Texel _e3 = texel(at_1);
    if ((_e3.object != center_.object)) {
        return (0.0).xxx;
    }
    float _e11 = curvature.pixel;
    float _e15 = curvature.perspective;
    float pixel_2 = (_e11 * lerp(1.0, center_.depth, _e15));
    float2 gradient = (-(center_.normal.xy) / (max(center_.normal.z, 0.02)).xx);
    float expected = (dot(gradient, offset) * pixel_2);
    float error = abs(((center_.depth - _e3.depth) - expected));
    float tolerance = (((2.0 * pixel_2) * length(offset)) * (1.0 + length(gradient)));
    float weight = clamp((2.0 - (error / max(tolerance, 1e-30))), 0.0, 1.0);
    const float2 _e52 = slope(_e3.normal);
    return float3(_e52, weight);
}

float derivative(SideDifferences sides)
{
    float forward = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward = (sides.backward / max(sides.backward_weight, 1e-6));
    float2 trust = float2(smoothstep(0.0, 0.5, sides.forward_weight), smoothstep(0.0, 0.5, sides.backward_weight));
    return (((forward * trust.x) + (backward * trust.y)) / max((trust.x + trust.y), 1e-6));
}

float4 whole_picture(uint index_1)
{
    return float4(((float((index_1 & 1u)) * 4.0) - 1.0), ((float((index_1 >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

int2 covered_near(int2 pixel)
{
    int2 found = (int2)0;
    int k = int(7);

    int2 most = asint(asuint(int2(NagaDimensions2D(normals))) - asuint((int(1)).xx));
    found = pixel;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e27 = k;
            k = asint(asuint(_e27) - asuint(int(1)));
        }
        loop_init = false;
        int _e10 = k;
        if ((_e10 >= int(0))) {
        } else {
            break;
        }
        {
            int _e14 = k;
            int2 near = clamp(asint(asuint(pixel) + asuint(RING[min(uint(_e14), 7u)])), (int(0)).xx, most);
            float4 _e22 = normals.Load(int3(near, int(0)));
            if ((_e22.w != 0.0)) {
                found = near;
            }
        }
    }
    int2 _e29 = found;
    return _e29;
}

int naga_neg(int val) {
    return asint(-asuint(val));
}

SideDifferences ConstructSideDifferences(float arg0, float arg1, float arg2, float arg3) {
    SideDifferences ret = (SideDifferences)0;
    ret.forward = arg0;
    ret.forward_weight = arg1;
    ret.backward = arg2;
    ret.backward_weight = arg3;
    return ret;
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float curvature_at(int2 pixel_1, int first, int last)
{
    int2 at_2 = (int2)0;
    Texel center_1 = (Texel)0;
    SideDifferences along_x = ConstructSideDifferences(0.0, 0.0, 0.0, 0.0);
    SideDifferences along_y = ConstructSideDifferences(0.0, 0.0, 0.0, 0.0);
    int k_1 = (int)0;

    at_2 = pixel_1;
    int2 _e4 = at_2;
    const Texel _e5 = texel(_e4);
    center_1 = _e5;
    float _e8 = center_1.object;
    if ((_e8 == 0.0)) {
        float _e13 = curvature.samples;
        if ((_e13 < 2.0)) {
            return 0.0;
        }
        const int2 _e17 = covered_near(pixel_1);
        at_2 = _e17;
        int2 _e18 = at_2;
        const Texel _e19 = texel(_e18);
        center_1 = _e19;
        float _e21 = center_1.object;
        if ((_e21 == 0.0)) {
            return 0.0;
        }
    }
    float3 _e26 = center_1.normal;
    const float2 _e27 = slope(_e26);
    float _e42 = curvature.rows_up;
    int up = ((_e42 > 0.5) ? int(1) : int(-1));
    float _e50 = curvature.viewport_height;
    int stride = max(naga_f2i32(round((_e50 / 800.0))), int(1));
    k_1 = first;
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e168 = k_1;
            k_1 = asint(asuint(_e168) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e58 = k_1;
        if ((_e58 <= last)) {
        } else {
            break;
        }
        {
            int _e60 = k_1;
            int reach = asint(asuint(_e60) * asuint(stride));
            float distance_ = float(reach);
            int _e64 = k_1;
            float weight_1 = ((WEIGHTS[min(uint(asint(asuint(_e64) - asuint(int(1)))), 2u)] * distance_) * distance_);
            Texel _e70 = center_1;
            int2 _e71 = at_2;
            const float3 _e79 = neighbor(_e70, asint(asuint(_e71) + asuint(int2(naga_neg(reach), int(0)))), float2(-(distance_), 0.0));
            Texel _e80 = center_1;
            int2 _e81 = at_2;
            const float3 _e87 = neighbor(_e80, asint(asuint(_e81) + asuint(int2(reach, int(0)))), float2(distance_, 0.0));
            Texel _e88 = center_1;
            int2 _e89 = at_2;
            const float3 _e96 = neighbor(_e88, asint(asuint(_e89) + asuint(int2(int(0), asint(asuint(up) * asuint(reach))))), float2(0.0, distance_));
            Texel _e97 = center_1;
            int2 _e98 = at_2;
            const float3 _e106 = neighbor(_e97, asint(asuint(_e98) - asuint(int2(int(0), asint(asuint(up) * asuint(reach))))), float2(0.0, -(distance_)));
            float _e108 = along_x.forward;
            along_x.forward = (_e108 + (((weight_1 * _e87.z) * (_e87.x - _e27.x)) / distance_));
            float _e118 = along_x.forward_weight;
            along_x.forward_weight = (_e118 + (weight_1 * _e87.z));
            float _e123 = along_x.backward;
            along_x.backward = (_e123 + (((weight_1 * _e79.z) * (_e27.x - _e79.x)) / distance_));
            float _e133 = along_x.backward_weight;
            along_x.backward_weight = (_e133 + (weight_1 * _e79.z));
            float _e138 = along_y.forward;
            along_y.forward = (_e138 + (((weight_1 * _e96.z) * (_e96.y - _e27.y)) / distance_));
            float _e148 = along_y.forward_weight;
            along_y.forward_weight = (_e148 + (weight_1 * _e96.z));
            float _e153 = along_y.backward;
            along_y.backward = (_e153 + (((weight_1 * _e106.z) * (_e27.y - _e106.y)) / distance_));
            float _e163 = along_y.backward_weight;
            along_y.backward_weight = (_e163 + (weight_1 * _e106.z));
        }
    }
    SideDifferences _e170 = along_x;
    const float _e171 = derivative(_e170);
    SideDifferences _e172 = along_y;
    const float _e173 = derivative(_e172);
    float _e179 = curvature.viewport_height;
    float kappa = ((0.5 * (_e171 + _e173)) * _e179);
    return clamp(kappa, -10000.0, 10000.0);
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    const float4 _e1 = whole_picture(index);
    return _e1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    float4 position = fragmentinput_fs_main.position_1;
    const float _e5 = curvature_at(naga_f2i32(position.xy), int(1), int(3));
    return _e5;
}
