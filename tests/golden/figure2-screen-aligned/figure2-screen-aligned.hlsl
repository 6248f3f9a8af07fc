// Screen-aligned parametrization: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// figure2-screen-aligned.json says what to put there and how to draw.
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
    row_major float3x3 camera_from_world;
    int _end_pad_0;
};

struct Surface {
    float3 normal;
    int _end_pad_0;
};

struct Angle {
    float half_sin;
    float half_cos;
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
    float3 normal : LOC0;
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

static const float HALF_PI = 1.5707964;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp color_code = ConstructRamp(Constructarray16_float4_(float4(1.0, 0.9686, 0.8392, 1.0), float4(1.0, 0.8196, 0.4, 1.0), float4(0.9529, 0.4471, 0.1725, 1.0), float4(0.7843, 0.1961, 0.3529, 1.0), float4(0.4157, 0.1725, 0.549, 1.0), float4(0.1529, 0.2039, 0.4353, 1.0), float4(0.0431, 0.0627, 0.149, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.1, 0.22, 0.36), float4(0.52, 0.72, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx), 7u, 1u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 normal_1 : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_2 : LOC0;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float4 finite_vec4_(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return (((asuint(v) & exponent) != exponent) ? v : (0.0).xxxx);
}

float3 normalize_seen_balanced(float3 v_1)
{
    return (v_1 * rsqrt(max(dot(v_1, v_1), 1e-30)));
}

float atan2_positive(float y, float x)
{
    float small = min(y, x);
    float large = max(y, x);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_2 = (is_wide ? (series + 0.7853982) : series);
    return ((y > x) ? (HALF_PI - a_2) : a_2);
}

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float4 bounded_vec4_(float4 v_2)
{
    uint4 bits_1 = asuint(v_2);
    uint4 magnitude_1 = (bits_1 & (2147483647u).xxxx);
    float4 largest_1 = asfloat(((bits_1 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers = ((magnitude_1 == (2139095040u).xxxx) ? largest_1 : (0.0).xxxx);
    return ((magnitude_1 < (2139095040u).xxxx) ? v_2 : numbers);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d = float2(_e1, _e2);
    return sqrt(dot(d, d));
}

float4 hermite(float4 a_1, float4 b_1, float4 from_a, float4 to_b, float t)
{
    float4 d_1 = (b_1 - a_1);
    return (a_1 + (t * (from_a + (t * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t * ((from_a + to_b) - (2.0 * d_1))))))));
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

float4 ramp_at(Ramp ramp, float x_3, float w)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    uint i_2_ = 1u;
    uint at = 0u;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e28 = i_2_;
            i_2_ = (_e28 + 1u);
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 7u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places[min(uint(naga_div(_e17, 4u)), 3u)][min(uint(naga_mod(_e21, 4u)), 3u)];
        at = ((_e25 <= x_3) ? _e16 : _e15);
    }
    uint _e31 = at;
    uint _e35 = at;
    float place = places[min(uint(naga_div(_e31, 4u)), 3u)][min(uint(naga_mod(_e35, 4u)), 3u)];
    uint _e40 = at;
    if ((((_e40 + 1u) >= 7u) | (x_3 <= place))) {
        uint _e47 = at;
        float4 _e49 = colors[min(uint(_e47), 15u)];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = (_e50 + 1u);
    float _e59 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span = (_e59 - place);
    const float _e62 = divided((x_3 - place), span);
    float t_2 = clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if ((_e69 > 0u)) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places[min(uint(naga_div((_e72 - 1u), 4u)), 3u)][min(uint(naga_mod((_e78 - 1u), 4u)), 3u)];
        uint _e85 = at;
        float4 _e87 = colors[min(uint(_e85), 15u)];
        uint _e88 = at;
        float4 _e92 = colors[min(uint((_e88 - 1u)), 15u)];
        float4 _e96 = colors[min(uint(after_1), 15u)];
        uint _e97 = at;
        float4 _e99 = colors[min(uint(_e97), 15u)];
        const float4 _e101 = ramp_slope((_e87 - _e92), (place - before_1), (_e96 - _e99), span);
        from_a_1 = _e101;
    }
    if (((after_1 + 1u) < 7u)) {
        float _e119 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e119 - (place + span));
        float4 _e123 = colors[min(uint(after_1), 15u)];
        uint _e124 = at;
        float4 _e126 = colors[min(uint(_e124), 15u)];
        float4 _e131 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e133 = colors[min(uint(after_1), 15u)];
        const float4 _e135 = ramp_slope((_e123 - _e126), span, (_e131 - _e133), next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    float4 _e138 = colors[min(uint(_e136), 15u)];
    float4 _e140 = colors[min(uint(after_1), 15u)];
    float4 _e141 = from_a_1;
    float4 _e143 = to_b_1;
    const float4 _e145 = hermite(_e138, _e140, (span * _e141), (span * _e143), t_2);
    const float4 _e146 = bounded_vec4_(_e145);
    return _e146;
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

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle parametrization_screen_aligned_balanced(Light light, float3 normal, float3x3 camera_from_world)
{
    float3 d_2 = mul(normal, camera_from_world);
    const Angle angle = ConstructAngle((0.5 * length((d_2 - light.own_direction))), (0.5 * length((d_2 + light.own_direction))));
    return angle;
}

float4 shade(Surface surface)
{
    Light _e3 = look.key;
    float3x3 _e7 = look.camera_from_world;
    const Angle _e8 = parametrization_screen_aligned_balanced(_e3, surface.normal, _e7);
    const float _e9 = angle_radians(_e8);
    float angle_over_pi = (_e9 / 3.1415927);
    const float _e13 = footprint_of(angle_over_pi);
    const float4 _e14 = ramp_at(color_code, angle_over_pi, _e13);
    float4 output_alpha = float4(_e14.xyz, clamp(_e14.w, 0.0, 1.0));
    const float4 _e21 = premultiplied(output_alpha);
    const float4 _e22 = output(_e21);
    return _e22;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.normal = arg1;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view.clip_from_world;
    float3x3 _e14 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), mul(vertex.normal, _e14));
    const VertexOutput_vs_main varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    Surface surface_1 = ConstructSurface(normal_3);
    const float4 _e7 = shade(surface_1);
    const float4 _e8 = finite_vec4_(_e7);
    return _e8;
}
