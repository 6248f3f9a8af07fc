//! Texts of packages that bring a look as a material: templates with places for the look's names.

use std::fmt::Write as _;

use super::super::ExportFile;
use super::PackageRequest;

/// A look as the package's texts tell it.
#[derive(Clone, Debug)]
pub(super) struct Materials<'a> {
    /// Name of the look, for people.
    pub(super) title: &'a str,
    /// Beginning of the names of the look's files: the look itself is `stem.js`.
    pub(super) stem: &'a str,
    /// Exposed parameters, in the artist's order.
    pub(super) parameters: Vec<MaterialParameter<'a>>,
    /// Ids of the lights that the look reads.
    pub(super) lights: Vec<&'a str>,
    /// The parameters and lights as tables of Markdown, in the place `{{table}}` of templates.
    pub(super) table: String,
    /// Names of the files with the look's images.
    pub(super) images: Vec<&'a str>,
}

/// An exposed parameter.
#[derive(Clone, Debug)]
pub(super) struct MaterialParameter<'a> {
    /// Name under which the artist exposed the parameter.
    pub(super) name: &'a str,
    /// Type in Chiaro, such as `float`.
    pub(super) ty: &'a str,
    /// Words of a choice; none of other parameters.
    pub(super) options: &'a [String],
    /// Help text, or else the label; may be empty.
    pub(super) help: &'a str,
}

impl<'a> Materials<'a> {
    /// The look of a request.
    pub(super) fn of(request: &PackageRequest<'a>) -> Self {
        let exposed = request.description.parameters.iter();
        let parameters = exposed.filter_map(|parameter| {
            Some(MaterialParameter {
                name: parameter.name.as_ref()?.as_str(),
                ty: &parameter.ty,
                options: &parameter.options,
                help: if parameter.help.is_empty() { &parameter.label } else { &parameter.help },
            })
        });
        let lights = request.description.lights.iter().map(|light| light.id.as_str());
        Self {
            title: request.title,
            stem: request.stem,
            parameters: parameters.collect(),
            lights: lights.collect(),
            table: request.tables(),
            images: request.textures.iter().map(|file| file.name.as_str()).collect(),
        }
    }

    /// The files of templates with their places filled, and those of a runtime, which are called
    /// `chiaro.NAME` so that no look's file has the same name. `version` is the version of the
    /// library that the package was run with.
    pub(super) fn files(
        &self,
        templates: impl IntoIterator<Item = (String, String)>,
        runtime: &[(&str, &str)],
        version: &str,
    ) -> Vec<ExportFile> {
        // The look itself may be called as a file of the runtime is: its name comes after theirs.
        let renamed = |text: &str| {
            runtime.iter().fold(text.to_owned(), |text, (name, _)| {
                text.replace(&format!("\"./{name}\""), &format!("\"./chiaro.{name}\""))
            })
        };
        let templates = templates.into_iter();
        let own = templates.map(|(name, text)| (name, filled(&renamed(&text), self, version)));
        let others = runtime.iter().map(|(name, text)| (format!("chiaro.{name}"), renamed(text)));
        own.chain(others).map(|(name, text)| ExportFile::text(name, text)).collect()
    }
}

/// Typings of a library's material, with the types of a look's values in the place `{{values}}`.
pub(super) fn with_value_types(typings: &str) -> String {
    typings.replace("{{values}}\n", include_str!("shared/values.d.ts"))
}

/// A template with its places filled.
fn filled(template: &str, materials: &Materials<'_>, version: &str) -> String {
    // The title stands in comments of JavaScript, in Markdown and in HTML.
    let title = materials.title.replace('&', "and").replace(['<', '>', '*', '`', '{', '}'], "");
    let class = class_name(materials.stem);
    let ids = &materials.lights;
    template
        .replace("{{name}}", &title)
        .replace("{{package}}", &package_name(materials.stem))
        .replace("{{class}}", &class)
        .replace("{{stem}}", materials.stem)
        .replace("{{version}}", env!("CARGO_PKG_VERSION"))
        .replace("{{library}}", version)
        .replace("{{parameters}}", &members(materials))
        .replace("{{table}}", &materials.table)
        .replace("{{files}}", &addresses(&materials.images))
        .replace("{{light}}", &joined(ids, " | ", "never", |id| format!("\"{id}\"")))
        .replace("{{lights}}", &joined(ids, ", ", "none here", |id| format!("`{id}`")))
        .replace(
            "{{light_members}}",
            &joined(ids, "", "", |id| format!("\"{id}\": {class}Light; ")),
        )
}

/// Ids as a text, each as `write` has it; `none` where there are none.
fn joined(ids: &[&str], between: &str, none: &str, write: impl Fn(&str) -> String) -> String {
    let texts: Vec<_> = ids.iter().map(|id| write(id)).collect();
    if texts.is_empty() { none.to_owned() } else { texts.join(between) }
}

