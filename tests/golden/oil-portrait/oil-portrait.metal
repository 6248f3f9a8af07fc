// Oil portrait: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view_4 buffer(0), object buffer(1), look buffer(2), curvature_map texture(0), smooth_normal_1_map texture(1), smooth_normal_3_map texture(2).
// oil-portrait.json says what to put there and how to draw.
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
    metal::float4 toned_canvas;
    metal::float2 viewport;
    char _pad2[8];
    metal::float4 accents_as_paint_b;
    Light sky;
    metal::float4 cool_reflections_as_paint_b;
    Light key;
    metal::float4 thick_lights_as_paint_b;
    metal::float4 light_as_paint_b;
    metal::float4 half_tones_as_paint_b;
    metal::float4 umber_as_paint_b;
};
struct Surface {
    metal::float3 normal;
    metal::float3 view;
    metal::packed_float3 position_object;
    float kappa;
    metal::float3 smooth_normal_1_;
    metal::float3 smooth_normal_3_;
    metal::float2 pixel;
    char _pad7[8];
    metal::packed_float3 anchor;
    float magnification;
    metal::float3x3 world_from_normal;
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
struct Brush {
    float aspect;
    float size;
    float scatter;
    float turn;
    uint seed;
    bool is_dark;
    char _pad6[3];
};
struct Brushstroke {
    metal::float2 uv;
    metal::float2 turn;
    float way;
    float share;
};
struct BrushStrokes {
    Color color;
    float ink;
    char _pad2[12];
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
    metal::float3 position_object;
    metal::float3 normal;
};
constant float SMALLEST_NORMAL = 0.000000000000000000000000000000000000011754944;
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant type_11 BLUE_TILE = type_11 {{667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u}};

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

metal::float2 sin_cos_eighth(
    float x_2
) {
    float s = x_2 * 0.9088517;
    return metal::float2(s, 0.73168886);
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
    float x_3
) {
    uint bits_1 = as_type<uint>(x_3);
    uint magnitude = bits_1 & 2147483647u;
    float largest = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0);
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

metal::float4 mixed_vec4_(
    metal::float4 a,
    metal::float4 b,
    float t
) {
    metal::float4 _e4 = bounded_vec4_(b - a);
    metal::float4 _e14 = bounded_vec4_((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4)));
    return _e14;
}

float place_between(
    float x_4,
    float low,
    float high
) {
    float span = high - low;
    if (metal::abs(span) < SMALLEST_NORMAL) {
        return (x_4 >= high) ? 1.0 : 0.0;
    }
    float _e13 = bounded((x_4 - low) / span);
    return _e13;
}

float eased(
    float x_5,
    float low_1,
    float high_1
) {
    float _e3 = place_between(x_5, low_1, high_1);
    float t_1 = metal::clamp(_e3, 0.0, 1.0);
    return (t_1 * t_1) * (3.0 - (2.0 * t_1));
}

metal::float4 color_mixed(
    metal::float4 a_1,
    metal::float3 blended,
    float factor
) {
    metal::float3 _e3 = bounded_vec3_(blended);
    metal::float3 _e6 = bounded_vec3_(_e3 - a_1.xyz);
    metal::float3 _e10 = bounded_vec3_(_e3 - (0.0 * _e6));
    return metal::float4(_e10, 1.0);
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
    Color a_2,
    Color b_1,
    float factor_1
) {
    metal::float4 _e3 = bounded_vec4_(a_2);
    metal::float4 _e4 = bounded_vec4_(b_1);
    metal::float4 _e8 = mixed_vec4_(_e3, _e4, metal::clamp(factor_1, 0.0, 1.0));
    return _e8;
}

metal::float3x3 axes_around(
    metal::float3 toward,
    metal::float3 up
) {
    metal::float3 z_1 = toward * metal::rsqrt(metal::dot(toward, toward));
    metal::float3 leaning = metal::cross(up, z_1);
    float square_1 = metal::dot(leaning, leaning);
    metal::float3 aside = (metal::abs(z_1.x) > 0.7) ? metal::float3(0.0, 0.0, 1.0) : metal::float3(1.0, 0.0, 0.0);
    metal::float3 across_3 = (square_1 > 0.00000001) ? leaning : metal::cross(aside, z_1);
    metal::float3 _e31 = normalize_moderate(across_3 - (metal::dot(across_3, z_1) * z_1), metal::float3(1.0, 0.0, 0.0));
    return metal::float3x3(_e31, metal::cross(z_1, _e31), z_1);
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
    metal::uint3 v_5 = {};
    v_5 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_5.x;
    uint _e10 = v_5.y;
    uint _e12 = v_5.z;
    v_5.x = _e8 + (_e10 * _e12);
    uint _e16 = v_5.y;
    uint _e18 = v_5.z;
    uint _e20 = v_5.x;
    v_5.y = _e16 + (_e18 * _e20);
    uint _e24 = v_5.z;
    uint _e26 = v_5.x;
    uint _e28 = v_5.y;
    v_5.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_5;
    metal::uint3 _e32 = v_5;
    v_5 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_5.x;
    uint _e40 = v_5.y;
    uint _e42 = v_5.z;
    v_5.x = _e38 + (_e40 * _e42);
    uint _e46 = v_5.y;
    uint _e48 = v_5.z;
    uint _e50 = v_5.x;
    v_5.y = _e46 + (_e48 * _e50);
    uint _e54 = v_5.z;
    uint _e56 = v_5.x;
    uint _e58 = v_5.y;
    v_5.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_5;
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

uint blue_index(
    metal::int2 cell_1
) {
    metal::uint2 at_6 = as_type<metal::uint2>(cell_1) & metal::uint2(31u);
    return (8u * at_6.y) + (at_6.x >> 2u);
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn_6 = metal::float2(0.0, 1.0);
    metal::float3 _e12 = bounded_vec3_((turn_6.y * along) + (turn_6.x * across));
    metal::float3 _e18 = bounded_vec3_((turn_6.y * across) - (turn_6.x * along));
    metal::float2 turned = metal::float2((turn_6.y * place.x) + (turn_6.x * place.y), (turn_6.y * place.y) - (turn_6.x * place.x));
    metal::float3 most = metal::float3(1000000000000000.0);
    metal::float3 stretch_9 = metal::clamp(metal::float3(metal::dot(_e12, _e12), metal::dot(_e12, _e18), metal::dot(_e18, _e18)), -(most), most);
    return StretchedPlace {turned, {}, stretch_9};
}

StretchedPlace mark_place_of_2_(
    metal::float2 place_1,
    metal::float3 along_1,
    metal::float3 across_1,
    float angle_1
) {
    metal::float2 _e5 = sin_cos_eighth(0.75);
    metal::float2 turn_7 = metal::clamp(_e5, metal::float2(-1.0), metal::float2(1.0));
    metal::float3 x_6 = (turn_7.y * along_1) + (turn_7.x * across_1);
    metal::float3 y = (turn_7.y * across_1) - (turn_7.x * along_1);
    metal::float2 turned_1 = metal::float2((turn_7.y * place_1.x) + (turn_7.x * place_1.y), (turn_7.y * place_1.y) - (turn_7.x * place_1.x));
    metal::float3 stretch_10 = metal::float3(metal::dot(x_6, x_6), metal::dot(x_6, y), metal::dot(y, y));
    return StretchedPlace {turned_1, {}, stretch_10};
}

metal::float3 gradient_on_picture(
    metal::float3 g,
    metal::float3 normal,
    metal::float3 view
) {
    float facing = metal::dot(normal, view);
    return g - (normal * (metal::dot(g, view) / ((facing >= 0.0) ? metal::max(facing, 0.125) : metal::min(facing, -0.125))));
}

StretchedPlace place_on_surface(
    metal::float2 place_2,
    metal::float3 along_2,
    metal::float3 across_2,
    metal::float3 normal_1,
    metal::float3 view_1,
    float magnification,
    float angle_2
) {
    float height = 1.0 / metal::clamp(magnification, 0.000000000000001, 1000000000000000.0);
    metal::float3 _e12 = gradient_on_picture(along_2, normal_1, view_1);
    metal::float3 _e14 = bounded_vec3_(_e12 * height);
    metal::float3 _e15 = gradient_on_picture(across_2, normal_1, view_1);
    metal::float3 _e17 = bounded_vec3_(_e15 * height);
    StretchedPlace _e18 = mark_place_of(place_2, _e14, _e17, angle_2);
    return _e18;
}

StretchedPlace place_across(
    metal::float3 axis,
    metal::float3 position,
    metal::float3x3 world_from_normal,
    metal::float3 normal_2,
    metal::float3 view_2,
    float magnification_1,
    float angle_3
) {
    metal::float3x3 _e11 = axes_around(axis, metal::float3(0.0, 1.0, 0.0));
    metal::float2 place_11 = metal::float2(metal::dot(position, _e11[0]), metal::dot(position, _e11[2]));
    metal::float3 along_3 = world_from_normal * _e11[0];
    metal::float3 across_4 = world_from_normal * _e11[2];
    StretchedPlace _e21 = place_on_surface(place_11, along_3, across_4, normal_2, view_2, magnification_1, angle_3);
    return _e21;
}

SpacedPlace spaced(
    metal::float2 place_3,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = is_pixel ? (count / metal::max(viewport_1.y, 1.0)) : count;
    metal::float2 p_6 = metal::clamp(place_3 * scale_2, metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float3 _e21 = bounded_vec3_(stretch);
    metal::float3 s_1 = metal::clamp(_e21, metal::float3(-1000000000000000.0), metal::float3(1000000000000000.0));
    return SpacedPlace {p_6, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : s_1};
}

SpacedPlace spaced_2_(
    metal::float2 place_4,
    metal::float3 stretch_1,
    metal::float2 viewport_2,
    float count_1
) {
    bool is_pixel_1 = !(((stretch_1.x + stretch_1.z) > 0.0));
    float scale_3 = is_pixel_1 ? (count_1 / metal::max(viewport_2.y, 1.0)) : count_1;
    metal::float2 p_7 = metal::clamp(place_4 * scale_3, metal::float2(-4194304.0), metal::float2(4194304.0));
    return SpacedPlace {p_7, {}, is_pixel_1 ? metal::float3(1.0, 0.0, 1.0) : stretch_1};
}

float area_square(
    metal::float3 stretch_2
) {
    float sum = stretch_2.x + stretch_2.z;
    return metal::max((stretch_2.x * stretch_2.z) - (stretch_2.y * stretch_2.y), (sum * sum) / 66.0);
}

metal::float2 brush_turned(
    metal::float2 step,
    Brushstroke stroke,
    Brush style
) {
    metal::float2 turned_2 = metal::float2((stroke.turn.y * step.x) + (stroke.turn.x * step.y), (stroke.turn.y * step.y) - (stroke.turn.x * step.x));
    return turned_2 * metal::float2(stroke.way / (style.size * style.aspect), -1.0 / style.size);
}

Brushstroke brush_stroke(
    metal::float2 p,
    metal::int2 cell_2,
    int zoom,
    float drawn,
    Brush style_1
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_2, zoom)) + metal::uint3(2654435769u, 2246822507u, 3266489909u));
    metal::float3 chance = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    metal::float2 offset = p - ((static_cast<metal::float2>(cell_2) + metal::float2(0.5)) + (style_1.scatter * (chance.xy - metal::float2(0.5))));
    float x_7 = 0.5 * (chance.z - 0.5);
    metal::float2 turn_8 = metal::float2(metal::sin(x_7), metal::cos(x_7));
    metal::uint3 _e46 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_2, zoom)) + metal::uint3(1013904242u, 198677718u, 2238012522u));
    float way = ((static_cast<metal::float3>(_e46 >> metal::uint3(8u)) * 0.000000059604645).x < 0.5) ? 1.0 : -1.0;
    Brushstroke stroke_3 = Brushstroke {metal::float2(0.5), turn_8, way, 0.0};
    metal::float2 _e67 = brush_turned(offset * metal::float2(style_1.aspect, 1.0), stroke_3, style_1);
    metal::float2 uv_1 = metal::float2(0.5) + _e67;
    metal::float2 from_edge = metal::min(uv_1, metal::float2(1.0) - uv_1);
    float inside = metal::clamp(64.0 * metal::min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = metal::max(metal::abs(offset.x), metal::abs(offset.y)) / (1.0 - (0.5 * style_1.scatter));
    float share = (drawn * inside) * (1.0 - metal::smoothstep(0.85, 1.0, far));
    return Brushstroke {uv_1, turn_8, way, share};
}

