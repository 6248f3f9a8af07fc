//! Microsoft's own compiler of HLSL takes what is exported, by the rules of both language versions.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::support::validators::say;
use crate::support::{files, root};

/// The program that `tests/dxc/fetch` makes.
fn dxc() -> PathBuf {
    root().join(".tools/dxc/dxc")
}

/// Complaints of dxc about an entry point of a file, as a vertex or a pixel shader of a version of
/// the language.
fn complaints(file: &Path, entry: &str, version: &str) -> Option<String> {
    let profile = if entry == "vs_main" { "vs_6_0" } else { "ps_6_0" };
    let output = Command::new(dxc())
        .arg(file)
        .args(["-T", profile, "-E", entry, "-HV", version])
        .output()
        .expect("dxc starts");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    (!output.status.success()).then_some(said)
}

/// All golden files, by HLSL 2018 and 2021. A vector before `?` is right in one and wrong in the
/// other, so that dxc is known to tell them apart.
#[test]
#[ignore = "takes a minute; scripts/soak runs it where tests/dxc/fetch was run"]
fn soak_dxc_takes_the_goldens() {
    if !dxc().is_file() {
        say("SKIPPED: dxc is missing; tests/dxc/fetch fetches it");
        return;
    }
    let place = tempfile::tempdir().expect("a folder");
    let file = place.path().join("choice.hlsl");
    let text = "float4 fs_main(float4 x : A) : SV_Target { return x > 0.5 ? x : x * x; }";
    std::fs::write(&file, text).expect("a file");
    assert_eq!(complaints(&file, "fs_main", "2018"), None);
    let said = complaints(&file, "fs_main", "2021").expect("a complaint");
    assert!(said.contains("must be scalar"), "{said}");
    let goldens = files::below(&root().join("tests/golden"));
    let mut count = 0;
    for file in goldens.iter().filter(|path| path.extension().is_some_and(|it| it == "hlsl")) {
        let text = std::fs::read_to_string(file).expect("a text");
        for entry in ["vs_main", "fs_main"].iter().filter(|it| text.contains(&format!(" {it}("))) {
            for version in ["2018", "2021"] {
                count += 1;
                let said = complaints(file, entry, version);
                assert_eq!(said, None, "{} of {}, HLSL {version}", entry, file.display());
            }
        }
    }
    assert!(count > 500, "{count} entry points were compiled");
}
