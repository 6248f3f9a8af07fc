//! Heights of stacks in low windows: a panel that is opened gets the height that it needs, from the
//! stacks of its column.

use egui_tiles::{Container, LinearDir, Tile, TileId};

use super::Dock;

/// Greatest part of a column that an opened panel takes from its neighbors.
const MOST_PART: f32 = 0.6;
/// Difference of heights that changes nothing, in points: gaps between stacks and rounding.
const TOLERANCE: f32 = 6.0;

impl Dock {
    /// Gives the stack of a panel the height that the panel needs, where it has less. True if
    /// heights changed.
    pub(super) fn raise(&mut self, pane: TileId) -> bool {
        let Some(panel) = self.tree.tiles.get_pane(&pane).map(|pane| pane.0) else { return false };
        let tiles = &self.tree.tiles;
        let column_of = |tile: TileId| {
            let parent = tiles.parent_of(tile)?;
            let Some(Tile::Container(Container::Linear(linear))) = tiles.get(parent) else {
                return None;
            };
            (linear.dir == LinearDir::Vertical).then_some((parent, tile))
        };
        let mut around = std::iter::successors(Some(pane), |tile| tiles.parent_of(*tile));
        let Some((column, stack)) = around.find_map(column_of) else { return false };
        let heights = [column, stack].map(|tile| tiles.rect(tile).map(|rect| rect.height()));
        let [Some(room), Some(height)] = heights else { return false };
        let wanted = panel.place.least_height.min(MOST_PART * room);
        if height + TOLERANCE > wanted {
            return false;
        }
        let tile = self.tree.tiles.get_mut(column);
        let Some(Tile::Container(Container::Linear(linear))) = tile else { return false };
        let others = linear.children.iter().filter(|child| **child != stack);
        let others: f32 = others.map(|child| linear.shares[*child]).sum();
        linear.shares.set_share(stack, share(wanted / room, others));
        others > 0.0
    }
}

/// Share of a stack that takes this part of a column beside stacks whose shares have this sum.
fn share(part: f32, others: f32) -> f32 {
    others * part / (1.0 - part)
}

#[cfg(test)]
mod tests {
    use super::share;

    #[test]
    fn a_stack_takes_its_part_of_the_column() {
        for (part, others) in [(0.5, 0.62), (0.25, 3.0), (0.6, 1.0)] {
            let own = share(part, others);
            assert!((own / (own + others) - part).abs() < 1e-6, "{part} beside {others}: {own}");
        }
    }
}
