// Ink outlines: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Finds where surfaces end, fold and meet.
// Arguments of both functions: surface texture(0), curvature buffer(0).
// ink-outlines.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};
struct SeenPixel {
    metal::int2 at;
    char _pad1[8];
    metal::float4 texel;
};
struct Plane {
    float object;
    float depth;
    metal::float2 rise;
    float tolerance;
    char _pad4[4];
};
struct Center {
    metal::int2 at;
    metal::float2 slope;
    Plane plane;
};
struct Ring {
    metal::float4 x;
    metal::float4 y;
    metal::float4 weights;
};
struct EdgeLines {
    metal::float4 x;
    metal::float4 y;
    metal::float4 offset;
};
struct Facet {
    metal::float3 normal;
    metal::packed_float3 toward;
    float depth;
    float number;
    char _pad4[4];
    metal::float2 rise;
    metal::float2 gentle_rise;
    char _pad6[8];
};
struct Edge {
    int kind;
    char _pad1[4];
    metal::float2 normal;
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
struct type_10 {
    metal::float2 inner[2];
};

metal::float2 slope_of(
    metal::float3 normal
) {
    return normal.xy / metal::float2(metal::max(normal.z, 0.2));
}

metal::float4 surface_texel(
    metal::float3 normal_1,
    float depth,
    float number
) {
    metal::float2 _e3 = slope_of(normal_1);
    return metal::float4(_e3, depth, (normal_1.z < 0.0) ? -(number) : number);
}

metal::float3 normal_of(
    metal::float4 texel
) {
    metal::float2 aside = 0.2 * texel.xy;
    float rest = metal::sqrt(metal::max(1.0 - metal::dot(aside, aside), 0.0));
    float nz = (texel.w < 0.0) ? -(rest) : rest;
    metal::float3 facing = metal::float3(texel.xy, 1.0) / metal::float3(metal::sqrt(1.0 + metal::dot(texel.xy, texel.xy)));
    return (nz >= 0.2) ? facing : metal::float3(aside, nz);
}

metal::float4 whole_picture(
    uint index_1
) {
    return metal::float4((static_cast<float>(index_1 & 1u) * 4.0) - 1.0, (static_cast<float>(index_1 >> 1u) * 4.0) - 1.0, 0.0, 1.0);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int step_pixels(
    constant Curvature& curvature
) {
    float _e2 = curvature.viewport_height;
    return metal::max(naga_f2i32(metal::rint(_e2 / 800.0)), 1);
}

float row_direction(
    constant Curvature& curvature
) {
    float _e2 = curvature.rows_up;
    return (_e2 > 0.5) ? 1.0 : -1.0;
}

metal::int2 around(
    int index_2
) {
    int side_1 = as_type<int>(as_type<uint>(1) - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(index_2 & 1))));
    metal::int2 straight = (index_2 < 2) ? metal::int2(side_1, 0) : metal::int2(0, side_1);
    return (index_2 > 3) ? metal::int2(side_1, as_type<int>(as_type<uint>(1) - as_type<uint>(index_2 & 2))) : straight;
}

SeenPixel seen_pixel(
    metal::int2 pixel,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel seen = {};
    bool local = {};
    int index_3 = {};
    metal::float4 _e3 = surface.read(metal::uint2(pixel), 0);
    seen = SeenPixel {pixel, {}, _e3};
    metal::int2 last = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    float _e14 = curvature.samples;
    if (_e14 >= 2.0) {
        float _e21 = seen.texel.w;
        local = _e21 == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
    index_3 = may_be_missed ? 7 : -1;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e47 = index_3;
            index_3 = as_type<int>(as_type<uint>(_e47) - as_type<uint>(1));
        }
        loop_init = false;
        int _e30 = index_3;
        if (_e30 >= 0) {
        } else {
            break;
        }
        {
            int _e33 = index_3;
            metal::int2 _e34 = around(_e33);
            metal::int2 near = metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel) + as_type<metal::uint2>(_e34)), metal::int2(0), last);
            metal::float4 texel_1 = surface.read(metal::uint2(near), 0);
            if (texel_1.w != 0.0) {
                seen = SeenPixel {near, {}, texel_1};
            }
        }
    }
    SeenPixel _e49 = seen;
    return _e49;
}

Plane plane_of(
    float object,
    float depth_1,
    metal::float3 normal_2,
    constant Curvature& curvature
) {
    float _e5 = curvature.pixel;
    float _e8 = curvature.perspective;
    float pixel_9 = _e5 * metal::mix(1.0, depth_1, _e8);
    metal::float2 gradient = normal_2.xy / metal::float2(metal::max(normal_2.z, 0.02));
    float _e19 = row_direction(curvature);
    return Plane {object, depth_1, (pixel_9 * gradient) * metal::float2(1.0, _e19), (2.0 * pixel_9) * (1.0 + metal::length(gradient))};
}

