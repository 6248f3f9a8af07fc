//! Three whole looks against their closed forms: every pixel is computed here in f64, from the
//! paper's formulas (`formulas`), for surfaces that are known at every point (`surfaces`), and
//! compared with the reference's picture.
//!
//! `cargo test --test truth closed_forms -- --nocapture` prints the largest difference of each. On
//! a plane whose normals turn linearly everything has a closed form, the curvature pass included,
//! so that only the polynomials of the shader library differ: the least accurate of them are
//! atan2's series (3e-9) and the logarithm's (2e-10, times a profile's exponent). On a sphere made
//! of triangles the triangles differ.

mod formulas;
mod surfaces;

use std::path::{Path, PathBuf};

use crate::support::report::Errors;
use chiaro::compile::Live;
use chiaro::document::{Camera, Look, Projection, Scene};
use chiaro::frame::{Assets, FramePlan, PlanOptions, Planner, Setup, SetupLook, SetupObject};
use chiaro::geometry::Mesh;
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules, ReferencePicture};
use formulas::Stack;
use glam::{DMat4, DVec4};
use serde_json::Value as Json;
use surfaces::{Plane, Sphere, Surface};

const LOOKS: [&str; 3] = ["figure1-layers", "figure6-comics", "figure5-directional"];
const SIZE: [u32; 2] = [192, 128];

/// JSON of an example look, changed by `change`.
fn example(name: &str, change: impl Fn(&mut Json)) -> Json {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/looks/{name}.json"));
    let text = std::fs::read_to_string(path).expect("an example");
    let mut json = serde_json::from_str(&text).expect("JSON");
    change(&mut json);
    json
}

/// Takes curvature out of a look: no slopes in its colors and warps.
fn flat(json: &mut Json) {
    for node in json["nodes"]
        .as_array_mut()
        .expect("nodes")
        .iter_mut()
        .filter(|node| node["kind"] == "light_layer")
    {
        node["values"]["slope"] = 0.0.into();
    }
}

/// Moves the key light between the two keys of figure 5, where both have weight.
fn between_keys(json: &mut Json) {
    if json.get("direction_keys").is_some() {
        json["lights"]["key"]["direction"] = serde_json::json!([-0.25, 0.8, -0.1]);
    }
}

fn plan(look: &Json, mesh: Mesh, camera: Camera) -> FramePlan {
    let loaded = Look::read(&look.to_string(), "closed-form.json");
    let look = SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: PathBuf::new(),
    };
    let object = SetupObject {
        id: "surface".into(),
        looks: vec![Some(0); mesh.parts.len()],
        mesh: mesh.into(),
        world_from_object: DMat4::IDENTITY,
        animation: None,
        values: Default::default(),
        light_link: Default::default(),
        shadow_link: Default::default(),
        layers: Default::default(),
    };
    let scene = Scene { camera, ..Scene::default() };
    let setup = Setup { scene, looks: vec![look], objects: vec![object], ..Setup::default() };
    let options = PlanOptions { size: SIZE, samples: 1, time: 0.0 };
    let mut planner = Planner::for_truth(Assets::default());
    planner.plan(&setup, Library::built_in(), &Live::All, &options).expect("it is planned").value
}

fn picture(plan: &FramePlan) -> ReferencePicture {
    let modules = Modules::new(plan, Precision::F64).expect("it compiles");
    reference::execute(plan, &modules, &reference::ReferenceOptions::default(), &Progress::new())
        .expect("it is drawn")
}

/// Compares the picture of a look with its closed form, at all pixels that `surface` knows.
fn compare(errors: &mut Errors, look: &Json, surface: &dyn Surface, camera: Camera) {
    let plan = plan(look, surface.mesh(), camera);
    let picture = picture(&plan);
    let eye = surfaces::Eye::new(&camera, SIZE);
    let stack = Stack::read(look, eye.camera_from_world());
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            let quad = [0, 1, 2, 3].map(|lane| [x & !1 | lane & 1, y & !1 | lane >> 1]);
            let own = (x & 1 | (y & 1) << 1) as usize;
            let Some(points) = surface.quad(&eye, quad, own) else { continue };
            let wanted = stack.color(&points, own);
            let got = DVec4::from_array(picture.straight(x, y));
            for channel in 0..4 {
                errors.note(got[channel], wanted[channel], || {
                    format!("pixel ({x}, {y}), channel {channel}")
                });
            }
        }
    }
}

fn cameras() -> [(&'static str, Camera); 2] {
    let camera = Camera { eye: [0.0, 0.0, 3.0], fov: 0.6, height: 1.5, ..Camera::default() };
    [
        ("perspective", Camera { projection: Projection::Perspective, ..camera }),
        ("parallel", Camera { projection: Projection::Orthographic, ..camera }),
    ]
}

#[test]
fn a_plane_of_turning_normals_without_curvature() {
    for look in LOOKS {
        let json = example(look, |json| {
            flat(json);
            between_keys(json);
        });
        for (name, camera) in cameras() {
            let mut errors = Errors::new(format!("{look}, plane, {name}, slope 0"), 1e-6);
            compare(&mut errors, &json, &Plane, camera);
            errors.finish();
        }
    }
}

/// A plane whose normals' slope is linear on the screen, so that finite differences measure it
/// exactly.
#[test]
fn a_plane_of_turning_normals_with_curvature_from_the_pass() {
    for look in LOOKS {
        let json = example(look, between_keys);
        for (name, camera) in cameras() {
            let mut errors = Errors::new(format!("{look}, plane, {name}, curvature"), 1e-6);
            compare(&mut errors, &json, &Plane, camera);
            errors.finish();
        }
    }
}

/// A sphere met by rays, by its equation. The mesh is as fine as its triangles, which are 1/120
/// wide: at most 1e-5 below the sphere, so that angles differ by up to 4e-5 toward the rim, twice
/// that where the view is mirrored. A highlight that falls within 0.1 multiplies that by ten;
/// cartoon edges take the width of their ramp from the triangles' planes, which lean by 1/240.
#[test]
fn a_sphere_by_its_equation() {
    for (look, bound) in LOOKS.into_iter().zip([1e-4, 2e-3, 4e-4]) {
        let json = example(look, |json| {
            flat(json);
            between_keys(json);
        });
        for (name, camera) in cameras() {
            let camera = Camera { height: 2.5, fov: 0.9, ..camera };
            let mut errors = Errors::new(format!("{look}, sphere, {name}, slope 0"), bound);
            compare(&mut errors, &json, &Sphere { least_facing: 0.3 }, camera);
            errors.finish();
        }
    }
}

/// The sphere's curvature, kappa = (1 + nz^2) / (2 R nz^3), against differences over up to three
/// pixels of a sphere of 160: relative errors of 2e-4 in the middle, 1e-3 where n.z is 0.8.
#[test]
fn a_sphere_with_curvature_from_the_pass() {
    for (look, bound) in LOOKS.into_iter().zip([2e-4, 5e-3, 2e-4]) {
        let json = example(look, between_keys);
        let camera = Camera { height: 0.8, ..cameras()[1].1 };
        let mut errors = Errors::new(format!("{look}, sphere, parallel, curvature"), bound);
        compare(&mut errors, &json, &Sphere { least_facing: 0.8 }, camera);
        errors.finish();
    }
}
