/// A light as it is set, in its own frame.
struct LightSettings {
    /// Toward a directional light; of any length.
    direction: vec3f,
    /// In scene units.
    position: vec3f,
    /// The way that a spot light shines; of any length.
    aim: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// A factor on the color.
    intensity: f32,
    /// Half-angle within which a spot light is whole, in radians.
    inner: f32,
    /// Half-angle where a spot light ends, in radians.
    outer: f32,
    /// Distance at which half of the light is left, in scene units; 0 for no fading.
    half_distance: f32,
    /// Distance where the light ends, in scene units; 0 for no end.
    range: f32,
    /// Place in the world that the light is turned toward, and 1; 0 for none.
    aimed_at: vec4f,
    /// Place in the shadow maps.
    shadow_map: vec4f,
}

/// A light in the world.
struct WorldLight {
    direction: vec3f,
    own_direction: vec3f,
    position: vec3f,
    aim: vec3f,
    color: vec3f,
    intensity: f32,
    cone: vec2f,
    half_distance: f32,
    range: f32,
    own_from_world: mat3x3f,
    shadow_map: vec4f,
}

/// The frame that a light is set in.
struct LightFrame {
    world_from_own: mat3x3f,
    origin: vec3f,
}

/// Surroundings of an object at a time.
struct Surroundings {
    /// Rotation from the illumination frame to the world.
    illumination: mat3x3f,
    /// Rotation from the world to camera axes.
    camera_from_world: mat3x3f,
    /// In the world.
    eye: vec3f,
    /// Unit direction toward the viewer of a parallel view; 0 for perspective.
    parallel: vec3f,
    /// Axes of the object in the world, at length 1.
    object_axes: mat3x3f,
    /// Middle of the object's box, in the world.
    object_middle: vec3f,
    object_id: f32,
    /// Width and height in pixels.
    viewport: vec2f,
    /// Seconds.
    time: f32,
    frame: f32,
}

const DIRECTIONAL_LIGHT = 0;
const POINT_LIGHT = 1;
const SPOT_LIGHT = 2;
const PI_HOST = 3.14159265358979323846;
const FAR_AWAY_HOST = 1000000.0;

/// The vector at length 1, or another where it has no length.
fn unit_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let all = length(v);
    if all > 0.0 && all < 1e38 {
        return v / all;
    }
    return otherwise;
}

/// The number within bounds; 0 for what is none.
fn bounded_number(x: f32, least: f32, greatest: f32) -> f32 {
    if x != x {
        return 0.0;
    }
    return clamp(x, least, greatest);
}

/// A distance of a light: 0 or at least 1e-30.
fn bounded_distance(x: f32) -> f32 {
    if x > 0.0 {
        return clamp(x, 1e-30, 3.4028234663852886e38);
    }
    return 0.0;
}

fn bounded_color(color: vec3f) -> vec3f {
    return vec3f(
        bounded_number(color.x, -1e6, 1e6),
        bounded_number(color.y, -1e6, 1e6),
        bounded_number(color.z, -1e6, 1e6),
    );
}

/// The light in the world.
fn light_in_world(light: LightSettings, frame: LightFrame, kind: i32) -> WorldLight {
    let forward = vec3f(0.0, 0.0, 1.0);
    let position = frame.origin + frame.world_from_own * light.position;
    let own_from_world = transpose(frame.world_from_own);
    var direction = frame.world_from_own * unit_or(light.direction, forward);
    var own_direction = unit_or(light.direction, forward);
    var aim = frame.world_from_own * unit_or(light.aim, forward);
    let way = light.aimed_at.xyz - position;
    if light.aimed_at.w > 0.0 && length(way) > 0.0 {
        let toward = unit_or(way, forward);
        if kind == DIRECTIONAL_LIGHT {
            direction = -toward;
            own_direction = own_from_world * direction;
        }
        if kind == SPOT_LIGHT {
            aim = toward;
        }
    }
    let outer = bounded_number(light.outer, 0.0, PI_HOST);
    let inner = min(bounded_number(light.inner, 0.0, PI_HOST), outer);
    return WorldLight(
        direction,
        own_direction,
        position,
        aim,
        bounded_color(light.color),
        bounded_number(light.intensity, 0.0, 1e30),
        vec2f(cos(inner), cos(outer)),
        bounded_distance(light.half_distance),
        bounded_distance(light.range),
        own_from_world,
        light.shadow_map,
    );
}