metal::float4 neighbor_weights(
    Plane plane,
    metal::float4 objects,
    metal::float4 depths,
    metal::float4 rises,
    float distance
) {
    metal::float4 error = metal::abs((depths - metal::float4(plane.depth)) - rises);
    float scale = 1.0 / metal::max(plane.tolerance * distance, 0.000000000000000000000000000001);
    metal::float4 weights_1 = metal::clamp(metal::float4(2.0) - (error * scale), metal::float4(0.0), metal::float4(1.0));
    return metal::select(metal::float4(0.0), weights_1, objects == metal::float4(plane.object));
}

Center center_at(
    metal::int2 pixel_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    SeenPixel _e1 = seen_pixel(pixel_1, surface, curvature);
    metal::float4 texel_2 = _e1.texel;
    metal::float3 _e8 = normal_of(texel_2);
    Plane _e9 = plane_of(metal::abs(_e1.texel.w), _e1.texel.z, _e8, curvature);
    return Center {_e1.at, texel_2.xy, _e9};
}

Ring ring_at(
    Center center,
    int steps,
    float weight,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    int _e3 = step_pixels(curvature);
    int reach = as_type<int>(as_type<uint>(steps) * as_type<uint>(_e3));
    float distance_1 = static_cast<float>(reach);
    metal::int2 at_2 = center.at;
    metal::int2 last_1 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 a_1 = surface.read(metal::uint2(metal::int2(metal::min(as_type<int>(as_type<uint>(center.at.x) + as_type<uint>(reach)), last_1.x), center.at.y)), 0);
    metal::float4 b_1 = surface.read(metal::uint2(metal::int2(metal::max(as_type<int>(as_type<uint>(center.at.x) - as_type<uint>(reach)), 0), center.at.y)), 0);
    metal::float4 c = surface.read(metal::uint2(metal::int2(center.at.x, metal::min(as_type<int>(as_type<uint>(center.at.y) + as_type<uint>(reach)), last_1.y))), 0);
    metal::float4 d = surface.read(metal::uint2(metal::int2(center.at.x, metal::max(as_type<int>(as_type<uint>(center.at.y) - as_type<uint>(reach)), 0))), 0);
    metal::bool4 is_inside = metal::int4(as_type<int>(as_type<uint>(last_1.x) - as_type<uint>(center.at.x)), center.at.x, as_type<int>(as_type<uint>(last_1.y) - as_type<uint>(center.at.y)), center.at.y) >= metal::int4(reach);
    metal::float4 objects_1 = metal::select(metal::float4(0.0), metal::abs(metal::float4(a_1.w, b_1.w, c.w, d.w)), is_inside);
    metal::float2 rise = distance_1 * center.plane.rise;
    metal::float4 rises_1 = metal::float4(rise.x, -(rise.x), rise.y, -(rise.y));
    metal::float4 _e86 = neighbor_weights(center.plane, objects_1, metal::float4(a_1.z, b_1.z, c.z, d.z), rises_1, distance_1);
    metal::float4 shares = (weight * distance_1) * _e86;
    return Ring {shares * (metal::float4(a_1.x, b_1.x, c.x, d.x) - metal::float4(center.slope.x)), shares * (metal::float4(a_1.y, b_1.y, c.y, d.y) - metal::float4(center.slope.y)), shares * distance_1};
}

Ring joined(
    Ring a,
    Ring b
) {
    return Ring {a.x + b.x, a.y + b.y, a.weights + b.weights};
}

Ring rings_at(
    Center center_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    Ring _e3 = ring_at(center_1, 1, 1.0, surface, curvature);
    Ring _e6 = ring_at(center_1, 2, 0.85, surface, curvature);
    Ring _e7 = joined(_e3, _e6);
    Ring _e10 = ring_at(center_1, 3, 0.5, surface, curvature);
    Ring _e11 = joined(_e7, _e10);
    return _e11;
}

metal::float2 derivatives(
    metal::float4 changes,
    metal::float4 weights,
    constant Curvature& curvature
) {
    metal::float4 trust_1 = metal::smoothstep(metal::float4(0.0), metal::float4(0.5), weights);
    metal::float4 sides = (changes / metal::max(weights, metal::float4(0.000001))) * trust_1;
    metal::float2 along = (sides.xz - sides.yw) / metal::max(trust_1.xz + trust_1.yw, metal::float2(0.000001));
    float _e22 = row_direction(curvature);
    return along * metal::float2(1.0, _e22);
}

