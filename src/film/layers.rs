//! Layers of pictures: what is asked for, the plans that draw it, and the layers of the file.
//!
//! One draw writes as many layers beside the picture as the executor can; where more are asked for,
//! the rest are drawn by further plans of the same picture. Mattes have plans of their own.

use std::collections::{BTreeSet, HashMap, HashSet};

use chiaro_locale::tr;

use crate::compile::{AovSource, Live, ShadowOutput, check};
use crate::contributions::Contributions;
use crate::cryptomatte::{Cryptomatte, MatteCoverage};
use crate::diag::{Diagnostic, WithWarnings, nearest};
use crate::document::NamedAov;
use crate::exr::{ExrAttribute, ExrLayer};
use crate::frame::{
    AovLayer, AovRequest, Executor, FramePlan, MattePart, Picture, PlanOptions, Planner, Setup,
};
use crate::ids::{NodeId, NodePath, PortName};
use crate::library::Library;
use crate::naming::{free_name, is_legal, legal_name};
use crate::progress::Progress;
use crate::tables::LayerTable;

/// The most layers beside a picture: so many take 3 GB for a frame of HDTV.
const MOST_LAYERS: usize = 128;

/// Names that mattes tell apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MatteKind {
    /// Objects, by their ids.
    Objects,
    /// Looks, by their names.
    Looks,
    /// Materials of meshes, by their names in the files.
    Materials,
    /// Lights, each by its share of what is seen: the strongest first.
    Lights,
}

/// Row of a kind of mattes.
struct MatteRow {
    kind: MatteKind,
    /// Name for people.
    word: &'static str,
    /// Name in files.
    name: &'static str,
}

const MATTES: [MatteRow; 4] = [
    MatteRow { kind: MatteKind::Objects, word: "objects", name: "CryptoObject" },
    MatteRow { kind: MatteKind::Looks, word: "looks", name: "CryptoLook" },
    MatteRow { kind: MatteKind::Materials, word: "materials", name: "CryptoMaterial" },
    MatteRow { kind: MatteKind::Lights, word: "lights", name: "CryptoLight" },
];

impl MatteKind {
    /// The kinds, each with its name for people.
    pub fn all() -> impl Iterator<Item = (&'static str, Self)> {
        MATTES.iter().map(|row| (row.word, row.kind))
    }

    /// Name in files, with which the names of the layers begin.
    pub fn name(self) -> &'static str {
        MATTES.iter().find(|row| row.kind == self).map_or("", |row| row.name)
    }

    /// The name of a part of an object.
    fn name_of(self, setup: &Setup, part: MattePart) -> Option<&str> {
        let object = setup.objects.get(part.object)?;
        Some(match self {
            Self::Objects => object.id.as_str(),
            Self::Looks => {
                let look = (*object.looks.get(part.material)?)?;
                named(&setup.looks.get(look)?.look.name)
            }
            Self::Materials => named(&object.mesh.parts.get(part.material)?.material),
            Self::Lights => return None,
        })
    }
}

/// The name, or the one that Cryptomatte has for things without a name.
fn named(name: &str) -> &str {
    if name.is_empty() { "default" } else { name }
}

/// Layers that are asked for.
#[derive(Clone, Debug, Default)]
pub struct AskedLayers {
    /// Values of looks.
    pub aovs: Vec<AovRequest>,
    /// Mattes.
    pub mattes: Vec<MatteKind>,
    /// Contributions of lights for their matte, by the lights' names.
    pub lights: Vec<AovRequest>,
    /// Tables that are written beside the picture, for values among the layers.
    pub tables: Vec<LayerTable>,
    /// Other statements of the header, such as the names of the tables' files.
    pub notes: Vec<ExrAttribute>,
}

impl AskedLayers {
    /// True if nothing is asked for but the picture.
    pub fn is_empty(&self) -> bool {
        self.aovs.is_empty() && self.mattes.is_empty()
    }

