//! Pictures of scenes that are seen from the front, along the z axis and without perspective, x to
//! the right and y up: what stands where in them is known in pixels.

use chiaro_compiler::compile::Live;
use chiaro_compiler::document::{Camera, Projection, Scene};
use chiaro_compiler::library::Library;
use chiaro_language::progress::Progress;
use chiaro_scene::frame::{Executor, FramePlan, Picture, PlanOptions, Planner, Setup};
use chiaro_test_support::wait::block_on;
use glam::DVec2;

use crate::eval::told;

/// Width and height of the pictures, in pixels.
pub const SIZE: u32 = 128;

/// Height of what the camera sees, in scene units.
pub const SEEN: f64 = 4.0;

/// Pixels to a unit of the scene.
pub const PIXELS: f64 = SIZE as f64 / SEEN;

/// A scene without objects, seen from the front.
pub fn from_front() -> Scene {
    let camera = Camera {
        eye: [0.0, 0.0, 10.0],
        target: [0.0; 3],
        height: SEEN,
        projection: Projection::Orthographic,
        ..Camera::default()
    };
    Scene { backdrop: None, camera, ..Scene::default() }
}

/// The plan of a picture of so many samples a pixel.
pub fn planned(setup: &Setup, samples: u32) -> FramePlan {
    let options = PlanOptions { size: [SIZE; 2], samples, time: 0.0 };
    let planned = Planner::default().plan(setup, Library::built_in(), &Live::Keyed, &options);
    planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
}

/// The picture of a plan.
pub fn drawn(executor: &mut dyn Executor, plan: &FramePlan) -> Picture {
    let picture = block_on(executor.picture(plan, &Progress::new()));
    picture.unwrap_or_else(|error| panic!("{}: {error}", executor.name()))
}

/// The first number of each pixel that shows anything.
pub fn first_numbers(picture: &Picture) -> Vec<Option<f64>> {
    picture.rgba.iter().map(|pixel| (pixel[3] > 0.5).then(|| f64::from(pixel[0]))).collect()
}

/// A place in pixels from the picture's middle, y up, from a pixel and a place within.
pub fn place(pixel: usize, within: DVec2) -> DVec2 {
    let at = DVec2::new((pixel % SIZE as usize) as f64, (pixel / SIZE as usize) as f64) + within;
    let middle = 0.5 * f64::from(SIZE);
    DVec2::new(at.x - middle, middle - at.y)
}

/// The share of a pixel in which a line is, by 16 x 16 samples.
pub fn share(pixel: usize, is_line: &dyn Fn(DVec2) -> bool) -> f64 {
    const SIDE: usize = 16;
    let sample = |index: usize| {
        let at = DVec2::new((index % SIDE) as f64, (index / SIDE) as f64);
        is_line(place(pixel, (at + 0.5) / SIDE as f64))
    };
    (0..SIDE * SIDE).filter(|index| sample(*index)).count() as f64 / (SIDE * SIDE) as f64
}
