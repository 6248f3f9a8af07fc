//! Images of f64, and coverage of pixels.

/// An image: rows from the top, the channels of a pixel side by side.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Texels {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Number of channels of a pixel.
    pub channels: usize,
    /// `size[0] * size[1] * channels` numbers.
    pub values: Vec<f64>,
}

impl Texels {
    /// An image of zeros.
    pub fn new(size: [u32; 2], channels: usize) -> Self {
        Self { size, channels, values: vec![0.0; size[0] as usize * size[1] as usize * channels] }
    }

    fn index(&self, x: u32, y: u32) -> usize {
        (y as usize * self.size[0] as usize + x as usize) * self.channels
    }

    /// The channels of a pixel by column and row.
    ///
    /// # Panics
    /// Outside of the image.
    pub fn pixel(&self, x: u32, y: u32) -> &[f64] {
        &self.values[self.index(x, y)..][..self.channels]
    }

    pub(super) fn pixel_mut(&mut self, x: u32, y: u32) -> &mut [f64] {
        let index = self.index(x, y);
        &mut self.values[index..][..self.channels]
    }

    /// The image with each number rounded by `round`.
    pub(super) fn rounded(mut self, round: impl Fn(f64) -> f64) -> Self {
        self.values.iter_mut().for_each(|number| *number = round(*number));
        self
    }

    /// Some of the channels, as an image of their own.
    pub(super) fn channels(&self, range: std::ops::Range<usize>) -> Self {
        let channels = range.len();
        let values = self
            .values
            .chunks_exact(self.channels.max(1))
            .flat_map(|pixel| &pixel[range.clone()])
            .copied();
        Self { size: self.size, channels, values: values.collect() }
    }
}

/// Draws and triangles on top in a pixel. Pixels with equal coverage in two pictures can be
/// compared by color; elsewhere an edge lies a little to one side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// Draw that is on top in most samples, the earlier one of equals; `None` if nothing is.
    pub draw: Option<u32>,
    /// Number of samples that show this draw.
    pub own: u8,
    /// Number of samples that show any draw.
    pub samples: u8,
    /// Number of triangles that are on top in some sample.
    pub triangles: u8,
}

/// Owner of a sample that no triangle covers.
pub(super) const NOTHING: [u32; 2] = [u32::MAX; 2];

impl Coverage {
    /// The coverage of a pixel from the draw and triangle on top in each sample, [`NOTHING`] for
    /// none.
    pub(super) fn of(owners: &[[u32; 2]]) -> Self {
        let mut coverage = Self::default();
        for (i, &owner) in owners.iter().enumerate().filter(|(_, owner)| **owner != NOTHING) {
            coverage.samples += 1;
            coverage.triangles += u8::from(!owners[..i].contains(&owner));
            let own = owners.iter().filter(|other| other[0] == owner[0]).count() as u8;
            if own > coverage.own
                || (own == coverage.own && coverage.draw.is_none_or(|draw| owner[0] < draw))
            {
                (coverage.draw, coverage.own) = (Some(owner[0]), own);
            }
        }
        coverage
    }

    /// True if all of `samples` samples show the same draw.
    pub fn is_inside(&self, samples: u32) -> bool {
        u32::from(self.own) == samples
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn most_samples_decide_and_the_earlier_draw_of_equals() {
        let coverage = Coverage::of(&[[3, 1], [2, 0], NOTHING, [3, 2]]);
        assert_eq!(coverage, Coverage { draw: Some(3), own: 2, samples: 3, triangles: 3 });
        assert_eq!(Coverage::of(&[[3, 1], [2, 0], [2, 0], [3, 1]]).draw, Some(2));
        assert_eq!(Coverage::of(&[NOTHING; 4]), Coverage::default());
        assert!(Coverage::of(&[[0, 0], [0, 1], [0, 1], [0, 0]]).is_inside(4));
    }
}
