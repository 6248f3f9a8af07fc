import chiaro::antialias;
import chiaro::noise;
import chiaro::total;

/// Scatter UV
///
/// Hides that a tile repeats (texture bombing): the surface is divided into cells, and each shows
/// the tile from another place on. Take a lookup or a picture at A, one at B and one at C, mix B
/// into A by Mix B, and C into both by Mix C.
///
/// @param uv "UV" from=uv : Where on the tile, which repeats.
/// @param cells "Cells" default=1 min=0 : How many there are along one unit; cells smaller than a
///   tile cut it up.
/// @param sharpness "Sharpness" default=0.5 min=0 max=1 : 0 blends from the middle of a cell to the
///   next; 1 cuts cells out, with an edge as wide as a pixel.
/// @param seed "Seed" default=0 : Another number, other places.
/// @source Heitz and Neyret 2018 (the lattice of triangles)
fn scatter_uv(uv: vec2f, cells: f32, sharpness: f32, seed: i32) -> ScatteredUv {
    let p = clamp(bounded_vec2(uv * cells), vec2f(-1e6), vec2f(1e6));
    let w = footprint_of_vec2(p);
    // Cells lie around the corners of even triangles, which sheared are halves of squares.
    let sheared = vec2f(p.x - 0.577350269189625765 * p.y, 1.15470053837925153 * p.y);
    let low = floor(sheared);
    let f = sheared - low;
    let cell = vec2i(low);
    let is_upper = f.x + f.y > 1.0;
    // Nearness of each corner of the triangle: 1 at the corner, 0 on the edge across.
    let near = select(
        vec3f(1.0 - f.x - f.y, f.x, f.y),
        vec3f(f.x + f.y - 1.0, 1.0 - f.y, 1.0 - f.x),
        is_upper,
    );
    // A corner that is not near at all counts nothing: on the edge across, another takes its place.
    let width = clamp(0.5 * (1.0 - bounded(sharpness)), clamp(1.5 * max(w.x, w.y), 1e-4, 0.5), 0.5);
    let counts = clamp(1.0 + (near - max(near.x, max(near.y, near.z))) / width, vec3f(0.0),
        vec3f(1.0));
    let first = scatter_place(cell + select(vec2i(0), vec2i(1), is_upper), seed);
    let right = scatter_place(cell + vec2i(1, 0), seed);
    let above = scatter_place(cell + vec2i(0, 1), seed);
    // The lattice's corners have three colors, so that no two of a triangle have the same; A, B and
    // C each keep to one color.
    let color = ((cell.x - cell.y) % 3 + 3) % 3;
    var a = first;
    var b = right;
    var c = above;
    var share = counts;
    if color == 1 {
        a = above;
        b = first;
        c = right;
        share = counts.zxy;
    } else if color == 2 {
        a = right;
        b = above;
        c = first;
        share = counts.yzx;
    }
    let mix_b = divided(share.y, share.x + share.y);
    let mix_c = share.z / (share.x + share.y + share.z);
    let place = bounded_vec2(uv);
    return ScatteredUv(place + a, place + b, place + c, mix_b, mix_c);
}

/// Random origin of a cell in the tile.
fn scatter_place(cell: vec2i, seed: i32) -> vec2f {
    return unit_of_hash(lattice_hash(vec3i(cell, 0), u32(seed))).xy;
}

struct ScatteredUv {
    /// For the first lookup.
    a: vec2f,
    /// For the second.
    b: vec2f,
    /// For the third.
    c: vec2f,
    /// How much B counts beside A, from 0 to 1.
    mix_b: f32,
    /// How much C counts beside both, from 0 to 1.
    mix_c: f32,
}
