#version 300 es
// Chalk: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// chalk-board.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light back;
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    float kappa;
    vec2 pixel;
    vec3 anchor;
};
struct Angle {
    float half_sin;
    float half_cos;
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
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct PaperGrain {
    float tone;
    float height;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const float MOST_ON_SCREEN = 1000000000000000.0;
const ProfileShape orange_chalk_shape = ProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    int exponent = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w_2 = (2.0 * sqrt((dot(dx, dx) + dot(dy, dy))));
    return min(w_2, 0.5);
}

Angle angle_turned(Angle u_1, vec2 t) {
    float s_1 = (u_1.half_sin - 0.0);
    vec2 upper = ((u_1.half_cos <= 0.0) ? vec2(1.0, 0.0) : vec2(s_1, u_1.half_cos));
    vec2 turned = (((s_1 <= 0.0) && (s_1 < u_1.half_cos)) ? vec2(0.0, 1.0) : upper);
    return Angle(turned.x, turned.y);
}

float bounded(float x_1) {
    uint bits_1 = floatBitsToUint(x_1);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float profile_soft_quick(float s, ProfileShape shape) {
    float q = (s * shape.scale);
    return ((s <= 0.0) ? 1.0 : pow(max((1.0 - (q * q)), 0.0), shape.exponent));
}

float profile_filtered_quick(Angle u_2, float w, ProfileShape shape_1) {
    vec2 place_6 = vec2(((u_2.half_sin * shape_1.half_cos_offset) - (u_2.half_cos * shape_1.half_sin_offset)), ((u_2.half_cos * shape_1.half_cos_offset) + (u_2.half_sin * shape_1.half_sin_offset)));
    float _e19 = profile_soft_quick(place_6.x, shape_1);
    if ((w < (0.1 * shape_1.edge_deviation))) {
        return _e19;
    }
    float r = (0.19364917 * w);
    vec2 turn = vec2((r * (1.0 - ((0.16666667 * r) * r))), (1.0 - ((0.5 * r) * r)));
    float _e45 = profile_soft_quick(((place_6.x * turn.y) - (place_6.y * turn.x)), shape_1);
    float _e53 = profile_soft_quick(((place_6.x * turn.y) + (place_6.y * turn.x)), shape_1);
    return ((((5.0 * _e45) + (8.0 * _e19)) + (5.0 * _e53)) / 18.0);
}

float profile_balanced(Angle angle, float shift, ProfileShape shape_2) {
    Angle _e6 = angle_turned(angle, vec2(0.0, 1.0));
    float _e7 = angle_footprint(_e6);
    float _e8 = profile_filtered_quick(_e6, _e7, shape_2);
    return _e8;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_2 = uvec3(0u);
    v_2 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_2.x;
    uint _e10 = v_2.y;
    uint _e12 = v_2.z;
    v_2.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_2.y;
    uint _e18 = v_2.z;
    uint _e20 = v_2.x;
    v_2.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_2.z;
    uint _e26 = v_2.x;
    uint _e28 = v_2.y;
    v_2.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_2;
    uvec3 _e32 = v_2;
    v_2 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_2.x;
    uint _e40 = v_2.y;
    uint _e42 = v_2.z;
    v_2.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_2.y;
    uint _e48 = v_2.z;
    uint _e50 = v_2.x;
    v_2.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_2.z;
    uint _e56 = v_2.x;
    uint _e58 = v_2.y;
    v_2.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_2;
    return _e61;
}

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a = ((axis == 0u) ? d.y : d.x);
    float b = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a : -(a)) + (((hash.z >> 31u) == 0u) ? b : -(b)));
}

float perlin_noise(vec3 p, uint seed_1) {
    int i = 0;
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 d_1 = (p - corner);
    vec3 f = (((d_1 * d_1) * d_1) * ((d_1 * ((d_1 * 6.0) - vec3(15.0))) + vec3(10.0)));
    ivec3 cell = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e64 = i;
            i = (_e64 + 1);
        }
        loop_init = false;
        int _e21 = i;
        if (!((_e21 < 8))) {
            break;
        }
        int _e25 = i;
        int _e28 = i;
        int _e33 = i;
        ivec3 at_1 = ivec3((_e25 & 1), ((_e28 >> 1u) & 1), (_e33 >> 2u));
        vec3 weight = mix((vec3(1.0) - f), f, equal(at_1, ivec3(1)));
        float _e44 = sum;
        uvec3 _e58 = hash_pcg3d((uvec3((cell + at_1)) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
        float _e61 = gradient_dot(_e58, (d_1 - vec3(at_1)));
        sum = (_e44 + (((weight.x * weight.y) * 0.5) * _e61));
    }
    float _e67 = sum;
    return clamp((0.5 + (0.48244 * _e67)), 0.0, 1.0);
}

