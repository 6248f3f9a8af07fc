//! Painting, compared with closed formulas where there are some, and with invariants otherwise.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::DVec2;
use proptest::prelude::*;

use super::path::Path;
use super::*;

const CLEAR: [u8; 4] = [0; 4];

fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn stroke(
    tile: &Tile,
    brush: &Brush,
    symmetry: Symmetry,
    wraps: bool,
    points: &[(DVec2, f64)],
) -> Tile {
    let mut stroke = Stroke::begin(tile, brush, &symmetry, wraps);
    for &(at, pressure) in points {
        stroke.to(at, pressure);
    }
    stroke.finish()
}

fn dot(tile: &Tile, brush: &Brush, place: DVec2) -> Tile {
    stroke(tile, brush, Symmetry::default(), false, &[(place, 1.0)])
}

fn texels(tile: &Tile) -> &[[u8; 4]] {
    tile.bytes().as_chunks().0
}

/// A tile of many colors, some of them clear.
fn motley(size: [u32; 2], seed: u32) -> Tile {
    let mut state = seed | 1;
    let mut next = move || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 24) as u8
    };
    let count = 4 * size[0] as usize * size[1] as usize;
    Tile::new(size, (0..count).map(|_| next()).collect()).unwrap()
}

#[test]
fn a_hard_stamp_covers_its_disc() {
    for size in [3.0, 8.0, 20.5, 64.0] {
        let brush = Brush { size, ..Brush::default() };
        let tile = dot(&Tile::filled([96, 96], CLEAR), &brush, at(48.25, 47.5));
        let area: f64 = texels(&tile).iter().map(|texel| f64::from(texel[3]) / 255.0).sum();
        // The edge falls linearly over a texel, half of it outside.
        let expected = PI * (size * size / 4.0 + 1.0 / 12.0);
        assert!((area / expected - 1.0).abs() < 0.02, "size {size}: {area} for {expected}");
    }
}

#[test]
fn a_soft_stamp_covers_what_its_profile_says() {
    let brush = Brush { size: 80.0, hardness: 0.0, ..Brush::default() };
    let tile = dot(&Tile::filled([96, 96], CLEAR), &brush, at(48.0, 48.0));
    let area: f64 = texels(&tile).iter().map(|texel| f64::from(texel[3]) / 255.0).sum();
    // The integral of 2 pi r s(1 - r / 40) with s(t) = t t (3 - 2 t).
    let expected = 2.0 * PI * 1600.0 * 3.0 / 20.0;
    assert!((area / expected - 1.0).abs() < 0.005, "{area} for {expected}");
    assert_eq!(tile.texel(48, 48)[3], 255);
}

#[test]
fn a_hard_brush_of_one_texel_is_the_texel_under_the_pointer() {
    let brush = Brush { size: 1.0, color: [9, 8, 7, 255], ..Brush::default() };
    for (x, y) in [(3.0, 4.0), (3.01, 4.99), (3.99, 4.01), (3.5, 4.5)] {
        let tile = dot(&Tile::filled([8, 8], CLEAR), &brush, at(x, y));
        for (index, texel) in texels(&tile).iter().enumerate() {
            assert_eq!(*texel, if index == 4 * 8 + 3 { [9, 8, 7, 255] } else { CLEAR }, "{x} {y}");
        }
    }
    // A line along a row is that row, without a gap.
    let tile = line(
        &Tile::filled([8, 8], CLEAR),
        &brush,
        &Symmetry::default(),
        false,
        at(0.5, 2.5),
        at(7.5, 2.5),
    );
    let painted: Vec<usize> = (0..64).filter(|index| texels(&tile)[*index][3] > 0).collect();
    assert_eq!(painted, (16..24).collect::<Vec<_>>());
}

#[test]
fn flow_adds_up_to_the_opacity_and_no_further() {
    let base = Tile::filled([128, 128], CLEAR);
    let brush = Brush { size: 64.0, spacing: 0.25, flow: 0.3, opacity: 0.8, ..Brush::default() };
    let tile = line(&base, &brush, &Symmetry::default(), false, at(0.0, 64.5), at(64.0, 64.5));
    // Stamps at 16, 32, 48 and 64 cover the texel wholly, that at 0 not at all.
    let expected = (255.0 * 0.8 * (1.0 - 0.7_f64.powi(4))).round() as u8;
    assert_eq!(tile.texel(32, 64)[3], expected);

    let there_and_back: Vec<_> =
        (0..60).map(|turn| (at(if turn % 2 == 0 { 30.0 } else { 90.0 }, 64.5), 1.0)).collect();
    let tile = stroke(&base, &brush, Symmetry::default(), false, &there_and_back);
    assert_eq!(tile.texel(60, 64)[3], 204);
    assert!(texels(&tile).iter().all(|texel| texel[3] <= 204));
    // Another stroke covers more.
    let tile = stroke(&tile, &brush, Symmetry::default(), false, &there_and_back);
    assert_eq!(tile.texel(60, 64)[3], 245);
}