metal::float3 bristle(
    float row,
    uint seed_2
) {
    float first = metal::floor(row);
    float t_2 = row - first;
    metal::uint3 _e8 = lattice_hash(metal::int3(naga_f2i32(first), 0, 0), seed_2);
    metal::float3 _e9 = unit_of_hash(_e8);
    metal::uint3 _e16 = lattice_hash(metal::int3(as_type<int>(as_type<uint>(naga_f2i32(first)) + as_type<uint>(1)), 0, 0), seed_2);
    metal::float3 _e17 = unit_of_hash(_e16);
    return metal::mix(_e9, _e17, (t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

metal::float2 bristles(
    metal::float2 uv,
    float width,
    uint seed_3
) {
    float across_5 = (2.0 * uv.y) - 1.0;
    metal::uint3 _e19 = hash_pcg3d(as_type<metal::uint3>(metal::int3(0, 1, 0)) + (seed_3 * metal::uint3(2654435769u, 2246822507u, 3266489909u)));
    metal::float3 own = static_cast<metal::float3>(_e19 >> metal::uint3(8u)) * 0.000000059604645;
    float seen = metal::clamp(1.75 - (11.0 * width), 0.0, 1.0);
    metal::float3 _e38 = bristle(11.0 * uv.y, seed_3);
    metal::float3 chance_1 = metal::mix(metal::float3(0.5), _e38, seen);
    float start = (0.03 + (0.12 * chance_1.x)) + ((0.09 * across_5) * across_5);
    float end = (0.97 - ((0.1 + (0.25 * own.y)) * chance_1.y)) - ((0.12 * across_5) * across_5);
    float _e65 = eased(uv.x, start, start + 0.05);
    float _e69 = eased(uv.x, end - 0.1, end);
    float along_4 = _e65 * (1.0 - _e69);
    float side = 1.0 - metal::smoothstep(0.78, 0.95, metal::abs(across_5));
    float dry = metal::smoothstep(0.85, 1.25, uv.x + (0.55 * chance_1.z));
    float shade_1 = ((0.8 + (0.16 * own.z)) + (0.208 * (chance_1.z - 0.5))) - (0.05 * uv.x);
    return metal::float2(metal::clamp(shade_1, 0.0, 1.0), (along_4 * side) * (1.0 - (0.9 * dry)));
}

metal::int2 naga_f2i32(metal::float2 value) {
    return static_cast<metal::int2>(metal::clamp(value, -2147483600.0, 2147483500.0));
}

metal::int2 naga_mod(metal::int2 lhs, metal::int2 rhs) {
    metal::int2 divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_mod(int lhs, int rhs) {
    int divisor = metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / metal::select(rhs, 1, (lhs == (-2147483647 - 1) & rhs == -1) | (rhs == 0));
}

metal::float2 bristles_laid(
    SpacedPlace at,
    float ink,
    Brush style_2
) {
    int i = {};
    int octave = 0;
    metal::float2 paint = metal::float2(0.0);
    type_11 tile = BLUE_TILE;
    metal::float2 dx = metal::dfdx(at.place);
    metal::float2 dy = metal::dfdy(at.place);
    float _e8 = area_square(at.stretch);
    float _e12 = log2_stable(metal::max(metal::sqrt(_e8), 0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * _e12, -16.0, 16.0);
    float zoom_6 = metal::floor(level);
    float f_1 = level - zoom_6;
    float _e22 = exp2_stable(-2.0 * f_1);
    float fine = (1.0 - ((1.0 - f_1) * _e22)) / (4.0 * _e22);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e182 = octave;
            octave = as_type<int>(as_type<uint>(_e182) + as_type<uint>(1));
        }
        loop_init = false;
        int _e39 = octave;
        if (!((_e39 < 2))) {
            break;
        }
        int _e45 = octave;
        float amount = ink * ((_e45 == 1) ? fine : (1.0 - f_1));
        int _e51 = octave;
        float scale_4 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_6)) + as_type<uint>(_e51))) + as_type<uint>(127))) << 23u);
        metal::float2 p_8 = metal::clamp(at.place * scale_4, metal::float2(-4194304.0), metal::float2(4194304.0)) / metal::float2(style_2.aspect, 1.0);
        metal::int2 corner = naga_f2i32(metal::floor(p_8));
        metal::int2 phase = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(corner, metal::int2(3))) + as_type<metal::uint2>(metal::int2(3))), metal::int2(3));
        i = 0;
        uint2 loop_bound_1 = uint2(4294967295u);
        bool loop_init_1 = true;
        while(true) {
            if (metal::all(loop_bound_1 == uint2(0u))) { break; }
            loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
            if (!loop_init_1) {
                int _e179 = i;
                i = as_type<int>(as_type<uint>(_e179) + as_type<uint>(1));
            }
            loop_init_1 = false;
            int _e82 = i;
            if (!((_e82 < 9))) {
                break;
            }
            int _e86 = i;
            int _e89 = i;
            metal::int2 cell_8 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(corner) + as_type<metal::uint2>(naga_mod(as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(metal::int2(naga_mod(_e86, 3), naga_div(_e89, 3))) - as_type<metal::uint2>(phase))) + as_type<metal::uint2>(metal::int2(4))), metal::int2(3))))) - as_type<metal::uint2>(metal::int2(1)));
            int _e106 = octave;
            metal::int2 turning = as_type<metal::int2>(as_type<metal::uint2>(cell_8) + as_type<metal::uint2>(metal::int2(1, as_type<int>(as_type<uint>(7) * as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_6)) + as_type<uint>(_e106)))))));
            uint _e112 = blue_index(turning);
            uint _e114 = tile.inner[_e112];
            float late = 0.96875 * ((static_cast<float>((_e114 >> (8u * (as_type<uint>(turning.x) & 3u))) & 255u) + 0.5) * 0.00390625);
            float share_1 = metal::clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share_1 <= 0.0) {
                continue;
            }
            int _e140 = octave;
            Brushstroke _e142 = brush_stroke(p_8, cell_8, as_type<int>(as_type<uint>(naga_f2i32(zoom_6)) + as_type<uint>(_e140)), share_1, style_2);
            if (_e142.share > 0.0) {
                metal::float2 _e147 = brush_turned(dx * scale_4, _e142, style_2);
                metal::float2 _e149 = brush_turned(dy * scale_4, _e142, style_2);
                int _e151 = octave;
                metal::uint3 _e160 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_8, as_type<int>(as_type<uint>(naga_f2i32(zoom_6)) + as_type<uint>(_e151)))) + metal::uint3(3668340011u, 2445500225u, 1209535135u));
                uint own_1 = _e160.x;
                metal::float2 _e167 = bristles(_e142.uv, metal::length(metal::float2(_e147.y, _e149.y)), own_1);
                float cover = _e142.share * _e167.y;
                metal::float2 _e174 = paint;
                paint = metal::float2(_e167.x * cover, cover) + (_e174 * (1.0 - cover));
            }
        }
    }
    metal::float2 _e185 = paint;
    return _e185;
}

