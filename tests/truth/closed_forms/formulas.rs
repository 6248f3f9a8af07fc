//! A look as a stack of layers: from the JSON of a document to a pixel's color, by the paper's
//! formulas.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DMat3, DVec3, DVec4};
use serde_json::Value as Json;

use super::surfaces::Point;
use crate::support::badf::{self, Mode};

/// A base and the layers over it, in order.
pub(crate) struct Stack {
    base: DVec4,
    layers: Vec<Layer>,
}

struct Layer {
    light: DVec3,
    is_specular: bool,
    /// Offset, fall-off, cut-off.
    profile: [f64; 3],
    convex: DVec4,
    concave: DVec4,
    slope: f64,
    amount: f64,
    mode: Mode,
    /// Mean and standard deviation of the profile's soft edge.
    edge: [f64; 2],
}

type Values = BTreeMap<String, Json>;

impl Stack {
    /// Reads a look as a stack: a base, then light layers in their order. Direction keys (at most
    /// one set, of two keys by a light) are blended; their directions are in camera axes.
    pub(crate) fn read(look: &Json, camera_from_world: DMat3) -> Self {
        let nodes = look["nodes"].as_array().expect("nodes");
        let base = vec4(&nodes[0]["values"]["color"]);
        let light = |id: &str| vec3(&look["lights"][id]["direction"]).normalize();
        let keyed = look
            .get("direction_keys")
            .map(|keys| WeightedKeys::new(&keys[0], &light, camera_from_world));
        let layers = nodes.iter().filter(|node| node["kind"] == "light_layer").map(|node| {
            let own: Values = serde_json::from_value(node["values"].clone()).expect("values");
            let id = node["id"].as_str().expect("an id");
            Layer::new(&keyed.as_ref().map_or(own.clone(), |keyed| keyed.values(id, &own)), &light)
        });
        Self { base, layers: layers.collect() }
    }

    /// The straight color of one of a quad's pixels.
    pub(crate) fn color(&self, quad: &[Point; 4], own: usize) -> DVec4 {
        let below = badf::premultiplied(self.base);
        let laid = self.layers.iter().fold(below, |below, layer| {
            let (color, tone) = layer.at(quad, own);
            badf::blend(layer.mode, below, color, tone, 1.0, true)
        });
        badf::straight(laid)
    }
}

impl Layer {
    fn new(values: &Values, light: &dyn Fn(&str) -> DVec3) -> Self {
        let number = |name: &str, otherwise| {
            values.get(name).map_or(otherwise, |x| x.as_f64().expect("a number"))
        };
        let word = |name: &str| values.get(name).and_then(Json::as_str).unwrap_or_default();
        let profile =
            [number("offset", 0.0), number("falloff", FRAC_PI_2), number("cutoff", FRAC_PI_2)];
        Self {
            light: light(word("light")),
            is_specular: word("type") == "specular",
            profile,
            convex: vec4(&values["convex"]),
            concave: vec4(&values["concave"]),
            slope: number("slope", 0.0),
            amount: number("amount", 0.0),
            mode: if word("blend") == "alpha" { Mode::Alpha } else { Mode::Add },
            edge: edge(profile),
        }
    }

    /// Color and tone of a layer at one of a quad's pixels: BADF eq. 3 to 8.
    fn at(&self, quad: &[Point; 4], own: usize) -> (DVec4, f64) {
        let angles = quad.map(|point| self.warped_angle(&point));
        let tone = self.filtered(angles[own], footprint(angles, own));
        let lambda = badf::lambda(quad[own].kappa, self.slope);
        (self.concave * (1.0 - lambda) + self.convex * lambda, tone)
    }

    fn warped_angle(&self, point: &Point) -> f64 {
        let direction =
            if self.is_specular { badf::mirrored(point.normal, point.view) } else { point.normal };
        let u = badf::angle(direction, self.light);
        let shift = badf::warp(badf::lambda(point.kappa, self.slope), self.amount);
        (u - shift).clamp(0.0, PI)
    }

    /// alpha filtered over a footprint (docs/math.md 2.4): a ramp where the edge is narrower than
    /// the footprint, three points where it is not much wider.
    fn filtered(&self, u: f64, width: f64) -> f64 {
        let alpha = |u: f64| badf::alpha(u.clamp(0.0, PI), 0.0, self.profile);
        let [mean, deviation] = self.edge;
        if width <= 0.0 || self.profile[0] >= PI - 1e-5 || (width < 0.1 * deviation) {
            return alpha(u);
        }
        if width >= 12.0_f64.sqrt() * deviation {
            let ramp = (width * width + 12.0 * deviation * deviation).sqrt();
            return (0.5 + (self.profile[0] + mean - u) / ramp).clamp(0.0, 1.0);
        }
        let reach = 0.15_f64.sqrt() * width;
        (5.0 * alpha(u - reach) + 8.0 * alpha(u) + 5.0 * alpha(u + reach)) / 18.0
    }
}

