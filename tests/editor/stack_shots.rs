//! Pictures of the panels for layers, lights, problems, history and the library, to be looked at:
//! `cargo test --test editor stack_shots -- --ignored` writes them to `target/shots`, or to the
//! folder that `CHIARO_SHOTS` names.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor_support::User;
use chiaro::editor::App;
use chiaro::render::device_descriptor;
use eframe::egui::{Key, Modifiers, Role, Theme, vec2};
use eframe::egui_wgpu::WgpuSetup;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
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
    User::with_builder(builder, move |ctx| App::new(ctx, Some(state.clone())))
}

fn save(hand: &mut User, name: &str) {
    let folder = std::env::var_os("CHIARO_SHOTS")
        .map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    std::fs::create_dir_all(&folder).unwrap();
    hand.settle();
    hand.settle();
    hand.harness.render().unwrap().save(folder.join(format!("{name}.png"))).unwrap();
}

fn tab(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_role_and_label(Role::Tab, label).rect().center();
    hand.click(at);
    hand.settle();
}

fn press(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_label(label).rect().center();
    hand.click(at);
    hand.settle();
}

/// A look with problems of every kind.
const BROKEN: &str = r##"{"name": "Broken", "lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
    "nodes": [
    {"id": "base", "kind": "base", "values": {"colour": [0.2, 0.2, 0.3]}},
    {"id": "diffuse", "kind": "light_layer", "at": [260, 0], "values": {"light": "kay",
    "opacity": 1.8, "blend": "ad"}},
    {"id": "rim", "kind": "ligth_layer", "at": [520, 0]},
    {"id": "output", "kind": "output", "at": [780, 0]}
  ], "wires": [{"from": "base", "to": "diffuse.below"}, {"from": "diffuse", "to": "rim.below"},
  {"from": "rim", "to": "output.color"}]}"##;

#[test]
#[ignore = "writes pictures to be looked at"]
fn shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    save(&mut hand, "layers");
    press(&mut hand, "Layer Specular");
    press(&mut hand, "Solo Specular");
    press(&mut hand, "Show Back-light");
    save(&mut hand, "layers-solo");
    press(&mut hand, "Add layer");
    save(&mut hand, "layers-menu");
    press(&mut hand, "Add Shadow");
    let at = hand.harness.get_all_by_label("Show all").next().unwrap().rect().center();
    hand.click(at);
    save(&mut hand, "layers-added");
    tab(&mut hand, "Lights");
    press(&mut hand, "Light key shines");
    save(&mut hand, "lights");
    tab(&mut hand, "History");
    press(&mut hand, "Step 1: mute back");
    save(&mut hand, "history");
    tab(&mut hand, "Library");
    save(&mut hand, "library");
    press(&mut hand, "Looks");
    for _ in 0..3 {
        hand.settle();
    }
    save(&mut hand, "looks");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "looks-light");
    tab(&mut hand, "Layers");
    save(&mut hand, "layers-light");
    hand.harness.ctx.set_theme(Theme::Dark);
    hand.harness.ctx.set_zoom_factor(1.6);
    save(&mut hand, "layers-scaled");
    hand.harness.ctx.set_zoom_factor(1.0);
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "layers-light");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    std::fs::write(&path, BROKEN).unwrap();
    hand.app_mut().session_mut().go_to(0);
    hand.app_mut().open(&path);
    hand.settle();
    press(&mut hand, "Open the list of problems");
    save(&mut hand, "problems-light");
    hand.harness.ctx.set_theme(Theme::Dark);
    save(&mut hand, "problems");
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn shots_of_folders() {
    let mut hand = window();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("layers.json");
    std::fs::copy("examples/looks/figure1-layers.json", &file).unwrap();
    hand.app_mut().open(&file);
    hand.settle();
    press(&mut hand, "Layer Specular");
    let at = hand.place("Layer Diffuse").left_top() + vec2(60.0, 26.0);
    hand.click_with(Modifiers::COMMAND, at);
    hand.settle();
    save(&mut hand, "folders-two");
    hand.key_with(Modifiers::COMMAND, Key::G);
    hand.settle();
    press(&mut hand, "More of Folder");
    save(&mut hand, "folders-menu");
    press(&mut hand, "Mask by");
    press(&mut hand, "Paint on the model");
    let middle = hand.app().viewport().rect().unwrap().center();
    hand.drag(middle - vec2(60.0, 0.0), middle + vec2(60.0, 10.0));
    hand.settle();
    save(&mut hand, "folders-masked");
}
