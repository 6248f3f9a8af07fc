//! Checks of a document without the library: whether wires, frames, keys and parameters name
//! existing parts.
//!
//! The compiler calls [`Look::check`] too, so that looks made by programs pass the same checks.

use std::collections::{HashMap, HashSet};
use std::hash::Hash;

use chiaro_locale::{text, tr};

use super::{
    Camera, Definition, Endpoint, Graph, Light, LightField, LightKind, Look, OutputPort, Override,
    Scene, Shot, Target, Wire,
};
use crate::diag::{Diagnostic, MAX_PROBLEMS, more_problems};
use crate::ids::{DefinitionId, GROUP_INPUTS, GROUP_OUTPUTS, LightId, NodeId, NodePath};

/// Greatest number of broken references that get a suggestion: looking for near names in 100,000
/// takes its time.
const MAX_SUGGESTIONS: usize = 10;

impl Look {
    /// All problems of the look as a whole, whatever the library has: wires from and to nodes that
    /// do not exist, two wires into one input, ids used twice, keys and parameters that name
    /// nothing. Reading a look reports the same, with lines.
    pub fn check(&self) -> Vec<Diagnostic> {
        let mut check = Check::default();
        check.lights(&self.lights);
        check.graph(&self.graph, "", false);
        for (id, definition) in &self.definitions {
            check.definition(id, definition);
        }
        check.exposed(self);
        check.aovs(self);
        check.direction_keys(self);
        check.time_keys(self);
        check.finish()
    }
}

impl Scene {
    /// All problems of the scene as a whole. Reading a scene reports the same, with lines.
    pub fn check(&self) -> Vec<Diagnostic> {
        let mut check = Check::default();
        check.lights(&self.lights);
        check.scene_keys(self);
        for (index, object) in self.objects.values().enumerate() {
            let path = |row| format!("objects[{index}].layers[{row}].node");
            check.unique(object.layers.iter().map(|row| &row.node), path, "row");
        }
        check.camera(&self.camera);
        if self.time.end < self.time.start {
            let problem =
                Diagnostic::error("out-of-range", tr!("the time range ends before it starts"));
            check.push(
                "time.end".to_owned(),
                problem.hint(tr!("write {start} or more", start = self.time.start)),
            );
        }
        check.finish()
    }
}

impl Shot {
    /// All problems of the shot as a whole, whatever the scene has. Reading a shot reports the
    /// same, with lines.
    pub fn check(&self) -> Vec<Diagnostic> {
        let mut check = Check::default();
        if let Some([first, last]) = self.frames.filter(|[first, last]| first > last) {
            let message = tr!("the last frame, {last}, comes before the first, {first}");
            let problem = Diagnostic::error("out-of-range", message);
            check.push("frames".to_owned(), problem.hint(tr!("exchange them")));
        }
        if let Some(camera) = &self.camera {
            check.camera(camera);
        }
        let mut seen = HashSet::new();
        for (index, changed) in self.overrides.iter().enumerate() {
            let path = format!("overrides[{index}]");
            if !seen.insert((&changed.look, &changed.target)) {
                let message = tr!("`{address}` is changed twice", address = changed.address());
                let problem = Diagnostic::error("duplicate-id", message);
                check.push(path.clone() + ".target", problem.hint(tr!("leave one of them")));
            }
            check.override_values(changed, &path);
        }
        check.finish()
    }
}

/// Problems of a target.
pub(super) fn check_target(look: &Look, target: &Target) -> Vec<Diagnostic> {
    let mut check = Check::default();
    check.target(look, target, String::new());
    check.finish()
}

/// Problems of an output that drives keys.
pub(super) fn check_output(look: &Look, output: &OutputPort) -> Vec<Diagnostic> {
    let mut check = Check::default();
    check.node_at(look, &output.node, String::new());
    check.finish()
}

#[derive(Default)]
struct Check {
    found: Vec<Diagnostic>,
    suggestions: usize,
    left_out: usize,
    /// True for keys of a scene, which has no nodes.
    is_scene: bool,
}

impl Check {
    fn push(&mut self, path: String, problem: Diagnostic) {
        if self.found.len() < MAX_PROBLEMS {
            self.found.push(problem.json_path(path));
        } else {
            self.left_out += 1;
        }
    }

    fn finish(mut self) -> Vec<Diagnostic> {
        self.found.extend((self.left_out > 0).then(|| more_problems(self.left_out)));
        self.found
    }

