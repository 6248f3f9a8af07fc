//! The package `bevy`: a crate with the look as a `Material` of Bevy, and a plugin that computes
//! its numbers before a frame.
//!
//! The shader is the look's own ([`shader`]): camera and object are taken from Bevy's bindings, and
//! the look's uniform and images lie in the material's group.

mod shader;

use std::collections::BTreeSet;
use std::io::Cursor;

use chiaro_locale::{text, tr};
use image::{ColorType, DynamicImage, ImageFormat};
use serde_json::{Value, json};

use super::super::ExportFile;
use super::super::program::LightSetting;
use super::materials::class_name;
use super::rust::{
    HostModule, LOOK, Lights, MATH, Parameters, PassTable, SHADOW_MAPS, Template, UNIFORMS, Values,
    crate_name, image_files, plain, shader_text, structure, wide,
};
use super::{Package, PackageRequest, is_in_blocks, javascript, refusal};
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, LightKind, LightSpace};
use crate::export::description::DrawnSides;
use shader::PassMap;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "bevy",
    label: text!("Bevy crate"),
    help: text!("A Rust crate with the look as a Material for Bevy 0.19, and a plugin."),
    opens: None,
    run_with: Some("Bevy 0.19 on lavapipe"),
    is_without_passes: false,
    write,
};

/// Version of Bevy that the crate asks for.
const VERSION: &str = "0.19";

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let described = json!(request.description);
    let module = draw_module(&described);
    refuse(request)?;
    let one = |problem: Diagnostic| vec![problem];
    let host = HostModule::of(request).map_err(one)?;
    let shader = shader::write(request, &module).ok_or_else(|| {
        let message = tr!("the look's shader has a form that the crate does not know");
        one(refusal(message, tr!("export it `--to wgpu`")))
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
    template.place("class", &class);
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
    fill_passes(&mut template, request, &module);
    fill_words(&mut template, &class);

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
    files.extend(host.iter().map(|host| host.file("src/host.rs")));
    if template.has("math") {
        files.push(template.file("src/math.rs", MATH));
    }
    if template.has("passes") {
        files.push(template.file("src/frame.rs", include_str!("template/frame.rs.in")));
        files.push(template.file("src/look.rs", LOOK));
        files.push(template.file("src/passes.rs", include_str!("template/passes.rs.in")));
        files.push(template.file("src/uniforms.rs", UNIFORMS));
        files.extend(pass_shaders(request));
    }
    if template.has("shadows") {
        files.push(template.file("src/shadow_maps.rs", SHADOW_MAPS));
    }
    files.extend(values.files(&template));
    files.extend(image_files(request).map(with_eight_bits));
    Ok(files)
}

/// An image with 8 bits a channel. Bevy reads those of 16 bits as whole numbers, which no sampler
/// filters, and would not draw the look.
fn with_eight_bits(file: ExportFile) -> ExportFile {
    let Ok(read) = image::load_from_memory_with_format(&file.bytes, ImageFormat::Png) else {
        return file;
    };
    let narrowed = match read.color() {
        ColorType::L16 => DynamicImage::from(read.to_luma8()),
        ColorType::La16 | ColorType::Rgb16 | ColorType::Rgba16 => read.to_rgba8().into(),
        _ => return file,
    };
    let mut bytes = Cursor::new(Vec::new());
    match narrowed.write_to(&mut bytes, ImageFormat::Png) {
        Ok(()) => ExportFile { bytes: bytes.into_inner(), ..file },
        Err(_) => file,
    }
}

/// Shaders of passes. Bevy's texture coordinates have v down.
fn pass_shaders(request: &PackageRequest<'_>) -> impl Iterator<Item = ExportFile> {
    let modules = request.description.modules.iter().filter(|module| module.name != "draw");
    modules.map(|module| {
        let text = javascript::source(request.sources, "wgsl", module.name, ".wgsl");
        let text = text.replace("vertex.uv", "vec2f(vertex.uv.x, 1.0 - vertex.uv.y)");
        let text = shader_text(&text);
        ExportFile::text(format!("src/shaders/{}.wgsl", module.name), text)
    })
}

/// The module that draws the picture, with its bindings.
fn draw_module(described: &Value) -> Value {
    let mut modules = described["modules"].as_array().into_iter().flatten();
    let draw = modules.find(|module| module["name"] == "draw");
    draw.map(|module| Value::Object(javascript::module_object(module, described)))
        .unwrap_or_default()
}

/// Refuses what the crate cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Vec<Diagnostic>> {
    let is_readable = |file: &str| {
        let file = file.to_lowercase();
        file.ends_with(".png") || file.ends_with(".ktx2")
    };
    let mut images = request.description.images.iter();
    let found = if !request.work.near.is_empty() {
        let message = tr!("keys of the look are driven by distances of other objects");
        refusal(message, tr!("drive them by something else, or export it `--to wgpu`"))
    } else if images.any(|it| !it.file.as_deref().is_some_and(is_readable)) {
        let message = tr!("the crate reads images as PNG alone, and one of the look's is none");
        refusal(message, tr!("save the image as PNG, or export it `--to wgpu`"))
    } else {
        return Ok(());
    };
    Err(vec![found])
}

