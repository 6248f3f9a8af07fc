// Botanical plate: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_1 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0).
// botanical-plate.json says what to put there and how to draw.
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
    metal::packed_float3 position_object;
    float kappa;
    metal::float2 pixel;
    char _pad5[8];
    metal::float3 anchor;
};
typedef metal::float4 Color;
struct type_7 {
    metal::float4 inner[16];
};
struct type_8 {
    metal::float4 inner[4];
};
struct Ramp {
    type_7 colors;
    type_8 places;
    uint count;
    uint interpolation;
    char _pad4[8];
};
struct type_13 {
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
struct VectorParts {
    float x;
    float y;
    float z;
};
struct Vertex {
    metal::float3 position;
    metal::float3 normal;
};
struct Varyings {
    metal::float4 clip;
    metal::float3 position;
    metal::float3 position_object;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant uint NOISE_PERLIN = 1u;
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant type_13 BLUE_TILE = type_13 {{667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u}};
constant Ramp leaf_to_bloom = Ramp {type_7 {{metal::float4(0.4353, 0.5412, 0.2353, 1.0), metal::float4(0.6235, 0.7098, 0.3961, 1.0), metal::float4(0.9098, 0.7255, 0.6275, 1.0), metal::float4(0.8471, 0.3765, 0.4784, 1.0), metal::float4(0.6588, 0.2275, 0.4, 1.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0), metal::float4(0.0)}}, type_8 {{metal::float4(0.0, 0.35, 0.6, 0.85), metal::float4(1.0, 0.0, 0.0, 0.0), metal::float4(0.0), metal::float4(0.0)}}, 5u, 1u};

metal::float4 finite_vec4_(
    metal::float4 v
) {
    metal::uint4 exponent = metal::uint4(2139095040u);
    return metal::select(metal::float4(0.0), v, (as_type<metal::uint4>(v) & exponent) != exponent);
}

int naga_f2i32(float value) {
    return static_cast<int>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(
    float x
) {
    float whole = metal::rint(x);
    float f = x - whole;
    float twice = 2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724)))))))))));
    return twice * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(naga_f2i32(whole)) + as_type<uint>(126))) << 23u);
}

float log2_stable(
    float x_1
) {
    uint bits = as_type<uint>(x_1);
    int exponent_1 = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent_1) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
}

metal::float3 normalize_moderate(
    metal::float3 v_1,
    metal::float3 otherwise
) {
    float square = metal::dot(v_1, v_1);
    return (square > 0.000000000000000000000000000001) ? (v_1 * metal::rsqrt(metal::max(square, 0.000000000000000000000000000001))) : otherwise;
}

