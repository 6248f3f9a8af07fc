//! Checks of edits before they are applied: the new values must be ones that a document can hold,
//! and the names must exist.
//!
//! The first check is a trial rather than a second set of rules: a small document with nothing but
//! the new part is written and read, so that an edit obeys every bound of the reader.

use chiaro_locale::tr;

use super::{Edit, SceneEdit, ShotEdit, impossible, missing};
use crate::diag::Diagnostic;
use crate::document::check::{check_output, check_target};
use crate::document::{
    DirectionKeys, Endpoint, ExposedValue, Frame, Graph, GraphId, Look, NamedAov, Node, Object,
    Scene, Shot, Target, TimeKeys, Wire,
};
use crate::ids::{DefinitionId, GROUP_INPUTS, GROUP_OUTPUTS, NodePath, is_slug};

type Check = Result<(), Box<Diagnostic>>;

/// Checks an edit of a look, groups aside: their edits are checked one after the other.
pub(super) fn check(look: &Look, edit: &Edit) -> Check {
    match edit {
        Edit::SetLookName { name } => readable(|trial| trial.name = name.clone()),
        Edit::SetLookAbout { about } => readable(|trial| trial.about = about.clone()),
        Edit::SetLookTags { tags } => readable(|trial| trial.tags = tags.clone()),
        Edit::SetMaxError { max_error } => readable(|trial| trial.max_error = *max_error),
        Edit::AddNode { graph, id, node, .. } => {
            slug(id.as_str())?;
            if *graph != GraphId::Look && matches!(id.as_str(), GROUP_INPUTS | GROUP_OUTPUTS) {
                return Err(impossible(tr!("`{id}` is the name of the group's own {id}")));
            }
            readable_node(node.clone())
        }
        Edit::SetName { name, .. } => readable_node(Node { name: name.clone(), ..Node::default() }),
        Edit::SetKind { kind, .. } => readable_node(Node { kind: kind.clone(), ..Node::default() }),
        Edit::MoveNodes { positions, .. } => positions
            .values()
            .try_for_each(|&position| readable_node(Node { position, ..Node::default() })),
        Edit::SetValue { port, value, .. } => {
            slug(port.as_str())?;
            let values = [(port.clone(), value.clone())].into_iter().collect();
            readable_node(Node { values, ..Node::default() })
        }
        Edit::AddWire { graph, wire, index } => check_wire(look, graph, wire, index.is_some()),
        Edit::AddFrame { graph, id, frame, .. } => {
            slug(id.as_str())?;
            check_frame(look, graph, frame)
        }
        Edit::SetFrame { graph, frame, .. } => check_frame(look, graph, frame),
        Edit::AddNote { id, note, .. } => {
            slug(id.as_str())?;
            readable(|trial| drop(trial.graph.notes.insert("trial".into(), note.clone())))
        }
        Edit::SetNote { note, .. } => {
            readable(|trial| drop(trial.graph.notes.insert("trial".into(), note.clone())))
        }
        Edit::SetBookmarks { bookmarks, .. } => {
            readable(|trial| trial.graph.bookmarks.clone_from(bookmarks))
        }
        Edit::AddLight { id, light, .. } | Edit::SetLight { id, light } => {
            slug(id.as_str())?;
            readable(|trial| drop(trial.lights.insert(id.clone(), light.clone())))
        }
        Edit::AddDefinition { id, definition, .. } => {
            slug(id.as_str())?;
            readable(|trial| drop(trial.definitions.insert(id.clone(), definition.clone())))?;
            keeps_targets(look, id, &definition.graph)
        }
        Edit::SetInterface { id, label, help, inputs, outputs } => readable(|trial| {
            let of = trial.definitions.entry(id.clone()).or_default();
            (of.label, of.help) = (label.clone(), help.clone());
            (of.inputs, of.outputs) = (inputs.clone(), outputs.clone());
        }),
        Edit::RemoveDefinition { id } => check_unused(look, id),
        Edit::AddExposed { exposed, .. } => check_exposed(look, exposed, usize::MAX),
        Edit::SetExposed { exposed, index } => check_exposed(look, exposed, *index),
        Edit::SetAovs { aovs } => check_aovs(look, aovs),
        Edit::AddDirectionKeys { keys, .. } | Edit::SetDirectionKeys { keys, .. } => {
            check_direction_keys(look, keys)
        }
        Edit::AddTimeKeys { keys, .. } => check_time_keys(look, keys, usize::MAX),
        Edit::SetTimeKeys { keys, index } => check_time_keys(look, keys, *index),
        Edit::SetMarkers { markers } => readable_alone(|trial| trial.markers.clone_from(markers)),
        _ => Ok(()),
    }
}

