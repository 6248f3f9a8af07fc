// Botanical plate: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2, curvature_map t0.
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint NOISE_PERLIN = 1u;
static const float MOST_ON_SCREEN = 1000000000000000.0;
static const uint BLUE_TILE[256] = Constructarray256_uint_(667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);
static const Ramp leaf_to_bloom = ConstructRamp(Constructarray16_float4_(float4(0.4353, 0.5412, 0.2353, 1.0), float4(0.6235, 0.7098, 0.3961, 1.0), float4(0.9098, 0.7255, 0.6275, 1.0), float4(0.8471, 0.3765, 0.4784, 1.0), float4(0.6588, 0.2275, 0.4, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx), Constructarray4_float4_(float4(0.0, 0.35, 0.6, 0.85), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx), 5u, 1u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_1 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_2 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

float4 finite_vec4_(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return (((asuint(v) & exponent) != exponent) ? v : (0.0).xxxx);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float exp2_stable(float x)
{
    float whole = round(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * asfloat((uint(asint(asuint(naga_f2i32(whole)) + asuint(int(126)))) << 23u)));
}

float log2_stable(float x_1)
{
    uint bits = asuint(x_1);
    int exponent_1 = (asint((bits - 1060439283u)) >> 23u);
    float mantissa = asfloat((bits - (asuint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

float3 normalize_moderate(float3 v_1, float3 otherwise)
{
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * rsqrt(max(square, 1e-30))) : otherwise);
}

float3 normalize_seen(float3 v_2)
{
    const float3 _e5 = normalize_moderate(v_2, float3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_2)
{
    uint bits_1 = asuint(x_2);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float3 bounded_vec3_(float3 v_3)
{
    uint3 bits_2 = asuint(v_3);
    uint3 magnitude_1 = (bits_2 & (2147483647u).xxx);
    float3 largest_1 = asfloat(((bits_2 & (2147483648u).xxx) | (2139095039u).xxx));
    float3 numbers = ((magnitude_1 == (2139095040u).xxx) ? largest_1 : (0.0).xxx);
    return ((magnitude_1 < (2139095040u).xxx) ? v_3 : numbers);
}

float4 bounded_vec4_(float4 v_4)
{
    uint4 bits_3 = asuint(v_4);
    uint4 magnitude_2 = (bits_3 & (2147483647u).xxxx);
    float4 largest_2 = asfloat(((bits_3 & (2147483648u).xxxx) | (2139095039u).xxxx));
    float4 numbers_1 = ((magnitude_2 == (2139095040u).xxxx) ? largest_2 : (0.0).xxxx);
    return ((magnitude_2 < (2139095040u).xxxx) ? v_4 : numbers_1);
}

float divided(float a, float b)
{
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    const float _e7 = bounded((a / b));
    return _e7;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t)
{
    float3 d_2 = (b_1 - a_1);
    const float3 _e13 = bounded_vec3_(((t < 0.5) ? (a_1 + (t * d_2)) : (b_1 - ((1.0 - t) * d_2))));
    return _e13;
}

float4 mixed_vec4_(float4 a_2, float4 b_2, float t_1)
{
    const float4 _e4 = bounded_vec4_((b_2 - a_2));
    const float4 _e14 = bounded_vec4_(((t_1 < 0.5) ? (a_2 + (t_1 * _e4)) : (b_2 - ((1.0 - t_1) * _e4))));
    return _e14;
}

float eased(float x_3, float low, float high)
{
    const float _e3 = bounded(x_3);
    const float _e7 = bounded(((_e3 - low) / 0.5));
    float t_4 = clamp(_e7, 0.0, 1.0);
    return ((t_4 * t_4) * (3.0 - (2.0 * t_4)));
}

float eased_2_(float x_4, float low_1, float high_1)
{
    const float _e3 = bounded(x_4);
    const float _e7 = bounded(((_e3 - low_1) / 0.75));
    float t_5 = clamp(_e7, 0.0, 1.0);
    return ((t_5 * t_5) * (3.0 - (2.0 * t_5)));
}

float eased_3_(float x_5, float low_2, float high_2)
{
    float t_6 = clamp(((x_5 - low_2) / (high_2 - low_2)), 0.0, 1.0);
    return ((t_6 * t_6) * (3.0 - (2.0 * t_6)));
}

float footprint_of(float x_6)
{
    float _e1 = ddx(x_6);
    float _e2 = ddy(x_6);
    float2 d_3 = float2(_e1, _e2);
    return sqrt(dot(d_3, d_3));
}

float footprint_of_vec3_(float3 v_5)
{
    float3 dx = ddx(v_5);
    float3 dy = ddy(v_5);
    const float _e7 = bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
    return _e7;
}

float4 hermite(float4 a_3, float4 b_3, float4 from_a, float4 to_b, float t_2)
{
    float4 d_4 = (b_3 - a_3);
    return (a_3 + (t_2 * (from_a + (t_2 * ((((3.0 * d_4) - (2.0 * from_a)) - to_b) + (t_2 * ((from_a + to_b) - (2.0 * d_4))))))));
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

float4 ramp_at(Ramp ramp, float x_7, float w)
{
    float4 colors[16] = (float4[16])0;
    float4 places[4] = (float4[4])0;
    uint i_2_ = 1u;
    uint at = 0u;
    float4 from_a_1 = (0.0).xxxx;
    float4 to_b_1 = (0.0).xxxx;

    colors = ramp.colors;
    places = ramp.places;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
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
        float _e25 = places[min(uint(naga_div(_e17, 4u)), 3u)][min(uint(naga_mod(_e21, 4u)), 3u)];
        at = ((_e25 <= x_7) ? _e16 : _e15);
    }
    uint _e31 = at;
    uint _e35 = at;
    float place_3 = places[min(uint(naga_div(_e31, 4u)), 3u)][min(uint(naga_mod(_e35, 4u)), 3u)];
    uint _e40 = at;
    if ((((_e40 + 1u) >= 5u) | (x_7 <= place_3))) {
        uint _e47 = at;
        float4 _e49 = colors[min(uint(_e47), 15u)];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = (_e50 + 1u);
    float _e59 = places[min(uint(naga_div(after_1, 4u)), 3u)][min(uint(naga_mod(after_1, 4u)), 3u)];
    float span = (_e59 - place_3);
    const float _e62 = divided((x_7 - place_3), span);
    float t_7 = clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if ((_e69 > 0u)) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places[min(uint(naga_div((_e72 - 1u), 4u)), 3u)][min(uint(naga_mod((_e78 - 1u), 4u)), 3u)];
        uint _e85 = at;
        float4 _e87 = colors[min(uint(_e85), 15u)];
        uint _e88 = at;
        float4 _e92 = colors[min(uint((_e88 - 1u)), 15u)];
        float4 _e96 = colors[min(uint(after_1), 15u)];
        uint _e97 = at;
        float4 _e99 = colors[min(uint(_e97), 15u)];
        const float4 _e101 = ramp_slope((_e87 - _e92), (place_3 - before_1), (_e96 - _e99), span);
        from_a_1 = _e101;
    }
    if (((after_1 + 1u) < 5u)) {
        float _e119 = places[min(uint(naga_div((after_1 + 1u), 4u)), 3u)][min(uint(naga_mod((after_1 + 1u), 4u)), 3u)];
        float next = (_e119 - (place_3 + span));
        float4 _e123 = colors[min(uint(after_1), 15u)];
        uint _e124 = at;
        float4 _e126 = colors[min(uint(_e124), 15u)];
        float4 _e131 = colors[min(uint((after_1 + 1u)), 15u)];
        float4 _e133 = colors[min(uint(after_1), 15u)];
        const float4 _e135 = ramp_slope((_e123 - _e126), span, (_e131 - _e133), next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    float4 _e138 = colors[min(uint(_e136), 15u)];
    float4 _e140 = colors[min(uint(after_1), 15u)];
    float4 _e141 = from_a_1;
    float4 _e143 = to_b_1;
    const float4 _e145 = hermite(_e138, _e140, (span * _e141), (span * _e143), t_7);
    const float4 _e146 = bounded_vec4_(_e145);
    return _e146;
}

float4 mix_colors_multiply(float4 a_4, float4 b_4, float factor)
{
    const float3 _e7 = mixed_vec3_(a_4.xyz, (a_4.xyz * b_4.xyz), factor);
    return float4(_e7, 1.0);
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_6 = (uint3)0;

    v_6 = ((seed * 1664525u) + (1013904223u).xxx);
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
    uint3 _e31 = v_6;
    uint3 _e32 = v_6;
    v_6 = (_e31 ^ (_e32 >> (16u).xxx));
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
    uint3 _e61 = v_6;
    return _e61;
}

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod((hash.x >> 8u), 3u);
    float a_5 = ((axis == 0u) ? d.y : d.x);
    float b_5 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_5 : -(a_5)) + (((hash.z >> 31u) == 0u) ? b_5 : -(b_5)));
}

float3 fade_quintic(float3 t_3)
{
    return (((t_3 * t_3) * t_3) * ((t_3 * ((t_3 * 6.0) - (15.0).xxx)) + (10.0).xxx));
}

int3 naga_f2i32(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

float perlin_noise(float3 p, uint seed_2)
{
    float sum = 0.0;
    int i = int(0);

    float3 corner = floor(p);
    float3 d_5 = (p - corner);
    const float3 _e4 = fade_quintic(d_5);
    int3 cell_2 = naga_f2i32(corner);
    uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
    bool loop_init_1 = true;
    while(true) {
        if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
        loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
        if (!loop_init_1) {
            int _e46 = i;
            i = asint(asuint(_e46) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e10 = i;
        if ((_e10 < int(8))) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            int3 at_2 = int3((_e13 & int(1)), ((_e16 >> 1u) & int(1)), (_e21 >> 2u));
            float3 weight = ((at_2 == (int(1)).xxx) ? _e4 : ((1.0).xxx - _e4));
            float _e32 = sum;
            const uint3 _e39 = lattice_hash(asint(asuint(cell_2) + asuint(at_2)), seed_2);
            const float _e42 = gradient_dot(_e39, (d_5 - float3(at_2)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, float3 p_1, int octaves, float roughness, int seed_3, float w_1)
{
    float octave = (float)0;
    int i_1 = int(0);
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;

    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e66 = i_1;
            i_1 = asint(asuint(_e66) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e17 = i_1;
        if (!((_e17 < int(3)))) {
            break;
        }
        float _e21 = frequency;
        const float _e25 = eased((w_1 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            float3 place_4 = clamp(((p_1 * _e31) + (float(_e33) * float3(17.31, 5.17, 11.73))), (-4194304.0).xxx, (4194304.0).xxx);
            int _e47 = i_1;
            const float _e50 = perlin_noise(place_4, (0u + uint(_e47)));
            octave = lerp(0.5, _e50, visible);
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

float size_on_screen(float depth, float perspective, float scale)
{
    return min(((0.5 * scale) / lerp(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

float3 anchor_on_screen(float3 origin, float perspective_1, float scale_1)
{
    const float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(float3((origin.x * _e5), (-(origin.y) * _e5), _e5), (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
}

float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = (pixel - (0.5 * viewport));
    return (float2(from_middle.x, -(from_middle.y)) / (max(viewport.y, 1.0)).xx);
}

float disk_filtered(float d_1, float r, float w_2)
{
    if ((w_2 < 1e-30)) {
        return (((d_1 <= r) & (r > 0.0)) ? 1.0 : 0.0);
    }
    float square_1 = (r * r);
    float least = ((w_2 * w_2) / 3.0);
    float inner = sqrt((max(square_1, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d_1) / w_2)), 0.0, 1.0) * min((square_1 / least), 1.0));
}

uint blue_index(int2 cell_1)
{
    uint2 at_3 = (asuint(cell_1) & (31u).xx);
    return ((8u * at_3.y) + (at_3.x >> 2u));
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
    float3 x_8 = ((turn.y * along) + (turn.x * across));
    float3 y = ((turn.y * across) - (turn.x * along));
    float2 turned = float2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    float3 stretch_4 = float3(dot(x_8, x_8), dot(x_8, y), dot(y, y));
    const StretchedPlace stretchedplace = ConstructStretchedPlace(turned, stretch_4);
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
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_3 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    float2 p_2 = clamp((place_1 * scale_3), (-4194304.0).xx, (4194304.0).xx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_2, (is_pixel ? float3(1.0, 0.0, 1.0) : stretch));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_3 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_3 * sum_3) / 66.0));
}

float picture_square(float2 offset, float3 stretch_2)
{
    const float _e2 = area_square(stretch_2);
    float area = max(_e2, 1e-30);
    float square_2 = ((((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y));
    return (max(square_2, 0.0) / area);
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float dots_of_octave(float2 place_2, int zoom, float ink, float3 stretch_3, float w_3, Dots style)
{
    int i_2 = int(0);
    float sum_2 = 0.0;
    uint tile[256] = BLUE_TILE;

    float2 p_3 = clamp((place_2 * asfloat((uint(asint(asuint(zoom) + asuint(int(127)))) << 23u))), (-4194304.0).xx, (4194304.0).xx);
    float2 corner_1 = floor(p_3);
    float reach = (1.0 - (0.5 * style.scatter));
    uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
    bool loop_init_3 = true;
    while(true) {
        if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
        loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
        if (!loop_init_3) {
            int _e118 = i_2;
            i_2 = asint(asuint(_e118) + asuint(int(1)));
        }
        loop_init_3 = false;
        int _e30 = i_2;
        if (!((_e30 < int(9)))) {
            break;
        }
        int _e35 = i_2;
        int _e40 = i_2;
        int2 cell_3 = asint(asuint(naga_f2i32(corner_1)) + asuint(int2(asint(asuint(naga_mod(_e35, int(3))) - asuint(int(1))), asint(asuint(naga_div(_e40, int(3))) - asuint(int(1))))));
        const uint3 _e54 = hash_pcg3d((asuint(int3(cell_3, zoom)) + uint3(0u, 0u, 0u)));
        float3 chance = (float3((_e54 >> (8u).xxx)) * 5.9604645e-8);
        float2 middle = ((float2(cell_3) + (0.5).xx) + (style.scatter * (chance.xy - (0.5).xx)));
        float2 offset_1 = (p_3 - middle);
        int2 turning = asint(asuint(cell_3) + asuint(int2(int(0), asint(asuint(zoom) * asuint(int(7))))));
        const uint _e78 = blue_index(turning);
        uint _e80 = tile[min(uint(_e78), 255u)];
        float turn_1 = (0.96875 * ((float(((_e80 >> (8u * (asuint(turning.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
        float grown = clamp(((ink - turn_1) * 32.0), 0.0, 1.0);
        float radius = ((0.5 * style.size) * sqrt(grown));
        float far = (length(offset_1) / reach);
        const float _e110 = picture_square(offset_1, stretch_3);
        float d_6 = max(sqrt(_e110), ((far * far) * radius));
        float _e115 = sum_2;
        const float _e116 = disk_filtered(d_6, radius, w_3);
        sum_2 = max(_e115, _e116);
    }
    float _e121 = sum_2;
    return _e121;
}

float stippled(SpacedPlace at_1, float ink_1, Dots style_1)
{
    float dots = (float)0;

    float2 dx_1 = ddx(at_1.place);
    float2 dy_1 = ddy(at_1.place);
    const float _e8 = picture_square(dx_1, at_1.stretch);
    const float _e10 = picture_square(dy_1, at_1.stretch);
    const float _e13 = bounded(sqrt(max(_e8, _e10)));
    const float _e15 = area_square(at_1.stretch);
    const float _e19 = log2_stable(max(sqrt(_e15), 1e-30));
    float level = clamp((-0.5 * _e19), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    const float _e29 = exp2_stable((-2.0 * f_1));
    float coarse = (1.0 - f_1);
    float fine = ((1.0 - (coarse * _e29)) / (4.0 * _e29));
    const float _e44 = exp2_stable((2.0 * zoom_1));
    const float _e46 = dots_of_octave(at_1.place, naga_f2i32(zoom_1), (ink_1 * coarse), (at_1.stretch * _e44), _e13, style_1);
    dots = _e46;
    if ((fine > 0.0)) {
        const float _e60 = exp2_stable(((2.0 * zoom_1) + 2.0));
        const float _e62 = dots_of_octave(at_1.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), (ink_1 * fine), (at_1.stretch * _e60), _e13, style_1);
        float _e63 = dots;
        dots = max(_e63, _e62);
    }
    float mean = (ink_1 * ((0.7853982 * style_1.size) * style_1.size));
    float _e71 = dots;
    const float _e74 = eased_2_(_e13, 0.75, 1.5);
    return lerp(_e71, mean, _e74);
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_object(float angle_1, float3 anchor, float2 pixel_1, float2 viewport_2)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    const float2 _e8 = place_in_picture(pixel_1, viewport_2);
    float2 place_5 = ((_e8 - float2(anchor.x, -(anchor.y))) / (size).xx);
    const StretchedPlace _e26 = mark_place_of(place_5, float3((1.0 / size), 0.0, 0.0), float3(0.0, (1.0 / size), 0.0), angle_1);
    const MarkPlace markplace = ConstructMarkPlace(_e26.place, _e26.stretch);
    return markplace;
}

float outer_contour(float width, float3 normal, float3 view, float2 viewport_3)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = ((width * clamp(viewport_3.y, 1.0, 100000.0)) / 1000.0);
    const float _e15 = footprint_of(facing);
    float distance_ = (facing / max((2.0 * _e15), 1e-6));
    float near = (1.0 - smoothstep(0.45, 0.75, facing));
    return (clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * near);
}

float noise_perlin(float3 position, float scale_2, int octaves_1, float roughness_1, int seed_4)
{
    float3 p_4 = (position * scale_2);
    const float _e7 = footprint_of_vec3_(p_4);
    const float _e8 = fractal_noise(NOISE_PERLIN, p_4, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

VectorParts ConstructVectorParts(float arg0, float arg1, float arg2) {
    VectorParts ret = (VectorParts)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

Dots ConstructDots(float arg0, float arg1, uint arg2) {
    Dots ret = (Dots)0;
    ret.size = arg0;
    ret.scatter = arg1;
    ret.seed = arg2;
    return ret;
}

float4 shade(Surface surface)
{
    float3 where_2_ = surface.position_object;
    VectorParts parts = ConstructVectorParts(where_2_.x, where_2_.y, where_2_.z);
    const float _e11 = noise_perlin(surface.position_object, 4.0, int(3), 0.5, int(0));
    float height_mottled = (parts.y + lerp(-0.35, 0.35, (_e11 - 0.0)));
    float share = clamp(((height_mottled + 0.9) / 1.85), 0.0, 1.0);
    const float _e27 = footprint_of(share);
    const float4 _e28 = ramp_at(leaf_to_bloom, share, _e27);
    float3 _e33 = look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e33) + 0.3) / 1.3), 0.0);
    float tone = lerp(0.02, 1.0, min(((shade_2_ - 0.0) / 0.8), 1.0));
    float short_of_the_light = lerp(0.85, 0.12, clamp(((tone - 0.55) / 0.4), 0.0, 1.0));
    const float4 _e65 = mix_colors_multiply(float4(0.9725, 0.949, 0.8863, 1.0), _e28, short_of_the_light);
    float facing_1 = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    float turning_away = lerp(0.2, 1.0, clamp(((facing_1 - 0.05) / 0.55), 0.0, 1.0));
    float engraved_tone = (tone * turning_away);
    float2 _e88 = look.viewport;
    const MarkPlace _e89 = mark_place_object(0.0, surface.anchor, surface.pixel, _e88);
    float2 _e94 = look.viewport;
    const SpacedPlace _e96 = spaced(_e89.place, _e89.stretch, _e94, 230.0);
    const float _e105 = stippled(_e96, (1.0 - min(engraved_tone, 1.0)), ConstructDots(0.72, 0.8, 0u));
    float2 _e111 = look.viewport;
    const float _e112 = outer_contour(2.0, surface.normal, surface.view, _e111);
    float curvature = surface.kappa;
    float hollow = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.25), -20.0, 20.0))))))));
    const float _e134 = eased_3_(hollow, 0.24, 0.16);
    float ink_2 = max(max(_e105, _e112), _e134);
    const float4 _e137 = bounded_vec4_(_e65);
    const float4 _e143 = mixed_vec4_(_e137, float4(0.1725, 0.1412, 0.1216, 1.0), ink_2);
    const float4 _e144 = finite_vec4_(_e143);
    return _e144;
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
    float4x4 _e10 = view_1.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float arg3, float2 arg4, float3 arg5) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.kappa = arg3;
    ret.pixel = arg4;
    ret.anchor = arg5;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_1, fragmentinput_fs_main.normal_2 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_3 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_1.eye;
    float _e13 = view_1.eye.w;
    float4 _e24 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e30 = view_1.screen;
    float4 _e35 = view_1.screen;
    float4x4 _e40 = view_1.camera_from_world;
    float4 _e44 = object.world_from_object[3];
    float _e53 = view_1.eye.w;
    float _e58 = view_1.clip_from_world[0].y;
    float _e63 = view_1.clip_from_world[1].y;
    float _e68 = view_1.clip_from_world[2].y;
    const float3 _e71 = anchor_on_screen(mul(float4(_e44.xyz, 1.0), _e40).xyz, _e53, length(float3(_e58, _e63, _e68)));
    Surface surface_1 = ConstructSurface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x, ((in_.clip_.xy * _e30.xy) + _e35.zw), _e71);
    const float4 _e73 = shade(surface_1);
    const float4 _e74 = finite_vec4_(_e73);
    return _e74;
}
