//! The handles on the object, driven by the pointer: lines and lights lie where the layer's own
//! formulas say.

use crate::editor_support::{User, node_center};
use chiaro::document::Value;
use eframe::egui::{Key, Modifiers, Pos2, Rect, pos2, vec2};
use glam::DVec3;

/// A window with a new look on a ball, its layer selected.
fn on_ball() -> User {
    let mut hand = User::new();
    hand.app_mut().show_on("shape:sphere");
    hand.click(node_center(&hand, "diffuse"));
    hand.key(Key::Escape);
    hand.settle();
    hand
}

fn rect(hand: &User) -> Rect {
    hand.app().viewport().rect().unwrap()
}

fn number(hand: &User, port: &str) -> Option<f64> {
    match hand.look().graph.nodes["diffuse"].values.get(port) {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    }
}

/// Normal of the unit ball at a point of the screen, by intersecting the point's ray with the ball.
fn normal_at(hand: &User, at: Pos2) -> Option<DVec3> {
    let (rect, orbit) = (rect(hand), hand.app().session().view().orbit());
    let offset = (at - rect.center()) / rect.height();
    let (right, up) = orbit.right_and_up();
    let eye = orbit.target + orbit.direction() * orbit.distance;
    let tangent = 2.0 * (orbit.fov / 2.0).tan();
    let ray = right * f64::from(offset.x) * tangent
        - up * f64::from(offset.y) * tangent
        - orbit.direction();
    let ray = ray.normalize();
    let along = -eye.dot(ray);
    let half = 1.0 - (eye.length_squared() - along * along);
    (half > 0.0).then(|| eye + ray * (along - half.sqrt()))
}

/// Point of the screen at which the ball has a normal.
fn screen_at(hand: &User, normal: DVec3) -> Pos2 {
    let (rect, orbit) = (rect(hand), hand.app().session().view().orbit());
    let (right, up) = orbit.right_and_up();
    let eye = orbit.target + orbit.direction() * orbit.distance;
    let from_eye = normal - eye;
    let scale = f64::from(rect.height())
        / (2.0 * -from_eye.dot(orbit.direction()) * (orbit.fov / 2.0).tan());
    rect.center() + vec2((from_eye.dot(right) * scale) as f32, -(from_eye.dot(up) * scale) as f32)
}

fn light(hand: &User) -> DVec3 {
    let look = hand.look();
    (hand.app().session().view().orbit().illumination * DVec3::from(look.lights["key"].direction))
        .normalize()
}

/// A point of a line, well inside of the picture and away from other handles.
fn grip(hand: &User, port: &str) -> Pos2 {
    let points = hand.app().viewport().curve(port);
    let center = rect(hand).center();
    let inner = points.into_iter().min_by(|a, b| a.distance(center).total_cmp(&b.distance(center)));
    inner.expect("the line is seen")
}

#[test]
fn lines_lie_where_the_angle_is() {
    let hand = on_ball();
    let l = light(&hand);
    let points = hand.app().viewport().curve("cutoff");
    assert!(points.len() > 50, "{}", points.len());
    for at in points {
        let normal = normal_at(&hand, at).expect("on the ball");
        let angle = normal.angle_between(l);
        // The grid of the line is a pixel or two wide; at the rim a pixel is several degrees.
        let facing = normal.dot(hand.app().session().view().orbit().direction());
        if facing > 0.25 {
            assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 0.01, "{angle} at {at}");
        }
    }
}

#[test]
fn a_line_follows_the_pointer_and_a_gesture_is_one_step() {
    let mut hand = on_ball();
    // A Lambert layer's fall-off and cut-off coincide, and their lines move together.
    let from = grip(&hand, "cutoff");
    let l = light(&hand);
    let to = screen_at(&hand, normal_at(&hand, from).unwrap().lerp(l, 0.3).normalize());
    hand.drag(from, to);
    let wanted = normal_at(&hand, to).unwrap().angle_between(l);
    let (falloff, cutoff) = (number(&hand, "falloff").unwrap(), number(&hand, "cutoff").unwrap());
    assert!((cutoff - wanted).abs() < 0.004, "{cutoff} for {wanted}");
    assert_eq!(falloff, cutoff);
    hand.settle();
    let nearest = hand
        .app()
        .viewport()
        .curve("cutoff")
        .iter()
        .map(|p| p.distance(to))
        .fold(f32::INFINITY, f32::min);
    assert!(nearest < 1.5, "the line is under the pointer: {nearest}");
    hand.undo();
    assert_eq!((number(&hand, "falloff"), number(&hand, "cutoff")), (None, None), "one step");
    assert!(!hand.app().session().is_dirty());
}

