// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds where surfaces end, fold and meet.
// Registers of space 0: surface t0, curvature b0.
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

struct Facet {
    float3 normal;
    int _pad1_0;
    float3 toward;
    float depth;
    float number;
    int _pad4_0;
    float2 rise;
    float2 gentle_rise;
    int _end_pad_0;
    int _end_pad_1;
};

struct Edge {
    int kind;
    int _pad1_0;
    float2 normal;
    float offset;
    float trust;
};

struct Course {
    float place;
    float slope;
    float trust;
};

struct CourseSums {
    float count;
    float x;
    float y;
    float xx;
    float xy;
    float yy;
    float xxy;
};

Texture2D<float4> surface : register(t0);
cbuffer curvature : register(b0) { Curvature curvature; }

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
    int side_1 = asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint((index_2 & int(1))))));
    int2 straight = ((index_2 < int(2)) ? int2(side_1, int(0)) : int2(int(0), side_1));
    return ((index_2 > int(3)) ? int2(side_1, asint(asuint(int(1)) - asuint((index_2 & int(2))))) : straight);
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
            float4 texel_1 = surface.Load(int3(near, int(0)));
            if ((texel_1.w != 0.0)) {
                seen = ConstructSeenPixel(near, texel_1);
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
    float pixel_9 = (_e5 * lerp(1.0, depth_1, _e8));
    float2 gradient = (normal_2.xy / (max(normal_2.z, 0.02)).xx);
    const float _e19 = row_direction();
    const Plane plane_1 = ConstructPlane(object, depth_1, ((pixel_9 * gradient) * float2(1.0, _e19)), ((2.0 * pixel_9) * (1.0 + length(gradient))));
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
    float4 texel_2 = _e1.texel;
    const float3 _e8 = normal_of(texel_2);
    const Plane _e9 = plane_of(abs(texel_2.w), texel_2.z, _e8);
    const Center center_2 = ConstructCenter(_e1.at, texel_2.xy, _e9);
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
    int reach = asint(asuint(steps) * asuint(_e3));
    float distance_1 = float(reach);
    int2 at_2 = center_.at;
    int2 last_1 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 a_1 = surface.Load(int3(int2(min(asint(asuint(at_2.x) + asuint(reach)), last_1.x), at_2.y), int(0)));
    float4 b_1 = surface.Load(int3(int2(max(asint(asuint(at_2.x) - asuint(reach)), int(0)), at_2.y), int(0)));
    float4 c = surface.Load(int3(int2(at_2.x, min(asint(asuint(at_2.y) + asuint(reach)), last_1.y)), int(0)));
    float4 d = surface.Load(int3(int2(at_2.x, max(asint(asuint(at_2.y) - asuint(reach)), int(0))), int(0)));
    bool4 is_inside = (int4(asint(asuint(last_1.x) - asuint(at_2.x)), at_2.x, asint(asuint(last_1.y) - asuint(at_2.y)), at_2.y) >= (reach).xxxx);
    float4 objects_1 = (is_inside ? abs(float4(a_1.w, b_1.w, c.w, d.w)) : (0.0).xxxx);
    float2 rise = (distance_1 * center_.plane.rise);
    float4 rises_1 = float4(rise.x, -(rise.x), rise.y, -(rise.y));
    const float4 _e86 = neighbor_weights(center_.plane, objects_1, float4(a_1.z, b_1.z, c.z, d.z), rises_1, distance_1);
    float4 shares = ((weight * distance_1) * _e86);
    const Ring ring_1 = ConstructRing((shares * (float4(a_1.x, b_1.x, c.x, d.x) - (center_.slope.x).xxxx)), (shares * (float4(a_1.y, b_1.y, c.y, d.y) - (center_.slope.y).xxxx)), (shares * distance_1));
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
    float4 trust_1 = smoothstep((0.0).xxxx, (0.5).xxxx, weights);
    float4 sides = ((changes / max(weights, (1e-6).xxxx)) * trust_1);
    float2 along = ((sides.xz - sides.yw) / max((trust_1.xz + trust_1.yw), (1e-6).xx));
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
    float4 x = (is_back ? (turn_1 - (3.0).xxxx) : ((1.0).xxxx - turn_1));
    float4 rest_1 = ((1.0).xxxx - abs(x));
    float4 y = (is_back ? -(rest_1) : rest_1);
    float4 size_1 = sqrt(((x * x) + (y * y)));
    const EdgeLines edgelines = ConstructEdgeLines((x / size_1), (y / size_1), (((place_2 + (0.5).xxxx) * (4.0 / levels)) - (2.0).xxxx));
    return edgelines;
}

