//! The panels below the picture: effects and the probe, driven by pointer and keys.

use crate::editor_support;
use crate::editor_support::User;
use eframe::egui::{Key, Rect, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

fn picture(hand: &User) -> Rect {
    hand.app().viewport().rect().unwrap()
}

fn click_label(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_label(label).rect().center();
    hand.click(at);
}

/// A look whose second node divides by 0, and whose last node hides the result.
const BROKEN: &str = r##"{"nodes": [
    {"id": "fine", "kind": "add", "values": {"a": 0, "b": 0}},
    {"id": "broken", "kind": "wgsl", "at": [240, 0],
     "values": {"code": "fn broken(value: f32) -> f32 { return 1.0 / value; }"}},
    {"id": "after", "kind": "wgsl", "at": [480, 0],
     "values": {"code": "fn after(value: f32) -> f32 { return value * 2.0; }"}},
    {"id": "output", "kind": "output", "at": [720, 0]}
  ], "wires": [
    {"from": "fine", "to": "broken.value"}, {"from": "broken", "to": "after.value"},
    {"from": "after", "to": "output.color"}
  ]}"##;

fn open(hand: &mut User, text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    std::fs::write(&path, text).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    let problems = hand.app().session().compilation().problems();
    assert!(problems.iter().all(|problem| !problem.is_error()), "{problems:?}");
    folder
}

#[test]
fn the_probe_reads_every_wire_under_a_resting_pointer() {
    let mut hand = User::new();
    let middle = picture(&hand).center();
    hand.hover(middle);
    hand.settle();
    assert!(hand.app().probe().wires().is_empty(), "it is off");
    hand.key(Key::I);
    hand.settle();
    assert!(hand.app().probe().is_on());
    let wires = hand.app().probe().wires();
    let of = |node: &str| {
        wires.iter().find(|wire| wire.node.to_string() == node).expect("it has a value")
    };
    // A new look's base is [0.16, 0.15, 0.2]: nothing is computed, so f64 and f32 hold the color as
    // closely as each can.
    let base = of("base");
    assert_eq!(base.double, [0.16, 0.15, 0.2, 1.0]);
    assert_eq!(base.single, [0.16_f32, 0.15, 0.2, 1.0].map(f64::from));
    assert!(base.difference() > 0.0 && base.difference() < 1e-8);
    assert!(wires.last().unwrap().node.to_string() == "output", "in the order of computing");
    // Beside the object nothing is probed.
    let corner = picture(&hand).left_top() + vec2(5.0, 5.0);
    hand.hover(corner);
    hand.settle();
    assert!(hand.app().probe().wires().is_empty());
    assert!(hand.harness.query_by_label("Nothing is drawn there.").is_some());
    // Escape switches the probe off.
    hand.key(Key::Escape);
    assert!(!hand.app().probe().is_on());
}

