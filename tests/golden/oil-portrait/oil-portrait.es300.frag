#version 300 es
// Oil portrait: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0, u_smooth_normal_1_map 1, u_smooth_normal_3_map 2.
// oil-portrait.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    vec4 toned_canvas;
    vec2 viewport;
    vec4 accents_as_paint_b;
    Light sky;
    vec4 cool_reflections_as_paint_b;
    Light key;
    vec4 thick_lights_as_paint_b;
    vec4 light_as_paint_b;
    vec4 half_tones_as_paint_b;
    vec4 umber_as_paint_b;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    float kappa;
    vec3 smooth_normal_1_;
    vec3 smooth_normal_3_;
    vec2 pixel;
    vec3 anchor;
    float magnification;
    mat3x3 world_from_normal;
};
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct Brush {
    float aspect;
    float size;
    float scatter;
    float turn;
    uint seed;
    bool is_dark;
};
struct Brushstroke {
    vec2 uv;
    vec2 turn;
    float way;
    float share;
};
struct BrushStrokes {
    vec4 color;
    float ink;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint BLUE_TILE[256] = uint[256](667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

uniform highp sampler2D u_smooth_normal_1_map;

uniform highp sampler2D u_smooth_normal_3_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise) {
    bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

vec3 finite_vec3_(vec3 v) {
    float _e3 = finite_or(v.x, 0.0);
    float _e6 = finite_or(v.y, 0.0);
    float _e9 = finite_or(v.z, 0.0);
    return vec3(_e3, _e6, _e9);
}

vec4 finite_vec4_(vec4 v_1) {
    vec3 _e2 = finite_vec3_(v_1.xyz);
    float _e5 = finite_or(v_1.w, 0.0);
    return vec4(_e2, _e5);
}

vec3 normalize_or(vec3 v_2, vec3 otherwise_1) {
    bool local = false;
    float largest = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest > 1e-30)) {
        local = (largest < 1e30);
    } else {
        local = false;
    }
    bool _e17 = local;
    if (!(_e17)) {
        return otherwise_1;
    }
    vec3 scaled = (v_2 * (1.0 / largest));
    float square_1 = dot(scaled, scaled);
    bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square_1)));
}

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p_1 * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent = ((shift >= 256) ? (shift - 512) : shift);
    float mantissa = uintBitsToFloat((bits - (uint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent) * LN_2_) + series);
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

vec2 sin_cos(float x_5) {
    float turns = roundEven((x_5 * 0.31830987));
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    vec2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

float bounded(float x_6) {
    uint bits_1 = floatBitsToUint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

vec2 bounded_vec2_(vec2 v_3) {
    float _e2 = bounded(v_3.x);
    float _e4 = bounded(v_3.y);
    return vec2(_e2, _e4);
}

vec3 bounded_vec3_(vec3 v_4) {
    float _e2 = bounded(v_4.x);
    float _e4 = bounded(v_4.y);
    float _e6 = bounded(v_4.z);
    return vec3(_e2, _e4, _e6);
}

vec4 bounded_vec4_(vec4 v_5) {
    float _e2 = bounded(v_5.x);
    float _e4 = bounded(v_5.y);
    float _e6 = bounded(v_5.z);
    float _e8 = bounded(v_5.w);
    return vec4(_e2, _e4, _e6, _e8);
}

float mixed(float a, float b, float t) {
    float _e4 = bounded((b - a));
    float _e14 = bounded(((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4))));
    return _e14;
}

vec3 mixed_vec3_(vec3 a_1, vec3 b_1, float t_1) {
    float _e5 = mixed(a_1.x, b_1.x, t_1);
    float _e8 = mixed(a_1.y, b_1.y, t_1);
    float _e11 = mixed(a_1.z, b_1.z, t_1);
    return vec3(_e5, _e8, _e11);
}

vec4 mixed_vec4_(vec4 a_2, vec4 b_2, float t_2) {
    vec3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_2);
    float _e8 = mixed(a_2.w, b_2.w, t_2);
    return vec4(_e5, _e8);
}