float4 middle_distances(EdgeLines edges, float4 columns, float4 rows)
{
    float4 x_1 = (columns + (edges.x * edges.offset));
    float4 y_1 = (rows + (edges.y * edges.offset));
    float inward = ((x_1.x * edges.x.x) + (y_1.x * edges.y.x));
    float4 distances = sqrt(((x_1 * x_1) + (y_1 * y_1)));
    return float4(((inward < -1.0) ? 1000000000.0 : distances.x), distances.yzw);
}

float4 edge_distances(EdgeLines edges_1, float4 columns_1, float4 rows_1)
{
    float4 across = ((edges_1.offset + (edges_1.x * columns_1)) + (edges_1.y * rows_1));
    float4 along_1 = abs(((edges_1.y * columns_1) - (edges_1.x * rows_1)));
    float4 beyond = max((along_1 - (1.0).xxxx), (0.0).xxxx);
    float4 side_2 = float4(max(across.x, 0.0), abs(across.yzw));
    return sqrt(((side_2 * side_2) + (beyond * beyond)));
}

float pixel_size_at(float depth_2)
{
    float _e3 = curvature.pixel;
    float _e6 = curvature.perspective;
    return (_e3 * lerp(1.0, depth_2, _e6));
}

Facet ConstructFacet(float3 arg0, float3 arg1, float arg2, float arg3, float2 arg4, float2 arg5) {
    Facet ret = (Facet)0;
    ret.normal = arg0;
    ret.toward = arg1;
    ret.depth = arg2;
    ret.number = arg3;
    ret.rise = arg4;
    ret.gentle_rise = arg5;
    return ret;
}

Facet facet_at(int2 at)
{
    float4 texel_3 = surface.Load(int3(at, int(0)));
    const float3 _e4 = normal_of(texel_3);
    float2 middle = (0.5 * float2(NagaDimensions2D(surface)));
    const float _e15 = row_direction();
    float2 from_middle = (((float2(at) + (0.5).xx) - middle) * float2(1.0, _e15));
    float _e21 = curvature.pixel;
    float _e25 = curvature.perspective;
    float3 toward_2 = float3(((-(_e21) * _e25) * from_middle), 1.0);
    float facing_1 = dot(_e4, toward_2);
    const float _e32 = pixel_size_at(texel_3.z);
    const float _e35 = row_direction();
    float2 change_1 = ((_e32 * _e4.xy) * float2(1.0, _e35));
    const Facet facet_1 = ConstructFacet(_e4, toward_2, texel_3.z, abs(texel_3.w), (change_1 / (max(facing_1, 0.02)).xx), (change_1 / (max(facing_1, 0.2)).xx));
    return facet_1;
}

bool meets(Facet own, Facet other, float2 step_)
{
    bool local_1 = (bool)0;

    bool is_nearer = (own.depth <= other.depth);
    float rise_1 = dot((is_nearer ? own.gentle_rise : own.rise), step_);
    float other_rise = dot((is_nearer ? other.rise : other.gentle_rise), step_);
    float here = (own.depth - (other.depth - other_rise));
    float there = ((own.depth + rise_1) - other.depth);
    float steepness = min(length(own.gentle_rise), length(other.gentle_rise));
    const float _e30 = pixel_size_at(min(own.depth, other.depth));
    float tolerance = (_e30 + steepness);
    if (!(((here * there) <= 0.0))) {
        local_1 = (min(abs(here), abs(there)) <= tolerance);
    } else {
        local_1 = true;
    }
    bool _e43 = local_1;
    return _e43;
}

bool shows(int2 at_1, float number_2, float limit)
{
    bool local_2 = (bool)0;

    int2 last_2 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 texel_4 = surface.Load(int3(clamp(at_1, (int(0)).xx, last_2), int(0)));
    if ((abs(texel_4.w) == number_2)) {
        local_2 = (texel_4.z < limit);
    } else {
        local_2 = false;
    }
    bool _e23 = local_2;
    return _e23;
}

