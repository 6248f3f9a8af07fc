//! Painting light on the picture: strokes by the pointer, a fit of the look to the strokes, and the
//! fit's result in the document.

use std::path::{Path, PathBuf};

use crate::editor_support::User;
use chiaro::compile::Live;
use chiaro::document::{Document, Look};
use chiaro::editor::App;
use chiaro::frame::{Assets, PlanOptions, Planner, SetupLook, default_setup};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules};
use eframe::egui::{Key, Modifiers, Pos2, Role, Theme, vec2};
use eframe::egui_wgpu::WgpuSetup;
use egui_kittest::Harness;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};

/// Side of the pictures that are compared, in pixels.
const SIDE: u32 = 32;

/// A window in which light is painted on an example; fits work on few pixels.
fn painter(example: &str) -> User {
    let mut hand = User::new();
    hand.app_mut().fitting_mut().set_effort(24, 2);
    hand.app_mut().open(Path::new(example));
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    paint_light(&mut hand);
    hand
}

/// Presses the key over the picture that begins painting light.
fn paint_light(hand: &mut User) {
    let at = at(hand, 0.0, 0.0);
    hand.hover(at);
    hand.key(Key::L);
    hand.settle();
    assert!(hand.app().fitting().is_on());
}

/// A place of the picture, in parts of the ball's radius from the ball's middle.
fn at(hand: &User, x: f32, y: f32) -> Pos2 {
    let rect = hand.app().viewport().rect().unwrap();
    let radius = hand.app().session().view().orbit().radius_in_picture() as f32 * rect.height();
    rect.center() + vec2(x, -y) * radius
}

/// A stroke through places of the ball.
fn stroke(hand: &mut User, brush: &str, places: &[[f32; 2]]) {
    hand.press_a(Role::RadioButton, &format!("Brush: {brush}"));
    let points: Vec<Pos2> = places.iter().map(|&[x, y]| at(hand, x, y)).collect();
    hand.drag_through(&points);
    hand.settle();
}

/// Mean of the green channel around a place of the ball, in the picture of the reference, which
/// shares no state with the window.
fn brightness(look: &Look, [x, y]: [f64; 2]) -> f64 {
    let source = Look::read("{}", "none").source.into();
    let look = SetupLook { look: look.clone(), source, folder: PathBuf::new() };
    let setup = default_setup(look, "shape:sphere", &mut Assets::default()).unwrap().value;
    let options = PlanOptions { size: [SIDE; 2], samples: 1, time: 0.0 };
    let plan = Planner::new(Assets::default())
        .plan(&setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap()
        .value;
    let radius = chiaro::editor::Orbit::default().radius_in_picture();
    let modules = Modules::new(&plan, Precision::F64).unwrap();
    let picture = reference::execute(
        &plan,
        &modules,
        &reference::ReferenceOptions::default(),
        &Progress::new(),
    )
    .unwrap();
    let middle = [0.5 + x * radius, 0.5 - y * radius].map(|part| (part * f64::from(SIDE)) as u32);
    let around = (0..9).map(|index| [middle[0] + index % 3 - 1, middle[1] + index / 3 - 1]);
    around.map(|[x, y]| picture.straight(x, y)[1]).sum::<f64>() / 9.0
}

const LEFT: [f32; 2] = [-0.55, 0.2];
const RIGHT: [f32; 2] = [0.55, 0.2];

fn paint_both_sides(hand: &mut User) {
    stroke(hand, "Light", &[[0.5, 0.4], [0.6, -0.1]]);
    stroke(hand, "Dark", &[[-0.5, 0.4], [-0.6, -0.1]]);
}

#[test]
fn light_is_painted_fitted_applied_and_undone() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let before = hand.look().clone();
    paint_both_sides(&mut hand);
    assert!(hand.app().fitting().painted() > 20, "{}", hand.app().fitting().painted());
    assert_eq!(
        hand.app().session().steps().labels().collect::<Vec<_>>(),
        ["paint light", "paint dark"]
    );

    hand.press("Fit this look");
    let [was, is] = hand
        .app()
        .fitting()
        .errors()
        .unwrap_or_else(|| panic!("{:?}", hand.app().fitting().told()));
    assert!(is < 0.7 * was, "{is} of {was}");
    assert_eq!(*hand.look(), before, "a preview is no edit");
    assert!(
        hand.app().session().sketchbook().preview().is_some()
            && hand.says("Preview of the fit") | hand.has("Apply")
    );

    hand.press("Apply");
    let after = hand.look().clone();
    assert!(after != before && hand.app().session().sketchbook().preview().is_none());
    let [left, right] = [LEFT, RIGHT].map(|place| {
        let place = place.map(f64::from);
        brightness(&after, place) - brightness(&before, place)
    });
    assert!(right > 0.03 && left < 0.0, "right {right}, left {left}");
    let places =
        |look: &Look| look.graph.nodes.values().map(|node| node.position).collect::<Vec<_>>();
    assert_eq!(places(&after), places(&before));
    // The fitted look is an ordinary look: its file is read back as the same look.
    let read = Look::read(&after.to_text(), "fitted.json");
    assert!(!read.has_errors() && read.value == Some(after.clone()), "{:?}", read.diagnostics);

    assert!(hand.app().fitting().errors().is_some() && hand.has("Applied; undo takes it back"));
    hand.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(*hand.look(), before, "one step");
    hand.settle();
    assert!(hand.app().fitting().errors().is_none() && !hand.has("Applied; undo takes it back"));
    hand.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(*hand.look(), after);
}

