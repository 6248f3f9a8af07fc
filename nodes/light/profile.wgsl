import chiaro::types;
import chiaro::profile;

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
///
/// @param angle "Angle" wire : From a Parametrization.
/// @param offset "Offset" unit=rad default=0 min=0 max=pi : Up to this angle the tone is 1 (tau);
///   pi is ambient.
/// @param falloff "Fall-off" unit=rad default=pi/2 min=0 max=pi : Where the tone falls fastest (f).
/// @param cutoff "Cut-off" unit=rad default=pi/2 min=0 max=pi : Where the tone reaches 0 (c).
/// @param shift "Warp" unit=rad default=0 : Moves the profile outward, as a Curvature warp gives
///   it.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @preset "Lambert" offset=0 falloff=pi/2 cutoff=pi/2
/// @preset "Half-Lambert" offset=0 falloff=pi/2 cutoff=pi
/// @preset "Phong specular" offset=0 falloff=0.3 cutoff=pi/2
/// @preset "Cartoon" offset=pi/4 falloff=pi/4 cutoff=pi/4
/// @preset "Ambient" offset=pi falloff=pi cutoff=pi
/// @error balanced 1e-5 : tone, for a fall-off at least 0.05 from the offset; narrower ones divide
///   by what is left; up to 5e-3 at the end of one whose fall-off is a quarter turn or more from
///   there, which ends infinitely steep
/// @error fast 5e-5 : the same; pixels on an edge of a soft profile are not averaged, hard edges
///   are up to 0.15 off
/// @source BADF eq. 5, 8, 10, 11
fn profile(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_shifted(angle, shift);
    return profile_filtered(warped, angle_footprint(warped), shape);
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, sin_cos_quick(0.5 * clamp(shift, -PI, PI)));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

fn profile_fast(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    return profile_ramped(angle_turned(angle, sin_cos_short(0.5 * clamp(shift, -PI, PI))), shape);
}

fn profile_prepare(offset: f32, falloff: f32, cutoff: f32) -> ProfileShape {
    return profile_shape(offset, falloff, cutoff);
}
