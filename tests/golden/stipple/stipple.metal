// Stipple: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2).
// stipple.json says what to put there and how to draw.
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
    metal::float2 viewport;
    char _pad1[8];
    Light key;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::float2 pixel;
    char _pad3[8];
    metal::float3 anchor;
};
typedef metal::float4 Color;
typedef metal::float4 Composite;
struct type_11 {
    uint inner[256];
};
struct StretchedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct SpacedPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
};
struct Dots {
    float size;
    float scatter;
    uint seed;
};
struct MarkPlace {
    metal::float2 place;
    char _pad1[8];
    metal::float3 stretch;
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
constant float HALF_PI = 1.5707964;
constant float LN_2_ = 0.6931472;
constant float LOG2_E = 1.442695;
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant type_11 BLUE_TILE = type_11 {{667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u}};

bool is_finite(
    float x
) {
    return (as_type<uint>(x) & 2139095040u) != 2139095040u;
}

float finite_or(
    float x_1,
    float otherwise
) {
    bool _e2 = is_finite(x_1);
    return _e2 ? x_1 : otherwise;
}

metal::float3 finite_vec3_(
    metal::float3 v
) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return metal::float3(_e3, _e6, _e9);
}

metal::float4 finite_vec4_(
    metal::float4 v_1
) {
    metal::float3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return metal::float4(_e2, _e5);
}

metal::float3 normalize_or(
    metal::float3 v_2,
    metal::float3 otherwise_1
) {
    bool local = {};
    float largest = metal::max(metal::max(metal::abs(v_2.x), metal::abs(v_2.y)), metal::abs(v_2.z));
    if (largest > 0.000000000000000000000000000001) {
        local = largest < 1000000000000000000000000000000.0;
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    metal::float3 scaled = v_2 * (1.0 / largest);
    float square_1 = metal::dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return scaled * (1.0 / metal::sqrt(square_1));
}

float power_of_two(
    int n
) {
    return as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(n) + as_type<uint>(127))) << 23u);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float exp2_stable(
    float x_2
) {
    float clamped_3 = metal::clamp(x_2, -150.0, 127.99999);
    float whole = metal::rint(clamped_3);
    float f = (clamped_3 - whole) * LN_2_;
    float p = 1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127)))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two(as_type<int>(as_type<uint>(naga_f2i32(whole)) - as_type<uint>(half_whole)));
    return (p * _e33) * _e37;
}

float log_stable(
    float x_3
) {
    uint bits = as_type<uint>(x_3);
    int shift = static_cast<int>((bits - 1060439283u) >> 23u);
    int exponent = (shift >= 256) ? as_type<int>(as_type<uint>(shift) - as_type<uint>(512)) : shift;
    float mantissa = as_type<float>(bits - (static_cast<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    float series = (2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111))))))));
    return (static_cast<float>(exponent) * LN_2_) + series;
}

metal::float2 sin_cos_quarter(
    float x_4
) {
    float h = 0.5 * x_4;
    float h2_ = h * h;
    float s = h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (0.0000027557319 + (h2_ * -0.000000025052108))))))))));
    float one_minus_c = h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-0.000024801588 + (h2_ * (0.0000002755732 + (h2_ * -0.0000000020876756))))))))));
    float c = 1.0 - one_minus_c;
    return metal::float2((2.0 * s) * c, 1.0 - ((2.0 * s) * s));
}

metal::float2 sin_cos(
    float x_5
) {
    float turns = metal::rint(x_5 * 0.31830987);
    float r_1 = ((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 0.00000062783295);
    float sign = 1.0 - (2.0 * metal::abs(turns - (2.0 * metal::trunc(turns * 0.5))));
    metal::float2 _e27 = sin_cos_quarter(metal::clamp(r_1, -1.5707964, HALF_PI));
    return sign * _e27;
}

float bounded(
    float x_6
) {
    uint bits_1 = as_type<uint>(x_6);
    uint magnitude = bits_1 & 2147483647u;
    float largest_1 = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0);
}

metal::float2 bounded_vec2_(
    metal::float2 v_3
) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return metal::float2(_e2, _e4);
}

