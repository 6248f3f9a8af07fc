//! The numbers of the look's uniforms, from parameters, lights and surroundings. Translated from the
//! look's own nodes.

#![allow(clippy::all, reason = "the translation keeps the form of the shaders' functions")]
#![allow(unused, reason = "structures and functions have all members and values of the original")]

const DIRECTIONAL_LIGHT: i32 = 0_i32;
const PI_HOST: f64 = 3.141592653589793;
const SPOT_LIGHT: i32 = 2_i32;
const PI: f64 = 3.141592653589793;
const HALF_PI: f64 = 1.5707963267948966;
const LOG2_E: f64 = 1.4426950408889634;
const PROFILE_SOFT: u32 = 0_u32;
const PROFILE_STEP: u32 = 1_u32;
const PROFILE_AMBIENT: u32 = 2_u32;

/// A light as it is set, in its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSettings {
    /// Toward a directional light; of any length.
    pub direction: [f64; 3],
    /// In scene units.
    pub position: [f64; 3],
    /// The way that a spot light shines; of any length.
    pub aim: [f64; 3],
    /// Straight RGB.
    pub color: [f64; 3],
    /// A factor on the color.
    pub intensity: f64,
    /// Half-angle within which a spot light is whole, in radians.
    pub inner: f64,
    /// Half-angle where a spot light ends, in radians.
    pub outer: f64,
    /// Distance at which half of the light is left, in scene units; 0 for no fading.
    pub half_distance: f64,
    /// Distance where the light ends, in scene units; 0 for no end.
    pub range: f64,
    /// Place in the world that the light is turned toward, and 1; 0 for none.
    pub aimed_at: [f64; 4],
    /// Place in the shadow maps.
    pub shadow_map: [f64; 4],
}

/// A light in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldLight {
    pub direction: [f64; 3],
    pub own_direction: [f64; 3],
    pub position: [f64; 3],
    pub aim: [f64; 3],
    pub color: [f64; 3],
    pub intensity: f64,
    pub cone: [f64; 2],
    pub half_distance: f64,
    pub range: f64,
    pub own_from_world: [[f64; 3]; 3],
    pub shadow_map: [f64; 4],
}

/// The frame that a light is set in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightFrame {
    pub world_from_own: [[f64; 3]; 3],
    pub origin: [f64; 3],
}

/// Surroundings of an object at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surroundings {
    /// Rotation from the illumination frame to the world.
    pub illumination: [[f64; 3]; 3],
    /// Rotation from the world to camera axes.
    pub camera_from_world: [[f64; 3]; 3],
    /// In the world.
    pub eye: [f64; 3],
    /// Unit direction toward the viewer of a parallel view; 0 for perspective.
    pub parallel: [f64; 3],
    /// Axes of the object in the world, at length 1.
    pub object_axes: [[f64; 3]; 3],
    /// Middle of the object's box, in the world.
    pub object_middle: [f64; 3],
    pub object_id: f64,
    /// Width and height in pixels.
    pub viewport: [f64; 2],
    /// Seconds.
    pub time: f64,
    pub frame: f64,
}

/// A light as it arrives at a point of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Unit, toward the light, in world space.
    pub direction: [f64; 3],
    /// Unit, toward the light, in the light's own frame.
    pub own_direction: [f64; 3],
    /// Straight RGB.
    pub color: [f64; 3],
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    pub intensity: f64,
}

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    pub half_cos_offset: f64,
    pub half_sin_offset: f64,
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    pub scale: f64,
    /// gamma of BADF eq. 11.
    pub exponent: f64,
    /// tau, the step's place, in radians.
    pub offset: f64,
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    pub edge_mean: f64,
    pub edge_deviation: f64,
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    pub kind: u32,
}

