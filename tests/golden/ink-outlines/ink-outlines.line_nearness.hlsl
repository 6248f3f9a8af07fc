// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds how near the nearest edges of each kind are.
// Registers of space 0: surface t0, curvature b0, edges_2 t1, columns_2 t2.
// ink-outlines.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};

struct SeenPixel {
    int2 at;
    int _pad1_0;
    int _pad1_1;
    float4 texel;
};

struct Plane {
    float object;
    float depth;
    float2 rise;
    float tolerance;
    int _end_pad_0;
};

struct Center {
    int2 at;
    float2 slope;
    Plane plane;
};

struct Ring {
    float4 x;
    float4 y;
    float4 weights;
};

struct EdgeLines {
    float4 x;
    float4 y;
    float4 offset;
};

struct Angle {
    float half_sin;
    float half_cos;
};

struct Light {
    float3 direction;
    int _pad1_0;
    float3 own_direction;
    int _pad2_0;
    float3 color;
    float intensity;
};

struct Curve {
    float4 points[16];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
};

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
};

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;

Texture2D<float4> surface : register(t0);
cbuffer curvature : register(b0) { Curvature curvature; }
Texture2D<float4> edges_2 : register(t1);
Texture2D<float4> columns_2 : register(t2);

struct FragmentInput_fs_main {
    float4 position_1 : SV_Position;
};

float2 slope_of(float3 normal)
{
    return (normal.xy / (max(normal.z, 0.2)).xx);
}

float4 surface_texel(float3 normal_1, float depth, float number)
{
    const float2 _e3 = slope_of(normal_1);
    return float4(_e3, depth, ((normal_1.z < 0.0) ? -(number) : number));
}

float3 normal_of(float4 texel)
{
    float2 aside = (0.2 * texel.xy);
    float rest = sqrt(max((1.0 - dot(aside, aside)), 0.0));
    float nz = ((texel.w < 0.0) ? -(rest) : rest);
    float3 facing = (float3(texel.xy, 1.0) / (sqrt((1.0 + dot(texel.xy, texel.xy)))).xxx);
    return ((nz >= 0.2) ? facing : float3(aside, nz));
}

float4 whole_picture(uint index_1)
{
    return float4(((float((index_1 & 1u)) * 4.0) - 1.0), ((float((index_1 >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

int step_pixels()
{
    float _e2 = curvature.viewport_height;
    return max(naga_f2i32(round((_e2 / 800.0))), int(1));
}

float row_direction()
{
    float _e2 = curvature.rows_up;
    return ((_e2 > 0.5) ? 1.0 : -1.0);
}

int2 around(int index_2)
{
    int side = asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint((index_2 & int(1))))));
    int2 straight = ((index_2 < int(2)) ? int2(side, int(0)) : int2(int(0), side));
    return ((index_2 > int(3)) ? int2(side, asint(asuint(int(1)) - asuint((index_2 & int(2))))) : straight);
}

SeenPixel ConstructSeenPixel(int2 arg0, float4 arg1) {
    SeenPixel ret = (SeenPixel)0;
    ret.at = arg0;
    ret.texel = arg1;
    return ret;
}

uint2 NagaDimensions2D(Texture2D<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z);
    return ret.xy;
}

SeenPixel seen_pixel(int2 pixel)
{
    SeenPixel seen = (SeenPixel)0;
    bool local = (bool)0;
    int index_3 = (int)0;

    float4 _e3 = surface.Load(int3(pixel, int(0)));
    seen = ConstructSeenPixel(pixel, _e3);
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float _e14 = curvature.samples;
    if ((_e14 >= 2.0)) {
        float _e21 = seen.texel.w;
        local = (_e21 == 0.0);
    } else {
        local = false;
    }
    bool may_be_missed = local;
    index_3 = (may_be_missed ? int(7) : int(-1));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e47 = index_3;
            index_3 = asint(asuint(_e47) - asuint(int(1)));
        }
        loop_init = false;
        int _e30 = index_3;
        if ((_e30 >= int(0))) {
        } else {
            break;
        }
        {
            int _e33 = index_3;
            const int2 _e34 = around(_e33);
            int2 near = clamp(asint(asuint(pixel) + asuint(_e34)), (int(0)).xx, last);
            float4 texel_2 = surface.Load(int3(near, int(0)));
            if ((texel_2.w != 0.0)) {
                seen = ConstructSeenPixel(near, texel_2);
            }
        }
    }
    SeenPixel _e49 = seen;
    const SeenPixel seenpixel = _e49;
    return seenpixel;
}

Plane ConstructPlane(float arg0, float arg1, float2 arg2, float arg3) {
    Plane ret = (Plane)0;
    ret.object = arg0;
    ret.depth = arg1;
    ret.rise = arg2;
    ret.tolerance = arg3;
    return ret;
}

