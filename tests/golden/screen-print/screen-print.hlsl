// Screen print: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// screen-print.json says what to put there and how to draw.
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
    Light side;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    float kappa;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape yellow_s_share_shape = ConstructProfileShape(0.9887711, 0.14943813, 2.0858297, 1.7378688, 0.3, 0.54759663, 0.22553022, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_1 : LOC1;
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

float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_1)
{
    const float3 _e5 = normalize_moderate(v_1, float3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_7 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_7, 0.5);
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
    const Angle angle_6 = ConstructAngle(turned.x, turned.y);
    return angle_6;
}

float bounded(float x_1)
{
    uint bits = asuint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float place_between(float x_2, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_2 >= high) ? 1.0 : 0.0);
    }
    const float _e13 = bounded(((x_2 - low) / span));
    return _e13;
}

float eased(float x_3, float low_1, float high_1)
{
    const float _e3 = place_between(x_3, low_1, high_1);
    float t_1 = clamp(_e3, 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
    float2 d_2 = float2(_e1, _e2);
    return sqrt(dot(d_2, d_2));
}

float2 footprint_of_vec2_(float2 v_2)
{
    float2 dx_1 = ddx(v_2);
    float2 dy_1 = ddy(v_2);
    return sqrt(((dx_1 * dx_1) + (dy_1 * dy_1)));
}

float step_filtered(float x_5, float edge, float w)
{
    float d_3 = (x_5 - edge);
    return ((w < 1e-30) ? ((d_3 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_3 / w)), 0.0, 1.0));
}

