//! The picture in the window, drawn by the renderer on the window's own device (software Vulkan
//! suffices).
#![allow(clippy::print_stdout, reason = "what is measured is printed")]

use std::path::Path;
use std::time::Duration;

use crate::editor_support::User;
use chiaro::document::{Edit, GraphId};
use eframe::egui::{Key, Pos2, Rect, vec2};
use egui_kittest::kittest::Queryable as _;

/// Colors of the row of pixels through the middle of the picture.
fn middle_row(hand: &mut User) -> Vec<[u8; 4]> {
    let rect = hand.app().viewport().rect().unwrap();
    let image = hand.harness.render().unwrap();
    let y = rect.center().y as u32;
    (rect.min.x as u32 + 2..rect.max.x as u32 - 2).map(|x| image.get_pixel(x, y).0).collect()
}

#[test]
fn the_picture_shows_the_look_and_follows_the_hand() {
    let mut hand = User::drawing();
    let first = middle_row(&mut hand);
    let (edge, middle) = (first[0], first[first.len() / 2]);
    assert_ne!(edge, middle, "the object stands before the backdrop");

    // A drag turns the illumination frame.
    let rect = hand.app().viewport().rect().unwrap();
    hand.drag(rect.center(), rect.center() + vec2(90.0, 0.0));
    hand.settle();
    let turned = middle_row(&mut hand);
    assert_ne!(first, turned);

    // The live shader shows an edited value at once; at rest the baked shader shows the same
    // picture.
    let color = chiaro::document::Value::Vector(vec![0.1, 0.2, 0.9]);
    let graph = chiaro::document::GraphId::Look;
    let edit = chiaro::document::Edit::SetValue {
        graph,
        id: "base".into(),
        port: "color".into(),
        value: color,
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.harness.step();
    hand.app().wait();
    hand.harness.step();
    let live = middle_row(&mut hand);
    assert_ne!(turned, live);
    hand.harness.run_steps(12);
    hand.settle();
    let baked = middle_row(&mut hand);
    let far = |a: &[u8; 4], b: &[u8; 4]| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 1);
    assert!(!live.iter().zip(&baked).any(|(a, b)| far(a, b)), "baked equals live within 1/255");

    // At rest nothing is drawn.
    let before = hand.app().pictures();
    hand.harness.run_steps(10);
    assert_eq!(hand.app().pictures(), before);
    assert_eq!(
        hand.repaint_delay(),
        std::time::Duration::MAX,
        "{:?}",
        hand.harness.ctx.repaint_causes()
    );
}

#[test]
fn the_last_good_picture_stays_while_the_look_is_broken() {
    let mut hand = User::drawing();
    let good = middle_row(&mut hand);
    let nothing = hand.empty_place();
    hand.drag(hand.input("output", "color"), nothing);
    hand.harness.remove_cursor();
    hand.settle();
    assert!(hand.app().canvas().has_error("output"));
    // The list of problems makes the viewport lower and moves the picture, so only the color is
    // compared, not its place.
    let is_near =
        |color: &[u8; 4]| color.iter().zip(good[good.len() / 2]).all(|(a, b)| a.abs_diff(b) <= 6);
    assert!(middle_row(&mut hand).iter().any(is_near));
}

