// One bit: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_tensor_map t0.
// one-bit.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    float4 screen;
};

struct Object {
    row_major float4x4 world_from_object;
    /// The inverse transpose, for normals.
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    float3 direction;
    int _pad1_0;
    /// Unit, toward the light, in the light's own frame.
    float3 own_direction;
    int _pad2_0;
    /// Straight RGB.
    float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    row_major float3x3 camera_from_world;
    int _pad1_0;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light back;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_camera;
    float3 curvature_tensor;
    float2 pixel;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
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

static const uint BLUE_TILE[256] = {667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u,
    3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u,
    3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u,
    679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u,
    3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u,
    3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u,
    2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u,
    1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u,
    3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u,
    4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u,
    3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u,
    3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u,
    568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u,
    2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u,
    3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u,
    3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u,
    3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u,
    1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u,
    131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u,
    243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u,
    987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u,
    3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u,
    2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u,
    1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u,
    73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u,
    2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u,
    1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u,
    1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u,
    4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u,
    3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u,
    1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u,
    3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u,
    2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u,
    2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u,
    2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u,
    143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u,
    398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u};
static const ProfileShape tone_shape = {0.99875027, 0.04997917, 1.229384, 1.5428282, 0.1, 1.0145569,
    0.43140125, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, float2 t)
{
    float s = u.half_sin - 0.0;
    float2 upper = u.half_cos <= 0.0 ? float2(1.0, 0.0) : float2(s, u.half_cos);
    float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    const float point_ = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point_;
    }
    float r = 0.19364917 * w;
    float2 turn = float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    const float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    const float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Index of the number of the repeating tile that holds a cell's rank.
uint blue_index(int2 cell)
{
    uint2 at = asuint(cell) & (31u).xx;
    return 8u * at.y + (at.x >> 2u);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = min(footprint_of_2(facing), 1.0);
    float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / max(edge, 1e-6) + 0.5;
    float inside = clamp(within, 0.0, 1.0);
    float3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * rsqrt(max(dot(across, across), 1e-30)));
    return inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow);
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

/// Dither
///
/// Cuts a tone into few flat ones and lets single pixels decide between two of them, so that the
/// average stays: pixel art, woodcut grain, bands whose edges are sprinkled. Bayer's matrices make
/// a regular weave; blue noise has neither a pattern nor clumps; white noise is chance.
float dither_blue(float value, float2 place, int levels, float spread, float size)
{
    int2 cell = to_int(floor(place / (size).xx));
    const uint blue_index_value = blue_index(cell);
    return value - 0.0 - 0.5 >= (float((BLUE_TILE[min(uint(blue_index_value), 255u)]
        >> (8u * (asuint(cell.x) & 3u))) & 255u) + 0.5) * 0.00390625 - 0.5 ? 1.0 : 0.0;
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(float width, float limit, float softness, float3 tensor,
    float3 normal, float3 view, float3x3 camera_from_world, float3 place, float2 viewport)
{
    float3 n = mul(normal, camera_from_world);
    float square = dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    float2 change = float2(ddx(radial), ddy(radial));
    float3 v = mul(view, camera_from_world);
    float3 row = ddy(place);
    float up = (row - dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y) * rsqrt(max(square, 1e-6));
    float pixels = 1.5 * height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    const float footprint_of_value = footprint_of(x);
    float strength = clamp(0.5 + (x - limit)
        / length(float2(min(footprint_of_value, 1000000000000000.0), limit * softness)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Parametrization
    Angle turned_from_the_key = ConstructAngle(0.5 * length(surface.normal - look.key.direction),
        0.5 * length(surface.normal + look.key.direction));
    const float tone = profile_balanced(turned_from_the_key, 0.0, tone_shape);
    const float spray = dither_blue(tone, surface.pixel, int(2), 1.0, 2.0);
    const float edge_of_light = rim(look.back, surface.normal, surface.view, 0.34, 0.0, 1.0);
    // Combine tones
    float both_lights = max(spray, edge_of_light);
    const float line_ = inner_contour_suggestive(3.0, 20.0, 0.1, surface.curvature_tensor,
        surface.normal, surface.view, look.camera_from_world, surface.position_camera,
        look.viewport);
    // Combine tones
    float lines_cut_out = min(both_lights, 1.0 - line_);
    const float4 light = blend_alpha(float4(0.1333, 0.1216, 0.2, 1.0),
        float4(0.9373, 0.902, 0.8118, 1.0), lines_cut_out, 1.0, true);
    return light;
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float3 position_camera,
    float3 curvature_tensor, float2 pixel) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_camera = position_camera;
    ret.curvature_tensor = curvature_tensor;
    ret.pixel = pixel;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        mul(float4(in_.position, 1.0), view.camera_from_world).xyz, texel.xyz, in_.clip_.xy
        * view.screen.xy + view.screen.zw);
    return shade(surface);
}