float mean_curvature(
    Ring ring,
    constant Curvature& curvature
) {
    metal::float2 _e7 = derivatives(metal::float4(ring.x.xy, ring.y.zw), ring.weights, curvature);
    float _e15 = curvature.viewport_height;
    return metal::clamp((0.5 * (_e7.x + _e7.y)) * _e15, -10000.0, 10000.0);
}

float object_in(
    float number_1
) {
    return metal::floor(metal::abs(number_1));
}

float edge_code(
    metal::float2 normal_3,
    float offset
) {
    float share = normal_3.x / metal::max(metal::abs(normal_3.x) + metal::abs(normal_3.y), 0.00000000000000000001);
    float turn = (normal_3.y >= 0.0) ? (1.0 - share) : (3.0 + share);
    float direction = metal::min(metal::floor(turn * 1024.0), 4095.0);
    float place = metal::floor((metal::clamp(offset, -1.99, 1.99) + 2.0) * 1024.0);
    return (place * 4096.0) + direction;
}

metal::float4 coarse_codes(
    metal::float4 codes
) {
    metal::float4 place_1 = metal::floor(codes / metal::float4(4096.0));
    metal::float4 direction_1 = codes - (4096.0 * place_1);
    return (metal::floor(place_1 * 0.125) * 512.0) + metal::floor(direction_1 * 0.125);
}

EdgeLines edges_of(
    metal::float4 codes_1,
    float levels
) {
    metal::float4 place_2 = metal::floor(codes_1 / metal::float4(levels));
    metal::float4 turn_1 = ((codes_1 - (levels * place_2)) + metal::float4(0.5)) * (4.0 / levels);
    metal::bool4 is_back = turn_1 >= metal::float4(2.0);
    metal::float4 x = metal::select(metal::float4(1.0) - turn_1, turn_1 - metal::float4(3.0), is_back);
    metal::float4 rest_1 = metal::float4(1.0) - metal::abs(x);
    metal::float4 y = metal::select(rest_1, -(rest_1), is_back);
    metal::float4 size_1 = metal::sqrt((x * x) + (y * y));
    return EdgeLines {x / size_1, y / size_1, ((place_2 + metal::float4(0.5)) * (4.0 / levels)) - metal::float4(2.0)};
}

metal::float4 middle_distances(
    EdgeLines edges,
    metal::float4 columns,
    metal::float4 rows
) {
    metal::float4 x_1 = columns + (edges.x * edges.offset);
    metal::float4 y_1 = rows + (edges.y * edges.offset);
    float inward = (x_1.x * edges.x.x) + (y_1.x * edges.y.x);
    metal::float4 distances = metal::sqrt((x_1 * x_1) + (y_1 * y_1));
    return metal::float4((inward < -1.0) ? 1000000000.0 : distances.x, distances.yzw);
}

metal::float4 edge_distances(
    EdgeLines edges_1,
    metal::float4 columns_1,
    metal::float4 rows_1
) {
    metal::float4 across = (edges_1.offset + (edges_1.x * columns_1)) + (edges_1.y * rows_1);
    metal::float4 along_1 = metal::abs((edges_1.y * columns_1) - (edges_1.x * rows_1));
    metal::float4 beyond = metal::max(along_1 - metal::float4(1.0), metal::float4(0.0));
    metal::float4 side_2 = metal::float4(metal::max(across.x, 0.0), metal::abs(across.yzw));
    return metal::sqrt((side_2 * side_2) + (beyond * beyond));
}

float pixel_size_at(
    float depth_2,
    constant Curvature& curvature
) {
    float _e3 = curvature.pixel;
    float _e6 = curvature.perspective;
    return _e3 * metal::mix(1.0, depth_2, _e6);
}

Facet facet_at(
    metal::int2 at,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    metal::float4 texel_3 = surface.read(metal::uint2(at), 0);
    metal::float3 _e4 = normal_of(texel_3);
    metal::float2 middle = 0.5 * static_cast<metal::float2>(metal::uint2(surface.get_width(), surface.get_height()));
    float _e15 = row_direction(curvature);
    metal::float2 from_middle = ((static_cast<metal::float2>(at) + metal::float2(0.5)) - middle) * metal::float2(1.0, _e15);
    float _e21 = curvature.pixel;
    float _e25 = curvature.perspective;
    metal::float3 toward_2 = metal::float3((-(_e21) * _e25) * from_middle, 1.0);
    float facing_1 = metal::dot(_e4, toward_2);
    float _e32 = pixel_size_at(texel_3.z, curvature);
    float _e35 = row_direction(curvature);
    metal::float2 change_1 = (_e32 * _e4.xy) * metal::float2(1.0, _e35);
    return Facet {_e4, toward_2, texel_3.z, metal::abs(texel_3.w), {}, change_1 / metal::float2(metal::max(facing_1, 0.02)), change_1 / metal::float2(metal::max(facing_1, 0.2))};
}