#[test]
fn a_click_keeps_a_pixel_and_escape_lets_go_of_it() {
    let mut hand = User::new();
    click_label(&mut hand, "Probe pixel");
    assert!(hand.app().probe().is_on());
    let rect = picture(&hand);
    hand.click(rect.center());
    hand.settle();
    let offset = rect.size() / 2.0;
    assert_eq!(hand.app().probe().pinned(), Some([offset.x as u32, offset.y as u32]));
    let kept = hand.app().probe().wires().to_vec();
    assert!(!kept.is_empty());
    hand.hover(rect.left_top() + vec2(5.0, 5.0));
    hand.settle();
    assert_eq!(hand.app().probe().wires(), kept);
    // The values follow an edit.
    let graph = chiaro::document::GraphId::Look;
    let value = chiaro::document::Value::Vector(vec![0.5, 0.25, 0.125]);
    let edit = chiaro::document::Edit::SetValue {
        graph,
        id: "base".into(),
        port: "color".into(),
        value,
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    let base = &hand.app().probe().wires()[0];
    assert_eq!((base.node.to_string().as_str(), base.difference()), ("base", 0.0));
    assert_eq!(base.double, [0.5, 0.25, 0.125, 1.0]);
    hand.key(Key::Escape);
    assert!(hand.app().probe().is_on() && hand.app().probe().pinned().is_none());
    hand.key(Key::Escape);
    assert!(!hand.app().probe().is_on());
    // The picture is still shown.
    assert!(!hand.app().viewport().rect().unwrap().is_negative());
}

#[test]
fn a_row_of_the_probe_leads_to_its_node() {
    let mut hand = User::new();
    hand.key(Key::I);
    hand.click(picture(&hand).center());
    hand.settle();
    let at = hand.harness.get_all_by_label("Wire of base").next().unwrap().rect().center();
    hand.click(at);
    assert_eq!(hand.selected(), ["base"]);
    assert!(hand.app().probe().pinned().is_some(), "the probe goes on");
}

#[test]
fn the_first_broken_wire_is_found() {
    let mut hand = User::new();
    let _folder = open(&mut hand, BROKEN);
    hand.key(Key::I);
    hand.click(picture(&hand).center());
    hand.settle();
    let wires = hand.app().probe().wires();
    let broken: Vec<String> =
        wires.iter().filter(|w| !w.is_finite()).map(|w| w.node.to_string()).collect();
    assert_eq!(broken.first().map(String::as_str), Some("broken"), "{wires:?}");
    click_label(&mut hand, "Go to first broken wire");
    assert_eq!(hand.selected(), ["broken"]);
}

#[test]
fn a_window_with_a_probe_at_rest_asks_for_no_frame() {
    let mut hand = User::new();
    hand.key(Key::I);
    hand.hover(picture(&hand).center());
    hand.settle();
    hand.harness.run_steps(12);
    hand.settle();
    assert_eq!(hand.repaint_delay(), std::time::Duration::MAX);
}

#[test]
fn effects_are_listed_with_state_and_lead_to_nodes() {
    let mut hand = User::drawing_with(|app, _| app);
    click_label(&mut hand, "Effects");
    hand.harness.run_steps(8);
    hand.settle();
    let is_listed = |hand: &User, label: &str| hand.harness.query_by_label(label).is_some();
    // The first picture was drawn before the panel was opened: its passes still stand.
    assert!(is_listed(&hand, "Effect look"));
    assert!(
        is_listed(&hand, "Effect curvature of the detail normals"),
        "a dropped pass is told too"
    );
    // The filter for running passes hides dropped ones.
    let at = hand.harness.get_by_label_contains(" dropped").rect().center();
    hand.click(at);
    assert!(
        !is_listed(&hand, "Effect curvature of the detail normals")
            && is_listed(&hand, "Effect look")
    );
    // A node further down in a list that is taller than the panel: the wheel brings it into view.
    let list = hand.harness.get_by_label("Effect look").rect().center();
    let of_diffuse = |hand: &User| {
        let found = hand.harness.query_all_by_label_contains("Effect diffuse").next();
        found.map(|node| node.rect().center())
    };
    for _ in 0..20 {
        if of_diffuse(&hand).is_some() {
            break;
        }
        hand.wheel(list, -60.0);
    }
    hand.wheel(list, -40.0);
    let at = of_diffuse(&hand).expect("the diffuse layer runs");
    hand.click(at);
    assert_eq!(hand.selected(), ["diffuse"]);
}

/// Chooses from the list of executors and tiers that the picture is compared with.
fn compare_with(hand: &mut User, before: &str, what: &str) {
    let combo = hand.harness.get_all_by_role(eframe::egui::accesskit::Role::ComboBox);
    let combo = combo
        .into_iter()
        .find(|node| node.value().as_deref() == Some(before))
        .map(|node| node.rect().center());
    hand.click(combo.expect("the list of what to compare with"));
    let at = hand.harness.get_all_by_label(what).last().unwrap().rect().center();
    hand.click(at);
    hand.harness.run_steps(4);
    hand.settle();
}

#[test]
fn the_picture_is_wiped_against_truth_and_tiers() {
    let mut hand = User::drawing_with(|app, _| app);
    compare_with(&mut hand, "Compare", "Truth (f64)");
    let figures =
        hand.app().wipe().figures().expect("chosen by hand, it is computed at once").clone();
    assert!(figures.pixels > 10_000 && figures.broken == 0);
    assert!(figures.max < 1.0 / 255.0, "exact is close to the truth: {figures:?}");
    // The divider follows the pointer, and the camera stays.
    let before = hand.app().session().view().orbit().clone();
    let rect = picture(&hand);
    hand.drag(rect.center(), rect.center() + vec2(80.0, 0.0));
    assert!(
        (hand.app().wipe().split() - (0.5 + 80.0 / rect.width())).abs() < 0.02,
        "{}",
        hand.app().wipe().split()
    );
    assert_eq!(*hand.app().session().view().orbit(), before);
    // In the magnified difference equal pixels are black: the whole background.
    click_label(&mut hand, "×256");
    let image = hand.harness.render().unwrap();
    let corner = rect.left_bottom() + vec2(6.0, -6.0);
    assert_eq!(image.get_pixel(corner.x as u32, corner.y as u32).0, [0, 0, 0, 255]);
    // After any change the comparison with the truth is out of date, and only a click computes it
    // again.
    click_label(&mut hand, "Wipe");
    let corner = rect.left_top() + vec2(12.0, 60.0);
    hand.drag(corner, corner + vec2(40.0, 0.0));
    hand.harness.run_steps(4);
    hand.settle();
    assert!(hand.app().wipe().figures().is_none());
    click_label(&mut hand, "Compute again");
    hand.settle();
    assert!(hand.app().wipe().figures().is_some());
    // A comparison with a tier follows changes by itself.
    compare_with(&mut hand, "Truth (f64)", "Exact");
    let most = hand.app().wipe().figures().expect("drawn").max;
    assert!(most < 1.0 / 255.0, "{most}: nobody can see it");
    hand.drag(corner, corner + vec2(-40.0, 0.0));
    hand.harness.run_steps(4);
    hand.settle();
    assert!(hand.app().wipe().figures().is_some());
    hand.harness.run_steps(12);
    hand.settle();
    assert_eq!(hand.repaint_delay(), std::time::Duration::MAX);
}

/// A slow machine has no time for them then.
#[test]
fn small_pictures_wait_while_a_file_is_asked_for() {
    use chiaro::document::{Edit, GraphId, Value};
    let mut hand = User::drawing_coarsely(|app, _| app.with_path_fields());
    hand.settle();
    let before = hand.app().small_pictures();
    assert!(before > 0, "layers have small pictures");
    hand.press("Open");
    let edit = Edit::SetValue {
        graph: GraphId::Look,
        id: "base".into(),
        port: "color".into(),
        value: Value::Vector(vec![0.1, 0.2, 0.9]),
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert_eq!(hand.app().small_pictures(), before);
    hand.key(Key::Escape);
    hand.settle();
    assert!(hand.app().small_pictures() > before, "they are drawn afterwards");
}

#[test]
fn compare_stays_in_the_bar_while_light_is_painted() {
    let mut hand = User::drawing_with(|app, _| app);
    let may_compare = |hand: &User| {
        let mut all = hand.harness.get_all_by_role(eframe::egui::accesskit::Role::ComboBox);
        let compare = all.find(|node| node.value().as_deref() == Some("Compare"));
        !compare.expect("it is in the bar").accesskit_node().is_disabled()
    };
    assert!(may_compare(&hand));
    let over = picture(&hand).center();
    hand.hover(over);
    hand.key(Key::L);
    hand.settle();
    assert!(hand.app().fitting().is_on() && !may_compare(&hand));
    hand.key(Key::Escape);
    hand.settle();
    assert!(!hand.app().fitting().is_on() && may_compare(&hand));
}

/// A window so low that the bars above the picture leave it no room, or hardly any.
#[test]
fn a_comparison_needs_no_room() {
    let mut hand = User::drawing_with(|app, _| app);
    compare_with(&mut hand, "Compare", "Exact");
    let before = hand.harness.ctx.content_rect().size();
    for size in [vec2(400.0, 300.0), vec2(400.0, 130.0), vec2(400.0, 90.0), before] {
        hand.harness.set_size(size);
        hand.harness.run_steps(4);
        hand.settle();
        // A texture without a pixel ends here, where it is made.
        hand.harness.render().unwrap();
        assert!(!hand.says("refused our work"), "{size}: {:?}", hand.names());
        if size.y >= 300.0 {
            let height = picture(&hand).height();
            assert!(height >= 30.0, "{size}: the picture is {height} points high");
        }
    }
    assert!(hand.app().wipe().figures().is_some(), "with room it goes on");
}

/// Lines and labels of handles are on the look's own side of the divider alone.
#[test]
fn handles_leave_the_other_picture_of_a_wipe_free() {
    let mut hand = User::drawing_with(|app, _| app);
    hand.press("Layer Diffuse");
    compare_with(&mut hand, "Compare", "Exact");
    let rect = picture(&hand);
    // Between the names above and the bars below, on either side of the divider.
    let side = |hand: &mut User, from: f32, to: f32| {
        hand.settle();
        let image = hand.harness.render().unwrap();
        let at = |part: f32| (rect.left() + part * rect.width()) as u32;
        let rows = (rect.top() + 0.25 * rect.height()) as u32..(rect.bottom() - 90.0) as u32;
        let pixels = rows.flat_map(|y| (at(from)..at(to)).map(move |x| (x, y)));
        pixels.map(|(x, y)| image.get_pixel(x, y).0).collect::<Vec<_>>()
    };
    hand.hover(rect.left_center() + vec2(20.0, 0.0));
    let with = [side(&mut hand, 0.05, 0.45), side(&mut hand, 0.55, 0.95)];
    hand.key(Key::H);
    let without = [side(&mut hand, 0.05, 0.45), side(&mut hand, 0.55, 0.95)];
    assert!(with[0] != without[0], "the handles are there");
    assert!(with[1] == without[1], "and not over the picture that is compared with");
}

#[test]
fn tiers_are_measured_when_asked_and_adopted_by_a_click() {
    use chiaro::accuracy::MeasuredTier;
    use chiaro::document::Tier;
    let mut hand = User::drawing_with(|app, _| app);
    click_label(&mut hand, "Cost and accuracy");
    hand.harness.run_steps(8);
    hand.settle();
    assert!(hand.app().cost().report().is_none(), "never by itself");
    click_label(&mut hand, "Measure");
    hand.settle();
    let report = hand.app().cost().report().expect("it was measured");
    let is_measured =
        |tier: MeasuredTier| report.rows.iter().any(|row| row.tier == tier && row.error.is_some());
    assert!(is_measured(MeasuredTier::Named(Tier::Fast)) && is_measured(MeasuredTier::Automatic));
    let plot = hand.harness.get_by_label("Error against time").rect();
    // The wheel scrolls to the table, which is below the plot.
    let row = "Adopt fast for Whole look";
    let visible = |hand: &User| {
        let found = hand.harness.query_by_label(row).map(|node| node.rect());
        found.filter(|rect| rect.bottom() < 860.0)
    };
    for _ in 0..20 {
        if visible(&hand).is_some() {
            break;
        }
        hand.wheel(plot.center(), -30.0);
    }
    let at = visible(&hand).unwrap().center();
    hand.click(at);
    assert_eq!(hand.look().tier, Some(Tier::Fast));
    hand.undo();
    assert_eq!(hand.look().tier, None);
    assert!(!hand.app().session().is_dirty(), "one step");
    // A point of the plot adopts its tier by a click, too, and says so.
    for _ in 0..20 {
        hand.wheel(plot.center(), 60.0);
    }
    let point = hand.harness.get_by_label("Point fast").rect().center();
    hand.hover(point);
    hand.harness.run_steps(30);
    assert!(hand.harness.query_by_label_contains("A click adopts it").is_some());
    hand.click(point);
    assert_eq!(hand.look().tier, Some(Tier::Fast));
    hand.undo();
    // Measuring is stopped by its button; figures measured before stay.
    let times = |hand: &User| -> Vec<f64> {
        hand.app().cost().report().unwrap().rows.iter().map(|row| row.time.median).collect()
    };
    let before = times(&hand);
    let measure = hand.harness.get_by_label("Measure").rect().center();
    hand.click(measure);
    let stop = hand.harness.get_by_label("Stop").rect().center();
    hand.click(stop);
    hand.settle();
    assert!(!hand.app().is_busy());
    assert_eq!(times(&hand), before, "measured to the end, no time would be the same");
}

/// A look whose output shows 0.5 everywhere, with a constant of 2 and a custom node that is wired
/// to nothing.
const WIRES: &str = r##"{"nodes": [
    {"id": "two", "kind": "number", "values": {"value": 2}},
    {"id": "base", "kind": "base", "at": [240, 0], "values": {"color": [0.5, 0.5, 0.5]}},
    {"id": "output", "kind": "output", "at": [480, 0]}
  ], "wires": [{"from": "base", "to": "output.color"}]}"##;