/// *Light it there*: the journey from a stroke to a layer of its own and back.
#[test]
fn a_stroke_is_lit_there_by_a_layer_of_its_own_and_undone() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    hand.app_mut().fitting_mut().set_effort(40, 2);
    let before = hand.look().clone();
    // On the side away from the light.
    stroke(&mut hand, "Light", &[[0.35, -0.2], [0.5, -0.35], [0.4, -0.5]]);
    hand.press("Light it there");
    let [was, is] = hand
        .app()
        .fitting()
        .errors()
        .unwrap_or_else(|| panic!("{:?}", hand.app().fitting().told()));
    assert!(is < 0.7 * was, "{is} of {was}");
    assert_eq!(*hand.look(), before, "a preview is no edit");
    assert!(hand.app().session().sketchbook().preview().is_some());
    hand.press("Apply");

    // All that was there is there; a layer lies on top, with a light of its own.
    let after = hand.look().clone();
    for (id, node) in &before.graph.nodes {
        let kept = after.graph.nodes.get(id).expect("it stays");
        assert_eq!((&kept.kind, &kept.values), (&node.kind, &node.values), "{id}");
    }
    assert!(before.lights.iter().all(|(id, light)| after.lights.get(id) == Some(light)));
    let new = after.graph.nodes.iter().filter(|(id, _)| !before.graph.nodes.contains_key(*id));
    let kinds: Vec<&str> = new.map(|(_, node)| node.kind.as_str()).collect();
    assert!(kinds.contains(&"light_layer"), "{kinds:?}");
    assert!(kinds.iter().all(|kind| ["light_layer", "nearby"].contains(kind)), "{kinds:?}");
    assert!(after.lights.len() > before.lights.len());
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());

    // Lighter at the stroke, and the rest as it was, but for a bound of 6 of 255 over all of it.
    let lighter = |place: [f64; 2]| brightness(&after, place) - brightness(&before, place);
    let there = lighter([0.45, -0.35]);
    assert!(there > 0.04, "{there}");
    for place in [[-0.5, 0.4], [0.0, 0.6], [-0.6, -0.2], [-0.5, -0.5]] {
        let moved = lighter(place).abs();
        assert!(moved < 0.04 && moved < 0.5 * there, "{place:?}: {moved}");
    }
    hand.undo();
    assert_eq!(*hand.look(), before, "one step");
}

