//! Scenes of several objects in the window: scenes are opened, changed, saved and undone; looks are
//! switched without loss.

use crate::support::wait::block_on;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor_support::{User, set_text};
use chiaro::compile::{CompileOptions, Live, compile};
use chiaro::document::{Edit, Scene};
use chiaro::editor::{App, Places};
use chiaro::frame::{Assets, CullMode, Draw, Picture, PlanOptions, Planner, Setup, Stage, open};
use chiaro::library::Library;
use chiaro::render::{Gpu, Renderer};
use eframe::egui::{DroppedFile, Event, Key, Modifiers, Pos2, Role, vec2};
use egui_kittest::kittest::Queryable as _;

const CAST: &str = "examples/scenes/cast.json";
const BEHIND: &str = "examples/scenes/figure5-from-behind.json";

/// A folder with a scene of two objects in two looks, and with the state of its user's windows.
struct Home {
    folder: tempfile::TempDir,
}

impl Home {
    fn new() -> Self {
        let home = Self { folder: tempfile::tempdir().unwrap() };
        fs::create_dir(home.file("looks")).unwrap();
        for name in ["figure4-color", "figure6-minimal"] {
            fs::copy(
                format!("examples/looks/{name}.json"),
                home.file(&format!("looks/{name}.json")),
            )
            .unwrap();
        }
        fs::write(home.scene(), TWO).unwrap();
        home
    }

    fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn scene(&self) -> PathBuf {
        self.file("two.json")
    }

    fn look(&self, name: &str) -> PathBuf {
        self.file("looks").join(name)
    }

    /// A window with this folder's state, opened as the program opens a file or, without one, its
    /// start.
    fn window(&self, file: Option<&Path>) -> User {
        let folder = self.folder.path().to_owned();
        let places = Places { state: folder.join("state"), config: folder.join("config") };
        let file = file.map(Path::to_path_buf);
        User::with(move |ctx| {
            let mut app = App::new(ctx, None).without_dialogs();
            app.keep_in(places.clone(), ctx);
            match &file {
                Some(file) => app.open(file),
                None => app.resume(),
            }
            app
        })
    }
}

const TWO: &str = r#"{
 "chiaro": "scene",
 "objects": [
  {"id": "ring", "mesh": "shape:torus", "transform": {"translate": [-1.2, 0, 0]},
  "looks": "looks/figure4-color.json"},
  {"id": "ball", "mesh": "shape:sphere", "transform": {"translate": [1.2, 0, 0]},
  "looks": "looks/figure6-minimal.json"}
 ],
 "camera": {"eye": [0, 0, 9]}
}
"#;

fn open_scene(hand: &User) -> &chiaro::editor::OpenScene {
    hand.app().session().open_scene().expect("a scene is open")
}

fn scene(hand: &User) -> &Scene {
    open_scene(hand).scene()
}

fn ids(hand: &User) -> Vec<String> {
    scene(hand).objects.keys().map(ToString::to_string).collect()
}

/// File name of the open look.
fn open_look(hand: &User) -> String {
    let path = hand.app().session().path();
    path.map_or_else(String::new, |path| path.file_name().unwrap().to_string_lossy().into_owned())
}

fn press(hand: &mut User, label: &str) {
    hand.harness.get_by_label(label).scroll_to_me();
    hand.settle();
    let at = hand.harness.get_by_label(label).rect().center();
    hand.click(at);
    hand.settle();
}

fn press_button(hand: &mut User, label: &str) {
    hand.bring(Role::Button, label);
    let at = hand.harness.get_by_role_and_label(Role::Button, label).rect().center();
    hand.click(at);
    hand.settle();
}

fn tab(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_role_and_label(Role::Tab, label).rect().center();
    hand.click(at);
    hand.settle();
}

/// Chooses an entry of a menu that a button opens.
fn choose(hand: &mut User, menu: &str, entry: &str) {
    press(hand, menu);
    press_button(hand, entry);
}

/// Types a number into the number field of this name.
fn set_number(hand: &mut User, field: &str, value: &str) {
    let at = hand.harness.get_by_role_and_label(Role::SpinButton, field).rect().center();
    hand.click(at);
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text(value);
    hand.key(Key::Enter);
    hand.settle();
}

