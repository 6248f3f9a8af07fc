//! Looks that are drawn over the picture: the same picture as drawn triangle by triangle, and a
//! plan that says when and why not.
#![cfg(feature = "gpu")]

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::examples::looks;
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::{Camera, Projection, Scene, Tier};
use chiaro::frame::{FramePlan, PassId, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::Library;
use chiaro::render::Renderer;
use glam::{DMat4, DVec3};
use serde_json::json;

/// Largest difference of a channel, 1 for its whole range. Places between a triangle's corners are
/// rounded otherwise than a rasterizer rounds them.
const BOUND: f32 = 0.5 / 255.0;

fn planned(setup: &Setup, size: [u32; 2], samples: u32) -> FramePlan {
    let options = PlanOptions { size, samples, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn reason(plan: &FramePlan) -> String {
    let pass = plan.passes.iter().find(|pass| pass.id == PassId::LOOK);
    pass.map(|pass| pass.reason.clone()).unwrap_or_default()
}

/// The number of pixels that differ by more than the bound, the largest difference, and the number
/// of pixels that show anything.
fn differences(renderer: &mut Renderer, plan: &FramePlan) -> (usize, f32, usize) {
    let forward = plan.forward();
    assert!(plan.deferral.is_ok() && forward.deferral.is_err());
    let [over, by_triangles] =
        [plan, &forward].map(|plan| block_on(renderer.picture(plan)).expect("it draws"));
    let (mut beyond, mut most, mut shown) = (0, 0.0_f32, 0);
    for (one, other) in over.rgba.iter().zip(&by_triangles.rgba) {
        shown += usize::from(one[3] > 0.0);
        let channels = one.iter().zip(other);
        let difference = channels.map(|(one, other)| (one - other).abs()).fold(0.0, f32::max);
        beyond += usize::from(difference > BOUND);
        most = most.max(difference);
    }
    (beyond, most, shown)
}

/// A scene of one object that wears a look.
fn worn(look: SetupLook, mesh: &str) -> Setup {
    let (mesh, fitted) = shape(mesh);
    let camera = Camera { eye: [0.6, 0.8, 2.9], ..Camera::default() };
    scene_of(vec![(look, mesh, fitted)], Scene { camera, ..Scene::default() })
}

/// Every example look that may be is drawn over the picture, and as it is drawn triangle by
/// triangle: on a mesh of small triangles, whose quads are mostly of several, and on one with
/// creases.
#[test]
fn example_looks_are_the_same_picture() {
    let mut renderer = Renderer::new(renderer().gpu().precise());
    let (mut drawn, mut left) = (0, Vec::new());
    for (name, look) in looks() {
        for tier in [Some(Tier::Exact), None] {
            let mut look = look.clone();
            look.look.tier = tier;
            let mesh = if tier.is_some() { "creature" } else { "knot" };
            let plan = planned(&worn(look, mesh), [240, 180], 1);
            match &plan.deferral {
                Ok(_) => {
                    assert!(reason(&plan).contains("once a pixel"), "{}", reason(&plan));
                    let (beyond, most, shown) = differences(&mut renderer, &plan);
                    assert!(shown > 5_000, "{name} on the {mesh}: {shown} pixels");
                    assert_eq!(beyond, 0, "{name} on the {mesh}: most {most}");
                    drawn += 1;
                }
                Err(why) if why.is_empty() => {}
                Err(why) => {
                    assert!(reason(&plan).contains(why.as_str()), "{}", reason(&plan));
                    left.push(format!("{name} on the {mesh}: {why}"));
                }
            }
        }
    }
    assert!(drawn > 40, "only {drawn}: {left:#?}");
}

/// A look of curvature, UVs with their derivatives, tangents and places in the object's space.
fn searching() -> SetupLook {
    look(&json!({"name": "searching", "nodes": [
        {"id": "kappa", "kind": "kappa"},
        {"id": "transition", "kind": "transition"},
        {"id": "squares", "kind": "checker", "values": {
            "scale": 6, "color_a": [0.9, 0.6, 0.2, 1], "color_b": [0.1, 0.2, 0.5, 1]}},
        {"id": "frame", "kind": "tangent_frame"},
        {"id": "along", "kind": "dot_product", "values": {"b": [0.2, 0.5, 0.3]}},
        {"id": "one", "kind": "mix_colors", "values": {"b": [1, 1, 1, 1]}},
        {"id": "two", "kind": "mix_colors", "values": {"b": [0, 0, 0, 1]}},
        {"id": "solid", "kind": "set_alpha", "values": {"alpha": 1}},
        {"id": "output", "kind": "output"}
    ], "wires": [
        {"from": "kappa", "to": "transition.kappa"},
        {"from": "squares", "to": "one.a"}, {"from": "transition", "to": "one.factor"},
        {"from": "frame.tangent", "to": "along.a"},
        {"from": "one", "to": "two.a"}, {"from": "along", "to": "two.factor"},
        {"from": "two", "to": "solid.color"}, {"from": "solid", "to": "output.color"}
    ]}))
}

#[test]
fn several_objects_turned_mirrored_and_seen_from_within_are_the_same_picture() {
    let mut renderer = Renderer::new(renderer().gpu().precise());
    let (knot, fitted) = shape("knot");
    let (creature, whole) = shape("creature");
    for projection in [Projection::Perspective, Projection::Orthographic] {
        let at = |x: f64, scale: DVec3| {
            DMat4::from_translation(DVec3::X * x)
                * DMat4::from_scale(scale)
                * DMat4::from_rotation_y(x)
        };
        let parts = vec![
            (searching(), knot.clone(), at(-1.2, DVec3::splat(0.8)) * fitted),
            // A mirrored one, in front of another.
            (searching(), creature.clone(), at(0.4, DVec3::new(-1.0, 1.0, 0.6)) * whole),
            (searching(), creature.clone(), at(0.9, DVec3::splat(0.7)) * whole),
        ];
        let camera = Camera {
            eye: [0.3, 0.5, 4.0],
            target: [0.0; 3],
            projection,
            height: 3.0,
            ..Camera::default()
        };
        let setup = scene_of(parts, Scene { camera, ..Scene::default() });
        let plan = planned(&setup, [240, 180], 1);
        assert!(plan.deferral.is_ok(), "{}", reason(&plan));
        assert_eq!(plan.draws.len(), 3);
        let (beyond, most, shown) = differences(&mut renderer, &plan);
        assert!(shown > 5_000 && beyond == 0, "{beyond} of {shown}, most {most}");
    }
}

#[test]
fn a_plan_says_why_looks_are_drawn_triangle_by_triangle() {
    let plan = planned(&worn(searching(), "creature"), [240, 180], 4);
    assert!(reason(&plan).ends_with("a pixel has 4 samples"), "{}", reason(&plan));
    let plan = planned(&worn(searching(), "creature"), [4800, 3600], 1);
    assert!(reason(&plan).contains("it is quicker"), "{}", reason(&plan));
    let flat = look(&json!({"nodes": [
        {"id": "facing", "kind": "facing"}, {"id": "output", "kind": "output"}
    ], "wires": [{"from": "facing", "to": "output.color"}]}));
    let plan = planned(&worn(flat, "creature"), [240, 180], 1);
    assert_eq!(reason(&plan), "it is the picture", "nothing is drawn that it could be drawn over");
    let clear = look(&json!({"nodes": [
        {"id": "kappa", "kind": "kappa"},
        {"id": "thin", "kind": "set_alpha", "values": {"alpha": 0.4}},
        {"id": "output", "kind": "output"}
    ], "wires": [{"from": "kappa", "to": "thin.color"}, {"from": "thin", "to": "output.color"}]}));
    let plan = planned(&worn(clear, "creature"), [240, 180], 1);
    assert!(reason(&plan).contains("transparent"), "{}", reason(&plan));
}

/// A renderer that drew a plan in one way draws it in the other, too, and then rests.
#[test]
fn both_ways_take_turns_on_one_renderer() {
    let mut renderer = Renderer::new(renderer().gpu().clone());
    let plan = planned(&worn(searching(), "creature"), [120, 90], 1);
    let ran = |renderer: &mut Renderer, plan: &FramePlan| {
        block_on(renderer.draw(plan)).expect("it draws").len()
    };
    let all = plan.passes.len();
    assert_eq!(ran(&mut renderer, &plan), all);
    assert_eq!(ran(&mut renderer, &plan), 0, "nothing changed");
    assert!(ran(&mut renderer, &plan.forward()) >= 2);
    assert_eq!(ran(&mut renderer, &plan.forward()), 0);
    assert!(ran(&mut renderer, &plan) >= 2);
}