#[test]
fn new_layers_take_the_place_of_the_nodes() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let before = hand.look().clone();
    stroke(&mut hand, "Color", &[[0.5, 0.5], [0.6, -0.2]]);
    stroke(&mut hand, "Keep", &[[-0.6, 0.3], [-0.3, -0.3]]);
    hand.app_mut().fitting_mut().set_layers(1);
    hand.press("Fit new layers");
    let [was, is] = hand
        .app()
        .fitting()
        .errors()
        .unwrap_or_else(|| panic!("{:?}", hand.app().fitting().told()));
    // Half of the way, and a little less: what is not painted pulls toward staying as it is.
    assert!(is < 0.7 * was, "{is} of {was}");
    assert_eq!(*hand.look(), before);
    hand.press("Apply");
    assert!(
        hand.look()
            .graph
            .nodes
            .values()
            .all(|node| ["base", "light_layer", "output"].contains(&node.kind.as_str()))
    );
    let mut places: Vec<[u64; 2]> =
        hand.look().graph.nodes.values().map(|n| n.position.map(f64::to_bits)).collect();
    let count = places.len();
    places.sort_unstable();
    places.dedup();
    assert_eq!(places.len(), count, "no node lies on another");
    hand.undo();
    assert_eq!(*hand.look(), before);
}

#[test]
fn strokes_are_undone_cleared_and_belong_to_their_view() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let orbit = hand.app().session().view().orbit().clone();
    paint_both_sides(&mut hand);
    let both = hand.app().fitting().painted();
    hand.undo();
    hand.settle();
    let one = hand.app().fitting().painted();
    assert!(0 < one && one < both, "{one} of {both}");
    hand.redo();
    hand.settle();
    assert_eq!(hand.app().fitting().painted(), both);
    assert_eq!(*hand.app().session().view().orbit(), orbit, "the brush turns nothing");
    let middle = at(&hand, 0.0, 0.0);
    hand.wheel(middle, 60.0);
    assert_eq!(*hand.app().session().view().orbit(), orbit, "a wheel does not lose the view");

    // From another view the strokes are not seen, and painting is refused; a button leads back.
    let (from, to) = (at(&hand, 0.0, 0.0), at(&hand, 0.5, 0.0));
    hand.drag_with(Modifiers::ALT, from, to);
    hand.settle();
    assert_ne!(*hand.app().session().view().orbit(), orbit);
    hand.press("Fit this look");
    assert!(
        hand.app().fitting().told().unwrap().contains("another view"),
        "{:?}",
        hand.app().fitting().told()
    );
    hand.press("Back to the painted view");
    assert_eq!(*hand.app().session().view().orbit(), orbit);

    stroke(&mut hand, "Erase", &[[0.3, 0.7], [0.5, 0.3], [0.6, 0.0], [0.5, -0.4]]);
    assert!(hand.app().fitting().painted() < both);
    hand.press("Clear");
    assert!(
        hand.app().session().sketchbook().sketch().is_empty()
            && hand.app().fitting().painted() == 0
    );
    hand.undo();
    assert!(!hand.app().session().sketchbook().sketch().is_empty());
    // While strokes are not shown, undo takes back steps of the look.
    hand.key(Key::Escape);
    assert!(!hand.app().fitting().is_on());
    assert_eq!(hand.app().session().steps().undo_label(), None);
    paint_light(&mut hand);
    assert!(
        hand.app().session().steps().undo_label().is_some()
            && !hand.app().session().sketchbook().sketch().is_empty()
    );
}

#[test]
fn what_cannot_be_fitted_is_told() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let told = |hand: &User| hand.app().fitting().told().unwrap_or_default().to_owned();
    hand.press("Fit this look");
    assert!(told(&hand).contains("Nothing is painted"), "{}", told(&hand));
    // A stroke beside the object.
    stroke(&mut hand, "Light", &[[-1.1, 0.95], [-1.0, 1.0]]);
    assert!(hand.app().session().sketchbook().sketch().is_empty());
    assert!(
        hand.app().message().unwrap_or_default().contains("met no object"),
        "{:?}",
        hand.app().message()
    );
    // A dot: too few pixels.
    let size = hand.place_of(Role::SpinButton, "Size").center();
    hand.double_click(size);
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text("3");
    hand.key(Key::Enter);
    stroke(&mut hand, "Light", &[[0.2, 0.0], [0.21, 0.0]]);
    assert!(
        (1..12).contains(&hand.app().fitting().painted()),
        "{}",
        hand.app().fitting().painted()
    );
    hand.press("Fit this look");
    assert!(told(&hand).contains("Too little"), "{}", told(&hand));
    // Nothing of the look may change.
    for _ in 0..10 {
        hand.key(Key::Escape);
    }
    let mut hand = painter("examples/looks/figure3-profile.json");
    paint_both_sides(&mut hand);
    for label in ["Lights", "Profiles", "Colors", "Base"] {
        hand.press_a(Role::CheckBox, &format!("Keep: {label}"));
    }
    hand.press("Fit this look");
    assert!(told(&hand).contains("may change"), "{}", told(&hand));
}

