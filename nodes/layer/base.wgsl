import chiaro::types;
import chiaro::convert;

/// Base
///
/// The color under the first layer, which may be transparent. (The BADF paper calls it C0.)
///
/// @param color "Color" default=0.1,0.1,0.12,1 : What is seen where no layer paints.
/// @bound color
/// @return below "Stack" : The start of a stack of layers.
/// @source BADF eq. 2
fn base(color: Color) -> Composite {
    return premultiplied(color);
}
