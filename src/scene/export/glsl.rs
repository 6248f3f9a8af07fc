//! Common part of the versions of GLSL, which have a file for each stage.
//!
//! naga names interface blocks, varyings and attributes by numbers; the writer gives them the names
//! of the WGSL source back, the same in both stages, so that a uniform block is one block of the
//! linked program.

use std::collections::{BTreeMap, BTreeSet};

use naga::ResourceBinding;
use naga::back::glsl::{self, ReflectionInfo, Version};
use naga::proc::BoundsCheckPolicies;
use serde_json::json;

use super::ExportFile;
use super::header::list;
use super::language::{
    ExportedModule, LanguageAttribute, LanguageBinding, LanguageEntryPoint, LanguageFile,
    LanguageModule, Request,
};
use super::modules::ShaderModule;
use super::readable::{SourceComments, WrittenText};
use super::reflect::{self, BindingType, BoundVariable};
use super::remainders::DefinedRemainders;
use crate::wgsl::{ValidModule, identifiers, rename_identifiers, validate};

/// A stage, as naga writes it.
struct StageText {
    stage: naga::ShaderStage,
    text: String,
    /// The module that the text was written of.
    valid: ValidModule,
    /// Name of each block as naga writes it.
    blocks: BTreeMap<ResourceBinding, String>,
    /// Name of each texture as naga writes it, and the sampler that is combined with the texture.
    textures: BTreeMap<ResourceBinding, (String, Option<ResourceBinding>)>,
}

/// Writes a module; `suffix` stands between the stem and the extension.
pub(super) fn write(
    request: &Request<'_>,
    version: Version,
    suffix: &str,
) -> Result<ExportedModule, String> {
    let module = request.module;
    let slots = slots(&module.bindings);
    let binding_map = slots.iter().map(|(bound, slot)| (resource(bound), *slot)).collect();
    // Positions stay unchanged from the host's matrix.
    let options = glsl::Options {
        version,
        writer_flags: glsl::WriterFlags::empty(),
        binding_map,
        ..glsl::Options::default()
    };
    let defined = DefinedRemainders::of(module.wgsl())?;
    let (wgsl, valid) = match &defined {
        Some(defined) => (defined.wgsl.as_str(), &defined.valid),
        None => (module.wgsl(), module.valid()),
    };
    let stages =
        valid.module.entry_points.iter().map(|point| stage_text(&valid.module, point, &options));
    let stages: Vec<StageText> = stages.collect::<Result<_, _>>()?;
    let names = Names::choose(module, &stages);
    let mut described =
        LanguageModule { module: module.name.to_owned(), ..LanguageModule::default() };
    described.bindings =
        bindings(module, &names, &stages, &slots, version.supports_explicit_locations());
    described.attributes = names.attributes.clone();
    let source = SourceComments::of(wgsl);
    let mut files = Vec::new();
    for stage in &stages {
        let has_varyings = identifiers(&stage.text).iter().any(|word| word == "varyings");
        let written = WrittenText {
            text: rename_identifiers(&stage.text, |word| match word {
                // naga's name for what an entry point returns.
                "_tmp_return" if !has_varyings => Some("varyings".to_owned()),
                _ => names.of.get(word).cloned(),
            }),
            valid: &stage.valid,
            uniforms: names.uniforms(module),
            renamed: BTreeMap::new(),
        };
        let write = |valid: &ValidModule| {
            let point = &valid.module.entry_points[0];
            written_text(valid, point, &options).map(|(text, _)| text)
        };
        let text = written.readable(&source, write)?;
        let file = format!("{}.{suffix}.{}", request.stem, extension(stage.stage));
        let stage_name = reflect::stage_name(stage.stage);
        let point = LanguageEntryPoint { stage: stage_name, name: "main".to_owned() };
        described.files.push(LanguageFile { file: file.clone(), entry_points: vec![point] });
        let header = request
            .header(&format!("The {stage_name} shader. "), &binds(&described.bindings, &slots));
        files.push(ExportFile::text(file, after_version(&text, &header)));
    }
    Ok(ExportedModule { files, described })
}

