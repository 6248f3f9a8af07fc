//! Parts of a scene beside its objects: its own lights, values that objects set over their looks',
//! files that its looks read, and small pictures.

use std::fs;
use std::path::PathBuf;

use crate::editor_support::User;
use chiaro::document::{Light, LightKind, Scene, Value};
use chiaro::editor::{App, Places};
use chiaro::ids::LightId;
use eframe::egui::{Key, Modifiers, Role, vec2};
use egui_kittest::kittest::Queryable as _;

/// A user's folders, with a scene of two objects in two looks and with a light of its own.
struct Home(tempfile::TempDir);

/// A plain look: a base, a layer, and exposed values. Both looks have a light `key`.
const PAINT: &str = r#"{"chiaro": "look", "name": "Paint",
 "lights": {"key": {"direction": [0, 0, 1]}, "back": {"direction": [0.6, 0, -0.8]}},
 "nodes": [
  {"id": "base", "kind": "base", "values": {"color": [1, 0, 0]}},
  {"id": "rim", "kind": "light_layer", "values": {"light": "key", "opacity": 0.5}},
  {"id": "output", "kind": "output"}],
 "wires": [{"from": "base", "to": "rim.below"}, {"from": "rim", "to": "output.color"}],
 "exposed": [
  {"name": "strength", "target": "rim.opacity"},
  {"name": "kind", "target": "rim.type", "label": "Kind of light"},
  {"name": "by", "target": "rim.light"},
  {"name": "brightness", "target": "lights.back.intensity"}]}"#;

/// A look without the layer: an image is all that it shows.
const DECAL: &str = r#"{"chiaro": "look", "name": "Decal",
 "lights": {"key": {"direction": [0, 1, 0]}},
 "nodes": [
  {"id": "paper", "kind": "image", "values": {"image": "paper.png"}},
  {"id": "output", "kind": "output"}],
 "wires": [{"from": "paper.color", "to": "output.color"}],
 "exposed": [{"name": "picture", "target": "paper.image"}]}"#;

/// A mesh of one triangle.
const LEAF: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n\
                    f 1/1/1 2/2/1 3/3/1\n";

const TWO: &str = r#"{
 "chiaro": "scene",
 "objects": [
  {"id": "ring", "mesh": "shape:sphere", "transform": {"translate": [-1.2, 0, 0]},
  "looks": "looks/paint.json"},
  {"id": "ball", "mesh": "shape:sphere", "transform": {"translate": [1.2, 0, 0]},
  "looks": "looks/decal.json"}
 ],
 "lights": {"key": {"direction": [0.6, 0, 0.8], "color": [0, 1, 0]}},
 "camera": {"eye": [0, 0, 9], "projection": "orthographic", "height": 4.8}
}
"#;

impl Home {
    fn new() -> Self {
        let home = Self(tempfile::tempdir().unwrap());
        fs::create_dir(home.file("looks")).unwrap();
        fs::write(home.file("looks/paint.json"), PAINT).unwrap();
        fs::write(home.file("looks/decal.json"), DECAL).unwrap();
        home.write_paper([0, 0, 255]);
        fs::write(home.file("two.json"), TWO).unwrap();
        home
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn places(&self) -> Places {
        Places { state: self.file("state"), config: self.file("config") }
    }

    /// Writes the decal's image, in one color.
    fn write_paper(&self, color: [u8; 3]) {
        let image = image::RgbImage::from_pixel(8, 8, image::Rgb(color));
        image.save(self.file("looks/paper.png")).unwrap();
    }

    fn window(&self) -> User {
        let (places, file) = (self.places(), self.file("two.json"));
        User::with(move |ctx| {
            let mut app = App::new(ctx, None).without_dialogs();
            app.keep_in(places.clone(), ctx);
            app.open(&file);
            app
        })
    }

    fn drawing(&self) -> User {
        let mut hand = User::drawing();
        hand.app_mut().open(&self.file("two.json"));
        hand.settle();
        assert_eq!(hand.app().message(), None);
        let told: Vec<&str> = hand.app().session().open_scene().unwrap().problem_texts().collect();
        assert!(told.is_empty(), "{told:?}");
        hand
    }
}

fn scene(hand: &User) -> &Scene {
    hand.app().session().open_scene().expect("a scene is open").scene()
}

fn light<'h>(hand: &'h User, id: &str) -> &'h Light {
    &scene(hand).lights[id]
}

