use super::*;
use crate::document::Directions;
use crate::hcbtf::fill::fill;

const ODD: Grid = Grid {
    size: [3, 5],
    light: Directions { theta: 2, phi: 3 },
    view: Directions { theta: 4, phi: 1 },
};

fn directions(theta: u32, phi: u32) -> Directions {
    Directions { theta, phi }
}

fn byte(seed: u32) -> u8 {
    let mixed = (seed ^ 0x9e37_79b9).wrapping_mul(0x85eb_ca6b);
    ((mixed ^ mixed >> 15).wrapping_mul(0xc2b2_ae35) >> 19) as u8
}

/// A consistent sheet, written by the thesis's formulas (A.3) and nothing else.
fn hash_sheet(grid: &Grid) -> BytePicture {
    let [w, h] = grid.size;
    let (ti, pi, tr, pr) = (grid.light.theta, grid.light.phi, grid.view.theta, grid.view.phi);
    let size = [w * tr * ti, h * pr * (pi + 2)];
    let mut rgba = Vec::new();
    for y in 0..size[1] {
        for x in 0..size[0] {
            let (ix, theta_r, theta_i) = (x / (tr * ti), x / ti % tr, x % ti);
            let (iy, phi_r, row) = (y / (pr * (pi + 2)), y / (pi + 2) % pr, y % (pi + 2));
            let phi_i = if row == 0 { pi - 1 } else { (row - 1) % pi };
            // All steps at the normal have one value.
            let phi_i = if theta_i == 0 { 0 } else { phi_i };
            let phi_r = if theta_r == 0 { 0 } else { phi_r };
            let key = [ix, iy, theta_i, phi_i, theta_r, phi_r]
                .into_iter()
                .fold(1, |key: u32, n| key.wrapping_mul(257) ^ n);
            rgba.extend((0..4).map(|channel| byte(key.wrapping_mul(4) + channel)));
        }
    }
    BytePicture { size, rgba }
}

fn there_and_back(sheet: &BytePicture, grid: Grid) -> (BytePicture, Vec<Diagnostic>) {
    let (hcbtf, notes) = import(sheet, grid, "sheet.png").unwrap().into_parts();
    (export(&fill(&hcbtf, &Progress::new()).unwrap()).unwrap(), notes)
}

#[test]
fn a_consistent_sheet_comes_back_byte_for_byte() {
    let grids = [
        Grid::THESIS,
        ODD,
        Grid { size: [1, 1], light: directions(1, 1), view: directions(1, 1) },
        Grid { size: [2, 7], light: directions(1, 4), view: directions(3, 2) },
        Grid { size: [5, 2], light: directions(3, 2), view: directions(1, 6) },
    ];
    for grid in grids {
        let sheet = hash_sheet(&grid);
        assert_eq!(sheet.size, size(&grid));
        let (back, notes) = there_and_back(&sheet, grid);
        assert!(notes.is_empty(), "{notes:?}");
        assert!(back == sheet, "{grid:?}");
        let read =
            read(&sheet.to_png().unwrap(), grid, "sheet.png", &Progress::new()).unwrap().value;
        assert_eq!(read, import(&sheet, grid, "sheet.png").unwrap().value);
        assert_eq!(read.painted.len() as u64, grid.sample_count());
    }
    assert_eq!(size(&Grid::THESIS), [1152, 3840]);
}

#[test]
fn texels_lie_where_the_thesis_has_them() {
    let sheet = hash_sheet(&Grid::THESIS);
    let hcbtf = import(&sheet, Grid::THESIS, "sheet.png").unwrap().value;
    let (light, view, ix, iy) = ([4, 7], [3, 9], 31, 20);
    let tile = hcbtf.painted(Address::new(light, view)).unwrap();
    let (x, y) = (ix * 36 + view[0] * 6 + light[0], iy * 120 + view[1] * 12 + light[1] + 1);
    assert_eq!(tile.texel(i64::from(ix), i64::from(iy)), sheet.texel(x as usize, y as usize));
}