/// A class's name from the name of files: `rim-light` is `RimLight`.
pub(super) fn class_name(stem: &str) -> String {
    let words = stem.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let name: String = words
        .map(|word| {
            let (first, rest) = word.split_at(1);
            first.to_ascii_uppercase() + rest
        })
        .collect();
    match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => name,
        _ => format!("Look{name}"),
    }
}

/// A package's name as npm takes it from the name of files: `Rim Light` is `look-rim-light`.
fn package_name(stem: &str) -> String {
    let stem = stem.to_ascii_lowercase();
    let words = stem.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.fold("look".to_owned(), |name, word| name + "-" + word)
}

/// The addresses of files beside a module, by their names, as a constant of JavaScript. Bundlers
/// find a file only where its name is written out in a `new URL`.
fn addresses(names: &[&str]) -> String {
    if names.is_empty() {
        return "const files = {};\n".to_owned();
    }
    let mut text =
        "/** The look's images, each written out so that bundlers find them. */\n".to_owned();
    text += "const files = {\n";
    for name in names {
        // These four have meanings of their own in an address.
        let address = name.replace('%', "%25").replace('#', "%23");
        let address = address.replace('?', "%3F").replace('\\', "%5C");
        let key = serde_json::Value::from(*name);
        let address = serde_json::Value::from(format!("./{address}"));
        let _infallible = writeln!(text, "  {key}: new URL({address}, import.meta.url),");
    }
    text + "};\n"
}

/// The parameters as members of an interface of TypeScript, a line each.
fn members(materials: &Materials<'_>) -> String {
    let mut text = String::new();
    for parameter in &materials.parameters {
        let name = serde_json::Value::from(parameter.name);
        if !parameter.help.is_empty() {
            let help = parameter.help.replace("*/", "").replace(char::is_control, " ");
            let _infallible = writeln!(text, "  /** {help} */");
        }
        let (read, taken) = (type_read(parameter), type_taken(parameter));
        let _infallible = writeln!(text, "  get {name}(): {read};");
        let _infallible = writeln!(text, "  set {name}(value: {taken} | undefined);");
    }
    text
}

/// The type in TypeScript in which a parameter is read.
fn type_read(parameter: &MaterialParameter<'_>) -> String {
    match parameter.ty {
        "switch" => "boolean".to_owned(),
        "color" | "vec2" | "vec3" | "vec4" => "readonly number[]".to_owned(),
        _ if !parameter.options.is_empty() => {
            let words = parameter.options.iter().map(|word| format!("{word:?}"));
            words.collect::<Vec<_>>().join(" | ")
        }
        _ => "number".to_owned(),
    }
}

/// The type in TypeScript in which a parameter is set.
fn type_taken(parameter: &MaterialParameter<'_>) -> String {
    match parameter.ty {
        "color" => "ColorValue".to_owned(),
        "vec2" => "Vector2 | readonly number[]".to_owned(),
        "vec3" => "Vector3 | readonly number[]".to_owned(),
        "vec4" => "Vector4 | readonly number[]".to_owned(),
        _ => type_read(parameter),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A look whose names want care.
    pub(in super::super) fn example<'a>() -> Materials<'a> {
        let parameter = |name, ty| MaterialParameter { name, ty, options: &[], help: "Help" };
        Materials {
            title: "Rim & *light*",
            stem: "2-rim",
            parameters: vec![parameter("warmth", "float"), parameter("tint", "color")],
            lights: vec!["key"],
            table: String::new(),
            images: vec!["2-rim.50% #1.png"],
        }
    }

    /// The text of a file of a package.
    pub(in super::super) fn text(files: &[ExportFile], name: &str) -> String {
        let file = files.iter().find(|file| file.name == name).expect(name);
        String::from_utf8(file.bytes.clone()).expect("text")
    }

    /// Every place of the templates is filled, and imports name files of the package.
    pub(in super::super) fn is_complete(files: &[ExportFile]) {
        let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
        for name in &names {
            let text = text(files, name);
            assert!(!text.contains("{{"), "{name}: {text}");
            for import in text.split("from \"./").skip(1) {
                let import = import.split('"').next().unwrap_or_default();
                let is_look = import == "2-rim.js" || import.starts_with("2-rim/");
                assert!(names.contains(&import) || is_look, "{name}: {import}");
            }
        }
    }

    #[test]
    fn classes_have_names_of_the_language() {
        assert_eq!(class_name("figure5-directional"), "Figure5Directional");
        assert_eq!(class_name("2-rim"), "Look2Rim");
        assert_eq!(class_name("Ölbild"), "Lbild");
        assert_eq!(class_name("…"), "Look");
        assert_eq!(package_name("2-Rim_light"), "look-2-rim-light");
        assert_eq!(package_name("…"), "look");
    }
}
