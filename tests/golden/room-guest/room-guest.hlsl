// Guest: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2.
// room-guest.json says what to put there and how to draw.

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
    float3 eye_position;
    int _pad1_0;
    row_major float3x3 eye_own_from_world;
    int _pad2_0;
    float3 eye_color;
    float eye_intensity;
    float2 eye_fading;
    int _pad5_0;
    int _pad5_1;
    float3 rim_position;
    int _pad6_0;
    float3 rim_aim;
    int _pad7_0;
    row_major float3x3 rim_own_from_world;
    int _pad8_0;
    float3 rim_color;
    float rim_intensity;
    float2 rim_cone;
    float2 rim_fading;
    float3 fill_position;
    int _pad13_0;
    row_major float3x3 fill_own_from_world;
    int _pad14_0;
    float3 fill_color;
    float fill_intensity;
    float2 fill_fading;
    int _pad17_0;
    int _pad17_1;
    float3 sun_direction;
    int _pad18_0;
    Light sun;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 position;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

struct LitLayer {
    /// The color under this light.
    float4 color;
    /// The tone under this light.
    float tone;
};

struct FilteredLight {
    /// The light behind the filter.
    Light light;
    /// The angle for the profile.
    Angle angle;
};

struct LightParts {
    /// Unit, toward the light, world space.
    float3 direction;
    /// The light's color, opaque.
    float4 color;
    /// With the light's distance and cone attenuation; 0 or more.
    float intensity;
};