#[test]
fn pressure_drives_what_it_is_told_to() {
    let base = Tile::filled([64, 64], CLEAR);
    let with = |pressure| Brush { size: 40.0, pressure, ..Brush::default() };
    let half =
        |brush: Brush| stroke(&base, &brush, Symmetry::default(), false, &[(at(32.0, 32.0), 0.5)]);
    assert_eq!(
        half(with(Pressure::Size)),
        dot(&base, &Brush { size: 20.0, ..Brush::default() }, at(32.0, 32.0))
    );
    let faint = Brush { size: 40.0, opacity: 0.5, ..Brush::default() };
    assert_eq!(half(with(Pressure::Opacity)), dot(&base, &faint, at(32.0, 32.0)));
    assert_eq!(
        half(with(Pressure::Both)),
        dot(&base, &Brush { size: 20.0, ..faint }, at(32.0, 32.0))
    );
    assert_eq!(half(with(Pressure::None)), dot(&base, &with(Pressure::None), at(32.0, 32.0)));
}

#[test]
fn a_soft_edge_over_nothing_is_not_darkened() {
    let brush = Brush {
        size: 30.0,
        hardness: 0.1,
        color: [250, 200, 20, 255],
        flow: 0.4,
        ..Brush::default()
    };
    let tile = line(
        &Tile::filled([64, 64], CLEAR),
        &brush,
        &Symmetry::default(),
        true,
        at(3.0, 4.0),
        at(50.0, 70.0),
    );
    let seen: Vec<_> = texels(&tile).iter().filter(|texel| texel[3] > 0).collect();
    assert!(seen.len() > 500 && seen.iter().all(|texel| texel[..3] == [250, 200, 20]));
    // Over the same color the color stays.
    let base = Tile::filled([64, 64], [250, 200, 20, 90]);
    let tile = line(&base, &brush, &Symmetry::default(), true, at(3.0, 4.0), at(50.0, 70.0));
    assert!(texels(&tile).iter().all(|texel| texel[..3] == [250, 200, 20] && texel[3] >= 90));
}

#[test]
fn the_eraser_takes_alpha_and_leaves_color() {
    let brush = Brush { tool: Tool::Erase, size: 20.0, opacity: 0.75, ..Brush::default() };
    let tile = dot(&Tile::filled([32, 32], [1, 2, 3, 200]), &brush, at(16.0, 16.0));
    assert_eq!((tile.texel(16, 16), tile.texel(0, 0)), ([1, 2, 3, 50], [1, 2, 3, 200]));
}

#[test]
fn a_stamp_of_its_own_size_copies_texel_by_texel() {
    let picture = motley([6, 4], 5);
    let brush =
        Brush { tool: Tool::Stamp(Arc::new(picture.clone())), size: 6.0, ..Brush::default() };
    let base = Tile::filled([16, 16], CLEAR);
    let tile = dot(&base, &brush, at(8.3, 8.4));
    for (x, y) in (0..16).flat_map(|x| (0..16).map(move |y| (x, y))) {
        let is_in = (5..11).contains(&x) && (6..10).contains(&y);
        let expected = if is_in { picture.texel(x - 5, y - 6) } else { CLEAR };
        let expected = if expected[3] == 0 { CLEAR } else { expected };
        assert_eq!(tile.texel(x, y), expected, "{x} {y}");
    }
    // The stroke with a mirror is its own mirror image.
    let mirrored = Symmetry { across_u: true, ..Symmetry::default() };
    let both = stroke(&base, &brush, mirrored, false, &[(at(4.0, 8.0), 1.0)]);
    assert!((0..16).all(|x| (0..16).all(|y| both.texel(x, y) == both.texel(15 - x, y))));
    // A smaller picture has the same mean.
    let checks = Tile::new(
        [8, 8],
        (0..64)
            .flat_map(|i| if (i + i / 8) % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] })
            .collect(),
    );
    let brush =
        Brush { tool: Tool::Stamp(Arc::new(checks.unwrap())), size: 2.0, ..Brush::default() };
    assert_eq!(dot(&base, &brush, at(8.0, 8.0)).texel(8, 8), [128, 128, 128, 255]);
}