/// Unit direction from the object toward the viewer.
fn toward_viewer(around: Surroundings) -> vec3f {
    if length(around.parallel) > 0.0 {
        return around.parallel;
    }
    return unit_or(around.eye - around.object_middle, vec3f(0.0, 0.0, 1.0));
}

/// Unit direction from the object toward a light.
fn toward_light(light: WorldLight, around: Surroundings, kind: i32) -> vec3f {
    if kind == DIRECTIONAL_LIGHT {
        return light.direction;
    }
    return unit_or(light.position - around.object_middle, vec3f(0.0, 0.0, 1.0));
}

/// Distance from the eye to the object.
fn distance_to_eye(around: Surroundings) -> f32 {
    return bounded_number(distance(around.eye, around.object_middle), 0.0, FAR_AWAY_HOST);
}

/// Angle between the object's front and the direction to the eye.
fn facing_angle(around: Surroundings) -> f32 {
    let apart = distance(around.object_axes[2], toward_viewer(around));
    return 2.0 * asin(clamp(0.5 * apart, 0.0, 1.0));
}

/// Height over the horizon of a unit direction.
fn height_angle(toward: vec3f) -> f32 {
    return asin(clamp(toward.y, -1.0, 1.0));
}

/// The value of a wire that drives keys.
fn driving_number(x: f32) -> f32 {
    return bounded_number(x, -FAR_AWAY_HOST, FAR_AWAY_HOST);
}

/// x at 0 and 1, flat there.
fn eased(x: f32) -> f32 {
    let t = clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The offset of a profile, within what it may be.
fn profile_offset(offset: f32) -> f32 {
    return clamp(offset, 0.0, PI_HOST);
}

/// The cut-off of a profile, at or after its offset.
fn profile_cutoff(offset: f32, cutoff: f32) -> f32 {
    return clamp(cutoff, profile_offset(offset), PI_HOST);
}

/// The fall-off of a profile, between its offset and its cut-off.
fn profile_falloff(offset: f32, falloff: f32, cutoff: f32) -> f32 {
    return clamp(falloff, profile_offset(offset), profile_cutoff(offset, cutoff));
}

/// Li2(1 - exp(-z)) for z from 0 to ln 2, by its series.
fn dilogarithm_host(z: f32) -> f32 {
    let s = z * z;
    var sum = -3617.0 / 510.0 / 355687428096000.0;
    sum = sum * s + 7.0 / 6.0 / 1307674368000.0;
    sum = sum * s - 691.0 / 2730.0 / 6227020800.0;
    sum = sum * s + 5.0 / 66.0 / 39916800.0;
    sum = sum * s - 1.0 / 10886400.0;
    sum = sum * s + 1.0 / 211680.0;
    sum = sum * s - 1.0 / 3600.0;
    sum = sum * s + 1.0 / 36.0;
    return z - 0.25 * s + z * s * sum;
}

/// The kernel of smooth weights between two unit directions.
fn biharmonic_kernel(a: vec3f, b: vec3f) -> f32 {
    let near = 0.25 * dot(a - b, a - b);
    if near <= 0.0 {
        return 0.0;
    }
    if near <= 0.5 {
        let z = -log(1.0 - near);
        return log(near) * z - dilogarithm_host(z);
    }
    let far = clamp(0.25 * dot(a + b, a + b), 0.0, 0.5);
    return dilogarithm_host(-log(1.0 - far)) - PI_HOST * PI_HOST / 6.0;
}

/// The kernel of weights between places.
fn distance_kernel(a: vec3f, b: vec3f) -> f32 {
    return -distance(a, b);
}
