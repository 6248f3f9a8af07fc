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

fn click(hand: &mut Hand, label: &str) {
    let at = hand.harness.get_all_by_label(label).next().unwrap().rect().center();
    hand.click(at);
    hand.settle();
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn profile_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure5-directional.json"));
    hand.settle();
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    save(&mut hand, "profile-dark");
    click(&mut hand, "Profile preset Half-Lambert");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "profile-light");
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn keys_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure5-directional.json"));
    hand.settle();
    hand.app_mut().session_mut().select(vec!["back".into()]);
    click(&mut hand, "Direction keys");
    save(&mut hand, "keys-dark");
    click(&mut hand, "Select key 2");
    click(&mut hand, "Copy key");
    click(&mut hand, "Go to key");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "keys-light");
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn timeline_shots() {
    use chiaro::document::{Edit, Interpolation, Target, TimeKey, TimeKeys, Value};
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure6-comics.json"));
    hand.settle();
    let nodes: Vec<_> = hand.look().graph.nodes.iter().filter(|(_, node)| node.kind == "light_layer").collect();
    let id = nodes[0].0.clone();
    let track = |port: &str, keys: Vec<(f64, Value, Interpolation)>| Edit::AddTimeKeys {
        keys: TimeKeys {
            target: Target::parse(&format!("{id}.{port}")).unwrap(),
            keys: keys
                .into_iter()
                .map(|(time, value, interpolation)| TimeKey { time, value, interpolation, unknown: Default::default() })
                .collect(),
            unknown: Default::default(),
        },
        index: None,
    };
    let color = |r, g, b| Value::Vector(vec![r, g, b]);
    let (smooth, stepped, linear) = (Interpolation::Smooth, Interpolation::Stepped, Interpolation::Linear);
    for edit in [
        track(
            "cutoff",
            vec![
                (0.0, Value::Number(0.8), smooth),
                (1.5, Value::Number(2.4), smooth),
                (3.0, Value::Number(1.2), linear),
            ],
        ),
        track("convex", vec![(0.5, color(0.9, 0.5, 0.2), smooth), (2.5, color(0.3, 0.4, 0.9), smooth)]),
        track(
            "opacity",
            vec![
                (0.25, Value::Number(1.0), stepped),
                (1.0, Value::Number(0.5), stepped),
                (2.0, Value::Number(1.0), linear),
                (3.5, Value::Number(0.2), linear),
            ],
        ),
    ] {
        hand.app_mut().session_mut().apply(edit, None).unwrap();
    }
    hand.app_mut().session_mut().select(vec![id]);
    hand.settle();
    click(&mut hand, "View");
    let at = hand.harness.get_by_role_and_label(eframe::egui::Role::CheckBox, "Timeline").rect().center();
    hand.click(at);
    hand.settle();
    let at = hand.empty_place();
    hand.click(at);
    hand.settle();
    click(&mut hand, "Next key");
    save(&mut hand, "timeline-dark");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "timeline-light");
}
