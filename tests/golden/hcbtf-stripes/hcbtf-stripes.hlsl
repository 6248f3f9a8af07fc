// Stripes: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, image_1_ t0, image_1_sampler s0.
// hcbtf-stripes.json says what to put there and how to draw.
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
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float2 uv;
    int _pad3_0;
    int _pad3_1;
    float3 tangent;
    int _pad4_0;
    float3 bitangent;
    int _end_pad_0;
};

struct HcbtfGrid {
    int2 size;
    int2 light;
    int2 view;
    bool has_levels;
    bool is_decoded;
    int _end_pad_0;
};

struct HcbtfPlace {
    int2 theta;
    int2 phi;
    float2 weight;
};

struct HcbtfViews {
    int4 layer;
    float4 weight;
};

struct HcbtfTexels {
    int4 at;
    float2 weight;
    int2 origin;
};

struct HcbtfBlocks {
    int2 left_top;
    int2 right_top;
    int2 left_bottom;
    int2 right_bottom;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
    float2 uv : LOC3;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 tangent : LOC2;
    float2 uv : LOC3;
};

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float SMALLEST_NORMAL = 1.1754944e-38;

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2DArray<float4> image_1_ : register(t0);
SamplerState image_1_sampler : register(s0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 tangent_2 : LOC2;
    float2 uv_4 : LOC3;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
    float4 tangent_3 : LOC2;
    float2 uv_5 : LOC3;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise)
{
    const bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

float3 finite_vec3_(float3 v)
{
    const float _e3 = finite_or(v.x, 0.0);
    const float _e6 = finite_or(v.y, 0.0);
    const float _e9 = finite_or(v.z, 0.0);
    return float3(_e3, _e6, _e9);
}

float4 finite_vec4_(float4 v_1)
{
    const float3 _e2 = finite_vec3_(v_1.xyz);
    const float _e5 = finite_or(v_1.w, 0.0);
    return float4(_e2, _e5);
}

float3 normalize_or(float3 v_2, float3 otherwise_1)
{
    bool local = (bool)0;

    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    float3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float atan2_positive(float y, float x_2)
{
    float small = min(y, x_2);
    float large = max(y, x_2);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t = (small / large);
    bool is_wide = (t > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a = (is_wide ? (series + 0.7853982) : series);
    return ((y > x_2) ? (HALF_PI - a) : a);
}

float bounded(float x_3)
{
    uint bits = asuint(x_3);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float2 bounded_vec2_(float2 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    return float2(_e2, _e4);
}

float3 bounded_vec3_(float3 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_5)
{
    const float _e2 = bounded(v_5.x);
    const float _e4 = bounded(v_5.y);
    const float _e6 = bounded(v_5.z);
    const float _e8 = bounded(v_5.w);
    return float4(_e2, _e4, _e6, _e8);
}

float length_of(float3 v_6)
{
    const float3 _e1 = bounded_vec3_(v_6);
    float largest_2 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e17 = bounded((largest_2 * length((_e1 / (largest_2).xxx))));
    return _e17;
}

float angle_of_point(float y_1, float x_4)
{
    const float2 _e3 = bounded_vec2_(float2(x_4, y_1));
    float2 p = abs(_e3);
    float2 scaled_1 = ((max(p.x, p.y) > 1.0) ? (0.5 * p) : p);
    const float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned = ((x_4 < 0.0) ? (PI - _e15) : _e15);
    return ((y_1 < 0.0) ? -(turned) : turned);
}

float4 premultiplied(float4 color)
{
    return float4((color.xyz * color.w), color.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 linear_from_display(float4 color_1)
{
    float3 c = max(color_1.xyz, (0.0).xxx);
    float3 low = (c / (12.92).xxx);
    float3 high = pow(((c + (0.055).xxx) / (1.055).xxx), (2.4).xxx);
    return float4(((c <= (0.04045).xxx) ? low : high), color_1.w);
}

float3 any_orthogonal(float3 n)
{
    float sign_ = ((n.z >= 0.0) ? 1.0 : -1.0);
    float a_1 = (-1.0 / (sign_ + n.z));
    return float3((1.0 + (((sign_ * n.x) * n.x) * a_1)), (((sign_ * n.x) * n.y) * a_1), (-(sign_) * n.x));
}

float3x3 world_from_tangent(float3 tangent, float3 bitangent, float3 normal)
{
    const float3 _e7 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const float3 _e10 = normalize_or(tangent, (0.0).xxx);
    float3 leaning = (_e10 - (dot(_e10, _e7) * _e7));
    bool is_usable = (dot(leaning, leaning) > 1e-8);
    const float3 _e17 = any_orthogonal(_e7);
    const float3 _e23 = normalize_or((is_usable ? leaning : _e17), float3(1.0, 0.0, 0.0));
    const float3 _e31 = normalize_or((_e23 - (dot(_e23, _e7) * _e7)), float3(1.0, 0.0, 0.0));
    float3 b = cross(_e7, _e31);
    return float3x3(_e31, ((dot(b, bitangent) < 0.0) ? -(b) : b), _e7);
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float footprint_of(float x_5)
{
    float _e1 = ddx(x_5);
    float _e2 = ddy(x_5);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float step_filtered(float x_6, float edge, float w)
{
    const float _e4 = bounded((x_6 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

HcbtfGrid ConstructHcbtfGrid(int2 arg0, int2 arg1, int2 arg2, bool arg3, bool arg4) {
    HcbtfGrid ret = (HcbtfGrid)0;
    ret.size = arg0;
    ret.light = arg1;
    ret.view = arg2;
    ret.has_levels = arg3;
    ret.is_decoded = arg4;
    return ret;
}

int4 naga_f2i32(float4 value) {
    return int4(clamp(value, -2147483600.0, 2147483500.0));
}

uint NagaNumLayers2DArray(Texture2DArray<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z, ret.w);
    return ret.z;
}

HcbtfGrid hcbtf_grid(Texture2DArray<float4> sheet)
{
    int last = asint(asuint(int(NagaNumLayers2DArray(sheet))) - asuint(int(1)));
    float4 _e9 = sheet.Load(int4(int2(int(0), int(0)), last, int(0)));
    int4 first = naga_f2i32(round((255.0 * _e9)));
    float4 _e18 = sheet.Load(int4(int2(int(1), int(0)), last, int(0)));
    int4 second = naga_f2i32(round((255.0 * _e18)));
    int2 size_1 = int2(asint(asuint(first.x) + asuint(asint(asuint(int(256)) * asuint(naga_mod(first.z, int(16)))))), asint(asuint(first.y) + asuint(asint(asuint(int(256)) * asuint(naga_div(first.z, int(16)))))));
    const HcbtfGrid hcbtfgrid = ConstructHcbtfGrid(size_1, second.xy, second.zw, (naga_mod(first.w, int(2)) == int(1)), (naga_mod(naga_div(first.w, int(2)), int(2)) == int(1)));
    return hcbtfgrid;
}

float3 hcbtf_local(float3 direction, float3x3 frame)
{
    const float3 _e3 = normalize_or(direction, frame[2]);
    const float3 _e9 = normalize_or(mul(frame, _e3), float3(0.0, 0.0, 1.0));
    return _e9;
}

float2 hcbtf_place(float3 local_1, int2 directions)
{
    const float _e5 = length_of(float3(local_1.xy, 0.0));
    const float _e9 = angle_of_point(_e5, max(local_1.z, 0.0));
    const float _e12 = angle_of_point(local_1.x, local_1.y);
    float around = ((_e5 > 1e-12) ? _e12 : 0.0);
    float steps = float(directions.y);
    float phi = (around * (0.15915494 * steps));
    float turned_1 = ((phi < 0.0) ? (phi + steps) : phi);
    float rings = float(asint(asuint(directions.x) - asuint(int(1))));
    return float2(clamp(((_e9 * 0.63661975) * rings), 0.0, rings), ((turned_1 >= steps) ? 0.0 : turned_1));
}

HcbtfPlace ConstructHcbtfPlace(int2 arg0, int2 arg1, float2 arg2) {
    HcbtfPlace ret = (HcbtfPlace)0;
    ret.theta = arg0;
    ret.phi = arg1;
    ret.weight = arg2;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

HcbtfPlace hcbtf_around(float2 place, int2 directions_1)
{
    int2 low_1 = naga_f2i32(floor(place));
    int2 theta = int2(low_1.x, min(asint(asuint(low_1.x) + asuint(int(1))), asint(asuint(directions_1.x) - asuint(int(1)))));
    int2 phi_1 = int2(low_1.y, naga_mod(asint(asuint(low_1.y) + asuint(int(1))), directions_1.y));
    const HcbtfPlace hcbtfplace = ConstructHcbtfPlace(theta, phi_1, (place - floor(place)));
    return hcbtfplace;
}

HcbtfViews ConstructHcbtfViews(int4 arg0, float4 arg1) {
    HcbtfViews ret = (HcbtfViews)0;
    ret.layer = arg0;
    ret.weight = arg1;
    return ret;
}

HcbtfViews hcbtf_views(float2 place_1, int2 directions_2)
{
    const HcbtfPlace _e2 = hcbtf_around(place_1, directions_2);
    int4 layer_1 = asint(asuint(asint(asuint(int4(_e2.theta.x, _e2.theta.y, _e2.theta.x, _e2.theta.y)) * asuint(directions_2.y))) + asuint(int4(_e2.phi.x, _e2.phi.x, _e2.phi.y, _e2.phi.y)));
    float2 w_1 = _e2.weight;
    float4 weight_1 = float4(((1.0 - w_1.x) * (1.0 - w_1.y)), (w_1.x * (1.0 - w_1.y)), ((1.0 - w_1.x) * w_1.y), (w_1.x * w_1.y));
    const HcbtfViews hcbtfviews = ConstructHcbtfViews(layer_1, weight_1);
    return hcbtfviews;
}

int2 hcbtf_block(int2 texel, int2 light, int2 origin)
{
    return asint(asuint(origin) + asuint(asint(asuint(texel) * asuint(int2(light.x, asint(asuint(light.y) + asuint(int(2))))))));
}

float4 hcbtf_add(float4 sum, float4 color_3, float weight)
{
    return (sum + (float4((color_3.xyz * color_3.w), color_3.w) * weight));
}

float4 hcbtf_straight(float4 sum_1)
{
    return ((sum_1.w > 0.0) ? float4(clamp((sum_1.xyz / (max(sum_1.w, 1e-20)).xxx), (0.0).xxx, (1.0).xxx), min(sum_1.w, 1.0)) : (0.0).xxxx);
}

float4 hcbtf_lights(Texture2DArray<float4> sheet_1, int2 block, int layer, HcbtfPlace light_1)
{
    float4 sum_2 = (0.0).xxxx;

    float2 w_2 = light_1.weight;
    float4 _e8 = sum_2;
    float4 _e18 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_1.theta.x, asint(asuint(light_1.phi.x) + asuint(int(1)))))), layer, int(0)));
    const float4 _e26 = hcbtf_add(_e8, _e18, ((1.0 - w_2.x) * (1.0 - w_2.y)));
    sum_2 = _e26;
    float4 _e27 = sum_2;
    float4 _e37 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_1.theta.y, asint(asuint(light_1.phi.x) + asuint(int(1)))))), layer, int(0)));
    const float4 _e43 = hcbtf_add(_e27, _e37, (w_2.x * (1.0 - w_2.y)));
    sum_2 = _e43;
    float4 _e44 = sum_2;
    float4 _e54 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_1.theta.x, asint(asuint(light_1.phi.y) + asuint(int(1)))))), layer, int(0)));
    const float4 _e60 = hcbtf_add(_e44, _e54, ((1.0 - w_2.x) * w_2.y));
    sum_2 = _e60;
    float4 _e61 = sum_2;
    float4 _e71 = sheet_1.Load(int4(asint(asuint(block) + asuint(int2(light_1.theta.y, asint(asuint(light_1.phi.y) + asuint(int(1)))))), layer, int(0)));
    const float4 _e75 = hcbtf_add(_e61, _e71, (w_2.x * w_2.y));
    return _e75;
}

