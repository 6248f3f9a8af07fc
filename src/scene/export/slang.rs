//! Slang, for engines and tools that compile or differentiate it: a module whose entry points say
//! their stages and whose bindings say their places, so that `slangc` needs no flags, and its
//! reflection tells bindings and parameters.
//!
//! Slang reads HLSL, and the text is that of [`hlsl`](super::hlsl) but for those attributes.

use super::hlsl;
use super::language::{ClipSpace, Language, LanguageEntryPoint, TextFile};
use super::reflect::BoundVariable;

pub(super) const LANGUAGE: Language = Language {
    slug: "slang",
    label: "Slang",
    short_label: "Slang",
    api: "",
    texts: &[TextFile { ending: ".slang", content: "shader" }],
    verified_by: Some("slangc"),
    clip_space: ClipSpace::WEBGPU,
    note: "slangc compiles it without flags but the target, which finds the entry points by their \
           attributes. Attributes have the semantic LOC followed by their location. Matrices are \
           declared row_major, each row holding a column of the uniform's bytes.",
    write: |request| {
        let registers = hlsl::registers(&request.module.bindings);
        hlsl::write_as(request, "slang", |text, points| {
            with_places(&with_stages(text, points), &registers)
        })
    },
};

/// The text with its place for Vulkan before each binding: group and binding of the WGSL.
fn with_places(text: &str, registers: &[(&BoundVariable, char, u32)]) -> String {
    let mut text = text.to_owned();
    for (bound, letter, register) in registers {
        let Some(at) = text.find(&format!(" : register({letter}{register})")) else { continue };
        let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
        let place = format!("[[vk::binding({}, {})]]\n", bound.binding, bound.group);
        text.insert_str(start, &place);
    }
    text
}

/// The text with its stage before each entry point.
fn with_stages(text: &str, points: &[LanguageEntryPoint]) -> String {
    let stage = |line: &str| {
        let begins = line.starts_with(|c: char| c.is_ascii_alphabetic());
        let is_declared = |name: &str| begins && line.contains(&format!(" {name}("));
        points.iter().find(|point| is_declared(&point.name)).map(|point| point.stage)
    };
    let mut result = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        if let Some(stage) = stage(line) {
            result.push_str(&format!("[shader(\"{stage}\")]\n"));
        }
        result.push_str(line);
    }
    result
}
