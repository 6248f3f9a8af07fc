use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DVec2, Vec3};

use super::*;
use crate::document::{
    Bundle, Direction, Directions, Hcbtf, Placement, Rule, StrokeGround, StrokeShadow, StrokeShape,
    StrokeTones, Tile,
};
use crate::hcbtf::fill::{fill, sample};
use crate::hcbtf::{NotFilled, Provenance};

const SIDE: u32 = 48;
const GRID: Grid = Grid {
    size: [SIDE, SIDE],
    light: Directions { theta: 4, phi: 6 },
    view: Directions { theta: 4, phi: 8 },
};

fn with(bundles: Vec<Bundle>) -> Strokes {
    Strokes { bundles, ..Strokes::default() }
}

/// Black dots at these places.
fn dots(places: &[[f64; 3]], width: f64) -> Bundle {
    Bundle {
        place: Placement::Paths(places.iter().map(|place| vec![*place]).collect()),
        shape: StrokeShape::Dot,
        width: [width; 2],
        ..Bundle::default()
    }
}

fn tile(strokes: &Strokes, grid: Grid, is_tiling: bool, address: Address) -> Vec<Color> {
    let ready = PreparedStrokes::new(strokes, &grid, is_tiling, &Progress::new()).unwrap();
    ready.tile(address, &Progress::new()).unwrap()
}

/// The darkness of each texel, relative to white, 0 to 1.
fn darkness(texels: &[Color]) -> Vec<f64> {
    texels.iter().map(|texel| 1.0 - f64::from(texel[1]) / 255.0).collect()
}

/// The middle of the dark parts of a tile that repeats: along u and v in widths of the tile, by the
/// mean of angles.
fn middle(dark: &[f64]) -> DVec2 {
    let mut sums = [DVec2::ZERO; 2];
    for (index, dark) in dark.iter().enumerate() {
        let (x, y) = (index as u32 % SIDE, index as u32 / SIDE);
        let place = [f64::from(x) + 0.5, f64::from(SIDE) - f64::from(y) - 0.5];
        for (sum, at) in sums.iter_mut().zip(place) {
            *sum += *dark * DVec2::from_angle(TAU * at / f64::from(SIDE));
        }
    }
    let [u, v] = sums.map(|sum| (sum.to_angle() / TAU).rem_euclid(1.0));
    DVec2::new(u, v)
}

/// The distance between two places on a tile that repeats.
fn apart(a: DVec2, b: DVec2) -> f64 {
    let off = (a - b).abs();
    off.min(DVec2::ONE - off).length()
}

/// The tangent of a direction's angle from the normal, at most four, along u and v.
fn tangent(of: Directions, direction: Direction) -> DVec2 {
    let theta = FRAC_PI_2 * f64::from(direction.theta) / f64::from(of.theta - 1);
    let phi = TAU * f64::from(direction.phi) / f64::from(of.phi);
    let slope = if direction.theta == of.theta - 1 { 4.0 } else { theta.tan().min(4.0) };
    slope * DVec2::new(phi.sin(), phi.cos())
}

#[test]
fn what_stands_is_seen_moved_by_its_height() {
    let (place, height) = (DVec2::new(0.85, 0.3), 0.21);
    let strokes = with(vec![dots(&[[place.x, place.y, height]], 0.14)]);
    for view in GRID.view.distinct() {
        let seen = tile(&strokes, GRID, true, Address { view, light: Direction::default() });
        let dark = darkness(&seen);
        let expected = (place - height * tangent(GRID.view, view)).rem_euclid(DVec2::ONE);
        assert!(
            apart(middle(&dark), expected) < 2e-3,
            "{view}: {:?}, wanted {expected:?}",
            middle(&dark)
        );
        // The disc has its own size, wherever it is.
        let area = dark.iter().sum::<f64>() / f64::from(SIDE * SIDE);
        assert!((area - std::f64::consts::PI * 0.07 * 0.07).abs() < 4e-4, "{view}: {area}");
    }
}

#[test]
fn a_thread_is_equally_wide_from_every_side() {
    let upright = vec![[0.5, 0.5, 0.0], [0.5, 0.5, 0.1], [0.5, 0.5, 0.2]];
    let thread =
        Bundle { place: Placement::Paths(vec![upright]), width: [0.0625; 2], ..Bundle::default() };
    for view in GRID.view.distinct().filter(|view| view.theta > 0) {
        let dark = darkness(&tile(
            &with(vec![thread.clone()]),
            GRID,
            true,
            Address { view, ..Address::default() },
        ));
        let area = dark.iter().sum::<f64>() / f64::from(SIDE * SIDE);
        let expected = 0.0625 * 0.2 * tangent(GRID.view, view).length();
        assert!(
            (area - expected).abs() < 0.04 * expected + 3e-4,
            "{view}: {area}, wanted {expected}"
        );
    }
}

