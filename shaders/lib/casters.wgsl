// Rays from a surface toward a light, past the triangles of all objects that cast shadows.
//
// `Casters` is one texture, filled row by row (`src/scene/frame/casters.rs`). It begins with five
// texels for each object: three rows of the matrix from world space to the space of the object's
// triangles, which lie within 1 of its origin; the texel at which the object's tree begins, the
// tree's number of nodes, the object's number and the number of triangles; and the `casters` of
// what stands about it, whatever the light. Then come trees over objects, and last the objects'
// own trees, each followed by its triangles' corners and by the normals there.
//
// A node of a tree is two texels: the least corner of its box with the node that follows where the
// box is missed, and the greatest corner with what the node holds: a triangle, an object's texel,
// or -1 for more nodes, which come next. So no stack is needed, and every walk ends: nodes follow
// one another upward. Places of nodes are counted in an object's tree from its begin, and in a
// tree over objects as texels of the texture.
//
// A ray of f32 starts beside the surface that it leaves. What is as near as such roundings is no
// blocker: a triangle whose plane holds the ray's start. Nor is, for rays from a pixel's corners,
// the back of a triangle as near as the corner is: there the start has slipped under the surface
// beside its own. Nor, of the object itself, the triangle that the ray leaves, from which curved
// surfaces start a little above, on the planes of its corners' normals (Hanika 2021).
import chiaro::types;
import chiaro::numeric;

/// What a rounding may leave between a ray's start and the surface that it leaves, for places of
/// about 1.
const CASTER_NOISE: f32 = 1e-6;

/// A ray and what limits it.
struct Ray {
    origin: vec3f,
    direction: vec3f,
    /// 1 over each component of the direction.
    inverse: vec3f,
    /// The end of the ray, in lengths of the direction.
    end: f32,
    /// What a rounding may leave between the origin and a surface that it lies on.
    noise: f32,
    /// Up to this far away planes of triangles that are seen from behind are no blockers,
    under: f32,
    /// if the ray meets them within this, in lengths of its direction.
    under_end: f32,
}

/// The triangle that a ray leaves.
struct Facet {
    /// From the surface to where rays start, in the space of the object's triangles.
    lift: vec3f,
    /// Number of the triangle in the object's tree, or -1.
    triangle: i32,
}

/// No triangle: for rays that meet other objects alone.
const NO_FACET = Facet(vec3f(0.0), -1);

fn caster_texel(casters: Casters, index: i32) -> vec4f {
    return textureLoad(casters, vec2i(index & 2047, index >> 11u), 0);
}

/// The texel at which an object's row begins.
fn object_row(object: f32) -> i32 {
    return 5 * i32(object);
}

/// 1/x for numbers that may be 0, within what f32 holds.
fn inverse_of(v: vec3f) -> vec3f {
    let least = vec3f(1e-20);
    return 1.0 / select(v, least, abs(v) < least);
}

/// A point in the space of an object's triangles; the object's row of texels begins at `row`.
fn place_among(casters: Casters, row: i32, place: vec3f) -> vec3f {
    let x = caster_texel(casters, row);
    let y = caster_texel(casters, row + 1);
    let z = caster_texel(casters, row + 2);
    return vec3f(dot(x.xyz, place) + x.w, dot(y.xyz, place) + y.w, dot(z.xyz, place) + z.w);
}

/// A vector of world space in the space of an object's triangles.
fn turned_among(casters: Casters, row: i32, vector: vec3f) -> vec3f {
    let x = caster_texel(casters, row);
    let y = caster_texel(casters, row + 1);
    let z = caster_texel(casters, row + 2);
    return vec3f(dot(x.xyz, vector), dot(y.xyz, vector), dot(z.xyz, vector));
}

/// What a rounding may leave of a place in world space where an object's triangles lie.
fn noise_among(casters: Casters, row: i32, place: vec3f) -> f32 {
    let x = abs(caster_texel(casters, row));
    let y = abs(caster_texel(casters, row + 1));
    let z = abs(caster_texel(casters, row + 2));
    let far = abs(place);
    let most = max(max(dot(x.xyz, far) + x.w, dot(y.xyz, far) + y.w), dot(z.xyz, far) + z.w);
    return CASTER_NOISE * (1.0 + most);
}

/// A ray in the space of an object's triangles.
fn ray_among(casters: Casters, row: i32, ray: Ray) -> Ray {
    let origin = place_among(casters, row, ray.origin);
    let direction = turned_among(casters, row, ray.direction);
    let noise = noise_among(casters, row, ray.origin);
    let scale = sqrt(dot(direction, direction));
    return Ray(origin, direction, inverse_of(direction), ray.end, noise, ray.under * scale,
        ray.under_end);
}

