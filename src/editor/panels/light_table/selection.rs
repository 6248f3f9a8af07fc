//! Selected cells of the light table: a cursor, and a set that grows from an anchor.

use std::collections::HashSet;

use super::column::Column;
use super::sheet::Row;

/// Place of a cell, which stays the cell's when rows are sorted.
pub(super) type Place = (Row, Column);

/// Selected cells.
#[derive(Clone, Debug, Default)]
pub(super) struct CellSelection {
    /// Cell that the keyboard is at.
    cursor: Option<Place>,
    /// Cell that the selection grows from.
    anchor: Option<Place>,
    cells: HashSet<Place>,
}

/// Cells of the table as they are shown: rows from top to bottom, columns from left to right.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShownCells<'s> {
    pub(super) rows: &'s [Row],
    pub(super) columns: &'s [Column],
}

impl ShownCells<'_> {
    /// Row and column of a cell, counted from 0.
    fn indices(&self, (row, column): &Place) -> Option<[usize; 2]> {
        let row = self.rows.iter().position(|shown| shown == row)?;
        Some([row, self.columns.iter().position(|shown| shown == column)?])
    }

    fn place(&self, [row, column]: [usize; 2]) -> Option<Place> {
        Some((self.rows.get(row)?.clone(), *self.columns.get(column)?))
    }

    fn between(&self, a: &Place, b: &Place) -> HashSet<Place> {
        let (Some(a), Some(b)) = (self.indices(a), self.indices(b)) else { return HashSet::new() };
        let side = |index: usize| a[index].min(b[index])..=a[index].max(b[index]);
        let all = side(0).flat_map(|row| side(1).map(move |column| [row, column]));
        all.filter_map(|at| self.place(at)).collect()
    }
}

impl CellSelection {
    pub(super) fn cursor(&self) -> Option<&Place> {
        self.cursor.as_ref()
    }

    pub(super) fn has(&self, place: &Place) -> bool {
        self.cells.contains(place)
    }

    /// Number of selected cells.
    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    /// Selects one cell.
    pub(super) fn set(&mut self, place: Place) {
        self.cells = HashSet::from([place.clone()]);
        self.anchor = Some(place.clone());
        self.cursor = Some(place);
    }

    /// Selects the cells between the anchor and a cell, which the cursor goes to.
    pub(super) fn extend(&mut self, shown: ShownCells<'_>, place: Place) {
        match &self.anchor {
            Some(anchor) => {
                self.cells = shown.between(anchor, &place);
                self.cursor = Some(place);
            }
            None => self.set(place),
        }
    }

    /// Takes a cell in, or out.
    pub(super) fn toggle(&mut self, place: Place) {
        if !self.cells.remove(&place) {
            self.cells.insert(place.clone());
        }
        self.anchor = Some(place.clone());
        self.cursor = Some(place);
    }

    /// Selects the cursor's column, or all cells where that is selected already.
    pub(super) fn select_more(&mut self, shown: ShownCells<'_>) {
        let Some((_, column)) = self.cursor else { return };
        let of = |columns: &[Column]| -> HashSet<Place> {
            let rows = shown.rows.iter();
            rows.flat_map(|row| columns.iter().map(|column| (row.clone(), *column))).collect()
        };
        let whole = of(&[column]);
        self.cells = if whole.is_subset(&self.cells) { of(shown.columns) } else { whole };
    }

    /// Selects all cells of a column.
    pub(super) fn select_column(&mut self, shown: ShownCells<'_>, column: Column) {
        if let Some(first) = shown.rows.first() {
            self.set((first.clone(), column));
            self.cells = shown.rows.iter().map(|row| (row.clone(), column)).collect();
        }
    }

    /// Moves the cursor by rows and columns, at most to the edges; with `extends` the selection
    /// grows with it.
    pub(super) fn step(&mut self, shown: ShownCells<'_>, [down, right]: [isize; 2], extends: bool) {
        let Some(at) = self.cursor.as_ref().and_then(|cursor| shown.indices(cursor)) else {
            return;
        };
        let moved = |at: usize, by: isize, count: usize| {
            at.saturating_add_signed(by).min(count.saturating_sub(1))
        };
        let to = [moved(at[0], down, shown.rows.len()), moved(at[1], right, shown.columns.len())];
        let Some(place) = shown.place(to) else { return };
        if extends {
            self.extend(shown, place);
        } else {
            self.set(place);
        }
    }

