// Stipple: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_1 b0, object b1, look b2.
// stipple.json says what to put there and how to draw.
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
    float2 pixel;
    int _pad3_0;
    int _pad3_1;
    float3 anchor;
    int _end_pad_0;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
};

typedef uint ret_Constructarray256_uint_[256];
ret_Constructarray256_uint_ Constructarray256_uint_(uint arg0, uint arg1, uint arg2, uint arg3, uint arg4, uint arg5, uint arg6, uint arg7, uint arg8, uint arg9, uint arg10, uint arg11, uint arg12, uint arg13, uint arg14, uint arg15, uint arg16, uint arg17, uint arg18, uint arg19, uint arg20, uint arg21, uint arg22, uint arg23, uint arg24, uint arg25, uint arg26, uint arg27, uint arg28, uint arg29, uint arg30, uint arg31, uint arg32, uint arg33, uint arg34, uint arg35, uint arg36, uint arg37, uint arg38, uint arg39, uint arg40, uint arg41, uint arg42, uint arg43, uint arg44, uint arg45, uint arg46, uint arg47, uint arg48, uint arg49, uint arg50, uint arg51, uint arg52, uint arg53, uint arg54, uint arg55, uint arg56, uint arg57, uint arg58, uint arg59, uint arg60, uint arg61, uint arg62, uint arg63, uint arg64, uint arg65, uint arg66, uint arg67, uint arg68, uint arg69, uint arg70, uint arg71, uint arg72, uint arg73, uint arg74, uint arg75, uint arg76, uint arg77, uint arg78, uint arg79, uint arg80, uint arg81, uint arg82, uint arg83, uint arg84, uint arg85, uint arg86, uint arg87, uint arg88, uint arg89, uint arg90, uint arg91, uint arg92, uint arg93, uint arg94, uint arg95, uint arg96, uint arg97, uint arg98, uint arg99, uint arg100, uint arg101, uint arg102, uint arg103, uint arg104, uint arg105, uint arg106, uint arg107, uint arg108, uint arg109, uint arg110, uint arg111, uint arg112, uint arg113, uint arg114, uint arg115, uint arg116, uint arg117, uint arg118, uint arg119, uint arg120, uint arg121, uint arg122, uint arg123, uint arg124, uint arg125, uint arg126, uint arg127, uint arg128, uint arg129, uint arg130, uint arg131, uint arg132, uint arg133, uint arg134, uint arg135, uint arg136, uint arg137, uint arg138, uint arg139, uint arg140, uint arg141, uint arg142, uint arg143, uint arg144, uint arg145, uint arg146, uint arg147, uint arg148, uint arg149, uint arg150, uint arg151, uint arg152, uint arg153, uint arg154, uint arg155, uint arg156, uint arg157, uint arg158, uint arg159, uint arg160, uint arg161, uint arg162, uint arg163, uint arg164, uint arg165, uint arg166, uint arg167, uint arg168, uint arg169, uint arg170, uint arg171, uint arg172, uint arg173, uint arg174, uint arg175, uint arg176, uint arg177, uint arg178, uint arg179, uint arg180, uint arg181, uint arg182, uint arg183, uint arg184, uint arg185, uint arg186, uint arg187, uint arg188, uint arg189, uint arg190, uint arg191, uint arg192, uint arg193, uint arg194, uint arg195, uint arg196, uint arg197, uint arg198, uint arg199, uint arg200, uint arg201, uint arg202, uint arg203, uint arg204, uint arg205, uint arg206, uint arg207, uint arg208, uint arg209, uint arg210, uint arg211, uint arg212, uint arg213, uint arg214, uint arg215, uint arg216, uint arg217, uint arg218, uint arg219, uint arg220, uint arg221, uint arg222, uint arg223, uint arg224, uint arg225, uint arg226, uint arg227, uint arg228, uint arg229, uint arg230, uint arg231, uint arg232, uint arg233, uint arg234, uint arg235, uint arg236, uint arg237, uint arg238, uint arg239, uint arg240, uint arg241, uint arg242, uint arg243, uint arg244, uint arg245, uint arg246, uint arg247, uint arg248, uint arg249, uint arg250, uint arg251, uint arg252, uint arg253, uint arg254, uint arg255) {
    uint ret[256] = { arg0, arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10, arg11, arg12, arg13, arg14, arg15, arg16, arg17, arg18, arg19, arg20, arg21, arg22, arg23, arg24, arg25, arg26, arg27, arg28, arg29, arg30, arg31, arg32, arg33, arg34, arg35, arg36, arg37, arg38, arg39, arg40, arg41, arg42, arg43, arg44, arg45, arg46, arg47, arg48, arg49, arg50, arg51, arg52, arg53, arg54, arg55, arg56, arg57, arg58, arg59, arg60, arg61, arg62, arg63, arg64, arg65, arg66, arg67, arg68, arg69, arg70, arg71, arg72, arg73, arg74, arg75, arg76, arg77, arg78, arg79, arg80, arg81, arg82, arg83, arg84, arg85, arg86, arg87, arg88, arg89, arg90, arg91, arg92, arg93, arg94, arg95, arg96, arg97, arg98, arg99, arg100, arg101, arg102, arg103, arg104, arg105, arg106, arg107, arg108, arg109, arg110, arg111, arg112, arg113, arg114, arg115, arg116, arg117, arg118, arg119, arg120, arg121, arg122, arg123, arg124, arg125, arg126, arg127, arg128, arg129, arg130, arg131, arg132, arg133, arg134, arg135, arg136, arg137, arg138, arg139, arg140, arg141, arg142, arg143, arg144, arg145, arg146, arg147, arg148, arg149, arg150, arg151, arg152, arg153, arg154, arg155, arg156, arg157, arg158, arg159, arg160, arg161, arg162, arg163, arg164, arg165, arg166, arg167, arg168, arg169, arg170, arg171, arg172, arg173, arg174, arg175, arg176, arg177, arg178, arg179, arg180, arg181, arg182, arg183, arg184, arg185, arg186, arg187, arg188, arg189, arg190, arg191, arg192, arg193, arg194, arg195, arg196, arg197, arg198, arg199, arg200, arg201, arg202, arg203, arg204, arg205, arg206, arg207, arg208, arg209, arg210, arg211, arg212, arg213, arg214, arg215, arg216, arg217, arg218, arg219, arg220, arg221, arg222, arg223, arg224, arg225, arg226, arg227, arg228, arg229, arg230, arg231, arg232, arg233, arg234, arg235, arg236, arg237, arg238, arg239, arg240, arg241, arg242, arg243, arg244, arg245, arg246, arg247, arg248, arg249, arg250, arg251, arg252, arg253, arg254, arg255 };
    return ret;
}