fn set_name(hand: &mut User, name: &str) {
    let edit = Edit::SetLookName { name: name.to_owned() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
}

fn sees(hand: &User, text: &str) -> bool {
    hand.harness.query_all_by_label_contains(text).next().is_some()
}

/// The middle of an object on the screen, by the camera of the scene.
fn on_screen(hand: &User, id: &str) -> Pos2 {
    let rect = hand.app().viewport().rect().unwrap();
    let orbit = hand.app().session().view().orbit();
    let (right, up) = orbit.right_and_up();
    let at = glam::DVec3::from(scene(hand).objects[id].transform.translate) - orbit.target;
    let depth = match orbit.projection {
        chiaro::document::Projection::Perspective => {
            (orbit.distance - at.dot(orbit.direction())) / orbit.distance
        }
        chiaro::document::Projection::Orthographic => 1.0,
    };
    let scale = f64::from(rect.height()) / orbit.height() / depth;
    rect.center() + eframe::egui::vec2((at.dot(right) * scale) as f32, -(at.dot(up) * scale) as f32)
}

/// The picture of a scene as `chiaro render` draws it.
fn rendered(path: &Path, size: [u32; 2]) -> Picture {
    let mut planner = Planner::new(Assets::default());
    let setup = open(path, None, &mut planner.assets).unwrap().value;
    let options = PlanOptions { size, samples: 4, time: 0.0 };
    let plan = planner.plan(&setup, Library::built_in(), &Live::Keyed, &options).unwrap().value;
    let mut renderer =
        Renderer::new(block_on(Gpu::headless()).expect("an adapter; software Vulkan does"));
    block_on(renderer.picture(&plan)).unwrap()
}

/// True if the neighbors of a pixel differ from it by at most `range` of 255.
fn is_smooth(bytes: &[u8], size: [u32; 2], [x, y]: [u32; 2], range: u8) -> bool {
    let at = |x: u32, y: u32| &bytes[4 * (y * size[0] + x) as usize..][..3];
    let own = at(x, y);
    (x - 1..=x + 1)
        .flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y)))
        .all(|(x, y)| at(x, y).iter().zip(own).all(|(a, b)| a.abs_diff(*b) <= range))
}

#[test]
fn a_scene_is_seen_as_it_is_rendered() {
    for path in [CAST, BEHIND, "examples/scenes/figure4-curvature.json"].map(Path::new) {
        let mut hand = User::drawing();
        hand.app_mut().open(path);
        hand.settle();
        assert_eq!(hand.app().message(), None);
        let (rect, size) = {
            let rect = hand.app().viewport().rect().unwrap();
            (rect, [rect.width(), rect.height()].map(|side| side.round() as u32))
        };
        let wanted = rendered(path, size).to_rgba8();

        // The saved picture is the rendered one, edges of objects aside.
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("picture.png");
        hand.app_mut().save_picture(size, &file);
        hand.settle();
        let found = image::open(&file).unwrap().into_rgba8().into_raw();
        let pixels = (1..size[1] - 1).flat_map(|y| (1..size[0] - 1).map(move |x| [x, y]));
        let inner: Vec<_> = pixels.filter(|&at| is_smooth(&wanted, size, at, 24)).collect();
        assert!(inner.len() > (size[0] * size[1] / 2) as usize);
        for &[x, y] in &inner {
            let at = 4 * (y * size[0] + x) as usize;
            let is_near =
                (0..4).all(|channel| wanted[at + channel].abs_diff(found[at + channel]) <= 1);
            assert!(
                is_near,
                "{}: {x}, {y}: {:?} {:?}",
                path.display(),
                &wanted[at..at + 4],
                &found[at..at + 4]
            );
        }

        // The window shows the rendered picture too, except for marks that lie on it.
        hand.hover(rect.center());
        hand.key(Key::H);
        hand.harness.remove_cursor();
        hand.settle();
        let image = hand.harness.render().unwrap();
        let cost = hand.place_like("Cost of the picture").expand(2.0);
        let is_covered =
            |&&[x, y]: &&[u32; 2]| cost.contains(rect.min + vec2(x as f32 + 0.5, y as f32 + 0.5));
        let is_same = |&&[x, y]: &&[u32; 2]| {
            let at = 4 * (y * size[0] + x) as usize;
            let shown =
                image.get_pixel(rect.min.x.round() as u32 + x, rect.min.y.round() as u32 + y).0;
            (0..3).all(|channel| wanted[at + channel].abs_diff(shown[channel]) <= 2)
        };
        // Only flat places are compared: the picture need not lie on whole pixels of the screen.
        let flat: Vec<_> = inner
            .iter()
            .filter(|&&at| is_smooth(&wanted, size, at, 2))
            .filter(|at| !is_covered(at))
            .collect();
        let same = flat.iter().copied().filter(is_same).count();
        assert!(same * 1000 >= flat.len() * 995, "{}: {same} of {}", path.display(), flat.len());
        let background = &wanted[..3];
        let objects = flat
            .iter()
            .filter(|[x, y]| wanted[4 * (y * size[0] + x) as usize..][..3] != *background)
            .count();
        assert!(objects > 1000, "objects are seen: {objects} of {}", flat.len());
    }
}

