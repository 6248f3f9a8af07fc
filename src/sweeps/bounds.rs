//! Error bounds of each node's results, and the way results are judged. Exact tiers err by rounding
//! alone; cheaper ones by the error that their files state.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DQuat, DVec3};

use super::case::Case;
use super::slot::{InputSlot, Numbers, SlotKind, is_stretch};
use crate::document::Tier;
use crate::library::Library;

/// Default bound of an exact tier, relative to the output's range: 1, or the largest number of the
/// true result if that is more.
pub const DEFAULT: f64 = 2e-6;

/// Way of comparing a result with the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorMetric {
    /// Distance from the truth.
    Plain,
    /// Distance from the span of all true results for inputs within four units in the last place of
    /// the given ones: for steep or canceling functions, where rounding of the inputs themselves
    /// decides. Such a result is right for inputs that no f32 can tell from the given ones;
    /// anything worse still shows.
    Steep,
    /// Bound as `Steep`, but the distance from the nearest of these true results, and not from the
    /// span between them: for functions with steps.
    Steps,
}

/// A node with another bound or judging than the default, and the reason.
#[derive(Clone, Copy, Debug)]
pub struct Exception {
    /// The kind of node.
    pub node: &'static str,
    /// A word of one of the node's choices; empty for all choices.
    pub word: &'static str,
    /// Bound of the exact tier.
    pub bound: f64,
    /// Way of judging the node's results.
    pub judging: ErrorMetric,
    /// True if the size of the inputs counts into the output's range.
    pub of_inputs: bool,
    /// True if inputs are varied by units in the last place of the largest input (at least 1), and
    /// not each by its own.
    pub together: bool,
    /// Smallest size of inputs, 0 aside, that the bound applies to; below, the result only has to
    /// be finite.
    pub finest: f64,
    /// Largest size of inputs that the bound applies to; beyond, the result only has to be finite.
    pub reach: f64,
    /// Reason for the exception, as docs/accuracy.md prints it.
    pub reason: &'static str,
}

/// Reach of exceptions without a largest input.
const ALL: f64 = f32::MAX as f64;

const fn on(node: &'static str, word: &'static str) -> Exception {
    Exception {
        node,
        word,
        bound: DEFAULT,
        judging: ErrorMetric::Plain,
        of_inputs: false,
        together: false,
        finest: 0.0,
        reach: ALL,
        reason: "",
    }
}

impl Exception {
    const fn steep(self, reason: &'static str) -> Self {
        Self { judging: ErrorMetric::Steep, reason, ..self }
    }

    const fn steps(self, reason: &'static str) -> Self {
        Self { judging: ErrorMetric::Steps, reason, ..self }
    }

    const fn within(self, reach: f64) -> Self {
        Self { reach, ..self }
    }

    const fn from(self, finest: f64) -> Self {
        Self { finest, ..self }
    }

    const fn of_inputs(self) -> Self {
        Self { of_inputs: true, ..self }
    }

    const fn together(self) -> Self {
        Self { together: true, ..self }
    }

    const fn bound(self, bound: f64) -> Self {
        Self { bound, ..self }
    }

    const fn because(self, reason: &'static str) -> Self {
        Self { reason, ..self }
    }
}

/// Bound of colors that are converted back from Oklab. Near black a code is 13 times as steep as
/// light, and light up to 20 (a code of 2 times the matrix' 4) cancels there, rounded by 3e-7.
const FROM_OKLAB: f64 = 8e-5;

/// Bound of a direction of which a thousandth is left, the smallest remainder that is a direction:
/// a thousand times the rounding of the three terms that it is the remainder of.
const REST: f64 = 3e-4;

/// Rounding error of the difference of two distances in Oklab.
const OF_DISTANCES: f64 = 1e-6;