/// Checks an edit of a scene, groups aside.
pub(super) fn check_scene(edit: &SceneEdit) -> Check {
    let mut trial = Scene::default();
    match edit {
        SceneEdit::SetSceneName { name } => trial.name.clone_from(name),
        SceneEdit::SetSceneAbout { about } => trial.about.clone_from(about),
        SceneEdit::AddObject { id, object, .. } | SceneEdit::SetObject { id, object } => {
            slug(id.as_str())?;
            trial.objects.insert(id.clone(), Object::clone(object));
        }
        SceneEdit::AddLight { id, light, .. } | SceneEdit::SetLight { id, light } => {
            slug(id.as_str())?;
            trial.lights.insert(id.clone(), light.clone());
        }
        SceneEdit::SetLightKeys { direction_keys, time_keys } => {
            let of_keys = direction_keys.iter().flat_map(|keys| &keys.keys);
            let mut targets = of_keys
                .flat_map(|key| key.values.keys())
                .chain(time_keys.iter().map(|track| &track.target));
            if targets.any(|target| target.light_field().is_none())
                || direction_keys.iter().any(|keys| keys.by.outputs().next().is_some())
            {
                return Err(impossible(tr!("the keys of a scene move fields of its lights alone")));
            }
            return readable_alone(|look| {
                look.direction_keys.clone_from(direction_keys);
                look.time_keys.clone_from(time_keys);
            });
        }
        SceneEdit::SetMarkers { markers } => trial.markers.clone_from(markers),
        SceneEdit::SetIllumination { rotation } => {
            let length = rotation.iter().map(|x| x * x).sum::<f64>().sqrt();
            let is_unit = (length - 1.0).abs() < 1e-6;
            if !is_unit {
                return Err(impossible(tr!("the rotation is no quaternion of length 1")));
            }
        }
        SceneEdit::SetCamera { camera } => trial.camera = *camera,
        SceneEdit::SetFileCamera { camera } => trial.file_camera.clone_from(camera),
        SceneEdit::SetBackdrop { color } => trial.backdrop = *color,
        SceneEdit::SetMaster { group, master, .. } => {
            slug(group.as_str())?;
            trial.light_groups.extend(master.clone().map(|master| (group.clone(), master)));
        }
        SceneEdit::SetMutedLights { muted } => trial.muted.clone_from(muted),
        SceneEdit::SetSoloedLights { soloed } => trial.soloed.clone_from(soloed),
        SceneEdit::SetOutlines { outlines } => trial.outlines = *outlines,
        SceneEdit::SetTime { time } => trial.time = *time,
        _ => return Ok(()),
    }
    first_error(Scene::read(&trial.to_trial_text(), "").diagnostics)
}

