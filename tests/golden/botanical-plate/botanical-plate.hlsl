// Botanical plate: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2, curvature_map t0.
// botanical-plate.json says what to put there and how to draw.
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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    float kappa;
    float2 pixel;
    int _pad5_0;
    int _pad5_1;
    float3 anchor;
    int _end_pad_0;
};

struct Ramp {
    float4 colors[16];
    float4 places[4];
    uint count;
    uint interpolation;
    int _end_pad_0;
    int _end_pad_1;
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

struct Dots {
    float size;
    float scatter;
    uint seed;
};

struct MarkPlace {
    float2 place;
    int _pad1_0;
    int _pad1_1;
    float3 stretch;
    int _end_pad_0;
};

struct VectorParts {
    float x;
    float y;
    float z;
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

typedef uint ret_Constructarray256_uint_[256];
ret_Constructarray256_uint_ Constructarray256_uint_(uint arg0, uint arg1, uint arg2, uint arg3, uint arg4, uint arg5, uint arg6, uint arg7, uint arg8, uint arg9, uint arg10, uint arg11, uint arg12, uint arg13, uint arg14, uint arg15, uint arg16, uint arg17, uint arg18, uint arg19, uint arg20, uint arg21, uint arg22, uint arg23, uint arg24, uint arg25, uint arg26, uint arg27, uint arg28, uint arg29, uint arg30, uint arg31, uint arg32, uint arg33, uint arg34, uint arg35, uint arg36, uint arg37, uint arg38, uint arg39, uint arg40, uint arg41, uint arg42, uint arg43, uint arg44, uint arg45, uint arg46, uint arg47, uint arg48, uint arg49, uint arg50, uint arg51, uint arg52, uint arg53, uint arg54, uint arg55, uint arg56, uint arg57, uint arg58, uint arg59, uint arg60, uint arg61, uint arg62, uint arg63, uint arg64, uint arg65, uint arg66, uint arg67, uint arg68, uint arg69, uint arg70, uint arg71, uint arg72, uint arg73, uint arg74, uint arg75, uint arg76, uint arg77, uint arg78, uint arg79, uint arg80, uint arg81, uint arg82, uint arg83, uint arg84, uint arg85, uint arg86, uint arg87, uint arg88, uint arg89, uint arg90, uint arg91, uint arg92, uint arg93, uint arg94, uint arg95, uint arg96, uint arg97, uint arg98, uint arg99, uint arg100, uint arg101, uint arg102, uint arg103, uint arg104, uint arg105, uint arg106, uint arg107, uint arg108, uint arg109, uint arg110, uint arg111, uint arg112, uint arg113, uint arg114, uint arg115, uint arg116, uint arg117, uint arg118, uint arg119, uint arg120, uint arg121, uint arg122, uint arg123, uint arg124, uint arg125, uint arg126, uint arg127, uint arg128, uint arg129, uint arg130, uint arg131, uint arg132, uint arg133, uint arg134, uint arg135, uint arg136, uint arg137, uint arg138, uint arg139, uint arg140, uint arg141, uint arg142, uint arg143, uint arg144, uint arg145, uint arg146, uint arg147, uint arg148, uint arg149, uint arg150, uint arg151, uint arg152, uint arg153, uint arg154, uint arg155, uint arg156, uint arg157, uint arg158, uint arg159, uint arg160, uint arg161, uint arg162, uint arg163, uint arg164, uint arg165, uint arg166, uint arg167, uint arg168, uint arg169, uint arg170, uint arg171, uint arg172, uint arg173, uint arg174, uint arg175, uint arg176, uint arg177, uint arg178, uint arg179, uint arg180, uint arg181, uint arg182, uint arg183, uint arg184, uint arg185, uint arg186, uint arg187, uint arg188, uint arg189, uint arg190, uint arg191, uint arg192, uint arg193, uint arg194, uint arg195, uint arg196, uint arg197, uint arg198, uint arg199, uint arg200, uint arg201, uint arg202, uint arg203, uint arg204, uint arg205, uint arg206, uint arg207, uint arg208, uint arg209, uint arg210, uint arg211, uint arg212, uint arg213, uint arg214, uint arg215, uint arg216, uint arg217, uint arg218, uint arg219, uint arg220, uint arg221, uint arg222, uint arg223, uint arg224, uint arg225, uint arg226, uint arg227, uint arg228, uint arg229, uint arg230, uint arg231, uint arg232, uint arg233, uint arg234, uint arg235, uint arg236, uint arg237, uint arg238, uint arg239, uint arg240, uint arg241, uint arg242, uint arg243, uint arg244, uint arg245, uint arg246, uint arg247, uint arg248, uint arg249, uint arg250, uint arg251, uint arg252, uint arg253, uint arg254, uint arg255) {
    uint ret[256] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15, arg16, arg17, arg18, arg19, arg20, arg21, arg22, arg23, arg24, arg25, arg26, arg27, arg28, arg29, arg30, arg31, arg32, arg33, arg34, arg35, arg36, arg37, arg38, arg39, arg40, arg41, arg42, arg43, arg44, arg45, arg46, arg47, arg48, arg49, arg50, arg51, arg52, arg53, arg54, arg55, arg56, arg57, arg58, arg59, arg60, arg61, arg62, arg63, arg64, arg65, arg66, arg67, arg68, arg69, arg70, arg71, arg72, arg73, arg74, arg75, arg76, arg77, arg78, arg79, arg80, arg81, arg82, arg83, arg84, arg85, arg86, arg87, arg88, arg89, arg90, arg91, arg92, arg93, arg94, arg95, arg96, arg97, arg98, arg99, arg100, arg101, arg102, arg103, arg104, arg105, arg106, arg107, arg108, arg109, arg110, arg111, arg112, arg113, arg114, arg115, arg116, arg117, arg118, arg119, arg120, arg121, arg122, arg123, arg124, arg125, arg126, arg127, arg128, arg129, arg130, arg131, arg132, arg133, arg134, arg135, arg136, arg137, arg138, arg139, arg140, arg141, arg142, arg143, arg144, arg145, arg146, arg147, arg148, arg149, arg150, arg151, arg152, arg153, arg154, arg155, arg156, arg157, arg158, arg159, arg160, arg161, arg162, arg163, arg164, arg165, arg166, arg167, arg168, arg169, arg170, arg171, arg172, arg173, arg174, arg175, arg176, arg177, arg178, arg179, arg180, arg181, arg182, arg183, arg184, arg185, arg186, arg187, arg188, arg189, arg190, arg191, arg192, arg193, arg194, arg195, arg196, arg197, arg198, arg199, arg200, arg201, arg202, arg203, arg204, arg205, arg206, arg207, arg208, arg209, arg210, arg211, arg212, arg213, arg214, arg215, arg216, arg217, arg218, arg219, arg220, arg221, arg222, arg223, arg224, arg225, arg226, arg227, arg228, arg229, arg230, arg231, arg232, arg233, arg234, arg235, arg236, arg237, arg238, arg239, arg240, arg241, arg242, arg243, arg244, arg245, arg246, arg247, arg248, arg249, arg250, arg251, arg252, arg253, arg254, arg255 };
    return ret;
}

typedef float4 ret_Constructarray16_float4_[16];
ret_Constructarray16_float4_ Constructarray16_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3, float4 arg4, float4 arg5, float4 arg6, float4 arg7, float4 arg8, float4 arg9, float4 arg10, float4 arg11, float4 arg12, float4 arg13, float4 arg14, float4 arg15) {
    float4 ret[16] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15 };
    return ret;
}