float size_on_screen(float depth, float perspective, float scale) {
    return min(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

vec3 anchor_on_screen(vec3 origin, float perspective_1, float scale_1) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(vec3((origin.x * _e5), (-(origin.y) * _e5), _e5), vec3(-1000000000000000.0), vec3(1000000000000000.0));
}

vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 from_middle = (pixel - (0.5 * viewport));
    return (vec2(from_middle.x, -(from_middle.y)) / vec2(max(viewport.y, 1.0)));
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle_1) {
    vec2 turn_1 = vec2(0.0, 1.0);
    vec3 x_2 = ((turn_1.y * along) + (turn_1.x * across));
    vec3 y = ((turn_1.y * across) - (turn_1.x * along));
    vec2 turned_1 = vec2(((turn_1.y * place.x) + (turn_1.x * place.y)), ((turn_1.y * place.y) - (turn_1.x * place.x)));
    vec3 stretch_5 = vec3(dot(x_2, x_2), dot(x_2, y), dot(y, y));
    return StretchedPlace(turned_1, stretch_5);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    vec2 p_1 = clamp((place_1 * scale_2), vec2(-4194304.0), vec2(4194304.0));
    return SpacedPlace(p_1, (is_pixel ? vec3(1.0, 0.0, 1.0) : stretch));
}

float area_square(vec3 stretch_1) {
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
}

MarkPlace mark_place_object(float angle_2, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    vec2 _e8 = place_in_picture(pixel_1, viewport_2);
    vec2 place_7 = ((_e8 - vec2(anchor.x, -(anchor.y))) / vec2(size));
    StretchedPlace _e26 = mark_place_of(place_7, vec3((1.0 / size), 0.0, 0.0), vec3(0.0, (1.0 / size), 0.0), angle_2);
    return MarkPlace(_e26.place, _e26.stretch);
}

