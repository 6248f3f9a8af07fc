// Half-tone comic: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// halftone-comic.json says what to put there and how to draw.

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
    Light key;
    float2 viewport;
    int _end_pad_0;
    int _end_pad_1;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
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

static const ProfileShape not_in_deep_shade_shape = {0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0,
    0.0, 1u};
static const ProfileShape highlight_shape = {0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_2 : LOC1;
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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
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

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
float eased(float x, float low, float high)
{
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
float2 footprint_of_vec2(float2 v)
{
    float2 dx = ddx(v);
    float2 dy = ddy(v);
    return sqrt(dx * dx + dy * dy);
}

Angle parametrization_specular_balanced(Light light, float3 normal, float3 view)
{
    float3 d = 2.0 * dot(normal, view) * normal - view;
    return ConstructAngle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned(angle, float2(0.0, 1.0));
    const float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
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
    ink = disk_filtered(length(cell - round(cell)), sqrt(share * 0.31830987), width);
    float hole = sqrt((1.0 - share) * 0.31830987);
    float is_star = smoothstep(0.3 * hole, 0.9 * hole, width) * smoothstep(0.5, 0.7, share);
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
    return 1.0 - ink_of_dots_2(cell, 1.0 - value, max(w.x, w.y));
}

/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Reflectance
    float light_and_shade = max((dot(surface.normal, look.key.direction) + 0.25) / 1.25, 0.0);
    float red_to_print = lerp(0.15, 1.0, clamp((light_and_shade - 0.1) / 0.65, 0.0, 1.0));
    const float red_dots = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994,
        look.viewport);
    float4 red_on_yellow = lerp(float4(0.91, 0.3, 0.24, 1.0), float4(1.0, 0.87, 0.58, 1.0),
        red_dots);
    // Parametrization
    Angle turned_from_the_light = ConstructAngle(0.5 * length(surface.normal - look.key.direction),
        0.5 * length(surface.normal + look.key.direction));
    const float not_in_deep_shade = profile_balanced(turned_from_the_light, 0.0,
        not_in_deep_shade_shape);
    float deep_shade = 1.0 - not_in_deep_shade;
    float how_much_blue = deep_shade * 0.62;
    float less = 1.0 - how_much_blue;
    const float blue_dots = halftone_dots_2(less, surface.pixel, 78.0, 1.3089969, look.viewport);
    float inked = 1.0 - blue_dots;
    float4 blue_over_it = float4(lerp(red_on_yellow.xyz, red_on_yellow.xyz
        * float3(0.24, 0.3, 0.58), inked), 1.0);
    const Angle mirrored = parametrization_specular_balanced(look.key, surface.normal,
        surface.view);
    const float highlight = profile_balanced(mirrored, 0.0, highlight_shape);
    float4 left_free = lerp(blue_over_it, float4(1.0, 0.99, 0.95, 1.0), highlight);
    const float contour = eased(clamp(dot(surface.normal, surface.view), 0.0, 1.0), 0.3, 0.22);
    float4 black_line = lerp(left_free, float4(0.09, 0.07, 0.13, 1.0), contour);
    return black_line;
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

Surface ConstructSurface(float3 normal, float3 view, float2 pixel) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.pixel = pixel;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        in_.clip_.xy * view.screen.xy + view.screen.zw);
    return shade(surface);
}
