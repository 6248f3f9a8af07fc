//! Exported looks: golden outputs of every example look in every language, and what the description says held against
//! programs that are not the exporter.

mod support;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs};

use chiaro::document::Look;
use chiaro::export::{File, LANGUAGES, export};
use chiaro::library::Library;
use support::files;

/// Where the golden outputs lie.
fn golden_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

fn read_look(text: &str, name: &str) -> Look {
    let loaded = Look::read(text, name);
    loaded.value.unwrap_or_else(|| panic!("{:?}", loaded.diagnostics))
}

/// Every file of a look in every language.
fn export_all(look: &Look, stem: &str) -> Vec<File> {
    let exported = export(look, Library::built_in(), stem, &LANGUAGES);
    let exported = exported.unwrap_or_else(|problems| {
        panic!("{stem}: {}", problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
    });
    exported.files
}

/// The golden files as they should be: by path below the folder.
fn expected() -> BTreeMap<PathBuf, Vec<u8>> {
    let looks = files::below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks"));
    let mut expected = BTreeMap::new();
    for path in looks.iter().filter(|path| path.extension().is_some_and(|extension| extension == "json")) {
        let stem = path.file_stem().expect("a file").to_string_lossy().into_owned();
        let look = read_look(&fs::read_to_string(path).expect("an example"), &path.display().to_string());
        for file in export_all(&look, &stem) {
            let name = Path::new(&stem).join(&file.name);
            assert!(expected.insert(name.clone(), file.bytes).is_none(), "two files are {}", name.display());
        }
    }
    expected
}

/// The first line that differs, or the sizes of what is no text.
fn difference(golden: &[u8], now: &[u8]) -> String {
    let (Ok(golden_text), Ok(now_text)) = (std::str::from_utf8(golden), std::str::from_utf8(now)) else {
        return format!("{} bytes, now {}", golden.len(), now.len());
    };
    let longest = golden_text.lines().count().max(now_text.lines().count());
    let line = |text: &str, index: usize| text.lines().nth(index).unwrap_or("(the end)").to_owned();
    let first = (0..longest).find(|&index| line(golden_text, index) != line(now_text, index));
    first.map_or_else(
        || "line ends differ".to_owned(),
        |index| {
            format!("line {}\n  golden: {}\n  now:    {}", index + 1, line(golden_text, index), line(now_text, index))
        },
    )
}

/// `CHIARO_BLESS=1 cargo test --test export` writes them anew.
#[test]
fn golden_outputs_are_what_is_exported() {
    let folder = golden_folder();
    let expected = expected();
    let found: Vec<PathBuf> = files::below(&folder);
    let is_blessing = env::var("CHIARO_BLESS").is_ok_and(|value| value == "1");
    let mut complaints = Vec::new();
    for path in &found {
        let name = path.strip_prefix(&folder).expect("below the folder");
        if !expected.contains_key(name) {
            if is_blessing {
                fs::remove_file(path).expect("a stale golden file");
            } else {
                complaints.push(format!("{}: no example look is exported to this file any more", path.display()));
            }
        }
    }
    for (name, now) in &expected {
        let path = folder.join(name);
        let golden = fs::read(&path);
        if golden.as_ref().is_ok_and(|golden| golden == now) {
            continue;
        }
        if is_blessing {
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder for golden files");
            fs::write(&path, now).expect("a golden file");
        } else {
            let what = golden.map_or_else(|_| "there is no such golden file".to_owned(), |old| difference(&old, now));
            complaints.push(format!("{}: {what}", path.display()));
        }
    }
    let how = "if this is meant: CHIARO_BLESS=1 cargo test --test export, and read the difference";
    assert!(complaints.is_empty(), "{}\n{how}", complaints.join("\n"));
}

#[test]
fn exporting_twice_gives_the_same_bytes() {
    assert_eq!(expected(), expected());
}
