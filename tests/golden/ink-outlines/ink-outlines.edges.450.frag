#version 450 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds where surfaces end, fold and meet.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0.
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

/// What a pixel shows: a piece of a surface.
struct Facet {
    /// Unit, in camera axes.
    vec3 normal;
    /// Toward the eye in camera axes, of a length of 1 and more.
    vec3 toward;
    float depth;
    /// The texel's number: the object's, the material's and the id's.
    float number;
    /// Change of depth from a pixel to the next, along columns and rows.
    vec2 rise;
    /// The same where the surface is not seen as steeply: at least LEAST_NZ of it faces the eye.
    vec2 gentle_rise;
};

/// A piece of an edge: its kind, the unit normal of a straight line in pixels of the image, and how
/// far along it from the pixel's middle the line lies.
struct Edge {
    int kind;
    vec2 normal;
    float offset;
    /// How well the line is known, 0 to 1: little where it runs along the way to the neighbor.
    float trust;
};

/// The course of an edge past a pixel: how far beyond the pixel's middle it lies, 0 to 1, and how
/// far that changes from one pixel to the next along it.
struct Course {
    float place;
    float slope;
    /// Share of the rows nearby over which it was followed.
    float trust;
};

/// Sums over the rows of a course, to fit a line and a parabola: x is how far along a row lies, y
/// how far beyond the pixel's middle the edge lies there.
struct CourseSums {
    float count;
    float x;
    float y;
    float xx;
    float xy;
    float yy;
    float xxy;
};

layout(binding = 0) uniform sampler2D u_surface;

layout(std140, binding = 0) uniform CurvatureBlock { Curvature u_curvature; };

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

/// The number of the object in a texel's number, from 1 on; 0 where nothing is.
float object_in(float number) {
    return floor(abs(number));
}

/// The number of the material in a texel's number, from 0 on.
float material_in(float number) {
    return floor(fract(abs(number)) * 32.0);
}

/// The fine code of an edge by its unit normal and its offset, less than 2 pixels; never 0.
float edge_code(vec2 normal, float offset) {
    float share = normal.x / max(abs(normal.x) + abs(normal.y), 1e-20);
    float turn = normal.y >= 0.0 ? 1.0 - share : 3.0 + share;
    float direction = min(floor(turn * 1024.0), 4095.0);
    float place = floor((clamp(offset, -1.99, 1.99) + 2.0) * 1024.0);
    return place * 4096.0 + direction;
}

/// Size in scene units of a pixel at a depth.
float pixel_size_at(float depth) {
    return u_curvature.pixel * mix(1.0, depth, u_curvature.perspective);
}

Facet facet_at(ivec2 at) {
    vec4 texel = texelFetch(u_surface, at, 0);
    vec3 normal = normal_of(texel);
    vec2 middle = 0.5 * vec2(uvec2(textureSize(u_surface, 0).xy));
    vec2 from_middle = (vec2(at) + vec2(0.5) - middle) * vec2(1.0, row_direction());
    vec3 toward = vec3(-u_curvature.pixel * u_curvature.perspective * from_middle, 1.0);
    float facing = dot(normal, toward);
    vec2 change = pixel_size_at(texel.z) * normal.xy * vec2(1.0, row_direction());
    return Facet(normal, toward, texel.z, abs(texel.w), change / vec2(max(facing, 0.02)), change
        / vec2(max(facing, 0.2)));
}

/// True if the surfaces of two neighbors meet between them. The nearer one may not reach the other
/// more steeply than [`LEAST_NZ`] allows: then it ends in front.
bool meets(Facet own, Facet other, vec2 step_) {
    bool local = false;
    bool is_nearer = own.depth <= other.depth;
    float rise = dot(is_nearer ? own.gentle_rise : own.rise, step_);
    float other_rise = dot(is_nearer ? other.rise : other.gentle_rise, step_);
    float here = own.depth - (other.depth - other_rise);
    float there = own.depth + rise - other.depth;
    float steepness = min(length(own.gentle_rise), length(other.gentle_rise));
    float tolerance = pixel_size_at(min(own.depth, other.depth)) + steepness;
    if (!(here * there <= 0.0)) {
        local = min(abs(here), abs(there)) <= tolerance;
    } else {
        local = true;
    }
    return local;
}

/// True if a pixel shows the surface with this number, no farther than `limit`.
bool shows(ivec2 at, float number, float limit) {
    bool local_1 = false;
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    vec4 texel = texelFetch(u_surface, min(max(at, ivec2(0)), last), 0);
    if (abs(texel.w) == number) {
        local_1 = texel.z < limit;
    } else {
        local_1 = false;
    }
    return local_1;
}

