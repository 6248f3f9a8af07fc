import chiaro::direction;
import chiaro::numeric;
import chiaro::total;

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
///
/// @param direction "Direction" from=normal : The half-vector, with the mesh's axes; or the normal,
///   with axes around the half-vector. Any length.
/// @param x_axis "X axis" from=tangent : Along u of the mesh, or from Axes around a direction.
/// @param y_axis "Y axis" from=bitangent : Along v of the mesh, or from Axes around a direction.
/// @param amount "Amount" default=0.3 min=0 max=1 : How far the corners are drawn out; at 0.3 the
///   sides are straight.
/// @param sharpness "Sharpness" default=4 min=1 max=32 : How pointed the corners are.
/// @return direction "Direction" : Unit.
/// @source Anjyo and Hiramitsu 2003, squaring
fn square_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, amount: f32,
    sharpness: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    // `corner` is 0 along either axis and 1 midway between them.
    let square = dot(bent.place, bent.place);
    // The distance from midway decides, since a high sharpness multiplies that.
    let apart = abs(bent.place.x) - abs(bent.place.y);
    let aside = clamp(apart * apart / max(square, 1e-20), 0.0, 1.0);
    let sharp = clamp(bounded(sharpness), 1.0, 1024.0);
    let corner = select(0.0, exp2_stable(sharp * LOG2_E * log1p_negative(aside)), square > 1e-20
        && aside < 1.0);
    return direction_moved(bent, -clamp(amount, 0.0, 1.0) * corner * bent.place);
}
