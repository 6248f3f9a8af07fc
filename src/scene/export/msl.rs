//! Metal Shading Language 2.0: one file with both entry points.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

use naga::back::msl;
use serde_json::json;

use super::ExportFile;
use super::header::list;
use super::language::{
    ClipSpace, ExportedModule, Language, LanguageBinding, LanguageFile, LanguageModule, Request,
    TextFile,
};
use super::one_file::{NagaText, readable_text};
use super::readable::WrittenText;
use super::reflect::{BindingType, BoundVariable};
use crate::wgsl::ValidModule;

pub(super) const LANGUAGE: Language = Language {
    slug: "msl",
    label: "Metal Shading Language 2.0",
    short_label: "Metal Shading Language",
    api: "",
    texts: &[TextFile { ending: ".metal", content: "shader" }],
    verified_by: None,
    clip_space: ClipSpace::WEBGPU,
    note: "Unverified: written by naga, seen by no Metal compiler. Attributes are \
           [[attribute(location)]] of the stage input; give vertex buffers indices after those of \
           the uniform buffers.",
    write,
};

fn write(request: &Request<'_>) -> Result<ExportedModule, String> {
    let module = request.module;
    let slots = slots(&module.bindings);
    let mut resources = msl::EntryPointResources::default();
    for (bound, _, slot) in &slots {
        let target = match bound.kind {
            BindingType::Texture => {
                msl::BindTarget { texture: Some(*slot), ..msl::BindTarget::default() }
            }
            BindingType::Sampler => msl::BindTarget {
                sampler: Some(msl::BindSamplerTarget::Resource(*slot)),
                ..msl::BindTarget::default()
            },
            BindingType::Uniform | BindingType::Storage => {
                msl::BindTarget { buffer: Some(*slot), ..msl::BindTarget::default() }
            }
        };
        resources
            .resources
            .insert(naga::ResourceBinding { group: bound.group, binding: bound.binding }, target);
    }
    let write = |valid: &ValidModule| naga_text(valid, &resources);
    let valid = module.valid();
    let (text, points) = readable_text(module, valid, write, |text| {
        Ok(WrittenText { uniforms: uniforms(&text), renamed: BTreeMap::new(), valid, text })
    })?;
    let place = |(bound, kind, slot): &(&BoundVariable, &'static str, u8)| {
        LanguageBinding::new(
            &bound.name,
            name_at(&text, &format!("[[{kind}({slot})]]")),
            &[(*kind, json!(slot))],
        )
    };
    let bindings: Vec<_> = slots.iter().map(place).collect();
    let names: Vec<_> = bindings
        .iter()
        .zip(&slots)
        .map(|(b, (_, kind, slot))| format!("{} {kind}({slot})", b.name))
        .collect();
    let header = request.header("", &[list("Arguments of both functions", &names)]);
    let file = format!("{}.metal", request.stem);
    let described = LanguageModule {
        module: module.name.to_owned(),
        files: vec![LanguageFile { file: file.clone(), entry_points: points }],
        bindings,
        attributes: Vec::new(),
    };
    Ok(ExportedModule {
        files: vec![ExportFile::text(file, format!("{header}\n{text}"))],
        described,
    })
}

/// The slot of each binding: buffers, textures and samplers are counted separately.
fn slots(bindings: &[BoundVariable]) -> Vec<(&BoundVariable, &'static str, u8)> {
    let mut counts = [0u8; 3];
    let mut slots = Vec::new();
    for bound in bindings {
        let (index, kind) = match bound.kind {
            BindingType::Uniform | BindingType::Storage => (0, "buffer"),
            BindingType::Texture => (1, "texture"),
            BindingType::Sampler => (2, "sampler"),
        };
        slots.push((bound, kind, counts[index]));
        counts[index] = counts[index].saturating_add(1);
    }
    slots
}

/// Names in a text of arguments that hold uniforms: `constant Look& look`.
fn uniforms(text: &str) -> BTreeSet<String> {
    let argument = |line: &str| {
        let line = line.trim_start_matches([' ', ',']).strip_prefix("constant ")?;
        let (_, name) = line.split_once("& ")?;
        let end = name.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        Some(name[..end.unwrap_or(name.len())].to_owned())
    };
    text.lines().filter_map(argument).collect()
}

/// A module as naga writes it, and the names of its entry points there.
fn naga_text(
    valid: &ValidModule,
    resources: &msl::EntryPointResources,
) -> NagaText<impl Display + use<>> {
    let mut options = msl::Options {
        lang_version: (2, 0),
        fake_missing_bindings: false,
        // Loops of looks end: Chiaro takes no others.
        force_loop_bounding: false,
        ..msl::Options::default()
    };
    for point in &valid.module.entry_points {
        options.per_entry_point_map.insert(point.name.clone(), resources.clone());
    }
    let pipeline = msl::PipelineOptions::default();
    let (text, info) = msl::write_string(&valid.module, &valid.info, &options, &pipeline)
        .map_err(|e| e.to_string())?;
    Ok((text, info.entry_point_names))
}

/// The name that naga gives to the argument at a slot: `view_1` where another function has an
/// argument `view`.
fn name_at<'t>(text: &'t str, slot: &str) -> &'t str {
    let declared = text.find(&format!(" {slot}")).map_or("", |end| &text[..end]);
    declared.rsplit(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().unwrap_or_default()
}