#[test]
fn nearer_strokes_hide_those_behind() {
    let view = Direction { theta: 1, phi: 3 };
    let at = DVec2::new(0.4, 0.6);
    // Both dots are seen at one place.
    let along = |height: f64| {
        let place = at + height * tangent(GRID.view, view);
        [place.x, place.y, height]
    };
    let red = Bundle { root: [[255, 0, 0]; 2], tip: [[255, 0, 0]; 2], ..dots(&[along(0.1)], 0.2) };
    let green =
        Bundle { root: [[0, 255, 0]; 2], tip: [[0, 255, 0]; 2], ..dots(&[along(0.3)], 0.2) };
    let index = ((1.0 - at.y) * f64::from(SIDE)) as usize * SIDE as usize
        + (at.x * f64::from(SIDE)) as usize;
    let seen = |bundles: Vec<Bundle>| {
        let texels = tile(&with(bundles), GRID, true, Address { view, ..Address::default() });
        texels[index]
    };
    assert_eq!(seen(vec![red.clone(), green.clone()]), [0.0, 255.0, 0.0, 255.0]);
    assert_eq!(seen(vec![green.clone(), red.clone()]), [0.0, 255.0, 0.0, 255.0]);
    // Of equally high strokes the later one is in front.
    let level =
        |of: &Bundle| Bundle { place: Placement::Paths(vec![vec![along(0.1)]]), ..of.clone() };
    assert_eq!(seen(vec![level(&green), level(&red)]), [255.0, 0.0, 0.0, 255.0]);
    assert_eq!(seen(vec![level(&red), level(&green)]), [0.0, 255.0, 0.0, 255.0]);
}

/// Strokes on a white ground that is black where no light comes.
fn shadowed(bundles: Vec<Bundle>) -> Strokes {
    Strokes {
        ground: StrokeGround { color: [255; 4], ambient: 0.0, diffuse: 2.0 },
        shadow: StrokeShadow { amount: 1.0, softness: 0.0 },
        ..with(bundles)
    }
}

#[test]
fn shadows_fall_along_the_light() {
    let (place, height) = (DVec2::new(0.2, 0.7), 0.3);
    // The dot is white, so that only its shadow is dark.
    let dot = Bundle {
        root: [[255; 3]; 2],
        tip: [[255; 3]; 2],
        ..dots(&[[place.x, place.y, height]], 0.12)
    };
    for light in GRID.light.distinct().filter(|light| (1..3).contains(&light.theta)) {
        for view in [Direction::default(), Direction { theta: 1, phi: 6 }] {
            let dark =
                darkness(&tile(&shadowed(vec![dot.clone()]), GRID, true, Address { view, light }));
            let lambert = (FRAC_PI_2 * f64::from(light.theta) / 3.0).cos();
            let ground = 1.0 - (2.0 * lambert).min(1.0);
            let shadow: Vec<f64> = dark.iter().map(|dark| (dark - ground).max(0.0)).collect();
            let expected = (place - height * tangent(GRID.light, light)).rem_euclid(DVec2::ONE);
            // Places where the dot hides its own shadow are skipped.
            if apart(expected, place - height * tangent(GRID.view, view)) < 0.13 {
                continue;
            }
            assert!(
                apart(middle(&shadow), expected) < 6e-3,
                "{light}: {:?}, wanted {expected:?}",
                middle(&shadow)
            );
        }
    }
}

#[test]
fn strokes_shadow_each_other_and_not_themselves() {
    let light = Direction { theta: 1, phi: 2 };
    let low = DVec2::new(0.5, 0.5);
    let high = low + 0.2 * tangent(GRID.light, light);
    let lit = |places: &[[f64; 3]]| {
        let white = Bundle {
            root: [[255; 3]; 2],
            tip: [[255; 3]; 2],
            ambient: 0.0,
            diffuse: 1.0,
            ..dots(places, 0.16)
        };
        let texels =
            tile(&shadowed(vec![white]), GRID, true, Address { light, ..Address::default() });
        texels[(SIDE / 2 * SIDE + SIDE / 2) as usize][0]
    };
    assert!(lit(&[[low.x, low.y, 0.1]]) > 200.0);
    assert_eq!(lit(&[[low.x, low.y, 0.1], [high.x, high.y, 0.3]]), 0.0);
}

