#version 330 core
// Lantern: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// lantern.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
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
const Ramp glow = Ramp(vec4[16](vec4(0.851, 0.4118, 0.1647, 1.0), vec4(1.0, 0.7804, 0.3961, 1.0),
    vec4(1.0, 0.9647, 0.8471, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.45, 1.0, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 3u, 0u);

layout(std140) uniform ViewBlock { View u_view; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

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

/// [`oklab_of_linear`] of an sRGB-coded color.
vec3 oklab_of_srgb_2(vec3 coded) {
    return oklab_of_linear(vec3(1.0, pow((coded.y + 0.055) / 1.055, 2.4),
        pow((coded.z + 0.055) / 1.055, 2.4)));
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
    for (uint i = 1u; i < 3u; i++) {
        float places_now = places[0][i % 4u];
        at = places_now <= x ? i : at;
    }
    uint after = min(at + 1u, 2u);
    float place = places[0][at % 4u];
    float t = clamp(divided(x - place, places[0][after % 4u] - place), 0.0, 1.0);
    return RampPlace(colors[at], colors[after], t);
}

vec4 ramp_oklab(float value, Ramp ramp) {
    RampPlace place = ramp_place(ramp, value);
    vec3 srgb_of_oklab_value = srgb_of_oklab(mix(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb_2(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : vec4(srgb_of_oklab_value, 1.0));
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    vec4 glow_2 = ramp_oklab(clamp(dot(surface.normal, surface.view), 0.0, 1.0), glow);
    return glow_2;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position));
    out_color = shade(surface);
}