fn lights(hand: &User) -> Vec<String> {
    scene(hand).lights.keys().map(LightId::to_string).collect()
}

/// Opens the list of a light's fields, or closes it.
fn unfold(hand: &mut User, light: &str) {
    let at = hand.place(&format!("Light {light} shines"));
    hand.click(at.left_center() - vec2(14.0, 0.0));
    hand.settle();
}

/// Colors of the two objects, in the middle of the picture's left and right halves.
fn colors(hand: &mut User) -> [[u8; 3]; 2] {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("picture.png");
    hand.app_mut().save_picture([320, 160], &file);
    hand.settle();
    let picture = image::open(&file).unwrap().into_rgb8();
    // The objects lie 1.2 to the left and right of the middle, and 4.8 are 160 pixels.
    [120, 200].map(|x| picture.get_pixel(x, 80).0)
}

#[test]
fn a_scenes_lights_are_edited_as_a_looks_are() {
    let home = Home::new();
    let mut hand = home.window();
    hand.tab("Lights");
    assert!(
        hand.has("Light key of the scene shines") && hand.has("Light key shines"),
        "told apart"
    );
    assert!(
        hand.has("2 looks") && hand.has("scene's"),
        "who has it, and what it stands in place of"
    );
    let look = hand.look().clone();
    let field = hand.place_of(Role::SpinButton, "Intensity of key of the scene");
    hand.type_over(field, "2.5");
    assert_eq!(light(&hand, "key").intensity, 2.5);
    unfold(&mut hand, "key of the scene");
    hand.choose("Type", "Point");
    assert_eq!(light(&hand, "key").kind, LightKind::Point);
    let position = hand.fields_called("Position");
    hand.type_over(position[1], "3");
    assert_eq!(light(&hand, "key").position, [0.0, 3.0, 3.0]);
    let hex = hand.place_of(Role::TextInput, "Color");
    hand.type_over(hex, "ff0000");
    assert_eq!(light(&hand, "key").color, [1.0, 0.0, 0.0]);
    hand.press("More of key of the scene");
    hand.press("Rename light");
    hand.type_text("Sun");
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(light(&hand, "key").name, "Sun");
    assert_eq!(*hand.look(), look, "the look's own light is as it was");
    let steps: Vec<String> = hand.app().session().steps().labels().map(str::to_owned).collect();
    assert_eq!(
        steps,
        [
            "Intensity of key",
            "Type of key",
            "Position of key",
            "Color of key",
            "rename the light key"
        ]
    );
    // One order of undo also covers the look's light.
    hand.bring(Role::SpinButton, "Intensity of back");
    let field = hand.place_of(Role::SpinButton, "Intensity of back");
    hand.type_over(field, "3");
    hand.undo();
    assert_eq!((hand.look(), light(&hand, "key").name.as_str()), (&look, "Sun"));
    hand.undo();
    assert_eq!(
        (light(&hand, "key").name.as_str(), light(&hand, "key").color),
        ("", [1.0, 0.0, 0.0])
    );
    hand.redo();

    // The change is saved with the scene.
    assert!(hand.app_mut().save_scene_as(&home.file("two.json")));
    let saved =
        Scene::read(&fs::read_to_string(home.file("two.json")).unwrap(), "two").value.unwrap();
    assert_eq!(saved.lights, scene(&hand).lights);
    hand.bring(Role::Button, "More of Sun of the scene");
    hand.press("More of Sun of the scene");
    hand.press("Remove light");
    assert!(scene(&hand).lights.is_empty() && !hand.has("Of the scene"));
    hand.app().session().wait_for_journal();
    drop(hand);
    let hand = home.window();
    assert!(scene(&hand).lights.is_empty() && hand.app().session().is_dirty(), "from the journal");
}

