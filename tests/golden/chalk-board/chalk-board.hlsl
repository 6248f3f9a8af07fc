// Chalk: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// chalk-board.json says what to put there and how to draw.

struct View {
    row_major float4x4 clip_from_world;
    row_major float4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    float4 eye;
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    float4 screen;
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
    Light back;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float kappa;
    float2 pixel;
    float3 anchor;
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

struct MarkPlace {
    /// Along the strokes, and across them.
    float2 place;
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    float3 stretch;
};

struct PaperGrain {
    /// The tone as the paper shows it.
    float tone;
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    float height;
};

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 normal : LOC0;
};

/// Greatest place and size on screen, in picture heights: beyond, it says no more.
static const float MOST_ON_SCREEN = 1000000000000000.0;
static const ProfileShape orange_chalk_shape = {0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5,
    0.43399706, 0.1847509, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 normal : LOC0;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 normal_1 : LOC0;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
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

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u)
{
    float2 half_ = float2(u.half_sin, u.half_cos);
    float2 dx = ddx(half_);
    float2 dy = ddy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

Angle ConstructAngle(float half_sin, float half_cos) {
    Angle ret = (Angle)0;
    ret.half_sin = half_sin;
    ret.half_cos = half_cos;
    return ret;
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, float2 t)
{
    float s = u.half_sin - 0.0;
    float2 upper = u.half_cos <= 0.0 ? float2(1.0, 0.0) : float2(s, u.half_cos);
    float2 turned = ((s <= 0.0) & (s < u.half_cos)) ? float2(0.0, 1.0) : upper;
    return ConstructAngle(turned.x, turned.y);
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

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    const float point_ = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point_;
    }
    float r = 0.19364917 * w;
    float2 turn = float2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    const float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    const float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point_ + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
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

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
float gradient_dot(uint3 hash, float3 d)
{
    uint axis = naga_mod(hash.x >> 8u, 3u);
    float a = axis == 0u ? d.y : d.x;
    float b = axis == 2u ? d.y : d.z;
    return ((hash.y >> 31u) == 0u ? a : -a) + ((hash.z >> 31u) == 0u ? b : -b);
}

int3 to_int(float3 value) {
    return int3(clamp(value, -2147483600.0, 2147483500.0));
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
float perlin_noise(float3 p, uint seed)
{
    float sum = 0.0;

    float3 corner = floor(p);
    float3 d = p - corner;
    float3 f = d * d * d * (d * (d * 6.0 - (15.0).xxx) + (10.0).xxx);
    int3 cell = to_int(corner);
    for (int i = 0; i < 8; i++) {
        int3 at = int3(i & int(1), (i >> 1u) & int(1), i >> 2u);
        const float3 weight = choose(at == (int(1)).xxx, f, (1.0).xxx - f);
        const uint3 hash_pcg3d_value = hash_pcg3d(asuint(asint(asuint(cell) + asuint(at))) + seed
            * uint3(2654435769u, 2246822507u, 3266489909u));
        sum = sum + weight.x * weight.y * 0.5 * gradient_dot(hash_pcg3d_value, d - float3(at));
    }
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
float size_on_screen(float depth, float perspective, float scale)
{
    // Clip space is 2 high.
    return min(0.5 * scale / lerp(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
float3 anchor_on_screen(float3 origin, float perspective, float scale)
{
    const float size = size_on_screen(-origin.z, perspective, scale);
    return clamp(float3(origin.x * size, -origin.y * size, size), (-1000000000000000.0).xxx,
        (1000000000000000.0).xxx);
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
float2 place_in_picture(float2 pixel, float2 viewport)
{
    float2 from_middle = pixel - 0.5 * viewport;
    return float2(from_middle.x, -from_middle.y) / (max(viewport.y, 1.0)).xx;
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
    float3 x = turn.y * along + turn.x * across;
    float3 y = turn.y * across - turn.x * along;
    float2 turned = float2(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x
        * place.x);
    float3 stretch = float3(dot(x, x), dot(x, y), dot(y, y));
    return ConstructStretchedPlace(turned, stretch);
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
    return ConstructSpacedPlace(p, is_pixel ? float3(1.0, 0.0, 1.0) : stretch);
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
float area_square(float3 stretch)
{
    float sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

MarkPlace ConstructMarkPlace(float2 place, float3 stretch) {
    MarkPlace ret = (MarkPlace)0;
    ret.place = place;
    ret.stretch = stretch;
    return ret;
}

MarkPlace mark_place_object(float angle, float3 anchor, float2 pixel, float2 viewport)
{
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    float2 place = (place_in_picture(pixel, viewport) - float2(anchor.x, -anchor.y)) / (size).xx;
    const StretchedPlace m = mark_place_of(place, float3(1.0 / size, 0.0, 0.0),
        float3(0.0, 1.0 / size, 0.0), angle);
    return ConstructMarkPlace(m.place, m.stretch);
}

/// The height of paper in one octave; paper finer than a pixel is flat.
float paper_octave(float2 place, int zoom, float w, float fiber, uint seed)
{
    float scale = asfloat(uint(asint(asuint(zoom) + asuint(int(127)))) << 23u);
    float2 p = clamp(place * scale, (-4194304.0).xx, (4194304.0).xx);
    uint own = seed + 7u * asuint(zoom);
    float grain = perlin_noise(float3(p, 0.5), own) - 0.5;
    float2 q = clamp(2.7 * float2(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), (-4194304.0).xx,
        (4194304.0).xx);
    float felt = perlin_noise(float3(q, 0.5), own + 1u) - 0.5;
    float coarse_seen = 1.0 - smoothstep(0.5, 1.0, w * scale);
    float felt_seen = 1.0 - smoothstep(0.5, 1.0, 2.7 * w * scale);
    return clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
float paper_height(SpacedPlace at, float fiber, uint seed)
{
    float height = (float)0;

    float2 x = ddx(at.place);
    float2 y = ddy(at.place);
    float w = sqrt(max(dot(x, x), dot(y, y)));
    float level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    float zoom = floor(level);
    float f = level - zoom;
    height = paper_octave(at.place, to_int(zoom), w, fiber, seed);
    if (f > 0.0) {
        const float paper_octave_value = paper_octave(at.place,
            asint(asuint(to_int(zoom)) + asuint(int(1))), w, fiber, seed);
        float both = lerp(height, paper_octave_value, f);
        height = clamp(0.5 + (both - 0.5) / sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0, 1.0);
    }
    return height;
}

PaperGrain ConstructPaperGrain(float tone, float height) {
    PaperGrain ret = (PaperGrain)0;
    ret.tone = tone;
    ret.height = height;
    return ret;
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain(float value, float2 place, float3 stretch, float count, float tooth,
    float fiber, int seed, float2 viewport)
{
    const float height = paper_height(spaced(place, stretch, viewport, count), fiber, 5u);
    float ink = 1.0 - value;
    return ConstructPaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_2(float value, float2 place, float3 stretch, float count, float tooth,
    float fiber, int seed, float2 viewport)
{
    const float height = paper_height(spaced(place, stretch, viewport, count), fiber, 9u);
    float ink = 1.0 - value;
    return ConstructPaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
PaperGrain paper_grain_3(float value, float2 place, float3 stretch, float count, float tooth,
    float fiber, int seed, float2 viewport)
{
    const float height = paper_height(spaced(place, stretch, viewport, count), fiber, 3u);
    float ink = 1.0 - max(value, 0.0);
    return ConstructPaperGrain(1.0 - clamp(ink + 8.0 * tooth * (height - 0.5) * ink * (1.0 - ink),
        0.0, 1.0), height);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float shade_2 = max((dot(surface.normal, look.key.direction) + 0.15) / 1.15, 0.0);
    float tone = min((shade_2 - 0.0) / 0.9, 1.0);
    float rubbed = lerp(0.05, 0.5, min((tone - 0.0) / 0.6, 1.0));
    float r_bare = 1.0 - rubbed;
    const MarkPlace board = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    const PaperGrain r_grain = paper_grain(r_bare, board.place, board.stretch, 120.0, 0.6, 0.5,
        int(5), look.viewport);
    const float r_on = bounded(1.0 - r_grain.tone);
    float4 blue_gray = lerp(float4(0.1216, 0.1647, 0.1686, 1.0),
        float4(0.4275, 0.5098, 0.5647, 1.0), r_on);
    // Parametrization
    Angle turn = ConstructAngle(0.5 * length(surface.normal - look.back.direction), 0.5
        * length(surface.normal + look.back.direction));
    const float orange_chalk = profile_balanced(turn, 0.0, orange_chalk_shape);
    float o_bare = 1.0 - orange_chalk;
    const PaperGrain o_grain = paper_grain_2(o_bare, board.place, board.stretch, 220.0, 0.8, 0.5,
        int(9), look.viewport);
    float4 orange = lerp(blue_gray, float4(0.9412, 0.6353, 0.3608, 1.0),
        bounded(1.0 - o_grain.tone));
    float curvature = surface.kappa;
    // Curvature transition
    float hollow_to_bulge = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.88539 * clamp(curvature * 0.16, -20.0, 20.0))));
    float bare_in_hollows = lerp(0.1, 1.0, clamp((hollow_to_bulge - 0.15) / 0.35, 0.0, 1.0));
    float white_chalk = tone * bare_in_hollows;
    float w_bare = 1.0 - white_chalk;
    const PaperGrain w_grain = paper_grain_3(w_bare, board.place, board.stretch, 260.0, 0.62, 0.5,
        int(3), look.viewport);
    float4 white = lerp(orange, float4(0.9686, 0.9529, 0.9098, 1.0), bounded(1.0 - w_grain.tone));
    return white;
}

Varyings ConstructVaryings(float4 clip_, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world),
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float kappa, float2 pixel, float3 anchor) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.kappa = kappa;
    ret.pixel = pixel;
    ret.anchor = anchor;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.normal_1 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    const float3 anchor_on_screen_value = anchor_on_screen(mul(float4(object.world_from_object[3].xyz,
        1.0), view.camera_from_world).xyz, view.eye.w,
        length(float3(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y)));
    Surface surface = ConstructSurface(normal, texel.x, in_.clip_.xy * view.screen.xy
        + view.screen.zw, anchor_on_screen_value);
    return shade(surface);
}
