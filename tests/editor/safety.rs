//! Work is never lost: it is offered again after a crash and goes on after a window was closed, and
//! changes of files by other programs are noticed.

use std::fs;
use std::path::Path;
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use crate::editor_support::home::Home;
use crate::editor_support::{User, node_center};
use chiaro::document::{Edit, GraphId, Value};
use chiaro::editor::App;
use chiaro::editor::settings::Theme;
use chiaro::files::{Disk, FileMetadata, Files, FoundFiles, ReadError, WalkBounds};
use eframe::egui::{Event, Key, Modifiers, Role, ViewportEvent, ViewportId, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

const OFFER: &str = "Work that was not saved";

fn set_offset(hand: &mut User, value: f64) {
    let (graph, id) = (GraphId::Look, "diffuse".into());
    let edit = Edit::SetValue {
        graph,
        id,
        port: "offset".into(),
        value: Value::Number(value),
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    hand.app().session().wait_for_journal();
}

fn offset(hand: &User) -> Option<f64> {
    match hand.look().graph.nodes["diffuse"].values.get("offset") {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    }
}

#[test]
fn work_is_taken_back_after_a_crash_with_its_past() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    assert!(!hand.says(OFFER));
    assert!(hand.app_mut().save_as(&path));
    hand.click(node_center(&hand, "base"));
    hand.key(Key::Delete);
    set_offset(&mut hand, 0.5);
    set_offset(&mut hand, 0.75);
    hand.undo();
    let before = hand.look().clone();

    let later = home.after_a_crash();
    let mut hand = later.window(None);
    assert_eq!(
        hand.look().graph.nodes.len(),
        3,
        "a crash may come from the work itself: it is only offered"
    );
    assert!(hand.says("rim.json, 2 changes, just now"));
    hand.press("Restore it");
    assert_eq!(*hand.look(), before);
    assert_eq!(hand.app().session().path(), Some(path.as_path()));
    assert!(hand.app().session().is_dirty() && !hand.says(OFFER));
    hand.redo();
    assert_eq!(offset(&hand), Some(0.75));
    for _ in 0..3 {
        hand.undo();
    }
    assert_eq!(hand.look().graph.nodes.len(), 3);
    assert!(!hand.app().session().is_dirty(), "back where it was saved");
    hand.app_mut().save_as(&path);

    // Restored work is kept like any other, also past another crash.
    set_offset(&mut hand, 0.25);
    let again = later.after_a_crash();
    let mut hand = again.window(None);
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(0.25));
}

#[test]
fn a_drag_that_a_crash_ends_is_there() {
    let home = Home::new();
    let mut hand = home.window(None);
    hand.click(node_center(&hand, "diffuse"));
    let slider = hand.slider("Offset");
    hand.drag(slider.left_center() + eframe::egui::vec2(4.0, 0.0), slider.center());
    hand.settle();
    hand.app().session().wait_for_journal();
    let value = offset(&hand).expect("the drag set it");
    let later = home.after_a_crash();
    let mut hand = later.window(None);
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(value));
    hand.undo();
    assert_eq!(offset(&hand), None, "one step, as before");
}

#[test]
fn the_camera_is_where_it_was_after_a_crash_and_is_no_step() {
    let home = Home::new();
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.3);
    let steps = hand.steps();
    let before = hand.app().session().view().orbit().clone();
    // A drag beside the object walks around it, a drag on the object turns the lights; the wheel
    // comes nearer.
    let picture = hand.app().viewport().rect().unwrap();
    hand.drag(picture.left_top() + vec2(6.0, 60.0), picture.left_top() + vec2(60.0, 90.0));
    hand.drag(picture.center() + vec2(0.0, 30.0), picture.center() + vec2(50.0, 60.0));
    hand.wheel(picture.center(), 120.0);
    hand.settle();
    let orbit = hand.app().session().view().orbit().clone();
    assert!(orbit.yaw != before.yaw && orbit.distance < before.distance);
    assert!(orbit.illumination.angle_between(before.illumination) > 0.05);
    assert_eq!(hand.steps(), steps, "looking around is no step");
    hand.app().session().wait_for_journal();
    home.wait_until_written();

    let later = home.after_a_crash();
    let mut hand = later.window(None);
    assert_eq!(
        hand.app().session().view().orbit().yaw,
        before.yaw,
        "nothing is taken back unasked"
    );
    hand.press("Restore it");
    let taken = hand.app().session().view().orbit();
    assert!(taken.illumination.angle_between(orbit.illumination) < 1e-9);
    assert_eq!((taken.yaw, taken.pitch, taken.distance), (orbit.yaw, orbit.pitch, orbit.distance));
    assert_eq!((hand.steps(), offset(&hand)), (steps, Some(0.3)));
}

