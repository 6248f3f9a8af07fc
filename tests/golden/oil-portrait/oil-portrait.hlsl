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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const float MOST_ON_SCREEN = 1000000000000000.0;
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
    float3 normal_5 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput_fs_main {
    float3 position_2 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_6 : LOC2;
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

float2 sin_cos_eighth(float x_2)
{
    float s = (x_2 * 0.9088517);
    return float2(s, 0.73168886);
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

float bounded(float x_3)
{
    uint bits_1 = asuint(x_3);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = asfloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_3 : ((magnitude == 2139095040u) ? largest : 0.0));
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

float4 mixed_vec4_(float4 a, float4 b, float t)
{
    const float4 _e4 = bounded_vec4_((b - a));
    const float4 _e14 = bounded_vec4_(((t < 0.5) ? (a + (t * _e4)) : (b - ((1.0 - t) * _e4))));
    return _e14;
}

float place_between(float x_4, float low, float high)
{
    float span = (high - low);
    if ((abs(span) < SMALLEST_NORMAL)) {
        return ((x_4 >= high) ? 1.0 : 0.0);
    }
    const float _e13 = bounded(((x_4 - low) / span));
    return _e13;
}

float eased(float x_5, float low_1, float high_1)
{
    const float _e3 = place_between(x_5, low_1, high_1);
    float t_1 = clamp(_e3, 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float4 color_mixed(float4 a_1, float3 blended, float factor)
{
    const float3 _e3 = bounded_vec3_(blended);
    const float3 _e6 = bounded_vec3_((_e3 - a_1.xyz));
    const float3 _e10 = bounded_vec3_((_e3 - (0.0 * _e6)));
    return float4(_e10, 1.0);
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

float4 mix_colors_normal(float4 a_2, float4 b_1, float factor_1)
{
    const float4 _e3 = bounded_vec4_(a_2);
    const float4 _e4 = bounded_vec4_(b_1);
    const float4 _e8 = mixed_vec4_(_e3, _e4, clamp(factor_1, 0.0, 1.0));
    return _e8;
}

float3x3 axes_around(float3 toward, float3 up)
{
    float3 z_1 = (toward * rsqrt(dot(toward, toward)));
    float3 leaning = cross(up, z_1);
    float square_1 = dot(leaning, leaning);
    float3 aside = ((abs(z_1.x) > 0.7) ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    float3 across_3 = ((square_1 > 1e-8) ? leaning : cross(aside, z_1));
    const float3 _e31 = normalize_moderate((across_3 - (dot(across_3, z_1) * z_1)), float3(1.0, 0.0, 0.0));
    return float3x3(_e31, cross(z_1, _e31), z_1);
}

float4 output(float4 color_1)
{
    const float4 _e1 = straight(color_1);
    const float4 _e2 = finite_vec4_(_e1);
    return _e2;
}

uint3 hash_pcg3d(uint3 seed)
{
    uint3 v_5 = (uint3)0;

    v_5 = ((seed * 1664525u) + (1013904223u).xxx);
    uint _e8 = v_5.x;
    uint _e10 = v_5.y;
    uint _e12 = v_5.z;
    v_5.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_5.y;
    uint _e18 = v_5.z;
    uint _e20 = v_5.x;
    v_5.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_5.z;
    uint _e26 = v_5.x;
    uint _e28 = v_5.y;
    v_5.z = (_e24 + (_e26 * _e28));
    uint3 _e31 = v_5;
    uint3 _e32 = v_5;
    v_5 = (_e31 ^ (_e32 >> (16u).xxx));
    uint _e38 = v_5.x;
    uint _e40 = v_5.y;
    uint _e42 = v_5.z;
    v_5.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_5.y;
    uint _e48 = v_5.z;
    uint _e50 = v_5.x;
    v_5.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_5.z;
    uint _e56 = v_5.x;
    uint _e58 = v_5.y;
    v_5.z = (_e54 + (_e56 * _e58));
    uint3 _e61 = v_5;
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

uint blue_index(int2 cell_1)
{
    uint2 at_6 = (asuint(cell_1) & (31u).xx);
    return ((8u * at_6.y) + (at_6.x >> 2u));
}

StretchedPlace ConstructStretchedPlace(float2 arg0, float3 arg1) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    float2 turn_6 = float2(0.0, 1.0);
    const float3 _e12 = bounded_vec3_(((turn_6.y * along) + (turn_6.x * across)));
    const float3 _e18 = bounded_vec3_(((turn_6.y * across) - (turn_6.x * along)));
    float2 turned = float2(((turn_6.y * place.x) + (turn_6.x * place.y)), ((turn_6.y * place.y) - (turn_6.x * place.x)));
    float3 most = (1000000000000000.0).xxx;
    float3 stretch_9 = clamp(float3(dot(_e12, _e12), dot(_e12, _e18), dot(_e18, _e18)), -(most), most);
    const StretchedPlace stretchedplace = ConstructStretchedPlace(turned, stretch_9);
    return stretchedplace;
}

StretchedPlace mark_place_of_2_(float2 place_1, float3 along_1, float3 across_1, float angle_1)
{
    const float2 _e5 = sin_cos_eighth(0.75);
    float2 turn_7 = clamp(_e5, (-1.0).xx, (1.0).xx);
    float3 x_6 = ((turn_7.y * along_1) + (turn_7.x * across_1));
    float3 y = ((turn_7.y * across_1) - (turn_7.x * along_1));
    float2 turned_1 = float2(((turn_7.y * place_1.x) + (turn_7.x * place_1.y)), ((turn_7.y * place_1.y) - (turn_7.x * place_1.x)));
    float3 stretch_10 = float3(dot(x_6, x_6), dot(x_6, y), dot(y, y));
    const StretchedPlace stretchedplace_1 = ConstructStretchedPlace(turned_1, stretch_10);
    return stretchedplace_1;
}

float3 gradient_on_picture(float3 g, float3 normal, float3 view)
{
    float facing = dot(normal, view);
    return (g - (normal * (dot(g, view) / ((facing >= 0.0) ? max(facing, 0.125) : min(facing, -0.125)))));
}

StretchedPlace place_on_surface(float2 place_2, float3 along_2, float3 across_2, float3 normal_1, float3 view_1, float magnification, float angle_2)
{
    float height = (1.0 / clamp(magnification, 1e-15, 1000000000000000.0));
    const float3 _e12 = gradient_on_picture(along_2, normal_1, view_1);
    const float3 _e14 = bounded_vec3_((_e12 * height));
    const float3 _e15 = gradient_on_picture(across_2, normal_1, view_1);
    const float3 _e17 = bounded_vec3_((_e15 * height));
    const StretchedPlace _e18 = mark_place_of(place_2, _e14, _e17, angle_2);
    const StretchedPlace stretchedplace_2 = _e18;
    return stretchedplace_2;
}

StretchedPlace place_across(float3 axis, float3 position, float3x3 world_from_normal, float3 normal_2, float3 view_2, float magnification_1, float angle_3)
{
    const float3x3 _e11 = axes_around(axis, float3(0.0, 1.0, 0.0));
    float2 place_11 = float2(dot(position, _e11[0]), dot(position, _e11[2]));
    float3 along_3 = mul(_e11[0], world_from_normal);
    float3 across_4 = mul(_e11[2], world_from_normal);
    const StretchedPlace _e21 = place_on_surface(place_11, along_3, across_4, normal_2, view_2, magnification_1, angle_3);
    const StretchedPlace stretchedplace_3 = _e21;
    return stretchedplace_3;
}

SpacedPlace ConstructSpacedPlace(float2 arg0, float3 arg1) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

SpacedPlace spaced(float2 place_3, float3 stretch, float2 viewport_1, float count)
{
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    float2 p_6 = clamp((place_3 * scale_2), (-4194304.0).xx, (4194304.0).xx);
    const float3 _e21 = bounded_vec3_(stretch);
    float3 s_1 = clamp(_e21, (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    const SpacedPlace spacedplace = ConstructSpacedPlace(p_6, (is_pixel ? float3(1.0, 0.0, 1.0) : s_1));
    return spacedplace;
}

SpacedPlace spaced_2_(float2 place_4, float3 stretch_1, float2 viewport_2, float count_1)
{
    bool is_pixel_1 = !(((stretch_1.x + stretch_1.z) > 0.0));
    float scale_3 = (is_pixel_1 ? (count_1 / max(viewport_2.y, 1.0)) : count_1);
    float2 p_7 = clamp((place_4 * scale_3), (-4194304.0).xx, (4194304.0).xx);
    const SpacedPlace spacedplace_1 = ConstructSpacedPlace(p_7, (is_pixel_1 ? float3(1.0, 0.0, 1.0) : stretch_1));
    return spacedplace_1;
}

float area_square(float3 stretch_2)
{
    float sum = (stretch_2.x + stretch_2.z);
    return max(((stretch_2.x * stretch_2.z) - (stretch_2.y * stretch_2.y)), ((sum * sum) / 66.0));
}

float2 brush_turned(float2 step_, Brushstroke stroke, Brush style)
{
    float2 turned_2 = float2(((stroke.turn.y * step_.x) + (stroke.turn.x * step_.y)), ((stroke.turn.y * step_.y) - (stroke.turn.x * step_.x)));
    return (turned_2 * float2((stroke.way / (style.size * style.aspect)), (-1.0 / style.size)));
}

Brushstroke ConstructBrushstroke(float2 arg0, float2 arg1, float arg2, float arg3) {
    Brushstroke ret = (Brushstroke)0;
    ret.uv = arg0;
    ret.turn = arg1;
    ret.way = arg2;
    ret.share = arg3;
    return ret;
}

Brushstroke brush_stroke(float2 p, int2 cell_2, int zoom, float drawn, Brush style_1)
{
    const uint3 _e12 = hash_pcg3d((asuint(int3(cell_2, zoom)) + uint3(2654435769u, 2246822507u, 3266489909u)));
    float3 chance = (float3((_e12 >> (8u).xxx)) * 5.9604645e-8);
    float2 offset = (p - ((float2(cell_2) + (0.5).xx) + (style_1.scatter * (chance.xy - (0.5).xx))));
    float x_7 = (0.5 * (chance.z - 0.5));
    float2 turn_8 = float2(sin(x_7), cos(x_7));
    const uint3 _e46 = hash_pcg3d((asuint(int3(cell_2, zoom)) + uint3(1013904242u, 198677718u, 2238012522u)));
    float way = (((float3((_e46 >> (8u).xxx)) * 5.9604645e-8).x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_3 = ConstructBrushstroke((0.5).xx, turn_8, way, 0.0);
    const float2 _e67 = brush_turned((offset * float2(style_1.aspect, 1.0)), stroke_3, style_1);
    float2 uv_1 = ((0.5).xx + _e67);
    float2 from_edge = min(uv_1, ((1.0).xx - uv_1));
    float inside = clamp((64.0 * min(from_edge.x, from_edge.y)), 0.0, 1.0);
    float far = (max(abs(offset.x), abs(offset.y)) / (1.0 - (0.5 * style_1.scatter)));
    float share = ((drawn * inside) * (1.0 - smoothstep(0.85, 1.0, far)));
    const Brushstroke brushstroke = ConstructBrushstroke(uv_1, turn_8, way, share);
    return brushstroke;
}

float3 bristle(float row, uint seed_2)
{
    float first = floor(row);
    float t_2 = (row - first);
    const uint3 _e8 = lattice_hash(int3(naga_f2i32(first), int(0), int(0)), seed_2);
    const float3 _e9 = unit_of_hash(_e8);
    const uint3 _e16 = lattice_hash(int3(asint(asuint(naga_f2i32(first)) + asuint(int(1))), int(0), int(0)), seed_2);
    const float3 _e17 = unit_of_hash(_e16);
    return lerp(_e9, _e17, ((t_2 * t_2) * (3.0 - (2.0 * t_2))));
}

float2 bristles(float2 uv, float width, uint seed_3)
{
    float across_5 = ((2.0 * uv.y) - 1.0);
    const uint3 _e19 = hash_pcg3d((asuint(int3(int(0), int(1), int(0))) + (seed_3 * uint3(2654435769u, 2246822507u, 3266489909u))));
    float3 own = (float3((_e19 >> (8u).xxx)) * 5.9604645e-8);
    float seen = clamp((1.75 - (11.0 * width)), 0.0, 1.0);
    const float3 _e38 = bristle((11.0 * uv.y), seed_3);
    float3 chance_1 = lerp((0.5).xxx, _e38, seen);
    float start = ((0.03 + (0.12 * chance_1.x)) + ((0.09 * across_5) * across_5));
    float end = ((0.97 - ((0.1 + (0.25 * own.y)) * chance_1.y)) - ((0.12 * across_5) * across_5));
    const float _e65 = eased(uv.x, start, (start + 0.05));
    const float _e69 = eased(uv.x, (end - 0.1), end);
    float along_4 = (_e65 * (1.0 - _e69));
    float side = (1.0 - smoothstep(0.78, 0.95, abs(across_5)));
    float dry = smoothstep(0.85, 1.25, (uv.x + (0.55 * chance_1.z)));
    float shade_1 = (((0.8 + (0.16 * own.z)) + (0.208 * (chance_1.z - 0.5))) - (0.05 * uv.x));
    return float2(clamp(shade_1, 0.0, 1.0), ((along_4 * side) * (1.0 - (0.9 * dry))));
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
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

float2 bristles_laid(SpacedPlace at, float ink, Brush style_2)
{
    int i = (int)0;
    int octave = int(0);
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    const float _e8 = area_square(at.stretch);
    const float _e12 = log2_stable(max(sqrt(_e8), 1e-30));
    float level = clamp((-0.5 * _e12), -16.0, 16.0);
    float zoom_6 = floor(level);
    float f_1 = (level - zoom_6);
    const float _e22 = exp2_stable((-2.0 * f_1));
    float fine = ((1.0 - ((1.0 - f_1) * _e22)) / (4.0 * _e22));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e182 = octave;
            octave = asint(asuint(_e182) + asuint(int(1)));
        }
        loop_init = false;
        int _e39 = octave;
        if (!((_e39 < int(2)))) {
            break;
        }
        int _e45 = octave;
        float amount = (ink * ((_e45 == int(1)) ? fine : (1.0 - f_1)));
        int _e51 = octave;
        float scale_4 = asfloat((uint(asint(asuint(asint(asuint(naga_f2i32(zoom_6)) + asuint(_e51))) + asuint(int(127)))) << 23u));
        float2 p_8 = (clamp((at.place * scale_4), (-4194304.0).xx, (4194304.0).xx) / float2(style_2.aspect, 1.0));
        int2 corner = naga_f2i32(floor(p_8));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
        i = int(0);
        uint2 loop_bound_1 = uint2(4294967295u, 4294967295u);
        bool loop_init_1 = true;
        while(true) {
            if (all(loop_bound_1 == uint2(0u, 0u))) { break; }
            loop_bound_1 -= uint2(loop_bound_1.y == 0u, 1u);
            if (!loop_init_1) {
                int _e179 = i;
                i = asint(asuint(_e179) + asuint(int(1)));
            }
            loop_init_1 = false;
            int _e82 = i;
            if (!((_e82 < int(9)))) {
                break;
            }
            int _e86 = i;
            int _e89 = i;
            int2 cell_8 = asint(asuint(asint(asuint(corner) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e86, int(3)), naga_div(_e89, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
            int _e106 = octave;
            int2 turning = asint(asuint(cell_8) + asuint(int2(int(1), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_6)) + asuint(_e106)))))));
            const uint _e112 = blue_index(turning);
            uint _e114 = tile[min(uint(_e112), 255u)];
            float late = (0.96875 * ((float(((_e114 >> (8u * (asuint(turning.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
            float share_1 = clamp(((amount - late) * 32.0), 0.0, 1.0);
            if ((share_1 <= 0.0)) {
                continue;
            }
            int _e140 = octave;
            const Brushstroke _e142 = brush_stroke(p_8, cell_8, asint(asuint(naga_f2i32(zoom_6)) + asuint(_e140)), share_1, style_2);
            if ((_e142.share > 0.0)) {
                const float2 _e147 = brush_turned((dx * scale_4), _e142, style_2);
                const float2 _e149 = brush_turned((dy * scale_4), _e142, style_2);
                int _e151 = octave;
                const uint3 _e160 = hash_pcg3d((asuint(int3(cell_8, asint(asuint(naga_f2i32(zoom_6)) + asuint(_e151)))) + uint3(3668340011u, 2445500225u, 1209535135u)));
                uint own_1 = _e160.x;
                const float2 _e167 = bristles(_e142.uv, length(float2(_e147.y, _e149.y)), own_1);
                float cover = (_e142.share * _e167.y);
                float2 _e174 = paint;
                paint = (float2((_e167.x * cover), cover) + (_e174 * (1.0 - cover)));
            }
        }
    }
    float2 _e185 = paint;
    return _e185;
}

float2 brush_turned_2_(float2 step_1, Brushstroke stroke_1, Brush style_3)
{
    float2 turned_3 = float2(((stroke_1.turn.y * step_1.x) + (stroke_1.turn.x * step_1.y)), ((stroke_1.turn.y * step_1.y) - (stroke_1.turn.x * step_1.x)));
    return (turned_3 * float2((stroke_1.way / (1.5 * style_3.aspect)), -0.6666667));
}

Brushstroke brush_stroke_2_(float2 p_1, int2 cell_3, int zoom_1, float drawn_1, Brush style_4)
{
    const uint3 _e12 = hash_pcg3d((asuint(int3(cell_3, zoom_1)) + uint3(3041712726u, 596033154u, 2419070270u)));
    float3 chance_2 = (float3((_e12 >> (8u).xxx)) * 5.9604645e-8);
    float2 offset_1 = (p_1 - ((float2(cell_3) + (0.5).xx) + (style_4.scatter * (chance_2.xy - (0.5).xx))));
    float x_8 = (0.5 * (chance_2.z - 0.5));
    float2 turn_9 = float2(sin(x_8), cos(x_8));
    const uint3 _e46 = hash_pcg3d((asuint(int3(cell_3, zoom_1)) + uint3(1401181199u, 2842855661u, 1390592883u)));
    float way_1 = (((float3((_e46 >> (8u).xxx)) * 5.9604645e-8).x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_4 = ConstructBrushstroke((0.5).xx, turn_9, way_1, 0.0);
    const float2 _e67 = brush_turned_2_((offset_1 * float2(style_4.aspect, 1.0)), stroke_4, style_4);
    float2 uv_2 = ((0.5).xx + _e67);
    float2 from_edge_1 = min(uv_2, ((1.0).xx - uv_2));
    float inside_1 = clamp((64.0 * min(from_edge_1.x, from_edge_1.y)), 0.0, 1.0);
    float far_1 = (max(abs(offset_1.x), abs(offset_1.y)) / (1.0 - (0.5 * style_4.scatter)));
    float share_2 = ((drawn_1 * inside_1) * (1.0 - smoothstep(0.85, 1.0, far_1)));
    const Brushstroke brushstroke_1 = ConstructBrushstroke(uv_2, turn_9, way_1, share_2);
    return brushstroke_1;
}

float2 bristles_laid_2_(SpacedPlace at_1, float ink_1, Brush style_5)
{
    int i_1 = (int)0;
    int octave_1 = int(0);
    float2 paint_1 = (0.0).xx;
    uint tile_1[256] = BLUE_TILE;

    float2 dx_1 = ddx(at_1.place);
    float2 dy_1 = ddy(at_1.place);
    const float _e8 = area_square(at_1.stretch);
    const float _e12 = log2_stable(max(sqrt(_e8), 1e-30));
    float level_1 = clamp((-0.5 * _e12), -16.0, 16.0);
    float zoom_7 = floor(level_1);
    float f_2 = (level_1 - zoom_7);
    const float _e22 = exp2_stable((-2.0 * f_2));
    float fine_1 = ((1.0 - ((1.0 - f_2) * _e22)) / (4.0 * _e22));
    uint2 loop_bound_2 = uint2(4294967295u, 4294967295u);
    bool loop_init_2 = true;
    while(true) {
        if (all(loop_bound_2 == uint2(0u, 0u))) { break; }
        loop_bound_2 -= uint2(loop_bound_2.y == 0u, 1u);
        if (!loop_init_2) {
            int _e182 = octave_1;
            octave_1 = asint(asuint(_e182) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e39 = octave_1;
        if (!((_e39 < int(2)))) {
            break;
        }
        int _e45 = octave_1;
        float amount_1 = (ink_1 * ((_e45 == int(1)) ? fine_1 : (1.0 - f_2)));
        int _e51 = octave_1;
        float scale_5 = asfloat((uint(asint(asuint(asint(asuint(naga_f2i32(zoom_7)) + asuint(_e51))) + asuint(int(127)))) << 23u));
        float2 p_9 = (clamp((at_1.place * scale_5), (-4194304.0).xx, (4194304.0).xx) / float2(style_5.aspect, 1.0));
        int2 corner_1 = naga_f2i32(floor(p_9));
        int2 phase_1 = naga_mod(asint(asuint(naga_mod(corner_1, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
        i_1 = int(0);
        uint2 loop_bound_3 = uint2(4294967295u, 4294967295u);
        bool loop_init_3 = true;
        while(true) {
            if (all(loop_bound_3 == uint2(0u, 0u))) { break; }
            loop_bound_3 -= uint2(loop_bound_3.y == 0u, 1u);
            if (!loop_init_3) {
                int _e179 = i_1;
                i_1 = asint(asuint(_e179) + asuint(int(1)));
            }
            loop_init_3 = false;
            int _e82 = i_1;
            if (!((_e82 < int(9)))) {
                break;
            }
            int _e86 = i_1;
            int _e89 = i_1;
            int2 cell_9 = asint(asuint(asint(asuint(corner_1) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e86, int(3)), naga_div(_e89, int(3)))) - asuint(phase_1))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
            int _e106 = octave_1;
            int2 turning_1 = asint(asuint(cell_9) + asuint(int2(int(6), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_7)) + asuint(_e106)))))));
            const uint _e112 = blue_index(turning_1);
            uint _e114 = tile_1[min(uint(_e112), 255u)];
            float late_1 = (0.96875 * ((float(((_e114 >> (8u * (asuint(turning_1.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
            float share_3 = clamp(((amount_1 - late_1) * 32.0), 0.0, 1.0);
            if ((share_3 <= 0.0)) {
                continue;
            }
            int _e140 = octave_1;
            const Brushstroke _e142 = brush_stroke_2_(p_9, cell_9, asint(asuint(naga_f2i32(zoom_7)) + asuint(_e140)), share_3, style_5);
            if ((_e142.share > 0.0)) {
                const float2 _e147 = brush_turned_2_((dx_1 * scale_5), _e142, style_5);
                const float2 _e149 = brush_turned_2_((dy_1 * scale_5), _e142, style_5);
                int _e151 = octave_1;
                const uint3 _e160 = hash_pcg3d((asuint(int3(cell_9, asint(asuint(naga_f2i32(zoom_7)) + asuint(_e151)))) + uint3(4055616968u, 794710872u, 362115496u)));
                uint own_2 = _e160.x;
                const float2 _e167 = bristles(_e142.uv, length(float2(_e147.y, _e149.y)), own_2);
                float cover_1 = (_e142.share * _e167.y);
                float2 _e174 = paint_1;
                paint_1 = (float2((_e167.x * cover_1), cover_1) + (_e174 * (1.0 - cover_1)));
            }
        }
    }
    float2 _e185 = paint_1;
    return _e185;
}

Brushstroke brush_stroke_3_(float2 p_2, int2 cell_4, int zoom_2, float drawn_2, Brush style_6)
{
    const uint3 _e12 = hash_pcg3d((asuint(int3(cell_4, zoom_2)) + uint3(1013904242u, 198677718u, 2238012522u)));
    float3 chance_3 = (float3((_e12 >> (8u).xxx)) * 5.9604645e-8);
    float2 offset_2 = (p_2 - ((float2(cell_4) + (0.5).xx) + (style_6.scatter * (chance_3.xy - (0.5).xx))));
    float x_9 = (0.5 * (chance_3.z - 0.5));
    float2 turn_10 = float2(sin(x_9), cos(x_9));
    const uint3 _e46 = hash_pcg3d((asuint(int3(cell_4, zoom_2)) + uint3(3668340011u, 2445500225u, 1209535135u)));
    float way_2 = (((float3((_e46 >> (8u).xxx)) * 5.9604645e-8).x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_5 = ConstructBrushstroke((0.5).xx, turn_10, way_2, 0.0);
    const float2 _e67 = brush_turned((offset_2 * float2(style_6.aspect, 1.0)), stroke_5, style_6);
    float2 uv_3 = ((0.5).xx + _e67);
    float2 from_edge_2 = min(uv_3, ((1.0).xx - uv_3));
    float inside_2 = clamp((64.0 * min(from_edge_2.x, from_edge_2.y)), 0.0, 1.0);
    float far_2 = (max(abs(offset_2.x), abs(offset_2.y)) / (1.0 - (0.5 * style_6.scatter)));
    float share_4 = ((drawn_2 * inside_2) * (1.0 - smoothstep(0.85, 1.0, far_2)));
    const Brushstroke brushstroke_2 = ConstructBrushstroke(uv_3, turn_10, way_2, share_4);
    return brushstroke_2;
}

float2 bristles_laid_3_(SpacedPlace at_2, float ink_2, Brush style_7)
{
    int i_2 = (int)0;
    int octave_2 = int(0);
    float2 paint_2 = (0.0).xx;
    uint tile_2[256] = BLUE_TILE;

    float2 dx_2 = ddx(at_2.place);
    float2 dy_2 = ddy(at_2.place);
    const float _e8 = area_square(at_2.stretch);
    const float _e12 = log2_stable(max(sqrt(_e8), 1e-30));
    float level_2 = clamp((-0.5 * _e12), -16.0, 16.0);
    float zoom_8 = floor(level_2);
    float f_3 = (level_2 - zoom_8);
    const float _e22 = exp2_stable((-2.0 * f_3));
    float fine_2 = ((1.0 - ((1.0 - f_3) * _e22)) / (4.0 * _e22));
    uint2 loop_bound_4 = uint2(4294967295u, 4294967295u);
    bool loop_init_4 = true;
    while(true) {
        if (all(loop_bound_4 == uint2(0u, 0u))) { break; }
        loop_bound_4 -= uint2(loop_bound_4.y == 0u, 1u);
        if (!loop_init_4) {
            int _e182 = octave_2;
            octave_2 = asint(asuint(_e182) + asuint(int(1)));
        }
        loop_init_4 = false;
        int _e39 = octave_2;
        if (!((_e39 < int(2)))) {
            break;
        }
        int _e45 = octave_2;
        float amount_2 = (ink_2 * ((_e45 == int(1)) ? fine_2 : (1.0 - f_3)));
        int _e51 = octave_2;
        float scale_6 = asfloat((uint(asint(asuint(asint(asuint(naga_f2i32(zoom_8)) + asuint(_e51))) + asuint(int(127)))) << 23u));
        float2 p_10 = (clamp((at_2.place * scale_6), (-4194304.0).xx, (4194304.0).xx) / float2(style_7.aspect, 1.0));
        int2 corner_2 = naga_f2i32(floor(p_10));
        int2 phase_2 = naga_mod(asint(asuint(naga_mod(corner_2, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
        i_2 = int(0);
        uint2 loop_bound_5 = uint2(4294967295u, 4294967295u);
        bool loop_init_5 = true;
        while(true) {
            if (all(loop_bound_5 == uint2(0u, 0u))) { break; }
            loop_bound_5 -= uint2(loop_bound_5.y == 0u, 1u);
            if (!loop_init_5) {
                int _e179 = i_2;
                i_2 = asint(asuint(_e179) + asuint(int(1)));
            }
            loop_init_5 = false;
            int _e82 = i_2;
            if (!((_e82 < int(9)))) {
                break;
            }
            int _e86 = i_2;
            int _e89 = i_2;
            int2 cell_10 = asint(asuint(asint(asuint(corner_2) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e86, int(3)), naga_div(_e89, int(3)))) - asuint(phase_2))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
            int _e106 = octave_2;
            int2 turning_2 = asint(asuint(cell_10) + asuint(int2(int(2), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_8)) + asuint(_e106)))))));
            const uint _e112 = blue_index(turning_2);
            uint _e114 = tile_2[min(uint(_e112), 255u)];
            float late_2 = (0.96875 * ((float(((_e114 >> (8u * (asuint(turning_2.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
            float share_5 = clamp(((amount_2 - late_2) * 32.0), 0.0, 1.0);
            if ((share_5 <= 0.0)) {
                continue;
            }
            int _e140 = octave_2;
            const Brushstroke _e142 = brush_stroke_3_(p_10, cell_10, asint(asuint(naga_f2i32(zoom_8)) + asuint(_e140)), share_5, style_7);
            if ((_e142.share > 0.0)) {
                const float2 _e147 = brush_turned((dx_2 * scale_6), _e142, style_7);
                const float2 _e149 = brush_turned((dy_2 * scale_6), _e142, style_7);
                int _e151 = octave_2;
                const uint3 _e160 = hash_pcg3d((asuint(int3(cell_10, asint(asuint(naga_f2i32(zoom_8)) + asuint(_e151)))) + uint3(2027808484u, 397355436u, 181057748u)));
                uint own_3 = _e160.x;
                const float2 _e167 = bristles(_e142.uv, length(float2(_e147.y, _e149.y)), own_3);
                float cover_2 = (_e142.share * _e167.y);
                float2 _e174 = paint_2;
                paint_2 = (float2((_e167.x * cover_2), cover_2) + (_e174 * (1.0 - cover_2)));
            }
        }
    }
    float2 _e185 = paint_2;
    return _e185;
}

float2 brush_turned_3_(float2 step_2, Brushstroke stroke_2, Brush style_8)
{
    float2 turned_4 = float2(((stroke_2.turn.y * step_2.x) + (stroke_2.turn.x * step_2.y)), ((stroke_2.turn.y * step_2.y) - (stroke_2.turn.x * step_2.x)));
    return (turned_4 * float2((stroke_2.way / 4.5), -0.6666667));
}

Brushstroke brush_stroke_4_(float2 p_3, int2 cell_5, int zoom_3, float drawn_3, Brush style_9)
{
    const uint3 _e12 = hash_pcg3d((asuint(int3(cell_5, zoom_3)) + uint3(3668340011u, 2445500225u, 1209535135u)));
    float3 chance_4 = (float3((_e12 >> (8u).xxx)) * 5.9604645e-8);
    float2 offset_3 = (p_3 - ((float2(cell_5) + (0.5).xx) + (style_9.scatter * (chance_4.xy - (0.5).xx))));
    float x_10 = (0.5 * (chance_4.z - 0.5));
    float2 turn_11 = float2(sin(x_10), cos(x_10));
    const uint3 _e46 = hash_pcg3d((asuint(int3(cell_5, zoom_3)) + uint3(2027808484u, 397355436u, 181057748u)));
    float way_3 = (((float3((_e46 >> (8u).xxx)) * 5.9604645e-8).x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_6 = ConstructBrushstroke((0.5).xx, turn_11, way_3, 0.0);
    const float2 _e67 = brush_turned_3_((offset_3 * float2(3.0, 1.0)), stroke_6, style_9);
    float2 uv_4 = ((0.5).xx + _e67);
    float2 from_edge_3 = min(uv_4, ((1.0).xx - uv_4));
    float inside_3 = clamp((64.0 * min(from_edge_3.x, from_edge_3.y)), 0.0, 1.0);
    float far_3 = (max(abs(offset_3.x), abs(offset_3.y)) / (1.0 - (0.5 * style_9.scatter)));
    float share_6 = ((drawn_3 * inside_3) * (1.0 - smoothstep(0.85, 1.0, far_3)));
    const Brushstroke brushstroke_3 = ConstructBrushstroke(uv_4, turn_11, way_3, share_6);
    return brushstroke_3;
}

float2 bristles_laid_4_(SpacedPlace at_3, float ink_3, Brush style_10)
{
    int i_3 = (int)0;
    int octave_3 = int(0);
    float2 paint_3 = (0.0).xx;
    uint tile_3[256] = BLUE_TILE;

    float2 dx_3 = ddx(at_3.place);
    float2 dy_3 = ddy(at_3.place);
    const float _e8 = area_square(at_3.stretch);
    const float _e12 = log2_stable(max(sqrt(_e8), 1e-30));
    float level_3 = clamp((-0.5 * _e12), -16.0, 16.0);
    float zoom_9 = floor(level_3);
    float f_4 = (level_3 - zoom_9);
    const float _e22 = exp2_stable((-2.0 * f_4));
    float fine_3 = ((1.0 - ((1.0 - f_4) * _e22)) / (4.0 * _e22));
    uint2 loop_bound_6 = uint2(4294967295u, 4294967295u);
    bool loop_init_6 = true;
    while(true) {
        if (all(loop_bound_6 == uint2(0u, 0u))) { break; }
        loop_bound_6 -= uint2(loop_bound_6.y == 0u, 1u);
        if (!loop_init_6) {
            int _e182 = octave_3;
            octave_3 = asint(asuint(_e182) + asuint(int(1)));
        }
        loop_init_6 = false;
        int _e39 = octave_3;
        if (!((_e39 < int(2)))) {
            break;
        }
        int _e45 = octave_3;
        float amount_3 = (ink_3 * ((_e45 == int(1)) ? fine_3 : (1.0 - f_4)));
        int _e51 = octave_3;
        float scale_7 = asfloat((uint(asint(asuint(asint(asuint(naga_f2i32(zoom_9)) + asuint(_e51))) + asuint(int(127)))) << 23u));
        float2 p_11 = (clamp((at_3.place * scale_7), (-4194304.0).xx, (4194304.0).xx) / float2(3.0, 1.0));
        int2 corner_3 = naga_f2i32(floor(p_11));
        int2 phase_3 = naga_mod(asint(asuint(naga_mod(corner_3, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
        i_3 = int(0);
        uint2 loop_bound_7 = uint2(4294967295u, 4294967295u);
        bool loop_init_7 = true;
        while(true) {
            if (all(loop_bound_7 == uint2(0u, 0u))) { break; }
            loop_bound_7 -= uint2(loop_bound_7.y == 0u, 1u);
            if (!loop_init_7) {
                int _e179 = i_3;
                i_3 = asint(asuint(_e179) + asuint(int(1)));
            }
            loop_init_7 = false;
            int _e82 = i_3;
            if (!((_e82 < int(9)))) {
                break;
            }
            int _e86 = i_3;
            int _e89 = i_3;
            int2 cell_11 = asint(asuint(asint(asuint(corner_3) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e86, int(3)), naga_div(_e89, int(3)))) - asuint(phase_3))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
            int _e106 = octave_3;
            int2 turning_3 = asint(asuint(cell_11) + asuint(int2(int(3), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_9)) + asuint(_e106)))))));
            const uint _e112 = blue_index(turning_3);
            uint _e114 = tile_3[min(uint(_e112), 255u)];
            float late_3 = (0.96875 * ((float(((_e114 >> (8u * (asuint(turning_3.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
            float share_7 = clamp(((amount_3 - late_3) * 32.0), 0.0, 1.0);
            if ((share_7 <= 0.0)) {
                continue;
            }
            int _e140 = octave_3;
            const Brushstroke _e142 = brush_stroke_4_(p_11, cell_11, asint(asuint(naga_f2i32(zoom_9)) + asuint(_e140)), share_7, style_10);
            if ((_e142.share > 0.0)) {
                const float2 _e147 = brush_turned_3_((dx_3 * scale_7), _e142, style_10);
                const float2 _e149 = brush_turned_3_((dy_3 * scale_7), _e142, style_10);
                int _e151 = octave_3;
                const uint3 _e160 = hash_pcg3d((asuint(int3(cell_11, asint(asuint(naga_f2i32(zoom_9)) + asuint(_e151)))) + uint3(387276957u, 2644177943u, 3447547657u)));
                uint own_4 = _e160.x;
                const float2 _e167 = bristles(_e142.uv, length(float2(_e147.y, _e149.y)), own_4);
                float cover_3 = (_e142.share * _e167.y);
                float2 _e174 = paint_3;
                paint_3 = (float2((_e167.x * cover_3), cover_3) + (_e174 * (1.0 - cover_3)));
            }
        }
    }
    float2 _e185 = paint_3;
    return _e185;
}

Brushstroke brush_stroke_5_(float2 p_4, int2 cell_6, int zoom_4, float drawn_4, Brush style_11)
{
    const uint3 _e12 = hash_pcg3d((asuint(int3(cell_6, zoom_4)) + uint3(2027808484u, 397355436u, 181057748u)));
    float3 chance_5 = (float3((_e12 >> (8u).xxx)) * 5.9604645e-8);
    float2 offset_4 = (p_4 - ((float2(cell_6) + (0.5).xx) + (style_11.scatter * (chance_5.xy - (0.5).xx))));
    float x_11 = (style_11.turn * (chance_5.z - 0.5));
    float2 turn_12 = float2(sin(x_11), cos(x_11));
    const uint3 _e46 = hash_pcg3d((asuint(int3(cell_6, zoom_4)) + uint3(387276957u, 2644177943u, 3447547657u)));
    float way_4 = (((float3((_e46 >> (8u).xxx)) * 5.9604645e-8).x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_7 = ConstructBrushstroke((0.5).xx, turn_12, way_4, 0.0);
    const float2 _e67 = brush_turned((offset_4 * float2(style_11.aspect, 1.0)), stroke_7, style_11);
    float2 uv_5 = ((0.5).xx + _e67);
    float2 from_edge_4 = min(uv_5, ((1.0).xx - uv_5));
    float inside_4 = clamp((64.0 * min(from_edge_4.x, from_edge_4.y)), 0.0, 1.0);
    float far_4 = (max(abs(offset_4.x), abs(offset_4.y)) / (1.0 - (0.5 * style_11.scatter)));
    float share_8 = ((drawn_4 * inside_4) * (1.0 - smoothstep(0.85, 1.0, far_4)));
    const Brushstroke brushstroke_4 = ConstructBrushstroke(uv_5, turn_12, way_4, share_8);
    return brushstroke_4;
}

float2 bristles_laid_5_(SpacedPlace at_4, float ink_4, Brush style_12)
{
    int i_4 = (int)0;
    int octave_4 = int(0);
    float2 paint_4 = (0.0).xx;
    uint tile_4[256] = BLUE_TILE;

    float2 dx_4 = ddx(at_4.place);
    float2 dy_4 = ddy(at_4.place);
    const float _e8 = area_square(at_4.stretch);
    const float _e12 = log2_stable(max(sqrt(_e8), 1e-30));
    float level_4 = clamp((-0.5 * _e12), -16.0, 16.0);
    float zoom_10 = floor(level_4);
    float f_5 = (level_4 - zoom_10);
    const float _e22 = exp2_stable((-2.0 * f_5));
    float fine_4 = ((1.0 - ((1.0 - f_5) * _e22)) / (4.0 * _e22));
    uint2 loop_bound_8 = uint2(4294967295u, 4294967295u);
    bool loop_init_8 = true;
    while(true) {
        if (all(loop_bound_8 == uint2(0u, 0u))) { break; }
        loop_bound_8 -= uint2(loop_bound_8.y == 0u, 1u);
        if (!loop_init_8) {
            int _e182 = octave_4;
            octave_4 = asint(asuint(_e182) + asuint(int(1)));
        }
        loop_init_8 = false;
        int _e39 = octave_4;
        if (!((_e39 < int(2)))) {
            break;
        }
        int _e45 = octave_4;
        float amount_4 = (ink_4 * ((_e45 == int(1)) ? fine_4 : (1.0 - f_5)));
        int _e51 = octave_4;
        float scale_8 = asfloat((uint(asint(asuint(asint(asuint(naga_f2i32(zoom_10)) + asuint(_e51))) + asuint(int(127)))) << 23u));
        float2 p_12 = (clamp((at_4.place * scale_8), (-4194304.0).xx, (4194304.0).xx) / float2(style_12.aspect, 1.0));
        int2 corner_4 = naga_f2i32(floor(p_12));
        int2 phase_4 = naga_mod(asint(asuint(naga_mod(corner_4, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
        i_4 = int(0);
        uint2 loop_bound_9 = uint2(4294967295u, 4294967295u);
        bool loop_init_9 = true;
        while(true) {
            if (all(loop_bound_9 == uint2(0u, 0u))) { break; }
            loop_bound_9 -= uint2(loop_bound_9.y == 0u, 1u);
            if (!loop_init_9) {
                int _e179 = i_4;
                i_4 = asint(asuint(_e179) + asuint(int(1)));
            }
            loop_init_9 = false;
            int _e82 = i_4;
            if (!((_e82 < int(9)))) {
                break;
            }
            int _e86 = i_4;
            int _e89 = i_4;
            int2 cell_12 = asint(asuint(asint(asuint(corner_4) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e86, int(3)), naga_div(_e89, int(3)))) - asuint(phase_4))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
            int _e106 = octave_4;
            int2 turning_4 = asint(asuint(cell_12) + asuint(int2(int(4), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_10)) + asuint(_e106)))))));
            const uint _e112 = blue_index(turning_4);
            uint _e114 = tile_4[min(uint(_e112), 255u)];
            float late_4 = (0.96875 * ((float(((_e114 >> (8u * (asuint(turning_4.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
            float share_9 = clamp(((amount_4 - late_4) * 32.0), 0.0, 1.0);
            if ((share_9 <= 0.0)) {
                continue;
            }
            int _e140 = octave_4;
            const Brushstroke _e142 = brush_stroke_5_(p_12, cell_12, asint(asuint(naga_f2i32(zoom_10)) + asuint(_e140)), share_9, style_12);
            if ((_e142.share > 0.0)) {
                const float2 _e147 = brush_turned((dx_4 * scale_8), _e142, style_12);
                const float2 _e149 = brush_turned((dy_4 * scale_8), _e142, style_12);
                int _e151 = octave_4;
                const uint3 _e160 = hash_pcg3d((asuint(int3(cell_12, asint(asuint(naga_f2i32(zoom_10)) + asuint(_e151)))) + uint3(3041712726u, 596033154u, 2419070270u)));
                uint own_5 = _e160.x;
                const float2 _e167 = bristles(_e142.uv, length(float2(_e147.y, _e149.y)), own_5);
                float cover_4 = (_e142.share * _e167.y);
                float2 _e174 = paint_4;
                paint_4 = (float2((_e167.x * cover_4), cover_4) + (_e174 * (1.0 - cover_4)));
            }
        }
    }
    float2 _e185 = paint_4;
    return _e185;
}

Brushstroke brush_stroke_6_(float2 p_5, int2 cell_7, int zoom_5, float drawn_5, Brush style_13)
{
    const uint3 _e12 = hash_pcg3d((asuint(int3(cell_7, zoom_5)) + uint3(4055616968u, 794710872u, 362115496u)));
    float3 chance_6 = (float3((_e12 >> (8u).xxx)) * 5.9604645e-8);
    float2 offset_5 = (p_5 - ((float2(cell_7) + (0.5).xx) + (style_13.scatter * (chance_6.xy - (0.5).xx))));
    float x_12 = (style_13.turn * (chance_6.z - 0.5));
    float2 turn_13 = float2(sin(x_12), cos(x_12));
    const uint3 _e46 = hash_pcg3d((asuint(int3(cell_7, zoom_5)) + uint3(2415085441u, 3041533379u, 3628605405u)));
    float way_5 = (((float3((_e46 >> (8u).xxx)) * 5.9604645e-8).x < 0.5) ? 1.0 : -1.0);
    Brushstroke stroke_8 = ConstructBrushstroke((0.5).xx, turn_13, way_5, 0.0);
    const float2 _e67 = brush_turned_2_((offset_5 * float2(style_13.aspect, 1.0)), stroke_8, style_13);
    float2 uv_6 = ((0.5).xx + _e67);
    float2 from_edge_5 = min(uv_6, ((1.0).xx - uv_6));
    float inside_5 = clamp((64.0 * min(from_edge_5.x, from_edge_5.y)), 0.0, 1.0);
    float far_5 = (max(abs(offset_5.x), abs(offset_5.y)) / (1.0 - (0.5 * style_13.scatter)));
    float share_10 = ((drawn_5 * inside_5) * (1.0 - smoothstep(0.85, 1.0, far_5)));
    const Brushstroke brushstroke_5 = ConstructBrushstroke(uv_6, turn_13, way_5, share_10);
    return brushstroke_5;
}

float2 bristles_laid_6_(SpacedPlace at_5, float ink_5, Brush style_14)
{
    int i_5 = (int)0;
    int octave_5 = int(0);
    float2 paint_5 = (0.0).xx;
    uint tile_5[256] = BLUE_TILE;

    float2 dx_5 = ddx(at_5.place);
    float2 dy_5 = ddy(at_5.place);
    const float _e8 = area_square(at_5.stretch);
    const float _e12 = log2_stable(max(sqrt(_e8), 1e-30));
    float level_5 = clamp((-0.5 * _e12), -16.0, 16.0);
    float zoom_11 = floor(level_5);
    float f_6 = (level_5 - zoom_11);
    const float _e22 = exp2_stable((-2.0 * f_6));
    float fine_5 = ((1.0 - ((1.0 - f_6) * _e22)) / (4.0 * _e22));
    uint2 loop_bound_10 = uint2(4294967295u, 4294967295u);
    bool loop_init_10 = true;
    while(true) {
        if (all(loop_bound_10 == uint2(0u, 0u))) { break; }
        loop_bound_10 -= uint2(loop_bound_10.y == 0u, 1u);
        if (!loop_init_10) {
            int _e182 = octave_5;
            octave_5 = asint(asuint(_e182) + asuint(int(1)));
        }
        loop_init_10 = false;
        int _e39 = octave_5;
        if (!((_e39 < int(2)))) {
            break;
        }
        int _e45 = octave_5;
        float amount_5 = (ink_5 * ((_e45 == int(1)) ? fine_5 : (1.0 - f_6)));
        int _e51 = octave_5;
        float scale_9 = asfloat((uint(asint(asuint(asint(asuint(naga_f2i32(zoom_11)) + asuint(_e51))) + asuint(int(127)))) << 23u));
        float2 p_13 = (clamp((at_5.place * scale_9), (-4194304.0).xx, (4194304.0).xx) / float2(style_14.aspect, 1.0));
        int2 corner_5 = naga_f2i32(floor(p_13));
        int2 phase_5 = naga_mod(asint(asuint(naga_mod(corner_5, (int(3)).xx)) + asuint((int(3)).xx)), (int(3)).xx);
        i_5 = int(0);
        uint2 loop_bound_11 = uint2(4294967295u, 4294967295u);
        bool loop_init_11 = true;
        while(true) {
            if (all(loop_bound_11 == uint2(0u, 0u))) { break; }
            loop_bound_11 -= uint2(loop_bound_11.y == 0u, 1u);
            if (!loop_init_11) {
                int _e179 = i_5;
                i_5 = asint(asuint(_e179) + asuint(int(1)));
            }
            loop_init_11 = false;
            int _e82 = i_5;
            if (!((_e82 < int(9)))) {
                break;
            }
            int _e86 = i_5;
            int _e89 = i_5;
            int2 cell_13 = asint(asuint(asint(asuint(corner_5) + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(_e86, int(3)), naga_div(_e89, int(3)))) - asuint(phase_5))) + asuint((int(4)).xx)), (int(3)).xx)))) - asuint((int(1)).xx));
            int _e106 = octave_5;
            int2 turning_5 = asint(asuint(cell_13) + asuint(int2(int(8), asint(asuint(int(7)) * asuint(asint(asuint(naga_f2i32(zoom_11)) + asuint(_e106)))))));
            const uint _e112 = blue_index(turning_5);
            uint _e114 = tile_5[min(uint(_e112), 255u)];
            float late_5 = (0.96875 * ((float(((_e114 >> (8u * (asuint(turning_5.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
            float share_11 = clamp(((amount_5 - late_5) * 32.0), 0.0, 1.0);
            if ((share_11 <= 0.0)) {
                continue;
            }
            int _e140 = octave_5;
            const Brushstroke _e142 = brush_stroke_6_(p_13, cell_13, asint(asuint(naga_f2i32(zoom_11)) + asuint(_e140)), share_11, style_14);
            if ((_e142.share > 0.0)) {
                const float2 _e147 = brush_turned_2_((dx_5 * scale_9), _e142, style_14);
                const float2 _e149 = brush_turned_2_((dy_5 * scale_9), _e142, style_14);
                int _e151 = octave_5;
                const uint3 _e160 = hash_pcg3d((asuint(int3(cell_13, asint(asuint(naga_f2i32(zoom_11)) + asuint(_e151)))) + uint3(774553914u, 993388590u, 2600128018u)));
                uint own_6 = _e160.x;
                const float2 _e167 = bristles(_e142.uv, length(float2(_e147.y, _e149.y)), own_6);
                float cover_5 = (_e142.share * _e167.y);
                float2 _e174 = paint_5;
                paint_5 = (float2((_e167.x * cover_5), cover_5) + (_e174 * (1.0 - cover_5)));
            }
        }
    }
    float2 _e185 = paint_5;
    return _e185;
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

BrushStrokes ConstructBrushStrokes(float4 arg0, float arg1) {
    BrushStrokes ret = (BrushStrokes)0;
    ret.color = arg0;
    ret.ink = arg1;
    return ret;
}

BrushStrokes brush_strokes_bristles(float value, float2 place_5, float3 stretch_3, float count_2, float aspect, float size, float scatter, float turn, int seed_4, float2 viewport_3)
{
    const SpacedPlace _e10 = spaced(place_5, stretch_3, viewport_3, count_2);
    Brush style_15 = ConstructBrush(aspect, size, scatter, turn, 1u, false);
    const float2 _e16 = bristles_laid(_e10, (1.0 - value), style_15);
    float shade_2 = (_e16.x / max(_e16.y, 0.001));
    const BrushStrokes brushstrokes = ConstructBrushStrokes(float4(shade_2, shade_2, shade_2, 1.0), _e16.y);
    return brushstrokes;
}

BrushStrokes brush_strokes_bristles_2_(float value_1, float2 place_6, float3 stretch_4, float count_3, float aspect_1, float size_1, float scatter_1, float turn_1, int seed_5, float2 viewport_4)
{
    const SpacedPlace _e10 = spaced(place_6, stretch_4, viewport_4, count_3);
    Brush style_16 = ConstructBrush(aspect_1, size_1, scatter_1, turn_1, 6u, false);
    const float2 _e16 = bristles_laid_2_(_e10, (1.0 - value_1), style_16);
    float shade_3 = (_e16.x / max(_e16.y, 0.001));
    const BrushStrokes brushstrokes_1 = ConstructBrushStrokes(float4(shade_3, shade_3, shade_3, 1.0), _e16.y);
    return brushstrokes_1;
}

BrushStrokes brush_strokes_bristles_3_(float value_2, float2 place_7, float3 stretch_5, float count_4, float aspect_2, float size_2, float scatter_2, float turn_2, int seed_6, float2 viewport_5)
{
    const SpacedPlace _e10 = spaced(place_7, stretch_5, viewport_5, count_4);
    Brush style_17 = ConstructBrush(aspect_2, size_2, scatter_2, turn_2, 2u, false);
    const float2 _e16 = bristles_laid_3_(_e10, (1.0 - value_2), style_17);
    float shade_4 = (_e16.x / max(_e16.y, 0.001));
    const BrushStrokes brushstrokes_2 = ConstructBrushStrokes(float4(shade_4, shade_4, shade_4, 1.0), _e16.y);
    return brushstrokes_2;
}

BrushStrokes brush_strokes_bristles_4_(float value_3, float2 place_8, float3 stretch_6, float count_5, float aspect_3, float size_3, float scatter_3, float turn_3, int seed_7, float2 viewport_6)
{
    const SpacedPlace _e10 = spaced_2_(place_8, stretch_6, viewport_6, count_5);
    Brush style_18 = ConstructBrush(aspect_3, size_3, scatter_3, turn_3, 3u, false);
    const float2 _e16 = bristles_laid_4_(_e10, (1.0 - value_3), style_18);
    float shade_5 = (_e16.x / max(_e16.y, 0.001));
    const BrushStrokes brushstrokes_3 = ConstructBrushStrokes(float4(shade_5, shade_5, shade_5, 1.0), _e16.y);
    return brushstrokes_3;
}

BrushStrokes brush_strokes_bristles_5_(float value_4, float2 place_9, float3 stretch_7, float count_6, float aspect_4, float size_4, float scatter_4, float turn_4, int seed_8, float2 viewport_7)
{
    const SpacedPlace _e10 = spaced_2_(place_9, stretch_7, viewport_7, count_6);
    Brush style_19 = ConstructBrush(aspect_4, size_4, scatter_4, turn_4, 4u, false);
    const float2 _e16 = bristles_laid_5_(_e10, (1.0 - value_4), style_19);
    float shade_6 = (_e16.x / max(_e16.y, 0.001));
    const BrushStrokes brushstrokes_4 = ConstructBrushStrokes(float4(shade_6, shade_6, shade_6, 1.0), _e16.y);
    return brushstrokes_4;
}

BrushStrokes brush_strokes_bristles_6_(float value_5, float2 place_10, float3 stretch_8, float count_7, float aspect_5, float size_5, float scatter_5, float turn_5, int seed_9, float2 viewport_8)
{
    const SpacedPlace _e10 = spaced(place_10, stretch_8, viewport_8, count_7);
    Brush style_20 = ConstructBrush(aspect_5, size_5, scatter_5, turn_5, 8u, false);
    const float2 _e16 = bristles_laid_6_(_e10, (1.0 - value_5), style_20);
    float shade_7 = (_e16.x / max(_e16.y, 0.001));
    const BrushStrokes brushstrokes_5 = ConstructBrushStrokes(float4(shade_7, shade_7, shade_7, 1.0), _e16.y);
    return brushstrokes_5;
}

MarkPlace ConstructMarkPlace(float2 arg0, float3 arg1) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = arg0;
    ret.stretch = arg1;
    return ret;
}

MarkPlace mark_place_axis(float3 axis_1, float3 normal_3, float angle_4, float3 view_3, float3 position_object, float3x3 world_from_normal_1, float magnification_2)
{
    const StretchedPlace _e7 = place_across(axis_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_4);
    const MarkPlace markplace = ConstructMarkPlace(_e7.place, _e7.stretch);
    return markplace;
}

MarkPlace mark_place_object(float angle_5, float3 anchor, float2 pixel_1, float2 viewport_9)
{
    float size_6 = clamp(anchor.z, 1e-6, 1000000.0);
    const float2 _e8 = place_in_picture(pixel_1, viewport_9);
    float2 place_12 = ((_e8 - float2(anchor.x, -(anchor.y))) / (size_6).xx);
    const StretchedPlace _e26 = mark_place_of_2_(place_12, float3((1.0 / size_6), 0.0, 0.0), float3(0.0, (1.0 / size_6), 0.0), angle_5);
    const MarkPlace markplace_1 = ConstructMarkPlace(_e26.place, _e26.stretch);
    return markplace_1;
}

float reflectance_half_lambert(Light light, float3 normal_4)
{
    float half_ = (0.5 + (0.5 * dot(normal_4, light.direction)));
    return min((half_ * half_), 1.0);
}

float map_range(float value_6, float from_low, float from_high, float to_low, float to_high, bool clamped)
{
    return lerp(to_low, to_high, clamp(((value_6 - from_low) / (from_high - from_low)), 0.0, 1.0));
}

float4 shade(Surface surface)
{
    const float3 _e3 = normalize_moderate(surface.smooth_normal_1_, surface.normal);
    Light _e6 = look.key;
    const float _e7 = reflectance_half_lambert(_e6, _e3);
    const float _e13 = map_range(_e7, 0.02, 0.2, 1.0, 0.0, true);
    const float3 _e16 = normalize_moderate(surface.smooth_normal_3_, surface.normal);
    const MarkPlace _e26 = mark_place_axis(float3(0.35, 1.0, 0.25), _e16, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    float2 _e37 = look.viewport;
    const BrushStrokes _e38 = brush_strokes_bristles(_e13, _e26.place, _e26.stretch, 14.0, 3.4, 1.8, 0.6, 0.5, int(1), _e37);
    float4 _e44 = look.umber_as_paint_b;
    const float4 _e48 = color_mixed(_e38.color, (_e38.color.xyz * _e44.xyz), 1.0);
    float4 _e51 = look.toned_canvas;
    const float4 _e52 = bounded_vec4_(_e48);
    const float4 _e57 = mixed_vec4_(_e51, _e52, clamp(_e38.ink, 0.0, 1.0));
    float3 _e61 = look.sky.direction;
    float reflected_light = max(dot(_e3, _e61), 0.0);
    float where_cool_reflections_go = lerp(1.0, 0.0, clamp(((reflected_light - 0.25) / 0.5), 0.0, 1.0));
    float2 _e85 = look.viewport;
    const BrushStrokes _e86 = brush_strokes_bristles_2_(where_cool_reflections_go, _e26.place, _e26.stretch, 18.0, 3.2, 1.5, 0.6, 0.5, int(6), _e85);
    float4 _e92 = look.cool_reflections_as_paint_b;
    const float4 _e96 = color_mixed(_e86.color, (_e86.color.xyz * _e92.xyz), 1.0);
    const float4 _e98 = mix_colors_normal(_e57, _e96, _e86.ink);
    const float _e104 = map_range(_e7, 0.24, 0.42, 1.0, 0.0, true);
    float2 _e115 = look.viewport;
    const BrushStrokes _e116 = brush_strokes_bristles_3_(_e104, _e26.place, _e26.stretch, 18.0, 3.2, 1.6, 0.6, 0.5, int(2), _e115);
    float4 _e122 = look.half_tones_as_paint_b;
    const float4 _e126 = color_mixed(_e116.color, (_e116.color.xyz * _e122.xyz), 1.0);
    const float4 _e128 = mix_colors_normal(_e98, _e126, _e116.ink);
    const float _e134 = map_range(_e7, 0.46, 0.66, 1.0, 0.0, true);
    float2 _e140 = look.viewport;
    const MarkPlace _e141 = mark_place_object(0.75, surface.anchor, surface.pixel, _e140);
    float2 _e152 = look.viewport;
    const BrushStrokes _e153 = brush_strokes_bristles_4_(_e134, _e141.place, _e141.stretch, 24.0, 3.0, 1.5, 0.6, 0.5, int(3), _e152);
    float4 _e159 = look.light_as_paint_b;
    const float4 _e163 = color_mixed(_e153.color, (_e153.color.xyz * _e159.xyz), 1.0);
    const float4 _e165 = mix_colors_normal(_e128, _e163, _e153.ink);
    const float _e171 = map_range(_e7, 0.76, 0.95, 1.0, 0.0, true);
    float2 _e182 = look.viewport;
    const BrushStrokes _e183 = brush_strokes_bristles_5_(_e171, _e141.place, _e141.stretch, 32.0, 2.6, 1.3, 0.6, 0.4, int(4), _e182);
    float4 _e189 = look.thick_lights_as_paint_b;
    const float4 _e193 = color_mixed(_e183.color, (_e183.color.xyz * _e189.xyz), 1.0);
    const float4 _e195 = mix_colors_normal(_e165, _e193, _e183.ink);
    float hollows = surface.kappa;
    float where_accents_go = lerp(1.0, 0.0, clamp(((hollows + 6.0) / -14.0), 0.0, 1.0));
    float2 _e217 = look.viewport;
    const BrushStrokes _e218 = brush_strokes_bristles_6_(where_accents_go, _e26.place, _e26.stretch, 44.0, 3.4, 1.5, 0.6, 0.4, int(8), _e217);
    float4 _e224 = look.accents_as_paint_b;
    const float4 _e228 = color_mixed(_e218.color, (_e218.color.xyz * _e224.xyz), 1.0);
    const float4 _e230 = mix_colors_normal(_e195, _e228, _e218.ink);
    float4 output_alpha = float4(_e230.xyz, clamp(_e230.w, 0.0, 1.0));
    const float4 _e237 = premultiplied(output_alpha);
    const float4 _e238 = output(_e237);
    return _e238;
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
    float4x4 _e10 = view_4.clip_from_world;
    float3x3 _e16 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, vertex.position, mul(vertex.normal, _e16));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.position_object, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float arg3, float3 arg4, float3 arg5, float2 arg6, float3 arg7, float arg8, float3x3 arg9) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_object = arg2;
    ret.kappa = arg3;
    ret.smooth_normal_1_ = arg4;
    ret.smooth_normal_3_ = arg5;
    ret.pixel = arg6;
    ret.anchor = arg7;
    ret.magnification = arg8;
    ret.world_from_normal = arg9;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_2, fragmentinput_fs_main.position_object_2, fragmentinput_fs_main.normal_6 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen(in_.normal);
    float3 normal_7 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_4.eye;
    float _e13 = view_4.eye.w;
    float4 _e24 = curvature_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e31 = smooth_normal_1_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e37 = view_4.camera_from_world;
    float4 _e45 = smooth_normal_3_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4x4 _e51 = view_4.camera_from_world;
    float4 _e58 = view_4.screen;
    float4 _e63 = view_4.screen;
    float4x4 _e68 = view_4.camera_from_world;
    float4 _e72 = object.world_from_object[3];
    float _e81 = view_4.eye.w;
    float _e86 = view_4.clip_from_world[0].y;
    float _e91 = view_4.clip_from_world[1].y;
    float _e96 = view_4.clip_from_world[2].y;
    const float3 _e99 = anchor_on_screen(mul(float4(_e72.xyz, 1.0), _e68).xyz, _e81, length(float3(_e86, _e91, _e96)));
    float4x4 _e102 = view_4.camera_from_world;
    float _e112 = view_4.eye.w;
    float _e117 = view_4.clip_from_world[0].y;
    float _e122 = view_4.clip_from_world[1].y;
    float _e127 = view_4.clip_from_world[2].y;
    const float _e130 = size_on_screen(-(mul(float4(in_.position, 1.0), _e102).z), _e112, length(float3(_e117, _e122, _e127)));
    float3x3 _e133 = object.world_from_normal;
    Surface surface_1 = ConstructSurface(normal_7, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x, mul(_e37, float4(_e31.xyz, 0.0)).xyz, mul(_e51, float4(_e45.xyz, 0.0)).xyz, ((in_.clip_.xy * _e58.xy) + _e63.zw), _e99, _e130, _e133);
    const float4 _e135 = shade(surface_1);
    const float4 _e136 = finite_vec4_(_e135);
    return _e136;
}
