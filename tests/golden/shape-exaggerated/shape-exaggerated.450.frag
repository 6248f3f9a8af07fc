#version 450 core
// Exaggerated shape: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_smooth_normal_1_map 0, u_smooth_normal_2_map 1, u_smooth_normal_3_map 2, u_smooth_normal_4_map 3.
// shape-exaggerated.json says what to put there and how to draw.
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
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 smooth_normal_1_;
    vec3 smooth_normal_2_;
    vec3 smooth_normal_3_;
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

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    vec4 before;
    vec4 after;
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    float t;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp from_dusk_to_sun = Ramp(vec4[16](vec4(0.1373, 0.1647, 0.302, 1.0),
    vec4(0.4196, 0.3725, 0.5255, 1.0), vec4(0.7882, 0.5804, 0.4353, 1.0),
    vec4(0.9412, 0.8039, 0.5725, 1.0), vec4(1.0, 0.9843, 0.902, 1.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0)), vec4[4](vec4(0.05, 0.35, 0.55, 0.75), vec4(0.98, 0.0, 0.0, 0.0), vec4(0.0),
    vec4(0.0)), 5u, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_smooth_normal_1_map;

layout(binding = 1) uniform sampler2D u_smooth_normal_2_map;

layout(binding = 2) uniform sampler2D u_smooth_normal_3_map;

layout(binding = 3) uniform sampler2D u_smooth_normal_4_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = x - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * 0.5;
}

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
    return sqrt(dot(d, d));
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
float srgb_of_linear(float light) {
    float size = abs(light);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * pow(size, 0.41666666) - 0.055;
    return light < 0.0 ? -value : value;
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
vec3 oklab_of_linear(vec3 rgb) {
    float l = pow(dot(rgb, vec3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, vec3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = pow(dot(rgb, vec3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return vec3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l - 2.4285922 * m
        + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
vec3 linear_of_oklab(vec3 lab) {
    float l = lab.x + 0.39633778 * lab.y + 0.21580376 * lab.z;
    float m = lab.x - 0.105561346 * lab.y - 0.06385417 * lab.z;
    float s = lab.x - 0.08948418 * lab.y - 1.2914855 * lab.z;
    vec3 cubes = vec3(l * l * l, m * m * m, s * s * s);
    return vec3(dot(cubes, vec3(4.0767417, -3.3077116, 0.23096994)),
        dot(cubes, vec3(-1.268438, 2.6097574, -0.34131938)),
        dot(cubes, vec3(-0.0041960864, -0.7034186, 1.7076147)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
vec3 oklab_of_srgb(vec3 coded) {
    vec3 oklab_of_linear_value = oklab_of_linear(vec3(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
vec3 srgb_of_oklab(vec3 lab) {
    vec3 light = linear_of_oklab(lab);
    return vec3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
RampPlace ramp_place(Ramp ramp, float x) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint at = 0u;
    colors = ramp.colors;
    places = ramp.places;
    for (uint i = 1u; i < 5u; i++) {
        float places_now = places[i / 4u][i % 4u];
        at = places_now <= x ? i : at;
    }
    uint after = min(at + 1u, 4u);
    float place = places[at / 4u][at % 4u];
    float t = clamp(divided(x - place, places[after / 4u][after % 4u] - place), 0.0, 1.0);
    return RampPlace(colors[at], colors[after], t);
}

vec4 ramp_oklab(float value, Ramp ramp) {
    RampPlace place = ramp_place(ramp, value);
    vec3 srgb_of_oklab_value = srgb_of_oklab(mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : vec4(srgb_of_oklab_value, 1.0));
}

/// Shading of the detail that a finer normal has beyond a coarser one: -1 where the finer turns
/// from the light, 1 where it turns toward the light. The light is laid at the coarser normal's
/// horizon, so that detail is lit as well as can be, however the light falls.
float detail_lit(vec3 finer, vec3 coarser, vec3 light, float contrast) {
    vec3 across = light - dot(light, coarser) * coarser;
    // Straight under the light there is no direction along the surface, and detail fades.
    vec3 toward = across / vec3(max(length(across), 0.05));
    return clamp(contrast * dot(finer, toward), -1.0, 1.0);
}

float exaggerated_four(Light light, vec3 normal, float contrast, float detail, vec3 smooth_1,
    vec3 smooth_2, vec3 smooth_3, vec3 smooth_4) {
    float r = exp2_stable(-detail);
    vec3 n1 = normalize_moderate(smooth_1, normal);
    vec3 n2 = normalize_moderate(smooth_2, n1);
    vec3 n3 = normalize_moderate(smooth_3, n2);
    vec3 n4 = normalize_moderate(smooth_4, n3);
    float detail_lit_value = detail_lit(n3, n4, light.direction, contrast);
    float coarse = detail_lit(n2, n3, light.direction, contrast) + r
        * (detail_lit_value + r * dot(n4, light.direction));
    float detail_lit_value_1 = detail_lit(n1, n2, light.direction, contrast);
    float sum = detail_lit(normal, n1, light.direction, contrast) + r
        * (detail_lit_value_1 + r * coarse);
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r * (1.0 + r)))), 0.0, 1.0);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
float outer_contour(float width, vec3 normal, vec3 view, vec2 viewport) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float pixels = width * clamp(viewport.y, 1.0, 100000.0) / 1000.0;
    float distance_ = facing / max(2.0 * footprint_of(facing), 1e-6);
    float near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * near;
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    float every_scale_of_detail = exaggerated_four(u_look.key, surface.normal, 7.0, 0.1,
        surface.smooth_normal_1_, surface.smooth_normal_2_, surface.smooth_normal_3_,
        surface.smooth_normal_4_);
    vec4 from_dusk_to_sun_2 = ramp_oklab(every_scale_of_detail, from_dusk_to_sun);
    float ink = outer_contour(3.0, surface.normal, surface.view, u_look.viewport);
    vec4 inked = mix(from_dusk_to_sun_2, vec4(0.098, 0.1059, 0.2, 1.0), ink);
    return inked;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_smooth_normal_1_map, ivec2(in_.clip.xy), 0);
    vec4 texel_1 = texelFetch(u_smooth_normal_2_map, ivec2(in_.clip.xy), 0);
    vec4 texel_2 = texelFetch(u_smooth_normal_3_map, ivec2(in_.clip.xy), 0);
    vec4 texel_3 = texelFetch(u_smooth_normal_4_map, ivec2(in_.clip.xy), 0);
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        (vec4(texel.xyz, 0.0) * u_view.camera_from_world).xyz,
        (vec4(texel_1.xyz, 0.0) * u_view.camera_from_world).xyz,
        (vec4(texel_2.xyz, 0.0) * u_view.camera_from_world).xyz,
        (vec4(texel_3.xyz, 0.0) * u_view.camera_from_world).xyz);
    out_color = shade(surface);
}
