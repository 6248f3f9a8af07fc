#version 450 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds how near the nearest edges of each kind are.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_edges 1, u_columns 2.
// ink-outlines.json says what to put there and how to draw.
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

/// Edges of four kinds: the unit normals of straight lines, and how far along them the lines lie,
/// in pixels of the image.
struct EdgeLines {
    vec4 x;
    vec4 y;
    vec4 offset;
};

const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2 = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;
/// What is no nearer than this many pixels is not near at all: less is rounding.
const float LEAST_NEARNESS = 1e-6;

layout(binding = 0) uniform sampler2D u_surface;

layout(std140, binding = 0) uniform CurvatureBlock { Curvature u_curvature; };

layout(binding = 1) uniform sampler2D u_edges;

layout(binding = 2) uniform sampler2D u_columns;

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
    bool local_1 = false;
    seen = SeenPixel(pixel, texelFetch(u_surface, pixel, 0));
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    if (u_curvature.samples >= 2.0) {
        local_1 = seen.texel.w == 0.0;
    } else {
        local_1 = false;
    }
    bool may_be_missed = local_1;
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

/// The number of the object in a texel's number, from 1 on; 0 where nothing is.
float object_in(float number) {
    return floor(abs(number));
}

/// The edges that codes of so many levels say, each 0 or more.
EdgeLines edges_of(vec4 codes, float levels) {
    vec4 place = floor(codes / vec4(levels));
    vec4 turn = (codes - levels * place + vec4(0.5)) * (4.0 / levels);
    bvec4 is_back = greaterThanEqual(turn, vec4(2.0));
    vec4 x = mix(vec4(1.0) - turn, turn - vec4(3.0), is_back);
    vec4 rest = vec4(1.0) - abs(x);
    vec4 y = mix(rest, -rest, is_back);
    vec4 size = sqrt(x * x + y * y);
    return EdgeLines(x / size, y / size, (place + vec4(0.5)) * (4.0 / levels) - vec4(2.0));
}

/// Distances in pixels between a pixel and the middles of the pieces of edges, by the places of the
/// edges' pixels from it: they tell which piece is the nearest, whichever way it leans. The first
/// edge is a silhouette, which counts on its inner side alone unless `beyond` says both: outside it
/// is [`FAR`].
vec4 middle_distances(EdgeLines edges, vec4 columns, vec4 rows, bool beyond) {
    bool local_2 = false;
    vec4 x = columns + edges.x * edges.offset;
    vec4 y = rows + edges.y * edges.offset;
    float inward = x.x * edges.x.x + y.x * edges.y.x;
    vec4 distances = sqrt(x * x + y * y);
    if (inward < -1.0) {
        local_2 = !beyond;
    } else {
        local_2 = false;
    }
    return vec4(local_2 ? 1000000000.0 : distances.x, distances.yzw);
}

/// Distances in pixels between a pixel and the nearest pieces of edges, by the places of the edges'
/// pixels from it. The first is a silhouette, and 0 away beyond it, where a pixel is only touched,
/// unless `beyond` pixels count as those within do.
vec4 edge_distances(EdgeLines edges, vec4 columns, vec4 rows, bool beyond) {
    vec4 across = edges.offset + edges.x * columns + edges.y * rows;
    vec4 along = abs(edges.y * columns - edges.x * rows);
    // What is farther along than the edge's own pixel lies beyond the edge's end.
    vec4 past = max(along - vec4(1.0), vec4(0.0));
    float inner = beyond ? abs(across.x) : max(across.x, 0.0);
    vec4 side = vec4(inner, abs(across.yzw));
    return sqrt(side * side + past * past);
}

/// Farthest that a line is known from its edge, in pixels: so many steps of 1/800 of the picture's
/// height, and at most 31 pixels, as far as an offset fits into a texel.
float line_reach(float viewport_height, float steps) {
    return min(steps * max(roundEven(viewport_height / 800.0), 1.0), 31.0);
}

/// True if a texel belongs to the surface of a plane, so many pixels away.
bool is_same_surface(Plane own, vec4 texel, vec2 offset) {
    bool local_3 = false;
    float error = abs(texel.z - own.depth - dot(own.rise, offset));
    if (object_in(texel.w) == object_in(own.object)) {
        local_3 = error <= 3.0 * own.tolerance * max(length(offset), 1.0);
    } else {
        local_3 = false;
    }
    return local_3;
}

vec4 nearness_at(ivec2 pixel, Plane own) {
    vec4 nearest = vec4(1000000000.0);
    // Columns and rows of the nearest edges, from the pixel.
    vec4 across = vec4(0.0);
    vec4 down = vec4(0.0);
    bool local_4 = false;
    bool local_5 = false;
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    int reach = int(line_reach(u_curvature.viewport_height, 16.0));
    for (int column = max(-reach, -pixel.x); column <= min(reach, last.x - pixel.x); column++) {
        ivec2 at = pixel + ivec2(column, 0);
        vec4 found = texelFetch(u_columns, at, 0);
        if (all(equal(found, vec4(0.0)))) {
            continue;
        }
        if (true) {
            local_4 = column != 0;
        } else {
            local_4 = false;
        }
        if (local_4) {
            local_5 = !is_same_surface(own, texelFetch(u_surface, at, 0), vec2(float(column), 0.0));
        } else {
            local_5 = false;
        }
        if (local_5) {
            continue;
        }
        vec4 coarse = abs(found);
        vec4 rows = floor(coarse / vec4(262144.0));
        EdgeLines lines = edges_of(coarse - 262144.0 * rows, 512.0);
        vec4 places = rows - vec4(31.0);
        vec4 middle_distances_value = middle_distances(lines, vec4(float(column)), places, false);
        vec4 distances = mix(vec4(1000000000.0), middle_distances_value,
            greaterThan(coarse, vec4(0.0)));
        bvec4 is_nearer = lessThan(distances, nearest);
        nearest = mix(nearest, distances, is_nearer);
        across = mix(across, vec4(float(column)), is_nearer);
        down = mix(down, places, is_nearer);
    }
    if (all(greaterThanEqual(nearest, vec4(1000000000.0)))) {
        return vec4(0.0);
    }
    // The edge itself tells the distance in full.
    ivec4 x = ivec4(pixel.x) + ivec4(across);
    ivec4 y = ivec4(pixel.y) + ivec4(down);
    vec4 texel = texelFetch(u_edges, ivec2(x.y, y.y), 0);
    vec4 texel_1 = texelFetch(u_edges, ivec2(x.z, y.z), 0);
    vec4 texel_2 = texelFetch(u_edges, ivec2(x.w, y.w), 0);
    vec4 codes = vec4(texelFetch(u_edges, ivec2(x.x, y.x), 0).x, texel.y, texel_1.z, texel_2.w);
    vec4 distances_1 = edge_distances(edges_of(abs(codes), 4096.0), across, down, false);
    vec4 nearness = clamp(vec4(float(reach)) - distances_1, vec4(0.0), vec4(float(reach)));
    vec4 near = mix(vec4(0.0), nearness, lessThan(nearest, vec4(1000000000.0)));
    return mix(near, -near, lessThan(codes, vec4(0.0)));
}

void main() {
    vec4 position = gl_FragCoord;
    bool local = false;
    ivec2 pixel = ivec2(position.xy);
    vec4 seen = seen_pixel(pixel).texel;
    if (true) {
        local = seen.w == 0.0;
    } else {
        local = false;
    }
    if (local) {
        out_color = vec4(0.0);
        return;
    }
    out_color = nearness_at(pixel, plane_of(abs(seen.w), seen.z, normal_of(seen)));
}