#[test]
fn point_and_spot_lights_are_given_their_fall_off() {
    let mut hand = User::new();
    hand.tab("Lights");
    assert!(!hand.has("Half distance"), "the sun does not fade");
    let of_key = |hand: &User| hand.look().lights["key"].clone();
    let set = |hand: &mut User, field: &str, text: &str| {
        hand.bring(Role::SpinButton, field);
        let place = hand.place_of(Role::SpinButton, field);
        hand.type_over(place, text);
    };
    for kind in ["Point", "Spot"] {
        hand.bring(Role::ComboBox, "Type");
        hand.choose("Type", kind);
        set(&mut hand, "Half distance", "2.5");
        set(&mut hand, "Range", "7");
        assert_eq!((of_key(&hand).half_distance, of_key(&hand).range), (2.5, 7.0));
        assert!(
            hand.has("Keys of Half distance") && hand.has("Keys of Range"),
            "they can be keyed"
        );
        // Values that no document may hold are not set, and `off` is the word for 0.
        set(&mut hand, "Half distance", "-3");
        set(&mut hand, "Range", "off");
        assert_eq!((of_key(&hand).half_distance, of_key(&hand).range), (0.0, 0.0));
    }
}

#[test]
fn the_list_of_meshes_shows_the_way_to_ones_own() {
    let home = Home::new();
    let mesh = home.file("own.obj");
    fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().answer_dialog(&mesh);
    hand.choose("On", "From a file...");
    assert_eq!(
        hand.app().session().view().orbit().mesh,
        mesh.display().to_string(),
        "nothing is in front of it"
    );
}

#[test]
fn a_scene_is_named_and_described_as_one_step_each() {
    let home = Home::new();
    let mut hand = home.window();
    hand.tab("Objects");
    hand.press("Name, about, outlines");
    let name = hand.text_field("Scene name");
    hand.type_over(name, "Two in one light");
    assert_eq!(scene(&hand).name, "Two in one light");
    assert!(hand.app().session().is_dirty());
    let about = hand.place_of(Role::MultilineTextInput, "About");
    hand.click(about.center());
    for text in ["A ring", " and a ball"] {
        hand.type_text(text);
    }
    hand.settle();
    assert_eq!(scene(&hand).about, "A ring and a ball");
    assert!(hand.has("Two in one light"), "its fold tells the name");
    // A text field that has the focus has an undo of its own.
    hand.key(Key::Escape);
    hand.undo();
    assert_eq!(scene(&hand).about, "");
    hand.undo();
    assert_eq!(scene(&hand).name, "");
}

#[test]
fn lights_are_added_to_a_scene_in_place_of_its_looks_own() {
    let home = Home::new();
    let mut hand = home.window();
    hand.tab("Lights");
    hand.press("Add scene light");
    hand.press("In place of back");
    assert_eq!(lights(&hand), ["key", "back"]);
    assert_eq!(
        light(&hand, "back"),
        &hand.look().lights["back"],
        "it begins as what it stands in for"
    );
    assert!(hand.has("1 look"));
    hand.press("More of key of the scene");
    hand.press("Duplicate light");
    assert_eq!(lights(&hand), ["key", "key_2", "back"]);
    assert!(hand.has("unused"), "no look has a light of that id");
    // A light that stands in for no look's light can stand in for another one.
    hand.press("More of back of the scene");
    hand.press("Remove light");
    hand.press("More of key_2 of the scene");
    hand.press("Stand in for back");
    assert_eq!(lights(&hand), ["key", "back"]);
    assert_eq!(light(&hand, "back").direction, [0.6, 0.0, 0.8]);
    // A look's own light can be given to the scene as it is.
    hand.press("More of back of the scene");
    hand.press("Remove light");
    hand.press("More of back");
    hand.press("Light the scene with it");
    assert_eq!(
        (lights(&hand), light(&hand, "back").direction),
        (vec!["key".into(), "back".into()], [0.6, 0.0, -0.8])
    );
    hand.app_mut().session_mut().go_to(0);
    assert_eq!(lights(&hand), ["key"]);
}