#[test]
fn every_object_wears_its_own_look_and_a_click_opens_it() {
    let mut hand = User::new();
    hand.app_mut().open(Path::new(CAST));
    hand.settle();
    assert_eq!(ids(&hand), ["layers", "minimal", "comics", "pastel", "directional", "both"]);
    assert_eq!(open_look(&hand), "figure1-layers.json");
    for (id, look) in [("pastel", "figure7-pastel.json"), ("minimal", "figure6-minimal.json")] {
        let at = on_screen(&hand, id);
        // Rings and knots have a hole in the middle; the tube is beside it.
        let at = if id == "minimal" { at + eframe::egui::vec2(0.0, 18.0) } else { at };
        hand.click(at);
        hand.settle();
        assert_eq!(open_scene(&hand).selected().map(|(id, _)| id.as_str()), Some(id));
        assert_eq!(open_look(&hand), look);
    }
    // A click beside all objects selects nothing, and the look stays open.
    let rect = hand.app().viewport().rect().unwrap();
    hand.click(rect.left_top() + eframe::egui::vec2(12.0, 12.0));
    assert!(open_scene(&hand).selected().is_none());
    assert_eq!(open_look(&hand), "figure6-minimal.json");
    // A click on an object's row selects it too.
    press(&mut hand, "Object directional");
    assert_eq!(open_look(&hand), "figure5-directional.json");
    // The pointer tells the object under it and the object's look.
    let at = on_screen(&hand, "pastel");
    hand.hover(at);
    assert!(sees(&hand, "pastel wears figure7-pastel.json"));
}

#[test]
fn a_look_alone_becomes_a_scene_by_adding_and_one_order_of_undo_takes_all_back() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.look("figure4-color.json")));
    assert!(hand.app().session().open_scene().is_none());
    tab(&mut hand, "Objects");
    assert!(sees(&hand, "The look is on one object"));
    choose(&mut hand, "Add an object", "Torus");
    assert_eq!(ids(&hand), ["creature", "torus"]);
    assert!(hand.app().session().is_dirty());
    assert_eq!(open_scene(&hand).selected().map(|(id, _)| id.as_str()), Some("torus"));
    // Both objects wear the open look, and both can be seen.
    let looks: Vec<_> =
        scene(&hand).objects.values().map(|object| object.looks["*"].clone()).collect();
    assert_eq!(looks[0], looks[1]);
    let place = scene(&hand).objects["torus"].transform.translate;
    assert!(place[0] > 2.0);

    set_number(&mut hand, "Place y", "0.5");
    assert_eq!(scene(&hand).objects["torus"].transform.translate, [place[0], 0.5, 0.0]);
    set_name(&mut hand, "mine");
    set_number(&mut hand, "Turn y", "90");
    let turned = scene(&hand).objects["torus"].transform.rotate;
    assert!((turned[1] - 0.5_f64.sqrt()).abs() < 1e-9, "{turned:?}");
    set_number(&mut hand, "Scale", "2");
    assert_eq!(scene(&hand).objects["torus"].transform.scale, [2.0; 3]);
    let steps: Vec<String> = hand.app().session().steps().labels().map(str::to_owned).collect();
    assert_eq!(steps, ["add torus", "move torus", "rename the look", "turn torus", "scale torus"]);

    // The newest step is undone first, whichever document it was in.
    hand.undo();
    assert_eq!(scene(&hand).objects["torus"].transform.scale, [1.0; 3]);
    hand.undo();
    assert_eq!(hand.look().name, "mine");
    hand.undo();
    assert_ne!(hand.look().name, "mine");
    assert_eq!(scene(&hand).objects["torus"].transform.translate[1], 0.5);
    hand.redo();
    hand.redo();
    assert_eq!(
        (hand.look().name.as_str(), scene(&hand).objects["torus"].transform.rotate),
        ("mine", turned)
    );
    hand.app_mut().session_mut().go_to(0);
    assert_eq!(ids(&hand), ["creature"]);
    hand.app_mut().session_mut().go_to(5);
    assert_eq!(scene(&hand).objects["torus"].transform.scale, [2.0; 3]);
}

