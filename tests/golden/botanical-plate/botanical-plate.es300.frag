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
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const float MOST_ON_SCREEN = 1000000000000000.0;
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

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_1) {
    uint bits = floatBitsToUint(x_1);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise) {
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_2) {
    uint bits_1 = floatBitsToUint(x_2);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec3 bounded_vec3_(vec3 v_3) {
    uvec3 bits_2 = floatBitsToUint(v_3);
    uvec3 magnitude_1 = (bits_2 & uvec3(2147483647u));
    vec3 largest_1 = uintBitsToFloat(((bits_2 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest_1, equal(magnitude_1, uvec3(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude_1, uvec3(2139095040u)));
}

vec4 bounded_vec4_(vec4 v_4) {
    uvec4 bits_3 = floatBitsToUint(v_4);
    uvec4 magnitude_2 = (bits_3 & uvec4(2147483647u));
    vec4 largest_2 = uintBitsToFloat(((bits_3 & uvec4(2147483648u)) | uvec4(2139095039u)));
    vec4 numbers_1 = mix(vec4(0.0), largest_2, equal(magnitude_2, uvec4(2139095040u)));
    return mix(numbers_1, v_4, lessThan(magnitude_2, uvec4(2139095040u)));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

vec3 mixed_vec3_(vec3 a_1, vec3 b_1, float t) {
    vec3 d_2 = (b_1 - a_1);
    vec3 _e13 = bounded_vec3_(((t < 0.5) ? (a_1 + (t * d_2)) : (b_1 - ((1.0 - t) * d_2))));
    return _e13;
}

vec4 mixed_vec4_(vec4 a_2, vec4 b_2, float t_1) {
    vec4 _e4 = bounded_vec4_((b_2 - a_2));
    vec4 _e14 = bounded_vec4_(((t_1 < 0.5) ? (a_2 + (t_1 * _e4)) : (b_2 - ((1.0 - t_1) * _e4))));
    return _e14;
}

float eased(float x_3, float low, float high) {
    float _e3 = bounded(x_3);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_4 = clamp(_e7, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float eased_2_(float x_4, float low_1, float high_1) {
    float _e3 = bounded(x_4);
    float _e7 = bounded(((_e3 - low_1) / 0.75));
    float t_5 = clamp(_e7, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float eased_3_(float x_5, float low_2, float high_2) {
    float t_6 = clamp(((x_5 - low_2) / (high_2 - low_2)), 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float footprint_of(float x_6) {
    float _e1 = dFdx(x_6);
    float _e2 = dFdy(x_6);
    vec2 d_3 = vec2(_e1, _e2);
    return sqrt(dot(d_3, d_3));
}

float footprint_of_vec3_(vec3 v_5) {
    vec3 dx = dFdx(v_5);
    vec3 dy = dFdy(v_5);
    float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

vec4 hermite(vec4 a_3, vec4 b_3, vec4 from_a, vec4 to_b, float t_2) {
    vec4 d_4 = (b_3 - a_3);
    return (a_3 + (t_2 * (from_a + (t_2 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_2 * ((from_a + to_b) - (2.0 * d_4))))))));
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

vec4 ramp_at(Ramp ramp, float x_7, float w) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint i_2_ = 1u;
    uint at = 0u;
    vec4 from_a_1 = vec4(0.0);
    vec4 to_b_1 = vec4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e28 = i_2_;
            i_2_ = (_e28 + 1u);
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
        float _e25 = places[(_e17 / 4u)][(_e21 % 4u)];
        at = ((_e25 <= x_7) ? _e16 : _e15);
    }
    uint _e31 = at;
    uint _e35 = at;
    float place_3 = places[(_e31 / 4u)][(_e35 % 4u)];
    uint _e40 = at;
    if ((((_e40 + 1u) >= 5u) || (x_7 <= place_3))) {
        uint _e47 = at;
        vec4 _e49 = colors[_e47];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = (_e50 + 1u);
    float _e59 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span = (_e59 - place_3);
    float _e62 = divided((x_7 - place_3), span);
    float t_7 = clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if ((_e69 > 0u)) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places[((_e72 - 1u) / 4u)][((_e78 - 1u) % 4u)];
        uint _e85 = at;
        vec4 _e87 = colors[_e85];
        uint _e88 = at;
        vec4 _e92 = colors[(_e88 - 1u)];
        vec4 _e96 = colors[after_1];
        uint _e97 = at;
        vec4 _e99 = colors[_e97];
        vec4 _e101 = ramp_slope((_e87 - _e92), (place_3 - before_1), (_e96 - _e99), span);
        from_a_1 = _e101;
    }
    if (((after_1 + 1u) < 5u)) {
        float _e119 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e119 - (place_3 + span));
        vec4 _e123 = colors[after_1];
        uint _e124 = at;
        vec4 _e126 = colors[_e124];
        vec4 _e131 = colors[(after_1 + 1u)];
        vec4 _e133 = colors[after_1];
        vec4 _e135 = ramp_slope((_e123 - _e126), span, (_e131 - _e133), next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    vec4 _e138 = colors[_e136];
    vec4 _e140 = colors[after_1];
    vec4 _e141 = from_a_1;
    vec4 _e143 = to_b_1;
    vec4 _e145 = hermite(_e138, _e140, (span * _e141), (span * _e143), t_7);
    vec4 _e146 = bounded_vec4_(_e145);
    return _e146;
}

vec4 mix_colors_multiply(vec4 a_4, vec4 b_4, float factor) {
    vec3 _e7 = mixed_vec3_(a_4.xyz, (a_4.xyz * b_4.xyz), factor);
    return vec4(_e7, 1.0);
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

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a_5 = ((axis == 0u) ? d.y : d.x);
    float b_5 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_5 : -(a_5)) + (((hash.z >> 31u) == 0u) ? b_5 : -(b_5)));
}

vec3 fade_quintic(vec3 t_3) {
    return (((t_3 * t_3) * t_3) * ((t_3 * ((t_3 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_5 = (p - corner);
    vec3 _e4 = fade_quintic(d_5);
    ivec3 cell_2 = ivec3(corner);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e46 = i;
            i = (_e46 + 1);
        }
        loop_init_1 = false;
        int _e10 = i;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            ivec3 at_2 = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at_2, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_2 + at_2), seed_2);
            float _e42 = gradient_dot(_e39, (d_5 - vec3(at_2)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, vec3 p_1, int octaves, float roughness, int seed_3, float w_1) {
    float octave = 0.0;
    int i_1 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e66 = i_1;
            i_1 = (_e66 + 1);
        }
        loop_init_2 = false;
        int _e17 = i_1;
        if (!((_e17 < 3))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased((w_1 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            vec3 place_4 = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_4, (0u + uint(_e47)));
            octave = mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_1;
    return min((_e69 / 1.75), 1.0);
}

float size_on_screen(float depth, float perspective, float scale) {
    return min(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

vec3 anchor_on_screen(vec3 origin, float perspective_1, float scale_1) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(vec3((origin.x * _e5), (-(origin.y) * _e5), _e5), vec3(-1000000000000000.0), vec3(1000000000000000.0));
}

vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 from_middle = (pixel - (0.5 * viewport));
    return (vec2(from_middle.x, -(from_middle.y)) / vec2(max(viewport.y, 1.0)));
}

float disk_filtered(float d_1, float r, float w_2) {
    if ((w_2 < 1e-30)) {
        return (((d_1 <= r) && (r > 0.0)) ? 1.0 : 0.0);
    }
    float square_1 = (r * r);
    float least = ((w_2 * w_2) / 3.0);
    float inner = sqrt((max(square_1, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d_1) / w_2)), 0.0, 1.0) * min((square_1 / least), 1.0));
}

uint blue_index(ivec2 cell_1) {
    uvec2 at_3 = (uvec2(cell_1) & uvec2(31u));
    return ((8u * at_3.y) + (at_3.x >> 2u));
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(0.0, 1.0);
    vec3 x_8 = ((turn.y * along) + (turn.x * across));
    vec3 y = ((turn.y * across) - (turn.x * along));
    vec2 turned = vec2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    vec3 stretch_4 = vec3(dot(x_8, x_8), dot(x_8, y), dot(y, y));
    return StretchedPlace(turned, stretch_4);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_3 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    vec2 p_2 = clamp((place_1 * scale_3), vec2(-4194304.0), vec2(4194304.0));
    return SpacedPlace(p_2, (is_pixel ? vec3(1.0, 0.0, 1.0) : stretch));
}

float area_square(vec3 stretch_1) {
    float sum_3 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_3 * sum_3) / 66.0));
}

float picture_square(vec2 offset, vec3 stretch_2) {
    float _e2 = area_square(stretch_2);
    float area = max(_e2, 1e-30);
    float square_2 = ((((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y));
    return (max(square_2, 0.0) / area);
}

float dots_of_octave(vec2 place_2, int zoom, float ink, vec3 stretch_3, float w_3, Dots style) {
    int i_2 = 0;
    float sum_2 = 0.0;
    uint tile[256] = BLUE_TILE;
    vec2 p_3 = clamp((place_2 * uintBitsToFloat((uint((zoom + 127)) << 23u))), vec2(-4194304.0), vec2(4194304.0));
    vec2 corner_1 = floor(p_3);
    float reach = (1.0 - (0.5 * style.scatter));
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            int _e118 = i_2;
            i_2 = (_e118 + 1);
        }
        loop_init_3 = false;
        int _e30 = i_2;
        if (!((_e30 < 9))) {
            break;
        }
        int _e35 = i_2;
        int _e40 = i_2;
        ivec2 cell_3 = (ivec2(corner_1) + ivec2(((_e35 % 3) - 1), ((_e40 / 3) - 1)));
        uvec3 _e54 = hash_pcg3d((uvec3(ivec3(cell_3, zoom)) + uvec3(0u, 0u, 0u)));
        vec3 chance = (vec3((_e54 >> uvec3(8u))) * 5.9604645e-8);
        vec2 middle = ((vec2(cell_3) + vec2(0.5)) + (style.scatter * (chance.xy - vec2(0.5))));
        vec2 offset_1 = (p_3 - middle);
        ivec2 turning = (cell_3 + ivec2(0, (zoom * 7)));
        uint _e78 = blue_index(turning);
        uint _e80 = tile[_e78];
        float turn_1 = (0.96875 * ((float(((_e80 >> (8u * (uint(turning.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
        float grown = clamp(((ink - turn_1) * 32.0), 0.0, 1.0);
        float radius = ((0.5 * style.size) * sqrt(grown));
        float far = (length(offset_1) / reach);
        float _e110 = picture_square(offset_1, stretch_3);
        float d_6 = max(sqrt(_e110), ((far * far) * radius));
        float _e115 = sum_2;
        float _e116 = disk_filtered(d_6, radius, w_3);
        sum_2 = max(_e115, _e116);
    }
    float _e121 = sum_2;
    return _e121;
}

float stippled(SpacedPlace at_1, float ink_1, Dots style_1) {
    float dots = 0.0;
    vec2 dx_1 = dFdx(at_1.place);
    vec2 dy_1 = dFdy(at_1.place);
    float _e8 = picture_square(dx_1, at_1.stretch);
    float _e10 = picture_square(dy_1, at_1.stretch);
    float _e13 = bounded(sqrt(max(_e8, _e10)));
    float _e15 = area_square(at_1.stretch);
    float _e19 = log2_stable(max(sqrt(_e15), 1e-30));
    float level = clamp((-0.5 * _e19), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    float _e29 = exp2_stable((-2.0 * f_1));
    float coarse = (1.0 - f_1);
    float fine = ((1.0 - (coarse * _e29)) / (4.0 * _e29));
    float _e44 = exp2_stable((2.0 * zoom_1));
    float _e46 = dots_of_octave(at_1.place, int(zoom_1), (ink_1 * coarse), (at_1.stretch * _e44), _e13, style_1);
    dots = _e46;
    if ((fine > 0.0)) {
        float _e60 = exp2_stable(((2.0 * zoom_1) + 2.0));
        float _e62 = dots_of_octave(at_1.place, (int(zoom_1) + 1), (ink_1 * fine), (at_1.stretch * _e60), _e13, style_1);
        float _e63 = dots;
        dots = max(_e63, _e62);
    }
    float mean = (ink_1 * ((0.7853982 * style_1.size) * style_1.size));
    float _e71 = dots;
    float _e74 = eased_2_(_e13, 0.75, 1.5);
    return mix(_e71, mean, _e74);
}

MarkPlace mark_place_object(float angle_1, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    vec2 _e8 = place_in_picture(pixel_1, viewport_2);
    vec2 place_5 = ((_e8 - vec2(anchor.x, -(anchor.y))) / vec2(size));
    StretchedPlace _e26 = mark_place_of(place_5, vec3((1.0 / size), 0.0, 0.0), vec3(0.0, (1.0 / size), 0.0), angle_1);
    return MarkPlace(_e26.place, _e26.stretch);
}

float outer_contour(float width, vec3 normal, vec3 view, vec2 viewport_3) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport_3.y, 1.0, 100000.0)) / 1000.0);
    float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float noise_perlin(vec3 position, float scale_2, int octaves_1, float roughness_1, int seed_4) {
    vec3 p_4 = (position * scale_2);
    float _e7 = footprint_of_vec3_(p_4);
    float _e8 = fractal_noise(NOISE_PERLIN, p_4, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 where_2_ = surface.position_object;
    VectorParts parts = VectorParts(where_2_.x, where_2_.y, where_2_.z);
    float _e11 = noise_perlin(surface.position_object, 4.0, 3, 0.5, 0);
    float height_mottled = (parts.y + mix(-0.35, 0.35, (_e11 - 0.0)));
    float share = clamp(((height_mottled + 0.9) / 1.85), 0.0, 1.0);
    float _e27 = footprint_of(share);
    vec4 _e28 = ramp_at(leaf_to_bloom, share, _e27);
    vec3 _e33 = u_look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e33) + 0.3) / 1.3), 0.0);
    float tone = mix(0.02, 1.0, min(((shade_2_ - 0.0) / 0.8), 1.0));
    float short_of_the_light = mix(0.85, 0.12, clamp(((tone - 0.55) / 0.4), 0.0, 1.0));
    vec4 _e65 = mix_colors_multiply(vec4(0.9725, 0.949, 0.8863, 1.0), _e28, short_of_the_light);
    float facing_1 = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    float turning_away = mix(0.2, 1.0, clamp(((facing_1 - 0.05) / 0.55), 0.0, 1.0));
    float engraved_tone = (tone * turning_away);
    vec2 _e88 = u_look.viewport;
    MarkPlace _e89 = mark_place_object(0.0, surface.anchor, surface.pixel, _e88);
    vec2 _e94 = u_look.viewport;
    SpacedPlace _e96 = spaced(_e89.place, _e89.stretch, _e94, 230.0);
    float _e105 = stippled(_e96, (1.0 - min(engraved_tone, 1.0)), Dots(0.72, 0.8, 0u));
    vec2 _e111 = u_look.viewport;
    float _e112 = outer_contour(2.0, surface.normal, surface.view, _e111);
    float curvature = surface.kappa;
    float hollow = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.25), -20.0, 20.0))))))));
    float _e134 = eased_3_(hollow, 0.24, 0.16);
    float ink_2 = max(max(_e105, _e112), _e134);
    vec4 _e137 = bounded_vec4_(_e65);
    vec4 _e143 = mixed_vec4_(_e137, vec4(0.1725, 0.1412, 0.1216, 1.0), ink_2);
    vec4 _e144 = finite_vec4_(_e143);
    return _e144;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e24 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    vec4 _e30 = u_view.screen;
    vec4 _e35 = u_view.screen;
    mat4x4 _e40 = u_view.camera_from_world;
    vec4 _e44 = u_object.world_from_object[3];
    float _e53 = u_view.eye.w;
    float _e58 = u_view.clip_from_world[0][1];
    float _e63 = u_view.clip_from_world[1][1];
    float _e68 = u_view.clip_from_world[2][1];
    vec3 _e71 = anchor_on_screen((_e40 * vec4(_e44.xyz, 1.0)).xyz, _e53, length(vec3(_e58, _e63, _e68)));
    Surface surface_1 = Surface(normal_1, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x, ((in_.clip.xy * _e30.xy) + _e35.zw), _e71);
    vec4 _e73 = shade(surface_1);
    vec4 _e74 = finite_vec4_(_e73);
    out_color = _e74;
    return;
}

