//! The package `web` in Chromium, by WebGPU and by WebGL 2.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::support::chromium::{Chromium, from_base64};
use crate::support::root;
use serde_json::json;

use crate::pictures::{Difference, SIZE, Trial, examples, soak_trials};
use crate::table;

/// The APIs that the page draws by, with the names that it shows.
const APIS: [(&str, &str); 2] = [("webgpu", "WebGPU"), ("webgl2", "WebGL 2")];

/// Opens the page of a package, and waits until it draws.
fn open(browser: &mut Chromium, package: &Path, (api, name): (&str, &str)) {
    let page = package.join("index.html");
    browser.open_file_with(&page, &format!("?api={api}")).expect("the page opens");
    let found = browser.evaluate("chiaro.ready.then((player) => player.api)");
    assert_eq!(found, Ok(json!(name)), "{}", package.display());
}

/// The picture of the page that is open, as `chiaro.picture` gives it.
fn picture(browser: &mut Chromium) -> Vec<u8> {
    let [width, height] = SIZE;
    let asked = format!(
        "chiaro.picture({width}, {height}, {{ samples: 1 }}).then(({{ data }}) => {{
            let text = '';
            for (const byte of data) text += String.fromCharCode(byte);
            return btoa(text);
        }})"
    );
    let text = browser.evaluate(&asked).expect("a picture");
    from_base64(text.as_str().expect("base64")).expect("bytes")
}

/// Compares the pages of looks with our own pictures, and the differences with the table.
fn compare(browser: &mut Chromium, trials: &[(String, Trial)]) {
    let mut measured = BTreeMap::new();
    for (name, trial) in trials {
        let package = trial.package("web");
        let ours = trial.ours();
        for api in APIS {
            open(browser, &package, api);
            let found = Difference::of(&picture(browser), &ours);
            measured.insert(format!("web {} {name}", api.0), found);
            assert!(browser.console_errors().is_empty(), "{name}: {:?}", browser.console_errors());
        }
    }
    table::check(&measured);
}

/// A look of each kind of passes and textures is drawn as we draw it: layers with curvature,
/// painted surfaces, shadows. [`soak_pages_of_all_examples_show_what_we_show`] has the others.
#[test]
fn pages_show_what_we_show() {
    let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
    let mut trials = examples(&["looks/figure1-layers", "hcbtf/grass-flat"]);
    let shadows = Trial::of("shadows/long-shadows").with(&["--tier", "balanced"]);
    trials.push(("long-shadows".to_owned(), shadows));
    compare(&mut browser, &trials);
}

/// Looks that no example is like: a transparent one, and one of linear light.
fn changed_looks() -> [(String, Trial); 2] {
    let transparent = Trial::changed("looks/highlight-moves", |look| {
        look["nodes"][0]["values"]["color"] = json!([0.16, 0.3, 0.55, 0.4]);
    });
    let linear = Trial::changed("looks/highlight-moves", |look| {
        look["color_space"] = json!("linear");
    });
    [("transparent".to_owned(), transparent), ("linear".to_owned(), linear)]
}

/// A parameter and a light that the page sets change what they change in our own picture; what is
/// reset is as before.
#[test]
fn parameters_and_lights_change_what_they_change_with_us() {
    let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
    let trial = Trial::of("looks/highlight-moves");
    let package = trial.package("web");
    let before = trial.ours();
    let values = json!({"move_x": 0.35, "color": [0.6, 0.2, 0.1, 1.0], "turn": 0.8});
    let set = trial.ours_with(&values);
    assert!(Difference::of(before.as_raw(), &set).beyond > 500, "the values are seen");
    let turned = Trial::changed("looks/highlight-moves", |look| {
        look["lights"]["key"]["direction"] = json!([0.7, 0.1, 0.7]);
        look["lights"]["key"]["intensity"] = json!(0.6);
    });
    let turned = turned.ours();
    for api in APIS {
        open(&mut browser, &package, api);
        let mut shows = |script: &str, ours| {
            browser.evaluate(script).expect(script);
            let found = Difference::of(&picture(&mut browser), ours);
            assert!(found.greatest <= 1, "{} after {script}: {found:?}", api.1);
        };
        let set_each = values.as_object().into_iter().flatten();
        let set_each = set_each.map(|(name, value)| format!("chiaro.set({name:?}, {value});"));
        let all: String = set_each.collect();
        shows(&all, &set);
        let light = "chiaro.light('key', { direction: [0.7, 0.1, 0.7], intensity: 0.6 })";
        shows(&format!("chiaro.reset(); {light}"), &turned);
        shows("chiaro.reset()", &before);
        let unknown = browser.evaluate("chiaro.set('nothing', 1)").expect_err("an error");
        assert!(unknown.contains("move_x"), "the names that there are: {unknown}");
    }
}

