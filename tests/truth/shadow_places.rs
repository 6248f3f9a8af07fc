//! Places of shadows: they begin where their casters stand, at any scale and in any tier, and their
//! edges move as steadily as their lights do.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use super::shadows::{
    EYE, SEEN, SIZE, TestLight, UNSEEN, box_of_12, floor, on_gpu, plain, scene_on_floor, shown,
};
use crate::support::eval::scene_of;
use chiaro::document::{Camera, Projection, Scene, Tier};
use chiaro::frame::{Setup, SetupLook};
use chiaro::geometry::Mesh;
use glam::{DMat4, DVec3};
use serde_json::json;

const TIERS: [Tier; 3] = [Tier::Exact, Tier::Balanced, Tier::Fast];

/// A look that shows the cast shadow of a light, in a tier.
fn cast(light: TestLight, tier: Tier) -> SetupLook {
    let mut look = shown("cast_shadow", "shadow", light, &json!({}));
    look.look.tier = Some(tier);
    look
}

/// A camera that looks straight down at a place, onto a square `SEEN` times as wide as `scale`.
fn straight_down(at: DVec3, scale: f64) -> Scene {
    let camera = Camera {
        eye: (at + 30.0 * scale * DVec3::Y).to_array(),
        target: at.to_array(),
        up: [0.0, 0.0, -1.0],
        projection: Projection::Orthographic,
        height: SEEN * scale,
        ..Camera::default()
    };
    Scene { backdrop: None, camera, ..Scene::default() }
}

/// A box of sides `scale` that stands on the floor, with its right side over the place.
fn standing(at: DVec3, scale: f64) -> (Mesh, DMat4) {
    let middle = at + scale * DVec3::new(-0.5, 0.5, 0.0);
    let sides = DMat4::from_scale(DVec3::splat(0.5 * scale));
    (box_of_12(), DMat4::from_translation(middle) * sides)
}

/// A floor of a look, and things on it that show nothing of a light.
fn on_floor(look: SetupLook, wide: f64, things: Vec<(Mesh, DMat4)>, scene: Scene) -> Setup {
    let (mesh, placed) = floor();
    let mut parts = vec![(look, mesh, DMat4::from_scale(DVec3::splat(wide)) * placed)];
    parts.extend(things.into_iter().map(|(mesh, placed)| (plain(), mesh, placed)));
    scene_of(parts, scene)
}

/// Pixels of the middle row to the right of the middle, where a box of sides 1 stands with its
/// right side over the middle: dark for as many pixels as its shadow is long, and lit beyond.
fn check_row(drawn: &[f64], length: f64, slack: usize, what: &str) {
    let side = SIZE as usize;
    let row = &drawn[side / 2 * side + side / 2..][..side / 2];
    let end = (length / SEEN * f64::from(SIZE)).round() as usize;
    let dark = row.iter().take_while(|share| **share > 0.99).count();
    let lit = row.iter().rev().take_while(|share| **share < 0.01).count();
    assert!(dark + slack >= end, "{what}: light from the {dark}th pixel on: {row:?}");
    assert!(lit + slack >= row.len() - end, "{what}: dark up to {lit} from the end: {row:?}");
}

/// No gap between what stands on a floor and its shadow, from a thimble to a city: a light at 45
/// degrees, whose shadow is as long as the box is high.
#[test]
fn shadows_begin_where_their_casters_stand() {
    for scale in [1e-3, 1.0, 1e4] {
        for light in [
            TestLight::Sun(DVec3::new(-1.0, 1.0, 0.0)),
            // On the way of the same sunlight past the box's upper edge.
            TestLight::Lamp(scale * DVec3::new(-3.0, 4.0, 0.0)),
        ] {
            for tier in TIERS {
                let things = vec![standing(DVec3::ZERO, scale)];
                let scene = straight_down(DVec3::ZERO, scale);
                let drawn = on_gpu(&on_floor(cast(light, tier), scale, things, scene));
                let slack = if tier == Tier::Exact { 0 } else { 1 };
                check_row(&drawn, 1.0, slack, &format!("{tier:?} {light:?} at {scale}"));
            }
        }
    }
}

