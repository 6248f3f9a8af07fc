//! Packages: folders that run where they arrive, with the look's shaders, host work, textures and
//! what shows them.
//!
//! A package is a folder of this module and a line of [`PACKAGES`]. What packages share is made
//! once: `javascript` writes a look's shaders, bindings and host work as one object that their
//! players read.

mod babylon;
mod bevy_crate;
mod blender;
mod godot;
mod javascript;
mod light_table;
mod materials;
mod materialx;
mod numbers;
mod parameter_table;
mod python;
mod rust;
mod stable_id;
mod three;
mod unity;
mod unreal;
mod web;
mod wgpu_crate;

use std::path::Path;
use std::sync::Arc;

use chiaro_locale::{Text, tr};
use glam::DMat4;
use indexmap::IndexSet;
use serde_json::json;

use super::description::{self, Description};
use super::pretty::pretty;
use super::{ExportFile, LANGUAGES, exposed, header, modules, program, textures, tiers};
use crate::compile::{TypedGraph, check};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Camera, Look};
use crate::frame::{Assets, Executor, PlanOptions, PlanStyle, Setup, SetupObject};
use crate::geometry::Mesh;
use crate::library::{Library, Type};
use crate::progress::Progress;

/// A package that looks are exported to.
#[derive(Debug)]
pub struct Package {
    /// Name of the package for `--to`.
    pub slug: &'static str,
    /// Name of the package for people.
    pub label: Text,
    /// Sentence that says what the package is.
    pub help: Text,
    /// File to open after an export, where there is one.
    pub opens: Option<&'static str>,
    /// Program and version that tests run the package with; `None` where the program itself was
    /// never run.
    pub run_with: Option<&'static str>,
    /// True if looks whose tiers are automatic are brought into tiers without passes before the
    /// picture, where there are such: the package draws none.
    is_without_passes: bool,
    write: fn(&PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>>,
}

/// All packages, in the order in which the window lists them.
pub const PACKAGES: &[&Package] = &[
    &web::PACKAGE,
    &three::PACKAGE,
    &babylon::PACKAGE,
    &wgpu_crate::PACKAGE,
    &bevy_crate::PACKAGE,
    &godot::PACKAGE,
    &unity::PACKAGE,
    &unreal::PACKAGE,
    &blender::PACKAGE,
    &materialx::PACKAGE,
];

/// Symbols of papers that texts of nodes mention.
const SYMBOLS: [&str; 3] = ["tau", "f", "c"];

/// The scene that a package shows the look in.
#[derive(Clone, Debug)]
pub struct PackageScene {
    /// Mesh that wears the look.
    pub mesh: Arc<Mesh>,
    /// Matrix from the mesh to the world.
    pub world_from_object: DMat4,
    /// Camera of the first view.
    pub camera: Camera,
    /// Color behind the mesh, straight RGB as shown; `None` for none.
    pub backdrop: Option<[f64; 3]>,
}

/// A request to write a package.
pub(super) struct PackageRequest<'a> {
    /// Name of the look, fit for a comment.
    pub(super) title: &'a str,
    /// Beginning of file names.
    pub(super) stem: &'a str,
    /// The look's document.
    pub(super) look: &'a Look,
    /// Host work of the look.
    pub(super) work: &'a program::HostWork,
    /// The look's nodes as they are checked.
    pub(super) graph: &'a TypedGraph,
    /// The look's modules, for packages that write them in a language of their own.
    pub(super) modules: &'a modules::Modules,
    /// Shaders of the look's modules.
    pub(super) sources: &'a [javascript::Source],
    /// Description of the look.
    pub(super) description: &'a Description,
    /// Images and HCBTFs that the look reads.
    pub(super) textures: &'a [ExportFile],
    /// Scene that shows the look.
    pub(super) scene: &'a PackageScene,
}

