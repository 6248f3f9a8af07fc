//! Shaders for tests of the rasterizer: given vertices, and a closure for the fragments.

use chiaro::diag::Diagnostic;
use chiaro::progress::Progress;
use chiaro::reference::{
    FragmentStage, PassTarget, QuadBatch, Raster, ReferenceOptions, Shader, ShaderOutputs, Sides,
    Triangles, Varying, VaryingInterpolation, VertexStage, rasterize,
};

use crate::support::random::Random;

/// Output of a fragment in a lane of a batch; `None` discards the fragment.
pub(crate) type Fragment<'a> = Box<dyn Fn(&QuadBatch, usize) -> Option<Vec<f64>> + Sync + 'a>;

/// A shader of vertices in clip space with varyings, and a closure for the fragments.
pub(crate) struct Plain<'a> {
    pub(crate) clip: Vec<[f64; 4]>,
    pub(crate) varyings: Vec<Varying>,
    /// Numbers of all varyings, for each vertex.
    pub(crate) numbers: Vec<Vec<f64>>,
    pub(crate) fragment: Fragment<'a>,
}

impl<'a> Plain<'a> {
    /// A shader without varyings.
    pub(crate) fn new(
        clip: Vec<[f64; 4]>,
        fragment: impl Fn(&QuadBatch, usize) -> Option<Vec<f64>> + Sync + 'a,
    ) -> Self {
        let numbers = vec![Vec::new(); clip.len()];
        Self { clip, varyings: Vec::new(), numbers, fragment: Box::new(fragment) }
    }

    /// The shader with `numbers` for each vertex, in one varying.
    pub(crate) fn with(
        mut self,
        interpolation: VaryingInterpolation,
        numbers: Vec<Vec<f64>>,
    ) -> Self {
        self.varyings = vec![Varying { components: numbers[0].len(), interpolation }];
        self.numbers = numbers;
        self
    }
}

impl Shader for Plain<'_> {
    fn varyings(&self) -> &[Varying] {
        &self.varyings
    }

    fn vertices(&self) -> Box<dyn VertexStage + '_> {
        Box::new(Vertices(self))
    }

    fn fragments(&self) -> Box<dyn FragmentStage + '_> {
        Box::new(Fragments(self))
    }
}

struct Vertices<'a>(&'a Plain<'a>);

impl VertexStage for Vertices<'_> {
    fn shade(&mut self, vertices: &[u32], out: &mut [f64]) -> Result<(), Diagnostic> {
        let stride = out.len() / vertices.len();
        for (vertex, out) in vertices.iter().zip(out.chunks_exact_mut(stride)) {
            let index = *vertex as usize;
            out[..4].copy_from_slice(&self.0.clip[index]);
            out[4..].copy_from_slice(&self.0.numbers[index]);
        }
        Ok(())
    }
}

struct Fragments<'a>(&'a Plain<'a>);

impl FragmentStage for Fragments<'_> {
    fn shade(&mut self, batch: &QuadBatch, out: &mut ShaderOutputs) -> Result<(), Diagnostic> {
        for lane in 0..batch.lanes() {
            match (self.0.fragment)(batch, lane) {
                Some(numbers) => {
                    numbers
                        .iter()
                        .enumerate()
                        .for_each(|(channel, number)| out.channel_mut(channel)[lane] = *number);
                }
                None => out.discarded |= 1 << lane,
            }
        }
        Ok(())
    }
}

/// Both sides of triangles are drawn.
pub(crate) const BOTH: Sides = Sides { both: true, is_mirrored: false };
/// A picture that begins transparent.
pub(crate) const CLEAR: PassTarget = PassTarget::Picture([0.0; 4]);

/// Draws triangles with one shader.
pub(crate) fn draw(
    size: [u32; 2],
    samples: u32,
    target: &PassTarget,
    indices: &[u32],
    shader: &Plain<'_>,
    options: &ReferenceOptions,
) -> Raster {
    draw_all(size, samples, target, &[(indices, shader)], options)
}

/// Draws triangles with several shaders, one after the other.
pub(crate) fn draw_all(
    size: [u32; 2],
    samples: u32,
    target: &PassTarget,
    draws: &[(&[u32], &Plain<'_>)],
    options: &ReferenceOptions,
) -> Raster {
    let triangles: Vec<_> = draws
        .iter()
        .map(|(indices, shader)| Triangles { indices, shader: *shader, sides: BOTH })
        .collect();
    rasterize(size, samples, target, &triangles, options, &Progress::new())
        .expect("it fits, and nothing fails")
}

/// Clip space (w = 1) of a point of the screen. In pixels from the upper left.
pub(crate) fn at_pixel(size: [u32; 2], [x, y]: [f64; 2], depth: f64) -> [f64; 4] {
    [2.0 * x / f64::from(size[0]) - 1.0, 1.0 - 2.0 * y / f64::from(size[1]), depth, 1.0]
}

/// The indices 0, 1, 2, ...
pub(crate) fn in_order(count: usize) -> Vec<u32> {
    (0..count as u32).collect()
}

/// A random point in the picture or a little beyond it, in pixels.
pub(crate) fn somewhere(random: &mut Random, size: [u32; 2]) -> [f64; 2] {
    size.map(|side| random.between(-0.2, 1.2) * f64::from(side))
}
