// Control of light by place (Todo et al. 2007).
import chiaro::numeric;
import chiaro::total;

/// Weight of a place: 1 within the share `hardness` of the radius around the center, 0 from the
/// radius on, smooth between.
fn near_place(position: vec3f, center: vec3f, radius: f32, hardness: f32) -> f32 {
    let far = length_of(bounded_vec3(position) - bounded_vec3(center));
    let reach = max(bounded(radius), 0.0);
    return 1.0 - eased(far, reach * factor_of(hardness, true), reach);
}
