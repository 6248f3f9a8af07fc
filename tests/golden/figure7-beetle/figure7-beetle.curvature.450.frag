#version 450 core
// Beetle: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds curvature from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0.
// figure7-beetle.json says what to put there and how to draw.
struct Curvature {
    /// The size of a pixel in scene units: at depth 1 for perspective, at every depth for parallel
    /// projection.
    float pixel;
    /// 1 for perspective, 0 for parallel projection.
    float perspective;
    /// Height of the picture, in pixels.
    float viewport_height;
    /// 1 where the first row of an image is at the bottom of the picture (OpenGL), 0 where it is at
    /// the top.
    float rows_up;
    /// Samples per pixel of the picture.
    float samples;
};

/// A pixel and its texel of the surface.
struct SeenPixel {
    ivec2 at;
    vec4 texel;
};

/// The plane of the surface at a pixel: it tells which neighbors lie on the same surface. Changes
/// of depth are along columns and rows of the image.
struct Plane {
    float object;
    float depth;
    /// Change of depth from a pixel to the next.
    vec2 rise;
    /// Tolerated difference of a neighbor's depth, for each pixel that the neighbor is away.
    float tolerance;
};

/// A pixel whose curvature is measured.
struct Center {
    ivec2 at;
    vec2 slope;
    Plane plane;
};

/// Neighbors on the four sides of a center: in the column after it, in the column before it, in the
/// row after it, and in the row before it.
struct Ring {
    /// Weighted changes of slope.x from the center.
    vec4 x;
    /// Weighted changes of slope.y from the center.
    vec4 y;
    vec4 weights;
};

layout(binding = 0) uniform sampler2D u_surface;

layout(std140, binding = 0) uniform CurvatureBlock { Curvature u_curvature; };

layout(location = 0) out float out_color;

/// The normal that a texel was made from.
vec3 normal_of(vec4 texel) {
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    vec2 aside = 0.2 * texel.xy;
    float rest = sqrt(max(1.0 - dot(aside, aside), 0.0));
    float nz = texel.w < 0.0 ? -rest : rest;
    vec3 facing = vec3(texel.xy, 1.0) / vec3(sqrt(1.0 + dot(texel.xy, texel.xy)));
    return nz >= 0.2 ? facing : vec3(aside, nz);
}

/// A step in pixels: a share of the picture's height, so that a larger picture measures the same
/// curvature, not a finer one.
int step_pixels() {
    return max(int(roundEven(u_curvature.viewport_height / 800.0)), 1);
}

/// 1 where a row of the image lies above the row before it, -1 where it lies below.
float row_direction() {
    return u_curvature.rows_up > 0.5 ? 1.0 : -1.0;
}

/// Offset to one of the eight pixels around a pixel, by an index from 0 to 7; the nearest first.
ivec2 around(int index) {
    int side = 1 - 2 * (index & 1);
    ivec2 straight = index < 2 ? ivec2(side, 0) : ivec2(0, side);
    return index > 3 ? ivec2(side, 1 - (index & 2)) : straight;
}