/// All exceptions, with their reasons; the first that fits a case counts.
pub const EXCEPTIONS: &[Exception] = &[
    on("sine", "").within(1e5).because(PHASE),
    on("cosine", "").within(1e5).because(PHASE),
    on("tangent_value", "").within(1e5).steep(PHASE),
    on("transform_uv", "").within(1e5).steep(PHASE),
    on("rotate_vector", "").within(1e5).steep(PHASE),
    on("power", "").within(1e15).steep(POWER),
    on("gamma", "").within(1e15).steep(POWER),
    on("color_space", "oklab_to_srgb").within(2.0).of_inputs().bound(2e-5).steep(COLOR),
    on("color_space", "srgb_to_oklab").within(1e3).of_inputs().steep(COLOR),
    on("color_space", "").within(1e3).because(COLOR),
    on("map_range", "").within(1e15).of_inputs().steep(NARROW),
    on("smooth_step_value", "").within(1e15).steep(NARROW),
    on("threshold", "").within(1e15).steep(NARROW),
    on("bands", "").within(1e15).steep(NARROW),
    on("profile", "").steep(NARROW),
    on("mix_values", "").within(1e15).of_inputs().steep(CANCELS),
    on("dot_product", "").within(1e15).steep(CANCELS),
    on("cross_product", "").within(1e15).steep(CANCELS),
    on("reflect_vector", "").within(1e15).steep(CANCELS),
    on("project_vector", "").within(1e15).steep(CANCELS),
    on("transform_direction", "").within(1e15).steep(CANCELS),
    on("refract_vector", "")
        .within(8.0)
        .bound(2e-4)
        .steep("where total reflection begins, the direction turns infinitely fast"),
    on("normalize_vector", "").steps("a vector that is too short to have a direction gives 0"),
    on("light", "").steep("at the light itself it has no direction"),
    on("light_details", "").steep("at the light itself it has no direction"),
    on("blocker", "").from(1e-2).within(30.0).together().bound(1e-3).steps(THROWN),
    on("rod", "").within(1e3).together().steep(NARROW),
    on("barn_doors", "").within(1e3).together().steps("behind a lamp angles leap"),
    on("light_place", "").from(1e-2).within(1e3).together().bound(1e-4).steps(BEHIND),
    on("lamp_sphere", "").from(1e-2).within(1e3).together().bound(1e-4).steps(AROUND),
    on("distance_ramp", "").within(1e3).together().steep(NARROW),
    on("decay", "").within(1e3).together().steep(POWER),
    on("fraction", "").together().steep(STEPS),
    on("modulo", "").within(1e15).together().steep(STEPS),
    on("rounding", "").steps(STEPS),
    on("sign_of", "").steps(STEPS),
    on("compare", "").steps(STEPS),
    on("curve", "stepped").steps(STEPS),
    on("ramp", "stepped").steps(STEPS),
    on("ramp", "oklab").bound(2e-5).steep(COLOR),
    on("ramp", "light").bound(2e-5).steep(COLOR),
    on("ramp", "hue").bound(2e-5).steep(COLOR),
    on("ramp", "hsv").bound(2e-5).steep(COLOR),
    on("checker", "").from(1e-15).within(1e5).together().steps(STEPS),
    on("gradient", "")
        .from(1e-15)
        .within(1e15)
        .together()
        .steps("around its start it leaps from 1 to 0"),
    on("noise", "")
        .within(8.0)
        .bound(2e-5)
        .steep("octaves are finer than the position's last digits"),
    on("cells", "")
        .within(8.0)
        .together()
        .bound(2e-5)
        .steps("from cell to cell the number is another"),
    on("image", "linear").within(30.0).together().bound(1e-2).steep(FILTER),
    on("image", "nearest").within(30.0).together().steps("between texels rounding decides"),
    on("litsphere", "linear").together().bound(1e-2).steep(FILTER),
    on("litsphere", "nearest").together().steep("between texels rounding decides"),
    on("constant_size", "")
        .from(1e-3)
        .within(1e3)
        .together()
        .steep("at powers of two Even and Odd change places"),
    on("scatter_uv", "").from(1e-4).within(30.0).together().bound(1e-4).steep(CELLS),
    on("hcbtf_lookup", "smooth").within(30.0).together().bound(1e-4).steep(PLACES),
    on("hcbtf_nearest", "")
        .within(30.0)
        .together()
        .bound(1e-4)
        .steep("between texels and paintings rounding decides"),
    on("hcbtf_lookup", "")
        .within(30.0)
        .together()
        .bound(1e-4)
        .steep("between texels and paintings rounding decides"),
    on("hcbtf_directions", "").together().bound(1e-4).steep(PLACES),
    on("dominant_light", "").from(1e-15).steep(STEPS),
    on("light_by_tone", "")
        .steep("where the light stands on the normal, rounding decides to which side it tilts"),
    on("tangent_frame", "").steep(FRAME),
    on("normal_map", "").within(1e15).steep(FRAME),
    on("bump_map", "").within(1e15).because("beyond, the height leaves f32"),
    on("mix_evenly", "").within(2.0).together().bound(FROM_OKLAB).steep(COLOR),
    on("posterize", "lightness").bound(FROM_OKLAB).steep(NARROW),
    on("posterize", "").bound(2e-5).steep(NARROW),
    on("gooch", "").within(1e3).of_inputs().because(COLOR),
    on("detail", "orientation").steep(POWER),
    on("detail", "highlight").bound(2e-5).steep(POWER),
    on("exaggerated", "").bound(3e-4).steep("contrast multiplies what directions were rounded by"),
    on("relief", "").from(1e-15).bound(2e-5).steep(CANCELS),
    on("light_warp", "")
        .from(1e-15)
        .bound(3e-4)
        .steep("a light opposite the normal has no place; powers of two multiply others'"),
    on("radiance_scaling", "").bound(2e-5).steep(POWER),
    on("inner_contour", "").from(1e-15).within(1e3).together().bound(2e-5).steep(NARROW),
    on("outer_contour", "").bound(2e-5).steep(NARROW),
    on("nearby", "").within(1e15).steep(NARROW),
    on("local_tone", "").within(1e15).steep(NARROW),
    on("local_light", "").within(1e3).bound(1e-4).steep(NARROW),
    on("palette", "blended").within(2.0).together().bound(1e-4).steep(COLOR),
    on("palette", "").within(2.0).steps("between two colors that are as near rounding decides"),
    on("color_curves", "").within(1e3).steps(STEPS),
    on("detail", "").steep(NARROW),
    on("rim", "").steep(NARROW),
    on("reflectance", "lambert").steep(CANCELS),
    on("reflectance", "wrap").steep(CANCELS),
    on("reflectance", "").bound(2e-5).steep(POWER),
    on("fresnel", "").steep(CANCELS),
    on("thin_film", "").bound(2e-5).steep(PHASE),
    on("half_vector", "")
        .steep("where light and eye are opposite, rounding says which side is between them"),
    on("axes", "").steep(FRAME),
    on("angle_between_directions", "")
        .steps("a vector that is too short to have a direction counts as +z"),
    on("shift_direction", "").within(1e3).bound(REST).steep(CANCELS),
    on("stretch_direction", "").within(1e3).bound(REST).steep(CANCELS),
    on("split_direction", "").within(1e3).bound(REST).steep(STEPS),
    on("square_direction", "").within(1e3).bound(2e-5).steep(POWER),
    on("star_angle", "")
        .within(1e3)
        .bound(5e-4)
        .steep("64 rays turn 64 times as fast, and notches multiply by 100"),
    on("polar_place", "").steep(POLAR),
    on("screen_place", "")
        .within(1e15)
        .because("far beyond any picture its middle is rounded away"),
    on("mark_place", "").within(1e3).bound(1e-4).steep(FRAME),
    on("halftone", "").within(100.0).together().bound(1e-4).steps(SCREEN),
    on("dither", "").within(1e3).together().bound(1e-4).steps(SCREEN),
    on("paper_grain", "").within(8.0).together().bound(1e-3).steep(CELLS_OF_MARKS),
    on("hatching", "").within(8.0).together().bound(1e-3).steps(CELLS_OF_MARKS),
    on("stippling", "").within(8.0).together().bound(1e-3).steps(CELLS_OF_MARKS),
    on("brush_strokes", "").within(8.0).together().bound(1e-2).steps(CELLS_OF_MARKS),
    on("tone_map", "linear").together().bound(1e-2).steep(FILTER),
    on("tone_map", "nearest").together().steps("between texels rounding decides"),
    on("hsv_adjust", "").within(1e3).of_inputs().steep(COLOR),
    on("brightness_contrast", "").within(1e3).of_inputs().because(COLOR),
    on("negative_color", "").within(1e3).of_inputs().because(COLOR),
    on("curvature_color", "").within(1e3).of_inputs().because(COLOR),
    on("mix_colors", "").within(1e3).of_inputs().steep(COLOR),
    on("blend", "")
        .within(2.0)
        .because("tones and opacities far above 1 multiply what colors were rounded by"),
    on("output", "").within(1e3).steep("dividing by a small alpha"),
    on("stack_color", "").within(1e3).steep("dividing by a small alpha"),
];

