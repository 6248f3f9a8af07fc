//! Arrival of a light at a point, as the node Light computes it: its own function is run in f64.

use glam::DVec3;

use crate::diag::Diagnostic;
use crate::document::LightValues;
use crate::interp::{Precision, Value};
use crate::library::{ArgumentSource, Fallback, Library};

/// A light where it arrives.
pub(super) struct Arrival {
    /// Unit direction toward the light, in world space.
    pub(super) toward: DVec3,
    /// The light's color, straight RGB.
    pub(super) color: DVec3,
    /// Factor on the color, after fading and cone.
    pub(super) intensity: f64,
}

impl Arrival {
    /// The light as it arrives at `position`, in world space; `None` where the node Light is not
    /// what it was when this was written.
    ///
    /// # Errors
    /// The faults of the node's function.
    pub(super) fn of(light: &LightValues, position: DVec3) -> Result<Option<Self>, Diagnostic> {
        let Some(def) = Library::built_in().nodes.get("light") else { return Ok(None) };
        let word = light.kind.word();
        let is_of_kind =
            |choice: &Option<(usize, String)>| choice.as_ref().is_some_and(|(_, own)| own == word);
        let mut variants = def.variants.iter().filter(|variant| is_of_kind(&variant.choice));
        let Some(variant) = variants.next() else { return Ok(None) };
        let argument = |source: &ArgumentSource| {
            let ArgumentSource::Input(input, _) = source else { return None };
            let Fallback::Context(context) = &def.inputs[*input].fallback else { return None };
            Some(match context.light_input() {
                Some(input) => input.value(light),
                // The surface's position is the only input that is not the light's.
                None => Value::vec(&position.to_array()),
            })
        };
        let arguments: Option<Vec<Value>> = variant.parameters.iter().map(argument).collect();
        let Some(arguments) = arguments else { return Ok(None) };
        let arrived = def.module.program(&variant.function)?.call(&arguments, Precision::F64)?;
        let Some([toward, _, color, intensity]) = arrived.parts() else { return Ok(None) };
        let (toward, color) = (toward.as_vec::<3>(), color.as_vec::<3>());
        Ok(toward.zip(color).zip(intensity.as_f64()).map(|((toward, color), intensity)| Self {
            toward: toward.into(),
            color: color.into(),
            intensity,
        }))
    }
}
