//! Mattes: which object and material each sample of a picture shows.
//!
//! A plan of mattes is a plan like any other, of looks' modules that write three small numbers in
//! place of a color, one sample a pixel. There is one for each sample of the picture, moved so that
//! the sample's place is the middle of the pixel; so coverage is that of the picture to the sample,
//! on every executor, and numbers are never averaged.

use super::picture::Picture;

/// Places of four samples in a pixel, in sixteenths: the standard ones of Direct3D and Vulkan.
const FOUR: [[f64; 2]; 4] = [[6.0, 2.0], [14.0, 6.0], [2.0, 10.0], [10.0, 14.0]];

/// Numbers in one channel of a matte.
const BASE: f32 = 1024.0;

/// Shifts of a picture by which each sample comes to lie in the middle of its pixel.
pub(super) fn sample_shifts(samples: u32) -> Vec<[f64; 2]> {
    if samples == 1 {
        return vec![[0.0; 2]];
    }
    FOUR.iter().map(|place| place.map(|at| (8.0 - at) / 16.0)).collect()
}

/// Part of an object that a sample shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MattePart {
    /// Number of the object, among those of the setup.
    pub object: usize,
    /// Number of the material, among the parts of the object's mesh.
    pub material: usize,
}

impl MattePart {
    /// The parts that a picture of mattes shows, pixel by pixel in rows from the top; `None` where
    /// nothing is seen.
    pub fn seen(picture: &Picture) -> impl Iterator<Item = Option<Self>> + '_ {
        picture.rgba.iter().map(|[low, high, material, alpha]| {
            let object = (high * BASE + low - 1.0).round();
            (*alpha > 0.5 && object >= 0.0)
                .then(|| Self { object: object as usize, material: material.round() as usize })
        })
    }
}
