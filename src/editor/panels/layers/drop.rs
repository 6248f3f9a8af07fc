//! Place where dragged rows would lie.

use std::collections::HashSet;

use crate::ids::NodeId;
use crate::state::stack::tree::{LayerPlace, LayerTree, TreeRow};

/// Place under the pointer, and where a mark of it is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct DropTarget {
    pub(super) place: LayerPlace,
    /// Row that the place lies over, or that it lies in.
    pub(super) line: usize,
    /// Number of folders around the place.
    pub(super) depth: usize,
    /// True for the place in a closed folder.
    pub(super) is_within: bool,
}

impl DropTarget {
    /// The place at a height, counted in rows from the top of the list: over a row in its upper
    /// half, after it in its lower half. After an open folder is in it; the middle of a closed one
    /// is in it too.
    pub(super) fn at(
        height: f32,
        rows: &[TreeRow],
        closed: &HashSet<NodeId>,
        tree: &LayerTree,
    ) -> Self {
        let index = height.floor().max(0.0) as usize;
        let part = height - index as f32;
        let Some(row) = rows.get(index) else {
            let at = tree.own().layers.len();
            let place = LayerPlace { folder: None, at };
            return Self { place, line: rows.len(), depth: 0, is_within: false };
        };
        let LayerPlace { folder, at } = row.place.clone();
        let is_closed = closed.contains(&row.id);
        let is_in = match (row.is_folder, is_closed) {
            (false, _) => false,
            (true, false) => part >= 0.5,
            (true, true) => (0.3..0.7).contains(&part),
        };
        if is_in {
            let place = LayerPlace { folder: Some(row.id.clone()), at: 0 };
            let line = if is_closed { index } else { index + 1 };
            return Self { place, line, depth: row.depth + 1, is_within: is_closed };
        }
        let is_after = usize::from(part >= 0.5);
        let place = LayerPlace { folder, at: at + is_after };
        Self { place, line: index + is_after, depth: row.depth, is_within: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(id: &str, folder: Option<&str>, at: usize, depth: usize) -> TreeRow {
        let place = LayerPlace { folder: folder.map(NodeId::from), at };
        TreeRow { id: id.into(), place, depth, is_folder: id.starts_with("folder") }
    }

    #[test]
    fn a_place_is_over_after_or_in_the_row_under_the_pointer() {
        let rows =
            [row("folder", None, 0, 0), row("a", Some("folder"), 0, 1), row("b", None, 1, 0)];
        let tree = LayerTree::default();
        let at = |height, closed: &HashSet<NodeId>, rows: &[TreeRow]| {
            let found = DropTarget::at(height, rows, closed, &tree);
            (found.place.folder.map(|id| id.to_string()), found.place.at, found.line)
        };
        let folder = || Some("folder".to_owned());
        let open = HashSet::new();
        assert_eq!(at(0.2, &open, &rows), (None, 0, 0));
        assert_eq!(at(0.8, &open, &rows), (folder(), 0, 1));
        assert_eq!(at(1.2, &open, &rows), (folder(), 0, 1));
        assert_eq!(at(1.8, &open, &rows), (folder(), 1, 2), "the end of the folder");
        assert_eq!(at(2.2, &open, &rows), (None, 1, 2), "under the folder");
        assert_eq!(at(9.0, &open, &rows), (None, 0, 3));
        let closed = HashSet::from(["folder".into()]);
        let rows = [rows[0].clone(), rows[2].clone()];
        assert_eq!(at(0.5, &closed, &rows), (folder(), 0, 0));
        assert_eq!(at(0.8, &closed, &rows), (None, 1, 1));
    }
}
