//! Outlines of scenes, drawn over the looks: coverage in f64, what lies in front, and when they are
//! drawn again.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use crate::support::eval::{look, renderer, scene_of, shape};
use crate::support::front::{PIXELS, SIZE, drawn, from_front, place, planned, share};
use chiaro::document::{Scene, SceneOutlines};
use chiaro::frame::{Setup, SetupLook};
use chiaro::library::PassId;
use chiaro::reference::Reference;
use glam::{DMat4, DVec2, DVec3};
use serde_json::json;

/// Width of lines, in pixels.
const WIDTH: f64 = 5.0;

fn white() -> SetupLook {
    look(&json!({"nodes": [
            {"id": "tone", "kind": "color_value", "values": {"color": [1.0, 1.0, 1.0, 1.0]}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "tone", "to": "output.color"}]}))
}

/// Black lines of [`WIDTH`] at silhouettes and where objects meet.
fn outlines() -> SceneOutlines {
    SceneOutlines {
        width: 1000.0 * WIDTH / f64::from(SIZE),
        color: [0.0, 0.0, 0.0, 1.0],
        creases: 0.0,
        ..SceneOutlines::default()
    }
}

/// A scene that is seen along the z axis without perspective, x to the right and y up, with a ball
/// of radius 1, and a wall in front of all that is left of `end` and its lower half.
fn scene(end: Option<f64>) -> Setup {
    let (ball, fitted) = shape("sphere");
    let (wall, _) = shape("plane");
    let mut parts = vec![(white(), ball, fitted)];
    if let Some(end) = end {
        let placed = DMat4::from_translation(DVec3::new(end - 10.0, 0.0, 2.0))
            * DMat4::from_scale(DVec3::splat(10.0));
        parts.push((white(), wall, placed));
    }
    scene_of(parts, Scene { outlines: outlines(), ..from_front() })
}

/// The share of a pixel that is within half a line of a radius.
fn ring(pixel: usize, radius: f64) -> f64 {
    share(pixel, &|at| (at.length() - radius).abs() <= 0.5 * WIDTH)
}

/// A line of a ball lies half on the ball and half beside it, where nothing was drawn.
#[test]
fn a_silhouette_is_drawn_on_both_sides() {
    for samples in [1, 4] {
        let plan = planned(&scene(None), samples);
        let picture = drawn(&mut *renderer(), &plan);
        let (mut sum, mut most, mut count) = (0.0, 0.0_f64, 0.0);
        for (pixel, color) in picture.rgba.iter().enumerate() {
            let at = place(pixel, DVec2::splat(0.5)).length();
            let truth = ring(pixel, PIXELS);
            let [tone, alpha] = [color[0], color[3]].map(f64::from);
            // Beside the ball a line is what there is; on the ball it darkens.
            let found = if at > PIXELS + 1.0 { alpha } else { 1.0 - tone };
            if (at - PIXELS).abs() < 1.0 {
                assert!(alpha > 0.99 && tone < 0.01, "{at}: {color:?} in the middle of the line");
                continue;
            }
            most = most.max((found - truth).abs());
            if truth > 0.0 && truth < 1.0 {
                (sum, count) = (sum + (found - truth).abs(), count + 1.0);
            }
        }
        println!("{samples} samples: mean {:.4}, most {most:.4}", sum / count);
        assert!(count > 200.0 && sum / count < 0.05 && most < 0.2, "{}, {most}", sum / count);
        let truth = drawn(&mut Reference::default(), &plan);
        let pairs = picture.rgba.iter().zip(&truth.rgba);
        let differs = |(a, b): &(&[f32; 4], &[f32; 4])| (0..4).any(|c| (a[c] - b[c]).abs() > 0.02);
        let differ = pairs.filter(differs).count();
        assert!(differ * 200 <= picture.rgba.len(), "{differ} pixels differ from the reference");
    }
}

/// No line of what lies behind is drawn over what lies in front.
#[test]
fn what_lies_in_front_hides_lines() {
    let picture = drawn(&mut *renderer(), &planned(&scene(Some(0.0)), 1));
    let (mut hidden, mut seen) = (0, 0);
    for (pixel, color) in picture.rgba.iter().enumerate() {
        let at = place(pixel, DVec2::splat(0.5));
        if at.x < -WIDTH {
            hidden += 1;
            assert!(color[0] > 0.99 && color[3] > 0.99, "{at}: {color:?} on the wall");
        } else if at.x.abs() < 0.5 * WIDTH - 1.0 {
            seen += 1;
            assert!(color[0] < 0.01 && color[3] > 0.99, "{at}: {color:?} at the wall's end");
        }
    }
    assert!(hidden > 1000 && seen > 200, "{hidden} on the wall, {seen} at its end");
}

/// Passes exist only where a scene draws lines; and a renderer that drew the scene before draws the
/// new lines alone.
#[test]
fn lines_are_drawn_only_where_a_scene_asks() {
    let mut setup = scene(Some(0.0));
    let passes =
        |setup: &Setup| planned(setup, 1).passes.iter().map(|pass| pass.id).collect::<Vec<_>>();
    let wanted = ["facets", "edges", "outlines"].map(PassId::named);
    assert_eq!(passes(&setup), [wanted.to_vec(), vec![PassId::LOOK]].concat());
    let mut executor = renderer();
    drawn(&mut *executor, &planned(&setup, 1));
    setup.scene.outlines.color = [1.0, 0.0, 0.0, 0.5];
    setup.scene.outlines.silhouettes = 0.4;
    let plan = planned(&setup, 1);
    assert_eq!(drawn(&mut *executor, &plan), drawn(&mut *renderer(), &plan));
    for off in [
        SceneOutlines::default(),
        SceneOutlines { color: [0.0; 4], ..outlines() },
        SceneOutlines {
            silhouettes: 0.0,
            borders: 0.0,
            material_borders: 0.0,
            id_borders: 0.0,
            ..outlines()
        },
    ] {
        setup.scene.outlines = off;
        assert_eq!(passes(&setup), [PassId::LOOK], "{off:?}");
    }
    setup.scene.outlines = outlines();
    setup.objects.clear();
    assert_eq!(passes(&setup), [PassId::LOOK]);
}