float paper_octave(vec2 place_2, int zoom, float w_1, float fiber, uint seed_2) {
    float scale_3 = uintBitsToFloat((uint((zoom + 127)) << 23u));
    vec2 p_2 = clamp((place_2 * scale_3), vec2(-4194304.0), vec2(4194304.0));
    uint own = (seed_2 + (7u * uint(zoom)));
    float _e23 = perlin_noise(vec3(p_2, 0.5), own);
    float grain = (_e23 - 0.5);
    vec2 q_1 = clamp((2.7 * vec2(((0.8 * p_2.x) - (0.6 * p_2.y)), ((0.6 * p_2.x) + (0.8 * p_2.y)))), vec2(-4194304.0), vec2(4194304.0));
    float _e52 = perlin_noise(vec3(q_1, 0.5), (own + 1u));
    float felt = (_e52 - 0.5);
    float coarse_seen = (1.0 - smoothstep(0.5, 1.0, (w_1 * scale_3)));
    float felt_seen = (1.0 - smoothstep(0.5, 1.0, ((2.7 * w_1) * scale_3)));
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

float paper_height(SpacedPlace at, float fiber_1, uint seed_3) {
    float height = 0.0;
    vec2 x_3 = dFdx(at.place);
    vec2 y_1 = dFdy(at.place);
    float w_3 = sqrt(max(dot(x_3, x_3), dot(y_1, y_1)));
    float _e12 = area_square(at.stretch);
    float _e16 = log2_stable(max(sqrt(_e12), 1e-30));
    float level = clamp((-0.5 * _e16), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    float _e26 = paper_octave(at.place, int(zoom_1), w_3, fiber_1, seed_3);
    height = _e26;
    if ((f_1 > 0.0)) {
        float _e30 = height;
        float _e35 = paper_octave(at.place, (int(zoom_1) + 1), w_3, fiber_1, seed_3);
        float both = mix(_e30, _e35, f_1);
        height = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain paper_grain(float value, vec2 place_3, vec3 stretch_2, float count_1, float tooth, float fiber_2, int seed_4, vec2 viewport_3) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_1);
    float _e10 = paper_height(_e8, fiber_2, 5u);
    float ink = (1.0 - value);
    return PaperGrain((1.0 - clamp((ink + ((((8.0 * tooth) * (_e10 - 0.5)) * ink) * (1.0 - ink))), 0.0, 1.0)), _e10);
}

PaperGrain paper_grain_2_(float value_1, vec2 place_4, vec3 stretch_3, float count_2, float tooth_1, float fiber_3, int seed_5, vec2 viewport_4) {
    SpacedPlace _e8 = spaced(place_4, stretch_3, viewport_4, count_2);
    float _e10 = paper_height(_e8, fiber_3, 9u);
    float ink_1 = (1.0 - value_1);
    return PaperGrain((1.0 - clamp((ink_1 + ((((8.0 * tooth_1) * (_e10 - 0.5)) * ink_1) * (1.0 - ink_1))), 0.0, 1.0)), _e10);
}

PaperGrain paper_grain_3_(float value_2, vec2 place_5, vec3 stretch_4, float count_3, float tooth_2, float fiber_4, int seed_6, vec2 viewport_5) {
    SpacedPlace _e8 = spaced(place_5, stretch_4, viewport_5, count_3);
    float _e10 = paper_height(_e8, fiber_4, 3u);
    float ink_2 = (1.0 - max(value_2, 0.0));
    return PaperGrain((1.0 - clamp((ink_2 + ((((8.0 * tooth_2) * (_e10 - 0.5)) * ink_2) * (1.0 - ink_2))), 0.0, 1.0)), _e10);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e5) + 0.15) / 1.15), 0.0);
    float tone = min(((shade_2_ - 0.0) / 0.9), 1.0);
    float rubbed = mix(0.05, 0.5, min(((tone - 0.0) / 0.6), 1.0));
    float r_bare = (1.0 - rubbed);
    vec2 _e35 = u_look.viewport;
    MarkPlace _e36 = mark_place_object(0.0, surface.anchor, surface.pixel, _e35);
    vec2 _e45 = u_look.viewport;
    PaperGrain _e46 = paper_grain(r_bare, _e36.place, _e36.stretch, 120.0, 0.6, 0.5, 5, _e45);
    float _e50 = bounded((1.0 - _e46.tone));
    vec4 blue_gray = mix(vec4(0.1216, 0.1647, 0.1686, 1.0), vec4(0.4275, 0.5098, 0.5647, 1.0), _e50);
    vec3 _e66 = u_look.back.direction;
    vec3 _e75 = u_look.back.direction;
    Angle turn_2 = Angle((0.5 * length((surface.normal - _e66))), (0.5 * length((surface.normal + _e75))));
    float _e83 = profile_balanced(turn_2, 0.0, orange_chalk_shape);
    float o_bare = (1.0 - _e83);
    vec2 _e94 = u_look.viewport;
    PaperGrain _e95 = paper_grain_2_(o_bare, _e36.place, _e36.stretch, 220.0, 0.8, 0.5, 9, _e94);
    float _e104 = bounded((1.0 - _e95.tone));
    vec4 orange = mix(blue_gray, vec4(0.9412, 0.6353, 0.3608, 1.0), _e104);
    float curvature = surface.kappa;
    float hollow_to_bulge = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.16), -20.0, 20.0))))))));
    float bare_in_hollows = mix(0.1, 1.0, clamp(((hollow_to_bulge - 0.15) / 0.35), 0.0, 1.0));
    float white_chalk = (tone * bare_in_hollows);
    float w_bare = (1.0 - white_chalk);
    vec2 _e146 = u_look.viewport;
    PaperGrain _e147 = paper_grain_3_(w_bare, _e36.place, _e36.stretch, 260.0, 0.62, 0.5, 3, _e146);
    float _e156 = bounded((1.0 - _e147.tone));
    vec4 white = mix(orange, vec4(0.9686, 0.9529, 0.9098, 1.0), _e156);
    return white;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    vec4 _e11 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    vec4 _e17 = u_view.screen;
    vec4 _e22 = u_view.screen;
    mat4x4 _e27 = u_view.camera_from_world;
    vec4 _e31 = u_object.world_from_object[3];
    float _e40 = u_view.eye.w;
    float _e45 = u_view.clip_from_world[0][1];
    float _e50 = u_view.clip_from_world[1][1];
    float _e55 = u_view.clip_from_world[2][1];
    vec3 _e58 = anchor_on_screen((_e27 * vec4(_e31.xyz, 1.0)).xyz, _e40, length(vec3(_e45, _e50, _e55)));
    Surface surface_1 = Surface(normal, _e11.x, ((in_.clip.xy * _e17.xy) + _e22.zw), _e58);
    vec4 _e60 = shade(surface_1);
    out_color = _e60;
    return;
}

