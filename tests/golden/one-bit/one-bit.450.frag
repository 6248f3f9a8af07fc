#version 450 core
// One bit: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// one-bit.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    mat3x3 camera_from_world;
    vec2 viewport;
    Light back;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_camera;
    vec3 curvature_tensor;
    vec2 pixel;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint PROFILE_STEP = 1u;
const uint PROFILE_AMBIENT = 2u;
const uint BLUE_TILE[256] = uint[256](667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);
const ProfileShape tone_shape = ProfileShape(0.99875027, 0.04997917, 1.229384, 1.5428282, 0.1, 1.0145569, 0.43140125, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
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
    float square = dot(scaled, scaled);
    bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
}

float power_of_two(int n) {
    return uintBitsToFloat((uint((n + 127)) << 23u));
}

float exp2_stable(float x_2) {
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = roundEven(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = (int(whole) / 2);
    float _e33 = power_of_two(half_whole);
    float _e37 = power_of_two((int(whole) - half_whole));
    return ((p * _e33) * _e37);
}

float log_stable(float x_3) {
    uint bits = floatBitsToUint(x_3);
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= 256) ? (shift_2 - 512) : shift_2);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y) {
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
}

vec2 sin_cos_quarter(float x_4) {
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return vec2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

Angle angle_between(vec3 d, vec3 l) {
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    return Angle((p_1 * k), (s_1 * k));
}

float atan2_positive(float y_1, float x_5) {
    float small = min(y_1, x_5);
    float large = max(y_1, x_5);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_2 = (small / large);
    bool is_wide = (t_2 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_2);
    float r2_ = (r * r);
    float series_1 = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_3 = (is_wide ? (series_1 + 0.7853982) : series_1);
    return ((y_1 > x_5) ? (HALF_PI - a_3) : a_3);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, vec2 t) {
    bool local_1 = false;
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    vec2 turned = (_e32 ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

Angle angle_shifted(Angle u_2, float shift) {
    vec2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    Angle _e8 = angle_turned(u_2, _e7);
    return _e8;
}

float angle_footprint(Angle u_3) {
    vec2 half_ = vec2(u_3.half_sin, u_3.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
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

float mixed(float a, float b, float t_1) {
    float _e4 = bounded((b - a));
    float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
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

float eased(float x_8, float low_1, float high_1) {
    float _e3 = bounded(x_8);
    float _e4 = bounded(low_1);
    float _e5 = bounded(high_1);
    float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float factor_of(float x_9, bool clamped) {
    float _e2 = bounded(x_9);
    float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_10) {
    float _e1 = dFdx(x_10);
    float _e2 = dFdy(x_10);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness) {
    float _e4 = bounded(softness);
    return length(vec2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_11, float edge, float w_1) {
    float _e4 = bounded((x_11 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

float kappa_safe(float kappa) {
    bool is_nan = ((floatBitsToUint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

vec3 tensor_safe(vec3 tensor) {
    float _e2 = kappa_safe(tensor.x);
    float _e4 = kappa_safe(tensor.y);
    float _e6 = kappa_safe(tensor.z);
    return vec3(_e2, _e4, _e6);
}

float combine_tones_union(float a_1, float b_1) {
    float _e3 = factor_of(a_1, true);
    float _e5 = factor_of(b_1, true);
    return max(_e3, _e5);
}

float combine_tones_difference(float a_2, float b_2) {
    float _e3 = factor_of(a_2, true);
    float _e5 = factor_of(b_2, true);
    return min(_e3, (1.0 - _e5));
}

vec4 blend_finish(vec4 below, vec3 blended, float alpha, float opacity, bool clamped_1) {
    if ((opacity <= 0.0)) {
        return below;
    }
    vec4 mixed_1 = vec4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_1 ? clamp(mixed_1, vec4(0.0), vec4(1.0)) : mixed_1);
}

vec4 blend_alpha(vec4 below_1, vec4 color, float tone, float opacity_1, bool clamped_2) {
    float a_4 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_4) * (1.0 - below_1.w)));
    vec4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_4, clamped_2);
    return _e20;
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light, vec3 normal) {
    vec3 _e6 = normalize_or(normal, vec3(0.0, 0.0, 1.0));
    Angle _e8 = angle_between(_e6, light.direction);
    return _e8;
}

float profile_power(float q, float exponent) {
    float log_base = 0.0;
    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape) {
    bool local_2 = false;
    float s_3 = ((u_4.half_sin * shape.half_cos_offset) - (u_4.half_cos * shape.half_sin_offset));
    if (!((s_3 <= 0.0))) {
        local_2 = (shape.kind == PROFILE_AMBIENT);
    } else {
        local_2 = true;
    }
    bool _e18 = local_2;
    if (_e18) {
        return 1.0;
    }
    if ((shape.kind == PROFILE_STEP)) {
        return ((s_3 <= 4e-7) ? 1.0 : 0.0);
    }
    float q_1 = (s_3 * shape.scale);
    float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1) {
    bool local_3 = false;
    bool local_4 = false;
    float _e3 = profile_point(u_5, shape_1);
    if (!((w_2 <= 0.0))) {
        local_3 = (shape_1.kind == PROFILE_AMBIENT);
    } else {
        local_3 = true;
    }
    bool _e13 = local_3;
    if (_e13) {
        return _e3;
    }
    if ((shape_1.edge_deviation < 0.145)) {
        local_4 = (w_2 >= (3.4641016 * shape_1.edge_deviation));
    } else {
        local_4 = false;
    }
    bool _e24 = local_4;
    if (_e24) {
        float width_3 = sqrt(((w_2 * w_2) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
        float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_3)), 0.0, 1.0);
    }
    if ((w_2 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    vec2 _e50 = sin_cos_quarter((0.19364917 * w_2));
    Angle _e51 = angle_turned(u_5, _e50);
    float _e52 = profile_point(_e51, shape_1);
    Angle _e57 = angle_turned(u_5, vec2(-(_e50.x), _e50.y));
    float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2) {
    Angle _e3 = angle_shifted(angle, shift_1);
    float _e4 = angle_footprint(_e3);
    float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

ivec2 dither_cell(vec2 place, float size) {
    float _e2 = bounded(size);
    float least = max(_e2, 0.001);
    vec2 _e5 = bounded_vec2_(place);
    return ivec2(floor(clamp((_e5 / vec2(least)), vec2(-4194304.0), vec2(4194304.0))));
}

float dithered(float tone_1, int levels, float spread, float threshold) {
    float steps = float((min(max(levels, 2), 256) - 1));
    float _e10 = bounded(tone_1);
    float x_13 = (clamp(_e10, 0.0, 1.0) * steps);
    float low_2 = min(floor(x_13), (steps - 1.0));
    float _e19 = bounded(spread);
    float soft = clamp(_e19, 0.0, 1.0);
    bool is_upper = (((x_13 - low_2) - 0.5) >= ((threshold - 0.5) * soft));
    return ((low_2 + (is_upper ? 1.0 : 0.0)) / steps);
}

uint blue_index(ivec2 cell) {
    uvec2 at = (uvec2(cell) & uvec2(31u));
    return ((8u * at.y) + (at.x >> 2u));
}

float blue_part(uint four, ivec2 cell_1) {
    return ((float(((four >> (8u * (uint(cell_1.x) & 3u))) & 255u)) + 0.5) * 0.00390625);
}

float blue_threshold(ivec2 cell_2) {
    uint _e2 = blue_index(cell_2);
    float _e4 = blue_part(BLUE_TILE[_e2], cell_2);
    return _e4;
}

float rim(Light light_1, vec3 normal_1, vec3 view, float width, float softness_1, float follow) {
    vec3 _e10 = normalize_or(normal_1, vec3(0.0, 0.0, 1.0));
    float facing_1 = clamp(dot(_e10, view), 0.0, 1.0);
    float _e16 = factor_of(width, true);
    float _e18 = factor_of(softness_1, true);
    float _e20 = footprint_of(facing_1);
    float edge_1 = max((_e16 * _e18), min(_e20, 1.0));
    vec3 aside = (_e10 - view);
    float further = ((facing_1 > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1));
    float within = ((further / max(edge_1, 1e-6)) + ((softness_1 > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    vec3 across = (light_1.direction - (dot(light_1.direction, view) * view));
    vec3 _e61 = normalize_or(across, vec3(0.0));
    float side = dot((_e10 - (dot(_e10, view) * view)), _e61);
    float _e66 = eased(side, 0.0, 0.5);
    float _e68 = factor_of(follow, true);
    float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float dither_blue(float value, vec2 place_1, int levels_1, float spread_1, float size_1) {
    ivec2 _e5 = dither_cell(place_1, size_1);
    float _e6 = blue_threshold(_e5);
    float _e7 = dithered(value, levels_1, spread_1, _e6);
    return _e7;
}

float line_covers(float distance_, float width_1) {
    return clamp(((width_1 + 0.5) - distance_), 0.0, min(width_1, 1.0));
}

float seen_well(float facing) {
    float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_12, float limit, float softness_2) {
    float _e3 = bounded(limit);
    float at_1 = max(_e3, 0.0);
    float _e6 = footprint_of(x_12);
    float _e10 = factor_of(softness_2, true);
    float _e12 = edge_width(_e6, (min(at_1, 1000000000.0) * _e10));
    float _e13 = bounded(x_12);
    float _e14 = step_filtered(_e13, at_1, _e12);
    return _e14;
}

float inner_contour_suggestive(float width_2, float limit_1, float softness_3, vec3 tensor_1, vec3 normal_2, vec3 view_1, mat3x3 camera_from_world, vec3 place_2, vec2 viewport) {
    vec3 n_1 = (camera_from_world * normal_2);
    vec3 _e10 = tensor_safe(tensor_1);
    float square_1 = dot(n_1.xy, n_1.xy);
    float radial = (((((_e10.x * n_1.x) * n_1.x) + (((2.0 * _e10.y) * n_1.x) * n_1.y)) + ((_e10.z * n_1.y) * n_1.y)) / max(square_1, 1e-6));
    float _e36 = dFdx(radial);
    float _e37 = dFdy(radial);
    vec2 change = vec2(_e36, _e37);
    vec3 v_4 = (camera_from_world * view_1);
    vec3 row = dFdy(place_2);
    float up = (((row - (dot(row, v_4) * v_4)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n_1.x) + ((up * change.y) * n_1.y))) * inversesqrt(max(square_1, 1e-6)));
    float _e67 = bounded(width_2);
    float pixels = (((0.5 * clamp(_e67, 0.0, 10000.0)) * height) / 1000.0);
    float distance_1 = (abs(radial) / max(length(change), 1e-6));
    float _e84 = faded_in(((toward_eye * height) * 0.05), limit_1, softness_3);
    float _e85 = line_covers(distance_1, pixels);
    float _e88 = seen_well(dot(normal_2, view_1));
    return ((_e85 * _e84) * _e88);
}

vec4 shade(Surface surface_1) {
    Light _e3 = u_look.key;
    Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    float _e8 = profile(_e5, 0.0, tone_shape);
    float _e13 = dither_blue(_e8, surface_1.pixel, 2, 1.0, 2.0);
    Light _e16 = u_look.back;
    float _e22 = rim(_e16, surface_1.normal, surface_1.view, 0.34, 0.0, 1.0);
    float _e23 = combine_tones_union(_e13, _e22);
    mat3x3 _e32 = u_look.camera_from_world;
    vec2 _e36 = u_look.viewport;
    float _e37 = inner_contour_suggestive(3.0, 20.0, 0.1, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e32, surface_1.position_camera, _e36);
    float _e38 = combine_tones_difference(_e23, _e37);
    vec4 _e51 = blend_alpha(vec4(0.1333, 0.1216, 0.2, 1.0), vec4(0.9373, 0.902, 0.8118, 1.0), _e38, 1.0, true);
    vec4 _e52 = output_(_e51);
    return _e52;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    Surface surface = Surface(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0));
    vec3 _e7 = normalize_or(in_.normal, vec3(0.0, 0.0, 1.0));
    vec3 normal_3 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_3;
    vec4 _e15 = u_view.eye;
    float _e20 = u_view.eye.w;
    vec4 _e26 = u_view.eye;
    vec3 _e32 = normalize_or(_e26.xyz, vec3(0.0, 0.0, 1.0));
    vec3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    mat4x4 _e37 = u_view.camera_from_world;
    surface.position_camera = (_e37 * vec4(in_.position, 1.0)).xyz;
    vec4 _e49 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    surface.curvature_tensor = _e49.xyz;
    vec4 _e56 = u_view.screen;
    vec4 _e61 = u_view.screen;
    surface.pixel = ((in_.clip.xy * _e56.xy) + _e61.zw);
    Surface _e64 = surface;
    vec4 _e65 = shade(_e64);
    vec4 _e66 = finite_vec4_(_e65);
    out_color = _e66;
    return;
}

