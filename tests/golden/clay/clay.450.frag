#version 450 core
// Clay: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// clay.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light window;
    Light table;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position;
    vec3 position_object;
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
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float SMALLEST_NORMAL = 1.1754944e-38;
const uint NOISE_PERLIN = 1u;
const ProfileShape body_tone_shape = ProfileShape(0.9996875, 0.024997396, 1.0955735, 1.3436927, 0.05, 1.2296002, 0.5273893, 0u);
const ProfileShape bounce_tone_shape = ProfileShape(0.99875027, 0.04997917, 1.7091175, 1.516349, 0.1, 0.70851815, 0.28734237, 0u);
const ProfileShape soft_sheen_tone_shape = ProfileShape(0.9996875, 0.024997396, 2.1865644, 2.5171125, 0.05, 0.45394465, 0.19900247, 0u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

bool is_finite(float x) {
    return ((floatBitsToUint(x) & 2139095040u) != 2139095040u);
}

vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(((largest > 1e-30) && (largest < 1e30)))) {
        return otherwise;
    }
    vec3 scaled = (v * (1.0 / largest));
    float square = dot(scaled, scaled);
    bool _e20 = is_finite(square);
    if (!(_e20)) {
        return otherwise;
    }
    return (scaled * (1.0 / sqrt(square)));
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

vec2 sin_cos_quick(float x_1) {
    float y = (x_1 * x_1);
    float s_1 = (x_1 * (1.0 + (y * (-0.16666666 + (y * (0.0083332425 + (y * (-0.0001982274 + (y * 2.6347564e-6)))))))));
    float c = (1.0 + (y * (-0.5 + (y * (0.04166666 + (y * (-0.0013888652 + (y * (2.477458e-5 - (y * 2.6297516e-7))))))))));
    return vec2(s_1, c);
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_2 = ((u_1.half_sin * t.y) - (u_1.half_cos * t.x));
    float c_1 = ((u_1.half_cos * t.y) + (u_1.half_sin * t.x));
    vec2 upper = ((c_1 <= 0.0) ? vec2(1.0, 0.0) : vec2(s_2, c_1));
    vec2 turned = (((s_2 <= 0.0) && (s_2 < c_1)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x_2) {
    uint bits = floatBitsToUint(x_2);
    uint magnitude = (bits & 2147483647u);
    float largest_1 = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest_1 : 0.0));
}

float eased(float x_3, float low, float high) {
    float _e3 = bounded(x_3);
    float _e7 = bounded(((_e3 - low) / 0.5));
    float t_2 = clamp(_e7, 0.0, 1.0);
    return ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
}

float length_of(vec3 v_2) {
    float largest_2 = max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z));
    if ((largest_2 < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e16 = bounded((largest_2 * length((v_2 / vec3(largest_2)))));
    return _e16;
}

float footprint_of_vec3_(vec3 v_3) {
    vec3 dx_1 = dFdx(v_3);
    vec3 dy_1 = dFdy(v_3);
    float _e7 = bounded(sqrt(max(dot(dx_1, dx_1), dot(dy_1, dy_1))));
    return _e7;
}

vec4 curvature_color(float convexity, vec4 convex, vec4 concave) {
    return (concave + (convexity * (convex - concave)));
}

vec3 bumped_normal(vec4 along_x, vec4 along_y, vec3 normal) {
    float _e4 = length_of(along_x.xyz);
    float _e6 = length_of(along_y.xyz);
    float largest_3 = max(_e4, _e6);
    if (((largest_3 < 1e-18) || (largest_3 > 1e18))) {
        return normal;
    }
    vec3 s_3 = (along_x.xyz / vec3(largest_3));
    vec3 t_3 = (along_y.xyz / vec3(largest_3));
    vec2 rise = clamp((vec2(along_x.w, along_y.w) / vec2(largest_3)), vec2(-1000000.0), vec2(1000000.0));
    vec3 right = cross(t_3, normal);
    vec3 up = cross(normal, s_3);
    float area = dot(s_3, right);
    if ((abs(area) < 1e-6)) {
        return normal;
    }
    vec3 slope = (((rise.x * right) + (rise.y * up)) / vec3(area));
    float steepness = length(slope);
    vec3 limited = (slope * (min(steepness, 10.0) / max(steepness, 1e-20)));
    vec3 _e50 = normalize_or((normal - limited), normal);
    return _e50;
}

vec3 bump_map(float height, float scale, vec3 normal_1, vec3 position) {
    float raised = (height * scale);
    vec3 _e5 = dFdx(position);
    float _e6 = dFdx(raised);
    vec4 along_x_1 = vec4(_e5, _e6);
    vec3 _e8 = dFdy(position);
    float _e9 = dFdy(raised);
    vec4 along_y_1 = vec4(_e8, _e9);
    vec3 _e11 = bumped_normal(along_x_1, along_y_1, normal_1);
    return _e11;
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    return clamp(vec4((below.xyz + (tone * (color.xyz - below.xyz))), 1.0), vec4(0.0), vec4(1.0));
}

LitLayer light_apply(Light light, vec4 color_1, float tone_1) {
    vec2 split = vec2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4(((color_1.xyz * light.color) * split.y), 1.0), (tone_1 * split.x));
}

