//! The look's tables: passes with their bindings and outputs, and images.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::super::rust::{Parameters, Template, wide};
use super::super::{PackageRequest, javascript};
use crate::document::ColorSpace;
use crate::export::description::{DrawnSides, ExportPass};

/// Sources of the tables.
pub(super) struct Tables<'a> {
    passes: &'a [ExportPass],
    /// Modules as packages in JavaScript have them, by the passes.
    modules: Vec<Value>,
}

/// Feature of the crate `image` that reads a file; `None` for files that crates do not read.
pub(super) fn image_feature(file: &str) -> Option<&'static str> {
    match file.rsplit('.').next()?.to_ascii_lowercase().as_str() {
        "png" => Some("png"),
        "jpg" | "jpeg" => Some("jpeg"),
        _ => None,
    }
}

impl<'a> Tables<'a> {
    pub(super) fn of(request: &PackageRequest<'a>) -> Self {
        let described = json!(request.description);
        let module = |pass: &ExportPass| {
            let mut modules = described["modules"].as_array().into_iter().flatten();
            let found = modules.find(|module| module["name"] == pass.module);
            found.map(|module| Value::Object(javascript::module_object(module, &described)))
        };
        let passes = &request.description.passes;
        let modules = passes.iter().map(|pass| module(pass).unwrap_or_default()).collect();
        Self { passes, modules }
    }

    /// Fills templates with the tables, and opens the sections that they need.
    pub(super) fn fill(
        &self,
        template: &mut Template,
        request: &PackageRequest<'_>,
        parameters: &Parameters<'_>,
    ) {
        let mut feeds = BTreeSet::new();
        let mut attributes = BTreeSet::new();
        for module in &self.modules {
            let bindings = module["bindings"].as_array().into_iter().flatten();
            feeds.extend(bindings.filter_map(|it| it["feed"]["from"].as_str()));
            let of_module = module["attributes"].as_array().into_iter().flatten();
            attributes.extend(of_module.filter_map(|it| it["name"].as_str()));
        }
        for name in ["normal", "tangent", "uv", "color"] {
            template.section(name, attributes.contains(name));
        }
        template.section("passes", self.passes.len() > 1);
        template.section("screen", self.passes.iter().any(|pass| pass.draws == "screen"));
        template.section("numbers", feeds.contains("curvature"));
        let cuts = self.cuts(request, parameters);
        template.section("cuts", cuts.is_some());
        template.place("cuts", cuts.unwrap_or_default());
        let is_read = |name: &str| template.has(name) || name == "object" || name == "view";
        let uniforms = ["view", "object", "look", "numbers"].into_iter().filter(|it| is_read(it));
        let uniforms: Vec<String> = uniforms.map(|it| format!("Self::{}", variant(it))).collect();
        template.place("uniform_feeds", uniforms.join(" | "));
        let has_passes = template.has("passes");
        template.place("encoder", if has_passes { "encoder" } else { "_encoder" });
        let reads_size = ["passes", "look", "numbers"].iter().any(|name| template.has(name));
        template.place("size", if reads_size { "size" } else { "_size" });
        let table = self.table(template, request);
        template.lines("passes", table);
        template.place("pass_count", self.passes.len().to_string());
        self.fill_images(template, request);
    }

    /// The condition under which backs are seen through what a look cuts away.
    fn cuts(&self, request: &PackageRequest<'_>, parameters: &Parameters<'_>) -> Option<String> {
        let pass = self.passes.last()?;
        let member = pass.sides_parameter.and_then(|it| parameters.member_of(request, it));
        match member {
            Some(member) => Some(format!("self.parameters.{member} > 0.0")),
            None => (pass.sides == Some(DrawnSides::Both)).then(|| "true".to_owned()),
        }
    }