Plane plane_of(float object, float depth_1, float3 normal_2)
{
    float _e5 = curvature.pixel;
    float _e8 = curvature.perspective;
    float pixel_4 = (_e5 * lerp(1.0, depth_1, _e8));
    float2 gradient = (normal_2.xy / (max(normal_2.z, 0.02)).xx);
    const float _e19 = row_direction();
    const Plane plane_1 = ConstructPlane(object, depth_1, ((pixel_4 * gradient) * float2(1.0, _e19)), ((2.0 * pixel_4) * (1.0 + length(gradient))));
    return plane_1;
}

float4 neighbor_weights(Plane plane, float4 objects, float4 depths, float4 rises, float distance_)
{
    float4 error = abs(((depths - (plane.depth).xxxx) - rises));
    float scale = (1.0 / max((plane.tolerance * distance_), 1e-30));
    float4 weights_1 = clamp(((2.0).xxxx - (error * scale)), (0.0).xxxx, (1.0).xxxx);
    return ((objects == (plane.object).xxxx) ? weights_1 : (0.0).xxxx);
}

Center ConstructCenter(int2 arg0, float2 arg1, Plane arg2) {
    Center ret = (Center)0;
    ret.at = arg0;
    ret.slope = arg1;
    ret.plane = arg2;
    return ret;
}

Center center_at(int2 pixel_1)
{
    const SeenPixel _e1 = seen_pixel(pixel_1);
    float4 texel_3 = _e1.texel;
    const float3 _e8 = normal_of(texel_3);
    const Plane _e9 = plane_of(abs(texel_3.w), texel_3.z, _e8);
    const Center center_2 = ConstructCenter(_e1.at, texel_3.xy, _e9);
    return center_2;
}

Ring ConstructRing(float4 arg0, float4 arg1, float4 arg2) {
    Ring ret = (Ring)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.weights = arg2;
    return ret;
}

Ring ring_at(Center center_, int steps, float weight)
{
    const int _e3 = step_pixels();
    int reach_3 = asint(asuint(steps) * asuint(_e3));
    float distance_3 = float(reach_3);
    int2 at = center_.at;
    int2 last_1 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 a_6 = surface.Load(int3(int2(min(asint(asuint(at.x) + asuint(reach_3)), last_1.x), at.y), int(0)));
    float4 b_6 = surface.Load(int3(int2(max(asint(asuint(at.x) - asuint(reach_3)), int(0)), at.y), int(0)));
    float4 c = surface.Load(int3(int2(at.x, min(asint(asuint(at.y) + asuint(reach_3)), last_1.y)), int(0)));
    float4 d_2 = surface.Load(int3(int2(at.x, max(asint(asuint(at.y) - asuint(reach_3)), int(0))), int(0)));
    bool4 is_inside = (int4(asint(asuint(last_1.x) - asuint(at.x)), at.x, asint(asuint(last_1.y) - asuint(at.y)), at.y) >= (reach_3).xxxx);
    float4 objects_1 = (is_inside ? abs(float4(a_6.w, b_6.w, c.w, d_2.w)) : (0.0).xxxx);
    float2 rise = (distance_3 * center_.plane.rise);
    float4 rises_1 = float4(rise.x, -(rise.x), rise.y, -(rise.y));
    const float4 _e86 = neighbor_weights(center_.plane, objects_1, float4(a_6.z, b_6.z, c.z, d_2.z), rises_1, distance_3);
    float4 shares_1 = ((weight * distance_3) * _e86);
    const Ring ring_1 = ConstructRing((shares_1 * (float4(a_6.x, b_6.x, c.x, d_2.x) - (center_.slope.x).xxxx)), (shares_1 * (float4(a_6.y, b_6.y, c.y, d_2.y) - (center_.slope.y).xxxx)), (shares_1 * distance_3));
    return ring_1;
}

Ring joined(Ring a, Ring b)
{
    const Ring ring_2 = ConstructRing((a.x + b.x), (a.y + b.y), (a.weights + b.weights));
    return ring_2;
}

Ring rings_at(Center center_1)
{
    const Ring _e3 = ring_at(center_1, int(1), 1.0);
    const Ring _e6 = ring_at(center_1, int(2), 0.85);
    const Ring _e7 = joined(_e3, _e6);
    const Ring _e10 = ring_at(center_1, int(3), 0.5);
    const Ring _e11 = joined(_e7, _e10);
    const Ring ring_3 = _e11;
    return ring_3;
}

float2 derivatives(float4 changes, float4 weights)
{
    float4 trust = smoothstep((0.0).xxxx, (0.5).xxxx, weights);
    float4 sides = ((changes / max(weights, (1e-6).xxxx)) * trust);
    float2 along = ((sides.xz - sides.yw) / max((trust.xz + trust.yw), (1e-6).xx));
    const float _e22 = row_direction();
    return (along * float2(1.0, _e22));
}

float mean_curvature(Ring ring)
{
    const float2 _e7 = derivatives(float4(ring.x.xy, ring.y.zw), ring.weights);
    float _e15 = curvature.viewport_height;
    return clamp(((0.5 * (_e7.x + _e7.y)) * _e15), -10000.0, 10000.0);
}

