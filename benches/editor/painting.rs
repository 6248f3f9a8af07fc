//! Latency from the pointer to the stroke on the screen: on the tile, and on the surface that shows
//! it.

use std::path::Path;
use std::sync::Arc;

use chiaro::clock::Clock;
use chiaro::document::{Address, Directions, Grid, Hcbtf, Rule, Tile};
use eframe::egui::accesskit::Role;
use eframe::egui::{Rect, vec2};

use crate::editor_support::User;
use crate::times::told;

const FRAMES: u8 = 60;
/// Half of the size of a stroke's loop on the screen, in points.
const REACH: f32 = 60.0;

/// A tile of noise, without areas of one color.
fn noise(size: [u32; 2]) -> Tile {
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 24) as u8
    };
    let texels = (0..size[0] * size[1]).flat_map(|_| [next(), next(), next(), 255]);
    Tile::new(size, texels.collect()).expect("four bytes a texel")
}

/// A window with an open HCBTF whose rules blend two painted samples.
fn opened(folder: &Path, grid: Grid) -> User {
    let mut hcbtf = Hcbtf { rules: vec![Rule::Blend { sharpness: 4.0 }], ..Hcbtf::new(grid) };
    for light in [[0, 0], [grid.light.theta - 1, 0]] {
        hcbtf.painted.insert(Address::new(light, [0, 0]), Arc::new(noise(grid.size)));
    }
    let path = folder.join(format!("{}.hcbtf", grid.size[0]));
    std::fs::write(&path, chiaro::hcbtf::write(&hcbtf).expect("it can be written"))
        .expect("a folder to write to");
    let mut hand = User::drawing_with(|app, _| app.without_dialogs());
    hand.app_mut().open(&path);
    hand.settle();
    hand
}

/// Pixels of a part of the image.
fn pixels(image: &image::RgbaImage, rect: Rect) -> Vec<u8> {
    let [x, y, width, height] =
        [rect.min.x, rect.min.y, rect.width(), rect.height()].map(|side| side as u32);
    image::imageops::crop_imm(image, x, y, width, height).to_image().into_raw()
}

/// Number of pictures of a part of the window that were in the very frame of their stamp.
#[derive(Default)]
struct PictureCount {
    in_time: u32,
    changed: u32,
    last: Vec<u8>,
}

impl PictureCount {
    fn tell(&mut self, shown: &[u8], right: Vec<u8>) {
        self.changed += u32::from(right != self.last);
        self.in_time += u32::from(shown == right && right != self.last);
        self.last = right;
    }
}

fn stroke(hand: &mut User, texels: f64, what: &str) {
    let size = hand.place_of(Role::SpinButton, "Size");
    hand.type_over(size, &format!("{texels}"));
    let canvas = hand.place("Painting canvas");
    let picture = hand.app().viewport().rect().expect("the picture is shown");
    let from = canvas.center() + vec2(30.0, 0.0);
    hand.hold(from);
    let (mut on_tile, mut on_surface) = (PictureCount::default(), PictureCount::default());
    let (mut times, mut own) = (Vec::new(), Vec::new());
    for step in 1..=FRAMES {
        let turn = f32::from(step) * 0.31;
        let clock = Clock::start();
        hand.move_to(from + REACH * vec2(turn.cos() - 1.0, turn.sin()));
        own.push(clock.seconds());
        let shown = hand.harness.render().expect("it draws");
        times.push(clock.seconds());
        hand.app().wait();
        let right = hand.harness.render().expect("it draws");
        on_tile.tell(&pixels(&shown, canvas), pixels(&right, canvas));
        on_surface.tell(&pixels(&shown, picture), pixels(&right, picture));
    }
    hand.release(from);
    let clock = Clock::start();
    hand.settle();
    let settled = clock.seconds() * 1e3;
    println!(
        "| {what} | {} of {} | {} of {} | {} | {} | {settled:.0} |",
        on_tile.in_time,
        on_tile.changed,
        on_surface.in_time,
        on_surface.changed,
        told(own),
        told(times)
    );
}

pub(crate) fn run() {
    println!("\nFrom the pointer to the stroke (window of 1500x900 points); ms, median / p95");
    println!(
        "\n| tile, directions, brush | on the tile in the very frame | on the surface | the UI \
         thread | to the drawn frame \
         | until all is filled |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: |");
    let folder = tempfile::tempdir().expect("a folder");
    let few = Directions { theta: 2, phi: 4 };
    let large = Grid { size: [512, 512], light: few, view: few };
    for (grid, brush) in [(Grid::THESIS, 4.0), (large, 16.0), (large, 64.0)] {
        let mut hand = opened(folder.path(), grid);
        let directions = grid.sample_count();
        stroke(
            &mut hand,
            brush,
            &format!("{0}x{0}, {directions} samples, {brush} texels", grid.size[0]),
        );
    }
}
