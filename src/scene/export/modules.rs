//! The modules of an export, and the passes that run them.

use std::collections::HashMap;

use chiaro_locale::{tr, tr_in};
use serde::Serialize;

use super::ExportFile;
use super::header;
use super::reflect::{self, BindingType, BoundVariable, EntryPoint};
use super::tiers::{carried, sends_rays};
use crate::compile::{
    AlphaCutoff, BindingKind, CompileOptions, CompiledShader, HostSource, ImageShape, ImageUse,
    Live, ParamId, Stage, TypedGraph, TypedNode, compile_typed,
};
use crate::diag::Diagnostic;
use crate::frame::{LightModule, ScreenModule};
use crate::library::{PassId, PassOutput};
use crate::wgsl::ValidModule;

/// A WGSL module with everything that a host has to know of it.
pub(super) struct ShaderModule {
    /// Slug of the module's pass, or the name that several passes share.
    pub(super) name: &'static str,
    /// Purpose of the module, as a sentence.
    pub(super) purpose: &'static str,
    pub(super) entry_points: Vec<EntryPoint>,
    pub(super) bindings: Vec<BoundVariable>,
    /// Feeds of the bindings, in their order.
    pub(super) feeds: Vec<Feed>,
    code: Code,
}

enum Code {
    /// A module made from a look.
    Look(Box<Host>),
    /// A module from a file of `shaders/passes`: its text, and naga's form of it.
    Fixed(String, Box<ValidModule>),
}

/// Program that computes a module's `Look` uniform.
pub(super) struct Host {
    pub(super) shader: CompiledShader,
    pub(super) source: HostSource,
    /// Name of the file that holds the functions; `None` where there are none.
    pub(super) file: Option<String>,
}

/// Content that a host puts into a binding.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "from", rename_all = "snake_case")]
pub enum Feed {
    /// The camera: set once a view.
    View,
    /// The object's place: set once an object.
    Object,
    /// The members that the module's `host` computes: set once an object and frame.
    Look,
    /// An image of `images`.
    Image {
        /// Index of the image.
        image: usize,
    },
    /// The sampler of one of `images`.
    Sampler {
        /// Index of the image.
        image: usize,
    },
    /// The result of an earlier pass, at the same size.
    Pass {
        /// Name of the pass.
        pass: &'static str,
        /// Name of the pass's output.
        output: &'static str,
    },
    /// The numbers of the view that the module of a pass over the picture asks for: set once a
    /// view. Hosts know them by the name of the first such passes.
    #[serde(rename = "curvature")]
    Numbers,
    /// A layer of what lights see: set once a layer.
    LightLayer,
    /// An object that casts shadows: set once an object.
    LightCaster,
    /// The results of earlier passes that each pass's `inputs` name: the module runs in several
    /// passes.
    Inputs,
}

/// A pass: one step of drawing a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExportPass {
    /// Name of the pass.
    pub name: &'static str,
    /// Module that the pass runs.
    pub module: &'static str,
    /// Geometry that is drawn. `meshes`: every mesh, depth-tested. `screen`: one triangle over the
    /// whole target, made from the vertex index. `lights`: every mesh that casts shadows, both
    /// sides, depth-tested, into each layer of a square array, whatever the picture's size: one for
    /// a directional light, six for a lamp.
    pub draws: &'static str,
    /// Sides of the triangles of meshes that are drawn while parameters have their defaults; left
    /// out where no meshes are drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sides: Option<DrawnSides>,
    /// Parameter that decides about `sides`, by index: both sides are drawn while it is above 0,
    /// front sides otherwise. Left out where `sides` never changes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sides_parameter: Option<usize>,
    /// Textures that the pass reads from earlier passes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<PassInput>,
    /// Targets that the pass draws into, in the order of locations.
    pub outputs: Vec<ExportTarget>,
}

/// Sides of triangles that a pass draws. A triangle shows its front where its corners run counter-
/// clockwise in the picture; clockwise where the model matrix mirrors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DrawnSides {
    /// Front sides of closed meshes that the eye is outside of, both sides of all others.
    Front,
    /// Both sides of every mesh: the look cuts parts away, and the back is seen through them.
    Both,
}

/// A texture that a pass reads from an earlier one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassInput {
    /// Name of the module's binding.
    pub binding: String,
    /// Name of the earlier pass.
    pub pass: &'static str,
    /// Name of the earlier pass's output.
    pub output: &'static str,
}

