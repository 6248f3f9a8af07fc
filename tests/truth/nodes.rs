//! Every node of the library on the GPU against f64: at ordinary values, at edges, and finite
//! everywhere. Nodes of the BADF model itself are tested in `badf.rs`. A kind without any test
//! fails the last test.
#![cfg(feature = "gpu")]

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::support::badf::f32_of;
use crate::support::color::{to_linear, to_srgb};
use crate::support::eval::{eval, look};
use crate::support::held::{SampleInputs, library, numeric, run, width, words};
use crate::support::noise::{lattice, noise, pcg3d, unit3};
use crate::support::paint::painted;
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::document::Value;
use chiaro::frame::{EvalSample, SetupLook};
use chiaro::library::{Fallback, Input, Library, NodeDef, Type};
use glam::{DMat3, DVec2, DVec3};
use serde_json::{Value as Json, json};

const MOST: f64 = f32::MAX as f64;

/// The truth of a node: the numbers of one output after another.
type NodeFormula = fn(SampleInputs<'_>) -> Vec<f64>;

fn bounded(x: f64) -> f64 {
    if x.is_nan() { 0.0 } else { x.clamp(-MOST, MOST) }
}

/// `x` rounded to f32, and bounded.
fn bounded_f32(x: f64) -> f64 {
    bounded(f32_of(x))
}

/// A function of one number, for each component of a vector.
fn each(inputs: SampleInputs<'_>, f: impl Fn(f64) -> f64) -> Vec<f64> {
    inputs[0].iter().map(|x| bounded(f(*x))).collect()
}

/// A function of two numbers, component by component; of colors (four components) the first one's
/// alpha stays.
fn pair(inputs: SampleInputs<'_>, f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let (a, b) = (&inputs[0], &inputs[1]);
    let at = |i: usize| if i == 3 { a[3] } else { bounded(f(a[i], b[i.min(b.len() - 1)])) };
    (0..a.len()).map(at).collect()
}

fn rgb(inputs: SampleInputs<'_>, f: impl Fn(f64) -> f64) -> Vec<f64> {
    let c = &inputs[0];
    vec![f(c[0]), f(c[1]), f(c[2]), c[3]]
}

fn v3(numbers: &[f64]) -> DVec3 {
    DVec3::from_slice(numbers)
}

fn unit_or(v: DVec3, otherwise: DVec3) -> DVec3 {
    v.try_normalize().unwrap_or(otherwise)
}

fn modulo(a: f64, b: f64) -> f64 {
    if b == 0.0 { 0.0 } else { a - b * (a / b).floor() }
}

fn power(b: f64, e: f64) -> f64 {
    let is_even = (e * 0.5).floor() == e * 0.5;
    match (b, e) {
        (_, 0.0) => 1.0,
        (0.0, _) => 0.0,
        _ if b < 0.0 && !is_even => -(-b).powf(e),
        _ => b.abs().powf(e),
    }
}

fn ease(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

fn place(x: f64, low: f64, high: f64) -> f64 {
    if low == high { f64::from(u8::from(x >= high)) } else { (x - low) / (high - low) }
}

fn hsv_of([r, g, b]: [f64; 3]) -> [f64; 3] {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let chroma = most - least;
    let hue = if chroma == 0.0 {
        0.0
    } else if most == r {
        modulo((g - b) / chroma, 6.0)
    } else if most == g {
        (b - r) / chroma + 2.0
    } else {
        (r - g) / chroma + 4.0
    };
    [hue / 6.0, if most == 0.0 { 0.0 } else { chroma / most }, most]
}

fn rgb_of([h, s, v]: [f64; 3]) -> [f64; 3] {
    [5.0, 3.0, 1.0].map(|n| {
        let k = modulo(n + h * 6.0, 6.0);
        v - v * s * k.min(4.0 - k).clamp(0.0, 1.0)
    })
}

/// Blend modes of the W3C's Compositing and Blending.
fn mixed_colors(mode: &str, inputs: SampleInputs<'_>) -> Vec<f64> {
    let (a, b, factor) = (&inputs[0], &inputs[1], inputs[2][0].clamp(0.0, 1.0));
    let (under, over) = ([a[0], a[1], a[2]], [b[0], b[1], b[2]]);
    let each = |f: fn(f64, f64) -> f64| [0, 1, 2].map(|k| f(a[k], b[k]));
    let blended = match mode {
        "add" => each(|a, b| a + b),
        "subtract" => each(|a, b| a - b),
        "divide" => each(|a, b| if b == 0.0 { 0.0 } else { a / b }),
        mode => painted(mode, under, over),
    };
    let alpha = if mode == "normal" { (1.0 - factor) * a[3] + factor * b[3] } else { a[3] };
    (0..3).map(|i| (1.0 - factor) * a[i] + factor * blended[i]).chain([alpha]).collect()
}

/// The truth of a kind by its documentation; `None` for kinds with tests of their own.
#[expect(clippy::too_many_lines, reason = "a table: one line a node")]
fn truth(kind: &str, word: &str) -> Option<NodeFormula> {
    Some(match (kind, word) {
        ("absolute", _) => |i| each(i, f64::abs),
        ("negate", _) => |i| each(i, |x| -x),
        ("sign_of", _) => |i| each(i, |x| if x == 0.0 { 0.0 } else { x.signum() }),
        ("mask", _) => |i| {
            let [mask, opacity, density] = [0, 1, 2].map(|k: usize| i[k][0].clamp(0.0, 1.0));
            let hidden = if i[3][0] != 0.0 { mask } else { 1.0 - mask };
            vec![opacity - opacity * density * hidden]
        },
        ("invert", _) => {
            |i| if i[0].len() == 4 { rgb(i, |x| 1.0 - x) } else { each(i, |x| 1.0 - x) }
        }
        ("square_root", _) => |i| each(i, |x| x.max(0.0).sqrt()),
        ("exponential", _) => |i| each(i, f64::exp),
        ("sine", _) => |i| each(i, f64::sin),
        ("cosine", _) => |i| each(i, f64::cos),
        ("tangent_value", _) => |i| each(i, |x| x.tan().clamp(-1e7, 1e7)),
        ("arcsine", _) => |i| each(i, |x| x.clamp(-1.0, 1.0).asin()),
        ("arccosine", _) => |i| each(i, |x| x.clamp(-1.0, 1.0).acos()),
        ("arctangent", _) => |i| vec![i[0][0].atan2(i[1][0])],
        ("fraction", _) => |i| each(i, |x| x - x.floor()),
        ("rounding", "nearest") => |i| each(i, f64::round_ties_even),
        ("rounding", "floor") => |i| each(i, f64::floor),
        ("rounding", "ceiling") => |i| each(i, f64::ceil),
        ("add", _) => |i| pair(i, |a, b| a + b),
        ("subtract", _) => |i| pair(i, |a, b| a - b),
        ("multiply", _) => |i| (0..i[0].len()).map(|k| bounded(i[0][k] * i[1][k])).collect(),
        ("divide", _) => |i| pair(i, |a, b| if b == 0.0 { 0.0 } else { a / b }),
        ("minimum", _) => |i| pair(i, f64::min),
        ("maximum", _) => |i| pair(i, f64::max),
        ("modulo", _) => |i| (0..i[0].len()).map(|k| modulo(i[0][k], i[1][k])).collect(),
        ("power", _) => |i| pair(i, power),
        ("logarithm", _) => |i| {
            let ln = |x: f64| x.max(f64::from(f32::MIN_POSITIVE)).ln();
            vec![if ln(i[1][0]) == 0.0 { 0.0 } else { ln(i[0][0]) / ln(i[1][0]) }]
        },
        ("clamp_range", _) => |i| {
            let clamp = |x: f64| x.max(i[1][0]).min(i[2][0]);
            if i[0].len() == 4 {
                vec![clamp(i[0][0]), clamp(i[0][1]), clamp(i[0][2]), i[0][3].clamp(0.0, 1.0)]
            } else {
                each(i, clamp)
            }
        },
        ("limit_color", _) => |i| {
            let (limit, soft) = (i[1][0].max(0.0), i[2][0].clamp(0.0, 1.0));
            let most = i[0][0].max(i[0][1]).max(i[0][2]);
            let knee = limit * (1.0 - soft);
            let pressed = match (most > knee, limit > knee) {
                (false, _) => most,
                (true, false) => limit,
                // The inverse of 1 / x + 1 / room, from the knee.
                (true, true) => knee + 1.0 / (1.0 / (most - knee) + 1.0 / (limit - knee)),
            };
            let factor = if most > knee { pressed / most } else { 1.0 };
            vec![i[0][0] * factor, i[0][1] * factor, i[0][2] * factor, i[0][3]]
        },
        ("mix_values", _) => |i| {
            let t = if i[3][0] > 0.5 { i[2][0].clamp(0.0, 1.0) } else { i[2][0] };
            (0..i[0].len()).map(|k| (1.0 - t) * i[0][k] + t * i[1][k]).collect()
        },
        ("switch_value", _) => |i| if i[2][0] > 0.5 { i[1].clone() } else { i[0].clone() },
        ("smooth_step_value", _) => {
            |i| each(i, |x| ease(place(x, i[1][0], i[2][0]).clamp(0.0, 1.0)))
        }
        ("map_range", _) => |i| {
            let is_clamped = i[5][0] > 0.5;
            let map = |x: f64| {
                let t = place(x, i[1][0], i[2][0]);
                let t = if is_clamped { t.clamp(0.0, 1.0) } else { t };
                i[3][0] + t * (i[4][0] - i[3][0])
            };
            match i[0].as_slice() {
                [r, g, b, a] => {
                    vec![map(*r), map(*g), map(*b), if is_clamped { a.clamp(0.0, 1.0) } else { *a }]
                }
                _ => each(i, map),
            }
        },
        ("compare", "less") => {
            |i| vec![f64::from(u8::from(bounded_f32(i[0][0] - i[1][0]) < -i[2][0].abs()))]
        }
        ("compare", "greater") => {
            |i| vec![f64::from(u8::from(bounded_f32(i[0][0] - i[1][0]) > i[2][0].abs()))]
        }
        ("compare", "equal") => {
            |i| vec![f64::from(u8::from(bounded_f32(i[0][0] - i[1][0]).abs() <= i[2][0].abs()))]
        }
        ("combine_vector", _) => |i| vec![i[0][0], i[1][0], i[2][0]],
        ("combine_color", _) => |i| vec![i[0][0], i[1][0], i[2][0], i[3][0]],
        ("separate_vector" | "separate_color", _) => |i| i[0].clone(),
        ("number" | "color_value" | "vector_value" | "reroute", _) => |i| i[0].clone(),
        ("cross_product", _) => |i| v3(&i[0]).cross(v3(&i[1])).to_array().to_vec(),
        ("dot_product", _) => |i| vec![v3(&i[0]).dot(v3(&i[1]))],
        ("vector_length", _) => |i| vec![bounded(v3(&i[0]).length())],
        ("vector_distance", _) => |i| vec![bounded(v3(&i[0]).distance(v3(&i[1])))],
        ("normalize_vector", _) => |i| unit_or(v3(&i[0]), DVec3::ZERO).to_array().to_vec(),
        ("project_vector", _) => |i| {
            let d = unit_or(v3(&i[1]), DVec3::ZERO);
            let along = v3(&i[0]).dot(d) * d;
            [along.to_array(), (v3(&i[0]) - along).to_array()].concat()
        },
        ("reflect_vector", _) => |i| {
            let (v, n) = (v3(&i[0]), unit_or(v3(&i[1]), DVec3::ZERO));
            (v - 2.0 * v.dot(n) * n).to_array().to_vec()
        },
        ("refract_vector", _) => |i| {
            // Snell's law by angles: sine inside = ratio * sine outside.
            let (v, n) = (unit_or(v3(&i[0]), DVec3::ZERO), unit_or(v3(&i[1]), DVec3::ZERO));
            let across = v - v.dot(n) * n;
            let sine = i[2][0].max(0.0) * across.length();
            let bent = if sine > 1.0 {
                v - 2.0 * v.dot(n) * n
            } else {
                unit_or(across, DVec3::ZERO) * sine - n * (1.0 - sine * sine).sqrt()
            };
            unit_or(bent, v).to_array().to_vec()
        },
        ("rotate_vector", _) => |i| {
            let axis = unit_or(v3(&i[1]), DVec3::ZERO);
            let turn = DMat3::from_axis_angle(
                if axis == DVec3::ZERO { DVec3::X } else { axis },
                if axis == DVec3::ZERO { 0.0 } else { i[2][0] },
            );
            (turn * v3(&i[0])).to_array().to_vec()
        },
        ("brightness_contrast", _) => {
            |i| rgb(i, |c| i[3][0] + (c - i[3][0]) * (1.0 + i[2][0]) + i[1][0])
        }
        ("color_luminance", _) => |i| vec![0.2126 * i[0][0] + 0.7152 * i[0][1] + 0.0722 * i[0][2]],
        ("color_space", "srgb_to_linear") => |i| rgb(i, to_linear),
        ("color_space", "linear_to_srgb") => |i| rgb(i, to_srgb),
        ("gamma", _) => |i| rgb(i, |c| power(c, i[1][0].max(0.01))),
        ("negative_color", _) => |i| rgb(i, |c| c + i[1][0].clamp(0.0, 1.0) * (1.0 - 2.0 * c)),
        ("set_alpha", _) => |i| vec![i[0][0], i[0][1], i[0][2], i[1][0]],
        ("hsv_adjust", _) => |i| {
            let [h, s, v] = hsv_of([i[0][0], i[0][1], i[0][2]]);
            let shifted = [
                modulo(h + i[1][0] / TAU, 1.0),
                (s * i[2][0].max(0.0)).min(1.0),
                v * i[3][0].max(0.0),
            ];
            rgb_of(shifted).into_iter().chain([i[0][3]]).collect()
        },
        ("mix_colors", mode) => match mode {
            "normal" => |i| mixed_colors("normal", i),
            "multiply" => |i| mixed_colors("multiply", i),
            "screen" => |i| mixed_colors("screen", i),
            "overlay" => |i| mixed_colors("overlay", i),
            "soft_light" => |i| mixed_colors("soft_light", i),
            "hard_light" => |i| mixed_colors("hard_light", i),
            "darken" => |i| mixed_colors("darken", i),
            "lighten" => |i| mixed_colors("lighten", i),
            "add" => |i| mixed_colors("add", i),
            "subtract" => |i| mixed_colors("subtract", i),
            "difference" => |i| mixed_colors("difference", i),
            "divide" => |i| mixed_colors("divide", i),
            _ => return None,
        },
        ("threshold", _) => |i| {
            let d = i[0][0] - i[1][0];
            let soft = i[2][0].max(0.0);
            vec![if soft == 0.0 {
                f64::from(u8::from(d >= 0.0))
            } else {
                (0.5 + d / soft).clamp(0.0, 1.0)
            }]
        },
        ("checker", _) => |i| {
            let squares = (i[0][0] * i[1][0]).floor() + (i[0][1] * i[1][0]).floor();
            if modulo(squares, 2.0) == 0.0 { i[2].clone() } else { i[3].clone() }
        },
        ("gradient", "straight") => |i| {
            let (p, a, b) =
                (DVec2::from_slice(&i[0]), DVec2::from_slice(&i[1]), DVec2::from_slice(&i[2]));
            let line = b - a;
            vec![if line == DVec2::ZERO {
                0.0
            } else {
                ((p - a).dot(line) / line.length_squared()).clamp(0.0, 1.0)
            }]
        },
        ("gradient", "round") => |i| {
            let (p, a, b) =
                (DVec2::from_slice(&i[0]), DVec2::from_slice(&i[1]), DVec2::from_slice(&i[2]));
            vec![if a == b { 0.0 } else { (p.distance(a) / b.distance(a)).min(1.0) }]
        },
        ("gradient", "around") => |i| {
            let (p, a, b) =
                (DVec2::from_slice(&i[0]), DVec2::from_slice(&i[1]), DVec2::from_slice(&i[2]));
            vec![modulo(((p - a).to_angle() - (b - a).to_angle()) / TAU, 1.0)]
        },
        ("transform_uv", _) => |i| {
            let [uv, scale, offset, middle] = [0, 1, 3, 4].map(|k| DVec2::from_slice(&i[k]));
            (DVec2::from_angle(i[2][0]).rotate((uv - middle) * scale) + middle + offset)
                .to_array()
                .to_vec()
        },
        _ => return None,
    })
}

/// Tolerance at ordinary values, relative to numbers above 1.
fn tolerance(kind: &str) -> f64 {
    match kind {
        "power" | "gamma" | "exponential" | "tangent_value" | "logarithm" | "transform_uv" => 3e-6,
        "refract_vector" | "hsv_adjust" | "color_space" => 2e-6,
        _ => 1.5e-6,
    }
}

/// True for discontinuous kinds, of which a sample within rounding of a jump proves nothing.
fn jumps(kind: &str) -> bool {
    matches!(
        kind,
        "fraction"
            | "modulo"
            | "rounding"
            | "compare"
            | "checker"
            | "threshold"
            | "gradient"
            | "sign_of"
            | "mix_colors"
            | "refract_vector"
            | "hsv_adjust"
            | "tangent_value"
            | "smooth_step_value"
            | "map_range"
    )
}

/// Types of the inputs, for each width that a kind has functions for.
fn type_rows(def: &NodeDef) -> Vec<Vec<Type>> {
    let inputs = numeric(def);
    let own: Vec<Type> = inputs.iter().map(|input| input.ty.clone()).collect();
    let mut rows = vec![own.clone()];
    for variant in def.variants.iter().filter(|variant| variant.width.is_some()) {
        let wide = variant.width.clone().unwrap_or(Type::Float);
        if wide.width() == Some(4) && wide != Type::Color {
            continue;
        }
        let mut row = own.clone();
        for parameter in &variant.parameters {
            if let chiaro::library::ArgumentSource::Input(index, ty) = parameter
                && let Some(place) =
                    inputs.iter().position(|input| input.name == def.inputs[*index].name)
            {
                row[place] = ty.clone();
            }
        }
        if !rows.contains(&row) {
            rows.push(row);
        }
    }
    rows
}

fn random_row(types: &[Type], inputs: &[&Input], random: &mut Random) -> Vec<Vec<f64>> {
    let number = |ty: &Type, input: &Input, random: &mut Random| match ty {
        Type::Bool => f64::from(u8::from(random.chance(0.5))),
        Type::Int => random.index(9) as f64,
        Type::Color => f32_of(random.unit()),
        _ if input.unit == "rad" => f32_of(random.between(-7.0, 7.0)),
        _ => f32_of(random.between(-3.0, 3.0)),
    };
    types
        .iter()
        .zip(inputs)
        .map(|(ty, input)| (0..width(ty)).map(|_| number(ty, input, random)).collect())
        .collect()
}

#[test]
fn ordinary_values() {
    let library = library();
    for def in Library::built_in().nodes.values() {
        let inputs = numeric(def);
        for (port, word) in words(def) {
            let Some(truth) = truth(&def.kind, &word) else { continue };
            let choice: &[(&str, &str)] = if word.is_empty() { &[] } else { &[(&port, &word)] };
            let mut errors = Errors::new(format!("{} {word}", def.kind), tolerance(&def.kind));
            for types in type_rows(def) {
                let mut random = Random::new(80);
                let rows: Vec<Vec<Vec<f64>>> =
                    (0..400).map(|_| random_row(&types, &inputs, &mut random)).collect();
                for (got, row) in run(def, choice, &types, &rows, &library).iter().zip(&rows) {
                    let wanted = truth(row);
                    assert_eq!(got.len(), wanted.len(), "{} {types:?}", def.kind);
                    // Near a jump both sides are right; for large powers rounding of the exponent
                    // is multiplied.
                    let shaken: Vec<Vec<f64>> = row
                        .iter()
                        .map(|v| v.iter().map(|x| x * (1.0 + 3e-7) + 1e-7).collect())
                        .collect();
                    let other = truth(&shaken);
                    for ((got, wanted), other) in got.iter().zip(&wanted).zip(&other) {
                        let scale = wanted.abs().max(1.0);
                        let is_steep = (wanted - other).abs() > 1e-5 * scale;
                        if is_steep
                            && (jumps(&def.kind)
                                || matches!(
                                    def.kind.as_str(),
                                    "divide" | "power" | "gamma" | "logarithm" | "normalize_vector"
                                ))
                        {
                            assert!(got.is_finite());
                            continue;
                        }
                        errors.note(got / scale, wanted / scale, || format!("{types:?} {row:?}"));
                    }
                }
            }
            errors.finish();
        }
    }
}

/// Numbers at which arithmetic often fails.
const EDGES: [f64; 17] = [
    0.0, -0.0, 1.0, -1.0, 0.5, 2.0, -2.0, 3.0, -0.5, 1e-40, -1e-40, 1e-20, 1e19, -1e19, 1e30, MOST,
    -MOST,
];

#[test]
fn edges_give_what_is_documented_and_everything_is_finite() {
    let library = library();
    // Kinds whose documentation gives the result of every pair of numbers.
    let exact = [
        "add",
        "subtract",
        "multiply",
        "divide",
        "minimum",
        "maximum",
        "absolute",
        "negate",
        "sign_of",
        "square_root",
        "invert",
        "clamp_range",
        "compare",
        "switch_value",
        "arcsine",
        "arccosine",
    ];
    for def in Library::built_in().nodes.values() {
        let inputs = numeric(def);
        if inputs.is_empty()
            || def.kind == "light"
            || def.inputs.iter().any(|input| input.ty == Type::Hcbtf)
            || inputs.iter().any(|input| input.fallback == Fallback::Wire && def.kind != "reroute")
        {
            continue;
        }
        for (port, word) in words(def) {
            let choice: &[(&str, &str)] = if word.is_empty() { &[] } else { &[(&port, &word)] };
            for types in type_rows(def) {
                let mut random = Random::new(81);
                // Layers and their colors are no maths nodes: the Output clears numbers that leave
                // f32 there.
                let most = if matches!(def.category.as_str(), "curvature" | "layer") {
                    1e12
                } else {
                    MOST
                };
                let edges: Vec<f64> = EDGES.into_iter().filter(|x| x.abs() <= most).collect();
                let mut edge = |ty: &Type| -> Vec<f64> {
                    (0..width(ty))
                        .map(|_| {
                            if *ty == Type::Bool {
                                f64::from(u8::from(random.chance(0.5)))
                            } else {
                                *random.pick(&edges)
                            }
                        })
                        .collect()
                };
                let mut rows: Vec<Vec<Vec<f64>>> =
                    (0..600).map(|_| types.iter().map(&mut edge).collect()).collect();
                if types.len() <= 2 {
                    for a in &edges {
                        for b in &edges {
                            rows.push(
                                types
                                    .iter()
                                    .enumerate()
                                    .map(|(i, ty)| vec![[*a, *b][i]; width(ty)])
                                    .collect(),
                            );
                        }
                    }
                }
                let truth = truth(&def.kind, &word).filter(|_| exact.contains(&def.kind.as_str()));
                for (got, row) in run(def, choice, &types, &rows, &library).iter().zip(&rows) {
                    assert!(
                        got.iter().all(|x| x.is_finite()),
                        "{} {word} {types:?}: {got:?} of {row:?}",
                        def.kind
                    );
                    let Some(truth) = truth else { continue };
                    // The GPU gets numbers in f32, which keeps few digits of a denormal.
                    let held: Vec<Vec<f64>> = row
                        .iter()
                        .map(|v| v.iter().map(|x| f64::from(*x as f32)).collect())
                        .collect();
                    // A denormal may count as 0, also as a divisor.
                    let flushed: Vec<Vec<f64>> = row
                        .iter()
                        .map(|v| v.iter().map(|x| if x.abs() < 1e-38 { 0.0 } else { *x }).collect())
                        .collect();
                    for ((got, a), b) in got.iter().zip(truth(&held)).zip(truth(&flushed)) {
                        let near =
                            |wanted: f64| (got - wanted).abs() <= 1e-6 * wanted.abs().max(1e-30);
                        assert!(
                            near(a) || near(b),
                            "{} {word}: {got} for {a} or {b} of {row:?}",
                            def.kind
                        );
                    }
                }
            }
        }
    }
}

/// Results that the documentation names.
#[test]
fn documented_results() {
    let library = library();
    let one = |kind: &str, inputs: &[f64]| {
        let def = &Library::built_in().nodes[kind];
        let types: Vec<Type> = numeric(def).iter().map(|input| input.ty.clone()).collect();
        run(def, &[], &types, &[inputs.iter().map(|x| vec![*x]).collect()], &library)[0][0]
    };
    for (kind, inputs, wanted) in [
        ("power", vec![-2.0, 2.0], 4.0),
        ("power", vec![-2.0, 3.0], -8.0),
        ("power", vec![-4.0, 0.5], -2.0),
        ("power", vec![0.0, 0.0], 1.0),
        ("power", vec![0.0, -1.0], 0.0),
        ("divide", vec![0.0, 0.0], 0.0),
        ("divide", vec![5.0, 0.0], 0.0),
        ("modulo", vec![-0.25, 1.0], 0.75),
        ("modulo", vec![1.0, 0.0], 0.0),
        ("square_root", vec![-4.0], 0.0),
        ("logarithm", vec![0.0, std::f64::consts::E], -87.336_54),
        ("logarithm", vec![5.0, 1.0], 0.0),
        ("arctangent", vec![0.0, 0.0], 0.0),
        ("arctangent", vec![0.0, -1.0], PI),
        ("arccosine", vec![-2.0], PI),
        ("arcsine", vec![7.0], FRAC_PI_2),
        ("exponential", vec![-200.0], 0.0),
        ("exponential", vec![100.0], MOST),
        ("smooth_step_value", vec![1.0, 1.0, 1.0], 1.0),
        ("smooth_step_value", vec![0.999, 1.0, 1.0], 0.0),
        ("map_range", vec![2.0, 2.0, 2.0, -5.0, 5.0, 1.0], 5.0),
        ("clamp_range", vec![0.3, 2.0, 1.0], 1.0),
    ] {
        let got = one(kind, &inputs);
        assert!(
            (got - wanted).abs() <= 1e-5 * wanted.abs().max(0.1),
            "{kind} of {inputs:?}: {got} for {wanted}"
        );
    }
}

/// Bands are steps of equal width from 0 to 1, flat except for a ramp around each edge, as wide as
/// softness says.
#[test]
fn bands_are_flat() {
    let library = library();
    let def = &Library::built_in().nodes["bands"];
    let types: Vec<Type> = numeric(def).iter().map(|input| input.ty.clone()).collect();
    for (count, softness) in
        [(2, 0.0), (3, 0.0), (5, 0.0), (64, 0.0), (2, 0.5), (3, 1.0), (5, 0.3), (7, 0.85)]
    {
        let n = f64::from(count);
        let rows: Vec<Vec<Vec<f64>>> = (0..=1000)
            .map(|i| vec![vec![f64::from(i) / 1000.0 + 1e-5], vec![n], vec![softness]])
            .collect();
        for (got, row) in run(def, &[], &types, &rows, &library).iter().zip(&rows) {
            let past = |edge: i32| {
                let past = row[0][0] * n - f64::from(edge);
                if softness == 0.0 {
                    f64::from(u8::from(past >= 0.0))
                } else {
                    (0.5 + past / softness).clamp(0.0, 1.0)
                }
            };
            let wanted = (1..count).map(past).sum::<f64>() / (n - 1.0);
            let bound = if softness == 0.0 { 1e-6 } else { 1e-6 / softness };
            assert!((got[0] - wanted).abs() < bound, "{got:?} for {wanted} of {row:?}");
        }
    }
}

// Inputs from the surface

fn surface_sample(random: &mut Random) -> EvalSample {
    let short = |v: DVec3| DVec3::from_array(v.to_array().map(f32_of));
    EvalSample {
        normal: short(random.direction()),
        tangent: Some(short(random.direction())),
        view: short(random.direction()),
        position: short(random.direction() * random.between(0.0, 4.0)),
        camera: DMat3::from_quat(random.rotation()),
        uv: DVec2::new(f32_of(random.between(-2.0, 2.0)), f32_of(random.unit())),
        kappa: f32_of(random.between(-50.0, 50.0)),
        vertex_color: [(); 4].map(|()| f32_of(random.unit())),
        time: f32_of(random.between(0.0, 9.0)),
        ..EvalSample::default()
    }
}

fn surface_truth(kind: &str, word: &str, s: &EvalSample) -> Option<Vec<f64>> {
    let (n, v) = (s.normal.normalize(), s.view.normalize());
    let tangent = s.tangent.unwrap_or(DVec3::X);
    let t = (tangent - n * n.dot(tangent)).normalize();
    let three = |v: DVec3| Some(v.to_array().to_vec());
    match (kind, word) {
        ("normal", _) => three(n),
        ("view", _) => three(v),
        ("mirrored_view", _) => three(2.0 * n.dot(v) * n - v),
        ("camera_normal", _) => three(s.camera * n),
        ("position", "camera") => three(s.camera * s.position),
        ("position", _) => three(s.position),
        ("uv", _) => Some(s.uv.to_array().to_vec()),
        ("vertex_color", _) => Some(s.vertex_color.to_vec()),
        ("tangent_frame", _) => Some([t.to_array(), n.cross(t).to_array(), n.to_array()].concat()),
        ("depth", _) => Some(vec![-(s.camera * s.position).z]),
        ("facing", _) => Some(vec![n.dot(v).clamp(0.0, 1.0)]),
        ("kappa", _) => Some(vec![s.kappa]),
        ("object_id", _) => Some(vec![0.0]),
        ("time", _) => Some(vec![s.time]),
        ("frame", _) => Some(vec![(s.time * 24.0).round()]),
        ("viewport", _) => Some(vec![1.0, 1.0, 1.0]),
        ("transform_direction", "world_of_camera") => three(s.camera.transpose() * n),
        ("transform_direction", _) => three(s.camera * n),
        _ => None,
    }
}

#[test]
fn the_surface_and_the_clock() {
    let mut random = Random::new(82);
    let samples: Vec<EvalSample> = (0..300).map(|_| surface_sample(&mut random)).collect();
    for def in Library::built_in().nodes.values() {
        for (port, word) in words(def) {
            if surface_truth(&def.kind, &word, &samples[0]).is_none() {
                continue;
            }
            let values = if word.is_empty() { json!({}) } else { json!({port: word}) };
            let look = look(&json!({
                "nodes": [
                    {"id": "node", "kind": def.kind, "values": values},
                    {"id": "output", "kind": "output"}
                ],
                "wires": [{"from": "node", "to": "output.color"}]
            }));
            let mut all = vec![Vec::new(); samples.len()];
            for output in &def.outputs {
                for (row, value) in
                    all.iter_mut().zip(eval(&look, &format!("node.{}", output.name), &samples))
                {
                    row.extend(&value[..width(&output.ty)]);
                }
            }
            let mut errors = Errors::new(format!("{} {word}", def.kind), 2e-6);
            for (got, sample) in all.iter().zip(&samples) {
                let wanted = surface_truth(&def.kind, &word, sample).expect("as above");
                assert_eq!(got.len(), wanted.len(), "{}", def.kind);
                for (got, wanted) in got.iter().zip(&wanted) {
                    errors.note(*got, *wanted, || format!("{sample:?}"));
                }
            }
            errors.finish();
        }
    }
}

/// Normal maps lean the normal in its tangent frame; a bump without slope leaves it, and bumps with
/// slopes are tested in `shape_passes.rs`.
#[test]
fn normal_and_bump_maps() {
    let mut random = Random::new(83);
    let samples: Vec<EvalSample> = (0..300).map(|_| surface_sample(&mut random)).collect();
    for (green, sign) in [("up", 1.0), ("down", -1.0)] {
        let look = look(&json!({
            "nodes": [
                {"id": "paint", "kind": "vertex_color"},
                {"id": "node", "kind": "normal_map", "values": {"green": green, "strength": 1.5}},
                {"id": "output", "kind": "output"}
            ],
            "wires": [{"from": "paint", "to": "node.color"}, {"from": "node", "to": "output.color"}]
        }));
        let mut errors = Errors::new(format!("normal_map {green}"), 2e-6);
        for (got, s) in eval(&look, "node.normal", &samples).iter().zip(&samples) {
            let n = s.normal.normalize();
            let t = (s.tangent.unwrap_or(DVec3::X) - n * n.dot(s.tangent.unwrap_or(DVec3::X)))
                .normalize();
            let [x, y, z] = [0, 1, 2].map(|i| 2.0 * s.vertex_color[i] - 1.0);
            let wanted = (1.5 * x * t + 1.5 * sign * y * n.cross(t) + z.max(1e-3) * n).normalize();
            for (got, wanted) in got.iter().zip(wanted.to_array()) {
                errors.note(*got, wanted, || format!("{s:?}"));
            }
        }
        errors.finish();
    }
    let look = look(&json!({
        "nodes": [
            {"id": "paint", "kind": "kappa"},
            {"id": "node", "kind": "bump_map", "values": {"scale": 3}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "paint", "to": "node.height"}, {"from": "node", "to": "output.color"}]
    }));
    for (got, s) in eval(&look, "node.normal", &samples).iter().zip(&samples) {
        assert!((DVec3::from_slice(&got[..3]) - s.normal.normalize()).length() < 1e-6, "{got:?}");
    }
}

// Curves and ramps

/// Hermite's cubic from `y[0]` to `y[1]` over a span, with `slopes` at both ends, at the share `t`
/// of the span.
fn hermite(y: [f64; 2], slopes: [f64; 2], span: f64, t: f64) -> f64 {
    let (t2, t3) = (t * t, t * t * t);
    let bend = span * ((t3 - 2.0 * t2 + t) * slopes[0] + (t3 - t2) * slopes[1]);
    (2.0 * t3 - 3.0 * t2 + 1.0) * y[0] + (3.0 * t2 - 2.0 * t3) * y[1] + bend
}

/// Slope at an inner stop of a smooth ramp: the harmonic mean of the slopes on both sides, weighted
/// by the spans (Fritsch and Butland 1984); 0 where the slopes change sign. At its ends a ramp is
/// level.
fn ramp_slope(xs: &[f64], ys: &[f64], at: usize) -> f64 {
    if at == 0 || at + 1 == xs.len() {
        return 0.0;
    }
    let spans = [xs[at] - xs[at - 1], xs[at + 1] - xs[at]];
    let [before, after] = [(ys[at] - ys[at - 1]) / spans[0], (ys[at + 1] - ys[at]) / spans[1]];
    // Each side's weight is a third of its own span and two thirds of the other's.
    let share = (spans[0] + 2.0 * spans[1]) / (3.0 * (spans[0] + spans[1]));
    if before * after <= 0.0 {
        0.0
    } else {
        before * after / (share * after + (1.0 - share) * before)
    }
}

#[test]
fn curves_and_ramps() {
    let points = [[-1.0, 0.5], [0.0, 0.0], [0.5, 2.0], [1.5, 2.5], [2.0, 2.5], [3.0, -1.0]];
    // Slopes by Fritsch and Butland 1984: the harmonic mean of the slopes on both sides, 0 where
    // they change sign, and at an end the end's own slope. Between 0 and 1.5 the slopes are 4 and
    // 0.5, which makes 8 / 9.
    let slopes = [-0.5, 0.0, 8.0 / 9.0, 0.0, 0.0, -3.5];
    let stops_at = points.map(|[x, _]| x);
    let colors: Vec<[f64; 4]> = points.iter().map(|[x, y]| [*y, 0.1 * x, 0.3, 0.2 * y]).collect();
    let stops: Vec<Json> = points
        .iter()
        .zip(&colors)
        .map(|([x, _], color)| json!({"at": x, "color": color}))
        .collect();
    let xs: Vec<f64> = (0..600).map(|i| f32_of(-2.0 + 0.0101 * f64::from(i))).collect();
    let samples: Vec<EvalSample> =
        xs.iter().map(|x| EvalSample { kappa: *x, ..EvalSample::default() }).collect();
    for word in ["linear", "stepped", "smooth"] {
        let look = look(&json!({
            "nodes": [
                {"id": "place", "kind": "kappa"},
                {
                    "id": "curve", "kind": "curve",
                    "values": {"curve": {"points": points, "interpolation": word}}
                },
                {
                    "id": "ramp", "kind": "ramp",
                    "values": {"ramp": {"stops": stops, "interpolation": word}}
                },
                {"id": "product", "kind": "multiply"},
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "place", "to": "curve.value"}, {"from": "place", "to": "ramp.value"},
                {"from": "ramp", "to": "product.a"}, {"from": "curve", "to": "product.b"},
                {"from": "product", "to": "output.color"}
            ]
        }));
        let (ys, paints) =
            (eval(&look, "curve.value", &samples), eval(&look, "ramp.color", &samples));
        let mut errors = Errors::new(
            format!("curve and ramp, {word}"),
            if word == "smooth" { 3e-6 } else { 1e-6 },
        );
        for ((x, y), paint) in xs.iter().zip(&ys).zip(&paints) {
            let next = points.iter().position(|p| p[0] > *x);
            let (a, b, t) = match next {
                None => (5, 5, 0.0),
                Some(0) => (0, 0, 0.0),
                Some(next) => (
                    next - 1,
                    next,
                    (x - points[next - 1][0]) / (points[next][0] - points[next - 1][0]),
                ),
            };
            if word == "smooth" {
                // The curve is monotone between neighboring points, and goes through its points.
                let (low, high) = (points[a][1].min(points[b][1]), points[a][1].max(points[b][1]));
                assert!(
                    y[0] >= low - 1e-6 && y[0] <= high + 1e-6,
                    "{y:?} at {x} leaves {low} to {high}"
                );
                let span = points[b][0] - points[a][0];
                let wanted = hermite([points[a][1], points[b][1]], [slopes[a], slopes[b]], span, t);
                errors.note(y[0], wanted, || format!("curve at {x}"));
                for (c, got) in paint.iter().enumerate() {
                    let ys = colors.iter().map(|color| color[c]).collect::<Vec<_>>();
                    let slopes = [a, b].map(|at| ramp_slope(&stops_at, &ys, at));
                    errors.note(*got, hermite([ys[a], ys[b]], slopes, span, t), || {
                        format!("ramp at {x}")
                    });
                }
                continue;
            }
            let t = if word == "stepped" { 0.0 } else { t };
            errors.note(y[0], points[a][1] + t * (points[b][1] - points[a][1]), || {
                format!("curve at {x}")
            });
            for (c, got) in paint.iter().enumerate() {
                errors.note(*got, colors[a][c] + t * (colors[b][c] - colors[a][c]), || {
                    format!("ramp at {x}")
                });
            }
        }
        errors.finish();
        if word == "smooth" {
            // Values within the points; outside of them the curve is flat.
            let inside: Vec<_> = xs
                .iter()
                .zip(&ys)
                .filter(|(x, _)| (-0.98..2.98).contains(*x))
                .map(|(_, y)| y)
                .collect();
            let steps: Vec<f64> =
                inside.windows(2).map(|pair| (pair[1][0] - pair[0][0]) / 0.0101).collect();
            let jump = steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
            assert!(jump < 0.6, "the slope jumps by {jump}");
        }
    }
}

// Noise, from integers on

#[test]
fn noises_are_their_lattices() {
    let mut random = Random::new(84);
    let samples: Vec<EvalSample> = (0..800)
        .map(|_| EvalSample {
            position: DVec3::from_array(
                (random.direction() * random.between(0.0, 30.0)).to_array().map(f32_of),
            ),
            ..EvalSample::default()
        })
        .collect();
    for kind in ["value", "perlin", "simplex", "worley"] {
        for (octaves, seed) in [(1, 0), (1, 77), (3, 5)] {
            let look = look(&json!({
                "nodes": [
                    {
                        "id": "node", "kind": "noise",
                        "values": {
                            "kind": kind, "scale": 2, "octaves": octaves, "roughness": 0.5,
                            "seed": seed
                        }
                    },
                    {"id": "output", "kind": "output"}
                ],
                "wires": [{"from": "node", "to": "output.color"}]
            }));
            let mut errors = Errors::new(format!("noise {kind}, {octaves} octaves"), 1e-5);
            for (got, s) in eval(&look, "node.value", &samples).iter().zip(&samples) {
                let (mut sum, mut total, mut strength) = (0.0, 0.0, 1.0);
                for octave in 0..octaves {
                    let shift = f64::from(octave) * DVec3::new(17.31, 5.17, 11.73);
                    let p = 2.0 * s.position * f64::from(1 << octave) + shift;
                    sum += strength * noise(kind, p, (seed + octave) as u32);
                    total += strength;
                    strength *= 0.5;
                }
                errors.note(got[0], sum / total, || format!("{}", s.position));
            }
            errors.finish();
        }
    }
}

/// Border, random number and distance of the cell around a point, by a search of all points up to
/// three cells away.
fn cell(p: DVec3, seed: u32) -> [f64; 3] {
    let home = p.floor().to_array().map(|x| x as i64);
    let steps = || -3..4_i64;
    let all = steps().flat_map(|i| steps().flat_map(move |j| steps().map(move |k| [i, j, k])));
    let point = |at: [i64; 3]| {
        let cell: [i64; 3] = std::array::from_fn(|i| home[i] + at[i]);
        let hash = lattice(cell, seed);
        let place = DVec3::from_array(cell.map(|x| x as f64)) + 0.25 + 0.5 * unit3(hash);
        (place, unit3(pcg3d(hash)).x)
    };
    let points: Vec<(DVec3, f64)> = all.map(point).collect();
    let of = |q: DVec3| {
        points
            .iter()
            .map(move |point| (point.0.distance(q), point))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let (distance, (own, random)) = of(p).unwrap();
    // Distance to the plane half-way to another point, at which both points are equally far.
    let plane = |other: &DVec3| {
        (p.distance_squared(*other) - distance * distance) / (2.0 * own.distance(*other))
    };
    let others = points.iter().map(|point| &point.0).filter(|other| *other != own);
    let border = others.map(plane).fold(f64::INFINITY, f64::min);
    [border.min(0.5 * (1.25 - distance)), *random, distance]
}

#[test]
fn cells_are_around_their_points() {
    let mut random = Random::new(85);
    let samples: Vec<EvalSample> = (0..800)
        .map(|_| EvalSample {
            position: DVec3::from_array(
                (random.direction() * random.between(0.0, 20.0)).to_array().map(f32_of),
            ),
            ..EvalSample::default()
        })
        .collect();
    for seed in [0, 31] {
        let look = look(&json!({
            "nodes": [
                {"id": "node", "kind": "cells", "values": {"scale": 2, "seed": seed}},
                {"id": "output", "kind": "output"}
            ],
            "wires": [{"from": "node.border", "to": "output.color"}]
        }));
        for (index, output) in ["border", "random", "distance"].into_iter().enumerate() {
            let mut errors = Errors::new(format!("cells {output}"), 1e-5);
            for (got, s) in eval(&look, &format!("node.{output}"), &samples).iter().zip(&samples) {
                let expected = cell(2.0 * s.position, seed);
                // At a border the random number of either neighbor is right.
                if index != 1 || expected[0] > 1e-4 {
                    errors.note(got[0], expected[index], || format!("{}", s.position));
                }
            }
            errors.finish();
        }
    }
}

// Pictures

/// A folder with a PNG of 4 x 4 texels, each in a color of its own, and one of 64 x 64 whose colors
/// tell the place.
fn pictures() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, side: u32| {
        let picture = image::RgbaImage::from_fn(side, side, |x, y| image::Rgba(texel(side, x, y)));
        picture.save(folder.path().join(name)).expect("written");
    };
    write("four.png", 4);
    write("ball.png", 64);
    folder
}

fn texel(side: u32, x: u32, y: u32) -> [u8; 4] {
    let scale = 255 / side;
    [(x * scale) as u8, (y * scale) as u8, 100, (255 - 3 * x) as u8]
}

fn with_folder(mut look: SetupLook, folder: &tempfile::TempDir) -> SetupLook {
    look.folder = folder.path().to_path_buf();
    look
}

#[test]
fn images_by_texel() {
    let folder = pictures();
    let mut random = Random::new(85);
    let samples: Vec<EvalSample> = (0..400)
        .map(|_| EvalSample {
            uv: DVec2::new(f32_of(random.between(-2.0, 3.0)), f32_of(random.between(-2.0, 3.0))),
            ..EvalSample::default()
        })
        .collect();
    for wrap in ["repeat", "clamp", "mirror"] {
        for filter in ["nearest", "linear"] {
            let look = look(&json!({
                "nodes": [
                    {
                        "id": "node", "kind": "image",
                        "values": {
                            "image": "four.png", "wrap": wrap, "filter": filter, "encoding": "data"
                        }
                    },
                    {"id": "output", "kind": "output"}
                ],
                "wires": [{"from": "node", "to": "output.color"}]
            }));
            let look = with_folder(look, &folder);
            let at = |i: i64| match wrap {
                "repeat" => i.rem_euclid(4),
                "clamp" => i.clamp(0, 3),
                _ => (i.rem_euclid(8)).min(7 - i.rem_euclid(8)),
            } as u32;
            let fetch = |x: i64, y: i64| texel(4, at(x), at(y)).map(|c| f64::from(c) / 255.0);
            let mut errors = Errors::new(
                format!("image, {wrap}, {filter}"),
                if filter == "nearest" { 1e-6 } else { 4e-3 },
            );
            for (got, s) in eval(&look, "node.color", &samples).iter().zip(&samples) {
                // Coordinates of the image: v goes up, rows go down.
                let p = DVec2::new(s.uv.x, 1.0 - s.uv.y) * 4.0;
                let edge = |x: f64| (x - x.round()).abs() < 1e-5;
                if filter == "nearest" && (edge(p.x) || edge(p.y)) {
                    continue;
                }
                let q = if filter == "nearest" { p.floor() } else { p - 0.5 };
                let (c, f) = (q.floor(), q - q.floor());
                let (x, y) = (c.x as i64, c.y as i64);
                for channel in 0..4 {
                    let [a, b, d, e] =
                        [fetch(x, y), fetch(x + 1, y), fetch(x, y + 1), fetch(x + 1, y + 1)]
                            .map(|c| c[channel]);
                    let wanted = (1.0 - f.y) * ((1.0 - f.x) * a + f.x * b)
                        + f.y * ((1.0 - f.x) * d + f.x * e);
                    errors.note(got[channel], wanted, || format!("{}", s.uv));
                }
            }
            errors.finish();
        }
    }
}

#[test]
fn a_tone_map_is_read_from_left_to_right_and_up() {
    let folder = pictures();
    let look = look(&json!({
        "nodes": [
            {"id": "place", "kind": "position"},
            {"id": "parts", "kind": "separate_vector"},
            {
                "id": "node", "kind": "tone_map",
                "values": {"image": "four.png", "filter": "nearest", "encoding": "data"}
            },
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "place", "to": "parts.vector"},
            {"from": "parts.x", "to": "node.tone"},
            {"from": "parts.y", "to": "node.detail"},
            {"from": "node", "to": "output.color"}
        ]
    }));
    let look = with_folder(look, &folder);
    let places = [-3.0, 0.1, 0.3, 0.6, 0.9, 5.0];
    let texel_of = |x: f64| ((x.clamp(0.0, 1.0) * 4.0) as u32).min(3);
    for detail in places {
        let at = |tone: f64| EvalSample {
            position: DVec3::new(tone, detail, 0.0),
            ..EvalSample::default()
        };
        for (got, tone) in eval(&look, "node.color", &places.map(at)).iter().zip(places) {
            let wanted =
                texel(4, texel_of(tone), 3 - texel_of(detail)).map(|c| f64::from(c) / 255.0);
            assert!(
                got.iter().zip(wanted).all(|(got, wanted)| (got - wanted).abs() < 1e-6),
                "{tone} {detail}: {got:?}"
            );
        }
    }
    // A linear filter mixes the colors of neighboring texels.
    let mut linear = look;
    let node = linear.look.graph.nodes.get_mut("node").expect("as above");
    node.values.insert("filter".into(), Value::Text("linear".into()));
    let mut random = Random::new(87);
    let places: Vec<[f64; 2]> =
        (0..300).map(|_| [(); 2].map(|()| f32_of(random.between(-0.3, 1.3)))).collect();
    let at = |[tone, detail]: &[f64; 2]| EvalSample {
        position: DVec3::new(*tone, *detail, 0.0),
        ..EvalSample::default()
    };
    let samples: Vec<EvalSample> = places.iter().map(at).collect();
    // The filter of a sampler has 8 bits.
    let mut errors = Errors::new("tone map, linear", 4e-3);
    for (got, [tone, detail]) in eval(&linear, "node.color", &samples).iter().zip(&places) {
        let across = (4.0 * tone.clamp(0.0, 1.0) - 0.5).clamp(0.0, 3.0);
        let down = (4.0 * (1.0 - detail.clamp(0.0, 1.0)) - 0.5).clamp(0.0, 3.0);
        // Colors of the texels grow evenly to the right and downwards; their alpha falls to the
        // right.
        let wanted = [63.0 * across, 63.0 * down, 100.0, 255.0 - 3.0 * across].map(|c| c / 255.0);
        for (got, wanted) in got.iter().zip(wanted) {
            errors.note(*got, wanted, || format!("{tone} {detail}"));
        }
    }
    errors.finish();
}