metal::float2 brush_turned_2_(
    metal::float2 step_1,
    Brushstroke stroke_1,
    Brush style_3
) {
    metal::float2 turned_3 = metal::float2((stroke_1.turn.y * step_1.x) + (stroke_1.turn.x * step_1.y), (stroke_1.turn.y * step_1.y) - (stroke_1.turn.x * step_1.x));
    return turned_3 * metal::float2(stroke_1.way / (1.5 * style_3.aspect), -0.6666667);
}

Brushstroke brush_stroke_2_(
    metal::float2 p_1,
    metal::int2 cell_3,
    int zoom_1,
    float drawn_1,
    Brush style_4
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_3, zoom_1)) + metal::uint3(3041712726u, 596033154u, 2419070270u));
    metal::float3 chance_2 = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    metal::float2 offset_1 = p_1 - ((static_cast<metal::float2>(cell_3) + metal::float2(0.5)) + (style_4.scatter * (chance_2.xy - metal::float2(0.5))));
    float x_8 = 0.5 * (chance_2.z - 0.5);
    metal::float2 turn_9 = metal::float2(metal::sin(x_8), metal::cos(x_8));
    metal::uint3 _e46 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_3, zoom_1)) + metal::uint3(1401181199u, 2842855661u, 1390592883u));
    float way_1 = ((static_cast<metal::float3>(_e46 >> metal::uint3(8u)) * 0.000000059604645).x < 0.5) ? 1.0 : -1.0;
    Brushstroke stroke_4 = Brushstroke {metal::float2(0.5), turn_9, way_1, 0.0};
    metal::float2 _e67 = brush_turned_2_(offset_1 * metal::float2(style_4.aspect, 1.0), stroke_4, style_4);
    metal::float2 uv_2 = metal::float2(0.5) + _e67;
    metal::float2 from_edge_1 = metal::min(uv_2, metal::float2(1.0) - uv_2);
    float inside_1 = metal::clamp(64.0 * metal::min(from_edge_1.x, from_edge_1.y), 0.0, 1.0);
    float far_1 = metal::max(metal::abs(offset_1.x), metal::abs(offset_1.y)) / (1.0 - (0.5 * style_4.scatter));
    float share_2 = (drawn_1 * inside_1) * (1.0 - metal::smoothstep(0.85, 1.0, far_1));
    return Brushstroke {uv_2, turn_9, way_1, share_2};
}

metal::float2 bristles_laid_2_(
    SpacedPlace at_1,
    float ink_1,
    Brush style_5
) {
    int i_1 = {};
    int octave_1 = 0;
    metal::float2 paint_1 = metal::float2(0.0);
    type_11 tile_1 = BLUE_TILE;
    metal::float2 dx_1 = metal::dfdx(at_1.place);
    metal::float2 dy_1 = metal::dfdy(at_1.place);
    float _e8 = area_square(at_1.stretch);
    float _e12 = log2_stable(metal::max(metal::sqrt(_e8), 0.000000000000000000000000000001));
    float level_1 = metal::clamp(-0.5 * _e12, -16.0, 16.0);
    float zoom_7 = metal::floor(level_1);
    float f_2 = level_1 - zoom_7;
    float _e22 = exp2_stable(-2.0 * f_2);
    float fine_1 = (1.0 - ((1.0 - f_2) * _e22)) / (4.0 * _e22);
    uint2 loop_bound_2 = uint2(4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (metal::all(loop_bound_2 == uint2(0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e182 = octave_1;
            octave_1 = as_type<int>(as_type<uint>(_e182) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e39 = octave_1;
        if (!((_e39 < 2))) {
            break;
        }
        int _e45 = octave_1;
        float amount_1 = ink_1 * ((_e45 == 1) ? fine_1 : (1.0 - f_2));
        int _e51 = octave_1;
        float scale_5 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_7)) + as_type<uint>(_e51))) + as_type<uint>(127))) << 23u);
        metal::float2 p_9 = metal::clamp(at_1.place * scale_5, metal::float2(-4194304.0), metal::float2(4194304.0)) / metal::float2(style_5.aspect, 1.0);
        metal::int2 corner_1 = naga_f2i32(metal::floor(p_9));
        metal::int2 phase_1 = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(corner_1, metal::int2(3))) + as_type<metal::uint2>(metal::int2(3))), metal::int2(3));
        i_1 = 0;
        uint2 loop_bound_3 = uint2(4294967295u);
        bool loop_init_3 = true;
        while(true) {
            if (metal::all(loop_bound_3 == uint2(0u))) { break; }
            loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
            if (!loop_init_3) {
                int _e179 = i_1;
                i_1 = as_type<int>(as_type<uint>(_e179) + as_type<uint>(1));
            }
            loop_init_3 = false;
            int _e82 = i_1;
            if (!((_e82 < 9))) {
                break;
            }
            int _e86 = i_1;
            int _e89 = i_1;
            metal::int2 cell_9 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(corner_1) + as_type<metal::uint2>(naga_mod(as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(metal::int2(naga_mod(_e86, 3), naga_div(_e89, 3))) - as_type<metal::uint2>(phase_1))) + as_type<metal::uint2>(metal::int2(4))), metal::int2(3))))) - as_type<metal::uint2>(metal::int2(1)));
            int _e106 = octave_1;
            metal::int2 turning_1 = as_type<metal::int2>(as_type<metal::uint2>(cell_9) + as_type<metal::uint2>(metal::int2(6, as_type<int>(as_type<uint>(7) * as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_7)) + as_type<uint>(_e106)))))));
            uint _e112 = blue_index(turning_1);
            uint _e114 = tile_1.inner[_e112];
            float late_1 = 0.96875 * ((static_cast<float>((_e114 >> (8u * (as_type<uint>(turning_1.x) & 3u))) & 255u) + 0.5) * 0.00390625);
            float share_3 = metal::clamp((amount_1 - late_1) * 32.0, 0.0, 1.0);
            if (share_3 <= 0.0) {
                continue;
            }
            int _e140 = octave_1;
            Brushstroke _e142 = brush_stroke_2_(p_9, cell_9, as_type<int>(as_type<uint>(naga_f2i32(zoom_7)) + as_type<uint>(_e140)), share_3, style_5);
            if (_e142.share > 0.0) {
                metal::float2 _e147 = brush_turned_2_(dx_1 * scale_5, _e142, style_5);
                metal::float2 _e149 = brush_turned_2_(dy_1 * scale_5, _e142, style_5);
                int _e151 = octave_1;
                metal::uint3 _e160 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_9, as_type<int>(as_type<uint>(naga_f2i32(zoom_7)) + as_type<uint>(_e151)))) + metal::uint3(4055616968u, 794710872u, 362115496u));
                uint own_2 = _e160.x;
                metal::float2 _e167 = bristles(_e142.uv, metal::length(metal::float2(_e147.y, _e149.y)), own_2);
                float cover_1 = _e142.share * _e167.y;
                metal::float2 _e174 = paint_1;
                paint_1 = metal::float2(_e167.x * cover_1, cover_1) + (_e174 * (1.0 - cover_1));
            }
        }
    }
    metal::float2 _e185 = paint_1;
    return _e185;
}

