//! Random expressions against the same expressions computed by Rust.

use proptest::prelude::*;

use super::super::{Bindings, LANES};
use super::lanes::{bind, stage};
use super::*;

/// Expression over three arguments.
#[derive(Clone, Debug)]
enum Tree {
    Leaf(usize),
    Unary(&'static str, Box<Tree>),
    Binary(&'static str, Box<Tree>, Box<Tree>),
    /// `select(a, b, a < b)` of three.
    Choose(Box<[Tree; 3]>),
}

impl Tree {
    /// WGSL text of the expression. Names of functions are letters, those of operators are not.
    fn wgsl(&self) -> String {
        match self {
            Self::Leaf(index) => ["a", "b", "c"][*index].to_owned(),
            Self::Unary(name, x) => format!("{name}({})", x.wgsl()),
            Self::Binary(name, x, y) if name.starts_with(char::is_alphabetic) => {
                format!("{name}({}, {})", x.wgsl(), y.wgsl())
            }
            Self::Binary(name, x, y) => format!("({} {name} {})", x.wgsl(), y.wgsl()),
            Self::Choose(parts) => {
                let [x, y, z] = parts.each_ref().map(Tree::wgsl);
                format!("select({x}, {y}, {x} < {z})")
            }
        }
    }

    /// Computes the expression, given the meanings of the names.
    fn compute<T: Copy + PartialOrd>(
        &self,
        leaves: [T; 3],
        unary: &impl Fn(&str, T) -> T,
        binary: &impl Fn(&str, T, T) -> T,
    ) -> T {
        let compute = |tree: &Self| tree.compute(leaves, unary, binary);
        match self {
            Self::Leaf(index) => leaves[*index],
            Self::Unary(name, x) => unary(name, compute(x)),
            Self::Binary(name, x, y) => binary(name, compute(x), compute(y)),
            Self::Choose(parts) => {
                let [x, y, z] = parts.each_ref().map(compute);
                if x < z { y } else { x }
            }
        }
    }
}

fn trees(
    unary: &'static [&'static str],
    binary: &'static [&'static str],
) -> impl Strategy<Value = Tree> {
    let leaf = (0..3_usize).prop_map(Tree::Leaf);
    leaf.prop_recursive(5, 40, 3, move |inner| {
        let pair = (inner.clone(), inner.clone());
        let triple = [inner.clone(), inner.clone(), inner.clone()];
        prop_oneof![
            (prop::sample::select(unary), inner)
                .prop_map(|(name, x)| Tree::Unary(name, Box::new(x))),
            (prop::sample::select(binary), pair).prop_map(|(name, (x, y))| Tree::Binary(
                name,
                Box::new(x),
                Box::new(y)
            )),
            triple.prop_map(|parts| Tree::Choose(Box::new(parts))),
        ]
    })
}

macro_rules! float_functions {
    ($float:ty) => {
        (
            |name: &str, x: $float| match name {
                "-" => -x,
                "abs" => x.abs(),
                "sqrt" => x.sqrt(),
                "floor" => x.floor(),
                "round" => x.round_ties_even(),
                _ => unreachable!(),
            },
            |name: &str, x: $float, y: $float| match name {
                "+" => x + y,
                "-" => x - y,
                "*" => x * y,
                "/" => x / y,
                "%" => x % y,
                "step" => <$float>::from(u8::from(x <= y)),
                _ => unreachable!(),
            },
        )
    };
}

/// Checks that lanes give the results of single calls, bit for bit.
fn lanes_agree(
    source: &str,
    precision: Precision,
    lanes_arguments: &[Vec<Value>],
) -> Result<(), TestCaseError> {
    let program = stage(source, "f");
    let bound = bind(&program, &Bindings::new(), precision);
    let (mut lanes, mut machine) = (bound.lanes().unwrap(), bound.machine());
    for (lane, arguments) in lanes_arguments.iter().enumerate() {
        lanes.set(lane, arguments).unwrap();
    }
    lanes.run(lanes_arguments.len()).unwrap();
    for (lane, arguments) in lanes_arguments.iter().enumerate() {
        let [together, alone] = [lanes.get(lane), machine.call(arguments).unwrap()]
            .map(|value| value.as_f64().unwrap());
        let agree = together.to_bits() == alone.to_bits() || together.is_nan() && alone.is_nan();
        prop_assert!(agree, "lane {lane}: {together:?} is not {alone:?} in {source}");
    }
    Ok(())
}

