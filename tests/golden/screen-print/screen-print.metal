// Screen print: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// screen-print.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
    metal::float4 screen;
};
struct Object {
    metal::float4x4 world_from_object;
    metal::float3x3 world_from_normal;
    float id;
    float cutoff;
    char _pad4[8];
};
struct Light {
    metal::float3 direction;
    metal::float3 own_direction;
    metal::packed_float3 color;
    float intensity;
};
struct Look {
    Light side;
    metal::float2 viewport;
    char _pad2[8];
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::packed_float3 view;
    float kappa;
    metal::float2 pixel;
    char _pad4[8];
};
typedef metal::float4 Color;
struct Angle {
    float half_sin;
    float half_cos;
};
struct ProfileShape {
    float half_cos_offset;
    float half_sin_offset;
    float scale;
    float exponent;
    float offset;
    float edge_mean;
    float edge_deviation;
    uint kind;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant ProfileShape yellow_s_share_shape = ProfileShape {0.9887711, 0.14943813, 2.0858297, 1.7378688, 0.3, 0.54759663, 0.22553022, 0u};

metal::float2 sin_cos_quarter(
    float x
) {
    float h = 0.5 * x;
    float h2_ = h * h;
    float s_1 = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s_1) * c, 1.0 - ((2.0 * s_1) * s_1));
}

metal::float3 normalize_moderate(
    metal::float3 v,
    metal::float3 otherwise
) {
    float square = metal::dot(v, v);
    return (square > 0.000000000000000000000000000001) ? (v * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_1
) {
    metal::float3 _e5 = normalize_moderate(v_1, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_7 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_7, 0.5);
}

Angle angle_turned(
    Angle u_1,
    metal::float2 t
) {
    float s_2 = u_1.half_sin - 0.0;
    metal::float2 upper = (u_1.half_cos <= 0.0) ? metal::float2(1.0, 0.0) : metal::float2(s_2, u_1.half_cos);
    metal::float2 turned = ((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? metal::float2(0.0, 1.0) : upper;
    return Angle {turned.x, turned.y};
}

float bounded(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    uint magnitude = bits & 2147483647u;
    float largest = as_type<float>((bits & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0);
}

float place_between(
    float x_2,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_2 >= high) ? 1.0 : 0.0;
    }
    float _e13 = bounded((x_2 - low) / span);
    return _e13;
}

float eased(
    float x_3,
    float low_1,
    float high_1
) {
    float _e3 = place_between(x_3, low_1, high_1);
    float t_1 = metal::clamp(_e3, 0.0, 1.0);
    return (t_1 * t_1) * (3.0 - (2.0 * t_1));
}

float footprint_of(
    float x_4
) {
    float _e1 = metal::dfdx(x_4);
    float _e2 = metal::dfdy(x_4);
    metal::float2 d_2 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_2, d_2));
}

metal::float2 footprint_of_vec2_(
    metal::float2 v_2
) {
    metal::float2 dx_1 = metal::dfdx(v_2);
    metal::float2 dy_1 = metal::dfdy(v_2);
    return metal::sqrt((dx_1 * dx_1) + (dy_1 * dy_1));
}

float step_filtered(
    float x_5,
    float edge,
    float w
) {
    float d_3 = x_5 - edge;
    return (w < 0.000000000000000000000000000001) ? ((d_3 >= 0.0) ? 1.0 : 0.0) : metal::clamp(0.5 + (d_3 / w), 0.0, 1.0);
}

Color mix_colors_multiply(
    Color a,
    Color b,
    float factor
) {
    return metal::float4(metal::mix(a.xyz, a.xyz * b.xyz, factor), 1.0);
}

float profile_soft_quick(
    float s,
    ProfileShape shape
) {
    float q = s * shape.scale;
    return (s <= 0.0) ? 1.0 : metal::pow(metal::max(1.0 - (q * q), 0.0), shape.exponent);
}

