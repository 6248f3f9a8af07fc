//! The picture in the window, drawn by the renderer on the window's own device (software Vulkan does).
#![cfg(feature = "editor")]

mod editor_support;

use chiaro::editor::App;
use chiaro::render::{Gpu, block_on};
use editor_support::Hand;
use eframe::egui::vec2;
use egui_kittest::Harness;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};

/// A window that draws.
fn window() -> Hand {
    block_on(Gpu::headless()).expect("an adapter; software Vulkan does");
    let state = create_render_state(default_wgpu_setup(), eframe::egui_wgpu::RendererOptions::PREDICTABLE);
    let builder = Harness::builder().renderer(WgpuTestRenderer::from_render_state(state.clone()));
    Hand::with_builder(builder, move |ctx| App::new(ctx, Some(state.clone())))
}

/// The colours of a row through the middle of the picture.
fn middle_row(hand: &mut Hand) -> Vec<[u8; 4]> {
    let rect = hand.app().viewport().rect().unwrap();
    let image = hand.harness.render().unwrap();
    let y = rect.center().y as u32;
    (rect.min.x as u32 + 2..rect.max.x as u32 - 2).map(|x| image.get_pixel(x, y).0).collect()
}

#[test]
fn the_picture_shows_the_look_and_follows_the_hand() {
    let mut hand = window();
    let first = middle_row(&mut hand);
    let (edge, middle) = (first[0], first[first.len() / 2]);
    assert_ne!(edge, middle, "the object stands before the backdrop");

    // The illumination frame turns under the hand.
    let rect = hand.app().viewport().rect().unwrap();
    hand.drag(rect.center(), rect.center() + vec2(90.0, 0.0));
    hand.settle();
    let turned = middle_row(&mut hand);
    assert_ne!(first, turned);

    // A value is seen at once, by the live shader; the rest shows the baked one, and the picture stays what it is.
    let color = chiaro::document::Value::Vector(vec![0.1, 0.2, 0.9]);
    let graph = chiaro::document::GraphId::Look;
    let edit =
        chiaro::document::Edit::SetValue { graph, id: "base".into(), port: "color".into(), value: color, index: None };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.harness.step();
    hand.app().wait();
    hand.harness.step();
    let live = middle_row(&mut hand);
    assert_ne!(turned, live);
    hand.harness.run_steps(12);
    hand.settle();
    let baked = middle_row(&mut hand);
    let far = |a: &[u8; 4], b: &[u8; 4]| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 1);
    assert!(!live.iter().zip(&baked).any(|(a, b)| far(a, b)), "baked equals live within 1/255");

    // At rest nothing is drawn.
    let before = hand.app().pictures();
    hand.harness.run_steps(10);
    assert_eq!(hand.app().pictures(), before);
    assert_eq!(hand.repaint_delay(), std::time::Duration::MAX);
}

#[test]
fn the_last_good_picture_stays_while_the_look_is_broken() {
    let mut hand = window();
    let good = middle_row(&mut hand);
    let nothing = hand.empty_place();
    hand.drag(hand.input("output", "color"), nothing);
    hand.harness.remove_cursor();
    hand.settle();
    assert!(hand.app().canvas().has_error("output"));
    // The list of problems makes the viewport lower, so only what it shows is held, not where.
    let is_near = |color: &[u8; 4]| color.iter().zip(good[good.len() / 2]).all(|(a, b)| a.abs_diff(b) <= 6);
    assert!(middle_row(&mut hand).iter().any(is_near));
}

#[test]
fn the_look_is_seen_on_another_mesh_and_on_one_from_a_file() {
    let mut hand = window();
    let creature = middle_row(&mut hand);
    hand.app_mut().show_on("shape:torus");
    hand.settle();
    let torus = middle_row(&mut hand);
    assert_ne!(creature, torus);

    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("wedge.obj");
    std::fs::write(&file, "v -1 -1 0\nv 1 -1 0\nv 1 1 -1\nv -1 1 -1\nf 1 2 3 4\n").unwrap();
    hand.app_mut().show_on(&file.to_string_lossy());
    hand.settle();
    let wedge = middle_row(&mut hand);
    assert_ne!(torus, wedge);

    // A mesh that is not there is told of, and the last good picture stays.
    hand.app_mut().show_on("nowhere.obj");
    hand.settle();
    // The problem that is told makes the viewport lower, so only what it shows is held, not where.
    let shown = middle_row(&mut hand);
    assert_eq!(shown[shown.len() / 2], wedge[wedge.len() / 2]);
}