metal::float3 bounded_vec3_(
    metal::float3 v_4
) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return metal::float3(_e2, _e4, _e6);
}

metal::float4 bounded_vec4_(
    metal::float4 v_5
) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return metal::float4(_e2, _e4, _e6, _e8);
}

float mixed(
    float a,
    float b,
    float t
) {
    float _e4 = bounded(b - a);
    float _e14 = bounded((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4)));
    return _e14;
}

metal::float3 mixed_vec3_(
    metal::float3 a_1,
    metal::float3 b_1,
    float t_1
) {
    float _e5 = mixed(a_1.x, b_1.x, t_1);
    float _e8 = mixed(a_1.y, b_1.y, t_1);
    float _e11 = mixed(a_1.z, b_1.z, t_1);
    return metal::float3(_e5, _e8, _e11);
}

metal::float4 mixed_vec4_(
    metal::float4 a_2,
    metal::float4 b_2,
    float t_2
) {
    metal::float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_2);
    float _e8 = mixed(a_2.w, b_2.w, t_2);
    return metal::float4(_e5, _e8);
}

float place_between(
    float x_7,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_7 >= high) ? 1.0 : 0.0;
    }
    float _e12 = bounded(span);
    float _e14 = bounded((x_7 - low) / _e12);
    return _e14;
}

float remapped(
    float x_8,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, clamped ? metal::clamp(_e9, 0.0, 1.0) : _e9);
    return _e16;
}

float eased(
    float x_9,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = metal::clamp(_e6, 0.0, 1.0);
    return (t_3 * t_3) * (3.0 - (2.0 * t_3));
}

float factor_of(
    float x_10,
    bool clamped_1
) {
    float _e2 = bounded(x_10);
    float _e3 = bounded(x_10);
    return clamped_1 ? metal::clamp(_e3, 0.0, 1.0) : _e2;
}

metal::float2 sin_cos_of(
    float x_11
) {
    float _e1 = bounded(x_11);
    metal::float2 _e2 = sin_cos(_e1);
    return metal::clamp(_e2, metal::float2(-1.0), metal::float2(1.0));
}

Composite premultiplied(
    Color color
) {
    return metal::float4(color.xyz * color.w, color.w);
}

Color straight(
    Composite composite
) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return metal::float4(composite.xyz / metal::float3(composite.w), composite.w);
}

Color mix_colors_normal(
    Color a_3,
    Color b_3,
    float factor
) {
    metal::float4 _e3 = bounded_vec4_(a_3);
    metal::float4 _e4 = bounded_vec4_(b_3);
    float _e6 = factor_of(factor, true);
    metal::float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float facing(
    metal::float3 normal,
    metal::float3 view
) {
    metal::float3 _e4 = normalize_or(normal, metal::float3(0.0));
    return metal::clamp(metal::dot(_e4, view), 0.0, 1.0);
}

Color output(
    Composite color_1
) {
    Color _e1 = straight(color_1);
    metal::float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_6 = {};
    v_6 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = _e8 + (_e10 * _e12);
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = _e16 + (_e18 * _e20);
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_6;
    metal::uint3 _e32 = v_6;
    v_6 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = _e38 + (_e40 * _e42);
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = _e46 + (_e48 * _e50);
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_6;
    return _e61;
}

metal::float3 unit_of_hash(
    metal::uint3 hash
) {
    return static_cast<metal::float3>(hash >> metal::uint3(8u)) * 0.000000059604645;
}

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    float _e10 = bounded((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective));
    return _e10;
}

metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective_1,
    float scale_1
) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    metal::float3 _e12 = bounded_vec3_(metal::float3(origin.x * _e5, -(origin.y) * _e5, _e5));
    return _e12;
}

metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 _e2 = bounded_vec2_(pixel);
    metal::float2 from_middle = _e2 - (0.5 * viewport);
    return metal::float2(from_middle.x, -(from_middle.y)) / metal::float2(metal::max(viewport.y, 1.0));
}

