// Iridescent film: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// material-film.json says what to put there and how to draw.

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
    float3 view;
    float3 position_object;
};

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    float sine2_;
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

static const float PI = 3.1415927;
static const float LN_2 = 0.6931472;
static const float LOG2_E = 1.442695;
static const uint NOISE_PERLIN = 1u;

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 position_object : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_5 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float clamped = max(x, -126.0);
    float whole = round(clamped);
    float f = clamped - whole;
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

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y)
{
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(float y)
{
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return LN_2 * log2_stable(1.0 - y);
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(float3 v)
{
    float3 dx = ddx(v);
    float3 dy = ddy(v);
    return sqrt(max(dot(dx, dx), dot(dy, dy)));
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
float4 blend_add(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity * (below.xyz + tone * (1.0).xxx - below.xyz), 1.0),
        (0.0).xxxx, (1.0).xxxx);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
float3 half_of(float3 light, float3 normal, float3 view)
{
    float3 half_ = light + view;
    return normalize_moderate(dot(half_, half_) > 1e-12 ? half_ : normal, normal);
}

/// The square of the sine between two unit vectors.
float sine_squared(float3 a, float3 b)
{
    float3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

Reflection ConstructReflection(float n_l, float n_v, float n_h, float v_h, float sine2_) {
    Reflection ret = (Reflection)0;
    ret.n_l = n_l;
    ret.n_v = n_v;
    ret.n_h = n_h;
    ret.v_h = v_h;
    ret.sine2_ = sine2_;
    return ret;
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
Reflection reflection_of(float3 light, float3 normal, float3 view)
{
    const float3 half_ = half_of(light, normal, view);
    float n_h = clamp(dot(normal, half_), 0.0, 1.0);
    float v_h = clamp(dot(view, half_), 0.0, 1.0);
    const float sine_squared_value = sine_squared(normal, half_);
    return ConstructReflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared_value);
}

/// A cosine to a power, 0 where it is negative; by the square of its sine where that has more
/// digits.
float cosine_power(float cosine, float sine2, float exponent)
{
    if (cosine < 0.7) {
        return 0.0;
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(min(sine2, 0.6)));
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(float at_normal, float cosine)
{
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Share of one wavelength that a thin film reflects: 0 where the waves from both its faces cancel,
/// 1 where they add up. `path` is the difference of both ways, in the wavelength's unit.
float interference(float path, float wavelength)
{
    float x = PI * path / wavelength;
    float2 half_ = float2(sin(x), cos(x));
    return half_.x * half_.x;
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
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

    for (int i = 0; i < 2; i++) {
        float visible = 1.0 - smoothstep(0.5, 1.0, w * frequency);
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
    return min(sum / 1.5, 1.0);
}

float reflectance_blinn_phong(Light light, float3 normal, float3 view, float roughness)
{
    const Reflection r = reflection_of(light.direction, normal, view);
    float width = roughness * roughness;
    float e = 2.0 / (width * width) - 2.0;
    const float shine = cosine_power(r.n_h, r.sine2_, e);
    return 0.125 * (e + 8.0) * shine * max(r.n_l, 0.0);
}

/// Thin film
///
/// The colors of soap bubbles, beetles and oil on water: a film that is as thin as light's waves
/// are long reflects some and cancels others, changing with the angle.
float4 thin_film(float thickness, float index, float3 normal, float3 view)
{
    float cosine = clamp(dot(normal, view), 0.0, 1.0);
    float inside = sqrt((index - 1.0) * (index + 1.0) + cosine * cosine);
    float path = 2.0 * thickness * inside;
    return float4(interference(path, 650.0), interference(path, 532.0), interference(path, 450.0),
        1.0);
}

float noise_perlin(float3 position, float scale, int octaves, float roughness, int seed)
{
    float3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const float swirl = noise_perlin(surface.position_object, 1.3, int(2), 0.5, int(0));
    float thickness = lerp(180.0, 420.0, swirl - 0.0);
    const float4 film = thin_film(thickness, 1.33, surface.normal, surface.view);
    // Fresnel
    const float glow = schlick(0.45, clamp(dot(surface.normal, surface.view), 0.0, 1.0));
    // Blend
    float4 film_2 = min(float4(float3(0.0784, 0.0863, 0.1216) + glow * film.xyz, 1.0), (1.0).xxxx);
    const float highlight = reflectance_blinn_phong(look.key, surface.normal, surface.view, 0.22);
    const float4 highlight_on_top = blend_add(film_2, (1.0).xxxx, highlight, 0.2, true);
    return highlight_on_top;
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

Surface ConstructSurface(float3 normal, float3 view, float3 position_object) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_2, input.position_object_1, input.normal_5 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object);
    return shade(surface);
}