#[test]
fn darker_is_more_strokes_and_those_of_lighter_tones_stay() {
    let lines = Bundle {
        place: Placement::Scatter(60),
        shape: StrokeShape::Ribbon,
        length: [0.3, 0.5],
        lean: FRAC_PI_2,
        spread: 0.3,
        tones: Some(StrokeTones { first: 0.95, all: 0.1, growth: 0.0 }),
        ..Bundle::default()
    };
    let dots = Bundle {
        place: Placement::Lattice(32),
        shape: StrokeShape::Dot,
        width: [0.25; 2],
        tones: Some(StrokeTones { first: 1.0, all: 0.0, growth: 1.0 }),
        ..Bundle::default()
    };
    let grid = Grid { light: Directions { theta: 9, phi: 1 }, ..GRID };
    for bundle in [lines, dots] {
        let strokes = with(vec![bundle]);
        let ready = PreparedStrokes::new(&strokes, &grid, true, &Progress::new()).unwrap();
        let mut before = vec![0.0; grid.texels()];
        let mut tones = Vec::new();
        for light in grid.light.distinct() {
            let texels =
                ready.tile(Address { light, ..Address::default() }, &Progress::new()).unwrap();
            let dark = darkness(&texels);
            assert!(dark.iter().zip(&before).all(|(now, before)| *now >= before - 1e-6), "{light}");
            tones.push(dark.iter().sum::<f64>() / dark.len() as f64);
            before = dark;
        }
        assert!(tones[0] < 1e-6 && tones[8] > 0.4, "{tones:?}");
        assert!(tones.windows(2).skip(1).all(|pair| pair[1] > pair[0]), "{tones:?}");
    }
    // Two strokes of a bundle: each appears at its own tone.
    let tones = StrokeTones { first: 0.8, all: 0.4, growth: 0.0 };
    assert_eq!([0.85, 0.65, 0.45].map(|tone| tones.share(tone, 0.25)), [0.0, 1.0, 1.0]);
    assert_eq!([0.85, 0.65, 0.45].map(|tone| tones.share(tone, 0.75)), [0.0, 0.0, 1.0]);
    let bright = StrokeTones { first: 0.4, all: 0.8, growth: 1.0 };
    assert!((bright.share(0.5, 0.3) - 0.25).abs() < 1e-9, "and lighter may be more strokes, too");
}

/// A field that lies half a tile further is the same field, rolled: the tile's edges leave no
/// trace.
#[test]
fn strokes_go_on_across_the_edges() {
    let field = |shift: f64| {
        let path = |index: u32| {
            let at = |part: f64| {
                let turn = f64::from(index) + 0.8 * part;
                let u = (f64::from(index) * 0.37).fract() + 0.2 * part * turn.sin() + shift;
                let v = (f64::from(index) * 0.61).fract() + 0.2 * part * turn.cos() + shift;
                [u, v, 0.25 * part]
            };
            (0..6).map(|step| at(f64::from(step) / 5.0)).collect()
        };
        let threads = Bundle {
            place: Placement::Paths((0..30).map(path).collect()),
            root: [[20, 60, 10]; 2],
            tip: [[200, 220, 90]; 2],
            width: [0.03; 2],
            diffuse: 0.6,
            ambient: 0.4,
            ..Bundle::default()
        };
        Strokes { shadow: StrokeShadow { amount: 0.8, softness: 0.1 }, ..shadowed(vec![threads]) }
    };
    let address = Address::new([2, 1], [2, 3]);
    let here = tile(&field(0.0), GRID, true, address);
    let there = tile(&field(0.5), GRID, true, address);
    let mut worst: Vec<f32> = Vec::new();
    for y in 0..SIDE {
        for x in 0..SIDE {
            let rolled = there[((y + SIDE / 2) % SIDE * SIDE + (x + SIDE / 2) % SIDE) as usize];
            let texel = here[(y * SIDE + x) as usize];
            worst.push((0..4).map(|i| (texel[i] - rolled[i]).abs()).fold(0.0, f32::max));
        }
    }
    worst.sort_by(f32::total_cmp);
    // A place on an edge may fall to either side of it by rounding.
    assert!(worst[worst.len() * 98 / 100] < 0.5, "{:?}", &worst[worst.len() * 98 / 100..]);
    // Without tiling, strokes beyond the tile's edges are not seen.
    let dot = with(vec![dots(&[[0.1, 0.5, 0.3]], 0.1)]);
    let beyond = Address::new([0, 0], [2, 2]);
    assert!(darkness(&tile(&dot, GRID, false, beyond)).iter().all(|dark| *dark == 0.0));
    assert!(darkness(&tile(&dot, GRID, true, beyond)).iter().any(|dark| *dark > 0.9));
}

