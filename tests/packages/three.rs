//! The package `three` in three.js: both of its renderers, with a mesh, a camera and controls of
//! its own.

use crate::support::root;
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

/// A look of each kind is drawn as we draw it: many passes, an image, painted surfaces, shadow
/// maps, one of linear light, and one that shows both sides.
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
    // WebGPU has no sampler of three.js for every way of reading the nearest texel.
    let nearest = Trial::changed("images/xtoon-orientation", |look| {
        let values = &mut look["nodes"][4]["values"];
        let image = root().join("examples/images").join(values["image"].as_str().expect("a name"));
        values["image"] = json!(image);
        values["filter"] = json!("nearest");
    });
    trials.push(("nearest".to_owned(), nearest));
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
        if api == "webgl" {
            fits_models_of_several_meshes(&mut page);
        } else {
            // In software, WebGL warns that it does not compile beside the page.
            page.evaluate("test.compile().then(() => true)");
            assert_eq!(before, page.pixels(), "a clone that was compiled before it is drawn");
        }
        page.evaluate("test.mesh.material.lights.key.color = '#336699'");
        let color = page.evaluate("test.mesh.material.lights.key.color");
        assert_eq!(color, json!([0.2, 0.4, 0.6]), "{api}: colors in hex");
        let number = "(test.mesh.material.lights.key.color = 0x336699, \
            test.mesh.material.lights.key.color)";
        assert_eq!(page.evaluate(number), color, "{api}: numbers are hex, as in three.js");
        for (wrong, told) in [
            ("follow('kee', null)", "no light \"kee\", but key"),
            ("parameters.falloff = 'wide'", "parameters.falloff is a number"),
            ("lights.key.direction = [1, 2]", "takes 3 numbers"),
            ("lights.key.color = 'red'", "such as \"#40c070\""),
            ("lights.key.color = 0.5", "such as \"#40c070\""),
            ("lights.key.colour = '#336699'", "there is no lights.key.colour, but direction"),
            ("parameters.fallof = 1", "there is no parameters.fallof, but"),
            ("illumination = [1, 0, 0]", "illumination is a Matrix3"),
        ] {
            let error = page.browser.evaluate(&format!("test.mesh.material.{wrong}"));
            assert!(error.as_ref().is_err_and(|it| it.contains(told)), "{api}: {error:?}");
        }
    }
}

/// A model of several meshes has the size that looks are made for after `fitAll`, and stays where
/// it was.
fn fits_models_of_several_meshes(page: &mut Page) {
    let found = page.evaluate("test.fitted('0', 'figure3-profile')");
    assert!(found["moved"].as_f64().expect("a distance") < 1e-6, "{found}");
    // Radius 1 at the middle and radius 0.5 at 2: together from -1 to 2.5.
    for (place, radius) in [(0, 1.0), (1, 0.5)] {
        let fitted = found["radii"][place].as_f64().expect("a radius");
        assert!((fitted - radius / 1.75).abs() < 1e-6, "{found}");
    }
}
