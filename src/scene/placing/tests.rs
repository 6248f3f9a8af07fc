//! Lights that were placed, measured by the formulas of the paper as it writes them: arc cosines of
//! plain vectors, and the profile by its cosines and its power.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use glam::{DMat3, DQuat, DVec3};

use super::*;
use crate::document::{LightSpace, ObjectFrame};

const ALL: [Parametrization; 4] = [
    Parametrization::Diffuse,
    Parametrization::Specular,
    Parametrization::ScreenAligned,
    Parametrization::HalfVector,
];
const KINDS: [LightKind; 3] = [LightKind::Directional, LightKind::Point, LightKind::Spot];
const SPACES: [LightSpace; 4] =
    [LightSpace::Illumination, LightSpace::World, LightSpace::Camera, LightSpace::Object];

fn point() -> SurfacePoint {
    let normal = DVec3::new(0.3, 0.5, 0.8).normalize();
    SurfacePoint {
        position: DVec3::new(0.4, -0.2, 1.1),
        normal,
        toward_eye: DVec3::new(-0.2, 0.1, 0.9).normalize(),
        camera_from_world: DMat3::from_quat(DQuat::from_rotation_y(0.3)),
    }
}

fn frames() -> LightFrames {
    LightFrames {
        illumination: DQuat::from_rotation_x(0.7) * DQuat::from_rotation_y(-0.4),
        camera_from_world: point().camera_from_world,
        object: ObjectFrame {
            center: DVec3::new(0.5, 1.5, -0.3),
            turn: DQuat::from_rotation_z(1.1),
        },
        aims: Default::default(),
    }
}

fn lights() -> impl Iterator<Item = Light> {
    KINDS.into_iter().flat_map(|kind| SPACES.map(|space| (kind, space))).map(|(kind, space)| {
        Light {
            kind,
            space,
            direction: [0.7, 0.9, -0.5],
            position: [1.5, 2.0, 2.5],
            aim: [-0.4, -0.5, -0.6],
            outer: 0.6,
            ..Light::default()
        }
    })
}

/// Matrix and origin of a light's own frame.
fn world_from_own(space: LightSpace) -> (DMat3, DVec3) {
    let frames = frames();
    match space {
        LightSpace::Illumination => (DMat3::from_quat(frames.illumination), DVec3::ZERO),
        LightSpace::World => (DMat3::IDENTITY, DVec3::ZERO),
        LightSpace::Camera => (frames.camera_from_world.inverse(), DVec3::ZERO),
        LightSpace::Object => (DMat3::from_quat(frames.object.turn), frames.object.center),
    }
}

/// Direction toward a light, and its distance.
fn toward(light: &Light) -> (DVec3, f64) {
    let (turn, origin) = world_from_own(light.space);
    let offset = match light.kind {
        LightKind::Directional => turn * DVec3::from(light.direction),
        _ => origin + turn * DVec3::from(light.position) - point().position,
    };
    (offset.normalize(), offset.length())
}

/// Angle of a parametrization, in radians.
fn measured(parametrization: Parametrization, light: &Light) -> f64 {
    let SurfacePoint { normal, toward_eye, camera_from_world, .. } = point();
    let (l, _) = toward(light);
    let cosine = match parametrization {
        Parametrization::Diffuse => normal.dot(l),
        // The mirrored light against the eye is the mirrored eye against the light.
        Parametrization::Specular => (2.0 * normal.dot(l) * normal - l).dot(toward_eye),
        Parametrization::HalfVector => normal.dot((l + toward_eye).normalize()),
        Parametrization::ScreenAligned => {
            let own = world_from_own(light.space).0.inverse() * l;
            (camera_from_world * normal).dot(own)
        }
    };
    cosine.clamp(-1.0, 1.0).acos()
}

/// The profile as the paper writes it.
fn tone(u: f64, [offset, falloff, cutoff]: [f64; 3]) -> f64 {
    let (c, f) = (cutoff - offset, falloff - offset);
    let beta = -c.cos() / (1.0 - c.cos());
    let gamma = (1.0 - c.cos() * f.cos()) / f.sin().powi(2);
    if u <= offset { 1.0 } else { (beta + (1.0 - beta) * (u - offset).cos()).max(0.0).powf(gamma) }
}