impl PackageRequest<'_> {
    /// The look as an ES module, which exports `look`.
    fn module(&self) -> Result<ExportFile, Vec<Diagnostic>> {
        self.javascript_file("export const look = ")
    }

    /// Refuses painted surfaces in BC7 blocks for a `reader` that takes none.
    fn refuse_blocks(&self, reader: &str) -> Result<(), Vec<Diagnostic>> {
        if !self.textures.iter().any(is_in_blocks) {
            return Ok(());
        }
        let message =
            tr!("the look's painted surface lies in BC7 blocks, which {reader} cannot show");
        let help = tr!("export it with `--textures compact`, or choose that storage in its node");
        Err(vec![refusal(message, help)])
    }

    /// Refuses passes before the picture, for a package that has none; `told` is the reason by the
    /// name of the first pass.
    fn refuse_passes(&self, told: impl FnOnce(&str) -> String) -> Result<(), Diagnostic> {
        let mut passes = self.description.passes.iter();
        let Some(pass) = passes.find(|pass| pass.module != "draw") else { return Ok(()) };
        let help =
            tr!("export with `--tier fast`, whose curvature needs none, or `--to web` or `three`");
        Err(refusal(told(pass.name), help))
    }

    /// Refuses images, for the package of a name that carries none; `help` says what does.
    fn refuse_images(&self, package: &str, help: &str) -> Result<(), Diagnostic> {
        if self.description.images.is_empty() {
            return Ok(());
        }
        let message = tr!("the look reads images, which the package {package} does not carry yet");
        Err(refusal(message, help))
    }

    /// Names of the nodes of the picture that take values of these types, each once, in the order
    /// in which they are computed.
    fn nodes_that_take(&self, types: &[Type]) -> IndexSet<String> {
        light_table::nodes_that_take(self.graph, types)
    }

    /// The exposed parameters and the lights as tables of Markdown, for the end of a README.
    fn tables(&self) -> String {
        parameter_table::parameter_table(self.description)
            + &light_table::light_table(self.description, self.graph)
    }

    /// The look as a script that begins with `declaration`, as its first line of code.
    fn javascript_file(&self, declaration: &str) -> Result<ExportFile, Vec<Diagnostic>> {
        let object = javascript::write(self.look, self.description, self.work, self.sources);
        let object = object.map_err(|problem| vec![problem])?;
        let lines = [
            format!("{}: made by Chiaro {}, JavaScript.", self.title, env!("CARGO_PKG_VERSION")),
            "Shaders, parameters, lights, passes and host work of the look.".to_owned(),
        ];
        let text = format!("{}\n{declaration}{object};\n", header::comment(&lines));
        Ok(ExportFile::text(format!("{}.js", self.stem), text))
    }
}

/// True for a KTX2 file whose texels lie in blocks: its format is not Vulkan's 37, RGBA of 8 bits.
fn is_in_blocks(file: &ExportFile) -> bool {
    file.name.ends_with(".ktx2") && file.bytes.get(12..16) != Some(&[37, 0, 0, 0][..])
}

/// The error of a look that a package cannot carry, and what helps.
fn refusal(message: impl Into<String>, help: &str) -> Diagnostic {
    Diagnostic::error("not-in-package", message).hint(help)
}

/// The package that `chiaro export --to` calls `slug`.
pub fn package(slug: &str) -> Option<&'static Package> {
    PACKAGES.iter().copied().find(|package| package.slug == slug)
}