Brushstroke brush_stroke_3_(
    metal::float2 p_2,
    metal::int2 cell_4,
    int zoom_2,
    float drawn_2,
    Brush style_6
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_4, zoom_2)) + metal::uint3(1013904242u, 198677718u, 2238012522u));
    metal::float3 chance_3 = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    metal::float2 offset_2 = p_2 - ((static_cast<metal::float2>(cell_4) + metal::float2(0.5)) + (style_6.scatter * (chance_3.xy - metal::float2(0.5))));
    float x_9 = 0.5 * (chance_3.z - 0.5);
    metal::float2 turn_10 = metal::float2(metal::sin(x_9), metal::cos(x_9));
    metal::uint3 _e46 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_4, zoom_2)) + metal::uint3(3668340011u, 2445500225u, 1209535135u));
    float way_2 = ((static_cast<metal::float3>(_e46 >> metal::uint3(8u)) * 0.000000059604645).x < 0.5) ? 1.0 : -1.0;
    Brushstroke stroke_5 = Brushstroke {metal::float2(0.5), turn_10, way_2, 0.0};
    metal::float2 _e67 = brush_turned(offset_2 * metal::float2(style_6.aspect, 1.0), stroke_5, style_6);
    metal::float2 uv_3 = metal::float2(0.5) + _e67;
    metal::float2 from_edge_2 = metal::min(uv_3, metal::float2(1.0) - uv_3);
    float inside_2 = metal::clamp(64.0 * metal::min(from_edge_2.x, from_edge_2.y), 0.0, 1.0);
    float far_2 = metal::max(metal::abs(offset_2.x), metal::abs(offset_2.y)) / (1.0 - (0.5 * style_6.scatter));
    float share_4 = (drawn_2 * inside_2) * (1.0 - metal::smoothstep(0.85, 1.0, far_2));
    return Brushstroke {uv_3, turn_10, way_2, share_4};
}

metal::float2 bristles_laid_3_(
    SpacedPlace at_2,
    float ink_2,
    Brush style_7
) {
    int i_2 = {};
    int octave_2 = 0;
    metal::float2 paint_2 = metal::float2(0.0);
    type_11 tile_2 = BLUE_TILE;
    metal::float2 dx_2 = metal::dfdx(at_2.place);
    metal::float2 dy_2 = metal::dfdy(at_2.place);
    float _e8 = area_square(at_2.stretch);
    float _e12 = log2_stable(metal::max(metal::sqrt(_e8), 0.000000000000000000000000000001));
    float level_2 = metal::clamp(-0.5 * _e12, -16.0, 16.0);
    float zoom_8 = metal::floor(level_2);
    float f_3 = level_2 - zoom_8;
    float _e22 = exp2_stable(-2.0 * f_3);
    float fine_2 = (1.0 - ((1.0 - f_3) * _e22)) / (4.0 * _e22);
    uint2 loop_bound_4 = uint2(4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (metal::all(loop_bound_4 == uint2(0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e182 = octave_2;
            octave_2 = as_type<int>(as_type<uint>(_e182) + as_type<uint>(1));
        }
        loop_init_4 = false;
        int _e39 = octave_2;
        if (!((_e39 < 2))) {
            break;
        }
        int _e45 = octave_2;
        float amount_2 = ink_2 * ((_e45 == 1) ? fine_2 : (1.0 - f_3));
        int _e51 = octave_2;
        float scale_6 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_8)) + as_type<uint>(_e51))) + as_type<uint>(127))) << 23u);
        metal::float2 p_10 = metal::clamp(at_2.place * scale_6, metal::float2(-4194304.0), metal::float2(4194304.0)) / metal::float2(style_7.aspect, 1.0);
        metal::int2 corner_2 = naga_f2i32(metal::floor(p_10));
        metal::int2 phase_2 = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(corner_2, metal::int2(3))) + as_type<metal::uint2>(metal::int2(3))), metal::int2(3));
        i_2 = 0;
        uint2 loop_bound_5 = uint2(4294967295u);
        bool loop_init_5 = true;
        while(true) {
            if (metal::all(loop_bound_5 == uint2(0u))) { break; }
            loop_bound_5 -= uint2(loop_bound_5.y == 0u, 1u);
            if (!loop_init_5) {
                int _e179 = i_2;
                i_2 = as_type<int>(as_type<uint>(_e179) + as_type<uint>(1));
            }
            loop_init_5 = false;
            int _e82 = i_2;
            if (!((_e82 < 9))) {
                break;
            }
            int _e86 = i_2;
            int _e89 = i_2;
            metal::int2 cell_10 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(corner_2) + as_type<metal::uint2>(naga_mod(as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(metal::int2(naga_mod(_e86, 3), naga_div(_e89, 3))) - as_type<metal::uint2>(phase_2))) + as_type<metal::uint2>(metal::int2(4))), metal::int2(3))))) - as_type<metal::uint2>(metal::int2(1)));
            int _e106 = octave_2;
            metal::int2 turning_2 = as_type<metal::int2>(as_type<metal::uint2>(cell_10) + as_type<metal::uint2>(metal::int2(2, as_type<int>(as_type<uint>(7) * as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_8)) + as_type<uint>(_e106)))))));
            uint _e112 = blue_index(turning_2);
            uint _e114 = tile_2.inner[_e112];
            float late_2 = 0.96875 * ((static_cast<float>((_e114 >> (8u * (as_type<uint>(turning_2.x) & 3u))) & 255u) + 0.5) * 0.00390625);
            float share_5 = metal::clamp((amount_2 - late_2) * 32.0, 0.0, 1.0);
            if (share_5 <= 0.0) {
                continue;
            }
            int _e140 = octave_2;
            Brushstroke _e142 = brush_stroke_3_(p_10, cell_10, as_type<int>(as_type<uint>(naga_f2i32(zoom_8)) + as_type<uint>(_e140)), share_5, style_7);
            if (_e142.share > 0.0) {
                metal::float2 _e147 = brush_turned(dx_2 * scale_6, _e142, style_7);
                metal::float2 _e149 = brush_turned(dy_2 * scale_6, _e142, style_7);
                int _e151 = octave_2;
                metal::uint3 _e160 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_10, as_type<int>(as_type<uint>(naga_f2i32(zoom_8)) + as_type<uint>(_e151)))) + metal::uint3(2027808484u, 397355436u, 181057748u));
                uint own_3 = _e160.x;
                metal::float2 _e167 = bristles(_e142.uv, metal::length(metal::float2(_e147.y, _e149.y)), own_3);
                float cover_2 = _e142.share * _e167.y;
                metal::float2 _e174 = paint_2;
                paint_2 = metal::float2(_e167.x * cover_2, cover_2) + (_e174 * (1.0 - cover_2));
            }
        }
    }
    metal::float2 _e185 = paint_2;
    return _e185;
}

metal::float2 brush_turned_3_(
    metal::float2 step_2,
    Brushstroke stroke_2,
    Brush style_8
) {
    metal::float2 turned_4 = metal::float2((stroke_2.turn.y * step_2.x) + (stroke_2.turn.x * step_2.y), (stroke_2.turn.y * step_2.y) - (stroke_2.turn.x * step_2.x));
    return turned_4 * metal::float2(stroke_2.way / 4.5, -0.6666667);
}

Brushstroke brush_stroke_4_(
    metal::float2 p_3,
    metal::int2 cell_5,
    int zoom_3,
    float drawn_3,
    Brush style_9
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_5, zoom_3)) + metal::uint3(3668340011u, 2445500225u, 1209535135u));
    metal::float3 chance_4 = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    metal::float2 offset_3 = p_3 - ((static_cast<metal::float2>(cell_5) + metal::float2(0.5)) + (style_9.scatter * (chance_4.xy - metal::float2(0.5))));
    float x_10 = 0.5 * (chance_4.z - 0.5);
    metal::float2 turn_11 = metal::float2(metal::sin(x_10), metal::cos(x_10));
    metal::uint3 _e46 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_5, zoom_3)) + metal::uint3(2027808484u, 397355436u, 181057748u));
    float way_3 = ((static_cast<metal::float3>(_e46 >> metal::uint3(8u)) * 0.000000059604645).x < 0.5) ? 1.0 : -1.0;
    Brushstroke stroke_6 = Brushstroke {metal::float2(0.5), turn_11, way_3, 0.0};
    metal::float2 _e67 = brush_turned_3_(offset_3 * metal::float2(3.0, 1.0), stroke_6, style_9);
    metal::float2 uv_4 = metal::float2(0.5) + _e67;
    metal::float2 from_edge_3 = metal::min(uv_4, metal::float2(1.0) - uv_4);
    float inside_3 = metal::clamp(64.0 * metal::min(from_edge_3.x, from_edge_3.y), 0.0, 1.0);
    float far_3 = metal::max(metal::abs(offset_3.x), metal::abs(offset_3.y)) / (1.0 - (0.5 * style_9.scatter));
    float share_6 = (drawn_3 * inside_3) * (1.0 - metal::smoothstep(0.85, 1.0, far_3));
    return Brushstroke {uv_4, turn_11, way_3, share_6};
}

