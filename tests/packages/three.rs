//! The package `three` in three.js: both of its renderers, with a mesh, a camera and controls of
//! its own.

use crate::support::validators::{Tool, three_folder};
use serde_json::json;

use crate::library::{APIS, Library, Page, compare, compare_all};
use crate::pictures::{Difference, Trial, examples};

static THREE: Library = Library {
    slug: "three",
    tool: Tool::Three,
    folder: three_folder,
    page: &["three.html", "gltf.js"],
};

/// A look of each kind is drawn as we draw it: many passes, an image, painted surfaces, shadow maps,
/// one of linear light, and one that shows both sides.
#[test]
fn three_draws_what_we_draw() {
    let mut trials =
        examples(&["looks/ink-outlines", "hcbtf/grass-flat", "images/xtoon-orientation"]);
    let linear = Trial::changed("looks/figure2-diffuse", |look| {
        look["color_space"] = json!("linear");
    });
    trials.push(("linear".to_owned(), linear));
    let shadows = Trial::of("shadows/long-shadows").with(&["--tier", "balanced"]);
    trials.push(("long-shadows".to_owned(), shadows));
    // Back faces, and a parameter that GLSL has another word for: `output`.
    let cut = Trial::of("looks/technical-cutaway").live();
    trials.push(("technical-cutaway".to_owned(), cut));
    compare(&THREE, &trials);
}

/// All example looks. `CHIARO_BLESS=1` writes their lines.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_three_draws_all_examples() {
    compare_all(&THREE);
}

/// Parameters and lights that are set through the material change the same pixels as in Chiaro, and
/// a wrong name or value is told.
#[test]
fn parameters_and_lights_are_those_of_the_look() {
    let trial = Trial::of("looks/figure3-profile");
    let changed = Trial::changed("looks/figure3-profile", |look| {
        look["nodes"][1]["values"]["falloff"] = json!(0.9);
        look["lights"]["key"]["direction"] = json!([0.7, -0.4, 0.2]);
    });
    let Some(mut page) = Page::new(&THREE, &[&trial]) else { return };
    for api in APIS {
        page.open(api);
        page.wear(0);
        let arguments = page.own_arguments();
        let ours = changed.ours_with_arguments(&arguments.each_ref().map(String::as_str));
        let before = page.pixels();
        page.evaluate("test.mesh.material.parameters.falloff = 0.9");
        page.evaluate("test.mesh.material.lights.key.direction = [0.7, -0.4, 0.2]");
        let set = page.pixels();
        let found = Difference::of(&set, &ours);
        // WebGL takes derivatives from the other row of two.
        if api == "webgpu" {
            assert!(found.greatest <= 1, "{api}: {found:?}");
        }
        assert!(found.beyond <= 20, "{api}: {found:?}");
        assert!(Difference::of(&before, &ours).beyond > 500, "{api}: the values are seen");
        page.evaluate("test.mesh.material.lights.key.direction = undefined");
        // A light of three.js from the same side.
        page.evaluate("test.follow('key', [0.7, -0.4, 0.2]), true");
        let followed = page.pixels();
        let differ = set.iter().zip(&followed).filter(|(a, b)| a.abs_diff(**b) > 1).count();
        assert_eq!(differ, 0, "{api}: the light of three.js is followed");
        page.evaluate("test.follow('key', null), true");
        page.evaluate("test.mesh.material.parameters.falloff = undefined");
        assert_eq!(before, page.pixels(), "{api}: the look's own values are back");
        page.evaluate("test.mesh.material.lights.key.color = '#336699'");
        let color = page.evaluate("test.mesh.material.lights.key.color");
        assert_eq!(color, json!([0.2, 0.4, 0.6]), "{api}: colors in hex");
        for (wrong, told) in [
            ("follow('kee', null)", "no light \"kee\", but key"),
            ("parameters.falloff = 'wide'", "parameters.falloff is a number"),
            ("lights.key.direction = [1, 2]", "takes 3 numbers"),
            ("lights.key.color = 'red'", "such as \"#40c070\""),
        ] {
            let error = page.browser.evaluate(&format!("test.mesh.material.{wrong}"));
            assert!(error.as_ref().is_err_and(|it| it.contains(told)), "{api}: {error:?}");
        }
    }
}
