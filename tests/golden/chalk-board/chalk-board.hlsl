// Chalk: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// chalk-board.json says what to put there and how to draw.
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
    Light back;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
};

struct Surface {
    float3 normal;
    float kappa;
    float2 pixel;
    int _pad3_0;
    int _pad3_1;
    float3 anchor;
    int _end_pad_0;
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

struct StretchedPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct SpacedPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct MarkPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct PaperGrain {
    float tone;
    float height;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
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

static const float MOST_ON_SCREEN = 1000000000000000.0;
static const ProfileShape orange_chalk_shape = ConstructProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u);

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 normal : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 normal_1 : LOC0;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float log2_stable(float x)
{
    uint bits = asuint(x);
    int exponent = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
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
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_1 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_1, u_1.half_cos));
    float2 turned = (((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_3 = ConstructAngle(turned.x, turned.y);
    return angle_3;
}

float bounded(float x_1)
{
    uint bits_1 = asuint(x_1);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1)
{
    float2 place_6 = float2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    const float _e19 = profile_soft_quick(place_6.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place_6.x * turn.y) - (place_6.y * turn.x)), shape_1);
    const float _e53 = profile_soft_quick(((place_6.x * turn.y) + (place_6.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_2 = (uint3)0;

    v_2 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_2.x;
    uint _e10 = v_2.y;
    uint _e12 = v_2.z;
    v_2.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_2.y;
    uint _e18 = v_2.z;
    uint _e20 = v_2.x;
    v_2.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_2.z;
    uint _e26 = v_2.x;
    uint _e28 = v_2.y;
    v_2.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_2;
    uint3 _e32 = v_2;
    v_2 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_2.x;
    uint _e40 = v_2.y;
    uint _e42 = v_2.z;
    v_2.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_2.y;
    uint _e48 = v_2.z;
    uint _e50 = v_2.x;
    v_2.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_2.z;
    uint _e56 = v_2.x;
    uint _e58 = v_2.y;
    v_2.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_2;
    return _e61;
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_1)
{
    int i = int(0);
    float sum = 0.0;

    float3 corner = floor(p);
    float3 d_1 = (p - corner);
    float3 f = (((d_1 * d_1) * d_1) * ((d_1 * ((d_1 * 6.0) - (15.0).xxx)) + (10.0).xxx));
    int3 cell = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e64 = i;
            i = asint(asuint(_e64) + asuint(int(1)));
        }
        loop_init = false;
        int _e21 = i;
        if (!((_e21 < int(8)))) {
            break;
        }
        int _e25 = i;
        int _e28 = i;
        int _e33 = i;
        int3 at_1 = int3((_e25 & int(1)), ((_e28 >> 1u) & int(1)), (_e33 >> 2u));
        float3 weight = ((at_1 == (int(1)).xxx) ? f : ((1.0).xxx - f));
        float _e44 = sum;
        const uint3 _e58 = hash_pcg3d((asuint(asint(asuint(cell) + asuint(at_1))) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
        const float _e61 = gradient_dot(_e58, (d_1 - float3(at_1)));
        sum = (_e44 + (((weight.x * weight.y) * 0.5) * _e61));
    }
    float _e67 = sum;
    return clamp((0.5 + (0.48244 * _e67)), 0.0, 1.0);
}

float size_on_screen(float depth, float perspective, float scale)
{
    return min(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

float3 anchor_on_screen(float3 origin, float perspective_1, float scale_1)
{
    const float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(float3((origin.x * _e5), (-(origin.y) * _e5), _e5), (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
}

float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = (pixel - (0.5 * viewport));
    return (float2(from_middle.x, -(from_middle.y)) / (max(viewport.y, 1.0)).xx);
}

StretchedPlace ConstructStretchedPlace(float2 arg0, float3 arg1) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle_1)
{
    float2 turn_1 = float2(0.0, 1.0);
    float3 x_2 = ((turn_1.y * along) + (turn_1.x * across));
    float3 y = ((turn_1.y * across) - (turn_1.x * along));
    float2 turned_1 = float2(((turn_1.y * place.x) + (turn_1.x * place.y)), ((turn_1.y * place.y) - (turn_1.x * place.x)));
    float3 stretch_5 = float3(dot(x_2, x_2), dot(x_2, y), dot(y, y));
    const StretchedPlace stretchedplace = ConstructStretchedPlace(turned_1, stretch_5);
    return stretchedplace;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_1, float3 stretch, float2 viewport_1, float count)
{
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    float2 p_1 = clamp((place_1 * scale_2), (-4194304.0).xx, (4194304.0).xx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_1, (is_pixel ? float3(1.0, 0.0, 1.0) : stretch));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_object(float angle_2, float3 anchor, float2 pixel_1, float2 viewport_2)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    const float2 _e8 = place_in_picture(pixel_1, viewport_2);
    float2 place_7 = ((_e8 - float2(anchor.x, -(anchor.y))) / (size).xx);
    const StretchedPlace _e26 = mark_place_of(place_7, float3((1.0 / size), 0.0, 0.0), float3(0.0, (1.0 / size), 0.0), angle_2);
    const MarkPlace markplace = ConstructMarkPlace(_e26.place, _e26.stretch);
    return markplace;
}

float paper_octave(float2 place_2, int zoom, float w_1, float fiber, uint seed_2)
{
    float scale_3 = asfloat((uint(asint(asuint(zoom) + asuint(int(127)))) << 23u));
    float2 p_2 = clamp((place_2 * scale_3), (-4194304.0).xx, (4194304.0).xx);
    uint own = (seed_2 + (7u * asuint(zoom)));
    const float _e23 = perlin_noise(float3(p_2, 0.5), own);
    float grain = (_e23 - 0.5);
    float2 q_1 = clamp((2.7 * float2(((0.8 * p_2.x) - (0.6 * p_2.y)), ((0.6 * p_2.x) + (0.8 * p_2.y)))), (-4194304.0).xx, (4194304.0).xx);
    const float _e52 = perlin_noise(float3(q_1, 0.5), (own + 1u));
    float felt = (_e52 - 0.5);
    float coarse_seen = (1.0 - smoothstep(0.5, 1.0, (w_1 * scale_3)));
    float felt_seen = (1.0 - smoothstep(0.5, 1.0, ((2.7 * w_1) * scale_3)));
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float paper_height(SpacedPlace at, float fiber_1, uint seed_3)
{
    float height = (float)0;

    float2 x_3 = ddx(at.place);
    float2 y_1 = ddy(at.place);
    float w_3 = sqrt(max(dot(x_3, x_3), dot(y_1, y_1)));
    const float _e12 = area_square(at.stretch);
    const float _e16 = log2_stable(max(sqrt(_e12), 1e-30));
    float level = clamp((-0.5 * _e16), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    const float _e26 = paper_octave(at.place, naga_f2i32(zoom_1), w_3, fiber_1, seed_3);
    height = _e26;
    if ((f_1 > 0.0)) {
        float _e30 = height;
        const float _e35 = paper_octave(at.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), w_3, fiber_1, seed_3);
        float both = lerp(_e30, _e35, f_1);
        height = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain ConstructPaperGrain(float arg0, float arg1) {
    PaperGrain ret = (PaperGrain)0;
    ret.tone = arg0;
    ret.height = arg1;
    return ret;
}

PaperGrain paper_grain(float value, float2 place_3, float3 stretch_2, float count_1, float tooth, float fiber_2, int seed_4, float2 viewport_3)
{
    const SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    const float _e10 = paper_height(_e8, fiber_2, 5u);
    float ink = (1.0 - value);
    const PaperGrain papergrain = ConstructPaperGrain((1.0 - clamp((ink + ((((8.0 * tooth) * (_e10 - 0.5)) * ink) * (1.0 - ink))), 0.0, 1.0)), _e10);
    return papergrain;
}

PaperGrain paper_grain_2_(float value_1, float2 place_4, float3 stretch_3, float count_2, float tooth_1, float fiber_3, int seed_5, float2 viewport_4)
{
    const SpacedPlace _e8 = spaced(place_4, stretch_3, viewport_4, count_2);
    const float _e10 = paper_height(_e8, fiber_3, 9u);
    float ink_1 = (1.0 - value_1);
    const PaperGrain papergrain_1 = ConstructPaperGrain((1.0 - clamp((ink_1 + ((((8.0 * tooth_1) * (_e10 - 0.5)) * ink_1) * (1.0 - ink_1))), 0.0, 1.0)), _e10);
    return papergrain_1;
}

PaperGrain paper_grain_3_(float value_2, float2 place_5, float3 stretch_4, float count_3, float tooth_2, float fiber_4, int seed_6, float2 viewport_5)
{
    const SpacedPlace _e8 = spaced(place_5, stretch_4, viewport_5, count_3);
    const float _e10 = paper_height(_e8, fiber_4, 3u);
    float ink_2 = (1.0 - max(value_2, 0.0));
    const PaperGrain papergrain_2 = ConstructPaperGrain((1.0 - clamp((ink_2 + ((((8.0 * tooth_2) * (_e10 - 0.5)) * ink_2) * (1.0 - ink_2))), 0.0, 1.0)), _e10);
    return papergrain_2;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e5) + 0.15) / 1.15), 0.0);
    float tone = min(((shade_2_ - 0.0) / 0.9), 1.0);
    float rubbed = lerp(0.05, 0.5, min(((tone - 0.0) / 0.6), 1.0));
    float r_bare = (1.0 - rubbed);
    float2 _e35 = look.viewport;
    const MarkPlace _e36 = mark_place_object(0.0, surface.anchor, surface.pixel, _e35);
    float2 _e45 = look.viewport;
    const PaperGrain _e46 = paper_grain(r_bare, _e36.place, _e36.stretch, 120.0, 0.6, 0.5, int(5), _e45);
    const float _e50 = bounded((1.0 - _e46.tone));
    float4 blue_gray = lerp(float4(0.1216, 0.1647, 0.1686, 1.0), float4(0.4275, 0.5098, 0.5647, 1.0), _e50);
    float3 _e66 = look.back.direction;
    float3 _e75 = look.back.direction;
    Angle turn_2 = ConstructAngle((0.5 * length((surface.normal - _e66))), (0.5 * length((surface.normal + _e75))));
    const float _e83 = profile_balanced(turn_2, 0.0, orange_chalk_shape);
    float o_bare = (1.0 - _e83);
    float2 _e94 = look.viewport;
    const PaperGrain _e95 = paper_grain_2_(o_bare, _e36.place, _e36.stretch, 220.0, 0.8, 0.5, int(9), _e94);
    const float _e104 = bounded((1.0 - _e95.tone));
    float4 orange = lerp(blue_gray, float4(0.9412, 0.6353, 0.3608, 1.0), _e104);
    float curvature = surface.kappa;
    float hollow_to_bulge = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.16), -20.0, 20.0))))))));
    float bare_in_hollows = lerp(0.1, 1.0, clamp(((hollow_to_bulge - 0.15) / 0.35), 0.0, 1.0));
    float white_chalk = (tone * bare_in_hollows);
    float w_bare = (1.0 - white_chalk);
    float2 _e146 = look.viewport;
    const PaperGrain _e147 = paper_grain_3_(w_bare, _e36.place, _e36.stretch, 260.0, 0.62, 0.5, int(3), _e146);
    const float _e156 = bounded((1.0 - _e147.tone));
    float4 white = lerp(orange, float4(0.9686, 0.9529, 0.9098, 1.0), _e156);
    return white;
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

Surface ConstructSurface(float3 arg0, float arg1, float2 arg2, float3 arg3) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.kappa = arg1;
    ret.pixel = arg2;
    ret.anchor = arg3;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.normal_1 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_2 = (is_front ? _e3 : -(_e3));
    float4 _e11 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e17 = view.screen;
    float4 _e22 = view.screen;
    float4x4 _e27 = view.camera_from_world;
    float4 _e31 = object.world_from_object[3];
    float _e40 = view.eye.w;
    float _e45 = view.clip_from_world[0].y;
    float _e50 = view.clip_from_world[1].y;
    float _e55 = view.clip_from_world[2].y;
    const float3 _e58 = anchor_on_screen(mul(float4(_e31.xyz, 1.0), _e27).xyz, _e40, length(float3(_e45, _e50, _e55)));
    Surface surface_1 = ConstructSurface(normal_2, _e11.x, ((in_.clip_.xy * _e17.xy) + _e22.zw), _e58);
    const float4 _e60 = shade(surface_1);
    return _e60;
}
