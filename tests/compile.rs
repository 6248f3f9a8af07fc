//! Looks compile to WGSL that naga accepts.

use chiaro::compile::{Live, Options, Stage, compile};
use chiaro::document::Look;
use chiaro::library::Library;

#[test]
fn a_look_compiles_for_every_stage_and_liveness() {
    let library = Library::built_in();
    for problem in &library.problems {
        panic!("{problem}");
    }
    let text = include_str!("../examples/looks/first.json");
    let loaded = Look::read(text, "first.json");
    for d in &loaded.diagnostics {
        println!("{d}");
    }
    let look = loaded.value.unwrap();
    for stage in [Stage::Draw, Stage::Normals, Stage::Eval] {
        for live in [Live::Keyed, Live::Exposed, Live::All] {
            for unspecialized in [false, true] {
                let options = Options { live: live.clone(), stage, root: None, unspecialized };
                match compile(&look, library, &options) {
                    Ok(shader) => {
                        if !unspecialized {
                            println!("=== {stage:?} {live:?}\n{}", shader.wgsl);
                        }
                    }
                    Err(problems) => panic!(
                        "{stage:?} {live:?} {unspecialized}: {}",
                        problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
                    ),
                }
            }
        }
    }
}