#[test]
fn smudging_carries_color_along() {
    let halves = |x: usize| if x < 32 { [200, 0, 0, 255] } else { [0, 0, 200, 255] };
    let base =
        Tile::new([64, 16], (0..64 * 16).flat_map(|index| halves(index % 64)).collect()).unwrap();
    let smudged = |flow| {
        let brush = Brush { tool: Tool::Smudge, size: 8.0, flow, ..Brush::default() };
        line(&base, &brush, &Symmetry::default(), false, at(20.0, 8.0), at(50.0, 8.0))
    };
    // Texels are the redder the longer the color is carried, and the less the farther away.
    let reds = [0.0, 0.2, 0.5, 0.8, 1.0]
        .map(|flow| (32..64).map(|x| u32::from(smudged(flow).texel(x, 8)[0])).sum::<u32>());
    assert!(reds[0] == 0 && reds.is_sorted_by(|a, b| a < b), "{reds:?}");
    let tile = smudged(0.5);
    let red = |x: i64| tile.texel(x, 8)[0];
    assert!(
        red(33) > 100 && (33..60).all(|x| red(x) >= red(x + 1)),
        "{:?}",
        (33..60).map(red).collect::<Vec<_>>()
    );
    assert_eq!(
        (tile.texel(20, 8), tile.texel(60, 8), tile.texel(40, 1)),
        (halves(0), halves(63), halves(63))
    );
    // At full flow the color is that which lay under the brush in the beginning.
    assert_eq!(smudged(1.0).texel(49, 8), halves(0));
    let brush = Brush { tool: Tool::Smudge, size: 8.0, flow: 0.8, ..Brush::default() };
    // A flat color stays as it is, whatever its alpha.
    let flat = Tile::filled([40, 40], [13, 77, 201, 3]);
    assert_eq!(line(&flat, &brush, &Symmetry::default(), true, at(0.0, 0.0), at(50.0, 31.0)), flat);
}

#[test]
fn bad_numbers_do_nothing() {
    let base = motley([8, 8], 3);
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1.0, 0.0] {
        let brush = Brush { size: bad, ..Brush::default() };
        assert_eq!(dot(&base, &brush, at(4.0, 4.0)), base);
        let path = [(at(bad * 1e7, 4.0), 1.0), (at(4.0, f64::NAN), 1.0), (at(4.0, 4.0), f64::NAN)];
        assert_eq!(stroke(&base, &Brush::default(), Symmetry::default(), false, &path[1..]), base);
        let brush =
            Brush { opacity: bad, hardness: bad, flow: bad, spacing: bad, ..Brush::default() };
        let tile = stroke(&base, &brush, Symmetry::default(), true, &path);
        assert!(tile == base || bad > 1.0 && bad.is_finite());
        assert_eq!(fill(&base, [9, 0], [1; 4], hard(0.0, true)), base);
        assert_eq!(fill(&base, [0, 0], [1; 4], hard(f64::NAN, true)), base);
    }
    let tall = Tool::Stamp(Arc::new(Tile::filled([1, 4000], [1; 4])));
    assert_eq!(
        dot(&base, &Brush { tool: tall, size: 8000.0, ..Brush::default() }, at(0.0, 0.0)),
        base
    );
    let many = Symmetry { across_u: true, across_v: true, turns: u32::MAX };
    let huge = Brush { size: 8192.0, ..Brush::default() };
    assert_eq!(stroke(&base, &huge, many, true, &[(at(0.0, 0.0), 1.0)]), base);
}

#[test]
fn a_long_way_has_no_more_stamps_than_it_may() {
    let (mut path, mut count) = (Path::default(), 0);
    for x in [-1e6, 1e6, 3e6] {
        path.to(at(x, 0.0), 1.0, 1000.0, |_| 0.25, |_, _| count += 1);
    }
    assert!((1000..=1002).contains(&count), "{count}");
}

#[test]
fn a_picked_color_is_the_texel() {
    let tile = motley([5, 3], 9);
    assert_eq!(pick(&tile, [3, 1]), tile.texel(3, 1));
    assert_eq!(pick(&tile, [99, u32::MAX]), tile.texel(4, 2));
}

/// A flood that stops where the tolerance does.
fn hard(tolerance: f64, wraps: bool) -> Flood {
    Flood { tolerance, edge: 0, wraps }
}

