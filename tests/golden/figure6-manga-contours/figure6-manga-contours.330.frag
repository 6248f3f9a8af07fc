#version 330 core
// Manga, contours: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-manga-contours.json says what to put there and how to draw.
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

struct Varyings {
    vec4 clip;
    vec3 normal;
};

const ProfileShape shadow_tone_shape = ProfileShape(0.78070694, 0.6248973, 0.0, 1.0, 1.35, 0.0, 0.0,
    1u);
const ProfileShape contour_tone_shape = ProfileShape(0.8337121, 0.55219936, 0.0, 1.0, 1.17, 0.0,
    0.0, 1u);

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
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

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return concave + convexity * (convex - concave);
}

float transition_balanced(float kappa, float slope) {
    return 0.5 + 0.5 * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(kappa * slope, -20.0, 20.0))));
}

vec4 blend_multiply(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + 0.5 * (below.xyz * (tone * color.xyz) - below.xyz), 1.0),
        vec4(0.0), vec4(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_screen_aligned_balanced(Light light, vec3 normal, mat3x3 camera_from_world) {
    vec3 d = camera_from_world * normal;
    return Angle(0.5 * length(d - light.own_direction), 0.5 * length(d + light.own_direction));
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Shadow (Light layer)
    Angle inked_hollows_angle = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float shadow_warp = (2.0 * transition_balanced(surface.kappa, 0.3) - 1.0) * 0.35;
    float shadow_tone = profile_balanced(inked_hollows_angle, shadow_warp, shadow_tone_shape);
    LitLayer shadow_lit = light_apply(u_look.key, vec4(0.9843, 0.9765, 0.9569, 1.0), shadow_tone);
    vec4 shadow_blend = blend_multiply(vec4(0.9843, 0.9765, 0.9569, 1.0), shadow_lit.color,
        shadow_lit.tone, 0.5, true);

    // Inked hollows (Light layer)
    float inked_hollows_convexity = transition_balanced(surface.kappa, 0.5);
    vec4 inked_hollows_color = curvature_color(inked_hollows_convexity, vec4(1.0),
        vec4(0.1647, 0.1451, 0.1882, 1.0));
    LitLayer inked_hollows_lit = light_apply(u_look.key, inked_hollows_color, 1.0);
    vec4 inked_hollows_blend = clamp(vec4(shadow_blend.xyz
        * (inked_hollows_lit.tone * inked_hollows_lit.color.xyz), 1.0), vec4(0.0), vec4(1.0));

    // Contour (Light layer)
    Angle contour_angle = parametrization_screen_aligned_balanced(u_look.eye, surface.normal,
        u_look.camera_from_world);
    float contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.3;
    float contour_tone = profile_balanced(contour_angle, contour_warp, contour_tone_shape);
    LitLayer contour_lit = light_apply(u_look.eye, vec4(1.0), contour_tone);
    vec4 contour_blend = clamp(vec4(inked_hollows_blend.xyz
        * (contour_lit.tone * contour_lit.color.xyz), 1.0), vec4(0.0), vec4(1.0));

    return contour_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0).x);
    out_color = shade(surface);
}
