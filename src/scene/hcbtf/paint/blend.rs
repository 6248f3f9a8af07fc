//! Blending of colors over texels, straight alpha as bytes.

/// A byte from a number of 0 to 255, rounded to the nearest.
fn byte(number: f64) -> u8 {
    (number + 0.5) as u8
}

/// A color (0 to 255 each) laid over a texel with the coverage `alpha` from 0 to 1. Colors are
/// weighted by how much of them is seen, so that colors under alpha 0 darken no edge.
pub(super) fn over(under: [u8; 4], color: [f64; 3], alpha: f64) -> [u8; 4] {
    let kept = f64::from(under[3]) / 255.0 * (1.0 - alpha);
    let all = alpha + kept;
    let opacity = byte(all * 255.0);
    if opacity == 0 || alpha <= 0.0 {
        return under;
    }
    let weight = alpha / all;
    let mix = |channel: usize| {
        let below = f64::from(under[channel]);
        byte(below + (color[channel] - below) * weight)
    };
    [mix(0), mix(1), mix(2), opacity]
}

/// A texel with a share of its alpha removed, from 0 to 1.
pub(super) fn erased(under: [u8; 4], part: f64) -> [u8; 4] {
    let [red, green, blue, alpha] = under;
    [red, green, blue, byte(f64::from(alpha) * (1.0 - part))]
}

/// A texel with its color multiplied by its alpha, each from 0 to 1.
pub(super) fn premultiplied(texel: [u8; 4]) -> [f32; 4] {
    let [red, green, blue, alpha] = texel.map(|byte| f32::from(byte) / 255.0);
    [red * alpha, green * alpha, blue * alpha, alpha]
}

/// The texel of a premultiplied color; a texel of alpha 0 keeps the color that it had.
pub(super) fn straight(color: [f32; 4], before: [u8; 4]) -> [u8; 4] {
    let [red, green, blue, alpha] = color.map(f64::from);
    match byte(alpha * 255.0) {
        0 => [before[0], before[1], before[2], 0],
        opacity => {
            let [red, green, blue] =
                [red, green, blue].map(|channel| byte(channel / alpha * 255.0));
            [red, green, blue, opacity]
        }
    }
}