Course ConstructCourse(float arg0, float arg1, float arg2) {
    Course ret = (Course)0;
    ret.place = arg0;
    ret.slope = arg1;
    ret.trust = arg2;
    return ret;
}

Course fitted_course(CourseSums sums, bool is_arc)
{
    float trust_2 = (sums.count / 11.0);
    float spread = ((sums.count * sums.xx) - (sums.x * sums.x));
    float slope_1 = (((sums.count * sums.xy) - (sums.x * sums.y)) / spread);
    float straight_1 = ((sums.y - (slope_1 * sums.x)) / sums.count);
    if ((trust_2 < 1.0)) {
        const Course course_2 = ConstructCourse(clamp(straight_1, 0.0, 1.0), slope_1, trust_2);
        return course_2;
    }
    float bent = (((1958.0 * sums.y) - (sums.xx * sums.xxy)) / ((sums.count * 1958.0) - (sums.xx * sums.xx)));
    float left_1 = (((sums.yy - (straight_1 * sums.y)) - (slope_1 * sums.xy)) / sums.count);
    float share_1 = clamp(((left_1 - 0.09) / 0.05), 0.0, 1.0);
    const Course course_3 = ConstructCourse(clamp(lerp(straight_1, bent, (is_arc ? 1.0 : share_1)), 0.0, 1.0), slope_1, trust_2);
    return course_3;
}

int2 naga_abs(int2 val) {
    return val >= 0 ? val : asint(-asuint(val));
}

typedef float2 ret_Constructarray2_float2_[2];
ret_Constructarray2_float2_ Constructarray2_float2_(float2 arg0, float2 arg1) {
    float2 ret[2] = { arg0, arg1 };
    return ret;
}

CourseSums ConstructCourseSums(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, float arg6) {
    CourseSums ret = (CourseSums)0;
    ret.count = arg0;
    ret.x = arg1;
    ret.y = arg2;
    ret.xx = arg3;
    ret.xy = arg4;
    ret.yy = arg5;
    ret.xxy = arg6;
    return ret;
}