/// The course that fits rows best.
Course fitted_course(CourseSums sums, bool is_arc) {
    float trust = sums.count / 11.0;
    float spread = sums.count * sums.xx - sums.x * sums.x;
    float slope = (sums.count * sums.xy - sums.x * sums.y) / spread;
    float straight = (sums.y - slope * sums.x) / sums.count;
    if (trust < 1.0) {
        return Course(clamp(straight, 0.0, 1.0), slope, trust);
    }
    // Over all rows x sums to 0, its fourth powers to 1958.
    float bent = (1958.0 * sums.y - sums.xx * sums.xxy) / (sums.count * 1958.0 - sums.xx * sums.xx);
    float left = (sums.yy - straight * sums.y - slope * sums.xy) / sums.count;
    float share = clamp((left - 0.09) / 0.05, 0.0, 1.0);
    return Course(clamp(mix(straight, bent, is_arc ? 1.0 : share), 0.0, 1.0), slope, trust);
}

/// The course of the edge between a pixel and its neighbor, by the pixels at which it changes over
/// from one row to the next. A flat course passes the middle of a pixel near each such change; a
/// steep or bent one is fitted.
Course course_at(ivec2 pixel, ivec2 step_, float number, float limit) {
    // The first change to both sides: how far along, and how far beyond the pixel.
    vec2 ends[2] = vec2[2](vec2(0.0), vec2(0.0));
    int changes = 0;
    CourseSums sums = CourseSums(1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0);
    int height = 0;
    bool is_open = false;
    int row = 0;
    bool local_2 = false;
    bool local_3 = false;
    int change = 0;
    bool local_4 = false;
    bool local_5 = false;
    bool local_6 = false;
    bool local_7 = false;
    bool local_8 = false;
    bool local_9 = false;
    ivec2 along = abs(step_.yx);
    for (int side = 0; side < 2; side++) {
        ivec2 way = along * (1 - 2 * side);
        height = 0;
        is_open = true;
        row = 1;
        while(true) {
            if (row <= 12) {
                if (!is_open) {
                    local_3 = row <= 5;
                } else {
                    local_3 = true;
                }
                local_2 = local_3;
            } else {
                local_2 = false;
            }
            if (local_2) {
            } else {
                break;
            }
            {
                ivec2 at = pixel + way * row + step_ * height;
                change = 0;
                if (shows(at, number, limit)) {
                    if (shows(at + step_, number, limit)) {
                        change = 1;
                    }
                } else {
                    change = -1;
                }
                if (change > 0) {
                    local_4 = shows(at + 2 * step_, number, limit);
                } else {
                    local_4 = false;
                }
                if (local_4) {
                    break;
                }
                if (change < 0) {
                    local_5 = !shows(at - step_, number, limit);
                } else {
                    local_5 = false;
                }
                if (local_5) {
                    break;
                }
                if (change != 0) {
                    if (is_open) {
                        ends[side] = vec2(float(row) - 0.5, float(max(height, height + change)));
                        is_open = false;
                    }
                    changes = changes + (row <= 5 ? 1 : 0);
                    height = height + change;
                }
                if (row <= 5) {
                    float x = float(row * (1 - 2 * side));
                    float y = float(height) + 0.5;
                    sums.count = sums.count + 1.0;
                    sums.x = sums.x + x;
                    sums.y = sums.y + y;
                    sums.xx = sums.xx + x * x;
                    sums.xy = sums.xy + x * y;
                    sums.yy = sums.yy + y * y;
                    sums.xxy = sums.xxy + x * x * y;
                }
                row = row + 1;
            }
        }
        if (is_open) {
            ends[side] = vec2(float(row) - 0.5, float(height) + 0.5);
        }
    }
    float length_ = ends[0].x + ends[1].x;
    float slope = (ends[0].y - ends[1].y) / length_;
    float place = ends[1].y + slope * ends[1].x;
    if (ends[0].y == ends[1].y) {
        local_6 = place != 0.5;
    } else {
        local_6 = false;
    }
    bool is_arc = local_6;
    if (!(changes >= 3)) {
        if (is_arc) {
            local_8 = changes >= 2;
        } else {
            local_8 = false;
        }
        local_7 = local_8;
    } else {
        local_7 = true;
    }
    if (local_7) {
        local_9 = sums.count >= 7.0;
    } else {
        local_9 = false;
    }
    if (local_9) {
        return fitted_course(sums, is_arc);
    }
    // The top of an arc lies beyond the changes to both sides, by half a pixel in the mean.
    float rise = is_arc ? 4.0 * ends[0].x * ends[1].x / (length_ * length_) : 0.0;
    float trust = sums.count / 11.0;
    return Course(clamp(mix(place, 0.5, rise), 0.0, 1.0), slope, trust);
}

