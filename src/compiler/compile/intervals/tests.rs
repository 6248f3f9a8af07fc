//! Results of a function lie within what the ranges of its arguments say.

use super::range::{Bools, Floats, Ints, Length};
use super::*;
use crate::interp::{Derivatives, FunctionOptions, Precision, Program, Scalar, ScalarKind, Shape};
use crate::library::Library;

/// Splitmix64: the tests draw the same boxes on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn index(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// A number such as looks hold, or one at the end of what f32 holds.
    fn number(&mut self) -> f64 {
        let special = [0.0, -0.0, 1.0, -1.0, 0.5, 2.0, std::f64::consts::PI, 1e-3, -7.5, 255.0];
        let wild = [f64::INFINITY, f64::NEG_INFINITY, 3.4e38, -3.4e38, 1e-38, 1e-45, 1e30, -1e20];
        let x = match self.index(10) {
            0..=2 => special[self.index(special.len())],
            3 => wild[self.index(wild.len())],
            4..=7 => 4.0 * self.unit() - 2.0,
            _ => 200.0 * self.unit() - 100.0,
        };
        f64::from(x as f32)
    }

    fn range(&mut self, kind: ScalarKind) -> Range {
        match kind {
            ScalarKind::Bool => {
                Range::Bool([Bools::ALL, Bools::of(true), Bools::of(false)][self.index(3)])
            }
            ScalarKind::I32 => {
                let low = self.index(20) as i64 - 5;
                Range::Int(Ints::between(low, low + self.index(6) as i64))
            }
            ScalarKind::U32 => {
                let low = self.index(6) as i64;
                Range::Int(Ints::between(low, low + self.index(12) as i64))
            }
            ScalarKind::Float => {
                let low = self.number();
                let high = match self.index(4) {
                    0 => low,
                    1 => low + self.unit(),
                    _ => self.number(),
                };
                let (low, high) = (low.min(high), f64::from(low.max(high) as f32));
                let minus_zero = low <= 0.0 && high >= 0.0;
                let nan = self.index(12) == 0;
                Range::Float(Floats {
                    low: low + 0.0,
                    high: high + 0.0,
                    nan,
                    minus_zero,
                    length: Length::Any,
                })
            }
        }
    }

    /// Value within a range, often at its ends.
    fn within(&mut self, range: Range, kind: ScalarKind) -> Scalar {
        match range {
            Range::Bool(x) => Scalar::Bool(x.point().unwrap_or(self.index(2) == 0)),
            Range::Int(x) => {
                let x = x.low + self.index((x.high - x.low + 1) as usize) as i64;
                if kind == ScalarKind::U32 { Scalar::U32(x as u32) } else { Scalar::I32(x as i32) }
            }
            Range::Float(x) => {
                if x.nan && self.index(3) == 0 {
                    return Scalar::Float(f64::NAN);
                }
                let inner = x.low.max(-1e38) + (x.high.min(1e38) - x.low.max(-1e38)) * self.unit();
                let inner =
                    if x.has(inner) { f64::from(inner as f32).clamp(x.low, x.high) } else { x.low };
                let special = [x.low, x.high, 0.0, -0.0, 1.0, 0.5, 1e-3, -1.0];
                let pick = special[self.index(special.len())];
                let y = if self.index(2) == 0 && x.has(pick) { pick } else { inner };
                Scalar::Float(if y == 0.0 && !x.minus_zero { 0.0 } else { y })
            }
        }
    }
}

fn kinds(shape: &Shape, out: &mut Vec<ScalarKind>) {
    match shape {
        Shape::Scalar(kind) => out.push(*kind),
        Shape::Vector { kind, size } => out.extend(vec![*kind; *size]),
        Shape::Matrix { columns, rows } => out.extend(vec![ScalarKind::Float; columns * rows]),
        Shape::Array { element, count } => (0..*count).for_each(|_| kinds(element, out)),
        Shape::Struct { members, .. } => members.iter().for_each(|(_, shape)| kinds(shape, out)),
    }
}

fn built(shape: &Shape, scalars: &mut impl Iterator<Item = Scalar>) -> interp::Value {
    match shape {
        Shape::Scalar(_) => scalars.next().expect("enough").into(),
        Shape::Vector { size, .. } => interp::Value::Vector(scalars.take(*size).collect()),
        Shape::Matrix { columns, rows } => interp::Value::Matrix {
            columns: *columns,
            components: scalars.take(columns * rows).map(Scalar::as_f64).collect(),
        },
        Shape::Array { element, count } => {
            interp::Value::Array((0..*count).map(|_| built(element, scalars)).collect())
        }
        Shape::Struct { members, .. } => {
            interp::Value::Struct(members.iter().map(|(_, shape)| built(shape, scalars)).collect())
        }
    }
}