fn stage_text(
    module: &naga::Module,
    point: &naga::EntryPoint,
    options: &glsl::Options,
) -> Result<StageText, String> {
    let valid = one_stage(module, point)?;
    let (text, info) = written_text(&valid, point, options)?;
    let place =
        |handle: naga::Handle<naga::GlobalVariable>| valid.module.global_variables[handle].binding;
    let mut blocks = BTreeMap::new();
    for (handle, name) in info.uniforms {
        blocks.extend(place(handle).map(|place| (place, name)));
    }
    let mut textures = BTreeMap::new();
    for (name, found) in info.texture_mapping {
        textures.extend(
            place(found.texture).map(|place_of| (place_of, (name, found.sampler.and_then(place)))),
        );
    }
    Ok(StageText { stage: point.stage, text, valid, blocks, textures })
}

/// The stage of an entry point, as naga writes it.
pub(super) fn written_text(
    valid: &ValidModule,
    point: &naga::EntryPoint,
    options: &glsl::Options,
) -> Result<(String, ReflectionInfo), String> {
    let pipeline = glsl::PipelineOptions {
        shader_stage: point.stage,
        entry_point: point.name.clone(),
        multiview: None,
    };
    let mut text = String::new();
    let policies = BoundsCheckPolicies::default();
    let mut writer =
        glsl::Writer::new(&mut text, &valid.module, &valid.info, options, &pipeline, policies)
            .map_err(|error| error.to_string())?;
    let info = writer.write().map_err(|error| error.to_string())?;
    Ok((text, info))
}

/// The module reduced to one entry point and everything that it needs; naga would write every
/// function into both files.
fn one_stage(module: &naga::Module, point: &naga::EntryPoint) -> Result<ValidModule, String> {
    let mut naga_module = module.clone();
    naga_module.entry_points.retain(|other| other.name == point.name);
    naga::compact::compact(&mut naga_module, naga::compact::KeepUnused::No);
    validate(naga_module).map_err(|error| error.to_string())
}

/// Slots for buffers and for textures, counted separately: OpenGL's binding points and texture
/// units.
fn slots(bindings: &[BoundVariable]) -> Vec<(&BoundVariable, u8)> {
    let mut counts: BTreeMap<bool, u8> = BTreeMap::new();
    let mut slots = Vec::new();
    for bound in bindings.iter().filter(|bound| bound.kind != BindingType::Sampler) {
        let count = counts.entry(bound.kind == BindingType::Texture).or_default();
        slots.push((bound, *count));
        *count = count.saturating_add(1);
    }
    slots
}

fn resource(bound: &BoundVariable) -> ResourceBinding {
    ResourceBinding { group: bound.group, binding: bound.binding }
}

fn extension(stage: naga::ShaderStage) -> &'static str {
    match stage {
        naga::ShaderStage::Vertex => "vert",
        naga::ShaderStage::Fragment => "frag",
        _ => "comp",
    }
}

/// New names for those that naga wrote.
struct Names {
    of: BTreeMap<String, String>,
    attributes: Vec<LanguageAttribute>,
}

impl Names {
    fn choose(module: &ShaderModule, stages: &[StageText]) -> Self {
        let taken = stages.iter().flat_map(|stage| identifiers(&stage.text)).collect();
        let mut names = Choice { of: BTreeMap::new(), taken };
        for stage in stages {
            for (place, block) in &stage.blocks {
                if let Some(bound) = module.bindings.iter().find(|bound| resource(bound) == *place)
                {
                    names.give(block, &format!("{}Block", bound.ty));
                }
            }
        }
        for bound in &module.bindings {
            for own in stage_names(bound) {
                names.give(&own, &format!("u_{}", bound.name));
            }
        }
        let mut attributes = Vec::new();
        for attribute in module.entry_points.iter().flat_map(|point| &point.attributes) {
            let name = names.give(
                &format!("_p2vs_location{}", attribute.location),
                &format!("a_{}", attribute.name),
            );
            attributes.push(LanguageAttribute { attribute: attribute.name.clone(), name });
        }
        for varying in reflect::varyings(&module.valid().module) {
            names.give(
                &format!("_vs2fs_location{}", varying.location),
                &format!("v_{}", varying.name),
            );
        }
        for output in module.entry_points.iter().flat_map(|point| &point.outputs) {
            let name = if output.name.is_empty() { "color" } else { &output.name };
            names.give(&format!("_fs2p_location{}", output.location), &format!("out_{name}"));
        }
        Self { of: names.of, attributes }
    }

