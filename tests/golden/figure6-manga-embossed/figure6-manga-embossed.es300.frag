#version 300 es
// Manga, embossed: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure6-manga-embossed.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light above;
    mat3x3 camera_from_world;
    Light below;
};
struct Surface {
    vec3 normal;
    float kappa;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct LitLayer {
    vec4 color;
    float tone;
};
struct ProfileShape {
    float half_cos_offset;
    float half_sin_offset;
    float scale;
    float exponent;
    float offset;
    float edge_mean;
    float edge_deviation;
    uint kind;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const ProfileShape dark_side_tone_shape = ProfileShape(0.9624252, 0.27154693, 5.0334897, 2.4651666, 0.55, 0.19658314, 0.08474467, 0u);
const ProfileShape light_side_tone_shape = ProfileShape(0.9689124, 0.24740396, 5.743557, 2.3650649, 0.5, 0.17491564, 0.07484149, 0u);

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y = (x * x);
    float s_2 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_2, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_3 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_3, c_1));
    vec2 turned = (((s_3 <= 0.0) && (s_3 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
}

Angle parametrization_screen_aligned_balanced(Light light_1, vec3 normal, mat3x3 camera_from_world) {
    vec3 d = (camera_from_world * normal);
    return Angle((0.5 * length((d - light_1.own_direction))), (0.5 * length((d + light_1.own_direction))));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_ramp_quick(float s_1, float w, ProfileShape shape_1) {
    float width = sqrt(((w * w) + ((12.0 * shape_1.edge_deviation) * shape_1.edge_deviation)));
    float from_offset = (s_1 * (2.0 + ((s_1 * s_1) * 0.33333334)));
    float ramp = clamp((0.5 + ((shape_1.edge_mean - from_offset) / width)), 0.0, 1.0);
    return ((w <= 0.0) ? ((s_1 <= 4e-7) ? 1.0 : 0.0) : ramp);
}

float profile_filtered_quick(Angle u_2, float w_1, ProfileShape shape_2) {
    vec2 place = vec2(((u_2.half_sin * shape_2.half_cos_offset) - (u_2.half_cos * shape_2.half_sin_offset)), ((u_2.half_cos * shape_2.half_cos_offset) + (u_2.half_sin * shape_2.half_sin_offset)));
    bool is_narrow = ((w_1 > 0.0) && (w_1 >= (3.4641016 * shape_2.edge_deviation)));
    if ((false || is_narrow)) {
        float _e28 = profile_ramp_quick(place.x, w_1, shape_2);
        return _e28;
    }
    float _e30 = profile_soft_quick(place.x, shape_2);
    if ((w_1 < (0.1 * shape_2.edge_deviation))) {
        return _e30;
    }
    float r = (0.19364917 * w_1);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e56 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_2);
    float _e64 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_2);
    return ((((5.0 * _e56) + (8.0 * _e30)) + (5.0 * _e64)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_3) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_3);
    return _e8;
}

vec4 shade(Surface surface) {
    float light_side_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.3), -20.0, 20.0))))))));
    vec4 _e30 = curvature_color(light_side_convexity, vec4(0.4275, 0.4078, 0.4745, 1.0), vec4(0.2275, 0.2078, 0.2784, 1.0));
    Light _e33 = u_look.below;
    mat3x3 _e37 = u_look.camera_from_world;
    Angle _e38 = parametrization_screen_aligned_balanced(_e33, surface.normal, _e37);
    float light_side_warp = (((2.0 * light_side_convexity) - 1.0) * 0.35);
    float _e46 = profile_balanced(_e38, light_side_warp, dark_side_tone_shape);
    Light _e49 = u_look.below;
    LitLayer _e50 = light_apply(_e49, _e30, _e46);
    vec4 dark_side_blend = clamp(vec4((vec3(0.851, 0.8314, 0.7804) * mix(vec3(1.0), _e50.color.xyz, _e50.tone)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e76 = curvature_color(light_side_convexity, vec4(1.0), vec4(0.9529, 0.9176, 0.8471, 1.0));
    Light _e79 = u_look.above;
    mat3x3 _e83 = u_look.camera_from_world;
    Angle _e84 = parametrization_screen_aligned_balanced(_e79, surface.normal, _e83);
    float _e86 = profile_balanced(_e84, light_side_warp, light_side_tone_shape);
    Light _e89 = u_look.above;
    LitLayer _e90 = light_apply(_e89, _e76, _e86);
    vec4 light_side_blend = clamp(vec4((dark_side_blend.xyz + (_e90.tone * (_e90.color.xyz - dark_side_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float hollows_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.4), -20.0, 20.0))))))));
    vec4 _e132 = curvature_color(hollows_convexity, vec4(1.0), vec4(0.4667, 0.4392, 0.5412, 1.0));
    Light _e135 = u_look.above;
    LitLayer _e137 = light_apply(_e135, _e132, 1.0);
    vec4 hollows_blend = clamp(vec4((light_side_blend.xyz + (0.8 * ((light_side_blend.xyz * (_e137.tone * _e137.color.xyz)) - light_side_blend.xyz))), 1.0), vec4(0.0), vec4(1.0));
    return hollows_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_1 = (is_front ? _e3 : -(_e3));
    vec4 _e11 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_1, _e11.x);
    vec4 _e14 = shade(surface_1);
    out_color = _e14;
    return;
}

