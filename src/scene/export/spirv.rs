//! SPIR-V 1.3, for Vulkan 1.1 and later: one module with both entry points.

use chiaro_locale::tr;
use naga::back::spv;
use serde_json::json;

use super::ExportFile;
use super::language::{
    ClipSpace, ExportedModule, Language, LanguageBinding, LanguageFile, LanguageModule, Request,
    entry_points,
};
use crate::wgsl::ValidModule;

pub(super) const LANGUAGE: Language = Language {
    slug: "spirv",
    label: "SPIR-V 1.3",
    short_label: "SPIR-V",
    api: "Vulkan",
    texts: &[],
    verified_by: Some("spirv-val"),
    clip_space: ClipSpace::VULKAN,
    note: "Names are kept for reflection (OpName).",
    write,
};

/// A module as SPIR-V words, the same as in the export but for the bindings' numbers.
///
/// # Errors
/// A construct that SPIR-V cannot express.
pub fn spirv_words(valid: &ValidModule) -> Result<Vec<u32>, String> {
    let options = spv::Options { lang_version: (1, 3), ..spv::Options::default() };
    spv::write_vec(&valid.module, &valid.info, &options, None).map_err(|error| error.to_string())
}

/// The fragment stage of a module as SPIR-V words. Names are left out, so that the module has as
/// many instructions in any build of Chiaro.
///
/// # Errors
/// A module without a fragment stage, or a construct that SPIR-V cannot express.
pub fn fragment_spirv_words(valid: &ValidModule) -> Result<Vec<u32>, String> {
    let stage = naga::ShaderStage::Fragment;
    let mut points = valid.module.entry_points.iter();
    let point = points
        .find(|point| point.stage == stage)
        .ok_or_else(|| tr!("there is no fragment stage"))?;
    let pipeline = spv::PipelineOptions { shader_stage: stage, entry_point: point.name.clone() };
    let options = spv::Options {
        lang_version: (1, 3),
        flags: spv::WriterFlags::empty(),
        ..spv::Options::default()
    };
    spv::write_vec(&valid.module, &valid.info, &options, Some(&pipeline))
        .map_err(|error| error.to_string())
}

fn write(request: &Request<'_>) -> Result<ExportedModule, String> {
    let module = request.module;
    let mut options = spv::Options {
        lang_version: (1, 3),
        fake_missing_bindings: false,
        ..spv::Options::default()
    };
    // Names stay in, in any build of Chiaro; positions stay unchanged from the host's matrix.
    options.flags = spv::WriterFlags::DEBUG;
    let mut bindings = Vec::new();
    for bound in &module.bindings {
        let target = spv::BindingInfo {
            descriptor_set: bound.group,
            binding: bound.binding,
            binding_array_size: None,
        };
        options
            .binding_map
            .insert(naga::ResourceBinding { group: bound.group, binding: bound.binding }, target);
        let at = [("set", json!(bound.group)), ("binding", json!(bound.binding))];
        bindings.push(LanguageBinding::new(&bound.name, &bound.name, &at));
    }
    let valid = module.valid();
    let words = spv::write_vec(&valid.module, &valid.info, &options, None)
        .map_err(|error| error.to_string())?;
    let bytes = words.into_iter().flat_map(u32::to_le_bytes).collect();
    let file = format!("{}.spv", request.stem);
    let described = LanguageModule {
        module: module.name.to_owned(),
        files: vec![LanguageFile { file: file.clone(), entry_points: entry_points(module) }],
        bindings,
        attributes: Vec::new(),
    };
    Ok(ExportedModule { files: vec![ExportFile { name: file, bytes }], described })
}
