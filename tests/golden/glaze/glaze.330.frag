#version 330 core
// Grisaille and glaze: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// glaze.json says what to put there and how to draw.
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
    Light key;
    Light back;
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

const ProfileShape gray_modeling_tone_shape = ProfileShape(1.0, 0.0, 1.0537579, 1.3909147, 0.0,
    1.2772532, 0.561292, 0u);
const ProfileShape gray_lights_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.0858297,
    3.3126261, 0.1, 0.42646712, 0.19445144, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

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
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// [`bounded`], component by component.
vec3 bounded_vec3(vec3 v) {
    uvec3 bits = floatBitsToUint(v);
    uvec3 magnitude = bits & uvec3(2147483647u);
    vec3 largest = uintBitsToFloat((bits & uvec3(2147483648u)) | uvec3(2139095039u));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v, lessThan(magnitude, uvec3(2139095040u)));
}

/// [`mixed`], component by component.
vec3 mixed_vec3(vec3 a, vec3 b, float t) {
    vec3 d = bounded_vec3(b - a);
    return bounded_vec3(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
float soft_light(float a, float b) {
    float curved = a <= 0.25 ? ((16.0 * a - 12.0) * a + 4.0) * a : sqrt(max(a, 0.0));
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
vec4 color_mixed(vec4 a, vec3 blended, float factor) {
    vec3 b = bounded_vec3(blended);
    return vec4(bounded_vec3(b - (1.0 - factor) * bounded_vec3(b - a.xyz)), 1.0);
}

/// Lightness of a color in the non-separable modes (W3C Compositing and Blending 1, Lum).
float lightness_of(vec3 rgb) {
    return dot(rgb, vec3(0.3, 0.59, 0.11));
}

/// `rgb` as light as `other`, drawn toward its gray where a component would leave [0, 1] (SetLum,
/// ClipColor).
vec3 lit_as(vec3 rgb, vec3 other) {
    float light = lightness_of(other);
    vec3 moved = rgb + vec3(light - lightness_of(rgb));
    float least = min(min(moved.x, moved.y), moved.z);
    float largest = max(max(moved.x, moved.y), moved.z);
    float raised = least < 0.0 ? light / max(light - least, 1e-6) : 1.0;
    vec3 clipped = vec3(light) + (moved - vec3(light)) * raised;
    // If both ends lie outside, the upper one is measured after the lower one was drawn in.
    float top = light + (largest - light) * raised;
    float lowered = top > 1.0 ? (1.0 - light) / max(top - light, 1e-6) : 1.0;
    return vec3(light) + (clipped - vec3(light)) * lowered;
}

/// Hue of b with the saturation and lightness of a; both counted from 0 to 1.
vec3 hued(vec3 a, vec3 b) {
    vec3 below = clamp(bounded_vec3(a), vec3(0.0), vec3(1.0));
    vec3 lit_as_value = lit_as((b - vec3(b.y))
        * ((max(max(below.x, below.y), below.z) - min(min(below.x, below.y), below.z))
        / (b.x - b.y)), below);
    return lit_as_value;
}

vec4 mix_colors_screen(vec4 a, vec4 b, float factor) {
    return vec4(mixed_vec3(bounded_vec3(a.xyz), bounded_vec3(a.xyz + b.xyz - a.xyz * b.xyz),
        factor), 1.0);
}

vec4 mix_colors_soft_light(vec4 a, vec4 b, float factor) {
    float soft_light_value = soft_light(a.x, b.x);
    float soft_light_value_1 = soft_light(a.y, b.y);
    return color_mixed(a, vec3(soft_light_value, soft_light_value_1, a.z - (1.0 - 2.0 * b.z) * a.z
        * (1.0 - a.z)), factor);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4(below.xyz + tone * (color.xyz - below.xyz), 1.0), vec4(0.0), vec4(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

Angle parametrization_specular_balanced(Light light, vec3 normal, vec3 view) {
    vec3 d = 2.0 * dot(normal, view) * normal - view;
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin - 0.0, u.half_cos);
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
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
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
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick_2(warped, angle_footprint(warped), shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, vec3 normal, vec3 view, float width, float softness, float follow) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of(facing), 1.0));
    vec3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    vec3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * inversesqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Gray modeling (Light layer)
    Angle gray_modeling_angle = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float gray_modeling_tone = profile_balanced(gray_modeling_angle, 0.0, gray_modeling_tone_shape);
    LitLayer gray_modeling_lit = light_apply(u_look.key, vec4(0.7059, 0.7059, 0.7059, 1.0),
        gray_modeling_tone);
    vec4 gray_modeling_blend = blend_alpha(vec4(0.1216, 0.1216, 0.1216, 1.0),
        gray_modeling_lit.color, gray_modeling_lit.tone, 1.0, true);

    // Gray lights (Light layer)
    Angle gray_lights_angle = parametrization_specular_balanced(u_look.key, surface.normal,
        surface.view);
    float gray_lights_tone = profile_balanced_2(gray_lights_angle, 0.0, gray_lights_tone_shape);
    LitLayer gray_lights_lit = light_apply(u_look.key, vec4(0.2902, 0.2902, 0.2902, 1.0),
        gray_lights_tone);
    vec4 gray_lights_blend = clamp(vec4(gray_modeling_blend.xyz + gray_lights_lit.tone
        * gray_lights_lit.color.xyz, 1.0), vec4(0.0), vec4(1.0));

    // Set alpha
    vec4 grisaille = vec4(gray_lights_blend.xyz, 1.0);
    vec4 glaze_of_green_earth = vec4(mix(grisaille.xyz,
        lit_as(vec3(0.4275, 0.5412, 0.4471), grisaille.xyz), 0.75), 1.0);
    vec4 glaze_of_sienna = vec4(mix(grisaille.xyz,
        lit_as(vec3(0.7098, 0.4667, 0.3098), grisaille.xyz), 0.7), 1.0);
    vec3 place = surface.position_object;
    VectorParts height = VectorParts(place.x, place.y, place.z);
    float toward_the_head = smoothstep(-0.5, 0.5, height.y);
    vec4 from_green_to_sienna = mix(glaze_of_green_earth, glaze_of_sienna, toward_the_head);
    vec4 warm_light = mix_colors_soft_light(from_green_to_sienna, vec4(0.9098, 0.702, 0.4157, 1.0),
        0.6);
    float curvature = surface.kappa;
    // Curvature transition
    float bulge = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.88539 * clamp(curvature * 0.06, -20.0, 20.0))));
    float hollows = mix(0.6, 0.0, min((bulge - 0.0) / 0.55, 1.0));
    vec3 mixed_vec3_value = mixed_vec3(bounded_vec3(warm_light.xyz),
        hued(warm_light.xyz, vec3(0.4902, 0.2471, 0.3608)), max(hollows, 0.0));
    // Mix colors
    vec4 wine_in_the_hollows = vec4(mixed_vec3_value, 1.0);
    float rim_2 = rim(u_look.back, surface.normal, surface.view, 0.3, 0.6, 1.0);
    vec4 cool_edge = mix_colors_screen(wine_in_the_hollows, vec4(0.4353, 0.5294, 0.6588, 1.0),
        rim_2);
    return finite_vec4(cool_edge);
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object, texel.x);
    out_color = finite_vec4(shade(surface));
}
