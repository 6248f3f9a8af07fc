//! Paint modes in f64, after W3C Compositing and Blending 1, sections 10.1 and 10.2, as it has
//! them.

/// Result of a paint mode: `cs` laid on `cb`, straight and whole. The modes from `color_dodge` on
/// are meant for colors from 0 to 1.
///
/// # Panics
/// Where there is no such mode.
pub fn painted(mode: &str, cb: [f64; 3], cs: [f64; 3]) -> [f64; 3] {
    let hard = |cb: f64, cs: f64| {
        if cs <= 0.5 { cb * 2.0 * cs } else { cb + (2.0 * cs - 1.0) - cb * (2.0 * cs - 1.0) }
    };
    let each = |f: &dyn Fn(f64, f64) -> f64| [0, 1, 2].map(|k| f(cb[k], cs[k]));
    match mode {
        "normal" | "alpha" => cs,
        "multiply" => each(&|cb, cs| cb * cs),
        "screen" => each(&|cb, cs| 1.0 - (1.0 - cb) * (1.0 - cs)),
        "overlay" => each(&|cb, cs| hard(cs, cb)),
        "hard_light" => each(&hard),
        "soft_light" => each(&soft_light),
        "darken" => each(&f64::min),
        "lighten" => each(&f64::max),
        "difference" => each(&|cb, cs| (cb - cs).abs()),
        "exclusion" => each(&|cb, cs| cb + cs - 2.0 * cb * cs),
        "color_dodge" => each(&|cb, cs| {
            if cb == 0.0 {
                0.0
            } else if cs >= 1.0 {
                1.0
            } else {
                (cb / (1.0 - cs)).min(1.0)
            }
        }),
        "color_burn" => each(&|cb, cs| {
            if cb >= 1.0 {
                1.0
            } else if cs <= 0.0 {
                0.0
            } else {
                1.0 - ((1.0 - cb) / cs).min(1.0)
            }
        }),
        "hue" => set_lum(set_sat(cs, sat(cb)), lum(cb)),
        "saturation" => set_lum(set_sat(cb, sat(cs)), lum(cb)),
        "color" => set_lum(cs, lum(cb)),
        "luminosity" => set_lum(cb, lum(cs)),
        other => panic!("`{other}` has no truth"),
    }
}

fn soft_light(cb: f64, cs: f64) -> f64 {
    let d = if cb <= 0.25 { ((16.0 * cb - 12.0) * cb + 4.0) * cb } else { cb.sqrt() };
    if cs <= 0.5 {
        cb - (1.0 - 2.0 * cs) * cb * (1.0 - cb)
    } else {
        cb + (2.0 * cs - 1.0) * (d - cb)
    }
}

fn lum(c: [f64; 3]) -> f64 {
    0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]
}

fn most(c: [f64; 3]) -> f64 {
    c.into_iter().fold(f64::MIN, f64::max)
}

fn least(c: [f64; 3]) -> f64 {
    c.into_iter().fold(f64::MAX, f64::min)
}

fn sat(c: [f64; 3]) -> f64 {
    most(c) - least(c)
}

fn set_lum(c: [f64; 3], light: f64) -> [f64; 3] {
    let moved = c.map(|channel| channel + light - lum(c));
    let (l, n, x) = (lum(moved), least(moved), most(moved));
    let c = if n < 0.0 { moved.map(|c| l + (c - l) * l / (l - n)) } else { moved };
    if x > 1.0 { c.map(|c| l + (c - l) * (1.0 - l) / (x - l)) } else { c }
}

fn set_sat(c: [f64; 3], spread: f64) -> [f64; 3] {
    if sat(c) > 0.0 { c.map(|channel| (channel - least(c)) * spread / sat(c)) } else { [0.0; 3] }
}
