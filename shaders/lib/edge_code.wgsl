// Straight edges near pixels, each packed into one number that an f32 holds exactly, so that a
// texel has four. Borders of materials and borders of ids share the last one: those of ids are
// negative.
import chiaro::slope;

/// Levels of a fine code's direction and of its place, by which an edge is told within 1/2000 of a
/// pixel.
const FINE = 4096.0;
/// Levels of a coarse code's direction and of its place: enough to tell which edge is the nearest.
const COARSE = 512.0;
/// What a coarse code leaves room for below 2^24: the row in which its edge lies.
const ROW = 262144.0;
/// Rows before the first that a code can tell.
const MOST_ROWS = 31.0;
/// A distance farther than any.
const FAR = 1e9;

/// The number of the object in a texel's number, from 1 on; 0 where nothing is.
fn object_in(number: f32) -> f32 {
    return floor(abs(number));
}

/// The number of the material in a texel's number, from 0 on.
fn material_in(number: f32) -> f32 {
    return floor(fract(abs(number)) * MATERIALS);
}

/// Edges of four kinds: the unit normals of straight lines, and how far along them the lines lie,
/// in pixels of the image.
struct EdgeLines {
    x: vec4f,
    y: vec4f,
    offset: vec4f,
}

/// The fine code of an edge by its unit normal and its offset, less than 2 pixels; never 0.
fn edge_code(normal: vec2f, offset: f32) -> f32 {
    let share = normal.x / max(abs(normal.x) + abs(normal.y), 1e-20);
    let turn = select(3.0 + share, 1.0 - share, normal.y >= 0.0);
    let direction = min(floor(turn * (0.25 * FINE)), FINE - 1.0);
    let place = floor((clamp(offset, -1.99, 1.99) + 2.0) * (0.25 * FINE));
    return place * FINE + direction;
}

/// Codes of few levels from fine ones.
fn coarse_codes(codes: vec4f) -> vec4f {
    let place = floor(codes / FINE);
    let direction = codes - FINE * place;
    let share = COARSE / FINE;
    return floor(place * share) * COARSE + floor(direction * share);
}

/// The edges that codes of so many levels say, each 0 or more.
fn edges_of(codes: vec4f, levels: f32) -> EdgeLines {
    let place = floor(codes / levels);
    let turn = (codes - levels * place + 0.5) * (4.0 / levels);
    let is_back = turn >= vec4f(2.0);
    let x = select(1.0 - turn, turn - 3.0, is_back);
    let rest = 1.0 - abs(x);
    let y = select(rest, -rest, is_back);
    let size = sqrt(x * x + y * y);
    return EdgeLines(x / size, y / size, (place + 0.5) * (4.0 / levels) - 2.0);
}

/// Distances in pixels between a pixel and the middles of the pieces of edges, by the places of the
/// edges' pixels from it: they tell which piece is the nearest, whichever way it leans. The first
/// edge is a silhouette, which counts on its inner side alone unless `beyond` says both: outside it
/// is [`FAR`].
fn middle_distances(edges: EdgeLines, columns: vec4f, rows: vec4f, beyond: bool) -> vec4f {
    let x = columns + edges.x * edges.offset;
    let y = rows + edges.y * edges.offset;
    let inward = x.x * edges.x.x + y.x * edges.y.x;
    let distances = sqrt(x * x + y * y);
    return vec4f(select(distances.x, FAR, inward < -1.0 && !beyond), distances.yzw);
}

/// Distances in pixels between a pixel and the nearest pieces of edges, by the places of the edges'
/// pixels from it. The first is a silhouette, and 0 away beyond it, where a pixel is only touched,
/// unless `beyond` pixels count as those within do.
fn edge_distances(edges: EdgeLines, columns: vec4f, rows: vec4f, beyond: bool) -> vec4f {
    let across = edges.offset + edges.x * columns + edges.y * rows;
    let along = abs(edges.y * columns - edges.x * rows);
    // What is farther along than the edge's own pixel lies beyond the edge's end.
    let past = max(along - 1.0, vec4f(0.0));
    let inner = select(max(across.x, 0.0), abs(across.x), beyond);
    let side = vec4f(inner, abs(across.yzw));
    return sqrt(side * side + past * past);
}