bool meets(
    Facet own,
    Facet other,
    metal::float2 step,
    constant Curvature& curvature
) {
    bool local_1 = {};
    bool is_nearer = own.depth <= other.depth;
    float rise_1 = metal::dot(is_nearer ? own.gentle_rise : own.rise, step);
    float other_rise = metal::dot(is_nearer ? other.rise : other.gentle_rise, step);
    float here = own.depth - (other.depth - other_rise);
    float there = (own.depth + rise_1) - other.depth;
    float steepness = metal::min(metal::length(own.gentle_rise), metal::length(other.gentle_rise));
    float _e30 = pixel_size_at(metal::min(own.depth, other.depth), curvature);
    float tolerance = _e30 + steepness;
    if (!(((here * there) <= 0.0))) {
        local_1 = metal::min(metal::abs(here), metal::abs(there)) <= tolerance;
    } else {
        local_1 = true;
    }
    bool _e43 = local_1;
    return _e43;
}

bool shows(
    metal::int2 at_1,
    float number_2,
    float limit,
    metal::texture2d<float, metal::access::sample> surface
) {
    bool local_2 = {};
    metal::int2 last_2 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 texel_4 = surface.read(metal::uint2(metal::clamp(at_1, metal::int2(0), last_2)), 0);
    if (metal::abs(texel_4.w) == number_2) {
        local_2 = texel_4.z < limit;
    } else {
        local_2 = false;
    }
    bool _e23 = local_2;
    return _e23;
}

Course fitted_course(
    CourseSums sums,
    bool is_arc
) {
    float trust_2 = sums.count / 11.0;
    float spread = (sums.count * sums.xx) - (sums.x * sums.x);
    float slope_1 = ((sums.count * sums.xy) - (sums.x * sums.y)) / spread;
    float straight_1 = (sums.y - (slope_1 * sums.x)) / sums.count;
    if (trust_2 < 1.0) {
        return Course {metal::clamp(straight_1, 0.0, 1.0), slope_1, trust_2};
    }
    float bent = ((1958.0 * sums.y) - (sums.xx * sums.xxy)) / ((sums.count * 1958.0) - (sums.xx * sums.xx));
    float left_1 = ((sums.yy - (straight_1 * sums.y)) - (slope_1 * sums.xy)) / sums.count;
    float share_1 = metal::clamp((left_1 - 0.09) / 0.05, 0.0, 1.0);
    return Course {metal::clamp(metal::mix(straight_1, bent, is_arc ? 1.0 : share_1), 0.0, 1.0), slope_1, trust_2};
}

metal::int2 naga_abs(metal::int2 val) {
    return metal::select(as_type<metal::int2>(-as_type<metal::uint2>(val)), val, val >= 0);
}