float object_in(float number_1)
{
    return floor(abs(number_1));
}

float edge_code(float2 normal_3, float offset)
{
    float share = (normal_3.x / max((abs(normal_3.x) + abs(normal_3.y)), 1e-20));
    float turn = ((normal_3.y >= 0.0) ? (1.0 - share) : (3.0 + share));
    float direction = min(floor((turn * 1024.0)), 4095.0);
    float place = floor(((clamp(offset, -1.99, 1.99) + 2.0) * 1024.0));
    return ((place * 4096.0) + direction);
}

float4 coarse_codes(float4 codes)
{
    float4 place_1 = floor((codes / (4096.0).xxxx));
    float4 direction_1 = (codes - (4096.0 * place_1));
    return ((floor((place_1 * 0.125)) * 512.0) + floor((direction_1 * 0.125)));
}

EdgeLines ConstructEdgeLines(float4 arg0, float4 arg1, float4 arg2) {
    EdgeLines ret = (EdgeLines)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.offset = arg2;
    return ret;
}

EdgeLines edges_of(float4 codes_1, float levels)
{
    float4 place_2 = floor((codes_1 / (levels).xxxx));
    float4 turn_1 = (((codes_1 - (levels * place_2)) + (0.5).xxxx) * (4.0 / levels));
    bool4 is_back = (turn_1 >= (2.0).xxxx);
    float4 x_28 = (is_back ? (turn_1 - (3.0).xxxx) : ((1.0).xxxx - turn_1));
    float4 rest_1 = ((1.0).xxxx - abs(x_28));
    float4 y_6 = (is_back ? -(rest_1) : rest_1);
    float4 size = sqrt(((x_28 * x_28) + (y_6 * y_6)));
    const EdgeLines edgelines = ConstructEdgeLines((x_28 / size), (y_6 / size), (((place_2 + (0.5).xxxx) * (4.0 / levels)) - (2.0).xxxx));
    return edgelines;
}

float4 middle_distances(EdgeLines edges, float4 columns, float4 rows)
{
    float4 x_29 = (columns + (edges.x * edges.offset));
    float4 y_7 = (rows + (edges.y * edges.offset));
    float inward = ((x_29.x * edges.x.x) + (y_7.x * edges.y.x));
    float4 distances = sqrt(((x_29 * x_29) + (y_7 * y_7)));
    return float4(((inward < -1.0) ? 1000000000.0 : distances.x), distances.yzw);
}

float4 edge_distances(EdgeLines edges_1, float4 columns_1, float4 rows_1)
{
    float4 across_1 = ((edges_1.offset + (edges_1.x * columns_1)) + (edges_1.y * rows_1));
    float4 along_1 = abs(((edges_1.y * columns_1) - (edges_1.x * rows_1)));
    float4 beyond = max((along_1 - (1.0).xxxx), (0.0).xxxx);
    float4 side_1 = float4(max(across_1.x, 0.0), abs(across_1.yzw));
    return sqrt(((side_1 * side_1) + (beyond * beyond)));
}

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
    uint3 exponent_2 = (2139095040u).xxx;
    return (((asuint(v) & exponent_2) != exponent_2) ? v : (0.0).xxx);
}

float4 finite_vec4_(float4 v_1)
{
    uint4 exponent_3 = (2139095040u).xxxx;
    return (((asuint(v_1) & exponent_3) != exponent_3) ? v_1 : (0.0).xxxx);
}

