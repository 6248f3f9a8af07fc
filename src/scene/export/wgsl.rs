//! WGSL, for WebGPU: the modules as they are.

use serde_json::json;

use super::ExportFile;
use super::header::list;
use super::language::{
    ClipSpace, ExportedModule, Language, LanguageBinding, LanguageFile, LanguageModule, Request,
    entry_points,
};

pub(super) const LANGUAGE: Language = Language {
    slug: "wgsl",
    label: "WGSL",
    short_label: "WGSL",
    api: "WebGPU",
    // The window copies the shader as it is shown, without exposed parameters.
    texts: &[],
    verified_by: Some("Tint"),
    clip_space: ClipSpace::WEBGPU,
    note: "",
    write,
};

fn write(request: &Request<'_>) -> Result<ExportedModule, String> {
    let module = request.module;
    let bindings: Vec<_> = module
        .bindings
        .iter()
        .map(|bound| {
            let at = [("group", json!(bound.group)), ("binding", json!(bound.binding))];
            LanguageBinding::new(&bound.name, &bound.name, &at)
        })
        .collect();
    let names: Vec<_> =
        module.bindings.iter().map(|bound| format!("{} {}", bound.name, bound.binding)).collect();
    let header = request.header("", &[list("Bindings of group 0", &names)]);
    let file = format!("{}.wgsl", request.stem);
    let described = LanguageModule {
        module: module.name.to_owned(),
        files: vec![LanguageFile { file: file.clone(), entry_points: entry_points(module) }],
        bindings,
        attributes: Vec::new(),
    };
    let source = module.wgsl();
    let source = if module.host().is_some() { without_header(source) } else { source };
    let text = format!("{header}\n{source}");
    Ok(ExportedModule { files: vec![ExportFile::text(file, text)], described })
}

/// A compiled source without the comment that it begins with, which the export's header replaces.
fn without_header(source: &str) -> &str {
    let mut rest = source;
    while let Some((line, after)) = rest.split_once('\n') {
        let is_header = line.is_empty() || (line.starts_with("//") && !line.starts_with("///"));
        if !is_header {
            break;
        }
        rest = after;
    }
    rest
}
