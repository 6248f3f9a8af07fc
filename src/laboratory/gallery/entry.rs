//! Entries of a gallery: one document each, drawn, measured and taken apart.

use std::collections::BTreeMap;
use std::collections::HashSet;
use std::sync::Arc;

use super::{GalleryDocument, GalleryOptions};
use crate::accuracy::{BenchOptions, BenchReport, MeasuredNodes, bench};
use crate::compile::Live;
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::Look;
use crate::frame::{Assets, FramePlan, Pass, PlanOptions, Planner, Setup, open};
use crate::library::Library;
use crate::progress::Progress;
use crate::render::{Gpu, Renderer};

/// Content of one document's page.
pub(super) struct GalleryEntry {
    /// The artist's name of the document.
    pub(super) name: String,
    /// Description of the picture and of how the document is built.
    pub(super) about: String,
    /// The document's file name.
    pub(super) file: String,
    /// The picture, as PNG.
    pub(super) png: Vec<u8>,
    pub(super) size: [u32; 2],
    /// Looks that objects wear, each once.
    pub(super) looks: Vec<Look>,
    /// WGSL of each look, by the look's name.
    pub(super) shaders: Vec<(String, String)>,
    pub(super) passes: Vec<Pass>,
    /// Number of uses of each kind of node in the looks.
    pub(super) kinds: BTreeMap<String, usize>,
    /// Costs and errors, if they were asked for.
    pub(super) report: Option<BenchReport>,
    pub(super) triangles: usize,
}

/// A document as it is drawn, with the plan of its picture.
struct DocumentPlan {
    setup: Setup,
    options: PlanOptions,
    plan: FramePlan,
    warnings: Vec<Diagnostic>,
}

impl DocumentPlan {
    /// Reads the document with `assets`, which keep what was read.
    fn new(
        shown: &GalleryDocument,
        library: &Library,
        options: &GalleryOptions,
        assets: &mut Assets,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mesh = options.mesh.as_deref().or(shown.mesh.as_deref());
        let (mut setup, mut warnings) = open(&shown.file, mesh, assets)?.into_parts();
        setup.scene.backdrop = shown.backdrop.or(setup.scene.backdrop);
        shown.place(&mut setup.scene).map_err(|problem| vec![problem])?;
        let time = shown.time.unwrap_or(setup.scene.time.start);
        let options = PlanOptions { size: options.size, samples: options.samples, time };
        let mut planner = Planner::new(std::mem::take(assets));
        let plan = planner.plan(&setup, library, &Live::Keyed, &options);
        *assets = planner.assets;
        let plan = plan?.tell(&mut warnings);
        Ok(Self { setup, options, plan, warnings })
    }
}

/// Passes everything that a page is made of to `sink`: what is drawn, and the page's texts.
pub(super) fn content(
    shown: &GalleryDocument,
    library: &Library,
    options: &GalleryOptions,
    assets: &mut Assets,
    sink: &mut dyn FnMut(&[u8]),
) -> Result<(), Vec<Diagnostic>> {
    let document = DocumentPlan::new(shown, library, options, assets)?;
    document.plan.content(sink);
    let (name, about) = told(shown, &document.setup);
    sink(format!("{name}\n{about}\n{options:?}").as_bytes());
    document.setup.looks.iter().for_each(|worn| sink(worn.look.to_text().as_bytes()));
    Ok(())
}

impl GalleryEntry {
    /// Draws and measures a document.
    pub(super) async fn make(
        shown: &GalleryDocument,
        library: &Library,
        gpu: &Gpu,
        options: &GalleryOptions,
    ) -> Result<WithWarnings<Self>, Vec<Diagnostic>> {
        let DocumentPlan { setup, options: plan_options, plan, warnings } =
            DocumentPlan::new(shown, library, options, &mut Assets::default())?;
        let picture = gpu.executor().picture(&plan, &Progress::new()).await;
        let picture = picture.map_err(|problem| vec![problem])?;
        let png = picture.to_png().map_err(|problem| vec![problem])?;
        let mut seen = HashSet::new();
        let modules = plan.draws.iter().filter(|draw| seen.insert(Arc::as_ptr(&draw.look)));
        let shaders =
            modules.map(|draw| (draw.look_name.clone(), draw.look.wgsl.clone())).collect();
        let report = match options.rounds {
            0 => None,
            rounds => Some(measure(&setup, library, gpu, &plan_options, rounds).await?),
        };
        let looks = looks(&setup);
        let (name, about) = told(shown, &setup);
        let entry = Self {
            name,
            about,
            file: shown
                .file
                .file_name()
                .map(|name| name.to_string_lossy().into_owned())
                .unwrap_or_default(),
            png,
            size: picture.size,
            kinds: kinds(&looks),
            looks,
            shaders,
            passes: plan.passes.clone(),
            report,
            triangles: setup.objects.iter().map(|object| object.mesh.triangle_count()).sum(),
        };
        Ok(WithWarnings::new(entry, warnings))
    }
}

async fn measure(
    setup: &Setup,
    library: &Library,
    gpu: &Gpu,
    plan: &PlanOptions,
    rounds: usize,
) -> Result<BenchReport, Vec<Diagnostic>> {
    let options = BenchOptions {
        plan: PlanOptions { samples: 1, ..plan.clone() },
        rounds,
        nodes: MeasuredNodes::None,
        truth: true,
    };
    let mut renderer = Renderer::new(gpu.clone());
    Ok(bench(setup, library, &mut renderer, &options, &Progress::new()).await?)
}

/// Distinct looks, in the order in which objects wear them.
fn looks(setup: &Setup) -> Vec<Look> {
    let mut looks: Vec<Look> = Vec::new();
    for worn in &setup.looks {
        if !looks.contains(&worn.look) {
            looks.push(worn.look.clone());
        }
    }
    looks
}

fn kinds(looks: &[Look]) -> BTreeMap<String, usize> {
    let mut kinds = BTreeMap::new();
    for look in looks {
        let inner = look.definitions.values().map(|definition| &definition.graph);
        for node in std::iter::once(&look.graph).chain(inner).flat_map(|graph| graph.nodes.values())
        {
            if !look.definitions.contains_key(node.kind.as_str()) {
                *kinds.entry(node.kind.clone()).or_default() += 1;
            }
        }
    }
    kinds
}

/// The document's name and description: a scene's own, or those of the only look that was opened.
fn told(shown: &GalleryDocument, setup: &Setup) -> (String, String) {
    let (mut name, mut about) = (setup.scene.name.clone(), setup.scene.about.clone());
    if let [only] = setup.looks.as_slice() {
        if name.is_empty() {
            name.clone_from(&only.look.name);
        }
        if about.is_empty() {
            about.clone_from(&only.look.about);
        }
    }
    if let Some(own) = &shown.name {
        name.clone_from(own);
    }
    if name.is_empty() {
        name = shown
            .file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
            .unwrap_or_default();
    }
    (name, about)
}
