import chiaro::types;
import chiaro::convert;

/// Base
///
/// The colour under the first layer: C0 of the BADF paper. It may be transparent.
///
/// @param color "Color" default=0.1,0.1,0.12,1 : What is seen where no layer paints.
/// @return below "Stack" : The start of a stack of layers.
/// @source BADF eq. 2
fn base(color: Color) -> Composite {
    return premultiplied(color);
}
