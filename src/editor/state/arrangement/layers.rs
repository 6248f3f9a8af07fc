//! Layout of boxes in layers from left to right.
//!
//! The layout is Sugiyama's in its plain form (1981): each node lies in a column left of all that
//! it feeds, columns are ordered by the mean of their neighbors' places, and each node comes to lie
//! as near to the sockets that it feeds as the other nodes of its column let it.

/// Gap between neighboring columns, in points of the graph.
pub(super) const COLUMN_GAP: f32 = 64.0;
/// Gap between neighboring nodes of a column, in points of the graph.
const ROW_GAP: f32 = 26.0;
/// Number of passes that sort the columns by their neighbors, alternately leftward and rightward.
const SWEEPS: usize = 6;

/// Box of a node on the canvas, in points of the graph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NodeBox {
    /// Upper left corner.
    pub(crate) min: [f32; 2],
    /// Width and height.
    pub(crate) size: [f32; 2],
}

impl NodeBox {
    /// Bounds of boxes; `None` of none.
    pub(super) fn around(boxes: impl Iterator<Item = Self>) -> Option<Self> {
        boxes.reduce(|all, one| {
            let min = [0, 1].map(|axis| all.min[axis].min(one.min[axis]));
            let size = [0, 1].map(|axis| all.max(axis).max(one.max(axis)) - min[axis]);
            Self { min, size }
        })
    }

    /// Coordinate of the right edge, axis 0, or of the lower one, axis 1.
    pub(crate) fn max(&self, axis: usize) -> f32 {
        self.min[axis] + self.size[axis]
    }

    fn center(&self, axis: usize) -> f32 {
        self.min[axis] + self.size[axis] / 2.0
    }

    /// True if the boxes overlap, wholly or in part.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.min[axis] < other.max(axis) && other.min[axis] < self.max(axis))
    }
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

/// Lays boxes out in layers, by their corners; the center of their bounds stays where it is.
pub(crate) fn layers(boxes: &[NodeBox], links: &[Link]) -> Vec<[f32; 2]> {
    let Some(before) = NodeBox::around(boxes.iter().copied()) else { return Vec::new() };
    let graph = LayeredGraph::new(boxes, links);
    let mut columns = graph.columns();
    graph.sort(&mut columns);
    let places = graph.place(&columns);
    let moved = places.iter().zip(boxes).map(|(&min, one)| NodeBox { min, size: one.size });
    let after = NodeBox::around(moved).unwrap_or(before);
    let shift = [0, 1].map(|axis| before.center(axis) - after.center(axis));
    places.into_iter().map(|[x, y]| [(x + shift[0]).round(), (y + shift[1]).round()]).collect()
}

struct LayeredGraph<'a> {
    boxes: &'a [NodeBox],
    /// Wires by the box that they leave.
    out: Vec<Vec<Link>>,
    /// Wires by the box that they reach.
    into: Vec<Vec<Link>>,
}

impl<'a> LayeredGraph<'a> {
    fn new(boxes: &'a [NodeBox], links: &[Link]) -> Self {
        let mut graph =
            Self { boxes, out: vec![Vec::new(); boxes.len()], into: vec![Vec::new(); boxes.len()] };
        for &link in links.iter().filter(|link| link.from != link.to) {
            graph.out[link.from].push(link);
            graph.into[link.to].push(link);
        }
        graph
    }

    /// Indices of boxes by column, from the right: a box lies left of everything that it feeds.
    /// Wires that close a ring are left out.
    fn columns(&self) -> Vec<Vec<usize>> {
        let count = self.boxes.len();
        let mut rank = vec![0usize; count];
        let mut waits: Vec<usize> = self.out.iter().map(Vec::len).collect();
        let mut is_done = vec![false; count];
        let mut ready: Vec<usize> = (0..count).filter(|&index| waits[index] == 0).collect();
        // In a ring no box is ever ready; the rightmost box that is left is then taken.
        let mut by_place: Vec<usize> = (0..count).collect();
        by_place.sort_by(|&a, &b| self.boxes[b].min[0].total_cmp(&self.boxes[a].min[0]));
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
            column.sort_by(|&a, &b| self.boxes[a].min[1].total_cmp(&self.boxes[b].min[1]));
        }
        columns
    }

    /// Sorts each column by the mean place of the boxes that its boxes are wired to.
    fn sort(&self, columns: &mut [Vec<usize>]) {
        let mut place = vec![0.0f32; self.boxes.len()];
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
    fn place(&self, columns: &[Vec<usize>]) -> Vec<[f32; 2]> {
        let mut places = vec![[0.0f32; 2]; self.boxes.len()];
        let mut right = 0.0;
        for column in columns {
            let width = column.iter().map(|&index| self.boxes[index].size[0]).fold(0.0, f32::max);
            let goals: Vec<f32> = column.iter().map(|&index| self.goal(index, &places)).collect();
            for (&index, y) in column.iter().zip(self.spread(column, &goals)) {
                places[index] = [right - width, y];
            }
            right -= width + COLUMN_GAP;
        }
        places
    }

    /// Top at which a box's wires would run level, on average.
    fn goal(&self, index: usize, places: &[[f32; 2]]) -> f32 {
        let links = &self.out[index];
        if links.is_empty() {
            return 0.0;
        }
        links.iter().map(|link| places[link.to][1] + link.to_y - link.from_y).sum::<f32>()
            / links.len() as f32
    }

    /// Tops of a column's boxes, in order and without overlap, as near to their goals as least
    /// squares allow; boxes that touch move together.
    fn spread(&self, column: &[usize], goals: &[f32]) -> Vec<f32> {
        // Blocks of boxes that touch: the goal of the block's first box, the number of boxes, and
        // the block's height.
        let mut blocks: Vec<(f32, usize, f32)> = Vec::new();
        for (&index, &goal) in column.iter().zip(goals) {
            let mut block = (goal, 1, self.boxes[index].size[1] + ROW_GAP);
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
                at += self.boxes[index].size[1] + ROW_GAP;
            }
        }
        tops
    }
}