#[test]
fn a_scenes_light_goes_out_for_all_looks_and_is_shown_alone() {
    let home = Home::new();
    // Both objects are lit by `key` alone, and show its color.
    fs::write(
        home.file("looks/decal.json"),
        PAINT.replace("[1, 0, 0]", "[0, 0, 0]").replace("0.5", "1"),
    )
    .unwrap();
    let mut hand = home.drawing();
    hand.tab("Lights");
    let lit = colors(&mut hand);
    assert!(lit[0][1] > 60 && lit[1][1] > 120, "green light on both: {lit:?}");
    hand.press("Light key of the scene shines");
    assert!(!hand.app().session().view().shines("key") && hand.says("Muted: light key"));
    let dark = colors(&mut hand);
    assert!(dark[0][1] < 20 && dark[1][1] < 20, "{dark:?}");
    // Muting belongs to the window: another look of the same scene is seen the same way.
    hand.tab("Objects");
    hand.press("Object ball");
    assert!(!hand.app().session().view().shines("key"));
    hand.tab("Lights");
    hand.press("Show all");
    assert_eq!(colors(&mut hand), lit);
    assert!(!hand.app().session().is_dirty());
    hand.press("Solo key of the scene");
    assert!(
        hand.app().session().view().shines("key") && !hand.app().session().view().shines("back")
    );
    assert_eq!(colors(&mut hand), lit);
    // Removing a light ends its solo: the other lights are not left dark.
    hand.press("More of key of the scene");
    hand.press("Remove light");
    hand.press("Solo back");
    hand.press("Add scene light");
    hand.press("In place of back");
    hand.press("More of back of the scene");
    hand.press("Remove light");
    assert!(!hand.app().session().view().shines("key"), "the look has it still");
}

#[test]
fn a_scenes_light_is_dragged_on_the_object() {
    let home = Home::new();
    let mut hand = home.window();
    hand.app_mut().session_mut().select(vec!["rim".into()]);
    hand.settle();
    let before = (hand.look().clone(), light(&hand, "key").clone());
    let rect = hand.app().viewport().rect().unwrap();
    let orbit = hand.app().session().view().orbit();
    let scale = rect.height() / orbit.height() as f32;
    let ring = rect.center() - vec2(1.2 * scale, 0.0);
    hand.hover(ring);
    hand.settle();
    let shift = eframe::egui::Modifiers::SHIFT;
    hand.drag_with(shift, ring, ring + vec2(0.0, -0.5 * scale));
    hand.settle();
    let turned = glam::DVec3::from(light(&hand, "key").direction);
    assert!(turned.y > 0.4 && turned.x.abs() < 0.35, "from the right to above: {turned}");
    assert_eq!(*hand.look(), before.0, "the look's own light stays");
    assert_eq!(
        hand.app().session().steps().labels().collect::<Vec<_>>(),
        ["Direction of key"],
        "one step a gesture"
    );
    hand.undo();
    assert_eq!(*light(&hand, "key"), before.1);
}

