import chiaro::antialias;
import chiaro::noise;
import chiaro::total;

/// Cells
///
/// Space in pieces with straight borders, each with a number of its own: panes of glass, scales,
/// tiles, cracks. A Threshold of the border draws the seams, a Ramp of the number gives every piece
/// its color.
///
/// @param position "Position" from=position_object : Where among the cells.
/// @param scale "Scale" default=5 : How many cells there are along one unit of the position.
/// @param seed "Seed" default=0 : Another number, other cells.
/// @source Worley 1996
fn cells(position: vec3f, scale: f32, seed: i32) -> Cells {
    let p = clamp(bounded_vec3(position * scale), vec3f(-4194304.0), vec3f(4194304.0));
    let cell = nearest_cell(p, bitcast<u32>(seed));
    // Cells that the screen cannot show fade to their average rather than flicker.
    let visible = 1.0 - eased(footprint_of_vec3(p), 0.5, 1.0);
    let average = vec3f(CELL_BORDER_MEAN, 0.5, CELL_DISTANCE_MEAN);
    let seen = mix(average, vec3f(cell.border, cell.random, cell.distance), visible);
    return Cells(seen.x, seen.y, seen.z);
}

struct Cells {
    /// The distance to the nearest border, in cells: 0 at it, rarely above 0.3.
    border: f32,
    /// A number from 0 to 1 that is the same all over a cell.
    random: f32,
    /// The distance to the cell's middle, in cells.
    distance: f32,
}