#[test]
fn a_living_window_is_not_robbed() {
    let home = Home::new();
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.5);
    let other = home.window(None);
    assert!(!other.says(OFFER));
    assert_eq!(offset(&other), None);
    assert_eq!(offset(&hand), Some(0.5));
}

#[test]
fn what_is_thrown_away_stays_until_the_window_closes() {
    let home = Home::new();
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.5);
    let later = home.after_a_crash();
    let mut hand = later.window(None);
    hand.press("Throw it away");
    assert!(hand.says("are thrown away when this window closes") && later.journals() == 1);
    hand.press("Keep it");
    drop(hand);
    let mut hand = later.window(None);
    hand.press("Throw it away");
    drop(hand);
    assert_eq!(later.journals(), 0);
    assert!(!later.window(None).says(OFFER));
}

#[test]
fn work_of_several_documents_is_one_bar_with_a_list() {
    let home = Home::new();
    let mut windows: Vec<User> = (1..=3).map(|_| home.window(None)).collect();
    for (hand, value) in windows.iter_mut().zip([0.1, 0.2, 0.3]) {
        set_offset(hand, value);
    }
    let later = home.after_a_crash();
    drop(windows);
    let mut hand = later.window(None);
    let bars = |hand: &User| hand.harness.query_all_by_label_contains(OFFER).count();
    assert!(bars(&hand) == 1 && hand.says("of 3 documents"));
    assert!(!hand.says("Restore it"), "the list has them");
    hand.press("Choose...");
    assert_eq!(hand.harness.query_all_by_label("Restore it").count(), 3);
    hand.press("Throw it away");
    assert_eq!(hand.harness.query_all_by_label("Keep it").count(), 1, "the list stays open");
    hand.press("Restore it");
    assert!(offset(&hand).is_some());
    hand.key(Key::Escape);
    hand.settle();
    assert!(bars(&hand) == 1 && hand.says("of 2 documents"));
    hand.press("Throw all away");
    drop(hand);
    assert_eq!(later.journals(), 1, "what was restored stays");
}

#[test]
fn a_damaged_journal_gives_what_it_can_and_says_so() {
    let home = Home::new();
    let mut hand = home.window(None);
    for value in [0.111, 0.222, 0.333] {
        set_offset(&mut hand, value);
    }
    let journal_of = |home: &Home| {
        let mut entries =
            fs::read_dir(home.places().journals()).unwrap().flatten().map(|entry| entry.path());
        entries.find(|path| path.extension().is_some_and(|ending| ending == "journal")).unwrap()
    };
    let later = home.after_a_crash();
    let path = journal_of(&later);
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replacen("0.222", "9.222", 1)).unwrap();
    let mut hand = later.window(None);
    assert!(hand.says("a part of it was damaged and is lost"));
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(0.111));

    let later = home.after_a_crash();
    fs::write(journal_of(&later), "nothing good").unwrap();
    let hand = later.window(None);
    assert!(hand.says("nothing in it can be read"));
    assert!(hand.harness.query_by_label("Restore it").is_none());
    drop(hand);
    assert_eq!(later.journals(), 1, "what nobody threw away stays");
}

/// Asks the window to close, as the title bar's button does.
fn close(hand: &mut User) {
    let input = hand.harness.input_mut();
    input.viewports.get_mut(&ViewportId::ROOT).unwrap().events.push(ViewportEvent::Close);
    hand.harness.step();
    hand.harness.input_mut().viewports.get_mut(&ViewportId::ROOT).unwrap().events.clear();
}