#[test]
fn a_fit_can_be_stopped_and_an_edit_ends_it() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let before = hand.look().clone();
    paint_both_sides(&mut hand);
    let start = |hand: &mut User| {
        let fit = hand.place("Fit this look").center();
        hand.click(fit);
        assert!(hand.app().fitting().is_fitting(), "{:?}", hand.app().fitting().told());
    };
    start(&mut hand);
    hand.press("Stop");
    assert!(
        !hand.app().fitting().is_fitting() && *hand.look() == before,
        "nothing is applied by itself"
    );
    // A stopped fit either has a result, which is shown, or tells that it has none.
    let told = hand.app().fitting().told().unwrap().to_owned();
    match hand.app().fitting().errors() {
        Some([was, is]) => {
            assert!(
                is < was
                    && told.contains("best so far")
                    && hand.app().session().sketchbook().preview().is_some(),
                "{told}"
            );
            hand.press("Discard");
        }
        None => {
            assert!(
                told.contains("stopped") && hand.app().session().sketchbook().preview().is_none(),
                "{told}"
            );
        }
    }

    // Escape stops a fit too, and leaves painting on.
    start(&mut hand);
    hand.key(Key::Escape);
    hand.settle();
    assert!(hand.app().fitting().is_on() && !hand.app().fitting().is_fitting());
    if hand.has("Discard") {
        hand.press("Discard");
    }

    start(&mut hand);
    let edit = chiaro::document::Edit::SetLookName { name: "Another".to_owned() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert!(
        hand.app().fitting().told().unwrap().contains("was changed"),
        "{:?}",
        hand.app().fitting().told()
    );
    assert!(hand.app().session().sketchbook().preview().is_none());
}

#[test]
fn strokes_wait_for_their_look_and_undoing_one_ends_a_preview() {
    let example = Path::new("examples/looks/figure3-profile.json");
    let mut hand = painter("examples/looks/figure3-profile.json");
    paint_both_sides(&mut hand);
    hand.press("Fit this look");
    assert!(
        hand.app().session().sketchbook().preview().is_some(),
        "{:?}",
        hand.app().fitting().told()
    );
    hand.undo();
    assert!(
        hand.app().session().sketchbook().preview().is_none()
            && hand.app().fitting().errors().is_none()
    );
    assert_eq!(hand.app().fitting().told(), Some("The strokes were changed: fit again"));

    let tile = hand.app().session().sketchbook().sketch().tile().cloned();
    hand.app_mut().open(Path::new("examples/looks/figure2-diffuse.json"));
    hand.settle();
    assert!(hand.app().session().sketchbook().sketch().is_empty() && !hand.app().fitting().is_on());
    hand.app_mut().open(example);
    hand.settle();
    assert!(tile.is_some() && hand.app().session().sketchbook().sketch().tile() == tile.as_ref());
}

#[test]
fn tools_leave_the_picture_its_size_and_a_stroke_waits_until_it_is_read() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let rect = hand.app().viewport().rect();
    for brush in ["Dark", "Color", "Keep", "Erase", "Light"] {
        hand.press_a(Role::RadioButton, &format!("Brush: {brush}"));
        assert_eq!(hand.app().viewport().rect(), rect, "{brush}");
    }
    // Another height makes another picture, which is not read back yet.
    hand.app_mut().fitting_mut().set_effort(28, 2);
    let points: Vec<Pos2> =
        [[0.5, 0.4], [0.6, -0.1]].iter().map(|&[x, y]| at(&hand, x, y)).collect();
    hand.drag_through(&points);
    hand.settle();
    assert_eq!(
        hand.app().session().steps().labels().collect::<Vec<_>>(),
        ["paint light"],
        "{:?}",
        hand.app().message()
    );
    assert!(hand.app().fitting().painted() > 20, "{}", hand.app().fitting().painted());
}

