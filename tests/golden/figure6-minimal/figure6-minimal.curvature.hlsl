// Minimal: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds curvature from normals and depth.
// Registers of space 0: normals t0, depths t1, curvature b0.
// figure6-minimal.json says what to put there and how to draw.
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

Texel texel(int2 at_1)
{
    bool local_1 = (bool)0;

    int2 size = int2(NagaDimensions2D(normals));
    if (!(any((at_1 < (int(0)).xx)))) {
        local_1 = any((at_1 >= size));
    } else {
        local_1 = true;
    }
    bool _e14 = local_1;
    if (_e14) {
        const Texel texel_1 = ConstructTexel((0.0).xxx, 0.0, 0.0);
        return texel_1;
    }
    float4 normal_1 = normals.Load(int3(at_1, int(0)));
    float4 _e27 = depths.Load(int3(at_1, int(0)));
    const Texel texel_2 = ConstructTexel(normal_1.xyz, normal_1.w, _e27.x);
    return texel_2;
}

float2 slope(float3 normal)
{
    return (normal.xy / (max(normal.z, 0.2)).xx);
}

float3 neighbour(Texel center_1, int2 at_2, float2 offset)
{
    const Texel _e3 = texel(at_2);
    if ((_e3.object != center_1.object)) {
        return (0.0).xxx;
    }
    float _e11 = curvature.pixel;
    float _e15 = curvature.perspective;
    float pixel = (_e11 * lerp(1.0, center_1.depth, _e15));
    float2 gradient = (-(center_1.normal.xy) / (max(center_1.normal.z, 0.02)).xx);
    float expected = (dot(gradient, offset) * pixel);
    float error = abs(((center_1.depth - _e3.depth) - expected));
    float tolerance = (((2.0 * pixel) * length(offset)) * (1.0 + length(gradient)));
    float weight = clamp((2.0 - (error / max(tolerance, 1e-30))), 0.0, 1.0);
    const float2 _e52 = slope(_e3.normal);
    return float3(_e52, weight);
}

float derivative(Sides sides)
{
    float forward = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward = (sides.backward / max(sides.backward_weight, 1e-6));
    float2 trust = float2(smoothstep(0.0, 0.5, sides.forward_weight), smoothstep(0.0, 0.5, sides.backward_weight));
    return (((forward * trust.x) + (backward * trust.y)) / max((trust.x + trust.y), 1e-6));
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
    int2 at = (int2)0;
    Texel center_ = (Texel)0;
    int k = int(0);
    bool local = (bool)0;
    Sides along_x = ConstructSides(0.0, 0.0, 0.0, 0.0);
    Sides along_y = ConstructSides(0.0, 0.0, 0.0, 0.0);
    int k_1 = int(1);

    at = naga_f2i32(position.xy);
    int2 _e4 = at;
    const Texel _e5 = texel(_e4);
    center_ = _e5;
    float _e8 = center_.object;
    if ((_e8 == 0.0)) {
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                int _e33 = k;
                k = asint(asuint(_e33) + asuint(int(1)));
            }
            loop_init = false;
            int _e13 = k;
            if ((_e13 < int(8))) {
                float _e19 = center_.object;
                local = (_e19 == 0.0);
            } else {
                local = false;
            }
            bool _e23 = local;
            if (_e23) {
            } else {
                break;
            }
            {
                int _e27 = k;
                at = asint(asuint(naga_f2i32(position.xy)) + asuint(RING[min(uint(_e27), 7u)]));
                int2 _e30 = at;
                const Texel _e31 = texel(_e30);
                center_ = _e31;
            }
        }
        float _e36 = center_.object;
        if ((_e36 == 0.0)) {
            return 0.0;
        }
    }
    float3 _e41 = center_.normal;
    const float2 _e42 = slope(_e41);
    float _e57 = curvature.rows_up;
    int up = ((_e57 > 0.5) ? int(1) : int(-1));
    float _e65 = curvature.viewport_height;
    int stride = max(naga_f2i32(round((_e65 / 800.0))), int(1));
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e185 = k_1;
            k_1 = asint(asuint(_e185) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e74 = k_1;
        if ((_e74 <= int(3))) {
        } else {
            break;
        }
        {
            int _e77 = k_1;
            int reach = asint(asuint(_e77) * asuint(stride));
            float distance_ = float(reach);
            int _e81 = k_1;
            float weight_1 = ((WEIGHTS[min(uint(asint(asuint(_e81) - asuint(int(1)))), 2u)] * distance_) * distance_);
            Texel _e87 = center_;
            int2 _e88 = at;
            const float3 _e96 = neighbour(_e87, asint(asuint(_e88) + asuint(int2(naga_neg(reach), int(0)))), float2(-(distance_), 0.0));
            Texel _e97 = center_;
            int2 _e98 = at;
            const float3 _e104 = neighbour(_e97, asint(asuint(_e98) + asuint(int2(reach, int(0)))), float2(distance_, 0.0));
            Texel _e105 = center_;
            int2 _e106 = at;
            const float3 _e113 = neighbour(_e105, asint(asuint(_e106) + asuint(int2(int(0), asint(asuint(up) * asuint(reach))))), float2(0.0, distance_));
            Texel _e114 = center_;
            int2 _e115 = at;
            const float3 _e123 = neighbour(_e114, asint(asuint(_e115) - asuint(int2(int(0), asint(asuint(up) * asuint(reach))))), float2(0.0, -(distance_)));
            float _e125 = along_x.forward;
            along_x.forward = (_e125 + (((weight_1 * _e104.z) * (_e104.x - _e42.x)) / distance_));
            float _e135 = along_x.forward_weight;
            along_x.forward_weight = (_e135 + (weight_1 * _e104.z));
            float _e140 = along_x.backward;
            along_x.backward = (_e140 + (((weight_1 * _e96.z) * (_e42.x - _e96.x)) / distance_));
            float _e150 = along_x.backward_weight;
            along_x.backward_weight = (_e150 + (weight_1 * _e96.z));
            float _e155 = along_y.forward;
            along_y.forward = (_e155 + (((weight_1 * _e113.z) * (_e113.y - _e42.y)) / distance_));
            float _e165 = along_y.forward_weight;
            along_y.forward_weight = (_e165 + (weight_1 * _e113.z));
            float _e170 = along_y.backward;
            along_y.backward = (_e170 + (((weight_1 * _e123.z) * (_e42.y - _e123.y)) / distance_));
            float _e180 = along_y.backward_weight;
            along_y.backward_weight = (_e180 + (weight_1 * _e123.z));
        }
    }
    Sides _e187 = along_x;
    const float _e188 = derivative(_e187);
    Sides _e189 = along_y;
    const float _e190 = derivative(_e189);
    float _e196 = curvature.viewport_height;
    float kappa = ((0.5 * (_e188 + _e190)) * _e196);
    return clamp(kappa, -10000.0, 10000.0);
}
