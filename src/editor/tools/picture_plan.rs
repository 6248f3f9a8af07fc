//! Planner of the look as the window shows it, for every thread that draws the open picture.

use std::sync::Arc;

use crate::compile::CompiledShader;
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::Look;
use crate::frame::{CullMode, FramePlan, PlanOptions, Planner};
use crate::library::Library;
use crate::state::session::DrawableLook;
use crate::state::snapshot::RenderSnapshot;

/// Number of samples of a pixel, along with the viewport's.
pub(crate) const SAMPLES: u32 = 4;

/// Planner of shown looks. It keeps the shader that the window has compiled.
pub(crate) struct PicturePlanner {
    planner: Planner,
    /// Shader that the planner was given last, with its look.
    provided: Option<(Arc<CompiledShader>, Arc<Look>)>,
    /// Library that the planner compiled with.
    library: Option<Arc<Library>>,
}

impl Default for PicturePlanner {
    fn default() -> Self {
        // Only whole objects are culled: lights are edited, and a look must not be compiled anew
        // when one goes out.
        let planner = Planner::default().culling(CullMode::Objects);
        Self { planner, provided: None, library: None }
    }
}

impl PicturePlanner {
    /// Plan of a picture of `size` pixels, with warnings about the scene and the plan.
    ///
    /// # Errors
    /// Problems of the scene, its meshes and its looks.
    pub(crate) fn plan(
        &mut self,
        showing: &DrawableLook,
        snapshot: &RenderSnapshot,
        size: [u32; 2],
    ) -> Result<WithWarnings<FramePlan>, Vec<Diagnostic>> {
        let is_same = |library: &Arc<Library>| Arc::ptr_eq(library, &snapshot.library);
        if !self.library.as_ref().is_some_and(is_same) {
            self.planner =
                Planner::new(std::mem::take(&mut self.planner.assets)).culling(CullMode::Objects);
            (self.library, self.provided) = (Some(snapshot.library.clone()), None);
        }
        let (mut setup, of_setup) = snapshot.setup(&mut self.planner.assets)?.into_parts();
        setup.edited = Some(0);
        if !self.provided.as_ref().is_some_and(|(shader, look)| {
            Arc::ptr_eq(shader, &showing.shader) && same_keys(look, &showing.look)
        }) {
            self.planner.provide(&showing.look, &showing.live, showing.shader.clone());
            self.provided = Some((showing.shader.clone(), showing.look.clone()));
        }
        let options = PlanOptions { size, samples: SAMPLES, time: snapshot.time };
        let planned = self.planner.plan(&setup, &snapshot.library, &showing.live, &options)?;
        let (plan, mut warnings) = planned.into_parts();
        warnings.extend(of_setup);
        Ok(WithWarnings::new(plan, warnings))
    }
}

/// True if a planner that knows the keys of one look knows those of the other.
fn same_keys(a: &Look, b: &Look) -> bool {
    (&a.direction_keys, &a.time_keys, &a.exposed) == (&b.direction_keys, &b.time_keys, &b.exposed)
}
