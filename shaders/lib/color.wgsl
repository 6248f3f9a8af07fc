// Color arithmetic on straight RGB numbers; total, also for colors below 0 and above 1.
import chiaro::numeric;
import chiaro::total;

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
fn linear_of_srgb(coded: f32) -> f32 {
    let size = abs(bounded(coded));
    let value = select(powered((size + 0.055) / 1.055, 2.4), size / 12.92, size <= 0.04045);
    return select(value, -value, coded < 0.0);
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
fn srgb_of_linear(light: f32) -> f32 {
    let size = abs(bounded(light));
    let value = select(1.055 * powered(size, 1.0 / 2.4) - 0.055, size * 12.92, size <= 0.0031308);
    return bounded(select(value, -value, light < 0.0));
}

/// The color whose largest component is 1 and smallest 0, for a hue in turns; red at 0, green at
/// 1/3, blue at 2/3.
fn rgb_of_hue(hue: f32) -> vec3f {
    let places = vec3f(hue) + vec3f(0.0, 0.666666666666666667, 0.333333333333333333);
    return clamp(abs(6.0 * (places - floor(places)) - 3.0) - 1.0, vec3f(0.0), vec3f(1.0));
}

/// The hue of a color in turns, in [0, 1]; 0 for gray. `chroma` is its largest component less its
/// smallest.
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

/// Turns the hue (by turns) and scales saturation and value, as HSV counts them. Saturation ends
/// where a component reaches 0, unless one was below it before.
fn hsv_adjusted(rgb: vec3f, hue: f32, saturation: f32, value: f32) -> vec3f {
    let c = clamp(rgb, vec3f(-1e15), vec3f(1e15));
    let largest = max(max(c.x, c.y), c.z);
    let chroma = largest - min(min(c.x, c.y), c.z);
    let turned = rgb_of_hue(hue_of_rgb(c, chroma) + clamp(hue, -1e4, 1e4));
    let scaled = clamp(chroma * clamp(saturation, 0.0, 1e15), 0.0, max(chroma, largest));
    return bounded_vec3(clamp(value, 0.0, 1e15) * (largest - scaled * (1.0 - turned)));
}

/// Hard light: 2 a b where b is at most 1/2, and the same from white above.
fn hard_light(a: f32, b: f32) -> f32 {
    return select(1.0 - 2.0 * (1.0 - a) * (1.0 - b), 2.0 * a * b, b <= 0.5);
}

/// Soft light: a darkened or lightened by b without ever reaching black or white (W3C Compositing
/// and Blending 1).
fn soft_light(a: f32, b: f32) -> f32 {
    if b <= 0.5 {
        return a - (1.0 - 2.0 * b) * a * (1.0 - a);
    }
    let curved = select(sqrt(max(a, 0.0)), ((16.0 * a - 12.0) * a + 4.0) * a, a <= 0.25);
    return a + (2.0 * b - 1.0) * (curved - a);
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
fn color_mixed(a: vec4f, blended: vec3f, factor: f32) -> vec4f {
    return vec4f(mixed_vec3(bounded_vec3(a.xyz), bounded_vec3(blended), factor_of(factor, true)),
        bounded(a.w));
}

/// `rgb` with each component clamped to [0, 1].
fn within_unit(rgb: vec3f) -> vec3f {
    return clamp(bounded_vec3(rgb), vec3f(0.0), vec3f(1.0));
}

/// a brightened toward white as b nears it (W3C Compositing and Blending 1); both from 0 to 1.
fn dodged(a: f32, b: f32) -> f32 {
    return select(select(min(1.0, a / max(1.0 - b, SMALLEST_NORMAL)), 1.0, b >= 1.0), 0.0,
        a <= 0.0);
}

/// a darkened toward black as b nears it (W3C Compositing and Blending 1); both from 0 to 1.
fn burned(a: f32, b: f32) -> f32 {
    return select(select(1.0 - min(1.0, (1.0 - a) / max(b, SMALLEST_NORMAL)), 0.0, b <= 0.0), 1.0,
        a >= 1.0);
}

/// Lightness of a color in the non-separable modes (W3C Compositing and Blending 1, Lum).
fn lightness_of(rgb: vec3f) -> f32 {
    return dot(rgb, vec3f(0.3, 0.59, 0.11));
}

/// `rgb` as light as `other`, drawn toward its gray where a component would leave [0, 1] (SetLum,
/// ClipColor).
fn lit_as(rgb: vec3f, other: vec3f) -> vec3f {
    let light = lightness_of(other);
    let moved = rgb + (light - lightness_of(rgb));
    let least = min(min(moved.x, moved.y), moved.z);
    let largest = max(max(moved.x, moved.y), moved.z);
    let raised = select(1.0, light / max(light - least, 1e-6), least < 0.0);
    let clipped = light + (moved - light) * raised;
    // If both ends lie outside, the upper one is measured after the lower one was drawn in.
    let top = light + (largest - light) * raised;
    let lowered = select(1.0, (1.0 - light) / max(top - light, 1e-6), top > 1.0);
    return light + (clipped - light) * lowered;
}

/// `rgb` with the spread between largest and smallest component that `other` has (SetSat); black
/// where `rgb` is gray.
fn saturated_as(rgb: vec3f, other: vec3f) -> vec3f {
    let least = min(min(rgb.x, rgb.y), rgb.z);
    let spread = max(max(rgb.x, rgb.y), rgb.z) - least;
    let wanted = max(max(other.x, other.y), other.z) - min(min(other.x, other.y), other.z);
    return select(vec3f(0.0), (rgb - least) * (wanted / max(spread, SMALLEST_NORMAL)),
        spread > 0.0);
}

// Paint modes (W3C Compositing and Blending 1): a is below, b on top.

/// Both lights together, as of two projectors: never darker than either.
fn screened(a: vec3f, b: vec3f) -> vec3f {
    return a + b - a * b;
}

/// Each component of b in hard light over a; overlay is a over b.
fn hard_lit(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(hard_light(a.x, b.x), hard_light(a.y, b.y), hard_light(a.z, b.z));
}

/// Each component of b in soft light over a.
fn soft_lit(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(soft_light(a.x, b.x), soft_light(a.y, b.y), soft_light(a.z, b.z));
}

/// Difference without its middle: `a + b - 2ab`.
fn excluded(a: vec3f, b: vec3f) -> vec3f {
    return a + b - 2.0 * a * b;
}

/// Each component of a dodged by b; both counted from 0 to 1.
fn dodged_by(a: vec3f, b: vec3f) -> vec3f {
    let below = within_unit(a);
    let top = within_unit(b);
    return vec3f(dodged(below.x, top.x), dodged(below.y, top.y), dodged(below.z, top.z));
}

/// Each component of a burned by b; both counted from 0 to 1.
fn burned_by(a: vec3f, b: vec3f) -> vec3f {
    let below = within_unit(a);
    let top = within_unit(b);
    return vec3f(burned(below.x, top.x), burned(below.y, top.y), burned(below.z, top.z));
}

/// Hue of b with the saturation and lightness of a; both counted from 0 to 1.
fn hued(a: vec3f, b: vec3f) -> vec3f {
    let below = within_unit(a);
    return lit_as(saturated_as(within_unit(b), below), below);
}

/// Saturation of b with the hue and lightness of a; both counted from 0 to 1.
fn saturated(a: vec3f, b: vec3f) -> vec3f {
    let below = within_unit(a);
    return lit_as(saturated_as(below, within_unit(b)), below);
}

/// Hue and saturation of b with the lightness of a; both counted from 0 to 1.
fn tinted(a: vec3f, b: vec3f) -> vec3f {
    return lit_as(within_unit(b), within_unit(a));
}

/// The cube root, with the sign of x.
fn cube_root(x: f32) -> f32 {
    let root = powered(abs(x), 1.0 / 3.0);
    return select(root, -root, x < 0.0);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear(rgb: vec3f) -> vec3f {
    let c = clamp(bounded_vec3(rgb), vec3f(-1e9), vec3f(1e9));
    let l = cube_root(dot(c, vec3f(0.4122214708, 0.5363325363, 0.0514459929)));
    let m = cube_root(dot(c, vec3f(0.2119034982, 0.6806995451, 0.1073969566)));
    let s = cube_root(dot(c, vec3f(0.0883024619, 0.2817188376, 0.6299787005)));
    return vec3f(
        0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
        1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
        0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s,
    );
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
fn linear_of_oklab(lab: vec3f) -> vec3f {
    let c = clamp(bounded_vec3(lab), vec3f(-1e6), vec3f(1e6));
    let l = c.x + 0.3963377774 * c.y + 0.2158037573 * c.z;
    let m = c.x - 0.1055613458 * c.y - 0.0638541728 * c.z;
    let s = c.x - 0.0894841775 * c.y - 1.2914855480 * c.z;
    let cubes = vec3f(l * l * l, m * m * m, s * s * s);
    return vec3f(
        dot(cubes, vec3f(4.0767416621, -3.3077115913, 0.2309699292)),
        dot(cubes, vec3f(-1.2684380046, 2.6097574011, -0.3413193965)),
        dot(cubes, vec3f(-0.0041960863, -0.7034186147, 1.7076147010)),
    );
}

/// [`oklab_of_linear`] of an sRGB-coded color.
fn oklab_of_srgb(coded: vec3f) -> vec3f {
    return oklab_of_linear(vec3f(linear_of_srgb(coded.x), linear_of_srgb(coded.y),
        linear_of_srgb(coded.z)));
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
fn srgb_of_oklab(lab: vec3f) -> vec3f {
    let light = linear_of_oklab(lab);
    return vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// Mix of two sRGB-coded colors in Oklab, even to the eye; t from 0 to 1.
fn mixed_in_oklab(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let lab = mixed_vec3(oklab_of_srgb(a.xyz), oklab_of_srgb(b.xyz), t);
    return ends_kept(a, b, t, srgb_of_oklab(lab));
}

/// Mix of two sRGB-coded colors in linear light, as lights mix; t from 0 to 1.
fn mixed_in_light(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let light = vec3f(
        mixed(linear_of_srgb(a.x), linear_of_srgb(b.x), t),
        mixed(linear_of_srgb(a.y), linear_of_srgb(b.y), t),
        mixed(linear_of_srgb(a.z), linear_of_srgb(b.z), t),
    );
    return ends_kept(a, b, t, vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y),
        srgb_of_linear(light.z)));
}

/// Mix of two sRGB-coded colors by lightness, chroma and hue of Oklab, the shorter way around; t
/// from 0 to 1.
fn mixed_by_hue(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let start = oklab_of_srgb(a.xyz);
    let goal = oklab_of_srgb(b.xyz);
    let chroma = vec2f(length_of(vec3f(start.yz, 0.0)), length_of(vec3f(goal.yz, 0.0)));
    // Gray has no hue and takes that of the other color.
    let one = angle_of_point(select(start.z, goal.z, chroma.x < 1e-3),
        select(start.y, goal.y, chroma.x < 1e-3));
    let other = angle_of_point(select(goal.z, start.z, chroma.y < 1e-3),
        select(goal.y, start.y, chroma.y < 1e-3));
    let apart = other - one;
    let way = apart - 2.0 * PI * round(apart / (2.0 * PI));
    let turned = sin_cos_of(one + t * way);
    let size = mixed(chroma.x, chroma.y, t);
    return ends_kept(a, b, t, srgb_of_oklab(vec3f(mixed(start.x, goal.x, t), size * turned.y,
        size * turned.x)));
}

/// Mix of two colors by hue, saturation and value, the shorter way around; t from 0 to 1.
fn mixed_in_hsv(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let start = hsv_of_rgb(bounded_vec3(a.xyz));
    let goal = hsv_of_rgb(bounded_vec3(b.xyz));
    // Gray has no hue and takes that of the other color.
    let one = select(start.x, goal.x, start.y < 1e-3);
    let other = select(goal.x, start.x, goal.y < 1e-3);
    let apart = other - one;
    let hue = one + t * (apart - round(apart));
    let value = mixed(start.z, goal.z, t);
    let rgb = mixed_vec3(vec3f(1.0), rgb_of_hue(hue - floor(hue)), mixed(start.y, goal.y, t));
    return ends_kept(a, b, t, value * rgb);
}

/// Hue in turns, saturation and value of a color; gray has the hue 0.
fn hsv_of_rgb(rgb: vec3f) -> vec3f {
    let most = max(max(rgb.x, rgb.y), rgb.z);
    let chroma = most - min(min(rgb.x, rgb.y), rgb.z);
    return vec3f(hue_of_rgb(rgb, chroma), divided(chroma, most), most);
}

/// The mixed color with its alpha; exactly a and b at the ends, which going to another space and
/// back would round.
fn ends_kept(a: vec4f, b: vec4f, t: f32, rgb: vec3f) -> vec4f {
    let mixed_color = vec4f(bounded_vec3(rgb), mixed(a.w, b.w, t));
    return select(select(mixed_color, bounded_vec4(b), t >= 1.0), bounded_vec4(a), t <= 0.0);
}
