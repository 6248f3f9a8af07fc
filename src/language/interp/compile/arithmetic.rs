//! Evaluator of the text of a constant expression over numbers, in f64 and as WGSL's types round
//! it.
//!
//! The evaluator knows decimal and hexadecimal literals, `+ - * /`, signs, brackets, names of
//! constants, and the functions that naga folds. Any other syntax makes a text unreadable, which is
//! no error.

use std::collections::HashMap;

/// Greatest nesting of brackets and signs.
const MAX_DEPTH: u32 = 64;

/// Number at compile time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ConstantNumber {
    /// WGSL's `AbstractInt`.
    Int(i64),
    /// WGSL's `AbstractFloat`, an f64.
    Abstract(f64),
    /// An f32, and its value without any rounding.
    Single { single: f32, wide: f64 },
}

impl ConstantNumber {
    /// Value without any rounding to f32.
    pub(super) fn wide(self) -> f64 {
        match self {
            Self::Int(x) => x as f64,
            Self::Abstract(x) => x,
            Self::Single { wide, .. } => wide,
        }
    }

    fn as_f32(self) -> f32 {
        match self {
            Self::Single { single, .. } => single,
            other => other.wide() as f32,
        }
    }

    /// Number converted to f32.
    pub(super) fn single(self) -> Self {
        Self::Single { single: self.as_f32(), wide: self.wide() }
    }

    /// True if naga makes this f32 of the number.
    pub(super) fn agrees_with(self, single: f32) -> bool {
        self.as_f32().to_bits() == single.to_bits()
    }

    /// Applies an operation, which is given for both kinds of floats.
    fn with(self, wide: impl Fn(f64) -> f64, single: impl Fn(f32) -> f32) -> Self {
        match self {
            Self::Single { single: x, wide: w } => {
                Self::Single { single: single(x), wide: wide(w) }
            }
            other => Self::Abstract(wide(other.wide())),
        }
    }

    fn join(
        self,
        other: Self,
        wide: impl Fn(f64, f64) -> f64,
        single: impl Fn(f32, f32) -> f32,
    ) -> Self {
        match (self, other) {
            (Self::Single { .. }, _) | (_, Self::Single { .. }) => Self::Single {
                single: single(self.as_f32(), other.as_f32()),
                wide: wide(self.wide(), other.wide()),
            },
            _ => Self::Abstract(wide(self.wide(), other.wide())),
        }
    }

    fn operate(self, operator: u8, other: Self) -> Option<Self> {
        if let (Self::Int(a), Self::Int(b)) = (self, other) {
            return Some(Self::Int(match operator {
                b'+' => a.checked_add(b)?,
                b'-' => a.checked_sub(b)?,
                b'*' => a.checked_mul(b)?,
                _ => a.checked_div(b)?,
            }));
        }
        Some(match operator {
            b'+' => self.join(other, |a, b| a + b, |a, b| a + b),
            b'-' => self.join(other, |a, b| a - b, |a, b| a - b),
            b'*' => self.join(other, |a, b| a * b, |a, b| a * b),
            _ => self.join(other, |a, b| a / b, |a, b| a / b),
        })
    }

    fn negate(self) -> Option<Self> {
        match self {
            Self::Int(x) => x.checked_neg().map(Self::Int),
            other => Some(other.with(|x| -x, |x| -x)),
        }
    }
}

/// Number that a text denotes, given the constants that it may name.
pub(super) fn evaluate(
    text: &str,
    constants: &HashMap<String, ConstantNumber>,
) -> Option<ConstantNumber> {
    let mut reader = Reader { rest: text, constants, depth: 0 };
    let number = reader.sum()?;
    reader.skip_space();
    reader.rest.is_empty().then_some(number)
}

struct Reader<'t> {
    rest: &'t str,
    constants: &'t HashMap<String, ConstantNumber>,
    depth: u32,
}

impl<'t> Reader<'t> {
    fn skip_space(&mut self) {
        self.rest = self.rest.trim_start();
    }

    /// Next byte that is no space.
    fn peek(&mut self) -> Option<u8> {
        self.skip_space();
        self.rest.bytes().next()
    }

    /// Takes an ASCII byte if it is next.
    fn take(&mut self, byte: u8) -> bool {
        let is_next = self.peek() == Some(byte);
        if is_next {
            self.rest = &self.rest[1..];
        }
        is_next
    }