fn soft() -> Flood {
    Flood { tolerance: 0.1, edge: Flood::EDGE, wraps: true }
}

/// A round stroke of a color with a soft edge.
fn soft_disc(base: &Tile, color: [u8; 4]) -> Tile {
    dot(base, &Brush { size: 20.0, hardness: 0.7, color, ..Brush::default() }, at(16.3, 15.6))
}

/// The largest difference of any channel, as seen over black and over white.
fn apart(a: &Tile, b: &Tile) -> i32 {
    let over = |ground: i32, [r, g, b, a]: [u8; 4]| {
        [r, g, b].map(|channel| {
            (i32::from(channel) * i32::from(a) + ground * (255 - i32::from(a))) / 255
        })
    };
    let pairs = texels(a).iter().zip(texels(b));
    let of = |(a, b): (&[u8; 4], &[u8; 4])| {
        let at = |ground| {
            over(ground, *a).into_iter().zip(over(ground, *b)).map(|(a, b)| (a - b).abs()).max()
        };
        at(0).max(at(255)).unwrap_or(0)
    };
    pairs.map(of).max().unwrap_or(0)
}

#[test]
fn a_flood_leaves_no_ring_around_a_soft_disc() {
    let (white, red, blue) = ([255, 255, 255, 255], [220, 30, 20, 255], [20, 60, 200, 255]);
    // Texels within the tolerance take the color whole: twice as much where the ground is seen
    // half, and more where the ground is nearer to the disc than the color is.
    let grounds = [white, [10, 90, 40, 255], CLEAR, [255, 255, 255, 128]];
    for (ground, (tolerance, most)) in
        grounds.into_iter().flat_map(|ground| [(0.02, 14), (0.1, 48)].map(|of| (ground, of)))
    {
        let soft = || Flood { tolerance, ..soft() };
        let base = Tile::filled([32, 32], ground);
        let disc = soft_disc(&base, blue);
        // The ground is filled: as if the disc had been painted on the new ground.
        let told = soft_disc(&Tile::filled([32, 32], red), blue);
        let filled = fill(&disc, [0, 0], red, soft());
        assert!(apart(&filled, &told) <= most, "{ground:?}: {}", apart(&filled, &told));
        let ringed = fill(&disc, [0, 0], red, hard(tolerance, true));
        assert!(apart(&ringed, &told) > 72, "{ground:?}: without the rim there is a ring");
        // The disc is filled: as if it had been painted in the new color.
        let told = soft_disc(&base, red);
        let filled = fill(&disc, [16, 16], red, soft());
        assert!(apart(&filled, &told) <= most, "{ground:?}: {}", apart(&filled, &told));
    }
}

#[test]
fn a_flood_goes_on_under_the_seam_and_stops_at_hard_edges_and_other_colors() {
    let (white, black, red) = ([255; 4], [0, 0, 0, 255], [220, 30, 20, 255]);
    // A soft disc over the corner, whose parts are edges of one another.
    let base = Tile::filled([32, 32], white);
    let over_seam = |color| {
        let brush = Brush { size: 20.0, hardness: 0.7, color, ..Brush::default() };
        stroke(&base, &brush, Symmetry::default(), true, &[(at(0.4, 31.2), 1.0)])
    };
    let filled = fill(&over_seam(black), [0, 0], red, soft());
    assert!(apart(&filled, &over_seam(red)) <= 26);
    // Beside hard edges only the filled texels change.
    let halves = |left: [u8; 4]| {
        let texels = (0..16 * 8).flat_map(|index| if index % 16 < 8 { left } else { black });
        Tile::new([16, 8], texels.collect()).unwrap()
    };
    assert_eq!(fill(&halves(white), [2, 2], red, Flood { wraps: false, ..soft() }), halves(red));
    // A line as thin as a texel keeps its color, and so do the texels behind it.
    let mut lined = halves(white);
    (0..8).for_each(|y| {
        lined.bytes_mut()[4 * (y * 16 + 4)..][..4].copy_from_slice(&[90, 90, 90, 255]);
    });
    let filled = fill(&lined, [1, 1], red, Flood { wraps: false, ..soft() });
    assert_eq!([3, 4, 5].map(|x| filled.texel(x, 3)), [red, [90, 90, 90, 255], white]);
}

