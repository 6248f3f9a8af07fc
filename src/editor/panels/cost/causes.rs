//! Causes of passes: the values without which a look needs fewer of them, found by compiling the
//! look without each.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::catalog::{Catalog, values};
use crate::compile::{CompileOptions, CompiledShader, Live, compile};
use crate::document::{Edit, GraphId, Look, Target, Value};
use crate::ids::{NodePath, PortName};
use crate::library::{Library, PassId, Type};
use crate::progress::Progress;

/// Most compilations for the causes of one look.
const MOST_TRIALS: usize = 120;

/// Value that passes are needed for.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CauseValue {
    /// Graph that the value lies in.
    graph: GraphId,
    /// Node that has the value; of a group that is used several times, in the first of its nodes.
    node: NodePath,
    port: PortName,
    /// The value as it is.
    pub(super) now: Value,
}

impl CauseValue {
    /// Input that has the value.
    pub(super) fn target(&self) -> Target {
        Target::Input { node: self.node.clone(), port: self.port.clone() }
    }

    /// Edit that takes the value away.
    fn neutral(&self) -> Option<Edit> {
        let value = match self.now {
            Value::Bool(_) => Value::Bool(false),
            _ => Value::Number(0.0),
        };
        let (graph, port) = (self.graph.clone(), self.port.clone());
        let id = self.node.last()?.clone();
        Some(Edit::SetValue { graph, id, port, value, index: None })
    }
}

/// Values that are the only reason for passes, together.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PassCause {
    pub(super) values: Vec<CauseValue>,
    /// Passes that go without them.
    pub(super) passes: Vec<PassId>,
}

impl PassCause {
    /// Edit that takes the values away, and the passes with them.
    pub(super) fn cure(&self) -> Edit {
        let mut edits: Vec<Edit> = self.values.iter().filter_map(CauseValue::neutral).collect();
        if edits.len() == 1 { edits.remove(0) } else { Edit::Group { edits } }
    }
}

/// Look whose passes are asked about.
pub(super) struct CauseRequest {
    pub(super) look: Arc<Look>,
    pub(super) library: Arc<Library>,
    pub(super) progress: Progress,
}

/// Finds the causes of the passes of a look: single values first, then values of the same name
/// that only together are one.
pub(super) fn causes(request: &CauseRequest) -> Vec<PassCause> {
    let mut trials = Trials { request, left: MOST_TRIALS };
    let Some(shader) = trials.compiled(&[]) else { return Vec::new() };
    let all = passes_of(&shader);
    if all.is_empty() {
        return Vec::new();
    }
    let (mut found, mut others): (Vec<PassCause>, Vec<CauseValue>) = Default::default();
    for candidate in candidates(request, &shader) {
        let values = vec![candidate.clone()];
        match trials.passes_without(&values, &all) {
            Some(passes) if !passes.is_empty() => found.push(PassCause { values, passes }),
            Some(_) => others.push(candidate),
            None => {}
        }
    }
    let explained: BTreeSet<PassId> = found.iter().flat_map(|cause| cause.passes.clone()).collect();
    let unexplained: BTreeSet<PassId> = all.difference(&explained).copied().collect();
    let names: BTreeSet<PortName> = others.iter().map(|value| value.port.clone()).collect();
    for name in names.into_iter().filter(|_| !unexplained.is_empty()) {
        let values: Vec<CauseValue> =
            others.iter().filter(|value| value.port == name).cloned().collect();
        found.extend(together(&mut trials, values, &unexplained));
    }
    found
}

/// The least of some values that are a cause together.
fn together(
    trials: &mut Trials<'_>,
    mut values: Vec<CauseValue>,
    all: &BTreeSet<PassId>,
) -> Option<PassCause> {
    let passes = trials.passes_without(&values, all).filter(|passes| !passes.is_empty())?;
    let mut index = 0;
    while index < values.len() {
        let mut fewer = values.clone();
        fewer.remove(index);
        if trials.passes_without(&fewer, all).as_ref() == Some(&passes) {
            values = fewer;
        } else {
            index += 1;
        }
    }
    Some(PassCause { values, passes })
}

