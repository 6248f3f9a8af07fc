// Half-tone comic: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// halftone-comic.json says what to put there and how to draw.
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
    Light key;
    metal::float2 viewport;
    char _pad2[8];
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float2 pixel;
    char _pad3[8];
};
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
constant ProfileShape not_in_deep_shade_shape = ProfileShape {0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u};
constant ProfileShape highlight_shape = ProfileShape {0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u};

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

metal::float3 normalize_seen_balanced(
    metal::float3 v
) {
    return v * metal::rsqrt(metal::max(metal::dot(v, v), 0.000000000000000000000000000001));
}

float angle_footprint(
    Angle u
) {
    metal::float2 half_ = metal::float2(u.half_sin, u.half_cos);
    metal::float2 dx = metal::dfdx(half_);
    metal::float2 dy = metal::dfdy(half_);
    float w_5 = 2.0 * metal::sqrt(metal::dot(dx, dx) + metal::dot(dy, dy));
    return metal::min(w_5, 0.5);
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

float eased(
    float x_1,
    float low,
    float high
) {
    float t_1 = metal::clamp((x_1 - low) / (high - low), 0.0, 1.0);
    return (t_1 * t_1) * (3.0 - (2.0 * t_1));
}

metal::float2 footprint_of_vec2_(
    metal::float2 v_1
) {
    metal::float2 dx_1 = metal::dfdx(v_1);
    metal::float2 dy_1 = metal::dfdy(v_1);
    return metal::sqrt((dx_1 * dx_1) + (dy_1 * dy_1));
}

Angle parametrization_specular_balanced(
    Light light,
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 d_2 = ((2.0 * metal::dot(normal, view)) * normal) - view;
    return Angle {0.5 * metal::length(d_2 - light.direction), 0.5 * metal::length(d_2 + light.direction)};
}

float profile_ramp_quick(
    float s,
    float w,
    ProfileShape shape
) {
    float width = metal::sqrt(w * w);
    float from_offset = s * (2.0 + ((s * s) * 0.33333334));
    float ramp = metal::clamp(0.5 + ((0.0 - from_offset) / metal::max(width, 0.000001)), 0.0, 1.0);
    return (w <= 0.0) ? ((s <= 0.0000004) ? 1.0 : 0.0) : ramp;
}

float profile_balanced(
    Angle angle,
    float shift,
    ProfileShape shape_1
) {
    Angle _e6 = angle_turned(angle, metal::float2(0.0, 1.0));
    float _e14 = angle_footprint(_e6);
    float _e15 = profile_ramp_quick((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset), _e14, shape_1);
    return _e15;
}

metal::float2 turned_by(
    metal::float2 p,
    float angle_1
) {
    metal::float2 turn = metal::float2(metal::sin(angle_1), metal::cos(angle_1));
    return metal::float2((turn.y * p.x) - (turn.x * p.y), (turn.x * p.x) + (turn.y * p.y));
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

float dot_radius(
    float share
) {
    float a = {};
    int i = 0;
    if (share <= 0.7853982) {
        return metal::sqrt(share * 0.31830987);
    }
    float s_3 = (share - 0.7853982) / 0.21460183;
    a = metal::mix(0.5227232 * metal::sqrt(s_3), 0.7853982 - (0.3275682 * metal::sqrt(1.0 - s_3)), s_3);
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
        float _e28 = a;
        metal::float2 _e32 = sin_cos_quarter(metal::clamp(_e28, 0.0, 0.7853982));
        float tangent = _e32.x / _e32.y;
        float square = 1.0 / (_e32.y * _e32.y);
        float _e41 = a;
        float sector = 0.7853982 - _e41;
        float slope = ((2.0 * sector) * square) * tangent;
        float _e48 = a;
        a = metal::clamp(_e48 - ((slope > 0.001) ? ((((sector * square) + tangent) - share) / slope) : 0.0), 0.0, 0.7853982);
    }
    float _e64 = a;
    metal::float2 _e65 = sin_cos_quarter(_e64);
    return 0.5 / _e65.y;
}

float disk_filtered(
    float d,
    float r,
    float w_1
) {
    if (w_1 < 0.000000000000000000000000000001) {
        return ((d <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    float square_1 = r * r;
    float least = (w_1 * w_1) / 3.0;
    float inner = metal::sqrt(metal::max(square_1, least) - (0.25 * least));
    return metal::clamp(0.5 + ((inner - d) / w_1), 0.0, 1.0) * metal::min(square_1 / least, 1.0);
}

float disk_filtered_2_(
    float d_1,
    float r_1,
    float w_2
) {
    if (w_2 < 0.000000000000000000000000000001) {
        return ((d_1 <= r_1) & true) ? 1.0 : 0.0;
    }
    float square_2 = r_1 * r_1;
    float least_1 = (w_2 * w_2) / 3.0;
    float inner_1 = metal::sqrt(metal::max(square_2, least_1) - (0.25 * least_1));
    return metal::clamp(0.5 + ((inner_1 - d_1) / w_2), 0.0, 1.0) * metal::min(square_2 / least_1, 1.0);
}

float ink_of_dots(
    metal::float2 cell,
    float share_1,
    float w_3
) {
    float ink = {};
    float width_1 = metal::min(w_3, 1.0);
    float _e8 = dot_radius(share_1);
    float _e9 = disk_filtered(metal::length(cell - metal::rint(cell)), _e8, width_1);
    ink = _e9;
    float hole = metal::sqrt((1.0 - share_1) * 0.31830987);
    float is_star = metal::smoothstep(0.3 * hole, 0.9 * hole, width_1) * metal::smoothstep(0.5, 0.7, share_1);
    if (is_star > 0.0) {
        float _e27 = ink;
        float _e34 = disk_filtered_2_(metal::length((cell - metal::floor(cell)) - metal::float2(0.5)), hole, width_1);
        ink = metal::mix(_e27, 1.0 - _e34, is_star);
    }
    float _e38 = ink;
    float mean = metal::mix(_e38, share_1, metal::smoothstep(0.4, 1.0, w_3));
    return ((share_1 <= 0.0) | false) ? share_1 : mean;
}

float ink_of_dots_2_(
    metal::float2 cell_1,
    float share_2,
    float w_4
) {
    float ink_1 = {};
    float width_2 = metal::min(w_4, 1.0);
    float _e11 = disk_filtered(metal::length(cell_1 - metal::rint(cell_1)), metal::sqrt(share_2 * 0.31830987), width_2);
    ink_1 = _e11;
    float hole_1 = metal::sqrt((1.0 - share_2) * 0.31830987);
    float is_star_1 = metal::smoothstep(0.3 * hole_1, 0.9 * hole_1, width_2) * metal::smoothstep(0.5, 0.7, share_2);
    if (is_star_1 > 0.0) {
        float _e29 = ink_1;
        float _e36 = disk_filtered_2_(metal::length((cell_1 - metal::floor(cell_1)) - metal::float2(0.5)), hole_1, width_2);
        ink_1 = metal::mix(_e29, 1.0 - _e36, is_star_1);
    }
    float _e40 = ink_1;
    float mean_1 = metal::mix(_e40, share_2, metal::smoothstep(0.4, 1.0, w_4));
    return ((share_2 <= 0.0) | false) ? share_2 : mean_1;
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
    float _e12 = ink_of_dots_2_(_e5, 1.0 - value_1, metal::max(_e6.x, _e6.y));
    return 1.0 - _e12;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float light_and_shade = metal::max((metal::dot(surface.normal, _e5) + 0.25) / 1.25, 0.0);
    float red_to_print = metal::mix(0.15, 1.0, metal::clamp((light_and_shade - 0.1) / 0.65, 0.0, 1.0));
    metal::float2 _e28 = look.viewport;
    float _e29 = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994, _e28);
    metal::float4 red_on_yellow = metal::mix(metal::float4(0.91, 0.3, 0.24, 1.0), metal::float4(1.0, 0.87, 0.58, 1.0), _e29);
    metal::float3 _e45 = look.key.direction;
    metal::float3 _e54 = look.key.direction;
    Angle turned_from_the_light = Angle {0.5 * metal::length(surface.normal - _e45), 0.5 * metal::length(surface.normal + _e54)};
    float _e62 = profile_balanced(turned_from_the_light, 0.0, not_in_deep_shade_shape);
    float deep_shade = 1.0 - _e62;
    float how_much_blue = deep_shade * 0.62;
    float less = 1.0 - how_much_blue;
    metal::float2 _e74 = look.viewport;
    float _e75 = halftone_dots_2_(less, surface.pixel, 78.0, 1.3089969, _e74);
    float inked = 1.0 - _e75;
    metal::float4 blue_over_it = metal::float4(metal::mix(red_on_yellow.xyz, red_on_yellow.xyz * metal::float3(0.24, 0.3, 0.58), inked), 1.0);
    Light _e90 = look.key;
    Angle _e93 = parametrization_specular_balanced(_e90, surface.normal, surface.view);
    float _e96 = profile_balanced(_e93, 0.0, highlight_shape);
    metal::float4 left_free = metal::mix(blue_over_it, metal::float4(1.0, 0.99, 0.95, 1.0), _e96);
    float _e111 = eased(metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.22);
    metal::float4 black_line = metal::mix(left_free, metal::float4(0.09, 0.07, 0.13, 1.0), _e111);
    return black_line;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_1 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e22 = view_1.screen;
    metal::float4 _e27 = view_1.screen;
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), (in.clip.xy * _e22.xy) + _e27.zw};
    metal::float4 _e31 = shade(surface_1, look);
    return fs_mainOutput { _e31 };
}
