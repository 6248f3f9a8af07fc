//! Placement of nodes: alignment, even spacing, and a layout in layers from left to right.
//!
//! The layout is Sugiyama's in its plain form (1981): each node lies in a column left of all that
//! it feeds, columns are ordered by the mean of their neighbors' places, and each node comes to lie
//! as near to the sockets that it feeds as the other nodes of its column let it.

use eframe::egui::{Pos2, Rect, Vec2, pos2, vec2};

/// Gap between neighboring columns, in points of the graph.
const COLUMN_GAP: f32 = 64.0;
/// Gap between neighboring nodes of a column, in points of the graph.
const ROW_GAP: f32 = 26.0;
/// Number of passes that sort the columns by their neighbors, alternately leftward and rightward.
const SWEEPS: usize = 6;

/// Side of a rectangle, to align by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Right,
    Top,
    Bottom,
}

/// Moves rectangles so that one of their edges lies on a line.
pub(crate) fn align(rects: &[Rect], side: Side) -> Vec<Pos2> {
    let all = rects.iter().fold(Rect::NOTHING, |all, rect| all.union(*rect));
    let place = |rect: &Rect| match side {
        Side::Left => pos2(all.min.x, rect.min.y),
        Side::Right => pos2(all.max.x - rect.width(), rect.min.y),
        Side::Top => pos2(rect.min.x, all.min.y),
        Side::Bottom => pos2(rect.min.x, all.max.y - rect.height()),
    };
    rects.iter().map(place).collect()
}

/// Moves rectangles so that the gaps between neighbors are equal, across or downward; the outer two
/// stay.
pub(crate) fn distribute(rects: &[Rect], is_across: bool) -> Vec<Pos2> {
    let along = |v: Vec2| if is_across { v.x } else { v.y };
    let start = |rect: &Rect| along(rect.min.to_vec2());
    let mut order: Vec<usize> = (0..rects.len()).collect();
    order.sort_by(|&a, &b| start(&rects[a]).total_cmp(&start(&rects[b])));
    let mut places: Vec<Pos2> = rects.iter().map(|rect| rect.min).collect();
    let (Some(&first), Some(&last)) = (order.first(), order.last()) else { return places };
    if order.len() < 3 {
        return places;
    }
    let room = start(&rects[last]) + along(rects[last].size()) - start(&rects[first]);
    let used: f32 = rects.iter().map(|rect| along(rect.size())).sum();
    let gap = (room - used) / (order.len() - 1) as f32;
    let mut at = start(&rects[first]);
    for index in order {
        if is_across {
            places[index].x = at;
        } else {
            places[index].y = at;
        }
        at += along(rects[index].size()) + gap;
    }
    places
}

/// Wire of the layout: the indices of its two boxes, and the heights of its ends below the boxes'
/// tops.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) from_y: f32,
    pub(crate) to_y: f32,
}

/// Lays boxes out in layers; the center of their bounds stays where it is.
pub(crate) fn layers(rects: &[Rect], links: &[Link]) -> Vec<Pos2> {
    if rects.is_empty() {
        return Vec::new();
    }
    let graph = LayeredGraph::new(rects, links);
    let mut columns = graph.columns();
    graph.sort(&mut columns);
    let places = graph.place(&columns);
    let before = rects.iter().fold(Rect::NOTHING, |all, rect| all.union(*rect));
    let moved = places.iter().zip(rects).map(|(&min, rect)| Rect::from_min_size(min, rect.size()));
    let after = moved.fold(Rect::NOTHING, |all, rect| all.union(rect));
    let shift = before.center() - after.center();
    places
        .into_iter()
        .map(|place| pos2((place.x + shift.x).round(), (place.y + shift.y).round()))
        .collect()
}

struct LayeredGraph<'a> {
    rects: &'a [Rect],
    /// Wires by the box that they leave.
    out: Vec<Vec<Link>>,
    /// Wires by the box that they reach.
    into: Vec<Vec<Link>>,
}

impl<'a> LayeredGraph<'a> {
    fn new(rects: &'a [Rect], links: &[Link]) -> Self {
        let mut graph =
            Self { rects, out: vec![Vec::new(); rects.len()], into: vec![Vec::new(); rects.len()] };
        for &link in links.iter().filter(|link| link.from != link.to) {
            graph.out[link.from].push(link);
            graph.into[link.to].push(link);
        }
        graph
    }

