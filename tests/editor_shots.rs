//! Pictures of the window, to be looked at: `cargo test --test editor_shots -- --ignored` writes them to
//! `target/shots`, or to the folder that `CHIARO_SHOTS` names.
#![cfg(feature = "editor")]

mod editor_support;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro::editor::App;
use chiaro::render::device_descriptor;
use editor_support::Hand;
use eframe::egui::{Role, Theme, vec2};
use eframe::egui_wgpu::WgpuSetup;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};

fn window() -> Hand {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.device_descriptor = Arc::new(device_descriptor);
    }
    let state = create_render_state(setup, eframe::egui_wgpu::RendererOptions::PREDICTABLE);
    let builder =
        Harness::builder().with_size(vec2(1600.0, 960.0)).renderer(WgpuTestRenderer::from_render_state(state.clone()));
    Hand::with_builder(builder, move |ctx| App::new(ctx, Some(state.clone())))
}

fn save(hand: &mut Hand, name: &str) {
    let folder = std::env::var_os("CHIARO_SHOTS").map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    std::fs::create_dir_all(&folder).unwrap();
    hand.settle();
    hand.harness.render().unwrap().save(folder.join(format!("{name}.png"))).unwrap();
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    save(&mut hand, "dark");
    for panel in ["Effects", "Cost and accuracy", "Probe"] {
        let tab = hand.harness.get_by_label(panel).rect().center();
        hand.click(tab);
        save(&mut hand, &panel.to_lowercase().replace(' ', "-"));
    }
    hand.harness.ctx.set_theme(Theme::Light);
    let tab = hand.harness.get_by_label("Code").rect().center();
    hand.click(tab);
    save(&mut hand, "light");
}

fn click_label(hand: &mut Hand, label: &str) {
    let at = hand.harness.get_by_label(label).rect().center();
    hand.click(at);
    hand.settle();
}

/// What tells how true the picture is and what it costs: measured tiers, a wipe against the truth, a wire as isolines,
/// and a wire that is not a number.
#[test]
#[ignore = "writes pictures to be looked at"]
fn shots_of_truth() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure4-both.json"));
    hand.settle();
    click_label(&mut hand, "Cost and accuracy");
    click_label(&mut hand, "Measure");
    save(&mut hand, "cost-measured");
    let plot = hand.harness.get_by_label("Error against time").rect();
    hand.wheel(plot.center(), -160.0);
    save(&mut hand, "cost-rows");

    let combos = hand.harness.get_all_by_role(Role::ComboBox);
    let list = combos.into_iter().find(|node| node.value().as_deref() == Some("Compare with")).unwrap().rect().center();
    hand.click(list);
    hand.settle();
    click_label(&mut hand, "Truth (f64)");
    save(&mut hand, "wipe-truth");
    click_label(&mut hand, "×256");
    save(&mut hand, "wipe-difference");

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.json");
    let broken = r##"{"name": "Broken", "nodes": [
        {"id": "facing", "kind": "facing", "at": [0, 0]},
        {"id": "broken", "kind": "wgsl", "at": [240, 0], "name": "Reciprocal",
         "values": {"code": "fn broken(value: f32) -> f32 { return 1.0 / (value - value); }"}},
        {"id": "mix", "kind": "mix_values", "at": [480, 0], "values": {"a": [0.2, 0.3, 0.5, 1], "b": [1, 0.8, 0.4, 1]}},
        {"id": "output", "kind": "output", "at": [720, 0]}],
        "wires": [{"from": "facing", "to": "broken.value"}, {"from": "broken", "to": "mix.factor"},
                  {"from": "mix", "to": "output.color"}]}"##;
    std::fs::write(&path, broken).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    click_label(&mut hand, "Probe");
    hand.key(eframe::egui::Key::I);
    let middle = hand.app().viewport().rect().unwrap().center();
    hand.click(middle);
    save(&mut hand, "probe-broken");

    let combos = hand.harness.get_all_by_role(Role::ComboBox);
    let list = combos.into_iter().find(|node| node.value().as_deref() == Some("Truth (f64)")).unwrap().rect().center();
    hand.click(list);
    hand.settle();
    click_label(&mut hand, "Nothing");
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    hand.click(middle);
    hand.settle();
    save(&mut hand, "probe-kept");
    hand.click(editor_support::node_center(&hand, "diffuse"));
    let list = hand.harness.get_by_role_and_label(Role::ComboBox, "View wire").rect().center();
    hand.click(list);
    hand.settle();
    let tone = hand.harness.get_all_by_label("Tone").last().unwrap().rect().center();
    hand.click(tone);
    hand.settle();
    click_label(&mut hand, "Isolines");
    save(&mut hand, "isolines");
}