float place_between(float x_7, float low, float high) {
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    float _e12 = bounded(span);
    float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped) {
    float _e6 = bounded(x_8);
    float _e7 = bounded(from_low);
    float _e8 = bounded(from_high);
    float _e9 = place_between(_e6, _e7, _e8);
    float _e10 = bounded(to_low);
    float _e11 = bounded(to_high);
    float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1) {
    float _e3 = bounded(x_9);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float factor_of(float x_10, bool clamped_1) {
    float _e2 = bounded(x_10);
    float _e3 = bounded(x_10);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

vec2 sin_cos_of(float x_11) {
    float _e1 = bounded(x_11);
    vec2 _e2 = sin_cos(_e1);
    return clamp(_e2, vec2(-1.0), vec2(1.0));
}

vec4 color_mixed(vec4 a_3, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_3.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    vec3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_3.w);
    return vec4(_e8, _e10);
}

float unit_share(float share) {
    return clamp(share, 0.0, 1.0);
}

vec4 with_unit_alpha(vec4 color) {
    float _e3 = unit_share(color.w);
    return vec4(color.xyz, _e3);
}

vec4 premultiplied(vec4 color_1) {
    return vec4((color_1.xyz * color_1.w), color_1.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 mix_colors_normal(vec4 a_4, vec4 b_3, float factor_1) {
    vec4 _e3 = bounded_vec4_(a_4);
    vec4 _e4 = bounded_vec4_(b_3);
    float _e6 = factor_of(factor_1, true);
    vec4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

vec4 mix_colors_multiply(vec4 a_5, vec4 b_4, float factor_2) {
    vec4 _e6 = color_mixed(a_5, (a_5.xyz * b_4.xyz), factor_2);
    return _e6;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float kappa_surface(float kappa_1) {
    float _e1 = kappa_safe(kappa_1);
    return _e1;
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 _e6 = normalize_or(toward, vec3(0.0, 0.0, 1.0));
    vec3 _e11 = normalize_or(up, vec3(0.0, 1.0, 0.0));
    vec3 leaning = cross(_e11, _e6);
    float square_2 = dot(leaning, leaning);
    vec3 aside = ((abs(_e6.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across_2 = ((square_2 > 1e-8) ? leaning : cross(aside, _e6));
    vec3 _e38 = normalize_or((across_2 - (dot(across_2, _e6) * _e6)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e38, cross(_e6, _e38), _e6);
}

vec4 output_(vec4 color_2) {
    vec4 _e1 = straight(color_2);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_6 = uvec3(0u);
    v_6 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_6.x;
    uint _e10 = v_6.y;
    uint _e12 = v_6.z;
    v_6.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_6.y;
    uint _e18 = v_6.z;
    uint _e20 = v_6.x;
    v_6.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_6.z;
    uint _e26 = v_6.x;
    uint _e28 = v_6.y;
    v_6.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_6;
    uvec3 _e32 = v_6;
    v_6 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_6.x;
    uint _e40 = v_6.y;
    uint _e42 = v_6.z;
    v_6.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_6.y;
    uint _e48 = v_6.z;
    uint _e50 = v_6.x;
    v_6.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_6.z;
    uint _e56 = v_6.x;
    uint _e58 = v_6.y;
    v_6.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_6;
    return _e61;
}

vec3 unit_of_hash(uvec3 hash) {
    return (vec3((hash >> uvec3(8u))) * 5.9604645e-8);
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float size_on_screen(float depth, float perspective, float scale) {
    float _e10 = bounded(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)));
    return _e10;
}

vec3 anchor_on_screen(vec3 origin, float perspective_1, float scale_1) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    vec3 _e12 = bounded_vec3_(vec3((origin.x * _e5), (-(origin.y) * _e5), _e5));
    return _e12;
}

vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 _e2 = bounded_vec2_(pixel);
    vec2 from_middle = (_e2 - (0.5 * viewport));
    return (vec2(from_middle.x, -(from_middle.y)) / vec2(max(viewport.y, 1.0)));
}

uint blue_index(ivec2 cell_1) {
    uvec2 at_1 = (uvec2(cell_1) & uvec2(31u));
    return ((8u * at_1.y) + (at_1.x >> 2u));
}

float blue_part(uint four, ivec2 cell_2) {
    return ((float(((four >> (8u * (uint(cell_2.x) & 3u))) & 255u)) + 0.5) * 0.00390625);
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 _e4 = sin_cos_of(angle);
    vec3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    vec3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    vec2 _e17 = bounded_vec2_(place);
    vec2 turned = vec2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    vec3 most = vec3(1000000000000000.0);
    vec3 stretch_3 = clamp(vec3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    vec2 _e41 = bounded_vec2_(turned);
    return StretchedPlace(_e41, stretch_3);
}

vec3 gradient_on_picture(vec3 g, vec3 normal, vec3 view) {
    float facing = dot(normal, view);
    return (g - (normal * (dot(g, view) / ((facing >= 0.0) ? max(facing, 0.125) : min(facing, -0.125)))));
}

StretchedPlace place_on_surface(vec2 place_1, vec3 along_1, vec3 across_1, vec3 normal_1, vec3 view_1, float magnification, float angle_1) {
    vec3 _e11 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    vec3 _e16 = normalize_or(view_1, vec3(0.0, 0.0, 1.0));
    float _e17 = bounded(magnification);
    float height = (1.0 / clamp(_e17, 1e-15, 1000000000000000.0));
    vec3 _e23 = gradient_on_picture(along_1, _e11, _e16);
    vec3 _e25 = bounded_vec3_((_e23 * height));
    vec3 _e26 = gradient_on_picture(across_1, _e11, _e16);
    vec3 _e28 = bounded_vec3_((_e26 * height));
    vec2 _e29 = bounded_vec2_(place_1);
    StretchedPlace _e30 = mark_place_of(_e29, _e25, _e28, angle_1);
    return _e30;
}

StretchedPlace place_across(vec3 axis, vec3 position, mat3x3 world_from_normal, vec3 normal_2, vec3 view_2, float magnification_1, float angle_2) {
    mat3x3 _e11 = axes_around(axis, vec3(0.0, 1.0, 0.0));
    vec3 _e12 = bounded_vec3_(position);
    vec2 place_4 = vec2(dot(_e12, _e11[0]), dot(_e12, _e11[2]));
    vec3 _e20 = bounded_vec3_((world_from_normal * _e11[0]));
    vec3 _e23 = bounded_vec3_((world_from_normal * _e11[2]));
    StretchedPlace _e24 = place_on_surface(place_4, _e20, _e23, normal_2, view_2, magnification_1, angle_2);
    return _e24;
}

SpacedPlace spaced(vec2 place_2, vec3 stretch, vec2 viewport_1, float count) {
    float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    vec2 _e19 = bounded_vec2_(place_2);
    vec2 _e21 = bounded_vec2_((_e19 * scale_2));
    vec2 p_2 = clamp(_e21, vec2(-4194304.0), vec2(4194304.0));
    vec3 _e27 = bounded_vec3_(stretch);
    vec3 s_1 = clamp(_e27, vec3(-1000000000000000.0), vec3(1000000000000000.0));
    return SpacedPlace(p_2, (is_pixel ? vec3(1.0, 0.0, 1.0) : s_1));
}

float area_square(vec3 stretch_1) {
    float sum = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum * sum) / 66.0));
}

float octave_of(float square) {
    float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

Brush brush_of(float aspect, float size, float scatter, float turn, int seed_2, bool is_dark) {
    float _e6 = bounded(aspect);
    float _e10 = bounded(size);
    float _e14 = bounded(scatter);
    float _e18 = bounded(turn);
    return Brush(clamp(_e6, 1.0, 16.0), clamp(_e10, 0.1, 2.0), clamp(_e14, 0.0, 1.0), clamp(_e18, 0.0, 6.2831855), uint(seed_2), is_dark);
}

vec2 brush_turned(vec2 step_, Brushstroke stroke, Brush style) {
    vec2 turned_1 = vec2(((stroke.turn.y * step_.x) + (stroke.turn.x * step_.y)), ((stroke.turn.y * step_.y) - (stroke.turn.x * step_.x)));
    return (turned_1 * vec2((stroke.way / (style.size * style.aspect)), (-1.0 / style.size)));
}

Brushstroke brush_stroke(vec2 p, ivec2 cell_3, int zoom, float drawn, Brush style_1) {
    uvec3 _e7 = lattice_hash(ivec3(cell_3, zoom), style_1.seed);
    vec3 _e8 = unit_of_hash(_e7);
    vec2 offset = (p - ((vec2(cell_3) + vec2(0.5)) + (style_1.scatter * (_e8.xy - vec2(0.5)))));
    vec2 _e26 = sin_cos_of((style_1.turn * (_e8.z - 0.5)));
    uvec3 _e31 = lattice_hash(ivec3(cell_3, zoom), (style_1.seed + 1u));
    vec3 _e32 = unit_of_hash(_e31);
    float way = ((_e32.x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_1 = Brushstroke(vec2(0.5), _e26, way, 0.0);
    vec2 _e47 = brush_turned((offset * vec2(style_1.aspect, 1.0)), stroke_1, style_1);
    vec2 uv_1 = (vec2(0.5) + _e47);
    vec2 from_edge = min(uv_1, (vec2(1.0) - uv_1));
    float inside = clamp((64.0 * min(from_edge.x, from_edge.y)), 0.0, 1.0);
    float far = (max(abs(offset.x), abs(offset.y)) / (1.0 - (0.5 * style_1.scatter)));
    float _e77 = eased(far, 0.85, 1.0);
    float share_1 = ((drawn * inside) * (1.0 - _e77));
    return Brushstroke(uv_1, _e26, way, share_1);
}

vec3 bristle(float row, uint seed_3) {
    float first = floor(row);
    float t_4 = (row - first);
    uvec3 _e8 = lattice_hash(ivec3(int(first), 0, 0), seed_3);
    vec3 _e9 = unit_of_hash(_e8);
    uvec3 _e16 = lattice_hash(ivec3((int(first) + 1), 0, 0), seed_3);
    vec3 _e17 = unit_of_hash(_e16);
    return mix(_e9, _e17, ((t_4 * t_4) * (3.0 - (2.0 * t_4))));
}

vec2 bristles(vec2 uv, float width, uint seed_4) {
    float across_3 = ((2.0 * uv.y) - 1.0);
    uvec3 _e12 = lattice_hash(ivec3(0, 1, 0), seed_4);
    vec3 _e13 = unit_of_hash(_e12);
    float seen = clamp((1.75 - (11.0 * width)), 0.0, 1.0);
    vec3 _e26 = bristle((11.0 * uv.y), seed_4);
    vec3 chance = mix(vec3(0.5), _e26, seen);
    float start = ((0.03 + (0.12 * chance.x)) + ((0.09 * across_3) * across_3));
    float end = ((0.97 - ((0.1 + (0.25 * _e13.y)) * chance.y)) - ((0.12 * across_3) * across_3));
    float _e53 = eased(uv.x, start, (start + 0.05));
    float _e57 = eased(uv.x, (end - 0.1), end);
    float along_2 = (_e53 * (1.0 - _e57));
    float _e64 = eased(abs(across_3), 0.78, 0.95);
    float side = (1.0 - _e64);
    float _e74 = eased((uv.x + (0.55 * chance.z)), 0.85, 1.25);
    float shade_1 = (((0.8 + (0.16 * _e13.z)) + (0.208 * (chance.z - 0.5))) - (0.05 * uv.x));
    return vec2(clamp(shade_1, 0.0, 1.0), ((along_2 * side) * (1.0 - (0.9 * _e74))));
}

vec2 bristles_laid(SpacedPlace at, float ink, Brush style_2) {
    uint tile[256] = BLUE_TILE;
    vec2 paint = vec2(0.0);
    int octave = 0;
    int i = 0;
    vec2 dx = dFdx(at.place);
    vec2 dy = dFdy(at.place);
    float _e8 = area_square(at.stretch);
    float _e10 = octave_of(sqrt(_e8));
    float zoom_1 = floor(_e10);
    float f_1 = (_e10 - zoom_1);
    float _e15 = exp2_stable((-2.0 * f_1));
    float fine = ((1.0 - ((1.0 - f_1) * _e15)) / (4.0 * _e15));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e156 = octave;
            octave = (_e156 + 1);
        }
        loop_init = false;
        int _e31 = octave;
        if ((_e31 < 2)) {
        } else {
            break;
        }
        {
            int _e36 = octave;
            float amount = (ink * ((_e36 == 1) ? fine : (1.0 - f_1)));
            int _e42 = octave;
            float _e44 = power_of_two((int(zoom_1) + _e42));
            vec2 p_3 = (clamp((at.place * _e44), vec2(-4194304.0), vec2(4194304.0)) / vec2(style_2.aspect, 1.0));
            ivec2 corner = ivec2(floor(p_3));
            ivec2 phase = (((corner % ivec2(3)) + ivec2(3)) % ivec2(3));
            i = 0;
            bool loop_init_1 = true;
            while(true) {
                if (!loop_init_1) {
                    int _e153 = i;
                    i = (_e153 + 1);
                }
                loop_init_1 = false;
                int _e69 = i;
                if ((_e69 < 9)) {
                } else {
                    break;
                }
                {
                    int _e72 = i;
                    int _e75 = i;
                    ivec2 cell_4 = ((corner + (((ivec2((_e72 % 3), (_e75 / 3)) - phase) + ivec2(4)) % ivec2(3))) - ivec2(1));
                    int _e95 = octave;
                    ivec2 turning = (cell_4 + ivec2(int((style_2.seed & 31u)), (7 * (int(zoom_1) + _e95))));
                    uint _e101 = blue_index(turning);
                    uint _e103 = tile[_e101];
                    float _e104 = blue_part(_e103, turning);
                    float late = (0.96875 * _e104);
                    float share_2 = clamp(((amount - late) * 32.0), 0.0, 1.0);
                    if ((share_2 <= 0.0)) {
                        continue;
                    }
                    int _e116 = octave;
                    Brushstroke _e118 = brush_stroke(p_3, cell_4, (int(zoom_1) + _e116), share_2, style_2);
                    if ((_e118.share > 0.0)) {
                        vec2 _e123 = brush_turned((dx * _e44), _e118, style_2);
                        vec2 _e125 = brush_turned((dy * _e44), _e118, style_2);
                        int _e127 = octave;
                        uvec3 _e133 = lattice_hash(ivec3(cell_4, (int(zoom_1) + _e127)), (style_2.seed + 2u));
                        uint own = _e133.x;
                        vec2 _e140 = bristles(_e118.uv, length(vec2(_e123.y, _e125.y)), own);
                        float cover = (_e118.share * _e140.y);
                        vec2 _e147 = paint;
                        paint = (vec2((_e140.x * cover), cover) + (_e147 * (1.0 - cover)));
                    }
                }
            }
        }
    }
    vec2 _e158 = paint;
    return _e158;
}

BrushStrokes brush_strokes_bristles(float value, vec2 place_3, vec3 stretch_2, float count_1, float aspect_1, float size_1, float scatter_1, float turn_1, int seed_5, vec2 viewport_2) {
    SpacedPlace _e10 = spaced(place_3, stretch_2, viewport_2, count_1);
    Brush _e12 = brush_of(aspect_1, size_1, scatter_1, turn_1, seed_5, false);
    float _e14 = factor_of(value, true);
    vec2 _e17 = bristles_laid(_e10, (1.0 - _e14), _e12);
    float shade_2 = (_e17.x / max(_e17.y, 0.001));
    return BrushStrokes(vec4(shade_2, shade_2, shade_2, 1.0), _e17.y);
}

MarkPlace mark_place_axis(vec3 axis_1, vec3 normal_3, float angle_3, vec3 view_3, vec3 position_object, mat3x3 world_from_normal_1, float magnification_2) {
    StretchedPlace _e7 = place_across(axis_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_3);
    return MarkPlace(_e7.place, _e7.stretch);
}

MarkPlace mark_place_object(float angle_4, vec3 anchor, vec2 pixel_1, vec2 viewport_3) {
    float _e5 = bounded(anchor.z);
    float size_2 = clamp(_e5, 1e-6, 1000000.0);
    vec2 _e9 = place_in_picture(pixel_1, viewport_3);
    vec2 _e15 = bounded_vec2_((_e9 - vec2(anchor.x, -(anchor.y))));
    vec2 place_5 = (_e15 / vec2(size_2));
    StretchedPlace _e28 = mark_place_of(place_5, vec3((1.0 / size_2), 0.0, 0.0), vec3(0.0, (1.0 / size_2), 0.0), angle_4);
    return MarkPlace(_e28.place, _e28.stretch);
}

float reflectance_lambert(Light light, vec3 normal_4) {
    vec3 _e6 = normalize_or(normal_4, vec3(0.0, 0.0, 1.0));
    return max(dot(_e6, light.direction), 0.0);
}

float reflectance_half_lambert(Light light_1, vec3 normal_5) {
    vec3 _e6 = normalize_or(normal_5, vec3(0.0, 0.0, 1.0));
    float half_ = (0.5 + (0.5 * dot(_e6, light_1.direction)));
    return clamp((half_ * half_), 0.0, 1.0);
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2) {
    float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

vec3 smooth_normal_fine(vec3 normal_6, vec3 smooth_1_) {
    vec3 _e2 = normalize_or(smooth_1_, normal_6);
    return _e2;
}

vec3 smooth_normal_medium(vec3 normal_7, vec3 smooth_3_) {
    vec3 _e2 = normalize_or(smooth_3_, normal_7);
    return _e2;
}

vec4 shade(Surface surface_1) {
    vec3 _e3 = smooth_normal_fine(surface_1.normal, surface_1.smooth_normal_1_);
    Light _e6 = u_look.key;
    float _e7 = reflectance_half_lambert(_e6, _e3);
    float _e13 = map_range(_e7, 0.02, 0.2, 1.0, 0.0, true);
    vec3 _e16 = smooth_normal_medium(surface_1.normal, surface_1.smooth_normal_3_);
    MarkPlace _e26 = mark_place_axis(vec3(0.35, 1.0, 0.25), _e16, 0.0, surface_1.view, surface_1.position_object, surface_1.world_from_normal, surface_1.magnification);
    vec2 _e37 = u_look.viewport;
    BrushStrokes _e38 = brush_strokes_bristles(_e13, _e26.place, _e26.stretch, 14.0, 3.4, 1.8, 0.6, 0.5, 1, _e37);
    vec4 _e42 = u_look.umber_as_paint_b;
    vec4 _e44 = mix_colors_multiply(_e38.color, _e42, 1.0);
    vec4 _e47 = u_look.toned_canvas;
    vec4 _e49 = mix_colors_normal(_e47, _e44, _e38.ink);
    Light _e52 = u_look.sky;
    float _e53 = reflectance_lambert(_e52, _e3);
    float _e59 = map_range(_e53, 0.25, 0.75, 1.0, 0.0, true);
    vec2 _e70 = u_look.viewport;
    BrushStrokes _e71 = brush_strokes_bristles(_e59, _e26.place, _e26.stretch, 18.0, 3.2, 1.5, 0.6, 0.5, 6, _e70);
    vec4 _e75 = u_look.cool_reflections_as_paint_b;
    vec4 _e77 = mix_colors_multiply(_e71.color, _e75, 1.0);
    vec4 _e79 = mix_colors_normal(_e49, _e77, _e71.ink);
    float _e85 = map_range(_e7, 0.24, 0.42, 1.0, 0.0, true);
    vec2 _e96 = u_look.viewport;
    BrushStrokes _e97 = brush_strokes_bristles(_e85, _e26.place, _e26.stretch, 18.0, 3.2, 1.6, 0.6, 0.5, 2, _e96);
    vec4 _e101 = u_look.half_tones_as_paint_b;
    vec4 _e103 = mix_colors_multiply(_e97.color, _e101, 1.0);
    vec4 _e105 = mix_colors_normal(_e79, _e103, _e97.ink);
    float _e111 = map_range(_e7, 0.46, 0.66, 1.0, 0.0, true);
    vec2 _e117 = u_look.viewport;
    MarkPlace _e118 = mark_place_object(0.75, surface_1.anchor, surface_1.pixel, _e117);
    vec2 _e129 = u_look.viewport;
    BrushStrokes _e130 = brush_strokes_bristles(_e111, _e118.place, _e118.stretch, 24.0, 3.0, 1.5, 0.6, 0.5, 3, _e129);
    vec4 _e134 = u_look.light_as_paint_b;
    vec4 _e136 = mix_colors_multiply(_e130.color, _e134, 1.0);
    vec4 _e138 = mix_colors_normal(_e105, _e136, _e130.ink);
    float _e144 = map_range(_e7, 0.76, 0.95, 1.0, 0.0, true);
    vec2 _e155 = u_look.viewport;
    BrushStrokes _e156 = brush_strokes_bristles(_e144, _e118.place, _e118.stretch, 32.0, 2.6, 1.3, 0.6, 0.4, 4, _e155);
    vec4 _e160 = u_look.thick_lights_as_paint_b;
    vec4 _e162 = mix_colors_multiply(_e156.color, _e160, 1.0);
    vec4 _e164 = mix_colors_normal(_e138, _e162, _e156.ink);
    float _e166 = kappa_surface(surface_1.kappa);
    float _e172 = map_range(_e166, -6.0, -20.0, 1.0, 0.0, true);
    vec2 _e183 = u_look.viewport;
    BrushStrokes _e184 = brush_strokes_bristles(_e172, _e26.place, _e26.stretch, 44.0, 3.4, 1.5, 0.6, 0.4, 8, _e183);
    vec4 _e188 = u_look.accents_as_paint_b;
    vec4 _e190 = mix_colors_multiply(_e184.color, _e188, 1.0);
    vec4 _e192 = mix_colors_normal(_e164, _e190, _e184.ink);
    vec4 _e193 = with_unit_alpha(_e192);
    vec4 _e194 = premultiplied(_e193);
    vec4 _e195 = output_(_e194);
    return _e195;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec3(0.0), vec3(0.0), vec2(0.0), vec3(0.0), 0.0, mat3x3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_8 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_8;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    vec4 _e42 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e42.x;
    vec4 _e50 = texelFetch(u_smooth_normal_1_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e56 = u_view.camera_from_world;
    surface.smooth_normal_1_ = (vec4(_e50.xyz, 0.0) * _e56).xyz;
    vec4 _e65 = texelFetch(u_smooth_normal_3_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e71 = u_view.camera_from_world;
    surface.smooth_normal_3_ = (vec4(_e65.xyz, 0.0) * _e71).xyz;
    vec4 _e79 = u_view.screen;
    vec4 _e84 = u_view.screen;
    surface.pixel = ((in_.clip.xy * _e79.xy) + _e84.zw);
    mat4x4 _e90 = u_view.camera_from_world;
    vec4 _e94 = u_object.world_from_object[3];
    float _e103 = u_view.eye.w;
    float _e108 = u_view.clip_from_world[0][1];
    float _e113 = u_view.clip_from_world[1][1];
    float _e118 = u_view.clip_from_world[2][1];
    vec3 _e121 = anchor_on_screen((_e90 * vec4(_e94.xyz, 1.0)).xyz, _e103, length(vec3(_e108, _e113, _e118)));
    surface.anchor = _e121;
    mat4x4 _e125 = u_view.camera_from_world;
    float _e135 = u_view.eye.w;
    float _e140 = u_view.clip_from_world[0][1];
    float _e145 = u_view.clip_from_world[1][1];
    float _e150 = u_view.clip_from_world[2][1];
    float _e153 = size_on_screen(-((_e125 * vec4(in_.position, 1.0)).z), _e135, length(vec3(_e140, _e145, _e150)));
    surface.magnification = _e153;
    mat3x3 _e157 = u_object.world_from_normal;
    surface.world_from_normal = _e157;
    Surface _e158 = surface;
    vec4 _e159 = shade(_e158);
    vec4 _e160 = finite_vec4_(_e159);
    out_color = _e160;
    return;
}