/// Values that may be set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    pub back_light_slope: f64,
    pub back_light_convex: [f64; 4],
    pub back_light_concave: [f64; 4],
    pub back_light_amount: f64,
    pub back_light_cutoff: f64,
    pub back_light_falloff: f64,
    pub back_light_offset: f64,
    pub specular_slope: f64,
    pub specular_convex: [f64; 4],
    pub specular_concave: [f64; 4],
    pub specular_amount: f64,
    pub specular_cutoff: f64,
    pub specular_falloff: f64,
    pub specular_offset: f64,
    pub diffuse_slope: f64,
    pub diffuse_convex: [f64; 4],
    pub diffuse_concave: [f64; 4],
    pub diffuse_amount: f64,
    pub diffuse_cutoff: f64,
    pub diffuse_falloff: f64,
    pub diffuse_offset: f64,
    pub fill_slope: f64,
    pub fill_convex: [f64; 4],
    pub fill_concave: [f64; 4],
    pub fill_amount: f64,
    pub fill_cutoff: f64,
    pub fill_falloff: f64,
    pub fill_offset: f64,
    pub base_color: [f64; 4],
    pub fill_clamped: bool,
    pub fill_opacity: f64,
    pub diffuse_clamped: bool,
    pub diffuse_opacity: f64,
    pub specular_clamped: bool,
    pub specular_opacity: f64,
    pub back_light_clamped: bool,
    pub back_light_opacity: f64,
    pub output_cutoff: f64,
    pub key_light: LightSettings,
    pub back_light: LightSettings,
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(&b).map(|(x, y)| x * y).sum()
}
fn length<const N: usize>(a: [f64; N]) -> f64 {
    dot(a, a).sqrt()
}
fn matrix_times_vector<const C: usize, const R: usize>(
    m: [[f64; R]; C],
    v: [f64; C],
) -> [f64; R] {
    std::array::from_fn(|row| (0..C).map(|i| m[i][row] * v[i]).sum())
}
fn transpose<const C: usize, const R: usize>(m: [[f64; R]; C]) -> [[f64; C]; R] {
    std::array::from_fn(|row| std::array::from_fn(|column| m[column][row]))
}
fn vector_add<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| {
        let (x, y) = (a[i], b[i]);
        x + y
    })
}
fn vector_divide<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| {
        let (x, y) = (a[i], b[i]);
        x / y
    })
}
fn vector_multiply<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| {
        let (x, y) = (a[i], b[i]);
        x * y
    })
}
fn vector_negate<const N: usize>(a: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| {
        let x = a[i];
        -x
    })
}
fn vector_subtract<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| {
        let (x, y) = (a[i], b[i]);
        x - y
    })
}

/// The vector at length 1, or another where it has no length.
pub fn unit_or(v: [f64; 3], otherwise: [f64; 3]) -> [f64; 3] {
    let all_: f64 = length(v);
    let mut value: bool = false;
    if all_ > 0.0 {
        value = all_ < 1e38;
    } else {
        value = false;
    }
    if value {
        return vector_divide(v, [all_, all_, all_]);
    }
    return otherwise;
}

/// The number within bounds; 0 for what is none.
pub fn bounded_number(x: f64, least: f64, greatest: f64) -> f64 {
    if x != x {
        return 0.0;
    }
    return f64::min(f64::max(x, least), greatest);
}

/// A distance of a light: 0 or at least 1e-30.
pub fn bounded_distance(x: f64) -> f64 {
    if x > 0.0 {
        return f64::min(f64::max(x, 1e-30), 3.4028234663852886e38);
    }
    return 0.0;
}

pub fn bounded_color(color: [f64; 3]) -> [f64; 3] {
    return [bounded_number(color[0], -1000000.0, 1000000.0), bounded_number(color[1], -1000000.0, 1000000.0), bounded_number(color[2], -1000000.0, 1000000.0)];
}