Angle parametrization_specular_balanced(Light light_1, vec3 normal_2, vec3 view) {
    vec3 d_1 = (((2.0 * dot(normal_2, view)) * normal_2) - view);
    return Angle((0.5 * length((d_1 - light_1.direction))), (0.5 * length((d_1 + light_1.direction))));
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

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_4 = uvec3(0u);
    v_4 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_4.x;
    uint _e10 = v_4.y;
    uint _e12 = v_4.z;
    v_4.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_4.y;
    uint _e18 = v_4.z;
    uint _e20 = v_4.x;
    v_4.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_4.z;
    uint _e26 = v_4.x;
    uint _e28 = v_4.y;
    v_4.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_4;
    uvec3 _e32 = v_4;
    v_4 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_4.x;
    uint _e40 = v_4.y;
    uint _e42 = v_4.z;
    v_4.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_4.y;
    uint _e48 = v_4.z;
    uint _e50 = v_4.x;
    v_4.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_4.z;
    uint _e56 = v_4.x;
    uint _e58 = v_4.y;
    v_4.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_4;
    return _e61;
}

uvec3 lattice_hash(ivec3 cell, uint seed_1) {
    uvec3 _e9 = hash_pcg3d((uvec3(cell) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
    return _e9;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

vec3 fade_quintic(vec3 t_1) {
    return (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - vec3(15.0))) + vec3(10.0)));
}

float perlin_noise(vec3 p, uint seed_2) {
    float sum = 0.0;
    int i = 0;
    vec3 corner = floor(p);
    vec3 d_2 = (p - corner);
    vec3 _e4 = fade_quintic(d_2);
    ivec3 cell_1 = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e46 = i;
            i = (_e46 + 1);
        }
        loop_init = false;
        int _e10 = i;
        if ((_e10 < 8)) {
        } else {
            break;
        }
        {
            int _e13 = i;
            int _e16 = i;
            int _e21 = i;
            ivec3 at = ivec3((_e13 & 1), ((_e16 >> 1u) & 1), (_e21 >> 2u));
            vec3 weight = mix((vec3(1.0) - _e4), _e4, equal(at, ivec3(1)));
            float _e32 = sum;
            uvec3 _e39 = lattice_hash((cell_1 + at), seed_2);
            float _e42 = gradient_dot(_e39, (d_2 - vec3(at)));
            sum = (_e32 + (((weight.x * weight.y) * weight.z) * _e42));
        }
    }
    float _e48 = sum;
    return clamp((0.5 + (0.48244 * _e48)), 0.0, 1.0);
}

float fractal_noise(uint kind, vec3 p_1, int octaves, float roughness, int seed_3, float w_1) {
    float octave = 0.0;
    int i_1 = 0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum_1 = 0.0;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e66 = i_1;
            i_1 = (_e66 + 1);
        }
        loop_init_1 = false;
        int _e17 = i_1;
        if (!((_e17 < 2))) {
            break;
        }
        float _e21 = frequency;
        float _e25 = eased((w_1 * _e21), 0.5, 1.0);
        float visible = (1.0 - _e25);
        octave = 0.5;
        if ((visible > 0.0)) {
            float _e31 = frequency;
            int _e33 = i_1;
            vec3 place_1 = clamp(((p_1 * _e31) + (float(_e33) * vec3(17.31, 5.17, 11.73))), vec3(-4194304.0), vec3(4194304.0));
            int _e47 = i_1;
            float _e50 = perlin_noise(place_1, (0u + uint(_e47)));
            octave = mix(0.5, _e50, visible);
        }
        float _e53 = sum_1;
        float _e54 = strength;
        float _e55 = octave;
        sum_1 = (_e53 + (_e54 * _e55));
        float _e58 = total;
        float _e59 = strength;
        total = (_e58 + _e59);
        float _e61 = strength;
        strength = (_e61 * roughness);
        float _e63 = frequency;
        frequency = (_e63 * 2.0);
    }
    float _e69 = sum_1;
    float _e70 = total;
    return min((_e69 / _e70), 1.0);
}

