// Exaggerated shape: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, smooth_normal_1_map t0, smooth_normal_2_map t1, smooth_normal_3_map t2, smooth_normal_4_map t3.
// shape-exaggerated.json says what to put there and how to draw.

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
    float2 viewport;
    int _pad1_0;
    int _pad1_1;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 smooth_normal_1_;
    float3 smooth_normal_2_;
    float3 smooth_normal_3_;
    float3 smooth_normal_4_;
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
    float3 position : LOC0;
    float3 normal : LOC1;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const Ramp from_dusk_to_sun = {{float4(0.1373, 0.1647, 0.302, 1.0),
    float4(0.4196, 0.3725, 0.5255, 1.0), float4(0.7882, 0.5804, 0.4353, 1.0),
    float4(0.9412, 0.8039, 0.5725, 1.0), float4(1.0, 0.9843, 0.902, 1.0), (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx}, {float4(0.05, 0.35, 0.55, 0.75), float4(0.98, 0.0, 0.0, 0.0), (0.0).xxxx,
    (0.0).xxxx}, 5u, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> smooth_normal_1_map : register(t0);
Texture2D<float4> smooth_normal_2_map : register(t1);
Texture2D<float4> smooth_normal_3_map : register(t2);
Texture2D<float4> smooth_normal_4_map : register(t3);

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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float whole = round(x);
    float f = x - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * 0.5;
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
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

float4 ramp_oklab(float value, Ramp ramp)
{
    const RampPlace place = ramp_place(ramp, value);
    const float3 srgb_of_oklab_value = srgb_of_oklab(lerp(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : float4(srgb_of_oklab_value, 1.0));
}

/// Shading of the detail that a finer normal has beyond a coarser one: -1 where the finer turns
/// from the light, 1 where it turns toward the light. The light is laid at the coarser normal's
/// horizon, so that detail is lit as well as can be, however the light falls.
float detail_lit(float3 finer, float3 coarser, float3 light, float contrast)
{
    float3 across = light - dot(light, coarser) * coarser;
    // Straight under the light there is no direction along the surface, and detail fades.
    float3 toward = across / (max(length(across), 0.05)).xxx;
    return clamp(contrast * dot(finer, toward), -1.0, 1.0);
}

float exaggerated_four(Light light, float3 normal, float contrast, float detail, float3 smooth_1,
    float3 smooth_2, float3 smooth_3, float3 smooth_4)
{
    const float r = exp2_stable(-detail);
    const float3 n1 = normalize_moderate(smooth_1, normal);
    const float3 n2 = normalize_moderate(smooth_2, n1);
    const float3 n3 = normalize_moderate(smooth_3, n2);
    const float3 n4 = normalize_moderate(smooth_4, n3);
    const float detail_lit_value = detail_lit(n3, n4, light.direction, contrast);
    float coarse = detail_lit(n2, n3, light.direction, contrast) + r
        * (detail_lit_value + r * dot(n4, light.direction));
    const float detail_lit_value_1 = detail_lit(n1, n2, light.direction, contrast);
    float sum = detail_lit(normal, n1, light.direction, contrast) + r
        * (detail_lit_value_1 + r * coarse);
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r * (1.0 + r)))), 0.0, 1.0);
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


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const float every_scale_of_detail = exaggerated_four(look.key, surface.normal, 7.0, 0.1,
        surface.smooth_normal_1_, surface.smooth_normal_2_, surface.smooth_normal_3_,
        surface.smooth_normal_4_);
    const float4 from_dusk_to_sun_2 = ramp_oklab(every_scale_of_detail, from_dusk_to_sun);
    const float ink = outer_contour(3.0, surface.normal, surface.view, look.viewport);
    float4 inked = lerp(from_dusk_to_sun_2, float4(0.098, 0.1059, 0.2, 1.0), ink);
    return inked;
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

Surface ConstructSurface(float3 normal, float3 view, float3 smooth_normal_1_,
    float3 smooth_normal_2_, float3 smooth_normal_3_, float3 smooth_normal_4_) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.smooth_normal_1_ = smooth_normal_1_;
    ret.smooth_normal_2_ = smooth_normal_2_;
    ret.smooth_normal_3_ = smooth_normal_3_;
    ret.smooth_normal_4_ = smooth_normal_4_;
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
    float4 texel = smooth_normal_1_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_1 = smooth_normal_2_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_2 = smooth_normal_3_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    float4 texel_3 = smooth_normal_4_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        mul(view.camera_from_world, float4(texel.xyz, 0.0)).xyz,
        mul(view.camera_from_world, float4(texel_1.xyz, 0.0)).xyz,
        mul(view.camera_from_world, float4(texel_2.xyz, 0.0)).xyz,
        mul(view.camera_from_world, float4(texel_3.xyz, 0.0)).xyz);
    return shade(surface);
}
