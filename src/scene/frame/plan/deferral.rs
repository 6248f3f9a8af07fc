//! Choice of how looks are drawn: triangle by triangle, or deferred over the picture.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

use chiaro_locale::tr;

use super::omissions::quoted;
use super::placement::{PlacedScene, VisibleObject};
use super::{Draw, FramePlan, Pass};
use crate::compile::CompiledShader;
use crate::frame::deferred::{Deferral, DeferredDraw, DeferredLook, saved_operations};
use crate::library::PassId;

/// Most draws of a plan that are drawn deferred: each goes over all pixels of its own area.
const MOST_DRAWS: usize = 64;

/// Mark of passes whose results depend on the way in which looks are drawn.
const DEFERRED: u64 = 0x64_6566_6572;

/// A look's modules with what they were made from.
#[derive(Debug)]
struct KnownLook {
    look: Weak<CompiledShader>,
    surface: Weak<CompiledShader>,
    made: Result<Arc<DeferredLook>, &'static str>,
}

/// Modules of looks that are drawn deferred, made when first asked for.
#[derive(Debug, Default)]
pub(super) struct DeferredLooks(HashMap<[usize; 2], KnownLook>);

impl DeferredLooks {
    fn get(
        &mut self,
        look: &Arc<CompiledShader>,
        surface: &Arc<CompiledShader>,
    ) -> Result<Arc<DeferredLook>, &'static str> {
        self.0.retain(|_, known| known.look.strong_count() * known.surface.strong_count() > 0);
        let key = [look, surface].map(|shader| Arc::as_ptr(shader) as usize);
        let known = self.0.entry(key).or_insert_with(|| KnownLook {
            look: Arc::downgrade(look),
            surface: Arc::downgrade(surface),
            made: DeferredLook::new(look, surface).map(Arc::new),
        });
        known.made.clone()
    }

    /// The deferred drawing of `draws`.
    ///
    /// # Errors
    /// The reason why they are drawn triangle by triangle: the end of a sentence. It is empty where
    /// nothing is drawn that they could be drawn over.
    pub(super) fn deferral(
        &mut self,
        scene: &PlacedScene<'_>,
        visible: &[VisibleObject<'_>],
        passes: &[Pass],
        draws: &[Draw],
    ) -> Result<Deferral, String> {
        let is_surface = |pass: &PassId| pass.stage().is_some() && !pass.writes_picture();
        let Some(surface) = passes.iter().map(|pass| pass.id).find(is_surface) else {
            return Err(String::new());
        };
        let Some(stage) = surface.stage() else { return Err(String::new()) };
        if draws.iter().any(|draw| !draw.look.aovs.is_empty()) {
            return Err(tr!("layers are written beside the picture").to_owned());
        }
        let samples = scene.options.samples;
        if samples != 1 {
            return Err(tr!("a pixel has {samples} samples"));
        }
        if draws.len() > MOST_DRAWS {
            return Err(tr!("more than {MOST_DRAWS} parts are drawn"));
        }
        let areas: HashMap<_, _> =
            visible.iter().map(|visible| (&visible.object.id, scene.area(visible))).collect();
        let area = |draw: &Draw| areas.get(&draw.object).copied().unwrap_or_else(|| scene.whole());
        let (mut pixels, mut triangles, mut saved) = (0.0, 0.0, 0.0);
        let mut first: u64 = 1;
        let mut deferred = Vec::with_capacity(draws.len());
        for draw in draws {
            let missing = || tr!("no module draws its surface");
            let look = draw.module(stage).ok_or_else(missing);
            let look = look.and_then(|surface| self.get(&draw.look, surface));
            let look = look.map_err(|why| {
                tr!("needed by {look}, because {why}", look = quoted(&draw.look_name))
            })?;
            // About half of the box around an object is the object.
            let own = (0.5 * area(draw).count() as f64, draw.indices.len() as f64 / 3.0);
            saved += saved_operations(look.operations, own.0, own.1);
            (pixels, triangles) = (pixels + own.0, triangles + own.1);
            let begin =
                u32::try_from(first).map_err(|_| tr!("the scene has too many triangles"))?;
            deferred.push(DeferredDraw {
                shader: draw.look.clone(),
                look,
                area: area(draw),
                first: begin,
                triangles: draw.indices.start / 3..draw.indices.end / 3,
                two_sided: draw.two_sided,
                is_mirrored: draw.is_mirrored,
            });
            first += draw.mesh.indices.len() as u64 / 3;
        }
        u32::try_from(first).map_err(|_| tr!("the scene has too many triangles"))?;
        if saved <= 0.0 {
            let share = pixels / f64::max(triangles, 1.0);
            return Err(tr!("a triangle fills about {share:.0} pixels, so that it is quicker"));
        }
        Ok(Deferral { surface, draws: deferred })
    }
}

/// Tells the passes how looks are drawn, and why.
pub(super) fn tell(passes: &mut [Pass], deferral: &Result<Deferral, String>) {
    let told = match deferral {
        Ok(deferral) => {
            let over = deferral.surface.label();
            mark(passes, deferral.surface);
            tr!(", shaded once a pixel over what the {over} pass shows")
        }
        Err(why) if why.is_empty() => String::new(),
        Err(why) => tr!(", drawn triangle by triangle: {why}"),
    };
    if let Some(pass) = passes.iter_mut().find(|pass| pass.id.writes_picture()) {
        pass.reason += &told;
    }
}

/// Marks the results that depend on deferred drawing, or takes the mark back.
fn mark(passes: &mut [Pass], surface: PassId) {
    let depends = |pass: &&mut Pass| pass.id == surface || pass.id.writes_picture();
    passes.iter_mut().filter(depends).for_each(|pass| pass.input_hash ^= DEFERRED);
}

impl FramePlan {
    /// The plan with its looks drawn triangle by triangle, for comparisons.
    #[must_use]
    pub fn forward(&self) -> Self {
        let mut plan = self.clone();
        if let Ok(deferral) = &self.deferral {
            mark(&mut plan.passes, deferral.surface);
            plan.deferral = Err(tr!("it is compared").to_owned());
        }
        plan
    }
}