#[test]
fn objects_set_what_their_looks_expose() {
    let home = Home::new();
    // Both objects wear the same look.
    fs::write(home.file("two.json"), TWO.replace("decal", "paint")).unwrap();
    let mut hand = home.drawing();
    hand.press("Object ring");
    assert!(hand.has("Parameters of paint.json"));
    for label in ["Strength", "Kind of light", "By", "Brightness"] {
        assert!(hand.has(label), "{label}");
    }
    let plain = colors(&mut hand);
    assert_eq!(plain[0], plain[1]);
    let values = |hand: &User| scene(hand).objects["ring"].values.clone();
    hand.bring(Role::SpinButton, "Strength");
    let strength = hand.place_of(Role::SpinButton, "Strength");
    hand.type_over(strength, "0");
    assert_eq!(values(&hand)["strength"], Value::Number(0.0));
    let set = colors(&mut hand);
    assert_eq!(set[1], plain[1], "the other object is as its look");
    assert_eq!(set[0], [255, 0, 0], "no layer over its base");
    hand.choose("Kind of light", "Specular");
    hand.bring(Role::ComboBox, "By");
    hand.choose("By", "back");
    assert_eq!(values(&hand)["kind"], Value::Text("specular".into()));
    assert_eq!(values(&hand)["by"], Value::Text("back".into()));
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    let steps: Vec<String> = hand.app().session().steps().labels().map(str::to_owned).collect();
    assert_eq!(steps, ["change strength of ring", "change kind of ring", "change by of ring"]);
    // Values go back to the look's one by one, and undo sets them again.
    hand.press("Back to the look's Strength");
    assert!(!values(&hand).contains_key("strength") && !hand.has("Back to the look's Strength"));
    hand.undo();
    assert!(values(&hand).contains_key("strength"));
    for label in ["Strength", "Kind of light", "By"] {
        hand.press(&format!("Back to the look's {label}"));
    }
    assert!(values(&hand).is_empty());
    assert_eq!(colors(&mut hand), plain);
    // The value set in the window is saved for other executors.
    let strength = hand.place_of(Role::SpinButton, "Strength");
    hand.type_over(strength, "0.25");
    assert!(hand.app_mut().save_scene_as(&home.file("two.json")));
    assert!(fs::read_to_string(home.file("two.json")).unwrap().contains("\"strength\": 0.25"));
}

#[test]
fn values_of_looks_that_are_not_open_and_of_none_are_there_too() {
    let home = Home::new();
    let halves = "v -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\n\
                  usemtl left\nf 1 2 3 4\nusemtl right\nf 2 5 6 3\n";
    fs::write(home.file("halves.obj"), halves).unwrap();
    let two_looks =
        r#"{"left": "looks/paint.json", "right": "looks/decal.json"}, "values": {"lost": 3}"#;
    let text = TWO.replacen("shape:sphere", "halves.obj", 1).replacen(
        "\"looks/paint.json\"",
        two_looks,
        1,
    );
    fs::write(home.file("two.json"), text).unwrap();
    let mut hand = home.window();
    hand.press("Object ring");
    assert!(hand.has("Parameters of paint.json") && hand.has("Parameters of decal.json"));
    hand.bring(Role::TextInput, "Picture");
    let path = hand.text_field("Picture");
    hand.type_over(path, "other.png");
    assert_eq!(scene(&hand).objects["ring"].values["picture"], Value::Text("other.png".into()));
    // A value that no look exposes is told of, and can be taken out.
    assert!(hand.has("lost") && hand.has("Set, and exposed by none of its looks"));
    hand.press("Take out lost");
    assert!(!scene(&hand).objects["ring"].values.contains_key("lost"));
    hand.undo();
    assert_eq!(scene(&hand).objects["ring"].values["lost"], Value::Number(3.0));
}

#[test]
fn images_of_looks_that_are_not_open_are_read_again() {
    let home = Home::new();
    let mut hand = home.drawing();
    assert_eq!(hand.app().session().path().unwrap().file_name().unwrap(), "paint.json");
    assert_eq!(colors(&mut hand)[1], [0, 0, 255]);
    home.write_paper([0, 200, 0]);
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.app().message(), Some("paper.png was loaded again"));
    assert_eq!(colors(&mut hand)[1], [0, 200, 0]);
    // An image that an object sets in its place is read again, too.
    let other = |color: [u8; 3]| {
        image::RgbImage::from_pixel(4, 4, image::Rgb(color))
            .save(home.file("looks/other.png"))
            .unwrap();
    };
    other([200, 0, 0]);
    let text = TWO.replace(
        "\"looks/decal.json\"",
        r#""looks/decal.json", "values": {"picture": "other.png"}"#,
    );
    fs::write(home.file("two.json"), text).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(colors(&mut hand)[1], [200, 0, 0]);
    other([9, 9, 9]);
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(colors(&mut hand)[1], [9, 9, 9]);
}

