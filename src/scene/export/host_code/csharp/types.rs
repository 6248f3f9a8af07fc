//! Structs of vectors and matrices, which a text declares as far as it uses them.

use std::fmt::Write as _;

use super::super::dialect::Kind;

/// Fields of vectors.
pub(super) const AXES: [&str; 4] = ["x", "y", "z", "w"];

/// Name of a scalar's type.
pub(super) fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Float => "double",
        Kind::Signed => "int",
        Kind::Unsigned => "uint",
        Kind::Bool => "bool",
    }
}

/// Beginning of the names of vectors' types.
pub(super) fn vector_word(kind: Kind) -> &'static str {
    match kind {
        Kind::Float => "Double",
        Kind::Signed => "Int",
        Kind::Unsigned => "UInt",
        Kind::Bool => "Bool",
    }
}

/// Declarations of the types that a text uses.
pub(super) fn declarations(text: &str) -> String {
    let mut matrices = String::new();
    for (rows, columns) in (2..=4).flat_map(|rows| (2..=4).map(move |columns| (rows, columns))) {
        if has_word(text, &format!("Double{rows}x{columns}")) {
            matrices += &matrix(rows, columns);
        }
    }
    let mut found = String::new();
    for kind in [Kind::Float, Kind::Signed, Kind::Unsigned, Kind::Bool] {
        for count in 2..=4 {
            let name = format!("{}{count}", vector_word(kind));
            if has_word(text, &name) || has_word(&matrices, &name) {
                found += &vector(&name, count, kind, has_index(text));
            }
        }
    }
    found + &matrices
}

/// True if a text has a word as a whole.
fn has_word(text: &str, word: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.match_indices(word).any(|(at, _)| {
        !text[..at].ends_with(is_part) && !text[at + word.len()..].starts_with(is_part)
    })
}

/// True if something may be taken by an index that is computed.
fn has_index(text: &str) -> bool {
    let is_index = |rest: &str| rest.starts_with(|c: char| c.is_ascii_alphabetic());
    text.split('[').skip(1).any(is_index)
}

fn vector(name: &str, count: usize, kind: Kind, is_indexed: bool) -> String {
    let (ty, axes) = (word(kind), &AXES[..count]);
    let each = |write: &dyn Fn(&str) -> String, between: &str| {
        axes.iter().map(|axis| write(axis)).collect::<Vec<_>>().join(between)
    };
    let parameters = each(&|axis| format!("{ty} {axis}"), ", ");
    let sets = each(&|axis| format!("this.{axis} = {axis};"), " ");
    let mut text = format!(
        "/// <summary>{} components.</summary>\npublic struct {name}\n{{\n    \
         public {ty} {};\n\n    \
         public {name}({ty} all) {{ {} = all; }}\n\n    \
         public {name}({parameters}) {{ {sets} }}\n",
        ["Two", "Three", "Four"][count - 2],
        axes.join(", "),
        axes.join(" = "),
    );
    if is_indexed {
        let mut get = axes[count - 1].to_owned();
        let mut set = format!("{} = value;", axes[count - 1]);
        for (index, axis) in axes[..count - 1].iter().enumerate().rev() {
            get = format!("index == {index} ? {axis} : {get}");
            set = format!("if (index == {index}) {axis} = value; else {set}");
        }
        let _ = write!(
            text,
            "\n    public {ty} this[long index]\n    {{\n        \
             get => {get};\n        set {{ {set} }}\n    }}\n"
        );
    }
    if kind != Kind::Bool {
        let operators: &[&str] =
            if kind == Kind::Float { &["+", "-", "*", "/"] } else { &["+", "-", "*"] };
        for operator in operators {
            let items = each(&|axis| format!("a.{axis} {operator} b.{axis}"), ", ");
            let _ = write!(
                text,
                "\n    public static {name} operator {operator}({name} a, {name} b) =>\n        \
                 new {name}({items});\n"
            );
        }
        let scaled = each(&|axis| format!("a.{axis} * b"), ", ");
        let _ = write!(
            text,
            "\n    public static {name} operator *({name} a, {ty} b) => \
             new {name}({scaled});\n\n    \
             public static {name} operator *({ty} a, {name} b) => b * a;\n"
        );
        if kind == Kind::Float {
            let divided = each(&|axis| format!("a.{axis} / b"), ", ");
            let _ = write!(
                text,
                "\n    public static {name} operator /({name} a, {ty} b) => \
                 new {name}({divided});\n"
            );
        }
        if kind != Kind::Unsigned {
            let negated = each(&|axis| format!("-a.{axis}"), ", ");
            let _ = write!(
                text,
                "\n    public static {name} operator -({name} a) => new {name}({negated});\n"
            );
        }
    }
    text + "}\n\n"
}

fn matrix(rows: usize, columns: usize) -> String {
    let name = format!("Double{rows}x{columns}");
    let list = |write: &dyn Fn(usize) -> String, between: &str| {
        (0..columns).map(write).collect::<Vec<_>>().join(between)
    };
    format!(
        "/// <summary>A matrix of {columns} columns.</summary>\npublic struct {name}\n{{\n    \
         public Double{rows} {};\n\n    \
         public {name}({})\n    {{\n        {}\n    }}\n}}\n\n",
        list(&|column| format!("c{column}"), ", "),
        list(&|column| format!("Double{rows} c{column}"), ", "),
        list(&|column| format!("this.c{column} = c{column};"), "\n        "),
    )
}
