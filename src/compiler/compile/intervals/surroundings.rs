//! The range of a context before any fragment runs.

use super::Ranges;
use super::range::{Floats, Range};
use crate::compile::MAX_INTENSITY;
use crate::document::{LightInput, LightQuantity};
use crate::library::{Context, Type};

/// Unit vectors and rotations, with their roundings.
const UNIT: f64 = 1.0 + 2e-6;

/// The range of each scalar of a context.
///
/// Everything that a mesh, an interpolation or a scene says may be anything; what generated code
/// normalizes, and what the host computes as a cosine or clamps, is known.
pub(in crate::compile) fn context_ranges(context: Context) -> Ranges {
    let count = super::scalars_in(&Type::from_wgsl(context.wgsl_type())).unwrap_or(1);
    let unit_length = Floats { minus_zero: true, ..Floats::between(-UNIT, UNIT) };
    let one = match context {
        Context::Normal | Context::View | Context::CameraFromWorld => unit_length,
        Context::Light(input) if input.is_unit() => unit_length,
        Context::Light(LightInput::Field(field)) if field.quantity() == LightQuantity::Factor => {
            Floats { minus_zero: true, ..Floats::between(0.0, MAX_INTENSITY * 1.001) }
        }
        Context::ObjectId | Context::Viewport => Floats::between(0.0, f64::from(1_u32 << 24)),
        _ => Floats::ALL,
    };
    vec![Range::Float(one); count].into()
}
