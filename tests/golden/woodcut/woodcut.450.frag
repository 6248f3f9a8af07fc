#version 450 core
// Woodcut: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_map 0.
// woodcut.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
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
    Light key;
    vec2 viewport;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    float kappa;
    float magnification;
    mat3x3 world_from_normal;
};
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct Strokes {
    float width;
    float length_;
    float taper;
    float wobble;
    float pressure;
    float variation;
    uint seed;
};
struct Stroke {
    float turn;
    float profile;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};
const float MOST_ON_SCREEN = 1000000000000000.0;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float whole_1 = roundEven(x);
    float f = (x - whole_1);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole_1) + 126)) << 23u)));
}

float log2_stable(float x_1) {
    uint bits = floatBitsToUint(x_1);
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

vec3 bounded_vec3_(vec3 v_2) {
    uvec3 bits_1 = floatBitsToUint(v_2);
    uvec3 magnitude = (bits_1 & uvec3(2147483647u));
    vec3 largest = uintBitsToFloat(((bits_1 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v_2, lessThan(magnitude, uvec3(2139095040u)));
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

float step_filtered(float x_3, float edge, float w) {
    float d_1 = (x_3 - edge);
    return ((w < 1e-30) ? ((d_1 >= 0.0) ? 1.0 : 0.0) : clamp((0.5 + (d_1 / w)), 0.0, 1.0));
}

mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 _e6 = normalize_moderate(toward, vec3(0.0, 0.0, 1.0));
    vec3 leaning = cross(up, _e6);
    float square_1 = dot(leaning, leaning);
    vec3 aside = ((abs(_e6.x) > 0.7) ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    vec3 across_2 = ((square_1 > 1e-8) ? leaning : cross(aside, _e6));
    vec3 _e33 = normalize_moderate((across_2 - (dot(across_2, _e6) * _e6)), vec3(1.0, 0.0, 0.0));
    return mat3x3(_e33, cross(_e6, _e33), _e6);
}

float threshold(float value, float edge_1, float softness) {
    float _e3 = footprint_of(value);
    float _e6 = step_filtered(value, edge_1, length(vec2(_e3, softness)));
    return _e6;
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_3 = uvec3(0u);
    v_3 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_3.x;
    uint _e10 = v_3.y;
    uint _e12 = v_3.z;
    v_3.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_3.y;
    uint _e18 = v_3.z;
    uint _e20 = v_3.x;
    v_3.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_3.z;
    uint _e26 = v_3.x;
    uint _e28 = v_3.y;
    v_3.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_3;
    uvec3 _e32 = v_3;
    v_3 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_3.x;
    uint _e40 = v_3.y;
    uint _e42 = v_3.z;
    v_3.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_3.y;
    uint _e48 = v_3.z;
    uint _e50 = v_3.x;
    v_3.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_3.z;
    uint _e56 = v_3.x;
    uint _e58 = v_3.y;
    v_3.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_3;
    return _e61;
}

float value_noise(vec3 p, uint seed_1) {
    int i = 0;
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 t_1 = (p - corner);
    vec3 f_1 = (((t_1 * t_1) * t_1) * ((t_1 * ((t_1 * 6.0) - vec3(15.0))) + vec3(10.0)));
    ivec3 cell = ivec3(corner);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e68 = i;
            i = (_e68 + 1);
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
        vec3 weight = mix((vec3(1.0) - f_1), f_1, equal(at_1, ivec3(1)));
        float _e44 = sum;
        uvec3 _e58 = hash_pcg3d((uvec3((cell + at_1)) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
        sum = (_e44 + (((weight.x * weight.y) * 0.5) * (vec3((_e58 >> uvec3(8u))) * 5.9604645e-8).x));
    }
    float _e71 = sum;
    return _e71;
}

float size_on_screen(float depth, float perspective, float scale) {
    return min(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(sin(angle), cos(angle));
    vec3 _e12 = bounded_vec3_(((turn.y * along) + (turn.x * across)));
    vec3 _e18 = bounded_vec3_(((turn.y * across) - (turn.x * along)));
    vec2 turned = vec2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    vec3 most = vec3(1000000000000000.0);
    vec3 stretch_1 = clamp(vec3(dot(_e12, _e12), dot(_e12, _e18), dot(_e18, _e18)), -(most), most);
    return StretchedPlace(turned, stretch_1);
}

vec3 gradient_on_picture(vec3 g, vec3 normal, vec3 view) {
    float facing = dot(normal, view);
    return (g - (normal * (dot(g, view) / ((facing >= 0.0) ? max(facing, 0.125) : min(facing, -0.125)))));
}

StretchedPlace place_on_surface(vec2 place_1, vec3 along_1, vec3 across_1, vec3 normal_1, vec3 view_1, float magnification, float angle_1) {
    float height = (1.0 / clamp(magnification, 1e-15, 1000000000000000.0));
    vec3 _e12 = gradient_on_picture(along_1, normal_1, view_1);
    vec3 _e14 = bounded_vec3_((_e12 * height));
    vec3 _e15 = gradient_on_picture(across_1, normal_1, view_1);
    vec3 _e17 = bounded_vec3_((_e15 * height));
    StretchedPlace _e18 = mark_place_of(place_1, _e14, _e17, angle_1);
    return _e18;
}

StretchedPlace place_across(vec3 axis, vec3 position, mat3x3 world_from_normal, vec3 normal_2, vec3 view_2, float magnification_1, float angle_2) {
    mat3x3 _e11 = axes_around(axis, vec3(0.0, 1.0, 0.0));
    vec2 place_5 = vec2(dot(position, _e11[0]), dot(position, _e11[2]));
    vec3 along_2 = (world_from_normal * _e11[0]);
    vec3 across_3 = (world_from_normal * _e11[2]);
    StretchedPlace _e21 = place_on_surface(place_5, along_2, across_3, normal_2, view_2, magnification_1, angle_2);
    return _e21;
}

SpacedPlace spaced(vec2 place_2, vec3 stretch, vec2 viewport, float count) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_1 = (is_pixel ? (count / max(viewport.y, 1.0)) : count);
    vec2 p_1 = clamp((place_2 * scale_1), vec2(-4194304.0), vec2(4194304.0));
    vec3 _e21 = bounded_vec3_(stretch);
    vec3 s = clamp(_e21, vec3(-1000000000000000.0), vec3(1000000000000000.0));
    return SpacedPlace(p_1, (is_pixel ? vec3(1.0, 0.0, 1.0) : s));
}

Stroke stroke_at(ivec2 line, float x_4, int zoom, Strokes style) {
    uvec3 _e12 = hash_pcg3d((uvec3(ivec3(line, 1048576)) + uvec3(1401181199u, 2842855661u, 1390592883u)));
    vec3 own_1 = (vec3((_e12 >> uvec3(8u))) * 5.9604645e-8);
    return Stroke(own_1.y, 1.0);
}

Stroke stroke_between(ivec2 line_1, float x_5, float level, Strokes style_1) {
    float zoom_2 = floor(level);
    Stroke _e6 = stroke_at(line_1, x_5, int(zoom_2), style_1);
    Stroke _e10 = stroke_at(line_1, x_5, (int(zoom_2) + 1), style_1);
    float f_2 = (level - zoom_2);
    return Stroke(mix(_e6.turn, _e10.turn, f_2), mix(1.0, 1.0, f_2));
}

float stray_at(vec2 place_3, int zoom_1, uint seed_2) {
    vec2 p_2 = (place_3 * uintBitsToFloat((uint((zoom_1 + 127)) << 23u)));
    float _e18 = value_noise(vec3((0.11 * p_2.x), (0.45 * p_2.y), 0.5), seed_2);
    return (((_e18 - 0.5) * 2.0) * uintBitsToFloat((uint((-(zoom_1) + 127)) << 23u)));
}

float band_filtered(float t, float half_, float w_1) {
    if ((w_1 < 1e-30)) {
        return (((abs(t) <= half_) && (half_ > 0.0)) ? 1.0 : 0.0);
    }
    return clamp(((clamp((t + (0.5 * w_1)), -(half_), half_) - clamp((t - (0.5 * w_1)), -(half_), half_)) / w_1), 0.0, 1.0);
}

ivec2 line_of(int whole, int octave) {
    int power = ((whole == 0) ? 1 : (whole & -(whole)));
    int octaves = (int((floatBitsToUint(float(power)) >> 23u)) - 127);
    return ((whole == 0) ? ivec2(0) : ivec2((whole / power), (octave - octaves)));
}

float hatched(vec2 place_4, float w_2, float level_1, float ink, Strokes style_2) {
    if (!((ink > 0.0))) {
        return 0.0;
    }
    float number = pow(ink, (1.0 - style_2.pressure));
    float width = (style_2.width * pow(ink, style_2.pressure));
    float zoom_3 = floor(level_1);
    float _e20 = stray_at(place_4, int(zoom_3), 7u);
    float _e25 = stray_at(place_4, (int(zoom_3) + 1), 7u);
    float stray = mix(_e20, _e25, (level_1 - zoom_3));
    float across_4 = (place_4.y + (style_2.wobble * stray));
    float _e34 = log2_stable(max(number, 1e-9));
    float density = max((level_1 + _e34), -40.0);
    float octave_1 = floor(density);
    float _e40 = exp2_stable((density - octave_1));
    float growth = (_e40 - 1.0);
    float scale_2 = uintBitsToFloat((uint((int(octave_1) + 127)) << 23u));
    float q = clamp((across_4 * scale_2), -4194304.0, 4194304.0);
    float _e57 = exp2_stable((octave_1 - level_1));
    float half_1 = ((0.5 * width) * _e57);
    float footprint = (w_2 * scale_2);
    int whole_2 = int(roundEven(q));
    ivec2 _e63 = line_of(whole_2, int(octave_1));
    Stroke _e65 = stroke_between(_e63, place_4.x, level_1, style_2);
    float middle = floor(q);
    Stroke _e77 = stroke_between(ivec2(((2 * int(middle)) + 1), (int(octave_1) + 1)), place_4.x, level_1, style_2);
    float grown = clamp(((growth - (0.75 * _e77.turn)) / 0.25), 0.0, 1.0);
    float _e91 = band_filtered((q - float(whole_2)), (half_1 * _e65.profile), footprint);
    float _e98 = band_filtered(((q - middle) - 0.5), ((half_1 * grown) * _e77.profile), footprint);
    float mean = min(((2.0 * half_1) * (1.0 + growth)), 1.0);
    return mix(max(_e91, _e98), mean, smoothstep(0.75, 1.5, footprint));
}

float cross_hatched(SpacedPlace at, float ink_1, int layers, float cross_, Strokes style_3) {
    Strokes own = Strokes(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0u);
    int i_1 = 0;
    float free = 1.0;
    vec2 x_6 = dFdx(at.place);
    vec2 y = dFdy(at.place);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e78 = i_1;
            i_1 = (_e78 + 1);
        }
        loop_init_1 = false;
        int _e14 = i_1;
        if (!((_e14 < 4))) {
            break;
        }
        int _e18 = i_1;
        if ((_e18 < 1)) {
            vec2 turn_1 = vec2(0.0, 1.0);
            vec2 along_3 = vec2(turn_1.y, turn_1.x);
            vec2 across_5 = vec2(-(turn_1.x), turn_1.y);
            float w_3 = length(vec2(dot(across_5, x_6), dot(across_5, y)));
            float square_2 = dot(vec3((across_5.x * across_5.x), ((2.0 * across_5.x) * across_5.y), (across_5.y * across_5.y)), at.stretch);
            float _e59 = log2_stable(max(max(square_2, ((at.stretch.x + at.stretch.z) / 65.0)), 1e-30));
            float level_2 = clamp((-0.5 * _e59), -16.0, 16.0);
            vec2 place_6 = vec2(dot(along_3, at.place), dot(across_5, at.place));
            own = style_3;
            own.seed = 7u;
            Strokes _e74 = own;
            float _e75 = hatched(place_6, w_3, level_2, (ink_1 - 0.0), _e74);
            free = (1.0 - _e75);
        }
    }
    float _e81 = free;
    return (1.0 - _e81);
}

MarkPlace mark_place_light(Light light, vec3 normal_3, float angle_3, vec3 view_3, vec3 position_object, mat3x3 world_from_normal_1, float magnification_2) {
    vec3 toward_1 = (light.direction * world_from_normal_1);
    StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_3);
    return MarkPlace(_e9.place, _e9.stretch);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float shade_2_ = max(((dot(surface.normal, _e5) + 0.3) / 1.3), 0.0);
    float tone = mix(0.02, 1.0, min(((shade_2_ - 0.0) / 0.8), 1.0));
    float _e24 = threshold(tone, 0.72, 0.0);
    vec4 ochre_block = mix(vec4(0.8392, 0.6039, 0.2902, 1.0), vec4(0.9529, 0.902, 0.7843, 1.0), _e24);
    Light _e38 = u_look.key;
    MarkPlace _e45 = mark_place_light(_e38, surface.normal, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    vec2 _e50 = u_look.viewport;
    SpacedPlace _e52 = spaced(_e45.place, _e45.stretch, _e50, 78.0);
    float _e67 = cross_hatched(_e52, (1.0 - min(tone, 1.0)), 1, 1.0471976, Strokes(0.62, 0.0, 0.8, 0.35, 0.85, 1.0, 7u));
    float _e70 = threshold(tone, 0.2, 0.0);
    float curvature = surface.kappa;
    float hollow_to_bulge = (0.5 + (0.5 * (1.0 - (2.0 / (1.0 + exp2((2.88539 * clamp((curvature * 0.22), -20.0, 20.0))))))));
    float _e92 = threshold(hollow_to_bulge, 0.2, 0.0);
    float _e101 = threshold(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.0);
    float black_block = max(max(_e67, (1.0 - _e70)), max((1.0 - _e92), (1.0 - _e101)));
    vec4 print = mix(ochre_block, vec4(0.1137, 0.0824, 0.0706, 1.0), black_block);
    return print;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_4 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e24 = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e28 = u_view.camera_from_world;
    float _e38 = u_view.eye.w;
    float _e43 = u_view.clip_from_world[0][1];
    float _e48 = u_view.clip_from_world[1][1];
    float _e53 = u_view.clip_from_world[2][1];
    float _e56 = size_on_screen(-((_e28 * vec4(in_.position, 1.0)).z), _e38, length(vec3(_e43, _e48, _e53)));
    mat3x3 _e59 = u_object.world_from_normal;
    Surface surface_1 = Surface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.x, _e56, _e59);
    vec4 _e61 = shade(surface_1);
    out_color = _e61;
    return;
}

