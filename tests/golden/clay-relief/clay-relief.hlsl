// Clay relief: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0, curvature_tensor_map t1.
// clay-relief.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
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
    Light sky;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float kappa;
    float3 curvature_tensor;
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

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    float4 before;
    float4 after;
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    float t;
};

struct Relief {
    /// The shape index: 0 a pit, 0.25 a valley, 0.5 a saddle or flat, 0.75 a ridge, 1 a bump.
    float shape;
    /// From 0 where it is flat to 1.
    float strength;
    /// The greatest curvature of all directions, in 1/viewport-height.
    float greatest;
    /// The least curvature of all directions, in 1/viewport-height.
    float least;
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

static const float PI = 3.1415927;
static const float HALF_PI = 1.5707964;
static const float LOG2_E = 1.442695;
static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp terracotta = {{float4(0.2353, 0.102, 0.1098, 1.0),
    float4(0.5412, 0.251, 0.1882, 1.0), float4(0.8118, 0.498, 0.3412, 1.0),
    float4(0.949, 0.7412, 0.5725, 1.0), float4(0.9843, 0.8627, 0.7333, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx}, {float4(0.0, 0.3, 0.62, 0.9), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx},
    5u, 0u};
static const Ramp pits_to_bumps = {{float4(0.2941, 0.2275, 0.3216, 1.0),
    float4(0.4784, 0.2902, 0.2902, 1.0), float4(0.7529, 0.502, 0.3765, 1.0),
    float4(0.9412, 0.7529, 0.5804, 1.0), float4(1.0, 0.9412, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx}, {float4(0.0, 0.3, 0.5, 0.75), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx},
    5u, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);
Texture2D<float4> curvature_tensor_map : register(t1);

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

/// `accept` where the condition holds, else `reject`, component by component.
float2 choose(bool2 condition, float2 accept, float2 reject)
{
    return float2(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = round(clamped);
    float f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable_2(float x)
{
    float clamped = max(x, -126.0);
    float whole = round(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
}

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
float atan2_positive(float y, float x)
{
    float small = min(y, x);
    float large = max(y, x);
    if (large <= 0.0) {
        return 0.0;
    }
    float t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    bool is_wide = t > 0.41421357;
    float r = is_wide ? (small - large) / (small + large) : t;
    float r2 = r * r;
    float series = r * (1.0 + r2 * (-0.33333334 + r2
        * (0.2 + r2 * (-0.14285715 + r2
        * (0.11111111 + r2 * (-0.09090909 + r2
        * (0.07692308 + r2 * (-0.06666667 + r2 * 0.05882353))))))));
    float a = is_wide ? series + 0.7853982 : series;
    return y > x ? HALF_PI - a : a;
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
float2 bounded_vec2(float2 v)
{
    uint2 bits = asuint(v);
    uint2 magnitude = bits & (2147483647u).xx;
    float2 largest = asfloat((bits & (2147483648u).xx) | (2139095039u).xx);
    const float2 numbers = choose(magnitude == (2139095040u).xx, largest, (0.0).xx);
    return choose(magnitude < (2139095040u).xx, v, numbers);
}

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
float angle_of_point(float y, float x)
{
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    float2 p = abs(bounded_vec2(float2(x, y)));
    float2 scaled = max(p.x, p.y) > 1.0 ? 0.5 * p : p;
    const float a = atan2_positive(scaled.y, scaled.x);
    float turned = x < 0.0 ? PI - a : a;
    return y < 0.0 ? -turned : turned;
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
float srgb_of_linear(float light)
{
    float size = abs(light);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * pow(size, 0.41666666) - 0.055;
    return light < 0.0 ? -value : value;
}

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
float soft_light(float a, float b)
{
    if (b <= 0.5) {
        return a - (1.0 - 2.0 * b) * a * (1.0 - a);
    }
    float curved = a <= 0.25 ? ((16.0 * a - 12.0) * a + 4.0) * a : sqrt(max(a, 0.0));
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
float3 oklab_of_linear(float3 rgb)
{
    float l = pow(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = pow(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return float3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l - 2.4285922 * m
        + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
float3 linear_of_oklab(float3 lab)
{
    float l = lab.x + 0.39633778 * lab.y + 0.21580376 * lab.z;
    float m = lab.x - 0.105561346 * lab.y - 0.06385417 * lab.z;
    float s = lab.x - 0.08948418 * lab.y - 1.2914855 * lab.z;
    float3 cubes = float3(l * l * l, m * m * m, s * s * s);
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)),
        dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)),
        dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
float3 oklab_of_srgb(float3 coded)
{
    const float3 oklab_of_linear_value = oklab_of_linear(float3(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
float3 srgb_of_oklab(float3 lab)
{
    const float3 light = linear_of_oklab(lab);
    return float3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / max(rhs, 1u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

RampPlace ConstructRampPlace(float4 before, float4 after, float t) {
    RampPlace ret = (RampPlace)0;
    ret.before = before;
    ret.after = after;
    ret.t = t;
    return ret;
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
RampPlace ramp_place(Ramp ramp, float x)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    uint at = 0u;

    colors = ramp.colors;
    places = ramp.places;
    for (uint i = 1u; i < 5u; i++) {
        float places_now = places[min(uint(naga_div(i, 4u)), 3u)][min(uint(naga_mod(i, 4u)), 3u)];
        at = places_now <= x ? i : at;
    }
    uint after = min(at + 1u, 4u);
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    const float divided_value = divided(x - place,
        places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)] - place);
    float t = clamp(divided_value, 0.0, 1.0);
    return ConstructRampPlace(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)], t);
}

float4 mix_colors_screen(float4 a, float4 b, float factor)
{
    return float4(lerp(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, factor), 1.0);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
float curvature_signed(float kappa, float slope)
{
    float a = kappa * slope;
    float magnitude = min(abs(a), 50.0);
    if (magnitude < 0.0625) {
        float a2 = a * a;
        return a * (1.0 - a2 * (0.33333334 - a2 * (0.13333334 - a2 * 0.053968254)));
    }
    const float z = exp2_stable_2(-2.88539 * magnitude);
    float t = (1.0 - z) / (1.0 + z);
    return a >= 0.0 ? t : -t;
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
float curvature_signed_2(float kappa, float slope)
{
    float a = min(kappa, 10000.0) * slope;
    float magnitude = min(a, 50.0);
    if (magnitude < 0.0625) {
        float a2 = a * a;
        return a * (1.0 - a2 * (0.33333334 - a2 * (0.13333334 - a2 * 0.053968254)));
    }
    const float z = exp2_stable_2(-2.88539 * magnitude);
    float t = (1.0 - z) / (1.0 + z);
    return t;
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
float2 principal_curvatures(float3 tensor)
{
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = length(float2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    const float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? float2(far, near) : float2(near, far);
}

float4 ramp_oklab(float value, Ramp ramp)
{
    const RampPlace place = ramp_place(ramp, value);
    const float3 srgb_of_oklab_value = srgb_of_oklab(lerp(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : float4(srgb_of_oklab_value, 1.0));
}

float reflectance_half_lambert(Light light, float3 normal)
{
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of(facing), 1.0));
    float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    float3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * rsqrt(max(dot(across, across), 1e-30)));
    return inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// A tone from 0 to 1 scaled by e^curved where it is dark and by e^-curved where it is light; the
/// tone `turning` stays.
float radiance_scaled(float tone, float curved, float turning)
{
    const float e = exp2_stable(curved * LOG2_E);
    float dark = turning * (1.0 - tone);
    float light = tone * (1.0 - turning);
    return tone * (e * dark + light) / max(dark + e * light, 1e-20);
}

/// Scale by curvature
///
/// Makes a tone lighter where the surface bulges and darker where it is hollow, and the other way
/// around where it is very light: any shading shows its shape more plainly.
float radiance_scaling(float tone, float kappa, float amount, float slope, float turning)
{
    float curved = amount * curvature_signed(kappa, slope);
    const float radiance_scaled_value = radiance_scaled(tone, curved, turning);
    return min(curved == 0.0 ? tone : radiance_scaled_value, 1.0);
}

Relief ConstructRelief(float shape, float strength, float greatest, float least) {
    Relief ret = (Relief)0;
    ret.shape = shape;
    ret.strength = strength;
    ret.greatest = greatest;
    ret.least = least;
    return ret;
}

/// Relief
///
/// What the surface does at a place, in two numbers for a Tone map or for ramps: its shape (pit,
/// valley, saddle, ridge or bump) and how strongly it has it.
Relief relief(float3 tensor, float slope)
{
    const float2 k = principal_curvatures(tensor);
    const float around = angle_of_point(k.x + k.y, k.x - k.y);
    float curvedness = sqrt(0.5 * dot(k, k));
    const float strength = curvature_signed_2(curvedness, slope);
    return ConstructRelief(0.5 + around / PI, strength, k.x, k.y);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const float matt_clay = reflectance_half_lambert(look.key, surface.normal);
    const float worked_by_curvature = radiance_scaling(matt_clay, surface.kappa, 1.3, 0.03, 0.9);
    const float4 terracotta_2 = ramp_oklab(worked_by_curvature, terracotta);
    const Relief what_the_surface_does = relief(surface.curvature_tensor, 0.025);
    const float4 pits_to_bumps_2 = ramp_oklab(what_the_surface_does.shape, pits_to_bumps);
    const float soft_light_value = soft_light(terracotta_2.x, pits_to_bumps_2.x);
    const float soft_light_value_1 = soft_light(terracotta_2.y, pits_to_bumps_2.y);
    const float soft_light_value_2 = soft_light(terracotta_2.z, pits_to_bumps_2.z);
    float4 slip_in_the_hollows = float4(lerp(terracotta_2.xyz,
        float3(soft_light_value, soft_light_value_1, soft_light_value_2),
        clamp(what_the_surface_does.strength, 0.0, 1.0)), 1.0);
    const float sky_along_the_edge = rim(look.sky, surface.normal, surface.view, 0.4, 0.9, 1.0);
    const float4 cool_edge = mix_colors_screen(slip_in_the_hollows,
        float4(0.3725, 0.498, 0.6588, 1.0), sky_along_the_edge);
    return cool_edge;
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

Surface ConstructSurface(float3 normal, float3 view, float kappa, float3 curvature_tensor) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.kappa = kappa;
    ret.curvature_tensor = curvature_tensor;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_1 = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        texel.x, texel_1.xyz);
    return shade(surface);
}
