//! Matrix of lights and objects, resolved as rendering and `chiaro lights --matrix` resolve it, on
//! a thread of its own: the looks that an object wears follow from its mesh.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use indexmap::IndexMap;

use super::ObjectRow;
use super::layer::{LayerRow, LayerStates, ObjectLayers, layers_of};
use super::relation::Relation;
use crate::document::{Light, LightLink, LinkRule};
use crate::frame::{Assets, Setup};
use crate::ids::{LightId, ObjectId};
use crate::library::Library;
use crate::state::revision::{DocumentNumber, LookRevision, PictureRevision};
use crate::state::session::Session;
use crate::state::snapshot::RenderSnapshot;
use crate::state::worker::{BackgroundJobs, Worker};

/// Most pairs of a light and an object that are resolved for the window.
const MOST_PAIRS: usize = 1_000_000;
/// Most of these whose objects' layers are resolved too.
const MOST_PAIRS_WITH_LAYERS: usize = 50_000;

/// State of the documents that a matrix is of.
type MatrixKey = (DocumentNumber, LookRevision, Option<PictureRevision>);

/// Relation of a light to an object, with the rule that decides in words.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LinkState {
    pub(super) is_so: bool,
    pub(super) rule: String,
}

/// Lights and objects of a setup, with what decides between each two.
#[derive(Debug, Default)]
pub(super) struct LinkMatrix {
    /// Lights that reach objects, and those that do not; a light that no look of the object has is
    /// not there.
    reach: HashMap<ObjectId, IndexMap<LightId, LinkState>>,
    /// Lights whose shadows an object casts or not, and objects that it casts them onto.
    casts: IndexMap<ObjectId, (IndexMap<LightId, LinkState>, BTreeSet<ObjectId>)>,
    /// Layers of the objects' looks, with the lights that they are about.
    layers: ObjectLayers,
    /// True if there are too many lights and objects to resolve layers here.
    pub(super) has_no_layers: bool,
    /// True if there are too many lights and objects to resolve them here.
    pub(super) is_too_large: bool,
}

impl LinkMatrix {
    /// Resolves a setup at a time, in seconds.
    fn of(setup: &Setup, library: &Library, time: f64) -> Self {
        let lights = setup.all_lights();
        let pairs = lights.len().saturating_mul(setup.objects.len());
        if pairs > MOST_PAIRS {
            return Self { is_too_large: true, ..Self::default() };
        }
        let has_no_layers = pairs > MOST_PAIRS_WITH_LAYERS;
        let mut matrix = Self { has_no_layers, ..Self::default() };
        if !matrix.has_no_layers {
            matrix.layers = layers_of(setup, library, time);
        }
        for found in setup.light_reach() {
            let state = LinkState { is_so: found.reaches, rule: found.words };
            matrix.reach.entry(found.object).or_default().insert(found.light, state);
        }
        for object in &setup.objects {
            let shadow = &object.shadow_link;
            let link =
                LightLink { linked: shadow.shadowed.clone(), unlinked: shadow.unshadowed.clone() };
            let states = shadow_states(&link, &lights);
            let onto = shadow.objects(&setup.scene.objects);
            matrix.casts.insert(object.id.clone(), (states, onto));
        }
        matrix
    }

    /// Relation of a light to an object; `None` where neither is there for the other.
    pub(super) fn state(
        &self,
        relation: Relation,
        object: &ObjectId,
        light: &LightId,
    ) -> Option<&LinkState> {
        match relation {
            Relation::Light => self.reach.get(object)?.get(light),
            Relation::Shadow => self.casts.get(object)?.0.get(light),
        }
    }

    /// Relation of a light to a row: to an object, or to a layer of one.
    pub(super) fn row_state(
        &self,
        relation: Relation,
        row: &ObjectRow,
        light: &LightId,
    ) -> Option<&LinkState> {
        match row {
            ObjectRow::Object(object) => self.state(relation, object, light),
            ObjectRow::Layer(object, layer) => {
                self.layers.get(object)?.get(layer)?.states.get(light)
            }
        }
    }

    /// Layers of an object.
    pub(super) fn layers(
        &self,
        object: &ObjectId,
    ) -> impl Iterator<Item = (&LayerRow, &LayerStates)> {
        self.layers.get(object).into_iter().flatten()
    }

    /// Display name of a layer.
    pub(super) fn layer_name(&self, object: &ObjectId, layer: &LayerRow) -> &str {
        let found = self.layers.get(object).and_then(|layers| layers.get(layer));
        found.map_or("", |layer| layer.name.as_str())
    }

    /// Names of the layers that a light does not reach, although it reaches their object.
    pub(super) fn dark_layers(&self, object: &ObjectId, light: &LightId) -> Vec<&str> {
        let is_lit = self.state(Relation::Light, object, light).is_some_and(|state| state.is_so);
        let is_dark = |(row, layer): &(&LayerRow, &LayerStates)| {
            !row.is_filter && layer.states.get(light).is_some_and(|state| !state.is_so)
        };
        let all = self.layers(object).filter(|_| is_lit).filter(is_dark);
        all.map(|(_, layer)| layer.name.as_str()).collect()
    }

    /// Number of visible objects.
    pub(super) fn object_count(&self) -> usize {
        self.casts.len()
    }

    /// Objects that cast a light's shadow onto an object, where the light reaches it.
    pub(super) fn casters(&self, object: &ObjectId, light: &LightId) -> Vec<&ObjectId> {
        let is_lit = self.state(Relation::Light, object, light).is_some_and(|state| state.is_so);
        let casts = |(states, onto): &(IndexMap<LightId, LinkState>, BTreeSet<ObjectId>)| {
            onto.contains(object) && states.get(light).is_some_and(|state| state.is_so)
        };
        let all = self.casts.iter().filter(|_| is_lit);
        all.filter(|(_, found)| casts(found)).map(|(id, _)| id).collect()
    }
}

/// Relation of each light to an object that casts shadows by a link.
fn shadow_states(
    link: &LightLink,
    lights: &IndexMap<LightId, Light>,
) -> IndexMap<LightId, LinkState> {
    let state = |rule| LinkState {
        is_so: rule == LinkRule::Linked,
        rule: Relation::Shadow.words(link, rule),
    };
    link.rules(lights).into_iter().map(|(id, rule)| (id, state(rule))).collect()
}

/// Thread that resolves matrices, and the last one.
pub(super) struct MatrixSource {
    worker: Worker<RenderSnapshot, Option<Arc<LinkMatrix>>>,
    asked: Option<MatrixKey>,
    matrix: Arc<LinkMatrix>,
}

impl MatrixSource {
    /// `wake` is called from the thread for each answer.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let worker = Worker::new("links", wake, |snapshot: RenderSnapshot| {
            let setup = snapshot.setup(&mut Assets::of(&snapshot.assets)).ok()?;
            Some(Arc::new(LinkMatrix::of(&setup.value, &snapshot.library, snapshot.time)))
        });
        Self { worker, asked: None, matrix: Arc::default() }
    }

    /// The matrix of the last state of the documents that was resolved; a newer state is asked for.
    pub(super) fn matrix(&mut self, session: &Session) -> Arc<LinkMatrix> {
        for matrix in self.worker.answers() {
            self.matrix = matrix.unwrap_or_default();
        }
        let key = (session.revisions().document, session.revision(), session.scene_revision());
        if self.asked != Some(key) {
            self.asked = Some(key);
            let snapshot = session.snapshot_of(Arc::new(session.look().clone()));
            self.worker.request(|_| snapshot);
        }
        self.matrix.clone()
    }
}

impl BackgroundJobs for MatrixSource {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}
