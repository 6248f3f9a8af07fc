//! Functions of the shader library of which intervals alone would learn too little: those that work
//! on the bits of a float, and those whose operands hang together, as the sine and the cosine of
//! one angle do. A function goes by its name only where its text is the library's own, and the
//! tests run each of them against the interpreter.

use super::machine::Ranges;
use super::range::{ALMOST_INFINITE as LARGEST, Bools, Floats, Length, Range};

/// The error bound of the library's polynomials, and of the roundings of a unit vector.
const SLACK: f64 = 2e-6;

/// A quarter turn, with its rounding.
const QUARTER: f64 = std::f64::consts::FRAC_PI_2 + SLACK;

/// The functions that [`result`] knows.
pub(super) const NAMES: &[&str] = &[
    "bounded",
    "bounded_vec2",
    "bounded_vec3",
    "bounded_vec4",
    "finite_vec3",
    "finite_vec4",
    "is_finite",
    "finite_or",
    "normalize_or",
    "exp2_stable",
    "log2_stable",
    "log_stable",
    "log1p_negative",
    "sin_cos_quarter",
    "sin_cos",
    "sine_of",
    "cosine_of",
    "angle_between",
    "angle_of",
    "atan2_positive",
];

/// The ranges of a library function's result; `None` for a function that is not known here.
pub(super) fn result(name: &str, arguments: &[Ranges]) -> Option<Ranges> {
    if !NAMES.contains(&name) {
        return None;
    }
    let mut floats = Vec::new();
    for range in arguments.iter().flat_map(|ranges| ranges.iter()) {
        let Range::Float(x) = range else { return None };
        floats.push(*x);
    }
    let result = match (name, floats.as_slice()) {
        ("bounded", [x]) => vec![bounded(*x)],
        ("bounded_vec2" | "bounded_vec3" | "bounded_vec4", all) => {
            all.iter().map(|x| bounded(*x)).collect()
        }
        ("finite_vec3" | "finite_vec4", all) => {
            all.iter().map(|x| finite_or(*x, Floats::ZERO)).collect()
        }
        ("is_finite", [x]) => return Some([Range::Bool(is_finite(*x))].into()),
        ("finite_or", [x, otherwise]) => vec![finite_or(*x, *otherwise)],
        ("normalize_or", [x, y, z, otherwise @ ..]) => normalized([*x, *y, *z], otherwise),
        ("exp2_stable", [x]) => {
            let limits = [0.0, LARGEST];
            let x = if x.nan { Floats::ALL } else { *x };
            vec![inside(x, -150.0, 128.0).smooth(f64::exp2, 1e-5, 1e-38, limits).with_nan(x.nan)]
        }
        // Meant for normal numbers above 0.
        ("log2_stable" | "log_stable", [x])
            if !x.nan && x.low >= 0.999 * f64::from(f32::MIN_POSITIVE) && x.high <= LARGEST =>
        {
            let log = if name == "log_stable" { f64::ln } else { f64::log2 };
            vec![x.smooth(log, 1e-5, 1e-5, [-1e3, 1e3])]
        }
        ("log2_stable" | "log_stable", [_]) => vec![Floats::ALL],
        ("log1p_negative", [y]) if y.is_within(0.0, 1.0) => vec![Floats::between(-88.0, 0.0)],
        ("log1p_negative", [_]) => vec![Floats::ALL],
        ("sin_cos_quarter", [x]) if x.is_within(-QUARTER, QUARTER) => quarter(*x),
        ("sine_of" | "cosine_of", [_]) => {
            vec![Floats { minus_zero: true, ..Floats::between(-1.0, 1.0) }]
        }
        ("sin_cos", [x]) if x.is_within(-1e5, 1e5) => {
            vec![Floats::between(-1.0 - SLACK, 1.0 + SLACK); 2]
        }
        ("sin_cos_quarter" | "sin_cos", _) => vec![Floats::ALL; 2],
        ("angle_between", [..]) => angle_between(&floats),
        ("angle_of", [_]) => {
            vec![Floats { minus_zero: false, ..Floats::between(0.0, 1.0 + SLACK) }; 2]
        }
        ("atan2_positive", [y, x]) if y.low >= 0.0 && x.low >= 0.0 => {
            let nan = y.nan || x.nan || (y.may_be_infinite() || x.may_be_infinite());
            vec![Floats::between(0.0, std::f64::consts::FRAC_PI_2 + SLACK).with_nan(nan)]
        }
        ("atan2_positive", _) => vec![Floats::ALL],
        _ => return None,
    };
    Some(result.into_iter().map(|x| Range::Float(either_zero(x))).collect())
}

