//! Host work in the shader: from parameters, lights and surroundings to the numbers of the look.
//!
//! A material runs no program before it draws, so each pixel computes the numbers, from the same
//! WGSL that packages with a program translate. What depends on parameters alone costs little:
//! compilers of shaders move it out of the pixel where they can.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::arguments::Argument;
use crate::diag::Diagnostic;
use crate::document::Light;
use crate::export::hlsl;
use crate::export::package::PackageRequest;
use crate::export::package::unity::leaves::Leaf;
use crate::export::program::{literal, number, vec3};
use crate::wgsl::{rename_identifiers, scan};

/// Name of the function that makes the numbers.
pub(super) const FUNCTION: &str = "numbers_of_look";

/// The host work of a look.
#[derive(Clone, Debug)]
pub(super) struct HostText {
    /// The functions and types, in HLSL.
    pub(super) hlsl: String,
    /// Members of the surroundings that the functions read.
    pub(super) reads: BTreeSet<String>,
    /// Members of the numbers in HLSL, in the order of the leaves.
    pub(super) members: Vec<String>,
}

/// The host work; `None` where the look has no numbers. Names of `taken` are those of the look's
/// own text and Unreal's.
///
/// # Errors
/// Host work that is no HLSL.
pub(super) fn write(
    request: &PackageRequest<'_>,
    arguments: &[Argument<'_>],
    leaves: &[Leaf],
    taken: &BTreeSet<String>,
) -> Result<Option<HostText>, Diagnostic> {
    let work = request.work;
    let Some(draw) = work.modules.iter().find(|it| it.module == "draw") else { return Ok(None) };
    let mut source = with_members(&work.wgsl, &draw.function, leaves);
    source += &entry(request, &draw.function, arguments);
    let source = needed(&source, FUNCTION);
    let names: BTreeSet<String> =
        scan(&source).declarations.into_iter().map(|it| it.name).collect();
    let source = rename_identifiers(&source, |name| {
        let is_both = names.contains(name) && taken.contains(name);
        let is_loud = name.chars().all(|c| c.is_ascii_uppercase() || c == '_');
        is_both.then(|| match name.chars().next() {
            _ if is_loud => format!("HOST_{name}"),
            Some(first) if first.is_ascii_uppercase() => format!("Host{name}"),
            _ => format!("host_{name}"),
        })
    });
    let reads = identifiers(&source.replace("around.", " around_"))
        .filter_map(|word| word.strip_prefix("around_").map(str::to_owned))
        .collect();
    let hlsl = hlsl::functions(&source)?;
    let members = members(&hlsl);
    Ok(Some(HostText { hlsl, reads, members }))
}

/// Members of the numbers, as HLSL calls them, without those that fill up space.
fn members(hlsl: &str) -> Vec<String> {
    let body = hlsl.split_once("struct Numbers {\n").and_then(|(_, rest)| rest.split_once("\n}"));
    let lines = body.map_or("", |(body, _)| body).lines();
    let names = lines.filter_map(|line| line.trim().strip_suffix(';')?.rsplit(' ').next());
    let is_filling = |name: &&str| name.starts_with("_pad") || name.starts_with("_end_pad");
    names.filter(|name| !is_filling(name)).map(str::to_owned).collect()
}

/// The words of a text.
fn identifiers(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// The program with a struct of the numbers in place of a list: a member for each place in the
/// look's own struct.
fn with_members(wgsl: &str, function: &str, leaves: &[Leaf]) -> String {
    let scanned = scan(wgsl);
    let Some(found) = scanned.declarations.iter().find(|it| it.name == function) else {
        return wgsl.to_owned();
    };
    let mut members = String::new();
    for leaf in leaves {
        let _ = writeln!(members, "    {}: {},", member(leaf), wgsl_type(leaf));
    }
    let text = &wgsl[found.body.clone()];
    let mut body = String::new();
    let mut words: Vec<Option<&str>> = Vec::new();
    for line in text.lines().skip(1) {
        // `    numbers[12] = key.direction.x;`
        let word = line.trim_start().strip_prefix("numbers[").and_then(|rest| {
            let (at, value) = rest.split_once("] = ")?;
            Some((at.parse::<usize>().ok()?, value.strip_suffix(';')?))
        });
        if let Some((at, value)) = word {
            words.resize(words.len().max(at + 1), None);
            words[at] = Some(value);
        } else if line.contains("var numbers: array<") {
            body += "    var numbers: Numbers;\n";
        } else if line.trim_start() == "return numbers;" {
            for leaf in leaves {
                let _ = writeln!(body, "    numbers.{} = {};", member(leaf), value(leaf, &words));
            }
            body += "    return numbers;\n";
        } else {
            body += line;
            body.push('\n');
        }
    }
    let body = body.trim_end();
    format!(
        "{}/// Numbers of the look.\nstruct Numbers {{\n{members}}}\n\n/// Numbers of the look.\n\
         fn {function}(settings: Settings, around: Surroundings) -> Numbers {{\n{body}{}",
        &wgsl[..found.span.start],
        &wgsl[found.body.end..],
    )
}

/// Member of the numbers that is a leaf's.
fn member(leaf: &Leaf) -> &str {
    leaf.property.trim_start_matches('_')
}

fn wgsl_type(leaf: &Leaf) -> &'static str {
    match (leaf.ty.as_str(), leaf.count) {
        ("int", _) => "i32",
        ("uint", _) => "u32",
        (_, 2) => "vec2f",
        (_, 3) => "vec3f",
        (_, 4) => "vec4f",
        _ => "f32",
    }
}

/// The value of a leaf, of the values of all words.
fn value(leaf: &Leaf, words: &[Option<&str>]) -> String {
    let first = leaf.word as usize;
    let parts: Vec<&str> = (first..first + leaf.count as usize)
        .map(|at| words.get(at).copied().flatten().unwrap_or("0.0"))
        .collect();
    if leaf.is_integer() {
        let inner = parts[0].strip_prefix("f32(").and_then(|rest| rest.strip_suffix(')'));
        return inner.unwrap_or(parts[0]).to_owned();
    }
    let whole = |part: &str, axis: &str| part.strip_suffix(axis).map(str::to_owned);
    let vector = whole(parts[0], ".x").filter(|vector| {
        let axes = [".x", ".y", ".z", ".w"];
        parts.len() > 1
            && parts.iter().zip(axes).all(|(part, axis)| whole(part, axis).as_ref() == Some(vector))
    });
    match (vector, parts.as_slice()) {
        (_, [one]) => (*one).to_owned(),
        (Some(vector), _) => vector,
        (None, parts) => format!("{}({})", wgsl_type(leaf), parts.join(", ")),
    }
}

/// The function that makes the numbers of arguments.
fn entry(request: &PackageRequest<'_>, function: &str, arguments: &[Argument<'_>]) -> String {
    let work = request.work;
    let mut text = format!("/// Numbers of the look, of its parameters.\nfn {FUNCTION}(");
    let mut body = "    var settings: Settings;\n".to_owned();
    for light in &work.lights {
        let _ = writeln!(body, "    settings.{} = {};", light.member, settings(&light.light));
    }
    for setting in &work.parameters {
        // What nobody can set has the look's own value, which keys move.
        if arguments.iter().all(|argument| argument.member != setting.member)
            && let Some(value) = literal(&setting.default)
        {
            let _ = writeln!(body, "    settings.{} = {value};", setting.member);
        }
    }
    for argument in arguments {
        let name = argument.member.replace('.', "_");
        let _ = write!(text, "{name}: {}, ", argument.kind.wgsl());
        let _ =
            writeln!(body, "    settings.{} = {};", argument.member, argument.kind.setting(&name));
    }
    let set = if work.is_keyed { "keyed(settings, around)" } else { "settings" };
    let _ = write!(
        text,
        "around: Surroundings) -> Numbers {{\n{body}    return {function}({set}, around);\n}}\n"
    );
    text
}