float disk_filtered(
    float d,
    float r,
    float w
) {
    bool local_1 = {};
    if (w < 0.000000000000000000000000000001) {
        if (d <= r) {
            local_1 = r > 0.0;
        } else {
            local_1 = false;
        }
        bool _e11 = local_1;
        return _e11 ? 1.0 : 0.0;
    }
    float square_2 = r * r;
    float least = (w * w) / 3.0;
    float inner = metal::sqrt(metal::max(square_2, least) - (0.25 * least));
    return metal::clamp(0.5 + ((inner - d) / w), 0.0, 1.0) * metal::min(square_2 / least, 1.0);
}

uint blue_index(
    metal::int2 cell_1
) {
    metal::uint2 at_1 = as_type<metal::uint2>(cell_1) & metal::uint2(31u);
    return (8u * at_1.y) + (at_1.x >> 2u);
}

float blue_part(
    uint four,
    metal::int2 cell_2
) {
    return (static_cast<float>((four >> (8u * (as_type<uint>(cell_2.x) & 3u))) & 255u) + 0.5) * 0.00390625;
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 _e4 = sin_cos_of(angle);
    metal::float3 _e10 = bounded_vec3_((_e4.y * along) + (_e4.x * across));
    metal::float3 _e16 = bounded_vec3_((_e4.y * across) - (_e4.x * along));
    metal::float2 _e17 = bounded_vec2_(place);
    metal::float2 turned = metal::float2((_e4.y * _e17.x) + (_e4.x * _e17.y), (_e4.y * _e17.y) - (_e4.x * _e17.x));
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch_5 = metal::clamp(metal::float3(metal::dot(_e10, _e10), metal::dot(_e10, _e16), metal::dot(_e16, _e16)), -(most), most);
    metal::float2 _e41 = bounded_vec2_(turned);
    return StretchedPlace {_e41, {}, stretch_5};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    float _e4 = bounded(count);
    float number = metal::clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = is_pixel ? (number / metal::max(viewport_1.y, 1.0)) : number;
    metal::float2 _e19 = bounded_vec2_(place_1);
    metal::float2 _e21 = bounded_vec2_(_e19 * scale_2);
    metal::float2 p_1 = metal::clamp(_e21, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float3 _e27 = bounded_vec3_(stretch);
    metal::float3 s_1 = metal::clamp(_e27, metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
    return SpacedPlace {p_1, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s_1};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_1 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_1 * sum_1) / 66.0);
}

float octave_of(
    float square
) {
    float _e5 = log_stable(metal::clamp(square, 0.000000000000000000000000000001, 1000000000000000000000000000000.0));
    return metal::clamp(-0.7213475 * _e5, -16.0, 16.0);
}