/// Square of how much a facet faces the eye; negative for one that is turned away.
float facing_squared(Facet facet) {
    float facing = dot(facet.normal, facet.toward);
    return facing * abs(facing) / dot(facet.toward, facet.toward);
}

vec2 course_normal(Course course, vec2 toward) {
    vec2 along = abs(toward.yx);
    return (toward - course.slope * along) / vec2(sqrt(1.0 + course.slope * course.slope));
}

Edge edge_along(int kind, Course course, vec2 toward, vec2 normal) {
    float lean = dot(normal, toward);
    return Edge(kind, normal, course.place * lean, course.trust * lean);
}

/// The edge of a surface that ends in front of what is farther than `limit`, or of another object.
Edge silhouette(Facet own, ivec2 pixel, ivec2 step_, float limit) {
    bool local_10 = false;
    bool local_11 = false;
    bool local_12 = false;
    vec2 toward = vec2(step_);
    Course course = course_at(pixel, step_, own.number, limit);
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    Facet before = facet_at(min(max(pixel - step_, ivec2(0)), last));
    // Near its outline the facing of a round form goes like the root of the distance.
    float facing = facing_squared(own);
    float change = facing_squared(before) - facing;
    vec2 across = own.normal.xy * vec2(1.0, row_direction());
    vec2 normal = across / vec2(max(length(across), 1e-6));
    if (before.number == own.number) {
        local_10 = facing < 0.36;
    } else {
        local_10 = false;
    }
    if (local_10) {
        local_11 = change > 0.0001;
    } else {
        local_11 = false;
    }
    if (local_11) {
        local_12 = dot(normal, toward) > 0.5;
    } else {
        local_12 = false;
    }
    bool is_round = local_12;
    float found = facing / max(change, 0.0001);
    float place = clamp(found, 0.0, 1.0);
    // As far as this is not between the pixels, the form is not as round as its normals.
    float trust = is_round ? clamp(2.0 - 4.0 * abs(found - place), 0.0, 1.0) : 0.0;
    Course seen = Course(mix(course.place, place, trust), course.slope,
        mix(course.trust, 1.0, trust));
    vec2 turned = mix(course_normal(course, toward), normal, trust);
    return edge_along(0, seen, toward, turned / vec2(length(turned)));
}

/// Change of the normal between two neighbors that a round form would have: what it is to both
/// sides of them.
float round_bend(Facet own, Facet other, ivec2 pixel, ivec2 step_) {
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    vec4 before = texelFetch(u_surface, min(max(pixel - step_, ivec2(0)), last), 0);
    vec4 after = texelFetch(u_surface, min(max(pixel + 2 * step_, ivec2(0)), last), 0);
    vec2 bends = vec2(length(normal_of(before) - own.normal),
        length(normal_of(after) - other.normal));
    vec2 numbers = vec2(abs(before.w), abs(after.w));
    vec2 shares = mix(vec2(0.0), vec2(1.0), equal(numbers, vec2(own.number)));
    return dot(bends, shares) / max(shares.x + shares.y, 1.0);
}

/// The edge between a pixel and its neighbor.
Edge edge_between(Facet own, ivec2 pixel, ivec2 step_) {
    bool local_13 = false;
    bool local_14 = false;
    Edge none = Edge(-1, vec2(0.0), 0.0, 0.0);
    ivec2 at = pixel + step_;
    if (!any(lessThan(at, ivec2(0)))) {
        local_13 = any(greaterThanEqual(at, ivec2(uvec2(textureSize(u_surface, 0).xy))));
    } else {
        local_13 = true;
    }
    if (local_13) {
        return none;
    }
    Facet other = facet_at(at);
    if (other.number == 0.0) {
        return silhouette(own, pixel, step_, 1000000000.0);
    }
    vec2 toward = vec2(step_);
    bool is_same_object = object_in(own.number) == object_in(other.number);
    if (!meets(own, other, toward)) {
        if (own.depth > other.depth) {
            return none;
        }
        float middle = 0.5 * (own.depth + other.depth);
        return silhouette(own, pixel, step_, is_same_object ? middle : 1000000000.0);
    }
    if (!is_same_object) {
        return Edge(2, vec2(0.0), 0.0, 0.0);
    }
    if (own.number != other.number) {
        bool is_material = material_in(own.number) != material_in(other.number);
        int kind = is_material ? 3 : 4;
        return Edge(kind, vec2(0.0), 0.0, 0.0);
    }
    float bend = length(own.normal - other.normal);
    if (!(bend < 0.5176381)) {
        local_14 = bend - round_bend(own, other, pixel, step_) < 0.5176381;
    } else {
        local_14 = true;
    }
    if (local_14) {
        return none;
    }
    return Edge(1, vec2(0.0), 0.0, 0.0);
}

