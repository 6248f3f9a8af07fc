// Half-tone comic: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// halftone-comic.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    float4 eye;
    float4 screen;
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
    float2 viewport;
    int _end_pad_0;
    int _end_pad_1;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float2 pixel;
    int _end_pad_0;
    int _end_pad_1;
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
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
};

ProfileShape ConstructProfileShape(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, float arg6, uint arg7) {
    ProfileShape ret = (ProfileShape)0;
    ret.half_cos_offset = arg0;
    ret.half_sin_offset = arg1;
    ret.scale = arg2;
    ret.exponent = arg3;
    ret.offset = arg4;
    ret.edge_mean = arg5;
    ret.edge_deviation = arg6;
    ret.kind = arg7;
    return ret;
}

static const ProfileShape not_in_deep_shade_shape = ConstructProfileShape(0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u);
static const ProfileShape highlight_shape = ConstructProfileShape(0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float2 sin_cos_quarter(float x)
{
    float h = (0.5 * x);
    float h2_ = (h * h);
    float s_1 = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s_1) * c), (1.0 - ((2.0 * s_1) * s_1)));
}

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_5 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_5, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_2 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_2, u_1.half_cos));
    float2 turned = (((s_2 <= 0.0) & (s_2 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_5 = ConstructAngle(turned.x, turned.y);
    return angle_5;
}

float eased(float x_1, float low, float high)
{
    float t_1 = clamp(((x_1 - low) / (high - low)), 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float2 footprint_of_vec2_(float2 v_1)
{
    float2 dx_1 = ddx(v_1);
    float2 dy_1 = ddy(v_1);
    return sqrt(((dx_1 * dx_1) + (dy_1 * dy_1)));
}

Angle parametrization_specular_balanced(Light light, float3 normal, float3 view)
{
    float3 d_2 = (((2.0 * dot(normal, view)) * normal) - view);
    const Angle angle_6 = ConstructAngle((0.5 * length((d_2 - light.direction))), (0.5 * length((d_2 + light.direction))));
    return angle_6;
}

float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width = sqrt((w * w));
    float from_offset = (s * (2.0 + ((s * s) * 0.33333334)));
    float ramp = clamp((0.5 + ((0.0 - from_offset) / max(width, 1e-6))), 0.0, 1.0);
    return ((w <= 0.0) ? ((s <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_1)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e14 = angle_footprint(_e6);
    const float _e15 = profile_ramp_quick(((_e6.half_sin * shape_1.half_cos_offset) - (_e6.half_cos * shape_1.half_sin_offset)), _e14, shape_1);
    return _e15;
}

float2 turned_by(float2 p, float angle_1)
{
    float2 turn = float2(sin(angle_1), cos(angle_1));
    return float2(((turn.y * p.x) - (turn.x * p.y)), ((turn.x * p.x) + (turn.y * p.y)));
}

float2 screen_cells(float2 place, float2 viewport, float lines, float angle_2)
{
    float2 most = (4194304.0).xx;
    float2 upright = (place * (lines / max(viewport.y, 1.0)));
    const float2 _e14 = turned_by(clamp(upright, (-4194304.0).xx, most), angle_2);
    return clamp(_e14, (-4194304.0).xx, most);
}

float dot_radius(float share)
{
    float a = (float)0;
    int i = int(0);

    if ((share <= 0.7853982)) {
        return sqrt((share * 0.31830987));
    }
    float s_3 = ((share - 0.7853982) / 0.21460183);
    a = lerp((0.5227232 * sqrt(s_3)), (0.7853982 - (0.3275682 * sqrt((1.0 - s_3)))), s_3);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e61 = i;
            i = asint(asuint(_e61) + asuint(int(1)));
        }
        loop_init = false;
        int _e24 = i;
        if (!((_e24 < int(2)))) {
            break;
        }
        float _e28 = a;
        const float2 _e32 = sin_cos_quarter(clamp(_e28, 0.0, 0.7853982));
        float tangent = (_e32.x / _e32.y);
        float square = (1.0 / (_e32.y * _e32.y));
        float _e41 = a;
        float sector = (0.7853982 - _e41);
        float slope = (((2.0 * sector) * square) * tangent);
        float _e48 = a;
        a = clamp((_e48 - ((slope > 0.001) ? ((((sector * square) + tangent) - share) / slope) : 0.0)), 0.0, 0.7853982);
    }
    float _e64 = a;
    const float2 _e65 = sin_cos_quarter(_e64);
    return (0.5 / _e65.y);
}

float disk_filtered(float d, float r, float w_1)
{
    if ((w_1 < 1e-30)) {
        return (((d <= r) & (r > 0.0)) ? 1.0 : 0.0);
    }
    float square_1 = (r * r);
    float least = ((w_1 * w_1) / 3.0);
    float inner = sqrt((max(square_1, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d) / w_1)), 0.0, 1.0) * min((square_1 / least), 1.0));
}

float disk_filtered_2_(float d_1, float r_1, float w_2)
{
    if ((w_2 < 1e-30)) {
        return (((d_1 <= r_1) & true) ? 1.0 : 0.0);
    }
    float square_2 = (r_1 * r_1);
    float least_1 = ((w_2 * w_2) / 3.0);
    float inner_1 = sqrt((max(square_2, least_1) - (0.25 * least_1)));
    return (clamp((0.5 + ((inner_1 - d_1) / w_2)), 0.0, 1.0) * min((square_2 / least_1), 1.0));
}

float ink_of_dots(float2 cell, float share_1, float w_3)
{
    float ink = (float)0;

    float width_1 = min(w_3, 1.0);
    const float _e8 = dot_radius(share_1);
    const float _e9 = disk_filtered(length((cell - round(cell))), _e8, width_1);
    ink = _e9;
    float hole = sqrt(((1.0 - share_1) * 0.31830987));
    float is_star = (smoothstep((0.3 * hole), (0.9 * hole), width_1) * smoothstep(0.5, 0.7, share_1));
    if ((is_star > 0.0)) {
        float _e27 = ink;
        const float _e34 = disk_filtered_2_(length(((cell - floor(cell)) - (0.5).xx)), hole, width_1);
        ink = lerp(_e27, (1.0 - _e34), is_star);
    }
    float _e38 = ink;
    float mean = lerp(_e38, share_1, smoothstep(0.4, 1.0, w_3));
    return (((share_1 <= 0.0) | false) ? share_1 : mean);
}

float ink_of_dots_2_(float2 cell_1, float share_2, float w_4)
{
    float ink_1 = (float)0;

    float width_2 = min(w_4, 1.0);
    const float _e11 = disk_filtered(length((cell_1 - round(cell_1))), sqrt((share_2 * 0.31830987)), width_2);
    ink_1 = _e11;
    float hole_1 = sqrt(((1.0 - share_2) * 0.31830987));
    float is_star_1 = (smoothstep((0.3 * hole_1), (0.9 * hole_1), width_2) * smoothstep(0.5, 0.7, share_2));
    if ((is_star_1 > 0.0)) {
        float _e29 = ink_1;
        const float _e36 = disk_filtered_2_(length(((cell_1 - floor(cell_1)) - (0.5).xx)), hole_1, width_2);
        ink_1 = lerp(_e29, (1.0 - _e36), is_star_1);
    }
    float _e40 = ink_1;
    float mean_1 = lerp(_e40, share_2, smoothstep(0.4, 1.0, w_4));
    return (((share_2 <= 0.0) | false) ? share_2 : mean_1);
}

float halftone_dots(float value, float2 place_1, float lines_1, float angle_3, float2 viewport_1)
{
    const float2 _e5 = screen_cells(place_1, viewport_1, lines_1, angle_3);
    const float2 _e6 = footprint_of_vec2_(_e5);
    const float _e14 = ink_of_dots(_e5, (1.0 - min(value, 1.0)), max(_e6.x, _e6.y));
    return (1.0 - _e14);
}

float halftone_dots_2_(float value_1, float2 place_2, float lines_2, float angle_4, float2 viewport_2)
{
    const float2 _e5 = screen_cells(place_2, viewport_2, lines_2, angle_4);
    const float2 _e6 = footprint_of_vec2_(_e5);
    const float _e12 = ink_of_dots_2_(_e5, (1.0 - value_1), max(_e6.x, _e6.y));
    return (1.0 - _e12);
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.25) / 1.25), 0.0);
    float red_to_print = lerp(0.15, 1.0, clamp(((light_and_shade - 0.1) / 0.65), 0.0, 1.0));
    float2 _e28 = look.viewport;
    const float _e29 = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994, _e28);
    float4 red_on_yellow = lerp(float4(0.91, 0.3, 0.24, 1.0), float4(1.0, 0.87, 0.58, 1.0), _e29);
    float3 _e45 = look.key.direction;
    float3 _e54 = look.key.direction;
    Angle turned_from_the_light = ConstructAngle((0.5 * length((surface.normal - _e45))), (0.5 * length((surface.normal + _e54))));
    const float _e62 = profile_balanced(turned_from_the_light, 0.0, not_in_deep_shade_shape);
    float deep_shade = (1.0 - _e62);
    float how_much_blue = (deep_shade * 0.62);
    float less = (1.0 - how_much_blue);
    float2 _e74 = look.viewport;
    const float _e75 = halftone_dots_2_(less, surface.pixel, 78.0, 1.3089969, _e74);
    float inked = (1.0 - _e75);
    float4 blue_over_it = float4(lerp(red_on_yellow.xyz, (red_on_yellow.xyz * float3(0.24, 0.3, 0.58)), inked), 1.0);
    Light _e90 = look.key;
    const Angle _e93 = parametrization_specular_balanced(_e90, surface.normal, surface.view);
    const float _e96 = profile_balanced(_e93, 0.0, highlight_shape);
    float4 left_free = lerp(blue_over_it, float4(1.0, 0.99, 0.95, 1.0), _e96);
    const float _e111 = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.22);
    float4 black_line = lerp(left_free, float4(0.09, 0.07, 0.13, 1.0), _e111);
    return black_line;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.normal = arg2;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float2 arg2) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.pixel = arg2;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e22 = view_1.screen;
    float4 _e27 = view_1.screen;
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), ((in_.clip_.xy * _e22.xy) + _e27.zw));
    const float4 _e31 = shade(surface_1);
    return _e31;
}
