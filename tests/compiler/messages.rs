//! Messages: what the window tells of a problem is looked up, so that its user reads it in the
//! window's language.
//!
//! Read are the arguments of `Diagnostic::error`, `warning` and `note`, of `hint`, of `Err`,
//! `ok_or` and `ok_or_else` and of `#[error(...)]`, and what is bound to `message`, `hint`, `help`
//! or `reason`. A sentence there, a text of several words, stands in `tr!`, `trn!` or `text!`. A
//! message that comes to a diagnostic in another way is not seen.

use std::collections::BTreeSet;
use std::fs;

use proc_macro2::{TokenStream, TokenTree};
use syn::LitStr;

use crate::support::{files, root};

/// Rooms and files whose sentences are English in every language, from `src`.
const ENGLISH: &[&str] = &[
    // The command line tells these, which is English for the sake of scripts: its own rooms, a
    // window that could not open, words of its options, and commands without a panel.
    "cli/",
    "editor/lib.rs",
    "laboratory/accuracy/measure.rs",
    "laboratory/fit/report.rs",
    "laboratory/gallery/",
    "sweeps/",
    // They go into files of packages.
    "scene/export/package/blender/osl/",
    "scene/export/package/godot/script.rs",
    "scene/export/package/materialx/standard/",
    "scene/export/package/unity/component.rs",
];

/// Macros whose texts are looked up, or that end the program.
const LOOKUPS: &[&str] = &["tr", "trn", "text", "assert", "assert_eq", "panic", "unreachable"];

fn trees_of(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}

fn is_word(tree: &TokenTree, words: &[&str]) -> bool {
    matches!(tree, TokenTree::Ident(word) if words.contains(&word.to_string().as_str()))
}

fn is_mark(tree: &TokenTree, mark: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// True for a text of several words, beside the values in it.
fn is_sentence(text: &str) -> bool {
    let mut depth = 0_usize;
    let mut plain = String::new();
    for letter in text.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ if depth == 0 => plain.push(letter),
            _ => {}
        }
    }
    let is_word = |word: &str| word.chars().filter(|letter| letter.is_alphabetic()).count() > 1;
    plain.trim().contains(' ') && plain.split(' ').any(is_word)
}

/// Adds the sentences of an expression that are not looked up, however deep they stand.
fn sentences(trees: &[TokenTree], found: &mut BTreeSet<String>) {
    for (at, tree) in trees.iter().enumerate() {
        let is_told_elsewhere = match &trees[..at] {
            [.., name, mark] if is_mark(mark, '!') => is_word(name, LOOKUPS),
            [.., name] => is_word(name, &["expect"]),
            [] => false,
        };
        match tree {
            TokenTree::Literal(literal) => {
                let text = syn::parse_str::<LitStr>(&literal.to_string()).map(|it| it.value());
                found.extend(text.ok().filter(|text| is_sentence(text)));
            }
            TokenTree::Group(group) if !is_told_elsewhere => {
                sentences(&trees_of(group.stream()), found);
            }
            _ => {}
        }
    }
}

/// True if a message stands in the brackets after these tokens.
fn begins_message(before: &[TokenTree]) -> bool {
    match before {
        [.., ty, first, second, name] if is_mark(first, ':') && is_mark(second, ':') => {
            is_word(ty, &["Diagnostic", "Self"]) && is_word(name, &["error", "warning", "note"])
        }
        [.., dot, name] if is_mark(dot, '.') => is_word(name, &["hint", "ok_or", "ok_or_else"]),
        [attribute] if is_word(attribute, &["error"]) => true,
        [.., name] => is_word(name, &["Err"]),
        [] => false,
    }
}

/// Adds the sentences of a source's messages that are not looked up.
fn messages(trees: &[TokenTree], found: &mut BTreeSet<String>) {
    for (at, tree) in trees.iter().enumerate() {
        let (before, after) = trees.split_at(at);
        if let [binding, name, equals, value @ ..] = after
            && is_word(binding, &["let"])
            && is_word(name, &["message", "hint", "help", "reason"])
            && is_mark(equals, '=')
        {
            let end = value.iter().position(|tree| is_mark(tree, ';')).unwrap_or(value.len());
            sentences(&value[..end], found);
        }
        let TokenTree::Group(group) = tree else { continue };
        let is_tests = matches!(before, [.., module, name]
            if is_word(module, &["mod"]) && is_word(name, &["tests"]));
        if is_tests {
            continue;
        }
        let inner = trees_of(group.stream());
        if begins_message(before) {
            sentences(&inner, found);
        }
        messages(&inner, found);
    }
}

/// Sentences of the messages in a source that are not looked up.
fn messages_of(source: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    messages(&trees_of(source.parse().expect("a source has tokens")), &mut found);
    found
}

#[test]
fn messages_of_the_window_are_looked_up() {
    let mut missed = Vec::new();
    let mut english = BTreeSet::new();
    for path in files::below(&root().join("src")) {
        let name = path.strip_prefix(root().join("src")).expect("it was found there");
        let name = name.to_string_lossy().replace('\\', "/");
        let is_of_tests = name.ends_with("tests.rs") || name.contains("/tests/");
        let is_program = name.contains('/') && !name.ends_with("build.rs");
        if !name.ends_with(".rs") || is_of_tests || !is_program || name.starts_with("locale/") {
            continue;
        }
        let found = messages_of(&fs::read_to_string(&path).expect("a source reads"));
        match ENGLISH.iter().find(|room| name.starts_with(*room)) {
            Some(room) if !found.is_empty() => {
                english.insert(*room);
            }
            Some(_) => {}
            None => missed.extend(found.into_iter().map(|text| format!("{name}: {text:?}"))),
        }
    }
    assert!(missed.is_empty(), "English in every language, as tr! is missing: {missed:#?}");
    let needless: Vec<_> = ENGLISH.iter().filter(|room| !english.contains(*room)).collect();
    assert!(needless.is_empty(), "rooms of ENGLISH without English: {needless:?}");
}

#[test]
fn messages_are_found_however_they_are_made() {
    let source = r#"
        #[error("an attribute's {text}")]
        #[error("{}", tr!("an attribute's text"))]
        fn f() -> Result<(), Diagnostic> {
            let message = if is_long() { format!("{n} long words") } else { "short".to_owned() };
            let hint = tr!("looked up by {name}", name = g("no message"));
            let other = "no message either";
            list.first().ok_or_else(|| Diagnostic::error("a-code", "an error's text"))?;
            problem.hint(format!("a hint of `{name}`")).expect("a list has a first");
            Err(trn!(n, "one way", "{n} ways")).or(Err(refused("a refusal's text")))
        }
        mod tests { fn g() { Diagnostic::error("a-code", "of a test") } }
    "#;
    let found = messages_of(source);
    let expected = [
        "a hint of `{name}`",
        "a refusal's text",
        "an attribute's {text}",
        "an error's text",
        "{n} long words",
    ];
    assert_eq!(found.iter().map(String::as_str).collect::<Vec<_>>(), expected);
}
