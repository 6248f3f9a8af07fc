//! Playback in the window: frames are drawn once, kept within a bound, and compared with those of
//! another version.

use std::path::PathBuf;

use chiaro::document::{Edit, GraphId, Target, TimeInterpolation, TimeKey, TimeKeys, Value};
use chiaro::film::{BUILT_IN, ColorConfig};
use chiaro::frame::Picture;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Pos2, pos2};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;

/// A window with a look whose exposed layer fades in steps and then evenly, and its timeline over
/// frames 0 to 8.
fn moving() -> User {
    let mut hand = User::drawing();
    let look =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples/looks/figure5-directional.json");
    hand.app_mut().open(&look);
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    let layer = hand.look().graph.nodes.iter().find(|(_, node)| node.kind == "light_layer");
    let (id, _) = layer.expect("the example has a layer");
    let target = Target::parse(&format!("{id}.opacity")).unwrap();
    let key = |frame: f64, value: f64, interpolation| {
        TimeKey::new(frame / 24.0, Value::Number(value), interpolation)
    };
    // Held over frames 0 to 3.
    let keys = vec![
        key(0.0, 1.0, TimeInterpolation::Stepped),
        key(4.0, 0.8, TimeInterpolation::Linear),
        key(8.0, 0.2, TimeInterpolation::Linear),
    ];
    let keys = TimeKeys { keys, ..TimeKeys::new(target) };
    let edit = Edit::AddTimeKeys { keys, index: None };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    hand.press("View");
    hand.press_a(Role::CheckBox, "Timeline");
    let nothing = hand.empty_place();
    hand.click(nothing);
    let end = hand.fields_called("Range to")[0];
    hand.type_over(end, "8");
    assert!(hand.says("0 of 9 kept"), "nothing is drawn ahead unasked");
    hand
}

/// Picture of the picture's panel, as it is on the screen.
fn seen(hand: &mut User) -> Vec<u8> {
    let rect = hand.app().viewport().rect().unwrap().shrink(60.0);
    let image = hand.harness.render().unwrap();
    let at = |x: f32| x.round() as u32;
    let (left, top) = (at(rect.left()), at(rect.top()));
    let part = image::imageops::crop_imm(&image, left, top, at(rect.width()), at(rect.height()));
    part.to_image().into_raw()
}

fn scrub_to(hand: &mut User, frame: f64) {
    let flag = |hand: &User, name: &str| hand.place(name).center().x;
    let [start, end] = ["Start of the range", "End of the range"].map(|name| flag(hand, name));
    let x = start + frame as f32 / 8.0 * (end - start);
    let at = pos2(x, hand.place("Playhead").top() + 8.0);
    hand.click(at);
    hand.settle();
    let time = hand.app().session().view().time();
    assert!((time * 24.0 - frame).abs() < 1e-3, "{time} for frame {frame}");
}

/// Clicks in a window that may never rest.
fn press_without_rest(hand: &mut User, label: &str) {
    let at = hand.place(label).center();
    hand.click(at);
}

fn hold(hand: &mut User, key: Key, pressed: bool) {
    hand.harness.event(Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    });
    hand.harness.run_steps(2);
}

