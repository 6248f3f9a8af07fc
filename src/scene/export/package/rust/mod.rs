//! Parts that packages in Rust share: templates, names, and the look's parameters, lights and host
//! work as modules of a crate.

mod fragment;
mod passes;
mod shadow_maps;
mod template;
mod values;

use super::super::ExportFile;
use super::PackageRequest;
pub(super) use fragment::FragmentEntry;
pub(super) use passes::{LOOK, PassTable, UNIFORMS};
pub(super) use shadow_maps::{SHADOW_MAPS, fill_shadow_maps};
pub(super) use template::Template;
pub(super) use values::{HostModule, Lights, Parameters, float};

/// Vectors and matrices of the host's work.
pub(super) const MATH: &str = include_str!("template/math.rs.in");

/// Words of Rust that WGSL takes as names.
const WORDS: [&str; 4] = ["box", "dyn", "gen", "in"];

/// Names that a crate cannot have, or that its dependencies have.
const TAKEN: [&str; 12] = [
    "alloc",
    "bevy",
    "build",
    "core",
    "deps",
    "examples",
    "image",
    "incremental",
    "pollster",
    "proc_macro",
    "std",
    "test",
];

/// Values of a look that its crate lets others set, and the work that is done with them.
pub(super) struct Values<'a> {
    pub(super) host: &'a Option<HostModule>,
    pub(super) parameters: &'a Parameters<'a>,
    pub(super) lights: &'a Lights<'a>,
}

impl Values<'_> {
    /// Keeps those sections of a template that the values need.
    pub(super) fn choose_sections(&self, template: &mut Template, request: &PackageRequest<'_>) {
        let reads =
            |surrounding: &str| self.host.as_ref().is_some_and(|host| host.reads(surrounding));
        template.section("look", self.host.is_some());
        template.section("parameters", !self.parameters.is_empty());
        template.section("lights", !self.lights.is_empty());
        template.section("keyed", request.work.is_keyed && self.host.is_some());
        template.section("illumination", reads("illumination"));
        template.section("time", reads("time") || reads("frame"));
    }

    /// The modules of parameters and lights, where there are any.
    pub(super) fn files(&self, template: &Template) -> Vec<ExportFile> {
        let mut files = Vec::new();
        if template.has("parameters") {
            let text = self.parameters.fill(&mut template.clone());
            files.push(ExportFile::text("src/parameters.rs".to_owned(), text));
        }
        if template.has("lights") {
            let text = self.lights.fill(&mut template.clone());
            files.push(ExportFile::text("src/lights.rs".to_owned(), text));
        }
        files
    }
}

/// Images of a look, where a crate's sources include them.
pub(super) fn image_files(request: &PackageRequest<'_>) -> impl Iterator<Item = ExportFile> {
    let images = request.textures.iter().cloned();
    images.map(|file| ExportFile { name: format!("src/images/{}", file.name), ..file })
}

/// A shader's text for a crate, whose code has what the description of shaders alone says.
pub(super) fn shader_text(text: &str) -> String {
    const OTHER: &str = ".json says what to put there and how to draw.";
    let own = |line: &str| match line.ends_with(OTHER) {
        true => "// look.rs says what to put there.\n".to_owned(),
        false => format!("{line}\n"),
    };
    text.lines().map(own).collect()
}

/// A member's name as Rust writes it.
pub(super) fn member(name: &str) -> String {
    if WORDS.contains(&name) { format!("r#{name}") } else { name.to_owned() }
}

/// A crate's name from the name of files: small letters, digits and hyphens.
pub(super) fn crate_name(stem: &str) -> String {
    let kept = |c: char| {
        if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' }
    };
    let text: String = stem.chars().map(kept).collect();
    let words: Vec<&str> = text.split('-').filter(|word| !word.is_empty()).collect();
    let name = words.join("-");
    let is_word = syntax_word(&name) || TAKEN.contains(&name.as_str()) || name == "wgpu";
    match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() && !is_word => name,
        Some(first) if first.is_ascii_alphabetic() => format!("{name}-look"),
        Some(_) => format!("look-{name}"),
        None => "look".to_owned(),
    }
}

/// True for a word that Rust has for itself, as a name of one word may be.
fn syntax_word(name: &str) -> bool {
    const KEYWORDS: [&str; 51] = [
        "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
        "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
        "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
        "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type",
        "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
    ];
    KEYWORDS.contains(&name)
}

/// A text of any content as one that may stand in comments, strings and Markdown.
pub(super) fn plain(text: &str) -> String {
    let kept = |c: char| !c.is_control() && !"\"\\`{}[]<>*".contains(c);
    text.chars().filter(|c| kept(*c)).collect::<String>().replace("//", "/")
}

/// A line of the three parts, where it is at most 100 characters wide when it is moved in by
/// `indent`.
pub(super) fn wide(start: &str, middle: &str, end: &str, indent: usize) -> Option<Vec<String>> {
    let line = format!("{start}{middle}{end}");
    (line.chars().count() + indent <= 100).then(|| vec![line])
}

/// A struct's value: in one line, or a member a line. `start` is what stands before its name.
pub(super) fn structure(start: &str, members: &[String], end: &str, indent: usize) -> Vec<String> {
    let whole = members.join(", ");
    wide(&format!("{start} {{ "), &whole, &format!(" }}{end}"), indent).unwrap_or_else(|| {
        let members = members.iter().map(|member| format!("    {member},"));
        let (open, close) = (format!("{start} {{"), format!("}}{end}"));
        std::iter::once(open).chain(members).chain([close]).collect()
    })
}

/// A text as lines of a comment that begin with `start`, at most 100 characters wide when they are
/// moved in by `indent`.
pub(super) fn wrapped(text: &str, start: &str, indent: usize) -> Vec<String> {
    let width = 100 - indent;
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        let length = start.chars().count() + line.chars().count() + 1 + word.chars().count();
        if length > width && !line.is_empty() {
            lines.push(format!("{start}{line}"));
            line.clear();
        }
        line += if line.is_empty() { "" } else { " " };
        line += word;
    }
    lines.push(format!("{start}{line}"));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crates_have_names_that_cargo_takes() {
        assert_eq!(crate_name("figure1-layers"), "figure1-layers");
        assert_eq!(crate_name("2 Rim_light"), "look-2-rim-light");
        assert_eq!(crate_name("Loop"), "loop-look");
        assert_eq!(crate_name("wgpu"), "wgpu-look");
        assert_eq!(crate_name("…"), "look");
    }

    #[test]
    fn comments_are_wrapped() {
        let lines = wrapped(&"word ".repeat(40), "/// ", 4);
        assert!(lines.iter().all(|line| line.len() <= 96 && line.starts_with("/// word")));
        assert_eq!(lines.len(), 3);
    }
}
