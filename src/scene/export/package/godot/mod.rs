//! The package `godot`: a look for Godot 4, as a shader, a material and a script.
//!
//! `STEM.gdshader` is the look's shader ([`shader`]), whose uniforms are the members of the look's
//! uniform block ([`uniforms`]); `STEM.tres` a material of it, with the numbers that hold before
//! anything is set ([`defaults`]). `STEM.gd` ([`script`]) is for a mesh: parameters in the
//! inspector, lights of the scene that lights of the look follow, and the uniforms of them; what is
//! the same for all looks is in `chiaro.look.gd`, and the host work itself in `STEM.host.gd`. A
//! project with a scene shows the look ([`scene`]). Textures are pictures with the settings of
//! their import ([`textures`]).

pub(super) mod defaults;
mod scene;
mod script;
mod shader;
mod textures;
mod uniforms;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use chiaro_locale::{text, tr};

use super::super::ExportFile;
use super::super::description::{DrawnSides, Feed, Member, ModuleDescription, StepDescription};
use super::super::host_code::{GDSCRIPT, translate};
use super::{Package, PackageRequest, javascript, refusal};
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use uniforms::{ImageUniform, ParameterUniform, Uniform, Uniforms};

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "godot",
    label: text!("Godot"),
    help: text!(
        "A shader, a material and a script for meshes in Godot 4, and a project that shows them."
    ),
    opens: None,
    run_with: Some("Godot 4.6, its web build in Chromium, renderer Compatibility"),
    is_without_passes: true,
    write,
};

/// The script of what all looks have in common.
const LOOK: &str = include_str!("look.gd");

/// The text of one screen for whoever gets the folder.
const README: &str = include_str!("README.md");

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    refuse(request)?;
    let one = |problem: Diagnostic| vec![problem];
    let stem = request.stem;
    let description = request.description;
    let Some(module) = description.modules.iter().find(|module| module.name == "draw") else {
        return Err(vec![unknown(tr!("no picture"))]);
    };
    let properties = script::properties(request);
    let numbers = defaults::numbers(request).map_err(one)?;
    let mut uniforms = uniforms_of(request, module, numbers).map_err(one)?;
    let pass = description.passes.iter().find(|pass| pass.name == "draw");
    let blocks = module.bindings.iter().map(|binding| binding.ty.clone()).collect();
    let options = shader::ShaderOptions {
        title: request.title,
        script: &format!("{stem}.gd"),
        has_both_sides: pass.is_some_and(|pass| {
            pass.sides == Some(DrawnSides::Both) || pass.sides_parameter.is_some()
        }),
        is_opaque: description.opaque,
        is_linear: description.color_space == ColorSpace::Linear,
        blocks: &blocks,
    };
    let fragment = javascript::source(request.sources, "glsl-es300", "draw", ".frag");
    let shader =
        shader::write(&fragment, &mut uniforms, &options).map_err(|what| vec![unknown(&what)])?;
    let read = uniforms.read(&shader);
    let script = script::write(request, &uniforms, &read, &properties);
    let mut files = vec![
        ExportFile::text(format!("{stem}.gdshader"), shader),
        ExportFile::text(format!("{stem}.tres"), material(stem, &uniforms, &read)),
        ExportFile::text(format!("{stem}.gd"), script),
        ExportFile::text(format!("{stem}.host.gd"), host(request).map_err(one)?),
        ExportFile::text("chiaro.look.gd".to_owned(), LOOK.to_owned()),
        ExportFile::text(format!("{stem}.mesh.tres"), scene::mesh(&request.scene.mesh)),
        ExportFile::text(format!("{stem}.tscn"), scene::scene(request)),
        ExportFile::text("project.godot".to_owned(), scene::project(request)),
        ExportFile::text("README.md".to_owned(), readme(request)),
    ];
    files.extend(textures::files(request.textures).map_err(one)?);
    Ok(files)
}

/// The host work as a script of static functions.
fn host(request: &PackageRequest<'_>) -> Result<String, Diagnostic> {
    let work = request.work;
    let mut functions: Vec<&str> = Vec::new();
    if work.is_keyed {
        functions.push("keyed");
    }
    functions.extend(
        work.modules.iter().filter(|it| it.module == "draw").map(|it| it.function.as_str()),
    );
    let mut text = format!(
        "extends RefCounted\n\
         ## {}: made by Chiaro {}, Godot 4.\n##\n\
         ## What is computed before the look is drawn: lights in their frames, keys, and the\n\
         ## numbers of its uniforms. Numbers have 64 bits, so vectors are arrays.\n\n\n",
        request.title,
        env!("CARGO_PKG_VERSION")
    );
    if !functions.is_empty() {
        text += &two_lines_between(&translate(&work.wgsl, &functions, &GDSCRIPT)?);
    }
    Ok(text)
}

/// Two empty lines between functions, as the language has it.
fn two_lines_between(text: &str) -> String {
    let mut result = String::new();
    for line in text.lines() {
        result += line;
        result.push('\n');
        if line.is_empty() && !result.ends_with("\n\n\n") {
            result.push('\n');
        }
    }
    result
}

