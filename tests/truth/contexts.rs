//! Every context of the table on a GPU and on the reference: each is shown by a look of its own, so
//! that a new row is tested without further code.
#![cfg(feature = "gpu")]

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::Scene;
use chiaro::frame::{Executor, FramePlan, Picture, PlanOptions, Planner, SetupLook};
use chiaro::library::{Context, Library};
use chiaro::progress::Progress;
use chiaro::reference::Reference;
use serde_json::json;

const SIZE: [u32; 2] = [96, 80];

/// A look that shows a context, squeezed into the range of colors.
fn showing(context: Context) -> SetupLook {
    let (word, ty) = (context.word(), context.wgsl_type());
    let shown = match ty {
        "f32" => "vec3f(x)",
        "vec2f" => "vec3f(x, 0.0)",
        "vec3f" => "x",
        "vec4f" => "x.xyz + x.w",
        "Color" => "x.xyz",
        "mat3x3f" => "x * vec3f(0.2, 0.5, 0.9)",
        // The first row of the first object.
        "Casters" => "textureLoad(x, vec2i(0, 0), 0).xyz",
        // No light is asked about, so that there is none.
        "ShadowMaps" => "textureLoad(x, vec2i(0, 0), 0, 0).xyz",
        other => panic!("{word}: show a {other}"),
    };
    let code = format!(
        "import chiaro::types;\n\n/// Shows a context.\n///\n/// @param x from={word}\n\
         fn shown_context(x: {ty}) -> vec3f {{\n    let y = {shown};\n    \
         return 0.5 + 0.5 * y / (1.0 + abs(y));\n}}\n"
    );
    look(&json!({
        "nodes": [
            {"id": "own", "kind": "wgsl", "values": {"code": code}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "own", "to": "output.color"}]
    }))
}

fn plan_of(context: Context) -> FramePlan {
    let (mesh, fitted) = shape("torus");
    let setup = scene_of(
        vec![(showing(context), mesh, fitted)],
        Scene { backdrop: None, ..Scene::default() },
    );
    let options = PlanOptions { size: SIZE, samples: 1, time: 0.25 };
    let planned = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    planned.unwrap_or_else(|problems| panic!("{context:?}: {}", told(&problems))).value
}

fn drawn_by(executor: &mut dyn Executor, plan: &FramePlan) -> Picture {
    let picture = block_on(executor.picture(plan, &Progress::new()));
    picture.unwrap_or_else(|error| panic!("{}: {error}", executor.name()))
}

/// Number of pixels that both pictures show, and number of those that differ by more than a
/// hundredth.
fn differing(one: &Picture, other: &Picture) -> [usize; 2] {
    let both = one.rgba.iter().zip(&other.rgba).filter(|(a, b)| a[3] > 0.5 && b[3] > 0.5);
    both.fold([0; 2], |[count, far], (a, b)| {
        let is_near = a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 0.01);
        [count + 1, far + usize::from(!is_near)]
    })
}

#[test]
fn every_context_is_the_same_on_a_gpu_and_in_truth() {
    for context in Context::all().filter(|context| context.light_input().is_none()) {
        let plan = plan_of(context);
        let is_planned = |pass| plan.passes.iter().any(|planned| planned.id == pass);
        assert!(context.pass().is_none_or(is_planned), "{context:?}: its pass");
        let gpu = drawn_by(&mut *renderer(), &plan);
        let truth = drawn_by(&mut Reference::default(), &plan);
        let [count, far] = differing(&gpu, &truth);
        assert!(count > 1000, "{context:?}: {count} pixels");
        assert!(far * 50 < count, "{context:?}: {far} of {count} pixels differ");
    }
}

#[test]
fn a_picture_that_is_not_wanted_any_more_is_not_made() {
    let plan = plan_of(Context::KAPPA);
    for executor in [&mut *renderer() as &mut dyn Executor, &mut Reference::default()] {
        let progress = Progress::new();
        progress.stop();
        let stopped = block_on(executor.picture(&plan, &progress)).expect_err("it was stopped");
        assert_eq!(stopped.code, chiaro::progress::Interruption::CODE, "{}", executor.name());
    }
}
