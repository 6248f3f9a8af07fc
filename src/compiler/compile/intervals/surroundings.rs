//! The range of a context before any fragment runs.

use super::Ranges;
use super::range::{Floats, Length, Range};
use crate::compile::MAX_INTENSITY;
use crate::document::MAX_LIGHT_COLOR;
use crate::library::{Context, ContextBounds, Type};

/// Unit vectors and rotations, with their roundings.
const UNIT: f64 = 1.0 + 2e-6;

/// The range of each scalar of a context.
///
/// Everything that a mesh, an interpolation or a scene says may be anything; what generated code
/// normalizes, and what the host computes as a cosine or clamps, is known.
pub(in crate::compile) fn context_ranges(context: Context) -> Ranges {
    let count = super::scalars_in(&Type::from_wgsl(context.wgsl_type())).unwrap_or(1);
    let ty = Type::from_wgsl(context.wgsl_type());
    // Vectors and rotations; a cosine alone is none.
    let is_vector = matches!(ty, Type::Vec3 | Type::Mat3);
    let length = if is_vector { Length::One } else { Length::Any };
    let one = match context.row().bounds {
        ContextBounds::Anything => Floats::ALL,
        ContextBounds::Unit => Floats { minus_zero: true, length, ..Floats::between(-UNIT, UNIT) },
        ContextBounds::Count => Floats::between(0.0, f64::from(1_u32 << 24)),
        ContextBounds::Within(most) => {
            Floats { minus_zero: true, ..Floats::between(-most * 1.001, most * 1.001) }
        }
        ContextBounds::Color => {
            let most = MAX_LIGHT_COLOR * 1.001;
            Floats { minus_zero: true, ..Floats::between(-most, most) }
        }
        ContextBounds::Intensity => {
            Floats { minus_zero: true, ..Floats::between(0.0, MAX_INTENSITY * 1.001) }
        }
    };
    vec![Range::Float(one); count].into()
}
