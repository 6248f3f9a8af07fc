//! Shader of the look: requests to the compiler, its answers, and the choice between the live and
//! the baked shader.

use std::collections::HashSet;
use std::sync::Arc;
use std::time::Duration;

use super::Session;
use crate::compile::{CompiledShader, Live, TypedGraph};
use crate::diag::WithWarnings;
use crate::document::{
    DirectionKeys, DocumentRevision, Edit, Editable, GraphId, Look, Target, Value,
};
use crate::ids::{NodePath, PortName};
use crate::library::Fallback;
use crate::state::compiling::{CompileAnswer, CompileRequest};
use crate::state::reading::LookWithLibrary;
use crate::state::revision::LookRevision;

/// Seconds of inactivity before the baked shader is compiled.
const BAKE_DELAY: f64 = 0.8;

/// Number of edited values that a long look keeps as uniforms before the set begins anew.
const MOST_TOUCHED: usize = 512;

/// The shaders that are shown, and their relation to the document.
#[derive(Default)]
pub(crate) struct ShaderCache {
    /// The look that a shader can show: the document, or, while that does not compile, its last
    /// state that did.
    pub(super) good: Option<Arc<Look>>,
    pub(super) live: Option<Arc<CompiledShader>>,
    /// Structure of the live shader.
    pub(super) live_structure: Option<LookRevision>,
    pub(super) baked: Option<Arc<CompiledShader>>,
    /// Typed look that both shaders were compiled from.
    pub(super) typed: Option<Arc<TypedGraph>>,
    /// Revision of the last change that the picture of `good` may show.
    pub(super) good_picture: Option<DocumentRevision>,
    /// Revision of the document that the baked shader shows.
    pub(super) baked_revision: Option<LookRevision>,
    /// Revision of the last edit that a live shader cannot show.
    pub(super) structure: LookRevision,
    pub(super) requested: Option<LookRevision>,
    pub(super) requested_structure: Option<LookRevision>,
    /// Values that were edited since the look was opened: the ones that a long look's live shader
    /// keeps as uniforms.
    pub(super) touched: Arc<HashSet<(NodePath, PortName)>>,
    /// Number of touched values when a live shader was last requested.
    pub(super) requested_touched: usize,
    /// Time of the document's last change, in seconds of the window's clock.
    pub(super) changed_at: f64,
    pub(super) seen_revision: LookRevision,
}

/// A look with a shader that shows it.
pub(crate) struct DrawableLook {
    pub(crate) look: Arc<Look>,
    pub(crate) shader: Arc<CompiledShader>,
    pub(crate) live: Live,
}

impl ShaderCache {
    /// Discards the state of both shaders after the available nodes changed.
    pub(super) fn structure_changed(&mut self) {
        self.requested_structure = None;
        self.live_structure = None;
        self.baked_revision = None;
    }

    /// True if the baked shader shows the look of a revision.
    fn is_baked(&self, revision: LookRevision) -> bool {
        self.baked_revision == Some(revision)
    }

    /// True if the live shader has the look's structure.
    fn is_live(&self) -> bool {
        self.live_structure == Some(self.structure)
    }

    /// The shader with the values of the present revision: the baked one where nothing changed
    /// since, else the live one.
    pub(super) fn current(&self, revision: LookRevision) -> Option<&CompiledShader> {
        let shader = if self.is_baked(revision) { &self.baked } else { &self.live };
        shader.as_deref()
    }

    /// The shader that computes wires for an object. For an object that sets exposed values this is
    /// the live one: a baked shader has the look's values in it.
    pub(super) fn of_wires(
        &self,
        sets_values: bool,
        revision: LookRevision,
    ) -> Option<&CompiledShader> {
        let live = self.live.as_deref().filter(|_| sets_values && self.is_live());
        live.or_else(|| self.current(revision))
    }

    /// True if the live shader of a long look has folded a value that is edited now, and no shader
    /// was requested since.
    fn lacks_a_uniform(&self) -> bool {
        let Some(Live::Touched(known)) = self.live.as_ref().map(|shader| &shader.live) else {
            return false;
        };
        self.requested_touched != self.touched.len()
            && self.touched.iter().any(|value| !known.contains(value))
    }

    /// True if only touched values are uniforms.
    pub(super) fn is_long(&self) -> bool {
        self.live.as_ref().is_some_and(|shader| matches!(shader.live, Live::Touched(_)))
    }

