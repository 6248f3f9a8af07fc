//! `chiaro new`: a new look, scene or shot to begin with.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::output::Output;
use super::target::OutputPath;
use crate::diag::Diagnostic;
use crate::document::Document;
use crate::files::{Disk, OutputKind, Outputs, relative};

const EXAMPLES: &str = "\
Examples:
  chiaro new rim                      rim.json: five light layers over a base
  chiaro new flat --template minimal  light and shadow, two colors
  chiaro new stage --template scene   stage.json, a scene, and stage-look.json, which it wears
  chiaro new sh010 --template shot    sh010.json, a shot over a new scene, which wears a look
  chiaro new sh020 --over scene.json  sh020.json, a shot over a scene, or a shot, that is there";

/// Arguments of `chiaro new`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The name of the look; also the file's, with `.json`
    name: OutputPath,
    /// Beginning of the look
    #[arg(long, value_enum, default_value_t = Template::Layers)]
    template: Template,
    /// Makes a shot over this scene or shot, in which nothing is changed yet
    #[arg(long, conflicts_with = "template")]
    over: Option<PathBuf>,
    /// Replace files that are there
    #[arg(long)]
    force: bool,
}

/// Document that `chiaro new` writes to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Template {
    /// Fill, body, glow, gleam and rim: what a painter lays down
    Layers,
    /// Light and shadow
    Minimal,
    /// Two objects that wear a look of layers
    Scene,
    /// A shot of a second over such a scene: its camera and its key light move, shading on twos
    Shot,
}

const LAYERS: &str = include_str!("templates/layers.json");
const MINIMAL: &str = include_str!("templates/minimal.json");
const SCENE: &str = include_str!("templates/scene.json");
const SHOT: &str = include_str!("templates/shot.json");

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let files = match &arguments.over {
        Some(over) => shot_over(arguments.name.as_ref(), over),
        None => files(arguments.name.as_ref(), arguments.template),
    };
    let files = files.map_err(|problem| vec![problem])?;
    // All files are written, or none: a scene without its look would be no start.
    let mut outputs = Outputs::new(arguments.force);
    let check = |(path, _): &(PathBuf, String)| outputs.check(path, OutputKind::DOCUMENT).err();
    let taken: Vec<Diagnostic> = files.iter().filter_map(check).collect();
    if !taken.is_empty() {
        return Err(taken);
    }
    // The looks of a scene are written before it.
    for (path, text) in files.iter().rev() {
        outputs
            .add(path, OutputKind::DOCUMENT, text.as_bytes())
            .map_err(|problem| vec![problem])?;
    }
    outputs.commit().map_err(|problem| vec![problem])?;
    files.iter().for_each(|(path, _)| output.result(&path.display().to_string()));
    let (document, _) = &files[0];
    let name = quoted(document);
    let stem = quoted(&document.with_extension(""));
    output.message(&format!(
        "\nWhat next:\n  chiaro edit {name}\n  chiaro render {name} -o {stem}.png\n  chiaro check \
         {name}\n  chiaro nodes"
    ));
    Ok(())
}

/// Path and text of a shot over a document that is there.
fn shot_over(name: &Path, over: &Path) -> Result<Vec<(PathBuf, String)>, Diagnostic> {
    let (path, title) = path_and_title(name)?;
    let in_frames = match Document::load(&Disk, over) {
        Document::Shot(_) => "",
        Document::Scene(_) => "\n  \"frames\": [1, 24],\n  \"rate\": 24,",
        Document::Look(_) => {
            let problem = Diagnostic::error("bad-argument", "a shot is over a scene or a shot");
            return Err(problem
                .in_file(over.display().to_string())
                .hint("put the look on objects of a scene: chiaro new NAME --template scene"));
        }
    };
    let absolute = |path: &Path| {
        std::path::absolute(path).map_err(|error| {
            Diagnostic::error("cannot-read", format!("this folder is not known: {error}"))
        })
    };
    let (shot, over) = (absolute(&path)?, absolute(over)?);
    let folder = shot.parent().unwrap_or(&shot);
    let scene = in_json(&relative(folder, &over).replace('\\', "/"));
    let text = format!(
        "{{\n  \"chiaro\": \"shot\",\n  \"version\": 1,\n  \"name\": \"{title}\",\n  \"scene\": \
         \"{scene}\",{in_frames}\n  \"overrides\": []\n}}\n"
    );
    Ok(vec![(path, text)])
}