/// Statements over `a`, `b`, `c` and the read-only `n`. Loops end, because each counts its rounds.
fn statements() -> impl Strategy<Value = String> {
    let name = || prop::sample::select(vec!["a", "b", "c"]);
    let expression = move || {
        let operator = prop::sample::select(vec!["+", "-", "*", "^", "&", "/", "%"]);
        prop_oneof![
            (name(), operator, name()).prop_map(|(x, op, y)| format!("({x} {op} {y})")),
            (name(), -3..9).prop_map(|(x, i)| format!("({x} + {i})")),
            (name(), name()).prop_map(|(x, y)| format!("g({x}, {y})")),
            (0..3).prop_map(|i| format!("(n >> {i}u)")),
        ]
    };
    let condition =
        move || (expression(), 2..5, 0..3).prop_map(|(x, n, r)| format!("({x} % {n} == {r})"));
    let leaf = prop_oneof![
        6 => (name(), expression()).prop_map(|(x, y)| format!("{x} = {y};")),
        1 => condition().prop_map(|c| format!("if {c} {{ return a; }}")),
        1 => name().prop_map(|x| format!("h(&{x});")),
    ];
    leaf.prop_recursive(4, 40, 4, move |inner| {
        let block = prop::collection::vec(inner, 1..4).prop_map(|statements| statements.join("\n"));
        let exit = (condition(), prop::sample::select(vec!["break", "continue"]));
        prop_oneof![
            (condition(), block.clone(), block.clone())
                .prop_map(|(c, yes, no)| format!("if {c} {{ {yes} }} else {{ {no} }}")),
            (name(), block.clone(), exit, block.clone()).prop_map(|(x, first, (c, exit), then)| {
                format!(
                    "for (var i = 0; i < ({x} & 7); i++) {{ {first} if {c} {{ {exit}; }} {then} }}"
                )
            }),
            (block.clone(), condition(), block.clone()).prop_map(|(body, c, next)| {
                let next = next.replace("return a;", "a += 1;");
                format!(
                    "{{ var k = 0; loop {{ {body} continuing {{ {next} k += 1; break if {c} || \
                         k > 3; }} }} }}"
                )
            }),
            (expression(), block.clone(), block.clone(), block).prop_map(|(x, one, two, rest)| {
                format!(
                    "switch {x} % 3 {{ case 0: {{ {one} }} case 1, -1: {{ {two} break; }} \
                     default: {{ {rest} }} }}"
                )
            }),
        ]
    })
}

fn same(a: f64, b: f64) -> bool {
    a == b || a.is_nan() && b.is_nan()
}

proptest! {
    #[test]
    fn floats_agree(
        tree in trees(&["-", "abs", "sqrt", "floor", "round"], &["+", "-", "*", "/", "%", "step"]),
        leaves in prop::array::uniform3(prop_oneof![any::<f32>(), -10.0_f32..10.0]),
    ) {
        let program = compile(&source("f32; f32; f32 -> f32", &tree.wgsl())).unwrap();
        let arguments = leaves.map(|x| f64::from(x).into());
        let (unary, binary) = float_functions!(f64);
        let expected = tree.compute(leaves.map(f64::from), &unary, &binary);
        let actual = program.call(&arguments, Precision::F64).unwrap().as_f64().unwrap();
        prop_assert!(same(actual, expected), "f64: {actual} is not {expected}");
        let (unary, binary) = float_functions!(f32);
        let expected = f64::from(tree.compute(leaves, &unary, &binary));
        let actual = program.call(&arguments, Precision::F32).unwrap().as_f64().unwrap();
        prop_assert!(same(actual, expected), "f32: {actual} is not {expected}");
        let [x, y, z] = leaves.map(|x| Value::from(f64::from(x)));
        let turned = [
            vec![x.clone(), y.clone(), z.clone()], vec![z.clone(), x.clone(), y.clone()],
            vec![y, z, x]
        ];
        for precision in [Precision::F64, Precision::F32] {
            lanes_agree(&source("f32; f32; f32 -> f32", &tree.wgsl()), precision, &turned)?;
        }
    }

    #[test]
    fn integers_agree(
        tree in trees(
            &["-", "~", "abs", "countOneBits"],
            &["+", "-", "*", "/", "%", "&", "|", "^", "min", "max"]
        ),
        leaves in prop::array::uniform3(prop_oneof![any::<i32>(), -3..4]),
    ) {
        let unary = |name: &str, x: i32| match name {
            "-" => x.wrapping_neg(),
            "~" => !x,
            "abs" => x.wrapping_abs(),
            _ => x.count_ones() as i32,
        };
        let binary = |name: &str, x: i32, y: i32| match name {
            "+" => x.wrapping_add(y),
            "-" => x.wrapping_sub(y),
            "*" => x.wrapping_mul(y),
            "/" => if y == 0 { x } else { x.wrapping_div(y) },
            "%" => if y == 0 { 0 } else { x.wrapping_rem(y) },
            "&" => x & y,
            "|" => x | y,
            "^" => x ^ y,
            "min" => x.min(y),
            _ => x.max(y),
        };
        let actual = run(&source("i32; i32; i32 -> i32", &tree.wgsl()), &leaves.map(Value::from));
        prop_assert_eq!(actual, tree.compute(leaves, &unary, &binary).into());
    }

    #[test]
    fn lanes_part_and_meet_as_if_alone(
        body in prop::collection::vec(statements(), 1..6),
        seeds in prop::array::uniform4(-100..100),
    ) {
        let source = format!(
            "fn g(x: i32, y: i32) -> i32 {{
                var r = x;
                for (var i = 0; i < (y & 3); i++) {{ if r % 3 == 1 {{ return r + y; }} r += i * y; \
                }}
                return r - y;
            }}
            fn h(p: ptr<function, i32>) {{ if *p > 50 {{ *p /= 2; return; }} *p = g(*p, 3) + 1; }}
            fn f(x: i32, y: i32, n: i32) -> i32 {{ var a = x; var b = y; var c = n;\n{}\nreturn a \
            + 3 * b + 7 * c; }}",
            body.join("\n")
        );
        let arguments: Vec<Vec<Value>> = (0..LANES as i32)
            .map(|lane| {
                [seeds[0] + lane, seeds[1] * lane, seeds[2] ^ (lane * seeds[3])]
                    .map(Value::I32)
                    .to_vec()
            })
            .collect();
        lanes_agree(&source, Precision::F64, &arguments)?;
    }
}
