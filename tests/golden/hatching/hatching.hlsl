// Hatching: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_tensor_map t0.
// hatching.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
};

struct Object {
    row_major float4x4 world_from_object;
    /// The inverse transpose, for normals.
    row_major float3x3 world_from_normal;
    int _pad2_0;
    float id;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    float3 direction;
    int _pad1_0;
    /// Unit, toward the light, in the light's own frame.
    float3 own_direction;
    int _pad2_0;
    /// Straight RGB.
    float3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light key;
    float2 viewport;
    int _end_pad_0;
    int _end_pad_1;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 position_object;
    float3 curvature_tensor;
    float magnification;
    row_major float3x3 world_from_normal;
};

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    float2 place;
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    float3 stretch;
};

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    float2 place;
    float3 stretch;
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
    float2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    float3 stretch;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 position_object : LOC1;
    float3 normal : LOC2;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
/// Greatest place and size on screen, in picture heights: beyond, it says no more.
static const float MOST_ON_SCREEN = 1000000000000000.0;

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput {
    float3 position_1 : LOC0;
    float3 position_object_1 : LOC1;
    float3 normal_4 : LOC2;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_2 : LOC0;
    float3 position_object_2 : LOC1;
    float3 normal_5 : LOC2;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float whole = round(x);
    float f = x - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x)
{
    uint bits = asuint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = asint(bits - 1060439283u) >> 23u;
    float mantissa = asfloat(bits - (asuint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
float3 normalize_seen(float3 v)
{
    return normalize_moderate(v, float3(0.0, 0.0, 1.0));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
float bounded(float x)
{
    uint bits = asuint(x);
    uint magnitude = bits & 2147483647u;
    float largest = asfloat((bits & 2147483648u) | 2139095039u);
    return magnitude < 2139095040u ? x : (magnitude == 2139095040u ? largest : 0.0);
}

/// [`bounded`], component by component.
float3 bounded_vec3(float3 v)
{
    uint3 bits = asuint(v);
    uint3 magnitude = bits & (2147483647u).xxx;
    float3 largest = asfloat((bits & (2147483648u).xxx) | (2139095039u).xxx);
    const float3 numbers = choose(magnitude == (2139095040u).xxx, largest, (0.0).xxx);
    return choose(magnitude < (2139095040u).xxx, v, numbers);
}

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return bounded(sqrt(dot(d, d)));
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
float2 principal_curvatures(float3 tensor)
{
    float mean = 0.5 * (tensor.x + tensor.z);
    float spread = length(float2(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    float far = mean + (mean >= 0.0 ? spread : -spread);
    const float near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return mean >= 0.0 ? float2(far, near) : float2(near, far);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
float3x3 axes_around(float3 toward, float3 up)
{
    const float3 z = normalize_moderate(toward, float3(0.0, 0.0, 1.0));
    float3 leaning = cross(up, z);
    float square = dot(leaning, leaning);
    float3 aside = abs(z.x) > 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0);
    float3 across = square > 1e-8 ? leaning : cross(aside, z);
    const float3 x = normalize_moderate(across - dot(across, z) * z, float3(1.0, 0.0, 0.0));
    return float3x3(x, cross(z, x), z);
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
uint3 hash_pcg3d(uint3 seed)
{
    uint3 v = (uint3)0;

    v = seed * 1664525u + (1013904223u).xxx;
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    v = v ^ (v >> (16u).xxx);
    v.x = v.x + v.y * v.z;
    v.y = v.y + v.z * v.x;
    v.z = v.z + v.x * v.y;
    return v;
}

int3 to_int(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

/// Value noise: random numbers at lattice points, smooth between them.
float value_noise(float3 p, uint seed)
{
    float sum = 0.0;

    float3 corner = floor(p);
    float3 t = p - corner;
    float3 f = t * t * t * (t * (t * 6.0 - (15.0).xxx) + (10.0).xxx);
    int3 cell = to_int(corner);
    for (int i = 0; i < 8; i++) {
        int3 at = int3(i & int(1), (i >> 1u) & int(1), i >> 2u);
        const float3 weight = choose(at == (int(1)).xxx, f, (1.0).xxx - f);
        const uint3 hash_pcg3d_value = hash_pcg3d(asuint(asint(asuint(cell) + asuint(at))) + seed
            * uint3(2654435769u, 2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5
            * (float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8).x;
    }
    return sum;
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale)
{
    // Clip space is 2 high.
    return min(0.5 * scale / lerp(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

StretchedPlace ConstructStretchedPlace(float2 place, float3 stretch) {
    StretchedPlace ret = (StretchedPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
StretchedPlace mark_place_of(float2 place, float3 along, float3 across, float angle)
{
    float2 turn = float2(0.0, 1.0);
    const float3 x = bounded_vec3(turn.y * along + turn.x * across);
    const float3 y = bounded_vec3(turn.y * across - turn.x * along);
    float2 turned = float2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x
        * place.x);
    float3 most = (1000000000000000.0).xxx;
    float3 stretch = clamp(float3(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return ConstructStretchedPlace(turned, stretch);
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
float3 gradient_on_picture(float3 g, float3 normal, float3 view)
{
    float facing = dot(normal, view);
    return g - normal * (dot(g, view) / (facing >= 0.0 ? max(facing, 0.125) : min(facing, -0.125)));
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
StretchedPlace place_on_surface(float2 place, float3 along, float3 across, float3 normal,
    float3 view, float magnification, float angle)
{
    float height = 1.0 / clamp(magnification, 1e-15, 1000000000000000.0);
    const float3 x = bounded_vec3(gradient_on_picture(along, normal, view) * height);
    const float3 y = bounded_vec3(gradient_on_picture(across, normal, view) * height);
    return mark_place_of(place, x, y, angle);
}

/// A place on a surface for strokes across an axis of the object.
StretchedPlace place_across(float3 axis, float3 position, float3x3 world_from_normal, float3 normal,
    float3 view, float magnification, float angle)
{
    const float3x3 axes = axes_around(axis, float3(0.0, 1.0, 0.0));
    float2 place = float2(dot(position, axes[0]), dot(position, axes[2]));
    float3 along = mul(axes[0], world_from_normal);
    float3 across = mul(axes[2], world_from_normal);
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

SpacedPlace ConstructSpacedPlace(float2 place, float3 stretch) {
    SpacedPlace ret = (SpacedPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
SpacedPlace spaced(float2 place, float3 stretch, float2 viewport, float count)
{
    bool is_pixel = !(stretch.x + stretch.z > 0.0);
    float scale = is_pixel ? count / max(viewport.y, 1.0) : count;
    float2 p = clamp(place * scale, (-4194304.0).xx, (4194304.0).xx);
    float3 s = clamp(bounded_vec3(stretch), (-1000000000000000.0).xxx, (1000000000000000.0).xxx);
    return ConstructSpacedPlace(p, is_pixel ? float3(1.0, 0.0, 1.0) : s);
}

Stroke ConstructStroke(float turn, float profile) {
    Stroke ret = (Stroke)0;
    ret.turn = turn;
    ret.profile = profile;
    return ret;
}

/// The stroke of a line at x, in one octave. A line's name is an odd number and the octave that it
/// first lies in.
Stroke stroke_at(int2 line_, float x, int zoom, Strokes style)
{
    const uint3 hash_pcg3d_value = hash_pcg3d(asuint(int3(line_, int(1048576))) + style.seed
        * uint3(2654435769u, 2246822507u, 3266489909u));
    float3 own = float3(hash_pcg3d_value >> (8u).xxx) * 5.9604645e-8;
    float along = clamp(x * asfloat(uint(asint(asuint(zoom) + asuint(int(127)))) << 23u) / 24.0,
        -1000000.0, 1000000.0) + own.x;
    float index = floor(along);
    const uint3 hash_pcg3d_value_1 = hash_pcg3d(asuint(int3(line_, to_int(index)))
        + (style.seed + asuint(zoom)) * uint3(2654435769u, 2246822507u, 3266489909u));
    float3 chance = float3(hash_pcg3d_value_1 >> (8u).xxx) * 5.9604645e-8;
    float from_end = min(along - index, 1.0 - (along - index));
    float slope = min(from_end / (0.5 * style.taper), 1.0);
    return ConstructStroke(chance.x, slope * (2.0 - slope));
}

/// A stroke where an octave fades into the next.
Stroke stroke_between(int2 line_, float x, float level, Strokes style)
{
    float zoom = floor(level);
    const Stroke a = stroke_at(line_, x, to_int(zoom), style);
    const Stroke b = stroke_at(line_, x, asint(asuint(to_int(zoom)) + asuint(int(1))), style);
    float f = level - zoom;
    return ConstructStroke(lerp(a.turn, b.turn, f), lerp(a.profile, b.profile, f));
}

int naga_neg(int val) {
    return asint(0u - asuint(val));
}

/// Distance that strokes stray at a place of an octave, in spacings of the place.
float stray_at(float2 place, int zoom, uint seed)
{
    float2 p = place * asfloat(uint(asint(asuint(zoom) + asuint(int(127)))) << 23u);
    const float value_noise_value = value_noise(float3(0.11 * p.x, 0.45 * p.y, 0.5), seed);
    return (value_noise_value - 0.5) * 2.0
        * asfloat(uint(asint(asuint(naga_neg(zoom)) + asuint(int(127)))) << 23u);
}

/// Share of a footprint of `w` that a band covers whose middle is t away and which reaches `half`
/// to both sides.
float band_filtered(float t, float half_, float w)
{
    if (w < 1e-30) {
        return ((abs(t) <= half_) & (half_ > 0.0)) ? 1.0 : 0.0;
    }
    return clamp((clamp(t + 0.5 * w, -half_, half_) - clamp(t - 0.5 * w, -half_, half_)) / w, 0.0,
        1.0);
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
int2 line_of(int whole, int octave)
{
    int power = whole == int(0) ? int(1) : (whole & naga_neg(whole));
    // log2 of a power of two, by its bits.
    int octaves = asint(asuint(int(asuint(float(power)) >> 23u)) - asuint(int(127)));
    return whole == int(0) ? (int(0)).xx : int2(naga_div(whole, power),
        asint(asuint(octave) - asuint(octaves)));
}

/// The ink of one direction of strokes. `place` is along and across, in spacings at `level` 0; `w`
/// is the footprint of the coordinate across. The average ink is `ink` times the width, but for
/// tapers.
float hatched(float2 place, float w, float level, float ink, Strokes style)
{
    if (!(ink > 0.0)) {
        return 0.0;
    }
    float number = pow(ink, 0.75);
    float width = style.width * pow(ink, 0.25);
    float zoom = floor(level);
    const float stray_at_value = stray_at(place, asint(asuint(to_int(zoom)) + asuint(int(1))),
        style.seed);
    float stray = lerp(stray_at(place, to_int(zoom), style.seed), stray_at_value, level - zoom);
    float across = place.y + style.wobble * stray;
    float density = max(level + log2_stable(max(number, 1e-9)), -40.0);
    float octave = floor(density);
    float growth = exp2_stable(density - octave) - 1.0;
    float scale = asfloat(uint(asint(asuint(to_int(octave)) + asuint(int(127)))) << 23u);
    float q = clamp(across * scale, -4194304.0, 4194304.0);
    float half_ = 0.5 * width * exp2_stable(octave - level);
    float footprint = w * scale;
    int whole = to_int(round(q));
    const Stroke old = stroke_between(line_of(whole, to_int(octave)), place.x, level, style);
    float middle = floor(q);
    const Stroke young = stroke_between(int2(asint(asuint(asint(asuint(int(2))
        * asuint(to_int(middle)))) + asuint(int(1))),
        asint(asuint(to_int(octave)) + asuint(int(1)))), place.x, level, style);
    float grown = clamp((growth - 0.75 * young.turn) / 0.25, 0.0, 1.0);
    const float a = band_filtered(q - float(whole), half_ * old.profile, footprint);
    const float b = band_filtered(q - middle - 0.5, half_ * grown * young.profile, footprint);
    float mean = min(2.0 * half_ * (1.0 + growth), 1.0);
    return lerp(max(a, b), mean, smoothstep(0.75, 1.5, footprint));
}

/// The ink of strokes in up to four directions, each turned by `cross` radians from the one before:
/// the first take the light tones, and the others come in one after the other.
float cross_hatched(SpacedPlace at, float ink, int layers, float cross_, Strokes style)
{
    Strokes own = (Strokes)0;
    float free = 1.0;

    float2 x = ddx(at.place);
    float2 y = ddy(at.place);
    float amount = ink * 3.0;
    for (int i = 0; i < 4; i++) {
        if (i < int(3)) {
            float x_2 = float(i) * cross_;
            float2 turn = float2(sin(x_2), cos(x_2));
            float2 along = float2(turn.y, turn.x);
            float2 across = float2(-turn.x, turn.y);
            float w = length(float2(dot(across, x), dot(across, y)));
            float square = dot(float3(across.x * across.x, 2.0 * across.x * across.y, across.y
                * across.y), at.stretch);
            float level = clamp(-0.5 * log2_stable(max(max(square, (at.stretch.x + at.stretch.z)
                / 65.0), 1e-30)), -16.0, 16.0);
            float2 place = float2(dot(along, at.place), dot(across, at.place));
            own = style;
            own.seed = 4u + 101u * uint(i);
            free = free * (1.0 - hatched(place, w, level, clamp(amount - float(i), 0.0, 1.0), own));
        }
    }
    return 1.0 - free;
}

MarkPlace ConstructMarkPlace(float2 place, float3 stretch) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

/// Mark place
///
/// Where strokes and dots are anchored, and which way strokes go: on the picture, on the picture
/// but moving along with the object, along texture coordinates, across an axis of the object, or
/// around the light so that they turn with it. Wire both outputs to Hatching, Stippling, Brush
/// strokes or Paper grain, which keep their marks as large on the picture as they are, however far
/// the surface is.
MarkPlace mark_place_light(Light light, float3 normal, float angle, float3 view,
    float3 position_object, float3x3 world_from_normal, float magnification)
{
    float3 toward = mul(world_from_normal, light.direction);
    const StretchedPlace m = place_across(toward, position_object, world_from_normal, normal, view,
        magnification, angle);
    return ConstructMarkPlace(m.place, m.stretch);
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
float faded_in(float x, float limit, float softness)
{
    float width = length(float2(min(footprint_of(x), 1000000000000000.0), limit * softness));
    return clamp(0.5 + bounded(bounded(x) - limit) / width, 0.0, 1.0);
}

Strokes ConstructStrokes(float width, float length_, float taper, float wobble, float pressure,
    float variation, uint seed) {
    Strokes ret = (Strokes)0;
    ret.width = width;
    ret.length_ = length_;
    ret.taper = taper;
    ret.wobble = wobble;
    ret.pressure = pressure;
    ret.variation = variation;
    ret.seed = seed;
    return ret;
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float light_and_shade = max((dot(surface.normal, look.key.direction) + 0.35) / 1.35, 0.0);
    float tone_to_draw = lerp(0.04, 1.0, min((light_and_shade - 0.0) / 0.85, 1.0));
    const MarkPlace around_the_light = mark_place_light(look.key, surface.normal, 0.0, surface.view,
        surface.position_object, surface.world_from_normal, surface.magnification);
    const SpacedPlace spaced_value = spaced(around_the_light.place, around_the_light.stretch,
        look.viewport, 120.0);
    // Hatching
    const float pen_strokes = cross_hatched(spaced_value, 1.0 - min(tone_to_draw, 1.0), int(3), 0.8,
        ConstructStrokes(0.42, 24.0, 0.6, 0.45, 0.25, 1.0, 4u));
    const float contour = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.34, 0.2);
    // Combine tones
    float ink = max(pen_strokes, contour);
    const float faded_in_value = faded_in(-principal_curvatures(surface.curvature_tensor).y, 75.0,
        0.3);
    // Inner contour
    float features = faded_in_value * smoothstep(0.05, 0.3, dot(surface.normal, surface.view));
    // Combine tones
    float strokes_and_features = max(ink, features);
    float4 pen_on_paper = lerp(float4(0.965, 0.937, 0.875, 1.0), float4(0.12, 0.105, 0.16, 1.0),
        strokes_and_features);
    return pen_on_paper;
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 position_object, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.position_object = position_object;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        vertex.position, mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.position_object, varyings.normal,
        varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float3 position_object,
    float3 curvature_tensor, float magnification, float3x3 world_from_normal) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.position_object = position_object;
    ret.curvature_tensor = curvature_tensor;
    ret.magnification = magnification;
    ret.world_from_normal = world_from_normal;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_2, input.position_object_2, input.normal_5 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    const float size_on_screen_value = size_on_screen(-mul(float4(in_.position, 1.0),
        view.camera_from_world).z, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.position_object, texel.xyz, size_on_screen_value, object.world_from_normal);
    return shade(surface);
}
