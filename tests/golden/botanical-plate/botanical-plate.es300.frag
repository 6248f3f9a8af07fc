#version 300 es
// Botanical plate: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// botanical-plate.json says what to put there and how to draw.

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
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    float kappa;
    vec2 pixel;
    vec3 anchor;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct Dots {
    float size;
    float scatter;
    uint seed;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct VectorParts {
    float x;
    float y;
    float z;
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
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const uint NOISE_PERLIN = 1u;
const uint NOISE_SIMPLEX = 2u;
const uint NOISE_WORLEY = 3u;
const float SIMPLEX_SCALE = 38.4553;
const float WORLEY_MEAN = 0.5205;
const uint BLUE_TILE[256] = uint[256](667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);
const Ramp leaf_to_bloom = Ramp(vec4[16](vec4(0.4353, 0.5412, 0.2353, 1.0), vec4(0.6235, 0.7098, 0.3961, 1.0), vec4(0.9098, 0.7255, 0.6275, 1.0), vec4(0.8471, 0.3765, 0.4784, 1.0), vec4(0.6588, 0.2275, 0.4, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.35, 0.6, 0.85), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

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
    float p_6 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p_6 * _e33) * _e37);
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
    float r_1 = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    vec2 _e27 = sin_cos_quarter(clamp(r_1, -1.5707964, HALF_PI));
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

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float mixed(float a_1, float b_1, float t) {
    float _e4 = bounded((b_1 - a_1));
    float _e14 = bounded(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

vec3 mixed_vec3_(vec3 a_2, vec3 b_2, float t_1) {
    float _e5 = mixed(a_2.x, b_2.x, t_1);
    float _e8 = mixed(a_2.y, b_2.y, t_1);
    float _e11 = mixed(a_2.z, b_2.z, t_1);
    return vec3(_e5, _e8, _e11);
}

vec4 mixed_vec4_(vec4 a_3, vec4 b_3, float t_2) {
    vec3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    float _e8 = mixed(a_3.w, b_3.w, t_2);
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
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
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

float footprint_of(float x_12) {
    float _e1 = dFdx(x_12);
    float _e2 = dFdy(x_12);
    vec2 d_3 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(vec3 v_6) {
    vec3 dx = dFdx(v_6);
    vec3 dy = dFdy(v_6);
    float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

float step_filtered(float x_13, float edge, float w) {
    float _e4 = bounded((x_13 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 color_mixed(vec4 a_4, vec3 blended, float factor) {
    vec3 _e4 = bounded_vec3_(a_4.xyz);
    vec3 _e5 = bounded_vec3_(blended);
    float _e7 = factor_of(factor, true);
    vec3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    float _e10 = bounded(a_4.w);
    return vec4(_e8, _e10);
}

vec4 hermite(vec4 a_5, vec4 b_4, vec4 from_a, vec4 to_b, float t_3) {
    vec4 d_4 = (b_4 - a_5);
    return (a_5 + (t_3 * (from_a + (t_3 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_4))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after) {
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

vec4 ramp_slope(vec4 rise_before, float span_before_1, vec4 rise_after, float span_after_1) {
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
    return vec4(_e8, _e13, _e18, _e23);
}

vec4 ramp_at(Ramp ramp, float x_14, float w_1) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = false;
    vec4 from_a_1 = vec4(0.0);
    vec4 to_b_1 = vec4(0.0);
    uint count_2 = min(ramp.count, 16u);
    if ((count_2 == 0u)) {
        return vec4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        vec4 _e18 = colors[0];
        color = _e18;
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                uint _e47 = i;
                i = (_e47 + 1u);
            }
            loop_init = false;
            uint _e22 = i;
            if ((_e22 < count_2)) {
            } else {
                break;
            }
            {
                vec4 _e24 = color;
                uint _e25 = i;
                vec4 _e27 = colors[_e25];
                uint _e28 = i;
                vec4 _e32 = colors[(_e28 - 1u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[(_e34 / 4u)][(_e38 % 4u)];
                float _e43 = step_filtered(x_14, _e42, w_1);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        vec4 _e49 = color;
        vec4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e71 = i_1;
            i_1 = (_e71 + 1u);
        }
        loop_init_1 = false;
        uint _e55 = i_1;
        if ((_e55 < count_2)) {
        } else {
            break;
        }
        {
            uint _e57 = at;
            uint _e58 = i_1;
            uint _e59 = i_1;
            uint _e63 = i_1;
            float _e67 = places[(_e59 / 4u)][(_e63 % 4u)];
            at = ((_e67 <= x_14) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_4 = places[(_e73 / 4u)][(_e77 % 4u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count_2))) {
        local_1 = (x_14 <= place_4);
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        vec4 _e94 = colors[_e92];
        vec4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span_1 = (_e105 - place_4);
    float _e108 = divided((x_14 - place_4), span_1);
    float t_6 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        vec4 _e117 = colors[_e115];
        vec4 _e119 = colors[after_1];
        vec4 _e120 = mixed_vec4_(_e117, _e119, t_6);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[((_e130 - 1u) / 4u)][((_e136 - 1u) % 4u)];
        uint _e143 = at;
        vec4 _e145 = colors[_e143];
        uint _e146 = at;
        vec4 _e150 = colors[(_e146 - 1u)];
        vec4 _e154 = colors[after_1];
        uint _e155 = at;
        vec4 _e157 = colors[_e155];
        vec4 _e159 = ramp_slope((_e145 - _e150), (place_4 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count_2)) {
        float _e173 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e173 - (place_4 + span_1));
        vec4 _e177 = colors[after_1];
        uint _e178 = at;
        vec4 _e180 = colors[_e178];
        vec4 _e185 = colors[(after_1 + 1u)];
        vec4 _e187 = colors[after_1];
        vec4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    vec4 _e192 = colors[_e190];
    vec4 _e194 = colors[after_1];
    vec4 _e195 = from_a_1;
    vec4 _e197 = to_b_1;
    vec4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_6);
    vec4 _e200 = bounded_vec4_(_e199);
    return _e200;
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

vec4 mix_colors_normal(vec4 a_6, vec4 b_5, float factor_1) {
    vec4 _e3 = bounded_vec4_(a_6);
    vec4 _e4 = bounded_vec4_(b_5);
    float _e6 = factor_of(factor_1, true);
    vec4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

vec4 mix_colors_multiply(vec4 a_7, vec4 b_6, float factor_2) {
    vec4 _e6 = color_mixed(a_7, (a_7.xyz * b_6.xyz), factor_2);
    return _e6;
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope) {
    float _e2 = kappa_safe(kappa_1);
    float _e4 = finite_or(slope, 0.0);
    float a_11 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_11), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_11 * a_11);
        return (a_11 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_7 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_11 >= 0.0) ? t_7 : -(t_7));
}

float transition(float kappa_2, float slope_1) {
    float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float facing(vec3 normal, vec3 view) {
    vec3 _e4 = normalize_or(normal, vec3(0.0));
    return clamp(dot(_e4, view), 0.0, 1.0);
}

float kappa_surface(float kappa_3) {
    float _e1 = kappa_safe(kappa_3);
    return _e1;
}

vec3 position_object(vec3 position_object_1) {
    return position_object_1;
}

float combine_tones_union(float a_8, float b_7) {
    float _e3 = factor_of(a_8, true);
    float _e5 = factor_of(b_7, true);
    return max(_e3, _e5);
}

vec4 output_(vec4 color_2) {
    vec4 _e1 = straight(color_2);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

vec4 ramp_plain(float value, Ramp ramp_1) {
    float _e2 = footprint_of(value);
    float _e3 = bounded(value);
    vec4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_7 = uvec3(0u);
    v_7 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_7.x;
    uint _e10 = v_7.y;
    uint _e12 = v_7.z;
    v_7.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_7.y;
    uint _e18 = v_7.z;
    uint _e20 = v_7.x;
    v_7.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_7.z;
    uint _e26 = v_7.x;
    uint _e28 = v_7.y;
    v_7.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_7;
    uvec3 _e32 = v_7;
    v_7 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_7.x;
    uint _e40 = v_7.y;
    uint _e42 = v_7.z;
    v_7.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_7.y;
    uint _e48 = v_7.z;
    uint _e50 = v_7.x;
    v_7.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_7.z;
    uint _e56 = v_7.x;
    uint _e58 = v_7.y;
    v_7.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_7;
    return _e61;
}

vec3 unit_of_hash(uvec3 hash) {
    return (vec3((hash >> uvec3(8u))) * 5.9604645e-8);
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash_1, vec3 d) {
    uint axis = ((hash_1.x >> 8u) % 3u);
    float a_12 = ((axis == 0u) ? d.y : d.x);
    float b_10 = ((axis == 2u) ? d.y : d.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_12 : -(a_12)) + (((hash_1.z >> 31u) == 0u) ? b_10 : -(b_10)));
}

vec3 fade_quintic(vec3 t_4) {
    return (((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float value_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i_2 = 0;
    vec3 corner = floor(p);
    vec3 _e4 = fade_quintic((p - corner));
    ivec3 cell_3 = ivec3(corner);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e45 = i_2;
            i_2 = (_e45 + 1);
        }
        loop_init_2 = false;
        int _e10 = i_2;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_2;
            int _e16 = i_2;
            int _e21 = i_2;
            ivec3 at_2 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_2, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_3 + at_2), seed_2);
            vec3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(vec3 p_1, uint seed_3) {
    float sum_1 = 0.0;
    int i_3 = 0;
    vec3 corner_1 = floor(p_1);
    vec3 d_5 = (p_1 - corner_1);
    vec3 _e4 = fade_quintic(d_5);
    ivec3 cell_4 = ivec3(corner_1);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = (_e46 + 1);
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            ivec3 at_3 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight_1 = mix((vec3(1.0) - _e4), _e4, equal(at_3, ivec3(1)));
            float _e32 = sum_1;
            uvec3 _e39 = lattice_hash((cell_4 + at_3), seed_3);
            float _e42 = gradient_dot(_e39, (d_5 - vec3(at_3)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(vec3 d_1, uvec3 hash_2) {
    float t_8 = max((0.5 - dot(d_1, d_1)), 0.0);
    float _e10 = gradient_dot(hash_2, d_1);
    return ((((t_8 * t_8) * t_8) * t_8) * _e10);
}

float simplex_noise(vec3 p_2, uint seed_4) {
    float sum_2 = 0.0;
    vec3 corner_2 = floor((p_2 + vec3((((p_2.x + p_2.y) + p_2.z) / 3.0))));
    vec3 d_6 = ((p_2 - corner_2) + vec3((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)));
    bvec3 is_first = bvec3((d_6.x >= d_6.y), (d_6.y >= d_6.z), (d_6.z > d_6.x));
    vec3 g = mix(vec3(0.0), vec3(1.0), is_first);
    vec3 l = (vec3(1.0) - g);
    vec3 second = min(g, l.zxy);
    vec3 third = max(g, l.zxy);
    ivec3 cell_5 = ivec3(corner_2);
    uvec3 _e45 = lattice_hash(cell_5, seed_4);
    float _e46 = simplex_corner(d_6, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    uvec3 _e55 = lattice_hash((cell_5 + ivec3(second)), seed_4);
    float _e56 = simplex_corner(((d_6 - second) + vec3(0.16666667)), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    uvec3 _e65 = lattice_hash((cell_5 + ivec3(third)), seed_4);
    float _e66 = simplex_corner(((d_6 - third) + vec3(0.33333334)), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    uvec3 _e75 = lattice_hash((cell_5 + ivec3(1)), seed_4);
    float _e76 = simplex_corner((d_6 - vec3(0.5)), _e75);
    sum_2 = (_e68 + _e76);
    float _e79 = sum_2;
    return clamp((0.5 + (SIMPLEX_SCALE * _e79)), 0.0, 1.0);
}

float worley_noise(vec3 p_3, uint seed_5) {
    float nearest = 1.0;
    int i_4 = 0;
    vec3 corner_3 = floor(p_3);
    vec3 d_7 = (p_3 - corner_3);
    ivec3 cell_6 = ivec3(corner_3);
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e40 = i_4;
            i_4 = (_e40 + 1);
        }
        loop_init_4 = false;
        int _e9 = i_4;
        if ((_e9 < 27)) {
        } else {
            break;
        }
        {
            int _e12 = i_4;
            int _e17 = i_4;
            int _e24 = i_4;
            ivec3 at_4 = ivec3(((_e12 % 3) - 1), (((_e17 / 3) % 3) - 1), ((_e24 / 9) - 1));
            uvec3 _e32 = lattice_hash((cell_6 + at_4), seed_5);
            vec3 _e33 = unit_of_hash(_e32);
            vec3 offset_1 = ((vec3(at_4) + _e33) - d_7);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset_1, offset_1));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

float noise_octave(uint kind, vec3 p_4, uint seed_6) {
    switch(kind) {
        case 1u: {
            float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, vec3 p_5, int octaves, float roughness, int seed_7, float w_2) {
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_5 = 0;
    float octave = 0.0;
    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    float _e11 = bounded(roughness);
    float gain = clamp(_e11, 0.0, 1.0);
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            int _e75 = i_5;
            i_5 = (_e75 + 1);
        }
        loop_init_5 = false;
        int _e25 = i_5;
        if ((_e25 < min(max(octaves, 1), 8))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            float _e34 = eased((w_2 * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_5;
                vec3 place_5 = clamp(((p_5 * _e40) + (float(_e42) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
                int _e56 = i_5;
                float _e59 = noise_octave(kind_1, place_5, (uint(seed_7) + uint(_e56)));
                octave = mix(mean, _e59, visible);
            }
            float _e61 = sum_3;
            float _e62 = strength;
            float _e63 = octave;
            sum_3 = (_e61 + (_e62 * _e63));
            float _e66 = total;
            float _e67 = strength;
            total = (_e66 + _e67);
            float _e69 = strength;
            strength = (_e69 * gain);
            float _e71 = frequency;
            frequency = (_e71 * 2.0);
        }
    }
    float _e77 = sum_3;
    float _e78 = total;
    return clamp((_e77 / _e78), 0.0, 1.0);
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

float disk_filtered(float d_2, float r, float w_3) {
    bool local_2 = false;
    if ((w_3 < 1e-30)) {
        if ((d_2 <= r)) {
            local_2 = (r > 0.0);
        } else {
            local_2 = false;
        }
        bool _e11 = local_2;
        return (_e11 ? 1.0 : 0.0);
    }
    float square_2 = (r * r);
    float least = ((w_3 * w_3) / 3.0);
    float inner = sqrt((max(square_2, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d_2) / w_3)), 0.0, 1.0) * min((square_2 / least), 1.0));
}

uint blue_index(ivec2 cell_1) {
    uvec2 at_5 = (uvec2(cell_1) & uvec2(31u));
    return ((8u * at_5.y) + (at_5.x >> 2u));
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
    vec3 stretch_5 = clamp(vec3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    vec2 _e41 = bounded_vec2_(turned);
    return StretchedPlace(_e41, stretch_5);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count) {
    float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_3 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    vec2 _e19 = bounded_vec2_(place_1);
    vec2 _e21 = bounded_vec2_((_e19 * scale_3));
    vec2 p_7 = clamp(_e21, vec2(-4194304.0), vec2(4194304.0));
    vec3 _e27 = bounded_vec3_(stretch);
    vec3 s_1 = clamp(_e27, vec3(-1000000000000000.0), vec3(1000000000000000.0));
    return SpacedPlace(p_7, (is_pixel ? vec3(1.0, 0.0, 1.0) : s_1));
}

float area_square(vec3 stretch_1) {
    float sum_5 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_5 * sum_5) / 66.0));
}

float octave_of(float square) {
    float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

float picture_square(vec2 offset, vec3 stretch_2) {
    float _e2 = area_square(stretch_2);
    float area = max(_e2, 1e-30);
    float square_3 = ((((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y));
    return (max(square_3, 0.0) / area);
}

float dots_of_octave(vec2 place_2, int zoom, float ink, vec3 stretch_3, float w_4, Dots style) {
    uint tile[256] = BLUE_TILE;
    float sum_4 = 0.0;
    int i_6 = 0;
    float _e6 = power_of_two(zoom);
    vec2 p_8 = clamp((place_2 * _e6), vec2(-4194304.0), vec2(4194304.0));
    vec2 corner_4 = floor(p_8);
    float reach = (1.0 - (0.5 * style.scatter));
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            int _e93 = i_6;
            i_6 = (_e93 + 1);
        }
        loop_init_6 = false;
        int _e25 = i_6;
        if ((_e25 < 9)) {
        } else {
            break;
        }
        {
            int _e29 = i_6;
            int _e34 = i_6;
            ivec2 cell_7 = (ivec2(corner_4) + ivec2(((_e29 % 3) - 1), ((_e34 / 3) - 1)));
            uvec3 _e43 = lattice_hash(ivec3(cell_7, zoom), style.seed);
            vec3 _e44 = unit_of_hash(_e43);
            vec2 middle = ((vec2(cell_7) + vec2(0.5)) + (style.scatter * (_e44.xy - vec2(0.5))));
            vec2 offset_2 = (p_8 - middle);
            ivec2 turning = (cell_7 + ivec2(int((style.seed & 31u)), (zoom * 7)));
            uint _e65 = blue_index(turning);
            uint _e67 = tile[_e65];
            float _e68 = blue_part(_e67, turning);
            float turn = (0.96875 * _e68);
            float grown = clamp(((ink - turn) * 32.0), 0.0, 1.0);
            float radius = ((0.5 * style.size) * sqrt(grown));
            float far = (length(offset_2) / reach);
            float _e84 = picture_square(offset_2, stretch_3);
            float d_8 = max(sqrt(_e84), ((far * far) * radius));
            float _e89 = sum_4;
            float _e90 = disk_filtered(d_8, radius, w_4);
            sum_4 = max(_e89, _e90);
        }
    }
    float _e95 = sum_4;
    return _e95;
}

float stippled(SpacedPlace at_1, float ink_1, Dots style_1) {
    float dots = 0.0;
    vec2 dx_1 = dFdx(at_1.place);
    vec2 dy_1 = dFdy(at_1.place);
    float _e8 = picture_square(dx_1, at_1.stretch);
    float _e10 = picture_square(dy_1, at_1.stretch);
    float _e13 = bounded(sqrt(max(_e8, _e10)));
    float _e14 = bounded(ink_1);
    float amount = clamp(_e14, 0.0, 1.0);
    vec3 s_2 = at_1.stretch;
    float _e19 = area_square(s_2);
    float _e21 = octave_of(sqrt(_e19));
    float zoom_1 = floor(_e21);
    float f_1 = (_e21 - zoom_1);
    float _e26 = exp2_stable((-2.0 * f_1));
    float coarse = (1.0 - f_1);
    float fine = ((1.0 - (coarse * _e26)) / (4.0 * _e26));
    float _e40 = exp2_stable((2.0 * zoom_1));
    float _e42 = dots_of_octave(at_1.place, int(zoom_1), (amount * coarse), (s_2 * _e40), _e13, style_1);
    dots = _e42;
    if ((fine > 0.0)) {
        float _e55 = exp2_stable(((2.0 * zoom_1) + 2.0));
        float _e57 = dots_of_octave(at_1.place, (int(zoom_1) + 1), (amount * fine), (s_2 * _e55), _e13, style_1);
        float _e58 = dots;
        dots = max(_e58, _e57);
    }
    float mean_1 = (amount * min(((0.7853982 * style_1.size) * style_1.size), 1.0));
    float _e68 = dots;
    float _e71 = eased(_e13, 0.75, 1.5);
    return mix(_e68, mean_1, _e71);
}

MarkPlace mark_place_object(float angle_1, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float _e5 = bounded(anchor.z);
    float size_1 = clamp(_e5, 1e-6, 1000000.0);
    vec2 _e9 = place_in_picture(pixel_1, viewport_2);
    vec2 _e15 = bounded_vec2_((_e9 - vec2(anchor.x, -(anchor.y))));
    vec2 place_6 = (_e15 / vec2(size_1));
    StretchedPlace _e28 = mark_place_of(place_6, vec3((1.0 / size_1), 0.0, 0.0), vec3(0.0, (1.0 / size_1), 0.0), angle_1);
    return MarkPlace(_e28.place, _e28.stretch);
}

float stippling(float value_1, vec2 place_3, vec3 stretch_4, float count_1, float size, float scatter, int seed_8, vec2 viewport_3) {
    float _e8 = bounded(size);
    float _e12 = bounded(scatter);
    Dots style_2 = Dots(clamp(_e8, 0.0, 1.4), clamp(_e12, 0.0, 1.0), uint(seed_8));
    SpacedPlace _e18 = spaced(place_3, stretch_4, viewport_3, count_1);
    float _e20 = factor_of(value_1, true);
    float _e23 = stippled(_e18, (1.0 - _e20), style_2);
    return _e23;
}

float reflectance_wrap(Light light, vec3 normal_1, float wrap) {
    float _e3 = bounded(wrap);
    float w_5 = clamp(_e3, 0.0, 1.0);
    vec3 _e11 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light.direction);
    return max(((cosine + w_5) / (1.0 + w_5)), 0.0);
}

float add(float a_9, float b_8) {
    float _e3 = bounded((a_9 + b_8));
    return _e3;
}

float map_range(float value_2, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2) {
    float _e6 = remapped(value_2, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_10, float b_9) {
    float _e3 = bounded((a_10 * b_9));
    return _e3;
}

float smooth_step_value(float value_3, float low_2, float high_2) {
    float _e3 = eased(value_3, low_2, high_2);
    return _e3;
}

float line_covers(float distance_, float width) {
    return clamp(((width + 0.5) - distance_), 0.0, min(width, 1.0));
}

float outer_contour(float width_1, vec3 normal_2, vec3 view_1, vec2 viewport_4) {
    vec3 _e6 = normalize_or(normal_2, vec3(0.0));
    float facing_1 = clamp(dot(_e6, view_1), 0.0, 1.0);
    float _e11 = bounded(width_1);
    float pixels = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport_4.y, 1.0, 100000.0)) / 1000.0);
    float _e22 = footprint_of(facing_1);
    float distance_1 = (facing_1 / max((2.0 * _e22), 1e-6));
    float _e30 = eased(facing_1, 0.45, 0.75);
    float near = (1.0 - _e30);
    float _e33 = line_covers(distance_1, pixels);
    return (_e33 * near);
}

float noise_perlin(vec3 position, float scale_2, int octaves_1, float roughness_1, int seed_9) {
    vec3 _e6 = bounded_vec3_((position * scale_2));
    float _e8 = footprint_of_vec3_(_e6);
    float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_9, _e8);
    return _e9;
}

VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, vector.z);
}

vec4 shade(Surface surface_1) {
    vec3 _e2 = position_object(surface_1.position_object);
    VectorParts _e3 = separate_vector(_e2);
    float _e9 = noise_perlin(surface_1.position_object, 4.0, 3, 0.5, 0);
    float _e15 = map_range(_e9, 0.0, 1.0, -0.35, 0.35, false);
    float _e17 = add(_e3.y, _e15);
    float _e23 = map_range(_e17, -0.9, 0.95, 0.0, 1.0, true);
    vec4 _e25 = ramp_plain(_e23, leaf_to_bloom);
    Light _e28 = u_look.key;
    float _e31 = reflectance_wrap(_e28, surface_1.normal, 0.3);
    float _e37 = map_range(_e31, 0.0, 0.8, 0.02, 1.0, true);
    float _e43 = map_range(_e37, 0.55, 0.95, 0.85, 0.12, true);
    vec4 _e49 = mix_colors_multiply(vec4(0.9725, 0.949, 0.8863, 1.0), _e25, _e43);
    float _e52 = facing(surface_1.normal, surface_1.view);
    float _e58 = map_range(_e52, 0.05, 0.6, 0.2, 1.0, true);
    float _e59 = multiply(_e37, _e58);
    vec2 _e65 = u_look.viewport;
    MarkPlace _e66 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e65);
    vec2 _e75 = u_look.viewport;
    float _e76 = stippling(_e59, _e66.place, _e66.stretch, 230.0, 0.72, 0.8, 0, _e75);
    vec2 _e82 = u_look.viewport;
    float _e83 = outer_contour(2.0, surface_1.normal, surface_1.view, _e82);
    float _e84 = combine_tones_union(_e76, _e83);
    float _e86 = kappa_surface(surface_1.kappa);
    float _e88 = transition(_e86, 0.25);
    float _e91 = smooth_step_value(_e88, 0.24, 0.16);
    float _e92 = combine_tones_union(_e84, _e91);
    vec4 _e98 = mix_colors_normal(_e49, vec4(0.1725, 0.1412, 0.1216, 1.0), _e92);
    vec4 _e99 = premultiplied(_e98);
    vec4 _e100 = output_(_e99);
    return _e100;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec2(0.0), vec3(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_3 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_3;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    vec4 _e42 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    surface.kappa = _e42.x;
    vec4 _e49 = u_view.screen;
    vec4 _e54 = u_view.screen;
    surface.pixel = ((in_.clip.xy * _e49.xy) + _e54.zw);
    mat4x4 _e60 = u_view.camera_from_world;
    vec4 _e64 = u_object.world_from_object[3];
    float _e73 = u_view.eye.w;
    float _e78 = u_view.clip_from_world[0][1];
    float _e83 = u_view.clip_from_world[1][1];
    float _e88 = u_view.clip_from_world[2][1];
    vec3 _e91 = anchor_on_screen((_e60 * vec4(_e64.xyz, 1.0)).xyz, _e73, length(vec3(_e78, _e83, _e88)));
    surface.anchor = _e91;
    Surface _e92 = surface;
    vec4 _e93 = shade(_e92);
    vec4 _e94 = finite_vec4_(_e93);
    out_color = _e94;
    return;
}