metal::float2 bristles_laid_4_(
    SpacedPlace at_3,
    float ink_3,
    Brush style_10
) {
    int i_3 = {};
    int octave_3 = 0;
    metal::float2 paint_3 = metal::float2(0.0);
    type_11 tile_3 = BLUE_TILE;
    metal::float2 dx_3 = metal::dfdx(at_3.place);
    metal::float2 dy_3 = metal::dfdy(at_3.place);
    float _e8 = area_square(at_3.stretch);
    float _e12 = log2_stable(metal::max(metal::sqrt(_e8), 0.000000000000000000000000000001));
    float level_3 = metal::clamp(-0.5 * _e12, -16.0, 16.0);
    float zoom_9 = metal::floor(level_3);
    float f_4 = level_3 - zoom_9;
    float _e22 = exp2_stable(-2.0 * f_4);
    float fine_3 = (1.0 - ((1.0 - f_4) * _e22)) / (4.0 * _e22);
    uint2 loop_bound_6 = uint2(4294967295u);
    bool loop_init_6 = true;
    while(true) {
        if (metal::all(loop_bound_6 == uint2(0u))) { break; }
        loop_bound_6 -= uint2(loop_bound_6.y == 0u, 1u);
        if (!loop_init_6) {
            int _e182 = octave_3;
            octave_3 = as_type<int>(as_type<uint>(_e182) + as_type<uint>(1));
        }
        loop_init_6 = false;
        int _e39 = octave_3;
        if (!((_e39 < 2))) {
            break;
        }
        int _e45 = octave_3;
        float amount_3 = ink_3 * ((_e45 == 1) ? fine_3 : (1.0 - f_4));
        int _e51 = octave_3;
        float scale_7 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_9)) + as_type<uint>(_e51))) + as_type<uint>(127))) << 23u);
        metal::float2 p_11 = metal::clamp(at_3.place * scale_7, metal::float2(-4194304.0), metal::float2(4194304.0)) / metal::float2(3.0, 1.0);
        metal::int2 corner_3 = naga_f2i32(metal::floor(p_11));
        metal::int2 phase_3 = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(corner_3, metal::int2(3))) + as_type<metal::uint2>(metal::int2(3))), metal::int2(3));
        i_3 = 0;
        uint2 loop_bound_7 = uint2(4294967295u);
        bool loop_init_7 = true;
        while(true) {
            if (metal::all(loop_bound_7 == uint2(0u))) { break; }
            loop_bound_7 -= uint2(loop_bound_7.y == 0u, 1u);
            if (!loop_init_7) {
                int _e179 = i_3;
                i_3 = as_type<int>(as_type<uint>(_e179) + as_type<uint>(1));
            }
            loop_init_7 = false;
            int _e82 = i_3;
            if (!((_e82 < 9))) {
                break;
            }
            int _e86 = i_3;
            int _e89 = i_3;
            metal::int2 cell_11 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(corner_3) + as_type<metal::uint2>(naga_mod(as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(metal::int2(naga_mod(_e86, 3), naga_div(_e89, 3))) - as_type<metal::uint2>(phase_3))) + as_type<metal::uint2>(metal::int2(4))), metal::int2(3))))) - as_type<metal::uint2>(metal::int2(1)));
            int _e106 = octave_3;
            metal::int2 turning_3 = as_type<metal::int2>(as_type<metal::uint2>(cell_11) + as_type<metal::uint2>(metal::int2(3, as_type<int>(as_type<uint>(7) * as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_9)) + as_type<uint>(_e106)))))));
            uint _e112 = blue_index(turning_3);
            uint _e114 = tile_3.inner[_e112];
            float late_3 = 0.96875 * ((static_cast<float>((_e114 >> (8u * (as_type<uint>(turning_3.x) & 3u))) & 255u) + 0.5) * 0.00390625);
            float share_7 = metal::clamp((amount_3 - late_3) * 32.0, 0.0, 1.0);
            if (share_7 <= 0.0) {
                continue;
            }
            int _e140 = octave_3;
            Brushstroke _e142 = brush_stroke_4_(p_11, cell_11, as_type<int>(as_type<uint>(naga_f2i32(zoom_9)) + as_type<uint>(_e140)), share_7, style_10);
            if (_e142.share > 0.0) {
                metal::float2 _e147 = brush_turned_3_(dx_3 * scale_7, _e142, style_10);
                metal::float2 _e149 = brush_turned_3_(dy_3 * scale_7, _e142, style_10);
                int _e151 = octave_3;
                metal::uint3 _e160 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_11, as_type<int>(as_type<uint>(naga_f2i32(zoom_9)) + as_type<uint>(_e151)))) + metal::uint3(387276957u, 2644177943u, 3447547657u));
                uint own_4 = _e160.x;
                metal::float2 _e167 = bristles(_e142.uv, metal::length(metal::float2(_e147.y, _e149.y)), own_4);
                float cover_3 = _e142.share * _e167.y;
                metal::float2 _e174 = paint_3;
                paint_3 = metal::float2(_e167.x * cover_3, cover_3) + (_e174 * (1.0 - cover_3));
            }
        }
    }
    metal::float2 _e185 = paint_3;
    return _e185;
}

Brushstroke brush_stroke_5_(
    metal::float2 p_4,
    metal::int2 cell_6,
    int zoom_4,
    float drawn_4,
    Brush style_11
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_6, zoom_4)) + metal::uint3(2027808484u, 397355436u, 181057748u));
    metal::float3 chance_5 = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    metal::float2 offset_4 = p_4 - ((static_cast<metal::float2>(cell_6) + metal::float2(0.5)) + (style_11.scatter * (chance_5.xy - metal::float2(0.5))));
    float x_11 = style_11.turn * (chance_5.z - 0.5);
    metal::float2 turn_12 = metal::float2(metal::sin(x_11), metal::cos(x_11));
    metal::uint3 _e46 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_6, zoom_4)) + metal::uint3(387276957u, 2644177943u, 3447547657u));
    float way_4 = ((static_cast<metal::float3>(_e46 >> metal::uint3(8u)) * 0.000000059604645).x < 0.5) ? 1.0 : -1.0;
    Brushstroke stroke_7 = Brushstroke {metal::float2(0.5), turn_12, way_4, 0.0};
    metal::float2 _e67 = brush_turned(offset_4 * metal::float2(style_11.aspect, 1.0), stroke_7, style_11);
    metal::float2 uv_5 = metal::float2(0.5) + _e67;
    metal::float2 from_edge_4 = metal::min(uv_5, metal::float2(1.0) - uv_5);
    float inside_4 = metal::clamp(64.0 * metal::min(from_edge_4.x, from_edge_4.y), 0.0, 1.0);
    float far_4 = metal::max(metal::abs(offset_4.x), metal::abs(offset_4.y)) / (1.0 - (0.5 * style_11.scatter));
    float share_8 = (drawn_4 * inside_4) * (1.0 - metal::smoothstep(0.85, 1.0, far_4));
    return Brushstroke {uv_5, turn_12, way_4, share_8};
}

