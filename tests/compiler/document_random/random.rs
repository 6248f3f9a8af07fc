//! Random documents and edits from a seed; a small size makes small documents.

use std::collections::HashSet;

use chiaro_compiler::document::{
    Bookmark, Camera, ColorSpace, Curve, Definition, DirectionKey, DirectionKeys, Endpoint,
    ExposedValue, Extrapolation, FileCamera, Frame, Graph, GroupMaster, HandlePair, InterfacePort,
    Interpolation, KeyDirection, KeyScheme, LayerLink, Light, LightField, LightKind, LightQuantity,
    LightSet, LightSpace, Look, Marker, MeshAnimation, NamedAov, Node, NodeLinks, Note, Object,
    ObjectSet, OutputPort, Override, Projection, Ramp, RampStop, Scene, SceneOutlines, Shot,
    ShotKey, ShotMarker, Target, Tier, TimeInterpolation, TimeKey, TimeKeys, TimeRange, Transform,
    UnknownFields, Value, Values, Wire,
};
use chiaro_language::ids::{LightId, NodeId, NodePath, PortName};
use serde_json::json;

use crate::support;

/// Random numbers, and a size that bounds texts, lists and depths.
pub(crate) struct Random {
    numbers: support::random::Random,
    size: usize,
}

impl Random {
    pub(crate) fn new(seed: u64, size: usize) -> Self {
        Self { numbers: support::random::Random::new(seed), size }
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.numbers.bits()
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.numbers.index(count)
    }

    pub(crate) fn chance(&mut self, in_ten: usize) -> bool {
        self.below(10) < in_ten
    }