/// |grad u| from the quad's differences, at most 0.5. A difference is measured by its chord, 4
/// sin(du / 4), as in the library. In radians per pixel.
fn footprint(angles: [f64; 4], own: usize) -> f64 {
    let chord = |a: usize, b: usize| 4.0 * (0.25 * (angles[b] - angles[a])).sin();
    chord(own & 2, own | 1).hypot(chord(own & 1, own | 2)).min(0.5)
}

/// Mean and standard deviation of -eta', by parts, and by the trapezoid rule of 64 steps: the
/// library's definition, because the choice of a filter depends on it.
fn edge(profile: [f64; 3]) -> [f64; 2] {
    let [tau, f, c] = badf::sanitized(profile);
    if tau >= PI - 1e-5 || f <= tau || c <= tau {
        return [0.0; 2];
    }
    let step = (c - tau) / 64.0;
    let (mut area, mut moment) = (0.5 * step, 0.0);
    for index in 1..64 {
        let x = f64::from(index) * step;
        let eta = badf::alpha(tau + x, 0.0, profile);
        area += eta * step;
        moment += x * eta * step;
    }
    [area, (2.0 * moment - area * area).max(0.0).sqrt()]
}

/// Two keys of directions with their weights.
struct WeightedKeys {
    weights: [f64; 2],
    /// Values of each key by target, `node.port`.
    values: [Values; 2],
}

impl WeightedKeys {
    fn new(keys: &Json, light: &dyn Fn(&str) -> DVec3, camera_from_world: DMat3) -> Self {
        let places = [0, 1].map(|k| vec3(&keys["keys"][k]["direction"]).normalize());
        let direction =
            camera_from_world * light(keys["by"]["light"].as_str().expect("by a light"));
        let values = [0, 1]
            .map(|k| serde_json::from_value(keys["keys"][k]["values"].clone()).expect("values"));
        Self { weights: weights(places, direction), values }
    }

    /// Values of a layer under the keys' weights; a value that a key does not name is the layer's
    /// own.
    fn values(&self, node: &str, own: &Values) -> Values {
        let at_key = |key: usize| {
            let named = self.values[key].iter().filter_map(|(target, value)| {
                Some((target.strip_prefix(&format!("{node}."))?.to_owned(), value.clone()))
            });
            let mut values = own.clone();
            values.extend(named);
            values
        };
        let (first, second) = (at_key(0), at_key(1));
        first.iter().map(|(name, value)| (name.clone(), self.mix(value, &second[name]))).collect()
    }

    fn mix(&self, a: &Json, b: &Json) -> Json {
        let mix = |a: &Json, b: &Json| {
            self.weights[0] * a.as_f64().expect("a number")
                + self.weights[1] * b.as_f64().expect("a number")
        };
        match (a, b) {
            (Json::Number(_), Json::Number(_)) => mix(a, b).into(),
            (Json::Array(a), Json::Array(b)) => a.iter().zip(b).map(|(a, b)| mix(a, b)).collect(),
            _ => a.clone(),
        }
    }
}

/// Weights of two keys (BADF eq. 9, docs/math.md 5): with equations for both keys and weights of
/// sum 1, the biharmonic form w = a + c (K(y1) - K(y2)) has a = 1/2 and c = 1 / (2 (K(0) -
/// K(y12))).
fn weights(places: [DVec3; 2], direction: DVec3) -> [f64; 2] {
    let between = |a: DVec3, b: DVec3| kernel(0.25 * (a - b).length_squared());
    let slope = 0.5 / (kernel(0.0) - between(places[0], places[1]));
    let first = 0.5 + slope * (between(direction, places[0]) - between(direction, places[1]));
    let smooth = |w: f64| {
        let w = w.clamp(0.0, 1.0);
        w * w * (3.0 - 2.0 * w)
    };
    let smoothed = [smooth(first), smooth(1.0 - first)];
    smoothed.map(|w| w / (smoothed[0] + smoothed[1]))
}

/// The kernel K(y) = -ln y ln(1 - y) - Li2(y), which by Euler's reflection is Li2(1 - y) - pi^2 /
/// 6; the series converges for directions that are no keys.
fn kernel(y: f64) -> f64 {
    let z = 1.0 - y;
    if z >= 1.0 {
        return 0.0;
    }
    let terms = (1..4000).map(|n| z.powi(n) / f64::from(n * n));
    terms.take_while(|term| *term > 1e-18).sum::<f64>() - PI * PI / 6.0
}

fn vec3(json: &Json) -> DVec3 {
    DVec3::from_array(serde_json::from_value(json.clone()).expect("three numbers"))
}

/// Straight RGBA of JSON, opaque where alpha is missing.
fn vec4(json: &Json) -> DVec4 {
    let numbers: Vec<f64> = serde_json::from_value(json.clone()).expect("numbers");
    DVec4::new(numbers[0], numbers[1], numbers[2], numbers.get(3).copied().unwrap_or(1.0))
}
