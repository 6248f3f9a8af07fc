//! Functions that naga adds for operations on integers, in a form that every compiler takes.
//!
//! They guard against what HLSL leaves open: a division by 0, and the least integer's sign. naga
//! writes the guards as choices, for vectors too, which HLSL 2021 refuses.

/// The text with guards that are no choices between vectors.
pub(super) fn with_plain_helpers(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    // Type of the vectors that a helper takes.
    let mut vector = None;
    for line in text.lines() {
        if !line.starts_with([' ', '{']) {
            vector = vector_of(line);
        }
        let guarded = vector.and_then(|ty| with_sum(line, ty));
        let line = guarded.unwrap_or_else(|| line.to_owned());
        // slangc writes the minus before an unsigned number into WGSL, which has none.
        let line = line
            .replace("val >= 0 ? val : asint(-asuint(val))", "max(val, asint(0u - asuint(val)))")
            .replace("asint(-asuint(", "asint(0u - asuint(")
            .replace("(rhs == 0u ? 1u : rhs)", "max(rhs, 1u)");
        result.push_str(&line);
        result.push('\n');
    }
    result
}

/// `int2` of the head `int2 naga_div(int2 lhs, int2 rhs) {`.
fn vector_of(line: &str) -> Option<&str> {
    let (ty, rest) = line.split_once(' ')?;
    let is_helper = rest.starts_with("naga_div(") || rest.starts_with("naga_mod(");
    (is_helper && ty.ends_with(|c: char| c.is_ascii_digit())).then_some(ty)
}

/// A line with `rhs + (1 - rhs) * int2(GUARD)` for `GUARD ? 1 : rhs`; `None` for other lines.
fn with_sum(line: &str, ty: &str) -> Option<String> {
    let (before, after) = line.split_once(" ? 1 : rhs")?;
    let (start, guard) = before.split_at(before.find("((lhs == ")?);
    Some(format!("{start}rhs + (1 - rhs) * {ty}{guard}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guards_of_vectors_are_no_choices() {
        let text = "\
int2 naga_abs(int2 val) {
    return val >= 0 ? val : asint(-asuint(val));
}

int2 naga_div(int2 lhs, int2 rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

uint3 naga_mod(uint3 lhs, uint3 rhs) {
    return lhs % (rhs == 0u ? 1u : rhs);
}

int naga_div(int lhs, int rhs) {
    return lhs / (((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs);
}
";
        let guard = "(lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)";
        let wanted = format!(
            "\
int2 naga_abs(int2 val) {{
    return max(val, asint(0u - asuint(val)));
}}

int2 naga_div(int2 lhs, int2 rhs) {{
    return lhs / (rhs + (1 - rhs) * int2({guard}));
}}

int2 naga_mod(int2 lhs, int2 rhs) {{
    int2 divisor = rhs + (1 - rhs) * int2({guard});
    return lhs - (lhs / divisor) * divisor;
}}

uint3 naga_mod(uint3 lhs, uint3 rhs) {{
    return lhs % max(rhs, 1u);
}}

int naga_div(int lhs, int rhs) {{
    return lhs / (({guard}) ? 1 : rhs);
}}
"
        );
        assert_eq!(with_plain_helpers(text), wanted);
    }
}