#[test]
fn a_closed_window_goes_on_where_it_was() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    set_offset(&mut hand, 0.5);
    let saved = fs::read_to_string(&path).unwrap();
    close(&mut hand);
    assert!(
        hand.harness.query_by_label("Do not save").is_none(),
        "nothing is asked, since nothing is lost"
    );
    drop(hand);
    assert_eq!(fs::read_to_string(&path).unwrap(), saved, "and nothing is saved unasked");

    let mut hand = home.window(None);
    assert_eq!(offset(&hand), Some(0.5));
    assert_eq!(hand.app().session().path(), Some(path.as_path()));
    assert!(hand.app().session().is_dirty() && !hand.says(OFFER));
    drop(hand);
    // The work also goes on where the file is named on the command line.
    hand = home.window(Some(&path));
    assert_eq!(offset(&hand), Some(0.5));
    hand.undo();
    assert!(!hand.app().session().is_dirty());
    drop(hand);
    assert_eq!(home.journals(), 0, "what is saved needs no journal");
    assert_eq!(offset(&home.window(None)), None);
}

/// A window whose program renders for a minute, with a look that has a file.
#[cfg(unix)]
fn window_of_a_slow_program(home: &Home) -> User {
    use std::os::unix::fs::PermissionsExt as _;
    let program = home.file("slow");
    fs::write(&program, "#!/bin/sh\nexec sleep 60\n").unwrap();
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).unwrap();
    let mut hand = User::with(move |ctx| App::new(ctx, None).rendering_by(&program));
    hand.app_mut().save_as(&home.file("rim.json"));
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("Render frames");
    hand.key(Key::Enter);
    hand.settle();
    hand
}

#[cfg(unix)]
#[test]
fn closing_asks_before_it_stops_what_is_rendered() {
    let home = Home::new();
    let mut hand = window_of_a_slow_program(&home);
    let click = |hand: &mut User, label: &str| {
        let at = hand.place(label).center();
        hand.click(at);
    };
    const ASKED: &str = "Closing stops what is being made";
    click(&mut hand, "Render 48 frames");
    assert!(hand.app().is_busy() && !hand.has(ASKED));
    close(&mut hand);
    hand.harness.run_steps(3);
    assert!(hand.has(ASKED) && hand.says("0 of 48 frames of rim.json are whole"));
    click(&mut hand, "Stay");
    assert!(hand.app().is_busy() && !hand.has(ASKED));
    close(&mut hand);
    hand.harness.run_steps(3);
    click(&mut hand, "Stop and close");
    hand.app().wait();
    assert!(!hand.app().is_busy() && !hand.has(ASKED), "the program has ended");
}

#[test]
fn a_named_file_that_has_changed_since_is_opened_as_it_is() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    set_offset(&mut hand, 0.5);
    drop(hand);
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("\"Rim\"", "\"Theirs\"")).unwrap();
    let mut hand = home.window(Some(&path));
    assert_eq!((hand.look().name.as_str(), offset(&hand)), ("Theirs", None));
    assert!(hand.says(OFFER));
    // After restoring, both versions can be chosen.
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(0.5));
    assert!(hand.says("was changed by another program, and by you"));
}

#[test]
fn work_of_a_program_that_dies_slowly_is_offered_as_soon_as_it_lets_go() {
    let home = Home::new();
    let mut dying = home.window(None);
    set_offset(&mut dying, 0.5);
    let mut hand = home.window(None);
    assert!(!hand.says(OFFER), "it is in use, as far as anybody knows");
    dying.app_mut().session_mut().close_journal(false);
    drop(dying);
    // Six seconds: four frames a second by the window's clock.
    hand.harness.run_steps(24);
    assert!(hand.says("New look, 1 change"));
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(0.5));
}

#[test]
fn another_look_puts_this_one_aside() {
    let home = Home::new();
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.5);
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(hand.harness.query_by_label("Do not save").is_none(), "nothing is asked");
    assert_eq!(offset(&hand), None);
    assert!(hand.says("New look, 1 change, just now"));
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(0.5));
    assert!(!hand.says(OFFER), "the new look had nothing to be kept");
}

#[test]
fn the_past_of_a_saved_look_survives_a_crash() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.5);
    hand.app_mut().save_as(&path);
    hand.settle();
    hand.app().session().wait_for_journal();
    let later = home.after_a_crash();
    let mut hand = later.window(Some(&path));
    assert!(!hand.says(OFFER) && !hand.app().session().is_dirty(), "it is saved");
    hand.undo();
    assert_eq!(offset(&hand), None);
}

