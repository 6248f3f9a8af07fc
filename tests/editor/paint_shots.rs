//! Pictures of the painting workspace, to be looked at: `cargo test --test editor paint_shots --
//! --ignored` writes them to `target/shots`, or to the folder that `CHIARO_SHOTS` names.

use std::path::PathBuf;
use std::sync::Arc;

use crate::editor_support::User;
use chiaro::document::{Address, Directions, Grid, Hcbtf, Rule, Tile};
use chiaro::editor::App;
use chiaro::render::device_descriptor;
use eframe::egui::{Key, Modifiers, Pos2, Role, Theme, vec2};
use eframe::egui_wgpu::WgpuSetup;
use egui_kittest::Harness;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};

fn window() -> User {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.device_descriptor = Arc::new(device_descriptor);
    }
    let state = create_render_state(setup, eframe::egui_wgpu::RendererOptions::PREDICTABLE);
    let builder = Harness::builder()
        .with_size(vec2(1600.0, 960.0))
        .renderer(WgpuTestRenderer::from_render_state(state.clone()));
    User::with_builder(builder, move |ctx| App::new(ctx, Some(state.clone())).without_dialogs())
}

fn save(hand: &mut User, name: &str) {
    let folder = std::env::var_os("CHIARO_SHOTS")
        .map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    std::fs::create_dir_all(&folder).unwrap();
    hand.settle();
    hand.harness.render().unwrap().save(folder.join(format!("{name}.png"))).unwrap();
}

/// A tile of bricks under a light and from a view: lit edges, and mortar in shadow.
fn bricks(grid: &Grid, at: Address) -> Tile {
    let [width, height] = grid.size;
    let light = grid.light.vector(at.light);
    let texel = |x: u32, y: u32| {
        let rows = 4;
        let row = y * rows / height;
        let shift = if row.is_multiple_of(2) { 0 } else { width / 4 };
        let (bx, by) = ((x + shift) % (width / 2), y % (height / rows));
        let is_mortar = bx < 2 || by < 1;
        let lit = |n: glam::DVec3| (n.normalize().dot(light)).max(0.0);
        let up = if by == 1 {
            0.7
        } else if by + 1 == height / rows {
            -0.7
        } else {
            0.0
        };
        let across = if bx == 2 {
            -0.7
        } else if bx + 1 == width / 2 {
            0.7
        } else {
            0.0
        };
        let shade = 0.25 + 0.75 * lit(glam::DVec3::new(across, up, 1.0));
        let tone = (x * 7 + row * 13 + (x + shift) / (width / 2) * 29) % 5;
        let base = if is_mortar {
            [150.0, 142.0, 130.0]
        } else {
            [176.0 - 8.0 * f64::from(tone), 84.0, 58.0]
        };
        let dim = if is_mortar { 0.7 } else { 1.0 };
        base.map(|c: f64| (c * shade * dim).clamp(0.0, 255.0) as u8)
    };
    let bytes = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).flat_map(|(x, y)| {
        let [r, g, b] = texel(x, y);
        [r, g, b, 255]
    });
    Tile::new(grid.size, bytes.collect()).unwrap()
}

fn painted() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let grid = Grid {
        size: [32, 32],
        light: Directions { theta: 6, phi: 10 },
        view: Directions { theta: 6, phi: 10 },
    };
    let mut hcbtf = Hcbtf::new(grid);
    for (light, view) in
        [([0, 0], [0, 0]), ([3, 0], [0, 0]), ([3, 5], [0, 0]), ([4, 8], [2, 5]), ([5, 2], [3, 7])]
    {
        let address = Address::new(light, view);
        hcbtf.painted.insert(address, Arc::new(bricks(&grid, address)));
    }
    hcbtf.rules =
        vec![Rule::Blend { sharpness: 4.0 }, Rule::Lambert { shadow: [20, 18, 32], amount: 0.6 }];
    std::fs::write(folder.path().join("bricks.hcbtf"), chiaro::hcbtf::write(&hcbtf).unwrap())
        .unwrap();
    folder
}

