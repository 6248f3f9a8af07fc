//! Frame plans whose looks are drawn by WGSL written by hand, `benches/handwritten/*.wgsl`.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_compiler::compile::{CompileOptions, Live, compile};
use chiaro_compiler::document::Tier;
use chiaro_compiler::library::Library;
use chiaro_language::wgsl;
use chiaro_scene::frame::{Assets, FramePlan, PassId, PlanOptions, Planner, Setup, open};

/// Folder of the examples.
const EXAMPLES: &str = "examples/looks";
/// Folder of looks that are there to be measured alone.
const MEASURED: &str = "benches/handwritten/looks";

/// A look that has a module written by hand.
#[derive(Clone, Copy, Debug)]
pub struct HandwrittenLook {
    /// Stem of the look's document and of the module.
    pub name: &'static str,
    /// Folder of the document, from the root of the repository.
    pub folder: &'static str,
}

/// The looks that have a module written by hand.
pub const LOOKS: [HandwrittenLook; 7] = [
    HandwrittenLook { name: "figure4-both", folder: EXAMPLES },
    HandwrittenLook { name: "figure6-comics", folder: EXAMPLES },
    HandwrittenLook { name: "figure6-minimal", folder: EXAMPLES },
    HandwrittenLook { name: "math-gooch", folder: MEASURED },
    HandwrittenLook { name: "math-toon", folder: MEASURED },
    HandwrittenLook { name: "math-layers", folder: MEASURED },
    HandwrittenLook { name: "math-chain", folder: MEASURED },
];

fn root(folder: &str) -> PathBuf {
    chiaro_test_support::root().join(folder)
}

/// A look on the mesh on which looks are shown.
pub fn setup(look: HandwrittenLook) -> Setup {
    let path = root(look.folder).join(format!("{}.json", look.name));
    open(&path, None, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}", problems[0]))
        .value
}

/// The frame plan with the compiler's module, every node in one tier, or where none is given in the
/// cheapest that nobody can see, one sample a pixel. Drawn triangle by triangle, for modules are
/// compared and not ways to draw.
pub fn generated(setup: &Setup, tier: Option<Tier>, size: [u32; 2]) -> FramePlan {
    let mut setup = setup.clone();
    for look in &mut setup.looks {
        look.look.tier = tier;
    }
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    let plan = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    plan.unwrap_or_else(|problems| panic!("{}", problems[0])).value.forward()
}

/// The frame plan with the module written by hand in the generated one's place, with the same
/// bindings.
pub fn by_hand(setup: &Setup, look: HandwrittenLook, plan: &FramePlan) -> FramePlan {
    let options = CompileOptions { display: true, ..CompileOptions::default() };
    let mut shader =
        compile(&setup.looks[0].look, Library::built_in(), &options).expect("a right look").value;
    let path = root("benches/handwritten").join(format!("{}.wgsl", look.name));
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