    /// Indices of boxes by column, from the right: a box lies left of everything that it feeds.
    /// Wires that close a ring are left out.
    fn columns(&self) -> Vec<Vec<usize>> {
        let count = self.rects.len();
        let mut rank = vec![0usize; count];
        let mut waits: Vec<usize> = self.out.iter().map(Vec::len).collect();
        let mut is_done = vec![false; count];
        let mut ready: Vec<usize> = (0..count).filter(|&index| waits[index] == 0).collect();
        // In a ring no box is ever ready; the rightmost box that is left is then taken.
        let mut by_place: Vec<usize> = (0..count).collect();
        by_place.sort_by(|&a, &b| self.rects[b].min.x.total_cmp(&self.rects[a].min.x));
        let mut next = by_place.into_iter();
        loop {
            let Some(index) = ready.pop() else {
                match next.find(|&index| !is_done[index]) {
                    Some(index) => ready.push(index),
                    None => break,
                }
                continue;
            };
            if std::mem::replace(&mut is_done[index], true) {
                continue;
            }
            for link in &self.into[index] {
                if !is_done[link.from] {
                    rank[link.from] = rank[link.from].max(rank[index] + 1);
                    waits[link.from] = waits[link.from].saturating_sub(1);
                    if waits[link.from] == 0 {
                        ready.push(link.from);
                    }
                }
            }
        }
        let mut columns = vec![Vec::new(); rank.iter().max().map_or(1, |most| most + 1)];
        for index in 0..count {
            columns[rank[index]].push(index);
        }
        for column in &mut columns {
            column.sort_by(|&a, &b| self.rects[a].min.y.total_cmp(&self.rects[b].min.y));
        }
        columns
    }

    /// Sorts each column by the mean place of the boxes that its boxes are wired to.
    fn sort(&self, columns: &mut [Vec<usize>]) {
        let mut place = vec![0.0f32; self.rects.len()];
        let number = |column: &[usize], place: &mut Vec<f32>| {
            for (order, &index) in column.iter().enumerate() {
                // Places run from 0 to 1, so that short and long columns compare.
                place[index] = (order as f32 + 0.5) / column.len() as f32;
            }
        };
        columns.iter().for_each(|column| number(column, &mut place));
        for sweep in 0..SWEEPS {
            let is_leftward = sweep % 2 == 0;
            let order: Vec<usize> = if is_leftward {
                (0..columns.len()).collect()
            } else {
                (0..columns.len()).rev().collect()
            };
            for column in order {
                let mut keyed: Vec<(f32, usize)> = columns[column]
                    .iter()
                    .map(|&index| {
                        (self.mean(index, is_leftward, &place).unwrap_or(place[index]), index)
                    })
                    .collect();
                keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
                columns[column] = keyed.into_iter().map(|(_, index)| index).collect();
                number(&columns[column], &mut place);
            }
        }
    }

    /// Mean place of a box's consumers, or of its sources. The heights of sockets count a little,
    /// so that wires to one node keep the order of its sockets.
    fn mean(&self, index: usize, is_leftward: bool, place: &[f32]) -> Option<f32> {
        let links = if is_leftward { &self.out[index] } else { &self.into[index] };
        if links.is_empty() {
            return None;
        }
        let of = |link: &Link| {
            if is_leftward {
                place[link.to] + link.to_y * 1e-5
            } else {
                place[link.from] + link.from_y * 1e-5
            }
        };
        Some(links.iter().map(of).sum::<f32>() / links.len() as f32)
    }

    /// Puts columns side by side from the right, each box as level with the sockets that it feeds
    /// as there is room.
    fn place(&self, columns: &[Vec<usize>]) -> Vec<Pos2> {
        let mut places = vec![Pos2::ZERO; self.rects.len()];
        let mut right = 0.0;
        for column in columns {
            let width = column.iter().map(|&index| self.rects[index].width()).fold(0.0, f32::max);
            let goals: Vec<f32> = column.iter().map(|&index| self.goal(index, &places)).collect();
            for (&index, y) in column.iter().zip(self.spread(column, &goals)) {
                places[index] = pos2(right - width, y);
            }
            right -= width + COLUMN_GAP;
        }
        places
    }

    /// Top at which a box's wires would run level, on average.
    fn goal(&self, index: usize, places: &[Pos2]) -> f32 {
        let links = &self.out[index];
        if links.is_empty() {
            return 0.0;
        }
        links.iter().map(|link| places[link.to].y + link.to_y - link.from_y).sum::<f32>()
            / links.len() as f32
    }

    /// Tops of a column's boxes, in order and without overlap, as near to their goals as least
    /// squares allow; boxes that touch move together.
    fn spread(&self, column: &[usize], goals: &[f32]) -> Vec<f32> {
        // Blocks of boxes that touch: the goal of the block's first box, the number of boxes, and
        // the block's height.
        let mut blocks: Vec<(f32, usize, f32)> = Vec::new();
        for (&index, &goal) in column.iter().zip(goals) {
            let mut block = (goal, 1, self.rects[index].height() + ROW_GAP);
            while let Some(&(top, count, height)) = blocks.last() {
                if top + height <= block.0 {
                    break;
                }
                // The lower block's goal for the first box of both is less by the height of the
                // upper block.
                let (a, b) = (count as f32, block.1 as f32);
                block = (
                    (top * a + (block.0 - height) * b) / (a + b),
                    count + block.1,
                    height + block.2,
                );
                blocks.pop();
            }
            blocks.push(block);
        }
        let mut tops = Vec::with_capacity(column.len());
        let mut boxes = column.iter();
        for (top, count, _) in blocks {
            let mut at = top;
            for &index in boxes.by_ref().take(count) {
                tops.push(at);
                at += self.rects[index].height() + ROW_GAP;
            }
        }
        tops
    }
}