/// Passes before the picture, and what the material reads of them.
fn fill_passes(template: &mut Template, request: &PackageRequest<'_>, module: &Value) {
    let passes = &request.description.passes;
    let modules: Vec<&str> = passes.iter().map(|it| it.module).filter(|it| *it != "draw").collect();
    if modules.is_empty() {
        return;
    }
    template.section("bevy", true);
    template.section("places", true);
    let is_numbered = request.work.modules.iter().any(|it| modules.contains(&it.module));
    PassTable::of(request, |pass| pass.module != "draw").fill(template, request, is_numbered);
    template.section("measures", template.has("shadows"));
    let has_shadows = template.has("shadows");
    let is_array = if has_shadows { ", pass.draws == Draws::Lights" } else { "" };
    template.place("is_array_argument", is_array);
    let names = if has_shadows { "{self, Place, Uniforms}" } else { "{Place, Uniforms}" };
    template.place("uniform_names", names);
    let has_numbers = template.has("numbers");
    template.place("msaa_type", if has_numbers { ", &Msaa" } else { "" });
    template.place("msaa_name", if has_numbers { ", msaa" } else { "" });
    let has_look = template.has("look");
    let names =
        if has_look { "mesh, handle, transform, bounds" } else { "mesh, handle, transform" };
    template.place("seen_names", names);
    let numbers = if has_look { ", and computes the numbers of materials" } else { "" };
    template.place("and_numbers", numbers);

    let maps = shader::pass_maps(request, module);
    let mut members = Vec::new();
    for map in &maps {
        let [pass, _] = map.source;
        let array = if map.is_array { ", dimension = \"2d_array\"" } else { "" };
        members.push(format!("    /// What the pass `{}` has drawn.", passes[pass].name));
        members.push(format!(
            "    #[texture({}, sample_type = \"float\", filterable = false{array})]",
            map.binding
        ));
        members.push(format!("    pub(crate) {}: Option<Handle<Image>>,", map.name));
    }
    template.lines("maps", members);
    let none = maps.iter().map(|map| format!("            {}: None,", map.name));
    template.lines("map_defaults", none.collect());
    template.place("map_count", maps.len().to_string());
    let list = |start: &str, item: &dyn Fn(&PassMap) -> String, end: &str, indent: usize| {
        let items: Vec<String> = maps.iter().map(item).collect();
        let margin = " ".repeat(indent);
        let lines = wide(start, &items.join(", "), end, indent + 4).unwrap_or_else(|| {
            let items = items.iter().map(|item| format!("    {item},"));
            std::iter::once(start.to_owned()).chain(items).chain([end.to_owned()]).collect()
        });
        lines.into_iter().map(|line| margin.clone() + &line).collect::<Vec<_>>()
    };
    let image = |map: &PassMap| format!("frame.image({}, {})", map.source[0], map.source[1]);
    template.lines("map_list", list("let maps = [", &image, "];", 4));
    let own = |map: &PassMap| format!("&self.{}", map.name);
    template.lines("map_references", list("[", &own, "]", 0));
    let own = |map: &PassMap| format!("self.{}", map.name);
    template.lines("map_assignment", list("[", &own, "] = maps;", 0));
}