/// A target that a pass draws into.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ExportTarget {
    /// Name of the target.
    pub name: &'static str,
    /// Format of the target in WebGPU; `any` for the host's own color target.
    pub format: &'static str,
    /// Color that the target is cleared to.
    pub clear: [f64; 4],
}

/// An image that the look reads, and how it is sampled.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExportImage {
    /// Path of the image's file, relative to the look's document.
    pub path: String,
    /// File beside this description that carries the image: an image file unchanged, or the texture
    /// of an HCBTF as KTX2; none where the image could not be read.
    pub file: Option<String>,
    /// Kind. `image`: a flat texture. `hcbtf`: an array of flat textures, as they lie in the KTX2
    /// file.
    pub kind: &'static str,
    /// Wrapping: `repeat`, `clamp` or `mirror`.
    pub wrap: String,
    /// Filter: `linear` or `nearest`.
    pub filter: String,
    /// Encoding: `color`, decoded into the look's color space, or `data`, taken unchanged. An
    /// HCBTF's shader decodes by itself.
    pub encoding: String,
    /// Use of the image by the look.
    #[serde(skip)]
    pub(super) used: ImageUse,
}

/// Modules, passes and images of an export.
pub(super) struct Modules {
    /// Name of the look, fit for a comment.
    pub(super) title: String,
    /// Modules, each before those that read its results.
    pub(super) modules: Vec<ShaderModule>,
    pub(super) passes: Vec<ExportPass>,
    pub(super) images: Vec<ExportImage>,
    /// Sides that meshes show while parameters have their defaults.
    sides: DrawnSides,
    /// True if every pixel that the look draws has alpha 1.
    pub(super) is_opaque: bool,
    /// Value that decides whether the look cuts parts of its surface away.
    pub(super) cutoff: Option<ParamId>,
}

impl ShaderModule {
    pub(super) fn is_draw(&self) -> bool {
        self.host().is_some_and(|host| host.shader.stage.is_picture())
    }

    pub(super) fn wgsl(&self) -> &str {
        match &self.code {
            Code::Look(host) => &host.shader.wgsl,
            Code::Fixed(text, _) => text,
        }
    }

    pub(super) fn valid(&self) -> &ValidModule {
        match &self.code {
            Code::Look(host) => &host.shader.valid,
            Code::Fixed(_, valid) => valid,
        }
    }

    pub(super) fn host(&self) -> Option<&Host> {
        match &self.code {
            Code::Look(host) => Some(host),
            Code::Fixed(..) => None,
        }
    }

    fn of_look(
        name: &'static str,
        purpose: &'static str,
        shader: CompiledShader,
        stem: &str,
        images: &mut Vec<ExportImage>,
    ) -> Self {
        let source = shader.host.source();
        let middle = if shader.stage.is_picture() { String::new() } else { format!(".{name}") };
        let file = format!("{stem}{middle}.prepare.wgsl");
        let file = (!source.wgsl.is_empty()).then_some(file);
        let bindings = reflect::bindings(&shader.valid.module);
        let feeds = bindings.iter().map(|bound| feed(&shader, bound, images)).collect();
        let entry_points = reflect::entry_points(&shader.valid.module);
        let code = Code::Look(Box::new(Host { shader, source, file }));
        Self { name, purpose, entry_points, bindings, feeds, code }
    }

    /// The module of a pass that draws what lights see; `None` for other passes.
    fn of_lights(pass: PassId) -> Result<Option<Self>, Vec<Diagnostic>> {
        let feed = |bound: &BoundVariable| match (bound.kind, bound.binding) {
            (BindingType::Texture, _) => Feed::Inputs,
            (_, 0) => Feed::LightLayer,
            _ => Feed::LightCaster,
        };
        let module = LightModule::of(pass)?;
        Ok(module.map(|module| Self::fixed(pass, module.text, module.valid, feed)))
    }

    /// The module of a pass over the whole picture; `None` where the pass draws meshes.
    fn of_screen(pass: PassId) -> Result<Option<Self>, Vec<Diagnostic>> {
        let feed = |bound: &BoundVariable| match bound.kind {
            BindingType::Texture => Feed::Inputs,
            _ => Feed::Numbers,
        };
        let module = ScreenModule::of(pass)?;
        Ok(module.map(|module| Self::fixed(pass, module.text, module.valid, feed)))
    }

