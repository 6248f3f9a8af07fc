#version 300 es
// Diffuse parametrization: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// figure2-diffuse.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    Light key;
};
struct Surface {
    vec3 normal;
};
struct Angle {
    float half_sin;
    float half_cos;
};
struct Ramp {
    vec4 colors[16];
    vec4 places[4];
    uint count;
    uint interpolation;
};
struct Varyings {
    vec4 clip;
    vec3 normal;
};
const float HALF_PI = 1.5707964;
const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp color_code = Ramp(vec4[16](vec4(1.0, 0.9686, 0.8392, 1.0), vec4(1.0, 0.8196, 0.4, 1.0), vec4(0.9529, 0.4471, 0.1725, 1.0), vec4(0.7843, 0.1961, 0.3529, 1.0), vec4(0.4157, 0.1725, 0.549, 1.0), vec4(0.1529, 0.2039, 0.4353, 1.0), vec4(0.0431, 0.0627, 0.149, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)), vec4[4](vec4(0.0, 0.1, 0.22, 0.36), vec4(0.52, 0.72, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 1u);

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

vec4 finite_vec4_(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual((floatBitsToUint(v) & exponent), exponent));
}

vec3 normalize_seen_balanced(vec3 v_1) {
    return (v_1 * inversesqrt(max(dot(v_1, v_1), 1e-30)));
}

float atan2_positive(float y, float x) {
    float small = min(y, x);
    float large = max(y, x);
    if ((large <= 0.0)) {
        return 0.0;
    }
    float t_1 = (small / large);
    bool is_wide = (t_1 > 0.41421357);
    float r = (is_wide ? ((small - large) / (small + large)) : t_1);
    float r2_ = (r * r);
    float series = (r * (1.0 + (r2_ * (-0.33333334 + (r2_ * (0.2 + (r2_ * (-0.14285715 + (r2_ * (0.11111111 + (r2_ * (-0.09090909 + (r2_ * (0.07692308 + (r2_ * (-0.06666667 + (r2_ * 0.05882353)))))))))))))))));
    float a_2 = (is_wide ? (series + 0.7853982) : series);
    return ((y > x) ? (HALF_PI - a_2) : a_2);
}

float angle_radians(Angle u) {
    float _e3 = atan2_positive(u.half_sin, u.half_cos);
    return (2.0 * _e3);
}

float bounded(float x_1) {
    uint bits = floatBitsToUint(x_1);
    uint magnitude = (bits & 2147483647u);
    float largest = uintBitsToFloat(((bits & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_1 : ((magnitude == 2139095040u) ? largest : 0.0));
}

vec4 bounded_vec4_(vec4 v_2) {
    uvec4 bits_1 = floatBitsToUint(v_2);
    uvec4 magnitude_1 = (bits_1 & uvec4(2147483647u));
    vec4 largest_1 = uintBitsToFloat(((bits_1 & uvec4(2147483648u)) | uvec4(2139095039u)));
    vec4 numbers = mix(vec4(0.0), largest_1, equal(magnitude_1, uvec4(2139095040u)));
    return mix(numbers, v_2, lessThan(magnitude_1, uvec4(2139095040u)));
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
    vec2 d = vec2(_e1, _e2);
    return sqrt(dot(d, d));
}

vec4 hermite(vec4 a_1, vec4 b_1, vec4 from_a, vec4 to_b, float t) {
    vec4 d_1 = (b_1 - a_1);
    return (a_1 + (t * (from_a + (t * ((((3.0 * d_1) - (2.0 * from_a)) - to_b) + (t * ((from_a + to_b) - (2.0 * d_1))))))));
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

vec4 ramp_at(Ramp ramp, float x_3, float w) {
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
        if (!((_e11 < 7u))) {
            break;
        }
        uint _e15 = at;
        uint _e16 = i_2_;
        uint _e17 = i_2_;
        uint _e21 = i_2_;
        float _e25 = places[(_e17 / 4u)][(_e21 % 4u)];
        at = ((_e25 <= x_3) ? _e16 : _e15);
    }
    uint _e31 = at;
    uint _e35 = at;
    float place = places[(_e31 / 4u)][(_e35 % 4u)];
    uint _e40 = at;
    if ((((_e40 + 1u) >= 7u) || (x_3 <= place))) {
        uint _e47 = at;
        vec4 _e49 = colors[_e47];
        return _e49;
    }
    uint _e50 = at;
    uint after_1 = (_e50 + 1u);
    float _e59 = places[(after_1 / 4u)][(after_1 % 4u)];
    float span = (_e59 - place);
    float _e62 = divided((x_3 - place), span);
    float t_2 = clamp(_e62, 0.0, 1.0);
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
        vec4 _e101 = ramp_slope((_e87 - _e92), (place - before_1), (_e96 - _e99), span);
        from_a_1 = _e101;
    }
    if (((after_1 + 1u) < 7u)) {
        float _e119 = places[((after_1 + 1u) / 4u)][((after_1 + 1u) % 4u)];
        float next = (_e119 - (place + span));
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
    vec4 _e145 = hermite(_e138, _e140, (span * _e141), (span * _e143), t_2);
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

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    vec3 _e14 = u_look.key.direction;
    Angle angle = Angle((0.5 * length((surface.normal - _e5))), (0.5 * length((surface.normal + _e14))));
    float _e20 = angle_radians(angle);
    float angle_over_pi = (_e20 / 3.1415927);
    float _e24 = footprint_of(angle_over_pi);
    vec4 _e25 = ramp_at(color_code, angle_over_pi, _e24);
    vec4 output_alpha = vec4(_e25.xyz, clamp(_e25.w, 0.0, 1.0));
    vec4 _e32 = premultiplied(output_alpha);
    vec4 _e33 = output_(_e32);
    return _e33;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen_balanced(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    Surface surface_1 = Surface(normal);
    vec4 _e7 = shade(surface_1);
    vec4 _e8 = finite_vec4_(_e7);
    out_color = _e8;
    return;
}

