//! Execution of a frame plan: its passes in order.

use std::collections::BTreeMap;

use chiaro_locale::tr;

use super::fullscreen::shade_all;
use super::geometry::Triangles;
use super::options::{ImageRounding, ReferenceOptions};
use super::picture::ReferencePicture;
use super::raster::{Raster, check_size, rasterize};
use super::setup::Sides;
use super::shader::Shader;
use super::texels::Texels;
use super::tile::PassTarget;
use crate::diag::Diagnostic;
use crate::frame::{Draw, FramePlan, PassId, PassImage, ShadowMaps, Stage, TexelFormat};
use crate::progress::Progress;

/// Factory of the shaders for a frame plan.
pub trait ShaderFactory {
    /// The shader of a draw in a pass that draws meshes: the draw's [module](Draw::module) of the
    /// pass's stage, which may read the images of earlier passes.
    ///
    /// # Errors
    /// Modules that cannot be run.
    fn draw<'a>(
        &'a self,
        plan: &'a FramePlan,
        draw: &'a Draw,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic>;

    /// The shader of a pass over the whole picture, which reads the images that the pass's row
    /// lists.
    ///
    /// # Errors
    /// Modules that cannot be run, and `reference-plan` if the pass comes before a pass that it
    /// reads.
    fn screen<'a>(
        &'a self,
        plan: &'a FramePlan,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic>;

    /// The shaders of the objects that a light sees in a layer of a pass that draws what lights
    /// see, in the order of the layer's casters.
    ///
    /// # Errors
    /// As [`screen`](Self::screen).
    fn layer<'a>(
        &'a self,
        maps: &'a ShadowMaps,
        pass: PassId,
        layer: usize,
        images: &'a PassImages,
    ) -> Result<Vec<Box<dyn Shader + 'a>>, Diagnostic>;
}

/// Images of the passes so far, for later ones to read, rounded as [`ReferenceOptions::images`]
/// says. Each image has as many channels as its format.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PassImages(BTreeMap<PassImage, Texels>);

impl PassImages {
    /// An image of a pass, if the pass ran.
    pub fn get(&self, image: PassImage) -> Option<&Texels> {
        self.0.get(&image)
    }

    /// The first image of a pass, which is the one that looks read.
    pub fn first(&self, pass: PassId) -> Option<&Texels> {
        self.get(PassImage { pass, output: 0 })
    }

    /// Inserts the images of a pass; `made` has the channels of all outputs side by side.
    pub fn insert(&mut self, pass: PassId, made: &Texels) {
        let mut first = 0;
        for image in PassImage::written(pass) {
            let channels = pass.row().writes[image.output].format.channels();
            self.0.insert(image, made.channels(first..first + channels));
            first += channels;
        }
    }

    /// Inserts the images of a pass, rounded: surfaces of mesh passes may be held as halves.
    fn insert_rounded(&mut self, pass: PassId, made: &Texels, rounding: ImageRounding) {
        self.insert(pass, made);
        for image in PassImage::written(pass) {
            let format = pass.row().writes[image.output].format;
            let is_half = pass.stage().is_some() && format == TexelFormat::Numbers;
            if let Some(texels) = self.0.remove(&image) {
                let rounded =
                    texels.rounded(|x| if is_half { rounding.half(x) } else { rounding.single(x) });
                self.0.insert(image, rounded);
            }
        }
    }
}

/// Number of channels a pixel that a pass writes, over all outputs.
fn channels(pass: PassId) -> usize {
    pass.row().writes.iter().map(|output| output.format.channels()).sum()
}

