#version 450 core
// Hatching: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// hatching.json says what to put there and how to draw.
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
    vec3 curvature_tensor;
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
const float SMALLEST_NORMAL = 1.1754944e-38;
const float MOST_ON_SCREEN = 1000000000000000.0;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

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

float bounded(float x_2) {
    uint bits_1 = floatBitsToUint(x_2);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec3 bounded_vec3_(vec3 v_2) {
    uvec3 bits_2 = floatBitsToUint(v_2);
    uvec3 magnitude_1 = (bits_2 & uvec3(2147483647u));
    vec3 largest_1 = uintBitsToFloat(((bits_2 & uvec3(2147483648u)) | uvec3(2139095039u)));
    vec3 numbers = mix(vec3(0.0), largest_1, equal(magnitude_1, uvec3(2139095040u)));
    return mix(numbers, v_2, lessThan(magnitude_1, uvec3(2139095040u)));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float eased(float x_3, float low, float high) {
    float t_1 = clamp(((x_3 - low) / (high - low)), 0.0, 1.0);
    return ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
}

float footprint_of(float x_4) {
    float _e1 = dFdx(x_4);
    float _e2 = dFdy(x_4);
    vec2 d = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d, d)));
    return _e6;
}

vec2 principal_curvatures(vec3 tensor) {
    float mean = (0.5 * (tensor.x + tensor.z));
    float spread = length(vec2((0.5 * (tensor.x - tensor.z)), tensor.y));
    float far = (mean + ((mean >= 0.0) ? spread : -(spread)));
    float _e26 = divided(((tensor.x * tensor.z) - (tensor.y * tensor.y)), far);
    return ((mean >= 0.0) ? vec2(far, _e26) : vec2(_e26, far));
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
    vec3 t_2 = (p - corner);
    vec3 f_1 = (((t_2 * t_2) * t_2) * ((t_2 * ((t_2 * 6.0) - vec3(15.0))) + vec3(10.0)));
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
    vec2 turn = vec2(0.0, 1.0);
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

Stroke stroke_at(ivec2 line, float x_5, int zoom, Strokes style) {
    uvec3 _e14 = hash_pcg3d((uvec3(ivec3(line, 1048576)) + (style.seed * uvec3(2654435769u, 2246822507u, 3266489909u))));
    vec3 own_1 = (vec3((_e14 >> uvec3(8u))) * 5.9604645e-8);
    float along_3 = (clamp(((x_5 * uintBitsToFloat((uint((zoom + 127)) << 23u))) / 24.0), -1000000.0, 1000000.0) + own_1.x);
    float index = floor(along_3);
    uvec3 _e48 = hash_pcg3d((uvec3(ivec3(line, int(index))) + ((style.seed + uint(zoom)) * uvec3(2654435769u, 2246822507u, 3266489909u))));
    vec3 chance = (vec3((_e48 >> uvec3(8u))) * 5.9604645e-8);
    float from_end = min((along_3 - index), (1.0 - (along_3 - index)));
    float slope = min((from_end / (0.5 * style.taper)), 1.0);
    return Stroke(chance.x, (slope * (2.0 - slope)));
}

Stroke stroke_between(ivec2 line_1, float x_6, float level, Strokes style_1) {
    float zoom_2 = floor(level);
    Stroke _e6 = stroke_at(line_1, x_6, int(zoom_2), style_1);
    Stroke _e10 = stroke_at(line_1, x_6, (int(zoom_2) + 1), style_1);
    float f_2 = (level - zoom_2);
    return Stroke(mix(_e6.turn, _e10.turn, f_2), mix(_e6.profile, _e10.profile, f_2));
}

float stray_at(vec2 place_3, int zoom_1, uint seed_2) {
    vec2 p_2 = (place_3 * uintBitsToFloat((uint((zoom_1 + 127)) << 23u)));
    float _e18 = value_noise(vec3((0.11 * p_2.x), (0.45 * p_2.y), 0.5), seed_2);
    return (((_e18 - 0.5) * 2.0) * uintBitsToFloat((uint((-(zoom_1) + 127)) << 23u)));
}

float band_filtered(float t, float half_, float w) {
    if ((w < 1e-30)) {
        return (((abs(t) <= half_) && (half_ > 0.0)) ? 1.0 : 0.0);
    }
    return clamp(((clamp((t + (0.5 * w)), -(half_), half_) - clamp((t - (0.5 * w)), -(half_), half_)) / w), 0.0, 1.0);
}

ivec2 line_of(int whole, int octave) {
    int power = ((whole == 0) ? 1 : (whole & -(whole)));
    int octaves = (int((floatBitsToUint(float(power)) >> 23u)) - 127);
    return ((whole == 0) ? ivec2(0) : ivec2((whole / power), (octave - octaves)));
}

float hatched(vec2 place_4, float w_1, float level_1, float ink, Strokes style_2) {
    if (!((ink > 0.0))) {
        return 0.0;
    }
    float number = pow(ink, 0.75);
    float width = (style_2.width * pow(ink, 0.25));
    float zoom_3 = floor(level_1);
    float _e18 = stray_at(place_4, int(zoom_3), style_2.seed);
    float _e23 = stray_at(place_4, (int(zoom_3) + 1), style_2.seed);
    float stray = mix(_e18, _e23, (level_1 - zoom_3));
    float across_4 = (place_4.y + (style_2.wobble * stray));
    float _e32 = log2_stable(max(number, 1e-9));
    float density = max((level_1 + _e32), -40.0);
    float octave_1 = floor(density);
    float _e38 = exp2_stable((density - octave_1));
    float growth = (_e38 - 1.0);
    float scale_2 = uintBitsToFloat((uint((int(octave_1) + 127)) << 23u));
    float q = clamp((across_4 * scale_2), -4194304.0, 4194304.0);
    float _e55 = exp2_stable((octave_1 - level_1));
    float half_1 = ((0.5 * width) * _e55);
    float footprint = (w_1 * scale_2);
    int whole_2 = int(roundEven(q));
    ivec2 _e61 = line_of(whole_2, int(octave_1));
    Stroke _e63 = stroke_between(_e61, place_4.x, level_1, style_2);
    float middle = floor(q);
    Stroke _e75 = stroke_between(ivec2(((2 * int(middle)) + 1), (int(octave_1) + 1)), place_4.x, level_1, style_2);
    float grown = clamp(((growth - (0.75 * _e75.turn)) / 0.25), 0.0, 1.0);
    float _e89 = band_filtered((q - float(whole_2)), (half_1 * _e63.profile), footprint);
    float _e96 = band_filtered(((q - middle) - 0.5), ((half_1 * grown) * _e75.profile), footprint);
    float mean_1 = min(((2.0 * half_1) * (1.0 + growth)), 1.0);
    return mix(max(_e89, _e96), mean_1, smoothstep(0.75, 1.5, footprint));
}

float cross_hatched(SpacedPlace at, float ink_1, int layers, float cross_, Strokes style_3) {
    Strokes own = Strokes(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0u);
    int i_1 = 0;
    float free = 1.0;
    vec2 x_8 = dFdx(at.place);
    vec2 y = dFdy(at.place);
    float amount = (ink_1 * 3.0);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e94 = i_1;
            i_1 = (_e94 + 1);
        }
        loop_init_1 = false;
        int _e16 = i_1;
        if (!((_e16 < 4))) {
            break;
        }
        int _e20 = i_1;
        if ((_e20 < 3)) {
            int _e23 = i_1;
            float x_2_ = (float(_e23) * cross_);
            vec2 turn_1 = vec2(sin(x_2_), cos(x_2_));
            vec2 along_4 = vec2(turn_1.y, turn_1.x);
            vec2 across_5 = vec2(-(turn_1.x), turn_1.y);
            float w_2 = length(vec2(dot(across_5, x_8), dot(across_5, y)));
            float square_2 = dot(vec3((across_5.x * across_5.x), ((2.0 * across_5.x) * across_5.y), (across_5.y * across_5.y)), at.stretch);
            float _e64 = log2_stable(max(max(square_2, ((at.stretch.x + at.stretch.z) / 65.0)), 1e-30));
            float level_2 = clamp((-0.5 * _e64), -16.0, 16.0);
            vec2 place_6 = vec2(dot(along_4, at.place), dot(across_5, at.place));
            own = style_3;
            int _e78 = i_1;
            own.seed = (4u + (101u * uint(_e78)));
            float _e82 = free;
            int _e83 = i_1;
            Strokes _e89 = own;
            float _e90 = hatched(place_6, w_2, level_2, clamp((amount - float(_e83)), 0.0, 1.0), _e89);
            free = (_e82 * (1.0 - _e90));
        }
    }
    float _e97 = free;
    return (1.0 - _e97);
}

