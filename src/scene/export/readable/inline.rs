//! Values without a name, put where they are read.
//!
//! naga gives every load, call, derivative and texture read a line of its own, in the order of the
//! source. Such a value is moved into the line that reads it, where
//!
//! - it is a place of a uniform, which nothing writes; or
//! - it is read once, by a later line of the same block, and only declarations stand between. The
//!   functions of a look write nothing, so no declaration changes what another one reads.
//!
//! A call, a derivative or a texture read is not moved into a line with `?:`, `&&` or `||`, which
//! may pass over an operand: derivatives must stay where all fragments come along.

use super::Dialect;
use super::pieces::FunctionText;
use super::word::{baked_index, has_word, replace_words, words};

/// Greatest length of a line that a value is moved into, in bytes.
const LONGEST: usize = 140;

/// A line that declares a value.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct DeclarationLine<'t> {
    /// Spaces before the declaration.
    pub(super) indent: usize,
    /// Type of the value, as written.
    pub(super) ty: &'t str,
    /// Name of the value, without the length of an array.
    pub(super) name: &'t str,
    /// Value; none for a variable without one.
    pub(super) value: Option<&'t str>,
}

impl<'t> DeclarationLine<'t> {
    /// Reads a line; `None` where the line declares nothing.
    pub(super) fn of(line: &'t str) -> Option<Self> {
        let trimmed = line.trim_start();
        let indent = line.len() - trimmed.len();
        let statement = trimmed.strip_suffix(';')?;
        let (variable, value) = match statement.split_once(" = ") {
            Some((variable, value)) => (variable, Some(value)),
            None => (statement, None),
        };
        let variable = variable.split('[').next().unwrap_or(variable);
        let (ty, name) = variable.rsplit_once(' ')?;
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let is_type = |c: char| is_name(c) || " :<>,".contains(c);
        let begins = |text: &str| text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
        let is_statement = matches!(ty.split(' ').next(), Some("return" | "else" | "case"));
        let is_declaration = begins(ty)
            && begins(name)
            && ty.chars().all(is_type)
            && name.chars().all(is_name)
            && !is_statement;
        is_declaration.then_some(Self { indent, ty, name, value })
    }
}

/// Puts values without a name where they are read. `is_pure` is true where no function has side
/// effects.
pub(super) fn inline(function: &mut FunctionText<'_>, dialect: &Dialect<'_>, is_pure: bool) {
    let Some((ir, _)) = function.ir else { return };
    let has_name =
        |index: usize| ir.named_expressions.keys().any(|expression| expression.index() == index);
    let mut at = 0;
    while at < function.body.len() {
        let line = function.body[at].clone();
        let declared = DeclarationLine::of(&line)
            .filter(|declared| baked_index(declared.name).is_some_and(|index| !has_name(index)));
        let is_moved = declared.is_some_and(|declared| {
            let value = declared.value.unwrap_or_default();
            is_uniform(value, dialect) && move_uniform(&mut function.body, at, &declared, dialect)
                || is_pure && move_value(&mut function.body, at, &declared)
        });
        if is_moved {
            function.body.remove(at);
        } else {
            at += 1;
        }
    }
}

/// True if `value` is a place, written with names, points and constant indices only.
fn is_place(value: &str) -> bool {
    value.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && value.chars().all(|c| c.is_ascii_alphanumeric() || "_.[]".contains(c))
}

fn is_uniform(value: &str, dialect: &Dialect<'_>) -> bool {
    let mut names = words(value).filter(|word| !word.is_member);
    let root = names.next().map(|word| &value[word.span]);
    // An index that is a name may be a variable, which changes.
    is_place(value)
        && names.next().is_none()
        && root.is_some_and(|root| dialect.uniforms.contains(root))
}

/// Replaces every read of a uniform's place.
fn move_uniform(
    body: &mut [String],
    at: usize,
    declared: &DeclarationLine<'_>,
    dialect: &Dialect<'_>,
) -> bool {
    let value = declared.value.unwrap_or_default();
    let member = value.rsplit('.').next().unwrap_or(value);
    let is_packed = declared.ty.ends_with("float3") && dialect.packed.contains(member);
    let value = if is_packed { format!("{}({value})", declared.ty) } else { value.to_owned() };
    for line in body.iter_mut().skip(at + 1).filter(|line| has_word(line, declared.name)) {
        *line = replace_words(line, |word| (word == declared.name).then(|| value.clone()));
    }
    true
}

