use std::sync::Arc;

use super::super::{fill, sample};
use super::*;
use crate::document::{Directions, Hcbtf, Rule};

const SIDE: u32 = 32;

/// A white tile with black discs at these places, in texels.
fn marked(places: &[[f64; 2]], radius: f64) -> Tile {
    let bytes = (0..SIDE * SIDE).flat_map(|index| {
        let (x, y) = (f64::from(index % SIDE) + 0.5, f64::from(index / SIDE) + 0.5);
        let wrapped =
            |off: f64| (off.rem_euclid(f64::from(SIDE))).min((-off).rem_euclid(f64::from(SIDE)));
        let off = places.iter().map(|[u, v]| wrapped(x - u).hypot(wrapped(y - v)) - radius);
        let ink = (0.5 - off.fold(f64::INFINITY, f64::min)).clamp(0.0, 1.0);
        let gray = (255.0 * (1.0 - ink)).round() as u8;
        [gray, gray, gray, 255]
    });
    Tile::new([SIDE, SIDE], bytes.collect()).unwrap()
}

/// An HCBTF painted for the light along the normal and on the horizon, and the address half way
/// between.
fn between(first: Tile, last: Tile, is_tiling: bool, rule: Rule) -> (Hcbtf, Address) {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [SIDE, SIDE], light: Directions { theta: 3, phi: 1 }, view: one };
    let mut hcbtf = Hcbtf { is_tiling, rules: vec![rule], ..Hcbtf::new(grid) };
    hcbtf.painted.insert(Address::new([0, 0], [0, 0]), Arc::new(first));
    hcbtf.painted.insert(Address::new([2, 0], [0, 0]), Arc::new(last));
    (hcbtf, Address::new([1, 0], [0, 0]))
}

fn middle_of(first: Tile, last: Tile, is_tiling: bool) -> Arc<Tile> {
    let (hcbtf, at) = between(first, last, is_tiling, Rule::Morph { sharpness: 2.0 });
    sample(&hcbtf, at, &Progress::new()).unwrap().unwrap()
}

fn ink(tile: &Tile, [x, y]: [f64; 2]) -> f64 {
    1.0 - f64::from(tile.texel(x.floor() as i64, y.floor() as i64)[0]) / 255.0
}

#[test]
fn a_stroke_moves_and_does_not_fade() {
    let cases = [
        // Motions within the tile, across its edge, and by a small distance.
        ([10.5, 12.5], [18.5, 16.5], [14.5, 14.5]),
        ([4.5, 16.5], [26.5, 18.5], [31.5, 17.5]),
        ([10.5, 10.5], [12.5, 10.5], [11.5, 10.5]),
    ];
    for (a, b, half) in cases {
        let tile = middle_of(marked(&[a], 3.0), marked(&[b], 3.0), true);
        assert!(ink(&tile, half) > 0.9, "{a:?} to {b:?}: {}", ink(&tile, half));
        let far = |place: [f64; 2]| (place[0] - half[0]).hypot(place[1] - half[1]) > 4.5;
        for place in [a, b].into_iter().filter(|place| far(*place)) {
            assert!(ink(&tile, place) < 0.1, "{a:?} to {b:?}: {place:?} has {}", ink(&tile, place));
        }
        // The morph has as much ink as was painted.
        let all = |tile: &Tile| {
            tile.bytes().iter().step_by(4).map(|byte| 255.0 - f64::from(*byte)).sum::<f64>()
        };
        let (got, painted) = (all(&tile), all(&marked(&[a], 3.0)));
        assert!((got - painted).abs() < 0.25 * painted, "{a:?} to {b:?}: {got} of {painted}");
    }
    // A blend has two discs of half the strength.
    let (hcbtf, at) = between(
        marked(&[[10.5, 12.5]], 3.0),
        marked(&[[18.5, 16.5]], 3.0),
        true,
        Rule::Blend { sharpness: 2.0 },
    );
    let blended = sample(&hcbtf, at, &Progress::new()).unwrap().unwrap();
    assert!((ink(&blended, [10.5, 12.5]) - 0.5).abs() < 0.01 && ink(&blended, [14.5, 14.5]) < 0.3);
}

#[test]
fn strokes_move_each_their_own_way() {
    let first = marked(&[[8.5, 8.5], [23.5, 23.5]], 2.5);
    let last = marked(&[[12.5, 8.5], [23.5, 19.5]], 2.5);
    let tile = middle_of(first, last, true);
    for place in [[10.5, 8.5], [23.5, 21.5]] {
        assert!(ink(&tile, place) > 0.85, "{place:?}: {}", ink(&tile, place));
    }
}

#[test]
fn what_is_painted_stays_and_what_is_alike_nowhere_is_blended() {
    let (first, last) = (marked(&[[10.5, 12.5]], 3.0), marked(&[[18.5, 16.5]], 3.0));
    let (hcbtf, _) = between(first.clone(), last.clone(), true, Rule::Morph { sharpness: 2.0 });
    let filled = fill(&hcbtf, &Progress::new()).unwrap();
    assert_eq!(**filled.tile(Address::new([0, 0], [0, 0])).unwrap(), first);
    assert_eq!(**filled.tile(Address::new([2, 0], [0, 0])).unwrap(), last);
    // A mark that only one sample has fades.
    for is_tiling in [true, false] {
        let tile = middle_of(
            marked(&[[16.5, 16.5]], 4.0),
            Tile::filled([SIDE, SIDE], [255; 4]),
            is_tiling,
        );
        assert!((ink(&tile, [16.5, 16.5]) - 0.5).abs() < 0.06, "{}", ink(&tile, [16.5, 16.5]));
    }
    // The morph of two equal samples equals them, texel for texel.
    assert_eq!(*middle_of(first.clone(), first.clone(), true), first);
    let alone = {
        let (mut hcbtf, at) = between(first.clone(), last, false, Rule::Morph { sharpness: 2.0 });
        hcbtf.painted.remove(&Address::new([2, 0], [0, 0]));
        sample(&hcbtf, at, &Progress::new()).unwrap().unwrap()
    };
    assert_eq!(*alone, first);
}

#[test]
fn it_is_the_same_on_any_number_of_threads_and_can_be_stopped() {
    let (mut hcbtf, _) = between(
        marked(&[[10.5, 12.5]], 3.0),
        marked(&[[18.5, 16.5]], 3.0),
        true,
        Rule::Morph { sharpness: 2.0 },
    );
    hcbtf.grid.light = Directions { theta: 4, phi: 3 };
    hcbtf.painted.insert(Address::new([2, 1], [0, 0]), Arc::new(marked(&[[5.5, 20.5]], 3.0)));
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| fill(&hcbtf, &Progress::new()).unwrap())
    };
    assert_eq!(on(1), on(5));
    let progress = Progress::new();
    progress.stop();
    assert!(fill(&hcbtf, &progress).is_err());
    // A single texel is enough.
    let mut tiny = hcbtf.clone();
    tiny.grid.size = [1, 1];
    for tile in tiny.painted.values_mut() {
        *tile = Arc::new(Tile::filled([1, 1], [9, 9, 9, 255]));
    }
    let filled = fill(&tiny, &Progress::new()).unwrap();
    assert!(filled.tiles().iter().all(|tile| tile.texel(0, 0) == [9, 9, 9, 255]));
}
