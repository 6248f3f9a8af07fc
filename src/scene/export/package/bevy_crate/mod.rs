//! The package `bevy`: a crate with the look as a `Material` of Bevy, and a plugin that computes
//! its numbers before a frame.
//!
//! The shader is the look's own ([`shader`]): camera and object are taken from Bevy's bindings, and
//! the look's uniform and images lie in the material's group.

mod shader;

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::super::ExportFile;
use super::super::program::LightSetting;
use super::materials::class_name;
use super::rust::{
    HostModule, Lights, MATH, Parameters, Template, Values, crate_name, image_files, plain,
    structure, wide,
};
use super::{Package, PackageRequest, javascript, refusal};
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, LightKind, LightSpace};
use crate::export::description::DrawnSides;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "bevy",
    label: "Bevy crate",
    help: "A Rust crate with the look as a Material for Bevy 0.19, and a plugin.",
    opens: None,
    run_with: Some("Bevy 0.19 on lavapipe"),
    write,
};

/// Version of Bevy that the crate asks for.
const VERSION: &str = "0.19";

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let described = json!(request.description);
    let module = draw_module(&described);
    refuse(request, &module)?;
    let one = |problem: Diagnostic| vec![problem];
    let host = HostModule::of(request).map_err(one)?;
    let shader = shader::write(request, &module).ok_or_else(|| {
        let message = "the look's shader reads numbers of the object for each fragment, which the \
                       crate cannot give";
        one(refusal(message, "take what tells objects apart out of it, or export it `--to wgpu`"))
    })?;
    let (parameters, lights) = (Parameters::of(request), Lights::of(request));
    let mut template = Template::default();
    let name = format!("{}_bevy_0_19", crate_name(request.stem).replace('-', "_"));
    template.place("title", plain(request.title));
    template.place("crate", &name);
    template.place("module", &name);
    let class = class_name(request.stem);
    let mut names = [format!("{class}Plugin"), "Drives".to_owned(), "LightName".to_owned()];
    names.sort();
    template.place("plugin_names", names.join(", "));
    template.place("class", class);
    template.place("version", env!("CARGO_PKG_VERSION"));
    template.place("library", VERSION);
    let values = Values { host: &host, parameters: &parameters, lights: &lights };
    values.choose_sections(&mut template, request);
    let reads_object = host.as_ref().is_some_and(|host| host.reads("object_"));
    template.section("object", reads_object);
    fill_material(&mut template, request, &parameters, &module);
    fill_lights(&mut template, request, &lights);
    fill_numbers(&mut template, request, &parameters, &lights, &module);
    fill_images(&mut template, request);
    fill_examples(&mut template, &parameters, &lights);

    let mut files = vec![
        template.file("Cargo.toml", include_str!("template/Cargo.toml.in")),
        template.file("rustfmt.toml", include_str!("template/rustfmt.toml.in")),
        template.file("README.md", include_str!("template/README.md.in")),
        template.file("src/lib.rs", include_str!("template/lib.rs.in")),
        template.file("src/material.rs", include_str!("template/material.rs.in")),
        template.file("src/plugin.rs", include_str!("template/plugin.rs.in")),
        template.file("examples/show.rs", include_str!("template/show.rs.in")),
        ExportFile::text("src/shaders/draw.wgsl".to_owned(), shader),
    ];
    if let Some(host) = &host {
        files.push(host.file("src/host.rs"));
        files.push(template.file("src/math.rs", MATH));
    }
    files.extend(values.files(&template));
    files.extend(image_files(request));
    Ok(files)
}

/// The module that draws the picture, with its bindings.
fn draw_module(described: &Value) -> Value {
    let mut modules = described["modules"].as_array().into_iter().flatten();
    let draw = modules.find(|module| module["name"] == "draw");
    draw.map(|module| Value::Object(javascript::module_object(module, described)))
        .unwrap_or_default()
}