Course course_at(
    metal::int2 pixel_2,
    metal::int2 step_1,
    float number_3,
    float limit_1,
    metal::texture2d<float, metal::access::sample> surface
) {
    type_10 ends = type_10 {{metal::float2(0.0), metal::float2(0.0)}};
    int changes_1 = 0;
    CourseSums sums_1 = CourseSums {1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0};
    int side = 0;
    int height = {};
    bool is_open = {};
    int row = {};
    bool local_3 = {};
    bool local_4 = {};
    int change = {};
    bool local_5 = {};
    bool local_6 = {};
    bool local_7 = {};
    bool local_8 = {};
    bool local_9 = {};
    bool local_10 = {};
    metal::int2 along_2 = naga_abs(step_1.yx);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e177 = side;
            side = as_type<int>(as_type<uint>(_e177) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e25 = side;
        if (_e25 < 2) {
        } else {
            break;
        }
        {
            int _e28 = side;
            metal::int2 way = as_type<metal::int2>(as_type<metal::uint2>(along_2) * as_type<uint>(as_type<int>(as_type<uint>(1) - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(_e28))))));
            height = 0;
            is_open = true;
            row = 1;
            uint2 loop_bound_2 = uint2(4294967295u);
            while(true) {
                if (metal::all(loop_bound_2 == uint2(0u))) { break; }
                loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
                int _e40 = row;
                if (_e40 <= 12) {
                    bool _e45 = is_open;
                    if (!(_e45)) {
                        int _e49 = row;
                        local_4 = _e49 <= 5;
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
                    metal::int2 at_3 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(pixel_2) + as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(way) * as_type<uint>(_e56))))) + as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(step_1) * as_type<uint>(_e59))));
                    change = 0;
                    bool _e64 = shows(at_3, number_3, limit_1, surface);
                    if (_e64) {
                        bool _e66 = shows(as_type<metal::int2>(as_type<metal::uint2>(at_3) + as_type<metal::uint2>(step_1)), number_3, limit_1, surface);
                        if (_e66) {
                            change = 1;
                        }
                    } else {
                        change = -1;
                    }
                    int _e69 = change;
                    if (_e69 > 0) {
                        bool _e77 = shows(as_type<metal::int2>(as_type<metal::uint2>(at_3) + as_type<metal::uint2>(as_type<metal::int2>(as_type<uint>(2) * as_type<metal::uint2>(step_1)))), number_3, limit_1, surface);
                        local_5 = _e77;
                    } else {
                        local_5 = false;
                    }
                    bool _e79 = local_5;
                    if (_e79) {
                        break;
                    }
                    int _e80 = change;
                    if (_e80 < 0) {
                        bool _e86 = shows(as_type<metal::int2>(as_type<metal::uint2>(at_3) - as_type<metal::uint2>(step_1)), number_3, limit_1, surface);
                        local_6 = !(_e86);
                    } else {
                        local_6 = false;
                    }
                    bool _e89 = local_6;
                    if (_e89) {
                        break;
                    }
                    int _e90 = change;
                    if (_e90 != 0) {
                        bool _e93 = is_open;
                        if (_e93) {
                            int _e94 = side;
                            int _e96 = row;
                            int _e100 = height;
                            int _e101 = height;
                            int _e102 = change;
                            ends.inner[_e94] = metal::float2(static_cast<float>(_e96) - 0.5, static_cast<float>(metal::max(_e100, as_type<int>(as_type<uint>(_e101) + as_type<uint>(_e102)))));
                            is_open = false;
                        }
                        int _e108 = changes_1;
                        int _e109 = row;
                        changes_1 = as_type<int>(as_type<uint>(_e108) + as_type<uint>((_e109 <= 5) ? 1 : 0));
                        int _e116 = height;
                        int _e117 = change;
                        height = as_type<int>(as_type<uint>(_e116) + as_type<uint>(_e117));
                    }
                    int _e119 = row;
                    if (_e119 <= 5) {
                        int _e122 = row;
                        int _e123 = side;
                        float x_2 = static_cast<float>(as_type<int>(as_type<uint>(_e122) * as_type<uint>(as_type<int>(as_type<uint>(1) - as_type<uint>(as_type<int>(as_type<uint>(2) * as_type<uint>(_e123)))))));
                        int _e130 = height;
                        float y_2 = static_cast<float>(_e130) + 0.5;
                        float _e135 = sums_1.count;
                        sums_1.count = _e135 + 1.0;
                        float _e139 = sums_1.x;
                        sums_1.x = _e139 + x_2;
                        float _e142 = sums_1.y;
                        sums_1.y = _e142 + y_2;
                        float _e145 = sums_1.xx;
                        sums_1.xx = _e145 + (x_2 * x_2);
                        float _e149 = sums_1.xy;
                        sums_1.xy = _e149 + (x_2 * y_2);
                        float _e153 = sums_1.yy;
                        sums_1.yy = _e153 + (y_2 * y_2);
                        float _e157 = sums_1.xxy;
                        sums_1.xxy = _e157 + ((x_2 * x_2) * y_2);
                    }
                    int _e162 = row;
                    row = as_type<int>(as_type<uint>(_e162) + as_type<uint>(1));
                }
            }
            bool _e164 = is_open;
            if (_e164) {
                int _e165 = side;
                int _e167 = row;
                int _e171 = height;
                ends.inner[_e165] = metal::float2(static_cast<float>(_e167) - 0.5, static_cast<float>(_e171) + 0.5);
            }
        }
    }
    float _e181 = ends.inner[0].x;
    float _e184 = ends.inner[1].x;
    float length = _e181 + _e184;
    float _e188 = ends.inner[0].y;
    float _e191 = ends.inner[1].y;
    float slope_2 = (_e188 - _e191) / length;
    float _e196 = ends.inner[1].y;
    float _e199 = ends.inner[1].x;
    float place_3 = _e196 + (slope_2 * _e199);
    float _e204 = ends.inner[0].y;
    float _e207 = ends.inner[1].y;
    if (_e204 == _e207) {
        local_7 = place_3 != 0.5;
    } else {
        local_7 = false;
    }
    bool is_arc_1 = local_7;
    int _e215 = changes_1;
    if (!((_e215 >= 3))) {
        if (is_arc_1) {
            int _e223 = changes_1;
            local_9 = _e223 >= 2;
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
        local_10 = _e233 >= 7.0;
    } else {
        local_10 = false;
    }
    bool _e237 = local_10;
    if (_e237) {
        CourseSums _e238 = sums_1;
        Course _e239 = fitted_course(_e238, is_arc_1);
        return _e239;
    }
    float _e242 = ends.inner[0].x;
    float _e247 = ends.inner[1].x;
    float rise_2 = is_arc_1 ? (((4.0 * _e242) * _e247) / (length * length)) : 0.0;
    float _e254 = sums_1.count;
    float trust_3 = _e254 / 11.0;
    return Course {metal::clamp(metal::mix(place_3, 0.5, rise_2), 0.0, 1.0), slope_2, trust_3};
}