/// A light as the look has it.
fn settings(light: &Light) -> String {
    let described = serde_json::json!(light);
    let vector = |field: &str| {
        let numbers = described[field].as_array().cloned().unwrap_or_default();
        let number = |index: usize| numbers.get(index).and_then(serde_json::Value::as_f64);
        vec3([0, 1, 2].map(|index| number(index).unwrap_or_default()))
    };
    let scalar = |field: &str| number(described[field].as_f64().unwrap_or_default());
    let vectors = ["direction", "position", "aim", "color"].map(vector).join(", ");
    let scalars = ["intensity", "inner", "outer", "half_distance", "range"].map(scalar).join(", ");
    format!("LightSettings({vectors}, {scalars}, vec4f(), vec4f(0.0, 0.0, 1.0, -1.0))")
}

/// The declarations that one needs, in their order.
fn needed(source: &str, root: &str) -> String {
    let declarations = scan(source).declarations;
    let mut wanted = BTreeSet::from([root]);
    let mut open = vec![root];
    while let Some(name) = open.pop() {
        for declaration in declarations.iter().filter(|it| it.name == name) {
            for word in identifiers(&source[declaration.body.clone()]) {
                if wanted.insert(word) {
                    open.push(word);
                }
            }
        }
    }
    let texts = declarations.iter().filter(|it| wanted.contains(it.name.as_str()));
    texts.map(|it| format!("{}\n\n", &source[it.span.clone()])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn leaf(property: &str, ty: &str, word: u32, count: u32) -> Leaf {
        let place = format!("look.{property}");
        Leaf { property: property.to_owned(), place, ty: ty.to_owned(), word, count }
    }

    #[test]
    fn words_become_members() {
        let source = "struct Settings { a: f32 }\n\nfn draw(settings: Settings, around: \
                      Surroundings) -> array<f32, 8> {\n    var numbers: array<f32, 8>;\n    \
                      numbers[0] = v.x;\n    numbers[1] = v.y;\n    numbers[2] = 1.5;\n    \
                      numbers[4] = f32(select(0u, 1u, b));\n    return numbers;\n}\n\nfn g() {}\n";
        let leaves =
            [leaf("_v", "float2", 0, 2), leaf("_x", "float", 2, 1), leaf("_b", "uint", 4, 1)];
        let found = with_members(source, "draw", &leaves);
        for wanted in [
            "    v: vec2f,\n    x: f32,\n    b: u32,\n}",
            "    numbers.v = v;\n    numbers.x = 1.5;\n    \
             numbers.b = select(0u, 1u, b);\n    return",
            "}\n\nfn g() {}",
        ] {
            assert!(found.contains(wanted), "{found}");
        }
    }

    #[test]
    fn what_is_not_needed_goes() {
        let source = "const A = 1.0;\n\nfn f() -> f32 {\n    return A;\n}\n\nfn g() {}\n\n\
                      fn h() -> f32 {\n    return f();\n}\n";
        let found = needed(source, "h");
        assert!(found.contains("const A") && !found.contains("fn g"), "{found}");
    }
}
