//! A tile without a seam: copies beside it are painted on as the tile itself, strokes go across
//! edges and corners, and the saved tile repeats.

use chiaro::document::{Address, Tile};
use eframe::egui::{Key, Modifiers, Pos2, Role};

use super::artist::{JourneyUser, Studio};

const SIDE: i32 = 16;

fn texel(artist: &JourneyUser, x: f64, y: f64) -> Pos2 {
    artist.app().painting().screen([x, y]).unwrap()
}

fn tile(artist: &JourneyUser) -> Tile {
    let hcbtf = artist.app().session().painting().unwrap().hcbtf();
    hcbtf
        .painted(Address::default())
        .map_or_else(|| Tile::filled([16, 16], [0; 4]), |tile| (**tile).clone())
}

fn alphas(tile: &Tile, from: [i64; 2]) -> Vec<u8> {
    let all = (0..i64::from(SIDE)).flat_map(|y| (0..i64::from(SIDE)).map(move |x| [x, y]));
    all.map(|[x, y]| tile.texel(x + from[0], y + from[1])[3]).collect()
}

#[test]
fn a_tile_is_painted_without_a_seam() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.press("Paint");
    artist.press("New painted surface, small (16 x 16, 3 x 6 directions)");
    let size = artist.place_of(Role::SpinButton, "Size");
    artist.type_over(size, "5");
    let hardness = artist.place_of(Role::SpinButton, "Hardness");
    artist.type_over(hardness, "30");

    // A bow over the corner, across copies on all sides. The same bow in the middle makes the same
    // tile, moved by half.
    let bow = [[-4.0, 1.0], [0.5, -3.0], [5.0, 2.0]];
    let along = |artist: &JourneyUser, by: f64| -> Vec<Pos2> {
        bow.iter().map(|[x, y]| texel(artist, x + by, y + by)).collect()
    };
    let path = along(&artist, 0.0);
    artist.drag_through(&path);
    artist.settle();
    let over_the_corner = tile(&artist);
    artist.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(tile(&artist).bytes().iter().max(), Some(&0), "one step takes the whole bow back");
    let path = along(&artist, 8.0);
    artist.drag_through(&path);
    artist.settle();
    let inside = tile(&artist);
    let (moved, whole) = (alphas(&over_the_corner, [-8, -8]), alphas(&inside, [0, 0]));
    let apart = moved.iter().zip(&whole).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
    assert!(whole.iter().filter(|alpha| **alpha > 0).count() > 30);
    assert!(apart <= 2, "nothing is lost at an edge: {apart}");

    // A stripe that leaves the tile on the right and comes back on the left.
    let (from, to) = (texel(&artist, 10.0, 14.0), texel(&artist, 26.0, 14.0));
    artist.drag(from, to);
    artist.settle();
    let striped = tile(&artist);
    let row: Vec<u8> = (0..i64::from(SIDE)).map(|x| striped.texel(x, 14)[3]).collect();
    assert!(row.iter().all(|alpha| *alpha == 255), "once around: {row:?}");

    // Without tiling a stroke ends at the edge.
    artist.press_a(Role::CheckBox, "The tile repeats");
    let before = tile(&artist);
    let outside = texel(&artist, 20.0, 5.0);
    artist.drag(outside, outside + eframe::egui::vec2(2.0, 0.0));
    artist.settle();
    assert_eq!(tile(&artist), before);
    artist.key_with(Modifiers::COMMAND, Key::Z);
    artist.settle();

    // The saved tile repeats: the file says so, and four tiles side by side have no seam that a
    // tile does not have within.
    let path = studio.path("bow.hcbtf");
    artist.app_mut().answer_dialog(&path);
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    let saved = chiaro::hcbtf::load(&chiaro::files::Disk, &path).unwrap().value;
    assert!(
        saved.is_tiling && saved.painted(Address::default()).unwrap().bytes() == striped.bytes()
    );
    // Export for programs that tile pictures: the contact sheet's first tile is the painted one.
    let sheet = studio.path("bow.png");
    artist.app_mut().answer_dialog(&sheet);
    artist.press("Paint");
    artist.press("Export the painted surface as a contact sheet...");
    artist.settle();
    let sheet = image::open(&sheet).unwrap().into_rgba8();
    let first = image::imageops::crop_imm(&sheet, 0, 0, 16, 16).to_image();
    assert_eq!(first.as_raw(), striped.bytes(), "{:?}", artist.app().message());
    artist.choose("On", "Sphere");
    studio.finish(artist, "bow.json");
}
