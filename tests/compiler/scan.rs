//! The scanner for paths in Rust source, `tests/support/scan.rs`.

use crate::support::scan::{Reference, references};

/// The modules that `text` reaches, each with its line.
fn modules(text: &str) -> Vec<(String, usize)> {
    references(text, 1)
        .into_iter()
        .filter_map(|found| match found.reference {
            Reference::Module(name) => Some((name, found.line)),
            _ => None,
        })
        .collect()
}

fn names(text: &str) -> Vec<String> {
    modules(text).into_iter().map(|(name, _)| name).collect()
}

#[test]
fn use_items_and_nested_groups() {
    assert_eq!(names("use crate::a::B; pub(crate) use crate::c;"), ["a", "c"]);
    assert_eq!(names("use crate::{a, b::{c, d::{e}}, f::*, g as h};"), ["a", "b", "f", "g"]);
    assert_eq!(names("use {crate::a::{b}, std::fmt, crate::c};"), ["a", "c"]);
    assert_eq!(
        modules("use crate::{\n  a,\n  b::{\n c,\n },\n d,\n};"),
        [("a".into(), 2), ("b".into(), 3), ("d".into(), 6)]
    );
}

#[test]
fn inline_paths_in_code_and_macros() {
    assert_eq!(
        names("fn f(x: &crate::a::T) -> crate::b::U { crate::c::g::<crate::d::V>(x) }"),
        ["a", "b", "c", "d"]
    );
    assert_eq!(
        names("vec![crate::a::X]; macro_rules! m { () => { $crate::b::y!() } }"),
        ["a", "b"]
    );
    assert_eq!(names("impl From<crate::a::A> for B {} pub(in crate::b) fn f() {}"), ["a", "b"]);
}

#[test]
fn comments_and_literals_are_no_code() {
    let silent = [
        "// crate::a::b",
        "/// [`crate::a`]\n//! crate::b",
        "/* crate::a /* crate::b */ crate::c */",
        r#" "crate::a \" crate::b" "#,
        r##" r#"crate::a " crate::b"# "##,
        r#" br"crate::a\" "#,
        r#" b"crate::a" "#,
        r#" c"crate::a" "#,
    ];
    for text in silent {
        assert_eq!(names(text), [""; 0], "{text}");
    }
}

#[test]
fn what_looks_like_a_literal_does_not_swallow_code() {
    assert_eq!(names(r"let c = '\''; crate::a::b"), ["a"]);
    assert_eq!(names(r"let c = '\\'; crate::a::b"), ["a"]);
    assert_eq!(names("let c = '\"'; crate::a::b"), ["a"]);
    assert_eq!(names("let c = b'\"'; crate::a::b"), ["a"]);
    assert_eq!(names(r"let c = '\u{1F600}'; crate::a::b"), ["a"]);
    assert_eq!(names("fn f<'a>(x: &'a str) -> crate::a::B<'a> {}"), ["a"]);
    assert_eq!(names(r#"let s = "\\"; crate::a::b"#), ["a"]);
    assert_eq!(names(r#"let s = r"\"; crate::a::b"#), ["a"]);
    assert_eq!(names("let r#type = r#crate_name; crate::a::b"), ["a"]);
    assert_eq!(names("let x = 1 / 2; // no\ncrate::a::b"), ["a"]);
    assert_eq!(names("let s = \"λ\nμ\"; 'λ'; crate::a::b"), ["a"]);
}

#[test]
fn supers_reach_the_root_only_from_the_right_depth() {
    let reached = |text, depth| {
        references(text, depth).iter().any(|f| f.reference == Reference::Module("x".into()))
    };
    assert!(reached("use super::x;", 1));
    assert!(!reached("use super::x;", 2));
    assert!(reached("use super::super::x;", 2));
    assert!(reached("self::super::x", 1));
    assert!(!reached("mod tests { use super::x; }", 1));
    assert!(reached("mod a { fn f() {} } use super::x;", 1));
}

#[test]
fn other_crates_are_seen_where_a_path_starts() {
    let crates =
        |text| -> Vec<_> { references(text, 1).into_iter().map(|found| found.path).collect() };
    assert_eq!(
        crates("use std::fmt; ::wgpu::Device; a.b.wgpu.c; x::wgpu::y"),
        ["std", "wgpu", "x"]
    );
}