/// A pair of LitSpheres shows one where the surface bulges and the other where it is hollow, each
/// by the normal, mixed by eq. 7.
#[test]
fn a_pair_of_litspheres_is_mixed_by_curvature() {
    let folder = pictures();
    let turned = image::RgbaImage::from_fn(64, 64, |x, y| {
        image::Rgba([250 - 3 * y as u8, 3 * x as u8, 20, 255])
    });
    turned.save(folder.path().join("turned.png")).expect("written");
    let mut random = Random::new(88);
    let samples: Vec<EvalSample> = (0..400).map(|_| surface_sample(&mut random)).collect();
    let look = look(&json!({
        "nodes": [
            {"id": "node", "kind": "litsphere_pair",
                "values": {
                    "convex": "ball.png", "concave": "turned.png", "slope": 0.03, "radius": 0.45
                }},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "node", "to": "output.color"}]
    }));
    let look = with_folder(look, &folder);
    let mut errors = Errors::new("litsphere_pair", 4e-3);
    for (got, s) in eval(&look, "node.color", &samples).iter().zip(&samples) {
        let [x, y] = on_ball(s, "perspective");
        let (convex, concave) = ([3.0 * x, 3.0 * y, 100.0], [250.0 - 3.0 * y, 3.0 * x, 20.0]);
        let convexity = 0.5 + 0.5 * (0.03 * s.kappa).tanh();
        for channel in 0..3 {
            let wanted = convexity * convex[channel] + (1.0 - convexity) * concave[channel];
            errors.note(got[channel], wanted / 255.0, || format!("{s:?}"));
        }
    }
    errors.finish();
}