static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint BLUE_TILE[256] = Constructarray256_uint_(667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);

cbuffer view_1 : register(b0) { View view_1; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
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
    float p = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p * _e33) * _e37);
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

float mixed(float a, float b, float t)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4))));
    return _e14;
}

float3 mixed_vec3_(float3 a_1, float3 b_1, float t_1)
{
    const float _e5 = mixed(a_1.x, b_1.x, t_1);
    const float _e8 = mixed(a_1.y, b_1.y, t_1);
    const float _e11 = mixed(a_1.z, b_1.z, t_1);
    return float3(_e5, _e8, _e11);
}

float4 mixed_vec4_(float4 a_2, float4 b_2, float t_2)
{
    const float3 _e5 = mixed_vec3_(a_2.xyz, b_2.xyz, t_2);
    const float _e8 = mixed(a_2.w, b_2.w, t_2);
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
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
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

float4 premultiplied(float4 color)
{
    return float4((color.xyz * color.w), color.w);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float4 mix_colors_normal(float4 a_3, float4 b_3, float factor)
{
    const float4 _e3 = bounded_vec4_(a_3);
    const float4 _e4 = bounded_vec4_(b_3);
    const float _e6 = factor_of(factor, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float facing(float3 normal, float3 view)
{
    const float3 _e4 = normalize_or(normal, (0.0).xxx);
    return clamp(dot(_e4, view), 0.0, 1.0);
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
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

float3 unit_of_hash(uint3 hash)
{
    return (float3((hash >> (8u).xxx)) * 5.9604645e-8);
}

uint3 lattice_hash(int3 cell, uint seed_1)
{
    const uint3 _e9 = hash_pcg3d((asuint(cell) + (seed_1 * uint3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
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

float disk_filtered(float d, float r, float w)
{
    bool local_1 = (bool)0;

    if ((w < 1e-30)) {
        if ((d <= r)) {
            local_1 = (r > 0.0);
        } else {
            local_1 = false;
        }
        bool _e11 = local_1;
        return (_e11 ? 1.0 : 0.0);
    }
    float square_2 = (r * r);
    float least = ((w * w) / 3.0);
    float inner = sqrt((max(square_2, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d) / w)), 0.0, 1.0) * min((square_2 / least), 1.0));
}

uint blue_index(int2 cell_1)
{
    uint2 at_1 = (asuint(cell_1) & (31u).xx);
    return ((8u * at_1.y) + (at_1.x >> 2u));
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
    float scale_2 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    const float2 _e19 = bounded_vec2_(place_1);
    const float2 _e21 = bounded_vec2_((_e19 * scale_2));
    float2 p_1 = clamp(_e21, (-4194304.0).xx, (4194304.0).xx);
    const float3 _e27 = bounded_vec3_(stretch);
    float3 s_1 = clamp(_e27, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_1, (is_pixel ? float3(1.0, 0.0, 1.0) : s_1));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
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

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float dots_of_octave(float2 place_2, int zoom, float ink, float3 stretch_3, float w_1, Dots style)
{
    uint tile[256] = BLUE_TILE;
    float sum = 0.0;
    int i = int(0);

    const float _e6 = power_of_two(zoom);
    float2 p_2 = clamp((place_2 * _e6), (-4194304.0).xx, (4194304.0).xx);
    float2 corner = floor(p_2);
    float reach = (1.0 - (0.5 * style.scatter));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e93 = i;
            i = asint(asuint(_e93) + asuint(int(1)));
        }
        loop_init = false;
        int _e25 = i;
        if ((_e25 < int(9))) {
        } else {
            break;
        }
        {
            int _e29 = i;
            int _e34 = i;
            int2 cell_3 = asint(asuint(naga_f2i32(corner)) + asuint(int2(asint(asuint(naga_mod(_e29, int(3))) - asuint(int(1))), asint(asuint(naga_div(_e34, int(3))) - asuint(int(1))))));
            const uint3 _e43 = lattice_hash(int3(cell_3, zoom), style.seed);
            const float3 _e44 = unit_of_hash(_e43);
            float2 middle = ((float2(cell_3) + (0.5).xx) + (style.scatter * (_e44.xy - (0.5).xx)));
            float2 offset_1 = (p_2 - middle);
            int2 turning = asint(asuint(cell_3) + asuint(int2(int((style.seed & 31u)), asint(asuint(zoom) * asuint(int(7))))));
            const uint _e65 = blue_index(turning);
            uint _e67 = tile[min(uint(_e65), 255u)];
            const float _e68 = blue_part(_e67, turning);
            float turn = (0.96875 * _e68);
            float grown = clamp(((ink - turn) * 32.0), 0.0, 1.0);
            float radius = ((0.5 * style.size) * sqrt(grown));
            float far = (length(offset_1) / reach);
            const float _e84 = picture_square(offset_1, stretch_3);
            float d_1 = max(sqrt(_e84), ((far * far) * radius));
            float _e89 = sum;
            const float _e90 = disk_filtered(d_1, radius, w_1);
            sum = max(_e89, _e90);
        }
    }
    float _e95 = sum;
    return _e95;
}

float stippled(SpacedPlace at, float ink_1, Dots style_1)
{
    float dots = (float)0;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    const float _e8 = picture_square(dx, at.stretch);
    const float _e10 = picture_square(dy, at.stretch);
    const float _e13 = bounded(sqrt(max(_e8, _e10)));
    const float _e14 = bounded(ink_1);
    float amount = clamp(_e14, 0.0, 1.0);
    float3 s_2 = at.stretch;
    const float _e19 = area_square(s_2);
    const float _e21 = octave_of(sqrt(_e19));
    float zoom_1 = floor(_e21);
    float f_1 = (_e21 - zoom_1);
    const float _e26 = exp2_stable((-2.0 * f_1));
    float coarse = (1.0 - f_1);
    float fine = ((1.0 - (coarse * _e26)) / (4.0 * _e26));
    const float _e40 = exp2_stable((2.0 * zoom_1));
    const float _e42 = dots_of_octave(at.place, naga_f2i32(zoom_1), (amount * coarse), (s_2 * _e40), _e13, style_1);
    dots = _e42;
    if ((fine > 0.0)) {
        const float _e55 = exp2_stable(((2.0 * zoom_1) + 2.0));
        const float _e57 = dots_of_octave(at.place, asint(asuint(naga_f2i32(zoom_1)) + asuint(int(1))), (amount * fine), (s_2 * _e55), _e13, style_1);
        float _e58 = dots;
        dots = max(_e58, _e57);
    }
    float mean = (amount * min(((0.7853982 * style_1.size) * style_1.size), 1.0));
    float _e68 = dots;
    const float _e71 = eased(_e13, 0.75, 1.5);
    return lerp(_e68, mean, _e71);
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
    float2 place_4 = (_e15 / (size_1).xx);
    const StretchedPlace _e28 = mark_place_of(place_4, float3((1.0 / size_1), 0.0, 0.0), float3(0.0, (1.0 / size_1), 0.0), angle_1);
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

float stippling(float value, float2 place_3, float3 stretch_4, float count_1, float size, float scatter, int seed_2, float2 viewport_3)
{
    const float _e8 = bounded(size);
    const float _e12 = bounded(scatter);
    Dots style_2 = ConstructDots(clamp(_e8, 0.0, 1.4), clamp(_e12, 0.0, 1.0), asuint(seed_2));
    const SpacedPlace _e18 = spaced(place_3, stretch_4, viewport_3, count_1);
    const float _e20 = factor_of(value, true);
    const float _e23 = stippled(_e18, (1.0 - _e20), style_2);
    return _e23;
}

float reflectance_wrap(Light light, float3 normal_1, float wrap)
{
    const float _e3 = bounded(wrap);
    float w_2 = clamp(_e3, 0.0, 1.0);
    const float3 _e11 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float cosine = dot(_e11, light.direction);
    return max(((cosine + w_2) / (1.0 + w_2)), 0.0);
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float multiply(float a_4, float b_4)
{
    const float _e3 = bounded((a_4 * b_4));
    return _e3;
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const float _e6 = reflectance_wrap(_e3, surface_1.normal, 0.3);
    const float _e9 = facing(surface_1.normal, surface_1.view);
    const float _e15 = map_range(_e9, 0.0, 0.55, 0.0, 1.0, true);
    const float _e16 = multiply(_e6, _e15);
    const float _e22 = map_range(_e16, 0.0, 0.85, 0.0, 1.0, true);
    float2 _e28 = look.viewport;
    const MarkPlace _e29 = mark_place_object(0.0, surface_1.anchor, surface_1.pixel, _e28);
    float2 _e38 = look.viewport;
    const float _e39 = stippling(_e22, _e29.place, _e29.stretch, 210.0, 0.85, 0.8, int(0), _e38);
    const float4 _e50 = mix_colors_normal(float4(0.965, 0.95, 0.915, 1.0), float4(0.09, 0.12, 0.22, 1.0), _e39);
    const float4 _e51 = premultiplied(_e50);
    const float4 _e52 = output(_e51);
    return _e52;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_1.clip_from_world;
    out_.clip_ = mul(world, _e12);
    out_.position = world.xyz;
    float3x3 _e19 = object.world_from_normal;
    out_.normal = mul(vertex.normal, _e19);
    Varyings _e22 = out_;
    const Varyings varyings = _e22;
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_4 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_4;
    float4 _e15 = view_1.eye;
    float _e20 = view_1.eye.w;
    float4 _e26 = view_1.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    float4 _e39 = view_1.screen;
    float4 _e44 = view_1.screen;
    surface.pixel = ((in_.clip_.xy * _e39.xy) + _e44.zw);
    float4x4 _e50 = view_1.camera_from_world;
    float4 _e54 = object.world_from_object[3];
    float _e63 = view_1.eye.w;
    float _e68 = view_1.clip_from_world[0].y;
    float _e73 = view_1.clip_from_world[1].y;
    float _e78 = view_1.clip_from_world[2].y;
    const float3 _e81 = anchor_on_screen(mul(float4(_e54.xyz, 1.0), _e50).xyz, _e63, length(float3(_e68, _e73, _e78)));
    surface.anchor = _e81;
    Surface _e82 = surface;
    const float4 _e83 = shade(_e82);
    const float4 _e84 = finite_vec4_(_e83);
    return _e84;
}
