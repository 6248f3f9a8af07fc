// Oil portrait: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0, smooth_normal_1_map t1, smooth_normal_3_map t2.
// oil-portrait.json says what to put there and how to draw.

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

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_object;
    float kappa;
    float3 smooth_normal_1_;
    float3 smooth_normal_3_;
    float2 pixel;
    float3 anchor;
    float magnification;
    row_major float3x3 world_from_normal;
};

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    float2 place;
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    float3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    float2 place;
    float3 stretch;
};

/// Style of brush strokes.
struct Brush {
    /// Length of a stroke over its width.
    float aspect;
    /// Size of a stroke over that of its cell.
    float size;
    /// Scatter of strokes around the middles of their cells, 0 to 1.
    float scatter;
    /// Range of the strokes' angles, both sides together, in radians.
    float turn;
    uint seed;
    /// True if the picture's dark texels are paint; false if its opaque ones are.
    bool is_dark;
};

/// A stroke as seen at a place.
struct Brushstroke {
    /// Place in the stroke's picture, v down.
    float2 uv;
    /// Sine and cosine of the stroke's angle.
    float2 turn;
    /// Direction of the stroke: 1 forward, -1 backward.
    float way;
    /// Share of the stroke that is there, 0 to 1.
    float share;
};

struct BrushStrokes {
    /// The picture's own color, opaque; of bristles how light their paint lies, to multiply a
    /// color by; black where no stroke is.
    float4 color;
    /// How much of the canvas is covered, from 0 to 1.
    float ink;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    float2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    float3 stretch;
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
static const float MOST_ON_SCREEN = 1000000000000000.0;
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

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);
Texture2D<float4> smooth_normal_1_map : register(t1);
Texture2D<float4> smooth_normal_3_map : register(t2);

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_5 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_6 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