/// Refuses what the crate cannot draw.
fn refuse(request: &PackageRequest<'_>, module: &Value) -> Result<(), Vec<Diagnostic>> {
    let description = request.description;
    let passes: Vec<&str> =
        description.passes.iter().map(|it| it.name).filter(|name| *name != "draw").collect();
    let mut attributes = module["attributes"].as_array().into_iter().flatten();
    let is_readable = |file: &str| file.to_lowercase().ends_with(".png");
    let found = if !passes.is_empty() {
        let message = format!(
            "the look draws passes before the picture ({}), which the crate cannot",
            passes.join(", ")
        );
        refusal(message, "take curvature, lines and shadows out of it, or export it `--to wgpu`")
    } else if attributes.any(|attribute| attribute["name"] == "tangent") {
        let message = "the look reads tangents, which Bevy counts the other way";
        refusal(message, "export it `--to wgpu` or `--to web`")
    } else if !request.work.near.is_empty() {
        let message = "keys of the look are driven by distances of other objects";
        refusal(message, "drive them by something else, or export it `--to wgpu`")
    } else if description.images.iter().any(|it| !it.file.as_deref().is_some_and(is_readable)) {
        let message = "the crate reads images as PNG alone, and one of the look's is none";
        refusal(message, "save the image as PNG, or export it `--to wgpu`")
    } else {
        return Ok(());
    };
    Err(vec![found])
}

fn fill_material(
    template: &mut Template,
    request: &PackageRequest<'_>,
    parameters: &Parameters<'_>,
    module: &Value,
) {
    let alpha = if request.description.opaque { "Opaque" } else { "Blend" };
    template.place("alpha_mode", format!("AlphaMode::{alpha}"));
    let pass = request.description.passes.last();
    let index = pass.and_then(|pass| pass.sides_parameter);
    let cuts = index.and_then(|index| parameters.member_of(request, index));
    let is_cut = pass.is_some_and(|pass| pass.sides == Some(DrawnSides::Both));
    template.place(
        "shows_backs",
        match cuts {
            Some(member) => {
                format!("material.is_two_sided || material.parameters.{member} > 0.0")
            }
            None if is_cut => "true".to_owned(),
            None => "material.is_two_sided".to_owned(),
        },
    );
    let attributes = module["attributes"].as_array().into_iter().flatten();
    let attributes = attributes.map(|attribute| {
        let name = match attribute["name"].as_str().unwrap_or_default() {
            "uv" => "UV_0".to_owned(),
            name => name.to_uppercase(),
        };
        let location = &attribute["location"];
        format!("            Mesh::ATTRIBUTE_{name}.at_shader_location({location}),")
    });
    template.lines("attributes", attributes.collect());
}

fn fill_lights(template: &mut Template, request: &PackageRequest<'_>, lights: &Lights<'_>) {
    let variants: Vec<String> = lights.names().iter().map(|name| class_name(name)).collect();
    let all = || request.work.lights.iter().zip(lights.names()).zip(&variants);
    let about = |((light, _), variant): ((&LightSetting, &String), &String)| {
        [format!("    /// The light {}.", plain(light.id.as_str())), format!("    {variant},")]
    };
    template.lines("light_names", all().flat_map(about).collect());
    template.place("first_light", variants.first().cloned().unwrap_or_default());
    let frame = |((light, _), variant): ((&LightSetting, &String), &String)| {
        let frame = match light.light.space {
            LightSpace::Illumination if template.has("illumination") => {
                "material.illumination.inverse()"
            }
            LightSpace::Camera => "camera_from_world",
            _ => "Quat::IDENTITY",
        };
        format!("                LightName::{variant} => {frame},")
    };
    let frames: Vec<String> = all().map(frame).collect();
    template.section("camera_light", frames.iter().any(|it| it.contains("camera_from_world")));
    let has = |is: fn(LightKind) -> bool| request.work.lights.iter().any(|it| is(it.light.kind));
    template.section("has_directional", has(|kind| kind == LightKind::Directional));
    template.section("has_lamp", has(|kind| kind != LightKind::Directional));
    template.section("has_spot", has(|kind| kind == LightKind::Spot));
    template.lines("light_frames", frames);
    let follow = |((light, name), variant): ((&LightSetting, &String), &String)| {
        let start = format!("                LightName::{variant} =>");
        match light.light.kind {
            LightKind::Directional => vec![format!("{start} lights.{name}.direction = toward,")],
            LightKind::Point => vec![format!("{start} lights.{name}.position = position,")],
            LightKind::Spot => vec![
                format!("{start} {{"),
                format!("                    lights.{name}.position = position;"),
                format!("                    lights.{name}.aim = aim;"),
                "                }".to_owned(),
            ],
        }
    };
    template.lines("light_follows", all().flat_map(follow).collect());
    let types: Vec<&str> = if lights.is_empty() { Vec::new() } else { lights.types() };
    template.place("light_types", types.join(", "));
}

