//! The examples embedded in the program are those of the source tree.

use std::collections::BTreeSet;
use std::path::Path;

use chiaro_compiler::examples::{PREFIX, file, names};

#[test]
fn every_example_is_there_as_it_lies_in_the_source() {
    let root = crate::support::root().join("examples");
    let mut found = BTreeSet::new();
    for folder in ["looks", "shadows", "hcbtf", "scenes", "images"] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let name = format!("{folder}/{}", entry.unwrap().file_name().to_str().unwrap());
            let path = Path::new("somewhere/else").join(format!("{PREFIX}{name}"));
            assert_eq!(file(&path).unwrap(), std::fs::read(root.join(&name)).unwrap(), "{name}");
            found.insert(name);
        }
    }
    assert_eq!(found, names().map(str::to_owned).collect());
}
