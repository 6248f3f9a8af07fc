// Contours: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_3 b0, object b1, look b2, curvature_tensor_map t0, smooth_normal_4_map t1.
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
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const Ramp three_washes = ConstructRamp(Constructarray16_float4_(float4(0.7255, 0.7686, 0.8118, 1.0), float4(0.8627, 0.8627, 0.8235, 1.0), float4(0.9725, 0.949, 0.8863, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.16, 0.42, 0.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), 3u, 2u);

cbuffer view_3 : register(b0) { View view_3; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);
Texture2D<float4> smooth_normal_4_map : register(t1);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_5 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_6 : LOC1;
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

float bounded(float x_2)
{
    uint bits = asuint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float4 bounded_vec4_(float4 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    const float _e6 = bounded(v_3.z);
    const float _e8 = bounded(v_3.w);
    return float4(_e2, _e4, _e6, _e8);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float mixed(float a_1, float b_1, float t)
{
    const float _e4 = bounded((b_1 - a_1));
    const float _e14 = bounded(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_2, float3 b_2, float t_1)
{
    const float _e5 = mixed(a_2.x, b_2.x, t_1);
    const float _e8 = mixed(a_2.y, b_2.y, t_1);
    const float _e11 = mixed(a_2.z, b_2.z, t_1);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_3, float4 b_3, float t_2)
{
    const float3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    const float _e8 = mixed(a_3.w, b_3.w, t_2);
    return float4(_e5, _e8);
}

float place_between(float x_3, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_3 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_3 - low) / _e12));
    return _e14;
}

float eased(float x_4, float low_1, float high_1)
{
    const float _e3 = bounded(x_4);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_4 = clamp(_e6, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float factor_of(float x_5, bool clamped)
{
    const float _e2 = bounded(x_5);
    const float _e3 = bounded(x_5);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_6)
{
    float _e1 = ddx(x_6);
    float _e2 = ddy(x_6);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_7, float edge, float w_1)
{
    const float _e4 = bounded((x_7 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 hermite(float4 a_4, float4 b_4, float4 from_a, float4 to_b, float t_3)
{
    float4 d_1 = (b_4 - a_4);
    return (a_4 + (t_3 * (from_a + (t_3 * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_1))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    const float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

float4 ramp_slope(float4 rise_before, float span_before_1, float4 rise_after, float span_after_1)
{
    const float _e5 = divided(rise_before.x, span_before_1);
    const float _e7 = divided(rise_after.x, span_after_1);
    const float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    const float _e10 = divided(rise_before.y, span_before_1);
    const float _e12 = divided(rise_after.y, span_after_1);
    const float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    const float _e15 = divided(rise_before.z, span_before_1);
    const float _e17 = divided(rise_after.z, span_after_1);
    const float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    const float _e20 = divided(rise_before.w, span_before_1);
    const float _e22 = divided(rise_after.w, span_after_1);
    const float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_8, float w_2)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = (bool)0;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    uint count = min(ramp.count, 16u);
    if ((count == 0u)) {
        return (0.0).xxxx;
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        float4 _e18 = colors[0];
        color = _e18;
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
            if (!loop_init) {
                uint _e47 = i;
                i = (_e47 + 1u);
            }
            loop_init = false;
            uint _e22 = i;
            if ((_e22 < count)) {
            } else {
                break;
            }
            {
                float4 _e24 = color;
                uint _e25 = i;
                float4 _e27 = colors[min(uint(_e25), 15u)];
                uint _e28 = i;
                float4 _e32 = colors[min(uint((_e28 - 1u)), 15u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[min(uint(naga_div(_e34, 4u)), 3u)][min(uint(naga_mod(_e38, 4u)), 3u)];
                const float _e43 = step_filtered(x_8, _e42, w_2);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        float4 _e49 = color;
        const float4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = (_e71 + 1u);
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if ((_e55 < count)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[min(uint(naga_div(_e59, 4u)), 3u)][min(uint(naga_mod(_e63, 4u)), 3u)];
            at = ((_e67 <= x_8) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_1 = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count))) {
        local_1 = (x_8 <= place_1);
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        float4 _e94 = colors[min(uint(_e92), 15u)];
        const float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span_1 = (_e105 - place_1);
    const float _e108 = divided((x_8 - place_1), span_1);
    float t_5 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        float4 _e117 = colors[min(uint(_e115), 15u)];
        float4 _e119 = colors[min(uint(after_1), 15u)];
        const float4 _e120 = mixed_vec4_(_e117, _e119, t_5);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[min(uint(naga_div((_e130 - 1u), 4u)), 3u)][min(uint(naga_mod((_e136 - 1u), 4u)), 3u)];
        uint _e143 = at;
        float4 _e145 = colors[min(uint(_e143), 15u)];
        uint _e146 = at;
        float4 _e150 = colors[min(uint((_e146 - 1u)), 15u)];
        float4 _e154 = colors[min(uint(after_1), 15u)];
        uint _e155 = at;
        float4 _e157 = colors[min(uint(_e155), 15u)];
        const float4 _e159 = ramp_slope((_e145 - _e150), (place_1 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count)) {
        float _e173 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e173 - (place_1 + span_1));
        float4 _e177 = colors[min(uint(after_1), 15u)];
        uint _e178 = at;
        float4 _e180 = colors[min(uint(_e178), 15u)];
        float4 _e185 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e187 = colors[min(uint(after_1), 15u)];
        const float4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    float4 _e192 = colors[min(uint(_e190), 15u)];
    float4 _e194 = colors[min(uint(after_1), 15u)];
    float4 _e195 = from_a_1;
    float4 _e197 = to_b_1;
    const float4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_5);
    const float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

float4 premultiplied(float4 color_1)
{
    return float4((color_1.xyz * color_1.w), color_1.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_normal(float4 a_5, float4 b_5, float factor)
{
    const float4 _e3 = bounded_vec4_(a_5);
    const float4 _e4 = bounded_vec4_(b_5);
    const float _e6 = factor_of(factor, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float3 tensor_safe(float3 tensor)
{
    const float _e2 = kappa_safe(tensor.x);
    const float _e4 = kappa_safe(tensor.y);
    const float _e6 = kappa_safe(tensor.z);
    return float3(_e2, _e4, _e6);
}

float2 principal_curvatures(float3 tensor_1)
{
    float mean = (0.5 * (tensor_1.x + tensor_1.z));
    float spread = length(float2((0.5 * (tensor_1.x - tensor_1.z)), tensor_1.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    const float _e26 = divided(((tensor_1.x * tensor_1.z) - (tensor_1.y * tensor_1.y)), far);
    return ((mean >= 0.0) ? float2(far, _e26) : float2(_e26, far));
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float4 ramp_plain(float value, Ramp ramp_1)
{
    const float _e2 = footprint_of(value);
    const float _e3 = bounded(value);
    const float4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

float reflectance_half_lambert(Light light, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    float half_ = (0.5 + (0.5 * dot(_e6, light.direction)));
    return clamp((half_ * half_), 0.0, 1.0);
}

float maximum(float a_6, float b_6)
{
    const float _e2 = bounded(a_6);
    const float _e3 = bounded(b_6);
    return max(_e2, _e3);
}

float line_covers(float distance_, float width)
{
    return clamp(((width + 0.5) - distance_), 0.0, min(width, 1.0));
}

float seen_well(float facing)
{
    const float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_9, float limit, float softness_1)
{
    const float _e3 = bounded(limit);
    float at_1 = max(_e3, 0.0);
    const float _e6 = footprint_of(x_9);
    const float _e10 = factor_of(softness_1, true);
    const float _e12 = edge_width(_e6, (min(at_1, 1000000000.0) * _e10));
    const float _e13 = bounded(x_9);
    const float _e14 = step_filtered(_e13, at_1, _e12);
    return _e14;
}

float inner_contour_suggestive(float width_1, float limit_1, float softness_2, float3 tensor_2, float3 normal_1, float3 view, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal_1, camera_from_world);
    const float3 _e10 = tensor_safe(tensor_2);
    float square_1 = dot(n.xy, n.xy);
    float radial = (((((_e10.x * n.x) * n.x) + (((2.0 * _e10.y) * n.x) * n.y)) + ((_e10.z * n.y) * n.y)) / max(square_1, 1e-6));
    float _e36 = ddx(radial);
    float _e37 = ddy(radial);
    float2 change = float2(_e36, _e37);
    float3 v_4 = mul(view, camera_from_world);
    float3 row = ddy(place);
    float up = (((row - (dot(row, v_4) * v_4)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * rsqrt(max(square_1, 1e-6)));
    const float _e67 = bounded(width_1);
    float pixels = (((0.5 * clamp(_e67, 0.0, 10000.0)) * height) / 1000.0);
    float distance_1 = (abs(radial) / max(length(change), 1e-6));
    const float _e84 = faded_in(((toward_eye * height) * 0.05), limit_1, softness_2);
    const float _e85 = line_covers(distance_1, pixels);
    const float _e88 = seen_well(dot(normal_1, view));
    return ((_e85 * _e84) * _e88);
}

float inner_contour_valleys(float limit_2, float softness_3, float3 tensor_3, float3 normal_2, float3 view_1)
{
    const float3 _e5 = tensor_safe(tensor_3);
    const float2 _e6 = principal_curvatures(_e5);
    float least = _e6.y;
    const float _e9 = faded_in(-(least), limit_2, softness_3);
    const float _e11 = seen_well(dot(normal_2, view_1));
    return (_e9 * _e11);
}

float outer_contour(float width_2, float3 normal_3, float3 view_2, float2 viewport_1)
{
    const float3 _e6 = normalize_or(normal_3, (0.0).xxx);
    float facing_1 = clamp(dot(_e6, view_2), 0.0, 1.0);
    const float _e11 = bounded(width_2);
    float pixels_1 = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport_1.y, 1.0, 100000.0)) / 1000.0);
    const float _e22 = footprint_of(facing_1);
    float distance_2 = (facing_1 / max((2.0 * _e22), 1e-6));
    const float _e30 = eased(facing_1, 0.45, 0.75);
    float near = (1.0 - _e30);
    const float _e33 = line_covers(distance_2, pixels_1);
    return (_e33 * near);
}

float3 smooth_normal_large(float3 normal_4, float3 smooth_4_)
{
    const float3 _e2 = normalize_or(smooth_4_, normal_4);
    return _e2;
}

float4 shade(Surface surface_1)
{
    const float3 _e3 = smooth_normal_large(surface_1.normal, surface_1.smooth_normal_4_);
    Light _e6 = look.key;
    const float _e7 = reflectance_half_lambert(_e6, _e3);
    const float4 _e9 = ramp_plain(_e7, three_washes);
    const float _e15 = inner_contour_valleys(45.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view);
    const float4 _e21 = mix_colors_normal(_e9, float4(0.6588, 0.5294, 0.4235, 1.0), _e15);
    float3x3 _e30 = look.camera_from_world;
    float2 _e34 = look.viewport;
    const float _e35 = inner_contour_suggestive(3.0, 22.0, 1.0, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e30, surface_1.position_camera, _e34);
    float2 _e41 = look.viewport;
    const float _e42 = outer_contour(5.0, surface_1.normal, surface_1.view, _e41);
    const float _e43 = maximum(_e35, _e42);
    const float4 _e49 = mix_colors_normal(_e21, float4(0.1647, 0.1412, 0.1882, 1.0), _e43);
    const float4 _e50 = premultiplied(_e49);
    const float4 _e51 = output(_e50);
    return _e51;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_3.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    Varyings _e22 = out_;
    const Varyings varyings = _e22;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_6 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_7 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_7;
    float4 _e15 = view_3.eye;
    float _e20 = view_3.eye.w;
    float4 _e26 = view_3.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    float4x4 _e37 = view_3.camera_from_world;
    surface.position_camera = mul(float4(in_.position, 1.0), _e37).xyz;
    float4 _e49 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.curvature_tensor = _e49.xyz;
    float4 _e57 = smooth_normal_4_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e63 = view_3.camera_from_world;
    surface.smooth_normal_4_ = mul(_e63, float4(_e57.xyz, 0.0)).xyz;
    Surface _e66 = surface;
    const float4 _e67 = shade(_e66);
    const float4 _e68 = finite_vec4_(_e67);
    return _e68;
}