    /// Forgets cells that are no longer shown.
    pub(super) fn keep(&mut self, shown: ShownCells<'_>) {
        let (rows, columns): (HashSet<&Row>, HashSet<Column>) =
            (shown.rows.iter().collect(), shown.columns.iter().copied().collect());
        let is_shown = |(row, column): &Place| rows.contains(row) && columns.contains(column);
        self.cells.retain(&is_shown);
        for place in [&mut self.cursor, &mut self.anchor] {
            if !place.as_ref().is_some_and(&is_shown) {
                *place = None;
            }
        }
    }

    /// Selected cells as lines of the smallest table around them; `None` for cells between.
    pub(super) fn lines(&self, shown: ShownCells<'_>) -> Vec<Vec<Option<Place>>> {
        let at: Vec<[usize; 2]> =
            self.cells.iter().filter_map(|place| shown.indices(place)).collect();
        let side = |index: usize| {
            let of = || at.iter().map(move |at| at[index]);
            Some(of().min()?..=of().max()?)
        };
        let (Some(rows), Some(columns)) = (side(0), side(1)) else { return Vec::new() };
        let cell = |at| shown.place(at).filter(|place| self.has(place));
        rows.map(|row| columns.clone().map(|column| cell([row, column])).collect()).collect()
    }

    /// Cells that a pasted table of this many lines and columns covers: each selected cell, with
    /// the table repeated over them; or, where one cell is selected, a table of that size from
    /// there on. Each with its line and column in what is pasted.
    pub(super) fn covered(
        &self,
        shown: ShownCells<'_>,
        [height, width]: [usize; 2],
    ) -> Vec<(Place, [usize; 2])> {
        let lines = self.lines(shown);
        if height == 0 || width == 0 {
            return Vec::new();
        }
        if self.len() == 1 {
            let begin = self.cells.iter().next().and_then(|place| shown.indices(place));
            let Some([row, column]) = begin else { return Vec::new() };
            let all = (0..height).flat_map(|y| (0..width).map(move |x| [y, x]));
            let place = |[y, x]: [usize; 2]| Some((shown.place([row + y, column + x])?, [y, x]));
            return all.filter_map(place).collect();
        }
        let lines = lines.into_iter().enumerate();
        lines
            .flat_map(|(y, line)| {
                let cells = line.into_iter().enumerate();
                cells.filter_map(move |(x, place)| Some((place?, [y % height, x % width])))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<Row> {
        ["a", "b", "c"].map(|id| Row::Light(id.into())).to_vec()
    }

    const COLUMNS: [Column; 3] = [Column::Name, Column::Kind, Column::Groups];

    #[test]
    fn selections_grow_and_are_pasted_over() {
        let rows = rows();
        let shown = ShownCells { rows: &rows, columns: &COLUMNS };
        let mut selection = CellSelection::default();
        selection.set((rows[0].clone(), Column::Name));
        assert_eq!(selection.covered(shown, [2, 2]).len(), 4, "from one cell on");
        selection.step(shown, [1, 1], true);
        assert_eq!((selection.len(), selection.lines(shown).len()), (4, 2));
        let pasted = selection.covered(shown, [1, 1]);
        assert!(pasted.len() == 4 && pasted.iter().all(|(_, from)| *from == [0, 0]));
        selection.toggle((rows[2].clone(), Column::Groups));
        assert_eq!(selection.covered(shown, [1, 1]).len(), 5, "and none between");
        assert_eq!(selection.lines(shown)[2], [None, None, Some((rows[2].clone(), COLUMNS[2]))]);
        selection.step(shown, [9, 9], false);
        assert_eq!(selection.cursor(), Some(&(rows[2].clone(), Column::Groups)));
        selection.select_more(shown);
        assert_eq!(selection.len(), 3);
        selection.select_more(shown);
        assert_eq!(selection.len(), 9);
        selection.keep(ShownCells { rows: &rows[..1], columns: &COLUMNS });
        assert_eq!((selection.len(), selection.cursor()), (3, None));
    }
}