    fn table(&self, template: &Template, request: &PackageRequest<'_>) -> Vec<String> {
        let mut lines = Vec::new();
        for (pass, module) in self.passes.iter().zip(&self.modules) {
            lines.push("Pass {".to_owned());
            lines.push(format!("    name: {:?},", pass.name));
            lines.push(format!("    shader: include_str!(\"shaders/{}.wgsl\"),", pass.module));
            if template.has("screen") {
                let draws = if pass.draws == "screen" { "Screen" } else { "Meshes" };
                lines.push(format!("    draws: Draws::{draws},"));
            }
            let attributes = module["attributes"].as_array().into_iter().flatten();
            let attributes = attributes.filter(|_| pass.draws != "screen").map(|attribute| {
                let name = variant(attribute["name"].as_str().unwrap_or_default());
                format!("({}, Attribute::{name})", attribute["location"])
            });
            lines.extend(listed("attributes", &attributes.collect::<Vec<_>>()));
            let bindings = module["bindings"].as_array().into_iter().flatten();
            let bindings =
                bindings.map(|it| format!("({}, {})", it["wgsl"]["binding"], self.feed(pass, it)));
            lines.extend(listed("bindings", &bindings.collect::<Vec<_>>()));
            if template.has("look") {
                let numbers = request.work.modules.iter().find(|it| it.module == pass.module);
                match numbers {
                    None => lines.push("    numbers: None,".to_owned()),
                    Some(numbers) => {
                        let call = format!("host::{}(settings, around)", numbers.function);
                        let integers = format!("&{:?}", numbers.integers);
                        lines.push("    numbers: Some(|settings, around| {".to_owned());
                        let both = format!("{call}, {integers}");
                        let in_one = wide("        uniforms::look(", &both, ")", 4);
                        lines.extend(in_one.unwrap_or_else(|| {
                            vec![
                                "        uniforms::look(".to_owned(),
                                format!("            {call},"),
                                format!("            {integers},"),
                                "        )".to_owned(),
                            ]
                        }));
                        lines.push("    }),".to_owned());
                    }
                }
            }
            if template.has("passes") {
                lines.extend(outputs(pass));
            }
            lines.push("},".to_owned());
        }
        lines
    }

    /// Content of a binding of a pass.
    fn feed(&self, pass: &ExportPass, binding: &Value) -> String {
        let feed = &binding["feed"];
        let place = |of: &str, output: &str| {
            let index = self.passes.iter().position(|pass| pass.name == of).unwrap_or_default();
            let outputs = &self.passes[index].outputs;
            let output = outputs.iter().position(|it| it.name == output).unwrap_or_default();
            format!("Feed::Pass {{ pass: {index}, output: {output} }}")
        };
        match feed["from"].as_str().unwrap_or_default() {
            "image" => format!("Feed::Image({})", feed["image"]),
            "sampler" => format!("Feed::Sampler({})", feed["image"]),
            "curvature" => "Feed::Numbers".to_owned(),
            "pass" | "inputs" => {
                let name = binding["name"].as_str().unwrap_or_default();
                let input = pass.inputs.iter().find(|input| input.binding == name);
                input.map(|input| place(input.pass, input.output)).unwrap_or_else(|| {
                    let word = |key: &str| feed[key].as_str().unwrap_or_default();
                    place(word("pass"), word("output"))
                })
            }
            from => format!("Feed::{}", variant(from)),
        }
    }