    /// A pass's module from a file of `shaders/passes`, with the feed of each binding.
    fn fixed(
        pass: PassId,
        text: String,
        valid: ValidModule,
        feed: impl Fn(&BoundVariable) -> Feed,
    ) -> Self {
        let bindings = reflect::bindings(&valid.module);
        Self {
            name: pass.row().module(),
            purpose: pass.row().help,
            entry_points: reflect::entry_points(&valid.module),
            feeds: bindings.iter().map(feed).collect(),
            bindings,
            code: Code::Fixed(text, Box::new(valid)),
        }
    }
}

fn feed(shader: &CompiledShader, bound: &BoundVariable, images: &mut Vec<ExportImage>) -> Feed {
    let mut image = |index: usize| {
        let used = &shader.needs.images[index];
        let image = ExportImage {
            path: used.path.clone(),
            file: None,
            kind: match used.shape {
                ImageShape::Flat => "image",
                ImageShape::Hcbtf { .. } => "hcbtf",
            },
            wrap: used.wrap.clone(),
            filter: used.filter.clone(),
            encoding: used.encoding.clone(),
            used: used.clone(),
        };
        // Uses that differ only in the node that reads the image are the same.
        let same = |known: &ExportImage| {
            known.used == ImageUse { node: known.used.node.clone(), ..used.clone() }
        };
        images.iter().position(same).unwrap_or_else(|| {
            images.push(image);
            images.len() - 1
        })
    };
    let binding = shader.bindings.iter().find(|binding| binding.name == bound.name);
    match binding.map(|binding| &binding.kind) {
        Some(BindingKind::View) => Feed::View,
        Some(BindingKind::Object) => Feed::Object,
        Some(BindingKind::Look) => Feed::Look,
        Some(BindingKind::Image(index) | BindingKind::Hcbtf(index)) => {
            Feed::Image { image: image(*index) }
        }
        Some(BindingKind::Sampler(index)) => Feed::Sampler { image: image(*index) },
        Some(BindingKind::Pass(pass)) => {
            let row = pass.row();
            Feed::Pass { pass: row.slug, output: row.writes[0].name }
        }
        // A module that draws meshes has no such binding.
        // Looks that read casters are refused.
        Some(BindingKind::Samples | BindingKind::Casters) | None => Feed::Inputs,
    }
}

impl ExportPass {
    fn of(pass: PassId, draws: &'static str, inputs: Vec<PassInput>) -> Self {
        let row = pass.row();
        let target = |output: &PassOutput| ExportTarget {
            name: output.name,
            format: output.format.name(),
            clear: [0.0; 4],
        };
        let outputs = row.writes.iter().map(target).collect();
        let sides = (draws == "lights").then_some(DrawnSides::Both);
        let (name, module) = (row.slug, row.module());
        Self { name, module, draws, sides, sides_parameter: None, inputs, outputs }
    }
}

/// Compiles a look's modules and plans its passes.
pub(super) fn compile(typed: &TypedGraph, stem: &str) -> Result<Modules, Vec<Diagnostic>> {
    let compile = |stage| {
        let options = CompileOptions { live: Live::Exposed, stage, ..CompileOptions::default() };
        compile_typed(typed, &options)
    };
    let draw = compile(Stage::default())?;
    refuse_casters(typed, &draw)?;
    let wanted = wanted(&draw);
    let is_cut = draw.cuts(&HashMap::new());
    let mut found = Modules {
        title: header::title(&typed.name),
        modules: Vec::new(),
        passes: Vec::new(),
        images: Vec::new(),
        is_opaque: draw.opaque_with.as_ref().is_some_and(Vec::is_empty),
        sides: if is_cut { DrawnSides::Both } else { DrawnSides::Front },
        cutoff: if let AlphaCutoff::Param(id) = draw.cutoff { Some(id) } else { None },
    };
    for &pass in &wanted {
        if let Some(module) = ShaderModule::of_lights(pass)? {
            found.add_lights(pass, module);
        } else if let Some(stage) = pass.stage() {
            found.add_meshes(pass, compile(stage)?, stem);
        }
    }
    found.add_screens(&wanted)?;
    found.add_meshes(PassId::LOOK, draw, stem);
    Ok(found)
}