const POWER: &str = "far up a power, the exponent multiplies what the base was rounded by";
const NARROW: &str = "a narrow edge is as steep as it is narrow, and an empty one a step";
const FRAME: &str = "where normal and tangent are nearly the same, rounding turns the frame";
const THROWN: &str = "a small shape far away multiplies what its way was rounded by";
const AROUND: &str = "around a lamp 1 meets 0; on its axis any turn is right";
const BEHIND: &str = "behind a lamp there is no picture";
const PHASE: &str = "beyond 100,000 an f32 holds no phase";
const CANCELS: &str = "large terms cancel";
const STEPS: &str = "a step: rounding of the input decides on which side it is";
const CELLS: &str = "from cell to cell another place is seen; what B counts beside A is nothing \
                     where C is all there is";
const PLACES: &str =
    "near the normal rounding turns directions, at the horizon it decides whether there is light";
const SCREEN: &str = "at the edge of a dot or of a pixel rounding decides";
const CELLS_OF_MARKS: &str = "as many as 1000 marks to the height are finer than the place's last \
                              digits, and have hard edges";
const POLAR: &str = "in the middle there is no around, and rounding decides";
const FILTER: &str = "a GPU weighs texels by 8 bits";
const COLOR: &str = "far beyond any color, what is left of a small difference is rounding's";