fn fill_numbers(
    template: &mut Template,
    request: &PackageRequest<'_>,
    parameters: &Parameters<'_>,
    lights: &Lights<'_>,
    module: &Value,
) {
    let mut settings = parameters.settings(request, "self.parameters");
    settings.extend(lights.settings("self.lights"));
    if settings.is_empty() {
        settings.push("nothing: 0.0".to_owned());
    }
    template.lines("settings", structure("host::Settings", &settings, "", 8));
    let mut bindings = module["bindings"].as_array().into_iter().flatten();
    let look = bindings.find(|binding| binding["feed"]["from"] == "look");
    let size = look.and_then(|binding| binding["size"].as_u64()).unwrap_or_default();
    template.place("vectors", size.div_ceil(16).to_string());
    if let Some(numbers) = request.work.modules.iter().find(|it| it.module == "draw") {
        let call = format!("host::{}(settings, around)", numbers.function);
        let integers = format!("&{:?}", numbers.integers);
        let both = format!("{call}, {integers}");
        let lines = wide("LookNumbers::new(", &both, ")", 8).unwrap_or_else(|| {
            let arguments = [call, integers].map(|it| format!("    {it},"));
            let open = std::iter::once("LookNumbers::new(".to_owned());
            open.chain(arguments).chain([")".to_owned()]).collect()
        });
        template.lines("numbers", lines);
    }
}

fn fill_images(template: &mut Template, request: &PackageRequest<'_>) {
    let images = &request.description.images;
    template.section("images", !images.is_empty());
    template.place("image_features", if images.is_empty() { "" } else { ", \"png\"" });
    template.place("derive_default", if images.is_empty() { ", Default" } else { "" });
    let class = class_name(request.stem);
    let construct = if images.is_empty() { "default()" } else { "new(&assets)" };
    template.place("construct", format!("{class}Material::{construct}"));
    let is_linear = request.description.color_space == ColorSpace::Linear;
    let (mut members, mut handles) = (Vec::new(), Vec::new());
    let mut files = BTreeSet::new();
    for (index, image) in images.iter().enumerate() {
        let Some(file) = &image.file else { continue };
        let (texture, sampler) = shader::places(index);
        members.push(format!("    /// The image `{}`.", plain(&image.path)));
        members.push(format!("    #[texture({texture})]"));
        members.push(format!("    #[sampler({sampler})]"));
        members.push(format!("    pub image_{}: Handle<Image>,", index + 1));
        let wrap = match image.wrap.as_str() {
            "clamp" => "ClampToEdge",
            "mirror" => "MirrorRepeat",
            _ => "Repeat",
        };
        let filter = if image.filter == "nearest" { "Nearest" } else { "Linear" };
        let is_srgb = is_linear && image.encoding == "color";
        handles.push(format!("            image_{}: image(", index + 1));
        handles.push("                assets,".to_owned());
        handles.push(format!(
            "                \"embedded://{}_bevy_0_19/images/{file}\",",
            crate_name(request.stem).replace('-', "_")
        ));
        handles.push(format!("                {is_srgb},"));
        handles.push(format!("                ImageAddressMode::{wrap},"));
        handles.push(format!("                ImageFilterMode::{filter},"));
        handles.push("            ),".to_owned());
        files.insert(file.clone());
    }
    template.lines("images", members);
    template.lines("image_handles", handles);
    let embedded =
        files.iter().map(|file| format!("        embedded_asset!(app, \"images/{file}\");"));
    template.lines("embedded", embedded.collect());
}

/// Statements that set something, for the example and the texts.
fn fill_examples(template: &mut Template, parameters: &Parameters<'_>, lights: &Lights<'_>) {
    let parameter = parameters.example();
    let set = parameter.map(|(name, value)| format!("material.parameters.{name} = {value};"));
    let set = set.or_else(|| lights.example("material.lights"));
    template.place("doc_mut", if set.is_some() { "mut " } else { "" });
    template.lines("doc_set", set.iter().map(|line| format!("//!     {line}")).collect());
    template.lines("example_set", set.iter().map(|line| format!("    {line}")).collect());
    template.lines("readme_set", set.into_iter().collect());
    template.lines("readme_parameters", parameters.listed());
}