/// Checks an edit of a shot, groups aside.
pub(super) fn check_shot(edit: &ShotEdit) -> Check {
    let mut trial = Shot { scene: "scene.json".to_owned(), ..Shot::default() };
    match edit {
        ShotEdit::SetShotName { name } => trial.name.clone_from(name),
        ShotEdit::SetOverride { change: Some(change), .. } => {
            trial.overrides.push(change.as_ref().clone());
        }
        ShotEdit::SetFrames { frames } => trial.frames = *frames,
        ShotEdit::SetRate { rate } => trial.rate = *rate,
        ShotEdit::SetSize { size } => trial.size = *size,
        ShotEdit::SetStep { step } => trial.step = *step,
        ShotEdit::SetChunk { chunk } => trial.chunk = *chunk,
        ShotEdit::SetShotCamera { camera } => trial.camera = *camera,
        ShotEdit::SetShotMarkers { markers } => trial.markers.clone_from(markers),
        _ => return Ok(()),
    }
    first_error(Shot::read(&trial.to_trial_text(), "").diagnostics)
}

/// Checks that a look with nothing but this part is read without an error.
fn readable(part: impl FnOnce(&mut Look)) -> Check {
    let mut trial = Look::default();
    part(&mut trial);
    first_error(Look::read(&trial.to_trial_text(), "").diagnostics)
}

fn readable_node(node: Node) -> Check {
    readable(|trial| drop(trial.graph.nodes.insert("trial".into(), node)))
}

/// Check as [`readable`], but for parts that name others, which are not in the trial.
fn readable_alone(part: impl FnOnce(&mut Look)) -> Check {
    let mut trial = Look::default();
    part(&mut trial);
    first_error(Look::read_alone(&trial.to_trial_text()))
}

/// First error, without its place in the trial.
fn first_error(diagnostics: Vec<Diagnostic>) -> Check {
    match diagnostics.into_iter().find(Diagnostic::is_error) {
        None => Ok(()),
        Some(mut problem) => {
            problem.place = Default::default();
            Err(Box::new(problem))
        }
    }
}

fn slug(id: &str) -> Check {
    if is_slug(id) { Ok(()) } else { Err(impossible(tr!("`{id}` is no id"))) }
}

fn graph_of<'l>(look: &'l Look, graph: &GraphId) -> Result<&'l Graph, Box<Diagnostic>> {
    look.graph_of(graph).ok_or_else(|| match graph {
        GraphId::Definition(id) => missing(tr!("part" => "group"), id),
        GraphId::Look => impossible(tr!("there is no graph")),
    })
}

fn check_wire(look: &Look, graph: &GraphId, wire: &Wire, needs_free_input: bool) -> Check {
    let of = graph_of(look, graph)?;
    let end = |end: &Endpoint, own: &str| {
        let is_own = *graph != GraphId::Look && end.node.as_str() == own;
        if is_own || of.nodes.contains_key(&end.node) {
            Ok(())
        } else {
            Err(missing(tr!("part" => "node"), &end.node))
        }
    };
    end(&wire.from, GROUP_INPUTS)?;
    end(&wire.to, GROUP_OUTPUTS)?;
    if !wire.from.port.as_str().is_empty() {
        slug(wire.from.port.as_str())?;
    }
    slug(wire.to.port.as_str())?;
    if needs_free_input && of.wire_into(&wire.to.node, &wire.to.port).is_some() {
        return Err(impossible(tr!("a wire leads into `{to}` already", to = wire.to)));
    }
    Ok(())
}

fn check_frame(look: &Look, graph: &GraphId, frame: &Frame) -> Check {
    let of = graph_of(look, graph)?;
    if let Some(id) = frame.nodes.iter().find(|&id| !of.nodes.contains_key(id)) {
        return Err(missing(tr!("part" => "node"), id));
    }
    readable_alone(|trial| drop(trial.graph.frames.insert("trial".into(), frame.clone())))
}