    fn fill_images(&self, template: &mut Template, request: &PackageRequest<'_>) {
        let images = &request.description.images;
        let is_layered = |file: &str| file.ends_with(".ktx2");
        let files: Vec<&str> = images.iter().filter_map(|image| image.file.as_deref()).collect();
        template.section("images", !files.is_empty());
        template.section("flat", files.iter().any(|file| !is_layered(file)));
        template.section("layered", files.iter().any(|file| is_layered(file)));
        let features: BTreeSet<_> = files.iter().filter_map(|file| image_feature(file)).collect();
        let features: Vec<String> = features.iter().map(|it| format!("{it:?}")).collect();
        template.place("image_features", features.join(", "));
        let (flat, layered) = (template.has("flat"), template.has("layered"));
        template.place(
            "read",
            match (flat, layered) {
                (true, true) => "read(device, image)",
                (false, _) => "read_layers(device, image)",
                (true, false) => "read_flat(image)",
            },
        );
        template.place(
            "dimension",
            if layered { "IMAGES[image].dimension" } else { "wgpu::TextureViewDimension::D2" },
        );
        // The image's number is read where a dimension depends on it.
        template.place("image_number", if layered { "image" } else { "_" });
        let has_images = template.has("images");
        template.place("and_uploads", if has_images { ", and uploads its images" } else { "" });
        template
            .place("image_errors", if has_images { "; an image that cannot be read" } else { "" });
        template.place("doc_queue", if has_images { "queue: &wgpu::Queue, " } else { "" });
        template.place("doc_queue_argument", if has_images { "queue, " } else { "" });
        template.place("example_queue", if has_images { "&queue, " } else { "" });
        let is_linear = request.description.color_space == ColorSpace::Linear;
        template.place("doc_format", if is_linear { "Rgba8UnormSrgb" } else { "Rgba8Unorm" });
        template.place("image_count", images.len().to_string());
        let mut lines = Vec::new();
        for image in images {
            let Some(file) = &image.file else { continue };
            lines.push("Image {".to_owned());
            lines.push(format!("    file: {file:?},"));
            lines.push(format!("    bytes: include_bytes!(\"images/{file}\"),"));
            if flat {
                let is_decoded = is_linear && image.encoding == "color" && !is_layered(file);
                let format = if is_decoded { "Rgba8UnormSrgb" } else { "Rgba8Unorm" };
                lines.push(format!("    format: wgpu::TextureFormat::{format},"));
            }
            if layered {
                let dimension = if is_layered(file) { "D2Array" } else { "D2" };
                lines.push(format!("    dimension: wgpu::TextureViewDimension::{dimension},"));
            }
            let wrap = match image.wrap.as_str() {
                "clamp" => "ClampToEdge",
                "mirror" => "MirrorRepeat",
                _ => "Repeat",
            };
            lines.push(format!("    wrap: wgpu::AddressMode::{wrap},"));
            let filter = if image.filter == "nearest" { "Nearest" } else { "Linear" };
            lines.push(format!("    filter: wgpu::FilterMode::{filter},"));
            lines.push("},".to_owned());
        }
        template.lines("images", lines);
    }
}

/// A member of a struct that is a list: in one line, or an item a line.
fn listed(name: &str, items: &[String]) -> Vec<String> {
    let short = format!("    {name}: &[{}],", items.join(", "));
    // The table is four columns further in.
    if let Some(lines) = wide("", &short, "", 4) {
        return lines;
    }
    let items = items.iter().map(|item| format!("        {item},"));
    std::iter::once(format!("    {name}: &[")).chain(items).chain(["    ],".to_owned()]).collect()
}

/// Outputs of a pass before the picture; the picture has none of its own.
fn outputs(pass: &ExportPass) -> Vec<String> {
    if pass.module == "draw" {
        return vec!["    outputs: &[],".to_owned()];
    }
    let mut lines = vec!["    outputs: &[".to_owned()];
    for output in &pass.outputs {
        let format = output.format.split("float").next().unwrap_or_default();
        let format = format!("{}Float", variant(format));
        let clear = match output.clear {
            [0.0, 0.0, 0.0, 0.0] => "wgpu::Color::TRANSPARENT".to_owned(),
            [r, g, b, a] => format!("wgpu::Color {{ r: {r:?}, g: {g:?}, b: {b:?}, a: {a:?} }}"),
        };
        lines.push("        PassOutput {".to_owned());
        lines.push(format!("            format: wgpu::TextureFormat::{format},"));
        lines.push(format!("            clear: {clear},"));
        lines.push("        },".to_owned());
    }
    lines.push("    ],".to_owned());
    lines
}

/// A name as a variant's: `position` is `Position`.
fn variant(name: &str) -> String {
    let mut letters = name.chars();
    letters
        .next()
        .map_or_else(String::new, |first| first.to_ascii_uppercase().to_string() + letters.as_str())
}
