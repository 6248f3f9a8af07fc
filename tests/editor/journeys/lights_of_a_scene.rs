//! A lighter's journey: three gray objects get a key, a rim and an eye light that one of them has
//! for itself; links, a shadow placed by pointing, and a group that is dimmed by the mixer.

use std::path::Path;

use chiaro::document::{Light, LightKind, LightSpace, Scene};
use eframe::egui::accesskit::{Role, Toggled};
use eframe::egui::{Key, Modifiers, Pos2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use glam::DVec3;

use super::artist::{JourneyUser, Studio};
use super::picture::Picture;

/// The scene and the look that the tour of lights begins with.
const SCENE: &str = include_str!("../../../src/editor/app/tour/gray-scene.json");
const LOOK: &str = include_str!("../../../src/editor/app/tour/gray-look.json");
/// Height of the floor, and center and radius of the ball, as the scene has them.
const FLOOR: f64 = -0.97;
const BALL: (DVec3, f64) = (DVec3::new(1.0, -0.45, 0.3), 0.5);

fn scene(lighter: &JourneyUser) -> &Scene {
    lighter.app().session().open_scene().expect("one is open").scene()
}

fn light<'s>(lighter: &'s JourneyUser, id: &str) -> &'s Light {
    &scene(lighter).lights[id]
}

fn open(studio: &Studio, file: &Path) -> JourneyUser {
    let mut lighter = studio.window();
    lighter.app_mut().answer_dialog(file);
    lighter.key_with(Modifiers::COMMAND, Key::O);
    lighter.settle();
    assert_eq!(scene(&lighter).objects.len(), 3, "{:?}", lighter.app().message());
    lighter
}

/// Opens a panel by the menu of panels.
fn show(lighter: &mut JourneyUser, panel: &str) {
    lighter.press("View");
    lighter.press_a(Role::CheckBox, panel);
    lighter.key(Key::Escape);
    lighter.settle();
}

/// Types into a cell of the light table, which the arrow keys lead to from the row's name.
#[track_caller]
fn set_cell(lighter: &mut JourneyUser, row: &str, column: &str, text: &str) {
    let name = lighter.place_of(Role::Cell, &format!("Light of {row}")).center();
    lighter.click(name);
    let cell = format!("{column} of {row}");
    let is_at = |lighter: &JourneyUser| {
        let found = lighter.harness.query_all_by_role_and_label(Role::Cell, &cell).next();
        found.is_some_and(|cell| cell.accesskit_node().toggled() == Some(Toggled::True))
    };
    for _ in 0..30 {
        if is_at(lighter) {
            break;
        }
        lighter.key(Key::ArrowRight);
    }
    assert!(is_at(lighter), "the keys do not lead to {cell}");
    lighter.type_text(text);
    lighter.key(Key::Enter);
    lighter.settle();
}

/// A point of the picture, in heights from its middle.
fn at(lighter: &JourneyUser, x: f32, y: f32) -> Pos2 {
    let rect = lighter.app().viewport().rect().unwrap();
    rect.center() + vec2(x, -y) * rect.height()
}

/// The ray of the eye through the middle of the pixel at a point of the screen.
fn ray(lighter: &JourneyUser, point: Pos2) -> (DVec3, DVec3) {
    let rect = lighter.app().viewport().rect().unwrap();
    let orbit = lighter.app().session().view().orbit();
    let pixels = lighter.harness.ctx.pixels_per_point();
    let pixel = ((point - rect.min) * pixels).floor() + vec2(0.5, 0.5);
    let size = (rect.size() * pixels).round();
    let offset = (pixel - size / 2.0) / size.y;
    let (right, up) = orbit.right_and_up();
    let span = 2.0 * (orbit.fov / 2.0).tan();
    let (x, y) = (f64::from(offset.x) * span, f64::from(-offset.y) * span);
    let eye = orbit.target + orbit.direction() * orbit.distance;
    (eye, (right * x + up * y - orbit.direction()).normalize())
}

fn on_floor((eye, ray): (DVec3, DVec3)) -> DVec3 {
    eye + ray * ((FLOOR - eye.y) / ray.y)
}

fn on_ball((eye, ray): (DVec3, DVec3)) -> DVec3 {
    let (center, radius) = BALL;
    let along = (center - eye).dot(ray);
    let near = eye + ray * along;
    let half = (radius * radius - near.distance_squared(center)).sqrt();
    assert!(half.is_finite(), "the pointer is on the ball");
    near - ray * half
}

/// The point of the screen where a point of the world is seen.
fn on_screen(lighter: &JourneyUser, point: DVec3) -> Pos2 {
    let orbit = lighter.app().session().view().orbit();
    let (right, up) = orbit.right_and_up();
    let from_eye = point - (orbit.target + orbit.direction() * orbit.distance);
    let span = 2.0 * -from_eye.dot(orbit.direction()) * (orbit.fov / 2.0).tan();
    at(lighter, (from_eye.dot(right) / span) as f32, (from_eye.dot(up) / span) as f32)
}

/// A picture that differs from the one before.
#[track_caller]
fn next(lighter: &mut JourneyUser, before: &Picture) -> Picture {
    let now = lighter.picture();
    now.differs(before);
    now
}