metal::float3 normalize_seen(
    metal::float3 v_2
) {
    metal::float3 _e5 = normalize_moderate(v_2, metal::float3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(
    float x_2
) {
    uint bits_1 = as_type<uint>(x_2);
    uint magnitude = bits_1 & 2147483647u;
    float largest = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0);
}

metal::float3 bounded_vec3_(
    metal::float3 v_3
) {
    metal::uint3 bits_2 = as_type<metal::uint3>(v_3);
    metal::uint3 magnitude_1 = bits_2 & metal::uint3(2147483647u);
    metal::float3 largest_1 = as_type<metal::float3>((bits_2 & metal::uint3(2147483648u)) | metal::uint3(2139095039u));
    metal::float3 numbers = metal::select(metal::float3(0.0), largest_1, magnitude_1 == metal::uint3(2139095040u));
    return metal::select(numbers, v_3, magnitude_1 < metal::uint3(2139095040u));
}

metal::float4 bounded_vec4_(
    metal::float4 v_4
) {
    metal::uint4 bits_3 = as_type<metal::uint4>(v_4);
    metal::uint4 magnitude_2 = bits_3 & metal::uint4(2147483647u);
    metal::float4 largest_2 = as_type<metal::float4>((bits_3 & metal::uint4(2147483648u)) | metal::uint4(2139095039u));
    metal::float4 numbers_1 = metal::select(metal::float4(0.0), largest_2, magnitude_2 == metal::uint4(2139095040u));
    return metal::select(numbers_1, v_4, magnitude_2 < metal::uint4(2139095040u));
}

float divided(
    float a,
    float b
) {
    if (metal::abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    float _e7 = bounded(a / b);
    return _e7;
}

metal::float3 mixed_vec3_(
    metal::float3 a_1,
    metal::float3 b_1,
    float t
) {
    metal::float3 d_2 = b_1 - a_1;
    metal::float3 _e13 = bounded_vec3_((t < 0.5) ? (a_1 + (t * d_2)) : (b_1 - ((1.0 - t) * d_2)));
    return _e13;
}

metal::float4 mixed_vec4_(
    metal::float4 a_2,
    metal::float4 b_2,
    float t_1
) {
    metal::float4 _e4 = bounded_vec4_(b_2 - a_2);
    metal::float4 _e14 = bounded_vec4_((t_1 < 0.5) ? (a_2 + (t_1 * _e4)) : (b_2 - ((1.0 - t_1) * _e4)));
    return _e14;
}

float eased(
    float x_3,
    float low,
    float high
) {
    float _e3 = bounded(x_3);
    float _e7 = bounded((_e3 - low) / 0.5);
    float t_4 = metal::clamp(_e7, 0.0, 1.0);
    return (t_4 * t_4) * (3.0 - (2.0 * t_4));
}

float eased_2_(
    float x_4,
    float low_1,
    float high_1
) {
    float _e3 = bounded(x_4);
    float _e7 = bounded((_e3 - low_1) / 0.75);
    float t_5 = metal::clamp(_e7, 0.0, 1.0);
    return (t_5 * t_5) * (3.0 - (2.0 * t_5));
}

float eased_3_(
    float x_5,
    float low_2,
    float high_2
) {
    float t_6 = metal::clamp((x_5 - low_2) / (high_2 - low_2), 0.0, 1.0);
    return (t_6 * t_6) * (3.0 - (2.0 * t_6));
}

float footprint_of(
    float x_6
) {
    float _e1 = metal::dfdx(x_6);
    float _e2 = metal::dfdy(x_6);
    metal::float2 d_3 = metal::float2(_e1, _e2);
    return metal::sqrt(metal::dot(d_3, d_3));
}

float footprint_of_vec3_(
    metal::float3 v_5
) {
    metal::float3 dx = metal::dfdx(v_5);
    metal::float3 dy = metal::dfdy(v_5);
    float _e7 = bounded(metal::sqrt(metal::max(metal::dot(dx, dx), metal::dot(dy, dy))));
    return _e7;
}

metal::float4 hermite(
    metal::float4 a_3,
    metal::float4 b_3,
    metal::float4 from_a,
    metal::float4 to_b,
    float t_2
) {
    metal::float4 d_4 = b_3 - a_3;
    return a_3 + (t_2 * (from_a + (t_2 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_2 * ((from_a + to_b) - (2.0 * d_4)))))));
}

float harmonic_slope(
    float before,
    float span_before,
    float after,
    float span_after
) {
    if ((before * after) <= 0.0) {
        return 0.0;
    }
    float weight_before = (2.0 * span_after) + span_before;
    float weight_after = span_after + (2.0 * span_before);
    float _e18 = divided(weight_before + weight_after, (weight_before / before) + (weight_after / after));
    return _e18;
}

metal::float4 ramp_slope(
    metal::float4 rise_before,
    float span_before_1,
    metal::float4 rise_after,
    float span_after_1
) {
    float _e5 = divided(rise_before.x, span_before_1);
    float _e7 = divided(rise_after.x, span_after_1);
    float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    float _e10 = divided(rise_before.y, span_before_1);
    float _e12 = divided(rise_after.y, span_after_1);
    float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    float _e15 = divided(rise_before.z, span_before_1);
    float _e17 = divided(rise_after.z, span_after_1);
    float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    float _e20 = divided(rise_before.w, span_before_1);
    float _e22 = divided(rise_after.w, span_after_1);
    float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return metal::float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % metal::select(rhs, 1u, rhs == 0u);
}

