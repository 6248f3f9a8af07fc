//! Brackets that change nothing, taken away: naga puts them around every operation.
//!
//! What is computed stays the same, as a parser reads the same tree without them. Brackets stay
//! where people set them: where operators of different families meet.

/// Precedence of the families of binary operators, from what binds least.
const FAMILIES: [&[&str]; 6] = [
    &["?", ":"],
    &["||", "&&"],
    &["==", "!="],
    &["<", ">", "<=", ">="],
    &["+", "-"],
    &["*", "/", "%"],
];
/// Operators of bits, which bind differently from language to language.
const OF_BITS: [&str; 5] = ["&", "|", "^", "<<", ">>"];
const LOGICAL: usize = 1;
const SUM: usize = 4;

/// Words before brackets that belong to a statement.
const STATEMENTS: [&str; 4] = ["if", "for", "switch", "while"];

/// Neighbor of brackets, at one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Neighbor {
    /// The end of an argument or a statement.
    End,
    /// A binary operator, by its family.
    Operator(usize),
    /// Anything else.
    Other,
}

/// Content of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Content {
    /// An operand without operators.
    Operand,
    /// Operands with operators, by the family that binds least.
    Operators(usize),
    /// Operands with operators of bits among them.
    Bits,
    /// Anything else.
    Other,
}

/// A line without brackets that change nothing.
pub(super) fn without_needless(line: &str) -> String {
    let mut line = line.to_owned();
    if line.trim_start().starts_with(['#', '/']) {
        return line;
    }
    let mut at = 0;
    while let Some(found) = line[at..].find('(') {
        let open = at + found;
        at = open + 1;
        let Some(close) = closing(&line, open) else { break };
        if is_needless(&line, open, close) {
            line.remove(close);
            line.remove(open);
            at = open;
        }
    }
    line
}

