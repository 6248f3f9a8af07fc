//! Fragments of chosen pixels, kept so that a look can be shaded there again and again with other
//! values.
//!
//! The surface that a camera sees does not change with the numbers of a look, so a plan is drawn
//! once, with a recorder between the rasterizer and the look's own module. The recorder keeps the
//! inputs of the nearest fragment of each chosen pixel, together with its quad, so that derivatives
//! stay the same. From then on a change of values costs the fragment shader of these quads alone,
//! and gives exactly the colors that the whole picture would have there.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use super::executor::{PassImages, ShaderFactory, execute};
use super::modules::Modules;
use super::options::ReferenceOptions;
use super::shader::{
    FragmentStage, LANES, QUADS, QuadBatch, Shader, ShaderOutputs, Varying, VertexStage,
};
use super::texels::Coverage;
use crate::diag::Diagnostic;
use crate::frame::{Draw, FramePlan, PassId, ShadowMaps};
use crate::interp::{Bindings, Precision};
use crate::progress::Progress;

/// Inputs of a quad's fragments on one triangle.
#[derive(Clone, Debug, PartialEq)]
struct Quad {
    draw: usize,
    is_front: bool,
    position: [[f64; 4]; 4],
    /// Numbers of the four lanes, for each component.
    varyings: Vec<[f64; 4]>,
}

/// The nearest fragment of a pixel so far.
#[derive(Clone, Debug)]
struct NearestFragment {
    depth: f64,
    lane: usize,
    quad: Quad,
}

/// A pixel that was gathered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GatheredPixel {
    /// Column and row of the pixel.
    pub pixel: [u32; 2],
    /// Index of the draw on top, in the plan.
    pub draw: usize,
    quad: usize,
    lane: usize,
}

impl GatheredPixel {
    /// Index of the pixel's quad: pixels of one quad and one triangle have the same.
    pub fn quad(&self) -> usize {
        self.quad
    }
}

/// Fragments of chosen pixels, with everything that shading them needs.
#[derive(Debug)]
pub struct GatheredFragments {
    plan: FramePlan,
    modules: Modules,
    /// Bindings of each draw; `None` if no fragment of the draw was gathered.
    bindings: Vec<Option<Bindings>>,
    quads: Vec<Quad>,
    /// The gathered pixels by row and column; chosen pixels that nothing covers are not among them.
    pub seen: Vec<GatheredPixel>,
    /// Coverage of each pixel, rows from the top.
    pub coverage: Vec<Coverage>,
}

/// Some of the gathered pixels, in batches.
#[derive(Clone, Debug)]
pub struct PixelSheet {
    batches: Vec<SheetBatch>,
    count: usize,
}

#[derive(Clone, Debug)]
struct SheetBatch {
    draw: usize,
    batch: QuadBatch,
    /// Lane, and index among the sheet's pixels.
    wanted: Vec<(usize, usize)>,
}

impl PixelSheet {
    /// Number of pixels in the sheet.
    pub fn count(&self) -> usize {
        self.count
    }
}

impl GatheredFragments {
    /// Draws `plan` and keeps the fragments of the pixels that `is_chosen` accepts, by column and
    /// row.
    ///
    /// # Errors
    /// Modules that the interpreter cannot run, and the errors of [`execute`].
    pub fn new(
        plan: FramePlan,
        is_chosen: &(dyn Fn([u32; 2]) -> bool + Sync),
        options: &ReferenceOptions,
        progress: &Progress,
    ) -> Result<Self, Diagnostic> {
        let modules = Modules::new(&plan, Precision::F64)?;
        let none = vec![None; plan.draws.len()];
        let recorder = Recorder {
            modules: &modules,
            is_chosen,
            bindings: Mutex::new(none),
            nearest: Mutex::new(BTreeMap::new()),
        };
        let coverage = execute(&plan, &recorder, options, progress)?.coverage;
        let Recorder { bindings, nearest, .. } = recorder;
        let bindings = bindings.into_inner().unwrap_or_else(PoisonError::into_inner);
        let nearest = nearest.into_inner().unwrap_or_else(PoisonError::into_inner);
        let mut quads: Vec<Quad> = Vec::new();
        let mut places: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        let mut seen = Vec::with_capacity(nearest.len());
        for ([row, column], NearestFragment { lane, quad, .. }) in nearest {
            // Pixels of one quad and one triangle share the quad's inputs.
            let alike = places.entry([row / 2, column / 2]).or_default();
            let found = alike.iter().copied().find(|&index| quads[index] == quad);
            let draw = quad.draw;
            let index = found.unwrap_or_else(|| {
                quads.push(quad);
                alike.push(quads.len() - 1);
                quads.len() - 1
            });
            seen.push(GatheredPixel { pixel: [column, row], draw, quad: index, lane });
        }
        Ok(Self { plan, modules, bindings, quads, seen, coverage })
    }

