//! Names of values inside functions.
//!
//! Each function has names of its own: those of its WGSL, as far as the language has no other use
//! for them and no two values share one.

use std::collections::{BTreeMap, BTreeSet};

use naga::{DerivativeAxis, Expression, Function, Handle, Module};

use super::Dialect;
use super::inline::DeclarationLine;
use super::pieces::{FunctionText, base};
use super::word::{baked_index, replace_words, words};

/// Variables that naga adds to loops.
const HELPERS: [&str; 3] = ["loop_init", "loop_bound", "should_continue"];

/// Names for values that have none in WGSL, whatever function they are of.
const PLAIN: [&str; 5] = ["texel", "along_x", "along_y", "width", "value"];

/// Gives the values of a function their names.
pub(super) fn rename(function: &mut FunctionText<'_>, module: &Module, dialect: &Dialect<'_>) {
    let Some((ir, _)) = function.ir else { return };
    let known = known_names(ir, module);
    let locals = locals(function);
    let mut names = LocalNames { reserved: dialect.reserved, taken: BTreeSet::new() };
    let lines = || function.head.iter().chain(&function.body);
    for line in lines() {
        for word in words(line).filter(|word| !word.is_member) {
            let word = &line[word.span];
            if !locals.iter().any(|local| local == word) {
                let shown = dialect.renamed.get(word).map_or(word, String::as_str);
                names.taken.insert(shown.to_owned());
            }
        }
    }
    let mut renamed = BTreeMap::new();
    for local in locals {
        let wanted = match baked_index(&local) {
            Some(index) => baked_name(ir, module, index),
            None => known_name(&local, &known).map(str::to_owned),
        };
        let name = match wanted {
            Some(wanted) => names.choose(&wanted),
            None => names.choose_same(&local),
        };
        renamed.insert(local, name);
    }
    for line in function.head.iter_mut().chain(&mut function.body) {
        *line = replace_words(line, |word| renamed.get(word).cloned());
    }
}

/// All names that [`rename`] may want for values of the module's functions.
pub(super) fn wanted_names(module: &Module) -> BTreeSet<String> {
    let functions = module.functions.iter().map(|(_, function)| function);
    let functions = functions.chain(module.entry_points.iter().map(|point| &point.function));
    let mut wanted: BTreeSet<String> = PLAIN.map(str::to_owned).into();
    for function in functions {
        wanted.extend(known_names(function, module).into_iter().map(str::to_owned));
    }
    wanted
}

/// Functions, constants and types whose names end with a digit, by their names in the text, where
/// naga has added a `_` for that.
pub(super) fn plain_names(module: &Module, text: &str) -> BTreeMap<String, String> {
    let functions = module.functions.iter().filter_map(|(_, function)| function.name.as_deref());
    let constants = module.constants.iter().filter_map(|(_, constant)| constant.name.as_deref());
    let types = module.types.iter().filter_map(|(_, ty)| ty.name.as_deref());
    let used: BTreeSet<&str> = words(text).map(|word| &text[word.span]).collect();
    let is_free = |name: &&str| {
        name.ends_with(|c: char| c.is_ascii_digit())
            && !is_like_builtin(name)
            && !used.contains(name)
    };
    let names = functions.chain(constants).chain(types).filter(is_free);
    names.map(|name| (format!("{name}_"), name.to_owned())).collect()
}

/// Names that the values of a function have in WGSL, and those of variables that naga adds.
fn known_names<'m>(ir: &'m Function, module: &'m Module) -> BTreeSet<&'m str> {
    let arguments = ir.arguments.iter().filter_map(|argument| argument.name.as_deref());
    let variables = ir.local_variables.iter().filter_map(|(_, local)| local.name.as_deref());
    let globals = module.global_variables.iter().filter_map(|(_, global)| global.name.as_deref());
    let values = ir.named_expressions.values().map(String::as_str);
    arguments.chain(variables).chain(globals).chain(values).chain(HELPERS).collect()
}

/// The name in WGSL of a value that naga calls `local`.
fn known_name<'m>(local: &str, known: &BTreeSet<&'m str>) -> Option<&'m str> {
    let is_known = |name: &str| known.get(name).copied();
    let without_end = || is_known(local.trim_end_matches('_'));
    is_known(local).or_else(without_end).or_else(|| is_known(base(local)?))
}

/// The name of a value that naga only numbers: its own, or one by what the value is.
fn baked_name(ir: &Function, module: &Module, index: usize) -> Option<String> {
    let (handle, expression) = ir.expressions.iter().nth(index)?;
    if let Some(name) = ir.named_expressions.get(&handle) {
        return Some(name.clone());
    }
    Some(match expression {
        Expression::CallResult(function) => {
            let name = module.functions[*function].name.as_deref().unwrap_or("call");
            format!("{name}_value")
        }
        Expression::ImageSample { .. } | Expression::ImageLoad { .. } => "texel".to_owned(),
        Expression::Derivative { axis: DerivativeAxis::X, .. } => "along_x".to_owned(),
        Expression::Derivative { axis: DerivativeAxis::Y, .. } => "along_y".to_owned(),
        Expression::Derivative { .. } => "width".to_owned(),
        Expression::Load { pointer } => match variable_name(ir, *pointer) {
            Some(name) => format!("{name}_now"),
            None => "value".to_owned(),
        },
        _ => "value".to_owned(),
    })
}

