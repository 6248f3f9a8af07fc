// Oil portrait: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3, smooth_normal_1_map 4, smooth_normal_3_map 5.
// oil-portrait.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    screen: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// What is known before the fragment.
struct Look {
    toned_canvas: vec4f,
    viewport: vec2f,
    accents_as_paint_b: vec4f,
    @align(16) sky: Light,
    @align(16) cool_reflections_as_paint_b: vec4f,
    @align(16) key: Light,
    @align(16) thick_lights_as_paint_b: vec4f,
    light_as_paint_b: vec4f,
    half_tones_as_paint_b: vec4f,
    umber_as_paint_b: vec4f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    kappa: f32,
    smooth_normal_1: vec3f,
    smooth_normal_3: vec3f,
    pixel: vec2f,
    anchor: vec3f,
    magnification: f32,
    world_from_normal: mat3x3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;
@group(0) @binding(4) var smooth_normal_1_map: texture_2d<f32>;
@group(0) @binding(5) var smooth_normal_3_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let whole = round(x);
    let f = x - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
fn log2_stable(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    let exponent = bitcast<i32>(bits - 0x3f3504f3u) >> 23u;
    let mantissa = bitcast<f32>(bits - (bitcast<u32>(exponent) << 23u));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    return f32(exponent) + z * (2.8853900797881615 + z2 * (0.9617988482912865
        + z2 * (0.5767143098091317 + z2 * 0.43173790132006157)));
}

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
fn sin_cos_eighth(x: f32) -> vec2f {
    let s = x * (1.0 + 0.5625 * (-0.16666666666666666 + 0.5625
        * (0.00833333333333333333 + 0.5625
        * (-0.0001984126984126984 + 0.5625 * 0.00000275573192239858907))));
    let c = 1.0 - 0.5625 * (0.5 + 0.5625
        * (-0.041666666666666664 + 0.5625
        * (0.00138888888888888889 + 0.5625
        * (-2.48015873015873e-5 + 0.5625 * 2.75573192239858907e-7))));
    return vec2f(s, c);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
fn normalize_seen(v: vec3f) -> vec3f {
    return normalize_moderate(v, vec3f(0.0, 0.0, 1.0));
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
fn place_between(x: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    if abs(span) < SMALLEST_NORMAL {
        return select(0.0, 1.0, x >= high);
    }
    return bounded((x - low) / span);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(x, low, high), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
fn color_mixed(a: vec4f, blended: vec3f, factor: f32) -> vec4f {
    let b = bounded_vec3(blended);
    return vec4f(bounded_vec3(b - 0.0 * bounded_vec3(b - a.xyz)), 1.0);
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Mix colors
///
/// Lays one color on another as paint programs do. For a stack of shading layers take Blend, which
/// knows tones and transparency.
fn mix_colors_normal(a: Color, b: Color, factor: f32) -> Color {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), clamp(factor, 0.0, 1.0));
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let z = toward * inverseSqrt(dot(toward, toward));
    let leaning = cross(up, z);
    let square = dot(leaning, leaning);
    let aside = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(z.x) > 0.7);
    let across = select(cross(aside, z), leaning, square > 1e-8);
    let x = normalize_moderate(across - dot(across, z) * z, vec3f(1.0, 0.0, 0.0));
    return mat3x3f(x, cross(z, x), z);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
fn hash_pcg3d(seed: vec3u) -> vec3u {
    var v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
fn unit_of_hash(hash: vec3u) -> vec3f {
    return vec3f(hash >> vec3u(8u)) * 5.9604644775390625e-8;
}

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
}

/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const MOST_ON_SCREEN: f32 = 1e15;
/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
fn size_on_screen(depth: f32, perspective: f32, scale: f32) -> f32 {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
fn anchor_on_screen(origin: vec3f, perspective: f32, scale: f32) -> vec3f {
    let size = size_on_screen(-origin.z, perspective, scale);
    return clamp(vec3f(origin.x * size, -origin.y * size, size), vec3f(-MOST_ON_SCREEN),
        vec3f(MOST_ON_SCREEN));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
fn place_in_picture(pixel: vec2f, viewport: vec2f) -> vec2f {
    let from_middle = pixel - 0.5 * viewport;
    return vec2f(from_middle.x, -from_middle.y) / max(viewport.y, 1.0);
}

const BLUE_TILE = array<u32, 256>(
    0x27c8a652u, 0x0d3ddf58u, 0xd68cb1fdu, 0xcab465a4u,
    0x74e18943u, 0xbbd9a53fu, 0xe039f68bu, 0xb3d313a9u,
    0xb4836201u, 0x51aa198eu, 0x57321f62u, 0xe55204edu,
    0xb30b9c1au, 0x107e2290u, 0x0dca67afu, 0x77944a72u,
    0x44d8fe32u, 0xdbcb6aeeu, 0xbc709f86u, 0x28829712u,
    0x563662adu, 0xe347ecceu, 0xa0531d34u, 0xc3e524fbu,
    0x0f72219eu, 0x782a9c35u, 0xd043f201u, 0xf2c4387bu,
    0xbdfad46eu, 0x5b9e6c16u, 0x7fef95c2u, 0x863c5fbdu,
    0xd1bd5aebu, 0xc24af880u, 0x26b3e216u, 0x455ba8fbu,
    0x4b7b1291u, 0x05f52c85u, 0x2d43d374u, 0x14cdad04u,
    0xad914aa8u, 0x93b65706u, 0x4c8f5d38u, 0x1fdd0966u,
    0xea01a2bau, 0xb23dc7aau, 0x68e61487u, 0x6d50dc90u,
    0x1d3ae02cu, 0xe822d966u, 0x1ad5ab6fu, 0x2e87cc9du,
    0xd85e3fe7u, 0xdb62941eu, 0xb8a74c26u, 0x0bf3781eu,
    0xc679fa8au, 0x42a388efu, 0x348108c8u, 0x51b071e5u,
    0x3499c978u, 0xff105372u, 0xf859cb9bu, 0xb6994033u,
    0x9c095cd2u, 0x7d11304fu, 0xf3542afdu, 0xfe133ec0u,
    0xb4f51a65u, 0x7cbbe483u, 0x83096e35u, 0x1b63c5d6u,
    0x6f25c146u, 0xe05cb0d4u, 0x8cb69b68u, 0xd598025fu,
    0x48088aa7u, 0x4406cf29u, 0x1892f0afu, 0x80eb54a2u,
    0x8ee9a136u, 0xbc02f73eu, 0x21db154bu, 0x277eec47u,
    0x6cc45837u, 0x678ea4efu, 0xbf49d920u, 0xae002973u,
    0x64b51175u, 0x9583c519u, 0xa477cf37u, 0x4eb2c66cu,
    0x96ddb9e9u, 0xe8551b3bu, 0xe7612fc6u, 0xde93f63bu,
    0xe14bfd58u, 0x2371a32cu, 0xfa0bacf1u, 0x8f1bde32u,
    0x7a180c72u, 0x7fb9d45fu, 0xa78b039au, 0xcd69b50fu,
    0x79058830u, 0x53eb42cfu, 0x59418b64u, 0xa3610685u,
    0xacfc42ceu, 0x380df32du, 0xd078fc4du, 0x21448452u,
    0x98bad7aau, 0xd809ae5au, 0xcde72bc0u, 0xf13cbf99u,
    0x4b9d8229u, 0x6da088c9u, 0x2a1cd8b0u, 0x9d14e3bdu,
    0x1c3a6bf0u, 0x7f178bf6u, 0x75b10e9eu, 0x6be25123u,
    0x07db5ab7u, 0x15e02465u, 0x6c405dc0u, 0xc561f896u,
    0x2951800au, 0x3d6ec8e4u, 0x15664dffu, 0x0e7ca9f6u,
    0xee35941eu, 0xf54577bfu, 0xa5ed9032u, 0x47793506u,
    0xa0c2df92u, 0x20b54863u, 0x3ae195cau, 0xd6318cd2u,
    0x1671c7f4u, 0xa85991b2u, 0xdc7d0ecdu, 0x27d3af55u,
    0x74fc155cu, 0xdda63301u, 0xb8812e5bu, 0x569b4902u,
    0x528941aeu, 0x81003ae4u, 0xc24a2769u, 0xb9e9891fu,
    0x86ac409au, 0x8d7bf1d5u, 0x71a4ee0au, 0x26eac460u,
    0xd1a50566u, 0xd59cf720u, 0xff97b7ebu, 0x6a113b70u,
    0x572233cbu, 0x6950c110u, 0x2543be19u, 0x768418fau,
    0x7e2ffebbu, 0x4e2dc363u, 0x04603d17u, 0xf34ea1ceu,
    0xb8ecda79u, 0xfb3e2891u, 0xda54d29au, 0xcf3bb192u,
    0x98da4811u, 0x8aac730bu, 0x33a97ae2u, 0x07b282e5u,
    0x6f49648du, 0xabcce79fu, 0x08897637u, 0xa050e131u,
    0x58b58fe6u, 0x0fbb45ecu, 0x90f5ca56u, 0xc12b591au,
    0xd00ca81eu, 0x03805e18u, 0xc764e622u, 0x5e0d6da6u,
    0x19366a21u, 0x6bfb25cbu, 0xbc471fa2u, 0xf940de67u,
    0x7cf03955u, 0x8fbc4431u, 0xf413b34du, 0xc9f97e46u,
    0x76a6f188u, 0x923984dfu, 0x0a752fd7u, 0x9774d19eu,
    0xb486c5e3u, 0xd468f8deu, 0xbf5b9fefu, 0x2db69823u,
    0x4e05c042u, 0x025d9db1u, 0xee85b0e8u, 0x00af264fu,
    0x4f9b2a6bu, 0x0f28a507u, 0x3c872f73u, 0xd65500d9u,
    0xf9607b12u, 0x4cd2172eu, 0xc63e63beu, 0xba81f416u,
    0x1d60fd14u, 0xc8549575u, 0x691bdf41u, 0xa98c76eau,
    0x8eda9ae8u, 0x7cf26fc7u, 0x94dc1028u, 0x48365fa7u,
    0x3fccaadcu, 0x82aee9d7u, 0xcc96f9b8u, 0x1c4934adu,
    0x4623386du, 0xa23cb70cu, 0x3153fe8du, 0x8dcee670u,
    0xb92c700cu, 0x5e37128au, 0x0e50a303u, 0xd0ffbe5du,
    0xabedba5au, 0x1ce35684u, 0x7dc3ab6au, 0x579f2004u,
    0x4cf2967fu, 0xd124f767u, 0xf07a2b6eu, 0x08932485u,
    0x65137da1u, 0xc93097d3u, 0xd7450aeau, 0xc141f7b7u,
    0x07e2391du, 0x93be7aa1u, 0x17c446e4u, 0x3073dd3fu,
    0x2bc34ff4u, 0x4d6103fcu, 0x5c992577u, 0xed682e87u,
);
/// Index of the number of the repeating tile that holds a cell's rank.
fn blue_index(cell: vec2i) -> u32 {
    let at = bitcast<vec2u>(cell) & vec2u(31u);
    return 8u * at.y + (at.x >> 2u);
}

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    place: vec2f,
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    stretch: vec3f,
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
fn mark_place_of(place: vec2f, along: vec3f, across: vec3f, angle: f32) -> StretchedPlace {
    let turn = clamp(vec2f(0.0, 1.0), vec2f(-1.0), vec2f(1.0));
    let x = bounded_vec3(turn.y * along + turn.x * across);
    let y = bounded_vec3(turn.y * across - turn.x * along);
    let turned = vec2f(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    let most = vec3f(1e15);
    let stretch = clamp(vec3f(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return StretchedPlace(turned, stretch);
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
fn mark_place_of_2(place: vec2f, along: vec3f, across: vec3f, angle: f32) -> StretchedPlace {
    let turn = clamp(sin_cos_eighth(0.75), vec2f(-1.0), vec2f(1.0));
    let x = turn.y * along + turn.x * across;
    let y = turn.y * across - turn.x * along;
    let turned = vec2f(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    let stretch = vec3f(dot(x, x), dot(x, y), dot(y, y));
    return StretchedPlace(turned, stretch);
}

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
fn gradient_on_picture(g: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let facing = dot(normal, view);
    return g - normal * (dot(g, view) / select(min(facing, -0.125), max(facing, 0.125),
        facing >= 0.0));
}

/// A place on a surface for strokes across an axis of the object.
fn place_across(axis: vec3f, position: vec3f, world_from_normal: mat3x3f, normal: vec3f,
    view: vec3f, magnification: f32, angle: f32) -> StretchedPlace {
    let axes = axes_around(axis, vec3f(0.0, 1.0, 0.0));
    let place = vec2f(dot(position, axes[0]), dot(position, axes[2]));
    let along = world_from_normal * axes[0];
    let across = world_from_normal * axes[2];
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
fn place_on_surface(place: vec2f, along: vec3f, across: vec3f, normal: vec3f, view: vec3f,
    magnification: f32, angle: f32) -> StretchedPlace {
    let height = 1.0 / clamp(magnification, 1e-15, 1e15);
    let x = bounded_vec3(gradient_on_picture(along, normal, view) * height);
    let y = bounded_vec3(gradient_on_picture(across, normal, view) * height);
    return mark_place_of(place, x, y, angle);
}

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    place: vec2f,
    stretch: vec3f,
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
fn spaced(place: vec2f, stretch: vec3f, viewport: vec2f, count: f32) -> SpacedPlace {
    let is_pixel = !(stretch.x + stretch.z > 0.0);
    let scale = select(count, count / max(viewport.y, 1.0), is_pixel);
    let p = clamp(place * scale, vec2f(-4194304.0), vec2f(4194304.0));
    let s = clamp(bounded_vec3(stretch), vec3f(-1000000000000000.0), vec3f(1e15));
    return SpacedPlace(p, select(s, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
fn spaced_2(place: vec2f, stretch: vec3f, viewport: vec2f, count: f32) -> SpacedPlace {
    let is_pixel = !(stretch.x + stretch.z > 0.0);
    let scale = select(count, count / max(viewport.y, 1.0), is_pixel);
    let p = clamp(place * scale, vec2f(-4194304.0), vec2f(4194304.0));
    return SpacedPlace(p, select(stretch, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
fn area_square(stretch: vec3f) -> f32 {
    let sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

/// Style of brush strokes.
struct Brush {
    /// Length of a stroke over its width.
    aspect: f32,
    /// Size of a stroke over that of its cell.
    size: f32,
    /// Scatter of strokes around the middles of their cells, 0 to 1.
    scatter: f32,
    /// Range of the strokes' angles, both sides together, in radians.
    turn: f32,
    seed: u32,
    /// True if the picture's dark texels are paint; false if its opaque ones are.
    is_dark: bool,
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var i: i32;
    var octave = 0;
    var paint = vec2f(0.0);
    var tile = BLUE_TILE;
    loop {
        if !(octave < 2) {
            break;
        }
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = bitcast<f32>(u32(i32(zoom) + octave + 127) << 23u);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = (corner % 3 + 3) % 3;
        i = 0;
        loop {
            if !(i < 9) {
                break;
            }
            let cell = corner + (vec2i(i % 3, i / 3) - phase + 4) % 3 - 1;
            let turning = cell + vec2i(1i, 7 * (i32(zoom) + octave));
            let late = 0.96875 * ((f32((tile[blue_index(turning)]
                >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned(dx * scale, stroke, style);
                let gy = brush_turned(dy * scale, stroke, style);
                let own = hash_pcg3d(bitcast<vec3u>(vec3i(cell, i32(zoom) + octave)) + 3u
                    * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
            continuing {
                i = i + 1;
            }
        }
        continuing {
            octave = octave + 1;
        }
    }
    return paint;
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid_2(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var i: i32;
    var octave = 0;
    var paint = vec2f(0.0);
    var tile = BLUE_TILE;
    loop {
        if !(octave < 2) {
            break;
        }
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = bitcast<f32>(u32(i32(zoom) + octave + 127) << 23u);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = (corner % 3 + 3) % 3;
        i = 0;
        loop {
            if !(i < 9) {
                break;
            }
            let cell = corner + (vec2i(i % 3, i / 3) - phase + 4) % 3 - 1;
            let turning = cell + vec2i(6i, 7 * (i32(zoom) + octave));
            let late = 0.96875 * ((f32((tile[blue_index(turning)]
                >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke_2(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned_2(dx * scale, stroke, style);
                let gy = brush_turned_2(dy * scale, stroke, style);
                let own = hash_pcg3d(bitcast<vec3u>(vec3i(cell, i32(zoom) + octave)) + 8u
                    * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
            continuing {
                i = i + 1;
            }
        }
        continuing {
            octave = octave + 1;
        }
    }
    return paint;
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid_3(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var i: i32;
    var octave = 0;
    var paint = vec2f(0.0);
    var tile = BLUE_TILE;
    loop {
        if !(octave < 2) {
            break;
        }
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = bitcast<f32>(u32(i32(zoom) + octave + 127) << 23u);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = (corner % 3 + 3) % 3;
        i = 0;
        loop {
            if !(i < 9) {
                break;
            }
            let cell = corner + (vec2i(i % 3, i / 3) - phase + 4) % 3 - 1;
            let turning = cell + vec2i(2i, 7 * (i32(zoom) + octave));
            let late = 0.96875 * ((f32((tile[blue_index(turning)]
                >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke_3(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned(dx * scale, stroke, style);
                let gy = brush_turned(dy * scale, stroke, style);
                let own = hash_pcg3d(bitcast<vec3u>(vec3i(cell, i32(zoom) + octave)) + 4u
                    * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
            continuing {
                i = i + 1;
            }
        }
        continuing {
            octave = octave + 1;
        }
    }
    return paint;
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid_4(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var i: i32;
    var octave = 0;
    var paint = vec2f(0.0);
    var tile = BLUE_TILE;
    loop {
        if !(octave < 2) {
            break;
        }
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = bitcast<f32>(u32(i32(zoom) + octave + 127) << 23u);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0)) / vec2f(3.0, 1.0);
        let corner = vec2i(floor(p));
        let phase = (corner % 3 + 3) % 3;
        i = 0;
        loop {
            if !(i < 9) {
                break;
            }
            let cell = corner + (vec2i(i % 3, i / 3) - phase + 4) % 3 - 1;
            let turning = cell + vec2i(3i, 7 * (i32(zoom) + octave));
            let late = 0.96875 * ((f32((tile[blue_index(turning)]
                >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke_4(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned_3(dx * scale, stroke, style);
                let gy = brush_turned_3(dy * scale, stroke, style);
                let own = hash_pcg3d(bitcast<vec3u>(vec3i(cell, i32(zoom) + octave)) + 5u
                    * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
            continuing {
                i = i + 1;
            }
        }
        continuing {
            octave = octave + 1;
        }
    }
    return paint;
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid_5(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var i: i32;
    var octave = 0;
    var paint = vec2f(0.0);
    var tile = BLUE_TILE;
    loop {
        if !(octave < 2) {
            break;
        }
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = bitcast<f32>(u32(i32(zoom) + octave + 127) << 23u);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = (corner % 3 + 3) % 3;
        i = 0;
        loop {
            if !(i < 9) {
                break;
            }
            let cell = corner + (vec2i(i % 3, i / 3) - phase + 4) % 3 - 1;
            let turning = cell + vec2i(4i, 7 * (i32(zoom) + octave));
            let late = 0.96875 * ((f32((tile[blue_index(turning)]
                >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke_5(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned(dx * scale, stroke, style);
                let gy = brush_turned(dy * scale, stroke, style);
                let own = hash_pcg3d(bitcast<vec3u>(vec3i(cell, i32(zoom) + octave)) + 6u
                    * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
            continuing {
                i = i + 1;
            }
        }
        continuing {
            octave = octave + 1;
        }
    }
    return paint;
}

/// [`brushed`] by bristles, without a picture: premultiplied lightness in x, coverage in y.
fn bristles_laid_6(at: SpacedPlace, ink: f32, style: Brush) -> vec2f {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let fine = (1.0 - (1.0 - f) * coarse_cells) / (4.0 * coarse_cells);
    var i: i32;
    var octave = 0;
    var paint = vec2f(0.0);
    var tile = BLUE_TILE;
    loop {
        if !(octave < 2) {
            break;
        }
        let amount = ink * select(1.0 - f, fine, octave == 1);
        let scale = bitcast<f32>(u32(i32(zoom) + octave + 127) << 23u);
        let p = clamp(at.place * scale, vec2f(-4194304.0), vec2f(4194304.0))
            / vec2f(style.aspect, 1.0);
        let corner = vec2i(floor(p));
        let phase = (corner % 3 + 3) % 3;
        i = 0;
        loop {
            if !(i < 9) {
                break;
            }
            let cell = corner + (vec2i(i % 3, i / 3) - phase + 4) % 3 - 1;
            let turning = cell + vec2i(8i, 7 * (i32(zoom) + octave));
            let late = 0.96875 * ((f32((tile[blue_index(turning)]
                >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
            let share = clamp((amount - late) * 32.0, 0.0, 1.0);
            if share <= 0.0 {
                continue;
            }
            let stroke = brush_stroke_6(p, cell, i32(zoom) + octave, share, style);
            if stroke.share > 0.0 {
                let gx = brush_turned_2(dx * scale, stroke, style);
                let gy = brush_turned_2(dy * scale, stroke, style);
                let own = hash_pcg3d(bitcast<vec3u>(vec3i(cell, i32(zoom) + octave)) + 10u
                    * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)).x;
                let drawn = bristles(stroke.uv, length(vec2f(gx.y, gy.y)), own);
                let cover = stroke.share * drawn.y;
                paint = vec2f(drawn.x * cover, cover) + paint * (1.0 - cover);
            }
            continuing {
                i = i + 1;
            }
        }
        continuing {
            octave = octave + 1;
        }
    }
    return paint;
}

/// Three random numbers of a bristle, 0 to 1; across a stroke they go over smoothly into those of
/// the next bristle.
fn bristle(row: f32, seed: u32) -> vec3f {
    let first = floor(row);
    let t = row - first;
    let a = unit_of_hash(lattice_hash(vec3i(i32(first), 0, 0), seed));
    let b = unit_of_hash(lattice_hash(vec3i(i32(first) + 1, 0, 0), seed));
    return mix(a, b, t * t * (3.0 - 2.0 * t));
}

/// A stroke of a stiff brush at the place `uv` in it: lightness of its paint in x, coverage in y.
/// `width` is a pixel's share of the stroke's width.
fn bristles(uv: vec2f, width: f32, seed: u32) -> vec2f {
    let across = 2.0 * uv.y - 1.0;
    let own = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(0, 1, 0)) + seed
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let seen = clamp(1.75 - 11.0 * width, 0.0, 1.0);
    let chance = mix(vec3f(0.5), bristle(11.0 * uv.y, seed), seen);
    let start = 0.03 + 0.12 * chance.x + 0.09 * across * across;
    let end = 0.97 - (0.1 + 0.25 * own.y) * chance.y - 0.12 * across * across;
    let along = eased(uv.x, start, start + 0.05) * (1.0 - eased(uv.x, end - 0.1, end));
    let side = 1.0 - smoothstep(0.78, 0.95, abs(across));
    let dry = smoothstep(0.85, 1.25, uv.x + 0.55 * chance.z);
    let shade = 0.8 + 0.16 * own.z + 0.208 * (chance.z - 0.5) - 0.05 * uv.x;
    return vec2f(clamp(shade, 0.0, 1.0), along * side * (1.0 - 0.9 * dry));
}

/// A stroke as seen at a place.
struct Brushstroke {
    /// Place in the stroke's picture, v down.
    uv: vec2f,
    /// Sine and cosine of the stroke's angle.
    turn: vec2f,
    /// Direction of the stroke: 1 forward, -1 backward.
    way: f32,
    /// Share of the stroke that is there, 0 to 1.
    share: f32,
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 1u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let x = 0.5 * (chance.z - 0.5);
    let turn = vec2f(sin(x), cos(x));
    let way = select(-1.0, 1.0, (vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 2u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8).x
        < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned(offset * vec2f(style.aspect, 1.0), stroke, style);
    let from_edge = min(uv, 1.0 - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return Brushstroke(uv, turn, way, share);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke_2(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 6u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let x = 0.5 * (chance.z - 0.5);
    let turn = vec2f(sin(x), cos(x));
    let way = select(-1.0, 1.0, (vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 7u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8).x
        < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned_2(offset * vec2f(style.aspect, 1.0), stroke, style);
    let from_edge = min(uv, 1.0 - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return Brushstroke(uv, turn, way, share);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke_3(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 2u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let x = 0.5 * (chance.z - 0.5);
    let turn = vec2f(sin(x), cos(x));
    let way = select(-1.0, 1.0, (vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 3u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8).x
        < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned(offset * vec2f(style.aspect, 1.0), stroke, style);
    let from_edge = min(uv, 1.0 - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return Brushstroke(uv, turn, way, share);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke_4(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 3u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let x = 0.5 * (chance.z - 0.5);
    let turn = vec2f(sin(x), cos(x));
    let way = select(-1.0, 1.0, (vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 4u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8).x
        < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned_3(offset * vec2f(3.0, 1.0), stroke, style);
    let from_edge = min(uv, 1.0 - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return Brushstroke(uv, turn, way, share);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke_5(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 4u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let x = style.turn * (chance.z - 0.5);
    let turn = vec2f(sin(x), cos(x));
    let way = select(-1.0, 1.0, (vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 5u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8).x
        < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned(offset * vec2f(style.aspect, 1.0), stroke, style);
    let from_edge = min(uv, 1.0 - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return Brushstroke(uv, turn, way, share);
}

/// The stroke of `cell` at the place `p`, in cells; `drawn` is the share of it that is there.
fn brush_stroke_6(p: vec2f, cell: vec2i, zoom: i32, drawn: f32, style: Brush) -> Brushstroke {
    let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 8u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
    let offset = p - (vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5));
    let x = style.turn * (chance.z - 0.5);
    let turn = vec2f(sin(x), cos(x));
    let way = select(-1.0, 1.0, (vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 9u
        * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8).x
        < 0.5);
    let stroke = Brushstroke(vec2f(0.5), turn, way, 0.0);
    let uv = 0.5 + brush_turned_2(offset * vec2f(style.aspect, 1.0), stroke, style);
    let from_edge = min(uv, 1.0 - uv);
    let inside = clamp(64.0 * min(from_edge.x, from_edge.y), 0.0, 1.0);
    let far = max(abs(offset.x), abs(offset.y)) / (1.0 - 0.5 * style.scatter);
    let share = drawn * inside * (1.0 - smoothstep(0.85, 1.0, far));
    return Brushstroke(uv, turn, way, share);
}

/// A step on the canvas as a step in a stroke's picture.
fn brush_turned(step: vec2f, stroke: Brushstroke, style: Brush) -> vec2f {
    let turned = vec2f(
        stroke.turn.y * step.x + stroke.turn.x * step.y,
        stroke.turn.y * step.y - stroke.turn.x * step.x,
    );
    return turned * vec2f(stroke.way / (style.size * style.aspect), -1.0 / style.size);
}

/// A step on the canvas as a step in a stroke's picture.
fn brush_turned_2(step: vec2f, stroke: Brushstroke, style: Brush) -> vec2f {
    let turned = vec2f(stroke.turn.y * step.x + stroke.turn.x * step.y, stroke.turn.y * step.y
        - stroke.turn.x * step.x);
    return turned * vec2f(stroke.way / (1.5 * style.aspect), -1.0 / 1.5);
}

/// A step on the canvas as a step in a stroke's picture.
fn brush_turned_3(step: vec2f, stroke: Brushstroke, style: Brush) -> vec2f {
    let turned = vec2f(stroke.turn.y * step.x + stroke.turn.x * step.y, stroke.turn.y * step.y
        - stroke.turn.x * step.x);
    return turned * vec2f(stroke.way / 4.5, -1.0 / 1.5);
}

fn brush_strokes_bristles(value: f32, place: vec2f, stretch: vec3f, count: f32, aspect: f32,
    size: f32, scatter: f32, turn: f32, seed: i32, viewport: vec2f) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = Brush(aspect, size, scatter, turn, 1u, false);
    let paint = bristles_laid(at, 1.0 - value, style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

fn brush_strokes_bristles_2(value: f32, place: vec2f, stretch: vec3f, count: f32, aspect: f32,
    size: f32, scatter: f32, turn: f32, seed: i32, viewport: vec2f) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = Brush(aspect, size, scatter, turn, 6u, false);
    let paint = bristles_laid_2(at, 1.0 - value, style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

fn brush_strokes_bristles_3(value: f32, place: vec2f, stretch: vec3f, count: f32, aspect: f32,
    size: f32, scatter: f32, turn: f32, seed: i32, viewport: vec2f) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = Brush(aspect, size, scatter, turn, 2u, false);
    let paint = bristles_laid_3(at, 1.0 - value, style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

fn brush_strokes_bristles_4(value: f32, place: vec2f, stretch: vec3f, count: f32, aspect: f32,
    size: f32, scatter: f32, turn: f32, seed: i32, viewport: vec2f) -> BrushStrokes {
    let at = spaced_2(place, stretch, viewport, count);
    let style = Brush(aspect, size, scatter, turn, 3u, false);
    let paint = bristles_laid_4(at, 1.0 - value, style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

fn brush_strokes_bristles_5(value: f32, place: vec2f, stretch: vec3f, count: f32, aspect: f32,
    size: f32, scatter: f32, turn: f32, seed: i32, viewport: vec2f) -> BrushStrokes {
    let at = spaced_2(place, stretch, viewport, count);
    let style = Brush(aspect, size, scatter, turn, 4u, false);
    let paint = bristles_laid_5(at, 1.0 - value, style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

fn brush_strokes_bristles_6(value: f32, place: vec2f, stretch: vec3f, count: f32, aspect: f32,
    size: f32, scatter: f32, turn: f32, seed: i32, viewport: vec2f) -> BrushStrokes {
    let at = spaced(place, stretch, viewport, count);
    let style = Brush(aspect, size, scatter, turn, 8u, false);
    let paint = bristles_laid_6(at, 1.0 - value, style);
    let shade = paint.x / max(paint.y, 1e-3);
    return BrushStrokes(vec4f(shade, shade, shade, 1.0), paint.y);
}

struct BrushStrokes {
    /// The picture's own color, opaque; of bristles how light their paint lies, to multiply a
    /// color by; black where no stroke is.
    color: Color,
    /// How much of the canvas is covered, from 0 to 1.
    ink: f32,
}

fn mark_place_axis(axis: vec3f, normal: vec3f, angle: f32, view: vec3f, position_object: vec3f,
    world_from_normal: mat3x3f, magnification: f32) -> MarkPlace {
    let m = place_across(axis, position_object, world_from_normal, normal, view, magnification,
        angle);
    return MarkPlace(m.place, m.stretch);
}

fn mark_place_object(angle: f32, anchor: vec3f, pixel: vec2f, viewport: vec2f) -> MarkPlace {
    let size = clamp(anchor.z, 1e-6, 1e6);
    let place = (place_in_picture(pixel, viewport) - vec2f(anchor.x, -anchor.y)) / size;
    let m = mark_place_of_2(place, vec3f(1.0 / size, 0.0, 0.0), vec3f(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}

fn reflectance_half_lambert(light: Light, normal: vec3f) -> f32 {
    let half = 0.5 + 0.5 * dot(normal, light.direction);
    return min(half * half, 1.0);
}

/// Map range
///
/// Moves numbers from one range to another: depth to fog, curvature to a mask. Where the first
/// range is empty, all that is below it becomes the new low and the rest the new high. A color
/// keeps its alpha, within 0 and 1 while clamped.
fn map_range(value: f32, from_low: f32, from_high: f32, to_low: f32, to_high: f32, clamped: bool)
    -> f32 {
    return mix(to_low, to_high, clamp((value - from_low) / (from_high - from_low), 0.0, 1.0));
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let planes = normalize_moderate(surface.smooth_normal_1, surface.normal);
    let light_and_shade = reflectance_half_lambert(look.key, planes);
    let where_umber_goes = map_range(light_and_shade, 0.02, 0.2, 1.0, 0.0, true);
    let large_forms = normalize_moderate(surface.smooth_normal_3, surface.normal);
    let strokes_round_the_form = mark_place_axis(vec3f(0.35, 1.0, 0.25), large_forms, 0.0,
        surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    let umber = brush_strokes_bristles(where_umber_goes, strokes_round_the_form.place,
        strokes_round_the_form.stretch, 14.0, 3.4, 1.8, 0.6, 0.5, 1i, look.viewport);
    // Mix colors
    let umber_as_paint = color_mixed(umber.color, umber.color.xyz * look.umber_as_paint_b.xyz, 1.0);
    // Mix colors
    let umber_laid_on = mixed_vec4(look.toned_canvas, bounded_vec4(umber_as_paint),
        clamp(umber.ink, 0.0, 1.0));
    // Reflectance
    let reflected_light = max(dot(planes, look.sky.direction), 0.0);
    let where_cool_reflections_go = mix(1.0, 0.0, clamp((reflected_light - 0.25) / 0.5, 0.0, 1.0));
    let cool_reflections = brush_strokes_bristles_2(where_cool_reflections_go,
        strokes_round_the_form.place, strokes_round_the_form.stretch, 18.0, 3.2, 1.5, 0.6, 0.5, 6i,
        look.viewport);
    // Mix colors
    let cool_reflections_as_paint = color_mixed(cool_reflections.color, cool_reflections.color.xyz
        * look.cool_reflections_as_paint_b.xyz, 1.0);
    let cool_reflections_laid_on = mix_colors_normal(umber_laid_on, cool_reflections_as_paint,
        cool_reflections.ink);
    let where_half_tones_go = map_range(light_and_shade, 0.24, 0.42, 1.0, 0.0, true);
    let half_tones = brush_strokes_bristles_3(where_half_tones_go, strokes_round_the_form.place,
        strokes_round_the_form.stretch, 18.0, 3.2, 1.6, 0.6, 0.5, 2i, look.viewport);
    // Mix colors
    let half_tones_as_paint = color_mixed(half_tones.color, half_tones.color.xyz
        * look.half_tones_as_paint_b.xyz, 1.0);
    let half_tones_laid_on = mix_colors_normal(cool_reflections_laid_on, half_tones_as_paint,
        half_tones.ink);
    let where_light_goes = map_range(light_and_shade, 0.46, 0.66, 1.0, 0.0, true);
    let strokes_of_the_wrist = mark_place_object(0.75, surface.anchor, surface.pixel,
        look.viewport);
    let light = brush_strokes_bristles_4(where_light_goes, strokes_of_the_wrist.place,
        strokes_of_the_wrist.stretch, 24.0, 3.0, 1.5, 0.6, 0.5, 3i, look.viewport);
    // Mix colors
    let light_as_paint = color_mixed(light.color, light.color.xyz * look.light_as_paint_b.xyz, 1.0);
    let light_laid_on = mix_colors_normal(half_tones_laid_on, light_as_paint, light.ink);
    let where_thick_lights_go = map_range(light_and_shade, 0.76, 0.95, 1.0, 0.0, true);
    let thick_lights = brush_strokes_bristles_5(where_thick_lights_go, strokes_of_the_wrist.place,
        strokes_of_the_wrist.stretch, 32.0, 2.6, 1.3, 0.6, 0.4, 4i, look.viewport);
    // Mix colors
    let thick_lights_as_paint = color_mixed(thick_lights.color, thick_lights.color.xyz
        * look.thick_lights_as_paint_b.xyz, 1.0);
    let thick_lights_laid_on = mix_colors_normal(light_laid_on, thick_lights_as_paint,
        thick_lights.ink);
    let hollows = surface.kappa;
    let where_accents_go = mix(1.0, 0.0, clamp((hollows + 6.0) / -14.0, 0.0, 1.0));
    let accents = brush_strokes_bristles_6(where_accents_go, strokes_round_the_form.place,
        strokes_round_the_form.stretch, 44.0, 3.4, 1.5, 0.6, 0.4, 8i, look.viewport);
    // Mix colors
    let accents_as_paint = color_mixed(accents.color, accents.color.xyz
        * look.accents_as_paint_b.xyz, 1.0);
    let accents_laid_on = mix_colors_normal(thick_lights_laid_on, accents_as_paint, accents.ink);
    let output_alpha = vec4f(accents_laid_on.xyz, clamp(accents_laid_on.w, 0.0, 1.0));
    return output(premultiplied(output_alpha));
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) position_object: vec3f,
    @location(2) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, vertex.position,
        object.world_from_normal * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        in.position_object, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x,
        (vec4f(textureLoad(smooth_normal_1_map, vec2i(in.clip.xy), 0).xyz, 0.0)
        * view.camera_from_world).xyz, (vec4f(textureLoad(smooth_normal_3_map, vec2i(in.clip.xy),
        0).xyz, 0.0) * view.camera_from_world).xyz, in.clip.xy * view.screen.xy + view.screen.zw,
        anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz,
        view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))), size_on_screen(-(view.camera_from_world
        * vec4f(in.position, 1.0)).z, view.eye.w,
        length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))), object.world_from_normal);
    return finite_vec4(shade(surface));
}
