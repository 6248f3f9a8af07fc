//! Runs the passes of a frame plan in order.

use std::collections::BTreeMap;

use super::fullscreen::shade_all;
use super::geometry::Triangles;
use super::options::{ImageRounding, Options};
use super::picture::ReferencePicture;
use super::raster::{check_size, rasterise};
use super::setup::Sides;
use super::shader::Shader;
use super::texels::Texels;
use super::tile::Target;
use crate::diag::Diagnostic;
use crate::frame::{Draw, FramePlan, PassId, PassImage, Stage, TexelFormat};
use crate::progress::Progress;

/// Makes the shaders of a frame plan.
pub trait Shaders {
    /// The shader of a draw in a pass that draws meshes: with the draw's [module](Draw::module) of
    /// the pass's stage, which may read what earlier passes made.
    ///
    /// # Errors
    /// What cannot be run.
    fn draw<'a>(
        &'a self,
        plan: &'a FramePlan,
        draw: &'a Draw,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic>;

    /// The shader of a pass over the whole picture, reading what its row says.
    ///
    /// # Errors
    /// What cannot be run, and `reference-plan` where the pass comes before what it reads.
    fn screen<'a>(
        &'a self,
        plan: &'a FramePlan,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic>;
}

/// What the passes so far have made, for the later ones to read, rounded as [`Options::images`]
/// says. Each has as many channels as its format.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PassImages(BTreeMap<PassImage, Texels>);

impl PassImages {
    /// A result of a pass, if the pass ran.
    pub fn get(&self, image: PassImage) -> Option<&Texels> {
        self.0.get(&image)
    }

    /// The first result of a pass, which is what looks read.
    pub fn first(&self, pass: PassId) -> Option<&Texels> {
        self.get(PassImage { pass, output: 0 })
    }

    /// Takes what a pass made: the channels of all its outputs side by side.
    pub fn insert(&mut self, pass: PassId, made: &Texels) {
        let mut first = 0;
        for image in PassImage::written(pass) {
            let channels = pass.row().writes[image.output].format.channels();
            self.0.insert(image, made.channels(first..first + channels));
            first += channels;
        }
    }

    /// What a pass made, rounded: normals that meshes are drawn with may be held as halves.
    fn insert_rounded(&mut self, pass: PassId, made: &Texels, rounding: ImageRounding) {
        self.insert(pass, made);
        for image in PassImage::written(pass) {
            let format = pass.row().writes[image.output].format;
            let is_half = !pass.is_screen() && format == TexelFormat::Numbers;
            if let Some(texels) = self.0.remove(&image) {
                let rounded =
                    texels.rounded(|x| if is_half { rounding.half(x) } else { rounding.single(x) });
                self.0.insert(image, rounded);
            }
        }
    }
}

/// How many numbers a pixel a pass makes.
fn channels(pass: PassId) -> usize {
    pass.row().writes.iter().map(|output| output.format.channels()).sum()
}

/// Makes the picture of `plan`.
///
/// # Errors
/// As [`rasterise`], and `reference-plan` where a pass comes before what it reads, or nothing makes
/// the picture.
pub fn execute(
    plan: &FramePlan,
    shaders: &dyn Shaders,
    options: &Options,
    progress: &Progress,
) -> Result<ReferencePicture, Diagnostic> {
    check_size(plan.size, plan.samples)?;
    let mut images = PassImages::default();
    let mut picture = None;
    progress.begin(plan.passes.len() as u64);
    for pass in &plan.passes {
        let progress = progress.part(1);
        let id = pass.id;
        let around = options.widened(plan.margin(id));
        let made = match id.stage() {
            Some(Stage::Draw) => {
                let raster = draw(plan, (id, Stage::Draw), &images, shaders, options, &progress)?;
                let objects = plan.draws.iter().map(|draw| draw.object.clone()).collect();
                picture = Some(ReferencePicture::new(raster, plan.samples, objects));
                continue;
            }
            Some(stage) => draw(plan, (id, stage), &images, shaders, &around, &progress)?.texels,
            None => {
                let shader = shaders.screen(plan, id, &images)?;
                shade_all(plan.size, channels(id), shader.as_ref(), &around, &progress)?
            }
        };
        images.insert_rounded(id, &made, options.images);
    }
    picture.ok_or_else(|| {
        Diagnostic::error("reference-plan", "the plan has no pass that makes the picture")
    })
}

/// One pass that draws meshes.
fn draw(
    plan: &FramePlan,
    (pass, stage): (PassId, Stage),
    images: &PassImages,
    shaders: &dyn Shaders,
    options: &Options,
    progress: &Progress,
) -> Result<super::raster::Raster, Diagnostic> {
    let made = |draw| shaders.draw(plan, draw, pass, images);
    // A draw without a module of the stage leaves an empty place, so that draws keep their numbers.
    let wanted = |draw: &&Draw| draw.module(stage).is_some();
    let drawn: Vec<&Draw> = plan.draws.iter().filter(wanted).collect();
    let made = drawn.iter().map(|draw| made(draw)).collect::<Result<Vec<_>, _>>()?;
    let triangles = drawn.iter().zip(&made).map(|(draw, shader)| {
        let indices = draw.mesh.indices.get(draw.indices.start as usize..draw.indices.end as usize);
        let sides = Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored };
        Triangles { indices: indices.unwrap_or_default(), shader: shader.as_ref(), sides }
    });
    let triangles: Vec<_> = triangles.collect();
    let (target, samples) = if stage == Stage::Draw {
        let [r, g, b, a] = plan.backdrop.unwrap_or([0.0; 4]);
        (Target::Picture([r * a, g * a, b * a, a]), plan.samples)
    } else {
        (Target::Numbers(channels(pass)), 1)
    };
    rasterise(plan.size, samples, &target, &triangles, options, progress)
}