float4 hcbtf_sixteen(Texture2DArray<float4> sheet_2, int2 block_1, HcbtfPlace light_2, HcbtfViews views)
{
    const float4 _e8 = hcbtf_lights(sheet_2, block_1, views.layer.x, light_2);
    const float4 _e14 = hcbtf_lights(sheet_2, block_1, views.layer.y, light_2);
    const float4 _e21 = hcbtf_lights(sheet_2, block_1, views.layer.z, light_2);
    const float4 _e28 = hcbtf_lights(sheet_2, block_1, views.layer.w, light_2);
    return ((((views.weight.x * _e8) + (views.weight.y * _e14)) + (views.weight.z * _e21)) + (views.weight.w * _e28));
}

HcbtfBlocks ConstructHcbtfBlocks(int2 arg0, int2 arg1, int2 arg2, int2 arg3) {
    HcbtfBlocks ret = (HcbtfBlocks)0;
    ret.left_top = arg0;
    ret.right_top = arg1;
    ret.left_bottom = arg2;
    ret.right_bottom = arg3;
    return ret;
}

HcbtfBlocks hcbtf_blocks(HcbtfTexels texels, int2 light_3)
{
    int4 at = texels.at;
    const int2 _e5 = hcbtf_block(at.xy, light_3, texels.origin);
    const int2 _e8 = hcbtf_block(at.zy, light_3, texels.origin);
    const int2 _e11 = hcbtf_block(at.xw, light_3, texels.origin);
    const int2 _e14 = hcbtf_block(at.zw, light_3, texels.origin);
    const HcbtfBlocks hcbtfblocks = ConstructHcbtfBlocks(_e5, _e8, _e11, _e14);
    return hcbtfblocks;
}

