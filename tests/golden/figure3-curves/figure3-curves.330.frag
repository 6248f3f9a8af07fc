#version 330 core
// Profile curves: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// figure3-curves.json says what to put there and how to draw.
/// The surface under the fragment, in world space.
struct Surface {
    vec2 uv;
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

struct Varyings {
    vec4 clip;
    vec2 uv;
};

const float PI = 3.1415927;
const ProfileShape lambert_shape = ProfileShape(1.0, 0.0, 1.4142109, 1.0, 0.0, 0.9999519,
    0.37607926, 0u);
const ProfileShape half_lambert_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985,
    0.68337417, 0u);
const ProfileShape custom_shape = ProfileShape(0.9689124, 0.24740396, 1.6523834, 4.0124283, 0.5,
    0.49992928, 0.2351043, 0u);

smooth in vec2 v_uv;
layout(location = 0) out vec4 out_color;

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x) {
    return (floatBitsToUint(x) & 2139095040u) != 2139095040u;
}

/// x, or `otherwise` where x is NaN or infinite.
float finite_or(float x, float otherwise) {
    bool is_finite_value = is_finite(x);
    return is_finite_value ? x : otherwise;
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
vec2 sin_cos_quarter(float x) {
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
    return vec2(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// The angle of `radians`, clamped to [0, pi]; 0 where it is not finite.
Angle angle_of(float radians_) {
    float half_angle = 0.5 * clamp(finite_or(radians_, 0.0), 0.0, PI);
    vec2 sc = sin_cos_quarter(half_angle);
    return Angle(max(sc.x, 0.0), max(sc.y, 0.0));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, vec2 t) {
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + u.half_sin * 0.0;
    vec2 upper = c <= 0.0 ? vec2(1.0, 0.0) : vec2(s, c);
    vec2 turned = (s <= 0.0 && s < c) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w) {
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return vec4(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

vec4 blend_alpha_2(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_alpha_3(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), 1.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_2(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick_3(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(1.0 - q * q, shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin * 0.0);
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_2(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin - u.half_cos * 0.0, u.half_cos + u.half_sin * 0.0);
    float point = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_3(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick_3(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    float point = profile_soft_quick_2(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick_2(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick_2(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick_3(warped, angle_footprint(warped), shape);
}

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
float threshold(float value, float edge, float softness) {
    return step_filtered(value, edge, length(vec2(footprint_of(value), softness)));
}

/// Separate vector
///
/// The three numbers of a vector.
VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, 0.0);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    VectorParts place = separate_vector(vec3(surface.uv, 0.0));
    float tone = (place.y - 0.14) / 0.72;
    // Blend
    float angles_tone = max(threshold(tone, -0.006, 0.0) - threshold(tone, 0.006, 0.0), 0.0);
    vec4 angles = blend_alpha(vec4(0.98, 0.965, 0.925, 1.0), vec4(0.24, 0.26, 0.3, 1.0),
        angles_tone, 1.0, true);
    float angle = mix(0.0, 3.1415927, (place.x - 0.08) / 0.84);
    // Blend
    float tones_tone = max(threshold(angle, -0.012, 0.0) - threshold(angle, 0.012, 0.0), 0.0);
    // Blend
    vec4 tones = max(vec4(angles.xyz + tones_tone * (vec3(0.24, 0.26, 0.3) - angles.xyz), 1.0),
        vec4(0.0));
    // Blend
    float offset_tone = max(threshold(angle, 0.492, 0.0) - threshold(angle, 0.508, 0.0), 0.0);
    vec4 offset = blend_alpha_2(tones, vec4(0.2, 0.38, 0.78, 1.0), offset_tone, 0.55, true);
    // Blend
    float falloff_tone = max(threshold(angle, 0.942, 0.0) - threshold(angle, 0.958, 0.0), 0.0);
    vec4 falloff = blend_alpha_2(offset, vec4(0.2, 0.38, 0.78, 1.0), falloff_tone, 0.55, true);
    // Blend
    float cutoff_tone = max(threshold(angle, 1.792, 0.0) - threshold(angle, 1.808, 0.0), 0.0);
    vec4 cutoff = blend_alpha_2(falloff, vec4(0.2, 0.38, 0.78, 1.0), cutoff_tone, 0.55, true);
    float lambert = profile_balanced(angle_of(angle), 0.0, lambert_shape);
    float lambert_off = tone - lambert;
    float lambert_line = threshold(lambert_off, -0.012, 0.0) - threshold(lambert_off, 0.012, 0.0);
    // Blend
    float lambert_tone = max(lambert_line, 0.0);
    vec4 lambert_2 = blend_alpha_3(cutoff, vec4(0.8, 0.2, 0.17, 1.0), lambert_tone, 1.0, true);
    float half_lambert = profile_balanced_2(angle_of(angle), 0.0, half_lambert_shape);
    float half_lambert_off = tone - half_lambert;
    float half_lambert_to = threshold(half_lambert_off, 0.012, 0.0);
    float half_lambert_line = threshold(half_lambert_off, -0.012, 0.0) - half_lambert_to;
    // Blend
    float half_lambert_tone = max(half_lambert_line, 0.0);
    vec4 half_lambert_2 = blend_alpha_3(lambert_2, vec4(0.18, 0.55, 0.27, 1.0), half_lambert_tone,
        1.0, true);
    float custom = profile_balanced_3(angle_of(angle), 0.0, custom_shape);
    float custom_off = tone - custom;
    float custom_line = threshold(custom_off, -0.012, 0.0) - threshold(custom_off, 0.012, 0.0);
    // Blend
    float custom_tone = max(custom_line, 0.0);
    vec4 custom_2 = blend_alpha_3(half_lambert_2, vec4(0.5, 0.31, 0.14, 1.0), custom_tone, 1.0,
        true);
    return custom_2;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_uv);
    Surface surface = Surface(in_.uv);
    out_color = shade(surface);
}
