//! Latency from a drag to its picture, in frames and in milliseconds, on the present device.

use chiaro::clock::Clock;
use eframe::egui::{Pos2, Rect, vec2};

use crate::editor_support::User;
use crate::times::told;
use crate::{driven, example, has_display};

const FRAMES: u8 = 80;
/// Half of a drag's width if there is room, in points.
const REACH: f32 = 40.0;

/// Pixels of the picture in the window as it is drawn now; waits for the GPU.
fn pixels(hand: &mut User) -> Vec<u8> {
    let rect: Rect = hand.app().viewport().rect().expect("the picture is shown");
    let image = hand.harness.render().expect("it draws");
    let [x, y, width, height] =
        [rect.min.x, rect.min.y, rect.width(), rect.height()].map(|side| side as u32);
    image::imageops::crop_imm(&image, x, y, width, height).to_image().into_raw()
}

/// Drags along a small loop that is twice `reach` wide, in points. Prints how many pictures were in
/// the very frame of their edit, of all whose edit changed anything, and the time from the
/// pointer's move until that frame was drawn.
fn drag(hand: &mut User, from: Pos2, reach: f32, what: &str) {
    hand.hold(from);
    let (mut in_time, mut changed, mut times, mut own) = (0, 0, Vec::new(), Vec::new());
    let mut last = pixels(hand);
    for step in 1..=FRAMES {
        let clock = Clock::start();
        let turn = f32::from(step) * 0.31;
        hand.move_to(from + reach * vec2(turn.cos() - 1.0, 0.5 * turn.sin()));
        own.push(clock.seconds());
        let shown = pixels(hand);
        times.push(clock.seconds());
        hand.app().wait();
        let right = pixels(hand);
        // A value that is at the end of its range draws the same picture again, which tells
        // nothing.
        changed += u32::from(right != last);
        in_time += u32::from(shown == right && right != last);
        last = right;
    }
    hand.release(from);
    hand.settle();
    println!("| {what} | {in_time} of {changed} | {} | {} |", told(times), told(own));
}

pub(crate) fn run() {
    let mut hand = User::drawing();
    println!("\nFrom a drag to its picture (window of 1500x900 points); ms, median / p95");
    println!(
        "\n| what is dragged | in the very next frame | from the pointer to the drawn frame | of \
         that the UI thread |"
    );
    println!("| --- | ---: | ---: | ---: |");
    for look in ["figure1-layers", "figure4-both"] {
        hand.app_mut().open(&example(look));
        hand.settle();
        hand.app_mut().session_mut().select(vec!["diffuse".into()]);
        hand.settle();
        let slider = hand.slider("Cut-off");
        // A first drag creates the live shader's pipeline.
        let at = slider.left_center() + vec2(slider.width() * 0.5, 0.0);
        hand.drag(at, at + vec2(5.0, 0.0));
        hand.settle();
        drag(&mut hand, at, slider.width() * 0.2, &format!("{look}: a value"));
        if let Some(line) = hand.app().viewport().curve("cutoff").first().copied() {
            drag(&mut hand, line, REACH, &format!("{look}: a line on the object"));
        }
        if let Some(middle) = hand.app().viewport().middle() {
            drag(&mut hand, middle, REACH, &format!("{look}: a light"));
        }
        let corner =
            hand.app().viewport().rect().expect("the picture is shown").min + vec2(60.0, 60.0);
        drag(&mut hand, corner, REACH, &format!("{look}: the camera"));
    }
    if has_display() {
        driven::run(&example("figure1-layers"));
    }
}
