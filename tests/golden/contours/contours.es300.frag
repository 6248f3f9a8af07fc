#version 300 es
// Contours: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0, u_smooth_normal_4_map 1.
// contours.json says what to put there and how to draw.

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
    vec2 viewport;
    mat3x3 camera_from_world;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_camera;
    vec3 curvature_tensor;
    vec3 smooth_normal_4_;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    vec4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    vec4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp three_washes = Ramp(vec4[16](vec4(0.7255, 0.7686, 0.8118, 1.0),
    vec4(0.8627, 0.8627, 0.8235, 1.0), vec4(0.9725, 0.949, 0.8863, 1.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.16, 0.42, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 3u, 2u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_tensor_map;

uniform highp sampler2D u_smooth_normal_4_map;

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 2147483647u;
    float largest = uintBitsToFloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// a / b; 0 where b is 0.
float divided(float a, float b) {
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
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

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
vec4 ramp_at(Ramp ramp, float x, float w) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    color = colors[0];
    for (uint i = 1u; i < 3u; i++) {
        color = color + (colors[i] - colors[i - 1u]) * step_filtered(x, places[0][i % 4u], w);
    }
    return color;
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
vec2 principal_curvatures(vec3 tensor) {
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = length(vec2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? vec2(far, near) : vec2(near, far);
}

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
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
    float pixels = 1.5 * height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    float strength = clamp(0.5 + (x - limit)
        / length(vec2(min(footprint_of(x), 1000000000000000.0), 22.0)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
float faded_in(float x, float limit, float softness) {
    float width = length(vec2(min(footprint_of(x), 1000000000000000.0), 45.0));
    return clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
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
    vec3 broad_forms = normalize_moderate(surface.smooth_normal_4_, surface.normal);
    float light_and_dark = reflectance_half_lambert(u_look.key, broad_forms);
    vec4 three_washes_2 = ramp_at(three_washes, light_and_dark, footprint_of_2(light_and_dark));
    float faded_in_value = faded_in(-principal_curvatures(surface.curvature_tensor).y, 45.0, 1.0);
    // Inner contour
    float hollows = faded_in_value * smoothstep(0.05, 0.3, dot(surface.normal, surface.view));
    vec4 hollows_in_sepia = mix(three_washes_2, vec4(0.6588, 0.5294, 0.4235, 1.0), hollows);
    float inner_lines = inner_contour_suggestive(3.0, 22.0, 1.0, surface.curvature_tensor,
        surface.normal, surface.view, u_look.camera_from_world, surface.position_camera,
        u_look.viewport);
    float outline = outer_contour(5.0, surface.normal, surface.view, u_look.viewport);
    float all_lines = max(inner_lines, outline);
    vec4 ink = mix(hollows_in_sepia, vec4(0.1647, 0.1412, 0.1882, 1.0), all_lines);
    return ink;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    vec4 texel_1 = texelFetch(u_smooth_normal_4_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        (u_view.camera_from_world * vec4(in_.position, 1.0)).xyz, texel.xyz,
        (vec4(texel_1.xyz, 0.0) * u_view.camera_from_world).xyz);
    out_color = shade(surface);
}
