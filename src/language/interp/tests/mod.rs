//! WGSL snippets against values computed by other means. Snippets take their operands as arguments,
//! lest naga folds them.

mod composites;
mod control;
mod conversions;
mod errors;
mod floats;
mod folding;
mod integers;
mod lanes;
mod packing;
mod precision;
mod random;
mod resources;
mod shared;
mod textures;
mod vectors;

use super::{FunctionOptions, Literals, Precision, Program, Value};
use crate::diag::Diagnostic;

/// Module that naga's validator accepts.
fn module(source: &str) -> naga::Module {
    #[expect(
        clippy::disallowed_methods,
        reason = "tests of types and functions that our own shaders may not use"
    )]
    let module = naga::front::wgsl::parse_str(source)
        .unwrap_or_else(|e| panic!("{}", e.emit_to_string(source)));
    #[expect(clippy::disallowed_methods, reason = "as above")]
    let mut validator = naga::valid::Validator::new(
        naga::valid::ValidationFlags::all(),
        naga::valid::Capabilities::all(),
    );
    if let Err(problem) = validator.validate(&module) {
        panic!("{}", problem.emit_to_string(source));
    }
    module
}

/// Compiles `f` of the source.
fn compile(source: &str) -> Result<Program, Diagnostic> {
    Program::compile(&module(source), "f", FunctionOptions::default())
}

/// Runs `f` of the source in f64.
fn run(source: &str, arguments: &[Value]) -> Value {
    run_in(Precision::F64, source, arguments)
}

fn run_in(precision: Precision, source: &str, arguments: &[Value]) -> Value {
    compile(source)
        .and_then(|program| program.call(arguments, precision))
        .unwrap_or_else(|e| panic!("{e}"))
}

/// Value of an expression over arguments `a`, `b`, `c`, `d`, whose types and that of the result are
/// given as `f32, i32 -> f32`.
fn eval(signature: &str, expression: &str, arguments: &[Value]) -> Value {
    run(&source(signature, expression), arguments)
}

fn source(signature: &str, expression: &str) -> String {
    let (types, result) = signature.split_once("->").expect("a signature");
    let parameters: Vec<String> = types
        .split(';')
        .zip(["a", "b", "c", "d"])
        .map(|(ty, name)| format!("{name}: {}", ty.trim()))
        .collect();
    format!("fn f({}) -> {result} {{ return {expression}; }}", parameters.join(", "))
}

/// Float value of an expression over float arguments.
fn float(expression: &str, arguments: &[f64]) -> f64 {
    let types = vec!["f32"; arguments.len()].join(";");
    let arguments: Vec<Value> = arguments.iter().map(|&x| x.into()).collect();
    let Value::Float(x) = eval(&format!("{types} -> f32"), expression, &arguments) else {
        panic!("not a float")
    };
    x
}

/// i32 value of an expression over i32 arguments.
fn int(expression: &str, arguments: &[i32]) -> i32 {
    let types = vec!["i32"; arguments.len()].join(";");
    let arguments: Vec<Value> = arguments.iter().map(|&x| x.into()).collect();
    let Value::I32(x) = eval(&format!("{types} -> i32"), expression, &arguments) else {
        panic!("not an i32")
    };
    x
}

/// u32 value of an expression over u32 arguments.
fn uint(expression: &str, arguments: &[u32]) -> u32 {
    let types = vec!["u32"; arguments.len()].join(";");
    let arguments: Vec<Value> = arguments.iter().map(|&x| x.into()).collect();
    let Value::U32(x) = eval(&format!("{types} -> u32"), expression, &arguments) else {
        panic!("not a u32")
    };
    x
}

/// Checks that all components are within a relative or absolute error.
#[track_caller]
fn assert_close(actual: &Value, expected: &[f64], tolerance: f64) {
    let actual = actual.components().expect("numbers");
    assert_eq!(actual.len(), expected.len());
    for (a, e) in actual.iter().zip(expected) {
        assert!((a - e).abs() <= tolerance * e.abs().max(1.0), "{actual:?} is not {expected:?}");
    }
}
