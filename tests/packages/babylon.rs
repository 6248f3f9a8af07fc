//! The package `babylon` in Babylon.js, by WebGL and WebGPU, with a mesh and a camera of its own.

use crate::support::validators::{Tool, babylon_folder};
use serde_json::json;

use crate::library::{APIS, Library, Page, compare, compare_all};
use crate::pictures::{Difference, Trial, examples};

static BABYLON: Library = Library {
    slug: "babylon",
    tool: Tool::Babylon,
    folder: babylon_folder,
    page: &["babylon.html", "babylon.core.js", "gltf.js"],
};

/// Looks are drawn as we draw them: many lights, passes, painted surfaces, shadow maps, one of
/// linear light, and one that shows both sides.
#[test]
fn babylon_draws_what_we_draw() {
    let mut trials = examples(&["looks/string-of-lamps", "hcbtf/grass-flat"]);
    let shadows = Trial::of("shadows/long-shadows").with(&["--tier", "balanced"]);
    trials.push(("long-shadows".to_owned(), shadows));
    let linear = Trial::changed("looks/figure2-diffuse", |look| {
        look["color_space"] = json!("linear");
    });
    trials.push(("linear".to_owned(), linear));
    // Back faces, seen where a parameter cuts parts away.
    let cut = Trial::of("looks/technical-cutaway").live();
    trials.push(("technical-cutaway".to_owned(), cut));
    compare(&BABYLON, &trials);
}

/// All example looks. `CHIARO_BLESS=1` writes their lines.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_babylon_draws_all_examples() {
    compare_all(&BABYLON);
}

/// Painted surfaces in BC7 blocks are refused by hosts that take no such layers.
#[test]
fn painted_surfaces_in_blocks_are_refused() {
    for slug in ["babylon", "blender"] {
        let refused = Trial::of("hcbtf/grass-flat").export(slug, &["--textures", "blocks"]);
        let problem = refused.expect_err(slug);
        assert!(problem.contains("not-in-package") && problem.contains("BC7"), "{problem}");
        assert!(problem.contains("--textures compact"), "{problem}");
    }
}

/// Parameters and lights that are set through the material change the same pixels as in Chiaro, in
/// scenes of either hand.
#[test]
fn parameters_and_lights_are_those_of_the_look() {
    let trial = Trial::of("looks/figure3-profile");
    let changed = Trial::changed("looks/figure3-profile", |look| {
        look["nodes"][1]["values"]["falloff"] = json!(0.9);
        look["lights"]["key"]["direction"] = json!([0.7, -0.4, 0.2]);
    });
    let Some(mut page) = Page::new(&BABYLON, &[&trial]) else { return };
    for api in APIS {
        page.open(api);
        page.wear(0);
        let arguments = page.own_arguments();
        let ours = changed.ours_with_arguments(&arguments.each_ref().map(String::as_str));
        let before = page.pixels();
        page.evaluate("test.mesh.material.parameters.falloff = 0.9");
        page.evaluate("test.mesh.material.lights.key.direction = [0.7, -0.4, 0.2]");
        let found = Difference::of(&page.pixels(), &ours);
        // WebGL takes derivatives from the other row of two.
        if api == "webgpu" {
            assert!(found.greatest <= 1, "{api}: {found:?}");
        }
        assert!(found.beyond <= 20, "{api}: {found:?}");
        assert!(Difference::of(&before, &ours).beyond > 500, "{api}: the values are seen");
        page.evaluate("test.mesh.material.lights.key.direction = undefined");
        page.evaluate("test.mesh.material.parameters.falloff = undefined");
        assert_eq!(before, page.pixels(), "{api}: the look's own values are back");
        let wrong = page.browser.evaluate("test.mesh.material.parameters.fallof = 1");
        let told = "there is no parameters.fallof, but";
        assert!(wrong.as_ref().is_err_and(|it| it.contains(told)), "{api}: {wrong:?}");
    }
}
