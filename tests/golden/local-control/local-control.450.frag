#version 450 core
// Light where it is wanted: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// local-control.json says what to put there and how to draw.
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
    mat3x3 camera_from_world;
    vec2 viewport;
    Light back;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 position_camera;
    vec3 curvature_tensor;
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

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const ProfileShape soft_tone_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985,
    0.68337417, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

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

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 2147483647u;
    float largest = uintBitsToFloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high) {
    float t = clamp(bounded((bounded(x) - low) / (high - low)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The length of v, also where its square would over- or underflow.
float length_of(vec3 v) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (largest < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(largest * length(v / vec3(largest)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x) {
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

/// Local light
///
/// Bends a light and changes its strength around a place on the surface, and leaves it as it is
/// elsewhere: light as an artist wants it to fall, where the real one would not.
Light local_light(Light light, vec3 bend, float strength, vec3 center, float radius, float hardness,
    vec3 position) {
    float weight = 1.0 - eased(length_of(position - center), radius * hardness, radius);
    vec3 bent = light.direction + weight * bend;
    vec3 normalize_moderate_value = normalize_moderate(bent, light.direction);
    vec3 direction = (dot(bent, bent) > 1e-6 && weight
        > 0.0) ? normalize_moderate_value : light.direction;
    return Light(direction, light.own_direction, light.color, min(light.intensity, 1e30));
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

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, vec3 normal, vec3 view, float width, float softness, float follow) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of_2(facing), 1.0));
    vec3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    vec3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * inversesqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(float width, float limit, float softness, vec3 tensor, vec3 normal,
    vec3 view, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = camera_from_world * normal;
    float square = dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    vec2 change = vec2(dFdx(radial), dFdy(radial));
    vec3 v = camera_from_world * view;
    vec3 row = dFdy(place);
    float up = (row - dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y) * inversesqrt(max(square, 1e-6));
    float pixels = height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    float footprint_of_value = footprint_of(x);
    float strength = clamp(0.5 + (x - limit)
        / length(vec2(min(footprint_of_value, 1000000000000000.0), limit * softness)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(float width, vec3 normal, vec3 view, vec2 viewport) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = width * clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance_ = facing / max(2.0 * footprint_of_2(facing), 1e-6);
    float near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * near;
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    Light turned_to_the_face = local_light(u_look.key, vec3(0.9, 0.25, 0.5), 1.0,
        vec3(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    Light around_the_belly = local_light(turned_to_the_face, vec3(0.4, 0.1, 0.35), 1.0,
        vec3(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    // Parametrization
    Angle turned_from_the_light = Angle(0.5 * length(surface.normal - around_the_belly.direction),
        0.5 * length(surface.normal + around_the_belly.direction));
    float soft_tone = profile_balanced(turned_from_the_light, 0.0, soft_tone_shape);
    float eased_value = eased(length_of(surface.position_object - vec3(0.0, 0.02, 0.45)), 0.03,
        0.3);
    // Local tone
    float shadow_under_the_chin = clamp(soft_tone + (1.0 - eased_value) * -0.45, 0.0, 1.0);
    float eased_value_1 = eased(length_of(surface.position_object - vec3(-0.2, 0.72, 0.4)), 0.085,
        0.17);
    // Local tone
    float glint_on_the_brow = clamp(shadow_under_the_chin + (1.0 - eased_value_1) * 0.5, 0.0, 1.0);
    // Threshold
    float lit = step_filtered(glint_on_the_brow, 0.55,
        length(vec2(footprint_of_2(glint_on_the_brow), 0.0)));
    vec4 light = blend_alpha(vec4(0.36, 0.36, 0.6, 1.0), vec4(0.96, 0.72, 0.47, 1.0), lit, 1.0,
        true);
    // Threshold
    float brightest = step_filtered(glint_on_the_brow, 0.97,
        length(vec2(footprint_of_2(glint_on_the_brow), 0.0)));
    // Blend
    vec4 brightest_light = min(vec4(light.xyz + brightest * (vec3(1.0, 0.93, 0.76) - light.xyz),
        1.0), vec4(1.0));
    float rim_2 = rim(u_look.back, surface.normal, surface.view, 0.3, 0.1, 1.0);
    vec4 rim_s_light = blend_alpha_2(brightest_light, vec4(0.72, 0.86, 1.0, 1.0), rim_2, 0.7, true);
    float folds = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal,
        surface.view, u_look.camera_from_world, surface.position_camera, u_look.viewport);
    // Combine tones
    float all_lines = max(outer_contour(3.0, surface.normal, surface.view, u_look.viewport), folds);
    vec4 lines = blend_alpha_2(rim_s_light, vec4(0.17, 0.13, 0.28, 1.0), all_lines, 0.85, true);
    return lines;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object, (u_view.camera_from_world * vec4(in_.position, 1.0)).xyz, texel.xyz);
    out_color = shade(surface);
}