#[test]
fn nodes_beside_the_scene_are_read_again() {
    let home = Home::new();
    fs::create_dir(home.file("nodes")).unwrap();
    let node = |factor: &str| {
        let text = format!(
            "/// Tint\n///\n/// @param color \"Color\" default=1,1,1,1 : What comes in.\n\
             /// @return color \"Color\" : What goes out.\n\
             fn tint(color: vec4f) -> vec4f {{\n    return vec4f({factor} * color.rgb, \
             color.a);\n}}\n"
        );
        fs::write(home.file("nodes/tint.wgsl"), text).unwrap();
    };
    node("0.0");
    let look = r#"{"chiaro": "look", "nodes": [{"id": "tint", "kind": "tint",
        "values": {"color": [1, 1, 1, 1]}},
      {"id": "output", "kind": "output"}], "wires": [{"from": "tint", "to": "output.color"}]}"#;
    fs::write(home.file("looks/decal.json"), look).unwrap();
    let mut hand = home.drawing();
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    assert_eq!(colors(&mut hand)[1], [0; 3]);
    node("1.0");
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.app().message(), Some("The project's nodes were loaded again"));
    assert_eq!(colors(&mut hand)[1], [255; 3]);
}

#[test]
fn the_picture_small_pictures_and_exports_read_a_file_once() {
    let home = Home::new();
    fs::write(home.file("leaf.obj"), LEAF).unwrap();
    fs::write(home.file("two.json"), TWO.replace("shape:sphere", "leaf.obj")).unwrap();
    let mut hand = home.drawing();
    assert!(hand.app().small_pictures() > 0, "layers have small pictures");
    let reads = hand.app().session().asset_reads();
    assert_eq!(reads, 3, "the creature of the new look and small pictures, the leaf, the paper");
    hand.app_mut().save_picture([64, 48], &home.file("out.png"));
    hand.app_mut().show_reference(&home.file("looks/paper.png"));
    hand.settle();
    assert!(home.file("out.png").is_file());
    assert_eq!(hand.app().session().asset_reads(), reads);
}

#[test]
fn scenes_have_small_pictures_of_their_own() {
    let home = Home::new();
    let places = home.places();
    let mut hand = User::drawing_with(move |app, ctx| {
        let mut app = app.without_dialogs();
        app.keep_in(places.clone(), ctx);
        app
    });
    hand.app_mut().open(&home.file("two.json"));
    hand.settle();
    hand.app_mut().show_start_page();
    for _ in 0..40 {
        hand.harness.run_steps(2);
        hand.settle();
    }
    let card = hand.place("Open the scene two");
    let image = hand.harness.render().unwrap();
    let at = |x: f32, y: f32| {
        let p = card.min + vec2(x, y) * card.width();
        image.get_pixel(p.x.round() as u32, p.y.round() as u32).0
    };
    let [left, right] = [at(0.25, 0.5), at(0.75, 0.5)];
    assert!(right[2] > 200 && right[0] < 60, "the decal is blue: {right:?}");
    assert!(left[0] > 100 && left[2] < 60, "the paint is red, under green light: {left:?}");
    // The picture's backdrop is the scene's.
    let corner = at(0.05, 0.1);
    assert!(corner[0].abs_diff(41) < 4 && corner[2].abs_diff(46) < 4, "{corner:?}");
    let words = hand.harness.query_all_by_label("a scene").next();
    assert!(words.is_none(), "no words where the picture is");
    hand.press("Open the scene two");
    assert_eq!(
        hand.app().session().open_scene().unwrap().path(),
        Some(home.file("two.json").as_path())
    );
}

#[test]
fn a_look_on_one_object_is_saved_as_a_scene() {
    let home = Home::new();
    let (look, scene) = (home.file("looks/paint.json"), home.file("kept.json"));
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&look);
    hand.app_mut().show_on("shape:torus");
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("panel objects");
    hand.key(Key::Enter);
    hand.settle();
    hand.app_mut().answer_dialog(&scene);
    let button = hand.harness.get_by_role_and_label(Role::Button, "Save as a scene...").rect();
    hand.click(button.center());
    hand.settle();
    let kept: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&scene).unwrap()).unwrap();
    let object = &kept["objects"][0];
    assert_eq!(object["mesh"], "shape:torus");
    assert_eq!(object["looks"], "looks/paint.json");
    assert_eq!(hand.app().session().open_scene().unwrap().scene().objects.len(), 1);
}