/// The texel that is looked up in a ball of 64 x 64 with the radius 0.45, from the top left.
fn on_ball(s: &EvalSample, lookup: &str) -> [f64; 2] {
    let n = s.camera * s.normal.normalize();
    let v = if lookup == "camera" { DVec3::Z } else { s.camera * s.view.normalize() };
    // The picture's right is level: at right angles to the line of sight and to the picture's up.
    let right = DVec3::Y.cross(v).normalize();
    let seen = DVec2::new(n.dot(right), n.dot(v.cross(right)));
    let place = if n.dot(v) < 0.0 { seen.normalize() } else { seen } * 0.45;
    let texels = DVec2::new(0.5 + place.x, 0.5 - place.y) * 64.0 - 0.5;
    texels.to_array().map(|x| x.clamp(0.0, 63.0))
}

#[test]
fn litspheres_by_normal() {
    let folder = pictures();
    let mut random = Random::new(86);
    let samples: Vec<EvalSample> = (0..400).map(|_| surface_sample(&mut random)).collect();
    for lookup in ["camera", "perspective"] {
        let look = look(&json!({
            "nodes": [
                {
                    "id": "node", "kind": "litsphere",
                    "values": {
                        "image": "ball.png", "lookup": lookup, "radius": 0.45, "encoding": "data"
                    }
                },
                {"id": "output", "kind": "output"}
            ],
            "wires": [{"from": "node", "to": "output.color"}]
        }));
        let look = with_folder(look, &folder);
        let mut errors = Errors::new(format!("litsphere, {lookup}"), 2e-3);
        for (got, s) in eval(&look, "node.color", &samples).iter().zip(&samples) {
            for (got, texel) in got.iter().zip(on_ball(s, lookup)) {
                errors.note(*got, texel * 3.0 / 255.0, || format!("{s:?}"));
            }
        }
        errors.finish();
    }
}

