#version 450 core
// Working drawing: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_line_nearness_map 0, u_facet_map 1, u_hidden_map 2.
// working-drawing.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    vec4 screen;
};

/// What is known before the fragment.
struct Look {
    float object_id;
    vec2 viewport;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    float depth;
    vec4 line_nearness;
    vec2 middle_surface;
    vec4 hidden_nearness;
    vec2 pixel;
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

struct ScreenPlace {
    /// From the picture's upper left corner, x to the right and y down, in pixels; centers lie at
    /// halves.
    vec2 pixel;
    /// From the picture's middle, x to the right and y up, in picture heights.
    vec2 place;
    /// From 0 at the left to 1 at the right, and from 0 below to 1 above: texture coordinates of
    /// the picture.
    vec2 uv;
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
    vec3 position;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
const uint INTERPOLATION_SMOOTH = 1u;
const uint INTERPOLATION_STEPPED = 2u;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const float MOST_ON_SCREEN = 1000000000000000.0;
/// What is no nearer than this many pixels is not near at all: less is rounding.
const float LEAST_NEARNESS = 1e-6;
const Ramp paper = Ramp(vec4[16](vec4(0.8, 0.845, 0.885, 1.0), vec4(0.955, 0.965, 0.955, 1.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
    vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)),
    vec4[4](vec4(0.0, 0.75, 0.0, 0.0), vec4(0.0), vec4(0.0), vec4(0.0)), 2u, 1u);

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_line_nearness_map;

layout(binding = 1) uniform sampler2D u_facet_map;

layout(binding = 2) uniform sampler2D u_hidden_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_normal;
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

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
float modulo_floored(float x, float y) {
    float left = x - floor(x);
    float wrapped = left < 0.0 ? left + 1.0 : left;
    float inside = (wrapped >= 0.0 && wrapped < 1.0) ? wrapped : 0.0;
    return inside;
}

/// [`mixed`], component by component.
vec4 mixed_vec4(vec4 a, vec4 b, float t) {
    vec4 d = bounded_vec4(b - a);
    return bounded_vec4(t < 0.5 ? a + t * d : b - (1.0 - t) * d);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w) {
    float d = bounded(x - edge);
    if (w < 1e-30) {
        return d >= 0.0 ? 1.0 : 0.0;
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
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

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale) {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 from_middle = pixel - 0.5 * viewport;
    return vec2(from_middle.x, -from_middle.y) / vec2(max(viewport.y, 1.0));
}

/// Screen place
///
/// Where in the picture something is seen: for vignettes, gradients behind a figure, and patterns
/// that lie on the picture and not on surfaces.
ScreenPlace screen_place(vec2 pixel, vec2 viewport) {
    vec2 place = place_in_picture(pixel, viewport);
    float aspect = viewport.x / max(viewport.y, 1.0);
    return ScreenPlace(pixel, place, vec2(0.5 + place.x / max(aspect, 1e-6), 0.5 + place.y));
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
    float id_width = min(width, 10000.0);
    return LineWidths(mix(vec4(0.0), widths, greaterThan(widths, vec4(1e-6))), id_width
        > 1e-6 ? id_width : 0.0);
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
LineWidths line_widths_2(float width, vec4 shares, float ids) {
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

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
float any_line_covers(vec4 nearness, LineWidths widths, float reach) {
    vec4 near = clamp(nearness, vec4(-reach), vec4(reach));
    vec4 own = mix(vec4(0.0), vec4(widths.kinds.xyz, near.w < 0.0 ? widths.ids : widths.kinds.w),
        greaterThan(abs(near), vec4(1e-6)));
    vec4 covers = middle_line_covers(vec4(reach) - abs(near), own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
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

/// Hidden lines
///
/// Lines of what lies behind, seen through what is in front, as a value: where the next surface
/// ends, folds or meets another. Draw them pale, thin, or broken by a noise or a half-tone. The
/// surface in front shows them, one layer deep: what lies behind two surfaces is not seen, nor are
/// the backs of solids.
float hidden_lines_height(float width, float silhouettes, float creases, float borders,
    vec4 nearness, vec2 viewport) {
    vec4 shares = vec4(silhouettes, creases, borders, borders);
    LineWidths widths = line_widths(width * (0.001 * viewport.y), shares, borders);
    return any_line_covers(nearness, widths,
        min(16.0 * max(roundEven(viewport.y / 800.0), 1.0), 31.0));
}

Outline drawn_outline(LineWidths line_widths, vec4 of_edges, float reach) {
    float kind = 0.0;
    vec4 signed = clamp(of_edges, vec4(-reach), vec4(reach));
    vec4 nearness = abs(signed);
    vec4 widths = vec4(line_widths.kinds.xyz, 0.0);
    vec4 covers = lines_cover(nearness, widths, reach);
    float line = max(max(covers.x, covers.y), covers.z);
    float least = line - 0.0009765625;
    kind = signed.w < 0.0 ? 5.0 : 4.0;
    kind = covers.z >= least ? 3.0 : kind;
    kind = covers.y >= least ? 2.0 : kind;
    kind = covers.x >= least ? 1.0 : kind;
    vec4 near = mix(vec4(0.0), nearness, greaterThan(widths, vec4(0.0)));
    float nearest = max(max(near.x, near.y), near.z);
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
    LineWidths widths = line_widths_2(width * (0.001 * viewport.y), shares, id_borders);
    return drawn_outline(widths, own, reach);
}

/// Separate vector
///
/// The three numbers of a vector.
VectorParts separate_vector(vec3 vector) {
    return VectorParts(vector.x, vector.y, 0.0);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    float facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    vec4 paper_2 = ramp_at(paper, facing, footprint_of(facing));
    float what_lies_behind = hidden_lines_height(2.4, 1.0, 0.8, 1.0, surface.hidden_nearness,
        u_look.viewport);
    ScreenPlace place = screen_place(surface.pixel, u_look.viewport);
    VectorParts columns_and_rows = separate_vector(vec3(place.pixel, 0.0));
    float diagonal = columns_and_rows.x + columns_and_rows.y;
    float dash_length = diagonal * 0.11;
    float along_a_dash = modulo_floored(dash_length, 1.0);
    float ink_or_gap = along_a_dash - 0.58 < -0.0 ? 1.0 : 0.0;
    float dashed = what_lies_behind * ink_or_gap;
    // Mix colors
    vec4 dashed_on_the_paper = mixed_vec4(bounded_vec4(paper_2), vec4(0.32, 0.42, 0.55, 1.0),
        dashed);
    Outline what_is_seen = outline_height(5.0, 1.0, 0.55, 1.0, 0.0, 0.0, surface.line_nearness,
        surface.middle_surface, surface.depth, u_look.object_id, u_look.viewport,
        surface.magnification);
    // Mix colors
    vec4 inked = mixed_vec4(bounded_vec4(dashed_on_the_paper), vec4(0.07, 0.09, 0.15, 1.0),
        what_is_seen.line);
    vec4 output_2 = output_(premultiplied(vec4(inked.xyz, clamp(inked.w, 0.0, 1.0))));
    return output_2;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_line_nearness_map, ivec2(in_.clip.xy), 0);
    vec4 texel_1 = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0);
    vec4 texel_2 = texelFetch(u_facet_map, ivec2(in_.clip.xy), 0);
    vec4 texel_3 = texelFetch(u_hidden_map, ivec2(in_.clip.xy), 0);
    float size_on_screen_value = size_on_screen(-(u_view.camera_from_world
        * vec4(in_.position, 1.0)).z, u_view.eye.w,
        length(vec3(u_view.clip_from_world[0][1], u_view.clip_from_world[1][1],
        u_view.clip_from_world[2][1])));
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        -(u_view.camera_from_world * vec4(in_.position, 1.0)).z, texel,
        vec2(texel_1.z, floor(abs(texel_2.w))), texel_3, in_.clip.xy * u_view.screen.xy
        + u_view.screen.zw, size_on_screen_value);
    out_color = finite_vec4(shade(surface));
}