float facing_squared(
    Facet facet
) {
    float facing_2 = metal::dot(facet.normal, facet.toward);
    return (facing_2 * metal::abs(facing_2)) / metal::dot(facet.toward, facet.toward);
}

metal::float2 course_normal(
    Course course,
    metal::float2 toward
) {
    metal::float2 along_3 = metal::abs(toward.yx);
    return (toward - (course.slope * along_3)) / metal::float2(metal::sqrt(1.0 + (course.slope * course.slope)));
}

Edge edge_along(
    int kind,
    Course course_1,
    metal::float2 toward_1,
    metal::float2 normal_4
) {
    float lean = metal::dot(normal_4, toward_1);
    return Edge {kind, {}, normal_4, course_1.place * lean, course_1.trust * lean};
}

Edge silhouette(
    Facet own_1,
    metal::int2 pixel_3,
    metal::int2 step_2,
    float limit_2,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    bool local_11 = {};
    bool local_12 = {};
    bool local_13 = {};
    metal::float2 toward_3 = static_cast<metal::float2>(step_2);
    Course _e6 = course_at(pixel_3, step_2, own_1.number, limit_2, surface);
    metal::int2 last_3 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    Facet _e17 = facet_at(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel_3) - as_type<metal::uint2>(step_2)), metal::int2(0), last_3), surface, curvature);
    float _e18 = facing_squared(own_1);
    float _e19 = facing_squared(_e17);
    float change_2 = _e19 - _e18;
    float _e23 = row_direction(curvature);
    metal::float2 across_1 = own_1.normal.xy * metal::float2(1.0, _e23);
    metal::float2 normal_5 = across_1 / metal::float2(metal::max(metal::length(across_1), 0.000001));
    if (_e17.number == own_1.number) {
        local_11 = _e18 < 0.36;
    } else {
        local_11 = false;
    }
    bool _e40 = local_11;
    if (_e40) {
        local_12 = change_2 > 0.0001;
    } else {
        local_12 = false;
    }
    bool _e46 = local_12;
    if (_e46) {
        local_13 = metal::dot(normal_5, toward_3) > 0.5;
    } else {
        local_13 = false;
    }
    bool is_round = local_13;
    float found = _e18 / metal::max(change_2, 0.0001);
    float place_4 = metal::clamp(found, 0.0, 1.0);
    float trust_4 = is_round ? metal::clamp(2.0 - (4.0 * metal::abs(found - place_4)), 0.0, 1.0) : 0.0;
    Course seen_1 = Course {metal::mix(_e6.place, place_4, trust_4), _e6.slope, metal::mix(_e6.trust, 1.0, trust_4)};
    metal::float2 _e78 = course_normal(_e6, toward_3);
    metal::float2 turned = metal::mix(_e78, normal_5, trust_4);
    Edge _e84 = edge_along(0, seen_1, toward_3, turned / metal::float2(metal::length(turned)));
    return _e84;
}

float round_bend(
    Facet own_2,
    Facet other_1,
    metal::int2 pixel_4,
    metal::int2 step_3,
    metal::texture2d<float, metal::access::sample> surface
) {
    metal::int2 last_4 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 before = surface.read(metal::uint2(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel_4) - as_type<metal::uint2>(step_3)), metal::int2(0), last_4)), 0);
    metal::float4 after = surface.read(metal::uint2(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel_4) + as_type<metal::uint2>(as_type<metal::int2>(as_type<uint>(2) * as_type<metal::uint2>(step_3)))), metal::int2(0), last_4)), 0);
    metal::float3 _e26 = normal_of(before);
    metal::float3 _e30 = normal_of(after);
    metal::float2 bends = metal::float2(metal::length(_e26 - own_2.normal), metal::length(_e30 - other_1.normal));
    metal::float2 numbers = metal::float2(metal::abs(before.w), metal::abs(after.w));
    metal::float2 shares_1 = metal::select(metal::float2(0.0), metal::float2(1.0), numbers == metal::float2(own_2.number));
    return metal::dot(bends, shares_1) / metal::max(shares_1.x + shares_1.y, 1.0);
}