/// The page has a control with a name for each parameter, and a drag on the picture turns it.
#[test]
fn the_page_is_worked_by_hand_and_keys() {
    let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
    browser.resize([900, 600]).expect("a size");
    let trial = Trial::of("looks/highlight-moves");
    let package = trial.package("web");
    open(&mut browser, &package, APIS[1]);
    let labels = "[...document.querySelectorAll('.panel label')].map((one) => one.textContent)";
    let labels = browser.evaluate(labels).expect("labels");
    for wanted in ["Body", "Move right", "Split upright", "key"] {
        assert!(labels.as_array().is_some_and(|all| all.contains(&json!(wanted))), "{labels}");
    }
    // Each control has a name of its own.
    let names = "[...document.querySelectorAll('.panel [aria-label]')]
        .map((one) => one.getAttribute('aria-label'))";
    let names = browser.evaluate(names).expect("names");
    let names: Vec<&str> =
        names.as_array().into_iter().flatten().filter_map(|name| name.as_str()).collect();
    let once: BTreeSet<&str> = names.iter().copied().collect();
    assert_eq!(names.len(), once.len(), "{names:?}");
    // A slider moves the value, and its button gives it back.
    let slid = "(() => {
        const slider = document.querySelector('[data-parameter] input[type=range]');
        slider.value = slider.max;
        slider.dispatchEvent(new Event('input'));
        const set = Object.keys(chiaro.player.values).length;
        slider.closest('.row').querySelector('.reset').click();
        return [set, Object.keys(chiaro.player.values).length];
    })()";
    assert_eq!(browser.evaluate(slid), Ok(json!([1, 0])));
    let eye = "chiaro.player.camera.eye.map((x) => Math.round(1000 * x))";
    let before = browser.evaluate(eye).expect("the camera");
    let mouse = |kind: &str, x: i32| {
        let buttons = i32::from(kind != "mouseReleased");
        json!({"type": kind, "x": x, "y": 300, "button": "left", "buttons": buttons})
    };
    for (kind, x) in [("mousePressed", 200), ("mouseMoved", 260), ("mouseReleased", 260)] {
        browser.call("Input.dispatchMouseEvent", &mouse(kind, x)).expect("a drag");
    }
    let dragged = browser.evaluate(eye).expect("the camera");
    assert_ne!(before, dragged, "a drag turns the view");
    for kind in ["keyDown", "keyUp"] {
        let key = json!({"type": kind, "key": "Home", "code": "Home", "windowsVirtualKeyCode": 36});
        browser.call("Input.dispatchKeyEvent", &key).expect("a key");
    }
    assert_eq!(browser.evaluate(eye), Ok(before), "Home shows the view as at the start");
    // Drawing ends soon after the last change, on a busy machine as well.
    let rest = "(async () => {
        const pause = () => new Promise((resolve) => setTimeout(resolve, 150));
        for (let turn = 0; turn < 60; turn++) {
            const drawn = chiaro.player.drawn;
            await pause();
            if (chiaro.player.drawn === drawn) return true;
        }
        return false;
    })()";
    assert_eq!(browser.evaluate(rest), Ok(json!(true)), "nothing is drawn at rest");
    // What moves is drawn coarsely in software, as the first frame is, and finely afterwards.
    let fine = "(async () => {
        const { player } = chiaro;
        for (let turn = 0; turn < 400; turn++) {
            const isFine = player.canvas.width === player.pageSize[0];
            if (isFine && Number.isFinite(player.slowness)) return player.slowness;
            await new Promise((resolve) => setTimeout(resolve, 25));
        }
    })()";
    let slowness = browser.evaluate(fine).expect("a time");
    assert!(slowness.as_f64().is_some_and(|time| time > 0.0), "a fine frame: {slowness}");
}

