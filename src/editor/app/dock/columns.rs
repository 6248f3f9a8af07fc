//! Columns of a narrow window: panels of fields keep the width that their rows need, and the wide
//! columns beside them give way.

use egui_tiles::{Container, LinearDir, Shares, Tile, TileId};

use super::Dock;

/// Width of a window, in points, below which narrow columns keep the width that they have at it.
const NARROW: f32 = 1000.0;
/// Width of a column that always gives way to narrower ones, in points.
const PLENTY: f32 = 220.0;

/// Shares of the window's columns, before those of narrow ones were raised for a frame.
pub(super) struct OwnShares {
    columns: TileId,
    shares: Shares,
}

impl Dock {
    /// Raises the shares of narrow columns while the window is narrow; the layout that is saved
    /// keeps its own.
    pub(super) fn widen_columns(&mut self, room: f32) -> Option<OwnShares> {
        let columns = self.tree.root.filter(|_| room < NARROW)?;
        let Some(Tile::Container(Container::Linear(linear))) = self.tree.tiles.get_mut(columns)
        else {
            return None;
        };
        if linear.dir != LinearDir::Horizontal {
            return None;
        }
        let before = linear.shares.clone();
        let own: Vec<f32> = linear.children.iter().map(|child| before[*child]).collect();
        let all: f32 = own.iter().sum();
        for (child, width) in linear.children.iter().zip(widths(&own, room)) {
            linear.shares.set_share(*child, all * width / room);
        }
        Some(OwnShares { columns, shares: before })
    }

    /// Gives columns their own shares back.
    pub(super) fn restore_columns(&mut self, own: &OwnShares) {
        let tile = self.tree.tiles.get_mut(own.columns);
        if let Some(Tile::Container(Container::Linear(linear))) = tile {
            own.shares.iter().for_each(|(child, share)| linear.shares.set_share(*child, *share));
        }
    }
}

/// Widths of columns in a narrow window, in points.
fn widths(shares: &[f32], room: f32) -> Vec<f32> {
    let all = shares.iter().sum::<f32>().max(f32::MIN_POSITIVE);
    let least = |share: &f32| (share / all * NARROW).min(PLENTY);
    let least: Vec<f32> = shares.iter().map(least).collect();
    let wanted = |(share, least): (&f32, &f32)| (share / all * room).max(*least);
    let wanted: Vec<f32> = shares.iter().zip(&least).map(wanted).collect();
    let [sum, at_least] = [&wanted, &least].map(|widths| widths.iter().sum::<f32>());
    if at_least >= room {
        return least.iter().map(|width| width * room / at_least).collect();
    }
    // Columns without a share have no width to give.
    let part = if sum > at_least { (room - at_least) / (sum - at_least) } else { 0.0 };
    least.iter().zip(&wanted).map(|(least, wanted)| least + (wanted - least) * part).collect()
}

#[cfg(test)]
mod tests {
    use super::widths;

    #[test]
    fn fields_keep_their_width_in_a_narrow_window() {
        let shares = [0.33, 0.45, 0.22];
        let found = widths(&shares, 800.0);
        assert!((found.iter().sum::<f32>() - 800.0).abs() < 1e-3, "{found:?}");
        assert!((found[2] - 220.0).abs() < 1e-3 && found[1] > found[0] && found[0] > 240.0);
        // What a hand made narrow stays so.
        let found = widths(&[0.1, 0.9], 800.0);
        assert!((found[0] - 100.0).abs() < 1e-3, "{found:?}");
        // Without room for anything all shrink alike.
        assert!(widths(&shares, 330.0).iter().all(|width| (width - 110.0).abs() < 1e-3));
        assert!(widths(&[0.0, 0.0], 500.0).iter().all(|width| width.is_finite()));
    }
}
