//! HLSL, shader model 5.1, for Direct3D 12: one file with both entry points.
//!
//! naga reaches samplers through a heap of 2048, as wgpu binds them. The writer gives each sampler
//! a register of its own instead, so that the file fits any engine; writes constants in a form that
//! every compiler takes ([`lists`]) and choices in one that HLSL 2018 and 2021 share ([`choices`]).

mod choices;
mod fillings;
mod helpers;
mod lists;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

use chiaro_locale::tr;
use naga::back::hlsl;
use serde_json::json;

use super::ExportFile;
use super::header::list;
use super::language::{
    ClipSpace, ExportedModule, Language, LanguageBinding, LanguageEntryPoint, LanguageFile,
    LanguageModule, Request, TextFile,
};
use super::one_file::{NagaText, readable_text};
use super::readable::{SourceComments, WrittenText, words};
use super::reflect::{BindingType, BoundVariable};
use crate::diag::Diagnostic;
use crate::wgsl::{self, ValidModule};

pub(super) const LANGUAGE: Language = Language {
    slug: "hlsl",
    label: "HLSL, shader model 5.1",
    short_label: "HLSL",
    api: "Direct3D 12",
    texts: &[TextFile { ending: ".hlsl", content: "shader" }],
    verified_by: Some("glslangValidator, slangc and dxc"),
    clip_space: ClipSpace::WEBGPU,
    note: "By the rules of HLSL 2018 and of 2021. fxc has not seen it. \
           Attributes have the semantic LOC followed by their location. Matrices are declared \
           row_major, each row holding a column of the uniform's bytes.",
    write,
};

fn write(request: &Request<'_>) -> Result<ExportedModule, String> {
    write_as(request, "hlsl", |text, _| text.to_owned())
}

