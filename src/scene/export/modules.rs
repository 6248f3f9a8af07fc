//! The modules of an export, and the passes that run them.

use serde::Serialize;

use super::File;
use super::header;
use super::reflect::{self, Bound, EntryPoint, Kind};
use crate::compile::{
    BindingKind, CompiledShader, HostSource, ImageShape, ImageUse, Live, Options, Stage,
    TypedGraph, compile_typed,
};
use crate::diag::Diagnostic;
use crate::library::{Context, SMOOTH_LEVELS};
use crate::wgsl::{self, Valid};

/// The name of the module that draws the look itself.
const DRAW: &str = "draw";

/// A WGSL module with what a host has to know.
pub(super) struct ShaderModule {
    /// `draw`, `normals`, `detail_normals` or `curvature`.
    pub(super) name: &'static str,
    /// What it does, as a sentence.
    pub(super) purpose: &'static str,
    pub(super) entry_points: Vec<EntryPoint>,
    pub(super) bindings: Vec<Bound>,
    /// For each binding.
    pub(super) feeds: Vec<Feed>,
    code: Code,
}

enum Code {
    /// Made from a look.
    Look(Box<Host>),
    /// A file of `shaders/passes`.
    Fixed(String, Box<Valid>),
}

/// What computes a module's `Look` uniform.
pub(super) struct Host {
    pub(super) shader: CompiledShader,
    pub(super) source: HostSource,
    /// The file that holds the functions; `None` where there are none.
    pub(super) file: Option<String>,
}

/// What a host puts into a binding.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "from", rename_all = "snake_case")]
pub enum Feed {
    /// The camera: once a view.
    View,
    /// The object's place: once an object.
    Object,
    /// The members that the module's `host` computes: once an object and frame.
    Look,
    /// One of `images`.
    Image {
        /// Its index.
        image: usize,
    },
    /// The sampler of one of `images`.
    Sampler {
        /// Its index.
        image: usize,
    },
    /// What an earlier pass has drawn, at the same size.
    Pass {
        /// The pass.
        pass: &'static str,
        /// Its output.
        output: &'static str,
    },
    /// The numbers of the curvature pass: once a view.
    Curvature,
    /// What earlier passes have drawn, as each pass's `inputs` say: the module runs in several.
    Inputs,
}

/// One step of drawing a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pass {
    /// Its name.
    pub name: &'static str,
    /// The module that it runs.
    pub module: &'static str,
    /// `meshes`: every mesh, depth-tested. `screen`: one triangle over the whole target, made from
    /// the vertex index.
    pub draws: &'static str,
    /// The textures that it reads from earlier passes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<PassInput>,
    /// What it draws into, in the order of locations.
    pub outputs: Vec<Target>,
}

/// A texture that a pass reads from an earlier one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassInput {
    /// The module's binding.
    pub binding: String,
    /// The earlier pass.
    pub pass: &'static str,
    /// Its output.
    pub output: &'static str,
}

/// What a pass draws into.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Target {
    /// Its name.
    pub name: &'static str,
    /// A WebGPU format; `any` for the host's own color target.
    pub format: &'static str,
    /// What it is cleared to.
    pub clear: [f64; 4],
}

const NORMAL_TARGETS: [Target; 2] = [
    Target { name: "normal", format: "rgba32float", clear: [0.0; 4] },
    Target { name: "depth", format: "r32float", clear: [0.0; 4] },
];
const CURVATURE_TARGET: Target = Target { name: "curvature", format: "r32float", clear: [0.0; 4] };
const COLOR_TARGET: Target = Target { name: "color", format: "any", clear: [0.0; 4] };

/// An image that the look reads, and how it is sampled.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Image {
    /// The file, relative to the look's document.
    pub path: String,
    /// The file beside this description that carries it: an image as it is, or the texture of an
    /// HCBTF as KTX2; none where it could not be read.
    pub file: Option<String>,
    /// `image`: a flat texture. `hcbtf`: an array of flat textures, as they lie in the KTX2 file.
    pub kind: &'static str,
    /// `repeat`, `clamp` or `mirror`.
    pub wrap: String,
    /// `linear` or `nearest`.
    pub filter: String,
    /// `color`, decoded into the look's color space, or `data`, taken as it is. An HCBTF's shader
    /// decodes by itself.
    pub encoding: String,
    /// How the look uses it.
    #[serde(skip)]
    pub(super) used: ImageUse,
}

/// Everything that is drawn.
#[derive(Default)]
pub(super) struct Modules {
    /// The look's name, fit for a comment.
    pub(super) title: String,
    /// Each before those that read what it draws.
    pub(super) modules: Vec<ShaderModule>,
    pub(super) passes: Vec<Pass>,
    pub(super) images: Vec<Image>,
    pub(super) warnings: Vec<Diagnostic>,
}

impl ShaderModule {
    pub(super) fn is_draw(&self) -> bool {
        self.name == DRAW
    }

