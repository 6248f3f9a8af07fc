//! Samples of one tile of the picture: depth, color, and the draw on top.

use super::coverage::{Pixels, bit};
use super::raster::Raster;
use super::shader::ShaderOutputs;
use super::texels::{Coverage, NOTHING};

/// Image that a pass draws into.
#[derive(Clone, Debug, PartialEq)]
pub enum PassTarget {
    /// A picture that is cleared to this premultiplied color; straight colors are blended over it,
    /// and samples averaged.
    Picture([f64; 4]),
    /// A picture with this many layers beside it, four channels each, which are cleared to 0 and
    /// otherwise drawn as the picture is.
    Layered([f64; 4], usize),
    /// Numbers, this many a pixel, which are cleared to 0 and are replaced; one sample a pixel.
    Numbers(usize),
}

impl PassTarget {
    /// Number of channels of a fragment.
    pub(super) fn channels(&self) -> usize {
        match self {
            Self::Picture(_) => 4,
            Self::Layered(_, layers) => 4 * (1 + layers),
            Self::Numbers(channels) => *channels,
        }
    }
}

/// A quad whose colors are being shaded.
#[derive(Clone, Copy, Debug)]
pub(super) struct PendingQuad {
    /// Upper left pixel.
    pub(super) at: [u32; 2],
    pub(super) covered: u16,
    /// Depth of each sample of each lane.
    pub(super) depths: [f64; 16],
    /// Draw and triangle.
    pub(super) owner: [u32; 2],
}

/// The samples of one tile: 8 bytes for the depth, 8 for each channel, 8 for the owner.
#[derive(Clone, Debug)]
pub(super) struct TileSamples {
    pixels: Pixels,
    width: usize,
    samples: usize,
    channels: usize,
    depths: Vec<f64>,
    colors: Vec<f64>,
    owners: Vec<[u32; 2]>,
}

impl TileSamples {
    /// Memory for tiles of up to `side` by `side` pixels.
    pub(super) fn new(side: u32, samples: u32, target: &PassTarget) -> Self {
        let (count, channels) = ((side * side * samples) as usize, target.channels());
        Self {
            pixels: Pixels { begin: [0; 2], end: [0; 2] },
            width: side as usize,
            samples: samples as usize,
            channels,
            depths: vec![1.0; count],
            colors: vec![0.0; count * channels],
            owners: vec![NOTHING; count],
        }
    }

    /// Clears the tile for `pixels`: depths to the far plane, colors to those of `target`.
    pub(super) fn clear(&mut self, pixels: Pixels, target: &PassTarget) {
        self.pixels = pixels;
        self.depths.fill(1.0);
        self.owners.fill(NOTHING);
        match target {
            PassTarget::Picture(background) => {
                self.colors.chunks_exact_mut(4).for_each(|color| color.copy_from_slice(background));
            }
            PassTarget::Layered(background, _) => {
                self.colors.fill(0.0);
                let pixels = self.colors.chunks_exact_mut(self.channels);
                pixels.for_each(|pixel| pixel[..4].copy_from_slice(background));
            }
            PassTarget::Numbers(_) => self.colors.fill(0.0),
        }
    }

    /// The pixels of the tile.
    pub(super) fn pixels(&self) -> Pixels {
        self.pixels
    }

    /// Index of the first sample of a pixel.
    fn index(&self, x: u32, y: u32) -> usize {
        let (x, y) = ((x - self.pixels.begin[0]) as usize, (y - self.pixels.begin[1]) as usize);
        (y * self.width + x) * self.samples
    }

    /// The samples that are in front of the drawn ones; earlier quads of the same batch may still
    /// hide them.
    pub(super) fn in_front(&self, pending: &PendingQuad) -> u16 {
        let mut covered = 0;
        for corner in (0..4).filter(|corner| pending.covered >> (4 * corner) & 0xF != 0) {
            let first = self.corner(pending, corner);
            for sample in
                (0..self.samples).filter(|sample| pending.covered & bit(corner, *sample) != 0)
            {
                // Depths only ever fall, so that a sample that is hidden now stays hidden, and
                // needs no color.
                if pending.depths[4 * corner + sample] < self.depths[first + sample] {
                    covered |= bit(corner, sample);
                }
            }
        }
        covered
    }

    /// Index of the first sample of one of a quad's four pixels.
    fn corner(&self, pending: &PendingQuad, corner: usize) -> usize {
        self.index(pending.at[0] + (corner as u32 & 1), pending.at[1] + (corner as u32 >> 1))
    }

    /// Draws a quad whose colors are in the lanes from `lane`.
    pub(super) fn draw(
        &mut self,
        pending: &PendingQuad,
        lane: usize,
        shaded: &ShaderOutputs,
        target: &PassTarget,
    ) {
        for corner in 0..4 {
            let covered = pending.covered >> (4 * corner) & 0xF;
            if covered == 0 || shaded.discarded >> (lane + corner) & 1 == 1 {
                continue;
            }
            let first = self.corner(pending, corner);
            for sample in (0..self.samples).filter(|sample| covered >> sample & 1 == 1) {
                let (index, depth) = (first + sample, pending.depths[4 * corner + sample]);
                if depth < self.depths[index] {
                    self.depths[index] = depth;
                    self.owners[index] = pending.owner;
                    let channels = self.channels;
                    let color = &mut self.colors[index * channels..][..channels];
                    write(color, |channel| shaded.get(channel, lane + corner), target);
                }
            }
        }
    }

    /// Averages the samples of each pixel into the picture.
    pub(super) fn resolve(&self, raster: &mut Raster) {
        let Raster { texels: picture, coverage, depths } = raster;
        let share = 1.0 / self.samples as f64;
        for y in self.pixels.begin[1]..self.pixels.end[1] {
            for x in self.pixels.begin[0]..self.pixels.end[0] {
                let first = self.index(x, y);
                let pixel = picture.pixel_mut(x, y);
                for (channel, number) in pixel.iter_mut().enumerate() {
                    let sample =
                        |sample: usize| self.colors[(first + sample) * self.channels + channel];
                    *number = (0..self.samples).map(sample).sum::<f64>() * share;
                }
                let place = y as usize * picture.size[0] as usize + x as usize;
                coverage[place] = Coverage::of(&self.owners[first..][..self.samples]);
                depths[place] =
                    self.depths[first..][..self.samples].iter().copied().fold(1.0, f64::min);
            }
        }
    }
}

/// Writes the color of a fragment into one sample of a target.
fn write(sample: &mut [f64], fragment: impl Fn(usize) -> f64, target: &PassTarget) {
    match target {
        // Straight color is blended over premultiplied.
        PassTarget::Picture(_) | PassTarget::Layered(..) => {
            for (channel, number) in sample.iter_mut().enumerate() {
                let alpha = fragment(channel / 4 * 4 + 3);
                let factor = if channel % 4 == 3 { 1.0 } else { alpha };
                *number = fragment(channel) * factor + *number * (1.0 - alpha);
            }
        }
        PassTarget::Numbers(_) => {
            sample.iter_mut().enumerate().for_each(|(channel, number)| *number = fragment(channel));
        }
    }
}
