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
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    vec4 screen;
};

struct Object {
    mat4x4 world_from_object;
    /// The inverse transpose, for normals.
    mat3x3 world_from_normal;
    float id;
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
    vec2 viewport;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec2 pixel;
    vec3 anchor;
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

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    vec2 place;
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    vec3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    vec2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    vec3 stretch;
};

struct PaperGrain {
    /// The tone as the paper shows it.
    float tone;
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    float height;
};

struct Varyings {
    vec4 clip;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const float MOST_ON_SCREEN = 1000000000000000.0;
const Ramp indigo_to_warm_paper = Ramp(vec4[16](vec4(0.13, 0.14, 0.33, 1.0),
    vec4(0.24, 0.36, 0.56, 1.0), vec4(0.53, 0.66, 0.72, 1.0), vec4(0.9, 0.8, 0.68, 1.0),
    vec4(0.975, 0.95, 0.9, 1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.35, 0.62, 0.82), vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0)), 5u, 1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// v with 0 for each component that is NaN or infinite.
vec4 finite_vec4(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual(floatBitsToUint(v) & exponent, exponent));
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = int(bits - 1060439283u) >> 23u;
    float mantissa = uintBitsToFloat(bits - (uint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
vec3 normalize_seen(vec3 v) {
    return normalize_moderate(v, vec3(0.0, 0.0, 1.0));
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
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of_2(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral(float x, float count) {
    float inside = min(x, count);
    float stair = min(floor(inside), 3.0);
    float beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 3.0;
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
float stairs_integral_2(float x, float count) {
    float inside = max(x, 0.0);
    float stair = floor(inside);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + 0.0;
}

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
float stairs_filtered(float x, float count, float w) {
    if (w <= 1.0) {
        float edge = clamp(roundEven(x), 1.0, 3.0);
        return edge - 1.0 + clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    float half_ = 0.5 * w;
    return (stairs_integral(x + half_, count) - stairs_integral_2(x - half_, count))
        / (2.0 * half_);
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
    for (uint i_2 = 1u; i_2 < 5u; i_2++) {
        float places_now = places[i_2 / 4u][i_2 % 4u];
        at = places_now <= x ? i_2 : at;
    }
    float place = places[at / 4u][at % 4u];
    if (at + 1u >= 5u || x <= place) {
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
    if (after + 1u < 5u) {
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

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uvec3 hash, vec3 d) {
    uint axis = (hash.x >> 8u) % 3u;
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(vec3 p, uint seed) {
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 d = p - corner;
    vec3 f = d * d * d * (d * (d * 6.0 - vec3(15.0)) + vec3(10.0));
    ivec3 cell = ivec3(corner);
    for (int i = 0; i < 8; i++) {
        ivec3 at = ivec3(i & 1, (i >> 1u) & 1, i >> 2u);
        vec3 weight = mix(vec3(1.0) - f, f, equal(at, ivec3(1)));
        uvec3 hash_pcg3d_value = hash_pcg3d(uvec3(cell + at) + seed
            * uvec3(2654435769u, 2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5 * gradient_dot(hash_pcg3d_value, d - vec3(at));
    }
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale) {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
vec3 anchor_on_screen(vec3 origin, float perspective, float scale) {
    float size = size_on_screen(-origin.z, perspective, scale);
    return clamp(vec3(origin.x * size, -origin.y * size, size), vec3(-1000000000000000.0),
        vec3(1000000000000000.0));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 from_middle = pixel - 0.5 * viewport;
    return vec2(from_middle.x, -from_middle.y) / vec2(max(viewport.y, 1.0));
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(0.0, 1.0);
    vec3 x = turn.y * along + turn.x * across;
    vec3 y = turn.y * across - turn.x * along;
    vec2 turned = vec2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    vec3 stretch = vec3(dot(x, x), dot(x, y), dot(y, y));
    return StretchedPlace(turned, stretch);
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(vec2 place, vec3 stretch, vec2 viewport, float count) {
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / max(viewport.y, 1.0) : count;
    vec2 p = clamp(place * scale, vec2(-4194304.0), vec2(4194304.0));
    return SpacedPlace(p, is_pixel ? vec3(1.0, 0.0, 1.0) : stretch);
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
float area_square(vec3 stretch) {
    float sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

MarkPlace mark_place_object(float angle, vec3 anchor, vec2 pixel, vec2 viewport) {
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    vec2 place = (place_in_picture(pixel, viewport) - vec2(anchor.x, -anchor.y)) / vec2(size);
    StretchedPlace m = mark_place_of(place, vec3(1.0 / size, 0.0, 0.0), vec3(0.0, 1.0 / size, 0.0),
        angle);
    return MarkPlace(m.place, m.stretch);
}

/// The height of paper in one octave; paper finer than a pixel is flat.
float paper_octave(vec2 place, int zoom, float w, float fiber, uint seed) {
    float scale = uintBitsToFloat(uint(zoom + 127) << 23u);
    vec2 p = clamp(place * scale, vec2(-4194304.0), vec2(4194304.0));
    uint own = seed + 7u * uint(zoom);
    float grain = perlin_noise(vec3(p, 0.5), own) - 0.5;
    vec2 q = clamp(2.7 * vec2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), vec2(-4194304.0),
        vec2(4194304.0));
    float felt = perlin_noise(vec3(q, 0.5), own + 1u) - 0.5;
    float coarse_seen = 1.0 - smoothstep(0.5, 1.0, w * scale);
    float felt_seen = 1.0 - smoothstep(0.5, 1.0, 2.7 * w * scale);
    return clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
float paper_height(SpacedPlace at, float fiber, uint seed) {
    float height = 0.0;
    vec2 x = dFdx(at.place);
    vec2 y = dFdy(at.place);
    float w = sqrt(max(dot(x, x), dot(y, y)));
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    height = paper_octave(at.place, int(zoom), w, fiber, seed);
    if (f > 0.0) {
        float both = mix(height, paper_octave(at.place, int(zoom) + 1, w, fiber, seed), f);
        height = clamp(0.5 + (both - 0.5) / sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0, 1.0);
    }
    return height;
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain(float value, vec2 place, vec3 stretch, float count, float tooth, float fiber,
    int seed, vec2 viewport) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 5u);
    return PaperGrain(1.0 - clamp(0.5 + 0.0 * (height - 0.5) * 0.5 * 0.5, 0.0, 1.0), height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_2(float value, vec2 place, vec3 stretch, float count, float tooth,
    float fiber, int seed, vec2 viewport) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 0u);
    float ink = 1.0 - clamp(value, 0.0, 1.0);
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Reflectance
    float light_and_shade = max((dot(surface.normal, u_look.key.direction) + 0.5) / 1.5, 0.0);
    MarkPlace paper_that_goes_along = mark_place_object(0.0, surface.anchor, surface.pixel,
        u_look.viewport);
    PaperGrain where_water_stood = paper_grain(0.5, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 11.0, 0.0, 0.7, 5, u_look.viewport);
    float uneven_edge = mix(-0.2, 0.2, bounded(where_water_stood.height) - 0.0);
    float wet = light_and_shade + uneven_edge;
    float stairs_filtered_value = stairs_filtered(4.0 * clamp(wet, 0.0, 1.0), 4.0,
        length(vec2(4.0 * footprint_of_2(wet), 0.22)));
    // Bands
    float washes = clamp(stairs_filtered_value / 3.0, 0.0, 1.0);
    float pigment_in_them = mix(washes, wet, 0.35);
    PaperGrain tooth_of_the_paper = paper_grain_2(pigment_in_them, paper_that_goes_along.place,
        paper_that_goes_along.stretch, 260.0, 0.2, 0.6, 0, u_look.viewport);
    vec4 indigo_to_warm_paper_2 = ramp_at(indigo_to_warm_paper, bounded(tooth_of_the_paper.tone),
        footprint_of(tooth_of_the_paper.tone));
    vec4 output_alpha = vec4(indigo_to_warm_paper_2.xyz, clamp(indigo_to_warm_paper_2.w, 0.0, 1.0));
    return output_(premultiplied(output_alpha));
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec3 anchor_on_screen_value = anchor_on_screen((u_view.camera_from_world
        * vec4(u_object.world_from_object[3].xyz, 1.0)).xyz, u_view.eye.w,
        length(vec3(u_view.clip_from_world[0][1], u_view.clip_from_world[1][1],
        u_view.clip_from_world[2][1])));
    Surface surface = Surface(normal, in_.clip.xy * u_view.screen.xy + u_view.screen.zw,
        anchor_on_screen_value);
    out_color = finite_vec4(shade(surface));
}