/// The pixel whose surface a pixel has: its own, or that of a neighbor.
///
/// With several samples a pixel, a look also shades pixels whose middle the object just misses:
/// they have the surface of the nearest of the eight pixels around that shows one.
SeenPixel seen_pixel(ivec2 pixel) {
    SeenPixel seen = SeenPixel(ivec2(0), vec4(0.0));
    bool local = false;
    seen = SeenPixel(pixel, texelFetch(u_surface, pixel, 0));
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    if (u_curvature.samples >= 2.0) {
        local = seen.texel.w == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
    for (int index = may_be_missed ? 7 : -1; index >= 0; index--) {
        ivec2 near = min(max(pixel + around(index), ivec2(0)), last);
        vec4 texel = texelFetch(u_surface, near, 0);
        if (texel.w != 0.0) {
            seen = SeenPixel(near, texel);
        }
    }
    return seen;
}

Plane plane_of(float object, float depth, vec3 normal) {
    float pixel = u_curvature.pixel * mix(1.0, depth, u_curvature.perspective);
    vec2 gradient = normal.xy / vec2(max(normal.z, 0.02));
    return Plane(object, depth, pixel * gradient * vec2(1.0, row_direction()), 2.0 * pixel
        * (1.0 + length(gradient)));
}

/// Weights of four neighbors that are `distance` pixels away, 0 to 1, by their objects, their
/// depths, and the rises of depth to them on the plane.
vec4 neighbor_weights(Plane plane, vec4 objects, vec4 depths, vec4 rises, float distance_) {
    vec4 error = abs(depths - vec4(plane.depth) - rises);
    float scale = 1.0 / max(plane.tolerance * distance_, 1e-30);
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    vec4 weights = clamp(vec4(2.0) - error * scale, vec4(0.0), vec4(1.0));
    return mix(vec4(0.0), weights, equal(objects, vec4(plane.object)));
}

/// The center for a pixel; its object is 0 where there is none.
Center center_at(ivec2 pixel) {
    SeenPixel seen = seen_pixel(pixel);
    vec4 texel = seen.texel;
    return Center(seen.at, texel.xy, plane_of(abs(texel.w), texel.z, normal_of(texel)));
}

/// The ring that is so many steps away, with its weight.
Ring ring_at(Center center, int steps, float weight) {
    int reach = steps * step_pixels();
    float distance_ = float(reach);
    ivec2 at = center.at;
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    vec4 a = texelFetch(u_surface, ivec2(min(at.x + reach, last.x), at.y), 0);
    vec4 b = texelFetch(u_surface, ivec2(max(at.x - reach, 0), at.y), 0);
    vec4 c = texelFetch(u_surface, ivec2(at.x, min(at.y + reach, last.y)), 0);
    vec4 d = texelFetch(u_surface, ivec2(at.x, max(at.y - reach, 0)), 0);
    // Beyond the image nothing is.
    bvec4 is_inside = greaterThanEqual(ivec4(last.x - at.x, at.x, last.y - at.y, at.y),
        ivec4(reach));
    vec4 objects = mix(vec4(0.0), abs(vec4(a.w, b.w, c.w, d.w)), is_inside);
    vec2 rise = distance_ * center.plane.rise;
    vec4 rises = vec4(rise.x, -rise.x, rise.y, -rise.y);
    vec4 neighbor_weights_value = neighbor_weights(center.plane, objects, vec4(a.z, b.z, c.z, d.z),
        rises, distance_);
    vec4 shares = weight * distance_ * neighbor_weights_value;
    return Ring(shares * (vec4(a.x, b.x, c.x, d.x) - vec4(center.slope.x)), shares
        * (vec4(a.y, b.y, c.y, d.y) - vec4(center.slope.y)), shares * distance_);
}

/// Two rings as one.
Ring joined(Ring a, Ring b) {
    return Ring(a.x + b.x, a.y + b.y, a.weights + b.weights);
}

/// The twelve neighbors one, two and three steps away.
Ring rings_at(Center center) {
    Ring near = joined(ring_at(center, 1, 1.0), ring_at(center, 2, 0.85));
    return joined(near, ring_at(center, 3, 0.5));
}

/// The derivatives along x and y, camera axes, from weighted changes to the four sides, as far as
/// each side counts; 0 where none does.
vec2 derivatives(vec4 changes, vec4 weights) {
    // A side that hardly counts any more is left to the other one, gradually.
    vec4 trust = smoothstep(vec4(0.0), vec4(0.5), weights);
    vec4 sides = changes / max(weights, vec4(1e-6)) * trust;
    vec2 along = (sides.xz - sides.yw) / max(trust.xz + trust.yw, vec2(1e-6));
    return along * vec2(1.0, row_direction());
}

/// Mean curvature from the neighbors.
float mean_curvature(Ring ring) {
    vec2 along = derivatives(vec4(ring.x.xy, ring.y.zw), ring.weights);
    return clamp(0.5 * (along.x + along.y) * u_curvature.viewport_height, -10000.0, 10000.0);
}

void main() {
    vec4 position = gl_FragCoord;
    Center center = center_at(ivec2(position.xy));
    if (center.plane.object == 0.0) {
        out_color = 0.0;
        return;
    }
    out_color = mean_curvature(rings_at(center));
}