    pub(super) fn wgsl(&self) -> &str {
        match &self.code {
            Code::Look(host) => &host.shader.wgsl,
            Code::Fixed(text, _) => text,
        }
    }

    pub(super) fn valid(&self) -> &Valid {
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
        images: &mut Vec<Image>,
    ) -> Self {
        let source = shader.host.source();
        let file = match name {
            DRAW => format!("{stem}.prepare.wgsl"),
            _ => format!("{stem}.{name}.prepare.wgsl"),
        };
        let file = (!source.wgsl.is_empty()).then_some(file);
        let bindings = reflect::bindings(&shader.valid.module);
        let feeds = bindings.iter().map(|bound| feed(&shader, bound, images)).collect();
        let entry_points = reflect::entry_points(&shader.valid.module);
        let code = Code::Look(Box::new(Host { shader, source, file }));
        Self { name, purpose, entry_points, bindings, feeds, code }
    }

    fn fixed(name: &'static str, purpose: &'static str) -> Result<Self, Vec<Diagnostic>> {
        let linked = wgsl::pass(name)?;
        let valid = wgsl::parse(&linked.text).map_err(|error| {
            vec![Diagnostic::error("internal-invalid-wgsl", format!("{name}: {error}"))]
        })?;
        let bindings = reflect::bindings(&valid.module);
        let feeds = bindings.iter().map(|bound| match bound.kind {
            Kind::Texture => Feed::Inputs,
            _ => Feed::Curvature,
        });
        let feeds = feeds.collect();
        let entry_points = reflect::entry_points(&valid.module);
        Ok(Self {
            name,
            purpose,
            entry_points,
            bindings,
            feeds,
            code: Code::Fixed(linked.text, Box::new(valid)),
        })
    }
}

