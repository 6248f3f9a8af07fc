import chiaro::types;
import chiaro::color;
import chiaro::total;
import chiaro::antialias;

/// Posterize
///
/// Reduces a color to a few steps, as screen prints and old posters do. By lightness the hue stays
/// and only light and dark are cut, in steps that look even; by channel the hue shifts too, which
/// is the look of early computers.
///
/// @choice by "By" default=lightness lightness="Lightness" channel="Channel" : What is cut into
///   steps.
/// @param color "Color" default=0.5,0.5,0.5,1 : Straight RGBA, as on screen; the alpha stays. Each
///   from 0 to 1.
/// @param steps "Steps" default=4 min=2 max=64 : How many; fewer than 2 count as 2.
/// @param softness "Softness" default=0 min=0 max=1 : How much of a step its edge takes.
/// @return color "Color" : Straight RGBA.
/// @source Ottosson 2020
fn posterize_lightness(color: Color, steps: i32, softness: f32) -> Color {
    let lab = oklab_of_srgb(within_unit(color.xyz));
    let stepped = stepped_tone(lab.x, footprint_of(lab.x), steps, softness);
    // Colorfulness goes with the lightness, so that what becomes black has no color.
    let kept = select(0.0, stepped / max(lab.x, 1e-4), lab.x > 1e-4);
    return vec4f(within_unit(srgb_of_oklab(vec3f(stepped, lab.yz * min(kept, 1.0)))),
        bounded(color.w));
}

fn posterize_channel(color: Color, steps: i32, softness: f32) -> Color {
    let c = within_unit(color.xyz);
    let w = vec3f(footprint_of(c.x), footprint_of(c.y), footprint_of(c.z));
    return vec4f(
        stepped_tone(c.x, w.x, steps, softness),
        stepped_tone(c.y, w.y, steps, softness),
        stepped_tone(c.z, w.z, steps, softness),
        bounded(color.w),
    );
}
