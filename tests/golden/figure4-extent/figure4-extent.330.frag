#version 330 core
// Curvature in the extent: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// figure4-extent.json says what to put there and how to draw.
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light key;
    vec4 fill_blend;
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
const ProfileShape diffuse_tone_shape = ProfileShape(0.9921977, 0.12467473, 1.6002629, 1.3188459, 0.25, 0.79761744, 0.31569642, 0u);

layout(std140) uniform LookBlock { Look u_look; };

uniform sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec3 normalize_seen_balanced(vec3 v) {
    return (v * inversesqrt(max(dot(v, v), 1e-30)));
}

vec2 sin_cos_quick(float x) {
    float y = (x * x);
    float s_1 = (x * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_1, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_1 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_1, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

LitLayer light_apply(Light light, vec4 color, float tone) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color.xyz * light.color) * split.y), 1.0), (tone * split.x));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1) {
    vec2 place = vec2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    float _e19 = profile_soft_quick(place.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place.x * turn.y) - (place.y * turn.x)), shape_1);
    float _e53 = profile_soft_quick(((place.x * turn.y) + (place.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2) {
    vec2 _e5 = sin_cos_quick((0.5 * shift));
    Angle _e6 = angle_turned(angle, _e5);
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle diffuse_angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float diffuse_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.3), -20.0, 20.0))))))));
    float diffuse_warp = (((2.0 * diffuse_convexity) - 1.0) * 0.75);
    float _e46 = profile_balanced(diffuse_angle, diffuse_warp, diffuse_tone_shape);
    Light _e49 = u_look.key;
    LitLayer _e55 = light_apply(_e49, vec4(0.6275, 0.4157, 0.2902, 1.0), _e46);
    vec4 _e58 = u_look.fill_blend;
    vec4 diffuse_blend = clamp(vec4((_e58.xyz + (_e55.tone * _e55.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return diffuse_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    vec4 _e11 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal, _e11.x);
    vec4 _e14 = shade(surface_1);
    out_color = _e14;
    return;
}

