//! From pictures painted in another program to a shader with its texture: a folder of numbered
//! images is imported, a rule fills the views that nobody painted, and the look is exported from
//! the menu.

use chiaro::document::{Address, Directions, Grid, Rule};
use chiaro::hcbtf::{from_layers, ktx2};
use eframe::egui::{Key, Modifiers, Role};

use super::artist::Studio;
use crate::support::files;
use crate::support::validators::tint;

const GRID: Grid = Grid {
    size: [12, 8],
    light: Directions { theta: 2, phi: 3 },
    view: Directions { theta: 2, phi: 2 },
};

/// The picture painted for a light, seen from above: a ramp whose color tells the light.
fn painted(light: u8) -> image::RgbaImage {
    let [width, height] = GRID.size;
    image::RgbaImage::from_fn(width, height, |x, y| {
        image::Rgba([40 + 50 * light, (x * 20) as u8, (y * 30) as u8, 255])
    })
}

#[test]
fn painted_pictures_become_a_shader() {
    let studio = Studio::new();
    let folder = studio.path("painted");
    std::fs::create_dir_all(&folder).unwrap();
    // The first view is straight above, with its four lights.
    for light in 0..4 {
        painted(light).save(folder.join(format!("tile-{:02}.png", light + 1))).unwrap();
    }
    std::fs::write(folder.join("notes.txt"), "mine").unwrap();

    let mut artist = studio.window();
    artist.press("Paint");
    artist.press("Import painted pictures as a painted surface...");
    for (label, text) in [
        ("Lights: rings", "2"),
        ("Lights: steps", "3"),
        ("Views: rings", "2"),
        ("Views: steps", "2"),
    ] {
        let field = artist.place_of(Role::SpinButton, label);
        artist.type_over(field, text);
    }
    artist.app_mut().answer_dialog(&folder);
    artist.press("Choose them...");
    let work = artist.app().session().painting().expect("the pictures are taken");
    assert_eq!(
        work.hcbtf().grid,
        GRID,
        "the tile is as large as the pictures: {:?}",
        artist.app().message()
    );
    assert!(work.is_dirty() && artist.has("4 painted") && artist.has("8 empty"));

    // The rule takes what was painted from above for all views.
    artist.tab("Fill rules");
    artist.press("+ Add a rule");
    artist.press_a(Role::MenuItem, "Lock angles");
    for label in ["Eye's height", "Eye's way around"] {
        let is_on = |artist: &super::artist::JourneyUser| {
            let rules = &artist.app().session().painting().unwrap().hcbtf().rules;
            matches!(&rules[..], [Rule::Lock { angles }] if angles.len() == 2)
        };
        if !is_on(&artist) {
            artist.press_a(Role::CheckBox, label);
        }
    }
    artist.settle();
    assert!(artist.has("8 filled") && artist.has("0 empty"));

    let path = studio.path("ramp.hcbtf");
    artist.app_mut().answer_dialog(&path);
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    assert_eq!(chiaro::hcbtf::load(&chiaro::files::Disk, &path).unwrap().value.painted.len(), 4);

    // The look is saved, and exported as WGSL from the menu.
    artist.choose("On", "Sphere");
    artist.save_under(&studio.path("ramp.json"));
    let out = studio.path("shaders");
    artist.app_mut().answer_dialog(&out);
    artist.press("Export");
    artist.press("Export to WGSL, for WebGPU...");
    artist.settle();
    let written = files::below(&out);
    let of = |ending: &str| {
        written
            .iter()
            .filter(|path| path.extension().is_some_and(|found| found == ending))
            .collect::<Vec<_>>()
    };
    let (wgsl, textures) = (of("wgsl"), of("ktx2"));
    assert_eq!(
        (wgsl.len(), textures.len()),
        (2, 1),
        "the look, what it prepares, and its texture: {written:?}: {:?}",
        artist.app().message()
    );
    tint(&wgsl).unwrap();
    let texture = ktx2::read(&std::fs::read(textures[0]).unwrap(), "texture").unwrap();
    let carried = from_layers(&texture).unwrap();
    assert_eq!(carried.grid, GRID);
    for (index, light) in GRID.light.distinct().enumerate() {
        for view in GRID.view.distinct() {
            let tile = carried.painted(Address { view, light }).expect("every view is filled");
            assert_eq!(
                tile.bytes(),
                painted(index as u8).as_raw().as_slice(),
                "light {light} from {view}"
            );
        }
    }
    studio.finish(artist, "ramp.json");
}
