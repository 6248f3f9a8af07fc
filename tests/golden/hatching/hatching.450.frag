#version 450 core
// Hatching: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// Textures: u_curvature_tensor_map 0.
// hatching.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
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
    Light key;
    vec2 viewport;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
    vec3 position_object;
    vec3 curvature_tensor;
    float magnification;
    mat3x3 world_from_normal;
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

/// Style of strokes.
struct Strokes {
    /// Width of a stroke, in spacings.
    float width;
    /// Length of a stroke, in spacings; 0 for endless strokes.
    float length_;
    /// Share of a stroke that its ends take, 0 to 1.
    float taper;
    /// Distance that strokes stray, in spacings.
    float wobble;
    /// Effect of a darker tone: from more strokes at 0 to wider ones at 1.
    float pressure;
    /// Growth of the strokes between others: from all together at 0 to one after the other at 1.
    float variation;
    uint seed;
};

/// A stroke as seen at a place.
struct Stroke {
    /// Turn of the stroke among its neighbors, 0 to 1.
    float turn;
    /// Width of the stroke at the place, as a share of its full width.
    float profile;
};

struct MarkPlace {
    /// Along the strokes, and across them.
    vec2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    vec3 stretch;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 position_object;
    vec3 normal;
};

const float SMALLEST_NORMAL = 1.1754944e-38;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const float MOST_ON_SCREEN = 1000000000000000.0;

layout(std140, binding = 0) uniform ViewBlock { View u_view; };

layout(std140, binding = 1) uniform ObjectBlock { Object u_object; };

layout(std140, binding = 2) uniform LookBlock { Look u_look; };

layout(binding = 0) uniform sampler2D u_curvature_tensor_map;

layout(location = 0) smooth in vec3 v_position;
layout(location = 1) smooth in vec3 v_position_object;
layout(location = 2) smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = x - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * uintBitsToFloat(uint(int(whole) + 126) << 23u);
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
vec3 bounded_vec3(vec3 v) {
    uvec3 bits = floatBitsToUint(v);
    uvec3 magnitude = bits & uvec3(2147483647u);
    vec3 largest = uintBitsToFloat((bits & uvec3(2147483648u)) | uvec3(2139095039u));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v, lessThan(magnitude, uvec3(2139095040u)));
}

