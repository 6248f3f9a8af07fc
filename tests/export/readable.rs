//! Exported text reads like the WGSL that it was made of: the same names, the same comments.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::support::{files, root};

/// Endings of the texts that naga writes, of a look's fragment stage.
const ENDINGS: [&str; 6] = ["es300.frag", "330.frag", "450.frag", "hlsl", "slang", "metal"];

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Words of a text, without its line comments.
fn words(text: &str) -> BTreeSet<&str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_')).collect()
}

/// Folders of the golden outputs, with the name of the look in each.
fn golden() -> Vec<(std::path::PathBuf, String)> {
    let folder = root().join("tests/golden");
    let entries = fs::read_dir(&folder).expect("golden outputs");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let folders = paths.filter(|path| path.is_dir());
    let named = folders.map(|path| {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        (path, name)
    });
    let mut found: Vec<_> = named.collect();
    found.sort();
    assert!(!found.is_empty());
    found
}

/// No value is called by a number alone, as naga calls results of calls and loads.
#[test]
fn no_value_is_a_number() {
    for path in files::below(&root().join("tests/golden")) {
        let name = path.display().to_string();
        if !ENDINGS.iter().chain(&["vert"]).any(|ending| name.ends_with(ending)) {
            continue;
        }
        let text = text(&path);
        let is_numbered = |word: &&&str| {
            word.strip_prefix("_e").is_some_and(|rest| {
                !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit())
            })
        };
        let found = words(&text).iter().find(is_numbered).map(|word| (*word).to_owned());
        assert_eq!(found, None, "{name}");
    }
}

/// Values that the WGSL of a look names are declared by these names in every language. A language
/// may have a word for itself, which then ends with `_`; and a value of two names has the latter.
#[test]
fn values_keep_their_names() {
    for (folder, name) in golden() {
        let wgsl = text(&folder.join(format!("{name}.wgsl")));
        let shade = wgsl.split("\nfn shade(").nth(1).and_then(|rest| rest.split("\n}\n").next());
        let Some(shade) = shade else { continue };
        let lets = shade.lines().filter_map(|line| line.trim().strip_prefix("let "));
        let mut named: Vec<&str> = lets.filter_map(|line| line.split([' ', ':']).next()).collect();
        named.retain(|value| !shade.contains(&format!(" = {value};")));
        assert!(!named.is_empty() || !shade.contains("let "), "{name}");
        for ending in ENDINGS {
            let text = text(&folder.join(format!("{name}.{ending}")));
            let words = words(&text);
            for value in &named {
                let is_there =
                    words.contains(value) || words.contains(format!("{value}_").as_str());
                assert!(is_there, "{name}.{ending} does not name {value}");
            }
        }
    }
}

/// The comment before each function of a look's WGSL stands before it in every language that has
/// the function.
#[test]
fn functions_keep_their_comments() {
    let mut compared = 0;
    for (folder, name) in golden() {
        let wgsl = text(&folder.join(format!("{name}.wgsl")));
        for ending in ENDINGS {
            let text = text(&folder.join(format!("{name}.{ending}")));
            let words = words(&text);
            let mut comment: Vec<&str> = Vec::new();
            for line in wgsl.lines() {
                if line.starts_with("///") {
                    comment.push(line);
                    continue;
                }
                let comment = std::mem::take(&mut comment);
                let function = line.strip_prefix("fn ").and_then(|rest| rest.split('(').next());
                let Some(function) = function.filter(|function| words.contains(function)) else {
                    continue;
                };
                let kept = text.contains(&(comment.join("\n") + "\n"));
                assert!(comment.is_empty() || kept, "{name}.{ending}: {function}");
                compared += usize::from(!comment.is_empty());
            }
        }
    }
    assert!(compared > 1000, "only {compared} comments were compared");
}

/// Each layer of a look stands apart, under the artist's name for it, in every language.
#[test]
fn layers_are_paragraphs() {
    let folder = root().join("tests/golden/figure1-layers");
    for ending in ENDINGS.iter().chain(&["wgsl"]) {
        let text = text(&folder.join(format!("figure1-layers.{ending}")));
        let shade = &text[text.find("// Fill (Light layer)").expect("the first layer")..];
        let mut at = 0;
        for (title, value) in [("Diffuse", "diffuse"), ("Specular", "specular")] {
            let heading = format!("\n\n    // {title} (Light layer)\n");
            let found = shade.find(&heading).unwrap_or_else(|| panic!("{ending}: {title}"));
            let before = shade.find(&format!(" {value}_color = ")).expect("a color");
            let after = shade.find(&format!(" {value}_blend = ")).expect("a blend");
            assert!(at < found && found < before && before < after, "{ending}: {title}");
            at = after;
        }
    }
}

/// No value stands in brackets as a whole.
#[test]
fn brackets_are_few() {
    let is_whole = |line: &str| {
        let Some((_, value)) = line.split_once(" = (") else { return false };
        let mut depth = 1_i32;
        let end = value.bytes().position(|byte| {
            depth += i32::from(byte == b'(') - i32::from(byte == b')');
            depth == 0
        });
        end.is_some_and(|end| &value[end..] == ");")
    };
    assert!(is_whole("float x = ((a) + b);") && !is_whole("float x = (a) + (b);"));
    for (folder, name) in golden() {
        for ending in ENDINGS {
            let text = text(&folder.join(format!("{name}.{ending}")));
            let found = text.lines().find(|line| is_whole(line));
            assert_eq!(found, None, "{name}.{ending}");
        }
    }
}