/// Nodes whose files state errors for pixels on edges, which single samples do not have.
const ON_EDGES: [&str; 2] = ["threshold", "bands"];

/// The exception that a case falls under.
pub fn exception_of(case: &Case) -> Option<&'static Exception> {
    let fits = |exception: &&Exception| {
        exception.node == case.node
            && (exception.word.is_empty()
                || case.choices.values().any(|word| word == exception.word))
    };
    EXCEPTIONS.iter().find(fits)
}

/// True if the size of the inputs counts into a case's range.
pub fn counts_inputs(case: &Case) -> bool {
    exception_of(case).is_some_and(|exception| exception.of_inputs)
}

/// True if a case's inputs are varied by units in the last place of the largest of them.
pub fn moves_together(case: &Case) -> bool {
    exception_of(case).is_some_and(|exception| exception.together)
}

/// Way of judging a case.
pub fn judging(case: &Case) -> ErrorMetric {
    exception_of(case).map_or(ErrorMetric::Plain, |exception| exception.judging)
}

/// Bound of a case's exact tier, relative to the output's range.
fn bound_of_exact(case: &Case) -> f64 {
    exception_of(case).map_or(DEFAULT, |exception| exception.bound)
}

/// Bound of a case, relative to the output's range.
pub fn bound(case: &Case, library: &Library) -> f64 {
    let exact = bound_of_exact(case);
    if case.tier == Tier::Exact {
        return exact;
    }
    let def = library.nodes.get(&case.node).filter(|_| !ON_EDGES.contains(&case.node.as_str()));
    exact + def.and_then(|def| def.error_of(case.tier)).map_or(0.0, |error| error.bound)
}

/// True if a bound applies to a sample; otherwise the result only has to be finite.
pub fn is_stated(case: &Case, slots: &[InputSlot], numbers: &Numbers) -> bool {
    let (finest, reach) =
        exception_of(case).map_or((0.0, ALL), |exception| (exception.finest, exception.reach));
    let is_in_reach = |(slot, numbers): (&InputSlot, &Vec<f64>)| {
        if slot.kind == SlotKind::Direction {
            // At 1e-30 the last digit decides whether a vector is too short to have a direction.
            let largest = numbers.iter().map(|x| x.abs()).fold(0.0, f64::max);
            return !(0.999e-30..1.001e-30).contains(&largest);
        }
        if slot.kind == SlotKind::Stretch && !is_stretch(numbers) {
            return false;
        }
        matches!(slot.kind, SlotKind::Kappa | SlotKind::Whole { .. })
            || numbers.iter().all(|x| *x == 0.0 || (finest..=reach).contains(&x.abs()))
    };
    slots.iter().zip(numbers).all(is_in_reach) && is_of_tier(case, slots, numbers)
}

