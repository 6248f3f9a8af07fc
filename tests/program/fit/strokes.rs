//! A few strokes of light and dark on the picture of a look, as painted by hand.

use chiaro::document::Look;
use chiaro::fit::{FitTarget, PixelGoal};

use super::hidden::{SIDE, picture, setup_of};

/// Goals of a few strokes, and colors that the look shows at the rest.
pub(crate) struct Strokes {
    pub(crate) painted: FitTarget,
    /// Unpainted pixels within the object, with their colors.
    pub(crate) rest: Vec<PixelGoal>,
}

/// Middle and brightness of two broad strokes: light on the right, dark on the left; positions from
/// the picture's middle, in parts of its side.
const SPOTS: [([f64; 2], f64); 2] = [([0.14, -0.08], 0.25), ([-0.14, 0.02], -0.2)];
/// Half the brush's width, in parts of the picture's side.
const RADIUS: f64 = 0.075;

/// Strokes on a look on a mesh.
pub(crate) fn strokes(look: &Look, mesh: &str) -> Strokes {
    let picture = picture(&setup_of(look.clone(), mesh));
    let (mut painted, mut rest) = (FitTarget { size: [SIDE; 2], goals: Vec::new() }, Vec::new());
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        if picture.coverage(x, y).draw.is_none() {
            continue;
        }
        let at = [x, y].map(|at| (f64::from(at) + 0.5) / f64::from(SIDE) - 0.5);
        let [r, g, b, _] = picture.straight(x, y);
        let shown = [r, g, b];
        // A stroke extends up and down from its middle.
        let near = |(middle, _): &&([f64; 2], f64)| {
            let beyond = (at[1] - middle[1]).abs() - 0.08;
            (at[0] - middle[0]).hypot(beyond.max(0.0)) < RADIUS
        };
        match SPOTS.iter().find(near) {
            Some((_, by)) => {
                let color =
                    shown.map(|c| if *by > 0.0 { c + by * (1.0 - c) } else { c * (1.0 + by) });
                painted.goals.push(PixelGoal { pixel: [x, y], color, weight: 1.0, is_rest: false });
            }
            None => {
                rest.push(PixelGoal { pixel: [x, y], color: shown, weight: 1.0, is_rest: false });
            }
        }
    }
    Strokes { painted, rest }
}

/// Distance of another look from the goals of the strokes: the RMS of a channel at the strokes and
/// at the rest, and the largest difference at the rest, 0 to 1.
pub(crate) fn off(strokes: &Strokes, look: &Look, mesh: &str) -> [f64; 3] {
    let picture = picture(&setup_of(look.clone(), mesh));
    let off = |goals: &[PixelGoal]| {
        let each = goals.iter().map(|goal| {
            let shown = picture.straight(goal.pixel[0], goal.pixel[1]);
            (0..3).map(|c| (shown[c] - goal.color[c]).powi(2)).sum::<f64>() / 3.0
        });
        each.collect::<Vec<f64>>()
    };
    let rms = |squares: &[f64]| (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
    let (painted, rest) = (off(&strokes.painted.goals), off(&strokes.rest));
    [rms(&painted), rms(&rest), rest.iter().copied().fold(0.0, f64::max).sqrt()]
}