typedef float4 ret_Constructarray4_float4_[4];
ret_Constructarray4_float4_ Constructarray4_float4_(float4 arg0, float4 arg1, float4 arg2, float4 arg3) {
    float4 ret[4] = { arg0, arg1, arg2, arg3 };
    return ret;
}

Ramp ConstructRamp(float4 arg0[16], float4 arg1[4], uint arg2, uint arg3) {
    Ramp ret = (Ramp)0;
    ret.colors = arg0;
    ret.places = arg1;
    ret.count = arg2;
    ret.interpolation = arg3;
    return ret;
}

static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint INTERPOLATION_SMOOTH = 1u;
static const uint INTERPOLATION_STEPPED = 2u;
static const uint NOISE_PERLIN = 1u;
static const uint NOISE_SIMPLEX = 2u;
static const uint NOISE_WORLEY = 3u;
static const float SIMPLEX_SCALE = 38.4553;
static const float WORLEY_MEAN = 0.5205;
static const uint BLUE_TILE[256] = Constructarray256_uint_(667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);
static const Ramp leaf_to_bloom = ConstructRamp(Constructarray16_float4_(float4(0.4353, 0.5412, 0.2353, 1.0), float4(0.6235, 0.7098, 0.3961, 1.0), float4(0.9098, 0.7255, 0.6275, 1.0), float4(0.8471, 0.3765, 0.4784, 1.0), float4(0.6588, 0.2275, 0.4, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.35, 0.6, 0.85), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 1u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_3 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_3 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

bool is_finite(float x)
{
    return ((asuint(x) & 2139095040u) != 2139095040u);
}

float finite_or(float x_1, float otherwise)
{
    const bool _e2 = is_finite(x_1);
    return (_e2 ? x_1 : otherwise);
}

float3 finite_vec3_(float3 v)
{
    const float _e3 = finite_or(v.x, 0.0);
    const float _e6 = finite_or(v.y, 0.0);
    const float _e9 = finite_or(v.z, 0.0);
    return float3(_e3, _e6, _e9);
}

float4 finite_vec4_(float4 v_1)
{
    const float3 _e2 = finite_vec3_(v_1.xyz);
    const float _e5 = finite_or(v_1.w, 0.0);
    return float4(_e2, _e5);
}

float3 normalize_or(float3 v_2, float3 otherwise_1)
{
    bool local = (bool)0;

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
    float3 scaled = (v_2 * (1.0 / largest));
    float square_1 = dot(scaled, scaled);
    const bool _e23 = is_finite(square_1);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square_1)));
}

float power_of_two(int n)
{
    return asfloat((uint(asint(asuint(n) + asuint(int(127)))) << 23u));
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x_2)
{
    float clamped_3 = clamp(x_2, -150.0, 127.99999);
    float whole = round(clamped_3);
    float f = ((clamped_3 - whole) * LN_2_);
    float p_6 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p_6 * _e33) * _e37);
}

float log_stable(float x_3)
{
    uint bits = asuint(x_3);
    int shift = int(((bits - 1060439283u) >> 23u));
    int exponent = ((shift >= int(256)) ? asint(asuint(shift) - asuint(int(512))) : shift);
    float mantissa = asfloat((bits - (uint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent) * LN_2_) + series);
}

float2 sin_cos_quarter(float x_4)
{
    float h = (0.5 * x_4);
    float h2_ = (h * h);
    float s = (h * (1.0 + (h2_ * (-0.16666667 + (h2_ * (0.008333334 + (h2_ * (-0.0001984127 + (h2_ * (2.7557319e-6 + (h2_ * -2.5052108e-8)))))))))));
    float one_minus_c = (h2_ * (0.5 + (h2_ * (-0.041666668 + (h2_ * (0.0013888889 + (h2_ * (-2.4801588e-5 + (h2_ * (2.755732e-7 + (h2_ * -2.0876756e-9)))))))))));
    float c = (1.0 - one_minus_c);
    return float2(((2.0 * s) * c), (1.0 - ((2.0 * s) * s)));
}

