//! The numbers of the look's uniforms, from parameters, lights and surroundings. Translated from the
//! look's own nodes.

#![allow(clippy::all, reason = "the translation keeps the form of the shaders' functions")]
#![allow(unused, reason = "structures and functions have all members and values of the original")]

const DIRECTIONAL_LIGHT: i32 = 0_i32;
const PI_HOST: f64 = 3.141592653589793;
const SPOT_LIGHT: i32 = 2_i32;

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

/// Values that may be set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    pub sun_light: LightSettings,
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

/// Light
pub fn light_directional(direction: [f64; 3], own_direction: [f64; 3], color: [f64; 3], intensity: f64) -> Light {
    return Light { direction, own_direction, color, intensity };
}

/// Numbers of the uniform of `draw`, one for each four bytes.
pub fn draw_numbers(settings: Settings, around: Surroundings) -> [f64; 24] {
    let sun_light: WorldLight = light_in_world(settings.sun_light, LightFrame { world_from_own: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0, 0.0, 0.0] }, DIRECTIONAL_LIGHT);
    let sun: Light = light_directional(sun_light.direction, sun_light.own_direction, sun_light.color, sun_light.intensity);
    let mut numbers: [f64; 24] = [0.0; 24];
    numbers[0] = [sun_light.direction[0], sun_light.direction[1], sun_light.direction[2], 0.0][0];
    numbers[1] = [sun_light.direction[0], sun_light.direction[1], sun_light.direction[2], 0.0][1];
    numbers[2] = [sun_light.direction[0], sun_light.direction[1], sun_light.direction[2], 0.0][2];
    numbers[3] = [sun_light.direction[0], sun_light.direction[1], sun_light.direction[2], 0.0][3];
    numbers[4] = around.object_id;
    numbers[8] = sun_light.shadow_map[0];
    numbers[9] = sun_light.shadow_map[1];
    numbers[10] = sun_light.shadow_map[2];
    numbers[11] = sun_light.shadow_map[3];
    numbers[12] = sun.direction[0];
    numbers[13] = sun.direction[1];
    numbers[14] = sun.direction[2];
    numbers[16] = sun.own_direction[0];
    numbers[17] = sun.own_direction[1];
    numbers[18] = sun.own_direction[2];
    numbers[20] = sun.color[0];
    numbers[21] = sun.color[1];
    numbers[22] = sun.color[2];
    numbers[23] = sun.intensity;
    return numbers;
}
