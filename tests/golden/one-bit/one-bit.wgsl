// One bit: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3.
// one-bit.json says what to put there and how to draw.

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
    camera_from_world: mat3x3f,
    viewport: vec2f,
    @align(16) back: Light,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_camera: vec3f,
    curvature_tensor: vec3f,
    pixel: vec2f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    half_sin: f32,
    /// cos(u/2), 0 or more.
    half_cos: f32,
}

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

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - 0.0;
    let upper = select(vec2f(s, u.half_cos), vec2f(1.0, 0.0), u.half_cos <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < u.half_cos));
    return Angle(turned.x, turned.y);
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of_2(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    return vec4f(below.xyz + tone * (color.xyz - below.xyz), 1.0);
}

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    half_cos_offset: f32,
    half_sin_offset: f32,
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    scale: f32,
    /// gamma of BADF eq. 11.
    exponent: f32,
    /// tau, the step's place, in radians.
    offset: f32,
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    edge_mean: f32,
    edge_deviation: f32,
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    kind: u32,
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(max(1.0 - q * q, 0.0), shape.exponent), 1.0, s <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
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

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let edge = min(footprint_of_2(facing), 1.0);
    let aside = normal - view;
    let further = select(width - facing, 0.5 * dot(aside, aside) - (1.0 - width), facing > 0.5);
    let within = further / max(edge, 1e-6) + 0.5;
    let inside = clamp(within, 0.0, 1.0);
    let across = light.direction - dot(light.direction, view) * view;
    let side = dot(normal - dot(normal, view) * view, across
        * inverseSqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// Dither
///
/// Cuts a tone into few flat ones and lets single pixels decide between two of them, so that the
/// average stays: pixel art, woodcut grain, bands whose edges are sprinkled. Bayer's matrices make
/// a regular weave; blue noise has neither a pattern nor clumps; white noise is chance.
fn dither_blue(value: f32, place: vec2f, levels: i32, spread: f32, size: f32) -> f32 {
    let cell = vec2i(floor(place / size));
    return select(0.0, 1.0, value - 0.0 - 0.5
        >= (f32((BLUE_TILE[blue_index(cell)] >> (8u * (bitcast<u32>(cell.x) & 3u))) & 0xffu)
        + 0.5) * 0.00390625 - 0.5);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
fn inner_contour_suggestive(width: f32, limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f, camera_from_world: mat3x3f, place: vec3f, viewport: vec2f) -> f32 {
    let n = camera_from_world * normal;
    let square = dot(n.xy, n.xy);
    let radial = (tensor.x * n.x * n.x + 2.0 * tensor.y * n.x * n.y + tensor.z * n.y * n.y)
        / max(square, 1e-6);
    let change = vec2f(dpdx(radial), dpdy(radial));
    let v = camera_from_world * view;
    let row = dpdy(place);
    let up = select(-1.0, 1.0, (row - dot(row, v) * v).y >= 0.0);
    let height = clamp(viewport.y, 1.0, 1e5);
    let toward_eye = -(change.x * n.x + up * change.y * n.y) * inverseSqrt(max(square, 1e-6));
    let pixels = 1.5 * height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    let x = toward_eye * height * 0.05;
    let strength = clamp(0.5 + (x - limit)
        / length(vec2f(min(footprint_of(x), 1e15), limit * softness)), 0.0, 1.0);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * strength
        * smoothstep(0.05, 0.3, dot(normal, view));
}

const tone_shape = ProfileShape(0.99875027, 0.04997917, 1.229384, 1.5428282, 0.1, 1.0145569,
    0.43140125, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let turned_from_the_key = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let tone = profile_balanced(turned_from_the_key, 0.0, tone_shape);
    let spray = dither_blue(tone, surface.pixel, 2i, 1.0, 2.0);
    let edge_of_light = rim(look.back, surface.normal, surface.view, 0.34, 0.0, 1.0);
    // Combine tones
    let both_lights = max(spray, edge_of_light);
    let line = inner_contour_suggestive(3.0, 20.0, 0.1, surface.curvature_tensor, surface.normal,
        surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    // Combine tones
    let lines_cut_out = min(both_lights, 1.0 - line);
    let light = blend_alpha(vec4f(0.1333, 0.1216, 0.2, 1.0), vec4f(0.9373, 0.902, 0.8118, 1.0),
        lines_cut_out, 1.0, true);
    return light;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        (view.camera_from_world * vec4f(in.position, 1.0)).xyz,
        textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz, in.clip.xy * view.screen.xy
        + view.screen.zw);
    return shade(surface);
}
