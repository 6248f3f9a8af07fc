//! An HCBTF's texture says whether it is opaque: where no texel of any sample is transparent, in
//! each storage. One that is being painted says nothing, as the next stroke may be transparent.

use std::sync::Arc;

use chiaro::document::{Address, Directions, Grid, Storage, Tile};
use chiaro::hcbtf::{LayerOptions, from_layers, layers, stored};
use chiaro::progress::Progress;

#[test]
fn an_opaque_texture_says_so() {
    let directions = Directions { theta: 2, phi: 3 };
    let grid = Grid { size: [5, 3], light: directions, view: directions };
    let opaque = Arc::new(Tile::filled(grid.size, [9, 8, 7, 255]));
    let mut hole = Tile::clone(&opaque);
    hole.bytes_mut()[4 * 7 + 3] = 254;
    let hole = Arc::new(hole);
    let last = grid.addresses().last().expect("a sample");
    for storage in Storage::ALL {
        let options = LayerOptions { has_levels: true, is_decoded: false, storage };
        let cases = [(Some(&opaque), true), (Some(&hole), false), (None, false)];
        for (tile_of_last, is_opaque) in cases {
            let tile = |address: Address| {
                if address == last { tile_of_last } else { Some(&opaque) }
            };
            let made = stored(&grid, tile, options, &Progress::new()).expect("it fits");
            assert_eq!(made.is_opaque(), is_opaque, "{storage:?}, {tile_of_last:?}");
            let back = from_layers(&made).expect("it is read");
            assert_eq!(back.grid, grid, "{storage:?}");
        }
    }
    assert!(!layers(&grid, |_| Some(&opaque), LayerOptions::default()).is_opaque());
}