/// Refuses a look whose nodes send rays past the triangles of a scene, which an export has not.
fn refuse_casters(typed: &TypedGraph, draw: &CompiledShader) -> Result<(), Vec<Diagnostic>> {
    if !draw.needs.casters() {
        return Ok(());
    }
    let asks = |node: &&TypedNode| sends_rays(node, node.tier);
    let problems = typed.nodes.iter().filter(asks).map(|node| {
        let hint = match carried(node) {
            Some((word, _)) => {
                tr!("choose its {word} tier, which an export carries: \"tier\": \"{word}\", or \
                 `--tier auto` for all such nodes")
            }
            None => tr!("mute it for the export, and let the program that draws cast the shadow")
                .to_owned(),
        };
        let message = tr!(
            "the node `{node}` ({kind}) sends rays past the meshes of a scene, which an export \
             does not carry",
            node = node.path,
            kind = tr_in("node", &node.def.label)
        );
        Diagnostic::error("export-casters", message).node(node.path.clone()).hint(hint)
    });
    Err(problems.collect())
}

/// The passes before the look that it reads, and the passes that those read in turn.
fn wanted(draw: &CompiledShader) -> Vec<PassId> {
    let read: Vec<PassId> = draw.needs.passes().collect();
    let mut wanted: Vec<PassId> = Vec::new();
    // Passes are visited from the last to the first, so that the readers of a pass are known before
    // it.
    for pass in PassId::all().rev() {
        if read.contains(&pass) || wanted.iter().any(|reader| reader.reads(pass)) {
            wanted.push(pass);
        }
    }
    wanted.reverse();
    wanted
}

impl Modules {
    fn add_meshes(&mut self, pass: PassId, shader: CompiledShader, stem: &str) {
        let row = pass.row();
        let module = ShaderModule::of_look(row.slug, row.help, shader, stem, &mut self.images);
        let inputs = module.bindings.iter().zip(&module.feeds).filter_map(|(bound, feed)| {
            let Feed::Pass { pass, output } = feed else { return None };
            Some(PassInput { binding: bound.name.clone(), pass, output })
        });
        let sides = Some(self.sides);
        self.passes.push(ExportPass { sides, ..ExportPass::of(pass, "meshes", inputs.collect()) });
        self.modules.push(module);
    }

    /// Adds a pass that draws what lights see.
    fn add_lights(&mut self, pass: PassId, module: ShaderModule) {
        let read = pass.row().reads.iter().map(|input| PassInput {
            binding: input.binding.to_owned(),
            pass: input.pass,
            output: input.output,
        });
        self.passes.push(ExportPass::of(pass, "lights", read.collect()));
        self.modules.push(module);
    }

    /// Adds the passes over the whole picture, those of one module side by side.
    fn add_screens(&mut self, wanted: &[PassId]) -> Result<(), Vec<Diagnostic>> {
        for first in PassId::all().filter(|pass| pass.is_screen()) {
            let name = first.row().module();
            let mut passes = wanted.iter().filter(|pass| pass.row().module() == name).peekable();
            if passes.peek().is_none() || self.modules.iter().any(|known| known.name == name) {
                continue;
            }
            let Some(module) = ShaderModule::of_screen(first)? else { continue };
            let is_texture = |name: &str| {
                module.bindings.iter().any(|b| b.kind == BindingType::Texture && b.name == name)
            };
            for &pass in passes {
                let read = pass.row().reads.iter().filter(|input| is_texture(input.binding));
                let inputs = read.map(|input| PassInput {
                    binding: input.binding.to_owned(),
                    pass: input.pass,
                    output: input.output,
                });
                self.passes.push(ExportPass::of(pass, "screen", inputs.collect()));
            }
            self.modules.push(module);
        }
        Ok(())
    }

    /// The files of functions that hosts call, one file for each module that has any.
    pub(super) fn prepare_files(&self) -> Vec<ExportFile> {
        let file = |module: &ShaderModule| {
            let host = module.host()?;
            let lines = [
                format!("{}: made by Chiaro {}, WGSL.", self.title, env!("CARGO_PKG_VERSION")),
                format!(
                    "What turns parameters and lights into the `Look` uniform of the module `{}`,",
                    module.name
                ),
                "called before drawing by the steps of `host` in the JSON file. Run it or port it."
                    .to_owned(),
            ];
            Some(ExportFile::text(
                host.file.clone()?,
                header::comment(&lines) + "\n" + &host.source.wgsl,
            ))
        };
        self.modules.iter().filter_map(file).collect()
    }
}
