// Warped light: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Draws a mesh with the look; the result is straight RGBA.
// Registers of space 0: view b0, object b1, look b2, curvature_tensor_map t0.
// warped-light.json says what to put there and how to draw.

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
    Light back;
    Light key;
    row_major float3x3 camera_from_world;
    int _end_pad_0;
};

/// The surface under the fragment, in world space.
struct Surface {
    float3 normal;
    float3 view;
    float3 curvature_tensor;
};

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    float4 colors[16];
    /// Places of the stops, in increasing order, four to a vector.
    float4 places[4];
    /// Number of stops that count.
    uint count;
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    uint interpolation;
};

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    float4 before;
    float4 after;
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    float t;
};

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    float n_l;
    float n_v;
    float n_h;
    float v_h;
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    float sine2_;
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
static const Ramp jade = {{float4(0.0157, 0.1294, 0.1216, 1.0), float4(0.0588, 0.3529, 0.298, 1.0),
    float4(0.2471, 0.6275, 0.4784, 1.0), float4(0.7137, 0.8784, 0.6902, 1.0),
    float4(0.9333, 0.9725, 0.8471, 1.0), (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx,
    (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx, (0.0).xxxx},
    {float4(0.0, 0.35, 0.65, 0.9), float4(1.0, 0.0, 0.0, 0.0), (0.0).xxxx, (0.0).xxxx}, 5u, 0u};

cbuffer view : register(b0) { View view; }
cbuffer object : register(b1) { Object object; }
cbuffer look : register(b2) { Look look; }
Texture2D<float4> curvature_tensor_map : register(t0);

struct VertexOutput {
    float3 position : LOC0;
    float3 normal_4 : LOC1;
    float4 clip_ : SV_Position;
};

struct FragmentInput {
    float3 position_1 : LOC0;
    float3 normal_5 : LOC1;
    float4 clip_1 : SV_Position;
    bool is_front_1 : SV_IsFrontFace;
};

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

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x)
{
    float clamped = clamp(x, -126.0, 127.99999);
    float whole = round(clamped);
    float f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable_2(float x)
{
    float clamped = max(x, -126.0);
    float whole = round(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * asfloat(uint(asint(asuint(to_int(whole)) + asuint(int(126)))) << 23u);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
float3 normalize_moderate(float3 v, float3 otherwise)
{
    float square = dot(v, v);
    return square > 1e-30 ? v * rsqrt(max(square, 1e-30)) : otherwise;
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
float3 normalize_seen_balanced(float3 v)
{
    return v * rsqrt(max(dot(v, v), 1e-30));
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

/// a / b; 0 where b is 0.
float divided(float a, float b)
{
    if (abs(b) < SMALLEST_NORMAL) {
        return 0.0;
    }
    return bounded(a / b);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x)
{
    float2 d = float2(ddx(x), ddy(x));
    return sqrt(dot(d, d));
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
float srgb_of_linear(float light)
{
    float size = abs(light);
    float value = size <= 0.0031308 ? size * 12.92 : 1.055 * pow(size, 0.41666666) - 0.055;
    return light < 0.0 ? -value : value;
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
float3 oklab_of_linear(float3 rgb)
{
    float l = pow(dot(rgb, float3(0.41222146, 0.53633255, 0.051445995)), 0.33333334);
    float m = pow(dot(rgb, float3(0.2119035, 0.6806995, 0.10739696)), 0.33333334);
    float s = pow(dot(rgb, float3(0.08830246, 0.28171885, 0.6299787)), 0.33333334);
    return float3(0.21045426 * l + 0.7936178 * m - 0.004072047 * s, 1.9779985 * l - 2.4285922 * m
        + 0.4505937 * s, 0.025904037 * l + 0.78277177 * m - 0.80867577 * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
float3 linear_of_oklab(float3 lab)
{
    float l = lab.x + 0.39633778 * lab.y + 0.21580376 * lab.z;
    float m = lab.x - 0.105561346 * lab.y - 0.06385417 * lab.z;
    float s = lab.x - 0.08948418 * lab.y - 1.2914855 * lab.z;
    float3 cubes = float3(l * l * l, m * m * m, s * s * s);
    return float3(dot(cubes, float3(4.0767417, -3.3077116, 0.23096994)),
        dot(cubes, float3(-1.268438, 2.6097574, -0.34131938)),
        dot(cubes, float3(-0.0041960864, -0.7034186, 1.7076147)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
float3 oklab_of_srgb(float3 coded)
{
    const float3 oklab_of_linear_value = oklab_of_linear(float3(coded.x <= 0.04045 ? coded.x
        / 12.92 : pow((coded.x + 0.055) / 1.055, 2.4), pow((coded.y + 0.055) / 1.055, 2.4),
        pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// [`oklab_of_linear`] of an sRGB-coded color.
float3 oklab_of_srgb_2(float3 coded)
{
    const float3 oklab_of_linear_value = oklab_of_linear(float3(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
    return oklab_of_linear_value;
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
float3 srgb_of_oklab(float3 lab)
{
    const float3 light = linear_of_oklab(lab);
    return float3(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / max(rhs, 1u);
}

uint naga_mod(uint lhs, uint rhs) {
    return lhs % max(rhs, 1u);
}

RampPlace ConstructRampPlace(float4 before, float4 after, float t) {
    RampPlace ret = (RampPlace)0;
    ret.before = before;
    ret.after = after;
    ret.t = t;
    return ret;
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
RampPlace ramp_place(Ramp ramp, float x)
{
    float4 colors[16] = { (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0, (float4)0,
        (float4)0, (float4)0 };
    float4 places[4] = { (float4)0, (float4)0, (float4)0, (float4)0 };
    uint at = 0u;

    colors = ramp.colors;
    places = ramp.places;
    for (uint i = 1u; i < 5u; i++) {
        float places_now = places[min(uint(naga_div(i, 4u)), 3u)][min(uint(naga_mod(i, 4u)), 3u)];
        at = places_now <= x ? i : at;
    }
    uint after = min(at + 1u, 4u);
    float place = places[min(uint(naga_div(at, 4u)), 3u)][min(uint(naga_mod(at, 4u)), 3u)];
    float places_now_1 = places[min(uint(naga_div(after, 4u)), 3u)][min(uint(naga_mod(after, 4u)),
        3u)];
    float t = clamp(divided(x - place, places_now_1 - place), 0.0, 1.0);
    return ConstructRampPlace(colors[min(uint(at), 15u)], colors[min(uint(after), 15u)], t);
}

float4 mix_colors_screen(float4 a, float4 b, float factor)
{
    return float4(lerp(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, min(factor, 1.0)), 1.0);
}

float4 mix_colors_screen_2(float4 a, float4 b, float factor)
{
    return float4(lerp(a.xyz, a.xyz + b.xyz - a.xyz * b.xyz, factor), 1.0);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
float curvature_signed(float kappa, float slope)
{
    float a = clamp(kappa, -10000.0, 10000.0) * slope;
    float magnitude = min(abs(a), 50.0);
    if (magnitude < 0.0625) {
        float a2 = a * a;
        return a * (1.0 - a2 * (0.33333334 - a2 * (0.13333334 - a2 * 0.053968254)));
    }
    const float z = exp2_stable_2(-2.88539 * magnitude);
    float t = (1.0 - z) / (1.0 + z);
    return a >= 0.0 ? t : -t;
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

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
float3 half_of(float3 light, float3 normal, float3 view)
{
    float3 half_ = light + view;
    return normalize_moderate(dot(half_, half_) > 1e-12 ? half_ : normal, normal);
}

/// The square of the sine between two unit vectors.
float sine_squared(float3 a, float3 b)
{
    float3 across = cross(a, b);
    return min(dot(across, across), 1.0);
}

Reflection ConstructReflection(float n_l, float n_v, float n_h, float v_h, float sine2_) {
    Reflection ret = (Reflection)0;
    ret.n_l = n_l;
    ret.n_v = n_v;
    ret.n_h = n_h;
    ret.v_h = v_h;
    ret.sine2_ = sine2_;
    return ret;
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
Reflection reflection_of(float3 light, float3 normal, float3 view)
{
    const float3 half_ = half_of(light, normal, view);
    float n_h = clamp(dot(normal, half_), 0.0, 1.0);
    float v_h = clamp(dot(view, half_), 0.0, 1.0);
    const float sine_squared_value = sine_squared(normal, half_);
    return ConstructReflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared_value);
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
float schlick(float at_normal, float cosine)
{
    float m = 1.0 - cosine;
    float m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
float ggx(Reflection r, float width, float at_normal)
{
    if ((r.n_l <= 0.0) | (r.n_v <= 0.0)) {
        return 0.0;
    }
    float a2 = width * width;
    float bottom = max(r.sine2_ + a2 * r.n_h * r.n_h, 1e-12);
    float distribution = a2 / (bottom * bottom);
    float toward_light = r.n_v * sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    float toward_eye = r.n_l * sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    float visibility = 0.5 / max(toward_light + toward_eye, 1e-9);
    return min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1000000.0);
}

float4 ramp_oklab(float value, Ramp ramp)
{
    const RampPlace place = ramp_place(ramp, value);
    const float3 srgb_of_oklab_value = srgb_of_oklab(lerp(oklab_of_srgb(place.before.xyz),
        oklab_of_srgb_2(place.after.xyz), place.t));
    return place.t <= 0.0 ? place.before : (place.t
        >= 1.0 ? place.after : float4(srgb_of_oklab_value, 1.0));
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, float3 normal, float3 view, float width, float softness, float follow)
{
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of(facing), 1.0));
    float3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - 0.5 : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    float3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * rsqrt(max(dot(across, across), 1e-30)));
    return inside * lerp(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// `place` times the symmetric matrix (xx, xy, yy) in which each principal curvature k of the
/// tensor has become 2^(-amount tanh(slope k)).
float2 warped_place(float3 tensor, float2 place, float amount, float slope)
{
    const float2 k = principal_curvatures(tensor);
    const float most = exp2_stable(-amount * curvature_signed(k.x, slope));
    const float least = exp2_stable(-amount * curvature_signed(k.y, slope));
    float2 half_apart = float2(0.5 * (tensor.x - tensor.z), tensor.y);
    float2 axes = half_apart / (max(length(half_apart), 1e-20)).xx;
    float2 turned = float2(axes.x * place.x + axes.y * place.y, axes.y * place.x - axes.x
        * place.y);
    return 0.5 * (most + least) * place + 0.5 * (most - least) * turned;
}

/// The light's direction after light warping: its stereographic projection from the point opposite
/// the normal is drawn nearer along convex directions and away along concave ones.
float3 warped_light(float3 light, float3 n, float3 view, float3x3 camera_from_world, float3 tensor,
    float amount, float slope)
{
    float3 right = mul(camera_from_world, float3(1.0, 0.0, 0.0));
    const float3 x = normalize_moderate(right - dot(right, view) * view, float3(1.0, 0.0, 0.0));
    float3 y = cross(view, x);
    float3 between = (view + n) / (max(1.0 + dot(view, n), 0.01)).xxx;
    float3 along_x = x - dot(n, x) * between;
    float3 along_y = y - dot(n, y) * between;
    float2 place = float2(dot(light, along_x), dot(light, along_y))
        / (max(1.0 + dot(light, n), 0.0001)).xx;
    const float2 q = warped_place(tensor, place, amount, slope);
    float square = dot(q, q);
    return normalize_or(2.0 * q.x * along_x + 2.0 * q.y * along_y + (1.0 - square) * n, light);
}

Light ConstructLight(float3 direction, float3 own_direction, float3 color, float intensity) {
    Light ret = (Light)0;
    ret.direction = direction;
    ret.own_direction = own_direction;
    ret.color = color;
    ret.intensity = intensity;
    return ret;
}

/// Warp light
///
/// Bends a light over the surface's shape: bumps and ridges draw it toward themselves, hollows push
/// it away, so that every layer it lights shows more of the form. Flat places see it as it is, and
/// so does the outline.
Light light_warp(Light light, float3 normal, float amount, float slope, float3 tensor, float3 view,
    float3x3 camera_from_world)
{
    float most = amount * smoothstep(0.05, 0.3, dot(normal, view));
    const float3 warped = warped_light(light.direction, normal, view, camera_from_world, tensor,
        most, slope);
    bool is_flat = most == 0.0;
    return ConstructLight(is_flat ? light.direction : warped, light.own_direction, light.color,
        light.intensity);
}


/// The look at one point of the surface.
float4 shade(Surface surface)
{
    const Light bent_by_the_form = light_warp(look.key, surface.normal, 1.4, 0.03,
        surface.curvature_tensor, surface.view, look.camera_from_world);
    // Reflectance
    float through_the_stone = max((dot(surface.normal, bent_by_the_form.direction) + 0.6) / 1.6,
        0.0);
    const float4 jade_2 = ramp_oklab(through_the_stone, jade);
    // Reflectance
    const float polish = ggx(reflection_of(bent_by_the_form.direction, surface.normal,
        surface.view), 0.1764, 0.09);
    const float4 polished = mix_colors_screen(jade_2, float4(1.0, 0.9569, 0.8627, 1.0), polish);
    const float light_from_behind = rim(look.back, surface.normal, surface.view, 0.5, 0.8, 1.0);
    const float4 glowing_edge = mix_colors_screen_2(polished, float4(0.1843, 0.5608, 0.7216, 1.0),
        light_from_behind);
    return glowing_edge;
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

Surface ConstructSurface(float3 normal, float3 view, float3 curvature_tensor) {
    Surface ret = (Surface)0;
    ret.normal = normal;
    ret.view = view;
    ret.curvature_tensor = curvature_tensor;
    return ret;
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    Varyings in_ = { input.clip_1, input.position_1, input.normal_5 };
    bool is_front = input.is_front_1;
    const float3 facing = normalize_seen_balanced(in_.normal);
    float3 normal = is_front ? facing : -facing;
    float4 texel = curvature_tensor_map.Load(int3(to_int(in_.clip_.xy), int(0)));
    Surface surface = ConstructSurface(normal, normalize(view.eye.xyz - view.eye.w * in_.position),
        texel.xyz);
    return shade(surface);
}
