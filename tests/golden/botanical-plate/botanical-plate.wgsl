// Botanical plate: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// botanical-plate.json says what to put there and how to draw.

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
    viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    kappa: f32,
    pixel: vec2f,
    anchor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

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

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    colors: array<vec4f, 16>,
    /// Places of the stops, in increasing order, four to a vector.
    places: array<vec4f, 4>,
    /// Number of stops that count.
    count: u32,
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    interpolation: u32,
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

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// [`mixed`], component by component.
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    let d = b - a;
    return bounded_vec3(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(bounded((bounded(x) - low) / 0.5), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased_2(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(bounded((bounded(x) - low) / 0.75), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased_3(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    var colors = ramp.colors;
    var places = ramp.places;
    var i_2 = 1u;
    var at = 0u;
    loop {
        if !(i_2 < 5u) {
            break;
        }
        at = select(at, i_2, places[i_2 / 4u][i_2 % 4u] <= x);
        continuing {
            i_2 = i_2 + 1u;
        }
    }
    let place = places[at / 4u][at % 4u];
    if (at + 1u >= 5u) | (x <= place) {
        return colors[at];
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    var from_a = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    var to_b = vec4f(0.0);
    if after + 1u < 5u {
        let next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
fn ramp_slope(rise_before: vec4f, span_before: f32, rise_after: vec4f, span_after: f32) -> vec4f {
    return vec4f(
        harmonic_slope(divided(rise_before.x, span_before), span_before,
            divided(rise_after.x, span_after), span_after),
        harmonic_slope(divided(rise_before.y, span_before), span_before,
            divided(rise_after.y, span_after), span_after),
        harmonic_slope(divided(rise_before.z, span_before), span_before,
            divided(rise_after.z, span_after), span_after),
        harmonic_slope(divided(rise_before.w, span_before), span_before,
            divided(rise_after.w, span_after), span_after),
    );
}

/// [`ramp_slope`] of one component.
fn harmonic_slope(before: f32, span_before: f32, after: f32, span_after: f32) -> f32 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let weight_before = 2.0 * span_after + span_before;
    let weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

fn mix_colors_multiply(a: Color, b: Color, factor: f32) -> Color {
    return vec4f(mixed_vec3(a.xyz, a.xyz * b.xyz, factor), 1.0);
}

const NOISE_PERLIN: u32 = 1u;
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

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
fn gradient_dot(hash: vec3u, d: vec3f) -> f32 {
    let axis = (hash.x >> 8u) % 3u;
    let a = select(d.x, d.y, axis == 0u);
    let b = select(d.z, d.y, axis == 2u);
    return select(-a, a, (hash.y >> 31u) == 0u) + select(-b, b, (hash.z >> 31u) == 0u);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
fn fade_quintic(t: vec3f) -> vec3f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = fade_quintic(d);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * gradient_dot(lattice_hash(cell + at, seed), d
            - vec3f(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
fn fractal_noise(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32, w: f32) -> f32 {
    var octave: f32;
    var i = 0;
    var frequency = 1.0;
    var strength = 1.0;
    var total = 0.0;
    var sum = 0.0;
    loop {
        if !(i < 3i) {
            break;
        }
        let visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        octave = 0.5;
        if visible > 0.0 {
            let place = clamp(p * frequency + f32(i) * vec3f(17.31, 5.17, 11.73), vec3f(-4194304.0),
                vec3f(4194304.0));
            octave = mix(0.5, perlin_noise(place, 0u + u32(i)), visible);
        }
        sum = sum + strength * octave;
        total = total + strength;
        strength = strength * roughness;
        frequency = frequency * 2.0;
        continuing {
            i = i + 1;
        }
    }
    return min(sum / 1.75, 1.0);
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

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
fn disk_filtered(d: f32, r: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, (d <= r) & (r > 0.0));
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    let square = r * r;
    let least = w * w / 3.0;
    let inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
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
    let x = turn.y * along + turn.x * across;
    let y = turn.y * across - turn.x * along;
    let turned = vec2f(turn.y * place.x + turn.x * place.y, turn.y * place.y - turn.x * place.x);
    let stretch = vec3f(dot(x, x), dot(x, y), dot(y, y));
    return StretchedPlace(turned, stretch);
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
    return SpacedPlace(p, select(stretch, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
fn area_square(stretch: vec3f) -> f32 {
    let sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

/// Style of dots.
struct Dots {
    /// Diameter of a dot, in spacings.
    size: f32,
    /// Scatter of dots around the middles of their cells, 0 to 1.
    scatter: f32,
    seed: u32,
}

/// The square of an offset's length along the picture, for an offset in the units of a stretched
/// place.
fn picture_square(offset: vec2f, stretch: vec3f) -> f32 {
    let area = max(area_square(stretch), 1e-30);
    let square = stretch.z * offset.x * offset.x - 2.0 * stretch.y * offset.x * offset.y
        + stretch.x * offset.y * offset.y;
    return max(square, 0.0) / area;
}

/// The ink of one octave's dots, of which the share `ink` is drawn; `stretch` is that of a unit of
/// the octave.
fn dots_of_octave(place: vec2f, zoom: i32, ink: f32, stretch: vec3f, w: f32, style: Dots) -> f32 {
    let p = clamp(place * bitcast<f32>(u32(zoom + 127) << 23u), vec2f(-4194304.0),
        vec2f(4194304.0));
    let corner = floor(p);
    let reach = 1.0 - 0.5 * style.scatter;
    var i = 0;
    var sum = 0.0;
    var tile = BLUE_TILE;
    loop {
        if !(i < 9) {
            break;
        }
        let cell = vec2i(corner) + vec2i(i % 3 - 1, i / 3 - 1);
        let chance = vec3f(hash_pcg3d(bitcast<vec3u>(vec3i(cell, zoom)) + 0u
            * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u)) >> vec3u(8u)) * 5.9604644775390625e-8;
        let middle = vec2f(cell) + 0.5 + style.scatter * (chance.xy - 0.5);
        let offset = p - middle;
        let turning = cell + vec2i(0i, zoom * 7);
        let turn = 0.96875 * ((f32((tile[blue_index(turning)]
            >> (8u * (bitcast<u32>(turning.x) & 3u))) & 0xffu) + 0.5) * 0.00390625);
        let grown = clamp((ink - turn) * 32.0, 0.0, 1.0);
        let radius = 0.5 * style.size * sqrt(grown);
        let far = length(offset) / reach;
        let d = max(sqrt(picture_square(offset, stretch)), far * far * radius);
        sum = max(sum, disk_filtered(d, radius, w));
        continuing {
            i = i + 1;
        }
    }
    return sum;
}

/// The ink of dots whose number, and not whose size, makes the tone.
fn stippled(at: SpacedPlace, ink: f32, style: Dots) -> f32 {
    let dx = dpdx(at.place);
    let dy = dpdy(at.place);
    let w = bounded(sqrt(max(picture_square(dx, at.stretch), picture_square(dy, at.stretch))));
    let level = clamp(-0.5 * log2_stable(max(sqrt(area_square(at.stretch)), 1e-30)), -16.0, 16.0);
    let zoom = floor(level);
    let f = level - zoom;
    let coarse_cells = exp2_stable(-2.0 * f);
    let coarse = 1.0 - f;
    let fine = (1.0 - coarse * coarse_cells) / (4.0 * coarse_cells);
    var dots = dots_of_octave(at.place, i32(zoom), ink * coarse, at.stretch
        * exp2_stable(2.0 * zoom), w, style);
    if fine > 0.0 {
        let finer = dots_of_octave(at.place, i32(zoom) + 1, ink * fine, at.stretch
            * exp2_stable(2.0 * zoom + 2.0), w, style);
        dots = max(dots, finer);
    }
    let mean = ink * (0.785398163397448310 * style.size * style.size);
    return mix(dots, mean, eased_2(w, 0.75, 1.5));
}

fn mark_place_object(angle: f32, anchor: vec3f, pixel: vec2f, viewport: vec2f) -> MarkPlace {
    let size = clamp(anchor.z, 1e-6, 1e6);
    let place = (place_in_picture(pixel, viewport) - vec2f(anchor.x, -anchor.y)) / size;
    let m = mark_place_of(place, vec3f(1.0 / size, 0.0, 0.0), vec3f(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let pixels = width * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    let distance = facing / max(2.0 * footprint_of(facing), 1e-6);
    let near = 1.0 - smoothstep(0.45, 0.75, facing);
    return clamp(pixels + 0.5 - distance, 0.0, min(pixels, 1.0)) * near;
}

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = position * scale;
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

struct VectorParts {
    /// The first number.
    x: f32,
    /// The second number.
    y: f32,
    /// The third number.
    z: f32,
}

const leaf_to_bloom = Ramp(array(vec4f(0.4353, 0.5412, 0.2353, 1.0),
    vec4f(0.6235, 0.7098, 0.3961, 1.0), vec4f(0.9098, 0.7255, 0.6275, 1.0),
    vec4f(0.8471, 0.3765, 0.4784, 1.0), vec4f(0.6588, 0.2275, 0.4, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0)), array(vec4f(0.0, 0.35, 0.6, 0.85), vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0),
    vec4f(0.0)), 5u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let where_2 = surface.position_object;
    let parts = VectorParts(where_2.x, where_2.y, where_2.z);
    let mottled = noise_perlin(surface.position_object, 4.0, 3i, 0.5, 0i);
    let height_mottled = parts.y + mix(-0.35, 0.35, mottled - 0.0);
    let share = clamp((height_mottled + 0.9) / (0.95 + 0.9), 0.0, 1.0);
    let leaf_to_bloom_2 = ramp_at(leaf_to_bloom, share, footprint_of(share));
    // Reflectance
    let shade_2 = max((dot(surface.normal, look.key.direction) + 0.3) / (1.0 + 0.3), 0.0);
    let tone = mix(0.02, 1.0, min((shade_2 - 0.0) / (0.8 - 0.0), 1.0));
    let short_of_the_light = mix(0.85, 0.12, clamp((tone - 0.55) / (0.95 - 0.55), 0.0, 1.0));
    let wash = mix_colors_multiply(vec4f(0.9725, 0.949, 0.8863, 1.0), leaf_to_bloom_2,
        short_of_the_light);
    let facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    let turning_away = mix(0.2, 1.0, clamp((facing - 0.05) / (0.6 - 0.05), 0.0, 1.0));
    let engraved_tone = tone * turning_away;
    let plate = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    // Stippling
    let stipple = stippled(spaced(plate.place, plate.stretch, look.viewport, 230.0), 1.0
        - min(engraved_tone, 1.0), Dots(0.72, 0.8, 0u));
    let contour = outer_contour(2.0, surface.normal, surface.view, look.viewport);
    let curvature = surface.kappa;
    // Curvature transition
    let hollow = 0.5 + 0.5 * (1.0 - 2.0
        / (1.0 + exp2(2.8853900817779268 * clamp(curvature * 0.25, -20.0, 20.0))));
    let inked_hollows = eased_3(hollow, 0.24, 0.16);
    // Combine tones
    let ink = max(max(stipple, contour), inked_hollows);
    // Mix colors
    let plate_2 = mixed_vec4(bounded_vec4(wash), vec4f(0.1725, 0.1412, 0.1216, 1.0), ink);
    return finite_vec4(plate_2);
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
        in.position_object, textureLoad(curvature_map, vec2i(in.clip.xy), 0).x, in.clip.xy
        * view.screen.xy + view.screen.zw,
        anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz,
        view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y,
        view.clip_from_world[2].y))));
    return finite_vec4(shade(surface));
}