/// The color in the middle of the picture.
fn middle(hand: &mut User) -> [u8; 4] {
    let at = picture(hand).center();
    hand.harness.remove_cursor();
    hand.settle();
    hand.harness.render().unwrap().get_pixel(at.x as u32, at.y as u32).0
}

fn choose(hand: &mut User, list: &str, what: &str) {
    let role = eframe::egui::accesskit::Role::ComboBox;
    let at = hand.harness.get_by_role_and_label(role, list).rect().center();
    hand.click(at);
    let at = hand.harness.get_all_by_label(what).last().unwrap().rect().center();
    hand.click(at);
    hand.settle();
}

#[test]
fn any_wire_is_shown_in_place_of_the_picture() {
    let mut hand = User::drawing_with(|app, _| app);
    let _folder = open(&mut hand, WIRES);
    let gray = middle(&mut hand);
    assert!(gray[0].abs_diff(128) <= 1, "{gray:?}");
    hand.click(editor_support::node_center(&hand, "two"));
    let room = picture(&hand);
    choose(&mut hand, "View wire", "Value");
    assert_eq!(
        picture(&hand),
        room,
        "what is told of it lies over the picture, which stays where it is"
    );
    assert_eq!(middle(&mut hand), [255; 4], "2 is white");
    // Heat is red above 1, whatever the look's output shows.
    click_label(&mut hand, "Heat");
    let red = middle(&mut hand);
    assert!(red[0] > 200 && red[1] < 80 && red[2] < 80, "{red:?}");
    // Every style is a shader that compiles, and the look is untouched.
    click_label(&mut hand, "Isolines");
    let level = middle(&mut hand);
    assert!(
        level[..3].iter().all(|c| c.abs_diff(191) <= 1),
        "2 everywhere crosses nothing: {level:?}"
    );
    assert!(
        hand.app().session().compilation().problems().is_empty(),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    assert!(!hand.app().session().is_dirty());
    click_label(&mut hand, "Show the look");
    assert_eq!(middle(&mut hand), gray);
}

/// Wires inside of groups are listed by the probe too, and a right click shows one.
#[test]
fn a_wire_inside_a_group_is_shown_in_place_of_the_picture() {
    let mut hand = User::drawing_with(|app, _| app);
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    hand.key(Key::I);
    // A point on the shaded side, down to the right, in parts of the picture's height: a message
    // above the picture makes the picture smaller.
    let place = |hand: &User| picture(hand).center() + vec2(0.12, 0.1) * picture(hand).height();
    let at = place(&hand);
    hand.click(at);
    hand.settle();
    let path = "diffuse/tone";
    let tone = hand
        .app()
        .probe()
        .wires()
        .iter()
        .rfind(|wire| wire.node.to_string() == path)
        .expect("the tone")
        .double[0];
    assert!(tone > 0.05 && tone < 0.95, "{tone}");
    hand.harness.get_all_by_label(&format!("Wire of {path}")).last().unwrap().click_secondary();
    hand.settle();
    click_label(&mut hand, "Show Tone as color");
    hand.key(Key::Escape);
    hand.key(Key::Escape);
    hand.harness.remove_cursor();
    let at = place(&hand);
    let gray = color_at(&mut hand, at);
    let expected = (tone * 255.0).round() as u8;
    assert!(gray[..3].iter().all(|c| c.abs_diff(expected) <= 8), "{gray:?} for {tone}");
    assert!(hand.harness.query_by_label("Showing Tone of Diffuse / Profile as color").is_some());
    assert!(
        !hand.app().session().is_dirty()
            && hand.app().session().compilation().problems().is_empty()
    );
    for style in ["heat", "isolines"] {
        hand.key(Key::I);
        hand.click(at);
        hand.settle();
        hand.harness.get_all_by_label(&format!("Wire of {path}")).last().unwrap().click_secondary();
        hand.settle();
        click_label(&mut hand, &format!("Show Tone as {style}"));
        hand.settle();
        assert!(
            hand.app().session().compilation().problems().is_empty(),
            "{:?}",
            hand.app().session().compilation().problems()
        );
        assert_ne!(color_at(&mut hand, at), gray, "{style}");
        hand.key(Key::Escape);
        hand.key(Key::Escape);
    }
}

fn color_at(hand: &mut User, at: eframe::egui::Pos2) -> [u8; 4] {
    hand.settle();
    hand.harness.render().unwrap().get_pixel(at.x as u32, at.y as u32).0
}

/// Opens the picker of a color in the inspector.
fn open_picker(hand: &mut User) {
    let swatch = hand.swatch("Convex color").center();
    hand.click(swatch);
    hand.settle();
    assert!(is_picking(hand));
}

fn is_picking(hand: &User) -> bool {
    hand.says("Saturation and brightness")
}

#[test]
fn the_picker_is_closed_by_escape_whatever_was_done_in_it_and_speaks_plainly() {
    let mut hand = User::new();
    hand.press("Layer Diffuse");
    let color = |hand: &User| hand.look().graph.nodes["diffuse"].values.get("convex").cloned();
    let first = color(&hand);
    let steps = hand.steps();
    open_picker(&mut hand);
    for jargon in ["U8", "F", "📋", "HSVA"] {
        assert!(!hand.has(jargon), "{jargon}");
    }
    for part in ["Red", "Green", "Blue", "Opacity", "Hex code"] {
        assert!(hand.has(part), "{part}");
    }
    hand.key(Key::Escape);
    hand.settle();
    assert!(
        !is_picking(&hand) && color(&hand) == first && hand.steps() == steps,
        "it was only looked at"
    );

    // Changes in the square, on the strip of hues, and at a number are one step each, and Escape
    // keeps the picked color.
    open_picker(&mut hand);
    let square = hand.place_like("Saturation and brightness");
    hand.drag(square.center(), square.right_top() + vec2(-20.0, 20.0));
    let hues = hand.place_like("Hue");
    hand.drag(hues.left_center() + vec2(4.0, 0.0), hues.center());
    let red = hand.place("Red").center();
    hand.drag(red, red + vec2(40.0, 0.0));
    assert_eq!(hand.steps(), steps + 3);
    let picked = color(&hand);
    assert_ne!(picked, first);
    hand.key(Key::Escape);
    hand.settle();
    assert!(!is_picking(&hand) && color(&hand) == picked);

    // Escape also closes the picker while a number or a hex code is typed, and while the probe is
    // on, which Escape would leave too.
    open_picker(&mut hand);
    let green = hand.place("Green").center();
    hand.click(green);
    hand.type_text("9");
    hand.key(Key::Escape);
    hand.settle();
    assert!(!is_picking(&hand), "a number is being typed");
    let middle = picture(&hand).center();
    hand.hover(middle);
    hand.key(Key::I);
    hand.settle();
    assert!(hand.app().probe().is_on());
    open_picker(&mut hand);
    hand.key(Key::Escape);
    hand.settle();
    assert!(!is_picking(&hand) && hand.app().probe().is_on(), "one key, one thing");
}

#[test]
fn the_backdrop_is_picked_within_its_menu() {
    let mut hand = User::new();
    hand.press("Options");
    hand.press("Backdrop");
    let own = hand.app().session().view().orbit().backdrop;
    assert!(own.is_some());
    let square = hand.place_like("Saturation and brightness");
    hand.click(square.right_top() + vec2(-10.0, 10.0));
    hand.settle();
    assert_ne!(hand.app().session().view().orbit().backdrop, own);
    assert!(is_picking(&hand), "it stays, for the next try");
    hand.key(Key::Escape);
    hand.settle();
    assert!(!is_picking(&hand));
}

#[test]
fn values_over_the_picture_come_with_the_pointer_and_go_with_it() {
    let mut hand = User::new();
    hand.press("Layer Diffuse");
    let picture = picture(&hand);
    hand.hover(picture.center());
    hand.settle();
    let tab = hand.place("Values of Diffuse over the picture");
    assert!(
        tab.width() < 0.4 * picture.width()
            && tab.height() < 30.0
            && !hand.has("Offset on the object")
    );
    // At the object's feet nothing lies over the picture.
    hand.hover(picture.center_bottom() - vec2(0.0, 20.0));
    hand.settle();
    assert!(!hand.has("Offset on the object"));
    hand.hover(tab.center());
    hand.settle();
    let field = hand.place("Cut-off on the object");
    hand.type_over(field, "120");
    let cutoff = hand.look().graph.nodes["diffuse"].values.get("cutoff").cloned();
    assert_eq!(cutoff, Some(chiaro::document::Value::Number(2.0944)));
    hand.hover(picture.center());
    hand.settle();
    assert!(!hand.has("Cut-off on the object") && hand.has("Values of Diffuse over the picture"));
}

/// The difference that automatic tiers may make stands where the tier is, and is a step of history.
#[test]
fn the_difference_of_automatic_tiers_stands_beside_the_tier() {
    use chiaro::document::{MAX_ERROR, Tier};
    let mut hand = User::new();
    hand.app_mut().open(std::path::Path::new("examples/looks/figure2-diffuse.json"));
    hand.settle();
    assert_eq!((hand.look().tier, hand.look().max_error), (None, MAX_ERROR));
    assert!(hand.has("Difference"));
    let wider = chiaro::document::Edit::SetMaxError { max_error: 3.0 / 255.0 };
    hand.app_mut().session_mut().apply(wider, None).expect("a look has a difference");
    hand.settle();
    assert!((hand.look().max_error - 3.0 / 255.0).abs() < 1e-12, "{}", hand.look().max_error);
    hand.undo();
    hand.settle();
    assert_eq!(hand.look().max_error, MAX_ERROR);
    let exact = chiaro::document::Edit::SetLookTier { tier: Some(Tier::Exact) };
    hand.app_mut().session_mut().apply(exact, None).expect("a look has a tier");
    hand.settle();
    assert!(hand.harness.query_by_label("Difference").is_none(), "nothing is automatic");
}

/// A layer's menu copies it and pastes it, and says what Ctrl+V does next.
#[test]
fn the_menu_of_a_layer_copies_and_pastes_it() {
    let mut hand = User::new();
    let count = hand.look().graph.nodes.len();
    hand.press("More of Diffuse");
    hand.press("Copy layer");
    let told = hand.app().message().expect("it says so").to_owned();
    assert!(told.contains("Diffuse") && told.contains("Ctrl+V"), "{told}");
    let text = hand.take_copied().expect("a text");
    // It is laid over the layer whose menu it was, also while another is selected.
    let other = hand.look().graph.nodes.keys().last().expect("one").clone();
    hand.app_mut().session_mut().select(vec![other]);
    hand.settle();
    hand.press("More of Diffuse");
    hand.press("Paste above");
    assert_eq!(hand.app().session().selection().nodes().next().expect("one").as_str(), "diffuse");
    hand.harness.event(eframe::egui::Event::Paste(text));
    hand.settle();
    assert_eq!(hand.look().graph.nodes.len(), count + 1, "{:?}", hand.app().message());
    let wires = &hand.look().graph.wires;
    let above = wires.iter().find(|wire| wire.from.node.as_str() == "diffuse").expect("a wire");
    assert!(above.to.node.as_str().starts_with("diffuse"), "{above:?}");
}

/// The menu of a value opens on its label and on all that sets it.
#[test]
fn the_menu_of_a_value_opens_anywhere_on_its_row() {
    for widget in ["number", "slider", "swatch"] {
        let mut hand = User::new();
        hand.press("Layer Diffuse");
        let before = hand.look().clone();
        if widget != "swatch" {
            hand.bring(eframe::egui::accesskit::Role::Button, "Keys of Opacity");
        }
        let place = match widget {
            "number" => hand.number_field("Opacity"),
            "slider" => hand.slider("Opacity"),
            _ => hand.swatch("Convex color"),
        };
        assert!(!hand.has("Variations..."));
        hand.right_click(place.center());
        assert!(hand.has("Variations..."), "the {widget} has no menu");
        hand.key(Key::Escape);
        hand.settle();
        assert_eq!(*hand.look(), before, "the {widget} takes no value from a right click");
    }
}
