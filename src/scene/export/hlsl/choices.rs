//! Choices between vectors, component by component, as calls of a function.
//!
//! WGSL's `select` and naga's writer put a vector before `?`, which HLSL 2018 takes component by
//! component and HLSL 2021 refuses; the function `select` of 2021 is unknown to 2018. A function of
//! the module's own, `choose`, is the same in both. It is added to the IR, before the writer comes,
//! so that the writer gives every value a place in the order of statements as it does for any call.

use std::collections::{BTreeMap, BTreeSet};

use naga::{
    Block, Expression, Function, FunctionArgument, FunctionResult, Handle, Module, Range, Scalar,
    Span, Statement, Type, TypeInner, VectorSize,
};

use super::super::readable::words;
use crate::wgsl::{ValidModule, validate};

/// Name of the function, and the beginning of its names where there are several: naga numbers all
/// but the first.
const NAME: &str = "choose";

/// Comment before the functions.
const COMMENT: &str =
    "/// `accept` where the condition holds, else `reject`, component by component.";

/// Names in a text of the functions for other types, and the one name for all.
pub(super) fn plain_names(text: &str) -> BTreeMap<String, String> {
    let named = |word: &&str| word.starts_with(NAME);
    let all: BTreeSet<&str> = words(text).map(|word| &text[word.span]).filter(named).collect();
    let heads: BTreeSet<&str> = text.lines().filter_map(declared).collect();
    // Something else of that name keeps the numbers.
    if all != heads {
        return BTreeMap::new();
    }
    let numbered = heads.into_iter().filter(|name| *name != NAME);
    numbered.map(|name| (name.to_owned(), NAME.to_owned())).collect()
}

/// The function that a line begins: `float3 choose_1(bool3 condition_1, ...`.
fn declared(line: &str) -> Option<&str> {
    let (head, arguments) = line.split_once('(')?;
    let name = head.split_once(' ')?.1;
    let is_own =
        name.starts_with(NAME) && arguments.starts_with("bool") && arguments.contains(" condition");
    is_own.then_some(name)
}

/// A text with a comment before each of the functions: a host of several texts tells by the whole
/// declaration that it has one already.
pub(super) fn with_comments(text: &str) -> String {
    let mut result = String::with_capacity(text.len() + COMMENT.len() + 1);
    for line in text.lines() {
        if declared(line).is_some() {
            result.push_str(COMMENT);
            result.push('\n');
        }
        result.push_str(line);
        result.push('\n');
    }
    result
}

/// Type of a choice: that of its two vectors.
type Choice = (VectorSize, Scalar);

/// Choices of a function.
type Choices = BTreeMap<Handle<Expression>, Choice>;

/// New places of functions.
type MovedFunctions = BTreeMap<Handle<Function>, Handle<Function>>;

/// The module with calls in the place of choices by vectors of conditions; `None` where it makes no
/// such choice.
///
/// # Errors
/// The error of naga's validator, for a form of module that is not known.
pub(super) fn with_calls(valid: &ValidModule) -> Result<Option<ValidModule>, String> {
    let (module, info) = (&valid.module, &valid.info);
    let functions: Vec<_> = module
        .functions
        .iter()
        .map(|(handle, function)| choices(module, function, &info[handle]))
        .collect();
    let points: Vec<_> = (0..module.entry_points.len())
        .map(|at| choices(module, &module.entry_points[at].function, info.get_entry_point(at)))
        .collect();
    let mut kinds: Vec<Choice> = Vec::new();
    for kind in functions.iter().chain(&points).flat_map(BTreeMap::values) {
        if !kinds.contains(kind) {
            kinds.push(*kind);
        }
    }
    if kinds.is_empty() {
        return Ok(None);
    }
    let mut module = module.clone();
    let before = std::mem::take(&mut module.functions);
    // Functions stand before those that call them.
    let added: Vec<_> = kinds.iter().map(|kind| add(&mut module, *kind)).collect();
    let added_for = |kind: &Choice| {
        let at = kinds.iter().position(|other| other == kind).unwrap_or_default();
        added[at]
    };
    let mut moved = MovedFunctions::new();
    let calling = |function: &mut Function, chosen: &Choices, moved: &MovedFunctions| {
        let calls = chosen.iter().map(|(at, kind)| (*at, added_for(kind))).collect();
        rewrite(function, moved, &calls);
    };
    for ((old, function), chosen) in before.iter().zip(&functions) {
        let mut function = function.clone();
        calling(&mut function, chosen, &moved);
        moved.insert(old, module.functions.append(function, before.get_span(old)));
    }
    for (point, chosen) in module.entry_points.iter_mut().zip(&points) {
        calling(&mut point.function, chosen, &moved);
    }
    validate(module).map(Some).map_err(|error| error.to_string())
}