MarkPlace mark_place_light(Light light, vec3 normal_3, float angle_3, vec3 view_3, vec3 position_object, mat3x3 world_from_normal_1, float magnification_2) {
    vec3 toward_1 = (light.direction * world_from_normal_1);
    StretchedPlace _e9 = place_across(toward_1, position_object, world_from_normal_1, normal_3, view_3, magnification_2, angle_3);
    return MarkPlace(_e9.place, _e9.stretch);
}

float faded_in(float x_7, float limit, float softness) {
    float _e3 = footprint_of(x_7);
    float width_1 = length(vec2(min(_e3, 1000000000000000.0), (limit * softness)));
    float _e9 = bounded(x_7);
    float _e11 = bounded((_e9 - limit));
    return clamp((0.5 + (_e11 / width_1)), 0.0, 1.0);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.35) / 1.35), 0.0);
    float tone_to_draw = mix(0.04, 1.0, min(((light_and_shade - 0.0) / 0.85), 1.0));
    Light _e24 = u_look.key;
    MarkPlace _e31 = mark_place_light(_e24, surface.normal, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    vec2 _e36 = u_look.viewport;
    SpacedPlace _e38 = spaced(_e31.place, _e31.stretch, _e36, 120.0);
    float _e53 = cross_hatched(_e38, (1.0 - min(tone_to_draw, 1.0)), 3, 0.8, Strokes(0.42, 24.0, 0.6, 0.45, 0.25, 1.0, 4u));
    float _e62 = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.34, 0.2);
    float ink_2 = max(_e53, _e62);
    vec2 _e65 = principal_curvatures(surface.curvature_tensor);
    float _e70 = faded_in(-(_e65.y), 75.0, 0.3);
    float features = (_e70 * smoothstep(0.05, 0.3, dot(surface.normal, surface.view)));
    float strokes_and_features = max(ink_2, features);
    vec4 pen_on_paper = mix(vec4(0.965, 0.937, 0.875, 1.0), vec4(0.12, 0.105, 0.16, 1.0), strokes_and_features);
    return pen_on_paper;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal_4 = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e24 = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    mat4x4 _e28 = u_view.camera_from_world;
    float _e38 = u_view.eye.w;
    float _e43 = u_view.clip_from_world[0][1];
    float _e48 = u_view.clip_from_world[1][1];
    float _e53 = u_view.clip_from_world[2][1];
    float _e56 = size_on_screen(-((_e28 * vec4(in_.position, 1.0)).z), _e38, length(vec3(_e43, _e48, _e53)));
    mat3x3 _e59 = u_object.world_from_normal;
    Surface surface_1 = Surface(normal_4, normalize((_e8.xyz - (_e13 * in_.position))), in_.position_object, _e24.xyz, _e56, _e59);
    vec4 _e61 = shade(surface_1);
    out_color = _e61;
    return;
}

