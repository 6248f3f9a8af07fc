//! Shader traits of the rasterizer: vertices are shaded one list at a time, fragments sixteen quads
//! at a time.
//!
//! The rasterizer knows no WGSL. A stage gives each thread a worker, which may keep memory of its
//! own.

use crate::diag::Diagnostic;

/// Number of quads in a batch.
pub const QUADS: usize = 16;
/// Number of fragments in a batch: lane `4 * quad + 2 * y + x`, with `y` down.
pub const LANES: usize = 4 * QUADS;

/// Interpolation of a varying from the corners of a triangle to its pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum VaryingInterpolation {
    /// Linear on the surface, and so perspective-correct on the screen.
    #[default]
    Perspective,
    /// Value of the first corner everywhere.
    Flat,
}

/// An output of a vertex stage that is an input of the fragment stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Varying {
    /// Number of components: 1 to 4.
    pub components: usize,
    /// Interpolation of the components.
    pub interpolation: VaryingInterpolation,
}

/// The shader of one draw.
pub trait Shader: Sync {
    /// The varyings, in the order of their locations.
    fn varyings(&self) -> &[Varying];

    /// A worker of the vertex stage, for one thread.
    fn vertices(&self) -> Box<dyn VertexStage + '_>;

    /// A worker of the fragment stage, for one thread.
    fn fragments(&self) -> Box<dyn FragmentStage + '_>;
}

/// Worker that runs vertex shaders.
pub trait VertexStage {
    /// Shades the vertices with these indices. `out` has, for each vertex, the clip position `x y z
    /// w` and then all components of the varyings.
    ///
    /// # Errors
    /// Shaders that do not end.
    fn shade(&mut self, vertices: &[u32], out: &mut [f64]) -> Result<(), Diagnostic>;
}

/// Worker that runs fragment shaders.
pub trait FragmentStage {
    /// Shades all lanes of `batch`, helpers included, as derivatives need them.
    ///
    /// # Errors
    /// Shaders that do not end.
    fn shade(&mut self, batch: &QuadBatch, out: &mut ShaderOutputs) -> Result<(), Diagnostic>;
}

/// Up to [`QUADS`] quads of 2x2 fragments of one draw, component by component.
#[derive(Clone, Debug)]
pub struct QuadBatch {
    quads: usize,
    live: u64,
    front: u64,
    /// [`LANES`] numbers for each component.
    position: Vec<f64>,
    varyings: Vec<f64>,
}

impl QuadBatch {
    /// An empty batch for `components` numbers in all varyings.
    pub(super) fn new(components: usize) -> Self {
        Self {
            quads: 0,
            live: 0,
            front: 0,
            position: vec![0.0; 4 * LANES],
            varyings: vec![0.0; components * LANES],
        }
    }

    /// Number of lanes that are filled: a multiple of 4, from lane 0.
    pub fn lanes(&self) -> usize {
        4 * self.quads
    }

    /// Lanes whose color counts, by bit; the other lanes exist for the derivatives.
    pub fn live(&self) -> u64 {
        self.live
    }

    /// Lanes of front faces, by bit.
    pub fn front(&self) -> u64 {
        self.front
    }

    /// `@builtin(position)` of all lanes: x and y of the pixel's middle, from the upper left, in
    /// pixels; depth; 1/w.
    pub fn position(&self, component: usize) -> &[f64] {
        &self.position[component * LANES..][..LANES]
    }

    /// A component of the varyings, counted over all of them, of all lanes.
    pub fn varying(&self, component: usize) -> &[f64] {
        &self.varyings[component * LANES..][..LANES]
    }

    pub(super) fn is_full(&self) -> bool {
        self.quads == QUADS
    }

    pub(super) fn clear(&mut self) {
        (self.quads, self.live, self.front) = (0, 0, 0);
    }

    /// Begins the next quad, with four bits for the lanes that count. Returns its first lane.
    pub(super) fn begin(&mut self, live: u64, is_front: bool) -> usize {
        let lane = self.lanes();
        self.live |= live << lane;
        self.front |= if is_front { 0xF << lane } else { 0 };
        self.quads += 1;
        lane
    }

    pub(super) fn set_position(&mut self, lane: usize, position: [f64; 4]) {
        for (component, number) in position.into_iter().enumerate() {
            self.position[component * LANES + lane] = number;
        }
    }

    pub(super) fn set_varying(&mut self, component: usize, lane: usize, number: f64) {
        self.varyings[component * LANES + lane] = number;
    }
}

/// Outputs of the fragments of a batch.
#[derive(Clone, Debug)]
pub struct ShaderOutputs {
    channels: usize,
    values: Vec<f64>,
    /// Lanes that were discarded, by bit.
    pub discarded: u64,
}

impl ShaderOutputs {
    /// Outputs of `channels` numbers a fragment: those of the color targets, in the order of their
    /// locations.
    pub(super) fn new(channels: usize) -> Self {
        Self { channels, values: vec![0.0; channels * LANES], discarded: 0 }
    }

    /// Number of channels of a fragment.
    pub fn channels(&self) -> usize {
        self.channels
    }

    /// A channel of all lanes, to be filled in.
    pub fn channel_mut(&mut self, channel: usize) -> &mut [f64] {
        &mut self.values[channel * LANES..][..LANES]
    }

    pub(super) fn get(&self, channel: usize, lane: usize) -> f64 {
        self.values[channel * LANES + lane]
    }
}