#[test]
fn the_old_picture_steps_back_while_another_look_is_prepared() {
    // Four frames a second by the window's clock.
    let mut hand = User::drawing_with(|app, _| app.without_dialogs());
    assert!(!hand.app().is_preparing() && !hand.says("Preparing"));
    hand.app_mut().session_mut().open(Path::new("examples/looks/figure4-color.json")).unwrap();
    let now = |hand: &User| hand.harness.ctx.input(|input| input.time);
    let begins = now(&hand) + 0.25;
    for frame in 0..40 {
        hand.harness.step();
        // A look that is still prepared after a frame was so within it; preparing for up to a third
        // of a second shows no sign.
        if now(&hand) - begins < 0.35 {
            assert!(!hand.says("Preparing"), "frame {frame}: quick ones do not flicker");
        } else if frame > 3 && hand.app().is_preparing() {
            assert!(hand.says("Preparing figure4-color.json"), "frame {frame}");
        }
    }
    hand.settle();
    assert!(!hand.app().is_preparing() && !hand.says("Preparing"));

    // A look that is broken from the start has no picture, and does not show another look's.
    let folder = tempfile::tempdir().unwrap();
    let broken = folder.path().join("broken.json");
    std::fs::write(&broken, r#"{"chiaro": "look", "nodes": [{"kind": "base"}]}"#).unwrap();
    hand.app_mut().session_mut().open(&broken).unwrap();
    hand.settle();
    assert!(hand.says("No picture yet"), "{:?}", hand.errors());
    hand.app_mut().session_mut().start_new();
    hand.settle();
    assert!(!hand.says("No picture yet"));

    // After an error of the graph the picture says that it is of the graph before.
    let stale = "Of the graph before the error";
    assert!(!hand.has(stale));
    let remove = Edit::RemoveNode { graph: GraphId::Look, id: "output".into() };
    hand.app_mut().session_mut().apply(remove, None).unwrap();
    hand.settle();
    assert!(hand.has(stale) && !hand.errors().is_empty(), "{:?}", hand.errors());
    hand.undo();
    hand.settle();
    assert!(!hand.has(stale) && hand.errors().is_empty(), "{:?}", hand.errors());
}

#[test]
fn the_look_is_seen_on_another_mesh_and_on_one_from_a_file() {
    let mut hand = User::drawing();
    let creature = middle_row(&mut hand);
    hand.app_mut().show_on("shape:torus");
    hand.settle();
    let torus = middle_row(&mut hand);
    assert_ne!(creature, torus);

    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("wedge.obj");
    std::fs::write(&file, "v -1 -1 0\nv 1 -1 0\nv 1 1 -1\nv -1 1 -1\nf 1 2 3 4\n").unwrap();
    hand.app_mut().show_on(&file.to_string_lossy());
    hand.settle();
    // What was noted of the file goes from the status bar once it was read.
    let list = "Open the list of problems";
    assert!(hand.has(list) && hand.says("normals were made"));
    hand.press(list);
    assert!(hand.says("normals were made"), "the panel has it");
    assert!(!hand.has(list));
    let wedge = middle_row(&mut hand);
    assert_ne!(torus, wedge);

    // A missing mesh is told of, and the last good picture stays.
    hand.app_mut().show_on("nowhere.obj");
    hand.settle();
    // The message makes the viewport lower, so only the color is compared, not its place.
    let shown = middle_row(&mut hand);
    assert_eq!(shown[shown.len() / 2], wedge[wedge.len() / 2]);
}

/// A look that shows a litsphere: the image of a painted ball.
const LITSPHERE: &str = r##"{
  "name": "Ball",
  "nodes": [
    {"id": "ball", "kind": "litsphere", "at": [0, 0], "values": {"image": "ball.png",
    "lookup": "camera"}},
    {"id": "output", "kind": "output", "at": [260, 0]}
  ],
  "wires": [{"from": "ball", "to": "output.color"}]
}"##;

#[test]
fn a_baked_ball_shows_what_the_look_shows() {
    let mut hand = User::drawing();
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    hand.app_mut().show_on("shape:knot");
    // Seen from aside, with the lights turned, and without perspective, which would turn normals
    // away from the camera a little.
    let rect = hand.app().viewport().rect().unwrap();
    hand.hover(rect.center());
    hand.key(Key::P);
    hand.drag(rect.min + vec2(4.0, 30.0), rect.min + vec2(60.0, 50.0));
    hand.drag(rect.center(), rect.center() + vec2(30.0, 20.0));
    hand.app_mut().bake_litsphere(512, &file("ball.png"));
    hand.app_mut().save_picture([320, 240], &file("own.png"));
    hand.settle();
    let orbit = hand.app().session().view().orbit().clone();
    std::fs::write(file("ball.json"), LITSPHERE).unwrap();
    // The picture of the same mesh goes on to be seen as it was.
    hand.app_mut().open(&file("ball.json"));
    hand.settle();
    assert!(
        (hand.app().session().view().orbit().direction() - orbit.direction()).length() < 1e-9,
        "seen from the same place"
    );
    hand.app_mut().save_picture([320, 240], &file("baked.png"));
    hand.settle();
    let [own, baked] =
        ["own.png", "baked.png"].map(|name| image::open(file(name)).unwrap().into_rgba8());
    let backdrop = own.get_pixel(0, 0).0;
    let (mut sum, mut count, mut far) = (0.0, 0, 0);
    for (a, b) in own.pixels().zip(baked.pixels()).filter(|(a, _)| a.0 != backdrop) {
        let difference = (0..3).map(|k| a.0[k].abs_diff(b.0[k])).max().unwrap();
        // Near the rim of the ball's image a pixel is several degrees.
        far += u32::from(difference > 6);
        sum += f64::from(difference);
        count += 1;
    }
    assert!(count > 5000, "{count}");
    let mean = sum / f64::from(count);
    assert!(
        mean < 0.6 && far * 100 < count,
        "mean {mean} of 255, {far} of {count} pixels are far off"
    );
}

