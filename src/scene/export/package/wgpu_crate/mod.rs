//! The package `wgpu`: a crate with the look as a material.
//!
//! Files of the crate are templates of `template/`, whose sections stay where a look needs them:
//! nobody is given code that their look does not run. `look.rs` is the look itself, a table of its
//! passes ([`tables`]); `host.rs` its host work, translated; `material.rs` what draws it. Uniforms
//! of a frame lie in one buffer, which is used again when nothing needs it any more: two pictures
//! of one material may be drawn in one submission.

mod scene;
mod shader;
mod tables;

use chiaro_locale::{text, tr};

use super::super::ExportFile;
use super::rust::{
    HostModule, LOOK, Lights, MATH, Parameters, SHADOW_MAPS, Template, UNIFORMS, Values,
    crate_name, image_files, plain, structure, wide,
};
use super::{Package, PackageRequest, refusal};
use crate::diag::Diagnostic;
use crate::document::ColorSpace;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "wgpu",
    label: text!("wgpu crate"),
    help: text!("A Rust crate with the look as a material for wgpu, and an example that draws it."),
    opens: None,
    run_with: Some("wgpu 30 on lavapipe"),
    is_without_passes: false,
    write,
};

/// Version of wgpu that the crate asks for.
const VERSION: &str = "30";

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    refuse(request)?;
    let one = |problem: Diagnostic| vec![problem];
    let host = HostModule::of(request).map_err(one)?;
    let (parameters, lights) = (Parameters::of(request), Lights::of(request));
    let tables = tables::Tables::of(request);
    let mut template = Template::default();
    let title = plain(request.title);
    let name = crate_name(request.stem);
    template.place("title", title);
    template.place("stem", request.stem);
    template.place("crate", &name);
    template.place("module", name.replace('-', "_"));
    template.place("version", env!("CARGO_PKG_VERSION"));
    template.place("library", VERSION);
    template.section("wgpu", true);
    template.section("measures", true);
    template.section("places", true);
    template.section("look_or_wgpu", true);
    template.place("none_for_picture", "; none for the picture");
    template.place("last_draws", "; the last one draws the picture");
    template.section("linear", request.description.color_space == ColorSpace::Linear);
    let values = Values { host: &host, parameters: &parameters, lights: &lights };
    values.choose_sections(&mut template, request);
    tables.fill(&mut template, request, &parameters);
    fill_settings(&mut template, request, &parameters, &lights);
    fill_examples(&mut template, &parameters, &lights);
    fill_meshes(&mut template);
    let example = template.text(include_str!("template/example.rs.in"));
    template.lines("readme_example", example.lines().map(str::to_owned).collect());
    template.lines("doc_example", example.lines().map(|line| format!("//! {line}")).collect());

    let mut files = vec![
        template.file("Cargo.toml", include_str!("template/Cargo.toml.in")),
        template.file("rustfmt.toml", include_str!("template/rustfmt.toml.in")),
        template.file("README.md", include_str!("template/README.md.in")),
        template.file("src/lib.rs", include_str!("template/lib.rs.in")),
        template.file("src/error.rs", include_str!("template/error.rs.in")),
        template.file("src/look.rs", LOOK),
        template.file("src/material.rs", include_str!("template/material.rs.in")),
        template.file("src/math.rs", MATH),
        template.file("src/output.rs", include_str!("template/output.rs.in")),
        template.file("src/scene.rs", include_str!("template/scene.rs.in")),
        template.file("src/uniforms.rs", UNIFORMS),
        template.file("examples/show/main.rs", include_str!("template/main.rs.in")),
    ];
    files.extend(host.iter().map(|host| host.file("src/host.rs")));
    files.extend(values.files(&template));
    if template.has("images") {
        files.push(template.file("src/images.rs", include_str!("template/images.rs.in")));
    }
    if template.has("shadows") {
        files.push(template.file("src/shadow_maps.rs", SHADOW_MAPS));
    }
    if template.has("passes") {
        files.push(template.file("src/targets.rs", include_str!("template/targets.rs.in")));
    }
    for module in &request.description.modules {
        let text = shader::write(request, module.name).ok_or_else(|| {
            let message = tr!("the look's shader has a form that the crate does not know");
            one(refusal(message, tr!("export it `--to wgsl`")))
        })?;
        files.push(ExportFile::text(format!("src/shaders/{}.wgsl", module.name), text));
    }
    files.extend(image_files(request));
    files.extend(scene::files(request, template));
    Ok(files)
}