/// The light in the world.
pub fn light_in_world(light: LightSettings, frame: LightFrame, kind: i32) -> WorldLight {
    let forward: [f64; 3] = [0.0, 0.0, 1.0];
    let position: [f64; 3] = vector_add(frame.origin, matrix_times_vector(frame.world_from_own, light.position));
    let own_from_world: [[f64; 3]; 3] = transpose(frame.world_from_own);
    let mut direction: [f64; 3] = matrix_times_vector(frame.world_from_own, unit_or(light.direction, forward));
    let mut own_direction: [f64; 3] = unit_or(light.direction, forward);
    let mut aim: [f64; 3] = matrix_times_vector(frame.world_from_own, unit_or(light.aim, forward));
    let way: [f64; 3] = vector_subtract([light.aimed_at[0], light.aimed_at[1], light.aimed_at[2]], position);
    let mut value: bool = false;
    if light.aimed_at[3] > 0.0 {
        value = length(way) > 0.0;
    } else {
        value = false;
    }
    if value {
        let toward: [f64; 3] = unit_or(way, forward);
        if kind == DIRECTIONAL_LIGHT {
            direction = vector_negate(toward);
            own_direction = matrix_times_vector(own_from_world, direction);
        }
        if kind == SPOT_LIGHT {
            aim = toward;
        }
    }
    let outer: f64 = bounded_number(light.outer, 0.0, PI_HOST);
    let inner: f64 = f64::min(bounded_number(light.inner, 0.0, PI_HOST), outer);
    return WorldLight { direction, own_direction, position, aim, color: bounded_color(light.color), intensity: bounded_number(light.intensity, 0.0, 1e30), cone: [f64::cos(inner), f64::cos(outer)], half_distance: bounded_distance(light.half_distance), range: bounded_distance(light.range), own_from_world, shadow_map: light.shadow_map };
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
pub fn exp2_stable(x: f64) -> f64 {
    let clamped: f64 = f64::min(f64::max(x, -126.0), 127.999992);
    let whole: f64 = f64::round_ties_even(clamped);
    let f: f64 = clamped - whole;
    let twice: f64 = 2.0 + f * (1.386294405710424 + f * (0.4804529582723118 + f * (0.11100664941567157 + f * (0.019236874716471952 + f * (0.0026797749114217807 + f * 0.00030706724124369896)))));
    return twice * f64::from(f32::from_bits(u32::wrapping_shl(i32::wrapping_add(whole as i32, 126_i32) as u32, 23_u32) as u32));
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
pub fn log2_stable(x: f64) -> f64 {
    let bits: u32 = (x as f32).to_bits();
    let exponent: i32 = i32::wrapping_shr(u32::wrapping_sub(bits, 1060439283_u32) as i32, 23_u32);
    let mantissa: f64 = f64::from(f32::from_bits(u32::wrapping_sub(bits, u32::wrapping_shl(exponent as u32, 23_u32)) as u32));
    let z: f64 = (mantissa - 1.0) / (mantissa + 1.0);
    let z2: f64 = z * z;
    return f64::from(exponent) + z * (2.8853900797881615 + z2 * (0.9617988482912865 + z2 * (0.5767143098091317 + z2 * 0.43173790132006157)));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
pub fn log1p_negative_small(y: f64) -> f64 {
    let z: f64 = y / (2.0 - y);
    let z2: f64 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.3333333333333333 + z2 * (0.2 + z2 * (0.14285714285714285 + z2 * 0.1111111111111111))));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
pub fn sin_cos_quarter(x: f64) -> [f64; 2] {
    let h: f64 = 0.5 * x;
    let h2: f64 = h * h;
    let s: f64 = h * (1.0 + h2 * (-0.16666666666666666 + h2 * (0.008333333333333333 + h2 * (-0.0001984126984126984 + h2 * (2.7557319223985893e-6 + h2 * -2.505210838544172e-8)))));
    let one_minus_c: f64 = h2 * (0.5 + h2 * (-0.041666666666666664 + h2 * (0.001388888888888889 + h2 * (-2.48015873015873e-5 + h2 * (2.755731922398589e-7 + h2 * -2.08767569878681e-9)))));
    let c: f64 = 1.0 - one_minus_c;
    return [2.0 * s * c, 1.0 - 2.0 * s * s];
}

/// sin(x/2) and cos(x/2) for x in [0, pi], given `left`, which is pi - x: both keep their relative
/// accuracy at both ends, because the smaller angle is halved and its cosine is the other's sine.
pub fn sin_cos_half(x: f64, left: f64) -> [f64; 2] {
    let half: [f64; 2] = sin_cos_quarter(0.5 * f64::min(x, left));
    return if x <= left { half } else { [half[1], half[0]] };
}

/// pi - x for x up to pi, with the digits of pi that an f32 does not hold; 0 where x is the f32
/// next to pi.
pub fn left_to_pi(x: f64) -> f64 {
    let coarse: f64 = f64::max(3.1415927410125732 - x, 0.0);
    return f64::max(coarse - 8.742278012618954e-8, 0.0);
}

/// A share (an opacity, a mask) clamped to [0, 1]: beyond, a mix would go past what it mixes.
pub fn unit_share(share: f64) -> f64 {
    return f64::min(f64::max(share, 0.0), 1.0);
}

/// `color` with its alpha clamped to [0, 1].
pub fn with_unit_alpha(color: [f64; 4]) -> [f64; 4] {
    let value: [f64; 3] = [color[0], color[1], color[2]];
    return [value[0], value[1], value[2], unit_share(color[3])];
}

/// Premultiplied RGBA of a straight color.
pub fn premultiplied(color: [f64; 4]) -> [f64; 4] {
    let value: f64 = color[3];
    let value_: [f64; 3] = vector_multiply([color[0], color[1], color[2]], [value, value, value]);
    return [value_[0], value_[1], value_[2], color[3]];
}

/// Base
pub fn base(color: [f64; 4]) -> [f64; 4] {
    return premultiplied(color);
}

pub fn output_cutoff(cutoff: f64) -> f64 {
    return cutoff;
}

/// Light
pub fn light_directional(direction: [f64; 3], own_direction: [f64; 3], color: [f64; 3], intensity: f64) -> Light {
    return Light { direction, own_direction, color, intensity };
}

/// gamma(f, c) of BADF eq. 11 by half-angles: 1 exactly at f = c, also at the corner f = c = pi
/// (D5). `f_left` and `c_left` are pi - f and pi - c, with digits of their own where they are
/// small.
pub fn profile_exponent(f: f64, c: f64, f_left: f64, c_left: f64) -> f64 {
    let half_c: [f64; 2] = sin_cos_half(c, c_left);
    let half_f: [f64; 2] = sin_cos_half(f, f_left);
    let apart: f64 = if c < HALF_PI { c - f } else { f_left - c_left };
    if apart <= 0.0 {
        return 1.0;
    }
    let sum: f64 = half_c[0] * half_f[1] + half_c[1] * half_f[0];
    let difference: f64 = sin_cos_quarter(0.5 * apart)[0];
    let sin_f: f64 = 2.0 * half_f[0] * half_f[1];
    return (sum * sum + difference * difference) / (sin_f * sin_f);
}

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
pub fn profile_power(q: f64, exponent: f64) -> f64 {
    if q >= 1.0 {
        return 0.0;
    }
    let mut log_base: f64 = 0.0;
    if q < 0.5 {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return f64::min(f64::max(exp2_stable(exponent * log_base), 0.0), 1.0);
}

/// `shape` with its edge: mean and standard deviation of -eta' over [0, c], by the trapezoid rule
/// on eta, which tell how wide the soft edge looks.
pub fn profile_edge(shape: ProfileShape, c: f64) -> ProfileShape {
    let h: f64 = c / f64::from(64_i32);
    let mut area: f64 = 0.5;
    let mut moment: f64 = 0.0;
    let mut i: i32 = 1_i32;
    while i < 64_i32 {
        let x: f64 = f64::from(i) * h;
        let q: f64 = f64::min(sin_cos_quarter(0.5 * x)[0] * shape.scale, 1.0);
        let eta: f64 = profile_power(q, shape.exponent);
        area = area + eta;
        moment = moment + x * eta;
        i = i32::wrapping_add(i, 1_i32);
    }
    let mut result: ProfileShape = shape;
    result.edge_mean = area * h;
    result.edge_deviation = f64::sqrt(f64::max(2.0 * moment * h - area * area * h * h, 0.0));
    return result;
}

/// Sanitises offset, fall-off and cut-off (D2) and makes the shape (BADF eq. 10, 11; docs/math.md
/// 2.1 to 2.3). An offset within 1e-5 of pi is ambient: pi has no exact f32, and people write
/// 3.14159.
pub fn profile_shape(offset: f64, falloff: f64, cutoff: f64) -> ProfileShape {
    let tau: f64 = f64::min(f64::max(offset, 0.0), PI);
    let zero_at: f64 = f64::min(f64::max(cutoff, tau), PI);
    let steep_at: f64 = f64::min(f64::max(falloff, tau), zero_at);
    let c: f64 = zero_at - tau;
    let f: f64 = steep_at - tau;
    let half_tau: [f64; 2] = sin_cos_quarter(0.5 * tau);
    let mut shape: ProfileShape = ProfileShape { half_cos_offset: half_tau[1], half_sin_offset: half_tau[0], scale: 0.0, exponent: 1.0, offset: tau, edge_mean: 0.0, edge_deviation: 0.0, kind: PROFILE_STEP };
    if tau >= 3.141582653589793 {
        shape.kind = PROFILE_AMBIENT;
        return shape;
    }
    let sin_c: f64 = sin_cos_quarter(0.5 * c)[0];
    let sin_f: f64 = sin_cos_quarter(0.5 * f)[0];
    if (sin_c <= 0.0) | (sin_f < 1e-9) {
        return shape;
    }
    shape.kind = PROFILE_SOFT;
    shape.scale = 1.0 / sin_c;
    shape.exponent = profile_exponent(f, c, left_to_pi(steep_at) + tau, left_to_pi(zero_at) + tau);
    return profile_edge(shape, c);
}

pub fn profile_prepare(offset: f64, falloff: f64, cutoff: f64) -> ProfileShape {
    return profile_shape(offset, falloff, cutoff);
}

/// Numbers of the uniform of `normals`, one for each four bytes.
pub fn normals_numbers(settings: Settings, around: Surroundings) -> [f64; 136] {
    let back_light_color_convex: [f64; 4] = with_unit_alpha(settings.back_light_convex);
    let back_light_color_concave: [f64; 4] = with_unit_alpha(settings.back_light_concave);
    let back_light: WorldLight = light_in_world(settings.back_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let back: Light = light_directional(back_light.direction, back_light.own_direction, back_light.color, back_light.intensity);
    let back_light_tone_shape: ProfileShape = profile_prepare(settings.back_light_offset, settings.back_light_falloff, settings.back_light_cutoff);
    let specular_color_convex: [f64; 4] = with_unit_alpha(settings.specular_convex);
    let specular_color_concave: [f64; 4] = with_unit_alpha(settings.specular_concave);
    let key_light: WorldLight = light_in_world(settings.key_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let key: Light = light_directional(key_light.direction, key_light.own_direction, key_light.color, key_light.intensity);
    let specular_tone_shape: ProfileShape = profile_prepare(settings.specular_offset, settings.specular_falloff, settings.specular_cutoff);
    let diffuse_color_convex: [f64; 4] = with_unit_alpha(settings.diffuse_convex);
    let diffuse_color_concave: [f64; 4] = with_unit_alpha(settings.diffuse_concave);
    let diffuse_tone_shape: ProfileShape = profile_prepare(settings.diffuse_offset, settings.diffuse_falloff, settings.diffuse_cutoff);
    let fill_color_convex: [f64; 4] = with_unit_alpha(settings.fill_convex);
    let fill_color_concave: [f64; 4] = with_unit_alpha(settings.fill_concave);
    let fill_tone_shape: ProfileShape = profile_prepare(settings.fill_offset, settings.fill_falloff, settings.fill_cutoff);
    let value_51: [f64; 4] = with_unit_alpha(settings.base_color);
    let base_of_look: [f64; 4] = base(value_51);
    let fill_blend_opacity: f64 = unit_share(settings.fill_opacity);
    let diffuse_blend_opacity: f64 = unit_share(settings.diffuse_opacity);
    let specular_blend_opacity: f64 = unit_share(settings.specular_opacity);
    let back_light_blend_opacity: f64 = unit_share(settings.back_light_opacity);
    let output: f64 = output_cutoff(settings.output_cutoff);
    let mut numbers: [f64; 136] = [0.0; 136];
    numbers[0] = settings.back_light_slope;
    numbers[4] = back_light_color_convex[0];
    numbers[5] = back_light_color_convex[1];
    numbers[6] = back_light_color_convex[2];
    numbers[7] = back_light_color_convex[3];
    numbers[8] = back_light_color_concave[0];
    numbers[9] = back_light_color_concave[1];
    numbers[10] = back_light_color_concave[2];
    numbers[11] = back_light_color_concave[3];
    numbers[12] = settings.back_light_amount;
    numbers[16] = back.direction[0];
    numbers[17] = back.direction[1];
    numbers[18] = back.direction[2];
    numbers[20] = back.own_direction[0];
    numbers[21] = back.own_direction[1];
    numbers[22] = back.own_direction[2];
    numbers[24] = back.color[0];
    numbers[25] = back.color[1];
    numbers[26] = back.color[2];
    numbers[27] = back.intensity;
    numbers[28] = back_light_tone_shape.half_cos_offset;
    numbers[29] = back_light_tone_shape.half_sin_offset;
    numbers[30] = back_light_tone_shape.scale;
    numbers[31] = back_light_tone_shape.exponent;
    numbers[32] = back_light_tone_shape.offset;
    numbers[33] = back_light_tone_shape.edge_mean;
    numbers[34] = back_light_tone_shape.edge_deviation;
    numbers[35] = f64::from(back_light_tone_shape.kind);
    numbers[36] = settings.specular_slope;
    numbers[40] = specular_color_convex[0];
    numbers[41] = specular_color_convex[1];
    numbers[42] = specular_color_convex[2];
    numbers[43] = specular_color_convex[3];
    numbers[44] = specular_color_concave[0];
    numbers[45] = specular_color_concave[1];
    numbers[46] = specular_color_concave[2];
    numbers[47] = specular_color_concave[3];
    numbers[48] = settings.specular_amount;
    numbers[52] = key.direction[0];
    numbers[53] = key.direction[1];
    numbers[54] = key.direction[2];
    numbers[56] = key.own_direction[0];
    numbers[57] = key.own_direction[1];
    numbers[58] = key.own_direction[2];
    numbers[60] = key.color[0];
    numbers[61] = key.color[1];
    numbers[62] = key.color[2];
    numbers[63] = key.intensity;
    numbers[64] = specular_tone_shape.half_cos_offset;
    numbers[65] = specular_tone_shape.half_sin_offset;
    numbers[66] = specular_tone_shape.scale;
    numbers[67] = specular_tone_shape.exponent;
    numbers[68] = specular_tone_shape.offset;
    numbers[69] = specular_tone_shape.edge_mean;
    numbers[70] = specular_tone_shape.edge_deviation;
    numbers[71] = f64::from(specular_tone_shape.kind);
    numbers[72] = settings.diffuse_slope;
    numbers[76] = diffuse_color_convex[0];
    numbers[77] = diffuse_color_convex[1];
    numbers[78] = diffuse_color_convex[2];
    numbers[79] = diffuse_color_convex[3];
    numbers[80] = diffuse_color_concave[0];
    numbers[81] = diffuse_color_concave[1];
    numbers[82] = diffuse_color_concave[2];
    numbers[83] = diffuse_color_concave[3];
    numbers[84] = settings.diffuse_amount;
    numbers[88] = diffuse_tone_shape.half_cos_offset;
    numbers[89] = diffuse_tone_shape.half_sin_offset;
    numbers[90] = diffuse_tone_shape.scale;
    numbers[91] = diffuse_tone_shape.exponent;
    numbers[92] = diffuse_tone_shape.offset;
    numbers[93] = diffuse_tone_shape.edge_mean;
    numbers[94] = diffuse_tone_shape.edge_deviation;
    numbers[95] = f64::from(diffuse_tone_shape.kind);
    numbers[96] = settings.fill_slope;
    numbers[100] = fill_color_convex[0];
    numbers[101] = fill_color_convex[1];
    numbers[102] = fill_color_convex[2];
    numbers[103] = fill_color_convex[3];
    numbers[104] = fill_color_concave[0];
    numbers[105] = fill_color_concave[1];
    numbers[106] = fill_color_concave[2];
    numbers[107] = fill_color_concave[3];
    numbers[108] = settings.fill_amount;
    numbers[112] = fill_tone_shape.half_cos_offset;
    numbers[113] = fill_tone_shape.half_sin_offset;
    numbers[114] = fill_tone_shape.scale;
    numbers[115] = fill_tone_shape.exponent;
    numbers[116] = fill_tone_shape.offset;
    numbers[117] = fill_tone_shape.edge_mean;
    numbers[118] = fill_tone_shape.edge_deviation;
    numbers[119] = f64::from(fill_tone_shape.kind);
    numbers[120] = base_of_look[0];
    numbers[121] = base_of_look[1];
    numbers[122] = base_of_look[2];
    numbers[123] = base_of_look[3];
    numbers[124] = f64::from(if settings.fill_clamped { 1_u32 } else { 0_u32 });
    numbers[125] = fill_blend_opacity;
    numbers[126] = f64::from(if settings.diffuse_clamped { 1_u32 } else { 0_u32 });
    numbers[127] = diffuse_blend_opacity;
    numbers[128] = f64::from(if settings.specular_clamped { 1_u32 } else { 0_u32 });
    numbers[129] = specular_blend_opacity;
    numbers[130] = f64::from(if settings.back_light_clamped { 1_u32 } else { 0_u32 });
    numbers[131] = back_light_blend_opacity;
    numbers[132] = output;
    return numbers;
}

/// Numbers of the uniform of `draw`, one for each four bytes.
pub fn draw_numbers(settings: Settings, around: Surroundings) -> [f64; 136] {
    let back_light_color_convex: [f64; 4] = with_unit_alpha(settings.back_light_convex);
    let back_light_color_concave: [f64; 4] = with_unit_alpha(settings.back_light_concave);
    let back_light: WorldLight = light_in_world(settings.back_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let back: Light = light_directional(back_light.direction, back_light.own_direction, back_light.color, back_light.intensity);
    let back_light_tone_shape: ProfileShape = profile_prepare(settings.back_light_offset, settings.back_light_falloff, settings.back_light_cutoff);
    let specular_color_convex: [f64; 4] = with_unit_alpha(settings.specular_convex);
    let specular_color_concave: [f64; 4] = with_unit_alpha(settings.specular_concave);
    let key_light: WorldLight = light_in_world(settings.key_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let key: Light = light_directional(key_light.direction, key_light.own_direction, key_light.color, key_light.intensity);
    let specular_tone_shape: ProfileShape = profile_prepare(settings.specular_offset, settings.specular_falloff, settings.specular_cutoff);
    let diffuse_color_convex: [f64; 4] = with_unit_alpha(settings.diffuse_convex);
    let diffuse_color_concave: [f64; 4] = with_unit_alpha(settings.diffuse_concave);
    let diffuse_tone_shape: ProfileShape = profile_prepare(settings.diffuse_offset, settings.diffuse_falloff, settings.diffuse_cutoff);
    let fill_color_convex: [f64; 4] = with_unit_alpha(settings.fill_convex);
    let fill_color_concave: [f64; 4] = with_unit_alpha(settings.fill_concave);
    let fill_tone_shape: ProfileShape = profile_prepare(settings.fill_offset, settings.fill_falloff, settings.fill_cutoff);
    let value_51: [f64; 4] = with_unit_alpha(settings.base_color);
    let base_of_look: [f64; 4] = base(value_51);
    let fill_blend_opacity: f64 = unit_share(settings.fill_opacity);
    let diffuse_blend_opacity: f64 = unit_share(settings.diffuse_opacity);
    let specular_blend_opacity: f64 = unit_share(settings.specular_opacity);
    let back_light_blend_opacity: f64 = unit_share(settings.back_light_opacity);
    let output: f64 = output_cutoff(settings.output_cutoff);
    let mut numbers: [f64; 136] = [0.0; 136];
    numbers[0] = settings.back_light_slope;
    numbers[4] = back_light_color_convex[0];
    numbers[5] = back_light_color_convex[1];
    numbers[6] = back_light_color_convex[2];
    numbers[7] = back_light_color_convex[3];
    numbers[8] = back_light_color_concave[0];
    numbers[9] = back_light_color_concave[1];
    numbers[10] = back_light_color_concave[2];
    numbers[11] = back_light_color_concave[3];
    numbers[12] = settings.back_light_amount;
    numbers[16] = back.direction[0];
    numbers[17] = back.direction[1];
    numbers[18] = back.direction[2];
    numbers[20] = back.own_direction[0];
    numbers[21] = back.own_direction[1];
    numbers[22] = back.own_direction[2];
    numbers[24] = back.color[0];
    numbers[25] = back.color[1];
    numbers[26] = back.color[2];
    numbers[27] = back.intensity;
    numbers[28] = back_light_tone_shape.half_cos_offset;
    numbers[29] = back_light_tone_shape.half_sin_offset;
    numbers[30] = back_light_tone_shape.scale;
    numbers[31] = back_light_tone_shape.exponent;
    numbers[32] = back_light_tone_shape.offset;
    numbers[33] = back_light_tone_shape.edge_mean;
    numbers[34] = back_light_tone_shape.edge_deviation;
    numbers[35] = f64::from(back_light_tone_shape.kind);
    numbers[36] = settings.specular_slope;
    numbers[40] = specular_color_convex[0];
    numbers[41] = specular_color_convex[1];
    numbers[42] = specular_color_convex[2];
    numbers[43] = specular_color_convex[3];
    numbers[44] = specular_color_concave[0];
    numbers[45] = specular_color_concave[1];
    numbers[46] = specular_color_concave[2];
    numbers[47] = specular_color_concave[3];
    numbers[48] = settings.specular_amount;
    numbers[52] = key.direction[0];
    numbers[53] = key.direction[1];
    numbers[54] = key.direction[2];
    numbers[56] = key.own_direction[0];
    numbers[57] = key.own_direction[1];
    numbers[58] = key.own_direction[2];
    numbers[60] = key.color[0];
    numbers[61] = key.color[1];
    numbers[62] = key.color[2];
    numbers[63] = key.intensity;
    numbers[64] = specular_tone_shape.half_cos_offset;
    numbers[65] = specular_tone_shape.half_sin_offset;
    numbers[66] = specular_tone_shape.scale;
    numbers[67] = specular_tone_shape.exponent;
    numbers[68] = specular_tone_shape.offset;
    numbers[69] = specular_tone_shape.edge_mean;
    numbers[70] = specular_tone_shape.edge_deviation;
    numbers[71] = f64::from(specular_tone_shape.kind);
    numbers[72] = settings.diffuse_slope;
    numbers[76] = diffuse_color_convex[0];
    numbers[77] = diffuse_color_convex[1];
    numbers[78] = diffuse_color_convex[2];
    numbers[79] = diffuse_color_convex[3];
    numbers[80] = diffuse_color_concave[0];
    numbers[81] = diffuse_color_concave[1];
    numbers[82] = diffuse_color_concave[2];
    numbers[83] = diffuse_color_concave[3];
    numbers[84] = settings.diffuse_amount;
    numbers[88] = diffuse_tone_shape.half_cos_offset;
    numbers[89] = diffuse_tone_shape.half_sin_offset;
    numbers[90] = diffuse_tone_shape.scale;
    numbers[91] = diffuse_tone_shape.exponent;
    numbers[92] = diffuse_tone_shape.offset;
    numbers[93] = diffuse_tone_shape.edge_mean;
    numbers[94] = diffuse_tone_shape.edge_deviation;
    numbers[95] = f64::from(diffuse_tone_shape.kind);
    numbers[96] = settings.fill_slope;
    numbers[100] = fill_color_convex[0];
    numbers[101] = fill_color_convex[1];
    numbers[102] = fill_color_convex[2];
    numbers[103] = fill_color_convex[3];
    numbers[104] = fill_color_concave[0];
    numbers[105] = fill_color_concave[1];
    numbers[106] = fill_color_concave[2];
    numbers[107] = fill_color_concave[3];
    numbers[108] = settings.fill_amount;
    numbers[112] = fill_tone_shape.half_cos_offset;
    numbers[113] = fill_tone_shape.half_sin_offset;
    numbers[114] = fill_tone_shape.scale;
    numbers[115] = fill_tone_shape.exponent;
    numbers[116] = fill_tone_shape.offset;
    numbers[117] = fill_tone_shape.edge_mean;
    numbers[118] = fill_tone_shape.edge_deviation;
    numbers[119] = f64::from(fill_tone_shape.kind);
    numbers[120] = base_of_look[0];
    numbers[121] = base_of_look[1];
    numbers[122] = base_of_look[2];
    numbers[123] = base_of_look[3];
    numbers[124] = f64::from(if settings.fill_clamped { 1_u32 } else { 0_u32 });
    numbers[125] = fill_blend_opacity;
    numbers[126] = f64::from(if settings.diffuse_clamped { 1_u32 } else { 0_u32 });
    numbers[127] = diffuse_blend_opacity;
    numbers[128] = f64::from(if settings.specular_clamped { 1_u32 } else { 0_u32 });
    numbers[129] = specular_blend_opacity;
    numbers[130] = f64::from(if settings.back_light_clamped { 1_u32 } else { 0_u32 });
    numbers[131] = back_light_blend_opacity;
    numbers[132] = output;
    return numbers;
}