/// The bracket that closes the one at `open`.
fn closing(line: &str, open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, byte) in line.bytes().enumerate().skip(open) {
        match byte {
            b'(' => depth += 1,
            b')' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}

fn is_needless(line: &str, open: usize, close: usize) -> bool {
    let (before, after) = (&line[..open], &line[close + 1..]);
    let content = &line[open + 1..close];
    let is_negative = content.starts_with(['-', '!', '~']);
    let is_after_sign = before.ends_with(" -") || before.ends_with("(-") || before.ends_with('!');
    if is_after_sign && !is_negative {
        return of(content) == Content::Operand && right(after) != Neighbor::Other;
    }
    match (left(before), of(content), right(after)) {
        (Neighbor::Other, ..) | (_, _, Neighbor::Other) | (_, Content::Other, _) => false,
        (Neighbor::End, _, Neighbor::End) => true,
        (_, Content::Bits, _) => false,
        (Neighbor::End, Content::Operand, _) => true,
        (Neighbor::Operator(_), Content::Operand, _) => !is_negative,
        (left, Content::Operators(own), right) => {
            let is_above = |other: Neighbor, is_left: bool| match other {
                Neighbor::End => true,
                Neighbor::Operator(..=LOGICAL) => own > LOGICAL,
                // A sum of sums is read from the left.
                Neighbor::Operator(other) if own == other => own >= SUM && !is_left,
                Neighbor::Operator(other) => own > other && own >= SUM,
                Neighbor::Other => false,
            };
            is_above(left, true)
                && is_above(right, false)
                && (left == Neighbor::End || !is_negative)
        }
    }
}

/// The neighbor before brackets, from the text that ends there.
fn left(before: &str) -> Neighbor {
    if before.ends_with(['(', '[', '{']) {
        return Neighbor::End;
    }
    let Some(before) = before.strip_suffix(' ') else { return Neighbor::Other };
    let word = before.rsplit(' ').next().unwrap_or_default();
    if STATEMENTS.contains(&word) {
        Neighbor::Other
    } else if word == "return" || word == "=" || word.ends_with(',') {
        Neighbor::End
    } else {
        family(word).map_or(Neighbor::Other, Neighbor::Operator)
    }
}

/// The neighbor behind brackets, from the text that begins there.
fn right(after: &str) -> Neighbor {
    if after.starts_with([',', ';', ')', ']', '}']) {
        return Neighbor::End;
    }
    let Some(after) = after.strip_prefix(' ') else { return Neighbor::Other };
    let word = after.split(' ').next().unwrap_or_default();
    family(word).map_or(Neighbor::Other, Neighbor::Operator)
}

fn family(operator: &str) -> Option<usize> {
    FAMILIES.iter().position(|family| family.contains(&operator))
}

/// The content of brackets, from their text.
fn of(content: &str) -> Content {
    let mut depth = 0_i32;
    let mut least: Option<usize> = None;
    let mut has_bits = false;
    for word in content.split(' ').filter(|word| !word.is_empty()) {
        let is_operator = |c: char| !c.is_alphanumeric() && !"()[]{}_,.".contains(c);
        if word.chars().all(is_operator) {
            match family(word) {
                _ if depth > 0 => {}
                Some(own) => least = Some(least.map_or(own, |least| least.min(own))),
                None if OF_BITS.contains(&word) => has_bits = true,
                None => return Content::Other,
            }
            continue;
        }
        for byte in word.bytes() {
            depth += i32::from(matches!(byte, b'(' | b'[' | b'{' | b'<'));
            depth -= i32::from(matches!(byte, b')' | b']' | b'}' | b'>'));
            if depth == 0 && byte == b',' {
                return Content::Other;
            }
        }
    }
    if has_bits { Content::Bits } else { least.map_or(Content::Operand, Content::Operators) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_that_change_nothing_go() {
        let rows = [
            ("x = (((2.0 * a) - 1.0) * 0.25);", "x = (2.0 * a - 1.0) * 0.25;"),
            ("return f((a * b), (c));", "return f(a * b, c);"),
            ("x = (a - (b - c));", "x = a - (b - c);"),
            ("x = ((a - b) - c);", "x = a - b - c;"),
            ("x = (a / (b * c));", "x = a / (b * c);"),
            ("x = ((a * b) / c);", "x = a * b / c;"),
            ("x = (a + (b * c));", "x = a + b * c;"),
            ("x = (a + b).xyz;", "x = (a + b).xyz;"),
            ("x = (c ? -(a) : b);", "x = c ? -a : b;"),
            ("x = ((c <= 0.0) ? a : (b + d));", "x = c <= 0.0 ? a : b + d;"),
            ("x = a * (c ? a : b);", "x = a * (c ? a : b);"),
            ("x = ((a || b) ? c : d);", "x = (a || b) ? c : d;"),
            ("if ((a > b)) {", "if (a > b) {"),
            ("if (((a + b) < c) && (d)) {", "if (a + b < c && d) {"),
            ("x = ((a < b) == c);", "x = (a < b) == c;"),
            ("x = (a & (b | c));", "x = a & (b | c);"),
            ("return f((a & 1u) == b, (a >> 1u));", "return f((a & 1u) == b, a >> 1u);"),
            ("if (((a >> uint(b)) & 1u) == 0u) {", "if (((a >> uint(b)) & 1u) == 0u) {"),
            ("x = (float)(a);", "x = (float)(a);"),
            ("x = a * (-b + c);", "x = a * (-b + c);"),
            ("x = a + (-b);", "x = a + (-b);"),
            ("x = vec3(-(a.x), b.y);", "x = vec3(-a.x, b.y);"),
            ("x = -(a + b);", "x = -(a + b);"),
            ("#define A (b)", "#define A (b)"),
            ("for (int i = 0; (i < 3); i++) {", "for (int i = 0; (i < 3); i++) {"),
            ("x = f<a, b>((c));", "x = f<a, b>(c);"),
            ("x = (((a || b)) && c);", "x = (a || b) && c;"),
        ];
        for (line, wanted) in rows {
            assert_eq!(without_needless(line), wanted, "{line}");
        }
    }
}
