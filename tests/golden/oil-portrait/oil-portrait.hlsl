// Oil portrait: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_4 b0, object b1, look b2, curvature_map t0, smooth_normal_1_map t1, smooth_normal_3_map t2.
// oil-portrait.json says what to put there and how to draw.
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
    float4 toned_canvas;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    float4 accents_as_paint_b;
    Light sky;
    float4 cool_reflections_as_paint_b;
    Light key;
    float4 thick_lights_as_paint_b;
    float4 light_as_paint_b;
    float4 half_tones_as_paint_b;
    float4 umber_as_paint_b;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_object;
    float kappa;
    float3 smooth_normal_1_;
    int _pad5_0;
    float3 smooth_normal_3_;
    int _pad6_0;
    float2 pixel;
    int _pad7_0;
    int _pad7_1;
    float3 anchor;
    float magnification;
    row_major float3x3 world_from_normal;
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

struct Brush {
    float aspect;
    float size;
    float scatter;
    float turn;
    uint seed;
    bool is_dark;
};

struct Brushstroke {
    float2 uv;
    float2 turn;
    float way;
    float share;
};

struct BrushStrokes {
    float4 color;
    float ink;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
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
    float3 position_object : LOC1;
    float3 normal : LOC2;
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

cbuffer view_4 : register(b0) { View view_4; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);
Texture2D<float4> smooth_normal_1_map : register(t1);
Texture2D<float4> smooth_normal_3_map : register(t2);

struct VertexOutput_vs_main {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_8 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_9 : LOC2;
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
    float p_1 = (1.0 + (f * (1.0 + (f * (0.5 + (f * (0.16666667 + (f * (0.041666668 + (f * (0.008333334 + (f * (0.0013888889 + (f * 0.0001984127))))))))))))));
    int half_whole = naga_div(naga_f2i32(whole), int(2));
    const float _e33 = power_of_two(half_whole);
    const float _e37 = power_of_two(asint(asuint(naga_f2i32(whole)) - asuint(half_whole)));
    return ((p_1 * _e33) * _e37);
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
    float r = (((x_5 - (turns * 3.140625)) - (turns * 0.00096702576)) - (turns * 6.2783295e-7));
    float sign_ = (1.0 - (2.0 * abs((turns - (2.0 * trunc((turns * 0.5)))))));
    const float2 _e27 = sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
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

float4 color_mixed(float4 a_3, float3 blended, float factor)
{
    const float3 _e4 = bounded_vec3_(a_3.xyz);
    const float3 _e5 = bounded_vec3_(blended);
    const float _e7 = factor_of(factor, true);
    const float3 _e8 = mixed_vec3_(_e4, _e5, _e7);
    const float _e10 = bounded(a_3.w);
    return float4(_e8, _e10);
}

float unit_share(float share)
{
    return clamp(share, 0.0, 1.0);
}

float4 with_unit_alpha(float4 color)
{
    const float _e3 = unit_share(color.w);
    return float4(color.xyz, _e3);
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

float4 mix_colors_normal(float4 a_4, float4 b_3, float factor_1)
{
    const float4 _e3 = bounded_vec4_(a_4);
    const float4 _e4 = bounded_vec4_(b_3);
    const float _e6 = factor_of(factor_1, true);
    const float4 _e7 = mixed_vec4_(_e3, _e4, _e6);
    return _e7;
}

float4 mix_colors_multiply(float4 a_5, float4 b_4, float factor_2)
{
    const float4 _e6 = color_mixed(a_5, (a_5.xyz * b_4.xyz), factor_2);
    return _e6;
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float kappa_surface(float kappa_1)
{
    const float _e1 = kappa_safe(kappa_1);
    return _e1;
}

float3x3 axes_around(float3 toward, float3 up)
{
    const float3 _e6 = normalize_or(toward, float3(0.0, 0.0, 1.0));
    const float3 _e11 = normalize_or(up, float3(0.0, 1.0, 0.0));
    float3 leaning = cross(_e11, _e6);
    float square_2 = dot(leaning, leaning);
    float3 aside = ((abs(_e6.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across_2 = ((square_2 > 1e-8) ? leaning : cross(aside, _e6));
    const float3 _e38 = normalize_or((across_2 - (dot(across_2, _e6) * _e6)), float3(1.0, 0.0, 0.0));
    return float3x3(_e38, cross(_e6, _e38), _e6);
}

float4 output(float4 color_2)
{
    const float4 _e1 = straight(color_2);
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
    float3 stretch_3 = clamp(float3(dot(_e10, _e10), dot(_e10, _e16), dot(_e16, _e16)), -(most), most);
    const float2 _e41 = bounded_vec2_(turned);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(_e41, stretch_3);
    return stretchedplace;
}

float3 gradient_on_picture(float3 g, float3 normal, float3 view)
{
    float facing = dot(normal, view);
    return (g - (normal * (dot(g, view) / ((facing >= 0.0) ? max(facing, 0.125) : min(facing, -0.125)))));
}

StretchedPlace place_on_surface(float2 place_1, float3 along_1, float3 across_1, float3 normal_1, float3 view_1, float magnification, float angle_1)
{
    const float3 _e11 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    const float3 _e16 = normalize_or(view_1, float3(0.0, 0.0, 1.0));
    const float _e17 = bounded(magnification);
    float height = (1.0 / clamp(_e17, 1e-15, 1000000000000000.0));
    const float3 _e23 = gradient_on_picture(along_1, _e11, _e16);
    const float3 _e25 = bounded_vec3_((_e23 * height));
    const float3 _e26 = gradient_on_picture(across_1, _e11, _e16);
    const float3 _e28 = bounded_vec3_((_e26 * height));
    const float2 _e29 = bounded_vec2_(place_1);
    const StretchedPlace _e30 = mark_place_of(_e29, _e25, _e28, angle_1);
    const StretchedPlace stretchedplace_1 = _e30;
    return stretchedplace_1;
}

StretchedPlace place_across(float3 axis, float3 position, float3x3 world_from_normal, float3 normal_2, float3 view_2, float magnification_1, float angle_2)
{
    const float3x3 _e11 = axes_around(axis, float3(0.0, 1.0, 0.0));
    const float3 _e12 = bounded_vec3_(position);
    float2 place_4 = float2(dot(_e12, _e11[0]), dot(_e12, _e11[2]));
    const float3 _e20 = bounded_vec3_(mul(_e11[0], world_from_normal));
    const float3 _e23 = bounded_vec3_(mul(_e11[2], world_from_normal));
    const StretchedPlace _e24 = place_on_surface(place_4, _e20, _e23, normal_2, view_2, magnification_1, angle_2);
    const StretchedPlace stretchedplace_2 = _e24;
    return stretchedplace_2;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_2, float3 stretch, float2 viewport_1, float count)
{
    const float _e4 = bounded(count);
    float number = clamp(_e4, 0.0, 100000.0);
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (number / max(viewport_1.y, 1.0)) : number);
    const float2 _e19 = bounded_vec2_(place_2);
    const float2 _e21 = bounded_vec2_((_e19 * scale_2));
    float2 p_2 = clamp(_e21, (-4194304.0).xx, (4194304.0).xx);
    const float3 _e27 = bounded_vec3_(stretch);
    float3 s_1 = clamp(_e27, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_2, (is_pixel ? float3(1.0, 0.0, 1.0) : s_1));
    return spacedplace;
}

float area_square(float3 stretch_1)
{
    float sum = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum * sum) / 66.0));
}

float octave_of(float square)
{
    const float _e5 = log_stable(clamp(square, 1e-30, 1e30));
    return clamp((-0.7213475 * _e5), -16.0, 16.0);
}

Brush ConstructBrush(float arg0, float arg1, float arg2, float arg3, uint arg4, bool arg5) {
    Brush ret = (Brush)0;
    ret.aspect = arg0;
    ret.size = arg1;
    ret.scatter = arg2;
    ret.turn = arg3;
    ret.seed = arg4;
    ret.is_dark = arg5;
    return ret;
}

Brush brush_of(float aspect, float size, float scatter, float turn, int seed_2, bool is_dark)
{
    const float _e6 = bounded(aspect);
    const float _e10 = bounded(size);
    const float _e14 = bounded(scatter);
    const float _e18 = bounded(turn);
    const Brush brush = ConstructBrush(clamp(_e6, 1.0, 16.0), clamp(_e10, 0.1, 2.0), clamp(_e14, 0.0, 1.0), clamp(_e18, 0.0, 6.2831855), asuint(seed_2), is_dark);
    return brush;
}

float2 brush_turned(float2 step_, Brushstroke stroke, Brush style)
{
    float2 turned_1 = float2(((stroke.turn.y * step_.x) + (stroke.turn.x * step_.y)), ((stroke.turn.y * step_.y) - (stroke.turn.x * step_.x)));
    return (turned_1 * float2((stroke.way / (style.size * style.aspect)), (-1.0 / style.size)));
}

Brushstroke ConstructBrushstroke(float2 arg0, float2 arg1, float arg2, float arg3) {
    Brushstroke ret = (Brushstroke)0;
    ret.uv = arg0;
    ret.turn = arg1;
    ret.way = arg2;
    ret.share = arg3;
    return ret;
}

Brushstroke brush_stroke(float2 p, int2 cell_3, int zoom, float drawn, Brush style_1)
{
    const uint3 _e7 = lattice_hash(int3(cell_3, zoom), style_1.seed);
    const float3 _e8 = unit_of_hash(_e7);
    float2 offset = (p - ((float2(cell_3) + (0.5).xx) + (style_1.scatter * (_e8.xy - (0.5).xx))));
    const float2 _e26 = sin_cos_of((style_1.turn * (_e8.z - 0.5)));
    const uint3 _e31 = lattice_hash(int3(cell_3, zoom), (style_1.seed + 1u));
    const float3 _e32 = unit_of_hash(_e31);
    float way = ((_e32.x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_1 = ConstructBrushstroke((0.5).xx, _e26, way, 0.0);
    const float2 _e47 = brush_turned((offset * float2(style_1.aspect, 1.0)), stroke_1, style_1);
    float2 uv_1 = ((0.5).xx + _e47);
    float2 from_edge = min(uv_1, ((1.0).xx - uv_1));
    float inside = clamp((64.0 * min(from_edge.x, from_edge.y)), 0.0, 1.0);
    float far = (max(abs(offset.x), abs(offset.y)) / (1.0 - (0.5 * style_1.scatter)));
    const float _e77 = eased(far, 0.85, 1.0);
    float share_1 = ((drawn * inside) * (1.0 - _e77));
    const Brushstroke brushstroke = ConstructBrushstroke(uv_1, _e26, way, share_1);
    return brushstroke;
}

float3 bristle(float row, uint seed_3)
{
    float first = floor(row);
    float t_4 = (row - first);
    const uint3 _e8 = lattice_hash(int3(naga_f2i32(first), int(0), int(0)), seed_3);
    const float3 _e9 = unit_of_hash(_e8);
    const uint3 _e16 = lattice_hash(int3(asint(asuint(naga_f2i32(first)) + asuint(int(1))), int(0), int(0)), seed_3);
    const float3 _e17 = unit_of_hash(_e16);
    return lerp(_e9, _e17, ((t_4 * t_4) * (3.0 - (2.0 * t_4))));
}

float2 bristles(float2 uv, float width, uint seed_4)
{
    float across_3 = ((2.0 * uv.y) - 1.0);
    const uint3 _e12 = lattice_hash(int3(int(0), int(1), int(0)), seed_4);
    const float3 _e13 = unit_of_hash(_e12);
    float seen = clamp((1.75 - (11.0 * width)), 0.0, 1.0);
    const float3 _e26 = bristle((11.0 * uv.y), seed_4);
    float3 chance = lerp((0.5).xxx, _e26, seen);
    float start = ((0.03 + (0.12 * chance.x)) + ((0.09 * across_3) * across_3));
    float end = ((0.97 - ((0.1 + (0.25 * _e13.y)) * chance.y)) - ((0.12 * across_3) * across_3));
    const float _e53 = eased(uv.x, start, (start + 0.05));
    const float _e57 = eased(uv.x, (end - 0.1), end);
    float along_2 = (_e53 * (1.0 - _e57));
    const float _e64 = eased(abs(across_3), 0.78, 0.95);
    float side = (1.0 - _e64);
    const float _e74 = eased((uv.x + (0.55 * chance.z)), 0.85, 1.25);
    float shade_1 = (((0.8 + (0.16 * _e13.z)) + (0.208 * (chance.z - 0.5))) - (0.05 * uv.x));
    return float2(clamp(shade_1, 0.0, 1.0), ((along_2 * side) * (1.0 - (0.9 * _e74))));
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float2 bristles_laid(SpacedPlace at, float ink, Brush style_2)
{
    uint tile[256] = BLUE_TILE;
    float2 paint = (0.0).xx;
    int octave = int(0);
    int i = (int)0;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    const float _e8 = area_square(at.stretch);
    const float _e10 = octave_of(sqrt(_e8));
    float zoom_1 = floor(_e10);
    float f_1 = (_e10 - zoom_1);
    const float _e15 = exp2_stable((-2.0 * f_1));
    float fine = ((1.0 - ((1.0 - f_1) * _e15)) / (4.0 * _e15));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e156 = octave;
            octave = asint(asuint(_e156) + asuint(int(1)));
        }
        loop_init = false;
        int _e31 = octave;
        if ((_e31 < int(2))) {
        } else {
            break;
        }
        {
            int _e36 = octave;
            float amount = (ink * ((_e36 == int(1)) ? fine : (1.0 - f_1)));
            int _e42 = octave;
            const float _e44 = power_of_two(asint(asuint(naga_f2i32(zoom_1)) + asuint(_e42)));
            float2 p_3 = (clamp((at.place * _e44), (-4194304.0).xx, (4194304.0).xx) / float2(style_2.aspect, 1.0));
            int2 corner = naga_f2i32(floor(p_3));
            int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
            i = int(0);
            uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
            bool loop_init_1 = true;
            while(true) {
                if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
                loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
                if (!loop_init_1) {
                    int _e153 = i;
                    i = asint(asuint(_e153) + asuint(int(1)));
                }
                loop_init_1 = false;
                int _e69 = i;
                if ((_e69 < int(9))) {
                } else {
                    break;
                }
                {
                    int _e72 = i;
                    int _e75 = i;
                    int2 cell_4 = asint(asuint(asint(asuint(corner) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e72, int(3)), naga_div(_e75, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
                    int _e95 = octave;
                    int2 turning = asint(asuint(cell_4) + asuint(int2(int((style_2.seed & 31u)), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_1)) + asuint(_e95)))))));
                    const uint _e101 = blue_index(turning);
                    uint _e103 = tile[min(uint(_e101), 255u)];
                    const float _e104 = blue_part(_e103, turning);
                    float late = (0.96875 * _e104);
                    float share_2 = clamp(((amount - late) * 32.0), 0.0, 1.0);
                    if ((share_2 <= 0.0)) {
                        continue;
                    }
                    int _e116 = octave;
                    const Brushstroke _e118 = brush_stroke(p_3, cell_4, asint(asuint(naga_f2i32(zoom_1)) + asuint(_e116)), share_2, style_2);
                    if ((_e118.share > 0.0)) {
                        const float2 _e123 = brush_turned((dx * _e44), _e118, style_2);
                        const float2 _e125 = brush_turned((dy * _e44), _e118, style_2);
                        int _e127 = octave;
                        const uint3 _e133 = lattice_hash(int3(cell_4, asint(asuint(naga_f2i32(zoom_1)) + asuint(_e127))), (style_2.seed + 2u));
                        uint own = _e133.x;
                        const float2 _e140 = bristles(_e118.uv, length(float2(_e123.y, _e125.y)), own);
                        float cover = (_e118.share * _e140.y);
                        float2 _e147 = paint;
                        paint = (float2((_e140.x * cover), cover) + (_e147 * (1.0 - cover)));
                    }
                }
            }
        }
    }
    float2 _e158 = paint;
    return _e158;
}

BrushStrokes ConstructBrushStrokes(float4 arg0, float arg1) {
    BrushStrokes ret = (BrushStrokes)0;
    ret.color = arg0;
    ret.ink = arg1;
    return ret;
}

BrushStrokes brush_strokes_bristles(float value, float2 place_3, float3 stretch_2, float count_1, float aspect_1, float size_1, float scatter_1, float turn_1, int seed_5, float2 viewport_2)
{
    const SpacedPlace _e10 = spaced(place_3, stretch_2, viewport_2, count_1);
    const Brush _e12 = brush_of(aspect_1, size_1, scatter_1, turn_1, seed_5, false);
    const float _e14 = factor_of(value, true);
    const float2 _e17 = bristles_laid(_e10, (1.0 - _e14), _e12);
    float shade_2 = (_e17.x / max(_e17.y, 0.001));
    const BrushStrokes brushstrokes = ConstructBrushStrokes(float4(shade_2, shade_2, shade_2, 1.0), _e17.y);
    return brushstrokes;
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_axis(float3 axis_1, float3 normal_3, float angle_3, float3 view_3, float3 position_object, float3x3 world_from_normal_1, float magnification_2)
{
    const StretchedPlace _e7 = place_across(axis_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_3);
    const MarkPlace markplace = ConstructMarkPlace(_e7.place, _e7.stretch);
    return markplace;
}

MarkPlace mark_place_object(float angle_4, float3 anchor, float2 pixel_1, float2 viewport_3)
{
    const float _e5 = bounded(anchor.z);
    float size_2 = clamp(_e5, 1e-6, 1000000.0);
    const float2 _e9 = place_in_picture(pixel_1, viewport_3);
    const float2 _e15 = bounded_vec2_((_e9 - float2(anchor.x, -(anchor.y))));
    float2 place_5 = (_e15 / (size_2).xx);
    const StretchedPlace _e28 = mark_place_of(place_5, float3((1.0 / size_2), 0.0, 0.0), float3(0.0, (1.0 / size_2), 0.0), angle_4);
    const MarkPlace markplace_1 = ConstructMarkPlace(_e28.place, _e28.stretch);
    return markplace_1;
}

float reflectance_lambert(Light light, float3 normal_4)
{
    const float3 _e6 = normalize_or(normal_4, float3(0.0, 0.0, 1.0));
    return max(dot(_e6, light.direction), 0.0);
}

float reflectance_half_lambert(Light light_1, float3 normal_5)
{
    const float3 _e6 = normalize_or(normal_5, float3(0.0, 0.0, 1.0));
    float half_ = (0.5 + (0.5 * dot(_e6, light_1.direction)));
    return clamp((half_ * half_), 0.0, 1.0);
}

float map_range(float value_1, float from_low_1, float from_high_1, float to_low_1, float to_high_1, bool clamped_2)
{
    const float _e6 = remapped(value_1, from_low_1, from_high_1, to_low_1, to_high_1, clamped_2);
    return _e6;
}

float3 smooth_normal_fine(float3 normal_6, float3 smooth_1_)
{
    const float3 _e2 = normalize_or(smooth_1_, normal_6);
    return _e2;
}

float3 smooth_normal_medium(float3 normal_7, float3 smooth_3_)
{
    const float3 _e2 = normalize_or(smooth_3_, normal_7);
    return _e2;
}

float4 shade(Surface surface_1)
{
    const float3 _e3 = smooth_normal_fine(surface_1.normal, surface_1.smooth_normal_1_);
    Light _e6 = look.key;
    const float _e7 = reflectance_half_lambert(_e6, _e3);
    const float _e13 = map_range(_e7, 0.02, 0.2, 1.0, 0.0, true);
    const float3 _e16 = smooth_normal_medium(surface_1.normal, surface_1.smooth_normal_3_);
    const MarkPlace _e26 = mark_place_axis(float3(0.35, 1.0, 0.25), _e16, 0.0, surface_1.view, surface_1.position_object, surface_1.world_from_normal, surface_1.magnification);
    float2 _e37 = look.viewport;
    const BrushStrokes _e38 = brush_strokes_bristles(_e13, _e26.place, _e26.stretch, 14.0, 3.4, 1.8, 0.6, 0.5, int(1), _e37);
    float4 _e42 = look.umber_as_paint_b;
    const float4 _e44 = mix_colors_multiply(_e38.color, _e42, 1.0);
    float4 _e47 = look.toned_canvas;
    const float4 _e49 = mix_colors_normal(_e47, _e44, _e38.ink);
    Light _e52 = look.sky;
    const float _e53 = reflectance_lambert(_e52, _e3);
    const float _e59 = map_range(_e53, 0.25, 0.75, 1.0, 0.0, true);
    float2 _e70 = look.viewport;
    const BrushStrokes _e71 = brush_strokes_bristles(_e59, _e26.place, _e26.stretch, 18.0, 3.2, 1.5, 0.6, 0.5, int(6), _e70);
    float4 _e75 = look.cool_reflections_as_paint_b;
    const float4 _e77 = mix_colors_multiply(_e71.color, _e75, 1.0);
    const float4 _e79 = mix_colors_normal(_e49, _e77, _e71.ink);
    const float _e85 = map_range(_e7, 0.24, 0.42, 1.0, 0.0, true);
    float2 _e96 = look.viewport;
    const BrushStrokes _e97 = brush_strokes_bristles(_e85, _e26.place, _e26.stretch, 18.0, 3.2, 1.6, 0.6, 0.5, int(2), _e96);
    float4 _e101 = look.half_tones_as_paint_b;
    const float4 _e103 = mix_colors_multiply(_e97.color, _e101, 1.0);
    const float4 _e105 = mix_colors_normal(_e79, _e103, _e97.ink);
    const float _e111 = map_range(_e7, 0.46, 0.66, 1.0, 0.0, true);
    float2 _e117 = look.viewport;
    const MarkPlace _e118 = mark_place_object(0.75, surface_1.anchor, surface_1.pixel, _e117);
    float2 _e129 = look.viewport;
    const BrushStrokes _e130 = brush_strokes_bristles(_e111, _e118.place, _e118.stretch, 24.0, 3.0, 1.5, 0.6, 0.5, int(3), _e129);
    float4 _e134 = look.light_as_paint_b;
    const float4 _e136 = mix_colors_multiply(_e130.color, _e134, 1.0);
    const float4 _e138 = mix_colors_normal(_e105, _e136, _e130.ink);
    const float _e144 = map_range(_e7, 0.76, 0.95, 1.0, 0.0, true);
    float2 _e155 = look.viewport;
    const BrushStrokes _e156 = brush_strokes_bristles(_e144, _e118.place, _e118.stretch, 32.0, 2.6, 1.3, 0.6, 0.4, int(4), _e155);
    float4 _e160 = look.thick_lights_as_paint_b;
    const float4 _e162 = mix_colors_multiply(_e156.color, _e160, 1.0);
    const float4 _e164 = mix_colors_normal(_e138, _e162, _e156.ink);
    const float _e166 = kappa_surface(surface_1.kappa);
    const float _e172 = map_range(_e166, -6.0, -20.0, 1.0, 0.0, true);
    float2 _e183 = look.viewport;
    const BrushStrokes _e184 = brush_strokes_bristles(_e172, _e26.place, _e26.stretch, 44.0, 3.4, 1.5, 0.6, 0.4, int(8), _e183);
    float4 _e188 = look.accents_as_paint_b;
    const float4 _e190 = mix_colors_multiply(_e184.color, _e188, 1.0);
    const float4 _e192 = mix_colors_normal(_e164, _e190, _e184.ink);
    const float4 _e193 = with_unit_alpha(_e192);
    const float4 _e194 = premultiplied(_e193);
    const float4 _e195 = output(_e194);
    return _e195;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_4.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_2, fragmentinput_fs_main.normal_9 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    Surface surface = (Surface)0;

    const float3 _e7 = normalize_or(in_.normal, float3(0.0, 0.0, 1.0));
    float3 normal_10 = (is_front ? _e7 : -(_e7));
    surface.normal = normal_10;
    float4 _e15 = view_4.eye;
    float _e20 = view_4.eye.w;
    float4 _e26 = view_4.eye;
    const float3 _e32 = normalize_or(_e26.xyz, float3(0.0, 0.0, 1.0));
    const float3 _e33 = normalize_or((_e15.xyz - (_e20 * in_.position)), _e32);
    surface.view = _e33;
    surface.position_object = in_.position_object;
    float4 _e42 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.kappa = _e42.x;
    float4 _e50 = smooth_normal_1_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e56 = view_4.camera_from_world;
    surface.smooth_normal_1_ = mul(_e56, float4(_e50.xyz, 0.0)).xyz;
    float4 _e65 = smooth_normal_3_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e71 = view_4.camera_from_world;
    surface.smooth_normal_3_ = mul(_e71, float4(_e65.xyz, 0.0)).xyz;
    float4 _e79 = view_4.screen;
    float4 _e84 = view_4.screen;
    surface.pixel = ((in_.clip_.xy * _e79.xy) + _e84.zw);
    float4x4 _e90 = view_4.camera_from_world;
    float4 _e94 = object.world_from_object[3];
    float _e103 = view_4.eye.w;
    float _e108 = view_4.clip_from_world[0].y;
    float _e113 = view_4.clip_from_world[1].y;
    float _e118 = view_4.clip_from_world[2].y;
    const float3 _e121 = anchor_on_screen(mul(float4(_e94.xyz, 1.0), _e90).xyz, _e103, length(float3(_e108, _e113, _e118)));
    surface.anchor = _e121;
    float4x4 _e125 = view_4.camera_from_world;
    float _e135 = view_4.eye.w;
    float _e140 = view_4.clip_from_world[0].y;
    float _e145 = view_4.clip_from_world[1].y;
    float _e150 = view_4.clip_from_world[2].y;
    const float _e153 = size_on_screen(-(mul(float4(in_.position, 1.0), _e125).z), _e135, length(float3(_e140, _e145, _e150)));
    surface.magnification = _e153;
    float3x3 _e157 = object.world_from_normal;
    surface.world_from_normal = _e157;
    Surface _e158 = surface;
    const float4 _e159 = shade(_e158);
    const float4 _e160 = finite_vec4_(_e159);
    return _e160;
}