/// True if the file of a cheaper tier states a bound for a sample.
fn is_of_tier(case: &Case, slots: &[InputSlot], numbers: &Numbers) -> bool {
    if case.node == "litsphere" {
        return has_rim(case, slots, numbers);
    }
    let of =
        |name: &str| slots.iter().position(|slot| slot.name == name).map(|index| &numbers[index]);
    let is_usual = profile_of(case, slots, numbers).is_none_or(|[tau, f, c]| {
        // An offset within 1e-5 of pi is ambient, and shortly before that nothing is left of f32's
        // digits, as of a fall-off that is nearly pi.
        let is_near_pi = (PI - 1e-2..PI - 9e-6).contains(&tau) || (f > PI - 1e-3 && f < c);
        !is_near_pi && (case.tier == Tier::Exact || f >= 0.05)
    });
    let length = of("normal").map_or(1.0, |n| n.iter().map(|x| x * x).sum::<f64>().sqrt());
    is_usual && (case.tier == Tier::Exact || (1e-15..1e18).contains(&length))
}

/// Factor that a sample's bound is multiplied by. A profile that falls off a quarter turn or more
/// from its offset ends infinitely steep, as the square root does at 0; and near an offset of pi
/// the cosine of half the offset is so small that its error is large beside it. A palette's
/// softness divides distances in Oklab, and their rounding error.
pub fn slack(case: &Case, slots: &[InputSlot], numbers: &Numbers) -> f64 {
    if case.choice("by") == "blended" {
        let softness = slots
            .iter()
            .position(|slot| slot.name == "softness")
            .map_or(0.0, |index| numbers[index][0]);
        let share = OF_DISTANCES / bound_of_exact(case);
        return if softness > 0.0 { (share / softness).max(1.0) } else { 1.0 };
    }
    let Some([tau, f, _]) = profile_of(case, slots, numbers) else { return 1.0 };
    let near_pi = (0.5 / (PI - tau).max(1e-2)).max(1.0);
    let steep = match case.tier {
        _ if f <= FRAC_PI_2 - 0.1 => 1.0,
        Tier::Exact => STEEP_FOOT / DEFAULT,
        Tier::Balanced => 10.0 * STEEP_FOOT / 1e-5,
        Tier::Fast => 10.0 * STEEP_FOOT / 5e-5,
    };
    near_pi.max(steep)
}

/// Bound of a profile's exact tier where the profile ends infinitely steep; cheaper tiers have ten
/// times that.
pub const STEEP_FOOT: f64 = 5e-4;

/// A profile's offset, and its fall-off and cut-off measured from there, in order.
fn profile_of(case: &Case, slots: &[InputSlot], numbers: &Numbers) -> Option<[f64; 3]> {
    let at = |name: &str| {
        slots.iter().position(|slot| slot.name == name).map_or(0.0, |index| numbers[index][0])
    };
    (case.node == "profile").then(|| {
        let tau = at("offset").clamp(0.0, PI);
        let c = at("cutoff").clamp(tau, PI);
        [tau, at("falloff").clamp(tau, c) - tau, c - tau]
    })
}

/// True unless a normal, as a LitSphere sees it, points straight away from the viewer, where no
/// side of the rim is nearer.
fn has_rim(case: &Case, slots: &[InputSlot], numbers: &Numbers) -> bool {
    let of =
        |name: &str| slots.iter().position(|slot| slot.name == name).map(|index| &numbers[index]);
    let [Some(normal), Some(view), Some(camera)] = ["normal", "view", "camera"].map(of) else {
        return true;
    };
    let unit = |v: &[f64]| DVec3::from_slice(v).try_normalize().unwrap_or(DVec3::Z);
    let camera = DQuat::from_slice(camera).normalize();
    let view =
        if case.choice("lookup") == "camera" { camera.inverse() * DVec3::Z } else { unit(view) };
    (unit(normal) + view).length() > 1e-3
}