int2 naga_div(int2 lhs, int2 rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

HcbtfTexels ConstructHcbtfTexels(int4 arg0, float2 arg1, int2 arg2) {
    HcbtfTexels ret = (HcbtfTexels)0;
    ret.at = arg0;
    ret.weight = arg1;
    ret.origin = arg2;
    return ret;
}

HcbtfTexels hcbtf_texels(float2 uv, HcbtfGrid grid, int level)
{
    int2 size = (int2)0;
    int2 origin_1 = (int(0)).xx;
    int i = int(0);

    size = grid.size;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e41 = i;
            i = asint(asuint(_e41) + asuint(int(1)));
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < level)) {
        } else {
            break;
        }
        {
            int _e18 = origin_1.y;
            int _e20 = size.y;
            int _e27 = i;
            origin_1 = int2(asint(asuint(grid.size.x) * asuint(grid.light.x)), ((_e27 == int(0)) ? int(0) : asint(asuint(_e18) + asuint(asint(asuint(_e20) * asuint(asint(asuint(grid.light.y) + asuint(int(2)))))))));
            int2 _e33 = size;
            size = max(naga_div(_e33, (int(2)).xx), (int(1)).xx);
        }
    }
    const float2 _e47 = bounded_vec2_(float2(uv.x, -(uv.y)));
    int2 _e50 = size;
    float2 place_2 = (((_e47 - floor(_e47)) * float2(_e50)) - (0.5).xx);
    int2 low_2 = naga_f2i32(floor(place_2));
    int2 _e58 = size;
    int2 _e60 = size;
    int2 first_1 = naga_mod(asint(asuint(low_2) + asuint(_e58)), _e60);
    int2 _e65 = size;
    int2 _e70 = origin_1;
    const HcbtfTexels hcbtftexels = ConstructHcbtfTexels(int4(first_1, naga_mod(asint(asuint(first_1) + asuint((int(1)).xx)), _e65)), (place_2 - floor(place_2)), _e70);
    return hcbtftexels;
}

