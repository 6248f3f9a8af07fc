// Profile curves: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1.
// figure3-curves.json says what to put there and how to draw.

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

/// The surface under the fragment, in world space.
struct Surface {
    float2 uv;
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
    float2 uv : LOC3;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float2 uv : LOC0;
};

static const float PI = 3.1415927;
static const ProfileShape lambert_shape = {1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519, 0.37607926,
    0u};
static const ProfileShape half_lambert_shape = {1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985,
    0.68337417, 0u};
static const ProfileShape custom_shape = {0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5,
    0.49992928, 0.2351043, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }

struct VertexOutput {
    float2 uv : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float2 uv_1 : LOC0;
    float4 clip_1 : SV_Position;
};

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x)
{
    return (asuint(x) & 2139095040u) != 2139095040u;
}

/// x, or `otherwise` where x is NaN or infinite.
float finite_or(float x, float otherwise)
{
    const bool is_finite_value = is_finite(x);
    return is_finite_value ? x : otherwise;
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
float2 sin_cos_quarter(float x)
{
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (2.7557319e-6 + h2 * -2.5052108e-8)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-2.4801588e-5 + h2 * (2.755732e-7 + h2 * -2.0876756e-9)))));
    float c = 1.0 - one_minus_c;
    return float2(2.0 * s * c, 1.0 - 2.0 * s * s);
}

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
Angle angle_of(float radians_)
{
    float half_angle = 0.5 * clamp(finite_or(radians_, 0.0), 0.0, PI);
    const float2 sc = sin_cos_quarter(half_angle);
    return ConstructAngle(max(sc.x, 0.0), max(sc.y, 0.0));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, float2 t)
{
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + u.half_sin * 0.0;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
}

float4 blend_alpha(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return float4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

float4 blend_alpha_2(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
}

float4 blend_alpha_3(float4 below, float4 color, float tone, float opacity, bool clamped)
{
    return clamp(float4(below.xyz + tone * (color.xyz - below.xyz), 1.0), (0.0).xxxx, (1.0).xxxx);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), 1.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_2(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_3(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(1.0 - q * q, shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin * 0.0);
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

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin * 0.0);
    const float point_ = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point_;
    }
    float r = 0.19364917 * w;
    float2 turn = float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    const float before = profile_soft_quick_3(place.x * turn.y - place.y * turn.x, shape);
    const float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_3(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    const float point_ = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point_;
    }
    float r = 0.19364917 * w;
    float2 turn = float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    const float before = profile_soft_quick_2(place.x * turn.y - place.y * turn.x, shape);
    const float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick_3(warped, angle_footprint(warped), shape);
}

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
float threshold(float value, float edge, float softness)
{
    return step_filtered(value, edge, length(float2(footprint_of(value), softness)));
}

VectorParts ConstructVectorParts(float x, float y, float z) {
    VectorParts ret = (VectorParts)0;
    ret.x = x;
    ret.y = y;
    ret.z = z;
    return ret;
}

/// Separate vector
///
/// The three numbers of a vector.
VectorParts separate_vector(float3 vector_)
{
    return ConstructVectorParts(vector_.x, vector_.y, 0.0);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const VectorParts place = separate_vector(float3(surface.uv, 0.0));
    float tone = (place.y - 0.14) / 0.72;
    // Blend
    float angles_tone = max(threshold(tone, -0.006, 0.0) - threshold(tone, 0.006, 0.0), 0.0);
    const float4 angles = blend_alpha(float4(0.98, 0.965, 0.925, 1.0), float4(0.24, 0.26, 0.3, 1.0),
        angles_tone, 1.0, true);
    float angle = lerp(0.0, 3.1415927, (place.x - 0.08) / 0.84);
    // Blend
    float tones_tone = max(threshold(angle, -0.012, 0.0) - threshold(angle, 0.012, 0.0), 0.0);
    // Blend
    float4 tones = max(float4(angles.xyz + tones_tone * (float3(0.24, 0.26, 0.3) - angles.xyz),
        1.0), (0.0).xxxx);
    // Blend
    float offset_tone = max(threshold(angle, 0.492, 0.0) - threshold(angle, 0.508, 0.0), 0.0);
    const float4 offset = blend_alpha_2(tones, float4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55,
        true);
    // Blend
    float falloff_tone = max(threshold(angle, 0.942, 0.0) - threshold(angle, 0.958, 0.0), 0.0);
    const float4 falloff = blend_alpha_2(offset, float4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55,
        true);
    // Blend
    float cutoff_tone = max(threshold(angle, 1.792, 0.0) - threshold(angle, 1.808, 0.0), 0.0);
    const float4 cutoff = blend_alpha_2(falloff, float4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55,
        true);
    const float lambert = profile_balanced(angle_of(angle), 0.0, lambert_shape);
    float lambert_off = tone - lambert;
    float lambert_line = threshold(lambert_off, -0.012, 0.0) - threshold(lambert_off, 0.012, 0.0);
    // Blend
    float lambert_tone = max(lambert_line, 0.0);
    const float4 lambert_2 = blend_alpha_3(cutoff, float4(0.8, 0.2, 0.17, 1.0), lambert_tone, 1.0,
        true);
    const float half_lambert = profile_balanced_2(angle_of(angle), 0.0, half_lambert_shape);
    float half_lambert_off = tone - half_lambert;
    const float half_lambert_to = threshold(half_lambert_off, 0.012, 0.0);
    float half_lambert_line = threshold(half_lambert_off, -0.012, 0.0) - half_lambert_to;
    // Blend
    float half_lambert_tone = max(half_lambert_line, 0.0);
    const float4 half_lambert_2 = blend_alpha_3(lambert_2, float4(0.18, 0.55, 0.27, 1.0),
        half_lambert_tone, 1.0, true);
    const float custom = profile_balanced_3(angle_of(angle), 0.0, custom_shape);
    float custom_off = tone - custom;
    float custom_line = threshold(custom_off, -0.012, 0.0) - threshold(custom_off, 0.012, 0.0);
    // Blend
    float custom_tone = max(custom_line, 0.0);
    const float4 custom_2 = blend_alpha_3(half_lambert_2, float4(0.5, 0.31, 0.14, 1.0), custom_tone,
        1.0, true);
    return custom_2;
}

Varyings ConstructVaryings(float4 clip_, float2 uv) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.uv = uv;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), vertex.uv);
    const VertexOutput varyings_1 = { varyings.uv, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float2 uv) {
    Surface ret = (Surface)0;
    ret.uv = uv;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.uv_1 };
    Surface surface = ConstructSurface(in_.uv);
    return shade(surface);
}