/// v with 0 for each component that is NaN or infinite.
float4 finite_vec4(float4 v)
{
    uint4 exponent = (2139095040u).xxxx;
    return choose((asuint(v) & exponent) != exponent, v, (0.0).xxxx);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float whole = round(x);
    float f = x - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x)
{
    uint bits = asuint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = asint(bits - 1060439283u) >> 23u;
    float mantissa = asfloat(bits - (asuint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
float2 sin_cos_eighth(float x)
{
    float s = x * 0.9088517;
    return float2(s, 0.73168886);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
float3 normalize_seen(float3 v)
{
    return normalize_moderate(v, float3(0.0, 0.0, 1.0));
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

/// [`bounded`], component by component.
float3 bounded_vec3(float3 v)
{
    uint3 bits = asuint(v);
    uint3 magnitude = bits & (2147483647u).xxx;
    float3 largest = asfloat((bits & (2147483648u).xxx) | (2139095039u).xxx);
    const float3 numbers = choose(magnitude == (2139095040u).xxx, largest, (0.0).xxx);
    return choose(magnitude < (2139095040u).xxx, v, numbers);
}

/// [`bounded`], component by component.
float4 bounded_vec4(float4 v)
{
    uint4 bits = asuint(v);
    uint4 magnitude = bits & (2147483647u).xxxx;
    float4 largest = asfloat((bits & (2147483648u).xxxx) | (2139095039u).xxxx);
    const float4 numbers = choose(magnitude == (2139095040u).xxxx, largest, (0.0).xxxx);
    return choose(magnitude < (2139095040u).xxxx, v, numbers);
}

/// [`mixed`], component by component.
float4 mixed_vec4(float4 a, float4 b, float t)
{
    const float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(float x, float low, float high)
{
    float span = high - low;
    if (abs(span) < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
float4 color_mixed(float4 a, float3 blended, float factor)
{
    const float3 b = bounded_vec3(blended);
    return float4(bounded_vec3(b - 0.0 * bounded_vec3(b - a.xyz)), 1.0);
}

/// Premultiplied RGBA of a straight color.
float4 premultiplied(float4 color)
{
    return float4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
float4 straight(float4 composite)
{
    if (composite.w <= 0.0) {
        return composite;
    }
    return float4(composite.xyz / (composite.w).xxx, composite.w);
}

/// Mix colors
///
/// Lays one color on another as paint programs do. For a stack of shading layers take Blend, which
/// knows tones and transparency.
float4 mix_colors_normal(float4 a, float4 b, float factor)
{
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), clamp(factor, 0.0, 1.0));
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
float3x3 axes_around(float3 toward, float3 up)
{
    float3 z = toward * rsqrt(dot(toward, toward));
    float3 leaning = cross(up, z);
    float square = dot(leaning, leaning);
    float3 aside = abs(z.x) > 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0);
    float3 across = square > 1e-8 ? leaning : cross(aside, z);
    const float3 x = normalize_moderate(across - dot(across, z) * z, float3(1.0, 0.0, 0.0));
    return float3x3(x, cross(z, x), z);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
float4 output(float4 color)
{
    return finite_vec4(straight(color));
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
uint3 hash_pcg3d(uint3 seed)
{
    uint3 v = (uint3)0;

    v = seed * 1664525u + (1013904223u).xxx;
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> (16u).xxx);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
float3 unit_of_hash(uint3 hash)
{
    return float3(hash >> (8u).xxx) * 5.9604645e-8;
}

/// The hash of a lattice point.
uint3 lattice_hash(int3 cell, uint seed)
{
    return hash_pcg3d(asuint(cell) + seed * uint3(2654435769u, 2246822507u, 3266489909u));
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale)
{
    // Clip space is 2 high.
    return min(0.5 * scale / lerp(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
float3 anchor_on_screen(float3 origin, float perspective, float scale)
{
    const float size = size_on_screen(-origin.z, perspective, scale);
    return clamp(float3(origin.x * size, -origin.y * size, size), (-1000000000000000.0).xxx,
        (1000000000000000.0).xxx);
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = pixel - 0.5 * viewport;
    return float2(from_middle.x, -from_middle.y) / (max(viewport.y, 1.0)).xx;
}

/// Index of the number of the repeating tile that holds a cell's rank.
uint blue_index(int2 cell)
{
    uint2 at = asuint(cell) & (31u).xx;
    return 8u * at.y + (at.x >> 2u);
}

StretchedPlace ConstructStretchedPlace(float2 place, float3 stretch) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    float2 turn = float2(0.0, 1.0);
    const float3 x = bounded_vec3(turn.y * along + turn.x * across);
    const float3 y = bounded_vec3(turn.y * across - turn.x * along);
    float2 turned = float2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x
        * place.x);
    float3 most = (1000000000000000.0).xxx;
    float3 stretch = clamp(float3(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return ConstructStretchedPlace(turned, stretch);
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of_2(float2 place, float3 along, float3 across, float angle)
{
    float2 turn = clamp(sin_cos_eighth(0.75), (-1.0).xx, (1.0).xx);
    float3 x = turn.y * along + turn.x * across;
    float3 y = turn.y * across - turn.x * along;
    float2 turned = float2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x
        * place.x);
    float3 stretch = float3(dot(x, x), dot(x, y), dot(y, y));
    return ConstructStretchedPlace(turned, stretch);
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
float3 gradient_on_picture(float3 g, float3 normal, float3 view)
{
    float facing = dot(normal, view);
    return g - normal * (dot(g, view) / (facing >= 0.0 ? max(facing, 0.125) : min(facing, -0.125)));
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
StretchedPlace place_on_surface(float2 place, float3 along, float3 across, float3 normal,
    float3 view, float magnification, float angle)
{
    float height = 1.0 / clamp(magnification, 1e-15, 1000000000000000.0);
    const float3 x = bounded_vec3(gradient_on_picture(along, normal, view) * height);
    const float3 y = bounded_vec3(gradient_on_picture(across, normal, view) * height);
    return mark_place_of(place, x, y, angle);
}

/// A place on a surface for strokes across an axis of the object.
StretchedPlace place_across(float3 axis, float3 position, float3x3 world_from_normal, float3 normal,
    float3 view, float magnification, float angle)
{
    const float3x3 axes = axes_around(axis, float3(0.0, 1.0, 0.0));
    float2 place = float2(dot(position, axes[0]), dot(position, axes[2]));
    float3 along = mul(axes[0], world_from_normal);
    float3 across = mul(axes[2], world_from_normal);
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

SpacedPlace ConstructSpacedPlace(float2 place, float3 stretch) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(float2 place, float3 stretch, float2 viewport, float count)
{
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / max(viewport.y, 1.0) : count;
    float2 p = clamp(place * scale, (-4194304.0).xx, (4194304.0).xx);
    float3 s = clamp(bounded_vec3(stretch), (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    return ConstructSpacedPlace(p, is_pixel ? float3(1.0, 0.0, 1.0) : s);
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced_2(float2 place, float3 stretch, float2 viewport, float count)
{
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / max(viewport.y, 1.0) : count;
    float2 p = clamp(place * scale, (-4194304.0).xx, (4194304.0).xx);
    return ConstructSpacedPlace(p, is_pixel ? float3(1.0, 0.0, 1.0) : stretch);
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
float area_square(float3 stretch)
{
    float sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

/// A step on the canvas as a step in a stroke's picture.
float2 brush_turned(float2 step_, Brushstroke stroke, Brush style)
{
    float2 turned = float2(stroke.turn.y * step_.x + stroke.turn.x * step_.y, stroke.turn.y
        * step_.y - stroke.turn.x * step_.x);
    return turned * float2(stroke.way / (style.size * style.aspect), -1.0 / style.size);
}

Brushstroke ConstructBrushstroke(float2 uv, float2 turn, float way, float share) {
    Brushstroke ret = (Brushstroke)0;
    ret.uv = uv;
    ret.turn = turn;
    ret.way = way;
    ret.share = share;
    return ret;
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
Brushstroke brush_stroke(float2 p, int2 cell, int zoom, float drawn, Brush style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(2654435769u, 2246822507u, 3266489909u));
    float3 chance = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float2 offset = p - (float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx));
    float x = 0.5 * (chance.z - 0.5);
    float2 turn = float2(sin(x), cos(x));
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(1013904242u, 198677718u, 2238012522u));
    float way = (float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8).x < 0.5 ? 1.0 : -1.0;
    Brushstroke stroke = ConstructBrushstroke((0.5).xx, turn, way, 0.0);
    float2 uv = (0.5).xx + brush_turned(offset * float2(style.aspect, 1.0), stroke, style);
    float2 from_edge = min(uv, (1.0).xx - uv);
    float inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    float share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return ConstructBrushstroke(uv, turn, way, share);
}

/// Three random numbers of a bristle, 0 to 1; across a stroke they go over smoothly into those of
/// the next bristle.
float3 bristle(float row, uint seed)
{
    float first = floor(row);
    float t = row - first;
    const float3 a = unit_of_hash(lattice_hash(int3(to_int(first), int(0), int(0)), seed));
    const float3 b = unit_of_hash(lattice_hash(int3(asint(asuint(to_int(first)) + asuint(int(1))),
        int(0), int(0)), seed));
    return lerp(a, b, t * t * (3.0 - 2.0 * t));
}

/// A stroke of a stiff brush at the place `uv` in it: lightness of its paint in x, coverage in y.
/// `width` is a pixel's share of the stroke's width.
float2 bristles(float2 uv, float width, uint seed)
{
    float across = 2.0 * uv.y - 1.0;
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(int(0), int(1), int(0))) + seed
        * uint3(2654435769u, 2246822507u, 3266489909u));
    float3 own = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float seen = clamp(1.75 - 11.0 * width, 0.0, 1.0);
    float3 chance = lerp((0.5).xxx, bristle(11.0 * uv.y, seed), seen);
    float start = 0.03 + 0.12 * chance.x + 0.09 * across * across;
    float end = 0.97 - (0.1 + 0.25 * own.y) * chance.y - 0.12 * across * across;
    float along = eased(uv.x, start, start + 0.05) * (1.0 - eased(uv.x, end - 0.1, end));
    float side = 1.0 - smoothstep(0.78, 0.95, abs(across));
    float dry = smoothstep(0.85, 1.25, uv.x + 0.55 * chance.z);
    float shade = 0.8 + 0.16 * own.z + 0.208 * (chance.z - 0.5) - 0.05 * uv.x;
    return float2(clamp(shade, 0.0, 1.0), along * side * (1.0 - 0.9 * dry));
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = rhs + (1 - rhs) * int2((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0));
    return lhs - lhs / divisor * divisor;
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - lhs / divisor * divisor;
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
float2 bristles_laid(SpacedPlace at, float ink, Brush style)
{
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    for (int octave = 0; octave < 2; octave++) {
        float amount = ink * (octave == int(1) ? fine : 1.0 - f);
        float scale = asfloat(uint(asint(asuint(asint(asuint(to_int(zoom)) + asuint(octave)))
            + asuint(int(127)))) << 23u);
        float2 p = clamp(at.place * scale, (-4194304.0).xx, (4194304.0).xx)
            / float2(style.aspect, 1.0);
        int2 corner = to_int(floor(p));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)),
            (int(3)).xx);
        for (int i = 0; i < 9; i++) {
            int2 cell = asint(asuint(asint(asuint(corner)
                + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(i, int(3)),
                naga_div(i, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx))))
                - asuint((int(1)).xx));
            int2 turning = asint(asuint(cell)
                + asuint(int2(int(1), asint(asuint(int(7))
                * asuint(asint(asuint(to_int(zoom)) + asuint(octave)))))));
            uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
            float late = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
                + 0.5) * 0.00390625);
            float share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share <= 0.0) {
                continue;
            }
            const Brushstroke stroke = brush_stroke(p, cell,
                asint(asuint(to_int(zoom)) + asuint(octave)), share, style);
            if (stroke.share > 0.0) {
                const float2 gx = brush_turned(dx * scale, stroke, style);
                const float2 gy = brush_turned(dy * scale, stroke, style);
                const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell,
                    asint(asuint(to_int(zoom)) + asuint(octave))))
                    + uint3(3668340011u, 2445500225u, 1209535135u));
                uint own = hash_pcg3d_value.x;
                const float2 drawn = bristles(stroke.uv, length(float2(gx.y, gy.y)), own);
                float cover = stroke.share * drawn.y;
                paint = float2(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// A step on the canvas as a step in a stroke's picture.
float2 brush_turned_2(float2 step_, Brushstroke stroke, Brush style)
{
    float2 turned = float2(stroke.turn.y * step_.x + stroke.turn.x * step_.y, stroke.turn.y
        * step_.y - stroke.turn.x * step_.x);
    return turned * float2(stroke.way / (1.5 * style.aspect), -0.6666667);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
Brushstroke brush_stroke_2(float2 p, int2 cell, int zoom, float drawn, Brush style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(3041712726u, 596033154u, 2419070270u));
    float3 chance = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float2 offset = p - (float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx));
    float x = 0.5 * (chance.z - 0.5);
    float2 turn = float2(sin(x), cos(x));
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(1401181199u, 2842855661u, 1390592883u));
    float way = (float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8).x < 0.5 ? 1.0 : -1.0;
    Brushstroke stroke = ConstructBrushstroke((0.5).xx, turn, way, 0.0);
    float2 uv = (0.5).xx + brush_turned_2(offset * float2(style.aspect, 1.0), stroke, style);
    float2 from_edge = min(uv, (1.0).xx - uv);
    float inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    float share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return ConstructBrushstroke(uv, turn, way, share);
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
float2 bristles_laid_2(SpacedPlace at, float ink, Brush style)
{
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    for (int octave = 0; octave < 2; octave++) {
        float amount = ink * (octave == int(1) ? fine : 1.0 - f);
        float scale = asfloat(uint(asint(asuint(asint(asuint(to_int(zoom)) + asuint(octave)))
            + asuint(int(127)))) << 23u);
        float2 p = clamp(at.place * scale, (-4194304.0).xx, (4194304.0).xx)
            / float2(style.aspect, 1.0);
        int2 corner = to_int(floor(p));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)),
            (int(3)).xx);
        for (int i = 0; i < 9; i++) {
            int2 cell = asint(asuint(asint(asuint(corner)
                + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(i, int(3)),
                naga_div(i, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx))))
                - asuint((int(1)).xx));
            int2 turning = asint(asuint(cell)
                + asuint(int2(int(6), asint(asuint(int(7))
                * asuint(asint(asuint(to_int(zoom)) + asuint(octave)))))));
            uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
            float late = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
                + 0.5) * 0.00390625);
            float share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share <= 0.0) {
                continue;
            }
            const Brushstroke stroke = brush_stroke_2(p, cell,
                asint(asuint(to_int(zoom)) + asuint(octave)), share, style);
            if (stroke.share > 0.0) {
                const float2 gx = brush_turned_2(dx * scale, stroke, style);
                const float2 gy = brush_turned_2(dy * scale, stroke, style);
                const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell,
                    asint(asuint(to_int(zoom)) + asuint(octave))))
                    + uint3(4055616968u, 794710872u, 362115496u));
                uint own = hash_pcg3d_value.x;
                const float2 drawn = bristles(stroke.uv, length(float2(gx.y, gy.y)), own);
                float cover = stroke.share * drawn.y;
                paint = float2(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
Brushstroke brush_stroke_3(float2 p, int2 cell, int zoom, float drawn, Brush style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(1013904242u, 198677718u, 2238012522u));
    float3 chance = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float2 offset = p - (float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx));
    float x = 0.5 * (chance.z - 0.5);
    float2 turn = float2(sin(x), cos(x));
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(3668340011u, 2445500225u, 1209535135u));
    float way = (float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8).x < 0.5 ? 1.0 : -1.0;
    Brushstroke stroke = ConstructBrushstroke((0.5).xx, turn, way, 0.0);
    float2 uv = (0.5).xx + brush_turned(offset * float2(style.aspect, 1.0), stroke, style);
    float2 from_edge = min(uv, (1.0).xx - uv);
    float inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    float share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return ConstructBrushstroke(uv, turn, way, share);
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
float2 bristles_laid_3(SpacedPlace at, float ink, Brush style)
{
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    for (int octave = 0; octave < 2; octave++) {
        float amount = ink * (octave == int(1) ? fine : 1.0 - f);
        float scale = asfloat(uint(asint(asuint(asint(asuint(to_int(zoom)) + asuint(octave)))
            + asuint(int(127)))) << 23u);
        float2 p = clamp(at.place * scale, (-4194304.0).xx, (4194304.0).xx)
            / float2(style.aspect, 1.0);
        int2 corner = to_int(floor(p));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)),
            (int(3)).xx);
        for (int i = 0; i < 9; i++) {
            int2 cell = asint(asuint(asint(asuint(corner)
                + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(i, int(3)),
                naga_div(i, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx))))
                - asuint((int(1)).xx));
            int2 turning = asint(asuint(cell)
                + asuint(int2(int(2), asint(asuint(int(7))
                * asuint(asint(asuint(to_int(zoom)) + asuint(octave)))))));
            uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
            float late = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
                + 0.5) * 0.00390625);
            float share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share <= 0.0) {
                continue;
            }
            const Brushstroke stroke = brush_stroke_3(p, cell,
                asint(asuint(to_int(zoom)) + asuint(octave)), share, style);
            if (stroke.share > 0.0) {
                const float2 gx = brush_turned(dx * scale, stroke, style);
                const float2 gy = brush_turned(dy * scale, stroke, style);
                const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell,
                    asint(asuint(to_int(zoom)) + asuint(octave))))
                    + uint3(2027808484u, 397355436u, 181057748u));
                uint own = hash_pcg3d_value.x;
                const float2 drawn = bristles(stroke.uv, length(float2(gx.y, gy.y)), own);
                float cover = stroke.share * drawn.y;
                paint = float2(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// A step on the canvas as a step in a stroke's picture.
float2 brush_turned_3(float2 step_, Brushstroke stroke, Brush style)
{
    float2 turned = float2(stroke.turn.y * step_.x + stroke.turn.x * step_.y, stroke.turn.y
        * step_.y - stroke.turn.x * step_.x);
    return turned * float2(stroke.way / 4.5, -0.6666667);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
Brushstroke brush_stroke_4(float2 p, int2 cell, int zoom, float drawn, Brush style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(3668340011u, 2445500225u, 1209535135u));
    float3 chance = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float2 offset = p - (float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx));
    float x = 0.5 * (chance.z - 0.5);
    float2 turn = float2(sin(x), cos(x));
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(2027808484u, 397355436u, 181057748u));
    float way = (float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8).x < 0.5 ? 1.0 : -1.0;
    Brushstroke stroke = ConstructBrushstroke((0.5).xx, turn, way, 0.0);
    float2 uv = (0.5).xx + brush_turned_3(offset * float2(3.0, 1.0), stroke, style);
    float2 from_edge = min(uv, (1.0).xx - uv);
    float inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    float share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return ConstructBrushstroke(uv, turn, way, share);
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
float2 bristles_laid_4(SpacedPlace at, float ink, Brush style)
{
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    for (int octave = 0; octave < 2; octave++) {
        float amount = ink * (octave == int(1) ? fine : 1.0 - f);
        float scale = asfloat(uint(asint(asuint(asint(asuint(to_int(zoom)) + asuint(octave)))
            + asuint(int(127)))) << 23u);
        float2 p = clamp(at.place * scale, (-4194304.0).xx, (4194304.0).xx) / float2(3.0, 1.0);
        int2 corner = to_int(floor(p));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)),
            (int(3)).xx);
        for (int i = 0; i < 9; i++) {
            int2 cell = asint(asuint(asint(asuint(corner)
                + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(i, int(3)),
                naga_div(i, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx))))
                - asuint((int(1)).xx));
            int2 turning = asint(asuint(cell)
                + asuint(int2(int(3), asint(asuint(int(7))
                * asuint(asint(asuint(to_int(zoom)) + asuint(octave)))))));
            uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
            float late = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
                + 0.5) * 0.00390625);
            float share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share <= 0.0) {
                continue;
            }
            const Brushstroke stroke = brush_stroke_4(p, cell,
                asint(asuint(to_int(zoom)) + asuint(octave)), share, style);
            if (stroke.share > 0.0) {
                const float2 gx = brush_turned_3(dx * scale, stroke, style);
                const float2 gy = brush_turned_3(dy * scale, stroke, style);
                const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell,
                    asint(asuint(to_int(zoom)) + asuint(octave))))
                    + uint3(387276957u, 2644177943u, 3447547657u));
                uint own = hash_pcg3d_value.x;
                const float2 drawn = bristles(stroke.uv, length(float2(gx.y, gy.y)), own);
                float cover = stroke.share * drawn.y;
                paint = float2(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
Brushstroke brush_stroke_5(float2 p, int2 cell, int zoom, float drawn, Brush style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(2027808484u, 397355436u, 181057748u));
    float3 chance = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float2 offset = p - (float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx));
    float x = style.turn * (chance.z - 0.5);
    float2 turn = float2(sin(x), cos(x));
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(387276957u, 2644177943u, 3447547657u));
    float way = (float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8).x < 0.5 ? 1.0 : -1.0;
    Brushstroke stroke = ConstructBrushstroke((0.5).xx, turn, way, 0.0);
    float2 uv = (0.5).xx + brush_turned(offset * float2(style.aspect, 1.0), stroke, style);
    float2 from_edge = min(uv, (1.0).xx - uv);
    float inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    float share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return ConstructBrushstroke(uv, turn, way, share);
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
float2 bristles_laid_5(SpacedPlace at, float ink, Brush style)
{
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    for (int octave = 0; octave < 2; octave++) {
        float amount = ink * (octave == int(1) ? fine : 1.0 - f);
        float scale = asfloat(uint(asint(asuint(asint(asuint(to_int(zoom)) + asuint(octave)))
            + asuint(int(127)))) << 23u);
        float2 p = clamp(at.place * scale, (-4194304.0).xx, (4194304.0).xx)
            / float2(style.aspect, 1.0);
        int2 corner = to_int(floor(p));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)),
            (int(3)).xx);
        for (int i = 0; i < 9; i++) {
            int2 cell = asint(asuint(asint(asuint(corner)
                + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(i, int(3)),
                naga_div(i, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx))))
                - asuint((int(1)).xx));
            int2 turning = asint(asuint(cell)
                + asuint(int2(int(4), asint(asuint(int(7))
                * asuint(asint(asuint(to_int(zoom)) + asuint(octave)))))));
            uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
            float late = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
                + 0.5) * 0.00390625);
            float share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share <= 0.0) {
                continue;
            }
            const Brushstroke stroke = brush_stroke_5(p, cell,
                asint(asuint(to_int(zoom)) + asuint(octave)), share, style);
            if (stroke.share > 0.0) {
                const float2 gx = brush_turned(dx * scale, stroke, style);
                const float2 gy = brush_turned(dy * scale, stroke, style);
                const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell,
                    asint(asuint(to_int(zoom)) + asuint(octave))))
                    + uint3(3041712726u, 596033154u, 2419070270u));
                uint own = hash_pcg3d_value.x;
                const float2 drawn = bristles(stroke.uv, length(float2(gx.y, gy.y)), own);
                float cover = stroke.share * drawn.y;
                paint = float2(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
Brushstroke brush_stroke_6(float2 p, int2 cell, int zoom, float drawn, Brush style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(4055616968u, 794710872u, 362115496u));
    float3 chance = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float2 offset = p - (float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx));
    float x = style.turn * (chance.z - 0.5);
    float2 turn = float2(sin(x), cos(x));
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(cell, zoom))
        + uint3(2415085441u, 3041533379u, 3628605405u));
    float way = (float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8).x < 0.5 ? 1.0 : -1.0;
    Brushstroke stroke = ConstructBrushstroke((0.5).xx, turn, way, 0.0);
    float2 uv = (0.5).xx + brush_turned_2(offset * float2(style.aspect, 1.0), stroke, style);
    float2 from_edge = min(uv, (1.0).xx - uv);
    float inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    float far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    float share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return ConstructBrushstroke(uv, turn, way, share);
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
float2 bristles_laid_6(SpacedPlace at, float ink, Brush style)
{
    float2 paint = (0.0).xx;
    uint tile[256] = BLUE_TILE;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    for (int octave = 0; octave < 2; octave++) {
        float amount = ink * (octave == int(1) ? fine : 1.0 - f);
        float scale = asfloat(uint(asint(asuint(asint(asuint(to_int(zoom)) + asuint(octave)))
            + asuint(int(127)))) << 23u);
        float2 p = clamp(at.place * scale, (-4194304.0).xx, (4194304.0).xx)
            / float2(style.aspect, 1.0);
        int2 corner = to_int(floor(p));
        int2 phase = naga_mod(asint(asuint(naga_mod(corner, (int(3)).xx)) + asuint((int(3)).xx)),
            (int(3)).xx);
        for (int i = 0; i < 9; i++) {
            int2 cell = asint(asuint(asint(asuint(corner)
                + asuint(naga_mod(asint(asuint(asint(asuint(int2(naga_mod(i, int(3)),
                naga_div(i, int(3)))) - asuint(phase))) + asuint((int(4)).xx)), (int(3)).xx))))
                - asuint((int(1)).xx));
            int2 turning = asint(asuint(cell)
                + asuint(int2(int(8), asint(asuint(int(7))
                * asuint(asint(asuint(to_int(zoom)) + asuint(octave)))))));
            uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
            float late = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
                + 0.5) * 0.00390625);
            float share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if (share <= 0.0) {
                continue;
            }
            const Brushstroke stroke = brush_stroke_6(p, cell,
                asint(asuint(to_int(zoom)) + asuint(octave)), share, style);
            if (stroke.share > 0.0) {
                const float2 gx = brush_turned_2(dx * scale, stroke, style);
                const float2 gy = brush_turned_2(dy * scale, stroke, style);
                const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(cell,
                    asint(asuint(to_int(zoom)) + asuint(octave))))
                    + uint3(774553914u, 993388590u, 2600128018u));
                uint own = hash_pcg3d_value.x;
                const float2 drawn = bristles(stroke.uv, length(float2(gx.y, gy.y)), own);
                float cover = stroke.share * drawn.y;
                paint = float2(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
        }
    }
    return paint;
}