struct PlaceInLight {
    /// From 0,0 at the picture's lower left corner to 1,1 at its upper right one, as the light sees
    /// it.
    float2 uv;
    /// 1 within the picture, 0 outside of it.
    float inside;
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
static const ProfileShape lamps_eye_tone_shape = {0.87758255, 0.47942555, 8.353367, 2.4874215, 1.0,
    0.117860116, 0.05078552, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }

struct VertexOutput {
    float3 position_2 : LOC0;
    float3 normal_1 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_3 : LOC0;
    float3 normal_2 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

/// `accept` where the condition holds, else `reject`, component by component.
float3 choose(bool3 condition, float3 accept, float3 reject)
{
    return float3(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z);
}

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x)
{
    return (asuint(x) & 2139095040u) != 2139095040u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
float3 normalize_or(float3 v, float3 otherwise)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!((largest > 1e-30) & (largest < 1e30))) {
        return otherwise;
    }
    float3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, float2 t)
{
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + 0.0;
    float2 upper = c <= 0.0 ? float2(1.0, 0.0) : float2(s, c);
    float2 turned = ((s <= 0.0) & (s < c)) ? float2(0.0, 1.0) : upper;
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

/// [`bounded`], component by component.
float3 bounded_vec3(float3 v)
{
    uint3 bits = asuint(v);
    uint3 magnitude = bits & (2147483647u).xxx;
    float3 largest = asfloat((bits & (2147483648u).xxx) | (2139095039u).xxx);
    const float3 numbers = choose(magnitude == (2139095040u).xxx, largest, (0.0).xxx);
    return choose(magnitude < (2139095040u).xxx, v, numbers);
}

/// [`bounded`], component by component.
float4 bounded_vec4(float4 v)
{
    uint4 bits = asuint(v);
    uint4 magnitude = bits & (2147483647u).xxxx;
    float4 largest = asfloat((bits & (2147483648u).xxxx) | (2139095039u).xxxx);
    const float4 numbers = choose(magnitude == (2139095040u).xxxx, largest, (0.0).xxxx);
    return choose(magnitude < (2139095040u).xxxx, v, numbers);
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
float place_between(float x, float low, float high)
{
    float span = high - low;
    if (span < SMALLEST_NORMAL) {
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

/// Relative luminance by the Rec. 709 weights, of the numbers as they stand.
float luminance(float4 color)
{
    return dot(color.xyz, float3(0.2126, 0.7152, 0.0722));
}

/// Limit color
///
/// Darkens what is too bright, and keeps its hue: channels that are cut one by one turn warm light
/// yellow and then white. Channels beyond 1e18 count as that.
float4 limit_color(float4 color, float limit, float softness)
{
    float knee = 1.0 - softness;
    float brightest = max(max(color.x, color.y), color.z);
    if (brightest <= knee) {
        return float4(color.xyz, 1.0);
    }
    float room = limit - knee;
    float above = brightest - knee;
    float pressed = knee + min(above, room) * (max(above, room) / (above + room));
    return float4(color.xyz * min(pressed / brightest, 1.0), 1.0);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
float3x3 axes_around(float3 toward, float3 up)
{
    float3 leaning = cross(up, toward);
    float square = dot(leaning, leaning);
    float3 aside = abs(toward.x) > 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0);
    float3 across = square > 1e-8 ? leaning : cross(aside, toward);
    const float3 x = normalize_moderate(across - dot(across, toward) * toward,
        float3(1.0, 0.0, 0.0));
    return float3x3(x, cross(toward, x), toward);
}

/// Axes of a thing that points along `toward`, upright and then turned by `spin`, as columns.
float3x3 axes_turned(float3 toward, float spin)
{
    const float3x3 axes = axes_around(toward, float3(0.0, 1.0, 0.0));
    float2 turn = float2(0.0, 1.0);
    return float3x3(turn.y * axes[0] + turn.x * axes[1], turn.y * axes[1] - turn.x * axes[0],
        axes[2]);
}

/// A place as seen from a center along axes, within a million of it.
float3 place_along(float3 place, float3 center_, float3x3 axes)
{
    float3 away = clamp(place - center_, (-1000000.0).xxx, (1000000.0).xxx);
    return float3(dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2]));
}

/// The share of a light that passes a shape at distance m, 1 on its surface, in sizes of the shape:
/// its edge is `softness` wide outward, and never narrower than a pixel. Call it in uniform control
/// flow.
float share_beside(float m, float softness, float density, bool inverted)
{
    float half_ = 0.5 * min(footprint_of(m), 0.25);
    const float beside = eased(m, 1.0 - half_, 1.0 + half_);
    return 1.0 - beside;
}

/// An angle as a filter before the profile leaves it: tan(u/2) over the share that passes, so that
/// the dark side grows from its edge as less passes, and everything is dark where nothing does.
Angle angle_filtered(Angle u, float share)
{
    float cosine = u.half_cos * share;
    float square = u.half_sin * u.half_sin + cosine * cosine;
    float scale = rsqrt(max(square, 1e-30));
    bool is_dark = square < 1e-30;
    return ConstructAngle(is_dark ? 1.0 : u.half_sin * scale, is_dark ? 0.0 : cosine * scale);
}

/// Attenuation at `distance`: 1 / (1 + (d / half)^2), ended smoothly at the range by (1 - (d /
/// range)^4)^2. A half distance or range of 0 leaves its factor out.
float light_fading(float distance_, float2 fading)
{
    float left = 1.0;

    if (fading.x > 0.0) {
        float d = min(distance_ / fading.x, 1000000000000000.0);
        left = 1.0 / (1.0 + d * d);
    }
    if (fading.y > 0.0) {
        float d_1 = min(distance_ / fading.y, 1.0);
        float window = max(1.0 - d_1 * d_1 * d_1 * d_1, 0.0);
        left = left * (window * window);
    }
    return left;
}

Light ConstructLight(float3 direction, float3 own_direction, float3 color, float intensity) {
    Light ret = (Light)0;
    ret.direction = direction;
    ret.own_direction = own_direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}

/// A light at `light_position` seen from `position`, both in world space; `fading` is half distance
/// and range.
Light light_at(float3 light_position, float3x3 own_from_world, float3 color, float intensity,
    float2 fading, float3 position)
{
    float3 offset = light_position - position;
    const float3 direction = normalize_or(offset, float3(0.0, 0.0, 1.0));
    float faded = intensity * light_fading(length(offset), fading);
    return ConstructLight(direction, mul(direction, own_from_world), color, faded);
}

/// Attenuation at an angle from a spot light's aim: smoothstep between the cosines `cone.y` (outer)
/// and `cone.x` (inner); a hard, inclusive edge where they are equal.
float light_cone(float cos_angle, float2 cone)
{
    if (cone.x <= cone.y) {
        return cos_angle >= cone.y ? 1.0 : 0.0;
    }
    float t = clamp((cos_angle - cone.y) / (cone.x - cone.y), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Light light_spot(float3 light_position, float3 aim, float3x3 own_from_world, float3 color,
    float intensity, float2 cone, float2 fading, float3 position)
{
    Light light = (Light)0;

    light = light_at(light_position, own_from_world, color, intensity, fading, position);
    light.intensity = light.intensity * light_cone(dot(-light.direction, aim), cone);
    return light;
}

LitLayer ConstructLitLayer(float4 color, float tone) {
    LitLayer ret = (LitLayer)0;
    ret.color = color;
    ret.tone = tone;
    return ret;
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
LitLayer light_apply(Light light, float4 color, float tone)
{
    float2 split = float2(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return ConstructLitLayer(float4(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

LightParts ConstructLightParts(float3 direction, float4 color, float intensity) {
    LightParts ret = (LightParts)0;
    ret.direction = direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}

/// Light parts
///
/// Takes a light apart, for shading that the other nodes do not know.
LightParts light_parts(Light light)
{
    return ConstructLightParts(light.direction, float4(light.color, 1.0), light.intensity);
}

PlaceInLight ConstructPlaceInLight(float2 uv, float inside) {
    PlaceInLight ret = (PlaceInLight)0;
    ret.uv = uv;
    ret.inside = inside;
    return ret;
}

PlaceInLight place_in_light(float2 at)
{
    float2 near = clamp(at, (-1000.0).xx, (1000.0).xx);
    const float inside = share_beside(max(abs(near.x), abs(near.y)), 0.0, 1.0, true);
    return ConstructPlaceInLight((0.5).xx + 0.5 * float2(-near.x, near.y), inside);
}

Angle parametrization_diffuse_balanced(Light light, float3 normal)
{
    return ConstructAngle(0.5 * length(normal - light.direction), 0.5
        * length(normal + light.direction));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape)
{
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape)
{
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape)
{
    float2 place = float2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = (w > 0.0) & (w >= 3.4641016 * shape.edge_deviation);
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
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

float profile_balanced_2(Angle angle, float shift, ProfileShape shape)
{
    const Angle warped = angle_turned_2(angle, float2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

/// Window
///
/// Four panes of a window: 1 through the glass, 0 at its bars and beyond.
float window(float2 uv, float bars, float softness)
{
    float2 from_edge = (0.5).xx - abs(uv - (0.5).xx);
    float2 from_cross = abs(uv - (0.5).xx);
    float2 within = smoothstep((bars).xx, (bars + softness).xx, from_edge);
    float2 beside = smoothstep((0.5 * bars).xx, (0.5 * bars + softness).xx, from_cross);
    return within.x * within.y * beside.x * beside.y;
}

FilteredLight ConstructFilteredLight(Light light, Angle angle) {
    FilteredLight ret = (FilteredLight)0;
    ret.light = light;
    ret.angle = angle;
    return ret;
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    // Lamps eye (Lamps)
    const Light eye = light_at(look.eye_position, look.eye_own_from_world, look.eye_color,
        look.eye_intensity, look.eye_fading, surface.position);
    const LightParts eye_2 = light_parts(eye);
    const float4 lamps_eye_strength = bounded_vec4(eye_2.color
        * float4((eye_2.intensity).xxx, 1.0));
    const Angle lamps_eye_angle = parametrization_diffuse_balanced(eye, surface.normal);
    const float lamps_eye_tone = profile_balanced(lamps_eye_angle, 0.0, lamps_eye_tone_shape);
    const float4 lamps_eye_lit = bounded_vec4(lamps_eye_strength
        * float4((lamps_eye_tone).xxx, 1.0));

    // Lamps rim (Lamps)
    const Light rim = light_spot(look.rim_position, look.rim_aim, look.rim_own_from_world,
        look.rim_color, look.rim_intensity, look.rim_cone, look.rim_fading, surface.position);
    const LightParts rim_2 = light_parts(rim);
    const float4 lamps_rim_strength = bounded_vec4(rim_2.color
        * float4((rim_2.intensity).xxx, 1.0));
    const Angle lamps_rim_angle = parametrization_diffuse_balanced(rim, surface.normal);
    const float lamps_rim_tone = profile_balanced(lamps_rim_angle, 0.0, lamps_eye_tone_shape);
    const float4 lamps_rim_lit = bounded_vec4(lamps_rim_strength
        * float4((lamps_rim_tone).xxx, 1.0));

    // Lamps fill (Lamps)
    const Light fill = light_at(look.fill_position, look.fill_own_from_world, look.fill_color,
        look.fill_intensity, look.fill_fading, surface.position);
    const LightParts fill_2 = light_parts(fill);
    const float4 lamps_fill_strength = bounded_vec4(fill_2.color
        * float4((fill_2.intensity).xxx, 1.0));
    const Angle lamps_fill_angle = parametrization_diffuse_balanced(fill, surface.normal);
    const float lamps_fill_tone = profile_balanced(lamps_fill_angle, 0.0, lamps_eye_tone_shape);
    const float4 lamps_fill_lit = bounded_vec4(lamps_fill_strength
        * float4((lamps_fill_tone).xxx, 1.0));
    const float3 bounded_vec3_value = bounded_vec3((0.0).xxx + lamps_fill_lit.xyz);
    float4 lamps_fill_sum = fill_2.intensity
        > 0.0 ? float4(bounded_vec3_value, 1.0) : float4(0.0, 0.0, 0.0, 1.0);
    const float3 bounded_vec3_value_1 = bounded_vec3(lamps_fill_sum.xyz + lamps_rim_lit.xyz);

    // Lamps rim
    float4 lamps_rim_sum = rim_2.intensity
        > 0.0 ? float4(bounded_vec3_value_1, 1.0) : lamps_fill_sum;
    const float3 bounded_vec3_value_2 = bounded_vec3(lamps_rim_sum.xyz + lamps_eye_lit.xyz);

    // Lamps eye
    float4 lamps_eye_sum = eye_2.intensity
        > 0.0 ? float4(bounded_vec3_value_2, 1.0) : lamps_rim_sum;

    float4 lamplit = lamps_eye_sum * float4(0.86, 0.62, 0.44, 1.0);
    float4 night = lamplit + float4(0.1, 0.07, 0.15, 1.0);
    // Base
    float4 ground = float4(night.xyz, 1.0);
    const Angle sun_angle = parametrization_diffuse_balanced(look.sun, surface.normal);
    const float3 place_along_value = place_along(surface.position, float3(0.1, -0.05, 0.0),
        axes_turned(-look.sun_direction, 0.0));
    const PlaceInLight thrown = place_in_light(place_along_value.xy / (0.95).xx);
    const float window_2 = window(thrown.uv, 0.05, 0.02);
    const Angle angle_filtered_value = angle_filtered(sun_angle, min(window_2, 1.0)
        * min(luminance((1.0).xxxx), 1.0));
    // Light filter
    FilteredLight filter_2 = ConstructFilteredLight(look.sun, angle_filtered_value);
    const float sun_tone = profile_balanced_2(filter_2.angle, 0.0, lamps_eye_tone_shape);
    const LitLayer sun_lit = light_apply(filter_2.light, float4(0.86, 0.62, 0.44, 1.0), sun_tone);
    // Blend
    float4 stack = clamp(float4(ground.xyz + sun_lit.tone * sun_lit.color.xyz, 1.0), (0.0).xxxx,
        (1.0).xxxx);
    return limit_color(stack, 1.0, 0.3);
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

Surface ConstructSurface(float3 normal, float3 position) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.position = position;
    return ret;
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_3, input.normal_2 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen(in_.normal);
    float3 normal = is_front ? facing : -facing;
    Surface surface = ConstructSurface(normal, in_.position);
    return shade(surface);
}