/// Runs a function on random boxes and on points within; says how many results were followed and
/// how many narrowed.
fn hold(
    name: &str,
    program: &Program,
    follow: &dyn Fn(&[Ranges]) -> Option<Ranges>,
    random: &mut Random,
    boxes: usize,
) -> [usize; 2] {
    let mut machines = [program.machine(Precision::F32), program.machine(Precision::F64)];
    let mut counts = [0; 2];
    for _ in 0..boxes {
        let shapes: Vec<&Shape> =
            program.parameters().iter().map(|parameter| &parameter.shape).collect();
        let mut arguments: Vec<Ranges> = Vec::new();
        for shape in &shapes {
            let mut of = Vec::new();
            kinds(shape, &mut of);
            arguments.push(of.iter().map(|kind| random.range(*kind)).collect());
        }
        let Some(result) = follow(&arguments) else { continue };
        counts[0] += 1;
        counts[1] += usize::from(
            result.iter().any(|r| r.bounds().is_some_and(|[low, high]| high - low < 1e6)),
        );
        for _ in 0..12 {
            let values: Vec<interp::Value> = shapes
                .iter()
                .zip(&arguments)
                .map(|(shape, ranges)| {
                    let mut of = Vec::new();
                    kinds(shape, &mut of);
                    let scalars: Vec<Scalar> = of
                        .iter()
                        .zip(ranges.iter())
                        .map(|(kind, range)| random.within(*range, *kind))
                        .collect();
                    built(shape, &mut scalars.into_iter())
                })
                .collect();
            for machine in &mut machines {
                let Ok(value) = machine.call(&values) else { continue };
                let mut scalars = Vec::new();
                push_scalars(&value, &mut |scalar| scalars.push(scalar));
                assert_eq!(scalars.len(), result.len(), "{name}");
                for (index, (scalar, range)) in scalars.iter().zip(result.iter()).enumerate() {
                    assert!(
                        range.contains(*scalar),
                        "{name}: scalar {index} is {scalar:?}, outside of \
                         {range:?}\n{values:?}\n{arguments:?}"
                    );
                }
                hold_lengths(name, &scalars, &result);
            }
        }
    }
    counts
}

/// Vectors of a result are as long as their ranges say.
fn hold_lengths(name: &str, scalars: &[Scalar], result: &[Range]) {
    let length = |range: &Range| match range {
        Range::Float(x) if !x.nan => x.length,
        _ => Length::Any,
    };
    let mut at = 0;
    while at + 3 <= result.len() {
        let known = result[at..at + 3].iter().map(length).min().unwrap_or_default();
        if known == Length::Any {
            at += 1;
            continue;
        }
        let square: f64 = scalars[at..at + 3].iter().map(|x| x.as_f64() * x.as_f64()).sum();
        let (found, slack) = (square.sqrt(), 1e-5);
        let is_right = found <= 1.0 + slack && (known != Length::One || found >= 1.0 - slack);
        assert!(is_right, "{name}: a vector of length {found} is {known:?}");
        at += 3;
    }
}

/// Every function of every node on random boxes; gives the functions, the boxes that were followed
/// and those that were narrowed.
fn hold_nodes(seed: u64, boxes: usize) -> [usize; 3] {
    let library = Library::built_in();
    let mut random = Random(seed);
    let mut counts = [0; 3];
    for def in library.nodes.values() {
        let prepared = def.prepare.iter().map(|prepare| prepare.function.clone());
        for function in def.variants.iter().map(|variant| variant.function.clone()).chain(prepared)
        {
            let Ok(program) = def.module.program(&function) else { continue };
            let follow = |arguments: &[Ranges]| call(&def.module, &function, arguments);
            let [followed, narrowed] = hold(&function, &program, &follow, &mut random, boxes);
            counts = [counts[0] + 1, counts[1] + followed, counts[2] + narrowed];
        }
    }
    counts
}

/// Every function of the library on random boxes, those that are known by name on ten times as
/// many.
fn hold_library(seed: u64, boxes: usize) -> usize {
    let mut random = Random(seed);
    let mut known = 0;
    for (path, _) in wgsl::SHADER_LIBRARY {
        let name = path.rsplit('/').next().unwrap_or(path).trim_end_matches(".wgsl");
        let text = format!("import chiaro::{name};\n");
        let linked =
            wgsl::link(&[wgsl::NamedSource { name: "test", text: &text }]).expect("it links");
        let valid = wgsl::parse(&linked.text).expect("it is valid");
        for (_, function) in valid.module.functions.iter() {
            let Some(of) = &function.name else { continue };
            let options =
                FunctionOptions { derivatives: Derivatives::Zero, ..FunctionOptions::default() };
            let Ok(program) = Program::compile(&valid.module, of, options) else { continue };
            let is_known = library::NAMES.contains(&of.as_str());
            known += usize::from(is_known);
            let follow = |arguments: &[Ranges]| call_plain(&valid, of, arguments);
            hold(of, &program, &follow, &mut random, if is_known { 10 * boxes } else { boxes });
        }
    }
    known
}