Brush ConstructBrush(float aspect, float size, float scatter, float turn, uint seed, bool is_dark) {
    Brush ret = (Brush)0;
    ret.aspect = aspect;
    ret.size = size;
    ret.scatter = scatter;
    ret.turn = turn;
    ret.seed = seed;
    ret.is_dark = is_dark;
    return ret;
}

BrushStrokes ConstructBrushStrokes(float4 color, float ink) {
    BrushStrokes ret = (BrushStrokes)0;
    ret.color = color;
    ret.ink = ink;
    return ret;
}

BrushStrokes brush_strokes_bristles(float value, float2 place, float3 stretch, float count,
    float aspect, float size, float scatter, float turn, int seed, float2 viewport)
{
    const SpacedPlace at = spaced(place, stretch, viewport, count);
    Brush style = ConstructBrush(aspect, size, scatter, turn, 1u, false);
    const float2 paint = bristles_laid(at, 1.0 - value, style);
    float shade = paint.x / max(paint.y, 0.001);
    return ConstructBrushStrokes(float4(shade, shade, shade, 1.0), paint.y);
}

BrushStrokes brush_strokes_bristles_2(float value, float2 place, float3 stretch, float count,
    float aspect, float size, float scatter, float turn, int seed, float2 viewport)
{
    const SpacedPlace at = spaced(place, stretch, viewport, count);
    Brush style = ConstructBrush(aspect, size, scatter, turn, 6u, false);
    const float2 paint = bristles_laid_2(at, 1.0 - value, style);
    float shade = paint.x / max(paint.y, 0.001);
    return ConstructBrushStrokes(float4(shade, shade, shade, 1.0), paint.y);
}

