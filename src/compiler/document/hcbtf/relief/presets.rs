//! Presets of reliefs.

use chiaro_locale::{Text, text};

use super::{Finish, Glint, Illumination, Pattern, Relief};

/// Name of a preset, and the function that makes its relief.
pub type Preset = (Text, fn() -> Relief);

/// Presets of reliefs, by name.
pub const PRESETS: [Preset; 5] = [
    (text!("Bricks"), bricks),
    (text!("Asphalt"), asphalt),
    (text!("Facade"), facade),
    (text!("Arches"), arches),
    (text!("Sand"), sand),
];

fn bricks() -> Relief {
    let pattern = Pattern::Bricks {
        columns: 3,
        rows: 6,
        shift: 0.5,
        joint: 0.14,
        bevel: 0.16,
        unevenness: 0.35,
        roughness: 0.45,
        colors: [[206, 112, 84], [158, 78, 64]],
        joint_color: [222, 212, 194],
    };
    let light = Illumination { sun_amount: 1.0, sky_amount: 0.5, ..Illumination::default() };
    Relief {
        pattern,
        light,
        depth: 0.04,
        glint: Glint { amount: 0.12, sharpness: 12.0, ..Glint::default() },
        finish: Finish { ink: 0.35, ink_width: 0.8, grain: 0.12, ..Finish::default() },
        ..Relief::default()
    }
}

fn asphalt() -> Relief {
    let pattern = Pattern::Stones {
        count: 9,
        share: 0.75,
        grit: 0.8,
        roundness: 0.55,
        colors: [[112, 110, 108], [168, 160, 148]],
        binder: [46, 46, 52],
    };
    Relief {
        pattern,
        depth: 0.055,
        glint: Glint { amount: 1.6, sharpness: 30.0, share: 0.4, lean: 0.35 },
        ..Relief::default()
    }
}

fn facade() -> Relief {
    let pattern = Pattern::Facade {
        columns: 2,
        floors: 2,
        window: [0.46, 0.58],
        frame: 0.1,
        sill: 0.5,
        roughness: 0.5,
        wall: [226, 206, 178],
        trim: [244, 236, 222],
        glass: [70, 92, 112],
        lit: 0.4,
        lit_color: [255, 206, 120],
    };
    let light = Illumination {
        sun: [255, 248, 232],
        low_sun: [255, 178, 122],
        sun_amount: 0.95,
        sky: [168, 188, 224],
        low_sky: [136, 122, 176],
        sky_amount: 0.42,
        is_upright: true,
        ..Illumination::default()
    };
    let finish = Finish {
        ink: 0.75,
        ink_width: 0.8,
        ink_color: [58, 44, 60],
        hatch: 0.4,
        hatch_lines: 14,
        wobble: 0.012,
        grain: 0.16,
        ..Finish::default()
    };
    let glint = Glint { amount: 0.9, sharpness: 24.0, ..Glint::default() };
    Relief { pattern, depth: 0.05, light, glint, finish, ..Relief::default() }
}

fn arches() -> Relief {
    let pattern = Pattern::Arches {
        columns: 1,
        rows: 1,
        opening: [0.5, 0.8],
        ring: 0.34,
        courses: 7,
        roughness: 0.5,
        wall: [206, 178, 138],
        trim: [232, 212, 176],
        inside: [134, 102, 92],
    };
    let light = Illumination { sky_amount: 0.4, bounces: 3, ..Illumination::default() };
    let finish = Finish { ink: 0.5, ink_color: [66, 44, 44], grain: 0.12, ..Finish::default() };
    Relief { pattern, depth: 0.13, light, finish, ..Relief::default() }
}

fn sand() -> Relief {
    let pattern = Pattern::Ripples {
        count: 7,
        bend: 1.1,
        roughness: 0.25,
        colors: [[176, 132, 84], [238, 208, 154]],
    };
    let glint = Glint { amount: 0.8, sharpness: 60.0, share: 0.06, lean: 0.3 };
    Relief { pattern, depth: 0.035, glint, ..Relief::default() }
}