/// A thimble at the foot of a tower: rays find the shadow of the one as that of the other, here and
/// far from the world's origin.
#[test]
fn a_thimble_in_a_city_has_its_shadow() {
    let light = TestLight::Sun(DVec3::new(-1.0, 1.0, 0.0));
    let thimble = 0.01;
    for at in [DVec3::ZERO, DVec3::new(30.0, 0.0, -20.0), DVec3::new(300.0, 0.0, 200.0)] {
        let tower = standing(DVec3::new(1800.0, 0.0, 0.0), 600.0);
        let things = vec![standing(at, thimble), tower];
        let scene = straight_down(at, thimble);
        let drawn = on_gpu(&on_floor(cast(light, Tier::Exact), 500.0, things, scene));
        // Places in f32 are a thirtieth of a pixel apart at most.
        check_row(&drawn, 1.0, 1, &format!("at {at}"));
    }
}

/// An edge moves by as much as its light lets it in each small step, along the rows of pixels and
/// across them. Maps leave its place uncertain by half a texel, and its steps steady all the same.
#[test]
fn edges_move_as_steadily_as_their_lights() {
    let pixel = SEEN / f64::from(SIZE);
    // A map of 256 texels, a little wider than a sphere that holds the box however it is scaled.
    let texel = 33.0 / 32.0 * 2.0 * 8.0 * 3.0_f64.sqrt() / 256.0;
    for (tier, is_lamp, degrees, steps, uncertain, most) in [
        (Tier::Exact, true, 20.0_f64, 16, 0.1 * pixel, 0.05),
        (Tier::Balanced, false, 0.0, 24, 0.5 * texel, 0.05),
        (Tier::Balanced, false, 20.0, 64, 0.5 * texel, 0.15),
    ] {
        let turned = DMat4::from_rotation_y(degrees.to_radians());
        let across = turned.transform_vector3(DVec3::X);
        let beside = DMat4::from_translation(UNSEEN * DVec3::Y - 4.0 * across)
            * turned
            * DMat4::from_scale(DVec3::new(4.0, 0.5, 8.0));
        let edge = (UNSEEN - 0.5) * DVec3::Y;
        let place = |moved: f64| {
            let light = match is_lamp {
                // Twice as high as the edge, so that its shadow moves as far as the lamp does.
                true => TestLight::Lamp(2.0 * edge - moved * across),
                false => TestLight::Sun(edge - moved * across),
            };
            let things = vec![(box_of_12(), beside)];
            let drawn = on_gpu(&scene_on_floor(cast(light, tier), things, EYE));
            // Half of what is seen is dark while the edge goes through its middle.
            let dark = drawn.iter().sum::<f64>() * pixel * pixel - 0.5 * SEEN * SEEN;
            dark / (SEEN / degrees.to_radians().cos())
        };
        let wanted = |step: i32| f64::from(step) * pixel / 30.0;
        let found: Vec<f64> = (0..steps).map(|step| place(wanted(step))).collect();
        let off = (0..).zip(&found).map(|(step, found)| (found - wanted(step)).abs());
        let off = off.fold(0.0, f64::max);
        let each = found.windows(2).map(|pair| (pair[1] - pair[0]) / pixel);
        let [least, greatest] = each
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], step| [a.min(step), b.max(step)]);
        println!("{tier:?} at {degrees}: off by {off:.4}, steps of {least:.4} to {greatest:.4}");
        assert!(off < uncertain, "{tier:?} at {degrees}: off by {off}, more than {uncertain}");
        assert!(least > 0.0 && greatest < most, "{tier:?} at {degrees}: {least} to {greatest}");
    }
}