#[test]
fn an_unsaved_stage_is_saved_as_a_scene_that_renders() {
    let home = Home::new();
    let mut hand = home.window(None);
    tab(&mut hand, "Objects");
    choose(&mut hand, "Add an object", "Knot");
    // The look has no file yet, and a scene names looks by their files: it gets one beside the
    // scene's, under a name that is free.
    let path = home.file("scenes");
    fs::create_dir(&path).unwrap();
    fs::write(path.join("new_look.json"), "another").unwrap();
    let path = path.join("mine.json");
    assert!(hand.app_mut().save_scene_as(&path));
    let told = hand.app().message().unwrap().to_owned();
    assert!(told.ends_with("and its look new_look_2.json beside it"), "{told}");
    assert!(!hand.app().session().is_dirty());
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains("\"looks\": \"new_look_2.json\""), "{text}");
    assert_eq!(fs::read_to_string(path.with_file_name("new_look.json")).unwrap(), "another");
    // With a file of its own the look stays there.
    assert!(hand.app_mut().save_as(&home.look("mine.json")));
    assert!(hand.app_mut().save_scene_as(&path));
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains("\"looks\": \"../looks/mine.json\""), "{text}");
    let (setup, problems) = open(&path, None, &mut Assets::default()).unwrap().into_parts();
    assert_eq!((setup.objects.len(), setup.looks.len(), problems.len()), (2, 1, 0), "{problems:?}");

    // The saved scene is opened again as it was.
    let camera = hand.app().session().view().orbit().camera();
    let mut hand = home.window(Some(&path));
    assert_eq!(ids(&hand), ["creature", "knot"]);
    assert_eq!(open_look(&hand), "mine.json");
    assert!(!hand.app().session().is_dirty());
    let before = scene(&hand).camera;
    assert!(before.eye != camera.eye, "all was framed, which is the window's own view");
    // The window begins with the scene's camera, until it is orbited; the scene's camera changes
    // only by a command.
    let corner = hand.app().viewport().rect().unwrap().left_top() + eframe::egui::vec2(20.0, 20.0);
    hand.drag(corner, corner + eframe::egui::vec2(60.0, 30.0));
    assert!(!hand.app().session().is_dirty());
    choose(&mut hand, "More of the scene", "Keep this view");
    let eye = glam::DVec3::from(scene(&hand).camera.eye);
    assert!(eye.distance(before.eye.into()) > 0.5 && hand.app().session().is_dirty());
    hand.undo();
    assert_eq!(scene(&hand).camera, before);
}

#[test]
fn saving_a_scene_unchanged_writes_it_byte_for_byte_and_changes_are_saved_with_one_key() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.scene()));
    assert!(hand.app_mut().save_scene_as(&home.scene()));
    assert_eq!(fs::read_to_string(home.scene()).unwrap(), TWO);
    press(&mut hand, "Object ball is seen");
    assert!(!scene(&hand).objects["ball"].visible);
    set_name(&mut hand, "renamed");
    assert!(sees(&hand, "figure4-color.json changed in two.json changed"));
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert!(!hand.app().session().is_dirty());
    assert!(fs::read_to_string(home.scene()).unwrap().contains("\"visible\": false"));
    assert!(fs::read_to_string(home.look("figure4-color.json")).unwrap().contains("renamed"));
}

#[test]
fn looks_are_switched_without_loss() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.scene()));
    assert_eq!(open_look(&hand), "figure4-color.json");
    set_name(&mut hand, "first");
    press(&mut hand, "Object ball");
    assert_eq!(open_look(&hand), "figure6-minimal.json");
    set_name(&mut hand, "second");
    choose(&mut hand, "More of ball", "Duplicate object");
    assert_eq!(ids(&hand), ["ring", "ball", "ball_2"]);
    press(&mut hand, "Object ring");
    assert_eq!(
        (open_look(&hand).as_str(), hand.look().name.as_str()),
        ("figure4-color.json", "first")
    );
    assert!(hand.app().session().is_dirty() && ids(&hand).len() == 3);
    // The newest step of both documents goes first: the copy was made after the first name was set.
    hand.undo();
    assert_eq!((ids(&hand).len(), hand.look().name.as_str()), (2, "first"));
    hand.undo();
    assert_ne!(hand.look().name, "first");
    press(&mut hand, "Object ball");
    assert_eq!(hand.look().name, "second");
    assert!(
        fs::read_to_string(home.look("figure6-minimal.json")).unwrap().find("second").is_none(),
        "nothing is saved"
    );
}

#[test]
fn work_on_a_scene_and_its_look_goes_on_after_the_window_was_closed() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.scene()));
    press(&mut hand, "Object ball");
    set_number(&mut hand, "Place x", "3");
    set_name(&mut hand, "unsaved");
    hand.app_mut().session_mut().close_journal(true);
    drop(hand);

    let mut hand = home.window(None);
    assert_eq!(open_scene(&hand).path(), Some(home.scene().as_path()));
    assert_eq!(
        (open_look(&hand).as_str(), hand.look().name.as_str()),
        ("figure6-minimal.json", "unsaved")
    );
    assert_eq!(scene(&hand).objects["ball"].transform.translate[0], 3.0);
    hand.undo();
    hand.undo();
    assert!(!hand.app().session().is_dirty());
    assert_eq!(scene(&hand).objects["ball"].transform.translate[0], 1.2);
}

#[test]
fn an_unsaved_look_on_an_unsaved_stage_goes_on_too() {
    let home = Home::new();
    let mut hand = home.window(None);
    tab(&mut hand, "Objects");
    choose(&mut hand, "Add an object", "Knot");
    set_name(&mut hand, "nowhere yet");
    hand.app_mut().session_mut().close_journal(true);
    drop(hand);
    let mut hand = home.window(None);
    assert_eq!(
        (ids(&hand), hand.look().name.as_str()),
        (vec!["creature".to_owned(), "knot".to_owned()], "nowhere yet")
    );
    assert!(hand.app().session().path().is_none() && open_scene(&hand).path().is_none());
    hand.undo();
    hand.undo();
    assert_eq!(ids(&hand), ["creature"]);
}