/// The texels that a flood reaches, one step after the other until no new one comes.
fn naive_fill(tile: &Tile, from: [u32; 2], color: [u8; 4], tolerance: f64, wraps: bool) -> Tile {
    let [width, height] = tile.size().map(i64::from);
    let first = pick(tile, from);
    let is_like = |x: i64, y: i64| {
        let texel = tile.texel(x, y);
        let near =
            (0..4).all(|i| (f64::from(texel[i]) - f64::from(first[i])).abs() <= tolerance * 255.0);
        near || texel[3] == 0 && first[3] == 0
    };
    let mut reached = vec![false; (width * height) as usize];
    reached[(i64::from(from[1]) * width + i64::from(from[0])) as usize] = true;
    loop {
        let before = reached.clone();
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let is_reached = |(i, j): (i64, i64)| {
                let (x, y) = (x + i, y + j);
                let is_in = (0..width).contains(&x) && (0..height).contains(&y);
                (wraps || is_in)
                    && before[(y.rem_euclid(height) * width + x.rem_euclid(width)) as usize]
            };
            if is_like(x, y) && [(1, 0), (-1, 0), (0, 1), (0, -1)].into_iter().any(is_reached) {
                reached[(y * width + x) as usize] = true;
            }
        }
        if before == reached {
            break;
        }
    }
    let texels = texels(tile)
        .iter()
        .zip(reached)
        .flat_map(|(texel, is_reached)| if is_reached { color } else { *texel });
    Tile::new(tile.size(), texels.collect()).unwrap()
}

fn tools() -> impl Strategy<Value = Tool> {
    prop_oneof![
        Just(Tool::Paint),
        Just(Tool::Erase),
        Just(Tool::Smudge),
        any::<u32>().prop_map(|seed| Tool::Stamp(Arc::new(motley([7, 5], seed)))),
    ]
}

fn brushes(size: impl Strategy<Value = f64>) -> impl Strategy<Value = Brush> {
    let pressure = prop_oneof![
        Just(Pressure::None),
        Just(Pressure::Size),
        Just(Pressure::Opacity),
        Just(Pressure::Both)
    ];
    (tools(), size, 0.0..=1.0, 0.1..=1.0, 0.05..=1.0, 0.05..0.6, any::<[u8; 4]>(), pressure)
        .prop_map(|(tool, size, hardness, opacity, flow, spacing, color, pressure)| Brush {
            tool,
            size,
            hardness,
            opacity,
            flow,
            spacing,
            color,
            pressure,
        })
}

fn points(reach: std::ops::Range<f64>) -> impl Strategy<Value = Vec<(DVec2, f64)>> {
    let point = (reach.clone(), reach, 0.0..=1.0).prop_map(|(x, y, pressure)| (at(x, y), pressure));
    prop::collection::vec(point, 1..5)
}