/// A value of the wrong form is refused in words, and changes nothing; one that is as in the look
/// counts as none.
#[test]
fn wrong_values_are_refused() {
    let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
    let trial = Trial::of("looks/highlight-moves");
    open(&mut browser, &trial.package("web"), APIS[1]);
    let wrong = [
        ("chiaro.set('move_x', NaN)", "move_x is a number"),
        ("chiaro.set('move_x', '0.5')", "move_x is a number"),
        ("chiaro.set('move_x', null)", "move_x is a number"),
        ("chiaro.set('color', 'red')", "#rrggbb"),
        ("chiaro.set('color', [1, 0])", "three or four numbers"),
        ("chiaro.light('key', { colour: [1, 0, 0] })", "it has: direction"),
        ("chiaro.light('key', { direction: [0, 0, 0] })", "not all 0"),
        ("chiaro.light('key', { intensity: Infinity })", "a number from 0"),
        ("chiaro.wear({ positions: [1, 2] })", "three for every vertex"),
        ("chiaro.open(document.createElement('canvas'), { look: 1 })", "not that of an export"),
    ];
    for (script, words) in wrong {
        let refused = browser.evaluate(script).expect_err(script);
        assert!(refused.contains(words), "{script}: {refused}");
    }
    assert_eq!(browser.evaluate("chiaro.player.isUntouched"), Ok(json!(true)));
    let short = "chiaro.set('color', '#F00'); chiaro.get('color')";
    assert_eq!(browser.evaluate(short), Ok(json!("#ff0000")));
    let same = "chiaro.set('color', chiaro.player.parameter('color').default);
        chiaro.player.isUntouched";
    assert_eq!(browser.evaluate(same), Ok(json!(true)));
}

/// A canvas by `chiaro.open` alone is reached by keys and not scrolled by a drag; the page's link
/// has what was changed; a device that is lost at once is replaced by WebGL 2.
#[test]
fn a_canvas_of_ones_own_a_link_and_a_lost_device() {
    let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
    let trial = Trial::of("looks/highlight-moves");
    let package = trial.package("web");
    open(&mut browser, &package, APIS[1]);
    let own = "(async () => {
        const canvas = document.createElement('canvas');
        canvas.style.cssText = 'width: 64px; height: 64px';
        document.body.append(canvas);
        const content = Object.values(chiaroExports)[0];
        const player = await chiaro.open(canvas, content, { api: 'WebGL2', wheel: 'ctrl' });
        const found = [canvas.style.touchAction, canvas.tabIndex, canvas.getAttribute('role')];
        const wheel = new WheelEvent('wheel', { deltaY: 100, cancelable: true });
        canvas.dispatchEvent(wheel);
        player.close();
        canvas.remove();
        return [...found, wheel.defaultPrevented];
    })()";
    assert_eq!(browser.evaluate(own), Ok(json!(["none", 0, "application", false])));
    let link = "chiaro.set('move_x', 0.25);
        chiaro.light('key', { intensity: 0.5 });
        document.querySelector('.link').click();
        location.hash";
    let link = browser.evaluate(link).expect("a link");
    // Another address but for what follows #, or the browser would not load the page anew.
    let ending = format!("?api=webgl2&panel=1{}", link.as_str().expect("a link"));
    browser.open_file_with(&package.join("index.html"), &ending).expect("the page opens");
    let set = "chiaro.ready.then((player) =>
        [player.get('move_x'), player.lightNow('key').intensity])";
    assert_eq!(browser.evaluate(set), Ok(json!([0.25, 0.5])));
    // No API is asked for here, so that another may follow.
    browser.open_file_with(&package.join("index.html"), "?panel=0").expect("the page opens");
    let lost = "chiaro.ready.then(async (player) => {
        if (player.api !== 'WebGPU') return player.failures;
        const turned = new Promise((then) => player.addEventListener('api', then));
        player.executor.device.destroy();
        await turned;
        return [player.api, player.canvas === document.getElementById('picture')];
    })";
    assert_eq!(browser.evaluate(lost), Ok(json!(["WebGL 2", true])));
    let told = "document.getElementById('problem').hidden
        && document.getElementById('api').textContent";
    assert_eq!(browser.evaluate(told), Ok(json!("WebGL 2")));
}

/// A page that was exported by the last release is drawn by the browsers of today, as this release
/// draws the same look. With a release the folder is exported anew.
#[test]
fn a_page_of_the_last_release_still_runs() {
    let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
    let kept = root().join("tests/packages/last_release");
    let look = Trial::of("../tests/packages/last_release/highlight-moves");
    let ours = look.with(&["--mesh", "shape:ball"]).ours();
    let mut measured = BTreeMap::new();
    for api in APIS {
        open(&mut browser, &kept.join("page"), api);
        let found = Difference::of(&picture(&mut browser), &ours);
        measured.insert(format!("web {} last-release", api.0), found);
    }
    table::check(&measured);
}

/// All example looks, images and painted surfaces that are exported.
#[test]
#[ignore = "minutes: scripts/soak runs it"]
fn soak_pages_of_all_examples_show_what_we_show() {
    let mut all = Vec::from(changed_looks());
    all.extend(soak_trials("web", |trial| trial));
    // A few at a time, each with a browser of its own, which collects much in hours.
    for trials in all.chunks(8) {
        let Some(mut browser) = Chromium::start().expect("Chromium") else { return };
        compare(&mut browser, trials);
    }
}