    /// The plan that was drawn.
    pub fn plan(&self) -> &FramePlan {
        &self.plan
    }

    /// Some of the pixels, by their indices in [`seen`](Self::seen), ready to be shaded together.
    pub fn sheet(&self, chosen: &[usize]) -> PixelSheet {
        let mut by_quad: BTreeMap<(usize, usize), Vec<(usize, usize)>> = BTreeMap::new();
        for (place, &index) in chosen.iter().enumerate() {
            let GatheredPixel { draw, quad, lane, .. } = self.seen[index];
            by_quad.entry((draw, quad)).or_default().push((lane, place));
        }
        let mut batches: Vec<SheetBatch> = Vec::new();
        for ((draw, index), wanted) in by_quad {
            let quad = &self.quads[index];
            let has_room = batches
                .last()
                .is_some_and(|last| last.draw == draw && last.batch.lanes() < 4 * QUADS);
            if !has_room {
                let batch = QuadBatch::new(quad.varyings.len());
                batches.push(SheetBatch { draw, batch, wanted: Vec::new() });
            }
            let Some(last) = batches.last_mut() else { continue };
            let live = wanted.iter().fold(0, |live, (lane, _)| live | 1 << lane);
            let first = last.batch.begin(live, quad.is_front);
            for (lane, position) in quad.position.iter().enumerate() {
                last.batch.set_position(first + lane, *position);
            }
            for (component, numbers) in quad.varyings.iter().enumerate() {
                for (lane, number) in numbers.iter().enumerate() {
                    last.batch.set_varying(component, first + lane, *number);
                }
            }
            last.wanted.extend(wanted.into_iter().map(|(lane, place)| (first + lane, place)));
        }
        PixelSheet { batches, count: chosen.len() }
    }

    /// The colors of a sheet's pixels, straight RGBA, with `numbers` in the looks' uniforms: the
    /// numbers of all draws, by draw.
    ///
    /// # Errors
    /// Shaders that do not end.
    pub fn shade(
        &self,
        sheet: &PixelSheet,
        numbers: &[Vec<f64>],
    ) -> Result<Vec<[f64; 4]>, Diagnostic> {
        let mut colors = vec![[0.0; 4]; sheet.count];
        let mut shaded = ShaderOutputs::new(4);
        for batches in sheet.batches.chunk_by(|a, b| a.draw == b.draw) {
            let number = batches[0].draw;
            let (draw, Some(bindings)) = (&self.plan.draws[number], &self.bindings[number]) else {
                continue;
            };
            let own = numbers.get(number).map(Vec::as_slice).unwrap_or_default();
            let shader = self.modules.with_look(draw, bindings.clone(), own)?;
            let mut stage = shader.fragments();
            for SheetBatch { batch, wanted, .. } in batches {
                stage.shade(batch, &mut shaded)?;
                for &(lane, place) in wanted {
                    colors[place] = std::array::from_fn(|channel| shaded.get(channel, lane));
                }
            }
        }
        Ok(colors)
    }
}

/// Shaders of a plan that record the inputs of the looks' fragments.
struct Recorder<'m> {
    modules: &'m Modules,
    is_chosen: &'m (dyn Fn([u32; 2]) -> bool + Sync),
    bindings: Mutex<Vec<Option<Bindings>>>,
    /// The nearest fragment of each chosen pixel, by row and column.
    nearest: Mutex<BTreeMap<[u32; 2], NearestFragment>>,
}