/// Any number, often one that is not finite or far out.
fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![6 => -40.0..60.0, 1 => any::<f64>(), 1 => Just(f64::NAN), 1 => -3000.0..3000.0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn how_a_path_is_chopped_does_not_matter(
        brush in brushes(1.0..20.0),
        points in points(-20.0..50.0),
        cuts in prop::collection::vec((0.0..1.0, 0.0..1.0), 4),
        wraps: bool,
        turns in 1..4_u32,
    ) {
        let base = motley([33, 21], 7);
        let symmetry = Symmetry { across_u: turns == 2, across_v: false, turns };
        let mut chopped = vec![points[0]];
        for (pair, (a, b)) in points.windows(2).zip(cuts) {
            for part in [f64::min(a, b), f64::max(a, b), 1.0] {
                let pressure = pair[0].1 + (pair[1].1 - pair[0].1) * part;
                chopped.push((pair[0].0.lerp(pair[1].0, part), pressure));
            }
        }
        let [whole, chopped] =
            [points, chopped].map(|points| stroke(&base, &brush, symmetry, wraps, &points));
        prop_assert_eq!(whole.bytes(), chopped.bytes());
    }

    /// A stroke across the seam equals a stroke on a plane of copies, folded: so short that it
    /// meets no texel twice.
    #[test]
    fn wrapping_is_painting_on_a_plane_of_copies(
        brush in brushes(1.0..12.0),
        start in (0.0..40.0, 0.0..40.0),
        way in (-9.0..9.0, -9.0..9.0),
    ) {
        let base = motley([40, 40], 11);
        let plane = (0..120 * 120).flat_map(|index| base.texel(index % 120, index / 120)).collect();
        let plane = Tile::new([120, 120], plane).unwrap();
        let from = at(start.0, start.1);
        let path = [(from, 0.7), (from + at(way.0, way.1), 1.0)];
        let wrapped = stroke(&base, &brush, Symmetry::default(), true, &path);
        let path = path.map(|(at, pressure)| (at + 40.0, pressure));
        let flat = stroke(&plane, &brush, Symmetry::default(), false, &path);
        for (x, y) in (0..40).flat_map(|x| (0..40).map(move |y| (x, y))) {
            let mut copies =
                (0..9).map(|copy| flat.texel(x + 40 * (copy % 3), y + 40 * (copy / 3)));
            let folded =
                copies.find(|texel| *texel != base.texel(x, y)).unwrap_or(base.texel(x, y));
            prop_assert_eq!(wrapped.texel(x, y), folded, "{} {}", x, y);
        }
    }

    #[test]
    fn symmetric_strokes_are_symmetric_to_the_byte(
        brush in brushes(1.0..20.0),
        points in points(-5.0..45.0),
        wraps: bool,
        erases: bool,
        kind in 0..4,
    ) {
        let brush = Brush { tool: if erases { Tool::Erase } else { Tool::Paint }, ..brush };
        let base = Tile::filled([40, 40], [90, 20, 30, 120]);
        let symmetry = match kind {
            0 => Symmetry { across_u: true, ..Symmetry::default() },
            1 => Symmetry { across_v: true, ..Symmetry::default() },
            2 => Symmetry { turns: 4, ..Symmetry::default() },
            _ => Symmetry { across_u: true, across_v: true, turns: 2 },
        };
        let tile = stroke(&base, &brush, symmetry, wraps, &points);
        for (x, y) in (0..40).flat_map(|x| (0..40).map(move |y| (x, y))) {
            let copy = match kind {
                0 => tile.texel(39 - x, y),
                1 => tile.texel(x, 39 - y),
                2 => tile.texel(39 - y, x),
                _ => tile.texel(39 - x, 39 - y),
            };
            prop_assert_eq!(tile.texel(x, y), copy);
        }
    }

    #[test]
    fn nothing_changes_outside_what_is_told(
        brush in brushes(prop_oneof![4 => 0.01..90.0, 1 => -9.0..200.0, 1 => Just(f64::INFINITY)]),
        points in prop::collection::vec(
            (wild(), wild(), prop_oneof![4 => 0.0..=1.0, 1 => wild()]), 1..5
        ),
        size in (1..70_u32, 1..70_u32),
        wraps: bool,
        flips: (bool, bool),
        turns in prop_oneof![Just(0_u32), Just(1), Just(3), Just(5)],
    ) {
        let base = motley(size.into(), 5);
        let symmetry = Symmetry { across_u: flips.0, across_v: flips.1, turns };
        let mut stroke = Stroke::begin(&base, &brush, &symmetry, wraps);
        let mut told = base.clone();
        for (x, y, pressure) in points {
            for [x, y, width, height] in stroke.to(at(x, y), pressure) {
                prop_assert!(
                    width > 0 && height > 0 && x + width <= size.0 && y + height <= size.1
                );
                for row in y..y + height {
                    let start = 4 * (row * size.0 + x) as usize;
                    let range = start..start + 4 * width as usize;
                    told.bytes_mut()[range.clone()].copy_from_slice(&stroke.tile().bytes()[range]);
                }
            }
            prop_assert!(told.bytes() == stroke.tile().bytes());
        }
        prop_assert!(stroke.finish() == told);
    }

    #[test]
    fn a_flood_is_what_hangs_together(
        size in (1..12_u32, 1..12_u32),
        bits in prop::collection::vec(0..4_u8, 144),
        place: (prop::sample::Index, prop::sample::Index),
        tolerance in prop_oneof![Just(0.0), Just(0.1), Just(1.0)],
        wraps: bool,
    ) {
        let colors = [[0, 0, 0, 255], [20, 20, 20, 255], [200, 20, 20, 0], [0, 0, 0, 0]];
        let texels = bits
            .iter()
            .flat_map(|bit| colors[usize::from(*bit)])
            .take(4 * (size.0 * size.1) as usize);
        let tile = Tile::new(size.into(), texels.collect()).unwrap();
        let place = [place.0.index(size.0 as usize) as u32, place.1.index(size.1 as usize) as u32];
        let color = [7, 7, 7, 9];
        let filled = fill(&tile, place, color, hard(tolerance, wraps));
        let naive = naive_fill(&tile, place, color, tolerance, wraps);
        prop_assert_eq!(filled.bytes(), naive.bytes());
    }
}