metal::float2 bristles_laid_5_(
    SpacedPlace at_4,
    float ink_4,
    Brush style_12
) {
    int i_4 = {};
    int octave_4 = 0;
    metal::float2 paint_4 = metal::float2(0.0);
    type_11 tile_4 = BLUE_TILE;
    metal::float2 dx_4 = metal::dfdx(at_4.place);
    metal::float2 dy_4 = metal::dfdy(at_4.place);
    float _e8 = area_square(at_4.stretch);
    float _e12 = log2_stable(metal::max(metal::sqrt(_e8), 0.000000000000000000000000000001));
    float level_4 = metal::clamp(-0.5 * _e12, -16.0, 16.0);
    float zoom_10 = metal::floor(level_4);
    float f_5 = level_4 - zoom_10;
    float _e22 = exp2_stable(-2.0 * f_5);
    float fine_4 = (1.0 - ((1.0 - f_5) * _e22)) / (4.0 * _e22);
    uint2 loop_bound_8 = uint2(4294967295u);
    bool loop_init_8 = true;
    while(true) {
        if (metal::all(loop_bound_8 == uint2(0u))) { break; }
        loop_bound_8 -= uint2(loop_bound_8.y == 0u, 1u);
        if (!loop_init_8) {
            int _e182 = octave_4;
            octave_4 = as_type<int>(as_type<uint>(_e182) + as_type<uint>(1));
        }
        loop_init_8 = false;
        int _e39 = octave_4;
        if (!((_e39 < 2))) {
            break;
        }
        int _e45 = octave_4;
        float amount_4 = ink_4 * ((_e45 == 1) ? fine_4 : (1.0 - f_5));
        int _e51 = octave_4;
        float scale_8 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_10)) + as_type<uint>(_e51))) + as_type<uint>(127))) << 23u);
        metal::float2 p_12 = metal::clamp(at_4.place * scale_8, metal::float2(-4194304.0), metal::float2(4194304.0)) / metal::float2(style_12.aspect, 1.0);
        metal::int2 corner_4 = naga_f2i32(metal::floor(p_12));
        metal::int2 phase_4 = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(corner_4, metal::int2(3))) + as_type<metal::uint2>(metal::int2(3))), metal::int2(3));
        i_4 = 0;
        uint2 loop_bound_9 = uint2(4294967295u);
        bool loop_init_9 = true;
        while(true) {
            if (metal::all(loop_bound_9 == uint2(0u))) { break; }
            loop_bound_9 -= uint2(loop_bound_9.y == 0u, 1u);
            if (!loop_init_9) {
                int _e179 = i_4;
                i_4 = as_type<int>(as_type<uint>(_e179) + as_type<uint>(1));
            }
            loop_init_9 = false;
            int _e82 = i_4;
            if (!((_e82 < 9))) {
                break;
            }
            int _e86 = i_4;
            int _e89 = i_4;
            metal::int2 cell_12 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(corner_4) + as_type<metal::uint2>(naga_mod(as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(metal::int2(naga_mod(_e86, 3), naga_div(_e89, 3))) - as_type<metal::uint2>(phase_4))) + as_type<metal::uint2>(metal::int2(4))), metal::int2(3))))) - as_type<metal::uint2>(metal::int2(1)));
            int _e106 = octave_4;
            metal::int2 turning_4 = as_type<metal::int2>(as_type<metal::uint2>(cell_12) + as_type<metal::uint2>(metal::int2(4, as_type<int>(as_type<uint>(7) * as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_10)) + as_type<uint>(_e106)))))));
            uint _e112 = blue_index(turning_4);
            uint _e114 = tile_4.inner[_e112];
            float late_4 = 0.96875 * ((static_cast<float>((_e114 >> (8u * (as_type<uint>(turning_4.x) & 3u))) & 255u) + 0.5) * 0.00390625);
            float share_9 = metal::clamp((amount_4 - late_4) * 32.0, 0.0, 1.0);
            if (share_9 <= 0.0) {
                continue;
            }
            int _e140 = octave_4;
            Brushstroke _e142 = brush_stroke_5_(p_12, cell_12, as_type<int>(as_type<uint>(naga_f2i32(zoom_10)) + as_type<uint>(_e140)), share_9, style_12);
            if (_e142.share > 0.0) {
                metal::float2 _e147 = brush_turned(dx_4 * scale_8, _e142, style_12);
                metal::float2 _e149 = brush_turned(dy_4 * scale_8, _e142, style_12);
                int _e151 = octave_4;
                metal::uint3 _e160 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_12, as_type<int>(as_type<uint>(naga_f2i32(zoom_10)) + as_type<uint>(_e151)))) + metal::uint3(3041712726u, 596033154u, 2419070270u));
                uint own_5 = _e160.x;
                metal::float2 _e167 = bristles(_e142.uv, metal::length(metal::float2(_e147.y, _e149.y)), own_5);
                float cover_4 = _e142.share * _e167.y;
                metal::float2 _e174 = paint_4;
                paint_4 = metal::float2(_e167.x * cover_4, cover_4) + (_e174 * (1.0 - cover_4));
            }
        }
    }
    metal::float2 _e185 = paint_4;
    return _e185;
}

Brushstroke brush_stroke_6_(
    metal::float2 p_5,
    metal::int2 cell_7,
    int zoom_5,
    float drawn_5,
    Brush style_13
) {
    metal::uint3 _e12 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_7, zoom_5)) + metal::uint3(4055616968u, 794710872u, 362115496u));
    metal::float3 chance_6 = static_cast<metal::float3>(_e12 >> metal::uint3(8u)) * 0.000000059604645;
    metal::float2 offset_5 = p_5 - ((static_cast<metal::float2>(cell_7) + metal::float2(0.5)) + (style_13.scatter * (chance_6.xy - metal::float2(0.5))));
    float x_12 = style_13.turn * (chance_6.z - 0.5);
    metal::float2 turn_13 = metal::float2(metal::sin(x_12), metal::cos(x_12));
    metal::uint3 _e46 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_7, zoom_5)) + metal::uint3(2415085441u, 3041533379u, 3628605405u));
    float way_5 = ((static_cast<metal::float3>(_e46 >> metal::uint3(8u)) * 0.000000059604645).x < 0.5) ? 1.0 : -1.0;
    Brushstroke stroke_8 = Brushstroke {metal::float2(0.5), turn_13, way_5, 0.0};
    metal::float2 _e67 = brush_turned_2_(offset_5 * metal::float2(style_13.aspect, 1.0), stroke_8, style_13);
    metal::float2 uv_6 = metal::float2(0.5) + _e67;
    metal::float2 from_edge_5 = metal::min(uv_6, metal::float2(1.0) - uv_6);
    float inside_5 = metal::clamp(64.0 * metal::min(from_edge_5.x, from_edge_5.y), 0.0, 1.0);
    float far_5 = metal::max(metal::abs(offset_5.x), metal::abs(offset_5.y)) / (1.0 - (0.5 * style_13.scatter));
    float share_10 = (drawn_5 * inside_5) * (1.0 - metal::smoothstep(0.85, 1.0, far_5));
    return Brushstroke {uv_6, turn_13, way_5, share_10};
}

metal::float2 bristles_laid_6_(
    SpacedPlace at_5,
    float ink_5,
    Brush style_14
) {
    int i_5 = {};
    int octave_5 = 0;
    metal::float2 paint_5 = metal::float2(0.0);
    type_11 tile_5 = BLUE_TILE;
    metal::float2 dx_5 = metal::dfdx(at_5.place);
    metal::float2 dy_5 = metal::dfdy(at_5.place);
    float _e8 = area_square(at_5.stretch);
    float _e12 = log2_stable(metal::max(metal::sqrt(_e8), 0.000000000000000000000000000001));
    float level_5 = metal::clamp(-0.5 * _e12, -16.0, 16.0);
    float zoom_11 = metal::floor(level_5);
    float f_6 = level_5 - zoom_11;
    float _e22 = exp2_stable(-2.0 * f_6);
    float fine_5 = (1.0 - ((1.0 - f_6) * _e22)) / (4.0 * _e22);
    uint2 loop_bound_10 = uint2(4294967295u);
    bool loop_init_10 = true;
    while(true) {
        if (metal::all(loop_bound_10 == uint2(0u))) { break; }
        loop_bound_10 -= uint2(loop_bound_10.y == 0u, 1u);
        if (!loop_init_10) {
            int _e182 = octave_5;
            octave_5 = as_type<int>(as_type<uint>(_e182) + as_type<uint>(1));
        }
        loop_init_10 = false;
        int _e39 = octave_5;
        if (!((_e39 < 2))) {
            break;
        }
        int _e45 = octave_5;
        float amount_5 = ink_5 * ((_e45 == 1) ? fine_5 : (1.0 - f_6));
        int _e51 = octave_5;
        float scale_9 = as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_11)) + as_type<uint>(_e51))) + as_type<uint>(127))) << 23u);
        metal::float2 p_13 = metal::clamp(at_5.place * scale_9, metal::float2(-4194304.0), metal::float2(4194304.0)) / metal::float2(style_14.aspect, 1.0);
        metal::int2 corner_5 = naga_f2i32(metal::floor(p_13));
        metal::int2 phase_5 = naga_mod(as_type<metal::int2>(as_type<metal::uint2>(naga_mod(corner_5, metal::int2(3))) + as_type<metal::uint2>(metal::int2(3))), metal::int2(3));
        i_5 = 0;
        uint2 loop_bound_11 = uint2(4294967295u);
        bool loop_init_11 = true;
        while(true) {
            if (metal::all(loop_bound_11 == uint2(0u))) { break; }
            loop_bound_11 -= uint2(loop_bound_11.y == 0u, 1u);
            if (!loop_init_11) {
                int _e179 = i_5;
                i_5 = as_type<int>(as_type<uint>(_e179) + as_type<uint>(1));
            }
            loop_init_11 = false;
            int _e82 = i_5;
            if (!((_e82 < 9))) {
                break;
            }
            int _e86 = i_5;
            int _e89 = i_5;
            metal::int2 cell_13 = as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(corner_5) + as_type<metal::uint2>(naga_mod(as_type<metal::int2>(as_type<metal::uint2>(as_type<metal::int2>(as_type<metal::uint2>(metal::int2(naga_mod(_e86, 3), naga_div(_e89, 3))) - as_type<metal::uint2>(phase_5))) + as_type<metal::uint2>(metal::int2(4))), metal::int2(3))))) - as_type<metal::uint2>(metal::int2(1)));
            int _e106 = octave_5;
            metal::int2 turning_5 = as_type<metal::int2>(as_type<metal::uint2>(cell_13) + as_type<metal::uint2>(metal::int2(8, as_type<int>(as_type<uint>(7) * as_type<uint>(as_type<int>(as_type<uint>(naga_f2i32(zoom_11)) + as_type<uint>(_e106)))))));
            uint _e112 = blue_index(turning_5);
            uint _e114 = tile_5.inner[_e112];
            float late_5 = 0.96875 * ((static_cast<float>((_e114 >> (8u * (as_type<uint>(turning_5.x) & 3u))) & 255u) + 0.5) * 0.00390625);
            float share_11 = metal::clamp((amount_5 - late_5) * 32.0, 0.0, 1.0);
            if (share_11 <= 0.0) {
                continue;
            }
            int _e140 = octave_5;
            Brushstroke _e142 = brush_stroke_6_(p_13, cell_13, as_type<int>(as_type<uint>(naga_f2i32(zoom_11)) + as_type<uint>(_e140)), share_11, style_14);
            if (_e142.share > 0.0) {
                metal::float2 _e147 = brush_turned_2_(dx_5 * scale_9, _e142, style_14);
                metal::float2 _e149 = brush_turned_2_(dy_5 * scale_9, _e142, style_14);
                int _e151 = octave_5;
                metal::uint3 _e160 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_13, as_type<int>(as_type<uint>(naga_f2i32(zoom_11)) + as_type<uint>(_e151)))) + metal::uint3(774553914u, 993388590u, 2600128018u));
                uint own_6 = _e160.x;
                metal::float2 _e167 = bristles(_e142.uv, metal::length(metal::float2(_e147.y, _e149.y)), own_6);
                float cover_5 = _e142.share * _e167.y;
                metal::float2 _e174 = paint_5;
                paint_5 = metal::float2(_e167.x * cover_5, cover_5) + (_e174 * (1.0 - cover_5));
            }
        }
    }
    metal::float2 _e185 = paint_5;
    return _e185;
}