#[test]
fn copies_that_differ_are_told_and_not_taken() {
    let grid = ODD;
    let clean = hash_sheet(&grid);
    let spoiled = |places: &[[usize; 2]]| {
        let mut sheet = clean.clone();
        for [x, y] in places {
            sheet.rgba[4 * (y * sheet.size[0] as usize + x)] ^= 0x80;
        }
        there_and_back(&sheet, grid)
    };
    // Rows of 5: padding, steps 0 to 2, padding; columns of 8: views 0 to 3, for each view lights 0
    // and 1.
    let (back, notes) = spoiled(&[[9, 4], [3, 5]]);
    assert!(back == clean, "padding is made anew");
    assert_eq!(notes.len(), 1);
    let told = notes[0].to_string();
    assert!(
        told.contains("2 texels of padding rows") && told.contains("the first at x 9, y 4"),
        "{told}"
    );
    assert!(told.contains("sheet.png: warning[hcbtf-copies]"), "{told}");

    // Column 2 is view ring 1, light ring 0; row 7 is step 1.
    let (back, notes) = spoiled(&[[2, 7]]);
    assert!(back == clean, "step 0 is taken");
    assert_eq!(notes.len(), 1, "{notes:?}");
    assert!(
        notes[0].message.contains("1 texels at the normal differ between steps of the light"),
        "{notes:?}"
    );

    // The normal's own step 0 is the original, so every copy of it differs now.
    let (back, notes) = spoiled(&[[2, 6]]);
    assert!(back != clean);
    assert!(
        notes.iter().any(|note| note.message.starts_with("2 texels at the normal")),
        "{notes:?}"
    );

    let views = Grid { size: [1, 1], light: directions(2, 2), view: directions(2, 3) };
    let clean = hash_sheet(&views);
    let mut sheet = clean.clone();
    // View ring 0, light ring 1, at the view's step 2 and the light's step 0.
    sheet.rgba[4 * ((2 * 4 + 1) * 4 + 1)] ^= 0x80;
    let (back, notes) = there_and_back(&sheet, views);
    assert!(back == clean);
    assert!(
        notes.iter().any(|note| note.message.contains("between steps of the view")),
        "{notes:?}"
    );
}

#[test]
fn other_sizes_and_other_files_are_refused() {
    let sheet = hash_sheet(&ODD);
    let problems = import(&sheet, Grid::THESIS, "a.png").unwrap_err();
    assert!(
        problems[0].to_string().contains("it has 24 x 25 texels; the grid asks for 1152 x 3840"),
        "{problems:?}"
    );
    let problems =
        read(&sheet.to_png().unwrap(), Grid::THESIS, "a.png", &Progress::new()).unwrap_err();
    assert!(problems[0].hints[0].contains("--grid"), "{problems:?}");
    assert!(
        read(b"nothing", ODD, "a.png", &Progress::new()).unwrap_err()[0]
            .message
            .contains("it is no PNG")
    );
    let lying = BytePicture { size: sheet.size, rgba: vec![0; 4] };
    assert!(import(&lying, ODD, "a.png").is_err());
    let huge = Grid { size: [4095; 2], light: directions(255, 255), view: directions(255, 255) };
    let mut header = sheet.to_png().unwrap();
    header[16..20].copy_from_slice(&size(&huge)[0].to_be_bytes());
    header[20..24].copy_from_slice(&size(&huge)[1].to_be_bytes());
    assert!(read(&header, huge, "a.png", &Progress::new()).unwrap_err()[0].message.contains("MiB"));
}

#[test]
fn empty_samples_stay_empty() {
    let mut hcbtf = Hcbtf::new(ODD);
    hcbtf
        .painted
        .insert(Address::new([1, 2], [3, 0]), Arc::new(Tile::filled(ODD.size, [1, 2, 3, 0])));
    let sheet = export(&fill(&hcbtf, &Progress::new()).unwrap()).unwrap();
    assert_eq!(import(&sheet, ODD, "a.png").unwrap().value.painted, hcbtf.painted);
}

#[test]
fn every_place_of_the_sheet_tells_what_it_holds() {
    let grid = Grid { size: [3, 2], light: directions(3, 4), view: directions(2, 5) };
    let [width, height] = size(&grid);
    let mut own = 0;
    for [x, y] in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
        let SheetTexel { address, texel, is_copy } = held(&grid, [x, y]).unwrap();
        assert_eq!(address, address.canonical());
        let is_own = place(&grid, address, texel.map(|n| n as usize)) == [x as usize, y as usize];
        assert_eq!(is_own, !is_copy, "{address} at {x}, {y}");
        own += u64::from(is_own);
    }
    assert_eq!(own, grid.sample_count() * 6, "every texel of every sample once");
    assert_eq!(held(&grid, [width, 0]), None);
    // Computed by hand from A.3: the third light ring of the second view ring, in the block of the
    // texel to the right; the row of padding above light step 0 of view step 1 is a copy of light
    // step 3.
    let found = held(&grid, [6 + 3 + 2, 6]).unwrap();
    assert_eq!(
        found,
        SheetTexel { address: Address::new([2, 3], [1, 1]), texel: [1, 0], is_copy: true }
    );
}