/// Refuses what a material of Godot cannot draw.
fn refuse(request: &PackageRequest<'_>) -> Result<(), Vec<Diagnostic>> {
    let refused = |message: String, help: &str| Err(vec![refusal(message, help)]);
    let description = request.description;
    let before: Vec<&str> =
        description.passes.iter().map(|pass| pass.name).filter(|name| *name != "draw").collect();
    if !before.is_empty() {
        return refused(
            tr!(
                "the look is drawn in several passes ({names}), and a material of Godot has one",
                names = before.join(", ")
            ),
            tr!("export it with `--tier auto` or `--tier fast`, whose curvature and normals need \
                 no passes; take outlines, shadows and smooth normals out of the look, or export \
                 it `--to web`"),
        );
    }
    let is_linear = description.color_space == ColorSpace::Linear;
    // A painted surface is sampled within its edges alone, and its shader decodes it.
    for image in description.images.iter().filter(|image| image.kind != "hcbtf") {
        if image.wrap == "mirror" {
            return refused(
                tr!(
                    "the image `{image}` is mirrored where it repeats, as none is in Godot",
                    image = image.path
                ),
                tr!("let the image node repeat or clamp instead"),
            );
        }
        if is_linear && image.encoding == "color" {
            return refused(
                tr!(
                    "the image `{image}` is turned into linear light as it is read",
                    image = image.path
                ),
                tr!("let the look work with colors as shown, or export it `--to three`"),
            );
        }
    }
    Ok(())
}

fn unknown(what: &str) -> Diagnostic {
    refusal(
        tr!("the look's shader reads {what}, which Godot has nothing for"),
        tr!("export the look `--to web` or `--to three`"),
    )
}

fn uniforms_of<'a>(
    request: &'a PackageRequest<'_>,
    module: &'a ModuleDescription,
    numbers: Vec<f64>,
) -> Result<Uniforms<'a>, Diagnostic> {
    let description = request.description;
    let is_linear = description.color_space == ColorSpace::Linear;
    let block = module.bindings.iter().find(|binding| matches!(binding.feed, Feed::Look));
    let (mut own, mut lights) = (BTreeMap::new(), BTreeMap::new());
    for member in module.host.iter().flat_map(|host| &host.members) {
        if let Some(light) = member.lights.iter().next().filter(|_| member.lights.len() == 1) {
            lights.insert(member.name.clone(), light.to_string());
        }
        let step = module.host.iter().flat_map(|host| &host.steps).nth(member.step);
        // A parameter that keys move, or that is taken as another type, is computed.
        if let Some(StepDescription::Parameter { parameter, .. }) = step
            && let Some(found) = description.parameters.get(*parameter)
            && let Some(name) = &found.name
            && !found.keyed
            && found.ty == member.ty
        {
            own.insert(
                member.name.clone(),
                ParameterUniform {
                    index: *parameter,
                    name: script::property_name(name.as_str()),
                    parameter: found,
                    is_color: member.ty == "color" && !is_linear,
                },
            );
        }
    }
    let mut images = Vec::new();
    for binding in &module.bindings {
        let Feed::Image { image } = binding.feed else { continue };
        let Some(found) = description.images.get(image) else { continue };
        let filter = if found.filter == "nearest" { "filter_nearest" } else { "filter_linear" };
        let wrap = if found.wrap == "repeat" { "repeat_enable" } else { "repeat_disable" };
        let (file, ty) = textures::picture_of(found.file.as_deref().unwrap_or_default());
        images.push(ImageUniform {
            old: format!("u_{}", binding.name),
            name: binding.name.clone(),
            file,
            ty,
            hints: format!("{filter}, {wrap}"),
        });
    }
    let members: Vec<Member> = block
        .iter()
        .flat_map(|block| block.members.iter().map(|described| described.member.clone()))
        .collect();
    Uniforms::of(members, own, &lights, images, numbers).map_err(|what| unknown(&what))
}

/// A material with the shader's own numbers, for meshes without the script.
fn material(stem: &str, uniforms: &Uniforms<'_>, read: &[&Uniform]) -> String {
    let mut text = format!(
        "[gd_resource type=\"ShaderMaterial\" load_steps={} format=3]\n\n\
         [ext_resource type=\"Shader\" path=\"{stem}.gdshader\" id=\"shader\"]\n",
        uniforms.images.len() + 2
    );
    for image in &uniforms.images {
        let _infallible = writeln!(
            text,
            "[ext_resource type=\"{}\" path=\"{}\" id=\"{}\"]",
            image.ty, image.file, image.name
        );
    }
    text += "\n[resource]\nshader = ExtResource(\"shader\")\n";
    for image in &uniforms.images {
        let name = &image.name;
        let _infallible = writeln!(text, "shader_parameter/{name} = ExtResource(\"{name}\")");
    }
    // Godot's shaders have no defaults of arrays.
    for uniform in read.iter().filter(|uniform| uniform.count.is_some()) {
        let (name, list) = (&uniform.name, uniforms.list_of(uniform));
        let _infallible = writeln!(text, "shader_parameter/{name} = {list}");
    }
    text
}

fn readme(request: &PackageRequest<'_>) -> String {
    let lights: Vec<String> =
        request.work.lights.iter().map(|light| format!("`{}`", light.member)).collect();
    let lights = if lights.is_empty() { "none here".to_owned() } else { lights.join(", ") };
    README
        .replace("{{title}}", request.title)
        .replace("{{stem}}", request.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{table}}", &request.tables())
        .replace("{{lights}}", &lights)
}