/// True if a ray meets a box.
fn meets_box(ray: Ray, least: vec3f, most: vec3f) -> bool {
    let a = (least - ray.origin) * ray.inverse;
    let b = (most - ray.origin) * ray.inverse;
    let near = min(a, b);
    let far = max(a, b);
    let enters = max(max(near.x, near.y), max(near.z, 0.0));
    let leaves = min(min(far.x, far.y), min(far.z, ray.end));
    return enters <= leaves * 1.000002;
}

/// Where a ray meets a triangle, in lengths of its direction; below 0 where it does not, and where
/// that does not count. Its edges count, and a little more, so that rays slip through no seam.
fn meets_triangle(ray: Ray, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    let ab = b - a;
    let ac = c - a;
    let normal = cross(ab, ac);
    let across = cross(ray.direction, ac);
    // Above 0 where the ray comes from the front.
    let facing = dot(ab, across);
    let offset = ray.origin - a;
    let height = abs(dot(normal, offset));
    let area = sqrt(dot(normal, normal));
    if !(abs(facing) > 1e-30) || !(height > ray.noise * area) {
        return -1.0;
    }
    let u = dot(offset, across) / facing;
    let along = cross(offset, ab);
    let v = dot(ray.direction, along) / facing;
    let distance = dot(ac, along) / facing;
    let is_inside = u >= -2e-6 && v >= -2e-6 && u + v <= 1.000002;
    let is_under = facing < 0.0 && height <= ray.under * area && distance <= ray.under_end;
    let is_met = is_inside && !is_under && distance > 0.0 && distance < ray.end;
    return select(-1.0, distance, is_met);
}

/// Where a ray first meets an object's triangles, or any of them if `is_any`; below 0 where it
/// meets none. `facet` is the one that the ray leaves, if it is the object's own.
fn meets_object(casters: Casters, row: i32, world: Ray, facet: Facet, is_any: bool) -> f32 {
    let tree = caster_texel(casters, row + 3);
    let begin = i32(tree.x);
    let nodes = i32(tree.y);
    let triangles = begin + 2 * nodes;
    var ray = ray_among(casters, row, world);
    ray.origin += facet.lift;
    var met = -1.0;
    var node = 0;
    while node < nodes {
        let least = caster_texel(casters, begin + 2 * node);
        let most = caster_texel(casters, begin + 2 * node + 1);
        if !meets_box(ray, least.xyz, most.xyz) {
            node = max(i32(least.w), node + 1);
            continue;
        }
        node += 1;
        var triangle = i32(most.w);
        while triangle >= 0 {
            let at = triangles + 3 * triangle;
            let a = caster_texel(casters, at);
            let b = caster_texel(casters, at + 1);
            let c = caster_texel(casters, at + 2);
            let distance = meets_triangle(ray, a.xyz, b.xyz, c.xyz);
            if distance > 0.0 && triangle != facet.triangle {
                met = distance;
                ray.end = distance;
                if is_any {
                    return met;
                }
            }
            // All triangles of a node but its last say that more follow.
            triangle = select(-1, triangle + 1, a.w > 0.5);
        }
    }
    return met;
}

/// Where a ray first meets other objects than the one that it leaves, or any of them if `is_any`,
/// and the number of the object; below 0 where it meets none. `root` is the texel of a tree over
/// objects.
fn meets_others(casters: Casters, root: i32, ray: Ray, object: f32, is_any: bool) -> vec2f {
    var met = vec2f(-1.0);
    if root < 0 {
        return met;
    }
    let end = i32(caster_texel(casters, root).w);
    var rest = ray;
    var node = root;
    while node < end {
        let least = caster_texel(casters, node);
        let most = caster_texel(casters, node + 1);
        if !meets_box(rest, least.xyz, most.xyz) {
            node = max(i32(least.w), node + 2);
            continue;
        }
        node += 2;
        let row = i32(most.w);
        if row < 0 {
            continue;
        }
        let other = caster_texel(casters, row + 3).z;
        if other == object {
            continue;
        }
        let distance = meets_object(casters, row, rest, NO_FACET, is_any);
        if distance > 0.0 {
            met = vec2f(distance, other);
            rest.end = distance;
            if is_any {
                return met;
            }
        }
    }
    return met;
}

/// The texel of the tree over the objects that cast a light's shadows; below 0 where none do.
fn caster_root(casters: f32) -> i32 {
    return i32(floor(0.5 * casters));
}

/// The `casters` of what stands about an object, whatever the light.
fn occluders(casters: Casters, object: f32) -> f32 {
    return caster_texel(casters, object_row(object) + 4).x;
}

/// True if an object casts a light's shadows onto itself.
fn casts_on_itself(casters: f32) -> bool {
    return casters - 2.0 * floor(0.5 * casters) > 0.5;
}

