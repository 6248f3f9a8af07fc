// Anisotropic Ward: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_3 buffer(0), object buffer(1), look buffer(2).
// material-ward.json says what to put there and how to draw.
// UNVERIFIED: no compiler of Metal Shading Language 2.0 has seen this file.

// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct View {
    metal::float4x4 clip_from_world;
    metal::float4x4 camera_from_world;
    metal::float4 eye;
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
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float3 tangent;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 normal;
    metal::float4 tangent;
};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

metal::float3 normalize_or(
    metal::float3 v,
    metal::float3 otherwise
) {
    float largest = metal::max(metal::max(metal::abs(v.x), metal::abs(v.y)), metal::abs(v.z));
    if (!(((largest > 0.000000000000000000000000000001) & (largest < 1000000000000000000000000000000.0)))) {
        return otherwise;
    }
    metal::float3 scaled = v * (1.0 / largest);
    float square = metal::dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return scaled * (1.0 / metal::sqrt(square));
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x_1
) {
    float clamped = metal::max(x_1, -126.0);
    float whole = metal::rint(clamped);
    float f = clamped - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise_1
) {
    float square_1 = metal::dot(v_1, v_1);
    return (square_1 > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square_1, 0.000000000000000000000000000001))) : otherwise_1;
}

metal::float3 normalize_seen_balanced(
    metal::float3 v_2
) {
    return v_2 * metal::rsqrt(metal::max(metal::dot(v_2, v_2), 0.000000000000000000000000000001));
}

metal::float3 any_orthogonal(
    metal::float3 n
) {
    float sign = (n.z >= 0.0) ? 1.0 : -1.0;
    float a = -1.0 / (sign + n.z);
    return metal::float3(1.0 + (((sign * n.x) * n.x) * a), ((sign * n.x) * n.y) * a, -(sign) * n.x);
}

metal::float3x3 world_from_tangent(
    metal::float3 tangent,
    metal::float3 bitangent,
    metal::float3 normal
) {
    metal::float3 t = tangent * metal::rsqrt(metal::max(metal::dot(tangent, tangent), 0.000000000000000000000000000001));
    metal::float3 leaning = t - (metal::dot(t, normal) * normal);
    bool is_usable = metal::dot(leaning, leaning) > 0.00000001;
    metal::float3 _e14 = any_orthogonal(normal);
    metal::float3 _e20 = normalize_or(is_usable ? leaning : _e14, metal::float3(1.0, 0.0, 0.0));
    metal::float3 _e28 = normalize_moderate(_e20 - (metal::dot(_e20, normal) * normal), metal::float3(1.0, 0.0, 0.0));
    metal::float3 b = metal::cross(normal, _e28);
    return metal::float3x3(_e28, b, normal);
}

metal::float3 half_of(
    metal::float3 light,
    metal::float3 normal_1,
    metal::float3 view
) {
    metal::float3 half_ = light + view;
    metal::float3 _e8 = normalize_moderate((metal::dot(half_, half_) > 0.000000000001) ? half_ : normal_1, normal_1);
    return _e8;
}

float ward(
    metal::float3 light_1,
    metal::float3 normal_2,
    metal::float3 view_1,
    metal::float3 x_axis,
    metal::float3 y_axis,
    metal::float2 widths
) {
    float n_l = metal::dot(normal_2, light_1);
    float n_v = metal::dot(normal_2, view_1);
    if ((n_l <= 0.0) | (n_v <= 0.0)) {
        return 0.0;
    }
    metal::float3 _e14 = half_of(light_1, normal_2, view_1);
    float n_h = metal::max(metal::dot(normal_2, _e14), 0.000001);
    metal::float2 slope = metal::float2(metal::dot(_e14, x_axis), metal::dot(_e14, y_axis)) / (widths * n_h);
    float _e28 = exp2_stable(-1.442695 * metal::min(metal::dot(slope, slope), 200.0));
    return (n_l * _e28) / (widths.y * metal::sqrt(metal::max(n_l * n_v, 0.000001)));
}

float reflectance_ward(
    Light light_2,
    metal::float3 normal_3,
    metal::float3 view_2,
    metal::float3 tangent_1,
    float roughness,
    float across
) {
    metal::float3x3 _e8 = world_from_tangent(tangent_1, metal::float3(0.0), normal_3);
    metal::float2 widths_1 = metal::float2(0.25, across * across);
    float _e16 = ward(light_2.direction, _e8[2], view_2, _e8[0], _e8[1], widths_1);
    return _e16;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float lambert = metal::max(metal::dot(surface.normal, _e5), 0.0);
    metal::float4 body = metal::float4(metal::float3(0.098, 0.1059, 0.1333) + (lambert * metal::float3(0.3529, 0.3961, 0.4392)), 1.0);
    Light _e23 = look.key;
    float _e29 = reflectance_ward(_e23, surface.normal, surface.view, surface.tangent, 0.5, 0.2);
    metal::float4 highlight = metal::clamp(metal::float4(body.xyz + (0.55 * ((body.xyz + (_e29 * metal::float3(0.9569, 0.9412, 0.902))) - body.xyz)), 1.0), metal::float4(0.0), metal::float4(1.0));
    return highlight;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_4 [[attribute(1)]];
    metal::float4 tangent_2 [[attribute(2)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal [[user(loc1), center_perspective]];
    metal::float4 tangent [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_3 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position, varyings.normal_4, varyings.tangent_2 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_3.clip_from_world;
    metal::float3x3 _e15 = object.world_from_normal;
    metal::float4x4 _e20 = object.world_from_object;
    metal::float3x3 _e34 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, _e15 * vertex_.normal, metal::float4((_e20 * metal::float4(vertex_.tangent.xyz, 0.0)).xyz, (metal::determinant(_e34) < 0.0) ? -(vertex_.tangent.w) : vertex_.tangent.w)};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal, _tmp.tangent };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_4 [[user(loc1), center_perspective]];
    metal::float4 tangent_2 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_3 [[buffer(0)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_4, varyings_1.tangent_2 };
    metal::float3 _e3 = normalize_seen_balanced(in.normal);
    metal::float3 normal_4 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_3.eye;
    float _e13 = view_3.eye.w;
    metal::float3 _e27 = normalize_moderate(in.tangent.xyz - (normal_4 * metal::dot(normal_4, in.tangent.xyz)), metal::float3(0.0));
    Surface surface_1 = Surface {normal_4, metal::normalize(_e8.xyz - (_e13 * in.position)), _e27};
    metal::float4 _e29 = shade(surface_1, look);
    return fs_mainOutput { _e29 };
}
