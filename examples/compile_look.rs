//! Uses Chiaro as a library: reads a look, compiles it and prints its WGSL.
//!
//! `cargo run --no-default-features --example compile_look -- examples/looks/figure1-layers.json`

use std::path::Path;
use std::process::ExitCode;

use chiaro::compile::{CompileOptions, compile};
use chiaro::document::Look;
use chiaro::library::Library;

#[expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "an example talks to whoever runs it"
)]
fn main() -> ExitCode {
    let path =
        std::env::args().nth(1).unwrap_or_else(|| "examples/looks/figure1-layers.json".to_owned());
    let loaded = Look::load(&chiaro::files::Disk, Path::new(&path));
    for diagnostic in &loaded.diagnostics {
        eprintln!("{diagnostic}");
    }
    let Some(look) = loaded.value else { return ExitCode::FAILURE };
    match compile(&look, Library::built_in(), &CompileOptions::default()) {
        Ok(compiled) => {
            compiled.warnings.iter().for_each(|warning| eprintln!("{warning}"));
            let shader = compiled.value;
            println!("{}", shader.wgsl);
            for removal in &shader.removed {
                eprintln!("left out `{}`: {}", removal.path, removal.reason);
            }
            ExitCode::SUCCESS
        }
        Err(problems) => {
            for problem in problems {
                eprintln!("{problem}");
            }
            ExitCode::FAILURE
        }
    }
}