/// The line in which the planes of two facets meet, or along which a border runs over one plane.
Edge meeting(Facet own, ivec2 pixel, ivec2 step_, int kind) {
    bool local_15 = false;
    Facet other = facet_at(pixel + step_);
    vec2 toward = vec2(step_);
    vec2 slope = own.rise - other.rise;
    float steepness = length(slope);
    float here = own.depth - (other.depth - dot(other.rise, toward));
    float side = dot(slope, toward);
    if (abs(side) > 0.1 * pixel_size_at(own.depth)) {
        local_15 = abs(side) > 0.3 * steepness;
    } else {
        local_15 = false;
    }
    if (local_15) {
        float share = clamp(-here / side, 0.0, 1.0);
        vec2 normal = slope / vec2(side > 0.0 ? steepness : -steepness);
        float lean = dot(normal, toward);
        return Edge(kind, normal, share * lean, lean);
    }
    if (kind == 1) {
        return Edge(kind, toward, 0.5, 0.0);
    }
    Course course = course_at(pixel, step_, own.number, 1000000000.0);
    return edge_along(kind, course, toward, course_normal(course, toward));
}

/// True if a surface plainly goes on to a neighbor, which most do: that costs little to tell.
bool goes_on(Facet own, vec2 slope, float size, ivec2 pixel, ivec2 step_) {
    bool local_16 = false;
    bool local_17 = false;
    ivec2 last = ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1);
    vec4 texel = texelFetch(u_surface, min(max(pixel + step_, ivec2(0)), last), 0);
    vec2 change = abs(texel.xy - slope);
    float error = abs(texel.z - own.depth - dot(own.gentle_rise, vec2(step_)));
    if (abs(texel.w) == own.number) {
        local_16 = error <= size;
    } else {
        local_16 = false;
    }
    if (local_16) {
        local_17 = max(change.x, change.y) < 0.35;
    } else {
        local_17 = false;
    }
    return local_17;
}

/// Codes of the edges of each kind between a pixel and the four beside it, those that are known
/// best; 0 for none, and negative for borders of ids.
vec4 edges_at(ivec2 pixel) {
    uint left = 0u;
    vec4 codes = vec4(0.0);
    vec4 trust = vec4(-1.0);
    Edge edge = Edge(0, vec2(0.0), 0.0, 0.0);
    Facet own = facet_at(pixel);
    if (own.number == 0.0) {
        return vec4(0.0);
    }
    vec2 slope = texelFetch(u_surface, pixel, 0).xy;
    float size = pixel_size_at(own.depth);
    for (int index = 0; index < 4; index++) {
        bool goes_on_value = goes_on(own, slope, size, pixel, around(index));
        left = left | (goes_on_value ? 0u : (1u << uint(index)));
    }
    // Most pixels have no round at all: what a loop does not enter costs nothing everywhere.
    for (int index_1 = left == 0u ? 4 : 0; index_1 < 4; index_1++) {
        if (((left >> uint(index_1)) & 1u) == 0u) {
            continue;
        }
        ivec2 step_ = around(index_1);
        edge = edge_between(own, pixel, step_);
        if (edge.kind == -1) {
            continue;
        }
        if (edge.kind != 0) {
            edge = meeting(own, pixel, step_, edge.kind);
        }
        int place = min(edge.kind, 3);
        bvec4 is_kind = equal(ivec4(place), ivec4(0, 1, 2, 3));
        float edge_now = edge.trust;
        vec4 trust_now = trust;
        bvec4 is_better = bvec4(is_kind.x && greaterThan(vec4(edge_now), trust_now).x, is_kind.y
            && greaterThan(vec4(edge_now), trust_now).y, is_kind.z
            && greaterThan(vec4(edge_now), trust_now).z, is_kind.w
            && greaterThan(vec4(edge_now), trust_now).w);
        trust = mix(trust, vec4(edge.trust), is_better);
        float code = edge_code(edge.normal, edge.offset);
        codes = mix(codes, vec4(edge.kind == 4 ? -code : code), is_better);
    }
    return codes;
}

void main() {
    vec4 position = gl_FragCoord;
    out_color = edges_at(ivec2(position.xy));
}