/// Result of snapping a dragged rectangle to the edges of others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Snap {
    /// Shift that brings the rectangle onto the edges, in points of the graph.
    pub(crate) shift: Vec2,
    /// Guide line that the rectangle then lies on, upright or level: its coordinate, and the range
    /// that it spans.
    pub(crate) upright: Option<(f32, [f32; 2])>,
    pub(crate) level: Option<(f32, [f32; 2])>,
}

/// Shift by which `moved` comes to lie on an edge of one of `others`, if one is within `reach`.
pub(crate) fn snap(moved: Rect, others: impl Iterator<Item = Rect>, reach: f32) -> Snap {
    let mut best = [(reach, 0.0, None), (reach, 0.0, None)];
    for other in others {
        let edges = [
            [
                (moved.min.x, other.min.x),
                (moved.max.x, other.max.x),
                (moved.min.x, other.max.x),
                (moved.max.x, other.min.x),
            ],
            [
                (moved.min.y, other.min.y),
                (moved.max.y, other.max.y),
                (moved.min.y, other.max.y),
                (moved.max.y, other.min.y),
            ],
        ];
        for (axis, pairs) in edges.into_iter().enumerate() {
            for (own, line) in pairs {
                let distance = (line - own).abs();
                if distance < best[axis].0 {
                    let (a, b) = if axis == 0 {
                        (moved.min.y.min(other.min.y), moved.max.y.max(other.max.y))
                    } else {
                        (moved.min.x.min(other.min.x), moved.max.x.max(other.max.x))
                    };
                    best[axis] = (distance, line - own, Some((line, [a, b])));
                }
            }
        }
    }
    Snap { shift: vec2(best[0].1, best[1].1), upright: best[0].2, level: best[1].2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect(x: f32, y: f32) -> Rect {
        Rect::from_min_size(pos2(x, y), vec2(100.0, 50.0))
    }

    fn link(from: usize, to: usize) -> Link {
        Link { from, to, from_y: 20.0, to_y: 20.0 }
    }

    fn moved(rects: &[Rect], places: &[Pos2]) -> Vec<Rect> {
        rects
            .iter()
            .zip(places)
            .map(|(rect, place)| Rect::from_min_size(*place, rect.size()))
            .collect()
    }

    #[test]
    fn edges_come_to_lie_on_a_line() {
        let rects = [rect(0.0, 0.0), rect(40.0, 100.0), rect(-30.0, 300.0)];
        assert!(align(&rects, Side::Left).iter().all(|place| place.x == -30.0));
        assert!(moved(&rects, &align(&rects, Side::Bottom)).iter().all(|rect| rect.max.y == 350.0));
        assert_eq!(distribute(&rects, false)[1].y, 150.0);
        assert_eq!(distribute(&rects[..2], false)[1].y, 100.0);
    }

    /// For any wiring, sources lie left of the boxes that they feed, and boxes do not overlap.
    #[test]
    fn layers_never_overlap_and_wires_run_to_the_right() {
        let mut seed = 7u64;
        let mut random = move |below: usize| {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 33) as usize % below
        };
        for count in [1, 2, 7, 40, 200] {
            let rects: Vec<Rect> =
                (0..count).map(|_| rect(random(500) as f32, random(500) as f32)).collect();
            let links: Vec<Link> =
                (1..count).flat_map(|to| [link(random(to), to), link(random(to), to)]).collect();
            let after = moved(&rects, &layers(&rects, &links));
            for link in &links {
                assert!(after[link.from].max.x + 1.0 < after[link.to].min.x, "{count}: {link:?}");
            }
            for a in 0..count {
                for b in 0..a {
                    assert!(
                        !after[a].shrink(1.0).intersects(after[b].shrink(1.0)),
                        "{count}: {a} and {b}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_chain_is_level_and_a_ring_is_no_trouble() {
        let rects = [rect(0.0, 80.0), rect(10.0, 10.0), rect(300.0, 0.0)];
        let places = layers(&rects, &[link(0, 1), link(1, 2)]);
        assert!(places.iter().all(|place| place.y == places[0].y), "{places:?}");
        let places = layers(&rects, &[link(0, 1), link(1, 2), link(2, 0), link(1, 1)]);
        assert_eq!(places.len(), 3);
    }

    #[test]
    fn edges_snap_to_edges() {
        let snapped = snap(rect(3.0, 200.0), [rect(0.0, 0.0)].into_iter(), 6.0);
        assert_eq!(snapped.shift, vec2(-3.0, 0.0));
        assert_eq!(snapped.upright, Some((0.0, [0.0, 250.0])));
        assert_eq!(snap(rect(30.0, 200.0), [rect(0.0, 0.0)].into_iter(), 6.0).shift, Vec2::ZERO);
    }
}
