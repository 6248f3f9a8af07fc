#version 300 es
// Paper wash: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// paper-wash.json says what to put there and how to draw.

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
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    vec2 pixel;
    vec3 anchor;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
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
const float SMALLEST_NORMAL = 1.1754944e-38;
const float MOST_ON_SCREEN = 1000000000000000.0;
const Ramp indigo_to_warm_paper = Ramp(vec4[16](vec4(0.13, 0.14, 0.33, 1.0), vec4(0.24, 0.36, 0.56, 1.0), vec4(0.53, 0.66, 0.72, 1.0), vec4(0.9, 0.8, 0.68, 1.0), vec4(0.975, 0.95, 0.9, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.35, 0.62, 0.82), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    int exponent_1 = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent_1) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent_1) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

vec3 normalize_moderate(vec3 v_1, vec3 otherwise) {
    float square = dot(v_1, v_1);
    return ((square > 1e-30) ? (v_1 * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_2) {
    vec3 _e5 = normalize_moderate(v_2, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_1) {
    uint bits_1 = floatBitsToUint(x_1);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec4 bounded_vec4_(vec4 v_3) {
    uvec4 bits_2 = floatBitsToUint(v_3);
    uvec4 magnitude_1 = (bits_2 & uvec4(2147483647u));
    vec4 largest_1 = uintBitsToFloat(((bits_2 & uvec4(2147483648u)) | uvec4(2139095039u)));
    vec4 numbers = mix(vec4(0.0), largest_1, equal(magnitude_1, uvec4(2139095040u)));
    return mix(numbers, v_3, lessThan(magnitude_1, uvec4(2139095040u)));
}

float divided(float a, float b) {
    if ((abs(b) < SMALLEST_NORMAL)) {
        return 0.0;
    }
    float _e7 = bounded((a / b));
    return _e7;
}

float footprint_of(float x_2) {
    float _e1 = dFdx(x_2);
    float _e2 = dFdy(x_2);
    vec2 d_1 = vec2(_e1, _e2);
    float _e6 = bounded(sqrt(dot(d_1, d_1)));
    return _e6;
}

float footprint_of_2_(float x_3) {
    float _e1 = dFdx(x_3);
    float _e2 = dFdy(x_3);
    vec2 d_2 = vec2(_e1, _e2);
    return sqrt(dot(d_2, d_2));
}

float stairs_integral(float x_4, float count) {
    float inside = min(x_4, count);
    float stair = min(floor(inside), 3.0);
    float beyond = max((x_4 - count), 0.0);
    return ((stair * (((0.5 * (stair - 1.0)) + inside) - stair)) + (beyond * 3.0));
}

float stairs_integral_2_(float x_5, float count_1) {
    float inside_1 = max(x_5, 0.0);
    float stair_1 = floor(inside_1);
    return ((stair_1 * (((0.5 * (stair_1 - 1.0)) + inside_1) - stair_1)) + 0.0);
}

float stairs_filtered(float x_6, float count_2, float w) {
    if ((w <= 1.0)) {
        float edge = clamp(roundEven(x_6), 1.0, 3.0);
        return ((edge - 1.0) + clamp((0.5 + ((x_6 - edge) / w)), 0.0, 1.0));
    }
    float half_ = (0.5 * w);
    float _e22 = stairs_integral((x_6 + half_), count_2);
    float _e24 = stairs_integral_2_((x_6 - half_), count_2);
    return ((_e22 - _e24) / (2.0 * half_));
}

vec4 hermite(vec4 a_1, vec4 b_1, vec4 from_a, vec4 to_b, float t) {
    vec4 d_3 = (b_1 - a_1);
    return (a_1 + (t * (from_a + (t * ((((3.0 * d_3) - (2.0 * from_a)) - to_b) + (t * ((from_a + to_b) - (2.0 * d_3))))))));
}

float harmonic_slope(float before, float span_before, float after, float span_after) {
    if (((before * after) <= 0.0)) {
        return 0.0;
    }
    float weight_before = ((2.0 * span_after) + span_before);
    float weight_after = (span_after + (2.0 * span_before));
    float _e18 = divided((weight_before + weight_after), ((weight_before / before) + (weight_after / after)));
    return _e18;
}

vec4 ramp_slope(vec4 rise_before, float span_before_1, vec4 rise_after, float span_after_1) {
    float _e5 = divided(rise_before.x, span_before_1);
    float _e7 = divided(rise_after.x, span_after_1);
    float _e8 = harmonic_slope(_e5, span_before_1, _e7, span_after_1);
    float _e10 = divided(rise_before.y, span_before_1);
    float _e12 = divided(rise_after.y, span_after_1);
    float _e13 = harmonic_slope(_e10, span_before_1, _e12, span_after_1);
    float _e15 = divided(rise_before.z, span_before_1);
    float _e17 = divided(rise_after.z, span_after_1);
    float _e18 = harmonic_slope(_e15, span_before_1, _e17, span_after_1);
    float _e20 = divided(rise_before.w, span_before_1);
    float _e22 = divided(rise_after.w, span_after_1);
    float _e23 = harmonic_slope(_e20, span_before_1, _e22, span_after_1);
    return vec4(_e8, _e13, _e18, _e23);
}

vec4 ramp_at(Ramp ramp, float x_7, float w_1) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint i_2_ = 1u;
    uint at = 0u;
    vec4 from_a_1 = vec4(0.0);
    vec4 to_b_1 = vec4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e28 = i_2_;
            i_2_ = (_e28 + 1u);
        }
        loop_init = false;
        uint _e11 = i_2_;
        if (!((_e11 < 5u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places[(_e17 / 4u)][(_e21 % 4u)];
        at = ((_e25 <= x_7) ? _e16 : _e15);
    }
    uint _e31 = at;
    uint _e35 = at;
    float place_5 = places[(_e31 / 4u)][(_e35 % 4u)];
    uint _e40 = at;
    if ((((_e40 + 1u) >= 5u) || (x_7 <= place_5))) {
        uint _e47 = at;
        vec4 _e49 = colors[_e47];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = (_e50 + 1u);
    float _e59 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span = (_e59 - place_5);
    float _e62 = divided((x_7 - place_5), span);
    float t_1 = clamp(_e62, 0.0, 1.0);
    uint _e69 = at;
    if ((_e69 > 0u)) {
        uint _e72 = at;
        uint _e78 = at;
        float before_1 = places[((_e72 - 1u) / 4u)][((_e78 - 1u) % 4u)];
        uint _e85 = at;
        vec4 _e87 = colors[_e85];
        uint _e88 = at;
        vec4 _e92 = colors[(_e88 - 1u)];
        vec4 _e96 = colors[after_1];
        uint _e97 = at;
        vec4 _e99 = colors[_e97];
        vec4 _e101 = ramp_slope((_e87 - _e92), (place_5 - before_1), (_e96 - _e99), span);
        from_a_1 = _e101;
    }
    if (((after_1 + 1u) < 5u)) {
        float _e119 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e119 - (place_5 + span));
        vec4 _e123 = colors[after_1];
        uint _e124 = at;
        vec4 _e126 = colors[_e124];
        vec4 _e131 = colors[(after_1 + 1u)];
        vec4 _e133 = colors[after_1];
        vec4 _e135 = ramp_slope((_e123 - _e126), span, (_e131 - _e133), next);
        to_b_1 = _e135;
    }
    uint _e136 = at;
    vec4 _e138 = colors[_e136];
    vec4 _e140 = colors[after_1];
    vec4 _e141 = from_a_1;
    vec4 _e143 = to_b_1;
    vec4 _e145 = hermite(_e138, _e140, (span * _e141), (span * _e143), t_1);
    vec4 _e146 = bounded_vec4_(_e145);
    return _e146;
}

vec4 premultiplied(vec4 color) {
    return vec4((color.xyz * color.w), color.w);
}

vec4 straight(vec4 composite) {
    if ((composite.w <= 0.0)) {
        return composite;
    }
    return vec4((composite.xyz / vec3(composite.w)), composite.w);
}

vec4 output_(vec4 color_1) {
    vec4 _e1 = straight(color_1);
    vec4 _e2 = finite_vec4_(_e1);
    return _e2;
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

float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = ((hash.x >> 8u) % 3u);
    float a_2 = ((axis == 0u) ? d.y : d.x);
    float b_2 = ((axis == 2u) ? d.y : d.z);
    return ((((hash.y >> 31u) == 0u) ? a_2 : -(a_2)) + (((hash.z >> 31u) == 0u) ? b_2 : -(b_2)));
}

float perlin_noise(vec3 p, uint seed_1) {
    int i = 0;
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 d_4 = (p - corner);
    vec3 f = (((d_4 * d_4) * d_4) * ((d_4 * ((d_4 * 6.0) - vec3(15.0))) + vec3(10.0)));
    ivec3 cell = ivec3(corner);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e64 = i;
            i = (_e64 + 1);
        }
        loop_init_1 = false;
        int _e21 = i;
        if (!((_e21 < 8))) {
            break;
        }
        int _e25 = i;
        int _e28 = i;
        int _e33 = i;
        ivec3 at_2 = ivec3((_e25 & 1), ((_e28 >> 1u) & 1), (_e33 >> 2u));
        vec3 weight = mix((vec3(1.0) - f), f, equal(at_2, ivec3(1)));
        float _e44 = sum;
        uvec3 _e58 = hash_pcg3d((uvec3((cell + at_2)) + (seed_1 * uvec3(2654435769u, 2246822507u, 3266489909u))));
        float _e61 = gradient_dot(_e58, (d_4 - vec3(at_2)));
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

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(0.0, 1.0);
    vec3 x_8 = ((turn.y * along) + (turn.x * across));
    vec3 y = ((turn.y * across) - (turn.x * along));
    vec2 turned = vec2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    vec3 stretch_4 = vec3(dot(x_8, x_8), dot(x_8, y), dot(y, y));
    return StretchedPlace(turned, stretch_4);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count_3) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (count_3 / max(viewport_1.y, 1.0)) : count_3);
    vec2 p_1 = clamp((place_1 * scale_2), vec2(-4194304.0), vec2(4194304.0));
    return SpacedPlace(p_1, (is_pixel ? vec3(1.0, 0.0, 1.0) : stretch));
}

float area_square(vec3 stretch_1) {
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
}

MarkPlace mark_place_object(float angle_1, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    vec2 _e8 = place_in_picture(pixel_1, viewport_2);
    vec2 place_6 = ((_e8 - vec2(anchor.x, -(anchor.y))) / vec2(size));
    StretchedPlace _e26 = mark_place_of(place_6, vec3((1.0 / size), 0.0, 0.0), vec3(0.0, (1.0 / size), 0.0), angle_1);
    return MarkPlace(_e26.place, _e26.stretch);
}

float paper_octave(vec2 place_2, int zoom, float w_2, float fiber, uint seed_2) {
    float scale_3 = uintBitsToFloat((uint((zoom + 127)) << 23u));
    vec2 p_2 = clamp((place_2 * scale_3), vec2(-4194304.0), vec2(4194304.0));
    uint own = (seed_2 + (7u * uint(zoom)));
    float _e23 = perlin_noise(vec3(p_2, 0.5), own);
    float grain = (_e23 - 0.5);
    vec2 q = clamp((2.7 * vec2(((0.8 * p_2.x) - (0.6 * p_2.y)), ((0.6 * p_2.x) + (0.8 * p_2.y)))), vec2(-4194304.0), vec2(4194304.0));
    float _e52 = perlin_noise(vec3(q, 0.5), (own + 1u));
    float felt = (_e52 - 0.5);
    float coarse_seen = (1.0 - smoothstep(0.5, 1.0, (w_2 * scale_3)));
    float felt_seen = (1.0 - smoothstep(0.5, 1.0, ((2.7 * w_2) * scale_3)));
    return clamp((0.5 + (1.4 * ((coarse_seen * grain) + ((fiber * felt_seen) * felt)))), 0.0, 1.0);
}

float paper_height(SpacedPlace at_1, float fiber_1, uint seed_3) {
    float height = 0.0;
    vec2 x_9 = dFdx(at_1.place);
    vec2 y_1 = dFdy(at_1.place);
    float w_3 = sqrt(max(dot(x_9, x_9), dot(y_1, y_1)));
    float _e12 = area_square(at_1.stretch);
    float _e16 = log2_stable(max(sqrt(_e12), 1e-30));
    float level = clamp((-0.5 * _e16), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    float _e26 = paper_octave(at_1.place, int(zoom_1), w_3, fiber_1, seed_3);
    height = _e26;
    if ((f_1 > 0.0)) {
        float _e30 = height;
        float _e35 = paper_octave(at_1.place, (int(zoom_1) + 1), w_3, fiber_1, seed_3);
        float both = mix(_e30, _e35, f_1);
        height = clamp((0.5 + ((both - 0.5) / sqrt(((f_1 * f_1) + ((1.0 - f_1) * (1.0 - f_1)))))), 0.0, 1.0);
    }
    float _e53 = height;
    return _e53;
}

PaperGrain paper_grain(float value, vec2 place_3, vec3 stretch_2, float count_4, float tooth, float fiber_2, int seed_4, vec2 viewport_3) {
    SpacedPlace _e8 = spaced(place_3, stretch_2, viewport_3, count_4);
    float _e10 = paper_height(_e8, fiber_2, 5u);
    return PaperGrain((1.0 - clamp((0.5 + (((0.0 * (_e10 - 0.5)) * 0.5) * 0.5)), 0.0, 1.0)), _e10);
}

PaperGrain paper_grain_2_(float value_1, vec2 place_4, vec3 stretch_3, float count_5, float tooth_1, float fiber_3, int seed_5, vec2 viewport_4) {
    SpacedPlace _e8 = spaced(place_4, stretch_3, viewport_4, count_5);
    float _e10 = paper_height(_e8, fiber_3, 0u);
    float ink = (1.0 - clamp(value_1, 0.0, 1.0));
    return PaperGrain((1.0 - clamp((ink + ((((8.0 * tooth_1) * (_e10 - 0.5)) * ink) * (1.0 - ink))), 0.0, 1.0)), _e10);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.5) / 1.5), 0.0);
    vec2 _e18 = u_look.viewport;
    MarkPlace _e19 = mark_place_object(0.0, surface.anchor, surface.pixel, _e18);
    vec2 _e29 = u_look.viewport;
    PaperGrain _e30 = paper_grain(0.5, _e19.place, _e19.stretch, 11.0, 0.0, 0.7, 5, _e29);
    float _e32 = bounded(_e30.height);
    float uneven_edge = mix(-0.2, 0.2, (_e32 - 0.0));
    float wet = (light_and_shade + uneven_edge);
    float _e45 = footprint_of_2_(wet);
    float _e51 = stairs_filtered((4.0 * clamp(wet, 0.0, 1.0)), 4.0, length(vec2((4.0 * _e45), 0.22)));
    float washes = clamp((_e51 / 3.0), 0.0, 1.0);
    float pigment_in_them = mix(washes, wet, 0.35);
    vec2 _e67 = u_look.viewport;
    PaperGrain _e68 = paper_grain_2_(pigment_in_them, _e19.place, _e19.stretch, 260.0, 0.2, 0.6, 0, _e67);
    float _e71 = bounded(_e68.tone);
    float _e73 = footprint_of(_e68.tone);
    vec4 _e74 = ramp_at(indigo_to_warm_paper, _e71, _e73);
    vec4 output_alpha = vec4(_e74.xyz, clamp(_e74.w, 0.0, 1.0));
    vec4 _e81 = premultiplied(output_alpha);
    vec4 _e82 = output_(_e81);
    return _e82;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    vec4 _e10 = u_view.screen;
    vec4 _e15 = u_view.screen;
    mat4x4 _e20 = u_view.camera_from_world;
    vec4 _e24 = u_object.world_from_object[3];
    float _e33 = u_view.eye.w;
    float _e38 = u_view.clip_from_world[0][1];
    float _e43 = u_view.clip_from_world[1][1];
    float _e48 = u_view.clip_from_world[2][1];
    vec3 _e51 = anchor_on_screen((_e20 * vec4(_e24.xyz, 1.0)).xyz, _e33, length(vec3(_e38, _e43, _e48)));
    Surface surface_1 = Surface(normal, ((in_.clip.xy * _e10.xy) + _e15.zw), _e51);
    vec4 _e53 = shade(surface_1);
    vec4 _e54 = finite_vec4_(_e53);
    out_color = _e54;
    return;
}