    /// Checks the names of layers, and their number.
    ///
    /// # Errors
    /// `aov` with the reason.
    pub fn check(&self) -> Result<(), Diagnostic> {
        let problem = |message: String| Diagnostic::error("aov", message);
        let mut seen: HashSet<&str> = MatteKind::all().map(|(_, kind)| kind.name()).collect();
        for request in &self.aovs {
            if !is_legal(&request.name) {
                let hint =
                    tr!("use letters, digits and underscores, and no digit at the beginning");
                let message = tr!("`{name}` is no name that compositors take", name = request.name);
                return Err(problem(message).hint(hint));
            }
            if !seen.insert(&request.name) {
                let message = tr!("two layers have the name `{name}`", name = request.name);
                return Err(problem(message).hint(tr!("name each once: --aov NAME=NODE.OUTPUT")));
            }
        }
        if self.aovs.len() > MOST_LAYERS {
            let count = self.aovs.len();
            let message = tr!("{count} layers are more than {MOST_LAYERS}");
            return Err(problem(message).hint(tr!("ask for fewer, or render twice")));
        }
        Ok(())
    }
}

/// Names of one kind of mattes.
#[derive(Clone, Debug)]
struct MatteNames {
    kind: MatteKind,
    names: Vec<String>,
    /// Indices among the names.
    of: HashMap<MattePart, usize>,
}

impl MatteNames {
    /// All names of a scene, whether or not they are seen.
    fn new(kind: MatteKind, setup: &Setup) -> Self {
        let mut names = Vec::new();
        let mut known: HashMap<String, usize> = HashMap::new();
        let mut of = HashMap::new();
        for (object, worn) in setup.objects.iter().enumerate() {
            let parts = (0..worn.looks.len()).map(|material| MattePart { object, material });
            for part in parts {
                let Some(name) = kind.name_of(setup, part) else { continue };
                let next = names.len();
                let index = *known.entry(name.to_owned()).or_insert(next);
                if index == next {
                    names.push(name.to_owned());
                }
                of.insert(part, index);
            }
        }
        Self { kind, names, of }
    }
}

/// Plans of a picture with its layers.
#[derive(Clone, Debug)]
pub struct LayeredPlan {
    /// The plan of the picture and the first layers.
    first: FramePlan,
    /// Plans of the same picture with the other layers.
    further: Vec<FramePlan>,
    /// Plans of mattes, one for each sample of the picture.
    mattes: Vec<FramePlan>,
    names: Vec<MatteNames>,
    /// Number of layers that are written; those that follow are for the matte of lights.
    written: usize,
    /// Lights of the matte of lights, each with the number of its layer.
    lights: Vec<(String, usize)>,
    /// Other statements of the header.
    notes: Vec<ExrAttribute>,
}

impl LayeredPlan {
    /// Plans a picture with the layers that are asked for, at most `most` in one draw.
    ///
    /// # Errors
    /// As [`Planner::plan`], and where no look has what is asked for.
    pub fn new(
        planner: &mut Planner,
        (setup, library, live): (&Setup, &Library, &Live),
        options: &PlanOptions,
        asked: &AskedLayers,
        most: usize,
    ) -> Result<WithWarnings<Self>, Vec<Diagnostic>> {
        let mut aovs = asked.aovs.clone();
        let mut lights = Vec::with_capacity(asked.lights.len());
        for light in &asked.lights {
            let known = aovs.iter().position(|layer| layer.sources == light.sources);
            lights.push((light.name.clone(), known.unwrap_or(aovs.len())));
            if known.is_none() {
                aovs.push(light.clone());
            }
        }
        let mut batches = aovs.chunks(most.max(1));
        planner.aovs = batches.next().unwrap_or_default().to_vec();
        let (first, warnings) = planner.plan(setup, library, live, options)?.into_parts();
        let mut further = Vec::new();
        for batch in batches {
            planner.aovs = batch.to_vec();
            further.push(planner.plan(setup, library, live, options)?.value);
        }
        planner.aovs.clear();
        let kinds = asked.mattes.iter().filter(|kind| **kind != MatteKind::Lights);
        let mattes = if kinds.clone().next().is_none() {
            Vec::new()
        } else {
            planner.plan_mattes(setup, library, live, options)?
        };
        let names = kinds.map(|kind| MatteNames::new(*kind, setup)).collect();
        let written = asked.aovs.len();
        let notes = asked.notes.clone();
        let plan = Self { first, further, mattes, names, written, lights, notes };
        Ok(WithWarnings::new(plan, warnings))
    }

