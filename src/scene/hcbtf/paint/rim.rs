//! The soft edges of a flood fill: texels that are mixes of the old color and of the color beyond
//! get the new color in place of the old one's share, so that no rim of the old color is left.
//!
//! A soft edge is climbed from the filled texels outward for as long as texels become less like the
//! old color. The top of the climb has the color beyond, and the height of a texel in the climb is
//! its share of that color. Colors count by how much of them is seen (premultiplied), so that edges
//! toward transparent texels are edges like others. A texel that is no mix of both, as where a
//! third color comes in, stays as it is.

use super::canvas::TileExtent;

/// A color weighted by its alpha: red, green, blue and alpha, each from 0 to 255.
type WeightedColor = [f64; 4];

/// Greatest distance of a texel from the mix that it is taken for, in 255ths: each of the three
/// colors is rounded, and brushes blend straight bytes.
const ROUNDED: f64 = 10.0;

/// Colors of a fill, and the width of its soft edges.
pub(super) struct FillEdge {
    /// Old color, straight.
    pub(super) first: [u8; 4],
    /// New color, straight.
    pub(super) color: [u8; 4],
    /// Greatest width of soft edges, in texels.
    pub(super) width: u32,
    pub(super) canvas: TileExtent,
}

/// Gives the new color to soft edges around the texels that `is_filled` marks. `before` is the tile
/// before the fill.
pub(super) fn recolor(
    before: &[[u8; 4]],
    edge: &FillEdge,
    is_filled: &[bool],
    after: &mut [[u8; 4]],
) {
    let first = seen(edge.first);
    let far = |index: usize| distance(seen(before[index]), first);
    let mut rim = climbed(edge, is_filled, &far);
    // Texels are visited from the tops downward, so that the color beyond is known for the texels
    // above one.
    rim.sort_by(|a, b| far(*b).total_cmp(&far(*a)).then(a.cmp(b)));
    let mut beyond: Vec<Option<WeightedColor>> =
        vec![None; if rim.is_empty() { 0 } else { before.len() }];
    for index in rim {
        let own = seen(before[index]);
        let higher = neighbors(edge.canvas, index)
            .filter(|other| far(*other) > far(index) && !is_filled[*other]);
        let tops = higher.map(|other| beyond[other].unwrap_or_else(|| seen(before[other])));
        // Of several tops that one is taken whose mix is nearest to the texel.
        let best = tops
            .map(|top| (top, share(own, first, top)))
            .filter(|(_, (_, error))| *error <= ROUNDED);
        let best = best.min_by(|(_, (_, a)), (_, (_, b))| a.total_cmp(b));
        let (top, part) = best.map_or((own, 1.0), |(top, (part, _))| (top, part));
        beyond[index] = Some(top);
        if part < 1.0 {
            let color = seen(edge.color);
            after[index] = straight(
                [0, 1, 2, 3].map(|channel| color[channel] + (top[channel] - color[channel]) * part),
            );
        }
    }
}

/// The texels of the soft edges: connected to the filled texels, each less like the old color than
/// the texel before it.
fn climbed(edge: &FillEdge, is_filled: &[bool], far: &impl Fn(usize) -> f64) -> Vec<usize> {
    let mut rim = Vec::new();
    if edge.width == 0 {
        return rim;
    }
    let mut is_taken = is_filled.to_vec();
    let mut front: Vec<usize> = (0..is_filled.len()).filter(|index| is_filled[*index]).collect();
    for _ in 0..edge.width {
        let mut next = Vec::new();
        for index in front {
            let height = if is_filled[index] { 0.0 } else { far(index) };
            for other in neighbors(edge.canvas, index) {
                if !is_taken[other] && far(other) > height {
                    is_taken[other] = true;
                    next.push(other);
                }
            }
        }
        if next.is_empty() {
            break;
        }
        rim.extend_from_slice(&next);
        front = next;
    }
    rim
}

/// The texels around a texel, corners included, row by row.
fn neighbors(canvas: TileExtent, index: usize) -> impl Iterator<Item = usize> {
    let [width, height] = canvas.size.map(|side| side as i64);
    let (x, y) = (index as i64 % width, index as i64 / width);
    let around = (-1..=1)
        .flat_map(|down| (-1..=1).map(move |across| (across, down)))
        .filter(|by| *by != (0, 0));
    around.filter_map(move |(across, down)| {
        let (x, y) = (x + across, y + down);
        let is_on = (0..width).contains(&x) && (0..height).contains(&y);
        let found = canvas.nearest(1, y) * canvas.size[0] + canvas.nearest(0, x);
        (is_on || canvas.wraps).then_some(found)
    })
}

/// The share of `top` in a mix of `first` and `top`, and the distance of the color from that mix.
fn share(own: WeightedColor, first: WeightedColor, top: WeightedColor) -> (f64, f64) {
    let whole = [0, 1, 2, 3].map(|channel| top[channel] - first[channel]);
    let length = whole.iter().map(|part| part * part).sum::<f64>();
    let along = [0, 1, 2, 3]
        .map(|channel| (own[channel] - first[channel]) * whole[channel])
        .iter()
        .sum::<f64>();
    let part = if length > 0.0 { (along / length).clamp(0.0, 1.0) } else { 1.0 };
    let mix = [0, 1, 2, 3].map(|channel| first[channel] + whole[channel] * part);
    (part, distance(own, mix))
}

fn seen([r, g, b, a]: [u8; 4]) -> WeightedColor {
    let weighted = |channel: u8| f64::from(channel) * f64::from(a) / 255.0;
    [weighted(r), weighted(g), weighted(b), f64::from(a)]
}

fn straight([r, g, b, a]: WeightedColor) -> [u8; 4] {
    let byte = |number: f64| number.round().clamp(0.0, 255.0) as u8;
    match byte(a) {
        0 => [0; 4],
        alpha => {
            let [r, g, b] = [r, g, b].map(|channel| byte(channel * 255.0 / a));
            [r, g, b, alpha]
        }
    }
}

/// The distance of two colors, in the channel in which they differ most.
fn distance(a: WeightedColor, b: WeightedColor) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