    /// True if an edit cannot be shown by the live shader's uniforms.
    pub(super) fn is_structural(&self, edit: &Edit, look: LookWithLibrary<'_>) -> bool {
        match edit {
            Edit::Group { edits } => edits.iter().any(|edit| self.is_structural(edit, look)),
            edit if Look::is_annotation(edit) => false,
            // Uniforms of a long look are identified by paths, and a group's node lies at many of
            // them.
            Edit::SetValue { graph: GraphId::Definition(_), .. } if self.is_long() => true,
            // Keys of the same targets have all their values in uniforms, except words.
            Edit::SetDirectionKeys { index, keys } => {
                let targets = |keys: &DirectionKeys| -> HashSet<Target> {
                    keys.keys.iter().flat_map(|key| key.values.keys()).cloned().collect()
                };
                let wires =
                    |keys: &DirectionKeys| keys.by.outputs().cloned().collect::<HashSet<_>>();
                let is_other = |old: &DirectionKeys| {
                    targets(old) != targets(keys) || wires(old) != wires(keys)
                };
                look.look.direction_keys.get(*index).is_none_or(is_other)
            }
            Edit::SetTimeKeys { index, keys } => {
                let is_word = keys.keys.iter().any(|key| matches!(&key.value, Value::Text(_)));
                is_word
                    || look.look.time_keys.get(*index).is_none_or(|old| old.target != keys.target)
            }
            Edit::SetLight { id, light } => look
                .look
                .lights
                .get(id)
                .is_none_or(|old| (old.kind, &old.name) != (light.kind, &light.name)),
            Edit::SetValue { graph, id, port, .. } => {
                let node = look.look.graph_of(graph).and_then(|graph| graph.nodes.get(id));
                let Some((node, kind)) = node.and_then(|node| Some((node, look.catalog.of(node)?)))
                else {
                    return true;
                };
                let Some(port) = kind.input(port.as_str()).map(|index| &kind.inputs[index]) else {
                    return true;
                };
                let had_one = node.values.contains_key(&port.name)
                    || matches!(port.fallback, Fallback::Value(_));
                port.ty.is_setting() || !had_one
            }
            _ => true,
        }
    }

    /// Remembers the inputs that an edit sets.
    pub(super) fn touch(&mut self, edit: &Edit) {
        match edit {
            Edit::Group { edits } => edits.iter().for_each(|edit| self.touch(edit)),
            Edit::SetValue { graph: GraphId::Look, id, port, .. } => {
                let value = (NodePath::root(id.clone()), port.clone());
                if !self.touched.contains(&value) {
                    let touched = Arc::make_mut(&mut self.touched);
                    if touched.len() >= MOST_TOUCHED {
                        touched.clear();
                    }
                    touched.insert(value);
                }
            }
            _ => {}
        }
    }
}

impl Session {
    /// Requests shaders that must be compiled, and takes those that are. `now` is in seconds of the
    /// window's clock. Returns the time until the next call.
    pub(crate) fn tick(&mut self, now: f64) -> Option<Duration> {
        let awaits_nodes = self.awaits_nodes();
        for answer in self.compilation.compiler.answers() {
            self.take(answer);
        }
        if awaits_nodes {
            return None;
        }
        self.hold_suspect();
        if self.journals.held().is_some() {
            return None;
        }
        let revision = self.revision();
        if self.compilation.shaders.seen_revision != revision {
            self.compilation.shaders.seen_revision = revision;
            self.compilation.shaders.changed_at = now;
        }
        let is_another = self.compilation.shaders.requested_structure
            != Some(self.compilation.shaders.structure);
        if is_another || self.compilation.shaders.lacks_a_uniform() {
            self.request(false);
            return None;
        }
        if self.compilation.shaders.requested == Some(revision) {
            return None;
        }
        let rested = now - self.compilation.shaders.changed_at;
        if rested >= BAKE_DELAY {
            self.request(true);
            return None;
        }
        Some(Duration::from_secs_f64((BAKE_DELAY - rested).max(0.01)))
    }

