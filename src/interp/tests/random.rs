//! Random expressions against the same computed by Rust.

use proptest::prelude::*;

use super::*;

/// An expression over three arguments.
#[derive(Clone, Debug)]
enum Tree {
    Leaf(usize),
    Unary(&'static str, Box<Tree>),
    Binary(&'static str, Box<Tree>, Box<Tree>),
    /// `select(a, b, a < b)` of three.
    Choose(Box<[Tree; 3]>),
}

impl Tree {
    /// As WGSL writes it. Names of functions are letters, those of operators are not.
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

    /// Computes it, given what the names mean.
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

fn trees(unary: &'static [&'static str], binary: &'static [&'static str]) -> impl Strategy<Value = Tree> {
    let leaf = (0..3_usize).prop_map(Tree::Leaf);
    leaf.prop_recursive(5, 40, 3, move |inner| {
        let pair = (inner.clone(), inner.clone());
        let triple = [inner.clone(), inner.clone(), inner.clone()];
        prop_oneof![
            (prop::sample::select(unary), inner).prop_map(|(name, x)| Tree::Unary(name, Box::new(x))),
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
    }

    #[test]
    fn integers_agree(
        tree in trees(&["-", "~", "abs", "countOneBits"], &["+", "-", "*", "/", "%", "&", "|", "^", "min", "max"]),
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
}