/// Choices of a function by vectors of conditions.
fn choices(module: &Module, function: &Function, info: &naga::valid::FunctionInfo) -> Choices {
    let choice = |(at, expression): (Handle<Expression>, &Expression)| {
        let Expression::Select { condition, .. } = *expression else { return None };
        let is_vector =
            matches!(info[condition].ty.inner_with(&module.types), TypeInner::Vector { .. });
        match *info[at].ty.inner_with(&module.types) {
            TypeInner::Vector { size, scalar } if is_vector => Some((at, (size, scalar))),
            _ => None,
        }
    };
    function.expressions.iter().filter_map(choice).collect()
}

/// Adds the function for a type to a module.
fn add(module: &mut Module, (size, scalar): Choice) -> Handle<Function> {
    let mut vector = |scalar| {
        let inner = TypeInner::Vector { size, scalar };
        module.types.insert(Type { name: None, inner }, Span::UNDEFINED)
    };
    let (conditions, values) = (vector(Scalar::BOOL), vector(scalar));
    let argument =
        |(name, ty): (&str, _)| FunctionArgument { name: Some(name.to_owned()), ty, binding: None };
    let arguments = [("condition", conditions), ("accept", values), ("reject", values)];
    let mut function = Function {
        name: Some(NAME.to_owned()),
        arguments: arguments.map(argument).into(),
        result: Some(FunctionResult { ty: values, binding: None }),
        ..Function::default()
    };
    let mut push =
        |expression: Expression| function.expressions.append(expression, Span::UNDEFINED);
    let [condition, accept, reject] = [0, 1, 2].map(|at| push(Expression::FunctionArgument(at)));
    let components: Vec<_> = (0..size as u32)
        .map(|index| {
            let [condition, accept, reject] = [condition, accept, reject]
                .map(|base| push(Expression::AccessIndex { base, index }));
            push(Expression::Select { condition, accept, reject })
        })
        .collect();
    let whole = push(Expression::Compose { ty: values, components });
    let range = function.expressions.range_from(3);
    function.body.push(Statement::Emit(range), Span::UNDEFINED);
    function.body.push(Statement::Return { value: Some(whole) }, Span::UNDEFINED);
    module.functions.append(function, Span::UNDEFINED)
}

/// Lets a function call other functions: those that were moved, at their new places, and `calls` at
/// the values that were choices.
fn rewrite(
    function: &mut Function,
    moved: &MovedFunctions,
    calls: &BTreeMap<Handle<Expression>, Handle<Function>>,
) {
    for (_, expression) in function.expressions.iter_mut() {
        if let Expression::CallResult(called) = expression {
            *called = moved[called];
        }
    }
    let mut statements = BTreeMap::new();
    for (&result, &called) in calls {
        let expression = &mut function.expressions[result];
        if let Expression::Select { condition, accept, reject } = *expression {
            let arguments = vec![condition, accept, reject];
            statements.insert(
                result,
                Statement::Call { function: called, arguments, result: Some(result) },
            );
            *expression = Expression::CallResult(called);
        }
    }
    rewrite_block(&mut function.body, moved, &statements);
}

