// The types that wires carry beside numbers and vectors. Their names are read from signatures: an
// alias says what the numbers mean, and the compiler converts where the meaning differs.

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// The triangles of all objects that cast shadows, as `shaders/lib/casters.wgsl` reads them.
alias Casters = texture_2d<f32>;

/// What lights see first, a layer for each, as `shaders/lib/shadow_map.wgsl` reads it.
alias ShadowMaps = texture_2d_array<f32>;

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

/// A free function of one number, drawn through points; flat outside of them. The layout is one for
/// uniform buffers.
struct Curve {
    /// x, y and slope (dy/dx, used by the smooth interpolation) of each point, in increasing x.
    points: array<vec4f, 16>,
    /// Number of points that count.
    count: u32,
    /// 0 straight, 1 smooth (cubic, with the slopes), 2 stepped: each point's y holds until the
    /// next point.
    interpolation: u32,
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