#[test]
fn a_line_of_a_keyed_value_sets_its_key() {
    let mut hand = User::new();
    hand.app_mut().show_on("shape:sphere");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    let look = r#"{"lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
        "nodes": [{"id": "base", "kind": "base"},
        {"id": "diffuse", "kind": "light_layer", "values": {"light": "key"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "diffuse.below"},
        {"from": "diffuse", "to": "output.color"}],
        "direction_keys": [{"by": {"light": "key"}, "keys": [{"direction": [-0.5, 0.7, 0.6],
        "values": {"diffuse.cutoff": 1.2, "diffuse.falloff": 1.2}}]}]}"#;
    std::fs::write(&path, look).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let l = light(&hand);
    let from = grip(&hand, "cutoff");
    assert!(
        (normal_at(&hand, from).unwrap().angle_between(l) - 1.2).abs() < 0.01,
        "the line is where the key has it"
    );
    let to = screen_at(&hand, normal_at(&hand, from).unwrap().lerp(l, 0.3).normalize());
    hand.drag(from, to);
    hand.settle();
    let wanted = normal_at(&hand, to).unwrap().angle_between(l);
    for port in ["cutoff", "falloff"] {
        let target = chiaro::document::Target::parse(&format!("diffuse.{port}")).unwrap();
        let Value::Number(set) = hand.look().direction_keys[0].keys[0].values[&target] else {
            panic!("a number")
        };
        assert!((set - wanted).abs() < 0.004, "{port}: {set} for {wanted}");
    }
    assert_eq!(
        (number(&hand, "falloff"), number(&hand, "cutoff")),
        (None, None),
        "the node's own values stay"
    );
    assert_eq!(hand.app().session().steps().labels().count(), 1);
}

#[test]
fn ctrl_pulls_one_line_off_and_order_is_kept() {
    let mut hand = on_ball();
    let from = grip(&hand, "cutoff");
    let l = light(&hand);
    let to = screen_at(&hand, normal_at(&hand, from).unwrap().lerp(l, 0.4).normalize());
    hand.drag_with(Modifiers::COMMAND, from, to);
    let falloff = number(&hand, "falloff").expect("inward the fall-off comes off");
    assert_eq!(number(&hand, "cutoff"), None);
    assert!(falloff < 1.4, "{falloff}");
    hand.settle();
    // The cut-off now stops at the fall-off.
    let from = grip(&hand, "cutoff");
    hand.drag(from, screen_at(&hand, l));
    assert_eq!(number(&hand, "cutoff"), Some(falloff));
}

#[test]
fn the_offset_opens_from_the_ring_around_the_light() {
    let mut hand = on_ball();
    let middle = hand.app().viewport().middle().expect("the light's place is seen");
    let l = light(&hand);
    assert!(middle.distance(screen_at(&hand, l)) < 4.0);
    let away = (rect(&hand).center() - middle).normalized();
    let to = middle + away * 80.0;
    hand.drag(middle + away * 14.0, to);
    let offset = number(&hand, "offset").expect("it has one now");
    assert!((offset - normal_at(&hand, to).unwrap().angle_between(l)).abs() < 0.02, "{offset}");
}

#[test]
fn the_bright_middle_follows_the_pointer() {
    let mut hand = on_ball();
    let middle = hand.app().viewport().middle().unwrap();
    let to = rect(&hand).center() + vec2(40.0, 30.0);
    hand.drag(middle, to);
    let wanted = normal_at(&hand, to).unwrap();
    assert!(light(&hand).angle_between(wanted) < 0.02, "{} for {wanted}", light(&hand));
    assert_eq!(hand.app().session().steps().undo_label(), Some("Direction of key"));
    hand.undo();
    assert!(!hand.app().session().is_dirty(), "one step");
    // With Shift a drag from any place moves the light.
    let from = rect(&hand).center() + vec2(-20.0, 60.0);
    hand.drag_with(Modifiers::SHIFT, from, to);
    assert!(light(&hand).angle_between(wanted) < 0.02);
}