/// Exports `look` as a package whose files' names begin with `stem`. Images and HCBTFs that the
/// look reads, whose paths are relative to `folder`, are read with `assets`. Returns the files to
/// write; no two have the same name.
///
/// # Errors
/// All errors of the look; constructs that the package's languages or its host code cannot express;
/// what the package cannot show, with the reason and what helps.
pub fn export_package(
    look: &Look,
    library: &Library,
    stem: &str,
    package: &Package,
    scene: &PackageScene,
    (folder, assets): (&Path, &mut Assets),
) -> Result<WithWarnings<Vec<ExportFile>>, Vec<Diagnostic>> {
    let (mut own_look, mut own_library);
    let mut told = Vec::new();
    let (look, library) = if package.is_without_passes {
        (own_look, own_library) = (look.clone(), library.clone());
        told =
            tiers::take_tiers_without_passes(&mut own_look, &mut own_library, package.label.tr());
        (&own_look, &own_library)
    } else {
        (look, library)
    };
    let (typed, mut warnings) = check(look, library, None)?.into_parts();
    warnings.extend(told);
    let mut modules = modules::compile(&typed, stem)?;
    let carried = textures::carried(&mut modules.images, stem, folder, assets).tell(&mut warnings);
    let mut written = Vec::new();
    let mut sources = Vec::new();
    let mut problems = Vec::new();
    for language in LANGUAGES.into_iter().filter(|it| javascript::LANGUAGES.contains(&it.slug)) {
        for module in &modules.modules {
            match language.write(module, &modules.title, stem) {
                Ok(found) => {
                    sources.push((language.slug, module.name, found.files));
                    written.push((language, found.described));
                }
                Err(problem) => problems.push(problem),
            }
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let parameters = exposed::parameters(look, library, &typed, &modules);
    let one = |problem: Diagnostic| vec![problem];
    let work = program::build(look, &typed, &modules, &parameters).map_err(one)?;
    let mut description = description::description(look, library, &typed, &modules, &written);
    for parameter in &mut description.parameters {
        parameter.help = without_symbols(&parameter.help);
    }
    let request = PackageRequest {
        title: &modules.title,
        stem,
        look,
        work: &work,
        graph: &typed,
        modules: &modules,
        sources: &sources,
        description: &description,
        textures: &carried,
        scene,
    };
    let mut files = (package.write)(&request)?;
    files.push(manifest(&request, package, &files));
    Ok(WithWarnings::new(files, warnings))
}

/// A text without the symbols that papers have for what it is about: `falls fastest (f).` is
/// `falls fastest.`
fn without_symbols(text: &str) -> String {
    SYMBOLS.iter().fold(text.to_owned(), |text, symbol| text.replace(&format!(" ({symbol})"), ""))
}

/// The list of a package's files, by which the next export knows them as its own.
fn manifest(request: &PackageRequest<'_>, package: &Package, files: &[ExportFile]) -> ExportFile {
    let mut names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    names.push(EXPECTED);
    let description = request.description;
    let text = pretty(&json!({
        "look": description.look,
        "chiaro": description.chiaro,
        "package": package.slug,
        "tiers": description.tiers,
        "files": names,
    }));
    ExportFile::text("chiaro.json".to_owned(), text)
}

/// Name of the picture that a package is expected to show.
pub const EXPECTED: &str = "expected.png";

/// Needs of a look: all that it asks of whoever draws it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LookNeeds {
    /// Labels of the passes before the picture, in order.
    pub passes: Vec<&'static str>,
    /// Number of images.
    pub images: usize,
    /// Number of painted surfaces (HCBTFs).
    pub painted_surfaces: usize,
    /// Number of lights.
    pub lights: usize,
    /// Number of exposed parameters that change the picture.
    pub parameters: usize,
    /// Number of sets and tracks of keys.
    pub keys: usize,
}

impl LookNeeds {
    /// The needs of `look`.
    ///
    /// # Errors
    /// All errors of the look.
    pub fn of(look: &Look, library: &Library) -> Result<Self, Vec<Diagnostic>> {
        let (typed, _) = check(look, library, None)?.into_parts();
        let modules = modules::compile(&typed, "look")?;
        let parameters = exposed::parameters(look, library, &typed, &modules);
        let is_painted = |image: &&modules::ExportImage| image.kind == "hcbtf";
        let painted_surfaces = modules.images.iter().filter(is_painted).count();
        let before = modules.passes.iter().filter(|pass| pass.module != "draw");
        Ok(Self {
            passes: before.map(|pass| pass.name).collect(),
            images: modules.images.len() - painted_surfaces,
            painted_surfaces,
            lights: exposed::lights(look, &modules).len(),
            parameters: parameters.list.iter().filter(|it| it.name.is_some() && it.live).count(),
            keys: look.direction_keys.len() + look.time_keys.len(),
        })
    }
}

/// Draws the picture that a package is expected to show: `setup` before its own camera, 800 by 800
/// pixels, 4 samples a pixel.
///
/// # Errors
/// Those of planning and drawing.
pub async fn draw_expected(
    setup: &Setup,
    library: &Library,
    assets: Assets,
    executor: &mut dyn Executor,
    progress: &Progress,
) -> Result<ExportFile, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let style = PlanStyle::Specialized;
    let mut planner = style.planner(assets);
    let options = PlanOptions { size: [800; 2], samples: 4, time: 0.0 };
    let plan = planner.plan(setup, library, &style.live(), &options)?.value;
    let picture = executor.picture(&plan, progress).await.map_err(one)?;
    let bytes = picture.to_png().map_err(one)?;
    Ok(ExportFile { name: EXPECTED.to_owned(), bytes })
}

impl PackageScene {
    /// The scene of the object that wears the first look of a setup, before the setup's camera.
    /// `None` where no object wears it.
    pub fn of(setup: &Setup) -> Option<Self> {
        let wears = |object: &&SetupObject| object.worn_looks().any(|look| look == 0);
        let object = setup.objects.iter().find(wears)?;
        Some(Self {
            mesh: object.mesh.clone(),
            world_from_object: object.world_from_object,
            camera: setup.scene.camera,
            backdrop: setup.scene.backdrop.map(|color| [color[0], color[1], color[2]]),
        })
    }
}
