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
    Light back;
    vec2 viewport;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    float kappa;
    vec2 pixel;
    vec3 anchor;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
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

/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const float MOST_ON_SCREEN = 1000000000000000.0;
const ProfileShape orange_chalk_shape = ProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545,
    0.5, 0.43399706, 0.1847509, 0u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

uniform highp sampler2D u_curvature_map;

smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

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

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, vec2 t) {
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 2147483647u;
    float largest = uintBitsToFloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
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
    float ink = 1.0 - value;
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_2(float value, vec2 place, vec3 stretch, float count, float tooth,
    float fiber, int seed, vec2 viewport) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 9u);
    float ink = 1.0 - value;
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_3(float value, vec2 place, vec3 stretch, float count, float tooth,
    float fiber, int seed, vec2 viewport) {
    float height = paper_height(spaced(place, stretch, viewport, count), fiber, 3u);
    float ink = 1.0 - max(value, 0.0);
    return PaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink), 0.0, 1.0),
        height);
}


/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Reflectance
    float shade_2 = max((dot(surface.normal, u_look.key.direction) + 0.15) / 1.15, 0.0);
    float tone = min((shade_2 - 0.0) / 0.9, 1.0);
    float rubbed = mix(0.05, 0.5, min((tone - 0.0) / 0.6, 1.0));
    float r_bare = 1.0 - rubbed;
    MarkPlace board = mark_place_object(0.0, surface.anchor, surface.pixel, u_look.viewport);
    PaperGrain r_grain = paper_grain(r_bare, board.place, board.stretch, 120.0, 0.6, 0.5, 5,
        u_look.viewport);
    float r_on = bounded(1.0 - r_grain.tone);
    vec4 blue_gray = mix(vec4(0.1216, 0.1647, 0.1686, 1.0), vec4(0.4275, 0.5098, 0.5647, 1.0),
        r_on);
    // Parametrization
    Angle turn = Angle(0.5 * length(surface.normal - u_look.back.direction), 0.5
        * length(surface.normal + u_look.back.direction));
    float orange_chalk = profile_balanced(turn, 0.0, orange_chalk_shape);
    float o_bare = 1.0 - orange_chalk;
    PaperGrain o_grain = paper_grain_2(o_bare, board.place, board.stretch, 220.0, 0.8, 0.5, 9,
        u_look.viewport);
    vec4 orange = mix(blue_gray, vec4(0.9412, 0.6353, 0.3608, 1.0), bounded(1.0 - o_grain.tone));
    float curvature = surface.kappa;
    // Curvature transition
    float hollow_to_bulge = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(curvature * 0.16, -20.0, 20.0))));
    float bare_in_hollows = mix(0.1, 1.0, clamp((hollow_to_bulge - 0.15) / 0.35, 0.0, 1.0));
    float white_chalk = tone * bare_in_hollows;
    float w_bare = 1.0 - white_chalk;
    PaperGrain w_grain = paper_grain_3(w_bare, board.place, board.stretch, 260.0, 0.62, 0.5, 3,
        u_look.viewport);
    vec4 white = mix(orange, vec4(0.9686, 0.9529, 0.9098, 1.0), bounded(1.0 - w_grain.tone));
    return white;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_map, ivec2(in_.clip.xy), 0);
    vec3 anchor_on_screen_value = anchor_on_screen((u_view.camera_from_world
        * vec4(u_object.world_from_object[3].xyz, 1.0)).xyz, u_view.eye.w,
        length(vec3(u_view.clip_from_world[0][1], u_view.clip_from_world[1][1],
        u_view.clip_from_world[2][1])));
    Surface surface = Surface(normal, texel.x, in_.clip.xy * u_view.screen.xy + u_view.screen.zw,
        anchor_on_screen_value);
    out_color = shade(surface);
}