float2 sin_cos(float x_5)
{
    float turns = round((x_5 * 0.31830987));
    float r_1 = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r_1, -1.5707964, HALF_PI));
    return (sign_ * _e27);
}

float bounded(float x_6)
{
    uint bits_1 = asuint(x_6);
    uint magnitude = (bits_1 & 2147483647u);
    float largest_1 = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_6 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float2 bounded_vec2_(float2 v_3)
{
    const float _e2 = bounded(v_3.x);
    const float _e4 = bounded(v_3.y);
    return float2(_e2, _e4);
}

float3 bounded_vec3_(float3 v_4)
{
    const float _e2 = bounded(v_4.x);
    const float _e4 = bounded(v_4.y);
    const float _e6 = bounded(v_4.z);
    return float3(_e2, _e4, _e6);
}

float4 bounded_vec4_(float4 v_5)
{
    const float _e2 = bounded(v_5.x);
    const float _e4 = bounded(v_5.y);
    const float _e6 = bounded(v_5.z);
    const float _e8 = bounded(v_5.w);
    return float4(_e2, _e4, _e6, _e8);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float mixed(float a_1, float b_1, float t)
{
    const float _e4 = bounded((b_1 - a_1));
    const float _e14 = bounded(((t < 0.5) ? (a_1 + (t * _e4)) : (b_1 - ((1.0 - t) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_2, float3 b_2, float t_1)
{
    const float _e5 = mixed(a_2.x, b_2.x, t_1);
    const float _e8 = mixed(a_2.y, b_2.y, t_1);
    const float _e11 = mixed(a_2.z, b_2.z, t_1);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_3, float4 b_3, float t_2)
{
    const float3 _e5 = mixed_vec3_(a_3.xyz, b_3.xyz, t_2);
    const float _e8 = mixed(a_3.w, b_3.w, t_2);
    return float4(_e5, _e8);
}

float place_between(float x_7, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_7 >= high) ? 1.0 : 0.0);
    }
    const float _e12 = bounded(span);
    const float _e14 = bounded(((x_7 - low) / _e12));
    return _e14;
}

float remapped(float x_8, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    const float _e6 = bounded(x_8);
    const float _e7 = bounded(from_low);
    const float _e8 = bounded(from_high);
    const float _e9 = place_between(_e6, _e7, _e8);
    const float _e10 = bounded(to_low);
    const float _e11 = bounded(to_high);
    const float _e16 = mixed(_e10, _e11, (clamped ? clamp(_e9, 0.0, 1.0) : _e9));
    return _e16;
}

float eased(float x_9, float low_1, float high_1)
{
    const float _e3 = bounded(x_9);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_5 = clamp(_e6, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float factor_of(float x_10, bool clamped_1)
{
    const float _e2 = bounded(x_10);
    const float _e3 = bounded(x_10);
    return (clamped_1 ? clamp(_e3, 0.0, 1.0) : _e2);
}

float2 sin_cos_of(float x_11)
{
    const float _e1 = bounded(x_11);
    const float2 _e2 = sin_cos(_e1);
    return clamp(_e2, (-1.0).xx, (1.0).xx);
}

float footprint_of(float x_12)
{
    float _e1 = ddx(x_12);
    float _e2 = ddy(x_12);
    float2 d_3 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_3, d_3)));
    return _e6;
}

float footprint_of_vec3_(float3 v_6)
{
    float3 dx = ddx(v_6);
    float3 dy = ddy(v_6);
    const float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

float step_filtered(float x_13, float edge, float w)
{
    const float _e4 = bounded((x_13 - edge));
    if ((w < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 color_mixed(float4 a_4, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_4.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float _e7 = factor_of(factor, true);
    const float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    const float _e10 = bounded(a_4.w);
    return float4(_e8, _e10);
}

float4 hermite(float4 a_5, float4 b_4, float4 from_a, float4 to_b, float t_3)
{
    float4 d_4 = (b_4 - a_5);
    return (a_5 + (t_3 * (from_a + (t_3 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_3 * ((from_a + to_b) - (2.0 * d_4))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    const float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

float4 ramp_slope(float4 rise_before, float span_before_1, float4 rise_after, float span_after_1)
{
    const float _e5 = divided(rise_before.x, span_before_1);
    const float _e7 = divided(rise_after.x, span_after_1);
    const float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    const float _e10 = divided(rise_before.y, span_before_1);
    const float _e12 = divided(rise_after.y, span_after_1);
    const float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    const float _e15 = divided(rise_before.z, span_before_1);
    const float _e17 = divided(rise_after.z, span_after_1);
    const float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    const float _e20 = divided(rise_before.w, span_before_1);
    const float _e22 = divided(rise_after.w, span_after_1);
    const float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return float4(_e8, _e13, _e18, _e23);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

float4 ramp_at(Ramp ramp, float x_14, float w_1)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    float4 color = (float4)0;
    uint i = 1u;
    uint at = 0u;
    uint i_1 = 1u;
    bool local_1 = (bool)0;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    uint count_2 = min(ramp.count, 16u);
    if ((count_2 == 0u)) {
        return (0.0).xxxx;
    }
    colors = ramp.colors;
    places = ramp.places;
    if ((ramp.interpolation == INTERPOLATION_STEPPED)) {
        float4 _e18 = colors[0];
        color = _e18;
        uint2 loop_bound = uint2(4294967295u, 4294967295u);
        bool loop_init = true;
        while(true) {
            if (all(loop_bound == uint2(0u, 0u))) { break; }
            loop_bound -= uint2(loop_bound.y == 0u, 1u);
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
                float4 _e24 = color;
                uint _e25 = i;
                float4 _e27 = colors[min(uint(_e25), 15u)];
                uint _e28 = i;
                float4 _e32 = colors[min(uint((_e28 - 1u)), 15u)];
                uint _e34 = i;
                uint _e38 = i;
                float _e42 = places[min(uint(naga_div(_e34, 4u)), 3u)][min(uint(naga_mod(_e38, 4u)), 3u)];
                const float _e43 = step_filtered(x_14, _e42, w_1);
                color = (_e24 + ((_e27 - _e32) * _e43));
            }
        }
        float4 _e49 = color;
        const float4 _e50 = bounded_vec4_(_e49);
        return _e50;
    }
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
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
            float _e67 = places[min(uint(naga_div(_e59, 4u)), 3u)][min(uint(naga_mod(_e63, 4u)), 3u)];
            at = ((_e67 <= x_14) ? _e58 : _e57);
        }
    }
    uint _e73 = at;
    uint _e77 = at;
    float place_4 = places[min(uint(naga_div(_e73, 4u)), 3u)][min(uint(naga_mod(_e77, 4u)), 3u)];
    uint _e82 = at;
    if (!(((_e82 + 1u) >= count_2))) {
        local_1 = (x_14 <= place_4);
    } else {
        local_1 = true;
    }
    bool _e91 = local_1;
    if (_e91) {
        uint _e92 = at;
        float4 _e94 = colors[min(uint(_e92), 15u)];
        const float4 _e95 = bounded_vec4_(_e94);
        return _e95;
    }
    uint _e96 = at;
    uint after_1 = (_e96 + 1u);
    float _e105 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span_1 = (_e105 - place_4);
    const float _e108 = divided((x_14 - place_4), span_1);
    float t_6 = clamp(_e108, 0.0, 1.0);
    if ((ramp.interpolation != INTERPOLATION_SMOOTH)) {
        uint _e115 = at;
        float4 _e117 = colors[min(uint(_e115), 15u)];
        float4 _e119 = colors[min(uint(after_1), 15u)];
        const float4 _e120 = mixed_vec4_(_e117, _e119, t_6);
        return _e120;
    }
    uint _e127 = at;
    if ((_e127 > 0u)) {
        uint _e130 = at;
        uint _e136 = at;
        float before_1 = places[min(uint(naga_div((_e130 - 1u), 4u)), 3u)][min(uint(naga_mod((_e136 - 1u), 4u)), 3u)];
        uint _e143 = at;
        float4 _e145 = colors[min(uint(_e143), 15u)];
        uint _e146 = at;
        float4 _e150 = colors[min(uint((_e146 - 1u)), 15u)];
        float4 _e154 = colors[min(uint(after_1), 15u)];
        uint _e155 = at;
        float4 _e157 = colors[min(uint(_e155), 15u)];
        const float4 _e159 = ramp_slope((_e145 - _e150), (place_4 - before_1), (_e154 - _e157), span_1);
        from_a_1 = _e159;
    }
    if (((after_1 + 1u) < count_2)) {
        float _e173 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e173 - (place_4 + span_1));
        float4 _e177 = colors[min(uint(after_1), 15u)];
        uint _e178 = at;
        float4 _e180 = colors[min(uint(_e178), 15u)];
        float4 _e185 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e187 = colors[min(uint(after_1), 15u)];
        const float4 _e189 = ramp_slope((_e177 - _e180), span_1, (_e185 - _e187), next);
        to_b_1 = _e189;
    }
    uint _e190 = at;
    float4 _e192 = colors[min(uint(_e190), 15u)];
    float4 _e194 = colors[min(uint(after_1), 15u)];
    float4 _e195 = from_a_1;
    float4 _e197 = to_b_1;
    const float4 _e199 = hermite(_e192, _e194, (span_1 * _e195), (span_1 * _e197), t_6);
    const float4 _e200 = bounded_vec4_(_e199);
    return _e200;
}

float4 premultiplied(float4 color_1)
{
    return float4((color_1.xyz * color_1.w), color_1.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_normal(float4 a_6, float4 b_5, float factor_1)
{
    const float4 _e3 = bounded_vec4_(a_6);
    const float4 _e4 = bounded_vec4_(b_5);
    const float _e6 = factor_of(factor_1, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float4 mix_colors_multiply(float4 a_7, float4 b_6, float factor_2)
{
    const float4 _e6 = color_mixed(a_7, (a_7.xyz * b_6.xyz), factor_2);
    return _e6;
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float curvature_signed(float kappa_1, float slope)
{
    const float _e2 = kappa_safe(kappa_1);
    const float _e4 = finite_or(slope, 0.0);
    float a_11 = (_e2 * clamp(_e4, -1e30, 1e30));
    float magnitude_1 = min(abs(a_11), 50.0);
    if ((magnitude_1 < 0.0625)) {
        float a2_ = (a_11 * a_11);
        return (a_11 * (1.0 - (a2_ * (0.33333334 - (a2_ * (0.13333334 - (a2_ * 0.053968254)))))));
    }
    const float _e28 = exp2_stable((-2.88539 * magnitude_1));
    float t_7 = ((1.0 - _e28) / (1.0 + _e28));
    return ((a_11 >= 0.0) ? t_7 : -(t_7));
}

float transition(float kappa_2, float slope_1)
{
    const float _e2 = curvature_signed(kappa_2, slope_1);
    return (0.5 + (0.5 * _e2));
}

float facing(float3 normal, float3 view)
{
    const float3 _e4 = normalize_or(normal, (0.0).xxx);
    return clamp(dot(_e4, view), 0.0, 1.0);
}

float kappa_surface(float kappa_3)
{
    const float _e1 = kappa_safe(kappa_3);
    return _e1;
}

float3 position_object(float3 position_object_1)
{
    return position_object_1;
}

float combine_tones_union(float a_8, float b_7)
{
    const float _e3 = factor_of(a_8, true);
    const float _e5 = factor_of(b_7, true);
    return max(_e3, _e5);
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

float4 ramp_plain(float value, Ramp ramp_1)
{
    const float _e2 = footprint_of(value);
    const float _e3 = bounded(value);
    const float4 _e4 = ramp_at(ramp_1, _e3, _e2);
    return _e4;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_7 = (uint3)0;

    v_7 = ((seed * 1664525u) + (1013904223u).xxx);
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
    uint3 _e31 = v_7;
    uint3 _e32 = v_7;
    v_7 = (_e31 ^ (_e32 >> (16u).xxx));
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
    uint3 _e61 = v_7;
    return _e61;
}

float3 unit_of_hash(uint3 hash)
{
    return (float3((hash >> (8u).xxx)) * 5.9604645e-8);
}

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uint3 hash_1, float3 d)
{
    uint axis = naga_mod((hash_1.x >> 8u), 3u);
    float a_12 = ((axis == 0u) ? d.y : d.x);
    float b_10 = ((axis == 2u) ? d.y : d.z);
    return ((((hash_1.y >> 31u) == 0u) ? a_12 : -(a_12)) + (((hash_1.z >> 31u) == 0u) ? b_10 : -(b_10)));
}

float3 fade_quintic(float3 t_4)
{
    return (((t_4 * t_4) * t_4) * ((t_4 * ((t_4 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float value_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i_2 = int(0);

    float3 corner = floor(p);
    const float3 _e4 = fade_quintic((p - corner));
    int3 cell_3 = naga_f2i32(corner);
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e45 = i_2;
            i_2 = asint(asuint(_e45) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e10 = i_2;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_2;
            int _e16 = i_2;
            int _e21 = i_2;
            int3 at_2 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_2 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_3) + asuint(at_2)), seed_2);
            const float3 _e40 = unit_of_hash(_e39);
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e40.x));
        }
    }
    float _e47 = sum;
    return _e47;
}

float perlin_noise(float3 p_1, uint seed_3)
{
    float sum_1 = 0.0;
    int i_3 = int(0);

    float3 corner_1 = floor(p_1);
    float3 d_5 = (p_1 - corner_1);
    const float3 _e4 = fade_quintic(d_5);
    int3 cell_4 = naga_f2i32(corner_1);
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e46 = i_3;
            i_3 = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e10 = i_3;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i_3;
            int _e16 = i_3;
            int _e21 = i_3;
            int3 at_3 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight_1 = ((at_3 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum_1;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_4) + asuint(at_3)), seed_3);
            const float _e42 = gradient_dot(_e39, (d_5 - float3(at_3)));
            sum_1 = (_e32 + (((weight_1.x * weight_1.y) * weight_1.z) * _e42));
        }
    }
    float _e48 = sum_1;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float simplex_corner(float3 d_1, uint3 hash_2)
{
    float t_8 = max((0.5 - dot(d_1, d_1)), 0.0);
    const float _e10 = gradient_dot(hash_2, d_1);
    return ((((t_8 * t_8) * t_8) * t_8) * _e10);
}

float simplex_noise(float3 p_2, uint seed_4)
{
    float sum_2 = (float)0;

    float3 corner_2 = floor((p_2 + ((((p_2.x + p_2.y) + p_2.z) / 3.0)).xxx));
    float3 d_6 = ((p_2 - corner_2) + ((((corner_2.x + corner_2.y) + corner_2.z) / 6.0)).xxx);
    bool3 is_first = bool3((d_6.x >= d_6.y), (d_6.y >= d_6.z), (d_6.z > d_6.x));
    float3 g = (is_first ? (1.0).xxx : (0.0).xxx);
    float3 l = ((1.0).xxx - g);
    float3 second = min(g, l.zxy);
    float3 third = max(g, l.zxy);
    int3 cell_5 = naga_f2i32(corner_2);
    const uint3 _e45 = lattice_hash(cell_5, seed_4);
    const float _e46 = simplex_corner(d_6, _e45);
    sum_2 = _e46;
    float _e48 = sum_2;
    const uint3 _e55 = lattice_hash(asint(asuint(cell_5) + asuint(naga_f2i32(second))), seed_4);
    const float _e56 = simplex_corner(((d_6 - second) + (0.16666667).xxx), _e55);
    sum_2 = (_e48 + _e56);
    float _e58 = sum_2;
    const uint3 _e65 = lattice_hash(asint(asuint(cell_5) + asuint(naga_f2i32(third))), seed_4);
    const float _e66 = simplex_corner(((d_6 - third) + (0.33333334).xxx), _e65);
    sum_2 = (_e58 + _e66);
    float _e68 = sum_2;
    const uint3 _e75 = lattice_hash(asint(asuint(cell_5) + asuint((int(1)).xxx)), seed_4);
    const float _e76 = simplex_corner((d_6 - (0.5).xxx), _e75);
    sum_2 = (_e68 + _e76);
    float _e79 = sum_2;
    return clamp((0.5 + (SIMPLEX_SCALE * _e79)), 0.0, 1.0);
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

float worley_noise(float3 p_3, uint seed_5)
{
    float nearest = 1.0;
    int i_4 = int(0);

    float3 corner_3 = floor(p_3);
    float3 d_7 = (p_3 - corner_3);
    int3 cell_6 = naga_f2i32(corner_3);
    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e40 = i_4;
            i_4 = asint(asuint(_e40) + asuint(int(1)));
        }
        loop_init_4 = false;
        int _e9 = i_4;
        if ((_e9 < int(27))) {
        } else {
            break;
        }
        {
            int _e12 = i_4;
            int _e17 = i_4;
            int _e24 = i_4;
            int3 at_4 = int3(asint(asuint(naga_mod(_e12, int(3))) - asuint(int(1))), asint(asuint(naga_mod(naga_div(_e17, int(3)), int(3))) - asuint(int(1))), asint(asuint(naga_div(_e24, int(9))) - asuint(int(1))));
            const uint3 _e32 = lattice_hash(asint(asuint(cell_6) + asuint(at_4)), seed_5);
            const float3 _e33 = unit_of_hash(_e32);
            float3 offset_1 = ((float3(at_4) + _e33) - d_7);
            float _e36 = nearest;
            nearest = min(_e36, dot(offset_1, offset_1));
        }
    }
    float _e42 = nearest;
    return sqrt(_e42);
}

float noise_octave(uint kind, float3 p_4, uint seed_6)
{
    switch(kind) {
        case 1u: {
            const float _e3 = perlin_noise(p_4, seed_6);
            return _e3;
        }
        case 2u: {
            const float _e4 = simplex_noise(p_4, seed_6);
            return _e4;
        }
        case 3u: {
            const float _e5 = worley_noise(p_4, seed_6);
            return _e5;
        }
        default: {
            const float _e6 = value_noise(p_4, seed_6);
            return _e6;
        }
    }
}

float fractal_noise(uint kind_1, float3 p_5, int octaves, float roughness, int seed_7, float w_2)
{
    float sum_3 = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float frequency = 1.0;
    int i_5 = int(0);
    float octave = (float)0;

    float mean = ((kind_1 == NOISE_WORLEY) ? WORLEY_MEAN : 0.5);
    const float _e11 = bounded(roughness);
    float gain = clamp(_e11, 0.0, 1.0);
    uint2 loop_bound_5 = uint2(4294967295u, 4294967295u);
    bool loop_init_5 = true;
    while(true) {
        if (all(loop_bound_5 == uint2(0u, 0u))) { break; }
        loop_bound_5 -= uint2(loop_bound_5.y == 0u, 1u);
        if (!loop_init_5) {
            int _e75 = i_5;
            i_5 = asint(asuint(_e75) + asuint(int(1)));
        }
        loop_init_5 = false;
        int _e25 = i_5;
        if ((_e25 < clamp(octaves, int(1), int(8)))) {
        } else {
            break;
        }
        {
            float _e30 = frequency;
            const float _e34 = eased((w_2 * _e30), 0.5, 1.0);
            float visible = (1.0 - _e34);
            octave = mean;
            if ((visible > 0.0)) {
                float _e40 = frequency;
                int _e42 = i_5;
                float3 place_5 = clamp(((p_5 * _e40) + (float(_e42) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
                int _e56 = i_5;
                const float _e59 = noise_octave(kind_1, place_5, (asuint(seed_7) + uint(_e56)));
                octave = lerp(mean, _e59, visible);
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

float size_on_screen(float depth, float perspective, float scale)
{
    const float _e10 = bounded(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)));
    return _e10;
}

float3 anchor_on_screen(float3 origin, float perspective_1, float scale_1)
{
    const float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    const float3 _e12 = bounded_vec3_(float3((origin.x * _e5), (-(origin.y) * _e5), _e5));
    return _e12;
}

float2 place_in_picture(float2 pixel, float2 viewport)
{
    const float2 _e2 = bounded_vec2_(pixel);
    float2 from_middle = (_e2 - (0.5 * viewport));
    return (float2(from_middle.x, -(from_middle.y)) / (max(viewport.y, 1.0)).xx);
}

float disk_filtered(float d_2, float r, float w_3)
{
    bool local_2 = (bool)0;

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

uint blue_index(int2 cell_1)
{
    uint2 at_5 = (asuint(cell_1) & (31u).xx);
    return ((8u * at_5.y) + (at_5.x >> 2u));
}

float blue_part(uint four, int2 cell_2)
{
    return ((float(((four >> (8u * (asuint(cell_2.x) & 3u))) & 255u)) + 0.5) * 0.00390625);
}

StretchedPlace ConstructStretchedPlace(float2 arg0, float3 arg1) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    const float2 _e4 = sin_cos_of(angle);
    const float3 _e10 = bounded_vec3_(((_e4.y * along) + (_e4.x * across)));
    const float3 _e16 = bounded_vec3_(((_e4.y * across) - (_e4.x * along)));
    const float2 _e17 = bounded_vec2_(place);
    float2 turned = float2(((_e4.y * _e17.x) + (_e4.x * _e17.y)), ((_e4.y * _e17.y) - (_e4.x * _e17.x)));
    float3 most = (1000000000000000.0).xxx;
    float3 stretch_5 = clamp(float3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    const float2 _e41 = bounded_vec2_(turned);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(_e41, stretch_5);
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
    const float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_3 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    const float2 _e19 = bounded_vec2_(place_1);
    const float2 _e21 = bounded_vec2_((_e19 * scale_3));
    float2 p_7 = clamp(_e21, (-4194304.0).xx, (4194304.0).xx);
    const float3 _e27 = bounded_vec3_(stretch);
    float3 s_1 = clamp(_e27, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_7, (is_pixel ? float3(1.0, 0.0, 1.0) : s_1));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_5 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_5 * sum_5) / 66.0));
}

float octave_of(float square)
{
    const float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

float picture_square(float2 offset, float3 stretch_2)
{
    const float _e2 = area_square(stretch_2);
    float area = max(_e2, 1e-30);
    float square_3 = ((((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y));
    return (max(square_3, 0.0) / area);
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float dots_of_octave(float2 place_2, int zoom, float ink, float3 stretch_3, float w_4, Dots style)
{
    uint tile[256] = BLUE_TILE;
    float sum_4 = 0.0;
    int i_6 = int(0);

    const float _e6 = power_of_two(zoom);
    float2 p_8 = clamp((place_2 * _e6), (-4194304.0).xx, (4194304.0).xx);
    float2 corner_4 = floor(p_8);
    float reach = (1.0 - (0.5 * style.scatter));
    uint2 loop_bound_6 = uint2(4294967295u, 4294967295u);
    bool loop_init_6 = true;
    while(true) {
        if (all(loop_bound_6 == uint2(0u, 0u))) { break; }
        loop_bound_6 -= uint2(loop_bound_6.y == 0u, 1u);
        if (!loop_init_6) {
            int _e93 = i_6;
            i_6 = asint(asuint(_e93) + asuint(int(1)));
        }
        loop_init_6 = false;
        int _e25 = i_6;
        if ((_e25 < int(9))) {
        } else {
            break;
        }
        {
            int _e29 = i_6;
            int _e34 = i_6;
            int2 cell_7 = asint(asuint(naga_f2i32(corner_4)) + asuint(int2(asint(asuint(naga_mod(_e29, int(3))) - asuint(int(1))), asint(asuint(naga_div(_e34, int(3))) - asuint(int(1))))));
            const uint3 _e43 = lattice_hash(int3(cell_7, zoom), style.seed);
            const float3 _e44 = unit_of_hash(_e43);
            float2 middle = ((float2(cell_7) + (0.5).xx) + (style.scatter * (_e44.xy - (0.5).xx)));
            float2 offset_2 = (p_8 - middle);
            int2 turning = asint(asuint(cell_7) + asuint(int2(int((style.seed & 31u)), asint(asuint(zoom) * asuint(int(7))))));
            const uint _e65 = blue_index(turning);
            uint _e67 = tile[min(uint(_e65), 255u)];
            const float _e68 = blue_part(_e67, turning);
            float turn = (0.96875 * _e68);
            float grown = clamp(((ink - turn) * 32.0), 0.0, 1.0);
            float radius = ((0.5 * style.size) * sqrt(grown));
            float far = (length(offset_2) / reach);
            const float _e84 = picture_square(offset_2, stretch_3);
            float d_8 = max(sqrt(_e84), ((far * far) * radius));
            float _e89 = sum_4;
            const float _e90 = disk_filtered(d_8, radius, w_4);
            sum_4 = max(_e89, _e90);
        }
    }
    float _e95 = sum_4;
    return _e95;
}

float stippled(SpacedPlace at_1, float ink_1, Dots style_1)
{
    float dots = (float)0;

    float2 dx_1 = ddx(at_1.place);
    float2 dy_1 = ddy(at_1.place);
    const float _e8 = picture_square(dx_1, at_1.stretch);
    const float _e10 = picture_square(dy_1, at_1.stretch);
    const float _e13 = bounded(sqrt(max(_e8, _e10)));
    const float _e14 = bounded(ink_1);
    float amount = clamp(_e14, 0.0, 1.0);
    float3 s_2 = at_1.stretch;
    const float _e19 = area_square(s_2);
    const float _e21 = octave_of(sqrt(_e19));
    float zoom_1 = floor(_e21);
    float f_1 = (_e21 - zoom_1);
    const float _e26 = exp2_stable((-2.0 * f_1));
    float coarse = (1.0 - f_1);
    float fine = ((1.0 - (coarse * _e26)) / (4.0 * _e26));
    const float _e40 = exp2_stable((2.0 * zoom_1));
    const float _e42 = dots_of_octave(at_1.place, naga_f2i32(zoom_1), (amount * coarse), (s_2 * _e40), _e13, style_1);
    dots = _e42;
    if ((fine > 0.0)) {
        const float _e55 = exp2_stable(((2.0 * zoom_1) + 2.0));
        const float _e57 = dots_of_octave(at_1.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), (amount * fine), (s_2 * _e55), _e13, style_1);
        float _e58 = dots;
        dots = max(_e58, _e57);
    }
    float mean_1 = (amount * min(((0.7853982 * style_1.size) * style_1.size), 1.0));
    float _e68 = dots;
    const float _e71 = eased(_e13, 0.75, 1.5);
    return lerp(_e68, mean_1, _e71);
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_object(float angle_1, float3 anchor, float2 pixel_1, float2 viewport_2)
{
    const float _e5 = bounded(anchor.z);
    float size_1 = clamp(_e5, 1e-6, 1000000.0);
    const float2 _e9 = place_in_picture(pixel_1, viewport_2);
    const float2 _e15 = bounded_vec2_((_e9 - float2(anchor.x, -(anchor.y))));
    float2 place_6 = (_e15 / (size_1).xx);
    const StretchedPlace _e28 = mark_place_of(place_6, float3((1.0 / size_1), 0.0, 0.0), float3(0.0, (1.0 / size_1), 0.0), angle_1);
    const MarkPlace markplace = ConstructMarkPlace(_e28.place, _e28.stretch);
    return markplace;
}

Dots ConstructDots(float arg0, float arg1, uint arg2) {
    Dots ret = (Dots)0;
    ret.size = arg0;
    ret.scatter = arg1;
    ret.seed = arg2;
    return ret;
}

float stippling(float value_1, float2 place_3, float3 stretch_4, float count_1, float size, float scatter, int seed_8, float2 viewport_3)
{
    const float _e8 = bounded(size);
    const float _e12 = bounded(scatter);
    Dots style_2 = ConstructDots(clamp(_e8, 0.0, 1.4), clamp(_e12, 0.0, 1.0), asuint(seed_8));
    const SpacedPlace _e18 = spaced(place_3, stretch_4, viewport_3, count_1);
    const float _e20 = factor_of(value_1, true);
    const float _e23 = stippled(_e18, (1.0 - _e20), style_2);
    return _e23;
}

float reflectance_wrap(Light light, float3 normal_1, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_5 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light.direction);
    return max(((cosine + w_5) / (1.0 + w_5)), 0.0);
}

float add(float a_9, float b_8)
{
    const float _e3 = bounded((a_9 + b_8));
    return _e3;
}

float map_range(float value_2, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_2, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_10, float b_9)
{
    const float _e3 = bounded((a_10 * b_9));
    return _e3;
}

float smooth_step_value(float value_3, float low_2, float high_2)
{
    const float _e3 = eased(value_3, low_2, high_2);
    return _e3;
}

float line_covers(float distance_, float width)
{
    return clamp(((width + 0.5) - distance_), 0.0, min(width, 1.0));
}

float outer_contour(float width_1, float3 normal_2, float3 view_1, float2 viewport_4)
{
    const float3 _e6 = normalize_or(normal_2, (0.0).xxx);
    float facing_1 = clamp(dot(_e6, view_1), 0.0, 1.0);
    const float _e11 = bounded(width_1);
    float pixels = ((clamp(_e11, 0.0, 10000.0) * clamp(viewport_4.y, 1.0, 100000.0)) / 1000.0);
    const float _e22 = footprint_of(facing_1);
    float distance_1 = (facing_1 / max((2.0 * _e22), 1e-6));
    const float _e30 = eased(facing_1, 0.45, 0.75);
    float near = (1.0 - _e30);
    const float _e33 = line_covers(distance_1, pixels);
    return (_e33 * near);
}

float noise_perlin(float3 position, float scale_2, int octaves_1, float roughness_1, int seed_9)
{
    const float3 _e6 = bounded_vec3_((position * scale_2));
    const float _e8 = footprint_of_vec3_(_e6);
    const float _e9 = fractal_noise(NOISE_PERLIN, _e6, octaves_1, roughness_1, seed_9, _e8);
    return _e9;
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

VectorParts separate_vector(float3 vector_)
{
    const VectorParts vectorparts = ConstructVectorParts(vector_.x, vector_.y, vector_.z);
    return vectorparts;
}

float4 shade(Surface surface_1)
{
    const float3 _e2 = position_object(surface_1.position_object);
    const VectorParts _e3 = separate_vector(_e2);
    const float _e9 = noise_perlin(surface_1.position_object, 4.0, int(3), 0.5, int(0));
    const float _e15 = map_range(_e9, 0.0, 1.0, -0.35, 0.35, false);
    const float _e17 = add(_e3.y, _e15);
    const float _e23 = map_range(_e17, -0.9, 0.95, 0.0, 1.0, true);
    const float4 _e25 = ramp_plain(_e23, leaf_to_bloom);
    Light _e28 = look.key;
    const float _e31 = reflectance_wrap(_e28, surface_1.normal, 0.3);
    const float _e37 = map_range(_e31, 0.0, 0.8, 0.02, 1.0, true);
    const float _e43 = map_range(_e37, 0.55, 0.95, 0.85, 0.12, true);
    const float4 _e49 = mix_colors_multiply(float4(0.9725, 0.949, 0.8863, 1.0), _e25, _e43);
    const float _e52 = facing(surface_1.normal, surface_1.view);
    const float _e58 = map_range(_e52, 0.05, 0.6, 0.2, 1.0, true);
    const float _e59 = multiply(_e37, _e58);
    float2 _e65 = look.viewport;
    const MarkPlace _e66 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e65);
    float2 _e75 = look.viewport;
    const float _e76 = stippling(_e59, _e66.place, _e66.stretch, 230.0, 0.72, 0.8, int(0), _e75);
    float2 _e82 = look.viewport;
    const float _e83 = outer_contour(2.0, surface_1.normal, surface_1.view, _e82);
    const float _e84 = combine_tones_union(_e76, _e83);
    const float _e86 = kappa_surface(surface_1.kappa);
    const float _e88 = transition(_e86, 0.25);
    const float _e91 = smooth_step_value(_e88, 0.24, 0.16);
    const float _e92 = combine_tones_union(_e84, _e91);
    const float4 _e98 = mix_colors_normal(_e49, float4(0.1725, 0.1412, 0.1216, 1.0), _e92);
    const float4 _e99 = premultiplied(_e98);
    const float4 _e100 = output(_e99);
    return _e100;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_2.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    out_.position_object = vertex.position;
    float3x3 _e21 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e21);
    Varyings _e24 = out_;
    const Varyings varyings = _e24;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_3, fragmentinput_fs_main.normal_4 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_5 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_5;
    float4 _e15 = view_2.eye;
    float _e20 = view_2.eye.w;
    float4 _e26 = view_2.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    float4 _e42 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e42.x;
    float4 _e49 = view_2.screen;
    float4 _e54 = view_2.screen;
    surface.pixel = ((in_.clip_.xy * _e49.xy) + _e54.zw);
    float4x4 _e60 = view_2.camera_from_world;
    float4 _e64 = object.world_from_object[3];
    float _e73 = view_2.eye.w;
    float _e78 = view_2.clip_from_world[0].y;
    float _e83 = view_2.clip_from_world[1].y;
    float _e88 = view_2.clip_from_world[2].y;
    const float3 _e91 = anchor_on_screen(mul(float4(_e64.xyz, 1.0), _e60).xyz, _e73, length(float3(_e78, _e83, _e88)));
    surface.anchor = _e91;
    Surface _e92 = surface;
    const float4 _e93 = shade(_e92);
    const float4 _e94 = finite_vec4_(_e93);
    return _e94;
}