/// Path of a document by its name, and its title, escaped for JSON.
fn path_and_title(name: &Path) -> Result<(PathBuf, String), Diagnostic> {
    let stem = stem_of(name)?;
    Ok((name.with_file_name(format!("{stem}.json")), in_json(&title(stem))))
}

/// The name of a document, without its ending.
fn stem_of(name: &Path) -> Result<&str, Diagnostic> {
    let is_json = name.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
    let stem = if is_json { name.file_stem() } else { name.file_name() };
    stem.and_then(|stem| stem.to_str()).filter(|stem| !stem.is_empty()).ok_or_else(|| {
        let message = format!("the name cannot be `{}`", name.display());
        Diagnostic::error("bad-argument", message)
            .hint("write a name such as rim, or a path such as looks/rim")
    })
}

/// Paths and texts of the files, the one to open first.
fn files(name: &Path, template: Template) -> Result<Vec<(PathBuf, String)>, Diagnostic> {
    let (stem, (path, title)) = (stem_of(name)?, path_and_title(name)?);
    let look = |text: &str| text.replace("{{name}}", &title);
    let beside = |file: &str| name.with_file_name(file);
    Ok(match template {
        Template::Layers => vec![(path, look(LAYERS))],
        Template::Minimal => vec![(path, look(MINIMAL))],
        Template::Scene => {
            let worn = format!("{stem}-look.json");
            let scene = look(SCENE).replace("{{look}}", &in_json(&worn));
            vec![(path, scene), (beside(&worn), look(LAYERS))]
        }
        Template::Shot => {
            let (worn, stage) = (format!("{stem}-look.json"), format!("{stem}-scene.json"));
            let named = |text: &str| look(text).replace("{{look}}", &in_json(&worn));
            let shot = named(SHOT).replace("{{scene}}", &in_json(&stage));
            vec![(path, shot), (beside(&stage), named(SCENE)), (beside(&worn), look(LAYERS))]
        }
    })
}

/// Title for a file's stem: `rim_light-2` becomes `Rim light 2`.
fn title(stem: &str) -> String {
    let spaced = stem.replace(['_', '-'], " ");
    let mut characters = spaced.chars();
    characters
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

/// The text escaped for JSON, without quotes.
fn in_json(text: &str) -> String {
    let quoted = serde_json::Value::from(text).to_string();
    quoted[1..quoted.len() - 1].to_owned()
}

/// The path quoted for a shell.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = text.chars().all(|c| c.is_alphanumeric() || "/._-\\:".contains(c));
    if is_plain { text } else { format!("'{}'", text.replace('\'', r"'\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_are_sound_whatever_the_name() {
        for name in ["rim", "folder/rim.json", "odd \"name\" \\ here", "光", "v1.2"] {
            for template in Template::value_variants() {
                for (path, text) in files(Path::new(name), *template).unwrap() {
                    let file = path.display().to_string();
                    let document = Document::read(&text, &file);
                    let problems = document.diagnostics();
                    assert!(problems.is_empty(), "{file}: {problems:?}");
                    assert!(!text.contains("{{"), "{text}");
                }
            }
        }
        assert_eq!(
            files(Path::new("v1.2"), Template::Minimal).unwrap()[0].0,
            Path::new("v1.2.json")
        );
        assert!(files(Path::new("/"), Template::Minimal).is_err());
        assert_eq!(title("rim_light-2"), "Rim light 2");
    }
}
