//! The forms of `@where` rules give what their functions give, wherever the facts hold.

use chiaro_test_support::random::Random;

use super::facts;
use crate::compile::intervals::{self, Ranges};
use crate::document::Tier;
use crate::interp::{
    Derivatives, FunctionOptions, Precision, Program, Scalar, ScalarKind, Shape, Value,
};
use crate::library::{Fact, FormRule, Library, NodeModule};

/// Arguments that each rule is tried with, where its facts hold.
const WANTED: usize = 200;
/// Arguments drawn for a rule at most.
const MOST_DRAWN: usize = 400_000;

/// A number of the sizes that looks have, exact in f32.
fn number(random: &mut Random) -> f64 {
    let x = match random.index(8) {
        0 => *random.pick(&[0.0, 1.0, -1.0, 0.5, 2.0, 48.0]),
        1..=3 => random.unit(),
        4 => random.between(-0.1, 0.1),
        5 => random.between(-2.0, 2.0),
        6 => random.between(-100.0, 100.0),
        _ => random.between(-5e3, 5e3),
    };
    f64::from(x as f32)
}

fn vector(random: &mut Random, size: usize) -> Value {
    let numbers: Vec<f64> = match random.index(4) {
        0 => vec![number(random); size],
        1 => {
            let raw: Vec<f64> = (0..size).map(|_| random.between(-1.0, 1.0)).collect();
            let length = raw.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
            raw.into_iter().map(|x| f64::from((x / length) as f32)).collect()
        }
        _ => (0..size).map(|_| number(random)).collect(),
    };
    Value::vec(&numbers)
}

fn argument(random: &mut Random, shape: &Shape) -> Value {
    match shape {
        Shape::Scalar(ScalarKind::Bool) => Value::Bool(random.chance(0.5)),
        Shape::Scalar(_) => Value::Float(number(random)),
        Shape::Vector { size, .. } => vector(random, *size),
        other => panic!("no rule takes {other:?} yet"),
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    match (value.parts(), value.components()) {
        (Some(parts), _) => parts.iter().flat_map(numbers).collect(),
        (None, Some(components)) => components.to_vec(),
        (None, None) => value.as_scalar().map(Scalar::as_f64).into_iter().collect(),
    }
}

/// Greatest size of the numbers of arguments, at least 1: rounding goes by it.
fn scale(arguments: &[Value]) -> f64 {
    arguments.iter().flat_map(numbers).fold(1.0, |most, x| most.max(x.abs()))
}

/// True for arguments at which a rule says that its form differs: a vector too short to have a
/// direction, and a phase that rounding has left nothing of.
fn is_excepted(function: &str, arguments: &[Value]) -> bool {
    let first = arguments.first().map(numbers).unwrap_or_default();
    let length = first.iter().map(|x| x * x).sum::<f64>().sqrt();
    match function {
        "normalize_or" | "normalize_quick" | "normalize_moderate" => length < 1e-14,
        "sine_of" | "cosine_of" => length > 10_000.0,
        _ => false,
    }
}

struct RuleTrial<'a> {
    module: &'a NodeModule,
    function: &'a str,
    rule: &'a FormRule,
}

impl RuleTrial<'_> {
    fn form(&self) -> Program {
        let (valid, literals) = self.module.read(self.function).expect("it is valid");
        let options = FunctionOptions {
            derivatives: Derivatives::Zero,
            literals: Some(literals),
            ..FunctionOptions::default()
        };
        Program::compile(&valid.module, &self.rule.function, options).expect("it runs")
    }

    /// The number of arguments at which the facts held.
    fn run(&self, random: &mut Random) -> usize {
        let (whole, form) = (self.module.program(self.function).expect("it runs"), self.form());
        let mut held = 0;
        for _ in 0..MOST_DRAWN {
            let arguments: Vec<Value> = whole
                .parameters()
                .iter()
                .map(|parameter| argument(random, &parameter.shape))
                .collect();
            let ranges: Vec<Ranges> = arguments.iter().map(intervals::of_value).collect();
            let holds = facts::all_hold(&self.rule.facts, Tier::Fast, &ranges);
            if !holds || is_excepted(self.function, &arguments) {
                continue;
            }
            held += 1;
            for (precision, rounding) in [(Precision::F64, 1e-8), (Precision::F32, 2e-6)] {
                let call = |program: &Program| {
                    numbers(&program.call(&arguments, precision).expect("it ends"))
                };
                // What counts as unit is so but for roundings of f32.
                let is_of_units = self.rule.facts.iter().any(|fact| matches!(fact, Fact::Unit(_)));
                let rounding = if is_of_units { 4e-6 } else { rounding };
                let bound = self.rule.bound.unwrap_or_default() + rounding;
                for (a, b) in call(&whole).into_iter().zip(call(&form)) {
                    let size = scale(&arguments).max(a.abs());
                    assert!(
                        (a - b).abs() <= bound * size,
                        "{} in {precision:?}: {a} or {b} for {arguments:?}",
                        self.rule.function
                    );
                }
            }
            if held == WANTED {
                break;
            }
        }
        held
    }
}

#[test]
fn forms_give_what_functions_give() {
    let module = &Library::built_in().nodes["profile"].module;
    let mut functions: Vec<&str> = module.ruled_functions().collect();
    functions.sort_unstable();
    assert!(functions.len() > 15, "{functions:?}");
    let mut random = Random::new(17);
    for function in functions {
        for rule in module.rules(function) {
            let held = RuleTrial { module, function, rule }.run(&mut random);
            assert!(held >= 20, "the facts of `{}` held {held} times", rule.function);
            let is_cheaper = rule.facts.iter().any(|fact| matches!(fact, Fact::Tier(_)));
            assert!(is_cheaper || rule.bound.is_none(), "`{}` is exact", rule.function);
        }
    }
}