#[test]
fn stripes_turn_to_the_eye() {
    let straight = |ends: [[f64; 2]; 2], turns: f64| {
        let path = ends.map(|[u, v]| [u, v, 0.0]).to_vec();
        let shape = StrokeShape::Ribbon;
        with(vec![Bundle {
            place: Placement::Paths(vec![path]),
            shape,
            width: [0.1; 2],
            turns,
            ..Bundle::default()
        }])
    };
    let turning = straight([[0.5, 0.3], [0.5, 0.8]], 1.0);
    for (phi, ends) in [
        (0, [[0.5, 0.3], [0.5, 0.8]]),
        (2, [[0.25, 0.55], [0.75, 0.55]]),
        (4, [[0.5, 0.8], [0.5, 0.3]]),
    ] {
        let address = Address::new([0, 0], [1, phi]);
        let (got, wanted) =
            (tile(&turning, GRID, true, address), tile(&straight(ends, 0.0), GRID, true, address));
        let off =
            darkness(&got).iter().zip(darkness(&wanted)).map(|(a, b)| (a - b).abs()).sum::<f64>();
        assert!(off < 3.0, "{phi}: {off}");
    }
}

#[test]
fn rows_are_the_same_however_many_are_drawn_at_once() {
    let strokes = Strokes::preset("Grass");
    let ready = PreparedStrokes::new(&strokes, &GRID, true, &Progress::new()).unwrap();
    let rays = Rays { view: Vec3::new(0.6, 0.0, 0.8), light: Vec3::Z, around: 0.25 };
    let there = seen(&strokes, &ready.all, rays);
    let size = [SIDE as usize * CELLS; 2];
    let drawn = |rows: std::ops::Range<usize>| {
        let mut canvas = StrokeRaster::new(size, true, rows);
        let all = there.iter().flatten();
        draw(&mut canvas, all, slope(rays.view), size[0] as f32, 1.0, true, &Progress::new())
            .unwrap();
        canvas
    };
    let (whole, part) = (drawn(0..size[1]), drawn(40..60));
    for y in 40..60 {
        assert!(
            whole
                .row(y)
                .iter()
                .zip(part.row(y))
                .all(|(a, b)| a.stroke == b.stroke && a.along == b.along),
            "{y}"
        );
    }
}

fn hcbtf(strokes: Strokes, side: u32) -> Hcbtf {
    let directions = Directions { theta: 3, phi: 4 };
    let grid = Grid { size: [side, side], light: directions, view: directions };
    Hcbtf { rules: vec![Rule::Strokes(Box::new(strokes))], ..Hcbtf::new(grid) }
}

#[test]
fn it_is_the_same_on_any_number_of_threads_and_alone() {
    for name in Strokes::PRESETS {
        let hcbtf = hcbtf(Strokes::preset(name), 12);
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| fill(&hcbtf, &Progress::new()).unwrap())
        };
        let filled = on(1);
        assert_eq!(filled, on(7), "{name}");
        for (address, tile, provenance) in filled.iter().step_by(7) {
            assert_eq!(*provenance, Provenance::Filled { by: 0, changed_by: Vec::new() });
            assert_eq!(
                sample(&hcbtf, address, &Progress::new()).unwrap().as_ref(),
                Some(tile),
                "{name}: {address}"
            );
        }
    }
    assert_eq!(
        sample(&hcbtf(Strokes::default(), 4), Address::new([9, 0], [0, 0]), &Progress::new()),
        Ok(None)
    );
}