float4 mix_colors_multiply(float4 a, float4 b, float factor)
{
    return float4(lerp(a.xyz, (a.xyz * b.xyz), factor), 1.0);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_1)
{
    float2 place_4 = float2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    const float _e19 = profile_soft_quick(place_4.x, shape_1);
    if ((w_1 < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r_2 = (0.19364917 * w_1);
    float2 turn = float2((r_2 * (1.0 - ((0.16666667 * r_2) * r_2))), (1.0 - ((0.5 * r_2) * r_2)));
    const float _e45 = profile_soft_quick(((place_4.x * turn.y) - (place_4.y * turn.x)), shape_1);
    const float _e53 = profile_soft_quick(((place_4.x * turn.y) + (place_4.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

float2 turned_by(float2 p, float angle_1)
{
    float2 turn_1 = float2(sin(angle_1), cos(angle_1));
    return float2(((turn_1.y * p.x) - (turn_1.x * p.y)), ((turn_1.x * p.x) + (turn_1.y * p.y)));
}

float2 screen_cells(float2 place, float2 viewport, float lines, float angle_2)
{
    float2 most = (4194304.0).xx;
    float2 upright = (place * (lines / max(viewport.y, 1.0)));
    const float2 _e14 = turned_by(clamp(upright, (-4194304.0).xx, most), angle_2);
    return clamp(_e14, (-4194304.0).xx, most);
}

float lines_integral(float x_6, float share)
{
    float whole = round(x_6);
    return ((whole * share) + clamp((x_6 - whole), (-0.5 * share), (0.5 * share)));
}

float lines_filtered(float x_7, float share_1, float w_2)
{
    float t_2 = (x_7 - round(x_7));
    if ((w_2 < 1e-30)) {
        return (((abs(t_2) <= (0.5 * share_1)) & (share_1 > 0.0)) ? 1.0 : 0.0);
    }
    float half_1 = (0.5 * min(w_2, 1000.0));
    const float _e22 = lines_integral((t_2 + half_1), share_1);
    const float _e24 = lines_integral((t_2 - half_1), share_1);
    return clamp(((_e22 - _e24) / (2.0 * half_1)), 0.0, 1.0);
}

float dot_radius(float share_2)
{
    float a_1 = (float)0;
    int i = int(0);

    if ((share_2 <= 0.7853982)) {
        return sqrt((share_2 * 0.31830987));
    }
    float s_3 = ((share_2 - 0.7853982) / 0.21460183);
    a_1 = lerp((0.5227232 * sqrt(s_3)), (0.7853982 - (0.3275682 * sqrt((1.0 - s_3)))), s_3);
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
        float _e28 = a_1;
        const float2 _e32 = sin_cos_quarter(clamp(_e28, 0.0, 0.7853982));
        float tangent = (_e32.x / _e32.y);
        float square_1 = (1.0 / (_e32.y * _e32.y));
        float _e41 = a_1;
        float sector = (0.7853982 - _e41);
        float slope = (((2.0 * sector) * square_1) * tangent);
        float _e48 = a_1;
        a_1 = clamp((_e48 - ((slope > 0.001) ? ((((sector * square_1) + tangent) - share_2) / slope) : 0.0)), 0.0, 0.7853982);
    }
    float _e64 = a_1;
    const float2 _e65 = sin_cos_quarter(_e64);
    return (0.5 / _e65.y);
}

float disk_filtered(float d, float r, float w_3)
{
    if ((w_3 < 1e-30)) {
        return (((d <= r) & (r > 0.0)) ? 1.0 : 0.0);
    }
    float square_2 = (r * r);
    float least = ((w_3 * w_3) / 3.0);
    float inner = sqrt((max(square_2, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d) / w_3)), 0.0, 1.0) * min((square_2 / least), 1.0));
}

float disk_filtered_2_(float d_1, float r_1, float w_4)
{
    if ((w_4 < 1e-30)) {
        return (((d_1 <= r_1) & true) ? 1.0 : 0.0);
    }
    float square_3 = (r_1 * r_1);
    float least_1 = ((w_4 * w_4) / 3.0);
    float inner_1 = sqrt((max(square_3, least_1) - (0.25 * least_1)));
    return (clamp((0.5 + ((inner_1 - d_1) / w_4)), 0.0, 1.0) * min((square_3 / least_1), 1.0));
}

float ink_of_dots(float2 cell, float share_3, float w_5)
{
    float ink = (float)0;

    float width = min(w_5, 1.0);
    const float _e8 = dot_radius(share_3);
    const float _e9 = disk_filtered(length((cell - round(cell))), _e8, width);
    ink = _e9;
    float hole = sqrt(((1.0 - share_3) * 0.31830987));
    float is_star = (smoothstep((0.3 * hole), (0.9 * hole), width) * smoothstep(0.5, 0.7, share_3));
    if ((is_star > 0.0)) {
        float _e27 = ink;
        const float _e34 = disk_filtered_2_(length(((cell - floor(cell)) - (0.5).xx)), hole, width);
        ink = lerp(_e27, (1.0 - _e34), is_star);
    }
    float _e38 = ink;
    float mean = lerp(_e38, share_3, smoothstep(0.4, 1.0, w_5));
    return (((share_3 <= 0.0) | false) ? share_3 : mean);
}

float ink_of_dots_2_(float2 cell_1, float share_4, float w_6)
{
    float ink_1 = (float)0;

    float width_1 = min(w_6, 1.0);
    const float _e8 = dot_radius(share_4);
    const float _e9 = disk_filtered(length((cell_1 - round(cell_1))), _e8, width_1);
    ink_1 = _e9;
    float hole_1 = sqrt(((1.0 - share_4) * 0.31830987));
    const float _e20 = eased(width_1, (0.3 * hole_1), (0.9 * hole_1));
    float is_star_1 = (_e20 * smoothstep(0.5, 0.7, share_4));
    if ((is_star_1 > 0.0)) {
        float _e27 = ink_1;
        const float _e34 = disk_filtered_2_(length(((cell_1 - floor(cell_1)) - (0.5).xx)), hole_1, width_1);
        ink_1 = lerp(_e27, (1.0 - _e34), is_star_1);
    }
    float _e38 = ink_1;
    float mean_1 = lerp(_e38, share_4, smoothstep(0.4, 1.0, w_6));
    return (((share_4 <= 0.0) | false) ? share_4 : mean_1);
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
    const float _e14 = ink_of_dots_2_(_e5, (1.0 - min(value_1, 1.0)), max(_e6.x, _e6.y));
    return (1.0 - _e14);
}

float halftone_lines(float value_2, float2 place_3, float lines_3, float angle_5, float2 viewport_3)
{
    const float2 _e5 = screen_cells(place_3, viewport_3, lines_3, angle_5);
    const float _e10 = footprint_of(_e5.y);
    const float _e11 = lines_filtered(_e5.y, (1.0 - value_2), _e10);
    return (1.0 - _e11);
}

float4 shade(Surface surface)
{
    float3 _e5 = look.side.direction;
    float3 _e14 = look.side.direction;
    Angle side = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(side, 0.0, yellow_s_share_shape);
    float pale = lerp(1.0, 0.25, (_e22 - 0.0));
    float2 _e33 = look.viewport;
    const float _e34 = halftone_lines(pale, surface.pixel, 56.0, 0.0, _e33);
    float4 p1_ink = lerp(float4(0.9647, 0.8118, 0.2902, 1.0), (1.0).xxxx, _e34);
    const float4 _e49 = mix_colors_multiply(float4(0.9686, 0.9373, 0.8784, 1.0), p1_ink, 1.0);
    float3 _e54 = look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e54) + 0.3) / 1.3), 0.0);
    float tone = min(((shade_2_ - 0.0) / 0.8), 1.0);
    float coral_s_share = lerp(0.12, 1.0, clamp(((tone - 0.25) / 0.7), 0.0, 1.0));
    float2 _e83 = look.viewport;
    const float _e84 = halftone_dots(coral_s_share, surface.pixel, 56.0, 0.2618, _e83);
    float4 p2_ink = lerp(float4(0.9333, 0.3529, 0.2902, 1.0), (1.0).xxxx, _e84);
    float4 printed_over = float4(lerp(_e49.xyz, (_e49.xyz * p2_ink.xyz), 1.0), 1.0);
    float teal_s_share = lerp(0.05, 1.0, min(((tone - 0.0) / 0.5), 1.0));
    float2 _e115 = look.viewport;
    const float _e116 = halftone_dots_2_(teal_s_share, surface.pixel, 56.0, 1.309, _e115);
    float4 p3_ink = lerp(float4(0.1216, 0.5608, 0.5922, 1.0), (1.0).xxxx, _e116);
    float4 printed_over_2_ = float4(lerp(printed_over.xyz, (printed_over.xyz * p3_ink.xyz), 1.0), 1.0);
    float curvature = surface.kappa;
    float hollow = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.25), -20.0, 20.0))))))));
    const float _e153 = footprint_of(hollow);
    const float _e157 = step_filtered(hollow, 0.22, length(float2(_e153, 0.0)));
    float facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    const float _e165 = footprint_of(facing);
    const float _e169 = step_filtered(facing, 0.28, length(float2(_e165, 0.0)));
    float black_screen = (_e157 * _e169);
    float4 p4_ink = lerp(float4(0.0902, 0.0745, 0.1216, 1.0), (1.0).xxxx, black_screen);
    float4 printed_over_3_ = float4(lerp(printed_over_2_.xyz, (printed_over_2_.xyz * p4_ink.xyz), 1.0), 1.0);
    return printed_over_3_;
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
    float4x4 _e10 = view.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float arg2, float2 arg3) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.kappa = arg2;
    ret.pixel = arg3;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view.eye;
    float _e13 = view.eye.w;
    float4 _e23 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e29 = view.screen;
    float4 _e34 = view.screen;
    Surface surface_1 = ConstructSurface(normal_2, normalize((_e8.xyz - (_e13 * in_.position))), _e23.x, ((in_.clip_.xy * _e29.xy) + _e34.zw));
    const float4 _e38 = shade(surface_1);
    return _e38;
}