#[test]
fn a_picture_is_saved_in_its_size_and_on_its_backdrop() {
    let mut hand = User::drawing();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("picture.png");
    hand.app_mut().save_picture([123, 77], &path);
    hand.settle();
    let picture = image::open(&path).unwrap().into_rgba8();
    assert_eq!(picture.dimensions(), (123, 77));
    assert_eq!(picture.get_pixel(0, 0).0[3], 255);
    assert_ne!(picture.get_pixel(0, 0), picture.get_pixel(61, 38));
    assert!(hand.harness.query_by_label_contains("Saved").is_some(), "it is told");
}

#[test]
fn what_a_hand_does_is_in_the_frame_that_follows() {
    let mut hand = User::drawing();
    hand.app_mut().show_on("shape:sphere");
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let slider = hand.slider("Cut-off");
    let from = slider.left_center() + vec2(slider.width() * 0.5, 0.0);
    // A first drag compiles the live shader's pipeline.
    hand.drag(from, from + vec2(5.0, 0.0));
    hand.settle();
    let before = middle_row(&mut hand);
    let wishes = hand.app().pictures();
    let slider = hand.slider("Cut-off");
    let from = slider.left_center() + vec2(slider.width() * 0.5, 0.0);
    hand.hold(from);
    hand.move_to(from + vec2(40.0, 0.0));
    // The edit of this frame has asked for its picture before the frame ended.
    assert!(hand.app().pictures() > wishes);
    hand.app().wait();
    let after = middle_row(&mut hand);
    assert_ne!(before, after, "and the frame shows it");
    hand.release(from + vec2(40.0, 0.0));
    hand.settle();
    assert_eq!(hand.app().coarseness(), 1, "at rest the picture is whole");
}

/// Pixels of the picture as the window shows them now.
fn picture(hand: &mut User) -> Vec<u8> {
    let rect = hand.app().viewport().rect().unwrap();
    let image = hand.harness.render().unwrap();
    let [x, y, width, height] =
        [rect.min.x, rect.min.y, rect.width(), rect.height()].map(|side| side as u32);
    image::imageops::crop_imm(&image, x, y, width, height).to_image().into_raw()
}

/// Drags step by step. Each step's frame already shows the picture that the window shows once all
/// work is done.
fn assert_in_the_next_frame(hand: &mut User, from: Pos2, what: &str) {
    hand.hold(from);
    let mut last = picture(hand);
    for step in 1..=6_u8 {
        hand.move_to(from + f32::from(step) * vec2(-4.0, 2.0));
        let shown = picture(hand);
        hand.app().wait();
        assert!(picture(hand) == shown, "{what}: the picture of step {step} came later");
        assert!(shown != last, "{what}: step {step} changes the picture");
        last = shown;
    }
    hand.release(from + 6.0 * vec2(-4.0, 2.0));
    hand.settle();
}

#[test]
fn the_picture_of_a_drag_is_in_the_very_next_frame() {
    let mut hand = User::drawing();
    // On a busy machine too: the test holds that the picture is waited for, and drawn before the
    // window is.
    hand.app_mut().wait_for_pictures(Duration::from_secs(60));
    hand.app_mut().show_on("shape:sphere");
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let middle = |rect: Rect| rect.left_center() + vec2(rect.width() * 0.5, 0.0);
    // A first drag compiles the live shader's pipeline.
    let slider = middle(hand.slider("Cut-off"));
    hand.drag(slider, slider + vec2(5.0, 0.0));
    hand.settle();
    assert_in_the_next_frame(&mut hand, slider, "a value");
    let line = hand.app().viewport().curve("cutoff");
    assert_in_the_next_frame(&mut hand, line[line.len() / 2], "a line on the object");
    let rect = hand.app().viewport().rect().unwrap();
    hand.app_mut().session_mut().select(Vec::new());
    hand.settle();
    assert_in_the_next_frame(&mut hand, rect.center() + vec2(30.0, 60.0), "the lights");
    assert_in_the_next_frame(&mut hand, rect.min + vec2(12.0, 12.0), "the camera");
}