#[test]
fn a_gray_scene_is_lit() {
    let studio = Studio::new();
    // Rays are slow to trace without a card.
    studio.write("gray.json", &LOOK.replacen('{', r#"{"tier": "fast","#, 1));
    studio.write("gray-scene.json", &SCENE.replace("look:open", "gray.json"));
    let file = studio.path("gray-scene.json");
    let mut lighter = open(&studio, &file);
    let begin = scene(&lighter).clone();
    let gray = lighter.picture();

    // Key: the look's light, from now on the scene's; warm, of the set.
    lighter.tab("Lights");
    lighter.press("Add scene light");
    lighter.press("In place of Key");
    show(&mut lighter, "Light table");
    set_cell(&mut lighter, "Key", "Color", "#ffd9a8");
    set_cell(&mut lighter, "Key", "Groups", "set");
    let picture = next(&mut lighter, &gray);

    // Rim: a new light from behind.
    lighter.press("Add scene light");
    lighter.press("Directional");
    set_cell(&mut lighter, "light", "Light", "Rim");
    set_cell(&mut lighter, "Rim", "Direction", "0.8 0.4 -0.75");
    set_cell(&mut lighter, "Rim", "Groups", "rim, set");
    assert_eq!(light(&lighter, "light").direction, [0.8, 0.4, -0.75]);
    let picture = next(&mut lighter, &picture);

    // The eye light goes along with each object.
    lighter.press("Add scene light");
    lighter.press("Point");
    set_cell(&mut lighter, "light_2", "Light", "Eye");
    lighter.press("Columns");
    lighter.press_a(Role::CheckBox, "Frame");
    lighter.key(Key::Escape);
    lighter.settle();
    set_cell(&mut lighter, "Eye", "Frame", "object");
    set_cell(&mut lighter, "Eye", "Position", "0.2 0.5 1.2");
    set_cell(&mut lighter, "Eye", "Half distance", "0.6");
    let eye = light(&lighter, "light_2");
    assert_eq!((eye.kind, eye.space), (LightKind::Point, LightSpace::Object));
    let picture = next(&mut lighter, &picture);

    // For the figure alone.
    show(&mut lighter, "Links");
    lighter.press_a(Role::ListItem, "Link light Eye");
    for object in ["ball", "floor"] {
        lighter.press_a(Role::CheckBox, &format!("object {object} is linked"));
        assert_eq!(scene(&lighter).objects[object].linked.text(), "* - light_2");
    }
    assert_eq!(scene(&lighter).objects["figure"].linked.text(), "*");
    let picture = next(&mut lighter, &picture);

    // The key's shadow of the ball falls where the pointer says.
    lighter.tab("Light table");
    lighter.press_a(Role::Cell, "Light of Key");
    let (caster, place) = (BALL.0 + DVec3::new(0.0, 0.1, 0.45), DVec3::new(0.9, FLOOR, 1.0));
    let [caster, place] = [caster, place].map(|point| on_screen(&lighter, point));
    lighter.hover(caster);
    lighter.key_with(Modifiers::SHIFT, Key::S);
    for point in [caster, place] {
        lighter.click(point);
        lighter.settle();
    }
    let wanted = on_ball(ray(&lighter, caster)) - on_floor(ray(&lighter, place));
    let found = DVec3::from(light(&lighter, "key").direction);
    let hint = lighter.app().placing().hint().to_owned();
    // Within a pixel at both ends.
    assert!(found.angle_between(wanted) < 0.012, "{found} for {wanted}: {hint}");
    lighter.key(Key::Escape);
    lighter.key(Key::Escape);
    lighter.settle();
    let picture = next(&mut lighter, &picture);

    // The probe tells why: the key does not arrive there, and the eye light has no link.
    lighter.press("Probe pixel");
    lighter.click(place);
    lighter.settle();
    let accounts = lighter.app().probe().lights();
    let of = |id: &str| accounts.iter().find(|account| account.light.as_str() == id).unwrap();
    assert!(of("key").reaches && of("light").reaches, "{accounts:?}");
    assert!(!of("light_2").reaches && of("light_2").rule.contains("linked"), "{accounts:?}");
    lighter.press("Probe pixel");

    // The rim is dimmed by the mixer.
    show(&mut lighter, "Mixer");
    let fader = lighter.place_of(Role::Slider, "Fader of group rim");
    lighter.drag(fader.center(), fader.center() + vec2(0.0, fader.height() * 0.25));
    lighter.settle();
    let dimmed = scene(&lighter).light_groups["rim"].intensity;
    assert!((0.05..0.6).contains(&dimmed), "{dimmed}");
    next(&mut lighter, &picture);

    // All of it is undone, done again, saved, and the same elsewhere.
    let end = scene(&lighter).clone();
    lighter.undo_all();
    assert_eq!(*scene(&lighter), begin);
    lighter.picture().equals(&gray);
    while lighter.app().session().steps().redo_label().is_some() {
        lighter.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    }
    lighter.settle();
    assert_eq!(*scene(&lighter), end);
    lighter.key_with(Modifiers::COMMAND, Key::S);
    lighter.settle();
    assert!(!lighter.app().session().open_scene().unwrap().is_dirty());
    lighter.look_from_the_front();
    let lit = lighter.picture();
    drop(lighter);
    let mut other = open(&studio, &file);
    assert_eq!(*scene(&other), end);
    other.look_from_the_front();
    other.picture().equals(&lit);
}