BrushStrokes brush_strokes_bristles_3(float value, float2 place, float3 stretch, float count,
    float aspect, float size, float scatter, float turn, int seed, float2 viewport)
{
    const SpacedPlace at = spaced(place, stretch, viewport, count);
    Brush style = ConstructBrush(aspect, size, scatter, turn, 2u, false);
    const float2 paint = bristles_laid_3(at, 1.0 - value, style);
    float shade = paint.x / max(paint.y, 0.001);
    return ConstructBrushStrokes(float4(shade, shade, shade, 1.0), paint.y);
}

BrushStrokes brush_strokes_bristles_4(float value, float2 place, float3 stretch, float count,
    float aspect, float size, float scatter, float turn, int seed, float2 viewport)
{
    const SpacedPlace at = spaced_2(place, stretch, viewport, count);
    Brush style = ConstructBrush(aspect, size, scatter, turn, 3u, false);
    const float2 paint = bristles_laid_4(at, 1.0 - value, style);
    float shade = paint.x / max(paint.y, 0.001);
    return ConstructBrushStrokes(float4(shade, shade, shade, 1.0), paint.y);
}

BrushStrokes brush_strokes_bristles_5(float value, float2 place, float3 stretch, float count,
    float aspect, float size, float scatter, float turn, int seed, float2 viewport)
{
    const SpacedPlace at = spaced_2(place, stretch, viewport, count);
    Brush style = ConstructBrush(aspect, size, scatter, turn, 4u, false);
    const float2 paint = bristles_laid_5(at, 1.0 - value, style);
    float shade = paint.x / max(paint.y, 0.001);
    return ConstructBrushStrokes(float4(shade, shade, shade, 1.0), paint.y);
}