#[test]
fn a_scene_is_offered_after_a_crash() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.scene()));
    press(&mut hand, "Object ball");
    choose(&mut hand, "More of ball", "Remove object");
    assert_eq!(ids(&hand), ["ring"]);
    hand.app().session().wait_for_journal();
    // The same user after a crash of all running programs: files are there, locks are gone.
    let later = Home::new();
    for name in ["two.json", "looks/figure4-color.json", "looks/figure6-minimal.json"] {
        assert_eq!(fs::read(home.file(name)).unwrap(), fs::read(later.file(name)).unwrap());
    }
    let journals = later.file("state/journals");
    fs::create_dir_all(&journals).unwrap();
    for entry in fs::read_dir(home.file("state/journals")).unwrap().flatten() {
        fs::copy(entry.path(), journals.join(entry.file_name())).unwrap();
    }
    let mut hand = later.window(None);
    assert!(
        hand.app().session().open_scene().is_none(),
        "a crash may come from the work itself: it is only offered"
    );
    assert!(sees(&hand, "two.json, 1 change, just now"));
    press(&mut hand, "Restore it");
    assert_eq!(ids(&hand), ["ring"]);
    assert_eq!(open_look(&hand), "figure4-color.json", "what was open then is worn by nothing now");
    hand.undo();
    assert_eq!(ids(&hand), ["ring", "ball"]);
}

#[test]
fn bad_scene_files_are_told_and_what_is_open_stays() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.scene()));
    for (name, text, told) in [
        ("empty.json", "", "empty.json could not be opened"),
        ("newer.json", "{\"chiaro\": \"scene\", \"version\": 99}", "this Chiaro reads up to"),
        ("mesh.gltf.json", "{\"asset\": {}, \"meshes\": []}", "this is a glTF"),
    ] {
        fs::write(home.file(name), text).unwrap();
        hand.app_mut().open(&home.file(name));
        hand.settle();
        assert!(hand.harness.query_by_label_contains(told).is_some(), "{name}");
        assert_eq!(open_scene(&hand).path(), Some(home.scene().as_path()), "{name}");
    }
    // Looks and meshes that are missing or broken are told of, and the rest of the scene is there.
    let text = TWO
        .replace("looks/figure6-minimal.json", "looks/none.json")
        .replace("shape:torus", "shape:tours");
    fs::write(home.file("lacks.json"), text).unwrap();
    hand.app_mut().open(&home.file("lacks.json"));
    hand.settle();
    assert_eq!(ids(&hand), ["ring", "ball"]);
    assert_eq!(open_look(&hand), "figure4-color.json");
    press(&mut hand, "Object ball");
    assert!(
        hand.app().message().unwrap().contains("There is no look"),
        "{:?}",
        hand.app().message()
    );
    assert_eq!(open_look(&hand), "figure4-color.json");
}

#[test]
fn the_other_looks_are_read_again_when_they_change() {
    let mut hand = User::drawing();
    let home = Home::new();
    hand.app_mut().open(&home.scene());
    hand.settle();
    let before = hand.app().pictures();
    let minimal = home.look("figure6-minimal.json");
    let good = fs::read_to_string(&minimal).unwrap();
    fs::write(&minimal, "{ \"nodes\": [ broken").unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert!(hand.app().pictures() > before);
    assert!(
        hand.app()
            .session()
            .open_scene()
            .unwrap()
            .problem_texts()
            .any(|text| text.contains("figure6-minimal.json"))
    );
    fs::write(&minimal, good).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.app().session().open_scene().unwrap().problem_texts().count(), 0);
    // Another program changes the scene's own file.
    fs::write(home.scene(), TWO.replace("[1.2, 0, 0]", "[2.5, 0, 0]")).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(scene(&hand).objects["ball"].transform.translate[0], 2.5);
    assert!(!hand.app().session().is_dirty());
    hand.undo();
    assert_eq!(scene(&hand).objects["ball"].transform.translate[0], 1.2);
}

/// A file from the desktop.
#[derive(Debug)]
struct DesktopFile(PathBuf);

