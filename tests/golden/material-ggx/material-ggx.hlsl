// Cook-Torrance, GGX: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// material-ggx.json says what to put there and how to draw.

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

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

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

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(float at_normal, float cosine)
{
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
float ggx(Reflection r, float width, float at_normal)
{
    if ((r.n_l <= 0.0) | (r.n_v <= 0.0)) {
        return 0.0;
    }
    float a2 = width * width;
    float bottom = max(r.sine2_ + a2 * r.n_h * r.n_h, 1e-12);
    float distribution = a2 / (bottom * bottom);
    float toward_light = r.n_v * sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    float toward_eye = r.n_l * sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    float visibility = 0.5 / max(toward_light + toward_eye, 1e-9);
    return min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1000000.0);
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float lambert = max(dot(surface.normal, look.key.direction), 0.0);
    // Blend
    float4 body = float4(float3(0.0784, 0.0863, 0.1098) + lambert * float3(0.2353, 0.2667, 0.3137),
        1.0);
    // Reflectance
    const float ggx_2 = ggx(reflection_of(look.key.direction, surface.normal, surface.view), 0.1764,
        0.85);
    // Blend
    float4 highlight = clamp(float4(body.xyz + 0.5
        * (body.xyz + ggx_2 * float3(0.9098, 0.9333, 0.9647) - body.xyz), 1.0), (0.0).xxxx,
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
    Varyings in_ = { input.clip_1, input.position_1, input.normal_3 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position));
    return shade(surface);
}