    /// Takes all bytes at the front that fulfil a condition, which only ASCII does.
    fn take_while(&mut self, mut condition: impl FnMut(u8) -> bool) -> &'t str {
        let end = self
            .rest
            .bytes()
            .position(|b| !b.is_ascii() || !condition(b))
            .unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    fn sum(&mut self) -> Option<ConstantNumber> {
        let mut left = self.product()?;
        while let Some(operator @ (b'+' | b'-')) = self.peek() {
            self.rest = &self.rest[1..];
            left = left.operate(operator, self.product()?)?;
        }
        Some(left)
    }

    fn product(&mut self) -> Option<ConstantNumber> {
        let mut left = self.signed()?;
        while let Some(operator @ (b'*' | b'/')) = self.peek() {
            self.rest = &self.rest[1..];
            left = left.operate(operator, self.signed()?)?;
        }
        Some(left)
    }

    fn signed(&mut self) -> Option<ConstantNumber> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return None;
        }
        let number = if self.take(b'-') { self.signed()?.negate() } else { self.atom() };
        self.depth -= 1;
        number
    }

    fn atom(&mut self) -> Option<ConstantNumber> {
        match self.peek()? {
            b'(' => {
                self.take(b'(');
                let number = self.sum()?;
                self.take(b')').then_some(number)
            }
            b'0'..=b'9' | b'.' => self.literal(),
            b if b.is_ascii_alphabetic() || b == b'_' => {
                let name = self.take_while(|b| b.is_ascii_alphanumeric() || b == b'_');
                if self.peek() == Some(b'(') {
                    self.call(name)
                } else {
                    self.constants.get(name).copied()
                }
            }
            _ => None,
        }
    }

    fn call(&mut self, name: &str) -> Option<ConstantNumber> {
        self.take(b'(');
        let mut arguments = vec![self.sum()?];
        while self.take(b',') && self.peek()? != b')' {
            arguments.push(self.sum()?);
        }
        if !self.take(b')') {
            return None;
        }
        match *arguments.as_slice() {
            [a] => of_one(name, a),
            [a, b] => of_two(name, a, b),
            _ => None,
        }
    }

    fn literal(&mut self) -> Option<ConstantNumber> {
        if self.rest.starts_with("0x") || self.rest.starts_with("0X") {
            return self.hexadecimal();
        }
        let mut before = 0;
        let text = self.take_while(|b| {
            let is_sign = matches!(b, b'+' | b'-') && matches!(before, b'e' | b'E');
            before = b;
            is_sign || matches!(b, b'0'..=b'9' | b'.' | b'e' | b'E')
        });
        let is_int = text.bytes().all(|b| b.is_ascii_digit());
        match self.take_while(|b| b.is_ascii_alphanumeric() || b == b'_') {
            "" if is_int => text.parse().ok().map(ConstantNumber::Int),
            "" => text.parse().ok().map(ConstantNumber::Abstract),
            "f" => Some(ConstantNumber::Abstract(text.parse().ok()?).single()),
            _ => None,
        }
    }

    /// Reads `0x1F`, `0x1.8p3`, each with an f at the end if it is a float of WGSL's f32 (only
    /// after an exponent).
    fn hexadecimal(&mut self) -> Option<ConstantNumber> {
        self.rest = &self.rest[2..];
        let whole = self.take_while(|b| b.is_ascii_hexdigit());
        let fraction = if self.rest.starts_with('.') {
            self.rest = &self.rest[1..];
            self.take_while(|b| b.is_ascii_hexdigit())
        } else {
            ""
        };
        let digits = i64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
        if !self.rest.starts_with(['p', 'P']) {
            let ends = !self.rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
            return (fraction.is_empty() && ends).then_some(ConstantNumber::Int(digits));
        }
        self.rest = &self.rest[1..];
        let mut is_first = true;
        let exponent = self.take_while(|b| {
            let fits = b.is_ascii_digit() || is_first && matches!(b, b'+' | b'-');
            is_first = false;
            fits
        });
        let exponent = exponent.parse::<i32>().ok()?.clamp(-2000, 2000) - 4 * fraction.len() as i32;
        let number = ConstantNumber::Abstract(digits as f64 * f64::from(exponent).exp2());
        match self.take_while(|b| b.is_ascii_alphanumeric() || b == b'_') {
            "" => Some(number),
            "f" => Some(number.single()),
            _ => None,
        }
    }
}