#[test]
fn a_file_changed_by_others_is_loaded_again_as_one_step() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("\"Diffuse\"", "\"Theirs\"")).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.look().graph.nodes["diffuse"].name, "Theirs");
    assert!(!hand.app().session().is_dirty() && hand.says("loaded again"));
    let selected: Vec<String> =
        hand.app().session().selection().nodes().map(ToString::to_string).collect();
    assert_eq!(selected, ["diffuse"]);
    hand.undo();
    assert_eq!(hand.look().graph.nodes["diffuse"].name, "Diffuse");
    assert!(hand.app().session().is_dirty());
    hand.redo();
    // A file edited by hand is saved in its own formatting.
    hand.app_mut().save_as(&path);
    assert_eq!(fs::read_to_string(&path).unwrap(), text.replace("\"Diffuse\"", "\"Theirs\""));

    // A file that cannot be read, half written for example, leaves the look as it is; once it can
    // be read, it is loaded.
    fs::write(&path, "{ \"nodes\": 12").unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.look().graph.nodes.len(), 3);
    assert!(hand.says("cannot be read now"));
    fs::write(&path, text.replace("\"Diffuse\"", "\"Mended\"")).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.look().graph.nodes["diffuse"].name, "Mended");
    assert!(!hand.says("cannot be read now"));
}

#[test]
fn of_two_versions_one_is_chosen_and_the_other_not_lost() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    let theirs = |name: &str| {
        fs::read_to_string(&path).unwrap().replace("\"Diffuse\"", &format!("\"{name}\""))
    };
    set_offset(&mut hand, 0.5);
    fs::write(&path, theirs("Theirs")).unwrap();
    // Before the window has noticed the change: saving does not overwrite a version that nobody has
    // seen.
    let before = fs::read_to_string(&path).unwrap();
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(fs::read_to_string(&path).unwrap(), before);
    assert!(hand.says("was changed by another program, and by you"));
    hand.press("Load the file's version");
    assert_eq!((offset(&hand), hand.look().graph.nodes["diffuse"].name.as_str()), (None, "Theirs"));
    hand.undo();
    assert_eq!(offset(&hand), Some(0.5), "mine is one step away");

    fs::write(&path, before.replace("Theirs", "Once more")).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    hand.press("Keep mine");
    assert!(!hand.says("was changed by another program, and by you"));
    hand.key_with(Modifiers::COMMAND, Key::S);
    assert!(!hand.app().session().is_dirty());
    assert!(fs::read_to_string(&path).unwrap().contains("\"offset\": 0.5"));
}

#[test]
fn a_removed_file_is_told_and_saved_again() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    hand.settle();
    hand.app_mut().look_at_files();
    fs::remove_file(&path).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert!(hand.says("rim.json was removed or moved"));
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.app_mut().look_at_files();
    hand.settle();
    assert!(path.exists() && !hand.says("rim.json was removed or moved"));
}

/// Runs frames until the system's report of a changed file has come to the window.
fn wait_until(hand: &mut User, is_so: impl Fn(&User) -> bool) {
    for _ in 0..200 {
        hand.harness.run_steps(12);
        if is_so(hand) {
            return;
        }
        std::thread::park_timeout(Duration::from_millis(50));
    }
    panic!("nothing was noticed in ten seconds");
}

#[test]
fn the_system_tells_of_changed_files() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    hand.settle();
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replace("\"Diffuse\"", "\"Theirs\"")).unwrap();
    wait_until(&mut hand, |hand| hand.look().graph.nodes["diffuse"].name == "Theirs");
    // A change is also noticed where another file is renamed over the file, as careful programs
    // write.
    let other = home.file("other");
    fs::write(&other, text.replace("\"Diffuse\"", "\"Again\"")).unwrap();
    fs::rename(&other, &path).unwrap();
    wait_until(&mut hand, |hand| hand.look().graph.nodes["diffuse"].name == "Again");
}

#[test]
fn coming_back_to_the_window_looks_at_files() {
    let home = Home::new();
    let path = home.file("rim.json");
    let mut hand = home.window(None);
    hand.app_mut().save_as(&path);
    hand.settle();
    fs::write(&path, fs::read_to_string(&path).unwrap().replace("\"Diffuse\"", "\"Theirs\""))
        .unwrap();
    hand.harness.event(Event::WindowFocused(true));
    hand.harness.step();
    assert_eq!(hand.look().graph.nodes["diffuse"].name, "Theirs");
}

const NODE: &str = "/// Twice\n///\n/// @param value \"Value\" default=0.5 : What comes in.\n/// \
                    @return value \"Value\" : Twice that.\nfn twice(value: f32) -> f32 \
                    {\n    return 2.0 * value;\n}\n";

