// Botanical plate: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// botanical-plate.json says what to put there and how to draw.

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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_object;
    float kappa;
    float2 pixel;
    float3 anchor;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    float4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    float4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
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

/// Style of dots.
struct Dots {
    /// Diameter of a dot, in spacings.
    float size;
    /// Scatter of dots around the middles of their cells, 0 to 1.
    float scatter;
    uint seed;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    float2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    float3 stretch;
};

struct VectorParts {
    /// The first number.
    float x;
    /// The second number.
    float y;
    /// The third number.
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

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const uint NOISE_PERLIN = 1u;
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
static const Ramp leaf_to_bloom = {{float4(0.4353, 0.5412, 0.2353, 1.0),
    float4(0.6235, 0.7098, 0.3961, 1.0), float4(0.9098, 0.7255, 0.6275, 1.0),
    float4(0.8471, 0.3765, 0.4784, 1.0), float4(0.6588, 0.2275, 0.4, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx}, {float4(0.0, 0.35, 0.6, 0.85), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx},
    5u, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_1 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_2 : LOC2;
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

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// [`mixed`], component by component.
float3 mixed_vec3(float3 a, float3 b, float t)
{
    float3 d = b - a;
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// [`mixed`], component by component.
float4 mixed_vec4(float4 a, float4 b, float t)
{
    const float4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased_2(float x, float low, float high)
{
    float t = clamp(bounded((bounded(x) - low) / 0.75), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased_3(float x, float low, float high)
{
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(float3 v)
{
    float3 dx = ddx(v);
    float3 dy = ddy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
float4 hermite(float4 a, float4 b, float4 from_a, float4 to_b, float t)
{
    float4 d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// [`ramp_slope`] of one component.
float harmonic_slope(float before, float span_before, float after, float span_after)
{
    if (before * after <= 0.0) {
        return 0.0;
    }
    float weight_before = 2.0 * span_after + span_before;
    float weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
float4 ramp_slope(float4 rise_before, float span_before, float4 rise_after, float span_after)
{
    const float divided_value = divided(rise_after.x, span_after);
    const float divided_value_1 = divided(rise_after.y, span_after);
    const float harmonic_slope_value = harmonic_slope(divided(rise_before.y, span_before),
        span_before, divided_value_1, span_after);
    const float divided_value_2 = divided(rise_after.z, span_after);
    const float harmonic_slope_value_1 = harmonic_slope(divided(rise_before.z, span_before),
        span_before, divided_value_2, span_after);
    const float divided_value_3 = divided(rise_after.w, span_after);
    const float harmonic_slope_value_2 = harmonic_slope(divided(rise_before.w, span_before),
        span_before, divided_value_3, span_after);
    return float4(harmonic_slope(divided(rise_before.x, span_before), span_before, divided_value,
        span_after), harmonic_slope_value, harmonic_slope_value_1, harmonic_slope_value_2);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / max(rhs, 1u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
float4 ramp_at(Ramp ramp, float x, float w)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    uint at = 0u;
    float4 from_a = (0.0).xxxx;
    float4 to_b = (0.0).xxxx;

    colors = ramp.colors;
    places = ramp.places;
    for (uint i_2 = 1u; i_2 < 5u; i_2++) {
        float places_now = places[min(uint(naga_div(i_2, 4u)), 3u)][min(uint(naga_mod(i_2, 4u)),
            3u)];
        at = places_now <= x ? i_2 : at;
    }
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    if ((at + 1u >= 5u) | (x <= place)) {
        return colors[min(uint(at), 15u)];
    }
    uint after = at + 1u;
    float span = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)]
        - place;
    float t = clamp(divided(x - place, span), 0.0, 1.0);
    if (at > 0u) {
        float before = places[min(uint(naga_div(at - 1u, 4u)), 3u)][min(uint(naga_mod(at - 1u, 4u)),
            3u)];
        float4 colors_now = colors[min(uint(at - 1u), 15u)];
        float4 colors_now_1 = colors[min(uint(after), 15u)];
        float4 colors_now_2 = colors[min(uint(at), 15u)];
        from_a = ramp_slope(colors[min(uint(at), 15u)] - colors_now, place - before, colors_now_1
            - colors_now_2, span);
    }
    if (after + 1u < 5u) {
        float places_now_1 = places[min(uint(naga_div(after + 1u, 4u)),
            3u)][min(uint(naga_mod(after + 1u, 4u)), 3u)];
        float next = places_now_1 - (place + span);
        float4 colors_now_3 = colors[min(uint(after + 1u), 15u)];
        float4 colors_now_4 = colors[min(uint(after), 15u)];
        to_b = ramp_slope(colors[min(uint(after), 15u)] - colors[min(uint(at), 15u)], span,
            colors_now_3 - colors_now_4, next);
    }
    const float4 hermite_value = hermite(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)],
        span * from_a, span * to_b, t);
    return bounded_vec4(hermite_value);
}

float4 mix_colors_multiply(float4 a, float4 b, float factor)
{
    return float4(mixed_vec3(a.xyz, a.xyz * b.xyz, factor), 1.0);
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

/// The hash of a lattice point.
uint3 lattice_hash(int3 cell, uint seed)
{
    return hash_pcg3d(asuint(cell) + seed * uint3(2654435769u, 2246822507u, 3266489909u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
float3 fade_quintic(float3 t)
{
    return t * t * t * (t * (t * 6.0 - (15.0).xxx) + (10.0).xxx);
}

int3 to_int(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(float3 p, uint seed)
{
    float sum = 0.0;

    float3 corner = floor(p);
    float3 d = p - corner;
    const float3 f = fade_quintic(d);
    int3 cell = to_int(corner);
    for (int i = 0; i < 8; i++) {
        int3 at = int3(i & int(1), (i >> 1u) & int(1), i >> 2u);
        const float3 weight = choose(at == (int(1)).xxx, f, (1.0).xxx - f);
        const float gradient_dot_value = gradient_dot(lattice_hash(asint(asuint(cell) + asuint(at)),
            seed), d - float3(at));
        sum = sum + weight.x * weight.y * weight.z * gradient_dot_value;
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise(uint kind, float3 p, int octaves, float roughness, int seed, float w)
{
    float octave = (float)0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum = 0.0;

    for (int i = 0; i < 3; i++) {
        float visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if (visible > 0.0) {
            float3 place = clamp(p * frequency + float(i) * float3(17.31, 5.17, 11.73),
                (-4194304.0).xxx, (4194304.0).xxx);
            octave = lerp(0.5, perlin_noise(place, 0u + uint(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return min(sum / 1.75, 1.0);
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

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
float disk_filtered(float d, float r, float w)
{
    if (w < 1e-30) {
        return ((d <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    float square = r * r;
    float least = w * w / 3.0;
    float inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
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
    float3 x = turn.y * along + turn.x * across;
    float3 y = turn.y * across - turn.x * along;
    float2 turned = float2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x
        * place.x);
    float3 stretch = float3(dot(x, x), dot(x, y), dot(y, y));
    return ConstructStretchedPlace(turned, stretch);
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

/// The square of an offset's length along the picture, for an offset in the units of a stretched
/// place.
float picture_square(float2 offset, float3 stretch)
{
    float area = max(area_square(stretch), 1e-30);
    float square = stretch.z * offset.x * offset.x - 2.0 * stretch.y * offset.x * offset.y
        + stretch.x * offset.y * offset.y;
    return max(square, 0.0) / area;
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

/// The ink of one octave's dots, of which the share `ink` is drawn; `stretch` is that of a unit of
/// the octave.
float dots_of_octave(float2 place, int zoom, float ink, float3 stretch, float w, Dots style)
{
    float sum = 0.0;
    uint tile[256] = BLUE_TILE;

    float2 p = clamp(place * asfloat(uint(asint(asuint(zoom) + asuint(int(127)))) << 23u),
        (-4194304.0).xx, (4194304.0).xx);
    float2 corner = floor(p);
    float reach = 1.0 - 0.5 * style.scatter;
    for (int i = 0; i < 9; i++) {
        int2 cell = asint(asuint(to_int(corner))
            + asuint(int2(asint(asuint(naga_mod(i, int(3))) - asuint(int(1))),
            asint(asuint(naga_div(i, int(3))) - asuint(int(1))))));
        float3 chance = float3(hash_pcg3d(asuint(int3(cell, zoom)) + uint3(0u, 0u, 0u))
            >> (8u).xxx) * 5.9604645e-8;
        float2 middle = float2(cell) + (0.5).xx + style.scatter * (chance.xy - (0.5).xx);
        float2 offset = p - middle;
        int2 turning = asint(asuint(cell)
            + asuint(int2(int(0), asint(asuint(zoom) * asuint(int(7))))));
        uint tile_now = tile[min(uint(blue_index(turning)), 255u)];
        float turn = 0.96875 * ((float((tile_now >> (8u * (asuint(turning.x) & 3u))) & 255u)
            + 0.5) * 0.00390625);
        float grown = clamp((ink - turn) * 32.0, 0.0, 1.0);
        float radius = 0.5 * style.size * sqrt(grown);
        float far = length(offset) / reach;
        float d = max(sqrt(picture_square(offset, stretch)), far * far * radius);
        sum = max(sum, disk_filtered(d, radius, w));
    }
    return sum;
}

/// The ink of dots whose number, and not whose size, makes the tone.
float stippled(SpacedPlace at, float ink, Dots style)
{
    float dots = (float)0;

    float2 dx = ddx(at.place);
    float2 dy = ddy(at.place);
    const float w = bounded(sqrt(max(picture_square(dx, at.stretch),
        picture_square(dy, at.stretch))));
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    const float coarse_cells = exp2_stable(-2.0 * f);
    float coarse = 1.0 - f;
    float fine = (1.0 - coarse * coarse_cells) / (4.0 * coarse_cells);
    const float exp2_stable_value = exp2_stable(2.0 * zoom);
    dots = dots_of_octave(at.place, to_int(zoom), ink * coarse, at.stretch * exp2_stable_value, w,
        style);
    if (fine > 0.0) {
        const float exp2_stable_value_1 = exp2_stable(2.0 * zoom + 2.0);
        const float finer = dots_of_octave(at.place, asint(asuint(to_int(zoom)) + asuint(int(1))),
            ink * fine, at.stretch * exp2_stable_value_1, w, style);
        dots = max(dots, finer);
    }
    float mean = ink * (0.7853982 * style.size * style.size);
    return lerp(dots, mean, eased_2(w, 0.75, 1.5));
}

MarkPlace ConstructMarkPlace(float2 place, float3 stretch) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

MarkPlace mark_place_object(float angle, float3 anchor, float2 pixel, float2 viewport)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    float2 place = (place_in_picture(pixel, viewport) - float2(anchor.x, -anchor.y)) / (size).xx;
    const StretchedPlace m = mark_place_of(place, float3(1.0 / size, 0.0, 0.0),
        float3(0.0, 1.0 / size, 0.0), angle);
    return ConstructMarkPlace(m.place, m.stretch);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(float width, float3 normal, float3 view, float2 viewport)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = width * clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance_ = facing / max(2.0 * footprint_of(facing), 1e-6);
    float near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * near;
}

float noise_perlin(float3 position, float scale, int octaves, float roughness, int seed)
{
    float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

VectorParts ConstructVectorParts(float x, float y, float z) {
    VectorParts ret = (VectorParts)0;
    ret.x = x;
    ret.y = y;
    ret.z = z;
    return ret;
}

Dots ConstructDots(float size, float scatter, uint seed) {
    Dots ret = (Dots)0;
    ret.size = size;
    ret.scatter = scatter;
    ret.seed = seed;
    return ret;
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    float3 where_2 = surface.position_object;
    VectorParts parts = ConstructVectorParts(where_2.x, where_2.y, where_2.z);
    const float mottled = noise_perlin(surface.position_object, 4.0, int(3), 0.5, int(0));
    float height_mottled = parts.y + lerp(-0.35, 0.35, mottled - 0.0);
    float share = clamp((height_mottled + 0.9) / 1.85, 0.0, 1.0);
    const float4 leaf_to_bloom_2 = ramp_at(leaf_to_bloom, share, footprint_of(share));
    // Reflectance
    float shade_2 = max((dot(surface.normal, look.key.direction) + 0.3) / 1.3, 0.0);
    float tone = lerp(0.02, 1.0, min((shade_2 - 0.0) / 0.8, 1.0));
    float short_of_the_light = lerp(0.85, 0.12, clamp((tone - 0.55) / 0.4, 0.0, 1.0));
    const float4 wash = mix_colors_multiply(float4(0.9725, 0.949, 0.8863, 1.0), leaf_to_bloom_2,
        short_of_the_light);
    float facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    float turning_away = lerp(0.2, 1.0, clamp((facing - 0.05) / 0.55, 0.0, 1.0));
    float engraved_tone = tone * turning_away;
    const MarkPlace plate = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    const SpacedPlace spaced_value = spaced(plate.place, plate.stretch, look.viewport, 230.0);
    // Stippling
    const float stipple = stippled(spaced_value, 1.0 - min(engraved_tone, 1.0),
        ConstructDots(0.72, 0.8, 0u));
    const float contour = outer_contour(2.0, surface.normal, surface.view, look.viewport);
    float curvature = surface.kappa;
    // Curvature transition
    float hollow = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.88539 * clamp(curvature * 0.25, -20.0, 20.0))));
    const float inked_hollows = eased_3(hollow, 0.24, 0.16);
    // Combine tones
    float ink = max(max(stipple, contour), inked_hollows);
    // Mix colors
    const float4 plate_2 = mixed_vec4(bounded_vec4(wash), float4(0.1725, 0.1412, 0.1216, 1.0), ink);
    return finite_vec4(plate_2);
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
    float2 pixel, float3 anchor) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    ret.kappa = kappa;
    ret.pixel = pixel;
    ret.anchor = anchor;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_2, input.position_object_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    const float3 anchor_on_screen_value = anchor_on_screen(mul(float4(object.world_from_object[3].xyz,
        1.0), view.camera_from_world).xyz, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, texel.x, in_.clip_.xy * view.screen.xy + view.screen.zw,
        anchor_on_screen_value);
    return finite_vec4(shade(surface));
}