    /// The plan of the picture.
    pub fn picture(&self) -> &FramePlan {
        &self.first
    }

    /// Statements of a file's header about the layers.
    pub fn attributes(&self) -> Vec<ExrAttribute> {
        let matte = |names: &MatteNames| {
            let (name, names) = (names.kind.name(), names.names.clone());
            Cryptomatte { name, names, coverage: MatteCoverage::Samples(Vec::new()) }.attributes()
        };
        let of_lights = (!self.lights.is_empty()).then(|| self.matte_of_lights(&[], &[]));
        let of_lights = of_lights.iter().flat_map(Cryptomatte::attributes);
        let notes = self.notes.iter().cloned();
        self.names.iter().flat_map(matte).chain(of_lights).chain(notes).collect()
    }

    /// True if values of looks are among the layers.
    pub fn has_values(&self) -> bool {
        self.written > 0
    }

    /// All plans.
    pub(super) fn plans(&self) -> impl Iterator<Item = &FramePlan> {
        std::iter::once(&self.first).chain(&self.further).chain(&self.mattes)
    }

    /// Everything that decides on mattes but their plans; `None` where there are none.
    pub(super) fn mattes_key(&self) -> Option<impl std::hash::Hash + '_> {
        let names = self.names.iter().map(|names| (names.kind, names.names.as_slice()));
        let has_mattes = !(self.names.is_empty() && self.lights.is_empty());
        has_mattes.then(|| (names.collect::<Vec<_>>(), &self.lights, self.written))
    }

    /// The matte of lights: of each pixel, each light's share of all contributions.
    fn matte_of_lights(
        &self,
        layers: &[(AovLayer, Vec<[f32; 3]>)],
        coverage: &[f32],
    ) -> Cryptomatte {
        let strengths = self.lights.iter().map(|(_, layer)| {
            let known = layers.get(*layer);
            let numbers = known.map(|(_, numbers)| numbers.as_slice()).unwrap_or_default();
            numbers.iter().map(|&[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b).collect()
        });
        let mut shares: Vec<Vec<f32>> = strengths.collect();
        for (pixel, covered) in coverage.iter().enumerate() {
            let all: f32 = shares.iter().map(|share| share[pixel]).sum();
            let scale = if all > 0.0 { covered / all } else { 0.0 };
            shares.iter_mut().for_each(|share| share[pixel] *= scale);
        }
        Cryptomatte {
            name: MatteKind::Lights.name(),
            names: self.lights.iter().map(|(name, _)| name.clone()).collect(),
            coverage: MatteCoverage::Shares(shares),
        }
    }

    /// Draws the picture and the layers.
    ///
    /// # Errors
    /// As [`Executor::layered`].
    pub async fn draw(
        &self,
        executor: &mut dyn Executor,
        progress: &Progress,
    ) -> Result<DrawnLayers, Diagnostic> {
        let mut drawn = DrawnLayers::default();
        if self.first.aovs.is_empty() && self.mattes.is_empty() {
            drawn.picture = executor.picture(&self.first, progress).await?;
            return Ok(drawn);
        }
        progress.begin(self.plans().count() as u64);
        let made = executor.layered(&self.first, &progress.part(1)).await?;
        drawn.picture = made.picture;
        drawn.layers.extend(self.first.aovs.iter().cloned().zip(made.layers));
        let beside = match executor.beside() {
            Some(beside) => beside,
            None => executor,
        };
        for plan in &self.further {
            let made = beside.layered(plan, &progress.part(1)).await?;
            drawn.layers.extend(plan.aovs.iter().cloned().zip(made.layers));
        }
        let mut samples: Vec<Vec<Option<MattePart>>> = Vec::with_capacity(self.mattes.len());
        for plan in &self.mattes {
            let made = beside.picture(plan, &progress.part(1)).await?;
            samples.push(MattePart::seen(&made).collect());
        }
        let matte = |names: &MatteNames| {
            let index = |part: &Option<MattePart>| names.of.get(part.as_ref()?).copied();
            Cryptomatte {
                name: names.kind.name(),
                names: names.names.clone(),
                coverage: MatteCoverage::Samples(
                    samples.iter().map(|seen| seen.iter().map(index).collect()).collect(),
                ),
            }
        };
        drawn.mattes = self.names.iter().map(matte).collect();
        if !self.lights.is_empty() {
            let coverage: Vec<f32> = drawn.picture.rgba.iter().map(|pixel| pixel[3]).collect();
            drawn.mattes.push(self.matte_of_lights(&drawn.layers, &coverage));
        }
        drawn.layers.truncate(self.written);
        Ok(drawn)
    }
}