/// Refuses what the crate cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Vec<Diagnostic>> {
    let refused = |message: String, help: &str| Err(vec![refusal(message, help)]);
    for image in &request.description.images {
        let Some(file) = &image.file else {
            return refused(
                tr!(
                    "the image `{image}` cannot be read, and a crate is built with it",
                    image = image.path
                ),
                tr!("put the file where the look says, and export again"),
            );
        };
        if tables::image_feature(file).is_none() && !file.ends_with(".ktx2") {
            return refused(
                tr!(
                    "the crate reads PNG and JPEG files, and `{image}` is neither",
                    image = image.path
                ),
                tr!("save the image as PNG, with 8 bits a channel"),
            );
        }
    }
    Ok(())
}

/// Members of the host work's settings and surroundings.
fn fill_settings(
    template: &mut Template,
    request: &PackageRequest<'_>,
    parameters: &Parameters<'_>,
    lights: &Lights<'_>,
) {
    let mut settings = parameters.settings(request, "self.parameters");
    settings.extend(lights.settings("self.lights"));
    if settings.is_empty() {
        settings.push("nothing: 0.0".to_owned());
    }
    template.lines("settings", structure("host::Settings", &settings, "", 8));
    let (mut members, mut defaults, mut around) = (Vec::new(), Vec::new(), Vec::new());
    for (id, member) in &request.work.near {
        members.push(format!("    /// Distance from the object's middle to that of `{id}`, which"));
        members.push("    /// drives keys, in scene units.".to_owned());
        members.push(format!("    pub {member}: f64,"));
        defaults.push(format!("{member}: 1e6"));
        around.push(format!("            {member}: self.{member},"));
    }
    template.lines("near", members);
    let mut fields = vec![
        ("parameters", "parameters: Parameters::default()"),
        ("lights", "lights: Lights::default()"),
        ("illumination", "illumination: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"),
        ("time", "time: 0.0"),
    ];
    fields.extend(defaults.iter().map(|field| ("wgpu", field.as_str())));
    fields.extend([
        ("wgpu", "output"),
        ("wgpu", "pipelines"),
        ("wgpu", "uniforms: UniformBuffers::default()"),
        ("images", "images: images::upload(device, queue)?"),
        ("targets", "targets: None"),
        ("shadows", "shadows: None"),
    ]);
    let kept = fields.into_iter().filter(|(section, _)| template.has(section));
    let fields: Vec<String> = kept.map(|(_, field)| field.to_owned()).collect();
    template.lines("material", structure("Ok(Self", &fields, ")", 8));
    template.lines("near_surroundings", around);
}

/// Statements that set something, for the example and the text at the top of the crate.
fn fill_examples(template: &mut Template, parameters: &Parameters<'_>, lights: &Lights<'_>) {
    let parameter = parameters.example();
    let set = parameter.map(|(name, value)| format!("material.parameters.{name} = {value};"));
    let set = set.or_else(|| lights.example("material.lights"));
    template.place("mut", "mut ");
    template.lines("example_set", set.iter().map(|line| format!("    {line}")).collect());
    template.lines("set", set.into_iter().collect());
    let listed = if parameters.is_empty() {
        vec![
            "  - This look exposes none: expose some in Chiaro, or export with `--live`."
                .to_owned(),
        ]
    } else {
        parameters.listed()
    };
    template.lines("readme_parameters", listed);
    let types: Vec<&str> = if lights.is_empty() { Vec::new() } else { lights.types() };
    template.place("light_types", types.join(", "));
    let names: Vec<String> = lights.names().iter().map(|name| format!("`{name}`")).collect();
    template.place("light_names", names.join(", "));
}

/// Lengths of a mesh's arrays, but for that of positions.
fn fill_meshes(template: &mut Template) {
    let arrays =
        [("normal", "normals"), ("tangent", "tangents"), ("uv", "uvs"), ("color", "colors")];
    let read = arrays.into_iter().filter(|(section, _)| template.has(section));
    let lengths: Vec<String> =
        read.map(|(_, name)| format!("({name:?}, data.{name}.len())")).collect();
    template.section("attributed", !lengths.is_empty());
    let in_one = wide("let lengths = [", &lengths.join(", "), "];", 8);
    let lines = in_one.unwrap_or_else(|| {
        let lengths = lengths.iter().map(|it| format!("    {it},"));
        let [start, end] = ["let lengths = [", "];"].map(str::to_owned);
        std::iter::once(start).chain(lengths).chain([end]).collect()
    });
    template.lines("lengths", lines);
}