float4 hcbtf_sixteen_at(Texture2DArray<float4> sheet_3, float2 uv_1, HcbtfGrid grid_1, int level_1, HcbtfPlace light_4, HcbtfViews views_1)
{
    const HcbtfTexels _e6 = hcbtf_texels(uv_1, grid_1, level_1);
    float2 w_3 = _e6.weight;
    const HcbtfBlocks _e9 = hcbtf_blocks(_e6, grid_1.light);
    const float4 _e18 = hcbtf_sixteen(sheet_3, _e9.left_top, light_4, views_1);
    const float4 _e26 = hcbtf_sixteen(sheet_3, _e9.right_top, light_4, views_1);
    const float4 _e35 = hcbtf_sixteen(sheet_3, _e9.left_bottom, light_4, views_1);
    const float4 _e42 = hcbtf_sixteen(sheet_3, _e9.right_bottom, light_4, views_1);
    return ((((((1.0 - w_3.x) * (1.0 - w_3.y)) * _e18) + ((w_3.x * (1.0 - w_3.y)) * _e26)) + (((1.0 - w_3.x) * w_3.y) * _e35)) + ((w_3.x * w_3.y) * _e42));
}

float hcbtf_level(float2 uv_2, HcbtfGrid grid_2)
{
    float2 _e2 = ddx(uv_2);
    const float2 _e6 = bounded_vec2_((_e2 * float2(grid_2.size)));
    float2 _e7 = ddy(uv_2);
    const float2 _e11 = bounded_vec2_((_e7 * float2(grid_2.size)));
    float widest = clamp(max(dot(_e6, _e6), dot(_e11, _e11)), 1.0, 1000000000.0);
    int side = max(grid_2.size.x, grid_2.size.y);
    float last_1 = floor((log2(float(side)) + 0.0001));
    return (grid_2.has_levels ? min((0.5 * log2(widest)), last_1) : 0.0);
}

