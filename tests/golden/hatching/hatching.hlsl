// Hatching: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_4 b0, object b1, look b2, curvature_tensor_map t0.
// hatching.json says what to put there and how to draw.
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
    float2 viewport;
    int _end_pad_0;
    int _end_pad_1;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    int _pad3_0;
    float3 curvature_tensor;
    float magnification;
    row_major float3x3 world_from_normal;
    int _end_pad_0;
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

struct Strokes {
    float width;
    float length_;
    float taper;
    float wobble;
    float pressure;
    float variation;
    uint seed;
};

struct Stroke {
    float turn;
    float profile;
};

struct MarkPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const float MOST_ON_SCREEN = 1000000000000000.0;

cbuffer view_4 : register(b0) { View view_4; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_5 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x)
{
    float whole_1 = round(x);
    float f = (x - whole_1);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole_1)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_1)
{
    uint bits = asuint(x_1);
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

float bounded(float x_2)
{
    uint bits_1 = asuint(x_2);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float3 bounded_vec3_(float3 v_2)
{
    uint3 bits_2 = asuint(v_2);
    uint3 magnitude_1 = (bits_2 & (2147483647u).xxx);
    float3 largest_1 = asfloat(((bits_2 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude_1 == (2139095040u).xxx) ? largest_1 : (0.0).xxx);
    return ((magnitude_1 < (2139095040u).xxx) ? v_2 : numbers);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float eased(float x_3, float low, float high)
{
    float t_1 = clamp(((x_3 - low) / (high - low)), 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float footprint_of(float x_4)
{
    float _e1 = ddx(x_4);
    float _e2 = ddy(x_4);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float2 principal_curvatures(float3 tensor)
{
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(float2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    const float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? float2(far, _e26) : float2(_e26, far));
}

float3x3 axes_around(float3 toward, float3 up)
{
    const float3 _e6 = normalize_moderate(toward, float3(0.0, 0.0, 1.0));
    float3 leaning = cross(up, _e6);
    float square_1 = dot(leaning, leaning);
    float3 aside = ((abs(_e6.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across_2 = ((square_1 > 1e-8) ? leaning : cross(aside, _e6));
    const float3 _e33 = normalize_moderate((across_2 - (dot(across_2, _e6) * _e6)), float3(1.0, 0.0, 0.0));
    return float3x3(_e33, cross(_e6, _e33), _e6);
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_3 = (uint3)0;

    v_3 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_3;
    uint3 _e32 = v_3;
    v_3 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_3;
    return _e61;
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(float3 p, uint seed_1)
{
    int i = int(0);
    float sum = 0.0;

    float3 corner = floor(p);
    float3 t_2 = (p - corner);
    float3 f_1 = (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - (15.0).xxx)) + (10.0).xxx));
    int3 cell = naga_f2i32(corner);
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e68 = i;
            i = asint(asuint(_e68) + asuint(int(1)));
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
        float3 weight = ((at_1 == (int(1)).xxx) ? f_1 : ((1.0).xxx - f_1));
        float _e44 = sum;
        const uint3 _e58 = hash_pcg3d((asuint(asint(asuint(cell) + asuint(at_1))) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
        sum = (_e44 + (((weight.x * weight.y) * 0.5) * (float3((_e58 >> (8u).xxx)) * 5.9604645e-8).x));
    }
    float _e71 = sum;
    return _e71;
}

float size_on_screen(float depth, float perspective, float scale)
{
    return min(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

StretchedPlace ConstructStretchedPlace(float2 arg0, float3 arg1) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    float2 turn = float2(0.0, 1.0);
    const float3 _e12 = bounded_vec3_(((turn.y * along) + (turn.x * across)));
    const float3 _e18 = bounded_vec3_(((turn.y * across) - (turn.x * along)));
    float2 turned = float2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    float3 most = (1000000000000000.0).xxx;
    float3 stretch_1 = clamp(float3(dot(_e12, _e12), dot(_e12, _e18), dot(_e18, _e18)), -(most), most);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(turned, stretch_1);
    return stretchedplace;
}

float3 gradient_on_picture(float3 g, float3 normal, float3 view)
{
    float facing = dot(normal, view);
    return (g - (normal * (dot(g, view) / ((facing >= 0.0) ? max(facing, 0.125) : min(facing, -0.125)))));
}

StretchedPlace place_on_surface(float2 place_1, float3 along_1, float3 across_1, float3 normal_1, float3 view_1, float magnification, float angle_1)
{
    float height = (1.0 / clamp(magnification, 1e-15, 1000000000000000.0));
    const float3 _e12 = gradient_on_picture(along_1, normal_1, view_1);
    const float3 _e14 = bounded_vec3_((_e12 * height));
    const float3 _e15 = gradient_on_picture(across_1, normal_1, view_1);
    const float3 _e17 = bounded_vec3_((_e15 * height));
    const StretchedPlace _e18 = mark_place_of(place_1, _e14, _e17, angle_1);
    const StretchedPlace stretchedplace_1 = _e18;
    return stretchedplace_1;
}

StretchedPlace place_across(float3 axis, float3 position, float3x3 world_from_normal, float3 normal_2, float3 view_2, float magnification_1, float angle_2)
{
    const float3x3 _e11 = axes_around(axis, float3(0.0, 1.0, 0.0));
    float2 place_5 = float2(dot(position, _e11[0]), dot(position, _e11[2]));
    float3 along_2 = mul(_e11[0], world_from_normal);
    float3 across_3 = mul(_e11[2], world_from_normal);
    const StretchedPlace _e21 = place_on_surface(place_5, along_2, across_3, normal_2, view_2, magnification_1, angle_2);
    const StretchedPlace stretchedplace_2 = _e21;
    return stretchedplace_2;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_2, float3 stretch, float2 viewport, float count)
{
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_1 = (is_pixel ? (count / max(viewport.y, 1.0)) : count);
    float2 p_1 = clamp((place_2 * scale_1), (-4194304.0).xx, (4194304.0).xx);
    const float3 _e21 = bounded_vec3_(stretch);
    float3 s = clamp(_e21, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_1, (is_pixel ? float3(1.0, 0.0, 1.0) : s));
    return spacedplace;
}

Stroke ConstructStroke(float arg0, float arg1) {
    Stroke ret = (Stroke)0;
    ret.turn = arg0;
    ret.profile = arg1;
    return ret;
}

Stroke stroke_at(int2 line_, float x_5, int zoom, Strokes style)
{
    const uint3 _e14 = hash_pcg3d((asuint(int3(line_, int(1048576))) + (style.seed * uint3(2654435769u, 2246822507u, 3266489909u))));
    float3 own_1 = (float3((_e14 >> (8u).xxx)) * 5.9604645e-8);
    float along_3 = (clamp(((x_5 * asfloat((uint(asint(asuint(zoom) + asuint(int(127)))) << 23u))) / 24.0), -1000000.0, 1000000.0) + own_1.x);
    float index = floor(along_3);
    const uint3 _e48 = hash_pcg3d((asuint(int3(line_, naga_f2i32(index))) + ((style.seed + asuint(zoom)) * uint3(2654435769u, 2246822507u, 3266489909u))));
    float3 chance = (float3((_e48 >> (8u).xxx)) * 5.9604645e-8);
    float from_end = min((along_3 - index), (1.0 - (along_3 - index)));
    float slope = min((from_end / (0.5 * style.taper)), 1.0);
    const Stroke stroke = ConstructStroke(chance.x, (slope * (2.0 - slope)));
    return stroke;
}

Stroke stroke_between(int2 line_1, float x_6, float level, Strokes style_1)
{
    float zoom_2 = floor(level);
    const Stroke _e6 = stroke_at(line_1, x_6, naga_f2i32(zoom_2), style_1);
    const Stroke _e10 = stroke_at(line_1, x_6, asint(asuint(naga_f2i32(zoom_2)) + asuint(int(1))), style_1);
    float f_2 = (level - zoom_2);
    const Stroke stroke_1 = ConstructStroke(lerp(_e6.turn, _e10.turn, f_2), lerp(_e6.profile, _e10.profile, f_2));
    return stroke_1;
}

int naga_neg(int val) {
    return asint(-asuint(val));
}

float stray_at(float2 place_3, int zoom_1, uint seed_2)
{
    float2 p_2 = (place_3 * asfloat((uint(asint(asuint(zoom_1) + asuint(int(127)))) << 23u)));
    const float _e18 = value_noise(float3((0.11 * p_2.x), (0.45 * p_2.y), 0.5), seed_2);
    return (((_e18 - 0.5) * 2.0) * asfloat((uint(asint(asuint(naga_neg(zoom_1)) + asuint(int(127)))) << 23u)));
}

float band_filtered(float t, float half_, float w)
{
    if ((w < 1e-30)) {
        return (((abs(t) <= half_) & (half_ > 0.0)) ? 1.0 : 0.0);
    }
    return clamp(((clamp((t + (0.5 * w)), -(half_), half_) - clamp((t - (0.5 * w)), -(half_), half_)) / w), 0.0, 1.0);
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int2 line_of(int whole, int octave)
{
    int power = ((whole == int(0)) ? int(1) : (whole & naga_neg(whole)));
    int octaves = asint(asuint(int((asuint(float(power)) >> 23u))) - asuint(int(127)));
    return ((whole == int(0)) ? (int(0)).xx : int2(naga_div(whole, power), asint(asuint(octave) - asuint(octaves))));
}

float hatched(float2 place_4, float w_1, float level_1, float ink, Strokes style_2)
{
    if (!((ink > 0.0))) {
        return 0.0;
    }
    float number = pow(ink, 0.75);
    float width = (style_2.width * pow(ink, 0.25));
    float zoom_3 = floor(level_1);
    const float _e18 = stray_at(place_4, naga_f2i32(zoom_3), style_2.seed);
    const float _e23 = stray_at(place_4, asint(asuint(naga_f2i32(zoom_3)) + asuint(int(1))), style_2.seed);
    float stray = lerp(_e18, _e23, (level_1 - zoom_3));
    float across_4 = (place_4.y + (style_2.wobble * stray));
    const float _e32 = log2_stable(max(number, 1e-9));
    float density = max((level_1 + _e32), -40.0);
    float octave_1 = floor(density);
    const float _e38 = exp2_stable((density - octave_1));
    float growth = (_e38 - 1.0);
    float scale_2 = asfloat((uint(asint(asuint(naga_f2i32(octave_1)) + asuint(int(127)))) << 23u));
    float q = clamp((across_4 * scale_2), -4194304.0, 4194304.0);
    const float _e55 = exp2_stable((octave_1 - level_1));
    float half_1 = ((0.5 * width) * _e55);
    float footprint = (w_1 * scale_2);
    int whole_2 = naga_f2i32(round(q));
    const int2 _e61 = line_of(whole_2, naga_f2i32(octave_1));
    const Stroke _e63 = stroke_between(_e61, place_4.x, level_1, style_2);
    float middle = floor(q);
    const Stroke _e75 = stroke_between(int2(asint(asuint(asint(asuint(int(2)) * asuint(naga_f2i32(middle)))) + asuint(int(1))), asint(asuint(naga_f2i32(octave_1)) + asuint(int(1)))), place_4.x, level_1, style_2);
    float grown = clamp(((growth - (0.75 * _e75.turn)) / 0.25), 0.0, 1.0);
    const float _e89 = band_filtered((q - float(whole_2)), (half_1 * _e63.profile), footprint);
    const float _e96 = band_filtered(((q - middle) - 0.5), ((half_1 * grown) * _e75.profile), footprint);
    float mean_1 = min(((2.0 * half_1) * (1.0 + growth)), 1.0);
    return lerp(max(_e89, _e96), mean_1, smoothstep(0.75, 1.5, footprint));
}

float cross_hatched(SpacedPlace at, float ink_1, int layers, float cross_, Strokes style_3)
{
    Strokes own = (Strokes)0;
    int i_1 = int(0);
    float free = 1.0;

    float2 x_8 = ddx(at.place);
    float2 y = ddy(at.place);
    float amount = (ink_1 * 3.0);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e94 = i_1;
            i_1 = asint(asuint(_e94) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e16 = i_1;
        if (!((_e16 < int(4)))) {
            break;
        }
        int _e20 = i_1;
        if ((_e20 < int(3))) {
            int _e23 = i_1;
            float x_2_ = (float(_e23) * cross_);
            float2 turn_1 = float2(sin(x_2_), cos(x_2_));
            float2 along_4 = float2(turn_1.y, turn_1.x);
            float2 across_5 = float2(-(turn_1.x), turn_1.y);
            float w_2 = length(float2(dot(across_5, x_8), dot(across_5, y)));
            float square_2 = dot(float3((across_5.x * across_5.x), ((2.0 * across_5.x) * across_5.y), (across_5.y * across_5.y)), at.stretch);
            const float _e64 = log2_stable(max(max(square_2, ((at.stretch.x + at.stretch.z) / 65.0)), 1e-30));
            float level_2 = clamp((-0.5 * _e64), -16.0, 16.0);
            float2 place_6 = float2(dot(along_4, at.place), dot(across_5, at.place));
            own = style_3;
            int _e78 = i_1;
            own.seed = (4u + (101u * uint(_e78)));
            float _e82 = free;
            int _e83 = i_1;
            Strokes _e89 = own;
            const float _e90 = hatched(place_6, w_2, level_2, clamp((amount - float(_e83)), 0.0, 1.0), _e89);
            free = (_e82 * (1.0 - _e90));
        }
    }
    float _e97 = free;
    return (1.0 - _e97);
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_light(Light light, float3 normal_3, float angle_3, float3 view_3, float3 position_object, float3x3 world_from_normal_1, float magnification_2)
{
    float3 toward_1 = mul(world_from_normal_1, light.direction);
    const StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_3);
    const MarkPlace markplace = ConstructMarkPlace(_e9.place, _e9.stretch);
    return markplace;
}

float faded_in(float x_7, float limit, float softness)
{
    const float _e3 = footprint_of(x_7);
    float width_1 = length(float2(min(_e3, 1000000000000000.0), (limit * softness)));
    const float _e9 = bounded(x_7);
    const float _e11 = bounded((_e9 - limit));
    return clamp((0.5 + (_e11 / width_1)), 0.0, 1.0);
}

Strokes ConstructStrokes(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, uint arg6) {
    Strokes ret = (Strokes)0;
    ret.width = arg0;
    ret.length_ = arg1;
    ret.taper = arg2;
    ret.wobble = arg3;
    ret.pressure = arg4;
    ret.variation = arg5;
    ret.seed = arg6;
    return ret;
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.35) / 1.35), 0.0);
    float tone_to_draw = lerp(0.04, 1.0, min(((light_and_shade - 0.0) / 0.85), 1.0));
    Light _e24 = look.key;
    const MarkPlace _e31 = mark_place_light(_e24, surface.normal, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    float2 _e36 = look.viewport;
    const SpacedPlace _e38 = spaced(_e31.place, _e31.stretch, _e36, 120.0);
    const float _e53 = cross_hatched(_e38, (1.0 - min(tone_to_draw, 1.0)), int(3), 0.8, ConstructStrokes(0.42, 24.0, 0.6, 0.45, 0.25, 1.0, 4u));
    const float _e62 = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.34, 0.2);
    float ink_2 = max(_e53, _e62);
    const float2 _e65 = principal_curvatures(surface.curvature_tensor);
    const float _e70 = faded_in(-(_e65.y), 75.0, 0.3);
    float features = (_e70 * smoothstep(0.05, 0.3, dot(surface.normal, surface.view)));
    float strokes_and_features = max(ink_2, features);
    float4 pen_on_paper = lerp(float4(0.965, 0.937, 0.875, 1.0), float4(0.12, 0.105, 0.16, 1.0), strokes_and_features);
    return pen_on_paper;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2, float3 arg3) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.position_object = arg2;
    ret.normal = arg3;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_4.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float arg4, float3x3 arg5) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.curvature_tensor = arg3;
    ret.magnification = arg4;
    ret.world_from_normal = arg5;
    return ret;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_2, fragmentinput_fs_main.normal_5 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_6 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_4.eye;
    float _e13 = view_4.eye.w;
    float4 _e24 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e28 = view_4.camera_from_world;
    float _e38 = view_4.eye.w;
    float _e43 = view_4.clip_from_world[0].y;
    float _e48 = view_4.clip_from_world[1].y;
    float _e53 = view_4.clip_from_world[2].y;
    const float _e56 = size_on_screen(-(mul(float4(in_.position, 1.0), _e28).z), _e38, length(float3(_e43, _e48, _e53)));
    float3x3 _e59 = object.world_from_normal;
    Surface surface_1 = ConstructSurface(normal_6, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.xyz, _e56, _e59);
    const float4 _e61 = shade(surface_1);
    return _e61;
}
