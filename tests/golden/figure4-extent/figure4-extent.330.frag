#version 330 core
// Curvature in the extent: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure4-extent.json says what to put there and how to draw.
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
    vec4 fill_blend;
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

const ProfileShape diffuse_tone_shape = ProfileShape(0.9921977, 0.12467473, 1.6002629, 1.3188459,
    0.25, 0.79761744, 0.31569642, 0u);

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

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
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
    Angle warped = angle_turned(angle, sin_cos_quick(0.5 * shift));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Diffuse (Light layer)
    Angle diffuse_angle = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float diffuse_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(surface.kappa * 0.3, -20.0, 20.0))));
    float diffuse_warp = (2.0 * diffuse_convexity - 1.0) * 0.75;
    float diffuse_tone = profile_balanced(diffuse_angle, diffuse_warp, diffuse_tone_shape);
    LitLayer diffuse_lit = light_apply(u_look.key, vec4(0.6275, 0.4157, 0.2902, 1.0), diffuse_tone);
    vec4 diffuse_blend = clamp(vec4(u_look.fill_blend.xyz + diffuse_lit.tone
        * diffuse_lit.color.xyz, 1.0), vec4(0.0), vec4(1.0));

    return diffuse_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0).x);
    out_color = shade(surface);
}