#[test]
fn what_is_painted_and_what_changes_it_stay_rules_as_others() {
    let mut hcbtf = hcbtf(Strokes::preset("Grass"), 8);
    let painted = Arc::new(Tile::filled([8, 8], [1, 2, 3, 255]));
    hcbtf.painted.insert(Address::default(), painted.clone());
    let plain = fill(&hcbtf, &Progress::new()).unwrap();
    assert_eq!(plain.tile(Address::default()), Some(&painted));
    hcbtf.rules.push(Rule::Lambert { shadow: [0; 3], amount: 1.0 });
    let darkened = fill(&hcbtf, &Progress::new()).unwrap();
    let address = Address::new([1, 2], [1, 0]);
    let bytes =
        plain.tile(address).unwrap().bytes().iter().zip(darkened.tile(address).unwrap().bytes());
    let lambert = std::f64::consts::FRAC_PI_4.cos();
    for (index, (before, after)) in bytes.enumerate().filter(|(index, _)| index % 4 < 3) {
        assert!(
            (f64::from(*before) * lambert - f64::from(*after)).abs() < 1.0,
            "{index}: {before} {after}"
        );
    }
}

#[test]
fn it_can_be_stopped() {
    let progress = Progress::new();
    progress.stop();
    assert!(PreparedStrokes::new(&Strokes::preset("Grass"), &GRID, true, &progress).is_none());
    let ready =
        PreparedStrokes::new(&Strokes::preset("Grass"), &GRID, true, &Progress::new()).unwrap();
    assert!(ready.tile(Address::default(), &progress).is_none());
    let hcbtf = hcbtf(Strokes::preset("Grass"), 8);
    assert_eq!(fill(&hcbtf, &progress), Err(NotFilled::Stopped));
    assert_eq!(sample(&hcbtf, Address::default(), &progress), Err(NotFilled::Stopped));
}

#[test]
fn numbers_are_bounded() {
    assert!(Strokes::PRESETS.iter().all(|name| Strokes::preset(name).check().is_ok()));
    let wrong = |change: fn(&mut Bundle), told: &str| {
        let mut bundle = Bundle::default();
        change(&mut bundle);
        let why = with(vec![Bundle::default(), bundle]).check().unwrap_err();
        assert!(why.contains(told), "{why}");
    };
    wrong(
        |bundle| bundle.place = Placement::Scatter(5000),
        "`bundles[1].place.scatter`: 5000 is out of range: write a whole number from 0 to 4096",
    );
    wrong(|bundle| bundle.length = [0.1, 5.0], "`bundles[1].length[1]`: 5 is out of range");
    wrong(|bundle| bundle.lift = [0.0, f64::NAN], "`bundles[1].lift[1]`: `NaN`");
    wrong(|bundle| bundle.highlight.sharpness = 0.0, "`bundles[1].highlight.sharpness`: 0 is out");
    wrong(
        |bundle| bundle.tones = Some(StrokeTones { first: 0.5, all: 0.5, growth: 0.0 }),
        "are equal",
    );
    wrong(
        |bundle| bundle.place = Placement::Paths(vec![vec![[0.0, 9.0, 0.0]]]),
        "paths[0][0][1]`: 9 is out of range",
    );
    wrong(|bundle| bundle.place = Placement::Paths(vec![vec![[0.5; 3]; 30_000]]), "are 30000 here");
    let paths = vec![vec![[0.5; 3]; 15_000]; 2];
    let many = Bundle { place: Placement::Paths(paths), ..Bundle::default() };
    assert!(with(vec![many]).check().unwrap_err().contains("30000 points"));
    wrong(
        |bundle| {
            (bundle.place, bundle.length, bundle.width) =
                (Placement::Scatter(4000), [4.0; 2], [1.0; 2]);
        },
        "cover the tile 16002 times",
    );
    assert!(
        with(vec![Bundle::default(); 40])
            .check()
            .unwrap_err()
            .contains("there are 40 here; at most 32")
    );
    // The most extreme strokes are drawn without harm: ends that meet, no points at all, strokes as
    // wide as the tile.
    let odd = |place: Placement, shape: StrokeShape| Bundle {
        place,
        shape,
        width: [1.0; 2],
        ..Bundle::default()
    };
    let still = Placement::Paths(vec![vec![[0.5; 3]; 3], Vec::new(), vec![[0.2, 0.2, 4.0]]]);
    for shape in [StrokeShape::Thread, StrokeShape::Ribbon, StrokeShape::Dot] {
        let strokes = with(vec![
            odd(still.clone(), shape),
            odd(Placement::Scatter(0), shape),
            odd(Placement::Lattice(0), shape),
        ]);
        strokes.check().unwrap();
        for size in [[1, 1], [3, 40], [40, 1]] {
            let texels = tile(&strokes, Grid { size, ..GRID }, true, Address::new([3, 1], [3, 2]));
            assert!(texels.iter().flatten().all(|channel| (0.0..=255.0).contains(channel)));
        }
    }
}