/// Words of the material that several files have.
fn fill_words(template: &mut Template, class: &str) {
    let material = format!("{class}Material");
    let braces = |mut names: Vec<String>| {
        names.sort();
        if names.len() == 1 { names.concat() } else { format!("{{{}}}", names.join(", ")) }
    };
    let (has_look, has_passes) = (template.has("look"), template.has("passes"));
    let numbers = |is_there: bool| is_there.then(|| "LookNumbers".to_owned());
    let own = std::iter::once(material.clone());
    template
        .place("plugin_material", braces(own.chain(numbers(has_look && !has_passes)).collect()));
    let own = [material, "MaterialKey".to_owned()].into_iter();
    template.place("material_names", braces(own.chain(numbers(has_look)).collect()));
    template.place("key_visibility", if has_passes { "pub(crate) " } else { "" });
    let is_keyed = template.has("keyed");
    template.place("settings_visibility", if is_keyed { "" } else { "pub(crate) " });
    let call = if is_keyed { "material.settings_in(around)" } else { "material.settings()" };
    template.place("settings_call", call);
    let has_illumination = template.has("illumination");
    template.place("show_systems", if has_illumination { "(walk, turn_lights)" } else { "walk" });
    let what = ", and computes its numbers";
    let more = ", computes its numbers, and draws its passes";
    template.place("and_what", if has_passes { more } else { what });
    let has_shadows = template.has("shadows");
    let shadows = if has_shadows { "shadows of Bevy's lights" } else { "shadows" };
    template.place("not_here", format!("{shadows}, skins and morphs"));
    template.section("math", has_look || has_passes);
    template.section("look_or_wgpu", has_look);
}

fn fill_material(
    template: &mut Template,
    request: &PackageRequest<'_>,
    parameters: &Parameters<'_>,
    module: &Value,
) {
    let alpha = if request.description.opaque { "Opaque" } else { "Blend" };
    template.place("alpha_mode", format!("AlphaMode::{alpha}"));
    let is_linear = request.description.color_space == ColorSpace::Linear;
    template.section("blended", !request.description.opaque && !is_linear);
    let pass = request.description.passes.last();
    let index = pass.and_then(|pass| pass.sides_parameter);
    let cuts = index.and_then(|index| parameters.member_of(request, index));
    let is_cut = pass.is_some_and(|pass| pass.sides == Some(DrawnSides::Both));
    let shows_backs = match cuts {
        Some(member) => {
            format!("material.is_two_sided || material.parameters.{member} > 0.0")
        }
        None if is_cut => "true".to_owned(),
        None => "material.is_two_sided".to_owned(),
    };
    template.place("key_of", if shows_backs == "true" { "_material" } else { "material" });
    template.place("shows_backs", shows_backs);
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
    let mut attributes = module["attributes"].as_array().into_iter().flatten();
    template.section("tangents", attributes.any(|attribute| attribute["name"] == "tangent"));
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
    let is_layered = |file: &str| file.ends_with(".ktx2");
    let mut names = images.iter().filter_map(|image| image.file.as_deref());
    template.section("layered", names.clone().any(is_layered));
    template.section("flat", names.any(|file| !is_layered(file)));
    template.section("blocks", request.textures.iter().any(is_in_blocks));
    template.place("image_features", if template.has("flat") { ", \"png\"" } else { "" });
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
        let array = if is_layered(file) { ", dimension = \"2d_array\"" } else { "" };
        members.push(format!("    #[texture({texture}{array})]"));
        members.push(format!("    #[sampler({sampler})]"));
        members.push(format!("    pub image_{}: Handle<Image>,", index + 1));
        let wrap = match image.wrap.as_str() {
            "clamp" => "ClampToEdge",
            "mirror" => "MirrorRepeat",
            _ => "Repeat",
        };
        let filter = if image.filter == "nearest" { "Nearest" } else { "Linear" };
        let is_srgb = is_linear && image.encoding == "color";
        let load = if is_layered(file) { "layers" } else { "image" };
        handles.push(format!("            image_{}: {load}(", index + 1));
        handles.push("                assets,".to_owned());
        if is_layered(file) {
            handles.push(format!("                include_bytes!(\"images/{file}\"),"));
        } else {
            handles.push(format!(
                "                \"embedded://{}_bevy_0_19/images/{file}\",",
                crate_name(request.stem).replace('-', "_")
            ));
            handles.push(format!("                {is_srgb},"));
            files.insert(file.clone());
        }
        handles.push(format!("                ImageAddressMode::{wrap},"));
        handles.push(format!("                ImageFilterMode::{filter},"));
        handles.push("            ),".to_owned());
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
    template.lines("readme_parameters", parameters.listed());
}