Course course_at(int2 pixel_2, int2 step_1, float number_3, float limit_1)
{
    float2 ends[2] = Constructarray2_float2_((0.0).xx, (0.0).xx);
    int changes_1 = int(0);
    CourseSums sums_1 = ConstructCourseSums(1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0);
    int side = int(0);
    int height = (int)0;
    bool is_open = (bool)0;
    int row = (int)0;
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;
    int change = (int)0;
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;
    bool local_7 = (bool)0;
    bool local_8 = (bool)0;
    bool local_9 = (bool)0;
    bool local_10 = (bool)0;

    int2 along_2 = naga_abs(step_1.yx);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e177 = side;
            side = asint(asuint(_e177) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e25 = side;
        if ((_e25 < int(2))) {
        } else {
            break;
        }
        {
            int _e28 = side;
            int2 way = asint(asuint(along_2) * asuint(asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint(_e28))))));
            height = int(0);
            is_open = true;
            row = int(1);
            uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
            while(true) {
                if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
                loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
                int _e40 = row;
                if ((_e40 <= int(12))) {
                    bool _e45 = is_open;
                    if (!(_e45)) {
                        int _e49 = row;
                        local_4 = (_e49 <= int(5));
                    } else {
                        local_4 = true;
                    }
                    bool _e53 = local_4;
                    local_3 = _e53;
                } else {
                    local_3 = false;
                }
                bool _e55 = local_3;
                if (_e55) {
                } else {
                    break;
                }
                {
                    int _e56 = row;
                    int _e59 = height;
                    int2 at_3 = asint(asuint(asint(asuint(pixel_2) + asuint(asint(asuint(way) * asuint(_e56))))) + asuint(asint(asuint(step_1) * asuint(_e59))));
                    change = int(0);
                    const bool _e64 = shows(at_3, number_3, limit_1);
                    if (_e64) {
                        const bool _e66 = shows(asint(asuint(at_3) + asuint(step_1)), number_3, limit_1);
                        if (_e66) {
                            change = int(1);
                        }
                    } else {
                        change = int(-1);
                    }
                    int _e69 = change;
                    if ((_e69 > int(0))) {
                        const bool _e77 = shows(asint(asuint(at_3) + asuint(asint(asuint(int(2)) * asuint(step_1)))), number_3, limit_1);
                        local_5 = _e77;
                    } else {
                        local_5 = false;
                    }
                    bool _e79 = local_5;
                    if (_e79) {
                        break;
                    }
                    int _e80 = change;
                    if ((_e80 < int(0))) {
                        const bool _e86 = shows(asint(asuint(at_3) - asuint(step_1)), number_3, limit_1);
                        local_6 = !(_e86);
                    } else {
                        local_6 = false;
                    }
                    bool _e89 = local_6;
                    if (_e89) {
                        break;
                    }
                    int _e90 = change;
                    if ((_e90 != int(0))) {
                        bool _e93 = is_open;
                        if (_e93) {
                            int _e94 = side;
                            int _e96 = row;
                            int _e100 = height;
                            int _e101 = height;
                            int _e102 = change;
                            ends[min(uint(_e94), 1u)] = float2((float(_e96) - 0.5), float(max(_e100, asint(asuint(_e101) + asuint(_e102)))));
                            is_open = false;
                        }
                        int _e108 = changes_1;
                        int _e109 = row;
                        changes_1 = asint(asuint(_e108) + asuint(((_e109 <= int(5)) ? int(1) : int(0))));
                        int _e116 = height;
                        int _e117 = change;
                        height = asint(asuint(_e116) + asuint(_e117));
                    }
                    int _e119 = row;
                    if ((_e119 <= int(5))) {
                        int _e122 = row;
                        int _e123 = side;
                        float x_2 = float(asint(asuint(_e122) * asuint(asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint(_e123)))))));
                        int _e130 = height;
                        float y_2 = (float(_e130) + 0.5);
                        float _e135 = sums_1.count;
                        sums_1.count = (_e135 + 1.0);
                        float _e139 = sums_1.x;
                        sums_1.x = (_e139 + x_2);
                        float _e142 = sums_1.y;
                        sums_1.y = (_e142 + y_2);
                        float _e145 = sums_1.xx;
                        sums_1.xx = (_e145 + (x_2 * x_2));
                        float _e149 = sums_1.xy;
                        sums_1.xy = (_e149 + (x_2 * y_2));
                        float _e153 = sums_1.yy;
                        sums_1.yy = (_e153 + (y_2 * y_2));
                        float _e157 = sums_1.xxy;
                        sums_1.xxy = (_e157 + ((x_2 * x_2) * y_2));
                    }
                    int _e162 = row;
                    row = asint(asuint(_e162) + asuint(int(1)));
                }
            }
            bool _e164 = is_open;
            if (_e164) {
                int _e165 = side;
                int _e167 = row;
                int _e171 = height;
                ends[min(uint(_e165), 1u)] = float2((float(_e167) - 0.5), (float(_e171) + 0.5));
            }
        }
    }
    float _e181 = ends[0].x;
    float _e184 = ends[1].x;
    float length_ = (_e181 + _e184);
    float _e188 = ends[0].y;
    float _e191 = ends[1].y;
    float slope_2 = ((_e188 - _e191) / length_);
    float _e196 = ends[1].y;
    float _e199 = ends[1].x;
    float place_3 = (_e196 + (slope_2 * _e199));
    float _e204 = ends[0].y;
    float _e207 = ends[1].y;
    if ((_e204 == _e207)) {
        local_7 = (place_3 != 0.5);
    } else {
        local_7 = false;
    }
    bool is_arc_1 = local_7;
    int _e215 = changes_1;
    if (!((_e215 >= int(3)))) {
        if (is_arc_1) {
            int _e223 = changes_1;
            local_9 = (_e223 >= int(2));
        } else {
            local_9 = false;
        }
        bool _e227 = local_9;
        local_8 = _e227;
    } else {
        local_8 = true;
    }
    bool _e229 = local_8;
    if (_e229) {
        float _e233 = sums_1.count;
        local_10 = (_e233 >= 7.0);
    } else {
        local_10 = false;
    }
    bool _e237 = local_10;
    if (_e237) {
        CourseSums _e238 = sums_1;
        const Course _e239 = fitted_course(_e238, is_arc_1);
        const Course course_4 = _e239;
        return course_4;
    }
    float _e242 = ends[0].x;
    float _e247 = ends[1].x;
    float rise_2 = (is_arc_1 ? (((4.0 * _e242) * _e247) / (length_ * length_)) : 0.0);
    float _e254 = sums_1.count;
    float trust_3 = (_e254 / 11.0);
    const Course course_5 = ConstructCourse(clamp(lerp(place_3, 0.5, rise_2), 0.0, 1.0), slope_2, trust_3);
    return course_5;
}