float picture_square(
    metal::float2 offset,
    metal::float3 stretch_2
) {
    float _e2 = area_square(stretch_2);
    float area = metal::max(_e2, 0.000000000000000000000000000001);
    float square_3 = (((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y);
    return metal::max(square_3, 0.0) / area;
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

float dots_of_octave(
    metal::float2 place_2,
    int zoom,
    float ink,
    metal::float3 stretch_3,
    float w_1,
    Dots style
) {
    type_11 tile = BLUE_TILE;
    float sum = 0.0;
    int i = 0;
    float _e6 = power_of_two(zoom);
    metal::float2 p_2 = metal::clamp(place_2 * _e6, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float2 corner = metal::floor(p_2);
    float reach = 1.0 - (0.5 * style.scatter);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e93 = i;
            i = as_type<int>(as_type<uint>(_e93) + as_type<uint>(1));
        }
        loop_init = false;
        int _e25 = i;
        if (_e25 < 9) {
        } else {
            break;
        }
        {
            int _e29 = i;
            int _e34 = i;
            metal::int2 cell_3 = as_type<metal::int2>(as_type<metal::uint2>(naga_f2i32(corner)) + as_type<metal::uint2>(metal::int2(as_type<int>(as_type<uint>(naga_mod(_e29, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e34, 3)) - as_type<uint>(1)))));
            metal::uint3 _e43 = lattice_hash(metal::int3(cell_3, zoom), style.seed);
            metal::float3 _e44 = unit_of_hash(_e43);
            metal::float2 middle = (static_cast<metal::float2>(cell_3) + metal::float2(0.5)) + (style.scatter * (_e44.xy - metal::float2(0.5)));
            metal::float2 offset_1 = p_2 - middle;
            metal::int2 turning = as_type<metal::int2>(as_type<metal::uint2>(cell_3) + as_type<metal::uint2>(metal::int2(static_cast<int>(style.seed & 31u), as_type<int>(as_type<uint>(zoom) * as_type<uint>(7)))));
            uint _e65 = blue_index(turning);
            uint _e67 = tile.inner[_e65];
            float _e68 = blue_part(_e67, turning);
            float turn = 0.96875 * _e68;
            float grown = metal::clamp((ink - turn) * 32.0, 0.0, 1.0);
            float radius = (0.5 * style.size) * metal::sqrt(grown);
            float far = metal::length(offset_1) / reach;
            float _e84 = picture_square(offset_1, stretch_3);
            float d_1 = metal::max(metal::sqrt(_e84), (far * far) * radius);
            float _e89 = sum;
            float _e90 = disk_filtered(d_1, radius, w_1);
            sum = metal::max(_e89, _e90);
        }
    }
    float _e95 = sum;
    return _e95;
}

float stippled(
    SpacedPlace at,
    float ink_1,
    Dots style_1
) {
    float dots = {};
    metal::float2 dx = metal::dfdx(at.place);
    metal::float2 dy = metal::dfdy(at.place);
    float _e8 = picture_square(dx, at.stretch);
    float _e10 = picture_square(dy, at.stretch);
    float _e13 = bounded(metal::sqrt(metal::max(_e8, _e10)));
    float _e14 = bounded(ink_1);
    float amount = metal::clamp(_e14, 0.0, 1.0);
    metal::float3 s_2 = at.stretch;
    float _e19 = area_square(s_2);
    float _e21 = octave_of(metal::sqrt(_e19));
    float zoom_1 = metal::floor(_e21);
    float f_1 = _e21 - zoom_1;
    float _e26 = exp2_stable(-2.0 * f_1);
    float coarse = 1.0 - f_1;
    float fine = (1.0 - (coarse * _e26)) / (4.0 * _e26);
    float _e40 = exp2_stable(2.0 * zoom_1);
    float _e42 = dots_of_octave(at.place, naga_f2i32(zoom_1), amount * coarse, s_2 * _e40, _e13, style_1);
    dots = _e42;
    if (fine > 0.0) {
        float _e55 = exp2_stable((2.0 * zoom_1) + 2.0);
        float _e57 = dots_of_octave(at.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), amount * fine, s_2 * _e55, _e13, style_1);
        float _e58 = dots;
        dots = metal::max(_e58, _e57);
    }
    float mean = amount * metal::min((0.7853982 * style_1.size) * style_1.size, 1.0);
    float _e68 = dots;
    float _e71 = eased(_e13, 0.75, 1.5);
    return metal::mix(_e68, mean, _e71);
}

MarkPlace mark_place_object(
    float angle_1,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float _e5 = bounded(anchor.z);
    float size_1 = metal::clamp(_e5, 0.000001, 1000000.0);
    metal::float2 _e9 = place_in_picture(pixel_1, viewport_2);
    metal::float2 _e15 = bounded_vec2_(_e9 - metal::float2(anchor.x, -(anchor.y)));
    metal::float2 place_4 = _e15 / metal::float2(size_1);
    StretchedPlace _e28 = mark_place_of(place_4, metal::float3(1.0 / size_1, 0.0, 0.0), metal::float3(0.0, 1.0 / size_1, 0.0), angle_1);
    return MarkPlace {_e28.place, {}, _e28.stretch};
}

float stippling(
    float value,
    metal::float2 place_3,
    metal::float3 stretch_4,
    float count_1,
    float size,
    float scatter,
    int seed_2,
    metal::float2 viewport_3
) {
    float _e8 = bounded(size);
    float _e12 = bounded(scatter);
    Dots style_2 = Dots {metal::clamp(_e8, 0.0, 1.4), metal::clamp(_e12, 0.0, 1.0), as_type<uint>(seed_2)};
    SpacedPlace _e18 = spaced(place_3, stretch_4, viewport_3, count_1);
    float _e20 = factor_of(value, true);
    float _e23 = stippled(_e18, 1.0 - _e20, style_2);
    return _e23;
}

float reflectance_wrap(
    Light light,
    metal::float3 normal_1,
    float wrap
) {
    float _e3 = bounded(wrap);
    float w_2 = metal::clamp(_e3, 0.0, 1.0);
    metal::float3 _e11 = normalize_or(normal_1, metal::float3(0.0, 0.0, 1.0));
    float cosine = metal::dot(_e11, light.direction);
    return metal::max((cosine + w_2) / (1.0 + w_2), 0.0);
}

float map_range(
    float value_1,
    float from_low_1,
    float from_high_1,
    float to_low_1,
    float to_high_1,
    bool clamped_2
) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(
    float a_4,
    float b_4
) {
    float _e3 = bounded(a_4 * b_4);
    return _e3;
}

metal::float4 shade(
    Surface surface_1,
    constant Look& look
) {
    Light _e3 = look.key;
    float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.3);
    float _e9 = facing(surface_1.normal, surface_1.view);
    float _e15 = map_range(_e9, 0.0, 0.55, 0.0, 1.0, true);
    float _e16 = multiply(_e6, _e15);
    float _e22 = map_range(_e16, 0.0, 0.85, 0.0, 1.0, true);
    metal::float2 _e28 = look.viewport;
    MarkPlace _e29 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e28);
    metal::float2 _e38 = look.viewport;
    float _e39 = stippling(_e22, _e29.place, _e29.stretch, 210.0, 0.85, 0.8, 0, _e38);
    Color _e50 = mix_colors_normal(metal::float4(0.965, 0.95, 0.915, 1.0), metal::float4(0.09, 0.12, 0.22, 1.0), _e39);
    Composite _e51 = premultiplied(_e50);
    Color _e52 = output(_e51);
    return _e52;
}