BrushStrokes brush_strokes_bristles_6(float value, float2 place, float3 stretch, float count,
    float aspect, float size, float scatter, float turn, int seed, float2 viewport)
{
    const SpacedPlace at = spaced(place, stretch, viewport, count);
    Brush style = ConstructBrush(aspect, size, scatter, turn, 8u, false);
    const float2 paint = bristles_laid_6(at, 1.0 - value, style);
    float shade = paint.x / max(paint.y, 0.001);
    return ConstructBrushStrokes(float4(shade, shade, shade, 1.0), paint.y);
}

MarkPlace ConstructMarkPlace(float2 place, float3 stretch) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

MarkPlace mark_place_axis(float3 axis, float3 normal, float angle, float3 view,
    float3 position_object, float3x3 world_from_normal, float magnification)
{
    const StretchedPlace m = place_across(axis, position_object, world_from_normal, normal, view,
        magnification, angle);
    return ConstructMarkPlace(m.place, m.stretch);
}

MarkPlace mark_place_object(float angle, float3 anchor, float2 pixel, float2 viewport)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    float2 place = (place_in_picture(pixel, viewport) - float2(anchor.x, -anchor.y)) / (size).xx;
    const StretchedPlace m = mark_place_of_2(place, float3(1.0 / size, 0.0, 0.0),
        float3(0.0, 1.0 / size, 0.0), angle);
    return ConstructMarkPlace(m.place, m.stretch);
}