    fn request(&mut self, only_baked: bool) {
        self.compilation.shaders.requested = Some(self.revision());
        self.compilation.shaders.requested_structure = Some(self.compilation.shaders.structure);
        if !only_baked {
            self.compilation.shaders.requested_touched = self.compilation.shaders.touched.len();
        }
        let request = CompileRequest {
            look: match &self.sketchbook.preview {
                Some(preview) => preview.clone(),
                None => {
                    Arc::new(self.view.solo.alone(self.look(), &self.project.catalog).into_owned())
                }
            },
            document: self.revisions.document,
            revision: self.revision(),
            picture: self.look.history.picture_revision(),
            structure: self.compilation.shaders.structure,
            touched: self.compilation.shaders.touched.clone(),
            wire: self.view.wire.clone().map(|wire| {
                let ty = wire.ty(self.look(), &self.project.library, &self.project.catalog);
                (wire, ty)
            }),
            library: self.project.library.clone(),
            only_baked,
            solo: self.view.solo_revision,
            preview: self.sketchbook.preview_revision,
            name: self.name(),
            path: self.look.path.clone(),
        };
        // A waiting request for both shaders must not be lost to one for the baked shader alone.
        self.compilation.compiler.request(|waiting| CompileRequest {
            only_baked: request.only_baked && waiting.is_none_or(|waiting| waiting.only_baked),
            ..request
        });
    }

    fn take(&mut self, CompileAnswer { request, result }: CompileAnswer) {
        let is_current = request.document == self.revisions.document
            && request.structure == self.compilation.shaders.structure;
        let is_current =
            is_current && request.wire.as_ref().map(|(wire, _)| wire) == self.view.wire.as_ref();
        let is_current = is_current
            && request.solo == self.view.solo_revision
            && request.preview == self.sketchbook.preview_revision;
        if !is_current {
            // A newer request is on its way, and the subject of this answer is gone.
            return;
        }
        self.revisions.problems.advance();
        match result {
            Ok(WithWarnings { value: shaders, warnings }) => {
                self.compilation.problems = warnings;
                // Baked anew after an annotation, the picture is the same.
                let picture = Some(request.picture);
                let was = std::mem::replace(&mut self.compilation.shaders.good_picture, picture);
                if shaders.live.is_some() || was != picture {
                    self.revisions.picture.advance();
                }
                if let Some(live) = shaders.live {
                    self.compilation.shaders.live = Some(live);
                    self.compilation.shaders.live_structure = Some(request.structure);
                }
                self.compilation.shaders.baked = Some(shaders.baked);
                self.compilation.shaders.typed = Some(shaders.typed);
                self.key_evaluation.forget();
                self.compilation.shaders.baked_revision = Some(request.revision);
                self.compilation.shaders.good = Some(request.look);
            }
            // The last good picture stays.
            Err(problems) => self.compilation.problems = problems,
        }
        if self.revision() == LookRevision::default() {
            self.look.file.source.locate_all(&mut self.compilation.problems);
        }
    }

    /// True while nodes are being read or shaders compiled, or are done and not taken yet.
    pub fn is_compiling(&self) -> bool {
        self.project.reader.is_awaited() || self.compilation.compiler.owes()
    }

    /// Waits for the project's nodes and the compiler; for tests.
    pub fn wait(&self) {
        self.project.reader.wait();
        self.compilation.compiler.wait();
    }

    /// Takes the present look for the picture, where the live shader can show it.
    pub(crate) fn refresh_shown_look(&mut self) {
        let revision = (self.revisions.document, self.revision());
        let shaders = &self.compilation.shaders;
        if shaders.is_baked(self.revision())
            || !shaders.is_live()
            || self.compilation.shown_revision == revision
        {
            return;
        }
        if let Some(good) = &mut self.compilation.shaders.good {
            *good = Arc::new(
                self.view.solo.alone(self.look.document(), &self.project.catalog).into_owned(),
            );
            self.compilation.shown_revision = revision;
        }
    }

    /// The look to show: as it was last refreshed, by the baked shader where nothing changed since,
    /// else by the live one; or the last look that could be compiled.
    pub(crate) fn showing(&self) -> Option<DrawableLook> {
        let good = self.view.solo.lit(self.compilation.shaders.good.as_ref()?);
        let (shader, live) = match self.compilation.shaders.is_baked(self.revision()) {
            true => (&self.compilation.shaders.baked, Live::Keyed),
            false => (&self.compilation.shaders.live, Live::All),
        };
        Some(DrawableLook { look: good, shader: shader.clone()?, live })
    }
}