#[test]
fn frames_are_drawn_once_and_played_without_the_gpu() {
    let mut hand = moving();
    hand.press("Cache range");
    let [kept, drawn] = hand.app().frames();
    assert_eq!((kept, drawn), (9, 6), "four frames are held, and drawn once");
    assert!(hand.says("9 of 9 kept") && !hand.app().is_busy());
    let [width, height] = hand.app().viewport().rect().unwrap().size().into();
    let one = width.round() as usize * height.round() as usize * 4;
    assert_eq!(hand.app().frame_bytes(), 6 * one, "equal frames are stored once");

    // Two rounds show each frame and draw nothing.
    let pictures = hand.app().pictures();
    press_without_rest(&mut hand, "Play");
    let mut times = Vec::new();
    for _ in 0..45 {
        hand.harness.step();
        times.push((hand.app().session().view().time() * 24.0).round() as i32);
    }
    let mut shown = times.clone();
    shown.sort_unstable();
    shown.dedup();
    assert_eq!(shown, (0..9).collect::<Vec<i32>>(), "{times:?}");
    assert!(times.windows(2).any(|pair| pair[1] < pair[0]), "it has come around");
    assert_eq!((hand.app().pictures(), hand.app().frames()), (pictures, [9, 6]));
    assert!(hand.says("of 24 fps"), "the real rate is told");
    press_without_rest(&mut hand, "Pause");
    hand.settle();
    assert_eq!(hand.app().session().steps().done(), 1, "playing changes nothing");

    // An edit gives all up; what is undone is known again, and is not drawn anew.
    let layer = hand.look().graph.nodes.iter().find(|(_, node)| node.kind == "light_layer");
    let node = layer.unwrap().0.clone();
    let edit = Edit::SetValue {
        graph: GraphId::Look,
        id: node,
        port: "falloff".into(),
        value: Value::Number(0.4),
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    hand.press("Next frame");
    assert!(hand.says("0 of 9 kept"), "{:?}", hand.app().frames());
    hand.undo();
    hand.settle();
    hand.press("Cache range");
    assert_eq!(hand.app().frames(), [9, 6], "the pictures were still there");
}

#[test]
fn a_first_round_fills_the_cache_and_memory_is_bounded() {
    let mut hand = moving();
    hand.press("0 of 9 kept");
    let field = hand.fields_called("Memory of frames")[0];
    hand.type_over(field, "4");
    hand.key(Key::Escape);
    hand.settle();
    press_without_rest(&mut hand, "Play");
    for _ in 0..60 {
        hand.harness.step();
        hand.app().wait();
    }
    press_without_rest(&mut hand, "Pause");
    hand.settle();
    let [kept, drawn] = hand.app().frames();
    assert!(hand.app().frame_bytes() <= 4 << 20, "{}", hand.app().frame_bytes());
    assert!(kept >= 1 && drawn >= 1, "{kept} kept, {drawn} drawn");
    assert!(!hand.app().is_busy(), "and the window rests although not all frames have room");
}

#[test]
fn a_kept_version_is_compared_with_the_frames_after_an_edit() {
    let mut hand = moving();
    hand.press("Cache range");
    scrub_to(&mut hand, 6.0);
    hand.press("Keep version");
    // The frame in view alone is compared yet.
    assert!(hand.says("0 of 1 differ") && hand.says("frame 6 no difference"));
    // The last key is changed: frames 5 to 8 differ, and 8 most.
    let mut keys = hand.look().time_keys[0].clone();
    keys.keys[2].value = Value::Number(0.9);
    let edit = Edit::SetTimeKeys { index: 0, keys };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    hand.press("Cache range");
    assert!(hand.says("4 differ"), "{:?}", hand.app().frames());
    hand.press("Greatest difference");
    assert!((hand.app().session().view().time() - 8.0 / 24.0).abs() < 1e-3);
    // While V is held the other version is seen.
    let middle: Pos2 = hand.app().viewport().rect().unwrap().center();
    hand.hover(middle);
    let now = seen(&mut hand);
    hold(&mut hand, Key::V, true);
    let before = seen(&mut hand);
    hold(&mut hand, Key::V, false);
    assert!(now != before && seen(&mut hand) == now);
    // In the difference what is equal is black, and more stops show more of it.
    hand.press("Difference");
    hand.hover(middle);
    let difference = seen(&mut hand);
    let lit = |bytes: &[u8]| bytes.chunks_exact(4).filter(|of| of[..3] != [0; 3]).count();
    assert!(lit(&difference) > 500 && lit(&difference) < difference.len() / 4);
    // The divider follows the pointer; the camera stays.
    hand.press("Wipe");
    let orbit = hand.app().session().view().orbit().clone();
    hand.drag(middle, middle + eframe::egui::vec2(60.0, 0.0));
    assert_eq!(*hand.app().session().view().orbit(), orbit);
    hand.press("Close flip book");
    assert!(!hand.says("differ"));
}

#[test]
fn an_onion_skin_costs_nothing_while_it_is_off() {
    let mut hand = moving();
    scrub_to(&mut hand, 6.0);
    let plain = seen(&mut hand);
    assert_eq!(hand.app().frames(), [0, 0]);
    hand.press("Onion skin");
    hand.press_a(Role::CheckBox, "Show ghosts");
    hand.key(Key::Escape);
    hand.settle();
    // The present frame and those at the keys before and after it.
    assert_eq!(hand.app().frames(), [3, 3]);
    let ghosts = seen(&mut hand);
    assert!(plain != ghosts, "ghosts are seen");
    hand.press("Onion skin");
    hand.press_a(Role::CheckBox, "Show ghosts");
    hand.key(Key::Escape);
    hand.settle();
    assert!(seen(&mut hand) == plain);
}

fn press_like(hand: &mut User, text: &str) {
    let at = hand.place_like(text).center();
    hand.click(at);
    hand.settle();
}

/// By *View transform* the picture at rest, kept frames and files of frames are shown alike, as the
/// view shows them.
#[test]
fn picture_and_kept_frames_are_shown_by_a_view() {
    const VIEW: &str = "ACES 2.0 - SDR 100 nits (Rec.709)";
    let mut hand = moving();
    let plain = seen(&mut hand);
    hand.press("Options");
    hand.press("View transform: sRGB");
    press_like(&mut hand, "sRGB - Display");
    hand.press(VIEW);
    hand.key(Key::Escape);
    hand.key(Key::Escape);
    hand.settle();
    let chosen = hand.app().settings().display.clone().expect("the window remembers it");
    assert_eq!((&*chosen.config, &*chosen.view), (BUILT_IN, VIEW));
    assert_eq!(hand.app().session().steps().done(), 1, "the look stays as it is");
    let shown = seen(&mut hand);
    let view = ColorConfig::open(BUILT_IN).unwrap().view(Some(&chosen.display), VIEW).unwrap();
    let near = |shown: &[u8], plain: &[u8]| {
        let pixels = plain.chunks_exact(4);
        let rgba = pixels.map(|of| std::array::from_fn(|at| f32::from(of[at]) / 255.0)).collect();
        let picture = Picture { size: [plain.len() as u32 / 4, 1], rgba };
        let wanted = view.show(&picture).to_rgba8();
        assert_eq!(shown.len(), wanted.len());
        // What goes in was rounded to 8 bits here, and views are steep at the edge of their colors;
        // at outlines pixels of a kept frame are mixed after the view.
        let apart = || shown.iter().zip(&wanted).map(|(a, b)| a.abs_diff(*b));
        let mean = apart().map(f64::from).sum::<f64>() / shown.len() as f64;
        let beyond = apart().filter(|apart| *apart > 6).count();
        assert!(beyond < shown.len() / 20 && mean < 0.5, "{beyond} of {}, {mean}", shown.len());
        assert!(shown.iter().zip(plain).any(|(a, b)| a.abs_diff(*b) > 20), "it shows a difference");
    };
    near(&shown, &plain);
    // The flip book shows kept frames in place of the picture, in less room.
    hand.press("Cache range");
    hand.press("Keep version");
    scrub_to(&mut hand, 0.0);
    let kept = seen(&mut hand);
    hand.press("Options");
    press_like(&mut hand, "View transform: ACES");
    hand.press("sRGB");
    hand.key(Key::Escape);
    hand.key(Key::Escape);
    hand.settle();
    assert!(hand.app().settings().display.is_none());
    near(&kept, &seen(&mut hand));
}

/// Chooses another document in the list that shows what the picture is compared with.
fn compare(hand: &mut User, list: &str) {
    let lists = hand.harness.query_all_by_role(Role::ComboBox);
    let found = lists.into_iter().find(|node| node.value().as_deref() == Some(list));
    let at = found.expect("the list of what to compare with").rect().center();
    hand.click(at);
    hand.press("Another document...");
    hand.settle();
}

#[test]
fn another_document_is_drawn_to_be_compared() {
    let mut hand = moving();
    let folder = tempfile::tempdir().unwrap();
    let same = folder.path().join("same.json");
    std::fs::write(&same, hand.look().to_text()).unwrap();
    let mut other = hand.look().clone();
    other.time_keys[0].keys[2].value = Value::Number(0.9);
    let path = folder.path().join("other.json");
    std::fs::write(&path, other.to_text()).unwrap();
    scrub_to(&mut hand, 6.0);
    hand.app_mut().answer_dialog(&same);
    compare(&mut hand, "Compare");
    assert!(hand.says("9 of 9 kept") && hand.says("0 differ"), "the same look is the same");
    hand.app_mut().answer_dialog(&path);
    compare(&mut hand, "same.json");
    assert!(hand.says("4 differ"), "frames 5 to 8 lead to another key");
    hand.press("Greatest difference");
    assert!((hand.app().session().view().time() - 8.0 / 24.0).abs() < 1e-3);
    // Both are seen from where the window looks.
    let middle: Pos2 = hand.app().viewport().rect().unwrap().center();
    hand.drag(middle, middle + eframe::egui::vec2(60.0, 0.0));
    hand.settle();
    hand.press("Cache range");
    hand.settle();
    assert!(hand.says("4 differ"));
    let broken = folder.path().join("broken.json");
    std::fs::write(&broken, "{\"chiaro\": \"look\", \"nodes\": 3}").unwrap();
    hand.app_mut().answer_dialog(&broken);
    compare(&mut hand, "other.json");
    assert!(hand.says("broken.json"), "a document that cannot be read is named");
    hand.press("Close flip book");
}