    /// The new names of variables that hold uniforms.
    fn uniforms(&self, module: &ShaderModule) -> BTreeSet<String> {
        let uniforms = module.bindings.iter().filter(|bound| bound.kind == BindingType::Uniform);
        uniforms.flat_map(stage_names).filter_map(|own| self.of.get(&own).cloned()).collect()
    }
}

/// naga's names of a binding's variable, one for each stage.
fn stage_names(bound: &BoundVariable) -> [String; 3] {
    let (group, binding) = (bound.group, bound.binding);
    ["vs", "fs", "cs"].map(|stage| format!("_group_{group}_binding_{binding}_{stage}"))
}

struct Choice {
    of: BTreeMap<String, String>,
    taken: BTreeSet<String>,
}

impl Choice {
    /// The new name for naga's name `old`; two names that naga has for one variable of the source
    /// get the same new name.
    fn give(&mut self, old: &str, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        while self.taken.contains(&name) {
            name.push('_');
        }
        self.of.insert(old.to_owned(), name.clone());
        name
    }
}

/// The locations of all bindings; `is_explicit` where the text itself contains them.
fn bindings(
    module: &ShaderModule,
    names: &Names,
    stages: &[StageText],
    slots: &[(&BoundVariable, u8)],
    is_explicit: bool,
) -> Vec<LanguageBinding> {
    let mut found = Vec::new();
    for (bound, slot) in slots {
        let place = resource(bound);
        let block = stages.iter().find_map(|stage| stage.blocks.get(&place));
        let texture = stages.iter().find_map(|stage| stage.textures.get(&place));
        // Bindings that neither stage reads are not in the text.
        let Some(old) = block.or(texture.map(|(old, _)| old)) else { continue };
        let name = names.of.get(old).unwrap_or(old);
        let key = match (bound.kind, is_explicit) {
            (BindingType::Texture, true) => "unit",
            (BindingType::Texture, false) => "suggested_unit",
            (_, true) => "binding",
            (_, false) => "suggested_binding",
        };
        let mut binding = LanguageBinding::new(&bound.name, name, &[(key, json!(slot))]);
        let sampler = texture.and_then(|(_, sampler)| *sampler);
        let sampler = module.bindings.iter().find(|other| Some(resource(other)) == sampler);
        binding.sampler = sampler.map(|sampler| sampler.name.clone());
        found.push(binding);
    }
    found
}

/// The bindings in words, for the header.
fn binds(bindings: &[LanguageBinding], slots: &[(&BoundVariable, u8)]) -> Vec<String> {
    let named = |is_texture: bool| {
        let of_kind = bindings.iter().filter(move |binding| {
            let bound = slots.iter().find(|(bound, _)| bound.name == binding.binding);
            bound.is_some_and(|(bound, _)| (bound.kind == BindingType::Texture) == is_texture)
        });
        let text = of_kind.map(|binding| {
            let slot = slots
                .iter()
                .find(|(bound, _)| bound.name == binding.binding)
                .map_or(0, |(_, slot)| *slot);
            format!("{} {slot}", binding.name)
        });
        text.collect::<Vec<_>>()
    };
    vec![list("Uniform blocks (std140)", &named(false)), list("Textures", &named(true))]
}

/// Puts the header after the first line, because `#version` has to come first.
fn after_version(text: &str, header: &str) -> String {
    let (version, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!("{version}\n{header}{rest}")
}