float profile_filtered_quick(
    Angle u_2,
    float w_1,
    ProfileShape shape_1
) {
    metal::float2 place_4 = metal::float2((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset), (u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset));
    float _e19 = profile_soft_quick(place_4.x, shape_1);
    if (w_1 < (0.1 * shape_1.edge_deviation)) {
        return _e19;
    }
    float r_2 = 0.19364917 * w_1;
    metal::float2 turn = metal::float2(r_2 * (1.0 - ((0.16666667 * r_2) * r_2)), 1.0 - ((0.5 * r_2) * r_2));
    float _e45 = profile_soft_quick((place_4.x * turn.y) - (place_4.y * turn.x), shape_1);
    float _e53 = profile_soft_quick((place_4.x * turn.y) + (place_4.y * turn.x), shape_1);
    return (((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_2
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

metal::float2 turned_by(
    metal::float2 p,
    float angle_1
) {
    metal::float2 turn_1 = metal::float2(metal::sin(angle_1), metal::cos(angle_1));
    return metal::float2((turn_1.y * p.x) - (turn_1.x * p.y), (turn_1.x * p.x) + (turn_1.y * p.y));
}

metal::float2 screen_cells(
    metal::float2 place,
    metal::float2 viewport,
    float lines,
    float angle_2
) {
    metal::float2 most = metal::float2(4194304.0);
    metal::float2 upright = place * (lines / metal::max(viewport.y, 1.0));
    metal::float2 _e14 = turned_by(metal::clamp(upright, metal::float2(-4194304.0), most), angle_2);
    return metal::clamp(_e14, metal::float2(-4194304.0), most);
}

float lines_integral(
    float x_6,
    float share
) {
    float whole = metal::rint(x_6);
    return (whole * share) + metal::clamp(x_6 - whole, -0.5 * share, 0.5 * share);
}

float lines_filtered(
    float x_7,
    float share_1,
    float w_2
) {
    float t_2 = x_7 - metal::rint(x_7);
    if (w_2 < 0.000000000000000000000000000001) {
        return ((metal::abs(t_2) <= (0.5 * share_1)) & (share_1 > 0.0)) ? 1.0 : 0.0;
    }
    float half_1 = 0.5 * metal::min(w_2, 1000.0);
    float _e22 = lines_integral(t_2 + half_1, share_1);
    float _e24 = lines_integral(t_2 - half_1, share_1);
    return metal::clamp((_e22 - _e24) / (2.0 * half_1), 0.0, 1.0);
}

float dot_radius(
    float share_2
) {
    float a_1 = {};
    int i = 0;
    if (share_2 <= 0.7853982) {
        return metal::sqrt(share_2 * 0.31830987);
    }
    float s_3 = (share_2 - 0.7853982) / 0.21460183;
    a_1 = metal::mix(0.5227232 * metal::sqrt(s_3), 0.7853982 - (0.3275682 * metal::sqrt(1.0 - s_3)), s_3);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e61 = i;
            i = as_type<int>(as_type<uint>(_e61) + as_type<uint>(1));
        }
        loop_init = false;
        int _e24 = i;
        if (!((_e24 < 2))) {
            break;
        }
        float _e28 = a_1;
        metal::float2 _e32 = sin_cos_quarter(metal::clamp(_e28, 0.0, 0.7853982));
        float tangent = _e32.x / _e32.y;
        float square_1 = 1.0 / (_e32.y * _e32.y);
        float _e41 = a_1;
        float sector = 0.7853982 - _e41;
        float slope = ((2.0 * sector) * square_1) * tangent;
        float _e48 = a_1;
        a_1 = metal::clamp(_e48 - ((slope > 0.001) ? ((((sector * square_1) + tangent) - share_2) / slope) : 0.0), 0.0, 0.7853982);
    }
    float _e64 = a_1;
    metal::float2 _e65 = sin_cos_quarter(_e64);
    return 0.5 / _e65.y;
}

float disk_filtered(
    float d,
    float r,
    float w_3
) {
    if (w_3 < 0.000000000000000000000000000001) {
        return ((d <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    float square_2 = r * r;
    float least = (w_3 * w_3) / 3.0;
    float inner = metal::sqrt(metal::max(square_2, least) - (0.25 * least));
    return metal::clamp(0.5 + ((inner - d) / w_3), 0.0, 1.0) * metal::min(square_2 / least, 1.0);
}

float disk_filtered_2_(
    float d_1,
    float r_1,
    float w_4
) {
    if (w_4 < 0.000000000000000000000000000001) {
        return ((d_1 <= r_1) & true) ? 1.0 : 0.0;
    }
    float square_3 = r_1 * r_1;
    float least_1 = (w_4 * w_4) / 3.0;
    float inner_1 = metal::sqrt(metal::max(square_3, least_1) - (0.25 * least_1));
    return metal::clamp(0.5 + ((inner_1 - d_1) / w_4), 0.0, 1.0) * metal::min(square_3 / least_1, 1.0);
}

float ink_of_dots(
    metal::float2 cell,
    float share_3,
    float w_5
) {
    float ink = {};
    float width = metal::min(w_5, 1.0);
    float _e8 = dot_radius(share_3);
    float _e9 = disk_filtered(metal::length(cell - metal::rint(cell)), _e8, width);
    ink = _e9;
    float hole = metal::sqrt((1.0 - share_3) * 0.31830987);
    float is_star = metal::smoothstep(0.3 * hole, 0.9 * hole, width) * metal::smoothstep(0.5, 0.7, share_3);
    if (is_star > 0.0) {
        float _e27 = ink;
        float _e34 = disk_filtered_2_(metal::length((cell - metal::floor(cell)) - metal::float2(0.5)), hole, width);
        ink = metal::mix(_e27, 1.0 - _e34, is_star);
    }
    float _e38 = ink;
    float mean = metal::mix(_e38, share_3, metal::smoothstep(0.4, 1.0, w_5));
    return ((share_3 <= 0.0) | false) ? share_3 : mean;
}

float ink_of_dots_2_(
    metal::float2 cell_1,
    float share_4,
    float w_6
) {
    float ink_1 = {};
    float width_1 = metal::min(w_6, 1.0);
    float _e8 = dot_radius(share_4);
    float _e9 = disk_filtered(metal::length(cell_1 - metal::rint(cell_1)), _e8, width_1);
    ink_1 = _e9;
    float hole_1 = metal::sqrt((1.0 - share_4) * 0.31830987);
    float _e20 = eased(width_1, 0.3 * hole_1, 0.9 * hole_1);
    float is_star_1 = _e20 * metal::smoothstep(0.5, 0.7, share_4);
    if (is_star_1 > 0.0) {
        float _e27 = ink_1;
        float _e34 = disk_filtered_2_(metal::length((cell_1 - metal::floor(cell_1)) - metal::float2(0.5)), hole_1, width_1);
        ink_1 = metal::mix(_e27, 1.0 - _e34, is_star_1);
    }
    float _e38 = ink_1;
    float mean_1 = metal::mix(_e38, share_4, metal::smoothstep(0.4, 1.0, w_6));
    return ((share_4 <= 0.0) | false) ? share_4 : mean_1;
}

float halftone_dots(
    float value,
    metal::float2 place_1,
    float lines_1,
    float angle_3,
    metal::float2 viewport_1
) {
    metal::float2 _e5 = screen_cells(place_1, viewport_1, lines_1, angle_3);
    metal::float2 _e6 = footprint_of_vec2_(_e5);
    float _e14 = ink_of_dots(_e5, 1.0 - metal::min(value, 1.0), metal::max(_e6.x, _e6.y));
    return 1.0 - _e14;
}

float halftone_dots_2_(
    float value_1,
    metal::float2 place_2,
    float lines_2,
    float angle_4,
    metal::float2 viewport_2
) {
    metal::float2 _e5 = screen_cells(place_2, viewport_2, lines_2, angle_4);
    metal::float2 _e6 = footprint_of_vec2_(_e5);
    float _e14 = ink_of_dots_2_(_e5, 1.0 - metal::min(value_1, 1.0), metal::max(_e6.x, _e6.y));
    return 1.0 - _e14;
}

float halftone_lines(
    float value_2,
    metal::float2 place_3,
    float lines_3,
    float angle_5,
    metal::float2 viewport_3
) {
    metal::float2 _e5 = screen_cells(place_3, viewport_3, lines_3, angle_5);
    float _e10 = footprint_of(_e5.y);
    float _e11 = lines_filtered(_e5.y, 1.0 - value_2, _e10);
    return 1.0 - _e11;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.side.direction;
    metal::float3 _e14 = look.side.direction;
    Angle side = Angle {0.5 * metal::length(surface.normal - _e5), 0.5 * metal::length(surface.normal + _e14)};
    float _e22 = profile_balanced(side, 0.0, yellow_s_share_shape);
    float pale = metal::mix(1.0, 0.25, _e22 - 0.0);
    metal::float2 _e33 = look.viewport;
    float _e34 = halftone_lines(pale, surface.pixel, 56.0, 0.0, _e33);
    metal::float4 p1_ink = metal::mix(metal::float4(0.9647, 0.8118, 0.2902, 1.0), metal::float4(1.0), _e34);
    Color _e49 = mix_colors_multiply(metal::float4(0.9686, 0.9373, 0.8784, 1.0), p1_ink, 1.0);
    metal::float3 _e54 = look.key.direction;
    float shade_2_ = metal::max((metal::dot(surface.normal, _e54) + 0.3) / 1.3, 0.0);
    float tone = metal::min((shade_2_ - 0.0) / 0.8, 1.0);
    float coral_s_share = metal::mix(0.12, 1.0, metal::clamp((tone - 0.25) / 0.7, 0.0, 1.0));
    metal::float2 _e83 = look.viewport;
    float _e84 = halftone_dots(coral_s_share, surface.pixel, 56.0, 0.2618, _e83);
    metal::float4 p2_ink = metal::mix(metal::float4(0.9333, 0.3529, 0.2902, 1.0), metal::float4(1.0), _e84);
    metal::float4 printed_over = metal::float4(metal::mix(_e49.xyz, _e49.xyz * p2_ink.xyz, 1.0), 1.0);
    float teal_s_share = metal::mix(0.05, 1.0, metal::min((tone - 0.0) / 0.5, 1.0));
    metal::float2 _e115 = look.viewport;
    float _e116 = halftone_dots_2_(teal_s_share, surface.pixel, 56.0, 1.309, _e115);
    metal::float4 p3_ink = metal::mix(metal::float4(0.1216, 0.5608, 0.5922, 1.0), metal::float4(1.0), _e116);
    metal::float4 printed_over_2_ = metal::float4(metal::mix(printed_over.xyz, printed_over.xyz * p3_ink.xyz, 1.0), 1.0);
    float curvature = surface.kappa;
    float hollow = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.25, -20.0, 20.0))))));
    float _e153 = footprint_of(hollow);
    float _e157 = step_filtered(hollow, 0.22, metal::length(metal::float2(_e153, 0.0)));
    float facing = metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0);
    float _e165 = footprint_of(facing);
    float _e169 = step_filtered(facing, 0.28, metal::length(metal::float2(_e165, 0.0)));
    float black_screen = _e157 * _e169;
    metal::float4 p4_ink = metal::mix(metal::float4(0.0902, 0.0745, 0.1216, 1.0), metal::float4(1.0), black_screen);
    metal::float4 printed_over_3_ = metal::float4(metal::mix(printed_over_2_.xyz, printed_over_2_.xyz * p4_ink.xyz, 1.0), 1.0);
    return printed_over_3_;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view [[buffer(0)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view.eye;
    float _e13 = view.eye.w;
    metal::float4 _e23 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e29 = view.screen;
    metal::float4 _e34 = view.screen;
    Surface surface_1 = Surface {normal, metal::normalize(_e8.xyz - (_e13 * in.position)), _e23.x, (in.clip.xy * _e29.xy) + _e34.zw};
    metal::float4 _e38 = shade(surface_1, look);
    return fs_mainOutput { _e38 };
}