Edge edge_between(
    Facet own_3,
    metal::int2 pixel_5,
    metal::int2 step_4,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    bool local_14 = {};
    bool local_15 = {};
    Edge none = Edge {-1, {}, metal::float2(0.0), 0.0, 0.0};
    metal::int2 at_4 = as_type<metal::int2>(as_type<metal::uint2>(pixel_5) + as_type<metal::uint2>(step_4));
    if (!(metal::any(at_4 < metal::int2(0)))) {
        local_14 = metal::any(at_4 >= static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height())));
    } else {
        local_14 = true;
    }
    bool _e23 = local_14;
    if (_e23) {
        return none;
    }
    Facet _e24 = facet_at(at_4, surface, curvature);
    if (_e24.number == 0.0) {
        Edge _e29 = silhouette(own_3, pixel_5, step_4, 1000000000.0, surface, curvature);
        return _e29;
    }
    metal::float2 toward_4 = static_cast<metal::float2>(step_4);
    float _e32 = object_in(own_3.number);
    float _e34 = object_in(_e24.number);
    bool is_same_object = _e32 == _e34;
    bool _e36 = meets(own_3, _e24, toward_4, curvature);
    if (!(_e36)) {
        if (own_3.depth > _e24.depth) {
            return none;
        }
        float middle_1 = 0.5 * (own_3.depth + _e24.depth);
        Edge _e48 = silhouette(own_3, pixel_5, step_4, is_same_object ? middle_1 : 1000000000.0, surface, curvature);
        return _e48;
    }
    if (!(is_same_object)) {
        return Edge {2, {}, metal::float2(0.0), 0.0, 0.0};
    }
    if (own_3.number != _e24.number) {
        return Edge {3, {}, metal::float2(0.0), 0.0, 0.0};
    }
    float bend = metal::length(own_3.normal - _e24.normal);
    if (!((bend < 0.5176381))) {
        float _e74 = round_bend(own_3, _e24, pixel_5, step_4, surface);
        local_15 = (bend - _e74) < 0.5176381;
    } else {
        local_15 = true;
    }
    bool _e79 = local_15;
    if (_e79) {
        return none;
    }
    return Edge {1, {}, metal::float2(0.0), 0.0, 0.0};
}

Edge meeting(
    Facet own_4,
    metal::int2 pixel_6,
    metal::int2 step_5,
    int kind_1,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    bool local_16 = {};
    Facet _e5 = facet_at(as_type<metal::int2>(as_type<metal::uint2>(pixel_6) + as_type<metal::uint2>(step_5)), surface, curvature);
    metal::float2 toward_5 = static_cast<metal::float2>(step_5);
    metal::float2 slope_3 = own_4.rise - _e5.rise;
    float steepness_1 = metal::length(slope_3);
    float here_1 = own_4.depth - (_e5.depth - metal::dot(_e5.rise, toward_5));
    float side_3 = metal::dot(slope_3, toward_5);
    float _e20 = pixel_size_at(own_4.depth, curvature);
    if (metal::abs(side_3) > (0.1 * _e20)) {
        local_16 = metal::abs(side_3) > (0.3 * steepness_1);
    } else {
        local_16 = false;
    }
    bool _e31 = local_16;
    if (_e31) {
        float share_2 = metal::clamp(-(here_1) / side_3, 0.0, 1.0);
        metal::float2 normal_6 = slope_3 / metal::float2((side_3 > 0.0) ? steepness_1 : -(steepness_1));
        float lean_1 = metal::dot(normal_6, toward_5);
        return Edge {kind_1, {}, normal_6, share_2 * lean_1, lean_1};
    }
    if (kind_1 == 1) {
        return Edge {kind_1, {}, toward_5, 0.5, 0.0};
    }
    Course _e53 = course_at(pixel_6, step_5, own_4.number, 1000000000.0, surface);
    metal::float2 _e54 = course_normal(_e53, toward_5);
    Edge _e55 = edge_along(kind_1, _e53, toward_5, _e54);
    return _e55;
}