/// Compilations of a look with other values.
struct Trials<'r> {
    request: &'r CauseRequest,
    /// Number of compilations that may still be made.
    left: usize,
}

impl Trials<'_> {
    /// The look without values.
    fn compiled(&mut self, without: &[CauseValue]) -> Option<CompiledShader> {
        self.left = self.left.checked_sub(1)?;
        self.request.progress.check().ok()?;
        let mut look = (*self.request.look).clone();
        for value in without {
            look.apply(value.neutral()?).ok()?;
        }
        let options =
            CompileOptions { live: Live::Keyed, display: true, ..CompileOptions::default() };
        Some(compile(&look, &self.request.library, &options).ok()?.value)
    }

    /// Passes of `all` that go without values; `None` where a node that has one goes as well, as
    /// the values would then be no more than a way to take the node out.
    fn passes_without(
        &mut self,
        without: &[CauseValue],
        all: &BTreeSet<PassId>,
    ) -> Option<Vec<PassId>> {
        let shader = self.compiled(without)?;
        if !without.iter().all(|value| lives(&shader, &value.node)) {
            return None;
        }
        let left = passes_of(&shader);
        Some(all.iter().filter(|pass| !left.contains(pass)).copied().collect())
    }
}

/// The passes that a look reads, and those that these are made from.
fn passes_of(shader: &CompiledShader) -> BTreeSet<PassId> {
    let mut passes: BTreeSet<PassId> = shader.needs.passes().collect();
    // Each pass reads earlier ones alone.
    for pass in PassId::all().rev() {
        if passes.iter().any(|reader| reader.reads(pass)) {
            passes.insert(pass);
        }
    }
    passes
}

/// Values of live nodes that can be taken away: switches that are on, numbers that are not 0.
fn candidates(request: &CauseRequest, shader: &CompiledShader) -> Vec<CauseValue> {
    let look = &*request.look;
    let mut catalog = Catalog::new(&request.library);
    catalog.sync(look, &request.library);
    let mut found = Vec::new();
    for (graph, at) in graphs(look) {
        let Some(here) = look.graph_of(&graph) else { continue };
        for (id, node) in here.nodes.iter().filter(|(_, node)| !node.muted) {
            let path = at.join(id.clone());
            let Some(kind) = catalog.of(node).filter(|_| lives(shader, &path)) else { continue };
            for port in &kind.inputs {
                let is_free = here.wire_into(id, &port.name).is_none();
                let own = node.values.get(&port.name);
                let Some(now) = values::current(port, own).filter(|_| is_free) else { continue };
                let counts = match (now, &port.ty) {
                    (Value::Number(number), Type::Float) => *number != 0.0,
                    (Value::Bool(is_on), Type::Bool) => *is_on,
                    _ => false,
                };
                let (graph, node, port) = (graph.clone(), path.clone(), port.name.clone());
                let value = CauseValue { graph, node, port, now: now.clone() };
                if counts && !is_keyed(look, &value.target()) {
                    found.push(value);
                }
            }
        }
    }
    found
}

/// The look's own graph, and those of its groups that are used, each with the path of the first
/// node that is one.
fn graphs(look: &Look) -> Vec<(GraphId, NodePath)> {
    let mut found = vec![(GraphId::Look, NodePath::default())];
    let mut next = 0;
    while let Some((graph, at)) = found.get(next).cloned() {
        next += 1;
        let Some(graph) = look.graph_of(&graph) else { continue };
        for (id, node) in graph.nodes.iter().filter(|(_, node)| !node.muted) {
            let Some((group, _)) = look.definitions.get_key_value(node.kind.as_str()) else {
                continue;
            };
            let group = GraphId::Definition(group.clone());
            if found.iter().all(|(known, _)| *known != group) {
                found.push((group, at.join(id.clone())));
            }
        }
    }
    found
}

/// True if anything of a node is left in the shader.
fn lives(shader: &CompiledShader, node: &NodePath) -> bool {
    shader.spans.spans_of(node).next().is_some()
}

