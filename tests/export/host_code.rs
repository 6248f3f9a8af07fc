//! Host code in each language computes what the interpreter computes: every function of the library
//! that a language takes, run by the language's own program.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;

use serde_json::Value as Json;

use crate::support::godot::Godot;
use crate::support::random::Random;
use crate::support::validators::{say, tools_are_required};
use chiaro::export::host_code::{
    CSHARP, GDSCRIPT, HostLanguage, JAVASCRIPT, PYTHON, RUST, translate,
};
use chiaro::interp::{FunctionOptions, Precision, Program, ScalarKind, Shape, Value};
use chiaro::library::Library;

/// Number of argument lists that each function is tried with.
const TRIES: usize = 12;

/// Relative difference that is rounding: functions of the language's own library differ in the
/// last digits, and cancellation makes more of that.
const TOLERANCE: f64 = 1e-6;

/// A value of a shape. Numbers are of the size that shading has, with whole and round ones among
/// them.
fn value(shape: &Shape, random: &mut Random) -> Value {
    let scalar = |kind: ScalarKind, random: &mut Random| match kind {
        ScalarKind::Bool => Value::Bool(random.chance(0.5)),
        ScalarKind::I32 => Value::I32(random.index(9) as i32 - 2),
        ScalarKind::U32 => Value::U32(random.index(9) as u32),
        ScalarKind::Float => Value::Float(match random.index(4) {
            0 => *random.pick(&[0.0, 0.25, 0.5, 1.0, 2.0, -1.0]),
            1 => random.between(-3.0, 3.0),
            _ => random.unit(),
        }),
    };
    match shape {
        Shape::Scalar(kind) => scalar(*kind, random),
        Shape::Vector { kind, size } => {
            Value::Vector((0..*size).filter_map(|_| scalar(*kind, random).as_scalar()).collect())
        }
        Shape::Matrix { columns, rows } => Value::Matrix {
            columns: *columns,
            components: (0..columns * rows).map(|_| random.between(-1.0, 1.0)).collect(),
        },
        Shape::Array { element, count } => {
            Value::Array((0..*count).map(|_| value(element, random)).collect())
        }
        Shape::Struct { members, .. } => {
            Value::Struct(members.iter().map(|(_, shape)| value(shape, random)).collect())
        }
    }
}

