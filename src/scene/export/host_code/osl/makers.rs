//! Functions that make structs of structs: oslc leaves members that are structs themselves out when
//! a constructor is given a variable for them.

use std::fmt::Write as _;

use super::super::dialect::function_head;
use crate::wgsl::rename_identifiers;

/// Types that constructors copy.
const COPIED: [&str; 8] =
    ["float", "int", "string", "color", "point", "vector", "normal", "matrix"];

/// The text with such functions behind their structs, called in the places of constructors, and
/// with functions for constants that have lists.
pub(super) fn with_makers(text: &str) -> String {
    let (text, constants) = without_lists(text);
    let text = text.as_str();
    let mut made = Vec::new();
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    let start = |rest: &str| {
        let is_first = rest.starts_with("struct ");
        if is_first { Some(0) } else { rest.find("\nstruct ").map(|at| at + 1) }
    };
    while let Some(at) = start(rest) {
        let end = rest[at..].find("};\n").map_or(rest.len(), |end| at + end + 3);
        let (declared, after) = rest.split_at(end);
        result += declared;
        rest = after;
        let Some((name, members)) = parsed(&declared[at..]) else { continue };
        let is_copied = |(ty, name): &(&str, &str)| COPIED.contains(ty) && !name.contains('[');
        let mut own = constants.iter().filter(|constant| constant.structure == name).peekable();
        if !members.iter().all(is_copied) && (has_call(text, name) || own.peek().is_some()) {
            result += &maker(name, &members);
            own.for_each(|constant| result += &constant.function(&members));
            made.push(name.to_owned());
        }
    }
    result += rest;
    for name in made {
        result = with_calls(&result, &name, &maker_name(&name));
    }
    result
}

/// A constant of a struct with lists, which macros cannot hold.
struct ListConstant {
    name: String,
    structure: String,
    items: Vec<String>,
}

impl ListConstant {
    /// The constant as a function without parameters.
    fn function(&self, members: &[(&str, &str)]) -> String {
        let Self { name, structure, items } = self;
        let mut text = format!("\n{structure} {name}()\n{{\n");
        let mut arguments = Vec::new();
        for (item, (ty, member)) in items.iter().zip(members) {
            if item.starts_with('{') {
                let _ = writeln!(text, "    {ty} {member} = {item};");
                arguments.push(member.split('[').next().unwrap_or_default());
            } else {
                arguments.push(item.as_str());
            }
        }
        let call = format!("{}({})", maker_name(structure), arguments.join(", "));
        text + &format!("    return {call};\n}}\n")
    }
}

/// The text without macros of structs with lists, which it calls as functions, and these.
fn without_lists(text: &str) -> (String, Vec<ListConstant>) {
    let mut constants = Vec::new();
    let mut rest = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let constant = line.strip_prefix("#define ").filter(|it| it.contains('{'));
        match constant.and_then(list_constant) {
            Some(constant) => constants.push(constant),
            None => rest.push_str(line),
        }
    }
    let is_known = |word: &str| constants.iter().any(|constant| constant.name == word);
    let called = rename_identifiers(&rest, |word| is_known(word).then(|| format!("{word}()")));
    (called, constants)
}

fn list_constant(line: &str) -> Option<ListConstant> {
    let (name, value) = line.trim_end().split_once(' ')?;
    let (structure, inner) = value.strip_suffix(')')?.split_once('(')?;
    let (mut items, mut depth) = (vec![String::new()], 0_i32);
    for c in inner.chars() {
        depth += i32::from(matches!(c, '(' | '{')) - i32::from(matches!(c, ')' | '}'));
        if depth == 0 && c == ',' {
            items.push(String::new());
        } else if let Some(item) = items.last_mut() {
            item.push(c);
        }
    }
    let items = items.iter().map(|item| item.trim().to_owned()).collect();
    Some(ListConstant { name: name.to_owned(), structure: structure.to_owned(), items })
}

/// Name and members (type and name) of a struct.
fn parsed(text: &str) -> Option<(&str, Vec<(&str, &str)>)> {
    let (name, inner) = text.strip_prefix("struct ")?.split_once(" {\n")?;
    let lines = inner.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    let members = lines.filter_map(|line| line.strip_suffix(';')?.split_once(' ')).collect();
    Some((name, members))
}

/// The function that makes a struct of its members.
fn maker(name: &str, members: &[(&str, &str)]) -> String {
    let parameters: Vec<String> = members.iter().map(|(ty, it)| format!("{ty} {it}")).collect();
    let head = function_head(&format!("{name} {}", maker_name(name)), &parameters, 100);
    let mut text = format!("\n{head}\n{{\n    {name} made;\n");
    for (_, member) in members {
        let member = member.split('[').next().unwrap_or_default();
        let _ = writeln!(text, "    made.{member} = {member};");
    }
    text + "    return made;\n}\n"
}

/// `make_light_frame` of `LightFrame`.
fn maker_name(name: &str) -> String {
    let mut result = "make".to_owned();
    for c in name.chars() {
        if c.is_ascii_uppercase() {
            result.push('_');
        }
        result.push(c.to_ascii_lowercase());
    }
    result
}

fn has_call(text: &str, name: &str) -> bool {
    with_calls(text, name, "") != text
}

/// The text with calls of a function by another name.
fn with_calls(text: &str, name: &str, other: &str) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let call = format!("{name}(");
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(&call) {
        let (before, after) = rest.split_at(at);
        result += before;
        result += if before.ends_with(is_word) { name } else { other };
        rest = &after[name.len()..];
    }
    result + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn structs_of_structs_are_made_member_by_member() {
        let text = "struct Flat {\n    float x;\n};\n\nstruct Deep {\n    // Where.\n    \
                    Flat flat;\n    float y;\n};\n\nDeep f(Flat a)\n{\n    \
                    return Deep(a, 1.0);\n}\n";
        let made = with_makers(text);
        let maker = "Deep make_deep(Flat flat, float y)\n{\n    Deep made;\n    \
                     made.flat = flat;\n    made.y = y;\n    return made;\n}\n";
        assert!(made.contains(maker), "{made}");
        assert!(made.contains("return make_deep(a, 1.0);"), "{made}");
        assert!(!made.contains("make_flat"), "{made}");
    }

    #[test]
    fn constants_with_lists_are_functions() {
        let text = "#define tones Ramp({1.0, 2.0}, 2)\nstruct Ramp {\n    float places[2];\n    \
                    int count;\n};\n\nfloat f()\n{\n    return g(tones);\n}\n";
        let made = with_makers(text);
        let constant = "Ramp tones()\n{\n    float places[2] = {1.0, 2.0};\n    \
                        return make_ramp(places, 2);\n}\n";
        assert!(made.contains(constant), "{made}");
        assert!(made.contains("return g(tones());"), "{made}");
        assert!(!made.contains("#define"), "{made}");
    }
}
