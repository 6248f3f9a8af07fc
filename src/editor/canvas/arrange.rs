//! Placement of nodes: alignment, even spacing, and the layout in layers of the window's state.

use eframe::egui::{Pos2, Rect, Vec2, pos2, vec2};

pub(crate) use crate::state::arrangement::Link;
use crate::state::arrangement::{self, NodeBox};

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

/// Lays boxes out in layers; the center of their bounds stays where it is.
pub(crate) fn layers(rects: &[Rect], links: &[Link]) -> Vec<Pos2> {
    let node = |rect: &Rect| NodeBox { min: rect.min.into(), size: rect.size().into() };
    let boxes: Vec<NodeBox> = rects.iter().map(node).collect();
    arrangement::layers(&boxes, links).into_iter().map(Pos2::from).collect()
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