#[test]
fn a_preview_is_discarded_or_goes_with_an_edit() {
    let mut hand = painter("examples/looks/figure3-profile.json");
    let before = hand.look().clone();
    paint_both_sides(&mut hand);
    hand.press("Fit this look");
    assert!(hand.app().session().sketchbook().preview().is_some());
    hand.press("Discard");
    assert!(
        hand.app().session().sketchbook().preview().is_none()
            && *hand.look() == before
            && hand.app().fitting().is_on()
    );
    hand.press("Fit this look");
    assert!(hand.app().session().sketchbook().preview().is_some());
    let edit = chiaro::document::Edit::SetLookName { name: "Another".to_owned() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert!(hand.app().session().sketchbook().preview().is_none() && !hand.has("Apply"));
    // Strokes belong to a look: another look has none.
    hand.app_mut().open(Path::new("examples/looks/figure2-diffuse.json"));
    hand.settle();
    assert!(hand.app().session().sketchbook().sketch().is_empty());
    assert!(matches!(
        Document::load(&chiaro::files::Disk, Path::new("examples/looks/figure2-diffuse.json")),
        Document::Look(_)
    ));
}

/// Pictures of each state, to be looked at: `cargo test --test editor fit::shots -- --ignored`
/// writes them to `target/shots`, or to the folder that `CHIARO_SHOTS` names.
#[test]
#[ignore = "writes pictures to be looked at"]
fn shots() {
    let size = vec2(1600.0, 960.0);
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.device_descriptor = std::sync::Arc::new(chiaro::render::device_descriptor);
    }
    let state = create_render_state(setup, eframe::egui_wgpu::RendererOptions::PREDICTABLE);
    let builder = Harness::builder()
        .with_size(size)
        .renderer(WgpuTestRenderer::from_render_state(state.clone()));
    let mut hand = User::with_builder(builder, move |ctx| App::new(ctx, Some(state.clone())));
    let folder = std::env::var_os("CHIARO_SHOTS")
        .map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    std::fs::create_dir_all(&folder).unwrap();
    let save = |hand: &mut User, name: &str| {
        hand.harness.render().unwrap().save(folder.join(format!("{name}.png"))).unwrap();
    };
    hand.app_mut().fitting_mut().set_effort(96, 2);
    hand.app_mut().open(Path::new("examples/looks/figure4-color.json"));
    hand.app_mut().show_on("shape:creature");
    hand.settle();
    paint_light(&mut hand);
    save(&mut hand, "fit-1-begun");
    stroke(&mut hand, "Light", &[[0.35, 0.45], [0.5, 0.1], [0.4, -0.3]]);
    stroke(&mut hand, "Dark", &[[-0.45, 0.4], [-0.5, 0.0]]);
    stroke(&mut hand, "Keep", &[[-0.1, -0.4], [0.1, -0.5]]);
    let over = at(&hand, 0.1, 0.3);
    hand.hover(over);
    save(&mut hand, "fit-2-painted");
    hand.press("Misses");
    save(&mut hand, "fit-3-misses");
    hand.press("Misses");
    let fit = hand.place("Fit this look").center();
    hand.click(fit);
    hand.app().fitting().wait_for_ground();
    save(&mut hand, "fit-4-fitting");
    hand.settle();
    save(&mut hand, "fit-5-preview");
    hand.press("Apply");
    save(&mut hand, "fit-6-applied");
    hand.harness.ctx.set_theme(Theme::Light);
    hand.settle();
    save(&mut hand, "fit-7-light");
    hand.harness.ctx.set_theme(Theme::Dark);
    let (from, to) = (at(&hand, 0.0, 0.0), at(&hand, 0.5, 0.0));
    hand.drag_with(Modifiers::ALT, from, to);
    hand.settle();
    save(&mut hand, "fit-8-elsewhere");
    hand.press("Back to the painted view");
    hand.harness.set_size(vec2(900.0, 620.0));
    hand.settle();
    save(&mut hand, "fit-9-small");
    hand.harness.set_size(vec2(1600.0, 960.0));
    hand.settle();
    hand.app_mut().fitting_mut().set_layers(1);
    hand.press("Clear");
    stroke(&mut hand, "Color", &[[0.35, 0.45], [0.5, 0.1], [0.4, -0.3]]);
    hand.press("Fit new layers");
    save(&mut hand, "fit-10-layers");
}