#[test]
fn a_highlight_follows_the_pointer() {
    let mut hand = on_ball();
    let specular = Value::Text("specular".to_owned());
    let edit = chiaro::document::Edit::SetValue {
        graph: chiaro::document::GraphId::Look,
        id: "diffuse".into(),
        port: "type".into(),
        value: specular,
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    let (from, to) =
        (rect(&hand).center() + vec2(-20.0, 60.0), rect(&hand).center() + vec2(50.0, -35.0));
    hand.drag_with(Modifiers::SHIFT, from, to);
    let n = normal_at(&hand, to).unwrap();
    let orbit = hand.app().session().view().orbit();
    let v = (orbit.target + orbit.direction() * orbit.distance - n).normalize();
    let mirrored = 2.0 * n.dot(v) * n - v;
    assert!(light(&hand).angle_between(mirrored) < 0.03, "{} for {mirrored}", light(&hand));
}

#[test]
fn beyond_the_outline_the_light_goes_behind() {
    let mut hand = on_ball();
    let from = hand.app().viewport().middle().unwrap();
    let rect = rect(&hand);
    hand.drag(from, pos2(rect.min.x + 4.0, rect.min.y + 4.0));
    let forward = hand.app().session().view().orbit().direction();
    assert!(light(&hand).dot(forward) < -0.05, "{}", light(&hand));
}

#[test]
fn a_needle_is_dragged_over_the_rim_to_the_other_side() {
    let mut hand = on_ball();
    hand.wheel(rect(&hand).center(), -150.0);
    hand.settle();
    let end = screen_at(&hand, light(&hand) * 1.25);
    let center = rect(&hand).center();
    hand.hover(center);
    let out = center + (end - center).normalized() * rect(&hand).height() * 0.49;
    hand.drag_through(&[end, out, center + (end - center) * 0.5]);
    let forward = hand.app().session().view().orbit().direction();
    assert!(light(&hand).dot(forward) < -0.5, "{}", light(&hand));
    assert!(
        hand.app().session().view().orbit().illumination.is_near_identity(),
        "the frame itself stays"
    );
}

/// A camera that stands near has the needle's end outside of the picture.
#[test]
fn a_needle_that_leaves_the_picture_is_dragged_by_its_arrow() {
    let mut hand = on_ball();
    for _ in 0..4 {
        hand.wheel(rect(&hand).center(), 120.0);
    }
    hand.settle();
    let end = screen_at(&hand, light(&hand) * 1.25);
    assert!(!rect(&hand).contains(end), "the end is outside: {end}");
    hand.hover(rect(&hand).center());
    hand.settle();
    let arrow = hand.place("Needle of key").center();
    let room = rect(&hand);
    assert!(room.shrink(5.0).contains(arrow), "{arrow} in {room}");
    let (old, steps) = (light(&hand), hand.steps());
    // A small drag moves the light a little, a long one takes its end to the pointer.
    hand.hold(arrow);
    let way = (room.center() - arrow).normalized();
    hand.move_to(arrow + way * 4.0);
    hand.move_to(arrow + way * 8.0);
    hand.harness.run_steps(2);
    let near = light(&hand).angle_between(old);
    assert!(near > 1e-4 && near < 0.06, "{near}");
    let to = room.center() + (arrow - room.center()) * 0.5;
    hand.move_to(to);
    hand.harness.run_steps(2);
    hand.release(to);
    hand.settle();
    let end = screen_at(&hand, light(&hand) * 1.25);
    assert!(end.distance(to) < 2.0, "{end} for {to}");
    assert_eq!(hand.steps(), steps + 1);
    hand.undo();
    assert!(light(&hand).angle_between(old) < 1e-9);
}

#[test]
fn without_a_layer_all_lights_turn() {
    let mut hand = on_ball();
    hand.app_mut().session_mut().select(Vec::new());
    hand.settle();
    let center = rect(&hand).center();
    hand.drag(center, center + vec2(60.0, 0.0));
    assert!(!hand.app().session().view().orbit().illumination.is_near_identity());
    assert!(!hand.app().session().is_dirty(), "the look stays as it was");
    assert!(hand.app().viewport().curve("cutoff").is_empty());
}

#[test]
fn escape_gives_a_drag_up() {
    let mut hand = on_ball();
    let before = hand.app().session().view().orbit().clone();
    let corner = rect(&hand).left_top() + vec2(12.0, 12.0);
    hand.hold(corner);
    hand.move_to(corner + vec2(60.0, 20.0));
    assert_ne!(*hand.app().session().view().orbit(), before);
    hand.key(Key::Escape);
    assert_eq!(*hand.app().session().view().orbit(), before);
    hand.move_to(corner + vec2(90.0, 20.0));
    hand.release(corner + vec2(90.0, 20.0));
    assert_eq!(*hand.app().session().view().orbit(), before, "the hand holds nothing any more");
    hand.settle();
    // Escape also takes back a value that a drag of a line has set, and leaves no step to undo.
    let from = grip(&hand, "cutoff");
    let to = screen_at(&hand, normal_at(&hand, from).unwrap().lerp(light(&hand), 0.3).normalize());
    hand.hold(from);
    hand.move_to(from + (to - from) * 0.5);
    hand.move_to(to);
    assert!(number(&hand, "cutoff").is_some());
    hand.key(Key::Escape);
    assert_eq!((number(&hand, "cutoff"), hand.app().session().steps().undo_label()), (None, None));
    hand.release(to);
    assert!(!hand.app().session().is_dirty());
    // An edit made before the drag stays.
    hand.drag(from, to);
    let first = number(&hand, "cutoff");
    hand.hold(corner);
    hand.move_to(corner + vec2(60.0, 20.0));
    hand.key(Key::Escape);
    hand.release(corner + vec2(60.0, 20.0));
    assert_eq!(number(&hand, "cutoff"), first);
}

#[test]
fn plain_nodes_have_lines_too() {
    let mut hand = User::new();
    hand.app_mut().show_on("shape:sphere");
    hand.app_mut().open(std::path::Path::new("tests/editor/editor_support/plain.json"));
    hand.app_mut().session_mut().select(vec!["tone".into()]);
    hand.settle();
    assert!(hand.app().viewport().curve("cutoff").len() > 30);
    hand.app_mut().session_mut().select(vec!["angle".into()]);
    hand.settle();
    assert!(
        hand.app().viewport().curve("falloff").len() > 30,
        "an angle that feeds one profile stands for it"
    );
}

#[test]
fn the_window_rests_with_lines_on_the_object() {
    let mut hand = on_ball();
    hand.hover(rect(&hand).center());
    hand.settle();
    assert!(hand.repaint_delay() > std::time::Duration::from_secs(60));
    hand.key(Key::T);
    hand.harness.run_steps(2);
    assert!(hand.repaint_delay() < std::time::Duration::from_secs(1), "the turntable runs");
    hand.key(Key::T);
    hand.settle();
    assert!(hand.repaint_delay() > std::time::Duration::from_secs(60));
    // The palette starts the turntable too; over the graph the key is the graph's.
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("turntable");
    hand.key(Key::Enter);
    hand.harness.run_steps(2);
    assert!(hand.repaint_delay() < std::time::Duration::from_secs(1), "it runs again");
    let nothing = hand.empty_place();
    hand.hover(nothing);
    hand.key(Key::T);
    hand.harness.run_steps(2);
    assert!(hand.repaint_delay() < std::time::Duration::from_secs(1), "and goes on");
}

/// Arrows lie from the surface toward each light and along the eye's trace; without the option
/// there are no arrows.
#[test]
fn arrows_point_at_the_light() {
    let mut hand = on_ball();
    assert_eq!(hand.app().viewport().arrows().count(), 0);
    hand.press("Options");
    hand.press("Arrows toward eye and lights");
    hand.key(Key::Escape);
    hand.settle();
    let arrows: Vec<[Pos2; 2]> = hand.app().viewport().arrows().collect();
    assert!(arrows.len() > 20, "{}", arrows.len());
    let toward = light(&hand);
    let mut pointed = 0;
    for [from, to] in &arrows {
        let Some(normal) = normal_at(&hand, *from) else { continue };
        let ends: Vec<Pos2> = [
            // Ends of the three arrows: at the light, at the light's trace, and at the eye's trace.
            toward,
            toward - normal * normal.dot(toward),
            {
                let orbit = hand.app().session().view().orbit();
                let eye = orbit.target + orbit.direction() * orbit.distance;
                let view = (eye - normal).normalize();
                view - normal * normal.dot(view)
            },
        ]
        .map(|along| screen_at(&hand, normal + along * 0.09))
        .to_vec();
        let nearest = ends.iter().map(|end| end.distance(*to)).fold(f32::MAX, f32::min);
        assert!(nearest < 3.0, "from {from} to {to}: {ends:?}");
        pointed += usize::from(ends[0].distance(*to) < 3.0);
    }
    assert!(pointed > 5, "{pointed}");
}