float noise_perlin(vec3 position_1, float scale_1, int octaves_1, float roughness_1, int seed_4) {
    vec3 p_2 = (position_1 * scale_1);
    float _e7 = footprint_of_vec3_(p_2);
    float _e8 = fractal_noise(NOISE_PERLIN, p_2, octaves_1, roughness_1, seed_4, _e7);
    return _e8;
}

vec4 shade(Surface surface) {
    float shade_in_hollows_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.09), -20.0, 20.0))))))));
    vec4 _e30 = curvature_color(shade_in_hollows_convexity, vec4(0.851, 0.5412, 0.4, 1.0), vec4(0.6902, 0.3765, 0.2902, 1.0));
    float _e36 = noise_perlin(surface.position_object, 2.6, 2, 0.4, 0);
    vec3 _e40 = bump_map(_e36, 0.05, surface.normal, surface.position);
    vec3 _e44 = u_look.window.direction;
    vec3 _e52 = u_look.window.direction;
    Angle body_angle = Angle((0.5 * length((_e40 - _e44))), (0.5 * length((_e40 + _e52))));
    float body_warp = (((2.0 * shade_in_hollows_convexity) - 1.0) * 0.2);
    float _e65 = profile_balanced(body_angle, body_warp, body_tone_shape);
    Light _e68 = u_look.window;
    LitLayer _e69 = light_apply(_e68, _e30, _e65);
    vec4 _e79 = blend_alpha(vec4(0.3529, 0.2, 0.1529, 1.0), _e69.color, _e69.tone, 1.0, true);
    vec4 _e87 = curvature_color(shade_in_hollows_convexity, vec4(1.0), vec4(0.7216, 0.4706, 0.4235, 1.0));
    Light _e90 = u_look.window;
    LitLayer _e92 = light_apply(_e90, _e87, 1.0);
    vec4 shade_in_hollows_blend = clamp(vec4((_e79.xyz + (0.8 * ((_e79.xyz * (_e92.tone * _e92.color.xyz)) - _e79.xyz))), 1.0), vec4(0.0), vec4(1.0));
    float soft_sheen_convexity = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((surface.kappa * 0.15), -20.0, 20.0))))))));
    vec4 _e141 = curvature_color(soft_sheen_convexity, vec4(0.4157, 0.2353, 0.1804, 1.0), vec4(0.2902, 0.1412, 0.1216, 1.0));
    vec3 _e145 = u_look.table.direction;
    vec3 _e153 = u_look.table.direction;
    Angle bounce_angle = Angle((0.5 * length((_e40 - _e145))), (0.5 * length((_e40 + _e153))));
    float bounce_warp = (((2.0 * soft_sheen_convexity) - 1.0) * 0.15);
    float _e166 = profile_balanced(bounce_angle, bounce_warp, bounce_tone_shape);
    Light _e169 = u_look.table;
    LitLayer _e170 = light_apply(_e169, _e141, _e166);
    vec4 bounce_blend = clamp(vec4((shade_in_hollows_blend.xyz + (_e170.tone * _e170.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    vec4 _e194 = curvature_color(soft_sheen_convexity, vec4(0.302, 0.2039, 0.1686, 1.0), vec4(0.1647, 0.102, 0.0863, 1.0));
    Light _e197 = u_look.window;
    Angle _e199 = parametrization_specular_balanced(_e197, _e40, surface.view);
    float soft_sheen_warp = (((2.0 * soft_sheen_convexity) - 1.0) * 0.1);
    float _e207 = profile_balanced(_e199, soft_sheen_warp, soft_sheen_tone_shape);
    Light _e210 = u_look.window;
    LitLayer _e211 = light_apply(_e210, _e194, _e207);
    vec4 soft_sheen_blend = clamp(vec4((bounce_blend.xyz + (_e211.tone * _e211.color.xyz)), 1.0), vec4(0.0), vec4(1.0));
    return soft_sheen_blend;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal_3 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e25 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    Surface surface_1 = Surface(normal_3, normalize((_e8.xyz - (_e13 * in_.position))), in_.position, in_.position_object, _e25.x);
    vec4 _e28 = shade(surface_1);
    out_color = _e28;
    return;
}

