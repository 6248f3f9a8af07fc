//! Operations: functions of WGSL as nodes of MaterialX, and those nodes on known numbers.

use naga::MathFunction as Math;

/// The node for a function that works on each number by itself, its arguments in the same order.
pub(super) fn node_of(function: Math) -> Option<&'static str> {
    Some(match function {
        Math::Abs => "absval",
        Math::Min => "min",
        Math::Max => "max",
        Math::Clamp => "clamp",
        Math::Cos => "cos",
        Math::Sin => "sin",
        Math::Tan => "tan",
        Math::Acos => "acos",
        Math::Asin => "asin",
        Math::Atan2 => "atan2",
        Math::Ceil => "ceil",
        Math::Floor => "floor",
        Math::Round => "round",
        Math::Fract => "fract",
        Math::Exp => "exp",
        Math::Log => "ln",
        Math::Pow => "power",
        Math::Sign => "sign",
        Math::Sqrt => "sqrt",
        _ => return None,
    })
}

/// Names of a node's inputs, in the order of its sources.
pub(super) fn inputs_of(kind: &str, sources: usize) -> &'static [&'static str] {
    match (kind, sources) {
        ("clamp" | "smoothstep", _) => &["in", "low", "high"],
        ("mix", _) => &["fg", "bg", "mix"],
        ("atan2", _) => &["iny", "inx"],
        ("ifgreater" | "ifgreatereq" | "ifequal", 4) => &["value1", "value2", "in1", "in2"],
        // The value of a switch is compared with true.
        ("ifequal", _) => &["value1", "in1", "in2"],
        (_, 1) => &["in"],
        _ => &["in1", "in2", "in3", "in4"],
    }
}

/// A node's result of known numbers; `None` for nodes that are not calculated here.
pub(super) fn fold(kind: &str, sources: &[Vec<f64>]) -> Option<Vec<f64>> {
    let width = sources.iter().map(Vec::len).max()?;
    let each = |function: &dyn Fn(&[f64]) -> f64| {
        let at = |place: usize| {
            let numbers: Vec<f64> =
                sources.iter().map(|source| source[place.min(source.len() - 1)]).collect();
            function(&numbers)
        };
        Some((0..width).map(at).collect::<Vec<f64>>())
    };
    let found = match kind {
        "add" => each(&|x| x[0] + x[1]),
        "subtract" => each(&|x| x[0] - x[1]),
        "multiply" => each(&|x| x[0] * x[1]),
        "divide" => each(&|x| x[0] / x[1]),
        "modulo" => each(&|x| x[0] - x[1] * (x[0] / x[1]).floor()),
        "min" => each(&|x| x[0].min(x[1])),
        "max" => each(&|x| x[0].max(x[1])),
        "power" => each(&|x| x[0].powf(x[1])),
        "atan2" => each(&|x| x[0].atan2(x[1])),
        "clamp" => each(&|x| x[0].max(x[1]).min(x[2])),
        "mix" => each(&|x| x[0] * x[2] + x[1] * (1.0 - x[2])),
        "smoothstep" => each(&|x| {
            let t = ((x[0] - x[1]) / (x[2] - x[1])).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        }),
        "absval" => each(&|x| x[0].abs()),
        "sign" => each(&|x| if x[0] == 0.0 { 0.0 } else { x[0].signum() }),
        "floor" => each(&|x| x[0].floor()),
        "ceil" => each(&|x| x[0].ceil()),
        "round" => each(&|x| x[0].round_ties_even()),
        "fract" => each(&|x| x[0] - x[0].floor()),
        "sin" => each(&|x| x[0].sin()),
        "cos" => each(&|x| x[0].cos()),
        "tan" => each(&|x| x[0].tan()),
        "asin" => each(&|x| x[0].asin()),
        "acos" => each(&|x| x[0].acos()),
        "sqrt" => each(&|x| x[0].sqrt()),
        "ln" => each(&|x| x[0].ln()),
        "exp" => each(&|x| x[0].exp()),
        "dotproduct" => Some(vec![dot(&sources[0], &sources[1])]),
        "magnitude" => Some(vec![dot(&sources[0], &sources[0]).sqrt()]),
        "normalize" => {
            let length = dot(&sources[0], &sources[0]).sqrt();
            Some(sources[0].iter().map(|x| x / length).collect())
        }
        "crossproduct" => {
            let (a, b) = (&sources[0], &sources[1]);
            let at = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
            Some(vec![at(1, 2), at(2, 0), at(0, 1)])
        }
        _ => None,
    };
    found.filter(|numbers| numbers.iter().all(|x| x.is_finite()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_numbers_are_calculated() {
        let cross = fold("crossproduct", &[vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0]]);
        assert_eq!(cross, Some(vec![0.0, 0.0, 1.0]));
        let product = fold("multiply", &[vec![1.0, 2.0], vec![3.0]]);
        assert_eq!(product, Some(vec![3.0, 6.0]));
        assert_eq!(fold("mix", &[vec![4.0], vec![2.0], vec![0.25]]), Some(vec![2.5]));
        assert_eq!(fold("modulo", &[vec![-1.0], vec![3.0]]), Some(vec![2.0]));
        // What has no value is left to the host.
        assert_eq!(fold("divide", &[vec![1.0], vec![0.0]]), None);
    }
}