/// Picture with its layers and mattes.
#[derive(Clone, Debug, Default)]
pub struct DrawnLayers {
    /// The picture.
    pub picture: Picture,
    /// Layers of values, with three numbers a pixel.
    pub layers: Vec<(AovLayer, Vec<[f32; 3]>)>,
    /// Mattes.
    pub mattes: Vec<Cryptomatte>,
}

impl DrawnLayers {
    /// Number of bytes in memory, about.
    pub fn bytes(&self) -> usize {
        let pixels = self.picture.rgba.len();
        let of_layers = size_of::<[f32; 3]>() * self.layers.len();
        let of_mattes = self.mattes.iter().map(Cryptomatte::bytes_a_pixel).sum::<usize>();
        pixels * (size_of::<[f32; 4]>() + of_layers + of_mattes)
    }

    /// The layers of a file: the picture, values as they are in the looks, and mattes.
    pub fn exr_layers(&self) -> Vec<ExrLayer> {
        let values = self.layers.iter().map(|(layer, numbers)| {
            let channel = |(place, name): (usize, &&str)| {
                ((*name).to_owned(), numbers.iter().map(|pixel| pixel[place]).collect())
            };
            let channels = layer.kind.channels().iter().enumerate().map(channel).collect();
            ExrLayer { name: layer.name.clone(), channels, samples: None }
        });
        let mattes = self.mattes.iter().flat_map(Cryptomatte::layers);
        std::iter::once(ExrLayer::of_picture(&self.picture)).chain(values).chain(mattes).collect()
    }
}

/// The named outputs of all looks, each once, in their order.
pub fn named_outputs(setup: &Setup) -> Vec<AovRequest> {
    let mut requests: Vec<AovRequest> = Vec::new();
    for (look, worn) in setup.looks.iter().enumerate() {
        for NamedAov { name, from } in &worn.look.aovs {
            let source = (Some(look), AovSource::Wire(from.node.clone(), from.port.clone()));
            let name = legal_name(name.as_str());
            match requests.iter_mut().find(|request| request.name == name) {
                Some(request) => request.sources.push(source),
                None => requests.push(AovRequest { name, sources: vec![source] }),
            }
        }
    }
    requests
}