/// Kinds that are tested by other tests than [`truth`] and [`surface_truth`].
const ELSEWHERE: &[&str] = &[
    // badf.rs
    "base",
    "blend",
    "curvature_color",
    "light",
    "light_apply",
    "light_layer",
    "light_parts",
    "output",
    "parametrization",
    "profile",
    "transition",
    "warp",
    // src/editor/state/stack/tree/tests.rs, against the layers without the folder, in f64
    "folder",
    "pass_through",
    "stack_color",
    // joined_lights.rs
    "fill_layer",
    "first_of_lights",
    "greatest_of_lights",
    "layers_of_lights",
    "light_details",
    "light_from_parts",
    "merged_direction",
    "mix_of_lights",
    "strongest_of_lights",
    "sum_of_lights",
    // tests/render/layered_lights.rs
    "light_in_set",
    "light_number",
    // light_filters.rs
    "barn_doors",
    "blocker",
    "combine_filters",
    "decay",
    "distance_ramp",
    "gobo",
    "lamp_sphere",
    "light_filter",
    "light_place",
    "photometry",
    "rod",
    // shadows.rs
    "cast_shadow",
    "occlusion",
    "self_shadow",
    "shadow",
    "shadow_blocker",
    "shadow_layer",
    // tests/sweeps/hcbtf_lookup.rs
    "constant_size",
    "dominant_light",
    "hcbtf_directions",
    "hcbtf_lookup",
    "hcbtf_nearest",
    "light_by_tone",
    "scatter_uv",
    // family.rs
    "angle_between_directions",
    "axes",
    "combine_tones",
    "detail",
    "fresnel",
    "gooch",
    "half_vector",
    "light_toward",
    "mix_evenly",
    "polar_place",
    "posterize",
    "reflectance",
    "rim",
    "scale_angle",
    "shift_direction",
    "split_direction",
    "square_direction",
    "star_angle",
    "stretch_direction",
    "thin_film",
    "color_curves",
    "exaggerated",
    "inner_contour",
    "local_light",
    "local_tone",
    "nearby",
    "palette",
    "light_warp",
    "radiance_scaling",
    "relief",
    "smooth_normal",
    // outlines.rs
    "outline",
    // hidden_lines.rs
    "hidden_lines",
    // shaped_layers.rs
    "band_layer",
    "halftone_layer",
    "hatching_layer",
    "highlight_layer",
    "ink_layer",
    // shape_passes.rs
    "litsphere_pair",
    "outer_contour",
    // marks.rs
    "brush_strokes",
    "dither",
    "halftone",
    "hatching",
    "mark_place",
    "paper_grain",
    "screen_place",
    "stippling",
    // Tests of their own above.
    "tone_map",
    "bands",
    "bump_map",
    "cells",
    "curve",
    "image",
    "litsphere",
    "noise",
    "normal_map",
    "ramp",
];