BrushStrokes brush_strokes_bristles(
    float value,
    metal::float2 place_5,
    metal::float3 stretch_3,
    float count_2,
    float aspect,
    float size,
    float scatter,
    float turn,
    int seed_4,
    metal::float2 viewport_3
) {
    SpacedPlace _e10 = spaced(place_5, stretch_3, viewport_3, count_2);
    Brush style_15 = Brush {aspect, size, scatter, turn, 1u, false};
    metal::float2 _e16 = bristles_laid(_e10, 1.0 - value, style_15);
    float shade_2 = _e16.x / metal::max(_e16.y, 0.001);
    return BrushStrokes {metal::float4(shade_2, shade_2, shade_2, 1.0), _e16.y};
}

BrushStrokes brush_strokes_bristles_2_(
    float value_1,
    metal::float2 place_6,
    metal::float3 stretch_4,
    float count_3,
    float aspect_1,
    float size_1,
    float scatter_1,
    float turn_1,
    int seed_5,
    metal::float2 viewport_4
) {
    SpacedPlace _e10 = spaced(place_6, stretch_4, viewport_4, count_3);
    Brush style_16 = Brush {aspect_1, size_1, scatter_1, turn_1, 6u, false};
    metal::float2 _e16 = bristles_laid_2_(_e10, 1.0 - value_1, style_16);
    float shade_3 = _e16.x / metal::max(_e16.y, 0.001);
    return BrushStrokes {metal::float4(shade_3, shade_3, shade_3, 1.0), _e16.y};
}

BrushStrokes brush_strokes_bristles_3_(
    float value_2,
    metal::float2 place_7,
    metal::float3 stretch_5,
    float count_4,
    float aspect_2,
    float size_2,
    float scatter_2,
    float turn_2,
    int seed_6,
    metal::float2 viewport_5
) {
    SpacedPlace _e10 = spaced(place_7, stretch_5, viewport_5, count_4);
    Brush style_17 = Brush {aspect_2, size_2, scatter_2, turn_2, 2u, false};
    metal::float2 _e16 = bristles_laid_3_(_e10, 1.0 - value_2, style_17);
    float shade_4 = _e16.x / metal::max(_e16.y, 0.001);
    return BrushStrokes {metal::float4(shade_4, shade_4, shade_4, 1.0), _e16.y};
}

BrushStrokes brush_strokes_bristles_4_(
    float value_3,
    metal::float2 place_8,
    metal::float3 stretch_6,
    float count_5,
    float aspect_3,
    float size_3,
    float scatter_3,
    float turn_3,
    int seed_7,
    metal::float2 viewport_6
) {
    SpacedPlace _e10 = spaced_2_(place_8, stretch_6, viewport_6, count_5);
    Brush style_18 = Brush {aspect_3, size_3, scatter_3, turn_3, 3u, false};
    metal::float2 _e16 = bristles_laid_4_(_e10, 1.0 - value_3, style_18);
    float shade_5 = _e16.x / metal::max(_e16.y, 0.001);
    return BrushStrokes {metal::float4(shade_5, shade_5, shade_5, 1.0), _e16.y};
}

BrushStrokes brush_strokes_bristles_5_(
    float value_4,
    metal::float2 place_9,
    metal::float3 stretch_7,
    float count_6,
    float aspect_4,
    float size_4,
    float scatter_4,
    float turn_4,
    int seed_8,
    metal::float2 viewport_7
) {
    SpacedPlace _e10 = spaced_2_(place_9, stretch_7, viewport_7, count_6);
    Brush style_19 = Brush {aspect_4, size_4, scatter_4, turn_4, 4u, false};
    metal::float2 _e16 = bristles_laid_5_(_e10, 1.0 - value_4, style_19);
    float shade_6 = _e16.x / metal::max(_e16.y, 0.001);
    return BrushStrokes {metal::float4(shade_6, shade_6, shade_6, 1.0), _e16.y};
}

BrushStrokes brush_strokes_bristles_6_(
    float value_5,
    metal::float2 place_10,
    metal::float3 stretch_8,
    float count_7,
    float aspect_5,
    float size_5,
    float scatter_5,
    float turn_5,
    int seed_9,
    metal::float2 viewport_8
) {
    SpacedPlace _e10 = spaced(place_10, stretch_8, viewport_8, count_7);
    Brush style_20 = Brush {aspect_5, size_5, scatter_5, turn_5, 8u, false};
    metal::float2 _e16 = bristles_laid_6_(_e10, 1.0 - value_5, style_20);
    float shade_7 = _e16.x / metal::max(_e16.y, 0.001);
    return BrushStrokes {metal::float4(shade_7, shade_7, shade_7, 1.0), _e16.y};
}

MarkPlace mark_place_axis(
    metal::float3 axis_1,
    metal::float3 normal_3,
    float angle_4,
    metal::float3 view_3,
    metal::float3 position_object,
    metal::float3x3 world_from_normal_1,
    float magnification_2
) {
    StretchedPlace _e7 = place_across(axis_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_4);
    return MarkPlace {_e7.place, {}, _e7.stretch};
}

MarkPlace mark_place_object(
    float angle_5,
    metal::float3 anchor,
    metal::float2 pixel_1,
    metal::float2 viewport_9
) {
    float size_6 = metal::clamp(anchor.z, 0.000001, 1000000.0);
    metal::float2 _e8 = place_in_picture(pixel_1, viewport_9);
    metal::float2 place_12 = (_e8 - metal::float2(anchor.x, -(anchor.y))) / metal::float2(size_6);
    StretchedPlace _e26 = mark_place_of_2_(place_12, metal::float3(1.0 / size_6, 0.0, 0.0), metal::float3(0.0, 1.0 / size_6, 0.0), angle_5);
    return MarkPlace {_e26.place, {}, _e26.stretch};
}

float reflectance_half_lambert(
    Light light,
    metal::float3 normal_4
) {
    float half_ = 0.5 + (0.5 * metal::dot(normal_4, light.direction));
    return metal::min(half_ * half_, 1.0);
}

