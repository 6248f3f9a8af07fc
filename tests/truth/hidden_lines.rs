//! Hidden lines: edges of what lies behind the first surface, drawn by that surface.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::{Camera, Projection, Scene};
use chiaro::frame::{Executor, FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::{Library, PassId};
use chiaro::progress::Progress;
use chiaro::reference::Reference;
use glam::{DMat4, DVec2, DVec3};
use serde_json::json;

/// Width and height of the pictures.
const SIZE: u32 = 128;

/// Pixels to a unit of the scene.
const PIXELS: f64 = SIZE as f64 / 4.0;

fn hidden(width: f64) -> SetupLook {
    look(&json!({"nodes": [
            {"id": "lines", "kind": "hidden_lines", "values": {"unit": "pixels", "width": width}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "lines", "to": "output.color"}]}))
}

/// A ball of radius 1 behind a wall that ends at `end` on the right, from the front and without
/// perspective.
fn ball_behind_wall(width: f64, end: f64) -> Setup {
    let camera = Camera {
        eye: [0.0, 0.0, 10.0],
        target: [0.0; 3],
        height: 4.0,
        projection: Projection::Orthographic,
        ..Camera::default()
    };
    let (ball, fitted) = shape("sphere");
    let (wall, _) = shape("plane");
    let placed = DMat4::from_translation(DVec3::new(end - 10.0, 0.0, 2.0))
        * DMat4::from_scale(DVec3::splat(10.0));
    scene_of(
        vec![(hidden(width), wall, placed), (hidden(width), ball, fitted)],
        Scene { backdrop: None, camera, ..Scene::default() },
    )
}

fn planned(setup: &Setup, samples: u32) -> FramePlan {
    let options = PlanOptions { size: [SIZE; 2], samples, time: 0.0 };
    let planned = Planner::default().plan(setup, Library::built_in(), &Live::Keyed, &options);
    planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
}

fn drawn(executor: &mut dyn Executor, setup: &Setup) -> Vec<Option<f64>> {
    let picture = block_on(executor.picture(&planned(setup, 1), &Progress::new()));
    let picture = picture.unwrap_or_else(|error| panic!("{}: {error}", executor.name()));
    picture.rgba.iter().map(|pixel| (pixel[3] > 0.5).then(|| f64::from(pixel[0]))).collect()
}

/// A place in pixels from the picture's middle, y up, from a pixel and a place within.
fn place(pixel: usize, within: DVec2) -> DVec2 {
    let at = DVec2::new((pixel % SIZE as usize) as f64, (pixel / SIZE as usize) as f64) + within;
    let middle = 0.5 * f64::from(SIZE);
    DVec2::new(at.x - middle, middle - at.y)
}

/// The share of a pixel that a ring of so many pixels around the radius 1 covers.
fn ring(pixel: usize, width: f64) -> f64 {
    const SIDE: usize = 16;
    let is_line = |index: &usize| {
        let within = DVec2::new((index % SIDE) as f64, (index / SIDE) as f64);
        let from_middle = place(pixel, (within + 0.5) / SIDE as f64).length();
        (from_middle - PIXELS).abs() <= 0.5 * width
    };
    (0..SIDE * SIDE).filter(is_line).count() as f64 / (SIDE * SIDE) as f64
}

/// The wall shows the ball behind it as a ring, placed within the pixel.
#[test]
fn a_wall_shows_the_ball_behind_it() {
    let width = 3.0;
    let setup = ball_behind_wall(width, 10.0);
    let found = drawn(&mut *renderer(), &setup);
    let (mut sum, mut most, mut count) = (0.0, 0.0_f64, 0.0);
    for (pixel, found) in found.iter().enumerate() {
        let truth = ring(pixel, width);
        let error = (found.expect("the wall") - truth).abs();
        most = most.max(error);
        if truth > 0.0 && truth < 1.0 {
            (sum, count) = (sum + error, count + 1.0);
        }
    }
    println!("a ring behind a wall: mean {:.4}, most {most:.4}", sum / count);
    assert!(count > 200.0 && sum / count < 0.05 && most < 0.2, "{}, {most}", sum / count);
    let truth = drawn(&mut Reference::default(), &setup);
    let differs = |(a, b): &(&Option<f64>, &Option<f64>)| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() > 0.02,
        _ => a.is_some() != b.is_some(),
    };
    let differ = found.iter().zip(&truth).filter(differs).count();
    assert!(differ * 1000 <= found.len(), "{differ} pixels differ from the reference");
}

/// No end of the ball where it comes out from behind the wall, and no hidden line where it is seen.
#[test]
fn what_comes_out_does_not_end() {
    let found = drawn(&mut *renderer(), &ball_behind_wall(3.0, 0.0));
    let (mut beside, mut on) = (0, 0);
    for (pixel, found) in found.iter().enumerate() {
        let at = place(pixel, DVec2::splat(0.5));
        let Some(found) = *found else { continue };
        if at.length() < PIXELS - 6.0 {
            beside += 1;
            assert!(found < 0.01, "{at}: a line of {found} within the ball");
        } else if at.x > 2.0 {
            assert!(found < 0.01, "{at}: {found} on the ball itself");
        } else if at.x < -2.0 && ring(pixel, 3.0) == 1.0 {
            on += 1;
            assert!(found > 0.9, "{at}: {found} on the hidden line");
        }
    }
    assert!(beside > 500 && on > 50, "{beside} within, {on} on the line");
}

/// The passes exist only where a look asks, and none of the others'.
#[test]
fn passes_of_hidden_lines_exist_only_while_asked_for() {
    let slugs = ["facets", "hidden_facets", "hidden_edges", "hidden_columns", "hidden_nearness"];
    let wanted: Vec<PassId> = slugs.map(PassId::named).into_iter().chain([PassId::LOOK]).collect();
    let passes =
        |setup: &Setup| planned(setup, 4).passes.iter().map(|pass| pass.id).collect::<Vec<_>>();
    let mut setup = ball_behind_wall(3.0, 0.0);
    assert_eq!(passes(&setup), wanted);
    let unread = look(&json!({"nodes": [{"id": "lines", "kind": "hidden_lines"},
            {"id": "tone", "kind": "color_value"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "tone", "to": "output.color"}]}));
    setup.looks.iter_mut().for_each(|look| look.clone_from(&unread));
    assert_eq!(passes(&setup), [PassId::LOOK]);
}