float facing_squared(Facet facet)
{
    float facing_2 = dot(facet.normal, facet.toward);
    return ((facing_2 * abs(facing_2)) / dot(facet.toward, facet.toward));
}

float2 course_normal(Course course, float2 toward)
{
    float2 along_3 = abs(toward.yx);
    return ((toward - (course.slope * along_3)) / (sqrt((1.0 + (course.slope * course.slope)))).xx);
}

Edge ConstructEdge(int arg0, float2 arg1, float arg2, float arg3) {
    Edge ret = (Edge)0;
    ret.kind = arg0;
    ret.normal = arg1;
    ret.offset = arg2;
    ret.trust = arg3;
    return ret;
}

Edge edge_along(int kind, Course course_1, float2 toward_1, float2 normal_4)
{
    float lean = dot(normal_4, toward_1);
    const Edge edge_1 = ConstructEdge(kind, normal_4, (course_1.place * lean), (course_1.trust * lean));
    return edge_1;
}

Edge silhouette(Facet own_1, int2 pixel_3, int2 step_2, float limit_2)
{
    bool local_11 = (bool)0;
    bool local_12 = (bool)0;
    bool local_13 = (bool)0;

    float2 toward_3 = float2(step_2);
    const Course _e6 = course_at(pixel_3, step_2, own_1.number, limit_2);
    int2 last_3 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    const Facet _e17 = facet_at(clamp(asint(asuint(pixel_3) - asuint(step_2)), (int(0)).xx, last_3));
    const float _e18 = facing_squared(own_1);
    const float _e19 = facing_squared(_e17);
    float change_2 = (_e19 - _e18);
    const float _e23 = row_direction();
    float2 across_1 = (own_1.normal.xy * float2(1.0, _e23));
    float2 normal_5 = (across_1 / (max(length(across_1), 1e-6)).xx);
    if ((_e17.number == own_1.number)) {
        local_11 = (_e18 < 0.36);
    } else {
        local_11 = false;
    }
    bool _e40 = local_11;
    if (_e40) {
        local_12 = (change_2 > 0.0001);
    } else {
        local_12 = false;
    }
    bool _e46 = local_12;
    if (_e46) {
        local_13 = (dot(normal_5, toward_3) > 0.5);
    } else {
        local_13 = false;
    }
    bool is_round = local_13;
    float found = (_e18 / max(change_2, 0.0001));
    float place_4 = clamp(found, 0.0, 1.0);
    float trust_4 = (is_round ? clamp((2.0 - (4.0 * abs((found - place_4)))), 0.0, 1.0) : 0.0);
    Course seen_1 = ConstructCourse(lerp(_e6.place, place_4, trust_4), _e6.slope, lerp(_e6.trust, 1.0, trust_4));
    const float2 _e78 = course_normal(_e6, toward_3);
    float2 turned = lerp(_e78, normal_5, trust_4);
    const Edge _e84 = edge_along(int(0), seen_1, toward_3, (turned / (length(turned)).xx));
    const Edge edge_2 = _e84;
    return edge_2;
}

float round_bend(Facet own_2, Facet other_1, int2 pixel_4, int2 step_3)
{
    int2 last_4 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 before = surface.Load(int3(clamp(asint(asuint(pixel_4) - asuint(step_3)), (int(0)).xx, last_4), int(0)));
    float4 after = surface.Load(int3(clamp(asint(asuint(pixel_4) + asuint(asint(asuint(int(2)) * asuint(step_3)))), (int(0)).xx, last_4), int(0)));
    const float3 _e26 = normal_of(before);
    const float3 _e30 = normal_of(after);
    float2 bends = float2(length((_e26 - own_2.normal)), length((_e30 - other_1.normal)));
    float2 numbers = float2(abs(before.w), abs(after.w));
    float2 shares_1 = ((numbers == (own_2.number).xx) ? (1.0).xx : (0.0).xx);
    return (dot(bends, shares_1) / max((shares_1.x + shares_1.y), 1.0));
}