/// A language with the program that runs it and the way that its values are written.
struct Runner {
    language: &'static HostLanguage,
    /// Program that runs the file; empty for Godot, which runs in a browser.
    command: &'static str,
    file: &'static str,
    /// Program and arguments that make a program of the file, in the same folder, to be run in its
    /// place; none for languages that are read.
    compiler: Option<(&'static str, &'static [&'static str])>,
    /// A vector, a matrix or an array of its parts.
    list: fn(&Shape, &[String]) -> String,
    /// Text before a struct's members.
    structure: fn(&str) -> String,
    /// A scalar of a kind.
    scalar: fn(ScalarKind, f64) -> String,
    /// A member of a struct.
    member: fn(&str, &str) -> String,
    /// The text of a program that runs all cases and prints the results as JSON: a list of lists of
    /// numbers for each function, null for what is no number.
    program: fn(&[Case]) -> String,
}

/// All languages that are tried.
const RUNNERS: [Runner; 5] = [
    Runner {
        language: &JAVASCRIPT,
        command: "node",
        file: "cases.mjs",
        compiler: None,
        list: in_brackets,
        structure: |_| String::new(),
        scalar: |kind, x| match kind {
            ScalarKind::Bool => (x != 0.0).to_string(),
            _ => format!("{x:?}"),
        },
        member: |name, value| format!("{name}: {value}"),
        program: javascript,
    },
    Runner {
        language: &PYTHON,
        command: "python3",
        file: "cases.py",
        compiler: None,
        list: in_brackets,
        structure: |_| String::new(),
        scalar: |kind, x| match kind {
            ScalarKind::Bool => if x != 0.0 { "True" } else { "False" }.to_owned(),
            ScalarKind::I32 | ScalarKind::U32 => format!("{x}"),
            ScalarKind::Float => format!("{x:?}"),
        },
        member: |name, value| format!("\"{name}\": {value}"),
        program: python,
    },
    Runner {
        language: &RUST,
        command: "./cases",
        file: "cases.rs",
        compiler: Some((
            "rustc",
            &[
                "--edition",
                "2024",
                "-A",
                "warnings",
                "-C",
                "debuginfo=0",
                "-o",
                "cases",
                "cases.rs",
            ],
        )),
        list: in_brackets,
        structure: |name| format!("{name} "),
        scalar: |kind, x| match kind {
            ScalarKind::Bool => (x != 0.0).to_string(),
            ScalarKind::I32 => format!("{x}_i32"),
            ScalarKind::U32 => format!("{x}_u32"),
            ScalarKind::Float => format!("{x:?}_f64"),
        },
        member: |name, value| format!("{name}: {value}"),
        program: rust,
    },
    Runner {
        language: &GDSCRIPT,
        command: "",
        file: "",
        compiler: None,
        list: in_brackets,
        structure: |_| String::new(),
        scalar: |kind, x| match kind {
            ScalarKind::Bool => (x != 0.0).to_string(),
            ScalarKind::I32 | ScalarKind::U32 => format!("{x}"),
            ScalarKind::Float => format!("{x:?}"),
        },
        member: |name, value| format!("\"{name}\": {value}"),
        program: gdscript,
    },
    Runner {
        language: &CSHARP,
        command: "mono",
        file: "cases.cs",
        compiler: Some(("mcs", &["-nologo", "-warn:0", "-out:cases", "cases.cs"])),
        list: |shape, parts| match shape {
            Shape::Array { .. } => {
                format!("new {} {{ {} }}", csharp_type(shape), parts.join(", "))
            }
            _ => format!("new {}({})", csharp_type(shape), parts.join(", ")),
        },
        structure: |name| format!("new {} ", CSHARP.function_name(name)),
        scalar: |kind, x| match kind {
            ScalarKind::Bool => (x != 0.0).to_string(),
            ScalarKind::I32 => format!("{x}"),
            ScalarKind::U32 => format!("{x}u"),
            ScalarKind::Float => format!("{x:?}"),
        },
        member: |name, value| format!("{} = {value}", CSHARP.member_name(name)),
        program: csharp,
    },
];

fn in_brackets(_: &Shape, parts: &[String]) -> String {
    format!("[{}]", parts.join(", "))
}

/// A type as the host code in C# names it.
fn csharp_type(shape: &Shape) -> String {
    let words = |kind: &ScalarKind| match kind {
        ScalarKind::Bool => ("bool", "Bool"),
        ScalarKind::I32 => ("int", "Int"),
        ScalarKind::U32 => ("uint", "UInt"),
        ScalarKind::Float => ("double", "Double"),
    };
    match shape {
        Shape::Scalar(kind) => words(kind).0.to_owned(),
        Shape::Vector { kind, size } => format!("{}{size}", words(kind).1),
        Shape::Matrix { columns, rows } => format!("Double{rows}x{columns}"),
        Shape::Array { element, .. } => format!("{}[]", csharp_type(element)),
        Shape::Struct { name, .. } => CSHARP.function_name(name),
    }
}

impl Runner {
    /// A value as the language has it.
    fn value(&self, shape: &Shape, value: &Value) -> String {
        let list = |parts: Vec<String>| (self.list)(shape, &parts);
        match (shape, value) {
            (Shape::Struct { name, members }, Value::Struct(parts)) => {
                let member = |((name, shape), part): (&(String, Shape), &Value)| {
                    (self.member)(name, &self.value(shape, part))
                };
                let parts: Vec<String> = members.iter().zip(parts).map(member).collect();
                format!("{}{{ {} }}", (self.structure)(name), parts.join(", "))
            }
            (Shape::Array { element, .. }, Value::Array(parts)) => {
                list(parts.iter().map(|part| self.value(element, part)).collect())
            }
            (Shape::Matrix { rows, .. }, Value::Matrix { components, .. }) => {
                let of = Shape::Vector { kind: ScalarKind::Float, size: *rows };
                let column = |column: &[f64]| {
                    let numbers = column.iter().map(|x| (self.scalar)(ScalarKind::Float, *x));
                    (self.list)(&of, &numbers.collect::<Vec<_>>())
                };
                list(components.chunks(*rows).map(column).collect())
            }
            (Shape::Vector { kind, .. }, Value::Vector(scalars)) => {
                list(scalars.iter().map(|it| (self.scalar)(*kind, it.as_f64())).collect())
            }
            (Shape::Scalar(kind), value) => {
                (self.scalar)(*kind, value.as_f64().unwrap_or(f64::NAN))
            }
            _ => String::new(),
        }
    }

    /// Results that a program of the cases prints; `None`, said aloud, where nothing runs the
    /// language.
    fn results(&self, cases: &[Case]) -> Option<Vec<Vec<Vec<Option<f64>>>>> {
        if self.command.is_empty() {
            let mut godot = Godot::start(&[]).expect("Godot starts")?;
            let numbers = godot.run(&(self.program)(cases));
            let numbers =
                numbers.unwrap_or_else(|said| panic!("{}", &said[..said.len().min(4000)]));
            return Some(serde_json::from_value(numbers).expect("lists of numbers"));
        }
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = folder.path().join(self.file);
        std::fs::write(&file, (self.program)(cases)).expect("a temporary file");
        let mut command = Command::new(self.command);
        command.arg(&file);
        if let Some((compiler, arguments)) = self.compiler {
            let made = Command::new(compiler).args(arguments).current_dir(folder.path()).output();
            if let Ok(made) = made {
                let said = String::from_utf8_lossy(&made.stderr);
                assert!(made.status.success(), "{}", &said[..said.len().min(6000)]);
            }
            let program = folder.path().join("cases");
            command = match self.command.starts_with('.') {
                true => Command::new(program),
                false => Command::new(self.command),
            };
            command.arg(folder.path().join("cases"));
        }
        let Ok(output) = command.output() else {
            assert!(!tools_are_required(), "{} is missing: run scripts/setup", self.command);
            say(&format!("SKIPPED: {} is missing", self.command));
            return None;
        };
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}", &said[..said.len().min(4000)]);
        let numbers = serde_json::from_slice::<Json>(&output.stdout);
        Some(numbers.and_then(serde_json::from_value).expect("lists of numbers"))
    }
}

/// The scalars of a value in order.
fn scalars(value: &Value, into: &mut Vec<f64>) {
    match value.parts() {
        Some(parts) => parts.iter().for_each(|part| scalars(part, into)),
        None => into.extend(value.components().unwrap_or_default()),
    }
}

/// Functions of the library: name, text, arguments as text and what the interpreter gives.
struct Case {
    function: String,
    text: String,
    calls: Vec<(Vec<String>, Vec<f64>)>,
    result: Shape,
}

fn cases(runner: &Runner) -> (Vec<Case>, BTreeMap<String, String>) {
    let (mut cases, mut refused) = (Vec::new(), BTreeMap::new());
    let mut known = std::collections::BTreeSet::new();
    let mut random = Random::new(24);
    for definition in Library::built_in().nodes.values() {
        for first in &definition.variants {
            let Ok((valid, literals)) = definition.module.read(&first.function) else { continue };
            for (_, function) in valid.module.functions.iter() {
                let Some(name) = function.name.clone().filter(|name| known.insert(name.clone()))
                else {
                    continue;
                };
                let options =
                    FunctionOptions { literals: Some(literals), ..FunctionOptions::default() };
                let Ok(program) = Program::compile(&valid.module, &name, options) else { continue };
                let text = match translate(literals.source(), &[&name], runner.language) {
                    Ok(text) => text,
                    Err(problem) => {
                        refused.insert(name, problem.message);
                        continue;
                    }
                };
                let mut calls = Vec::new();
                for _ in 0..TRIES {
                    let arguments: Vec<Value> = program
                        .parameters()
                        .iter()
                        .map(|parameter| value(&parameter.shape, &mut random))
                        .collect();
                    let Ok(result) = program.call(&arguments, Precision::F64) else { continue };
                    let mut wanted = Vec::new();
                    scalars(&result, &mut wanted);
                    let written = program.parameters().iter().zip(&arguments);
                    let written =
                        written.map(|(it, value)| runner.value(&it.shape, value)).collect();
                    calls.push((written, wanted));
                }
                let result = program.result().clone();
                cases.push(Case { function: name, text, calls, result });
            }
        }
    }
    (cases, refused)
}

fn javascript(cases: &[Case]) -> String {
    let mut text = "const flat = (x) => typeof x === 'object' ? Object.values(x).flatMap(flat) \
                    : [Number(x)];\nconst results = [];\n"
        .to_owned();
    for case in cases {
        let _ = writeln!(text, "results.push((() => {{\n{}\nreturn [", case.text);
        for (arguments, _) in &case.calls {
            let _ = writeln!(text, "flat({}({})),", case.function, arguments.join(", "));
        }
        text += "];\n})());\n";
    }
    text + "console.log(JSON.stringify(results));\n"
}

fn python(cases: &[Case]) -> String {
    let mut text = "import copy, json, math, struct\n\n\n\
                    def flat(x):\n    \
                        x = list(x.values()) if isinstance(x, dict) else x\n    \
                        if isinstance(x, list):\n        \
                            return [number for part in x for number in flat(part)]\n    \
                        return [float(x) if math.isfinite(x) else None]\n\n\n\
                    results = []\n"
        .to_owned();
    for case in cases {
        let indented = case.text.lines().map(|line| format!("    {line}\n"));
        let _ = writeln!(text, "def run():\n{}    return [", indented.collect::<String>());
        for (arguments, _) in &case.calls {
            let _ = writeln!(text, "        flat({}({})),", case.function, arguments.join(", "));
        }
        text += "    ]\n\n\nresults.append(run())\n";
    }
    text + "print(json.dumps(results))\n"
}

/// A class for each case: what is static in a script is so in its classes.
fn gdscript(cases: &[Case]) -> String {
    let mut text = "extends RefCounted\n\n\n".to_owned();
    for (number, case) in cases.iter().enumerate() {
        let indented = case.text.lines().map(|line| format!("\t{line}\n"));
        let _ = writeln!(
            text,
            "class Case{number}:\n{}\tstatic func results() -> Array:\n\t\treturn [",
            indented.collect::<String>()
        );
        for (arguments, _) in &case.calls {
            let _ = writeln!(text, "\t\t\t{}({}),", case.function, arguments.join(", "));
        }
        text += "\t\t]\n\n\n";
    }
    text += "func flat(value: Variant) -> Array:\n\
             \tif value is Dictionary:\n\t\tvalue = value.values()\n\
             \tif not value is Array:\n\
             \t\treturn [float(value) if is_finite(float(value)) else null]\n\
             \tvar all := []\n\tfor part: Variant in value:\n\t\tall.append_array(flat(part))\n\
             \treturn all\n\n\n\
             func run(_main: Node) -> Array:\n\treturn [\n";
    for number in 0..cases.len() {
        let _ = writeln!(text, "\t\tCase{number}.results().map(flat),");
    }
    text + "\t]\n"
}

/// Expressions of the scalars of a value of Rust, each as an `f64`.
fn rust_scalars(shape: &Shape, value: &str, into: &mut Vec<String>) {
    match shape {
        Shape::Scalar(ScalarKind::Bool) => into.push(format!("f64::from(u8::from({value}))")),
        Shape::Scalar(ScalarKind::Float) => into.push(value.to_owned()),
        Shape::Scalar(_) => into.push(format!("f64::from({value})")),
        Shape::Vector { kind, size } => {
            let element = Shape::Scalar(*kind);
            (0..*size).for_each(|at| rust_scalars(&element, &format!("{value}[{at}]"), into));
        }
        Shape::Matrix { columns, rows } => {
            let column = Shape::Vector { kind: ScalarKind::Float, size: *rows };
            (0..*columns).for_each(|at| rust_scalars(&column, &format!("{value}[{at}]"), into));
        }
        Shape::Array { element, count } => {
            (0..*count).for_each(|at| rust_scalars(element, &format!("{value}[{at}]"), into));
        }
        Shape::Struct { members, .. } => {
            for (name, shape) in members {
                rust_scalars(shape, &format!("{value}.{name}"), into);
            }
        }
    }
}

fn rust(cases: &[Case]) -> String {
    let mut text = String::new();
    for (number, case) in cases.iter().enumerate() {
        let _ = writeln!(text, "mod case_{number} {{\n{}", case.text);
        let _ = writeln!(text, "pub fn run() -> Vec<Vec<f64>> {{\nlet mut all = Vec::new();");
        for (arguments, _) in &case.calls {
            let mut scalars = Vec::new();
            rust_scalars(&case.result, "value", &mut scalars);
            let _ = writeln!(
                text,
                "let value = {}({}); all.push(vec![{}]);",
                case.function,
                arguments.join(", "),
                scalars.join(", ")
            );
        }
        text += "all\n}\n}\n";
    }
    text += "fn text(x: &f64) -> String {\n    \
             if x.is_finite() { format!(\"{x:?}\") } else { \"null\".to_owned() }\n}\n\
             fn list(items: Vec<String>) -> String { format!(\"[{}]\", items.join(\",\")) }\n\
             fn main() {\n    let all: Vec<Vec<Vec<f64>>> = vec![";
    for number in 0..cases.len() {
        let _ = write!(text, "case_{number}::run(), ");
    }
    text + "];\n    let row = |row: &Vec<f64>| list(row.iter().map(text).collect());\n    \
            let case = |case: &Vec<Vec<f64>>| list(case.iter().map(row).collect());\n    \
            println!(\"{}\", list(all.iter().map(case).collect()));\n}\n"
}

/// Expressions of the scalars of a value of C#, each as a `double`.
fn csharp_scalars(shape: &Shape, value: &str, into: &mut Vec<String>) {
    match shape {
        Shape::Scalar(ScalarKind::Bool) => into.push(format!("({value} ? 1.0 : 0.0)")),
        Shape::Scalar(_) => into.push(value.to_owned()),
        Shape::Vector { kind, size } => {
            for axis in &["x", "y", "z", "w"][..*size] {
                csharp_scalars(&Shape::Scalar(*kind), &format!("{value}.{axis}"), into);
            }
        }
        Shape::Matrix { columns, rows } => {
            let column = Shape::Vector { kind: ScalarKind::Float, size: *rows };
            (0..*columns).for_each(|at| csharp_scalars(&column, &format!("{value}.c{at}"), into));
        }
        Shape::Array { element, count } => {
            (0..*count).for_each(|at| csharp_scalars(element, &format!("{value}[{at}]"), into));
        }
        Shape::Struct { members, .. } => {
            for (name, shape) in members {
                csharp_scalars(shape, &format!("{value}.{}", CSHARP.member_name(name)), into);
            }
        }
    }
}

fn csharp(cases: &[Case]) -> String {
    let mut text = "using System;\nusing System.Collections.Generic;\n\
                    using System.Globalization;\nusing System.Linq;\n"
        .to_owned();
    let mut runs = String::new();
    for (number, case) in cases.iter().enumerate() {
        let _ = writeln!(text, "static class Case_{number}\n{{\n{}", case.text);
        text += "public static List<double[]> RunCase()\n{\nvar all = new List<double[]>();\n";
        // A function that is called as a struct gives way.
        let mut function = CSHARP.function_name(&case.function);
        if case.text.contains(&format!("public struct {function}\n")) {
            function.push('_');
        }
        for (call, (arguments, _)) in case.calls.iter().enumerate() {
            let mut scalars = Vec::new();
            csharp_scalars(&case.result, &format!("value{call}"), &mut scalars);
            let _ = writeln!(
                text,
                "var value{call} = {}({}); all.Add(new double[] {{ {} }});",
                function,
                arguments.join(", "),
                scalars.join(", ")
            );
        }
        text += "return all;\n}\n}\n";
        let _ = write!(runs, "Case_{number}.RunCase(), ");
    }
    text + "static class Cases\n{\nstatic string Text(double x) => double.IsNaN(x) || \
            double.IsInfinity(x) ? \"null\" : x.ToString(\"R\", CultureInfo.InvariantCulture);\n\
            static string Row(IEnumerable<string> items) => \"[\" + string.Join(\",\", items) + \
            \"]\";\nstatic void Main()\n{\nvar all = new List<double[]>[] { "
        + &runs
        + "};\nConsole.WriteLine(Row(all.Select(one => Row(one.Select(row => \
           Row(row.Select(Text)))))));\n}\n}\n"
}

/// True if two numbers are the same but for rounding; what is no number may be any.
fn agree(wanted: f64, found: Option<f64>, scale: f64) -> bool {
    match found {
        Some(found) => (wanted - found).abs() <= TOLERANCE * scale.max(1.0),
        None => !wanted.is_finite(),
    }
}

#[test]
fn javascript_computes_what_the_interpreter_does() {
    compare(&RUNNERS[0]);
}

#[test]
fn python_computes_what_the_interpreter_does() {
    compare(&RUNNERS[1]);
}

#[test]
fn rust_computes_what_the_interpreter_does() {
    compare(&RUNNERS[2]);
}

#[test]
fn gdscript_computes_what_the_interpreter_does() {
    compare(&RUNNERS[3]);
}

#[test]
fn csharp_computes_what_the_interpreter_does() {
    compare(&RUNNERS[4]);
}

/// Runs the functions of the library in a language, and in the interpreter.
fn compare(runner: &Runner) {
    let (cases, refused) = cases(runner);
    assert!(cases.len() > 300, "{} functions are tried", cases.len());
    let allowed = ["pointer", "texture", "Image", "Derivative", "a parameter's type"];
    let unexpected: Vec<_> = refused
        .iter()
        .filter(|(_, reason)| !allowed.iter().any(|word| reason.contains(word)))
        .collect();
    assert!(unexpected.is_empty(), "{unexpected:#?}");
    let Some(results) = runner.results(&cases) else { return };
    let mut wrong = Vec::new();
    for (case, results) in cases.iter().zip(&results) {
        for ((arguments, wanted), found) in case.calls.iter().zip(results) {
            let scale =
                wanted.iter().filter(|x| x.is_finite()).fold(0.0_f64, |a, x| a.max(x.abs()));
            let is_same = wanted.len() == found.len()
                && wanted.iter().zip(found).all(|(wanted, found)| agree(*wanted, *found, scale));
            if !is_same {
                wrong.push(format!(
                    "{}({}): {found:?} and not {wanted:?}\n{}",
                    case.function,
                    arguments.join(", "),
                    case.text
                ));
                break;
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} functions differ\n{}",
        wrong.len(),
        wrong[..wrong.len().min(6)].join("\n")
    );
}