Color ramp_at(
    Ramp ramp,
    float x_7,
    float w
) {
    type_7 colors = {};
    type_8 places = {};
    uint i_2_ = 1u;
    uint at = 0u;
    metal::float4 from_a_1 = metal::float4(0.0);
    metal::float4 to_b_1 = metal::float4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e28 = i_2_;
            i_2_ = _e28 + 1u;
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 5u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places.inner[naga_div(_e17, 4u)][naga_mod(_e21, 4u)];
        at = (_e25 <= x_7) ? _e16 : _e15;
    }
    uint _e31 = at;
    uint _e35 = at;
    float place_3 = places.inner[naga_div(_e31, 4u)][naga_mod(_e35, 4u)];
    uint _e40 = at;
    if (((_e40 + 1u) >= 5u) | (x_7 <= place_3)) {
        uint _e47 = at;
        metal::float4 _e49 = colors.inner[_e47];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = _e50 + 1u;
    float _e59 = places.inner[naga_div(after_1, 4u)][naga_mod(after_1, 4u)];
    float span = _e59 - place_3;
    float _e62 = divided(x_7 - place_3, span);
    float t_7 = metal::clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if (_e69 > 0u) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places.inner[naga_div(_e72 - 1u, 4u)][naga_mod(_e78 - 1u, 4u)];
        uint _e85 = at;
        metal::float4 _e87 = colors.inner[_e85];
        uint _e88 = at;
        metal::float4 _e92 = colors.inner[_e88 - 1u];
        metal::float4 _e96 = colors.inner[after_1];
        uint _e97 = at;
        metal::float4 _e99 = colors.inner[_e97];
        metal::float4 _e101 = ramp_slope(_e87 - _e92, place_3 - before_1, _e96 - _e99, span);
        from_a_1 = _e101;
    }
    if ((after_1 + 1u) < 5u) {
        float _e119 = places.inner[naga_div(after_1 + 1u, 4u)][naga_mod(after_1 + 1u, 4u)];
        float next = _e119 - (place_3 + span);
        metal::float4 _e123 = colors.inner[after_1];
        uint _e124 = at;
        metal::float4 _e126 = colors.inner[_e124];
        metal::float4 _e131 = colors.inner[after_1 + 1u];
        metal::float4 _e133 = colors.inner[after_1];
        metal::float4 _e135 = ramp_slope(_e123 - _e126, span, _e131 - _e133, next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    metal::float4 _e138 = colors.inner[_e136];
    metal::float4 _e140 = colors.inner[after_1];
    metal::float4 _e141 = from_a_1;
    metal::float4 _e143 = to_b_1;
    metal::float4 _e145 = hermite(_e138, _e140, span * _e141, span * _e143, t_7);
    metal::float4 _e146 = bounded_vec4_(_e145);
    return _e146;
}

Color mix_colors_multiply(
    Color a_4,
    Color b_4,
    float factor
) {
    metal::float3 _e7 = mixed_vec3_(a_4.xyz, a_4.xyz * b_4.xyz, factor);
    return metal::float4(_e7, 1.0);
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

metal::uint3 lattice_hash(
    metal::int3 cell,
    uint seed_1
) {
    metal::uint3 _e9 = hash_pcg3d(as_type<metal::uint3>(cell) + (seed_1 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    return _e9;
}

float gradient_dot(
    metal::uint3 hash,
    metal::float3 d
) {
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a_5 = (axis == 0u) ? d.y : d.x;
    float b_5 = (axis == 2u) ? d.y : d.z;
    return (((hash.y >> 31u) == 0u) ? a_5 : -(a_5)) + (((hash.z >> 31u) == 0u) ? b_5 : -(b_5));
}

metal::float3 fade_quintic(
    metal::float3 t_3
) {
    return ((t_3 * t_3) * t_3) * ((t_3 * ((t_3 * 6.0) - metal::float3(15.0))) + metal::float3(10.0));
}

metal::int3 naga_f2i32(metal::float3 value) {
    return static_cast<metal::int3>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(
    metal::float3 p,
    uint seed_2
) {
    float sum = 0.0;
    int i = 0;
    metal::float3 corner = metal::floor(p);
    metal::float3 d_5 = p - corner;
    metal::float3 _e4 = fade_quintic(d_5);
    metal::int3 cell_2 = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (metal::all(loop_bound_1 == uint2(0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i;
            i = as_type<int>(as_type<uint>(_e46) + as_type<uint>(1));
        }
        loop_init_1 = false;
        int _e10 = i;
        if (_e10 < 8) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            metal::int3 at_2 = metal::int3(_e13 & 1, (_e16 >> 1u) & 1, _e21 >> 2u);
            metal::float3 weight = metal::select(metal::float3(1.0) - _e4, _e4, at_2 == metal::int3(1));
            float _e32 = sum;
            metal::uint3 _e39 = lattice_hash(as_type<metal::int3>(as_type<metal::uint3>(cell_2) + as_type<metal::uint3>(at_2)), seed_2);
            float _e42 = gradient_dot(_e39, d_5 - static_cast<metal::float3>(at_2));
            sum = _e32 + (((weight.x * weight.y) * weight.z) * _e42);
        }
    }
    float _e48 = sum;
    return metal::clamp(0.5 + (0.48244 * _e48), 0.0, 1.0);
}

float fractal_noise(
    uint kind,
    metal::float3 p_1,
    int octaves,
    float roughness,
    int seed_3,
    float w_1
) {
    float octave = {};
    int i_1 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e66 = i_1;
            i_1 = as_type<int>(as_type<uint>(_e66) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e17 = i_1;
        if (!((_e17 < 3))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased(w_1 * _e21, 0.5, 1.0);
        float visible = 1.0 - _e25;
        octave = 0.5;
        if (visible > 0.0) {
            float _e31 = frequency;
            int _e33 = i_1;
            metal::float3 place_4 = metal::clamp((p_1 * _e31) + (static_cast<float>(_e33) * metal::float3(17.31, 5.17, 11.73)), metal::float3(-4194304.0), metal::float3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_4, 0u + static_cast<uint>(_e47));
            octave = metal::mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = _e53 + (_e54 * _e55);
        float _e58 = total;
        float _e59 = strength;
        total = _e58 + _e59;
        float _e61 = strength;
        strength = _e61 * roughness;
        float _e63 = frequency;
        frequency = _e63 * 2.0;
    }
    float _e69 = sum_1;
    return metal::min(_e69 / 1.75, 1.0);
}

float size_on_screen(
    float depth,
    float perspective,
    float scale
) {
    return metal::min((0.5 * scale) / metal::mix(1.0, metal::max(depth, 0.000001), perspective), MOST_ON_SCREEN);
}

metal::float3 anchor_on_screen(
    metal::float3 origin,
    float perspective_1,
    float scale_1
) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return metal::clamp(metal::float3(origin.x * _e5, -(origin.y) * _e5, _e5), metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
}

metal::float2 place_in_picture(
    metal::float2 pixel,
    metal::float2 viewport
) {
    metal::float2 from_middle = pixel - (0.5 * viewport);
    return metal::float2(from_middle.x, -(from_middle.y)) / metal::float2(metal::max(viewport.y, 1.0));
}

float disk_filtered(
    float d_1,
    float r,
    float w_2
) {
    if (w_2 < 0.000000000000000000000000000001) {
        return ((d_1 <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    float square_1 = r * r;
    float least = (w_2 * w_2) / 3.0;
    float inner = metal::sqrt(metal::max(square_1, least) - (0.25 * least));
    return metal::clamp(0.5 + ((inner - d_1) / w_2), 0.0, 1.0) * metal::min(square_1 / least, 1.0);
}

uint blue_index(
    metal::int2 cell_1
) {
    metal::uint2 at_3 = as_type<metal::uint2>(cell_1) & metal::uint2(31u);
    return (8u * at_3.y) + (at_3.x >> 2u);
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(0.0, 1.0);
    metal::float3 x_8 = (turn.y * along) + (turn.x * across);
    metal::float3 y = (turn.y * across) - (turn.x * along);
    metal::float2 turned = metal::float2((turn.y * place.x) + (turn.x * place.y), (turn.y * place.y) - (turn.x * place.x));
    metal::float3 stretch_4 = metal::float3(metal::dot(x_8, x_8), metal::dot(x_8, y), metal::dot(y, y));
    return StretchedPlace {turned, {}, stretch_4};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_3 = is_pixel ? (count / metal::max(viewport_1.y, 1.0)) : count;
    metal::float2 p_2 = metal::clamp(place_1 * scale_3, metal::float2(-4194304.0), metal::float2(4194304.0));
    return SpacedPlace {p_2, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_3 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_3 * sum_3) / 66.0);
}

float picture_square(
    metal::float2 offset,
    metal::float3 stretch_2
) {
    float _e2 = area_square(stretch_2);
    float area = metal::max(_e2, 0.000000000000000000000000000001);
    float square_2 = (((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y);
    return metal::max(square_2, 0.0) / area;
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

float dots_of_octave(
    metal::float2 place_2,
    int zoom,
    float ink,
    metal::float3 stretch_3,
    float w_3,
    Dots style
) {
    int i_2 = 0;
    float sum_2 = 0.0;
    type_13 tile = BLUE_TILE;
    metal::float2 p_3 = metal::clamp(place_2 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom) + as_type<uint>(127))) << 23u), metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float2 corner_1 = metal::floor(p_3);
    float reach = 1.0 - (0.5 * style.scatter);
    uint2 loop_bound_3 = uint2(4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (metal::all(loop_bound_3 == uint2(0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e118 = i_2;
            i_2 = as_type<int>(as_type<uint>(_e118) + as_type<uint>(1));
        }
        loop_init_3 = false;
        int _e30 = i_2;
        if (!((_e30 < 9))) {
            break;
        }
        int _e35 = i_2;
        int _e40 = i_2;
        metal::int2 cell_3 = as_type<metal::int2>(as_type<metal::uint2>(naga_f2i32(corner_1)) + as_type<metal::uint2>(metal::int2(as_type<int>(as_type<uint>(naga_mod(_e35, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e40, 3)) - as_type<uint>(1)))));
        metal::uint3 _e54 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_3, zoom)) + metal::uint3(0u, 0u, 0u));
        metal::float3 chance = static_cast<metal::float3>(_e54 >> metal::uint3(8u)) * 0.000000059604645;
        metal::float2 middle = (static_cast<metal::float2>(cell_3) + metal::float2(0.5)) + (style.scatter * (chance.xy - metal::float2(0.5)));
        metal::float2 offset_1 = p_3 - middle;
        metal::int2 turning = as_type<metal::int2>(as_type<metal::uint2>(cell_3) + as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(zoom) * as_type<uint>(7)))));
        uint _e78 = blue_index(turning);
        uint _e80 = tile.inner[_e78];
        float turn_1 = 0.96875 * ((static_cast<float>((_e80 >> (8u * (as_type<uint>(turning.x) & 3u))) & 255u) + 0.5) * 0.00390625);
        float grown = metal::clamp((ink - turn_1) * 32.0, 0.0, 1.0);
        float radius = (0.5 * style.size) * metal::sqrt(grown);
        float far = metal::length(offset_1) / reach;
        float _e110 = picture_square(offset_1, stretch_3);
        float d_6 = metal::max(metal::sqrt(_e110), (far * far) * radius);
        float _e115 = sum_2;
        float _e116 = disk_filtered(d_6, radius, w_3);
        sum_2 = metal::max(_e115, _e116);
    }
    float _e121 = sum_2;
    return _e121;
}

float stippled(
    SpacedPlace at_1,
    float ink_1,
    Dots style_1
) {
    float dots = {};
    metal::float2 dx_1 = metal::dfdx(at_1.place);
    metal::float2 dy_1 = metal::dfdy(at_1.place);
    float _e8 = picture_square(dx_1, at_1.stretch);
    float _e10 = picture_square(dy_1, at_1.stretch);
    float _e13 = bounded(metal::sqrt(metal::max(_e8, _e10)));
    float _e15 = area_square(at_1.stretch);
    float _e19 = log2_stable(metal::max(metal::sqrt(_e15), 0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * _e19, -16.0, 16.0);
    float zoom_1 = metal::floor(level);
    float f_1 = level - zoom_1;
    float _e29 = exp2_stable(-2.0 * f_1);
    float coarse = 1.0 - f_1;
    float fine = (1.0 - (coarse * _e29)) / (4.0 * _e29);
    float _e44 = exp2_stable(2.0 * zoom_1);
    float _e46 = dots_of_octave(at_1.place, naga_f2i32(zoom_1), ink_1 * coarse, at_1.stretch * _e44, _e13, style_1);
    dots = _e46;
    if (fine > 0.0) {
        float _e60 = exp2_stable((2.0 * zoom_1) + 2.0);
        float _e62 = dots_of_octave(at_1.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), ink_1 * fine, at_1.stretch * _e60, _e13, style_1);
        float _e63 = dots;
        dots = metal::max(_e63, _e62);
    }
    float mean = ink_1 * ((0.7853982 * style_1.size) * style_1.size);
    float _e71 = dots;
    float _e74 = eased_2_(_e13, 0.75, 1.5);
    return metal::mix(_e71, mean, _e74);
}

MarkPlace mark_place_object(
    float angle_1,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_2
) {
    float size = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 _e8 = place_in_picture(pixel_1, viewport_2);
    metal::float2 place_5 = (_e8 - metal::float2(anchor.x, -(anchor.y))) / metal::float2(size);
    StretchedPlace _e26 = mark_place_of(place_5, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_1);
    return MarkPlace {_e26.place, {}, _e26.stretch};
}

float outer_contour(
    float width,
    metal::float3 normal,
    metal::float3 view,
    metal::float2 viewport_3
) {
    float facing = metal::clamp(metal::dot(normal, view), 0.0, 1.0);
    float pixels = (width * metal::clamp(viewport_3.y, 1.0, 100000.0)) / 1000.0;
    float _e15 = footprint_of(facing);
    float distance = facing / metal::max(2.0 * _e15, 0.000001);
    float near = 1.0 - metal::smoothstep(0.45, 0.75, facing);
    return metal::clamp((pixels + 0.5) - distance, 0.0, metal::min(pixels, 1.0)) * near;
}

float noise_perlin(
    metal::float3 position,
    float scale_2,
    int octaves_1,
    float roughness_1,
    int seed_4
) {
    metal::float3 p_4 = position * scale_2;
    float _e7 = footprint_of_vec3_(p_4);
    float _e8 = fractal_noise(NOISE_PERLIN, p_4, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 where_2_ = surface.position_object;
    VectorParts parts = VectorParts {surface.position_object[0], surface.position_object[1], surface.position_object[2]};
    float _e11 = noise_perlin(surface.position_object, 4.0, 3, 0.5, 0);
    float height_mottled = parts.y + metal::mix(-0.35, 0.35, _e11 - 0.0);
    float share = metal::clamp((height_mottled + 0.9) / 1.85, 0.0, 1.0);
    float _e27 = footprint_of(share);
    Color _e28 = ramp_at(leaf_to_bloom, share, _e27);
    metal::float3 _e33 = look.key.direction;
    float shade_2_ = metal::max((metal::dot(surface.normal, _e33) + 0.3) / 1.3, 0.0);
    float tone = metal::mix(0.02, 1.0, metal::min((shade_2_ - 0.0) / 0.8, 1.0));
    float short_of_the_light = metal::mix(0.85, 0.12, metal::clamp((tone - 0.55) / 0.4, 0.0, 1.0));
    Color _e65 = mix_colors_multiply(metal::float4(0.9725, 0.949, 0.8863, 1.0), _e28, short_of_the_light);
    float facing_1 = metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0);
    float turning_away = metal::mix(0.2, 1.0, metal::clamp((facing_1 - 0.05) / 0.55, 0.0, 1.0));
    float engraved_tone = tone * turning_away;
    metal::float2 _e88 = look.viewport;
    MarkPlace _e89 = mark_place_object(0.0, surface.anchor, surface.pixel, _e88);
    metal::float2 _e94 = look.viewport;
    SpacedPlace _e96 = spaced(_e89.place, _e89.stretch, _e94, 230.0);
    float _e105 = stippled(_e96, 1.0 - metal::min(engraved_tone, 1.0), Dots {0.72, 0.8, 0u});
    metal::float2 _e111 = look.viewport;
    float _e112 = outer_contour(2.0, surface.normal, surface.view, _e111);
    float curvature = surface.kappa;
    float hollow = 0.5 + (0.5 * (1.0 - (2.0 / (1.0 + metal::exp2(2.88539 * metal::clamp(curvature * 0.25, -20.0, 20.0))))));
    float _e134 = eased_3_(hollow, 0.24, 0.16);
    float ink_2 = metal::max(metal::max(_e105, _e112), _e134);
    metal::float4 _e137 = bounded_vec4_(_e65);
    metal::float4 _e143 = mixed_vec4_(_e137, metal::float4(0.1725, 0.1412, 0.1216, 1.0), ink_2);
    metal::float4 _e144 = finite_vec4_(_e143);
    return _e144;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_1 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_1 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_1 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_1.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal_1 [[user(loc2), center_perspective]];
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
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object, varyings_1.normal_1 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_1 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    metal::float4 _e24 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e30 = view_1.screen;
    metal::float4 _e35 = view_1.screen;
    metal::float4x4 _e40 = view_1.camera_from_world;
    metal::float4 _e44 = object.world_from_object[3];
    float _e53 = view_1.eye.w;
    float _e58 = view_1.clip_from_world[0].y;
    float _e63 = view_1.clip_from_world[1].y;
    float _e68 = view_1.clip_from_world[2].y;
    metal::float3 _e71 = anchor_on_screen((_e40 * metal::float4(_e44.xyz, 1.0)).xyz, _e53, metal::length(metal::float3(_e58, _e63, _e68)));
    Surface surface_1 = Surface {normal_1, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, _e24.x, (in.clip.xy * _e30.xy) + _e35.zw, {}, _e71};
    metal::float4 _e73 = shade(surface_1, look);
    metal::float4 _e74 = finite_vec4_(_e73);
    return fs_mainOutput { _e74 };
}