/// Every kind has a test.
#[test]
fn every_kind_is_held() {
    // family.rs
    let words_elsewhere = [
        "color_space oklab_to_srgb",
        "color_space srgb_to_oklab",
        "mix_colors color",
        "mix_colors color_burn",
        "mix_colors color_dodge",
        "mix_colors exclusion",
        "mix_colors hue",
        "mix_colors luminosity",
        "mix_colors saturation",
    ];
    let sample = surface_sample(&mut Random::new(87));
    let mut missing = BTreeSet::new();
    for kind in Library::built_in().kinds() {
        let Some(def) = Library::built_in().nodes.get(kind) else {
            if !ELSEWHERE.contains(&kind) {
                missing.insert(kind.to_owned());
            }
            continue;
        };
        for (_, word) in words(def) {
            let is_held =
                truth(kind, &word).is_some() || surface_truth(kind, &word, &sample).is_some();
            let name = format!("{kind} {word}");
            if !is_held && !ELSEWHERE.contains(&kind) && !words_elsewhere.contains(&name.as_str()) {
                missing.insert(name);
            }
        }
    }
    assert!(missing.is_empty(), "nothing holds {missing:?}");
    for kind in ELSEWHERE {
        assert!(
            Library::built_in().kinds().any(|known| known == *kind),
            "there is no `{kind}` any more"
        );
    }
}
