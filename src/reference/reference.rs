//! The reference as an executor of frame plans.

use super::executor::{execute, execute_layered};
use super::modules::Modules;
use super::options::ReferenceOptions;
use super::texels::Texels;
use crate::frame::{Executor, FramePlan, LayeredPicture, LayersFuture, PictureFuture};
use crate::interp::Precision;
use crate::progress::Progress;

/// The most layers of one plan: more would take more memory than another draw takes time.
const MOST_LAYERS: usize = 15;

/// Executor on the CPU, in f64; see [`execute`] for results beyond the picture.
#[derive(Clone, Debug, Default)]
pub struct Reference {
    /// Options of the pictures.
    pub options: ReferenceOptions,
}

impl Executor for Reference {
    fn name(&self) -> String {
        "the reference, in f64".to_owned()
    }

    fn picture<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> PictureFuture<'a> {
        Box::pin(async move {
            let modules = Modules::new(plan, Precision::F64)?;
            Ok(execute(plan, &modules, &self.options, progress)?.to_picture())
        })
    }

    fn layered<'a>(&'a mut self, plan: &'a FramePlan, progress: &'a Progress) -> LayersFuture<'a> {
        Box::pin(async move {
            let modules = Modules::new(plan, Precision::F64)?;
            let (picture, layers) = execute_layered(plan, &modules, &self.options, progress)?;
            let numbers = |texels: &Texels| {
                let pixels = texels.values.chunks_exact(4);
                pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]].map(|x| x as f32)).collect()
            };
            let layers = layers.iter().map(numbers).collect();
            Ok(LayeredPicture { picture: picture.to_picture(), layers })
        })
    }

    fn most_layers(&self) -> usize {
        MOST_LAYERS
    }
}