bool goes_on(
    Facet own_5,
    metal::float2 slope,
    float size,
    metal::int2 pixel_7,
    metal::int2 step_6,
    metal::texture2d<float, metal::access::sample> surface
) {
    bool local_17 = {};
    bool local_18 = {};
    metal::int2 last_5 = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(surface.get_width(), surface.get_height()))) - as_type<metal::uint2>(metal::int2(1)));
    metal::float4 texel_5 = surface.read(metal::uint2(metal::clamp(as_type<metal::int2>(as_type<metal::uint2>(pixel_7) + as_type<metal::uint2>(step_6)), metal::int2(0), last_5)), 0);
    metal::float2 change_3 = metal::abs(texel_5.xy - slope);
    float error_1 = metal::abs((texel_5.z - own_5.depth) - metal::dot(own_5.gentle_rise, static_cast<metal::float2>(step_6)));
    if (metal::abs(texel_5.w) == own_5.number) {
        local_17 = error_1 <= size;
    } else {
        local_17 = false;
    }
    bool _e37 = local_17;
    if (_e37) {
        local_18 = metal::max(change_3.x, change_3.y) < 0.35;
    } else {
        local_18 = false;
    }
    bool _e46 = local_18;
    return _e46;
}

metal::float4 edges_at(
    metal::int2 pixel_8,
    metal::texture2d<float, metal::access::sample> surface,
    constant Curvature& curvature
) {
    uint left = 0u;
    int index_4 = 0;
    metal::float4 codes_2 = metal::float4(0.0);
    metal::float4 trust = metal::float4(-1.0);
    int index_5 = {};
    Edge edge = {};
    Facet _e1 = facet_at(pixel_8, surface, curvature);
    if (_e1.number == 0.0) {
        return metal::float4(0.0);
    }
    metal::float4 _e9 = surface.read(metal::uint2(pixel_8), 0);
    metal::float2 slope_4 = _e9.xy;
    float _e12 = pixel_size_at(_e1.depth, curvature);
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_2) {
            int _e32 = index_4;
            index_4 = as_type<int>(as_type<uint>(_e32) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e17 = index_4;
        if (_e17 < 4) {
        } else {
            break;
        }
        {
            uint _e20 = left;
            int _e22 = index_4;
            int _e26 = index_4;
            metal::int2 _e27 = around(_e26);
            bool _e28 = goes_on(_e1, slope_4, _e12, pixel_8, _e27, surface);
            left = _e20 | (_e28 ? 0u : (1u << static_cast<uint>(_e22)));
        }
    }
    uint _e40 = left;
    index_5 = (_e40 == 0u) ? 4 : 0;
    uint2 loop_bound_4 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_4 == uint2(0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_3) {
            int _e102 = index_5;
            index_5 = as_type<int>(as_type<uint>(_e102) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e47 = index_5;
        if (_e47 < 4) {
        } else {
            break;
        }
        {
            uint _e50 = left;
            int _e51 = index_5;
            if (((_e50 >> static_cast<uint>(_e51)) & 1u) == 0u) {
                continue;
            }
            int _e58 = index_5;
            metal::int2 _e59 = around(_e58);
            Edge _e60 = edge_between(_e1, pixel_8, _e59, surface, curvature);
            edge = _e60;
            int _e63 = edge.kind;
            if (_e63 == -1) {
                continue;
            }
            int _e67 = edge.kind;
            if (_e67 != 0) {
                int _e71 = edge.kind;
                Edge _e72 = meeting(_e1, pixel_8, _e59, _e71, surface, curvature);
                edge = _e72;
            }
            int _e74 = edge.kind;
            metal::bool4 is_kind = metal::int4(_e74) == metal::int4(0, 1, 2, 3);
            float _e83 = edge.trust;
            metal::float4 _e85 = trust;
            metal::bool4 is_better = is_kind & (metal::float4(_e83) > _e85);
            metal::float4 _e88 = trust;
            float _e90 = edge.trust;
            trust = metal::select(_e88, metal::float4(_e90), is_better);
            metal::float4 _e93 = codes_2;
            metal::float2 _e95 = edge.normal;
            float _e97 = edge.offset;
            float _e98 = edge_code(_e95, _e97);
            codes_2 = metal::select(_e93, metal::float4(_e98), is_better);
        }
    }
    metal::float4 _e104 = codes_2;
    return _e104;
}

struct vs_mainInput {
};
struct vs_mainOutput {
    metal::float4 member [[position]];
};
vertex vs_mainOutput vs_main(
  uint index [[vertex_id]]
) {
    metal::float4 _e1 = whole_picture(index);
    return vs_mainOutput { _e1 };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  metal::float4 position [[position]]
, metal::texture2d<float, metal::access::sample> surface [[texture(0)]]
, constant Curvature& curvature [[buffer(0)]]
) {
    metal::float4 _e3 = edges_at(naga_f2i32(position.xy), surface, curvature);
    return fs_mainOutput { _e3 };
}
