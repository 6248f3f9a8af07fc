// Colour arithmetic on straight RGB numbers; total, also for colours below 0 and above 1.
import chiaro::numeric;
import chiaro::total;

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its size.
fn linear_of_srgb(coded: f32) -> f32 {
    let size = abs(bounded(coded));
    let value = select(powered((size + 0.055) / 1.055, 2.4), size / 12.92, size <= 0.04045);
    return select(value, -value, coded < 0.0);
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its size.
fn srgb_of_linear(light: f32) -> f32 {
    let size = abs(bounded(light));
    let value = select(1.055 * powered(size, 1.0 / 2.4) - 0.055, size * 12.92, size <= 0.0031308);
    return bounded(select(value, -value, light < 0.0));
}

/// The colour whose largest component is 1 and smallest 0, for a hue in turns; red at 0, green at 1/3, blue at 2/3.
fn rgb_of_hue(hue: f32) -> vec3f {
    let places = vec3f(hue) + vec3f(0.0, 0.666666666666666667, 0.333333333333333333);
    return clamp(abs(6.0 * (places - floor(places)) - 3.0) - 1.0, vec3f(0.0), vec3f(1.0));
}

/// The hue of a colour in turns, in [0, 1]; 0 for grey. `chroma` is its largest component less its smallest.
fn hue_of_rgb(rgb: vec3f, chroma: f32) -> f32 {
    let largest = max(max(rgb.x, rgb.y), rgb.z);
    var sextant = 4.0 + divided(rgb.x - rgb.y, chroma);
    if largest == rgb.y {
        sextant = 2.0 + divided(rgb.z - rgb.x, chroma);
    }
    if largest == rgb.x {
        sextant = divided(rgb.y - rgb.z, chroma);
    }
    let hue = select(0.0, sextant / 6.0, chroma > 0.0);
    return select(hue, hue + 1.0, hue < 0.0);
}

/// Turns the hue (by turns) and scales saturation and value, as HSV counts them. Saturation ends where a component
/// reaches 0, unless one was below it before.
fn hsv_adjusted(rgb: vec3f, hue: f32, saturation: f32, value: f32) -> vec3f {
    let c = clamp(rgb, vec3f(-1e15), vec3f(1e15));
    let largest = max(max(c.x, c.y), c.z);
    let chroma = largest - min(min(c.x, c.y), c.z);
    let turned = rgb_of_hue(hue_of_rgb(c, chroma) + clamp(hue, -1e4, 1e4));
    let scaled = clamp(chroma * clamp(saturation, 0.0, 1e15), 0.0, max(chroma, largest));
    return bounded_vec3(clamp(value, 0.0, 1e15) * (largest - scaled * (1.0 - turned)));
}

/// 2 a b below the middle of `b`, and the same from white above it.
fn hard_light(a: f32, b: f32) -> f32 {
    return select(1.0 - 2.0 * (1.0 - a) * (1.0 - b), 2.0 * a * b, b <= 0.5);
}

/// Darkens or lightens a by b without ever reaching black or white (W3C Compositing and Blending 1).
fn soft_light(a: f32, b: f32) -> f32 {
    if b <= 0.5 {
        return a - (1.0 - 2.0 * b) * a * (1.0 - a);
    }
    let curved = select(sqrt(max(a, 0.0)), ((16.0 * a - 12.0) * a + 4.0) * a, a <= 0.25);
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// From the colour a to the blended numbers by a factor in [0, 1]; a keeps its alpha.
fn color_mixed(a: vec4f, blended: vec3f, factor: f32) -> vec4f {
    return vec4f(mixed_vec3(bounded_vec3(a.xyz), bounded_vec3(blended), factor_of(factor, true)), bounded(a.w));
}
