// Light that wraps: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// material-wrap.json says what to put there and how to draw.

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
    float3 normal : LOC1;
};

static const float LN_2 = 0.6931472;
static const float LOG2_E = 1.442695;

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_3 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_4 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

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
        return pow(cosine, exponent);
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(min(sine2, 0.6)));
}

float reflectance_blinn_phong(Light light, float3 normal, float3 view, float roughness)
{
    const Reflection r = reflection_of(light.direction, normal, view);
    float width = roughness * roughness;
    float e = 2.0 / (width * width) - 2.0;
    const float shine = cosine_power(r.n_h, r.sine2_, e);
    return 0.125 * (e + 8.0) * shine * max(r.n_l, 0.0);
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float wrap = max((dot(surface.normal, look.key.direction) + 0.7) / 1.7, 0.0);
    // Blend
    float4 body = min(float4(float3(0.2902, 0.1137, 0.1333) + wrap * float3(0.851, 0.4706, 0.3725),
        1.0), (1.0).xxxx);
    const float blinn_phong = reflectance_blinn_phong(look.key, surface.normal, surface.view, 0.6);
    // Blend
    float4 highlight = clamp(float4(body.xyz + 0.25
        * (body.xyz + blinn_phong * float3(1.0, 0.8902, 0.8) - body.xyz), 1.0), (0.0).xxxx,
        (1.0).xxxx);
    return highlight;
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

Surface ConstructSurface(float3 normal, float3 view) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_4 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position));
    return shade(surface);
}
