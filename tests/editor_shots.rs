//! Pictures of the window, to be looked at: `cargo test --test editor_shots -- --ignored` writes them to
//! `target/shots`, or to the folder that `CHIARO_SHOTS` names.
#![cfg(feature = "editor")]

mod editor_support;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro::editor::App;
use chiaro::render::device_descriptor;
use editor_support::Hand;
use eframe::egui::{Theme, vec2};
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

/// The viewport's handles on every mesh of a folder that `CHIARO_MODELS` names, and on own shapes.
#[test]
#[ignore = "writes pictures to be looked at"]
fn viewport_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    let folder = std::env::var_os("CHIARO_MODELS").map(PathBuf::from);
    let own = ["shape:sphere".to_owned(), "shape:creature".to_owned()];
    let meshes = ["spot", "stanford-bunny", "nefertiti"];
    let of_folder = folder
        .iter()
        .flat_map(|folder| meshes.map(|mesh| folder.join(mesh).with_extension("obj").display().to_string()));
    let ids: Vec<_> = hand
        .look()
        .graph
        .nodes
        .iter()
        .filter(|(_, node)| node.kind == "light_layer")
        .map(|(id, _)| id.clone())
        .collect();
    for (number, mesh) in own.into_iter().chain(of_folder).enumerate() {
        hand.app_mut().show_on(&mesh);
        let id = ids[number % ids.len()].clone();
        hand.app_mut().session_mut().select(vec![id.clone()]);
        hand.settle();
        let rect = hand.app().viewport().rect().unwrap();
        hand.hover(rect.center() + vec2(30.0, 10.0));
        save(&mut hand, &format!("view-{number}-{id}"));
        if number % 2 == 1 {
            hand.harness.ctx.set_theme(Theme::Light);
        } else {
            hand.harness.ctx.set_theme(Theme::Dark);
        }
    }
}