/// Checks that a group is unused before it is removed. Undoing the addition of a group, which may
/// stand before the library's of the same name, leaves its nodes to the latter; so inverses are not
/// checked.
fn check_unused(look: &Look, id: &DefinitionId) -> Check {
    let uses = |graph: &Graph| {
        graph.nodes.iter().find(|(_, node)| node.kind == id.as_str()).map(|(id, _)| id.clone())
    };
    let others = look.definitions.iter().filter(|(other, _)| *other != id);
    let graphs =
        std::iter::once(&look.graph).chain(others.map(|(_, definition)| &definition.graph));
    match graphs.filter_map(uses).next() {
        Some(user) => {
            let problem = impossible(tr!("the node `{user}` is of the group `{id}`"));
            Err(Box::new(problem.hint(tr!("remove its nodes first"))))
        }
        None => Ok(()),
    }
}

/// Checks that a definition does not take targets away from a group of the library of the same
/// name.
fn keeps_targets(look: &Look, id: &DefinitionId, graph: &Graph) -> Check {
    let targets = look.exposed.iter().map(|exposed| &exposed.target);
    let targets = targets.chain(look.time_keys.iter().map(|keys| &keys.target));
    let keyed = look
        .direction_keys
        .iter()
        .flat_map(|keys| keys.keys.iter().flat_map(|key| key.values.keys()));
    for target in targets.chain(keyed) {
        let Target::Input { node, .. } = target else { continue };
        let ids = node.ids();
        let loses = (1..ids.len()).any(|depth| {
            let around = ids[1..depth]
                .iter()
                .fold(NodePath::root(ids[0].clone()), |path, id| path.join(id.clone()));
            look.find(&around).is_some_and(|found| found.node.kind == id.as_str())
                && !graph.nodes.contains_key(&ids[depth])
        });
        if loses {
            return Err(impossible(tr!(
                "the group `{id}` has nothing for `{target}`, which is exposed or keyed"
            )));
        }
    }
    Ok(())
}

fn check_exposed(look: &Look, exposed: &ExposedValue, own: usize) -> Check {
    let is_taken =
        |(index, other): (usize, &ExposedValue)| index != own && other.name == exposed.name;
    if look.exposed.iter().enumerate().any(is_taken) {
        return Err(impossible(tr!("there is a parameter `{name}` already", name = exposed.name)));
    }
    slug(exposed.name.as_str())?;
    first_error(check_target(look, &exposed.target))?;
    readable_alone(|trial| trial.exposed.push(exposed.clone()))
}

fn check_aovs(look: &Look, aovs: &[NamedAov]) -> Check {
    for (index, aov) in aovs.iter().enumerate() {
        if aovs[..index].iter().any(|other| other.name == aov.name) {
            return Err(impossible(tr!("two outputs have the name `{name}`", name = aov.name)));
        }
        slug(aov.name.as_str())?;
        first_error(check_output(look, &aov.from))?;
    }
    readable_alone(|trial| trial.aovs.extend_from_slice(aovs))
}

fn check_direction_keys(look: &Look, keys: &DirectionKeys) -> Check {
    if let Some(light) =
        keys.by.lights().into_iter().find(|light| !look.lights.contains_key(*light))
    {
        return Err(missing(tr!("part" => "light"), light));
    }
    for output in keys.by.outputs() {
        first_error(check_output(look, output))?;
    }
    for target in keys.keys.iter().flat_map(|key| key.values.keys()) {
        first_error(check_target(look, target))?;
    }
    readable_alone(|trial| trial.direction_keys.push(keys.clone()))
}

fn check_time_keys(look: &Look, keys: &TimeKeys, own: usize) -> Check {
    let is_taken = |(index, other): (usize, &TimeKeys)| index != own && other.target == keys.target;
    if look.time_keys.iter().enumerate().any(is_taken) {
        return Err(impossible(tr!("`{target}` has keys already", target = keys.target)));
    }
    first_error(check_target(look, &keys.target))?;
    if !keys.keys.windows(2).all(|pair| pair[0].time < pair[1].time) {
        return Err(impossible(tr!("the times of the keys do not increase")));
    }
    readable_alone(|trial| trial.time_keys.push(keys.clone()))
}
