use std::sync::Arc;

use proptest::prelude::*;

use super::{JsonKind, MAX_DEPTH, Tree, ValueIndex, parse};
use crate::diag::Diagnostic;
use crate::document::problems::{LineIndex, Problems};

fn parsed(text: &str) -> (Tree, Vec<Diagnostic>) {
    let lines = LineIndex::new(text);
    let mut problems = Problems::new();
    let tree = parse(&Arc::from(text), &lines, &mut problems);
    (tree, problems.finish("", text, &lines))
}

/// Messages of the problems, with line and column.
fn told(text: &str) -> Vec<String> {
    let at = |d: &Diagnostic| {
        d.place.at.map_or_else(String::new, |at| format!("{}:{} ", at.line, at.column))
    };
    parsed(text).1.iter().map(|d| at(d) + &d.message).collect()
}

proptest! {
    /// The comparison is with serde_json, another reader of the same language.
    #[test]
    fn what_is_json_is_what_serde_json_takes(
        text in concat!(
            r#"(\{|\}|\[|\]|,|:|"a"|"\\u00e9"|"\\ud83d\\ude00"|"\\ud83d"|"\\x"|"\t"|"é""#,
            r#"|true|false|null|nul|0|-|-0|01|1\.|\.5|1e5|1E-2|2\.5e+3|1e400"#,
            r#"|12345678901234567890|-9007199254740993| |\n){0,12}"#
        )
    ) {
        let serde = serde_json::from_str::<serde_json::Value>(&text);
        let (tree, problems) = parsed(&text);
        prop_assert_eq!(serde.is_ok(), problems.is_empty(), "{}: {:?} {:?}", text, serde, problems);
        if let (Ok(value), Some(root)) = (serde, tree.root()) {
            prop_assert_eq!(tree.to_json(root), value);
        }
    }

    /// Items make a tree, whatever the text: children lie in their parents, one after the other.
    #[test]
    fn items_make_a_tree(text in r#"(\{|\}|\[|\]|,|:|"a"|'b|"|1|x|/\*|//|\n|é){0,40}"#) {
        let (tree, _) = parsed(&text);
        let mut open: Vec<ValueIndex> = tree.root().into_iter().collect();
        let mut count = 0;
        while let Some(at) = open.pop() {
            count += 1;
            let (start, end) = (tree.start(at), tree.item(at).end as usize);
            prop_assert!(start <= end && end <= text.len());
            let mut last = start;
            for child in tree.children(at) {
                prop_assert!(
                    tree.key_start(child) >= last && tree.item(child).end as usize <= end, "{text}"
                );
                last = tree.item(child).end as usize;
                open.push(child);
            }
        }
        prop_assert_eq!(count, tree.items.len());
    }
}

#[test]
fn mistakes_are_told_and_the_rest_is_read() {
    assert_eq!(told("{\"a\": 1,}"), ["1:8 there is a comma after the last item"]);
    assert_eq!(told("[1 2]"), ["1:3 a comma is missing here"]);
    assert_eq!(told("[1,, 2]"), ["1:4 there is a comma too many"]);
    assert_eq!(told("[.5]"), ["1:2 `.5` is no number of JSON"]);
    assert_eq!(told("{a: 1}"), ["1:2 the names of fields stand in double quotes"]);
    assert_eq!(told("{\"a\" = 1}"), ["1:6 found `=` after the name of a field"]);
    assert_eq!(told("{\"a\"}"), ["1:5 \"a\" has no `:` and no value"]);
    assert_eq!(told("{\"a\": }"), ["1:7 \"a\" has no value"]);
    assert_eq!(told("{\"a\": True}"), ["1:7 `True` is no value of JSON"]);
    assert_eq!(told("{\"a\": key}"), ["1:7 `key` is no value of JSON"]);
    assert_eq!(told("[1] // done"), ["1:5 JSON has no comments"]);
    assert_eq!(told("/* é */ [1]"), ["1:1 JSON has no comments"]);
    assert_eq!(told("[\"a\n, 1]"), ["1:2 the string is not closed on its line"]);
    assert_eq!(told("[\"C:\\models\"]"), ["1:5 `\\m` is no escape of JSON"]);
    assert_eq!(told("{\"a\": [1, 2}"), ["1:12 the list opened at line 1, column 7 is not closed"]);
    assert_eq!(
        told("{\"a\": [1,\n \"b\": 2}"),
        ["2:2 the list opened at line 1, column 7 is not closed"]
    );
    assert_eq!(told("[1]]"), ["1:4 there is more text after the end of the document"]);
    assert_eq!(
        told("[-Infinity, nan]"),
        ["1:2 `-Infinity` is no finite number", "1:13 `nan` is no finite number"]
    );

    let (tree, _) = parsed("{'a': [1, 2 3,], b = {\"c\": .5, \"d\": tru}, \"e\": [4, \"f\": 5}");
    let json = tree.to_json(tree.root().unwrap());
    let expected =
        serde_json::json!({ "a": [1, 2, 3], "b": { "c": null, "d": null }, "e": [4], "f": 5 });
    assert_eq!(json, expected);
}

#[test]
fn depth_and_mistakes_are_bounded() {
    let deep = |depth: usize| "[".repeat(depth) + &"]".repeat(depth);
    assert_eq!(parsed(&deep(MAX_DEPTH)).1, []);
    let (_, problems) = parsed(&deep(MAX_DEPTH + 1));
    assert_eq!(problems[0].code, "too-deep");
    // Texts as long as a stranger may send must not end the program.
    assert_eq!(parsed(&"[".repeat(5_000_000)).1[0].code, "too-deep");
    assert_eq!(parsed(&"{\"a\":".repeat(1_000_000)).1[0].code, "too-deep");

    let (_, problems) = parsed(&format!("[{}]", "x ".repeat(100_000)));
    assert_eq!(problems.len(), 101);
    assert_eq!(problems.last().unwrap().code, "too-many-mistakes");
    assert_eq!(parsed(&"[1e999,".repeat(60)).1.len(), 61);
}

#[test]
fn strings_are_unquoted() {
    let (tree, problems) = parsed(r#"["\u0041\n\"\\\/\ud83d\ude00", "plain é"]"#);
    assert!(problems.is_empty());
    let root = tree.root().unwrap();
    let strings: Vec<_> =
        tree.children(root).map(|at| tree.string(at).unwrap().into_owned()).collect();
    assert_eq!(strings, ["A\n\"\\/😀", "plain é"]);
    assert_eq!(tree.kind(root), JsonKind::List);
}