impl ShaderFactory for Recorder<'_> {
    fn draw<'a>(
        &'a self,
        plan: &'a FramePlan,
        draw: &'a Draw,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        let inner = self.modules.draw(plan, draw, pass, images)?;
        let place = plan.draws.iter().position(|other| std::ptr::eq(other, draw));
        let Some(number) = place.filter(|_| pass.writes_picture()) else { return Ok(inner) };
        let bindings = self.modules.bindings_of(plan, draw, images)?;
        self.bindings.lock().unwrap_or_else(PoisonError::into_inner)[number] = Some(bindings);
        let discards = draw.look.wgsl.contains("discard");
        Ok(Box::new(RecordingShader { inner, number, discards, recorder: self }))
    }

    fn screen<'a>(
        &'a self,
        plan: &'a FramePlan,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        self.modules.screen(plan, pass, images)
    }

    fn layer<'a>(
        &'a self,
        maps: &'a ShadowMaps,
        pass: PassId,
        layer: usize,
        images: &'a PassImages,
    ) -> Result<Vec<Box<dyn Shader + 'a>>, Diagnostic> {
        self.modules.layer(maps, pass, layer, images)
    }
}

struct RecordingShader<'a> {
    inner: Box<dyn Shader + 'a>,
    number: usize,
    discards: bool,
    recorder: &'a Recorder<'a>,
}

impl Shader for RecordingShader<'_> {
    fn varyings(&self) -> &[Varying] {
        self.inner.varyings()
    }

    fn vertices(&self) -> Box<dyn VertexStage + '_> {
        self.inner.vertices()
    }

    fn fragments(&self) -> Box<dyn FragmentStage + '_> {
        let components = self.varyings().iter().map(|varying| varying.components).sum();
        let (number, recorder) = (self.number, self.recorder);
        // A fragment that the look discards does not hide what lies behind; a look that discards
        // none need not be run.
        let inner = self.discards.then(|| self.inner.fragments());
        Box::new(RecordedStage { inner, number, components, recorder })
    }
}

struct RecordedStage<'a> {
    inner: Option<Box<dyn FragmentStage + 'a>>,
    number: usize,
    components: usize,
    recorder: &'a Recorder<'a>,
}

impl FragmentStage for RecordedStage<'_> {
    fn shade(&mut self, batch: &QuadBatch, out: &mut ShaderOutputs) -> Result<(), Diagnostic> {
        if let Some(inner) = &mut self.inner {
            inner.shade(batch, out)?;
        }
        for lane in 0..batch.lanes().min(LANES) {
            let is_live = batch.live() & !out.discarded & (1 << lane) != 0;
            let pixel = [0, 1].map(|axis| batch.position(axis)[lane] as u32);
            if is_live && (self.recorder.is_chosen)(pixel) {
                self.keep(batch, lane, pixel);
            }
        }
        Ok(())
    }
}

impl RecordedStage<'_> {
    fn keep(&self, batch: &QuadBatch, lane: usize, [column, row]: [u32; 2]) {
        let depth = batch.position(2)[lane];
        let mut nearest = self.recorder.nearest.lock().unwrap_or_else(PoisonError::into_inner);
        // Depths of one pixel come from one tile, and so in the order of drawing; of equal ones the
        // first stays.
        if nearest.get(&[row, column]).is_some_and(|known| known.depth <= depth) {
            return;
        }
        let first = lane & !3;
        let of_lanes = |numbers: &[f64]| std::array::from_fn(|lane| numbers[first + lane]);
        let quad = Quad {
            draw: self.number,
            is_front: batch.front() >> lane & 1 == 1,
            position: std::array::from_fn(|lane| {
                std::array::from_fn(|axis| batch.position(axis)[first + lane])
            }),
            varyings: (0..self.components)
                .map(|component| of_lanes(batch.varying(component)))
                .collect(),
        };
        nearest.insert([row, column], NearestFragment { depth, lane: lane & 3, quad });
    }
}
