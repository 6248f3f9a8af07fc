//! Runs the passes of a frame plan in order.

use super::fullscreen::shade_all;
use super::geometry::Triangles;
use super::options::Options;
use super::picture::ReferencePicture;
use super::raster::{check_size, rasterise};
use super::setup::Sides;
use super::shader::Shader;
use super::texels::Texels;
use super::tile::Target;
use crate::diag::Diagnostic;
use crate::frame::{Draw, FramePlan, PassKind};
use crate::library::SMOOTH_LEVELS;
use crate::progress::Progress;

/// Makes the shaders of a frame plan.
pub trait Shaders {
    /// The shader of a draw in a pass that draws meshes: [`PassKind::Normals`],
    /// [`PassKind::DetailNormals`] (with the module of [`Draw::normals`]) or [`PassKind::Look`]
    /// (with [`Draw::look`], which may read the curvature in `images`).
    ///
    /// # Errors
    /// What cannot be run.
    fn draw<'a>(
        &'a self,
        plan: &'a FramePlan,
        draw: &'a Draw,
        kind: &PassKind,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic>;

    /// The [shader](PassKind::shader) of a pass over normals, reading `normals` (four channels) and
    /// `depths` (one).
    ///
    /// # Errors
    /// What cannot be run.
    fn curvature<'a>(
        &'a self,
        plan: &'a FramePlan,
        kind: &PassKind,
        normals: &'a Texels,
        depths: &'a Texels,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic>;
}

/// What the passes so far have made of the surface, or of its detail normals.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceImages {
    /// Four channels: the normal in camera axes, and the object's number plus 1; 0 where nothing
    /// is.
    pub normals: Option<Texels>,
    /// One channel: the distance in front of the eye.
    pub depths: Option<Texels>,
    /// One channel: curvature in 1/viewport-height.
    pub curvature: Option<Texels>,
    /// The same from four neighbours of a pixel.
    pub sparse: Option<Texels>,
    /// Four channels: the curvature tensor in xx, xy and yy.
    pub tensor: Option<Texels>,
    /// Four channels each, as the normals have: these, ever smoother.
    pub smooth: [Option<Texels>; SMOOTH_LEVELS as usize],
}

/// What the passes so far have made, for the later ones to read, rounded as [`Options::images`]
/// says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PassImages {
    /// Of the surface.
    pub surface: SurfaceImages,
    /// Of the looks' detail normals.
    pub detail: SurfaceImages,
}

impl PassImages {
    /// The images of the kind that a normals or curvature pass makes.
    fn of(&mut self, kind: &PassKind) -> &mut SurfaceImages {
        match kind {
            PassKind::DetailNormals
            | PassKind::DetailCurvature
            | PassKind::SparseDetailCurvature => &mut self.detail,
            _ => &mut self.surface,
        }
    }
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
        match &pass.kind {
            kind @ (PassKind::Normals | PassKind::DetailNormals) => {
                let around = options.widened(plan.reach() as u32 + 2);
                let drawn = draw(plan, kind, &images, shaders, &around, &progress)?.texels;
                let made = images.of(kind);
                made.normals = Some(drawn.channels(0..4).rounded(|x| options.images.half(x)));
                made.depths = Some(drawn.channels(4..5).rounded(|x| options.images.single(x)));
            }
            kind @ (PassKind::Curvature
            | PassKind::SparseCurvature
            | PassKind::DetailCurvature
            | PassKind::SparseDetailCurvature
            | PassKind::CurvatureTensor
            | PassKind::SmoothNormals(_)) => {
                let made = images.of(kind);
                let normals = match kind {
                    PassKind::SmoothNormals(level @ 2..) => {
                        made.smooth.get(usize::from(*level) - 2)
                    }
                    _ => Some(&made.normals),
                };
                let (Some(Some(normals)), Some(depths)) = (normals, &made.depths) else {
                    return Err(misplaced(kind));
                };
                let shader = shaders.curvature(plan, kind, normals, depths)?;
                // The levels after a smoothed one look around in it.
                let around =
                    options.widened(if kind.channels() == 1 { 1 } else { plan.reach() as u32 + 1 });
                let found =
                    shade_all(plan.size, kind.channels(), shader.as_ref(), &around, &progress)?;
                drop(shader);
                let found = Some(found.rounded(|x| options.images.single(x)));
                match kind {
                    PassKind::SparseCurvature | PassKind::SparseDetailCurvature => {
                        made.sparse = found;
                    }
                    PassKind::CurvatureTensor => made.tensor = found,
                    PassKind::SmoothNormals(level) => {
                        if let Some(slot) = made.smooth.get_mut(usize::from(*level) - 1) {
                            *slot = found;
                        }
                    }
                    _ => made.curvature = found,
                }
            }
            PassKind::Look => {
                let raster = draw(plan, &PassKind::Look, &images, shaders, options, &progress)?;
                let objects = plan.draws.iter().map(|draw| draw.object.clone()).collect();
                picture = Some(ReferencePicture::new(raster, plan.samples, objects));
            }
        }
    }
    picture.ok_or_else(|| {
        Diagnostic::error("reference-plan", "the plan has no pass that makes the picture")
    })
}

#[cold]
fn misplaced(kind: &PassKind) -> Diagnostic {
    Diagnostic::error(
        "reference-plan",
        format!("the plan has {kind:?} before the normals that it reads"),
    )
}

/// One pass that draws meshes.
fn draw(
    plan: &FramePlan,
    kind: &PassKind,
    images: &PassImages,
    shaders: &dyn Shaders,
    options: &Options,
    progress: &Progress,
) -> Result<super::raster::Raster, Diagnostic> {
    let is_look = *kind == PassKind::Look;
    let made = |draw| shaders.draw(plan, draw, kind, images);
    // A draw without normals leaves an empty place, so that draws keep their numbers.
    let wanted = |draw: &&Draw| is_look || draw.normals.contains_key(kind);
    let drawn: Vec<&Draw> = plan.draws.iter().filter(wanted).collect();
    let made = drawn.iter().map(|draw| made(draw)).collect::<Result<Vec<_>, _>>()?;
    let triangles = drawn.iter().zip(&made).map(|(draw, shader)| {
        let indices = draw.mesh.indices.get(draw.indices.start as usize..draw.indices.end as usize);
        let sides = Sides { both: draw.two_sided, is_mirrored: draw.is_mirrored };
        Triangles { indices: indices.unwrap_or_default(), shader: shader.as_ref(), sides }
    });
    let triangles: Vec<_> = triangles.collect();
    let (target, samples) = if is_look {
        let [r, g, b, a] = plan.backdrop.unwrap_or([0.0; 4]);
        (Target::Picture([r * a, g * a, b * a, a]), plan.samples)
    } else {
        // Normal, object number and depth.
        (Target::Numbers(5), 1)
    };
    rasterise(plan.size, samples, &target, &triangles, options, progress)
}
