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

static const uint BLUE_TILE[256] = Constructarray256_uint_(667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);
static const ProfileShape tone_shape = ConstructProfileShape(0.99875027, 0.04997917, 1.229384, 1.5428282, 0.1, 1.0145569, 0.43140125, 0u);

cbuffer view_2 : register(b0) { View view_2; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

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

float3 normalize_seen_balanced(float3 v)
{
    return (v * rsqrt(max(dot(v, v), 1e-30)));
}

float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle ConstructAngle(float arg0, float arg1) {
    Angle ret = (Angle)0;
    ret.half_sin = arg0;
    ret.half_cos = arg1;
    return ret;
}

Angle angle_turned(Angle u_1, float2 t)
{
    float s_1 = (u_1.half_sin - 0.0);
    float2 upper = ((u_1.half_cos <= 0.0) ? float2(1.0, 0.0) : float2(s_1, u_1.half_cos));
    float2 turned = (((s_1 <= 0.0) & (s_1 < u_1.half_cos)) ? float2(0.0, 1.0) : upper);
    const Angle angle_1 = ConstructAngle(turned.x, turned.y);
    return angle_1;
}

float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = (bits & 2147483647u);
    float largest = asfloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x : ((magnitude == 2139095040u) ? largest : 0.0));
}

float footprint_of(float x_1)
{
    float _e1 = ddx(x_1);
    float _e2 = ddy(x_1);
    float2 d = float2(_e1, _e2);
    const float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

float footprint_of_2_(float x_2)
{
    float _e1 = ddx(x_2);
    float _e2 = ddy(x_2);
    float2 d_1 = float2(_e1, _e2);
    return sqrt(dot(d_1, d_1));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0);
}

