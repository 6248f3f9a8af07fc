#version 300 es
// Technical cutaway: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// technical-cutaway.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    vec3 direction;
    /// Unit, toward the light, in the light's own frame.
    vec3 own_direction;
    /// Straight RGB.
    vec3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light eye;
    mat3x3 camera_from_world;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    float kappa;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

struct LitLayer {
    /// The color under this light.
    vec4 color;
    /// The tone under this light.
    float tone;
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

struct Shaded {
    vec4 value;
    vec4 color;
    float cutoff;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};

const ProfileShape metal_tone_shape = ProfileShape(0.99820054, 0.059964005, 7.166244, 3.1997643,
    0.12, 0.124456726, 0.0556771, 0u);
const ProfileShape contour_tone_shape = ProfileShape(0.8253356, 0.5646425, 0.0, 1.0, 1.2, 0.0, 0.0,
    1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// v with 0 for each component that is NaN or infinite.
vec4 finite_vec4(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual(floatBitsToUint(v) & exponent, exponent));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
vec3 normalize_seen(vec3 v) {
    return normalize_moderate(v, vec3(0.0, 0.0, 1.0));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
vec2 sin_cos_quick(float x) {
    float y = x * x;
    float s = x * (1.0 + y * (-0.16666666 + y
        * (0.0083332425 + y * (-0.0001982274 + y * 2.6347564e-6))));
    float c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.477458e-5 - y * 2.6297516e-7))));
    return vec2(s, c);
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
    float s = u.half_sin * t.y - u.half_cos * t.x;
    float c = u.half_cos * t.y + u.half_sin * t.x;
    vec2 upper = c <= 0.0 ? vec2(1.0, 0.0) : vec2(s, c);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    vec2 turned = (s <= 0.0 && s < c) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 2147483647u;
    float largest = uintBitsToFloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w) {
    float d = x - edge;
    if (w < 1e-30) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Premultiplied RGBA of a straight color.
vec4 premultiplied(vec4 color) {
    return vec4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
vec4 straight(vec4 composite) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return vec4(composite.xyz / vec3(composite.w), composite.w);
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return concave + convexity * (convex - concave);
}

float transition_balanced(float kappa, float slope) {
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(kappa * slope, -20.0, 20.0))));
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
vec4 output_(vec4 color) {
    return finite_vec4(straight(color));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_2(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_specular_balanced(Light light, vec3 normal, vec3 view) {
    vec3 d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

Angle parametrization_screen_aligned_balanced(Light light, vec3 normal, mat3x3 camera_from_world) {
    vec3 d = camera_from_world * normal;
    return Angle(0.5 * length(d - light.own_direction), 0.5 * length(d + light.own_direction));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick_2(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
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

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// Cool to warm
///
/// Technical illustration's shading: from a cool color on the far side to a warm one toward the
/// light, so that outlines and highlights, which are darker and lighter, stay readable everywhere.
vec4 gooch(Light light, vec3 normal, vec4 color, vec4 cool, vec4 warm, float cool_amount,
    float warm_amount) {
    float t = 0.5 + 0.5 * dot(normal, light.direction);
    vec3 far = cool.xyz + cool_amount * color.xyz;
    vec3 near = warm.xyz + warm_amount * color.xyz;
    return vec4(mix(far, near, clamp(t, 0.0, 1.0)), 1.0);
}

/// The look at one point of the surface.
Shaded shade(Surface surface) {
    vec4 cool_to_warm = gooch(u_look.key, surface.normal, vec4(0.8314, 0.8392, 0.8549, 1.0),
        vec4(0.1725, 0.2902, 0.4863, 1.0), vec4(0.4196, 0.3529, 0.1961, 1.0), 0.35, 0.6);
    // Blend
    vec4 cool_to_warm_2 = vec4(vec3(1.0) + (cool_to_warm.xyz - vec3(1.0)), 1.0);

    // Hollows (Light layer)
    float hollows_convexity = transition_balanced(surface.kappa, 0.25);
    vec4 hollows_color = curvature_color(hollows_convexity, vec4(1.0),
        vec4(0.5412, 0.5804, 0.6588, 1.0));
    LitLayer hollows_lit = light_apply(u_look.key, hollows_color, 1.0);
    vec4 hollows_blend = clamp(vec4(cool_to_warm_2.xyz + 0.8
        * (cool_to_warm_2.xyz * (hollows_lit.tone * hollows_lit.color.xyz) - cool_to_warm_2.xyz),
        1.0), vec4(0.0), vec4(1.0));

    // Metal (Light layer)
    Angle metal_angle = parametrization_specular_balanced(u_look.key, surface.normal, surface.view);
    float metal_warp = (2.0 * transition_balanced(surface.kappa, 0.2) - 1.0) * 0.05;
    float metal_tone = profile_balanced(metal_angle, metal_warp, metal_tone_shape);
    LitLayer metal_lit = light_apply_2(u_look.key, vec4(1.0), metal_tone);
    vec4 metal_blend = blend_alpha(hollows_blend, metal_lit.color, metal_lit.tone, 0.8, true);

    // Contour (Light layer)
    Angle contour_angle = parametrization_screen_aligned_balanced(u_look.eye, surface.normal,
        u_look.camera_from_world);
    float contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.25;
    float contour_tone = profile_balanced_2(contour_angle, contour_warp, contour_tone_shape);
    LitLayer contour_lit = light_apply_2(u_look.eye, vec4(1.0), contour_tone);
    vec4 contour_blend = clamp(vec4(metal_blend.xyz * (contour_lit.tone * contour_lit.color.xyz),
        1.0), vec4(0.0), vec4(1.0));

    vec3 place = surface.position_object;
    VectorParts parts = VectorParts(place.x, place.y, place.z);
    float into_the_corner = min(parts.x, parts.z);
    // Threshold
    float section = step_filtered(into_the_corner, -0.012,
        length(vec2(min(footprint_of(into_the_corner), 1000000000000000.0), 0.0)));
    vec4 section_line = clamp(vec4(contour_blend.xyz + section
        * (vec3(0.8471, 0.1569, 0.1098) - contour_blend.xyz), 1.0), vec4(0.0), vec4(1.0));
    // Threshold
    float taken_out = step_filtered(into_the_corner, 0.02,
        length(vec2(min(footprint_of(into_the_corner), 1000000000000000.0), 0.0)));
    float kept = 1.0 - taken_out;
    // Set alpha
    vec4 cut = vec4(section_line.xyz, kept);
    vec4 output_2 = output_(premultiplied(cut));
    return Shaded(output_2, output_2, 0.5);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object, texel.x);
    Shaded shaded = shade(surface);
    if (shaded.color.w < shaded.cutoff) {
        discard;
    }
    out_color = finite_vec4(shaded.value);
}