/// The name of the local variable that a place belongs to.
fn variable_name(ir: &Function, place: Handle<Expression>) -> Option<&str> {
    let mut place = place;
    loop {
        match &ir.expressions[place] {
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => place = *base,
            Expression::LocalVariable(variable) => {
                return ir.local_variables[*variable].name.as_deref();
            }
            _ => return None,
        }
    }
}

/// Names of a function's values in its text, arguments first.
fn locals(function: &FunctionText<'_>) -> Vec<String> {
    let head = function.head.join("\n");
    let mut found: Vec<String> = arguments(&head).into_iter().map(str::to_owned).collect();
    let declared = function.body.iter().filter_map(|line| DeclarationLine::of(line));
    found.extend(declared.map(|declared| declared.name.to_owned()));
    let mut seen = BTreeSet::new();
    found.retain(|name| seen.insert(name.clone()));
    found
}

/// The names of the arguments in a function's head.
fn arguments(head: &str) -> Vec<&str> {
    let Some(start) = head.find('(') else { return Vec::new() };
    let mut depth = 0usize;
    let mut found = Vec::new();
    let mut begin = start + 1;
    for (at, c) in head.char_indices().skip_while(|(at, _)| *at <= start) {
        match c {
            '(' | '[' | '<' => depth += 1,
            ']' | '>' => depth = depth.saturating_sub(1),
            ')' if depth > 0 => depth -= 1,
            ',' | ')' if depth == 0 => {
                found.extend(argument(&head[begin..at]));
                begin = at + 1;
                if c == ')' {
                    break;
                }
            }
            _ => {}
        }
    }
    found
}

/// The name in `float4 clip : SV_Position`, `View view [[buffer(0)]]` or `vec3 v[2]`.
fn argument(text: &str) -> Option<&str> {
    let text = text.split(" : ").next().unwrap_or(text);
    let text = text.split('[').next().unwrap_or(text);
    words(text).last().map(|word| &text[word.span])
}

/// True if a name that ends with a digit is likely a type or a function of the language, such as
/// `vec3`. Of such names naga does not tell: it adds `_` to all of them.
pub(super) fn is_like_builtin(name: &str) -> bool {
    const BEGINNINGS: [&str; 20] = [
        "vec", "ivec", "uvec", "bvec", "dvec", "mat", "dmat", "float", "int", "uint", "bool",
        "half", "double", "min", "log", "exp", "atan", "short", "char", "long",
    ];
    let number = |rest: &str| rest.bytes().all(|byte| byte.is_ascii_digit() || byte == b'x');
    BEGINNINGS.iter().any(|begin| name.strip_prefix(begin).is_some_and(number))
}

struct LocalNames<'a> {
    reserved: &'a BTreeSet<String>,
    taken: BTreeSet<String>,
}

impl LocalNames<'_> {
    /// A name as near to `wanted` as can be.
    fn choose(&mut self, wanted: &str) -> String {
        let wanted = wanted.trim_end_matches('_');
        let is_other = self.reserved.contains(wanted)
            || wanted.ends_with(|c: char| c.is_ascii_digit()) && is_like_builtin(wanted);
        let first = if is_other { format!("{wanted}_") } else { wanted.to_owned() };
        let numbered = (1..).map(|number| format!("{wanted}_{number}"));
        let mut names = std::iter::once(first).chain(numbered);
        let name = names.find(|name| !self.taken.contains(name)).unwrap_or_default();
        self.taken.insert(name.clone());
        name
    }

    /// The name itself, where it is free.
    fn choose_same(&mut self, name: &str) -> String {
        if self.taken.insert(name.to_owned()) { name.to_owned() } else { self.choose(name) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_are_found_in_every_language() {
        let glsl = "vec4 f(vec3 v, float x[2]) {";
        let hlsl = "float4 fs_main(FragmentInput input, uint at : SV_VertexID) : SV_Target0\n{";
        let metal = "fragment Out fs_main(\n  In varyings [[stage_in]]\n, constant View& view_1 \
                     [[buffer(0)]]\n, metal::texture2d<float, metal::access::sample> map\n) {";
        assert_eq!(arguments(glsl), ["v", "x"]);
        assert_eq!(arguments(hlsl), ["input", "at"]);
        assert_eq!(arguments(metal), ["varyings", "view_1", "map"]);
        assert_eq!(arguments("void main() {"), [""; 0]);
    }

    #[test]
    fn names_are_told_apart() {
        let reserved: BTreeSet<String> = ["half".to_owned()].into();
        let taken: BTreeSet<String> = ["dot".to_owned()].into();
        let mut names = LocalNames { reserved: &reserved, taken };
        let chosen: Vec<_> = ["dx", "dx", "half", "half", "dot", "rim_2", "mat3x3"]
            .map(|name| names.choose(name))
            .into();
        assert_eq!(chosen, ["dx", "dx_1", "half_", "half_1", "dot_1", "rim_2", "mat3x3_"]);
    }

    #[test]
    fn names_of_the_source_are_known_again() {
        let known: BTreeSet<&str> = ["dx", "half", "rim_2"].into();
        for (name, wanted) in [
            ("dx", Some("dx")),
            ("dx_3", Some("dx")),
            ("half_", Some("half")),
            ("half_1", Some("half")),
            ("rim_2_", Some("rim_2")),
            ("rim_2_1", Some("rim_2")),
            ("other", None),
        ] {
            assert_eq!(known_name(name, &known), wanted, "{name}");
        }
    }
}
