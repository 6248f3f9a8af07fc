#version 450 core
// Contours: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Smooths normals further, from neighbors sixteen steps away.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_normals 1.
// contours.json says what to put there and how to draw.
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

/// A pixel before a level smooths it: all 0 beyond the image, and the object where nothing is.
struct RoughPixel {
    vec3 normal;
    float object;
    float depth;
};

layout(binding = 0) uniform sampler2D u_surface;

layout(std140, binding = 0) uniform CurvatureBlock { Curvature u_curvature; };

layout(binding = 1) uniform sampler2D u_normals;

layout(location = 0) out vec4 out_color;

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

RoughPixel rough_pixel(ivec2 at, int level) {
    bool local_1 = false;
    ivec2 size = ivec2(uvec2(textureSize(u_surface, 0).xy));
    if (!any(lessThan(at, ivec2(0)))) {
        local_1 = any(greaterThanEqual(at, size));
    } else {
        local_1 = true;
    }
    if (local_1) {
        return RoughPixel(vec3(0.0), 0.0, 0.0);
    }
    vec4 texel = texelFetch(u_surface, at, 0);
    if (level == 1) {
        return RoughPixel(normal_of(texel), abs(texel.w), texel.z);
    }
    return RoughPixel(texelFetch(u_normals, at, 0).xyz, abs(texel.w), texel.z);
}

/// Sum of the normals of two pairs of neighbors, at both sides of a pixel each; the pixel's own
/// normal stands in as far as one of a pair does not count. Both offsets, along columns and rows,
/// are equally long.
vec3 pairs_of(vec3 normal, Plane plane, ivec2 at, ivec2 first, ivec2 second, int level) {
    RoughPixel a = rough_pixel(at + first, level);
    RoughPixel b = rough_pixel(at - first, level);
    RoughPixel c = rough_pixel(at + second, level);
    RoughPixel d = rough_pixel(at - second, level);
    vec4 objects = vec4(a.object, b.object, c.object, d.object);
    vec4 depths = vec4(a.depth, b.depth, c.depth, d.depth);
    vec2 rise = vec2(dot(plane.rise, vec2(first)), dot(plane.rise, vec2(second)));
    vec4 rises = vec4(rise.x, -rise.x, rise.y, -rise.y);
    vec4 weights = neighbor_weights(plane, objects, depths, rises, length(vec2(first)));
    vec2 share = min(weights.xz, weights.yw);
    return share.x * (a.normal + b.normal) + (1.0 - share.x) * 2.0 * normal + share.y
        * (c.normal + d.normal) + (1.0 - share.y) * 2.0 * normal;
}

/// The normal at a pixel, smoothed from neighbors 2^level steps of 1/800 of the picture's height
/// away, in xyz; the object in w.
///
/// Two opposite neighbors count for as much as the lesser of them does. So what one side lacks, at
/// an outline or where something else lies in front, does not bend the normal toward the other
/// side.
vec4 smoothed_at(ivec2 pixel, int level) {
    ivec2 at = seen_pixel(pixel).at;
    RoughPixel center = rough_pixel(at, level);
    if (center.object == 0.0) {
        return vec4(0.0);
    }
    Plane plane = plane_of(center.object, center.depth, center.normal);
    int reach = (1 << uint(level)) * step_pixels();
    vec3 straight = pairs_of(center.normal, plane, at, ivec2(reach, 0), ivec2(0, reach), level);
    vec3 slanted = pairs_of(center.normal, plane, at, ivec2(reach), ivec2(reach, -reach), level);
    vec3 sum = 4.0 * center.normal + 2.0 * straight + slanted;
    float size = length(sum);
    vec3 normal = size > 1e-6 ? sum / vec3(max(size, 1e-6)) : center.normal;
    // A pixel that has its neighbor's normal shows no object itself.
    return vec4(normal, all(equal(at, pixel)) ? center.object : 0.0);
}

void main() {
    vec4 position = gl_FragCoord;
    out_color = smoothed_at(ivec2(position.xy), 4);
}