/// a / b; 0 where b is 0.
float divided(float a, float b) {
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high) {
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
vec2 principal_curvatures(vec3 tensor) {
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = length(vec2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? vec2(far, near) : vec2(near, far);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 z = normalize_moderate(toward, vec3(0.0, 0.0, 1.0));
    vec3 leaning = cross(up, z);
    float square = dot(leaning, leaning);
    vec3 aside = abs(z.x) > 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 across = square > 1e-8 ? leaning : cross(aside, z);
    vec3 x = normalize_moderate(across - dot(across, z) * z, vec3(1.0, 0.0, 0.0));
    return mat3x3(x, cross(z, x), z);
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

/// Value noise: random numbers at lattice points, smooth between them.
float value_noise(vec3 p, uint seed) {
    float sum = 0.0;
    vec3 corner = floor(p);
    vec3 t = p - corner;
    vec3 f = t * t * t * (t * (t * 6.0 - vec3(15.0)) + vec3(10.0));
    ivec3 cell = ivec3(corner);
    for (int i = 0; i < 8; i++) {
        ivec3 at = ivec3(i & 1, (i >> 1u) & 1, i >> 2u);
        vec3 weight = mix(vec3(1.0) - f, f, equal(at, ivec3(1)));
        uvec3 hash_pcg3d_value = hash_pcg3d(uvec3(cell + at) + seed
            * uvec3(2654435769u, 2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5
            * (vec3(hash_pcg3d_value >> uvec3(8u)) * 5.9604645e-8).x;
    }
    return sum;
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale) {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(0.0, 1.0);
    vec3 x = bounded_vec3(turn.y * along + turn.x * across);
    vec3 y = bounded_vec3(turn.y * across - turn.x * along);
    vec2 turned = vec2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    vec3 most = vec3(1000000000000000.0);
    vec3 stretch = clamp(vec3(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return StretchedPlace(turned, stretch);
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
vec3 gradient_on_picture(vec3 g, vec3 normal, vec3 view) {
    float facing = dot(normal, view);
    return g - normal * (dot(g, view) / (facing >= 0.0 ? max(facing, 0.125) : min(facing, -0.125)));
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
StretchedPlace place_on_surface(vec2 place, vec3 along, vec3 across, vec3 normal, vec3 view,
    float magnification, float angle) {
    float height = 1.0 / clamp(magnification, 1e-15, 1000000000000000.0);
    vec3 x = bounded_vec3(gradient_on_picture(along, normal, view) * height);
    vec3 y = bounded_vec3(gradient_on_picture(across, normal, view) * height);
    return mark_place_of(place, x, y, angle);
}

/// A place on a surface for strokes across an axis of the object.
StretchedPlace place_across(vec3 axis, vec3 position, mat3x3 world_from_normal, vec3 normal,
    vec3 view, float magnification, float angle) {
    mat3x3 axes = axes_around(axis, vec3(0.0, 1.0, 0.0));
    vec2 place = vec2(dot(position, axes[0]), dot(position, axes[2]));
    vec3 along = world_from_normal * axes[0];
    vec3 across = world_from_normal * axes[2];
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(vec2 place, vec3 stretch, vec2 viewport, float count) {
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / max(viewport.y, 1.0) : count;
    vec2 p = clamp(place * scale, vec2(-4194304.0), vec2(4194304.0));
    vec3 s = clamp(bounded_vec3(stretch), vec3(-1000000000000000.0), vec3(1000000000000000.0));
    return SpacedPlace(p, is_pixel ? vec3(1.0, 0.0, 1.0) : s);
}

/// The stroke of a line at x, in one octave. A line's name is an odd number and the octave that it
/// first lies in.
Stroke stroke_at(ivec2 line, float x, int zoom, Strokes style) {
    uvec3 hash_pcg3d_value = hash_pcg3d(uvec3(ivec3(line, 1048576)) + style.seed
        * uvec3(2654435769u, 2246822507u, 3266489909u));
    vec3 own = vec3(hash_pcg3d_value >> uvec3(8u)) * 5.9604645e-8;
    float along = clamp(x * uintBitsToFloat(uint(zoom + 127) << 23u) / 24.0, -1000000.0,
        1000000.0) + own.x;
    float index = floor(along);
    uvec3 hash_pcg3d_value_1 = hash_pcg3d(uvec3(ivec3(line, int(index)))
        + (style.seed + uint(zoom)) * uvec3(2654435769u, 2246822507u, 3266489909u));
    vec3 chance = vec3(hash_pcg3d_value_1 >> uvec3(8u)) * 5.9604645e-8;
    float from_end = min(along - index, 1.0 - (along - index));
    float slope = min(from_end / (0.5 * style.taper), 1.0);
    return Stroke(chance.x, slope * (2.0 - slope));
}

/// A stroke where an octave fades into the next.
Stroke stroke_between(ivec2 line, float x, float level, Strokes style) {
    float zoom = floor(level);
    Stroke a = stroke_at(line, x, int(zoom), style);
    Stroke b = stroke_at(line, x, int(zoom) + 1, style);
    float f = level - zoom;
    return Stroke(mix(a.turn, b.turn, f), mix(a.profile, b.profile, f));
}

/// Distance that strokes stray at a place of an octave, in spacings of the place.
float stray_at(vec2 place, int zoom, uint seed) {
    vec2 p = place * uintBitsToFloat(uint(zoom + 127) << 23u);
    float value_noise_value = value_noise(vec3(0.11 * p.x, 0.45 * p.y, 0.5), seed);
    return (value_noise_value - 0.5) * 2.0 * uintBitsToFloat(uint(-zoom + 127) << 23u);
}

/// Share of a footprint of `w` that a band covers whose middle is t away and which reaches `half`
/// to both sides.
float band_filtered(float t, float half_, float w) {
    if (w < 1e-30) {
        return (abs(t) <= half_ && half_ > 0.0) ? 1.0 : 0.0;
    }
    return clamp((clamp(t + 0.5 * w, -half_, half_) - clamp(t - 0.5 * w, -half_, half_)) / w, 0.0,
        1.0);
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
ivec2 line_of(int whole, int octave) {
    int power = whole == 0 ? 1 : (whole & -whole);
    // log2 of a power of two, by its bits.
    int octaves = int(floatBitsToUint(float(power)) >> 23u) - 127;
    return whole == 0 ? ivec2(0) : ivec2(whole / power, octave - octaves);
}

/// The ink of one direction of strokes. `place` is along and across, in spacings at `level` 0; `w`
/// is the footprint of the coordinate across. The average ink is `ink` times the width, but for
/// tapers.
float hatched(vec2 place, float w, float level, float ink, Strokes style) {
    if (!(ink > 0.0)) {
        return 0.0;
    }
    float number = pow(ink, 0.75);
    float width = style.width * pow(ink, 0.25);
    float zoom = floor(level);
    float stray_at_value = stray_at(place, int(zoom) + 1, style.seed);
    float stray = mix(stray_at(place, int(zoom), style.seed), stray_at_value, level - zoom);
    float across = place.y + style.wobble * stray;
    float density = max(level + log2_stable(max(number, 1e-9)), -40.0);
    float octave = floor(density);
    float growth = exp2_stable(density - octave) - 1.0;
    float scale = uintBitsToFloat(uint(int(octave) + 127) << 23u);
    float q = clamp(across * scale, -4194304.0, 4194304.0);
    float half_ = 0.5 * width * exp2_stable(octave - level);
    float footprint = w * scale;
    int whole = int(roundEven(q));
    Stroke old = stroke_between(line_of(whole, int(octave)), place.x, level, style);
    float middle = floor(q);
    Stroke young = stroke_between(ivec2(2 * int(middle) + 1, int(octave) + 1), place.x, level,
        style);
    float grown = clamp((growth - 0.75 * young.turn) / 0.25, 0.0, 1.0);
    float a = band_filtered(q - float(whole), half_ * old.profile, footprint);
    float b = band_filtered(q - middle - 0.5, half_ * grown * young.profile, footprint);
    float mean = min(2.0 * half_ * (1.0 + growth), 1.0);
    return mix(max(a, b), mean, smoothstep(0.75, 1.5, footprint));
}

/// The ink of strokes in up to four directions, each turned by `cross` radians from the one before:
/// the first take the light tones, and the others come in one after the other.
float cross_hatched(SpacedPlace at, float ink, int layers, float cross_, Strokes style) {
    Strokes own = Strokes(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0u);
    float free = 1.0;
    vec2 x = dFdx(at.place);
    vec2 y = dFdy(at.place);
    float amount = ink * 3.0;
    for (int i = 0; i < 4; i++) {
        if (i < 3) {
            float x_2 = float(i) * cross_;
            vec2 turn = vec2(sin(x_2), cos(x_2));
            vec2 along = vec2(turn.y, turn.x);
            vec2 across = vec2(-turn.x, turn.y);
            float w = length(vec2(dot(across, x), dot(across, y)));
            float square = dot(vec3(across.x * across.x, 2.0 * across.x * across.y, across.y
                * across.y), at.stretch);
            float level = clamp(-0.5 * log2_stable(max(max(square, (at.stretch.x + at.stretch.z)
                / 65.0), 1e-30)), -16.0, 16.0);
            vec2 place = vec2(dot(along, at.place), dot(across, at.place));
            own = style;
            own.seed = 4u + 101u * uint(i);
            free = free * (1.0 - hatched(place, w, level, clamp(amount - float(i), 0.0, 1.0), own));
        }
    }
    return 1.0 - free;
}

/// Mark place
///
/// Where strokes and dots are anchored, and which way strokes go: on the picture, on the picture
/// but moving along with the object, along texture coordinates, across an axis of the object, or
/// around the light so that they turn with it. Wire both outputs to Hatching, Stippling, Brush
/// strokes or Paper grain, which keep their marks as large on the picture as they are, however far
/// the surface is.
MarkPlace mark_place_light(Light light, vec3 normal, float angle, vec3 view, vec3 position_object,
    mat3x3 world_from_normal, float magnification) {
    vec3 toward = light.direction * world_from_normal;
    StretchedPlace m = place_across(toward, position_object, world_from_normal, normal, view,
        magnification, angle);
    return MarkPlace(m.place, m.stretch);
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
float faded_in(float x, float limit, float softness) {
    float width = length(vec2(min(footprint_of(x), 1000000000000000.0), limit * softness));
    return clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Reflectance
    float light_and_shade = max((dot(surface.normal, u_look.key.direction) + 0.35) / 1.35, 0.0);
    float tone_to_draw = mix(0.04, 1.0, min((light_and_shade - 0.0) / 0.85, 1.0));
    MarkPlace around_the_light = mark_place_light(u_look.key, surface.normal, 0.0, surface.view,
        surface.position_object, surface.world_from_normal, surface.magnification);
    SpacedPlace spaced_value = spaced(around_the_light.place, around_the_light.stretch,
        u_look.viewport, 120.0);
    // Hatching
    float pen_strokes = cross_hatched(spaced_value, 1.0 - min(tone_to_draw, 1.0), 3, 0.8,
        Strokes(0.42, 24.0, 0.6, 0.45, 0.25, 1.0, 4u));
    float contour = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.34, 0.2);
    // Combine tones
    float ink = max(pen_strokes, contour);
    float faded_in_value = faded_in(-principal_curvatures(surface.curvature_tensor).y, 75.0, 0.3);
    // Inner contour
    float features = faded_in_value * smoothstep(0.05, 0.3, dot(surface.normal, surface.view));
    // Combine tones
    float strokes_and_features = max(ink, features);
    vec4 pen_on_paper = mix(vec4(0.965, 0.937, 0.875, 1.0), vec4(0.12, 0.105, 0.16, 1.0),
        strokes_and_features);
    return pen_on_paper;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_position_object, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    vec4 texel = texelFetch(u_curvature_tensor_map, ivec2(in_.clip.xy), 0);
    float size_on_screen_value = size_on_screen(-(u_view.camera_from_world
        * vec4(in_.position, 1.0)).z, u_view.eye.w,
        length(vec3(u_view.clip_from_world[0][1], u_view.clip_from_world[1][1],
        u_view.clip_from_world[2][1])));
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position),
        in_.position_object, texel.xyz, size_on_screen_value, u_object.world_from_normal);
    out_color = shade(surface);
}
