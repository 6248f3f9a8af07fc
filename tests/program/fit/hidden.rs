//! Hidden looks, and the distance of fitted looks from them on a view that was not painted.

use std::path::PathBuf;
use std::sync::Mutex;

use chiaro::compile::Live;
use chiaro::document::Look;
use chiaro::fit::FitTarget;
use chiaro::frame::{Assets, PlanOptions, Planner, Setup, SetupLook, default_setup};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules, ReferencePicture};
use serde_json::{Value, json};

use crate::support::random::Random;

/// Meshes that looks are hidden on, in turns: round all over, folded, and a figure.
pub(crate) const MESHES: [&str; 3] = ["shape:sphere", "shape:knot", "shape:creature"];
/// Side of the pictures, in pixels.
pub(crate) const SIDE: u32 = 64;
/// Turn of the camera to the new view: to the right, then up, in radians.
const TURN: [f64; 2] = [0.6, 0.25];
/// A layer counts as seen if it changes at least this share of the figure's pixels by at least this
/// much.
const SEEN: (f64, f64) = (0.02, 8.0 / 255.0);

/// A hidden look, with the layers that it was made of.
pub(crate) struct HiddenLook {
    pub(crate) look: Look,
    pub(crate) layers: usize,
    pub(crate) mesh: &'static str,
    /// Description of the look as a list of layers, for messages.
    pub(crate) told: Vec<Value>,
}

/// Hidden look number `number`: one to three layers of light, each of which is seen.
pub(crate) fn hidden(number: u64) -> HiddenLook {
    let mesh = MESHES[number as usize % MESHES.len()];
    let mut random = Random::new(0x0f17 + 7919 * number);
    let layers = 1 + random.index(3);
    loop {
        let base: Vec<f64> = (0..3).map(|_| random.between(0.05, 0.45)).collect();
        let told: Vec<Value> = (0..layers).map(|_| layer(&mut random)).collect();
        let look = look_of(&base, &told);
        let whole = picture(&setup_of(look.clone(), mesh));
        let is_seen = |without: usize| {
            let mut rest = told.clone();
            rest.remove(without);
            let (changed, all) = changed(&whole, &picture(&setup_of(look_of(&base, &rest), mesh)));
            changed as f64 >= SEEN.0 * all as f64
        };
        if (0..layers).all(is_seen) {
            return HiddenLook { look, layers, mesh, told };
        }
    }
}

fn layer(random: &mut Random) -> Value {
    // The direction lights a visible part of the object: the eye is at +z.
    let direction = loop {
        let v = [random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-0.4, 1.0)];
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.2..=1.0).contains(&length) {
            break v.map(|x| x / length);
        }
    };
    let is_specular = random.chance(0.5);
    let offset = random.between(0.0, if is_specular { 0.5 } else { 0.9 });
    let width = random.between(0.08, 1.1);
    let falloff = offset + width * random.between(0.3, 1.0);
    let color: Vec<f64> = (0..3).map(|_| random.between(0.0, 1.0)).collect();
    json!({
        "direction": direction, "type": if is_specular { "specular" } else { "diffuse" },
        "offset": offset, "falloff": falloff, "cutoff": offset + width, "convex": color,
        "blend": if random.chance(0.5) { "alpha" } else { "add" },
    })
}

fn look_of(base: &[f64], layers: &[Value]) -> Look {
    let mut nodes = vec![json!({"id": "base", "kind": "base", "values": {"color": base}})];
    let (mut lights, mut wires, mut below) = (json!({}), Vec::new(), "base".to_owned());
    for (index, layer) in layers.iter().enumerate() {
        let (id, light) = (format!("layer{index}"), format!("light{index}"));
        lights[&light] = json!({"direction": layer["direction"]});
        let mut values = layer.clone();
        values["light"] = json!(light);
        values.as_object_mut().unwrap().remove("direction");
        nodes.push(json!({"id": id, "kind": "light_layer", "values": values}));
        wires.push(json!({"from": format!("{below}.below"), "to": format!("{id}.below")}));
        below = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": format!("{below}.below"), "to": "output.color"}));
    let text =
        json!({"chiaro": "look", "version": 1, "lights": lights, "nodes": nodes, "wires": wires})
            .to_string();
    let loaded = Look::read(&text, "hidden.json");
    loaded.value.unwrap_or_else(|| panic!("{:?}", loaded.diagnostics))
}

/// The setup of a look on a mesh.
pub(crate) fn setup_of(look: Look, mesh: &str) -> Setup {
    let source = Look::read("{}", "hidden.json").source.into();
    let look = SetupLook { look, source, folder: PathBuf::new() };
    // Meshes are made once, and shared by all tests.
    static ASSETS: Mutex<Option<Assets>> = Mutex::new(None);
    let mut assets = ASSETS.lock().unwrap();
    default_setup(look, mesh, assets.get_or_insert_default()).unwrap().value
}

/// The picture of a setup in f64.
pub(crate) fn picture(setup: &Setup) -> ReferencePicture {
    let options = PlanOptions { size: [SIDE; 2], samples: 1, time: 0.0 };
    let plan = Planner::new(Assets::default())
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap()
        .value;
    let modules = Modules::new(&plan, Precision::F64).unwrap();
    reference::execute(&plan, &modules, &reference::ReferenceOptions::default(), &Progress::new())
        .unwrap()
}

/// Number of the figure's pixels that differ visibly, and number of all its pixels.
fn changed(a: &ReferencePicture, b: &ReferencePicture) -> (usize, usize) {
    let (mut changed, mut all) = (0, 0);
    for index in 0..a.coverage.len() {
        let pixel =
            |picture: &ReferencePicture| picture.color.values[4 * index..4 * index + 3].to_vec();
        if a.coverage[index].draw.is_some() {
            all += 1;
            let differs = pixel(a).iter().zip(pixel(b)).any(|(a, b)| (a - b).abs() > SEEN.1);
            changed += usize::from(differs);
        }
    }
    (changed, all)
}

/// Target of a painter who copies the whole picture: the figure's pixels in eight bits a channel.
pub(crate) fn painted(look: &Look, mesh: &str) -> FitTarget {
    let picture = picture(&setup_of(look.clone(), mesh));
    let mut rgba = picture.to_picture().to_rgba8();
    for (texel, coverage) in rgba.chunks_exact_mut(4).zip(&picture.coverage) {
        texel[3] = if coverage.draw.is_some() { 255 } else { 0 };
    }
    FitTarget::from_rgba8(picture.size, &rgba)
}

/// RMS difference of a channel on the figure, seen from the new view.
pub(crate) fn difference(a: &Look, b: &Look, mesh: &str) -> f64 {
    let [a, b] = [a, b].map(|look| {
        let mut setup = setup_of(look.clone(), mesh);
        setup.turn_camera(TURN);
        picture(&setup)
    });
    let (mut sum, mut count) = (0.0, 0);
    for index in (0..a.coverage.len()).filter(|&index| a.coverage[index].draw.is_some()) {
        for channel in 0..3 {
            sum +=
                (a.color.values[4 * index + channel] - b.color.values[4 * index + channel]).powi(2);
            count += 1;
        }
    }
    (sum / f64::from(count)).sqrt()
}