fn rewrite_block(
    block: &mut Block,
    moved: &MovedFunctions,
    calls: &BTreeMap<Handle<Expression>, Statement>,
) {
    let mut result = Block::with_capacity(block.len());
    for (mut statement, span) in std::mem::take(block).span_into_iter() {
        match &mut statement {
            Statement::Emit(range) => {
                emit(&mut result, range, span, calls);
                continue;
            }
            Statement::Call { function, .. } => *function = moved[function],
            Statement::Block(inner) => rewrite_block(inner, moved, calls),
            Statement::If { accept, reject, .. } => {
                rewrite_block(accept, moved, calls);
                rewrite_block(reject, moved, calls);
            }
            Statement::Switch { cases, .. } => {
                cases.iter_mut().for_each(|case| rewrite_block(&mut case.body, moved, calls));
            }
            Statement::Loop { body, continuing, .. } => {
                rewrite_block(body, moved, calls);
                rewrite_block(continuing, moved, calls);
            }
            _ => {}
        }
        result.push(statement, span);
    }
    *block = result;
}

/// Adds the values of a range to a block, with a call at each that has become one.
fn emit(
    block: &mut Block,
    range: &Range<Expression>,
    span: Span,
    calls: &BTreeMap<Handle<Expression>, Statement>,
) {
    let mut pending: Option<(Handle<Expression>, Handle<Expression>)> = None;
    let flush = |block: &mut Block, pending: Option<(_, _)>| {
        if let Some((first, last)) = pending {
            block.push(Statement::Emit(Range::new_from_bounds(first, last)), span);
        }
    };
    for value in range.clone() {
        match calls.get(&value) {
            Some(call) => {
                flush(block, pending.take());
                block.push(call.clone(), span);
            }
            None => pending = Some((pending.map_or(value, |(first, _)| first), value)),
        }
    }
    flush(block, pending);
}

#[cfg(test)]
mod tests {
    use naga::back::hlsl;

    use super::*;
    use crate::wgsl::parse;

    /// HLSL of a source, after the calls were put in.
    fn written(source: &str) -> String {
        let valid = parse(source).expect("a module");
        let changed = with_calls(&valid).expect("it is valid again");
        let changed = changed.unwrap_or(valid);
        let mut text = String::new();
        let (options, pipeline) = (hlsl::Options::default(), hlsl::PipelineOptions::default());
        let mut writer = hlsl::Writer::new(&mut text, &options, &pipeline);
        writer.write(&changed.module, &changed.info, None).expect("HLSL");
        text
    }

    #[test]
    fn vectors_of_conditions_are_arguments_of_a_call() {
        let text = written(
            "fn larger(a: vec3f, b: vec3f) -> vec3f {
                 if a.x > 2.0 {
                     return select(b, a, a.x > b.x);
                 }
                 return 2.0 * select(b, select(a, -a, a < b), a > b);
             }
             fn ones(a: vec2u) -> vec2u {
                 let next = larger(vec3f(1.0), vec3f(2.0));
                 return select(a, vec2u(u32(next.x)), a == vec2u(1));
             }",
        );
        let calls = text.matches(" = choose").count();
        assert_eq!(calls, 3, "{text}");
        assert!(text.contains("float3 choose(bool3 condition, float3 accept, float3 reject)"));
        assert!(text.contains("uint2 choose_1(bool2 condition_1"), "{text}");
        // The scalar stays as it was, in the branch.
        assert!(text.contains("? a : b"), "{text}");
        assert_eq!(text.matches('?').count(), 1 + 3 + 2, "{text}");
    }

    #[test]
    fn modules_without_such_choices_stay() {
        let valid = parse("fn f(a: f32) -> f32 { return select(1.0, 2.0, a > 1.0); }");
        assert!(with_calls(&valid.expect("a module")).expect("no error").is_none());
    }
}