fn of_one(name: &str, a: ConstantNumber) -> Option<ConstantNumber> {
    macro_rules! float {
        ($($name:literal => $function:ident,)*) => {
            match name {
                // A vector of equal components is treated as its component.
                "f32" | "vec2f" | "vec3f" | "vec4f" => Some(a.single()),
                $($name => Some(a.with(f64::$function, f32::$function)),)*
                _ => None,
            }
        };
    }
    float! {
        "abs" => abs, "sqrt" => sqrt, "exp" => exp, "exp2" => exp2, "log" => ln, "log2" => log2,
        "sin" => sin, "cos" => cos, "tan" => tan, "asin" => asin, "acos" => acos, "atan" => atan,
        "radians" => to_radians, "degrees" => to_degrees, "floor" => floor, "ceil" => ceil,
    }
}

fn of_two(name: &str, a: ConstantNumber, b: ConstantNumber) -> Option<ConstantNumber> {
    match name {
        "pow" => Some(a.join(b, f64::powf, f32::powf)),
        "min" => Some(a.join(b, f64::min, f32::min)),
        "max" => Some(a.join(b, f64::max, f32::max)),
        "atan2" => Some(a.join(b, f64::atan2, f32::atan2)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wide(text: &str) -> Option<f64> {
        let constants = HashMap::from([
            ("PI".to_owned(), ConstantNumber::Abstract(3.25).single()),
            ("THIRD".to_owned(), ConstantNumber::Abstract(1.0 / 3.0).single()),
        ]);
        evaluate(text, &constants).map(ConstantNumber::wide)
    }

    #[test]
    fn arithmetic_has_wgsls_precedence() {
        assert_eq!(wide("1.5 + 2 * 3.0 - -(4.0) / 8.0"), Some(8.0));
        assert_eq!(wide(" 2.0 - 1.0 - 0.5"), Some(0.5));
        assert_eq!(wide("7 / 2 + 0.25"), Some(3.25));
        assert_eq!(wide("-2.0 * PI"), Some(-6.5));
        assert_eq!(wide("THIRD * 3.0"), Some(1.0));
        assert_eq!(wide("sqrt(2.0) * max(2.0, 1.0,)"), Some(2.0_f64.sqrt() * 2.0));
    }

    #[test]
    fn literals_of_all_forms() {
        for (text, x) in [
            ("1e-7", 1e-7),
            (".5", 0.5),
            ("5.", 5.0),
            ("2.5E+3f", 2500.0),
            ("12f", 12.0),
            ("0x1F", 31.0),
        ] {
            assert_eq!(wide(text), Some(x), "{text}");
        }
        assert_eq!(wide("0x1.8p3"), Some(12.0));
        assert_eq!(wide("0X.8p-1f"), Some(0.25));
    }

    #[test]
    fn what_is_not_understood_is_no_number() {
        for text in [
            "",
            "1.0 +",
            "TAU",
            "f(1.0)",
            "1u",
            "1.0h",
            "(1.0",
            "1.0)",
            "1 / 0",
            "a[1]",
            "1.0 // one",
            "é",
            "0x",
            "1.0e",
        ] {
            assert_eq!(wide(text), None, "{text}");
        }
        assert_eq!(wide(&("(".repeat(100_000) + "1.0")), None);
        assert_eq!(wide(&("-".repeat(100_000) + "1.0")), None);
    }

    #[test]
    fn naga_is_agreed_with_where_its_rounding_is_followed() {
        let constants =
            HashMap::from([("THIRD".to_owned(), ConstantNumber::Abstract(1.0 / 3.0).single())]);
        let third = 1.0_f32 / 3.0;
        let number = evaluate("THIRD * 0.1 / 7.0", &constants).unwrap();
        assert!(number.agrees_with(third * 0.1 / 7.0));
        assert_eq!(number.wide(), 1.0 / 3.0 * 0.1 / 7.0);
        assert!(!evaluate("0.5", &constants).unwrap().agrees_with(0.25));
    }
}