impl DroppedFile for DesktopFile {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

/// Drops a file at a place of the window.
fn drop_at(hand: &mut User, file: &Path, at: Pos2, modifiers: Modifiers) {
    hand.hover(at);
    hand.harness.event(Event::ModifiersChanged(modifiers));
    hand.harness.step();
    hand.harness.input_mut().dropped_files.push(Arc::new(DesktopFile(file.to_owned())));
    hand.harness.step();
    hand.harness.event(Event::ModifiersChanged(Modifiers::NONE));
    hand.settle();
}

#[test]
fn a_mesh_that_is_dropped_replaces_or_is_added() {
    let home = Home::new();
    let wedge = home.file("wedge.obj");
    fs::write(&wedge, "v -1 -1 0\nv 1 -1 0\nv 1 1 -1\nv -1 1 -1\nf 1 2 3 4\n").unwrap();
    let mut hand = home.window(Some(&home.scene()));
    let mesh = |hand: &User, id: &str| scene(hand).objects[id].mesh.clone();
    // A mesh dropped onto an object replaces that object's mesh, whichever object is selected.
    press(&mut hand, "Object ring");
    let at = on_screen(&hand, "ball");
    drop_at(&mut hand, &wedge, at, Modifiers::NONE);
    assert_eq!(
        (mesh(&hand, "ring").as_str(), mesh(&hand, "ball").as_str()),
        ("shape:torus", "wedge.obj")
    );
    // A mesh dropped beside all objects replaces the selected object's.
    let beside = hand.app().viewport().rect().unwrap().left_top() + eframe::egui::vec2(9.0, 9.0);
    drop_at(&mut hand, &wedge, beside, Modifiers::NONE);
    assert_eq!(mesh(&hand, "ring"), "wedge.obj");
    // A mesh dropped with Shift, or on the panel, is added as an object.
    drop_at(&mut hand, &wedge, beside, Modifiers::SHIFT);
    assert_eq!(ids(&hand), ["ring", "ball", "wedge"]);
    let panel = hand.harness.get_by_label("Object ball").rect().center();
    drop_at(&mut hand, &wedge, panel, Modifiers::NONE);
    assert_eq!(ids(&hand), ["ring", "ball", "wedge", "wedge_2"]);
    assert_eq!(mesh(&hand, "wedge_2"), "wedge.obj");
    assert!(hand.app_mut().save_scene_as(&home.scene()));
    assert_eq!(open(&home.scene(), None, &mut Assets::default()).unwrap().value.objects.len(), 4);

    // Without a scene a dropped mesh replaces the mesh that the look is seen on, and with Shift it
    // begins a scene.
    let mut hand = home.window(None);
    let picture = hand.app().viewport().rect().unwrap().center();
    drop_at(&mut hand, &wedge, picture, Modifiers::NONE);
    assert!(hand.app().session().open_scene().is_none());
    assert_eq!(hand.app().session().view().orbit().mesh, wedge.to_string_lossy());
    drop_at(&mut hand, &wedge, picture, Modifiers::SHIFT);
    assert_eq!(ids(&hand), ["wedge", "wedge_2"]);
}

#[test]
fn objects_are_renamed_duplicated_and_removed() {
    let home = Home::new();
    let mut hand = home.window(Some(&home.scene()));
    choose(&mut hand, "More of ring", "Rename object");
    hand.type_text("Big ring");
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(ids(&hand), ["big_ring", "ball"]);
    choose(&mut hand, "More of ball", "Duplicate object");
    choose(&mut hand, "More of big_ring", "Remove object");
    assert_eq!(ids(&hand), ["ball", "ball_2"]);
    hand.undo();
    assert_eq!(ids(&hand), ["big_ring", "ball", "ball_2"]);
    // Closing the scene leaves the look open; the scene's unsaved work is put aside and comes back
    // when it is opened.
    let look = open_look(&hand);
    choose(&mut hand, "More of the scene", "Close the scene");
    assert!(hand.app().session().open_scene().is_none());
    assert_eq!(open_look(&hand), look);
    hand.app_mut().open(&home.scene());
    hand.settle();
    assert_eq!(ids(&hand), ["big_ring", "ball", "ball_2"], "with the work that was put aside");
}

#[test]
fn where_nothing_is_kept_one_is_asked_before_a_look_is_left() {
    let home = Home::new();
    let mut hand = User::new();
    hand.app_mut().open(&home.scene());
    hand.settle();
    // Going to another look of the scene would not lose the scene's own changes.
    press(&mut hand, "Object ring is seen");
    press(&mut hand, "Object ball");
    assert_eq!(open_look(&hand), "figure6-minimal.json");
    set_name(&mut hand, "mine");
    press(&mut hand, "Object ring");
    assert!(sees(&hand, "figure6-minimal.json has changes"));
    press(&mut hand, "Cancel");
    assert_eq!(
        (open_look(&hand).as_str(), hand.look().name.as_str()),
        ("figure6-minimal.json", "mine")
    );
    press(&mut hand, "Object ring");
    press(&mut hand, "Do not save");
    assert_eq!(open_look(&hand), "figure4-color.json");
    assert!(open_scene(&hand).is_dirty(), "the scene's changes are still there");
    choose(&mut hand, "More of the scene", "Close the scene");
    assert!(sees(&hand, "two.json has changes"));
    press(&mut hand, "Do not save");
    assert!(hand.app().session().open_scene().is_none());
}

/// A window with a scene that has a light, and its ring chosen.
fn lit_window(home: &Home) -> User {
    let lit = r#""camera": {"eye": [0, 0, 9]}, "lights": {"key": {"direction": [1, 1, 1]}}"#;
    fs::write(home.scene(), TWO.replace(r#""camera": {"eye": [0, 0, 9]}"#, lit)).unwrap();
    let mut hand = home.window(Some(&home.scene()));
    press(&mut hand, "Object ring");
    hand
}

#[test]
fn lights_are_linked_to_an_object_by_a_set() {
    let home = Home::new();
    let mut hand = lit_window(&home);
    let sets = |hand: &User| {
        let ring = &scene(hand).objects["ring"];
        [ring.linked.text().to_owned(), ring.unlinked.text().to_owned()]
    };
    assert_eq!(sets(&hand), ["*", ""]);
    // What is no set yet is told, and the last that was one stays.
    set_text(&mut hand, "Lit by", "group:sun");
    assert_eq!(sets(&hand), ["group:sun", ""]);
    hand.type_text(" &");
    hand.settle();
    assert!(sees(&hand, "a light or a group is missing at character 12"));
    assert_eq!(sets(&hand), ["group:sun", ""]);
    hand.type_text(" *");
    hand.settle();
    assert!(!sees(&hand, "is missing at character"));
    assert_eq!(sets(&hand), ["group:sun & *", ""]);
    hand.bring(Role::TextInput, "Not lit by");
    set_text(&mut hand, "Not lit by", "(");
    assert!(sees(&hand, "a light or a group is missing at character 2"));
    hand.key(Key::Enter);
    hand.settle();
    assert!(!sees(&hand, "is missing at character"), "what is no set is given up");
    assert_eq!(sets(&hand), ["group:sun & *", ""]);
    hand.undo();
    assert_eq!(sets(&hand), ["*", ""], "one stay in a field is one step");
}

#[test]
fn shadows_of_an_object_are_linked_by_sets() {
    let home = Home::new();
    let mut hand = lit_window(&home);
    hand.harness.get_by_label("Shadows").scroll_to_me();
    hand.settle();
    press(&mut hand, "Shadows");
    let set = |hand: &mut User, field: &str, text: &str| {
        hand.bring(Role::TextInput, field);
        set_text(hand, field, text);
    };
    set(&mut hand, "Of lights", "key");
    set(&mut hand, "Onto", "* - ball");
    let ring = scene(&hand).objects["ring"].shadow_link();
    assert_eq!((ring.shadowed.text(), ring.shadows_on.text()), ("key", "* - ball"));
    set(&mut hand, "Not onto", "(");
    assert!(sees(&hand, "an object is missing at character 2"));
    hand.key(Key::Enter);
    hand.settle();
    hand.undo();
    hand.undo();
    assert!(scene(&hand).objects["ring"].shadow_link().is_all(), "one stay in a field is a step");
}

#[test]
fn groups_of_a_light_are_typed_with_commas() {
    let mut hand = User::new();
    let light = "{\"chiaro\": \"look\", \"lights\": {\"sun\": {}}}";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    fs::write(&path, light).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    tab(&mut hand, "Lights");
    let groups = |hand: &User| {
        let groups = hand.look().lights["sun"].groups.iter();
        groups.map(ToString::to_string).collect::<Vec<_>>()
    };
    set_text(&mut hand, "Groups", "day");
    hand.type_text(", set light");
    hand.settle();
    assert!(sees(&hand, "`set light` is no group: write set_light"));
    assert_eq!(groups(&hand), ["day"], "the last that was a list of groups");
    set_text(&mut hand, "Groups", "day,set_light, day,");
    assert_eq!(groups(&hand), ["day", "set_light"]);
    hand.key(Key::Enter);
    hand.settle();
    hand.undo();
    assert_eq!(groups(&hand), ["day"], "the field was left, and clicked again");
    hand.undo();
    assert!(groups(&hand).is_empty());
}

#[test]
fn materials_of_one_mesh_wear_different_looks() {
    let home = Home::new();
    let halves = "v -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\n\
                  usemtl left\nf 1 2 3 4\nusemtl right\nf 2 5 6 3\n";
    fs::write(home.file("halves.obj"), halves).unwrap();
    fs::write(home.scene(), TWO.replace("shape:torus", "halves.obj")).unwrap();
    let mut hand = home.window(Some(&home.scene()));
    press(&mut hand, "Object ring");
    let combo = hand.harness.get_by_role_and_label(Role::ComboBox, "right").rect().center();
    hand.click(combo);
    hand.settle();
    press_button(&mut hand, "figure6-minimal.json");
    let looks = &scene(&hand).objects["ring"].looks;
    assert_eq!(
        (looks["right"].as_str(), looks["*"].as_str()),
        ("looks/figure6-minimal.json", "looks/figure4-color.json")
    );
    // A click on a part opens the look of that part.
    let middle = on_screen(&hand, "ring");
    hand.click(middle + eframe::egui::vec2(20.0, 0.0));
    hand.settle();
    assert_eq!(open_look(&hand), "figure6-minimal.json");
    hand.click(middle - eframe::egui::vec2(20.0, 0.0));
    hand.settle();
    assert_eq!(open_look(&hand), "figure4-color.json");
    hand.undo();
    assert!(!scene(&hand).objects["ring"].looks.contains_key("right"));
}

#[test]
fn while_one_look_is_edited_the_others_are_compiled_once() {
    let home = Home::new();
    let mut planner = Planner::new(Assets::default()).culling(CullMode::Objects);
    let mut setup = open(&home.scene(), None, &mut planner.assets).unwrap().value;
    setup.edited = Some(0);
    let plan = PlanOptions { size: [64, 32], samples: 1, time: 0.0 };
    let mut picture = |setup: &Setup, is_new: bool| {
        if is_new {
            let options =
                CompileOptions { live: Live::All, display: true, ..CompileOptions::default() };
            let shader =
                compile(&setup.looks[0].look, Library::built_in(), &options).unwrap().value;
            planner.provide(&setup.looks[0].look, &Live::All, Arc::new(shader));
        }
        let plan = planner.plan(setup, Library::built_in(), &Live::All, &plan).unwrap().value;
        ["ring", "ball"]
            .map(|id| plan.draws.iter().find(|draw| draw.object.as_str() == id).unwrap().clone())
    };
    let [ring, ball] = picture(&setup, true);
    assert_eq!((&ring.look.live, &ball.look.live), (&Live::All, &Live::Keyed));
    // A light of the edited look changes at once, by uniforms; the other look has a light of the
    // same name, which stays.
    assert!(
        setup.looks[1].look.lights.contains_key(setup.looks[0].look.lights.keys().next().unwrap())
    );
    setup.looks[0].look.lights.values_mut().for_each(|light| light.direction = [0.0, -1.0, 0.0]);
    let [turned, same] = picture(&setup, false);
    assert!(Arc::ptr_eq(&ring.look, &turned.look) && Arc::ptr_eq(&ball.look, &same.look));
    let bytes = |draw: &Draw| draw.look_uniforms[&Stage::Draw].bytes.clone();
    assert!(bytes(&ring) != bytes(&turned) && bytes(&ball) == bytes(&same));
    // Another structure of a look is another module, of that look alone.
    setup.looks[0].look.tier = Some(chiaro::document::Tier::Fast);
    let [other, same] = picture(&setup, true);
    assert!(!Arc::ptr_eq(&ring.look, &other.look) && Arc::ptr_eq(&ball.look, &same.look));
}

#[test]
fn groups_of_lights_are_mixed() {
    let home = Home::new();
    let lights = r#""lights": {
        "key": {"groups": ["set"]}, "back": {"groups": ["rim", "set"]}}, "objects": ["#;
    fs::write(home.scene(), TWO.replacen("\"objects\": [", lights, 1)).unwrap();
    let mut hand = home.window(Some(&home.scene()));
    tab(&mut hand, "Lights");
    press(&mut hand, "Group rim shines");
    assert_eq!(scene(&hand).muted.text(), "group:rim");
    press(&mut hand, "Solo group set");
    assert_eq!(scene(&hand).soloed.text(), "group:set");
    set_number(&mut hand, "Exposure of group rim", "-1.5");
    assert_eq!(scene(&hand).light_groups["rim"].exposure, -1.5);
    press(&mut hand, "Solo group set");
    press(&mut hand, "Group rim shines");
    assert_eq!((scene(&hand).muted.text(), scene(&hand).soloed.text()), ("", ""));
    set_number(&mut hand, "Exposure of group rim", "0");
    assert!(scene(&hand).light_groups.is_empty(), "a master that does nothing is not kept");
    hand.undo();
    assert_eq!(scene(&hand).light_groups["rim"].exposure, -1.5);
}

#[test]
fn outlines_of_a_scene_are_set_with_its_name() {
    let home = Home::new();
    let mut hand = lit_window(&home);
    press(&mut hand, "Name, about, outlines");
    assert!(!sees(&hand, "Silhouettes"), "none while there are no lines");
    set_number(&mut hand, "Outlines", "8");
    assert_eq!(scene(&hand).outlines.width, 8.0);
    set_number(&mut hand, "Creases", "0.25");
    assert_eq!(scene(&hand).outlines.creases, 0.25);
    hand.undo();
    hand.undo();
    assert_eq!(scene(&hand).outlines, chiaro::document::SceneOutlines::default());
    assert!(!sees(&hand, "Silhouettes"), "and gone");
}