#[test]
fn node_files_are_loaded_again_and_a_broken_one_keeps_the_picture() {
    let home = Home::new();
    let path = home.file("rim.json");
    fs::create_dir(home.file("nodes")).unwrap();
    let node = home.file("nodes/twice.wgsl");
    fs::write(&node, NODE).unwrap();
    let text = r#"{"nodes": [{"id": "mine", "kind": "twice", "values": {"value": 0.25}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "mine", "to": "output.color"}]}"#;
    fs::write(&path, text).unwrap();
    let mut hand = home.window(Some(&path));
    assert!(
        hand.app().session().compilation().problems().is_empty(),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    let wgsl = |hand: &User| hand.app().session().compilation().baked().unwrap().wgsl.clone();
    let first = wgsl(&hand);

    fs::write(&node, NODE.replace("2.0 * value", "7.5 * value")).unwrap();
    wait_until(&mut hand, |hand| hand.says("nodes were loaded again"));
    hand.settle();
    assert_ne!(wgsl(&hand), first);
    let good = wgsl(&hand);

    fs::write(&node, NODE.replace("2.0 * value", "2.0 * valu")).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert!(hand.app().canvas().has_error("mine"), "the error is shown at the node");
    assert!(hand.says("valu"));
    assert_eq!(wgsl(&hand), good, "the last good one stays");
    set_value(&mut hand);
    assert!(hand.app().session().compilation().problems().is_empty(), "and goes on to work");

    fs::write(&node, NODE).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert!(!hand.app().canvas().has_error("mine"));
}

/// The disk, whose folders are walked through only while the gate is open.
#[derive(Debug, Default)]
struct GatedDisk {
    gate: Mutex<Gate>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Gate {
    is_closed: bool,
    /// Number of walks that wait.
    waiting: u32,
}

impl GatedDisk {
    fn set_closed(&self, is_closed: bool) {
        self.gate.lock().unwrap().is_closed = is_closed;
        self.changed.notify_all();
    }

    /// Waits until a walk stands at the closed gate.
    fn wait_for_walk(&self) {
        let is_nobody_here = |gate: &mut Gate| gate.waiting == 0;
        let minute = Duration::from_secs(60);
        let here = self
            .changed
            .wait_timeout_while(self.gate.lock().unwrap(), minute, is_nobody_here)
            .unwrap();
        assert!(!here.1.timed_out(), "no folder was walked through");
    }
}

impl Files for GatedDisk {
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
        Disk.read(path, most)
    }

    fn metadata(&self, path: &Path) -> Option<FileMetadata> {
        Disk.metadata(path)
    }

    fn walk(
        &self,
        folder: &Path,
        bounds: WalkBounds,
        enters: &dyn Fn(&Path) -> bool,
    ) -> FoundFiles {
        let mut gate = self.gate.lock().unwrap();
        gate.waiting += 1;
        self.changed.notify_all();
        let minute = Duration::from_secs(60);
        let mut gate =
            self.changed.wait_timeout_while(gate, minute, |gate| gate.is_closed).unwrap().0;
        gate.waiting -= 1;
        drop(gate);
        Disk.walk(folder, bounds, enters)
    }
}

/// The system does not tell of a folder that was replaced by another of the same name: the new one
/// is watched since it was noticed, beside a scene as beside a look alone.
#[test]
fn a_replaced_folder_of_nodes_is_watched_beside_a_scene() {
    let home = Home::new();
    let nodes = home.file("nodes");
    let write = |factor: &str| {
        fs::write(nodes.join("twice.wgsl"), NODE.replace("2.0 * value", factor)).unwrap();
    };
    fs::create_dir(&nodes).unwrap();
    write("2.0 * value");
    let look = r#"{"nodes": [{"id": "mine", "kind": "twice", "values": {"value": 0.25}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "mine", "to": "output.color"}]}"#;
    fs::write(home.file("rim.json"), look).unwrap();
    let scene = r#"{"chiaro": "scene",
        "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "rim.json"}]}"#;
    fs::write(home.file("scene.json"), scene).unwrap();
    let mut hand = home.window(None);
    hand.app_mut().open(&home.file("scene.json"));
    hand.settle();
    assert!(hand.look().graph.nodes.contains_key("mine"));
    let wgsl = |hand: &User| hand.app().session().compilation().baked().map(|it| it.wgsl.clone());
    let first = wgsl(&hand);

    fs::rename(&nodes, home.file("away")).unwrap();
    fs::create_dir(&nodes).unwrap();
    write("7.5 * value");
    hand.app_mut().look_at_files();
    wait_until(&mut hand, |hand| wgsl(hand).is_some_and(|text| Some(text) != first));
    let second = wgsl(&hand);
    // Nothing asks whether this file has changed, so only the system can tell.
    write("3.25 * value");
    wait_until(&mut hand, |hand| wgsl(hand).is_some_and(|text| Some(text) != second));
}

#[test]
fn frames_go_on_while_a_folder_of_nodes_is_walked_through() {
    let home = Home::new();
    let path = home.file("rim.json");
    fs::create_dir(home.file("nodes")).unwrap();
    let node = home.file("nodes/twice.wgsl");
    fs::write(&node, NODE).unwrap();
    let text = r#"{"nodes": [{"id": "mine", "kind": "twice", "values": {"value": 0.25}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "mine", "to": "output.color"}]}"#;
    fs::write(&path, text).unwrap();
    let disk = Arc::new(GatedDisk::default());
    let files = disk.clone();
    let mut hand = User::with(move |ctx| App::reading_from(files.clone(), ctx, None));

    disk.set_closed(true);
    hand.app_mut().open(&path);
    hand.harness.run_steps(4);
    disk.wait_for_walk();
    hand.harness.run_steps(4);
    let session = hand.app().session();
    assert!(session.look().graph.nodes.contains_key("mine") && session.is_compiling());
    assert!(session.compilation().baked().is_none(), "it is not compiled without the nodes");
    disk.set_closed(false);
    hand.settle();
    let compilation = hand.app().session().compilation();
    assert!(compilation.problems().is_empty(), "{:?}", compilation.problems());
    let good = compilation.baked().unwrap().wgsl.clone();

    // A check whether files have changed walks there, too, and the look goes on meanwhile.
    disk.set_closed(true);
    fs::write(&node, NODE.replace("2.0 * value", "7.5 * value")).unwrap();
    hand.app_mut().look_at_files();
    disk.wait_for_walk();
    hand.harness.run_steps(4);
    assert!(!hand.app().session().is_compiling() && !hand.says("nodes were loaded again"));
    assert_eq!(hand.app().session().compilation().baked().unwrap().wgsl, good);
    disk.set_closed(false);
    hand.settle();
    assert!(hand.says("nodes were loaded again"));
    assert_ne!(hand.app().session().compilation().baked().unwrap().wgsl, good);
}

fn set_value(hand: &mut User) {
    let (graph, id, value) = (GraphId::Look, "mine".into(), Value::Number(0.75));
    let edit = Edit::SetValue { graph, id, port: "value".into(), value, index: None };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
}

#[test]
fn a_mesh_that_was_stood_up_stays_so() {
    let home = Home::new();
    let mesh = home.file("tri.obj");
    fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n").unwrap();
    let mesh = mesh.to_string_lossy().into_owned();
    let stands = |hand: &User| hand.app().session().view().orbit().z_is_up;
    let mut hand = home.window(None);
    hand.app_mut().show_on(&mesh);
    hand.settle();
    hand.press("Options");
    assert!(!stands(&hand));
    hand.press_a(Role::CheckBox, "Z is up");
    hand.key(Key::Escape);
    assert!(stands(&hand));
    // The setting holds under another look, and in another window.
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(stands(&hand));
    drop(hand);
    let mut hand = home.window(None);
    assert!(stands(&hand) && hand.app().session().view().orbit().mesh == mesh);
    hand.app_mut().show_on(&mesh);
    assert!(stands(&hand), "named again it is the same");
    // The mesh chosen next has its own setting, which is remembered too.
    hand.choose("On", "Torus");
    assert!(!stands(&hand) && hand.app().session().view().orbit().mesh == "shape:torus");
    drop(hand);
    let hand = home.window(None);
    assert!(!stands(&hand) && hand.app().session().view().orbit().mesh == "shape:torus");
}

#[test]
fn meshes_and_images_are_loaded_again() {
    let home = Home::new();
    let (path, mesh, image) = (home.file("rim.json"), home.file("tri.obj"), home.file("skin.png"));
    fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let paint = |value: u8| {
        image::RgbaImage::from_pixel(2, 2, image::Rgba([value, 0, 0, 255])).save(&image).unwrap();
    };
    paint(10);
    let text = r#"{"nodes": [{"id": "skin", "kind": "image", "values": {"image": "skin.png"}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "skin", "to": "output.color"}]}"#;
    fs::write(&path, text).unwrap();
    let mut hand = home.window(Some(&path));
    assert!(
        hand.app().session().compilation().problems().is_empty(),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    hand.app_mut().show_on(&mesh.to_string_lossy());
    hand.settle();
    fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n# longer\n").unwrap();
    wait_until(&mut hand, |hand| hand.says("tri.obj was loaded again"));
    image::RgbaImage::from_pixel(3, 3, image::Rgba([200, 0, 0, 255])).save(&image).unwrap();
    wait_until(&mut hand, |hand| hand.says("skin.png was loaded again"));
    fs::remove_file(&image).unwrap();
    wait_until(&mut hand, |hand| hand.says("skin.png is not there any more"));
    assert!(!hand.app().session().is_dirty());
}

#[test]
fn a_folder_that_cannot_be_written_is_told_once_and_editing_goes_on() {
    let home = Home::new();
    fs::write(home.file("state"), "a file is in the way").unwrap();
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.5);
    hand.settle();
    assert!(hand.says("a crash now would lose what is not saved"));
    hand.press("Understood");
    set_offset(&mut hand, 0.75);
    hand.settle();
    assert!(!hand.says("a crash now would lose what is not saved"));
    assert_eq!(offset(&hand), Some(0.75));
    // Without a journal closing would lose work, so the window asks.
    close(&mut hand);
    hand.harness.run_steps(3);
    assert!(hand.says("Do not save"));
    hand.press("Cancel");

    // Once the folder can be written, the work is kept without any action.
    fs::remove_file(home.file("state")).unwrap();
    wait_until(&mut hand, |_| home.journals() == 1);
    let later = home.after_a_crash();
    let mut hand = later.window(None);
    hand.press("Restore it");
    assert_eq!(offset(&hand), Some(0.75));
}

#[test]
fn files_that_were_open_are_listed() {
    let home = Home::new();
    let mut hand = home.window(None);
    for name in ["one.json", "two.json", "three.json"] {
        assert!(hand.app_mut().save_as(&home.file(name)));
    }
    fs::remove_file(home.file("two.json")).unwrap();
    drop(hand);
    let mut hand = home.window(None);
    hand.press("Recent");
    let rect = |name: &str| hand.harness.get_by_label(name).rect();
    assert!(
        rect("three.json").min.y < rect("two.json").min.y
            && rect("two.json").min.y < rect("one.json").min.y
    );
    assert!(hand.harness.get_by_label("two.json").accesskit_node().is_disabled());
    hand.press("one.json");
    assert_eq!(hand.app().session().path(), Some(home.file("one.json").as_path()));
    assert_eq!(hand.app().settings().recent[0], home.file("one.json"));
}

#[test]
fn theme_scale_and_panels_are_remembered() {
    let home = Home::new();
    let mut hand = home.window(None);
    hand.press("View");
    hand.press("Light");
    hand.press("View");
    hand.press("Scale 125%");
    assert_eq!((hand.app().settings().theme, hand.app().settings().scale), (Theme::Light, 1.25));
    drop(hand);
    let mut hand = home.window(None);
    assert_eq!(hand.harness.ctx.theme(), eframe::egui::Theme::Light);
    assert_eq!(hand.harness.ctx.zoom_factor(), 1.25);
    hand.harness.ctx.set_zoom_factor(1.0);
    hand.settle();
    assert!(
        hand.harness.query_by_role_and_label(eframe::egui::accesskit::Role::Tab, "Code").is_some()
    );
    hand.press("View");
    let code = hand
        .harness
        .get_by_role_and_label(eframe::egui::accesskit::Role::CheckBox, "Code")
        .rect()
        .center();
    hand.click(code);
    hand.settle();
    drop(hand);
    let hand = home.window(None);
    assert!(hand.app().settings().layout.is_some());
    let code = hand.harness.query_by_role_and_label(eframe::egui::accesskit::Role::Tab, "Code");
    assert!(code.is_none(), "the panel was closed");
}

#[test]
fn a_window_that_keeps_work_rests() {
    let home = Home::new();
    let mut hand = home.window(None);
    set_offset(&mut hand, 0.5);
    hand.harness.run_steps(12);
    hand.settle();
    assert_eq!(hand.repaint_delay(), Duration::MAX);
}
