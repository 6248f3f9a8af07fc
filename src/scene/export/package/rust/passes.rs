//! Passes of a crate: a table of what each reads, and what it draws into.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::super::{PackageRequest, javascript};
use super::{Template, fill_shadow_maps, wide};
use crate::export::description::ExportPass;

/// The module of the table.
pub(in super::super) const LOOK: &str = include_str!("template/look.rs.in");

/// The module of uniforms' bytes.
pub(in super::super) const UNIFORMS: &str = include_str!("template/uniforms.rs.in");

/// Variants of `Feed` that are uniforms, with the sections that they are in.
const UNIFORM_FEEDS: [(&str, &str); 6] = [
    ("View", ""),
    ("Object", ""),
    ("Look", "numbered"),
    ("Numbers", "numbers"),
    ("LightLayer", "shadows"),
    ("LightCaster", "shadows"),
];

/// Sources of the table.
pub(in super::super) struct PassTable<'a> {
    passes: Vec<&'a ExportPass>,
    /// Modules as packages in JavaScript have them, by the passes.
    modules: Vec<Value>,
}

impl<'a> PassTable<'a> {
    /// The table of the request's passes for which `is_in` holds.
    pub(in super::super) fn of(
        request: &PackageRequest<'a>,
        is_in: impl Fn(&ExportPass) -> bool,
    ) -> Self {
        let described = json!(request.description);
        let module = |pass: &&ExportPass| {
            let mut modules = described["modules"].as_array().into_iter().flatten();
            let found = modules.find(|module| module["name"] == pass.module);
            found.map(|module| Value::Object(javascript::module_object(module, &described)))
        };
        let passes: Vec<_> = request.description.passes.iter().filter(|it| is_in(it)).collect();
        let modules = passes.iter().map(|pass| module(pass).unwrap_or_default()).collect();
        Self { passes, modules }
    }

    /// The passes.
    pub(in super::super) fn passes(&self) -> &[&'a ExportPass] {
        &self.passes
    }

    /// Fills templates with the table, and opens the sections that it needs. `numbered` holds for
    /// passes that read numbers of the look.
    pub(in super::super) fn fill(
        &self,
        template: &mut Template,
        request: &PackageRequest<'_>,
        is_numbered: bool,
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
        let has = |draws: &str| self.passes.iter().any(|pass| pass.draws == draws);
        template.section("passes", self.passes.iter().any(|pass| pass.module != "draw"));
        template.section("screen", has("screen"));
        template.section("draws", has("screen") || has("lights"));
        let is_target = |pass: &&ExportPass| pass.draws != "lights" && pass.module != "draw";
        template.section("targets", self.passes.iter().any(is_target));
        template.section("numbers", feeds.contains("curvature"));
        template.section("numbered", is_numbered);
        fill_shadow_maps(template, request);
        let is_read = |(_, section): &(&str, &str)| section.is_empty() || template.has(section);
        let uniforms = UNIFORM_FEEDS.into_iter().filter(is_read);
        let uniforms: Vec<String> = uniforms.map(|(name, _)| format!("Self::{name}")).collect();
        let arms = uniforms.join(" | ");
        let in_block = || {
            let mut lines = wide("", &arms, " => {", 12)?;
            lines.extend(["    uniform", "}"].map(str::to_owned));
            Some(lines)
        };
        let lines = wide("", &arms, " => uniform,", 12).or_else(in_block).unwrap_or_else(|| {
            let arms = uniforms.join("\n| ") + " => uniform,";
            arms.lines().map(str::to_owned).collect()
        });
        template.lines("uniform_feeds", lines);
        let lines = self.lines(template, request);
        template.lines("passes", lines);
        template.place("pass_count", self.passes.len().to_string());
    }

    /// The table's lines. Passes have numbers of the look where the template has the section
    /// `numbered`.
    fn lines(&self, template: &Template, request: &PackageRequest<'_>) -> Vec<String> {
        let mut lines = Vec::new();
        for (&pass, module) in self.passes.iter().zip(&self.modules) {
            lines.push("Pass {".to_owned());
            lines.push(format!("    name: {:?},", pass.name));
            lines.push(format!("    shader: include_str!(\"shaders/{}.wgsl\"),", pass.module));
            if template.has("draws") {
                lines.push(format!("    draws: Draws::{},", variant(pass.draws)));
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
            if template.has("numbered") {
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
            if self.passes[index].draws == "lights" {
                return format!("Feed::ShadowMaps({index})");
            }
            let outputs = &self.passes[index].outputs;
            let output = outputs.iter().position(|it| it.name == output).unwrap_or_default();
            format!("Feed::Pass {{ pass: {index}, output: {output} }}")
        };
        match feed["from"].as_str().unwrap_or_default() {
            "image" => format!("Feed::Image({})", feed["image"]),
            "sampler" => format!("Feed::Sampler({})", feed["image"]),
            "curvature" => "Feed::Numbers".to_owned(),
            "light_layer" => "Feed::LightLayer".to_owned(),
            "light_caster" => "Feed::LightCaster".to_owned(),
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