Edge edge_between(Facet own_3, int2 pixel_5, int2 step_4)
{
    bool local_14 = (bool)0;
    bool local_15 = (bool)0;

    Edge none = ConstructEdge(int(-1), (0.0).xx, 0.0, 0.0);
    int2 at_4 = asint(asuint(pixel_5) + asuint(step_4));
    if (!(any((at_4 < (int(0)).xx)))) {
        local_14 = any((at_4 >= int2(NagaDimensions2D(surface))));
    } else {
        local_14 = true;
    }
    bool _e23 = local_14;
    if (_e23) {
        const Edge edge_3 = none;
        return edge_3;
    }
    const Facet _e24 = facet_at(at_4);
    if ((_e24.number == 0.0)) {
        const Edge _e29 = silhouette(own_3, pixel_5, step_4, 1000000000.0);
        const Edge edge_4 = _e29;
        return edge_4;
    }
    float2 toward_4 = float2(step_4);
    const float _e32 = object_in(own_3.number);
    const float _e34 = object_in(_e24.number);
    bool is_same_object = (_e32 == _e34);
    const bool _e36 = meets(own_3, _e24, toward_4);
    if (!(_e36)) {
        if ((own_3.depth > _e24.depth)) {
            const Edge edge_5 = none;
            return edge_5;
        }
        float middle_1 = (0.5 * (own_3.depth + _e24.depth));
        const Edge _e48 = silhouette(own_3, pixel_5, step_4, (is_same_object ? middle_1 : 1000000000.0));
        const Edge edge_6 = _e48;
        return edge_6;
    }
    if (!(is_same_object)) {
        const Edge edge_7 = ConstructEdge(int(2), (0.0).xx, 0.0, 0.0);
        return edge_7;
    }
    if ((own_3.number != _e24.number)) {
        const Edge edge_8 = ConstructEdge(int(3), (0.0).xx, 0.0, 0.0);
        return edge_8;
    }
    float bend = length((own_3.normal - _e24.normal));
    if (!((bend < 0.5176381))) {
        const float _e74 = round_bend(own_3, _e24, pixel_5, step_4);
        local_15 = ((bend - _e74) < 0.5176381);
    } else {
        local_15 = true;
    }
    bool _e79 = local_15;
    if (_e79) {
        const Edge edge_9 = none;
        return edge_9;
    }
    const Edge edge_10 = ConstructEdge(int(1), (0.0).xx, 0.0, 0.0);
    return edge_10;
}

Edge meeting(Facet own_4, int2 pixel_6, int2 step_5, int kind_1)
{
    bool local_16 = (bool)0;

    const Facet _e5 = facet_at(asint(asuint(pixel_6) + asuint(step_5)));
    float2 toward_5 = float2(step_5);
    float2 slope_3 = (own_4.rise - _e5.rise);
    float steepness_1 = length(slope_3);
    float here_1 = (own_4.depth - (_e5.depth - dot(_e5.rise, toward_5)));
    float side_3 = dot(slope_3, toward_5);
    const float _e20 = pixel_size_at(own_4.depth);
    if ((abs(side_3) > (0.1 * _e20))) {
        local_16 = (abs(side_3) > (0.3 * steepness_1));
    } else {
        local_16 = false;
    }
    bool _e31 = local_16;
    if (_e31) {
        float share_2 = clamp((-(here_1) / side_3), 0.0, 1.0);
        float2 normal_6 = (slope_3 / (((side_3 > 0.0) ? steepness_1 : -(steepness_1))).xx);
        float lean_1 = dot(normal_6, toward_5);
        const Edge edge_11 = ConstructEdge(kind_1, normal_6, (share_2 * lean_1), lean_1);
        return edge_11;
    }
    if ((kind_1 == int(1))) {
        const Edge edge_12 = ConstructEdge(kind_1, toward_5, 0.5, 0.0);
        return edge_12;
    }
    const Course _e53 = course_at(pixel_6, step_5, own_4.number, 1000000000.0);
    const float2 _e54 = course_normal(_e53, toward_5);
    const Edge _e55 = edge_along(kind_1, _e53, toward_5, _e54);
    const Edge edge_13 = _e55;
    return edge_13;
}