fn feed(shader: &CompiledShader, bound: &Bound, images: &mut Vec<Image>) -> Feed {
    let mut image = |index: usize| {
        let used = &shader.needs.images[index];
        let image = Image {
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
        // Which node read it first does not matter.
        let same = |known: &Image| {
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
        Some(BindingKind::Curvature) => Feed::Pass { pass: "curvature", output: "curvature" },
        Some(BindingKind::CurvatureSparse) => {
            Feed::Pass { pass: "curvature_sparse", output: "curvature" }
        }
        Some(BindingKind::CurvatureDetailSparse) => {
            Feed::Pass { pass: "detail_curvature_sparse", output: "curvature" }
        }
        Some(BindingKind::CurvatureDetail) => {
            Feed::Pass { pass: "detail_curvature", output: "curvature" }
        }
        Some(BindingKind::CurvatureTensor) => {
            Feed::Pass { pass: "curvature_tensor", output: "curvature" }
        }
        Some(BindingKind::SmoothNormal(level)) => {
            let pass =
                OVER_NORMALS.iter().find(|pass| pass.context == Context::SmoothNormal(*level));
            pass.map_or(Feed::Inputs, |pass| Feed::Pass { pass: pass.pass, output: "normal" })
        }
        // Neither is in a module that draws meshes.
        Some(BindingKind::Samples) | None => Feed::Inputs,
    }
}

/// A pass over normals.
#[derive(Clone, Copy)]
struct OverNormals {
    /// What a look reads for it.
    context: Context,
    pass: &'static str,
    module: &'static str,
    /// The pass that draws the normals and depths that it reads.
    normals: &'static str,
    /// The pass whose normals it reads in place of those.
    before: Option<&'static str>,
}

impl OverNormals {
    const fn of(
        context: Context,
        pass: &'static str,
        module: &'static str,
        normals: &'static str,
    ) -> Self {
        Self { context, pass, module, normals, before: None }
    }

    const fn smooth(level: u8, name: &'static str, before: Option<&'static str>) -> Self {
        Self { before, ..Self::of(Context::SmoothNormal(level), name, name, "normals") }
    }

    /// Whether a look reads it, or what is made from it.
    fn is_wanted(&self, reads: &dyn Fn(Context) -> bool) -> bool {
        match self.context {
            Context::SmoothNormal(level) => {
                (level..=SMOOTH_LEVELS).any(|level| reads(Context::SmoothNormal(level)))
            }
            context => reads(context),
        }
    }

    fn output(&self) -> Target {
        match self.context {
            Context::SmoothNormal(_) => NORMAL_TARGETS[0],
            Context::Tensor => Target { format: NORMAL_TARGETS[0].format, ..CURVATURE_TARGET },
            _ => CURVATURE_TARGET,
        }
    }
}

const OVER_NORMALS: [OverNormals; 9] = [
    OverNormals::of(Context::Kappa, "curvature", "curvature", "normals"),
    OverNormals::of(Context::KappaSparse, "curvature_sparse", "curvature_sparse", "normals"),
    OverNormals::of(Context::KappaDetail, "detail_curvature", "curvature", "detail_normals"),
    OverNormals::of(
        Context::KappaDetailSparse,
        "detail_curvature_sparse",
        "curvature_sparse",
        "detail_normals",
    ),
    OverNormals::of(Context::Tensor, "curvature_tensor", "curvature_tensor", "normals"),
    OverNormals::smooth(1, "smooth_normals_1", None),
    OverNormals::smooth(2, "smooth_normals_2", Some("smooth_normals_1")),
    OverNormals::smooth(3, "smooth_normals_3", Some("smooth_normals_2")),
    OverNormals::smooth(4, "smooth_normals_4", Some("smooth_normals_3")),
];

/// The modules of these passes, with what they are for.
const OVER_NORMALS_MODULES: [(&str, &str); 7] = [
    ("curvature", "Finds curvature from normals and depth."),
    ("curvature_sparse", "Finds curvature from normals and depth of four neighbours alone."),
    ("curvature_tensor", "Finds curvature by direction from normals and depth."),
    ("smooth_normals_1", "Smooths normals from neighbours two steps away."),
    ("smooth_normals_2", "Smooths normals further, from neighbours four steps away."),
    ("smooth_normals_3", "Smooths normals further, from neighbours eight steps away."),
    ("smooth_normals_4", "Smooths normals further, from neighbours sixteen steps away."),
];

/// Compiles a look's modules and plans its passes.
pub(super) fn compile(typed: &TypedGraph, stem: &str) -> Result<Modules, Vec<Diagnostic>> {
    let stage = |stage| {
        let options = Options { live: Live::Exposed, stage, ..Options::default() };
        compile_typed(typed, &options, Vec::new())
    };
    let draw = stage(Stage::Draw)?;
    let reads = |context| draw.needs.context(context);
    let over_normals =
        OVER_NORMALS.iter().filter(|pass| pass.is_wanted(&reads)).copied().collect::<Vec<_>>();
    let wants = |normals| over_normals.iter().any(|pass| pass.normals == normals);
    let mut found = Modules { title: header::title(&typed.name), ..Modules::default() };
    if wants("normals") {
        let purpose = "Draws normals and depth, for the curvature pass.";
        let normals = stage(Stage::Normals)?;
        found.modules.push(ShaderModule::of_look(
            "normals",
            purpose,
            normals,
            stem,
            &mut found.images,
        ));
        found.passes.push(Pass::meshes("normals", &NORMAL_TARGETS));
    }
    if wants("detail_normals") {
        let purpose = "Draws detail normals and depth, for the curvature pass.";
        let normals = stage(Stage::DetailNormals)?;
        found.modules.push(ShaderModule::of_look(
            "detail_normals",
            purpose,
            normals,
            stem,
            &mut found.images,
        ));
        found.passes.push(Pass::meshes("detail_normals", &NORMAL_TARGETS));
    }
    found.add_over_normals(&over_normals)?;
    let draw = ShaderModule::of_look(
        DRAW,
        "Draws a mesh with the look; the result is straight RGBA.",
        draw,
        stem,
        &mut found.images,
    );
    let inputs = draw.bindings.iter().zip(&draw.feeds).filter_map(|(bound, feed)| match feed {
        Feed::Pass { pass, output } => {
            Some(PassInput { binding: bound.name.clone(), pass, output })
        }
        _ => None,
    });
    found.passes.push(Pass { inputs: inputs.collect(), ..Pass::meshes(DRAW, &[COLOR_TARGET]) });
    found.modules.push(draw);
    Ok(found)
}

impl Pass {
    fn meshes(name: &'static str, outputs: &[Target]) -> Self {
        Self { name, module: name, draws: "meshes", inputs: Vec::new(), outputs: outputs.to_vec() }
    }
}

impl Modules {
    fn add_over_normals(&mut self, wanted: &[OverNormals]) -> Result<(), Vec<Diagnostic>> {
        for (name, purpose) in OVER_NORMALS_MODULES {
            let passes: Vec<_> = wanted.iter().filter(|pass| pass.module == name).collect();
            if passes.is_empty() {
                continue;
            }
            let module = ShaderModule::fixed(name, purpose)?;
            for wanted in passes {
                let textures = module.bindings.iter().filter(|bound| bound.kind == Kind::Texture);
                let inputs = textures.map(|bound| {
                    let (pass, output) = match wanted.before {
                        _ if bound.name.contains("depth") => (wanted.normals, "depth"),
                        before => (before.unwrap_or(wanted.normals), "normal"),
                    };
                    PassInput { binding: bound.name.clone(), pass, output }
                });
                self.passes.push(Pass {
                    name: wanted.pass,
                    module: name,
                    draws: "screen",
                    inputs: inputs.collect(),
                    outputs: vec![wanted.output()],
                });
            }
            self.modules.push(module);
        }
        Ok(())
    }

    /// The functions that hosts call, one file for each module that has any.
    pub(super) fn prepare_files(&self) -> Vec<File> {
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
            Some(File::text(host.file.clone()?, header::comment(&lines) + "\n" + &host.source.wgsl))
        };
        self.modules.iter().filter_map(file).collect()
    }
}