/// The signs of zeros are not followed here, but for ranges that are exactly 0 or have none.
fn either_zero(x: Floats) -> Floats {
    Floats { minus_zero: x.minus_zero || (x.low != x.high && x.has(0.0)), ..x }
}

fn inside(x: Floats, low: f64, high: f64) -> Floats {
    if x.is_none() {
        return Floats { nan: x.nan, ..Floats::between(low, high) };
    }
    Floats { low: x.low.clamp(low, high), high: x.high.clamp(low, high), length: Length::Any, ..x }
}

fn bounded(x: Floats) -> Floats {
    let single = f64::from(f32::MAX);
    let low = x.low.clamp(-LARGEST, single);
    let numbers = Floats { low, high: x.high.clamp(-single, LARGEST), nan: false, ..x };
    match (x.nan, x.is_none()) {
        (true, true) => Floats::ZERO,
        (true, false) => numbers.join(Floats::ZERO),
        (false, _) => numbers,
    }
}

fn is_finite(x: Floats) -> Bools {
    Bools {
        may_be_false: x.nan || x.may_be_infinite() || x.low > LARGEST || x.high < -LARGEST,
        may_be_true: !x.is_none() && x.low <= LARGEST && x.high >= -LARGEST,
    }
}

fn finite_or(x: Floats, otherwise: Floats) -> Floats {
    let known = is_finite(x);
    let numbers = Floats { nan: false, ..inside(x, -LARGEST, LARGEST) };
    match (known.may_be_true, known.may_be_false) {
        (true, true) => numbers.join(otherwise),
        (true, false) => numbers,
        _ => otherwise,
    }
}

fn normalized(v: [Floats; 3], otherwise: &[Floats]) -> Vec<Floats> {
    let unit = Floats::between(-1.0 - SLACK, 1.0 + SLACK);
    // Long enough, whatever it is: the fallback does not matter then.
    let is_long = v.iter().any(|x| !x.nan && (x.low > 1e-29 || x.high < -1e-29))
        && v.iter().all(|x| x.is_within(-1e29, 1e29));
    // A vector that has a length comes to 1.
    let length = [0, 1, 2].map(|i| v[i].squared());
    let length = length[0].add(length[1]).add(length[2]);
    let is_long = is_long
        || (v.iter().all(|x| x.is_within(-1e14, 1e14)) && length.low > 1e-28)
        || v.iter().all(|x| x.length == Length::One && !x.nan);
    let each = v.iter().zip(otherwise);
    each.map(|(x, otherwise)| {
        // A component keeps its sign.
        let own = Floats {
            low: if x.low >= 0.0 { 0.0 } else { unit.low },
            high: if x.high <= 0.0 { 0.0 } else { unit.high },
            nan: false,
            minus_zero: true,
            length: Length::One,
        };
        if is_long { own } else { own.join(*otherwise) }
    })
    .collect()
}

fn quarter(x: Floats) -> Vec<Floats> {
    if x.low == 0.0 && x.high == 0.0 {
        return vec![x, Floats::constant(1.0)];
    }
    let sin = x.smooth(f64::sin, 1e-5, SLACK, [-1.0 - SLACK, 1.0 + SLACK]);
    let size = x.abs();
    let cos = Floats::between(size.high.cos() - SLACK, size.low.cos() + SLACK);
    vec![sin, cos]
}

/// The sine and cosine of half an angle, from two chords: in [0, 1], or NaN where a direction is
/// none.
fn angle_between(directions: &[Floats]) -> Vec<Floats> {
    let is_plain = directions.iter().all(|x| x.is_within(-1e15, 1e15));
    let unit = Floats { minus_zero: false, ..Floats::between(0.0, 1.0 + SLACK) };
    if is_plain { vec![unit; 2] } else { vec![Floats { minus_zero: true, ..Floats::ALL }; 2] }
}