fn spiral(hand: &User) -> Vec<Pos2> {
    let at = |step: u32| {
        let turn = f64::from(step) * 0.35;
        let radius = 2.0 + f64::from(step) * 0.35;
        hand.app()
            .painting()
            .screen([16.0 + radius * turn.cos(), 16.0 + radius * turn.sin()])
            .unwrap()
    };
    (0..30).map(at).collect()
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn shots() {
    let mut hand = window();
    let recent = painted();
    let long = Grid { size: [64, 24], ..Grid::THESIS };
    let mut hcbtf = Hcbtf::new(long);
    hcbtf.painted.insert(Address::default(), Arc::new(bricks(&long, Address::default())));
    std::fs::write(recent.path().join("frieze.hcbtf"), chiaro::hcbtf::write(&hcbtf).unwrap())
        .unwrap();
    hand.app_mut().change_settings(|settings| {
        for name in ["frieze", "bricks"] {
            settings.opened(&recent.path().join(format!("{name}.hcbtf")));
        }
    });
    hand.app_mut().show_start_page();
    save(&mut hand, "paint-start-page");
    hand.press("Paint a surface");
    save(&mut hand, "paint-0-start");
    hand.press("Another grid...");
    save(&mut hand, "paint-0-grid");
    let views = hand.place_of(Role::SpinButton, "Views: rings");
    hand.type_over(views, "255");
    save(&mut hand, "paint-0-grid-refused");
    hand.press("Cancel");
    hand.press("Import painted pictures...");
    hand.choose("Kind of pictures", "A contact sheet");
    save(&mut hand, "paint-0-import");
    hand.press("Cancel");
    hand.press("Thesis: 32 x 32 texels, 51 lights x 51 views");
    save(&mut hand, "paint-1-new");
    let path = spiral(&hand);
    hand.drag_through(&path);
    hand.hover(path[3]);
    save(&mut hand, "paint-2-stroke");

    let folder = painted();
    hand.app_mut().session_mut().painting_mut().unwrap().go_to(Address::default());
    let mut hand = window();
    hand.app_mut().open(&folder.path().join("bricks.hcbtf"));
    hand.settle();
    save(&mut hand, "paint-3-bricks");
    hand.app_mut().session_mut().painting_mut().unwrap().go_to(Address::new([4, 8], [2, 5]));
    hand.settle();
    let path = spiral(&hand);
    hand.drag_through(&path);
    hand.hover(path[8]);
    save(&mut hand, "paint-4-tilted");
    hand.press("Where it shows");
    hand.hover(path[8]);
    save(&mut hand, "paint-4-where");
    hand.press("Where it shows");
    hand.press("Fill");
    save(&mut hand, "paint-4-fill");
    hand.press("Brush");
    hand.app_mut().show_on("shape:creature");
    hand.settle();
    hand.press("Paint");
    hand.press("Export the painted surface as a KTX2 texture...");
    save(&mut hand, "paint-13-texture");
    hand.press("Cancel");
    hand.press("Paint");
    save(&mut hand, "paint-13-menu");
    hand.key(Key::Escape);
    hand.press("Show in the picture");
    hand.app_mut().session_mut().painting_mut().unwrap().go_to(Address::new([2, 1], [5, 2]));
    hand.tab("Fill rules");
    save(&mut hand, "paint-5-grazing");
    let memory = hand.place_like("Memory:").center();
    hand.click(memory);
    save(&mut hand, "paint-5-memory");
    hand.press("Paint");
    hand.press("New tile from this painting...");
    let across = hand.place_of(Role::SpinButton, "Texels across");
    hand.type_over(across, "48");
    save(&mut hand, "paint-10-synthesis");
    hand.press("Cancel");
    hand.press("Paint");
    hand.press("Bake this look onto a tile...");
    save(&mut hand, "paint-11-bake");
    bake(&mut hand, &folder.path().join("baked.hcbtf"));
    hand.press("View");
    hand.press_a(Role::CheckBox, "Sheet");
    hand.key(Key::Escape);
    save(&mut hand, "paint-8-sheet");
    let sample = Address::new([2, 1], [5, 2]);
    for _ in 0..5 {
        let at = hand.app().painting().on_sheet(sample, [12, 10]).unwrap();
        hand.wheel(at, 300.0);
    }
    let at = hand.app().painting().on_sheet(sample, [12, 10]).unwrap();
    hand.hover(at + vec2(0.0, 40.0));
    save(&mut hand, "paint-9-sheet-near");
    hand.tab("Paint");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "paint-6-light");
    hand.key_with(Modifiers::NONE, Key::F1);
    save(&mut hand, "paint-7-keys");
}

/// Saves a picture of a bake under way, which no settled window shows.
fn bake(hand: &mut User, path: &std::path::Path) {
    hand.app_mut().answer_dialog(path);
    let bake = hand.place("Bake to...").center();
    hand.click(bake);
    let image = hand.harness.render().unwrap();
    let shots = std::env::var_os("CHIARO_SHOTS")
        .map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    image.save(shots.join("paint-12-baking.png")).unwrap();
    hand.press("Stop");
}
