//! Presets of strokes.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::{
    Bundle, Placement, StrokeGround, StrokeHighlight, StrokeShadow, StrokeShape, StrokeTones,
    Strokes,
};

impl Strokes {
    /// Names of the presets, as [`Self::preset`] takes them.
    pub const PRESETS: [&'static str; 4] = ["Grass", "Pencil", "Stripes", "Half-tone dots"];

    /// Preset with a name of [`Self::PRESETS`]; grass for any other name.
    pub fn preset(name: &str) -> Self {
        match name {
            "Pencil" => pencil(),
            "Stripes" => stripes(),
            "Half-tone dots" => halftone(),
            _ => grass(),
        }
    }
}

fn grass() -> Strokes {
    let blades = Bundle {
        place: Placement::Scatter(190),
        length: [0.3, 0.5],
        width: [0.025, 0.04],
        taper: [0.2, 1.0],
        lean: 0.25,
        bend: 0.7,
        spread: PI,
        curl: 0.5,
        root: [[34, 58, 24], [44, 70, 22]],
        tip: [[112, 152, 48], [170, 186, 82]],
        variation: 0.25,
        ambient: 0.4,
        diffuse: 0.75,
        translucent: 0.6,
        highlight: StrokeHighlight { color: [240, 250, 190], amount: 0.25, sharpness: 24.0 },
        ..Bundle::default()
    };
    let under = Bundle {
        place: Placement::Scatter(220),
        length: [0.15, 0.28],
        width: [0.03, 0.045],
        lean: 0.6,
        root: [[24, 42, 22], [34, 52, 20]],
        tip: [[58, 96, 34], [92, 122, 44]],
        translucent: 0.3,
        highlight: StrokeHighlight::default(),
        ..blades.clone()
    };
    Strokes {
        seed: 1,
        ground: StrokeGround { color: [40, 44, 24, 255], ambient: 0.5, diffuse: 0.5 },
        shadow: StrokeShadow { amount: 0.7, softness: 0.15 },
        bundles: vec![under, blades],
    }
}

fn pencil() -> Strokes {
    let hatch = |direction: f64, count: u32, first: f64, all: f64, gray: [u8; 3]| Bundle {
        place: Placement::Scatter(count),
        shape: StrokeShape::Ribbon,
        length: [0.5, 0.9],
        width: [0.016, 0.026],
        taper: [0.5, 0.9],
        lean: FRAC_PI_2,
        direction,
        spread: 0.06,
        curl: 0.12,
        root: [gray, gray.map(|channel| channel + 24)],
        tip: [gray.map(|channel| channel + 20), gray.map(|channel| channel + 40)],
        variation: 0.15,
        tones: Some(StrokeTones { first, all, growth: 0.0 }),
        grain: 0.45,
        ..Bundle::default()
    };
    Strokes {
        seed: 1,
        ground: StrokeGround { color: [246, 241, 228, 255], ..StrokeGround::default() },
        shadow: StrokeShadow::default(),
        bundles: vec![
            hatch(FRAC_PI_4, 90, 0.97, 0.2, [74, 72, 78]),
            hatch(-FRAC_PI_4, 80, 0.62, 0.05, [62, 60, 68]),
            hatch(0.06, 70, 0.35, -0.05, [48, 46, 56]),
        ],
    }
}

fn stripes() -> Strokes {
    let stripe = |count: u32, root: [u8; 3], tip: [u8; 3], amount: f64| Bundle {
        place: Placement::Scatter(count),
        shape: StrokeShape::Ribbon,
        length: [0.55, 0.8],
        width: [0.07, 0.1],
        lift: [0.0, 0.001],
        lean: FRAC_PI_2,
        turns: 1.0,
        root: [root, root],
        tip: [tip, tip],
        ambient: 0.35,
        diffuse: 0.7,
        highlight: StrokeHighlight { color: [235, 250, 255], amount, sharpness: 14.0 },
        ..Bundle::default()
    };
    Strokes {
        seed: 1,
        ground: StrokeGround { color: [26, 18, 40, 255], ambient: 0.6, diffuse: 0.4 },
        shadow: StrokeShadow::default(),
        bundles: vec![
            stripe(36, [214, 64, 32], [248, 150, 40], 0.0),
            stripe(24, [246, 228, 190], [255, 244, 214], 0.0),
            stripe(30, [18, 60, 170], [40, 130, 240], 1.0),
        ],
    }
}

fn halftone() -> Strokes {
    let dots = Bundle {
        place: Placement::Lattice(32),
        shape: StrokeShape::Dot,
        width: [0.26; 2],
        root: [[22, 24, 44]; 2],
        tip: [[22, 24, 44]; 2],
        tones: Some(StrokeTones { first: 0.95, all: 0.0, growth: 1.0 }),
        ..Bundle::default()
    };
    Strokes {
        seed: 1,
        ground: StrokeGround { color: [150, 170, 196, 255], ..StrokeGround::default() },
        shadow: StrokeShadow::default(),
        bundles: vec![dots],
    }
}