/// Draws the picture of `plan`.
///
/// # Errors
/// As [`rasterize`], and `reference-plan` if a pass comes before a pass that it reads, or if no
/// pass draws the picture.
pub fn execute(
    plan: &FramePlan,
    shaders: &dyn ShaderFactory,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<ReferencePicture, Diagnostic> {
    check_size(plan.size, plan.samples)?;
    execute_layered(plan, shaders, options, progress).map(|(picture, _)| picture)
}

/// Draws the picture of `plan`, and the plan's layers, premultiplied with four channels each.
///
/// # Errors
/// As [`execute`].
pub fn execute_layered(
    plan: &FramePlan,
    shaders: &dyn ShaderFactory,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<(ReferencePicture, Vec<Texels>), Diagnostic> {
    check_size(plan.size, plan.samples)?;
    let mut layers = Vec::new();
    let mut images = PassImages::default();
    let picture = run(plan, (&mut images, &mut layers), shaders, options, progress)?;
    let missing =
        || Diagnostic::error("reference-plan", tr!("the plan has no pass that makes the picture"));
    Ok((picture.ok_or_else(missing)?, layers))
}

/// The picture of a raster, whose layers are added to `layers`.
fn parted(raster: Raster, layers: &mut Vec<Texels>) -> Raster {
    let all = &raster.texels;
    let part = |number: usize| all.channels(4 * number..4 * number + 4);
    layers.extend((1..all.channels / 4).map(part));
    Raster { texels: part(0), ..raster }
}

/// Runs the passes of `plan`, and adds what they make for later passes to `images`, and the plan's
/// layers to `layers`. Returns the picture, if a pass draws it.
fn run(
    plan: &FramePlan,
    (images, layers): (&mut PassImages, &mut Vec<Texels>),
    shaders: &dyn ShaderFactory,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Option<ReferencePicture>, Diagnostic> {
    let mut picture = None;
    progress.begin(plan.passes.len() as u64);
    for pass in &plan.passes {
        let progress = progress.part(1);
        let id = pass.id;
        // Later passes also read this pass's pixels around the wanted ones.
        let around = options.widened(plan.margin(id));
        let made = match id.stage() {
            Some(stage) if id.writes_picture() => {
                let raster = draw(plan, (id, stage), images, shaders, options, &progress)?;
                let raster = if plan.aovs.is_empty() { raster } else { parted(raster, layers) };
                let objects = plan.draws.iter().map(|draw| draw.object.clone()).collect();
                let mut drawn = ReferencePicture::new(raster, plan.samples, objects);
                let over = plan.passes.iter().filter(|pass| pass.id.is_over());
                for lines in over.filter_map(|pass| images.first(pass.id)) {
                    drawn.lay_over(lines);
                }
                picture = Some(drawn);
                continue;
            }
            Some(stage) => draw(plan, (id, stage), images, shaders, &around, &progress)?.texels,
            None if id.is_of_lights() => {
                draw_lights(plan, id, images, shaders, options, &progress)?
            }
            None => {
                let shader = shaders.screen(plan, id, images)?;
                shade_all(plan.size, channels(id), shader.as_ref(), &around, &progress)?
            }
        };
        images.insert_rounded(id, &made, options.images);
    }
    Ok(picture)
}

/// Runs the passes of a [plan of screens](FramePlan::of_screens), and adds their results to
/// `images`, which hold what the plan is [missing](FramePlan::missing).
///
/// # Errors
/// As [`execute`].
pub fn execute_screens(
    plan: &FramePlan,
    images: &mut PassImages,
    shaders: &dyn ShaderFactory,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<(), Diagnostic> {
    run(plan, (images, &mut Vec::new()), shaders, options, progress).map(drop)
}

/// Draws what lights see: layers one below the other.
fn draw_lights(
    plan: &FramePlan,
    pass: PassId,
    images: &PassImages,
    shaders: &dyn ShaderFactory,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Texels, Diagnostic> {
    let Some(maps) = &plan.shadow_maps else { return Ok(Texels::new([1, 1], channels(pass))) };
    // All of a layer is drawn, whichever pixels of the picture are wanted.
    let options = ReferenceOptions { region: None, ..*options };
    let size = [maps.side, maps.side];
    if maps.layers.is_empty() {
        return Ok(Texels::new([1, 1], channels(pass)));
    }
    let mut made = Texels::new([maps.side, 0], channels(pass));
    progress.begin(maps.layers.len() as u64);
    for (number, layer) in maps.layers.iter().enumerate() {
        let shaders = shaders.layer(maps, pass, number, images)?;
        let triangles = layer.casters.iter().zip(&shaders).map(|(caster, shader)| Triangles {
            indices: &maps.casters[*caster].mesh.indices,
            shader: shader.as_ref(),
            sides: Sides { both: true, is_mirrored: false },
        });
        let triangles: Vec<_> = triangles.collect();
        let target = PassTarget::Numbers(channels(pass));
        let progress = progress.part(1);
        let layer = rasterize(size, 1, &target, &triangles, &options, &progress)?;
        made.values.extend(layer.texels.values);
        made.size[1] += maps.side;
    }
    Ok(made)
}

/// Draws one pass of meshes.
fn draw(
    plan: &FramePlan,
    (pass, stage): (PassId, Stage),
    images: &PassImages,
    shaders: &dyn ShaderFactory,
    options: &ReferenceOptions,
    progress: &Progress,
) -> Result<Raster, Diagnostic> {
    let made = |draw| shaders.draw(plan, draw, pass, images);
    // A draw without a module for the stage leaves a gap, so that draws keep their indices.
    let wanted = |draw: &&Draw| draw.module(stage).is_some();
    let drawn: Vec<&Draw> = plan.draws.iter().filter(wanted).collect();
    let made = drawn.iter().map(|draw| made(draw)).collect::<Result<Vec<_>, _>>()?;
    let triangles = drawn.iter().zip(&made).map(|(draw, shader)| {
        let indices = draw.mesh.indices.get(draw.indices.start as usize..draw.indices.end as usize);
        let sides = Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored };
        Triangles { indices: indices.unwrap_or_default(), shader: shader.as_ref(), sides }
    });
    let triangles: Vec<_> = triangles.collect();
    let (target, samples) = if pass.writes_picture() {
        let [r, g, b, a] = plan.backdrop.unwrap_or([0.0; 4]);
        let background = [r * a, g * a, b * a, a];
        let target = match plan.aovs.len() {
            0 => PassTarget::Picture(background),
            layers => PassTarget::Layered(background, layers),
        };
        (target, plan.samples)
    } else {
        (PassTarget::Numbers(channels(pass)), 1)
    };
    rasterize(plan.size, samples, &target, &triangles, options, progress)
}