    pub(crate) fn pick<'a, T>(&mut self, from: &'a [T]) -> Option<&'a T> {
        (!from.is_empty()).then(|| &from[self.below(from.len())])
    }

    fn choose<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    fn count(&mut self) -> usize {
        let size = self.size;
        self.below(size + 1)
    }

    /// A number of any magnitude up to `bound`: round and tiny numbers, both zeros, and numbers of
    /// full 53 bits.
    fn number(&mut self, bound: f64) -> f64 {
        let unit = self.bits() as f64 / u64::MAX as f64;
        let number = match self.below(8) {
            0 => 0.0,
            1 => -0.0,
            2 => self.below(10) as f64,
            3 => unit * 1e-300,
            4 => f64::MIN_POSITIVE / 8.0,
            5 => -unit * bound,
            6 => bound,
            _ => unit * bound.min(10.0),
        };
        number.clamp(-bound, bound)
    }

    fn positive(&mut self, bound: f64) -> f64 {
        self.number(bound).abs()
    }

    fn numbers<const N: usize>(&mut self, bound: f64) -> [f64; N] {
        std::array::from_fn(|_| self.number(bound))
    }

    fn direction(&mut self) -> [f64; 3] {
        let mut direction = self.numbers::<3>(1e6);
        direction[self.below(3)] = 1.0 + self.positive(9.0);
        direction
    }

    pub(crate) fn slug(&mut self) -> String {
        let mut slug = String::from(self.choose(&["a", "b", "_", "Node", "x-y"]));
        slug.push_str(&self.below(40).to_string());
        slug
    }

    fn port(&mut self) -> PortName {
        PortName::from(self.choose(&["below", "offset", "color", "light", "p_1"]))
    }

    fn text(&mut self) -> String {
        let pieces = [
            "",
            "Rim",
            "光",
            "\"quoted\"",
            "back\\slash",
            "\n\t\r\0\u{7f}\u{1f}",
            "/",
            "🙂",
            "\u{2028}",
            " ",
        ];
        (0..self.below(4)).map(|_| self.choose(&pieces)).collect()
    }

    fn maybe_text(&mut self) -> Option<String> {
        self.chance(3).then(|| self.text())
    }

    fn json(&mut self, depth: usize) -> serde_json::Value {
        match self.below(if depth == 0 { 6 } else { 8 }) {
            0 => json!(null),
            1 => json!(self.chance(5)),
            2 => json!(self.bits()),
            3 => json!(-(self.below(1000) as i64) - 1),
            4 => json!(self.number(1e300)),
            5 => json!(self.text()),
            6 => (0..self.below(3)).map(|_| self.json(depth - 1)).collect(),
            _ => (0..self.below(3))
                .map(|i| (format!("{}{i}", self.text()), self.json(depth - 1)))
                .collect::<UnknownFields>()
                .into(),
        }
    }

    fn unknown(&mut self) -> UnknownFields {
        if !self.chance(2) {
            return UnknownFields::new();
        }
        (0..1 + self.below(2)).map(|i| (format!("x_{i} {}", self.text()), self.json(2))).collect()
    }

    /// Adds unknown fields to the parts of a field, as documents keep them.
    fn shadows<'a>(
        &mut self,
        into: &mut UnknownFields,
        field: &str,
        parts: impl Iterator<Item = String> + 'a,
    ) {
        for part in parts {
            let extras = self.unknown();
            if !extras.is_empty() {
                let of_field = into.entry(field).or_insert_with(|| json!({}));
                of_field.as_object_mut().unwrap().insert(part, extras.into());
            }
        }
    }

    fn places(&mut self) -> Vec<f64> {
        let mut places: Vec<f64> = (0..1 + self.below(6)).map(|_| self.number(1e30)).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| a <= b);
        places
    }

    fn interpolation(&mut self) -> Interpolation {
        self.choose(&[Interpolation::Linear, Interpolation::Smooth, Interpolation::Stepped])
    }

    fn time_interpolation(&mut self) -> TimeInterpolation {
        use TimeInterpolation::{Bezier, Linear, Smooth, Stepped};
        self.choose(&[Linear, Smooth, Stepped, Bezier])
    }

    fn extrapolation(&mut self) -> Extrapolation {
        use Extrapolation::{Cycle, CycleOffset, Hold, Linear, Mirror};
        self.choose(&[Hold, Linear, Cycle, CycleOffset, Mirror])
    }

    fn handles(&mut self) -> Vec<[f64; 2]> {
        (0..self.below(4)).map(|_| self.numbers(1e3)).collect()
    }

    pub(crate) fn markers(&mut self) -> Vec<Marker> {
        let marker =
            |r: &mut Self| Marker { time: r.number(1e6), name: r.text(), unknown: r.unknown() };
        (0..self.below(3)).map(|_| marker(self)).collect()
    }

    pub(crate) fn value(&mut self) -> Value {
        match self.below(6) {
            0 => Value::Bool(self.chance(5)),
            1 => Value::Number(self.number(3e38)),
            2 => Value::Vector((0..1 + self.below(16)).map(|_| self.number(3e38)).collect()),
            3 => Value::Text(self.text()),
            4 => {
                let points = self.places().into_iter().map(|x| [x, self.number(1e10)]).collect();
                Value::Curve(Curve { points, interpolation: self.interpolation() })
            }
            _ => {
                let color = |r: &mut Self| (0..3 + r.below(2)).map(|_| r.number(10.0)).collect();
                let stops = self
                    .places()
                    .into_iter()
                    .map(|at| RampStop { at, color: color(self) })
                    .collect();
                Value::Ramp(Ramp { stops, interpolation: self.interpolation() })
            }
        }
    }

    fn values(&mut self) -> Values {
        (0..self.below(4)).map(|_| (self.port(), self.value())).collect()
    }

    pub(crate) fn light(&mut self) -> Light {
        let mut light = Light {
            name: self.text(),
            kind: self.choose(&[LightKind::Directional, LightKind::Point, LightKind::Spot]),
            groups: (0..self.below(3))
                .map(|_| self.choose(&["set", "rim-2", "_"]).into())
                .collect(),
            space: self.choose(&[LightSpace::Illumination, LightSpace::World, LightSpace::Camera]),
            ..Light::default()
        };
        if light.kind != LightKind::Point && self.chance(3) {
            light.aimed_at = Some(self.slug().into());
        }
        for field in LightField::ALL {
            let numbers = match (field.range(), field.quantity()) {
                (Some([least, most]), _) => {
                    let least = if field.is_above_range() { least + 1e-6 } else { least };
                    [(least + self.positive(most - least)).min(most); 3]
                }
                (None, LightQuantity::Direction) => self.direction(),
                (None, _) => self.numbers(1e6),
            };
            field.set(&mut light, &numbers);
        }
        // Numbers that must lie within another field are moved there.
        for field in LightField::ALL {
            let around = field.within().map(|around| around.numbers(&light).to_vec());
            for (number, most) in
                field.numbers_mut(&mut light).iter_mut().zip(around.iter().flatten())
            {
                *number = number.min(*most);
            }
        }
        light
    }

    pub(crate) fn node(&mut self, kinds: &[String]) -> Node {
        let mut node = Node {
            kind: match self.pick(kinds).cloned() {
                Some(kind) if self.chance(3) => kind,
                _ => self.choose(&["base", "light_layer", "output", "maths/add"]).to_owned(),
            },
            name: self.text(),
            position: self.numbers(1e6),
            values: self.values(),
            tier: self.choose(&[None, Some(Tier::Exact), Some(Tier::Balanced), Some(Tier::Fast)]),
            for_each: self.chance(5).then(|| self.light_set()),
            links: self.node_links(),
            muted: self.chance(5),
            collapsed: self.chance(5),
            unknown: self.unknown(),
        };
        let with_fields =
            |value: &&PortName| matches!(node.values[*value], Value::Curve(_) | Value::Ramp(_));
        let parts: Vec<String> =
            node.values.keys().filter(with_fields).map(ToString::to_string).collect();
        let mut unknown = std::mem::take(&mut node.unknown);
        self.shadows(&mut unknown, "values", parts.into_iter());
        node.unknown = unknown;
        node
    }

    pub(crate) fn frame(&mut self, nodes: Vec<NodeId>) -> Frame {
        let color = if self.chance(5) { Vec::new() } else { self.numbers::<3>(1.0).to_vec() };
        Frame { title: self.text(), color, nodes }
    }

    pub(crate) fn note(&mut self) -> Note {
        let color = if self.chance(5) { Vec::new() } else { self.numbers::<3>(1.0).to_vec() };
        let width = if self.chance(5) { Note::WIDTH } else { 40.0 + self.below(900) as f64 };
        Note { text: self.text(), position: self.numbers::<2>(1000.0), width, color }
    }

    pub(crate) fn bookmarks(&mut self) -> Vec<Bookmark> {
        let count = self.below(4) as u8;
        let bookmark = |key| Bookmark {
            key,
            position: self.numbers::<2>(1000.0),
            zoom: 0.25 + f64::from(key),
        };
        (1..=count).map(bookmark).collect()
    }

    fn graph(&mut self, kinds: &[String], unknown: &mut UnknownFields) -> Graph {
        let mut graph = Graph::default();
        for _ in 0..self.count() {
            graph.nodes.insert(self.slug().into(), self.node(kinds));
        }
        let ids: Vec<NodeId> = graph.nodes.keys().cloned().collect();
        for _ in 0..self.count() {
            if let Some(wire) = self.wire(&ids)
                && graph.wire_into(&wire.to.node, &wire.to.port).is_none()
            {
                graph.wires.push(wire);
            }
        }
        self.shadows(
            unknown,
            "wires",
            graph.wires.iter().map(|wire| wire.to.to_string()).collect::<Vec<_>>().into_iter(),
        );
        for nodes in ids.chunks(3) {
            if self.chance(3) {
                graph.frames.insert(self.slug().into(), self.frame(nodes.to_vec()));
            }
        }
        self.shadows(
            unknown,
            "frames",
            graph.frames.keys().map(ToString::to_string).collect::<Vec<_>>().into_iter(),
        );
        for _ in 0..self.below(3) {
            graph.notes.insert(self.slug().into(), self.note());
        }
        self.shadows(
            unknown,
            "notes",
            graph.notes.keys().map(ToString::to_string).collect::<Vec<_>>().into_iter(),
        );
        graph.bookmarks = self.bookmarks();
        let keys: Vec<String> =
            graph.bookmarks.iter().map(|bookmark| bookmark.key.to_string()).collect();
        self.shadows(unknown, "bookmarks", keys.into_iter());
        graph
    }

    pub(crate) fn wire(&mut self, ids: &[NodeId]) -> Option<Wire> {
        let (from, to) = (self.pick(ids)?.clone(), self.pick(ids)?.clone());
        let out = if self.chance(5) { PortName::default() } else { self.port() };
        Some(Wire { from: Endpoint::new(from, out), to: Endpoint::new(to, self.port()) })
    }

    pub(crate) fn definition(&mut self, kinds: &[String]) -> Definition {
        let mut unknown = self.unknown();
        let inputs = self.interface();
        self.shadows(&mut unknown, "inputs", inputs.iter().map(|port| port.name.to_string()));
        Definition {
            label: self.text(),
            help: self.text(),
            inputs,
            outputs: self.interface(),
            graph: self.graph(kinds, &mut unknown),
            unknown,
        }
    }

    pub(crate) fn interface(&mut self) -> Vec<InterfacePort> {
        let names = ["a", "b", "c"];
        let count = self.below(4);
        let port = |r: &mut Self, name: &str| {
            let min = r.number(1e9);
            InterfacePort {
                name: name.into(),
                label: r.maybe_text(),
                help: r.maybe_text(),
                default: r.chance(5).then(|| r.value()),
                min: r.chance(5).then_some(min),
                max: r.chance(5).then_some(min + r.positive(9.0)),
            }
        };
        names[..count].iter().map(|name| port(self, name)).collect()
    }

    /// A target of a node or a light, which mostly exists in the document.
    pub(crate) fn target(&mut self, look: &Look) -> Option<Target> {
        if self.chance(3) {
            let lights: Vec<&LightId> = look.lights.keys().collect();
            let light = (*self.pick(&lights)?).clone();
            return Some(Target::Light {
                light,
                field: self.choose(&LightField::ALL).name().to_owned(),
            });
        }
        let mut graph = &look.graph;
        let mut path: Option<NodePath> = None;
        loop {
            let nodes: Vec<(&NodeId, &Node)> = graph.nodes.iter().collect();
            let Some((id, node)) = self.pick(&nodes).copied() else { break };
            path =
                Some(path.map_or_else(|| NodePath::root(id.clone()), |path| path.join(id.clone())));
            match look.definitions.get(node.kind.as_str()) {
                Some(inner) if self.chance(8) => graph = &inner.graph,
                _ => break,
            }
        }
        Some(Target::Input { node: path?, port: self.port() })
    }

    pub(crate) fn exposed(&mut self, look: &Look) -> Option<ExposedValue> {
        Some(ExposedValue {
            name: self.slug().into(),
            target: self.target(look)?,
            label: self.text(),
        })
    }

    pub(crate) fn aovs(&mut self, look: &Look) -> Vec<NamedAov> {
        let named = (0..self.below(3)).filter_map(|_| {
            let Target::Input { node, port } = self.target(look)? else { return None };
            Some(NamedAov { name: self.slug().into(), from: OutputPort { node, port } })
        });
        let mut aovs: Vec<NamedAov> = named.collect();
        let mut seen = HashSet::new();
        aovs.retain(|aov| seen.insert(aov.name.clone()));
        aovs
    }

    pub(crate) fn direction_keys(&mut self, look: &Look) -> DirectionKeys {
        let lights: Vec<&LightId> = look.lights.keys().collect();
        let light = self
            .pick(&lights)
            .map(|id| KeyDirection::Light((*id).clone()))
            .filter(|_| self.chance(5));
        let key = |r: &mut Self| DirectionKey {
            direction: r.direction(),
            values: (0..r.below(3)).filter_map(|_| Some((r.target(look)?, r.value()))).collect(),
            unknown: r.unknown(),
        };
        DirectionKeys {
            name: self.text(),
            by: light.unwrap_or(KeyDirection::View),
            scheme: self.choose(&[
                KeyScheme::Biharmonic,
                KeyScheme::AppendixB,
                KeyScheme::Tessellated,
            ]),
            keys: (0..self.below(4)).map(|_| key(self)).collect(),
            unknown: self.unknown(),
        }
    }

    pub(crate) fn time_keys(&mut self, look: &Look) -> Option<TimeKeys> {
        let mut times: Vec<f64> = (0..self.below(5)).map(|_| self.number(1e6)).collect();
        times.sort_by(f64::total_cmp);
        times.dedup_by(|a, b| a <= b);
        let key = |r: &mut Self, time| TimeKey {
            time,
            value: r.value(),
            interpolation: r.time_interpolation(),
            incoming: r.handles(),
            outgoing: r.handles(),
            handles: r.choose(&[HandlePair::Aligned, HandlePair::Free]),
            unknown: r.unknown(),
        };
        let keys = times.into_iter().map(|time| key(self, time)).collect();
        Some(TimeKeys {
            target: self.target(look)?,
            before: self.extrapolation(),
            after: self.extrapolation(),
            keys,
            unknown: self.unknown(),
        })
    }

    /// A valid look.
    pub(crate) fn look(&mut self) -> Look {
        let mut look = Look {
            name: self.text(),
            markers: self.markers(),
            unknown: self.unknown(),
            ..Look::default()
        };
        look.color_space = self.choose(&[ColorSpace::Display, ColorSpace::Linear]);
        look.about = self.text();
        look.tuned = self.text();
        look.tier = self.choose(&[None, Some(Tier::Exact), Some(Tier::Balanced), Some(Tier::Fast)]);
        for _ in 0..self.below(4) {
            look.lights.insert(self.slug().into(), self.light());
        }
        let mut kinds: Vec<String> = Vec::new();
        for _ in 0..self.below(3) {
            let definition = self.definition(&kinds);
            let id = self.slug();
            look.definitions.insert(id.as_str().into(), definition);
            kinds.push(id);
        }
        let mut unknown = std::mem::take(&mut look.unknown);
        look.graph = self.graph(&kinds, &mut unknown);
        self.shadows(&mut unknown, "lights", look.lights.keys().map(ToString::to_string));
        for _ in 0..self.below(4) {
            if let Some(exposed) = self.exposed(&look)
                && look.exposed.iter().all(|other| other.name != exposed.name)
            {
                look.exposed.push(exposed);
            }
            let keys = self.direction_keys(&look);
            look.direction_keys.push(keys);
            if let Some(keys) = self.time_keys(&look)
                && look.time_keys.iter().all(|other| other.target != keys.target)
            {
                look.time_keys.push(keys);
            }
        }
        self.shadows(
            &mut unknown,
            "exposed",
            look.exposed.iter().map(|exposed| exposed.name.to_string()),
        );
        look.unknown = unknown;
        look
    }

    pub(crate) fn rotation(&mut self) -> [f64; 4] {
        let q: [f64; 4] = std::array::from_fn(|_| self.bits() as f64 / u64::MAX as f64 - 0.5);
        let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        q.map(|x| x / length)
    }

    pub(crate) fn master(&mut self) -> GroupMaster {
        GroupMaster {
            name: self.text(),
            intensity: self.positive(1e3),
            exposure: self.number(60.0),
            tint: self.numbers(2.0),
        }
    }

    pub(crate) fn node_links(&mut self) -> NodeLinks {
        if self.chance(5) {
            return NodeLinks::default();
        }
        NodeLinks {
            layered: self.light_set(),
            unlayered: self.light_set(),
            filtered: self.light_set(),
            unfiltered: self.light_set(),
        }
    }

    fn layers(&mut self) -> Vec<LayerLink> {
        let row = |r: &mut Self| LayerLink {
            layered: r.light_set(),
            unlayered: r.light_set(),
            filtered: r.light_set(),
            unfiltered: r.light_set(),
            ..LayerLink::new(r.slug().into())
        };
        let mut rows: Vec<LayerLink> = (0..self.below(3)).map(|_| row(self)).collect();
        rows.dedup_by(|a, b| a.node == b.node);
        rows
    }

    pub(crate) fn light_set(&mut self) -> LightSet {
        let texts = ["*", "", " key|rim-2 - group:set", "\"Key \\ light\" & ({source})"];
        LightSet::parse(self.choose(&texts)).expect("a set of lights")
    }

    pub(crate) fn object_set(&mut self) -> ObjectSet {
        let texts = ["*", "", " floor|wall-* - {source}", "torus & (*)"];
        ObjectSet::parse(self.choose(&texts)).expect("a set of objects")
    }

    pub(crate) fn object(&mut self) -> Object {
        let scale =
            std::array::from_fn(|_| if self.chance(5) { 1.0 } else { -0.5 - self.positive(1e3) });
        let mut object = Object {
            mesh: self.choose(&["shape:torus", "meshes/a b.obj", ""]).to_owned(),
            animation: self.chance(3).then(|| self.animation()),
            transform: Transform {
                translate: self.numbers(1e6),
                rotate: self.rotation(),
                scale,
                fit: self.chance(5),
            },
            looks: (0..self.below(3)).map(|_| (self.text(), self.text())).collect(),
            values: self.values(),
            linked: self.light_set(),
            unlinked: self.light_set(),
            shadowed: self.light_set(),
            unshadowed: self.light_set(),
            shadows_on: self.object_set(),
            no_shadows_on: self.object_set(),
            layers: self.layers(),
            visible: self.chance(5),
            unknown: self.unknown(),
        };
        if self.chance(3) {
            object.looks = [("*".to_owned(), self.text())].into();
        }
        object
    }

    fn animation(&mut self) -> MeshAnimation {
        MeshAnimation {
            name: self.text(),
            speed: self.number(1e3),
            offset: self.number(1e3),
            loops: self.chance(2),
        }
    }

    pub(crate) fn camera(&mut self) -> Camera {
        Camera {
            eye: [self.number(5.0), self.number(5.0), 10.0],
            target: [self.number(5.0), 0.0, self.number(5.0)],
            up: [0.1, 1.0, self.number(0.1)],
            projection: self.choose(&[Projection::Perspective, Projection::Orthographic]),
            fov: 0.1 + self.positive(3.0),
            height: 0.1 + self.positive(100.0),
            aspect: self.positive(3.0),
        }
    }

    pub(crate) fn outlines(&mut self) -> SceneOutlines {
        SceneOutlines {
            width: self.positive(20.0),
            color: [0.1, 0.2, self.positive(1.0), 1.0],
            creases: self.positive(1.0),
            ..SceneOutlines::default()
        }
    }

    pub(crate) fn time(&mut self) -> TimeRange {
        let start = self.number(1e3);
        TimeRange { start, end: start + self.positive(1e3), fps: 0.5 + self.positive(100.0) }
    }

    /// A valid scene.
    pub(crate) fn scene(&mut self) -> Scene {
        let mut scene = Scene {
            name: self.text(),
            about: self.text(),
            objects: (0..self.count()).map(|_| (self.slug().into(), self.object())).collect(),
            lights: (0..self.below(4)).map(|_| (self.slug().into(), self.light())).collect(),
            light_groups: (0..self.below(3)).map(|_| (self.slug().into(), self.master())).collect(),
            muted: self.light_set(),
            soloed: self.light_set(),
            direction_keys: Vec::new(),
            time_keys: Vec::new(),
            markers: self.markers(),
            illumination: self.rotation(),
            camera: self.camera(),
            file_camera: self
                .chance(3)
                .then(|| FileCamera { object: self.text(), name: self.text() }),
            backdrop: self.chance(7).then(|| self.numbers(1.0)),
            outlines: self.outlines(),
            time: self.time(),
            unknown: self.unknown(),
        };
        let lit = Look { lights: scene.lights.clone(), ..Look::default() };
        for _ in 0..self.below(3) {
            scene.direction_keys.push(self.direction_keys(&lit));
            scene.time_keys.extend(self.time_keys(&lit));
        }
        scene.time_keys.dedup_by(|a, b| a.target == b.target);
        let mut unknown = std::mem::take(&mut scene.unknown);
        self.shadows(&mut unknown, "lights", scene.lights.keys().map(ToString::to_string));
        for part in ["camera", "time"] {
            let extras = self.unknown();
            if !extras.is_empty() {
                unknown.insert(part.to_owned(), extras.into());
            }
        }
        scene.unknown = unknown;
        scene
    }

    fn shot_keys(&mut self) -> Vec<ShotKey> {
        let mut frame = self.below(2000) as f64 - 1000.0;
        let mut key = || {
            frame += 0.25 * (1 + self.below(100)) as f64;
            ShotKey {
                frame,
                value: self.value(),
                interpolation: self.time_interpolation(),
                incoming: self.handles(),
                outgoing: self.handles(),
                handles: self.choose(&[HandlePair::Aligned, HandlePair::Free]),
                unknown: self.unknown(),
            }
        };
        (0..3).map(|_| key()).collect()
    }

    fn change(&mut self) -> Override {
        let address = [self.slug(), self.slug(), self.slug()].join(".");
        let keys = if self.chance(5) { self.shot_keys() } else { Vec::new() };
        let value = keys.is_empty().then(|| self.value());
        Override {
            look: self.chance(4).then(|| self.text()),
            target: address,
            value,
            step: if keys.is_empty() { 1 } else { 1 + self.below(4) as u32 },
            before: self.extrapolation(),
            after: self.extrapolation(),
            keys,
            unknown: self.unknown(),
        }
    }

    pub(crate) fn shot(&mut self) -> Shot {
        let rates = ["24", "25", "24000/1001", "30000/1001"];
        let mut overrides: Vec<Override> = (0..self.count()).map(|_| self.change()).collect();
        overrides.sort_by(|a, b| a.target.cmp(&b.target));
        overrides.dedup_by(|a, b| a.target == b.target);
        let mut unknown = self.unknown();
        let camera = self.chance(4).then(|| self.camera());
        let extras = self.unknown();
        if camera.is_some() && !extras.is_empty() {
            unknown.insert("camera".to_owned(), extras.into());
        }
        Shot {
            name: self.text(),
            about: self.text(),
            scene: self.text(),
            frames: self.chance(6).then(|| {
                let first = self.below(2000) as i32 - 1000;
                [first, first + self.below(300) as i32]
            }),
            rate: self.chance(6).then(|| self.choose(&rates).parse().unwrap()),
            size: self
                .chance(4)
                .then(|| [1 + self.below(4000) as u32, 1 + self.below(4000) as u32]),
            step: self.chance(4).then(|| 1 + self.below(4) as u32),
            chunk: self.chance(4).then(|| 1 + self.below(100) as u32),
            camera,
            markers: (0..self.below(3))
                .map(|_| ShotMarker {
                    frame: self.below(2000) as i32 - 1000,
                    name: self.text(),
                    unknown: self.unknown(),
                })
                .collect(),
            overrides,
            unknown,
        }
    }
}
