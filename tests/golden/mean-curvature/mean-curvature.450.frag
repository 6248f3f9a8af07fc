#version 450 core
// Curvature as color: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// mean-curvature.json says what to put there and how to draw.
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
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    float kappa;
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
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp hollow_flat_ridge = Ramp(vec4[16](vec4(0.0588, 0.1294, 0.2706, 1.0),
    vec4(0.1843, 0.3725, 0.5412, 1.0), vec4(0.7255, 0.7647, 0.7059, 1.0),
    vec4(0.9255, 0.8902, 0.7961, 1.0), vec4(0.8902, 0.749, 0.502, 1.0),
    vec4(0.7804, 0.4627, 0.1843, 1.0), vec4(1.0, 0.9529, 0.8627, 1.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.25, 0.44, 0.5), vec4(0.6, 0.8, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 0u);

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_normal;
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
    for (uint i = 1u; i < 7u; i++) {
        float places_now = places[i / 4u][i % 4u];
        at = places_now <= x ? i : at;
    }
    uint after = min(at + 1u, 6u);
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

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    float curvature = surface.kappa;
    // Curvature transition
    float from_hollow_to_ridge = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(curvature * 0.045, -20.0, 20.0))));
    vec4 base = ramp_oklab(from_hollow_to_ridge, hollow_flat_ridge);
    float half_lambert = reflectance_half_lambert(u_look.key, surface.normal);
    float in_the_dark = 1.0 - half_lambert;
    // Blend
    vec4 shade_2 = clamp(vec4(base.xyz * mix(vec3(1.0), vec3(0.42, 0.4, 0.55), in_the_dark), 1.0),
        vec4(0.0), vec4(1.0));
    return shade_2;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0).x);
    out_color = shade(surface);
}
