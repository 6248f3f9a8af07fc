// One bit: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view_2 b0, object b1, look b2, curvature_tensor_map t0.
// one-bit.json says what to put there and how to draw.
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
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light back;
    Light key;
};

struct Surface {
    float3 normal;
    int _pad1_0;
    float3 view;
    int _pad2_0;
    float3 position_camera;
    int _pad3_0;
    float3 curvature_tensor;
    int _pad4_0;
    float2 pixel;
    int _end_pad_0;
    int _end_pad_1;
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

ProfileShape ConstructProfileShape(float arg0, float arg1, float arg2, float arg3, float arg4, float arg5, float arg6, uint arg7) {
    ProfileShape ret = (ProfileShape)0;
    ret.half_cos_offset = arg0;
    ret.half_sin_offset = arg1;
    ret.scale = arg2;
    ret.exponent = arg3;
    ret.offset = arg4;
    ret.edge_mean = arg5;
    ret.edge_deviation = arg6;
    ret.kind = arg7;
    return ret;
}

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LN_2_ = 0.6931472;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint PROFILE_STEP = 1u;
static const uint PROFILE_AMBIENT = 2u;
static const uint BLUE_TILE[256] = Constructarray256_uint_(667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);
static const ProfileShape tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.229384, 1.5428282, 0.1, 1.0145569, 0.43140125, 0u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput_vs_main {
    float3 position : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_1 : LOC0;
    float3 normal_4 : LOC1;
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
    float square = dot(scaled, scaled);
    const bool _e23 = is_finite(square);
    if (!(_e23)) {
        return otherwise_1;
    }
    return (scaled * (1.0 / sqrt(square)));
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
    int shift_2 = int(((bits - 1060439283u) >> 23u));
    int exponent_1 = ((shift_2 >= int(256)) ? asint(asuint(shift_2) - asuint(int(512))) : shift_2);
    float mantissa = asfloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    float series = ((2.0 * z) * (1.0 + (z2_ * (0.33333334 + (z2_ * (0.2 + (z2_ * (0.14285715 + (z2_ * 0.11111111)))))))));
    return ((float(exponent_1) * LN_2_) + series);
}

float log1p_negative_small(float y)
{
    float z_1 = (y / (2.0 - y));
    float z2_1 = (z_1 * z_1);
    return ((-2.0 * z_1) * (1.0 + (z2_1 * (0.33333334 + (z2_1 * (0.2 + (z2_1 * (0.14285715 + (z2_1 * 0.11111111)))))))));
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

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_between(float3 d, float3 l)
{
    float p_1 = length((d - l));
    float s_1 = length((d + l));
    float k = (1.0 / sqrt(max(((p_1 * p_1) + (s_1 * s_1)), 1e-30)));
    const Angle angle_1 = ConstructAngle((p_1 * k), (s_1 * k));
    return angle_1;
}

float atan2_positive(float y_1, float x_5)
{
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

float angle_radians(Angle u)
{
    const float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

Angle angle_turned(Angle u_1, float2 t)
{
    bool local_1 = (bool)0;

    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    float2 upper = ((c_1 <= 0.0) ? float2(1.0, 0.0) : float2(s_2, c_1));
    if ((s_2 <= 0.0)) {
        local_1 = (s_2 < c_1);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    float2 turned = (_e32 ? float2(0.0, 1.0) : upper);
    const Angle angle_2 = ConstructAngle(turned.x, turned.y);
    return angle_2;
}

Angle angle_shifted(Angle u_2, float shift)
{
    const float2 _e7 = sin_cos_quarter((0.5 * clamp(shift, -3.1415927, PI)));
    const Angle _e8 = angle_turned(u_2, _e7);
    const Angle angle_3 = _e8;
    return angle_3;
}

float angle_footprint(Angle u_3)
{
    float2 half_ = float2(u_3.half_sin, u_3.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_3 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    const float _e13 = finite_or(w_3, 0.5);
    return min(_e13, 0.5);
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

float mixed(float a, float b, float t_1)
{
    const float _e4 = bounded((b - a));
    const float _e14 = bounded(((t_1 < 0.5) ? (a + (t_1 * _e4)) : (b - ((1.0 - t_1) * _e4))));
    return _e14;
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

float eased(float x_8, float low_1, float high_1)
{
    const float _e3 = bounded(x_8);
    const float _e4 = bounded(low_1);
    const float _e5 = bounded(high_1);
    const float _e6 = place_between(_e3, _e4, _e5);
    float t_3 = clamp(_e6, 0.0, 1.0);
    return ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
}

float factor_of(float x_9, bool clamped)
{
    const float _e2 = bounded(x_9);
    const float _e3 = bounded(x_9);
    return (clamped ? clamp(_e3, 0.0, 1.0) : _e2);
}

float footprint_of(float x_10)
{
    float _e1 = ddx(x_10);
    float _e2 = ddy(x_10);
    float2 d_1 = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float edge_width(float w, float softness)
{
    const float _e4 = bounded(softness);
    return length(float2(min(w, 1000000000000000.0), clamp(_e4, 0.0, 1000000000000000.0)));
}

float step_filtered(float x_11, float edge, float w_1)
{
    const float _e4 = bounded((x_11 - edge));
    if ((w_1 < 1e-30)) {
        return ((_e4 >= 0.0) ? 1.0 : 0.0);
    }
    const float _e13 = bounded((_e4 / w_1));
    return clamp((0.5 + _e13), 0.0, 1.0);
}

float4 straight(float4 composite)
{
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return float4((composite.xyz / (composite.w).xxx), composite.w);
}

float kappa_safe(float kappa)
{
    bool is_nan = ((asuint(kappa) & 2147483647u) > 2139095040u);
    return (is_nan ? 0.0 : clamp(kappa, -10000.0, 10000.0));
}

float3 tensor_safe(float3 tensor)
{
    const float _e2 = kappa_safe(tensor.x);
    const float _e4 = kappa_safe(tensor.y);
    const float _e6 = kappa_safe(tensor.z);
    return float3(_e2, _e4, _e6);
}

float combine_tones_union(float a_1, float b_1)
{
    const float _e3 = factor_of(a_1, true);
    const float _e5 = factor_of(b_1, true);
    return max(_e3, _e5);
}

float combine_tones_difference(float a_2, float b_2)
{
    const float _e3 = factor_of(a_2, true);
    const float _e5 = factor_of(b_2, true);
    return min(_e3, (1.0 - _e5));
}

float4 blend_finish(float4 below, float3 blended, float alpha, float opacity, bool clamped_1)
{
    if ((opacity <= 0.0)) {
        return below;
    }
    float4 mixed_1 = float4((below.xyz + (opacity * (blended - below.xyz))), alpha);
    return (clamped_1 ? clamp(mixed_1, (0.0).xxxx, (1.0).xxxx) : mixed_1);
}

float4 blend_alpha(float4 below_1, float4 color, float tone, float opacity_1, bool clamped_2)
{
    float a_4 = (opacity_1 * color.w);
    float alpha_1 = (below_1.w + ((tone * a_4) * (1.0 - below_1.w)));
    const float4 _e20 = blend_finish(below_1, (below_1.xyz + (tone * (color.xyz - below_1.xyz))), alpha_1, a_4, clamped_2);
    return _e20;
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

Angle parametrization_diffuse(Light light, float3 normal)
{
    const float3 _e6 = normalize_or(normal, float3(0.0, 0.0, 1.0));
    const Angle _e8 = angle_between(_e6, light.direction);
    const Angle angle_4 = _e8;
    return angle_4;
}

float profile_power(float q, float exponent)
{
    float log_base = 0.0;

    if ((q >= 1.0)) {
        return 0.0;
    }
    if ((q < 0.5)) {
        const float _e10 = log1p_negative_small((q * q));
        log_base = _e10;
    } else {
        const float _e16 = log_stable(((1.0 - q) * (1.0 + q)));
        log_base = _e16;
    }
    float _e19 = log_base;
    const float _e21 = exp2_stable(((exponent * LOG2_E) * _e19));
    return clamp(_e21, 0.0, 1.0);
}

float profile_point(Angle u_4, ProfileShape shape)
{
    bool local_2 = (bool)0;

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
    const float _e31 = profile_power(q_1, shape.exponent);
    return _e31;
}

float profile_filtered(Angle u_5, float w_2, ProfileShape shape_1)
{
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    const float _e3 = profile_point(u_5, shape_1);
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
        const float _e36 = angle_radians(u_5);
        return clamp((0.5 + (((shape_1.offset + shape_1.edge_mean) - _e36) / width_3)), 0.0, 1.0);
    }
    if ((w_2 < (0.1 * shape_1.edge_deviation))) {
        return _e3;
    }
    const float2 _e50 = sin_cos_quarter((0.19364917 * w_2));
    const Angle _e51 = angle_turned(u_5, _e50);
    const float _e52 = profile_point(_e51, shape_1);
    const Angle _e57 = angle_turned(u_5, float2(-(_e50.x), _e50.y));
    const float _e58 = profile_point(_e57, shape_1);
    return ((((5.0 * _e52) + (8.0 * _e3)) + (5.0 * _e58)) / 18.0);
}

float profile(Angle angle, float shift_1, ProfileShape shape_2)
{
    const Angle _e3 = angle_shifted(angle, shift_1);
    const float _e4 = angle_footprint(_e3);
    const float _e5 = profile_filtered(_e3, _e4, shape_2);
    return _e5;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

int2 dither_cell(float2 place, float size)
{
    const float _e2 = bounded(size);
    float least = max(_e2, 0.001);
    const float2 _e5 = bounded_vec2_(place);
    return naga_f2i32(floor(clamp((_e5 / (least).xx), (-4194304.0).xx, (4194304.0).xx)));
}

float dithered(float tone_1, int levels, float spread, float threshold)
{
    float steps = float(asint(asuint(clamp(levels, int(2), int(256))) - asuint(int(1))));
    const float _e10 = bounded(tone_1);
    float x_13 = (clamp(_e10, 0.0, 1.0) * steps);
    float low_2 = min(floor(x_13), (steps - 1.0));
    const float _e19 = bounded(spread);
    float soft = clamp(_e19, 0.0, 1.0);
    bool is_upper = (((x_13 - low_2) - 0.5) >= ((threshold - 0.5) * soft));
    return ((low_2 + (is_upper ? 1.0 : 0.0)) / steps);
}

uint blue_index(int2 cell)
{
    uint2 at = (asuint(cell) & (31u).xx);
    return ((8u * at.y) + (at.x >> 2u));
}

float blue_part(uint four, int2 cell_1)
{
    return ((float(((four >> (8u * (asuint(cell_1.x) & 3u))) & 255u)) + 0.5) * 0.00390625);
}

float blue_threshold(int2 cell_2)
{
    const uint _e2 = blue_index(cell_2);
    const float _e4 = blue_part(BLUE_TILE[min(uint(_e2), 255u)], cell_2);
    return _e4;
}

float rim(Light light_1, float3 normal_1, float3 view, float width, float softness_1, float follow)
{
    const float3 _e10 = normalize_or(normal_1, float3(0.0, 0.0, 1.0));
    float facing_1 = clamp(dot(_e10, view), 0.0, 1.0);
    const float _e16 = factor_of(width, true);
    const float _e18 = factor_of(softness_1, true);
    const float _e20 = footprint_of(facing_1);
    float edge_1 = max((_e16 * _e18), min(_e20, 1.0));
    float3 aside = (_e10 - view);
    float further = ((facing_1 > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - _e16)) : (_e16 - facing_1));
    float within = ((further / max(edge_1, 1e-6)) + ((softness_1 > 0.0) ? 0.0 : 0.5));
    float inside = ((_e16 <= 0.0) ? 0.0 : clamp(within, 0.0, 1.0));
    float3 across = (light_1.direction - (dot(light_1.direction, view) * view));
    const float3 _e61 = normalize_or(across, (0.0).xxx);
    float side = dot((_e10 - (dot(_e10, view) * view)), _e61);
    const float _e66 = eased(side, 0.0, 0.5);
    const float _e68 = factor_of(follow, true);
    const float _e69 = mixed(1.0, _e66, _e68);
    return (inside * _e69);
}

float dither_blue(float value, float2 place_1, int levels_1, float spread_1, float size_1)
{
    const int2 _e5 = dither_cell(place_1, size_1);
    const float _e6 = blue_threshold(_e5);
    const float _e7 = dithered(value, levels_1, spread_1, _e6);
    return _e7;
}

float line_covers(float distance_, float width_1)
{
    return clamp(((width_1 + 0.5) - distance_), 0.0, min(width_1, 1.0));
}

float seen_well(float facing)
{
    const float _e3 = eased(facing, 0.05, 0.3);
    return _e3;
}

float faded_in(float x_12, float limit, float softness_2)
{
    const float _e3 = bounded(limit);
    float at_1 = max(_e3, 0.0);
    const float _e6 = footprint_of(x_12);
    const float _e10 = factor_of(softness_2, true);
    const float _e12 = edge_width(_e6, (min(at_1, 1000000000.0) * _e10));
    const float _e13 = bounded(x_12);
    const float _e14 = step_filtered(_e13, at_1, _e12);
    return _e14;
}

float inner_contour_suggestive(float width_2, float limit_1, float softness_3, float3 tensor_1, float3 normal_2, float3 view_1, float3x3 camera_from_world, float3 place_2, float2 viewport)
{
    float3 n_1 = mul(normal_2, camera_from_world);
    const float3 _e10 = tensor_safe(tensor_1);
    float square_1 = dot(n_1.xy, n_1.xy);
    float radial = (((((_e10.x * n_1.x) * n_1.x) + (((2.0 * _e10.y) * n_1.x) * n_1.y)) + ((_e10.z * n_1.y) * n_1.y)) / max(square_1, 1e-6));
    float _e36 = ddx(radial);
    float _e37 = ddy(radial);
    float2 change = float2(_e36, _e37);
    float3 v_4 = mul(view_1, camera_from_world);
    float3 row = ddy(place_2);
    float up = (((row - (dot(row, v_4) * v_4)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n_1.x) + ((up * change.y) * n_1.y))) * rsqrt(max(square_1, 1e-6)));
    const float _e67 = bounded(width_2);
    float pixels = (((0.5 * clamp(_e67, 0.0, 10000.0)) * height) / 1000.0);
    float distance_1 = (abs(radial) / max(length(change), 1e-6));
    const float _e84 = faded_in(((toward_eye * height) * 0.05), limit_1, softness_3);
    const float _e85 = line_covers(distance_1, pixels);
    const float _e88 = seen_well(dot(normal_2, view_1));
    return ((_e85 * _e84) * _e88);
}

float4 shade(Surface surface_1)
{
    Light _e3 = look.key;
    const Angle _e5 = parametrization_diffuse(_e3, surface_1.normal);
    const float _e8 = profile(_e5, 0.0, tone_shape);
    const float _e13 = dither_blue(_e8, surface_1.pixel, int(2), 1.0, 2.0);
    Light _e16 = look.back;
    const float _e22 = rim(_e16, surface_1.normal, surface_1.view, 0.34, 0.0, 1.0);
    const float _e23 = combine_tones_union(_e13, _e22);
    float3x3 _e32 = look.camera_from_world;
    float2 _e36 = look.viewport;
    const float _e37 = inner_contour_suggestive(3.0, 20.0, 0.1, surface_1.curvature_tensor, surface_1.normal, surface_1.view, _e32, surface_1.position_camera, _e36);
    const float _e38 = combine_tones_difference(_e23, _e37);
    const float4 _e51 = blend_alpha(float4(0.1333, 0.1216, 0.2, 1.0), float4(0.9373, 0.902, 0.8118, 1.0), _e38, 1.0, true);
    const float4 _e52 = output(_e51);
    return _e52;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    Varyings out_ = (Varyings)0;

    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e12 = view_2.clip_from_world;
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
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_4 };
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
    float4x4 _e37 = view_2.camera_from_world;
    surface.position_camera = mul(float4(in_.position, 1.0), _e37).xyz;
    float4 _e49 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    surface.curvature_tensor = _e49.xyz;
    float4 _e56 = view_2.screen;
    float4 _e61 = view_2.screen;
    surface.pixel = ((in_.clip_.xy * _e56.xy) + _e61.zw);
    Surface _e64 = surface;
    const float4 _e65 = shade(_e64);
    const float4 _e66 = finite_vec4_(_e65);
    return _e66;
}
