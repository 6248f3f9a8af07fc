//! The profile, direction keys, the timeline, and keyed values in the inspector, driven by pointer
//! and keys.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::path::Path;

use crate::editor_support::{User, close};
use chiaro::catalog::values::number_text;
use chiaro::document::{
    DirectionKey, DirectionKeys, Driver, Edit, ExposedValue, GraphId, KeyDirection, Target,
    TimeInterpolation, Value,
};
use chiaro::editor::App;
use eframe::egui::{Key, Pos2, Role, pos2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

fn at(hand: &User, label: &str) -> Pos2 {
    let found = hand.harness.get_all_by_label(label).next();
    found.unwrap_or_else(|| panic!("{label}")).rect().center()
}

fn click(hand: &mut User, label: &str) {
    let at = at(hand, label);
    hand.click(at);
    hand.settle();
}

fn has(hand: &User, text: &str) -> bool {
    hand.harness.query_all_by_label_contains(text).next().is_some()
}

fn select(hand: &mut User, ids: &[&str]) {
    hand.app_mut().session_mut().select(ids.iter().map(|id| (*id).into()).collect());
    hand.settle();
}

fn radians(hand: &User, node: &str, port: &str) -> f64 {
    match hand.look().graph.nodes[node].values.get(port) {
        Some(Value::Number(number)) => *number,
        other => panic!("{node}.{port} is {other:?}"),
    }
}

/// Brings a value of the inspector into view by its search.
fn find(hand: &mut User, text: &str) {
    let search = at(hand, "Find a value");
    hand.click(search);
    hand.key_with(eframe::egui::Modifiers::COMMAND, Key::A);
    hand.type_text(text);
    hand.settle();
}

/// Types a number into the field of a value in the inspector.
fn set(hand: &mut User, label: &str, number: &str) {
    find(hand, label);
    let mark = at(hand, &format!("Keys of {label}"));
    let fields = hand
        .harness
        .get_all_by_role(eframe::egui::accesskit::Role::SpinButton)
        .map(|node| node.rect());
    let in_row = fields
        .into_iter()
        .find(|rect| (rect.center().y - mark.y).abs() < 6.0 && rect.min.x > mark.x);
    hand.click(in_row.expect("a field").center());
    hand.key_with(eframe::egui::Modifiers::COMMAND, Key::A);
    hand.type_text(number);
    hand.key(Key::Enter);
    hand.settle();
}

fn target(text: &str) -> Target {
    Target::parse(text).unwrap()
}

/// Width of a degree in the plot of the profile, in points.
fn degree(hand: &User) -> f32 {
    let plot = hand.harness.get_by_label_contains("over the angle").rect();
    (plot.width() - 40.0) / 180.0
}

fn directional() -> User {
    let mut hand = User::new();
    hand.app_mut().open(Path::new("examples/looks/figure5-directional.json"));
    hand.settle();
    hand
}

#[test]
fn a_profile_is_dragged_in_one_step_and_keeps_its_order() {
    let mut hand = User::new();
    select(&mut hand, &["diffuse"]);
    let before = hand.look().clone();
    let cutoff = at(&hand, "Cut-off of the profile");
    let wide = degree(&hand);
    hand.drag(cutoff, cutoff + vec2(30.0 * wide, 0.0));
    hand.settle();
    let dragged = radians(&hand, "diffuse", "cutoff");
    assert!((dragged - 120_f64.to_radians()).abs() < 0.02, "{dragged}");
    // The offset stops at the fall-off.
    let offset = at(&hand, "Offset of the profile");
    hand.drag(offset, offset + vec2(150.0 * wide, 0.0));
    hand.settle();
    assert!(close(radians(&hand, "diffuse", "offset"), FRAC_PI_2));
    hand.undo();
    hand.undo();
    assert_eq!(*hand.look(), before, "a drag is one step");
}

#[test]
fn presets_keys_and_notes_of_a_profile() {
    let mut hand = User::new();
    select(&mut hand, &["diffuse"]);
    click(&mut hand, "Profile preset Cartoon");
    for port in ["offset", "falloff", "cutoff"] {
        assert!(close(radians(&hand, "diffuse", port), FRAC_PI_4), "{port}");
    }
    hand.undo();
    assert!(
        hand.look().graph.nodes["diffuse"].values.get("offset").is_none(),
        "a preset is one step"
    );
    click(&mut hand, "Profile preset Half-Lambert");
    assert!(close(radians(&hand, "diffuse", "cutoff"), PI));
    // A click takes the focus, arrow keys move by a degree.
    click(&mut hand, "Fall-off of the profile");
    hand.key(Key::ArrowLeft);
    hand.key(Key::ArrowLeft);
    assert!(close(radians(&hand, "diffuse", "falloff"), 88_f64.to_radians()));
    assert!(!has(&hand, "is not the only bend"));
    for _ in 0..12 {
        hand.key(Key::ArrowRight);
    }
    assert!(close(radians(&hand, "diffuse", "falloff"), 100_f64.to_radians()));
    hand.settle();
    assert!(
        !has(&hand, "is not the only bend"),
        "up to a cut-off of 180° the second bend lies at its end"
    );
    let cutoff = at(&hand, "Cut-off of the profile");
    let wide = degree(&hand);
    hand.drag(cutoff, cutoff - vec2(65.0 * wide, 0.0));
    hand.settle();
    assert!(has(&hand, "is not the only bend"));
}

#[test]
fn direction_keys_are_made_from_nothing() {
    let mut hand = User::new();
    let before = hand.look().clone();
    select(&mut hand, &["diffuse"]);
    click(&mut hand, "Keys");
    click(&mut hand, "Add direction keys");
    click(&mut hand, "By the light \"key\"");
    assert_eq!(hand.look().direction_keys[0].by, KeyDirection::Light("key".into()));
    assert_eq!(hand.look().direction_keys[0].keys.len(), 1);
    click(&mut hand, "Add value");
    click(&mut hand, "Diffuse: Opacity");
    let opacity = target("diffuse.opacity");
    let keys = |hand: &User| hand.look().direction_keys[0].keys.clone();
    assert_eq!(keys(&hand)[0].values[&opacity], Value::Number(1.0));
    // A copy of a key lies beside its original and is dragged elsewhere; values set in the
    // inspector are set at the copy.
    click(&mut hand, "Copy key");
    let copy = at(&hand, "Direction key 2");
    let sphere = hand.harness.get_by_label("Sphere of directions").rect();
    hand.drag(copy, pos2(sphere.center().x + 0.3 * sphere.width(), sphere.center().y));
    hand.settle();
    let moved = keys(&hand)[1].direction;
    assert!(moved[0] > 0.6 && moved[1].abs() < 0.15, "to the right: {moved:?}");
    set(&mut hand, "Opacity", "0.25");
    assert_eq!(keys(&hand)[1].values[&opacity], Value::Number(0.25));
    assert_eq!(
        keys(&hand)[0].values[&opacity],
        Value::Number(1.0),
        "only at the key that is selected"
    );
    assert!(hand.look().graph.nodes["diffuse"].values.get("opacity").is_none());
    // Going to a key turns the window's lights, not the document.
    let look = hand.look().clone();
    click(&mut hand, "Go to key");
    assert_eq!(*hand.look(), look);
    let light = hand.app().session().view().orbit().illumination
        * glam::DVec3::from(look.lights["key"].direction).normalize();
    assert!((light - glam::DVec3::from(moved).normalize()).length() < 1e-3, "{light}");
    click(&mut hand, "Back");
    assert_eq!(hand.app().session().view().orbit().illumination, glam::DQuat::IDENTITY);
    click(&mut hand, "Delete key");
    assert_eq!(keys(&hand).len(), 1);
    while hand.app().session().steps().undo_label().is_some() {
        hand.undo();
    }
    assert_eq!(*hand.look(), before);
}

/// Direction keys by numbers of the scene in place of a direction: drivers are chosen and shown,
/// and each key's value of a driver is typed.
#[test]
fn keys_by_drivers_are_made_from_nothing() {
    let mut hand = User::new();
    let before = hand.look().clone();
    select(&mut hand, &["diffuse"]);
    click(&mut hand, "Keys");
    click(&mut hand, "Add direction keys");
    click(&mut hand, "Distance to the eye");
    let set = |hand: &User| hand.look().direction_keys[0].clone();
    assert_eq!(set(&hand).by, KeyDirection::Drivers(vec![Driver::Distance]));
    let far = set(&hand).keys[0].direction[0];
    assert!(
        (far - hand.app().session().view().orbit().distance).abs() < 1e-3,
        "the key lies where it is now: {far}"
    );
    assert!(has(&hand, &format!("Distance to the eye now: {}", number_text(far, 3))));
    click(&mut hand, "Add value");
    click(&mut hand, "Diffuse: Opacity");
    click(&mut hand, "Copy key");
    assert!(set(&hand).keys[1].direction[0] > far, "a copy lies beside it");
    let field = at(&hand, "Distance to the eye of key 2");
    hand.click(field);
    hand.key_with(eframe::egui::Modifiers::COMMAND, Key::A);
    hand.type_text("0.5");
    hand.key(Key::Enter);
    hand.settle();
    assert!(close(set(&hand).keys[1].direction[0], 0.5), "{:?}", set(&hand).keys[1]);
    // The heaviest key is still the first one, which lies at the eye's own distance.
    let weights = hand.app().session().keys().key_weights(0);
    assert_eq!(weights, [1.0, 0.0]);
    // A second driver: keys lie on a plane, at first all at the driver's value of now.
    click(&mut hand, "Add driver");
    click(&mut hand, "Turned from the eye");
    assert_eq!(set(&hand).by.axes(), Some(2));
    let turned = set(&hand).keys.iter().map(|key| key.direction[1]).collect::<Vec<_>>();
    assert!(turned[0] == turned[1] && turned[0] < 1.6, "{turned:?}");
    click(&mut hand, "Remove the driver Distance to the eye");
    assert_eq!(set(&hand).by, KeyDirection::Drivers(vec![Driver::Facing]));
    assert!(
        set(&hand).keys.iter().all(|key| key.direction[0] == turned[0] && key.direction[1] == 0.0)
    );
    let problems = hand.app().session().compilation().problems();
    assert!(problems.iter().all(|problem| !problem.is_error()), "{problems:?}");
    while hand.app().session().steps().undo_label().is_some() {
        hand.undo();
    }
    assert_eq!(*hand.look(), before);
}

/// Direction keys by a wire whose value is the same all over the object: the value is chosen from
/// the menu, and changing it changes the keys' weights.
#[test]
fn keys_by_a_wire_are_made_and_follow_it() {
    let mut hand = User::new();
    let before = hand.look().clone();
    let mut node = chiaro::document::Node {
        kind: "number".to_owned(),
        name: "Mood".to_owned(),
        ..Default::default()
    };
    node.values.insert("value".into(), Value::Number(2.0));
    let add = Edit::AddNode { graph: GraphId::Look, id: "mood".into(), node, index: None };
    hand.app_mut().session_mut().apply(add, None).expect("it applies");
    hand.settle();
    // The value could never change: the menu does not offer it, and says so.
    click(&mut hand, "Keys");
    click(&mut hand, "Add direction keys");
    assert!(!has(&hand, "Value of \"Mood\""));
    assert!(has(&hand, "never change"));
    hand.key(Key::Escape);
    let exposed =
        ExposedValue { name: "mood".into(), target: target("mood.value"), label: String::new() };
    let expose = Edit::AddExposed { exposed, index: None };
    hand.app_mut().session_mut().apply(expose, None).expect("it applies");
    hand.settle();
    click(&mut hand, "Add direction keys");
    click(&mut hand, "Value of \"Mood\"");
    hand.settle();
    let set = |hand: &User| hand.look().direction_keys[0].clone();
    let KeyDirection::Drivers(drivers) = set(&hand).by else { panic!("{:?}", set(&hand).by) };
    assert_eq!(drivers[0].output().map(ToString::to_string).as_deref(), Some("mood.value"));
    assert_eq!(set(&hand).keys[0].direction[0], 2.0, "the key lies where the wire is now");
    select(&mut hand, &["diffuse"]);
    click(&mut hand, "Add value");
    click(&mut hand, "Diffuse: Opacity");
    click(&mut hand, "Copy key");
    assert_eq!(set(&hand).keys[1].direction[0], 2.5);
    hand.settle();
    assert_eq!(hand.app().session().keys().key_weights(0), [1.0, 0.0]);
    let value = Value::Number(2.25);
    let moved = Edit::SetValue {
        graph: GraphId::Look,
        id: "mood".into(),
        port: "value".into(),
        value,
        index: None,
    };
    hand.app_mut().session_mut().apply(moved, None).expect("it applies");
    hand.settle();
    let weights = hand.app().session().keys().key_weights(0);
    assert!(close(weights[0], 0.5), "half-way between the keys: {weights:?}");
    assert!(has(&hand, "Value of \"Mood\" now: 2.25"));
    let problems = hand.app().session().compilation().problems();
    assert!(problems.iter().all(|problem| !problem.is_error()), "{problems:?}");
    while hand.app().session().steps().undo_label().is_some() {
        hand.undo();
    }
    assert_eq!(*hand.look(), before);
}

/// The inspector shows below a keyed value: the value of now, the driver and its value, and the key
/// that edits go to. While the driver wanders about half-way between two keys that key stays the
/// same; it can be chosen there too.
#[test]
fn a_keyed_value_says_what_it_is_and_what_is_set() {
    let mut hand = User::new();
    let target = target("diffuse.opacity");
    let key = |at: f64, opacity: f64| DirectionKey {
        direction: [at, 0.0, 0.0],
        values: [(target.clone(), Value::Number(opacity))].into_iter().collect(),
        unknown: Default::default(),
    };
    let keys = DirectionKeys {
        name: "Height".to_owned(),
        by: KeyDirection::Drivers(vec![Driver::Height("key".into())]),
        scheme: Default::default(),
        keys: vec![key(0.0, 0.2), key(1.0, 0.8)],
        unknown: Default::default(),
    };
    let add = Edit::AddDirectionKeys { keys, index: None };
    hand.app_mut().session_mut().apply(add, None).expect("it applies");
    select(&mut hand, &["diffuse"]);
    find(&mut hand, "Opacity");
    let place = |hand: &mut User, height: f64| {
        let mut light = hand.look().lights["key"].clone();
        light.direction = [0.0, height.sin(), height.cos()];
        let set = Edit::SetLight { id: "key".into(), light };
        hand.app_mut().session_mut().apply(set, None).expect("it applies");
        hand.settle();
    };
    // Half-way the weights are equal, by symmetry.
    place(&mut hand, 0.5);
    assert!(has(&hand, "Now 0.5"));
    assert!(has(&hand, "while Height of \"key\" is 28.6°"));
    let is_set = |hand: &User, key: usize| {
        let name = format!("Set Opacity at key {key}");
        let node = hand.harness.get_by_label(&name);
        node.accesskit_node().toggled() == Some(eframe::egui::accesskit::Toggled::True)
    };
    // A light that wanders about the middle leaves the edited key as it is; a light that comes to
    // the other key does not.
    place(&mut hand, 0.1);
    assert!(is_set(&hand, 1) && !is_set(&hand, 2));
    for height in [0.48, 0.51, 0.49, 0.52, 0.5] {
        place(&mut hand, height);
        assert!(is_set(&hand, 1), "{height}");
    }
    place(&mut hand, 0.9);
    assert!(is_set(&hand, 2));
    for height in [0.52, 0.48, 0.5] {
        place(&mut hand, height);
        assert!(is_set(&hand, 2), "{height}");
    }
    set(&mut hand, "Opacity", "0.6");
    let opacity =
        |hand: &User, key: usize| hand.look().direction_keys[0].keys[key].values[&target].clone();
    assert_eq!([opacity(&hand, 0), opacity(&hand, 1)], [0.2, 0.6].map(Value::Number));
    assert!(has(&hand, "Now 0.4"), "between 0.2 and 0.6");
    click(&mut hand, "Set Opacity at key 1");
    place(&mut hand, 0.9);
    assert!(is_set(&hand, 1), "what is chosen stays");
    set(&mut hand, "Opacity", "0.1");
    assert_eq!([opacity(&hand, 0), opacity(&hand, 1)], [0.1, 0.6].map(Value::Number));
}

#[test]
fn a_key_takes_the_values_that_are_seen() {
    let mut hand = directional();
    click(&mut hand, "Keys");
    let now = match hand.look().graph.nodes["diffuse"].values["cutoff"] {
        Value::Number(own) => own,
        _ => unreachable!(),
    };
    // The light's direction is that of the first key.
    click(&mut hand, "Add key here");
    let keys = &hand.look().direction_keys[0].keys;
    assert_eq!(keys.len(), 3);
    match keys[2].values[&target("diffuse.cutoff")] {
        Value::Number(value) => assert!(close(value, now)),
        _ => unreachable!(),
    }
    assert_eq!(keys[2].values.len(), keys[1].values.len(), "every value that is keyed");
    // While the set of keyed values is unchanged nothing is compiled: dragging on the sphere only
    // writes uniforms.
    hand.undo();
    hand.settle();
    let back = at(&hand, "Direction key 2");
    hand.drag(back, back + vec2(12.0, 4.0));
    assert_ne!(hand.look().direction_keys[0].keys[1].direction, [0.2, 0.5, -0.85]);
    assert_eq!(hand.app().session().steps().undo_label(), Some("move key 2: Lit from behind"));
    hand.undo();
    assert_eq!(hand.look().direction_keys[0].keys[1].direction, [0.2, 0.5, -0.85]);
}

#[test]
fn what_is_keyed_follows_without_compiling() {
    let mut hand = directional();
    let mut keys = hand.look().direction_keys[0].clone();
    keys.keys[1].direction = [0.1, 0.4, -0.9];
    keys.keys[1].values.insert(target("diffuse.cutoff"), Value::Number(2.0));
    let edit = chiaro::document::Edit::SetDirectionKeys { index: 0, keys: keys.clone() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.harness.step();
    assert!(!hand.app().session().is_compiling(), "uniforms show it");
    // Another keyed value is a parameter that the shader does not have yet.
    keys.keys[1].values.insert(target("diffuse.opacity"), Value::Number(0.5));
    let edit = chiaro::document::Edit::SetDirectionKeys { index: 0, keys };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    let problems = hand.app().session().compilation().problems();
    assert!(problems.iter().all(|problem| !problem.is_error()), "{problems:?}");
}

/// The concave color follows the convex one until it has a value of its own, and only then can it
/// be keyed.
#[test]
fn what_has_no_value_of_its_own_gets_one_when_it_is_keyed() {
    let mut hand = User::new();
    select(&mut hand, &["diffuse"]);
    click(&mut hand, "Default");
    let before = hand.look().clone();
    assert!(before.graph.nodes["diffuse"].values.get("concave").is_none());
    for way in ["Key here", "New keys by the view", "Expose"] {
        click(&mut hand, "Keys of Concave color");
        click(&mut hand, way);
        let problems = hand.app().session().compilation().problems();
        assert!(problems.iter().all(|problem| !problem.is_error()), "{way}: {problems:?}");
        assert_ne!(*hand.look(), before, "{way}");
        hand.undo();
        assert_eq!(*hand.look(), before, "{way} is one step");
    }
}

#[test]
fn a_value_is_keyed_in_time_and_played() {
    let mut hand = User::new();
    let before = hand.look().clone();
    select(&mut hand, &["diffuse"]);
    find(&mut hand, "Opacity");
    click(&mut hand, "Keys of Opacity");
    click(&mut hand, "Key here");
    assert_eq!(hand.look().time_keys[0].target, target("diffuse.opacity"));
    assert!(
        hand.harness.query_by_role_and_label(Role::Tab, "Timeline").is_some(),
        "the timeline comes up"
    );
    // The entry is the first of the menu, and at a key takes that away.
    find(&mut hand, "Opacity");
    click(&mut hand, "Keys of Opacity");
    let [here, wedge, back] = ["Remove the key here", "Wedge this value", "Reset to default"]
        .map(|entry| at(&hand, entry).y);
    assert!(here < wedge && wedge < back, "{here} {wedge} {back}");
    click(&mut hand, "Remove the key here");
    assert!(hand.look().time_keys.is_empty());
    hand.undo();
    hand.settle();
    // Setting the value at another time makes a second key.
    let ruler = hand.harness.get_by_label("Playhead").rect();
    hand.click(pos2(ruler.left() + 0.6 * ruler.width(), ruler.top() + 6.0));
    hand.settle();
    let time = hand.app().session().view().time();
    assert!(time > 1.0 && close(time * 24.0, (time * 24.0).round()), "{time} is on a frame");
    set(&mut hand, "Opacity", "0.5");
    let keys = |hand: &User| hand.look().time_keys[0].keys.clone();
    assert_eq!(keys(&hand).len(), 2);
    assert_eq!((keys(&hand)[1].time, &keys(&hand)[1].value), (time, &Value::Number(0.5)));
    // The second key is dragged in time and made stepped.
    let second = at(&hand, "Time key 2 of Diffuse: Opacity");
    hand.drag(second, second + vec2(40.0, 0.0));
    hand.settle();
    assert!(keys(&hand)[1].time > time);
    click(&mut hand, "Interpolation");
    click(&mut hand, "Stepped");
    assert_eq!(keys(&hand)[1].interpolation, TimeInterpolation::Stepped);
    // A right click on a key shapes it, too.
    let first = at(&hand, "Time key 1 of Diffuse: Opacity");
    hand.right_click(first);
    hand.settle();
    click(&mut hand, "Straight");
    assert_eq!(keys(&hand)[0].interpolation, TimeInterpolation::Linear);
    hand.undo();
    hand.settle();
    // The timeline plays, and only then asks for frames.
    assert_eq!(hand.repaint_delay(), std::time::Duration::MAX);
    click(&mut hand, "Play");
    let started = hand.app().session().view().time();
    hand.harness.run_steps(12);
    assert!(
        hand.app().session().view().time() > started
            || hand.app().session().view().time() < started,
        "it moves"
    );
    assert!(hand.repaint_delay() < std::time::Duration::from_millis(60));
    let at_pause = at(&hand, "Pause");
    hand.click(at_pause);
    hand.settle();
    assert_eq!(hand.repaint_delay(), std::time::Duration::MAX);
    click(&mut hand, "Delete time key");
    assert_eq!(keys(&hand).len(), 1);
    while hand.app().session().steps().undo_label().is_some() {
        hand.undo();
    }
    assert_eq!(*hand.look(), before);
}

#[test]
fn the_inspector_exposes_finds_and_sets_several() {
    let mut hand = directional();
    select(&mut hand, &["fill", "diffuse"]);
    set(&mut hand, "Opacity", "0.75");
    assert!(
        close(radians(&hand, "fill", "opacity"), 0.75)
            && close(radians(&hand, "diffuse", "opacity"), 0.75)
    );
    hand.undo();
    assert!(hand.look().graph.nodes["fill"].values.get("opacity").is_none(), "one step");
    select(&mut hand, &["diffuse"]);
    click(&mut hand, "Keys of Opacity");
    click(&mut hand, "Expose");
    assert_eq!(hand.look().exposed[0].target, target("diffuse.opacity"));
    assert_eq!(hand.look().exposed[0].name.as_str(), "diffuse_opacity");
    // The search keeps the values that it finds and hides the rest.
    find(&mut hand, "opac");
    assert!(hand.harness.query_by_label("Keys of Opacity").is_some());
    assert!(hand.harness.query_by_label("Keys of Blending").is_none());
}

/// Keys driven by an exposed number: each object of the scene has a number of its own, and the
/// inspector's values, and the key that edits go to, are those of the selected object.
#[test]
fn keyed_values_are_of_the_object_that_is_selected() {
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().open(Path::new("examples/scenes/keys-mood.json"));
    hand.settle();
    let at_key = |hand: &User, key: usize| {
        let keys = &hand.look().direction_keys[0].keys;
        keys[key].values.get(&target("body.offset")).cloned()
    };
    let own = radians(&hand, "body", "offset");
    for (object, said, key, now) in
        [("mood-1", "0", 0, own), ("mood-3", "0.5", 1, 0.5), ("mood-5", "1", 2, 0.85)]
    {
        hand.app_mut().session_mut().select_object(Some(object.into()));
        select(&mut hand, &["body"]);
        find(&mut hand, "Offset");
        hand.place_like(&format!("while Value of \"Mood\" is {said}"));
        let degrees = number_text(now.to_degrees(), 1);
        assert!(has(&hand, &format!("Now {degrees}")), "{object}: {degrees}");
        let before = hand.look().clone();
        set(&mut hand, "Offset", "33");
        let set =
            (0..3).filter(|&key| at_key(&hand, key) == Some(Value::Number(33_f64.to_radians())));
        assert_eq!(set.collect::<Vec<_>>(), [key], "{object}");
        hand.undo();
        assert_eq!(*hand.look(), before, "one step");
    }
    // The object's own value drives the keys, and not the look's.
    hand.press_a(Role::Tab, "Objects");
    hand.bring(Role::SpinButton, "Mood");
    let mood = hand.place_of(Role::SpinButton, "Mood");
    hand.type_over(mood, "0.5");
    select(&mut hand, &["body"]);
    find(&mut hand, "Offset");
    assert!(has(&hand, "while Value of \"Mood\" is 0.5"));
}