/// True if keys move a value: to set it would change a key alone.
fn is_keyed(look: &Look, target: &Target) -> bool {
    look.time_keys.iter().any(|track| track.target == *target)
        || look
            .direction_keys
            .iter()
            .any(|set| set.keys.iter().any(|key| key.values.contains_key(target)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<PassCause> {
        let look = Arc::new(Look::read(text, "test").value.unwrap());
        let library = Arc::new(Library::built_in().clone());
        causes(&CauseRequest { look, library, progress: Progress::new() })
    }

    /// A look of two layers with these slopes.
    fn layers(slopes: [f64; 2]) -> String {
        let layer = |id: &str, slope: f64| {
            format!(
                r##"{{"id": "{id}", "kind": "light_layer", "values": {{"light": "key",
                "slope": {slope}, "convex": "#ff0000", "concave": "#0000ff"}}}}"##
            )
        };
        format!(
            r#"{{"lights": {{"key": {{"direction": [0, 0, 1]}}}}, "nodes": [
            {{"id": "base", "kind": "base"}}, {}, {}, {{"id": "output", "kind": "output"}}],
            "wires": [{{"from": "base", "to": "one.below"}}, {{"from": "one", "to": "two.below"}},
                      {{"from": "two", "to": "output.color"}}]}}"#,
            layer("one", slopes[0]),
            layer("two", slopes[1])
        )
    }

    fn names(cause: &PassCause) -> Vec<String> {
        let name = |value: &CauseValue| format!("{}.{}", value.node, value.port);
        cause.values.iter().map(name).collect()
    }

    #[test]
    fn a_slope_is_the_cause_of_the_passes_of_curvature() {
        let causes = found(&layers([0.2, 0.0]));
        assert_eq!(causes.iter().map(names).collect::<Vec<_>>(), [["one.slope"]], "{causes:?}");
        assert_eq!(causes[0].passes.len(), 2, "{causes:?}");
        assert!(found(&layers([0.0, 0.0])).is_empty(), "there is nothing to be the cause of");
    }

    #[test]
    fn values_may_be_the_cause_only_together() {
        let causes = found(&layers([0.2, 0.1]));
        let named: Vec<Vec<String>> = causes.iter().map(names).collect();
        assert_eq!(named, [["one.slope", "two.slope"]], "{causes:?}");
        let look = Look::read(&layers([0.2, 0.1]), "test").value.unwrap();
        let mut cured = look.clone();
        cured.apply(causes[0].cure()).unwrap();
        assert_eq!(cured.graph, Look::read(&layers([0.0, 0.0]), "test").value.unwrap().graph);
    }

    /// A layer in a group that lies in another.
    #[test]
    fn a_value_inside_of_groups_is_found_and_taken_away_there() {
        let group = |kind: &str, values: &str| {
            format!(
                r##"{{"inputs": [{{"name": "below"}}], "outputs": [{{"name": "below"}}],
                "nodes": [{{"id": "inner", "kind": "{kind}", "values": {{{values}}}}}],
                "wires": [{{"from": "inputs.below", "to": "inner.below"}},
                          {{"from": "inner.below", "to": "outputs.below"}}]}}"##
            )
        };
        let layer = r##""light": "key", "slope": 0.2, "convex": "#ff0000", "concave": "#0000ff""##;
        let text = format!(
            r#"{{"lights": {{"key": {{"direction": [0, 0, 1]}}}},
            "definitions": {{"rim": {}, "around": {}}},
            "nodes": [{{"id": "base", "kind": "base"}}, {{"id": "one", "kind": "around"}},
                      {{"id": "output", "kind": "output"}}],
            "wires": [{{"from": "base", "to": "one.below"}},
                      {{"from": "one.below", "to": "output.color"}}]}}"#,
            group("light_layer", layer),
            group("rim", "")
        );
        let causes = found(&text);
        let named: Vec<Vec<String>> = causes.iter().map(names).collect();
        assert_eq!(named, [["one/inner/inner.slope"]], "{causes:?}");
        let mut look = Look::read(&text, "test").value.unwrap();
        look.apply(causes[0].cure()).unwrap();
        let slope = look.definitions["rim"].graph.nodes["inner"].values.get("slope");
        assert_eq!(slope, Some(&Value::Number(0.0)));
    }
}