/// Moves a value into the one line that reads it; false where the value has to stay.
fn move_value(body: &mut [String], at: usize, declared: &DeclarationLine<'_>) -> bool {
    let Some(value) = declared.value else { return false };
    let reads = |line: &str| {
        words(line)
            .filter(|word| !word.is_member && &line[word.span.clone()] == declared.name)
            .count()
    };
    let mut readers = body.iter().enumerate().skip(at + 1).filter(|(_, line)| reads(line) > 0);
    let Some((reader, line)) = readers.next() else { return false };
    let is_alone = readers.next().is_none() && reads(line) == 1;
    let are_declarations = body[at + 1..reader].iter().all(|between| {
        DeclarationLine::of(between).is_some_and(|between| between.indent == declared.indent)
    });
    let trimmed = line.trim_start();
    let is_same_block = line.len() - trimmed.len() == declared.indent;
    // A loop's condition is read in every round.
    let is_once = !["while", "for", "}"].iter().any(|begin| trimmed.starts_with(begin));
    let may_pass_over = ["?", "&&", "||"].iter().any(|operator| line.contains(operator));
    if !(is_alone && are_declarations && is_same_block && is_once)
        || may_pass_over && !is_place(value)
        || line.len() + value.len() > LONGEST && !is_place(value)
    {
        return false;
    }
    let value = if is_primary(value) { value.to_owned() } else { format!("({value})") };
    let moved = replace_words(line, |word| (word == declared.name).then(|| value.clone()));
    body[reader] = moved;
    true
}

/// True if `value` keeps together wherever it stands: a place, a call, or what is in brackets.
fn is_primary(value: &str) -> bool {
    let mut depth = 0usize;
    !value.starts_with(['-', '!', '~'])
        && value.chars().all(|c| {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth > 0 || c != ' '
        })
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use super::*;

    fn inlined(body: &[&str]) -> Vec<String> {
        let ir = naga::Function::default();
        let mut function = FunctionText {
            comment: Vec::new(),
            head: Vec::new(),
            body: body.iter().map(|&line| line.to_owned()).collect(),
            ir: Some((&ir, "f")),
        };
        let uniforms: BTreeSet<String> = ["look".to_owned()].into();
        let (none, renamed) = (BTreeSet::new(), BTreeMap::new());
        let dialect =
            Dialect { uniforms: &uniforms, packed: &none, reserved: &none, renamed: &renamed };
        inline(&mut function, &dialect, true);
        function.body
    }

    #[test]
    fn declarations_are_told_from_other_lines() {
        let name = |line| DeclarationLine::of(line).map(|declared| declared.name.to_owned());
        for (line, wanted) in [
            ("    const metal::float3 a = b;", Some("a")),
            ("    metal::texture2d<float, metal::access::sample> t = u;", Some("t")),
            ("    float x[4] = { 0 };", Some("x")),
            ("    uint v;", Some("v")),
            ("    return a;", None),
            ("    v.x = a;", None),
            ("    v = a;", None),
            ("    if (a == b) {", None),
            ("    discard;", None),
        ] {
            assert_eq!(name(line).as_deref(), wanted, "{line}");
        }
    }

    #[test]
    fn values_are_moved_where_they_are_read() {
        let body = [
            "    uint _e1 = v.x;",
            "    uint _e2 = v.y;",
            "    v.x = (_e1 + _e2);",
            "    float3 _e3 = look.color;",
            "    float _e4 = bent(_e3, 1.0);",
            "    if (!(_e4 > 0.0)) {",
            "        v.y = _e3.x;",
            "    }",
            "    float _e5 = -(v.x);",
            "    return _e5 * 2.0;",
        ];
        let wanted = [
            "    v.x = (v.x + v.y);",
            "    if (!(bent(look.color, 1.0) > 0.0)) {",
            "        v.y = look.color.x;",
            "    }",
            "    return (-(v.x)) * 2.0;",
        ];
        assert_eq!(inlined(&body), wanted);
    }

    #[test]
    fn what_may_change_between_stays() {
        for body in [
            // Written in between.
            &["    uint _e1 = v;", "    v = 2u;", "    return _e1;"][..],
            // Read in a round of a loop, and in another block.
            &["    uint _e1 = v;", "    while(_e1) {", "    }"],
            &["    uint _e1 = f(v);", "    if (a) {", "        return _e1;", "    }"],
            // Read twice.
            &["    uint _e1 = f(v);", "    return _e1 * _e1;"],
            // An operand that may be passed over, and one that must not be.
            &["    float _e1 = dFdx(v);", "    return (a ? _e1 : b);"],
            // A variable decides about the place.
            &["    float _e1 = look.colors[i];", "    i = 2;", "    return _e1;"],
            // Nobody reads it.
            &["    float _e1 = f(v);", "    return a;"],
        ] {
            assert_eq!(inlined(body), body);
        }
    }
}
