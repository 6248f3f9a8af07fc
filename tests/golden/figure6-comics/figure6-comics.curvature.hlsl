// Comics: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds curvature from normals and depth.
// Registers of space 0: normals t0, depths t1, curvature b0.
// figure6-comics.json says what to put there and how to draw.
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

struct Sides {
    float forward;
    float forward_weight;
    float backward;
    float backward_weight;
};

typedef float ret_Constructarray3_float_[3];
ret_Constructarray3_float_ Constructarray3_float_(float arg0, float arg1, float arg2) {
    float ret[3] = { arg0, arg1, arg2 };
    return ret;
}

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

float3 neighbour(Texel center_, int2 at_1, float2 offset)
{
    const Texel _e3 = texel(at_1);
    if ((_e3.object != center_.object)) {
        return (0.0).xxx;
    }
    float _e11 = curvature.pixel;
    float _e15 = curvature.perspective;
    float pixel = (_e11 * lerp(1.0, center_.depth, _e15));
    float2 gradient = (-(center_.normal.xy) / (max(center_.normal.z, 0.02)).xx);
    float expected = (dot(gradient, offset) * pixel);
    float error = abs(((center_.depth - _e3.depth) - expected));
    bool is_near = (error <= (((2.0 * pixel) * length(offset)) * (1.0 + length(gradient))));
    const float2 _e47 = slope(_e3.normal);
    return (is_near ? float3(_e47, 1.0) : (0.0).xxx);
}

float derivative(Sides sides)
{
    float forward = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward = (sides.backward / max(sides.backward_weight, 1e-6));
    float count = (((sides.forward_weight > 0.0) ? 1.0 : 0.0) + ((sides.backward_weight > 0.0) ? 1.0 : 0.0));
    return ((forward + backward) / max(count, 1.0));
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    return float4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

int naga_neg(int val) {
    return asint(-asuint(val));
}

Sides ConstructSides(float arg0, float arg1, float arg2, float arg3) {
    Sides ret = (Sides)0;
    ret.forward = arg0;
    ret.forward_weight = arg1;
    ret.backward = arg2;
    ret.backward_weight = arg3;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    float4 position = fragmentinput_fs_main.position_1;
    Sides along_x = ConstructSides(0.0, 0.0, 0.0, 0.0);
    Sides along_y = ConstructSides(0.0, 0.0, 0.0, 0.0);
    int k = int(1);

    int2 at_2 = naga_f2i32(position.xy);
    const Texel _e3 = texel(at_2);
    if ((_e3.object == 0.0)) {
        return 0.0;
    }
    const float2 _e9 = slope(_e3.normal);
    float _e24 = curvature.rows_up;
    int up = ((_e24 > 0.5) ? int(1) : int(-1));
    float _e32 = curvature.viewport_height;
    int stride = max(naga_f2i32(round((_e32 / 800.0))), int(1));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e144 = k;
            k = asint(asuint(_e144) + asuint(int(1)));
        }
        loop_init = false;
        int _e41 = k;
        if ((_e41 <= int(3))) {
        } else {
            break;
        }
        {
            int _e44 = k;
            int reach = asint(asuint(_e44) * asuint(stride));
            float distance_ = float(reach);
            int _e48 = k;
            float weight = ((WEIGHTS[min(uint(asint(asuint(_e48) - asuint(int(1)))), 2u)] * distance_) * distance_);
            const float3 _e61 = neighbour(_e3, asint(asuint(at_2) + asuint(int2(naga_neg(reach), int(0)))), float2(-(distance_), 0.0));
            const float3 _e67 = neighbour(_e3, asint(asuint(at_2) + asuint(int2(reach, int(0)))), float2(distance_, 0.0));
            const float3 _e74 = neighbour(_e3, asint(asuint(at_2) + asuint(int2(int(0), asint(asuint(up) * asuint(reach))))), float2(0.0, distance_));
            const float3 _e82 = neighbour(_e3, asint(asuint(at_2) - asuint(int2(int(0), asint(asuint(up) * asuint(reach))))), float2(0.0, -(distance_)));
            float _e84 = along_x.forward;
            along_x.forward = (_e84 + (((weight * _e67.z) * (_e67.x - _e9.x)) / distance_));
            float _e94 = along_x.forward_weight;
            along_x.forward_weight = (_e94 + (weight * _e67.z));
            float _e99 = along_x.backward;
            along_x.backward = (_e99 + (((weight * _e61.z) * (_e9.x - _e61.x)) / distance_));
            float _e109 = along_x.backward_weight;
            along_x.backward_weight = (_e109 + (weight * _e61.z));
            float _e114 = along_y.forward;
            along_y.forward = (_e114 + (((weight * _e74.z) * (_e74.y - _e9.y)) / distance_));
            float _e124 = along_y.forward_weight;
            along_y.forward_weight = (_e124 + (weight * _e74.z));
            float _e129 = along_y.backward;
            along_y.backward = (_e129 + (((weight * _e82.z) * (_e9.y - _e82.y)) / distance_));
            float _e139 = along_y.backward_weight;
            along_y.backward_weight = (_e139 + (weight * _e82.z));
        }
    }
    Sides _e146 = along_x;
    const float _e147 = derivative(_e146);
    Sides _e148 = along_y;
    const float _e149 = derivative(_e148);
    float _e155 = curvature.viewport_height;
    float kappa = ((0.5 * (_e147 + _e149)) * _e155);
    return clamp(kappa, -10000.0, 10000.0);
}