bool goes_on(Facet own_5, float2 slope, float size, int2 pixel_7, int2 step_6)
{
    bool local_17 = (bool)0;
    bool local_18 = (bool)0;

    int2 last_5 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 texel_5 = surface.Load(int3(clamp(asint(asuint(pixel_7) + asuint(step_6)), (int(0)).xx, last_5), int(0)));
    float2 change_3 = abs((texel_5.xy - slope));
    float error_1 = abs(((texel_5.z - own_5.depth) - dot(own_5.gentle_rise, float2(step_6))));
    if ((abs(texel_5.w) == own_5.number)) {
        local_17 = (error_1 <= size);
    } else {
        local_17 = false;
    }
    bool _e37 = local_17;
    if (_e37) {
        local_18 = (max(change_3.x, change_3.y) < 0.35);
    } else {
        local_18 = false;
    }
    bool _e46 = local_18;
    return _e46;
}

float4 edges_at(int2 pixel_8)
{
    uint left = 0u;
    int index_4 = int(0);
    float4 codes_2 = (0.0).xxxx;
    float4 trust = (-1.0).xxxx;
    int index_5 = (int)0;
    Edge edge = (Edge)0;

    const Facet _e1 = facet_at(pixel_8);
    if ((_e1.number == 0.0)) {
        return (0.0).xxxx;
    }
    float4 _e9 = surface.Load(int3(pixel_8, int(0)));
    float2 slope_4 = _e9.xy;
    const float _e12 = pixel_size_at(_e1.depth);
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_2) {
            int _e32 = index_4;
            index_4 = asint(asuint(_e32) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e17 = index_4;
        if ((_e17 < int(4))) {
        } else {
            break;
        }
        {
            uint _e20 = left;
            int _e22 = index_4;
            int _e26 = index_4;
            const int2 _e27 = around(_e26);
            const bool _e28 = goes_on(_e1, slope_4, _e12, pixel_8, _e27);
            left = (_e20 | (_e28 ? 0u : (1u << uint(_e22))));
        }
    }
    uint _e40 = left;
    index_5 = ((_e40 == 0u) ? int(4) : int(0));
    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_3) {
            int _e102 = index_5;
            index_5 = asint(asuint(_e102) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e47 = index_5;
        if ((_e47 < int(4))) {
        } else {
            break;
        }
        {
            uint _e50 = left;
            int _e51 = index_5;
            if ((((_e50 >> uint(_e51)) & 1u) == 0u)) {
                continue;
            }
            int _e58 = index_5;
            const int2 _e59 = around(_e58);
            const Edge _e60 = edge_between(_e1, pixel_8, _e59);
            edge = _e60;
            int _e63 = edge.kind;
            if ((_e63 == int(-1))) {
                continue;
            }
            int _e67 = edge.kind;
            if ((_e67 != int(0))) {
                int _e71 = edge.kind;
                const Edge _e72 = meeting(_e1, pixel_8, _e59, _e71);
                edge = _e72;
            }
            int _e74 = edge.kind;
            bool4 is_kind = ((_e74).xxxx == int4(int(0), int(1), int(2), int(3)));
            float _e83 = edge.trust;
            float4 _e85 = trust;
            bool4 is_better = (is_kind & ((_e83).xxxx > _e85));
            float4 _e88 = trust;
            float _e90 = edge.trust;
            trust = (is_better ? (_e90).xxxx : _e88);
            float4 _e93 = codes_2;
            float2 _e95 = edge.normal;
            float _e97 = edge.offset;
            const float _e98 = edge_code(_e95, _e97);
            codes_2 = (is_better ? (_e98).xxxx : _e93);
        }
    }
    float4 _e104 = codes_2;
    return _e104;
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
    const float4 _e3 = edges_at(naga_f2i32(position.xy));
    return _e3;
}