float hcbtf_horizon(float3 light_5, float3x3 frame_1)
{
    const float3 _e3 = normalize_or(light_5, frame_1[2]);
    float height = dot(_e3, frame_1[2]);
    const float _e7 = footprint_of(height);
    const float _e8 = step_filtered(height, 0.0, _e7);
    return _e8;
}

float4 hcbtf_finished(float4 lit_, float above, float4 unlit, HcbtfGrid grid_3)
{
    const float4 _e4 = linear_from_display(lit_);
    float4 painted = (grid_3.is_decoded ? _e4 : lit_);
    const float4 _e7 = bounded_vec4_(unlit);
    return lerp(_e7, painted, above);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float4 hcbtf_lookup_smooth(Texture2DArray<float4> sheet_4, SamplerState sheet_sampler, Light light_6, float2 uv_3, float2 scale, float4 unlit_1, float3 normal_1, float3 view, float3 tangent_1, float3 bitangent_1)
{
    float4 sum_3 = (float4)0;

    const HcbtfGrid _e10 = hcbtf_grid(sheet_4);
    const float3x3 _e11 = world_from_tangent(tangent_1, bitangent_1, normal_1);
    const float2 _e13 = bounded_vec2_((uv_3 * scale));
    const float _e14 = hcbtf_level(_e13, _e10);
    const float _e16 = hcbtf_horizon(light_6.direction, _e11);
    const float3 _e18 = hcbtf_local(light_6.direction, _e11);
    const float2 _e20 = hcbtf_place(_e18, _e10.light);
    const HcbtfPlace _e22 = hcbtf_around(_e20, _e10.light);
    const float3 _e23 = hcbtf_local(view, _e11);
    const float2 _e25 = hcbtf_place(_e23, _e10.view);
    const HcbtfViews _e27 = hcbtf_views(_e25, _e10.view);
    int finer = naga_f2i32(_e14);
    const float4 _e29 = hcbtf_sixteen_at(sheet_4, _e13, _e10, finer, _e22, _e27);
    sum_3 = _e29;
    if ((_e14 > float(finer))) {
        float4 _e33 = sum_3;
        const float4 _e36 = hcbtf_sixteen_at(sheet_4, _e13, _e10, asint(asuint(finer) + asuint(int(1))), _e22, _e27);
        sum_3 = lerp(_e33, _e36, (_e14 - float(finer)));
    }
    float4 _e40 = sum_3;
    const float4 _e41 = hcbtf_straight(_e40);
    const float4 _e42 = hcbtf_finished(_e41, _e16, unlit_1, _e10);
    return _e42;
}

float4 shade(Surface surface_1)
{
    Light _e5 = look.key;
    const float4 _e18 = hcbtf_lookup_smooth(image_1_, image_1_sampler, _e5, surface_1.uv, (6.0).xx, float4(0.07, 0.04, 0.11, 1.0), surface_1.normal, surface_1.view, surface_1.tangent, surface_1.bitangent);
    const float4 _e19 = premultiplied(_e18);
    const float4 _e20 = output(_e19);
    return _e20;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_1.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    float4x4 _e25 = object.world_from_object;
    float3x3 _e39 = object.world_from_normal;
    out_.tangent = float4(mul(float4(vertex.tangent.xyz, 0.0), _e25).xyz, ((determinant(_e39) < 0.0) ? -(vertex.tangent.w) : vertex.tangent.w));
    out_.uv = vertex.uv;
    Varyings _e47 = out_;
    const Varyings varyings = _e47;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.tangent, varyings.uv, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3, fragmentinput_fs_main.tangent_3, fragmentinput_fs_main.uv_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    float4 _e26 = view_1.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.uv = in_.uv;
    const float3 _e46 = normalize_or((in_.tangent.xyz - (normal_4 * dot(normal_4, in_.tangent.xyz))), in_.tangent.xyz);
    surface.tangent = _e46;
    const float3 _e57 = normalize_or((in_.tangent.xyz - (normal_4 * dot(normal_4, in_.tangent.xyz))), in_.tangent.xyz);
    surface.bitangent = (cross(normal_4, _e57) * in_.tangent.w);
    Surface _e62 = surface;
    const float4 _e63 = shade(_e62);
    const float4 _e64 = finite_vec4_(_e63);
    return _e64;
}
