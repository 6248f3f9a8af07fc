#version 450 core
// Color code of angles: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1.
// figure2-code.json says what to put there and how to draw.
/// The surface under the fragment, in world space.
struct Surface {
    vec2 uv;
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

struct VectorParts {
    /// The first number.
    float x;
    /// The second number.
    float y;
    /// The third number.
    float z;
};

struct Varyings {
    vec4 clip;
    vec2 uv;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const Ramp color_code = Ramp(vec4[16](vec4(1.0, 0.9686, 0.8392, 1.0), vec4(1.0, 0.8196, 0.4, 1.0),
    vec4(0.9529, 0.4471, 0.1725, 1.0), vec4(0.7843, 0.1961, 0.3529, 1.0),
    vec4(0.4157, 0.1725, 0.549, 1.0), vec4(0.1529, 0.2039, 0.4353, 1.0),
    vec4(0.0431, 0.0627, 0.149, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.1, 0.22, 0.36), vec4(0.52, 0.72, 1.0, 0.0), vec4(0.0), vec4(0.0)), 7u, 1u);

layout(location = 0) smooth in vec2 v_uv;
layout(location = 0) out vec4 out_color;

/// v with 0 for each component that is NaN or infinite.
vec4 finite_vec4(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual(floatBitsToUint(v) & exponent, exponent));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 2147483647u;
    float largest = uintBitsToFloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
vec4 bounded_vec4(vec4 v) {
    uvec4 bits = floatBitsToUint(v);
    uvec4 magnitude = bits & uvec4(2147483647u);
    vec4 largest = uintBitsToFloat((bits & uvec4(2147483648u)) | uvec4(2139095039u));
    vec4 numbers = mix(vec4(0.0), largest, equal(magnitude, uvec4(2139095040u)));
    return mix(numbers, v, lessThan(magnitude, uvec4(2139095040u)));
}

/// a / b; 0 where b is 0.
float divided(float a, float b) {
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
vec4 hermite(vec4 a, vec4 b, vec4 from_a, vec4 to_b, float t) {
    vec4 d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// [`ramp_slope`] of one component.
float harmonic_slope(float before, float span_before, float after, float span_after) {
    if (before * after <= 0.0) {
        return 0.0;
    }
    float weight_before = 2.0 * span_after + span_before;
    float weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
vec4 ramp_slope(vec4 rise_before, float span_before, vec4 rise_after, float span_after) {
    float harmonic_slope_value = harmonic_slope(divided(rise_before.x, span_before), span_before,
        divided(rise_after.x, span_after), span_after);
    float divided_value = divided(rise_after.y, span_after);
    float divided_value_1 = divided(rise_after.z, span_after);
    float harmonic_slope_value_1 = harmonic_slope(divided(rise_before.z, span_before), span_before,
        divided_value_1, span_after);
    float divided_value_2 = divided(rise_after.w, span_after);
    float harmonic_slope_value_2 = harmonic_slope(divided(rise_before.w, span_before), span_before,
        divided_value_2, span_after);
    return vec4(harmonic_slope_value,
        harmonic_slope(divided(rise_before.y, span_before), span_before, divided_value, span_after),
        harmonic_slope_value_1, harmonic_slope_value_2);
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
vec4 ramp_at(Ramp ramp, float x, float w) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    uint at = 0u;
    vec4 from_a = vec4(0.0);
    vec4 to_b = vec4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    for (uint i_2 = 1u; i_2 < 7u; i_2++) {
        float places_now = places[i_2 / 4u][i_2 % 4u];
        at = places_now <= x ? i_2 : at;
    }
    float place = places[at / 4u][at % 4u];
    if (at + 1u >= 7u || x <= place) {
        return colors[at];
    }
    uint after = at + 1u;
    float span = places[after / 4u][after % 4u] - place;
    float t = clamp(divided(x - place, span), 0.0, 1.0);
    if (at > 0u) {
        float before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    if (after + 1u < 7u) {
        float next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// Premultiplied RGBA of a straight color.
vec4 premultiplied(vec4 color) {
    return vec4(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
vec4 straight(vec4 composite) {
    if (composite.w <= 0.0) {
        return composite;
    }
    return vec4(composite.xyz / vec3(composite.w), composite.w);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
vec4 output_(vec4 color) {
    return finite_vec4(straight(color));
}

/// Separate vector
///
/// The three numbers of a vector.
VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, 0.0);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    VectorParts parts = separate_vector(vec3(surface.uv, 0.0));
    vec4 color_code_2 = ramp_at(color_code, parts.y, footprint_of(parts.y));
    vec4 output_alpha = vec4(color_code_2.xyz, clamp(color_code_2.w, 0.0, 1.0));
    return output_(premultiplied(output_alpha));
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_uv);
    Surface surface = Surface(in_.uv);
    out_color = finite_vec4(shade(surface));
}
