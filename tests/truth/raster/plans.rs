//! The executor: passes in the order of the plan, each with the images that it reads.

use std::path::Path;
use std::sync::{Arc, Mutex};

use chiaro::compile::Live;
use chiaro::diag::Diagnostic;
use chiaro::frame::{Assets, Draw, FramePlan, PassId, PlanOptions, Planner, ShadowMaps, open};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{
    Modules, PassImages, ReferenceOptions, Shader, ShaderFactory, VaryingInterpolation, execute,
};
use glam::DVec3;

use super::shaders::Plain;

const NORMALS: PassId = PassId::named("normals");
const CURVATURE: PassId = PassId::named("curvature");

/// Shaders as closures that note which draws were asked for.
#[derive(Default)]
struct RecordingFactory(Mutex<Vec<&'static str>>);

impl RecordingFactory {
    fn note(&self, what: &'static str) {
        self.0.lock().expect("nobody panics").push(what);
    }
}

impl ShaderFactory for RecordingFactory {
    fn draw<'a>(
        &'a self,
        plan: &'a FramePlan,
        draw: &'a Draw,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        // The test's scene does not move the object's mesh.
        let positions = draw.mesh.positions.iter().map(|p| DVec3::from_array(p.map(f64::from)));
        let clip = positions
            .clone()
            .map(|p| (plan.view.clip_from_world * p.extend(1.0)).to_array())
            .collect();
        let seen = positions
            .map(|p| plan.view.camera_from_world.transform_point3(p).to_array().to_vec())
            .collect();
        let shader = if pass == PassId::LOOK {
            self.note("look");
            let curvature = images.first(CURVATURE).expect("the curvature pass came before");
            Plain::new(clip, move |batch, lane| {
                let [x, y] = [0, 1].map(|c| batch.position(c)[lane] as u32);
                Some(vec![curvature.pixel(x, y)[0], 0.0, 0.0, 1.0])
            })
        } else {
            self.note("normals");
            Plain::new(clip, |batch, lane| Some(vec![0.0, 0.0, -batch.varying(2)[lane], 7.0]))
        };
        Ok(Box::new(shader.with(VaryingInterpolation::Perspective, seen)))
    }

    fn screen<'a>(
        &'a self,
        _: &'a FramePlan,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        assert_eq!(pass, CURVATURE);
        self.note("curvature");
        let missing = || Diagnostic::error("reference-plan", "the normals come before");
        let surface = images.first(NORMALS).ok_or_else(missing)?;
        let fragment = |batch: &chiaro::reference::QuadBatch, lane: usize| {
            let [x, y] = [0, 1].map(|c| batch.position(c)[lane] as u32);
            let is_inside = x < surface.size[0] && y < surface.size[1];
            Some(vec![if is_inside { surface.pixel(x, y)[2..].iter().sum::<f64>() } else { 0.0 }])
        };
        Ok(Box::new(Plain::new(Vec::new(), fragment)))
    }

    fn layer<'a>(
        &'a self,
        _: &'a ShadowMaps,
        _: PassId,
        _: usize,
        _: &'a PassImages,
    ) -> Result<Vec<Box<dyn Shader + 'a>>, Diagnostic> {
        self.note("lights");
        Ok(Vec::new())
    }
}

fn plan(look: &str, size: [u32; 2]) -> FramePlan {
    let mut assets = Assets::default();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks").join(look);
    let mut setup = open(&path, Some("shape:sphere"), &mut assets).expect("an example").value;
    setup.objects[0].world_from_object = glam::DMat4::IDENTITY;
    let options = PlanOptions { size, samples: 4, time: 0.0 };
    Planner::new(assets)
        .plan(&setup, Library::built_in(), &Live::Keyed, &options)
        .expect("an example")
        .value
}

#[test]
fn passes_run_in_order_and_read_each_other() {
    let plan = plan("figure6-comics.json", [81, 60]);
    let kinds: Vec<_> = plan.passes.iter().map(|pass| pass.id).collect();
    assert_eq!(kinds, [NORMALS, CURVATURE, PassId::LOOK]);
    let shaders = RecordingFactory::default();
    let shares: Arc<Mutex<Vec<f64>>> = Arc::default();
    let observed = shares.clone();
    let progress = Progress::observed(move |progress| {
        observed.lock().expect("nobody panics").push(progress.share());
    });
    let options = ReferenceOptions { threads: 1, tile: 16, ..ReferenceOptions::default() };
    let picture = execute(&plan, &shaders, &options, &progress).expect("nothing fails");
    assert_eq!(*shaders.0.lock().expect("nobody panics"), ["normals", "curvature", "look"]);
    let shares = std::mem::take(&mut *shares.lock().expect("nobody panics"));
    assert!(shares.is_sorted() && shares.last() == Some(&1.0), "{shares:?}");
    // The middle shows the object's number plus 1 and the distance of the sphere; the corner shows
    // the backdrop.
    let middle = picture.straight(40, 30);
    let distance = (plan.view.eye.length() - 1.0) + 7.0;
    assert!((middle[0] - distance).abs() < 0.02, "{middle:?}, not {distance}");
    assert_eq!(picture.object(40, 30), Some(&plan.draws[0].object));
    assert!(picture.coverage(40, 30).is_inside(4));
    assert_eq!((picture.coverage(0, 0).draw, picture.object(0, 0)), (None, None));
    let backdrop = plan.backdrop.expect("the default scene has one");
    assert!(
        picture
            .straight(0, 0)
            .iter()
            .zip(backdrop)
            .all(|(found, wanted)| (found - wanted).abs() < 1e-15)
    );
    assert_eq!(picture.to_picture().rgba.len(), 81 * 60);
}

#[test]
fn a_plan_out_of_order_is_refused() {
    let mut plan = plan("figure6-comics.json", [16, 16]);
    plan.passes.remove(0);
    let modules = Modules::new(&plan, Precision::F64).expect("modules that run");
    for shaders in [&RecordingFactory::default() as &dyn ShaderFactory, &modules] {
        let problem = execute(&plan, shaders, &ReferenceOptions::default(), &Progress::new())
            .expect_err("no normals");
        assert_eq!(problem.code, "reference-plan");
    }
    plan.passes.clear();
    let problem = execute(
        &plan,
        &RecordingFactory::default(),
        &ReferenceOptions::default(),
        &Progress::new(),
    )
    .expect_err("no picture");
    assert_eq!(problem.code, "reference-plan");
}
