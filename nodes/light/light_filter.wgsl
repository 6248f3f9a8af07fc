import chiaro::types;
import chiaro::convert;
import chiaro::filter;

/// Light filter
///
/// Puts a filter into a light's way. After the profile it dims and tints what the light draws;
/// before the profile it moves the terminator: less light makes the bright side smaller, with its
/// edge as it was.
///
/// @choice stage "Stage" default=after after="After the profile" before="Before the profile" :
///   Whether the filter dims what is drawn, or moves where it is drawn.
/// @param light "Light" wire : The light.
/// @param angle "Angle" wire : The angle between the light and the surface, on its way to a
///   profile.
/// @param share "Share" default=1 min=0 max=1 : How much of the light passes, from a filter.
/// @param color "Color" default=1,1,1,1 : The color of the glass; before the profile its brightness
///   counts. Its alpha does not count.
fn light_filter_after(light: Light, angle: Angle, share: f32, color: Color) -> FilteredLight {
    let tint = clamp(bounded_vec3(color.xyz), vec3f(0.0), vec3f(1e6));
    let left = light.intensity * share_kept(share);
    let behind = Light(light.direction, light.own_direction, light.color * tint, left);
    return FilteredLight(behind, angle);
}

fn light_filter_before(light: Light, angle: Angle, share: f32, color: Color) -> FilteredLight {
    let tint = clamp(bounded_vec3(color.xyz), vec3f(0.0), vec3f(1.0));
    let left = share_kept(share) * clamp(luminance(vec4f(tint, 1.0)), 0.0, 1.0);
    return FilteredLight(light, angle_filtered(angle, left));
}

struct FilteredLight {
    /// The light behind the filter.
    light: Light,
    /// The angle for the profile.
    angle: Angle,
}
