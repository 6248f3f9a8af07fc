#version 300 es
// Anime face: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// anime-face.json says what to put there and how to draw.

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
    Light back;
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

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};

const ProfileShape edge_of_the_shadow_shape = ProfileShape(0.7960838, 0.6051864, 15.395454,
    2.8429606, 1.3, 0.060679536, 0.026670605, 0u);
const ProfileShape lit_shape = ProfileShape(0.7775727, 0.628793, 0.0, 1.0, 1.36, 0.0, 0.0, 1u);
const ProfileShape shine_tone_shape = ProfileShape(0.9950042, 0.099833414, 0.0, 1.0, 0.2, 0.0, 0.0,
    1u);
const ProfileShape rim_light_tone_shape = ProfileShape(0.90896577, 0.4168708, 0.0, 1.0, 0.86, 0.0,
    0.0, 1u);
const ProfileShape contour_tone_shape = ProfileShape(0.819648, 0.57286745, 0.0, 1.0, 1.22, 0.0, 0.0,
    1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_position;
smooth in vec3 v_position_object;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 1e-30)) {
        return otherwise;
    }
    vec3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    return (floatBitsToUint(square) & 2139095040u) == 2139095040u ? otherwise : scaled
        * (1.0 / sqrt(square));
}

/// [`normalize_or`] for a third of its price: a vector shorter than 1e-15 or longer than 1e18
/// counts as having no direction.
vec3 normalize_quick(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    bool is_usable = square > 1e-30;
    return is_usable ? v * inversesqrt(is_usable ? square : 1.0) : otherwise;
}

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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, vec2 t) {
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
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

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

vec4 blend_shade(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return min(vec4(below.xyz + opacity * (below.xyz * mix(vec3(1.0), color.xyz, tone) - below.xyz),
        1.0), vec4(1.0));
}

vec4 blend_shade_2(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + opacity
        * (below.xyz * mix(vec3(1.0), color.xyz, tone) - below.xyz), 1.0), vec4(0.0), vec4(1.0));
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

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply_3(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_diffuse_balanced(Light light, vec3 normal) {
    vec3 d = normalize_quick(normal, vec3(0.0, 0.0, 1.0));
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

float profile_balanced_3(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    vec3 place = surface.position_object;
    vec3 from_the_face_s_middle = place - vec3(0.0, 0.52, -0.18);
    vec3 flattened = from_the_face_s_middle * vec3(1.0, 0.35, 1.0);
    vec3 face_direction = normalize_or(flattened, vec3(0.0));
    VectorParts high = VectorParts(place.x, place.y, place.z);
    float is_face = smoothstep(0.02, 0.16, high.y);
    vec3 face_or_body = mix(surface.normal, face_direction, is_face);
    vec3 shading_direction = face_or_body
        * inversesqrt(max(dot(face_or_body, face_or_body), 1e-30));
    Angle from_the_light = parametrization_diffuse_balanced(u_look.key, shading_direction);
    float edge_of_the_shadow = profile_balanced(from_the_light, 0.0, edge_of_the_shadow_shape);
    float soft_dark = 1.0 - edge_of_the_shadow;
    vec4 warm_edge = blend_shade(vec4(0.9843, 0.8902, 0.8118, 1.0),
        vec4(0.9412, 0.5412, 0.4157, 1.0), soft_dark, 0.55, true);
    float lit = profile_balanced_2(from_the_light, 0.0, lit_shape);
    float in_shadow = 1.0 - lit;
    vec4 shadow = blend_shade_2(warm_edge, vec4(0.698, 0.4784, 0.6588, 1.0), in_shadow, 0.85, true);

    // Inked hollows (Light layer)
    float inked_hollows_convexity = transition_balanced(surface.kappa, 0.55);
    vec4 inked_hollows_color = curvature_color(inked_hollows_convexity, vec4(1.0),
        vec4(0.2902, 0.1412, 0.251, 1.0));
    LitLayer inked_hollows_lit = light_apply(u_look.eye, inked_hollows_color, 1.0);
    vec4 inked_hollows_blend = clamp(vec4(shadow.xyz + 0.9
        * (shadow.xyz * (inked_hollows_lit.tone * inked_hollows_lit.color.xyz) - shadow.xyz), 1.0),
        vec4(0.0), vec4(1.0));

    // Shine (Light layer)
    Angle shine_angle = parametrization_specular_balanced(u_look.key, surface.normal, surface.view);
    float rim_light_convexity = transition_balanced(surface.kappa, 0.2);
    float shine_warp = (2.0 * rim_light_convexity - 1.0) * 0.05;
    float shine_tone = profile_balanced_3(shine_angle, shine_warp, shine_tone_shape);
    LitLayer shine_lit = light_apply_2(u_look.key, vec4(1.0), shine_tone);
    vec4 shine_blend = blend_alpha(inked_hollows_blend, shine_lit.color, shine_lit.tone, 0.85,
        true);

    // Rim light (Light layer)
    Angle rim_light_angle = Angle(0.5 * length(surface.normal - u_look.back.direction), 0.5
        * length(surface.normal + u_look.back.direction));
    float rim_light_warp = (2.0 * rim_light_convexity - 1.0) * 0.15;
    float rim_light_tone = profile_balanced_3(rim_light_angle, rim_light_warp,
        rim_light_tone_shape);
    LitLayer rim_light_lit = light_apply_3(u_look.back, vec4(1.0, 0.9647, 0.9176, 1.0),
        rim_light_tone);
    vec4 rim_light_blend = blend_alpha(shine_blend, rim_light_lit.color, rim_light_lit.tone, 0.9,
        true);

    // Contour (Light layer)
    Angle contour_angle = parametrization_screen_aligned_balanced(u_look.eye, surface.normal,
        u_look.camera_from_world);
    float contour_warp = (2.0 * transition_balanced(surface.kappa, 0.12) - 1.0) * 0.28;
    float contour_tone = profile_balanced_3(contour_angle, contour_warp, contour_tone_shape);
    LitLayer contour_lit = light_apply_2(u_look.eye, vec4(1.0), contour_tone);
    vec4 contour_blend = clamp(vec4(rim_light_blend.xyz
        * (contour_lit.tone * contour_lit.color.xyz), 1.0), vec4(0.0), vec4(1.0));

    return contour_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object, texel.x);
    out_color = shade(surface);
}