/// The distance between a point and a triangle, squared.
fn distance_to_triangle(point: vec3f, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    let normal = cross(b - a, c - a);
    let beyond_ab = dot(cross(normal, b - a), point - a) < 0.0;
    let beyond_bc = dot(cross(normal, c - b), point - b) < 0.0;
    let beyond_ca = dot(cross(normal, a - c), point - c) < 0.0;
    let square = dot(normal, normal);
    if beyond_ab || beyond_bc || beyond_ca || square <= 1e-36 {
        return min(min(distance_to_segment(point, a, b), distance_to_segment(point, b, c)),
            distance_to_segment(point, c, a));
    }
    let height = dot(normal, point - a);
    return height * height / square;
}

/// The distance between a point and the segment from a to b, squared.
fn distance_to_segment(point: vec3f, a: vec3f, b: vec3f) -> f32 {
    let along = b - a;
    let share = clamp(dot(point - a, along) / max(dot(along, along), 1e-36), 0.0, 1.0);
    let rest = point - a - share * along;
    return dot(rest, rest);
}

/// True if a box is nearer to a point than `radius`.
fn is_near_box(point: vec3f, radius: f32, least: vec3f, most: vec3f) -> bool {
    return all(point >= least - radius) && all(point <= most + radius);
}

/// The triangle of an object on which a point of its surface lies, and where rays from there start;
/// none where no triangle is within a pixel. `normal` is the surface's, toward the seen side.
fn facet_at(
    casters: Casters,
    object: f32,
    place: vec3f,
    normal: vec3f,
    across: vec3f,
    down: vec3f,
) -> Facet {
    let row = object_row(object);
    let tree = caster_texel(casters, row + 3);
    let point = place_among(casters, row, place);
    let near = 4.0 * noise_among(casters, row, place);
    var found = nearest_triangle(casters, tree, point, near);
    if found < 0 {
        // Where a pixel's middle is beside the triangle that it shows.
        let a = turned_among(casters, row, across);
        let b = turned_among(casters, row, down);
        found = nearest_triangle(casters, tree, point, near + sqrt(dot(a, a) + dot(b, b)));
    }
    if found < 0 {
        return NO_FACET;
    }
    let corners = i32(tree.x) + 2 * i32(tree.y) + 3 * found;
    // Normals follow the corners of all triangles, which the tree's fourth number counts.
    let normals = corners + 3 * i32(tree.w);
    let seen = turned_among(casters, row, normal);
    return Facet(lift_of(casters, corners, normals, point, seen), found);
}

/// The number of the triangle that is nearest to a point, in their own space; -1 where none is
/// within a radius. `tree` is the fourth texel of the object's row.
fn nearest_triangle(casters: Casters, tree: vec4f, point: vec3f, within: f32) -> i32 {
    let begin = i32(tree.x);
    let nodes = i32(tree.y);
    let triangles = begin + 2 * nodes;
    var radius = within;
    var found = -1;
    var node = 0;
    while node < nodes {
        let least = caster_texel(casters, begin + 2 * node);
        let most = caster_texel(casters, begin + 2 * node + 1);
        if !is_near_box(point, radius, least.xyz, most.xyz) {
            node = max(i32(least.w), node + 1);
            continue;
        }
        node += 1;
        var triangle = i32(most.w);
        while triangle >= 0 {
            let at = triangles + 3 * triangle;
            let corner = caster_texel(casters, at);
            let distance = sqrt(distance_to_triangle(point, corner.xyz,
                caster_texel(casters, at + 1).xyz, caster_texel(casters, at + 2).xyz));
            if distance < radius {
                radius = distance;
                found = triangle;
            }
            triangle = select(-1, triangle + 1, corner.w > 0.5);
        }
    }
    return found;
}

/// From a point of a triangle to the planes of its corners' normals, weighted as the corners are;
/// 0 where these lie below (Hanika 2021, as tangent planes of the curved surface).
fn lift_of(casters: Casters, corners: i32, normals: i32, point: vec3f, seen: vec3f) -> vec3f {
    let a = caster_texel(casters, corners).xyz;
    let b = caster_texel(casters, corners + 1).xyz;
    let c = caster_texel(casters, corners + 2).xyz;
    let normal = cross(b - a, c - a);
    let square = max(dot(normal, normal), 1e-36);
    let of_b = clamp(dot(cross(point - a, c - a), normal) / square, 0.0, 1.0);
    let of_c = clamp(dot(cross(b - a, point - a), normal) / square, 0.0, 1.0);
    let of_a = max(1.0 - of_b - of_c, 0.0);
    // Of a surface seen from behind the normals point away.
    let side = select(-1.0, 1.0, dot(normal, seen) >= 0.0);
    return lift_to(point - a, side * caster_texel(casters, normals).xyz, of_a)
        + lift_to(point - b, side * caster_texel(casters, normals + 1).xyz, of_b)
        + lift_to(point - c, side * caster_texel(casters, normals + 2).xyz, of_c);
}

fn lift_to(from_corner: vec3f, normal: vec3f, weight: f32) -> vec3f {
    return -weight * min(dot(from_corner, normal), 0.0) * normal;
}
