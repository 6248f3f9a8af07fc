// Screen print: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_map t0.
// screen-print.json says what to put there and how to draw.

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
    Light side;
    float2 viewport;
    int _pad2_0;
    int _pad2_1;
    Light key;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float kappa;
    float2 pixel;
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

struct Vertex {
    float3 position : LOC0;
    float3 normal : LOC1;
};

struct Varyings {
    float4 clip_ : SV_Position;
    float3 position : LOC0;
    float3 normal : LOC1;
};

static const float SMALLEST_NORMAL = 1.1754944e-38;
static const ProfileShape yellow_s_share_shape = {0.9887711, 0.14943813, 2.0858297, 1.7378688, 0.3,
    0.54759663, 0.22553022, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
float2 sin_cos_quarter(float x)
{
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (2.7557319e-6 + h2 * -2.5052108e-8)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-2.4801588e-5 + h2 * (2.755732e-7 + h2 * -2.0876756e-9)))));
    float c = 1.0 - one_minus_c;
    return float2(2.0 * s * c, 1.0 - 2.0 * s * s);
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

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(float x, float low, float high)
{
    float span = high - low;
    if (abs(span) < SMALLEST_NORMAL) {
        return x >= high ? 1.0 : 0.0;
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
float2 footprint_of_vec2(float2 v)
{
    float2 dx = ddx(v);
    float2 dy = ddy(v);
    return sqrt(dx * dx + dy * dy);
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
float step_filtered(float x, float edge, float w)
{
    float d = x - edge;
    return w < 1e-30 ? (d >= 0.0 ? 1.0 : 0.0) : clamp(0.5 + d / w, 0.0, 1.0);
}

float4 mix_colors_multiply(float4 a, float4 b, float factor)
{
    return float4(lerp(a.xyz, a.xyz * b.xyz, factor), 1.0);
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

/// p turned by an angle in radians, from x to y.
float2 turned_by(float2 p, float angle)
{
    float2 turn = float2(sin(angle), cos(angle));
    return float2(turn.y * p.x - turn.x * p.y, turn.x * p.x + turn.y * p.y);
}

/// A place in pixels, in cells of a half-tone screen that has `lines` lines to the picture's height
/// and is turned by an angle in radians.
float2 screen_cells(float2 place, float2 viewport, float lines, float angle)
{
    float2 most = (4194304.0).xx;
    float2 upright = place * (lines / max(viewport.y, 1.0));
    return clamp(turned_by(clamp(upright, (-4194304.0).xx, most), angle), (-4194304.0).xx, most);
}

/// The integral of lines from 0 to x.
float lines_integral(float x, float share)
{
    float whole = round(x);
    return whole * share + clamp(x - whole, -0.5 * share, 0.5 * share);
}

/// Lines that cover `share` of all, from 0 to 1: 1 within half a `share` of every whole number, 0
/// elsewhere, averaged over a footprint of `w`. Without a footprint the edges are inclusive.
float lines_filtered(float x, float share, float w)
{
    float t = x - round(x);
    if (w < 1e-30) {
        return ((abs(t) <= 0.5 * share) & (share > 0.0)) ? 1.0 : 0.0;
    }
    // Beyond a thousand lines to the pixel the average does not change any more.
    float half_ = 0.5 * min(w, 1000.0);
    return clamp((lines_integral(t + half_, share) - lines_integral(t - half_, share))
        / (2.0 * half_), 0.0, 1.0);
}

/// The radius of disks around whole places that together cover `share` of the plane: beyond pi/4
/// they overlap, and at 1 they reach the middle between four.
float dot_radius(float share)
{
    float a = (float)0;

    if (share <= 0.7853982) {
        return sqrt(share * 0.31830987);
    }
    float s = (share - 0.7853982) / 0.21460183;
    a = lerp(0.5227232 * sqrt(s), 0.7853982 - 0.3275682 * sqrt(1.0 - s), s);
    for (int i = 0; i < 2; i++) {
        const float2 turn = sin_cos_quarter(clamp(a, 0.0, 0.7853982));
        float tangent = turn.x / turn.y;
        float square = 1.0 / (turn.y * turn.y);
        float sector = 0.7853982 - a;
        float slope = 2.0 * sector * square * tangent;
        a = clamp(a - (slope > 0.001 ? (sector * square + tangent - share) / slope : 0.0), 0.0,
            0.7853982);
    }
    return 0.5 / sin_cos_quarter(a).y;
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
float disk_filtered(float d, float r, float w)
{
    if (w < 1e-30) {
        return ((d <= r) & (r > 0.0)) ? 1.0 : 0.0;
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    float square = r * r;
    float least = w * w / 3.0;
    float inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
float disk_filtered_2(float d, float r, float w)
{
    if (w < 1e-30) {
        return d <= r ? 1.0 : 0.0;
    }
    float square = r * r;
    float least = w * w / 3.0;
    float inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
}

/// Ink of round dots that cover `share` of the plane.
float ink_of_dots(float2 cell, float share, float w)
{
    float ink = (float)0;

    float width = min(w, 1.0);
    ink = disk_filtered(length(cell - round(cell)), dot_radius(share), width);
    float hole = sqrt((1.0 - share) * 0.31830987);
    float is_star = smoothstep(0.3 * hole, 0.9 * hole, width) * smoothstep(0.5, 0.7, share);
    if (is_star > 0.0) {
        ink = lerp(ink, 1.0 - disk_filtered_2(length(cell - floor(cell) - (0.5).xx), hole, width),
            is_star);
    }
    float mean = lerp(ink, share, smoothstep(0.4, 1.0, w));
    return share <= 0.0 ? share : mean;
}

/// Ink of round dots that cover `share` of the plane.
float ink_of_dots_2(float2 cell, float share, float w)
{
    float ink = (float)0;

    float width = min(w, 1.0);
    ink = disk_filtered(length(cell - round(cell)), dot_radius(share), width);
    float hole = sqrt((1.0 - share) * 0.31830987);
    float is_star = eased(width, 0.3 * hole, 0.9 * hole) * smoothstep(0.5, 0.7, share);
    if (is_star > 0.0) {
        ink = lerp(ink, 1.0 - disk_filtered_2(length(cell - floor(cell) - (0.5).xx), hole, width),
            is_star);
    }
    float mean = lerp(ink, share, smoothstep(0.4, 1.0, w));
    return share <= 0.0 ? share : mean;
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
float halftone_dots(float value, float2 place, float lines, float angle, float2 viewport)
{
    const float2 cell = screen_cells(place, viewport, lines, angle);
    const float2 w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots(cell, 1.0 - min(value, 1.0), max(w.x, w.y));
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
float halftone_dots_2(float value, float2 place, float lines, float angle, float2 viewport)
{
    const float2 cell = screen_cells(place, viewport, lines, angle);
    const float2 w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots_2(cell, 1.0 - min(value, 1.0), max(w.x, w.y));
}

float halftone_lines(float value, float2 place, float lines, float angle, float2 viewport)
{
    const float2 cell = screen_cells(place, viewport, lines, angle);
    return 1.0 - lines_filtered(cell.y, 1.0 - value, footprint_of(cell.y));
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Parametrization
    Angle side = ConstructAngle(0.5 * length(surface.normal - look.side.direction), 0.5
        * length(surface.normal + look.side.direction));
    const float yellow_s_share = profile_balanced(side, 0.0, yellow_s_share_shape);
    float pale = lerp(1.0, 0.25, yellow_s_share - 0.0);
    const float yellow_screen = halftone_lines(pale, surface.pixel, 56.0, 0.0, look.viewport);
    float4 p1_ink = lerp(float4(0.9647, 0.8118, 0.2902, 1.0), (1.0).xxxx, yellow_screen);
    const float4 on_paper = mix_colors_multiply(float4(0.9686, 0.9373, 0.8784, 1.0), p1_ink, 1.0);
    // Reflectance
    float shade_2 = max((dot(surface.normal, look.key.direction) + 0.3) / 1.3, 0.0);
    float tone = min((shade_2 - 0.0) / 0.8, 1.0);
    float coral_s_share = lerp(0.12, 1.0, clamp((tone - 0.25) / 0.7, 0.0, 1.0));
    const float coral_screen = halftone_dots(coral_s_share, surface.pixel, 56.0, 0.2618,
        look.viewport);
    float4 p2_ink = lerp(float4(0.9333, 0.3529, 0.2902, 1.0), (1.0).xxxx, coral_screen);
    float4 printed_over = float4(lerp(on_paper.xyz, on_paper.xyz * p2_ink.xyz, 1.0), 1.0);
    float teal_s_share = lerp(0.05, 1.0, min((tone - 0.0) / 0.5, 1.0));
    const float teal_screen = halftone_dots_2(teal_s_share, surface.pixel, 56.0, 1.309,
        look.viewport);
    float4 p3_ink = lerp(float4(0.1216, 0.5608, 0.5922, 1.0), (1.0).xxxx, teal_screen);
    float4 printed_over_2 = float4(lerp(printed_over.xyz, printed_over.xyz * p3_ink.xyz, 1.0), 1.0);
    float curvature = surface.kappa;
    // Curvature transition
    float hollow = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.88539 * clamp(curvature * 0.25, -20.0, 20.0))));
    // Threshold
    const float hollows = step_filtered(hollow, 0.22, length(float2(footprint_of(hollow), 0.0)));
    float facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    // Threshold
    const float outline = step_filtered(facing, 0.28, length(float2(footprint_of(facing), 0.0)));
    float black_screen = hollows * outline;
    float4 p4_ink = lerp(float4(0.0902, 0.0745, 0.1216, 1.0), (1.0).xxxx, black_screen);
    float4 printed_over_3 = float4(lerp(printed_over_2.xyz, printed_over_2.xyz * p4_ink.xyz, 1.0),
        1.0);
    return printed_over_3;
}

Varyings ConstructVaryings(float4 clip_, float3 position, float3 normal) {
    Varyings ret = (Varyings)0;
    ret.clip_ = clip_;
    ret.position = position;
    ret.normal = normal;
    return ret;
}

VertexOutput vs_main(Vertex vertex)
{
    float4 world = mul(float4(vertex.position, 1.0), object.world_from_object);
    const Varyings varyings = ConstructVaryings(mul(world, view.clip_from_world), world.xyz,
        mul(vertex.normal, object.world_from_normal));
    const VertexOutput varyings_1 = { varyings.position, varyings.normal, varyings.clip_ };
    return varyings_1;
}

Surface ConstructSurface(float3 normal, float3 view, float kappa, float2 pixel) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.kappa = kappa;
    ret.pixel = pixel;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_1 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        texel.x, in_.clip_.xy * view.screen.xy + view.screen.zw);
    return shade(surface);
}
