// Curvature as color: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// mean-curvature.json says what to put there and how to draw.

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
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float kappa;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp hollow_flat_ridge = {{float4(0.0588, 0.1294, 0.2706, 1.0),
    float4(0.1843, 0.3725, 0.5412, 1.0), float4(0.7255, 0.7647, 0.7059, 1.0),
    float4(0.9255, 0.8902, 0.7961, 1.0), float4(0.8902, 0.749, 0.502, 1.0),
    float4(0.7804, 0.4627, 0.1843, 1.0), float4(1.0, 0.9529, 0.8627, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.25, 0.44, 0.5), float4(0.6, 0.8, 1.0, 0.0), (0.0).xxxx, (0.0).xxxx}, 7u, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 normal_1 : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 normal_2 : LOC0;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

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

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
float srgb_of_linear(float light)
{
    float size = abs(light);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * pow(size, 0.41666666) - 0.055;
    return light < 0.0 ? -value : value;
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
    for (uint i = 1u; i < 7u; i++) {
        float places_now = places[min(uint(naga_div(i, 4u)), 3u)][min(uint(naga_mod(i, 4u)), 3u)];
        at = places_now <= x ? i : at;
    }
    uint after = min(at + 1u, 6u);
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    const float divided_value = divided(x - place,
        places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)), 3u)] - place);
    float t = clamp(divided_value, 0.0, 1.0);
    return ConstructRampPlace(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)], t);
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


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    float curvature = surface.kappa;
    // Curvature transition
    float from_hollow_to_ridge = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(curvature * 0.045, -20.0, 20.0))));
    const float4 base = ramp_oklab(from_hollow_to_ridge, hollow_flat_ridge);
    const float half_lambert = reflectance_half_lambert(look.key, surface.normal);
    float in_the_dark = 1.0 - half_lambert;
    // Blend
    float4 shade_2 = clamp(float4(base.xyz * lerp((1.0).xxx, float3(0.42, 0.4, 0.55), in_the_dark),
        1.0), (0.0).xxxx, (1.0).xxxx);
    return shade_2;
}

Varyings ConstructVaryings(float4 clip_, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world),
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float kappa) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.kappa = kappa;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal,
        curvature_map.Load(int3(to_int(in_.clip_.xy), int(0))).x);
    return shade(surface);
}
