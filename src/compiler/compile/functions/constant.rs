//! Expressions that WGSL computes when a shader is made, where a result that is no number is an
//! error: `1.0 / 0.0` refuses the module, though the same of two parameters is infinite.

use super::code::Code;

/// Functions that give a number for every number, and that naga computes of constants: it has no
/// `mix` and no `select` of literals.
const TOTAL: [&str; 16] = [
    "abs", "bool", "ceil", "clamp", "cos", "f32", "floor", "fract", "i32", "max", "min", "round",
    "sign", "sin", "trunc", "u32",
];

impl Code {
    /// True if a part of it is computed when the shader is made, and may be refused there.
    pub(in crate::compile) fn may_be_refused(&self) -> bool {
        let mut found = false;
        self.each(&mut |code| found |= code.is_constant() && !code.is_number_for_sure());
        found
    }

    /// True if WGSL counts it as a constant expression.
    fn is_constant(&self) -> bool {
        match self {
            Self::Text(..) | Self::Constant(_) => true,
            Self::Argument(text, _) => number(text).is_some() || text.starts_with("vec"),
            Self::Unary(_, of) | Self::Member(of, ..) => of.is_constant(),
            Self::Binary(_, a, b) => a.is_constant() && b.is_constant(),
            Self::BuiltIn(_, parts) => parts.iter().all(Self::is_constant),
            _ => false,
        }
    }

    /// True for a constant expression of which it is clear that it has a value.
    fn is_number_for_sure(&self) -> bool {
        match self {
            // Unsigned integers wrap around.
            Self::Binary("+" | "-" | "*", ..) => {
                self.value().is_some() || self.is_small() || self.is_unsigned()
            }
            Self::Binary("/" | "%", ..) => self.value().is_some(),
            Self::BuiltIn(name, _) => {
                let is_made = ["vec", "mat", "bitcast"].iter().any(|made| name.starts_with(made));
                is_made || TOTAL.contains(&&**name) || self.value().is_some()
            }
            _ => true,
        }
    }

    fn is_unsigned(&self) -> bool {
        let mut found = false;
        self.each(&mut |code| found |= matches!(code, Self::Text(text, _) if text.ends_with('u')));
        found
    }

    /// True if all numbers in it are so small that a few sums and products of them have values.
    fn is_small(&self) -> bool {
        let (mut is_small, mut count) = (true, 0);
        self.each(&mut |code| match code {
            Self::Text(text, _) | Self::Argument(text, _) if !text.starts_with("vec") => {
                is_small &= number(text).is_some_and(|x| x.abs() <= 1e4);
                count += 1;
            }
            Self::BuiltIn(name, _) => is_small &= name.starts_with("vec"),
            Self::Binary("+" | "-" | "*", ..) | Self::Unary(..) | Self::Member(..) => {}
            _ => is_small = false,
        });
        is_small && count <= 8
    }

    /// The value of a constant expression of numbers, where f32 holds it.
    fn value(&self) -> Option<f32> {
        let found = match self {
            Self::Text(text, _) | Self::Argument(text, _) => number(text)?,
            Self::Unary("-", of) => -of.value()?,
            Self::Binary(operator, a, b) => {
                let (a, b) = (a.value()?, b.value()?);
                match *operator {
                    "+" => a + b,
                    "-" => a - b,
                    "*" => a * b,
                    "/" => a / b,
                    _ => return None,
                }
            }
            Self::BuiltIn(name, parts) => {
                let values = parts.iter().map(Self::value).collect::<Option<Vec<f32>>>()?;
                match (&**name, values.as_slice()) {
                    ("sqrt", [x]) => x.sqrt(),
                    ("inverseSqrt", [x]) => 1.0 / x.sqrt(),
                    ("exp", [x]) => x.exp(),
                    ("exp2", [x]) => x.exp2(),
                    ("log", [x]) => x.ln(),
                    ("log2", [x]) => x.log2(),
                    ("sin", [x]) => x.sin(),
                    ("cos", [x]) => x.cos(),
                    ("pow", [x, y]) => x.powf(*y),
                    ("abs", [x]) => x.abs(),
                    ("min", [x, y]) => x.min(*y),
                    ("max", [x, y]) => x.max(*y),
                    ("f32" | "i32" | "u32", [x]) => *x,
                    _ => return None,
                }
            }
            _ => return None,
        };
        found.is_finite().then_some(found)
    }
}

fn number(text: &str) -> Option<f32> {
    text.trim_end_matches(['i', 'u']).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_wgsl_would_refuse_is_found() {
        let number = |text: &str| Box::new(Code::number(text));
        let by = |a, b| Code::Binary("/", a, b);
        assert!(by(number("1.0"), number("0.0")).may_be_refused());
        assert!(!by(number("1.0"), number("3.0")).may_be_refused());
        assert!(!by(number("1.0"), Box::new(Code::Parameter(0))).may_be_refused());
        assert!(Code::BuiltIn("log".into(), vec![Code::number("0.0")]).may_be_refused());
        assert!(!Code::BuiltIn("vec2f".into(), vec![Code::number("0.0")]).may_be_refused());
        let ends = ["0.0", "0.7", "0.2"].map(Code::number).to_vec();
        assert!(Code::BuiltIn("mix".into(), ends).may_be_refused());
        let inner = by(number("1.0"), number("0.0"));
        assert!(Code::BuiltIn("min".into(), vec![inner, Code::Parameter(0)]).may_be_refused());
    }
}
