//! Hidden lines: edges of what lies behind the first surface, drawn by that surface.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use crate::support::eval::{look, renderer, scene_of, shape};
use crate::support::front::{PIXELS, drawn, first_numbers, from_front, place, planned, share};
use chiaro::frame::{Executor, Setup, SetupLook};
use chiaro::library::PassId;
use chiaro::reference::Reference;
use glam::{DMat4, DVec2, DVec3};
use serde_json::json;

fn hidden(width: f64) -> SetupLook {
    look(&json!({"nodes": [
            {"id": "lines", "kind": "hidden_lines", "values": {"unit": "pixels", "width": width}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "lines", "to": "output.color"}]}))
}

/// A ball of radius 1 behind a wall that ends at `end` on the right, from the front and without
/// perspective.
fn ball_behind_wall(width: f64, end: f64) -> Setup {
    let (ball, fitted) = shape("sphere");
    let (wall, _) = shape("plane");
    let placed = DMat4::from_translation(DVec3::new(end - 10.0, 0.0, 2.0))
        * DMat4::from_scale(DVec3::splat(10.0));
    scene_of(vec![(hidden(width), wall, placed), (hidden(width), ball, fitted)], from_front())
}

/// The first number of each pixel that shows anything.
fn numbers(executor: &mut dyn Executor, setup: &Setup) -> Vec<Option<f64>> {
    first_numbers(&drawn(executor, &planned(setup, 1)))
}

/// The share of a pixel that a ring of so many pixels around the radius 1 covers.
fn ring(pixel: usize, width: f64) -> f64 {
    share(pixel, &|at| (at.length() - PIXELS).abs() <= 0.5 * width)
}

/// The wall shows the ball behind it as a ring, placed within the pixel.
#[test]
fn a_wall_shows_the_ball_behind_it() {
    let width = 3.0;
    let setup = ball_behind_wall(width, 10.0);
    let found = numbers(&mut *renderer(), &setup);
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
    let truth = numbers(&mut Reference::default(), &setup);
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
    let found = numbers(&mut *renderer(), &ball_behind_wall(3.0, 0.0));
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