float profile_soft_quick(float s, ProfileShape shape)
{
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1)
{
    float2 place_2 = float2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    const float _e19 = profile_soft_quick(place_2.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    float2 turn = float2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    const float _e45 = profile_soft_quick(((place_2.x * turn.y) - (place_2.y * turn.x)), shape_1);
    const float _e53 = profile_soft_quick(((place_2.x * turn.y) + (place_2.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2)
{
    const Angle _e6 = angle_turned(angle, float2(0.0, 1.0));
    const float _e7 = angle_footprint(_e6);
    const float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

uint blue_index(int2 cell)
{
    uint2 at = (asuint(cell) & (31u).xx);
    return ((8u * at.y) + (at.x >> 2u));
}

float rim(Light light, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    const float _e10 = footprint_of_2_(facing);
    float edge = min(_e10, 1.0);
    float3 aside = (normal - view);
    float further = ((facing > 0.5) ? ((0.5 * dot(aside, aside)) - (1.0 - width)) : (width - facing));
    float within = ((further / max(edge, 1e-6)) + 0.5);
    float inside = clamp(within, 0.0, 1.0);
    float3 across = (light.direction - (dot(light.direction, view) * view));
    float side = dot((normal - (dot(normal, view) * view)), (across * rsqrt(max(dot(across, across), 1e-30))));
    return (inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow));
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float dither_blue(float value, float2 place, int levels, float spread, float size)
{
    int2 cell_1 = naga_f2i32(floor((place / (size).xx)));
    const uint _e14 = blue_index(cell_1);
    return ((((value - 0.0) - 0.5) >= (((float(((BLUE_TILE[min(uint(_e14), 255u)] >> (8u * (asuint(cell_1.x) & 3u))) & 255u)) + 0.5) * 0.00390625) - 0.5)) ? 1.0 : 0.0);
}

float inner_contour_suggestive(float width_1, float limit, float softness_1, float3 tensor, float3 normal_1, float3 view_1, float3x3 camera_from_world, float3 place_1, float2 viewport)
{
    float3 n = mul(normal_1, camera_from_world);
    float square = dot(n.xy, n.xy);
    float radial = (((((tensor.x * n.x) * n.x) + (((2.0 * tensor.y) * n.x) * n.y)) + ((tensor.z * n.y) * n.y)) / max(square, 1e-6));
    float _e35 = ddx(radial);
    float _e36 = ddy(radial);
    float2 change = float2(_e35, _e36);
    float3 v_1 = mul(view_1, camera_from_world);
    float3 row = ddy(place_1);
    float up = (((row - (dot(row, v_1) * v_1)).y >= 0.0) ? 1.0 : -1.0);
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = (-(((change.x * n.x) + ((up * change.y) * n.y))) * rsqrt(max(square, 1e-6)));
    float pixels = ((1.5 * height) / 1000.0);
    float distance_ = (abs(radial) / max(length(change), 1e-6));
    float x_3 = ((toward_eye * height) * 0.05);
    const float _e79 = footprint_of(x_3);
    float strength = clamp((0.5 + ((x_3 - limit) / length(float2(min(_e79, 1000000000000000.0), (limit * softness_1))))), 0.0, 1.0);
    return ((clamp(((pixels + 0.5) - distance_), 0.0, min(pixels, 1.0)) * strength) * smoothstep(0.05, 0.3, dot(normal_1, view_1)));
}

float4 shade(Surface surface)
{
    float3 _e5 = look.key.direction;
    float3 _e14 = look.key.direction;
    Angle turned_from_the_key = ConstructAngle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    const float _e22 = profile_balanced(turned_from_the_key, 0.0, tone_shape);
    const float _e27 = dither_blue(_e22, surface.pixel, int(2), 1.0, 2.0);
    Light _e30 = look.back;
    const float _e36 = rim(_e30, surface.normal, surface.view, 0.34, 0.0, 1.0);
    float both_lights = max(_e27, _e36);
    float3x3 _e46 = look.camera_from_world;
    float2 _e50 = look.viewport;
    const float _e51 = inner_contour_suggestive(3.0, 20.0, 0.1, surface.curvature_tensor, surface.normal, surface.view, _e46, surface.position_camera, _e50);
    float lines_cut_out = min(both_lights, (1.0 - _e51));
    const float4 _e67 = blend_alpha(float4(0.1333, 0.1216, 0.2, 1.0), float4(0.9373, 0.902, 0.8118, 1.0), lines_cut_out, 1.0, true);
    return _e67;
}

Varyings ConstructVaryings(float4 arg0, float3 arg1, float3 arg2) {
    Varyings ret = (Varyings)0;
    ret.clip_ = arg0;
    ret.position = arg1;
    ret.normal = arg2;
    return ret;
}

VertexOutput_vs_main vs_main(Vertex vertex)
{
    float4x4 _e3 = object.world_from_object;
    float4 world = mul(float4(vertex.position, 1.0), _e3);
    float4x4 _e10 = view_2.clip_from_world;
    float3x3 _e15 = object.world_from_normal;
    const Varyings varyings = ConstructVaryings(mul(world, _e10), world.xyz, mul(vertex.normal, _e15));
    const VertexOutput_vs_main varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float2 arg4) {
    Surface ret = (Surface)0;
    ret.normal = arg0;
    ret.view = arg1;
    ret.position_camera = arg2;
    ret.curvature_tensor = arg3;
    ret.pixel = arg4;
    return ret;
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    Varyings in_ = { fragmentinput_fs_main.clip_1, fragmentinput_fs_main.position_1, fragmentinput_fs_main.normal_3 };
    bool is_front = fragmentinput_fs_main.is_front_1;
    const float3 _e3 = normalize_seen_balanced(in_.normal);
    float3 normal_4 = (is_front ? _e3 : -(_e3));
    float4 _e8 = view_2.eye;
    float _e13 = view_2.eye.w;
    float4x4 _e20 = view_2.camera_from_world;
    float4 _e31 = curvature_tensor_map.Load(int3(naga_f2i32(in_.clip_.xy), int(0)));
    float4 _e37 = view_2.screen;
    float4 _e42 = view_2.screen;
    Surface surface_1 = ConstructSurface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), mul(float4(in_.position, 1.0), _e20).xyz, _e31.xyz, ((in_.clip_.xy * _e37.xy) + _e42.zw));
    const float4 _e46 = shade(surface_1);
    return _e46;
}