#[test]
fn every_node_stays_within_its_ranges() {
    let [functions, followed, narrowed] = hold_nodes(1, 40);
    assert!(functions > 100, "{functions} functions");
    let boxes = functions * 40;
    assert!(followed * 10 > boxes * 9, "{followed} of {boxes} boxes were followed");
    assert!(narrowed * 5 > boxes, "{narrowed} of {boxes} boxes were narrowed");
}

/// The functions of the library themselves, those that are known by name among them.
#[test]
fn every_function_of_the_library_stays_within_its_ranges() {
    assert!(hold_library(2, 40) >= library::NAMES.len());
    assert_eq!(LIBRARY_TEXTS.len(), library::NAMES.len());
}

#[test]
#[ignore = "minutes: the same on many more boxes"]
#[expect(clippy::print_stdout, reason = "how much was tried is the point")]
fn many_more_boxes() {
    for seed in 10..20 {
        let [functions, followed, narrowed] = hold_nodes(seed, 200);
        println!(
            "{functions} functions, {followed} of {} boxes followed, {narrowed} narrowed",
            functions * 200
        );
        hold_library(seed + 100, 200);
    }
}

fn module(text: &str) -> ValidModule {
    wgsl::parse(text).expect("it is valid")
}

fn float(low: f64, high: f64) -> Ranges {
    [Range::Float(Floats::between(low, high))].into()
}

fn bounds_of(valid: &ValidModule, arguments: &[Ranges]) -> Option<[f64; 2]> {
    run(valid, "f", arguments, &|_| false).and_then(|ranges| ranges[0].bounds())
}

#[test]
fn open_conditions_narrow_what_is_behind_them() {
    let valid = module("fn f(x: f32) -> f32 { if x <= 0.0 { return 1.0; } return 1.0 + x; }");
    let [low, high] = bounds_of(&valid, &[float(-3.0, 2.0)]).expect("it is followed");
    assert!((0.999_999..=1.0).contains(&low) && high == 3.0, "{low} {high}");
    let valid = module(
        "fn f(x: f32, k: u32) -> f32 { if x <= 0.0 || k == 2u { return 1.0; } return 0.0; }",
    );
    let two: Ranges = [Range::Int(Ints::between(2, 2))].into();
    assert_eq!(bounds_of(&valid, &[float(-3.0, 2.0), two]), Some([1.0, 1.0]));
    let valid = module("fn f(x: f32) -> f32 { return select(x, 0.0, x < 0.0); }");
    assert_eq!(bounds_of(&valid, &[float(-3.0, 2.0)]), Some([0.0, 2.0]));
}

#[test]
fn loops_are_followed_and_endless_ones_are_not_believed() {
    let valid = module(
        "fn f(x: f32) -> f32 { var s = 0.0; for (var i = 0; i < 8; i++) { s += x; } return s; }",
    );
    assert_eq!(bounds_of(&valid, &[float(0.0, 0.5)]), Some([0.0, 4.0]));
    // The number of turns depends on x: a variable that the loop writes may be anything, and one
    // that it does not write stays known.
    let valid = module(
        "fn f(x: f32) -> f32 \
         { var s = 0.0; var t = 3.0; loop { s += 1.0; if s > x { break; } } return t + 0.0 * \
         min(max(s, 0.0), 1.0); }",
    );
    let bounds = bounds_of(&valid, &[float(0.0, 1e9)]);
    assert!(bounds.is_none_or(|[low, high]| low <= 3.0 && high >= 3.0), "{bounds:?}");
}

#[test]
fn an_ambient_profile_is_one_everywhere() {
    let def = &Library::built_in().nodes["profile"];
    let shape = def.module.program("profile_prepare").expect("it runs");
    let numbers = [std::f64::consts::PI, 1.0, 2.0].map(interp::Value::Float);
    let shape = of_value(&shape.call(&numbers, Precision::F64).expect("it runs"));
    let angle: Ranges = vec![Range::Float(Floats::between(0.0, 1.0)); 2].into();
    let any: Ranges = [Range::Float(Floats::ALL)].into();
    let tone = call(&def.module, "profile", &[angle, any, shape]).expect("it is followed");
    assert_eq!(exactly(&tone, &Type::Float), Some(interp::Value::Float(1.0)));
}