/// The module in a file with an ending, its text as HLSL has it but for what `finish` changes; the
/// entry points go with the text.
pub(super) fn write_as(
    request: &Request<'_>,
    ending: &str,
    finish: impl FnOnce(&str, &[LanguageEntryPoint]) -> String,
) -> Result<ExportedModule, String> {
    let module = request.module;
    let registers = registers(&module.bindings);
    let mut options = hlsl::Options {
        fake_missing_bindings: false,
        // Loops of looks end: Chiaro takes no others.
        force_loop_bounding: false,
        ..hlsl::Options::default()
    };
    let textures = registers.iter().filter(|(_, letter, _)| *letter == 't').count() as u32;
    for (bound, _, register) in &registers {
        let target = hlsl::BindTarget { register: *register, ..hlsl::BindTarget::default() };
        let resource = naga::ResourceBinding { group: bound.group, binding: bound.binding };
        options.binding_map.insert(resource, target);
        // The heap's index, which is removed again, has a register after the textures.
        let index = hlsl::BindTarget { register: textures, ..hlsl::BindTarget::default() };
        options
            .sampler_buffer_binding_map
            .insert(hlsl::SamplerIndexBufferKey { group: bound.group }, index);
    }
    let write = |valid: &ValidModule| naga_text(valid, &options);
    let changed = choices::with_calls(module.valid())?;
    let valid = changed.as_ref().unwrap_or_else(|| module.valid());
    let (text, points) = readable_text(module, valid, write, |text| {
        let text = plain_text(&own_samplers(&text)?);
        let uniforms = registers.iter().filter(|(bound, ..)| bound.kind == BindingType::Uniform);
        let uniforms =
            uniforms.map(|(_, letter, register)| register_name(&text, *letter, *register));
        Ok(WrittenText {
            uniforms: uniforms.map(str::to_owned).collect(),
            renamed: own_names(&text, &registers),
            valid,
            text,
        })
    })?;
    let place = |(bound, letter, register): &(&BoundVariable, char, u32)| {
        let at = [("register", json!(format!("{letter}{register}"))), ("space", json!(0))];
        LanguageBinding::new(&bound.name, register_name(&text, *letter, *register), &at)
    };
    let bindings: Vec<_> = registers.iter().map(place).collect();
    let names: Vec<_> = bindings
        .iter()
        .zip(&registers)
        .map(|(binding, (_, letter, n))| format!("{} {letter}{n}", binding.name))
        .collect();
    let header = request.header("", &[list("Registers of space 0", &names)]);
    let file = format!("{}.{ending}", request.stem);
    let text = finish(&choices::with_comments(&text), &points);
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

/// Functions and types of WGSL without bindings as HLSL, with their names and comments.
///
/// # Errors
/// - `export-failed`: what naga or the writer cannot take.
pub(super) fn functions(source: &str) -> Result<String, Diagnostic> {
    let lost = |message: String| {
        Diagnostic::error("export-failed", tr!("host work is no HLSL: {message}"))
            .hint(tr!("please report the look; `--to hlsl` may still carry it"))
    };
    let valid = wgsl::parse(source).map_err(|error| lost(error.message))?;
    let valid = choices::with_calls(&valid).map_err(lost)?.unwrap_or(valid);
    let options = hlsl::Options { force_loop_bounding: false, ..hlsl::Options::default() };
    let write = |valid: &ValidModule| naga_text(valid, &options).map(|(text, _)| text);
    let text = plain_text(&write(&valid).map_err(lost)?);
    let renamed = choices::plain_names(&text);
    let written = WrittenText { text, valid: &valid, uniforms: BTreeSet::new(), renamed };
    let text = written.readable(&SourceComments::of(source), write).map_err(lost)?;
    Ok(choices::with_comments(&text))
}

/// A text of naga's in the form that every compiler takes, without what no one needs.
fn plain_text(text: &str) -> String {
    lists::with_lists(&helpers::with_plain_helpers(&fillings::without_fillings(text)))
}

/// The register of each binding: `b` buffers, `t` textures and `s` samplers are counted separately.
pub(super) fn registers(bindings: &[BoundVariable]) -> Vec<(&BoundVariable, char, u32)> {
    let mut counts = [0u32; 3];
    let mut register = |bound| {
        let (index, letter) = match bound {
            BindingType::Uniform => (0, 'b'),
            BindingType::Texture | BindingType::Storage => (1, 't'),
            BindingType::Sampler => (2, 's'),
        };
        counts[index] += 1;
        (letter, counts[index] - 1)
    };
    bindings
        .iter()
        .map(|bound| {
            let (letter, number) = register(bound.kind);
            (bound, letter, number)
        })
        .collect()
}

/// A module as naga writes it, and the names of its entry points there.
fn naga_text(valid: &ValidModule, options: &hlsl::Options) -> NagaText<impl Display + use<>> {
    let mut text = String::new();
    let pipeline = hlsl::PipelineOptions::default();
    let mut writer = hlsl::Writer::new(&mut text, options, &pipeline);
    let info = writer.write(&valid.module, &valid.info, None).map_err(|error| error.to_string())?;
    Ok((text, info.entry_point_names))
}

/// The bindings' own names for those that naga gives to their variables, where nothing else of the
/// module has them: `view` for `view_1`.
fn own_names(text: &str, registers: &[(&BoundVariable, char, u32)]) -> BTreeMap<String, String> {
    let outer = |name: &str| {
        let is_declared = |line: &str| {
            let begins = line.starts_with(|c: char| c.is_ascii_alphabetic());
            begins && (line.contains(&format!(" {name}(")) || line.contains(&format!(" {name} ")))
        };
        text.lines().any(is_declared)
    };
    let mut names = choices::plain_names(text);
    for (bound, letter, register) in registers {
        let own = register_name(text, *letter, *register);
        if own.strip_prefix(bound.name.as_str()).is_some_and(is_number) && !outer(&bound.name) {
            names.insert(own.to_owned(), bound.name.clone());
        }
    }
    for (name, plain) in PLAIN_NAMES {
        if !words(text).any(|word| &text[word.span] == plain) {
            names.insert(name.to_owned(), plain.to_owned());
        }
    }
    names
}

/// Names of naga's own, and plain ones.
const PLAIN_NAMES: [(&str, &str); 4] = [
    ("VertexOutput_vs_main", "VertexOutput"),
    ("FragmentInput_fs_main", "FragmentInput"),
    ("fragmentinput_fs_main", "input"),
    ("naga_f2i32", "to_int"),
];

/// True for `_1`.
fn is_number(end: &str) -> bool {
    let digits = end.strip_prefix('_').unwrap_or_default();
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// Removes the sampler heap from the text: every sampler gets its own register.
fn own_samplers(text: &str) -> Result<String, String> {
    const HEAPS: [&str; 3] = [
        "SamplerState nagaSamplerHeap[",
        "SamplerComparisonState nagaComparisonSamplerHeap[",
        "StructuredBuffer<uint> nagaGroup",
    ];
    let mut result = String::with_capacity(text.len());
    for line in text.lines().filter(|line| !HEAPS.iter().any(|heap| line.starts_with(heap))) {
        // static const SamplerState NAME = nagaSamplerHeap[nagaGroup0SamplerIndexArray[REGISTER]];
        let sampler = line.strip_prefix("static const SamplerState ").and_then(|rest| {
            let (name, index) = rest.split_once(" = nagaSamplerHeap[")?;
            Some((name, index.split_once('[')?.1.split_once(']')?.0))
        });
        match sampler {
            Some((name, register)) => {
                result.push_str(&format!("SamplerState {name} : register(s{register});"));
            }
            None => result.push_str(line),
        }
        result.push('\n');
    }
    if result.contains("nagaSamplerHeap") {
        return Err(tr!("a sampler is used in a way that only the heap allows").to_owned());
    }
    Ok(result)
}

/// The name of the variable at a register. naga calls it `view_1` where a function has an argument
/// `view`.
fn register_name(text: &str, letter: char, register: u32) -> &str {
    let place = format!(" : register({letter}{register})");
    let declared = text.find(&place).map_or("", |end| &text[..end]);
    declared.rsplit(|c: char| !c.is_ascii_alphanumeric() && c != '_').next().unwrap_or_default()
}