#[test]
fn a_profile_has_fallen_to_a_half_at_its_terminator() {
    let shapes = [
        [0.0, FRAC_PI_2, FRAC_PI_2],
        [0.0, FRAC_PI_2, 3.0],
        [0.0, 0.3, FRAC_PI_2],
        [0.05, 1.3, 1.9],
        [0.4, 0.45, 0.5],
        [0.0, 0.02, 1.2],
        [1.0, 2.0, 2.8],
    ];
    for shape in shapes {
        let u = terminator_angle(shape[0], shape[1], shape[2]).unwrap();
        assert!((tone(u, shape) - 0.5).abs() < 1e-9, "{shape:?}: {}", tone(u, shape));
    }
    let [lambert, half_lambert] =
        [FRAC_PI_2, PI].map(|cutoff| terminator_angle(0.0, FRAC_PI_2, cutoff).unwrap());
    assert!((lambert - PI / 3.0).abs() < 1e-12 && (half_lambert - FRAC_PI_2).abs() < 1e-12);
    // Edges of hard profiles, in whichever order their angles are written.
    assert_eq!(terminator_angle(FRAC_PI_4, FRAC_PI_4, FRAC_PI_4), Some(FRAC_PI_4));
    assert_eq!(terminator_angle(0.5, 0.5, 1.0), Some(0.5));
    assert_eq!(terminator_angle(0.7, 0.1, 0.2), Some(0.7));
    assert!((terminator_angle(0.0, PI, PI).unwrap() - FRAC_PI_2).abs() < 1e-12);
    // Ambient ones have none.
    assert_eq!(terminator_angle(PI, PI, PI), None);
    assert_eq!(terminator_angle(PI - 2e-6, 3.2, 3.2), None);
    assert_eq!(terminator_angle(f64::NAN, 0.0, 0.0), Some(0.0));
}

#[test]
fn the_angle_at_the_point_is_the_one_that_was_asked_for() {
    for light in lights() {
        let (was, distance) = toward(&light);
        for parametrization in ALL {
            for angle in [0.0, 0.02, 0.5, 1.2] {
                let goal = PlacingGoal::Angle(parametrization, angle);
                let placed = place_light(&light, &frames(), &point(), &goal).unwrap();
                let found = measured(parametrization, &placed.light);
                // The arc cosine of the check loses half of the digits near 0.
                assert!((found - angle).abs() < 1e-6, "{parametrization:?} {angle}: {found}");
                let (now, far) = toward(&placed.light);
                if light.kind != LightKind::Directional {
                    assert!((far - distance).abs() < 1e-6, "at its distance");
                    assert_eq!(placed.kept, Some(KeptDistance::FromPoint));
                }
                // No light of that angle is nearer to the present one than the one that was found.
                let own = world_from_own(light.space).0.inverse();
                for step in 0..400 {
                    let tilt = DQuat::from_rotation_arc(DVec3::Z, now);
                    let aside = f64::from(step).mul_add(0.0157, 0.0);
                    let near = tilt * DVec3::new(0.05 * aside.cos(), 0.05 * aside.sin(), 1.0);
                    let near = near.normalize();
                    let other = Light {
                        kind: LightKind::Directional,
                        direction: (own * near).to_array(),
                        ..light.clone()
                    };
                    let off = (measured(parametrization, &other) - angle).abs();
                    assert!(off > 1e-3 || near.dot(was) <= now.dot(was) + 1e-3);
                }
            }
        }
    }
}

#[test]
fn a_shadow_lies_on_the_line_from_the_light_through_its_caster() {
    let at = point();
    for (caster, kept) in [
        (at.position + DVec3::new(0.2, 0.5, 0.4), KeptDistance::FromPoint),
        (at.position + DVec3::new(3.0, 4.0, 9.0), KeptDistance::FromCaster),
    ] {
        for light in lights() {
            let (_, before) = toward(&light);
            let goal = PlacingGoal::Shadow(caster);
            let placed = place_light(&light, &frames(), &at, &goal).unwrap();
            let (l, distance) = toward(&placed.light);
            let line = (caster - at.position).normalize();
            assert!(l.cross(line).length() < 1e-7 && l.dot(line) > 0.0, "on the line");
            if light.kind == LightKind::Directional {
                assert_eq!(placed.kept, None);
                continue;
            }
            assert_eq!(placed.kept, Some(kept));
            let gap = caster.distance(at.position);
            assert!(distance > gap, "beyond the caster: {distance}");
            if kept == KeptDistance::FromPoint {
                assert!((distance - before).abs() < 1e-6);
            }
        }
    }
}