    /// Reports a name that does not exist, and suggests near ones.
    fn unknown<'a>(
        &mut self,
        path: String,
        problem: Diagnostic,
        wrong: &str,
        known: impl Iterator<Item = &'a str>,
    ) {
        self.suggestions += 1;
        let problem = if self.suggestions <= MAX_SUGGESTIONS {
            problem.suggest(wrong, known)
        } else {
            problem
        };
        self.push(path, problem);
    }

    fn lights(&mut self, lights: &indexmap::IndexMap<LightId, Light>) {
        for (id, light) in lights {
            if light.kind == LightKind::Point && light.aimed_at.is_some() {
                let message =
                    tr!("the point light `{id}` shines everywhere, so that aiming it does nothing");
                let problem = Diagnostic::warning("idle-aim", message);
                self.push(
                    format!("lights.{id}.aimed_at"),
                    problem.hint(tr!(
                        "make it a spot or a directional light, or leave `aimed_at` out"
                    )),
                );
            }
            for field in LightField::ALL {
                let Some(around) = field.within() else { continue };
                let mut pairs = field.numbers(light).iter().zip(around.numbers(light));
                let Some((number, most)) = pairs.find(|(number, most)| number > most) else {
                    continue;
                };
                let (name, bound) = (field.name(), around.name());
                let message = tr!("`{name}` ({number}) is greater than `{bound}` ({most})");
                // A spot light's cones are the only pair.
                let hint = tr!("the full cone lies inside the whole cone");
                let problem = Diagnostic::error("out-of-range", message).hint(hint);
                self.push(format!("lights.{id}.{name}"), problem);
            }
        }
    }

    fn override_values(&mut self, changed: &Override, path: &str) {
        let address = changed.address();
        match (&changed.value, changed.keys.is_empty()) {
            (None, true) => {
                let message = tr!("`{address}` is changed to nothing");
                let problem = Diagnostic::error("missing-field", message);
                let hint =
                    text!("write \"value\", or \"keys\": [{\"frame\": 1, \"value\": ...}, ...]")
                        .tr();
                self.push(path.to_owned(), problem.hint(hint));
            }
            (Some(_), false) => {
                let message = tr!("`{address}` has a value and keys");
                let problem = Diagnostic::error("two-values", message);
                self.push(format!("{path}.value"), problem.hint(tr!("leave one of them out")));
            }
            (Some(_), true) if changed.step > 1 => {
                let message = tr!("`{address}` is set, and so has nothing to hold");
                let problem = Diagnostic::warning("idle-step", message);
                self.push(
                    format!("{path}.step"),
                    problem.hint(tr!("leave `step` out, or write keys")),
                );
            }
            _ => {}
        }
        let pairs = changed.keys.windows(2).enumerate();
        for (key, pair) in pairs.filter(|(_, pair)| pair[0].frame >= pair[1].frame) {
            let (one, two) = (pair[0].frame, pair[1].frame);
            let message = tr!("frames must increase, but {two} follows {one}");
            let problem = Diagnostic::error("not-increasing", message);
            self.push(
                format!("{path}.keys[{}].frame", key + 1),
                problem.hint(tr!("sort the keys, and remove doubles")),
            );
        }
    }

    /// Keys of a scene move its lights alone.
    fn scene_keys(&mut self, scene: &Scene) {
        if let Some(keyed) = scene.keyed_lights() {
            self.is_scene = true;
            self.direction_keys(&keyed);
            self.time_keys(&keyed);
            self.is_scene = false;
        }
    }

    fn camera(&mut self, camera: &Camera) {
        let view = [0, 1, 2].map(|i| camera.target[i] - camera.eye[i]);
        let [up_x, up_y, up_z] = camera.up;
        let side = [
            view[1] * up_z - view[2] * up_y,
            view[2] * up_x - view[0] * up_z,
            view[0] * up_y - view[1] * up_x,
        ];
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        // These comparisons fail for NaN, too, which a program may have made.
        let sees = length(view) > 1e-9;
        let stands = length(side) > 1e-6 * length(view) * length(camera.up);
        if !sees {
            let problem =
                Diagnostic::error("bad-camera", tr!("the camera looks at the place where it is"));
            self.push("camera".to_owned(), problem.hint(tr!("move `eye` or `target`")));
        } else if !stands {
            let message = tr!("`up` lies along the view, so the picture could be turned any way");
            let problem = Diagnostic::error("bad-camera", message);
            self.push("camera.up".to_owned(), problem.hint(tr!("choose an `up` across the view")));
        }
    }

    fn definition(&mut self, id: &DefinitionId, definition: &Definition) {
        let prefix = format!("definitions.{id}.");
        for (list, ports) in [("inputs", &definition.inputs), ("outputs", &definition.outputs)] {
            let path = |index| format!("{prefix}{list}[{index}].name");
            self.unique(ports.iter().map(|port| &port.name), path, tr!("part" => "port"));
            for (index, port) in ports.iter().enumerate() {
                if port.min.zip(port.max).is_some_and(|(min, max)| min > max) {
                    let problem =
                        Diagnostic::error("out-of-range", tr!("`min` is greater than `max`"));
                    self.push(
                        format!("{prefix}{list}[{index}].min"),
                        problem.hint(tr!("exchange them")),
                    );
                }
            }
        }
        self.graph(&definition.graph, &prefix, true);
    }

    fn graph(&mut self, graph: &Graph, prefix: &str, is_inner: bool) {
        for (index, id) in
            graph.nodes.keys().enumerate().filter(|(_, id)| is_inner && is_group_end(id))
        {
            let message = tr!(
                "`{id}` is the name of the group's own {id}, so no node in it can have that id"
            );
            self.push(
                format!("{prefix}nodes[{index}].id"),
                Diagnostic::error("reserved-id", message),
            );
        }
        let mut into: HashMap<&Endpoint, &Wire> = HashMap::with_capacity(graph.wires.len());
        for (index, wire) in graph.wires.iter().enumerate() {
            let path = format!("{prefix}wires[{index}]");
            self.wire_end(graph, &wire.from, path.clone() + ".from", is_inner, GROUP_OUTPUTS);
            self.wire_end(graph, &wire.to, path.clone() + ".to", is_inner, GROUP_INPUTS);
            if wire.to.port.as_str().is_empty() {
                let problem = Diagnostic::error(
                    "wire-to-nothing",
                    tr!("the wire leads to no input of `{to}`", to = wire.to),
                );
                self.push(path.clone() + ".to", problem.hint(tr!("write \"node.input\"")));
            }
            match into.get(&wire.to) {
                Some(other) => {
                    let (one, two) = (&other.from, &wire.from);
                    let message = tr!(
                        "two wires lead into `{to}`: from `{one}` and from `{two}`",
                        to = wire.to
                    );
                    self.push(
                        path,
                        Diagnostic::error("two-wires", message).hint(tr!("remove one of them")),
                    );
                }
                None => drop(into.insert(&wire.to, wire)),
            }
        }
        self.frames(graph, prefix);
        let mut keys = HashSet::new();
        for (index, bookmark) in
            graph.bookmarks.iter().enumerate().filter(|(_, bookmark)| !keys.insert(bookmark.key))
        {
            let problem = Diagnostic::warning(
                "duplicate-id",
                tr!("another bookmark has the key {key}", key = bookmark.key),
            );
            self.push(
                format!("{prefix}bookmarks[{index}].key"),
                problem.hint(tr!("the first one counts; remove this one")),
            );
        }
    }

    fn wire_end(
        &mut self,
        graph: &Graph,
        end: &Endpoint,
        path: String,
        is_inner: bool,
        wrong_end: &str,
    ) {
        if graph.nodes.contains_key(&end.node) {
            return;
        }
        if is_inner && is_group_end(&end.node) {
            if end.node.as_str() == wrong_end {
                let message = tr!("in a group, wires come from `inputs` and lead to `outputs`");
                self.push(
                    path,
                    Diagnostic::error("wire-direction", message)
                        .hint(tr!("exchange the ends of the wire")),
                );
            }
            return;
        }
        let problem = Diagnostic::error(
            "unknown-node",
            tr!("the wire names the node `{node}`, which does not exist", node = end.node),
        );
        self.unknown(path, problem, end.node.as_str(), graph.nodes.keys().map(NodeId::as_str));
    }

    fn frames(&mut self, graph: &Graph, prefix: &str) {
        let mut framed: HashMap<&NodeId, &str> = HashMap::new();
        for (id, frame) in &graph.frames {
            for (index, node) in frame.nodes.iter().enumerate() {
                let path = format!("{prefix}frames.{id}.nodes[{index}]");
                if !graph.nodes.contains_key(node) {
                    let message = tr!("the frame names the node `{node}`, which does not exist");
                    let problem = Diagnostic::warning("unknown-node", message);
                    self.unknown(
                        path,
                        problem,
                        node.as_str(),
                        graph.nodes.keys().map(NodeId::as_str),
                    );
                } else if let Some(other) = framed.insert(node, id.as_str()) {
                    let message = tr!("the node `{node}` is in the frame `{other}` already");
                    self.push(
                        path,
                        Diagnostic::warning("two-frames", message)
                            .hint(tr!("leave it in one of them")),
                    );
                }
            }
        }
    }

    fn unique<'a, T: Hash + Eq + std::fmt::Display + 'a>(
        &mut self,
        names: impl Iterator<Item = &'a T>,
        path: impl Fn(usize) -> String,
        what: &str,
    ) {
        let mut seen = HashSet::new();
        for (index, name) in
            names.enumerate().filter(|(_, name)| !seen.insert(*name)).collect::<Vec<_>>()
        {
            let problem =
                Diagnostic::error("duplicate-id", tr!("another {what} is named `{name}` already"));
            self.push(path(index), problem.hint(tr!("give it another name")));
        }
    }

    fn exposed(&mut self, look: &Look) {
        self.unique(
            look.exposed.iter().map(|e| &e.name),
            |index| format!("exposed[{index}].name"),
            tr!("part" => "parameter"),
        );
        for (index, exposed) in look.exposed.iter().enumerate() {
            self.target(look, &exposed.target, format!("exposed[{index}].target"));
        }
    }

    fn aovs(&mut self, look: &Look) {
        self.unique(
            look.aovs.iter().map(|aov| &aov.name),
            |index| format!("aovs[{index}].name"),
            tr!("part" => "output"),
        );
        for (index, aov) in look.aovs.iter().enumerate() {
            self.node_at(look, &aov.from.node, format!("aovs[{index}].from"));
        }
    }

    fn direction_keys(&mut self, look: &Look) {
        for (index, keys) in look.direction_keys.iter().enumerate() {
            let path = format!("direction_keys[{index}]");
            for light in
                keys.by.lights().into_iter().filter(|light| !look.lights.contains_key(*light))
            {
                let problem =
                    Diagnostic::error("unknown-light", tr!("there is no light `{light}`"));
                self.unknown(
                    path.clone() + ".by",
                    problem,
                    light.as_str(),
                    look.lights.keys().map(LightId::as_str),
                );
            }
            for output in keys.by.outputs() {
                self.node_at(look, &output.node, path.clone() + ".by");
            }
            // Each target is checked once, not once a key.
            let mut seen = HashSet::new();
            for (index, key) in keys.keys.iter().enumerate() {
                for target in
                    key.values.keys().filter(|&target| seen.insert(target)).collect::<Vec<_>>()
                {
                    let name = serde_json::Value::from(target.to_string());
                    self.target(look, target, format!("{path}.keys[{index}].values[{name}]"));
                }
            }
        }
    }

    fn time_keys(&mut self, look: &Look) {
        let path = |index| format!("time_keys[{index}].target");
        self.unique(
            look.time_keys.iter().map(|keys| &keys.target),
            path,
            tr!("part" => "list of keys"),
        );
        for (index, keys) in look.time_keys.iter().enumerate() {
            self.target(look, &keys.target, path(index));
            for (key, pair) in
                keys.keys.windows(2).enumerate().filter(|(_, pair)| pair[0].time >= pair[1].time)
            {
                let message = tr!(
                    "times must increase, but {later} follows {earlier}",
                    later = pair[1].time,
                    earlier = pair[0].time
                );
                let path = format!("time_keys[{index}].keys[{}].time", key + 1);
                self.push(
                    path,
                    Diagnostic::error("not-increasing", message)
                        .hint(tr!("sort the keys, and remove doubles")),
                );
            }
        }
    }

    fn target(&mut self, look: &Look, target: &Target, path: String) {
        match target {
            Target::Light { light, field } => {
                if !look.lights.contains_key(light) {
                    let problem =
                        Diagnostic::error("unknown-light", tr!("there is no light `{light}`"));
                    self.unknown(
                        path,
                        problem,
                        light.as_str(),
                        look.lights.keys().map(LightId::as_str),
                    );
                } else if LightField::named(field).is_none() {
                    let problem = Diagnostic::error(
                        "bad-target",
                        tr!("a light has no `{field}` that can be set"),
                    );
                    self.unknown(path, problem, field, LightField::names());
                }
            }
            Target::Input { node, .. } => self.node_at(look, node, path),
        }
    }

    fn node_at(&mut self, look: &Look, node: &NodePath, path: String) {
        if self.is_scene {
            let message = tr!("a scene has no nodes, and so no `{node}`: its keys move lights");
            let problem = Diagnostic::error("bad-target", message);
            let hint =
                tr!("write a field of a light of the scene, such as `lights.key.intensity`; \
                        wires and inputs are keyed in their look");
            self.push(path, problem.hint(hint));
            return;
        }
        let mut graph = &look.graph;
        for (depth, id) in node.ids().iter().enumerate() {
            let Some(found) = graph.nodes.get(id) else {
                let problem = Diagnostic::error("unknown-node", tr!("there is no node `{id}`"));
                self.unknown(path, problem, id.as_str(), graph.nodes.keys().map(NodeId::as_str));
                return;
            };
            match look.definitions.get(found.kind.as_str()) {
                Some(definition) => graph = &definition.graph,
                // A group of the library, or no group: the compiler knows.
                None if depth + 1 < node.ids().len() => return,
                None => {}
            }
        }
    }
}

fn is_group_end(id: &NodeId) -> bool {
    matches!(id.as_str(), GROUP_INPUTS | GROUP_OUTPUTS)
}