float map_range(
    float value_6,
    float from_low,
    float from_high,
    float to_low,
    float to_high,
    bool clamped
) {
    return metal::mix(to_low, to_high, metal::clamp((value_6 - from_low) / (from_high - from_low), 0.0, 1.0));
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e3 = normalize_moderate(surface.smooth_normal_1_, surface.normal);
    Light _e6 = look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    float _e13 = map_range(_e7, 0.02, 0.2, 1.0, 0.0, true);
    metal::float3 _e16 = normalize_moderate(surface.smooth_normal_3_, surface.normal);
    MarkPlace _e26 = mark_place_axis(metal::float3(0.35, 1.0, 0.25), _e16, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    metal::float2 _e37 = look.viewport;
    BrushStrokes _e38 = brush_strokes_bristles(_e13, _e26.place, _e26.stretch, 14.0, 3.4, 1.8, 0.6, 0.5, 1, _e37);
    metal::float4 _e44 = look.umber_as_paint_b;
    metal::float4 _e48 = color_mixed(_e38.color, _e38.color.xyz * _e44.xyz, 1.0);
    metal::float4 _e51 = look.toned_canvas;
    metal::float4 _e52 = bounded_vec4_(_e48);
    metal::float4 _e57 = mixed_vec4_(_e51, _e52, metal::clamp(_e38.ink, 0.0, 1.0));
    metal::float3 _e61 = look.sky.direction;
    float reflected_light = metal::max(metal::dot(_e3, _e61), 0.0);
    float where_cool_reflections_go = metal::mix(1.0, 0.0, metal::clamp((reflected_light - 0.25) / 0.5, 0.0, 1.0));
    metal::float2 _e85 = look.viewport;
    BrushStrokes _e86 = brush_strokes_bristles_2_(where_cool_reflections_go, _e26.place, _e26.stretch, 18.0, 3.2, 1.5, 0.6, 0.5, 6, _e85);
    metal::float4 _e92 = look.cool_reflections_as_paint_b;
    metal::float4 _e96 = color_mixed(_e86.color, _e86.color.xyz * _e92.xyz, 1.0);
    Color _e98 = mix_colors_normal(_e57, _e96, _e86.ink);
    float _e104 = map_range(_e7, 0.24, 0.42, 1.0, 0.0, true);
    metal::float2 _e115 = look.viewport;
    BrushStrokes _e116 = brush_strokes_bristles_3_(_e104, _e26.place, _e26.stretch, 18.0, 3.2, 1.6, 0.6, 0.5, 2, _e115);
    metal::float4 _e122 = look.half_tones_as_paint_b;
    metal::float4 _e126 = color_mixed(_e116.color, _e116.color.xyz * _e122.xyz, 1.0);
    Color _e128 = mix_colors_normal(_e98, _e126, _e116.ink);
    float _e134 = map_range(_e7, 0.46, 0.66, 1.0, 0.0, true);
    metal::float2 _e140 = look.viewport;
    MarkPlace _e141 = mark_place_object(0.75, surface.anchor, surface.pixel, _e140);
    metal::float2 _e152 = look.viewport;
    BrushStrokes _e153 = brush_strokes_bristles_4_(_e134, _e141.place, _e141.stretch, 24.0, 3.0, 1.5, 0.6, 0.5, 3, _e152);
    metal::float4 _e159 = look.light_as_paint_b;
    metal::float4 _e163 = color_mixed(_e153.color, _e153.color.xyz * _e159.xyz, 1.0);
    Color _e165 = mix_colors_normal(_e128, _e163, _e153.ink);
    float _e171 = map_range(_e7, 0.76, 0.95, 1.0, 0.0, true);
    metal::float2 _e182 = look.viewport;
    BrushStrokes _e183 = brush_strokes_bristles_5_(_e171, _e141.place, _e141.stretch, 32.0, 2.6, 1.3, 0.6, 0.4, 4, _e182);
    metal::float4 _e189 = look.thick_lights_as_paint_b;
    metal::float4 _e193 = color_mixed(_e183.color, _e183.color.xyz * _e189.xyz, 1.0);
    Color _e195 = mix_colors_normal(_e165, _e193, _e183.ink);
    float hollows = surface.kappa;
    float where_accents_go = metal::mix(1.0, 0.0, metal::clamp((hollows + 6.0) / -14.0, 0.0, 1.0));
    metal::float2 _e217 = look.viewport;
    BrushStrokes _e218 = brush_strokes_bristles_6_(where_accents_go, _e26.place, _e26.stretch, 44.0, 3.4, 1.5, 0.6, 0.4, 8, _e217);
    metal::float4 _e224 = look.accents_as_paint_b;
    metal::float4 _e228 = color_mixed(_e218.color, _e218.color.xyz * _e224.xyz, 1.0);
    Color _e230 = mix_colors_normal(_e195, _e228, _e218.ink);
    metal::float4 output_alpha = metal::float4(_e230.xyz, metal::clamp(_e230.w, 0.0, 1.0));
    Composite _e237 = premultiplied(output_alpha);
    Color _e238 = output(_e237);
    return _e238;
}

struct vs_mainInput {
    metal::float3 position_1 [[attribute(0)]];
    metal::float3 normal_5 [[attribute(1)]];
};
struct vs_mainOutput {
    metal::float4 clip [[position]];
    metal::float3 position [[user(loc0), center_perspective]];
    metal::float3 position_object [[user(loc1), center_perspective]];
    metal::float3 normal [[user(loc2), center_perspective]];
};
vertex vs_mainOutput vs_main(
  vs_mainInput varyings [[stage_in]]
, constant View& view_4 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
) {
    const Vertex vertex_ = { varyings.position_1, varyings.normal_5 };
    metal::float4x4 _e3 = object.world_from_object;
    metal::float4 world = _e3 * metal::float4(vertex_.position, 1.0);
    metal::float4x4 _e10 = view_4.clip_from_world;
    metal::float3x3 _e16 = object.world_from_normal;
    const auto _tmp = Varyings {_e10 * world, world.xyz, vertex_.position, _e16 * vertex_.normal};
    return vs_mainOutput { _tmp.clip, _tmp.position, _tmp.position_object, _tmp.normal };
}


struct fs_mainInput {
    metal::float3 position_1 [[user(loc0), center_perspective]];
    metal::float3 position_object_1 [[user(loc1), center_perspective]];
    metal::float3 normal_5 [[user(loc2), center_perspective]];
};
struct fs_mainOutput {
    metal::float4 member_1 [[color(0)]];
};
fragment fs_mainOutput fs_main(
  fs_mainInput varyings_1 [[stage_in]]
, metal::float4 clip [[position]]
, bool is_front [[front_facing]]
, constant View& view_4 [[buffer(0)]]
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
, metal::texture2d<float, metal::access::sample> curvature_map [[texture(0)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_1_map [[texture(1)]]
, metal::texture2d<float, metal::access::sample> smooth_normal_3_map [[texture(2)]]
) {
    const Varyings in = { clip, varyings_1.position_1, varyings_1.position_object_1, varyings_1.normal_5 };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal_5 = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view_4.eye;
    float _e13 = view_4.eye.w;
    metal::float4 _e24 = curvature_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4 _e31 = smooth_normal_1_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e37 = view_4.camera_from_world;
    metal::float4 _e45 = smooth_normal_3_map.read(metal::uint2(naga_f2i32(in.clip.xy)), 0);
    metal::float4x4 _e51 = view_4.camera_from_world;
    metal::float4 _e58 = view_4.screen;
    metal::float4 _e63 = view_4.screen;
    metal::float4x4 _e68 = view_4.camera_from_world;
    metal::float4 _e72 = object.world_from_object[3];
    float _e81 = view_4.eye.w;
    float _e86 = view_4.clip_from_world[0].y;
    float _e91 = view_4.clip_from_world[1].y;
    float _e96 = view_4.clip_from_world[2].y;
    metal::float3 _e99 = anchor_on_screen((_e68 * metal::float4(_e72.xyz, 1.0)).xyz, _e81, metal::length(metal::float3(_e86, _e91, _e96)));
    metal::float4x4 _e102 = view_4.camera_from_world;
    float _e112 = view_4.eye.w;
    float _e117 = view_4.clip_from_world[0].y;
    float _e122 = view_4.clip_from_world[1].y;
    float _e127 = view_4.clip_from_world[2].y;
    float _e130 = size_on_screen(-((_e102 * metal::float4(in.position, 1.0)).z), _e112, metal::length(metal::float3(_e117, _e122, _e127)));
    metal::float3x3 _e133 = object.world_from_normal;
    Surface surface_1 = Surface {normal_5, metal::normalize(_e8.xyz - (_e13 * in.position)), in.position_object, _e24.x, (metal::float4(_e31.xyz, 0.0) * _e37).xyz, (metal::float4(_e45.xyz, 0.0) * _e51).xyz, (in.clip.xy * _e58.xy) + _e63.zw, {}, _e99, _e130, _e133};
    metal::float4 _e135 = shade(surface_1, look);
    metal::float4 _e136 = finite_vec4_(_e135);
    return fs_mainOutput { _e136 };
}
