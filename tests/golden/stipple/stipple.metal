// Stipple: made by Chiaro 0.1.0, Metal Shading Language 2.0.
// Draws a mesh with the look; the result is straight RGBA.
// Arguments of both functions: view buffer(0), object buffer(1), look buffer(2).
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
struct type_9 {
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
constant float MOST_ON_SCREEN = 1000000000000000.0;
constant type_9 BLUE_TILE = type_9 {{667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u}};

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
    int exponent = as_type<int>(bits - 1060439283u) >> 23u;
    float mantissa = as_type<float>(bits - (as_type<uint>(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2_ = z * z;
    return static_cast<float>(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379)))))));
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

float bounded(
    float x_2
) {
    uint bits_1 = as_type<uint>(x_2);
    uint magnitude = bits_1 & 2147483647u;
    float largest = as_type<float>((bits_1 & 2147483648u) | 2139095039u);
    return (magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0);
}

float eased(
    float x_3,
    float low,
    float high
) {
    float _e3 = bounded(x_3);
    float _e7 = bounded((_e3 - low) / 0.75);
    float t = metal::clamp(_e7, 0.0, 1.0);
    return (t * t) * (3.0 - (2.0 * t));
}

metal::uint3 hash_pcg3d(
    metal::uint3 seed
) {
    metal::uint3 v_2 = {};
    v_2 = (seed * 1664525u) + metal::uint3(1013904223u);
    uint _e8 = v_2.x;
    uint _e10 = v_2.y;
    uint _e12 = v_2.z;
    v_2.x = _e8 + (_e10 * _e12);
    uint _e16 = v_2.y;
    uint _e18 = v_2.z;
    uint _e20 = v_2.x;
    v_2.y = _e16 + (_e18 * _e20);
    uint _e24 = v_2.z;
    uint _e26 = v_2.x;
    uint _e28 = v_2.y;
    v_2.z = _e24 + (_e26 * _e28);
    metal::uint3 _e31 = v_2;
    metal::uint3 _e32 = v_2;
    v_2 = _e31 ^ (_e32 >> metal::uint3(16u));
    uint _e38 = v_2.x;
    uint _e40 = v_2.y;
    uint _e42 = v_2.z;
    v_2.x = _e38 + (_e40 * _e42);
    uint _e46 = v_2.y;
    uint _e48 = v_2.z;
    uint _e50 = v_2.x;
    v_2.y = _e46 + (_e48 * _e50);
    uint _e54 = v_2.z;
    uint _e56 = v_2.x;
    uint _e58 = v_2.y;
    v_2.z = _e54 + (_e56 * _e58);
    metal::uint3 _e61 = v_2;
    return _e61;
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
    float d,
    float r,
    float w
) {
    if (w < 0.000000000000000000000000000001) {
        return ((d <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    float square_1 = r * r;
    float least = (w * w) / 3.0;
    float inner = metal::sqrt(metal::max(square_1, least) - (0.25 * least));
    return metal::clamp(0.5 + ((inner - d) / w), 0.0, 1.0) * metal::min(square_1 / least, 1.0);
}

uint blue_index(
    metal::int2 cell
) {
    metal::uint2 at_1 = as_type<metal::uint2>(cell) & metal::uint2(31u);
    return (8u * at_1.y) + (at_1.x >> 2u);
}

StretchedPlace mark_place_of(
    metal::float2 place,
    metal::float3 along,
    metal::float3 across,
    float angle
) {
    metal::float2 turn = metal::float2(0.0, 1.0);
    metal::float3 x_4 = (turn.y * along) + (turn.x * across);
    metal::float3 y = (turn.y * across) - (turn.x * along);
    metal::float2 turned = metal::float2((turn.y * place.x) + (turn.x * place.y), (turn.y * place.y) - (turn.x * place.x));
    metal::float3 stretch_4 = metal::float3(metal::dot(x_4, x_4), metal::dot(x_4, y), metal::dot(y, y));
    return StretchedPlace {turned, {}, stretch_4};
}

SpacedPlace spaced(
    metal::float2 place_1,
    metal::float3 stretch,
    metal::float2 viewport_1,
    float count
) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = is_pixel ? (count / metal::max(viewport_1.y, 1.0)) : count;
    metal::float2 p = metal::clamp(place_1 * scale_2, metal::float2(-4194304.0), metal::float2(4194304.0));
    return SpacedPlace {p, {}, is_pixel ? metal::float3(1.0, 0.0, 1.0) : stretch};
}

float area_square(
    metal::float3 stretch_1
) {
    float sum_1 = stretch_1.x + stretch_1.z;
    return metal::max((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y), (sum_1 * sum_1) / 66.0);
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
    float w_1,
    Dots style
) {
    int i = 0;
    float sum = 0.0;
    type_9 tile = BLUE_TILE;
    metal::float2 p_1 = metal::clamp(place_2 * as_type<float>(static_cast<uint>(as_type<int>(as_type<uint>(zoom) + as_type<uint>(127))) << 23u), metal::float2(-4194304.0), metal::float2(4194304.0));
    metal::float2 corner = metal::floor(p_1);
    float reach = 1.0 - (0.5 * style.scatter);
    uint2 loop_bound = uint2(4294967295u);
    bool loop_init = true;
    while(true) {
        if (metal::all(loop_bound == uint2(0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e118 = i;
            i = as_type<int>(as_type<uint>(_e118) + as_type<uint>(1));
        }
        loop_init = false;
        int _e30 = i;
        if (!((_e30 < 9))) {
            break;
        }
        int _e35 = i;
        int _e40 = i;
        metal::int2 cell_1 = as_type<metal::int2>(as_type<metal::uint2>(naga_f2i32(corner)) + as_type<metal::uint2>(metal::int2(as_type<int>(as_type<uint>(naga_mod(_e35, 3)) - as_type<uint>(1)), as_type<int>(as_type<uint>(naga_div(_e40, 3)) - as_type<uint>(1)))));
        metal::uint3 _e54 = hash_pcg3d(as_type<metal::uint3>(metal::int3(cell_1, zoom)) + metal::uint3(0u, 0u, 0u));
        metal::float3 chance = static_cast<metal::float3>(_e54 >> metal::uint3(8u)) * 0.000000059604645;
        metal::float2 middle = (static_cast<metal::float2>(cell_1) + metal::float2(0.5)) + (style.scatter * (chance.xy - metal::float2(0.5)));
        metal::float2 offset_1 = p_1 - middle;
        metal::int2 turning = as_type<metal::int2>(as_type<metal::uint2>(cell_1) + as_type<metal::uint2>(metal::int2(0, as_type<int>(as_type<uint>(zoom) * as_type<uint>(7)))));
        uint _e78 = blue_index(turning);
        uint _e80 = tile.inner[_e78];
        float turn_1 = 0.96875 * ((static_cast<float>((_e80 >> (8u * (as_type<uint>(turning.x) & 3u))) & 255u) + 0.5) * 0.00390625);
        float grown = metal::clamp((ink - turn_1) * 32.0, 0.0, 1.0);
        float radius = (0.5 * style.size) * metal::sqrt(grown);
        float far = metal::length(offset_1) / reach;
        float _e110 = picture_square(offset_1, stretch_3);
        float d_1 = metal::max(metal::sqrt(_e110), (far * far) * radius);
        float _e115 = sum;
        float _e116 = disk_filtered(d_1, radius, w_1);
        sum = metal::max(_e115, _e116);
    }
    float _e121 = sum;
    return _e121;
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
    float _e15 = area_square(at.stretch);
    float _e19 = log2_stable(metal::max(metal::sqrt(_e15), 0.000000000000000000000000000001));
    float level = metal::clamp(-0.5 * _e19, -16.0, 16.0);
    float zoom_1 = metal::floor(level);
    float f_1 = level - zoom_1;
    float _e29 = exp2_stable(-2.0 * f_1);
    float coarse = 1.0 - f_1;
    float fine = (1.0 - (coarse * _e29)) / (4.0 * _e29);
    float _e44 = exp2_stable(2.0 * zoom_1);
    float _e46 = dots_of_octave(at.place, naga_f2i32(zoom_1), ink_1 * coarse, at.stretch * _e44, _e13, style_1);
    dots = _e46;
    if (fine > 0.0) {
        float _e60 = exp2_stable((2.0 * zoom_1) + 2.0);
        float _e62 = dots_of_octave(at.place, as_type<int>(as_type<uint>(naga_f2i32(zoom_1)) + as_type<uint>(1)), ink_1 * fine, at.stretch * _e60, _e13, style_1);
        float _e63 = dots;
        dots = metal::max(_e63, _e62);
    }
    float mean = ink_1 * ((0.7853982 * style_1.size) * style_1.size);
    float _e71 = dots;
    float _e74 = eased(_e13, 0.75, 1.5);
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
    metal::float2 place_3 = (_e8 - metal::float2(anchor.x, -(anchor.y))) / metal::float2(size);
    StretchedPlace _e26 = mark_place_of(place_3, metal::float3(1.0 / size, 0.0, 0.0), metal::float3(0.0, 1.0 / size, 0.0), angle_1);
    return MarkPlace {_e26.place, {}, _e26.stretch};
}

metal::float4 shade(
    Surface surface,
    constant Look& look
) {
    metal::float3 _e5 = look.key.direction;
    float light_and_shade = metal::max((metal::dot(surface.normal, _e5) + 0.3) / 1.3, 0.0);
    float facing = metal::clamp(metal::dot(surface.normal, surface.view), 0.0, 1.0);
    float darker_at_the_rim = metal::min((facing - 0.0) / 0.55, 1.0);
    float tone_to_draw = metal::min(((light_and_shade * darker_at_the_rim) - 0.0) / 0.85, 1.0);
    metal::float2 _e37 = look.viewport;
    MarkPlace _e38 = mark_place_object(0.0, surface.anchor, surface.pixel, _e37);
    metal::float2 _e43 = look.viewport;
    SpacedPlace _e45 = spaced(_e38.place, _e38.stretch, _e43, 210.0);
    float _e52 = stippled(_e45, 1.0 - tone_to_draw, Dots {0.85, 0.8, 0u});
    metal::float4 ink_on_paper = metal::mix(metal::float4(0.965, 0.95, 0.915, 1.0), metal::float4(0.09, 0.12, 0.22, 1.0), _e52);
    return ink_on_paper;
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
, constant Object& object [[buffer(1)]]
, constant Look& look [[buffer(2)]]
) {
    const Varyings in = { clip, varyings_1.position, varyings_1.normal };
    metal::float3 _e3 = normalize_seen(in.normal);
    metal::float3 normal = is_front ? _e3 : -(_e3);
    metal::float4 _e8 = view.eye;
    float _e13 = view.eye.w;
    metal::float4 _e22 = view.screen;
    metal::float4 _e27 = view.screen;
    metal::float4x4 _e32 = view.camera_from_world;
    metal::float4 _e36 = object.world_from_object[3];
    float _e45 = view.eye.w;
    float _e50 = view.clip_from_world[0].y;
    float _e55 = view.clip_from_world[1].y;
    float _e60 = view.clip_from_world[2].y;
    metal::float3 _e63 = anchor_on_screen((_e32 * metal::float4(_e36.xyz, 1.0)).xyz, _e45, metal::length(metal::float3(_e50, _e55, _e60)));
    Surface surface_1 = Surface {normal, metal::normalize(_e8.xyz - (_e13 * in.position)), (in.clip.xy * _e22.xy) + _e27.zw, {}, _e63};
    metal::float4 _e65 = shade(surface_1, look);
    return fs_mainOutput { _e65 };
}