#[test]
fn an_image_is_held_beside_the_picture_and_over_it() {
    let mut hand = User::drawing();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("paint.png");
    image::RgbaImage::from_pixel(8, 8, image::Rgba([250, 20, 10, 255])).save(&path).unwrap();
    let room = hand.app().viewport().rect().unwrap();
    hand.app_mut().show_reference(&path);
    hand.settle();
    let rect = hand.app().viewport().rect().unwrap();
    assert!((rect.width() - room.width() / 2.0).abs() < 1.0, "the picture has the right half");
    let at = room.left_center() + vec2(room.width() / 4.0, 0.0);
    let color =
        |hand: &mut User| hand.harness.render().unwrap().get_pixel(at.x as u32, at.y as u32).0;
    assert_eq!(color(&mut hand), [250, 20, 10, 255]);
    let options = hand.harness.get_by_label("Options").rect().center();
    hand.click(options);
    let over = hand.harness.get_by_label("Over").rect().center();
    hand.click(over);
    assert!(
        hand.harness.query_all_by_label("Opacity of the image").count() > 0,
        "the menu stays open"
    );
    hand.settle();
    assert_eq!(hand.app().viewport().rect().unwrap().width(), room.width());
    let away = hand.harness.get_by_label("Take away").rect().center();
    hand.click(away);
    hand.settle();
    assert!(color(&mut hand)[0] < 200);
}

#[test]
fn exposure_changes_what_is_shown_and_not_the_look() {
    let mut hand = User::drawing();
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    let dim = middle_row(&mut hand);
    let options = hand.harness.get_by_label("Options").rect().center();
    hand.click(options);
    let sliders = hand.harness.get_all_by_label("Exposure").map(|node| node.rect());
    let slider = sliders.max_by(|a, b| a.width().total_cmp(&b.width())).unwrap();
    hand.click(slider.left_center() + vec2(slider.width() * 0.625, 0.0));
    hand.click(options);
    hand.settle();
    let bright = middle_row(&mut hand);
    let middle = dim.len() / 2;
    // A quarter of the way from 0 to 4 stops on the right is 1 stop: about 2^(1 / 2.2) in shown
    // values.
    let gain = f64::from(bright[middle][1]) / f64::from(dim[middle][1]);
    assert!((1.25..1.5).contains(&gain), "{gain}");
    assert!(!hand.app().session().is_dirty());
}

/// Prints the median and the 95th percentile of times in milliseconds.
fn told(what: &str, mut times: Vec<f64>) {
    times.sort_by(f64::total_cmp);
    let (median, p95) = (times[times.len() / 2], times[times.len() * 95 / 100]);
    println!("{what:<60} median {median:6.2} ms, p95 {p95:6.2} ms");
}

/// Measures what the handles cost the window while they are dragged, without and with a picture,
/// and how often the picture of an edit is with the GPU before the edit's own frame ends.
#[test]
#[ignore = "prints how long it takes, and judges nothing"]
fn the_viewport_is_measured() {
    let models = std::env::var("CHIARO_MODELS").ok();
    let meshes = ["shape:creature".to_owned()].into_iter();
    let meshes: Vec<_> =
        meshes.chain(models.map(|folder| format!("{folder}/nefertiti.obj"))).collect();
    for (what, mut hand) in [("no picture", User::new()), ("with a picture", User::drawing())] {
        hand.app_mut().open(std::path::Path::new("examples/looks/figure1-layers.json"));
        for mesh in &meshes {
            hand.app_mut().show_on(mesh);
            measure_drags(
                &mut hand,
                &format!("{}, {what}", mesh.rsplit('/').next().unwrap_or(mesh)),
            );
        }
    }
}

fn measure_drags(hand: &mut User, what: &str) {
    use chiaro::clock::Clock;
    const FRAMES: u8 = 80;
    let rect = hand.app().viewport().rect().unwrap();
    for (ids, with) in [(Vec::new(), "without handles"), (vec!["diffuse".into()], "with handles")] {
        hand.app_mut().session_mut().select(ids);
        hand.settle();
        hand.hover(rect.center());
        let frame = |_| {
            let clock = Clock::start();
            hand.harness.step();
            clock.seconds() * 1e3
        };
        told(&format!("{what}: nothing moves, {with}"), (0..FRAMES).map(frame).collect());
    }
    let points = hand.app().viewport().curve("cutoff");
    let middle = hand.app().viewport().middle().unwrap_or(rect.center());
    for (from, name) in
        [(points[points.len() / 2], "a line is dragged"), (middle, "a light is dragged")]
    {
        hand.hold(from);
        let mut in_time = 0;
        let frame = |step: u8| {
            let clock = Clock::start();
            hand.move_to(rect.center() + vec2(f32::from(step % 20) * 3.0, f32::from(step % 7)));
            let time = clock.seconds() * 1e3;
            in_time += u32::from(!hand.app().is_busy());
            hand.app().wait();
            time
        };
        told(&format!("{what}: {name}"), (0..FRAMES).map(frame).collect());
        println!("{:>60} {in_time} of {FRAMES} with the GPU before the frame ended", "");
        hand.release(rect.center());
        hand.settle();
    }
    hand.undo();
    hand.undo();
}