#[test]
fn a_point_keeps_its_place_in_the_cone_of_a_spot() {
    let at = point();
    let in_cone = |light: &Light| {
        let (turn, _) = world_from_own(light.space);
        (turn * DVec3::from(light.aim)).normalize().dot(-toward(light).0).acos()
    };
    for space in SPACES {
        let (turn, origin) = world_from_own(space);
        let inward = turn.inverse();
        let stand = at.position + DVec3::new(0.0, 2.0, 1.0);
        let aimed = |aim: DVec3| Light {
            kind: LightKind::Spot,
            space,
            position: (inward * (stand - origin)).to_array(),
            aim: (inward * aim).to_array(),
            outer: 0.6,
            ..Light::default()
        };
        let goal = PlacingGoal::Angle(Parametrization::Diffuse, 0.4);
        let near = aimed(at.position - stand + DVec3::new(0.3, 0.0, 0.0));
        let placed = place_light(&near, &frames(), &at, &goal).unwrap();
        assert!(!placed.is_aimed && (in_cone(&placed.light) - in_cone(&near)).abs() < 1e-6);
        let past = aimed(DVec3::Y);
        let placed = place_light(&past, &frames(), &at, &goal).unwrap();
        assert!(placed.is_aimed && in_cone(&placed.light) < 1e-6);
    }
}

#[test]
fn what_is_impossible_says_why() {
    let at = point();
    let light = Light::default();
    let place = |light: &Light, at: &SurfacePoint, goal| place_light(light, &frames(), at, &goal);
    let behind = SurfacePoint { toward_eye: -at.normal, ..at };
    let highlight = PlacingGoal::Angle(Parametrization::Specular, 0.0);
    assert_eq!(place(&light, &behind, highlight), Err(PlacingObstacle::TurnedFromEye));
    let below = PlacingGoal::Shadow(at.position - at.normal);
    assert_eq!(place(&light, &at, below), Err(PlacingObstacle::TurnedFromCaster));
    let same = PlacingGoal::Shadow(at.position);
    assert_eq!(place(&light, &at, same), Err(PlacingObstacle::SamePlace));
    let lamp = Light {
        kind: LightKind::Point,
        space: LightSpace::World,
        position: at.position.to_array(),
        ..Light::default()
    };
    assert_eq!(place(&lamp, &at, highlight), Err(PlacingObstacle::LampOnPoint));
    let far = PlacingGoal::Angle(Parametrization::HalfVector, 3.0);
    assert_eq!(place(&light, &at, far), Err(PlacingObstacle::NoSuchAngle));
}

/// A light that is aimed at an object moves about it, and has the angle all the same.
#[test]
fn a_light_that_is_aimed_at_an_object_stays_so() {
    let target = DVec3::new(0.3, -0.2, 0.4);
    let frames = LightFrames {
        aims: std::sync::Arc::new([("hero".into(), target)].into_iter().collect()),
        ..frames()
    };
    for light in lights().filter(|light| light.kind != LightKind::Point) {
        let light = Light { aimed_at: Some("hero".into()), ..light };
        let goal = PlacingGoal::Angle(Parametrization::Diffuse, 0.5);
        let placed = place_light(&light, &frames, &point(), &goal).unwrap().light;
        assert_eq!(placed.aimed_at, light.aimed_at);
        assert_eq!((placed.aim, placed.direction), (light.aim, light.direction));
        let [before, after] = [&light, &placed].map(|light| LightValues::new(light, &frames));
        let toward = match light.kind {
            LightKind::Directional => after.direction(),
            _ => (after.position() - point().position).normalize(),
        };
        assert!((point().normal.dot(toward).acos() - 0.5).abs() < 1e-7, "{light:?}");
        if light.kind == LightKind::Directional {
            let around = |values: &LightValues| values.position().distance(target);
            assert!((around(&before) - around(&after)).abs() < 1e-7, "{light:?}");
        }
    }
}
