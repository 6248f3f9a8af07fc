#version 450 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0, u_line_nearness_map 1, u_facet_map 2.
// ink-outlines.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

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
    mat3x3 camera_from_world;
    vec2 viewport;
    Light key;
    float object_id;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 position_camera;
    float depth;
    vec3 curvature_tensor;
    vec4 line_nearness;
    vec2 middle_surface;
    float magnification;
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

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    vec4 kinds;
    /// Of borders of ids.
    float ids;
};

struct Outline {
    /// From 0 beside lines to 1 on them.
    float line;
    /// The line's kind where it is drawn: 1 a silhouette, 2 a crease, 3 a border of objects, 4 a
    /// border of materials, 5 a border of ids; 0 beside lines.
    float kind;
    /// To the nearest edge of a kind that is drawn, in pixels; as far as lines reach where none is
    /// near.
    float distance_;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
const uint NOISE_PERLIN = 1u;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const float MOST_ON_SCREEN = 1000000000000000.0;
/// What is no nearer than this many pixels is not near at all: less is rounding.
const float LEAST_NEARNESS = 1e-6;
const Ramp three_washes = Ramp(vec4[16](vec4(0.4353, 0.5255, 0.6588, 1.0),
    vec4(0.7882, 0.6471, 0.549, 1.0), vec4(0.949, 0.851, 0.6941, 1.0),
    vec4(1.0, 0.9647, 0.8784, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.36, 0.54, 0.93), vec4(0.0), vec4(0.0), vec4(0.0)), 4u, 2u);
const Ramp ink = Ramp(vec4[16](vec4(0.0784, 0.102, 0.2, 1.0), vec4(0.3529, 0.1647, 0.1098, 1.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.1, 0.85, 0.0, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 2u, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(binding = 1) uniform sampler2D u_line_nearness_map;

layout(binding = 2) uniform sampler2D u_facet_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// v with 0 for each component that is NaN or infinite.
vec4 finite_vec4(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual(floatBitsToUint(v) & exponent, exponent));
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
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

/// [`mixed`], component by component.
vec4 mixed_vec4(vec4 a, vec4 b, float t) {
    vec4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high) {
    float t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
float footprint_of_vec3(vec3 v) {
    vec3 dx = dFdx(v);
    vec3 dy = dFdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w) {
    float d = bounded(x - edge);
    if (w < 1e-30) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered_2(float x, float edge, float w) {
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
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
    vec4 color = vec4(0.0);
    uint i = 1u;
    uint at = 0u;
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    vec4 from_a = vec4(0.0);
    vec4 to_b = vec4(0.0);
    uint count = min(ramp.count, 16u);
    if (count == 0u) {
        return vec4(0.0);
    }
    colors = ramp.colors;
    places = ramp.places;
    if (ramp.interpolation == INTERPOLATION_STEPPED) {
        color = colors[0];
        for (; i < count; i++) {
            color = color + (colors[i] - colors[i - 1u])
                * step_filtered(x, places[i / 4u][i % 4u], w);
        }
        return bounded_vec4(color);
    }
    for (uint i_1 = 1u; i_1 < count; i_1++) {
        float places_now = places[i_1 / 4u][i_1 % 4u];
        at = places_now <= x ? i_1 : at;
    }
    float place = places[at / 4u][at % 4u];
    if (at + 1u >= count || x <= place) {
        return bounded_vec4(colors[at]);
    }
    uint after = at + 1u;
    float span = places[after / 4u][after % 4u] - place;
    float t = clamp(divided(x - place, span), 0.0, 1.0);
    if (ramp.interpolation != INTERPOLATION_SMOOTH) {
        return mixed_vec4(colors[at], colors[after], t);
    }
    if (at > 0u) {
        float before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    if (after + 1u < count) {
        float next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
vec4 ramp_at_2(Ramp ramp, float x, float w) {
    vec4 colors[16] = vec4[16](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
        vec4(0.0), vec4(0.0));
    vec4 places[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    vec4 color = vec4(0.0);
    colors = ramp.colors;
    places = ramp.places;
    color = colors[0];
    for (uint i = 1u; i < 4u; i++) {
        color = color + (colors[i] - colors[i - 1u]) * step_filtered_2(x, places[0][i % 4u], w);
    }
    return color;
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

/// The number of an object in texels, from 1 on.
float object_number(float object) {
    return object - 4096.0 * floor(object / 4096.0) + 1.0;
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
vec4 output_(vec4 color) {
    return finite_vec4(straight(color));
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v = uvec3(0u);
    v = seed * 1664525u + uvec3(1013904223u);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> uvec3(16u));
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

/// The hash of a lattice point.
uvec3 lattice_hash(ivec3 cell, uint seed) {
    return hash_pcg3d(uvec3(cell) + seed * uvec3(2654435769u, 2246822507u, 3266489909u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = (hash.x >> 8u) % 3u;
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
vec3 fade_quintic(vec3 t) {
    return t * t * t * (t * (t * 6.0 - vec3(15.0)) + vec3(10.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(vec3 p, uint seed) {
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 d = p - corner;
    vec3 f = fade_quintic(d);
    ivec3 cell = ivec3(corner);
    for (int i = 0; i < 8; i++) {
        ivec3 at = ivec3(i & 1, (i >> 1u) & 1, i >> 2u);
        vec3 weight = mix(vec3(1.0) - f, f, equal(at, ivec3(1)));
        float gradient_dot_value = gradient_dot(lattice_hash(cell + at, seed), d - vec3(at));
        sum = sum + weight.x * weight.y * weight.z * gradient_dot_value;
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
float fractal_noise(uint kind, vec3 p, int octaves, float roughness, int seed, float w) {
    float octave = 0.0;
    float frequency = 1.0;
    float strength = 1.0;
    float total = 0.0;
    float sum = 0.0;
    for (int i = 0; i < 2; i++) {
        float visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if (visible > 0.0) {
            vec3 place = clamp(p * frequency + float(i) * vec3(17.31, 5.17, 11.73),
                vec3(-4194304.0), vec3(4194304.0));
            octave = mix(0.5, perlin_noise(place, 0u + uint(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
    }
    return min(sum / 1.5, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale) {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

float reflectance_half_lambert(Light light, vec3 normal) {
    float half_ = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half_ * half_, 1.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
vec4 own_nearness(vec4 nearness, vec2 middle, float depth, float object, float pixels,
    float reach) {
    bool local = false;
    bool local_1 = false;
    bool is_same_object = middle.y == object_number(object);
    float behind = (depth - middle.x) * pixels;
    if (!(abs(middle.y) < 0.5)) {
        if (is_same_object) {
            local_1 = abs(behind) <= 8.0625;
        } else {
            local_1 = false;
        }
        local = local_1;
    } else {
        local = true;
    }
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    bool is_own = local;
    bool is_in_front = behind < (is_same_object ? -8.0625 : -2.0625);
    vec4 other = vec4(is_in_front ? reach : 0.0, 0.0, nearness.z, 0.0);
    return is_own ? nearness : other;
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths(float width, vec4 shares, float ids) {
    vec4 widths = min(width, 10000.0) * shares;
    return LineWidths(mix(vec4(0.0), widths, greaterThan(widths, vec4(1e-6))), 0.0);
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
float inner_line_covers(float distance_, float width) {
    return clamp(width + 0.5 - distance_, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
vec4 middle_line_covers(vec4 distance_, vec4 width) {
    vec4 half_ = 0.5 * width;
    return clamp(min(distance_ + vec4(0.5), half_) - max(distance_ - vec4(0.5), -half_), vec4(0.0),
        vec4(1.0));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
vec4 lines_cover(vec4 nearness, vec4 widths, float reach) {
    vec4 distance_ = vec4(reach) - nearness;
    vec4 covers = vec4(inner_line_covers(distance_.x, widths.x),
        middle_line_covers(distance_, widths).yzw);
    return mix(vec4(0.0), covers, greaterThan(nearness, vec4(1e-6)));
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
float inner_contour_suggestive(float width, float limit, float softness, vec3 tensor, vec3 normal,
    vec3 view, mat3x3 camera_from_world, vec3 place, vec2 viewport) {
    vec3 n = camera_from_world * normal;
    float square = dot(n.xy, n.xy);
    float radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    vec2 change = vec2(dFdx(radial), dFdy(radial));
    vec3 v = camera_from_world * view;
    vec3 row = dFdy(place);
    float up = (row - dot(row, v) * v).y >= 0.0 ? 1.0 : -1.0;
    float height = clamp(viewport.y, 1.0, 100000.0);
    float toward_eye = -(change.x * n.x + up * change.y * n.y) * inversesqrt(max(square, 1e-6));
    float pixels = 0.5 * width * height / 1000.0;
    float distance_ = abs(radial) / max(length(change), 1e-6);
    float x = toward_eye * height * 0.05;
    float strength = clamp(0.5 + (x - limit)
        / length(vec2(min(footprint_of(x), 1000000000000000.0), 24.0)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance_, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

Outline drawn_outline(LineWidths line_widths, vec4 of_edges, float reach) {
    float kind = 0.0;
    vec4 signed = clamp(of_edges, vec4(-reach), vec4(reach));
    vec4 nearness = abs(signed);
    vec4 widths = vec4(line_widths.kinds.xyz, signed.w < 0.0 ? 0.0 : line_widths.kinds.w);
    vec4 covers = lines_cover(nearness, widths, reach);
    float line = max(max(covers.x, covers.y), max(covers.z, covers.w));
    float least = line - 0.0009765625;
    kind = signed.w < 0.0 ? 5.0 : 4.0;
    kind = covers.z >= least ? 3.0 : kind;
    kind = covers.y >= least ? 2.0 : kind;
    kind = covers.x >= least ? 1.0 : kind;
    vec4 near = mix(vec4(0.0), nearness, greaterThan(widths, vec4(0.0)));
    float nearest = max(max(near.x, near.y), max(near.z, near.w));
    return Outline(line, line > 0.0009765625 ? kind : 0.0, reach - nearest);
}

/// Outline
///
/// Ink where forms end, fold and meet, as values to be drawn in any color: silhouettes, creases,
/// borders of objects, of materials and of ids, each as wide as it is told. A silhouette is drawn
/// by what lies in front, as wide as it is; where two surfaces meet, each draws its half of the
/// line. Wire the width to a curvature, a tone or a noise and lines taper.
Outline outline_height(float width, float silhouettes, float creases, float borders,
    float material_borders, float id_borders, vec4 nearness, vec2 middle, float depth, float object,
    vec2 viewport, float magnification) {
    float pixels = magnification * viewport.y;
    float reach = min(16.0 * max(roundEven(viewport.y / 800.0), 1.0), 31.0);
    vec4 own = own_nearness(nearness, middle, depth, object, pixels, reach);
    vec4 shares = vec4(silhouettes, creases, borders, material_borders);
    LineWidths widths = line_widths(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

float noise_perlin(vec3 position, float scale, int octaves, float roughness, int seed) {
    vec3 p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    float light_and_dark = reflectance_half_lambert(u_look.key, surface.normal);
    vec4 three_washes_2 = ramp_at_2(three_washes, light_and_dark, footprint_of_2(light_and_dark));
    vec4 ink_2 = ramp_at(ink, light_and_dark, footprint_of_2(light_and_dark));
    float heavy_in_the_shade = mix(1.6, 8.0, clamp((light_and_dark - 0.75) / -0.6, 0.0, 1.0));
    float hand = noise_perlin(surface.position_object, 3.5, 2, 0.5, 0);
    float pressure = mix(0.7, 1.3, hand - 0.0);
    float width = heavy_in_the_shade * pressure;
    Outline pen = outline_height(width, 1.0, 0.6, 1.0, 0.6, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, u_look.object_id, u_look.viewport,
        surface.magnification);
    float folds = inner_contour_suggestive(2.2, 24.0, 1.0, surface.curvature_tensor, surface.normal,
        surface.view, u_look.camera_from_world, surface.position_camera, u_look.viewport);
    float all_strokes = max(pen.line, folds);
    // Mix colors
    vec4 ink_on_the_washes = mixed_vec4(three_washes_2, bounded_vec4(ink_2), all_strokes);
    vec4 output_alpha = vec4(ink_on_the_washes.xyz, clamp(ink_on_the_washes.w, 0.0, 1.0));
    vec4 output_2 = output_(premultiplied(output_alpha));
    return output_2;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    vec4 texel_1 = texelFetch(u_line_nearness_map, ivec2(in_.clip.xy), 0);
    vec4 texel_2 = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0);
    vec4 texel_3 = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0);
    float size_on_screen_value = size_on_screen(-(u_view.camera_from_world
        * vec4(in_.position, 1.0)).z, u_view.eye.w,
        length(vec3(u_view.clip_from_world[0][1], u_view.clip_from_world[1][1],
        u_view.clip_from_world[2][1])));
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object, (u_view.camera_from_world * vec4(in_.position, 1.0)).xyz,
        -(u_view.camera_from_world * vec4(in_.position, 1.0)).z, texel.xyz, texel_1,
        vec2(texel_2.z, floor(abs(texel_3.w))), size_on_screen_value);
    out_color = finite_vec4(shade(surface));
}