struct vs_mainInput {
    metal::float3 position [[attribute(0)]];
    metal::float3 normal_2 [[attribute(1)]];
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
    const Vertex vertex_ = { varyings.position, varyings.normal_2 };
    Varyings out = {};
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e12 = view_1.clip_from_world;
    out.clip = _e12 * world;
    out.position = world.xyz;
    metal::float3x3 _e19 = object.world_from_normal;
    out.normal = _e19 * vertex_.normal;
    Varyings _e22 = out;
    const auto _tmp = _e22;
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 normal_2 [[user(loc1), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal_2 };
    Surface surface = {};
    metal::float3 _e7 = normalize_or(in.normal, metal::float3(0.0, 0.0, 1.0));
    metal::float3 normal_2 = is_front ? _e7 : -(_e7);
    surface.normal = normal_2;
    metal::float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    metal::float4 _e26 = view_1.eye;
    metal::float3 _e32 = normalize_or(_e26.xyz, metal::float3(0.0, 0.0, 1.0));
    metal::float3 _e33 = normalize_or(_e15.xyz - (_e20 * in.position), _e32);
    surface.view = _e33;
    metal::float4 _e39 = view_1.screen;
    metal::float4 _e44 = view_1.screen;
    surface.pixel = (in.clip.xy * _e39.xy) + _e44.zw;
    metal::float4x4 _e50 = view_1.camera_from_world;
    metal::float4 _e54 = object.world_from_object[3];
    float _e63 = view_1.eye.w;
    float _e68 = view_1.clip_from_world[0].y;
    float _e73 = view_1.clip_from_world[1].y;
    float _e78 = view_1.clip_from_world[2].y;
    metal::float3 _e81 = anchor_on_screen((_e50 * metal::float4(_e54.xyz, 1.0)).xyz, _e63, metal::length(metal::float3(_e68, _e73, _e78)));
    surface.anchor = _e81;
    Surface _e82 = surface;
    metal::float4 _e83 = shade(_e82, look);
    metal::float4 _e84 = finite_vec4_(_e83);
    return fs_mainOutput { _e84 };
}
