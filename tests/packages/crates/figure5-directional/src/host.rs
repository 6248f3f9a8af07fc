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
    pub highlight_convex: [f64; 4],
    pub highlight_concave: [f64; 4],
    pub back_convex: [f64; 4],
    pub back_concave: [f64; 4],
    pub back_amount: f64,
    pub back_cutoff: f64,
    pub diffuse_cutoff: f64,
    pub diffuse_falloff: f64,
    pub diffuse_offset: f64,
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

/// Unit direction from the object toward a light.
pub fn toward_light(light: WorldLight, around: Surroundings, kind: i32) -> [f64; 3] {
    if kind == DIRECTIONAL_LIGHT {
        return light.direction;
    }
    return unit_or(vector_subtract(light.position, around.object_middle), [0.0, 0.0, 1.0]);
}

/// x at 0 and 1, flat there.
pub fn eased(x: f64) -> f64 {
    let t: f64 = f64::min(f64::max(x, 0.0), 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The offset of a profile, within what it may be.
pub fn profile_offset(offset: f64) -> f64 {
    return f64::min(f64::max(offset, 0.0), PI_HOST);
}

/// The cut-off of a profile, at or after its offset.
pub fn profile_cutoff(offset: f64, cutoff: f64) -> f64 {
    return f64::min(f64::max(cutoff, profile_offset(offset)), PI_HOST);
}

/// The fall-off of a profile, between its offset and its cut-off.
pub fn profile_falloff(offset: f64, falloff: f64, cutoff: f64) -> f64 {
    return f64::min(f64::max(falloff, profile_offset(offset)), profile_cutoff(offset, cutoff));
}

/// Li2(1 - exp(-z)) for z from 0 to ln 2, by its series.
pub fn dilogarithm_host(z: f64) -> f64 {
    let s: f64 = z * z;
    let mut sum: f64 = -1.9939295860721074e-14;
    sum = sum * s + 8.921691020456453e-13;
    sum = sum * s - 4.0647616451442256e-11;
    sum = sum * s + 1.8978869988971e-9;
    sum = sum * s - 9.185773074661964e-8;
    sum = sum * s + 4.72411186696901e-6;
    sum = sum * s - 0.0002777777777777778;
    sum = sum * s + 0.027777777777777776;
    return z - 0.25 * s + z * s * sum;
}

/// The kernel of smooth weights between two unit directions.
pub fn biharmonic_kernel(a: [f64; 3], b: [f64; 3]) -> f64 {
    let near: f64 = 0.25 * dot(vector_subtract(a, b), vector_subtract(a, b));
    if near <= 0.0 {
        return 0.0;
    }
    if near <= 0.5 {
        let z: f64 = -f64::ln(1.0 - near);
        return f64::ln(near) * z - dilogarithm_host(z);
    }
    let far: f64 = f64::min(f64::max(0.25 * dot(vector_add(a, b), vector_add(a, b)), 0.0), 0.5);
    return dilogarithm_host(-f64::ln(1.0 - far)) - 1.6449340668482264;
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

/// Weights of the keys of set 0, which sum to 1.
pub fn key_weights_0(x: [f64; 3]) -> [f64; 2] {
    let place: [f64; 3] = unit_or(x, [0.0, 0.0, 0.0]);
    let is_known: bool = dot(place, place) > 0.5;
    let mut centers: [[f64; 3]; 2] = [[-0.5454545454545454, 0.6363636363636362, 0.5454545454545454], [0.19876159799998136, 0.49690399499995336, -0.8447367914999206]];
    let mut coefficients: [f64; 4] = [0.4067890288274284, -0.4067890288274284, -0.4067890288274284, 0.4067890288274284];
    let mut raw: [f64; 2] = [0.5, 0.5];
    let mut i: i32 = 0_i32;
    while i < 2_i32 {
        let kernel: f64 = biharmonic_kernel(place, centers[i as usize]);
        let mut j: i32 = 0_i32;
        while j < 2_i32 {
            raw[j as usize] = raw[j as usize] + coefficients[i32::wrapping_add(i32::wrapping_mul(i, 2_i32), j) as usize] * kernel;
            j = i32::wrapping_add(j, 1_i32);
        }
        i = i32::wrapping_add(i, 1_i32);
    }
    let mut sum: f64 = 0.0;
    let mut i_: i32 = 0_i32;
    while i_ < 2_i32 {
        raw[i_ as usize] = if is_known { eased(raw[i_ as usize]) } else { 0.5 };
        sum = sum + raw[i_ as usize];
        i_ = i32::wrapping_add(i_, 1_i32);
    }
    return [raw[0] / sum, raw[1] / sum];
}

/// The settings that hold in the surroundings: keys move them.
pub fn keyed(settings: Settings, around: Surroundings) -> Settings {
    let mut moved: Settings = settings;
    let before: Settings = moved;
    let own_0: Settings = moved;
    let weights_0: [f64; 2] = key_weights_0(matrix_times_vector(around.camera_from_world, toward_light(light_in_world(before.key_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT), around, DIRECTIONAL_LIGHT)));
    moved.back_amount = weights_0[0] * own_0.back_amount + weights_0[1] * -0.6;
    let value: f64 = weights_0[0];
    let value_: f64 = weights_0[1];
    moved.back_concave = vector_add(vector_multiply([value, value, value, value], own_0.back_concave), vector_multiply([value_, value_, value_, value_], [0.251, 0.1882, 0.3686, 1.0]));
    let value_2: f64 = weights_0[0];
    let value_3: f64 = weights_0[1];
    moved.back_convex = vector_add(vector_multiply([value_2, value_2, value_2, value_2], own_0.back_convex), vector_multiply([value_3, value_3, value_3, value_3], [0.3529, 0.2902, 0.4863, 1.0]));
    moved.back_cutoff = weights_0[0] * profile_cutoff(0.55, own_0.back_cutoff) + weights_0[1] * profile_cutoff(0.55, 1.4);
    moved.diffuse_cutoff = weights_0[0] * profile_cutoff(own_0.diffuse_offset, own_0.diffuse_cutoff) + weights_0[1] * profile_cutoff(0.35, 2.3);
    moved.diffuse_falloff = weights_0[0] * profile_falloff(own_0.diffuse_offset, own_0.diffuse_falloff, own_0.diffuse_cutoff) + weights_0[1] * profile_falloff(0.35, 1.5, 2.3);
    moved.diffuse_offset = weights_0[0] * profile_offset(own_0.diffuse_offset) + weights_0[1] * profile_offset(0.35);
    let value_4: f64 = weights_0[0];
    let value_5: f64 = weights_0[1];
    moved.highlight_concave = vector_add(vector_multiply([value_4, value_4, value_4, value_4], own_0.highlight_concave), vector_multiply([value_5, value_5, value_5, value_5], [0.2353, 0.2706, 0.1569, 1.0]));
    let value_6: f64 = weights_0[0];
    let value_7: f64 = weights_0[1];
    moved.highlight_convex = vector_add(vector_multiply([value_6, value_6, value_6, value_6], own_0.highlight_convex), vector_multiply([value_7, value_7, value_7, value_7], [0.349, 0.3765, 0.2275, 1.0]));
    return moved;
}

/// Numbers of the uniform of `draw`, one for each four bytes.
pub fn draw_numbers(settings: Settings, around: Surroundings) -> [f64; 60] {
    let highlight_color_convex: [f64; 4] = with_unit_alpha(settings.highlight_convex);
    let highlight_color_concave: [f64; 4] = with_unit_alpha(settings.highlight_concave);
    let key_light: WorldLight = light_in_world(settings.key_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let key: Light = light_directional(key_light.direction, key_light.own_direction, key_light.color, key_light.intensity);
    let back_light_color_convex: [f64; 4] = with_unit_alpha(settings.back_convex);
    let back_light_color_concave: [f64; 4] = with_unit_alpha(settings.back_concave);
    let back_light: WorldLight = light_in_world(settings.back_light, LightFrame { world_from_own: around.illumination, origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let back: Light = light_directional(back_light.direction, back_light.own_direction, back_light.color, back_light.intensity);
    let back_light_tone_shape: ProfileShape = profile_prepare(0.55, 0.9, settings.back_cutoff);
    let diffuse_tone_shape: ProfileShape = profile_prepare(settings.diffuse_offset, settings.diffuse_falloff, settings.diffuse_cutoff);
    let mut numbers: [f64; 60] = [0.0; 60];
    numbers[0] = highlight_color_convex[0];
    numbers[1] = highlight_color_convex[1];
    numbers[2] = highlight_color_convex[2];
    numbers[3] = highlight_color_convex[3];
    numbers[4] = highlight_color_concave[0];
    numbers[5] = highlight_color_concave[1];
    numbers[6] = highlight_color_concave[2];
    numbers[7] = highlight_color_concave[3];
    numbers[8] = key.direction[0];
    numbers[9] = key.direction[1];
    numbers[10] = key.direction[2];
    numbers[12] = key.own_direction[0];
    numbers[13] = key.own_direction[1];
    numbers[14] = key.own_direction[2];
    numbers[16] = key.color[0];
    numbers[17] = key.color[1];
    numbers[18] = key.color[2];
    numbers[19] = key.intensity;
    numbers[20] = back_light_color_convex[0];
    numbers[21] = back_light_color_convex[1];
    numbers[22] = back_light_color_convex[2];
    numbers[23] = back_light_color_convex[3];
    numbers[24] = back_light_color_concave[0];
    numbers[25] = back_light_color_concave[1];
    numbers[26] = back_light_color_concave[2];
    numbers[27] = back_light_color_concave[3];
    numbers[28] = settings.back_amount;
    numbers[32] = back.direction[0];
    numbers[33] = back.direction[1];
    numbers[34] = back.direction[2];
    numbers[36] = back.own_direction[0];
    numbers[37] = back.own_direction[1];
    numbers[38] = back.own_direction[2];
    numbers[40] = back.color[0];
    numbers[41] = back.color[1];
    numbers[42] = back.color[2];
    numbers[43] = back.intensity;
    numbers[44] = back_light_tone_shape.half_cos_offset;
    numbers[45] = back_light_tone_shape.half_sin_offset;
    numbers[46] = back_light_tone_shape.scale;
    numbers[47] = back_light_tone_shape.exponent;
    numbers[48] = back_light_tone_shape.offset;
    numbers[49] = back_light_tone_shape.edge_mean;
    numbers[50] = back_light_tone_shape.edge_deviation;
    numbers[51] = f64::from(back_light_tone_shape.kind);
    numbers[52] = diffuse_tone_shape.half_cos_offset;
    numbers[53] = diffuse_tone_shape.half_sin_offset;
    numbers[54] = diffuse_tone_shape.scale;
    numbers[55] = diffuse_tone_shape.exponent;
    numbers[56] = diffuse_tone_shape.offset;
    numbers[57] = diffuse_tone_shape.edge_mean;
    numbers[58] = diffuse_tone_shape.edge_deviation;
    numbers[59] = f64::from(diffuse_tone_shape.kind);
    return numbers;
}
