//! Frame plans whose looks are drawn by WGSL written by hand, `benches/handwritten/*.wgsl`.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_compiler::compile::{CompileOptions, Live, compile};
use chiaro_compiler::document::Tier;
use chiaro_compiler::library::Library;
use chiaro_language::wgsl;
use chiaro_scene::frame::{Assets, FramePlan, PassId, PlanOptions, Planner, Setup, open};

/// The looks that have a module written by hand.
pub const LOOKS: [&str; 3] = ["figure4-both", "figure6-comics", "figure6-minimal"];

fn root(folder: &str) -> PathBuf {
    chiaro_test_support::root().join(folder)
}

/// An example look on the mesh that its file names.
pub fn setup(look: &str) -> Setup {
    let path = root("examples/looks").join(format!("{look}.json"));
    open(&path, None, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}", problems[0]))
        .value
}

/// The frame plan with the compiler's module, every node in one tier, one sample a pixel.
pub fn generated(setup: &Setup, tier: Tier, size: [u32; 2]) -> FramePlan {
    let mut setup = setup.clone();
    for look in &mut setup.looks {
        look.look.tier = tier;
    }
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    let plan = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    plan.unwrap_or_else(|problems| panic!("{}", problems[0])).value
}

/// The frame plan with the module written by hand in the generated one's place, with the same
/// bindings.
pub fn by_hand(setup: &Setup, look: &str, plan: &FramePlan) -> FramePlan {
    let options = CompileOptions { display: true, ..CompileOptions::default() };
    let mut shader =
        compile(&setup.looks[0].look, Library::built_in(), &options).expect("an example").value;
    let path = root("benches/handwritten").join(format!("{look}.wgsl"));
    shader.wgsl = std::fs::read_to_string(&path).expect("a file that can be read");
    shader.valid = wgsl::parse(&shader.wgsl)
        .unwrap_or_else(|error| panic!("{}: {}", path.display(), error.message));
    let shader = Arc::new(shader);
    let mut plan = plan.clone();
    plan.draws.iter_mut().for_each(|draw| draw.look = shader.clone());
    // Renderers skip a pass whose inputs are those of the last picture.
    plan.passes
        .iter_mut()
        .filter(|pass| pass.id == PassId::LOOK)
        .for_each(|pass| pass.input_hash ^= 1);
    plan
}
