//! The range of a context before any fragment runs.

use super::Ranges;
use super::range::{Floats, Length, Range};
use crate::library::{Context, ContextBounds, Type};

/// The range of each scalar of a context: what its row promises.
pub(in crate::compile) fn context_ranges(context: Context) -> Ranges {
    if context.is_resource() {
        return [].into();
    }
    let count = super::scalars_in(&Type::from_wgsl(context.wgsl_type())).unwrap_or(1);
    let ty = Type::from_wgsl(context.wgsl_type());
    let bounds = context.row().bounds;
    let length = match (bounds, &ty) {
        // Vectors and rotations; a cosine alone is none.
        (ContextBounds::Unit, Type::Vec3 | Type::Mat3) => Length::One,
        (ContextBounds::UnitOrShorter, _) => Length::AtMostOne,
        _ => Length::Any,
    };
    let [least, most] = bounds.limits();
    let minus_zero = least < 0.0 || matches!(bounds, ContextBounds::Intensity);
    let one = Floats { minus_zero, length, ..Floats::between(least, most) };
    vec![Range::Float(one); count].into()
}