float reflectance_half_lambert(Light light, float3 normal)
{
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
}

/// Map range
///
/// Moves numbers from one range to another: depth to fog, curvature to a mask. Where the first
/// range is empty, all that is below it becomes the new low and the rest the new high. A color
/// keeps its alpha, within 0 and 1 while clamped.
float map_range(float value, float from_low, float from_high, float to_low, float to_high,
    bool clamped)
{
    return lerp(to_low, to_high, clamp((value - from_low) / (from_high - from_low), 0.0, 1.0));
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const float3 planes = normalize_moderate(surface.smooth_normal_1_, surface.normal);
    const float light_and_shade = reflectance_half_lambert(look.key, planes);
    const float where_umber_goes = map_range(light_and_shade, 0.02, 0.2, 1.0, 0.0, true);
    const float3 large_forms = normalize_moderate(surface.smooth_normal_3_, surface.normal);
    const MarkPlace strokes_round_the_form = mark_place_axis(float3(0.35, 1.0, 0.25), large_forms,
        0.0, surface.view, surface.position_object, surface.world_from_normal,
        surface.magnification);
    const BrushStrokes umber = brush_strokes_bristles(where_umber_goes,
        strokes_round_the_form.place, strokes_round_the_form.stretch, 14.0, 3.4, 1.8, 0.6, 0.5,
        int(1), look.viewport);
    // Mix colors
    const float4 umber_as_paint = color_mixed(umber.color, umber.color.xyz
        * look.umber_as_paint_b.xyz, 1.0);
    // Mix colors
    const float4 umber_laid_on = mixed_vec4(look.toned_canvas, bounded_vec4(umber_as_paint),
        clamp(umber.ink, 0.0, 1.0));
    // Reflectance
    float reflected_light = max(dot(planes, look.sky.direction), 0.0);
    float where_cool_reflections_go = lerp(1.0, 0.0,
        clamp((reflected_light - 0.25) / 0.5, 0.0, 1.0));
    const BrushStrokes cool_reflections = brush_strokes_bristles_2(where_cool_reflections_go,
        strokes_round_the_form.place, strokes_round_the_form.stretch, 18.0, 3.2, 1.5, 0.6, 0.5,
        int(6), look.viewport);
    // Mix colors
    const float4 cool_reflections_as_paint = color_mixed(cool_reflections.color,
        cool_reflections.color.xyz * look.cool_reflections_as_paint_b.xyz, 1.0);
    const float4 cool_reflections_laid_on = mix_colors_normal(umber_laid_on,
        cool_reflections_as_paint, cool_reflections.ink);
    const float where_half_tones_go = map_range(light_and_shade, 0.24, 0.42, 1.0, 0.0, true);
    const BrushStrokes half_tones = brush_strokes_bristles_3(where_half_tones_go,
        strokes_round_the_form.place, strokes_round_the_form.stretch, 18.0, 3.2, 1.6, 0.6, 0.5,
        int(2), look.viewport);
    // Mix colors
    const float4 half_tones_as_paint = color_mixed(half_tones.color, half_tones.color.xyz
        * look.half_tones_as_paint_b.xyz, 1.0);
    const float4 half_tones_laid_on = mix_colors_normal(cool_reflections_laid_on,
        half_tones_as_paint, half_tones.ink);
    const float where_light_goes = map_range(light_and_shade, 0.46, 0.66, 1.0, 0.0, true);
    const MarkPlace strokes_of_the_wrist = mark_place_object(0.75, surface.anchor, surface.pixel,
        look.viewport);
    const BrushStrokes light = brush_strokes_bristles_4(where_light_goes,
        strokes_of_the_wrist.place, strokes_of_the_wrist.stretch, 24.0, 3.0, 1.5, 0.6, 0.5, int(3),
        look.viewport);
    // Mix colors
    const float4 light_as_paint = color_mixed(light.color, light.color.xyz
        * look.light_as_paint_b.xyz, 1.0);
    const float4 light_laid_on = mix_colors_normal(half_tones_laid_on, light_as_paint, light.ink);
    const float where_thick_lights_go = map_range(light_and_shade, 0.76, 0.95, 1.0, 0.0, true);
    const BrushStrokes thick_lights = brush_strokes_bristles_5(where_thick_lights_go,
        strokes_of_the_wrist.place, strokes_of_the_wrist.stretch, 32.0, 2.6, 1.3, 0.6, 0.4, int(4),
        look.viewport);
    // Mix colors
    const float4 thick_lights_as_paint = color_mixed(thick_lights.color, thick_lights.color.xyz
        * look.thick_lights_as_paint_b.xyz, 1.0);
    const float4 thick_lights_laid_on = mix_colors_normal(light_laid_on, thick_lights_as_paint,
        thick_lights.ink);
    float hollows = surface.kappa;
    float where_accents_go = lerp(1.0, 0.0, clamp((hollows + 6.0) / -14.0, 0.0, 1.0));
    const BrushStrokes accents = brush_strokes_bristles_6(where_accents_go,
        strokes_round_the_form.place, strokes_round_the_form.stretch, 44.0, 3.4, 1.5, 0.6, 0.4,
        int(8), look.viewport);
    // Mix colors
    const float4 accents_as_paint = color_mixed(accents.color, accents.color.xyz
        * look.accents_as_paint_b.xyz, 1.0);
    const float4 accents_laid_on = mix_colors_normal(thick_lights_laid_on, accents_as_paint,
        accents.ink);
    float4 output_alpha = float4(accents_laid_on.xyz, clamp(accents_laid_on.w, 0.0, 1.0));
    return output(premultiplied(output_alpha));
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 position_object, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.position_object = position_object;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        vertex.position, mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.position_object, varyings.normal,
        varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float3 position_object, float kappa,
    float3 smooth_normal_1_, float3 smooth_normal_3_, float2 pixel, float3 anchor,
    float magnification, float3x3 world_from_normal) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    ret.kappa = kappa;
    ret.smooth_normal_1_ = smooth_normal_1_;
    ret.smooth_normal_3_ = smooth_normal_3_;
    ret.pixel = pixel;
    ret.anchor = anchor;
    ret.magnification = magnification;
    ret.world_from_normal = world_from_normal;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_2, input.position_object_2, input.normal_6 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_1 = smooth_normal_1_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_2 = smooth_normal_3_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    const float3 anchor_on_screen_value = anchor_on_screen(mul(float4(object.world_from_object[3].xyz,
        1.0), view.camera_from_world).xyz, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    const float size_on_screen_value = size_on_screen(-mul(float4(in_.position, 1.0),
        view.camera_from_world).z, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, texel.x, mul(view.camera_from_world, float4(texel_1.xyz, 0.0)).xyz,
        mul(view.camera_from_world, float4(texel_2.xyz, 0.0)).xyz, in_.clip_.xy * view.screen.xy
        + view.screen.zw, anchor_on_screen_value, size_on_screen_value, object.world_from_normal);
    return finite_vec4(shade(surface));
}