/// The shadows that looks ask for, each light's as a layer of its own.
///
/// # Errors
/// Everything that is wrong with the looks.
pub fn shadow_outputs(
    setup: &Setup,
    library: &Library,
    time: f64,
) -> Result<Vec<AovRequest>, Vec<Diagnostic>> {
    let mut requests: Vec<AovRequest> = Vec::new();
    for look in 0..setup.looks.len() {
        let wearer = setup.objects.iter().find(|object| object.looks.contains(&Some(look)));
        let Some(wearer) = wearer else { continue };
        let shadows = check(&setup.worn(look, wearer, library, time), library, None)?;
        let shadows = shadows.value.shadow_outputs();
        // Shadows of one light that are computed in other ways, such as of another size, get
        // numbers.
        let mut taken = HashSet::new();
        for ShadowOutput { light, caster, source } in shadows {
            let name = match caster {
                "" => format!("shadow_{light}"),
                caster => format!("shadow_{light}_{caster}"),
            };
            let name = free_name(&legal_name(&name), &mut taken);
            let source = (Some(look), source);
            match requests.iter_mut().find(|request| request.name == name) {
                Some(request) => request.sources.push(source),
                None => requests.push(AovRequest { name, sources: vec![source] }),
            }
        }
    }
    Ok(requests)
}

/// The problem of an output without the name of its layer; of a node that no look has with the node
/// that may be meant.
fn without_name(setup: &Setup, problem: Diagnostic, node: &str, port: &str) -> Diagnostic {
    let named = |node: &str| tr!("a layer of an output has a name: --aov {port}={node}.{port}");
    let path = NodePath::parse(node.rsplit_once(':').map_or(node, |(_, node)| node));
    let looks = || setup.looks.iter().map(|worn| &worn.look);
    let Some(outer) =
        path.outermost().filter(|id| looks().all(|it| !it.graph.nodes.contains_key(*id)))
    else {
        return problem.hint(named(node));
    };
    let known: BTreeSet<&str> =
        looks().flat_map(|look| look.graph.nodes.keys()).map(NodeId::as_str).collect();
    match nearest(outer.as_str(), known.iter().copied()).first() {
        Some(near) => {
            let meant = node.replacen(outer.as_str(), near, 1);
            problem.suggest(outer.as_str(), known).hint(named(&meant))
        }
        None => problem.hint(named(node)),
    }
}

/// The layer of an output of a node, from `NAME=NODE.OUTPUT` or `NAME=LOOK:NODE.OUTPUT`, or of an
/// output that a look names.
///
/// # Errors
/// `aov` with the form, and names of looks that are near.
pub fn wire_request(setup: &Setup, text: &str) -> Result<AovRequest, Diagnostic> {
    let form = || {
        Diagnostic::error("aov", tr!("`{text}` names no layer"))
            .hint(tr!("write --aov NAME=NODE.OUTPUT; --list-aovs shows what there is"))
    };
    let Some((name, wire)) = text.split_once('=') else {
        let named = named_outputs(setup);
        let slices = Contributions::all().map(|(name, _)| name.to_owned());
        let names: Vec<String> =
            named.iter().map(|request| request.name.clone()).chain(slices).collect();
        let found = named.into_iter().find(|request| request.name == text);
        return found.ok_or_else(|| match text.rsplit_once('.') {
            Some((node, port)) if is_legal(port) => without_name(setup, form(), node, port),
            _ => form().suggest(text, names.iter().map(String::as_str)),
        });
    };
    let (look, wire) = match wire.rsplit_once(':') {
        Some((look, wire)) => (Some(look), wire),
        None => (None, wire),
    };
    let (node, port) = wire.rsplit_once('.').ok_or_else(form)?;
    if node.is_empty() || port.is_empty() {
        return Err(form());
    }
    let number = |look: &str| {
        let names = || setup.looks.iter().map(|setup| setup.look.name.as_str());
        names().position(|name| name == look).ok_or_else(|| {
            let message = tr!("no object wears a look named `{look}`");
            Diagnostic::error("unknown-look", message).suggest(look, names())
        })
    };
    let look = look.map(number).transpose()?;
    let source = AovSource::Wire(NodePath::parse(node), PortName::new(port));
    Ok(AovRequest { name: name.to_owned(), sources: vec![(look, source)] })
}