float3 normalize_or(float3 v_2, float3 otherwise_1)
{
    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if (!(((largest > 1e-30) & (largest < 1e30)))) {
        return otherwise_1;
    }
    float3 scaled = (v_2 * (1.0 / largest));
    float square = dot(scaled, scaled);
    const bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float exp2_stable(float x_2)
{
    float clamped_2 = clamp(x_2, -126.0, 127.99999);
    float whole = round(clamped_2);
    float f = (clamped_2 - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float power_of_two(int n)
{
    return asfloat((uint(asint(asuint(n) + asuint(int(127)))) << 23u));
}

float log2_stable(float x_3)
{
    uint bits = asuint(x_3);
    int exponent_4 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_4) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_4) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float log_stable(float x_4)
{
    const float _e2 = log2_stable(x_4);
    return (LN_2_ * _e2);
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

float log1p_negative(float y_1)
{
    if ((y_1 < 0.25)) {
        const float _e3 = log1p_negative_small(y_1);
        return _e3;
    }
    const float _e8 = log_stable(max((1.0 - y_1), 1.1754944e-38));
    return _e8;
}

float2 sin_cos_quarter(float x_5)
{
    float h = (0.5 * x_5);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c_1 = (1.0 - one_minus_c);
    return float2(((2.0 * s) * c_1), (1.0 - ((2.0 * s) * s)));
}

float2 sin_cos_eighth(float x_6)
{
    float y_8 = (x_6 * x_6);
    float s_1 = (x_6 * (1.0 + (y_8 * (-0.16666667 + (y_8 * (0.008333334 + (y_8 * (-0.0001984127 + (y_8 * 2.7557319e-6)))))))));
    float c_2 = (1.0 - (y_8 * (0.5 + (y_8 * (-0.041666668 + (y_8 * (0.0013888889 + (y_8 * (-2.4801588e-5 + (y_8 * 2.755732e-7))))))))));
    return float2(s_1, c_2);
}

float2 sin_cos_tiny(float x_7)
{
    float y_9 = (x_7 * x_7);
    float s_2 = (x_7 * (1.0 + (y_9 * (-0.16666667 + (y_9 * 0.008333334)))));
    float c_3 = (1.0 - (y_9 * (0.5 + (y_9 * (-0.041666668 + (y_9 * 0.0013888889))))));
    return float2(s_2, c_3);
}

float2 sin_cos_half(float x_8, float left)
{
    const float2 _e5 = sin_cos_quarter((0.5 * min(x_8, left)));
    return ((x_8 <= left) ? _e5 : _e5.yx);
}

float left_to_pi(float x_9)
{
    float coarse = max((3.1415927 - x_9), 0.0);
    return max((coarse - 8.742278e-8), 0.0);
}

float2 sin_cos(float x_10)
{
    float turns_1 = round((x_10 * 0.31830987));
    float r_3 = (((x_10 - (turns_1 * 3.140625)) - (turns_1 * 0.00096702576)) - (turns_1 * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns_1 - (2.0 * trunc((turns_1 * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r_3, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

float3 normalize_quick(float3 v_3, float3 otherwise_2)
{
    float square_1 = dot(v_3, v_3);
    bool is_usable = ((square_1 > 1e-30) & (square_1 < 1e36));
    return (is_usable ? (v_3 * rsqrt((is_usable ? square_1 : 1.0))) : otherwise_2);
}

float3 normalize_moderate(float3 v_4, float3 otherwise_3)
{
    float square_2 = dot(v_4, v_4);
    return ((square_2 > 1e-30) ? (v_4 * rsqrt(max(square_2, 1e-30))) : otherwise_3);
}

float3 normalize_seen(float3 v_5)
{
    const float3 _e5 = normalize_moderate(v_5, float3(0.0, 0.0, 1.0));
    return _e5;
}

float3 normalize_seen_balanced(float3 v_6)
{
    return (v_6 * rsqrt(max(dot(v_6, v_6), 1e-30)));
}

float2 sin_cos_quick(float x_11)
{
    float y_10 = (x_11 * x_11);
    float s_3 = (x_11 * (1.0 + (y_10 * (-0.16666666 + (y_10 * (0.0083332425 + (y_10 * (-0.0001982274 + (y_10 * 2.6347564e-6)))))))));
    float c_4 = (1.0 + (y_10 * (-0.5 + (y_10 * (0.04166666 + (y_10 * (-0.0013888652 + (y_10 * (2.477458e-5 - (y_10 * 2.6297516e-7))))))))));
    return float2(s_3, c_4);
}

float2 sin_cos_short(float x_12)
{
    float y_11 = (x_12 * x_12);
    float s_4 = (x_12 * (1.0 + (y_11 * (-0.16666542 + (y_11 * (0.008324197 - (y_11 * 0.00018846673)))))));
    float c_5 = (1.0 + (y_11 * (-0.4999999 + (y_11 * (0.04166567 + (y_11 * (-0.0013868611 + (y_11 * 2.3476086e-5))))))));
    return float2(s_4, c_5);
}

float log2_one_minus(float y_2)
{
    float series = ((-(y_2) * LOG2_E) * (1.0 + (y_2 * (0.5 + (y_2 * (0.33333334 + (y_2 * (0.25 + (y_2 * 0.2)))))))));
    return ((y_2 < 0.0625) ? series : log2(max((1.0 - y_2), 7.888609e-31)));
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_between(float3 d, float3 l)
{
    float p = length((d - l));
    float s_5 = length((d + l));
    float k = (1.0 / sqrt(max(((p * p) + (s_5 * s_5)), 1e-30)));
    const Angle angle = ConstructAngle((p * k), (s_5 * k));
    return angle;
}

float atan2_positive(float y_3, float x_13)
{
    float small = min(y_3, x_13);
    float large = max(y_3, x_13);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_5 = (small / large);
    bool is_wide = (t_5 > 0.41421357);
    float r_4 = (is_wide ? ((small - large) / (small + large)) : t_5);
    float r2_ = (r_4 * r_4);
    float series_1 = (r_4 * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_7 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_3 > x_13) ? (HALF_PI - a_7) : a_7);
}

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_of(float radians_)
{
    const float _e2 = finite_or(radians_, 0.0);
    float half_angle = (0.5 * clamp(_e2, 0.0, PI));
    const float2 _e8 = sin_cos_quarter(half_angle);
    const Angle angle_1 = ConstructAngle(max(_e8.x, 0.0), max(_e8.y, 0.0));
    return angle_1;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_6 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_6 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_6 <= 0.0) ? float2(1.0, 0.0) : float2(s_6, c_6));
    float2 turned = (((s_6 <= 0.0) & (s_6 < c_6)) ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_shifted(Angle u_2, float shift)
{
    const float2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    const Angle _e8 = angle_turned(u_2, _e7);
    const Angle angle_3 = _e8;
    return angle_3;
}

float angle_footprint(Angle u_3)
{
    float2 half_ = float2(u_3.half_sin, u_3.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w, 0.5);
    return min(_e13, 0.5);
}

Angle angle_of_units(float3 d_1, float3 l_1)
{
    const Angle angle_4 = ConstructAngle((0.5 * length((d_1 - l_1))), (0.5 * length((d_1 + l_1))));
    return angle_4;
}

float bounded(float x_14)
{
    uint bits_1 = asuint(x_14);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_14 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float2 bounded_vec2_(float2 v_7)
{
    uint2 bits_2 = asuint(v_7);
    uint2 magnitude_1 = (bits_2 & (2147483647u).xx);
    float2 largest_2 = asfloat(((bits_2 & (2147483648u).xx) | (2139095039u).xx));
    float2 numbers = ((magnitude_1 == (2139095040u).xx) ? largest_2 : (0.0).xx);
    return ((magnitude_1 < (2139095040u).xx) ? v_7 : numbers);
}

float3 bounded_vec3_(float3 v_8)
{
    uint3 bits_3 = asuint(v_8);
    uint3 magnitude_2 = (bits_3 & (2147483647u).xxx);
    float3 largest_3 = asfloat(((bits_3 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers_1 = ((magnitude_2 == (2139095040u).xxx) ? largest_3 : (0.0).xxx);
    return ((magnitude_2 < (2139095040u).xxx) ? v_8 : numbers_1);
}

float4 bounded_vec4_(float4 v_9)
{
    uint4 bits_4 = asuint(v_9);
    uint4 magnitude_3 = (bits_4 & (2147483647u).xxxx);
    float4 largest_4 = asfloat(((bits_4 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers_2 = ((magnitude_3 == (2139095040u).xxxx) ? largest_4 : (0.0).xxxx);
    return ((magnitude_3 < (2139095040u).xxxx) ? v_9 : numbers_2);
}

float divided(float a_1, float b_1)
{
    if ((abs(b_1) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a_1 / b_1));
    return _e7;
}

float modulo_floored(float x_15, float y_4)
{
    float size_1 = abs(y_4);
    if ((size_1 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float turned_1 = ((y_4 > 0.0) ? x_15 : -(x_15));
    const float _e11 = bounded((turned_1 / size_1));
    const float _e15 = bounded((turned_1 - (size_1 * floor(_e11))));
    float wrapped = ((_e15 < 0.0) ? (_e15 + size_1) : _e15);
    float inside = (((wrapped >= 0.0) & (wrapped < size_1)) ? wrapped : 0.0);
    return ((y_4 > 0.0) ? inside : -(inside));
}

float powered(float base, float exponent)
{
    const float _e2 = bounded(base);
    const float _e3 = bounded(exponent);
    if ((_e3 == 1.0)) {
        return _e2;
    }
    if ((_e3 == 0.0)) {
        return 1.0;
    }
    if ((_e3 == 2.0)) {
        const float _e12 = bounded((_e2 * _e2));
        return _e12;
    }
    float magnitude_4 = abs(_e2);
    const float _e16 = log2_stable(max(magnitude_4, SMALLEST_NORMAL));
    const float _e18 = bounded((_e3 * _e16));
    const float _e19 = exp2_stable(_e18);
    bool is_even = (floor((_e3 * 0.5)) == (_e3 * 0.5));
    float signed_ = (((_e2 < 0.0) & !(is_even)) ? -(_e19) : _e19);
    return ((magnitude_4 < SMALLEST_NORMAL) ? 0.0 : signed_);
}

float3 powered_vec3_(float3 base_1, float exponent_1)
{
    const float _e3 = powered(base_1.x, exponent_1);
    const float _e5 = powered(base_1.y, exponent_1);
    const float _e7 = powered(base_1.z, exponent_1);
    return float3(_e3, _e5, _e7);
}

float exponential_of(float x_16)
{
    const float _e3 = bounded((x_16 * LOG2_E));
    const float _e4 = exp2_stable(_e3);
    return _e4;
}

float logarithm_of(float x_17)
{
    const float _e1 = bounded(x_17);
    const float _e4 = log_stable(max(_e1, SMALLEST_NORMAL));
    return _e4;
}

float mixed(float a_2, float b_2, float t_1)
{
    const float _e4 = bounded((b_2 - a_2));
    const float _e14 = bounded(((t_1 < 0.5) ? (a_2 + (t_1 * _e4)) : (b_2 - ((1.0 - t_1) * _e4))));
    return _e14;
}

float2 mixed_vec2_(float2 a_3, float2 b_3, float t_2)
{
    const float2 _e4 = bounded_vec2_((b_3 - a_3));
    const float2 _e14 = bounded_vec2_(((t_2 < 0.5) ? (a_3 + (t_2 * _e4)) : (b_3 - ((1.0 - t_2) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_4, float3 b_4, float t_3)
{
    const float3 _e4 = bounded_vec3_((b_4 - a_4));
    const float3 _e14 = bounded_vec3_(((t_3 < 0.5) ? (a_4 + (t_3 * _e4)) : (b_4 - ((1.0 - t_3) * _e4))));
    return _e14;
}

float4 mixed_vec4_(float4 a_5, float4 b_5, float t_4)
{
    const float4 _e4 = bounded_vec4_((b_5 - a_5));
    const float4 _e14 = bounded_vec4_(((t_4 < 0.5) ? (a_5 + (t_4 * _e4)) : (b_5 - ((1.0 - t_4) * _e4))));
    return _e14;
}

float place_between(float x_18, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_18 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_18 - low) / _e12));
    return _e14;
}

float remapped(float x_19, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_19);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_20, float low_1, float high_1)
{
    const float _e3 = bounded(x_20);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_6 = clamp(_e6, 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float factor_of(float x_21, bool clamped_1)
{
    const float _e2 = bounded(x_21);
    const float _e3 = bounded(x_21);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float length_of(float3 v_10)
{
    const float3 _e1 = bounded_vec3_(v_10);
    float largest_5 = max(max(abs(_e1.x), abs(_e1.y)), abs(_e1.z));
    if ((largest_5 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e17 = bounded((largest_5 * length((_e1 / (largest_5).xxx))));
    return _e17;
}

float sine_low(float r)
{
    float y_12 = (r * r);
    float high_2 = mad(y_12, 2.5930888e-6, -0.00019803418);
    float s_7 = mad((r * y_12), mad(y_12, mad(y_12, high_2, 0.008332972), -0.16666655), r);
    return clamp(s_7, -1.0, 1.0);
}

float sine_turned(float r_1, float turns)
{
    const float _e2 = sine_low(r_1);
    return (_e2 * mad(frac((turns * 0.5)), -4.0, 1.0));
}

float sine_of(float x_22)
{
    const float _e1 = bounded(x_22);
    float turns_2 = round((_e1 * 0.31830987));
    float coarse_1 = mad(turns_2, -0.00096702576, mad(turns_2, -3.140625, _e1));
    float r_5 = mad(turns_2, -6.2783295e-7, coarse_1);
    const float _e14 = sine_turned(clamp(r_5, -1.6, 1.6), turns_2);
    return _e14;
}

float sine_near(float x_23)
{
    float turns_3 = round((x_23 * 0.31830987));
    float r_6 = mad(turns_3, -0.0009676536, mad(turns_3, -3.140625, x_23));
    const float _e8 = sine_turned(r_6, turns_3);
    return _e8;
}

float cosine_of(float x_24)
{
    const float _e1 = bounded(x_24);
    float turns_4 = round(((_e1 * 0.31830987) - 0.5));
    float middle_1 = (turns_4 + 0.5);
    float coarse_2 = mad(middle_1, -0.00096702576, mad(middle_1, -3.140625, _e1));
    float r_7 = mad(middle_1, -6.2783295e-7, coarse_2);
    const float _e19 = sine_turned(-(clamp(r_7, -1.6, 1.6)), turns_4);
    return _e19;
}

float cosine_near(float x_25)
{
    float turns_5 = round(((x_25 * 0.31830987) - 0.5));
    float middle_2 = (turns_5 + 0.5);
    float r_8 = mad(middle_2, 0.0009676536, mad(middle_2, 3.140625, -(x_25)));
    const float _e13 = sine_turned(r_8, turns_5);
    return _e13;
}

float cosine_low(float r_2)
{
    float y_13 = (r_2 * r_2);
    float high_3 = mad(y_13, mad(y_13, 1.8474174e-9, -2.7357322e-7), 2.4793637e-5);
    return mad(y_13, mad(y_13, mad(y_13, mad(y_13, high_3, -0.0013888741), 0.041666657), -0.5), 1.0);
}

float2 sin_cos_of(float x_26)
{
    const float _e1 = bounded(x_26);
    const float2 _e2 = sin_cos(_e1);
    return clamp(_e2, (-1.0).xx, (1.0).xx);
}

float angle_of_point(float y_5, float x_27)
{
    const float2 _e3 = bounded_vec2_(float2(x_27, y_5));
    float2 p_1 = abs(_e3);
    float2 scaled_1 = ((max(p_1.x, p_1.y) > 1.0) ? (0.5 * p_1) : p_1);
    const float _e15 = atan2_positive(scaled_1.y, scaled_1.x);
    float turned_2 = ((x_27 < 0.0) ? (PI - _e15) : _e15);
    return ((y_5 < 0.0) ? -(turned_2) : turned_2);
}

float line_reach(float viewport_height, float steps_1)
{
    return min((steps_1 * max(round((viewport_height / 800.0)), 1.0)), 31.0);
}

float4 own_nearness(float4 nearness, float2 middle, float depth_2, float object_1, float pixels, float reach)
{
    bool local_1 = (bool)0;
    bool local_2 = (bool)0;

    bool is_same_object = (middle.y == (object_1 + 1.0));
    float behind = ((depth_2 - middle.x) * pixels);
    if (!((middle.y == 0.0))) {
        if (is_same_object) {
            local_2 = (abs(behind) <= 8.0);
        } else {
            local_2 = false;
        }
        bool _e25 = local_2;
        local_1 = _e25;
    } else {
        local_1 = true;
    }
    bool is_own = local_1;
    bool is_in_front = (behind < (is_same_object ? -8.0 : -2.0));
    float4 other = float4((is_in_front ? reach : 0.0), 0.0, nearness.z, 0.0);
    return (is_own ? nearness : other);
}

float line_pixels(float width, float pixels_1)
{
    const float _e2 = bounded(width);
    const float _e6 = bounded(pixels_1);
    return (clamp(_e2, 0.0, 1000000.0) * clamp(_e6, 0.0, 1000000.0));
}

float4 line_widths(float width_1, float4 shares)
{
    const float4 _e4 = bounded_vec4_(shares);
    float4 widths_1 = (min(width_1, 10000.0) * clamp(_e4, (0.0).xxxx, (100.0).xxxx));
    return ((widths_1 > (1e-6).xxxx) ? widths_1 : (0.0).xxxx);
}

float inner_line_covers(float distance_1, float width_2)
{
    return clamp(((width_2 + 0.5) - distance_1), 0.0, min(width_2, 1.0));
}

float3 middle_line_covers(float3 distance_2, float3 width_3)
{
    float3 half_1 = (0.5 * width_3);
    return clamp((min((distance_2 + (0.5).xxx), half_1) - max((distance_2 - (0.5).xxx), -(half_1))), (0.0).xxx, (1.0).xxx);
}

float4 lines_cover(float4 nearness_1, float4 widths, float reach_1)
{
    float4 distance_4 = ((reach_1).xxxx - nearness_1);
    const float _e7 = inner_line_covers(distance_4.x, widths.x);
    const float3 _e10 = middle_line_covers(distance_4.yzw, widths.yzw);
    float4 covers = float4(_e7, _e10);
    return ((nearness_1 > (0.0).xxxx) ? covers : (0.0).xxxx);
}

bool is_same_surface(Plane own, float4 texel_1, float2 offset_1)
{
    bool local_3 = (bool)0;

    float error_1 = abs(((texel_1.z - own.depth) - dot(own.rise, offset_1)));
    const float _e11 = object_in(texel_1.w);
    const float _e13 = object_in(own.object);
    if ((_e11 == _e13)) {
        local_3 = (error_1 <= ((3.0 * own.tolerance) * max(length(offset_1), 1.0)));
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    return _e26;
}

int naga_neg(int val) {
    return asint(-asuint(val));
}

float4 nearest_in_column(int2 pixel_2, Plane own_1, int reach_2)
{
    float4 nearest = (1000000000.0).xxxx;
    float4 codes_2 = (0.0).xxxx;
    int row = (int)0;

    int2 last_2 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    row = max(naga_neg(reach_2), naga_neg(pixel_2.y));
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e76 = row;
            row = asint(asuint(_e76) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e20 = row;
        if ((_e20 <= min(reach_2, asint(asuint(last_2.y) - asuint(pixel_2.y))))) {
        } else {
            break;
        }
        {
            int _e26 = row;
            int2 at_1 = asint(asuint(pixel_2) + asuint(int2(int(0), _e26)));
            float4 found = edges_2.Load(int3(at_1, int(0)));
            if (all((found == (0.0).xxxx))) {
                continue;
            }
            float4 _e39 = surface.Load(int3(at_1, int(0)));
            int _e40 = row;
            const bool _e44 = is_same_surface(own_1, _e39, float2(0.0, float(_e40)));
            if (!(_e44)) {
                continue;
            }
            const EdgeLines _e49 = edges_of(found, 4096.0);
            int _e52 = row;
            const float4 _e55 = middle_distances(_e49, (0.0).xxxx, (float(_e52)).xxxx);
            float4 distances_1 = ((found > (0.0).xxxx) ? _e55 : (1000000000.0).xxxx);
            float4 _e60 = nearest;
            bool4 is_nearer = (distances_1 < _e60);
            float4 _e62 = nearest;
            nearest = (is_nearer ? distances_1 : _e62);
            float4 _e64 = codes_2;
            const float4 _e65 = coarse_codes(found);
            int _e66 = row;
            codes_2 = (is_nearer ? (_e65 + ((262144.0 * (float(_e66) + 31.0))).xxxx) : _e64);
        }
    }
    float4 _e78 = codes_2;
    return _e78;
}

int4 naga_f2i32(float4 value) {
    return int4(clamp(value, -2147483600.0, 2147483500.0));
}

float4 nearness_at(int2 pixel_3, Plane own_2)
{
    float4 nearest_1 = (1000000000.0).xxxx;
    float4 across = (0.0).xxxx;
    float4 down = (0.0).xxxx;
    int column = (int)0;
    bool local_4 = (bool)0;

    int2 last_3 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float _e10 = curvature.viewport_height;
    const float _e12 = line_reach(_e10, 16.0);
    int reach_4 = naga_f2i32(_e12);
    column = max(naga_neg(reach_4), naga_neg(pixel_3.x));
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e95 = column;
            column = asint(asuint(_e95) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e28 = column;
        if ((_e28 <= min(reach_4, asint(asuint(last_3.x) - asuint(pixel_3.x))))) {
        } else {
            break;
        }
        {
            int _e34 = column;
            int2 at_2 = asint(asuint(pixel_3) + asuint(int2(_e34, int(0))));
            float4 found_1 = columns_2.Load(int3(at_2, int(0)));
            if (all((found_1 == (0.0).xxxx))) {
                continue;
            }
            int _e45 = column;
            if ((_e45 != int(0))) {
                float4 _e52 = surface.Load(int3(at_2, int(0)));
                int _e53 = column;
                const bool _e57 = is_same_surface(own_2, _e52, float2(float(_e53), 0.0));
                local_4 = !(_e57);
            } else {
                local_4 = false;
            }
            bool _e60 = local_4;
            if (_e60) {
                continue;
            }
            float4 rows_2 = floor((found_1 / (262144.0).xxxx));
            const EdgeLines _e69 = edges_of((found_1 - (262144.0 * rows_2)), 512.0);
            float4 places = (rows_2 - (31.0).xxxx);
            int _e75 = column;
            const float4 _e78 = middle_distances(_e69, (float(_e75)).xxxx, places);
            float4 distances_2 = ((found_1 > (0.0).xxxx) ? _e78 : (1000000000.0).xxxx);
            float4 _e83 = nearest_1;
            bool4 is_nearer_1 = (distances_2 < _e83);
            float4 _e85 = nearest_1;
            nearest_1 = (is_nearer_1 ? distances_2 : _e85);
            float4 _e87 = across;
            int _e88 = column;
            across = (is_nearer_1 ? (float(_e88)).xxxx : _e87);
            float4 _e92 = down;
            down = (is_nearer_1 ? places : _e92);
        }
    }
    float4 _e97 = nearest_1;
    if (all((_e97 >= (1000000000.0).xxxx))) {
        return (0.0).xxxx;
    }
    float4 _e105 = across;
    int4 x_30 = asint(asuint((pixel_3.x).xxxx) + asuint(naga_f2i32(_e105)));
    float4 _e110 = down;
    int4 y_14 = asint(asuint((pixel_3.y).xxxx) + asuint(naga_f2i32(_e110)));
    float4 _e119 = edges_2.Load(int3(int2(x_30.x, y_14.x), int(0)));
    float4 _e126 = edges_2.Load(int3(int2(x_30.y, y_14.y), int(0)));
    float4 _e133 = edges_2.Load(int3(int2(x_30.z, y_14.z), int(0)));
    float4 _e140 = edges_2.Load(int3(int2(x_30.w, y_14.w), int(0)));
    float4 codes_3 = float4(_e119.x, _e126.y, _e133.z, _e140.w);
    const EdgeLines _e144 = edges_of(codes_3, 4096.0);
    float4 _e145 = across;
    float4 _e146 = down;
    const float4 _e147 = edge_distances(_e144, _e145, _e146);
    float4 nearness_2 = clamp(((float(reach_4)).xxxx - _e147), (0.0).xxxx, (float(reach_4)).xxxx);
    float4 _e158 = nearest_1;
    return ((_e158 < (1000000000.0).xxxx) ? nearness_2 : (0.0).xxxx);
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    const float4 _e1 = whole_picture(index);
    return _e1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    float4 position = fragmentinput_fs_main.position_1;
    int2 pixel_5 = naga_f2i32(position.xy);
    const SeenPixel _e3 = seen_pixel(pixel_5);
    float4 seen_1 = _e3.texel;
    if ((seen_1.w == 0.0)) {
        return (0.0).xxxx;
    }
    const float3 _e13 = normal_of(seen_1);
    const Plane _e14 = plane_of(abs(seen_1.w), seen_1.z, _e13);
    const float4 _e15 = nearness_at(pixel_5, _e14);
    return _e15;
}
